// Drawn, for contrast: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// material-drawn.json says what to put there and how to draw.
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
    Light back;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _end_pad_0;
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
static const ProfileShape body_tone_shape = ConstructProfileShape(0.86532396, 0.501213, 5.743557, 2.0104687, 1.05, 0.18576889, 0.077249795, 0u);
static const ProfileShape window_tone_shape = ConstructProfileShape(0.9887711, 0.14943813, 50.003334, 8.498813, 0.3, 0.011653547, 0.0057055796, 0u);
static const ProfileShape rim_tone_shape = ConstructProfileShape(0.9305076, 0.36627254, 10.016686, 2.4912605, 0.75, 0.09820393, 0.042312488, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

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
    float whole = round(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_2_(float x_1)
{
    float clamped_1 = max(x_1, -126.0);
    float whole_1 = round(clamped_1);
    float f_1 = (clamped_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_2)
{
    uint bits = asuint(x_2);
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

float2 sin_cos_tiny(float x_3)
{
    float y_2 = (x_3 * x_3);
    float s = (x_3 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334)))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889))))));
    return float2(s, c);
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

float atan2_positive(float y_1, float x_4)
{
    float small = min(y_1, x_4);
    float large = max(y_1, x_4);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_1 > x_4) ? (HALF_PI - a) : a);
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
    float s_1 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_1, c_1));
    float2 turned = (((s_1 <= 0.0) & (s_1 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_2 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_2 = (u_2.half_cos + (u_2.half_sin * 0.0));
    float2 upper_1 = ((c_2 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_2));
    float2 turned_1 = (((s_2 <= 0.0) & (s_2 < c_2)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_4 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_4;
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_1, float tone_1)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
    return litlayer;
}

Angle parametrization_specular(Light light_1, float3 normal, float3 view)
{
    float3 mirrored = (((2.0 * dot(normal, view)) * normal) - view);
    const float3 _e8 = normalize_moderate(mirrored, normal);
    const Angle angle_5 = ConstructAngle((0.5 * length((_e8 - light_1.direction))), (0.5 * length((_e8 + light_1.direction))));
    return angle_5;
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
    return min(_e21, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape)
{
    float s_3 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
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
    const float _e21 = exp2_stable_2_((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point_2_(Angle u_4, ProfileShape shape_1)
{
    float s_4 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
    if (((s_4 <= 0.0) | false)) {
        return 1.0;
    }
    float q_3 = (s_4 * shape_1.scale);
    const float _e17 = profile_power_2_(q_3, shape_1.exponent);
    return _e17;
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
    bool is_wide_2 = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide_2 | (w_1 <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w_1 >= (3.4641016 * shape_3.edge_deviation)))) {
        float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        const float _e32 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e32)) / width_1)), 0.0, 1.0);
    }
    const float2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    const Angle _e45 = angle_turned(u_6, _e44);
    const float _e46 = profile_point_2_(_e45, shape_3);
    const Angle _e51 = angle_turned(u_6, float2(-(_e44.x), _e44.y));
    const float _e52 = profile_point_2_(_e51, shape_3);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_3_(Angle u_7, float w_2, ProfileShape shape_4)
{
    const float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_3 = (w_2 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_3 | (w_2 <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w_2 >= (3.4641016 * shape_4.edge_deviation)))) {
        float width_2 = sqrt(((w_2 * w_2) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
        const float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((0.75 + shape_4.edge_mean) - (2.0 * _e32)) / width_2)), 0.0, 1.0);
    }
    const float2 _e44 = sin_cos_tiny((0.19364917 * w_2));
    const Angle _e45 = angle_turned(u_7, _e44);
    const float _e46 = profile_point_2_(_e45, shape_4);
    const Angle _e51 = angle_turned(u_7, float2(-(_e44.x), _e44.y));
    const float _e52 = profile_point_2_(_e51, shape_4);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_5)
{
    const Angle _e6 = angle_turned_2_(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered(_e6, _e7, shape_5);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_6)
{
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_6);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_7)
{
    const Angle _e6 = angle_turned_2_(angle_2, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_3_(_e6, _e7, shape_7);
    return _e8;
}

float4 shade(Surface surface_1)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle body_angle = ConstructAngle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    const float _e22 = profile(body_angle, 0.0, body_tone_shape);
    Light _e25 = look.key;
    const LitLayer _e31 = light_apply(_e25, float4(0.2471, 0.4863, 0.7686, 1.0), _e22);
    const float4 _e41 = blend_alpha(float4(0.1333, 0.1882, 0.3098, 1.0), _e31.color, _e31.tone, 1.0, true);
    Light _e44 = look.key;
    const Angle _e47 = parametrization_specular(_e44, surface_1.normal, surface_1.view);
    const float _e50 = profile_2_(_e47, 0.0, window_tone_shape);
    Light _e53 = look.key;
    const LitLayer _e59 = light_apply(_e53, float4(0.9686, 0.9843, 1.0, 1.0), _e50);
    float4 window_blend = clamp(float4((_e41.xyz + (_e59.tone * (_e59.color.xyz - _e41.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    float3 _e79 = look.back.direction;
    float3 _e88 = look.back.direction;
    Angle rim_angle = ConstructAngle((0.5 * length((surface_1.normal - _e79))), (0.5 * length((surface_1.normal + _e88))));
    const float _e96 = profile_3_(rim_angle, 0.0, rim_tone_shape);
    Light _e99 = look.back;
    const LitLayer _e105 = light_apply(_e99, float4(0.2314, 0.3725, 0.5255, 1.0), _e96);
    float4 output = clamp(float4((window_blend.xyz + (_e105.tone * _e105.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
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
    Surface _e21 = surface;
    const float4 _e22 = shade(_e21);
    return _e22;
}
