// Warped light: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_5 b0, object b1, look b2, curvature_tensor_map t0.
// warped-light.json says what to put there and how to draw.
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
    Light back;
    Light key;
    row_major float3x3 camera_from_world;
    int _end_pad_0;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
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
static const Ramp jade = ConstructRamp(Constructarray16_float4_(float4(0.0157, 0.1294, 0.1216, 1.0), float4(0.0588, 0.3529, 0.298, 1.0), float4(0.2471, 0.6275, 0.4784, 1.0), float4(0.7137, 0.8784, 0.6902, 1.0), float4(0.9333, 0.9725, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.35, 0.65, 0.9), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 0u);

cbuffer view_5 : register(b0) { View view_5; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

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
    float clamped = clamp(x_1, -126.0, 127.99999);
    float whole = round(clamped);
    float f = (clamped - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float exp2_stable_2_(float x_2)
{
    float clamped_1 = max(x_2, -126.0);
    float whole_1 = round(clamped_1);
    float f_1 = (clamped_1 - whole_1);
    float twice_1 = (2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724))))))))))));
    return (twice_1 * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
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

float bounded(float x_3)
{
    uint bits = asuint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_4)
{
    float _e1 = ddx(x_4);
    float _e2 = ddy(x_4);
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
    const float3 _e30 = oklab_of_linear(float3(((coded.x <= 0.04045) ? (coded.x / 12.92) : pow(((coded.x + 0.055) / 1.055), 2.4)), pow(((coded.y + 0.055) / 1.055), 2.4), pow(((coded.z + 0.055) / 1.055), 2.4)));
    return _e30;
}

float3 oklab_of_srgb_2_(float3 coded_1)
{
    const float3 _e23 = oklab_of_linear(float3(pow(((coded_1.x + 0.055) / 1.055), 2.4), pow(((coded_1.y + 0.055) / 1.055), 2.4), pow(((coded_1.z + 0.055) / 1.055), 2.4)));
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

RampPlace ramp_place(Ramp ramp, float x_5)
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
        at = ((_e24 <= x_5) ? _e15 : _e14);
    }
    uint _e30 = at;
    uint after = min((_e30 + 1u), 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place_1 = places[min(uint(naga_div(_e35, 4u)), 3u)][min(uint(naga_mod(_e39, 4u)), 3u)];
    float _e51 = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)];
    const float _e53 = divided((x_5 - place_1), (_e51 - place_1));
    float t = clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    float4 _e59 = colors[min(uint(_e57), 15u)];
    float4 _e61 = colors[min(uint(after), 15u)];
    const RampPlace rampplace = ConstructRampPlace(_e59, _e61, t);
    return rampplace;
}

float4 mix_colors_screen(float4 a_1, float4 b_1, float factor)
{
    return float4(lerp(a_1.xyz, ((a_1.xyz + b_1.xyz) - (a_1.xyz * b_1.xyz)), min(factor, 1.0)), 1.0);
}

float4 mix_colors_screen_2_(float4 a_2, float4 b_2, float factor_1)
{
    return float4(lerp(a_2.xyz, ((a_2.xyz + b_2.xyz) - (a_2.xyz * b_2.xyz)), factor_1), 1.0);
}

float curvature_signed(float kappa, float slope)
{
    float a_4 = (clamp(kappa, -10000.0, 10000.0) * slope);
    float magnitude_1 = min(abs(a_4), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_4 * a_4);
        return (a_4 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e25 = exp2_stable_2_((-2.88539 * magnitude_1));
    float t_1 = ((1.0 - _e25) / (1.0 + _e25));
    return ((a_4 >= 0.0) ? t_1 : -(t_1));
}

float2 principal_curvatures(float3 tensor)
{
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(float2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    const float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? float2(far, _e26) : float2(_e26, far));
}

float3 half_of(float3 light_1, float3 normal, float3 view)
{
    float3 half_ = (light_1 + view);
    const float3 _e8 = normalize_moderate(((dot(half_, half_) > 1e-12) ? half_ : normal), normal);
    return _e8;
}

float sine_squared(float3 a_3, float3 b_3)
{
    float3 across = cross(a_3, b_3);
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

Reflection reflection_of(float3 light_2, float3 normal_1, float3 view_1)
{
    const float3 _e3 = half_of(light_2, normal_1, view_1);
    float n_h = clamp(dot(normal_1, _e3), 0.0, 1.0);
    float v_h = clamp(dot(view_1, _e3), 0.0, 1.0);
    const float _e14 = sine_squared(normal_1, _e3);
    const Reflection reflection = ConstructReflection(dot(normal_1, light_2), dot(normal_1, view_1), n_h, v_h, _e14);
    return reflection;
}

float schlick(float at_normal, float cosine)
{
    float m_2 = (1.0 - cosine);
    float m2_ = (m_2 * m_2);
    return (at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m_2)));
}

float ggx(Reflection r, float width, float at_normal_1)
{
    if (((r.n_l <= 0.0) | (r.n_v <= 0.0))) {
        return 0.0;
    }
    float a2_1 = (width * width);
    float bottom = max((r.sine2_ + ((a2_1 * r.n_h) * r.n_h)), 1e-12);
    float distribution = (a2_1 / (bottom * bottom));
    float toward_light = (r.n_v * sqrt((((r.n_l * r.n_l) * (1.0 - a2_1)) + a2_1)));
    float toward_eye = (r.n_l * sqrt((((r.n_v * r.n_v) * (1.0 - a2_1)) + a2_1)));
    float visibility = (0.5 / max((toward_light + toward_eye), 1e-9));
    const float _e49 = schlick(at_normal_1, r.v_h);
    return min((((distribution * visibility) * _e49) * r.n_l), 1000000.0);
}

float4 ramp_oklab(float value, Ramp ramp_1)
{
    const RampPlace _e2 = ramp_place(ramp_1, value);
    const float3 _e5 = oklab_of_srgb(_e2.before.xyz);
    const float3 _e8 = oklab_of_srgb_2_(_e2.after.xyz);
    const float3 _e11 = srgb_of_oklab(lerp(_e5, _e8, _e2.t));
    return ((_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : float4(_e11, 1.0)));
}

float rim(Light light_3, float3 normal_2, float3 view_2, float width_1, float softness, float follow)
{
    float facing = clamp(dot(normal_2, view_2), 0.0, 1.0);
    const float _e11 = footprint_of(facing);
    float edge = max((width_1 * softness), min(_e11, 1.0));
    float3 aside = (normal_2 - view_2);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - 0.5) : (width_1 - facing));
    float within = ((further / edge) + 0.0);
    float inside = clamp(within, 0.0, 1.0);
    float3 across_1 = (light_3.direction - (dot(light_3.direction, view_2) * view_2));
    float side = dot((normal_2 - (dot(normal_2, view_2) * view_2)), (across_1 * rsqrt(max(dot(across_1, across_1), 1e-30))));
    return (inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow));
}

float2 warped_place(float3 tensor_1, float2 place, float amount, float slope_1)
{
    const float2 _e4 = principal_curvatures(tensor_1);
    const float _e7 = curvature_signed(_e4.x, slope_1);
    const float _e9 = exp2_stable((-(amount) * _e7));
    const float _e12 = curvature_signed(_e4.y, slope_1);
    const float _e14 = exp2_stable((-(amount) * _e12));
    float2 half_apart = float2((0.5 * (tensor_1.x - tensor_1.z)), tensor_1.y);
    float2 axes = (half_apart / (max(length(half_apart), 1e-20)).xx);
    float2 turned = float2(((axes.x * place.x) + (axes.y * place.y)), ((axes.y * place.x) - (axes.x * place.y)));
    return (((0.5 * (_e9 + _e14)) * place) + ((0.5 * (_e9 - _e14)) * turned));
}

float3 warped_light(float3 light_4, float3 n, float3 view_3, float3x3 camera_from_world, float3 tensor_2, float amount_1, float slope_2)
{
    float3 right = mul(camera_from_world, float3(1.0, 0.0, 0.0));
    const float3 _e19 = normalize_moderate((right - (dot(right, view_3) * view_3)), float3(1.0, 0.0, 0.0));
    float3 y = cross(view_3, _e19);
    float3 between = ((view_3 + n) / (max((1.0 + dot(view_3, n)), 0.01)).xxx);
    float3 along_x = (_e19 - (dot(n, _e19) * between));
    float3 along_y = (y - (dot(n, y) * between));
    float2 place_2 = (float2(dot(light_4, along_x), dot(light_4, along_y)) / (max((1.0 + dot(light_4, n)), 0.0001)).xx);
    const float2 _e45 = warped_place(tensor_2, place_2, amount_1, slope_2);
    float square_2 = dot(_e45, _e45);
    const float3 _e60 = normalize_or(((((2.0 * _e45.x) * along_x) + ((2.0 * _e45.y) * along_y)) + ((1.0 - square_2) * n)), light_4);
    return _e60;
}

Light ConstructLight(float3 arg0, float3 arg1, float3 arg2, float arg3) {
    Light ret = (Light)0;
    ret.direction = arg0;
    ret.own_direction = arg1;
    ret.color = arg2;
    ret.intensity = arg3;
    return ret;
}

Light light_warp(Light light_5, float3 normal_3, float amount_2, float slope_3, float3 tensor_3, float3 view_4, float3x3 camera_from_world_1)
{
    float most = (amount_2 * smoothstep(0.05, 0.3, dot(normal_3, view_4)));
    const float3 _e13 = warped_light(light_5.direction, normal_3, view_4, camera_from_world_1, tensor_3, most, slope_3);
    bool is_flat = ((most == 0.0) | false);
    const Light light_6 = ConstructLight((is_flat ? light_5.direction : _e13), light_5.own_direction, light_5.color, light_5.intensity);
    return light_6;
}

float4 shade(Surface surface)
{
    Light _e3 = look.key;
    float3x3 _e11 = look.camera_from_world;
    const Light _e12 = light_warp(_e3, surface.normal, 1.4, 0.03, surface.curvature_tensor, surface.view, _e11);
    float through_the_stone = max(((dot(surface.normal, _e12.direction) + 0.6) / 1.6), 0.0);
    const float4 _e23 = ramp_oklab(through_the_stone, jade);
    const Reflection _e27 = reflection_of(_e12.direction, surface.normal, surface.view);
    const float _e30 = ggx(_e27, 0.1764, 0.09);
    const float4 _e36 = mix_colors_screen(_e23, float4(1.0, 0.9569, 0.8627, 1.0), _e30);
    Light _e39 = look.back;
    const float _e45 = rim(_e39, surface.normal, surface.view, 0.5, 0.8, 1.0);
    const float4 _e51 = mix_colors_screen_2_(_e36, float4(0.1843, 0.5608, 0.7216, 1.0), _e45);
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
    float4x4 _e10 = view_5.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.curvature_tensor = arg2;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_6 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_5.eye;
    float _e13 = view_5.eye.w;
    float4 _e23 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    Surface surface_1 = ConstructSurface(normal_6, normalize((_e8.xyz - (_e13 * in_.position))), _e23.xyz);
    const float4 _e26 = shade(surface_1);
    return _e26;
}
