// Silk: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// silk-ring.json says what to put there and how to draw.
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
    Light low;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    int _end_pad_0;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct DirectionParts {
    float3 direction;
    int _pad1_0;
    float3 x_axis;
    int _pad2_0;
    float3 y_axis;
    int _pad3_0;
    float2 place;
    int _end_pad_0;
    int _end_pad_1;
};

struct AxesAround {
    float3 x_axis;
    int _pad1_0;
    float3 y_axis;
    int _end_pad_0;
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
    float3 position_object : LOC1;
    float3 normal : LOC2;
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

static const uint NOISE_PERLIN = 1u;
static const ProfileShape lit_side_shape = ConstructProfileShape(0.9950042, 0.099833414, 1.1883951, 1.7298278, 0.2, 1.0107075, 0.4419037, 0u);
static const ProfileShape band_shape = ConstructProfileShape(0.9998875, 0.014999437, 9.541332, 4.980432, 0.03, 0.07759806, 0.03648918, 0u);
static const ProfileShape second_band_shape = ConstructProfileShape(1.0, 0.0, 6.6917324, 12.899528, 0.0, 0.07171497, 0.035865854, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_1 : LOC2;
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

float3 normalize_seen_balanced(float3 v_2)
{
    return (v_2 * rsqrt(max(dot(v_2, v_2), 1e-30)));
}

float2 sin_cos_quick(float x_1)
{
    float y_1 = (x_1 * x_1);
    float s_2 = (x_1 * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return float2(s_2, c);
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_3, c_1));
    float2 turned = (((s_3 <= 0.0) & (s_3 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_4 = (u_2.half_sin - 0.0);
    float2 upper_1 = ((u_2.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_4, u_2.half_cos));
    float2 turned_1 = (((s_4 <= 0.0) & (s_4 < u_2.half_cos)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_3 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_3;
}

float bounded(float x_2)
{
    uint bits = asuint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_3, float low, float high)
{
    const float _e3 = bounded(x_3);
    const float _e7 = bounded(((_e3 - low) / 0.5));
    float t_3 = clamp(_e7, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float footprint_of_vec3_(float3 v_3)
{
    float3 dx_1 = ddx(v_3);
    float3 dy_1 = ddy(v_3);
    const float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

float3 any_orthogonal(float3 n)
{
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_ + n.z));
    return float3((1.0 + (((sign_ * n.x) * n.x) * a)), (((sign_ * n.x) * n.y) * a), (-(sign_) * n.x));
}

DirectionParts ConstructDirectionParts(float3 arg0, float3 arg1, float3 arg2, float2 arg3) {
    DirectionParts ret = (DirectionParts)0;
    ret.direction = arg0;
    ret.x_axis = arg1;
    ret.y_axis = arg2;
    ret.place = arg3;
    return ret;
}

DirectionParts direction_within(float3 direction, float3 x_axis, float3 y_axis)
{
    float3 y_2 = (y_axis * rsqrt(max(dot(y_axis, y_axis), 1e-30)));
    const DirectionParts directionparts = ConstructDirectionParts(direction, x_axis, y_2, float2(dot(direction, x_axis), dot(direction, y_2)));
    return directionparts;
}

float3 direction_moved(DirectionParts parts, float2 by)
{
    float3 moved = ((parts.direction + (by.x * parts.x_axis)) + (by.y * parts.y_axis));
    const float3 _e13 = normalize_moderate(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e13 : parts.direction);
}

float3x3 axes_around(float3 toward, float3 up)
{
    float3 leaning = cross(up, toward);
    float square_2 = dot(leaning, leaning);
    float3 aside = ((abs(toward.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    const float3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), float3(1.0, 0.0, 0.0));
    return float3x3(_e28, cross(toward, _e28), toward);
}

AxesAround ConstructAxesAround(float3 arg0, float3 arg1) {
    AxesAround ret = (AxesAround)0;
    ret.x_axis = arg0;
    ret.y_axis = arg1;
    return ret;
}

AxesAround axes(float3 direction_1, float3 up_1)
{
    const float3x3 _e2 = axes_around(direction_1, up_1);
    const AxesAround axesaround = ConstructAxesAround(_e2[0], _e2[1]);
    return axesaround;
}

float3 half_vector(Light light, float3 view)
{
    float3 half_1 = (light.direction + view);
    const float3 _e4 = any_orthogonal(view);
    const float3 _e9 = normalize_or(((dot(half_1, half_1) > 1e-12) ? half_1 : _e4), view);
    return _e9;
}

float3 stretch_direction(float3 direction_2, float3 x_axis_1, float3 y_axis_1, float x_4, float y)
{
    const DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    const float3 _e10 = direction_moved(_e5, (-(float2(x_4, y)) * _e5.place));
    return _e10;
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

float4 blend_alpha_2_(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return clamp(float4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1)
{
    float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_3, float w_1, ProfileShape shape_2)
{
    float2 place = float2(((u_3.half_sin * shape_2.half_cos_offset) - (u_3.half_cos * shape_2.half_sin_offset)), ((u_3.half_cos * shape_2.half_cos_offset) + (u_3.half_sin * shape_2.half_sin_offset)));
    const float _e19 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_1);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    const float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_4, float w_2, ProfileShape shape_3)
{
    float2 place_1 = float2(((u_4.half_sin * shape_3.half_cos_offset) - (u_4.half_cos * shape_3.half_sin_offset)), ((u_4.half_cos * shape_3.half_cos_offset) + (u_4.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place_1.x, w_2, shape_3);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place_1.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_2);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_3);
    const float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4)
{
    const Angle _e6 = angle_turned_2_(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift_1));
    const Angle _e6 = angle_turned(angle_1, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod((hash.x >> 8u), 3u);
    float a_1 = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_1 : -(a_1)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
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
    int i = int(0);

    float3 corner = floor(p);
    float3 d_1 = (p - corner);
    const float3 _e4 = fade_quintic(d_1);
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
            int3 at = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at)), seed_2);
            const float _e42 = gradient_dot(_e39, (d_1 - float3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, float3 p_1, int octaves, float roughness, int seed_3, float w_3)
{
    float octave = (float)0;
    int i_1 = int(0);
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;

    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e66 = i_1;
            i_1 = asint(asuint(_e66) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e17 = i_1;
        if (!((_e17 < int(2)))) {
            break;
        }
        float _e21 = frequency;
        const float _e25 = eased((w_3 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            float3 place_2 = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_1;
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

float noise_perlin(float3 position, float scale, int octaves_1, float roughness_1, int seed_4)
{
    float3 p_2 = (position * scale);
    const float _e7 = footprint_of_vec3_(p_2);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle turned_from_the_key = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    const float4 _e35 = blend_alpha(float4(0.2275, 0.102, 0.2431, 1.0), float4(0.4824, 0.1843, 0.3882, 1.0), _e22, 1.0, true);
    float3 normal_2 = surface.normal;
    Light _e39 = look.key;
    const float3 _e41 = half_vector(_e39, surface.view);
    const AxesAround _e46 = axes(_e41, float3(0.0, 1.0, 0.0));
    const float3 _e51 = stretch_direction(normal_2, _e46.x_axis, _e46.y_axis, 0.985, 0.0);
    Angle from_the_band = ConstructAngle((0.5 * length((_e51 - _e41))), (0.5 * length((_e51 + _e41))));
    const float _e66 = noise_perlin(surface.position_object, 14.0, int(2), 0.5, int(0));
    float waver = lerp(-0.05, 0.05, (_e66 - 0.0));
    const float _e73 = profile_balanced_2_(from_the_band, waver, band_shape);
    const float4 _e81 = blend_alpha_2_(_e35, float4(0.9529, 0.6627, 0.7059, 1.0), _e73, 0.95, true);
    Light _e84 = look.low;
    const float3 _e86 = half_vector(_e84, surface.view);
    const AxesAround _e91 = axes(_e86, float3(0.0, 1.0, 0.0));
    const float3 _e96 = stretch_direction(normal_2, _e91.x_axis, _e91.y_axis, 0.985, 0.0);
    Angle from_the_second = ConstructAngle((0.5 * length((_e96 - _e86))), (0.5 * length((_e96 + _e86))));
    const float _e107 = profile_balanced_2_(from_the_second, waver, second_band_shape);
    float4 second_band_on_top = clamp(float4((_e81.xyz + (0.8 * ((_e81.xyz + (_e107 * float3(0.3529, 0.2471, 0.549))) - _e81.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return second_band_on_top;
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

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object);
    const float4 _e20 = shade(surface_1);
    return _e20;
}
