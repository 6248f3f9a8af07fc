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
    float s_3 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s_3) * c), (1.0 - ((2.0 * s_3) * s_3)));
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
    float s_4 = (u_1.half_sin - (u_1.half_cos * 0.0));
    float c_1 = (u_1.half_cos + (u_1.half_sin * 0.0));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_4, c_1));
    float2 turned = (((s_4 <= 0.0) & (s_4 < c_1)) ? float2(0.0, 1.0) : upper);
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

float4 blend_alpha_3_(float4 below_2, float4 color_2, float tone_2, float opacity_2, bool clamped_2)
{
    return clamp(float4((below_2.xyz + (tone_2 * (color_2.xyz - below_2.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), 1.0));
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_1)
{
    float q_1 = (s_1 * shape_1.scale);
    return ((s_1 <= 0.0) ? 1.0 : pow(max((1.0 - (q_1 * q_1)), 0.0), shape_1.exponent));
}

float profile_soft_quick_3_(float s_2, ProfileShape shape_2)
{
    float q_2 = (s_2 * shape_2.scale);
    return ((s_2 <= 0.0) ? 1.0 : pow((1.0 - (q_2 * q_2)), shape_2.exponent));
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_3)
{
    float2 place = float2((u_2.half_sin - (u_2.half_cos * 0.0)), (u_2.half_cos + (u_2.half_sin * 0.0)));
    const float _e15 = profile_soft_quick(place.x, shape_3);
    if ((w_1 < (0.1 * shape_3.edge_deviation))) {
        return _e15;
    }
    float r = (0.19364917 * w_1);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e41 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    const float _e49 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e41) + (8.0 * _e15)) + (5.0 * _e49)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_3, float w_2, ProfileShape shape_4)
{
    float2 place_1 = float2((u_3.half_sin - (u_3.half_cos * 0.0)), (u_3.half_cos + (u_3.half_sin * 0.0)));
    const float _e15 = profile_soft_quick_2_(place_1.x, shape_4);
    if ((w_2 < (0.1 * shape_4.edge_deviation))) {
        return _e15;
    }
    float r_1 = (0.19364917 * w_2);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e41 = profile_soft_quick_3_(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_4);
    const float _e49 = profile_soft_quick_2_(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_4);
    return ((((5.0 * _e41) + (8.0 * _e15)) + (5.0 * _e49)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_4, float w_3, ProfileShape shape_5)
{
    float2 place_2 = float2(((u_4.half_sin * shape_5.half_cos_offset) - (u_4.half_cos * shape_5.half_sin_offset)), ((u_4.half_cos * shape_5.half_cos_offset) + (u_4.half_sin * shape_5.half_sin_offset)));
    const float _e19 = profile_soft_quick_2_(place_2.x, shape_5);
    if ((w_3 < (0.1 * shape_5.edge_deviation))) {
        return _e19;
    }
    float r_2 = (0.19364917 * w_3);
    float2 turn_2 = float2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    const float _e45 = profile_soft_quick_2_(((place_2.x * turn_2.y) - (place_2.y * turn_2.x)), shape_5);
    const float _e53 = profile_soft_quick_2_(((place_2.x * turn_2.y) + (place_2.y * turn_2.x)), shape_5);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_6)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_7)
{
    const Angle _e6 = angle_turned(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_8)
{
    const Angle _e6 = angle_turned(angle_2, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_8);
    return _e8;
}

float threshold(float value, float edge_1, float softness)
{
    const float _e3 = footprint_of(value);
    const float _e6 = step_filtered(value, edge_1, length(float2(_e3, softness)));
    return _e6;
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

float4 shade(Surface surface)
{
    const VectorParts _e4 = separate_vector(float3(surface.uv, 0.0));
    float tone_3 = ((_e4.y - 0.14) / 0.72);
    const float _e12 = threshold(tone_3, -0.006, 0.0);
    const float _e15 = threshold(tone_3, 0.006, 0.0);
    float angles_tone = max((_e12 - _e15), 0.0);
    const float4 _e31 = blend_alpha(float4(0.98, 0.965, 0.925, 1.0), float4(0.24, 0.26, 0.3, 1.0), angles_tone, 1.0, true);
    float angle_5 = lerp(0.0, 3.1415927, ((_e4.x - 0.08) / 0.84));
    const float _e42 = threshold(angle_5, -0.012, 0.0);
    const float _e45 = threshold(angle_5, 0.012, 0.0);
    float tones_tone = max((_e42 - _e45), 0.0);
    float4 tones = max(float4((_e31.xyz + (tones_tone * (float3(0.24, 0.26, 0.3) - _e31.xyz))), 1.0), (0.0).xxxx);
    const float _e65 = threshold(angle_5, 0.492, 0.0);
    const float _e68 = threshold(angle_5, 0.508, 0.0);
    float offset_tone = max((_e65 - _e68), 0.0);
    const float4 _e79 = blend_alpha_2_(tones, float4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55, true);
    const float _e82 = threshold(angle_5, 0.942, 0.0);
    const float _e85 = threshold(angle_5, 0.958, 0.0);
    float falloff_tone = max((_e82 - _e85), 0.0);
    const float4 _e96 = blend_alpha_2_(_e79, float4(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55, true);
    const float _e99 = threshold(angle_5, 1.792, 0.0);
    const float _e102 = threshold(angle_5, 1.808, 0.0);
    float cutoff_tone = max((_e99 - _e102), 0.0);
    const float4 _e113 = blend_alpha_2_(_e96, float4(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55, true);
    const Angle _e114 = angle_of(angle_5);
    const float _e117 = profile_balanced(_e114, 0.0, lambert_shape);
    float lambert_off = (tone_3 - _e117);
    const float _e121 = threshold(lambert_off, -0.012, 0.0);
    const float _e124 = threshold(lambert_off, 0.012, 0.0);
    float lambert_line = (_e121 - _e124);
    float lambert_tone = max(lambert_line, 0.0);
    const float4 _e135 = blend_alpha_3_(_e113, float4(0.8, 0.2, 0.17, 1.0), lambert_tone, 1.0, true);
    const Angle _e136 = angle_of(angle_5);
    const float _e139 = profile_balanced_2_(_e136, 0.0, half_lambert_shape);
    float half_lambert_off = (tone_3 - _e139);
    const float _e143 = threshold(half_lambert_off, 0.012, 0.0);
    const float _e146 = threshold(half_lambert_off, -0.012, 0.0);
    float half_lambert_line = (_e146 - _e143);
    float half_lambert_tone = max(half_lambert_line, 0.0);
    const float4 _e157 = blend_alpha_3_(_e135, float4(0.18, 0.55, 0.27, 1.0), half_lambert_tone, 1.0, true);
    const Angle _e158 = angle_of(angle_5);
    const float _e161 = profile_balanced_3_(_e158, 0.0, custom_shape);
    float custom_off = (tone_3 - _e161);
    const float _e165 = threshold(custom_off, -0.012, 0.0);
    const float _e168 = threshold(custom_off, 0.012, 0.0);
    float custom_line = (_e165 - _e168);
    float custom_tone = max(custom_line, 0.0);
    const float4 _e179 = blend_alpha_3_(_e157, float4(0.5, 0.31, 0.14, 1.0), custom_tone, 1.0, true);
    return _e179;
}

Varyings ConstructVaryings(float4 arg0, float2 arg1) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.uv = arg1;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view.clip_from_world;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), vertex.uv);
    const VertexOutput_vs_main varyings_1 = { varyings.uv, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float2 arg0) {
    Surface ret = (Surface)0;
    ret.uv = arg0;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.uv_1 };
    Surface surface_1 = ConstructSurface(in_.uv);
    const float4 _e3 = shade(surface_1);
    return _e3;
}
