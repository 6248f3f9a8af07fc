// Anisotropic Ward: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
// material-ward.json says what to put there and how to draw.
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
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 tangent;
};

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
};

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

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign + n.z);
    return metal::float3(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// Unit tangent, bitangent and normal as columns: a mesh's tangent and bitangent stood upright on a
/// normal (Gram and Schmidt), with the handedness of the mesh. Where the tangent is missing or lies
/// along the normal, another one takes its place.
metal::float3x3 world_from_tangent(
    metal::float3 tangent,
    metal::float3 bitangent,
    metal::float3 normal
) {
    metal::float3 t = tangent * metal::rsqrt(metal::max(metal::dot(tangent, tangent),
        0.000000000000000000000000000001));
    metal::float3 leaning = t - metal::dot(t, normal) * normal;
    bool is_usable = metal::dot(leaning, leaning) > 0.00000001;
    metal::float3 any_orthogonal_value = any_orthogonal(normal);
    metal::float3 rough = normalize_or(is_usable ? leaning : any_orthogonal_value,
        metal::float3(1.0, 0.0, 0.0));
    metal::float3 upright = normalize_moderate(rough - metal::dot(rough, normal) * normal,
        metal::float3(1.0, 0.0, 0.0));
    metal::float3 b = metal::cross(normal, upright);
    return metal::float3x3(upright, b, normal);
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
metal::float3 half_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    return normalize_moderate(metal::dot(half_, half_) > 0.000000000001 ? half_ : normal, normal);
}

/// Ward's anisotropic highlight (1992, in the form of Walter 2005) with a width along each of two
/// axes.
float ward(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view,
    metal::float3 x_axis,
    metal::float3 y_axis,
    metal::float2 widths
) {
    float n_l = metal::dot(normal, light);
    float n_v = metal::dot(normal, view);
    if ((n_l <= 0.0) | (n_v <= 0.0)) {
        return 0.0;
    }
    metal::float3 half_ = half_of(light, normal, view);
    float n_h = metal::max(metal::dot(normal, half_), 0.000001);
    metal::float2 slope = metal::float2(metal::dot(half_, x_axis), metal::dot(half_, y_axis))
        / (widths * n_h);
    float lobe = exp2_stable(-1.442695 * metal::min(metal::dot(slope, slope), 200.0));
    return n_l * lobe / (widths.y * metal::sqrt(metal::max(n_l * n_v, 0.000001)));
}

float reflectance_ward(
    Light light,
    metal::float3 normal,
    metal::float3 view,
    metal::float3 tangent,
    float roughness,
    float across
) {
    metal::float3x3 frame = world_from_tangent(tangent, metal::float3(0.0), normal);
    metal::float2 widths = metal::float2(0.25, across * across);
    return ward(light.direction, frame[2], view, frame[0], frame[1], widths);
}

/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Reflectance
    float lambert = metal::max(metal::dot(surface.normal, look.key.direction), 0.0);
    // Blend
    metal::float4 body = metal::float4(metal::float3(0.098, 0.1059, 0.1333) + lambert
        * metal::float3(0.3529, 0.3961, 0.4392), 1.0);
    float ward_2 = reflectance_ward(look.key, surface.normal, surface.view, surface.tangent, 0.5,
        0.2);
    // Blend
    metal::float4 highlight = metal::clamp(metal::float4(body.xyz + 0.55
        * (body.xyz + ward_2 * metal::float3(0.9569, 0.9412, 0.902) - body.xyz), 1.0),
        metal::float4(0.0), metal::float4(1.0));
    return highlight;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
    metal::float4 tangent_2 [[attribute(2)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
    metal::float4 tangent [[user(loc2), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_4, varyings.tangent_2 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal, metal::float4((object.world_from_object
        * metal::float4(vertex_.tangent.xyz, 0.0)).xyz,
        metal::determinant(object.world_from_normal) < 0.0 ?
        -vertex_.tangent.w : vertex_.tangent.w)};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal, _tmp.tangent };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_4 [[user(loc1), center_perspective]];
    metal::float4 tangent_2 [[user(loc2), center_perspective]];
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
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_4, varyings_1.tangent_2 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float3 normalize_moderate_value = normalize_moderate(in.tangent.xyz - normal
        * metal::dot(normal, in.tangent.xyz), metal::float3(0.0));
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        normalize_moderate_value};
    return fs_mainOutput { shade(surface, look) };
}
