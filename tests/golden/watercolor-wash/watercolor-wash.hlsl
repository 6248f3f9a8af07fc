// Watercolor wash: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// watercolor-wash.json says what to put there and how to draw.
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
    float3 view;
    int _pad2_0;
    float3 position_object;
    int _pad3_0;
    float2 pixel;
    int _pad4_0;
    int _pad4_1;
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
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint NOISE_PERLIN = 1u;
static const float MOST_ON_SCREEN = 1000000000000000.0;
static const Ramp two_pigments = ConstructRamp(Constructarray16_float4_(float4(0.1843, 0.4353, 0.5608, 1.0), float4(0.2471, 0.6039, 0.5255, 1.0), float4(0.7882, 0.6353, 0.2353, 1.0), float4(0.8471, 0.451, 0.3529, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.45, 0.75, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 4u, 1u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_2 : LOC0;
    float3 position_object : LOC1;
    float3 normal_1 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_3 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float4 finite_vec4_(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return (((asuint(v) & exponent) != exponent) ? v : (0.0).xxxx);
}

float log2_stable(float x)
{
    uint bits = asuint(x);
    int exponent_1 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float3 normalize_moderate(float3 v_1, float3 otherwise)
{
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen(float3 v_2)
{
    const float3 _e5 = normalize_moderate(v_2, float3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x_1)
{
    uint bits_1 = asuint(x_1);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    uint3 bits_2 = asuint(v_3);
    uint3 magnitude_1 = (bits_2 & (2147483647u).xxx);
    float3 largest_1 = asfloat(((bits_2 & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers = ((magnitude_1 == (2139095040u).xxx) ? largest_1 : (0.0).xxx);
    return ((magnitude_1 < (2139095040u).xxx) ? v_3 : numbers);
}

float4 bounded_vec4_(float4 v_4)
{
    uint4 bits_3 = asuint(v_4);
    uint4 magnitude_2 = (bits_3 & (2147483647u).xxxx);
    float4 largest_2 = asfloat(((bits_3 & (2147483648u).xxxx) | (2139095039u).xxxx));
    float4 numbers_1 = ((magnitude_2 == (2139095040u).xxxx) ? largest_2 : (0.0).xxxx);
    return ((magnitude_2 < (2139095040u).xxxx) ? v_4 : numbers_1);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float3 mixed_vec3_(float3 a_1, float3 b_1, float t)
{
    const float3 _e4 = bounded_vec3_((b_1 - a_1));
    const float3 _e14 = bounded_vec3_(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

float3 mixed_vec3_2_(float3 a_2, float3 b_2, float t_1)
{
    float3 d_1 = (b_2 - a_2);
    const float3 _e13 = bounded_vec3_(((t_1 < 0.5) ? (a_2 + (t_1 * d_1)) : (b_2 - ((1.0 - t_1) * d_1))));
    return _e13;
}

float4 mixed_vec4_(float4 a_3, float4 b_3, float t_2)
{
    const float4 _e4 = bounded_vec4_((b_3 - a_3));
    const float4 _e14 = bounded_vec4_(((t_2 < 0.5) ? (a_3 + (t_2 * _e4)) : (b_3 - ((1.0 - t_2) * _e4))));
    return _e14;
}

float eased(float x_2, float low, float high)
{
    const float _e3 = bounded(x_2);
    const float _e7 = bounded(((_e3 - low) / 0.5));
    float t_5 = clamp(_e7, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float eased_2_(float x_3, float low_1, float high_1)
{
    float t_6 = clamp(((x_3 - low_1) / (high_1 - low_1)), 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float footprint_of(float x_4)
{
    float _e1 = ddx(x_4);
    float _e2 = ddy(x_4);
    float2 d_2 = float2(_e1, _e2);
    return sqrt(dot(d_2, d_2));
}

float footprint_of_vec3_(float3 v_5)
{
    float3 dx = ddx(v_5);
    float3 dy = ddy(v_5);
    const float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

float4 color_mixed(float4 a_4, float3 blended, float factor)
{
    const float3 _e4 = bounded_vec3_(a_4.xyz);
    const float3 _e5 = bounded_vec3_(blended);
    const float3 _e7 = bounded_vec3_((_e5 - _e4));
    const float3 _e10 = bounded_vec3_((_e4 + (factor * _e7)));
    return float4(_e10, 1.0);
}

float4 hermite(float4 a_5, float4 b_4, float4 from_a, float4 to_b, float t_3)
{
    float4 d_3 = (b_4 - a_5);
    return (a_5 + (t_3 * (from_a + (t_3 * ((((3.0 * d_3) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_3))))))));
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

float4 ramp_at(Ramp ramp, float x_5, float w)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    uint i_2_ = 1u;
    uint at = 0u;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e25 = i_2_;
            i_2_ = (_e25 + 1u);
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 4u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e18 = i_2_;
        float _e22 = places[0][min(uint(naga_mod(_e18, 4u)), 3u)];
        at = ((_e22 <= x_5) ? _e16 : _e15);
    }
    uint _e29 = at;
    float place_4 = places[0][min(uint(naga_mod(_e29, 4u)), 3u)];
    uint _e34 = at;
    if ((((_e34 + 1u) >= 4u) | (x_5 <= place_4))) {
        uint _e41 = at;
        float4 _e43 = colors[min(uint(_e41), 15u)];
        return _e43;
    }
    uint _e44 = at;
    uint after_1 = (_e44 + 1u);
    float _e53 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span = (_e53 - place_4);
    const float _e56 = divided((x_5 - place_4), span);
    float t_7 = clamp(_e56, 0.0, 1.0);
    uint _e63 = at;
    if ((_e63 > 0u)) {
        uint _e66 = at;
        uint _e72 = at;
        float before_1 = places[min(uint(naga_div((_e66 - 1u), 4u)), 3u)][min(uint(naga_mod((_e72 - 1u), 4u)), 3u)];
        uint _e79 = at;
        float4 _e81 = colors[min(uint(_e79), 15u)];
        uint _e82 = at;
        float4 _e86 = colors[min(uint((_e82 - 1u)), 15u)];
        float4 _e90 = colors[min(uint(after_1), 15u)];
        uint _e91 = at;
        float4 _e93 = colors[min(uint(_e91), 15u)];
        const float4 _e95 = ramp_slope((_e81 - _e86), (place_4 - before_1), (_e90 - _e93), span);
        from_a_1 = _e95;
    }
    if (((after_1 + 1u) < 4u)) {
        float _e113 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e113 - (place_4 + span));
        float4 _e117 = colors[min(uint(after_1), 15u)];
        uint _e118 = at;
        float4 _e120 = colors[min(uint(_e118), 15u)];
        float4 _e125 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e127 = colors[min(uint(after_1), 15u)];
        const float4 _e129 = ramp_slope((_e117 - _e120), span, (_e125 - _e127), next);
        to_b_1 = _e129;
    }
    uint _e130 = at;
    float4 _e132 = colors[min(uint(_e130), 15u)];
    float4 _e134 = colors[min(uint(after_1), 15u)];
    float4 _e135 = from_a_1;
    float4 _e137 = to_b_1;
    const float4 _e139 = hermite(_e132, _e134, (span * _e135), (span * _e137), t_7);
    const float4 _e140 = bounded_vec4_(_e139);
    return _e140;
}

float4 mix_colors_multiply(float4 a_6, float4 b_5, float factor_1)
{
    const float3 _e7 = mixed_vec3_2_(a_6.xyz, (a_6.xyz * b_5.xyz), factor_1);
    return float4(_e7, 1.0);
}

float4 mix_colors_multiply_2_(float4 a_7, float4 b_6, float factor_2)
{
    float3 blended_1 = (a_7.xyz * b_6.xyz);
    const float3 _e7 = bounded_vec3_(a_7.xyz);
    const float3 _e9 = bounded_vec3_((blended_1 - _e7));
    const float _e14 = bounded(a_7.w);
    return float4((blended_1 - (0.25 * _e9)), _e14);
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
    float a_8 = ((axis == 0u) ? d.y : d.x);
    float b_7 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_8 : -(a_8)) + (((hash.z >> 31u) == 0u) ? b_7 : -(b_7)));
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
    float3 d_4 = (p - corner);
    const float3 _e4 = fade_quintic(d_4);
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e46 = i;
            i = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e10 = i;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            int3 at_2 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at_2 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at_2)), seed_2);
            const float _e42 = gradient_dot(_e39, (d_4 - float3(at_2)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float perlin_noise_2_(float3 p_1, uint seed_3)
{
    int i_1 = int(0);
    float sum_1 = 0.0;

    float3 corner_1 = floor(p_1);
    float3 d_5 = (p_1 - corner_1);
    float3 f = (((d_5 * d_5) * d_5) * ((d_5 * ((d_5 * 6.0) - (15.0).xxx)) + (10.0).xxx));
    int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e64 = i_1;
            i_1 = asint(asuint(_e64) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e21 = i_1;
        if (!((_e21 < int(8)))) {
            break;
        }
        int _e25 = i_1;
        int _e28 = i_1;
        int _e33 = i_1;
        int3 at_3 = int3((_e25 & int(1)), ((_e28 >> 1u) & int(1)), (_e33 >> 2u));
        float3 weight_1 = ((at_3 == (int(1)).xxx) ? f : ((1.0).xxx - f));
        float _e44 = sum_1;
        const uint3 _e58 = hash_pcg3d((asuint(asint(asuint(cell_2) + asuint(at_3))) + (seed_3 * uint3(2654435769u, 2246822507u, 3266489909u))));
        const float _e61 = gradient_dot(_e58, (d_5 - float3(at_3)));
        sum_1 = (_e44 + (((weight_1.x * weight_1.y) * 0.5) * _e61));
    }
    float _e67 = sum_1;
    return clamp((0.5 + (0.48244 * _e67)), 0.0, 1.0);
}

float fractal_noise(uint kind, float3 p_2, int octaves, float roughness, int seed_4, float w_1)
{
    float octave = (float)0;
    int i_2 = int(0);
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_2 = 0.0;

    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e66 = i_2;
            i_2 = asint(asuint(_e66) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e17 = i_2;
        if (!((_e17 < int(2)))) {
            break;
        }
        float _e21 = frequency;
        const float _e25 = eased((w_1 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_2;
            float3 place_5 = clamp(((p_2 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_2;
            const float _e50 = perlin_noise(place_5, (11u + uint(_e47)));
            octave = lerp(0.5, _e50, visible);
        }
        float _e53 = sum_2;
        float _e54 = strength;
        float _e55 = octave;
        sum_2 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * roughness);
        float _e63 = frequency;
        frequency = (_e63 * 2.0);
    }
    float _e69 = sum_2;
    return min((_e69 / 1.5), 1.0);
}

float fractal_noise_2_(uint kind_1, float3 p_3, int octaves_1, float roughness_1, int seed_5, float w_2)
{
    float octave_1 = (float)0;
    int i_3 = int(0);
    float frequency_1 = 1.0;
    float strength_1 = 1.0;
    float total_1 = 0.0;
    float sum_3 = 0.0;

    uint2 loop_bound_4 = uint2(4294967295u, 4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (all(loop_bound_4 == uint2(0u, 0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e66 = i_3;
            i_3 = asint(asuint(_e66) + asuint(int(1)));
        }
        loop_init_4 = false;
        int _e17 = i_3;
        if (!((_e17 < int(4)))) {
            break;
        }
        float _e21 = frequency_1;
        const float _e25 = eased((w_2 * _e21), 0.5, 1.0);
        float visible_1 = (1.0 - _e25);
        octave_1 = 0.5;
        if ((visible_1 > 0.0)) {
            float _e31 = frequency_1;
            int _e33 = i_3;
            float3 place_6 = clamp(((p_3 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_3;
            const float _e50 = perlin_noise(place_6, (0u + uint(_e47)));
            octave_1 = lerp(0.5, _e50, visible_1);
        }
        float _e53 = sum_3;
        float _e54 = strength_1;
        float _e55 = octave_1;
        sum_3 = (_e53 + (_e54 * _e55));
        float _e58 = total_1;
        float _e59 = strength_1;
        total_1 = (_e58 + _e59);
        float _e61 = strength_1;
        strength_1 = (_e61 * roughness_1);
        float _e63 = frequency_1;
        frequency_1 = (_e63 * 2.0);
    }
    float _e69 = sum_3;
    float _e70 = total_1;
    return min((_e69 / _e70), 1.0);
}

float size_on_screen(float depth, float perspective, float scale)
{
    return min(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

float3 anchor_on_screen(float3 origin, float perspective_1, float scale_1)
{
    const float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return clamp(float3((origin.x * _e5), (-(origin.y) * _e5), _e5), (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
}

float2 place_in_picture(float2 pixel, float2 viewport)
{
    float2 from_middle = (pixel - (0.5 * viewport));
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
    float2 turn = float2(0.0, 1.0);
    float3 x_6 = ((turn.y * along) + (turn.x * across));
    float3 y = ((turn.y * across) - (turn.x * along));
    float2 turned = float2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    float3 stretch_3 = float3(dot(x_6, x_6), dot(x_6, y), dot(y, y));
    const StretchedPlace stretchedplace = ConstructStretchedPlace(turned, stretch_3);
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
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_4 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    float2 p_4 = clamp((place_1 * scale_4), (-4194304.0).xx, (4194304.0).xx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_4, (is_pixel ? float3(1.0, 0.0, 1.0) : stretch));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum_4 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_4 * sum_4) / 66.0));
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_object(float angle_1, float3 anchor, float2 pixel_1, float2 viewport_2)
{
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    const float2 _e8 = place_in_picture(pixel_1, viewport_2);
    float2 place_7 = ((_e8 - float2(anchor.x, -(anchor.y))) / (size).xx);
    const StretchedPlace _e26 = mark_place_of(place_7, float3((1.0 / size), 0.0, 0.0), float3(0.0, (1.0 / size), 0.0), angle_1);
    const MarkPlace markplace = ConstructMarkPlace(_e26.place, _e26.stretch);
    return markplace;
}

float paper_octave(float2 place_2, int zoom, float w_3, float fiber, uint seed_6)
{
    float scale_5 = asfloat((uint(asint(asuint(zoom) + asuint(int(127)))) << 23u));
    float2 p_5 = clamp((place_2 * scale_5), (-4194304.0).xx, (4194304.0).xx);
    uint own = (seed_6 + (7u * asuint(zoom)));
    const float _e23 = perlin_noise_2_(float3(p_5, 0.5), own);
    float grain = (_e23 - 0.5);
    float2 q = clamp((2.7 * float2(((0.8 * p_5.x) - (0.6 * p_5.y)), ((0.6 * p_5.x) + (0.8 * p_5.y)))), (-4194304.0).xx, (4194304.0).xx);
    const float _e52 = perlin_noise_2_(float3(q, 0.5), (own + 1u));
    float felt = (_e52 - 0.5);
    float coarse_seen = (1.0 - smoothstep(0.5, 1.0, (w_3 * scale_5)));
    float felt_seen = (1.0 - smoothstep(0.5, 1.0, ((2.7 * w_3) * scale_5)));
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(SpacedPlace at_1, float fiber_1, uint seed_7)
{
    float height = (float)0;

    float2 x_7 = ddx(at_1.place);
    float2 y_1 = ddy(at_1.place);
    float w_4 = sqrt(max(dot(x_7, x_7), dot(y_1, y_1)));
    const float _e12 = area_square(at_1.stretch);
    const float _e16 = log2_stable(max(sqrt(_e12), 1e-30));
    float level = clamp((-0.5 * _e16), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    const float _e26 = paper_octave(at_1.place, naga_f2i32(zoom_1), w_4, fiber_1, seed_7);
    height = _e26;
    if ((f_1 > 0.0)) {
        float _e30 = height;
        const float _e35 = paper_octave(at_1.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), w_4, fiber_1, seed_7);
        float both = lerp(_e30, _e35, f_1);
        height = clamp((0.5 + ((both - 0.5) / sqrt(((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))))), 0.0, 1.0);
    }
    float _e53 = height;
    return _e53;
}

PaperGrain ConstructPaperGrain(float arg0, float arg1) {
    PaperGrain ret = (PaperGrain)0;
    ret.tone = arg0;
    ret.height = arg1;
    return ret;
}

PaperGrain paper_grain(float value, float2 place_3, float3 stretch_2, float count_1, float tooth, float fiber_2, int seed_8, float2 viewport_3)
{
    const SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    const float _e10 = paper_height(_e8, fiber_2, 0u);
    const PaperGrain papergrain = ConstructPaperGrain((1.0 - clamp((0.5 + ((((8.0 * tooth) * (_e10 - 0.5)) * 0.5) * 0.5)), 0.0, 1.0)), _e10);
    return papergrain;
}

float outer_contour(float width, float3 normal, float3 view, float2 viewport_4)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport_4.y, 1.0, 100000.0)) / 1000.0);
    const float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

float noise_perlin(float3 position, float scale_2, int octaves_2, float roughness_2, int seed_9)
{
    float3 p_6 = (position * scale_2);
    const float _e7 = footprint_of_vec3_(p_6);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_6, octaves_2, roughness_2, seed_9, _e7);
    return _e8;
}

float noise_perlin_2_(float3 position_1, float scale_3, int octaves_3, float roughness_3, int seed_10)
{
    float3 p_7 = (position_1 * scale_3);
    const float _e7 = footprint_of_vec3_(p_7);
    const float _e8 = fractal_noise_2_(NOISE_PERLIN, p_7, octaves_3, roughness_3, seed_10, _e7);
    return _e8;
}

float4 shade(Surface surface)
{
    const float _e6 = noise_perlin(surface.position_object, 1.5, int(2), 0.5, int(11));
    float spread = clamp(((_e6 - 0.32) / 0.36), 0.0, 1.0);
    const float _e15 = footprint_of(spread);
    const float4 _e16 = ramp_at(two_pigments, spread, _e15);
    float3 _e21 = look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e21) + 0.45) / 1.45), 0.0);
    float tone = min(((shade_2_ - 0.0) / 0.85), 1.0);
    const float _e40 = noise_perlin_2_(surface.position_object, 2.2, int(4), 0.55, int(0));
    float how_far_it_runs = lerp(-0.24, 0.24, (_e40 - 0.0));
    float wet_tone = (tone + how_far_it_runs);
    const float _e49 = eased_2_(wet_tone, 0.82, 0.7);
    float k1_ = (_e49 * 0.62);
    const float4 _e57 = mix_colors_multiply(float4(0.9843, 0.9686, 0.9255, 1.0), _e16, k1_);
    const float4 _e64 = mix_colors_multiply_2_(_e16, float4(0.3529, 0.3098, 0.5255, 1.0), 0.75);
    const float _e67 = eased_2_(wet_tone, 0.42, 0.34);
    float k2_ = (_e67 * 0.6);
    const float3 _e71 = bounded_vec3_(_e57.xyz);
    const float3 _e75 = bounded_vec3_((_e57.xyz * _e64.xyz));
    const float3 _e76 = mixed_vec3_(_e71, _e75, k2_);
    float4 second_on_the_first = float4(_e76, 1.0);
    float pigment_s_rim = (smoothstep(0.66, 0.72, wet_tone) * _e49);
    float second_rim = (smoothstep(0.29, 0.34, wet_tone) * _e67);
    float k3_ = (max(pigment_s_rim, second_rim) * 0.34);
    const float4 _e93 = color_mixed(second_on_the_first, (second_on_the_first.xyz * _e64.xyz), k3_);
    float2 _e99 = look.viewport;
    const MarkPlace _e100 = mark_place_object(0.0, surface.anchor, surface.pixel, _e99);
    float2 _e110 = look.viewport;
    const PaperGrain _e111 = paper_grain(0.5, _e100.place, _e100.stretch, 240.0, 0.6, 0.6, int(0), _e110);
    const float _e113 = bounded(_e111.tone);
    float settled_pigment = lerp(0.9, 1.03, (_e113 - 0.0));
    const float4 _e123 = bounded_vec4_((_e93 * float4((settled_pigment).xxx, 1.0)));
    float2 _e129 = look.viewport;
    const float _e130 = outer_contour(2.2, surface.normal, surface.view, _e129);
    float soft = (_e130 * 0.7);
    const float4 _e133 = bounded_vec4_(_e123);
    const float4 _e139 = mixed_vec4_(_e133, float4(0.2902, 0.2588, 0.2824, 1.0), soft);
    const float4 _e140 = finite_vec4_(_e139);
    return _e140;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2, float3 arg3) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.position_object = arg2;
    ret.normal = arg3;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_1.clip_from_world;
    float3x3 _e16 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float2 arg3, float3 arg4) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    ret.pixel = arg3;
    ret.anchor = arg4;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_3, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e23 = view_1.screen;
    float4 _e28 = view_1.screen;
    float4x4 _e33 = view_1.camera_from_world;
    float4 _e37 = object.world_from_object[3];
    float _e46 = view_1.eye.w;
    float _e51 = view_1.clip_from_world[0].y;
    float _e56 = view_1.clip_from_world[1].y;
    float _e61 = view_1.clip_from_world[2].y;
    const float3 _e64 = anchor_on_screen(mul(float4(_e37.xyz, 1.0), _e33).xyz, _e46, length(float3(_e51, _e56, _e61)));
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, ((in_.clip_.xy * _e23.xy) + _e28.zw), _e64);
    const float4 _e66 = shade(surface_1);
    const float4 _e67 = finite_vec4_(_e66);
    return _e67;
}
