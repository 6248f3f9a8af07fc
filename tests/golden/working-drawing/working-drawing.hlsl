// Working drawing: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, line_nearness_map t0, facet_map t1, hidden_map t2.
// working-drawing.json says what to put there and how to draw.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    float4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    float4 screen;
};

struct Object {
    row_major float4x4 world_from_object;
    /// The inverse transpose, for normals.
    row_major float3x3 world_from_normal;
    int _pad2_0;
    float id;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

/// What is known before the fragment.
struct Look {
    float object_id;
    int _pad1_0;
    float2 viewport;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float depth;
    float4 line_nearness;
    float2 middle_surface;
    float4 hidden_nearness;
    float2 pixel;
    float magnification;
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    float4 colors[16];
    /// Places of the stops, in increasing order, four to a vector.
    float4 places[4];
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
};

struct ScreenPlace {
    /// From the picture's upper left corner, x to the right and y down, in pixels; centers lie at
    /// halves.
    float2 pixel;
    /// From the picture's middle, x to the right and y up, in picture heights.
    float2 place;
    /// From 0 at the left to 1 at the right, and from 0 below to 1 above: texture coordinates of
    /// the picture.
    float2 uv;
};

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    float4 kinds;
    /// Of borders of ids.
    float ids;
};

struct Outline {
    /// From 0 beside lines to 1 on them.
    float line_;
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of materials, 5 a border of ids; 0 beside lines.
    float kind;
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    float distance_;
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
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
static const float MOST_ON_SCREEN = 1000000000000000.0;
/// What is no nearer than this many pixels is not near at all: less is rounding.
static const float LEAST_NEARNESS = 1e-6;
static const Ramp paper = {{float4(0.8, 0.845, 0.885, 1.0), float4(0.955, 0.965, 0.955, 1.0),
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.75, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx}, 2u, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> line_nearness_map : register(t0);
Texture2D<float4> facet_map : register(t1);
Texture2D<float4> hidden_map : register(t2);

struct VertexOutput {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// v with 0 for each component that is NaN or infinite.
float4 finite_vec4(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return choose((asuint(v) & exponent) != exponent, v, (0.0).xxxx);
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = bits & 2147483647u;
    float largest = asfloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// [`bounded`], component by component.
float4 bounded_vec4(float4 v)
{
    uint4 bits = asuint(v);
    uint4 magnitude = bits & (2147483647u).xxxx;
    float4 largest = asfloat((bits & (2147483648u).xxxx) | (2139095039u).xxxx);
    const float4 numbers = choose(magnitude == (2139095040u).xxxx, largest, (0.0).xxxx);
    return choose(magnitude < (2139095040u).xxxx, v, numbers);
}

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
float modulo_floored(float x, float y)
{
    float left = x - floor(x);
    float wrapped = left < 0.0 ? left + 1.0 : left;
    float inside = ((wrapped >= 0.0) & (wrapped < 1.0)) ? wrapped : 0.0;
    return inside;
}

/// [`mixed`], component by component.
float4 mixed_vec4(float4 a, float4 b, float t)
{
    const float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w)
{
    const float d = bounded(x - edge);
    if (w < 1e-30) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
float4 hermite(float4 a, float4 b, float4 from_a, float4 to_b, float t)
{
    float4 d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// [`ramp_slope`] of one component.
float harmonic_slope(float before, float span_before, float after, float span_after)
{
    if (before * after <= 0.0) {
        return 0.0;
    }
    float weight_before = 2.0 * span_after + span_before;
    float weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
float4 ramp_slope(float4 rise_before, float span_before, float4 rise_after, float span_after)
{
    const float divided_value = divided(rise_after.x, span_after);
    const float divided_value_1 = divided(rise_after.y, span_after);
    const float harmonic_slope_value = harmonic_slope(divided(rise_before.y, span_before),
        span_before, divided_value_1, span_after);
    const float divided_value_2 = divided(rise_after.z, span_after);
    const float harmonic_slope_value_1 = harmonic_slope(divided(rise_before.z, span_before),
        span_before, divided_value_2, span_after);
    const float divided_value_3 = divided(rise_after.w, span_after);
    const float harmonic_slope_value_2 = harmonic_slope(divided(rise_before.w, span_before),
        span_before, divided_value_3, span_after);
    return float4(harmonic_slope(divided(rise_before.x, span_before), span_before, divided_value,
        span_after), harmonic_slope_value, harmonic_slope_value_1, harmonic_slope_value_2);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / max(rhs, 1u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
float4 ramp_at(Ramp ramp, float x, float w)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float4 places[4] = { (float4)0, (float4)0, (float4)0, (float4)0 };
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    float4 from_a = (0.0).xxxx;
    float4 to_b = (0.0).xxxx;

    uint count = min(ramp.count, 16u);
    if (count == 0u) {
        return (0.0).xxxx;
    }
    colors = ramp.colors;
    places = ramp.places;
    if (ramp.interpolation == INTERPOLATION_STEPPED) {
        color = colors[0];
        for (; i < count; i++) {
            const float step_filtered_value = step_filtered(x,
                places[min(uint(naga_div(i, 4u)), 3u)][min(uint(naga_mod(i, 4u)), 3u)], w);
            color = color + (colors[min(uint(i), 15u)] - colors[min(uint(i - 1u), 15u)])
                * step_filtered_value;
        }
        return bounded_vec4(color);
    }
    for (uint i_1 = 1u; i_1 < count; i_1++) {
        float places_now = places[min(uint(naga_div(i_1, 4u)), 3u)][min(uint(naga_mod(i_1, 4u)),
            3u)];
        at = places_now <= x ? i_1 : at;
    }
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    if ((at + 1u >= count) | (x <= place)) {
        return bounded_vec4(colors[min(uint(at), 15u)]);
    }
    uint after = at + 1u;
    float span = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)]
        - place;
    float t = clamp(divided(x - place, span), 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        return mixed_vec4(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)], t);
    }
    if (at > 0u) {
        float before = places[min(uint(naga_div(at - 1u, 4u)), 3u)][min(uint(naga_mod(at - 1u, 4u)),
            3u)];
        float4 colors_now = colors[min(uint(at - 1u), 15u)];
        float4 colors_now_1 = colors[min(uint(after), 15u)];
        float4 colors_now_2 = colors[min(uint(at), 15u)];
        from_a = ramp_slope(colors[min(uint(at), 15u)] - colors_now, place - before, colors_now_1
            - colors_now_2, span);
    }
    if (after + 1u < count) {
        float places_now_1 = places[min(uint(naga_div(after + 1u, 4u)),
            3u)][min(uint(naga_mod(after + 1u, 4u)), 3u)];
        float next = places_now_1 - (place + span);
        float4 colors_now_3 = colors[min(uint(after + 1u), 15u)];
        float4 colors_now_4 = colors[min(uint(after), 15u)];
        to_b = ramp_slope(colors[min(uint(after), 15u)] - colors[min(uint(at), 15u)], span,
            colors_now_3 - colors_now_4, next);
    }
    const float4 hermite_value = hermite(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)],
        span * from_a, span * to_b, t);
    return bounded_vec4(hermite_value);
}

/// Premultiplied RGBA of a straight color.
float4 premultiplied(float4 color)
{
    return float4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
float4 straight(float4 composite)
{
    if (composite.w <= 0.0) {
        return composite;
    }
    return float4(composite.xyz / (composite.w).xxx, composite.w);
}

/// The number of an object in texels, from 1 on.
float object_number(float object)
{
    return object - 4096.0 * floor(object / 4096.0) + 1.0;
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
float4 output(float4 color)
{
    return finite_vec4(straight(color));
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale)
{
    // Clip space is 2 high.
    return min(0.5 * scale / lerp(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
float2 place_in_picture(float2 pixel, float2 viewport)
{
    float2 from_middle = pixel - 0.5 * viewport;
    return float2(from_middle.x, -from_middle.y) / (max(viewport.y, 1.0)).xx;
}

ScreenPlace ConstructScreenPlace(float2 pixel, float2 place, float2 uv) {
    ScreenPlace ret = (ScreenPlace)0;
    ret.pixel = pixel;
    ret.place = place;
    ret.uv = uv;
    return ret;
}

/// Screen place
///
/// Where in the picture something is seen: for vignettes, gradients behind a figure, and patterns
/// that lie on the picture and not on surfaces.
ScreenPlace screen_place(float2 pixel, float2 viewport)
{
    const float2 place = place_in_picture(pixel, viewport);
    float aspect = viewport.x / max(viewport.y, 1.0);
    return ConstructScreenPlace(pixel, place,
        float2(0.5 + place.x / max(aspect, 1e-6), 0.5 + place.y));
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
float4 own_nearness(float4 nearness, float2 middle, float depth, float object, float pixels,
    float reach)
{
    bool local = (bool)0;
    bool local_1 = (bool)0;

    bool is_same_object = middle.y == object_number(object);
    float behind = (depth - middle.x) * pixels;
    if (!(abs(middle.y) < 0.5)) {
        if (is_same_object) {
            local_1 = abs(behind) <= 8.0625;
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
    float4 other = float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

LineWidths ConstructLineWidths(float4 kinds, float ids) {
    LineWidths ret = (LineWidths)0;
    ret.kinds = kinds;
    ret.ids = ids;
    return ret;
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths(float width, float4 shares, float ids)
{
    float4 widths = min(width, 10000.0) * shares;
    float id_width = min(width, 10000.0);
    const float4 choose_value = choose(widths > (1e-6).xxxx, widths, (0.0).xxxx);
    return ConstructLineWidths(choose_value, id_width > 1e-6 ? id_width : 0.0);
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths_2(float width, float4 shares, float ids)
{
    float4 widths = min(width, 10000.0) * shares;
    return ConstructLineWidths(choose(widths > (1e-6).xxxx, widths, (0.0).xxxx), 0.0);
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
float inner_line_covers(float distance_, float width)
{
    return clamp(width + 0.5 - distance_, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
float4 middle_line_covers(float4 distance_, float4 width)
{
    float4 half_ = 0.5 * width;
    return clamp(min(distance_ + (0.5).xxxx, half_) - max(distance_ - (0.5).xxxx, -half_),
        (0.0).xxxx, (1.0).xxxx);
}

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
float any_line_covers(float4 nearness, LineWidths widths, float reach)
{
    float4 near = clamp(nearness, (-reach).xxxx, (reach).xxxx);
    const float4 own = choose(abs(near) > (1e-6).xxxx,
        float4(widths.kinds.xyz, near.w < 0.0 ? widths.ids : widths.kinds.w), (0.0).xxxx);
    const float4 covers = middle_line_covers((reach).xxxx - abs(near), own);
    return max(max(covers.x, covers.y), max(covers.z, covers.w));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
float4 lines_cover(float4 nearness, float4 widths, float reach)
{
    float4 distance_ = (reach).xxxx - nearness;
    float4 covers = float4(inner_line_covers(distance_.x, widths.x),
        middle_line_covers(distance_, widths).yzw);
    return choose(nearness > (1e-6).xxxx, covers, (0.0).xxxx);
}

/// Hidden lines
///
/// Lines of what lies behind, seen through what is in front, as a value: where the next surface
/// ends, folds or meets another. Draw them pale, thin, or broken by a noise or a half-tone. The
/// surface in front shows them, one layer deep: what lies behind two surfaces is not seen, nor are
/// the backs of solids.
float hidden_lines_height(float width, float silhouettes, float creases, float borders,
    float4 nearness, float2 viewport)
{
    float4 shares = float4(silhouettes, creases, borders, borders);
    const LineWidths widths = line_widths(width * (0.001 * viewport.y), shares, borders);
    return any_line_covers(nearness, widths, min(16.0 * max(round(viewport.y / 800.0), 1.0), 31.0));
}

Outline ConstructOutline(float line_, float kind, float distance_) {
    Outline ret = (Outline)0;
    ret.line_ = line_;
    ret.kind = kind;
    ret.distance_ = distance_;
    return ret;
}

Outline drawn_outline(LineWidths line_widths, float4 of_edges, float reach)
{
    float kind = (float)0;

    float4 signed_ = clamp(of_edges, (-reach).xxxx, (reach).xxxx);
    float4 nearness = abs(signed_);
    float4 widths = float4(line_widths.kinds.xyz, 0.0);
    const float4 covers = lines_cover(nearness, widths, reach);
    float line_ = max(max(covers.x, covers.y), covers.z);
    float least = line_ - 0.0009765625;
    kind = signed_.w < 0.0 ? 5.0 : 4.0;
    kind = covers.z >= least ? 3.0 : kind;
    kind = covers.y >= least ? 2.0 : kind;
    kind = covers.x >= least ? 1.0 : kind;
    const float4 near = choose(widths > (0.0).xxxx, nearness, (0.0).xxxx);
    float nearest = max(max(near.x, near.y), near.z);
    return ConstructOutline(line_, line_ > 0.0009765625 ? kind : 0.0, reach - nearest);
}

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects, of materials and of ids, each as wide as it is told. A silhouette is drawn
/// by what lies in front, as wide as it is; where two surfaces meet, each draws its half of the
/// line. Wire the width to a curvature, a tone or a noise and lines taper.
Outline outline_height(float width, float silhouettes, float creases, float borders,
    float material_borders, float id_borders, float4 nearness, float2 middle, float depth,
    float object, float2 viewport, float magnification)
{
    float pixels = magnification * viewport.y;
    float reach = min(16.0 * max(round(viewport.y / 800.0), 1.0), 31.0);
    const float4 own = own_nearness(nearness, middle, depth, object, pixels, reach);
    float4 shares = float4(silhouettes, creases, borders, material_borders);
    const LineWidths widths = line_widths_2(width * (0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

VectorParts ConstructVectorParts(float x, float y, float z) {
    VectorParts ret = (VectorParts)0;
    ret.x = x;
    ret.y = y;
    ret.z = z;
    return ret;
}

/// Separate vector
///
/// The three numbers of a vector.
VectorParts separate_vector(float3 vector_)
{
    return ConstructVectorParts(vector_.x, vector_.y, 0.0);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    float facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    const float4 paper_2 = ramp_at(paper, facing, footprint_of(facing));
    const float what_lies_behind = hidden_lines_height(2.4, 1.0, 0.8, 1.0, surface.hidden_nearness,
        look.viewport);
    const ScreenPlace place = screen_place(surface.pixel, look.viewport);
    const VectorParts columns_and_rows = separate_vector(float3(place.pixel, 0.0));
    float diagonal = columns_and_rows.x + columns_and_rows.y;
    float dash_length = diagonal * 0.11;
    const float along_a_dash = modulo_floored(dash_length, 1.0);
    float ink_or_gap = along_a_dash - 0.58 < -0.0 ? 1.0 : 0.0;
    float dashed = what_lies_behind * ink_or_gap;
    // Mix colors
    const float4 dashed_on_the_paper = mixed_vec4(bounded_vec4(paper_2),
        float4(0.32, 0.42, 0.55, 1.0), dashed);
    const Outline what_is_seen = outline_height(5.0, 1.0, 0.55, 1.0, 0.0, 0.0,
        surface.line_nearness, surface.middle_surface, surface.depth, look.object_id, look.viewport,
        surface.magnification);
    // Mix colors
    const float4 inked = mixed_vec4(bounded_vec4(dashed_on_the_paper),
        float4(0.07, 0.09, 0.15, 1.0), what_is_seen.line_);
    const float4 output_2 = output(premultiplied(float4(inked.xyz, clamp(inked.w, 0.0, 1.0))));
    return output_2;
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 view, float depth, float4 line_nearness,
    float2 middle_surface, float4 hidden_nearness, float2 pixel, float magnification) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.depth = depth;
    ret.line_nearness = line_nearness;
    ret.middle_surface = middle_surface;
    ret.hidden_nearness = hidden_nearness;
    ret.pixel = pixel;
    ret.magnification = magnification;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_1 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = line_nearness_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_1 = facet_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_2 = facet_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_3 = hidden_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    const float size_on_screen_value = size_on_screen(-mul(float4(in_.position, 1.0),
        view.camera_from_world).z, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        -mul(float4(in_.position, 1.0), view.camera_from_world).z, texel,
        float2(texel_1.z, floor(abs(texel_2.w))), texel_3, in_.clip_.xy * view.screen.xy
        + view.screen.zw, size_on_screen_value);
    return finite_vec4(shade(surface));
}
