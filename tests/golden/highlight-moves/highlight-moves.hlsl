// A highlight, moved: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2.
// highlight-moves.json says what to put there and how to draw.
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
    float turn_angle;
    float move_x;
    float move_y;
    float stretch_x;
    float stretch_y;
    float split_x;
    float split_y;
    float square_amount;
    float4 body;
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

static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const ProfileShape lit_side_shape = ConstructProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u);
static const ProfileShape highlight_shape = ConstructProfileShape(0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0, 1u);

cbuffer view_2 : register(b0) { View view_2; }
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

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float4 finite_vec4_(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return (((asuint(v) & exponent) != exponent) ? v : (0.0).xxxx);
}

float3 normalize_or(float3 v_1, float3 otherwise)
{
    float largest = max(max(abs(v_1.x), abs(v_1.y)), abs(v_1.z));
    if (!(((largest > 1e-30) & (largest < 1e30)))) {
        return otherwise;
    }
    float3 scaled = (v_1 * (1.0 / largest));
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
    float clamped_1 = max(x_1, -126.0);
    float whole = round(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_2)
{
    uint bits = asuint(x_2);
    int exponent_1 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log_stable(float x_3)
{
    const float _e2 = log2_stable(x_3);
    return (LN_2_ * _e2);
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float log1p_negative(float y_1)
{
    if ((y_1 < 0.25)) {
        const float _e3 = log1p_negative_small(y_1);
        return _e3;
    }
    const float _e8 = log_stable(max((1.0 - y_1), 1.1754944e-38));
    return _e8;
}

float2 sin_cos_quarter(float x_4)
{
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s_3 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s_3) * c), (1.0 - ((2.0 * s_3) * s_3)));
}

float2 sin_cos(float x_5)
{
    float turns = round((x_5 * 0.31830987));
    float r = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    const float2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

float3 normalize_moderate(float3 v_2, float3 otherwise_1)
{
    float square_1 = dot(v_2, v_2);
    return ((square_1 > 1e-30) ? (v_2 * rsqrt(max(square_1, 1e-30))) : otherwise_1);
}

float3 normalize_seen_balanced(float3 v_3)
{
    return (v_3 * rsqrt(max(dot(v_3, v_3), 1e-30)));
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_3, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_4 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_4, u_1.half_cos));
    float2 turned = (((s_4 <= 0.0) & (s_4 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_5 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_1 = (u_2.half_cos + (u_2.half_sin * 0.0));
    float2 upper_1 = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_5, c_1));
    float2 turned_1 = (((s_5 <= 0.0) & (s_5 < c_1)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_4 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_4;
}

float3 bounded_vec3_(float3 v_4)
{
    uint3 bits_1 = asuint(v_4);
    uint3 magnitude = (bits_1 & (2147483647u).xxx);
    float3 largest_1 = asfloat(((bits_1 & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers = ((magnitude == (2139095040u).xxx) ? largest_1 : (0.0).xxx);
    return ((magnitude < (2139095040u).xxx) ? v_4 : numbers);
}

float footprint_of(float x_6)
{
    float _e1 = ddx(x_6);
    float _e2 = ddy(x_6);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float3 any_orthogonal(float3 n)
{
    float sign_1 = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_1 + n.z));
    return float3((1.0 + (((sign_1 * n.x) * n.x) * a)), (((sign_1 * n.x) * n.y) * a), (-(sign_1) * n.x));
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
    float3 y_4 = (y_axis * rsqrt(max(dot(y_axis, y_axis), 1e-30)));
    const DirectionParts directionparts = ConstructDirectionParts(direction, x_axis, y_4, float2(dot(direction, x_axis), dot(direction, y_4)));
    return directionparts;
}

float3 direction_moved(DirectionParts parts, float2 by)
{
    float2 step_ = clamp(by, (-1000000.0).xx, (1000000.0).xx);
    float3 moved = ((parts.direction + (step_.x * parts.x_axis)) + (step_.y * parts.y_axis));
    const float3 _e18 = normalize_moderate(moved, parts.direction);
    return ((dot(moved, moved) > 1e-6) ? _e18 : parts.direction);
}

float3 direction_moved_2_(DirectionParts parts_1, float2 by_1)
{
    float3 moved_1 = ((parts_1.direction + (by_1.x * parts_1.x_axis)) + (by_1.y * parts_1.y_axis));
    const float3 _e13 = normalize_moderate(moved_1, parts_1.direction);
    return ((dot(moved_1, moved_1) > 1e-6) ? _e13 : parts_1.direction);
}

float3x3 axes_around(float3 toward, float3 up)
{
    const float3 _e6 = normalize_moderate(up, float3(0.0, 1.0, 0.0));
    float3 leaning = cross(_e6, toward);
    float square_2 = dot(leaning, leaning);
    float3 aside = ((abs(toward.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across = ((square_2 > 1e-8) ? leaning : cross(aside, toward));
    const float3 _e33 = normalize_moderate((across - (dot(across, toward) * toward)), float3(1.0, 0.0, 0.0));
    return float3x3(_e33, cross(toward, _e33), toward);
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

float3 split_direction(float3 direction_2, float3 x_axis_1, float3 y_axis_1, float x_7, float y_2)
{
    const DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    float2 side = ((_e5.place >= (0.0).xx) ? (1.0).xx : (-1.0).xx);
    const float3 _e21 = direction_moved(_e5, (-(max(float2(x_7, y_2), (0.0).xx)) * side));
    return _e21;
}

float3 square_direction(float3 direction_3, float3 x_axis_2, float3 y_axis_2, float amount, float sharpness)
{
    const DirectionParts _e5 = direction_within(direction_3, x_axis_2, y_axis_2);
    float square_3 = dot(_e5.place, _e5.place);
    float apart = (abs(_e5.place.x) - abs(_e5.place.y));
    float aside_1 = min(((apart * apart) / max(square_3, 1e-20)), 1.0);
    const float _e24 = log1p_negative(aside_1);
    const float _e26 = exp2_stable(((sharpness * LOG2_E) * _e24));
    float corner = (((square_3 > 1e-20) & (aside_1 < 1.0)) ? _e26 : 0.0);
    const float3 _e41 = direction_moved_2_(_e5, ((-(clamp(amount, 0.0, 1.0)) * corner) * _e5.place));
    return _e41;
}

float3 stretch_direction(float3 direction_4, float3 x_axis_3, float3 y_axis_3, float x_8, float y_3)
{
    const DirectionParts _e5 = direction_within(direction_4, x_axis_3, y_axis_3);
    const float3 _e13 = direction_moved(_e5, (-(min(float2(x_8, y_3), (1.0).xx)) * _e5.place));
    return _e13;
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    float alpha = (below.w + ((tone * opacity) * (1.0 - below.w)));
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), alpha), (0.0).xxxx, (1.0).xxxx);
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1)
{
    float width_1 = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width_1)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_ramp_quick_2_(float s_2, float w_1, ProfileShape shape_2)
{
    float width_2 = sqrt((w_1 * w_1));
    float from_offset_1 = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp_1 = clamp((0.5 + ((0.0 - from_offset_1) / max(width_2, 1e-6))), 0.0, 1.0);
    return ((w_1 <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp_1);
}

float profile_filtered_quick(Angle u_3, float w_2, ProfileShape shape_3)
{
    float2 place = float2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    bool is_narrow = ((w_2 > 0.0) & (w_2 >= (3.4641016 * shape_3.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place.x, w_2, shape_3);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place.x, shape_3);
    if ((w_2 < (0.1 * shape_3.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_2);
    float2 turn = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    const float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_4)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_4);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_5)
{
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick_2_(((_e6.half_sin * shape_5.half_cos_offset) - (_e6.half_cos * shape_5.half_sin_offset)), _e14, shape_5);
    return _e15;
}

float rim(Light light_1, float3 normal, float3 view_1, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view_1), 0.0, 1.0);
    const float _e11 = footprint_of(facing);
    float edge = max((width * softness), min(_e11, 1.0));
    float3 aside_2 = (normal - view_1);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside_2, aside_2)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    float3 across_1 = (light_1.direction - (dot(light_1.direction, view_1) * view_1));
    float side_1 = dot((normal - (dot(normal, view_1) * view_1)), (across_1 * rsqrt(max(dot(across_1, across_1), 1e-30))));
    return (inside * lerp(1.0, smoothstep(0.0, 0.5, side_1), follow));
}

float3 rotate_vector(float3 vector_, float3 axis, float angle_2)
{
    const float2 _e5 = sin_cos((0.5 * angle_2));
    float2 half_2 = clamp(_e5, (-1.0).xx, (1.0).xx);
    float3 aside_3 = cross(axis, vector_);
    const float3 _e23 = bounded_vec3_((vector_ + ((2.0 * half_2.x) * ((half_2.y * aside_3) + (half_2.x * cross(axis, aside_3))))));
    return _e23;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle turned_from_the_key = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = (1.0 - _e22);
    float4 _e27 = look.body;
    float4 _e31 = look.body;
    float4 _e43 = look.body;
    float _e50 = look.body.w;
    float4 shadow = clamp(float4((_e27.xyz + ((_e31.xyz * lerp((1.0).xxx, float3(0.45, 0.36, 0.62), in_the_dark)) - _e43.xyz)), _e50), (0.0).xxxx, (1.0).xxxx);
    float3 normal_3 = surface.normal;
    Light _e60 = look.key;
    const float3 _e62 = half_vector(_e60, surface.view);
    float _e69 = look.turn_angle;
    const float3 _e70 = rotate_vector(float3(0.0, 1.0, 0.0), _e62, _e69);
    const AxesAround _e71 = axes(_e62, _e70);
    const DirectionParts _e74 = direction_within(normal_3, _e71.x_axis, _e71.y_axis);
    float _e77 = look.move_x;
    float _e80 = look.move_y;
    const float3 _e82 = direction_moved(_e74, float2(_e77, _e80));
    float _e87 = look.stretch_x;
    float _e90 = look.stretch_y;
    const float3 _e91 = stretch_direction(_e82, _e71.x_axis, _e71.y_axis, _e87, _e90);
    float _e96 = look.split_x;
    float _e99 = look.split_y;
    const float3 _e100 = split_direction(_e91, _e71.x_axis, _e71.y_axis, _e96, _e99);
    float _e105 = look.square_amount;
    const float3 _e107 = square_direction(_e100, _e71.x_axis, _e71.y_axis, _e105, 4.0);
    Angle from_the_highlight = ConstructAngle((0.5 * length((_e107 - _e62))), (0.5 * length((_e107 + _e62))));
    const float _e119 = profile_balanced_2_(from_the_highlight, 0.0, highlight_shape);
    const float4 _e127 = blend_alpha(shadow, float4(1.0, 0.98, 0.92, 1.0), _e119, 0.96, true);
    Light _e130 = look.back;
    const float _e136 = rim(_e130, surface.normal, surface.view, 0.3, 0.2, 1.0);
    float4 rim_s_light = clamp(float4((_e127.xyz + (0.5 * ((_e127.xyz + (_e136 * float3(0.55, 0.75, 1.0))) - _e127.xyz))), _e127.w), (0.0).xxxx, (1.0).xxxx);
    const float4 _e167 = finite_vec4_(((rim_s_light.w <= 0.0) ? rim_s_light : float4((rim_s_light.xyz / (rim_s_light.w).xxx), rim_s_light.w)));
    return _e167;
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
    float4x4 _e10 = view_2.clip_from_world;
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
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    const float4 _e20 = finite_vec4_(_e19);
    return _e20;
}
