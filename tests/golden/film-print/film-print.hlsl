// Film print: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// film-print.json says what to put there and how to draw.
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

struct Curve {
    float4 points[16];
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

Curve ConstructCurve(float4 arg0[16], uint arg1, uint arg2) {
    Curve ret = (Curve)0;
    ret.points = arg0;
    ret.count = arg1;
    ret.interpolation = arg2;
    return ret;
}

static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape tone_shape = ConstructProfileShape(1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107, 0.63535863, 0u);
static const Curve response_of_the_film = ConstructCurve(Constructarray16_float4_(float4(0.0, 0.0, 0.2, 0.0), float4(0.3, 0.06, 0.36, 0.0), float4(0.5, 0.42, 0.972973, 0.0), float4(0.62, 0.5, 1.0256411, 0.0), float4(0.8, 0.9, 0.81632656, 0.0), float4(1.0, 1.0, 0.5, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 6u, 1u);
static const ProfileShape sheen_tone_shape = ConstructProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368, 0.13399889, 0u);
static const ProfileShape back_light_tone_shape = ConstructProfileShape(0.9689124, 0.24740396, 4.0419726, 1.8505588, 0.5, 0.27256957, 0.11186968, 0u);
static const Curve film_print = ConstructCurve(Constructarray16_float4_(float4(0.0, 0.04, 0.64, 0.0), float4(0.25, 0.2, 0.8608187, 0.0), float4(0.6, 0.66, 0.97504276, 0.0), float4(1.0, 0.97, 0.775, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 4u, 1u);
static const Curve film_print_2_ = ConstructCurve(Constructarray16_float4_(float4(0.0, 0.0, 0.73333335, 0.0), float4(0.3, 0.22, 0.99215686, 0.0), float4(0.6, 0.68, 1.0514286, 0.0), float4(1.0, 1.0, 0.8, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 4u, 1u);
static const Curve film_print_3_ = ConstructCurve(Constructarray16_float4_(float4(0.0, 0.06, 0.8333333, 0.0), float4(0.3, 0.31, 0.8805031, 0.0), float4(0.6, 0.59, 0.91636366, 0.0), float4(1.0, 0.95, 0.9, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 4u, 1u);
static const Curve film_print_4_ = ConstructCurve(Constructarray16_float4_(float4(0.0, 0.13, 0.8, 0.0), float4(0.3, 0.37, 0.53333336, 0.0), float4(0.6, 0.49, 0.51555556, 0.0), float4(1.0, 0.78, 0.725, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 4u, 1u);

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

float log2_stable(float x_1)
{
    uint bits = asuint(x_1);
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

float2 sin_cos_tiny(float x_2)
{
    float y_1 = (x_2 * x_2);
    float s_2 = (x_2 * (1.0 + (y_1 * (-0.16666667 + (y_1 * 0.008333334)))));
    float c = (1.0 - (y_1 * (0.5 + (y_1 * (-0.041666668 + (y_1 * 0.0013888889))))));
    return float2(s_2, c);
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
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_3, c_1));
    float2 turned = (((s_3 <= 0.0) & (s_3 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_4 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_2 = (u_2.half_cos + (u_2.half_sin * 0.0));
    float2 upper_1 = ((c_2 <= 0.0) ? float2(1.0, 0.0) : float2(s_4, c_2));
    float2 turned_1 = (((s_4 <= 0.0) & (s_4 < c_2)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_3 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_3;
}

Angle angle_turned_3_(Angle u_3, float2 t_2)
{
    float s_5 = (u_3.half_sin - 0.0);
    float2 upper_2 = ((u_3.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_5, u_3.half_cos));
    float2 turned_2 = (((s_5 <= 0.0) & (s_5 < u_3.half_cos)) ? float2(0.0, 1.0) : upper_2);
    const Angle angle_4 = ConstructAngle(turned_2.x, turned_2.y);
    return angle_4;
}

float bounded(float x_3)
{
    uint bits_1 = asuint(x_3);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_4)
{
    float _e1 = ddx(x_4);
    float _e2 = ddy(x_4);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float4 hermite(float4 a_1, float4 b_1, float4 from_a, float4 to_b, float t_3)
{
    float4 d_1 = (b_1 - a_1);
    return (a_1 + (t_3 * (from_a + (t_3 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_1))))))));
}

float curve_at(Curve curve, float x_5, float w)
{
    float4 points[16] = (float4[16])0;
    uint i_2_ = 1u;
    uint at = 0u;

    points = curve.points;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e21 = i_2_;
            i_2_ = (_e21 + 1u);
        }
        loop_init = false;
        uint _e9 = i_2_;
        if (!((_e9 < 6u))) {
            break;
        }
        uint _e13 = at;
        uint _e14 = i_2_;
        uint _e15 = i_2_;
        float _e18 = points[min(uint(_e15), 15u)].x;
        at = ((_e18 <= x_5) ? _e14 : _e13);
    }
    uint _e24 = at;
    float4 a_2 = points[min(uint(_e24), 15u)];
    uint _e27 = at;
    if ((((_e27 + 1u) >= 6u) | (x_5 <= a_2.x))) {
        return a_2.y;
    }
    uint _e36 = at;
    float4 b_2 = points[min(uint((_e36 + 1u)), 15u)];
    const float _e46 = divided((x_5 - a_2.x), (b_2.x - a_2.x));
    float t_4 = clamp(_e46, 0.0, 1.0);
    const float4 _e66 = hermite((a_2.y).xxxx, (b_2.y).xxxx, ((b_2.x - a_2.x) * (a_2.z).xxxx), ((b_2.x - a_2.x) * (b_2.z).xxxx), t_4);
    return _e66.x;
}

float curve_at_2_(Curve curve_1, float x_6, float w_1)
{
    float4 points_1[16] = (float4[16])0;
    uint i_2_1 = 1u;
    uint at_1 = 0u;

    points_1 = curve_1.points;
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e21 = i_2_1;
            i_2_1 = (_e21 + 1u);
        }
        loop_init_1 = false;
        uint _e9 = i_2_1;
        if (!((_e9 < 4u))) {
            break;
        }
        uint _e13 = at_1;
        uint _e14 = i_2_1;
        uint _e15 = i_2_1;
        float _e18 = points_1[min(uint(_e15), 15u)].x;
        at_1 = ((_e18 <= x_6) ? _e14 : _e13);
    }
    uint _e24 = at_1;
    float4 a_3 = points_1[min(uint(_e24), 15u)];
    uint _e27 = at_1;
    if ((((_e27 + 1u) >= 4u) | (x_6 <= a_3.x))) {
        return a_3.y;
    }
    uint _e36 = at_1;
    float4 b_3 = points_1[min(uint((_e36 + 1u)), 15u)];
    const float _e46 = divided((x_6 - a_3.x), (b_3.x - a_3.x));
    float t_5 = clamp(_e46, 0.0, 1.0);
    const float4 _e66 = hermite((a_3.y).xxxx, (b_3.y).xxxx, ((b_3.x - a_3.x) * (a_3.z).xxxx), ((b_3.x - a_3.x) * (b_3.z).xxxx), t_5);
    return _e66.x;
}

float4 color_curves(float4 color, Curve all_, Curve red, Curve green, Curve blue)
{
    const float _e6 = footprint_of(color.x);
    const float _e8 = footprint_of(color.y);
    const float _e10 = footprint_of(color.z);
    float3 w_6 = float3(_e6, _e8, _e10);
    const float _e14 = curve_at_2_(all_, color.x, w_6.x);
    const float _e17 = curve_at_2_(all_, color.y, w_6.y);
    const float _e20 = curve_at_2_(all_, color.z, w_6.z);
    const float _e22 = curve_at_2_(red, _e14, w_6.x);
    const float _e24 = curve_at_2_(green, _e17, w_6.y);
    const float _e26 = curve_at_2_(blue, _e20, w_6.z);
    return float4(_e22, _e24, _e26, 1.0);
}

float4 blend_alpha(float4 below, float4 color_1, float tone, float opacity, bool clamped)
{
    return float4((below.xyz + (tone * (color_1.xyz - below.xyz))), 1.0);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_2, float tone_1)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_2.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
    return litlayer;
}

Angle parametrization_specular_balanced(Light light_1, float3 normal, float3 view)
{
    float3 d_2 = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_5 = ConstructAngle((0.5 * length((d_2 - light_1.direction))), (0.5 * length((d_2 + light_1.direction))));
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

float profile_point(Angle u_4, ProfileShape shape)
{
    float s_6 = (u_4.half_sin - (u_4.half_cos * 0.0));
    if (((s_6 <= 0.0) | false)) {
        return 1.0;
    }
    float q_1 = (s_6 * shape.scale);
    const float _e15 = profile_power(q_1, shape.exponent);
    return _e15;
}

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1)
{
    const float _e3 = profile_point(u_5, shape_1);
    bool is_wide = (w_2 < (0.1 * shape_1.edge_deviation));
    if (((is_wide | (w_2 <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w_2));
    const Angle _e16 = angle_turned(u_5, _e15);
    const float _e17 = profile_point(_e16, shape_1);
    const Angle _e22 = angle_turned(u_5, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point(_e22, shape_1);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_soft_quick(float s, ProfileShape shape_2)
{
    float q_2 = (s * shape_2.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q_2 * q_2)), 0.0), shape_2.exponent));
}

float profile_ramp_quick(float s_1, float w_3, ProfileShape shape_3)
{
    float width = sqrt(((w_3 * w_3) + ((12.0 * shape_3.edge_deviation) * shape_3.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_3.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w_3 <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_6, float w_4, ProfileShape shape_4)
{
    float2 place = float2(((u_6.half_sin * shape_4.half_cos_offset) - (u_6.half_cos * shape_4.half_sin_offset)), ((u_6.half_cos * shape_4.half_cos_offset) + (u_6.half_sin * shape_4.half_sin_offset)));
    bool is_narrow = ((w_4 > 0.0) & (w_4 >= (3.4641016 * shape_4.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place.x, w_4, shape_4);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place.x, shape_4);
    if ((w_4 < (0.1 * shape_4.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_4);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_4);
    const float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_4);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile(Angle angle, float shift, ProfileShape shape_5)
{
    const Angle _e6 = angle_turned_2_(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered(_e6, _e7, shape_5);
    return _e8;
}

float profile_balanced(Angle angle_1, float shift_1, ProfileShape shape_6)
{
    const Angle _e6 = angle_turned_3_(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle turned_from_the_key = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile(turned_from_the_key, 0.0, tone_shape);
    const float _e24 = footprint_of(_e22);
    const float _e25 = curve_at(response_of_the_film, _e22, _e24);
    float body_tone = clamp(_e25, 0.0, 1.0);
    const float4 _e41 = blend_alpha(float4(0.1216, 0.1137, 0.1333, 1.0), float4(0.7765, 0.7137, 0.6392, 1.0), body_tone, 1.0, true);
    Light _e44 = look.key;
    const Angle _e47 = parametrization_specular_balanced(_e44, surface.normal, surface.view);
    const float _e50 = profile_balanced(_e47, 0.0, sheen_tone_shape);
    Light _e53 = look.key;
    const LitLayer _e59 = light_apply(_e53, float4(0.3725, 0.3451, 0.298, 1.0), _e50);
    float4 sheen_blend = clamp(float4((_e41.xyz + (_e59.tone * _e59.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    float3 _e77 = look.back.direction;
    float3 _e86 = look.back.direction;
    Angle back_light_angle = ConstructAngle((0.5 * length((surface.normal - _e77))), (0.5 * length((surface.normal + _e86))));
    const float _e94 = profile_balanced(back_light_angle, 0.0, back_light_tone_shape);
    Light _e97 = look.back;
    const LitLayer _e103 = light_apply(_e97, float4(0.498, 0.5255, 0.549, 1.0), _e94);
    float4 back_light_blend = clamp(float4((sheen_blend.xyz + (_e103.tone * _e103.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float4 _e121 = color_curves(back_light_blend, film_print, film_print_2_, film_print_3_, film_print_4_);
    return _e121;
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

Surface ConstructSurface(float3 arg0, float3 arg1) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    return _e19;
}
