// Exaggerated shape: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), smooth_normal_1_map texture(0), smooth_normal_2_map texture(1), smooth_normal_3_map texture(2), smooth_normal_4_map texture(3).
// shape-exaggerated.json says what to put there and how to draw.
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
    metal::float2 viewport;
    char _pad1[8];
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 smooth_normal_1_;
    metal::float3 smooth_normal_2_;
    metal::float3 smooth_normal_3_;
    metal::float3 smooth_normal_4_;
};
typedef metal::float4 Color;
struct type_7 {
    metal::float4 inner[16];
};
struct type_8 {
    metal::float4 inner[4];
};
struct Ramp {
    type_7 colors;
    type_8 places;
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
    metal::float3 position;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant Ramp from_dusk_to_sun = Ramp {type_7 {{metal::float4(0.1373, 0.1647, 0.302, 1.0), metal::float4(0.4196, 0.3725, 0.5255, 1.0), metal::float4(0.7882, 0.5804, 0.4353, 1.0), metal::float4(0.9412, 0.8039, 0.5725, 1.0), metal::float4(1.0, 0.9843, 0.902, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_8 {{metal::float4(0.05, 0.35, 0.55, 0.75), metal::float4(0.98, 0.0, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};

float exp2_stable(
    float x
) {
    float whole = metal::rint(x);
    float f = x - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * 0.5;
}

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_1
) {
    return v_1 * metal::rsqrt(metal::max(metal::dot(v_1, v_1), 0.000000000000000000000000000001));
}

float bounded(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0);
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
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
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
    float x_3
) {
    type_7 colors = {};
    type_8 places = {};
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
        at = (_e24 <= x_3) ? _e15 : _e14;
    }
    uint _e30 = at;
    uint after = metal::min(_e30 + 1u, 4u);
    uint _e35 = at;
    uint _e39 = at;
    float place = places.inner[naga_div(_e35, 4u)][naga_mod(_e39, 4u)];
    float _e51 = places.inner[naga_div(after, 4u)][naga_mod(after, 4u)];
    float _e53 = divided(x_3 - place, _e51 - place);
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

float detail_lit(
    metal::float3 finer,
    metal::float3 coarser,
    metal::float3 light_1,
    float contrast
) {
    metal::float3 across = light_1 - (metal::dot(light_1, coarser) * coarser);
    metal::float3 toward = across / metal::float3(metal::max(metal::length(across), 0.05));
    return metal::clamp(contrast * metal::dot(finer, toward), -1.0, 1.0);
}

float exaggerated_four(
    Light light_2,
    metal::float3 normal,
    float contrast_1,
    float detail,
    metal::float3 smooth_1_,
    metal::float3 smooth_2_,
    metal::float3 smooth_3_,
    metal::float3 smooth_4_
) {
    float _e9 = exp2_stable(-(detail));
    metal::float3 _e10 = normalize_moderate(smooth_1_, normal);
    metal::float3 _e11 = normalize_moderate(smooth_2_, _e10);
    metal::float3 _e12 = normalize_moderate(smooth_3_, _e11);
    metal::float3 _e13 = normalize_moderate(smooth_4_, _e12);
    float _e15 = detail_lit(_e11, _e12, light_2.direction, contrast_1);
    float _e17 = detail_lit(_e12, _e13, light_2.direction, contrast_1);
    float coarse = _e15 + (_e9 * (_e17 + (_e9 * metal::dot(_e13, light_2.direction))));
    float _e25 = detail_lit(normal, _e10, light_2.direction, contrast_1);
    float _e27 = detail_lit(_e10, _e11, light_2.direction, contrast_1);
    float sum = _e25 + (_e9 * (_e27 + (_e9 * coarse)));
    return metal::clamp(0.5 + ((0.5 * sum) / (1.0 + (_e9 * (1.0 + (_e9 * (1.0 + (_e9 * (1.0 + _e9)))))))), 0.0, 1.0);
}

float outer_contour(
    float width,
    metal::float3 normal_1,
    metal::float3 view,
    metal::float2 viewport
) {
    float facing = metal::clamp(metal::dot(normal_1, view), 0.0, 1.0);
    float pixels = (width * metal::clamp(viewport.y, 1.0, 100000.0)) / 1000.0;
    float _e15 = footprint_of(facing);
    float distance = facing / metal::max(2.0 * _e15, 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp((pixels + 0.5) - distance, 0.0, metal::min(pixels, 1.0)) * near;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e11 = exaggerated_four(_e3, surface.normal, 7.0, 0.1, surface.smooth_normal_1_, surface.smooth_normal_2_, surface.smooth_normal_3_, surface.smooth_normal_4_);
    Color _e13 = ramp_oklab(_e11, from_dusk_to_sun);
    metal::float2 _e19 = look.viewport;
    float _e20 = outer_contour(3.0, surface.normal, surface.view, _e19);
    metal::float4 inked = metal::mix(_e13, metal::float4(0.098, 0.1059, 0.2, 1.0), _e20);
    return inked;
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
, metal::texture2d<float, metal::access::sample> smooth_normal_1_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_2_map [[texture(1)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_3_map [[texture(2)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_4_map [[texture(3)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_2 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e23 = smooth_normal_1_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e29 = view_1.camera_from_world;
    metal::float4 _e37 = smooth_normal_2_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e43 = view_1.camera_from_world;
    metal::float4 _e51 = smooth_normal_3_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e57 = view_1.camera_from_world;
    metal::float4 _e65 = smooth_normal_4_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e71 = view_1.camera_from_world;
    Surface surface_1 = Surface {normal_2, metal::normalize(_e8.xyz - (_e13 * in.position)), (metal::float4(_e23.xyz, 0.0) * _e29).xyz, (metal::float4(_e37.xyz, 0.0) * _e43).xyz, (metal::float4(_e51.xyz, 0.0) * _e57).xyz, (metal::float4(_e65.xyz, 0.0) * _e71).xyz};
    metal::float4 _e75 = shade(surface_1, look);
    return fs_mainOutput { _e75 };
}
