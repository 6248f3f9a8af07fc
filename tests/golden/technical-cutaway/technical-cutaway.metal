// Technical cutaway: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// technical-cutaway.json says what to put there and how to draw.
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
    Light eye;
    metal::float3x3 camera_from_world;
    Light key;
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

struct Shaded {
    metal::float4 value;
    metal::float4 color;
    float cutoff;
    char _pad3[12];
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

constant ProfileShape metal_tone_shape = ProfileShape {0.99820054, 0.059964005, 7.166244, 3.1997643,
    0.12, 0.124456726, 0.0556771, 0u};
constant ProfileShape contour_tone_shape = ProfileShape {0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0,
    0.0, 1u};

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

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
metal::float2 sin_cos_quick(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 0.0000026347564))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (0.00002477458 - y * 0.00000026297516))));
    return metal::float2(s, c);
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
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    metal::float2 upper = c <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    metal::float2 turned = ((s <= 0.0) & (s < c)) ? metal::float2(0.0, 1.0) : upper;
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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
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
    if (w < 0.000000000000000000000000000001) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return metal::clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Premultiplied RGBA of a straight color.
Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
Color curvature_color(
    float convexity,
    Color convex,
    Color concave
) {
    return concave + convexity * (convex - concave);
}

float transition_balanced(
    float kappa,
    float slope
) {
    return 0.5 + 0.5 * (1.0 - 2.0 / (1.0
        + metal::exp2(2.88539 * metal::clamp(kappa * slope, -20.0, 20.0))));
}

Composite blend_alpha(
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
Color output(
    Composite color
) {
    return finite_vec4(straight(color));
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
    return LitLayer {metal::float4(color.xyz * light.color * split.y, 1.0), split.x};
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply_2(
    Light light,
    Color color,
    float tone
) {
    metal::float2 split = metal::float2(metal::min(light.intensity, 1.0),
        metal::max(light.intensity, 1.0));
    return LitLayer {metal::float4(light.color * split.y, 1.0), tone * split.x};
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

Angle parametrization_screen_aligned_balanced(
    Light light,
    metal::float3 normal,
    metal::float3x3 camera_from_world
) {
    metal::float3 d = camera_from_world * normal;
    return Angle {0.5 * metal::length(d - light.own_direction), 0.5
        * metal::length(d + light.own_direction)};
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : metal::pow(metal::max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(
    float s,
    float w,
    ProfileShape shape
) {
    float width = metal::sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = metal::clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 0.0000004 ? 1.0 : 0.0) : ramp;
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick_2(
    float s,
    float w,
    ProfileShape shape
) {
    float width = metal::sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = metal::clamp(0.5 + (0.0 - from_offset) / metal::max(width, 0.000001), 0.0, 1.0);
    return w <= 0.0 ? (s <= 0.0000004 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(
    Angle u,
    float w,
    ProfileShape shape
) {
    metal::float2 place = metal::float2(u.half_sin * shape.half_cos_offset - u.half_cos
        * shape.half_sin_offset, u.half_cos * shape.half_cos_offset + u.half_sin
        * shape.half_sin_offset);
    bool is_narrow = (w > 0.0) & (w >= 3.4641016 * shape.edge_deviation);
    if (is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
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
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// Cool to warm
///
/// Technical illustration's shading: from a cool color on the far side to a warm one toward the
/// light, so that outlines and highlights, which are darker and lighter, stay readable everywhere.
Color gooch(
    Light light,
    metal::float3 normal,
    Color color,
    Color cool,
    Color warm,
    float cool_amount,
    float warm_amount
) {
    float t = 0.5 + 0.5 * metal::dot(normal, light.direction);
    metal::float3 far = cool.xyz + cool_amount * color.xyz;
    metal::float3 near = warm.xyz + warm_amount * color.xyz;
    return metal::float4(metal::mix(far, near, metal::clamp(t, 0.0, 1.0)), 1.0);
}

/// The look at one point of the surface.
Shaded shade(
    Surface surface,
    constant Look& look
) {
    Color cool_to_warm = gooch(look.key, surface.normal, metal::float4(0.8314, 0.8392, 0.8549, 1.0),
        metal::float4(0.1725, 0.2902, 0.4863, 1.0), metal::float4(0.4196, 0.3529, 0.1961, 1.0),
        0.35, 0.6);
    // Blend
    metal::float4 cool_to_warm_2 = metal::float4(metal::float3(1.0)
        + (cool_to_warm.xyz - metal::float3(1.0)), 1.0);

    // Hollows (Light layer)
    float hollows_convexity = transition_balanced(surface.kappa, 0.25);
    Color hollows_color = curvature_color(hollows_convexity, metal::float4(1.0),
        metal::float4(0.5412, 0.5804, 0.6588, 1.0));
    LitLayer hollows_lit = light_apply(look.key, hollows_color, 1.0);
    metal::float4 hollows_blend = metal::clamp(metal::float4(cool_to_warm_2.xyz + 0.8
        * (cool_to_warm_2.xyz * (hollows_lit.tone * hollows_lit.color.xyz) - cool_to_warm_2.xyz),
        1.0), metal::float4(0.0), metal::float4(1.0));

    // Metal (Light layer)
    Angle metal_angle = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    float metal_warp = (2.0 * transition_balanced(surface.kappa, 0.2) - 1.0) * 0.05;
    float metal_tone = profile_balanced(metal_angle, metal_warp, metal_tone_shape);
    LitLayer metal_lit = light_apply_2(look.key, metal::float4(1.0), metal_tone);
    Composite metal_blend = blend_alpha(hollows_blend, metal_lit.color, metal_lit.tone, 0.8, true);

    // Contour (Light layer)
    Angle contour_angle = parametrization_screen_aligned_balanced(look.eye, surface.normal,
        look.camera_from_world);
    float contour_warp = (2.0 * transition_balanced(surface.kappa, 0.12) - 1.0) * 0.25;
    float contour_tone = profile_balanced_2(contour_angle, contour_warp, contour_tone_shape);
    LitLayer contour_lit = light_apply_2(look.eye, metal::float4(1.0), contour_tone);
    metal::float4 contour_blend = metal::clamp(metal::float4(metal_blend.xyz
        * (contour_lit.tone * contour_lit.color.xyz), 1.0), metal::float4(0.0), metal::float4(1.0));

    metal::float3 place = surface.position_object;
    VectorParts parts = VectorParts {surface.position_object[0], surface.position_object[1],
        surface.position_object[2]};
    float into_the_corner = metal::min(parts.x, parts.z);
    float footprint_of_value = footprint_of(into_the_corner);
    // Threshold
    float section = step_filtered(into_the_corner, -0.012,
        metal::length(metal::float2(metal::min(footprint_of_value, 1000000000000000.0), 0.0)));
    metal::float4 section_line = metal::clamp(metal::float4(contour_blend.xyz + section
        * (metal::float3(0.8471, 0.1569, 0.1098) - contour_blend.xyz), 1.0), metal::float4(0.0),
        metal::float4(1.0));
    float footprint_of_value_1 = footprint_of(into_the_corner);
    // Threshold
    float taken_out = step_filtered(into_the_corner, 0.02,
        metal::length(metal::float2(metal::min(footprint_of_value_1, 1000000000000000.0), 0.0)));
    float kept = 1.0 - taken_out;
    // Set alpha
    metal::float4 cut = metal::float4(section_line.xyz, kept);
    Color output_2 = output(premultiplied(cut));
    return Shaded {output_2, output_2, 0.5};
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_3 };
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
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.position_object,
        varyings_1.normal_3 };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, texel.x};
    Shaded shaded = shade(surface, look);
    if (shaded.color.w < shaded.cutoff) {
        metal::discard_fragment();
    }
    return fs_mainOutput { finite_vec4(shaded.value) };
}
