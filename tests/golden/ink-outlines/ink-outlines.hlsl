// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object_2 b1, look b2, curvature_tensor_map t0, line_nearness_map t1, facet_map t2.
// ink-outlines.json says what to put there and how to draw.
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
    row_major float3x3 camera_from_world;
    int _pad1_0;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light key;
    float object_id;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    int _pad3_0;
    float3 position_camera;
    float depth;
    float3 curvature_tensor;
    int _pad6_0;
    float4 line_nearness;
    float2 middle_surface;
    float magnification;
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

struct Outline {
    float line_;
    float kind;
    float distance_;
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
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const uint NOISE_PERLIN = 1u;
static const float MOST_ON_SCREEN = 1000000000000000.0;
static const Ramp three_washes = ConstructRamp(Constructarray16_float4_(float4(0.4353, 0.5255, 0.6588, 1.0), float4(0.7882, 0.6471, 0.549, 1.0), float4(0.949, 0.851, 0.6941, 1.0), float4(1.0, 0.9647, 0.8784, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.36, 0.54, 0.93), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 4u, 2u);
static const Ramp ink = ConstructRamp(Constructarray16_float4_(float4(0.0784, 0.102, 0.2, 1.0), float4(0.3529, 0.1647, 0.1098, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.1, 0.85, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 2u, 1u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object_2 : register(b1) { Object object_2; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);
Texture2D<float4> line_nearness_map : register(t1);
Texture2D<float4> facet_map : register(t2);

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float4 finite_vec4_(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return (((asuint(v) & exponent) != exponent) ? v : (0.0).xxxx);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float4 bounded_vec4_(float4 v_2)
{
    uint4 bits_1 = asuint(v_2);
    uint4 magnitude_1 = (bits_1 & (2147483647u).xxxx);
    float4 largest_1 = asfloat(((bits_1 & (2147483648u).xxxx) | (2139095039u).xxxx));
    float4 numbers = ((magnitude_1 == (2139095040u).xxxx) ? largest_1 : (0.0).xxxx);
    return ((magnitude_1 < (2139095040u).xxxx) ? v_2 : numbers);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float4 mixed_vec4_(float4 a_1, float4 b_1, float t)
{
    const float4 _e4 = bounded_vec4_((b_1 - a_1));
    const float4 _e14 = bounded_vec4_(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

float eased(float x_1, float low, float high)
{
    const float _e3 = bounded(x_1);
    const float _e7 = bounded(((_e3 - low) / 0.5));
    float t_3 = clamp(_e7, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float footprint_of(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float footprint_of_2_(float x_3)
{
    float _e1 = ddx(x_3);
    float _e2 = ddy(x_3);
    float2 d_2 = float2(_e1, _e2);
    return sqrt(dot(d_2, d_2));
}

float footprint_of_vec3_(float3 v_3)
{
    float3 dx = ddx(v_3);
    float3 dy = ddy(v_3);
    const float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

float step_filtered(float x_4, float edge, float w)
{
    const float _e4 = bounded((x_4 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float step_filtered_2_(float x_5, float edge_1, float w_1)
{
    float d_3 = (x_5 - edge_1);
    return ((w_1 < 1e-30) ? ((d_3 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_3 / w_1)), 0.0, 1.0));
}

float4 hermite(float4 a_2, float4 b_2, float4 from_a, float4 to_b, float t_1)
{
    float4 d_4 = (b_2 - a_2);
    return (a_2 + (t_1 * (from_a + (t_1 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_1 * ((from_a + to_b) - (2.0 * d_4))))))));
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

float4 ramp_at(Ramp ramp, float x_6, float w_2)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
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
                const float _e43 = step_filtered(x_6, _e42, w_2);
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
            at = ((_e67 <= x_6) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if ((((_e82 + 1u) >= count) | (x_6 <= place_1))) {
        uint _e88 = at;
        float4 _e90 = colors[min(uint(_e88), 15u)];
        const float4 _e91 = bounded_vec4_(_e90);
        return _e91;
    }
    uint _e92 = at;
    uint after_1 = (_e92 + 1u);
    float _e101 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span = (_e101 - place_1);
    const float _e104 = divided((x_6 - place_1), span);
    float t_4 = clamp(_e104, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e111 = at;
        float4 _e113 = colors[min(uint(_e111), 15u)];
        float4 _e115 = colors[min(uint(after_1), 15u)];
        const float4 _e116 = mixed_vec4_(_e113, _e115, t_4);
        return _e116;
    }
    uint _e123 = at;
    if ((_e123 > 0u)) {
        uint _e126 = at;
        uint _e132 = at;
        float before_1 = places[min(uint(naga_div((_e126 - 1u), 4u)), 3u)][min(uint(naga_mod((_e132 - 1u), 4u)), 3u)];
        uint _e139 = at;
        float4 _e141 = colors[min(uint(_e139), 15u)];
        uint _e142 = at;
        float4 _e146 = colors[min(uint((_e142 - 1u)), 15u)];
        float4 _e150 = colors[min(uint(after_1), 15u)];
        uint _e151 = at;
        float4 _e153 = colors[min(uint(_e151), 15u)];
        const float4 _e155 = ramp_slope((_e141 - _e146), (place_1 - before_1), (_e150 - _e153), span);
        from_a_1 = _e155;
    }
    if (((after_1 + 1u) < count)) {
        float _e169 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e169 - (place_1 + span));
        float4 _e173 = colors[min(uint(after_1), 15u)];
        uint _e174 = at;
        float4 _e176 = colors[min(uint(_e174), 15u)];
        float4 _e181 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e183 = colors[min(uint(after_1), 15u)];
        const float4 _e185 = ramp_slope((_e173 - _e176), span, (_e181 - _e183), next);
        to_b_1 = _e185;
    }
    uint _e186 = at;
    float4 _e188 = colors[min(uint(_e186), 15u)];
    float4 _e190 = colors[min(uint(after_1), 15u)];
    float4 _e191 = from_a_1;
    float4 _e193 = to_b_1;
    const float4 _e195 = hermite(_e188, _e190, (span * _e191), (span * _e193), t_4);
    const float4 _e196 = bounded_vec4_(_e195);
    return _e196;
}

float4 ramp_at_2_(Ramp ramp_1, float x_7, float w_3)
{
    float4 colors_1[16] = (float4[16])0;
    float4 places_1[4] = (float4[4])0;
    float4 color_1 = (float4)0;
    uint i_2 = 1u;

    colors_1 = ramp_1.colors;
    places_1 = ramp_1.places;
    float4 _e8 = colors_1[0];
    color_1 = _e8;
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            uint _e35 = i_2;
            i_2 = (_e35 + 1u);
        }
        loop_init_2 = false;
        uint _e12 = i_2;
        if (!((_e12 < 4u))) {
            break;
        }
        float4 _e16 = color_1;
        uint _e17 = i_2;
        float4 _e19 = colors_1[min(uint(_e17), 15u)];
        uint _e20 = i_2;
        float4 _e24 = colors_1[min(uint((_e20 - 1u)), 15u)];
        uint _e27 = i_2;
        float _e31 = places_1[0][min(uint(naga_mod(_e27, 4u)), 3u)];
        const float _e32 = step_filtered_2_(x_7, _e31, w_3);
        color_1 = (_e16 + ((_e19 - _e24) * _e32));
    }
    float4 _e38 = color_1;
    return _e38;
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

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_4 = (uint3)0;

    v_4 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_4.x;
    uint _e10 = v_4.y;
    uint _e12 = v_4.z;
    v_4.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_4.y;
    uint _e18 = v_4.z;
    uint _e20 = v_4.x;
    v_4.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_4.z;
    uint _e26 = v_4.x;
    uint _e28 = v_4.y;
    v_4.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_4;
    uint3 _e32 = v_4;
    v_4 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_4.x;
    uint _e40 = v_4.y;
    uint _e42 = v_4.z;
    v_4.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_4.y;
    uint _e48 = v_4.z;
    uint _e50 = v_4.x;
    v_4.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_4.z;
    uint _e56 = v_4.x;
    uint _e58 = v_4.y;
    v_4.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_4;
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
    float a_3 = ((axis == 0u) ? d.y : d.x);
    float b_3 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_3 : -(a_3)) + (((hash.z >> 31u) == 0u) ? b_3 : -(b_3)));
}

float3 fade_quintic(float3 t_2)
{
    return (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i_3 = int(0);

    float3 corner = floor(p);
    float3 d_5 = (p - corner);
    const float3 _e4 = fade_quintic(d_5);
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            int3 at_1 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at_1 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at_1)), seed_2);
            const float _e42 = gradient_dot(_e39, (d_5 - float3(at_1)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, float3 p_1, int octaves, float roughness, int seed_3, float w_4)
{
    float octave = (float)0;
    int i_4 = int(0);
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;

    uint2 loop_bound_4 = uint2(4294967295u, 4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (all(loop_bound_4 == uint2(0u, 0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e66 = i_4;
            i_4 = asint(asuint(_e66) + asuint(int(1)));
        }
        loop_init_4 = false;
        int _e17 = i_4;
        if (!((_e17 < int(2)))) {
            break;
        }
        float _e21 = frequency;
        const float _e25 = eased((w_4 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_4;
            float3 place_2 = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_4;
            const float _e50 = perlin_noise(place_2, (0u + uint(_e47)));
            octave = lerp(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * roughness);
        float _e63 = frequency;
        frequency = (_e63 * 2.0);
    }
    float _e69 = sum_1;
    return min((_e69 / 1.5), 1.0);
}

float size_on_screen(float depth, float perspective, float scale)
{
    return min(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

float reflectance_half_lambert(Light light, float3 normal)
{
    float half_ = (0.5 + (0.5 * dot(normal, light.direction)));
    return min((half_ * half_), 1.0);
}

float inner_contour_suggestive(float width, float limit, float softness, float3 tensor, float3 normal_1, float3 view, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n = mul(normal_1, camera_from_world);
    float square = dot(n.xy, n.xy);
    float radial = (((((tensor.x * n.x) * n.x) + (((2.0 * tensor.y) * n.x) * n.y)) + ((tensor.z * n.y) * n.y)) / max(square, 1e-6));
    float _e35 = ddx(radial);
    float _e36 = ddy(radial);
    float2 change = float2(_e35, _e36);
    float3 v_5 = mul(view, camera_from_world);
    float3 row = ddy(place);
    float up = (((row - (dot(row, v_5) * v_5)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * rsqrt(max(square, 1e-6)));
    float pixels_1 = (((0.5 * width) * height) / 1000.0);
    float distance_2 = (abs(radial) / max(length(change), 1e-6));
    float x_8 = ((toward_eye * height) * 0.05);
    const float _e80 = footprint_of(x_8);
    float strength_1 = clamp((0.5 + ((x_8 - limit) / length(float2(min(_e80, 1000000000000000.0), 24.0)))), 0.0, 1.0);
    return ((clamp(((pixels_1 + 0.5) - distance_2), 0.0, min(pixels_1, 1.0)) * strength_1) * smoothstep(0.05, 0.3, dot(normal_1, view)));
}

float4 own_nearness(float4 nearness, float2 middle, float depth_1, float object, float pixels, float reach)
{
    bool local = (bool)0;
    bool local_1 = (bool)0;

    bool is_same_object = (middle.y == (object + 1.0));
    float behind = ((depth_1 - middle.x) * pixels);
    if (!((middle.y == 0.0))) {
        if (is_same_object) {
            local_1 = (abs(behind) <= 8.0);
        } else {
            local_1 = false;
        }
        bool _e25 = local_1;
        local = _e25;
    } else {
        local = true;
    }
    bool is_own = local;
    bool is_in_front = (behind < (is_same_object ? -8.0 : -2.0));
    float4 other = float4((is_in_front ? reach : 0.0), 0.0, nearness.z, 0.0);
    return (is_own ? nearness : other);
}

float4 line_widths(float width_1, float4 shares)
{
    float4 widths_2 = (min(width_1, 10000.0) * shares);
    return ((widths_2 > (1e-6).xxxx) ? widths_2 : (0.0).xxxx);
}

float inner_line_covers(float distance_, float width_2)
{
    return clamp(((width_2 + 0.5) - distance_), 0.0, min(width_2, 1.0));
}

float3 middle_line_covers(float3 distance_1, float3 width_3)
{
    float3 half_1 = (0.5 * width_3);
    return clamp((min((distance_1 + (0.5).xxx), half_1) - max((distance_1 - (0.5).xxx), -(half_1))), (0.0).xxx, (1.0).xxx);
}

float4 lines_cover(float4 nearness_1, float4 widths, float reach_1)
{
    float4 distance_3 = ((reach_1).xxxx - nearness_1);
    const float _e7 = inner_line_covers(distance_3.x, widths.x);
    const float3 _e10 = middle_line_covers(distance_3.yzw, widths.yzw);
    float4 covers = float4(_e7, _e10);
    return ((nearness_1 > (0.0).xxxx) ? covers : (0.0).xxxx);
}

Outline ConstructOutline(float arg0, float arg1, float arg2) {
    Outline ret = (Outline)0;
    ret.line_ = arg0;
    ret.kind = arg1;
    ret.distance_ = arg2;
    return ret;
}

Outline drawn_outline(float4 widths_1, float4 of_edges, float reach_2)
{
    float kind_1 = (float)0;

    float4 nearness_3 = clamp(of_edges, (0.0).xxxx, (reach_2).xxxx);
    const float4 _e7 = lines_cover(nearness_3, widths_1, reach_2);
    float line_ = max(max(_e7.x, _e7.y), max(_e7.z, _e7.w));
    kind_1 = ((_e7.z == line_) ? 3.0 : 4.0);
    float _e21 = kind_1;
    kind_1 = ((_e7.y == line_) ? 2.0 : _e21);
    float _e26 = kind_1;
    kind_1 = ((_e7.x == line_) ? 1.0 : _e26);
    float4 near = ((widths_1 > (0.0).xxxx) ? nearness_3 : (0.0).xxxx);
    float nearest = max(max(near.x, near.y), max(near.z, near.w));
    float _e44 = kind_1;
    const Outline outline = ConstructOutline(line_, ((line_ > 0.001) ? _e44 : 0.0), (reach_2 - nearest));
    return outline;
}

Outline outline_height(float width_4, float silhouettes, float creases, float borders, float look_borders, float4 nearness_2, float2 middle_1, float depth_2, float object_1, float2 viewport_1, float magnification)
{
    float pixels_2 = (magnification * viewport_1.y);
    float reach_3 = min((16.0 * max(round((viewport_1.y / 800.0)), 1.0)), 31.0);
    const float4 _e23 = own_nearness(nearness_2, middle_1, depth_2, object_1, pixels_2, reach_3);
    float4 shares_1 = float4(silhouettes, creases, borders, look_borders);
    const float4 _e29 = line_widths((width_4 * (0.001 * viewport_1.y)), shares_1);
    const Outline _e30 = drawn_outline(_e29, _e23, reach_3);
    const Outline outline_1 = _e30;
    return outline_1;
}

float noise_perlin(float3 position, float scale_1, int octaves_1, float roughness_1, int seed_4)
{
    float3 p_2 = (position * scale_1);
    const float _e7 = footprint_of_vec3_(p_2);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

float4 shade(Surface surface)
{
    Light _e3 = look.key;
    const float _e5 = reflectance_half_lambert(_e3, surface.normal);
    const float _e7 = footprint_of_2_(_e5);
    const float4 _e8 = ramp_at_2_(three_washes, _e5, _e7);
    const float _e10 = footprint_of_2_(_e5);
    const float4 _e11 = ramp_at(ink, _e5, _e10);
    float heavy_in_the_shade = lerp(1.6, 8.0, clamp(((_e5 - 0.75) / -0.6), 0.0, 1.0));
    const float _e27 = noise_perlin(surface.position_object, 3.5, int(2), 0.5, int(0));
    float pressure = lerp(0.7, 1.3, (_e27 - 0.0));
    float width_5 = (heavy_in_the_shade * pressure);
    float _e43 = look.object_id;
    float2 _e46 = look.viewport;
    const Outline _e48 = outline_height(width_5, 1.0, 0.6, 1.0, 0.6, surface.line_nearness, surface.middle_surface, surface.depth, _e43, _e46, surface.magnification);
    float3x3 _e57 = look.camera_from_world;
    float2 _e61 = look.viewport;
    const float _e62 = inner_contour_suggestive(2.2, 24.0, 1.0, surface.curvature_tensor, surface.normal, surface.view, _e57, surface.position_camera, _e61);
    float all_strokes = max(_e48.line_, _e62);
    const float4 _e65 = bounded_vec4_(_e11);
    const float4 _e66 = mixed_vec4_(_e8, _e65, all_strokes);
    float4 output_alpha = float4(_e66.xyz, clamp(_e66.w, 0.0, 1.0));
    const float4 _e73 = premultiplied(output_alpha);
    const float4 _e74 = output(_e73);
    return _e74;
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
    float4x4 _e3 = object_2.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_1.clip_from_world;
    float3x3 _e16 = object_2.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float arg4, float3 arg5, float4 arg6, float2 arg7, float arg8) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    ret.position_camera = arg3;
    ret.depth = arg4;
    ret.curvature_tensor = arg5;
    ret.line_nearness = arg6;
    ret.middle_surface = arg7;
    ret.magnification = arg8;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4x4 _e21 = view_1.camera_from_world;
    float4x4 _e29 = view_1.camera_from_world;
    float4 _e41 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e48 = line_nearness_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e54 = facet_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e61 = facet_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e68 = view_1.camera_from_world;
    float _e78 = view_1.eye.w;
    float _e83 = view_1.clip_from_world[0].y;
    float _e88 = view_1.clip_from_world[1].y;
    float _e93 = view_1.clip_from_world[2].y;
    const float _e96 = size_on_screen(-(mul(float4(in_.position, 1.0), _e68).z), _e78, length(float3(_e83, _e88, _e93)));
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, mul(float4(in_.position, 1.0), _e21).xyz, -(mul(float4(in_.position, 1.0), _e29).z), _e41.xyz, _e48, float2(_e54.z, floor(abs(_e61.w))), _e96);
    const float4 _e98 = shade(surface_1);
    const float4 _e99 = finite_vec4_(_e98);
    return _e99;
}
