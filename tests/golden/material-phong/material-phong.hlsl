// Phong: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// material-phong.json says what to put there and how to draw.
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
    int _end_pad_0;
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

static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;

cbuffer view_1 : register(b0) { View view_1; }
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

float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4((below.xyz + (opacity * ((below.xyz + (tone * (1.0).xxx)) - below.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float sine_squared(float3 a, float3 b)
{
    float3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

float cosine_power(float cosine, float sine2_, float exponent)
{
    if ((cosine < 0.7)) {
        return pow(max(cosine, 0.0), exponent);
    }
    const float _e14 = log1p_negative(min(sine2_, 0.6));
    const float _e16 = exp2_stable((((0.5 * exponent) * LOG2_E) * _e14));
    return _e16;
}

float reflectance_phong(Light light, float3 normal, float3 view, float roughness)
{
    float width = (roughness * roughness);
    float e = ((2.0 / (width * width)) - 2.0);
    float n_l = max(dot(normal, light.direction), 0.0);
    const float3 _e19 = normalize_moderate((((2.0 * dot(normal, view)) * normal) - view), normal);
    const float _e23 = sine_squared(_e19, light.direction);
    const float _e24 = cosine_power(dot(_e19, light.direction), _e23, e);
    return (((0.5 * (e + 2.0)) * _e24) * n_l);
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float lambert = max(dot(surface.normal, _e5), 0.0);
    float4 body = float4((float3(0.1647, 0.0706, 0.1255) + (lambert * float3(0.7608, 0.2314, 0.2275))), 1.0);
    Light _e23 = look.key;
    const float _e27 = reflectance_phong(_e23, surface.normal, surface.view, 0.42);
    const float4 _e32 = blend_add(body, (1.0).xxxx, _e27, 0.32, true);
    return _e32;
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
    float4x4 _e10 = view_1.clip_from_world;
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
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    return _e19;
}
