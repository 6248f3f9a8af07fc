#version 450 core
// Iridescent film: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// material-film.json says what to put there and how to draw.
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
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const uint NOISE_PERLIN = 1u;

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float clamped_1 = max(x, -126.0);
    float whole = roundEven(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float log2_stable(float x_1) {
    uint bits = floatBitsToUint(x_1);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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
    float _e7 = log2_stable((1.0 - y_1));
    return (LN_2_ * _e7);
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

float footprint_of_vec3_(vec3 v_2) {
    vec3 dx = dFdx(v_2);
    vec3 dy = dFdy(v_2);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

vec4 blend_add(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (opacity * ((below.xyz + (tone * vec3(1.0))) - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

vec3 half_of(vec3 light, vec3 normal, vec3 view) {
    vec3 half_ = (light + view);
    vec3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(vec3 a, vec3 b) {
    vec3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

Reflection reflection_of(vec3 light_1, vec3 normal_1, vec3 view_1) {
    vec3 _e3 = half_of(light_1, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection(dot(normal_1, light_1), dot(normal_1, view_1), n_h, v_h, _e14);
}

float cosine_power(float cosine, float sine2_, float exponent) {
    if ((cosine < 0.7)) {
        return 0.0;
    }
    float _e12 = log1p_negative(min(sine2_, 0.6));
    float _e14 = exp2_stable((((0.5 * exponent) * LOG2_E) * _e12));
    return _e14;
}

float schlick(float at_normal, float cosine_1) {
    float m = (1.0 - cosine_1);
    float m2_ = (m * m);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m)));
}

float interference(float path, float wavelength) {
    float x_2 = ((PI * path) / wavelength);
    vec2 half_1 = vec2(sin(x_2), cos(x_2));
    return (half_1.x * half_1.x);
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
    float a_1 = ((axis == 0u) ? d.y : d.x);
    float b_1 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_1 : -(a_1)) + (((hash.z >> 31u) == 0u) ? b_1 : -(b_1)));
}

vec3 fade_quintic(vec3 t) {
    return (((t * t) * t) * ((t * ((t * 6.0) - vec3(15.0))) + vec3(10.0)));
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

float fractal_noise(uint kind, vec3 p_1, int octaves, float roughness, int seed_3, float w) {
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
        float visible = (1.0 - smoothstep(0.5, 1.0, (w * _e21)));
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            vec3 place = clamp(((p_1 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place, (0u + uint(_e47)));
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

float reflectance_blinn_phong(Light light_2, vec3 normal_2, vec3 view_2, float roughness_1) {
    Reflection _e5 = reflection_of(light_2.direction, normal_2, view_2);
    float width = (roughness_1 * roughness_1);
    float e = ((2.0 / (width * width)) - 2.0);
    float _e14 = cosine_power(_e5.n_h, _e5.sine2_, e);
    return (((0.125 * (e + 8.0)) * _e14) * max(_e5.n_l, 0.0));
}

vec4 thin_film(float thickness, float index, vec3 normal_3, vec3 view_3) {
    float cosine_2 = clamp(dot(normal_3, view_3), 0.0, 1.0);
    float inside = sqrt((((index - 1.0) * (index + 1.0)) + (cosine_2 * cosine_2)));
    float path_1 = ((2.0 * thickness) * inside);
    float _e20 = interference(path_1, 650.0);
    float _e22 = interference(path_1, 532.0);
    float _e24 = interference(path_1, 450.0);
    return vec4(_e20, _e22, _e24, 1.0);
}

float noise_perlin(vec3 position, float scale, int octaves_1, float roughness_2, int seed_4) {
    vec3 p_2 = (position * scale);
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_2, seed_4, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    float _e6 = noise_perlin(surface.position_object, 1.3, 2, 0.5, 0);
    float thickness_1 = mix(180.0, 420.0, (_e6 - 0.0));
    vec4 _e15 = thin_film(thickness_1, 1.33, surface.normal, surface.view);
    float _e23 = schlick(0.45, clamp(dot(surface.normal, surface.view), 0.0, 1.0));
    vec4 film_2_ = min(vec4((vec3(0.0784, 0.0863, 0.1216) + (_e23 * _e15.xyz)), 1.0), vec4(1.0));
    Light _e38 = u_look.key;
    float _e42 = reflectance_blinn_phong(_e38, surface.normal, surface.view, 0.22);
    vec4 _e47 = blend_add(film_2_, vec4(1.0), _e42, 0.2, true);
    return _e47;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_4 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    Surface surface_1 = Surface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object);
    vec4 _e20 = shade(surface_1);
    out_color = _e20;
    return;
}

