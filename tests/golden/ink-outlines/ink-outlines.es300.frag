#version 300 es
// Ink outlines: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0, u_line_nearness_map 1, u_facet_map 2.
// ink-outlines.json says what to put there and how to draw.

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
    mat3x3 camera_from_world;
    vec2 viewport;
    Light key;
    float object_id;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    vec3 position_camera;
    float depth;
    vec3 curvature_tensor;
    vec4 line_nearness;
    vec2 middle_surface;
    float magnification;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct Outline {
    float line;
    float kind;
    float distance_;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
const uint NOISE_PERLIN = 1u;
const float MOST_ON_SCREEN = 1000000000000000.0;
const Ramp three_washes = Ramp(vec4[16](vec4(0.4353, 0.5255, 0.6588, 1.0), vec4(0.7882, 0.6471, 0.549, 1.0), vec4(0.949, 0.851, 0.6941, 1.0), vec4(1.0, 0.9647, 0.8784, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.36, 0.54, 0.93), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 2u);
const Ramp ink = Ramp(vec4[16](vec4(0.0784, 0.102, 0.2, 1.0), vec4(0.3529, 0.1647, 0.1098, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.1, 0.85, 0.0, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 2u, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_tensor_map;

uniform highp sampler2D u_line_nearness_map;

uniform highp sampler2D u_facet_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent), exponent));
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

vec4 bounded_vec4_(vec4 v_2) {
    uvec4 bits_1 = floatBitsToUint(v_2);
    uvec4 magnitude_1 = (bits_1 & uvec4(2147483647u));
    vec4 largest_1 = uintBitsToFloat(((bits_1 & uvec4(2147483648u)) | uvec4(2139095039u)));
    vec4 numbers = mix(vec4(0.0), largest_1, equal(magnitude_1, uvec4(2139095040u)));
    return mix(numbers, v_2, lessThan(magnitude_1, uvec4(2139095040u)));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

vec4 mixed_vec4_(vec4 a_1, vec4 b_1, float t) {
    vec4 _e4 = bounded_vec4_((b_1 - a_1));
    vec4 _e14 = bounded_vec4_(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

float eased(float x_1, float low, float high) {
    float _e3 = bounded(x_1);
    float _e7 = bounded(((_e3 - low) / 0.5));
    float t_3 = clamp(_e7, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float footprint_of_2_(float x_3) {
    float _e1 = dFdx(x_3);
    float _e2 = dFdy(x_3);
    vec2 d_2 = vec2(_e1, _e2);
    return sqrt(dot(d_2, d_2));
}

float footprint_of_vec3_(vec3 v_3) {
    vec3 dx = dFdx(v_3);
    vec3 dy = dFdy(v_3);
    float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

float step_filtered(float x_4, float edge, float w) {
    float _e4 = bounded((x_4 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float step_filtered_2_(float x_5, float edge_1, float w_1) {
    float d_3 = (x_5 - edge_1);
    return ((w_1 < 1e-30) ? ((d_3 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_3 / w_1)), 0.0, 1.0));
}

vec4 hermite(vec4 a_2, vec4 b_2, vec4 from_a, vec4 to_b, float t_1) {
    vec4 d_4 = (b_2 - a_2);
    return (a_2 + (t_1 * (from_a + (t_1 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_1 * ((from_a + to_b) - (2.0 * d_4))))))));
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

vec4 ramp_at(Ramp ramp, float x_6, float w_2) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color = vec4(0.0);
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
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
                float _e43 = step_filtered(x_6, _e42, w_2);
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
            at = ((_e67 <= x_6) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places[(_e73 / 4u)][(_e77 % 4u)];
    uint _e82 = at;
    if ((((_e82 + 1u) >= count) || (x_6 <= place_1))) {
        uint _e88 = at;
        vec4 _e90 = colors[_e88];
        vec4 _e91 = bounded_vec4_(_e90);
        return _e91;
    }
    uint _e92 = at;
    uint after_1 = (_e92 + 1u);
    float _e101 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span = (_e101 - place_1);
    float _e104 = divided((x_6 - place_1), span);
    float t_4 = clamp(_e104, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e111 = at;
        vec4 _e113 = colors[_e111];
        vec4 _e115 = colors[after_1];
        vec4 _e116 = mixed_vec4_(_e113, _e115, t_4);
        return _e116;
    }
    uint _e123 = at;
    if ((_e123 > 0u)) {
        uint _e126 = at;
        uint _e132 = at;
        float before_1 = places[((_e126 - 1u) / 4u)][((_e132 - 1u) % 4u)];
        uint _e139 = at;
        vec4 _e141 = colors[_e139];
        uint _e142 = at;
        vec4 _e146 = colors[(_e142 - 1u)];
        vec4 _e150 = colors[after_1];
        uint _e151 = at;
        vec4 _e153 = colors[_e151];
        vec4 _e155 = ramp_slope((_e141 - _e146), (place_1 - before_1), (_e150 - _e153), span);
        from_a_1 = _e155;
    }
    if (((after_1 + 1u) < count)) {
        float _e169 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e169 - (place_1 + span));
        vec4 _e173 = colors[after_1];
        uint _e174 = at;
        vec4 _e176 = colors[_e174];
        vec4 _e181 = colors[(after_1 + 1u)];
        vec4 _e183 = colors[after_1];
        vec4 _e185 = ramp_slope((_e173 - _e176), span, (_e181 - _e183), next);
        to_b_1 = _e185;
    }
    uint _e186 = at;
    vec4 _e188 = colors[_e186];
    vec4 _e190 = colors[after_1];
    vec4 _e191 = from_a_1;
    vec4 _e193 = to_b_1;
    vec4 _e195 = hermite(_e188, _e190, (span * _e191), (span * _e193), t_4);
    vec4 _e196 = bounded_vec4_(_e195);
    return _e196;
}

vec4 ramp_at_2_(Ramp ramp_1, float x_7, float w_3) {
    vec4 colors_1[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places_1[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color_1 = vec4(0.0);
    uint i_2 = 1u;
    colors_1 = ramp_1.colors;
    places_1 = ramp_1.places;
    vec4 _e8 = colors_1[0];
    color_1 = _e8;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e35 = i_2;
            i_2 = (_e35 + 1u);
        }
        loop_init_2 = false;
        uint _e12 = i_2;
        if (!((_e12 < 4u))) {
            break;
        }
        vec4 _e16 = color_1;
        uint _e17 = i_2;
        vec4 _e19 = colors_1[_e17];
        uint _e20 = i_2;
        vec4 _e24 = colors_1[(_e20 - 1u)];
        uint _e27 = i_2;
        float _e31 = places_1[0][(_e27 % 4u)];
        float _e32 = step_filtered_2_(x_7, _e31, w_3);
        color_1 = (_e16 + ((_e19 - _e24) * _e32));
    }
    vec4 _e38 = color_1;
    return _e38;
}

vec4 premultiplied(vec4 color_2) {
    return vec4((color_2.xyz * color_2.w), color_2.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 output_(vec4 color_3) {
    vec4 _e1 = straight(color_3);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
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
    float a_3 = ((axis == 0u) ? d.y : d.x);
    float b_3 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_3 : -(a_3)) + (((hash.z >> 31u) == 0u) ? b_3 : -(b_3)));
}

vec3 fade_quintic(vec3 t_2) {
    return (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i_3 = 0;
    vec3 corner = floor(p);
    vec3 d_5 = (p - corner);
    vec3 _e4 = fade_quintic(d_5);
    ivec3 cell_1 = ivec3(corner);
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = (_e46 + 1);
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            ivec3 at_1 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at_1, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at_1), seed_2);
            float _e42 = gradient_dot(_e39, (d_5 - vec3(at_1)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, vec3 p_1, int octaves, float roughness, int seed_3, float w_4) {
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
        float _e25 = eased((w_4 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_4;
            vec3 place_2 = clamp(((p_1 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
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

float size_on_screen(float depth, float perspective, float scale) {
    return min(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

float reflectance_half_lambert(Light light, vec3 normal) {
    float half_ = (0.5 + (0.5 * dot(normal, light.direction)));
    return min((half_ * half_), 1.0);
}

float inner_contour_suggestive(float width, float limit, float softness, vec3 tensor, vec3 normal_1, vec3 view, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n = (camera_from_world * normal_1);
    float square = dot(n.xy, n.xy);
    float radial = (((((tensor.x * n.x) * n.x) + (((2.0 * tensor.y) * n.x) * n.y)) + ((tensor.z * n.y) * n.y)) / max(square, 1e-6));
    float _e35 = dFdx(radial);
    float _e36 = dFdy(radial);
    vec2 change = vec2(_e35, _e36);
    vec3 v_5 = (camera_from_world * view);
    vec3 row = dFdy(place);
    float up = (((row - (dot(row, v_5) * v_5)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * inversesqrt(max(square, 1e-6)));
    float pixels_1 = (((0.5 * width) * height) / 1000.0);
    float distance_2 = (abs(radial) / max(length(change), 1e-6));
    float x_8 = ((toward_eye * height) * 0.05);
    float _e80 = footprint_of(x_8);
    float strength_1 = clamp((0.5 + ((x_8 - limit) / length(vec2(min(_e80, 1000000000000000.0), 24.0)))), 0.0, 1.0);
    return ((clamp(((pixels_1 + 0.5) - distance_2), 0.0, min(pixels_1, 1.0)) * strength_1) * smoothstep(0.05, 0.3, dot(normal_1, view)));
}

vec4 own_nearness(vec4 nearness, vec2 middle, float depth_1, float object, float pixels, float reach) {
    bool local = false;
    bool local_1 = false;
    bool is_same_object = (middle.y == (object + 1.0));
    float behind = ((depth_1 - middle.x) * pixels);
    if (!((middle.y == 0.0))) {
        if (is_same_object) {
            local_1 = (abs(behind) <= 8.0);
        } else {
            local_1 = false;
        }
        bool _e25 = local_1;
        local = _e25;
    } else {
        local = true;
    }
    bool is_own = local;
    bool is_in_front = (behind < (is_same_object ? -8.0 : -2.0));
    vec4 other = vec4((is_in_front ? reach : 0.0), 0.0, nearness.z, 0.0);
    return (is_own ? nearness : other);
}

vec4 line_widths(float width_1, vec4 shares) {
    vec4 widths_2 = (min(width_1, 10000.0) * shares);
    return mix(vec4(0.0), widths_2, greaterThan(widths_2, vec4(1e-6)));
}

float inner_line_covers(float distance_, float width_2) {
    return clamp(((width_2 + 0.5) - distance_), 0.0, min(width_2, 1.0));
}

vec3 middle_line_covers(vec3 distance_1, vec3 width_3) {
    vec3 half_1 = (0.5 * width_3);
    return clamp((min((distance_1 + vec3(0.5)), half_1) - max((distance_1 - vec3(0.5)), -(half_1))), vec3(0.0), vec3(1.0));
}

vec4 lines_cover(vec4 nearness_1, vec4 widths, float reach_1) {
    vec4 distance_3 = (vec4(reach_1) - nearness_1);
    float _e7 = inner_line_covers(distance_3.x, widths.x);
    vec3 _e10 = middle_line_covers(distance_3.yzw, widths.yzw);
    vec4 covers = vec4(_e7, _e10);
    return mix(vec4(0.0), covers, greaterThan(nearness_1, vec4(0.0)));
}

Outline drawn_outline(vec4 widths_1, vec4 of_edges, float reach_2) {
    float kind_1 = 0.0;
    vec4 nearness_3 = clamp(of_edges, vec4(0.0), vec4(reach_2));
    vec4 _e7 = lines_cover(nearness_3, widths_1, reach_2);
    float line = max(max(_e7.x, _e7.y), max(_e7.z, _e7.w));
    kind_1 = ((_e7.z == line) ? 3.0 : 4.0);
    float _e21 = kind_1;
    kind_1 = ((_e7.y == line) ? 2.0 : _e21);
    float _e26 = kind_1;
    kind_1 = ((_e7.x == line) ? 1.0 : _e26);
    vec4 near = mix(vec4(0.0), nearness_3, greaterThan(widths_1, vec4(0.0)));
    float nearest = max(max(near.x, near.y), max(near.z, near.w));
    float _e44 = kind_1;
    return Outline(line, ((line > 0.001) ? _e44 : 0.0), (reach_2 - nearest));
}

Outline outline_height(float width_4, float silhouettes, float creases, float borders, float look_borders, vec4 nearness_2, vec2 middle_1, float depth_2, float object_1, vec2 viewport_1, float magnification) {
    float pixels_2 = (magnification * viewport_1.y);
    float reach_3 = min((16.0 * max(roundEven((viewport_1.y / 800.0)), 1.0)), 31.0);
    vec4 _e23 = own_nearness(nearness_2, middle_1, depth_2, object_1, pixels_2, reach_3);
    vec4 shares_1 = vec4(silhouettes, creases, borders, look_borders);
    vec4 _e29 = line_widths((width_4 * (0.001 * viewport_1.y)), shares_1);
    Outline _e30 = drawn_outline(_e29, _e23, reach_3);
    return _e30;
}

float noise_perlin(vec3 position, float scale_1, int octaves_1, float roughness_1, int seed_4) {
    vec3 p_2 = (position * scale_1);
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    Light _e3 = u_look.key;
    float _e5 = reflectance_half_lambert(_e3, surface.normal);
    float _e7 = footprint_of_2_(_e5);
    vec4 _e8 = ramp_at_2_(three_washes, _e5, _e7);
    float _e10 = footprint_of_2_(_e5);
    vec4 _e11 = ramp_at(ink, _e5, _e10);
    float heavy_in_the_shade = mix(1.6, 8.0, clamp(((_e5 - 0.75) / -0.6), 0.0, 1.0));
    float _e27 = noise_perlin(surface.position_object, 3.5, 2, 0.5, 0);
    float pressure = mix(0.7, 1.3, (_e27 - 0.0));
    float width_5 = (heavy_in_the_shade * pressure);
    float _e43 = u_look.object_id;
    vec2 _e46 = u_look.viewport;
    Outline _e48 = outline_height(width_5, 1.0, 0.6, 1.0, 0.6, surface.line_nearness, surface.middle_surface, surface.depth, _e43, _e46, surface.magnification);
    mat3x3 _e57 = u_look.camera_from_world;
    vec2 _e61 = u_look.viewport;
    float _e62 = inner_contour_suggestive(2.2, 24.0, 1.0, surface.curvature_tensor, surface.normal, surface.view, _e57, surface.position_camera, _e61);
    float all_strokes = max(_e48.line, _e62);
    vec4 _e65 = bounded_vec4_(_e11);
    vec4 _e66 = mixed_vec4_(_e8, _e65, all_strokes);
    vec4 output_alpha = vec4(_e66.xyz, clamp(_e66.w, 0.0, 1.0));
    vec4 _e73 = premultiplied(output_alpha);
    vec4 _e74 = output_(_e73);
    return _e74;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_2 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    mat4x4 _e21 = u_view.camera_from_world;
    mat4x4 _e29 = u_view.camera_from_world;
    vec4 _e41 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    vec4 _e48 = texelFetch(u_line_nearness_map, ivec2(in_.clip.xy), 0);
    vec4 _e54 = texelFetch(u_facet_map, ivec2(in_.clip.xy), 0);
    vec4 _e61 = texelFetch(u_facet_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e68 = u_view.camera_from_world;
    float _e78 = u_view.eye.w;
    float _e83 = u_view.clip_from_world[0][1];
    float _e88 = u_view.clip_from_world[1][1];
    float _e93 = u_view.clip_from_world[2][1];
    float _e96 = size_on_screen(-((_e68 * vec4(in_.position, 1.0)).z), _e78, length(vec3(_e83, _e88, _e93)));
    Surface surface_1 = Surface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, (_e21 * vec4(in_.position, 1.0)).xyz, -((_e29 * vec4(in_.position, 1.0)).z), _e41.xyz, _e48, vec2(_e54.z, floor(abs(_e61.w))), _e96);
    vec4 _e98 = shade(surface_1);
    vec4 _e99 = finite_vec4_(_e98);
    out_color = _e99;
    return;
}

