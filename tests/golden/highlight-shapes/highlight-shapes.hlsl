// Highlight shapes: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2.
// highlight-shapes.json says what to put there and how to draw.
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
    Light spark;
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
static const ProfileShape shadow_side_shape = ConstructProfileShape(0.7484994, 0.66313547, 0.0, 1.0, 1.45, 0.0, 0.0, 1u);
static const ProfileShape window_shape = ConstructProfileShape(0.99804753, 0.062459316, 0.0, 1.0, 0.125, 0.0, 0.0, 1u);
static const ProfileShape spark_shape = ConstructProfileShape(0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u);

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
    float clamped_1 = max(x_1, -126.0);
    float whole = round(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_2)
{
    uint bits = asuint(x_2);
    int exponent = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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
    float s_1 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s_1) * c), (1.0 - ((2.0 * s_1) * s_1)));
}

float3 normalize_moderate(float3 v_1, float3 otherwise_1)
{
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * rsqrt(max(square_1, 1e-30))) : otherwise_1);
}

float3 normalize_seen_balanced(float3 v_2)
{
    return (v_2 * rsqrt(max(dot(v_2, v_2), 1e-30)));
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_of(float radians_)
{
    float half_angle = (0.5 * min(radians_, PI));
    const float2 _e5 = sin_cos_quarter(half_angle);
    const Angle angle_2 = ConstructAngle(max(_e5.x, 0.0), max(_e5.y, 0.0));
    return angle_2;
}

float atan2_positive(float y_2, float x_5)
{
    float small = min(y_2, x_5);
    float large = max(y_2, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y_2 > x_5) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_2 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_2, u_1.half_cos));
    float2 turned = (((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_3 = (u_2.half_sin - (u_2.half_cos * 0.0));
    float c_1 = (u_2.half_cos + (u_2.half_sin * 0.0));
    float2 upper_1 = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_3, c_1));
    float2 turned_1 = (((s_3 <= 0.0) & (s_3 < c_1)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_4 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_4;
}

float angle_of_point(float y_3, float x_6)
{
    float2 p = abs(float2(x_6, y_3));
    float2 scaled_1 = ((max(p.x, p.y) > 1.0) ? (0.5 * p) : p);
    const float _e14 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_2 = ((x_6 < 0.0) ? (PI - _e14) : _e14);
    return ((y_3 < 0.0) ? -(turned_2) : turned_2);
}

float footprint_of(float x_7)
{
    float _e1 = ddx(x_7);
    float _e2 = ddy(x_7);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
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
    float3 y_5 = (y_axis * rsqrt(max(dot(y_axis, y_axis), 1e-30)));
    const DirectionParts directionparts = ConstructDirectionParts(direction, x_axis, y_5, float2(dot(direction, x_axis), dot(direction, y_5)));
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

float star_reach(float turn, float rays, float inner, float round_)
{
    float half_sector = (PI / rays);
    float sector = abs(((turn * rays) - floor(((turn * rays) + 0.5))));
    const float2 _e18 = sin_cos_quarter(min(((2.0 * sector) * half_sector), HALF_PI));
    const float2 _e26 = sin_cos_quarter(max(((1.0 - (2.0 * sector)) * half_sector), 0.0));
    const float2 _e27 = sin_cos_quarter(half_sector);
    float corner = _e27.x;
    float straight = ((inner * corner) / max(((inner * _e26.x) + _e18.x), 1e-6));
    return lerp(straight, 1.0, round_);
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

float3 split_direction(float3 direction_2, float3 x_axis_1, float3 y_axis_1, float x_8, float y_4)
{
    const DirectionParts _e5 = direction_within(direction_2, x_axis_1, y_axis_1);
    float2 side = ((_e5.place >= (0.0).xx) ? (1.0).xx : (-1.0).xx);
    const float3 _e18 = direction_moved(_e5, (-(float2(x_8, y_4)) * side));
    return _e18;
}

float3 square_direction(float3 direction_3, float3 x_axis_2, float3 y_axis_2, float amount, float sharpness)
{
    const DirectionParts _e5 = direction_within(direction_3, x_axis_2, y_axis_2);
    float square_3 = dot(_e5.place, _e5.place);
    float apart = (abs(_e5.place.x) - abs(_e5.place.y));
    float aside_1 = min(((apart * apart) / max(square_3, 1e-20)), 1.0);
    const float _e24 = log1p_negative(aside_1);
    const float _e26 = exp2_stable(((sharpness * LOG2_E) * _e24));
    float corner_1 = (((square_3 > 1e-20) & (aside_1 < 1.0)) ? _e26 : 0.0);
    const float3 _e38 = direction_moved(_e5, ((-(amount) * corner_1) * _e5.place));
    return _e38;
}

Angle star_angle(float3 direction_4, float3 middle, float3 x_axis_3, float3 y_axis_3, int rays_1, float inner_1, float round_1, float turn_1)
{
    const DirectionParts _e8 = direction_within(direction_4, x_axis_3, y_axis_3);
    Angle u_3 = ConstructAngle((0.5 * length((_e8.direction - middle))), (0.5 * length((_e8.direction + middle))));
    const float _e24 = angle_of_point(_e8.place.y, _e8.place.x);
    float around = ((_e24 - turn_1) / 6.2831855);
    const float _e29 = star_reach(around, 4.0, inner_1, round_1);
    const float _e32 = atan2_positive(u_3.half_sin, u_3.half_cos);
    const Angle _e36 = angle_of(((2.0 * _e32) / _e29));
    const Angle angle_5 = _e36;
    return angle_5;
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (color.xyz - below.xyz))) - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float profile_ramp_quick(float s, float w, ProfileShape shape)
{
    float width_1 = sqrt((w * w));
    float from_offset = (s * (2.0 + ((s * s) * 0.33333334)));
    float ramp = clamp((0.5 + ((0.0 - from_offset) / max(width_1, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_1)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick(((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset)), _e14, shape_1);
    return _e15;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_2)
{
    const Angle _e6 = angle_turned_2_(angle_1, float2(0.0, 1.0));
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick(((_e6.half_sin * shape_2.half_cos_offset) - (_e6.half_cos * shape_2.half_sin_offset)), _e14, shape_2);
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

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle turned_from_the_key = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile_balanced(turned_from_the_key, 0.0, shadow_side_shape);
    float in_the_dark = (1.0 - _e22);
    float4 shadow = min(float4((float3(0.83, 0.19, 0.18) * lerp((1.0).xxx, float3(0.52, 0.25, 0.46), in_the_dark)), 1.0), (1.0).xxxx);
    Light _e44 = look.key;
    const float3 _e46 = half_vector(_e44, surface.view);
    const AxesAround _e51 = axes(_e46, float3(0.0, 1.0, 0.0));
    const float3 _e57 = split_direction(surface.normal, _e51.x_axis, _e51.y_axis, 0.15, 0.15);
    const float3 _e62 = square_direction(_e57, _e51.x_axis, _e51.y_axis, 0.3, 4.0);
    Angle window_angle = ConstructAngle((0.5 * length((_e62 - _e46))), (0.5 * length((_e62 + _e46))));
    const float _e74 = profile_balanced_2_(window_angle, 0.0, window_shape);
    const float4 _e82 = blend_alpha(shadow, float4(1.0, 0.97, 0.9, 1.0), _e74, 0.95, true);
    Light _e85 = look.spark;
    const float3 _e87 = half_vector(_e85, surface.view);
    const AxesAround _e92 = axes(_e87, float3(0.0, 1.0, 0.0));
    const Angle _e100 = star_angle(surface.normal, _e87, _e92.x_axis, _e92.y_axis, int(4), 0.28, 0.0, 0.3);
    const float _e103 = profile_balanced_2_(_e100, 0.0, spark_shape);
    float4 spark_s_light = clamp(float4((_e82.xyz + (_e103 * (float3(1.0, 0.83, 0.42) - _e82.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    Light _e122 = look.back;
    const float _e128 = rim(_e122, surface.normal, surface.view, 0.38, 0.15, 1.0);
    float4 rim_s_light = clamp(float4((spark_s_light.xyz + (0.75 * ((spark_s_light.xyz + (_e128 * float3(0.55, 0.72, 1.0))) - spark_s_light.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return rim_s_light;
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
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    return _e19;
}
