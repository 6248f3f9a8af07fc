// Orange peel: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// figure7-orange.json says what to put there and how to draw.
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
    Light key;
    Light fill;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position;
    int _pad3_0;
    float3 position_object;
    float kappa;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct LitLayer {
    float4 color;
    float tone;
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

static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint NOISE_PERLIN = 1u;
static const ProfileShape flesh_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.1220733, 1.2466265, 0.1, 1.2259196, 0.51338285, 0u);
static const ProfileShape shade_tone_shape = ConstructProfileShape(0.9950042, 0.099833414, 1.6523834, 1.9165641, 0.2, 0.67495763, 0.28714308, 0u);
static const ProfileShape waxy_sheen_tone_shape = ConstructProfileShape(0.9996875, 0.024997396, 2.2990327, 2.8187852, 0.05, 0.41226318, 0.18345885, 0u);
static const ProfileShape glint_tone_shape = ConstructProfileShape(0.9992001, 0.039989334, 14.297388, 3.2165964, 0.08, 0.062200632, 0.027819062, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position_2 : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_3 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
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

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float2 sin_cos_quick(float x_1)
{
    float y_1 = (x_1 * x_1);
    float s_3 = (x_1 * (1.0 + (y_1 * (-0.16666666 + (y_1 * (0.0083332425 + (y_1 * (-0.0001982274 + (y_1 * 2.6347564e-6)))))))));
    float c = (1.0 + (y_1 * (-0.5 + (y_1 * (0.04166666 + (y_1 * (-0.0013888652 + (y_1 * (2.477458e-5 - (y_1 * 2.6297516e-7))))))))));
    return float2(s_3, c);
}

float log2_one_minus(float y)
{
    float series = ((-(y) * LOG2_E) * (1.0 + (y * (0.5 + (y * (0.33333334 + (y * (0.25 + (y * 0.2)))))))));
    return ((y < 0.0625) ? series : log2(max((1.0 - y), 7.888609e-31)));
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_4 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_4, c_1));
    float2 turned = (((s_4 <= 0.0) & (s_4 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_4 = ConstructAngle(turned.x, turned.y);
    return angle_4;
}

Angle angle_turned_2_(Angle u_2, float2 t_1)
{
    float s_5 = (u_2.half_sin - 0.0);
    float2 upper_1 = ((u_2.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_5, u_2.half_cos));
    float2 turned_1 = (((s_5 <= 0.0) & (s_5 < u_2.half_cos)) ? float2(0.0, 1.0) : upper_1);
    const Angle angle_5 = ConstructAngle(turned_1.x, turned_1.y);
    return angle_5;
}

float bounded(float x_2)
{
    uint bits = asuint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_3, float low, float high)
{
    const float _e3 = bounded(x_3);
    const float _e8 = bounded(((_e3 - 0.5) / 0.5));
    float t_3 = clamp(_e8, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float length_of(float3 v_2)
{
    float largest_2 = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e16 = bounded((largest_2 * length((v_2 / (largest_2).xxx))));
    return _e16;
}

float footprint_of_vec3_(float3 v_3)
{
    float3 dx_1 = ddx(v_3);
    float3 dy_1 = ddy(v_3);
    const float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return (concave + (convexity * (convex - concave)));
}

float curvature_signed_balanced(float kappa, float slope)
{
    return (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp(((((asuint(kappa) & 2147483647u) > 2139095040u) ? 0.0 : clamp(kappa, -10000.0, 10000.0)) * slope), -20.0, 20.0))))));
}

float3 bumped_normal(float4 along_x, float4 along_y, float3 normal)
{
    const float _e4 = length_of(along_x.xyz);
    const float _e6 = length_of(along_y.xyz);
    float largest_3 = max(_e4, _e6);
    if (((largest_3 < 1e-18) | (largest_3 > 1e18))) {
        return normal;
    }
    float3 s_6 = (along_x.xyz / (largest_3).xxx);
    float3 t_4 = (along_y.xyz / (largest_3).xxx);
    float2 rise = clamp((float2(along_x.w, along_y.w) / (largest_3).xx), (-1000000.0).xx, (1000000.0).xx);
    float3 right = cross(t_4, normal);
    float3 up = cross(normal, s_6);
    float area = dot(s_6, right);
    if ((abs(area) < 1e-6)) {
        return normal;
    }
    float3 slope_1 = (((rise.x * right) + (rise.y * up)) / (area).xxx);
    float steepness = length(slope_1);
    float3 limited = (slope_1 * (min(steepness, 10.0) / max(steepness, 1e-20)));
    const float3 _e50 = normalize_or((normal - limited), normal);
    return _e50;
}

float3 bump_map(float height, float scale, float3 normal_1, float3 position)
{
    float raised = (height * scale);
    float3 _e5 = ddx(position);
    float _e6 = ddx(raised);
    float4 along_x_1 = float4(_e5, _e6);
    float3 _e8 = ddy(position);
    float _e9 = ddy(raised);
    float4 along_y_1 = float4(_e8, _e9);
    const float3 _e11 = bumped_normal(along_x_1, along_y_1, normal_1);
    return _e11;
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_alpha_2_(float4 below_1, float4 color_1, float tone_1, float opacity_1, bool clamped_1)
{
    return clamp(float4((below_1.xyz + (opacity_1 * ((below_1.xyz + (tone_1 * (color_1.xyz - below_1.xyz))) - below_1.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_shade(float4 below_2, float4 color_2, float tone_2, float opacity_2, bool clamped_2)
{
    return clamp(float4((below_2.xyz + (0.75 * ((below_2.xyz * lerp((1.0).xxx, color_2.xyz, tone_2)) - below_2.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_3, float tone_3)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_3.xyz * light.color) * split.y), 1.0), (tone_3 * split.x));
    return litlayer;
}

LitLayer light_apply_2_(Light light_1, float4 color_4, float tone_4)
{
    float2 split_1 = float2(min(light_1.intensity, 1.0), max(light_1.intensity, 1.0));
    const LitLayer litlayer_1 = ConstructLitLayer(float4((light_1.color * split_1.y), 1.0), (tone_4 * split_1.x));
    return litlayer_1;
}

Angle parametrization_specular_balanced(Light light_2, float3 normal_2, float3 view)
{
    float3 d_1 = (((2.0 * dot(normal_2, view)) * normal_2) - view);
    const Angle angle_6 = ConstructAngle((0.5 * length((d_1 - light_2.direction))), (0.5 * length((d_1 + light_2.direction))));
    return angle_6;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    const float _e8 = log2_one_minus(min((q * q), 1.0));
    return ((s <= 0.0) ? 1.0 : ((q >= 1.0) ? 0.0 : min(exp2((shape.exponent * _e8)), 1.0)));
}

float profile_soft_quick_2_(float s_1, ProfileShape shape_1)
{
    float q_1 = (s_1 * shape_1.scale);
    const float _e8 = log2_one_minus(min((q_1 * q_1), 1.0));
    return ((s_1 <= 0.0) ? 1.0 : ((q_1 >= 1.0) ? 0.0 : min(exp2(max((shape_1.exponent * _e8), -126.0)), 1.0)));
}

float profile_ramp_quick(float s_2, float w, ProfileShape shape_2)
{
    float width = sqrt(((w * w) + ((12.0 * shape_2.edge_deviation) * shape_2.edge_deviation)));
    float from_offset = (s_2 * (2.0 + ((s_2 * s_2) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_2.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_2 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_3, float w_1, ProfileShape shape_3)
{
    float2 place = float2(((u_3.half_sin * shape_3.half_cos_offset) - (u_3.half_cos * shape_3.half_sin_offset)), ((u_3.half_cos * shape_3.half_cos_offset) + (u_3.half_sin * shape_3.half_sin_offset)));
    const float _e19 = profile_soft_quick(place.x, shape_3);
    if ((w_1 < (0.1 * shape_3.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w_1);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_3);
    const float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_3);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_2_(Angle u_4, float w_2, ProfileShape shape_4)
{
    float2 place_1 = float2(((u_4.half_sin * shape_4.half_cos_offset) - (u_4.half_cos * shape_4.half_sin_offset)), ((u_4.half_cos * shape_4.half_cos_offset) + (u_4.half_sin * shape_4.half_sin_offset)));
    const float _e19 = profile_soft_quick_2_(place_1.x, shape_4);
    if ((w_2 < (0.1 * shape_4.edge_deviation))) {
        return _e19;
    }
    float r_1 = (0.19364917 * w_2);
    float2 turn_1 = float2((r_1 * (1.0 - ((0.16666667 * r_1) * r_1))), (1.0 - ((0.5 * r_1) * r_1)));
    const float _e45 = profile_soft_quick_2_(((place_1.x * turn_1.y) - (place_1.y * turn_1.x)), shape_4);
    const float _e53 = profile_soft_quick_2_(((place_1.x * turn_1.y) + (place_1.y * turn_1.x)), shape_4);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_filtered_quick_3_(Angle u_5, float w_3, ProfileShape shape_5)
{
    float2 place_2 = float2(((u_5.half_sin * shape_5.half_cos_offset) - (u_5.half_cos * shape_5.half_sin_offset)), ((u_5.half_cos * shape_5.half_cos_offset) + (u_5.half_sin * shape_5.half_sin_offset)));
    bool is_narrow = ((w_3 > 0.0) & (w_3 >= (3.4641016 * shape_5.edge_deviation)));
    if ((false | is_narrow)) {
        const float _e28 = profile_ramp_quick(place_2.x, w_3, shape_5);
        return _e28;
    }
    const float _e30 = profile_soft_quick_2_(place_2.x, shape_5);
    if ((w_3 < (0.1 * shape_5.edge_deviation))) {
        return _e30;
    }
    float r_2 = (0.19364917 * w_3);
    float2 turn_2 = float2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    const float _e56 = profile_soft_quick_2_(((place_2.x * turn_2.y) - (place_2.y * turn_2.x)), shape_5);
    const float _e64 = profile_soft_quick_2_(((place_2.x * turn_2.y) + (place_2.y * turn_2.x)), shape_5);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_6)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_6);
    return _e8;
}

float profile_balanced_2_(Angle angle_1, float shift_1, ProfileShape shape_7)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift_1));
    const Angle _e6 = angle_turned(angle_1, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_7);
    return _e8;
}

float profile_balanced_3_(Angle angle_2, float shift_2, ProfileShape shape_8)
{
    const Angle _e6 = angle_turned_2_(angle_2, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_2_(_e6, _e7, shape_8);
    return _e8;
}

float profile_balanced_4_(Angle angle_3, float shift_3, ProfileShape shape_9)
{
    const Angle _e6 = angle_turned_2_(angle_3, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick_3_(_e6, _e7, shape_9);
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
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
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
    float3 d_2 = (p - corner);
    const float3 _e4 = fade_quintic(d_2);
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
            const float _e42 = gradient_dot(_e39, (d_2 - float3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, float3 p_1, int octaves, float roughness, int seed_3, float w_4)
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
        const float _e25 = eased((w_4 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            float3 place_3 = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_1;
            const float _e50 = perlin_noise(place_3, (0u + uint(_e47)));
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

float noise_perlin(float3 position_1, float scale_1, int octaves_1, float roughness_1, int seed_4)
{
    float3 p_2 = (position_1 * scale_1);
    const float _e7 = footprint_of_vec3_(p_2);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

float4 shade(Surface surface_1)
{
    const float _e3 = curvature_signed_balanced(surface_1.kappa, 0.1);
    float shade_convexity = (0.5 + (0.5 * _e3));
    const float4 _e18 = curvature_color(shade_convexity, float4(0.9686, 0.6039, 0.1176, 1.0), float4(0.8471, 0.4118, 0.0392, 1.0));
    float3 place_4 = surface_1.position_object;
    const float _e24 = noise_perlin(place_4, 14.0, int(2), 0.5, int(0));
    const float3 _e28 = bump_map(_e24, 0.035, surface_1.normal, surface_1.position);
    float3 _e32 = look.key.direction;
    float3 _e40 = look.key.direction;
    Angle flesh_angle = ConstructAngle((0.5 * length((_e28 - _e32))), (0.5 * length((_e28 + _e40))));
    float flesh_warp = (((2.0 * shade_convexity) - 1.0) * 0.2);
    const float _e53 = profile_balanced(flesh_angle, flesh_warp, flesh_tone_shape);
    Light _e56 = look.key;
    const LitLayer _e57 = light_apply(_e56, _e18, _e53);
    const float4 _e67 = blend_alpha(float4(0.4314, 0.1647, 0.0235, 1.0), _e57.color, _e57.tone, 1.0, true);
    const float4 _e78 = curvature_color(shade_convexity, float4(0.7216, 0.2824, 0.0471, 1.0), float4(0.5412, 0.1843, 0.0392, 1.0));
    float3 _e82 = look.fill.direction;
    float3 _e90 = look.fill.direction;
    Angle shade_angle = ConstructAngle((0.5 * length((_e28 - _e82))), (0.5 * length((_e28 + _e90))));
    float shade_warp = (((2.0 * shade_convexity) - 1.0) * 0.1);
    const float _e103 = profile_balanced_2_(shade_angle, shade_warp, shade_tone_shape);
    Light _e106 = look.fill;
    const LitLayer _e107 = light_apply(_e106, _e78, _e103);
    const float4 _e112 = blend_shade(_e67, _e107.color, _e107.tone, 0.75, true);
    Light _e115 = look.key;
    const Angle _e117 = parametrization_specular_balanced(_e115, _e28, surface_1.view);
    const float _e120 = profile_balanced_3_(_e117, 0.0, waxy_sheen_tone_shape);
    Light _e123 = look.key;
    const LitLayer _e129 = light_apply(_e123, float4(0.4157, 0.2902, 0.1333, 1.0), _e120);
    float4 waxy_sheen_blend = clamp(float4((_e112.xyz + (0.55 * ((_e112.xyz + (_e129.tone * _e129.color.xyz)) - _e112.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float _e151 = profile_balanced_4_(_e117, 0.0, glint_tone_shape);
    Light _e154 = look.key;
    const LitLayer _e157 = light_apply_2_(_e154, (1.0).xxxx, _e151);
    const float4 _e162 = blend_alpha_2_(waxy_sheen_blend, _e157.color, _e157.tone, 0.85, true);
    return _e162;
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

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_3, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_5 = (is_front ? _e3 : -(_e3));
    surface.normal = normal_5;
    float4 _e11 = view_1.eye;
    float _e16 = view_1.eye.w;
    surface.view = normalize((_e11.xyz - (_e16 * in_.position)));
    surface.position = in_.position;
    surface.position_object = in_.position_object;
    float4 _e31 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e31.x;
    Surface _e33 = surface;
    const float4 _e34 = shade(_e33);
    return _e34;
}
