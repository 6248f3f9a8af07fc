// Hatching: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws normals and depth, for the curvature pass.
// Registers of space 0: view b0, object b1.
// hatching.json says what to put there and how to draw.
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

struct Fragment {
    float4 normal : SV_Target0;
    float depth : SV_Target1;
};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise)
{
    const bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

float3 finite_vec3_(float3 v)
{
    const float _e3 = finite_or(v.x, 0.0);
    const float _e6 = finite_or(v.y, 0.0);
    const float _e9 = finite_or(v.z, 0.0);
    return float3(_e3, _e6, _e9);
}

float4 finite_vec4_(float4 v_1)
{
    const float3 _e2 = finite_vec3_(v_1.xyz);
    const float _e5 = finite_or(v_1.w, 0.0);
    return float4(_e2, _e5);
}

float3 normalize_or(float3 v_2, float3 otherwise_1)
{
    bool local_1 = (bool)0;

    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local_1 = (largest < 1e30);
    } else {
        local_1 = false;
    }
    bool _e17 = local_1;
    if (!(_e17)) {
        return otherwise_1;
    }
    float3 scaled = (v_2 * (1.0 / largest));
    float square = dot(scaled, scaled);
    const bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
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

Fragment ConstructFragment(float4 arg0, float arg1) {
    Fragment ret = (Fragment)0;
    ret.normal = arg0;
    ret.depth = arg1;
    return ret;
}

Fragment fs_main(FragmentInput_fs_main fragmentinput_fs_main)
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    bool local = (bool)0;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float4 _e10 = view.eye;
    float _e15 = view.eye.w;
    const float3 _e19 = normalize_or((_e10.xyz - (_e15 * in_.position)), _e7);
    if (!(is_front)) {
        local = (dot(_e7, _e19) < -0.1);
    } else {
        local = false;
    }
    bool is_behind = local;
    float3 normal_2 = (is_behind ? -(_e7) : _e7);
    surface.normal = normal_2;
    Surface _e32 = surface;
    const float3 _e33 = shade(_e32);
    float4x4 _e36 = view.camera_from_world;
    float3 seen = mul(float4(_e33, 0.0), _e36).xyz;
    float4x4 _e43 = view.camera_from_world;
    float depth = -(mul(float4(in_.position, 1.0), _e43).z);
    float _e52 = object.id;
    const Fragment fragment = ConstructFragment(float4(seen, (_e52 + 1.0)), depth);
    return fragment;
}
