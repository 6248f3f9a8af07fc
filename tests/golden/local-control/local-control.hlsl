// Light where it is wanted: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_3 b0, object b1, look b2, curvature_tensor_map t0.
// local-control.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    float4 eye;
};

struct Object {
    row_major float4x4 world_from_object;
    row_major float3x3 world_from_normal;
    int _pad2_0;
    float id;
    float cutoff;
    int _end_pad_0;
    int _end_pad_1;
};

struct Light {
    float3 direction;
    int _pad1_0;
    float3 own_direction;
    int _pad2_0;
    float3 color;
    float intensity;
};

struct Look {
    row_major float3x3 camera_from_world;
    int _pad1_0;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light back;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    int _pad3_0;
    float3 position_camera;
    int _pad4_0;
    float3 curvature_tensor;
    int _end_pad_0;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
};

ProfileShape ConstructProfileShape(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, float arg6, uint arg7) {
    ProfileShape ret = (ProfileShape)0;
    ret.half_cos_offset = arg0;
    ret.half_sin_offset = arg1;
    ret.scale = arg2;
    ret.exponent = arg3;
    ret.offset = arg4;
    ret.edge_mean = arg5;
    ret.edge_deviation = arg6;
    ret.kind = arg7;
    return ret;
}

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const ProfileShape soft_tone_shape = ConstructProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);

cbuffer view_3 : register(b0) { View view_3; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput_vs_main {
    float3 position_3 : LOC0;
    float3 position_object : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_4 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_5 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise)
{
    const bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

float3 finite_vec3_(float3 v)
{
    const float _e3 = finite_or(v.x, 0.0);
    const float _e6 = finite_or(v.y, 0.0);
    const float _e9 = finite_or(v.z, 0.0);
    return float3(_e3, _e6, _e9);
}

float4 finite_vec4_(float4 v_1)
{
    const float3 _e2 = finite_vec3_(v_1.xyz);
    const float _e5 = finite_or(v_1.w, 0.0);
    return float4(_e2, _e5);
}

float3 normalize_or(float3 v_2, float3 otherwise_1)
{
    bool local = (bool)0;

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
    float3 scaled = (v_2 * (1.0 / largest));
    float square = dot(scaled, scaled);
    const bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float power_of_two(int n)
{
    return asfloat((uint(asint(asuint(n) + asuint(int(127)))) << 23u));
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x_2)
{
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3)
{
    uint bits = asuint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift_2 >= int(256)) ? asint(asuint(shift_2) - asuint(int(512))) : shift_2);
    float mantissa = asfloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float2 sin_cos_quarter(float x_4)
{
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_between(float3 d, float3 l)
{
    float p_1 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_1 * p_1) + (s_1 * s_1)), 1e-30)));
    const Angle angle_1 = ConstructAngle((p_1 * k), (s_1 * k));
    return angle_1;
}

float atan2_positive(float y_1, float x_5)
{
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_2 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_2) : a_2);
}

float angle_radians(Angle u)
{
    const float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, float2 t)
{
    bool local_1 = (bool)0;

    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_1 = (s_2 < c_1);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    float2 turned = (_e32 ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

Angle angle_shifted(Angle u_2, float shift)
{
    const float2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    const Angle _e8 = angle_turned(u_2, _e7);
    const Angle angle_3 = _e8;
    return angle_3;
}

float angle_footprint(Angle u_3)
{
    float2 half_ = float2(u_3.half_sin, u_3.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_3, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    const float _e6 = bounded(v_3.z);
    return float3(_e2, _e4, _e6);
}

float mixed(float a, float b, float t_1)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
}

float place_between(float x_7, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_7 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_7 - low) / _e12));
    return _e14;
}

float eased(float x_8, float low_1, float high_1)
{
    const float _e3 = bounded(x_8);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_3 = clamp(_e6, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float factor_of(float x_9, bool clamped)
{
    const float _e2 = bounded(x_9);
    const float _e3 = bounded(x_9);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float length_of(float3 v_4)
{
    const float3 _e1 = bounded_vec3_(v_4);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e17 = bounded((largest_2 * length((_e1 / (largest_2).xxx))));
    return _e17;
}

float footprint_of(float x_10)
{
    float _e1 = ddx(x_10);
    float _e2 = ddy(x_10);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness)
{
    const float _e4 = bounded(softness);
    return length(float2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_11, float edge, float w_1)
{
    const float _e4 = bounded((x_11 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float kappa_safe(float kappa)
{
    bool is_nan = ((asuint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float3 tensor_safe(float3 tensor)
{
    const float _e2 = kappa_safe(tensor.x);
    const float _e4 = kappa_safe(tensor.y);
    const float _e6 = kappa_safe(tensor.z);
    return float3(_e2, _e4, _e6);
}

float combine_tones_union(float a_1, float b_1)
{
    const float _e3 = factor_of(a_1, true);
    const float _e5 = factor_of(b_1, true);
    return max(_e3, _e5);
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped_1)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed_1 = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped_1 ? clamp(mixed_1, (0.0).xxxx, (1.0).xxxx) : mixed_1);
}

float4 blend_alpha(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_2)
{
    float a_3 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_3) * (1.0 - below_1.w)));
    const float4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_3, clamped_2);
    return _e20;
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float near_place(float3 position, float3 center_, float radius, float hardness)
{
    const float3 _e4 = bounded_vec3_(position);
    const float3 _e5 = bounded_vec3_(center_);
    const float _e7 = length_of((_e4 - _e5));
    const float _e8 = bounded(radius);
    float reach = max(_e8, 0.0);
    const float _e12 = factor_of(hardness, true);
    const float _e14 = eased(_e7, (reach * _e12), reach);
    return (1.0 - _e14);
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light local_light(Light light, float3 bend, float strength, float3 center_1, float radius_1, float hardness_1, float3 position_1)
{
    bool local_2 = (bool)0;

    const float _e7 = near_place(position_1, center_1, radius_1, hardness_1);
    const float3 _e9 = bounded_vec3_(bend);
    float3 bent = (light.direction + (_e7 * clamp(_e9, (-1000000.0).xxx, (1000000.0).xxx)));
    const float3 _e19 = normalize_or(bent, light.direction);
    if ((dot(bent, bent) > 1e-6)) {
        local_2 = (_e7 > 0.0);
    } else {
        local_2 = false;
    }
    bool _e28 = local_2;
    float3 direction = (_e28 ? _e19 : light.direction);
    const float _e32 = bounded(strength);
    const float _e36 = mixed(1.0, clamp(_e32, 0.0, 1000000.0), _e7);
    float intensity = (light.intensity * _e36);
    const Light light_3 = ConstructLight(direction, light.own_direction, light.color, min(intensity, 1e30));
    return light_3;
}

float local_tone(float tone_1, float amount, float3 center_2, float radius_2, float hardness_2, float3 position_2)
{
    const float _e6 = near_place(position_2, center_2, radius_2, hardness_2);
    const float _e7 = bounded(tone_1);
    const float _e11 = bounded(amount);
    return clamp((clamp(_e7, 0.0, 1.0) + (_e6 * clamp(_e11, -1.0, 1.0))), 0.0, 1.0);
}

Angle parametrization_diffuse(Light light_1, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light_1.direction);
    const Angle angle_4 = _e8;
    return angle_4;
}

float profile_power(float q, float exponent)
{
    float log_base = 0.0;

    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        const float _e10 = log1p_negative_small((q * q));
        log_base = _e10;
    } else {
        const float _e16 = log_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e16;
    }
    float _e19 = log_base;
    const float _e21 = exp2_stable(((exponent * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape)
{
    bool local_3 = (bool)0;

    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_3 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e18 = local_3;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_3 * shape.scale);
    const float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1)
{
    bool local_4 = (bool)0;
    bool local_5 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_4 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_4 = true;
    }
    bool _e13 = local_4;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_5 = (w_2 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_5 = false;
    }
    bool _e24 = local_5;
    if (_e24) {
        float width_4 = sqrt(((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_4)), 0.0, 1.0);
    }
    if ((w_2 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w_2));
    const Angle _e51 = angle_turned(u_5, _e50);
    const float _e52 = profile_point(_e51, shape_1);
    const Angle _e57 = angle_turned(u_5, float2(-(_e50.x), _e50.y));
    const float _e58 = profile_point(_e57, shape_1);
    return ((((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0);
}

float profile(Angle angle, float shift_1, ProfileShape shape_2)
{
    const Angle _e3 = angle_shifted(angle, shift_1);
    const float _e4 = angle_footprint(_e3);
    const float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

float threshold(float value, float edge_1, float softness_1)
{
    const float _e3 = footprint_of(value);
    const float _e4 = bounded(value);
    const float _e5 = bounded(edge_1);
    const float _e6 = edge_width(_e3, softness_1);
    const float _e7 = step_filtered(_e4, _e5, _e6);
    return _e7;
}

float rim(Light light_2, float3 normal_1, float3 view, float width, float softness_2, float follow)
{
    const float3 _e10 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float facing_1 = clamp(dot(_e10, view), 0.0, 1.0);
    const float _e16 = factor_of(width, true);
    const float _e18 = factor_of(softness_2, true);
    const float _e20 = footprint_of(facing_1);
    float edge_2 = max((_e16 * _e18), min(_e20, 1.0));
    float3 aside = (_e10 - view);
    float further = ((facing_1 > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1));
    float within = ((further / max(edge_2, 1e-6)) + ((softness_2 > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    float3 across = (light_2.direction - (dot(light_2.direction, view) * view));
    const float3 _e61 = normalize_or(across, (0.0).xxx);
    float side = dot((_e10 - (dot(_e10, view) * view)), _e61);
    const float _e66 = eased(side, 0.0, 0.5);
    const float _e68 = factor_of(follow, true);
    const float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float line_covers(float distance_, float width_1)
{
    return clamp(((width_1 + 0.5) - distance_), 0.0, min(width_1, 1.0));
}

float seen_well(float facing)
{
    const float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(float x_12, float limit, float softness_3)
{
    const float _e3 = bounded(limit);
    float at = max(_e3, 0.0);
    const float _e6 = footprint_of(x_12);
    const float _e10 = factor_of(softness_3, true);
    const float _e12 = edge_width(_e6, (min(at, 1000000000.0) * _e10));
    const float _e13 = bounded(x_12);
    const float _e14 = step_filtered(_e13, at, _e12);
    return _e14;
}

float inner_contour_suggestive(float width_2, float limit_1, float softness_4, float3 tensor_1, float3 normal_2, float3 view_1, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n_1 = mul(normal_2, camera_from_world);
    const float3 _e10 = tensor_safe(tensor_1);
    float square_1 = dot(n_1.xy, n_1.xy);
    float radial = (((((_e10.x * n_1.x) * n_1.x) + (((2.0 * _e10.y) * n_1.x) * n_1.y)) + ((_e10.z * n_1.y) * n_1.y)) / max(square_1, 1e-6));
    float _e36 = ddx(radial);
    float _e37 = ddy(radial);
    float2 change = float2(_e36, _e37);
    float3 v_5 = mul(view_1, camera_from_world);
    float3 row = ddy(place);
    float up = (((row - (dot(row, v_5) * v_5)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n_1.x) + ((up * change.y) * n_1.y))) * rsqrt(max(square_1, 1e-6)));
    const float _e67 = bounded(width_2);
    float pixels = (((0.5 * clamp(_e67, 0.0, 10000.0)) * height) / 1000.0);
    float distance_1 = (abs(radial) / max(length(change), 1e-6));
    const float _e84 = faded_in(((toward_eye * height) * 0.05), limit_1, softness_4);
    const float _e85 = line_covers(distance_1, pixels);
    const float _e88 = seen_well(dot(normal_2, view_1));
    return ((_e85 * _e84) * _e88);
}

float outer_contour(float width_3, float3 normal_3, float3 view_2, float2 viewport_1)
{
    const float3 _e6 = normalize_or(normal_3, (0.0).xxx);
    float facing_2 = clamp(dot(_e6, view_2), 0.0, 1.0);
    const float _e11 = bounded(width_3);
    float pixels_1 = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    const float _e22 = footprint_of(facing_2);
    float distance_2 = (facing_2 / max((2.0 * _e22), 1e-6));
    const float _e30 = eased(facing_2, 0.45, 0.75);
    float near = (1.0 - _e30);
    const float _e33 = line_covers(distance_2, pixels_1);
    return (_e33 * near);
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const Light _e16 = local_light(_e3, float3(0.9, 0.25, 0.5), 1.0, float3(0.12, 0.42, 0.5), 0.5, 0.4, surface_1.position_object);
    const Light _e29 = local_light(_e16, float3(0.4, 0.1, 0.35), 1.0, float3(-0.05, -0.35, 0.5), 0.4, 0.2, surface_1.position_object);
    const Angle _e31 = parametrization_diffuse(_e29, surface_1.normal);
    const float _e34 = profile(_e31, 0.0, soft_tone_shape);
    const float _e43 = local_tone(_e34, -0.45, float3(0.0, 0.02, 0.45), 0.3, 0.1, surface_1.position_object);
    const float _e52 = local_tone(_e43, 0.5, float3(-0.2, 0.72, 0.4), 0.17, 0.5, surface_1.position_object);
    const float _e55 = threshold(_e52, 0.55, 0.0);
    const float4 _e68 = blend_alpha(float4(0.36, 0.36, 0.6, 1.0), float4(0.96, 0.72, 0.47, 1.0), _e55, 1.0, true);
    const float _e71 = threshold(_e52, 0.97, 0.0);
    const float4 _e79 = blend_alpha(_e68, float4(1.0, 0.93, 0.76, 1.0), _e71, 1.0, true);
    Light _e82 = look.back;
    const float _e88 = rim(_e82, surface_1.normal, surface_1.view, 0.3, 0.1, 1.0);
    const float4 _e96 = blend_alpha(_e79, float4(0.72, 0.86, 1.0, 1.0), _e88, 0.7, true);
    float2 _e102 = look.viewport;
    const float _e103 = outer_contour(3.0, surface_1.normal, surface_1.view, _e102);
    float3x3 _e112 = look.camera_from_world;
    float2 _e116 = look.viewport;
    const float _e117 = inner_contour_suggestive(2.0, 20.0, 0.3, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e112, surface_1.position_camera, _e116);
    const float _e118 = combine_tones_union(_e103, _e117);
    const float4 _e126 = blend_alpha(_e96, float4(0.17, 0.13, 0.28, 1.0), _e118, 0.85, true);
    const float4 _e127 = output(_e126);
    return _e127;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_3.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    out_.position_object = vertex.position;
    float3x3 _e21 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e21);
    Varyings _e24 = out_;
    const Varyings varyings = _e24;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_4, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_6 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_6;
    float4 _e15 = view_3.eye;
    float _e20 = view_3.eye.w;
    float4 _e26 = view_3.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    float4x4 _e39 = view_3.camera_from_world;
    surface.position_camera = mul(float4(in_.position, 1.0), _e39).xyz;
    float4 _e51 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.curvature_tensor = _e51.xyz;
    Surface _e53 = surface;
    const float4 _e54 = shade(_e53);
    const float4 _e55 = finite_vec4_(_e54);
    return _e55;
}
