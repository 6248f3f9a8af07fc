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

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
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
    float3 normal_2 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
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
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
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
    float t_3 = (small / large);
    bool is_wide = (t_3 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_3);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_3 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_3) : a_3);
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
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_3, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float4 bounded_vec4_(float4 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    const float _e6 = bounded(v_3.z);
    const float _e8 = bounded(v_3.w);
    return float4(_e2, _e4, _e6, _e8);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float mixed(float a_1, float b_1, float t_1)
{
    const float _e4 = bounded((b_1 - a_1));
    const float _e14 = bounded(((t_1 < 0.5) ? (a_1 + (t_1 * _e4)) : (b_1 - ((1.0 - t_1) * _e4))));
    return _e14;
}

float footprint_of(float x_7)
{
    float _e1 = ddx(x_7);
    float _e2 = ddy(x_7);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float step_filtered(float x_8, float edge, float w)
{
    const float _e4 = bounded((x_8 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float4 hermite(float4 a_2, float4 b_2, float4 from_a, float4 to_b, float t_2)
{
    float4 d_2 = (b_2 - a_2);
    return (a_2 + (t_2 * (from_a + (t_2 * ((((3.0 * d_2) - (2.0 * from_a)) - to_b) + (t_2 * ((from_a + to_b) - (2.0 * d_2))))))));
}

float curve_at(Curve curve, float x_9, float w_1)
{
    float4 points[16] = (float4[16])0;
    float y_2 = (float)0;
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_2 = (bool)0;

    uint count = min(curve.count, 16u);
    if ((count == 0u)) {
        return 0.0;
    }
    points = curve.points;
    if ((curve.interpolation == INTERPOLATION_STEPPED)) {
        float _e16 = points[0].y;
        y_2 = _e16;
        uint2 loop_bound = uint2(4294967295u, 4294967295u);
        bool loop_init = true;
        while(true) {
            if (all(loop_bound == uint2(0u, 0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e42 = i;
                i = (_e42 + 1u);
            }
            loop_init = false;
            uint _e20 = i;
            if ((_e20 < count)) {
            } else {
                break;
            }
            {
                float _e22 = y_2;
                uint _e23 = i;
                float _e26 = points[min(uint(_e23), 15u)].y;
                uint _e27 = i;
                float _e32 = points[min(uint((_e27 - 1u)), 15u)].y;
                uint _e34 = i;
                float _e37 = points[min(uint(_e34), 15u)].x;
                const float _e38 = step_filtered(x_9, _e37, w_1);
                y_2 = (_e22 + ((_e26 - _e32) * _e38));
            }
        }
        float _e44 = y_2;
        const float _e45 = bounded(_e44);
        return _e45;
    }
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e61 = i_1;
            i_1 = (_e61 + 1u);
        }
        loop_init_1 = false;
        uint _e50 = i_1;
        if ((_e50 < count)) {
        } else {
            break;
        }
        {
            uint _e52 = at;
            uint _e53 = i_1;
            uint _e54 = i_1;
            float _e57 = points[min(uint(_e54), 15u)].x;
            at = ((_e57 <= x_9) ? _e53 : _e52);
        }
    }
    uint _e63 = at;
    float4 a_4 = points[min(uint(_e63), 15u)];
    uint _e66 = at;
    if (!(((_e66 + 1u) >= count))) {
        local_2 = (x_9 <= a_4.x);
    } else {
        local_2 = true;
    }
    bool _e76 = local_2;
    if (_e76) {
        const float _e78 = bounded(a_4.y);
        return _e78;
    }
    uint _e79 = at;
    float4 b_3 = points[min(uint((_e79 + 1u)), 15u)];
    const float _e89 = divided((x_9 - a_4.x), (b_3.x - a_4.x));
    float t_4 = clamp(_e89, 0.0, 1.0);
    if ((curve.interpolation == INTERPOLATION_SMOOTH)) {
        const float4 _e112 = hermite((a_4.y).xxxx, (b_3.y).xxxx, ((b_3.x - a_4.x) * (a_4.z).xxxx), ((b_3.x - a_4.x) * (b_3.z).xxxx), t_4);
        const float _e114 = bounded(_e112.x);
        return _e114;
    }
    const float _e117 = mixed(a_4.y, b_3.y, t_4);
    return _e117;
}

float4 color_curves(float4 color, Curve all_, Curve red, Curve green, Curve blue)
{
    const float4 _e5 = bounded_vec4_(color);
    const float _e7 = footprint_of(_e5.x);
    const float _e9 = footprint_of(_e5.y);
    const float _e11 = footprint_of(_e5.z);
    float3 w_4 = float3(_e7, _e9, _e11);
    const float _e15 = curve_at(all_, _e5.x, w_4.x);
    const float _e18 = curve_at(all_, _e5.y, w_4.y);
    const float _e21 = curve_at(all_, _e5.z, w_4.z);
    const float _e23 = curve_at(red, _e15, w_4.x);
    const float _e25 = curve_at(green, _e18, w_4.y);
    const float _e27 = curve_at(blue, _e21, w_4.z);
    return float4(_e23, _e25, _e27, _e5.w);
}

float unit_share(float share)
{
    return clamp(share, 0.0, 1.0);
}

float4 premultiplied(float4 color_1)
{
    return float4((color_1.xyz * color_1.w), color_1.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed_1 = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed_1, (0.0).xxxx, (1.0).xxxx) : mixed_1);
}

float4 blend_add(float4 below_1, float4 color_2, float tone, float opacity_1, bool clamped_1)
{
    const float4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color_2.xyz)), below_1.w, (opacity_1 * color_2.w), clamped_1);
    return _e12;
}

float4 blend_alpha(float4 below_2, float4 color_3, float tone_1, float opacity_2, bool clamped_2)
{
    float a_5 = (opacity_2 * color_3.w);
    float alpha_1 = (below_2.w + ((tone_1 * a_5) * (1.0 - below_2.w)));
    const float4 _e20 = blend_finish(below_2, (below_2.xyz + (tone_1 * (color_3.xyz - below_2.xyz))), alpha_1, a_5, clamped_2);
    return _e20;
}

float4 output(float4 color_4)
{
    const float4 _e1 = straight(color_4);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float curve_1(float value, Curve curve_2)
{
    const float _e2 = footprint_of(value);
    const float _e3 = bounded(value);
    const float _e4 = curve_at(curve_2, _e3, _e2);
    return _e4;
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
    bool local_3 = (bool)0;

    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_3 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e18 = local_3;
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

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1)
{
    bool local_4 = (bool)0;
    bool local_5 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_4 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_4 = true;
    }
    bool _e13 = local_4;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_5 = (w_2 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_5 = false;
    }
    bool _e24 = local_5;
    if (_e24) {
        float width = sqrt(((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_2 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w_2));
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

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    const float _e8 = profile(_e5, 0.0, tone_shape);
    const float _e10 = curve_1(_e8, response_of_the_film);
    const float _e11 = unit_share(_e10);
    const float4 _e24 = blend_alpha(float4(0.1216, 0.1137, 0.1333, 1.0), float4(0.7765, 0.7137, 0.6392, 1.0), _e11, 1.0, true);
    Light _e27 = look.key;
    const Angle _e30 = parametrization_specular(_e27, surface_1.normal, surface_1.view);
    const float _e33 = profile(_e30, 0.0, sheen_tone_shape);
    Light _e36 = look.key;
    const LitLayer _e42 = light_apply(_e36, float4(0.3725, 0.3451, 0.298, 1.0), _e33);
    const float4 _e47 = blend_add(_e24, _e42.color, _e42.tone, 1.0, true);
    Light _e50 = look.back;
    const Angle _e52 = parametrization_diffuse(_e50, surface_1.normal);
    const float _e55 = profile(_e52, 0.0, back_light_tone_shape);
    Light _e58 = look.back;
    const LitLayer _e64 = light_apply(_e58, float4(0.498, 0.5255, 0.549, 1.0), _e55);
    const float4 _e69 = blend_add(_e47, _e64.color, _e64.tone, 1.0, true);
    const float4 _e70 = straight(_e69);
    const float4 _e75 = color_curves(_e70, film_print, film_print_2_, film_print_3_, film_print_4_);
    const float4 _e76 = premultiplied(_e75);
    const float4 _e77 = output(_e76);
    return _e77;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    float4 _e26 = view_1.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    const float4 _e35 = shade(_e34);
    const float4 _e36 = finite_vec4_(_e35);
    return _e36;
}
