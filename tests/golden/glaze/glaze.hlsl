// Grisaille and glaze: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2, curvature_map t0.
// glaze.json says what to put there and how to draw.
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
    Light back;
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

static const ProfileShape gray_modeling_tone_shape = ConstructProfileShape(1.0, 0.0, 1.0537579, 1.3909147, 0.0, 1.2772532, 0.561292, 0u);
static const ProfileShape gray_lights_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 2.0858297, 3.3126261, 0.1, 0.42646712, 0.19445144, 0u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float4 finite_vec4_(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return (((asuint(v) & exponent) != exponent) ? v : (0.0).xxxx);
}

float3 normalize_moderate(float3 v_1, float3 otherwise)
{
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen(float3 v_2)
{
    const float3 _e5 = normalize_moderate(v_2, float3(0.0, 0.0, 1.0));
    return _e5;
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
    float s_1 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_1, u_1.half_cos));
    float2 turned = (((s_1 <= 0.0) & (s_1 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float3 bounded_vec3_(float3 v_3)
{
    uint3 bits = asuint(v_3);
    uint3 magnitude = (bits & (2147483647u).xxx);
    float3 largest = asfloat(((bits & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers = ((magnitude == (2139095040u).xxx) ? largest : (0.0).xxx);
    return ((magnitude < (2139095040u).xxx) ? v_3 : numbers);
}

float3 mixed_vec3_(float3 a, float3 b, float t_1)
{
    const float3 _e4 = bounded_vec3_((b - a));
    const float3 _e14 = bounded_vec3_(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
}

float footprint_of(float x)
{
    float _e1 = ddx(x);
    float _e2 = ddy(x);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float soft_light(float a_1, float b_1)
{
    float curved = ((a_1 <= 0.25) ? (((((16.0 * a_1) - 12.0) * a_1) + 4.0) * a_1) : sqrt(max(a_1, 0.0)));
    return (a_1 + (((2.0 * b_1) - 1.0) * (curved - a_1)));
}

float4 color_mixed(float4 a_2, float3 blended, float factor)
{
    const float3 _e3 = bounded_vec3_(blended);
    const float3 _e8 = bounded_vec3_((_e3 - a_2.xyz));
    const float3 _e11 = bounded_vec3_((_e3 - ((1.0 - factor) * _e8)));
    return float4(_e11, 1.0);
}

float lightness_of(float3 rgb)
{
    return dot(rgb, float3(0.3, 0.59, 0.11));
}

float3 lit_as(float3 rgb_1, float3 other)
{
    const float _e2 = lightness_of(other);
    const float _e3 = lightness_of(rgb_1);
    float3 moved = (rgb_1 + ((_e2 - _e3)).xxx);
    float least = min(min(moved.x, moved.y), moved.z);
    float largest_1 = max(max(moved.x, moved.y), moved.z);
    float raised = ((least < 0.0) ? (_e2 / max((_e2 - least), 1e-6)) : 1.0);
    float3 clipped = ((_e2).xxx + ((moved - (_e2).xxx) * raised));
    float top = (_e2 + ((largest_1 - _e2) * raised));
    float lowered = ((top > 1.0) ? ((1.0 - _e2) / max((top - _e2), 1e-6)) : 1.0);
    return ((_e2).xxx + ((clipped - (_e2).xxx) * lowered));
}

float4 mix_colors_screen(float4 a_3, float4 b_2, float factor_1)
{
    const float3 _e4 = bounded_vec3_(a_3.xyz);
    const float3 _e12 = bounded_vec3_(((a_3.xyz + b_2.xyz) - (a_3.xyz * b_2.xyz)));
    const float3 _e13 = mixed_vec3_(_e4, _e12, factor_1);
    return float4(_e13, 1.0);
}

float4 mix_colors_soft_light(float4 a_4, float4 b_3, float factor_2)
{
    const float _e5 = soft_light(a_4.x, b_3.x);
    const float _e8 = soft_light(a_4.y, b_3.y);
    const float4 _e23 = color_mixed(a_4, float3(_e5, _e8, (a_4.z - (((1.0 - (2.0 * b_3.z)) * a_4.z) * (1.0 - a_4.z)))), factor_2);
    return _e23;
}

float4 mix_colors_hue(float4 a_5, float4 b_4, float factor_3)
{
    const float3 _e4 = bounded_vec3_(a_5.xyz);
    float3 below_1 = clamp(_e4, (0.0).xxx, (1.0).xxx);
    const float3 _e11 = bounded_vec3_(a_5.xyz);
    const float3 _e32 = lit_as(((b_4.xyz - (b_4.y).xxx) * ((max(max(below_1.x, below_1.y), below_1.z) - min(min(below_1.x, below_1.y), below_1.z)) / (b_4.x - b_4.y))), below_1);
    const float3 _e35 = mixed_vec3_(_e11, _e32, max(factor_3, 0.0));
    return float4(_e35, 1.0);
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

Angle parametrization_specular_balanced(Light light_1, float3 normal, float3 view)
{
    float3 d_1 = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_3 = ConstructAngle((0.5 * length((d_1 - light_1.direction))), (0.5 * length((d_1 + light_1.direction))));
    return angle_3;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1)
{
    float2 place = float2((u_2.half_sin - 0.0), u_2.half_cos);
    const float _e9 = profile_soft_quick(place.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e9;
    }
    float r = (0.19364917 * w);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e35 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    const float _e43 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_1, ProfileShape shape_2)
{
    float2 place_1 = float2(((u_3.half_sin * shape_2.half_cos_offset) - (u_3.half_cos * shape_2.half_sin_offset)), ((u_3.half_cos * shape_2.half_cos_offset) + (u_3.half_sin * shape_2.half_sin_offset)));
    const float _e19 = profile_soft_quick(place_1.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r_1 = (0.19364917 * w_1);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e45 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_2);
    const float _e53 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_3)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_4)
{
    const Angle _e6 = angle_turned(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_4);
    return _e8;
}

float rim(Light light_2, float3 normal_1, float3 view_1, float width, float softness, float follow)
{
    float facing = clamp(dot(normal_1, view_1), 0.0, 1.0);
    const float _e11 = footprint_of(facing);
    float edge = max((width * softness), min(_e11, 1.0));
    float3 aside = (normal_1 - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    float3 across = (light_2.direction - (dot(light_2.direction, view_1) * view_1));
    float side = dot((normal_1 - (dot(normal_1, view_1) * view_1)), (across * rsqrt(max(dot(across, across), 1e-30))));
    return (inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow));
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
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle gray_modeling_angle = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile_balanced(gray_modeling_angle, 0.0, gray_modeling_tone_shape);
    Light _e25 = look.key;
    const LitLayer _e31 = light_apply(_e25, float4(0.7059, 0.7059, 0.7059, 1.0), _e22);
    const float4 _e41 = blend_alpha(float4(0.1216, 0.1216, 0.1216, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = look.key;
    const Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    const float _e50 = profile_balanced_2_(_e47, 0.0, gray_lights_tone_shape);
    Light _e53 = look.key;
    const LitLayer _e59 = light_apply(_e53, float4(0.2902, 0.2902, 0.2902, 1.0), _e50);
    float4 gray_lights_blend = clamp(float4((_e41.xyz + (_e59.tone * _e59.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    float4 grisaille = float4(gray_lights_blend.xyz, 1.0);
    const float3 _e82 = lit_as(float3(0.4275, 0.5412, 0.4471), grisaille.xyz);
    float4 glaze_of_green_earth = float4(lerp(grisaille.xyz, _e82, 0.75), 1.0);
    const float3 _e93 = lit_as(float3(0.7098, 0.4667, 0.3098), grisaille.xyz);
    float4 glaze_of_sienna = float4(lerp(grisaille.xyz, _e93, 0.7), 1.0);
    float3 place_2 = surface.position_object;
    VectorParts height = ConstructVectorParts(place_2.x, place_2.y, place_2.z);
    float toward_the_head = smoothstep(-0.5, 0.5, height.y);
    float4 from_green_to_sienna = lerp(glaze_of_green_earth, glaze_of_sienna, toward_the_head);
    const float4 _e114 = mix_colors_soft_light(from_green_to_sienna, float4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float curvature = surface.kappa;
    float bulge = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.06), -20.0, 20.0))))))));
    float hollows = lerp(0.6, 0.0, min(((bulge - 0.0) / 0.55), 1.0));
    const float4 _e148 = mix_colors_hue(_e114, float4(0.4902, 0.2471, 0.3608, 1.0), hollows);
    Light _e151 = look.back;
    const float _e157 = rim(_e151, surface.normal, surface.view, 0.3, 0.6, 1.0);
    const float4 _e163 = mix_colors_screen(_e148, float4(0.4353, 0.5294, 0.6588, 1.0), _e157);
    const float4 _e164 = finite_vec4_(_e163);
    return _e164;
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
    float4x4 _e10 = view_2.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    float4 _e24 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x);
    const float4 _e27 = shade(surface_1);
    const float4 _e28 = finite_vec4_(_e27);
    return _e28;
}
