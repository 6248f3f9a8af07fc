// A highlight, moved: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// highlight-moves.json says what to put there and how to draw.
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
    Light back;
    Light key;
    float turn_angle;
    float move_x;
    float move_y;
    float stretch_x;
    float stretch_y;
    float split_x;
    float split_y;
    float square_amount;
    metal::float4 body;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
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

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    metal::float3 direction;
    metal::float3 x_axis;
    metal::float3 y_axis;
    /// The direction's cosines with the two axes.
    metal::float2 place;
    char _pad4[8];
};

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    metal::float3 x_axis;
    /// Unit, upright.
    metal::float3 y_axis;
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

constant float HALF_PI = 1.5707964;
constant float LN_2 = 0.6931472;
constant float LOG2_E = 1.442695;
constant ProfileShape lit_side_shape = ProfileShape {0.8109631, 0.58509725, 4.0419726, 5.9230337,
    1.25, 0.17004733, 0.08138281, 0u};
constant ProfileShape highlight_shape = ProfileShape {0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0,
    0.0, 1u};

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

/// v with 0 for each component that is NaN or infinite.
metal::float4 finite_vec4(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
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

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(
    float x
) {
    float clamped = metal::max(x, -126.0);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole))
        + as_type<uint>(126))) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(
    float x
) {
    uint bits = as_type<uint>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return static_cast<float>(exponent) + z
        * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// ln(x) for normal x > 0.
float log_stable(
    float x
) {
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(
    float y
) {
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(
    float y
) {
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return log_stable(metal::max(1.0 - y, 0.000000000000000000000000000000000000011754944));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
metal::float2 sin_cos_quarter(
    float x
) {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (0.0000027557319 + h2 * -0.000000025052108)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-0.000024801588 + h2 * (0.0000002755732 + h2 * -0.0000000020876756)))));
    float c = 1.0 - one_minus_c;
    return metal::float2(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [`sin_cos_quarter`] after reduction to a
/// quarter turn.
metal::float2 sin_cos(
    float x
) {
    float turns = metal::rint(x * 0.31830987);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    float r = x - turns * 3.140625 - turns * 0.00096702576 - turns * 0.00000062783295;
    float sign = 1.0 - 2.0 * metal::abs(turns - 2.0 * metal::trunc(turns * 0.5));
    return sign * sin_cos_quarter(metal::clamp(r, -1.5707964, HALF_PI));
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(
    Angle u,
    metal::float2 t
) {
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + u.half_sin * 0.0;
    metal::float2 upper = c <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, c);
    metal::float2 turned = ((s <= 0.0) & (s < c)) ? metal::float2(0.0, 1.0) : upper;
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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return metal::sqrt(metal::dot(d, d));
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign + n.z);
    return metal::float3(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
DirectionParts direction_within(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis
) {
    metal::float3 y = y_axis * metal::rsqrt(metal::max(metal::dot(y_axis, y_axis),
        0.000000000000000000000000000001));
    return DirectionParts {direction, x_axis, y,
        metal::float2(metal::dot(direction, x_axis), metal::dot(direction, y))};
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
metal::float3 direction_moved(
    DirectionParts parts,
    metal::float2 by
) {
    metal::float2 step = metal::clamp(by, metal::float2(-1000000.0), metal::float2(1000000.0));
    metal::float3 moved = parts.direction + step.x * parts.x_axis + step.y * parts.y_axis;
    metal::float3 normalize_moderate_value = normalize_moderate(moved, parts.direction);
    return metal::dot(moved, moved) > 0.000001 ? normalize_moderate_value : parts.direction;
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
metal::float3 direction_moved_2(
    DirectionParts parts,
    metal::float2 by
) {
    metal::float3 moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    metal::float3 normalize_moderate_value = normalize_moderate(moved, parts.direction);
    return metal::dot(moved, moved) > 0.000001 ? normalize_moderate_value : parts.direction;
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 y = normalize_moderate(up, metal::float3(0.0, 1.0, 0.0));
    metal::float3 leaning = metal::cross(y, toward);
    float square = metal::dot(leaning, leaning);
    metal::float3 aside = metal::abs(toward.x)
        > 0.7 ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = square > 0.00000001 ? leaning : metal::cross(aside, toward);
    metal::float3 x = normalize_moderate(across - metal::dot(across, toward) * toward,
        metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(x, metal::cross(toward, x), toward);
}

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
AxesAround axes(
    metal::float3 direction,
    metal::float3 up
) {
    metal::float3x3 axes_2 = axes_around(direction, up);
    return AxesAround {axes_2[0], axes_2[1]};
}

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
metal::float3 half_vector(
    Light light,
    metal::float3 view
) {
    metal::float3 half_ = light.direction + view;
    metal::float3 any_orthogonal_value = any_orthogonal(view);
    return normalize_or(metal::dot(half_, half_) > 0.000000000001 ? half_ : any_orthogonal_value,
        view);
}

/// Split direction
///
/// Cuts a highlight in two along an axis and moves the halves apart, or in four along both: window
/// panes in an eye.
metal::float3 split_direction(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis,
    float x,
    float y
) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    metal::float2 side = metal::select(metal::float2(-1.0), metal::float2(1.0), bent.place
        >= metal::float2(0.0));
    return direction_moved(bent, -metal::max(metal::float2(x, y), metal::float2(0.0)) * side);
}

/// Square direction
///
/// Gives a highlight corners: from round to a square whose sides lie along the axes.
metal::float3 square_direction(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis,
    float amount,
    float sharpness
) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    float square = metal::dot(bent.place, bent.place);
    float apart = metal::abs(bent.place.x) - metal::abs(bent.place.y);
    float aside = metal::min(apart * apart / metal::max(square, 0.00000000000000000001), 1.0);
    float exp2_stable_value = exp2_stable(sharpness * LOG2_E * log1p_negative(aside));
    float corner = ((square > 0.00000000000000000001) & (aside < 1.0)) ? exp2_stable_value : 0.0;
    return direction_moved_2(bent, -metal::clamp(amount, 0.0, 1.0) * corner * bent.place);
}

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
metal::float3 stretch_direction(
    metal::float3 direction,
    metal::float3 x_axis,
    metal::float3 y_axis,
    float x,
    float y
) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -metal::min(metal::float2(x, y), metal::float2(1.0)) * bent.place);
}

Composite blend_alpha(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    float alpha = below.w + tone * opacity * (1.0 - below.w);
    return metal::clamp(metal::float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), alpha), metal::float4(0.0),
        metal::float4(1.0));
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
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned_2(angle, metal::float2(0.0, 1.0));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
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

/// Rotate vector
///
/// Turns a vector about an axis, counter-clockwise as the axis points at you.
metal::float3 rotate_vector(
    metal::float3 vector,
    metal::float3 axis,
    float angle
) {
    metal::float2 half_ = metal::clamp(sin_cos(0.5 * angle), metal::float2(-1.0),
        metal::float2(1.0));
    metal::float3 aside = metal::cross(axis, vector);
    return bounded_vec3(vector + 2.0 * half_.x
        * (half_.y * aside + half_.x * metal::cross(axis, aside)));
}

/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Parametrization
    Angle turned_from_the_key = Angle {0.5 * metal::length(surface.normal - look.key.direction),
        0.5 * metal::length(surface.normal + look.key.direction)};
    float lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = 1.0 - lit_side;
    // Blend
    metal::float4 shadow = metal::clamp(metal::float4(look.body.xyz
        + (look.body.xyz * metal::mix(metal::float3(1.0), metal::float3(0.45, 0.36, 0.62),
        in_the_dark) - look.body.xyz), look.body.w), metal::float4(0.0), metal::float4(1.0));
    metal::float3 normal = surface.normal;
    metal::float3 half_ = half_vector(look.key, surface.view);
    metal::float3 turn = rotate_vector(metal::float3(0.0, 1.0, 0.0), half_, look.turn_angle);
    AxesAround axes_of_the_highlight = axes(half_, turn);
    // Shift direction
    metal::float3 move_2 = direction_moved(direction_within(normal, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis), metal::float2(look.move_x, look.move_y));
    metal::float3 stretch = stretch_direction(move_2, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, look.stretch_x, look.stretch_y);
    metal::float3 split = split_direction(stretch, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, look.split_x, look.split_y);
    metal::float3 square = square_direction(split, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, look.square_amount, 4.0);
    // Angle between directions
    Angle from_the_highlight = Angle {0.5 * metal::length(square - half_), 0.5
        * metal::length(square + half_)};
    float highlight = profile_balanced_2(from_the_highlight, 0.0, highlight_shape);
    Composite highlight_on_top = blend_alpha(shadow, metal::float4(1.0, 0.98, 0.92, 1.0), highlight,
        0.96, true);
    float rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.2, 1.0);
    // Blend
    metal::float4 rim_s_light = metal::clamp(metal::float4(highlight_on_top.xyz + 0.5
        * (highlight_on_top.xyz + rim_2 * metal::float3(0.55, 0.75, 1.0) - highlight_on_top.xyz),
        highlight_on_top.w), metal::float4(0.0), metal::float4(1.0));
    metal::float4 output = finite_vec4(rim_s_light.w
        <= 0.0 ? rim_s_light : metal::float4(rim_s_light.xyz / metal::float3(rim_s_light.w),
        rim_s_light.w));
    return output;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
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
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position)};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
