// Half-tone comic: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2.
// halftone-comic.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    float4 eye;
    float4 screen;
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
    float2 viewport;
    int _end_pad_0;
    int _end_pad_1;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float2 pixel;
    int _end_pad_0;
    int _end_pad_1;
};

struct Angle {
    float half_sin;
    float half_cos;
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
static const ProfileShape not_in_deep_shade_shape = ConstructProfileShape(0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0, 0.0, 1u);
static const ProfileShape highlight_shape = ConstructProfileShape(0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u);

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
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p_1 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p_1 * _e33) * _e37);
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

float2 sin_cos(float x_5)
{
    float turns = round((x_5 * 0.31830987));
    float r_1 = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    const float2 _e27 = sin_cos_quarter(clamp(r_1, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_between(float3 d, float3 l)
{
    float p_2 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_2 * p_2) + (s_1 * s_1)), 1e-30)));
    const Angle angle_4 = ConstructAngle((p_2 * k), (s_1 * k));
    return angle_4;
}

float atan2_positive(float y_1, float x_6)
{
    float small = min(y_1, x_6);
    float large = max(y_1, x_6);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_4 = (small / large);
    bool is_wide = (t_4 > 0.41421357);
    float r_2 = (is_wide ? ((small - large) / (small + large)) : t_4);
    float r2_ = (r_2 * r_2);
    float series_1 = (r_2 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_8 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_6) ? (HALF_PI - a_8) : a_8);
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
    const Angle angle_5 = ConstructAngle(turned.x, turned.y);
    return angle_5;
}

Angle angle_shifted(Angle u_2, float shift)
{
    const float2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    const Angle _e8 = angle_turned(u_2, _e7);
    const Angle angle_6 = _e8;
    return angle_6;
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

float bounded(float x_7)
{
    uint bits_1 = asuint(x_7);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_7 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float2 bounded_vec2_(float2 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    return float2(_e2, _e4);
}

float3 bounded_vec3_(float3 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    return float3(_e2, _e4, _e6);
}

float4 bounded_vec4_(float4 v_5)
{
    const float _e2 = bounded(v_5.x);
    const float _e4 = bounded(v_5.y);
    const float _e6 = bounded(v_5.z);
    const float _e8 = bounded(v_5.w);
    return float4(_e2, _e4, _e6, _e8);
}

float mixed(float a, float b, float t_1)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_1, float3 b_1, float t_2)
{
    const float _e5 = mixed(a_1.x, b_1.x, t_2);
    const float _e8 = mixed(a_1.y, b_1.y, t_2);
    const float _e11 = mixed(a_1.z, b_1.z, t_2);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_2, float4 b_2, float t_3)
{
    const float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_3);
    const float _e8 = mixed(a_2.w, b_2.w, t_3);
    return float4(_e5, _e8);
}

float place_between(float x_8, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_8 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_8 - low) / _e12));
    return _e14;
}

float remapped(float x_9, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_9);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_10, float low_1, float high_1)
{
    const float _e3 = bounded(x_10);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float factor_of(float x_11, bool clamped_1)
{
    const float _e2 = bounded(x_11);
    const float _e3 = bounded(x_11);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float2 sin_cos_of(float x_12)
{
    const float _e1 = bounded(x_12);
    const float2 _e2 = sin_cos(_e1);
    return clamp(_e2, (-1.0).xx, (1.0).xx);
}

float2 footprint_of_vec2_(float2 v_6)
{
    float2 dx_1 = ddx(v_6);
    float2 dy_1 = ddy(v_6);
    const float2 _e7 = bounded_vec2_(sqrt(((dx_1 * dx_1) + (dy_1 * dy_1))));
    return _e7;
}

float4 color_mixed(float4 a_3, float3 blended, float factor)
{
    const float3 _e4 = bounded_vec3_(a_3.xyz);
    const float3 _e5 = bounded_vec3_(blended);
    const float _e7 = factor_of(factor, true);
    const float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    const float _e10 = bounded(a_3.w);
    return float4(_e8, _e10);
}

float4 premultiplied(float4 color)
{
    return float4((color.xyz * color.w), color.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 mix_colors_normal(float4 a_4, float4 b_3, float factor_1)
{
    const float4 _e3 = bounded_vec4_(a_4);
    const float4 _e4 = bounded_vec4_(b_3);
    const float _e6 = factor_of(factor_1, true);
    const float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float4 mix_colors_multiply(float4 a_5, float4 b_4, float factor_2)
{
    const float4 _e6 = color_mixed(a_5, (a_5.xyz * b_4.xyz), factor_2);
    return _e6;
}

float facing(float3 normal, float3 view)
{
    const float3 _e4 = normalize_or(normal, (0.0).xxx);
    return clamp(dot(_e4, view), 0.0, 1.0);
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light, float3 normal_1)
{
    const float3 _e6 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light.direction);
    const Angle angle_7 = _e8;
    return angle_7;
}

Angle parametrization_specular(Light light_1, float3 normal_2, float3 view_1)
{
    const float3 _e7 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    float3 mirrored = (((2.0 * dot(_e7, view_1)) * _e7) - view_1);
    const float3 _e13 = normalize_or(mirrored, _e7);
    const Angle _e15 = angle_between(_e13, light_1.direction);
    const Angle angle_8 = _e15;
    return angle_8;
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
        float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width)), 0.0, 1.0);
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

float2 turned_by(float2 p, float angle_1)
{
    const float2 _e2 = sin_cos_of(angle_1);
    return float2(((_e2.y * p.x) - (_e2.x * p.y)), ((_e2.x * p.x) + (_e2.y * p.y)));
}

float2 screen_cells(float2 place, float2 viewport, float lines, float angle_2)
{
    float2 most = (4194304.0).xx;
    const float2 _e6 = bounded_vec2_(place);
    const float _e7 = bounded(lines);
    const float2 _e15 = bounded_vec2_((_e6 * (max(_e7, 0.0) / max(viewport.y, 1.0))));
    const float2 _e18 = turned_by(clamp(_e15, -(most), most), angle_2);
    return clamp(_e18, -(most), most);
}

float dot_radius(float share)
{
    float a_6 = (float)0;
    int i = int(0);

    float t_6 = clamp(share, 0.0, 1.0);
    if ((t_6 <= 0.7853982)) {
        return sqrt((t_6 * 0.31830987));
    }
    float s_4 = min(((t_6 - 0.7853982) / (1.0 - 0.7853982)), 1.0);
    a_6 = lerp((0.5227232 * sqrt(s_4)), (0.7853982 - (0.3275682 * sqrt((1.0 - s_4)))), s_4);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e63 = i;
            i = asint(asuint(_e63) + asuint(int(1)));
        }
        loop_init = false;
        int _e28 = i;
        if ((_e28 < int(2))) {
        } else {
            break;
        }
        {
            float _e31 = a_6;
            const float2 _e34 = sin_cos_quarter(clamp(_e31, 0.0, 0.7853982));
            float tangent = (_e34.x / _e34.y);
            float square_1 = (1.0 / (_e34.y * _e34.y));
            float _e44 = a_6;
            float sector = (0.7853982 - _e44);
            float slope = (((2.0 * sector) * square_1) * tangent);
            float _e50 = a_6;
            a_6 = clamp((_e50 - ((slope > 0.001) ? ((((sector * square_1) + tangent) - t_6) / slope) : 0.0)), 0.0, 0.7853982);
        }
    }
    float _e65 = a_6;
    const float2 _e66 = sin_cos_quarter(_e65);
    return (0.5 / _e66.y);
}

float disk_filtered(float d_1, float r, float w_1)
{
    bool local_5 = (bool)0;

    if ((w_1 < 1e-30)) {
        if ((d_1 <= r)) {
            local_5 = (r > 0.0);
        } else {
            local_5 = false;
        }
        bool _e11 = local_5;
        return (_e11 ? 1.0 : 0.0);
    }
    float square_2 = (r * r);
    float least = ((w_1 * w_1) / 3.0);
    float inner = sqrt((max(square_2, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d_1) / w_1)), 0.0, 1.0) * min((square_2 / least), 1.0));
}

float ink_of_dots(float2 cell, float share_1, float w_2)
{
    float ink = (float)0;
    bool local_6 = (bool)0;

    float width_1 = min(w_2, 1.0);
    const float _e8 = dot_radius(share_1);
    const float _e9 = disk_filtered(length((cell - round(cell))), _e8, width_1);
    ink = _e9;
    float hole = sqrt((max((1.0 - share_1), 0.0) * 0.31830987));
    const float _e22 = eased(width_1, (0.3 * hole), (0.9 * hole));
    const float _e25 = eased(share_1, 0.5, 0.7);
    float is_star = (_e22 * _e25);
    if ((is_star > 0.0)) {
        float _e29 = ink;
        const float _e36 = disk_filtered(length(((cell - floor(cell)) - (0.5).xx)), hole, width_1);
        ink = lerp(_e29, (1.0 - _e36), is_star);
    }
    float _e40 = ink;
    const float _e43 = eased(w_2, 0.4, 1.0);
    float mean = lerp(_e40, share_1, _e43);
    if (!((share_1 <= 0.0))) {
        local_6 = (share_1 >= 1.0);
    } else {
        local_6 = true;
    }
    bool _e53 = local_6;
    return (_e53 ? share_1 : mean);
}

float reflectance_wrap(Light light_2, float3 normal_3, float wrap)
{
    const float _e3 = bounded(wrap);
    float w_4 = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal_3, float3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light_2.direction);
    return max(((cosine + w_4) / (1.0 + w_4)), 0.0);
}

float invert(float value)
{
    const float _e3 = bounded((1.0 - value));
    return _e3;
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2)
{
    const float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(float a_7, float b_5)
{
    const float _e3 = bounded((a_7 * b_5));
    return _e3;
}

float smooth_step_value(float value_2, float low_2, float high_2)
{
    const float _e3 = eased(value_2, low_2, high_2);
    return _e3;
}

float halftone_dots(float value_3, float2 place_1, float lines_1, float angle_3, float2 viewport_1)
{
    const float2 _e5 = screen_cells(place_1, viewport_1, lines_1, angle_3);
    const float2 _e6 = footprint_of_vec2_(_e5);
    const float _e8 = factor_of(value_3, true);
    const float _e14 = ink_of_dots(_e5, (1.0 - _e8), max(_e6.x, _e6.y));
    return (1.0 - _e14);
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.25);
    const float _e12 = map_range(_e6, 0.1, 0.75, 0.15, 1.0, true);
    float2 _e18 = look.viewport;
    const float _e19 = halftone_dots(_e12, surface_1.pixel, 78.0, 0.2617994, _e18);
    const float4 _e30 = mix_colors_normal(float4(0.91, 0.3, 0.24, 1.0), float4(1.0, 0.87, 0.58, 1.0), _e19);
    Light _e33 = look.key;
    const Angle _e35 = parametrization_diffuse(_e33, surface_1.normal);
    const float _e38 = profile(_e35, 0.0, not_in_deep_shade_shape);
    const float _e39 = invert(_e38);
    const float _e41 = multiply(_e39, 0.62);
    const float _e42 = invert(_e41);
    float2 _e48 = look.viewport;
    const float _e49 = halftone_dots(_e42, surface_1.pixel, 78.0, 1.3089969, _e48);
    const float _e50 = invert(_e49);
    const float4 _e56 = mix_colors_multiply(_e30, float4(0.24, 0.3, 0.58, 1.0), _e50);
    Light _e59 = look.key;
    const Angle _e62 = parametrization_specular(_e59, surface_1.normal, surface_1.view);
    const float _e65 = profile(_e62, 0.0, highlight_shape);
    const float4 _e71 = mix_colors_normal(_e56, float4(1.0, 0.99, 0.95, 1.0), _e65);
    const float _e74 = facing(surface_1.normal, surface_1.view);
    const float _e77 = smooth_step_value(_e74, 0.3, 0.22);
    const float4 _e83 = mix_colors_normal(_e71, float4(0.09, 0.07, 0.13, 1.0), _e77);
    const float4 _e84 = premultiplied(_e83);
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
    float4 _e39 = view_2.screen;
    float4 _e44 = view_2.screen;
    surface.pixel = ((in_.clip_.xy * _e39.xy) + _e44.zw);
    Surface _e47 = surface;
    const float4 _e48 = shade(_e47);
    const float4 _e49 = finite_vec4_(_e48);
    return _e49;
}
