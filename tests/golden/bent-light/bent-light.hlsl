// Light that wavers: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// bent-light.json says what to put there and how to draw.
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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light eye;
    Light key;
    float3 parts_direction;
    int _pad4_0;
    float3 axes_of_the_light_x_axis;
    int _pad5_0;
    float3 axes_of_the_light_y_axis;
    int _end_pad_0;
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

struct LightParts {
    float3 direction;
    int _pad1_0;
    float4 color;
    float intensity;
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

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const uint NOISE_PERLIN = 1u;
static const uint NOISE_SIMPLEX = 2u;
static const uint NOISE_WORLEY = 3u;
static const float SIMPLEX_SCALE = 38.4553;
static const float WORLEY_MEAN = 0.5205;
static const ProfileShape lit_shape = ConstructProfileShape(0.8253356, 0.5646425, 25.006668, 1.7790966, 1.2, 0.04446849, 0.018017149, 0u);
static const ProfileShape brightest_shape = ConstructProfileShape(0.9358968, 0.35227424, 40.004166, 3.6241908, 0.72, 0.021168118, 0.009611014, 0u);
static const ProfileShape window_shape = ConstructProfileShape(0.9963897, 0.08489768, 0.0, 1.0, 0.17, 0.0, 0.0, 1u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_3 : LOC1;
    float3 normal_3 : LOC2;
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
    float clamped_4 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_4);
    float f = ((clamped_4 - whole) * LN_2_);
    float p_6 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p_6 * _e33) * _e37);
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
    float p_7 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_7 * p_7) + (s_1 * s_1)), 1e-30)));
    const Angle angle_1 = ConstructAngle((p_7 * k), (s_1 * k));
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
    float a_1 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_1) : a_1);
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
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_2, 0.5);
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

float remapped(float x_8, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_8);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_9, float low_1, float high_1)
{
    const float _e3 = bounded(x_9);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_4 = clamp(_e6, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float footprint_of(float x_10)
{
    float _e1 = ddx(x_10);
    float _e2 = ddy(x_10);
    float2 d_3 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_3, d_3)));
    return _e6;
}

float footprint_of_vec3_(float3 v_4)
{
    float3 dx_1 = ddx(v_4);
    float3 dy_1 = ddy(v_4);
    const float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float3 position_object(float3 position_object_1)
{
    return position_object_1;
}

float3 view_2_(float3 view_2_1)
{
    return view_2_1;
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

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light light_toward(Light light, float3 direction_2)
{
    const float3 _e3 = normalize_or(direction_2, light.direction);
    const Light light_2 = ConstructLight(_e3, light.own_direction, light.color, light.intensity);
    return light_2;
}

float3 shift_direction(float3 direction_3, float3 x_axis_1, float3 y_axis_1, float x_11, float y_2)
{
    const DirectionParts _e5 = direction_within(direction_3, x_axis_1, y_axis_1);
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

float4 blend_alpha(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_2)
{
    float a_2 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_2) * (1.0 - below_1.w)));
    const float4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_2, clamped_2);
    return _e20;
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light_1, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light_1.direction);
    const Angle angle_4 = _e8;
    return angle_4;
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
        float width_2 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_2)), 0.0, 1.0);
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

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_5 = (uint3)0;

    v_5 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_5.x;
    uint _e10 = v_5.y;
    uint _e12 = v_5.z;
    v_5.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_5.y;
    uint _e18 = v_5.z;
    uint _e20 = v_5.x;
    v_5.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_5.z;
    uint _e26 = v_5.x;
    uint _e28 = v_5.y;
    v_5.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_5;
    uint3 _e32 = v_5;
    v_5 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_5.x;
    uint _e40 = v_5.y;
    uint _e42 = v_5.z;
    v_5.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_5.y;
    uint _e48 = v_5.z;
    uint _e50 = v_5.x;
    v_5.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_5.z;
    uint _e56 = v_5.x;
    uint _e58 = v_5.y;
    v_5.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_5;
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float gradient_dot(uint3 hash_1, float3 d_1)
{
    uint axis = naga_mod((hash_1.x >> 8u), 3u);
    float a_3 = ((axis == 0u) ? d_1.y : d_1.x);
    float b_1 = ((axis == 2u) ? d_1.y : d_1.z);
    return ((((hash_1.y >> 31u) == 0u) ? a_3 : -(a_3)) + (((hash_1.z >> 31u) == 0u) ? b_1 : -(b_1)));
}

float3 fade_quintic(float3 t_2)
{
    return (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i = int(0);

    float3 corner = floor(p);
    const float3 _e4 = fade_quintic((p - corner));
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e45 = i;
            i = asint(asuint(_e45) + asuint(int(1)));
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
    int i_1 = int(0);

    float3 corner_1 = floor(p_1);
    float3 d_4 = (p_1 - corner_1);
    const float3 _e4 = fade_quintic(d_4);
    int3 cell_2 = naga_f2i32(corner_1);
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e46 = i_1;
            i_1 = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e10 = i_1;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_1;
            int _e16 = i_1;
            int _e21 = i_1;
            int3 at_1 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight_1 = ((at_1 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum_1;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_2) + asuint(at_1)), seed_3);
            const float _e42 = gradient_dot(_e39, (d_4 - float3(at_1)));
            sum_1 = (_e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42));
        }
    }
    float _e48 = sum_1;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float simplex_corner(float3 d_2, uint3 hash_2)
{
    float t_5 = max((0.5 - dot(d_2, d_2)), 0.0);
    const float _e10 = gradient_dot(hash_2, d_2);
    return ((((t_5 * t_5) * t_5) * t_5) * _e10);
}

float simplex_noise(float3 p_2, uint seed_4)
{
    float sum_2 = (float)0;

    float3 corner_2 = floor((p_2 + ((((p_2.x + p_2.y) + p_2.z) / 3.0)).xxx));
    float3 d_5 = ((p_2 - corner_2) + ((((corner_2.x + corner_2.y) + corner_2.z) / 6.0)).xxx);
    bool3 is_first = bool3((d_5.x >= d_5.y), (d_5.y >= d_5.z), (d_5.z > d_5.x));
    float3 g = (is_first ? (1.0).xxx : (0.0).xxx);
    float3 l_1 = ((1.0).xxx - g);
    float3 second = min(g, l_1.zxy);
    float3 third = max(g, l_1.zxy);
    int3 cell_3 = naga_f2i32(corner_2);
    const uint3 _e45 = lattice_hash(cell_3, seed_4);
    const float _e46 = simplex_corner(d_5, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    const uint3 _e55 = lattice_hash(asint(asuint(cell_3) + asuint(naga_f2i32(second))), seed_4);
    const float _e56 = simplex_corner(((d_5 - second) + (0.16666667).xxx), _e55);
    sum_2 = (_e48 + _e56);
    float _e58 = sum_2;
    const uint3 _e65 = lattice_hash(asint(asuint(cell_3) + asuint(naga_f2i32(third))), seed_4);
    const float _e66 = simplex_corner(((d_5 - third) + (0.33333334).xxx), _e65);
    sum_2 = (_e58 + _e66);
    float _e68 = sum_2;
    const uint3 _e75 = lattice_hash(asint(asuint(cell_3) + asuint((int(1)).xxx)), seed_4);
    const float _e76 = simplex_corner((d_5 - (0.5).xxx), _e75);
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
    int i_2 = int(0);

    float3 corner_3 = floor(p_3);
    float3 d_6 = (p_3 - corner_3);
    int3 cell_4 = naga_f2i32(corner_3);
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e40 = i_2;
            i_2 = asint(asuint(_e40) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e9 = i_2;
        if ((_e9 < int(27))) {
        } else {
            break;
        }
        {
            int _e12 = i_2;
            int _e17 = i_2;
            int _e24 = i_2;
            int3 at_2 = int3(asint(asuint(naga_mod(_e12, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e17, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e24, int(9))) - asuint(int(1))));
            const uint3 _e32 = lattice_hash(asint(asuint(cell_4) + asuint(at_2)), seed_5);
            const float3 _e33 = unit_of_hash(_e32);
            float3 offset = ((float3(at_2) + _e33) - d_6);
            float _e36 = nearest;
            nearest = min(_e36, dot(offset, offset));
        }
    }
    float _e42 = nearest;
    return sqrt(_e42);
}

float noise_octave(uint kind, float3 p_4, uint seed_6)
{
    switch(kind) {
        case 1u: {
            const float _e3 = perlin_noise(p_4, seed_6);
            return _e3;
        }
        case 2u: {
            const float _e4 = simplex_noise(p_4, seed_6);
            return _e4;
        }
        case 3u: {
            const float _e5 = worley_noise(p_4, seed_6);
            return _e5;
        }
        default: {
            const float _e6 = value_noise(p_4, seed_6);
            return _e6;
        }
    }
}

float fractal_noise(uint kind_1, float3 p_5, int octaves, float roughness, int seed_7, float w_1)
{
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_3 = int(0);
    float octave = (float)0;

    float mean = ((kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5);
    const float _e11 = bounded(roughness);
    float gain = clamp(_e11, 0.0, 1.0);
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e75 = i_3;
            i_3 = asint(asuint(_e75) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e25 = i_3;
        if ((_e25 < clamp(octaves, int(1), int(8)))) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            const float _e34 = eased((w_1 * _e30), 0.5, 1.0);
            float visible = (1.0 - _e34);
            octave = mean;
            if ((visible > 0.0)) {
                float _e40 = frequency;
                int _e42 = i_3;
                float3 place = clamp(((p_5 * _e40) + (float(_e42) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
                int _e56 = i_3;
                const float _e59 = noise_octave(kind_1, place, (asuint(seed_7) + uint(_e56)));
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

float map_range(float value, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_3)
{
    const float _e6 = remapped(value, from_low_1, from_high_1, to_low_1, to_high_1, clamped_3);
    return _e6;
}

float line_covers(float distance_, float width)
{
    return clamp(((width + 0.5) - distance_), 0.0, min(width, 1.0));
}

float outer_contour(float width_1, float3 normal_1, float3 view_2_2, float2 viewport)
{
    const float3 _e6 = normalize_or(normal_1, (0.0).xxx);
    float facing = clamp(dot(_e6, view_2_2), 0.0, 1.0);
    const float _e11 = bounded(width_1);
    float pixels = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport.y, 1.0, 100000.0)) / 1000.0);
    const float _e22 = footprint_of(facing);
    float distance_1 = (facing / max((2.0 * _e22), 1e-6));
    const float _e30 = eased(facing, 0.45, 0.75);
    float near = (1.0 - _e30);
    const float _e33 = line_covers(distance_1, pixels);
    return (_e33 * near);
}

float noise_perlin(float3 position, float scale, int octaves_1, float roughness_1, int seed_8)
{
    const float3 _e6 = bounded_vec3_((position * scale));
    const float _e8 = footprint_of_vec3_(_e6);
    const float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_8, _e8);
    return _e9;
}

float4 shade(Surface surface_1)
{
    const float3 _e2 = position_object(surface_1.position_object);
    const float _e7 = noise_perlin(_e2, 3.5, int(2), 0.5, int(1));
    const float _e13 = map_range(_e7, 0.0, 1.0, -0.22, 0.22, true);
    const float _e18 = noise_perlin(_e2, 3.5, int(2), 0.5, int(5));
    const float _e24 = map_range(_e18, 0.0, 1.0, -0.22, 0.22, true);
    float3 _e27 = look.parts_direction;
    float3 _e30 = look.axes_of_the_light_x_axis;
    float3 _e33 = look.axes_of_the_light_y_axis;
    const float3 _e34 = shift_direction(_e27, _e30, _e33, _e13, _e24);
    Light _e37 = look.key;
    const Light _e38 = light_toward(_e37, _e34);
    const Angle _e40 = parametrization_diffuse(_e38, surface_1.normal);
    const float _e43 = profile(_e40, 0.0, lit_shape);
    const float4 _e56 = blend_alpha(float4(0.1529, 0.251, 0.3765, 1.0), float4(0.3098, 0.5608, 0.6118, 1.0), _e43, 1.0, true);
    const float _e59 = profile(_e40, 0.0, brightest_shape);
    const float4 _e67 = blend_alpha(_e56, float4(0.6627, 0.8392, 0.7569, 1.0), _e59, 1.0, true);
    const float3 _e69 = view_2_(surface_1.view);
    const AxesAround _e74 = axes(_e69, float3(0.0, 1.0, 0.0));
    const float3 _e79 = shift_direction(_e69, _e74.x_axis, _e74.y_axis, -0.32, 0.36);
    Light _e82 = look.eye;
    const Light _e83 = light_toward(_e82, _e79);
    const Angle _e85 = parametrization_diffuse(_e83, surface_1.normal);
    const float _e88 = profile(_e85, 0.0, window_shape);
    const float4 _e96 = blend_alpha(_e67, float4(0.9922, 0.9647, 0.8902, 1.0), _e88, 1.0, true);
    float2 _e102 = look.viewport;
    const float _e103 = outer_contour(3.0, surface_1.normal, surface_1.view, _e102);
    const float4 _e111 = blend_alpha(_e96, float4(0.0784, 0.1294, 0.2275, 1.0), _e103, 1.0, true);
    const float4 _e112 = output(_e111);
    return _e112;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_3, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    float4 _e15 = view.eye;
    float _e20 = view.eye.w;
    float4 _e26 = view.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    Surface _e36 = surface;
    const float4 _e37 = shade(_e36);
    const float4 _e38 = finite_vec4_(_e37);
    return _e38;
}
