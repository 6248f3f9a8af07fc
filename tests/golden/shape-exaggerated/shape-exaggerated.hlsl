// Exaggerated shape: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, smooth_normal_1_map t0, smooth_normal_2_map t1, smooth_normal_3_map t2, smooth_normal_4_map t3.
// shape-exaggerated.json says what to put there and how to draw.
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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 smooth_normal_1_;
    int _pad3_0;
    float3 smooth_normal_2_;
    int _pad4_0;
    float3 smooth_normal_3_;
    int _pad5_0;
    float3 smooth_normal_4_;
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
static const Ramp from_dusk_to_sun = ConstructRamp(Constructarray16_float4_(float4(0.1373, 0.1647, 0.302, 1.0), float4(0.4196, 0.3725, 0.5255, 1.0), float4(0.7882, 0.5804, 0.4353, 1.0), float4(0.9412, 0.8039, 0.5725, 1.0), float4(1.0, 0.9843, 0.902, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.05, 0.35, 0.55, 0.75), float4(0.98, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> smooth_normal_1_map : register(t0);
Texture2D<float4> smooth_normal_2_map : register(t1);
Texture2D<float4> smooth_normal_3_map : register(t2);
Texture2D<float4> smooth_normal_4_map : register(t3);

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

float exp2_stable(float x)
{
    float whole = round(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * 0.5);
}

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float bounded(float x_1)
{
    uint bits = asuint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
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

float3 srgb_of_oklab(float3 lab_1)
{
    const float3 _e1 = linear_of_oklab(lab_1);
    const float _e3 = srgb_of_linear(_e1.x);
    const float _e5 = srgb_of_linear(_e1.y);
    const float _e7 = srgb_of_linear(_e1.z);
    return float3(_e3, _e5, _e7);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
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

RampPlace ramp_place(Ramp ramp, float x_3)
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
            uint _e27 = i;
            i = (_e27 + 1u);
        }
        loop_init = false;
        uint _e10 = i;
        if (!((_e10 < 5u))) {
            break;
        }
        uint _e14 = at;
        uint _e15 = i;
        uint _e16 = i;
        uint _e20 = i;
        float _e24 = places[min(uint(naga_div(_e16, 4u)), 3u)][min(uint(naga_mod(_e20, 4u)), 3u)];
        at = ((_e24 <= x_3) ? _e15 : _e14);
    }
    uint _e30 = at;
    uint after = min((_e30 + 1u), 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places[min(uint(naga_div(_e35, 4u)), 3u)][min(uint(naga_mod(_e39, 4u)), 3u)];
    float _e51 = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)];
    const float _e53 = divided((x_3 - place), (_e51 - place));
    float t = clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    float4 _e59 = colors[min(uint(_e57), 15u)];
    float4 _e61 = colors[min(uint(after), 15u)];
    const RampPlace rampplace = ConstructRampPlace(_e59, _e61, t);
    return rampplace;
}

float4 ramp_oklab(float value, Ramp ramp_1)
{
    const RampPlace _e2 = ramp_place(ramp_1, value);
    const float3 _e5 = oklab_of_srgb(_e2.before.xyz);
    const float3 _e8 = oklab_of_srgb(_e2.after.xyz);
    const float3 _e11 = srgb_of_oklab(lerp(_e5, _e8, _e2.t));
    return ((_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : float4(_e11, 1.0)));
}

float detail_lit(float3 finer, float3 coarser, float3 light_1, float contrast)
{
    float3 across = (light_1 - (dot(light_1, coarser) * coarser));
    float3 toward = (across / (max(length(across), 0.05)).xxx);
    return clamp((contrast * dot(finer, toward)), -1.0, 1.0);
}

float exaggerated_four(Light light_2, float3 normal, float contrast_1, float detail, float3 smooth_1_, float3 smooth_2_, float3 smooth_3_, float3 smooth_4_)
{
    const float _e9 = exp2_stable(-(detail));
    const float3 _e10 = normalize_moderate(smooth_1_, normal);
    const float3 _e11 = normalize_moderate(smooth_2_, _e10);
    const float3 _e12 = normalize_moderate(smooth_3_, _e11);
    const float3 _e13 = normalize_moderate(smooth_4_, _e12);
    const float _e15 = detail_lit(_e11, _e12, light_2.direction, contrast_1);
    const float _e17 = detail_lit(_e12, _e13, light_2.direction, contrast_1);
    float coarse = (_e15 + (_e9 * (_e17 + (_e9 * dot(_e13, light_2.direction)))));
    const float _e25 = detail_lit(normal, _e10, light_2.direction, contrast_1);
    const float _e27 = detail_lit(_e10, _e11, light_2.direction, contrast_1);
    float sum = (_e25 + (_e9 * (_e27 + (_e9 * coarse))));
    return clamp((0.5 + ((0.5 * sum) / (1.0 + (_e9 * (1.0 + (_e9 * (1.0 + (_e9 * (1.0 + _e9))))))))), 0.0, 1.0);
}

float outer_contour(float width, float3 normal_1, float3 view, float2 viewport)
{
    float facing = clamp(dot(normal_1, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport.y, 1.0, 100000.0)) / 1000.0);
    const float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

float4 shade(Surface surface)
{
    Light _e3 = look.key;
    const float _e11 = exaggerated_four(_e3, surface.normal, 7.0, 0.1, surface.smooth_normal_1_, surface.smooth_normal_2_, surface.smooth_normal_3_, surface.smooth_normal_4_);
    const float4 _e13 = ramp_oklab(_e11, from_dusk_to_sun);
    float2 _e19 = look.viewport;
    const float _e20 = outer_contour(3.0, surface.normal, surface.view, _e19);
    float4 inked = lerp(_e13, float4(0.098, 0.1059, 0.2, 1.0), _e20);
    return inked;
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

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float3 arg4, float3 arg5) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.smooth_normal_1_ = arg2;
    ret.smooth_normal_2_ = arg3;
    ret.smooth_normal_3_ = arg4;
    ret.smooth_normal_4_ = arg5;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e23 = smooth_normal_1_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e29 = view_1.camera_from_world;
    float4 _e37 = smooth_normal_2_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e43 = view_1.camera_from_world;
    float4 _e51 = smooth_normal_3_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e57 = view_1.camera_from_world;
    float4 _e65 = smooth_normal_4_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e71 = view_1.camera_from_world;
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), mul(_e29, float4(_e23.xyz, 0.0)).xyz, mul(_e43, float4(_e37.xyz, 0.0)).xyz, mul(_e57, float4(_e51.xyz, 0.0)).xyz, mul(_e71, float4(_e65.xyz, 0.0)).xyz);
    const float4 _e75 = shade(surface_1);
    return _e75;
}
