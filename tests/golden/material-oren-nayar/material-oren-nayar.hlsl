// Oren-Nayar: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2.
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

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

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
    bool local = (bool)0;

    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local = (largest < 1e30);
    } else {
        local = false;
    }
    bool _e17 = local;
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

float bounded(float x_2)
{
    uint bits = asuint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped ? clamp(mixed, (0.0).xxxx, (1.0).xxxx) : mixed);
}

float4 blend_add(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_1)
{
    const float4 _e12 = blend_finish(below_1, (below_1.xyz + (tone * color.xyz)), below_1.w, (opacity_1 * color.w), clamped_1);
    return _e12;
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
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

float reflectance_oren_nayar(Light light_1, float3 normal_1, float3 view_1, float roughness)
{
    const float _e4 = bounded(roughness);
    float sigma_1 = clamp(_e4, 0.0, 1.0);
    const float3 _e13 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    const float _e14 = oren_nayar(light_1.direction, _e13, view_1, sigma_1);
    return _e14;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e7 = reflectance_oren_nayar(_e3, surface_1.normal, surface_1.view, 0.9);
    const float4 _e20 = blend_add(float4(0.1725, 0.1647, 0.2, 1.0), float4(0.851, 0.7961, 0.698, 1.0), _e7, 1.0, true);
    const float4 _e21 = output(_e20);
    return _e21;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_2.clip_from_world;
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
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    float4 _e26 = view_2.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    const float4 _e35 = shade(_e34);
    const float4 _e36 = finite_vec4_(_e35);
    return _e36;
}
