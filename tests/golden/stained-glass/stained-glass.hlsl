// Stained glass: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// stained-glass.json says what to put there and how to draw.
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
    Light room;
    Light sun;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position;
    int _pad3_0;
    float3 position_object;
    int _end_pad_0;
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

struct Cell {
    float border;
    float random;
    float distance_;
};

struct Cells {
    float border;
    float random;
    float distance_;
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
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const uint NOISE_PERLIN = 1u;
static const uint NOISE_SIMPLEX = 2u;
static const uint NOISE_WORLEY = 3u;
static const float SIMPLEX_SCALE = 38.4553;
static const float WORLEY_MEAN = 0.5205;
static const float CELL_REACH = 1.25;
static const float CELL_BORDER_MEAN = 0.1301;
static const float CELL_DISTANCE_MEAN = 0.491;
static const Ramp colors_1 = ConstructRamp(Constructarray16_float4_(float4(0.0706, 0.1882, 0.4784, 1.0), float4(0.1216, 0.4784, 0.6902, 1.0), float4(0.1137, 0.5412, 0.3529, 1.0), float4(0.9098, 0.6902, 0.1255, 1.0), float4(0.8471, 0.3255, 0.1098, 1.0), float4(0.6902, 0.0706, 0.2196, 1.0), float4(0.3529, 0.102, 0.4784, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.22, 0.4, 0.58), float4(0.75, 0.9, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx), 7u, 2u);
static const ProfileShape through_the_glass_shape = ConstructProfileShape(0.9950042, 0.099833414, 1.1883951, 1.4967098, 0.2, 1.0679889, 0.45520553, 0u);
static const ProfileShape on_the_glass_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1, 1.0089166, 0.41697913, 0u);
static const ProfileShape gleam_tone_shape = ConstructProfileShape(0.99820054, 0.059964005, 11.126125, 3.022525, 0.12, 0.08196669, 0.036355104, 0u);
static const ProfileShape edge_of_the_lead_tone_shape = ConstructProfileShape(0.9887711, 0.14943813, 3.3838634, 2.4220939, 0.3, 0.29531473, 0.1274162, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_3 : LOC0;
    float3 position_object : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_4 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_5 : LOC2;
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
    float p_7 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p_7 * _e33) * _e37);
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
    float p_8 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_8 * p_8) + (s_1 * s_1)), 1e-30)));
    const Angle angle_1 = ConstructAngle((p_8 * k), (s_1 * k));
    return angle_1;
}

float atan2_positive(float y_1, float x_5)
{
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_6 = (small / large);
    bool is_wide = (t_6 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_6);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_5 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_5) : a_5);
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
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_5, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    const float _e6 = bounded(v_3.z);
    return float3(_e2, _e4, _e6);
}

float4 bounded_vec4_(float4 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    const float _e8 = bounded(v_4.w);
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

float3 mixed_vec3_(float3 a_2, float3 b_2, float t_2)
{
    const float _e5 = mixed(a_2.x, b_2.x, t_2);
    const float _e8 = mixed(a_2.y, b_2.y, t_2);
    const float _e11 = mixed(a_2.z, b_2.z, t_2);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_3, float4 b_3, float t_3)
{
    const float3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_3);
    const float _e8 = mixed(a_3.w, b_3.w, t_3);
    return float4(_e5, _e8);
}

float place_between(float x_7, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_7 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_7 - low) / _e12));
    return _e14;
}

float eased(float x_8, float low_1, float high_1)
{
    const float _e3 = bounded(x_8);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_7 = clamp(_e6, 0.0, 1.0);
    return ((t_7 * t_7) * (3.0 - (2.0 * t_7)));
}

float length_of(float3 v_5)
{
    const float3 _e1 = bounded_vec3_(v_5);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e17 = bounded((largest_2 * length((_e1 / (largest_2).xxx))));
    return _e17;
}

float footprint_of(float x_9)
{
    float _e1 = ddx(x_9);
    float _e2 = ddy(x_9);
    float2 d_3 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_3, d_3)));
    return _e6;
}

float footprint_of_vec3_(float3 v_6)
{
    float3 dx_1 = ddx(v_6);
    float3 dy_1 = ddy(v_6);
    const float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

float edge_width(float w, float softness)
{
    const float _e4 = bounded(softness);
    return length(float2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_10, float edge, float w_1)
{
    const float _e4 = bounded((x_10 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float4 hermite(float4 a_4, float4 b_4, float4 from_a, float4 to_b, float t_4)
{
    float4 d_4 = (b_4 - a_4);
    return (a_4 + (t_4 * (from_a + (t_4 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_4 * ((from_a + to_b) - (2.0 * d_4))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after)
{
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    const float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

float4 ramp_slope(float4 rise_before, float span_before_1, float4 rise_after, float span_after_1)
{
    const float _e5 = divided(rise_before.x, span_before_1);
    const float _e7 = divided(rise_after.x, span_after_1);
    const float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    const float _e10 = divided(rise_before.y, span_before_1);
    const float _e12 = divided(rise_after.y, span_after_1);
    const float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    const float _e15 = divided(rise_before.z, span_before_1);
    const float _e17 = divided(rise_after.z, span_after_1);
    const float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    const float _e20 = divided(rise_before.w, span_before_1);
    const float _e22 = divided(rise_after.w, span_after_1);
    const float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return float4(_e8, _e13, _e18, _e23);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float4 ramp_at(Ramp ramp, float x_11, float w_2)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_2 = (bool)0;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    uint count = min(ramp.count, 16u);
    if ((count == 0u)) {
        return (0.0).xxxx;
    }
    colors = ramp.colors;
    places = ramp.places;
    if ((ramp.interpolation == INTERPOLATION_STEPPED)) {
        float4 _e18 = colors[0];
        color = _e18;
        uint2 loop_bound = uint2(4294967295u, 4294967295u);
        bool loop_init = true;
        while(true) {
            if (all(loop_bound == uint2(0u, 0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e47 = i;
                i = (_e47 + 1u);
            }
            loop_init = false;
            uint _e22 = i;
            if ((_e22 < count)) {
            } else {
                break;
            }
            {
                float4 _e24 = color;
                uint _e25 = i;
                float4 _e27 = colors[min(uint(_e25), 15u)];
                uint _e28 = i;
                float4 _e32 = colors[min(uint((_e28 - 1u)), 15u)];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places[min(uint(naga_div(_e34, 4u)), 3u)][min(uint(naga_mod(_e38, 4u)), 3u)];
                const float _e43 = step_filtered(x_11, _e42, w_2);
                color = (_e24 + ((_e27 - _e32) * _e43));
            }
        }
        float4 _e49 = color;
        const float4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = (_e71 + 1u);
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if ((_e55 < count)) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places[min(uint(naga_div(_e59, 4u)), 3u)][min(uint(naga_mod(_e63, 4u)), 3u)];
            at = ((_e67 <= x_11) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_2 = (x_11 <= place);
    } else {
        local_2 = true;
    }
    bool _e91 = local_2;
    if (_e91) {
        uint _e92 = at;
        float4 _e94 = colors[min(uint(_e92), 15u)];
        const float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span_1 = (_e105 - place);
    const float _e108 = divided((x_11 - place), span_1);
    float t_8 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        float4 _e117 = colors[min(uint(_e115), 15u)];
        float4 _e119 = colors[min(uint(after_1), 15u)];
        const float4 _e120 = mixed_vec4_(_e117, _e119, t_8);
        return _e120;
    }
    uint _e127 = at;
    if ((_e127 > 0u)) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places[min(uint(naga_div((_e130 - 1u), 4u)), 3u)][min(uint(naga_mod((_e136 - 1u), 4u)), 3u)];
        uint _e143 = at;
        float4 _e145 = colors[min(uint(_e143), 15u)];
        uint _e146 = at;
        float4 _e150 = colors[min(uint((_e146 - 1u)), 15u)];
        float4 _e154 = colors[min(uint(after_1), 15u)];
        uint _e155 = at;
        float4 _e157 = colors[min(uint(_e155), 15u)];
        const float4 _e159 = ramp_slope((_e145 - _e150), (place - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count)) {
        float _e173 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e173 - (place + span_1));
        float4 _e177 = colors[min(uint(after_1), 15u)];
        uint _e178 = at;
        float4 _e180 = colors[min(uint(_e178), 15u)];
        float4 _e185 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e187 = colors[min(uint(after_1), 15u)];
        const float4 _e189 = ramp_slope((_e177 - _e180), span_1, (_e185 - _e187), next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    float4 _e192 = colors[min(uint(_e190), 15u)];
    float4 _e194 = colors[min(uint(after_1), 15u)];
    float4 _e195 = from_a_1;
    float4 _e197 = to_b_1;
    const float4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_8);
    const float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float3 bumped_normal(float4 along_x, float4 along_y, float3 normal)
{
    bool local_3 = (bool)0;

    const float3 _e7 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const float4 _e8 = bounded_vec4_(along_x);
    const float4 _e9 = bounded_vec4_(along_y);
    const float _e11 = length_of(_e8.xyz);
    const float _e13 = length_of(_e9.xyz);
    float largest_3 = max(_e11, _e13);
    if (!((largest_3 < 1e-18))) {
        local_3 = (largest_3 > 1e18);
    } else {
        local_3 = true;
    }
    bool _e23 = local_3;
    if (_e23) {
        return _e7;
    }
    float3 s_3 = (_e8.xyz / (largest_3).xxx);
    float3 t_9 = (_e9.xyz / (largest_3).xxx);
    float2 rise = clamp((float2(_e8.w, _e9.w) / (largest_3).xx), (-1000000.0).xx, (1000000.0).xx);
    float3 right = cross(t_9, _e7);
    float3 up = cross(_e7, s_3);
    float area = dot(s_3, right);
    if ((abs(area) < 1e-6)) {
        return _e7;
    }
    float3 slope = (((rise.x * right) + (rise.y * up)) / (area).xxx);
    float steepness = length(slope);
    float3 limited = (slope * (min(steepness, 10.0) / max(steepness, 1e-20)));
    const float3 _e61 = normalize_or((_e7 - limited), _e7);
    return _e61;
}

float3 bump_map(float height, float scale, float3 normal_1, float3 position)
{
    const float _e5 = bounded((height * scale));
    float3 _e6 = ddx(position);
    float _e7 = ddx(_e5);
    float4 along_x_1 = float4(_e6, _e7);
    float3 _e9 = ddy(position);
    float _e10 = ddy(_e5);
    float4 along_y_1 = float4(_e9, _e10);
    const float3 _e12 = bumped_normal(along_x_1, along_y_1, normal_1);
    const float3 _e13 = bounded_vec3_(normal_1);
    return ((scale == 0.0) ? _e13 : _e12);
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed_1 = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed_1, (0.0).xxxx, (1.0).xxxx) : mixed_1);
}

float4 blend_add(float4 below_1, float4 color_1, float tone, float opacity_1, bool clamped_1)
{
    const float4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color_1.xyz)), below_1.w, (opacity_1 * color_1.w), clamped_1);
    return _e12;
}

float4 blend_alpha(float4 below_2, float4 color_2, float tone_1, float opacity_2, bool clamped_2)
{
    float a_6 = (opacity_2 * color_2.w);
    float alpha_1 = (below_2.w + ((tone_1 * a_6) * (1.0 - below_2.w)));
    const float4 _e20 = blend_finish(below_2, (below_2.xyz + (tone_1 * (color_2.xyz - below_2.xyz))), alpha_1, a_6, clamped_2);
    return _e20;
}

float4 output(float4 color_3)
{
    const float4 _e1 = straight(color_3);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
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

LitLayer light_apply(Light light, float4 color_4, float tone_2)
{
    const float2 _e4 = light_split(light.intensity);
    const LitLayer litlayer = ConstructLitLayer(float4(((color_4.xyz * light.color) * _e4.y), color_4.w), (tone_2 * _e4.x));
    return litlayer;
}

Angle parametrization_diffuse(Light light_1, float3 normal_2)
{
    const float3 _e6 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light_1.direction);
    const Angle angle_4 = _e8;
    return angle_4;
}

Angle parametrization_specular(Light light_2, float3 normal_3, float3 view)
{
    const float3 _e7 = normalize_or(normal_3, float3(0.0, 0.0, 1.0));
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
    bool local_4 = (bool)0;

    float s_4 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_4 <= 0.0))) {
        local_4 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_4 = true;
    }
    bool _e18 = local_4;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_4 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_4 * shape.scale);
    const float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_3, ProfileShape shape_1)
{
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w_3 <= 0.0))) {
        local_5 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_5 = true;
    }
    bool _e13 = local_5;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_6 = (w_3 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_6 = false;
    }
    bool _e24 = local_6;
    if (_e24) {
        float width = sqrt(((w_3 * w_3) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
    }
    if ((w_3 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w_3));
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

float4 ramp_plain(float value, Ramp ramp_1)
{
    const float _e2 = footprint_of(value);
    const float _e3 = bounded(value);
    const float4 _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

float threshold(float value_1, float edge_1, float softness_1)
{
    const float _e3 = footprint_of(value_1);
    const float _e4 = bounded(value_1);
    const float _e5 = bounded(edge_1);
    const float _e6 = edge_width(_e3, softness_1);
    const float _e7 = step_filtered(_e4, _e5, _e6);
    return _e7;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_7 = (uint3)0;

    v_7 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_7.x;
    uint _e10 = v_7.y;
    uint _e12 = v_7.z;
    v_7.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_7.y;
    uint _e18 = v_7.z;
    uint _e20 = v_7.x;
    v_7.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_7.z;
    uint _e26 = v_7.x;
    uint _e28 = v_7.y;
    v_7.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_7;
    uint3 _e32 = v_7;
    v_7 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_7.x;
    uint _e40 = v_7.y;
    uint _e42 = v_7.z;
    v_7.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_7.y;
    uint _e48 = v_7.z;
    uint _e50 = v_7.x;
    v_7.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_7.z;
    uint _e56 = v_7.x;
    uint _e58 = v_7.y;
    v_7.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_7;
    return _e61;
}

float3 unit_of_hash(uint3 hash)
{
    return (float3((hash >> (8u).xxx)) * 5.9604645e-8);
}

uint3 lattice_hash(int3 cell, uint seed_1)
{
    const uint3 _e9 = hash_pcg3d((asuint(cell) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uint3 hash_1, float3 d_1)
{
    uint axis = naga_mod((hash_1.x >> 8u), 3u);
    float a_7 = ((axis == 0u) ? d_1.y : d_1.x);
    float b_5 = ((axis == 2u) ? d_1.y : d_1.z);
    return ((((hash_1.y >> 31u) == 0u) ? a_7 : -(a_7)) + (((hash_1.z >> 31u) == 0u) ? b_5 : -(b_5)));
}

float3 fade_quintic(float3 t_5)
{
    return (((t_5 * t_5) * t_5) * ((t_5 * ((t_5 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i_2 = int(0);

    float3 corner = floor(p);
    const float3 _e4 = fade_quintic((p - corner));
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e45 = i_2;
            i_2 = asint(asuint(_e45) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e10 = i_2;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_2;
            int _e16 = i_2;
            int _e21 = i_2;
            int3 at_1 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at_1 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at_1)), seed_2);
            const float3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(float3 p_1, uint seed_3)
{
    float sum_1 = 0.0;
    int i_3 = int(0);

    float3 corner_1 = floor(p_1);
    float3 d_5 = (p_1 - corner_1);
    const float3 _e4 = fade_quintic(d_5);
    int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            int3 at_2 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight_1 = ((at_2 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum_1;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_2) + asuint(at_2)), seed_3);
            const float _e42 = gradient_dot(_e39, (d_5 - float3(at_2)));
            sum_1 = (_e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42));
        }
    }
    float _e48 = sum_1;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float simplex_corner(float3 d_2, uint3 hash_2)
{
    float t_10 = max((0.5 - dot(d_2, d_2)), 0.0);
    const float _e10 = gradient_dot(hash_2, d_2);
    return ((((t_10 * t_10) * t_10) * t_10) * _e10);
}

float simplex_noise(float3 p_2, uint seed_4)
{
    float sum_2 = (float)0;

    float3 corner_2 = floor((p_2 + ((((p_2.x + p_2.y) + p_2.z) / 3.0)).xxx));
    float3 d_6 = ((p_2 - corner_2) + ((((corner_2.x + corner_2.y) + corner_2.z) / 6.0)).xxx);
    bool3 is_first = bool3((d_6.x >= d_6.y), (d_6.y >= d_6.z), (d_6.z > d_6.x));
    float3 g = (is_first ? (1.0).xxx : (0.0).xxx);
    float3 l_1 = ((1.0).xxx - g);
    float3 second = min(g, l_1.zxy);
    float3 third = max(g, l_1.zxy);
    int3 cell_3 = naga_f2i32(corner_2);
    const uint3 _e45 = lattice_hash(cell_3, seed_4);
    const float _e46 = simplex_corner(d_6, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    const uint3 _e55 = lattice_hash(asint(asuint(cell_3) + asuint(naga_f2i32(second))), seed_4);
    const float _e56 = simplex_corner(((d_6 - second) + (0.16666667).xxx), _e55);
    sum_2 = (_e48 + _e56);
    float _e58 = sum_2;
    const uint3 _e65 = lattice_hash(asint(asuint(cell_3) + asuint(naga_f2i32(third))), seed_4);
    const float _e66 = simplex_corner(((d_6 - third) + (0.33333334).xxx), _e65);
    sum_2 = (_e58 + _e66);
    float _e68 = sum_2;
    const uint3 _e75 = lattice_hash(asint(asuint(cell_3) + asuint((int(1)).xxx)), seed_4);
    const float _e76 = simplex_corner((d_6 - (0.5).xxx), _e75);
    sum_2 = (_e68 + _e76);
    float _e79 = sum_2;
    return clamp((0.5 + (SIMPLEX_SCALE * _e79)), 0.0, 1.0);
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

float worley_noise(float3 p_3, uint seed_5)
{
    float nearest = 1.0;
    int i_4 = int(0);

    float3 corner_3 = floor(p_3);
    float3 d_7 = (p_3 - corner_3);
    int3 cell_4 = naga_f2i32(corner_3);
    uint2 loop_bound_4 = uint2(4294967295u, 4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (all(loop_bound_4 == uint2(0u, 0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e40 = i_4;
            i_4 = asint(asuint(_e40) + asuint(int(1)));
        }
        loop_init_4 = false;
        int _e9 = i_4;
        if ((_e9 < int(27))) {
        } else {
            break;
        }
        {
            int _e12 = i_4;
            int _e17 = i_4;
            int _e24 = i_4;
            int3 at_3 = int3(asint(asuint(naga_mod(_e12, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e17, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e24, int(9))) - asuint(int(1))));
            const uint3 _e32 = lattice_hash(asint(asuint(cell_4) + asuint(at_3)), seed_5);
            const float3 _e33 = unit_of_hash(_e32);
            float3 offset = ((float3(at_3) + _e33) - d_7);
            float _e36 = nearest;
            nearest = min(_e36, dot(offset, offset));
        }
    }
    float _e42 = nearest;
    return sqrt(_e42);
}

Cell ConstructCell(float arg0, float arg1, float arg2) {
    Cell ret = (Cell)0;
    ret.border = arg0;
    ret.random = arg1;
    ret.distance_ = arg2;
    return ret;
}

Cell nearest_cell(float3 p_4, uint seed_6)
{
    float3 nearest_1 = (4.0).xxx;
    uint3 hash_3 = (0u).xxx;
    int i_5 = int(0);
    float border = (float)0;
    int i_6 = int(0);

    float3 corner_4 = floor(p_4);
    float3 d_8 = (p_4 - corner_4);
    int3 cell_5 = naga_f2i32(corner_4);
    uint2 loop_bound_5 = uint2(4294967295u, 4294967295u);
    bool loop_init_5 = true;
    while(true) {
        if (all(loop_bound_5 == uint2(0u, 0u))) { break; }
        loop_bound_5 -= uint2(loop_bound_5.y == 0u, 1u);
        if (!loop_init_5) {
            int _e51 = i_5;
            i_5 = asint(asuint(_e51) + asuint(int(1)));
        }
        loop_init_5 = false;
        int _e13 = i_5;
        if ((_e13 < int(27))) {
        } else {
            break;
        }
        {
            int _e16 = i_5;
            int _e21 = i_5;
            int _e28 = i_5;
            int3 at_4 = int3(asint(asuint(naga_mod(_e16, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e21, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e28, int(9))) - asuint(int(1))));
            const uint3 _e35 = lattice_hash(asint(asuint(cell_5) + asuint(at_4)), seed_6);
            const float3 _e40 = unit_of_hash(_e35);
            float3 offset_1 = (((float3(at_4) + (0.25).xxx) + (0.5 * _e40)) - d_8);
            float3 _e46 = nearest_1;
            float3 _e47 = nearest_1;
            if ((dot(offset_1, offset_1) < dot(_e46, _e47))) {
                nearest_1 = offset_1;
                hash_3 = _e35;
            }
        }
    }
    float3 _e53 = nearest_1;
    float distance_ = length(_e53);
    border = max((0.5 * (CELL_REACH - distance_)), 0.0);
    uint2 loop_bound_6 = uint2(4294967295u, 4294967295u);
    bool loop_init_6 = true;
    while(true) {
        if (all(loop_bound_6 == uint2(0u, 0u))) { break; }
        loop_bound_6 -= uint2(loop_bound_6.y == 0u, 1u);
        if (!loop_init_6) {
            int _e110 = i_6;
            i_6 = asint(asuint(_e110) + asuint(int(1)));
        }
        loop_init_6 = false;
        int _e64 = i_6;
        if ((_e64 < int(27))) {
        } else {
            break;
        }
        {
            int _e67 = i_6;
            int _e72 = i_6;
            int _e79 = i_6;
            int3 at_5 = int3(asint(asuint(naga_mod(_e67, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e72, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e79, int(9))) - asuint(int(1))));
            const uint3 _e90 = lattice_hash(asint(asuint(cell_5) + asuint(at_5)), seed_6);
            const float3 _e91 = unit_of_hash(_e90);
            float3 _e96 = nearest_1;
            float3 apart = ((((float3(at_5) + (0.25).xxx) + (0.5 * _e91)) - d_8) - _e96);
            float between = length(apart);
            if ((between > 0.25)) {
                float _e101 = border;
                float3 _e102 = nearest_1;
                border = min(_e101, (dot((_e102 + (0.5 * apart)), apart) / between));
            }
        }
    }
    float _e112 = border;
    uint3 _e115 = hash_3;
    const uint3 _e116 = hash_pcg3d(_e115);
    const float3 _e117 = unit_of_hash(_e116);
    const Cell cell_6 = ConstructCell(max(_e112, 0.0), _e117.x, distance_);
    return cell_6;
}

float noise_octave(uint kind, float3 p_5, uint seed_7)
{
    switch(kind) {
        case 1u: {
            const float _e3 = perlin_noise(p_5, seed_7);
            return _e3;
        }
        case 2u: {
            const float _e4 = simplex_noise(p_5, seed_7);
            return _e4;
        }
        case 3u: {
            const float _e5 = worley_noise(p_5, seed_7);
            return _e5;
        }
        default: {
            const float _e6 = value_noise(p_5, seed_7);
            return _e6;
        }
    }
}

float fractal_noise(uint kind_1, float3 p_6, int octaves, float roughness, int seed_8, float w_4)
{
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_7 = int(0);
    float octave = (float)0;

    float mean = ((kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5);
    const float _e11 = bounded(roughness);
    float gain = clamp(_e11, 0.0, 1.0);
    uint2 loop_bound_7 = uint2(4294967295u, 4294967295u);
    bool loop_init_7 = true;
    while(true) {
        if (all(loop_bound_7 == uint2(0u, 0u))) { break; }
        loop_bound_7 -= uint2(loop_bound_7.y == 0u, 1u);
        if (!loop_init_7) {
            int _e75 = i_7;
            i_7 = asint(asuint(_e75) + asuint(int(1)));
        }
        loop_init_7 = false;
        int _e25 = i_7;
        if ((_e25 < clamp(octaves, int(1), int(8)))) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            const float _e34 = eased((w_4 * _e30), 0.5, 1.0);
            float visible = (1.0 - _e34);
            octave = mean;
            if ((visible > 0.0)) {
                float _e40 = frequency;
                int _e42 = i_7;
                float3 place_1 = clamp(((p_6 * _e40) + (float(_e42) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
                int _e56 = i_7;
                const float _e59 = noise_octave(kind_1, place_1, (asuint(seed_8) + uint(_e56)));
                octave = lerp(mean, _e59, visible);
            }
            float _e61 = sum_3;
            float _e62 = strength;
            float _e63 = octave;
            sum_3 = (_e61 + (_e62 * _e63));
            float _e66 = total;
            float _e67 = strength;
            total = (_e66 + _e67);
            float _e69 = strength;
            strength = (_e69 * gain);
            float _e71 = frequency;
            frequency = (_e71 * 2.0);
        }
    }
    float _e77 = sum_3;
    float _e78 = total;
    return clamp((_e77 / _e78), 0.0, 1.0);
}

float invert(float value_2)
{
    const float _e3 = bounded((1.0 - value_2));
    return _e3;
}

Cells ConstructCells(float arg0, float arg1, float arg2) {
    Cells ret = (Cells)0;
    ret.border = arg0;
    ret.random = arg1;
    ret.distance_ = arg2;
    return ret;
}

Cells cells(float3 position_1, float scale_1, int seed_9)
{
    const float3 _e4 = bounded_vec3_((position_1 * scale_1));
    float3 p_9 = clamp(_e4, (-4194304.0).xxx, (4194304.0).xxx);
    const Cell _e11 = nearest_cell(p_9, asuint(seed_9));
    const float _e12 = footprint_of_vec3_(p_9);
    const float _e15 = eased(_e12, 0.5, 1.0);
    float visible_1 = (1.0 - _e15);
    float3 average = float3(0.1301, 0.5, 0.491);
    float3 seen = lerp(average, float3(_e11.border, _e11.random, _e11.distance_), visible_1);
    const Cells cells_1 = ConstructCells(seen.x, seen.y, seen.z);
    return cells_1;
}

float noise_perlin(float3 position_2, float scale_2, int octaves_1, float roughness_1, int seed_10)
{
    const float3 _e6 = bounded_vec3_((position_2 * scale_2));
    const float _e8 = footprint_of_vec3_(_e6);
    const float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_10, _e8);
    return _e9;
}

float4 shade(Surface surface_1)
{
    const Cells _e4 = cells(surface_1.position_object, 3.4, int(4));
    const float4 _e7 = ramp_plain(_e4.random, colors_1);
    const float4 _e16 = blend_add(float4(0.0275, 0.0235, 0.0471, 1.0), _e7, 1.0, 0.3, true);
    const float _e22 = noise_perlin(surface_1.position_object, 5.0, int(2), 0.5, int(0));
    const float3 _e26 = bump_map(_e22, 0.03, surface_1.normal, surface_1.position);
    Light _e29 = look.sun;
    const Angle _e30 = parametrization_diffuse(_e29, _e26);
    const float _e33 = profile(_e30, 0.0, through_the_glass_shape);
    const float4 _e36 = blend_add(_e16, _e7, _e33, 0.95, true);
    Light _e39 = look.room;
    const Angle _e40 = parametrization_diffuse(_e39, _e26);
    const float _e43 = profile(_e40, 0.0, on_the_glass_shape);
    const float4 _e46 = blend_add(_e36, _e7, _e43, 0.45, true);
    const float _e50 = threshold(_e4.border, 0.035, 0.0);
    const float _e51 = invert(_e50);
    const float4 _e59 = blend_alpha(_e46, float4(0.0824, 0.0863, 0.102, 1.0), _e51, 1.0, true);
    Light _e62 = look.room;
    const Angle _e64 = parametrization_specular(_e62, _e26, surface_1.view);
    const float _e67 = profile(_e64, 0.0, gleam_tone_shape);
    Light _e70 = look.room;
    const LitLayer _e76 = light_apply(_e70, float4(1.0, 0.9647, 0.8941, 1.0), _e67);
    const float4 _e81 = blend_alpha(_e59, _e76.color, _e76.tone, 0.7, true);
    Light _e84 = look.room;
    const Angle _e87 = parametrization_specular(_e84, surface_1.normal, surface_1.view);
    const float _e90 = profile(_e87, 0.0, edge_of_the_lead_tone_shape);
    Light _e93 = look.room;
    const LitLayer _e99 = light_apply(_e93, float4(0.1725, 0.1843, 0.2196, 1.0), _e90);
    const float4 _e104 = blend_add(_e81, _e99.color, _e99.tone, 0.35, true);
    const float4 _e105 = output(_e104);
    return _e105;
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

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_4, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_6 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_6;
    float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    float4 _e26 = view_1.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position = in_.position;
    surface.position_object = in_.position_object;
    Surface _e38 = surface;
    const float4 _e39 = shade(_e38);
    const float4 _e40 = finite_vec4_(_e39);
    return _e40;
}
