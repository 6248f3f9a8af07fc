// Curvature as color: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// mean-curvature.json says what to put there and how to draw.
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
    Light key;
};
struct Surface {
    metal::packed_float3 normal;
    float kappa;
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
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant Ramp hollow_flat_ridge = Ramp {type_6 {{metal::float4(0.0588, 0.1294, 0.2706, 1.0), metal::float4(0.1843, 0.3725, 0.5412, 1.0), metal::float4(0.7255, 0.7647, 0.7059, 1.0), metal::float4(0.9255, 0.8902, 0.7961, 1.0), metal::float4(0.8902, 0.749, 0.502, 1.0), metal::float4(0.7804, 0.4627, 0.1843, 1.0), metal::float4(1.0, 0.9529, 0.8627, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_7 {{metal::float4(0.0, 0.25, 0.44, 0.5), metal::float4(0.6, 0.8, 1.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 7u, 0u};

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_1
) {
    metal::float3 _e5 = normalize_moderate(v_1, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0);
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
    float x_1
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
        if (!((_e10 < 7u))) {
            break;
        }
        uint _e14 = at;
        uint _e15 = i;
        uint _e16 = i;
        uint _e20 = i;
        float _e24 = places.inner[naga_div(_e16, 4u)][naga_mod(_e20, 4u)];
        at = (_e24 <= x_1) ? _e15 : _e14;
    }
    uint _e30 = at;
    uint after = metal::min(_e30 + 1u, 6u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places.inner[naga_div(_e35, 4u)][naga_mod(_e39, 4u)];
    float _e51 = places.inner[naga_div(after, 4u)][naga_mod(after, 4u)];
    float _e53 = divided(x_1 - place, _e51 - place);
    float t = metal::clamp(_e53, 0.0, 1.0);
    uint _e57 = at;
    metal::float4 _e59 = colors.inner[_e57];
    metal::float4 _e61 = colors.inner[after];
    return RampPlace {_e59, _e61, t};
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

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float curvature = surface.kappa;
    float from_hollow_to_ridge = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.045, -20.0, 20.0))))));
    Color _e21 = ramp_oklab(from_hollow_to_ridge, hollow_flat_ridge);
    Light _e24 = look.key;
    float _e26 = reflectance_half_lambert(_e24, surface.normal);
    float in_the_dark = 1.0 - _e26;
    metal::float4 shade_2_ = metal::clamp(metal::float4(_e21.xyz * metal::mix(metal::float3(1.0), metal::float3(0.42, 0.4, 0.55), in_the_dark), 1.0), metal::float4(0.0), metal::float4(1.0));
    return shade_2_;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 normal [[user(loc0), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e14 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, _e14 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 normal_1 [[user(loc0), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e11 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface_1 = Surface {normal_1, _e11.x};
    metal::float4 _e14 = shade(surface_1, look);
    return fs_mainOutput { _e14 };
}
