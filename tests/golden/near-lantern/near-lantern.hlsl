// Near the lantern: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// near-lantern.json says what to put there and how to draw.
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
    float4 back_light_color_convex;
    Light back;
    float4 highlight_color_convex;
    Light key;
    float4 body_color_convex;
    ProfileShape body_tone_shape;
    float4 shadow;
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
static const ProfileShape highlight_tone_shape = ConstructProfileShape(0.9950042, 0.099833414, 6.6917324, 4.960133, 0.2, 0.11088749, 0.05215291, 0u);
static const ProfileShape back_light_tone_shape = ConstructProfileShape(0.9553365, 0.29552022, 5.743557, 2.0104687, 0.6, 0.18576889, 0.077249795, 0u);

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

float4 finite_vec4_(float4 v)
{
    uint4 exponent_3 = (2139095040u).xxxx;
    return (((asuint(v) & exponent_3) != exponent_3) ? v : (0.0).xxxx);
}

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
    float clamped_3 = max(x_1, -126.0);
    float whole_1 = round(clamped_3);
    float f_1 = (clamped_3 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_3_(float x_2)
{
    float whole_2 = round(x_2);
    float f_2 = (x_2 - whole_2);
    float twice_2 = (2.0 + (f_2 * (1.3862944 + (f_2 * (0.48045295 + (f_2 * (0.11100665 + (f_2 * (0.019236874 + (f_2 * (0.002679775 + (f_2 * 0.00030706724))))))))))));
    return (twice_2 * asfloat((uint(asint(asuint(naga_f2i32(whole_2)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_3)
{
    uint bits = asuint(x_3);
    int exponent_4 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_4) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_4) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float2 sin_cos_tiny(float x_4)
{
    float y_2 = (x_4 * x_4);
    float s = (x_4 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334)))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889))))));
    return float2(s, c);
}

float3 normalize_moderate(float3 v_1, float3 otherwise)
{
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * rsqrt(max(square, 1e-30))) : otherwise);
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

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return clamp(mixed, (0.0).xxxx, (1.0).xxxx);
}

float4 blend_alpha(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_1)
{
    float a_1 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_1) * (1.0 - below_1.w)));
    const float4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_1, clamped_1);
    return _e20;
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
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape)
{
    float s_3 = ((u_3.half_sin * shape.half_cos_offset) - (u_3.half_cos * shape.half_sin_offset));
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

float profile_point_2_(Angle u_4, ProfileShape shape_1)
{
    float s_4 = ((u_4.half_sin * shape_1.half_cos_offset) - (u_4.half_cos * shape_1.half_sin_offset));
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

float profile_point_3_(Angle u_5, ProfileShape shape_2)
{
    float s_5 = ((u_5.half_sin * shape_2.half_cos_offset) - (u_5.half_cos * shape_2.half_sin_offset));
    if (((s_5 <= 0.0) | false)) {
        return 1.0;
    }
    float q_5 = (s_5 * shape_2.scale);
    const float _e17 = profile_power_3_(q_5, shape_2.exponent);
    return _e17;
}

float profile_filtered(Angle u_6, float w, ProfileShape shape_3)
{
    const float _e3 = profile_point(u_6, shape_3);
    bool is_wide_1 = (w < (0.1 * shape_3.edge_deviation));
    if (((is_wide_1 | (w <= 0.0)) | (shape_3.kind == PROFILE_AMBIENT))) {
        return _e3;
    }
    if (((shape_3.edge_deviation < 0.145) & (w >= (3.4641016 * shape_3.edge_deviation)))) {
        float width = sqrt(((w * w) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
        const float _e36 = atan2_positive(u_6.half_sin, u_6.half_cos);
        return clamp((0.5 + (((shape_3.offset + shape_3.edge_mean) - (2.0 * _e36)) / width)), 0.0, 1.0);
    }
    const float2 _e48 = sin_cos_tiny((0.19364917 * w));
    const Angle _e49 = angle_turned(u_6, _e48);
    const float _e50 = profile_point(_e49, shape_3);
    const Angle _e55 = angle_turned(u_6, float2(-(_e48.x), _e48.y));
    const float _e56 = profile_point(_e55, shape_3);
    return ((((5.0 * _e50) + (8.0 * _e3)) + (5.0 * _e56)) / 18.0);
}

float profile_filtered_2_(Angle u_7, float w_1, ProfileShape shape_4)
{
    const float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_2 = (w_1 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_2 | (w_1 <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w_1 >= (3.4641016 * shape_4.edge_deviation)))) {
        float width_1 = sqrt(((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
        const float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((shape_4.offset + shape_4.edge_mean) - (2.0 * _e32)) / width_1)), 0.0, 1.0);
    }
    const float2 _e44 = sin_cos_tiny((0.19364917 * w_1));
    const Angle _e45 = angle_turned(u_7, _e44);
    const float _e46 = profile_point_2_(_e45, shape_4);
    const Angle _e51 = angle_turned(u_7, float2(-(_e44.x), _e44.y));
    const float _e52 = profile_point_2_(_e51, shape_4);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile_filtered_3_(Angle u_8, float w_2, ProfileShape shape_5)
{
    const float _e3 = profile_point_3_(u_8, shape_5);
    bool is_wide_3 = (w_2 < (0.1 * shape_5.edge_deviation));
    if (((is_wide_3 | (w_2 <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w_2 >= (3.4641016 * shape_5.edge_deviation)))) {
        float width_2 = sqrt(((w_2 * w_2) + ((12.0 * shape_5.edge_deviation) * shape_5.edge_deviation)));
        const float _e32 = atan2_positive(u_8.half_sin, u_8.half_cos);
        return clamp((0.5 + (((shape_5.offset + shape_5.edge_mean) - (2.0 * _e32)) / width_2)), 0.0, 1.0);
    }
    const float2 _e44 = sin_cos_tiny((0.19364917 * w_2));
    const Angle _e45 = angle_turned(u_8, _e44);
    const float _e46 = profile_point_3_(_e45, shape_5);
    const Angle _e51 = angle_turned(u_8, float2(-(_e44.x), _e44.y));
    const float _e52 = profile_point_3_(_e51, shape_5);
    return ((((5.0 * _e46) + (8.0 * _e3)) + (5.0 * _e52)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_6)
{
    const Angle _e6 = angle_turned_2_(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered(_e6, _e7, shape_6);
    return _e8;
}

float profile_2_(Angle angle_1, float shift_1, ProfileShape shape_7)
{
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_8)
{
    const Angle _e6 = angle_turned_2_(angle_2, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

float4 shade(Surface surface_1)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle body_angle = ConstructAngle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    ProfileShape _e23 = look.body_tone_shape;
    const float _e24 = profile(body_angle, 0.0, _e23);
    Light _e27 = look.key;
    float4 _e30 = look.body_color_convex;
    const LitLayer _e31 = light_apply(_e27, _e30, _e24);
    float4 _e34 = look.shadow;
    float4 _e37 = look.shadow;
    float4 _e44 = look.shadow;
    float _e52 = look.shadow.w;
    float _e60 = look.shadow.w;
    const float4 _e68 = blend_finish(_e34, (_e37.xyz + (_e31.tone * (_e31.color.xyz - _e44.xyz))), (_e52 + ((_e31.tone * _e31.color.w) * (1.0 - _e60))), _e31.color.w, true);
    Light _e71 = look.key;
    const Angle _e74 = parametrization_specular(_e71, surface_1.normal, surface_1.view);
    const float _e77 = profile_2_(_e74, 0.0, highlight_tone_shape);
    Light _e80 = look.key;
    float4 _e83 = look.highlight_color_convex;
    const LitLayer _e84 = light_apply(_e80, _e83, _e77);
    const float4 _e89 = blend_alpha(_e68, _e84.color, _e84.tone, 0.9, true);
    float3 _e94 = look.back.direction;
    float3 _e103 = look.back.direction;
    Angle back_light_angle = ConstructAngle((0.5 * length((surface_1.normal - _e94))), (0.5 * length((surface_1.normal + _e103))));
    const float _e111 = profile_3_(back_light_angle, 0.0, back_light_tone_shape);
    Light _e114 = look.back;
    float4 _e117 = look.back_light_color_convex;
    const LitLayer _e118 = light_apply(_e114, _e117, _e111);
    const float4 _e129 = blend_finish(_e89, (_e89.xyz + (_e118.tone * _e118.color.xyz)), _e89.w, _e118.color.w, true);
    const float4 _e140 = finite_vec4_(((_e129.w <= 0.0) ? _e129 : float4((_e129.xyz / (_e129.w).xxx), _e129.w)));
    return _e140;
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
    const float4 _e23 = finite_vec4_(_e22);
    return _e23;
}
