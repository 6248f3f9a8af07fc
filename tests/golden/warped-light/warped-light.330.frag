#version 330 core
// Warped light: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// warped-light.json says what to put there and how to draw.
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
    Light back;
    Light key;
    mat3x3 camera_from_world;
};
struct Surface {
    vec3 normal;
    vec3 view;
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
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp jade = Ramp(vec4[16](vec4(0.0157, 0.1294, 0.1216, 1.0), vec4(0.0588, 0.3529, 0.298, 1.0), vec4(0.2471, 0.6275, 0.4784, 1.0), vec4(0.7137, 0.8784, 0.6902, 1.0), vec4(0.9333, 0.9725, 0.8471, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.35, 0.65, 0.9), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_tensor_map;

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

float exp2_stable(float x_1) {
    float clamped = clamp(x_1, -126.0, 127.99999);
    float whole = roundEven(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float exp2_stable_2_(float x_2) {
    float clamped_1 = max(x_2, -126.0);
    float whole_1 = roundEven(clamped_1);
    float f_1 = (clamped_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen_balanced(vec3 v_2) {
    return (v_2 * inversesqrt(max(dot(v_2, v_2), 1e-30)));
}

float bounded(float x_3) {
    uint bits = floatBitsToUint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_4) {
    float _e1 = dFdx(x_4);
    float _e2 = dFdy(x_4);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
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
    vec3 _e30 = oklab_of_linear(vec3(((coded.x <= 0.04045) ? (coded.x / 12.92) : pow(((coded.x + 0.055) / 1.055), 2.4)), pow(((coded.y + 0.055) / 1.055), 2.4), pow(((coded.z + 0.055) / 1.055), 2.4)));
    return _e30;
}

vec3 oklab_of_srgb_2_(vec3 coded_1) {
    vec3 _e23 = oklab_of_linear(vec3(pow(((coded_1.x + 0.055) / 1.055), 2.4), pow(((coded_1.y + 0.055) / 1.055), 2.4), pow(((coded_1.z + 0.055) / 1.055), 2.4)));
    return _e23;
}

vec3 srgb_of_oklab(vec3 lab_1) {
    vec3 _e1 = linear_of_oklab(lab_1);
    float _e3 = srgb_of_linear(_e1.x);
    float _e5 = srgb_of_linear(_e1.y);
    float _e7 = srgb_of_linear(_e1.z);
    return vec3(_e3, _e5, _e7);
}

RampPlace ramp_place(Ramp ramp, float x_5) {
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
        at = ((_e24 <= x_5) ? _e15 : _e14);
    }
    uint _e30 = at;
    uint after = min((_e30 + 1u), 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place_1 = places[(_e35 / 4u)][(_e39 % 4u)];
    float _e51 = places[(after / 4u)][(after % 4u)];
    float _e53 = divided((x_5 - place_1), (_e51 - place_1));
    float t = clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    vec4 _e59 = colors[_e57];
    vec4 _e61 = colors[after];
    return RampPlace(_e59, _e61, t);
}

vec4 mix_colors_screen(vec4 a_1, vec4 b_1, float factor) {
    return vec4(mix(a_1.xyz, ((a_1.xyz + b_1.xyz) - (a_1.xyz * b_1.xyz)), min(factor, 1.0)), 1.0);
}

vec4 mix_colors_screen_2_(vec4 a_2, vec4 b_2, float factor_1) {
    return vec4(mix(a_2.xyz, ((a_2.xyz + b_2.xyz) - (a_2.xyz * b_2.xyz)), factor_1), 1.0);
}

float curvature_signed(float kappa, float slope) {
    float a_4 = (clamp(kappa, -10000.0, 10000.0) * slope);
    float magnitude_1 = min(abs(a_4), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_4 * a_4);
        return (a_4 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e25 = exp2_stable_2_((-2.88539 * magnitude_1));
    float t_1 = ((1.0 - _e25) / (1.0 + _e25));
    return ((a_4 >= 0.0) ? t_1 : -(t_1));
}

vec2 principal_curvatures(vec3 tensor) {
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(vec2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? vec2(far, _e26) : vec2(_e26, far));
}

vec3 half_of(vec3 light_1, vec3 normal, vec3 view) {
    vec3 half_ = (light_1 + view);
    vec3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(vec3 a_3, vec3 b_3) {
    vec3 across = cross(a_3, b_3);
    return min(dot(across, across), 1.0);
}

Reflection reflection_of(vec3 light_2, vec3 normal_1, vec3 view_1) {
    vec3 _e3 = half_of(light_2, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection(dot(normal_1, light_2), dot(normal_1, view_1), n_h, v_h, _e14);
}

float schlick(float at_normal, float cosine) {
    float m_2 = (1.0 - cosine);
    float m2_ = (m_2 * m_2);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m_2)));
}

float ggx(Reflection r, float width, float at_normal_1) {
    if (((r.n_l <= 0.0) || (r.n_v <= 0.0))) {
        return 0.0;
    }
    float a2_1 = (width * width);
    float bottom = max((r.sine2_ + ((a2_1 * r.n_h) * r.n_h)), 1e-12);
    float distribution = (a2_1 / (bottom * bottom));
    float toward_light = (r.n_v * sqrt((((r.n_l * r.n_l) * (1.0 - a2_1)) + a2_1)));
    float toward_eye = (r.n_l * sqrt((((r.n_v * r.n_v) * (1.0 - a2_1)) + a2_1)));
    float visibility = (0.5 / max((toward_light + toward_eye), 1e-9));
    float _e49 = schlick(at_normal_1, r.v_h);
    return min((((distribution * visibility) * _e49) * r.n_l), 1000000.0);
}

vec4 ramp_oklab(float value, Ramp ramp_1) {
    RampPlace _e2 = ramp_place(ramp_1, value);
    vec3 _e5 = oklab_of_srgb(_e2.before.xyz);
    vec3 _e8 = oklab_of_srgb_2_(_e2.after.xyz);
    vec3 _e11 = srgb_of_oklab(mix(_e5, _e8, _e2.t));
    return ((_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : vec4(_e11, 1.0)));
}

float rim(Light light_3, vec3 normal_2, vec3 view_2, float width_1, float softness, float follow) {
    float facing = clamp(dot(normal_2, view_2), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = max((width_1 * softness), min(_e11, 1.0));
    vec3 aside = (normal_2 - view_2);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - 0.5) : (width_1 - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    vec3 across_1 = (light_3.direction - (dot(light_3.direction, view_2) * view_2));
    float side = dot((normal_2 - (dot(normal_2, view_2) * view_2)), (across_1 * inversesqrt(max(dot(across_1, across_1), 1e-30))));
    return (inside * mix(1.0, smoothstep(0.0, 0.5, side), follow));
}

vec2 warped_place(vec3 tensor_1, vec2 place, float amount, float slope_1) {
    vec2 _e4 = principal_curvatures(tensor_1);
    float _e7 = curvature_signed(_e4.x, slope_1);
    float _e9 = exp2_stable((-(amount) * _e7));
    float _e12 = curvature_signed(_e4.y, slope_1);
    float _e14 = exp2_stable((-(amount) * _e12));
    vec2 half_apart = vec2((0.5 * (tensor_1.x - tensor_1.z)), tensor_1.y);
    vec2 axes = (half_apart / vec2(max(length(half_apart), 1e-20)));
    vec2 turned = vec2(((axes.x * place.x) + (axes.y * place.y)), ((axes.y * place.x) - (axes.x * place.y)));
    return (((0.5 * (_e9 + _e14)) * place) + ((0.5 * (_e9 - _e14)) * turned));
}

vec3 warped_light(vec3 light_4, vec3 n, vec3 view_3, mat3x3 camera_from_world, vec3 tensor_2, float amount_1, float slope_2) {
    vec3 right = (vec3(1.0, 0.0, 0.0) * camera_from_world);
    vec3 _e19 = normalize_moderate((right - (dot(right, view_3) * view_3)), vec3(1.0, 0.0, 0.0));
    vec3 y = cross(view_3, _e19);
    vec3 between = ((view_3 + n) / vec3(max((1.0 + dot(view_3, n)), 0.01)));
    vec3 along_x = (_e19 - (dot(n, _e19) * between));
    vec3 along_y = (y - (dot(n, y) * between));
    vec2 place_2 = (vec2(dot(light_4, along_x), dot(light_4, along_y)) / vec2(max((1.0 + dot(light_4, n)), 0.0001)));
    vec2 _e45 = warped_place(tensor_2, place_2, amount_1, slope_2);
    float square_2 = dot(_e45, _e45);
    vec3 _e60 = normalize_or(((((2.0 * _e45.x) * along_x) + ((2.0 * _e45.y) * along_y)) + ((1.0 - square_2) * n)), light_4);
    return _e60;
}

Light light_warp(Light light_5, vec3 normal_3, float amount_2, float slope_3, vec3 tensor_3, vec3 view_4, mat3x3 camera_from_world_1) {
    float most = (amount_2 * smoothstep(0.05, 0.3, dot(normal_3, view_4)));
    vec3 _e13 = warped_light(light_5.direction, normal_3, view_4, camera_from_world_1, tensor_3, most, slope_3);
    bool is_flat = ((most == 0.0) || false);
    return Light((is_flat ? light_5.direction : _e13), light_5.own_direction, light_5.color, light_5.intensity);
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.key;
    mat3x3 _e11 = u_look.camera_from_world;
    Light _e12 = light_warp(_e3, surface.normal, 1.4, 0.03, surface.curvature_tensor, surface.view, _e11);
    float through_the_stone = max(((dot(surface.normal, _e12.direction) + 0.6) / 1.6), 0.0);
    vec4 _e23 = ramp_oklab(through_the_stone, jade);
    Reflection _e27 = reflection_of(_e12.direction, surface.normal, surface.view);
    float _e30 = ggx(_e27, 0.1764, 0.09);
    vec4 _e36 = mix_colors_screen(_e23, vec4(1.0, 0.9569, 0.8627, 1.0), _e30);
    Light _e39 = u_look.back;
    float _e45 = rim(_e39, surface.normal, surface.view, 0.5, 0.8, 1.0);
    vec4 _e51 = mix_colors_screen_2_(_e36, vec4(0.1843, 0.5608, 0.7216, 1.0), _e45);
    return _e51;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_4 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), _e23.xyz);
    vec4 _e26 = shade(surface_1);
    out_color = _e26;
    return;
}

