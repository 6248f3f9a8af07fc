// Walls: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// room-walls.json says what to put there and how to draw.
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
    metal::float3 rim_position;
    metal::float3 rim_aim;
    metal::float3x3 rim_own_from_world;
    metal::packed_float3 rim_color;
    float rim_intensity;
    metal::float2 rim_cone;
    metal::float2 rim_fading;
    metal::float3 fill_position;
    metal::float3x3 fill_own_from_world;
    metal::packed_float3 fill_color;
    float fill_intensity;
    metal::float2 fill_fading;
    char _pad12[8];
    metal::float3 sun_direction;
    Light sun;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 position;
};

typedef metal::float4 Color;
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

struct FilteredLight {
    /// The light behind the filter.
    Light light;
    /// The angle for the profile.
    Angle angle;
    char _pad2[8];
};

struct LightParts {
    /// Unit, toward the light, world space.
    metal::float3 direction;
    /// The light's color, opaque.
    Color color;
    /// With the light's distance and cone attenuation; 0 or more.
    float intensity;
    char _pad3[12];
};

struct PlaceInLight {
    /// From 0,0 at the picture's lower left corner to 1,1 at its upper right one, as the light sees
    /// it.
    metal::float2 uv;
    /// 1 within the picture, 0 outside of it.
    float inside;
    char _pad2[4];
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
    metal::float3 normal;
};

constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape lamps_rim_tone_shape = ProfileShape {0.9950042, 0.099833414, 1.5805954,
    1.2600908, 0.2, 0.82074726, 0.32190663, 0u};
constant ProfileShape sun_tone_shape = ProfileShape {0.7960838, 0.6051864, 7.4299555, 2.1069195,
    1.3, 0.14104924, 0.05909888, 0u};

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!((largest > 0.000000000000000000000000000001)
        & (largest < 1000000000000000000000000000000.0))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
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

/// [`bounded`], component by component.
metal::float4 bounded_vec4(
    metal::float4 v
) {
    metal::uint4 bits = as_type<metal::uint4>(v);
    metal::uint4 magnitude = bits & metal::uint4(2147483647u);
    metal::float4 largest = as_type<metal::float4>((bits & metal::uint4(2147483648u))
        | metal::uint4(2139095039u));
    metal::float4 numbers = metal::select(metal::float4(0.0), largest,
        magnitude == metal::uint4(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint4(2139095040u));
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(
    float x,
    float low,
    float high
) {
    float span = high - low;
    if (span < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(
    float x,
    float low,
    float high
) {
    float t = metal::clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return metal::sqrt(metal::dot(d, d));
}

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
Color limit_color(
    Color color,
    float limit,
    float softness
) {
    float knee = 1.0 - softness;
    float brightest = metal::max(metal::max(color.x, color.y), color.z);
    if (brightest <= knee) {
        return metal::float4(color.xyz, 1.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + metal::min(above, room) * (metal::max(above, room) / (above + room));
    return metal::float4(color.xyz * metal::min(pressed / brightest, 1.0), 1.0);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 leaning = metal::cross(up, toward);
    float square = metal::dot(leaning, leaning);
    metal::float3 aside = metal::abs(toward.x)
        > 0.7 ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = square > 0.00000001 ? leaning : metal::cross(aside, toward);
    metal::float3 x = normalize_moderate(across - metal::dot(across, toward) * toward,
        metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(x, metal::cross(toward, x), toward);
}

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
metal::float3x3 axes_turned(
    metal::float3 toward,
    float spin
) {
    metal::float3x3 axes = axes_around(toward, metal::float3(0.0, 1.0, 0.0));
    metal::float2 turn = metal::float2(0.0, 1.0);
    return metal::float3x3(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// A place as seen from a center along axes, within a million of it.
metal::float3 place_along(
    metal::float3 place,
    metal::float3 center,
    metal::float3x3 axes
) {
    metal::float3 away = metal::clamp(place - center, metal::float3(-1000000.0),
        metal::float3(1000000.0));
    return metal::float3(metal::dot(away, axes[0]), metal::dot(away, axes[1]),
        metal::dot(away, axes[2]));
}

/// The share of a light that passes a shape at distance m, 1 on its surface, in sizes of the shape:
/// its edge is `softness` wide outward, and never narrower than a pixel. Call it in uniform control
/// flow.
float share_beside(
    float m,
    float softness,
    float density,
    bool inverted
) {
    float half_ = 0.5 * metal::min(footprint_of(m), 0.25);
    float beside = eased(m, 1.0 - half_, 1.0 + half_);
    return 1.0 - beside;
}

/// Attenuation at `distance`: 1 / (1 + (d / half)^2), ended smoothly at the range by (1 - (d /
/// range)^4)^2. A half distance or range of 0 leaves its factor out.
float light_fading(
    float distance,
    metal::float2 fading
) {
    float left = 1.0;
    if (fading.x > 0.0) {
        float d = metal::min(distance / fading.x, 1000000000000000.0);
        left = 1.0 / (1.0 + d * d);
    }
    if (fading.y > 0.0) {
        float d_1 = metal::min(distance / fading.y, 1.0);
        float window = metal::max(1.0 - d_1 * d_1 * d_1 * d_1, 0.0);
        left = left * (window * window);
    }
    return left;
}

/// A light at `light_position` seen from `position`, both in world space; `fading` is half distance
/// and range.
Light light_at(
    metal::float3 light_position,
    metal::float3x3 own_from_world,
    metal::float3 color,
    float intensity,
    metal::float2 fading,
    metal::float3 position
) {
    metal::float3 offset = light_position - position;
    metal::float3 direction = normalize_or(offset, metal::float3(0.0, 0.0, 1.0));
    float faded = intensity * light_fading(metal::length(offset), fading);
    return Light {direction, own_from_world * direction, color, faded};
}

/// Attenuation at an angle from a spot light's aim: smoothstep between the cosines `cone.y` (outer)
/// and `cone.x` (inner); a hard, inclusive edge where they are equal.
float light_cone(
    float cos_angle,
    metal::float2 cone
) {
    if (cone.x <= cone.y) {
        return cos_angle >= cone.y ? 1.0 : 0.0;
    }
    float t = metal::clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Light light_spot(
    metal::float3 light_position,
    metal::float3 aim,
    metal::float3x3 own_from_world,
    metal::float3 color,
    float intensity,
    metal::float2 cone,
    metal::float2 fading,
    metal::float3 position
) {
    Light light = {};
    light = light_at(light_position, own_from_world, color, intensity, fading, position);
    light.intensity = light.intensity * light_cone(metal::dot(-light.direction, aim), cone);
    return light;
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

PlaceInLight place_in_light(
    metal::float2 at
) {
    metal::float2 near = metal::clamp(at, metal::float2(-1000.0), metal::float2(1000.0));
    float inside = share_beside(metal::max(metal::abs(near.x), metal::abs(near.y)), 0.0, 1.0, true);
    return PlaceInLight {metal::float2(0.5) + 0.5 * metal::float2(-near.x, near.y), inside};
}

Angle parametrization_diffuse_balanced(
    Light light,
    metal::float3 normal
) {
    return Angle {0.5 * metal::length(normal - light.direction), 0.5
        * metal::length(normal + light.direction)};
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

/// Window
///
/// Four panes of a window: 1 through the glass, 0 at its bars and beyond.
float window(
    metal::float2 uv,
    float bars,
    float softness
) {
    metal::float2 from_edge = metal::float2(0.5) - metal::abs(uv - metal::float2(0.5));
    metal::float2 from_cross = metal::abs(uv - metal::float2(0.5));
    metal::float2 within = metal::smoothstep(metal::float2(bars), metal::float2(bars + softness),
        from_edge);
    metal::float2 beside = metal::smoothstep(metal::float2(0.5 * bars),
        metal::float2(0.5 * bars + softness), from_cross);
    return within.x * within.y * beside.x * beside.y;
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Lamps rim (Lamps)
    Light rim = light_spot(look.rim_position, look.rim_aim, look.rim_own_from_world,
        metal::float3(look.rim_color), look.rim_intensity, look.rim_cone, look.rim_fading,
        surface.position);
    LightParts rim_2 = LightParts {rim.direction, metal::float4(rim.color, 1.0), rim.intensity};
    metal::float4 lamps_rim_strength = bounded_vec4(rim_2.color
        * metal::float4(metal::float3(rim_2.intensity), 1.0));
    Angle lamps_rim_angle = parametrization_diffuse_balanced(rim, surface.normal);
    float lamps_rim_tone = profile_balanced(lamps_rim_angle, 0.0, lamps_rim_tone_shape);
    metal::float4 lamps_rim_lit = bounded_vec4(lamps_rim_strength
        * metal::float4(metal::float3(lamps_rim_tone), 1.0));

    // Lamps fill (Lamps)
    Light fill = light_at(look.fill_position, look.fill_own_from_world,
        metal::float3(look.fill_color), look.fill_intensity, look.fill_fading, surface.position);
    LightParts fill_2 = LightParts {fill.direction, metal::float4(fill.color, 1.0), fill.intensity};
    metal::float4 lamps_fill_strength = bounded_vec4(fill_2.color
        * metal::float4(metal::float3(fill_2.intensity), 1.0));
    Angle lamps_fill_angle = parametrization_diffuse_balanced(fill, surface.normal);
    float lamps_fill_tone = profile_balanced(lamps_fill_angle, 0.0, lamps_rim_tone_shape);
    metal::float4 lamps_fill_lit = bounded_vec4(lamps_fill_strength
        * metal::float4(metal::float3(lamps_fill_tone), 1.0));
    metal::float3 bounded_vec3_value = bounded_vec3(metal::float3(0.0) + lamps_fill_lit.xyz);
    metal::float4 lamps_fill_sum = fill_2.intensity
        > 0.0 ? metal::float4(bounded_vec3_value, 1.0) : metal::float4(0.0, 0.0, 0.0, 1.0);
    metal::float3 bounded_vec3_value_1 = bounded_vec3(lamps_fill_sum.xyz + lamps_rim_lit.xyz);

    // Lamps rim
    metal::float4 lamps_rim_sum = rim_2.intensity
        > 0.0 ? metal::float4(bounded_vec3_value_1, 1.0) : lamps_fill_sum;

    metal::float4 lamplit = lamps_rim_sum * metal::float4(0.62, 0.55, 0.6, 1.0);
    metal::float4 night = lamplit + metal::float4(0.07, 0.055, 0.11, 1.0);
    // Base
    metal::float4 ground = metal::float4(night.xyz, 1.0);
    Angle sun_angle = parametrization_diffuse_balanced(look.sun, surface.normal);
    metal::float3 place_along_value = place_along(surface.position, metal::float3(0.1, -0.05, 0.0),
        axes_turned(-look.sun_direction, 0.0));
    PlaceInLight thrown = place_in_light(place_along_value.xy / metal::float2(0.95));
    float window_2 = window(thrown.uv, 0.05, 0.02);
    // Light filter
    FilteredLight filter_2 = FilteredLight {Light {look.sun.direction, look.sun.own_direction,
        metal::float3(look.sun.color), look.sun.intensity * metal::min(window_2, 1.0)}, sun_angle};
    float sun_tone = profile_balanced_2(filter_2.angle, 0.0, sun_tone_shape);
    LitLayer sun_lit = light_apply(filter_2.light, metal::float4(0.62, 0.55, 0.6, 1.0), sun_tone);
    // Blend
    metal::float4 stack = metal::clamp(metal::float4(ground.xyz + sun_lit.tone * sun_lit.color.xyz,
        1.0), metal::float4(0.0), metal::float4(1.0));
    return limit_color(stack, 1.0, 0.3);
}

struct vs_mainInput {
    metal::float3 position_2 [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_2, varyings.normal_1 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_2 [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position_2, varyings_1.normal_1 };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, in.position};
    return fs_mainOutput { shade(surface, look) };
}
