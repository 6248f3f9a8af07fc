#version 450 core
// Contours: made by Chiaro 0.1.0, GLSL 4.50.
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

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

layout(binding = 1) uniform sampler2D u_smooth_normal_4_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
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

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
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
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float footprint_of_2_(float x_3) {
    float _e1 = dFdx(x_3);
    float _e2 = dFdy(x_3);
    vec2 d_1 = vec2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float step_filtered(float x_4, float edge, float w) {
    float d_2 = (x_4 - edge);
    return ((w < 1e-30) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_2 / w)), 0.0, 1.0));
}

vec4 ramp_at(Ramp ramp, float x_5, float w_1) {
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
        float _e32 = step_filtered(x_5, _e31, w_1);
        color = (_e16 + ((_e19 - _e24) * _e32));
    }
    vec4 _e38 = color;
    return _e38;
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

vec3 tensor_safe(vec3 tensor) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return vec3(_e2, _e4, _e6);
}

vec2 principal_curvatures(vec3 tensor_1) {
    float mean = (0.5 * (tensor_1.x + tensor_1.z));
    float spread = length(vec2((0.5 * (tensor_1.x - tensor_1.z)), tensor_1.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    float _e26 = divided(((tensor_1.x * tensor_1.z) - (tensor_1.y * tensor_1.y)), far);
    return ((mean >= 0.0) ? vec2(far, _e26) : vec2(_e26, far));
}

float reflectance_half_lambert(Light light, vec3 normal) {
    float half_ = (0.5 + (0.5 * dot(normal, light.direction)));
    return min((half_ * half_), 1.0);
}

float inner_contour_suggestive(float width, float limit, float softness, vec3 tensor_2, vec3 normal_1, vec3 view, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n = (camera_from_world * normal_1);
    vec3 _e10 = tensor_safe(tensor_2);
    float square_1 = dot(n.xy, n.xy);
    float radial = (((((_e10.x * n.x) * n.x) + (((2.0 * _e10.y) * n.x) * n.y)) + ((_e10.z * n.y) * n.y)) / max(square_1, 1e-6));
    float _e36 = dFdx(radial);
    float _e37 = dFdy(radial);
    vec2 change = vec2(_e36, _e37);
    vec3 v_2 = (camera_from_world * view);
    vec3 row = dFdy(place);
    float up = (((row - (dot(row, v_2) * v_2)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * inversesqrt(max(square_1, 1e-6)));
    float pixels = ((1.5 * height) / 1000.0);
    float distance_ = (abs(radial) / max(length(change), 1e-6));
    float x_7 = ((toward_eye * height) * 0.05);
    float _e79 = bounded(x_7);
    float _e82 = footprint_of(x_7);
    float strength = clamp((0.5 + ((_e79 - 22.0) / length(vec2(min(_e82, 1000000000000000.0), 22.0)))), 0.0, 1.0);
    return ((clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * strength) * smoothstep(0.05, 0.3, dot(normal_1, view)));
}

float faded_in(float x_6, float limit_1, float softness_1) {
    float _e3 = footprint_of(x_6);
    float width_2 = length(vec2(min(_e3, 1000000000000000.0), 45.0));
    float _e9 = bounded(x_6);
    float _e12 = bounded((_e9 - 45.0));
    return clamp((0.5 + (_e12 / width_2)), 0.0, 1.0);
}

float outer_contour(float width_1, vec3 normal_2, vec3 view_1, vec2 viewport_1) {
    float facing = clamp(dot(normal_2, view_1), 0.0, 1.0);
    float pixels_1 = ((5.0 * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    float _e16 = footprint_of_2_(facing);
    float distance_1 = (facing / max((2.0 * _e16), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels_1 + 0.5) - distance_1), 0.0, min(pixels_1, 1.0)) * near);
}

vec4 shade(Surface surface_1) {
    vec3 _e3 = normalize_or(surface_1.smooth_normal_4_, surface_1.normal);
    Light _e6 = u_look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    float _e9 = footprint_of_2_(_e7);
    vec4 _e10 = ramp_at(three_washes, _e7, _e9);
    vec3 _e12 = tensor_safe(surface_1.curvature_tensor);
    vec2 _e13 = principal_curvatures(_e12);
    float _e18 = faded_in(-(_e13.y), 45.0, 1.0);
    float hollows = (_e18 * smoothstep(0.05, 0.3, dot(surface_1.normal, surface_1.view)));
    vec4 hollows_in_sepia = mix(_e10, vec4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    mat3x3 _e40 = u_look.camera_from_world;
    vec2 _e44 = u_look.viewport;
    float _e45 = inner_contour_suggestive(3.0, 22.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e40, surface_1.position_camera, _e44);
    vec2 _e51 = u_look.viewport;
    float _e52 = outer_contour(5.0, surface_1.normal, surface_1.view, _e51);
    float all_lines = max(_e45, _e52);
    vec4 output_ = mix(hollows_in_sepia, vec4(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_3;
    vec4 _e11 = u_view.eye;
    float _e16 = u_view.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    mat4x4 _e24 = u_view.camera_from_world;
    surface.position_camera = (_e24 * vec4(in_.position, 1.0)).xyz;
    vec4 _e36 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    surface.curvature_tensor = _e36.xyz;
    vec4 _e44 = texelFetch(u_smooth_normal_4_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e50 = u_view.camera_from_world;
    surface.smooth_normal_4_ = (vec4(_e44.xyz, 0.0) * _e50).xyz;
    Surface _e53 = surface;
    vec4 _e54 = shade(_e53);
    out_color = _e54;
    return;
}

