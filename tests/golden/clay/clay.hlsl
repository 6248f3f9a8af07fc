// Clay: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
// clay.json says what to put there and how to draw.
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
    Light window;
    Light table;
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint NOISE_PERLIN = 1u;
static const ProfileShape body_tone_shape = ConstructProfileShape(0.9996875, 0.024997396, 1.0955735, 1.3436927, 0.05, 1.2296002, 0.5273893, 0u);
static const ProfileShape bounce_tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.7091175, 1.516349, 0.1, 0.70851815, 0.28734237, 0u);
static const ProfileShape soft_sheen_tone_shape = ConstructProfileShape(0.9996875, 0.024997396, 2.1865644, 2.5171125, 0.05, 0.45394465, 0.19900247, 0u);

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
    float y = (x_1 * x_1);
    float s_1 = (x_1 * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return float2(s_1, c);
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
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_1));
    float2 turned = (((s_2 <= 0.0) & (s_2 < c_1)) ? float2(0.0, 1.0) : upper);
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
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
    const float _e7 = bounded(((_e3 - low) / 0.5));
    float t_2 = clamp(_e7, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
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

float3 bumped_normal(float4 along_x, float4 along_y, float3 normal)
{
    const float _e4 = length_of(along_x.xyz);
    const float _e6 = length_of(along_y.xyz);
    float largest_3 = max(_e4, _e6);
    if (((largest_3 < 1e-18) | (largest_3 > 1e18))) {
        return normal;
    }
    float3 s_3 = (along_x.xyz / (largest_3).xxx);
    float3 t_3 = (along_y.xyz / (largest_3).xxx);
    float2 rise = clamp((float2(along_x.w, along_y.w) / (largest_3).xx), (-1000000.0).xx, (1000000.0).xx);
    float3 right = cross(t_3, normal);
    float3 up = cross(normal, s_3);
    float area = dot(s_3, right);
    if ((abs(area) < 1e-6)) {
        return normal;
    }
    float3 slope = (((rise.x * right) + (rise.y * up)) / (area).xxx);
    float steepness = length(slope);
    float3 limited = (slope * (min(steepness, 10.0) / max(steepness, 1e-20)));
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

LitLayer ConstructLitLayer(float4 arg0, float arg1) {
    LitLayer ret = (LitLayer)0;
    ret.color = arg0;
    ret.tone = arg1;
    return ret;
}

LitLayer light_apply(Light light, float4 color_1, float tone_1)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    const LitLayer litlayer = ConstructLitLayer(float4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
    return litlayer;
}

Angle parametrization_specular_balanced(Light light_1, float3 normal_2, float3 view)
{
    float3 d_1 = (((2.0 * dot(normal_2, view)) * normal_2) - view);
    const Angle angle_2 = ConstructAngle((0.5 * length((d_1 - light_1.direction))), (0.5 * length((d_1 + light_1.direction))));
    return angle_2;
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1)
{
    float2 place = float2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    const float _e19 = profile_soft_quick(place.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    const float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2)
{
    const float2 _e5 = sin_cos_quick((0.5 * shift));
    const Angle _e6 = angle_turned(angle, _e5);
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
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

float3 fade_quintic(float3 t_1)
{
    return (((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - (15.0).xxx)) + (10.0).xxx));
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

float fractal_noise(uint kind, float3 p_1, int octaves, float roughness, int seed_3, float w_1)
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
            int _e66 = i_1;
            i_1 = asint(asuint(_e66) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e17 = i_1;
        if (!((_e17 < int(2)))) {
            break;
        }
        float _e21 = frequency;
        const float _e25 = eased((w_1 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            float3 place_1 = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_1;
            const float _e50 = perlin_noise(place_1, (0u + uint(_e47)));
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
        strength = (_e61 * roughness);
        float _e63 = frequency;
        frequency = (_e63 * 2.0);
    }
    float _e69 = sum_1;
    float _e70 = total;
    return min((_e69 / _e70), 1.0);
}

float noise_perlin(float3 position_1, float scale_1, int octaves_1, float roughness_1, int seed_4)
{
    float3 p_2 = (position_1 * scale_1);
    const float _e7 = footprint_of_vec3_(p_2);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

float4 shade(Surface surface)
{
    float shade_in_hollows_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.09), -20.0, 20.0))))))));
    const float4 _e30 = curvature_color(shade_in_hollows_convexity, float4(0.851, 0.5412, 0.4, 1.0), float4(0.6902, 0.3765, 0.2902, 1.0));
    const float _e36 = noise_perlin(surface.position_object, 2.6, int(2), 0.4, int(0));
    const float3 _e40 = bump_map(_e36, 0.05, surface.normal, surface.position);
    float3 _e44 = look.window.direction;
    float3 _e52 = look.window.direction;
    Angle body_angle = ConstructAngle((0.5 * length((_e40 - _e44))), (0.5 * length((_e40 + _e52))));
    float body_warp = (((2.0 * shade_in_hollows_convexity) - 1.0) * 0.2);
    const float _e65 = profile_balanced(body_angle, body_warp, body_tone_shape);
    Light _e68 = look.window;
    const LitLayer _e69 = light_apply(_e68, _e30, _e65);
    const float4 _e79 = blend_alpha(float4(0.3529, 0.2, 0.1529, 1.0), _e69.color, _e69.tone, 1.0, true);
    const float4 _e87 = curvature_color(shade_in_hollows_convexity, (1.0).xxxx, float4(0.7216, 0.4706, 0.4235, 1.0));
    Light _e90 = look.window;
    const LitLayer _e92 = light_apply(_e90, _e87, 1.0);
    float4 shade_in_hollows_blend = clamp(float4((_e79.xyz + (0.8 * ((_e79.xyz * (_e92.tone * _e92.color.xyz)) - _e79.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    float soft_sheen_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.15), -20.0, 20.0))))))));
    const float4 _e141 = curvature_color(soft_sheen_convexity, float4(0.4157, 0.2353, 0.1804, 1.0), float4(0.2902, 0.1412, 0.1216, 1.0));
    float3 _e145 = look.table.direction;
    float3 _e153 = look.table.direction;
    Angle bounce_angle = ConstructAngle((0.5 * length((_e40 - _e145))), (0.5 * length((_e40 + _e153))));
    float bounce_warp = (((2.0 * soft_sheen_convexity) - 1.0) * 0.15);
    const float _e166 = profile_balanced(bounce_angle, bounce_warp, bounce_tone_shape);
    Light _e169 = look.table;
    const LitLayer _e170 = light_apply(_e169, _e141, _e166);
    float4 bounce_blend = clamp(float4((shade_in_hollows_blend.xyz + (_e170.tone * _e170.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float4 _e194 = curvature_color(soft_sheen_convexity, float4(0.302, 0.2039, 0.1686, 1.0), float4(0.1647, 0.102, 0.0863, 1.0));
    Light _e197 = look.window;
    const Angle _e199 = parametrization_specular_balanced(_e197, _e40, surface.view);
    float soft_sheen_warp = (((2.0 * soft_sheen_convexity) - 1.0) * 0.1);
    const float _e207 = profile_balanced(_e199, soft_sheen_warp, soft_sheen_tone_shape);
    Light _e210 = look.window;
    const LitLayer _e211 = light_apply(_e210, _e194, _e207);
    float4 soft_sheen_blend = clamp(float4((bounce_blend.xyz + (_e211.tone * _e211.color.xyz)), 1.0), (0.0).xxxx, (1.0).xxxx);
    return soft_sheen_blend;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2, float3 arg3) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.position_object = arg2;
    ret.normal = arg3;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_1.clip_from_world;
    float3x3 _e16 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float arg4) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position = arg2;
    ret.position_object = arg3;
    ret.kappa = arg4;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_3, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_5 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e25 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_5, normalize((_e8.xyz - (_e13 * in_.position))), in_.position, in_.position_object, _e25.x);
    const float4 _e28 = shade(surface_1);
    return _e28;
}
