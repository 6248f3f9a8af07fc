// Stained glass: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// stained-glass.json says what to put there and how to draw.
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
    Light room;
    Light sun;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position;
    int _pad3_0;
    float3 position_object;
    int _end_pad_0;
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

struct Cell {
    float border;
    float random;
    float distance_;
};

struct Cells {
    float border;
    float random;
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint NOISE_PERLIN = 1u;
static const float CELL_REACH = 1.25;
static const Ramp colors_1 = ConstructRamp(Constructarray16_float4_(float4(0.0706, 0.1882, 0.4784, 1.0), float4(0.1216, 0.4784, 0.6902, 1.0), float4(0.1137, 0.5412, 0.3529, 1.0), float4(0.9098, 0.6902, 0.1255, 1.0), float4(0.8471, 0.3255, 0.1098, 1.0), float4(0.6902, 0.0706, 0.2196, 1.0), float4(0.3529, 0.102, 0.4784, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.22, 0.4, 0.58), float4(0.75, 0.9, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx), 7u, 2u);
static const ProfileShape through_the_glass_shape = ConstructProfileShape(0.9950042, 0.099833414, 1.1883951, 1.4967098, 0.2, 1.0679889, 0.45520553, 0u);
static const ProfileShape on_the_glass_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1, 1.0089166, 0.41697913, 0u);
static const ProfileShape gleam_tone_shape = ConstructProfileShape(0.99820054, 0.059964005, 11.126125, 3.022525, 0.12, 0.08196669, 0.036355104, 0u);
static const ProfileShape edge_of_the_lead_tone_shape = ConstructProfileShape(0.9887711, 0.14943813, 3.3838634, 2.4220939, 0.3, 0.29531473, 0.1274162, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_3 : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_4 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) & (largest < 1e30)))) {
        return otherwise;
    }
    float3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    const bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float3 normalize_moderate(float3 v_1, float3 otherwise_1)
{
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * rsqrt(max(square_1, 1e-30))) : otherwise_1);
}

float3 normalize_seen(float3 v_2)
{
    const float3 _e5 = normalize_moderate(v_2, float3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_6 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_6, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_2 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_2, u_1.half_cos));
    float2 turned = (((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float bounded(float x_1)
{
    uint bits = asuint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_2, float low, float high)
{
    const float _e3 = bounded(x_2);
    const float _e7 = bounded(((_e3 - low) / 0.5));
    float t_2 = clamp(_e7, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float length_of(float3 v_3)
{
    float largest_2 = max(max(abs(v_3.x), abs(v_3.y)), abs(v_3.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e16 = bounded((largest_2 * length((v_3 / (largest_2).xxx))));
    return _e16;
}

float footprint_of(float x_3)
{
    float _e1 = ddx(x_3);
    float _e2 = ddy(x_3);
    float2 d_1 = float2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float footprint_of_vec3_(float3 v_4)
{
    float3 dx_1 = ddx(v_4);
    float3 dy_1 = ddy(v_4);
    const float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

float footprint_of_vec3_2_(float3 v_5)
{
    float3 dx_2 = ddx(v_5);
    float3 dy_2 = ddy(v_5);
    return sqrt(max(dot(dx_2, dx_2), dot(dy_2, dy_2)));
}

float step_filtered(float x_4, float edge, float w)
{
    float d_2 = (x_4 - edge);
    return ((w < 1e-30) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_2 / w)), 0.0, 1.0));
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float4 ramp_at(Ramp ramp, float x_5, float w_1)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;

    colors = ramp.colors;
    places = ramp.places;
    float4 _e8 = colors[0];
    color = _e8;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e38 = i;
            i = (_e38 + 1u);
        }
        loop_init = false;
        uint _e12 = i;
        if (!((_e12 < 7u))) {
            break;
        }
        float4 _e16 = color;
        uint _e17 = i;
        float4 _e19 = colors[min(uint(_e17), 15u)];
        uint _e20 = i;
        float4 _e24 = colors[min(uint((_e20 - 1u)), 15u)];
        uint _e26 = i;
        uint _e30 = i;
        float _e34 = places[min(uint(naga_div(_e26, 4u)), 3u)][min(uint(naga_mod(_e30, 4u)), 3u)];
        const float _e35 = step_filtered(x_5, _e34, w_1);
        color = (_e16 + ((_e19 - _e24) * _e35));
    }
    float4 _e41 = color;
    return _e41;
}

float3 bumped_normal(float4 along_x, float4 along_y, float3 normal)
{
    const float _e4 = length_of(along_x.xyz);
    const float _e6 = length_of(along_y.xyz);
    float largest_3 = max(_e4, _e6);
    if (((largest_3 < 1e-18) | (largest_3 > 1e18))) {
        return normal;
    }
    float3 s_3 = (along_x.xyz / (largest_3).xxx);
    float3 t_3 = (along_y.xyz / (largest_3).xxx);
    float2 rise = clamp((float2(along_x.w, along_y.w) / (largest_3).xx), (-1000000.0).xx, (1000000.0).xx);
    float3 right = cross(t_3, normal);
    float3 up = cross(normal, s_3);
    float area = dot(s_3, right);
    if ((abs(area) < 1e-6)) {
        return normal;
    }
    float3 slope = (((rise.x * right) + (rise.y * up)) / (area).xxx);
    float steepness = length(slope);
    float3 limited = (slope * (min(steepness, 10.0) / max(steepness, 1e-20)));
    const float3 _e50 = normalize_or((normal - limited), normal);
    return _e50;
}

float3 bump_map(float height, float scale, float3 normal_1, float3 position)
{
    float raised = (height * scale);
    float3 _e5 = ddx(position);
    float _e6 = ddx(raised);
    float4 along_x_1 = float4(_e5, _e6);
    float3 _e8 = ddy(position);
    float _e9 = ddy(raised);
    float4 along_y_1 = float4(_e8, _e9);
    const float3 _e11 = bumped_normal(along_x_1, along_y_1, normal_1);
    return _e11;
}

float4 blend_add(float4 below, float4 color_1, float tone, float opacity, bool clamped)
{
    return max(float4((below.xyz + (opacity * ((below.xyz + color_1.xyz) - below.xyz))), 1.0), (0.0).xxxx);
}

float4 blend_add_2_(float4 below_1, float4 color_2, float tone_1, float opacity_1, bool clamped_1)
{
    return clamp(float4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * color_2.xyz)) - below_1.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_alpha(float4 below_2, float4 color_3, float tone_2, float opacity_2, bool clamped_2)
{
    return clamp(float4((below_2.xyz + (opacity_2 * ((below_2.xyz + (tone_2 * (color_3.xyz - below_2.xyz))) - below_2.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_4, float tone_3)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_4.xyz * light.color) * split.y), 1.0), (tone_3 * split.x));
    return litlayer;
}

Angle parametrization_specular_balanced(Light light_1, float3 normal_2, float3 view)
{
    float3 d_3 = (((2.0 * dot(normal_2, view)) * normal_2) - view);
    const Angle angle_3 = ConstructAngle((0.5 * length((d_3 - light_1.direction))), (0.5 * length((d_3 + light_1.direction))));
    return angle_3;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w_2, ProfileShape shape_1)
{
    float width = sqrt(((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w_2 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_2, float w_3, ProfileShape shape_2)
{
    float2 place = float2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    const float _e19 = profile_soft_quick(place.x, shape_2);
    if ((w_3 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_3);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    const float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_4, ProfileShape shape_3)
{
    float2 place_1 = float2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_4 > 0.0) & (w_4 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place_1.x, w_4, shape_3);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place_1.x, shape_3);
    if ((w_4 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_4);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_3);
    const float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5)
{
    const Angle _e6 = angle_turned(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
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

float gradient_dot(uint3 hash_1, float3 d)
{
    uint axis = naga_mod((hash_1.x >> 8u), 3u);
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash_1.y >> 31u) == 0u) ? a : -(a)) + (((hash_1.z >> 31u) == 0u) ? b : -(b)));
}

float3 fade_quintic(float3 t_1)
{
    return (((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i_1 = int(0);

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
            int _e46 = i_1;
            i_1 = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e10 = i_1;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_1;
            int _e16 = i_1;
            int _e21 = i_1;
            int3 at = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at)), seed_2);
            const float _e42 = gradient_dot(_e39, (d_4 - float3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

Cell ConstructCell(float arg0, float arg1, float arg2) {
    Cell ret = (Cell)0;
    ret.border = arg0;
    ret.random = arg1;
    ret.distance_ = arg2;
    return ret;
}

Cell nearest_cell(float3 p_1, uint seed_3)
{
    float3 nearest = (4.0).xxx;
    uint3 hash_2 = (0u).xxx;
    int i_2 = int(0);
    float border = (float)0;
    int i_3 = int(0);

    float3 corner_1 = floor(p_1);
    float3 d_5 = (p_1 - corner_1);
    int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e51 = i_2;
            i_2 = asint(asuint(_e51) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e13 = i_2;
        if ((_e13 < int(27))) {
        } else {
            break;
        }
        {
            int _e16 = i_2;
            int _e21 = i_2;
            int _e28 = i_2;
            int3 at_1 = int3(asint(asuint(naga_mod(_e16, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e21, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e28, int(9))) - asuint(int(1))));
            const uint3 _e35 = lattice_hash(asint(asuint(cell_2) + asuint(at_1)), seed_3);
            const float3 _e40 = unit_of_hash(_e35);
            float3 offset = (((float3(at_1) + (0.25).xxx) + (0.5 * _e40)) - d_5);
            float3 _e46 = nearest;
            float3 _e47 = nearest;
            if ((dot(offset, offset) < dot(_e46, _e47))) {
                nearest = offset;
                hash_2 = _e35;
            }
        }
    }
    float3 _e53 = nearest;
    float distance_ = length(_e53);
    border = max((0.5 * (CELL_REACH - distance_)), 0.0);
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e110 = i_3;
            i_3 = asint(asuint(_e110) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e64 = i_3;
        if ((_e64 < int(27))) {
        } else {
            break;
        }
        {
            int _e67 = i_3;
            int _e72 = i_3;
            int _e79 = i_3;
            int3 at_2 = int3(asint(asuint(naga_mod(_e67, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e72, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e79, int(9))) - asuint(int(1))));
            const uint3 _e90 = lattice_hash(asint(asuint(cell_2) + asuint(at_2)), seed_3);
            const float3 _e91 = unit_of_hash(_e90);
            float3 _e96 = nearest;
            float3 apart = ((((float3(at_2) + (0.25).xxx) + (0.5 * _e91)) - d_5) - _e96);
            float between = length(apart);
            if ((between > 0.25)) {
                float _e101 = border;
                float3 _e102 = nearest;
                border = min(_e101, (dot((_e102 + (0.5 * apart)), apart) / between));
            }
        }
    }
    float _e112 = border;
    uint3 _e115 = hash_2;
    const uint3 _e116 = hash_pcg3d(_e115);
    const float3 _e117 = unit_of_hash(_e116);
    const Cell cell_3 = ConstructCell(max(_e112, 0.0), _e117.x, distance_);
    return cell_3;
}

float fractal_noise(uint kind, float3 p_2, int octaves, float roughness, int seed_4, float w_5)
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
        const float _e25 = eased((w_5 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_4;
            float3 place_2 = clamp(((p_2 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
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

Cells ConstructCells(float arg0, float arg1, float arg2) {
    Cells ret = (Cells)0;
    ret.border = arg0;
    ret.random = arg1;
    ret.distance_ = arg2;
    return ret;
}

Cells cells(float3 position_1, float scale_1, int seed_5)
{
    float3 p_3 = clamp((position_1 * scale_1), (-4194304.0).xxx, (4194304.0).xxx);
    const Cell _e10 = nearest_cell(p_3, 4u);
    const float _e11 = footprint_of_vec3_2_(p_3);
    float visible_1 = (1.0 - smoothstep(0.5, 1.0, _e11));
    float3 average = float3(0.1301, 0.5, 0.491);
    float3 seen = lerp(average, float3(_e10.border, _e10.random, _e10.distance_), visible_1);
    const Cells cells_1 = ConstructCells(seen.x, seen.y, seen.z);
    return cells_1;
}

float noise_perlin(float3 position_2, float scale_2, int octaves_1, float roughness_1, int seed_6)
{
    float3 p_4 = (position_2 * scale_2);
    const float _e7 = footprint_of_vec3_(p_4);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_4, octaves_1, roughness_1, seed_6, _e7);
    return _e8;
}

float4 shade(Surface surface)
{
    const Cells _e4 = cells(surface.position_object, 3.4, int(4));
    const float _e8 = footprint_of(_e4.random);
    const float4 _e9 = ramp_at(colors_1, _e4.random, _e8);
    const float4 _e18 = blend_add(float4(0.0275, 0.0235, 0.0471, 1.0), _e9, 1.0, 0.3, true);
    const float _e24 = noise_perlin(surface.position_object, 5.0, int(2), 0.5, int(0));
    const float3 _e28 = bump_map(_e24, 0.03, surface.normal, surface.position);
    float3 _e32 = look.sun.direction;
    float3 _e40 = look.sun.direction;
    Angle sun_turn = ConstructAngle((0.5 * length((_e28 - _e32))), (0.5 * length((_e28 + _e40))));
    const float _e48 = profile_balanced(sun_turn, 0.0, through_the_glass_shape);
    const float4 _e51 = blend_add_2_(_e18, _e9, _e48, 0.95, true);
    float3 _e55 = look.room.direction;
    float3 _e63 = look.room.direction;
    Angle room_turn = ConstructAngle((0.5 * length((_e28 - _e55))), (0.5 * length((_e28 + _e63))));
    const float _e71 = profile_balanced(room_turn, 0.0, on_the_glass_shape);
    const float4 _e74 = blend_add_2_(_e51, _e9, _e71, 0.45, true);
    const float _e78 = footprint_of(_e4.border);
    const float _e82 = step_filtered(_e4.border, 0.035, length(float2(_e78, 0.0)));
    float leading = (1.0 - _e82);
    float4 leading_2_ = clamp(float4((_e74.xyz + (leading * (float3(0.0824, 0.0863, 0.102) - _e74.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    Light _e103 = look.room;
    const Angle _e105 = parametrization_specular_balanced(_e103, _e28, surface.view);
    const float _e108 = profile_balanced_2_(_e105, 0.0, gleam_tone_shape);
    Light _e111 = look.room;
    const LitLayer _e117 = light_apply(_e111, float4(1.0, 0.9647, 0.8941, 1.0), _e108);
    const float4 _e122 = blend_alpha(leading_2_, _e117.color, _e117.tone, 0.7, true);
    Light _e125 = look.room;
    const Angle _e128 = parametrization_specular_balanced(_e125, surface.normal, surface.view);
    const float _e131 = profile_balanced_2_(_e128, 0.0, edge_of_the_lead_tone_shape);
    Light _e134 = look.room;
    const LitLayer _e140 = light_apply(_e134, float4(0.1725, 0.1843, 0.2196, 1.0), _e131);
    const float4 _e145 = blend_add_2_(_e122, _e140.color, _e140.tone, 0.35, true);
    return _e145;
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

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position = arg2;
    ret.position_object = arg3;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_4, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_5 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = ConstructSurface(normal_5, normalize((_e8.xyz - (_e13 * in_.position))), in_.position, in_.position_object);
    const float4 _e21 = shade(surface_1);
    return _e21;
}
