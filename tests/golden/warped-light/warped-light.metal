// Warped light: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// warped-light.json says what to put there and how to draw.
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
    metal::float3x3 camera_from_world;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
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

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    float sine2_;
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
constant Ramp jade = Ramp {type_6 {{metal::float4(0.0157, 0.1294, 0.1216, 1.0),
    metal::float4(0.0588, 0.3529, 0.298, 1.0), metal::float4(0.2471, 0.6275, 0.4784, 1.0),
    metal::float4(0.7137, 0.8784, 0.6902, 1.0), metal::float4(0.9333, 0.9725, 0.8471, 1.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}},
    type_7 {{metal::float4(0.0, 0.35, 0.65, 0.9), metal::float4(1.0, 0.0, 0.0, 0.0),
    metal::float4(0.0), metal::float4(0.0)}}, 5u, 0u};

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
    metal::float3 oklab_of_linear_value = oklab_of_linear(metal::float3(coded.x
        <= 0.04045 ? coded.x / 12.92 : metal::pow((coded.x + 0.055) / 1.055, 2.4),
        metal::pow((coded.y + 0.055) / 1.055, 2.4), metal::pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// [`oklab_of_linear`] of an sRGB-coded color.
metal::float3 oklab_of_srgb_2(
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
    return metal::float4(metal::mix(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, metal::min(factor, 1.0)),
        1.0);
}

Color mix_colors_screen_2(
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
    float a = metal::clamp(kappa, -10000.0, 10000.0) * slope;
    float magnitude = metal::min(metal::abs(a), 50.0);
    if (magnitude < 0.0625) {
        float a2 = a * a;
        return a * (1.0 - a2 * (0.33333334 - a2 * (0.13333334 - a2 * 0.053968254)));
    }
    float z = exp2_stable_2(-2.88539 * magnitude);
    float t = (1.0 - z) / (1.0 + z);
    return a >= 0.0 ? t : -t;
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

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
metal::float3 half_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    return normalize_moderate(metal::dot(half_, half_) > 0.000000000001 ? half_ : normal, normal);
}

/// The square of the sine between two unit vectors.
float sine_squared(
    metal::float3 a,
    metal::float3 b
) {
    metal::float3 across = metal::cross(a, b);
    return metal::min(metal::dot(across, across), 1.0);
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
Reflection reflection_of(
    metal::float3 light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 half_ = half_of(light, normal, view);
    float n_h = metal::clamp(metal::dot(normal, half_), 0.0, 1.0);
    float v_h = metal::clamp(metal::dot(view, half_), 0.0, 1.0);
    return Reflection {metal::dot(normal, light), metal::dot(normal, view), n_h, v_h,
        sine_squared(normal, half_)};
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
float schlick(
    float at_normal,
    float cosine
) {
    float m = 1.0 - cosine;
    float m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Cook and Torrance's model with the GGX distribution and Smith's height-correlated shadowing
/// (Walter et al. 2007, Heitz 2014).
float ggx(
    Reflection r,
    float width,
    float at_normal
) {
    if ((r.n_l <= 0.0) | (r.n_v <= 0.0)) {
        return 0.0;
    }
    float a2 = width * width;
    float bottom = metal::max(r.sine2_ + a2 * r.n_h * r.n_h, 0.000000000001);
    float distribution = a2 / (bottom * bottom);
    float toward_light = r.n_v * metal::sqrt(r.n_l * r.n_l * (1.0 - a2) + a2);
    float toward_eye = r.n_l * metal::sqrt(r.n_v * r.n_v * (1.0 - a2) + a2);
    float visibility = 0.5 / metal::max(toward_light + toward_eye, 0.000000001);
    return metal::min(distribution * visibility * schlick(at_normal, r.v_h) * r.n_l, 1000000.0);
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
    float further = facing > 0.5 ? 0.5 * metal::dot(aside, aside) - 0.5 : width - facing;
    float within = further / edge + 0.0;
    float inside = metal::clamp(within, 0.0, 1.0);
    metal::float3 across = light.direction - metal::dot(light.direction, view) * view;
    float side = metal::dot(normal - metal::dot(normal, view) * view, across
        * metal::rsqrt(metal::max(metal::dot(across, across), 0.000000000000000000000000000001)));
    return inside * metal::mix(1.0, metal::smoothstep(0.0, 0.5, side), follow);
}

/// `place` times the symmetric matrix (xx, xy, yy) in which each principal curvature k of the
/// tensor has become 2^(-amount tanh(slope k)).
metal::float2 warped_place(
    metal::float3 tensor,
    metal::float2 place,
    float amount,
    float slope
) {
    metal::float2 k = principal_curvatures(tensor);
    float most = exp2_stable(-amount * curvature_signed(k.x, slope));
    float least = exp2_stable(-amount * curvature_signed(k.y, slope));
    metal::float2 half_apart = metal::float2(0.5 * (tensor.x - tensor.z), tensor.y);
    metal::float2 axes = half_apart / metal::float2(metal::max(metal::length(half_apart),
        0.00000000000000000001));
    metal::float2 turned = metal::float2(axes.x * place.x + axes.y * place.y, axes.y * place.x
        - axes.x * place.y);
    return 0.5 * (most + least) * place + 0.5 * (most - least) * turned;
}

/// The light's direction after light warping: its stereographic projection from the point opposite
/// the normal is drawn nearer along convex directions and away along concave ones.
metal::float3 warped_light(
    metal::float3 light,
    metal::float3 n,
    metal::float3 view,
    metal::float3x3 camera_from_world,
    metal::float3 tensor,
    float amount,
    float slope
) {
    metal::float3 right = metal::float3(1.0, 0.0, 0.0) * camera_from_world;
    metal::float3 x = normalize_moderate(right - metal::dot(right, view) * view,
        metal::float3(1.0, 0.0, 0.0));
    metal::float3 y = metal::cross(view, x);
    metal::float3 between = (view + n) / metal::float3(metal::max(1.0 + metal::dot(view, n), 0.01));
    metal::float3 along_x = x - metal::dot(n, x) * between;
    metal::float3 along_y = y - metal::dot(n, y) * between;
    metal::float2 place = metal::float2(metal::dot(light, along_x), metal::dot(light, along_y))
        / metal::float2(metal::max(1.0 + metal::dot(light, n), 0.0001));
    metal::float2 q = warped_place(tensor, place, amount, slope);
    float square = metal::dot(q, q);
    return normalize_or(2.0 * q.x * along_x + 2.0 * q.y * along_y + (1.0 - square) * n, light);
}

/// Warp light
///
/// Bends a light over the surface's shape: bumps and ridges draw it toward themselves, hollows push
/// it away, so that every layer it lights shows more of the form. Flat places see it as it is, and
/// so does the outline.
Light light_warp(
    Light light,
    metal::float3 normal,
    float amount,
    float slope,
    metal::float3 tensor,
    metal::float3 view,
    metal::float3x3 camera_from_world
) {
    float most = amount * metal::smoothstep(0.05, 0.3, metal::dot(normal, view));
    metal::float3 warped = warped_light(light.direction, normal, view, camera_from_world, tensor,
        most, slope);
    bool is_flat = most == 0.0;
    return Light {is_flat ? light.direction : warped, light.own_direction, light.color,
        light.intensity};
}


/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    Light bent_by_the_form = light_warp(look.key, surface.normal, 1.4, 0.03,
        surface.curvature_tensor, surface.view, look.camera_from_world);
    // Reflectance
    float through_the_stone = metal::max((metal::dot(surface.normal, bent_by_the_form.direction)
        + 0.6) / 1.6, 0.0);
    Color jade_2 = ramp_oklab(through_the_stone, jade);
    // Reflectance
    float polish = ggx(reflection_of(bent_by_the_form.direction, surface.normal, surface.view),
        0.1764, 0.09);
    Color polished = mix_colors_screen(jade_2, metal::float4(1.0, 0.9569, 0.8627, 1.0), polish);
    float light_from_behind = rim(look.back, surface.normal, surface.view, 0.5, 0.8, 1.0);
    Color glowing_edge = mix_colors_screen_2(polished, metal::float4(0.1843, 0.5608, 0.7216, 1.0),
        light_from_behind);
    return glowing_edge;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_4 };
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
    metal::float3 normal_4 [[user(loc1), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_4 };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        texel.xyz};
    return fs_mainOutput { shade(surface, look) };
}
