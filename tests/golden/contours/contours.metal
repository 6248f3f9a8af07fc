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
    float largest_1 = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
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
    float _e6 = bounded(metal::sqrt(metal::dot(d, d)));
    return _e6;
}

float footprint_of_2_(
    float x_3
) {
    float _e1 = metal::dfdx(x_3);
    float _e2 = metal::dfdy(x_3);
    metal::float2 d_1 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_1, d_1));
}

float step_filtered(
    float x_4,
    float edge,
    float w
) {
    float d_2 = x_4 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_2 / w), 0.0, 1.0);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_5,
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
        float _e32 = step_filtered(x_5, _e31, w_1);
        color = _e16 + ((_e19 - _e24) * _e32);
    }
    metal::float4 _e38 = color;
    return _e38;
}

float kappa_safe(
    float kappa
) {
    bool is_nan = (as_type<uint>(kappa) & 2147483647u) > 2139095040u;
    return is_nan ? 0.0 : metal::clamp(kappa, -10000.0, 10000.0);
}

metal::float3 tensor_safe(
    metal::float3 tensor
) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float2 principal_curvatures(
    metal::float3 tensor_1
) {
    float mean = 0.5 * (tensor_1.x + tensor_1.z);
    float spread = metal::length(metal::float2(0.5 * (tensor_1.x - tensor_1.z), tensor_1.y));
    float far = mean + ((mean >= 0.0) ? spread : -(spread));
    float _e26 = divided((tensor_1.x * tensor_1.z) - (tensor_1.y * tensor_1.y), far);
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
    metal::float3 tensor_2,
    metal::float3 normal_1,
    metal::float3 view,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n = camera_from_world * normal_1;
    metal::float3 _e10 = tensor_safe(tensor_2);
    float square_1 = metal::dot(n.xy, n.xy);
    float radial = ((((_e10.x * n.x) * n.x) + (((2.0 * _e10.y) * n.x) * n.y)) + ((_e10.z * n.y) * n.y)) / metal::max(square_1, 0.000001);
    float _e36 = metal::dfdx(radial);
    float _e37 = metal::dfdy(radial);
    metal::float2 change = metal::float2(_e36, _e37);
    metal::float3 v_2 = camera_from_world * view;
    metal::float3 row = metal::dfdy(place);
    float up = ((row - (metal::dot(row, v_2) * v_2)).y >= 0.0) ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(((change.x * n.x) + ((up * change.y) * n.y))) * metal::rsqrt(metal::max(square_1, 0.000001));
    float pixels = (1.5 * height) / 1000.0;
    float distance = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float x_7 = (toward_eye * height) * 0.05;
    float _e79 = bounded(x_7);
    float _e82 = footprint_of(x_7);
    float strength = metal::clamp(0.5 + ((_e79 - 22.0) / metal::length(metal::float2(metal::min(_e82, 1000000000000000.0), 22.0))), 0.0, 1.0);
    return (metal::clamp((pixels + 0.5) - distance, 0.0, metal::min(pixels, 1.0)) * strength) * metal::smoothstep(0.05, 0.3, metal::dot(normal_1, view));
}

float faded_in(
    float x_6,
    float limit_1,
    float softness_1
) {
    float _e3 = footprint_of(x_6);
    float width_2 = metal::length(metal::float2(metal::min(_e3, 1000000000000000.0), 45.0));
    float _e9 = bounded(x_6);
    float _e12 = bounded(_e9 - 45.0);
    return metal::clamp(0.5 + (_e12 / width_2), 0.0, 1.0);
}

float outer_contour(
    float width_1,
    metal::float3 normal_2,
    metal::float3 view_1,
    metal::float2 viewport_1
) {
    float facing = metal::clamp(metal::dot(normal_2, view_1), 0.0, 1.0);
    float pixels_1 = (5.0 * metal::clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0;
    float _e16 = footprint_of_2_(facing);
    float distance_1 = facing / metal::max(2.0 * _e16, 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp((pixels_1 + 0.5) - distance_1, 0.0, metal::min(pixels_1, 1.0)) * near;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    metal::float3 _e3 = normalize_or(surface_1.smooth_normal_4_, surface_1.normal);
    Light _e6 = look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    float _e9 = footprint_of_2_(_e7);
    Color _e10 = ramp_at(three_washes, _e7, _e9);
    metal::float3 _e12 = tensor_safe(surface_1.curvature_tensor);
    metal::float2 _e13 = principal_curvatures(_e12);
    float _e18 = faded_in(-(_e13.y), 45.0, 1.0);
    float hollows = _e18 * metal::smoothstep(0.05, 0.3, metal::dot(surface_1.normal, surface_1.view));
    metal::float4 hollows_in_sepia = metal::mix(_e10, metal::float4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    metal::float3x3 _e40 = look.camera_from_world;
    metal::float2 _e44 = look.viewport;
    float _e45 = inner_contour_suggestive(3.0, 22.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e40, surface_1.position_camera, _e44);
    metal::float2 _e51 = look.viewport;
    float _e52 = outer_contour(5.0, surface_1.normal, surface_1.view, _e51);
    float all_lines = metal::max(_e45, _e52);
    metal::float4 output = metal::mix(hollows_in_sepia, metal::float4(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return output;
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
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_2.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    Varyings _e22 = out;
    const auto _tmp = _e22;
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
    Surface surface = {};
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_3 = is_front ? _e3 : -(_e3);
    surface.normal = normal_3;
    metal::float4 _e11 = view_2.eye;
    float _e16 = view_2.eye.w;
    surface.view = metal::normalize(_e11.xyz - (_e16 * in.position));
    metal::float4x4 _e24 = view_2.camera_from_world;
    surface.position_camera = (_e24 * metal::float4(in.position, 1.0)).xyz;
    metal::float4 _e36 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    surface.curvature_tensor = _e36.xyz;
    metal::float4 _e44 = smooth_normal_4_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e50 = view_2.camera_from_world;
    surface.smooth_normal_4_ = (metal::float4(_e44.xyz, 0.0) * _e50).xyz;
    Surface _e53 = surface;
    metal::float4 _e54 = shade(_e53, look);
    return fs_mainOutput { _e54 };
}
