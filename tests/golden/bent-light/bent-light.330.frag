#version 330 core
// Light that wavers: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// bent-light.json says what to put there and how to draw.
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
    Light eye;
    Light key;
    vec3 parts_direction;
    vec3 axes_of_the_light_x_axis;
    vec3 axes_of_the_light_y_axis;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct DirectionParts {
    vec3 direction;
    vec3 x_axis;
    vec3 y_axis;
    vec2 place;
};
struct AxesAround {
    vec3 x_axis;
    vec3 y_axis;
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
    vec3 position_object;
    vec3 normal;
};
const uint NOISE_PERLIN = 1u;
const ProfileShape lit_shape = ProfileShape(0.8253356, 0.5646425, 25.006668, 1.7790966, 1.2, 0.04446849, 0.018017149, 0u);
const ProfileShape brightest_shape = ProfileShape(0.9358968, 0.35227424, 40.004166, 3.6241908, 0.72, 0.021168118, 0.009611014, 0u);
const ProfileShape window_shape = ProfileShape(0.9963897, 0.08489768, 0.0, 1.0, 0.17, 0.0, 0.0, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, u_1.half_cos));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float eased(float x_1, float low, float high) {
    float _e3 = bounded(x_1);
    float _e7 = bounded(((_e3 - low) / 0.5));
    float t_2 = clamp(_e7, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d_1 = vec2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float footprint_of_vec3_(vec3 v_2) {
    vec3 dx_1 = dFdx(v_2);
    vec3 dy_1 = dFdy(v_2);
    float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 y = (y_axis * inversesqrt(max(dot(y_axis, y_axis), 1e-30)));
    return DirectionParts(direction, x_axis, y, vec2(dot(direction, x_axis), dot(direction, y)));
}

vec3 direction_moved(DirectionParts parts, vec2 by) {
    vec3 moved = ((parts.direction + (by.x * parts.x_axis)) + (by.y * parts.y_axis));
    vec3 _e13 = normalize_moderate(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e13 : parts.direction);
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 leaning = cross(up, toward);
    float square_1 = dot(leaning, leaning);
    vec3 aside = ((abs(toward.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across = ((square_1 > 1e-8) ? leaning : cross(aside, toward));
    vec3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e28, cross(toward, _e28), toward);
}

AxesAround axes(vec3 direction_1, vec3 up_1) {
    mat3x3 _e2 = axes_around(direction_1, up_1);
    return AxesAround(_e2[0], _e2[1]);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1) {
    float width_1 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width_1)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_2, float w_1, ProfileShape shape_2) {
    float width_2 = sqrt((w_1 * w_1));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_2, 1e-6))), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_2, float w_2, ProfileShape shape_3) {
    vec2 place = vec2(((u_2.half_sin * shape_3.half_cos_offset) - (u_2.half_cos * shape_3.half_sin_offset)), ((u_2.half_cos * shape_3.half_cos_offset) + (u_2.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_2);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    Angle _e6 = angle_turned(angle_1, vec2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_3 = uvec3(0u);
    v_3 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_3.x;
    uint _e10 = v_3.y;
    uint _e12 = v_3.z;
    v_3.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_3.y;
    uint _e18 = v_3.z;
    uint _e20 = v_3.x;
    v_3.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_3.z;
    uint _e26 = v_3.x;
    uint _e28 = v_3.y;
    v_3.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_3;
    uvec3 _e32 = v_3;
    v_3 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_3.x;
    uint _e40 = v_3.y;
    uint _e42 = v_3.z;
    v_3.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_3.y;
    uint _e48 = v_3.z;
    uint _e50 = v_3.x;
    v_3.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_3.z;
    uint _e56 = v_3.x;
    uint _e58 = v_3.y;
    v_3.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_3;
    return _e61;
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
}

vec3 fade_quintic(vec3 t_1) {
    return (((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 d_2 = (p - corner);
    vec3 _e4 = fade_quintic(d_2);
    ivec3 cell_1 = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e46 = i;
            i = (_e46 + 1);
        }
        loop_init = false;
        int _e10 = i;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            ivec3 at = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at), seed_2);
            float _e42 = gradient_dot(_e39, (d_2 - vec3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, vec3 p_1, int octaves, float roughness, int seed_3, float w_3) {
    float octave = 0.0;
    int i_1 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e66 = i_1;
            i_1 = (_e66 + 1);
        }
        loop_init_1 = false;
        int _e17 = i_1;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased((w_3 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            vec3 place_1 = clamp(((p_1 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place_1, (1u + uint(_e47)));
            octave = mix(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * roughness);
        float _e63 = frequency;
        frequency = (_e63 * 2.0);
    }
    float _e69 = sum_1;
    return min((_e69 / 1.5), 1.0);
}

float fractal_noise_2_(uint kind_1, vec3 p_2, int octaves_1, float roughness_1, int seed_4, float w_4) {
    float octave_1 = 0.0;
    int i_2 = 0;
    float frequency_1 = 1.0;
    float strength_1 = 1.0;
    float total_1 = 0.0;
    float sum_2 = 0.0;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e66 = i_2;
            i_2 = (_e66 + 1);
        }
        loop_init_2 = false;
        int _e17 = i_2;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency_1;
        float _e25 = eased((w_4 * _e21), 0.5, 1.0);
        float visible_1 = (1.0 - _e25);
        octave_1 = 0.5;
        if ((visible_1 > 0.0)) {
            float _e31 = frequency_1;
            int _e33 = i_2;
            vec3 place_2 = clamp(((p_2 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_2;
            float _e50 = perlin_noise(place_2, (5u + uint(_e47)));
            octave_1 = mix(0.5, _e50, visible_1);
        }
        float _e53 = sum_2;
        float _e54 = strength_1;
        float _e55 = octave_1;
        sum_2 = (_e53 + (_e54 * _e55));
        float _e58 = total_1;
        float _e59 = strength_1;
        total_1 = (_e58 + _e59);
        float _e61 = strength_1;
        strength_1 = (_e61 * roughness_1);
        float _e63 = frequency_1;
        frequency_1 = (_e63 * 2.0);
    }
    float _e69 = sum_2;
    return min((_e69 / 1.5), 1.0);
}

float outer_contour(float width, vec3 normal, vec3 view, vec2 viewport) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport.y, 1.0, 100000.0)) / 1000.0);
    float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

float noise_perlin(vec3 position, float scale, int octaves_2, float roughness_2, int seed_5) {
    vec3 p_3 = (position * scale);
    float _e7 = footprint_of_vec3_(p_3);
    float _e8 = fractal_noise(NOISE_PERLIN, p_3, octaves_2, roughness_2, seed_5, _e7);
    return _e8;
}

float noise_perlin_2_(vec3 position_1, float scale_1, int octaves_3, float roughness_3, int seed_6) {
    vec3 p_4 = (position_1 * scale_1);
    float _e7 = footprint_of_vec3_(p_4);
    float _e8 = fractal_noise_2_(NOISE_PERLIN, p_4, octaves_3, roughness_3, seed_6, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 place_3 = surface.position_object;
    float _e6 = noise_perlin(place_3, 3.5, 2, 0.5, 1);
    float across_1 = mix(-0.22, 0.22, (_e6 - 0.0));
    float _e16 = noise_perlin_2_(place_3, 3.5, 2, 0.5, 5);
    float upright = mix(-0.22, 0.22, (_e16 - 0.0));
    vec3 _e24 = u_look.parts_direction;
    vec3 _e27 = u_look.axes_of_the_light_x_axis;
    vec3 _e30 = u_look.axes_of_the_light_y_axis;
    DirectionParts _e31 = direction_within(_e24, _e27, _e30);
    vec3 _e33 = direction_moved(_e31, vec2(across_1, upright));
    vec3 _e37 = u_look.key.own_direction;
    vec3 _e41 = u_look.key.color;
    float _e45 = u_look.key.intensity;
    Light bent_light = Light(_e33, _e37, _e41, _e45);
    Angle turned_from_it = Angle((0.5 * length((surface.normal - bent_light.direction))), (0.5 * length((surface.normal + bent_light.direction))));
    float _e62 = profile_balanced(turned_from_it, 0.0, lit_shape);
    vec4 _e75 = blend_alpha(vec4(0.1529, 0.251, 0.3765, 1.0), vec4(0.3098, 0.5608, 0.6118, 1.0), _e62, 1.0, true);
    float _e78 = profile_balanced(turned_from_it, 0.0, brightest_shape);
    vec4 brightest_light = min(vec4((_e75.xyz + (_e78 * (vec3(0.6627, 0.8392, 0.7569) - _e75.xyz))), 1.0), vec4(1.0));
    vec3 view_2_ = surface.view;
    AxesAround _e98 = axes(view_2_, vec3(0.0, 1.0, 0.0));
    DirectionParts _e101 = direction_within(view_2_, _e98.x_axis, _e98.y_axis);
    vec3 _e105 = direction_moved(_e101, vec2(-0.32, 0.36));
    vec3 _e109 = u_look.eye.own_direction;
    vec3 _e113 = u_look.eye.color;
    float _e117 = u_look.eye.intensity;
    Light locked_to_the_eye = Light(_e105, _e109, _e113, _e117);
    Angle turned_from_the_eye = Angle((0.5 * length((surface.normal - locked_to_the_eye.direction))), (0.5 * length((surface.normal + locked_to_the_eye.direction))));
    float _e134 = profile_balanced_2_(turned_from_the_eye, 0.0, window_shape);
    vec4 window_on_top = clamp(vec4((brightest_light.xyz + (_e134 * (vec3(0.9922, 0.9647, 0.8902) - brightest_light.xyz))), 1.0), vec4(0.0), vec4(1.0));
    vec2 _e156 = u_look.viewport;
    float _e157 = outer_contour(3.0, surface.normal, surface.view, _e156);
    vec4 outline = clamp(vec4((window_on_top.xyz + (_e157 * (vec3(0.0784, 0.1294, 0.2275) - window_on_top.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return outline;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object);
    vec4 _e20 = shade(surface_1);
    out_color = _e20;
    return;
}

