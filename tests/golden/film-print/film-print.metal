// Film print: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// film-print.json says what to put there and how to draw.
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

struct type_5 {
    metal::float4 inner[16];
};

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    type_5 points;
    /// Number of points that count.
    uint count;
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
    uint interpolation;
    char _pad3[8];
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

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};

constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape tone_shape = ProfileShape {1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107,
    0.63535863, 0u};
constant Curve response_of_the_film = Curve {type_5 {{metal::float4(0.0, 0.0, 0.2, 0.0),
    metal::float4(0.3, 0.06, 0.36, 0.0), metal::float4(0.5, 0.42, 0.972973, 0.0),
    metal::float4(0.62, 0.5, 1.0256411, 0.0), metal::float4(0.8, 0.9, 0.81632656, 0.0),
    metal::float4(1.0, 1.0, 0.5, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, 6u, 1u};
constant ProfileShape sheen_tone_shape = ProfileShape {0.9996875, 0.024997396, 3.1317647, 2.7420828,
    0.05, 0.3043368, 0.13399889, 0u};
constant ProfileShape back_light_tone_shape = ProfileShape {0.9689124, 0.24740396, 4.0419726,
    1.8505588, 0.5, 0.27256957, 0.11186968, 0u};
constant Curve film_print = Curve {type_5 {{metal::float4(0.0, 0.04, 0.64, 0.0),
    metal::float4(0.25, 0.2, 0.8608187, 0.0), metal::float4(0.6, 0.66, 0.97504276, 0.0),
    metal::float4(1.0, 0.97, 0.775, 0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};
constant Curve film_print_2 = Curve {type_5 {{metal::float4(0.0, 0.0, 0.73333335, 0.0),
    metal::float4(0.3, 0.22, 0.99215686, 0.0), metal::float4(0.6, 0.68, 1.0514286, 0.0),
    metal::float4(1.0, 1.0, 0.8, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, 4u, 1u};
constant Curve film_print_3 = Curve {type_5 {{metal::float4(0.0, 0.06, 0.8333333, 0.0),
    metal::float4(0.3, 0.31, 0.8805031, 0.0), metal::float4(0.6, 0.59, 0.91636366, 0.0),
    metal::float4(1.0, 0.95, 0.9, 0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, 4u, 1u};
constant Curve film_print_4 = Curve {type_5 {{metal::float4(0.0, 0.13, 0.8, 0.0),
    metal::float4(0.3, 0.37, 0.53333336, 0.0), metal::float4(0.6, 0.49, 0.51555556, 0.0),
    metal::float4(1.0, 0.78, 0.725, 0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 4u, 1u};

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(
    float x
) {
    float whole = metal::rint(x);
    float f = x - whole;
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

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(
    float y
) {
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// [`sin_cos_quarter`] for |x| <= 0.1.
metal::float2 sin_cos_tiny(
    float x
) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y * 0.008333334));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y * 0.0013888889));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_3(
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
    return metal::sqrt(metal::dot(d, d));
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
metal::float4 hermite(
    metal::float4 a,
    metal::float4 b,
    metal::float4 from_a,
    metal::float4 to_b,
    float t
) {
    metal::float4 d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// The curve's y at x; the steps of a stepped curve are averaged over a footprint of `w`. 0 for a
/// curve without points.
float curve_at(
    Curve curve,
    float x,
    float w
) {
    type_5 points = {};
    uint at = 0u;
    points = curve.points;
    for (uint i_2 = 1u; i_2 < 6u; i_2++) {
        at = points.inner[i_2].x <= x ? i_2 : at;
    }
    metal::float4 a = points.inner[at];
    if ((at + 1u >= 6u) | (x <= a.x)) {
        return a.y;
    }
    metal::float4 b = points.inner[at + 1u];
    float t = metal::clamp(divided(x - a.x, b.x - a.x), 0.0, 1.0);
    metal::float4 hermite_value = hermite(metal::float4(a.y), metal::float4(b.y), (b.x - a.x)
        * metal::float4(a.z), (b.x - a.x) * metal::float4(b.z), t);
    return hermite_value.x;
}

/// The curve's y at x; the steps of a stepped curve are averaged over a footprint of `w`. 0 for a
/// curve without points.
float curve_at_2(
    Curve curve,
    float x,
    float w
) {
    type_5 points = {};
    uint at = 0u;
    points = curve.points;
    for (uint i_2 = 1u; i_2 < 4u; i_2++) {
        at = points.inner[i_2].x <= x ? i_2 : at;
    }
    metal::float4 a = points.inner[at];
    if ((at + 1u >= 4u) | (x <= a.x)) {
        return a.y;
    }
    metal::float4 b = points.inner[at + 1u];
    float t = metal::clamp(divided(x - a.x, b.x - a.x), 0.0, 1.0);
    metal::float4 hermite_value = hermite(metal::float4(a.y), metal::float4(b.y), (b.x - a.x)
        * metal::float4(a.z), (b.x - a.x) * metal::float4(b.z), t);
    return hermite_value.x;
}

/// Color curves
///
/// Redraws a color's channels along curves, one for all of them and then one for each: contrast,
/// film looks, split toning.
Color color_curves(
    Color color,
    Curve all,
    Curve red,
    Curve green,
    Curve blue
) {
    metal::float3 w = metal::float3(footprint_of(color.x), footprint_of(color.y),
        footprint_of(color.z));
    float r = curve_at_2(all, color.x, w.x);
    float g = curve_at_2(all, color.y, w.y);
    float b = curve_at_2(all, color.z, w.z);
    return metal::float4(curve_at_2(red, r, w.x), curve_at_2(green, g, w.y),
        curve_at_2(blue, b, w.z), 1.0);
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

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
float profile_power(
    float q,
    float exponent
) {
    float log_base = 0.0;
    if (q >= 1.0) {
        return 0.0;
    }
    if (q < 0.5) {
        log_base = LOG2_E * log1p_negative_small(q * q);
    } else {
        log_base = log2_stable((1.0 - q) * (1.0 + q));
    }
    return metal::min(exp2_stable(exponent * log_base), 1.0);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
float profile_point(
    Angle u,
    ProfileShape shape
) {
    float s = u.half_sin - u.half_cos * 0.0;
    if (s <= 0.0) {
        return 1.0;
    }
    float q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
float profile_filtered(
    Angle u,
    float w,
    ProfileShape shape
) {
    float point = profile_point(u, shape);
    bool is_wide = w < 0.1 * shape.edge_deviation;
    if (is_wide | (w <= 0.0)) {
        return point;
    }
    metal::float2 reach = sin_cos_tiny(0.19364917 * w);
    float before = profile_point(angle_turned(u, reach), shape);
    float after = profile_point(angle_turned(u, metal::float2(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
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

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
float profile(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned_2(angle, metal::float2(0.0, 1.0));
    return profile_filtered(warped, angle_footprint(warped), shape);
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned_3(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Parametrization
    Angle turned_from_the_key = Angle {0.5 * metal::length(surface.normal - look.key.direction),
        0.5 * metal::length(surface.normal + look.key.direction)};
    float tone = profile(turned_from_the_key, 0.0, tone_shape);
    float response_of_the_film_2 = curve_at(response_of_the_film, tone, footprint_of(tone));
    // Blend
    float body_tone = metal::clamp(response_of_the_film_2, 0.0, 1.0);
    Composite body = blend_alpha(metal::float4(0.1216, 0.1137, 0.1333, 1.0),
        metal::float4(0.7765, 0.7137, 0.6392, 1.0), body_tone, 1.0, true);

    // Sheen (Light layer)
    Angle sheen_angle = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    float sheen_tone = profile_balanced(sheen_angle, 0.0, sheen_tone_shape);
    LitLayer sheen_lit = light_apply(look.key, metal::float4(0.3725, 0.3451, 0.298, 1.0),
        sheen_tone);
    metal::float4 sheen_blend = metal::clamp(metal::float4(body.xyz + sheen_lit.tone
        * sheen_lit.color.xyz, 1.0), metal::float4(0.0), metal::float4(1.0));

    // Back-light (Light layer)
    Angle back_light_angle = Angle {0.5 * metal::length(surface.normal - look.back.direction), 0.5
        * metal::length(surface.normal + look.back.direction)};
    float back_light_tone = profile_balanced(back_light_angle, 0.0, back_light_tone_shape);
    LitLayer back_light_lit = light_apply(look.back, metal::float4(0.498, 0.5255, 0.549, 1.0),
        back_light_tone);
    metal::float4 back_light_blend = metal::clamp(metal::float4(sheen_blend.xyz
        + back_light_lit.tone * back_light_lit.color.xyz, 1.0), metal::float4(0.0),
        metal::float4(1.0));

    Color film_print_5 = color_curves(back_light_blend, film_print, film_print_2, film_print_3,
        film_print_4);
    return film_print_5;
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
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position)};
    return fs_mainOutput { shade(surface, look) };
}
