#version 450 core
// Ten lights, one edge after the sum: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// lights-summed.json says what to put there and how to draw.
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light moon;
    float moon_intensity;
    Light violet;
    float violet_intensity;
    Light rose;
    float rose_intensity;
    Light amber;
    float amber_intensity;
    Light gold;
    float gold_intensity;
    Light coral;
    float coral_intensity;
    Light magenta;
    float magenta_intensity;
    Light cobalt;
    float cobalt_intensity;
    Light turquoise;
    float turquoise_intensity;
    Light azure;
    float azure_intensity;
    vec4 lamps_moon_strength;
    vec4 lamps_violet_strength;
    vec4 lamps_rose_strength;
    vec4 lamps_amber_strength;
    vec4 lamps_gold_strength;
    vec4 lamps_coral_strength;
    vec4 lamps_magenta_strength;
    vec4 lamps_cobalt_strength;
    vec4 lamps_turquoise_strength;
    vec4 lamps_azure_strength;
};
struct Surface {
    vec3 normal;
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
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const ProfileShape lamps_moon_tone_shape = ProfileShape(1.0, 0.0, 1.6002629, 1.8073579, 0.0, 0.71386534, 0.30130044, 0u);

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, u_1.half_cos));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float footprint_of(float x) {
    float _e1 = dFdx(x);
    float _e2 = dFdy(x);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float stairs_integral(float x_1, float count) {
    float inside = min(x_1, count);
    float stair = min(floor(inside), 5.0);
    float beyond = max((x_1 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 5.0));
}

float stairs_integral_2_(float x_2, float count_1) {
    float inside_1 = max(x_2, 0.0);
    float stair_1 = floor(inside_1);
    return ((stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0);
}

float stairs_filtered(float x_3, float count_2, float w) {
    if ((w <= 1.0)) {
        float edge = clamp(roundEven(x_3), 1.0, 5.0);
        return ((edge - 1.0) + clamp((0.5 + ((x_3 - edge) / w)), 0.0, 1.0));
    }
    float half_1 = (0.5 * w);
    float _e22 = stairs_integral((x_3 + half_1), count_2);
    float _e24 = stairs_integral_2_((x_3 - half_1), count_2);
    return ((_e22 - _e24) / (2.0 * half_1));
}

float linear_of_srgb(float coded) {
    float size = abs(coded);
    float value_1 = ((size <= 0.04045) ? (size / 12.92) : pow(((size + 0.055) / 1.055), 2.4));
    return value_1;
}

float srgb_of_linear(float light) {
    float size_1 = abs(light);
    float value_2 = ((size_1 <= 0.0031308) ? (size_1 * 12.92) : ((1.055 * pow(size_1, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value_2) : value_2);
}

vec3 oklab_of_linear(vec3 rgb) {
    float l = pow(abs(dot(rgb, vec3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float m = pow(abs(dot(rgb, vec3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float s_2 = pow(abs(dot(rgb, vec3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return vec3((((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_2)), (((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_2)), (((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_2)));
}

vec3 linear_of_oklab(vec3 lab) {
    float l_1 = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m_1 = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s_3 = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    vec3 cubes = vec3(((l_1 * l_1) * l_1), ((m_1 * m_1) * m_1), ((s_3 * s_3) * s_3));
    return vec3(dot(cubes, vec3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, vec3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, vec3(-0.0041960864, -0.7034186, 1.7076147)));
}

vec3 srgb_of_oklab(vec3 lab_1) {
    vec3 _e1 = linear_of_oklab(lab_1);
    float _e3 = srgb_of_linear(_e1.x);
    float _e5 = srgb_of_linear(_e1.y);
    float _e7 = srgb_of_linear(_e1.z);
    return vec3(_e3, _e5, _e7);
}

vec4 limit_color(vec4 color, float limit, float softness) {
    float knee = (1.0 - softness);
    float brightest = max(max(color.x, color.y), color.z);
    if ((brightest <= knee)) {
        return vec4(color.xyz, 2.0);
    }
    float room = (limit - knee);
    float above = (brightest - knee);
    float pressed = (knee + (min(above, room) * (max(above, room) / (above + room))));
    return vec4((color.xyz * min((pressed / brightest), 1.0)), 2.0);
}

vec4 posterize_lightness(vec4 color_1, int steps, float softness_1) {
    vec3 coded_1 = clamp(color_1.xyz, vec3(0.0), vec3(1.0));
    float _e10 = linear_of_srgb(coded_1.x);
    float _e12 = linear_of_srgb(coded_1.y);
    float _e14 = linear_of_srgb(coded_1.z);
    vec3 _e16 = oklab_of_linear(vec3(_e10, _e12, _e14));
    float _e25 = footprint_of(_e16.x);
    float _e30 = stairs_filtered((6.0 * clamp(_e16.x, 0.0, 1.0)), 6.0, length(vec2((6.0 * _e25), softness_1)));
    float stepped = clamp((_e30 / 5.0), 0.0, 1.0);
    float kept = ((_e16.x > 0.0001) ? (stepped / max(_e16.x, 0.0001)) : 0.0);
    vec3 _e50 = srgb_of_oklab(vec3(stepped, (_e16.yz * min(kept, 1.0))));
    return vec4(clamp(_e50, vec3(0.0), vec3(1.0)), 2.0);
}

Angle parametrization_diffuse_balanced(Light light_1, vec3 normal) {
    return Angle((0.5 * length((normal - light_1.direction))), (0.5 * length((normal + light_1.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_1) {
    vec2 place = vec2((u_2.half_sin - 0.0), u_2.half_cos);
    float _e9 = profile_soft_quick(place.x, shape_1);
    if ((w_1 < (0.1 * shape_1.edge_deviation))) {
        return _e9;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e35 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    float _e43 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e35) + (8.0 * _e9)) + (5.0 * _e43)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

vec4 sum_of_lights_color(vec4 value, vec4 before_sum, float reach) {
    return ((reach > 0.0) ? vec4((before_sum.xyz + value.xyz), 1.0) : before_sum);
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.moon;
    Angle _e5 = parametrization_diffuse_balanced(_e3, surface.normal);
    float _e8 = profile_balanced(_e5, 0.0, lamps_moon_tone_shape);
    vec4 _e11 = u_look.lamps_moon_strength;
    vec4 lamps_moon_lit = (_e11 * vec4(vec3(_e8), 1.0));
    Light _e18 = u_look.violet;
    Angle _e20 = parametrization_diffuse_balanced(_e18, surface.normal);
    float _e23 = profile_balanced(_e20, 0.0, lamps_moon_tone_shape);
    vec4 _e26 = u_look.lamps_violet_strength;
    vec4 lamps_violet_lit = (_e26 * vec4(vec3(_e23), 1.0));
    Light _e33 = u_look.rose;
    Angle _e35 = parametrization_diffuse_balanced(_e33, surface.normal);
    float _e38 = profile_balanced(_e35, 0.0, lamps_moon_tone_shape);
    vec4 _e41 = u_look.lamps_rose_strength;
    vec4 lamps_rose_lit = (_e41 * vec4(vec3(_e38), 1.0));
    Light _e48 = u_look.amber;
    Angle _e50 = parametrization_diffuse_balanced(_e48, surface.normal);
    float _e53 = profile_balanced(_e50, 0.0, lamps_moon_tone_shape);
    vec4 _e56 = u_look.lamps_amber_strength;
    vec4 lamps_amber_lit = (_e56 * vec4(vec3(_e53), 1.0));
    Light _e63 = u_look.gold;
    Angle _e65 = parametrization_diffuse_balanced(_e63, surface.normal);
    float _e68 = profile_balanced(_e65, 0.0, lamps_moon_tone_shape);
    vec4 _e71 = u_look.lamps_gold_strength;
    vec4 lamps_gold_lit = (_e71 * vec4(vec3(_e68), 1.0));
    Light _e78 = u_look.coral;
    Angle _e80 = parametrization_diffuse_balanced(_e78, surface.normal);
    float _e83 = profile_balanced(_e80, 0.0, lamps_moon_tone_shape);
    vec4 _e86 = u_look.lamps_coral_strength;
    vec4 lamps_coral_lit = (_e86 * vec4(vec3(_e83), 1.0));
    Light _e93 = u_look.magenta;
    Angle _e95 = parametrization_diffuse_balanced(_e93, surface.normal);
    float _e98 = profile_balanced(_e95, 0.0, lamps_moon_tone_shape);
    vec4 _e101 = u_look.lamps_magenta_strength;
    vec4 lamps_magenta_lit = (_e101 * vec4(vec3(_e98), 1.0));
    Light _e108 = u_look.cobalt;
    Angle _e110 = parametrization_diffuse_balanced(_e108, surface.normal);
    float _e113 = profile_balanced(_e110, 0.0, lamps_moon_tone_shape);
    vec4 _e116 = u_look.lamps_cobalt_strength;
    vec4 lamps_cobalt_lit = (_e116 * vec4(vec3(_e113), 1.0));
    Light _e123 = u_look.turquoise;
    Angle _e125 = parametrization_diffuse_balanced(_e123, surface.normal);
    float _e128 = profile_balanced(_e125, 0.0, lamps_moon_tone_shape);
    vec4 _e131 = u_look.lamps_turquoise_strength;
    vec4 lamps_turquoise_lit = (_e131 * vec4(vec3(_e128), 1.0));
    Light _e138 = u_look.azure;
    Angle _e140 = parametrization_diffuse_balanced(_e138, surface.normal);
    float _e143 = profile_balanced(_e140, 0.0, lamps_moon_tone_shape);
    vec4 _e146 = u_look.lamps_azure_strength;
    vec4 lamps_azure_lit = (_e146 * vec4(vec3(_e143), 1.0));
    float _e164 = u_look.azure_intensity;
    vec4 lamps_azure_sum = ((_e164 > 0.0) ? vec4((vec3(0.0) + lamps_azure_lit.xyz), 1.0) : vec4(0.0, 0.0, 0.0, 1.0));
    float _e170 = u_look.turquoise_intensity;
    vec4 _e171 = sum_of_lights_color(lamps_turquoise_lit, lamps_azure_sum, _e170);
    float _e174 = u_look.cobalt_intensity;
    vec4 _e175 = sum_of_lights_color(lamps_cobalt_lit, _e171, _e174);
    float _e178 = u_look.magenta_intensity;
    vec4 _e179 = sum_of_lights_color(lamps_magenta_lit, _e175, _e178);
    float _e182 = u_look.coral_intensity;
    vec4 _e183 = sum_of_lights_color(lamps_coral_lit, _e179, _e182);
    float _e186 = u_look.gold_intensity;
    vec4 _e187 = sum_of_lights_color(lamps_gold_lit, _e183, _e186);
    float _e190 = u_look.amber_intensity;
    vec4 _e191 = sum_of_lights_color(lamps_amber_lit, _e187, _e190);
    float _e194 = u_look.rose_intensity;
    vec4 _e195 = sum_of_lights_color(lamps_rose_lit, _e191, _e194);
    float _e198 = u_look.violet_intensity;
    vec4 _e199 = sum_of_lights_color(lamps_violet_lit, _e195, _e198);
    float _e202 = u_look.moon_intensity;
    vec4 _e203 = sum_of_lights_color(lamps_moon_lit, _e199, _e202);
    vec4 dark = ((_e203 * vec4(0.44, 0.44, 0.44, 1.0)) + vec4(0.07, 0.05, 0.1, 1.0));
    vec4 _e218 = posterize_lightness(dark, 6, 0.04);
    vec4 _e221 = limit_color(_e218, 1.0, 0.4);
    return vec4(_e221.xyz, 1.0);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal_1);
    vec4 _e7 = shade(surface_1);
    out_color = _e7;
    return;
}

