// Exaggerated shape: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), smooth_normal_1_map texture(0), smooth_normal_2_map texture(1), smooth_normal_3_map texture(2), smooth_normal_4_map texture(3).
// shape-exaggerated.json says what to put there and how to draw.
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
    metal::float2 viewport;
    char _pad1[8];
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 smooth_normal_1_;
    metal::float3 smooth_normal_2_;
    metal::float3 smooth_normal_3_;
    metal::float3 smooth_normal_4_;
};

typedef metal::float4 Color;
struct type_7 {
    metal::float4 inner[16];
};

struct type_8 {
    metal::float4 inner[4];
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_7 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_8 places;
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
constant Ramp from_dusk_to_sun = Ramp {type_7 {{metal::float4(0.1373, 0.1647, 0.302, 1.0),
    metal::float4(0.4196, 0.3725, 0.5255, 1.0), metal::float4(0.7882, 0.5804, 0.4353, 1.0),
    metal::float4(0.9412, 0.8039, 0.5725, 1.0), metal::float4(1.0, 0.9843, 0.902, 1.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}},
    type_8 {{metal::float4(0.05, 0.35, 0.55, 0.75), metal::float4(0.98, 0.0, 0.0, 0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};

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
    return twice * 0.5;
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

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
metal::float3 srgb_of_oklab(
    metal::float3 lab
) {
    metal::float3 light = linear_of_oklab(lab);
    return metal::float3(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
RampPlace ramp_place(
    Ramp ramp,
    float x
) {
    type_7 colors = {};
    type_8 places = {};
    uint at = 0u;
    colors = ramp.colors;
    places = ramp.places;
    for (uint i = 1u; i < 5u; i++) {
        float places_now = places.inner[naga_div(i, 4u)][naga_mod(i, 4u)];
        at = places_now <= x ? i : at;
    }
    uint after = metal::min(at + 1u, 4u);
    float place = places.inner[naga_div(at, 4u)][naga_mod(at, 4u)];
    float t = metal::clamp(divided(x - place,
        places.inner[naga_div(after, 4u)][naga_mod(after, 4u)] - place), 0.0, 1.0);
    return RampPlace {colors.inner[at], colors.inner[after], t};
}

Color ramp_oklab(
    float value,
    Ramp ramp
) {
    RampPlace place = ramp_place(ramp, value);
    metal::float3 srgb_of_oklab_value = srgb_of_oklab(metal::mix(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb(place.after.xyz), place.t));
    return place.t <= 0.0 ? place.before : (place.t
        >= 1.0 ? place.after : metal::float4(srgb_of_oklab_value, 1.0));
}

/// Shading of the detail that a finer normal has beyond a coarser one: -1 where the finer turns
/// from the light, 1 where it turns toward the light. The light is laid at the coarser normal's
/// horizon, so that detail is lit as well as can be, however the light falls.
float detail_lit(
    metal::float3 finer,
    metal::float3 coarser,
    metal::float3 light,
    float contrast
) {
    metal::float3 across = light - metal::dot(light, coarser) * coarser;
    // Straight under the light there is no direction along the surface, and detail fades.
    metal::float3 toward = across / metal::float3(metal::max(metal::length(across), 0.05));
    return metal::clamp(contrast * metal::dot(finer, toward), -1.0, 1.0);
}

float exaggerated_four(
    Light light,
    metal::float3 normal,
    float contrast,
    float detail,
    metal::float3 smooth_1,
    metal::float3 smooth_2,
    metal::float3 smooth_3,
    metal::float3 smooth_4
) {
    float r = exp2_stable(-detail);
    metal::float3 n1 = normalize_moderate(smooth_1, normal);
    metal::float3 n2 = normalize_moderate(smooth_2, n1);
    metal::float3 n3 = normalize_moderate(smooth_3, n2);
    metal::float3 n4 = normalize_moderate(smooth_4, n3);
    float detail_lit_value = detail_lit(n3, n4, light.direction, contrast);
    float coarse = detail_lit(n2, n3, light.direction, contrast) + r
        * (detail_lit_value + r * metal::dot(n4, light.direction));
    float detail_lit_value_1 = detail_lit(n1, n2, light.direction, contrast);
    float sum = detail_lit(normal, n1, light.direction, contrast) + r
        * (detail_lit_value_1 + r * coarse);
    return metal::clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r * (1.0 + r * (1.0 + r)))), 0.0, 1.0);
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
    float distance = facing / metal::max(2.0 * footprint_of(facing), 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp(pixels + 0.5 - distance, 0.0, metal::min(pixels, 1.0)) * near;
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float every_scale_of_detail = exaggerated_four(look.key, surface.normal, 7.0, 0.1,
        surface.smooth_normal_1_, surface.smooth_normal_2_, surface.smooth_normal_3_,
        surface.smooth_normal_4_);
    Color from_dusk_to_sun_2 = ramp_oklab(every_scale_of_detail, from_dusk_to_sun);
    float ink = outer_contour(3.0, surface.normal, surface.view, look.viewport);
    metal::float4 inked = metal::mix(from_dusk_to_sun_2, metal::float4(0.098, 0.1059, 0.2, 1.0),
        ink);
    return inked;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_2 [[user(loc1), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> smooth_normal_1_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_2_map [[texture(1)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_3_map [[texture(2)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_4_map [[texture(3)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = smooth_normal_1_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_1 = smooth_normal_2_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_2 = smooth_normal_3_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_3 = smooth_normal_4_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        (metal::float4(texel.xyz, 0.0) * view.camera_from_world).xyz,
        (metal::float4(texel_1.xyz, 0.0) * view.camera_from_world).xyz,
        (metal::float4(texel_2.xyz, 0.0) * view.camera_from_world).xyz,
        (metal::float4(texel_3.xyz, 0.0) * view.camera_from_world).xyz};
    return fs_mainOutput { shade(surface, look) };
}
