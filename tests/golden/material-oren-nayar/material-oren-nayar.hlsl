// Oren-Nayar: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// material-oren-nayar.json says what to put there and how to draw.
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

float3 normalize_seen_balanced(float3 v)
{
    return (v * rsqrt(max(dot(v, v), 1e-30)));
}

float oren_nayar(float3 light, float3 normal, float3 view, float sigma)
{
    float n_l = dot(normal, light);
    float n_v = dot(normal, view);
    if ((n_l <= 0.0)) {
        return 0.0;
    }
    float s2_ = (sigma * sigma);
    float a = (1.0 - ((0.5 * s2_) / (s2_ + 0.33)));
    float b = ((0.45 * s2_) / (s2_ + 0.09));
    float across = (dot(light, view) - (n_l * n_v));
    float larger = max(max(n_l, n_v), 0.001);
    return (n_l * (a + ((b * max(across, 0.0)) / larger)));
}

float4 shade(Surface surface)
{
    float3 _e4 = look.key.direction;
    const float _e8 = oren_nayar(_e4, surface.normal, surface.view, 0.9);
    float4 body = min(float4((float3(0.1725, 0.1647, 0.2) + (_e8 * float3(0.851, 0.7961, 0.698))), 1.0), (1.0).xxxx);
    return body;
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
