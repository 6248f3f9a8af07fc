// Technical cutaway: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// technical-cutaway.json says what to put there and how to draw.
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

struct Shaded {
    float4 value;
    float4 color;
    float cutoff;
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

static const ProfileShape metal_tone_shape = ConstructProfileShape(0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12, 0.124456726, 0.0556771, 0u);
static const ProfileShape contour_tone_shape = ConstructProfileShape(0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u);

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
    float s_4 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_4, c_1));
    float2 turned = (((s_4 <= 0.0) & (s_4 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float bounded(float x_1)
{
    uint bits = asuint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float footprint_of(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float step_filtered(float x_3, float edge, float w)
{
    float d_1 = (x_3 - edge);
    if ((w < 1e-30)) {
        return ((d_1 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e12 = bounded((d_1 / w));
    return clamp((0.5 + _e12), 0.0, 1.0);
}

float4 premultiplied(float4 color)
{
    return float4((color.xyz * color.w), color.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float transition_balanced(float kappa, float slope)
{
    return (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((kappa * slope), -20.0, 20.0))))))));
}

float4 blend_alpha(float4 below, float4 color_1, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (color_1.xyz - below.xyz))) - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 output(float4 color_2)
{
    const float4 _e1 = straight(color_2);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_3, float tone_1)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_3.xyz * light.color) * split.y), 1.0), split.x);
    return litlayer;
}

LitLayer light_apply_2_(Light light_1, float4 color_4, float tone_2)
{
    float2 split_1 = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer_1 = ConstructLitLayer(float4((light_1.color * split_1.y), 1.0), (tone_2 * split_1.x));
    return litlayer_1;
}

Angle parametrization_specular_balanced(Light light_2, float3 normal, float3 view)
{
    float3 d_2 = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_3 = ConstructAngle((0.5 * length((d_2 - light_2.direction))), (0.5 * length((d_2 + light_2.direction))));
    return angle_3;
}

Angle parametrization_screen_aligned_balanced(Light light_3, float3 normal_1, float3x3 camera_from_world)
{
    float3 d_3 = mul(normal_1, camera_from_world);
    const Angle angle_4 = ConstructAngle((0.5 * length((d_3 - light_3.own_direction))), (0.5 * length((d_3 + light_3.own_direction))));
    return angle_4;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w_1, ProfileShape shape_1)
{
    float width = sqrt(((w_1 * w_1) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_2, float w_2, ProfileShape shape_2)
{
    float width_1 = sqrt((w_2 * w_2));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_1, 1e-6))), 0.0, 1.0);
    return ((w_2 <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_2, float w_3, ProfileShape shape_3)
{
    float2 place = float2(((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset)), ((u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_3 > 0.0) & (w_3 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place.x, w_3, shape_3);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_3 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_3);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    const float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
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
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

float4 gooch(Light light_4, float3 normal_2, float4 color_5, float4 cool, float4 warm, float cool_amount, float warm_amount)
{
    float t_1 = (0.5 + (0.5 * dot(normal_2, light_4.direction)));
    float3 far = (cool.xyz + (cool_amount * color_5.xyz));
    float3 near = (warm.xyz + (warm_amount * color_5.xyz));
    return float4(lerp(far, near, clamp(t_1, 0.0, 1.0)), 1.0);
}

VectorParts ConstructVectorParts(float arg0, float arg1, float arg2) {
    VectorParts ret = (VectorParts)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

Shaded ConstructShaded(float4 arg0, float4 arg1, float arg2) {
    Shaded ret = (Shaded)0;
    ret.value = arg0;
    ret.color = arg1;
    ret.cutoff = arg2;
    return ret;
}

Shaded shade(Surface surface)
{
    Light _e3 = look.key;
    const float4 _e22 = gooch(_e3, surface.normal, float4(0.8314, 0.8392, 0.8549, 1.0), float4(0.1725, 0.2902, 0.4863, 1.0), float4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    float4 cool_to_warm_2_ = float4(((1.0).xxx + (_e22.xyz - (1.0).xxx)), 1.0);
    const float _e34 = transition_balanced(surface.kappa, 0.25);
    const float4 _e42 = curvature_color(_e34, (1.0).xxxx, float4(0.5412, 0.5804, 0.6588, 1.0));
    Light _e45 = look.key;
    const LitLayer _e47 = light_apply(_e45, _e42, 1.0);
    float4 hollows_blend = clamp(float4((cool_to_warm_2_.xyz + (0.8 * ((cool_to_warm_2_.xyz * (_e47.tone * _e47.color.xyz)) - cool_to_warm_2_.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    Light _e69 = look.key;
    const Angle _e72 = parametrization_specular_balanced(_e69, surface.normal, surface.view);
    const float _e75 = transition_balanced(surface.kappa, 0.2);
    float metal_warp = (((2.0 * _e75) - 1.0) * 0.05);
    const float _e83 = profile_balanced(_e72, metal_warp, metal_tone_shape);
    Light _e86 = look.key;
    const LitLayer _e89 = light_apply_2_(_e86, (1.0).xxxx, _e83);
    const float4 _e94 = blend_alpha(hollows_blend, _e89.color, _e89.tone, 0.8, true);
    Light _e97 = look.eye;
    float3x3 _e101 = look.camera_from_world;
    const Angle _e102 = parametrization_screen_aligned_balanced(_e97, surface.normal, _e101);
    const float _e105 = transition_balanced(surface.kappa, 0.12);
    float contour_warp = (((2.0 * _e105) - 1.0) * 0.25);
    const float _e113 = profile_balanced_2_(_e102, contour_warp, contour_tone_shape);
    Light _e116 = look.eye;
    const LitLayer _e119 = light_apply_2_(_e116, (1.0).xxxx, _e113);
    float4 contour_blend = clamp(float4((_e94.xyz * (_e119.tone * _e119.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    float3 place_1 = surface.position_object;
    VectorParts parts = ConstructVectorParts(place_1.x, place_1.y, place_1.z);
    float into_the_corner = min(parts.x, parts.z);
    const float _e142 = footprint_of(into_the_corner);
    const float _e148 = step_filtered(into_the_corner, -0.012, length(float2(min(_e142, 1000000000000000.0), 0.0)));
    float4 section_line = clamp(float4((contour_blend.xyz + (_e148 * (float3(0.8471, 0.1569, 0.1098) - contour_blend.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float _e166 = footprint_of(into_the_corner);
    const float _e172 = step_filtered(into_the_corner, 0.02, length(float2(min(_e166, 1000000000000000.0), 0.0)));
    float kept = (1.0 - _e172);
    float4 cut = float4(section_line.xyz, kept);
    const float4 _e177 = premultiplied(cut);
    const float4 _e178 = output(_e177);
    const Shaded shaded = ConstructShaded(_e178, _e178, 0.5);
    return shaded;
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
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_5 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e24 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_5, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x);
    const Shaded _e27 = shade(surface_1);
    if ((_e27.color.w < _e27.cutoff)) {
        discard;
    }
    const float4 _e33 = finite_vec4_(_e27.value);
    return _e33;
}
