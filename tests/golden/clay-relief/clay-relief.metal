// Clay relief: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0), curvature_tensor_map texture(1).
// clay-relief.json says what to put there and how to draw.
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
    Light sky;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float kappa;
    metal::float3 curvature_tensor;
};

typedef metal::float4 Color;
struct type_6 {
    metal::float4 inner[16];
};

struct type_7 {
    metal::float4 inner[4];
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    type_6 colors;
    /// Places of the stops, in increasing order, four to a vector.
    type_7 places;
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

struct Relief {
    /// The shape index: 0 a pit, 0.25 a valley, 0.5 a saddle or flat, 0.75 a ridge, 1 a bump.
    float shape;
    /// From 0 where it is flat to 1.
    float strength;
    /// The greatest curvature of all directions, in 1/viewport-height.
    float greatest;
    /// The least curvature of all directions, in 1/viewport-height.
    float least;
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
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant Ramp terracotta = Ramp {type_6 {{metal::float4(0.2353, 0.102, 0.1098, 1.0),
    metal::float4(0.5412, 0.251, 0.1882, 1.0), metal::float4(0.8118, 0.498, 0.3412, 1.0),
    metal::float4(0.949, 0.7412, 0.5725, 1.0), metal::float4(0.9843, 0.8627, 0.7333, 1.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}},
    type_7 {{metal::float4(0.0, 0.3, 0.62, 0.9), metal::float4(1.0, 0.0, 0.0, 0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};
constant Ramp pits_to_bumps = Ramp {type_6 {{metal::float4(0.2941, 0.2275, 0.3216, 1.0),
    metal::float4(0.4784, 0.2902, 0.2902, 1.0), metal::float4(0.7529, 0.502, 0.3765, 1.0),
    metal::float4(0.9412, 0.7529, 0.5804, 1.0), metal::float4(1.0, 0.9412, 0.8471, 1.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}},
    type_7 {{metal::float4(0.0, 0.3, 0.5, 0.75), metal::float4(1.0, 0.0, 0.0, 0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(
    float x
) {
    float clamped = metal::clamp(x, -126.0, 127.99999);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole))
        + as_type<uint>(126))) << 23u);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable_2(
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
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
metal::float2 bounded_vec2(
    metal::float2 v
) {
    metal::uint2 bits = as_type<metal::uint2>(v);
    metal::uint2 magnitude = bits & metal::uint2(2147483647u);
    metal::float2 largest = as_type<metal::float2>((bits & metal::uint2(2147483648u))
        | metal::uint2(2139095039u));
    metal::float2 numbers = metal::select(metal::float2(0.0), largest,
        magnitude == metal::uint2(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint2(2139095040u));
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

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
float angle_of_point(
    float y,
    float x
) {
    // Coordinates are halved where they are large, so that the sum of both stays finite.
    metal::float2 p = metal::abs(bounded_vec2(metal::float2(x, y)));
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

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
float soft_light(
    float a,
    float b
) {
    if (b <= 0.5) {
        return a - (1.0 - 2.0 * b) * a * (1.0 - a);
    }
    float curved = a <= 0.25 ? ((16.0 * a - 12.0) * a + 4.0) * a : metal::sqrt(metal::max(a, 0.0));
    return a + (2.0 * b - 1.0) * (curved - a);
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
    type_6 colors = {};
    type_7 places = {};
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

Color mix_colors_screen(
    Color a,
    Color b,
    float factor
) {
    return metal::float4(metal::mix(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, factor), 1.0);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
float curvature_signed(
    float kappa,
    float slope
) {
    float a = kappa * slope;
    float magnitude = metal::min(metal::abs(a), 50.0);
    if (magnitude < 0.0625) {
        float a2 = a * a;
        return a * (1.0 - a2 * (0.33333334 - a2 * (0.13333334 - a2 * 0.053968254)));
    }
    float z = exp2_stable_2(-2.88539 * magnitude);
    float t = (1.0 - z) / (1.0 + z);
    return a >= 0.0 ? t : -t;
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
float curvature_signed_2(
    float kappa,
    float slope
) {
    float a = metal::min(kappa, 10000.0) * slope;
    float magnitude = metal::min(a, 50.0);
    if (magnitude < 0.0625) {
        float a2 = a * a;
        return a * (1.0 - a2 * (0.33333334 - a2 * (0.13333334 - a2 * 0.053968254)));
    }
    float z = exp2_stable_2(-2.88539 * magnitude);
    float t = (1.0 - z) / (1.0 + z);
    return t;
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
metal::float2 principal_curvatures(
    metal::float3 tensor
) {
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = metal::length(metal::float2(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    float far = mean + (mean >= 0.0 ? spread : -spread);
    float near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return mean >= 0.0 ? metal::float2(far, near) : metal::float2(near, far);
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

float reflectance_half_lambert(
    Light light,
    metal::float3 normal
) {
    float half_ = 0.5 + 0.5 * metal::dot(normal, light.direction);
    return metal::min(half_ * half_, 1.0);
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

/// A tone from 0 to 1 scaled by e^curved where it is dark and by e^-curved where it is light; the
/// tone `turning` stays.
float radiance_scaled(
    float tone,
    float curved,
    float turning
) {
    float e = exp2_stable(curved * LOG2_E);
    float dark = turning * (1.0 - tone);
    float light = tone * (1.0 - turning);
    return tone * (e * dark + light) / metal::max(dark + e * light, 0.00000000000000000001);
}

/// Scale by curvature
///
/// Makes a tone lighter where the surface bulges and darker where it is hollow, and the other way
/// around where it is very light: any shading shows its shape more plainly.
float radiance_scaling(
    float tone,
    float kappa,
    float amount,
    float slope,
    float turning
) {
    float curved = amount * curvature_signed(kappa, slope);
    float radiance_scaled_value = radiance_scaled(tone, curved, turning);
    return metal::min(curved == 0.0 ? tone : radiance_scaled_value, 1.0);
}

/// Relief
///
/// What the surface does at a place, in two numbers for a Tone map or for ramps: its shape (pit,
/// valley, saddle, ridge or bump) and how strongly it has it.
Relief relief(
    metal::float3 tensor,
    float slope
) {
    metal::float2 k = principal_curvatures(tensor);
    float around = angle_of_point(k.x + k.y, k.x - k.y);
    float curvedness = metal::sqrt(0.5 * metal::dot(k, k));
    float strength = curvature_signed_2(curvedness, slope);
    return Relief {0.5 + around / PI, strength, k.x, k.y};
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    float matt_clay = reflectance_half_lambert(look.key, surface.normal);
    float worked_by_curvature = radiance_scaling(matt_clay, surface.kappa, 1.3, 0.03, 0.9);
    Color terracotta_2 = ramp_oklab(worked_by_curvature, terracotta);
    Relief what_the_surface_does = relief(surface.curvature_tensor, 0.025);
    Color pits_to_bumps_2 = ramp_oklab(what_the_surface_does.shape, pits_to_bumps);
    float soft_light_value = soft_light(terracotta_2.x, pits_to_bumps_2.x);
    float soft_light_value_1 = soft_light(terracotta_2.y, pits_to_bumps_2.y);
    float soft_light_value_2 = soft_light(terracotta_2.z, pits_to_bumps_2.z);
    metal::float4 slip_in_the_hollows = metal::float4(metal::mix(terracotta_2.xyz,
        metal::float3(soft_light_value, soft_light_value_1, soft_light_value_2),
        metal::clamp(what_the_surface_does.strength, 0.0, 1.0)), 1.0);
    float sky_along_the_edge = rim(look.sky, surface.normal, surface.view, 0.4, 0.9, 1.0);
    Color cool_edge = mix_colors_screen(slip_in_the_hollows,
        metal::float4(0.3725, 0.498, 0.6588, 1.0), sky_along_the_edge);
    return cool_edge;
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
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(1)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_1 = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        texel.x, texel_1.xyz};
    return fs_mainOutput { shade(surface, look) };
}
