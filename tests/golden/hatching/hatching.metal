// Hatching: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_tensor_map texture(0).
// hatching.json says what to put there and how to draw.
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
    metal::float2 viewport;
    char _pad2[8];
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 position_object;
    metal::packed_float3 curvature_tensor;
    float magnification;
    metal::float3x3 world_from_normal;
};

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    metal::float2 place;
    char _pad1[8];
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    metal::float3 stretch;
};

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};

/// Style of strokes.
struct Strokes {
    /// Width of a stroke, in spacings.
    float width;
    /// Length of a stroke, in spacings; 0 for endless strokes.
    float length;
    /// Share of a stroke that its ends take, 0 to 1.
    float taper;
    /// Distance that strokes stray, in spacings.
    float wobble;
    /// Effect of a darker tone: from more strokes at 0 to wider ones at 1.
    float pressure;
    /// Growth of the strokes between others: from all together at 0 to one after the other at 1.
    float variation;
    uint seed;
};

/// A stroke as seen at a place.
struct Stroke {
    /// Turn of the stroke among its neighbors, 0 to 1.
    float turn;
    /// Width of the stroke at the place, as a share of its full width.
    float profile;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    metal::float2 place;
    char _pad1[8];
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    metal::float3 stretch;
};

struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};

constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
constant float MOST_ON_SCREEN = 1000000000000000.0;

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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(
    float x,
    float low,
    float high
) {
    float t = metal::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(
    float x
) {
    metal::float2 d = metal::float2(metal::dfdx(x), metal::dfdy(x));
    return bounded(metal::sqrt(metal::dot(d, d)));
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

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 z = normalize_moderate(toward, metal::float3(0.0, 0.0, 1.0));
    metal::float3 leaning = metal::cross(up, z);
    float square = metal::dot(leaning, leaning);
    metal::float3 aside = metal::abs(z.x)
        > 0.7 ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across = square > 0.00000001 ? leaning : metal::cross(aside, z);
    metal::float3 x = normalize_moderate(across - metal::dot(across, z) * z,
        metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(x, metal::cross(z, x), z);
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

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

/// Value noise: random numbers at lattice points, smooth between them.
float value_noise(
    metal::float3 p,
    uint seed
) {
    float sum = 0.0;
    metal::float3 corner = metal::floor(p);
    metal::float3 t = p - corner;
    metal::float3 f = t * t * t * (t * (t * 6.0 - metal::float3(15.0)) + metal::float3(10.0));
    metal::int3 cell = naga_f2i32(corner);
    for (int i = 0; i < 8; i++) {
        metal::int3 at = metal::int3(i & 1, (i >> 1u) & 1, i >> 2u);
        metal::float3 weight = metal::select(metal::float3(1.0) - f, f, at == metal::int3(1));
        metal::uint3 hash_pcg3d_value = hash_pcg3d(as_type<metal::uint3>(as_type<metal::int3>(as_type<metal::uint3>(cell) + as_type<metal::uint3>(at))) + seed * metal::uint3(2654435769u,
            2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5
            * (static_cast<metal::float3>(hash_pcg3d_value >> metal::uint3(8u))
            * 0.000000059604645).x;
    }
    return sum;
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    // Clip space is 2 high.
    return metal::min(0.5 * scale / metal::mix(1.0, metal::max(depth, 0.000001), perspective),
        MOST_ON_SCREEN);
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn = metal::float2(0.0, 1.0);
    metal::float3 x = bounded_vec3(turn.y * along + turn.x * across);
    metal::float3 y = bounded_vec3(turn.y * across - turn.x * along);
    metal::float2 turned = metal::float2(turn.y * place.x + turn.x * place.y, turn.y * place.y
        - turn.x * place.x);
    metal::float3 most = metal::float3(1000000000000000.0);
    metal::float3 stretch = metal::clamp(metal::float3(metal::dot(x, x), metal::dot(x, y),
        metal::dot(y, y)), -most, most);
    return StretchedPlace {turned, {}, stretch};
}

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
metal::float3 gradient_on_picture(
    metal::float3 g,
    metal::float3 normal,
    metal::float3 view
) {
    float facing = metal::dot(normal, view);
    return g - normal * (metal::dot(g, view)
        / (facing >= 0.0 ? metal::max(facing, 0.125) : metal::min(facing, -0.125)));
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
StretchedPlace place_on_surface(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    metal::float3 normal,
    metal::float3 view,
    float magnification,
    float angle
) {
    float height = 1.0 / metal::clamp(magnification, 0.000000000000001, 1000000000000000.0);
    metal::float3 x = bounded_vec3(gradient_on_picture(along, normal, view) * height);
    metal::float3 y = bounded_vec3(gradient_on_picture(across, normal, view) * height);
    return mark_place_of(place, x, y, angle);
}

/// A place on a surface for strokes across an axis of the object.
StretchedPlace place_across(
    metal::float3 axis,
    metal::float3 position,
    metal::float3x3 world_from_normal,
    metal::float3 normal,
    metal::float3 view,
    float magnification,
    float angle
) {
    metal::float3x3 axes = axes_around(axis, metal::float3(0.0, 1.0, 0.0));
    metal::float2 place = metal::float2(metal::dot(position, axes[0]),
        metal::dot(position, axes[2]));
    metal::float3 along = world_from_normal * axes[0];
    metal::float3 across = world_from_normal * axes[2];
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(
    metal::float2 place,
    metal::float3 stretch,
    metal::float2 viewport,
    float count
) {
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / metal::max(viewport.y, 1.0) : count;
    metal::float2 p = metal::clamp(place * scale, metal::float2(-4194304.0),
        metal::float2(4194304.0));
    metal::float3 s = metal::clamp(bounded_vec3(stretch), metal::float3(-1000000000000000.0),
        metal::float3(1000000000000000.0));
    return SpacedPlace {p, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : s};
}

/// The stroke of a line at x, in one octave. A line's name is an odd number and the octave that it
/// first lies in.
Stroke stroke_at(
    metal::int2 line,
    float x,
    int zoom,
    Strokes style
) {
    metal::uint3 hash_pcg3d_value = hash_pcg3d(as_type<metal::uint3>(metal::int3(line, 1048576))
        + style.seed * metal::uint3(2654435769u, 2246822507u, 3266489909u));
    metal::float3 own = static_cast<metal::float3>(hash_pcg3d_value >> metal::uint3(8u))
        * 0.000000059604645;
    float along = metal::clamp(x
        * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom) + as_type<uint>(127)))
        << 23u) / 24.0, -1000000.0, 1000000.0) + own.x;
    float index = metal::floor(along);
    metal::uint3 hash_pcg3d_value_1 = hash_pcg3d(as_type<metal::uint3>(metal::int3(line,
        naga_f2i32(index))) + (style.seed + as_type<uint>(zoom))
        * metal::uint3(2654435769u, 2246822507u, 3266489909u));
    metal::float3 chance = static_cast<metal::float3>(hash_pcg3d_value_1 >> metal::uint3(8u))
        * 0.000000059604645;
    float from_end = metal::min(along - index, 1.0 - (along - index));
    float slope = metal::min(from_end / (0.5 * style.taper), 1.0);
    return Stroke {chance.x, slope * (2.0 - slope)};
}

/// A stroke where an octave fades into the next.
Stroke stroke_between(
    metal::int2 line,
    float x,
    float level,
    Strokes style
) {
    float zoom = metal::floor(level);
    Stroke a = stroke_at(line, x, naga_f2i32(zoom), style);
    Stroke b = stroke_at(line, x, as_type<int>(as_type<uint>(naga_f2i32(zoom)) + as_type<uint>(1)),
        style);
    float f = level - zoom;
    return Stroke {metal::mix(a.turn, b.turn, f), metal::mix(a.profile, b.profile, f)};
}

int naga_neg(int val) {
    return as_type<int>(-as_type<uint>(val));
}

/// Distance that strokes stray at a place of an octave, in spacings of the place.
float stray_at(
    metal::float2 place,
    int zoom,
    uint seed
) {
    metal::float2 p = place * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom)
        + as_type<uint>(127))) << 23u);
    float value_noise_value = value_noise(metal::float3(0.11 * p.x, 0.45 * p.y, 0.5), seed);
    return (value_noise_value - 0.5) * 2.0
        * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_neg(zoom))
        + as_type<uint>(127))) << 23u);
}

/// Share of a footprint of `w` that a band covers whose middle is t away and which reaches `half`
/// to both sides.
float band_filtered(
    float t,
    float half_,
    float w
) {
    if (w < 0.000000000000000000000000000001) {
        return ((metal::abs(t) <= half_) & (half_ > 0.0)) ? 1.0 : 0.0;
    }
    return metal::clamp((metal::clamp(t + 0.5 * w, -half_, half_)
        - metal::clamp(t - 0.5 * w, -half_, half_)) / w, 0.0, 1.0);
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

/// The name of a whole place's line in an octave: an odd number and the octave that the line first
/// lies in. The line at 0 lies in all.
metal::int2 line_of(
    int whole,
    int octave
) {
    int power = whole == 0 ? 1 : (whole & naga_neg(whole));
    // log2 of a power of two, by its bits.
    int octaves = as_type<int>(as_type<uint>(static_cast<int>(as_type<uint>(static_cast<float>(power)) >> 23u)) - as_type<uint>(127));
    return whole == 0 ? metal::int2(0) : metal::int2(naga_div(whole, power),
        as_type<int>(as_type<uint>(octave) - as_type<uint>(octaves)));
}

/// The ink of one direction of strokes. `place` is along and across, in spacings at `level` 0; `w`
/// is the footprint of the coordinate across. The average ink is `ink` times the width, but for
/// tapers.
float hatched(
    metal::float2 place,
    float w,
    float level,
    float ink,
    Strokes style
) {
    if (!(ink > 0.0)) {
        return 0.0;
    }
    float number = metal::pow(ink, 0.75);
    float width = style.width * metal::pow(ink, 0.25);
    float zoom = metal::floor(level);
    float stray_at_value = stray_at(place,
        as_type<int>(as_type<uint>(naga_f2i32(zoom)) + as_type<uint>(1)), style.seed);
    float stray = metal::mix(stray_at(place, naga_f2i32(zoom), style.seed), stray_at_value, level
        - zoom);
    float across = place.y + style.wobble * stray;
    float density = metal::max(level + log2_stable(metal::max(number, 0.000000001)), -40.0);
    float octave = metal::floor(density);
    float growth = exp2_stable(density - octave) - 1.0;
    float scale = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(octave))
        + as_type<uint>(127))) << 23u);
    float q = metal::clamp(across * scale, -4194304.0, 4194304.0);
    float half_ = 0.5 * width * exp2_stable(octave - level);
    float footprint = w * scale;
    int whole = naga_f2i32(metal::rint(q));
    Stroke old = stroke_between(line_of(whole, naga_f2i32(octave)), place.x, level, style);
    float middle = metal::floor(q);
    Stroke young = stroke_between(metal::int2(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(naga_f2i32(middle)))) + as_type<uint>(1)),
        as_type<int>(as_type<uint>(naga_f2i32(octave)) + as_type<uint>(1))), place.x, level, style);
    float grown = metal::clamp((growth - 0.75 * young.turn) / 0.25, 0.0, 1.0);
    float a = band_filtered(q - static_cast<float>(whole), half_ * old.profile, footprint);
    float b = band_filtered(q - middle - 0.5, half_ * grown * young.profile, footprint);
    float mean = metal::min(2.0 * half_ * (1.0 + growth), 1.0);
    return metal::mix(metal::max(a, b), mean, metal::smoothstep(0.75, 1.5, footprint));
}

/// The ink of strokes in up to four directions, each turned by `cross` radians from the one before:
/// the first take the light tones, and the others come in one after the other.
float cross_hatched(
    SpacedPlace at,
    float ink,
    int layers,
    float cross,
    Strokes style
) {
    Strokes own = {};
    float free = 1.0;
    metal::float2 x = metal::dfdx(at.place);
    metal::float2 y = metal::dfdy(at.place);
    float amount = ink * 3.0;
    for (int i = 0; i < 4; i++) {
        if (i < 3) {
            float x_2 = static_cast<float>(i) * cross;
            metal::float2 turn = metal::float2(metal::sin(x_2), metal::cos(x_2));
            metal::float2 along = metal::float2(turn.y, turn.x);
            metal::float2 across = metal::float2(-turn.x, turn.y);
            float w = metal::length(metal::float2(metal::dot(across, x), metal::dot(across, y)));
            float square = metal::dot(metal::float3(across.x * across.x, 2.0 * across.x * across.y,
                across.y * across.y), at.stretch);
            float log2_stable_value = log2_stable(metal::max(metal::max(square,
                (at.stretch.x + at.stretch.z) / 65.0), 0.000000000000000000000000000001));
            float level = metal::clamp(-0.5 * log2_stable_value, -16.0, 16.0);
            metal::float2 place = metal::float2(metal::dot(along, at.place),
                metal::dot(across, at.place));
            own = style;
            own.seed = 4u + 101u * static_cast<uint>(i);
            free = free * (1.0 - hatched(place, w, level,
                metal::clamp(amount - static_cast<float>(i), 0.0, 1.0), own));
        }
    }
    return 1.0 - free;
}

/// Mark place
///
/// Where strokes and dots are anchored, and which way strokes go: on the picture, on the picture
/// but moving along with the object, along texture coordinates, across an axis of the object, or
/// around the light so that they turn with it. Wire both outputs to Hatching, Stippling, Brush
/// strokes or Paper grain, which keep their marks as large on the picture as they are, however far
/// the surface is.
MarkPlace mark_place_light(
    Light light,
    metal::float3 normal,
    float angle,
    metal::float3 view,
    metal::float3 position_object,
    metal::float3x3 world_from_normal,
    float magnification
) {
    metal::float3 toward = light.direction * world_from_normal;
    StretchedPlace m = place_across(toward, position_object, world_from_normal, normal, view,
        magnification, angle);
    return MarkPlace {m.place, {}, m.stretch};
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
float faded_in(
    float x,
    float limit,
    float softness
) {
    float width = metal::length(metal::float2(metal::min(footprint_of(x), 1000000000000000.0),
        limit * softness));
    return metal::clamp(0.5 + bounded(bounded(x) - limit) / width, 0.0, 1.0);
}

/// The look at one point of the surface.
metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    // Reflectance
    float light_and_shade = metal::max((metal::dot(surface.normal, look.key.direction) + 0.35)
        / 1.35, 0.0);
    float tone_to_draw = metal::mix(0.04, 1.0, metal::min((light_and_shade - 0.0) / 0.85, 1.0));
    MarkPlace around_the_light = mark_place_light(look.key, surface.normal, 0.0, surface.view,
        surface.position_object, surface.world_from_normal, surface.magnification);
    SpacedPlace spaced_value = spaced(around_the_light.place, around_the_light.stretch,
        look.viewport, 120.0);
    // Hatching
    float pen_strokes = cross_hatched(spaced_value, 1.0 - metal::min(tone_to_draw, 1.0), 3, 0.8,
        Strokes {0.42, 24.0, 0.6, 0.45, 0.25, 1.0, 4u});
    float contour = eased(metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0), 0.34,
        0.2);
    // Combine tones
    float ink = metal::max(pen_strokes, contour);
    float faded_in_value = faded_in(-principal_curvatures(surface.curvature_tensor).y, 75.0, 0.3);
    // Inner contour
    float features = faded_in_value * metal::smoothstep(0.05, 0.3,
        metal::dot(surface.normal, surface.view));
    // Combine tones
    float strokes_and_features = metal::max(ink, features);
    metal::float4 pen_on_paper = metal::mix(metal::float4(0.965, 0.937, 0.875, 1.0),
        metal::float4(0.12, 0.105, 0.16, 1.0), strokes_and_features);
    return pen_on_paper;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
};

struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};

vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_4 };
    metal::float4 world = object.world_from_object * metal::float4(vertex_.position, 1.0);
    const auto _tmp = Varyings {view.clip_from_world * world, world.xyz, vertex_.position,
        object.world_from_normal * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object_1 [[user(loc1), center_perspective]];
    metal::float3 normal_4 [[user(loc2), center_perspective]];
};

struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};

fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_tensor_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object_1,
        varyings_1.normal_4 };
    metal::float3 facing = normalize_seen(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = curvature_tensor_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    float size_on_screen_value = size_on_screen(-(view.camera_from_world
        * metal::float4(in.position, 1.0)).z, view.eye.w,
        metal::length(metal::float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, texel.xyz, size_on_screen_value, object.world_from_normal};
    return fs_mainOutput { shade(surface, look) };
}
