// Iridescent film: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_4 b0, object b1, look b2.
// material-film.json says what to put there and how to draw.
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
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    int _end_pad_0;
};

struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
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

static const float PI = 3.1415927;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const uint NOISE_PERLIN = 1u;

cbuffer view_4 : register(b0) { View view_4; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_5 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x)
{
    float clamped_1 = max(x, -126.0);
    float whole = round(clamped_1);
    float f = (clamped_1 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_1)
{
    uint bits = asuint(x_1);
    int exponent_1 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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
    const float _e7 = log2_stable((1.0 - y_1));
    return (LN_2_ * _e7);
}

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float footprint_of_vec3_(float3 v_2)
{
    float3 dx = ddx(v_2);
    float3 dy = ddy(v_2);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (1.0).xxx)) - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float3 half_of(float3 light, float3 normal, float3 view)
{
    float3 half_ = (light + view);
    const float3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(float3 a, float3 b)
{
    float3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

Reflection ConstructReflection(float arg0, float arg1, float arg2, float arg3, float arg4) {
    Reflection ret = (Reflection)0;
    ret.n_l = arg0;
    ret.n_v = arg1;
    ret.n_h = arg2;
    ret.v_h = arg3;
    ret.sine2_ = arg4;
    return ret;
}

Reflection reflection_of(float3 light_1, float3 normal_1, float3 view_1)
{
    const float3 _e3 = half_of(light_1, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    const float _e14 = sine_squared(normal_1, _e3);
    const Reflection reflection = ConstructReflection(dot(normal_1, light_1), dot(normal_1, view_1), n_h, v_h, _e14);
    return reflection;
}

float cosine_power(float cosine, float sine2_, float exponent)
{
    if ((cosine < 0.7)) {
        return 0.0;
    }
    const float _e12 = log1p_negative(min(sine2_, 0.6));
    const float _e14 = exp2_stable((((0.5 * exponent) * LOG2_E) * _e12));
    return _e14;
}

float schlick(float at_normal, float cosine_1)
{
    float m = (1.0 - cosine_1);
    float m2_ = (m * m);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m)));
}

float interference(float path, float wavelength)
{
    float x_2 = ((PI * path) / wavelength);
    float2 half_1 = float2(sin(x_2), cos(x_2));
    return (half_1.x * half_1.x);
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_3 = (uint3)0;

    v_3 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_3.x;
    uint _e10 = v_3.y;
    uint _e12 = v_3.z;
    v_3.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_3.y;
    uint _e18 = v_3.z;
    uint _e20 = v_3.x;
    v_3.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_3.z;
    uint _e26 = v_3.x;
    uint _e28 = v_3.y;
    v_3.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_3;
    uint3 _e32 = v_3;
    v_3 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_3.x;
    uint _e40 = v_3.y;
    uint _e42 = v_3.z;
    v_3.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_3.y;
    uint _e48 = v_3.z;
    uint _e50 = v_3.x;
    v_3.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_3.z;
    uint _e56 = v_3.x;
    uint _e58 = v_3.y;
    v_3.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_3;
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
    float a_1 = ((axis == 0u) ? d.y : d.x);
    float b_1 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_1 : -(a_1)) + (((hash.z >> 31u) == 0u) ? b_1 : -(b_1)));
}

float3 fade_quintic(float3 t)
{
    return (((t * t) * t) * ((t * ((t * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i = int(0);

    float3 corner = floor(p);
    float3 d_1 = (p - corner);
    const float3 _e4 = fade_quintic(d_1);
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
            const float _e42 = gradient_dot(_e39, (d_1 - float3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, float3 p_1, int octaves, float roughness, int seed_3, float w)
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
        float visible = (1.0 - smoothstep(0.5, 1.0, (w * _e21)));
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            float3 place = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_1;
            const float _e50 = perlin_noise(place, (0u + uint(_e47)));
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
    return min((_e69 / 1.5), 1.0);
}

float reflectance_blinn_phong(Light light_2, float3 normal_2, float3 view_2, float roughness_1)
{
    const Reflection _e5 = reflection_of(light_2.direction, normal_2, view_2);
    float width = (roughness_1 * roughness_1);
    float e = ((2.0 / (width * width)) - 2.0);
    const float _e14 = cosine_power(_e5.n_h, _e5.sine2_, e);
    return (((0.125 * (e + 8.0)) * _e14) * max(_e5.n_l, 0.0));
}

float4 thin_film(float thickness, float index, float3 normal_3, float3 view_3)
{
    float cosine_2 = clamp(dot(normal_3, view_3), 0.0, 1.0);
    float inside = sqrt((((index - 1.0) * (index + 1.0)) + (cosine_2 * cosine_2)));
    float path_1 = ((2.0 * thickness) * inside);
    const float _e20 = interference(path_1, 650.0);
    const float _e22 = interference(path_1, 532.0);
    const float _e24 = interference(path_1, 450.0);
    return float4(_e20, _e22, _e24, 1.0);
}

float noise_perlin(float3 position, float scale, int octaves_1, float roughness_2, int seed_4)
{
    float3 p_2 = (position * scale);
    const float _e7 = footprint_of_vec3_(p_2);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_2, seed_4, _e7);
    return _e8;
}

float4 shade(Surface surface)
{
    const float _e6 = noise_perlin(surface.position_object, 1.3, int(2), 0.5, int(0));
    float thickness_1 = lerp(180.0, 420.0, (_e6 - 0.0));
    const float4 _e15 = thin_film(thickness_1, 1.33, surface.normal, surface.view);
    const float _e23 = schlick(0.45, clamp(dot(surface.normal, surface.view), 0.0, 1.0));
    float4 film_2_ = min(float4((float3(0.0784, 0.0863, 0.1216) + (_e23 * _e15.xyz)), 1.0), (1.0).xxxx);
    Light _e38 = look.key;
    const float _e42 = reflectance_blinn_phong(_e38, surface.normal, surface.view, 0.22);
    const float4 _e47 = blend_add(film_2_, (1.0).xxxx, _e42, 0.2, true);
    return _e47;
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
    float4x4 _e10 = view_4.clip_from_world;
    float3x3 _e16 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_6 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_4.eye;
    float _e13 = view_4.eye.w;
    Surface surface_1 = ConstructSurface(normal_6, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object);
    const float4 _e20 = shade(surface_1);
    return _e20;
}
