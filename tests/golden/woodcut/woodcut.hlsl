// Woodcut: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_5 b0, object b1, look b2, curvature_map t0.
// woodcut.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    float4 eye;
};

struct Object {
    row_major float4x4 world_from_object;
    row_major float3x3 world_from_normal;
    int _pad2_0;
    float id;
    float cutoff;
    int _end_pad_0;
    int _end_pad_1;
};

struct Light {
    float3 direction;
    int _pad1_0;
    float3 own_direction;
    int _pad2_0;
    float3 color;
    float intensity;
};

struct Look {
    Light key;
    float2 viewport;
    int _end_pad_0;
    int _end_pad_1;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    float kappa;
    float magnification;
    int _pad5_0;
    int _pad5_1;
    int _pad5_2;
    row_major float3x3 world_from_normal;
    int _end_pad_0;
};

struct StretchedPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct SpacedPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct Strokes {
    float width;
    float length_;
    float taper;
    float wobble;
    float pressure;
    float variation;
    uint seed;
};

struct Stroke {
    float turn;
    float profile;
};

struct MarkPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
};

static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;

cbuffer view_5 : register(b0) { View view_5; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_6 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_7 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise)
{
    const bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

float3 finite_vec3_(float3 v)
{
    const float _e3 = finite_or(v.x, 0.0);
    const float _e6 = finite_or(v.y, 0.0);
    const float _e9 = finite_or(v.z, 0.0);
    return float3(_e3, _e6, _e9);
}

float4 finite_vec4_(float4 v_1)
{
    const float3 _e2 = finite_vec3_(v_1.xyz);
    const float _e5 = finite_or(v_1.w, 0.0);
    return float4(_e2, _e5);
}

float3 normalize_or(float3 v_2, float3 otherwise_1)
{
    bool local = (bool)0;

    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local = (largest < 1e30);
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    float3 scaled = (v_2 * (1.0 / largest));
    float square_1 = dot(scaled, scaled);
    const bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square_1)));
}

float power_of_two(int n)
{
    return asfloat((uint(asint(asuint(n) + asuint(int(127)))) << 23u));
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x_2)
{
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole_1 = round(clamped_3);
    float f = ((clamped_3 - whole_1) * LN_2_);
    float p_1 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole_1), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole_1)) - asuint(half_whole)));
    return ((p_1 * _e33) * _e37);
}

float log_stable(float x_3)
{
    uint bits = asuint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift >= int(256)) ? asint(asuint(shift) - asuint(int(512))) : shift);
    float mantissa = asfloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float2 sin_cos_quarter(float x_4)
{
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

float2 sin_cos(float x_5)
{
    float turns = round((x_5 * 0.31830987));
    float r = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    const float2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float2 bounded_vec2_(float2 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    return float2(_e2, _e4);
}

float3 bounded_vec3_(float3 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    return float3(_e2, _e4, _e6);
}

float4 bounded_vec4_(float4 v_5)
{
    const float _e2 = bounded(v_5.x);
    const float _e4 = bounded(v_5.y);
    const float _e6 = bounded(v_5.z);
    const float _e8 = bounded(v_5.w);
    return float4(_e2, _e4, _e6, _e8);
}

float powered(float base, float exponent)
{
    bool local_1 = (bool)0;

    const float _e2 = bounded(base);
    const float _e3 = bounded(exponent);
    if ((_e3 == 1.0)) {
        return _e2;
    }
    if ((_e3 == 0.0)) {
        return 1.0;
    }
    if ((_e3 == 2.0)) {
        const float _e12 = bounded((_e2 * _e2));
        return _e12;
    }
    float magnitude_1 = abs(_e2);
    if ((magnitude_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e18 = log_stable(magnitude_1);
    const float _e21 = bounded((_e3 * (LOG2_E * _e18)));
    const float _e22 = exp2_stable(_e21);
    bool is_even = (floor((_e3 * 0.5)) == (_e3 * 0.5));
    if ((_e2 < 0.0)) {
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return (_e36 ? -(_e22) : _e22);
}

float mixed(float a, float b, float t)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t < 0.5) ? (a + (t * _e4)) : (b - ((1.0 - t) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_1, float3 b_1, float t_1)
{
    const float _e5 = mixed(a_1.x, b_1.x, t_1);
    const float _e8 = mixed(a_1.y, b_1.y, t_1);
    const float _e11 = mixed(a_1.z, b_1.z, t_1);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_2, float4 b_2, float t_2)
{
    const float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_2);
    const float _e8 = mixed(a_2.w, b_2.w, t_2);
    return float4(_e5, _e8);
}

float place_between(float x_7, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_7 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_7 - low) / _e12));
    return _e14;
}

float remapped(float x_8, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_8);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_9, float low_1, float high_1)
{
    const float _e3 = bounded(x_9);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float factor_of(float x_10, bool clamped_1)
{
    const float _e2 = bounded(x_10);
    const float _e3 = bounded(x_10);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float2 sin_cos_of(float x_11)
{
    const float _e1 = bounded(x_11);
    const float2 _e2 = sin_cos(_e1);
    return clamp(_e2, (-1.0).xx, (1.0).xx);
}

float footprint_of(float x_12)
{
    float _e1 = ddx(x_12);
    float _e2 = ddy(x_12);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float edge_width(float w, float softness)
{
    const float _e4 = bounded(softness);
    return length(float2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_13, float edge, float w_1)
{
    const float _e4 = bounded((x_13 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float4 premultiplied(float4 color)
{
    return float4((color.xyz * color.w), color.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 mix_colors_normal(float4 a_3, float4 b_3, float factor)
{
    const float4 _e3 = bounded_vec4_(a_3);
    const float4 _e4 = bounded_vec4_(b_3);
    const float _e6 = factor_of(factor, true);
    const float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float kappa_safe(float kappa)
{
    bool is_nan = ((asuint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope)
{
    const float _e2 = kappa_safe(kappa_1);
    const float _e4 = finite_or(slope, 0.0);
    float a_5 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_2 = min(abs(a_5), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_5 * a_5);
        return (a_5 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_2));
    float t_6 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_5 >= 0.0) ? t_6 : -(t_6));
}

float transition(float kappa_2, float slope_1)
{
    const float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float facing(float3 normal, float3 view)
{
    const float3 _e4 = normalize_or(normal, (0.0).xxx);
    return clamp(dot(_e4, view), 0.0, 1.0);
}

float kappa_surface(float kappa_3)
{
    const float _e1 = kappa_safe(kappa_3);
    return _e1;
}

float3x3 axes_around(float3 toward, float3 up)
{
    const float3 _e6 = normalize_or(toward, float3(0.0, 0.0, 1.0));
    const float3 _e11 = normalize_or(up, float3(0.0, 1.0, 0.0));
    float3 leaning = cross(_e11, _e6);
    float square_2 = dot(leaning, leaning);
    float3 aside = ((abs(_e6.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across_2 = ((square_2 > 1e-8) ? leaning : cross(aside, _e6));
    const float3 _e38 = normalize_or((across_2 - (dot(across_2, _e6) * _e6)), float3(1.0, 0.0, 0.0));
    return float3x3(_e38, cross(_e6, _e38), _e6);
}

float combine_tones_union(float a_4, float b_4)
{
    const float _e3 = factor_of(a_4, true);
    const float _e5 = factor_of(b_4, true);
    return max(_e3, _e5);
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float threshold(float value, float edge_1, float softness_1)
{
    const float _e3 = footprint_of(value);
    const float _e4 = bounded(value);
    const float _e5 = bounded(edge_1);
    const float _e6 = edge_width(_e3, softness_1);
    const float _e7 = step_filtered(_e4, _e5, _e6);
    return _e7;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_6 = (uint3)0;

    v_6 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_6;
    uint3 _e32 = v_6;
    v_6 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_6;
    return _e61;
}

float3 unit_of_hash(uint3 hash)
{
    return (float3((hash >> (8u).xxx)) * 5.9604645e-8);
}

uint3 lattice_hash(int3 cell, uint seed_1)
{
    const uint3 _e9 = hash_pcg3d((asuint(cell) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float3 fade_quintic(float3 t_3)
{
    return (((t_3 * t_3) * t_3) * ((t_3 * ((t_3 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i = int(0);

    float3 corner = floor(p);
    const float3 _e4 = fade_quintic((p - corner));
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e45 = i;
            i = asint(asuint(_e45) + asuint(int(1)));
        }
        loop_init = false;
        int _e10 = i;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            int3 at_1 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at_1 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at_1)), seed_2);
            const float3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float size_on_screen(float depth, float perspective, float scale)
{
    const float _e10 = bounded(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)));
    return _e10;
}

StretchedPlace ConstructStretchedPlace(float2 arg0, float3 arg1) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    const float2 _e4 = sin_cos_of(angle);
    const float3 _e10 = bounded_vec3_(((_e4.y * along) + (_e4.x * across)));
    const float3 _e16 = bounded_vec3_(((_e4.y * across) - (_e4.x * along)));
    const float2 _e17 = bounded_vec2_(place);
    float2 turned = float2(((_e4.y * _e17.x) + (_e4.x * _e17.y)), ((_e4.y * _e17.y) - (_e4.x * _e17.x)));
    float3 most = (1000000000000000.0).xxx;
    float3 stretch_2 = clamp(float3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    const float2 _e41 = bounded_vec2_(turned);
    const StretchedPlace stretchedplace = ConstructStretchedPlace(_e41, stretch_2);
    return stretchedplace;
}

float3 gradient_on_picture(float3 g, float3 normal_1, float3 view_1)
{
    float facing_1 = dot(normal_1, view_1);
    return (g - (normal_1 * (dot(g, view_1) / ((facing_1 >= 0.0) ? max(facing_1, 0.125) : min(facing_1, -0.125)))));
}

StretchedPlace place_on_surface(float2 place_1, float3 along_1, float3 across_1, float3 normal_2, float3 view_2, float magnification, float angle_1)
{
    const float3 _e11 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    const float3 _e16 = normalize_or(view_2, float3(0.0, 0.0, 1.0));
    const float _e17 = bounded(magnification);
    float height = (1.0 / clamp(_e17, 1e-15, 1000000000000000.0));
    const float3 _e23 = gradient_on_picture(along_1, _e11, _e16);
    const float3 _e25 = bounded_vec3_((_e23 * height));
    const float3 _e26 = gradient_on_picture(across_1, _e11, _e16);
    const float3 _e28 = bounded_vec3_((_e26 * height));
    const float2 _e29 = bounded_vec2_(place_1);
    const StretchedPlace _e30 = mark_place_of(_e29, _e25, _e28, angle_1);
    const StretchedPlace stretchedplace_1 = _e30;
    return stretchedplace_1;
}

StretchedPlace place_across(float3 axis, float3 position, float3x3 world_from_normal, float3 normal_3, float3 view_3, float magnification_1, float angle_2)
{
    const float3x3 _e11 = axes_around(axis, float3(0.0, 1.0, 0.0));
    const float3 _e12 = bounded_vec3_(position);
    float2 place_6 = float2(dot(_e12, _e11[0]), dot(_e12, _e11[2]));
    const float3 _e20 = bounded_vec3_(mul(_e11[0], world_from_normal));
    const float3 _e23 = bounded_vec3_(mul(_e11[2], world_from_normal));
    const StretchedPlace _e24 = place_on_surface(place_6, _e20, _e23, normal_3, view_3, magnification_1, angle_2);
    const StretchedPlace stretchedplace_2 = _e24;
    return stretchedplace_2;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_2, float3 stretch, float2 viewport, float count)
{
    const float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_1 = (is_pixel ? (number / max(viewport.y, 1.0)) : number);
    const float2 _e19 = bounded_vec2_(place_2);
    const float2 _e21 = bounded_vec2_((_e19 * scale_1));
    float2 p_2 = clamp(_e21, (-4194304.0).xx, (4194304.0).xx);
    const float3 _e27 = bounded_vec3_(stretch);
    float3 s_1 = clamp(_e27, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_2, (is_pixel ? float3(1.0, 0.0, 1.0) : s_1));
    return spacedplace;
}

float octave_of(float square)
{
    const float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

Stroke ConstructStroke(float arg0, float arg1) {
    Stroke ret = (Stroke)0;
    ret.turn = arg0;
    ret.profile = arg1;
    return ret;
}

Stroke stroke_at(int2 line_, float x_14, int zoom, Strokes style)
{
    const uint3 _e7 = lattice_hash(int3(line_, int(1048576)), style.seed);
    const float3 _e8 = unit_of_hash(_e7);
    if ((style.length_ <= 0.0)) {
        const Stroke stroke = ConstructStroke(_e8.y, 1.0);
        return stroke;
    }
    const float _e15 = power_of_two(zoom);
    float along_2 = (clamp(((x_14 * _e15) / style.length_), -1000000.0, 1000000.0) + _e8.x);
    float index = floor(along_2);
    const uint3 _e30 = lattice_hash(int3(line_, naga_f2i32(index)), (style.seed + asuint(zoom)));
    const float3 _e31 = unit_of_hash(_e30);
    float from_end = min((along_2 - index), (1.0 - (along_2 - index)));
    float slope_2 = clamp((from_end / max((0.5 * style.taper), 1e-6)), 0.0, 1.0);
    const Stroke stroke_1 = ConstructStroke(_e31.x, (slope_2 * (2.0 - slope_2)));
    return stroke_1;
}

Stroke stroke_between(int2 line_1, float x_15, float level, Strokes style_1)
{
    float zoom_2 = floor(level);
    const Stroke _e6 = stroke_at(line_1, x_15, naga_f2i32(zoom_2), style_1);
    const Stroke _e10 = stroke_at(line_1, x_15, asint(asuint(naga_f2i32(zoom_2)) + asuint(int(1))), style_1);
    float f_1 = (level - zoom_2);
    const Stroke stroke_2 = ConstructStroke(lerp(_e6.turn, _e10.turn, f_1), lerp(_e6.profile, _e10.profile, f_1));
    return stroke_2;
}

int naga_neg(int val) {
    return asint(-asuint(val));
}

float stray_at(float2 place_3, int zoom_1, uint seed_3)
{
    const float _e3 = power_of_two(zoom_1);
    float2 p_3 = (place_3 * _e3);
    const float _e13 = value_noise(float3((0.11 * p_3.x), (0.45 * p_3.y), 0.5), seed_3);
    const float _e19 = power_of_two(naga_neg(zoom_1));
    return (((_e13 - 0.5) * 2.0) * _e19);
}

float band_filtered(float t_4, float half_, float w_2)
{
    bool local_2 = (bool)0;

    if ((w_2 < 1e-30)) {
        if ((abs(t_4) <= half_)) {
            local_2 = (half_ > 0.0);
        } else {
            local_2 = false;
        }
        bool _e12 = local_2;
        return (_e12 ? 1.0 : 0.0);
    }
    return clamp(((clamp((t_4 + (0.5 * w_2)), -(half_), half_) - clamp((t_4 - (0.5 * w_2)), -(half_), half_)) / w_2), 0.0, 1.0);
}

int2 line_of(int whole, int octave)
{
    int power = ((whole == int(0)) ? int(1) : (whole & naga_neg(whole)));
    int octaves = asint(asuint(int((asuint(float(power)) >> 23u))) - asuint(int(127)));
    return ((whole == int(0)) ? (int(0)).xx : int2(naga_div(whole, power), asint(asuint(octave) - asuint(octaves))));
}

float hatched(float2 place_4, float w_3, float level_1, float ink, Strokes style_2)
{
    if (!((ink > 0.0))) {
        return 0.0;
    }
    const float _e12 = powered(ink, (1.0 - style_2.pressure));
    const float _e15 = powered(ink, style_2.pressure);
    float width_1 = (style_2.width * _e15);
    float zoom_3 = floor(level_1);
    const float _e20 = stray_at(place_4, naga_f2i32(zoom_3), style_2.seed);
    const float _e25 = stray_at(place_4, asint(asuint(naga_f2i32(zoom_3)) + asuint(int(1))), style_2.seed);
    float stray = lerp(_e20, _e25, (level_1 - zoom_3));
    float across_3 = (place_4.y + (style_2.wobble * stray));
    const float _e35 = log_stable(max(_e12, 1e-9));
    float density = clamp((level_1 + (LOG2_E * _e35)), -40.0, 17.0);
    float octave_1 = floor(density);
    const float _e43 = exp2_stable((density - octave_1));
    float growth = (_e43 - 1.0);
    const float _e47 = power_of_two(naga_f2i32(octave_1));
    float q = clamp((across_3 * _e47), -4194304.0, 4194304.0);
    const float _e55 = exp2_stable((octave_1 - level_1));
    float half_1 = ((0.5 * width_1) * _e55);
    float footprint = (w_3 * _e47);
    int whole_2 = naga_f2i32(round(q));
    const int2 _e61 = line_of(whole_2, naga_f2i32(octave_1));
    const Stroke _e63 = stroke_between(_e61, place_4.x, level_1, style_2);
    float middle = floor(q);
    const Stroke _e75 = stroke_between(int2(asint(asuint(asint(asuint(int(2)) * asuint(naga_f2i32(middle)))) + asuint(int(1))), asint(asuint(naga_f2i32(octave_1)) + asuint(int(1)))), place_4.x, level_1, style_2);
    float late = (0.75 * style_2.variation);
    float grown = clamp(((growth - (late * _e75.turn)) / (1.0 - late)), 0.0, 1.0);
    const float _e92 = band_filtered((q - float(whole_2)), (half_1 * _e63.profile), footprint);
    const float _e99 = band_filtered(((q - middle) - 0.5), ((half_1 * grown) * _e75.profile), footprint);
    float mean = min(((2.0 * half_1) * (1.0 + growth)), 1.0);
    const float _e110 = eased(footprint, 0.75, 1.5);
    return lerp(max(_e92, _e99), mean, _e110);
}

float cross_hatched(SpacedPlace at, float ink_1, int layers, float cross_, Strokes style_3)
{
    float free = 1.0;
    int i_1 = int(0);
    Strokes own = (Strokes)0;

    float2 x_16 = ddx(at.place);
    float2 y = ddy(at.place);
    int count_2 = clamp(layers, int(1), int(4));
    const float _e12 = bounded(ink_1);
    float amount = (clamp(_e12, 0.0, 1.0) * float(count_2));
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e90 = i_1;
            i_1 = asint(asuint(_e90) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e22 = i_1;
        if ((_e22 < int(4))) {
        } else {
            break;
        }
        {
            int _e25 = i_1;
            if ((_e25 < count_2)) {
                int _e27 = i_1;
                const float2 _e30 = sin_cos_of((float(_e27) * cross_));
                float2 along_3 = float2(_e30.y, _e30.x);
                float2 across_4 = float2(-(_e30.x), _e30.y);
                const float _e42 = bounded(length(float2(dot(across_4, x_16), dot(across_4, y))));
                float3 s_2 = at.stretch;
                float square_3 = dot(float3((across_4.x * across_4.x), ((2.0 * across_4.x) * across_4.y), (across_4.y * across_4.y)), s_2);
                const float _e63 = octave_of(max(square_3, ((s_2.x + s_2.z) / 65.0)));
                float2 place_7 = float2(dot(along_3, at.place), dot(across_4, at.place));
                own = style_3;
                int _e73 = i_1;
                own.seed = (style_3.seed + (101u * uint(_e73)));
                float _e77 = free;
                int _e78 = i_1;
                Strokes _e84 = own;
                const float _e85 = hatched(place_7, _e42, _e63, clamp((amount - float(_e78)), 0.0, 1.0), _e84);
                free = (_e77 * (1.0 - _e85));
            }
        }
    }
    float _e92 = free;
    return (1.0 - _e92);
}

Strokes ConstructStrokes(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, uint arg6) {
    Strokes ret = (Strokes)0;
    ret.width = arg0;
    ret.length_ = arg1;
    ret.taper = arg2;
    ret.wobble = arg3;
    ret.pressure = arg4;
    ret.variation = arg5;
    ret.seed = arg6;
    return ret;
}

float hatching(float value_1, float2 place_5, float3 stretch_1, float count_1, float width, int layers_1, float cross_1, float length_, float taper, float wobble, float pressure, float variation, int seed_4, float2 viewport_1)
{
    const float _e14 = bounded(width);
    const float _e18 = bounded(length_);
    const float _e22 = bounded(taper);
    const float _e26 = bounded(wobble);
    const float _e30 = bounded(pressure);
    const float _e34 = bounded(variation);
    Strokes style_4 = ConstructStrokes(clamp(_e14, 0.0, 1.0), clamp(_e18, 0.0, 10000.0), clamp(_e22, 0.0, 1.0), clamp(_e26, 0.0, 100.0), clamp(_e30, 0.0, 1.0), clamp(_e34, 0.0, 1.0), asuint(seed_4));
    const SpacedPlace _e40 = spaced(place_5, stretch_1, viewport_1, count_1);
    const float _e42 = factor_of(value_1, true);
    const float _e45 = cross_hatched(_e40, (1.0 - _e42), layers_1, cross_1, style_4);
    return _e45;
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_light(Light light, float3 normal_4, float angle_3, float3 view_4, float3 position_object, float3x3 world_from_normal_1, float magnification_2)
{
    float3 toward_1 = mul(world_from_normal_1, light.direction);
    const StretchedPlace _e9 = place_across(toward_1, position_object, world_from_normal_1, normal_4, view_4, magnification_2, angle_3);
    const MarkPlace markplace = ConstructMarkPlace(_e9.place, _e9.stretch);
    return markplace;
}

float reflectance_wrap(Light light_1, float3 normal_5, float wrap)
{
    const float _e3 = bounded(wrap);
    float w_4 = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal_5, float3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light_1.direction);
    return max(((cosine + w_4) / (1.0 + w_4)), 0.0);
}

float invert(float value_2)
{
    const float _e3 = bounded((1.0 - value_2));
    return _e3;
}

float map_range(float value_3, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2)
{
    const float _e6 = remapped(value_3, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.3);
    const float _e12 = map_range(_e6, 0.0, 0.8, 0.02, 1.0, true);
    const float _e15 = threshold(_e12, 0.72, 0.0);
    const float4 _e26 = mix_colors_normal(float4(0.8392, 0.6039, 0.2902, 1.0), float4(0.9529, 0.902, 0.7843, 1.0), _e15);
    Light _e29 = look.key;
    const MarkPlace _e36 = mark_place_light(_e29, surface_1.normal, 0.0, surface_1.view, surface_1.position_object, surface_1.world_from_normal, surface_1.magnification);
    float2 _e51 = look.viewport;
    const float _e52 = hatching(_e12, _e36.place, _e36.stretch, 78.0, 0.62, int(1), 1.0471976, 0.0, 0.8, 0.35, 0.85, 1.0, int(7), _e51);
    const float _e55 = threshold(_e12, 0.2, 0.0);
    const float _e56 = invert(_e55);
    const float _e57 = combine_tones_union(_e52, _e56);
    const float _e59 = kappa_surface(surface_1.kappa);
    const float _e61 = transition(_e59, 0.22);
    const float _e64 = threshold(_e61, 0.2, 0.0);
    const float _e65 = invert(_e64);
    const float _e68 = facing(surface_1.normal, surface_1.view);
    const float _e71 = threshold(_e68, 0.3, 0.0);
    const float _e72 = invert(_e71);
    const float _e73 = combine_tones_union(_e65, _e72);
    const float _e74 = combine_tones_union(_e57, _e73);
    const float4 _e80 = mix_colors_normal(_e26, float4(0.1137, 0.0824, 0.0706, 1.0), _e74);
    const float4 _e81 = premultiplied(_e80);
    const float4 _e82 = output(_e81);
    return _e82;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_5.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    out_.position_object = vertex.position;
    float3x3 _e21 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e21);
    Varyings _e24 = out_;
    const Varyings varyings = _e24;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_2, fragmentinput_fs_main.normal_7 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_8 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_8;
    float4 _e15 = view_5.eye;
    float _e20 = view_5.eye.w;
    float4 _e26 = view_5.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    float4 _e42 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e42.x;
    float4x4 _e47 = view_5.camera_from_world;
    float _e57 = view_5.eye.w;
    float _e62 = view_5.clip_from_world[0].y;
    float _e67 = view_5.clip_from_world[1].y;
    float _e72 = view_5.clip_from_world[2].y;
    const float _e75 = size_on_screen(-(mul(float4(in_.position, 1.0), _e47).z), _e57, length(float3(_e62, _e67, _e72)));
    surface.magnification = _e75;
    float3x3 _e79 = object.world_from_normal;
    surface.world_from_normal = _e79;
    Surface _e80 = surface;
    const float4 _e81 = shade(_e80);
    const float4 _e82 = finite_vec4_(_e81);
    return _e82;
}
