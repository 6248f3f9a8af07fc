// Anisotropic Ward: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_3 b0, object b1, look b2.
// material-ward.json says what to put there and how to draw.
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
    float3 tangent;
    int _end_pad_0;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
};

cbuffer view_3 : register(b0) { View view_3; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_4 : LOC1;
    float4 tangent_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_5 : LOC1;
    float4 tangent_3 : LOC2;
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

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x_1)
{
    float clamped = max(x_1, -126.0);
    float whole = round(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float3 normalize_moderate(float3 v_1, float3 otherwise_1)
{
    float square_1 = dot(v_1, v_1);
    return ((square_1 > 1e-30) ? (v_1 * rsqrt(max(square_1, 1e-30))) : otherwise_1);
}

float3 normalize_seen_balanced(float3 v_2)
{
    return (v_2 * rsqrt(max(dot(v_2, v_2), 1e-30)));
}

float3 any_orthogonal(float3 n)
{
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_ + n.z));
    return float3((1.0 + (((sign_ * n.x) * n.x) * a)), (((sign_ * n.x) * n.y) * a), (-(sign_) * n.x));
}

float3x3 world_from_tangent(float3 tangent, float3 bitangent, float3 normal)
{
    float3 t = (tangent * rsqrt(max(dot(tangent, tangent), 1e-30)));
    float3 leaning = (t - (dot(t, normal) * normal));
    bool is_usable = (dot(leaning, leaning) > 1e-8);
    const float3 _e14 = any_orthogonal(normal);
    const float3 _e20 = normalize_or((is_usable ? leaning : _e14), float3(1.0, 0.0, 0.0));
    const float3 _e28 = normalize_moderate((_e20 - (dot(_e20, normal) * normal)), float3(1.0, 0.0, 0.0));
    float3 b = cross(normal, _e28);
    return float3x3(_e28, b, normal);
}

float3 half_of(float3 light, float3 normal_1, float3 view)
{
    float3 half_ = (light + view);
    const float3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal_1), normal_1);
    return _e8;
}

float ward(float3 light_1, float3 normal_2, float3 view_1, float3 x_axis, float3 y_axis, float2 widths)
{
    float n_l = dot(normal_2, light_1);
    float n_v = dot(normal_2, view_1);
    if (((n_l <= 0.0) | (n_v <= 0.0))) {
        return 0.0;
    }
    const float3 _e14 = half_of(light_1, normal_2, view_1);
    float n_h = max(dot(normal_2, _e14), 1e-6);
    float2 slope = (float2(dot(_e14, x_axis), dot(_e14, y_axis)) / (widths * n_h));
    const float _e28 = exp2_stable((-1.442695 * min(dot(slope, slope), 200.0)));
    return ((n_l * _e28) / (widths.y * sqrt(max((n_l * n_v), 1e-6))));
}

float reflectance_ward(Light light_2, float3 normal_3, float3 view_2, float3 tangent_1, float roughness, float across)
{
    const float3x3 _e8 = world_from_tangent(tangent_1, (0.0).xxx, normal_3);
    float2 widths_1 = float2(0.25, (across * across));
    const float _e16 = ward(light_2.direction, _e8[2], view_2, _e8[0], _e8[1], widths_1);
    return _e16;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float lambert = max(dot(surface.normal, _e5), 0.0);
    float4 body = float4((float3(0.098, 0.1059, 0.1333) + (lambert * float3(0.3529, 0.3961, 0.4392))), 1.0);
    Light _e23 = look.key;
    const float _e29 = reflectance_ward(_e23, surface.normal, surface.view, surface.tangent, 0.5, 0.2);
    float4 highlight = clamp(float4((body.xyz + (0.55 * ((body.xyz + (_e29 * float3(0.9569, 0.9412, 0.902))) - body.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return highlight;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2, float4 arg3) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.normal = arg2;
    ret.tangent = arg3;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_3.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    float4x4 _e20 = object.world_from_object;
    float3x3 _e34 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15), float4(mul(float4(vertex.tangent.xyz, 0.0), _e20).xyz, ((determinant(_e34) < 0.0) ? -(vertex.tangent.w) : vertex.tangent.w)));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.tangent, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.tangent = arg2;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_5, fragmentinput_fs_main.tangent_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_6 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_3.eye;
    float _e13 = view_3.eye.w;
    const float3 _e27 = normalize_moderate((in_.tangent.xyz - (normal_6 * dot(normal_6, in_.tangent.xyz))), (0.0).xxx);
    Surface surface_1 = ConstructSurface(normal_6, normalize((_e8.xyz - (_e13 * in_.position))), _e27);
    const float4 _e29 = shade(surface_1);
    return _e29;
}
