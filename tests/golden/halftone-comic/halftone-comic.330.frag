#version 330 core
// Half-tone comic: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// halftone-comic.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light key;
    vec2 viewport;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec2 pixel;
};
struct Angle {
    float half_sin;
    float half_cos;
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
const ProfileShape not_in_deep_shade_shape = ProfileShape(0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0, 0.0, 1u);
const ProfileShape highlight_shape = ProfileShape(0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec2 sin_cos_quarter(float x) {
    float h = (0.5 * x);
    float h2_ = (h * h);
    float s_1 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s_1) * c), (1.0 - ((2.0 * s_1) * s_1)));
}

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_1.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float eased(float x_1, float low, float high) {
    float t_1 = clamp(((x_1 - low) / (high - low)), 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

vec2 footprint_of_vec2_(vec2 v_1) {
    vec2 dx_1 = dFdx(v_1);
    vec2 dy_1 = dFdy(v_1);
    return sqrt(((dx_1 * dx_1) + (dy_1 * dy_1)));
}

Angle parametrization_specular_balanced(Light light, vec3 normal, vec3 view) {
    vec3 d_2 = (((2.0 * dot(normal, view)) * normal) - view);
    return Angle((0.5 * length((d_2 - light.direction))), (0.5 * length((d_2 + light.direction))));
}

float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt((w * w));
    float from_offset = (s * (2.0 + ((s * s) * 0.33333334)));
    float ramp = clamp((0.5 + ((0.0 - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_1) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick(((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset)), _e14, shape_1);
    return _e15;
}

vec2 turned_by(vec2 p, float angle_1) {
    vec2 turn = vec2(sin(angle_1), cos(angle_1));
    return vec2(((turn.y * p.x) - (turn.x * p.y)), ((turn.x * p.x) + (turn.y * p.y)));
}

vec2 screen_cells(vec2 place, vec2 viewport, float lines, float angle_2) {
    vec2 most = vec2(4194304.0);
    vec2 upright = (place * (lines / max(viewport.y, 1.0)));
    vec2 _e14 = turned_by(clamp(upright, vec2(-4194304.0), most), angle_2);
    return clamp(_e14, vec2(-4194304.0), most);
}

float dot_radius(float share) {
    float a = 0.0;
    int i = 0;
    if ((share <= 0.7853982)) {
        return sqrt((share * 0.31830987));
    }
    float s_3 = ((share - 0.7853982) / 0.21460183);
    a = mix((0.5227232 * sqrt(s_3)), (0.7853982 - (0.3275682 * sqrt((1.0 - s_3)))), s_3);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e61 = i;
            i = (_e61 + 1);
        }
        loop_init = false;
        int _e24 = i;
        if (!((_e24 < 2))) {
            break;
        }
        float _e28 = a;
        vec2 _e32 = sin_cos_quarter(clamp(_e28, 0.0, 0.7853982));
        float tangent = (_e32.x / _e32.y);
        float square = (1.0 / (_e32.y * _e32.y));
        float _e41 = a;
        float sector = (0.7853982 - _e41);
        float slope = (((2.0 * sector) * square) * tangent);
        float _e48 = a;
        a = clamp((_e48 - ((slope > 0.001) ? ((((sector * square) + tangent) - share) / slope) : 0.0)), 0.0, 0.7853982);
    }
    float _e64 = a;
    vec2 _e65 = sin_cos_quarter(_e64);
    return (0.5 / _e65.y);
}

float disk_filtered(float d, float r, float w_1) {
    if ((w_1 < 1e-30)) {
        return (((d <= r) && (r > 0.0)) ? 1.0 : 0.0);
    }
    float square_1 = (r * r);
    float least = ((w_1 * w_1) / 3.0);
    float inner = sqrt((max(square_1, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d) / w_1)), 0.0, 1.0) * min((square_1 / least), 1.0));
}

float disk_filtered_2_(float d_1, float r_1, float w_2) {
    if ((w_2 < 1e-30)) {
        return (((d_1 <= r_1) && true) ? 1.0 : 0.0);
    }
    float square_2 = (r_1 * r_1);
    float least_1 = ((w_2 * w_2) / 3.0);
    float inner_1 = sqrt((max(square_2, least_1) - (0.25 * least_1)));
    return (clamp((0.5 + ((inner_1 - d_1) / w_2)), 0.0, 1.0) * min((square_2 / least_1), 1.0));
}

float ink_of_dots(vec2 cell, float share_1, float w_3) {
    float ink = 0.0;
    float width_1 = min(w_3, 1.0);
    float _e8 = dot_radius(share_1);
    float _e9 = disk_filtered(length((cell - roundEven(cell))), _e8, width_1);
    ink = _e9;
    float hole = sqrt(((1.0 - share_1) * 0.31830987));
    float is_star = (smoothstep((0.3 * hole), (0.9 * hole), width_1) * smoothstep(0.5, 0.7, share_1));
    if ((is_star > 0.0)) {
        float _e27 = ink;
        float _e34 = disk_filtered_2_(length(((cell - floor(cell)) - vec2(0.5))), hole, width_1);
        ink = mix(_e27, (1.0 - _e34), is_star);
    }
    float _e38 = ink;
    float mean = mix(_e38, share_1, smoothstep(0.4, 1.0, w_3));
    return (((share_1 <= 0.0) || false) ? share_1 : mean);
}

float ink_of_dots_2_(vec2 cell_1, float share_2, float w_4) {
    float ink_1 = 0.0;
    float width_2 = min(w_4, 1.0);
    float _e11 = disk_filtered(length((cell_1 - roundEven(cell_1))), sqrt((share_2 * 0.31830987)), width_2);
    ink_1 = _e11;
    float hole_1 = sqrt(((1.0 - share_2) * 0.31830987));
    float is_star_1 = (smoothstep((0.3 * hole_1), (0.9 * hole_1), width_2) * smoothstep(0.5, 0.7, share_2));
    if ((is_star_1 > 0.0)) {
        float _e29 = ink_1;
        float _e36 = disk_filtered_2_(length(((cell_1 - floor(cell_1)) - vec2(0.5))), hole_1, width_2);
        ink_1 = mix(_e29, (1.0 - _e36), is_star_1);
    }
    float _e40 = ink_1;
    float mean_1 = mix(_e40, share_2, smoothstep(0.4, 1.0, w_4));
    return (((share_2 <= 0.0) || false) ? share_2 : mean_1);
}

float halftone_dots(float value, vec2 place_1, float lines_1, float angle_3, vec2 viewport_1) {
    vec2 _e5 = screen_cells(place_1, viewport_1, lines_1, angle_3);
    vec2 _e6 = footprint_of_vec2_(_e5);
    float _e14 = ink_of_dots(_e5, (1.0 - min(value, 1.0)), max(_e6.x, _e6.y));
    return (1.0 - _e14);
}

float halftone_dots_2_(float value_1, vec2 place_2, float lines_2, float angle_4, vec2 viewport_2) {
    vec2 _e5 = screen_cells(place_2, viewport_2, lines_2, angle_4);
    vec2 _e6 = footprint_of_vec2_(_e5);
    float _e12 = ink_of_dots_2_(_e5, (1.0 - value_1), max(_e6.x, _e6.y));
    return (1.0 - _e12);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float light_and_shade = max(((dot(surface.normal, _e5) + 0.25) / 1.25), 0.0);
    float red_to_print = mix(0.15, 1.0, clamp(((light_and_shade - 0.1) / 0.65), 0.0, 1.0));
    vec2 _e28 = u_look.viewport;
    float _e29 = halftone_dots(red_to_print, surface.pixel, 78.0, 0.2617994, _e28);
    vec4 red_on_yellow = mix(vec4(0.91, 0.3, 0.24, 1.0), vec4(1.0, 0.87, 0.58, 1.0), _e29);
    vec3 _e45 = u_look.key.direction;
    vec3 _e54 = u_look.key.direction;
    Angle turned_from_the_light = Angle((0.5 * length((surface.normal - _e45))), (0.5 * length((surface.normal + _e54))));
    float _e62 = profile_balanced(turned_from_the_light, 0.0, not_in_deep_shade_shape);
    float deep_shade = (1.0 - _e62);
    float how_much_blue = (deep_shade * 0.62);
    float less = (1.0 - how_much_blue);
    vec2 _e74 = u_look.viewport;
    float _e75 = halftone_dots_2_(less, surface.pixel, 78.0, 1.3089969, _e74);
    float inked = (1.0 - _e75);
    vec4 blue_over_it = vec4(mix(red_on_yellow.xyz, (red_on_yellow.xyz * vec3(0.24, 0.3, 0.58)), inked), 1.0);
    Light _e90 = u_look.key;
    Angle _e93 = parametrization_specular_balanced(_e90, surface.normal, surface.view);
    float _e96 = profile_balanced(_e93, 0.0, highlight_shape);
    vec4 left_free = mix(blue_over_it, vec4(1.0, 0.99, 0.95, 1.0), _e96);
    float _e111 = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.22);
    vec4 black_line = mix(left_free, vec4(0.09, 0.07, 0.13, 1.0), _e111);
    return black_line;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e22 = u_view.screen;
    vec4 _e27 = u_view.screen;
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))), ((in_.clip.xy * _e22.xy) + _e27.zw));
    vec4 _e31 = shade(surface_1);
    out_color = _e31;
    return;
}

