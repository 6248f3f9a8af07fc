// Grisaille and glaze: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// glaze.json says what to put there and how to draw.
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
    Light key;
    Light back;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::packed_float3 position_object;
    float kappa;
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

struct LitLayer {
    /// The color under this light.
    Color color;
    /// The tone under this light.
    float tone;
    char _pad2[12];
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

struct VectorParts {
    /// The first number.
    float x;
    /// The second number.
    float y;
    /// The third number.
    float z;
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

constant ProfileShape gray_modeling_tone_shape = ProfileShape {1.0, 0.0, 1.0537579, 1.3909147, 0.0,
    1.2772532, 0.561292, 0u};
constant ProfileShape gray_lights_tone_shape = ProfileShape {0.99875027, 0.04997917, 2.0858297,
    3.3126261, 0.1, 0.42646712, 0.19445144, 0u};

/// v with 0 for each component that is NaN or infinite.
metal::float4 finite_vec4(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

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

/// [`bounded`], component by component.
metal::float3 bounded_vec3(
    metal::float3 v
) {
    metal::uint3 bits = as_type<metal::uint3>(v);
    metal::uint3 magnitude = bits & metal::uint3(2147483647u);
    metal::float3 largest = as_type<metal::float3>((bits & metal::uint3(2147483648u))
        | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest,
        magnitude == metal::uint3(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint3(2139095040u));
}

/// [`mixed`], component by component.
metal::float3 mixed_vec3(
    metal::float3 a,
    metal::float3 b,
    float t
) {
    metal::float3 d = bounded_vec3(b - a);
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return metal::sqrt(metal::dot(d, d));
}

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
float soft_light(
    float a,
    float b
) {
    float curved = a <= 0.25 ? ((16.0 * a - 12.0) * a + 4.0) * a : metal::sqrt(metal::max(a, 0.0));
    return a + (2.0 * b - 1.0) * (curved - a);
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
metal::float4 color_mixed(
    metal::float4 a,
    metal::float3 blended,
    float factor
) {
    metal::float3 b = bounded_vec3(blended);
    return metal::float4(bounded_vec3(b - (1.0 - factor) * bounded_vec3(b - a.xyz)), 1.0);
}

/// Lightness of a color in the non-separable modes (W3C Compositing and Blending 1, Lum).
float lightness_of(
    metal::float3 rgb
) {
    return metal::dot(rgb, metal::float3(0.3, 0.59, 0.11));
}

/// `rgb` as light as `other`, drawn toward its gray where a component would leave [0, 1] (SetLum,
/// ClipColor).
metal::float3 lit_as(
    metal::float3 rgb,
    metal::float3 other
) {
    float light = lightness_of(other);
    metal::float3 moved = rgb + metal::float3(light - lightness_of(rgb));
    float least = metal::min(metal::min(moved.x, moved.y), moved.z);
    float largest = metal::max(metal::max(moved.x, moved.y), moved.z);
    float raised = least < 0.0 ? light / metal::max(light - least, 0.000001) : 1.0;
    metal::float3 clipped = metal::float3(light) + (moved - metal::float3(light)) * raised;
    // If both ends lie outside, the upper one is measured after the lower one was drawn in.
    float top = light + (largest - light) * raised;
    float lowered = top > 1.0 ? (1.0 - light) / metal::max(top - light, 0.000001) : 1.0;
    return metal::float3(light) + (clipped - metal::float3(light)) * lowered;
}

/// Hue of b with the saturation and lightness of a; both counted from 0 to 1.
metal::float3 hued(
    metal::float3 a,
    metal::float3 b
) {
    metal::float3 below = metal::clamp(bounded_vec3(a), metal::float3(0.0), metal::float3(1.0));
    metal::float3 lit_as_value = lit_as((b - metal::float3(b.y))
        * ((metal::max(metal::max(below.x, below.y), below.z)
        - metal::min(metal::min(below.x, below.y), below.z)) / (b.x - b.y)), below);
    return lit_as_value;
}

Color mix_colors_screen(
    Color a,
    Color b,
    float factor
) {
    return metal::float4(mixed_vec3(bounded_vec3(a.xyz),
        bounded_vec3(a.xyz + b.xyz - a.xyz * b.xyz), factor), 1.0);
}

Color mix_colors_soft_light(
    Color a,
    Color b,
    float factor
) {
    float soft_light_value = soft_light(a.x, b.x);
    float soft_light_value_1 = soft_light(a.y, b.y);
    return color_mixed(a, metal::float3(soft_light_value, soft_light_value_1, a.z
        - (1.0 - 2.0 * b.z) * a.z * (1.0 - a.z)), factor);
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + tone * (color.xyz - below.xyz), 1.0),
        metal::float4(0.0), metal::float4(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(
    Light light,
    Color color,
    float tone
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0),
        metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4(color.xyz * light.color * split.y, 1.0), tone * split.x};
}

Angle parametrization_specular_balanced(
    Light light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d = 2.0 * metal::dot(normal, view) * normal - view;
    return Angle {0.5 * metal::length(d - light.direction), 0.5
        * metal::length(d + light.direction)};
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(
    Angle u,
    float w,
    ProfileShape shape
) {
    metal::float2 place = metal::float2(u.half_sin * shape.half_cos_offset - u.half_cos
        * shape.half_sin_offset, u.half_cos * shape.half_cos_offset + u.half_sin
        * shape.half_sin_offset);
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

float profile_balanced_2(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
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
    float edge = metal::max(width * softness, metal::min(footprint_of(facing), 1.0));
    metal::float3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * metal::dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light.direction - metal::dot(light.direction, view) * view;
    float side = metal::dot(normal - metal::dot(normal, view) * view, across
        * metal::rsqrt(metal::max(metal::dot(across, across), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Gray modeling (Light layer)
    Angle gray_modeling_angle = Angle {0.5 * metal::length(surface.normal - look.key.direction),
        0.5 * metal::length(surface.normal + look.key.direction)};
    float gray_modeling_tone = profile_balanced(gray_modeling_angle, 0.0, gray_modeling_tone_shape);
    LitLayer gray_modeling_lit = light_apply(look.key, metal::float4(0.7059, 0.7059, 0.7059, 1.0),
        gray_modeling_tone);
    Composite gray_modeling_blend = blend_alpha(metal::float4(0.1216, 0.1216, 0.1216, 1.0),
        gray_modeling_lit.color, gray_modeling_lit.tone, 1.0, true);

    // Gray lights (Light layer)
    Angle gray_lights_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    float gray_lights_tone = profile_balanced_2(gray_lights_angle, 0.0, gray_lights_tone_shape);
    LitLayer gray_lights_lit = light_apply(look.key, metal::float4(0.2902, 0.2902, 0.2902, 1.0),
        gray_lights_tone);
    metal::float4 gray_lights_blend = metal::clamp(metal::float4(gray_modeling_blend.xyz
        + gray_lights_lit.tone * gray_lights_lit.color.xyz, 1.0), metal::float4(0.0),
        metal::float4(1.0));

    // Set alpha
    metal::float4 grisaille = metal::float4(gray_lights_blend.xyz, 1.0);
    metal::float3 lit_as_value = lit_as(metal::float3(0.4275, 0.5412, 0.4471), grisaille.xyz);
    metal::float4 glaze_of_green_earth = metal::float4(metal::mix(grisaille.xyz, lit_as_value,
        0.75), 1.0);
    metal::float3 lit_as_value_1 = lit_as(metal::float3(0.7098, 0.4667, 0.3098), grisaille.xyz);
    metal::float4 glaze_of_sienna = metal::float4(metal::mix(grisaille.xyz, lit_as_value_1, 0.7),
        1.0);
    metal::float3 place = surface.position_object;
    VectorParts height = VectorParts {surface.position_object[0], surface.position_object[1],
        surface.position_object[2]};
    float toward_the_head = metal::smoothstep(-0.5, 0.5, height.y);
    metal::float4 from_green_to_sienna = metal::mix(glaze_of_green_earth, glaze_of_sienna,
        toward_the_head);
    Color warm_light = mix_colors_soft_light(from_green_to_sienna,
        metal::float4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float curvature = surface.kappa;
    // Curvature transition
    float bulge = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.06, -20.0, 20.0))));
    float hollows = metal::mix(0.6, 0.0, metal::min((bulge - 0.0) / 0.55, 1.0));
    metal::float3 hued_value = hued(warm_light.xyz, metal::float3(0.4902, 0.2471, 0.3608));
    // Mix colors
    metal::float4 wine_in_the_hollows = metal::float4(mixed_vec3(bounded_vec3(warm_light.xyz),
        hued_value, metal::max(hollows, 0.0)), 1.0);
    float rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.6, 1.0);
    Color cool_edge = mix_colors_screen(wine_in_the_hollows,
        metal::float4(0.4353, 0.5294, 0.6588, 1.0), rim_2);
    return finite_vec4(cool_edge);
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_2 [[user(loc2), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.position_object,
        varyings_1.normal_2 };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, texel.x};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
