// Light where it is wanted: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// local-control.json says what to put there and how to draw.
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
    metal::float3x3 camera_from_world;
    metal::float2 viewport;
    char _pad2[8];
    Light back;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::float3 position_camera;
    metal::float3 curvature_tensor;
};

typedef metal::float4 Color;
typedef metal::float4 Composite;
/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
};

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};

constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape soft_tone_shape = ProfileShape {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985,
    0.68337417, 0u};

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

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
metal::float3 normalize_seen(
    metal::float3 v
) {
    return normalize_moderate(v, metal::float3(0.0, 0.0, 1.0));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(
    Angle u,
    metal::float2 t
) {
    float s = u.half_sin - 0.0;
    metal::float2 upper = u.half_cos
        <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, u.half_cos);
    metal::float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(
    float x,
    float low,
    float high
) {
    float t = metal::clamp(bounded((bounded(x) - low) / (high - low)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
float length_of(
    metal::float3 v
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * metal::length(v / metal::float3(largest)));
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

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::float4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

Composite blend_alpha_2(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), metal::float4(0.0),
        metal::float4(1.0));
}

/// Local light
///
/// Bends a light and changes its strength around a place on the surface, and leaves it as it is
/// elsewhere: light as an artist wants it to fall, where the real one would not.
Light local_light(
    Light light,
    metal::float3 bend,
    float strength,
    metal::float3 center,
    float radius,
    float hardness,
    metal::float3 position
) {
    float weight = 1.0 - eased(length_of(position - center), radius * hardness, radius);
    metal::float3 bent = light.direction + weight * bend;
    metal::float3 normalize_moderate_value = normalize_moderate(bent, light.direction);
    metal::float3 direction = ((metal::dot(bent, bent) > 0.000001)
        & (weight > 0.0)) ? normalize_moderate_value : light.direction;
    return Light {direction, light.own_direction, light.color,
        metal::min(light.intensity, 1000000000000000000000000000000.0)};
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : metal::pow(metal::max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(
    Angle u,
    float w,
    ProfileShape shape
) {
    metal::float2 place = metal::float2(u.half_sin - 0.0, u.half_cos);
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(
    Light light,
    metal::float3 normal,
    metal::float3 view,
    float width,
    float softness,
    float follow
) {
    float facing = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float edge = metal::max(width * softness, metal::min(footprint_of_2(facing), 1.0));
    metal::float3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * metal::dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light.direction - metal::dot(light.direction, view) * view;
    float side = metal::dot(normal - metal::dot(normal, view) * view, across
        * metal::rsqrt(metal::max(metal::dot(across, across), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
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
    float pixels = height / 1000.0;
    float distance = metal::abs(radial) / metal::max(metal::length(change), 0.000001);
    float x = toward_eye * height * 0.05;
    float footprint_of_value = footprint_of(x);
    float strength = metal::clamp(0.5 + (x - limit)
        / metal::length(metal::float2(metal::min(footprint_of_value, 1000000000000000.0), limit
        * softness)), 0.0, 1.0);
    return metal::clamp(pixels + 0.5 - distance, 0.0, metal::min(pixels, 1.0)) * strength
        * metal::smoothstep(0.05, 0.3, metal::dot(normal, view));
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
    Light turned_to_the_face = local_light(look.key, metal::float3(0.9, 0.25, 0.5), 1.0,
        metal::float3(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    Light around_the_belly = local_light(turned_to_the_face, metal::float3(0.4, 0.1, 0.35), 1.0,
        metal::float3(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    // Parametrization
    Angle turned_from_the_light = Angle {0.5
        * metal::length(surface.normal - around_the_belly.direction), 0.5
        * metal::length(surface.normal + around_the_belly.direction)};
    float soft_tone = profile_balanced(turned_from_the_light, 0.0, soft_tone_shape);
    float eased_value = eased(length_of(surface.position_object - metal::float3(0.0, 0.02, 0.45)),
        0.03, 0.3);
    // Local tone
    float shadow_under_the_chin = metal::clamp(soft_tone + (1.0 - eased_value) * -0.45, 0.0, 1.0);
    float eased_value_1 = eased(length_of(surface.position_object - metal::float3(-0.2, 0.72, 0.4)),
        0.085, 0.17);
    // Local tone
    float glint_on_the_brow = metal::clamp(shadow_under_the_chin + (1.0 - eased_value_1) * 0.5, 0.0,
        1.0);
    // Threshold
    float lit = step_filtered(glint_on_the_brow, 0.55,
        metal::length(metal::float2(footprint_of_2(glint_on_the_brow), 0.0)));
    Composite light = blend_alpha(metal::float4(0.36, 0.36, 0.6, 1.0),
        metal::float4(0.96, 0.72, 0.47, 1.0), lit, 1.0, true);
    // Threshold
    float brightest = step_filtered(glint_on_the_brow, 0.97,
        metal::length(metal::float2(footprint_of_2(glint_on_the_brow), 0.0)));
    // Blend
    metal::float4 brightest_light = metal::min(metal::float4(light.xyz + brightest
        * (metal::float3(1.0, 0.93, 0.76) - light.xyz), 1.0), metal::float4(1.0));
    float rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.1, 1.0);
    Composite rim_s_light = blend_alpha_2(brightest_light, metal::float4(0.72, 0.86, 1.0, 1.0),
        rim_2, 0.7, true);
    float folds = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor, surface.normal,
        surface.view, look.camera_from_world, surface.position_camera, look.viewport);
    // Combine tones
    float all_lines = metal::max(outer_contour(3.0, surface.normal, surface.view, look.viewport),
        folds);
    Composite lines = blend_alpha_2(rim_s_light, metal::float4(0.17, 0.13, 0.28, 1.0), all_lines,
        0.85, true);
    return lines;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_3 [[attribute(1)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_3 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_3 [[user(loc2), center_perspective]];
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
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object,
        varyings_1.normal_3 };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, (view.camera_from_world * metal::float4(in.position, 1.0)).xyz,
        texel.xyz};
    return fs_mainOutput { shade(surface, look) };
}
