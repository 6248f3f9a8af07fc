// Anime face: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// anime-face.json says what to put there and how to draw.
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
    Light back;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
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

struct VectorParts {
    float x;
    float y;
    float z;
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

static const ProfileShape edge_of_the_shadow_shape = ConstructProfileShape(0.7960838, 0.6051864, 15.395454, 2.8429606, 1.3, 0.060679536, 0.026670605, 0u);
static const ProfileShape lit_shape = ConstructProfileShape(0.7775727, 0.628793, 0.0, 1.0, 1.36, 0.0, 0.0, 1u);
static const ProfileShape shine_tone_shape = ConstructProfileShape(0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u);
static const ProfileShape rim_light_tone_shape = ConstructProfileShape(0.90896577, 0.4168708, 0.0, 1.0, 0.86, 0.0, 0.0, 1u);
static const ProfileShape contour_tone_shape = ConstructProfileShape(0.819648, 0.57286745, 0.0, 1.0, 1.22, 0.0, 0.0, 1u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) & true))) {
        return otherwise;
    }
    float3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    return (((asuint(square) & 2139095040u) == 2139095040u) ? otherwise : (scaled * (1.0 / sqrt(square))));
}

float3 normalize_quick(float3 v_1, float3 otherwise_1)
{
    float square_1 = dot(v_1, v_1);
    bool is_usable = ((square_1 > 1e-30) & true);
    return (is_usable ? (v_1 * rsqrt((is_usable ? square_1 : 1.0))) : otherwise_1);
}

float3 normalize_seen_balanced(float3 v_2)
{
    return (v_2 * rsqrt(max(dot(v_2, v_2), 1e-30)));
}

float2 sin_cos_quick(float x)
{
    float y = (x * x);
    float s_3 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return float2(s_3, c);
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
    float s_4 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_4, c_1));
    float2 turned = (((s_4 <= 0.0) & (s_4 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_5 = (u_2.half_sin - 0.0);
    float2 upper_1 = ((u_2.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_5, u_2.half_cos));
    float2 turned_1 = (((s_5 <= 0.0) & (s_5 < u_2.half_cos)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_4 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_4;
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
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_shade(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return min(float4((below_1.xyz + (opacity_1 * ((below_1.xyz * lerp((1.0).xxx, color_1.xyz, tone_1)) - below_1.xyz))), 1.0), (1.0).xxxx);
}

float4 blend_shade_2_(float4 below_2, float4 color_2, float tone_2, float opacity_2, bool clamped_2)
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
    const LitLayer litlayer = ConstructLitLayer(float4(((color_3.xyz * light.color) * split.y), 1.0), split.x);
    return litlayer;
}

LitLayer light_apply_2_(Light light_1, float4 color_4, float tone_4)
{
    float2 split_1 = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer_1 = ConstructLitLayer(float4((light_1.color * split_1.y), 1.0), (tone_4 * split_1.x));
    return litlayer_1;
}

LitLayer light_apply_3_(Light light_2, float4 color_5, float tone_5)
{
    float2 split_2 = float2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    const LitLayer litlayer_2 = ConstructLitLayer(float4(((color_5.xyz * light_2.color) * split_2.y), 1.0), (tone_5 * split_2.x));
    return litlayer_2;
}

Angle parametrization_diffuse_balanced(Light light_3, float3 normal)
{
    const float3 _e6 = normalize_quick(normal, float3(0.0, 0.0, 1.0));
    const Angle angle_5 = ConstructAngle((0.5 * length((_e6 - light_3.direction))), (0.5 * length((_e6 + light_3.direction))));
    return angle_5;
}

Angle parametrization_specular_balanced(Light light_4, float3 normal_1, float3 view)
{
    float3 d = (((2.0 * dot(normal_1, view)) * normal_1) - view);
    const Angle angle_6 = ConstructAngle((0.5 * length((d - light_4.direction))), (0.5 * length((d + light_4.direction))));
    return angle_6;
}

Angle parametrization_screen_aligned_balanced(Light light_5, float3 normal_2, float3x3 camera_from_world)
{
    float3 d_1 = mul(normal_2, camera_from_world);
    const Angle angle_7 = ConstructAngle((0.5 * length((d_1 - light_5.own_direction))), (0.5 * length((d_1 + light_5.own_direction))));
    return angle_7;
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

float profile_ramp_quick_2_(float s_2, float w_1, ProfileShape shape_2)
{
    float width_1 = sqrt((w_1 * w_1));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_1, 1e-6))), 0.0, 1.0);
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
    const Angle _e6 = angle_turned_2_(angle, float2(0.0, 1.0));
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

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_6)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift_2));
    const Angle _e6 = angle_turned(angle_2, _e5);
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_6.half_cos_offset) - (_e6.half_cos * shape_6.half_sin_offset)), _e14, shape_6);
    return _e15;
}

VectorParts ConstructVectorParts(float arg0, float arg1, float arg2) {
    VectorParts ret = (VectorParts)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

float4 shade(Surface surface)
{
    float3 place_1 = surface.position_object;
    float3 from_the_face_s_middle = (place_1 - float3(0.0, 0.52, -0.18));
    float3 flattened = (from_the_face_s_middle * float3(1.0, 0.35, 1.0));
    const float3 _e14 = normalize_or(flattened, (0.0).xxx);
    VectorParts high = ConstructVectorParts(place_1.x, place_1.y, place_1.z);
    float is_face = smoothstep(0.02, 0.16, high.y);
    float3 face_or_body = lerp(surface.normal, _e14, is_face);
    float3 shading_direction = (face_or_body * rsqrt(max(dot(face_or_body, face_or_body), 1e-30)));
    Light _e32 = look.key;
    const Angle _e33 = parametrization_diffuse_balanced(_e32, shading_direction);
    const float _e36 = profile_balanced(_e33, 0.0, edge_of_the_shadow_shape);
    float soft_dark = (1.0 - _e36);
    const float4 _e51 = blend_shade(float4(0.9843, 0.8902, 0.8118, 1.0), float4(0.9412, 0.5412, 0.4157, 1.0), soft_dark, 0.55, true);
    const float _e54 = profile_balanced_2_(_e33, 0.0, lit_shape);
    float in_shadow = (1.0 - _e54);
    const float4 _e64 = blend_shade_2_(_e51, float4(0.698, 0.4784, 0.6588, 1.0), in_shadow, 0.85, true);
    const float _e67 = transition_balanced(surface.kappa, 0.55);
    const float4 _e75 = curvature_color(_e67, (1.0).xxxx, float4(0.2902, 0.1412, 0.251, 1.0));
    Light _e78 = look.eye;
    const LitLayer _e80 = light_apply(_e78, _e75, 1.0);
    float4 inked_hollows_blend = clamp(float4((_e64.xyz + (0.9 * ((_e64.xyz * (_e80.tone * _e80.color.xyz)) - _e64.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    Light _e102 = look.key;
    const Angle _e105 = parametrization_specular_balanced(_e102, surface.normal, surface.view);
    const float _e108 = transition_balanced(surface.kappa, 0.2);
    float shine_warp = (((2.0 * _e108) - 1.0) * 0.05);
    const float _e116 = profile_balanced_3_(_e105, shine_warp, shine_tone_shape);
    Light _e119 = look.key;
    const LitLayer _e122 = light_apply_2_(_e119, (1.0).xxxx, _e116);
    const float4 _e127 = blend_alpha(inked_hollows_blend, _e122.color, _e122.tone, 0.85, true);
    float3 _e132 = look.back.direction;
    float3 _e141 = look.back.direction;
    Angle rim_light_angle = ConstructAngle((0.5 * length((surface.normal - _e132))), (0.5 * length((surface.normal + _e141))));
    float rim_light_warp = (((2.0 * _e108) - 1.0) * 0.15);
    const float _e154 = profile_balanced_3_(rim_light_angle, rim_light_warp, rim_light_tone_shape);
    Light _e157 = look.back;
    const LitLayer _e163 = light_apply_3_(_e157, float4(1.0, 0.9647, 0.9176, 1.0), _e154);
    const float4 _e168 = blend_alpha(_e127, _e163.color, _e163.tone, 0.9, true);
    Light _e171 = look.eye;
    float3x3 _e175 = look.camera_from_world;
    const Angle _e176 = parametrization_screen_aligned_balanced(_e171, surface.normal, _e175);
    const float _e179 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = (((2.0 * _e179) - 1.0) * 0.28);
    const float _e187 = profile_balanced_3_(_e176, contour_warp, contour_tone_shape);
    Light _e190 = look.eye;
    const LitLayer _e193 = light_apply_2_(_e190, (1.0).xxxx, _e187);
    float4 contour_blend = clamp(float4((_e168.xyz * (_e193.tone * _e193.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    return contour_blend;
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

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    ret.kappa = arg3;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_5 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e24 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_5, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x);
    const float4 _e27 = shade(surface_1);
    return _e27;
}
