// Directional control: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// figure5-directional.json says what to put there and how to draw.
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
    float4 highlight_color_convex;
    float4 highlight_color_concave;
    Light key;
    float4 back_light_color_convex;
    float4 back_light_color_concave;
    float back_light_warp_amount;
    int _pad6_0;
    int _pad6_1;
    int _pad6_2;
    Light back;
    ProfileShape back_light_tone_shape;
    ProfileShape diffuse_tone_shape;
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

static const float PI = 3.1415927;
static const float LOG2_E = 1.442695;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const ProfileShape highlight_tone_shape = ConstructProfileShape(0.9959527, 0.08987855, 11.126125, 3.022525, 0.18, 0.08196669, 0.036355104, 0u);

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
    float y_1 = (x * x);
    float s_5 = (x * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return float2(s_5, c);
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
    float s_6 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_6, c_1));
    float2 turned = (((s_6 <= 0.0) & (s_6 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, (0.0).xxxx, (1.0).xxxx);
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

LitLayer light_apply(Light light, float4 color, float tone)
{
    const float2 _e4 = light_split(light.intensity);
    const LitLayer litlayer = ConstructLitLayer(float4(((color.xyz * light.color) * _e4.y), color.w), (tone * _e4.x));
    return litlayer;
}

LitLayer light_apply_2_(Light light_1, float4 color_1, float tone_1)
{
    float2 split = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer_1 = ConstructLitLayer(float4(((color_1.xyz * light_1.color) * split.y), 1.0), split.x);
    return litlayer_1;
}

LitLayer light_apply_3_(Light light_2, float4 color_2, float tone_2)
{
    float2 split_1 = float2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    const LitLayer litlayer_2 = ConstructLitLayer(float4(((color_2.xyz * light_2.color) * split_1.y), 1.0), (tone_2 * split_1.x));
    return litlayer_2;
}

Angle parametrization_specular_balanced(Light light_3, float3 normal, float3 view)
{
    float3 d = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_4 = ConstructAngle((0.5 * length((d - light_3.direction))), (0.5 * length((d + light_3.direction))));
    return angle_4;
}

float profile_power_quick(float q, float exponent)
{
    float y_2 = min((q * q), 1.0);
    const float _e5 = log2_one_minus(y_2);
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
    const float _e8 = log2_one_minus(min((q_1 * q_1), 1.0));
    return ((s_1 <= 0.0) ? 1.0 : ((q_1 >= 1.0) ? 0.0 : min(exp2(max((shape_2.exponent * _e8), -126.0)), 1.0)));
}

float profile_soft_quick_3_(float s_2, ProfileShape shape_3)
{
    float q_2 = (s_2 * shape_3.scale);
    return ((s_2 <= 0.0) ? 1.0 : pow(max((1.0 - (q_2 * q_2)), 0.0), shape_3.exponent));
}

float profile_ramp_quick(float s_3, float w, ProfileShape shape_4)
{
    float width = sqrt(((w * w) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
    float from_offset = (s_3 * (2.0 + ((s_3 * s_3) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_4.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_3 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_4, float w_1, ProfileShape shape_5)
{
    float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_5.edge_deviation) * shape_5.edge_deviation)));
    float from_offset_1 = (s_4 * (2.0 + ((s_4 * s_4) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((shape_5.edge_mean - from_offset_1) / width_1)), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_4 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_6)
{
    if ((shape_6.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    const float2 _e7 = profile_place(u_3, shape_6);
    bool is_narrow = ((w_2 > 0.0) & (w_2 >= (3.4641016 * shape_6.edge_deviation)));
    if (((shape_6.kind == PROFILE_STEP) | is_narrow)) {
        const float _e20 = profile_ramp_quick(_e7.x, w_2, shape_6);
        return _e20;
    }
    const float _e22 = profile_soft_quick(_e7.x, shape_6);
    if ((w_2 < (0.1 * shape_6.edge_deviation))) {
        return _e22;
    }
    float r = (0.19364917 * w_2);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_6);
    const float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_6);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_4, float w_3, ProfileShape shape_7)
{
    float2 place = float2(((u_4.half_sin * shape_7.half_cos_offset) - (u_4.half_cos * shape_7.half_sin_offset)), ((u_4.half_cos * shape_7.half_cos_offset) + (u_4.half_sin * shape_7.half_sin_offset)));
    bool is_narrow_1 = ((w_3 > 0.0) & (w_3 >= (3.4641016 * shape_7.edge_deviation)));
    if (((shape_7.kind == PROFILE_STEP) | is_narrow_1)) {
        const float _e30 = profile_ramp_quick(place.x, w_3, shape_7);
        return _e30;
    }
    const float _e32 = profile_soft_quick_2_(place.x, shape_7);
    if ((w_3 < (0.1 * shape_7.edge_deviation))) {
        return _e32;
    }
    float r_1 = (0.19364917 * w_3);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e58 = profile_soft_quick_2_(((place.x * turn_1.y) - (place.y * turn_1.x)), shape_7);
    const float _e66 = profile_soft_quick_2_(((place.x * turn_1.y) + (place.y * turn_1.x)), shape_7);
    return ((((5.0 * _e58) + (8.0 * _e32)) + (5.0 * _e66)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_5, float w_4, ProfileShape shape_8)
{
    float2 place_1 = float2(((u_5.half_sin * shape_8.half_cos_offset) - (u_5.half_cos * shape_8.half_sin_offset)), ((u_5.half_cos * shape_8.half_cos_offset) + (u_5.half_sin * shape_8.half_sin_offset)));
    bool is_narrow_2 = ((w_4 > 0.0) & (w_4 >= (3.4641016 * shape_8.edge_deviation)));
    if ((false | is_narrow_2)) {
        const float _e28 = profile_ramp_quick_2_(place_1.x, w_4, shape_8);
        return _e28;
    }
    const float _e30 = profile_soft_quick_3_(place_1.x, shape_8);
    if ((w_4 < (0.1 * shape_8.edge_deviation))) {
        return _e30;
    }
    float r_2 = (0.19364917 * w_4);
    float2 turn_2 = float2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    const float _e56 = profile_soft_quick_3_(((place_1.x * turn_2.y) - (place_1.y * turn_2.x)), shape_8);
    const float _e64 = profile_soft_quick_3_(((place_1.x * turn_2.y) + (place_1.y * turn_2.x)), shape_8);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_9)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_9);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_10)
{
    const float2 _e8 = sin_cos_quick((0.5 * clamp(shift_1, -3.1415927, PI)));
    const Angle _e9 = angle_turned(angle_1, _e8);
    const float _e10 = angle_footprint(_e9);
    const float _e11 = profile_filtered_quick_2_(_e9, _e10, shape_10);
    return _e11;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_11)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift_2));
    const Angle _e6 = angle_turned(angle_2, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_11);
    return _e8;
}

float4 shade(Surface surface)
{
    float back_light_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.25), -20.0, 20.0))))))));
    const float4 _e30 = curvature_color(back_light_convexity, float4(0.1647, 0.1843, 0.2392, 1.0), float4(0.0706, 0.0784, 0.1098, 1.0));
    Light _e33 = look.key;
    const LitLayer _e35 = light_apply_2_(_e33, _e30, 1.0);
    float4 fill_blend = clamp(float4((float3(0.0784, 0.0863, 0.1137) + (_e35.tone * _e35.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float4 _e62 = curvature_color(back_light_convexity, float4(0.498, 0.6039, 0.3216, 1.0), float4(0.2471, 0.4, 0.251, 1.0));
    float3 _e67 = look.key.direction;
    float3 _e76 = look.key.direction;
    Angle diffuse_angle = ConstructAngle((0.5 * length((surface.normal - _e67))), (0.5 * length((surface.normal + _e76))));
    float diffuse_warp = (((2.0 * back_light_convexity) - 1.0) * 0.3);
    ProfileShape _e90 = look.diffuse_tone_shape;
    const float _e91 = profile_balanced(diffuse_angle, diffuse_warp, _e90);
    Light _e94 = look.key;
    const LitLayer _e95 = light_apply_3_(_e94, _e62, _e91);
    float4 diffuse_blend = clamp(float4((fill_blend.xyz + (_e95.tone * _e95.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    float4 _e111 = look.back_light_color_concave;
    float4 _e114 = look.back_light_color_convex;
    float4 _e117 = look.back_light_color_concave;
    float4 back_light_color = (_e111 + (back_light_convexity * (_e114 - _e117)));
    float3 _e125 = look.back.direction;
    float3 _e134 = look.back.direction;
    Angle back_light_angle = ConstructAngle((0.5 * length((surface.normal - _e125))), (0.5 * length((surface.normal + _e134))));
    float _e146 = look.back_light_warp_amount;
    float back_light_warp = (((2.0 * back_light_convexity) - 1.0) * clamp(_e146, -3.1415927, 3.1415927));
    ProfileShape _e153 = look.back_light_tone_shape;
    const float _e154 = profile_balanced_2_(back_light_angle, back_light_warp, _e153);
    Light _e157 = look.back;
    const LitLayer _e158 = light_apply(_e157, back_light_color, _e154);
    const float4 _e169 = blend_finish(diffuse_blend, (diffuse_blend.xyz + (_e158.tone * _e158.color.xyz)), 1.0, _e158.color.w, true);
    float highlight_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.2), -20.0, 20.0))))))));
    float4 _e191 = look.highlight_color_concave;
    float4 _e194 = look.highlight_color_convex;
    float4 _e197 = look.highlight_color_concave;
    float4 highlight_color = (_e191 + (highlight_convexity * (_e194 - _e197)));
    Light _e203 = look.key;
    const Angle _e206 = parametrization_specular_balanced(_e203, surface.normal, surface.view);
    float highlight_warp = (((2.0 * highlight_convexity) - 1.0) * 0.05);
    const float _e214 = profile_balanced_3_(_e206, highlight_warp, highlight_tone_shape);
    Light _e217 = look.key;
    const LitLayer _e218 = light_apply(_e217, highlight_color, _e214);
    const float4 _e229 = blend_finish(_e169, (_e169.xyz + (_e218.tone * _e218.color.xyz)), 1.0, _e218.color.w, true);
    return _e229;
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
