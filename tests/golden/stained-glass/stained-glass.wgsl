// Stained glass: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// stained-glass.json says what to put there and how to draw.

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
    @align(16) room: Light,
    @align(16) sun: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position: vec3f,
    position_object: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

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

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !((largest > 1e-30) & (largest < 1e30)) {
        return otherwise;
    }
    let scaled = v * (1.0 / largest);
    let square = dot(scaled, scaled);
    // max() passes over a NaN.
    if !is_finite(square) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
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

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
fn length_of(v: vec3f) -> f32 {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if largest < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(largest * length(v / largest));
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
fn footprint_of_vec3_2(v: vec3f) -> f32 {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    return select(clamp(0.5 + d / w, 0.0, 1.0), select(0.0, 1.0, d >= 0.0), w < 1e-30);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    var colors = ramp.colors;
    var places = ramp.places;
    var color = colors[0];
    var i = 1u;
    loop {
        if !(i < 7u) {
            break;
        }
        color = color + (colors[i] - colors[i - 1u]) * step_filtered(x, places[i / 4u][i % 4u], w);
        continuing {
            i = i + 1u;
        }
    }
    return color;
}

/// The normal of a surface that is raised by a height (Mikkelsen 2010): `along_x` and `along_y`
/// hold how position (xyz) and height (w) change from pixel to pixel. Where position does not
/// change, or the surface is seen edge-on, the normal stays as it is. Slopes end at 10, which is 84
/// degrees, so that silhouettes do not sparkle.
fn bumped_normal(along_x: vec4f, along_y: vec4f, normal: vec3f) -> vec3f {
    let largest = max(length_of(along_x.xyz), length_of(along_y.xyz));
    if (largest < 1e-18) | (largest > 1e18) {
        return normal;
    }
    let s = along_x.xyz / largest;
    let t = along_y.xyz / largest;
    let rise = clamp(vec2f(along_x.w, along_y.w) / largest, vec2f(-1000000.0), vec2f(1000000.0));
    let right = cross(t, normal);
    let up = cross(normal, s);
    let area = dot(s, right);
    if abs(area) < 1e-6 {
        return normal;
    }
    let slope = (rise.x * right + rise.y * up) / area;
    let steepness = length(slope);
    let limited = slope * (min(steepness, 10.0) / max(steepness, 1e-20));
    return normalize_or(normal - limited, normal);
}

/// Bump map
///
/// Bends the normal as if the surface were raised by a height: from a picture, a noise or anything
/// else. It needs no texture coordinates.
fn bump_map(height: f32, scale: f32, normal: vec3f, position: vec3f) -> vec3f {
    let raised = height * scale;
    let along_x = vec4f(dpdx(position), dpdx(raised));
    let along_y = vec4f(dpdy(position), dpdy(raised));
    return bumped_normal(along_x, along_y, normal);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
fn blend_add(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool) -> Composite {
    return max(vec4f(below.xyz + opacity * (below.xyz + color.xyz - below.xyz), 1.0), vec4f(0.0));
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
fn blend_add_2(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + opacity * (below.xyz + tone * color.xyz - below.xyz), 1.0),
        vec4f(0.0), vec4f(1.0));
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}

fn parametrization_specular_balanced(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
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

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick_2(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    let is_narrow = (w > 0.0) & (w >= 3.46410161513775459 * shape.edge_deviation);
    if is_narrow {
        return profile_ramp_quick(place.x, w, shape);
    }
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

fn profile_balanced_2(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
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

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
fn unit_of_hash(hash: vec3u) -> vec3f {
    return vec3f(hash >> vec3u(8u)) * 5.9604644775390625e-8;
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

struct Cell {
    /// The distance to the nearest border, in cells.
    border: f32,
    /// A random number of the cell, in [0, 1).
    random: f32,
    /// The distance to the cell's point.
    distance: f32,
}

/// Least distance of the point of a cell that is no neighbor, in cells: points keep a quarter of a
/// cell from their cell's sides.
const CELL_REACH: f32 = 1.25;
/// The cell around the nearest of one point per lattice cell, each in the middle half of its own.
///
/// The distance to the border, which lies midway between the two nearest points, ends at (1.25 -
/// distance) / 2: a point that was not looked at is at least 1.25 away, so no border of its is
/// nearer, and a farther border counts as that far.
fn nearest_cell(p: vec3f, seed: u32) -> Cell {
    let corner = floor(p);
    let d = p - corner;
    let cell = vec3i(corner);
    var nearest = vec3f(4.0);
    var hash = vec3u(0u);
    for (var i = 0; i < 27; i++) {
        let at = vec3i(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
        let own = lattice_hash(cell + at, seed);
        let offset = vec3f(at) + 0.25 + 0.5 * unit_of_hash(own) - d;
        if dot(offset, offset) < dot(nearest, nearest) {
            nearest = offset;
            hash = own;
        }
    }
    let distance = length(nearest);
    var border = max(0.5 * (CELL_REACH - distance), 0.0);
    for (var i = 0; i < 27; i++) {
        let at = vec3i(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
        let apart = vec3f(at) + 0.25 + 0.5 * unit_of_hash(lattice_hash(cell + at, seed)) - d
            - nearest;
        let between = length(apart);
        // Points are half a cell apart at least; a nearer one is the cell's own.
        if between > 0.25 {
            border = min(border, dot(nearest + 0.5 * apart, apart) / between);
        }
    }
    // The number has a hash other than that of the point's place, or it would tell where in its
    // cell the point lies.
    return Cell(max(border, 0.0), unit_of_hash(hash_pcg3d(hash)).x, distance);
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

/// Cells
///
/// Space in pieces with straight borders, each with a number of its own: panes of glass, scales,
/// tiles, cracks. A Threshold of the border draws the seams, a Ramp of the number gives every piece
/// its color.
fn cells(position: vec3f, scale: f32, seed: i32) -> Cells {
    let p = clamp(position * scale, vec3f(-4194304.0), vec3f(4194304.0));
    let cell = nearest_cell(p, 4u);
    let visible = 1.0 - smoothstep(0.5, 1.0, footprint_of_vec3_2(p));
    let average = vec3f(0.1301, 0.5, 0.491);
    let seen = mix(average, vec3f(cell.border, cell.random, cell.distance), visible);
    return Cells(seen.x, seen.y, seen.z);
}

struct Cells {
    /// The distance to the nearest border, in cells: 0 at it, rarely above 0.3.
    border: f32,
    /// A number from 0 to 1 that is the same all over a cell.
    random: f32,
    /// The distance to the cell's middle, in cells.
    distance: f32,
}

fn noise_perlin(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

const colors = Ramp(array(vec4f(0.0706, 0.1882, 0.4784, 1.0), vec4f(0.1216, 0.4784, 0.6902, 1.0),
    vec4f(0.1137, 0.5412, 0.3529, 1.0), vec4f(0.9098, 0.6902, 0.1255, 1.0),
    vec4f(0.8471, 0.3255, 0.1098, 1.0), vec4f(0.6902, 0.0706, 0.2196, 1.0),
    vec4f(0.3529, 0.102, 0.4784, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.22, 0.4, 0.58), vec4f(0.75, 0.9, 1.0, 0.0), vec4f(0.0), vec4f(0.0)), 7u, 2u);
const through_the_glass_shape = ProfileShape(0.9950042, 0.099833414, 1.1883951, 1.4967098, 0.2,
    1.0679889, 0.45520553, 0u);
const on_the_glass_shape = ProfileShape(0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1,
    1.0089166, 0.41697913, 0u);
const gleam_tone_shape = ProfileShape(0.99820054, 0.059964005, 11.126125, 3.022525, 0.12,
    0.08196669, 0.036355104, 0u);
const edge_of_the_lead_tone_shape = ProfileShape(0.9887711, 0.14943813, 3.3838634, 2.4220939, 0.3,
    0.29531473, 0.1274162, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let panes = cells(surface.position_object, 3.4, 4i);
    let colors_2 = ramp_at(colors, panes.random, footprint_of(panes.random));
    let glass_in_shade = blend_add(vec4f(0.0275, 0.0235, 0.0471, 1.0), colors_2, 1.0, 0.3, true);
    let wavering_glass = noise_perlin(surface.position_object, 5.0, 2i, 0.5, 0i);
    let glass = bump_map(wavering_glass, 0.03, surface.normal, surface.position);
    // Parametrization
    let sun_turn = Angle(0.5 * length(glass - look.sun.direction), 0.5
        * length(glass + look.sun.direction));
    let through_the_glass = profile_balanced(sun_turn, 0.0, through_the_glass_shape);
    let light_through_it = blend_add_2(glass_in_shade, colors_2, through_the_glass, 0.95, true);
    // Parametrization
    let room_turn = Angle(0.5 * length(glass - look.room.direction), 0.5
        * length(glass + look.room.direction));
    let on_the_glass = profile_balanced(room_turn, 0.0, on_the_glass_shape);
    let light_on_it = blend_add_2(light_through_it, colors_2, on_the_glass, 0.45, true);
    // Threshold
    let seam = step_filtered(panes.border, 0.035, length(vec2f(footprint_of(panes.border), 0.0)));
    let leading = 1.0 - seam;
    // Blend
    let leading_2 = clamp(vec4f(light_on_it.xyz + leading
        * (vec4f(0.0824, 0.0863, 0.102, 1.0).xyz - light_on_it.xyz), 1.0), vec4f(0.0), vec4f(1.0));

    // Gleam (Light layer)
    let gleam_angle = parametrization_specular_balanced(look.room, glass, surface.view);
    let gleam_tone = profile_balanced_2(gleam_angle, 0.0, gleam_tone_shape);
    let gleam_lit = light_apply(look.room, vec4f(1.0, 0.9647, 0.8941, 1.0), gleam_tone);
    let gleam_blend = blend_alpha(leading_2, gleam_lit.color, gleam_lit.tone, 0.7, true);

    // Edge of the lead (Light layer)
    let edge_of_the_lead_angle = parametrization_specular_balanced(look.room, surface.normal,
        surface.view);
    let edge_of_the_lead_tone = profile_balanced_2(edge_of_the_lead_angle, 0.0,
        edge_of_the_lead_tone_shape);
    let edge_of_the_lead_lit = light_apply(look.room, vec4f(0.1725, 0.1843, 0.2196, 1.0),
        edge_of_the_lead_tone);
    let edge_of_the_lead_blend = blend_add_2(gleam_blend, edge_of_the_lead_lit.color,
        edge_of_the_lead_lit.tone, 0.35, true);

    return edge_of_the_lead_blend;
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
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position), in.position,
        in.position_object);
    return shade(surface);
}
