// Dual lighting, soft: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// figure6-dual-soft.json says what to put there and how to draw.
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
    Light warm;
    Light cool;
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
static const ProfileShape warm_side_tone_shape = ConstructProfileShape(0.9971888, 0.07492971, 1.3940078, 1.4345639, 0.15, 0.90231395, 0.36981526, 0u);
static const ProfileShape cool_side_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.5079876, 1.4054453, 0.1, 0.83293223, 0.33645248, 0u);
static const ProfileShape sheen_tone_shape = ConstructProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);

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
    float clamped = clamp(x, -126.0, 127.99999);
    float whole = round(clamped);
    float f = (clamped - whole);
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
    float clamped_1 = max(x_2, -126.0);
    float whole_2 = round(clamped_1);
    float f_2 = (clamped_1 - whole_2);
    float twice_2 = (2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724))))))))))));
    return (twice_2 * asfloat((uint(asint(asuint(naga_f2i32(whole_2)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_3)
{
    uint bits = asuint(x_3);
    int exponent_2 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_2) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed(float kappa, float slope)
{
    float a_1 = ((((asuint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * 0.25);
    float magnitude = min(abs(a_1), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a_1 * a_1);
        return (a_1 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e33 = exp2_stable((-2.88539 * magnitude));
    float t_2 = ((1.0 - _e33) / (1.0 + _e33));
    return ((a_1 >= 0.0) ? t_2 : -(t_2));
}

float curvature_signed_2_(float kappa_1, float slope_1)
{
    float a_2 = ((((asuint(kappa_1) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa_1, -10000.0, 10000.0)) * slope_1);
    float magnitude_1 = min(abs(a_2), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_1 = (a_2 * a_2);
        return (a_2 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254)))))));
    }
    const float _e32 = exp2_stable((-2.88539 * magnitude_1));
    float t_3 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a_2 >= 0.0) ? t_3 : -(t_3));
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color, float tone)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color.xyz * light.color) * split.y), 1.0), split.x);
    return litlayer;
}

LitLayer light_apply_2_(Light light_1, float4 color_1, float tone_1)
{
    float2 split_1 = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer_1 = ConstructLitLayer(float4(((color_1.xyz * light_1.color) * split_1.y), 1.0), (tone_1 * split_1.x));
    return litlayer_1;
}

Angle parametrization_specular(Light light_2, float3 normal, float3 view)
{
    float3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    const float3 _e8 = normalize_moderate(mirrored, normal);
    const Angle angle_3 = ConstructAngle((0.5 * length((_e8 - light_2.direction))), (0.5 * length((_e8 + light_2.direction))));
    return angle_3;
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

float profile_point(Angle u_2, ProfileShape shape)
{
    float s_3 = ((u_2.half_sin * shape.half_cos_offset) - (u_2.half_cos * shape.half_sin_offset));
    if (((s_3 <= 0.0) | false)) {
        return 1.0;
    }
    float q_2 = (s_3 * shape.scale);
    const float _e17 = profile_power(q_2, shape.exponent);
    return _e17;
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
    const float _e21 = exp2_stable_3_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_3, ProfileShape shape_1)
{
    float s_4 = ((u_3.half_sin * shape_1.half_cos_offset) - (u_3.half_cos * shape_1.half_sin_offset));
    if (((s_4 <= 0.0) | false)) {
        return 1.0;
    }
    float q_3 = (s_4 * shape_1.scale);
    const float _e17 = profile_power_2_(q_3, shape_1.exponent);
    return _e17;
}

float profile_filtered(Angle u_4, float w, ProfileShape shape_2)
{
    const float _e3 = profile_point(u_4, shape_2);
    bool is_wide_1 = (w < (0.1 * shape_2.edge_deviation));
    if (((is_wide_1 | (w <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w));
    const Angle _e16 = angle_turned(u_4, _e15);
    const float _e17 = profile_point(_e16, shape_2);
    const Angle _e22 = angle_turned(u_4, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point(_e22, shape_2);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_2_(Angle u_5, float w_1, ProfileShape shape_3)
{
    const float _e3 = profile_point_2_(u_5, shape_3);
    bool is_wide_2 = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide_2 | (w_1 <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w_1 >= (3.4641016 * shape_3.edge_deviation)))) {
        float width = sqrt(((w_1 * w_1) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        const float _e32 = atan2_positive(u_5.half_sin, u_5.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
    }
    const float2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    const Angle _e45 = angle_turned(u_5, _e44);
    const float _e46 = profile_point_2_(_e45, shape_3);
    const Angle _e51 = angle_turned(u_5, float2(-(_e44.x), _e44.y));
    const float _e52 = profile_point_2_(_e51, shape_3);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_4)
{
    const float2 _e5 = sin_cos_eighth((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered(_e6, _e7, shape_4);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_5)
{
    const float2 _e5 = sin_cos_tiny((0.5 * shift_1));
    const Angle _e6 = angle_turned(angle_1, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_5);
    return _e8;
}

float4 shade(Surface surface_1)
{
    const float _e3 = curvature_signed(surface_1.kappa, 0.25);
    float fill_convexity = (0.5 + (0.5 * _e3));
    const float4 _e18 = curvature_color(fill_convexity, float4(0.1137, 0.0941, 0.1333, 1.0), float4(0.0392, 0.0314, 0.0549, 1.0));
    Light _e21 = look.warm;
    const LitLayer _e23 = light_apply(_e21, _e18, 1.0);
    float4 fill_blend = clamp(float4((float3(0.051, 0.0431, 0.0706) + (_e23.tone * _e23.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float _e42 = curvature_signed_2_(surface_1.kappa, 0.22);
    float cool_side_convexity = (0.5 + (0.5 * _e42));
    const float4 _e57 = curvature_color(cool_side_convexity, float4(0.851, 0.5451, 0.3059, 1.0), float4(0.4784, 0.1843, 0.1333, 1.0));
    float3 _e62 = look.warm.direction;
    float3 _e71 = look.warm.direction;
    Angle warm_side_angle = ConstructAngle((0.5 * length((surface_1.normal - _e62))), (0.5 * length((surface_1.normal + _e71))));
    float warm_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.3);
    const float _e84 = profile(warm_side_angle, warm_side_warp, warm_side_tone_shape);
    Light _e87 = look.warm;
    const LitLayer _e88 = light_apply_2_(_e87, _e57, _e84);
    float4 warm_side_blend = clamp(float4((fill_blend.xyz + (_e88.tone * _e88.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float4 _e112 = curvature_color(cool_side_convexity, float4(0.3098, 0.498, 0.7216, 1.0), float4(0.1098, 0.1922, 0.3412, 1.0));
    float3 _e117 = look.cool.direction;
    float3 _e126 = look.cool.direction;
    Angle cool_side_angle = ConstructAngle((0.5 * length((surface_1.normal - _e117))), (0.5 * length((surface_1.normal + _e126))));
    float cool_side_warp = (((2.0 * cool_side_convexity) - 1.0) * 0.25);
    const float _e139 = profile(cool_side_angle, cool_side_warp, cool_side_tone_shape);
    Light _e142 = look.cool;
    const LitLayer _e143 = light_apply_2_(_e142, _e112, _e139);
    float4 cool_side_blend = clamp(float4((warm_side_blend.xyz + (_e143.tone * _e143.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float _e159 = curvature_signed_2_(surface_1.kappa, 0.2);
    float sheen_convexity = (0.5 + (0.5 * _e159));
    const float4 _e174 = curvature_color(sheen_convexity, float4(0.4196, 0.3176, 0.2196, 1.0), float4(0.2, 0.1373, 0.1098, 1.0));
    Light _e177 = look.warm;
    const Angle _e180 = parametrization_specular(_e177, surface_1.normal, surface_1.view);
    float sheen_warp = (((2.0 * sheen_convexity) - 1.0) * 0.1);
    const float _e188 = profile_2_(_e180, sheen_warp, sheen_tone_shape);
    Light _e191 = look.warm;
    const LitLayer _e192 = light_apply_2_(_e191, _e174, _e188);
    float4 output = clamp(float4((cool_side_blend.xyz + (_e192.tone * _e192.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
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
