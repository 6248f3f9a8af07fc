// Watercolor wash: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// watercolor-wash.json says what to put there and how to draw.

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
    view: vec3f,
    position_object: vec3f,
    pixel: vec2f,
    anchor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

/// Straight RGBA.
alias Color = vec4f;

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
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
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
fn mixed_vec3(a: vec3f, b: vec3f, t: f32) -> vec3f {
    let d = bounded_vec3(b - a);
    return bounded_vec3(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
fn mixed_vec3_2(a: vec3f, b: vec3f, t: f32) -> vec3f {
    let d = b - a;
    return bounded_vec3(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased_2(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
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

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
fn color_mixed(a: vec4f, blended: vec3f, factor: f32) -> vec4f {
    let a_2 = bounded_vec3(a.xyz);
    return vec4f(bounded_vec3(a_2 + factor * bounded_vec3(bounded_vec3(blended) - a_2)), 1.0);
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
        if !(i_2 < 4u) {
            break;
        }
        at = select(at, i_2, places[0u][i_2 % 4u] <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let place = places[0u][at % 4u];
    if (at + 1u >= 4u) | (x <= place) {
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
    if after + 1u < 4u {
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

fn mix_colors_multiply(a: Color, b: Color, factor: f32) -> Color {
    return vec4f(mixed_vec3_2(a.xyz, a.xyz * b.xyz, factor), 1.0);
}

fn mix_colors_multiply_2(a: Color, b: Color, factor: f32) -> Color {
    let blended = a.xyz * b.xyz;
    return vec4f(blended - 0.25 * bounded_vec3(blended - bounded_vec3(a.xyz)), bounded(a.w));
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

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
fn perlin_noise_2(p: vec3f, seed: u32) -> f32 {
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
            octave = mix(0.5, perlin_noise(place, 11u + u32(i)), visible);
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

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
fn fractal_noise_2(kind: u32, p: vec3f, octaves: i32, roughness: f32, seed: i32, w: f32) -> f32 {
    var octave: f32;
    var i = 0;
    var frequency = 1.0;
    var strength = 1.0;
    var total = 0.0;
    var sum = 0.0;
    loop {
        if !(i < 4i) {
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
    return min(sum / total, 1.0);
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
    let grain = perlin_noise_2(vec3f(p, 0.5), own) - 0.5;
    let q = clamp(2.7 * vec2f(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), vec2f(-4194304.0),
        vec2f(4194304.0));
    let felt = perlin_noise_2(vec3f(q, 0.5), own + 1u) - 0.5;
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
    let height = paper_height(spaced(place, stretch, viewport, count), fiber, 0u);
    return PaperGrain(1.0 - clamp(0.5 + 8.0 * tooth * (height - 0.5) * 0.5 * 0.5, 0.0, 1.0),
        height);
}

struct PaperGrain {
    /// The tone as the paper shows it.
    tone: f32,
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    height: f32,
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
fn outer_contour(width: f32, normal: vec3f, view: vec3f, viewport: vec2f) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let pixels = width * clamp(viewport.y, 1.0, 1e5) / 1000.0;
    let distance = facing / max(2.0 * footprint_of(facing), 1e-6);
    let near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * near;
}

fn noise_perlin(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

fn noise_perlin_2(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = position * scale;
    return fractal_noise_2(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

const two_pigments = Ramp(array(vec4f(0.1843, 0.4353, 0.5608, 1.0),
    vec4f(0.2471, 0.6039, 0.5255, 1.0), vec4f(0.7882, 0.6353, 0.2353, 1.0),
    vec4f(0.8471, 0.451, 0.3529, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.45, 0.75, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 4u, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let drift = noise_perlin(surface.position_object, 1.5, 2i, 0.5, 11i);
    let spread = clamp((drift - 0.32) / (0.68 - 0.32), 0.0, 1.0);
    let two_pigments_2 = ramp_at(two_pigments, spread, footprint_of(spread));
    // Reflectance
    let shade_2 = max((dot(surface.normal, look.key.direction) + 0.45) / (1.0 + 0.45), 0.0);
    let tone = min((shade_2 - 0.0) / (0.85 - 0.0), 1.0);
    let water = noise_perlin_2(surface.position_object, 2.2, 4i, 0.55, 0i);
    let how_far_it_runs = mix(-0.24, 0.24, water - 0.0);
    let wet_tone = tone + how_far_it_runs;
    let first_wash = eased_2(wet_tone, 0.82, 0.7);
    let k1 = first_wash * 0.62;
    let wash_on_paper = mix_colors_multiply(vec4f(0.9843, 0.9686, 0.9255, 1.0), two_pigments_2, k1);
    let deeper = mix_colors_multiply_2(two_pigments_2, vec4f(0.3529, 0.3098, 0.5255, 1.0), 0.75);
    let second_wash = eased_2(wet_tone, 0.42, 0.34);
    let k2 = second_wash * 0.6;
    // Mix colors
    let second_on_the_first = vec4f(mixed_vec3(bounded_vec3(wash_on_paper.xyz),
        bounded_vec3(wash_on_paper.xyz * deeper.xyz), k2), 1.0);
    let pigment_s_rim = smoothstep(0.66, 0.72, wet_tone) * first_wash;
    let second_rim = smoothstep(0.29, 0.34, wet_tone) * second_wash;
    let k3 = max(pigment_s_rim, second_rim) * 0.34;
    // Mix colors
    let rims_2 = color_mixed(second_on_the_first, second_on_the_first.xyz * deeper.xyz, k3);
    let sheet = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    let paper = paper_grain(0.5, sheet.place, sheet.stretch, 240.0, 0.6, 0.6, 0i, look.viewport);
    let settled_pigment = mix(0.9, 1.03, bounded(paper.tone) - 0.0);
    let grain = bounded_vec4(rims_2 * vec4f(vec3f(settled_pigment), 1.0));
    let pencil = outer_contour(2.2, surface.normal, surface.view, look.viewport);
    let soft = pencil * 0.7;
    // Mix colors
    let pencil_line = mixed_vec4(bounded_vec4(grain), vec4f(0.2902, 0.2588, 0.2824, 1.0), soft);
    return finite_vec4(pencil_line);
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
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, in.clip.xy * view.screen.xy + view.screen.zw,
        anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, 1.0)).xyz,
        view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))));
    return finite_vec4(shade(surface));
}
