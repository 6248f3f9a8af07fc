// Travel poster: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// travel-poster.json says what to put there and how to draw.
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
    Light sky;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    float kappa;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct Ramp {
    float4 colors[16];
    float4 places[4];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
};

struct LitLayer {
    float4 color;
    float tone;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
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

typedef float4 ret_Constructarray16_float4_[16];
ret_Constructarray16_float4_ Constructarray16_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3, float4 arg4, float4 arg5, float4 arg6, float4 arg7, float4 arg8, float4 arg9, float4 arg10, float4 arg11, float4 arg12, float4 arg13, float4 arg14, float4 arg15) {
    float4 ret[16] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10, arg11, arg12, arg13, arg14, arg15 };
    return ret;
}

typedef float4 ret_Constructarray4_float4_[4];
ret_Constructarray4_float4_ Constructarray4_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3) {
    float4 ret[4] = { arg0, arg1, arg2, arg3 };
    return ret;
}

Ramp ConstructRamp(float4 arg0[16], float4 arg1[4], uint arg2, uint arg3) {
    Ramp ret = (Ramp)0;
    ret.colors = arg0;
    ret.places = arg1;
    ret.count = arg2;
    ret.interpolation = arg3;
    return ret;
}

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const ProfileShape evening_sun_tone_shape = ConstructProfileShape(1.0, 0.0, 1.0955735, 1.6395584, 0.0, 1.1385497, 0.5052584, 0u);
static const ProfileShape sky_tone_shape = ConstructProfileShape(1.0, 0.0, 1.229384, 1.2860026, 0.0, 1.0836705, 0.44442755, 0u);
static const ProfileShape glow_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 2.425296, 2.5857167, 0.1, 0.4039123, 0.17722374, 0u);
static const Ramp seven_inks = ConstructRamp(Constructarray16_float4_(float4(0.0863, 0.1333, 0.2471, 1.0), float4(0.1725, 0.3176, 0.3882, 1.0), float4(0.4863, 0.2275, 0.2706, 1.0), float4(0.7686, 0.3294, 0.2471, 1.0), float4(0.8784, 0.5412, 0.298, 1.0), float4(0.9412, 0.7608, 0.4824, 1.0), float4(0.9843, 0.9333, 0.7961, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.15, 0.3, 0.45), float4(0.6, 0.8, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx), 7u, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
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
    float square = dot(scaled, scaled);
    const bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
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
    float clamped_2 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_2);
    float f = ((clamped_2 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3)
{
    uint bits = asuint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_2 = ((shift_2 >= int(256)) ? asint(asuint(shift_2) - asuint(int(512))) : shift_2);
    float mantissa = asfloat((bits - (uint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_2) * LN_2_) + series);
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

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_between(float3 d, float3 l)
{
    float p_1 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_1 * p_1) + (s_1 * s_1)), 1e-30)));
    const Angle angle_1 = ConstructAngle((p_1 * k), (s_1 * k));
    return angle_1;
}

float atan2_positive(float y_1, float x_5)
{
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a) : a);
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
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

Angle angle_shifted(Angle u_2, float shift)
{
    const float2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    const Angle _e8 = angle_turned(u_2, _e7);
    const Angle angle_3 = _e8;
    return angle_3;
}

float angle_footprint(Angle u_3)
{
    float2 half_ = float2(u_3.half_sin, u_3.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_5, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    const float _e6 = bounded(v_3.z);
    return float3(_e2, _e4, _e6);
}

float powered(float base, float exponent)
{
    bool local_2 = (bool)0;

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
        local_2 = !(is_even);
    } else {
        local_2 = false;
    }
    bool _e36 = local_2;
    return (_e36 ? -(_e22) : _e22);
}

float length_of(float3 v_4)
{
    const float3 _e1 = bounded_vec3_(v_4);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e17 = bounded((largest_2 * length((_e1 / (largest_2).xxx))));
    return _e17;
}

float footprint_of(float x_7)
{
    float _e1 = ddx(x_7);
    float _e2 = ddy(x_7);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness)
{
    const float _e4 = bounded(softness);
    return length(float2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_8, float edge, float w_1)
{
    const float _e4 = bounded((x_8 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float stairs_integral(float x_9, float count)
{
    float inside = clamp(x_9, 0.0, count);
    float stair = min(floor(inside), (count - 1.0));
    float beyond = max((x_9 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * (count - 1.0)));
}

float stairs_filtered(float x_10, float count_1, float w_2)
{
    if ((w_2 <= 1.0)) {
        float edge_1 = clamp(round(x_10), 1.0, (count_1 - 1.0));
        const float _e12 = step_filtered(x_10, edge_1, w_2);
        return ((edge_1 - 1.0) + _e12);
    }
    float half_1 = (0.5 * min(w_2, (1000.0 * count_1)));
    const float _e20 = stairs_integral((x_10 + half_1), count_1);
    const float _e22 = stairs_integral((x_10 - half_1), count_1);
    return ((_e20 - _e22) / (2.0 * half_1));
}

float stepped_tone(float value, float w_3, int count_2, float softness_1)
{
    float n_1 = float(clamp(count_2, int(2), int(1024)));
    const float _e11 = edge_width((n_1 * w_3), min(softness_1, 1.0));
    const float _e12 = bounded(value);
    const float _e17 = stairs_filtered((n_1 * clamp(_e12, 0.0, 1.0)), n_1, _e11);
    return clamp((_e17 / (n_1 - 1.0)), 0.0, 1.0);
}

float linear_of_srgb(float coded)
{
    const float _e1 = bounded(coded);
    float size = abs(_e1);
    const float _e8 = powered(((size + 0.055) / 1.055), 2.4);
    float value_1 = ((size <= 0.04045) ? (size / 12.92) : _e8);
    return ((coded < 0.0) ? -(value_1) : value_1);
}

float srgb_of_linear(float light)
{
    const float _e1 = bounded(light);
    float size_1 = abs(_e1);
    const float _e4 = powered(size_1, 0.41666666);
    float value_2 = ((size_1 <= 0.0031308) ? (size_1 * 12.92) : ((1.055 * _e4) - 0.055));
    const float _e18 = bounded(((light < 0.0) ? -(value_2) : value_2));
    return _e18;
}

float3 within_unit(float3 rgb)
{
    const float3 _e1 = bounded_vec3_(rgb);
    return clamp(_e1, (0.0).xxx, (1.0).xxx);
}

float cube_root(float x_11)
{
    const float _e3 = powered(abs(x_11), 0.33333334);
    return ((x_11 < 0.0) ? -(_e3) : _e3);
}

float3 oklab_of_linear(float3 rgb_1)
{
    const float3 _e1 = bounded_vec3_(rgb_1);
    float3 c_2 = clamp(_e1, (-1000000000.0).xxx, (1000000000.0).xxx);
    const float _e12 = cube_root(dot(c_2, float3(0.41222146, 0.53633255, 0.051445995)));
    const float _e18 = cube_root(dot(c_2, float3(0.2119035, 0.6806995, 0.10739696)));
    const float _e24 = cube_root(dot(c_2, float3(0.08830246, 0.28171885, 0.6299787)));
    return float3((((0.21045426 * _e12) + (0.7936178 * _e18)) - (0.004072047 * _e24)), (((1.9779985 * _e12) - (2.4285922 * _e18)) + (0.4505937 * _e24)), (((0.025904037 * _e12) + (0.78277177 * _e18)) - (0.80867577 * _e24)));
}

float3 linear_of_oklab(float3 lab)
{
    const float3 _e1 = bounded_vec3_(lab);
    float3 c_3 = clamp(_e1, (-1000000.0).xxx, (1000000.0).xxx);
    float l_1 = ((c_3.x + (0.39633778 * c_3.y)) + (0.21580376 * c_3.z));
    float m = ((c_3.x - (0.105561346 * c_3.y)) - (0.06385417 * c_3.z));
    float s_3 = ((c_3.x - (0.08948418 * c_3.y)) - (1.2914855 * c_3.z));
    float3 cubes = float3(((l_1 * l_1) * l_1), ((m * m) * m), ((s_3 * s_3) * s_3));
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

float3 oklab_of_srgb(float3 coded_1)
{
    const float _e2 = linear_of_srgb(coded_1.x);
    const float _e4 = linear_of_srgb(coded_1.y);
    const float _e6 = linear_of_srgb(coded_1.z);
    const float3 _e8 = oklab_of_linear(float3(_e2, _e4, _e6));
    return _e8;
}

float3 srgb_of_oklab(float3 lab_1)
{
    const float3 _e1 = linear_of_oklab(lab_1);
    const float _e3 = srgb_of_linear(_e1.x);
    const float _e5 = srgb_of_linear(_e1.y);
    const float _e7 = srgb_of_linear(_e1.z);
    return float3(_e3, _e5, _e7);
}

float3 palette_blend(Ramp palette, float3 rgb_2, float softness_2)
{
    float4 colors[16] = (float4[16])0;
    float nearest = 1e30;
    float3 found = (0.0).xxx;
    uint i = 0u;
    bool local_3 = (bool)0;
    float3 sum = (0.0).xxx;
    float total = 0.0;
    uint i_1 = 0u;

    uint count_3 = min(palette.count, 16u);
    colors = palette.colors;
    const float3 _e8 = oklab_of_srgb(rgb_2);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e39 = i;
            i = (_e39 + 1u);
        }
        loop_init = false;
        uint _e16 = i;
        if ((_e16 < count_3)) {
        } else {
            break;
        }
        {
            uint _e18 = i;
            float4 _e20 = colors[min(uint(_e18), 15u)];
            const float3 _e22 = oklab_of_srgb(_e20.xyz);
            const float _e24 = length_of((_e22 - _e8));
            float far = min(_e24, 1e29);
            float3 _e27 = found;
            uint _e28 = i;
            float4 _e30 = colors[min(uint(_e28), 15u)];
            const float3 _e32 = bounded_vec3_(_e30.xyz);
            float _e33 = nearest;
            found = ((far < _e33) ? _e32 : _e27);
            float _e36 = nearest;
            nearest = min(_e36, far);
        }
    }
    if (!((softness_2 <= 0.0))) {
        local_3 = (count_3 == 0u);
    } else {
        local_3 = true;
    }
    bool _e49 = local_3;
    if (_e49) {
        float3 _e50 = found;
        return _e50;
    }
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e83 = i_1;
            i_1 = (_e83 + 1u);
        }
        loop_init_1 = false;
        uint _e58 = i_1;
        if ((_e58 < count_3)) {
        } else {
            break;
        }
        {
            uint _e60 = i_1;
            float4 _e62 = colors[min(uint(_e60), 15u)];
            const float3 _e64 = oklab_of_srgb(_e62.xyz);
            const float _e66 = length_of((_e64 - _e8));
            float _e67 = nearest;
            float near = clamp((1.0 - ((_e66 - _e67) / softness_2)), 0.0, 1.0);
            float3 _e75 = sum;
            sum = (_e75 + ((near * near) * _e64));
            float _e79 = total;
            total = (_e79 + (near * near));
        }
    }
    float3 _e85 = sum;
    float _e86 = total;
    const float3 _e91 = srgb_of_oklab((_e85 / (max(_e86, 1e-6)).xxx));
    const float3 _e92 = bounded_vec3_(_e91);
    return _e92;
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

float4 palette_nearest(float4 color_1, Ramp palette_1)
{
    const float3 _e3 = bounded_vec3_(color_1.xyz);
    const float3 _e5 = palette_blend(palette_1, _e3, 0.0);
    const float _e7 = bounded(color_1.w);
    return float4(_e5, _e7);
}

float4 posterize_lightness(float4 color_2, int steps, float softness_3)
{
    const float3 _e4 = within_unit(color_2.xyz);
    const float3 _e5 = oklab_of_srgb(_e4);
    const float _e8 = footprint_of(_e5.x);
    const float _e9 = stepped_tone(_e5.x, _e8, steps, softness_3);
    float kept = ((_e5.x > 0.0001) ? (_e9 / max(_e5.x, 0.0001)) : 0.0);
    const float3 _e24 = srgb_of_oklab(float3(_e9, (_e5.yz * min(kept, 1.0))));
    const float3 _e25 = within_unit(_e24);
    const float _e27 = bounded(color_2.w);
    return float4(_e25, _e27);
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
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
    float a_1 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_2 = min(abs(a_1), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_2));
    float t_2 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float transition(float kappa_2, float slope_1)
{
    const float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float warp(float convexity_1, float amount)
{
    return (((2.0 * convexity_1) - 1.0) * clamp(amount, -3.1415927, 3.1415927));
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed, (0.0).xxxx, (1.0).xxxx) : mixed);
}

float4 blend_add(float4 below_1, float4 color_3, float tone, float opacity_1, bool clamped_1)
{
    const float4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color_3.xyz)), below_1.w, (opacity_1 * color_3.w), clamped_1);
    return _e12;
}

float4 output(float4 color_4)
{
    const float4 _e1 = straight(color_4);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float2 light_split(float intensity)
{
    return float2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light_1, float4 color_5, float tone_1)
{
    const float2 _e4 = light_split(light_1.intensity);
    const LitLayer litlayer = ConstructLitLayer(float4(((color_5.xyz * light_1.color) * _e4.y), color_5.w), (tone_1 * _e4.x));
    return litlayer;
}

Angle parametrization_diffuse(Light light_2, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light_2.direction);
    const Angle angle_4 = _e8;
    return angle_4;
}

Angle parametrization_specular(Light light_3, float3 normal_1, float3 view)
{
    const float3 _e7 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float3 mirrored = (((2.0 * dot(_e7, view)) * _e7) - view);
    const float3 _e13 = normalize_or(mirrored, _e7);
    const Angle _e15 = angle_between(_e13, light_3.direction);
    const Angle angle_5 = _e15;
    return angle_5;
}

float profile_power(float q, float exponent_1)
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
    const float _e21 = exp2_stable(((exponent_1 * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape)
{
    bool local_4 = (bool)0;

    float s_4 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_4 <= 0.0))) {
        local_4 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_4 = true;
    }
    bool _e18 = local_4;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_4 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_4 * shape.scale);
    const float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_4, ProfileShape shape_1)
{
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w_4 <= 0.0))) {
        local_5 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_5 = true;
    }
    bool _e13 = local_5;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_6 = (w_4 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_6 = false;
    }
    bool _e24 = local_6;
    if (_e24) {
        float width = sqrt(((w_4 * w_4) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_4 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w_4));
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

float4 shade(Surface surface_1)
{
    const float _e3 = transition(surface_1.kappa, 0.12);
    const float4 _e14 = curvature_color(_e3, float4(0.93, 0.62, 0.36, 1.0), float4(0.66, 0.24, 0.24, 1.0));
    Light _e17 = look.key;
    const Angle _e19 = parametrization_diffuse(_e17, surface_1.normal);
    const float _e21 = warp(_e3, 0.1);
    const float _e23 = profile(_e19, _e21, evening_sun_tone_shape);
    Light _e26 = look.key;
    const LitLayer _e27 = light_apply(_e26, _e14, _e23);
    const float4 _e37 = blend_add(float4(0.07, 0.1, 0.22, 1.0), _e27.color, _e27.tone, 1.0, true);
    Light _e40 = look.sky;
    const Angle _e42 = parametrization_diffuse(_e40, surface_1.normal);
    const float _e45 = profile(_e42, 0.0, sky_tone_shape);
    Light _e48 = look.sky;
    const LitLayer _e54 = light_apply(_e48, float4(0.02, 0.24, 0.3, 1.0), _e45);
    const float4 _e59 = blend_add(_e37, _e54.color, _e54.tone, 1.0, true);
    Light _e62 = look.key;
    const Angle _e65 = parametrization_specular(_e62, surface_1.normal, surface_1.view);
    const float _e68 = profile(_e65, 0.0, glow_tone_shape);
    Light _e71 = look.key;
    const LitLayer _e77 = light_apply(_e71, float4(0.42, 0.38, 0.24, 1.0), _e68);
    const float4 _e82 = blend_add(_e59, _e77.color, _e77.tone, 1.0, true);
    const float4 _e83 = straight(_e82);
    const float4 _e86 = posterize_lightness(_e83, int(7), 0.02);
    const float4 _e88 = palette_nearest(_e86, seven_inks);
    const float4 _e89 = premultiplied(_e88);
    const float4 _e90 = output(_e89);
    return _e90;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_1.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    Varyings _e22 = out_;
    const Varyings varyings = _e22;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    float4 _e26 = view_1.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    float4 _e40 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e40.x;
    Surface _e42 = surface;
    const float4 _e43 = shade(_e42);
    const float4 _e44 = finite_vec4_(_e43);
    return _e44;
}
