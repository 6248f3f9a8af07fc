// Lantern: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1.
// lantern.json says what to put there and how to draw.
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

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
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
static const Ramp glow = ConstructRamp(Constructarray16_float4_(float4(0.851, 0.4118, 0.1647, 1.0), float4(1.0, 0.7804, 0.3961, 1.0), float4(1.0, 0.9647, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.45, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 3u, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_2 : LOC1;
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
    float clamped = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped);
    float f = ((clamped - whole) * LN_2_);
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

float footprint_of(float x_7)
{
    float _e1 = ddx(x_7);
    float _e2 = ddy(x_7);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_8, float edge, float w)
{
    const float _e4 = bounded((x_8 - edge));
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

float cube_root(float x_9)
{
    const float _e3 = powered(abs(x_9), 0.33333334);
    return ((x_9 < 0.0) ? -(_e3) : _e3);
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

float4 ends_kept(float4 a_4, float4 b_4, float t_3, float3 rgb_1)
{
    const float3 _e4 = bounded_vec3_(rgb_1);
    const float _e7 = mixed(a_4.w, b_4.w, t_3);
    float4 mixed_color = float4(_e4, _e7);
    const float4 _e9 = bounded_vec4_(b_4);
    const float4 _e13 = bounded_vec4_(a_4);
    return ((t_3 <= 0.0) ? _e13 : ((t_3 >= 1.0) ? _e9 : mixed_color));
}

float4 mixed_in_oklab(float4 a_5, float4 b_5, float t_4)
{
    const float3 _e4 = oklab_of_srgb(a_5.xyz);
    const float3 _e6 = oklab_of_srgb(b_5.xyz);
    const float3 _e7 = mixed_vec3_(_e4, _e6, t_4);
    const float3 _e8 = srgb_of_oklab(_e7);
    const float4 _e9 = ends_kept(a_5, b_5, t_4, _e8);
    return _e9;
}

float4 hermite(float4 a_6, float4 b_6, float4 from_a, float4 to_b, float t_5)
{
    float4 d_1 = (b_6 - a_6);
    return (a_6 + (t_5 * (from_a + (t_5 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_5 * ((from_a + to_b) - (2.0 * d_1))))))));
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

float4 ramp_at(Ramp ramp, float x_10, float w_1)
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
                const float _e43 = step_filtered(x_10, _e42, w_1);
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
            at = ((_e67 <= x_10) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = (x_10 <= place);
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
    const float _e108 = divided((x_10 - place), span_1);
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

RampPlace ramp_place(Ramp ramp_1, float x_11)
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
            at_1 = ((_e33 <= x_11) ? _e24 : _e23);
        }
    }
    uint _e39 = at_1;
    uint after_2 = min((_e39 + 1u), (count_1 - 1u));
    uint _e45 = at_1;
    uint _e49 = at_1;
    float place_1 = places_1[min(uint(naga_div(_e45, 4u)), 3u)][min(uint(naga_mod(_e49, 4u)), 3u)];
    float _e61 = places_1[min(uint(naga_div(after_2, 4u)), 3u)][min(uint(naga_mod(after_2, 4u)), 3u)];
    const float _e63 = divided((x_11 - place_1), (_e61 - place_1));
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

float facing(float3 normal, float3 view)
{
    const float3 _e4 = normalize_or(normal, (0.0).xxx);
    return clamp(dot(_e4, view), 0.0, 1.0);
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

float4 shade(Surface surface_1)
{
    const float _e3 = facing(surface_1.normal, surface_1.view);
    const float4 _e5 = ramp_oklab(_e3, glow);
    const float4 _e6 = premultiplied(_e5);
    const float4 _e7 = output(_e6);
    return _e7;
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

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_3 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_3;
    float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    float4 _e26 = view_1.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    const float4 _e35 = shade(_e34);
    const float4 _e36 = finite_vec4_(_e35);
    return _e36;
}
