// Highlights, cut and joined: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2.
// highlight-cut.json says what to put there and how to draw.
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

struct DirectionParts {
    float3 direction;
    int _pad1_0;
    float3 x_axis;
    int _pad2_0;
    float3 y_axis;
    int _pad3_0;
    float2 place;
    int _end_pad_0;
    int _end_pad_1;
};

struct AxesAround {
    float3 x_axis;
    int _pad1_0;
    float3 y_axis;
    int _end_pad_0;
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

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const ProfileShape lit_side_shape = ConstructProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u);
static const ProfileShape disc_shape = ConstructProfileShape(0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u);
static const ProfileShape bite_shape = ConstructProfileShape(0.9887711, 0.14943813, 0.0, 1.0, 0.3, 0.0, 0.0, 1u);
static const ProfileShape dot_shape = ConstructProfileShape(0.99875027, 0.04997917, 0.0, 1.0, 0.1, 0.0, 0.0, 1u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_4 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_5 : LOC1;
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
    float clamped_5 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_5);
    float f = ((clamped_5 - whole) * LN_2_);
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
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
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
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_1, 0.5);
    return min(_e13, 0.5);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float mixed(float a, float b, float t_1)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
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
    float t_3 = clamp(_e6, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float factor_of(float x_9, bool clamped)
{
    const float _e2 = bounded(x_9);
    const float _e3 = bounded(x_9);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_10)
{
    float _e1 = ddx(x_10);
    float _e2 = ddy(x_10);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float3 any_orthogonal(float3 n_1)
{
    float sign_ = ((n_1.z >= 0.0) ? 1.0 : -1.0);
    float a_6 = (-1.0 / (sign_ + n_1.z));
    return float3((1.0 + (((sign_ * n_1.x) * n_1.x) * a_6)), (((sign_ * n_1.x) * n_1.y) * a_6), (-(sign_) * n_1.x));
}

float3 normal(float3 normal_1)
{
    return normal_1;
}

Angle angle_between_directions(float3 a_1, float3 b_1)
{
    float3 z_2 = float3(0.0, 0.0, 1.0);
    const float3 _e6 = normalize_or(a_1, z_2);
    const float3 _e7 = normalize_or(b_1, z_2);
    const Angle _e8 = angle_between(_e6, _e7);
    const Angle angle_4 = _e8;
    return angle_4;
}

DirectionParts ConstructDirectionParts(float3 arg0, float3 arg1, float3 arg2, float2 arg3) {
    DirectionParts ret = (DirectionParts)0;
    ret.direction = arg0;
    ret.x_axis = arg1;
    ret.y_axis = arg2;
    ret.place = arg3;
    return ret;
}

DirectionParts direction_within(float3 direction, float3 x_axis, float3 y_axis)
{
    const float3 _e7 = normalize_or(direction, float3(0.0, 0.0, 1.0));
    const float3 _e10 = normalize_or(x_axis, (0.0).xxx);
    const float3 _e13 = normalize_or(y_axis, (0.0).xxx);
    const DirectionParts directionparts = ConstructDirectionParts(_e7, _e10, _e13, float2(dot(_e7, _e10), dot(_e7, _e13)));
    return directionparts;
}

float3 direction_moved(DirectionParts parts, float2 by)
{
    float2 step_ = clamp(by, (-1000000.0).xx, (1000000.0).xx);
    float3 moved = ((parts.direction + (step_.x * parts.x_axis)) + (step_.y * parts.y_axis));
    const float3 _e18 = normalize_or(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e18 : parts.direction);
}

float3x3 axes_around(float3 toward, float3 up)
{
    const float3 _e6 = normalize_or(toward, float3(0.0, 0.0, 1.0));
    const float3 _e11 = normalize_or(up, float3(0.0, 1.0, 0.0));
    float3 leaning = cross(_e11, _e6);
    float square_1 = dot(leaning, leaning);
    float3 aside = ((abs(_e6.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across = ((square_1 > 1e-8) ? leaning : cross(aside, _e6));
    const float3 _e38 = normalize_or((across - (dot(across, _e6) * _e6)), float3(1.0, 0.0, 0.0));
    return float3x3(_e38, cross(_e6, _e38), _e6);
}

AxesAround ConstructAxesAround(float3 arg0, float3 arg1) {
    AxesAround ret = (AxesAround)0;
    ret.x_axis = arg0;
    ret.y_axis = arg1;
    return ret;
}

AxesAround axes(float3 direction_1, float3 up_1)
{
    const float3x3 _e2 = axes_around(direction_1, up_1);
    const AxesAround axesaround = ConstructAxesAround(_e2[0], _e2[1]);
    return axesaround;
}

float combine_tones_union(float a_2, float b_2)
{
    const float _e3 = factor_of(a_2, true);
    const float _e5 = factor_of(b_2, true);
    return max(_e3, _e5);
}

float combine_tones_intersection(float a_3, float b_3)
{
    const float _e3 = factor_of(a_3, true);
    const float _e5 = factor_of(b_3, true);
    return min(_e3, _e5);
}

float combine_tones_difference(float a_4, float b_4)
{
    const float _e3 = factor_of(a_4, true);
    const float _e5 = factor_of(b_4, true);
    return min(_e3, (1.0 - _e5));
}

float3 half_vector(Light light, float3 view)
{
    float3 half_1 = (light.direction + view);
    const float3 _e4 = any_orthogonal(view);
    const float3 _e9 = normalize_or(((dot(half_1, half_1) > 1e-12) ? half_1 : _e4), view);
    return _e9;
}

float3 shift_direction(float3 direction_2, float3 x_axis_1, float3 y_axis_1, float x_11, float y_2)
{
    const DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    const float3 _e7 = direction_moved(_e5, float2(x_11, y_2));
    return _e7;
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped_1)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed_1 = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped_1 ? clamp(mixed_1, (0.0).xxxx, (1.0).xxxx) : mixed_1);
}

float4 blend_add(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_2)
{
    const float4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color.xyz)), below_1.w, (opacity_1 * color.w), clamped_2);
    return _e12;
}

float4 blend_alpha(float4 below_2, float4 color_1, float tone_1, float opacity_2, bool clamped_3)
{
    float a_7 = (opacity_2 * color_1.w);
    float alpha_1 = (below_2.w + ((tone_1 * a_7) * (1.0 - below_2.w)));
    const float4 _e20 = blend_finish(below_2, (below_2.xyz + (tone_1 * (color_1.xyz - below_2.xyz))), alpha_1, a_7, clamped_3);
    return _e20;
}

float4 blend_shade(float4 below_3, float4 color_2, float tone_2, float opacity_3, bool clamped_4)
{
    const float4 _e14 = blend_finish(below_3, (below_3.xyz * lerp((1.0).xxx, color_2.xyz, tone_2)), below_3.w, (opacity_3 * color_2.w), clamped_4);
    return _e14;
}

float4 output(float4 color_3)
{
    const float4 _e1 = straight(color_3);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light_1, float3 normal_2)
{
    const float3 _e6 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light_1.direction);
    const Angle angle_5 = _e8;
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
    bool local_2 = (bool)0;

    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_2 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
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

float profile_filtered(Angle u_5, float w, ProfileShape shape_1)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width_1 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_1)), 0.0, 1.0);
    }
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w));
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

float rim(Light light_2, float3 normal_3, float3 view_1, float width, float softness, float follow)
{
    const float3 _e10 = normalize_or(normal_3, float3(0.0, 0.0, 1.0));
    float facing = clamp(dot(_e10, view_1), 0.0, 1.0);
    const float _e16 = factor_of(width, true);
    const float _e18 = factor_of(softness, true);
    const float _e20 = footprint_of(facing);
    float edge = max((_e16 * _e18), min(_e20, 1.0));
    float3 aside_1 = (_e10 - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside_1, aside_1)) - (1.0 - _e16)) : (_e16 - facing));
    float within = ((further / max(edge, 1e-6)) + ((softness > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    float3 across_1 = (light_2.direction - (dot(light_2.direction, view_1) * view_1));
    const float3 _e61 = normalize_or(across_1, (0.0).xxx);
    float side = dot((_e10 - (dot(_e10, view_1) * view_1)), _e61);
    const float _e66 = eased(side, 0.0, 0.5);
    const float _e68 = factor_of(follow, true);
    const float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float invert(float value)
{
    const float _e3 = bounded((1.0 - value));
    return _e3;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    const float _e8 = profile(_e5, 0.0, lit_side_shape);
    const float _e9 = invert(_e8);
    const float4 _e22 = blend_shade(float4(0.62, 0.16, 0.26, 1.0), float4(0.5, 0.33, 0.56, 1.0), _e9, 1.0, true);
    const float3 _e24 = normal(surface_1.normal);
    Light _e27 = look.key;
    const float3 _e29 = half_vector(_e27, surface_1.view);
    const Angle _e30 = angle_between_directions(_e24, _e29);
    const float _e33 = profile(_e30, 0.0, disc_shape);
    const AxesAround _e38 = axes(_e29, float3(0.0, 1.0, 0.0));
    const float3 _e43 = shift_direction(_e24, _e38.x_axis, _e38.y_axis, -0.13, 0.13);
    const Angle _e44 = angle_between_directions(_e43, _e29);
    const float _e47 = profile(_e44, 0.0, bite_shape);
    const float _e48 = combine_tones_difference(_e33, _e47);
    const float3 _e53 = shift_direction(_e24, _e38.x_axis, _e38.y_axis, -0.06, 0.06);
    const Angle _e54 = angle_between_directions(_e53, _e29);
    const float _e57 = profile(_e54, 0.0, dot_shape);
    const float _e58 = combine_tones_union(_e48, _e57);
    const float4 _e66 = blend_alpha(_e22, float4(1.0, 0.97, 0.9, 1.0), _e58, 0.96, true);
    Light _e69 = look.back;
    const float _e75 = rim(_e69, surface_1.normal, surface_1.view, 0.42, 0.08, 1.0);
    const float _e76 = combine_tones_intersection(_e75, _e9);
    const float4 _e84 = blend_add(_e66, float4(1.0, 0.62, 0.5, 1.0), _e76, 0.6, true);
    const float4 _e85 = output(_e84);
    return _e85;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_2.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_6 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_6;
    float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    float4 _e26 = view_2.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    const float4 _e35 = shade(_e34);
    const float4 _e36 = finite_vec4_(_e35);
    return _e36;
}
