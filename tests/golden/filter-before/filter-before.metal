// A filter before the profile: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// filter-before.json says what to put there and how to draw.
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

/// What is known before the fragment.
struct Look {
    metal::float3 lamp_position;
    metal::float3 lamp_aim;
    metal::float3x3 lamp_own_from_world;
    metal::packed_float3 lamp_color;
    float lamp_intensity;
    metal::float2 lamp_cone;
    metal::float2 lamp_fading;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 position;
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

struct Cell {
    /// The distance to the nearest border, in cells.
    float border;
    /// A random number of the cell, in [0, 1).
    float random;
    /// The distance to the cell's point.
    float distance;
};

struct Cells {
    /// The distance to the nearest border, in cells: 0 at it, rarely above 0.3.
    float border;
    /// A number from 0 to 1 that is the same all over a cell.
    float random;
    /// The distance to the cell's middle, in cells.
    float distance;
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
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
/// The farthest that anything counts as from a shape, in sizes of the shape.
constant float FAR_FROM_SHAPE = 1000.0;
/// Least distance of the point of a cell that is no neighbor, in cells: points keep a quarter of a
/// cell from their cell's sides.
constant float CELL_REACH = 1.25;
constant ProfileShape tone_shape = ProfileShape {0.87758255, 0.47942555, 20.008335, 2.4978132, 1.0,
    0.04909103, 0.021148764, 0u};

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

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
metal::float2 sin_cos_eighth(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y
        * (0.008333334 + y * (-0.0001984127 + y * 0.0000027557319))));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y
        * (0.0013888889 + y * (-0.000024801588 + y * 0.0000002755732))));
    return metal::float2(s, c);
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

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
float atan2_positive(
    float y,
    float x
) {
    float small = metal::min(y, x);
    float large = metal::max(y, x);
    if (large <= 0.0) {
        return 0.0;
    }
    float t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    bool is_wide = t > 0.41421357;
    float r = is_wide ? (small - large) / (small + large) : t;
    float r2 = r * r;
    float series = r * (1.0 + r2 * (-0.33333334 + r2
        * (0.2 + r2 * (-0.14285715 + r2
        * (0.11111111 + r2 * (-0.09090909 + r2
        * (0.07692308 + r2 * (-0.06666667 + r2 * 0.05882353))))))));
    float a = is_wide ? series + 0.7853982 : series;
    return y > x ? HALF_PI - a : a;
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
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + 0.0;
    metal::float2 upper = c <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, c);
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
    float t = metal::clamp(place_between(bounded(x), low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
float angle_of_point(
    float y,
    float x
) {
    metal::float2 p = metal::abs(metal::float2(x, y));
    metal::float2 scaled = metal::max(p.x, p.y) > 1.0 ? 0.5 * p : p;
    float a = atan2_positive(scaled.y, scaled.x);
    float turned = x < 0.0 ? PI - a : a;
    return y < 0.0 ? -turned : turned;
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return bounded(metal::sqrt(metal::dot(d, d)));
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
metal::float2 footprint_of_vec2(
    metal::float2 v
) {
    metal::float2 dx = metal::dfdx(v);
    metal::float2 dy = metal::dfdy(v);
    return metal::sqrt(dx * dx + dy * dy);
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(
    metal::float3 v
) {
    metal::float3 dx = metal::dfdx(v);
    metal::float3 dy = metal::dfdy(v);
    return metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy)));
}

/// Relative luminance by the Rec. 709 weights, of the numbers as they stand.
float luminance(
    Color color
) {
    return metal::dot(color.xyz, metal::float3(0.2126, 0.7152, 0.0722));
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

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
Composite blend_add(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + (below.xyz + tone * color.xyz - below.xyz), 1.0),
        metal::float4(0.0), metal::float4(1.0));
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

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
metal::float3x3 axes_turned_2(
    metal::float3 toward,
    float spin
) {
    metal::float3x3 axes = axes_around(toward, metal::float3(0.0, 1.0, 0.0));
    metal::float2 turn = metal::clamp(sin_cos_eighth(spin - 0.0 - 0.0 - 0.0), metal::float2(-1.0),
        metal::float2(1.0));
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
    float near = metal::min(m, FAR_FROM_SHAPE);
    float half_ = 0.5 * metal::min(footprint_of(near), 0.25);
    float beside = eased(near, 1.0 - half_, 1.0 + half_);
    return 1.0 - beside;
}

/// The share of a lamp's light that passes between four flaps, for a place as the lamp sees it and
/// the angles to the left, right, top and bottom flap.
float share_of_doors(
    metal::float3 seen,
    metal::float4 flaps,
    float softness
) {
    metal::float2 angles = metal::float2(angle_of_point(seen.x, seen.z),
        angle_of_point(seen.y, seen.z));
    metal::float2 half_ = 0.5 * metal::min(footprint_of_vec2(angles), metal::float2(0.1));
    float aside = (1.0 - metal::smoothstep(flaps.x - half_.x, flaps.x
        + metal::max(softness, half_.x), angles.x))
        * (1.0 - metal::smoothstep(flaps.y - half_.x, flaps.y + metal::max(softness, half_.x),
        -angles.x));
    return aside * (1.0 - metal::smoothstep(flaps.z - half_.y, flaps.z
        + metal::max(softness, half_.y), angles.y))
        * (1.0 - metal::smoothstep(flaps.w - half_.y, flaps.w + metal::max(softness, half_.y),
        -angles.y));
}

/// An angle as a filter before the profile leaves it: tan(u/2) over the share that passes, so that
/// the dark side grows from its edge as less passes, and everything is dark where nothing does.
Angle angle_filtered(
    Angle u,
    float share
) {
    float cosine = u.half_cos * share;
    float square = u.half_sin * u.half_sin + cosine * cosine;
    float scale = metal::rsqrt(metal::max(square, 0.000000000000000000000000000001));
    bool is_dark = square < 0.000000000000000000000000000001;
    return Angle {is_dark ? 1.0 : u.half_sin * scale, is_dark ? 0.0 : cosine * scale};
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

PlaceInLight light_place_point(
    metal::float3 light_position,
    float angle,
    float spin,
    metal::float3 toward,
    metal::float3 position
) {
    metal::float3 seen = place_along(position, light_position, axes_turned_2(toward, spin));
    metal::float2 turn = metal::clamp(sin_cos_eighth(angle - 0.0 - 0.0 - 0.0), metal::float2(-1.0),
        metal::float2(1.0));
    metal::float2 at = seen.xy * (turn.y / turn.x) / metal::float2(metal::max(seen.z, 0.001));
    return place_in_light(seen.z > 0.001 ? at : metal::float2(1000.0));
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

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v = {};
    v = seed * 1664525u + metal::uint3(1013904223u);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> metal::uint3(16u));
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
metal::float3 unit_of_hash(
    metal::uint3 hash
) {
    return static_cast<metal::float3>(hash >> metal::uint3(8u)) * 0.000000059604645;
}

/// The hash of a lattice point.
metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed
) {
    return hash_pcg3d(as_type<metal::uint3>(cell) + seed
        * metal::uint3(2654435769u, 2246822507u, 3266489909u));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - lhs / divisor * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

/// The cell around the nearest of one point per lattice cell, each in the middle half of its own.
///
/// The distance to the border, which lies midway between the two nearest points, ends at (1.25 -
/// distance) / 2: a point that was not looked at is at least 1.25 away, so no border of its is
/// nearer, and a farther border counts as that far.
Cell nearest_cell(
    metal::float3 p,
    uint seed
) {
    metal::float3 nearest = metal::float3(4.0);
    metal::uint3 hash = metal::uint3(0u);
    float border = {};
    metal::float3 corner = metal::floor(p);
    metal::float3 d = p - corner;
    metal::int3 cell = naga_f2i32(corner);
    for (int i = 0; i < 27; i++) {
        metal::int3 at = metal::int3(as_type<int>(as_type<uint>(naga_mod(i, 3)) - as_type<uint>(1)),
            as_type<int>(as_type<uint>(naga_mod(naga_div(i, 3), 3)) - as_type<uint>(1)),
            as_type<int>(as_type<uint>(naga_div(i, 9)) - as_type<uint>(1)));
        metal::uint3 own = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell)
            + as_type<metal::uint3>(at)), seed);
        metal::float3 offset = static_cast<metal::float3>(at) + metal::float3(0.25) + 0.5
            * unit_of_hash(own) - d;
        if (metal::dot(offset, offset) < metal::dot(nearest, nearest)) {
            nearest = offset;
            hash = own;
        }
    }
    float distance = metal::length(nearest);
    border = metal::max(0.5 * (CELL_REACH - distance), 0.0);
    for (int i_1 = 0; i_1 < 27; i_1++) {
        metal::int3 at_1 = metal::int3(as_type<int>(as_type<uint>(naga_mod(i_1, 3))
            - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_mod(naga_div(i_1, 3), 3))
            - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(i_1, 9)) - as_type<uint>(1)));
        metal::uint3 lattice_hash_value = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at_1)),
            seed);
        metal::float3 unit_of_hash_value = unit_of_hash(lattice_hash_value);
        metal::float3 apart = static_cast<metal::float3>(at_1) + metal::float3(0.25) + 0.5
            * unit_of_hash_value - d - nearest;
        float between = metal::length(apart);
        // Points are half a cell apart at least; a nearer one is the cell's own.
        if (between > 0.25) {
            border = metal::min(border, metal::dot(nearest + 0.5 * apart, apart) / between);
        }
    }
    // The number has a hash other than that of the point's place, or it would tell where in its
    // cell the point lies.
    return Cell {metal::max(border, 0.0), unit_of_hash(hash_pcg3d(hash)).x, distance};
}

/// Cells
///
/// Space in pieces with straight borders, each with a number of its own: panes of glass, scales,
/// tiles, cracks. A Threshold of the border draws the seams, a Ramp of the number gives every piece
/// its color.
Cells cells(
    metal::float3 position,
    float scale,
    int seed
) {
    metal::float3 p = bounded_vec3(position * scale);
    Cell cell = nearest_cell(p, 0u);
    float visible = 1.0 - metal::smoothstep(0.5, 1.0, footprint_of_vec3(p));
    metal::float3 average = metal::float3(0.1301, 0.5, 0.491);
    metal::float3 seen = metal::mix(average, metal::float3(cell.border, cell.random, cell.distance),
        visible);
    return Cells {seen.x, seen.y, seen.z};
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light lamp = light_spot(look.lamp_position, look.lamp_aim, look.lamp_own_from_world,
        metal::float3(look.lamp_color), look.lamp_intensity, look.lamp_cone, look.lamp_fading,
        surface.position);
    // Parametrization
    Angle angle = Angle {0.5 * metal::length(surface.normal - lamp.direction), 0.5
        * metal::length(surface.normal + lamp.direction)};
    metal::float3 place_along_value = place_along(surface.position, look.lamp_position,
        axes_turned(look.lamp_aim, 0.0));
    // Barn doors
    float doors = share_of_doors(place_along_value, metal::float4(0.3, 0.36, 0.3, 0.2), 0.02);
    PlaceInLight place = light_place_point(look.lamp_position, 0.4, 0.6, look.lamp_aim,
        surface.position);
    Cells leaves = cells(metal::float3(place.uv, 0.0), 13.0, 0);
    // Combine filters
    float both = doors * metal::smoothstep(0.12, 0.62, leaves.distance);
    // Light filter
    FilteredLight filter_2 = FilteredLight {lamp,
        angle_filtered(angle, both * metal::min(luminance(metal::float4(1.0)), 1.0))};
    float tone = profile_balanced(filter_2.angle, 0.0, tone_shape);
    LitLayer lit = light_apply(filter_2.light, metal::float4(0.93, 0.62, 0.36, 1.0), tone);
    return blend_add(metal::float4(0.13, 0.14, 0.27, 1.0), lit.color, lit.tone, 1.0, true);
}

struct vs_mainInput {
    metal::float3 position_4 [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position_4, varyings.normal };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_4 [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position_4, varyings_1.normal };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, in.position};
    return fs_mainOutput { shade(surface, look) };
}
