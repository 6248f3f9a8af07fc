#version 450 core
// Guest: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// room-guest.json says what to put there and how to draw.
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    vec3 eye_position;
    mat3x3 eye_own_from_world;
    vec3 eye_color;
    float eye_intensity;
    vec2 eye_fading;
    vec3 rim_position;
    vec3 rim_aim;
    mat3x3 rim_own_from_world;
    vec3 rim_color;
    float rim_intensity;
    vec2 rim_cone;
    vec2 rim_fading;
    vec3 fill_position;
    mat3x3 fill_own_from_world;
    vec3 fill_color;
    float fill_intensity;
    vec2 fill_fading;
    vec3 sun_direction;
    Light sun;
};
struct Surface {
    vec3 normal;
    vec3 position;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct LitLayer {
    vec4 color;
    float tone;
};
struct FilteredLight {
    Light light;
    Angle angle;
};
struct LightParts {
    vec3 direction;
    vec4 color;
    float intensity;
};
struct PlaceInLight {
    vec2 uv;
    float inside;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const ProfileShape lamps_eye_tone_shape = ProfileShape(0.87758255, 0.47942555, 8.353367, 2.4874215, 1.0, 0.117860116, 0.05078552, 0u);

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) && (largest < 1e30)))) {
        return otherwise;
    }
    vec3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_1.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_3 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c = (u_2.half_cos + 0.0);
    vec2 upper_1 = ((c <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c));
    vec2 turned_1 = (((s_3 <= 0.0) && (s_3 < c)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec3 bounded_vec3_(vec3 v_3) {
    uvec3 bits_1 = floatBitsToUint(v_3);
    uvec3 magnitude_1 = (bits_1 & uvec3(2147483647u));
    vec3 largest_2 = uintBitsToFloat(((bits_1 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest_2, equal(magnitude_1, uvec3(2139095040u)));
    return mix(numbers, v_3, lessThan(magnitude_1, uvec3(2139095040u)));
}

vec4 bounded_vec4_(vec4 v_4) {
    uvec4 bits_2 = floatBitsToUint(v_4);
    uvec4 magnitude_2 = (bits_2 & uvec4(2147483647u));
    vec4 largest_3 = uintBitsToFloat(((bits_2 & uvec4(2147483648u)) | uvec4(2139095039u)));
    vec4 numbers_1 = mix(vec4(0.0), largest_3, equal(magnitude_2, uvec4(2139095040u)));
    return mix(numbers_1, v_4, lessThan(magnitude_2, uvec4(2139095040u)));
}

float place_between(float x_2, float low, float high) {
    float span = (high - low);
    if ((span < SMALLEST_NORMAL)) {
        return ((x_2 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(((x_2 - low) / span));
    return _e12;
}

float eased(float x_3, float low_1, float high_1) {
    float _e3 = place_between(x_3, low_1, high_1);
    float t_2 = clamp(_e3, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float footprint_of(float x_4) {
    float _e1 = dFdx(x_4);
    float _e2 = dFdy(x_4);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float luminance(vec4 color) {
    return dot(color.xyz, vec3(0.2126, 0.7152, 0.0722));
}

vec4 limit_color(vec4 color_1, float limit, float softness) {
    float knee = (1.0 - softness);
    float brightest = max(max(color_1.x, color_1.y), color_1.z);
    if ((brightest <= knee)) {
        return vec4(color_1.xyz, 1.0);
    }
    float room = (limit - knee);
    float above = (brightest - knee);
    float pressed = (knee + (min(above, room) * (max(above, room) / (above + room))));
    return vec4((color_1.xyz * min((pressed / brightest), 1.0)), 1.0);
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 leaning = cross(up, toward);
    float square_2 = dot(leaning, leaning);
    vec3 aside = ((abs(toward.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    vec3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e28, cross(toward, _e28), toward);
}

mat3x3 axes_turned(vec3 toward_1, float spin) {
    mat3x3 _e6 = axes_around(toward_1, vec3(0.0, 1.0, 0.0));
    vec2 turn = vec2(0.0, 1.0);
    return mat3x3(((turn.y * _e6[0]) + (turn.x * _e6[1])), ((turn.y * _e6[1]) - (turn.x * _e6[0])), _e6[2]);
}

vec3 place_along(vec3 place, vec3 center, mat3x3 axes) {
    vec3 away = clamp((place - center), vec3(-1000000.0), vec3(1000000.0));
    return vec3(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

float share_beside(float m, float softness_1, float density, bool inverted) {
    float _e4 = footprint_of(m);
    float half_1 = (0.5 * min(_e4, 0.25));
    float _e13 = eased(m, (1.0 - half_1), (1.0 + half_1));
    return (1.0 - _e13);
}

Angle angle_filtered(Angle u_3, float share) {
    float cosine = (u_3.half_cos * share);
    float square_3 = ((u_3.half_sin * u_3.half_sin) + (cosine * cosine));
    float scale = inversesqrt(max(square_3, 1e-30));
    bool is_dark = (square_3 < 1e-30);
    return Angle((is_dark ? 1.0 : (u_3.half_sin * scale)), (is_dark ? 0.0 : (cosine * scale)));
}

float light_fading(float distance_, vec2 fading) {
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

Light light_at(vec3 light_position, mat3x3 own_from_world, vec3 color_2, float intensity, vec2 fading_1, vec3 position) {
    vec3 offset = (light_position - position);
    vec3 _e11 = normalize_or(offset, vec3(0.0, 0.0, 1.0));
    float _e13 = light_fading(length(offset), fading_1);
    float faded = (intensity * _e13);
    return Light(_e11, (own_from_world * _e11), color_2, faded);
}

float light_cone(float cos_angle, vec2 cone) {
    if ((cone.x <= cone.y)) {
        return ((cos_angle >= cone.y) ? 1.0 : 0.0);
    }
    float t_3 = clamp(((cos_angle - cone.y) / (cone.x - cone.y)), 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

Light light_spot(vec3 light_position_1, vec3 aim, mat3x3 own_from_world_1, vec3 color_3, float intensity_1, vec2 cone_1, vec2 fading_2, vec3 position_1) {
    Light light = Light(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    Light _e8 = light_at(light_position_1, own_from_world_1, color_3, intensity_1, fading_2, position_1);
    light = _e8;
    float _e11 = light.intensity;
    vec3 _e13 = light.direction;
    float _e16 = light_cone(dot(-(_e13), aim), cone_1);
    light.intensity = (_e11 * _e16);
    Light _e18 = light;
    return _e18;
}

LitLayer light_apply(Light light_1, vec4 color_4, float tone) {
    vec2 split = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_4.xyz * light_1.color) * split.y), 1.0), (tone * split.x));
}

LightParts light_parts(Light light_2) {
    return LightParts(light_2.direction, vec4(light_2.color, 1.0), light_2.intensity);
}

PlaceInLight place_in_light(vec2 at) {
    vec2 near = clamp(at, vec2(-1000.0), vec2(1000.0));
    float _e14 = share_beside(max(abs(near.x), abs(near.y)), 0.0, 1.0, true);
    return PlaceInLight((vec2(0.5) + (0.5 * vec2(-(near.x), near.y))), _e14);
}

Angle parametrization_diffuse_balanced(Light light_3, vec3 normal) {
    return Angle((0.5 * length((normal - light_3.direction))), (0.5 * length((normal + light_3.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1) {
    float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_4, float w_1, ProfileShape shape_2) {
    vec2 place_1 = vec2(((u_4.half_sin * shape_2.half_cos_offset) - (u_4.half_cos * shape_2.half_sin_offset)), ((u_4.half_cos * shape_2.half_cos_offset) + (u_4.half_sin * shape_2.half_sin_offset)));
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place_1.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_1);
    vec2 turn_1 = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_2);
    float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_3) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_4) {
    Angle _e6 = angle_turned_2_(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float window(vec2 uv, float bars, float softness_2) {
    vec2 from_edge = (vec2(0.5) - abs((uv - vec2(0.5))));
    vec2 from_cross = abs((uv - vec2(0.5)));
    vec2 within = smoothstep(vec2(bars), vec2((bars + softness_2)), from_edge);
    vec2 beside = smoothstep(vec2((0.5 * bars)), vec2(((0.5 * bars) + softness_2)), from_cross);
    return (((within.x * within.y) * beside.x) * beside.y);
}

vec4 shade(Surface surface) {
    vec3 _e3 = u_look.eye_position;
    mat3x3 _e6 = u_look.eye_own_from_world;
    vec3 _e9 = u_look.eye_color;
    float _e12 = u_look.eye_intensity;
    vec2 _e15 = u_look.eye_fading;
    Light _e17 = light_at(_e3, _e6, _e9, _e12, _e15, surface.position);
    LightParts _e18 = light_parts(_e17);
    vec4 _e25 = bounded_vec4_((_e18.color * vec4(vec3(_e18.intensity), 1.0)));
    Angle _e27 = parametrization_diffuse_balanced(_e17, surface.normal);
    float _e30 = profile_balanced(_e27, 0.0, lamps_eye_tone_shape);
    vec4 _e35 = bounded_vec4_((_e25 * vec4(vec3(_e30), 1.0)));
    vec3 _e38 = u_look.rim_position;
    vec3 _e41 = u_look.rim_aim;
    mat3x3 _e44 = u_look.rim_own_from_world;
    vec3 _e47 = u_look.rim_color;
    float _e50 = u_look.rim_intensity;
    vec2 _e53 = u_look.rim_cone;
    vec2 _e56 = u_look.rim_fading;
    Light _e58 = light_spot(_e38, _e41, _e44, _e47, _e50, _e53, _e56, surface.position);
    LightParts _e59 = light_parts(_e58);
    vec4 _e66 = bounded_vec4_((_e59.color * vec4(vec3(_e59.intensity), 1.0)));
    Angle _e68 = parametrization_diffuse_balanced(_e58, surface.normal);
    float _e71 = profile_balanced(_e68, 0.0, lamps_eye_tone_shape);
    vec4 _e76 = bounded_vec4_((_e66 * vec4(vec3(_e71), 1.0)));
    vec3 _e79 = u_look.fill_position;
    mat3x3 _e82 = u_look.fill_own_from_world;
    vec3 _e85 = u_look.fill_color;
    float _e88 = u_look.fill_intensity;
    vec2 _e91 = u_look.fill_fading;
    Light _e93 = light_at(_e79, _e82, _e85, _e88, _e91, surface.position);
    LightParts _e94 = light_parts(_e93);
    vec4 _e101 = bounded_vec4_((_e94.color * vec4(vec3(_e94.intensity), 1.0)));
    Angle _e103 = parametrization_diffuse_balanced(_e93, surface.normal);
    float _e106 = profile_balanced(_e103, 0.0, lamps_eye_tone_shape);
    vec4 _e111 = bounded_vec4_((_e101 * vec4(vec3(_e106), 1.0)));
    vec3 _e121 = bounded_vec3_((vec3(0.0) + _e111.xyz));
    vec4 lamps_fill_sum = ((_e94.intensity > 0.0) ? vec4(_e121, 1.0) : vec4(0.0, 0.0, 0.0, 1.0));
    vec3 _e131 = bounded_vec3_((lamps_fill_sum.xyz + _e76.xyz));
    vec4 lamps_rim_sum = ((_e59.intensity > 0.0) ? vec4(_e131, 1.0) : lamps_fill_sum);
    vec3 _e141 = bounded_vec3_((lamps_rim_sum.xyz + _e35.xyz));
    vec4 lamps_eye_sum = ((_e18.intensity > 0.0) ? vec4(_e141, 1.0) : lamps_rim_sum);
    vec4 lamplit = (lamps_eye_sum * vec4(0.86, 0.62, 0.44, 1.0));
    vec4 night = (lamplit + vec4(0.1, 0.07, 0.15, 1.0));
    vec4 ground = vec4(night.xyz, 1.0);
    Light _e165 = u_look.sun;
    Angle _e167 = parametrization_diffuse_balanced(_e165, surface.normal);
    vec3 _e175 = u_look.sun_direction;
    mat3x3 _e178 = axes_turned(-(_e175), 0.0);
    vec3 _e179 = place_along(surface.position, vec3(0.1, -0.05, 0.0), _e178);
    PlaceInLight _e184 = place_in_light((_e179.xy / vec2(0.95)));
    float _e188 = window(_e184.uv, 0.05, 0.02);
    Light _e191 = u_look.sun;
    float _e196 = luminance(vec4(1.0));
    Angle _e200 = angle_filtered(_e167, (min(_e188, 1.0) * min(_e196, 1.0)));
    FilteredLight filter_2_ = FilteredLight(_e191, _e200);
    float _e205 = profile_balanced_2_(filter_2_.angle, 0.0, lamps_eye_tone_shape);
    LitLayer _e212 = light_apply(filter_2_.light, vec4(0.86, 0.62, 0.44, 1.0), _e205);
    vec4 stack = clamp(vec4((ground.xyz + (_e212.tone * _e212.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e228 = limit_color(stack, 1.0, 0.3);
    return _e228;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal_1, in_.position);
    vec4 _e8 = shade(surface_1);
    out_color = _e8;
    return;
}

