// Light that wavers: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// bent-light.json says what to put there and how to draw.
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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light eye;
    Light key;
    float3 parts_direction;
    int _pad4_0;
    float3 axes_of_the_light_x_axis;
    int _pad5_0;
    float3 axes_of_the_light_y_axis;
    int _end_pad_0;
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
static const ProfileShape lit_shape = ConstructProfileShape(0.8253356, 0.5646425, 25.006668, 1.7790966, 1.2, 0.04446849, 0.018017149, 0u);
static const ProfileShape brightest_shape = ConstructProfileShape(0.9358968, 0.35227424, 40.004166, 3.6241908, 0.72, 0.021168118, 0.009611014, 0u);
static const ProfileShape window_shape = ConstructProfileShape(0.9963897, 0.08489768, 0.0, 1.0, 0.17, 0.0, 0.0, 1u);

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

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_3 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_3, u_1.half_cos));
    float2 turned = (((s_3 <= 0.0) & (s_3 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float eased(float x_1, float low, float high)
{
    const float _e3 = bounded(x_1);
    const float _e7 = bounded(((_e3 - low) / 0.5));
    float t_2 = clamp(_e7, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float footprint_of(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d_1 = float2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float footprint_of_vec3_(float3 v_2)
{
    float3 dx_1 = ddx(v_2);
    float3 dy_1 = ddy(v_2);
    const float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
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
    float3 y = (y_axis * rsqrt(max(dot(y_axis, y_axis), 1e-30)));
    const DirectionParts directionparts = ConstructDirectionParts(direction, x_axis, y, float2(dot(direction, x_axis), dot(direction, y)));
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
    float square_1 = dot(leaning, leaning);
    float3 aside = ((abs(toward.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across = ((square_1 > 1e-8) ? leaning : cross(aside, toward));
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

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1)
{
    float width_1 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width_1)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_2, float w_1, ProfileShape shape_2)
{
    float width_2 = sqrt((w_1 * w_1));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_2, 1e-6))), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_2, float w_2, ProfileShape shape_3)
{
    float2 place = float2(((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset)), ((u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place.x, w_2, shape_3);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_2);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    const float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
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
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_3 = (uint3)0;

    v_3 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_3.x;
    uint _e10 = v_3.y;
    uint _e12 = v_3.z;
    v_3.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_3.y;
    uint _e18 = v_3.z;
    uint _e20 = v_3.x;
    v_3.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_3.z;
    uint _e26 = v_3.x;
    uint _e28 = v_3.y;
    v_3.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_3;
    uint3 _e32 = v_3;
    v_3 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_3.x;
    uint _e40 = v_3.y;
    uint _e42 = v_3.z;
    v_3.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_3.y;
    uint _e48 = v_3.z;
    uint _e50 = v_3.x;
    v_3.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_3.z;
    uint _e56 = v_3.x;
    uint _e58 = v_3.y;
    v_3.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_3;
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
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
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
    int i = int(0);

    float3 corner = floor(p);
    float3 d_2 = (p - corner);
    const float3 _e4 = fade_quintic(d_2);
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
            const float _e42 = gradient_dot(_e39, (d_2 - float3(at)));
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
            float3 place_1 = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_1;
            const float _e50 = perlin_noise(place_1, (1u + uint(_e47)));
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

float fractal_noise_2_(uint kind_1, float3 p_2, int octaves_1, float roughness_1, int seed_4, float w_4)
{
    float octave_1 = (float)0;
    int i_2 = int(0);
    float frequency_1 = 1.0;
    float strength_1 = 1.0;
    float total_1 = 0.0;
    float sum_2 = 0.0;

    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e66 = i_2;
            i_2 = asint(asuint(_e66) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e17 = i_2;
        if (!((_e17 < int(2)))) {
            break;
        }
        float _e21 = frequency_1;
        const float _e25 = eased((w_4 * _e21), 0.5, 1.0);
        float visible_1 = (1.0 - _e25);
        octave_1 = 0.5;
        if ((visible_1 > 0.0)) {
            float _e31 = frequency_1;
            int _e33 = i_2;
            float3 place_2 = clamp(((p_2 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_2;
            const float _e50 = perlin_noise(place_2, (5u + uint(_e47)));
            octave_1 = lerp(0.5, _e50, visible_1);
        }
        float _e53 = sum_2;
        float _e54 = strength_1;
        float _e55 = octave_1;
        sum_2 = (_e53 + (_e54 * _e55));
        float _e58 = total_1;
        float _e59 = strength_1;
        total_1 = (_e58 + _e59);
        float _e61 = strength_1;
        strength_1 = (_e61 * roughness_1);
        float _e63 = frequency_1;
        frequency_1 = (_e63 * 2.0);
    }
    float _e69 = sum_2;
    return min((_e69 / 1.5), 1.0);
}

float outer_contour(float width, float3 normal, float3 view, float2 viewport)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport.y, 1.0, 100000.0)) / 1000.0);
    const float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

float noise_perlin(float3 position, float scale, int octaves_2, float roughness_2, int seed_5)
{
    float3 p_3 = (position * scale);
    const float _e7 = footprint_of_vec3_(p_3);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_3, octaves_2, roughness_2, seed_5, _e7);
    return _e8;
}

float noise_perlin_2_(float3 position_1, float scale_1, int octaves_3, float roughness_3, int seed_6)
{
    float3 p_4 = (position_1 * scale_1);
    const float _e7 = footprint_of_vec3_(p_4);
    const float _e8 = fractal_noise_2_(NOISE_PERLIN, p_4, octaves_3, roughness_3, seed_6, _e7);
    return _e8;
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

float4 shade(Surface surface)
{
    float3 place_3 = surface.position_object;
    const float _e6 = noise_perlin(place_3, 3.5, int(2), 0.5, int(1));
    float across_1 = lerp(-0.22, 0.22, (_e6 - 0.0));
    const float _e16 = noise_perlin_2_(place_3, 3.5, int(2), 0.5, int(5));
    float upright = lerp(-0.22, 0.22, (_e16 - 0.0));
    float3 _e24 = look.parts_direction;
    float3 _e27 = look.axes_of_the_light_x_axis;
    float3 _e30 = look.axes_of_the_light_y_axis;
    const DirectionParts _e31 = direction_within(_e24, _e27, _e30);
    const float3 _e33 = direction_moved(_e31, float2(across_1, upright));
    float3 _e37 = look.key.own_direction;
    float3 _e41 = look.key.color;
    float _e45 = look.key.intensity;
    Light bent_light = ConstructLight(_e33, _e37, _e41, _e45);
    Angle turned_from_it = ConstructAngle((0.5 * length((surface.normal - bent_light.direction))), (0.5 * length((surface.normal + bent_light.direction))));
    const float _e62 = profile_balanced(turned_from_it, 0.0, lit_shape);
    const float4 _e75 = blend_alpha(float4(0.1529, 0.251, 0.3765, 1.0), float4(0.3098, 0.5608, 0.6118, 1.0), _e62, 1.0, true);
    const float _e78 = profile_balanced(turned_from_it, 0.0, brightest_shape);
    float4 brightest_light = min(float4((_e75.xyz + (_e78 * (float3(0.6627, 0.8392, 0.7569) - _e75.xyz))), 1.0), (1.0).xxxx);
    float3 view_2_ = surface.view;
    const AxesAround _e98 = axes(view_2_, float3(0.0, 1.0, 0.0));
    const DirectionParts _e101 = direction_within(view_2_, _e98.x_axis, _e98.y_axis);
    const float3 _e105 = direction_moved(_e101, float2(-0.32, 0.36));
    float3 _e109 = look.eye.own_direction;
    float3 _e113 = look.eye.color;
    float _e117 = look.eye.intensity;
    Light locked_to_the_eye = ConstructLight(_e105, _e109, _e113, _e117);
    Angle turned_from_the_eye = ConstructAngle((0.5 * length((surface.normal - locked_to_the_eye.direction))), (0.5 * length((surface.normal + locked_to_the_eye.direction))));
    const float _e134 = profile_balanced_2_(turned_from_the_eye, 0.0, window_shape);
    float4 window_on_top = clamp(float4((brightest_light.xyz + (_e134 * (float3(0.9922, 0.9647, 0.8902) - brightest_light.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    float2 _e156 = look.viewport;
    const float _e157 = outer_contour(3.0, surface.normal, surface.view, _e156);
    float4 outline = clamp(float4((window_on_top.xyz + (_e157 * (float3(0.0784, 0.1294, 0.2275) - window_on_top.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return outline;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_3, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object);
    const float4 _e20 = shade(surface_1);
    return _e20;
}
