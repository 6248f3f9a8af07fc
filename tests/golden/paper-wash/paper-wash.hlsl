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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const float MOST_ON_SCREEN = 1000000000000000.0;
static const Ramp indigo_to_warm_paper = ConstructRamp(Constructarray16_float4_(float4(0.13, 0.14, 0.33, 1.0), float4(0.24, 0.36, 0.56, 1.0), float4(0.53, 0.66, 0.72, 1.0), float4(0.9, 0.8, 0.68, 1.0), float4(0.975, 0.95, 0.9, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.35, 0.62, 0.82), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 1u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 normal : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 normal_1 : LOC0;
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

float4 bounded_vec4_(float4 v_3)
{
    uint4 bits_2 = asuint(v_3);
    uint4 magnitude_1 = (bits_2 & (2147483647u).xxxx);
    float4 largest_1 = asfloat(((bits_2 & (2147483648u).xxxx) | (2139095039u).xxxx));
    float4 numbers = ((magnitude_1 == (2139095040u).xxxx) ? largest_1 : (0.0).xxxx);
    return ((magnitude_1 < (2139095040u).xxxx) ? v_3 : numbers);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
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

float stairs_integral(float x_4, float count)
{
    float inside = min(x_4, count);
    float stair = min(floor(inside), 3.0);
    float beyond = max((x_4 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 3.0));
}

float stairs_integral_2_(float x_5, float count_1)
{
    float inside_1 = max(x_5, 0.0);
    float stair_1 = floor(inside_1);
    return ((stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0);
}

float stairs_filtered(float x_6, float count_2, float w)
{
    if ((w <= 1.0)) {
        float edge = clamp(round(x_6), 1.0, 3.0);
        return ((edge - 1.0) + clamp((0.5 + ((x_6 - edge) / w)), 0.0, 1.0));
    }
    float half_ = (0.5 * w);
    const float _e22 = stairs_integral((x_6 + half_), count_2);
    const float _e24 = stairs_integral_2_((x_6 - half_), count_2);
    return ((_e22 - _e24) / (2.0 * half_));
}

float4 hermite(float4 a_1, float4 b_1, float4 from_a, float4 to_b, float t)
{
    float4 d_3 = (b_1 - a_1);
    return (a_1 + (t * (from_a + (t * ((((3.0 * d_3) - (2.0 * from_a)) - to_b) + (t * ((from_a + to_b) - (2.0 * d_3))))))));
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

float4 ramp_at(Ramp ramp, float x_7, float w_1)
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
            uint _e28 = i_2_;
            i_2_ = (_e28 + 1u);
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 5u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e17 = i_2_;
        uint _e21 = i_2_;
        float _e25 = places[min(uint(naga_div(_e17, 4u)), 3u)][min(uint(naga_mod(_e21, 4u)), 3u)];
        at = ((_e25 <= x_7) ? _e16 : _e15);
    }
    uint _e31 = at;
    uint _e35 = at;
    float place_5 = places[min(uint(naga_div(_e31, 4u)), 3u)][min(uint(naga_mod(_e35, 4u)), 3u)];
    uint _e40 = at;
    if ((((_e40 + 1u) >= 5u) | (x_7 <= place_5))) {
        uint _e47 = at;
        float4 _e49 = colors[min(uint(_e47), 15u)];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = (_e50 + 1u);
    float _e59 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span = (_e59 - place_5);
    const float _e62 = divided((x_7 - place_5), span);
    float t_1 = clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if ((_e69 > 0u)) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places[min(uint(naga_div((_e72 - 1u), 4u)), 3u)][min(uint(naga_mod((_e78 - 1u), 4u)), 3u)];
        uint _e85 = at;
        float4 _e87 = colors[min(uint(_e85), 15u)];
        uint _e88 = at;
        float4 _e92 = colors[min(uint((_e88 - 1u)), 15u)];
        float4 _e96 = colors[min(uint(after_1), 15u)];
        uint _e97 = at;
        float4 _e99 = colors[min(uint(_e97), 15u)];
        const float4 _e101 = ramp_slope((_e87 - _e92), (place_5 - before_1), (_e96 - _e99), span);
        from_a_1 = _e101;
    }
    if (((after_1 + 1u) < 5u)) {
        float _e119 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e119 - (place_5 + span));
        float4 _e123 = colors[min(uint(after_1), 15u)];
        uint _e124 = at;
        float4 _e126 = colors[min(uint(_e124), 15u)];
        float4 _e131 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e133 = colors[min(uint(after_1), 15u)];
        const float4 _e135 = ramp_slope((_e123 - _e126), span, (_e131 - _e133), next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    float4 _e138 = colors[min(uint(_e136), 15u)];
    float4 _e140 = colors[min(uint(after_1), 15u)];
    float4 _e141 = from_a_1;
    float4 _e143 = to_b_1;
    const float4 _e145 = hermite(_e138, _e140, (span * _e141), (span * _e143), t_1);
    const float4 _e146 = bounded_vec4_(_e145);
    return _e146;
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

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
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

float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod((hash.x >> 8u), 3u);
    float a_2 = ((axis == 0u) ? d.y : d.x);
    float b_2 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_2 : -(a_2)) + (((hash.z >> 31u) == 0u) ? b_2 : -(b_2)));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_1)
{
    int i = int(0);
    float sum = 0.0;

    float3 corner = floor(p);
    float3 d_4 = (p - corner);
    float3 f = (((d_4 * d_4) * d_4) * ((d_4 * ((d_4 * 6.0) - (15.0).xxx)) + (10.0).xxx));
    int3 cell = naga_f2i32(corner);
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e64 = i;
            i = asint(asuint(_e64) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e21 = i;
        if (!((_e21 < int(8)))) {
            break;
        }
        int _e25 = i;
        int _e28 = i;
        int _e33 = i;
        int3 at_2 = int3((_e25 & int(1)), ((_e28 >> 1u) & int(1)), (_e33 >> 2u));
        float3 weight = ((at_2 == (int(1)).xxx) ? f : ((1.0).xxx - f));
        float _e44 = sum;
        const uint3 _e58 = hash_pcg3d((asuint(asint(asuint(cell) + asuint(at_2))) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
        const float _e61 = gradient_dot(_e58, (d_4 - float3(at_2)));
        sum = (_e44 + (((weight.x * weight.y) * 0.5) * _e61));
    }
    float _e67 = sum;
    return clamp((0.5 + (0.48244 * _e67)), 0.0, 1.0);
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
    float3 x_8 = ((turn.y * along) + (turn.x * across));
    float3 y = ((turn.y * across) - (turn.x * along));
    float2 turned = float2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    float3 stretch_4 = float3(dot(x_8, x_8), dot(x_8, y), dot(y, y));
    const StretchedPlace stretchedplace = ConstructStretchedPlace(turned, stretch_4);
    return stretchedplace;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_1, float3 stretch, float2 viewport_1, float count_3)
{
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (count_3 / max(viewport_1.y, 1.0)) : count_3);
    float2 p_1 = clamp((place_1 * scale_2), (-4194304.0).xx, (4194304.0).xx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_1, (is_pixel ? float3(1.0, 0.0, 1.0) : stretch));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
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
    float2 place_6 = ((_e8 - float2(anchor.x, -(anchor.y))) / (size).xx);
    const StretchedPlace _e26 = mark_place_of(place_6, float3((1.0 / size), 0.0, 0.0), float3(0.0, (1.0 / size), 0.0), angle_1);
    const MarkPlace markplace = ConstructMarkPlace(_e26.place, _e26.stretch);
    return markplace;
}

float paper_octave(float2 place_2, int zoom, float w_2, float fiber, uint seed_2)
{
    float scale_3 = asfloat((uint(asint(asuint(zoom) + asuint(int(127)))) << 23u));
    float2 p_2 = clamp((place_2 * scale_3), (-4194304.0).xx, (4194304.0).xx);
    uint own = (seed_2 + (7u * asuint(zoom)));
    const float _e23 = perlin_noise(float3(p_2, 0.5), own);
    float grain = (_e23 - 0.5);
    float2 q = clamp((2.7 * float2(((0.8 * p_2.x) - (0.6 * p_2.y)), ((0.6 * p_2.x) + (0.8 * p_2.y)))), (-4194304.0).xx, (4194304.0).xx);
    const float _e52 = perlin_noise(float3(q, 0.5), (own + 1u));
    float felt = (_e52 - 0.5);
    float coarse_seen = (1.0 - smoothstep(0.5, 1.0, (w_2 * scale_3)));
    float felt_seen = (1.0 - smoothstep(0.5, 1.0, ((2.7 * w_2) * scale_3)));
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(SpacedPlace at_1, float fiber_1, uint seed_3)
{
    float height = (float)0;

    float2 x_9 = ddx(at_1.place);
    float2 y_1 = ddy(at_1.place);
    float w_3 = sqrt(max(dot(x_9, x_9), dot(y_1, y_1)));
    const float _e12 = area_square(at_1.stretch);
    const float _e16 = log2_stable(max(sqrt(_e12), 1e-30));
    float level = clamp((-0.5 * _e16), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    const float _e26 = paper_octave(at_1.place, naga_f2i32(zoom_1), w_3, fiber_1, seed_3);
    height = _e26;
    if ((f_1 > 0.0)) {
        float _e30 = height;
        const float _e35 = paper_octave(at_1.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), w_3, fiber_1, seed_3);
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

PaperGrain paper_grain(float value, float2 place_3, float3 stretch_2, float count_4, float tooth, float fiber_2, int seed_4, float2 viewport_3)
{
    const SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_4);
    const float _e10 = paper_height(_e8, fiber_2, 5u);
    const PaperGrain papergrain = ConstructPaperGrain((1.0 - clamp((0.5 + (((0.0 * (_e10 - 0.5)) * 0.5) * 0.5)), 0.0, 1.0)), _e10);
    return papergrain;
}

PaperGrain paper_grain_2_(float value_1, float2 place_4, float3 stretch_3, float count_5, float tooth_1, float fiber_3, int seed_5, float2 viewport_4)
{
    const SpacedPlace _e8 = spaced(place_4, stretch_3, viewport_4, count_5);
    const float _e10 = paper_height(_e8, fiber_3, 0u);
    float ink = (1.0 - clamp(value_1, 0.0, 1.0));
    const PaperGrain papergrain_1 = ConstructPaperGrain((1.0 - clamp((ink + ((((8.0 * tooth_1) * (_e10 - 0.5)) * ink) * (1.0 - ink))), 0.0, 1.0)), _e10);
    return papergrain_1;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float light_and_shade = max(((dot(surface.normal, _e5) + 0.5) / 1.5), 0.0);
    float2 _e18 = look.viewport;
    const MarkPlace _e19 = mark_place_object(0.0, surface.anchor, surface.pixel, _e18);
    float2 _e29 = look.viewport;
    const PaperGrain _e30 = paper_grain(0.5, _e19.place, _e19.stretch, 11.0, 0.0, 0.7, int(5), _e29);
    const float _e32 = bounded(_e30.height);
    float uneven_edge = lerp(-0.2, 0.2, (_e32 - 0.0));
    float wet = (light_and_shade + uneven_edge);
    const float _e45 = footprint_of_2_(wet);
    const float _e51 = stairs_filtered((4.0 * clamp(wet, 0.0, 1.0)), 4.0, length(float2((4.0 * _e45), 0.22)));
    float washes = clamp((_e51 / 3.0), 0.0, 1.0);
    float pigment_in_them = lerp(washes, wet, 0.35);
    float2 _e67 = look.viewport;
    const PaperGrain _e68 = paper_grain_2_(pigment_in_them, _e19.place, _e19.stretch, 260.0, 0.2, 0.6, int(0), _e67);
    const float _e71 = bounded(_e68.tone);
    const float _e73 = footprint_of(_e68.tone);
    const float4 _e74 = ramp_at(indigo_to_warm_paper, _e71, _e73);
    float4 output_alpha = float4(_e74.xyz, clamp(_e74.w, 0.0, 1.0));
    const float4 _e81 = premultiplied(output_alpha);
    const float4 _e82 = output(_e81);
    return _e82;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.normal = arg1;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view.clip_from_world;
    float3x3 _e14 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), mul(vertex.normal, _e14));
    const VertexOutput_vs_main varyings_1 = { varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float2 arg1, float3 arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.pixel = arg1;
    ret.anchor = arg2;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    float4 _e10 = view.screen;
    float4 _e15 = view.screen;
    float4x4 _e20 = view.camera_from_world;
    float4 _e24 = object.world_from_object[3];
    float _e33 = view.eye.w;
    float _e38 = view.clip_from_world[0].y;
    float _e43 = view.clip_from_world[1].y;
    float _e48 = view.clip_from_world[2].y;
    const float3 _e51 = anchor_on_screen(mul(float4(_e24.xyz, 1.0), _e20).xyz, _e33, length(float3(_e38, _e43, _e48)));
    Surface surface_1 = ConstructSurface(normal_2, ((in_.clip_.xy * _e10.xy) + _e15.zw), _e51);
    const float4 _e53 = shade(surface_1);
    const float4 _e54 = finite_vec4_(_e53);
    return _e54;
}
