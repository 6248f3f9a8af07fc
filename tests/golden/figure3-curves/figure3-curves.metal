// Profile curves: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1).
// figure3-curves.json says what to put there and how to draw.
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

/// The surface under the fragment, in world space.
struct Surface {
    metal::float2 uv;
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
    metal::float2 uv;
    char _pad2[8];
};

struct Varyings {
    metal::float4 clip;
    metal::float2 uv;
    char _pad2[8];
};

constant float PI = 3.1415927;
constant ProfileShape lambert_shape = ProfileShape {1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519,
    0.37607926, 0u};
constant ProfileShape half_lambert_shape = ProfileShape {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985,
    0.68337417, 0u};
constant ProfileShape custom_shape = ProfileShape {0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5,
    0.49992928, 0.2351043, 0u};

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

/// x, or `otherwise` where x is NaN or infinite.
float finite_or(
    float x,
    float otherwise
) {
    bool is_finite_value = is_finite(x);
    return is_finite_value ? x : otherwise;
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

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
Angle angle_of(
    float radians
) {
    float half_angle = 0.5 * metal::clamp(finite_or(radians, 0.0), 0.0, PI);
    metal::float2 sc = sin_cos_quarter(half_angle);
    return Angle {metal::max(sc.x, 0.0), metal::max(sc.y, 0.0)};
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
    float c = u.half_cos + u.half_sin * 0.0;
    metal::float2 upper = c <= 0.0 ? metal::float2(1.0, 0.0) : metal::float2(s, c);
    metal::float2 turned = ((s <= 0.0) & (s < c)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
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

Composite blend_alpha_3(
    Composite below,
    Color color,
    float tone,
    float opacity,
    bool clamped
) {
    return metal::clamp(metal::float4(below.xyz + tone * (color.xyz - below.xyz), 1.0),
        metal::float4(0.0), metal::float4(1.0));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : metal::pow(metal::max(1.0 - q * q, 0.0), 1.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_2(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : metal::pow(metal::max(1.0 - q * q, 0.0), shape.exponent);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_3(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : metal::pow(1.0 - q * q, shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(
    Angle u,
    float w,
    ProfileShape shape
) {
    metal::float2 place = metal::float2(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin
        * 0.0);
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
    metal::float2 place = metal::float2(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin
        * 0.0);
    float point = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick_3(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_3(
    Angle u,
    float w,
    ProfileShape shape
) {
    metal::float2 place = metal::float2(u.half_sin * shape.half_cos_offset - u.half_cos
        * shape.half_sin_offset, u.half_cos * shape.half_cos_offset + u.half_sin
        * shape.half_sin_offset);
    float point = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    metal::float2 turn = metal::float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick_2(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
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

float profile_balanced_3(
    Angle angle,
    float shift,
    ProfileShape shape
) {
    Angle warped = angle_turned(angle, metal::float2(0.0, 1.0));
    return profile_filtered_quick_3(warped, angle_footprint(warped), shape);
}

/// Threshold
///
/// 0 below an edge, 1 from the edge on, antialiased by its own width on the screen: cuts a hard
/// shape out of anything smooth. Where the value does not change on the screen the edge is hard,
/// and the edge itself is 1.
float threshold(
    float value,
    float edge,
    float softness
) {
    return step_filtered(value, edge, metal::length(metal::float2(footprint_of(value), softness)));
}

/// Separate vector
///
/// The three numbers of a vector.
VectorParts separate_vector(
    metal::float3 vector
) {
    return VectorParts {vector.x, vector.y, 0.0};
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface
) {
    VectorParts place = separate_vector(metal::float3(surface.uv, 0.0));
    float tone = (place.y - 0.14) / 0.72;
    // Blend
    float angles_tone = metal::max(threshold(tone, -0.006, 0.0) - threshold(tone, 0.006, 0.0), 0.0);
    Composite angles = blend_alpha(metal::float4(0.98, 0.965, 0.925, 1.0),
        metal::float4(0.24, 0.26, 0.3, 1.0), angles_tone, 1.0, true);
    float angle = metal::mix(0.0, 3.1415927, (place.x - 0.08) / 0.84);
    // Blend
    float tones_tone = metal::max(threshold(angle, -0.012, 0.0) - threshold(angle, 0.012, 0.0),
        0.0);
    // Blend
    metal::float4 tones = metal::max(metal::float4(angles.xyz + tones_tone
        * (metal::float3(0.24, 0.26, 0.3) - angles.xyz), 1.0), metal::float4(0.0));
    // Blend
    float offset_tone = metal::max(threshold(angle, 0.492, 0.0) - threshold(angle, 0.508, 0.0),
        0.0);
    Composite offset = blend_alpha_2(tones, metal::float4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55,
        true);
    // Blend
    float falloff_tone = metal::max(threshold(angle, 0.942, 0.0) - threshold(angle, 0.958, 0.0),
        0.0);
    Composite falloff = blend_alpha_2(offset, metal::float4(0.2, 0.38, 0.78, 1.0), falloff_tone,
        0.55, true);
    // Blend
    float cutoff_tone = metal::max(threshold(angle, 1.792, 0.0) - threshold(angle, 1.808, 0.0),
        0.0);
    Composite cutoff = blend_alpha_2(falloff, metal::float4(0.2, 0.38, 0.78, 1.0), cutoff_tone,
        0.55, true);
    float lambert = profile_balanced(angle_of(angle), 0.0, lambert_shape);
    float lambert_off = tone - lambert;
    float lambert_line = threshold(lambert_off, -0.012, 0.0) - threshold(lambert_off, 0.012, 0.0);
    // Blend
    float lambert_tone = metal::max(lambert_line, 0.0);
    Composite lambert_2 = blend_alpha_3(cutoff, metal::float4(0.8, 0.2, 0.17, 1.0), lambert_tone,
        1.0, true);
    float half_lambert = profile_balanced_2(angle_of(angle), 0.0, half_lambert_shape);
    float half_lambert_off = tone - half_lambert;
    float half_lambert_to = threshold(half_lambert_off, 0.012, 0.0);
    float half_lambert_line = threshold(half_lambert_off, -0.012, 0.0) - half_lambert_to;
    // Blend
    float half_lambert_tone = metal::max(half_lambert_line, 0.0);
    Composite half_lambert_2 = blend_alpha_3(lambert_2, metal::float4(0.18, 0.55, 0.27, 1.0),
        half_lambert_tone, 1.0, true);
    float custom = profile_balanced_3(angle_of(angle), 0.0, custom_shape);
    float custom_off = tone - custom;
    float custom_line = threshold(custom_off, -0.012, 0.0) - threshold(custom_off, 0.012, 0.0);
    // Blend
    float custom_tone = metal::max(custom_line, 0.0);
    Composite custom_2 = blend_alpha_3(half_lambert_2, metal::float4(0.5, 0.31, 0.14, 1.0),
        custom_tone, 1.0, true);
    return custom_2;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float2 uv [[attribute(3)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float2 uv [[user(loc0), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.uv };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, vertex_.uv};
    return vs_mainOutput { _tmp.clip, _tmp.uv };
}


struct fs_mainInput {
    metal::float2 uv [[user(loc0), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
) {
    const Varyings in = { clip, varyings_1.uv };
    Surface surface = Surface {in.uv};
    return fs_mainOutput { shade(surface) };
}
