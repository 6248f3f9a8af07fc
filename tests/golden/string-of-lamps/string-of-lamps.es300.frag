#version 300 es
// A string of lamps: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// string-of-lamps.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct EachLight {
    mat3x3 own_from_world;
    vec3 color;
    float intensity;
    vec3 position;
    vec2 fading;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light moon;
    EachLight lights[36];
};
struct Surface {
    vec3 normal;
    vec3 position;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct LightParts {
    vec3 direction;
    vec4 color;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const ProfileShape lamps_tone_shape = ProfileShape(0.90044713, 0.43496552, 10.016686, 2.4912605, 0.9, 0.09820393, 0.042312488, 0u);
const ProfileShape moon_tone_shape = ProfileShape(0.90044713, 0.43496552, 2.9163208, 3.0838382, 0.9, 0.3121117, 0.13987324, 0u);

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
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

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
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

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_2, float low, float high) {
    float _e3 = bounded(x_2);
    float _e7 = bounded(((_e3 - low) / (high - low)));
    float t_1 = clamp(_e7, 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float srgb_of_linear(float light) {
    float size = abs(light);
    float value = ((size <= 0.0031308) ? (size * 12.92) : ((1.055 * pow(size, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value) : value);
}

vec3 oklab_of_linear(vec3 rgb) {
    float l = pow(dot(rgb, vec3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, vec3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s_3 = pow(dot(rgb, vec3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return vec3((((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_3)), (((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_3)), (((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_3)));
}

vec3 linear_of_oklab(vec3 lab) {
    float l_1 = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m_1 = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s_4 = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    vec3 cubes = vec3(((l_1 * l_1) * l_1), ((m_1 * m_1) * m_1), ((s_4 * s_4) * s_4));
    return vec3(dot(cubes, vec3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, vec3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, vec3(-0.0041960864, -0.7034186, 1.7076147)));
}

vec3 oklab_of_srgb(vec3 coded) {
    vec3 _e23 = oklab_of_linear(vec3(pow(((coded.x + 0.055) / 1.055), 2.4), pow(((coded.y + 0.055) / 1.055), 2.4), pow(((coded.z + 0.055) / 1.055), 2.4)));
    return _e23;
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
        return vec4(color.xyz, 1.0);
    }
    float room = (limit - knee);
    float above = (brightest - knee);
    float pressed = (knee + (min(above, room) * (max(above, room) / (above + room))));
    return vec4((color.xyz * min((pressed / brightest), 1.0)), 1.0);
}

vec4 mix_evenly_oklab(vec4 a, vec4 b, float factor) {
    vec3 _e4 = oklab_of_srgb(a.xyz);
    vec3 _e6 = oklab_of_srgb(b.xyz);
    vec3 _e8 = srgb_of_oklab(mix(_e4, _e6, factor));
    return ((factor <= 0.0) ? a : ((factor >= 1.0) ? b : vec4(_e8, 1.0)));
}

float light_fading(float distance_, vec2 fading) {
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

Light light_at(vec3 light_position, mat3x3 own_from_world, vec3 color_1, float intensity, vec2 fading_1, vec3 position) {
    vec3 offset = (light_position - position);
    vec3 _e11 = normalize_or(offset, vec3(0.0, 0.0, 1.0));
    float _e13 = light_fading(length(offset), fading_1);
    float faded = (intensity * _e13);
    return Light(_e11, (own_from_world * _e11), color_1, faded);
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

vec4 shade(Surface surface) {
    vec4 lamps_brightest = vec4(0.0, 0.0, 0.0, 1.0);
    uint each = 0u;
    bool loop_init = true;
    while(true) {
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
            vec3 _e17 = u_look.lights[_e14].position;
            uint _e20 = each;
            mat3x3 _e23 = u_look.lights[_e20].own_from_world;
            uint _e26 = each;
            vec3 _e29 = u_look.lights[_e26].color;
            uint _e32 = each;
            float _e35 = u_look.lights[_e32].intensity;
            uint _e38 = each;
            vec2 _e41 = u_look.lights[_e38].fading;
            Light _e43 = light_at(_e17, _e23, _e29, _e35, _e41, surface.position);
            LightParts light_2_ = LightParts(_e43.direction, vec4(_e43.color, 1.0), _e43.intensity);
            Angle lamps_angle = Angle((0.5 * length((surface.normal - _e43.direction))), (0.5 * length((surface.normal + _e43.direction))));
            float _e65 = profile_balanced(lamps_angle, 0.0, lamps_tone_shape);
            float _e69 = eased(light_2_.intensity, 0.5, 0.55);
            float lamps_bands = mix(0.55, 1.0, _e69);
            float _e76 = eased(light_2_.intensity, 0.2, 0.24);
            float lamps_reach = (_e65 * (lamps_bands * _e76));
            vec4 lamps_lit = (light_2_.color * vec4(vec3(lamps_reach), 1.0));
            vec4 _e84 = lamps_brightest;
            vec4 _e85 = lamps_brightest;
            lamps_brightest = ((light_2_.intensity > 0.0) ? vec4(max(_e85.xyz, lamps_lit.xyz), 1.0) : _e84);
        }
    }
    vec3 _e102 = u_look.moon.direction;
    vec3 _e111 = u_look.moon.direction;
    Angle moon_angle = Angle((0.5 * length((surface.normal - _e102))), (0.5 * length((surface.normal + _e111))));
    float _e119 = profile_balanced(moon_angle, 0.0, moon_tone_shape);
    vec4 _e130 = mix_evenly_oklab(vec4(0.07, 0.08, 0.16, 1.0), vec4(0.2, 0.24, 0.4, 1.0), _e119);
    vec4 _e131 = lamps_brightest;
    vec4 _e139 = limit_color(vec4((_e131.xyz + _e130.xyz), 1.0), 1.0, 0.3);
    return _e139;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal, in_.position);
    vec4 _e8 = shade(surface_1);
    out_color = _e8;
    return;
}

