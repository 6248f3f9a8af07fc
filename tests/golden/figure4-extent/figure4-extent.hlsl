// Curvature in the extent: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// figure4-extent.json says what to put there and how to draw.
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
    float4 fill_blend;
};

struct Surface {
    float3 normal;
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
    float3 normal : LOC0;
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

static const float LOG2_E = 1.442695;
static const ProfileShape diffuse_tone_shape = ConstructProfileShape(0.9921977, 0.12467473, 1.6002629, 1.3188459, 0.25, 0.79761744, 0.31569642, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 normal : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 normal_1 : LOC0;
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
    float y_1 = (x_3 * x_3);
    float s = (x_3 * (1.0 + (y_1 * (-0.16666667 + (y_1 * (0.008333334 + (y_1 * (-0.0001984127 + (y_1 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * (0.0013888889 + (y_1 * (-2.4801588e-5 + (y_1 * 2.755732e-7))))))))));
    return float2(s, c);
}

float2 sin_cos_tiny(float x_4)
{
    float y_2 = (x_4 * x_4);
    float s_1 = (x_4 * (1.0 + (y_2 * (-0.16666667 + (y_2 * 0.008333334)))));
    float c_1 = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * 0.0013888889))))));
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

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
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
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
}

float curvature_signed(float kappa, float slope)
{
    float a = ((((asuint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope);
    float magnitude = min(abs(a), 50.0);
    if ((magnitude < 0.0625)) {
        float a2_ = (a * a);
        return (a * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e32 = exp2_stable((-2.88539 * magnitude));
    float t_1 = ((1.0 - _e32) / (1.0 + _e32));
    return ((a >= 0.0) ? t_1 : -(t_1));
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
    const LitLayer litlayer = ConstructLitLayer(float4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
    return litlayer;
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
    float q_1 = (s_3 * shape.scale);
    const float _e17 = profile_power(q_1, shape.exponent);
    return _e17;
}

float profile_filtered(Angle u_3, float w, ProfileShape shape_1)
{
    const float _e3 = profile_point(u_3, shape_1);
    bool is_wide = (w < (0.1 * shape_1.edge_deviation));
    if (((is_wide | (w <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w));
    const Angle _e16 = angle_turned(u_3, _e15);
    const float _e17 = profile_point(_e16, shape_1);
    const Angle _e22 = angle_turned(u_3, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point(_e22, shape_1);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_2)
{
    const float2 _e5 = sin_cos_eighth((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered(_e6, _e7, shape_2);
    return _e8;
}

float4 shade(Surface surface_1)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle diffuse_angle = ConstructAngle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    const float _e22 = curvature_signed(surface_1.kappa, 0.3);
    float diffuse_convexity = (0.5 + (0.5 * _e22));
    float diffuse_warp = (((2.0 * diffuse_convexity) - 1.0) * 0.75);
    const float _e34 = profile(diffuse_angle, diffuse_warp, diffuse_tone_shape);
    Light _e37 = look.key;
    const LitLayer _e43 = light_apply(_e37, float4(0.6275, 0.4157, 0.2902, 1.0), _e34);
    float4 _e46 = look.fill_blend;
    float4 output = clamp(float4((_e46.xyz + (_e43.tone * _e43.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    return output;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view.clip_from_world;
    out_.clip_ = mul(world, _e12);
    float3x3 _e17 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e17);
    Varyings _e20 = out_;
    const Varyings varyings = _e20;
    const VertexOutput_vs_main varyings_1 = { varyings.normal, varyings.clip_ };
    return varyings_1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_2;
    float4 _e14 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e14.x;
    Surface _e16 = surface;
    const float4 _e17 = shade(_e16);
    return _e17;
}
