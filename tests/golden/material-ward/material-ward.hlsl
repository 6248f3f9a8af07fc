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

static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;

cbuffer view_3 : register(b0) { View view_3; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_5 : LOC1;
    float4 tangent_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_6 : LOC1;
    float4 tangent_3 : LOC2;
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

float power_of_two(int n)
{
    return asfloat((uint(asint(asuint(n) + asuint(int(127)))) << 23u));
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x_2)
{
    float clamped_2 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_2);
    float f = ((clamped_2 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p * _e33) * _e37);
}

float bounded(float x_3)
{
    uint bits = asuint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float3 any_orthogonal(float3 n_1)
{
    float sign_ = ((n_1.z >= 0.0) ? 1.0 : -1.0);
    float a = (-1.0 / (sign_ + n_1.z));
    return float3((1.0 + (((sign_ * n_1.x) * n_1.x) * a)), (((sign_ * n_1.x) * n_1.y) * a), (-(sign_) * n_1.x));
}

float3x3 world_from_tangent(float3 tangent, float3 bitangent, float3 normal)
{
    const float3 _e7 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const float3 _e10 = normalize_or(tangent, (0.0).xxx);
    float3 leaning = (_e10 - (dot(_e10, _e7) * _e7));
    bool is_usable = (dot(leaning, leaning) > 1e-8);
    const float3 _e17 = any_orthogonal(_e7);
    const float3 _e23 = normalize_or((is_usable ? leaning : _e17), float3(1.0, 0.0, 0.0));
    const float3 _e31 = normalize_or((_e23 - (dot(_e23, _e7) * _e7)), float3(1.0, 0.0, 0.0));
    float3 b = cross(_e7, _e31);
    return float3x3(_e31, ((dot(b, bitangent) < 0.0) ? -(b) : b), _e7);
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

float3 half_of(float3 light, float3 normal_1, float3 view)
{
    float3 half_ = (light + view);
    const float3 _e8 = normalize_or(((dot(half_, half_) > 1e-12) ? half_ : normal_1), normal_1);
    return _e8;
}

float width_of_roughness(float roughness)
{
    const float _e1 = bounded(roughness);
    float r = clamp(_e1, 0.0, 1.0);
    return max((r * r), 0.001);
}

float ward(float3 light_1, float3 normal_2, float3 view_1, float3 x_axis, float3 y_axis, float2 widths)
{
    bool local_1 = (bool)0;

    float n_l = dot(normal_2, light_1);
    float n_v = dot(normal_2, view_1);
    if (!((n_l <= 0.0))) {
        local_1 = (n_v <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e16 = local_1;
    if (_e16) {
        return 0.0;
    }
    const float3 _e18 = half_of(light_1, normal_2, view_1);
    float n_h = max(dot(normal_2, _e18), 1e-6);
    float2 slope = (float2(dot(_e18, x_axis), dot(_e18, y_axis)) / (widths * n_h));
    const float _e32 = exp2_stable((-1.442695 * min(dot(slope, slope), 200.0)));
    return min(((n_l * _e32) / (((4.0 * widths.x) * widths.y) * sqrt(max((n_l * n_v), 1e-6)))), 1000000.0);
}

float reflectance_lambert(Light light_2, float3 normal_3)
{
    const float3 _e6 = normalize_or(normal_3, float3(0.0, 0.0, 1.0));
    return max(dot(_e6, light_2.direction), 0.0);
}

float reflectance_ward(Light light_3, float3 normal_4, float3 view_2, float3 tangent_1, float roughness_1, float across)
{
    const float3x3 _e8 = world_from_tangent(tangent_1, (0.0).xxx, normal_4);
    const float _e9 = width_of_roughness(roughness_1);
    const float _e10 = width_of_roughness(across);
    float2 widths_1 = max(float2(_e9, _e10), (0.0025).xx);
    const float _e19 = ward(light_3.direction, _e8[2], view_2, _e8[0], _e8[1], widths_1);
    return _e19;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e5 = reflectance_lambert(_e3, surface_1.normal);
    const float4 _e18 = blend_add(float4(0.098, 0.1059, 0.1333, 1.0), float4(0.3529, 0.3961, 0.4392, 1.0), _e5, 1.0, true);
    Light _e21 = look.key;
    const float _e27 = reflectance_ward(_e21, surface_1.normal, surface_1.view, surface_1.tangent, 0.5, 0.2);
    const float4 _e35 = blend_add(_e18, float4(0.9569, 0.9412, 0.902, 1.0), _e27, 0.55, true);
    const float4 _e36 = output(_e35);
    return _e36;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_3.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    float4x4 _e25 = object.world_from_object;
    float3x3 _e39 = object.world_from_normal;
    out_.tangent = float4(mul(float4(vertex.tangent.xyz, 0.0), _e25).xyz, ((determinant(_e39) < 0.0) ? -(vertex.tangent.w) : vertex.tangent.w));
    Varyings _e45 = out_;
    const Varyings varyings = _e45;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.tangent, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_6, fragmentinput_fs_main.tangent_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_7 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_7;
    float4 _e15 = view_3.eye;
    float _e20 = view_3.eye.w;
    float4 _e26 = view_3.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    const float3 _e44 = normalize_or((in_.tangent.xyz - (normal_7 * dot(normal_7, in_.tangent.xyz))), in_.tangent.xyz);
    surface.tangent = _e44;
    Surface _e45 = surface;
    const float4 _e46 = shade(_e45);
    const float4 _e47 = finite_vec4_(_e46);
    return _e47;
}
