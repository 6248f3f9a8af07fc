// Chalk: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// chalk-board.json says what to put there and how to draw.

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
    @align(16) back: Light,
    @align(16) viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    kappa: f32,
    pixel: vec2f,
    anchor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    half_sin: f32,
    /// cos(u/2), 0 or more.
    half_cos: f32,
}

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

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - 0.0;
    let upper = select(vec2f(s, u.half_cos), vec2f(1.0, 0.0), u.half_cos <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < u.half_cos));
    return Angle(turned.x, turned.y);
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    half_cos_offset: f32,
    half_sin_offset: f32,
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    scale: f32,
    /// gamma of BADF eq. 11.
    exponent: f32,
    /// tau, the step's place, in radians.
    offset: f32,
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    edge_mean: f32,
    edge_deviation: f32,
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    kind: u32,
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick(s: f32, shape: ProfileShape) -> f32 {
    let q = s * shape.scale;
    return select(pow(max(1.0 - q * q, 0.0), shape.exponent), 1.0, s <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    let point = profile_soft_quick(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
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
    let ink = 1.0 - value;
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
fn paper_grain_2(value: f32, place: vec2f, stretch: vec3f, count: f32, tooth: f32, fiber: f32,
    seed: i32, viewport: vec2f) -> PaperGrain {
    let height = paper_height(spaced(place, stretch, viewport, count), fiber, 9u);
    let ink = 1.0 - value;
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
fn paper_grain_3(value: f32, place: vec2f, stretch: vec3f, count: f32, tooth: f32, fiber: f32,
    seed: i32, viewport: vec2f) -> PaperGrain {
    let height = paper_height(spaced(place, stretch, viewport, count), fiber, 3u);
    let ink = 1.0 - max(value, 0.0);
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}

struct PaperGrain {
    /// The tone as the paper shows it.
    tone: f32,
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    height: f32,
}

const orange_chalk_shape = ProfileShape(0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706,
    0.1847509, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Reflectance
    let shade_2 = max((dot(surface.normal, look.key.direction) + 0.15) / (1.0 + 0.15), 0.0);
    let tone = min((shade_2 - 0.0) / (0.9 - 0.0), 1.0);
    let rubbed = mix(0.05, 0.5, min((tone - 0.0) / (0.6 - 0.0), 1.0));
    let r_bare = 1.0 - rubbed;
    let board = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    let r_grain = paper_grain(r_bare, board.place, board.stretch, 120.0, 0.6, 0.5, 5i,
        look.viewport);
    let r_on = bounded(1.0 - r_grain.tone);
    let blue_gray = mix(vec4f(0.1216, 0.1647, 0.1686, 1.0), vec4f(0.4275, 0.5098, 0.5647, 1.0),
        r_on);
    // Parametrization
    let turn = Angle(0.5 * length(surface.normal - look.back.direction), 0.5
        * length(surface.normal + look.back.direction));
    let orange_chalk = profile_balanced(turn, 0.0, orange_chalk_shape);
    let o_bare = 1.0 - orange_chalk;
    let o_grain = paper_grain_2(o_bare, board.place, board.stretch, 220.0, 0.8, 0.5, 9i,
        look.viewport);
    let orange = mix(blue_gray, vec4f(0.9412, 0.6353, 0.3608, 1.0), bounded(1.0 - o_grain.tone));
    let curvature = surface.kappa;
    // Curvature transition
    let hollow_to_bulge = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.8853900817779268 * clamp(curvature * 0.16, -20.0, 20.0))));
    let bare_in_hollows = mix(0.1, 1.0, clamp((hollow_to_bulge - 0.15) / (0.5 - 0.15), 0.0, 1.0));
    let white_chalk = tone * bare_in_hollows;
    let w_bare = 1.0 - white_chalk;
    let w_grain = paper_grain_3(w_bare, board.place, board.stretch, 260.0, 0.62, 0.5, 3i,
        look.viewport);
    let white = mix(orange, vec4f(0.9686, 0.9529, 0.9098, 1.0), bounded(1.0 - w_grain.tone));
    return white;
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
    let surface = Surface(normal, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x, in.clip.xy
        * view.screen.xy + view.screen.zw,
        anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, 1.0)).xyz,
        view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))));
    return shade(surface);
}
