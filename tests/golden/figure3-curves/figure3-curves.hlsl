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
static const float LOG2_E = 1.442695;
static const ProfileShape lambert_shape = ConstructProfileShape(1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u);
static const ProfileShape half_lambert_shape = ConstructProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);
static const ProfileShape custom_shape = ConstructProfileShape(0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928, 0.2351043, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }

struct VertexOutput_vs_main {
    float2 uv : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float2 uv_1 : LOC0;
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

float2 sin_cos_quarter(float x_2)
{
    float h = (0.5 * x_2);
    float h2_ = (h * h);
    float s_4 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s_4) * c), (1.0 - ((2.0 * s_4) * s_4)));
}

float log2_one_minus(float y)
{
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float log2_one_minus_2_(float y_1)
{
    float series_1 = ((-(y_1) * LOG2_E) * (1.0 + (y_1 * (0.5 + (y_1 * (0.33333334 + (y_1 * (0.25 + (y_1 * 0.2)))))))));
    return ((y_1 < 0.0625) ? series_1 : log2((1.0 - y_1)));
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
    const Angle angle_3 = ConstructAngle(max(_e8.x, 0.0), max(_e8.y, 0.0));
    return angle_3;
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_4 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_4, 0.5);
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_5 = (u_1.half_sin - (u_1.half_cos * 0.0));
    float c_1 = (u_1.half_cos + (u_1.half_sin * 0.0));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_5, c_1));
    float2 turned = (((s_5 <= 0.0) & (s_5 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_4 = ConstructAngle(turned.x, turned.y);
    return angle_4;
}

float footprint_of(float x_3)
{
    float _e1 = ddx(x_3);
    float _e2 = ddy(x_3);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float step_filtered(float x_4, float edge, float w)
{
    float d_1 = (x_4 - edge);
    return ((w < 1e-30) ? ((d_1 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_1 / w)), 0.0, 1.0));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

float4 blend_alpha_2_(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return clamp(float4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    const float _e7 = log2_one_minus(min((q * q), 1.0));
    return ((s <= 0.0) ? 1.0 : ((q >= 1.0) ? 0.0 : min(exp2(_e7), 1.0)));
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_1)
{
    float q_1 = (s_1 * shape_1.scale);
    const float _e8 = log2_one_minus(min((q_1 * q_1), 1.0));
    return ((s_1 <= 0.0) ? 1.0 : ((q_1 >= 1.0) ? 0.0 : min(exp2((shape_1.exponent * _e8)), 1.0)));
}

float profile_soft_quick_3_(float s_2, ProfileShape shape_2)
{
    float q_2 = (s_2 * shape_2.scale);
    const float _e6 = log2_one_minus_2_((q_2 * q_2));
    return ((s_2 <= 0.0) ? 1.0 : min(exp2((shape_2.exponent * _e6)), 1.0));
}

float profile_soft_quick_4_(float s_3, ProfileShape shape_3)
{
    float q_3 = (s_3 * shape_3.scale);
    const float _e8 = log2_one_minus(min((q_3 * q_3), 1.0));
    return ((s_3 <= 0.0) ? 1.0 : ((q_3 >= 1.0) ? 0.0 : min(exp2(max((shape_3.exponent * _e8), -126.0)), 1.0)));
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_4)
{
    float2 place = float2((u_2.half_sin - (u_2.half_cos * 0.0)), (u_2.half_cos + (u_2.half_sin * 0.0)));
    const float _e15 = profile_soft_quick(place.x, shape_4);
    if ((w_1 < (0.1 * shape_4.edge_deviation))) {
        return _e15;
    }
    float r = (0.19364917 * w_1);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e41 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_4);
    const float _e49 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_4);
    return ((((5.0 * _e41) + (8.0 * _e15)) + (5.0 * _e49)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_2, ProfileShape shape_5)
{
    float2 place_1 = float2((u_3.half_sin - (u_3.half_cos * 0.0)), (u_3.half_cos + (u_3.half_sin * 0.0)));
    const float _e15 = profile_soft_quick_2_(place_1.x, shape_5);
    if ((w_2 < (0.1 * shape_5.edge_deviation))) {
        return _e15;
    }
    float r_1 = (0.19364917 * w_2);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e41 = profile_soft_quick_3_(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_5);
    const float _e49 = profile_soft_quick_2_(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_5);
    return ((((5.0 * _e41) + (8.0 * _e15)) + (5.0 * _e49)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_4, float w_3, ProfileShape shape_6)
{
    float2 place_2 = float2(((u_4.half_sin * shape_6.half_cos_offset) - (u_4.half_cos * shape_6.half_sin_offset)), ((u_4.half_cos * shape_6.half_cos_offset) + (u_4.half_sin * shape_6.half_sin_offset)));
    const float _e19 = profile_soft_quick_4_(place_2.x, shape_6);
    if ((w_3 < (0.1 * shape_6.edge_deviation))) {
        return _e19;
    }
    float r_2 = (0.19364917 * w_3);
    float2 turn_2 = float2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    const float _e45 = profile_soft_quick_4_(((place_2.x * turn_2.y) - (place_2.y * turn_2.x)), shape_6);
    const float _e53 = profile_soft_quick_4_(((place_2.x * turn_2.y) + (place_2.y * turn_2.x)), shape_6);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_7)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_8)
{
    const Angle _e6 = angle_turned(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_8);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_9)
{
    const Angle _e6 = angle_turned(angle_2, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_9);
    return _e8;
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
    const VectorParts vectorparts = ConstructVectorParts(vector_.x, vector_.y, 0.0);
    return vectorparts;
}

float4 shade(Surface surface_1)
{
    float2 uv_2 = surface_1.uv;
    const VectorParts _e4 = separate_vector(float3(uv_2, 0.0));
    float tone_2 = ((_e4.y - 0.14) / 0.72);
    const float _e11 = footprint_of(tone_2);
    const float _e15 = step_filtered(tone_2, -0.006, length(float2(_e11, 0.0)));
    const float _e17 = footprint_of(tone_2);
    const float _e21 = step_filtered(tone_2, 0.006, length(float2(_e17, 0.0)));
    float angles_line = (_e15 - _e21);
    float angles_tone = max(angles_line, 0.0);
    const float4 _e37 = blend_alpha(float4(0.98, 0.965, 0.925, 1.0), float4(0.24, 0.26, 0.3, 1.0), angles_tone, 1.0, true);
    float angle_5 = lerp(0.0, 3.1415927, ((_e4.x - 0.08) / 0.84));
    const float _e47 = footprint_of(angle_5);
    const float _e51 = step_filtered(angle_5, -0.012, length(float2(_e47, 0.0)));
    const float _e53 = footprint_of(angle_5);
    const float _e57 = step_filtered(angle_5, 0.012, length(float2(_e53, 0.0)));
    float tones_line = (_e51 - _e57);
    float tones_tone = max(tones_line, 0.0);
    float4 tones = max(float4((_e37.xyz + (tones_tone * (float3(0.24, 0.26, 0.3) - _e37.xyz))), 1.0), (0.0).xxxx);
    const float _e76 = footprint_of(angle_5);
    const float _e80 = step_filtered(angle_5, 0.492, length(float2(_e76, 0.0)));
    const float _e82 = footprint_of(angle_5);
    const float _e86 = step_filtered(angle_5, 0.508, length(float2(_e82, 0.0)));
    float offset_line = (_e80 - _e86);
    float offset_tone = max(offset_line, 0.0);
    const float4 _e97 = blend_alpha_2_(tones, float4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55, true);
    const float _e99 = footprint_of(angle_5);
    const float _e103 = step_filtered(angle_5, 0.942, length(float2(_e99, 0.0)));
    const float _e105 = footprint_of(angle_5);
    const float _e109 = step_filtered(angle_5, 0.958, length(float2(_e105, 0.0)));
    float falloff_line = (_e103 - _e109);
    float falloff_tone = max(falloff_line, 0.0);
    const float4 _e120 = blend_alpha_2_(_e97, float4(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55, true);
    const float _e122 = footprint_of(angle_5);
    const float _e126 = step_filtered(angle_5, 1.792, length(float2(_e122, 0.0)));
    const float _e128 = footprint_of(angle_5);
    const float _e132 = step_filtered(angle_5, 1.808, length(float2(_e128, 0.0)));
    float cutoff_line = (_e126 - _e132);
    float cutoff_tone = max(cutoff_line, 0.0);
    const float4 _e143 = blend_alpha_2_(_e120, float4(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55, true);
    const Angle _e144 = angle_of(angle_5);
    const float _e147 = profile_balanced(_e144, 0.0, lambert_shape);
    float lambert_off = (tone_2 - _e147);
    const float _e150 = footprint_of(lambert_off);
    const float _e154 = step_filtered(lambert_off, -0.012, length(float2(_e150, 0.0)));
    const float _e156 = footprint_of(lambert_off);
    const float _e160 = step_filtered(lambert_off, 0.012, length(float2(_e156, 0.0)));
    float lambert_line = (_e154 - _e160);
    float lambert_tone = max(lambert_line, 0.0);
    float4 lambert_2_ = clamp(float4((_e143.xyz + (lambert_tone * (float3(0.8, 0.2, 0.17) - _e143.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    const Angle _e180 = angle_of(angle_5);
    const float _e183 = profile_balanced_2_(_e180, 0.0, half_lambert_shape);
    float half_lambert_off = (tone_2 - _e183);
    const float _e186 = footprint_of(half_lambert_off);
    const float _e190 = step_filtered(half_lambert_off, -0.012, length(float2(_e186, 0.0)));
    const float _e192 = footprint_of(half_lambert_off);
    const float _e196 = step_filtered(half_lambert_off, 0.012, length(float2(_e192, 0.0)));
    float half_lambert_line = (_e190 - _e196);
    float half_lambert_tone = max(half_lambert_line, 0.0);
    float4 half_lambert_2_ = clamp(float4((lambert_2_.xyz + (half_lambert_tone * (float3(0.18, 0.55, 0.27) - lambert_2_.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    const Angle _e216 = angle_of(angle_5);
    const float _e219 = profile_balanced_3_(_e216, 0.0, custom_shape);
    float custom_off = (tone_2 - _e219);
    const float _e222 = footprint_of(custom_off);
    const float _e226 = step_filtered(custom_off, -0.012, length(float2(_e222, 0.0)));
    const float _e228 = footprint_of(custom_off);
    const float _e232 = step_filtered(custom_off, 0.012, length(float2(_e228, 0.0)));
    float custom_line = (_e226 - _e232);
    float custom_tone = max(custom_line, 0.0);
    float4 output = clamp(float4((half_lambert_2_.xyz + (custom_tone * (float3(0.5, 0.31, 0.14) - half_lambert_2_.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return output;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.uv_1 };
    Surface surface = (Surface)0;

    surface.uv = in_.uv;
    Surface _e4 = surface;
    const float4 _e5 = shade(_e4);
    return _e5;
}
