// Travel poster: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// travel-poster.json says what to put there and how to draw.
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
    Light sky;
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

struct Ramp {
    float4 colors[16];
    float4 places[4];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
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

typedef float4 ret_Constructarray16_float4_[16];
ret_Constructarray16_float4_ Constructarray16_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3, float4 arg4, float4 arg5, float4 arg6, float4 arg7, float4 arg8, float4 arg9, float4 arg10, float4 arg11, float4 arg12, float4 arg13, float4 arg14, float4 arg15) {
    float4 ret[16] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10, arg11, arg12, arg13, arg14, arg15 };
    return ret;
}

typedef float4 ret_Constructarray4_float4_[4];
ret_Constructarray4_float4_ Constructarray4_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3) {
    float4 ret[4] = { arg0, arg1, arg2, arg3 };
    return ret;
}

Ramp ConstructRamp(float4 arg0[16], float4 arg1[4], uint arg2, uint arg3) {
    Ramp ret = (Ramp)0;
    ret.colors = arg0;
    ret.places = arg1;
    ret.count = arg2;
    ret.interpolation = arg3;
    return ret;
}

static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape evening_sun_tone_shape = ConstructProfileShape(1.0, 0.0, 1.0955735, 1.6395584, 0.0, 1.1385497, 0.5052584, 0u);
static const ProfileShape sky_tone_shape = ConstructProfileShape(1.0, 0.0, 1.229384, 1.2860026, 0.0, 1.0836705, 0.44442755, 0u);
static const ProfileShape glow_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 2.425296, 2.5857167, 0.1, 0.4039123, 0.17722374, 0u);
static const Ramp seven_inks = ConstructRamp(Constructarray16_float4_(float4(0.0863, 0.1333, 0.2471, 1.0), float4(0.1725, 0.3176, 0.3882, 1.0), float4(0.4863, 0.2275, 0.2706, 1.0), float4(0.7686, 0.3294, 0.2471, 1.0), float4(0.8784, 0.5412, 0.298, 1.0), float4(0.9412, 0.7608, 0.4824, 1.0), float4(0.9843, 0.9333, 0.7961, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.15, 0.3, 0.45), float4(0.6, 0.8, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx), 7u, 0u);

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

float2 sin_cos_tiny(float x_3)
{
    float y_1 = (x_3 * x_3);
    float s = (x_3 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334)))));
    float c = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889))))));
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

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
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
    float s_2 = (u_2.half_sin - 0.0);
    float2 upper_1 = ((u_2.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_2, u_2.half_cos));
    float2 turned_1 = (((s_2 <= 0.0) & (s_2 < u_2.half_cos)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_4 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_4;
}

float powered(float base, float exponent)
{
    float magnitude = abs(base);
    const float _e5 = log2_stable(max(magnitude, SMALLEST_NORMAL));
    const float _e7 = exp2_stable((exponent * _e5));
    return ((magnitude < SMALLEST_NORMAL) ? 0.0 : _e7);
}

float footprint_of(float x_4)
{
    float _e1 = ddx(x_4);
    float _e2 = ddy(x_4);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float stairs_integral(float x_5, float count)
{
    float inside = min(x_5, count);
    float stair = min(floor(inside), 6.0);
    float beyond = max((x_5 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 6.0));
}

float stairs_integral_2_(float x_6, float count_1)
{
    float inside_1 = max(x_6, 0.0);
    float stair_1 = floor(inside_1);
    return ((stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0);
}

float stairs_filtered(float x_7, float count_2, float w)
{
    if ((w <= 1.0)) {
        float edge = clamp(round(x_7), 1.0, 6.0);
        return ((edge - 1.0) + clamp((0.5 + ((x_7 - edge) / w)), 0.0, 1.0));
    }
    float half_1 = (0.5 * w);
    const float _e22 = stairs_integral((x_7 + half_1), count_2);
    const float _e24 = stairs_integral_2_((x_7 - half_1), count_2);
    return ((_e22 - _e24) / (2.0 * half_1));
}

float linear_of_srgb(float coded)
{
    float size = abs(coded);
    const float _e6 = log2_stable(((size + 0.055) / 1.055));
    const float _e9 = exp2_stable((2.4 * _e6));
    float value = ((size <= 0.04045) ? (size / 12.92) : _e9);
    return value;
}

float linear_of_srgb_2_(float coded_1)
{
    float size_1 = abs(coded_1);
    float value_1 = ((size_1 <= 0.04045) ? (size_1 / 12.92) : pow(((size_1 + 0.055) / 1.055), 2.4));
    return value_1;
}

float srgb_of_linear(float light)
{
    float size_2 = abs(light);
    const float _e3 = powered(size_2, 0.41666666);
    float value_2 = ((size_2 <= 0.0031308) ? (size_2 * 12.92) : ((1.055 * _e3) - 0.055));
    return ((light < 0.0) ? -(value_2) : value_2);
}

float3 oklab_of_linear(float3 rgb)
{
    const float _e8 = powered(abs(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    const float _e16 = powered(abs(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    const float _e24 = powered(abs(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return float3((((0.21045426 * _e8) + (0.7936178 * _e16)) - (0.004072047 * _e24)), (((1.9779985 * _e8) - (2.4285922 * _e16)) + (0.4505937 * _e24)), (((0.025904037 * _e8) + (0.78277177 * _e16)) - (0.80867577 * _e24)));
}

float3 oklab_of_linear_2_(float3 rgb_1)
{
    float l = pow(abs(dot(rgb_1, float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float m = pow(abs(dot(rgb_1, float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float s_3 = pow(abs(dot(rgb_1, float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return float3((((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s_3)), (((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s_3)), (((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s_3)));
}

float3 oklab_of_linear_3_(float3 rgb_2)
{
    float l_1 = pow(dot(rgb_2, float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m_1 = pow(dot(rgb_2, float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s_4 = pow(dot(rgb_2, float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return float3((((0.21045426 * l_1) + (0.7936178 * m_1)) - (0.004072047 * s_4)), (((1.9779985 * l_1) - (2.4285922 * m_1)) + (0.4505937 * s_4)), (((0.025904037 * l_1) + (0.78277177 * m_1)) - (0.80867577 * s_4)));
}

float3 linear_of_oklab(float3 lab)
{
    float l_2 = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m_2 = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s_5 = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    float3 cubes = float3(((l_2 * l_2) * l_2), ((m_2 * m_2) * m_2), ((s_5 * s_5) * s_5));
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

float3 oklab_of_srgb(float3 coded_2)
{
    const float3 _e23 = oklab_of_linear_3_(float3(pow(((coded_2.x + 0.055) / 1.055), 2.4), pow(((coded_2.y + 0.055) / 1.055), 2.4), pow(((coded_2.z + 0.055) / 1.055), 2.4)));
    return _e23;
}

float3 srgb_of_oklab(float3 lab_1)
{
    const float3 _e1 = linear_of_oklab(lab_1);
    const float _e3 = srgb_of_linear(_e1.x);
    const float _e5 = srgb_of_linear(_e1.y);
    const float _e7 = srgb_of_linear(_e1.z);
    return float3(_e3, _e5, _e7);
}

float3 palette_blend(Ramp palette, float3 rgb_3, float softness)
{
    float4 colors[16] = (float4[16])0;
    uint i = 0u;
    float3 found = (0.0).xxx;
    float nearest = 1e30;

    colors = palette.colors;
    const float _e6 = linear_of_srgb_2_(rgb_3.x);
    const float _e8 = linear_of_srgb_2_(rgb_3.y);
    const float _e10 = linear_of_srgb_2_(rgb_3.z);
    const float3 _e12 = oklab_of_linear_2_(float3(_e6, _e8, _e10));
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e43 = i;
            i = (_e43 + 1u);
        }
        loop_init = false;
        uint _e20 = i;
        if (!((_e20 < 7u))) {
            break;
        }
        uint _e24 = i;
        float4 _e26 = colors[min(uint(_e24), 15u)];
        const float3 _e28 = oklab_of_srgb(_e26.xyz);
        float far = min(length((_e28 - _e12)), 1e29);
        float3 _e33 = found;
        uint _e34 = i;
        float4 _e36 = colors[min(uint(_e34), 15u)];
        float _e38 = nearest;
        found = ((far < _e38) ? _e36.xyz : _e33);
        float _e41 = nearest;
        nearest = min(_e41, far);
    }
    float3 _e46 = found;
    return _e46;
}

float4 posterize_lightness(float4 color, int steps, float softness_1)
{
    const float _e4 = linear_of_srgb(color.x);
    const float _e6 = linear_of_srgb(color.y);
    const float _e8 = linear_of_srgb(color.z);
    const float3 _e10 = oklab_of_linear(float3(_e4, _e6, _e8));
    const float _e19 = footprint_of(_e10.x);
    const float _e24 = stairs_filtered((7.0 * clamp(_e10.x, 0.0, 1.0)), 7.0, length(float2((7.0 * _e19), softness_1)));
    float stepped = clamp((_e24 / 6.0), 0.0, 1.0);
    float kept = ((_e10.x > 0.0001) ? (stepped / max(_e10.x, 0.0001)) : 0.0);
    const float3 _e44 = srgb_of_oklab(float3(stepped, (_e10.yz * min(kept, 1.0))));
    return float4(clamp(_e44, (0.0).xxx, (1.0).xxx), 1.0);
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float4 blend_add(float4 below, float4 color_1, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (tone * color_1.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light_1, float4 color_2, float tone_1)
{
    float2 split = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_2.xyz * light_1.color) * split.y), 1.0), (tone_1 * split.x));
    return litlayer;
}

Angle parametrization_specular_balanced(Light light_2, float3 normal, float3 view)
{
    float3 d_1 = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_5 = ConstructAngle((0.5 * length((d_1 - light_2.direction))), (0.5 * length((d_1 + light_2.direction))));
    return angle_5;
}

float profile_power(float q, float exponent_1)
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
    const float _e21 = exp2_stable((exponent_1 * _e19));
    return min(_e21, 1.0);
}

float profile_point(Angle u_3, ProfileShape shape)
{
    float s_6 = (u_3.half_sin - (u_3.half_cos * 0.0));
    if (((s_6 <= 0.0) | false)) {
        return 1.0;
    }
    float q_2 = (s_6 * shape.scale);
    const float _e15 = profile_power(q_2, shape.exponent);
    return _e15;
}

float profile_point_2_(Angle u_4, ProfileShape shape_1)
{
    float s_7 = (u_4.half_sin - 0.0);
    if (((s_7 <= 0.0) | false)) {
        return 1.0;
    }
    float q_3 = (s_7 * shape_1.scale);
    const float _e13 = profile_power(q_3, shape_1.exponent);
    return _e13;
}

float profile_power_2_(float q_1, float exponent_2)
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
    const float _e21 = exp2_stable_2_((exponent_2 * _e19));
    return min(_e21, 1.0);
}

float profile_point_3_(Angle u_5, ProfileShape shape_2)
{
    float s_8 = ((u_5.half_sin * shape_2.half_cos_offset) - (u_5.half_cos * shape_2.half_sin_offset));
    if (((s_8 <= 0.0) | false)) {
        return 1.0;
    }
    float q_4 = (s_8 * shape_2.scale);
    const float _e17 = profile_power_2_(q_4, shape_2.exponent);
    return _e17;
}

float profile_filtered(Angle u_6, float w_1, ProfileShape shape_3)
{
    const float _e3 = profile_point(u_6, shape_3);
    bool is_wide = (w_1 < (0.1 * shape_3.edge_deviation));
    if (((is_wide | (w_1 <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w_1));
    const Angle _e16 = angle_turned(u_6, _e15);
    const float _e17 = profile_point(_e16, shape_3);
    const Angle _e22 = angle_turned(u_6, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point(_e22, shape_3);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_2_(Angle u_7, float w_2, ProfileShape shape_4)
{
    const float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_1 = (w_2 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_1 | (w_2 <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w_2));
    const Angle _e16 = angle_turned(u_7, _e15);
    const float _e17 = profile_point_2_(_e16, shape_4);
    const Angle _e22 = angle_turned(u_7, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point(_e22, shape_4);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_3_(Angle u_8, float w_3, ProfileShape shape_5)
{
    const float _e3 = profile_point_3_(u_8, shape_5);
    bool is_wide_2 = (w_3 < (0.1 * shape_5.edge_deviation));
    if (((is_wide_2 | (w_3 <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w_3));
    const Angle _e16 = angle_turned(u_8, _e15);
    const float _e17 = profile_point_3_(_e16, shape_5);
    const Angle _e22 = angle_turned(u_8, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point_3_(_e22, shape_5);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_6)
{
    const float2 _e5 = sin_cos_tiny((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
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

float4 shade(Surface surface)
{
    float evening_sun_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.12), -20.0, 20.0))))))));
    const float4 _e30 = curvature_color(evening_sun_convexity, float4(0.93, 0.62, 0.36, 1.0), float4(0.66, 0.24, 0.24, 1.0));
    float3 _e35 = look.key.direction;
    float3 _e44 = look.key.direction;
    Angle evening_sun_angle = ConstructAngle((0.5 * length((surface.normal - _e35))), (0.5 * length((surface.normal + _e44))));
    float evening_sun_warp = (((2.0 * evening_sun_convexity) - 1.0) * 0.1);
    const float _e57 = profile(evening_sun_angle, evening_sun_warp, evening_sun_tone_shape);
    Light _e60 = look.key;
    const LitLayer _e61 = light_apply(_e60, _e30, _e57);
    const float4 _e71 = blend_add(float4(0.07, 0.1, 0.22, 1.0), _e61.color, _e61.tone, 1.0, true);
    float3 _e76 = look.sky.direction;
    float3 _e85 = look.sky.direction;
    Angle sky_angle = ConstructAngle((0.5 * length((surface.normal - _e76))), (0.5 * length((surface.normal + _e85))));
    const float _e93 = profile_2_(sky_angle, 0.0, sky_tone_shape);
    Light _e96 = look.sky;
    const LitLayer _e102 = light_apply(_e96, float4(0.02, 0.24, 0.3, 1.0), _e93);
    const float4 _e107 = blend_add(_e71, _e102.color, _e102.tone, 1.0, true);
    Light _e110 = look.key;
    const Angle _e113 = parametrization_specular_balanced(_e110, surface.normal, surface.view);
    const float _e116 = profile_3_(_e113, 0.0, glow_tone_shape);
    Light _e119 = look.key;
    const LitLayer _e125 = light_apply(_e119, float4(0.42, 0.38, 0.24, 1.0), _e116);
    const float4 _e130 = blend_add(_e107, _e125.color, _e125.tone, 1.0, true);
    const float4 _e133 = posterize_lightness(_e130, int(7), 0.02);
    const float3 _e137 = palette_blend(seven_inks, _e133.xyz, 0.0);
    float4 seven_inks_2_ = float4(_e137, 1.0);
    return seven_inks_2_;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.normal = arg2;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_1.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.kappa = arg2;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e23 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x);
    const float4 _e26 = shade(surface_1);
    return _e26;
}
