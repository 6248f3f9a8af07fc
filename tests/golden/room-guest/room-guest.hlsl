// Guest: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// room-guest.json says what to put there and how to draw.
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
    float3 eye_position;
    int _pad1_0;
    row_major float3x3 eye_own_from_world;
    int _pad2_0;
    float3 eye_color;
    float eye_intensity;
    float2 eye_fading;
    int _pad5_0;
    int _pad5_1;
    float3 rim_position;
    int _pad6_0;
    float3 rim_aim;
    int _pad7_0;
    row_major float3x3 rim_own_from_world;
    int _pad8_0;
    float3 rim_color;
    float rim_intensity;
    float2 rim_cone;
    float2 rim_fading;
    float3 fill_position;
    int _pad13_0;
    row_major float3x3 fill_own_from_world;
    int _pad14_0;
    float3 fill_color;
    float fill_intensity;
    float2 fill_fading;
    int _pad17_0;
    int _pad17_1;
    float3 sun_direction;
    int _pad18_0;
    Light sun;
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

struct LitLayer {
    float4 color;
    float tone;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct FilteredLight {
    Light light;
    Angle angle;
    int _end_pad_0;
    int _end_pad_1;
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

struct PlaceInLight {
    float2 uv;
    float inside;
    int _end_pad_0;
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape lamps_eye_tone_shape = ConstructProfileShape(0.87758255, 0.47942555, 8.353367, 2.4874215, 1.0, 0.117860116, 0.05078552, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_2 : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_3 : LOC0;
    float3 normal_2 : LOC1;
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

float3 normalize_moderate(float3 v_1, float3 otherwise_1)
{
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * rsqrt(max(square_1, 1e-30))) : otherwise_1);
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
    float s_2 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_2, u_1.half_cos));
    float2 turned = (((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_3 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c = (u_2.half_cos + 0.0);
    float2 upper_1 = ((c <= 0.0) ? float2(1.0, 0.0) : float2(s_3, c));
    float2 turned_1 = (((s_3 <= 0.0) & (s_3 < c)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_3 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_3;
}

float bounded(float x_1)
{
    uint bits = asuint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    uint3 bits_1 = asuint(v_3);
    uint3 magnitude_1 = (bits_1 & (2147483647u).xxx);
    float3 largest_2 = asfloat(((bits_1 & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers = ((magnitude_1 == (2139095040u).xxx) ? largest_2 : (0.0).xxx);
    return ((magnitude_1 < (2139095040u).xxx) ? v_3 : numbers);
}

float4 bounded_vec4_(float4 v_4)
{
    uint4 bits_2 = asuint(v_4);
    uint4 magnitude_2 = (bits_2 & (2147483647u).xxxx);
    float4 largest_3 = asfloat(((bits_2 & (2147483648u).xxxx) | (2139095039u).xxxx));
    float4 numbers_1 = ((magnitude_2 == (2139095040u).xxxx) ? largest_3 : (0.0).xxxx);
    return ((magnitude_2 < (2139095040u).xxxx) ? v_4 : numbers_1);
}

float place_between(float x_2, float low, float high)
{
    float span = (high - low);
    if ((span < SMALLEST_NORMAL)) {
        return ((x_2 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(((x_2 - low) / span));
    return _e12;
}

float eased(float x_3, float low_1, float high_1)
{
    const float _e3 = place_between(x_3, low_1, high_1);
    float t_2 = clamp(_e3, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float footprint_of(float x_4)
{
    float _e1 = ddx(x_4);
    float _e2 = ddy(x_4);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float luminance(float4 color)
{
    return dot(color.xyz, float3(0.2126, 0.7152, 0.0722));
}

float4 limit_color(float4 color_1, float limit, float softness)
{
    float knee = (1.0 - softness);
    float brightest = max(max(color_1.x, color_1.y), color_1.z);
    if ((brightest <= knee)) {
        return float4(color_1.xyz, 1.0);
    }
    float room = (limit - knee);
    float above = (brightest - knee);
    float pressed = (knee + (min(above, room) * (max(above, room) / (above + room))));
    return float4((color_1.xyz * min((pressed / brightest), 1.0)), 1.0);
}

float3x3 axes_around(float3 toward, float3 up)
{
    float3 leaning = cross(up, toward);
    float square_2 = dot(leaning, leaning);
    float3 aside = ((abs(toward.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    const float3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), float3(1.0, 0.0, 0.0));
    return float3x3(_e28, cross(toward, _e28), toward);
}

float3x3 axes_turned(float3 toward_1, float spin)
{
    const float3x3 _e6 = axes_around(toward_1, float3(0.0, 1.0, 0.0));
    float2 turn = float2(0.0, 1.0);
    return float3x3(((turn.y * _e6[0]) + (turn.x * _e6[1])), ((turn.y * _e6[1]) - (turn.x * _e6[0])), _e6[2]);
}

float3 place_along(float3 place, float3 center_, float3x3 axes)
{
    float3 away = clamp((place - center_), (-1000000.0).xxx, (1000000.0).xxx);
    return float3(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

float share_beside(float m, float softness_1, float density, bool inverted)
{
    const float _e4 = footprint_of(m);
    float half_1 = (0.5 * min(_e4, 0.25));
    const float _e13 = eased(m, (1.0 - half_1), (1.0 + half_1));
    return (1.0 - _e13);
}

Angle angle_filtered(Angle u_3, float share)
{
    float cosine = (u_3.half_cos * share);
    float square_3 = ((u_3.half_sin * u_3.half_sin) + (cosine * cosine));
    float scale = rsqrt(max(square_3, 1e-30));
    bool is_dark = (square_3 < 1e-30);
    const Angle angle_4 = ConstructAngle((is_dark ? 1.0 : (u_3.half_sin * scale)), (is_dark ? 0.0 : (cosine * scale)));
    return angle_4;
}

float light_fading(float distance_, float2 fading)
{
    float left = 1.0;

    if ((fading.x > 0.0)) {
        float d_1 = min((distance_ / fading.x), 1000000000000000.0);
        left = (1.0 / (1.0 + (d_1 * d_1)));
    }
    if ((fading.y > 0.0)) {
        float d_2 = min((distance_ / fading.y), 1.0);
        float window_1 = max((1.0 - (((d_2 * d_2) * d_2) * d_2)), 0.0);
        float _e30 = left;
        left = (_e30 * (window_1 * window_1));
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

Light light_at(float3 light_position, float3x3 own_from_world, float3 color_2, float intensity, float2 fading_1, float3 position)
{
    float3 offset = (light_position - position);
    const float3 _e11 = normalize_or(offset, float3(0.0, 0.0, 1.0));
    const float _e13 = light_fading(length(offset), fading_1);
    float faded = (intensity * _e13);
    const Light light_4 = ConstructLight(_e11, mul(_e11, own_from_world), color_2, faded);
    return light_4;
}

float light_cone(float cos_angle, float2 cone)
{
    if ((cone.x <= cone.y)) {
        return ((cos_angle >= cone.y) ? 1.0 : 0.0);
    }
    float t_3 = clamp(((cos_angle - cone.y) / (cone.x - cone.y)), 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

Light light_spot(float3 light_position_1, float3 aim, float3x3 own_from_world_1, float3 color_3, float intensity_1, float2 cone_1, float2 fading_2, float3 position_1)
{
    Light light = (Light)0;

    const Light _e8 = light_at(light_position_1, own_from_world_1, color_3, intensity_1, fading_2, position_1);
    light = _e8;
    float _e11 = light.intensity;
    float3 _e13 = light.direction;
    const float _e16 = light_cone(dot(-(_e13), aim), cone_1);
    light.intensity = (_e11 * _e16);
    Light _e18 = light;
    const Light light_5 = _e18;
    return light_5;
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light_1, float4 color_4, float tone)
{
    float2 split = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_4.xyz * light_1.color) * split.y), 1.0), (tone * split.x));
    return litlayer;
}

LightParts ConstructLightParts(float3 arg0, float4 arg1, float arg2) {
    LightParts ret = (LightParts)0;
    ret.direction = arg0;
    ret.color = arg1;
    ret.intensity = arg2;
    return ret;
}

LightParts light_parts(Light light_2)
{
    const LightParts lightparts = ConstructLightParts(light_2.direction, float4(light_2.color, 1.0), light_2.intensity);
    return lightparts;
}

PlaceInLight ConstructPlaceInLight(float2 arg0, float arg1) {
    PlaceInLight ret = (PlaceInLight)0;
    ret.uv = arg0;
    ret.inside = arg1;
    return ret;
}

PlaceInLight place_in_light(float2 at)
{
    float2 near = clamp(at, (-1000.0).xx, (1000.0).xx);
    const float _e14 = share_beside(max(abs(near.x), abs(near.y)), 0.0, 1.0, true);
    const PlaceInLight placeinlight = ConstructPlaceInLight(((0.5).xx + (0.5 * float2(-(near.x), near.y))), _e14);
    return placeinlight;
}

Angle parametrization_diffuse_balanced(Light light_3, float3 normal)
{
    const Angle angle_5 = ConstructAngle((0.5 * length((normal - light_3.direction))), (0.5 * length((normal + light_3.direction))));
    return angle_5;
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

float profile_filtered_quick(Angle u_4, float w_1, ProfileShape shape_2)
{
    float2 place_1 = float2(((u_4.half_sin * shape_2.half_cos_offset) - (u_4.half_cos * shape_2.half_sin_offset)), ((u_4.half_cos * shape_2.half_cos_offset) + (u_4.half_sin * shape_2.half_sin_offset)));
    bool is_narrow = ((w_1 > 0.0) & (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place_1.x, w_1, shape_2);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place_1.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_1);
    float2 turn_1 = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_2);
    const float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
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
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float window(float2 uv, float bars, float softness_2)
{
    float2 from_edge = ((0.5).xx - abs((uv - (0.5).xx)));
    float2 from_cross = abs((uv - (0.5).xx));
    float2 within = smoothstep((bars).xx, ((bars + softness_2)).xx, from_edge);
    float2 beside = smoothstep(((0.5 * bars)).xx, (((0.5 * bars) + softness_2)).xx, from_cross);
    return (((within.x * within.y) * beside.x) * beside.y);
}

FilteredLight ConstructFilteredLight(Light arg0, Angle arg1) {
    FilteredLight ret = (FilteredLight)0;
    ret.light = arg0;
    ret.angle = arg1;
    return ret;
}

float4 shade(Surface surface)
{
    float3 _e3 = look.eye_position;
    float3x3 _e6 = look.eye_own_from_world;
    float3 _e9 = look.eye_color;
    float _e12 = look.eye_intensity;
    float2 _e15 = look.eye_fading;
    const Light _e17 = light_at(_e3, _e6, _e9, _e12, _e15, surface.position);
    const LightParts _e18 = light_parts(_e17);
    const float4 _e25 = bounded_vec4_((_e18.color * float4((_e18.intensity).xxx, 1.0)));
    const Angle _e27 = parametrization_diffuse_balanced(_e17, surface.normal);
    const float _e30 = profile_balanced(_e27, 0.0, lamps_eye_tone_shape);
    const float4 _e35 = bounded_vec4_((_e25 * float4((_e30).xxx, 1.0)));
    float3 _e38 = look.rim_position;
    float3 _e41 = look.rim_aim;
    float3x3 _e44 = look.rim_own_from_world;
    float3 _e47 = look.rim_color;
    float _e50 = look.rim_intensity;
    float2 _e53 = look.rim_cone;
    float2 _e56 = look.rim_fading;
    const Light _e58 = light_spot(_e38, _e41, _e44, _e47, _e50, _e53, _e56, surface.position);
    const LightParts _e59 = light_parts(_e58);
    const float4 _e66 = bounded_vec4_((_e59.color * float4((_e59.intensity).xxx, 1.0)));
    const Angle _e68 = parametrization_diffuse_balanced(_e58, surface.normal);
    const float _e71 = profile_balanced(_e68, 0.0, lamps_eye_tone_shape);
    const float4 _e76 = bounded_vec4_((_e66 * float4((_e71).xxx, 1.0)));
    float3 _e79 = look.fill_position;
    float3x3 _e82 = look.fill_own_from_world;
    float3 _e85 = look.fill_color;
    float _e88 = look.fill_intensity;
    float2 _e91 = look.fill_fading;
    const Light _e93 = light_at(_e79, _e82, _e85, _e88, _e91, surface.position);
    const LightParts _e94 = light_parts(_e93);
    const float4 _e101 = bounded_vec4_((_e94.color * float4((_e94.intensity).xxx, 1.0)));
    const Angle _e103 = parametrization_diffuse_balanced(_e93, surface.normal);
    const float _e106 = profile_balanced(_e103, 0.0, lamps_eye_tone_shape);
    const float4 _e111 = bounded_vec4_((_e101 * float4((_e106).xxx, 1.0)));
    const float3 _e121 = bounded_vec3_(((0.0).xxx + _e111.xyz));
    float4 lamps_fill_sum = ((_e94.intensity > 0.0) ? float4(_e121, 1.0) : float4(0.0, 0.0, 0.0, 1.0));
    const float3 _e131 = bounded_vec3_((lamps_fill_sum.xyz + _e76.xyz));
    float4 lamps_rim_sum = ((_e59.intensity > 0.0) ? float4(_e131, 1.0) : lamps_fill_sum);
    const float3 _e141 = bounded_vec3_((lamps_rim_sum.xyz + _e35.xyz));
    float4 lamps_eye_sum = ((_e18.intensity > 0.0) ? float4(_e141, 1.0) : lamps_rim_sum);
    float4 lamplit = (lamps_eye_sum * float4(0.86, 0.62, 0.44, 1.0));
    float4 night = (lamplit + float4(0.1, 0.07, 0.15, 1.0));
    float4 ground = float4(night.xyz, 1.0);
    Light _e165 = look.sun;
    const Angle _e167 = parametrization_diffuse_balanced(_e165, surface.normal);
    float3 _e175 = look.sun_direction;
    const float3x3 _e178 = axes_turned(-(_e175), 0.0);
    const float3 _e179 = place_along(surface.position, float3(0.1, -0.05, 0.0), _e178);
    const PlaceInLight _e184 = place_in_light((_e179.xy / (0.95).xx));
    const float _e188 = window(_e184.uv, 0.05, 0.02);
    Light _e191 = look.sun;
    const float _e196 = luminance((1.0).xxxx);
    const Angle _e200 = angle_filtered(_e167, (min(_e188, 1.0) * min(_e196, 1.0)));
    FilteredLight filter_2_ = ConstructFilteredLight(_e191, _e200);
    const float _e205 = profile_balanced_2_(filter_2_.angle, 0.0, lamps_eye_tone_shape);
    const LitLayer _e212 = light_apply(filter_2_.light, float4(0.86, 0.62, 0.44, 1.0), _e205);
    float4 stack = clamp(float4((ground.xyz + (_e212.tone * _e212.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float4 _e228 = limit_color(stack, 1.0, 0.3);
    return _e228;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_3, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = ConstructSurface(normal_3, in_.position);
    const float4 _e8 = shade(surface_1);
    return _e8;
}
