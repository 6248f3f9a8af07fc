// Paper wash: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// paper-wash.json says what to put there and how to draw.

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
    viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    pixel: vec2f,
    anchor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

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

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
fn log2_stable(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    let exponent = bitcast<i32>(bits - 0x3f3504f3u) >> 23u;
    let mantissa = bitcast<f32>(bits - (bitcast<u32>(exponent) << 23u));
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let z2 = z * z;
    return f32(exponent) + z * (2.8853900797881615 + z2 * (0.9617988482912865
        + z2 * (0.5767143098091317 + z2 * 0.43173790132006157)));
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
fn normalize_seen(v: vec3f) -> vec3f {
    return normalize_moderate(v, vec3f(0.0, 0.0, 1.0));
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

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
fn stairs_filtered(x: f32, count: f32, w: f32) -> f32 {
    if w <= 1.0 {
        let edge = clamp(round(x), 1.0, 3.0);
        return edge - 1.0 + clamp(0.5 + (x - edge) / w, 0.0, 1.0);
    }
    let half = 0.5 * w;
    return (stairs_integral(x + half, count) - stairs_integral_2(x - half, count)) / (2.0 * half);
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral(x: f32, count: f32) -> f32 {
    let inside = min(x, count);
    let stair = min(floor(inside), 3.0);
    let beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 3.0;
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral_2(x: f32, count: f32) -> f32 {
    let inside = max(x, 0.0);
    let stair = floor(inside);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + 0.0;
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
fn hermite(a: vec4f, b: vec4f, from_a: vec4f, to_b: vec4f, t: f32) -> vec4f {
    let d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    var colors = ramp.colors;
    var places = ramp.places;
    var i_2 = 1u;
    var at = 0u;
    loop {
        if !(i_2 < 5u) {
            break;
        }
        at = select(at, i_2, places[i_2 / 4u][i_2 % 4u] <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let place = places[at / 4u][at % 4u];
    if (at + 1u >= 5u) | (x <= place) {
        return colors[at];
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    var from_a = vec4f(0.0);
    if at > 0u {
        let before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    var to_b = vec4f(0.0);
    if after + 1u < 5u {
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

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

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
fn gradient_dot(hash: vec3u, d: vec3f) -> f32 {
    let axis = (hash.x >> 8u) % 3u;
    let a = select(d.x, d.y, axis == 0u);
    let b = select(d.z, d.y, axis == 2u);
    return select(-a, a, (hash.y >> 31u) == 0u) + select(-b, b, (hash.z >> 31u) == 0u);
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
fn perlin_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let f = d * d * d * (d * (d * 6.0 - 15.0) + 10.0);
    let cell = vec3i(corner);
    var i = 0;
    var sum = 0.0;
    loop {
        if !(i < 8) {
            break;
        }
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum = sum + weight.x * weight.y * 0.5
            * gradient_dot(hash_pcg3d(bitcast<vec3u>(cell + at) + seed
            * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)), d - vec3f(at));
        continuing {
            i = i + 1;
        }
    }
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
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

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
fn anchor_on_screen(origin: vec3f, perspective: f32, scale: f32) -> vec3f {
    let size = size_on_screen(-origin.z, perspective, scale);
    return clamp(vec3f(origin.x * size, -origin.y * size, size), vec3f(-MOST_ON_SCREEN),
        vec3f(MOST_ON_SCREEN));
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
fn place_in_picture(pixel: vec2f, viewport: vec2f) -> vec2f {
    let from_middle = pixel - 0.5 * viewport;
    return vec2f(from_middle.x, -from_middle.y) / max(viewport.y, 1.0);
}

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    place: vec2f,
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    stretch: vec3f,
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
fn mark_place_of(place: vec2f, along: vec3f, across: vec3f, angle: f32) -> StretchedPlace {
    let turn = clamp(vec2f(0.0, 1.0), vec2f(-1.0), vec2f(1.0));
    let x = turn.y * along + turn.x * across;
    let y = turn.y * across - turn.x * along;
    let turned = vec2f(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x * place.x);
    let stretch = vec3f(dot(x, x), dot(x, y), dot(y, y));
    return StretchedPlace(turned, stretch);
}

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    place: vec2f,
    stretch: vec3f,
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
fn spaced(place: vec2f, stretch: vec3f, viewport: vec2f, count: f32) -> SpacedPlace {
    let is_pixel = !(stretch.x + stretch.z > 0.0);
    let scale = select(count, count / max(viewport.y, 1.0), is_pixel);
    let p = clamp(place * scale, vec2f(-4194304.0), vec2f(4194304.0));
    return SpacedPlace(p, select(stretch, vec3f(1.0, 0.0, 1.0), is_pixel));
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
fn area_square(stretch: vec3f) -> f32 {
    let sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

fn mark_place_object(angle: f32, anchor: vec3f, pixel: vec2f, viewport: vec2f) -> MarkPlace {
    let size = clamp(anchor.z, 1e-6, 1e6);
    let place = (place_in_picture(pixel, viewport) - vec2f(anchor.x, -anchor.y)) / size;
    let m = mark_place_of(place, vec3f(1.0 / size, 0.0, 0.0), vec3f(0.0, 1.0 / size, 0.0), angle);
    return MarkPlace(m.place, m.stretch);
}

struct MarkPlace {
    /// Along the strokes, and across them.
    place: vec2f,
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    stretch: vec3f,
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
fn paper_height(at: SpacedPlace, fiber: f32, seed: u32) -> f32 {
    let x = dpdx(at.place);
    let y = dpdy(at.place);
    let w = sqrt(max(dot(x, x), dot(y, y)));
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    var height = paper_octave(at.place, i32(zoom), w, fiber, seed);
    if f > 0.0 {
        let both = mix(height, paper_octave(at.place, i32(zoom) + 1, w, fiber, seed), f);
        height = clamp(0.5 + (both - 0.5) / sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0, 1.0);
    }
    return height;
}

/// The height of paper in one octave; paper finer than a pixel is flat.
fn paper_octave(place: vec2f, zoom: i32, w: f32, fiber: f32, seed: u32) -> f32 {
    let scale = bitcast<f32>(u32(zoom + 127) << 23u);
    let p = clamp(place * scale, vec2f(-4194304.0), vec2f(4194304.0));
    let own = seed + 7u * bitcast<u32>(zoom);
    let grain = perlin_noise(vec3f(p, 0.5), own) - 0.5;
    let q = clamp(2.7 * vec2f(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), vec2f(-4194304.0),
        vec2f(4194304.0));
    let felt = perlin_noise(vec3f(q, 0.5), own + 1u) - 0.5;
    let coarse_seen = 1.0 - smoothstep(0.5, 1.0, w * scale);
    let felt_seen = 1.0 - smoothstep(0.5, 1.0, 2.7 * w * scale);
    return clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
fn paper_grain(value: f32, place: vec2f, stretch: vec3f, count: f32, tooth: f32, fiber: f32,
    seed: i32, viewport: vec2f) -> PaperGrain {
    let height = paper_height(spaced(place, stretch, viewport, count), fiber, 5u);
    return PaperGrain(1.0 - clamp(0.5 + 0.0 * (height - 0.5) * 0.5 * 0.5, 0.0, 1.0), height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
fn paper_grain_2(value: f32, place: vec2f, stretch: vec3f, count: f32, tooth: f32, fiber: f32,
    seed: i32, viewport: vec2f) -> PaperGrain {
    let height = paper_height(spaced(place, stretch, viewport, count), fiber, 0u);
    let ink = 1.0 - clamp(value, 0.0, 1.0);
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}

struct PaperGrain {
    /// The tone as the paper shows it.
    tone: f32,
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    height: f32,
}

const indigo_to_warm_paper = Ramp(array(vec4f(0.13, 0.14, 0.33, 1.0), vec4f(0.24, 0.36, 0.56, 1.0),
    vec4f(0.53, 0.66, 0.72, 1.0), vec4f(0.9, 0.8, 0.68, 1.0), vec4f(0.975, 0.95, 0.9, 1.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.35, 0.62, 0.82), vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0), vec4f(0.0)), 5u, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Reflectance
    let light_and_shade = max((dot(surface.normal, look.key.direction) + 0.5) / 1.5, 0.0);
    let paper_that_goes_along = mark_place_object(0.0, surface.anchor, surface.pixel,
        look.viewport);
    let where_water_stood = paper_grain(0.5, paper_that_goes_along.place,
        paper_that_goes_along.stretch, 11.0, 0.0, 0.7, 5i, look.viewport);
    let uneven_edge = mix(-0.2, 0.2, bounded(where_water_stood.height) - 0.0);
    let wet = light_and_shade + uneven_edge;
    // Bands
    let washes = clamp(stairs_filtered(4.0 * clamp(wet, 0.0, 1.0), 4.0,
        length(vec2f(4.0 * footprint_of_2(wet), 0.22))) / 3.0, 0.0, 1.0);
    let pigment_in_them = mix(washes, wet, 0.35);
    let tooth_of_the_paper = paper_grain_2(pigment_in_them, paper_that_goes_along.place,
        paper_that_goes_along.stretch, 260.0, 0.2, 0.6, 0i, look.viewport);
    let indigo_to_warm_paper_2 = ramp_at(indigo_to_warm_paper, bounded(tooth_of_the_paper.tone),
        footprint_of(tooth_of_the_paper.tone));
    let output_alpha = vec4f(indigo_to_warm_paper_2.xyz, clamp(indigo_to_warm_paper_2.w, 0.0, 1.0));
    return output(premultiplied(output_alpha));
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, object.world_from_normal * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, in.clip.xy * view.screen.xy + view.screen.zw,
        anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, 1.0)).xyz,
        view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))));
    return finite_vec4(shade(surface));
}
