#version 330 core
// Contours: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0, u_smooth_normal_4_map 1.
// contours.json says what to put there and how to draw.
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
    mat3x3 camera_from_world;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_camera;
    vec3 curvature_tensor;
    vec3 smooth_normal_4_;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp three_washes = Ramp(vec4[16](vec4(0.7255, 0.7686, 0.8118, 1.0), vec4(0.8627, 0.8627, 0.8235, 1.0), vec4(0.9725, 0.949, 0.8863, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.16, 0.42, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 3u, 2u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_tensor_map;

uniform sampler2D u_smooth_normal_4_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
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

float footprint_of(float x_1) {
    float _e1 = dFdx(x_1);
    float _e2 = dFdy(x_1);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float footprint_of_2_(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d_1 = vec2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float step_filtered(float x_3, float edge, float w) {
    float d_2 = (x_3 - edge);
    return ((w < 1e-30) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_2 / w)), 0.0, 1.0));
}

vec4 ramp_at(Ramp ramp, float x_4, float w_1) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color = vec4(0.0);
    uint i = 1u;
    colors = ramp.colors;
    places = ramp.places;
    vec4 _e8 = colors[0];
    color = _e8;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e35 = i;
            i = (_e35 + 1u);
        }
        loop_init = false;
        uint _e12 = i;
        if (!((_e12 < 3u))) {
            break;
        }
        vec4 _e16 = color;
        uint _e17 = i;
        vec4 _e19 = colors[_e17];
        uint _e20 = i;
        vec4 _e24 = colors[(_e20 - 1u)];
        uint _e27 = i;
        float _e31 = places[0][(_e27 % 4u)];
        float _e32 = step_filtered(x_4, _e31, w_1);
        color = (_e16 + ((_e19 - _e24) * _e32));
    }
    vec4 _e38 = color;
    return _e38;
}

vec2 principal_curvatures(vec3 tensor) {
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(vec2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? vec2(far, _e26) : vec2(_e26, far));
}

float reflectance_half_lambert(Light light, vec3 normal) {
    float half_ = (0.5 + (0.5 * dot(normal, light.direction)));
    return min((half_ * half_), 1.0);
}

float inner_contour_suggestive(float width, float limit, float softness, vec3 tensor_1, vec3 normal_1, vec3 view, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n = (camera_from_world * normal_1);
    float square_1 = dot(n.xy, n.xy);
    float radial = (((((tensor_1.x * n.x) * n.x) + (((2.0 * tensor_1.y) * n.x) * n.y)) + ((tensor_1.z * n.y) * n.y)) / max(square_1, 1e-6));
    float _e35 = dFdx(radial);
    float _e36 = dFdy(radial);
    vec2 change = vec2(_e35, _e36);
    vec3 v_2 = (camera_from_world * view);
    vec3 row = dFdy(place);
    float up = (((row - (dot(row, v_2) * v_2)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * inversesqrt(max(square_1, 1e-6)));
    float pixels = ((1.5 * height) / 1000.0);
    float distance_ = (abs(radial) / max(length(change), 1e-6));
    float x_6 = ((toward_eye * height) * 0.05);
    float _e79 = footprint_of(x_6);
    float strength = clamp((0.5 + ((x_6 - limit) / length(vec2(min(_e79, 1000000000000000.0), 22.0)))), 0.0, 1.0);
    return ((clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * strength) * smoothstep(0.05, 0.3, dot(normal_1, view)));
}

float faded_in(float x_5, float limit_1, float softness_1) {
    float _e3 = footprint_of(x_5);
    float width_2 = length(vec2(min(_e3, 1000000000000000.0), 45.0));
    float _e9 = bounded(x_5);
    float _e11 = bounded((_e9 - limit_1));
    return clamp((0.5 + (_e11 / width_2)), 0.0, 1.0);
}

float outer_contour(float width_1, vec3 normal_2, vec3 view_1, vec2 viewport_1) {
    float facing = clamp(dot(normal_2, view_1), 0.0, 1.0);
    float pixels_1 = ((width_1 * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    float _e15 = footprint_of_2_(facing);
    float distance_1 = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels_1 + 0.5) - distance_1), 0.0, min(pixels_1, 1.0)) * near);
}

vec4 shade(Surface surface) {
    vec3 _e3 = normalize_moderate(surface.smooth_normal_4_, surface.normal);
    Light _e6 = u_look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    float _e9 = footprint_of_2_(_e7);
    vec4 _e10 = ramp_at(three_washes, _e7, _e9);
    vec2 _e12 = principal_curvatures(surface.curvature_tensor);
    float _e17 = faded_in(-(_e12.y), 45.0, 1.0);
    float hollows = (_e17 * smoothstep(0.05, 0.3, dot(surface.normal, surface.view)));
    vec4 hollows_in_sepia = mix(_e10, vec4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    mat3x3 _e39 = u_look.camera_from_world;
    vec2 _e43 = u_look.viewport;
    float _e44 = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor, surface.normal, surface.view, _e39, surface.position_camera, _e43);
    vec2 _e50 = u_look.viewport;
    float _e51 = outer_contour(5.0, surface.normal, surface.view, _e50);
    float all_lines = max(_e44, _e51);
    vec4 ink = mix(hollows_in_sepia, vec4(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return ink;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    mat4x4 _e20 = u_view.camera_from_world;
    vec4 _e31 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    vec4 _e38 = texelFetch(u_smooth_normal_4_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e44 = u_view.camera_from_world;
    Surface surface_1 = Surface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), (_e20 * vec4(in_.position, 1.0)).xyz, _e31.xyz, (vec4(_e38.xyz, 0.0) * _e44).xyz);
    vec4 _e48 = shade(surface_1);
    out_color = _e48;
    return;
}

