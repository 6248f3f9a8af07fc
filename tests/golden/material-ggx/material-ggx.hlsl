// Cook-Torrance, GGX: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2.
// material-ggx.json says what to put there and how to draw.
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

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
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

float schlick(float at_normal, float cosine)
{
    float m = (1.0 - cosine);
    float m2_ = (m * m);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m)));
}

float ggx(Reflection r, float width, float at_normal_1)
{
    if (((r.n_l <= 0.0) | (r.n_v <= 0.0))) {
        return 0.0;
    }
    float a2_ = (width * width);
    float bottom = max((r.sine2_ + ((a2_ * r.n_h) * r.n_h)), 1e-12);
    float distribution = (a2_ / (bottom * bottom));
    float toward_light = (r.n_v * sqrt((((r.n_l * r.n_l) * (1.0 - a2_)) + a2_)));
    float toward_eye = (r.n_l * sqrt((((r.n_v * r.n_v) * (1.0 - a2_)) + a2_)));
    float visibility = (0.5 / max((toward_light + toward_eye), 1e-9));
    const float _e49 = schlick(at_normal_1, r.v_h);
    return min((((distribution * visibility) * _e49) * r.n_l), 1000000.0);
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float lambert = max(dot(surface.normal, _e5), 0.0);
    float4 body = float4((float3(0.0784, 0.0863, 0.1098) + (lambert * float3(0.2353, 0.2667, 0.3137))), 1.0);
    float3 _e24 = look.key.direction;
    const Reflection _e27 = reflection_of(_e24, surface.normal, surface.view);
    const float _e30 = ggx(_e27, 0.1764, 0.85);
    float4 highlight = clamp(float4((body.xyz + (0.5 * ((body.xyz + (_e30 * float3(0.9098, 0.9333, 0.9647))) - body.xyz))), 1.0), (0.0).xxxx, (1.0).xxxx);
    return highlight;
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
    float4x4 _e10 = view_2.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    return _e19;
}
