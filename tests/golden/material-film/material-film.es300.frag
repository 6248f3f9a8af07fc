#version 300 es
// Iridescent film: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-film.json says what to put there and how to draw.

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
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
};
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
const uint NOISE_SIMPLEX = 2u;
const uint NOISE_WORLEY = 3u;
const float SIMPLEX_SCALE = 38.4553;
const float WORLEY_MEAN = 0.5205;

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_position_object;
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

float power_of_two(int n) {
    return uintBitsToFloat((uint((n + 127)) << 23u));
}

float exp2_stable(float x_2) {
    float clamped_5 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_5);
    float f = ((clamped_5 - whole) * LN_2_);
    float p_6 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p_6 * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent_2 = ((shift >= 256) ? (shift - 512) : shift);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_2) * LN_2_) + series);
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float log1p_negative(float y_1) {
    if ((y_1 < 0.25)) {
        float _e3 = log1p_negative_small(y_1);
        return _e3;
    }
    float _e8 = log_stable(max((1.0 - y_1), 1.1754944e-38));
    return _e8;
}

vec2 sin_cos_quarter(float x_4) {
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

vec2 sin_cos(float x_5) {
    float turns = roundEven((x_5 * 0.31830987));
    float r = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    vec2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

float bounded(float x_6) {
    uint bits_1 = floatBitsToUint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec3 bounded_vec3_(vec3 v_3) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    float _e6 = bounded(v_3.z);
    return vec3(_e2, _e4, _e6);
}

float powered(float base, float exponent) {
    bool local_1 = false;
    float _e2 = bounded(base);
    float _e3 = bounded(exponent);
    if ((_e3 == 1.0)) {
        return _e2;
    }
    if ((_e3 == 0.0)) {
        return 1.0;
    }
    if ((_e3 == 2.0)) {
        float _e12 = bounded((_e2 * _e2));
        return _e12;
    }
    float magnitude_1 = abs(_e2);
    if ((magnitude_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e18 = log_stable(magnitude_1);
    float _e21 = bounded((_e3 * (LOG2_E * _e18)));
    float _e22 = exp2_stable(_e21);
    bool is_even = (floor((_e3 * 0.5)) == (_e3 * 0.5));
    if ((_e2 < 0.0)) {
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return (_e36 ? -(_e22) : _e22);
}

float mixed(float a, float b, float t) {
    float _e4 = bounded((b - a));
    float _e14 = bounded(((t < 0.5) ? (a + (t * _e4)) : (b - ((1.0 - t) * _e4))));
    return _e14;
}

float place_between(float x_7, float low, float high) {
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_7 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(span);
    float _e14 = bounded(((x_7 - low) / _e12));
    return _e14;
}

float remapped(float x_8, float from_low, float from_high, float to_low, float to_high, bool clamped) {
    float _e6 = bounded(x_8);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_9, float low_1, float high_1) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_2 = clamp(_e6, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float factor_of(float x_10, bool clamped_1) {
    float _e2 = bounded(x_10);
    float _e3 = bounded(x_10);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

vec2 sin_cos_of(float x_11) {
    float _e1 = bounded(x_11);
    vec2 _e2 = sin_cos(_e1);
    return clamp(_e2, vec2(-1.0), vec2(1.0));
}

float footprint_of_vec3_(vec3 v_4) {
    vec3 dx = dFdx(v_4);
    vec3 dy = dFdy(v_4);
    float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec3 position_object(vec3 position_object_1) {
    return position_object_1;
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped_2) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed_1 = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped_2 ? clamp(mixed_1, vec4(0.0), vec4(1.0)) : mixed_1);
}

vec4 blend_add(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_3) {
    vec4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color.xyz)), below_1.w, (opacity_1 * color.w), clamped_3);
    return _e12;
}

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = (light + view);
    vec3 _e8 = normalize_or(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(vec3 a_1, vec3 b_1) {
    vec3 across = cross(a_1, b_1);
    return min(dot(across, across), 1.0);
}

Reflection reflection_of(vec3 light_1, vec3 normal_1, vec3 view_1) {
    vec3 _e3 = half_of(light_1, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection(dot(normal_1, light_1), dot(normal_1, view_1), n_h, v_h, _e14);
}

float cosine_power(float cosine, float sine2_, float exponent_1) {
    if ((cosine < 0.7)) {
        float _e7 = powered(max(cosine, 0.0), exponent_1);
        return _e7;
    }
    float _e14 = log1p_negative(min(sine2_, 0.6));
    float _e16 = exp2_stable((((0.5 * exponent_1) * LOG2_E) * _e14));
    return _e16;
}

float width_of_roughness(float roughness) {
    float _e1 = bounded(roughness);
    float r_1 = clamp(_e1, 0.0, 1.0);
    return max((r_1 * r_1), 0.001);
}

float schlick(float at_normal, float cosine_1) {
    float m = clamp((1.0 - cosine_1), 0.0, 1.0);
    float m2_ = (m * m);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m)));
}

float exponent_of_width(float width) {
    return max(((2.0 / (width * width)) - 2.0), 0.0);
}

float interference(float path, float wavelength) {
    vec2 _e5 = sin_cos_of(((PI * path) / wavelength));
    return (_e5.x * _e5.x);
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_5 = uvec3(0u);
    v_5 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_5.x;
    uint _e10 = v_5.y;
    uint _e12 = v_5.z;
    v_5.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_5.y;
    uint _e18 = v_5.z;
    uint _e20 = v_5.x;
    v_5.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_5.z;
    uint _e26 = v_5.x;
    uint _e28 = v_5.y;
    v_5.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_5;
    uvec3 _e32 = v_5;
    v_5 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_5.x;
    uint _e40 = v_5.y;
    uint _e42 = v_5.z;
    v_5.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_5.y;
    uint _e48 = v_5.z;
    uint _e50 = v_5.x;
    v_5.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_5.z;
    uint _e56 = v_5.x;
    uint _e58 = v_5.y;
    v_5.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_5;
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
    float a_2 = ((axis == 0u) ? d.y : d.x);
    float b_2 = ((axis == 2u) ? d.y : d.z);
    return ((((hash_1.y >> 31u) == 0u) ? a_2 : -(a_2)) + (((hash_1.z >> 31u) == 0u) ? b_2 : -(b_2)));
}

vec3 fade_quintic(vec3 t_1) {
    return (((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float value_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 _e4 = fade_quintic((p - corner));
    ivec3 cell_1 = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e45 = i;
            i = (_e45 + 1);
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
            vec3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(vec3 p_1, uint seed_3) {
    float sum_1 = 0.0;
    int i_1 = 0;
    vec3 corner_1 = floor(p_1);
    vec3 d_2 = (p_1 - corner_1);
    vec3 _e4 = fade_quintic(d_2);
    ivec3 cell_2 = ivec3(corner_1);
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
            ivec3 at_1 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight_1 = mix((vec3(1.0) - _e4), _e4, equal(at_1, ivec3(1)));
            float _e32 = sum_1;
            uvec3 _e39 = lattice_hash((cell_2 + at_1), seed_3);
            float _e42 = gradient_dot(_e39, (d_2 - vec3(at_1)));
            sum_1 = (_e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42));
        }
    }
    float _e48 = sum_1;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float simplex_corner(vec3 d_1, uvec3 hash_2) {
    float t_3 = max((0.5 - dot(d_1, d_1)), 0.0);
    float _e10 = gradient_dot(hash_2, d_1);
    return ((((t_3 * t_3) * t_3) * t_3) * _e10);
}

float simplex_noise(vec3 p_2, uint seed_4) {
    float sum_2 = 0.0;
    vec3 corner_2 = floor((p_2 + vec3((((p_2.x + p_2.y) + p_2.z) / 3.0))));
    vec3 d_3 = ((p_2 - corner_2) + vec3((((corner_2.x + corner_2.y) + corner_2.z) / 6.0)));
    bvec3 is_first = bvec3((d_3.x >= d_3.y), (d_3.y >= d_3.z), (d_3.z > d_3.x));
    vec3 g = mix(vec3(0.0), vec3(1.0), is_first);
    vec3 l = (vec3(1.0) - g);
    vec3 second = min(g, l.zxy);
    vec3 third = max(g, l.zxy);
    ivec3 cell_3 = ivec3(corner_2);
    uvec3 _e45 = lattice_hash(cell_3, seed_4);
    float _e46 = simplex_corner(d_3, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    uvec3 _e55 = lattice_hash((cell_3 + ivec3(second)), seed_4);
    float _e56 = simplex_corner(((d_3 - second) + vec3(0.16666667)), _e55);
    sum_2 = (_e48 + _e56);
    float _e58 = sum_2;
    uvec3 _e65 = lattice_hash((cell_3 + ivec3(third)), seed_4);
    float _e66 = simplex_corner(((d_3 - third) + vec3(0.33333334)), _e65);
    sum_2 = (_e58 + _e66);
    float _e68 = sum_2;
    uvec3 _e75 = lattice_hash((cell_3 + ivec3(1)), seed_4);
    float _e76 = simplex_corner((d_3 - vec3(0.5)), _e75);
    sum_2 = (_e68 + _e76);
    float _e79 = sum_2;
    return clamp((0.5 + (SIMPLEX_SCALE * _e79)), 0.0, 1.0);
}

float worley_noise(vec3 p_3, uint seed_5) {
    float nearest = 1.0;
    int i_2 = 0;
    vec3 corner_3 = floor(p_3);
    vec3 d_4 = (p_3 - corner_3);
    ivec3 cell_4 = ivec3(corner_3);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e40 = i_2;
            i_2 = (_e40 + 1);
        }
        loop_init_2 = false;
        int _e9 = i_2;
        if ((_e9 < 27)) {
        } else {
            break;
        }
        {
            int _e12 = i_2;
            int _e17 = i_2;
            int _e24 = i_2;
            ivec3 at_2 = ivec3(((_e12 % 3) - 1), (((_e17 / 3) % 3) - 1), ((_e24 / 9) - 1));
            uvec3 _e32 = lattice_hash((cell_4 + at_2), seed_5);
            vec3 _e33 = unit_of_hash(_e32);
            vec3 offset = ((vec3(at_2) + _e33) - d_4);
            float _e36 = nearest;
            nearest = min(_e36, dot(offset, offset));
        }
    }
    float _e42 = nearest;
    return sqrt(_e42);
}

float noise_octave(uint kind, vec3 p_4, uint seed_6) {
    switch(kind) {
        case 1u: {
            float _e3 = perlin_noise(p_4, seed_6);
            return _e3;
        }
        case 2u: {
            float _e4 = simplex_noise(p_4, seed_6);
            return _e4;
        }
        case 3u: {
            float _e5 = worley_noise(p_4, seed_6);
            return _e5;
        }
        default: {
            float _e6 = value_noise(p_4, seed_6);
            return _e6;
        }
    }
}

float fractal_noise(uint kind_1, vec3 p_5, int octaves, float roughness_1, int seed_7, float w) {
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_3 = 0;
    float octave = 0.0;
    float mean = ((kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5);
    float _e11 = bounded(roughness_1);
    float gain = clamp(_e11, 0.0, 1.0);
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e75 = i_3;
            i_3 = (_e75 + 1);
        }
        loop_init_3 = false;
        int _e25 = i_3;
        if ((_e25 < min(max(octaves, 1), 8))) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            float _e34 = eased((w * _e30), 0.5, 1.0);
            float visible = (1.0 - _e34);
            octave = mean;
            if ((visible > 0.0)) {
                float _e40 = frequency;
                int _e42 = i_3;
                vec3 place = clamp(((p_5 * _e40) + (float(_e42) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
                int _e56 = i_3;
                float _e59 = noise_octave(kind_1, place, (uint(seed_7) + uint(_e56)));
                octave = mix(mean, _e59, visible);
            }
            float _e61 = sum_3;
            float _e62 = strength;
            float _e63 = octave;
            sum_3 = (_e61 + (_e62 * _e63));
            float _e66 = total;
            float _e67 = strength;
            total = (_e66 + _e67);
            float _e69 = strength;
            strength = (_e69 * gain);
            float _e71 = frequency;
            frequency = (_e71 * 2.0);
        }
    }
    float _e77 = sum_3;
    float _e78 = total;
    return clamp((_e77 / _e78), 0.0, 1.0);
}

float fresnel(float at_normal_1, vec3 normal_2, vec3 view_2) {
    vec3 _e7 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    float cosine_2 = clamp(dot(_e7, view_2), 0.0, 1.0);
    float _e13 = factor_of(at_normal_1, true);
    float _e14 = schlick(_e13, cosine_2);
    return _e14;
}

float reflectance_blinn_phong(Light light_2, vec3 normal_3, vec3 view_3, float roughness_2) {
    vec3 _e9 = normalize_or(normal_3, vec3(0.0, 0.0, 1.0));
    Reflection _e10 = reflection_of(light_2.direction, _e9, view_3);
    float _e11 = width_of_roughness(roughness_2);
    float _e12 = exponent_of_width(_e11);
    float _e15 = cosine_power(_e10.n_h, _e10.sine2_, _e12);
    return min((((0.125 * (_e12 + 8.0)) * _e15) * max(_e10.n_l, 0.0)), 1000000.0);
}

vec4 thin_film(float thickness, float index, vec3 normal_4, vec3 view_4) {
    vec3 _e8 = normalize_or(normal_4, vec3(0.0, 0.0, 1.0));
    float cosine_3 = clamp(dot(_e8, view_4), 0.0, 1.0);
    float _e13 = bounded(index);
    float n_1 = clamp(_e13, 1.0, 3.0);
    float inside = sqrt((((n_1 - 1.0) * (n_1 + 1.0)) + (cosine_3 * cosine_3)));
    float _e25 = bounded(thickness);
    float path_1 = ((2.0 * clamp(_e25, 0.0, 2000.0)) * inside);
    float _e33 = interference(path_1, 650.0);
    float _e35 = interference(path_1, 532.0);
    float _e37 = interference(path_1, 450.0);
    return vec4(_e33, _e35, _e37, 1.0);
}

float map_range(float value, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_4) {
    float _e6 = remapped(value, from_low_1, from_high_1, to_low_1, to_high_1, clamped_4);
    return _e6;
}

float noise_perlin(vec3 position, float scale, int octaves_1, float roughness_3, int seed_8) {
    vec3 _e6 = bounded_vec3_((position * scale));
    float _e8 = footprint_of_vec3_(_e6);
    float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_3, seed_8, _e8);
    return _e9;
}

vec4 shade(Surface surface_1) {
    vec3 _e2 = position_object(surface_1.position_object);
    float _e7 = noise_perlin(_e2, 1.3, 2, 0.5, 0);
    float _e13 = map_range(_e7, 0.0, 1.0, 180.0, 420.0, true);
    vec4 _e17 = thin_film(_e13, 1.33, surface_1.normal, surface_1.view);
    float _e21 = fresnel(0.45, surface_1.normal, surface_1.view);
    vec4 _e29 = blend_add(vec4(0.0784, 0.0863, 0.1216, 1.0), _e17, _e21, 1.0, true);
    Light _e32 = u_look.key;
    float _e36 = reflectance_blinn_phong(_e32, surface_1.normal, surface_1.view, 0.22);
    vec4 _e41 = blend_add(_e29, vec4(1.0), _e36, 0.2, true);
    vec4 _e42 = output_(_e41);
    return _e42;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_5 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_5;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    Surface _e36 = surface;
    vec4 _e37 = shade(_e36);
    vec4 _e38 = finite_vec4_(_e37);
    out_color = _e38;
    return;
}

