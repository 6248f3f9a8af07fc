// Ink outlines: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_tensor_map 3, line_nearness_map 4, facet_map 5.
// ink-outlines.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
}

/// What is known before the fragment.
struct Look {
    camera_from_world: mat3x3f,
    viewport: vec2f,
    @align(16) key: Light,
    @align(16) object_id: f32,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    position_camera: vec3f,
    depth: f32,
    curvature_tensor: vec3f,
    line_nearness: vec4f,
    middle_surface: vec2f,
    magnification: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_tensor_map: texture_2d<f32>;
@group(0) @binding(4) var line_nearness_map: texture_2d<f32>;
@group(0) @binding(5) var facet_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    direction: vec3f,
    /// Unit, toward the light, in the light's own frame.
    own_direction: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    intensity: f32,
}

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

/// [`mixed`], component by component.
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let d = bounded_vec4(b - a);
    return bounded_vec4(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of_2(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
fn footprint_of_vec3(v: vec3f) -> f32 {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = bounded(x - edge);
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered_2(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    return select(clamp(0.5 + d / w, 0.0, 1.0), select(0.0, 1.0, d >= 0.0), w < 1e-30);
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

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at_2(ramp: Ramp, x: f32, w: f32) -> Color {
    var colors = ramp.colors;
    var places = ramp.places;
    var color = colors[0];
    var i = 1u;
    loop {
        if !(i < 4u) {
            break;
        }
        color = color + (colors[i] - colors[i - 1u]) * step_filtered_2(x, places[0u][i % 4u], w);
        continuing {
            i = i + 1u;
        }
    }
    return color;
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

const NOISE_PERLIN: u32 = 1u;
/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
fn hash_pcg3d(seed: vec3u) -> vec3u {
    var v = seed * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// The hash of a lattice point.
fn lattice_hash(cell: vec3i, seed: u32) -> vec3u {
    return hash_pcg3d(bitcast<vec3u>(cell) + seed * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
fn gradient_dot(hash: vec3u, d: vec3f) -> f32 {
    let axis = (hash.x >> 8u) % 3u;
    let a = select(d.x, d.y, axis == 0u);
    let b = select(d.z, d.y, axis == 2u);
    return select(-a, a, (hash.y >> 31u) == 0u) + select(-b, b, (hash.z >> 31u) == 0u);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
fn fade_quintic(t: vec3f) -> vec3f {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
fn perlin_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let f = fade_quintic(d);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z * gradient_dot(lattice_hash(cell + at, seed), d
            - vec3f(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
fn fractal_noise(kind: u32, p: vec3f, octaves: i32, roughness: f32, seed: i32, w: f32) -> f32 {
    var octave: f32;
    var i = 0;
    var frequency = 1.0;
    var strength = 1.0;
    var total = 0.0;
    var sum = 0.0;
    loop {
        if !(i < 2i) {
            break;
        }
        let visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if visible > 0.0 {
            let place = clamp(p * frequency + f32(i) * vec3f(17.31, 5.17, 11.73), vec3f(-4194304.0),
                vec3f(4194304.0));
            octave = mix(0.5, perlin_noise(place, 0u + u32(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
        continuing {
            i = i + 1;
        }
    }
    return min(sum / 1.5, 1.0);
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

fn reflectance_half_lambert(light: Light, normal: vec3f) -> f32 {
    let half = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half * half, 1.0);
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

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
fn lines_cover(nearness: vec4f, widths: vec4f, reach: f32) -> vec4f {
    let distance = reach - nearness;
    let covers = vec4f(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance, widths).yzw);
    return select(vec4f(0.0), covers, nearness > vec4f(LEAST_NEARNESS));
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
fn inner_contour_suggestive(width: f32, limit: f32, softness: f32, tensor: vec3f, normal: vec3f,
    view: vec3f, camera_from_world: mat3x3f, place: vec3f, viewport: vec2f) -> f32 {
    let n = camera_from_world * normal;
    let square = dot(n.xy, n.xy);
    let radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    let change = vec2f(dpdx(radial), dpdy(radial));
    let v = camera_from_world * view;
    let row = dpdy(place);
    let up = select(-1.0, 1.0, (row - dot(row, v) * v).y >= 0.0);
    let height = clamp(viewport.y, 1.0, 1e5);
    let toward_eye = -(change.x * n.x + up * change.y * n.y) * inverseSqrt(max(square, 1e-6));
    let pixels = 0.5 * width * height / 1000.0;
    let distance = abs(radial) / max(length(change), 1e-6);
    let x = toward_eye * height * 0.05;
    let strength = clamp(0.5 + (x - limit) / length(vec2f(min(footprint_of(x), 1e15), 24.0)), 0.0,
        1.0);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
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
    let widths = line_widths(width * (0.001 * viewport.y), shares, id_borders);
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
    let widths = vec4f(line_widths.kinds.xyz, select(line_widths.kinds.w, 0.0, signed.w < 0.0));
    let covers = lines_cover(nearness, widths, reach);
    let line = max(max(covers.x, covers.y), max(covers.z, covers.w));
    let least = line - 0.0009765625;
    var kind = select(4.0, 5.0, signed.w < 0.0);
    kind = select(kind, 3.0, covers.z >= least);
    kind = select(kind, 2.0, covers.y >= least);
    kind = select(kind, 1.0, covers.x >= least);
    let near = select(vec4f(0.0), nearness, widths > vec4f(0.0));
    let nearest = max(max(near.x, near.y), max(near.z, near.w));
    return Outline(line, select(0.0, kind, line > 0.0009765625), reach - nearest);
}

fn noise_perlin(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

const three_washes = Ramp(array(vec4f(0.4353, 0.5255, 0.6588, 1.0),
    vec4f(0.7882, 0.6471, 0.549, 1.0), vec4f(0.949, 0.851, 0.6941, 1.0),
    vec4f(1.0, 0.9647, 0.8784, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.36, 0.54, 0.93), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 4u, 2u);
const ink = Ramp(array(vec4f(0.0784, 0.102, 0.2, 1.0), vec4f(0.3529, 0.1647, 0.1098, 1.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.1, 0.85, 0.0, 0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 2u, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let light_and_dark = reflectance_half_lambert(look.key, surface.normal);
    let three_washes_2 = ramp_at_2(three_washes, light_and_dark, footprint_of_2(light_and_dark));
    let ink_2 = ramp_at(ink, light_and_dark, footprint_of_2(light_and_dark));
    let heavy_in_the_shade = mix(1.6, 8.0,
        clamp((light_and_dark - 0.75) / (0.15 - 0.75), 0.0, 1.0));
    let hand = noise_perlin(surface.position_object, 3.5, 2i, 0.5, 0i);
    let pressure = mix(0.7, 1.3, hand - 0.0);
    let width = heavy_in_the_shade * pressure;
    let pen = outline_height(width, 1.0, 0.6, 1.0, 0.6, 0.0, surface.line_nearness,
        surface.middle_surface, surface.depth, look.object_id, look.viewport,
        surface.magnification);
    let folds = inner_contour_suggestive(2.2, 24.0, 1.0, surface.curvature_tensor, surface.normal,
        surface.view, look.camera_from_world, surface.position_camera, look.viewport);
    let all_strokes = max(pen.line, folds);
    // Mix colors
    let ink_on_the_washes = mixed_vec4(three_washes_2, bounded_vec4(ink_2), all_strokes);
    let output_alpha = vec4f(ink_on_the_washes.xyz, clamp(ink_on_the_washes.w, 0.0, 1.0));
    let output_2 = output(premultiplied(output_alpha));
    return output_2;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) position_object: vec3f,
    @location(2) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, vertex.position,
        object.world_from_normal * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, (view.camera_from_world * vec4f(in.position, 1.0)).xyz,
        -(view.camera_from_world * vec4f(in.position, 1.0)).z,
        textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz,
        textureLoad(line_nearness_map, vec2i(in.clip.xy), 0),
        vec2f(textureLoad(facet_map, vec2i(in.clip.xy), 0).z,
        floor(abs(textureLoad(facet_map, vec2i(in.clip.xy), 0).w))),
        size_on_screen(-(view.camera_from_world * vec4f(in.position, 1.0)).z, view.eye.w,
        length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))));
    return finite_vec4(shade(surface));
}
