// Light that wraps: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_3 b0, object b1, look b2.
// material-wrap.json says what to put there and how to draw.
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

static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;

cbuffer view_3 : register(b0) { View view_3; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_4 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_5 : LOC1;
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

float log_stable(float x_3)
{
    uint bits = asuint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent_2 = ((shift >= int(256)) ? asint(asuint(shift) - asuint(int(512))) : shift);
    float mantissa = asfloat((bits - (uint(exponent_2) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_2) * LN_2_) + series);
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
    const float _e8 = log_stable(max((1.0 - y_1), 1.1754944e-38));
    return _e8;
}

float bounded(float x_4)
{
    uint bits_1 = asuint(x_4);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_4 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float powered(float base, float exponent)
{
    bool local_1 = (bool)0;

    const float _e2 = bounded(base);
    const float _e3 = bounded(exponent);
    if ((_e3 == 1.0)) {
        return _e2;
    }
    if ((_e3 == 0.0)) {
        return 1.0;
    }
    if ((_e3 == 2.0)) {
        const float _e12 = bounded((_e2 * _e2));
        return _e12;
    }
    float magnitude_1 = abs(_e2);
    if ((magnitude_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e18 = log_stable(magnitude_1);
    const float _e21 = bounded((_e3 * (LOG2_E * _e18)));
    const float _e22 = exp2_stable(_e21);
    bool is_even = (floor((_e3 * 0.5)) == (_e3 * 0.5));
    if ((_e2 < 0.0)) {
        local_1 = !(is_even);
    } else {
        local_1 = false;
    }
    bool _e36 = local_1;
    return (_e36 ? -(_e22) : _e22);
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

float3 half_of(float3 light, float3 normal, float3 view)
{
    float3 half_ = (light + view);
    const float3 _e8 = normalize_or(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
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

float cosine_power(float cosine, float sine2_, float exponent_1)
{
    if ((cosine < 0.7)) {
        const float _e7 = powered(max(cosine, 0.0), exponent_1);
        return _e7;
    }
    const float _e14 = log1p_negative(min(sine2_, 0.6));
    const float _e16 = exp2_stable((((0.5 * exponent_1) * LOG2_E) * _e14));
    return _e16;
}

float width_of_roughness(float roughness)
{
    const float _e1 = bounded(roughness);
    float r = clamp(_e1, 0.0, 1.0);
    return max((r * r), 0.001);
}

float exponent_of_width(float width)
{
    return max(((2.0 / (width * width)) - 2.0), 0.0);
}

float reflectance_wrap(Light light_2, float3 normal_2, float wrap)
{
    const float _e3 = bounded(wrap);
    float w = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal_2, float3(0.0, 0.0, 1.0));
    float cosine_1 = dot(_e11, light_2.direction);
    return max(((cosine_1 + w) / (1.0 + w)), 0.0);
}

float reflectance_blinn_phong(Light light_3, float3 normal_3, float3 view_2, float roughness_1)
{
    const float3 _e9 = normalize_or(normal_3, float3(0.0, 0.0, 1.0));
    const Reflection _e10 = reflection_of(light_3.direction, _e9, view_2);
    const float _e11 = width_of_roughness(roughness_1);
    const float _e12 = exponent_of_width(_e11);
    const float _e15 = cosine_power(_e10.n_h, _e10.sine2_, _e12);
    return min((((0.125 * (_e12 + 8.0)) * _e15) * max(_e10.n_l, 0.0)), 1000000.0);
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.7);
    const float4 _e19 = blend_add(float4(0.2902, 0.1137, 0.1333, 1.0), float4(0.851, 0.4706, 0.3725, 1.0), _e6, 1.0, true);
    Light _e22 = look.key;
    const float _e26 = reflectance_blinn_phong(_e22, surface_1.normal, surface_1.view, 0.6);
    const float4 _e34 = blend_add(_e19, float4(1.0, 0.8902, 0.8, 1.0), _e26, 0.25, true);
    const float4 _e35 = output(_e34);
    return _e35;
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
    Varyings _e22 = out_;
    const Varyings varyings = _e22;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_6 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_6;
    float4 _e15 = view_3.eye;
    float _e20 = view_3.eye.w;
    float4 _e26 = view_3.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    Surface _e34 = surface;
    const float4 _e35 = shade(_e34);
    const float4 _e36 = finite_vec4_(_e35);
    return _e36;
}
