#version 450 core
// Hatching: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// hatching.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
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
    Light key;
    vec2 viewport;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    vec3 curvature_tensor;
    float magnification;
    mat3x3 world_from_normal;
};
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct Strokes {
    float width;
    float length_;
    float taper;
    float wobble;
    float pressure;
    float variation;
    uint seed;
};
struct Stroke {
    float turn;
    float profile;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
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
    float square_1 = dot(scaled, scaled);
    bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square_1)));
}

float power_of_two(int n) {
    return uintBitsToFloat((uint((n + 127)) << 23u));
}

float exp2_stable(float x_2) {
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole_1 = roundEven(clamped_3);
    float f = ((clamped_3 - whole_1) * LN_2_);
    float p_1 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole_1) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole_1) - half_whole));
    return ((p_1 * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift >= 256) ? (shift - 512) : shift);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
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

vec2 bounded_vec2_(vec2 v_3) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return vec2(_e2, _e4);
}

vec3 bounded_vec3_(vec3 v_4) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return vec3(_e2, _e4, _e6);
}

vec4 bounded_vec4_(vec4 v_5) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
    return vec4(_e2, _e4, _e6, _e8);
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
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
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
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

float footprint_of(float x_12) {
    float _e1 = dFdx(x_12);
    float _e2 = dFdy(x_12);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_13, float edge, float w_1) {
    float _e4 = bounded((x_13 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

vec4 premultiplied(vec4 color) {
    return vec4((color.xyz * color.w), color.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 mix_colors_normal(vec4 a_4, vec4 b_4, float factor) {
    vec4 _e3 = bounded_vec4_(a_4);
    vec4 _e4 = bounded_vec4_(b_4);
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

float facing(vec3 normal, vec3 view) {
    vec3 _e4 = normalize_or(normal, vec3(0.0));
    return clamp(dot(_e4, view), 0.0, 1.0);
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 _e6 = normalize_or(toward, vec3(0.0, 0.0, 1.0));
    vec3 _e11 = normalize_or(up, vec3(0.0, 1.0, 0.0));
    vec3 leaning = cross(_e11, _e6);
    float square_2 = dot(leaning, leaning);
    vec3 aside = ((abs(_e6.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across_2 = ((square_2 > 1e-8) ? leaning : cross(aside, _e6));
    vec3 _e38 = normalize_or((across_2 - (dot(across_2, _e6) * _e6)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e38, cross(_e6, _e38), _e6);
}

float combine_tones_union(float a_5, float b_5) {
    float _e3 = factor_of(a_5, true);
    float _e5 = factor_of(b_5, true);
    return max(_e3, _e5);
}

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
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

vec3 fade_quintic(vec3 t_3) {
    return (((t_3 * t_3) * t_3) * ((t_3 * ((t_3 * 6.0) - vec3(15.0))) + vec3(10.0)));
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
            ivec3 at_1 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at_1, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at_1), seed_2);
            vec3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float size_on_screen(float depth, float perspective, float scale) {
    float _e10 = bounded(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)));
    return _e10;
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 _e4 = sin_cos_of(angle);
    vec3 _e10 = bounded_vec3_(((_e4.y * along) + (_e4.x * across)));
    vec3 _e16 = bounded_vec3_(((_e4.y * across) - (_e4.x * along)));
    vec2 _e17 = bounded_vec2_(place);
    vec2 turned = vec2(((_e4.y * _e17.x) + (_e4.x * _e17.y)), ((_e4.y * _e17.y) - (_e4.x * _e17.x)));
    vec3 most = vec3(1000000000000000.0);
    vec3 stretch_2 = clamp(vec3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    vec2 _e41 = bounded_vec2_(turned);
    return StretchedPlace(_e41, stretch_2);
}

vec3 gradient_on_picture(vec3 g, vec3 normal_1, vec3 view_1) {
    float facing_2 = dot(normal_1, view_1);
    return (g - (normal_1 * (dot(g, view_1) / ((facing_2 >= 0.0) ? max(facing_2, 0.125) : min(facing_2, -0.125)))));
}

StretchedPlace place_on_surface(vec2 place_1, vec3 along_1, vec3 across_1, vec3 normal_2, vec3 view_2, float magnification, float angle_1) {
    vec3 _e11 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    vec3 _e16 = normalize_or(view_2, vec3(0.0, 0.0, 1.0));
    float _e17 = bounded(magnification);
    float height = (1.0 / clamp(_e17, 1e-15, 1000000000000000.0));
    vec3 _e23 = gradient_on_picture(along_1, _e11, _e16);
    vec3 _e25 = bounded_vec3_((_e23 * height));
    vec3 _e26 = gradient_on_picture(across_1, _e11, _e16);
    vec3 _e28 = bounded_vec3_((_e26 * height));
    vec2 _e29 = bounded_vec2_(place_1);
    StretchedPlace _e30 = mark_place_of(_e29, _e25, _e28, angle_1);
    return _e30;
}

StretchedPlace place_across(vec3 axis, vec3 position, mat3x3 world_from_normal, vec3 normal_3, vec3 view_3, float magnification_1, float angle_2) {
    mat3x3 _e11 = axes_around(axis, vec3(0.0, 1.0, 0.0));
    vec3 _e12 = bounded_vec3_(position);
    vec2 place_6 = vec2(dot(_e12, _e11[0]), dot(_e12, _e11[2]));
    vec3 _e20 = bounded_vec3_((world_from_normal * _e11[0]));
    vec3 _e23 = bounded_vec3_((world_from_normal * _e11[2]));
    StretchedPlace _e24 = place_on_surface(place_6, _e20, _e23, normal_3, view_3, magnification_1, angle_2);
    return _e24;
}

SpacedPlace spaced(vec2 place_2, vec3 stretch, vec2 viewport, float count) {
    float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_1 = (is_pixel ? (number / max(viewport.y, 1.0)) : number);
    vec2 _e19 = bounded_vec2_(place_2);
    vec2 _e21 = bounded_vec2_((_e19 * scale_1));
    vec2 p_2 = clamp(_e21, vec2(-4194304.0), vec2(4194304.0));
    vec3 _e27 = bounded_vec3_(stretch);
    vec3 s_1 = clamp(_e27, vec3(-1000000000000000.0), vec3(1000000000000000.0));
    return SpacedPlace(p_2, (is_pixel ? vec3(1.0, 0.0, 1.0) : s_1));
}

float octave_of(float square) {
    float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

Stroke stroke_at(ivec2 line, float x_14, int zoom, Strokes style) {
    uvec3 _e7 = lattice_hash(ivec3(line, 1048576), style.seed);
    vec3 _e8 = unit_of_hash(_e7);
    if ((style.length_ <= 0.0)) {
        return Stroke(_e8.y, 1.0);
    }
    float _e15 = power_of_two(zoom);
    float along_2 = (clamp(((x_14 * _e15) / style.length_), -1000000.0, 1000000.0) + _e8.x);
    float index = floor(along_2);
    uvec3 _e30 = lattice_hash(ivec3(line, int(index)), (style.seed + uint(zoom)));
    vec3 _e31 = unit_of_hash(_e30);
    float from_end = min((along_2 - index), (1.0 - (along_2 - index)));
    float slope = clamp((from_end / max((0.5 * style.taper), 1e-6)), 0.0, 1.0);
    return Stroke(_e31.x, (slope * (2.0 - slope)));
}

Stroke stroke_between(ivec2 line_1, float x_15, float level, Strokes style_1) {
    float zoom_2 = floor(level);
    Stroke _e6 = stroke_at(line_1, x_15, int(zoom_2), style_1);
    Stroke _e10 = stroke_at(line_1, x_15, (int(zoom_2) + 1), style_1);
    float f_1 = (level - zoom_2);
    return Stroke(mix(_e6.turn, _e10.turn, f_1), mix(_e6.profile, _e10.profile, f_1));
}

float stray_at(vec2 place_3, int zoom_1, uint seed_3) {
    float _e3 = power_of_two(zoom_1);
    vec2 p_3 = (place_3 * _e3);
    float _e13 = value_noise(vec3((0.11 * p_3.x), (0.45 * p_3.y), 0.5), seed_3);
    float _e19 = power_of_two(-(zoom_1));
    return (((_e13 - 0.5) * 2.0) * _e19);
}

float band_filtered(float t_4, float half_, float w_2) {
    bool local_2 = false;
    if ((w_2 < 1e-30)) {
        if ((abs(t_4) <= half_)) {
            local_2 = (half_ > 0.0);
        } else {
            local_2 = false;
        }
        bool _e12 = local_2;
        return (_e12 ? 1.0 : 0.0);
    }
    return clamp(((clamp((t_4 + (0.5 * w_2)), -(half_), half_) - clamp((t_4 - (0.5 * w_2)), -(half_), half_)) / w_2), 0.0, 1.0);
}

ivec2 line_of(int whole, int octave) {
    int power = ((whole == 0) ? 1 : (whole & -(whole)));
    int octaves = (int((floatBitsToUint(float(power)) >> 23u)) - 127);
    return ((whole == 0) ? ivec2(0) : ivec2((whole / power), (octave - octaves)));
}

float hatched(vec2 place_4, float w_3, float level_1, float ink, Strokes style_2) {
    if (!((ink > 0.0))) {
        return 0.0;
    }
    float _e12 = powered(ink, (1.0 - style_2.pressure));
    float _e15 = powered(ink, style_2.pressure);
    float width_1 = (style_2.width * _e15);
    float zoom_3 = floor(level_1);
    float _e20 = stray_at(place_4, int(zoom_3), style_2.seed);
    float _e25 = stray_at(place_4, (int(zoom_3) + 1), style_2.seed);
    float stray = mix(_e20, _e25, (level_1 - zoom_3));
    float across_3 = (place_4.y + (style_2.wobble * stray));
    float _e35 = log_stable(max(_e12, 1e-9));
    float density = clamp((level_1 + (LOG2_E * _e35)), -40.0, 17.0);
    float octave_1 = floor(density);
    float _e43 = exp2_stable((density - octave_1));
    float growth = (_e43 - 1.0);
    float _e47 = power_of_two(int(octave_1));
    float q = clamp((across_3 * _e47), -4194304.0, 4194304.0);
    float _e55 = exp2_stable((octave_1 - level_1));
    float half_1 = ((0.5 * width_1) * _e55);
    float footprint = (w_3 * _e47);
    int whole_2 = int(roundEven(q));
    ivec2 _e61 = line_of(whole_2, int(octave_1));
    Stroke _e63 = stroke_between(_e61, place_4.x, level_1, style_2);
    float middle = floor(q);
    Stroke _e75 = stroke_between(ivec2(((2 * int(middle)) + 1), (int(octave_1) + 1)), place_4.x, level_1, style_2);
    float late = (0.75 * style_2.variation);
    float grown = clamp(((growth - (late * _e75.turn)) / (1.0 - late)), 0.0, 1.0);
    float _e92 = band_filtered((q - float(whole_2)), (half_1 * _e63.profile), footprint);
    float _e99 = band_filtered(((q - middle) - 0.5), ((half_1 * grown) * _e75.profile), footprint);
    float mean_1 = min(((2.0 * half_1) * (1.0 + growth)), 1.0);
    float _e110 = eased(footprint, 0.75, 1.5);
    return mix(max(_e92, _e99), mean_1, _e110);
}

float cross_hatched(SpacedPlace at, float ink_1, int layers, float cross_, Strokes style_3) {
    float free = 1.0;
    int i_1 = 0;
    Strokes own = Strokes(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0u);
    vec2 x_17 = dFdx(at.place);
    vec2 y = dFdy(at.place);
    int count_2 = min(max(layers, 1), 4);
    float _e12 = bounded(ink_1);
    float amount = (clamp(_e12, 0.0, 1.0) * float(count_2));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e90 = i_1;
            i_1 = (_e90 + 1);
        }
        loop_init_1 = false;
        int _e22 = i_1;
        if ((_e22 < 4)) {
        } else {
            break;
        }
        {
            int _e25 = i_1;
            if ((_e25 < count_2)) {
                int _e27 = i_1;
                vec2 _e30 = sin_cos_of((float(_e27) * cross_));
                vec2 along_3 = vec2(_e30.y, _e30.x);
                vec2 across_4 = vec2(-(_e30.x), _e30.y);
                float _e42 = bounded(length(vec2(dot(across_4, x_17), dot(across_4, y))));
                vec3 s_2 = at.stretch;
                float square_3 = dot(vec3((across_4.x * across_4.x), ((2.0 * across_4.x) * across_4.y), (across_4.y * across_4.y)), s_2);
                float _e63 = octave_of(max(square_3, ((s_2.x + s_2.z) / 65.0)));
                vec2 place_7 = vec2(dot(along_3, at.place), dot(across_4, at.place));
                own = style_3;
                int _e73 = i_1;
                own.seed = (style_3.seed + (101u * uint(_e73)));
                float _e77 = free;
                int _e78 = i_1;
                Strokes _e84 = own;
                float _e85 = hatched(place_7, _e42, _e63, clamp((amount - float(_e78)), 0.0, 1.0), _e84);
                free = (_e77 * (1.0 - _e85));
            }
        }
    }
    float _e92 = free;
    return (1.0 - _e92);
}

float hatching(float value, vec2 place_5, vec3 stretch_1, float count_1, float width, int layers_1, float cross_1, float length_, float taper, float wobble, float pressure, float variation, int seed_4, vec2 viewport_1) {
    float _e14 = bounded(width);
    float _e18 = bounded(length_);
    float _e22 = bounded(taper);
    float _e26 = bounded(wobble);
    float _e30 = bounded(pressure);
    float _e34 = bounded(variation);
    Strokes style_4 = Strokes(clamp(_e14, 0.0, 1.0), clamp(_e18, 0.0, 10000.0), clamp(_e22, 0.0, 1.0), clamp(_e26, 0.0, 100.0), clamp(_e30, 0.0, 1.0), clamp(_e34, 0.0, 1.0), uint(seed_4));
    SpacedPlace _e40 = spaced(place_5, stretch_1, viewport_1, count_1);
    float _e42 = factor_of(value, true);
    float _e45 = cross_hatched(_e40, (1.0 - _e42), layers_1, cross_1, style_4);
    return _e45;
}

MarkPlace mark_place_light(Light light, vec3 normal_4, float angle_3, vec3 view_4, vec3 position_object, mat3x3 world_from_normal_1, float magnification_2) {
    vec3 toward_1 = (light.direction * world_from_normal_1);
    StretchedPlace _e9 = place_across(toward_1, position_object, world_from_normal_1, normal_4, view_4, magnification_2, angle_3);
    return MarkPlace(_e9.place, _e9.stretch);
}

float reflectance_wrap(Light light_1, vec3 normal_5, float wrap) {
    float _e3 = bounded(wrap);
    float w_4 = clamp(_e3, 0.0, 1.0);
    vec3 _e11 = normalize_or(normal_5, vec3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light_1.direction);
    return max(((cosine + w_4) / (1.0 + w_4)), 0.0);
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float smooth_step_value(float value_2, float low_2, float high_2) {
    float _e3 = eased(value_2, low_2, high_2);
    return _e3;
}

float seen_well(float facing_1) {
    float _e3 = eased(facing_1, 0.05, 0.3);
    return _e3;
}

float faded_in(float x_16, float limit, float softness_1) {
    float _e3 = bounded(limit);
    float at_2 = max(_e3, 0.0);
    float _e6 = footprint_of(x_16);
    float _e10 = factor_of(softness_1, true);
    float _e12 = edge_width(_e6, (min(at_2, 1000000000.0) * _e10));
    float _e13 = bounded(x_16);
    float _e14 = step_filtered(_e13, at_2, _e12);
    return _e14;
}

float inner_contour_valleys(float limit_1, float softness_2, vec3 tensor_2, vec3 normal_6, vec3 view_5) {
    vec3 _e5 = tensor_safe(tensor_2);
    vec2 _e6 = principal_curvatures(_e5);
    float least = _e6.y;
    float _e9 = faded_in(-(least), limit_1, softness_2);
    float _e11 = seen_well(dot(normal_6, view_5));
    return (_e9 * _e11);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.35);
    float _e12 = map_range(_e6, 0.0, 0.85, 0.04, 1.0, true);
    Light _e15 = u_look.key;
    MarkPlace _e22 = mark_place_light(_e15, surface_1.normal, 0.0, surface_1.view, surface_1.position_object, surface_1.world_from_normal, surface_1.magnification);
    vec2 _e37 = u_look.viewport;
    float _e38 = hatching(_e12, _e22.place, _e22.stretch, 120.0, 0.42, 3, 0.8, 24.0, 0.6, 0.45, 0.25, 1.0, 4, _e37);
    float _e41 = facing(surface_1.normal, surface_1.view);
    float _e44 = smooth_step_value(_e41, 0.34, 0.2);
    float _e45 = combine_tones_union(_e38, _e44);
    float _e51 = inner_contour_valleys(75.0, 0.3, surface_1.curvature_tensor, surface_1.normal, surface_1.view);
    float _e52 = combine_tones_union(_e45, _e51);
    vec4 _e63 = mix_colors_normal(vec4(0.965, 0.937, 0.875, 1.0), vec4(0.12, 0.105, 0.16, 1.0), _e52);
    vec4 _e64 = premultiplied(_e63);
    vec4 _e65 = output_(_e64);
    return _e65;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0, mat3x3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_7 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_7;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    vec4 _e42 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    surface.curvature_tensor = _e42.xyz;
    mat4x4 _e47 = u_view.camera_from_world;
    float _e57 = u_view.eye.w;
    float _e62 = u_view.clip_from_world[0][1];
    float _e67 = u_view.clip_from_world[1][1];
    float _e72 = u_view.clip_from_world[2][1];
    float _e75 = size_on_screen(-((_e47 * vec4(in_.position, 1.0)).z), _e57, length(vec3(_e62, _e67, _e72)));
    surface.magnification = _e75;
    mat3x3 _e79 = u_object.world_from_normal;
    surface.world_from_normal = _e79;
    Surface _e80 = surface;
    vec4 _e81 = shade(_e80);
    vec4 _e82 = finite_vec4_(_e81);
    out_color = _e82;
    return;
}

