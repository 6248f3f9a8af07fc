// Light where it is wanted: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_3 b0, object b1, look b2, curvature_tensor_map t0.
// local-control.json says what to put there and how to draw.
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
    row_major float3x3 camera_from_world;
    int _pad1_0;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light back;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    int _pad3_0;
    float3 position_camera;
    int _pad4_0;
    float3 curvature_tensor;
    int _end_pad_0;
};

struct Angle {
    float half_sin;
    float half_cos;
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape soft_tone_shape = ConstructProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);

cbuffer view_3 : register(b0) { View view_3; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen(float3 v_1)
{
    const float3 _e5 = normalize_moderate(v_1, float3(0.0, 0.0, 1.0));
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
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
}

float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float eased(float x_1, float low, float high)
{
    const float _e3 = bounded(x_1);
    const float _e7 = bounded(((_e3 - low) / (high - low)));
    float t_1 = clamp(_e7, 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float length_of(float3 v_2)
{
    float largest_1 = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e16 = bounded((largest_1 * length((v_2 / (largest_1).xxx))));
    return _e16;
}

float footprint_of(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float footprint_of_2_(float x_3)
{
    float _e1 = ddx(x_3);
    float _e2 = ddy(x_3);
    float2 d_1 = float2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float step_filtered(float x_4, float edge, float w)
{
    float d_2 = (x_4 - edge);
    return ((w < 1e-30) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_2 / w)), 0.0, 1.0));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

float4 blend_alpha_2_(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return clamp(float4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light local_light(Light light, float3 bend, float strength, float3 center_, float radius, float hardness, float3 position)
{
    const float _e8 = length_of((position - center_));
    const float _e10 = eased(_e8, (radius * hardness), radius);
    float weight = (1.0 - _e10);
    float3 bent = (light.direction + (weight * bend));
    const float3 _e18 = normalize_moderate(bent, light.direction);
    float3 direction = (((dot(bent, bent) > 1e-6) & (weight > 0.0)) ? _e18 : light.direction);
    const Light light_2 = ConstructLight(direction, light.own_direction, light.color, min(light.intensity, 1e30));
    return light_2;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_1)
{
    float2 place_1 = float2((u_2.half_sin - 0.0), u_2.half_cos);
    const float _e9 = profile_soft_quick(place_1.x, shape_1);
    if ((w_1 < (0.1 * shape_1.edge_deviation))) {
        return _e9;
    }
    float r = (0.19364917 * w_1);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e35 = profile_soft_quick(((place_1.x * turn.y) - (place_1.y * turn.x)), shape_1);
    const float _e43 = profile_soft_quick(((place_1.x * turn.y) + (place_1.y * turn.x)), shape_1);
    return ((((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

float rim(Light light_1, float3 normal, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    const float _e11 = footprint_of_2_(facing);
    float edge_1 = max((width * softness), min(_e11, 1.0));
    float3 aside = (normal - view);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge_1) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    float3 across = (light_1.direction - (dot(light_1.direction, view) * view));
    float side = dot((normal - (dot(normal, view) * view)), (across * rsqrt(max(dot(across, across), 1e-30))));
    return (inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow));
}

float inner_contour_suggestive(float width_1, float limit, float softness_1, float3 tensor, float3 normal_1, float3 view_1, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n = mul(normal_1, camera_from_world);
    float square_1 = dot(n.xy, n.xy);
    float radial = (((((tensor.x * n.x) * n.x) + (((2.0 * tensor.y) * n.x) * n.y)) + ((tensor.z * n.y) * n.y)) / max(square_1, 1e-6));
    float _e35 = ddx(radial);
    float _e36 = ddy(radial);
    float2 change = float2(_e35, _e36);
    float3 v_3 = mul(view_1, camera_from_world);
    float3 row = ddy(place);
    float up = (((row - (dot(row, v_3) * v_3)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * rsqrt(max(square_1, 1e-6)));
    float pixels = (height / 1000.0);
    float distance_ = (abs(radial) / max(length(change), 1e-6));
    float x_5 = ((toward_eye * height) * 0.05);
    const float _e77 = footprint_of(x_5);
    float strength_1 = clamp((0.5 + ((x_5 - limit) / length(float2(min(_e77, 1000000000000000.0), (limit * softness_1))))), 0.0, 1.0);
    return ((clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * strength_1) * smoothstep(0.05, 0.3, dot(normal_1, view_1)));
}

float outer_contour(float width_2, float3 normal_2, float3 view_2, float2 viewport_1)
{
    float facing_1 = clamp(dot(normal_2, view_2), 0.0, 1.0);
    float pixels_1 = ((width_2 * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    const float _e15 = footprint_of_2_(facing_1);
    float distance_1 = (facing_1 / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing_1));
    return (clamp(((pixels_1 + 0.5) - distance_1), 0.0, min(pixels_1, 1.0)) * near);
}

float4 shade(Surface surface)
{
    Light _e3 = look.key;
    const Light _e16 = local_light(_e3, float3(0.9, 0.25, 0.5), 1.0, float3(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    const Light _e29 = local_light(_e16, float3(0.4, 0.1, 0.35), 1.0, float3(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    Angle turned_from_the_light = ConstructAngle((0.5 * length((surface.normal - _e29.direction))), (0.5 * length((surface.normal + _e29.direction))));
    const float _e45 = profile_balanced(turned_from_the_light, 0.0, soft_tone_shape);
    const float _e52 = length_of((surface.position_object - float3(0.0, 0.02, 0.45)));
    const float _e55 = eased(_e52, 0.03, 0.3);
    float shadow_under_the_chin = clamp((_e45 + ((1.0 - _e55) * -0.45)), 0.0, 1.0);
    const float _e70 = length_of((surface.position_object - float3(-0.2, 0.72, 0.4)));
    const float _e73 = eased(_e70, 0.085, 0.17);
    float glint_on_the_brow = clamp((shadow_under_the_chin + ((1.0 - _e73) * 0.5)), 0.0, 1.0);
    const float _e83 = footprint_of_2_(glint_on_the_brow);
    const float _e87 = step_filtered(glint_on_the_brow, 0.55, length(float2(_e83, 0.0)));
    const float4 _e100 = blend_alpha(float4(0.36, 0.36, 0.6, 1.0), float4(0.96, 0.72, 0.47, 1.0), _e87, 1.0, true);
    const float _e102 = footprint_of_2_(glint_on_the_brow);
    const float _e106 = step_filtered(glint_on_the_brow, 0.97, length(float2(_e102, 0.0)));
    float4 brightest_light = min(float4((_e100.xyz + (_e106 * (float3(1.0, 0.93, 0.76) - _e100.xyz))), 1.0), (1.0).xxxx);
    Light _e123 = look.back;
    const float _e129 = rim(_e123, surface.normal, surface.view, 0.3, 0.1, 1.0);
    const float4 _e137 = blend_alpha_2_(brightest_light, float4(0.72, 0.86, 1.0, 1.0), _e129, 0.7, true);
    float3x3 _e146 = look.camera_from_world;
    float2 _e150 = look.viewport;
    const float _e151 = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor, surface.normal, surface.view, _e146, surface.position_camera, _e150);
    float2 _e157 = look.viewport;
    const float _e158 = outer_contour(3.0, surface.normal, surface.view, _e157);
    float all_lines = max(_e158, _e151);
    const float4 _e167 = blend_alpha_2_(_e137, float4(0.17, 0.13, 0.28, 1.0), all_lines, 0.85, true);
    return _e167;
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
    float4x4 _e10 = view_3.clip_from_world;
    float3x3 _e16 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float3 arg4) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    ret.position_camera = arg3;
    ret.curvature_tensor = arg4;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_5 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_3.eye;
    float _e13 = view_3.eye.w;
    float4x4 _e21 = view_3.camera_from_world;
    float4 _e32 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_5, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, mul(float4(in_.position, 1.0), _e21).xyz, _e32.xyz);
    const float4 _e35 = shade(surface_1);
    return _e35;
}
