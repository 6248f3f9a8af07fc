// Paper wash: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// paper-wash.json says what to put there and how to draw.
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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float2 pixel;
    int _pad2_0;
    int _pad2_1;
    float3 anchor;
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

static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const Ramp indigo_to_warm_paper = ConstructRamp(Constructarray16_float4_(float4(0.13, 0.14, 0.33, 1.0), float4(0.24, 0.36, 0.56, 1.0), float4(0.53, 0.66, 0.72, 1.0), float4(0.9, 0.8, 0.68, 1.0), float4(0.975, 0.95, 0.9, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.35, 0.62, 0.82), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 1u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 normal_1 : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 normal_2 : LOC0;
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

float log_stable(float x_2)
{
    uint bits = asuint(x_2);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent = ((shift >= int(256)) ? asint(asuint(shift) - asuint(int(512))) : shift);
    float mantissa = asfloat((bits - (uint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent) * LN_2_) + series);
}

float2 sin_cos_quarter(float x_3)
{
    float h = (0.5 * x_3);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

float2 sin_cos(float x_4)
{
    float turns = round((x_4 * 0.31830987));
    float r = (((x_4 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    const float2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
    return (sign_ * _e27);
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

float place_between(float x_6, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_6 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_6 - low) / _e12));
    return _e14;
}

float remapped(float x_7, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_7);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_8, float low_1, float high_1)
{
    const float _e3 = bounded(x_8);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float factor_of(float x_9, bool clamped_1)
{
    const float _e2 = bounded(x_9);
    const float _e3 = bounded(x_9);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float2 sin_cos_of(float x_10)
{
    const float _e1 = bounded(x_10);
    const float2 _e2 = sin_cos(_e1);
    return clamp(_e2, (-1.0).xx, (1.0).xx);
}

float footprint_of(float x_11)
{
    float _e1 = ddx(x_11);
    float _e2 = ddy(x_11);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness)
{
    const float _e4 = bounded(softness);
    return length(float2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_12, float edge, float w_1)
{
    const float _e4 = bounded((x_12 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float stairs_integral(float x_13, float count)
{
    float inside = clamp(x_13, 0.0, count);
    float stair = min(floor(inside), (count - 1.0));
    float beyond = max((x_13 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * (count - 1.0)));
}

float stairs_filtered(float x_14, float count_1, float w_2)
{
    if ((w_2 <= 1.0)) {
        float edge_1 = clamp(round(x_14), 1.0, (count_1 - 1.0));
        const float _e12 = step_filtered(x_14, edge_1, w_2);
        return ((edge_1 - 1.0) + _e12);
    }
    float half_ = (0.5 * min(w_2, (1000.0 * count_1)));
    const float _e20 = stairs_integral((x_14 + half_), count_1);
    const float _e22 = stairs_integral((x_14 - half_), count_1);
    return ((_e20 - _e22) / (2.0 * half_));
}

float stepped_tone(float value, float w_3, int count_2, float softness_1)
{
    float n_1 = float(clamp(count_2, int(2), int(1024)));
    const float _e11 = edge_width((n_1 * w_3), min(softness_1, 1.0));
    const float _e12 = bounded(value);
    const float _e17 = stairs_filtered((n_1 * clamp(_e12, 0.0, 1.0)), n_1, _e11);
    return clamp((_e17 / (n_1 - 1.0)), 0.0, 1.0);
}

float4 hermite(float4 a_4, float4 b_4, float4 from_a, float4 to_b, float t_3)
{
    float4 d_2 = (b_4 - a_4);
    return (a_4 + (t_3 * (from_a + (t_3 * ((((3.0 * d_2) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_2))))))));
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

float4 ramp_at(Ramp ramp, float x_15, float w_4)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_1 = (bool)0;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    uint count_6 = min(ramp.count, 16u);
    if ((count_6 == 0u)) {
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
            if ((_e22 < count_6)) {
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
                const float _e43 = step_filtered(x_15, _e42, w_4);
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
        if ((_e55 < count_6)) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places[min(uint(naga_div(_e59, 4u)), 3u)][min(uint(naga_mod(_e63, 4u)), 3u)];
            at = ((_e67 <= x_15) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_4 = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count_6))) {
        local_1 = (x_15 <= place_4);
    } else {
        local_1 = true;
    }
    bool _e91 = local_1;
    if (_e91) {
        uint _e92 = at;
        float4 _e94 = colors[min(uint(_e92), 15u)];
        const float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span_1 = (_e105 - place_4);
    const float _e108 = divided((x_15 - place_4), span_1);
    float t_6 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        float4 _e117 = colors[min(uint(_e115), 15u)];
        float4 _e119 = colors[min(uint(after_1), 15u)];
        const float4 _e120 = mixed_vec4_(_e117, _e119, t_6);
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
        const float4 _e159 = ramp_slope((_e145 - _e150), (place_4 - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count_6)) {
        float _e173 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e173 - (place_4 + span_1));
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
    const float4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_6);
    const float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

float unit_share(float share)
{
    return clamp(share, 0.0, 1.0);
}

float4 with_unit_alpha(float4 color_1)
{
    const float _e3 = unit_share(color_1.w);
    return float4(color_1.xyz, _e3);
}

float4 premultiplied(float4 color_2)
{
    return float4((color_2.xyz * color_2.w), color_2.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 output(float4 color_3)
{
    const float4 _e1 = straight(color_3);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float bands(float value_1, int count_3, float softness_2)
{
    const float _e3 = footprint_of(value_1);
    const float _e4 = stepped_tone(value_1, _e3, count_3, softness_2);
    return _e4;
}

float4 ramp_plain(float value_2, Ramp ramp_1)
{
    const float _e2 = footprint_of(value_2);
    const float _e3 = bounded(value_2);
    const float4 _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
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

float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod((hash.x >> 8u), 3u);
    float a_7 = ((axis == 0u) ? d.y : d.x);
    float b_7 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_7 : -(a_7)) + (((hash.z >> 31u) == 0u) ? b_7 : -(b_7)));
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
    int i_2 = int(0);

    float3 corner = floor(p);
    float3 d_3 = (p - corner);
    const float3 _e4 = fade_quintic(d_3);
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e46 = i_2;
            i_2 = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e10 = i_2;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_2;
            int _e16 = i_2;
            int _e21 = i_2;
            int3 at_2 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at_2 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at_2)), seed_2);
            const float _e42 = gradient_dot(_e39, (d_3 - float3(at_2)));
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

StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    const float2 _e4 = sin_cos_of(angle);
    const float3 _e10 = bounded_vec3_(((_e4.y * along) + (_e4.x * across)));
    const float3 _e16 = bounded_vec3_(((_e4.y * across) - (_e4.x * along)));
    const float2 _e17 = bounded_vec2_(place);
    float2 turned = float2(((_e4.y * _e17.x) + (_e4.x * _e17.y)), ((_e4.y * _e17.y) - (_e4.x * _e17.x)));
    float3 most = (1000000000000000.0).xxx;
    float3 stretch_3 = clamp(float3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    const float2 _e41 = bounded_vec2_(turned);
    const StretchedPlace stretchedplace = ConstructStretchedPlace(_e41, stretch_3);
    return stretchedplace;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_1, float3 stretch, float2 viewport_1, float count_4)
{
    const float _e4 = bounded(count_4);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    const float2 _e19 = bounded_vec2_(place_1);
    const float2 _e21 = bounded_vec2_((_e19 * scale_2));
    float2 p_1 = clamp(_e21, (-4194304.0).xx, (4194304.0).xx);
    const float3 _e27 = bounded_vec3_(stretch);
    float3 s_1 = clamp(_e27, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_1, (is_pixel ? float3(1.0, 0.0, 1.0) : s_1));
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

MarkPlace mark_place_object(float angle_1, float3 anchor, float2 pixel_1, float2 viewport_2)
{
    const float _e5 = bounded(anchor.z);
    float size = clamp(_e5, 1e-6, 1000000.0);
    const float2 _e9 = place_in_picture(pixel_1, viewport_2);
    const float2 _e15 = bounded_vec2_((_e9 - float2(anchor.x, -(anchor.y))));
    float2 place_5 = (_e15 / (size).xx);
    const StretchedPlace _e28 = mark_place_of(place_5, float3((1.0 / size), 0.0, 0.0), float3(0.0, (1.0 / size), 0.0), angle_1);
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

float paper_octave(float2 place_2, int zoom, float w_5, float fiber, uint seed_3)
{
    const float _e5 = power_of_two(zoom);
    float2 p_2 = clamp((place_2 * _e5), (-4194304.0).xx, (4194304.0).xx);
    uint own = (seed_3 + (7u * asuint(zoom)));
    const float _e18 = perlin_noise(float3(p_2, 0.5), own);
    float grain = (_e18 - 0.5);
    float2 q = clamp((2.7 * float2(((0.8 * p_2.x) - (0.6 * p_2.y)), ((0.6 * p_2.x) + (0.8 * p_2.y)))), (-4194304.0).xx, (4194304.0).xx);
    const float _e47 = perlin_noise(float3(q, 0.5), (own + 1u));
    float felt = (_e47 - 0.5);
    const float _e53 = eased((w_5 * _e5), 0.5, 1.0);
    float coarse_seen = (1.0 - _e53);
    const float _e61 = eased(((2.7 * w_5) * _e5), 0.5, 1.0);
    float felt_seen = (1.0 - _e61);
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(SpacedPlace at_1, float fiber_1, uint seed_4)
{
    float height_1 = (float)0;

    float2 x_16 = ddx(at_1.place);
    float2 y = ddy(at_1.place);
    const float _e11 = bounded(sqrt(max(dot(x_16, x_16), dot(y, y))));
    const float _e13 = area_square(at_1.stretch);
    const float _e15 = octave_of(sqrt(_e13));
    float zoom_1 = floor(_e15);
    float f = (_e15 - zoom_1);
    const float _e18 = bounded(fiber_1);
    float fine = clamp(_e18, 0.0, 1.0);
    const float _e24 = paper_octave(at_1.place, naga_f2i32(zoom_1), _e11, fine, seed_4);
    height_1 = _e24;
    if ((f > 0.0)) {
        float _e28 = height_1;
        const float _e33 = paper_octave(at_1.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), _e11, fine, seed_4);
        float both = lerp(_e28, _e33, f);
        height_1 = clamp((0.5 + ((both - 0.5) / sqrt(((f * f) + ((1.0 - f) * (1.0 - f)))))), 0.0, 1.0);
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

PaperGrain paper_grain(float value_3, float2 place_3, float3 stretch_2, float count_5, float tooth_1, float fiber_2, int seed_5, float2 viewport_3)
{
    const SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_5);
    const float _e10 = paper_height(_e8, fiber_2, asuint(seed_5));
    const float _e12 = factor_of(value_3, true);
    const float _e15 = caught_ink((1.0 - _e12), _e10, tooth_1);
    const PaperGrain papergrain = ConstructPaperGrain((1.0 - _e15), _e10);
    return papergrain;
}

float reflectance_wrap(Light light, float3 normal, float wrap)
{
    const float _e3 = bounded(wrap);
    float w_6 = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light.direction);
    return max(((cosine + w_6) / (1.0 + w_6)), 0.0);
}

float add(float a_5, float b_5)
{
    const float _e3 = bounded((a_5 + b_5));
    return _e3;
}

float map_range(float value_4, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2)
{
    const float _e6 = remapped(value_4, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float mix_values(float a_6, float b_6, float factor, bool clamped_3)
{
    const float _e4 = bounded(a_6);
    const float _e5 = bounded(b_6);
    const float _e6 = factor_of(factor, clamped_3);
    const float _e7 = mixed(_e4, _e5, _e6);
    return _e7;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.5);
    float2 _e12 = look.viewport;
    const MarkPlace _e13 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e12);
    float2 _e23 = look.viewport;
    const PaperGrain _e24 = paper_grain(0.5, _e13.place, _e13.stretch, 11.0, 0.0, 0.7, int(5), _e23);
    const float _e31 = map_range(_e24.height, 0.0, 1.0, -0.2, 0.2, true);
    const float _e32 = add(_e6, _e31);
    const float _e35 = bands(_e32, int(4), 0.22);
    const float _e38 = mix_values(_e35, _e32, 0.35, true);
    float2 _e47 = look.viewport;
    const PaperGrain _e48 = paper_grain(_e38, _e13.place, _e13.stretch, 260.0, 0.2, 0.6, int(0), _e47);
    const float4 _e51 = ramp_plain(_e48.tone, indigo_to_warm_paper);
    const float4 _e52 = with_unit_alpha(_e51);
    const float4 _e53 = premultiplied(_e52);
    const float4 _e54 = output(_e53);
    return _e54;
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

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_3 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_3;
    float4 _e17 = view.screen;
    float4 _e22 = view.screen;
    surface.pixel = ((in_.clip_.xy * _e17.xy) + _e22.zw);
    float4x4 _e28 = view.camera_from_world;
    float4 _e32 = object.world_from_object[3];
    float _e41 = view.eye.w;
    float _e46 = view.clip_from_world[0].y;
    float _e51 = view.clip_from_world[1].y;
    float _e56 = view.clip_from_world[2].y;
    const float3 _e59 = anchor_on_screen(mul(float4(_e32.xyz, 1.0), _e28).xyz, _e41, length(float3(_e46, _e51, _e56)));
    surface.anchor = _e59;
    Surface _e60 = surface;
    const float4 _e61 = shade(_e60);
    const float4 _e62 = finite_vec4_(_e61);
    return _e62;
}
