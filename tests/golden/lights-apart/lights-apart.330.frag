#version 330 core
// Ten lights, each with its own edge: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// lights-apart.json says what to put there and how to draw.
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
const ProfileShape lamps_moon_tone_shape = ProfileShape(0.9358968, 0.35227424, 66.66917, 2.499803, 0.72, 0.014726315, 0.0063439487, 0u);

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
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
    float s_2 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_1.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 limit_color(vec4 color, float limit, float softness) {
    vec3 c = clamp(color.xyz, vec3(-1e18), vec3(1e18));
    float knee = (1.0 - softness);
    float brightest = max(max(c.x, c.y), c.z);
    if ((brightest <= knee)) {
        return vec4(c, 2.0);
    }
    float room = (limit - knee);
    float above = (brightest - knee);
    float pressed = (knee + (min(above, room) * (max(above, room) / (above + room))));
    return vec4((c * min((pressed / brightest), 1.0)), 2.0);
}

Angle parametrization_diffuse_balanced(Light light, vec3 normal) {
    return Angle((0.5 * length((normal - light.direction))), (0.5 * length((normal + light.direction))));
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

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_2) {
    vec2 place = vec2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_3) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
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
    vec4 dark = (_e203 + vec4(0.07, 0.05, 0.1, 1.0));
    vec4 _e212 = limit_color(dark, 1.0, 0.4);
    return vec4(_e212.xyz, 1.0);
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

