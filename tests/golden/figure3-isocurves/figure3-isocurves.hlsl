// Profile isocurves: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// figure3-isocurves.json says what to put there and how to draw.
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
    Light key;
    float cut_off;
    float fall_off;
    float offset;
    int _pad4_0;
    ProfileShape profile_tone_shape;
};

struct Surface {
    float3 normal;
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
    float3 normal : LOC0;
};

static const float HALF_PI = 1.5707964;
static const float LOG2_E = 1.442695;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 normal : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 normal_1 : LOC0;
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

float log2_one_minus(float y)
{
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float atan2_positive(float y_1, float x)
{
    float small = min(y_1, x);
    float large = max(y_1, x);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x) ? (HALF_PI - a) : a);
}

float angle_radians(Angle u)
{
    const float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

float angle_footprint(Angle u_1)
{
    float2 half_ = float2(u_1.half_sin, u_1.half_cos);
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

Angle angle_turned(Angle u_2, float2 t)
{
    float s_2 = (u_2.half_sin - 0.0);
    float2 upper = ((u_2.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_2, u_2.half_cos));
    float2 turned = (((s_2 <= 0.0) & (s_2 < u_2.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
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
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_3, float edge, float w)
{
    const float _e4 = bounded((x_3 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
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

float profile_power_quick(float q, float exponent)
{
    float y_2 = min((q * q), 1.0);
    const float _e5 = log2_one_minus(y_2);
    float power = exp2(max((exponent * _e5), -126.0));
    return ((q >= 1.0) ? 0.0 : clamp(power, 0.0, 1.0));
}

float2 profile_place(Angle u_3, ProfileShape shape)
{
    return float2(((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset)), ((u_3.half_cos * shape.half_cos_offset) + (u_3.half_sin * shape.half_sin_offset)));
}

float profile_soft_quick(float s, ProfileShape shape_1)
{
    const float _e5 = profile_power_quick((s * shape_1.scale), shape_1.exponent);
    return ((s <= 0.0) ? 1.0 : _e5);
}

float profile_ramp_quick(float s_1, float w_1, ProfileShape shape_2)
{
    float width = sqrt(((w_1 * w_1) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_2.edge_mean - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_4, float w_2, ProfileShape shape_3)
{
    if ((shape_3.kind == PROFILE_AMBIENT)) {
        return 1.0;
    }
    const float2 _e7 = profile_place(u_4, shape_3);
    bool is_narrow = ((w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if (((shape_3.kind == PROFILE_STEP) | is_narrow)) {
        const float _e20 = profile_ramp_quick(_e7.x, w_2, shape_3);
        return _e20;
    }
    const float _e22 = profile_soft_quick(_e7.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e22;
    }
    float r_1 = (0.19364917 * w_2);
    float2 turn = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e48 = profile_soft_quick(((_e7.x * turn.y) - (_e7.y * turn.x)), shape_3);
    const float _e56 = profile_soft_quick(((_e7.x * turn.y) + (_e7.y * turn.x)), shape_3);
    return ((((5.0 * _e48) + (8.0 * _e22)) + (5.0 * _e56)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float threshold(float value, float edge_1, float softness)
{
    const float _e3 = bounded(value);
    const float _e4 = footprint_of(value);
    const float _e9 = step_filtered(_e3, edge_1, length(float2(min(_e4, 1000000000000000.0), softness)));
    return _e9;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle profile_angle = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    ProfileShape _e23 = look.profile_tone_shape;
    const float _e24 = profile_balanced(profile_angle, 0.0, _e23);
    Light _e27 = look.key;
    const LitLayer _e33 = light_apply(_e27, float4(0.86, 0.8, 0.7, 1.0), _e24);
    float4 profile_blend = clamp(float4((float3(0.11, 0.13, 0.19) + (_e33.tone * _e33.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float _e50 = angle_radians(profile_angle);
    float _e53 = look.offset;
    const float _e55 = bounded((_e50 - _e53));
    const float _e58 = threshold(_e55, 0.012, 0.0);
    const float _e61 = threshold(_e55, -0.012, 0.0);
    float offset_isocurve_line = (_e61 - _e58);
    float offset_isocurve_tone = max(offset_isocurve_line, 0.0);
    const float4 _e72 = blend_alpha(profile_blend, float4(0.16, 0.36, 0.85, 1.0), offset_isocurve_tone, 1.0, true);
    const float _e73 = angle_radians(profile_angle);
    float _e76 = look.fall_off;
    const float _e78 = bounded((_e73 - _e76));
    const float _e81 = threshold(_e78, 0.012, 0.0);
    const float _e84 = threshold(_e78, -0.012, 0.0);
    float falloff_isocurve_line = (_e84 - _e81);
    float falloff_isocurve_tone = max(falloff_isocurve_line, 0.0);
    const float4 _e95 = blend_alpha(_e72, float4(0.16, 0.36, 0.85, 1.0), falloff_isocurve_tone, 1.0, true);
    const float _e96 = angle_radians(profile_angle);
    float _e99 = look.cut_off;
    const float _e101 = bounded((_e96 - _e99));
    const float _e104 = threshold(_e101, 0.012, 0.0);
    const float _e107 = threshold(_e101, -0.012, 0.0);
    float cutoff_isocurve_line = (_e107 - _e104);
    float cutoff_isocurve_tone = max(cutoff_isocurve_line, 0.0);
    const float4 _e118 = blend_alpha(_e95, float4(0.16, 0.36, 0.85, 1.0), cutoff_isocurve_tone, 1.0, true);
    return _e118;
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

Surface ConstructSurface(float3 arg0) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = ConstructSurface(normal_2);
    const float4 _e7 = shade(surface_1);
    return _e7;
}
