// Far and turned: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// far-and-turned.json says what to put there and how to draw.
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

struct Look {
    float4 back_light_color_convex;
    Light back;
    ProfileShape back_light_tone_shape;
    float4 highlight_color_convex;
    Light key;
    float4 body_color_convex;
    ProfileShape body_tone_shape;
    float4 shadow;
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

struct LitLayer {
    float4 color;
    float tone;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
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

static const float LOG2_E = 1.442695;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const ProfileShape highlight_tone_shape = ConstructProfileShape(0.9971888, 0.07492971, 5.743557, 3.1871848, 0.15, 0.1556229, 0.06963291, 0u);

cbuffer view_1 : register(b0) { View view_1; }
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

float4 finite_vec4_(float4 v)
{
    uint4 exponent_1 = (2139095040u).xxxx;
    return (((asuint(v) & exponent_1) != exponent_1) ? v : (0.0).xxxx);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float log2_one_minus(float y)
{
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
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
    float s_4 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_4, u_1.half_cos));
    float2 turned = (((s_4 <= 0.0) & (s_4 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, (0.0).xxxx, (1.0).xxxx);
}

float4 blend_alpha(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_1)
{
    float a = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a) * (1.0 - below_1.w)));
    const float4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a, clamped_1);
    return _e20;
}

float2 light_split(float intensity)
{
    return float2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_1, float tone_1)
{
    const float2 _e4 = light_split(light.intensity);
    const LitLayer litlayer = ConstructLitLayer(float4(((color_1.xyz * light.color) * _e4.y), color_1.w), (tone_1 * _e4.x));
    return litlayer;
}

Angle parametrization_specular_balanced(Light light_1, float3 normal, float3 view)
{
    float3 d = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_3 = ConstructAngle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
    return angle_3;
}

float profile_power_quick(float q, float exponent)
{
    float y_1 = min((q * q), 1.0);
    const float _e5 = log2_one_minus(y_1);
    float power = exp2(max((exponent * _e5), -126.0));
    return ((q >= 1.0) ? 0.0 : clamp(power, 0.0, 1.0));
}

float2 profile_place(Angle u_2, ProfileShape shape)
{
    return float2(((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset)), ((u_2.half_cos * shape.half_cos_offset) + (u_2.half_sin * shape.half_sin_offset)));
}

float profile_soft_quick(float s, ProfileShape shape_1)
{
    const float _e5 = profile_power_quick((s * shape_1.scale), shape_1.exponent);
    return ((s <= 0.0) ? 1.0 : _e5);
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_2)
{
    float q_1 = (s_1 * shape_2.scale);
    return ((s_1 <= 0.0) ? 1.0 : pow(max((1.0 - (q_1 * q_1)), 0.0), shape_2.exponent));
}

float profile_ramp_quick(float s_2, float w, ProfileShape shape_3)
{
    float width = sqrt(((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
    float from_offset = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_3.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_3, float w_1, ProfileShape shape_4)
{
    float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
    float from_offset_1 = (s_3 * (2.0 + ((s_3 * s_3) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((shape_4.edge_mean - from_offset_1) / width_1)), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_3 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_5)
{
    if ((shape_5.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    const float2 _e7 = profile_place(u_3, shape_5);
    bool is_narrow = ((w_2 > 0.0) & (w_2 >= (3.4641016 * shape_5.edge_deviation)));
    if (((shape_5.kind == PROFILE_STEP) | is_narrow)) {
        const float _e20 = profile_ramp_quick(_e7.x, w_2, shape_5);
        return _e20;
    }
    const float _e22 = profile_soft_quick(_e7.x, shape_5);
    if ((w_2 < (0.1 * shape_5.edge_deviation))) {
        return _e22;
    }
    float r = (0.19364917 * w_2);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_5);
    const float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_5);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_4, float w_3, ProfileShape shape_6)
{
    float2 place = float2(((u_4.half_sin * shape_6.half_cos_offset) - (u_4.half_cos * shape_6.half_sin_offset)), ((u_4.half_cos * shape_6.half_cos_offset) + (u_4.half_sin * shape_6.half_sin_offset)));
    bool is_narrow_1 = ((w_3 > 0.0) & (w_3 >= (3.4641016 * shape_6.edge_deviation)));
    if ((false | is_narrow_1)) {
        const float _e28 = profile_ramp_quick_2_(place.x, w_3, shape_6);
        return _e28;
    }
    const float _e30 = profile_soft_quick_2_(place.x, shape_6);
    if ((w_3 < (0.1 * shape_6.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_3);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e56 = profile_soft_quick_2_(((place.x * turn_1.y) - (place.y * turn_1.x)), shape_6);
    const float _e64 = profile_soft_quick_2_(((place.x * turn_1.y) + (place.y * turn_1.x)), shape_6);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_7)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_8)
{
    const Angle _e6 = angle_turned(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_8);
    return _e8;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle body_angle = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    ProfileShape _e23 = look.body_tone_shape;
    const float _e24 = profile_balanced(body_angle, 0.0, _e23);
    Light _e27 = look.key;
    float4 _e30 = look.body_color_convex;
    const LitLayer _e31 = light_apply(_e27, _e30, _e24);
    float4 _e34 = look.shadow;
    float4 _e37 = look.shadow;
    float4 _e44 = look.shadow;
    float _e52 = look.shadow.w;
    float _e60 = look.shadow.w;
    const float4 _e68 = blend_finish(_e34, (_e37.xyz + (_e31.tone * (_e31.color.xyz - _e44.xyz))), (_e52 + ((_e31.tone * _e31.color.w) * (1.0 - _e60))), _e31.color.w, true);
    Light _e71 = look.key;
    const Angle _e74 = parametrization_specular_balanced(_e71, surface.normal, surface.view);
    const float _e77 = profile_balanced_2_(_e74, 0.0, highlight_tone_shape);
    Light _e80 = look.key;
    float4 _e83 = look.highlight_color_convex;
    const LitLayer _e84 = light_apply(_e80, _e83, _e77);
    const float4 _e89 = blend_alpha(_e68, _e84.color, _e84.tone, 0.8, true);
    float3 _e94 = look.back.direction;
    float3 _e103 = look.back.direction;
    Angle back_light_angle = ConstructAngle((0.5 * length((surface.normal - _e94))), (0.5 * length((surface.normal + _e103))));
    ProfileShape _e112 = look.back_light_tone_shape;
    const float _e113 = profile_balanced(back_light_angle, 0.0, _e112);
    Light _e116 = look.back;
    float4 _e119 = look.back_light_color_convex;
    const LitLayer _e120 = light_apply(_e116, _e119, _e113);
    const float4 _e131 = blend_finish(_e89, (_e89.xyz + (_e120.tone * _e120.color.xyz)), _e89.w, _e120.color.w, true);
    const float4 _e142 = finite_vec4_(((_e131.w <= 0.0) ? _e131 : float4((_e131.xyz / (_e131.w).xxx), _e131.w)));
    return _e142;
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
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    const float4 _e20 = finite_vec4_(_e19);
    return _e20;
}
