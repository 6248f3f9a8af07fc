#version 330 core
// Lantern: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// lantern.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Surface {
    vec3 normal;
    vec3 view;
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
    vec3 position;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp glow = Ramp(vec4[16](vec4(0.851, 0.4118, 0.1647, 1.0), vec4(1.0, 0.7804, 0.3961, 1.0), vec4(1.0, 0.9647, 0.8471, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.45, 1.0, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 3u, 0u);

layout(std140) uniform ViewBlock { View u_view; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
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

vec3 oklab_of_srgb_2_(vec3 coded_1) {
    vec3 _e17 = oklab_of_linear(vec3(1.0, pow(((coded_1.y + 0.055) / 1.055), 2.4), pow(((coded_1.z + 0.055) / 1.055), 2.4)));
    return _e17;
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
            uint _e24 = i;
            i = (_e24 + 1u);
        }
        loop_init = false;
        uint _e10 = i;
        if (!((_e10 < 3u))) {
            break;
        }
        uint _e14 = at;
        uint _e15 = i;
        uint _e17 = i;
        float _e21 = places[0][(_e17 % 4u)];
        at = ((_e21 <= x_1) ? _e15 : _e14);
    }
    uint _e27 = at;
    uint after = min((_e27 + 1u), 2u);
    uint _e33 = at;
    float place = places[0][(_e33 % 4u)];
    float _e43 = places[0][(after % 4u)];
    float _e45 = divided((x_1 - place), (_e43 - place));
    float t = clamp(_e45, 0.0, 1.0);
    uint _e49 = at;
    vec4 _e51 = colors[_e49];
    vec4 _e53 = colors[after];
    return RampPlace(_e51, _e53, t);
}

vec4 ramp_oklab(float value, Ramp ramp_1) {
    RampPlace _e2 = ramp_place(ramp_1, value);
    vec3 _e5 = oklab_of_srgb(_e2.before.xyz);
    vec3 _e8 = oklab_of_srgb_2_(_e2.after.xyz);
    vec3 _e11 = srgb_of_oklab(mix(_e5, _e8, _e2.t));
    return ((_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : vec4(_e11, 1.0)));
}

vec4 shade(Surface surface) {
    vec4 _e8 = ramp_oklab(clamp(dot(surface.normal, surface.view), 0.0, 1.0), glow);
    return _e8;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal, normalize((_e8.xyz - (_e13 * in_.position))));
    vec4 _e19 = shade(surface_1);
    out_color = _e19;
    return;
}

