// Clay relief: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0, curvature_tensor_map t1.
// clay-relief.json says what to put there and how to draw.
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
    Light sky;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    float kappa;
    float3 curvature_tensor;
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

struct Relief {
    float shape;
    float strength;
    float greatest;
    float least;
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

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp terracotta = ConstructRamp(Constructarray16_float4_(float4(0.2353, 0.102, 0.1098, 1.0), float4(0.5412, 0.251, 0.1882, 1.0), float4(0.8118, 0.498, 0.3412, 1.0), float4(0.949, 0.7412, 0.5725, 1.0), float4(0.9843, 0.8627, 0.7333, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.3, 0.62, 0.9), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 0u);
static const Ramp pits_to_bumps = ConstructRamp(Constructarray16_float4_(float4(0.2941, 0.2275, 0.3216, 1.0), float4(0.4784, 0.2902, 0.2902, 1.0), float4(0.7529, 0.502, 0.3765, 1.0), float4(0.9412, 0.7529, 0.5804, 1.0), float4(1.0, 0.9412, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.3, 0.5, 0.75), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 0u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);
Texture2D<float4> curvature_tensor_map : register(t1);

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

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x)
{
    float clamped = clamp(x, -126.0, 127.99999);
    float whole = round(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_2_(float x_1)
{
    float clamped_1 = max(x_1, -126.0);
    float whole_1 = round(clamped_1);
    float f_1 = (clamped_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
}

float3 normalize_seen_balanced(float3 v)
{
    return (v * rsqrt(max(dot(v, v), 1e-30)));
}

float atan2_positive(float y, float x_2)
{
    float small = min(y, x_2);
    float large = max(y, x_2);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t = (small / large);
    bool is_wide = (t > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_3 = (is_wide ? (series + 0.7853982) : series);
    return ((y > x_2) ? (HALF_PI - a_3) : a_3);
}

float bounded(float x_3)
{
    uint bits = asuint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float2 bounded_vec2_(float2 v_1)
{
    uint2 bits_1 = asuint(v_1);
    uint2 magnitude_1 = (bits_1 & (2147483647u).xx);
    float2 largest_1 = asfloat(((bits_1 & (2147483648u).xx) | (2139095039u).xx));
    float2 numbers = ((magnitude_1 == (2139095040u).xx) ? largest_1 : (0.0).xx);
    return ((magnitude_1 < (2139095040u).xx) ? v_1 : numbers);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float angle_of_point(float y_1, float x_4)
{
    const float2 _e3 = bounded_vec2_(float2(x_4, y_1));
    float2 p = abs(_e3);
    float2 scaled = ((max(p.x, p.y) > 1.0) ? (0.5 * p) : p);
    const float _e15 = atan2_positive(scaled.y, scaled.x);
    float turned = ((x_4 < 0.0) ? (PI - _e15) : _e15);
    return ((y_1 < 0.0) ? -(turned) : turned);
}

float footprint_of(float x_5)
{
    float _e1 = ddx(x_5);
    float _e2 = ddy(x_5);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float srgb_of_linear(float light)
{
    float size = abs(light);
    float value_1 = ((size <= 0.0031308) ? (size * 12.92) : ((1.055 * pow(size, 0.41666666)) - 0.055));
    return ((light < 0.0) ? -(value_1) : value_1);
}

float soft_light(float a_1, float b_1)
{
    if ((b_1 <= 0.5)) {
        return (a_1 - (((1.0 - (2.0 * b_1)) * a_1) * (1.0 - a_1)));
    }
    float curved_1 = ((a_1 <= 0.25) ? (((((16.0 * a_1) - 12.0) * a_1) + 4.0) * a_1) : sqrt(max(a_1, 0.0)));
    return (a_1 + (((2.0 * b_1) - 1.0) * (curved_1 - a_1)));
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

RampPlace ramp_place(Ramp ramp, float x_6)
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
        at = ((_e24 <= x_6) ? _e15 : _e14);
    }
    uint _e30 = at;
    uint after = min((_e30 + 1u), 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places[min(uint(naga_div(_e35, 4u)), 3u)][min(uint(naga_mod(_e39, 4u)), 3u)];
    float _e51 = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)];
    const float _e53 = divided((x_6 - place), (_e51 - place));
    float t_1 = clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    float4 _e59 = colors[min(uint(_e57), 15u)];
    float4 _e61 = colors[min(uint(after), 15u)];
    const RampPlace rampplace = ConstructRampPlace(_e59, _e61, t_1);
    return rampplace;
}

float4 mix_colors_screen(float4 a_2, float4 b_2, float factor)
{
    return float4(lerp(a_2.xyz, ((a_2.xyz + b_2.xyz) - (a_2.xyz * b_2.xyz)), factor), 1.0);
}

float curvature_signed(float kappa, float slope)
{
    float a_4 = (kappa * slope);
    float magnitude_2 = min(abs(a_4), 50.0);
    if ((magnitude_2 < 0.0625)) {
        float a2_ = (a_4 * a_4);
        return (a_4 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e22 = exp2_stable_2_((-2.88539 * magnitude_2));
    float t_2 = ((1.0 - _e22) / (1.0 + _e22));
    return ((a_4 >= 0.0) ? t_2 : -(t_2));
}

float curvature_signed_2_(float kappa_1, float slope_1)
{
    float a_5 = (min(kappa_1, 10000.0) * slope_1);
    float magnitude_3 = min(a_5, 50.0);
    if ((magnitude_3 < 0.0625)) {
        float a2_1 = (a_5 * a_5);
        return (a_5 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254)))))));
    }
    const float _e23 = exp2_stable_2_((-2.88539 * magnitude_3));
    float t_3 = ((1.0 - _e23) / (1.0 + _e23));
    return t_3;
}

float2 principal_curvatures(float3 tensor)
{
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(float2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    const float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? float2(far, _e26) : float2(_e26, far));
}

float4 ramp_oklab(float value, Ramp ramp_1)
{
    const RampPlace _e2 = ramp_place(ramp_1, value);
    const float3 _e5 = oklab_of_srgb(_e2.before.xyz);
    const float3 _e8 = oklab_of_srgb(_e2.after.xyz);
    const float3 _e11 = srgb_of_oklab(lerp(_e5, _e8, _e2.t));
    return ((_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : float4(_e11, 1.0)));
}

float reflectance_half_lambert(Light light_1, float3 normal)
{
    float half_ = (0.5 + (0.5 * dot(normal, light_1.direction)));
    return min((half_ * half_), 1.0);
}

float rim(Light light_2, float3 normal_1, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal_1, view), 0.0, 1.0);
    const float _e11 = footprint_of(facing);
    float edge = max((width * softness), min(_e11, 1.0));
    float3 aside = (normal_1 - view);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - width)) : (width - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    float3 across = (light_2.direction - (dot(light_2.direction, view) * view));
    float side = dot((normal_1 - (dot(normal_1, view) * view)), (across * rsqrt(max(dot(across, across), 1e-30))));
    return (inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow));
}

float radiance_scaled(float tone, float curved, float turning)
{
    const float _e5 = exp2_stable((curved * LOG2_E));
    float dark = (turning * (1.0 - tone));
    float light_3 = (tone * (1.0 - turning));
    return ((tone * ((_e5 * dark) + light_3)) / max((dark + (_e5 * light_3)), 1e-20));
}

float radiance_scaling(float tone_1, float kappa_2, float amount, float slope_2, float turning_1)
{
    const float _e5 = curvature_signed(kappa_2, slope_2);
    float curved_2 = (amount * _e5);
    const float _e7 = radiance_scaled(tone_1, curved_2, turning_1);
    return min(((curved_2 == 0.0) ? tone_1 : _e7), 1.0);
}

Relief ConstructRelief(float arg0, float arg1, float arg2, float arg3) {
    Relief ret = (Relief)0;
    ret.shape = arg0;
    ret.strength = arg1;
    ret.greatest = arg2;
    ret.least = arg3;
    return ret;
}

Relief relief(float3 tensor_1, float slope_3)
{
    const float2 _e2 = principal_curvatures(tensor_1);
    const float _e9 = angle_of_point((_e2.x + _e2.y), (_e2.x - _e2.y));
    float curvedness = sqrt((0.5 * dot(_e2, _e2)));
    const float _e14 = curvature_signed_2_(curvedness, slope_3);
    const Relief relief_1 = ConstructRelief((0.5 + (_e9 / PI)), _e14, _e2.x, _e2.y);
    return relief_1;
}

float4 shade(Surface surface)
{
    Light _e3 = look.key;
    const float _e5 = reflectance_half_lambert(_e3, surface.normal);
    const float _e10 = radiance_scaling(_e5, surface.kappa, 1.3, 0.03, 0.9);
    const float4 _e12 = ramp_oklab(_e10, terracotta);
    const Relief _e15 = relief(surface.curvature_tensor, 0.025);
    const float4 _e18 = ramp_oklab(_e15.shape, pits_to_bumps);
    const float _e22 = soft_light(_e12.x, _e18.x);
    const float _e25 = soft_light(_e12.y, _e18.y);
    const float _e28 = soft_light(_e12.z, _e18.z);
    float4 slip_in_the_hollows = float4(lerp(_e12.xyz, float3(_e22, _e25, _e28), clamp(_e15.strength, 0.0, 1.0)), 1.0);
    Light _e39 = look.sky;
    const float _e45 = rim(_e39, surface.normal, surface.view, 0.4, 0.9, 1.0);
    const float4 _e51 = mix_colors_screen(slip_in_the_hollows, float4(0.3725, 0.498, 0.6588, 1.0), _e45);
    return _e51;
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

Surface ConstructSurface(float3 arg0, float3 arg1, float arg2, float3 arg3) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.kappa = arg2;
    ret.curvature_tensor = arg3;
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
    float4 _e23 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e30 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x, _e30.xyz);
    const float4 _e33 = shade(surface_1);
    return _e33;
}
