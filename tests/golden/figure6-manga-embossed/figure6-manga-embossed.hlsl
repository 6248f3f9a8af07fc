// Manga, embossed: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// figure6-manga-embossed.json says what to put there and how to draw.
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
    Light above;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light below;
};

struct Surface {
    float3 normal;
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

static const ProfileShape dark_side_tone_shape = ConstructProfileShape(0.9624252, 0.27154693, 5.0334897, 2.4651666, 0.55, 0.19658314, 0.08474467, 0u);
static const ProfileShape light_side_tone_shape = ConstructProfileShape(0.9689124, 0.24740396, 5.743557, 2.3650649, 0.5, 0.17491564, 0.07484149, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

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
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
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
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color, float tone)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
    return litlayer;
}

Angle parametrization_screen_aligned_balanced(Light light_1, float3 normal, float3x3 camera_from_world)
{
    float3 d = mul(normal, camera_from_world);
    const Angle angle_2 = ConstructAngle((0.5 * length((d - light_1.own_direction))), (0.5 * length((d + light_1.own_direction))));
    return angle_2;
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
    bool is_narrow = ((w_1 > 0.0) & (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place.x, w_1, shape_2);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_1);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    const float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_3)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

float4 shade(Surface surface)
{
    float light_side_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.3), -20.0, 20.0))))))));
    const float4 _e30 = curvature_color(light_side_convexity, float4(0.4275, 0.4078, 0.4745, 1.0), float4(0.2275, 0.2078, 0.2784, 1.0));
    Light _e33 = look.below;
    float3x3 _e37 = look.camera_from_world;
    const Angle _e38 = parametrization_screen_aligned_balanced(_e33, surface.normal, _e37);
    float light_side_warp = (((2.0 * light_side_convexity) - 1.0) * 0.35);
    const float _e46 = profile_balanced(_e38, light_side_warp, dark_side_tone_shape);
    Light _e49 = look.below;
    const LitLayer _e50 = light_apply(_e49, _e30, _e46);
    float4 dark_side_blend = clamp(float4((float3(0.851, 0.8314, 0.7804) * lerp((1.0).xxx, _e50.color.xyz, _e50.tone)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float4 _e76 = curvature_color(light_side_convexity, (1.0).xxxx, float4(0.9529, 0.9176, 0.8471, 1.0));
    Light _e79 = look.above;
    float3x3 _e83 = look.camera_from_world;
    const Angle _e84 = parametrization_screen_aligned_balanced(_e79, surface.normal, _e83);
    const float _e86 = profile_balanced(_e84, light_side_warp, light_side_tone_shape);
    Light _e89 = look.above;
    const LitLayer _e90 = light_apply(_e89, _e76, _e86);
    float4 light_side_blend = clamp(float4((dark_side_blend.xyz + (_e90.tone * (_e90.color.xyz - dark_side_blend.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    float hollows_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.4), -20.0, 20.0))))))));
    const float4 _e132 = curvature_color(hollows_convexity, (1.0).xxxx, float4(0.4667, 0.4392, 0.5412, 1.0));
    Light _e135 = look.above;
    const LitLayer _e137 = light_apply(_e135, _e132, 1.0);
    float4 hollows_blend = clamp(float4((light_side_blend.xyz + (0.8 * ((light_side_blend.xyz * (_e137.tone * _e137.color.xyz)) - light_side_blend.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return hollows_blend;
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

Surface ConstructSurface(float3 arg0, float arg1) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.kappa = arg1;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e11 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_3, _e11.x);
    const float4 _e14 = shade(surface_1);
    return _e14;
}
