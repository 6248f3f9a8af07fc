// Comics: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// figure6-comics.json says what to put there and how to draw.
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
    Light key;
    Light rim;
    Light fill;
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

static const ProfileShape key_tone_shape = ConstructProfileShape(0.8472551, 0.5311862, 0.0, 1.0, 1.12, 0.0, 0.0, 1u);
static const ProfileShape bounce_tone_shape = ConstructProfileShape(0.9358968, 0.35227424, 0.0, 1.0, 0.72, 0.0, 0.0, 1u);
static const ProfileShape light_tone_shape = ConstructProfileShape(0.96638995, 0.25708055, 0.0, 1.0, 0.52, 0.0, 0.0, 1u);
static const ProfileShape rim_tone_shape = ConstructProfileShape(0.9130889, 0.40776044, 0.0, 1.0, 0.84, 0.0, 0.0, 1u);
static const ProfileShape highlight_tone_shape = ConstructProfileShape(0.99280864, 0.119712204, 0.0, 1.0, 0.24, 0.0, 0.0, 1u);

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
    float s_1 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return float2(s_1, c);
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
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_1));
    float2 turned = (((s_2 <= 0.0) & (s_2 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope)
{
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
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

Angle parametrization_specular_balanced(Light light_2, float3 normal_1, float3 view)
{
    float3 d = (((2.0 * dot(normal_1, view)) * normal_1) - view);
    const Angle angle_3 = ConstructAngle((0.5 * length((d - light_2.direction))), (0.5 * length((d + light_2.direction))));
    return angle_3;
}

float profile_ramp_quick(float s, float w, ProfileShape shape)
{
    float width = sqrt((w * w));
    float from_offset = (s * (2.0 + ((s * s) * 0.33333334)));
    float ramp = clamp((0.5 + ((0.0 - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_1)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick(((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset)), _e14, shape_1);
    return _e15;
}

float4 shade(Surface surface)
{
    const float _e3 = transition_balanced(surface.kappa, 0.35);
    const float4 _e14 = curvature_color(_e3, float4(0.7059, 0.3412, 0.2902, 1.0), float4(0.2941, 0.1098, 0.2, 1.0));
    Light _e17 = look.key;
    const LitLayer _e19 = light_apply(_e17, _e14, 1.0);
    const float4 _e29 = blend_alpha(float4(0.8863, 0.6275, 0.4353, 1.0), _e19.color, _e19.tone, 1.0, true);
    const float4 _e40 = curvature_color(_e3, float4(0.9529, 0.6902, 0.4392, 1.0), float4(0.7686, 0.3451, 0.2902, 1.0));
    Light _e43 = look.key;
    const Angle _e45 = parametrization_diffuse_balanced(_e43, surface.normal);
    float key_warp = (((2.0 * _e3) - 1.0) * 0.45);
    const float _e53 = profile_balanced(_e45, key_warp, key_tone_shape);
    Light _e56 = look.key;
    const LitLayer _e57 = light_apply(_e56, _e40, _e53);
    const float4 _e62 = blend_alpha(_e29, _e57.color, _e57.tone, 1.0, true);
    const float _e65 = transition_balanced(surface.kappa, 0.3);
    const float4 _e76 = curvature_color(_e65, float4(0.8157, 0.4863, 0.3686, 1.0), float4(0.549, 0.2275, 0.298, 1.0));
    Light _e79 = look.fill;
    const Angle _e81 = parametrization_diffuse_balanced(_e79, surface.normal);
    float bounce_warp = (((2.0 * _e65) - 1.0) * 0.35);
    const float _e89 = profile_balanced(_e81, bounce_warp, bounce_tone_shape);
    Light _e92 = look.fill;
    const LitLayer _e93 = light_apply(_e92, _e76, _e89);
    const float4 _e98 = blend_alpha(_e62, _e93.color, _e93.tone, 1.0, true);
    const float4 _e109 = curvature_color(_e65, float4(1.0, 0.851, 0.6275, 1.0), float4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = (((2.0 * _e65) - 1.0) * 0.3);
    const float _e117 = profile_balanced(_e45, light_warp, light_tone_shape);
    Light _e120 = look.key;
    const LitLayer _e121 = light_apply(_e120, _e109, _e117);
    const float4 _e126 = blend_alpha(_e98, _e121.color, _e121.tone, 1.0, true);
    const float _e129 = transition_balanced(surface.kappa, 0.25);
    const float4 _e140 = curvature_color(_e129, float4(1.0, 0.9569, 0.8627, 1.0), float4(0.949, 0.6588, 0.4196, 1.0));
    Light _e143 = look.rim;
    const Angle _e145 = parametrization_diffuse_balanced(_e143, surface.normal);
    float rim_warp = (((2.0 * _e129) - 1.0) * 0.2);
    const float _e153 = profile_balanced(_e145, rim_warp, rim_tone_shape);
    Light _e156 = look.rim;
    const LitLayer _e157 = light_apply(_e156, _e140, _e153);
    const float4 _e162 = blend_alpha(_e126, _e157.color, _e157.tone, 1.0, true);
    const float4 _e173 = curvature_color(_e129, float4(1.0, 0.9804, 0.9412, 1.0), float4(1.0, 0.8863, 0.7216, 1.0));
    Light _e176 = look.key;
    const Angle _e179 = parametrization_specular_balanced(_e176, surface.normal, surface.view);
    float highlight_warp = (((2.0 * _e129) - 1.0) * 0.1);
    const float _e187 = profile_balanced(_e179, highlight_warp, highlight_tone_shape);
    Light _e190 = look.key;
    const LitLayer _e191 = light_apply(_e190, _e173, _e187);
    const float4 _e196 = blend_alpha(_e162, _e191.color, _e191.tone, 1.0, true);
    return _e196;
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
