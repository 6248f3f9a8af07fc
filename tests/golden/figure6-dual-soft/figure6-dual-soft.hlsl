// Dual lighting, soft: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// figure6-dual-soft.json says what to put there and how to draw.
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
    Light warm;
    Light cool;
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

static const ProfileShape warm_side_tone_shape = ConstructProfileShape(0.9971888, 0.07492971, 1.3940078, 1.4345639, 0.15, 0.90231395, 0.36981526, 0u);
static const ProfileShape cool_side_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.5079876, 1.4054453, 0.1, 0.83293223, 0.33645248, 0u);
static const ProfileShape sheen_tone_shape = ConstructProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

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
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope)
{
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
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

Angle parametrization_specular_balanced(Light light_1, float3 normal, float3 view)
{
    float3 d = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_3 = ConstructAngle((0.5 * length((d - light_1.direction))), (0.5 * length((d + light_1.direction))));
    return angle_3;
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

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_2)
{
    float2 place = float2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
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

float profile_filtered_quick_2_(Angle u_3, float w_2, ProfileShape shape_3)
{
    float2 place_1 = float2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
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
    const float2 _e5 = sin_cos_quick((0.5 * shift_1));
    const Angle _e6 = angle_turned(angle_1, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

float4 shade(Surface surface)
{
    const float _e3 = transition_balanced(surface.kappa, 0.25);
    const float4 _e14 = curvature_color(_e3, float4(0.1137, 0.0941, 0.1333, 1.0), float4(0.0392, 0.0314, 0.0549, 1.0));
    Light _e17 = look.warm;
    const LitLayer _e19 = light_apply(_e17, _e14, 1.0);
    const float4 _e29 = blend_add(float4(0.051, 0.0431, 0.0706, 1.0), _e19.color, _e19.tone, 1.0, true);
    const float _e32 = transition_balanced(surface.kappa, 0.22);
    const float4 _e43 = curvature_color(_e32, float4(0.851, 0.5451, 0.3059, 1.0), float4(0.4784, 0.1843, 0.1333, 1.0));
    float3 _e48 = look.warm.direction;
    float3 _e57 = look.warm.direction;
    Angle warm_side_angle = ConstructAngle((0.5 * length((surface.normal - _e48))), (0.5 * length((surface.normal + _e57))));
    float warm_side_warp = (((2.0 * _e32) - 1.0) * 0.3);
    const float _e70 = profile_balanced(warm_side_angle, warm_side_warp, warm_side_tone_shape);
    Light _e73 = look.warm;
    const LitLayer _e74 = light_apply(_e73, _e43, _e70);
    const float4 _e79 = blend_add(_e29, _e74.color, _e74.tone, 1.0, true);
    const float4 _e90 = curvature_color(_e32, float4(0.3098, 0.498, 0.7216, 1.0), float4(0.1098, 0.1922, 0.3412, 1.0));
    float3 _e95 = look.cool.direction;
    float3 _e104 = look.cool.direction;
    Angle cool_side_angle = ConstructAngle((0.5 * length((surface.normal - _e95))), (0.5 * length((surface.normal + _e104))));
    float cool_side_warp = (((2.0 * _e32) - 1.0) * 0.25);
    const float _e117 = profile_balanced(cool_side_angle, cool_side_warp, cool_side_tone_shape);
    Light _e120 = look.cool;
    const LitLayer _e121 = light_apply(_e120, _e90, _e117);
    const float4 _e126 = blend_add(_e79, _e121.color, _e121.tone, 1.0, true);
    const float _e129 = transition_balanced(surface.kappa, 0.2);
    const float4 _e140 = curvature_color(_e129, float4(0.4196, 0.3176, 0.2196, 1.0), float4(0.2, 0.1373, 0.1098, 1.0));
    Light _e143 = look.warm;
    const Angle _e146 = parametrization_specular_balanced(_e143, surface.normal, surface.view);
    float sheen_warp = (((2.0 * _e129) - 1.0) * 0.1);
    const float _e154 = profile_balanced_2_(_e146, sheen_warp, sheen_tone_shape);
    Light _e157 = look.warm;
    const LitLayer _e158 = light_apply(_e157, _e140, _e154);
    const float4 _e163 = blend_add(_e126, _e158.color, _e158.tone, 1.0, true);
    return _e163;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e23 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x);
    const float4 _e26 = shade(surface_1);
    return _e26;
}
