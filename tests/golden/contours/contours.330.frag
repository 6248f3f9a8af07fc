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
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
const Ramp three_washes = Ramp(vec4[16](vec4(0.7255, 0.7686, 0.8118, 1.0), vec4(0.8627, 0.8627, 0.8235, 1.0), vec4(0.9725, 0.949, 0.8863, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.16, 0.42, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 3u, 2u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_tensor_map;

uniform sampler2D u_smooth_normal_4_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise) {
    bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

vec3 finite_vec3_(vec3 v) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return vec3(_e3, _e6, _e9);
}

vec4 finite_vec4_(vec4 v_1) {
    vec3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return vec4(_e2, _e5);
}

vec3 normalize_or(vec3 v_2, vec3 otherwise_1) {
    bool local = false;
    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local = (largest < 1e30);
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    vec3 scaled = (v_2 * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float bounded(float x_2) {
    uint bits = floatBitsToUint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec4 bounded_vec4_(vec4 v_3) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    float _e6 = bounded(v_3.z);
    float _e8 = bounded(v_3.w);
    return vec4(_e2, _e4, _e6, _e8);
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float mixed(float a_1, float b_1, float t) {
    float _e4 = bounded((b_1 - a_1));
    float _e14 = bounded(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

vec3 mixed_vec3_(vec3 a_2, vec3 b_2, float t_1) {
    float _e5 = mixed(a_2.x, b_2.x, t_1);
    float _e8 = mixed(a_2.y, b_2.y, t_1);
    float _e11 = mixed(a_2.z, b_2.z, t_1);
    return vec3(_e5, _e8, _e11);
}

vec4 mixed_vec4_(vec4 a_3, vec4 b_3, float t_2) {
    vec3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    float _e8 = mixed(a_3.w, b_3.w, t_2);
    return vec4(_e5, _e8);
}

float place_between(float x_3, float low, float high) {
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_3 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(span);
    float _e14 = bounded(((x_3 - low) / _e12));
    return _e14;
}

float eased(float x_4, float low_1, float high_1) {
    float _e3 = bounded(x_4);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_4 = clamp(_e6, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float factor_of(float x_5, bool clamped) {
    float _e2 = bounded(x_5);
    float _e3 = bounded(x_5);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_6) {
    float _e1 = dFdx(x_6);
    float _e2 = dFdy(x_6);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_7, float edge, float w_1) {
    float _e4 = bounded((x_7 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

vec4 hermite(vec4 a_4, vec4 b_4, vec4 from_a, vec4 to_b, float t_3) {
    vec4 d_1 = (b_4 - a_4);
    return (a_4 + (t_3 * (from_a + (t_3 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_1))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after) {
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

vec4 ramp_slope(vec4 rise_before, float span_before_1, vec4 rise_after, float span_after_1) {
    float _e5 = divided(rise_before.x, span_before_1);
    float _e7 = divided(rise_after.x, span_after_1);
    float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    float _e10 = divided(rise_before.y, span_before_1);
    float _e12 = divided(rise_after.y, span_after_1);
    float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    float _e15 = divided(rise_before.z, span_before_1);
    float _e17 = divided(rise_after.z, span_after_1);
    float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    float _e20 = divided(rise_before.w, span_before_1);
    float _e22 = divided(rise_after.w, span_after_1);
    float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return vec4(_e8, _e13, _e18, _e23);
}

vec4 ramp_at(Ramp ramp, float x_8, float w_2) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color = vec4(0.0);
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_1 = false;
    vec4 from_a_1 = vec4(0.0);
    vec4 to_b_1 = vec4(0.0);
    uint count = min(ramp.count, 16u);
    if ((count == 0u)) {
        return vec4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if ((ramp.interpolation == INTERPOLATION_STEPPED)) {
        vec4 _e18 = colors[0];
        color = _e18;
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                uint _e47 = i;
                i = (_e47 + 1u);
            }
            loop_init = false;
            uint _e22 = i;
            if ((_e22 < count)) {
            } else {
                break;
            }
            {
                vec4 _e24 = color;
                uint _e25 = i;
                vec4 _e27 = colors[_e25];
                uint _e28 = i;
                vec4 _e32 = colors[(_e28 - 1u)];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places[(_e34 / 4u)][(_e38 % 4u)];
                float _e43 = step_filtered(x_8, _e42, w_2);
                color = (_e24 + ((_e27 - _e32) * _e43));
            }
        }
        vec4 _e49 = color;
        vec4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = (_e71 + 1u);
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if ((_e55 < count)) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places[(_e59 / 4u)][(_e63 % 4u)];
            at = ((_e67 <= x_8) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places[(_e73 / 4u)][(_e77 % 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_1 = (x_8 <= place_1);
    } else {
        local_1 = true;
    }
    bool _e91 = local_1;
    if (_e91) {
        uint _e92 = at;
        vec4 _e94 = colors[_e92];
        vec4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span_1 = (_e105 - place_1);
    float _e108 = divided((x_8 - place_1), span_1);
    float t_5 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        vec4 _e117 = colors[_e115];
        vec4 _e119 = colors[after_1];
        vec4 _e120 = mixed_vec4_(_e117, _e119, t_5);
        return _e120;
    }
    uint _e127 = at;
    if ((_e127 > 0u)) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places[((_e130 - 1u) / 4u)][((_e136 - 1u) % 4u)];
        uint _e143 = at;
        vec4 _e145 = colors[_e143];
        uint _e146 = at;
        vec4 _e150 = colors[(_e146 - 1u)];
        vec4 _e154 = colors[after_1];
        uint _e155 = at;
        vec4 _e157 = colors[_e155];
        vec4 _e159 = ramp_slope((_e145 - _e150), (place_1 - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count)) {
        float _e173 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e173 - (place_1 + span_1));
        vec4 _e177 = colors[after_1];
        uint _e178 = at;
        vec4 _e180 = colors[_e178];
        vec4 _e185 = colors[(after_1 + 1u)];
        vec4 _e187 = colors[after_1];
        vec4 _e189 = ramp_slope((_e177 - _e180), span_1, (_e185 - _e187), next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    vec4 _e192 = colors[_e190];
    vec4 _e194 = colors[after_1];
    vec4 _e195 = from_a_1;
    vec4 _e197 = to_b_1;
    vec4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_5);
    vec4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

vec4 premultiplied(vec4 color_1) {
    return vec4((color_1.xyz * color_1.w), color_1.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 mix_colors_normal(vec4 a_5, vec4 b_5, float factor) {
    vec4 _e3 = bounded_vec4_(a_5);
    vec4 _e4 = bounded_vec4_(b_5);
    float _e6 = factor_of(factor, true);
    vec4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
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

vec4 output_(vec4 color_2) {
    vec4 _e1 = straight(color_2);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec4 ramp_plain(float value, Ramp ramp_1) {
    float _e2 = footprint_of(value);
    float _e3 = bounded(value);
    vec4 _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

float reflectance_half_lambert(Light light, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    float half_ = (0.5 + (0.5 * dot(_e6, light.direction)));
    return clamp((half_ * half_), 0.0, 1.0);
}

float maximum(float a_6, float b_6) {
    float _e2 = bounded(a_6);
    float _e3 = bounded(b_6);
    return max(_e2, _e3);
}

float line_covers(float distance_, float width) {
    return clamp(((width + 0.5) - distance_), 0.0, min(width, 1.0));
}

float seen_well(float facing) {
    float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(float x_9, float limit, float softness_1) {
    float _e3 = bounded(limit);
    float at_1 = max(_e3, 0.0);
    float _e6 = footprint_of(x_9);
    float _e10 = factor_of(softness_1, true);
    float _e12 = edge_width(_e6, (min(at_1, 1000000000.0) * _e10));
    float _e13 = bounded(x_9);
    float _e14 = step_filtered(_e13, at_1, _e12);
    return _e14;
}

float inner_contour_suggestive(float width_1, float limit_1, float softness_2, vec3 tensor_2, vec3 normal_1, vec3 view, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n = (camera_from_world * normal_1);
    vec3 _e10 = tensor_safe(tensor_2);
    float square_1 = dot(n.xy, n.xy);
    float radial = (((((_e10.x * n.x) * n.x) + (((2.0 * _e10.y) * n.x) * n.y)) + ((_e10.z * n.y) * n.y)) / max(square_1, 1e-6));
    float _e36 = dFdx(radial);
    float _e37 = dFdy(radial);
    vec2 change = vec2(_e36, _e37);
    vec3 v_4 = (camera_from_world * view);
    vec3 row = dFdy(place);
    float up = (((row - (dot(row, v_4) * v_4)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * inversesqrt(max(square_1, 1e-6)));
    float _e67 = bounded(width_1);
    float pixels = (((0.5 * clamp(_e67, 0.0, 10000.0)) * height) / 1000.0);
    float distance_1 = (abs(radial) / max(length(change), 1e-6));
    float _e84 = faded_in(((toward_eye * height) * 0.05), limit_1, softness_2);
    float _e85 = line_covers(distance_1, pixels);
    float _e88 = seen_well(dot(normal_1, view));
    return ((_e85 * _e84) * _e88);
}

float inner_contour_valleys(float limit_2, float softness_3, vec3 tensor_3, vec3 normal_2, vec3 view_1) {
    vec3 _e5 = tensor_safe(tensor_3);
    vec2 _e6 = principal_curvatures(_e5);
    float least = _e6.y;
    float _e9 = faded_in(-(least), limit_2, softness_3);
    float _e11 = seen_well(dot(normal_2, view_1));
    return (_e9 * _e11);
}

float outer_contour(float width_2, vec3 normal_3, vec3 view_2, vec2 viewport_1) {
    vec3 _e6 = normalize_or(normal_3, vec3(0.0));
    float facing_1 = clamp(dot(_e6, view_2), 0.0, 1.0);
    float _e11 = bounded(width_2);
    float pixels_1 = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    float _e22 = footprint_of(facing_1);
    float distance_2 = (facing_1 / max((2.0 * _e22), 1e-6));
    float _e30 = eased(facing_1, 0.45, 0.75);
    float near = (1.0 - _e30);
    float _e33 = line_covers(distance_2, pixels_1);
    return (_e33 * near);
}

vec3 smooth_normal_large(vec3 normal_4, vec3 smooth_4_) {
    vec3 _e2 = normalize_or(smooth_4_, normal_4);
    return _e2;
}

vec4 shade(Surface surface_1) {
    vec3 _e3 = smooth_normal_large(surface_1.normal, surface_1.smooth_normal_4_);
    Light _e6 = u_look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    vec4 _e9 = ramp_plain(_e7, three_washes);
    float _e15 = inner_contour_valleys(45.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view);
    vec4 _e21 = mix_colors_normal(_e9, vec4(0.6588, 0.5294, 0.4235, 1.0), _e15);
    mat3x3 _e30 = u_look.camera_from_world;
    vec2 _e34 = u_look.viewport;
    float _e35 = inner_contour_suggestive(3.0, 22.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e30, surface_1.position_camera, _e34);
    vec2 _e41 = u_look.viewport;
    float _e42 = outer_contour(5.0, surface_1.normal, surface_1.view, _e41);
    float _e43 = maximum(_e35, _e42);
    vec4 _e49 = mix_colors_normal(_e21, vec4(0.1647, 0.1412, 0.1882, 1.0), _e43);
    vec4 _e50 = premultiplied(_e49);
    vec4 _e51 = output_(_e50);
    return _e51;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_5 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_5;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    mat4x4 _e37 = u_view.camera_from_world;
    surface.position_camera = (_e37 * vec4(in_.position, 1.0)).xyz;
    vec4 _e49 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    surface.curvature_tensor = _e49.xyz;
    vec4 _e57 = texelFetch(u_smooth_normal_4_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e63 = u_view.camera_from_world;
    surface.smooth_normal_4_ = (vec4(_e57.xyz, 0.0) * _e63).xyz;
    Surface _e66 = surface;
    vec4 _e67 = shade(_e66);
    vec4 _e68 = finite_vec4_(_e67);
    out_color = _e68;
    return;
}

