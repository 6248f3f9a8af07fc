// Contours: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0), smooth_normal_4_map texture(1).
// contours.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    metal::float4 eye;
};

struct Object {
    metal::float4x4 world_from_object;
    /// The inverse transpose, for normals.
    metal::float3x3 world_from_normal;
    float id;
    char _pad3[12];
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    metal::float3 direction;
    /// Unit, toward the light, in the light's own frame.
    metal::float3 own_direction;
    /// Straight RGB.
    metal::packed_float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    metal::float2 viewport;
    char _pad1[8];
    metal::float3x3 camera_from_world;
    Light key;
};

/// The surface under the fragment, in world space.
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

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_7 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_8 places;
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
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
constant Ramp three_washes = Ramp {type_7 {{metal::float4(0.7255, 0.7686, 0.8118, 1.0),
    metal::float4(0.8627, 0.8627, 0.8235, 1.0), metal::float4(0.9725, 0.949, 0.8863, 1.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, type_8 {{metal::float4(0.0, 0.16, 0.42, 0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 3u, 2u};

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return square > 0.000000000000000000000000000001 ? v
        * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001)) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(
    float x
) {
    uint bits = as_type<uint>(x);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// a / b; 0 where b is 0.
float divided(
    float a,
    float b
) {
    if (metal::abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return bounded(metal::sqrt(metal::dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return metal::sqrt(metal::dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(
    float x,
    float edge,
    float w
) {
    float d = x - edge;
    return w < 0.000000000000000000000000000001 ? (d >= 0.0 ? 1.0 : 0.0) : metal::clamp(0.5 + d / w,
        0.0, 1.0);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
Color ramp_at(
    Ramp ramp,
    float x,
    float w
) {
    type_7 colors = {};
    type_8 places = {};
    metal::float4 color = {};
    colors = ramp.colors;
    places = ramp.places;
    color = colors.inner[0];
    for (uint i = 1u; i < 3u; i++) {
        color = color + (colors.inner[i] - colors.inner[i - 1u])
            * step_filtered(x, places.inner[0][naga_mod(i, 4u)], w);
    }
    return color;
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
metal::float2 principal_curvatures(
    metal::float3 tensor
) {
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = metal::length(metal::float2(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    float far = mean + (mean >= 0.0 ? spread : -spread);
    float near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return mean >= 0.0 ? metal::float2(far, near) : metal::float2(near, far);
}

float reflectance_half_lambert(
    Light light,
    metal::float3 normal
) {
    float half_ = 0.5 + 0.5 * metal::dot(normal, light.direction);
    return metal::min(half_ * half_, 1.0);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
float inner_contour_suggestive(
    float width,
    float limit,
    float softness,
    metal::float3 tensor,
    metal::float3 normal,
    metal::float3 view,
    metal::float3x3 camera_from_world,
    metal::float3 place,
    metal::float2 viewport
) {
    metal::float3 n = camera_from_world * normal;
    float square = metal::dot(n.xy, n.xy);
    float radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / metal::max(square, 0.000001);
    metal::float2 change = metal::float2(metal::dfdx(radial), metal::dfdy(radial));
    metal::float3 v = camera_from_world * view;
    metal::float3 row = metal::dfdy(place);
    float up = (row - metal::dot(row, v) * v).y >= 0.0 ? 1.0 : -1.0;
    float height = metal::clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(change.x * n.x + up * change.y * n.y)
        * metal::rsqrt(metal::max(square, 0.000001));
    float pixels = 1.5 * height / 1000.0;
    float distance = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float x = toward_eye * height * 0.05;
    float footprint_of_value = footprint_of(x);
    float strength = metal::clamp(0.5 + (x - limit)
        / metal::length(metal::float2(metal::min(footprint_of_value, 1000000000000000.0), 22.0)),
        0.0, 1.0);
    return metal::clamp(pixels + 0.5 - distance, 0.0, metal::min(pixels, 1.0)) * strength
        * metal::smoothstep(0.05, 0.3, metal::dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
float faded_in(
    float x,
    float limit,
    float softness
) {
    float width = metal::length(metal::float2(metal::min(footprint_of(x), 1000000000000000.0),
        45.0));
    return metal::clamp(0.5 + bounded(bounded(x) - limit) / width, 0.0, 1.0);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
float outer_contour(
    float width,
    metal::float3 normal,
    metal::float3 view,
    metal::float2 viewport
) {
    float facing = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float pixels = width * metal::clamp(viewport.y, 1.0, 100000.0) / 1000.0;
    float distance = facing / metal::max(2.0 * footprint_of_2(facing), 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp(pixels + 0.5 - distance, 0.0, metal::min(pixels, 1.0)) * near;
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 broad_forms = normalize_moderate(surface.smooth_normal_4_, surface.normal);
    float light_and_dark = reflectance_half_lambert(look.key, broad_forms);
    Color three_washes_2 = ramp_at(three_washes, light_and_dark, footprint_of_2(light_and_dark));
    float faded_in_value = faded_in(-principal_curvatures(surface.curvature_tensor).y, 45.0, 1.0);
    // Inner contour
    float hollows = faded_in_value * metal::smoothstep(0.05, 0.3,
        metal::dot(surface.normal, surface.view));
    metal::float4 hollows_in_sepia = metal::mix(three_washes_2,
        metal::float4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    float inner_lines = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor,
        surface.normal, surface.view, look.camera_from_world, surface.position_camera,
        look.viewport);
    float outline = outer_contour(5.0, surface.normal, surface.view, look.viewport);
    float all_lines = metal::max(inner_lines, outline);
    metal::float4 ink = metal::mix(hollows_in_sepia, metal::float4(0.1647, 0.1412, 0.1882, 1.0),
        all_lines);
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
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_3 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
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
, constant View& view [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_4_map [[texture(1)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_3 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_1 = smooth_normal_4_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        (view.camera_from_world * metal::float4(in.position, 1.0)).xyz, texel.xyz,
        (metal::float4(texel_1.xyz, 0.0) * view.camera_from_world).xyz};
    return fs_mainOutput { shade(surface, look) };
}
