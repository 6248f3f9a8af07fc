#version 300 es
// Exaggerated shape: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_smooth_normal_1_map 0, u_smooth_normal_2_map 1, u_smooth_normal_3_map 2, u_smooth_normal_4_map 3.
// shape-exaggerated.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
    vec2 viewport;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 smooth_normal_1_;
    vec3 smooth_normal_2_;
    vec3 smooth_normal_3_;
    vec3 smooth_normal_4_;
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
const Ramp from_dusk_to_sun = Ramp(vec4[16](vec4(0.1373, 0.1647, 0.302, 1.0), vec4(0.4196, 0.3725, 0.5255, 1.0), vec4(0.7882, 0.5804, 0.4353, 1.0), vec4(0.9412, 0.8039, 0.5725, 1.0), vec4(1.0, 0.9843, 0.902, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.05, 0.35, 0.55, 0.75), vec4(0.98, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_smooth_normal_1_map;

uniform highp sampler2D u_smooth_normal_2_map;

uniform highp sampler2D u_smooth_normal_3_map;

uniform highp sampler2D u_smooth_normal_4_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * 0.5);
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
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

RampPlace ramp_place(Ramp ramp, float x_3) {
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
        at = ((_e24 <= x_3) ? _e15 : _e14);
    }
    uint _e30 = at;
    uint after = min((_e30 + 1u), 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places[(_e35 / 4u)][(_e39 % 4u)];
    float _e51 = places[(after / 4u)][(after % 4u)];
    float _e53 = divided((x_3 - place), (_e51 - place));
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

float detail_lit(vec3 finer, vec3 coarser, vec3 light_1, float contrast) {
    vec3 across = (light_1 - (dot(light_1, coarser) * coarser));
    vec3 toward = (across / vec3(max(length(across), 0.05)));
    return clamp((contrast * dot(finer, toward)), -1.0, 1.0);
}

float exaggerated_four(Light light_2, vec3 normal, float contrast_1, float detail, vec3 smooth_1_, vec3 smooth_2_, vec3 smooth_3_, vec3 smooth_4_) {
    float _e9 = exp2_stable(-(detail));
    vec3 _e10 = normalize_moderate(smooth_1_, normal);
    vec3 _e11 = normalize_moderate(smooth_2_, _e10);
    vec3 _e12 = normalize_moderate(smooth_3_, _e11);
    vec3 _e13 = normalize_moderate(smooth_4_, _e12);
    float _e15 = detail_lit(_e11, _e12, light_2.direction, contrast_1);
    float _e17 = detail_lit(_e12, _e13, light_2.direction, contrast_1);
    float coarse = (_e15 + (_e9 * (_e17 + (_e9 * dot(_e13, light_2.direction)))));
    float _e25 = detail_lit(normal, _e10, light_2.direction, contrast_1);
    float _e27 = detail_lit(_e10, _e11, light_2.direction, contrast_1);
    float sum = (_e25 + (_e9 * (_e27 + (_e9 * coarse))));
    return clamp((0.5 + ((0.5 * sum) / (1.0 + (_e9 * (1.0 + (_e9 * (1.0 + (_e9 * (1.0 + _e9))))))))), 0.0, 1.0);
}

float outer_contour(float width, vec3 normal_1, vec3 view, vec2 viewport) {
    float facing = clamp(dot(normal_1, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport.y, 1.0, 100000.0)) / 1000.0);
    float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.key;
    float _e11 = exaggerated_four(_e3, surface.normal, 7.0, 0.1, surface.smooth_normal_1_, surface.smooth_normal_2_, surface.smooth_normal_3_, surface.smooth_normal_4_);
    vec4 _e13 = ramp_oklab(_e11, from_dusk_to_sun);
    vec2 _e19 = u_look.viewport;
    float _e20 = outer_contour(3.0, surface.normal, surface.view, _e19);
    vec4 inked = mix(_e13, vec4(0.098, 0.1059, 0.2, 1.0), _e20);
    return inked;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = texelFetch(u_smooth_normal_1_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e29 = u_view.camera_from_world;
    vec4 _e37 = texelFetch(u_smooth_normal_2_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e43 = u_view.camera_from_world;
    vec4 _e51 = texelFetch(u_smooth_normal_3_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e57 = u_view.camera_from_world;
    vec4 _e65 = texelFetch(u_smooth_normal_4_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e71 = u_view.camera_from_world;
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))), (vec4(_e23.xyz, 0.0) * _e29).xyz, (vec4(_e37.xyz, 0.0) * _e43).xyz, (vec4(_e51.xyz, 0.0) * _e57).xyz, (vec4(_e65.xyz, 0.0) * _e71).xyz);
    vec4 _e75 = shade(surface_1);
    out_color = _e75;
    return;
}

