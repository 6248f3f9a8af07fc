// Warped light: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_5 buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// warped-light.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
};
struct Object {
    metal::float4x4 world_from_object;
    metal::float3x3 world_from_normal;
    float id;
    float cutoff;
    char _pad4[8];
};
struct Light {
    metal::float3 direction;
    metal::float3 own_direction;
    metal::packed_float3 color;
    float intensity;
};
struct Look {
    Light back;
    Light key;
    metal::float3x3 camera_from_world;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 curvature_tensor;
};
typedef metal::float4 Color;
struct type_6 {
    metal::float4 inner[16];
};
struct type_7 {
    metal::float4 inner[4];
};
struct Ramp {
    type_6 colors;
    type_7 places;
    uint count;
    uint interpolation;
    char _pad4[8];
};
struct RampPlace {
    metal::float4 before;
    metal::float4 after;
    float t;
    char _pad3[12];
};
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    float sine2_;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant Ramp jade = Ramp {type_6 {{metal::float4(0.0157, 0.1294, 0.1216, 1.0), metal::float4(0.0588, 0.3529, 0.298, 1.0), metal::float4(0.2471, 0.6275, 0.4784, 1.0), metal::float4(0.7137, 0.8784, 0.6902, 1.0), metal::float4(0.9333, 0.9725, 0.8471, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.35, 0.65, 0.9), metal::float4(1.0, 0.0, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!(((largest > 0.000000000000000000000000000001) & (largest < 1000000000000000000000000000000.0)))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x_1
) {
    float clamped = metal::clamp(x_1, -126.0, 127.99999);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_2
) {
    float clamped_1 = metal::max(x_2, -126.0);
    float whole_1 = metal::rint(clamped_1);
    float f_1 = clamped_1 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise_1
) {
    float square_1 = metal::dot(v_1, v_1);
    return (square_1 > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square_1, 0.000000000000000000000000000001))) : otherwise_1;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_2
) {
    return v_2 * metal::rsqrt(metal::max(metal::dot(v_2, v_2), 0.000000000000000000000000000001));
}

float bounded(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    uint magnitude = bits & 2147483647u;
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

float divided(
    float a,
    float b
) {
    if (metal::abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e7 = bounded(a / b);
    return _e7;
}

float footprint_of(
    float x_4
) {
    float _e1 = metal::dfdx(x_4);
    float _e2 = metal::dfdy(x_4);
    metal::float2 d = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d, d));
}

float srgb_of_linear(
    float light
) {
    float size = metal::abs(light);
    float value_1 = (size <= 0.0031308) ? (size * 12.92) : ((1.055 * metal::pow(size, 0.41666666)) - 0.055);
    return (light < 0.0) ? -(value_1) : value_1;
}

metal::float3 oklab_of_linear(
    metal::float3 rgb
) {
    float l = metal::pow(metal::dot(rgb, metal::float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = metal::pow(metal::dot(rgb, metal::float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s = metal::pow(metal::dot(rgb, metal::float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return metal::float3(((0.21045426 * l) + (0.7936178 * m)) - (0.004072047 * s), ((1.9779985 * l) - (2.4285922 * m)) + (0.4505937 * s), ((0.025904037 * l) + (0.78277177 * m)) - (0.80867577 * s));
}

metal::float3 linear_of_oklab(
    metal::float3 lab
) {
    float l_1 = (lab.x + (0.39633778 * lab.y)) + (0.21580376 * lab.z);
    float m_1 = (lab.x - (0.105561346 * lab.y)) - (0.06385417 * lab.z);
    float s_1 = (lab.x - (0.08948418 * lab.y)) - (1.2914855 * lab.z);
    metal::float3 cubes = metal::float3((l_1 * l_1) * l_1, (m_1 * m_1) * m_1, (s_1 * s_1) * s_1);
    return metal::float3(metal::dot(cubes, metal::float3(4.0767417, -3.3077116, 0.23096994)), metal::dot(cubes, metal::float3(-1.268438, 2.6097574, -0.34131938)), metal::dot(cubes, metal::float3(-0.0041960864, -0.7034186, 1.7076147)));
}

metal::float3 oklab_of_srgb(
    metal::float3 coded
) {
    metal::float3 _e30 = oklab_of_linear(metal::float3((coded.x <= 0.04045) ? (coded.x / 12.92) : metal::pow((coded.x + 0.055) / 1.055, 2.4), metal::pow((coded.y + 0.055) / 1.055, 2.4), metal::pow((coded.z + 0.055) / 1.055, 2.4)));
    return _e30;
}

metal::float3 oklab_of_srgb_2_(
    metal::float3 coded_1
) {
    metal::float3 _e23 = oklab_of_linear(metal::float3(metal::pow((coded_1.x + 0.055) / 1.055, 2.4), metal::pow((coded_1.y + 0.055) / 1.055, 2.4), metal::pow((coded_1.z + 0.055) / 1.055, 2.4)));
    return _e23;
}

metal::float3 srgb_of_oklab(
    metal::float3 lab_1
) {
    metal::float3 _e1 = linear_of_oklab(lab_1);
    float _e3 = srgb_of_linear(_e1.x);
    float _e5 = srgb_of_linear(_e1.y);
    float _e7 = srgb_of_linear(_e1.z);
    return metal::float3(_e3, _e5, _e7);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

RampPlace ramp_place(
    Ramp ramp,
    float x_5
) {
    type_6 colors = {};
    type_7 places = {};
    uint i = 1u;
    uint at = 0u;
    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e27 = i;
            i = _e27 + 1u;
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
        float _e24 = places.inner[naga_div(_e16, 4u)][naga_mod(_e20, 4u)];
        at = (_e24 <= x_5) ? _e15 : _e14;
    }
    uint _e30 = at;
    uint after = metal::min(_e30 + 1u, 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place_1 = places.inner[naga_div(_e35, 4u)][naga_mod(_e39, 4u)];
    float _e51 = places.inner[naga_div(after, 4u)][naga_mod(after, 4u)];
    float _e53 = divided(x_5 - place_1, _e51 - place_1);
    float t = metal::clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    metal::float4 _e59 = colors.inner[_e57];
    metal::float4 _e61 = colors.inner[after];
    return RampPlace {_e59, _e61, t};
}

Color mix_colors_screen(
    Color a_1,
    Color b_1,
    float factor
) {
    return metal::float4(metal::mix(a_1.xyz, (a_1.xyz + b_1.xyz) - (a_1.xyz * b_1.xyz), metal::min(factor, 1.0)), 1.0);
}

Color mix_colors_screen_2_(
    Color a_2,
    Color b_2,
    float factor_1
) {
    return metal::float4(metal::mix(a_2.xyz, (a_2.xyz + b_2.xyz) - (a_2.xyz * b_2.xyz), factor_1), 1.0);
}

float curvature_signed(
    float kappa,
    float slope
) {
    float a_4 = metal::clamp(kappa, -10000.0, 10000.0) * slope;
    float magnitude_1 = metal::min(metal::abs(a_4), 50.0);
    if (magnitude_1 < 0.0625) {
        float a2_ = a_4 * a_4;
        return a_4 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e25 = exp2_stable_2_(-2.88539 * magnitude_1);
    float t_1 = (1.0 - _e25) / (1.0 + _e25);
    return (a_4 >= 0.0) ? t_1 : -(t_1);
}

metal::float2 principal_curvatures(
    metal::float3 tensor
) {
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = metal::length(metal::float2(0.5 * (tensor.x - tensor.z), tensor.y));
    float far = mean + ((mean >= 0.0) ? spread : -(spread));
    float _e26 = divided((tensor.x * tensor.z) - (tensor.y * tensor.y), far);
    return (mean >= 0.0) ? metal::float2(far, _e26) : metal::float2(_e26, far);
}

metal::float3 half_of(
    metal::float3 light_1,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light_1 + view;
    metal::float3 _e8 = normalize_moderate((metal::dot(half_, half_) > 0.000000000001) ? half_ : normal, normal);
    return _e8;
}

float sine_squared(
    metal::float3 a_3,
    metal::float3 b_3
) {
    metal::float3 across = metal::cross(a_3, b_3);
    return metal::min(metal::dot(across, across), 1.0);
}

Reflection reflection_of(
    metal::float3 light_2,
    metal::float3 normal_1,
    metal::float3 view_1
) {
    metal::float3 _e3 = half_of(light_2, normal_1, view_1);
    float n_h = metal::clamp(metal::dot(normal_1, _e3), 0.0, 1.0);
    float v_h = metal::clamp(metal::dot(view_1, _e3), 0.0, 1.0);
    float _e14 = sine_squared(normal_1, _e3);
    return Reflection {metal::dot(normal_1, light_2), metal::dot(normal_1, view_1), n_h, v_h, _e14};
}

float schlick(
    float at_normal,
    float cosine
) {
    float m_2 = 1.0 - cosine;
    float m2_ = m_2 * m_2;
    return at_normal + ((1.0 - at_normal) * ((m2_ * m2_) * m_2));
}

float ggx(
    Reflection r,
    float width,
    float at_normal_1
) {
    if ((r.n_l <= 0.0) | (r.n_v <= 0.0)) {
        return 0.0;
    }
    float a2_1 = width * width;
    float bottom = metal::max(r.sine2_ + ((a2_1 * r.n_h) * r.n_h), 0.000000000001);
    float distribution = a2_1 / (bottom * bottom);
    float toward_light = r.n_v * metal::sqrt(((r.n_l * r.n_l) * (1.0 - a2_1)) + a2_1);
    float toward_eye = r.n_l * metal::sqrt(((r.n_v * r.n_v) * (1.0 - a2_1)) + a2_1);
    float visibility = 0.5 / metal::max(toward_light + toward_eye, 0.000000001);
    float _e49 = schlick(at_normal_1, r.v_h);
    return metal::min(((distribution * visibility) * _e49) * r.n_l, 1000000.0);
}

Color ramp_oklab(
    float value,
    Ramp ramp_1
) {
    RampPlace _e2 = ramp_place(ramp_1, value);
    metal::float3 _e5 = oklab_of_srgb(_e2.before.xyz);
    metal::float3 _e8 = oklab_of_srgb_2_(_e2.after.xyz);
    metal::float3 _e11 = srgb_of_oklab(metal::mix(_e5, _e8, _e2.t));
    return (_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : metal::float4(_e11, 1.0));
}

float rim(
    Light light_3,
    metal::float3 normal_2,
    metal::float3 view_2,
    float width_1,
    float softness,
    float follow
) {
    float facing = metal::clamp(metal::dot(normal_2, view_2), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = metal::max(width_1 * softness, metal::min(_e11, 1.0));
    metal::float3 aside = normal_2 - view_2;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside, aside)) - 0.5) : (width_1 - facing);
    float within = (further / edge) + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across_1 = light_3.direction - (metal::dot(light_3.direction, view_2) * view_2);
    float side = metal::dot(normal_2 - (metal::dot(normal_2, view_2) * view_2), across_1 * metal::rsqrt(metal::max(metal::dot(across_1, across_1), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
}

metal::float2 warped_place(
    metal::float3 tensor_1,
    metal::float2 place,
    float amount,
    float slope_1
) {
    metal::float2 _e4 = principal_curvatures(tensor_1);
    float _e7 = curvature_signed(_e4.x, slope_1);
    float _e9 = exp2_stable(-(amount) * _e7);
    float _e12 = curvature_signed(_e4.y, slope_1);
    float _e14 = exp2_stable(-(amount) * _e12);
    metal::float2 half_apart = metal::float2(0.5 * (tensor_1.x - tensor_1.z), tensor_1.y);
    metal::float2 axes = half_apart / metal::float2(metal::max(metal::length(half_apart), 0.00000000000000000001));
    metal::float2 turned = metal::float2((axes.x * place.x) + (axes.y * place.y), (axes.y * place.x) - (axes.x * place.y));
    return ((0.5 * (_e9 + _e14)) * place) + ((0.5 * (_e9 - _e14)) * turned);
}

metal::float3 warped_light(
    metal::float3 light_4,
    metal::float3 n,
    metal::float3 view_3,
    metal::float3x3 camera_from_world,
    metal::float3 tensor_2,
    float amount_1,
    float slope_2
) {
    metal::float3 right = metal::float3(1.0, 0.0, 0.0) * camera_from_world;
    metal::float3 _e19 = normalize_moderate(right - (metal::dot(right, view_3) * view_3), metal::float3(1.0, 0.0, 0.0));
    metal::float3 y = metal::cross(view_3, _e19);
    metal::float3 between = (view_3 + n) / metal::float3(metal::max(1.0 + metal::dot(view_3, n), 0.01));
    metal::float3 along_x = _e19 - (metal::dot(n, _e19) * between);
    metal::float3 along_y = y - (metal::dot(n, y) * between);
    metal::float2 place_2 = metal::float2(metal::dot(light_4, along_x), metal::dot(light_4, along_y)) / metal::float2(metal::max(1.0 + metal::dot(light_4, n), 0.0001));
    metal::float2 _e45 = warped_place(tensor_2, place_2, amount_1, slope_2);
    float square_2 = metal::dot(_e45, _e45);
    metal::float3 _e60 = normalize_or((((2.0 * _e45.x) * along_x) + ((2.0 * _e45.y) * along_y)) + ((1.0 - square_2) * n), light_4);
    return _e60;
}

Light light_warp(
    Light light_5,
    metal::float3 normal_3,
    float amount_2,
    float slope_3,
    metal::float3 tensor_3,
    metal::float3 view_4,
    metal::float3x3 camera_from_world_1
) {
    float most = amount_2 * metal::smoothstep(0.05, 0.3, metal::dot(normal_3, view_4));
    metal::float3 _e13 = warped_light(light_5.direction, normal_3, view_4, camera_from_world_1, tensor_3, most, slope_3);
    bool is_flat = (most == 0.0) | false;
    return Light {is_flat ? light_5.direction : _e13, light_5.own_direction, light_5.color, light_5.intensity};
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.key;
    metal::float3x3 _e11 = look.camera_from_world;
    Light _e12 = light_warp(_e3, surface.normal, 1.4, 0.03, surface.curvature_tensor, surface.view, _e11);
    float through_the_stone = metal::max((metal::dot(surface.normal, _e12.direction) + 0.6) / 1.6, 0.0);
    Color _e23 = ramp_oklab(through_the_stone, jade);
    Reflection _e27 = reflection_of(_e12.direction, surface.normal, surface.view);
    float _e30 = ggx(_e27, 0.1764, 0.09);
    Color _e36 = mix_colors_screen(_e23, metal::float4(1.0, 0.9569, 0.8627, 1.0), _e30);
    Light _e39 = look.back;
    float _e45 = rim(_e39, surface.normal, surface.view, 0.5, 0.8, 1.0);
    Color _e51 = mix_colors_screen_2_(_e36, metal::float4(0.1843, 0.5608, 0.7216, 1.0), _e45);
    return _e51;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_5 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_4 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_5.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_4 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_5 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_4 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_4 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_5.eye;
    float _e13 = view_5.eye.w;
    metal::float4 _e23 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_4, metal::normalize(_e8.xyz - (_e13 * in.position)), _e23.xyz};
    metal::float4 _e26 = shade(surface_1, look);
    return fs_mainOutput { _e26 };
}
