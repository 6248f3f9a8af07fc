// A filter after the profile: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// filter-after.json says what to put there and how to draw.
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

struct Look {
    float3 lamp_position;
    int _pad1_0;
    float3 lamp_aim;
    int _pad2_0;
    row_major float3x3 lamp_own_from_world;
    int _pad3_0;
    float3 lamp_color;
    float lamp_intensity;
    float2 lamp_cone;
    float2 lamp_fading;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 position;
    int _end_pad_0;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct Light {
    float3 direction;
    int _pad1_0;
    float3 own_direction;
    int _pad2_0;
    float3 color;
    float intensity;
};

struct LitLayer {
    float4 color;
    float tone;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct FilteredLight {
    Light light;
    Angle angle;
    int _end_pad_0;
    int _end_pad_1;
};

struct PlaceInLight {
    float2 uv;
    float inside;
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
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const float FAR_FROM_SHAPE = 1000.0;
static const float CELL_REACH = 1.25;
static const ProfileShape tone_shape = ConstructProfileShape(0.87758255, 0.47942555, 20.008335, 2.4978132, 1.0, 0.04909103, 0.021148764, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_4 : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_5 : LOC0;
    float3 normal_1 : LOC1;
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

float2 sin_cos_eighth(float x_1)
{
    float y_2 = (x_1 * x_1);
    float s_2 = (x_1 * (1.0 + (y_2 * (-0.16666667 + (y_2 * (0.008333334 + (y_2 * (-0.0001984127 + (y_2 * 2.7557319e-6)))))))));
    float c = (1.0 - (y_2 * (0.5 + (y_2 * (-0.041666668 + (y_2 * (0.0013888889 + (y_2 * (-2.4801588e-5 + (y_2 * 2.755732e-7))))))))));
    return float2(s_2, c);
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

float atan2_positive(float y, float x_2)
{
    float small = min(y, x_2);
    float large = max(y, x_2);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y > x_2) ? (HALF_PI - a) : a);
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_3 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_3, u_1.half_cos));
    float2 turned = (((s_3 <= 0.0) & (s_3 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

float bounded(float x_3)
{
    uint bits = asuint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    uint3 bits_1 = asuint(v_3);
    uint3 magnitude_1 = (bits_1 & (2147483647u).xxx);
    float3 largest_2 = asfloat(((bits_1 & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers = ((magnitude_1 == (2139095040u).xxx) ? largest_2 : (0.0).xxx);
    return ((magnitude_1 < (2139095040u).xxx) ? v_3 : numbers);
}

float place_between(float x_4, float low, float high)
{
    float span = (high - low);
    if ((span < SMALLEST_NORMAL)) {
        return ((x_4 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(((x_4 - low) / span));
    return _e12;
}

float eased(float x_5, float low_1, float high_1)
{
    const float _e3 = bounded(x_5);
    const float _e4 = place_between(_e3, low_1, high_1);
    float t_2 = clamp(_e4, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float angle_of_point(float y_1, float x_6)
{
    float2 p_1 = abs(float2(x_6, y_1));
    float2 scaled_1 = ((max(p_1.x, p_1.y) > 1.0) ? (0.5 * p_1) : p_1);
    const float _e14 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_1 = ((x_6 < 0.0) ? (PI - _e14) : _e14);
    return ((y_1 < 0.0) ? -(turned_1) : turned_1);
}

float footprint_of(float x_7)
{
    float _e1 = ddx(x_7);
    float _e2 = ddy(x_7);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float2 footprint_of_vec2_(float2 v_4)
{
    float2 dx_1 = ddx(v_4);
    float2 dy_1 = ddy(v_4);
    return sqrt(((dx_1 * dx_1) + (dy_1 * dy_1)));
}

float footprint_of_vec3_(float3 v_5)
{
    float3 dx_2 = ddx(v_5);
    float3 dy_2 = ddy(v_5);
    return sqrt(max(dot(dx_2, dx_2), dot(dy_2, dy_2)));
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

float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + ((below.xyz + (tone * color.xyz)) - below.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float3x3 axes_turned(float3 toward_1, float spin)
{
    const float3x3 _e6 = axes_around(toward_1, float3(0.0, 1.0, 0.0));
    float2 turn = float2(0.0, 1.0);
    return float3x3(((turn.y * _e6[0]) + (turn.x * _e6[1])), ((turn.y * _e6[1]) - (turn.x * _e6[0])), _e6[2]);
}

float3x3 axes_turned_2_(float3 toward_2, float spin_1)
{
    const float3x3 _e6 = axes_around(toward_2, float3(0.0, 1.0, 0.0));
    const float2 _e13 = sin_cos_eighth((((spin_1 - 0.0) - 0.0) - 0.0));
    float2 turn_1 = clamp(_e13, (-1.0).xx, (1.0).xx);
    return float3x3(((turn_1.y * _e6[0]) + (turn_1.x * _e6[1])), ((turn_1.y * _e6[1]) - (turn_1.x * _e6[0])), _e6[2]);
}

float3 place_along(float3 place, float3 center_, float3x3 axes)
{
    float3 away = clamp((place - center_), (-1000000.0).xxx, (1000000.0).xxx);
    return float3(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

float share_beside(float m, float softness, float density, bool inverted)
{
    float near = min(m, FAR_FROM_SHAPE);
    const float _e6 = footprint_of(near);
    float half_1 = (0.5 * min(_e6, 0.25));
    const float _e15 = eased(near, (1.0 - half_1), (1.0 + half_1));
    return (1.0 - _e15);
}

float share_of_doors(float3 seen, float4 flaps, float softness_1)
{
    const float _e5 = angle_of_point(seen.x, seen.z);
    const float _e8 = angle_of_point(seen.y, seen.z);
    float2 angles = float2(_e5, _e8);
    const float2 _e10 = footprint_of_vec2_(angles);
    float2 half_2 = (0.5 * min(_e10, (0.1).xx));
    float aside_1 = ((1.0 - smoothstep((flaps.x - half_2.x), (flaps.x + max(softness_1, half_2.x)), angles.x)) * (1.0 - smoothstep((flaps.y - half_2.x), (flaps.y + max(softness_1, half_2.x)), -(angles.x))));
    return ((aside_1 * (1.0 - smoothstep((flaps.z - half_2.y), (flaps.z + max(softness_1, half_2.y)), angles.y))) * (1.0 - smoothstep((flaps.w - half_2.y), (flaps.w + max(softness_1, half_2.y)), -(angles.y))));
}

float light_fading(float distance_, float2 fading)
{
    float left = 1.0;

    if ((fading.x > 0.0)) {
        float d_1 = min((distance_ / fading.x), 1000000000000000.0);
        left = (1.0 / (1.0 + (d_1 * d_1)));
    }
    if ((fading.y > 0.0)) {
        float d_2 = min((distance_ / fading.y), 1.0);
        float window = max((1.0 - (((d_2 * d_2) * d_2) * d_2)), 0.0);
        float _e30 = left;
        left = (_e30 * (window * window));
    }
    float _e33 = left;
    return _e33;
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light light_at(float3 light_position, float3x3 own_from_world, float3 color_1, float intensity, float2 fading_1, float3 position)
{
    float3 offset = (light_position - position);
    const float3 _e11 = normalize_or(offset, float3(0.0, 0.0, 1.0));
    const float _e13 = light_fading(length(offset), fading_1);
    float faded = (intensity * _e13);
    const Light light_2 = ConstructLight(_e11, mul(_e11, own_from_world), color_1, faded);
    return light_2;
}

float light_cone(float cos_angle, float2 cone)
{
    if ((cone.x <= cone.y)) {
        return ((cos_angle >= cone.y) ? 1.0 : 0.0);
    }
    float t_3 = clamp(((cos_angle - cone.y) / (cone.x - cone.y)), 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

Light light_spot(float3 light_position_1, float3 aim, float3x3 own_from_world_1, float3 color_2, float intensity_1, float2 cone_1, float2 fading_2, float3 position_1)
{
    Light light = (Light)0;

    const Light _e8 = light_at(light_position_1, own_from_world_1, color_2, intensity_1, fading_2, position_1);
    light = _e8;
    float _e11 = light.intensity;
    float3 _e13 = light.direction;
    const float _e16 = light_cone(dot(-(_e13), aim), cone_1);
    light.intensity = (_e11 * _e16);
    Light _e18 = light;
    const Light light_3 = _e18;
    return light_3;
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light_1, float4 color_3, float tone_1)
{
    float2 split = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_3.xyz * light_1.color) * split.y), 1.0), (tone_1 * split.x));
    return litlayer;
}

PlaceInLight ConstructPlaceInLight(float2 arg0, float arg1) {
    PlaceInLight ret = (PlaceInLight)0;
    ret.uv = arg0;
    ret.inside = arg1;
    return ret;
}

PlaceInLight place_in_light(float2 at)
{
    float2 near_1 = clamp(at, (-1000.0).xx, (1000.0).xx);
    const float _e14 = share_beside(max(abs(near_1.x), abs(near_1.y)), 0.0, 1.0, true);
    const PlaceInLight placeinlight = ConstructPlaceInLight(((0.5).xx + (0.5 * float2(-(near_1.x), near_1.y))), _e14);
    return placeinlight;
}

PlaceInLight light_place_point(float3 light_position_2, float angle, float spin_2, float3 toward_3, float3 position_2)
{
    const float3x3 _e5 = axes_turned_2_(toward_3, spin_2);
    const float3 _e6 = place_along(position_2, light_position_2, _e5);
    const float2 _e13 = sin_cos_eighth((((angle - 0.0) - 0.0) - 0.0));
    float2 turn_2 = clamp(_e13, (-1.0).xx, (1.0).xx);
    float2 at_1 = ((_e6.xy * (turn_2.y / turn_2.x)) / (max(_e6.z, 0.001)).xx);
    const PlaceInLight _e35 = place_in_light(((_e6.z > 0.001) ? at_1 : (1000.0).xx));
    const PlaceInLight placeinlight_1 = _e35;
    return placeinlight_1;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1)
{
    float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_2)
{
    float2 place_1 = float2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    bool is_narrow = ((w_1 > 0.0) & (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place_1.x, w_1, shape_2);
        return _e28;
    }
    const float _e30 = profile_soft_quick(place_1.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r_1 = (0.19364917 * w_1);
    float2 turn_3 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e56 = profile_soft_quick(((place_1.x * turn_3.y) - (place_1.y * turn_3.x)), shape_2);
    const float _e64 = profile_soft_quick(((place_1.x * turn_3.y) + (place_1.y * turn_3.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle_1, float shift, ProfileShape shape_3)
{
    const Angle _e6 = angle_turned(angle_1, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_6 = (uint3)0;

    v_6 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_6;
    uint3 _e32 = v_6;
    v_6 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_6;
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

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

Cell ConstructCell(float arg0, float arg1, float arg2) {
    Cell ret = (Cell)0;
    ret.border = arg0;
    ret.random = arg1;
    ret.distance_ = arg2;
    return ret;
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

Cell nearest_cell(float3 p, uint seed_2)
{
    float3 nearest = (4.0).xxx;
    uint3 hash_1 = (0u).xxx;
    int i = int(0);
    float border = (float)0;
    int i_1 = int(0);

    float3 corner = floor(p);
    float3 d_3 = (p - corner);
    int3 cell_1 = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e51 = i;
            i = asint(asuint(_e51) + asuint(int(1)));
        }
        loop_init = false;
        int _e13 = i;
        if ((_e13 < int(27))) {
        } else {
            break;
        }
        {
            int _e16 = i;
            int _e21 = i;
            int _e28 = i;
            int3 at_2 = int3(asint(asuint(naga_mod(_e16, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e21, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e28, int(9))) - asuint(int(1))));
            const uint3 _e35 = lattice_hash(asint(asuint(cell_1) + asuint(at_2)), seed_2);
            const float3 _e40 = unit_of_hash(_e35);
            float3 offset_1 = (((float3(at_2) + (0.25).xxx) + (0.5 * _e40)) - d_3);
            float3 _e46 = nearest;
            float3 _e47 = nearest;
            if ((dot(offset_1, offset_1) < dot(_e46, _e47))) {
                nearest = offset_1;
                hash_1 = _e35;
            }
        }
    }
    float3 _e53 = nearest;
    float distance_1 = length(_e53);
    border = max((0.5 * (CELL_REACH - distance_1)), 0.0);
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e110 = i_1;
            i_1 = asint(asuint(_e110) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e64 = i_1;
        if ((_e64 < int(27))) {
        } else {
            break;
        }
        {
            int _e67 = i_1;
            int _e72 = i_1;
            int _e79 = i_1;
            int3 at_3 = int3(asint(asuint(naga_mod(_e67, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e72, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e79, int(9))) - asuint(int(1))));
            const uint3 _e90 = lattice_hash(asint(asuint(cell_1) + asuint(at_3)), seed_2);
            const float3 _e91 = unit_of_hash(_e90);
            float3 _e96 = nearest;
            float3 apart = ((((float3(at_3) + (0.25).xxx) + (0.5 * _e91)) - d_3) - _e96);
            float between = length(apart);
            if ((between > 0.25)) {
                float _e101 = border;
                float3 _e102 = nearest;
                border = min(_e101, (dot((_e102 + (0.5 * apart)), apart) / between));
            }
        }
    }
    float _e112 = border;
    uint3 _e115 = hash_1;
    const uint3 _e116 = hash_pcg3d(_e115);
    const float3 _e117 = unit_of_hash(_e116);
    const Cell cell_2 = ConstructCell(max(_e112, 0.0), _e117.x, distance_1);
    return cell_2;
}

Cells ConstructCells(float arg0, float arg1, float arg2) {
    Cells ret = (Cells)0;
    ret.border = arg0;
    ret.random = arg1;
    ret.distance_ = arg2;
    return ret;
}

Cells cells(float3 position_3, float scale, int seed_3)
{
    const float3 _e4 = bounded_vec3_((position_3 * scale));
    const Cell _e6 = nearest_cell(_e4, 0u);
    const float _e7 = footprint_of_vec3_(_e4);
    float visible = (1.0 - smoothstep(0.5, 1.0, _e7));
    float3 average = float3(0.1301, 0.5, 0.491);
    float3 seen_1 = lerp(average, float3(_e6.border, _e6.random, _e6.distance_), visible);
    const Cells cells_1 = ConstructCells(seen_1.x, seen_1.y, seen_1.z);
    return cells_1;
}

FilteredLight ConstructFilteredLight(Light arg0, Angle arg1) {
    FilteredLight ret = (FilteredLight)0;
    ret.light = arg0;
    ret.angle = arg1;
    return ret;
}

float4 shade(Surface surface)
{
    float3 _e3 = look.lamp_position;
    float3 _e6 = look.lamp_aim;
    float3x3 _e9 = look.lamp_own_from_world;
    float3 _e12 = look.lamp_color;
    float _e15 = look.lamp_intensity;
    float2 _e18 = look.lamp_cone;
    float2 _e21 = look.lamp_fading;
    const Light _e23 = light_spot(_e3, _e6, _e9, _e12, _e15, _e18, _e21, surface.position);
    Angle angle_3 = ConstructAngle((0.5 * length((surface.normal - _e23.direction))), (0.5 * length((surface.normal + _e23.direction))));
    float3 _e40 = look.lamp_position;
    float3 _e43 = look.lamp_aim;
    const float3x3 _e45 = axes_turned(_e43, 0.0);
    const float3 _e46 = place_along(surface.position, _e40, _e45);
    const float _e53 = share_of_doors(_e46, float4(0.3, 0.36, 0.3, 0.2), 0.02);
    float3 _e56 = look.lamp_position;
    float3 _e61 = look.lamp_aim;
    const PlaceInLight _e63 = light_place_point(_e56, 0.4, 0.6, _e61, surface.position);
    const Cells _e69 = cells(float3(_e63.uv, 0.0), 13.0, int(0));
    float both = (_e53 * smoothstep(0.12, 0.62, _e69.distance_));
    FilteredLight filter_2_ = ConstructFilteredLight(ConstructLight(_e23.direction, _e23.own_direction, _e23.color, (_e23.intensity * both)), angle_3);
    const float _e85 = profile_balanced(filter_2_.angle, 0.0, tone_shape);
    const LitLayer _e92 = light_apply(filter_2_.light, float4(0.93, 0.62, 0.36, 1.0), _e85);
    const float4 _e102 = blend_add(float4(0.13, 0.14, 0.27, 1.0), _e92.color, _e92.tone, 1.0, true);
    return _e102;
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
    float4x4 _e10 = view.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.position = arg1;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_5, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = ConstructSurface(normal_2, in_.position);
    const float4 _e8 = shade(surface_1);
    return _e8;
}
