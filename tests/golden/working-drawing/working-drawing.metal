// Working drawing: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), line_nearness_map texture(0), facet_map texture(1), hidden_map texture(2).
// working-drawing.json says what to put there and how to draw.
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
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    metal::float4 screen;
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
    float object_id;
    char _pad1[4];
    metal::float2 viewport;
};

/// The surface under the fragment, in world space.
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float depth;
    metal::float4 line_nearness;
    metal::float2 middle_surface;
    char _pad5[8];
    metal::float4 hidden_nearness;
    metal::float2 pixel;
    float magnification;
    char _pad8[4];
};

typedef metal::float4 Color;
typedef metal::float4 Composite;
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

struct ScreenPlace {
    /// From the picture's upper left corner, x to the right and y down, in pixels; centers lie at
    /// halves.
    metal::float2 pixel;
    /// From the picture's middle, x to the right and y up, in picture heights.
    metal::float2 place;
    /// From 0 at the left to 1 at the right, and from 0 below to 1 above: texture coordinates of
    /// the picture.
    metal::float2 uv;
};

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    metal::float4 kinds;
    /// Of borders of ids.
    float ids;
    char _pad2[12];
};

struct Outline {
    /// From 0 beside lines to 1 on them.
    float line;
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of materials, 5 a border of ids; 0 beside lines.
    float kind;
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    float distance;
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
    metal::float3 normal;
};

struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};

constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint INTERPOLATION_SMOOTH = 1u;
constant uint INTERPOLATION_STEPPED = 2u;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
constant float MOST_ON_SCREEN = 1000000000000000.0;
/// What is no nearer than this many pixels is not near at all: less is rounding.
constant float LEAST_NEARNESS = 0.000001;
constant Ramp paper = Ramp {type_7 {{metal::float4(0.8, 0.845, 0.885, 1.0),
    metal::float4(0.955, 0.965, 0.955, 1.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}},
    type_8 {{metal::float4(0.0, 0.75, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0),
    metal::float4(0.0)}}, 2u, 1u};

/// v with 0 for each component that is NaN or infinite.
metal::float4 finite_vec4(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
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

/// [`bounded`], component by component.
metal::float4 bounded_vec4(
    metal::float4 v
) {
    metal::uint4 bits = as_type<metal::uint4>(v);
    metal::uint4 magnitude = bits & metal::uint4(2147483647u);
    metal::float4 largest = as_type<metal::float4>((bits & metal::uint4(2147483648u))
        | metal::uint4(2139095039u));
    metal::float4 numbers = metal::select(metal::float4(0.0), largest,
        magnitude == metal::uint4(2139095040u));
    return metal::select(numbers, v, magnitude < metal::uint4(2139095040u));
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

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
float modulo_floored(
    float x,
    float y
) {
    float left = x - metal::floor(x);
    float wrapped = left < 0.0 ? left + 1.0 : left;
    float inside = ((wrapped >= 0.0) & (wrapped < 1.0)) ? wrapped : 0.0;
    return inside;
}

/// [`mixed`], component by component.
metal::float4 mixed_vec4(
    metal::float4 a,
    metal::float4 b,
    float t
) {
    metal::float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
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
    float d = bounded(x - edge);
    if (w < 0.000000000000000000000000000001) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return metal::clamp(0.5 + bounded(d / w), 0.0, 1.0);
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

/// [`ramp_slope`] of one component.
float harmonic_slope(
    float before,
    float span_before,
    float after,
    float span_after
) {
    if (before * after <= 0.0) {
        return 0.0;
    }
    float weight_before = 2.0 * span_after + span_before;
    float weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
metal::float4 ramp_slope(
    metal::float4 rise_before,
    float span_before,
    metal::float4 rise_after,
    float span_after
) {
    float harmonic_slope_value = harmonic_slope(divided(rise_before.x, span_before), span_before,
        divided(rise_after.x, span_after), span_after);
    float divided_value = divided(rise_after.y, span_after);
    float divided_value_1 = divided(rise_after.z, span_after);
    float harmonic_slope_value_1 = harmonic_slope(divided(rise_before.z, span_before), span_before,
        divided_value_1, span_after);
    float divided_value_2 = divided(rise_after.w, span_after);
    float harmonic_slope_value_2 = harmonic_slope(divided(rise_before.w, span_before), span_before,
        divided_value_2, span_after);
    return metal::float4(harmonic_slope_value,
        harmonic_slope(divided(rise_before.y, span_before), span_before, divided_value, span_after),
        harmonic_slope_value_1, harmonic_slope_value_2);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
Color ramp_at(
    Ramp ramp,
    float x,
    float w
) {
    type_7 colors = {};
    type_8 places = {};
    metal::float4 color = {};
    uint i = 1u;
    uint at = 0u;
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    metal::float4 from_a = metal::float4(0.0);
    metal::float4 to_b = metal::float4(0.0);
    uint count = metal::min(ramp.count, 16u);
    if (count == 0u) {
        return metal::float4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if (ramp.interpolation == INTERPOLATION_STEPPED) {
        color = colors.inner[0];
        for (; i < count; i++) {
            float step_filtered_value = step_filtered(x,
                places.inner[naga_div(i, 4u)][naga_mod(i, 4u)], w);
            color = color + (colors.inner[i] - colors.inner[i - 1u]) * step_filtered_value;
        }
        return bounded_vec4(color);
    }
    for (uint i_1 = 1u; i_1 < count; i_1++) {
        float places_now = places.inner[naga_div(i_1, 4u)][naga_mod(i_1, 4u)];
        at = places_now <= x ? i_1 : at;
    }
    float place = places.inner[naga_div(at, 4u)][naga_mod(at, 4u)];
    if ((at + 1u >= count) | (x <= place)) {
        return bounded_vec4(colors.inner[at]);
    }
    uint after = at + 1u;
    float span = places.inner[naga_div(after, 4u)][naga_mod(after, 4u)] - place;
    float t = metal::clamp(divided(x - place, span), 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        return mixed_vec4(colors.inner[at], colors.inner[after], t);
    }
    if (at > 0u) {
        float before = places.inner[naga_div(at - 1u, 4u)][naga_mod(at - 1u, 4u)];
        metal::float4 ramp_slope_value = ramp_slope(colors.inner[at] - colors.inner[at - 1u],
            place - before, colors.inner[after] - colors.inner[at], span);
        from_a = ramp_slope_value;
    }
    if (after + 1u < count) {
        float next = places.inner[naga_div(after + 1u, 4u)][naga_mod(after + 1u, 4u)]
            - (place + span);
        to_b = ramp_slope(colors.inner[after] - colors.inner[at], span, colors.inner[after + 1u]
            - colors.inner[after], next);
    }
    return bounded_vec4(hermite(colors.inner[at], colors.inner[after], span * from_a, span * to_b,
        t));
}

/// Premultiplied RGBA of a straight color.
Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

/// The number of an object in texels, from 1 on.
float object_number(
    float object
) {
    return object - 4096.0 * metal::floor(object / 4096.0) + 1.0;
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
Color output(
    Composite color
) {
    return finite_vec4(straight(color));
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

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 from_middle = pixel - 0.5 * viewport;
    return metal::float2(from_middle.x, -from_middle.y)
        / metal::float2(metal::max(viewport.y, 1.0));
}

/// Screen place
///
/// Where in the picture something is seen: for vignettes, gradients behind a figure, and patterns
/// that lie on the picture and not on surfaces.
ScreenPlace screen_place(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 place = place_in_picture(pixel, viewport);
    float aspect = viewport.x / metal::max(viewport.y, 1.0);
    return ScreenPlace {pixel, place,
        metal::float2(0.5 + place.x / metal::max(aspect, 0.000001), 0.5 + place.y)};
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
metal::float4 own_nearness(
    metal::float4 nearness,
    metal::float2 middle,
    float depth,
    float object,
    float pixels,
    float reach
) {
    bool local = {};
    bool local_1 = {};
    bool is_same_object = middle.y == object_number(object);
    float behind = (depth - middle.x) * pixels;
    if (!(metal::abs(middle.y) < 0.5)) {
        if (is_same_object) {
            local_1 = metal::abs(behind) <= 8.0625;
        } else {
            local_1 = false;
        }
        local = local_1;
    } else {
        local = true;
    }
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    bool is_own = local;
    bool is_in_front = behind < (is_same_object ? -8.0625 : -2.0625);
    metal::float4 other = metal::float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths(
    float width,
    metal::float4 shares,
    float ids
) {
    metal::float4 widths = metal::min(width, 10000.0) * shares;
    float id_width = metal::min(width, 10000.0);
    return LineWidths {metal::select(metal::float4(0.0), widths, widths > metal::float4(0.000001)),
        id_width > 0.000001 ? id_width : 0.0};
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths_2(
    float width,
    metal::float4 shares,
    float ids
) {
    metal::float4 widths = metal::min(width, 10000.0) * shares;
    return LineWidths {metal::select(metal::float4(0.0), widths, widths > metal::float4(0.000001)),
        0.0};
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
float inner_line_covers(
    float distance,
    float width
) {
    return metal::clamp(width + 0.5 - distance, 0.0, metal::min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
metal::float4 middle_line_covers(
    metal::float4 distance,
    metal::float4 width
) {
    metal::float4 half_ = 0.5 * width;
    return metal::clamp(metal::min(distance + metal::float4(0.5), half_)
        - metal::max(distance - metal::float4(0.5), -half_), metal::float4(0.0),
        metal::float4(1.0));
}

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
float any_line_covers(
    metal::float4 nearness,
    LineWidths widths,
    float reach
) {
    metal::float4 near = metal::clamp(nearness, metal::float4(-reach), metal::float4(reach));
    metal::float4 own = metal::select(metal::float4(0.0),
        metal::float4(widths.kinds.xyz, near.w < 0.0 ? widths.ids : widths.kinds.w),
        metal::abs(near) > metal::float4(0.000001));
    metal::float4 covers = middle_line_covers(metal::float4(reach) - metal::abs(near), own);
    return metal::max(metal::max(covers.x, covers.y), metal::max(covers.z, covers.w));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
metal::float4 lines_cover(
    metal::float4 nearness,
    metal::float4 widths,
    float reach
) {
    metal::float4 distance = metal::float4(reach) - nearness;
    metal::float4 covers = metal::float4(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance, widths).yzw);
    return metal::select(metal::float4(0.0), covers, nearness > metal::float4(0.000001));
}

/// Hidden lines
///
/// Lines of what lies behind, seen through what is in front, as a value: where the next surface
/// ends, folds or meets another. Draw them pale, thin, or broken by a noise or a half-tone. The
/// surface in front shows them, one layer deep: what lies behind two surfaces is not seen, nor are
/// the backs of solids.
float hidden_lines_height(
    float width,
    float silhouettes,
    float creases,
    float borders,
    metal::float4 nearness,
    metal::float2 viewport
) {
    metal::float4 shares = metal::float4(silhouettes, creases, borders, borders);
    LineWidths widths = line_widths(width * (0.001 * viewport.y), shares, borders);
    return any_line_covers(nearness, widths,
        metal::min(16.0 * metal::max(metal::rint(viewport.y / 800.0), 1.0), 31.0));
}

Outline drawn_outline(
    LineWidths line_widths,
    metal::float4 of_edges,
    float reach
) {
    float kind = {};
    metal::float4 signed_ = metal::clamp(of_edges, metal::float4(-reach), metal::float4(reach));
    metal::float4 nearness = metal::abs(signed_);
    metal::float4 widths = metal::float4(line_widths.kinds.xyz, 0.0);
    metal::float4 covers = lines_cover(nearness, widths, reach);
    float line = metal::max(metal::max(covers.x, covers.y), covers.z);
    float least = line - 0.0009765625;
    kind = signed_.w < 0.0 ? 5.0 : 4.0;
    kind = covers.z >= least ? 3.0 : kind;
    kind = covers.y >= least ? 2.0 : kind;
    kind = covers.x >= least ? 1.0 : kind;
    metal::float4 near = metal::select(metal::float4(0.0), nearness, widths > metal::float4(0.0));
    float nearest = metal::max(metal::max(near.x, near.y), near.z);
    return Outline {line, line > 0.0009765625 ? kind : 0.0, reach - nearest};
}

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects, of materials and of ids, each as wide as it is told. A silhouette is drawn
/// by what lies in front, as wide as it is; where two surfaces meet, each draws its half of the
/// line. Wire the width to a curvature, a tone or a noise and lines taper.
Outline outline_height(
    float width,
    float silhouettes,
    float creases,
    float borders,
    float material_borders,
    float id_borders,
    metal::float4 nearness,
    metal::float2 middle,
    float depth,
    float object,
    metal::float2 viewport,
    float magnification
) {
    float pixels = magnification * viewport.y;
    float reach = metal::min(16.0 * metal::max(metal::rint(viewport.y / 800.0), 1.0), 31.0);
    metal::float4 own = own_nearness(nearness, middle, depth, object, pixels, reach);
    metal::float4 shares = metal::float4(silhouettes, creases, borders, material_borders);
    LineWidths widths = line_widths_2(width * (0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
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
    Surface surface,
    constant Look& look
) {
    float facing = metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0);
    Color paper_2 = ramp_at(paper, facing, footprint_of(facing));
    float what_lies_behind = hidden_lines_height(2.4, 1.0, 0.8, 1.0, surface.hidden_nearness,
        look.viewport);
    ScreenPlace place = screen_place(surface.pixel, look.viewport);
    VectorParts columns_and_rows = separate_vector(metal::float3(place.pixel, 0.0));
    float diagonal = columns_and_rows.x + columns_and_rows.y;
    float dash_length = diagonal * 0.11;
    float along_a_dash = modulo_floored(dash_length, 1.0);
    float ink_or_gap = along_a_dash - 0.58 < -0.0 ? 1.0 : 0.0;
    float dashed = what_lies_behind * ink_or_gap;
    // Mix colors
    metal::float4 dashed_on_the_paper = mixed_vec4(bounded_vec4(paper_2),
        metal::float4(0.32, 0.42, 0.55, 1.0), dashed);
    Outline what_is_seen = outline_height(5.0, 1.0, 0.55, 1.0, 0.0, 0.0, surface.line_nearness,
        surface.middle_surface, surface.depth, look.object_id, look.viewport,
        surface.magnification);
    // Mix colors
    metal::float4 inked = mixed_vec4(bounded_vec4(dashed_on_the_paper),
        metal::float4(0.07, 0.09, 0.15, 1.0), what_is_seen.line);
    Color output_2 = output(premultiplied(metal::float4(inked.xyz,
        metal::clamp(inked.w, 0.0, 1.0))));
    return output_2;
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

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
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
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> line_nearness_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> facet_map [[texture(1)]]
, metal::texture2d<float, metal::access::sample> hidden_map [[texture(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal };
    metal::float3 facing = normalize_seen_balanced(in.normal);
    metal::float3 normal = is_front ? facing : -facing;
    metal::float4 texel = line_nearness_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_1 = facet_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_2 = facet_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 texel_3 = hidden_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    float size_on_screen_value = size_on_screen(-(view.camera_from_world
        * metal::float4(in.position, 1.0)).z, view.eye.w,
        metal::length(metal::float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = Surface {normal, metal::normalize(view.eye.xyz - view.eye.w * in.position),
        -(view.camera_from_world * metal::float4(in.position, 1.0)).z, texel,
        metal::float2(texel_1.z, metal::floor(metal::abs(texel_2.w))), {}, texel_3, in.clip.xy
        * view.screen.xy + view.screen.zw, size_on_screen_value};
    return fs_mainOutput { finite_vec4(shade(surface, look)) };
}
