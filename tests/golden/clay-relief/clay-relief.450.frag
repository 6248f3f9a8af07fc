#version 450 core
// Clay relief: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0, u_curvature_tensor_map 1.
// clay-relief.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light sky;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    float kappa;
    vec3 curvature_tensor;
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
struct Relief {
    float shape;
    float strength;
    float greatest;
    float least;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp terracotta = Ramp(vec4[16](vec4(0.2353, 0.102, 0.1098, 1.0), vec4(0.5412, 0.251, 0.1882, 1.0), vec4(0.8118, 0.498, 0.3412, 1.0), vec4(0.949, 0.7412, 0.5725, 1.0), vec4(0.9843, 0.8627, 0.7333, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.3, 0.62, 0.9), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 0u);
const Ramp pits_to_bumps = Ramp(vec4[16](vec4(0.2941, 0.2275, 0.3216, 1.0), vec4(0.4784, 0.2902, 0.2902, 1.0), vec4(0.7529, 0.502, 0.3765, 1.0), vec4(0.9412, 0.7529, 0.5804, 1.0), vec4(1.0, 0.9412, 0.8471, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.3, 0.5, 0.75), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(binding = 1) uniform sampler2D u_curvature_tensor_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float clamped = clamp(x, -126.0, 127.99999);
    float whole = roundEven(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_1) {
    float clamped_1 = max(x_1, -126.0);
    float whole_1 = roundEven(clamped_1);
    float f_1 = (clamped_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

float atan2_positive(float y, float x_2) {
    float small = min(y, x_2);
    float large = max(y, x_2);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t = (small / large);
    bool is_wide = (t > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_3 = (is_wide ? (series + 0.7853982) : series);
    return ((y > x_2) ? (HALF_PI - a_3) : a_3);
}

float bounded(float x_3) {
    uint bits = floatBitsToUint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0));
}

vec2 bounded_vec2_(vec2 v_1) {
    uvec2 bits_1 = floatBitsToUint(v_1);
    uvec2 magnitude_1 = (bits_1 & uvec2(2147483647u));
    vec2 largest_1 = uintBitsToFloat(((bits_1 & uvec2(2147483648u)) | uvec2(2139095039u)));
    vec2 numbers = mix(vec2(0.0), largest_1, equal(magnitude_1, uvec2(2139095040u)));
    return mix(numbers, v_1, lessThan(magnitude_1, uvec2(2139095040u)));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float angle_of_point(float y_1, float x_4) {
    vec2 _e3 = bounded_vec2_(vec2(x_4, y_1));
    vec2 p = abs(_e3);
    vec2 scaled = ((max(p.x, p.y) > 1.0) ? (0.5 * p) : p);
    float _e15 = atan2_positive(scaled.y, scaled.x);
    float turned = ((x_4 < 0.0) ? (PI - _e15) : _e15);
    return ((y_1 < 0.0) ? -(turned) : turned);
}

float footprint_of(float x_5) {
    float _e1 = dFdx(x_5);
    float _e2 = dFdy(x_5);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float srgb_of_linear(float light) {
    float size = abs(light);
    float value_1 = ((size <= 0.0031308) ? (size * 12.92) : ((1.055 * pow(size, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value_1) : value_1);
}

float soft_light(float a_1, float b_1) {
    if ((b_1 <= 0.5)) {
        return (a_1 - (((1.0 - (2.0 * b_1)) * a_1) * (1.0 - a_1)));
    }
    float curved_1 = ((a_1 <= 0.25) ? (((((16.0 * a_1) - 12.0) * a_1) + 4.0) * a_1) : sqrt(max(a_1, 0.0)));
    return (a_1 + (((2.0 * b_1) - 1.0) * (curved_1 - a_1)));
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
            uint _e27 = i;
            i = (_e27 + 1u);
        }
        loop_init = false;
        uint _e10 = i;
        if (!((_e10 < 5u))) {
            break;
        }
        uint _e14 = at;
        uint _e15 = i;
        uint _e16 = i;
        uint _e20 = i;
        float _e24 = places[(_e16 / 4u)][(_e20 % 4u)];
        at = ((_e24 <= x_6) ? _e15 : _e14);
    }
    uint _e30 = at;
    uint after = min((_e30 + 1u), 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places[(_e35 / 4u)][(_e39 % 4u)];
    float _e51 = places[(after / 4u)][(after % 4u)];
    float _e53 = divided((x_6 - place), (_e51 - place));
    float t_1 = clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    vec4 _e59 = colors[_e57];
    vec4 _e61 = colors[after];
    return RampPlace(_e59, _e61, t_1);
}

vec4 mix_colors_screen(vec4 a_2, vec4 b_2, float factor) {
    return vec4(mix(a_2.xyz, ((a_2.xyz + b_2.xyz) - (a_2.xyz * b_2.xyz)), factor), 1.0);
}

float curvature_signed(float kappa, float slope) {
    float a_4 = (kappa * slope);
    float magnitude_2 = min(abs(a_4), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_4 * a_4);
        return (a_4 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e22 = exp2_stable_2_((-2.88539 * magnitude_2));
    float t_2 = ((1.0 - _e22) / (1.0 + _e22));
    return ((a_4 >= 0.0) ? t_2 : -(t_2));
}

float curvature_signed_2_(float kappa_1, float slope_1) {
    float a_5 = (min(kappa_1, 10000.0) * slope_1);
    float magnitude_3 = min(a_5, 50.0);
    if ((magnitude_3 < 0.0625)) {
        float a2_1 = (a_5 * a_5);
        return (a_5 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254)))))));
    }
    float _e23 = exp2_stable_2_((-2.88539 * magnitude_3));
    float t_3 = ((1.0 - _e23) / (1.0 + _e23));
    return t_3;
}

vec2 principal_curvatures(vec3 tensor) {
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(vec2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? vec2(far, _e26) : vec2(_e26, far));
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

float rim(Light light_2, vec3 normal_1, vec3 view, float width, float softness, float follow) {
    float facing = clamp(dot(normal_1, view), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = max((width * softness), min(_e11, 1.0));
    vec3 aside = (normal_1 - view);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    vec3 across = (light_2.direction - (dot(light_2.direction, view) * view));
    float side = dot((normal_1 - (dot(normal_1, view) * view)), (across * inversesqrt(max(dot(across, across), 1e-30))));
    return (inside * mix(1.0, smoothstep(0.0, 0.5, side), follow));
}

float radiance_scaled(float tone, float curved, float turning) {
    float _e5 = exp2_stable((curved * LOG2_E));
    float dark = (turning * (1.0 - tone));
    float light_3 = (tone * (1.0 - turning));
    return ((tone * ((_e5 * dark) + light_3)) / max((dark + (_e5 * light_3)), 1e-20));
}

float radiance_scaling(float tone_1, float kappa_2, float amount, float slope_2, float turning_1) {
    float _e5 = curvature_signed(kappa_2, slope_2);
    float curved_2 = (amount * _e5);
    float _e7 = radiance_scaled(tone_1, curved_2, turning_1);
    return min(((curved_2 == 0.0) ? tone_1 : _e7), 1.0);
}

Relief relief(vec3 tensor_1, float slope_3) {
    vec2 _e2 = principal_curvatures(tensor_1);
    float _e9 = angle_of_point((_e2.x + _e2.y), (_e2.x - _e2.y));
    float curvedness = sqrt((0.5 * dot(_e2, _e2)));
    float _e14 = curvature_signed_2_(curvedness, slope_3);
    return Relief((0.5 + (_e9 / PI)), _e14, _e2.x, _e2.y);
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.key;
    float _e5 = reflectance_half_lambert(_e3, surface.normal);
    float _e10 = radiance_scaling(_e5, surface.kappa, 1.3, 0.03, 0.9);
    vec4 _e12 = ramp_oklab(_e10, terracotta);
    Relief _e15 = relief(surface.curvature_tensor, 0.025);
    vec4 _e18 = ramp_oklab(_e15.shape, pits_to_bumps);
    float _e22 = soft_light(_e12.x, _e18.x);
    float _e25 = soft_light(_e12.y, _e18.y);
    float _e28 = soft_light(_e12.z, _e18.z);
    vec4 slip_in_the_hollows = vec4(mix(_e12.xyz, vec3(_e22, _e25, _e28), clamp(_e15.strength, 0.0, 1.0)), 1.0);
    Light _e39 = u_look.sky;
    float _e45 = rim(_e39, surface.normal, surface.view, 0.4, 0.9, 1.0);
    vec4 _e51 = mix_colors_screen(slip_in_the_hollows, vec4(0.3725, 0.498, 0.6588, 1.0), _e45);
    return _e51;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    vec4 _e30 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x, _e30.xyz);
    vec4 _e33 = shade(surface_1);
    out_color = _e33;
    return;
}

