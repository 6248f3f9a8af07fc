// Lantern: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1.
// lantern.json says what to put there and how to draw.
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
    int _pad1_0;
    float3 view;
    int _end_pad_0;
};

struct Ramp {
    float4 colors[16];
    float4 places[4];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
};

struct RampPlace {
    float4 before;
    float4 after;
    float t;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
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

typedef float4 ret_Constructarray16_float4_[16];
ret_Constructarray16_float4_ Constructarray16_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3, float4 arg4, float4 arg5, float4 arg6, float4 arg7, float4 arg8, float4 arg9, float4 arg10, float4 arg11, float4 arg12, float4 arg13, float4 arg14, float4 arg15) {
    float4 ret[16] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10, arg11, arg12, arg13, arg14, arg15 };
    return ret;
}

typedef float4 ret_Constructarray4_float4_[4];
ret_Constructarray4_float4_ Constructarray4_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3) {
    float4 ret[4] = { arg0, arg1, arg2, arg3 };
    return ret;
}

Ramp ConstructRamp(float4 arg0[16], float4 arg1[4], uint arg2, uint arg3) {
    Ramp ret = (Ramp)0;
    ret.colors = arg0;
    ret.places = arg1;
    ret.count = arg2;
    ret.interpolation = arg3;
    return ret;
}

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp glow = ConstructRamp(Constructarray16_float4_(float4(0.851, 0.4118, 0.1647, 1.0), float4(1.0, 0.7804, 0.3961, 1.0), float4(1.0, 0.9647, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.45, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 3u, 0u);

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

float3 normalize_seen_balanced(float3 v)
{
    return (v * rsqrt(max(dot(v, v), 1e-30)));
}

float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float srgb_of_linear(float light)
{
    float size = abs(light);
    float value_1 = ((size <= 0.0031308) ? (size * 12.92) : ((1.055 * pow(size, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value_1) : value_1);
}

float3 oklab_of_linear(float3 rgb)
{
    float l = pow(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s = pow(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return float3((((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s)), (((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s)), (((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s)));
}

float3 linear_of_oklab(float3 lab)
{
    float l_1 = ((lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z));
    float m_1 = ((lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z));
    float s_1 = ((lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z));
    float3 cubes = float3(((l_1 * l_1) * l_1), ((m_1 * m_1) * m_1), ((s_1 * s_1) * s_1));
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)), dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)), dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

float3 oklab_of_srgb(float3 coded)
{
    const float3 _e23 = oklab_of_linear(float3(pow(((coded.x + 0.055) / 1.055), 2.4), pow(((coded.y + 0.055) / 1.055), 2.4), pow(((coded.z + 0.055) / 1.055), 2.4)));
    return _e23;
}

float3 oklab_of_srgb_2_(float3 coded_1)
{
    const float3 _e17 = oklab_of_linear(float3(1.0, pow(((coded_1.y + 0.055) / 1.055), 2.4), pow(((coded_1.z + 0.055) / 1.055), 2.4)));
    return _e17;
}

float3 srgb_of_oklab(float3 lab_1)
{
    const float3 _e1 = linear_of_oklab(lab_1);
    const float _e3 = srgb_of_linear(_e1.x);
    const float _e5 = srgb_of_linear(_e1.y);
    const float _e7 = srgb_of_linear(_e1.z);
    return float3(_e3, _e5, _e7);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

RampPlace ConstructRampPlace(float4 arg0, float4 arg1, float arg2) {
    RampPlace ret = (RampPlace)0;
    ret.before = arg0;
    ret.after = arg1;
    ret.t = arg2;
    return ret;
}

RampPlace ramp_place(Ramp ramp, float x_1)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    uint i = 1u;
    uint at = 0u;

    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e24 = i;
            i = (_e24 + 1u);
        }
        loop_init = false;
        uint _e10 = i;
        if (!((_e10 < 3u))) {
            break;
        }
        uint _e14 = at;
        uint _e15 = i;
        uint _e17 = i;
        float _e21 = places[0][min(uint(naga_mod(_e17, 4u)), 3u)];
        at = ((_e21 <= x_1) ? _e15 : _e14);
    }
    uint _e27 = at;
    uint after = min((_e27 + 1u), 2u);
    uint _e33 = at;
    float place = places[0][min(uint(naga_mod(_e33, 4u)), 3u)];
    float _e43 = places[0][min(uint(naga_mod(after, 4u)), 3u)];
    const float _e45 = divided((x_1 - place), (_e43 - place));
    float t = clamp(_e45, 0.0, 1.0);
    uint _e49 = at;
    float4 _e51 = colors[min(uint(_e49), 15u)];
    float4 _e53 = colors[min(uint(after), 15u)];
    const RampPlace rampplace = ConstructRampPlace(_e51, _e53, t);
    return rampplace;
}

float4 ramp_oklab(float value, Ramp ramp_1)
{
    const RampPlace _e2 = ramp_place(ramp_1, value);
    const float3 _e5 = oklab_of_srgb(_e2.before.xyz);
    const float3 _e8 = oklab_of_srgb_2_(_e2.after.xyz);
    const float3 _e11 = srgb_of_oklab(lerp(_e5, _e8, _e2.t));
    return ((_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : float4(_e11, 1.0)));
}

float4 shade(Surface surface)
{
    const float4 _e8 = ramp_oklab(clamp(dot(surface.normal, surface.view), 0.0, 1.0), glow);
    return _e8;
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

Surface ConstructSurface(float3 arg0, float3 arg1) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view.eye;
    float _e13 = view.eye.w;
    Surface surface_1 = ConstructSurface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))));
    const float4 _e19 = shade(surface_1);
    return _e19;
}
