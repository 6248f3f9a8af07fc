// Travel poster: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws normals and depth, for the curvature pass.
// Registers of space 0: view b0, object b1.
// travel-poster.json says what to put there and how to draw.
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

float2 slope_of(float3 normal)
{
    return (normal.xy / (max(normal.z, 0.2)).xx);
}

float4 surface_texel(float3 normal_1, float depth, float number)
{
    const float2 _e3 = slope_of(normal_1);
    return float4(_e3, depth, ((normal_1.z < 0.0) ? -(number) : number));
}

float3 shade(Surface surface_1)
{
    return surface_1.normal;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    Varyings _e22 = out_;
    const Varyings varyings = _e22;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    bool local = (bool)0;
    Surface surface = (Surface)0;

    const float3 _e3 = normalize_seen(in_.normal);
    float4 _e6 = view.eye;
    float _e11 = view.eye.w;
    const float3 _e15 = normalize_or((_e6.xyz - (_e11 * in_.position)), _e3);
    if (!(is_front)) {
        local = (dot(_e3, _e15) < -0.1);
    } else {
        local = false;
    }
    bool is_behind = local;
    float3 normal_4 = (is_behind ? -(_e3) : _e3);
    surface.normal = normal_4;
    Surface _e28 = surface;
    const float3 _e29 = shade(_e28);
    float4x4 _e32 = view.camera_from_world;
    float3 seen = mul(float4(_e29, 0.0), _e32).xyz;
    float4x4 _e39 = view.camera_from_world;
    float depth_1 = -(mul(float4(in_.position, 1.0), _e39).z);
    float _e48 = object.id;
    const float4 _e51 = surface_texel(seen, depth_1, (_e48 + 1.0));
    return _e51;
}
