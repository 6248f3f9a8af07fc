#version 330 core
// Watercolor wash: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// watercolor-wash.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
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
    vec3 position_object;
    vec2 pixel;
    vec3 anchor;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct PaperGrain {
    float tone;
    float height;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
const float MOST_ON_SCREEN = 1000000000000000.0;
const Ramp two_pigments = Ramp(vec4[16](vec4(0.1843, 0.4353, 0.5608, 1.0), vec4(0.2471, 0.6039, 0.5255, 1.0), vec4(0.7882, 0.6353, 0.2353, 1.0), vec4(0.8471, 0.451, 0.3529, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.45, 0.75, 1.0), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent), exponent));
}

float log2_stable(float x) {
    uint bits = floatBitsToUint(x);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise) {
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x_1) {
    uint bits_1 = floatBitsToUint(x_1);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

vec3 bounded_vec3_(vec3 v_3) {
    uvec3 bits_2 = floatBitsToUint(v_3);
    uvec3 magnitude_1 = (bits_2 & uvec3(2147483647u));
    vec3 largest_1 = uintBitsToFloat(((bits_2 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest_1, equal(magnitude_1, uvec3(2139095040u)));
    return mix(numbers, v_3, lessThan(magnitude_1, uvec3(2139095040u)));
}

vec4 bounded_vec4_(vec4 v_4) {
    uvec4 bits_3 = floatBitsToUint(v_4);
    uvec4 magnitude_2 = (bits_3 & uvec4(2147483647u));
    vec4 largest_2 = uintBitsToFloat(((bits_3 & uvec4(2147483648u)) | uvec4(2139095039u)));
    vec4 numbers_1 = mix(vec4(0.0), largest_2, equal(magnitude_2, uvec4(2139095040u)));
    return mix(numbers_1, v_4, lessThan(magnitude_2, uvec4(2139095040u)));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

vec3 mixed_vec3_(vec3 a_1, vec3 b_1, float t) {
    vec3 _e4 = bounded_vec3_((b_1 - a_1));
    vec3 _e14 = bounded_vec3_(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

vec3 mixed_vec3_2_(vec3 a_2, vec3 b_2, float t_1) {
    vec3 d_1 = (b_2 - a_2);
    vec3 _e13 = bounded_vec3_(((t_1 < 0.5) ? (a_2 + (t_1 * d_1)) : (b_2 - ((1.0 - t_1) * d_1))));
    return _e13;
}

vec4 mixed_vec4_(vec4 a_3, vec4 b_3, float t_2) {
    vec4 _e4 = bounded_vec4_((b_3 - a_3));
    vec4 _e14 = bounded_vec4_(((t_2 < 0.5) ? (a_3 + (t_2 * _e4)) : (b_3 - ((1.0 - t_2) * _e4))));
    return _e14;
}

float eased(float x_2, float low, float high) {
    float _e3 = bounded(x_2);
    float _e7 = bounded(((_e3 - low) / 0.5));
    float t_5 = clamp(_e7, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float eased_2_(float x_3, float low_1, float high_1) {
    float t_6 = clamp(((x_3 - low_1) / (high_1 - low_1)), 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float footprint_of(float x_4) {
    float _e1 = dFdx(x_4);
    float _e2 = dFdy(x_4);
    vec2 d_2 = vec2(_e1, _e2);
    return sqrt(dot(d_2, d_2));
}

float footprint_of_vec3_(vec3 v_5) {
    vec3 dx = dFdx(v_5);
    vec3 dy = dFdy(v_5);
    float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

vec4 color_mixed(vec4 a_4, vec3 blended, float factor) {
    vec3 _e4 = bounded_vec3_(a_4.xyz);
    vec3 _e5 = bounded_vec3_(blended);
    vec3 _e7 = bounded_vec3_((_e5 - _e4));
    vec3 _e10 = bounded_vec3_((_e4 + (factor * _e7)));
    return vec4(_e10, 1.0);
}

vec4 hermite(vec4 a_5, vec4 b_4, vec4 from_a, vec4 to_b, float t_3) {
    vec4 d_3 = (b_4 - a_5);
    return (a_5 + (t_3 * (from_a + (t_3 * ((((3.0 * d_3) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_3))))))));
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

vec4 ramp_at(Ramp ramp, float x_5, float w) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint i_2_ = 1u;
    uint at = 0u;
    vec4 from_a_1 = vec4(0.0);
    vec4 to_b_1 = vec4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e25 = i_2_;
            i_2_ = (_e25 + 1u);
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 4u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e18 = i_2_;
        float _e22 = places[0][(_e18 % 4u)];
        at = ((_e22 <= x_5) ? _e16 : _e15);
    }
    uint _e29 = at;
    float place_4 = places[0][(_e29 % 4u)];
    uint _e34 = at;
    if ((((_e34 + 1u) >= 4u) || (x_5 <= place_4))) {
        uint _e41 = at;
        vec4 _e43 = colors[_e41];
        return _e43;
    }
    uint _e44 = at;
    uint after_1 = (_e44 + 1u);
    float _e53 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span = (_e53 - place_4);
    float _e56 = divided((x_5 - place_4), span);
    float t_7 = clamp(_e56, 0.0, 1.0);
    uint _e63 = at;
    if ((_e63 > 0u)) {
        uint _e66 = at;
        uint _e72 = at;
        float before_1 = places[((_e66 - 1u) / 4u)][((_e72 - 1u) % 4u)];
        uint _e79 = at;
        vec4 _e81 = colors[_e79];
        uint _e82 = at;
        vec4 _e86 = colors[(_e82 - 1u)];
        vec4 _e90 = colors[after_1];
        uint _e91 = at;
        vec4 _e93 = colors[_e91];
        vec4 _e95 = ramp_slope((_e81 - _e86), (place_4 - before_1), (_e90 - _e93), span);
        from_a_1 = _e95;
    }
    if (((after_1 + 1u) < 4u)) {
        float _e113 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e113 - (place_4 + span));
        vec4 _e117 = colors[after_1];
        uint _e118 = at;
        vec4 _e120 = colors[_e118];
        vec4 _e125 = colors[(after_1 + 1u)];
        vec4 _e127 = colors[after_1];
        vec4 _e129 = ramp_slope((_e117 - _e120), span, (_e125 - _e127), next);
        to_b_1 = _e129;
    }
    uint _e130 = at;
    vec4 _e132 = colors[_e130];
    vec4 _e134 = colors[after_1];
    vec4 _e135 = from_a_1;
    vec4 _e137 = to_b_1;
    vec4 _e139 = hermite(_e132, _e134, (span * _e135), (span * _e137), t_7);
    vec4 _e140 = bounded_vec4_(_e139);
    return _e140;
}

vec4 mix_colors_multiply(vec4 a_6, vec4 b_5, float factor_1) {
    vec3 _e7 = mixed_vec3_2_(a_6.xyz, (a_6.xyz * b_5.xyz), factor_1);
    return vec4(_e7, 1.0);
}

vec4 mix_colors_multiply_2_(vec4 a_7, vec4 b_6, float factor_2) {
    vec3 blended_1 = (a_7.xyz * b_6.xyz);
    vec3 _e7 = bounded_vec3_(a_7.xyz);
    vec3 _e9 = bounded_vec3_((blended_1 - _e7));
    float _e14 = bounded(a_7.w);
    return vec4((blended_1 - (0.25 * _e9)), _e14);
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

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a_8 = ((axis == 0u) ? d.y : d.x);
    float b_7 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_8 : -(a_8)) + (((hash.z >> 31u) == 0u) ? b_7 : -(b_7)));
}

vec3 fade_quintic(vec3 t_4) {
    return (((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 d_4 = (p - corner);
    vec3 _e4 = fade_quintic(d_4);
    ivec3 cell_1 = ivec3(corner);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e46 = i;
            i = (_e46 + 1);
        }
        loop_init_1 = false;
        int _e10 = i;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            ivec3 at_2 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at_2, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at_2), seed_2);
            float _e42 = gradient_dot(_e39, (d_4 - vec3(at_2)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float perlin_noise_2_(vec3 p_1, uint seed_3) {
    int i_1 = 0;
    float sum_1 = 0.0;
    vec3 corner_1 = floor(p_1);
    vec3 d_5 = (p_1 - corner_1);
    vec3 f = (((d_5 * d_5) * d_5) * ((d_5 * ((d_5 * 6.0) - vec3(15.0))) + vec3(10.0)));
    ivec3 cell_2 = ivec3(corner_1);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e64 = i_1;
            i_1 = (_e64 + 1);
        }
        loop_init_2 = false;
        int _e21 = i_1;
        if (!((_e21 < 8))) {
            break;
        }
        int _e25 = i_1;
        int _e28 = i_1;
        int _e33 = i_1;
        ivec3 at_3 = ivec3((_e25 & 1), ((_e28 >> 1u) & 1), (_e33 >> 2u));
        vec3 weight_1 = mix((vec3(1.0) - f), f, equal(at_3, ivec3(1)));
        float _e44 = sum_1;
        uvec3 _e58 = hash_pcg3d((uvec3((cell_2 + at_3)) + (seed_3 * uvec3(2654435769u, 2246822507u, 3266489909u))));
        float _e61 = gradient_dot(_e58, (d_5 - vec3(at_3)));
        sum_1 = (_e44 + (((weight_1.x * weight_1.y) * 0.5) * _e61));
    }
    float _e67 = sum_1;
    return clamp((0.5 + (0.48244 * _e67)), 0.0, 1.0);
}

float fractal_noise(uint kind, vec3 p_2, int octaves, float roughness, int seed_4, float w_1) {
    float octave = 0.0;
    int i_2 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_2 = 0.0;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e66 = i_2;
            i_2 = (_e66 + 1);
        }
        loop_init_3 = false;
        int _e17 = i_2;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased((w_1 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_2;
            vec3 place_5 = clamp(((p_2 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_2;
            float _e50 = perlin_noise(place_5, (11u + uint(_e47)));
            octave = mix(0.5, _e50, visible);
        }
        float _e53 = sum_2;
        float _e54 = strength;
        float _e55 = octave;
        sum_2 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * roughness);
        float _e63 = frequency;
        frequency = (_e63 * 2.0);
    }
    float _e69 = sum_2;
    return min((_e69 / 1.5), 1.0);
}

float fractal_noise_2_(uint kind_1, vec3 p_3, int octaves_1, float roughness_1, int seed_5, float w_2) {
    float octave_1 = 0.0;
    int i_3 = 0;
    float frequency_1 = 1.0;
    float strength_1 = 1.0;
    float total_1 = 0.0;
    float sum_3 = 0.0;
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            int _e66 = i_3;
            i_3 = (_e66 + 1);
        }
        loop_init_4 = false;
        int _e17 = i_3;
        if (!((_e17 < 4))) {
            break;
        }
        float _e21 = frequency_1;
        float _e25 = eased((w_2 * _e21), 0.5, 1.0);
        float visible_1 = (1.0 - _e25);
        octave_1 = 0.5;
        if ((visible_1 > 0.0)) {
            float _e31 = frequency_1;
            int _e33 = i_3;
            vec3 place_6 = clamp(((p_3 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_3;
            float _e50 = perlin_noise(place_6, (0u + uint(_e47)));
            octave_1 = mix(0.5, _e50, visible_1);
        }
        float _e53 = sum_3;
        float _e54 = strength_1;
        float _e55 = octave_1;
        sum_3 = (_e53 + (_e54 * _e55));
        float _e58 = total_1;
        float _e59 = strength_1;
        total_1 = (_e58 + _e59);
        float _e61 = strength_1;
        strength_1 = (_e61 * roughness_1);
        float _e63 = frequency_1;
        frequency_1 = (_e63 * 2.0);
    }
    float _e69 = sum_3;
    float _e70 = total_1;
    return min((_e69 / _e70), 1.0);
}

float size_on_screen(float depth, float perspective, float scale) {
    return min(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

vec3 anchor_on_screen(vec3 origin, float perspective_1, float scale_1) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return clamp(vec3((origin.x * _e5), (-(origin.y) * _e5), _e5), vec3(-1000000000000000.0), vec3(1000000000000000.0));
}

vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 from_middle = (pixel - (0.5 * viewport));
    return (vec2(from_middle.x, -(from_middle.y)) / vec2(max(viewport.y, 1.0)));
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 turn = vec2(0.0, 1.0);
    vec3 x_6 = ((turn.y * along) + (turn.x * across));
    vec3 y = ((turn.y * across) - (turn.x * along));
    vec2 turned = vec2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    vec3 stretch_3 = vec3(dot(x_6, x_6), dot(x_6, y), dot(y, y));
    return StretchedPlace(turned, stretch_3);
}

SpacedPlace spaced(vec2 place_1, vec3 stretch, vec2 viewport_1, float count) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_4 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    vec2 p_4 = clamp((place_1 * scale_4), vec2(-4194304.0), vec2(4194304.0));
    return SpacedPlace(p_4, (is_pixel ? vec3(1.0, 0.0, 1.0) : stretch));
}

float area_square(vec3 stretch_1) {
    float sum_4 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_4 * sum_4) / 66.0));
}

MarkPlace mark_place_object(float angle_1, vec3 anchor, vec2 pixel_1, vec2 viewport_2) {
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    vec2 _e8 = place_in_picture(pixel_1, viewport_2);
    vec2 place_7 = ((_e8 - vec2(anchor.x, -(anchor.y))) / vec2(size));
    StretchedPlace _e26 = mark_place_of(place_7, vec3((1.0 / size), 0.0, 0.0), vec3(0.0, (1.0 / size), 0.0), angle_1);
    return MarkPlace(_e26.place, _e26.stretch);
}

float paper_octave(vec2 place_2, int zoom, float w_3, float fiber, uint seed_6) {
    float scale_5 = uintBitsToFloat((uint((zoom + 127)) << 23u));
    vec2 p_5 = clamp((place_2 * scale_5), vec2(-4194304.0), vec2(4194304.0));
    uint own = (seed_6 + (7u * uint(zoom)));
    float _e23 = perlin_noise_2_(vec3(p_5, 0.5), own);
    float grain = (_e23 - 0.5);
    vec2 q = clamp((2.7 * vec2(((0.8 * p_5.x) - (0.6 * p_5.y)), ((0.6 * p_5.x) + (0.8 * p_5.y)))), vec2(-4194304.0), vec2(4194304.0));
    float _e52 = perlin_noise_2_(vec3(q, 0.5), (own + 1u));
    float felt = (_e52 - 0.5);
    float coarse_seen = (1.0 - smoothstep(0.5, 1.0, (w_3 * scale_5)));
    float felt_seen = (1.0 - smoothstep(0.5, 1.0, ((2.7 * w_3) * scale_5)));
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

float paper_height(SpacedPlace at_1, float fiber_1, uint seed_7) {
    float height = 0.0;
    vec2 x_7 = dFdx(at_1.place);
    vec2 y_1 = dFdy(at_1.place);
    float w_4 = sqrt(max(dot(x_7, x_7), dot(y_1, y_1)));
    float _e12 = area_square(at_1.stretch);
    float _e16 = log2_stable(max(sqrt(_e12), 1e-30));
    float level = clamp((-0.5 * _e16), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    float _e26 = paper_octave(at_1.place, int(zoom_1), w_4, fiber_1, seed_7);
    height = _e26;
    if ((f_1 > 0.0)) {
        float _e30 = height;
        float _e35 = paper_octave(at_1.place, (int(zoom_1) + 1), w_4, fiber_1, seed_7);
        float both = mix(_e30, _e35, f_1);
        height = clamp((0.5 + ((both - 0.5) / sqrt(((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))))), 0.0, 1.0);
    }
    float _e53 = height;
    return _e53;
}

PaperGrain paper_grain(float value, vec2 place_3, vec3 stretch_2, float count_1, float tooth, float fiber_2, int seed_8, vec2 viewport_3) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    float _e10 = paper_height(_e8, fiber_2, 0u);
    return PaperGrain((1.0 - clamp((0.5 + ((((8.0 * tooth) * (_e10 - 0.5)) * 0.5) * 0.5)), 0.0, 1.0)), _e10);
}

float outer_contour(float width, vec3 normal, vec3 view, vec2 viewport_4) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport_4.y, 1.0, 100000.0)) / 1000.0);
    float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

float noise_perlin(vec3 position, float scale_2, int octaves_2, float roughness_2, int seed_9) {
    vec3 p_6 = (position * scale_2);
    float _e7 = footprint_of_vec3_(p_6);
    float _e8 = fractal_noise(NOISE_PERLIN, p_6, octaves_2, roughness_2, seed_9, _e7);
    return _e8;
}

float noise_perlin_2_(vec3 position_1, float scale_3, int octaves_3, float roughness_3, int seed_10) {
    vec3 p_7 = (position_1 * scale_3);
    float _e7 = footprint_of_vec3_(p_7);
    float _e8 = fractal_noise_2_(NOISE_PERLIN, p_7, octaves_3, roughness_3, seed_10, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    float _e6 = noise_perlin(surface.position_object, 1.5, 2, 0.5, 11);
    float spread = clamp(((_e6 - 0.32) / 0.36), 0.0, 1.0);
    float _e15 = footprint_of(spread);
    vec4 _e16 = ramp_at(two_pigments, spread, _e15);
    vec3 _e21 = u_look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e21) + 0.45) / 1.45), 0.0);
    float tone = min(((shade_2_ - 0.0) / 0.85), 1.0);
    float _e40 = noise_perlin_2_(surface.position_object, 2.2, 4, 0.55, 0);
    float how_far_it_runs = mix(-0.24, 0.24, (_e40 - 0.0));
    float wet_tone = (tone + how_far_it_runs);
    float _e49 = eased_2_(wet_tone, 0.82, 0.7);
    float k1_ = (_e49 * 0.62);
    vec4 _e57 = mix_colors_multiply(vec4(0.9843, 0.9686, 0.9255, 1.0), _e16, k1_);
    vec4 _e64 = mix_colors_multiply_2_(_e16, vec4(0.3529, 0.3098, 0.5255, 1.0), 0.75);
    float _e67 = eased_2_(wet_tone, 0.42, 0.34);
    float k2_ = (_e67 * 0.6);
    vec3 _e71 = bounded_vec3_(_e57.xyz);
    vec3 _e75 = bounded_vec3_((_e57.xyz * _e64.xyz));
    vec3 _e76 = mixed_vec3_(_e71, _e75, k2_);
    vec4 second_on_the_first = vec4(_e76, 1.0);
    float pigment_s_rim = (smoothstep(0.66, 0.72, wet_tone) * _e49);
    float second_rim = (smoothstep(0.29, 0.34, wet_tone) * _e67);
    float k3_ = (max(pigment_s_rim, second_rim) * 0.34);
    vec4 _e93 = color_mixed(second_on_the_first, (second_on_the_first.xyz * _e64.xyz), k3_);
    vec2 _e99 = u_look.viewport;
    MarkPlace _e100 = mark_place_object(0.0, surface.anchor, surface.pixel, _e99);
    vec2 _e110 = u_look.viewport;
    PaperGrain _e111 = paper_grain(0.5, _e100.place, _e100.stretch, 240.0, 0.6, 0.6, 0, _e110);
    float _e113 = bounded(_e111.tone);
    float settled_pigment = mix(0.9, 1.03, (_e113 - 0.0));
    vec4 _e123 = bounded_vec4_((_e93 * vec4(vec3(settled_pigment), 1.0)));
    vec2 _e129 = u_look.viewport;
    float _e130 = outer_contour(2.2, surface.normal, surface.view, _e129);
    float soft = (_e130 * 0.7);
    vec4 _e133 = bounded_vec4_(_e123);
    vec4 _e139 = mixed_vec4_(_e133, vec4(0.2902, 0.2588, 0.2824, 1.0), soft);
    vec4 _e140 = finite_vec4_(_e139);
    return _e140;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e23 = u_view.screen;
    vec4 _e28 = u_view.screen;
    mat4x4 _e33 = u_view.camera_from_world;
    vec4 _e37 = u_object.world_from_object[3];
    float _e46 = u_view.eye.w;
    float _e51 = u_view.clip_from_world[0][1];
    float _e56 = u_view.clip_from_world[1][1];
    float _e61 = u_view.clip_from_world[2][1];
    vec3 _e64 = anchor_on_screen((_e33 * vec4(_e37.xyz, 1.0)).xyz, _e46, length(vec3(_e51, _e56, _e61)));
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, ((in_.clip.xy * _e23.xy) + _e28.zw), _e64);
    vec4 _e66 = shade(surface_1);
    vec4 _e67 = finite_vec4_(_e66);
    out_color = _e67;
    return;
}

