// Bone, subdued: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// figure7-bone.json says what to put there and how to draw.
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
    Light eye;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light key;
    Light side;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    float kappa;
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

static const ProfileShape tone_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.1528398, 1.361735, 0.1, 1.1474836, 0.4845149, 0u);
static const ProfileShape shade_tone_shape = ConstructProfileShape(0.9950042, 0.099833414, 1.4670527, 1.847488, 0.2, 0.7777539, 0.33241227, 0u);
static const ProfileShape light_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 2.9163208, 3.0838382, 0.1, 0.3121117, 0.13987324, 0u);
static const ProfileShape edge_tone_shape = ConstructProfileShape(0.8525245, 0.52268726, 5.0334897, 2.4651666, 1.1, 0.19658314, 0.08474467, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float3 normalize_seen_balanced(float3 v)
{
    return (v * rsqrt(max(dot(v, v), 1e-30)));
}

float2 sin_cos_quick(float x)
{
    float y = (x * x);
    float s_2 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return float2(s_2, c);
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
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_3, c_1));
    float2 turned = (((s_3 <= 0.0) & (s_3 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_4 = (u_2.half_sin - 0.0);
    float2 upper_1 = ((u_2.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_4, u_2.half_cos));
    float2 turned_1 = (((s_4 <= 0.0) & (s_4 < u_2.half_cos)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_4 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_4;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_alpha_2_(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return clamp(float4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_shade(float4 below_2, float4 color_2, float tone_2, float opacity_2, bool clamped_2)
{
    return clamp(float4((below_2.xyz + (opacity_2 * ((below_2.xyz * lerp((1.0).xxx, color_2.xyz, tone_2)) - below_2.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_3, float tone_3)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_3.xyz * light.color) * split.y), 1.0), (tone_3 * split.x));
    return litlayer;
}

Angle parametrization_specular_balanced(Light light_1, float3 normal, float3 view)
{
    float3 d = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_5 = ConstructAngle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
    return angle_5;
}

Angle parametrization_screen_aligned_balanced(Light light_2, float3 normal_1, float3x3 camera_from_world)
{
    float3 d_1 = mul(normal_1, camera_from_world);
    const Angle angle_6 = ConstructAngle((0.5 * length((d_1 - light_2.own_direction))), (0.5 * length((d_1 + light_2.own_direction))));
    return angle_6;
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
    const float2 _e5 = sin_cos_quick((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5)
{
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_6)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift_2));
    const Angle _e6 = angle_turned(angle_2, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_6);
    return _e8;
}

float4 shade(Surface surface)
{
    float light_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.2), -20.0, 20.0))))))));
    const float4 _e30 = curvature_color(light_convexity, float4(0.9373, 0.9137, 0.8627, 1.0), float4(0.7216, 0.6706, 0.5882, 1.0));
    float3 _e35 = look.key.direction;
    float3 _e44 = look.key.direction;
    Angle tone_angle = ConstructAngle((0.5 * length((surface.normal - _e35))), (0.5 * length((surface.normal + _e44))));
    float tone_warp = (((2.0 * light_convexity) - 1.0) * 0.3);
    const float _e57 = profile_balanced(tone_angle, tone_warp, tone_tone_shape);
    Light _e60 = look.key;
    const LitLayer _e61 = light_apply(_e60, _e30, _e57);
    const float4 _e71 = blend_alpha(float4(0.7255, 0.698, 0.6431, 1.0), _e61.color, _e61.tone, 1.0, true);
    const float4 _e82 = curvature_color(light_convexity, float4(0.8118, 0.7765, 0.7137, 1.0), float4(0.5608, 0.5098, 0.4392, 1.0));
    float3 _e87 = look.side.direction;
    float3 _e96 = look.side.direction;
    Angle shade_angle = ConstructAngle((0.5 * length((surface.normal - _e87))), (0.5 * length((surface.normal + _e96))));
    float shade_warp = (((2.0 * light_convexity) - 1.0) * -0.2);
    const float _e109 = profile_balanced(shade_angle, shade_warp, shade_tone_shape);
    Light _e112 = look.side;
    const LitLayer _e113 = light_apply(_e112, _e82, _e109);
    const float4 _e118 = blend_shade(_e71, _e113.color, _e113.tone, 0.8, true);
    Light _e121 = look.key;
    const Angle _e124 = parametrization_specular_balanced(_e121, surface.normal, surface.view);
    const float _e127 = profile_balanced_2_(_e124, 0.0, light_tone_shape);
    Light _e130 = look.key;
    const LitLayer _e133 = light_apply(_e130, (1.0).xxxx, _e127);
    const float4 _e138 = blend_alpha_2_(_e118, _e133.color, _e133.tone, 0.6, true);
    Light _e141 = look.eye;
    float3x3 _e145 = look.camera_from_world;
    const Angle _e146 = parametrization_screen_aligned_balanced(_e141, surface.normal, _e145);
    float edge_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.1), -20.0, 20.0))))))));
    float edge_warp = (((2.0 * edge_convexity) - 1.0) * 0.2);
    const float _e173 = profile_balanced_3_(_e146, edge_warp, edge_tone_shape);
    Light _e176 = look.eye;
    const LitLayer _e179 = light_apply(_e176, (1.0).xxxx, _e173);
    float4 edge_blend = clamp(float4((_e138.xyz + (0.55 * ((_e138.xyz * (_e179.tone * _e179.color.xyz)) - _e138.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return edge_blend;
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
    float4x4 _e10 = view_1.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.kappa = arg2;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e23 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x);
    const float4 _e26 = shade(surface_1);
    return _e26;
}
