#version 330 core
// Curvature as color: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// mean-curvature.json says what to put there and how to draw.
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light key;
};
struct Surface {
    vec3 normal;
    float kappa;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct RampPlace {
    vec4 before;
    vec4 after;
    float t;
};
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp hollow_flat_ridge = Ramp(vec4[16](vec4(0.0588, 0.1294, 0.2706, 1.0), vec4(0.1843, 0.3725, 0.5412, 1.0), vec4(0.7255, 0.7647, 0.7059, 1.0), vec4(0.9255, 0.8902, 0.7961, 1.0), vec4(0.8902, 0.749, 0.502, 1.0), vec4(0.7804, 0.4627, 0.1843, 1.0), vec4(1.0, 0.9529, 0.8627, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.25, 0.44, 0.5), vec4(0.6, 0.8, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 0u);

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float srgb_of_linear(float light) {
    float size = abs(light);
    float value_1 = ((size <= 0.0031308) ? (size * 12.92) : ((1.055 * pow(size, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value_1) : value_1);
}

vec3 oklab_of_linear(vec3 rgb) {
    float l = pow(dot(rgb, vec3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, vec3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s = pow(dot(rgb, vec3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return vec3((((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s)), (((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s)), (((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s)));
}

vec3 linear_of_oklab(vec3 lab) {
    float l_1 = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m_1 = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s_1 = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    vec3 cubes = vec3(((l_1 * l_1) * l_1), ((m_1 * m_1) * m_1), ((s_1 * s_1) * s_1));
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

RampPlace ramp_place(Ramp ramp, float x_1) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint i = 1u;
    uint at = 0u;
    colors = ramp.colors;
    places = ramp.places;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e27 = i;
            i = (_e27 + 1u);
        }
        loop_init = false;
        uint _e10 = i;
        if (!((_e10 < 7u))) {
            break;
        }
        uint _e14 = at;
        uint _e15 = i;
        uint _e16 = i;
        uint _e20 = i;
        float _e24 = places[(_e16 / 4u)][(_e20 % 4u)];
        at = ((_e24 <= x_1) ? _e15 : _e14);
    }
    uint _e30 = at;
    uint after = min((_e30 + 1u), 6u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places[(_e35 / 4u)][(_e39 % 4u)];
    float _e51 = places[(after / 4u)][(after % 4u)];
    float _e53 = divided((x_1 - place), (_e51 - place));
    float t = clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    vec4 _e59 = colors[_e57];
    vec4 _e61 = colors[after];
    return RampPlace(_e59, _e61, t);
}

vec4 ramp_oklab(float value, Ramp ramp_1) {
    RampPlace _e2 = ramp_place(ramp_1, value);
    vec3 _e5 = oklab_of_srgb(_e2.before.xyz);
    vec3 _e8 = oklab_of_srgb(_e2.after.xyz);
    vec3 _e11 = srgb_of_oklab(mix(_e5, _e8, _e2.t));
    return ((_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : vec4(_e11, 1.0)));
}

float reflectance_half_lambert(Light light_1, vec3 normal) {
    float half_ = (0.5 + (0.5 * dot(normal, light_1.direction)));
    return min((half_ * half_), 1.0);
}

vec4 shade(Surface surface) {
    float curvature = surface.kappa;
    float from_hollow_to_ridge = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.045), -20.0, 20.0))))))));
    vec4 _e21 = ramp_oklab(from_hollow_to_ridge, hollow_flat_ridge);
    Light _e24 = u_look.key;
    float _e26 = reflectance_half_lambert(_e24, surface.normal);
    float in_the_dark = (1.0 - _e26);
    vec4 shade_2_ = clamp(vec4((_e21.xyz * mix(vec3(1.0), vec3(0.42, 0.4, 0.55), in_the_dark)), 1.0), vec4(0.0), vec4(1.0));
    return shade_2_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e11 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_1, _e11.x);
    vec4 _e14 = shade(surface_1);
    out_color = _e14;
    return;
}

