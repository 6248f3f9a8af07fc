// Clay relief: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0), curvature_tensor_map texture(1).
// clay-relief.json says what to put there and how to draw.
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
    Light sky;
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float kappa;
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
struct Relief {
    float shape;
    float strength;
    float greatest;
    float least;
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
constant float PI = 3.1415927;
constant float HALF_PI = 1.5707964;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant Ramp terracotta = Ramp {type_6 {{metal::float4(0.2353, 0.102, 0.1098, 1.0), metal::float4(0.5412, 0.251, 0.1882, 1.0), metal::float4(0.8118, 0.498, 0.3412, 1.0), metal::float4(0.949, 0.7412, 0.5725, 1.0), metal::float4(0.9843, 0.8627, 0.7333, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.3, 0.62, 0.9), metal::float4(1.0, 0.0, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};
constant Ramp pits_to_bumps = Ramp {type_6 {{metal::float4(0.2941, 0.2275, 0.3216, 1.0), metal::float4(0.4784, 0.2902, 0.2902, 1.0), metal::float4(0.7529, 0.502, 0.3765, 1.0), metal::float4(0.9412, 0.7529, 0.5804, 1.0), metal::float4(1.0, 0.9412, 0.8471, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.3, 0.5, 0.75), metal::float4(1.0, 0.0, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float clamped = metal::clamp(x, -126.0, 127.99999);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float exp2_stable_2_(
    float x_1
) {
    float clamped_1 = metal::max(x_1, -126.0);
    float whole_1 = metal::rint(clamped_1);
    float f_1 = clamped_1 - whole_1;
    float twice_1 = 2.0 + (f_1 * (1.3862944 + (f_1 * (0.48045295 + (f_1 * (0.11100665 + (f_1 * (0.019236874 + (f_1 * (0.002679775 + (f_1 * 0.00030706724)))))))))));
    return twice_1 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole_1)) + as_type<uint>(126))) << 23u);
}

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

float atan2_positive(
    float y,
    float x_2
) {
    float small = metal::min(y, x_2);
    float large = metal::max(y, x_2);
    if (large <= 0.0) {
        return 0.0;
    }
    float t = small / large;
    bool is_wide = t > 0.41421357;
    float r = is_wide ? ((small - large) / (small + large)) : t;
    float r2_ = r * r;
    float series = r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353))))))))))))))));
    float a_3 = is_wide ? (series + 0.7853982) : series;
    return (y > x_2) ? (HALF_PI - a_3) : a_3;
}

float bounded(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_1
) {
    metal::uint2 bits_1 = as_type<metal::uint2>(v_1);
    metal::uint2 magnitude_1 = bits_1 & metal::uint2(2147483647u);
    metal::float2 largest_1 = as_type<metal::float2>((bits_1 & metal::uint2(2147483648u)) | metal::uint2(2139095039u));
    metal::float2 numbers = metal::select(metal::float2(0.0), largest_1, magnitude_1 == metal::uint2(2139095040u));
    return metal::select(numbers, v_1, magnitude_1 < metal::uint2(2139095040u));
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

float angle_of_point(
    float y_1,
    float x_4
) {
    metal::float2 _e3 = bounded_vec2_(metal::float2(x_4, y_1));
    metal::float2 p = metal::abs(_e3);
    metal::float2 scaled = (metal::max(p.x, p.y) > 1.0) ? (0.5 * p) : p;
    float _e15 = atan2_positive(scaled.y, scaled.x);
    float turned = (x_4 < 0.0) ? (PI - _e15) : _e15;
    return (y_1 < 0.0) ? -(turned) : turned;
}

float footprint_of(
    float x_5
) {
    float _e1 = metal::dfdx(x_5);
    float _e2 = metal::dfdy(x_5);
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

float soft_light(
    float a_1,
    float b_1
) {
    if (b_1 <= 0.5) {
        return a_1 - (((1.0 - (2.0 * b_1)) * a_1) * (1.0 - a_1));
    }
    float curved_1 = (a_1 <= 0.25) ? (((((16.0 * a_1) - 12.0) * a_1) + 4.0) * a_1) : metal::sqrt(metal::max(a_1, 0.0));
    return a_1 + (((2.0 * b_1) - 1.0) * (curved_1 - a_1));
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
    metal::float3 _e23 = oklab_of_linear(metal::float3(metal::pow((coded.x + 0.055) / 1.055, 2.4), metal::pow((coded.y + 0.055) / 1.055, 2.4), metal::pow((coded.z + 0.055) / 1.055, 2.4)));
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
    float x_6
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
        at = (_e24 <= x_6) ? _e15 : _e14;
    }
    uint _e30 = at;
    uint after = metal::min(_e30 + 1u, 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places.inner[naga_div(_e35, 4u)][naga_mod(_e39, 4u)];
    float _e51 = places.inner[naga_div(after, 4u)][naga_mod(after, 4u)];
    float _e53 = divided(x_6 - place, _e51 - place);
    float t_1 = metal::clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    metal::float4 _e59 = colors.inner[_e57];
    metal::float4 _e61 = colors.inner[after];
    return RampPlace {_e59, _e61, t_1};
}

Color mix_colors_screen(
    Color a_2,
    Color b_2,
    float factor
) {
    return metal::float4(metal::mix(a_2.xyz, (a_2.xyz + b_2.xyz) - (a_2.xyz * b_2.xyz), factor), 1.0);
}

float curvature_signed(
    float kappa,
    float slope
) {
    float a_4 = kappa * slope;
    float magnitude_2 = metal::min(metal::abs(a_4), 50.0);
    if (magnitude_2 < 0.0625) {
        float a2_ = a_4 * a_4;
        return a_4 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254))))));
    }
    float _e22 = exp2_stable_2_(-2.88539 * magnitude_2);
    float t_2 = (1.0 - _e22) / (1.0 + _e22);
    return (a_4 >= 0.0) ? t_2 : -(t_2);
}

float curvature_signed_2_(
    float kappa_1,
    float slope_1
) {
    float a_5 = metal::min(kappa_1, 10000.0) * slope_1;
    float magnitude_3 = metal::min(a_5, 50.0);
    if (magnitude_3 < 0.0625) {
        float a2_1 = a_5 * a_5;
        return a_5 * (1.0 - (a2_1 * (0.33333334 - (a2_1 * (0.13333334 - (a2_1 * 0.053968254))))));
    }
    float _e23 = exp2_stable_2_(-2.88539 * magnitude_3);
    float t_3 = (1.0 - _e23) / (1.0 + _e23);
    return t_3;
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

Color ramp_oklab(
    float value,
    Ramp ramp_1
) {
    RampPlace _e2 = ramp_place(ramp_1, value);
    metal::float3 _e5 = oklab_of_srgb(_e2.before.xyz);
    metal::float3 _e8 = oklab_of_srgb(_e2.after.xyz);
    metal::float3 _e11 = srgb_of_oklab(metal::mix(_e5, _e8, _e2.t));
    return (_e2.t <= 0.0) ? _e2.before : ((_e2.t >= 1.0) ? _e2.after : metal::float4(_e11, 1.0));
}

float reflectance_half_lambert(
    Light light_1,
    metal::float3 normal
) {
    float half_ = 0.5 + (0.5 * metal::dot(normal, light_1.direction));
    return metal::min(half_ * half_, 1.0);
}

float rim(
    Light light_2,
    metal::float3 normal_1,
    metal::float3 view,
    float width,
    float softness,
    float follow
) {
    float facing = metal::clamp(metal::dot(normal_1, view), 0.0, 1.0);
    float _e11 = footprint_of(facing);
    float edge = metal::max(width * softness, metal::min(_e11, 1.0));
    metal::float3 aside = normal_1 - view;
    float further = (facing > 0.5) ? ((0.5 * metal::dot(aside, aside)) - (1.0 - width)) : (width - facing);
    float within = (further / edge) + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light_2.direction - (metal::dot(light_2.direction, view) * view);
    float side = metal::dot(normal_1 - (metal::dot(normal_1, view) * view), across * metal::rsqrt(metal::max(metal::dot(across, across), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
}

float radiance_scaled(
    float tone,
    float curved,
    float turning
) {
    float _e5 = exp2_stable(curved * LOG2_E);
    float dark = turning * (1.0 - tone);
    float light_3 = tone * (1.0 - turning);
    return (tone * ((_e5 * dark) + light_3)) / metal::max(dark + (_e5 * light_3), 0.00000000000000000001);
}

float radiance_scaling(
    float tone_1,
    float kappa_2,
    float amount,
    float slope_2,
    float turning_1
) {
    float _e5 = curvature_signed(kappa_2, slope_2);
    float curved_2 = amount * _e5;
    float _e7 = radiance_scaled(tone_1, curved_2, turning_1);
    return metal::min((curved_2 == 0.0) ? tone_1 : _e7, 1.0);
}

Relief relief(
    metal::float3 tensor_1,
    float slope_3
) {
    metal::float2 _e2 = principal_curvatures(tensor_1);
    float _e9 = angle_of_point(_e2.x + _e2.y, _e2.x - _e2.y);
    float curvedness = metal::sqrt(0.5 * metal::dot(_e2, _e2));
    float _e14 = curvature_signed_2_(curvedness, slope_3);
    return Relief {0.5 + (_e9 / PI), _e14, _e2.x, _e2.y};
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e5 = reflectance_half_lambert(_e3, surface.normal);
    float _e10 = radiance_scaling(_e5, surface.kappa, 1.3, 0.03, 0.9);
    Color _e12 = ramp_oklab(_e10, terracotta);
    Relief _e15 = relief(surface.curvature_tensor, 0.025);
    Color _e18 = ramp_oklab(_e15.shape, pits_to_bumps);
    float _e22 = soft_light(_e12.x, _e18.x);
    float _e25 = soft_light(_e12.y, _e18.y);
    float _e28 = soft_light(_e12.z, _e18.z);
    metal::float4 slip_in_the_hollows = metal::float4(metal::mix(_e12.xyz, metal::float3(_e22, _e25, _e28), metal::clamp(_e15.strength, 0.0, 1.0)), 1.0);
    Light _e39 = look.sky;
    float _e45 = rim(_e39, surface.normal, surface.view, 0.4, 0.9, 1.0);
    Color _e51 = mix_colors_screen(slip_in_the_hollows, metal::float4(0.3725, 0.498, 0.6588, 1.0), _e45);
    return _e51;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_2 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_1 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(1)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_2 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e23 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e30 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_2, metal::normalize(_e8.xyz - (_e13 * in.position)), _e23.x, _e30.xyz};
    metal::float4 _e33 = shade(surface_1, look);
    return fs_mainOutput { _e33 };
}
