// Anime face: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// anime-face.json says what to put there and how to draw.
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
    Light eye;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light back;
    Light key;
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

static const float HALF_PI = 1.5707964;
static const float LOG2_E = 1.442695;
static const ProfileShape edge_of_the_shadow_shape = ConstructProfileShape(0.7960838, 0.6051864, 15.395454, 2.8429606, 1.3, 0.060679536, 0.026670605, 0u);
static const ProfileShape lit_shape = ConstructProfileShape(0.7775727, 0.628793, 0.0, 1.0, 1.36, 0.0, 0.0, 1u);
static const ProfileShape shine_tone_shape = ConstructProfileShape(0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u);
static const ProfileShape rim_light_tone_shape = ConstructProfileShape(0.90896577, 0.4168708, 0.0, 1.0, 0.86, 0.0, 0.0, 1u);
static const ProfileShape contour_tone_shape = ConstructProfileShape(0.819648, 0.57286745, 0.0, 1.0, 1.22, 0.0, 0.0, 1u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) & true))) {
        return otherwise;
    }
    float3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    return (((asuint(square) & 2139095040u) == 2139095040u) ? otherwise : (scaled * (1.0 / sqrt(square))));
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x)
{
    float clamped_3 = clamp(x, -126.0, 127.99999);
    float whole = round(clamped_3);
    float f = (clamped_3 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_2_(float x_1)
{
    float clamped_4 = max(x_1, -126.0);
    float whole_1 = round(clamped_4);
    float f_1 = (clamped_4 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_2)
{
    uint bits = asuint(x_2);
    int exponent_1 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float2 sin_cos_eighth(float x_3)
{
    float y_2 = (x_3 * x_3);
    float s = (x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return float2(s, c);
}

float2 sin_cos_tiny(float x_4)
{
    float y_3 = (x_4 * x_4);
    float s_1 = (x_4 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
    float c_1 = (1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889))))));
    return float2(s_1, c_1);
}

float3 normalize_moderate(float3 v_1, float3 otherwise_1)
{
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * rsqrt(max(square_1, 1e-30))) : otherwise_1);
}

float3 normalize_seen(float3 v_2)
{
    const float3 _e5 = normalize_moderate(v_2, float3(0.0, 0.0, 1.0));
    return _e5;
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
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_5) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
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
    const Angle angle_4 = ConstructAngle(turned.x, turned.y);
    return angle_4;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_3 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_3 = (u_2.half_cos + (u_2.half_sin * 0.0));
    float2 upper_1 = ((c_3 <= 0.0) ? float2(1.0, 0.0) : float2(s_3, c_3));
    float2 turned_1 = (((s_3 <= 0.0) & (s_3 < c_3)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_5 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_5;
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
    float t_3 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_1 >= 0.0) ? t_3 : -(t_3));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_shade(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return min(float4((below_1.xyz + (opacity_1 * ((below_1.xyz * lerp((1.0).xxx, color_1.xyz, tone_1)) - below_1.xyz))), 1.0), (1.0).xxxx);
}

float4 blend_shade_2_(float4 below_2, float4 color_2, float tone_2, float opacity_2, bool clamped_2)
{
    return clamp(float4((below_2.xyz + (opacity_2 * ((below_2.xyz * lerp((1.0).xxx, color_2.xyz, tone_2)) - below_2.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_3, float tone_3)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_3.xyz * light.color) * split.y), 1.0), split.x);
    return litlayer;
}

LitLayer light_apply_2_(Light light_1, float4 color_4, float tone_4)
{
    float2 split_1 = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer_1 = ConstructLitLayer(float4((light_1.color * split_1.y), 1.0), (tone_4 * split_1.x));
    return litlayer_1;
}

LitLayer light_apply_3_(Light light_2, float4 color_5, float tone_5)
{
    float2 split_2 = float2(min(light_2.intensity, 1.0), max(light_2.intensity, 1.0));
    const LitLayer litlayer_2 = ConstructLitLayer(float4(((color_5.xyz * light_2.color) * split_2.y), 1.0), (tone_5 * split_2.x));
    return litlayer_2;
}

Angle parametrization_diffuse(Light light_3, float3 normal)
{
    const float3 _e6 = normalize_moderate(normal, float3(0.0, 0.0, 1.0));
    const Angle angle_6 = ConstructAngle((0.5 * length((_e6 - light_3.direction))), (0.5 * length((_e6 + light_3.direction))));
    return angle_6;
}

Angle parametrization_specular(Light light_4, float3 normal_1, float3 view)
{
    float3 mirrored = (((2.0 * dot(normal_1, view)) * normal_1) - view);
    const float3 _e8 = normalize_moderate(mirrored, normal_1);
    const Angle angle_7 = ConstructAngle((0.5 * length((_e8 - light_4.direction))), (0.5 * length((_e8 + light_4.direction))));
    return angle_7;
}

Angle parametrization_screen_aligned(Light light_5, float3 normal_2, float3x3 camera_from_world)
{
    float3 n = mul(normal_2, camera_from_world);
    const float3 _e8 = normalize_moderate(n, float3(0.0, 0.0, 1.0));
    const Angle angle_8 = ConstructAngle((0.5 * length((_e8 - light_5.own_direction))), (0.5 * length((_e8 + light_5.own_direction))));
    return angle_8;
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
    const float _e21 = exp2_stable_2_((exponent * _e19));
    return min(_e21, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape)
{
    float s_4 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
    if (((s_4 <= 0.0) | false)) {
        return 1.0;
    }
    float q_1 = (s_4 * shape.scale);
    const float _e17 = profile_power(q_1, shape.exponent);
    return _e17;
}

float profile_point_2_(Angle u_4, ProfileShape shape_1)
{
    float s_5 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    return (((s_5 <= 0.0) | false) ? 1.0 : ((s_5 <= 4e-7) ? 1.0 : 0.0));
}

float profile_filtered(Angle u_5, float w, ProfileShape shape_2)
{
    const float _e3 = profile_point(u_5, shape_2);
    bool is_wide_1 = (w < (0.1 * shape_2.edge_deviation));
    if (((is_wide_1 | (w <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w >= (3.4641016 * shape_2.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
        const float _e32 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return clamp((0.5 + (((shape_2.offset + shape_2.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
    }
    const float2 _e44 = sin_cos_tiny((0.19364917 * w));
    const Angle _e45 = angle_turned(u_5, _e44);
    const float _e46 = profile_point(_e45, shape_2);
    const Angle _e51 = angle_turned(u_5, float2(-(_e44.x), _e44.y));
    const float _e52 = profile_point(_e51, shape_2);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_2_(Angle u_6, float w_1, ProfileShape shape_3)
{
    const float _e3 = profile_point_2_(u_6, shape_3);
    if (((false | (w_1 <= 0.0)) | false)) {
        return _e3;
    }
    float width_1 = sqrt((w_1 * w_1));
    const float _e15 = atan2_positive(u_6.half_sin, u_6.half_cos);
    return clamp((0.5 + ((shape_3.offset - (2.0 * _e15)) / width_1)), 0.0, 1.0);
}

float profile(Angle angle, float shift, ProfileShape shape_4)
{
    const Angle _e6 = angle_turned_2_(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_5)
{
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_6)
{
    const float2 _e5 = sin_cos_tiny((0.5 * shift_2));
    const Angle _e6 = angle_turned(angle_2, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_6);
    return _e8;
}

float profile_4_(Angle angle_3, float shift_3, ProfileShape shape_7)
{
    const float2 _e5 = sin_cos_eighth((0.5 * shift_3));
    const Angle _e6 = angle_turned(angle_3, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

VectorParts ConstructVectorParts(float arg0, float arg1, float arg2) {
    VectorParts ret = (VectorParts)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

float4 shade(Surface surface_1)
{
    float3 normal_5 = surface_1.normal;
    float3 place = surface_1.position_object;
    float3 from_the_face_s_middle = (place - float3(0.0, 0.52, -0.18));
    float3 flattened = (from_the_face_s_middle * float3(1.0, 0.35, 1.0));
    const float3 _e15 = normalize_or(flattened, (0.0).xxx);
    VectorParts high = ConstructVectorParts(place.x, place.y, place.z);
    float is_face = smoothstep(0.02, 0.16, high.y);
    float3 face_or_body = lerp(normal_5, _e15, is_face);
    const float3 _e27 = normalize_moderate(face_or_body, (0.0).xxx);
    Light _e30 = look.key;
    const Angle _e31 = parametrization_diffuse(_e30, _e27);
    const float _e34 = profile(_e31, 0.0, edge_of_the_shadow_shape);
    float soft_dark = (1.0 - _e34);
    const float4 _e49 = blend_shade(float4(0.9843, 0.8902, 0.8118, 1.0), float4(0.9412, 0.5412, 0.4157, 1.0), soft_dark, 0.55, true);
    const float _e52 = profile_2_(_e31, 0.0, lit_shape);
    float in_shadow = (1.0 - _e52);
    const float4 _e62 = blend_shade_2_(_e49, float4(0.698, 0.4784, 0.6588, 1.0), in_shadow, 0.85, true);
    const float _e65 = curvature_signed(surface_1.kappa, 0.55);
    float inked_hollows_convexity = (0.5 + (0.5 * _e65));
    const float4 _e77 = curvature_color(inked_hollows_convexity, (1.0).xxxx, float4(0.2902, 0.1412, 0.251, 1.0));
    Light _e80 = look.eye;
    const LitLayer _e82 = light_apply(_e80, _e77, 1.0);
    float4 inked_hollows_blend = clamp(float4((_e62.xyz + (0.9 * ((_e62.xyz * (_e82.tone * _e82.color.xyz)) - _e62.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    Light _e104 = look.key;
    const Angle _e107 = parametrization_specular(_e104, surface_1.normal, surface_1.view);
    const float _e110 = curvature_signed(surface_1.kappa, 0.2);
    float rim_light_convexity = (0.5 + (0.5 * _e110));
    float shine_warp = (((2.0 * rim_light_convexity) - 1.0) * 0.05);
    const float _e122 = profile_3_(_e107, shine_warp, shine_tone_shape);
    Light _e125 = look.key;
    const LitLayer _e128 = light_apply_2_(_e125, (1.0).xxxx, _e122);
    const float4 _e133 = blend_alpha(inked_hollows_blend, _e128.color, _e128.tone, 0.85, true);
    float3 _e138 = look.back.direction;
    float3 _e147 = look.back.direction;
    Angle rim_light_angle = ConstructAngle((0.5 * length((surface_1.normal - _e138))), (0.5 * length((surface_1.normal + _e147))));
    float rim_light_warp = (((2.0 * rim_light_convexity) - 1.0) * 0.15);
    const float _e160 = profile_3_(rim_light_angle, rim_light_warp, rim_light_tone_shape);
    Light _e163 = look.back;
    const LitLayer _e169 = light_apply_3_(_e163, float4(1.0, 0.9647, 0.9176, 1.0), _e160);
    const float4 _e174 = blend_alpha(_e133, _e169.color, _e169.tone, 0.9, true);
    Light _e177 = look.eye;
    float3x3 _e181 = look.camera_from_world;
    const Angle _e182 = parametrization_screen_aligned(_e177, surface_1.normal, _e181);
    const float _e185 = curvature_signed(surface_1.kappa, 0.12);
    float contour_convexity = (0.5 + (0.5 * _e185));
    float contour_warp = (((2.0 * contour_convexity) - 1.0) * 0.28);
    const float _e197 = profile_4_(_e182, contour_warp, contour_tone_shape);
    Light _e200 = look.eye;
    const LitLayer _e203 = light_apply_2_(_e200, (1.0).xxxx, _e197);
    float4 output = clamp(float4((_e174.xyz * (_e203.tone * _e203.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    return output;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_1.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_6 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_6;
    float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    surface.position_object = in_.position_object;
    float4 _e29 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e29.x;
    Surface _e31 = surface;
    const float4 _e32 = shade(_e31);
    return _e32;
}
