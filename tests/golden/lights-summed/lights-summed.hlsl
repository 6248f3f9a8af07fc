// Ten lights, one edge after the sum: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// lights-summed.json says what to put there and how to draw.
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
    Light moon;
    float moon_intensity;
    int _pad2_0;
    int _pad2_1;
    int _pad2_2;
    Light violet;
    float violet_intensity;
    int _pad4_0;
    int _pad4_1;
    int _pad4_2;
    Light rose;
    float rose_intensity;
    int _pad6_0;
    int _pad6_1;
    int _pad6_2;
    Light amber;
    float amber_intensity;
    int _pad8_0;
    int _pad8_1;
    int _pad8_2;
    Light gold;
    float gold_intensity;
    int _pad10_0;
    int _pad10_1;
    int _pad10_2;
    Light coral;
    float coral_intensity;
    int _pad12_0;
    int _pad12_1;
    int _pad12_2;
    Light magenta;
    float magenta_intensity;
    int _pad14_0;
    int _pad14_1;
    int _pad14_2;
    Light cobalt;
    float cobalt_intensity;
    int _pad16_0;
    int _pad16_1;
    int _pad16_2;
    Light turquoise;
    float turquoise_intensity;
    int _pad18_0;
    int _pad18_1;
    int _pad18_2;
    Light azure;
    float azure_intensity;
    int _pad20_0;
    int _pad20_1;
    int _pad20_2;
    float4 lamps_moon_strength;
    float4 lamps_violet_strength;
    float4 lamps_rose_strength;
    float4 lamps_amber_strength;
    float4 lamps_gold_strength;
    float4 lamps_coral_strength;
    float4 lamps_magenta_strength;
    float4 lamps_cobalt_strength;
    float4 lamps_turquoise_strength;
    float4 lamps_azure_strength;
};

struct Surface {
    float3 normal;
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

static const ProfileShape lamps_moon_tone_shape = ConstructProfileShape(1.0, 0.0, 1.6002629, 1.8073579, 0.0, 0.71386534, 0.30130044, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

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

float footprint_of(float x)
{
    float _e1 = ddx(x);
    float _e2 = ddy(x);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float stairs_integral(float x_1, float count)
{
    float inside = min(x_1, count);
    float stair = min(floor(inside), 5.0);
    float beyond = max((x_1 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 5.0));
}

float stairs_integral_2_(float x_2, float count_1)
{
    float inside_1 = max(x_2, 0.0);
    float stair_1 = floor(inside_1);
    return ((stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0);
}

float stairs_filtered(float x_3, float count_2, float w)
{
    if ((w <= 1.0)) {
        float edge = clamp(round(x_3), 1.0, 5.0);
        return ((edge - 1.0) + clamp((0.5 + ((x_3 - edge) / w)), 0.0, 1.0));
    }
    float half_1 = (0.5 * w);
    const float _e22 = stairs_integral((x_3 + half_1), count_2);
    const float _e24 = stairs_integral_2_((x_3 - half_1), count_2);
    return ((_e22 - _e24) / (2.0 * half_1));
}

float linear_of_srgb(float coded)
{
    float size = abs(coded);
    float value_1 = ((size <= 0.04045) ? (size / 12.92) : pow(((size + 0.055) / 1.055), 2.4));
    return value_1;
}

float srgb_of_linear(float light)
{
    float size_1 = abs(light);
    float value_2 = ((size_1 <= 0.0031308) ? (size_1 * 12.92) : ((1.055 * pow(size_1, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value_2) : value_2);
}

float3 oklab_of_linear(float3 rgb)
{
    float l = pow(abs(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float m = pow(abs(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float s_2 = pow(abs(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return float3((((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_2)), (((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_2)), (((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_2)));
}

float3 linear_of_oklab(float3 lab)
{
    float l_1 = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m_1 = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s_3 = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    float3 cubes = float3(((l_1 * l_1) * l_1), ((m_1 * m_1) * m_1), ((s_3 * s_3) * s_3));
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

float3 srgb_of_oklab(float3 lab_1)
{
    const float3 _e1 = linear_of_oklab(lab_1);
    const float _e3 = srgb_of_linear(_e1.x);
    const float _e5 = srgb_of_linear(_e1.y);
    const float _e7 = srgb_of_linear(_e1.z);
    return float3(_e3, _e5, _e7);
}

float4 limit_color(float4 color, float limit, float softness)
{
    float knee = (1.0 - softness);
    float brightest = max(max(color.x, color.y), color.z);
    if ((brightest <= knee)) {
        return float4(color.xyz, 2.0);
    }
    float room = (limit - knee);
    float above = (brightest - knee);
    float pressed = (knee + (min(above, room) * (max(above, room) / (above + room))));
    return float4((color.xyz * min((pressed / brightest), 1.0)), 2.0);
}

float4 posterize_lightness(float4 color_1, int steps, float softness_1)
{
    float3 coded_1 = clamp(color_1.xyz, (0.0).xxx, (1.0).xxx);
    const float _e10 = linear_of_srgb(coded_1.x);
    const float _e12 = linear_of_srgb(coded_1.y);
    const float _e14 = linear_of_srgb(coded_1.z);
    const float3 _e16 = oklab_of_linear(float3(_e10, _e12, _e14));
    const float _e25 = footprint_of(_e16.x);
    const float _e30 = stairs_filtered((6.0 * clamp(_e16.x, 0.0, 1.0)), 6.0, length(float2((6.0 * _e25), softness_1)));
    float stepped = clamp((_e30 / 5.0), 0.0, 1.0);
    float kept = ((_e16.x > 0.0001) ? (stepped / max(_e16.x, 0.0001)) : 0.0);
    const float3 _e50 = srgb_of_oklab(float3(stepped, (_e16.yz * min(kept, 1.0))));
    return float4(clamp(_e50, (0.0).xxx, (1.0).xxx), 2.0);
}

Angle parametrization_diffuse_balanced(Light light_1, float3 normal)
{
    const Angle angle_2 = ConstructAngle((0.5 * length((normal - light_1.direction))), (0.5 * length((normal + light_1.direction))));
    return angle_2;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_1)
{
    float2 place = float2((u_2.half_sin - 0.0), u_2.half_cos);
    const float _e9 = profile_soft_quick(place.x, shape_1);
    if ((w_1 < (0.1 * shape_1.edge_deviation))) {
        return _e9;
    }
    float r = (0.19364917 * w_1);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e35 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    const float _e43 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

float4 sum_of_lights_color(float4 value, float4 before_sum, float reach)
{
    return ((reach > 0.0) ? float4((before_sum.xyz + value.xyz), 1.0) : before_sum);
}

float4 shade(Surface surface)
{
    Light _e3 = look.moon;
    const Angle _e5 = parametrization_diffuse_balanced(_e3, surface.normal);
    const float _e8 = profile_balanced(_e5, 0.0, lamps_moon_tone_shape);
    float4 _e11 = look.lamps_moon_strength;
    float4 lamps_moon_lit = (_e11 * float4((_e8).xxx, 1.0));
    Light _e18 = look.violet;
    const Angle _e20 = parametrization_diffuse_balanced(_e18, surface.normal);
    const float _e23 = profile_balanced(_e20, 0.0, lamps_moon_tone_shape);
    float4 _e26 = look.lamps_violet_strength;
    float4 lamps_violet_lit = (_e26 * float4((_e23).xxx, 1.0));
    Light _e33 = look.rose;
    const Angle _e35 = parametrization_diffuse_balanced(_e33, surface.normal);
    const float _e38 = profile_balanced(_e35, 0.0, lamps_moon_tone_shape);
    float4 _e41 = look.lamps_rose_strength;
    float4 lamps_rose_lit = (_e41 * float4((_e38).xxx, 1.0));
    Light _e48 = look.amber;
    const Angle _e50 = parametrization_diffuse_balanced(_e48, surface.normal);
    const float _e53 = profile_balanced(_e50, 0.0, lamps_moon_tone_shape);
    float4 _e56 = look.lamps_amber_strength;
    float4 lamps_amber_lit = (_e56 * float4((_e53).xxx, 1.0));
    Light _e63 = look.gold;
    const Angle _e65 = parametrization_diffuse_balanced(_e63, surface.normal);
    const float _e68 = profile_balanced(_e65, 0.0, lamps_moon_tone_shape);
    float4 _e71 = look.lamps_gold_strength;
    float4 lamps_gold_lit = (_e71 * float4((_e68).xxx, 1.0));
    Light _e78 = look.coral;
    const Angle _e80 = parametrization_diffuse_balanced(_e78, surface.normal);
    const float _e83 = profile_balanced(_e80, 0.0, lamps_moon_tone_shape);
    float4 _e86 = look.lamps_coral_strength;
    float4 lamps_coral_lit = (_e86 * float4((_e83).xxx, 1.0));
    Light _e93 = look.magenta;
    const Angle _e95 = parametrization_diffuse_balanced(_e93, surface.normal);
    const float _e98 = profile_balanced(_e95, 0.0, lamps_moon_tone_shape);
    float4 _e101 = look.lamps_magenta_strength;
    float4 lamps_magenta_lit = (_e101 * float4((_e98).xxx, 1.0));
    Light _e108 = look.cobalt;
    const Angle _e110 = parametrization_diffuse_balanced(_e108, surface.normal);
    const float _e113 = profile_balanced(_e110, 0.0, lamps_moon_tone_shape);
    float4 _e116 = look.lamps_cobalt_strength;
    float4 lamps_cobalt_lit = (_e116 * float4((_e113).xxx, 1.0));
    Light _e123 = look.turquoise;
    const Angle _e125 = parametrization_diffuse_balanced(_e123, surface.normal);
    const float _e128 = profile_balanced(_e125, 0.0, lamps_moon_tone_shape);
    float4 _e131 = look.lamps_turquoise_strength;
    float4 lamps_turquoise_lit = (_e131 * float4((_e128).xxx, 1.0));
    Light _e138 = look.azure;
    const Angle _e140 = parametrization_diffuse_balanced(_e138, surface.normal);
    const float _e143 = profile_balanced(_e140, 0.0, lamps_moon_tone_shape);
    float4 _e146 = look.lamps_azure_strength;
    float4 lamps_azure_lit = (_e146 * float4((_e143).xxx, 1.0));
    float _e164 = look.azure_intensity;
    float4 lamps_azure_sum = ((_e164 > 0.0) ? float4(((0.0).xxx + lamps_azure_lit.xyz), 1.0) : float4(0.0, 0.0, 0.0, 1.0));
    float _e170 = look.turquoise_intensity;
    const float4 _e171 = sum_of_lights_color(lamps_turquoise_lit, lamps_azure_sum, _e170);
    float _e174 = look.cobalt_intensity;
    const float4 _e175 = sum_of_lights_color(lamps_cobalt_lit, _e171, _e174);
    float _e178 = look.magenta_intensity;
    const float4 _e179 = sum_of_lights_color(lamps_magenta_lit, _e175, _e178);
    float _e182 = look.coral_intensity;
    const float4 _e183 = sum_of_lights_color(lamps_coral_lit, _e179, _e182);
    float _e186 = look.gold_intensity;
    const float4 _e187 = sum_of_lights_color(lamps_gold_lit, _e183, _e186);
    float _e190 = look.amber_intensity;
    const float4 _e191 = sum_of_lights_color(lamps_amber_lit, _e187, _e190);
    float _e194 = look.rose_intensity;
    const float4 _e195 = sum_of_lights_color(lamps_rose_lit, _e191, _e194);
    float _e198 = look.violet_intensity;
    const float4 _e199 = sum_of_lights_color(lamps_violet_lit, _e195, _e198);
    float _e202 = look.moon_intensity;
    const float4 _e203 = sum_of_lights_color(lamps_moon_lit, _e199, _e202);
    float4 dark = ((_e203 * float4(0.44, 0.44, 0.44, 1.0)) + float4(0.07, 0.05, 0.1, 1.0));
    const float4 _e218 = posterize_lightness(dark, int(6), 0.04);
    const float4 _e221 = limit_color(_e218, 1.0, 0.4);
    return float4(_e221.xyz, 1.0);
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = ConstructSurface(normal_3);
    const float4 _e7 = shade(surface_1);
    return _e7;
}
