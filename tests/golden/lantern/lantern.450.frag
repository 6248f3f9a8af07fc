#version 450 core
// Lantern: made by Chiaro 0.1.0, GLSL 4.50.
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

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_1) {
    float whole_1 = roundEven(x_1);
    float f_1 = (x_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * 0.5);
}

float log2_stable(float x_2) {
    uint bits = floatBitsToUint(x_2);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log2_stable_2_(float x_3) {
    uint bits_1 = floatBitsToUint(x_3);
    float mantissa_1 = uintBitsToFloat((bits_1 - 0u));
    float z_1 = ((mantissa_1 - 1.0) / (mantissa_1 + 1.0));
    float z2_1 = (z_1 * z_1);
    return (0.0 + (z_1 * (2.88539 + (z2_1 * (0.96179885 + (z2_1 * (0.57671434 + (z2_1 * 0.4317379))))))));
}

float log2_stable_3_(float x_4) {
    uint bits_2 = floatBitsToUint(x_4);
    float mantissa_2 = uintBitsToFloat((bits_2 - 0u));
    float z_2 = ((mantissa_2 - 1.0) / (mantissa_2 + 1.0));
    float z2_2 = (z_2 * z_2);
    return (z_2 * (2.88539 + (z2_2 * (0.96179885 + (z2_2 * (0.57671434 + (z2_2 * 0.4317379)))))));
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x_5) {
    uint bits_3 = floatBitsToUint(x_5);
    uint magnitude = (bits_3 & 2147483647u);
    float largest = uintBitsToFloat(((bits_3 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_5 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float powered(float base, float exponent) {
    float magnitude_1 = abs(base);
    float _e5 = log2_stable(max(magnitude_1, SMALLEST_NORMAL));
    float _e7 = exp2_stable((exponent * _e5));
    return ((magnitude_1 < SMALLEST_NORMAL) ? 0.0 : _e7);
}

float srgb_of_linear(float light) {
    float size = abs(light);
    float _e3 = powered(size, 0.41666666);
    float value_1 = ((size <= 0.0031308) ? (size * 12.92) : ((1.055 * _e3) - 0.055));
    return ((light < 0.0) ? -(value_1) : value_1);
}

vec3 oklab_of_linear(vec3 rgb) {
    float _e6 = log2_stable(dot(rgb, vec3(0.41222146, 0.53633255, 0.051445995)));
    float _e9 = exp2_stable_2_((0.33333334 * _e6));
    float _e15 = log2_stable(dot(rgb, vec3(0.2119035, 0.6806995, 0.10739696)));
    float _e18 = exp2_stable((0.33333334 * _e15));
    float _e24 = log2_stable(dot(rgb, vec3(0.08830246, 0.28171885, 0.6299787)));
    float _e27 = exp2_stable((0.33333334 * _e24));
    return vec3((((0.21045426 * _e9) + (0.7936178 * _e18)) - (0.004072047 * _e27)), (((1.9779985 * _e9) - (2.4285922 * _e18)) + (0.4505937 * _e27)), (((0.025904037 * _e9) + (0.78277177 * _e18)) - (0.80867577 * _e27)));
}

vec3 oklab_of_linear_2_(vec3 rgb_1) {
    float _e6 = log2_stable_3_(dot(rgb_1, vec3(0.41222146, 0.53633255, 0.051445995)));
    float _e9 = exp2_stable_2_((0.33333334 * _e6));
    float _e15 = log2_stable(dot(rgb_1, vec3(0.2119035, 0.6806995, 0.10739696)));
    float _e18 = exp2_stable_2_((0.33333334 * _e15));
    float _e24 = log2_stable(dot(rgb_1, vec3(0.08830246, 0.28171885, 0.6299787)));
    float _e27 = exp2_stable((0.33333334 * _e24));
    return vec3((((0.21045426 * _e9) + (0.7936178 * _e18)) - (0.004072047 * _e27)), (((1.9779985 * _e9) - (2.4285922 * _e18)) + (0.4505937 * _e27)), (((0.025904037 * _e9) + (0.78277177 * _e18)) - (0.80867577 * _e27)));
}

vec3 linear_of_oklab(vec3 lab) {
    float l = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    vec3 cubes = vec3(((l * l) * l), ((m * m) * m), ((s * s) * s));
    return vec3(dot(cubes, vec3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, vec3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, vec3(-0.0041960864, -0.7034186, 1.7076147)));
}

vec3 oklab_of_srgb(vec3 coded) {
    float _e6 = log2_stable_2_(((coded.x + 0.055) / 1.055));
    float _e9 = exp2_stable((2.4 * _e6));
    float _e15 = log2_stable(((coded.y + 0.055) / 1.055));
    float _e18 = exp2_stable((2.4 * _e15));
    float _e24 = log2_stable(((coded.z + 0.055) / 1.055));
    float _e27 = exp2_stable((2.4 * _e24));
    vec3 _e29 = oklab_of_linear(vec3(_e9, _e18, _e27));
    return _e29;
}

vec3 oklab_of_srgb_2_(vec3 coded_1) {
    float _e2 = log2_stable_2_(1.0);
    float _e5 = exp2_stable_2_((2.4 * _e2));
    float _e11 = log2_stable_3_(((coded_1.y + 0.055) / 1.055));
    float _e14 = exp2_stable((2.4 * _e11));
    float _e20 = log2_stable(((coded_1.z + 0.055) / 1.055));
    float _e23 = exp2_stable((2.4 * _e20));
    vec3 _e25 = oklab_of_linear_2_(vec3(_e5, _e14, _e23));
    return _e25;
}

vec3 srgb_of_oklab(vec3 lab_1) {
    vec3 _e1 = linear_of_oklab(lab_1);
    float _e3 = srgb_of_linear(_e1.x);
    float _e5 = srgb_of_linear(_e1.y);
    float _e7 = srgb_of_linear(_e1.z);
    return vec3(_e3, _e5, _e7);
}

RampPlace ramp_place(Ramp ramp, float x_6) {
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
        at = ((_e21 <= x_6) ? _e15 : _e14);
    }
    uint _e27 = at;
    uint after = min((_e27 + 1u), 2u);
    uint _e33 = at;
    float place = places[0][(_e33 % 4u)];
    float _e43 = places[0][(after % 4u)];
    float _e45 = divided((x_6 - place), (_e43 - place));
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

vec4 shade(Surface surface_1) {
    float facing = clamp(dot(surface_1.normal, surface_1.view), 0.0, 1.0);
    vec4 _e8 = ramp_oklab(facing, glow);
    return _e8;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0));
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    surface.normal = normal;
    vec4 _e11 = u_view.eye;
    float _e16 = u_view.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    Surface _e21 = surface;
    vec4 _e22 = shade(_e21);
    out_color = _e22;
    return;
}

