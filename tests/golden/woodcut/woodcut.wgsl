// Woodcut: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// woodcut.json says what to put there and how to draw.

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
    @align(16) key: Light,
    @align(16) viewport: vec2f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    kappa: f32,
    magnification: f32,
    world_from_normal: mat3x3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

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

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let whole = round(x);
    let f = x - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
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

/// [`bounded`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    return select(clamp(0.5 + d / w, 0.0, 1.0), select(0.0, 1.0, d >= 0.0), w < 1e-30);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
fn axes_around(toward: vec3f, up: vec3f) -> mat3x3f {
    let z = normalize_moderate(toward, vec3f(0.0, 0.0, 1.0));
    let leaning = cross(up, z);
    let square = dot(leaning, leaning);
    let aside = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), abs(z.x) > 0.7);
    let across = select(cross(aside, z), leaning, square > 1e-8);
    let x = normalize_moderate(across - dot(across, z) * z, vec3f(1.0, 0.0, 0.0));
    return mat3x3f(x, cross(z, x), z);
}

/// Threshold
///
/// 0 below an edge, 1 from the edge on, antialiased by its own width on the screen: cuts a hard
/// shape out of anything smooth. Where the value does not change on the screen the edge is hard,
/// and the edge itself is 1.
fn threshold(value: f32, edge: f32, softness: f32) -> f32 {
    return step_filtered(value, edge, length(vec2f(footprint_of(value), softness)));
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

/// Value noise: random numbers at lattice points, smooth between them.
fn value_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let t = p - corner;
    let f = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
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
            * (vec3f(hash_pcg3d(bitcast<vec3u>(cell + at) + seed
            * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u))
            * 5.9604644775390625e-8).x;
        continuing {
            i = i + 1;
        }
    }
    return sum;
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
    let turn = vec2f(sin(angle), cos(angle));
    let x = bounded_vec3(turn.y * along + turn.x * across);
    let y = bounded_vec3(turn.y * across - turn.x * along);
    let turned = vec2f(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x * place.x);
    let most = vec3f(1e15);
    let stretch = clamp(vec3f(dot(x, x), dot(x, y), dot(y, y)), -most, most);
    return StretchedPlace(turned, stretch);
}

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
fn gradient_on_picture(g: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let facing = dot(normal, view);
    return g - normal * (dot(g, view) / select(min(facing, -0.125), max(facing, 0.125),
        facing >= 0.0));
}

/// A place on a surface for strokes across an axis of the object.
fn place_across(axis: vec3f, position: vec3f, world_from_normal: mat3x3f, normal: vec3f,
    view: vec3f, magnification: f32, angle: f32) -> StretchedPlace {
    let axes = axes_around(axis, vec3f(0.0, 1.0, 0.0));
    let place = vec2f(dot(position, axes[0]), dot(position, axes[2]));
    let along = world_from_normal * axes[0];
    let across = world_from_normal * axes[2];
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
fn place_on_surface(place: vec2f, along: vec3f, across: vec3f, normal: vec3f, view: vec3f,
    magnification: f32, angle: f32) -> StretchedPlace {
    let height = 1.0 / clamp(magnification, 1e-15, 1e15);
    let x = bounded_vec3(gradient_on_picture(along, normal, view) * height);
    let y = bounded_vec3(gradient_on_picture(across, normal, view) * height);
    return mark_place_of(place, x, y, angle);
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
    let s = clamp(bounded_vec3(stretch), vec3f(-1000000000000000.0), vec3f(1e15));
    return SpacedPlace(p, select(s, vec3f(1.0, 0.0, 1.0), is_pixel));
}

/// Style of strokes.
struct Strokes {
    /// Width of a stroke, in spacings.
    width: f32,
    /// Length of a stroke, in spacings; 0 for endless strokes.
    length: f32,
    /// Share of a stroke that its ends take, 0 to 1.
    taper: f32,
    /// Distance that strokes stray, in spacings.
    wobble: f32,
    /// Effect of a darker tone: from more strokes at 0 to wider ones at 1.
    pressure: f32,
    /// Growth of the strokes between others: from all together at 0 to one after the other at 1.
    variation: f32,
    seed: u32,
}

/// A stroke as seen at a place.
struct Stroke {
    /// Turn of the stroke among its neighbors, 0 to 1.
    turn: f32,
    /// Width of the stroke at the place, as a share of its full width.
    profile: f32,
}

/// The stroke of a line at x, in one octave. A line's name is an odd number and the octave that it
/// first lies in.
fn stroke_at(line: vec2i, x: f32, zoom: i32, style: Strokes) -> Stroke {
    let own = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(line, 1048576)) + 7u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    return Stroke(own.y, 1.0);
}

/// A stroke where an octave fades into the next.
fn stroke_between(line: vec2i, x: f32, level: f32, style: Strokes) -> Stroke {
    let zoom = floor(level);
    let a = stroke_at(line, x, i32(zoom), style);
    let b = stroke_at(line, x, i32(zoom) + 1, style);
    let f = level - zoom;
    return Stroke(mix(a.turn, b.turn, f), mix(1.0, 1.0, f));
}

/// Distance that strokes stray at a place of an octave, in spacings of the place.
fn stray_at(place: vec2f, zoom: i32, seed: u32) -> f32 {
    let p = place * bitcast<f32>(u32(zoom + 127) << 23u);
    return (value_noise(vec3f(0.11 * p.x, 0.45 * p.y, 0.5), seed) - 0.5) * 2.0
        * bitcast<f32>(u32(-zoom + 127) << 23u);
}

/// Share of a footprint of `w` that a band covers whose middle is t away and which reaches `half`
/// to both sides.
fn band_filtered(t: f32, half: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, (abs(t) <= half) & (half > 0.0));
    }
    return clamp((clamp(t + 0.5 * w, -half, half) - clamp(t - 0.5 * w, -half, half)) / w, 0.0, 1.0);
}

/// The ink of one direction of strokes. `place` is along and across, in spacings at `level` 0; `w`
/// is the footprint of the coordinate across. The average ink is `ink` times the width, but for
/// tapers.
fn hatched(place: vec2f, w: f32, level: f32, ink: f32, style: Strokes) -> f32 {
    if !(ink > 0.0) {
        return 0.0;
    }
    let number = pow(ink, 1.0 - style.pressure);
    let width = style.width * pow(ink, style.pressure);
    let zoom = floor(level);
    let stray = mix(stray_at(place, i32(zoom), 7u), stray_at(place, i32(zoom) + 1, 7u), level
        - zoom);
    let across = place.y + style.wobble * stray;
    let density = max(level + log2_stable(max(number, 1e-9)), -40.0);
    let octave = floor(density);
    let growth = exp2_stable(density - octave) - 1.0;
    let scale = bitcast<f32>(u32(i32(octave) + 127) << 23u);
    let q = clamp(across * scale, -4194304.0, 4194304.0);
    let half = 0.5 * width * exp2_stable(octave - level);
    let footprint = w * scale;
    let whole = i32(round(q));
    let old = stroke_between(line_of(whole, i32(octave)), place.x, level, style);
    let middle = floor(q);
    let young = stroke_between(vec2i(2 * i32(middle) + 1, i32(octave) + 1), place.x, level, style);
    let grown = clamp((growth - 0.75 * young.turn) / 0.25, 0.0, 1.0);
    let a = band_filtered(q - f32(whole), half * old.profile, footprint);
    let b = band_filtered(q - middle - 0.5, half * grown * young.profile, footprint);
    let mean = min(2.0 * half * (1.0 + growth), 1.0);
    return mix(max(a, b), mean, smoothstep(0.75, 1.5, footprint));
}

/// The name of a whole place's line in an octave: an odd number and the octave that the line first
/// lies in. The line at 0 lies in all.
fn line_of(whole: i32, octave: i32) -> vec2i {
    let power = select(whole & -whole, 1, whole == 0);
    // log2 of a power of two, by its bits.
    let octaves = i32(bitcast<u32>(f32(power)) >> 23u) - 127;
    return select(vec2i(whole / power, octave - octaves), vec2i(0), whole == 0);
}

/// The ink of strokes in up to four directions, each turned by `cross` radians from the one before:
/// the first take the light tones, and the others come in one after the other.
fn cross_hatched(at: SpacedPlace, ink: f32, layers: i32, cross: f32, style: Strokes) -> f32 {
    let x = dpdx(at.place);
    let y = dpdy(at.place);
    var own: Strokes;
    var i = 0;
    var free = 1.0;
    loop {
        if !(i < 4) {
            break;
        }
        if i < 1i {
            let turn = vec2f(sin(0.0), cos(0.0));
            let along = vec2f(turn.y, turn.x);
            let across = vec2f(-turn.x, turn.y);
            let w = length(vec2f(dot(across, x), dot(across, y)));
            let square = dot(vec3f(across.x * across.x, 2.0 * across.x * across.y, across.y
                * across.y), at.stretch);
            let level = clamp(-0.5 * log2_stable(max(max(square, (at.stretch.x + at.stretch.z)
                / 65.0), 1e-30)), -16.0, 16.0);
            let place = vec2f(dot(along, at.place), dot(across, at.place));
            own = style;
            own.seed = 7u;
            free = 1.0 - hatched(place, w, level, ink - 0.0, own);
        }
        continuing {
            i = i + 1;
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
fn mark_place_light(light: Light, normal: vec3f, angle: f32, view: vec3f, position_object: vec3f,
    world_from_normal: mat3x3f, magnification: f32) -> MarkPlace {
    let toward = light.direction * world_from_normal;
    let m = place_across(toward, position_object, world_from_normal, normal, view, magnification,
        angle);
    return MarkPlace(m.place, m.stretch);
}

struct MarkPlace {
    /// Along the strokes, and across them.
    place: vec2f,
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    stretch: vec3f,
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Reflectance
    let shade_2 = max((dot(surface.normal, look.key.direction) + 0.3) / (1.0 + 0.3), 0.0);
    let tone = mix(0.02, 1.0, min((shade_2 - 0.0) / (0.8 - 0.0), 1.0));
    let lit = threshold(tone, 0.72, 0.0);
    let ochre_block = mix(vec4f(0.8392, 0.6039, 0.2902, 1.0), vec4f(0.9529, 0.902, 0.7843, 1.0),
        lit);
    let way_of_the_gouge = mark_place_light(look.key, surface.normal, 0.0, surface.view,
        surface.position_object, surface.world_from_normal, surface.magnification);
    // Hatching
    let cuts = cross_hatched(spaced(way_of_the_gouge.place, way_of_the_gouge.stretch, look.viewport,
        78.0), 1.0 - min(tone, 1.0), 1i, 1.0471976, Strokes(0.62, 0.0, 0.8, 0.35, 0.85, 1.0, 7u));
    let deep_shade = threshold(tone, 0.2, 0.0);
    let curvature = surface.kappa;
    // Curvature transition
    let hollow_to_bulge = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.8853900817779268 * clamp(curvature * 0.22, -20.0, 20.0))));
    let hollows = threshold(hollow_to_bulge, 0.2, 0.0);
    let outline = threshold(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.0);
    // Combine tones
    let black_block = max(max(cuts, 1.0 - deep_shade), max(1.0 - hollows, 1.0 - outline));
    let print = mix(ochre_block, vec4f(0.1137, 0.0824, 0.0706, 1.0), black_block);
    return print;
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
        in.position_object, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x,
        size_on_screen(-(view.camera_from_world * vec4f(in.position, 1.0)).z, view.eye.w,
        length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))), object.world_from_normal);
    return shade(surface);
}
