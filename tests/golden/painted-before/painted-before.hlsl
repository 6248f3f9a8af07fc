// Painted light, before: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// painted-before.json says what to put there and how to draw.
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
    Light lamp;
    Light window;
};

struct Surface {
    float3 normal;
    int _end_pad_0;
};

struct Angle {
    float half_sin;
    float half_cos;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 normal : LOC0;
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

static const ProfileShape body_tone_shape = ConstructProfileShape(0.9921977, 0.12467473, 1.2081645, 1.573837, 0.25, 1.0277877, 0.44035247, 0u);
static const ProfileShape light_tone_shape = ConstructProfileShape(0.9950042, 0.099833414, 2.0858297, 2.2877648, 0.2, 0.49455804, 0.21395217, 0u);
static const ProfileShape behind_tone_shape = ConstructProfileShape(0.9921977, 0.12467473, 2.425296, 2.1444545, 0.25, 0.43399706, 0.1847509, 0u);

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

float3 normalize_seen_balanced(float3 v)
{
    return (v * rsqrt(max(dot(v, v), 1e-30)));
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_1 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_1, u_1.half_cos));
    float2 turned = (((s_1 <= 0.0) & (s_1 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
}

float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (tone * color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_1, float tone_1)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
    return litlayer;
}

Angle parametrization_diffuse_balanced(Light light_1, float3 normal)
{
    const Angle angle_2 = ConstructAngle((0.5 * length((normal - light_1.direction))), (0.5 * length((normal + light_1.direction))));
    return angle_2;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1)
{
    float2 place = float2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    const float _e19 = profile_soft_quick(place.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    const float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

float4 shade(Surface surface)
{
    Light _e3 = look.window;
    const Angle _e5 = parametrization_diffuse_balanced(_e3, surface.normal);
    const float _e8 = profile_balanced(_e5, 0.0, body_tone_shape);
    Light _e11 = look.window;
    const LitLayer _e17 = light_apply(_e11, float4(0.42, 0.38, 0.38, 1.0), _e8);
    const float4 _e27 = blend_add(float4(0.2, 0.18, 0.22, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = look.lamp;
    const Angle _e32 = parametrization_diffuse_balanced(_e30, surface.normal);
    const float _e35 = profile_balanced(_e32, 0.0, light_tone_shape);
    Light _e38 = look.lamp;
    const LitLayer _e44 = light_apply(_e38, float4(0.14, 0.13, 0.12, 1.0), _e35);
    const float4 _e49 = blend_add(_e27, _e44.color, _e44.tone, 1.0, true);
    Light _e52 = look.back;
    const Angle _e54 = parametrization_diffuse_balanced(_e52, surface.normal);
    const float _e57 = profile_balanced(_e54, 0.0, behind_tone_shape);
    Light _e60 = look.back;
    const LitLayer _e66 = light_apply(_e60, float4(0.08, 0.09, 0.1, 1.0), _e57);
    const float4 _e71 = blend_add(_e49, _e66.color, _e66.tone, 1.0, true);
    return _e71;
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

Surface ConstructSurface(float3 arg0) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = ConstructSurface(normal_3);
    const float4 _e7 = shade(surface_1);
    return _e7;
}
