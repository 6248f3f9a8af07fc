// Half-tone metal: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2, curvature_map t0, image_1_ t1, image_1_sampler s0.
// hcbtf-halftone.json says what to put there and how to draw.
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
    Light rim;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float2 uv;
    int _pad3_0;
    int _pad3_1;
    float3 tangent;
    int _pad4_0;
    float3 bitangent;
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

struct HcbtfGrid {
    int2 size;
    int2 light;
    int2 view;
    bool has_levels;
    bool is_decoded;
    int _end_pad_0;
};

struct HcbtfPlace {
    int2 theta;
    int2 phi;
    float2 weight;
};

struct HcbtfViews {
    int4 layer;
    float4 weight;
};

struct HcbtfTexels {
    int4 at;
    float2 weight;
    int2 origin;
};

struct HcbtfBlocks {
    int2 left_top;
    int2 right_top;
    int2 left_bottom;
    int2 right_bottom;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
    float2 uv : LOC3;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
    float2 uv : LOC3;
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
static const ProfileShape key_tone_shape = ConstructProfileShape(0.9887711, 0.14943813, 1.7710322, 2.1985157, 0.3, 0.5954344, 0.25804672, 0u);
static const ProfileShape band_tone_shape = ConstructProfileShape(0.95233357, 0.30505863, 25.006668, 8.495251, 0.62, 0.023307618, 0.011411604, 0u);
static const ProfileShape tone_shape = ConstructProfileShape(1.0, 0.0, 1.0729164, 1.4587371, 0.0, 1.2242194, 0.53754854, 0u);
static const ProfileShape spark_tone_shape = ConstructProfileShape(0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u);
static const ProfileShape rim_tone_shape = ConstructProfileShape(0.921061, 0.38941833, 0.0, 1.0, 0.8, 0.0, 0.0, 1u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);
Texture2DArray<float4> image_1_ : register(t1);
SamplerState image_1_sampler : register(s0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_6 : LOC1;
    float4 tangent_2 : LOC2;
    float2 uv_4 : LOC3;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_7 : LOC1;
    float4 tangent_3 : LOC2;
    float2 uv_5 : LOC3;
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
    float clamped_2 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_2);
    float f = ((clamped_2 - whole) * LN_2_);
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
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a) : a);
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
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_2, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float2 bounded_vec2_(float2 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    return float2(_e2, _e4);
}

float3 bounded_vec3_(float3 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    return float3(_e2, _e4, _e6);
}

float4 bounded_vec4_(float4 v_5)
{
    const float _e2 = bounded(v_5.x);
    const float _e4 = bounded(v_5.y);
    const float _e6 = bounded(v_5.z);
    const float _e8 = bounded(v_5.w);
    return float4(_e2, _e4, _e6, _e8);
}

float length_of(float3 v_6)
{
    const float3 _e1 = bounded_vec3_(v_6);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e17 = bounded((largest_2 * length((_e1 / (largest_2).xxx))));
    return _e17;
}

float angle_of_point(float y_2, float x_7)
{
    const float2 _e3 = bounded_vec2_(float2(x_7, y_2));
    float2 p_2 = abs(_e3);
    float2 scaled_1 = ((max(p_2.x, p_2.y) > 1.0) ? (0.5 * p_2) : p_2);
    const float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_1 = ((x_7 < 0.0) ? (PI - _e15) : _e15);
    return ((y_2 < 0.0) ? -(turned_1) : turned_1);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 linear_from_display(float4 color)
{
    float3 c_2 = max(color.xyz, (0.0).xxx);
    float3 low = (c_2 / (12.92).xxx);
    float3 high = pow(((c_2 + (0.055).xxx) / (1.055).xxx), (2.4).xxx);
    return float4(((c_2 <= (0.04045).xxx) ? low : high), color.w);
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
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
    float a_1 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_1), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_2 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float transition(float kappa_2, float slope_1)
{
    const float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float warp(float convexity_1, float amount)
{
    return (((2.0 * convexity_1) - 1.0) * clamp(amount, -3.1415927, 3.1415927));
}

float3 any_orthogonal(float3 n_1)
{
    float sign_ = ((n_1.z >= 0.0) ? 1.0 : -1.0);
    float a_2 = (-1.0 / (sign_ + n_1.z));
    return float3((1.0 + (((sign_ * n_1.x) * n_1.x) * a_2)), (((sign_ * n_1.x) * n_1.y) * a_2), (-(sign_) * n_1.x));
}

float3x3 world_from_tangent(float3 tangent, float3 bitangent, float3 normal)
{
    const float3 _e7 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const float3 _e10 = normalize_or(tangent, (0.0).xxx);
    float3 leaning = (_e10 - (dot(_e10, _e7) * _e7));
    bool is_usable = (dot(leaning, leaning) > 1e-8);
    const float3 _e17 = any_orthogonal(_e7);
    const float3 _e23 = normalize_or((is_usable ? leaning : _e17), float3(1.0, 0.0, 0.0));
    const float3 _e31 = normalize_or((_e23 - (dot(_e23, _e7) * _e7)), float3(1.0, 0.0, 0.0));
    float3 b = cross(_e7, _e31);
    return float3x3(_e31, ((dot(b, bitangent) < 0.0) ? -(b) : b), _e7);
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed, (0.0).xxxx, (1.0).xxxx) : mixed);
}

float4 blend_alpha(float4 below_1, float4 color_1, float tone, float opacity_1, bool clamped_1)
{
    float a_3 = (opacity_1 * color_1.w);
    float alpha_1 = (below_1.w + ((tone * a_3) * (1.0 - below_1.w)));
    const float4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color_1.xyz - below_1.xyz))), alpha_1, a_3, clamped_1);
    return _e20;
}

float4 output(float4 color_2)
{
    const float4 _e1 = straight(color_2);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float footprint_of(float x_8)
{
    float _e1 = ddx(x_8);
    float _e2 = ddy(x_8);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float step_filtered(float x_9, float edge, float w)
{
    const float _e4 = bounded((x_9 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
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

LitLayer light_apply(Light light, float4 color_3, float tone_1)
{
    const float2 _e4 = light_split(light.intensity);
    const LitLayer litlayer = ConstructLitLayer(float4(((color_3.xyz * light.color) * _e4.y), color_3.w), (tone_1 * _e4.x));
    return litlayer;
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light light_by_tone(Light light_1, float tone_2, float3 normal_1)
{
    const float3x3 _e6 = world_from_tangent(light_1.direction, (0.0).xxx, normal_1);
    const float _e7 = bounded(tone_2);
    float height = clamp(_e7, 0.001, 1.0);
    const float3 _e23 = normalize_or(((height * _e6[2]) + (sqrt(max((1.0 - (height * height)), 0.0)) * _e6[0])), _e6[2]);
    const Light light_12 = ConstructLight(_e23, light_1.own_direction, light_1.color, light_1.intensity);
    return light_12;
}

Angle parametrization_diffuse(Light light_2, float3 normal_2)
{
    const float3 _e6 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light_2.direction);
    const Angle angle_4 = _e8;
    return angle_4;
}

Angle parametrization_specular(Light light_3, float3 normal_3, float3 view)
{
    const float3 _e7 = normalize_or(normal_3, float3(0.0, 0.0, 1.0));
    float3 mirrored = (((2.0 * dot(_e7, view)) * _e7) - view);
    const float3 _e13 = normalize_or(mirrored, _e7);
    const Angle _e15 = angle_between(_e13, light_3.direction);
    const Angle angle_5 = _e15;
    return angle_5;
}

Angle parametrization_screen_aligned(Light light_4, float3 normal_4, float3x3 camera_from_world)
{
    const float3 _e7 = normalize_or(normal_4, float3(0.0, 0.0, 1.0));
    float3 n_2 = mul(_e7, camera_from_world);
    const float3 _e13 = normalize_or(n_2, float3(0.0, 0.0, 1.0));
    const Angle _e15 = angle_between(_e13, light_4.own_direction);
    const Angle angle_6 = _e15;
    return angle_6;
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

float profile_filtered(Angle u_5, float w_1, ProfileShape shape_1)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
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
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_1 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w_1));
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

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

HcbtfGrid ConstructHcbtfGrid(int2 arg0, int2 arg1, int2 arg2, bool arg3, bool arg4) {
    HcbtfGrid ret = (HcbtfGrid)0;
    ret.size = arg0;
    ret.light = arg1;
    ret.view = arg2;
    ret.has_levels = arg3;
    ret.is_decoded = arg4;
    return ret;
}

int4 naga_f2i32(float4 value) {
    return int4(clamp(value, -2147483600.0, 2147483500.0));
}

uint NagaNumLayers2DArray(Texture2DArray<float4> tex)
{
    uint4 ret;
    tex.GetDimensions(0, ret.x, ret.y, ret.z, ret.w);
    return ret.z;
}

HcbtfGrid hcbtf_grid(Texture2DArray<float4> sheet)
{
    int last = asint(asuint(int(NagaNumLayers2DArray(sheet))) - asuint(int(1)));
    float4 _e9 = sheet.Load(int4(int2(int(0), int(0)), last, int(0)));
    int4 first = naga_f2i32(round((255.0 * _e9)));
    float4 _e18 = sheet.Load(int4(int2(int(1), int(0)), last, int(0)));
    int4 second = naga_f2i32(round((255.0 * _e18)));
    int2 size_1 = int2(asint(asuint(first.x) + asuint(asint(asuint(int(256)) * asuint(naga_mod(first.z, int(16)))))), asint(asuint(first.y) + asuint(asint(asuint(int(256)) * asuint(naga_div(first.z, int(16)))))));
    const HcbtfGrid hcbtfgrid = ConstructHcbtfGrid(size_1, second.xy, second.zw, (naga_mod(first.w, int(2)) == int(1)), (naga_mod(naga_div(first.w, int(2)), int(2)) == int(1)));
    return hcbtfgrid;
}

float3 hcbtf_local(float3 direction, float3x3 frame)
{
    const float3 _e3 = normalize_or(direction, frame[2]);
    const float3 _e9 = normalize_or(mul(frame, _e3), float3(0.0, 0.0, 1.0));
    return _e9;
}

float2 hcbtf_place(float3 local_5, int2 directions)
{
    const float _e5 = length_of(float3(local_5.xy, 0.0));
    const float _e9 = angle_of_point(_e5, max(local_5.z, 0.0));
    const float _e12 = angle_of_point(local_5.x, local_5.y);
    float around = ((_e5 > 1e-12) ? _e12 : 0.0);
    float steps = float(directions.y);
    float phi = (around * (0.15915494 * steps));
    float turned_2 = ((phi < 0.0) ? (phi + steps) : phi);
    float rings = float(asint(asuint(directions.x) - asuint(int(1))));
    return float2(clamp(((_e9 * 0.63661975) * rings), 0.0, rings), ((turned_2 >= steps) ? 0.0 : turned_2));
}

HcbtfPlace ConstructHcbtfPlace(int2 arg0, int2 arg1, float2 arg2) {
    HcbtfPlace ret = (HcbtfPlace)0;
    ret.theta = arg0;
    ret.phi = arg1;
    ret.weight = arg2;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

HcbtfPlace hcbtf_around(float2 place, int2 directions_1)
{
    int2 low_1 = naga_f2i32(floor(place));
    int2 theta = int2(low_1.x, min(asint(asuint(low_1.x) + asuint(int(1))), asint(asuint(directions_1.x) - asuint(int(1)))));
    int2 phi_1 = int2(low_1.y, naga_mod(asint(asuint(low_1.y) + asuint(int(1))), directions_1.y));
    const HcbtfPlace hcbtfplace = ConstructHcbtfPlace(theta, phi_1, (place - floor(place)));
    return hcbtfplace;
}

HcbtfViews ConstructHcbtfViews(int4 arg0, float4 arg1) {
    HcbtfViews ret = (HcbtfViews)0;
    ret.layer = arg0;
    ret.weight = arg1;
    return ret;
}

HcbtfViews hcbtf_views(float2 place_1, int2 directions_2)
{
    const HcbtfPlace _e2 = hcbtf_around(place_1, directions_2);
    int4 layer_1 = asint(asuint(asint(asuint(int4(_e2.theta.x, _e2.theta.y, _e2.theta.x, _e2.theta.y)) * asuint(directions_2.y))) + asuint(int4(_e2.phi.x, _e2.phi.x, _e2.phi.y, _e2.phi.y)));
    float2 w_3 = _e2.weight;
    float4 weight_1 = float4(((1.0 - w_3.x) * (1.0 - w_3.y)), (w_3.x * (1.0 - w_3.y)), ((1.0 - w_3.x) * w_3.y), (w_3.x * w_3.y));
    const HcbtfViews hcbtfviews = ConstructHcbtfViews(layer_1, weight_1);
    return hcbtfviews;
}

int2 hcbtf_block(int2 texel, int2 light_5, int2 origin)
{
    return asint(asuint(origin) + asuint(asint(asuint(texel) * asuint(int2(light_5.x, asint(asuint(light_5.y) + asuint(int(2))))))));
}

float4 hcbtf_add(float4 sum, float4 color_4, float weight)
{
    return (sum + (float4((color_4.xyz * color_4.w), color_4.w) * weight));
}

float4 hcbtf_straight(float4 sum_1)
{
    return ((sum_1.w > 0.0) ? float4(clamp((sum_1.xyz / (max(sum_1.w, 1e-20)).xxx), (0.0).xxx, (1.0).xxx), min(sum_1.w, 1.0)) : (0.0).xxxx);
}

float4 hcbtf_lights(Texture2DArray<float4> sheet_1, int2 block, int layer, HcbtfPlace light_6)
{
    float4 sum_2 = (0.0).xxxx;

    float2 w_4 = light_6.weight;
    float4 _e8 = sum_2;
    float4 _e18 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_6.theta.x, asint(asuint(light_6.phi.x) + asuint(int(1)))))), layer, int(0)));
    const float4 _e26 = hcbtf_add(_e8, _e18, ((1.0 - w_4.x) * (1.0 - w_4.y)));
    sum_2 = _e26;
    float4 _e27 = sum_2;
    float4 _e37 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_6.theta.y, asint(asuint(light_6.phi.x) + asuint(int(1)))))), layer, int(0)));
    const float4 _e43 = hcbtf_add(_e27, _e37, (w_4.x * (1.0 - w_4.y)));
    sum_2 = _e43;
    float4 _e44 = sum_2;
    float4 _e54 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_6.theta.x, asint(asuint(light_6.phi.y) + asuint(int(1)))))), layer, int(0)));
    const float4 _e60 = hcbtf_add(_e44, _e54, ((1.0 - w_4.x) * w_4.y));
    sum_2 = _e60;
    float4 _e61 = sum_2;
    float4 _e71 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_6.theta.y, asint(asuint(light_6.phi.y) + asuint(int(1)))))), layer, int(0)));
    const float4 _e75 = hcbtf_add(_e61, _e71, (w_4.x * w_4.y));
    return _e75;
}

float4 hcbtf_sixteen(Texture2DArray<float4> sheet_2, int2 block_1, HcbtfPlace light_7, HcbtfViews views)
{
    const float4 _e8 = hcbtf_lights(sheet_2, block_1, views.layer.x, light_7);
    const float4 _e14 = hcbtf_lights(sheet_2, block_1, views.layer.y, light_7);
    const float4 _e21 = hcbtf_lights(sheet_2, block_1, views.layer.z, light_7);
    const float4 _e28 = hcbtf_lights(sheet_2, block_1, views.layer.w, light_7);
    return ((((views.weight.x * _e8) + (views.weight.y * _e14)) + (views.weight.z * _e21)) + (views.weight.w * _e28));
}

HcbtfBlocks ConstructHcbtfBlocks(int2 arg0, int2 arg1, int2 arg2, int2 arg3) {
    HcbtfBlocks ret = (HcbtfBlocks)0;
    ret.left_top = arg0;
    ret.right_top = arg1;
    ret.left_bottom = arg2;
    ret.right_bottom = arg3;
    return ret;
}

HcbtfBlocks hcbtf_blocks(HcbtfTexels texels, int2 light_8)
{
    int4 at = texels.at;
    const int2 _e5 = hcbtf_block(at.xy, light_8, texels.origin);
    const int2 _e8 = hcbtf_block(at.zy, light_8, texels.origin);
    const int2 _e11 = hcbtf_block(at.xw, light_8, texels.origin);
    const int2 _e14 = hcbtf_block(at.zw, light_8, texels.origin);
    const HcbtfBlocks hcbtfblocks = ConstructHcbtfBlocks(_e5, _e8, _e11, _e14);
    return hcbtfblocks;
}

int2 naga_div(int2 lhs, int2 rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

HcbtfTexels ConstructHcbtfTexels(int4 arg0, float2 arg1, int2 arg2) {
    HcbtfTexels ret = (HcbtfTexels)0;
    ret.at = arg0;
    ret.weight = arg1;
    ret.origin = arg2;
    return ret;
}

HcbtfTexels hcbtf_texels(float2 uv, HcbtfGrid grid, int level)
{
    int2 size = (int2)0;
    int2 origin_1 = (int(0)).xx;
    int i = int(0);

    size = grid.size;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e41 = i;
            i = asint(asuint(_e41) + asuint(int(1)));
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
            origin_1 = int2(asint(asuint(grid.size.x) * asuint(grid.light.x)), ((_e27 == int(0)) ? int(0) : asint(asuint(_e18) + asuint(asint(asuint(_e20) * asuint(asint(asuint(grid.light.y) + asuint(int(2)))))))));
            int2 _e33 = size;
            size = max(naga_div(_e33, (int(2)).xx), (int(1)).xx);
        }
    }
    const float2 _e47 = bounded_vec2_(float2(uv.x, -(uv.y)));
    int2 _e50 = size;
    float2 place_2 = (((_e47 - floor(_e47)) * float2(_e50)) - (0.5).xx);
    int2 low_2 = naga_f2i32(floor(place_2));
    int2 _e58 = size;
    int2 _e60 = size;
    int2 first_1 = naga_mod(asint(asuint(low_2) + asuint(_e58)), _e60);
    int2 _e65 = size;
    int2 _e70 = origin_1;
    const HcbtfTexels hcbtftexels = ConstructHcbtfTexels(int4(first_1, naga_mod(asint(asuint(first_1) + asuint((int(1)).xx)), _e65)), (place_2 - floor(place_2)), _e70);
    return hcbtftexels;
}

float4 hcbtf_sixteen_at(Texture2DArray<float4> sheet_3, float2 uv_1, HcbtfGrid grid_1, int level_1, HcbtfPlace light_9, HcbtfViews views_1)
{
    const HcbtfTexels _e6 = hcbtf_texels(uv_1, grid_1, level_1);
    float2 w_5 = _e6.weight;
    const HcbtfBlocks _e9 = hcbtf_blocks(_e6, grid_1.light);
    const float4 _e18 = hcbtf_sixteen(sheet_3, _e9.left_top, light_9, views_1);
    const float4 _e26 = hcbtf_sixteen(sheet_3, _e9.right_top, light_9, views_1);
    const float4 _e35 = hcbtf_sixteen(sheet_3, _e9.left_bottom, light_9, views_1);
    const float4 _e42 = hcbtf_sixteen(sheet_3, _e9.right_bottom, light_9, views_1);
    return ((((((1.0 - w_5.x) * (1.0 - w_5.y)) * _e18) + ((w_5.x * (1.0 - w_5.y)) * _e26)) + (((1.0 - w_5.x) * w_5.y) * _e35)) + ((w_5.x * w_5.y) * _e42));
}

float hcbtf_level(float2 uv_2, HcbtfGrid grid_2)
{
    float2 _e2 = ddx(uv_2);
    const float2 _e6 = bounded_vec2_((_e2 * float2(grid_2.size)));
    float2 _e7 = ddy(uv_2);
    const float2 _e11 = bounded_vec2_((_e7 * float2(grid_2.size)));
    float widest = clamp(max(dot(_e6, _e6), dot(_e11, _e11)), 1.0, 1000000000.0);
    int side = max(grid_2.size.x, grid_2.size.y);
    float last_1 = floor((log2(float(side)) + 0.0001));
    return (grid_2.has_levels ? min((0.5 * log2(widest)), last_1) : 0.0);
}

float hcbtf_horizon(float3 light_10, float3x3 frame_1)
{
    const float3 _e3 = normalize_or(light_10, frame_1[2]);
    float height_1 = dot(_e3, frame_1[2]);
    const float _e7 = footprint_of(height_1);
    const float _e8 = step_filtered(height_1, 0.0, _e7);
    return _e8;
}

float4 hcbtf_finished(float4 lit_, float above, float4 unlit, HcbtfGrid grid_3)
{
    const float4 _e4 = linear_from_display(lit_);
    float4 painted = (grid_3.is_decoded ? _e4 : lit_);
    const float4 _e7 = bounded_vec4_(unlit);
    return lerp(_e7, painted, above);
}

float4 hcbtf_lookup_smooth(Texture2DArray<float4> sheet_4, SamplerState sheet_sampler, Light light_11, float2 uv_3, float2 scale, float4 unlit_1, float3 normal_5, float3 view_1, float3 tangent_1, float3 bitangent_1)
{
    float4 sum_3 = (float4)0;

    const HcbtfGrid _e10 = hcbtf_grid(sheet_4);
    const float3x3 _e11 = world_from_tangent(tangent_1, bitangent_1, normal_5);
    const float2 _e13 = bounded_vec2_((uv_3 * scale));
    const float _e14 = hcbtf_level(_e13, _e10);
    const float _e16 = hcbtf_horizon(light_11.direction, _e11);
    const float3 _e18 = hcbtf_local(light_11.direction, _e11);
    const float2 _e20 = hcbtf_place(_e18, _e10.light);
    const HcbtfPlace _e22 = hcbtf_around(_e20, _e10.light);
    const float3 _e23 = hcbtf_local(view_1, _e11);
    const float2 _e25 = hcbtf_place(_e23, _e10.view);
    const HcbtfViews _e27 = hcbtf_views(_e25, _e10.view);
    int finer = naga_f2i32(_e14);
    const float4 _e29 = hcbtf_sixteen_at(sheet_4, _e13, _e10, finer, _e22, _e27);
    sum_3 = _e29;
    if ((_e14 > float(finer))) {
        float4 _e33 = sum_3;
        const float4 _e36 = hcbtf_sixteen_at(sheet_4, _e13, _e10, asint(asuint(finer) + asuint(int(1))), _e22, _e27);
        sum_3 = lerp(_e33, _e36, (_e14 - float(finer)));
    }
    float4 _e40 = sum_3;
    const float4 _e41 = hcbtf_straight(_e40);
    const float4 _e42 = hcbtf_finished(_e41, _e16, unlit_1, _e10);
    return _e42;
}

float4 shade(Surface surface_1)
{
    const float _e3 = transition(surface_1.kappa, 0.3);
    const float4 _e14 = curvature_color(_e3, float4(0.7, 0.8, 0.92, 1.0), float4(0.52, 0.62, 0.8, 1.0));
    Light _e17 = look.key;
    const Angle _e19 = parametrization_diffuse(_e17, surface_1.normal);
    const float _e21 = warp(_e3, 0.3);
    const float _e23 = profile(_e19, _e21, key_tone_shape);
    Light _e26 = look.key;
    const LitLayer _e27 = light_apply(_e26, _e14, _e23);
    const float4 _e37 = blend_alpha(float4(0.33, 0.42, 0.56, 1.0), _e27.color, _e27.tone, 1.0, true);
    const float _e40 = transition(surface_1.kappa, 0.25);
    const float4 _e51 = curvature_color(_e40, float4(0.93, 0.97, 1.0, 1.0), float4(0.8, 0.9, 1.0, 1.0));
    Light _e54 = look.key;
    const Angle _e57 = parametrization_specular(_e54, surface_1.normal, surface_1.view);
    const float _e59 = warp(_e40, 0.2);
    const float _e61 = profile(_e57, _e59, band_tone_shape);
    Light _e64 = look.key;
    const LitLayer _e65 = light_apply(_e64, _e51, _e61);
    const float4 _e70 = blend_alpha(_e37, _e65.color, _e65.tone, 1.0, true);
    const float _e73 = profile(_e19, 0.0, tone_shape);
    Light _e76 = look.key;
    const Light _e78 = light_by_tone(_e76, _e73, surface_1.normal);
    const float4 _e93 = hcbtf_lookup_smooth(image_1_, image_1_sampler, _e78, surface_1.uv, (16.0).xx, float4(0.094, 0.102, 0.188, 1.0), surface_1.normal, surface_1.view, surface_1.tangent, surface_1.bitangent);
    const float4 _e97 = blend_alpha(_e70, _e93, 1.0, 1.0, true);
    const float _e100 = transition(surface_1.kappa, 0.2);
    const float _e102 = warp(_e100, 0.1);
    const float _e104 = profile(_e57, _e102, spark_tone_shape);
    Light _e107 = look.key;
    const LitLayer _e110 = light_apply(_e107, (1.0).xxxx, _e104);
    const float4 _e115 = blend_alpha(_e97, _e110.color, _e110.tone, 1.0, true);
    const float4 _e126 = curvature_color(_e3, float4(1.0, 0.62, 0.3, 1.0), float4(1.0, 0.5, 0.3, 1.0));
    Light _e129 = look.rim;
    float3x3 _e133 = look.camera_from_world;
    const Angle _e134 = parametrization_screen_aligned(_e129, surface_1.normal, _e133);
    const float _e136 = warp(_e3, 0.15);
    const float _e138 = profile(_e134, _e136, rim_tone_shape);
    Light _e141 = look.rim;
    const LitLayer _e142 = light_apply(_e141, _e126, _e138);
    const float4 _e147 = blend_alpha(_e115, _e142.color, _e142.tone, 1.0, true);
    const float4 _e148 = output(_e147);
    return _e148;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_2.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    float4x4 _e25 = object.world_from_object;
    float3x3 _e39 = object.world_from_normal;
    out_.tangent = float4(mul(float4(vertex.tangent.xyz, 0.0), _e25).xyz, ((determinant(_e39) < 0.0) ? -(vertex.tangent.w) : vertex.tangent.w));
    out_.uv = vertex.uv;
    Varyings _e47 = out_;
    const Varyings varyings = _e47;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.tangent, varyings.uv, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_7, fragmentinput_fs_main.tangent_3, fragmentinput_fs_main.uv_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_8 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_8;
    float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    float4 _e26 = view_2.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.uv = in_.uv;
    const float3 _e46 = normalize_or((in_.tangent.xyz - (normal_8 * dot(normal_8, in_.tangent.xyz))), in_.tangent.xyz);
    surface.tangent = _e46;
    const float3 _e57 = normalize_or((in_.tangent.xyz - (normal_8 * dot(normal_8, in_.tangent.xyz))), in_.tangent.xyz);
    surface.bitangent = (cross(normal_8, _e57) * in_.tangent.w);
    float4 _e68 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e68.x;
    Surface _e70 = surface;
    const float4 _e71 = shade(_e70);
    const float4 _e72 = finite_vec4_(_e71);
    return _e72;
}
