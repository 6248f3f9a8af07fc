#version 450 core
// Pencil: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_image_1 0.
// hcbtf-pencil.json says what to put there and how to draw.
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
    vec2 uv;
    vec3 tangent;
    vec3 bitangent;
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
struct HcbtfGrid {
    ivec2 size;
    ivec2 light;
    ivec2 view;
    bool has_levels;
    bool is_decoded;
};
struct HcbtfPlace {
    ivec2 theta;
    ivec2 phi;
    vec2 weight;
};
struct HcbtfViews {
    ivec4 layer;
    vec4 weight;
};
struct HcbtfTexels {
    ivec4 at;
    vec2 weight;
    ivec2 origin;
};
struct HcbtfBlocks {
    ivec2 left_top;
    ivec2 right_top;
    ivec2 left_bottom;
    ivec2 right_bottom;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
    vec4 tangent;
    vec2 uv;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const ProfileShape tone_shape = ProfileShape(1.0, 0.0, 1.1220733, 1.5951413, 0.0, 1.1173698, 0.4896476, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2DArray u_image_1;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 2) smooth in vec4 v_tangent;
layout(location = 3) smooth in vec2 v_uv;
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
    float clamped = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped);
    float f = ((clamped - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift_2 >= 256) ? (shift_2 - 512) : shift_2);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_quarter(float x_4) {
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

Angle angle_between(vec3 d, vec3 l) {
    float p_1 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_1 * p_1) + (s_1 * s_1)), 1e-30)));
    return Angle((p_1 * k), (s_1 * k));
}

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a) : a);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, vec2 t) {
    bool local_1 = false;
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_1 = (s_2 < c_1);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    vec2 turned = (_e32 ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_shifted(Angle u_2, float shift) {
    vec2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    Angle _e8 = angle_turned(u_2, _e7);
    return _e8;
}

float angle_footprint(Angle u_3) {
    vec2 half_ = vec2(u_3.half_sin, u_3.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_2, 0.5);
    return min(_e13, 0.5);
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

float length_of(vec3 v_6) {
    vec3 _e1 = bounded_vec3_(v_6);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e17 = bounded((largest_2 * length((_e1 / vec3(largest_2)))));
    return _e17;
}

float angle_of_point(float y_2, float x_7) {
    vec2 _e3 = bounded_vec2_(vec2(x_7, y_2));
    vec2 p_2 = abs(_e3);
    vec2 scaled_1 = ((max(p_2.x, p_2.y) > 1.0) ? (0.5 * p_2) : p_2);
    float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_1 = ((x_7 < 0.0) ? (PI - _e15) : _e15);
    return ((y_2 < 0.0) ? -(turned_1) : turned_1);
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

vec4 linear_from_display(vec4 color_1) {
    vec3 c_2 = max(color_1.xyz, vec3(0.0));
    vec3 low = (c_2 / vec3(12.92));
    vec3 high = pow(((c_2 + vec3(0.055)) / vec3(1.055)), vec3(2.4));
    return vec4(mix(high, low, lessThanEqual(c_2, vec3(0.04045))), color_1.w);
}

vec3 any_orthogonal(vec3 n_1) {
    float sign_ = ((n_1.z >= 0.0) ? 1.0 : -1.0);
    float a_1 = (-1.0 / (sign_ + n_1.z));
    return vec3((1.0 + (((sign_ * n_1.x) * n_1.x) * a_1)), (((sign_ * n_1.x) * n_1.y) * a_1), (-(sign_) * n_1.x));
}

mat3x3 world_from_tangent(vec3 tangent, vec3 bitangent, vec3 normal) {
    vec3 _e7 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    vec3 _e10 = normalize_or(tangent, vec3(0.0));
    vec3 leaning = (_e10 - (dot(_e10, _e7) * _e7));
    bool is_usable = (dot(leaning, leaning) > 1e-8);
    vec3 _e17 = any_orthogonal(_e7);
    vec3 _e23 = normalize_or((is_usable ? leaning : _e17), vec3(1.0, 0.0, 0.0));
    vec3 _e31 = normalize_or((_e23 - (dot(_e23, _e7) * _e7)), vec3(1.0, 0.0, 0.0));
    vec3 b = cross(_e7, _e31);
    return mat3x3(_e31, ((dot(b, bitangent) < 0.0) ? -(b) : b), _e7);
}

vec4 output_(vec4 color_2) {
    vec4 _e1 = straight(color_2);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float footprint_of(float x_8) {
    float _e1 = dFdx(x_8);
    float _e2 = dFdy(x_8);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float step_filtered(float x_9, float edge, float w) {
    float _e4 = bounded((x_9 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

Light light_by_tone(Light light, float tone, vec3 normal_1) {
    mat3x3 _e6 = world_from_tangent(light.direction, vec3(0.0), normal_1);
    float _e7 = bounded(tone);
    float height = clamp(_e7, 0.001, 1.0);
    vec3 _e23 = normalize_or(((height * _e6[2]) + (sqrt(max((1.0 - (height * height)), 0.0)) * _e6[0])), _e6[2]);
    return Light(_e23, light.own_direction, light.color, light.intensity);
}

Angle parametrization_diffuse(Light light_1, vec3 normal_2) {
    vec3 _e6 = normalize_or(normal_2, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light_1.direction);
    return _e8;
}

float profile_power(float q, float exponent) {
    float log_base = 0.0;
    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        float _e10 = log1p_negative_small((q * q));
        log_base = _e10;
    } else {
        float _e16 = log_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e16;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable(((exponent * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape) {
    bool local_2 = false;
    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_2 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_3 * shape.scale);
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_1, ProfileShape shape_1) {
    bool local_3 = false;
    bool local_4 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_1 <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w_1 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width = sqrt(((w_1 * w_1) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_1 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    vec2 _e50 = sin_cos_quarter((0.19364917 * w_1));
    Angle _e51 = angle_turned(u_5, _e50);
    float _e52 = profile_point(_e51, shape_1);
    Angle _e57 = angle_turned(u_5, vec2(-(_e50.x), _e50.y));
    float _e58 = profile_point(_e57, shape_1);
    return ((((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0);
}

float profile(Angle angle, float shift_1, ProfileShape shape_2) {
    Angle _e3 = angle_shifted(angle, shift_1);
    float _e4 = angle_footprint(_e3);
    float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

HcbtfGrid hcbtf_grid(sampler2DArray sheet) {
    int last = (int(uint(textureSize(sheet, 0).z)) - 1);
    vec4 _e9 = texelFetch(sheet, ivec3(ivec2(0, 0), last), 0);
    ivec4 first = ivec4(roundEven((255.0 * _e9)));
    vec4 _e18 = texelFetch(sheet, ivec3(ivec2(1, 0), last), 0);
    ivec4 second = ivec4(roundEven((255.0 * _e18)));
    ivec2 size_1 = ivec2((first.x + (256 * (first.z % 16))), (first.y + (256 * (first.z / 16))));
    return HcbtfGrid(size_1, second.xy, second.zw, ((first.w % 2) == 1), (((first.w / 2) % 2) == 1));
}

vec3 hcbtf_local(vec3 direction, mat3x3 frame) {
    vec3 _e3 = normalize_or(direction, frame[2]);
    vec3 _e9 = normalize_or((_e3 * frame), vec3(0.0, 0.0, 1.0));
    return _e9;
}

vec2 hcbtf_place(vec3 local_5, ivec2 directions) {
    float _e5 = length_of(vec3(local_5.xy, 0.0));
    float _e9 = angle_of_point(_e5, max(local_5.z, 0.0));
    float _e12 = angle_of_point(local_5.x, local_5.y);
    float around = ((_e5 > 1e-12) ? _e12 : 0.0);
    float steps = float(directions.y);
    float phi = (around * (0.15915494 * steps));
    float turned_2 = ((phi < 0.0) ? (phi + steps) : phi);
    float rings = float((directions.x - 1));
    return vec2(clamp(((_e9 * 0.63661975) * rings), 0.0, rings), ((turned_2 >= steps) ? 0.0 : turned_2));
}

HcbtfPlace hcbtf_around(vec2 place, ivec2 directions_1) {
    ivec2 low_1 = ivec2(floor(place));
    ivec2 theta = ivec2(low_1.x, min((low_1.x + 1), (directions_1.x - 1)));
    ivec2 phi_1 = ivec2(low_1.y, ((low_1.y + 1) % directions_1.y));
    return HcbtfPlace(theta, phi_1, (place - floor(place)));
}

HcbtfViews hcbtf_views(vec2 place_1, ivec2 directions_2) {
    HcbtfPlace _e2 = hcbtf_around(place_1, directions_2);
    ivec4 layer_1 = ((ivec4(_e2.theta.x, _e2.theta.y, _e2.theta.x, _e2.theta.y) * directions_2.y) + ivec4(_e2.phi.x, _e2.phi.x, _e2.phi.y, _e2.phi.y));
    vec2 w_3 = _e2.weight;
    vec4 weight_1 = vec4(((1.0 - w_3.x) * (1.0 - w_3.y)), (w_3.x * (1.0 - w_3.y)), ((1.0 - w_3.x) * w_3.y), (w_3.x * w_3.y));
    return HcbtfViews(layer_1, weight_1);
}

ivec2 hcbtf_block(ivec2 texel, ivec2 light_2, ivec2 origin) {
    return (origin + (texel * ivec2(light_2.x, (light_2.y + 2))));
}

vec4 hcbtf_add(vec4 sum, vec4 color_3, float weight) {
    return (sum + (vec4((color_3.xyz * color_3.w), color_3.w) * weight));
}

vec4 hcbtf_straight(vec4 sum_1) {
    return ((sum_1.w > 0.0) ? vec4(clamp((sum_1.xyz / vec3(max(sum_1.w, 1e-20))), vec3(0.0), vec3(1.0)), min(sum_1.w, 1.0)) : vec4(0.0));
}

vec4 hcbtf_lights(sampler2DArray sheet_1, ivec2 block, int layer, HcbtfPlace light_3) {
    vec4 sum_2 = vec4(0.0);
    vec2 w_4 = light_3.weight;
    vec4 _e8 = sum_2;
    vec4 _e18 = texelFetch(sheet_1, ivec3((block + ivec2(light_3.theta.x, (light_3.phi.x + 1))), layer), 0);
    vec4 _e26 = hcbtf_add(_e8, _e18, ((1.0 - w_4.x) * (1.0 - w_4.y)));
    sum_2 = _e26;
    vec4 _e27 = sum_2;
    vec4 _e37 = texelFetch(sheet_1, ivec3((block + ivec2(light_3.theta.y, (light_3.phi.x + 1))), layer), 0);
    vec4 _e43 = hcbtf_add(_e27, _e37, (w_4.x * (1.0 - w_4.y)));
    sum_2 = _e43;
    vec4 _e44 = sum_2;
    vec4 _e54 = texelFetch(sheet_1, ivec3((block + ivec2(light_3.theta.x, (light_3.phi.y + 1))), layer), 0);
    vec4 _e60 = hcbtf_add(_e44, _e54, ((1.0 - w_4.x) * w_4.y));
    sum_2 = _e60;
    vec4 _e61 = sum_2;
    vec4 _e71 = texelFetch(sheet_1, ivec3((block + ivec2(light_3.theta.y, (light_3.phi.y + 1))), layer), 0);
    vec4 _e75 = hcbtf_add(_e61, _e71, (w_4.x * w_4.y));
    return _e75;
}

vec4 hcbtf_sixteen(sampler2DArray sheet_2, ivec2 block_1, HcbtfPlace light_4, HcbtfViews views) {
    vec4 _e8 = hcbtf_lights(sheet_2, block_1, views.layer.x, light_4);
    vec4 _e14 = hcbtf_lights(sheet_2, block_1, views.layer.y, light_4);
    vec4 _e21 = hcbtf_lights(sheet_2, block_1, views.layer.z, light_4);
    vec4 _e28 = hcbtf_lights(sheet_2, block_1, views.layer.w, light_4);
    return ((((views.weight.x * _e8) + (views.weight.y * _e14)) + (views.weight.z * _e21)) + (views.weight.w * _e28));
}

HcbtfBlocks hcbtf_blocks(HcbtfTexels texels, ivec2 light_5) {
    ivec4 at = texels.at;
    ivec2 _e5 = hcbtf_block(at.xy, light_5, texels.origin);
    ivec2 _e8 = hcbtf_block(at.zy, light_5, texels.origin);
    ivec2 _e11 = hcbtf_block(at.xw, light_5, texels.origin);
    ivec2 _e14 = hcbtf_block(at.zw, light_5, texels.origin);
    return HcbtfBlocks(_e5, _e8, _e11, _e14);
}

HcbtfTexels hcbtf_texels(vec2 uv, HcbtfGrid grid, int level) {
    ivec2 size = ivec2(0);
    ivec2 origin_1 = ivec2(0);
    int i = 0;
    size = grid.size;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e41 = i;
            i = (_e41 + 1);
        }
        loop_init = false;
        int _e10 = i;
        if ((_e10 < level)) {
        } else {
            break;
        }
        {
            int _e18 = origin_1.y;
            int _e20 = size.y;
            int _e27 = i;
            origin_1 = ivec2((grid.size.x * grid.light.x), ((_e27 == 0) ? 0 : (_e18 + (_e20 * (grid.light.y + 2)))));
            ivec2 _e33 = size;
            size = max((_e33 / ivec2(2)), ivec2(1));
        }
    }
    vec2 _e47 = bounded_vec2_(vec2(uv.x, -(uv.y)));
    ivec2 _e50 = size;
    vec2 place_2 = (((_e47 - floor(_e47)) * vec2(_e50)) - vec2(0.5));
    ivec2 low_2 = ivec2(floor(place_2));
    ivec2 _e58 = size;
    ivec2 _e60 = size;
    ivec2 first_1 = ((low_2 + _e58) % _e60);
    ivec2 _e65 = size;
    ivec2 _e70 = origin_1;
    return HcbtfTexels(ivec4(first_1, ((first_1 + ivec2(1)) % _e65)), (place_2 - floor(place_2)), _e70);
}

vec4 hcbtf_sixteen_at(sampler2DArray sheet_3, vec2 uv_1, HcbtfGrid grid_1, int level_1, HcbtfPlace light_6, HcbtfViews views_1) {
    HcbtfTexels _e6 = hcbtf_texels(uv_1, grid_1, level_1);
    vec2 w_5 = _e6.weight;
    HcbtfBlocks _e9 = hcbtf_blocks(_e6, grid_1.light);
    vec4 _e18 = hcbtf_sixteen(sheet_3, _e9.left_top, light_6, views_1);
    vec4 _e26 = hcbtf_sixteen(sheet_3, _e9.right_top, light_6, views_1);
    vec4 _e35 = hcbtf_sixteen(sheet_3, _e9.left_bottom, light_6, views_1);
    vec4 _e42 = hcbtf_sixteen(sheet_3, _e9.right_bottom, light_6, views_1);
    return ((((((1.0 - w_5.x) * (1.0 - w_5.y)) * _e18) + ((w_5.x * (1.0 - w_5.y)) * _e26)) + (((1.0 - w_5.x) * w_5.y) * _e35)) + ((w_5.x * w_5.y) * _e42));
}

float hcbtf_level(vec2 uv_2, HcbtfGrid grid_2) {
    vec2 _e2 = dFdx(uv_2);
    vec2 _e6 = bounded_vec2_((_e2 * vec2(grid_2.size)));
    vec2 _e7 = dFdy(uv_2);
    vec2 _e11 = bounded_vec2_((_e7 * vec2(grid_2.size)));
    float widest = clamp(max(dot(_e6, _e6), dot(_e11, _e11)), 1.0, 1000000000.0);
    int side = max(grid_2.size.x, grid_2.size.y);
    float last_1 = floor((log2(float(side)) + 0.0001));
    return (grid_2.has_levels ? min((0.5 * log2(widest)), last_1) : 0.0);
}

float hcbtf_horizon(vec3 light_7, mat3x3 frame_1) {
    vec3 _e3 = normalize_or(light_7, frame_1[2]);
    float height_1 = dot(_e3, frame_1[2]);
    float _e7 = footprint_of(height_1);
    float _e8 = step_filtered(height_1, 0.0, _e7);
    return _e8;
}

vec4 hcbtf_finished(vec4 lit, float above, vec4 unlit, HcbtfGrid grid_3) {
    vec4 _e4 = linear_from_display(lit);
    vec4 painted = (grid_3.is_decoded ? _e4 : lit);
    vec4 _e7 = bounded_vec4_(unlit);
    return mix(_e7, painted, above);
}

vec4 hcbtf_lookup_smooth(sampler2DArray sheet_4, Light light_8, vec2 uv_3, vec2 scale, vec4 unlit_1, vec3 normal_3, vec3 view, vec3 tangent_1, vec3 bitangent_1) {
    vec4 sum_3 = vec4(0.0);
    HcbtfGrid _e10 = hcbtf_grid(sheet_4);
    mat3x3 _e11 = world_from_tangent(tangent_1, bitangent_1, normal_3);
    vec2 _e13 = bounded_vec2_((uv_3 * scale));
    float _e14 = hcbtf_level(_e13, _e10);
    float _e16 = hcbtf_horizon(light_8.direction, _e11);
    vec3 _e18 = hcbtf_local(light_8.direction, _e11);
    vec2 _e20 = hcbtf_place(_e18, _e10.light);
    HcbtfPlace _e22 = hcbtf_around(_e20, _e10.light);
    vec3 _e23 = hcbtf_local(view, _e11);
    vec2 _e25 = hcbtf_place(_e23, _e10.view);
    HcbtfViews _e27 = hcbtf_views(_e25, _e10.view);
    int finer = int(_e14);
    vec4 _e29 = hcbtf_sixteen_at(sheet_4, _e13, _e10, finer, _e22, _e27);
    sum_3 = _e29;
    if ((_e14 > float(finer))) {
        vec4 _e33 = sum_3;
        vec4 _e36 = hcbtf_sixteen_at(sheet_4, _e13, _e10, (finer + 1), _e22, _e27);
        sum_3 = mix(_e33, _e36, (_e14 - float(finer)));
    }
    vec4 _e40 = sum_3;
    vec4 _e41 = hcbtf_straight(_e40);
    vec4 _e42 = hcbtf_finished(_e41, _e16, unlit_1, _e10);
    return _e42;
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e8 = profile(_e5, 0.0, tone_shape);
    Light _e11 = u_look.key;
    Light _e13 = light_by_tone(_e11, _e8, surface_1.normal);
    vec4 _e28 = hcbtf_lookup_smooth(u_image_1, _e13, surface_1.uv, vec2(6.0), vec4(0.27, 0.26, 0.29, 1.0), surface_1.normal, surface_1.view, surface_1.tangent, surface_1.bitangent);
    vec4 _e29 = premultiplied(_e28);
    vec4 _e30 = output_(_e29);
    return _e30;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal, v_tangent, v_uv);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec2(0.0), vec3(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.uv = in_.uv;
    vec3 _e46 = normalize_or((in_.tangent.xyz - (normal_4 * dot(normal_4, in_.tangent.xyz))), in_.tangent.xyz);
    surface.tangent = _e46;
    vec3 _e57 = normalize_or((in_.tangent.xyz - (normal_4 * dot(normal_4, in_.tangent.xyz))), in_.tangent.xyz);
    surface.bitangent = (cross(normal_4, _e57) * in_.tangent.w);
    Surface _e62 = surface;
    vec4 _e63 = shade(_e62);
    vec4 _e64 = finite_vec4_(_e63);
    out_color = _e64;
    return;
}

