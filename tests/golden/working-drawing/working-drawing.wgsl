// Working drawing: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, line_nearness_map 3, facet_map 4, hidden_map 5.
// working-drawing.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    screen: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
}

/// What is known before the fragment.
struct Look {
    object_id: f32,
    viewport: vec2f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    depth: f32,
    line_nearness: vec4f,
    middle_surface: vec2f,
    hidden_nearness: vec4f,
    pixel: vec2f,
    magnification: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var line_nearness_map: texture_2d<f32>;
@group(0) @binding(4) var facet_map: texture_2d<f32>;
@group(0) @binding(5) var hidden_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    colors: array<vec4f, 16>,
    /// Places of the stops, in increasing order, four to a vector.
    places: array<vec4f, 4>,
    /// Number of stops that count.
    count: u32,
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    interpolation: u32,
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
fn modulo_floored(x: f32, y: f32) -> f32 {
    let left = x - floor(x);
    let wrapped = select(left, left + 1.0, left < 0.0);
    let inside = select(0.0, wrapped, (wrapped >= 0.0) & (wrapped < 1.0));
    return inside;
}

/// [`mixed`], component by component.
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let d = bounded_vec4(b - a);
    return bounded_vec4(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = bounded(x - edge);
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

const INTERPOLATION_SMOOTH: u32 = 1u;
const INTERPOLATION_STEPPED: u32 = 2u;
/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
fn hermite(a: vec4f, b: vec4f, from_a: vec4f, to_b: vec4f, t: f32) -> vec4f {
    let d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    let count = min(ramp.count, 16u);
    if count == 0u {
        return vec4f(0.0);
    }
    var colors = ramp.colors;
    var places = ramp.places;
    if ramp.interpolation == INTERPOLATION_STEPPED {
        var color = colors[0];
        for (var i = 1u; i < count; i++) {
            color += (colors[i] - colors[i - 1u]) * step_filtered(x, places[i / 4u][i % 4u], w);
        }
        return bounded_vec4(color);
    }
    var at = 0u;
    for (var i = 1u; i < count; i++) {
        at = select(at, i, places[i / 4u][i % 4u] <= x);
    }
    let place = places[at / 4u][at % 4u];
    if (at + 1u >= count) | (x <= place) {
        return bounded_vec4(colors[at]);
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    if ramp.interpolation != INTERPOLATION_SMOOTH {
        return mixed_vec4(colors[at], colors[after], t);
    }
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    var from_a = vec4f(0.0);
    var to_b = vec4f(0.0);
    if at > 0u {
        let before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    if after + 1u < count {
        let next = places[(after + 1u) / 4u][(after + 1u) % 4u] - (place + span);
        to_b = ramp_slope(colors[after] - colors[at], span, colors[after + 1u] - colors[after],
            next);
    }
    return bounded_vec4(hermite(colors[at], colors[after], span * from_a, span * to_b, t));
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
fn ramp_slope(rise_before: vec4f, span_before: f32, rise_after: vec4f, span_after: f32) -> vec4f {
    return vec4f(
        harmonic_slope(divided(rise_before.x, span_before), span_before,
            divided(rise_after.x, span_after), span_after),
        harmonic_slope(divided(rise_before.y, span_before), span_before,
            divided(rise_after.y, span_after), span_after),
        harmonic_slope(divided(rise_before.z, span_before), span_before,
            divided(rise_after.z, span_after), span_after),
        harmonic_slope(divided(rise_before.w, span_before), span_before,
            divided(rise_after.w, span_after), span_after),
    );
}

/// [`ramp_slope`] of one component.
fn harmonic_slope(before: f32, span_before: f32, after: f32, span_after: f32) -> f32 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let weight_before = 2.0 * span_after + span_before;
    let weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// Premultiplied RGBA of a straight color.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

const OBJECTS = 4096.0;
/// The number of an object in texels, from 1 on.
fn object_number(object: f32) -> f32 {
    return object - OBJECTS * floor(object / OBJECTS) + 1.0;
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const MOST_ON_SCREEN: f32 = 1e15;
/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
fn size_on_screen(depth: f32, perspective: f32, scale: f32) -> f32 {
    // Clip space is 2 high.
    return min(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
fn place_in_picture(pixel: vec2f, viewport: vec2f) -> vec2f {
    let from_middle = pixel - 0.5 * viewport;
    return vec2f(from_middle.x, -from_middle.y) / max(viewport.y, 1.0);
}

/// Screen place
///
/// Where in the picture something is seen: for vignettes, gradients behind a figure, and patterns
/// that lie on the picture and not on surfaces.
fn screen_place(pixel: vec2f, viewport: vec2f) -> ScreenPlace {
    let place = place_in_picture(pixel, viewport);
    let aspect = viewport.x / max(viewport.y, 1.0);
    return ScreenPlace(pixel, place, vec2f(0.5 + place.x / max(aspect, 1e-6), 0.5 + place.y));
}

struct ScreenPlace {
    /// From the picture's upper left corner, x to the right and y down, in pixels; centers lie at
    /// halves.
    pixel: vec2f,
    /// From the picture's middle, x to the right and y up, in picture heights.
    place: vec2f,
    /// From 0 at the left to 1 at the right, and from 0 below to 1 above: texture coordinates of
    /// the picture.
    uv: vec2f,
}

/// What is no nearer than this many pixels is not near at all: less is rounding.
const LEAST_NEARNESS: f32 = 1e-6;
/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
fn own_nearness(nearness: vec4f, middle: vec2f, depth: f32, object: f32, pixels: f32,
    reach: f32) -> vec4f {
    let is_same_object = middle.y == object_number(object);
    let behind = (depth - middle.x) * pixels;
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    let is_own = abs(middle.y) < 0.5 || (is_same_object && abs(behind) <= 8.0625);
    let is_in_front = behind < select(-2.0625, -8.0625, is_same_object);
    let other = vec4f(select(0.0, reach, is_in_front), 0.0, nearness.z, 0.0);
    return select(other, nearness, is_own);
}

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    kinds: vec4f,
    /// Of borders of ids.
    ids: f32,
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
fn line_widths(width: f32, shares: vec4f, ids: f32) -> LineWidths {
    let widths = min(width, 1e4) * shares;
    let id_width = min(width, 1e4);
    return LineWidths(select(vec4f(0.0), widths, widths > vec4f(1e-6)),
        select(0.0, id_width, id_width > 1e-6));
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
fn line_widths_2(width: f32, shares: vec4f, ids: f32) -> LineWidths {
    let widths = min(width, 1e4) * shares;
    return LineWidths(select(vec4f(0.0), widths, widths > vec4f(1e-6)), 0.0);
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
fn inner_line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
fn middle_line_covers(distance: vec4f, width: vec4f) -> vec4f {
    let half = 0.5 * width;
    return clamp(min(distance + 0.5, half) - max(distance - 0.5, -half), vec4f(0.0), vec4f(1.0));
}

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
fn any_line_covers(nearness: vec4f, widths: LineWidths, reach: f32) -> f32 {
    let near = clamp(nearness, vec4f(-reach), vec4f(reach));
    let own = select(vec4f(0.0), vec4f(widths.kinds.xyz,
        select(widths.kinds.w, widths.ids, near.w < 0.0)), abs(near) > vec4f(1e-6));
    let covers = middle_line_covers(reach - abs(near), own);
    return max(max(covers.x, covers.y), max(covers.z, covers.w));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
fn lines_cover(nearness: vec4f, widths: vec4f, reach: f32) -> vec4f {
    let distance = reach - nearness;
    let covers = vec4f(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance, widths).yzw);
    return select(vec4f(0.0), covers, nearness > vec4f(LEAST_NEARNESS));
}

/// Hidden lines
///
/// Lines of what lies behind, seen through what is in front, as a value: where the next surface
/// ends, folds or meets another. Draw them pale, thin, or broken by a noise or a half-tone. The
/// surface in front shows them, one layer deep: what lies behind two surfaces is not seen, nor are
/// the backs of solids.
fn hidden_lines_height(width: f32, silhouettes: f32, creases: f32, borders: f32, nearness: vec4f,
    viewport: vec2f) -> f32 {
    let shares = vec4f(silhouettes, creases, borders, borders);
    let widths = line_widths(width * (0.001 * viewport.y), shares, borders);
    return any_line_covers(nearness, widths, min(16.0 * max(round(viewport.y / 800.0), 1.0), 31.0));
}

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects, of materials and of ids, each as wide as it is told. A silhouette is drawn
/// by what lies in front, as wide as it is; where two surfaces meet, each draws its half of the
/// line. Wire the width to a curvature, a tone or a noise and lines taper.
fn outline_height(width: f32, silhouettes: f32, creases: f32, borders: f32, material_borders: f32,
    id_borders: f32, nearness: vec4f, middle: vec2f, depth: f32, object: f32, viewport: vec2f,
    magnification: f32) -> Outline {
    let pixels = magnification * viewport.y;
    let reach = min(16.0 * max(round(viewport.y / 800.0), 1.0), 31.0);
    let own = own_nearness(nearness, middle, depth, object, pixels, reach);
    let shares = vec4f(silhouettes, creases, borders, material_borders);
    let widths = line_widths_2(width * (0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

struct Outline {
    /// From 0 beside lines to 1 on them.
    line: f32,
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of materials, 5 a border of ids; 0 beside lines.
    kind: f32,
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    distance: f32,
}

fn drawn_outline(line_widths: LineWidths, of_edges: vec4f, reach: f32) -> Outline {
    let signed = clamp(of_edges, vec4f(-reach), vec4f(reach));
    let nearness = abs(signed);
    let widths = vec4f(line_widths.kinds.xyz, 0.0);
    let covers = lines_cover(nearness, widths, reach);
    let line = max(max(covers.x, covers.y), covers.z);
    let least = line - 0.0009765625;
    var kind = select(4.0, 5.0, signed.w < 0.0);
    kind = select(kind, 3.0, covers.z >= least);
    kind = select(kind, 2.0, covers.y >= least);
    kind = select(kind, 1.0, covers.x >= least);
    let near = select(vec4f(0.0), nearness, widths > vec4f(0.0));
    let nearest = max(max(near.x, near.y), near.z);
    return Outline(line, select(0.0, kind, line > 0.0009765625), reach - nearest);
}

/// Separate vector
///
/// The three numbers of a vector.
fn separate_vector(vector: vec3f) -> VectorParts {
    return VectorParts(vector.x, vector.y, 0.0);
}

struct VectorParts {
    /// The first number.
    x: f32,
    /// The second number.
    y: f32,
    /// The third number.
    z: f32,
}

const paper = Ramp(array(vec4f(0.8, 0.845, 0.885, 1.0), vec4f(0.955, 0.965, 0.955, 1.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.75, 0.0, 0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 2u, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    let paper_2 = ramp_at(paper, facing, footprint_of(facing));
    let what_lies_behind = hidden_lines_height(2.4, 1.0, 0.8, 1.0, surface.hidden_nearness,
        look.viewport);
    let place = screen_place(surface.pixel, look.viewport);
    let columns_and_rows = separate_vector(vec3f(place.pixel, 0.0));
    let diagonal = columns_and_rows.x + columns_and_rows.y;
    let dash_length = diagonal * 0.11;
    let along_a_dash = modulo_floored(dash_length, 1.0);
    let ink_or_gap = select(0.0, 1.0, along_a_dash - 0.58 < -0.0);
    let dashed = what_lies_behind * ink_or_gap;
    // Mix colors
    let dashed_on_the_paper = mixed_vec4(bounded_vec4(paper_2), vec4f(0.32, 0.42, 0.55, 1.0),
        dashed);
    let what_is_seen = outline_height(5.0, 1.0, 0.55, 1.0, 0.0, 0.0, surface.line_nearness,
        surface.middle_surface, surface.depth, look.object_id, look.viewport,
        surface.magnification);
    // Mix colors
    let inked = mixed_vec4(bounded_vec4(dashed_on_the_paper), vec4f(0.07, 0.09, 0.15, 1.0),
        what_is_seen.line);
    let output_2 = output(premultiplied(vec4f(inked.xyz, clamp(inked.w, 0.0, 1.0))));
    return output_2;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        -(view.camera_from_world * vec4f(in.position, 1.0)).z,
        textureLoad(line_nearness_map, vec2i(in.clip.xy), 0),
        vec2f(textureLoad(facet_map, vec2i(in.clip.xy), 0).z,
        floor(abs(textureLoad(facet_map, vec2i(in.clip.xy), 0).w))),
        textureLoad(hidden_map, vec2i(in.clip.xy), 0), in.clip.xy * view.screen.xy + view.screen.zw,
        size_on_screen(-(view.camera_from_world * vec4f(in.position, 1.0)).z, view.eye.w,
        length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))));
    return finite_vec4(shade(surface));
}
