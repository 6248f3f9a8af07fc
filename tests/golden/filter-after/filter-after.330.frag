#version 330 core
// A filter after the profile: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// filter-after.json says what to put there and how to draw.
struct Look {
    vec3 lamp_position;
    vec3 lamp_aim;
    mat3x3 lamp_own_from_world;
    vec3 lamp_color;
    float lamp_intensity;
    vec2 lamp_cone;
    vec2 lamp_fading;
};
struct Surface {
    vec3 normal;
    vec3 position;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct LitLayer {
    vec4 color;
    float tone;
};
struct FilteredLight {
    Light light;
    Angle angle;
};
struct PlaceInLight {
    vec2 uv;
    float inside;
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
struct Cell {
    float border;
    float random;
    float distance_;
};
struct Cells {
    float border;
    float random;
    float distance_;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float SMALLEST_NORMAL = 1.1754944e-38;
const float FAR_FROM_SHAPE = 1000.0;
const float CELL_REACH = 1.25;
const ProfileShape tone_shape = ProfileShape(0.87758255, 0.47942555, 20.008335, 2.4978132, 1.0, 0.04909103, 0.021148764, 0u);

layout(std140) uniform LookBlock { Look u_look; };

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

vec2 sin_cos_eighth(float x_1) {
    float y_2 = (x_1 * x_1);
    float s_2 = (x_1 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return vec2(s_2, c);
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y, float x_2) {
    float small = min(y, x_2);
    float large = max(y, x_2);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y > x_2) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, u_1.half_cos));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x_3) {
    uint bits = floatBitsToUint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec3 bounded_vec3_(vec3 v_3) {
    uvec3 bits_1 = floatBitsToUint(v_3);
    uvec3 magnitude_1 = (bits_1 & uvec3(2147483647u));
    vec3 largest_2 = uintBitsToFloat(((bits_1 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest_2, equal(magnitude_1, uvec3(2139095040u)));
    return mix(numbers, v_3, lessThan(magnitude_1, uvec3(2139095040u)));
}

float place_between(float x_4, float low, float high) {
    float span = (high - low);
    if ((span < SMALLEST_NORMAL)) {
        return ((x_4 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(((x_4 - low) / span));
    return _e12;
}

float eased(float x_5, float low_1, float high_1) {
    float _e3 = bounded(x_5);
    float _e4 = place_between(_e3, low_1, high_1);
    float t_2 = clamp(_e4, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float angle_of_point(float y_1, float x_6) {
    vec2 p_1 = abs(vec2(x_6, y_1));
    vec2 scaled_1 = ((max(p_1.x, p_1.y) > 1.0) ? (0.5 * p_1) : p_1);
    float _e14 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_1 = ((x_6 < 0.0) ? (PI - _e14) : _e14);
    return ((y_1 < 0.0) ? -(turned_1) : turned_1);
}

float footprint_of(float x_7) {
    float _e1 = dFdx(x_7);
    float _e2 = dFdy(x_7);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

vec2 footprint_of_vec2_(vec2 v_4) {
    vec2 dx_1 = dFdx(v_4);
    vec2 dy_1 = dFdy(v_4);
    return sqrt(((dx_1 * dx_1) + (dy_1 * dy_1)));
}

float footprint_of_vec3_(vec3 v_5) {
    vec3 dx_2 = dFdx(v_5);
    vec3 dy_2 = dFdy(v_5);
    return sqrt(max(dot(dx_2, dx_2), dot(dy_2, dy_2)));
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 leaning = cross(up, toward);
    float square_2 = dot(leaning, leaning);
    vec3 aside = ((abs(toward.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    vec3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e28, cross(toward, _e28), toward);
}

vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + ((below.xyz + (tone * color.xyz)) - below.xyz)), 1.0), vec4(0.0), vec4(1.0));
}

mat3x3 axes_turned(vec3 toward_1, float spin) {
    mat3x3 _e6 = axes_around(toward_1, vec3(0.0, 1.0, 0.0));
    vec2 turn = vec2(0.0, 1.0);
    return mat3x3(((turn.y * _e6[0]) + (turn.x * _e6[1])), ((turn.y * _e6[1]) - (turn.x * _e6[0])), _e6[2]);
}

mat3x3 axes_turned_2_(vec3 toward_2, float spin_1) {
    mat3x3 _e6 = axes_around(toward_2, vec3(0.0, 1.0, 0.0));
    vec2 _e13 = sin_cos_eighth((((spin_1 - 0.0) - 0.0) - 0.0));
    vec2 turn_1 = clamp(_e13, vec2(-1.0), vec2(1.0));
    return mat3x3(((turn_1.y * _e6[0]) + (turn_1.x * _e6[1])), ((turn_1.y * _e6[1]) - (turn_1.x * _e6[0])), _e6[2]);
}

vec3 place_along(vec3 place, vec3 center, mat3x3 axes) {
    vec3 away = clamp((place - center), vec3(-1000000.0), vec3(1000000.0));
    return vec3(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

float share_beside(float m, float softness, float density, bool inverted) {
    float near = min(m, FAR_FROM_SHAPE);
    float _e6 = footprint_of(near);
    float half_1 = (0.5 * min(_e6, 0.25));
    float _e15 = eased(near, (1.0 - half_1), (1.0 + half_1));
    return (1.0 - _e15);
}

float share_of_doors(vec3 seen, vec4 flaps, float softness_1) {
    float _e5 = angle_of_point(seen.x, seen.z);
    float _e8 = angle_of_point(seen.y, seen.z);
    vec2 angles = vec2(_e5, _e8);
    vec2 _e10 = footprint_of_vec2_(angles);
    vec2 half_2 = (0.5 * min(_e10, vec2(0.1)));
    float aside_1 = ((1.0 - smoothstep((flaps.x - half_2.x), (flaps.x + max(softness_1, half_2.x)), angles.x)) * (1.0 - smoothstep((flaps.y - half_2.x), (flaps.y + max(softness_1, half_2.x)), -(angles.x))));
    return ((aside_1 * (1.0 - smoothstep((flaps.z - half_2.y), (flaps.z + max(softness_1, half_2.y)), angles.y))) * (1.0 - smoothstep((flaps.w - half_2.y), (flaps.w + max(softness_1, half_2.y)), -(angles.y))));
}

float light_fading(float distance_, vec2 fading) {
    float left = 1.0;
    if ((fading.x > 0.0)) {
        float d_1 = min((distance_ / fading.x), 1000000000000000.0);
        left = (1.0 / (1.0 + (d_1 * d_1)));
    }
    if ((fading.y > 0.0)) {
        float d_2 = min((distance_ / fading.y), 1.0);
        float window = max((1.0 - (((d_2 * d_2) * d_2) * d_2)), 0.0);
        float _e30 = left;
        left = (_e30 * (window * window));
    }
    float _e33 = left;
    return _e33;
}

Light light_at(vec3 light_position, mat3x3 own_from_world, vec3 color_1, float intensity, vec2 fading_1, vec3 position) {
    vec3 offset = (light_position - position);
    vec3 _e11 = normalize_or(offset, vec3(0.0, 0.0, 1.0));
    float _e13 = light_fading(length(offset), fading_1);
    float faded = (intensity * _e13);
    return Light(_e11, (own_from_world * _e11), color_1, faded);
}

float light_cone(float cos_angle, vec2 cone) {
    if ((cone.x <= cone.y)) {
        return ((cos_angle >= cone.y) ? 1.0 : 0.0);
    }
    float t_3 = clamp(((cos_angle - cone.y) / (cone.x - cone.y)), 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

Light light_spot(vec3 light_position_1, vec3 aim, mat3x3 own_from_world_1, vec3 color_2, float intensity_1, vec2 cone_1, vec2 fading_2, vec3 position_1) {
    Light light = Light(vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    Light _e8 = light_at(light_position_1, own_from_world_1, color_2, intensity_1, fading_2, position_1);
    light = _e8;
    float _e11 = light.intensity;
    vec3 _e13 = light.direction;
    float _e16 = light_cone(dot(-(_e13), aim), cone_1);
    light.intensity = (_e11 * _e16);
    Light _e18 = light;
    return _e18;
}

LitLayer light_apply(Light light_1, vec4 color_3, float tone_1) {
    vec2 split = vec2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    return LitLayer(vec4(((color_3.xyz * light_1.color) * split.y), 1.0), (tone_1 * split.x));
}

PlaceInLight place_in_light(vec2 at) {
    vec2 near_1 = clamp(at, vec2(-1000.0), vec2(1000.0));
    float _e14 = share_beside(max(abs(near_1.x), abs(near_1.y)), 0.0, 1.0, true);
    return PlaceInLight((vec2(0.5) + (0.5 * vec2(-(near_1.x), near_1.y))), _e14);
}

PlaceInLight light_place_point(vec3 light_position_2, float angle, float spin_2, vec3 toward_3, vec3 position_2) {
    mat3x3 _e5 = axes_turned_2_(toward_3, spin_2);
    vec3 _e6 = place_along(position_2, light_position_2, _e5);
    vec2 _e13 = sin_cos_eighth((((angle - 0.0) - 0.0) - 0.0));
    vec2 turn_2 = clamp(_e13, vec2(-1.0), vec2(1.0));
    vec2 at_1 = ((_e6.xy * (turn_2.y / turn_2.x)) / vec2(max(_e6.z, 0.001)));
    PlaceInLight _e35 = place_in_light(((_e6.z > 0.001) ? at_1 : vec2(1000.0)));
    return _e35;
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1) {
    float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_2) {
    vec2 place_1 = vec2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place_1.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_1);
    vec2 turn_3 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e56 = profile_soft_quick(((place_1.x * turn_3.y) - (place_1.y * turn_3.x)), shape_2);
    float _e64 = profile_soft_quick(((place_1.x * turn_3.y) + (place_1.y * turn_3.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle_1, float shift, ProfileShape shape_3) {
    Angle _e6 = angle_turned(angle_1, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_6 = uvec3(0u);
    v_6 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_6;
    uvec3 _e32 = v_6;
    v_6 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_6;
    return _e61;
}

vec3 unit_of_hash(uvec3 hash) {
    return (vec3((hash >> uvec3(8u))) * 5.9604645e-8);
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

Cell nearest_cell(vec3 p, uint seed_2) {
    vec3 nearest = vec3(4.0);
    uvec3 hash_1 = uvec3(0u);
    int i = 0;
    float border = 0.0;
    int i_1 = 0;
    vec3 corner = floor(p);
    vec3 d_3 = (p - corner);
    ivec3 cell_1 = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e51 = i;
            i = (_e51 + 1);
        }
        loop_init = false;
        int _e13 = i;
        if ((_e13 < 27)) {
        } else {
            break;
        }
        {
            int _e16 = i;
            int _e21 = i;
            int _e28 = i;
            ivec3 at_2 = ivec3(((_e16 % 3) - 1), (((_e21 / 3) % 3) - 1), ((_e28 / 9) - 1));
            uvec3 _e35 = lattice_hash((cell_1 + at_2), seed_2);
            vec3 _e40 = unit_of_hash(_e35);
            vec3 offset_1 = (((vec3(at_2) + vec3(0.25)) + (0.5 * _e40)) - d_3);
            vec3 _e46 = nearest;
            vec3 _e47 = nearest;
            if ((dot(offset_1, offset_1) < dot(_e46, _e47))) {
                nearest = offset_1;
                hash_1 = _e35;
            }
        }
    }
    vec3 _e53 = nearest;
    float distance_1 = length(_e53);
    border = max((0.5 * (CELL_REACH - distance_1)), 0.0);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e110 = i_1;
            i_1 = (_e110 + 1);
        }
        loop_init_1 = false;
        int _e64 = i_1;
        if ((_e64 < 27)) {
        } else {
            break;
        }
        {
            int _e67 = i_1;
            int _e72 = i_1;
            int _e79 = i_1;
            ivec3 at_3 = ivec3(((_e67 % 3) - 1), (((_e72 / 3) % 3) - 1), ((_e79 / 9) - 1));
            uvec3 _e90 = lattice_hash((cell_1 + at_3), seed_2);
            vec3 _e91 = unit_of_hash(_e90);
            vec3 _e96 = nearest;
            vec3 apart = ((((vec3(at_3) + vec3(0.25)) + (0.5 * _e91)) - d_3) - _e96);
            float between = length(apart);
            if ((between > 0.25)) {
                float _e101 = border;
                vec3 _e102 = nearest;
                border = min(_e101, (dot((_e102 + (0.5 * apart)), apart) / between));
            }
        }
    }
    float _e112 = border;
    uvec3 _e115 = hash_1;
    uvec3 _e116 = hash_pcg3d(_e115);
    vec3 _e117 = unit_of_hash(_e116);
    return Cell(max(_e112, 0.0), _e117.x, distance_1);
}

Cells cells(vec3 position_3, float scale, int seed_3) {
    vec3 _e4 = bounded_vec3_((position_3 * scale));
    Cell _e6 = nearest_cell(_e4, 0u);
    float _e7 = footprint_of_vec3_(_e4);
    float visible = (1.0 - smoothstep(0.5, 1.0, _e7));
    vec3 average = vec3(0.1301, 0.5, 0.491);
    vec3 seen_1 = mix(average, vec3(_e6.border, _e6.random, _e6.distance_), visible);
    return Cells(seen_1.x, seen_1.y, seen_1.z);
}

vec4 shade(Surface surface) {
    vec3 _e3 = u_look.lamp_position;
    vec3 _e6 = u_look.lamp_aim;
    mat3x3 _e9 = u_look.lamp_own_from_world;
    vec3 _e12 = u_look.lamp_color;
    float _e15 = u_look.lamp_intensity;
    vec2 _e18 = u_look.lamp_cone;
    vec2 _e21 = u_look.lamp_fading;
    Light _e23 = light_spot(_e3, _e6, _e9, _e12, _e15, _e18, _e21, surface.position);
    Angle angle_2 = Angle((0.5 * length((surface.normal - _e23.direction))), (0.5 * length((surface.normal + _e23.direction))));
    vec3 _e40 = u_look.lamp_position;
    vec3 _e43 = u_look.lamp_aim;
    mat3x3 _e45 = axes_turned(_e43, 0.0);
    vec3 _e46 = place_along(surface.position, _e40, _e45);
    float _e53 = share_of_doors(_e46, vec4(0.3, 0.36, 0.3, 0.2), 0.02);
    vec3 _e56 = u_look.lamp_position;
    vec3 _e61 = u_look.lamp_aim;
    PlaceInLight _e63 = light_place_point(_e56, 0.4, 0.6, _e61, surface.position);
    Cells _e69 = cells(vec3(_e63.uv, 0.0), 13.0, 0);
    float both = (_e53 * smoothstep(0.12, 0.62, _e69.distance_));
    FilteredLight filter_2_ = FilteredLight(Light(_e23.direction, _e23.own_direction, _e23.color, (_e23.intensity * both)), angle_2);
    float _e85 = profile_balanced(filter_2_.angle, 0.0, tone_shape);
    LitLayer _e92 = light_apply(filter_2_.light, vec4(0.93, 0.62, 0.36, 1.0), _e85);
    vec4 _e102 = blend_add(vec4(0.13, 0.14, 0.27, 1.0), _e92.color, _e92.tone, 1.0, true);
    return _e102;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal, in_.position);
    vec4 _e8 = shade(surface_1);
    out_color = _e8;
    return;
}

