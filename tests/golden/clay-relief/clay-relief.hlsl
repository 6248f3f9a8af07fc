// Clay relief: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0, curvature_tensor_map t1.
// clay-relief.json says what to put there and how to draw.
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
    Light sky;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    float kappa;
    float3 curvature_tensor;
    int _end_pad_0;
};

struct Ramp {
    float4 colors[16];
    float4 places[4];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
};

struct RampPlace {
    float4 before;
    float4 after;
    float t;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct Relief {
    float shape;
    float strength;
    float greatest;
    float least;
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
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const Ramp terracotta = ConstructRamp(Constructarray16_float4_(float4(0.2353, 0.102, 0.1098, 1.0), float4(0.5412, 0.251, 0.1882, 1.0), float4(0.8118, 0.498, 0.3412, 1.0), float4(0.949, 0.7412, 0.5725, 1.0), float4(0.9843, 0.8627, 0.7333, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.3, 0.62, 0.9), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 0u);
static const Ramp pits_to_bumps = ConstructRamp(Constructarray16_float4_(float4(0.2941, 0.2275, 0.3216, 1.0), float4(0.4784, 0.2902, 0.2902, 1.0), float4(0.7529, 0.502, 0.3765, 1.0), float4(0.9412, 0.7529, 0.5804, 1.0), float4(1.0, 0.9412, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.3, 0.5, 0.75), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);
Texture2D<float4> curvature_tensor_map : register(t1);

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
    float clamped_1 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_1);
    float f = ((clamped_1 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p * _e33) * _e37);
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

float atan2_positive(float y, float x_4)
{
    float small = min(y, x_4);
    float large = max(y, x_4);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_6 = (small / large);
    bool is_wide = (t_6 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_6);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_11 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y > x_4) ? (HALF_PI - a_11) : a_11);
}

float bounded(float x_5)
{
    uint bits_1 = asuint(x_5);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_5 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
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

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
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

float exponential_of(float x_6)
{
    const float _e3 = bounded((x_6 * LOG2_E));
    const float _e4 = exp2_stable(_e3);
    return _e4;
}

float mixed(float a_1, float b_1, float t)
{
    const float _e4 = bounded((b_1 - a_1));
    const float _e14 = bounded(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_2, float3 b_2, float t_1)
{
    const float _e5 = mixed(a_2.x, b_2.x, t_1);
    const float _e8 = mixed(a_2.y, b_2.y, t_1);
    const float _e11 = mixed(a_2.z, b_2.z, t_1);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_3, float4 b_3, float t_2)
{
    const float3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    const float _e8 = mixed(a_3.w, b_3.w, t_2);
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

float eased(float x_8, float low_1, float high_1)
{
    const float _e3 = bounded(x_8);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_7 = clamp(_e6, 0.0, 1.0);
    return ((t_7 * t_7) * (3.0 - (2.0 * t_7)));
}

float factor_of(float x_9, bool clamped)
{
    const float _e2 = bounded(x_9);
    const float _e3 = bounded(x_9);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float angle_of_point(float y_1, float x_10)
{
    const float2 _e3 = bounded_vec2_(float2(x_10, y_1));
    float2 p_1 = abs(_e3);
    float2 scaled_1 = ((max(p_1.x, p_1.y) > 1.0) ? (0.5 * p_1) : p_1);
    const float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned = ((x_10 < 0.0) ? (PI - _e15) : _e15);
    return ((y_1 < 0.0) ? -(turned) : turned);
}

float footprint_of(float x_11)
{
    float _e1 = ddx(x_11);
    float _e2 = ddy(x_11);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_12, float edge, float w)
{
    const float _e4 = bounded((x_12 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
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

float soft_light(float a_4, float b_4)
{
    if ((b_4 <= 0.5)) {
        return (a_4 - (((1.0 - (2.0 * b_4)) * a_4) * (1.0 - a_4)));
    }
    float curved_1 = ((a_4 <= 0.25) ? (((((16.0 * a_4) - 12.0) * a_4) + 4.0) * a_4) : sqrt(max(a_4, 0.0)));
    return (a_4 + (((2.0 * b_4) - 1.0) * (curved_1 - a_4)));
}

float4 color_mixed(float4 a_5, float3 blended, float factor)
{
    const float3 _e4 = bounded_vec3_(a_5.xyz);
    const float3 _e5 = bounded_vec3_(blended);
    const float _e7 = factor_of(factor, true);
    const float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    const float _e10 = bounded(a_5.w);
    return float4(_e8, _e10);
}

float cube_root(float x_13)
{
    const float _e3 = powered(abs(x_13), 0.33333334);
    return ((x_13 < 0.0) ? -(_e3) : _e3);
}

float3 oklab_of_linear(float3 rgb)
{
    const float3 _e1 = bounded_vec3_(rgb);
    float3 c = clamp(_e1, (-1000000000.0).xxx, (1000000000.0).xxx);
    const float _e12 = cube_root(dot(c, float3(0.41222146, 0.53633255, 0.051445995)));
    const float _e18 = cube_root(dot(c, float3(0.2119035, 0.6806995, 0.10739696)));
    const float _e24 = cube_root(dot(c, float3(0.08830246, 0.28171885, 0.6299787)));
    return float3((((0.21045426 * _e12) + (0.7936178 * _e18)) - (0.004072047 * _e24)), (((1.9779985 * _e12) - (2.4285922 * _e18)) + (0.4505937 * _e24)), (((0.025904037 * _e12) + (0.78277177 * _e18)) - (0.80867577 * _e24)));
}

float3 linear_of_oklab(float3 lab)
{
    const float3 _e1 = bounded_vec3_(lab);
    float3 c_1 = clamp(_e1, (-1000000.0).xxx, (1000000.0).xxx);
    float l = ((c_1.x + (0.39633778 * c_1.y)) + (0.21580376 * c_1.z));
    float m = ((c_1.x - (0.105561346 * c_1.y)) - (0.06385417 * c_1.z));
    float s = ((c_1.x - (0.08948418 * c_1.y)) - (1.2914855 * c_1.z));
    float3 cubes = float3(((l * l) * l), ((m * m) * m), ((s * s) * s));
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

float4 ends_kept(float4 a_6, float4 b_5, float t_3, float3 rgb_1)
{
    const float3 _e4 = bounded_vec3_(rgb_1);
    const float _e7 = mixed(a_6.w, b_5.w, t_3);
    float4 mixed_color = float4(_e4, _e7);
    const float4 _e9 = bounded_vec4_(b_5);
    const float4 _e13 = bounded_vec4_(a_6);
    return ((t_3 <= 0.0) ? _e13 : ((t_3 >= 1.0) ? _e9 : mixed_color));
}

float4 mixed_in_oklab(float4 a_7, float4 b_6, float t_4)
{
    const float3 _e4 = oklab_of_srgb(a_7.xyz);
    const float3 _e6 = oklab_of_srgb(b_6.xyz);
    const float3 _e7 = mixed_vec3_(_e4, _e6, t_4);
    const float3 _e8 = srgb_of_oklab(_e7);
    const float4 _e9 = ends_kept(a_7, b_6, t_4, _e8);
    return _e9;
}

float4 hermite(float4 a_8, float4 b_7, float4 from_a, float4 to_b, float t_5)
{
    float4 d_1 = (b_7 - a_8);
    return (a_8 + (t_5 * (from_a + (t_5 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_5 * ((from_a + to_b) - (2.0 * d_1))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after)
{
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    const float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

float4 ramp_slope(float4 rise_before, float span_before_1, float4 rise_after, float span_after_1)
{
    const float _e5 = divided(rise_before.x, span_before_1);
    const float _e7 = divided(rise_after.x, span_after_1);
    const float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    const float _e10 = divided(rise_before.y, span_before_1);
    const float _e12 = divided(rise_after.y, span_after_1);
    const float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    const float _e15 = divided(rise_before.z, span_before_1);
    const float _e17 = divided(rise_after.z, span_after_1);
    const float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    const float _e20 = divided(rise_before.w, span_before_1);
    const float _e22 = divided(rise_after.w, span_after_1);
    const float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return float4(_e8, _e13, _e18, _e23);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float4 ramp_at(Ramp ramp, float x_14, float w_1)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_2 = (bool)0;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    uint count = min(ramp.count, 16u);
    if ((count == 0u)) {
        return (0.0).xxxx;
    }
    colors = ramp.colors;
    places = ramp.places;
    if ((ramp.interpolation == INTERPOLATION_STEPPED)) {
        float4 _e18 = colors[0];
        color = _e18;
        uint2 loop_bound = uint2(4294967295u, 4294967295u);
        bool loop_init = true;
        while(true) {
            if (all(loop_bound == uint2(0u, 0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e47 = i;
                i = (_e47 + 1u);
            }
            loop_init = false;
            uint _e22 = i;
            if ((_e22 < count)) {
            } else {
                break;
            }
            {
                float4 _e24 = color;
                uint _e25 = i;
                float4 _e27 = colors[min(uint(_e25), 15u)];
                uint _e28 = i;
                float4 _e32 = colors[min(uint((_e28 - 1u)), 15u)];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places[min(uint(naga_div(_e34, 4u)), 3u)][min(uint(naga_mod(_e38, 4u)), 3u)];
                const float _e43 = step_filtered(x_14, _e42, w_1);
                color = (_e24 + ((_e27 - _e32) * _e43));
            }
        }
        float4 _e49 = color;
        const float4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = (_e71 + 1u);
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if ((_e55 < count)) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places[min(uint(naga_div(_e59, 4u)), 3u)][min(uint(naga_mod(_e63, 4u)), 3u)];
            at = ((_e67 <= x_14) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = (x_14 <= place);
    } else {
        local_2 = true;
    }
    bool _e91 = local_2;
    if (_e91) {
        uint _e92 = at;
        float4 _e94 = colors[min(uint(_e92), 15u)];
        const float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span_1 = (_e105 - place);
    const float _e108 = divided((x_14 - place), span_1);
    float t_8 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        float4 _e117 = colors[min(uint(_e115), 15u)];
        float4 _e119 = colors[min(uint(after_1), 15u)];
        const float4 _e120 = mixed_vec4_(_e117, _e119, t_8);
        return _e120;
    }
    uint _e127 = at;
    if ((_e127 > 0u)) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places[min(uint(naga_div((_e130 - 1u), 4u)), 3u)][min(uint(naga_mod((_e136 - 1u), 4u)), 3u)];
        uint _e143 = at;
        float4 _e145 = colors[min(uint(_e143), 15u)];
        uint _e146 = at;
        float4 _e150 = colors[min(uint((_e146 - 1u)), 15u)];
        float4 _e154 = colors[min(uint(after_1), 15u)];
        uint _e155 = at;
        float4 _e157 = colors[min(uint(_e155), 15u)];
        const float4 _e159 = ramp_slope((_e145 - _e150), (place - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count)) {
        float _e173 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e173 - (place + span_1));
        float4 _e177 = colors[min(uint(after_1), 15u)];
        uint _e178 = at;
        float4 _e180 = colors[min(uint(_e178), 15u)];
        float4 _e185 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e187 = colors[min(uint(after_1), 15u)];
        const float4 _e189 = ramp_slope((_e177 - _e180), span_1, (_e185 - _e187), next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    float4 _e192 = colors[min(uint(_e190), 15u)];
    float4 _e194 = colors[min(uint(after_1), 15u)];
    float4 _e195 = from_a_1;
    float4 _e197 = to_b_1;
    const float4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_8);
    const float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

RampPlace ConstructRampPlace(float4 arg0, float4 arg1, float arg2) {
    RampPlace ret = (RampPlace)0;
    ret.before = arg0;
    ret.after = arg1;
    ret.t = arg2;
    return ret;
}

RampPlace ramp_place(Ramp ramp_1, float x_15)
{
    float4 colors_1[16] = (float4[16])0;
    float4 places_1[4] = (float4[4])0;
    uint at_1 = 0u;
    uint i_2 = 1u;

    uint count_1 = min(ramp_1.count, 16u);
    if ((count_1 == 0u)) {
        const RampPlace rampplace = ConstructRampPlace((0.0).xxxx, (0.0).xxxx, 0.0);
        return rampplace;
    }
    colors_1 = ramp_1.colors;
    places_1 = ramp_1.places;
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            uint _e37 = i_2;
            i_2 = (_e37 + 1u);
        }
        loop_init_2 = false;
        uint _e21 = i_2;
        if ((_e21 < count_1)) {
        } else {
            break;
        }
        {
            uint _e23 = at_1;
            uint _e24 = i_2;
            uint _e25 = i_2;
            uint _e29 = i_2;
            float _e33 = places_1[min(uint(naga_div(_e25, 4u)), 3u)][min(uint(naga_mod(_e29, 4u)), 3u)];
            at_1 = ((_e33 <= x_15) ? _e24 : _e23);
        }
    }
    uint _e39 = at_1;
    uint after_2 = min((_e39 + 1u), (count_1 - 1u));
    uint _e45 = at_1;
    uint _e49 = at_1;
    float place_1 = places_1[min(uint(naga_div(_e45, 4u)), 3u)][min(uint(naga_mod(_e49, 4u)), 3u)];
    float _e61 = places_1[min(uint(naga_div(after_2, 4u)), 3u)][min(uint(naga_mod(after_2, 4u)), 3u)];
    const float _e63 = divided((x_15 - place_1), (_e61 - place_1));
    float t_9 = clamp(_e63, 0.0, 1.0);
    uint _e67 = at_1;
    float4 _e69 = colors_1[min(uint(_e67), 15u)];
    float4 _e71 = colors_1[min(uint(after_2), 15u)];
    const float _e74 = eased(t_9, 0.0, 1.0);
    const RampPlace rampplace_1 = ConstructRampPlace(_e69, _e71, ((ramp_1.interpolation == INTERPOLATION_SMOOTH) ? _e74 : t_9));
    return rampplace_1;
}

float4 premultiplied(float4 color_1)
{
    return float4((color_1.xyz * color_1.w), color_1.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 mix_colors_screen(float4 a_9, float4 b_8, float factor_1)
{
    const float4 _e10 = color_mixed(a_9, ((a_9.xyz + b_8.xyz) - (a_9.xyz * b_8.xyz)), factor_1);
    return _e10;
}

float4 mix_colors_soft_light(float4 a_10, float4 b_9, float factor_2)
{
    const float _e5 = soft_light(a_10.x, b_9.x);
    const float _e8 = soft_light(a_10.y, b_9.y);
    const float _e11 = soft_light(a_10.z, b_9.z);
    const float4 _e13 = color_mixed(a_10, float3(_e5, _e8, _e11), factor_2);
    return _e13;
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
    float a_12 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_2 = min(abs(a_12), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_12 * a_12);
        return (a_12 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_2));
    float t_10 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_12 >= 0.0) ? t_10 : -(t_10));
}

float3 tensor_safe(float3 tensor)
{
    const float _e2 = kappa_safe(tensor.x);
    const float _e4 = kappa_safe(tensor.y);
    const float _e6 = kappa_safe(tensor.z);
    return float3(_e2, _e4, _e6);
}

float2 principal_curvatures(float3 tensor_1)
{
    float mean = (0.5 * (tensor_1.x + tensor_1.z));
    float spread = length(float2((0.5 * (tensor_1.x - tensor_1.z)), tensor_1.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    const float _e26 = divided(((tensor_1.x * tensor_1.z) - (tensor_1.y * tensor_1.y)), far);
    return ((mean >= 0.0) ? float2(far, _e26) : float2(_e26, far));
}

float4 output(float4 color_2)
{
    const float4 _e1 = straight(color_2);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float4 ramp_oklab(float value, Ramp ramp_2)
{
    const float _e2 = footprint_of(value);
    if ((ramp_2.interpolation == INTERPOLATION_STEPPED)) {
        const float _e6 = bounded(value);
        const float4 _e7 = ramp_at(ramp_2, _e6, _e2);
        return _e7;
    }
    const float _e8 = bounded(value);
    const RampPlace _e9 = ramp_place(ramp_2, _e8);
    const float4 _e13 = mixed_in_oklab(_e9.before, _e9.after, _e9.t);
    return _e13;
}

float reflectance_half_lambert(Light light_1, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    float half_ = (0.5 + (0.5 * dot(_e6, light_1.direction)));
    return clamp((half_ * half_), 0.0, 1.0);
}

float rim(Light light_2, float3 normal_1, float3 view, float width, float softness, float follow)
{
    const float3 _e10 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float facing = clamp(dot(_e10, view), 0.0, 1.0);
    const float _e16 = factor_of(width, true);
    const float _e18 = factor_of(softness, true);
    const float _e20 = footprint_of(facing);
    float edge_1 = max((_e16 * _e18), min(_e20, 1.0));
    float3 aside = (_e10 - view);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing));
    float within = ((further / max(edge_1, 1e-6)) + ((softness > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    float3 across = (light_2.direction - (dot(light_2.direction, view) * view));
    const float3 _e61 = normalize_or(across, (0.0).xxx);
    float side = dot((_e10 - (dot(_e10, view) * view)), _e61);
    const float _e66 = eased(side, 0.0, 0.5);
    const float _e68 = factor_of(follow, true);
    const float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float radiance_scaled(float tone, float curved, float turning)
{
    const float _e3 = exponential_of(curved);
    float dark = (turning * (1.0 - tone));
    float light_3 = (tone * (1.0 - turning));
    return ((tone * ((_e3 * dark) + light_3)) / max((dark + (_e3 * light_3)), 1e-20));
}

float radiance_scaling(float tone_1, float kappa_2, float amount, float slope_1, float turning_1)
{
    const float _e5 = bounded(amount);
    const float _e9 = curvature_signed(kappa_2, slope_1);
    float curved_2 = (clamp(_e5, -16.0, 16.0) * _e9);
    const float _e11 = bounded(turning_1);
    float at_2 = clamp(_e11, 0.001, 0.999);
    const float _e15 = bounded(tone_1);
    float before_2 = clamp(_e15, 0.0, 1.0);
    const float _e19 = radiance_scaled(before_2, curved_2, at_2);
    return clamp(((curved_2 == 0.0) ? before_2 : _e19), 0.0, 1.0);
}

Relief ConstructRelief(float arg0, float arg1, float arg2, float arg3) {
    Relief ret = (Relief)0;
    ret.shape = arg0;
    ret.strength = arg1;
    ret.greatest = arg2;
    ret.least = arg3;
    return ret;
}

Relief relief(float3 tensor_2, float slope_2)
{
    const float3 _e2 = tensor_safe(tensor_2);
    const float2 _e3 = principal_curvatures(_e2);
    const float _e10 = angle_of_point((_e3.x + _e3.y), (_e3.x - _e3.y));
    float curvedness = sqrt((0.5 * dot(_e3, _e3)));
    const float _e15 = bounded(slope_2);
    const float _e18 = curvature_signed(curvedness, max(_e15, 0.0));
    const Relief relief_1 = ConstructRelief((0.5 + (_e10 / PI)), _e18, _e3.x, _e3.y);
    return relief_1;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e5 = reflectance_half_lambert(_e3, surface_1.normal);
    const float _e10 = radiance_scaling(_e5, surface_1.kappa, 1.3, 0.03, 0.9);
    const float4 _e12 = ramp_oklab(_e10, terracotta);
    const Relief _e15 = relief(surface_1.curvature_tensor, 0.025);
    const float4 _e18 = ramp_oklab(_e15.shape, pits_to_bumps);
    const float4 _e20 = mix_colors_soft_light(_e12, _e18, _e15.strength);
    Light _e23 = look.sky;
    const float _e29 = rim(_e23, surface_1.normal, surface_1.view, 0.4, 0.9, 1.0);
    const float4 _e35 = mix_colors_screen(_e20, float4(0.3725, 0.498, 0.6588, 1.0), _e29);
    const float4 _e36 = premultiplied(_e35);
    const float4 _e37 = output(_e36);
    return _e37;
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
    float4 _e48 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.curvature_tensor = _e48.xyz;
    Surface _e50 = surface;
    const float4 _e51 = shade(_e50);
    const float4 _e52 = finite_vec4_(_e51);
    return _e52;
}
