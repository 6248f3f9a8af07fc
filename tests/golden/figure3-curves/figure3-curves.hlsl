// Profile curves: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1.
// figure3-curves.json says what to put there and how to draw.
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

struct Surface {
    float2 uv;
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

struct VectorParts {
    float x;
    float y;
    float z;
};

struct Vertex {
    float3 position : LOC0;
    float2 uv : LOC3;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float2 uv : LOC0;
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
static const ProfileShape lambert_shape = ConstructProfileShape(1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u);
static const ProfileShape half_lambert_shape = ConstructProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);
static const ProfileShape custom_shape = ConstructProfileShape(0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }

struct VertexOutput_vs_main {
    float2 uv_2 : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float2 uv_3 : LOC0;
    float4 clip_1 : SV_Position;
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
    float a_2 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_2) : a_2);
}

float angle_radians(Angle u)
{
    const float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_of(float radians_)
{
    const float _e2 = finite_or(radians_, 0.0);
    float half_angle = (0.5 * clamp(_e2, 0.0, PI));
    const float2 _e8 = sin_cos_quarter(half_angle);
    const Angle angle_1 = ConstructAngle(max(_e8.x, 0.0), max(_e8.y, 0.0));
    return angle_1;
}

Angle angle_turned(Angle u_1, float2 t)
{
    bool local_1 = (bool)0;

    float s_1 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_1, c_1));
    if ((s_1 <= 0.0)) {
        local_1 = (s_1 < c_1);
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

float footprint_of(float x_9)
{
    float _e1 = ddx(x_9);
    float _e2 = ddy(x_9);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
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

float unit_share(float share)
{
    return clamp(share, 0.0, 1.0);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float2 uv(float2 uv_1)
{
    return uv_1;
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
    float a_3 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_3) * (1.0 - below_1.w)));
    const float4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_3, clamped_2);
    return _e20;
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
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

    float s_2 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_2 <= 0.0))) {
        local_2 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_2 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_2 * shape.scale);
    const float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w_2 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
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

float threshold(float value, float edge_1, float softness_1)
{
    const float _e3 = footprint_of(value);
    const float _e4 = bounded(value);
    const float _e5 = bounded(edge_1);
    const float _e6 = edge_width(_e3, softness_1);
    const float _e7 = step_filtered(_e4, _e5, _e6);
    return _e7;
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_3)
{
    const float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_3);
    return _e6;
}

float subtract(float a_1, float b_1)
{
    const float _e3 = bounded((a_1 - b_1));
    return _e3;
}

VectorParts ConstructVectorParts(float arg0, float arg1, float arg2) {
    VectorParts ret = (VectorParts)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

VectorParts separate_vector(float3 vector_)
{
    const VectorParts vectorparts = ConstructVectorParts(vector_.x, vector_.y, vector_.z);
    return vectorparts;
}

float4 shade(Surface surface_1)
{
    const float2 _e2 = uv(surface_1.uv);
    const VectorParts _e5 = separate_vector(float3(_e2, 0.0));
    const float _e12 = map_range(_e5.y, 0.14, 0.86, 0.0, 1.0, false);
    const float _e15 = threshold(_e12, -0.006, 0.0);
    const float _e18 = threshold(_e12, 0.006, 0.0);
    const float _e19 = subtract(_e15, _e18);
    const float _e20 = unit_share(_e19);
    const float4 _e33 = blend_alpha(float4(0.98, 0.965, 0.925, 1.0), float4(0.24, 0.26, 0.3, 1.0), _e20, 1.0, true);
    const float _e40 = map_range(_e5.x, 0.08, 0.92, 0.0, 3.1415927, false);
    const float _e43 = threshold(_e40, -0.012, 0.0);
    const float _e46 = threshold(_e40, 0.012, 0.0);
    const float _e47 = subtract(_e43, _e46);
    const float _e48 = unit_share(_e47);
    const float4 _e56 = blend_alpha(_e33, float4(0.24, 0.26, 0.3, 1.0), _e48, 1.0, true);
    const float _e59 = threshold(_e40, 0.492, 0.0);
    const float _e62 = threshold(_e40, 0.508, 0.0);
    const float _e63 = subtract(_e59, _e62);
    const float _e64 = unit_share(_e63);
    const float4 _e72 = blend_alpha(_e56, float4(0.2, 0.38, 0.78, 1.0), _e64, 0.55, true);
    const float _e75 = threshold(_e40, 0.942, 0.0);
    const float _e78 = threshold(_e40, 0.958, 0.0);
    const float _e79 = subtract(_e75, _e78);
    const float _e80 = unit_share(_e79);
    const float4 _e88 = blend_alpha(_e72, float4(0.2, 0.38, 0.78, 1.0), _e80, 0.55, true);
    const float _e91 = threshold(_e40, 1.792, 0.0);
    const float _e94 = threshold(_e40, 1.808, 0.0);
    const float _e95 = subtract(_e91, _e94);
    const float _e96 = unit_share(_e95);
    const float4 _e104 = blend_alpha(_e88, float4(0.2, 0.38, 0.78, 1.0), _e96, 0.55, true);
    const Angle _e105 = angle_of(_e40);
    const float _e108 = profile(_e105, 0.0, lambert_shape);
    const float _e109 = subtract(_e12, _e108);
    const float _e112 = threshold(_e109, -0.012, 0.0);
    const float _e115 = threshold(_e109, 0.012, 0.0);
    const float _e116 = subtract(_e112, _e115);
    const float _e117 = unit_share(_e116);
    const float4 _e125 = blend_alpha(_e104, float4(0.8, 0.2, 0.17, 1.0), _e117, 1.0, true);
    const Angle _e126 = angle_of(_e40);
    const float _e129 = profile(_e126, 0.0, half_lambert_shape);
    const float _e130 = subtract(_e12, _e129);
    const float _e133 = threshold(_e130, -0.012, 0.0);
    const float _e136 = threshold(_e130, 0.012, 0.0);
    const float _e137 = subtract(_e133, _e136);
    const float _e138 = unit_share(_e137);
    const float4 _e146 = blend_alpha(_e125, float4(0.18, 0.55, 0.27, 1.0), _e138, 1.0, true);
    const Angle _e147 = angle_of(_e40);
    const float _e150 = profile(_e147, 0.0, custom_shape);
    const float _e151 = subtract(_e12, _e150);
    const float _e154 = threshold(_e151, -0.012, 0.0);
    const float _e157 = threshold(_e151, 0.012, 0.0);
    const float _e158 = subtract(_e154, _e157);
    const float _e159 = unit_share(_e158);
    const float4 _e167 = blend_alpha(_e146, float4(0.5, 0.31, 0.14, 1.0), _e159, 1.0, true);
    const float4 _e168 = output(_e167);
    return _e168;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.uv = vertex.uv;
    Varyings _e16 = out_;
    const Varyings varyings = _e16;
    const VertexOutput_vs_main varyings_1 = { varyings.uv, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.uv_3 };
    Surface surface = (Surface)0;

    surface.uv = in_.uv;
    Surface _e4 = surface;
    const float4 _e5 = shade(_e4);
    const float4 _e6 = finite_vec4_(_e5);
    return _e6;
}
