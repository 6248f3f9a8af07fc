// Chalk: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// chalk-board.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    float4 eye;
    float4 screen;
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
    Light back;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light key;
};

struct Surface {
    float3 normal;
    float kappa;
    float2 pixel;
    int _pad3_0;
    int _pad3_1;
    float3 anchor;
    int _end_pad_0;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct ProfileShape {
    float half_cos_offset;
    float half_sin_offset;
    float scale;
    float exponent;
    float offset;
    float edge_mean;
    float edge_deviation;
    uint kind;
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

struct MarkPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct PaperGrain {
    float tone;
    float height;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 normal : LOC0;
};

ProfileShape ConstructProfileShape(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, float arg6, uint arg7) {
    ProfileShape ret = (ProfileShape)0;
    ret.half_cos_offset = arg0;
    ret.half_sin_offset = arg1;
    ret.scale = arg2;
    ret.exponent = arg3;
    ret.offset = arg4;
    ret.edge_mean = arg5;
    ret.edge_deviation = arg6;
    ret.kind = arg7;
    return ret;
}

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const ProfileShape orange_chalk_shape = ConstructProfileShape(0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706, 0.1847509, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 normal_2 : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 normal_3 : LOC0;
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
    float whole = round(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p_1 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p_1 * _e33) * _e37);
}

float log_stable(float x_3)
{
    uint bits = asuint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift_2 >= int(256)) ? asint(asuint(shift_2) - asuint(int(512))) : shift_2);
    float mantissa = asfloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
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

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_between(float3 d, float3 l)
{
    float p_2 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_2 * p_2) + (s_1 * s_1)), 1e-30)));
    const Angle angle_3 = ConstructAngle((p_2 * k), (s_1 * k));
    return angle_3;
}

float atan2_positive(float y_1, float x_6)
{
    float small = min(y_1, x_6);
    float large = max(y_1, x_6);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_5 = (small / large);
    bool is_wide = (t_5 > 0.41421357);
    float r_1 = (is_wide ? ((small - large) / (small + large)) : t_5);
    float r2_ = (r_1 * r_1);
    float series_1 = (r_1 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_5 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_6) ? (HALF_PI - a_5) : a_5);
}

float angle_radians(Angle u)
{
    const float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, float2 t)
{
    bool local_1 = (bool)0;

    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_1 = (s_2 < c_1);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    float2 turned = (_e32 ? float2(0.0, 1.0) : upper);
    const Angle angle_4 = ConstructAngle(turned.x, turned.y);
    return angle_4;
}

Angle angle_shifted(Angle u_2, float shift)
{
    const float2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    const Angle _e8 = angle_turned(u_2, _e7);
    const Angle angle_5 = _e8;
    return angle_5;
}

float angle_footprint(Angle u_3)
{
    float2 half_ = float2(u_3.half_sin, u_3.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_2, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_7)
{
    uint bits_1 = asuint(x_7);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_7 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
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

float mixed(float a, float b, float t_1)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_1, float3 b_1, float t_2)
{
    const float _e5 = mixed(a_1.x, b_1.x, t_2);
    const float _e8 = mixed(a_1.y, b_1.y, t_2);
    const float _e11 = mixed(a_1.z, b_1.z, t_2);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_2, float4 b_2, float t_3)
{
    const float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_3);
    const float _e8 = mixed(a_2.w, b_2.w, t_3);
    return float4(_e5, _e8);
}

float place_between(float x_8, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_8 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_8 - low) / _e12));
    return _e14;
}

float remapped(float x_9, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_9);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_10, float low_1, float high_1)
{
    const float _e3 = bounded(x_10);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_6 = clamp(_e6, 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float factor_of(float x_11, bool clamped_1)
{
    const float _e2 = bounded(x_11);
    const float _e3 = bounded(x_11);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float2 sin_cos_of(float x_12)
{
    const float _e1 = bounded(x_12);
    const float2 _e2 = sin_cos(_e1);
    return clamp(_e2, (-1.0).xx, (1.0).xx);
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
    float a_6 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_6), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_6 * a_6);
        return (a_6 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_7 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_6 >= 0.0) ? t_7 : -(t_7));
}

float transition(float kappa_2, float slope_1)
{
    const float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float kappa_surface(float kappa_3)
{
    const float _e1 = kappa_safe(kappa_3);
    return _e1;
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light.direction);
    const Angle angle_6 = _e8;
    return angle_6;
}

float profile_power(float q, float exponent)
{
    float log_base = 0.0;

    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        const float _e10 = log1p_negative_small((q * q));
        log_base = _e10;
    } else {
        const float _e16 = log_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e16;
    }
    float _e19 = log_base;
    const float _e21 = exp2_stable(((exponent * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape)
{
    bool local_2 = (bool)0;

    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_2 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_3 * shape.scale);
    const float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_1)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w));
    const Angle _e51 = angle_turned(u_5, _e50);
    const float _e52 = profile_point(_e51, shape_1);
    const Angle _e57 = angle_turned(u_5, float2(-(_e50.x), _e50.y));
    const float _e58 = profile_point(_e57, shape_1);
    return ((((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0);
}

float profile(Angle angle, float shift_1, ProfileShape shape_2)
{
    const Angle _e3 = angle_shifted(angle, shift_1);
    const float _e4 = angle_footprint(_e3);
    const float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
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

uint3 lattice_hash(int3 cell, uint seed_1)
{
    const uint3 _e9 = hash_pcg3d((asuint(cell) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float gradient_dot(uint3 hash, float3 d_1)
{
    uint axis = naga_mod((hash.x >> 8u), 3u);
    float a_7 = ((axis == 0u) ? d_1.y : d_1.x);
    float b_5 = ((axis == 2u) ? d_1.y : d_1.z);
    return ((((hash.y >> 31u) == 0u) ? a_7 : -(a_7)) + (((hash.z >> 31u) == 0u) ? b_5 : -(b_5)));
}

float3 fade_quintic(float3 t_4)
{
    return (((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i = int(0);

    float3 corner = floor(p);
    float3 d_2 = (p - corner);
    const float3 _e4 = fade_quintic(d_2);
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e46 = i;
            i = asint(asuint(_e46) + asuint(int(1)));
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
            const float _e42 = gradient_dot(_e39, (d_2 - float3(at_1)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float size_on_screen(float depth, float perspective, float scale)
{
    const float _e10 = bounded(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)));
    return _e10;
}

float3 anchor_on_screen(float3 origin, float perspective_1, float scale_1)
{
    const float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    const float3 _e12 = bounded_vec3_(float3((origin.x * _e5), (-(origin.y) * _e5), _e5));
    return _e12;
}

float2 place_in_picture(float2 pixel, float2 viewport)
{
    const float2 _e2 = bounded_vec2_(pixel);
    float2 from_middle = (_e2 - (0.5 * viewport));
    return (float2(from_middle.x, -(from_middle.y)) / (max(viewport.y, 1.0)).xx);
}

StretchedPlace ConstructStretchedPlace(float2 arg0, float3 arg1) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle_1)
{
    const float2 _e4 = sin_cos_of(angle_1);
    const float3 _e10 = bounded_vec3_(((_e4.y * along) + (_e4.x * across)));
    const float3 _e16 = bounded_vec3_(((_e4.y * across) - (_e4.x * along)));
    const float2 _e17 = bounded_vec2_(place);
    float2 turned_1 = float2(((_e4.y * _e17.x) + (_e4.x * _e17.y)), ((_e4.y * _e17.y) - (_e4.x * _e17.x)));
    float3 most = (1000000000000000.0).xxx;
    float3 stretch_3 = clamp(float3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    const float2 _e41 = bounded_vec2_(turned_1);
    const StretchedPlace stretchedplace = ConstructStretchedPlace(_e41, stretch_3);
    return stretchedplace;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_1, float3 stretch, float2 viewport_1, float count)
{
    const float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    const float2 _e19 = bounded_vec2_(place_1);
    const float2 _e21 = bounded_vec2_((_e19 * scale_2));
    float2 p_3 = clamp(_e21, (-4194304.0).xx, (4194304.0).xx);
    const float3 _e27 = bounded_vec3_(stretch);
    float3 s_4 = clamp(_e27, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_3, (is_pixel ? float3(1.0, 0.0, 1.0) : s_4));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
}

float octave_of(float square)
{
    const float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_object(float angle_2, float3 anchor, float2 pixel_1, float2 viewport_2)
{
    const float _e5 = bounded(anchor.z);
    float size = clamp(_e5, 1e-6, 1000000.0);
    const float2 _e9 = place_in_picture(pixel_1, viewport_2);
    const float2 _e15 = bounded_vec2_((_e9 - float2(anchor.x, -(anchor.y))));
    float2 place_4 = (_e15 / (size).xx);
    const StretchedPlace _e28 = mark_place_of(place_4, float3((1.0 / size), 0.0, 0.0), float3(0.0, (1.0 / size), 0.0), angle_2);
    const MarkPlace markplace = ConstructMarkPlace(_e28.place, _e28.stretch);
    return markplace;
}

float caught_ink(float ink, float height, float tooth)
{
    const float _e3 = bounded(ink);
    float amount = clamp(_e3, 0.0, 1.0);
    const float _e7 = bounded(tooth);
    float rough = clamp(_e7, 0.0, 1.0);
    return clamp((amount + ((((8.0 * rough) * (height - 0.5)) * amount) * (1.0 - amount))), 0.0, 1.0);
}

float paper_octave(float2 place_2, int zoom, float w_1, float fiber, uint seed_3)
{
    const float _e5 = power_of_two(zoom);
    float2 p_4 = clamp((place_2 * _e5), (-4194304.0).xx, (4194304.0).xx);
    uint own = (seed_3 + (7u * asuint(zoom)));
    const float _e18 = perlin_noise(float3(p_4, 0.5), own);
    float grain = (_e18 - 0.5);
    float2 q_2 = clamp((2.7 * float2(((0.8 * p_4.x) - (0.6 * p_4.y)), ((0.6 * p_4.x) + (0.8 * p_4.y)))), (-4194304.0).xx, (4194304.0).xx);
    const float _e47 = perlin_noise(float3(q_2, 0.5), (own + 1u));
    float felt = (_e47 - 0.5);
    const float _e53 = eased((w_1 * _e5), 0.5, 1.0);
    float coarse_seen = (1.0 - _e53);
    const float _e61 = eased(((2.7 * w_1) * _e5), 0.5, 1.0);
    float felt_seen = (1.0 - _e61);
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

float paper_height(SpacedPlace at, float fiber_1, uint seed_4)
{
    float height_1 = (float)0;

    float2 x_13 = ddx(at.place);
    float2 y_2 = ddy(at.place);
    const float _e11 = bounded(sqrt(max(dot(x_13, x_13), dot(y_2, y_2))));
    const float _e13 = area_square(at.stretch);
    const float _e15 = octave_of(sqrt(_e13));
    float zoom_1 = floor(_e15);
    float f_1 = (_e15 - zoom_1);
    const float _e18 = bounded(fiber_1);
    float fine = clamp(_e18, 0.0, 1.0);
    const float _e24 = paper_octave(at.place, naga_f2i32(zoom_1), _e11, fine, seed_4);
    height_1 = _e24;
    if ((f_1 > 0.0)) {
        float _e28 = height_1;
        const float _e33 = paper_octave(at.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), _e11, fine, seed_4);
        float both = lerp(_e28, _e33, f_1);
        height_1 = clamp((0.5 + ((both - 0.5) / sqrt(((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))))), 0.0, 1.0);
    }
    float _e51 = height_1;
    return _e51;
}

PaperGrain ConstructPaperGrain(float arg0, float arg1) {
    PaperGrain ret = (PaperGrain)0;
    ret.tone = arg0;
    ret.height = arg1;
    return ret;
}

PaperGrain paper_grain(float value, float2 place_3, float3 stretch_2, float count_1, float tooth_1, float fiber_2, int seed_5, float2 viewport_3)
{
    const SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    const float _e10 = paper_height(_e8, fiber_2, asuint(seed_5));
    const float _e12 = factor_of(value, true);
    const float _e15 = caught_ink((1.0 - _e12), _e10, tooth_1);
    const PaperGrain papergrain = ConstructPaperGrain((1.0 - _e15), _e10);
    return papergrain;
}

float reflectance_wrap(Light light_1, float3 normal_1, float wrap)
{
    const float _e3 = bounded(wrap);
    float w_3 = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light_1.direction);
    return max(((cosine + w_3) / (1.0 + w_3)), 0.0);
}

float invert(float value_1)
{
    const float _e3 = bounded((1.0 - value_1));
    return _e3;
}

float map_range(float value_2, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2)
{
    const float _e6 = remapped(value_2, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(float a_4, float b_4)
{
    const float _e3 = bounded((a_4 * b_4));
    return _e3;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.15);
    const float _e12 = map_range(_e6, 0.0, 0.9, 0.0, 1.0, true);
    const float _e18 = map_range(_e12, 0.0, 0.6, 0.05, 0.5, true);
    const float _e19 = invert(_e18);
    float2 _e25 = look.viewport;
    const MarkPlace _e26 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e25);
    float2 _e35 = look.viewport;
    const PaperGrain _e36 = paper_grain(_e19, _e26.place, _e26.stretch, 120.0, 0.6, 0.5, int(5), _e35);
    const float _e38 = invert(_e36.tone);
    const float4 _e49 = mix_colors_normal(float4(0.1216, 0.1647, 0.1686, 1.0), float4(0.4275, 0.5098, 0.5647, 1.0), _e38);
    Light _e52 = look.back;
    const Angle _e54 = parametrization_diffuse(_e52, surface_1.normal);
    const float _e57 = profile(_e54, 0.0, orange_chalk_shape);
    const float _e58 = invert(_e57);
    float2 _e67 = look.viewport;
    const PaperGrain _e68 = paper_grain(_e58, _e26.place, _e26.stretch, 220.0, 0.8, 0.5, int(9), _e67);
    const float _e70 = invert(_e68.tone);
    const float4 _e76 = mix_colors_normal(_e49, float4(0.9412, 0.6353, 0.3608, 1.0), _e70);
    const float _e78 = kappa_surface(surface_1.kappa);
    const float _e80 = transition(_e78, 0.16);
    const float _e86 = map_range(_e80, 0.15, 0.5, 0.1, 1.0, true);
    const float _e87 = multiply(_e12, _e86);
    const float _e88 = invert(_e87);
    float2 _e97 = look.viewport;
    const PaperGrain _e98 = paper_grain(_e88, _e26.place, _e26.stretch, 260.0, 0.62, 0.5, int(3), _e97);
    const float _e100 = invert(_e98.tone);
    const float4 _e106 = mix_colors_normal(_e76, float4(0.9686, 0.9529, 0.9098, 1.0), _e100);
    const float4 _e107 = premultiplied(_e106);
    const float4 _e108 = output(_e107);
    return _e108;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view.clip_from_world;
    out_.clip_ = mul(world, _e12);
    float3x3 _e17 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e17);
    Varyings _e20 = out_;
    const Varyings varyings = _e20;
    const VertexOutput_vs_main varyings_1 = { varyings.normal, varyings.clip_ };
    return varyings_1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    float4 _e18 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e18.x;
    float4 _e25 = view.screen;
    float4 _e30 = view.screen;
    surface.pixel = ((in_.clip_.xy * _e25.xy) + _e30.zw);
    float4x4 _e36 = view.camera_from_world;
    float4 _e40 = object.world_from_object[3];
    float _e49 = view.eye.w;
    float _e54 = view.clip_from_world[0].y;
    float _e59 = view.clip_from_world[1].y;
    float _e64 = view.clip_from_world[2].y;
    const float3 _e67 = anchor_on_screen(mul(float4(_e40.xyz, 1.0), _e36).xyz, _e49, length(float3(_e54, _e59, _e64)));
    surface.anchor = _e67;
    Surface _e68 = surface;
    const float4 _e69 = shade(_e68);
    const float4 _e70 = finite_vec4_(_e69);
    return _e70;
}
