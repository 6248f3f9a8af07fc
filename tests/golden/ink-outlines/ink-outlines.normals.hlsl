// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws normals and depth, for the curvature pass.
// Registers of space 0: view b0, object b1.
// ink-outlines.json says what to put there and how to draw.
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
    float3 normal;
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

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen(float3 v_1)
{
    const float3 _e5 = normalize_moderate(v_1, float3(0.0, 0.0, 1.0));
    return _e5;
}

float2 slope_of(float3 normal)
{
    return (normal.xy / (max(normal.z, 0.2)).xx);
}

float4 surface_texel(float3 normal_1, float depth, float number)
{
    const float2 _e3 = slope_of(normal_1);
    return float4(_e3, depth, ((normal_1.z < 0.0) ? -(number) : number));
}

float3 shade(Surface surface)
{
    return surface.normal;
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

Surface ConstructSurface(float3 arg0) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    bool local = (bool)0;

    const float3 _e3 = normalize_seen(in_.normal);
    float4 _e6 = view.eye;
    float _e11 = view.eye.w;
    float3 toward = normalize((_e6.xyz - (_e11 * in_.position)));
    if (!(is_front)) {
        local = (dot(_e3, toward) < -0.1);
    } else {
        local = false;
    }
    bool is_behind = local;
    float3 normal_4 = (is_behind ? -(_e3) : _e3);
    Surface surface_1 = ConstructSurface(normal_4);
    float4x4 _e29 = view.camera_from_world;
    const float3 _e30 = shade(surface_1);
    float3 seen = mul(float4(_e30, 0.0), _e29).xyz;
    float4x4 _e37 = view.camera_from_world;
    float depth_1 = -(mul(float4(in_.position, 1.0), _e37).z);
    float _e46 = object.id;
    const float4 _e49 = surface_texel(seen, depth_1, (_e46 + 1.0));
    return _e49;
}
