#version 330 core
// Stained glass: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// stained-glass.json says what to put there and how to draw.
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
    Light room;
    Light sun;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position;
    vec3 position_object;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct LitLayer {
    vec4 color;
    float tone;
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
    vec3 position_object;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
const float CELL_REACH = 1.25;
const Ramp colors_1 = Ramp(vec4[16](vec4(0.0706, 0.1882, 0.4784, 1.0), vec4(0.1216, 0.4784, 0.6902, 1.0), vec4(0.1137, 0.5412, 0.3529, 1.0), vec4(0.9098, 0.6902, 0.1255, 1.0), vec4(0.8471, 0.3255, 0.1098, 1.0), vec4(0.6902, 0.0706, 0.2196, 1.0), vec4(0.3529, 0.102, 0.4784, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.22, 0.4, 0.58), vec4(0.75, 0.9, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 2u);
const ProfileShape through_the_glass_shape = ProfileShape(0.9950042, 0.099833414, 1.1883951, 1.4967098, 0.2, 1.0679889, 0.45520553, 0u);
const ProfileShape on_the_glass_shape = ProfileShape(0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1, 1.0089166, 0.41697913, 0u);
const ProfileShape gleam_tone_shape = ProfileShape(0.99820054, 0.059964005, 11.126125, 3.022525, 0.12, 0.08196669, 0.036355104, 0u);
const ProfileShape edge_of_the_lead_tone_shape = ProfileShape(0.9887711, 0.14943813, 3.3838634, 2.4220939, 0.3, 0.29531473, 0.1274162, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_position_object;
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

vec3 normalize_moderate(vec3 v_1, vec3 otherwise_1) {
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * inversesqrt(max(square_1, 1e-30))) : otherwise_1);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_6 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_6, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, u_1.half_cos));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_2, float low, float high) {
    float _e3 = bounded(x_2);
    float _e7 = bounded(((_e3 - low) / 0.5));
    float t_2 = clamp(_e7, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float length_of(vec3 v_3) {
    float largest_2 = max(max(abs(v_3.x), abs(v_3.y)), abs(v_3.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e16 = bounded((largest_2 * length((v_3 / vec3(largest_2)))));
    return _e16;
}

float footprint_of(float x_3) {
    float _e1 = dFdx(x_3);
    float _e2 = dFdy(x_3);
    vec2 d_1 = vec2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float footprint_of_vec3_(vec3 v_4) {
    vec3 dx_1 = dFdx(v_4);
    vec3 dy_1 = dFdy(v_4);
    float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

float footprint_of_vec3_2_(vec3 v_5) {
    vec3 dx_2 = dFdx(v_5);
    vec3 dy_2 = dFdy(v_5);
    return sqrt(max(dot(dx_2, dx_2), dot(dy_2, dy_2)));
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
            uint _e38 = i;
            i = (_e38 + 1u);
        }
        loop_init = false;
        uint _e12 = i;
        if (!((_e12 < 7u))) {
            break;
        }
        vec4 _e16 = color;
        uint _e17 = i;
        vec4 _e19 = colors[_e17];
        uint _e20 = i;
        vec4 _e24 = colors[(_e20 - 1u)];
        uint _e26 = i;
        uint _e30 = i;
        float _e34 = places[(_e26 / 4u)][(_e30 % 4u)];
        float _e35 = step_filtered(x_5, _e34, w_1);
        color = (_e16 + ((_e19 - _e24) * _e35));
    }
    vec4 _e41 = color;
    return _e41;
}

vec3 bumped_normal(vec4 along_x, vec4 along_y, vec3 normal) {
    float _e4 = length_of(along_x.xyz);
    float _e6 = length_of(along_y.xyz);
    float largest_3 = max(_e4, _e6);
    if (((largest_3 < 1e-18) || (largest_3 > 1e18))) {
        return normal;
    }
    vec3 s_3 = (along_x.xyz / vec3(largest_3));
    vec3 t_3 = (along_y.xyz / vec3(largest_3));
    vec2 rise = clamp((vec2(along_x.w, along_y.w) / vec2(largest_3)), vec2(-1000000.0), vec2(1000000.0));
    vec3 right = cross(t_3, normal);
    vec3 up = cross(normal, s_3);
    float area = dot(s_3, right);
    if ((abs(area) < 1e-6)) {
        return normal;
    }
    vec3 slope = (((rise.x * right) + (rise.y * up)) / vec3(area));
    float steepness = length(slope);
    vec3 limited = (slope * (min(steepness, 10.0) / max(steepness, 1e-20)));
    vec3 _e50 = normalize_or((normal - limited), normal);
    return _e50;
}

vec3 bump_map(float height, float scale, vec3 normal_1, vec3 position) {
    float raised = (height * scale);
    vec3 _e5 = dFdx(position);
    float _e6 = dFdx(raised);
    vec4 along_x_1 = vec4(_e5, _e6);
    vec3 _e8 = dFdy(position);
    float _e9 = dFdy(raised);
    vec4 along_y_1 = vec4(_e8, _e9);
    vec3 _e11 = bumped_normal(along_x_1, along_y_1, normal_1);
    return _e11;
}

vec4 blend_add(vec4 below, vec4 color_1, float tone, float opacity, bool clamped) {
    return max(vec4((below.xyz + (opacity * ((below.xyz + color_1.xyz) - below.xyz))), 1.0), vec4(0.0));
}

vec4 blend_add_2_(vec4 below_1, vec4 color_2, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * color_2.xyz)) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_alpha(vec4 below_2, vec4 color_3, float tone_2, float opacity_2, bool clamped_2) {
    return clamp(vec4((below_2.xyz + (opacity_2 * ((below_2.xyz + (tone_2 * (color_3.xyz - below_2.xyz))) - below_2.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_4, float tone_3) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_4.xyz * light.color) * split.y), 1.0), (tone_3 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal_2, vec3 view) {
    vec3 d_3 = (((2.0 * dot(normal_2, view)) * normal_2) - view);
    return Angle((0.5 * length((d_3 - light_1.direction))), (0.5 * length((d_3 + light_1.direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w_2, ProfileShape shape_1) {
    float width = sqrt(((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w_2 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_2, float w_3, ProfileShape shape_2) {
    vec2 place = vec2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    float _e19 = profile_soft_quick(place.x, shape_2);
    if ((w_3 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_3);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_4, ProfileShape shape_3) {
    vec2 place_1 = vec2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_4 > 0.0) && (w_4 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place_1.x, w_4, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_3);
    if ((w_4 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_4);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_3);
    float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_3);
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
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
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

float gradient_dot(uvec3 hash_1, vec3 d) {
    uint axis = ((hash_1.x >> 8u) % 3u);
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash_1.y >> 31u) == 0u) ? a : -(a)) + (((hash_1.z >> 31u) == 0u) ? b : -(b)));
}

vec3 fade_quintic(vec3 t_1) {
    return (((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i_1 = 0;
    vec3 corner = floor(p);
    vec3 d_4 = (p - corner);
    vec3 _e4 = fade_quintic(d_4);
    ivec3 cell_1 = ivec3(corner);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e46 = i_1;
            i_1 = (_e46 + 1);
        }
        loop_init_1 = false;
        int _e10 = i_1;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i_1;
            int _e16 = i_1;
            int _e21 = i_1;
            ivec3 at = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at), seed_2);
            float _e42 = gradient_dot(_e39, (d_4 - vec3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

Cell nearest_cell(vec3 p_1, uint seed_3) {
    vec3 nearest = vec3(4.0);
    uvec3 hash_2 = uvec3(0u);
    int i_2 = 0;
    float border = 0.0;
    int i_3 = 0;
    vec3 corner_1 = floor(p_1);
    vec3 d_5 = (p_1 - corner_1);
    ivec3 cell_2 = ivec3(corner_1);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e51 = i_2;
            i_2 = (_e51 + 1);
        }
        loop_init_2 = false;
        int _e13 = i_2;
        if ((_e13 < 27)) {
        } else {
            break;
        }
        {
            int _e16 = i_2;
            int _e21 = i_2;
            int _e28 = i_2;
            ivec3 at_1 = ivec3(((_e16 % 3) - 1), (((_e21 / 3) % 3) - 1), ((_e28 / 9) - 1));
            uvec3 _e35 = lattice_hash((cell_2 + at_1), seed_3);
            vec3 _e40 = unit_of_hash(_e35);
            vec3 offset = (((vec3(at_1) + vec3(0.25)) + (0.5 * _e40)) - d_5);
            vec3 _e46 = nearest;
            vec3 _e47 = nearest;
            if ((dot(offset, offset) < dot(_e46, _e47))) {
                nearest = offset;
                hash_2 = _e35;
            }
        }
    }
    vec3 _e53 = nearest;
    float distance_ = length(_e53);
    border = max((0.5 * (CELL_REACH - distance_)), 0.0);
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e110 = i_3;
            i_3 = (_e110 + 1);
        }
        loop_init_3 = false;
        int _e64 = i_3;
        if ((_e64 < 27)) {
        } else {
            break;
        }
        {
            int _e67 = i_3;
            int _e72 = i_3;
            int _e79 = i_3;
            ivec3 at_2 = ivec3(((_e67 % 3) - 1), (((_e72 / 3) % 3) - 1), ((_e79 / 9) - 1));
            uvec3 _e90 = lattice_hash((cell_2 + at_2), seed_3);
            vec3 _e91 = unit_of_hash(_e90);
            vec3 _e96 = nearest;
            vec3 apart = ((((vec3(at_2) + vec3(0.25)) + (0.5 * _e91)) - d_5) - _e96);
            float between = length(apart);
            if ((between > 0.25)) {
                float _e101 = border;
                vec3 _e102 = nearest;
                border = min(_e101, (dot((_e102 + (0.5 * apart)), apart) / between));
            }
        }
    }
    float _e112 = border;
    uvec3 _e115 = hash_2;
    uvec3 _e116 = hash_pcg3d(_e115);
    vec3 _e117 = unit_of_hash(_e116);
    return Cell(max(_e112, 0.0), _e117.x, distance_);
}

float fractal_noise(uint kind, vec3 p_2, int octaves, float roughness, int seed_4, float w_5) {
    float octave = 0.0;
    int i_4 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            int _e66 = i_4;
            i_4 = (_e66 + 1);
        }
        loop_init_4 = false;
        int _e17 = i_4;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased((w_5 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_4;
            vec3 place_2 = clamp(((p_2 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_4;
            float _e50 = perlin_noise(place_2, (0u + uint(_e47)));
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

Cells cells(vec3 position_1, float scale_1, int seed_5) {
    vec3 p_3 = clamp((position_1 * scale_1), vec3(-4194304.0), vec3(4194304.0));
    Cell _e10 = nearest_cell(p_3, 4u);
    float _e11 = footprint_of_vec3_2_(p_3);
    float visible_1 = (1.0 - smoothstep(0.5, 1.0, _e11));
    vec3 average = vec3(0.1301, 0.5, 0.491);
    vec3 seen = mix(average, vec3(_e10.border, _e10.random, _e10.distance_), visible_1);
    return Cells(seen.x, seen.y, seen.z);
}

float noise_perlin(vec3 position_2, float scale_2, int octaves_1, float roughness_1, int seed_6) {
    vec3 p_4 = (position_2 * scale_2);
    float _e7 = footprint_of_vec3_(p_4);
    float _e8 = fractal_noise(NOISE_PERLIN, p_4, octaves_1, roughness_1, seed_6, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    Cells _e4 = cells(surface.position_object, 3.4, 4);
    float _e8 = footprint_of(_e4.random);
    vec4 _e9 = ramp_at(colors_1, _e4.random, _e8);
    vec4 _e18 = blend_add(vec4(0.0275, 0.0235, 0.0471, 1.0), _e9, 1.0, 0.3, true);
    float _e24 = noise_perlin(surface.position_object, 5.0, 2, 0.5, 0);
    vec3 _e28 = bump_map(_e24, 0.03, surface.normal, surface.position);
    vec3 _e32 = u_look.sun.direction;
    vec3 _e40 = u_look.sun.direction;
    Angle sun_turn = Angle((0.5 * length((_e28 - _e32))), (0.5 * length((_e28 + _e40))));
    float _e48 = profile_balanced(sun_turn, 0.0, through_the_glass_shape);
    vec4 _e51 = blend_add_2_(_e18, _e9, _e48, 0.95, true);
    vec3 _e55 = u_look.room.direction;
    vec3 _e63 = u_look.room.direction;
    Angle room_turn = Angle((0.5 * length((_e28 - _e55))), (0.5 * length((_e28 + _e63))));
    float _e71 = profile_balanced(room_turn, 0.0, on_the_glass_shape);
    vec4 _e74 = blend_add_2_(_e51, _e9, _e71, 0.45, true);
    float _e78 = footprint_of(_e4.border);
    float _e82 = step_filtered(_e4.border, 0.035, length(vec2(_e78, 0.0)));
    float leading = (1.0 - _e82);
    vec4 leading_2_ = clamp(vec4((_e74.xyz + (leading * (vec3(0.0824, 0.0863, 0.102) - _e74.xyz))), 1.0), vec4(0.0), vec4(1.0));
    Light _e103 = u_look.room;
    Angle _e105 = parametrization_specular_balanced(_e103, _e28, surface.view);
    float _e108 = profile_balanced_2_(_e105, 0.0, gleam_tone_shape);
    Light _e111 = u_look.room;
    LitLayer _e117 = light_apply(_e111, vec4(1.0, 0.9647, 0.8941, 1.0), _e108);
    vec4 _e122 = blend_alpha(leading_2_, _e117.color, _e117.tone, 0.7, true);
    Light _e125 = u_look.room;
    Angle _e128 = parametrization_specular_balanced(_e125, surface.normal, surface.view);
    float _e131 = profile_balanced_2_(_e128, 0.0, edge_of_the_lead_tone_shape);
    Light _e134 = u_look.room;
    LitLayer _e140 = light_apply(_e134, vec4(0.1725, 0.1843, 0.2196, 1.0), _e131);
    vec4 _e145 = blend_add_2_(_e122, _e140.color, _e140.tone, 0.35, true);
    return _e145;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position, in_.position_object);
    vec4 _e21 = shade(surface_1);
    out_color = _e21;
    return;
}

