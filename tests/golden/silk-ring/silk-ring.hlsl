// Silk: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// silk-ring.json says what to put there and how to draw.
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
    Light low;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
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
static const uint NOISE_PERLIN = 1u;
static const ProfileShape lit_side_shape = ConstructProfileShape(0.9950042, 0.099833414, 1.1883951, 1.7298278, 0.2, 1.0107075, 0.4419037, 0u);
static const ProfileShape band_shape = ConstructProfileShape(0.9998875, 0.014999437, 9.541332, 4.980432, 0.03, 0.07759806, 0.03648918, 0u);
static const ProfileShape second_band_shape = ConstructProfileShape(1.0, 0.0, 6.6917324, 12.899528, 0.0, 0.07171497, 0.035865854, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_1 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) & (largest < 1e30)))) {
        return otherwise;
    }
    float3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    const bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x_1)
{
    float whole = round(x_1);
    float f = (x_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_2_(float x_2)
{
    float clamped_2 = max(x_2, -126.0);
    float whole_1 = round(clamped_2);
    float f_1 = (clamped_2 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
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

float2 sin_cos_tiny(float x_4)
{
    float y_3 = (x_4 * x_4);
    float s = (x_4 * (1.0 + (y_3 * (-0.16666667 + (y_3 * 0.008333334)))));
    float c = (1.0 - (y_3 * (0.5 + (y_3 * (-0.041666668 + (y_3 * 0.0013888889))))));
    return float2(s, c);
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
    float t_3 = (small / large);
    bool is_wide = (t_3 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_3);
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
    float s_2 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_2 = (u_2.half_cos + (u_2.half_sin * 0.0));
    float2 upper_1 = ((c_2 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_2));
    float2 turned_1 = (((s_2 <= 0.0) & (s_2 < c_2)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_4 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_4;
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_7, float low, float high)
{
    const float _e3 = bounded(x_7);
    const float _e8 = bounded(((_e3 - 0.5) / 0.5));
    float t_4 = clamp(_e8, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float footprint_of_vec3_(float3 v_3)
{
    float3 dx_1 = ddx(v_3);
    float3 dy_1 = ddy(v_3);
    const float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

float3 any_orthogonal(float3 n)
{
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a_1 = (-1.0 / (sign_ + n.z));
    return float3((1.0 + (((sign_ * n.x) * n.x) * a_1)), (((sign_ * n.x) * n.y) * a_1), (-(sign_) * n.x));
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
    const float3 _e5 = normalize_moderate(y_axis, (0.0).xxx);
    const DirectionParts directionparts = ConstructDirectionParts(direction, x_axis, _e5, float2(dot(direction, x_axis), dot(direction, _e5)));
    return directionparts;
}

float3 direction_moved(DirectionParts parts, float2 by)
{
    float3 moved = ((parts.direction + (by.x * parts.x_axis)) + (by.y * parts.y_axis));
    const float3 _e13 = normalize_moderate(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e13 : parts.direction);
}

float3x3 axes_around(float3 toward, float3 up)
{
    float3 leaning = cross(up, toward);
    float square_2 = dot(leaning, leaning);
    float3 aside = ((abs(toward.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    const float3 _e28 = normalize_moderate((across - (dot(across, toward) * toward)), float3(1.0, 0.0, 0.0));
    return float3x3(_e28, cross(toward, _e28), toward);
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

float3 half_vector(Light light, float3 view)
{
    float3 half_1 = (light.direction + view);
    const float3 _e4 = any_orthogonal(view);
    const float3 _e9 = normalize_or(((dot(half_1, half_1) > 1e-12) ? half_1 : _e4), view);
    return _e9;
}

float3 stretch_direction(float3 direction_2, float3 x_axis_1, float3 y_axis_1, float x_8, float y_2)
{
    const DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    const float3 _e10 = direction_moved(_e5, (-(float2(x_8, y_2)) * _e5.place));
    return _e10;
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

float4 blend_alpha_2_(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return clamp(float4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
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

float profile_point_3_(Angle u_5, ProfileShape shape_2)
{
    float s_5 = (u_5.half_sin - (u_5.half_cos * 0.0));
    if (((s_5 <= 0.0) | false)) {
        return 1.0;
    }
    float q_4 = (s_5 * shape_2.scale);
    const float _e15 = profile_power_2_(q_4, shape_2.exponent);
    return _e15;
}

float profile_filtered(Angle u_6, float w, ProfileShape shape_3)
{
    const float _e3 = profile_point(u_6, shape_3);
    bool is_wide_1 = (w < (0.1 * shape_3.edge_deviation));
    if (((is_wide_1 | (w <= 0.0)) | false)) {
        return _e3;
    }
    const float2 _e15 = sin_cos_tiny((0.19364917 * w));
    const Angle _e16 = angle_turned(u_6, _e15);
    const float _e17 = profile_point(_e16, shape_3);
    const Angle _e22 = angle_turned(u_6, float2(-(_e15.x), _e15.y));
    const float _e23 = profile_point(_e22, shape_3);
    return ((((5.0 * _e17) + (8.0 * _e3)) + (5.0 * _e23)) / 18.0);
}

float profile_filtered_2_(Angle u_7, float w_1, ProfileShape shape_4)
{
    const float _e3 = profile_point_2_(u_7, shape_4);
    bool is_wide_2 = (w_1 < (0.1 * shape_4.edge_deviation));
    if (((is_wide_2 | (w_1 <= 0.0)) | false)) {
        return _e3;
    }
    if ((true & (w_1 >= (3.4641016 * shape_4.edge_deviation)))) {
        float width = sqrt(((w_1 * w_1) + ((12.0 * shape_4.edge_deviation) * shape_4.edge_deviation)));
        const float _e32 = atan2_positive(u_7.half_sin, u_7.half_cos);
        return clamp((0.5 + (((shape_4.offset + shape_4.edge_mean) - (2.0 * _e32)) / width)), 0.0, 1.0);
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
        float width_1 = sqrt(((w_2 * w_2) + ((12.0 * shape_5.edge_deviation) * shape_5.edge_deviation)));
        const float _e30 = atan2_positive(u_8.half_sin, u_8.half_cos);
        return clamp((0.5 + ((shape_5.edge_mean - (2.0 * _e30)) / width_1)), 0.0, 1.0);
    }
    const float2 _e42 = sin_cos_tiny((0.19364917 * w_2));
    const Angle _e43 = angle_turned(u_8, _e42);
    const float _e44 = profile_point_3_(_e43, shape_5);
    const Angle _e49 = angle_turned(u_8, float2(-(_e42.x), _e42.y));
    const float _e50 = profile_point_3_(_e49, shape_5);
    return ((((5.0 * _e44) + (8.0 * _e3)) + (5.0 * _e50)) / 18.0);
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
    const float2 _e5 = sin_cos_tiny((0.5 * shift_1));
    const Angle _e6 = angle_turned(angle_1, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_3_(Angle angle_2, float shift_2, ProfileShape shape_8)
{
    const float2 _e5 = sin_cos_tiny((0.5 * shift_2));
    const Angle _e6 = angle_turned(angle_2, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_3_(_e6, _e7, shape_8);
    return _e8;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_4 = (uint3)0;

    v_4 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_4.x;
    uint _e10 = v_4.y;
    uint _e12 = v_4.z;
    v_4.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_4.y;
    uint _e18 = v_4.z;
    uint _e20 = v_4.x;
    v_4.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_4.z;
    uint _e26 = v_4.x;
    uint _e28 = v_4.y;
    v_4.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_4;
    uint3 _e32 = v_4;
    v_4 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_4.x;
    uint _e40 = v_4.y;
    uint _e42 = v_4.z;
    v_4.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_4.y;
    uint _e48 = v_4.z;
    uint _e50 = v_4.x;
    v_4.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_4.z;
    uint _e56 = v_4.x;
    uint _e58 = v_4.y;
    v_4.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_4;
    return _e61;
}

uint3 lattice_hash(int3 cell, uint seed_1)
{
    const uint3 _e9 = hash_pcg3d((asuint(cell) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod((hash.x >> 8u), 3u);
    float a_2 = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_2 : -(a_2)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
}

float3 fade_quintic(float3 t_2)
{
    return (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i = int(0);

    float3 corner = floor(p);
    float3 d_1 = (p - corner);
    const float3 _e4 = fade_quintic(d_1);
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e46 = i;
            i = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init = false;
        int _e10 = i;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            int3 at = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_1) + asuint(at)), seed_2);
            const float _e42 = gradient_dot(_e39, (d_1 - float3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, float3 p_1, int octaves, float roughness, int seed_3, float w_3)
{
    float octave = (float)0;
    int i_1 = int(0);
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;

    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e67 = i_1;
            i_1 = asint(asuint(_e67) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e17 = i_1;
        if (!((_e17 < int(2)))) {
            break;
        }
        float _e21 = frequency;
        const float _e25 = eased((w_3 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            float3 place = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_1;
            const float _e50 = perlin_noise(place, (0u + uint(_e47)));
            octave = lerp(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * 0.5);
        float _e64 = frequency;
        frequency = (_e64 * 2.0);
    }
    float _e70 = sum_1;
    return min((_e70 / 1.5), 1.0);
}

float noise_perlin(float3 position, float scale, int octaves_1, float roughness_1, int seed_4)
{
    float3 p_2 = (position * scale);
    const float _e7 = footprint_of_vec3_(p_2);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

float4 shade(Surface surface_1)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle turned_from_the_key = ConstructAngle((0.5 * length((surface_1.normal - _e5))), (0.5 * length((surface_1.normal + _e14))));
    const float _e22 = profile(turned_from_the_key, 0.0, lit_side_shape);
    const float4 _e35 = blend_alpha(float4(0.2275, 0.102, 0.2431, 1.0), float4(0.4824, 0.1843, 0.3882, 1.0), _e22, 1.0, true);
    float3 normal_2 = surface_1.normal;
    Light _e39 = look.key;
    const float3 _e41 = half_vector(_e39, surface_1.view);
    const AxesAround _e46 = axes(_e41, float3(0.0, 1.0, 0.0));
    const float3 _e51 = stretch_direction(normal_2, _e46.x_axis, _e46.y_axis, 0.985, 0.0);
    Angle from_the_band = ConstructAngle((0.5 * length((_e51 - _e41))), (0.5 * length((_e51 + _e41))));
    float3 place_1 = surface_1.position_object;
    const float _e66 = noise_perlin(place_1, 14.0, int(2), 0.5, int(0));
    float waver = lerp(-0.05, 0.05, (_e66 - 0.0));
    const float _e73 = profile_2_(from_the_band, waver, band_shape);
    const float4 _e81 = blend_alpha_2_(_e35, float4(0.9529, 0.6627, 0.7059, 1.0), _e73, 0.95, true);
    Light _e84 = look.low;
    const float3 _e86 = half_vector(_e84, surface_1.view);
    const AxesAround _e91 = axes(_e86, float3(0.0, 1.0, 0.0));
    const float3 _e96 = stretch_direction(normal_2, _e91.x_axis, _e91.y_axis, 0.985, 0.0);
    Angle from_the_second = ConstructAngle((0.5 * length((_e96 - _e86))), (0.5 * length((_e96 + _e86))));
    const float _e107 = profile_3_(from_the_second, waver, second_band_shape);
    float4 output = clamp(float4((_e81.xyz + (0.8 * ((_e81.xyz + (_e107 * float3(0.3529, 0.2471, 0.549))) - _e81.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
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

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_3;
    float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    surface.position_object = in_.position_object;
    Surface _e23 = surface;
    const float4 _e24 = shade(_e23);
    return _e24;
}
