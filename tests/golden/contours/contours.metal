// Contours: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_2 buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0), smooth_normal_4_map texture(1).
// contours.json says what to put there and how to draw.
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
    metal::float3x3 camera_from_world;
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_camera;
    metal::float3 curvature_tensor;
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
constant Ramp three_washes = Ramp {type_7 {{metal::float4(0.7255, 0.7686, 0.8118, 1.0), metal::float4(0.8627, 0.8627, 0.8235, 1.0), metal::float4(0.9725, 0.949, 0.8863, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_8 {{metal::float4(0.0, 0.16, 0.42, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 3u, 2u};

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

float footprint_of(
    float x_1
) {
    float _e1 = metal::dfdx(x_1);
    float _e2 = metal::dfdy(x_1);
    metal::float2 d = metal::float2(_e1, _e2);
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

float footprint_of_2_(
    float x_2
) {
    float _e1 = metal::dfdx(x_2);
    float _e2 = metal::dfdy(x_2);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_1, d_1));
}

float step_filtered(
    float x_3,
    float edge,
    float w
) {
    float d_2 = x_3 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_2 / w), 0.0, 1.0);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_4,
    float w_1
) {
    type_7 colors = {};
    type_8 places = {};
    metal::float4 color = {};
    uint i = 1u;
    colors = ramp.colors;
    places = ramp.places;
    metal::float4 _e8 = colors.inner[0];
    color = _e8;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e35 = i;
            i = _e35 + 1u;
        }
        loop_init = false;
        uint _e12 = i;
        if (!((_e12 < 3u))) {
            break;
        }
        metal::float4 _e16 = color;
        uint _e17 = i;
        metal::float4 _e19 = colors.inner[_e17];
        uint _e20 = i;
        metal::float4 _e24 = colors.inner[_e20 - 1u];
        uint _e27 = i;
        float _e31 = places.inner[0][naga_mod(_e27, 4u)];
        float _e32 = step_filtered(x_4, _e31, w_1);
        color = _e16 + ((_e19 - _e24) * _e32);
    }
    metal::float4 _e38 = color;
    return _e38;
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

float reflectance_half_lambert(
    Light light,
    metal::float3 normal
) {
    float half_ = 0.5 + (0.5 * metal::dot(normal, light.direction));
    return metal::min(half_ * half_, 1.0);
}

float inner_contour_suggestive(
    float width,
    float limit,
    float softness,
    metal::float3 tensor_1,
    metal::float3 normal_1,
    metal::float3 view,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n = camera_from_world * normal_1;
    float square_1 = metal::dot(n.xy, n.xy);
    float radial = ((((tensor_1.x * n.x) * n.x) + (((2.0 * tensor_1.y) * n.x) * n.y)) + ((tensor_1.z * n.y) * n.y)) / metal::max(square_1, 0.000001);
    float _e35 = metal::dfdx(radial);
    float _e36 = metal::dfdy(radial);
    metal::float2 change = metal::float2(_e35, _e36);
    metal::float3 v_2 = camera_from_world * view;
    metal::float3 row = metal::dfdy(place);
    float up = ((row - (metal::dot(row, v_2) * v_2)).y >= 0.0) ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(((change.x * n.x) + ((up * change.y) * n.y))) * metal::rsqrt(metal::max(square_1, 0.000001));
    float pixels = (1.5 * height) / 1000.0;
    float distance = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float x_6 = (toward_eye * height) * 0.05;
    float _e79 = footprint_of(x_6);
    float strength = metal::clamp(0.5 + ((x_6 - limit) / metal::length(metal::float2(metal::min(_e79, 1000000000000000.0), 22.0))), 0.0, 1.0);
    return (metal::clamp((pixels + 0.5) - distance, 0.0, metal::min(pixels, 1.0)) * strength) * metal::smoothstep(0.05, 0.3, metal::dot(normal_1, view));
}

float faded_in(
    float x_5,
    float limit_1,
    float softness_1
) {
    float _e3 = footprint_of(x_5);
    float width_2 = metal::length(metal::float2(metal::min(_e3, 1000000000000000.0), 45.0));
    float _e9 = bounded(x_5);
    float _e11 = bounded(_e9 - limit_1);
    return metal::clamp(0.5 + (_e11 / width_2), 0.0, 1.0);
}

float outer_contour(
    float width_1,
    metal::float3 normal_2,
    metal::float3 view_1,
    metal::float2 viewport_1
) {
    float facing = metal::clamp(metal::dot(normal_2, view_1), 0.0, 1.0);
    float pixels_1 = (width_1 * metal::clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0;
    float _e15 = footprint_of_2_(facing);
    float distance_1 = facing / metal::max(2.0 * _e15, 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp((pixels_1 + 0.5) - distance_1, 0.0, metal::min(pixels_1, 1.0)) * near;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e3 = normalize_moderate(surface.smooth_normal_4_, surface.normal);
    Light _e6 = look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    float _e9 = footprint_of_2_(_e7);
    Color _e10 = ramp_at(three_washes, _e7, _e9);
    metal::float2 _e12 = principal_curvatures(surface.curvature_tensor);
    float _e17 = faded_in(-(_e12.y), 45.0, 1.0);
    float hollows = _e17 * metal::smoothstep(0.05, 0.3, metal::dot(surface.normal, surface.view));
    metal::float4 hollows_in_sepia = metal::mix(_e10, metal::float4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    metal::float3x3 _e39 = look.camera_from_world;
    metal::float2 _e43 = look.viewport;
    float _e44 = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor, surface.normal, surface.view, _e39, surface.position_camera, _e43);
    metal::float2 _e50 = look.viewport;
    float _e51 = outer_contour(5.0, surface.normal, surface.view, _e50);
    float all_lines = metal::max(_e44, _e51);
    metal::float4 ink = metal::mix(hollows_in_sepia, metal::float4(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return ink;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_3 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_2 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_3 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_2.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_3 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_2 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_4_map [[texture(1)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_3 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    metal::float4x4 _e20 = view_2.camera_from_world;
    metal::float4 _e31 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e38 = smooth_normal_4_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e44 = view_2.camera_from_world;
    Surface surface_1 = Surface {normal_3, metal::normalize(_e8.xyz - (_e13 * in.position)), (_e20 * metal::float4(in.position, 1.0)).xyz, _e31.xyz, (metal::float4(_e38.xyz, 0.0) * _e44).xyz};
    metal::float4 _e48 = shade(surface_1, look);
    return fs_mainOutput { _e48 };
}
