// A string of lamps: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// string-of-lamps.json says what to put there and how to draw.
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

struct EachLight {
    row_major float3x3 own_from_world;
    int _pad1_0;
    float3 color;
    float intensity;
    float3 position;
    int _pad4_0;
    float2 fading;
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
    EachLight lights[36];
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 position;
    int _end_pad_0;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct LightParts {
    float3 direction;
    int _pad1_0;
    float4 color;
    float intensity;
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

static const ProfileShape lamps_tone_shape = ConstructProfileShape(0.90044713, 0.43496552, 10.016686, 2.4912605, 0.9, 0.09820393, 0.042312488, 0u);
static const ProfileShape moon_tone_shape = ConstructProfileShape(0.90044713, 0.43496552, 2.9163208, 3.0838382, 0.9, 0.3121117, 0.13987324, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) & (largest < 1e30)))) {
        return otherwise;
    }
    float3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    const bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
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
    float s_2 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_2, u_1.half_cos));
    float2 turned = (((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
}

float bounded(float x_1)
{
    uint bits = asuint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_2, float low, float high)
{
    const float _e3 = bounded(x_2);
    const float _e7 = bounded(((_e3 - low) / (high - low)));
    float t_1 = clamp(_e7, 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float srgb_of_linear(float light)
{
    float size = abs(light);
    float value = ((size <= 0.0031308) ? (size * 12.92) : ((1.055 * pow(size, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value) : value);
}

float3 oklab_of_linear(float3 rgb)
{
    float l = pow(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s_3 = pow(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return float3((((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_3)), (((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_3)), (((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_3)));
}

float3 linear_of_oklab(float3 lab)
{
    float l_1 = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m_1 = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s_4 = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    float3 cubes = float3(((l_1 * l_1) * l_1), ((m_1 * m_1) * m_1), ((s_4 * s_4) * s_4));
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

float3 oklab_of_srgb(float3 coded)
{
    const float3 _e23 = oklab_of_linear(float3(pow(((coded.x + 0.055) / 1.055), 2.4), pow(((coded.y + 0.055) / 1.055), 2.4), pow(((coded.z + 0.055) / 1.055), 2.4)));
    return _e23;
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
        return float4(color.xyz, 1.0);
    }
    float room = (limit - knee);
    float above = (brightest - knee);
    float pressed = (knee + (min(above, room) * (max(above, room) / (above + room))));
    return float4((color.xyz * min((pressed / brightest), 1.0)), 1.0);
}

float4 mix_evenly_oklab(float4 a, float4 b, float factor)
{
    const float3 _e4 = oklab_of_srgb(a.xyz);
    const float3 _e6 = oklab_of_srgb(b.xyz);
    const float3 _e8 = srgb_of_oklab(lerp(_e4, _e6, factor));
    return ((factor <= 0.0) ? a : ((factor >= 1.0) ? b : float4(_e8, 1.0)));
}

float light_fading(float distance_, float2 fading)
{
    float left = 1.0;

    if ((fading.x > 0.0)) {
        float d = min((distance_ / fading.x), 1000000000000000.0);
        left = (1.0 / (1.0 + (d * d)));
    }
    if ((fading.y > 0.0)) {
        float d_1 = min((distance_ / fading.y), 1.0);
        float window = max((1.0 - (((d_1 * d_1) * d_1) * d_1)), 0.0);
        float _e30 = left;
        left = (_e30 * (window * window));
    }
    float _e33 = left;
    return _e33;
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light light_at(float3 light_position, float3x3 own_from_world, float3 color_1, float intensity, float2 fading_1, float3 position)
{
    float3 offset = (light_position - position);
    const float3 _e11 = normalize_or(offset, float3(0.0, 0.0, 1.0));
    const float _e13 = light_fading(length(offset), fading_1);
    float faded = (intensity * _e13);
    const Light light_1 = ConstructLight(_e11, mul(_e11, own_from_world), color_1, faded);
    return light_1;
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
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

LightParts ConstructLightParts(float3 arg0, float4 arg1, float arg2) {
    LightParts ret = (LightParts)0;
    ret.direction = arg0;
    ret.color = arg1;
    ret.intensity = arg2;
    return ret;
}

float4 shade(Surface surface)
{
    float4 lamps_brightest = float4(0.0, 0.0, 0.0, 1.0);
    uint each = 0u;

    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e96 = each;
            each = (_e96 + 1u);
        }
        loop_init = false;
        uint _e9 = each;
        if ((_e9 < 36u)) {
        } else {
            break;
        }
        {
            uint _e14 = each;
            float3 _e17 = look.lights[_e14].position;
            uint _e20 = each;
            float3x3 _e23 = look.lights[_e20].own_from_world;
            uint _e26 = each;
            float3 _e29 = look.lights[_e26].color;
            uint _e32 = each;
            float _e35 = look.lights[_e32].intensity;
            uint _e38 = each;
            float2 _e41 = look.lights[_e38].fading;
            const Light _e43 = light_at(_e17, _e23, _e29, _e35, _e41, surface.position);
            LightParts light_2_ = ConstructLightParts(_e43.direction, float4(_e43.color, 1.0), _e43.intensity);
            Angle lamps_angle = ConstructAngle((0.5 * length((surface.normal - _e43.direction))), (0.5 * length((surface.normal + _e43.direction))));
            const float _e65 = profile_balanced(lamps_angle, 0.0, lamps_tone_shape);
            const float _e69 = eased(light_2_.intensity, 0.5, 0.55);
            float lamps_bands = lerp(0.55, 1.0, _e69);
            const float _e76 = eased(light_2_.intensity, 0.2, 0.24);
            float lamps_reach = (_e65 * (lamps_bands * _e76));
            float4 lamps_lit = (light_2_.color * float4((lamps_reach).xxx, 1.0));
            float4 _e84 = lamps_brightest;
            float4 _e85 = lamps_brightest;
            lamps_brightest = ((light_2_.intensity > 0.0) ? float4(max(_e85.xyz, lamps_lit.xyz), 1.0) : _e84);
        }
    }
    float3 _e102 = look.moon.direction;
    float3 _e111 = look.moon.direction;
    Angle moon_angle = ConstructAngle((0.5 * length((surface.normal - _e102))), (0.5 * length((surface.normal + _e111))));
    const float _e119 = profile_balanced(moon_angle, 0.0, moon_tone_shape);
    const float4 _e130 = mix_evenly_oklab(float4(0.07, 0.08, 0.16, 1.0), float4(0.2, 0.24, 0.4, 1.0), _e119);
    float4 _e131 = lamps_brightest;
    const float4 _e139 = limit_color(float4((_e131.xyz + _e130.xyz), 1.0), 1.0, 0.3);
    return _e139;
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
    float4x4 _e10 = view.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.position = arg1;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = ConstructSurface(normal_2, in_.position);
    const float4 _e8 = shade(surface_1);
    return _e8;
}
