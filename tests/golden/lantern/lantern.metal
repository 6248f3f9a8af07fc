// Lantern: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1).
// lantern.json says what to put there and how to draw.
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
    metal::float3 normal;
    metal::float3 view;
};

typedef metal::float4 Color;
struct type_5 {
    metal::float4 inner[16];
};

struct type_6 {
    metal::float4 inner[4];
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_5 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_6 places;
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
    char _pad4[8];
};

/// Place on a ramp: the colors before and after it, and the way between them.
struct RampPlace {
    metal::float4 before;
    metal::float4 after;
    /// Way from `before` to `after`, 0 to 1; smooth ramps are level at each stop.
    float t;
    char _pad3[12];
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
constant Ramp glow = Ramp {type_5 {{metal::float4(0.851, 0.4118, 0.1647, 1.0),
    metal::float4(1.0, 0.7804, 0.3961, 1.0), metal::float4(1.0, 0.9647, 0.8471, 1.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, type_6 {{metal::float4(0.0, 0.45, 1.0, 0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 3u, 0u};

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

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
float srgb_of_linear(
    float light
) {
    float size = metal::abs(light);
    float value = size <= 0.0031308 ? size * 12.92 : 1.055 * metal::pow(size, 0.41666666) - 0.055;
    return light < 0.0 ? -value : value;
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
metal::float3 oklab_of_linear(
    metal::float3 rgb
) {
    float l = metal::pow(metal::dot(rgb, metal::float3(0.41222146, 0.53633255, 0.051445995)),
        0.33333334);
    float m = metal::pow(metal::dot(rgb, metal::float3(0.2119035, 0.6806995, 0.10739696)),
        0.33333334);
    float s = metal::pow(metal::dot(rgb, metal::float3(0.08830246, 0.28171885, 0.6299787)),
        0.33333334);
    return metal::float3(0.21045426 * l + 0.7936178 * m - 0.004072047 * s, 1.9779985 * l
        - 2.4285922 * m + 0.4505937 * s, 0.025904037 * l + 0.78277177 * m - 0.80867577 * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
metal::float3 linear_of_oklab(
    metal::float3 lab
) {
    float l = lab.x + 0.39633778 * lab.y + 0.21580376 * lab.z;
    float m = lab.x - 0.105561346 * lab.y - 0.06385417 * lab.z;
    float s = lab.x - 0.08948418 * lab.y - 1.2914855 * lab.z;
    metal::float3 cubes = metal::float3(l * l * l, m * m * m, s * s * s);
    return metal::float3(metal::dot(cubes, metal::float3(4.0767417, -3.3077116, 0.23096994)),
        metal::dot(cubes, metal::float3(-1.268438, 2.6097574, -0.34131938)),
        metal::dot(cubes, metal::float3(-0.0041960864, -0.7034186, 1.7076147)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
metal::float3 oklab_of_srgb(
    metal::float3 coded
) {
    metal::float3 oklab_of_linear_value = oklab_of_linear(metal::float3(metal::pow((coded.x
        + 0.055) / 1.055, 2.4), metal::pow((coded.y + 0.055) / 1.055, 2.4),
        metal::pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// [`oklab_of_linear`] of an sRGB-coded color.
metal::float3 oklab_of_srgb_2(
    metal::float3 coded
) {
    metal::float3 oklab_of_linear_value = oklab_of_linear(metal::float3(1.0,
        metal::pow((coded.y + 0.055) / 1.055, 2.4), metal::pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
metal::float3 srgb_of_oklab(
    metal::float3 lab
) {
    metal::float3 light = linear_of_oklab(lab);
    return metal::float3(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
RampPlace ramp_place(
    Ramp ramp,
    float x
) {
    type_5 colors = {};
    type_6 places = {};
    uint at = 0u;
    colors = ramp.colors;
    places = ramp.places;
    for (uint i = 1u; i < 3u; i++) {
        float places_now = places.inner[0][naga_mod(i, 4u)];
        at = places_now <= x ? i : at;
    }
    uint after = metal::min(at + 1u, 2u);
    float place = places.inner[0][naga_mod(at, 4u)];
    float t = metal::clamp(divided(x - place, places.inner[0][naga_mod(after, 4u)] - place), 0.0,
        1.0);
    return RampPlace {colors.inner[at], colors.inner[after], t};
}

Color ramp_oklab(
    float value,
    Ramp ramp
) {
    RampPlace place = ramp_place(ramp, value);
    metal::float3 srgb_of_oklab_value = srgb_of_oklab(metal::mix(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb_2(place.after.xyz), place.t));
    return place.t <= 0.0 ? place.before : (place.t
        >= 1.0 ? place.after : metal::float4(srgb_of_oklab_value, 1.0));
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface
) {
    Color glow_2 = ramp_oklab(metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0),
        glow);
    return glow_2;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position)};
    return fs_mainOutput { shade(surface) };
}
