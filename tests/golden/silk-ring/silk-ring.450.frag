#version 450 core
// Silk: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// silk-ring.json says what to put there and how to draw.
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
    Light low;
    Light key;
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
const ProfileShape lit_side_shape = ProfileShape(0.9950042, 0.099833414, 1.1883951, 1.7298278, 0.2, 1.0107075, 0.4419037, 0u);
const ProfileShape band_shape = ProfileShape(0.9998875, 0.014999437, 9.541332, 4.980432, 0.03, 0.07759806, 0.03648918, 0u);
const ProfileShape second_band_shape = ProfileShape(1.0, 0.0, 6.6917324, 12.899528, 0.0, 0.07171497, 0.035865854, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
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

vec3 normalize_seen_balanced(vec3 v_2) {
    return (v_2 * inversesqrt(max(dot(v_2, v_2), 1e-30)));
}

vec2 sin_cos_quick(float x_1) {
    float y_1 = (x_1 * x_1);
    float s_2 = (x_1 * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return vec2(s_2, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_1));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_turned_2_(Angle u_2, vec2 t_1) {
    float s_4 = (u_2.half_sin - 0.0);
    vec2 upper_1 = ((u_2.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_4, u_2.half_cos));
    vec2 turned_1 = (((s_4 <= 0.0) && (s_4 < u_2.half_cos)) ? vec2(0.0, 1.0) : upper_1);
    return Angle(turned_1.x, turned_1.y);
}

float bounded(float x_2) {
    uint bits = floatBitsToUint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_3, float low, float high) {
    float _e3 = bounded(x_3);
    float _e7 = bounded(((_e3 - low) / 0.5));
    float t_3 = clamp(_e7, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float footprint_of_vec3_(vec3 v_3) {
    vec3 dx_1 = dFdx(v_3);
    vec3 dy_1 = dFdy(v_3);
    float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

vec3 any_orthogonal(vec3 n) {
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_ + n.z));
    return vec3((1.0 + (((sign_ * n.x) * n.x) * a)), (((sign_ * n.x) * n.y) * a), (-(sign_) * n.x));
}

DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 y_2 = (y_axis * inversesqrt(max(dot(y_axis, y_axis), 1e-30)));
    return DirectionParts(direction, x_axis, y_2, vec2(dot(direction, x_axis), dot(direction, y_2)));
}

vec3 direction_moved(DirectionParts parts, vec2 by) {
    vec3 moved = ((parts.direction + (by.x * parts.x_axis)) + (by.y * parts.y_axis));
    vec3 _e13 = normalize_moderate(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e13 : parts.direction);
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 leaning = cross(up, toward);
    float square_2 = dot(leaning, leaning);
    vec3 aside = ((abs(toward.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    vec3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e28, cross(toward, _e28), toward);
}

AxesAround axes(vec3 direction_1, vec3 up_1) {
    mat3x3 _e2 = axes_around(direction_1, up_1);
    return AxesAround(_e2[0], _e2[1]);
}

vec3 half_vector(Light light, vec3 view) {
    vec3 half_1 = (light.direction + view);
    vec3 _e4 = any_orthogonal(view);
    vec3 _e9 = normalize_or(((dot(half_1, half_1) > 1e-12) ? half_1 : _e4), view);
    return _e9;
}

vec3 stretch_direction(vec3 direction_2, vec3 x_axis_1, vec3 y_axis_1, float x_4, float y) {
    DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    vec3 _e10 = direction_moved(_e5, (-(vec2(x_4, y)) * _e5.place));
    return _e10;
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

vec4 blend_alpha_2_(vec4 below_1, vec4 color_1, float tone_1, float opacity_1, bool clamped_1) {
    return clamp(vec4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), vec4(0.0), vec4(1.0));
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

float profile_filtered_quick(Angle u_3, float w_1, ProfileShape shape_2) {
    vec2 place = vec2(((u_3.half_sin * shape_2.half_cos_offset) - (u_3.half_cos * shape_2.half_sin_offset)), ((u_3.half_cos * shape_2.half_cos_offset) + (u_3.half_sin * shape_2.half_sin_offset)));
    float _e19 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_4, float w_2, ProfileShape shape_3) {
    vec2 place_1 = vec2(((u_4.half_sin * shape_3.half_cos_offset) - (u_4.half_cos * shape_3.half_sin_offset)), ((u_4.half_cos * shape_3.half_cos_offset) + (u_4.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) && (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place_1.x, w_2, shape_3);
        return _e28;
    }
    float _e30 = profile_soft_quick(place_1.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_2);
    vec2 turn_1 = vec2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    float _e56 = profile_soft_quick(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_3);
    float _e64 = profile_soft_quick(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4) {
    Angle _e6 = angle_turned_2_(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5) {
    vec2 _e5 = sin_cos_quick((0.5 * shift_1));
    Angle _e6 = angle_turned(angle_1, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_5);
    return _e8;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_4 = uvec3(0u);
    v_4 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_4.x;
    uint _e10 = v_4.y;
    uint _e12 = v_4.z;
    v_4.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_4.y;
    uint _e18 = v_4.z;
    uint _e20 = v_4.x;
    v_4.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_4.z;
    uint _e26 = v_4.x;
    uint _e28 = v_4.y;
    v_4.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_4;
    uvec3 _e32 = v_4;
    v_4 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_4.x;
    uint _e40 = v_4.y;
    uint _e42 = v_4.z;
    v_4.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_4.y;
    uint _e48 = v_4.z;
    uint _e50 = v_4.x;
    v_4.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_4.z;
    uint _e56 = v_4.x;
    uint _e58 = v_4.y;
    v_4.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_4;
    return _e61;
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a_1 = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_1 : -(a_1)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
}

vec3 fade_quintic(vec3 t_2) {
    return (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 d_1 = (p - corner);
    vec3 _e4 = fade_quintic(d_1);
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
            float _e42 = gradient_dot(_e39, (d_1 - vec3(at)));
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
            vec3 place_2 = clamp(((p_1 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_1;
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

float noise_perlin(vec3 position, float scale, int octaves_1, float roughness_1, int seed_4) {
    vec3 p_2 = (position * scale);
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle turned_from_the_key = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    vec4 _e35 = blend_alpha(vec4(0.2275, 0.102, 0.2431, 1.0), vec4(0.4824, 0.1843, 0.3882, 1.0), _e22, 1.0, true);
    vec3 normal = surface.normal;
    Light _e39 = u_look.key;
    vec3 _e41 = half_vector(_e39, surface.view);
    AxesAround _e46 = axes(_e41, vec3(0.0, 1.0, 0.0));
    vec3 _e51 = stretch_direction(normal, _e46.x_axis, _e46.y_axis, 0.985, 0.0);
    Angle from_the_band = Angle((0.5 * length((_e51 - _e41))), (0.5 * length((_e51 + _e41))));
    float _e66 = noise_perlin(surface.position_object, 14.0, 2, 0.5, 0);
    float waver = mix(-0.05, 0.05, (_e66 - 0.0));
    float _e73 = profile_balanced_2_(from_the_band, waver, band_shape);
    vec4 _e81 = blend_alpha_2_(_e35, vec4(0.9529, 0.6627, 0.7059, 1.0), _e73, 0.95, true);
    Light _e84 = u_look.low;
    vec3 _e86 = half_vector(_e84, surface.view);
    AxesAround _e91 = axes(_e86, vec3(0.0, 1.0, 0.0));
    vec3 _e96 = stretch_direction(normal, _e91.x_axis, _e91.y_axis, 0.985, 0.0);
    Angle from_the_second = Angle((0.5 * length((_e96 - _e86))), (0.5 * length((_e96 + _e86))));
    float _e107 = profile_balanced_2_(from_the_second, waver, second_band_shape);
    vec4 second_band_on_top = clamp(vec4((_e81.xyz + (0.8 * ((_e81.xyz + (_e107 * vec3(0.3529, 0.2471, 0.549))) - _e81.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return second_band_on_top;
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

