// Beetle: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// figure7-beetle.json says what to put there and how to draw.
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

struct Look {
    float4 hollows_color_concave;
    Light key;
    float4 green_sheen_color_convex;
    float4 gold_color_convex;
    Light side;
    float4 wing_case_color_convex;
    float4 wing_case_color_concave;
    ProfileShape wing_case_tone_shape;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
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

static const float HALF_PI = 1.5707964;
static const float LOG2_E = 1.442695;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const ProfileShape violet_tone_shape = ConstructProfileShape(0.98472655, 0.17410813, 2.425296, 2.1444545, 0.35, 0.43399706, 0.1847509, 0u);
static const ProfileShape gold_tone_shape = ConstructProfileShape(0.9887711, 0.14943813, 3.6826046, 2.8423793, 0.3, 0.2547288, 0.11251208, 0u);
static const ProfileShape green_sheen_tone_shape = ConstructProfileShape(0.99820054, 0.059964005, 5.2949586, 2.6937559, 0.12, 0.1805348, 0.07889118, 0u);
static const ProfileShape glint_tone_shape = ConstructProfileShape(0.99955004, 0.029995501, 25.006668, 2.4986002, 0.06, 0.039271776, 0.016918294, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x)
{
    float clamped_2 = clamp(x, -126.0, 127.99999);
    float whole = round(clamped_2);
    float f = (clamped_2 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_2_(float x_1)
{
    float whole_1 = round(x_1);
    float f_1 = (x_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_3_(float x_2)
{
    float clamped_3 = max(x_2, -126.0);
    float whole_2 = round(clamped_3);
    float f_2 = (clamped_3 - whole_2);
    float twice_2 = (2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724))))))))))));
    return (twice_2 * asfloat((uint(asint(asuint(naga_f2i32(whole_2)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_3)
{
    uint bits = asuint(x_3);
    int exponent_3 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_3) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_3) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float2 sin_cos_eighth(float x_4)
{
    float y_2 = (x_4 * x_4);
    float s = (x_4 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return float2(s, c);
}

float2 sin_cos_tiny(float x_5)
{
    float y_3 = (x_5 * x_5);
    float s_1 = (x_5 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
    float c_1 = (1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889))))));
    return float2(s_1, c_1);
}

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen(float3 v_1)
{
    const float3 _e5 = normalize_moderate(v_1, float3(0.0, 0.0, 1.0));
    return _e5;
}

float atan2_positive(float y_1, float x_6)
{
    float small = min(y_1, x_6);
    float large = max(y_1, x_6);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_6) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_2 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_2 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_2));
    float2 turned = (((s_2 <= 0.0) & (s_2 < c_2)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed(float kappa, float slope)
{
    float a_1 = ((((asuint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope);
    float magnitude = min(abs(a_1), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e32 = exp2_stable((-2.88539 * magnitude));
    float t_2 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, (0.0).xxxx, (1.0).xxxx);
}

float4 blend_add(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_1)
{
    const float4 _e11 = blend_finish(below_1, (below_1.xyz + (tone * color.xyz)), 1.0, color.w, clamped_1);
    return _e11;
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

LitLayer light_apply(Light light, float4 color_1, float tone_1)
{
    const float2 _e4 = light_split(light.intensity);
    const LitLayer litlayer = ConstructLitLayer(float4(((color_1.xyz * light.color) * _e4.y), color_1.w), (tone_1 * _e4.x));
    return litlayer;
}

LitLayer light_apply_2_(Light light_1, float4 color_2, float tone_2)
{
    float2 split = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer_1 = ConstructLitLayer(float4(((color_2.xyz * light_1.color) * split.y), 1.0), (tone_2 * split.x));
    return litlayer_1;
}

LitLayer light_apply_3_(Light light_2, float4 color_3, float tone_3)
{
    float2 split_1 = float2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    const LitLayer litlayer_2 = ConstructLitLayer(float4(((color_3.xyz * light_2.color) * split_1.y), color_3.w), split_1.x);
    return litlayer_2;
}

Angle parametrization_specular(Light light_3, float3 normal, float3 view)
{
    float3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    const float3 _e8 = normalize_moderate(mirrored, normal);
    const Angle angle_4 = ConstructAngle((0.5 * length((_e8 - light_3.direction))), (0.5 * length((_e8 + light_3.direction))));
    return angle_4;
}

float profile_power(float q, float exponent)
{
    float log_base = 0.0;

    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        const float _e11 = log1p_negative_small((q * q));
        log_base = (LOG2_E * _e11);
    } else {
        const float _e18 = log2_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e18;
    }
    float _e19 = log_base;
    const float _e21 = exp2_stable((exponent * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_2, ProfileShape shape)
{
    float s_3 = ((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset));
    if (((s_3 <= 0.0) | (shape.kind == PROFILE_AMBIENT))) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_3 = (s_3 * shape.scale);
    const float _e27 = profile_power(q_3, shape.exponent);
    return _e27;
}

float profile_power_2_(float q_1, float exponent_1)
{
    float log_base_1 = 0.0;

    if ((q_1 >= 1.0)) {
        return 0.0;
    }
    if ((q_1 < 0.5)) {
        const float _e11 = log1p_negative_small((q_1 * q_1));
        log_base_1 = (LOG2_E * _e11);
    } else {
        const float _e18 = log2_stable(((1.0 - q_1) * (1.0 + q_1)));
        log_base_1 = _e18;
    }
    float _e19 = log_base_1;
    const float _e21 = exp2_stable_2_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_3, ProfileShape shape_1)
{
    float s_4 = ((u_3.half_sin * shape_1.half_cos_offset) - (u_3.half_cos * shape_1.half_sin_offset));
    if (((s_4 <= 0.0) | false)) {
        return 1.0;
    }
    float q_4 = (s_4 * shape_1.scale);
    const float _e17 = profile_power_2_(q_4, shape_1.exponent);
    return _e17;
}

float profile_power_3_(float q_2, float exponent_2)
{
    float log_base_2 = 0.0;

    if ((q_2 >= 1.0)) {
        return 0.0;
    }
    if ((q_2 < 0.5)) {
        const float _e11 = log1p_negative_small((q_2 * q_2));
        log_base_2 = (LOG2_E * _e11);
    } else {
        const float _e18 = log2_stable(((1.0 - q_2) * (1.0 + q_2)));
        log_base_2 = _e18;
    }
    float _e19 = log_base_2;
    const float _e21 = exp2_stable_3_((exponent_2 * _e19));
    return min(_e21, 1.0);
}

float profile_point_3_(Angle u_4, ProfileShape shape_2)
{
    float s_5 = ((u_4.half_sin * shape_2.half_cos_offset) - (u_4.half_cos * shape_2.half_sin_offset));
    if (((s_5 <= 0.0) | false)) {
        return 1.0;
    }
    float q_5 = (s_5 * shape_2.scale);
    const float _e17 = profile_power_3_(q_5, shape_2.exponent);
    return _e17;
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_3)
{
    const float _e3 = profile_point(u_5, shape_3);
    bool is_wide_1 = (w < (0.1 * shape_3.edge_deviation));
    if (((is_wide_1 | (w <= 0.0)) | (shape_3.kind == PROFILE_AMBIENT))) {
        return _e3;
    }
    if (((shape_3.edge_deviation < 0.145) & (w >= (3.4641016 * shape_3.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        const float _e36 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e36)) / width)), 0.0, 1.0);
    }
    const float2 _e48 = sin_cos_tiny((0.19364917 * w));
    const Angle _e49 = angle_turned(u_5, _e48);
    const float _e50 = profile_point(_e49, shape_3);
    const Angle _e55 = angle_turned(u_5, float2(-(_e48.x), _e48.y));
    const float _e56 = profile_point(_e55, shape_3);
    return ((((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_2_(Angle u_6, float w_1, ProfileShape shape_4)
{
    const float _e3 = profile_point_2_(u_6, shape_4);
    bool is_wide_2 = (w_1 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_2 | (w_1 <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w_1));
    const Angle _e16 = angle_turned(u_6, _e15);
    const float _e17 = profile_point_2_(_e16, shape_4);
    const Angle _e22 = angle_turned(u_6, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point_2_(_e22, shape_4);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_3_(Angle u_7, float w_2, ProfileShape shape_5)
{
    const float _e3 = profile_point_3_(u_7, shape_5);
    bool is_wide_3 = (w_2 < (0.1 * shape_5.edge_deviation));
    if (((is_wide_3 | (w_2 <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w_2 >= (3.4641016 * shape_5.edge_deviation)))) {
        float width_1 = sqrt(((w_2 * w_2) + ((12.0 * shape_5.edge_deviation) * shape_5.edge_deviation)));
        const float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((shape_5.offset + shape_5.edge_mean) - (2.0 * _e32)) / width_1)), 0.0, 1.0);
    }
    const float2 _e44 = sin_cos_tiny((0.19364917 * w_2));
    const Angle _e45 = angle_turned(u_7, _e44);
    const float _e46 = profile_point_3_(_e45, shape_5);
    const Angle _e51 = angle_turned(u_7, float2(-(_e44.x), _e44.y));
    const float _e52 = profile_point_3_(_e51, shape_5);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_6)
{
    const float2 _e5 = sin_cos_eighth((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered(_e6, _e7, shape_6);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_7)
{
    const float2 _e5 = sin_cos_tiny((0.5 * shift_1));
    const Angle _e6 = angle_turned(angle_1, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_8)
{
    const float2 _e5 = sin_cos_tiny((0.5 * shift_2));
    const Angle _e6 = angle_turned(angle_2, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

float4 shade(Surface surface_1)
{
    const float _e3 = curvature_signed(surface_1.kappa, 0.2);
    float glint_convexity = (0.5 + (0.5 * _e3));
    float4 _e10 = look.wing_case_color_concave;
    float4 _e13 = look.wing_case_color_convex;
    float4 _e16 = look.wing_case_color_concave;
    float4 wing_case_color = (_e10 + (glint_convexity * (_e13 - _e16)));
    float3 _e24 = look.key.direction;
    float3 _e33 = look.key.direction;
    Angle hollows_angle = ConstructAngle((0.5 * length((surface_1.normal - _e24))), (0.5 * length((surface_1.normal + _e33))));
    float wing_case_warp = (((2.0 * glint_convexity) - 1.0) * 0.2);
    ProfileShape _e47 = look.wing_case_tone_shape;
    const float _e48 = profile(hollows_angle, wing_case_warp, _e47);
    Light _e51 = look.key;
    const LitLayer _e52 = light_apply(_e51, wing_case_color, _e48);
    const float4 _e62 = blend_add(float4(0.0157, 0.0627, 0.0392, 1.0), _e52.color, _e52.tone, 1.0, true);
    const float4 _e73 = curvature_color(glint_convexity, float4(0.3529, 0.1647, 0.4314, 1.0), float4(0.1098, 0.0627, 0.251, 1.0));
    Light _e76 = look.side;
    const Angle _e79 = parametrization_specular(_e76, surface_1.normal, surface_1.view);
    float gold_warp = (((2.0 * glint_convexity) - 1.0) * 0.15);
    const float _e87 = profile_2_(_e79, gold_warp, violet_tone_shape);
    Light _e90 = look.side;
    const LitLayer _e91 = light_apply_2_(_e90, _e73, _e87);
    float4 violet_blend = clamp(float4((_e62.xyz + (_e91.tone * _e91.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    float4 _e107 = look.gold_color_convex;
    const float4 _e113 = curvature_color(glint_convexity, _e107, float4(0.2902, 0.3529, 0.0627, 1.0));
    Light _e116 = look.key;
    const Angle _e119 = parametrization_specular(_e116, surface_1.normal, surface_1.view);
    const float _e121 = profile_3_(_e119, gold_warp, gold_tone_shape);
    Light _e124 = look.key;
    const LitLayer _e125 = light_apply(_e124, _e113, _e121);
    const float4 _e136 = blend_finish(violet_blend, (violet_blend.xyz + (_e125.tone * _e125.color.xyz)), 1.0, _e125.color.w, true);
    float4 _e139 = look.green_sheen_color_convex;
    const float4 _e145 = curvature_color(glint_convexity, _e139, float4(0.1647, 0.5412, 0.3529, 1.0));
    float green_sheen_warp = (((2.0 * glint_convexity) - 1.0) * 0.1);
    const float _e153 = profile_3_(_e119, green_sheen_warp, green_sheen_tone_shape);
    Light _e156 = look.key;
    const LitLayer _e157 = light_apply(_e156, _e145, _e153);
    const float4 _e168 = blend_finish(_e136, (_e136.xyz + (_e157.tone * _e157.color.xyz)), 1.0, _e157.color.w, true);
    const float4 _e176 = curvature_color(glint_convexity, (1.0).xxxx, float4(0.8471, 1.0, 0.8784, 1.0));
    float glint_warp = (((2.0 * glint_convexity) - 1.0) * 0.05);
    const float _e184 = profile_3_(_e119, glint_warp, glint_tone_shape);
    Light _e187 = look.key;
    const LitLayer _e188 = light_apply_2_(_e187, _e176, _e184);
    float4 glint_blend = clamp(float4((_e168.xyz + (_e188.tone * (_e188.color.xyz - _e168.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float _e206 = curvature_signed(surface_1.kappa, 0.3);
    float hollows_convexity = (0.5 + (0.5 * _e206));
    float4 _e213 = look.hollows_color_concave;
    float4 _e218 = look.hollows_color_concave;
    float4 hollows_color = (_e213 + (hollows_convexity * ((1.0).xxxx - _e218)));
    Light _e224 = look.key;
    const LitLayer _e226 = light_apply_3_(_e224, hollows_color, 1.0);
    const float4 _e237 = blend_finish(glint_blend, (glint_blend.xyz * (_e226.tone * _e226.color.xyz)), 1.0, _e226.color.w, true);
    return _e237;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_1.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    Varyings _e22 = out_;
    const Varyings varyings = _e22;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_3;
    float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    float4 _e27 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e27.x;
    Surface _e29 = surface;
    const float4 _e30 = shade(_e29);
    return _e30;
}
