// Highlights, cut and joined: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2.
// highlight-cut.json says what to put there and how to draw.
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
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
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
    float3 normal : LOC1;
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

static const ProfileShape lit_side_shape = ConstructProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u);
static const ProfileShape disc_shape = ConstructProfileShape(0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u);
static const ProfileShape bite_shape = ConstructProfileShape(0.9887711, 0.14943813, 0.0, 1.0, 0.3, 0.0, 0.0, 1u);
static const ProfileShape dot_shape = ConstructProfileShape(0.99875027, 0.04997917, 0.0, 1.0, 0.1, 0.0, 0.0, 1u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

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

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
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

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_4 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c = (u_2.half_cos + (u_2.half_sin * 0.0));
    float2 upper_1 = ((c <= 0.0) ? float2(1.0, 0.0) : float2(s_4, c));
    float2 turned_1 = (((s_4 <= 0.0) & (s_4 < c)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_3 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_3;
}

float footprint_of(float x_1)
{
    float _e1 = ddx(x_1);
    float _e2 = ddy(x_1);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float3 any_orthogonal(float3 n)
{
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a_1 = (-1.0 / (sign_ + n.z));
    return float3((1.0 + (((sign_ * n.x) * n.x) * a_1)), (((sign_ * n.x) * n.y) * a_1), (-(sign_) * n.x));
}

Angle angle_between_directions(float3 a, float3 b)
{
    const Angle angle_4 = ConstructAngle((0.5 * length((a - b))), (0.5 * length((a + b))));
    return angle_4;
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

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
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

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_3)
{
    float2 place = float2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
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
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

float rim(Light light_1, float3 normal, float3 view_1, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view_1), 0.0, 1.0);
    const float _e11 = footprint_of(facing);
    float edge = max((width * softness), min(_e11, 1.0));
    float3 aside_1 = (normal - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside_1, aside_1)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    float3 across_1 = (light_1.direction - (dot(light_1.direction, view_1) * view_1));
    float side = dot((normal - (dot(normal, view_1) * view_1)), (across_1 * rsqrt(max(dot(across_1, across_1), 1e-30))));
    return (inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow));
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle turned_from_the_key = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = (1.0 - _e22);
    float4 shadow = float4((float3(0.62, 0.16, 0.26) * lerp((1.0).xxx, float3(0.5, 0.33, 0.56), in_the_dark)), 1.0);
    float3 normal_3 = surface.normal;
    Light _e42 = look.key;
    const float3 _e44 = half_vector(_e42, surface.view);
    const Angle _e45 = angle_between_directions(normal_3, _e44);
    const float _e48 = profile_balanced_2_(_e45, 0.0, disc_shape);
    const AxesAround _e53 = axes(_e44, float3(0.0, 1.0, 0.0));
    const DirectionParts _e56 = direction_within(normal_3, _e53.x_axis, _e53.y_axis);
    const float3 _e60 = direction_moved(_e56, float2(-0.13, 0.13));
    const Angle _e61 = angle_between_directions(_e60, _e44);
    const float _e64 = profile_balanced_2_(_e61, 0.0, bite_shape);
    float crescent = min(_e48, (1.0 - _e64));
    const DirectionParts _e70 = direction_within(normal_3, _e53.x_axis, _e53.y_axis);
    const float3 _e74 = direction_moved(_e70, float2(-0.06, 0.06));
    const Angle _e75 = angle_between_directions(_e74, _e44);
    const float _e78 = profile_balanced_2_(_e75, 0.0, dot_shape);
    float crescent_and_dot = max(crescent, _e78);
    const float4 _e87 = blend_alpha(shadow, float4(1.0, 0.97, 0.9, 1.0), crescent_and_dot, 0.96, true);
    Light _e90 = look.back;
    const float _e96 = rim(_e90, surface.normal, surface.view, 0.42, 0.08, 1.0);
    float rim_in_the_dark_only = min(_e96, in_the_dark);
    float4 rim_s_light = clamp(float4((_e87.xyz + (0.6 * ((_e87.xyz + (rim_in_the_dark_only * float3(1.0, 0.62, 0.5))) - _e87.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return rim_s_light;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.normal = arg2;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_2.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    return _e19;
}
