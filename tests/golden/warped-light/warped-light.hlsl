// Warped light: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_6 b0, object b1, look b2, curvature_tensor_map t0.
// warped-light.json says what to put there and how to draw.
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
    Light back;
    Light key;
    row_major float3x3 camera_from_world;
    int _end_pad_0;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
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

struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
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

static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const Ramp jade = ConstructRamp(Constructarray16_float4_(float4(0.0157, 0.1294, 0.1216, 1.0), float4(0.0588, 0.3529, 0.298, 1.0), float4(0.2471, 0.6275, 0.4784, 1.0), float4(0.7137, 0.8784, 0.6902, 1.0), float4(0.9333, 0.9725, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.35, 0.65, 0.9), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 0u);

cbuffer view_6 : register(b0) { View view_6; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_6 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_7 : LOC1;
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

float bounded(float x_4)
{
    uint bits_1 = asuint(x_4);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_4 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    const float _e6 = bounded(v_3.z);
    return float3(_e2, _e4, _e6);
}

float4 bounded_vec4_(float4 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    const float _e8 = bounded(v_4.w);
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

float place_between(float x_5, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_5 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_5 - low) / _e12));
    return _e14;
}

float eased(float x_6, float low_1, float high_1)
{
    const float _e3 = bounded(x_6);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_6 = clamp(_e6, 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float factor_of(float x_7, bool clamped)
{
    const float _e2 = bounded(x_7);
    const float _e3 = bounded(x_7);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_8)
{
    float _e1 = ddx(x_8);
    float _e2 = ddy(x_8);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_9, float edge, float w)
{
    const float _e4 = bounded((x_9 - edge));
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

float4 color_mixed(float4 a_4, float3 blended, float factor)
{
    const float3 _e4 = bounded_vec3_(a_4.xyz);
    const float3 _e5 = bounded_vec3_(blended);
    const float _e7 = factor_of(factor, true);
    const float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    const float _e10 = bounded(a_4.w);
    return float4(_e8, _e10);
}

float cube_root(float x_10)
{
    const float _e3 = powered(abs(x_10), 0.33333334);
    return ((x_10 < 0.0) ? -(_e3) : _e3);
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

float4 ends_kept(float4 a_5, float4 b_4, float t_3, float3 rgb_1)
{
    const float3 _e4 = bounded_vec3_(rgb_1);
    const float _e7 = mixed(a_5.w, b_4.w, t_3);
    float4 mixed_color = float4(_e4, _e7);
    const float4 _e9 = bounded_vec4_(b_4);
    const float4 _e13 = bounded_vec4_(a_5);
    return ((t_3 <= 0.0) ? _e13 : ((t_3 >= 1.0) ? _e9 : mixed_color));
}

float4 mixed_in_oklab(float4 a_6, float4 b_5, float t_4)
{
    const float3 _e4 = oklab_of_srgb(a_6.xyz);
    const float3 _e6 = oklab_of_srgb(b_5.xyz);
    const float3 _e7 = mixed_vec3_(_e4, _e6, t_4);
    const float3 _e8 = srgb_of_oklab(_e7);
    const float4 _e9 = ends_kept(a_6, b_5, t_4, _e8);
    return _e9;
}

float4 hermite(float4 a_7, float4 b_6, float4 from_a, float4 to_b, float t_5)
{
    float4 d_1 = (b_6 - a_7);
    return (a_7 + (t_5 * (from_a + (t_5 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_5 * ((from_a + to_b) - (2.0 * d_1))))))));
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

float4 ramp_at(Ramp ramp, float x_11, float w_1)
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
                const float _e43 = step_filtered(x_11, _e42, w_1);
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
            at = ((_e67 <= x_11) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = (x_11 <= place_1);
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
    float span_1 = (_e105 - place_1);
    const float _e108 = divided((x_11 - place_1), span_1);
    float t_7 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        float4 _e117 = colors[min(uint(_e115), 15u)];
        float4 _e119 = colors[min(uint(after_1), 15u)];
        const float4 _e120 = mixed_vec4_(_e117, _e119, t_7);
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
        const float4 _e159 = ramp_slope((_e145 - _e150), (place_1 - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count)) {
        float _e173 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e173 - (place_1 + span_1));
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
    const float4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_7);
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

RampPlace ramp_place(Ramp ramp_1, float x_12)
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
            at_1 = ((_e33 <= x_12) ? _e24 : _e23);
        }
    }
    uint _e39 = at_1;
    uint after_2 = min((_e39 + 1u), (count_1 - 1u));
    uint _e45 = at_1;
    uint _e49 = at_1;
    float place_2 = places_1[min(uint(naga_div(_e45, 4u)), 3u)][min(uint(naga_mod(_e49, 4u)), 3u)];
    float _e61 = places_1[min(uint(naga_div(after_2, 4u)), 3u)][min(uint(naga_mod(after_2, 4u)), 3u)];
    const float _e63 = divided((x_12 - place_2), (_e61 - place_2));
    float t_8 = clamp(_e63, 0.0, 1.0);
    uint _e67 = at_1;
    float4 _e69 = colors_1[min(uint(_e67), 15u)];
    float4 _e71 = colors_1[min(uint(after_2), 15u)];
    const float _e74 = eased(t_8, 0.0, 1.0);
    const RampPlace rampplace_1 = ConstructRampPlace(_e69, _e71, ((ramp_1.interpolation == INTERPOLATION_SMOOTH) ? _e74 : t_8));
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

float4 mix_colors_screen(float4 a_8, float4 b_7, float factor_1)
{
    const float4 _e10 = color_mixed(a_8, ((a_8.xyz + b_7.xyz) - (a_8.xyz * b_7.xyz)), factor_1);
    return _e10;
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
    float a_10 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_2 = min(abs(a_10), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_10 * a_10);
        return (a_10 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_2));
    float t_9 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_10 >= 0.0) ? t_9 : -(t_9));
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

float3 half_of(float3 light_1, float3 normal, float3 view)
{
    float3 half_ = (light_1 + view);
    const float3 _e8 = normalize_or(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(float3 a_9, float3 b_8)
{
    float3 across = cross(a_9, b_8);
    return min(dot(across, across), 1.0);
}

Reflection ConstructReflection(float arg0, float arg1, float arg2, float arg3, float arg4) {
    Reflection ret = (Reflection)0;
    ret.n_l = arg0;
    ret.n_v = arg1;
    ret.n_h = arg2;
    ret.v_h = arg3;
    ret.sine2_ = arg4;
    return ret;
}

Reflection reflection_of(float3 light_2, float3 normal_1, float3 view_1)
{
    const float3 _e3 = half_of(light_2, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    const float _e14 = sine_squared(normal_1, _e3);
    const Reflection reflection = ConstructReflection(dot(normal_1, light_2), dot(normal_1, view_1), n_h, v_h, _e14);
    return reflection;
}

float width_of_roughness(float roughness)
{
    const float _e1 = bounded(roughness);
    float r_1 = clamp(_e1, 0.0, 1.0);
    return max((r_1 * r_1), 0.001);
}

float schlick(float at_normal, float cosine)
{
    float m_1 = clamp((1.0 - cosine), 0.0, 1.0);
    float m2_ = (m_1 * m_1);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m_1)));
}

float ggx(Reflection r, float width, float at_normal_1)
{
    bool local_3 = (bool)0;

    if (!((r.n_l <= 0.0))) {
        local_3 = (r.n_v <= 0.0);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return 0.0;
    }
    float a2_1 = (width * width);
    float bottom = max((r.sine2_ + ((a2_1 * r.n_h) * r.n_h)), 1e-12);
    float distribution = (a2_1 / (bottom * bottom));
    float toward_light = (r.n_v * sqrt((((r.n_l * r.n_l) * (1.0 - a2_1)) + a2_1)));
    float toward_eye = (r.n_l * sqrt((((r.n_v * r.n_v) * (1.0 - a2_1)) + a2_1)));
    float visibility = (0.5 / max((toward_light + toward_eye), 1e-9));
    const float _e53 = schlick(at_normal_1, r.v_h);
    return min((((distribution * visibility) * _e53) * r.n_l), 1000000.0);
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

float reflectance_wrap(Light light_3, float3 normal_2, float wrap)
{
    const float _e3 = bounded(wrap);
    float w_2 = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    float cosine_1 = dot(_e11, light_3.direction);
    return max(((cosine_1 + w_2) / (1.0 + w_2)), 0.0);
}

float reflectance_ggx(Light light_4, float3 normal_3, float3 view_2, float roughness_1, float at_normal_2)
{
    const float3 _e10 = normalize_or(normal_3, float3(0.0, 0.0, 1.0));
    const Reflection _e11 = reflection_of(light_4.direction, _e10, view_2);
    const float _e12 = width_of_roughness(roughness_1);
    const float _e13 = bounded(at_normal_2);
    const float _e17 = ggx(_e11, _e12, clamp(_e13, 0.0, 1.0));
    return _e17;
}

float rim(Light light_5, float3 normal_4, float3 view_3, float width_1, float softness, float follow)
{
    const float3 _e10 = normalize_or(normal_4, float3(0.0, 0.0, 1.0));
    float facing_1 = clamp(dot(_e10, view_3), 0.0, 1.0);
    const float _e16 = factor_of(width_1, true);
    const float _e18 = factor_of(softness, true);
    const float _e20 = footprint_of(facing_1);
    float edge_1 = max((_e16 * _e18), min(_e20, 1.0));
    float3 aside = (_e10 - view_3);
    float further = ((facing_1 > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1));
    float within = ((further / max(edge_1, 1e-6)) + ((softness > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    float3 across_1 = (light_5.direction - (dot(light_5.direction, view_3) * view_3));
    const float3 _e61 = normalize_or(across_1, (0.0).xxx);
    float side = dot((_e10 - (dot(_e10, view_3) * view_3)), _e61);
    const float _e66 = eased(side, 0.0, 0.5);
    const float _e68 = factor_of(follow, true);
    const float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float2 warped_place(float3 tensor_2, float2 place, float amount, float slope_1)
{
    const float2 _e4 = principal_curvatures(tensor_2);
    const float _e7 = curvature_signed(_e4.x, slope_1);
    const float _e9 = exp2_stable((-(amount) * _e7));
    const float _e12 = curvature_signed(_e4.y, slope_1);
    const float _e14 = exp2_stable((-(amount) * _e12));
    float2 half_apart = float2((0.5 * (tensor_2.x - tensor_2.z)), tensor_2.y);
    float2 axes = (half_apart / (max(length(half_apart), 1e-20)).xx);
    float2 turned = float2(((axes.x * place.x) + (axes.y * place.y)), ((axes.y * place.x) - (axes.x * place.y)));
    return (((0.5 * (_e9 + _e14)) * place) + ((0.5 * (_e9 - _e14)) * turned));
}

float3 warped_light(float3 light_6, float3 n_1, float3 view_4, float3x3 camera_from_world, float3 tensor_3, float amount_1, float slope_2)
{
    float3 right = mul(camera_from_world, float3(1.0, 0.0, 0.0));
    const float3 _e19 = normalize_or((right - (dot(right, view_4) * view_4)), float3(1.0, 0.0, 0.0));
    float3 y = cross(view_4, _e19);
    float3 between = ((view_4 + n_1) / (max((1.0 + dot(view_4, n_1)), 0.01)).xxx);
    float3 along_x = (_e19 - (dot(n_1, _e19) * between));
    float3 along_y = (y - (dot(n_1, y) * between));
    float2 place_3 = (float2(dot(light_6, along_x), dot(light_6, along_y)) / (max((1.0 + dot(light_6, n_1)), 0.0001)).xx);
    const float2 _e45 = warped_place(tensor_3, place_3, amount_1, slope_2);
    float square_1 = dot(_e45, _e45);
    const float3 _e60 = normalize_or(((((2.0 * _e45.x) * along_x) + ((2.0 * _e45.y) * along_y)) + ((1.0 - square_1) * n_1)), light_6);
    return _e60;
}

float seen_well(float facing)
{
    const float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light light_warp(Light light_7, float3 normal_5, float amount_2, float slope_3, float3 tensor_4, float3 view_5, float3x3 camera_from_world_1)
{
    bool local_4 = (bool)0;

    const float3 _e7 = normalize_or(normal_5, view_5);
    const float _e8 = bounded(amount_2);
    const float _e13 = seen_well(dot(_e7, view_5));
    float most = (clamp(_e8, -8.0, 8.0) * _e13);
    const float3 _e16 = tensor_safe(tensor_4);
    const float3 _e17 = warped_light(light_7.direction, _e7, view_5, camera_from_world_1, _e16, most, slope_3);
    if (!((most == 0.0))) {
        local_4 = (slope_3 == 0.0);
    } else {
        local_4 = true;
    }
    bool is_flat = local_4;
    const Light light_8 = ConstructLight((is_flat ? light_7.direction : _e17), light_7.own_direction, light_7.color, light_7.intensity);
    return light_8;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    float3x3 _e11 = look.camera_from_world;
    const Light _e12 = light_warp(_e3, surface_1.normal, 1.4, 0.03, surface_1.curvature_tensor, surface_1.view, _e11);
    const float _e15 = reflectance_wrap(_e12, surface_1.normal, 0.6);
    const float4 _e17 = ramp_oklab(_e15, jade);
    const float _e22 = reflectance_ggx(_e12, surface_1.normal, surface_1.view, 0.42, 0.09);
    const float4 _e28 = mix_colors_screen(_e17, float4(1.0, 0.9569, 0.8627, 1.0), _e22);
    Light _e31 = look.back;
    const float _e37 = rim(_e31, surface_1.normal, surface_1.view, 0.5, 0.8, 1.0);
    const float4 _e43 = mix_colors_screen(_e28, float4(0.1843, 0.5608, 0.7216, 1.0), _e37);
    const float4 _e44 = premultiplied(_e43);
    const float4 _e45 = output(_e44);
    return _e45;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_6.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_7 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_8 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_8;
    float4 _e15 = view_6.eye;
    float _e20 = view_6.eye.w;
    float4 _e26 = view_6.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    float4 _e40 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.curvature_tensor = _e40.xyz;
    Surface _e42 = surface;
    const float4 _e43 = shade(_e42);
    const float4 _e44 = finite_vec4_(_e43);
    return _e44;
}
