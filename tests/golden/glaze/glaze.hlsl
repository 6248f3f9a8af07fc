// Grisaille and glaze: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2, curvature_map t0.
// glaze.json says what to put there and how to draw.
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
    Light key;
    Light back;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    float kappa;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct LitLayer {
    float4 color;
    float tone;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
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

struct VectorParts {
    float x;
    float y;
    float z;
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
static const ProfileShape gray_modeling_tone_shape = ConstructProfileShape(1.0, 0.0, 1.0537579, 1.3909147, 0.0, 1.2772532, 0.561292, 0u);
static const ProfileShape gray_lights_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 2.0858297, 3.3126261, 0.1, 0.42646712, 0.19445144, 0u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 position_object_3 : LOC1;
    float3 normal_4 : LOC2;
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
    float clamped_6 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_6);
    float f = ((clamped_6 - whole) * LN_2_);
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
    float t_4 = (small / large);
    bool is_wide = (t_4 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_4);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_10 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_10) : a_10);
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
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_1, 0.5);
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

float4 bounded_vec4_(float4 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    const float _e8 = bounded(v_4.w);
    return float4(_e2, _e4, _e6, _e8);
}

float mixed(float a, float b, float t_1)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_1, float3 b_1, float t_2)
{
    const float _e5 = mixed(a_1.x, b_1.x, t_2);
    const float _e8 = mixed(a_1.y, b_1.y, t_2);
    const float _e11 = mixed(a_1.z, b_1.z, t_2);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_2, float4 b_2, float t_3)
{
    const float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_3);
    const float _e8 = mixed(a_2.w, b_2.w, t_3);
    return float4(_e5, _e8);
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

float remapped(float x_8, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_8);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_9, float low_1, float high_1)
{
    const float _e3 = bounded(x_9);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float factor_of(float x_10, bool clamped_1)
{
    const float _e2 = bounded(x_10);
    const float _e3 = bounded(x_10);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_11)
{
    float _e1 = ddx(x_11);
    float _e2 = ddy(x_11);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float soft_light(float a_3, float b_3)
{
    if ((b_3 <= 0.5)) {
        return (a_3 - (((1.0 - (2.0 * b_3)) * a_3) * (1.0 - a_3)));
    }
    float curved = ((a_3 <= 0.25) ? (((((16.0 * a_3) - 12.0) * a_3) + 4.0) * a_3) : sqrt(max(a_3, 0.0)));
    return (a_3 + (((2.0 * b_3) - 1.0) * (curved - a_3)));
}

float4 color_mixed(float4 a_4, float3 blended, float factor)
{
    const float3 _e4 = bounded_vec3_(a_4.xyz);
    const float3 _e5 = bounded_vec3_(blended);
    const float _e7 = factor_of(factor, true);
    const float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    const float _e10 = bounded(a_4.w);
    return float4(_e8, _e10);
}

float3 within_unit(float3 rgb)
{
    const float3 _e1 = bounded_vec3_(rgb);
    return clamp(_e1, (0.0).xxx, (1.0).xxx);
}

float lightness_of(float3 rgb_1)
{
    return dot(rgb_1, float3(0.3, 0.59, 0.11));
}

float3 lit_as(float3 rgb_2, float3 other)
{
    const float _e2 = lightness_of(other);
    const float _e3 = lightness_of(rgb_2);
    float3 moved = (rgb_2 + ((_e2 - _e3)).xxx);
    float least = min(min(moved.x, moved.y), moved.z);
    float largest_2 = max(max(moved.x, moved.y), moved.z);
    float raised = ((least < 0.0) ? (_e2 / max((_e2 - least), 1e-6)) : 1.0);
    float3 clipped = ((_e2).xxx + ((moved - (_e2).xxx) * raised));
    float top = (_e2 + ((largest_2 - _e2) * raised));
    float lowered = ((top > 1.0) ? ((1.0 - _e2) / max((top - _e2), 1e-6)) : 1.0);
    return ((_e2).xxx + ((clipped - (_e2).xxx) * lowered));
}

float3 saturated_as(float3 rgb_3, float3 other_1)
{
    float least_1 = min(min(rgb_3.x, rgb_3.y), rgb_3.z);
    float spread = (max(max(rgb_3.x, rgb_3.y), rgb_3.z) - least_1);
    float wanted = (max(max(other_1.x, other_1.y), other_1.z) - min(min(other_1.x, other_1.y), other_1.z));
    return ((spread > 0.0) ? ((rgb_3 - (least_1).xxx) * (wanted / max(spread, SMALLEST_NORMAL))) : (0.0).xxx);
}

float4 premultiplied(float4 color)
{
    return float4((color.xyz * color.w), color.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 mix_colors_normal(float4 a_5, float4 b_4, float factor_1)
{
    const float4 _e3 = bounded_vec4_(a_5);
    const float4 _e4 = bounded_vec4_(b_4);
    const float _e6 = factor_of(factor_1, true);
    const float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float4 mix_colors_screen(float4 a_6, float4 b_5, float factor_2)
{
    const float4 _e10 = color_mixed(a_6, ((a_6.xyz + b_5.xyz) - (a_6.xyz * b_5.xyz)), factor_2);
    return _e10;
}

float4 mix_colors_soft_light(float4 a_7, float4 b_6, float factor_3)
{
    const float _e5 = soft_light(a_7.x, b_6.x);
    const float _e8 = soft_light(a_7.y, b_6.y);
    const float _e11 = soft_light(a_7.z, b_6.z);
    const float4 _e13 = color_mixed(a_7, float3(_e5, _e8, _e11), factor_3);
    return _e13;
}

float4 mix_colors_hue(float4 a_8, float4 b_7, float factor_4)
{
    const float3 _e4 = within_unit(a_8.xyz);
    const float3 _e6 = within_unit(b_7.xyz);
    const float3 _e7 = saturated_as(_e6, _e4);
    const float3 _e8 = lit_as(_e7, _e4);
    const float4 _e9 = color_mixed(a_8, _e8, factor_4);
    return _e9;
}

float4 mix_colors_color(float4 a_9, float4 b_8, float factor_5)
{
    const float3 _e4 = within_unit(b_8.xyz);
    const float3 _e6 = within_unit(a_9.xyz);
    const float3 _e7 = lit_as(_e4, _e6);
    const float4 _e8 = color_mixed(a_9, _e7, factor_5);
    return _e8;
}

float4 set_alpha(float4 color_1, float alpha)
{
    return float4(color_1.xyz, alpha);
}

float kappa_safe(float kappa)
{
    bool is_nan = ((asuint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope)
{
    const float _e2 = kappa_safe(kappa_1);
    const float _e4 = finite_or(slope, 0.0);
    float a_11 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_11), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_11 * a_11);
        return (a_11 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_6 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_11 >= 0.0) ? t_6 : -(t_6));
}

float transition(float kappa_2, float slope_1)
{
    const float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float kappa_surface(float kappa_3)
{
    const float _e1 = kappa_safe(kappa_3);
    return _e1;
}

float3 position_object(float3 position_object_1)
{
    return position_object_1;
}

float4 blend_finish(float4 below, float3 blended_1, float alpha_1, float opacity, bool clamped_2)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed_1 = float4((below.xyz + (opacity * (blended_1 - below.xyz))), alpha_1);
    return (clamped_2 ? clamp(mixed_1, (0.0).xxxx, (1.0).xxxx) : mixed_1);
}

float4 blend_add(float4 below_1, float4 color_2, float tone, float opacity_1, bool clamped_3)
{
    const float4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color_2.xyz)), below_1.w, (opacity_1 * color_2.w), clamped_3);
    return _e12;
}

float4 blend_alpha(float4 below_2, float4 color_3, float tone_1, float opacity_2, bool clamped_4)
{
    float a_12 = (opacity_2 * color_3.w);
    float alpha_2 = (below_2.w + ((tone_1 * a_12) * (1.0 - below_2.w)));
    const float4 _e20 = blend_finish(below_2, (below_2.xyz + (tone_1 * (color_3.xyz - below_2.xyz))), alpha_2, a_12, clamped_4);
    return _e20;
}

float4 output(float4 color_4)
{
    const float4 _e1 = straight(color_4);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float2 light_split(float intensity)
{
    return float2(min(intensity, 1.0), max(intensity, 1.0));
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_5, float tone_2)
{
    const float2 _e4 = light_split(light.intensity);
    const LitLayer litlayer = ConstructLitLayer(float4(((color_5.xyz * light.color) * _e4.y), color_5.w), (tone_2 * _e4.x));
    return litlayer;
}

Angle parametrization_diffuse(Light light_1, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light_1.direction);
    const Angle angle_4 = _e8;
    return angle_4;
}

Angle parametrization_specular(Light light_2, float3 normal_1, float3 view)
{
    const float3 _e7 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float3 mirrored = (((2.0 * dot(_e7, view)) * _e7) - view);
    const float3 _e13 = normalize_or(mirrored, _e7);
    const Angle _e15 = angle_between(_e13, light_2.direction);
    const Angle angle_5 = _e15;
    return angle_5;
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
    bool local_2 = (bool)0;

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
    const float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_1)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width_1 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_1)), 0.0, 1.0);
    }
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w));
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

float rim(Light light_3, float3 normal_2, float3 view_1, float width, float softness, float follow)
{
    const float3 _e10 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    float facing = clamp(dot(_e10, view_1), 0.0, 1.0);
    const float _e16 = factor_of(width, true);
    const float _e18 = factor_of(softness, true);
    const float _e20 = footprint_of(facing);
    float edge = max((_e16 * _e18), min(_e20, 1.0));
    float3 aside = (_e10 - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing));
    float within = ((further / max(edge, 1e-6)) + ((softness > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    float3 across = (light_3.direction - (dot(light_3.direction, view_1) * view_1));
    const float3 _e61 = normalize_or(across, (0.0).xxx);
    float side = dot((_e10 - (dot(_e10, view_1) * view_1)), _e61);
    const float _e66 = eased(side, 0.0, 0.5);
    const float _e68 = factor_of(follow, true);
    const float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float map_range(float value, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_5)
{
    const float _e6 = remapped(value, from_low_1, from_high_1, to_low_1, to_high_1, clamped_5);
    return _e6;
}

float smooth_step_value(float value_1, float low_2, float high_2)
{
    const float _e3 = eased(value_1, low_2, high_2);
    return _e3;
}

VectorParts ConstructVectorParts(float arg0, float arg1, float arg2) {
    VectorParts ret = (VectorParts)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

VectorParts separate_vector(float3 vector_)
{
    const VectorParts vectorparts = ConstructVectorParts(vector_.x, vector_.y, vector_.z);
    return vectorparts;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    const float _e8 = profile(_e5, 0.0, gray_modeling_tone_shape);
    Light _e11 = look.key;
    const LitLayer _e17 = light_apply(_e11, float4(0.7059, 0.7059, 0.7059, 1.0), _e8);
    const float4 _e27 = blend_alpha(float4(0.1216, 0.1216, 0.1216, 1.0), _e17.color, _e17.tone, 1.0, true);
    Light _e30 = look.key;
    const Angle _e33 = parametrization_specular(_e30, surface_1.normal, surface_1.view);
    const float _e36 = profile(_e33, 0.0, gray_lights_tone_shape);
    Light _e39 = look.key;
    const LitLayer _e45 = light_apply(_e39, float4(0.2902, 0.2902, 0.2902, 1.0), _e36);
    const float4 _e50 = blend_add(_e27, _e45.color, _e45.tone, 1.0, true);
    const float4 _e51 = straight(_e50);
    const float4 _e53 = set_alpha(_e51, 1.0);
    const float4 _e60 = mix_colors_color(_e53, float4(0.4275, 0.5412, 0.4471, 1.0), 0.75);
    const float4 _e67 = mix_colors_color(_e53, float4(0.7098, 0.4667, 0.3098, 1.0), 0.7);
    const float3 _e69 = position_object(surface_1.position_object);
    const VectorParts _e70 = separate_vector(_e69);
    const float _e74 = smooth_step_value(_e70.y, -0.5, 0.5);
    const float4 _e75 = mix_colors_normal(_e60, _e67, _e74);
    const float4 _e82 = mix_colors_soft_light(_e75, float4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    const float _e84 = kappa_surface(surface_1.kappa);
    const float _e86 = transition(_e84, 0.06);
    const float _e92 = map_range(_e86, 0.0, 0.55, 0.6, 0.0, true);
    const float4 _e98 = mix_colors_hue(_e82, float4(0.4902, 0.2471, 0.3608, 1.0), _e92);
    Light _e101 = look.back;
    const float _e107 = rim(_e101, surface_1.normal, surface_1.view, 0.3, 0.6, 1.0);
    const float4 _e113 = mix_colors_screen(_e98, float4(0.4353, 0.5294, 0.6588, 1.0), _e107);
    const float4 _e114 = premultiplied(_e113);
    const float4 _e115 = output(_e114);
    return _e115;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_2.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.position_object_3, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_5 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_5;
    float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    float4 _e26 = view_2.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    float4 _e42 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e42.x;
    Surface _e44 = surface;
    const float4 _e45 = shade(_e44);
    const float4 _e46 = finite_vec4_(_e45);
    return _e46;
}
