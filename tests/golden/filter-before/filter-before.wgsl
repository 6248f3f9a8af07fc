// A filter before the profile: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// filter-before.json says what to put there and how to draw.

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
    lamp_position: vec3f,
    lamp_aim: vec3f,
    lamp_own_from_world: mat3x3f,
    lamp_color: vec3f,
    lamp_intensity: f32,
    lamp_cone: vec2f,
    lamp_fading: vec2f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    position: vec3f,
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

const PI: f32 = 3.14159265358979323846;
const HALF_PI: f32 = 1.57079632679489661923;
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

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
fn sin_cos_eighth(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.166666666666666667 + y * (0.00833333333333333333
        + y * (-0.000198412698412698413 + y * 0.00000275573192239858907))));
    let c = 1.0 - y * (0.5 + y * (-0.0416666666666666667 + y * (0.00138888888888888889
        + y * (-0.0000248015873015873016 + y * 2.75573192239858907e-7))));
    return vec2f(s, c);
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

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
fn atan2_positive(y: f32, x: f32) -> f32 {
    let small = min(y, x);
    let large = max(y, x);
    if large <= 0.0 {
        return 0.0;
    }
    let t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    let is_wide = t > 0.41421356;
    let r = select(t, (small - large) / (small + large), is_wide);
    let r2 = r * r;
    let series = r * (1.0 + r2 * (-0.333333333333333333
        + r2 * (0.2 + r2 * (-0.142857142857142857
        + r2 * (0.111111111111111111 + r2 * (-0.0909090909090909091
        + r2 * (0.0769230769230769231 + r2 * (-0.0666666666666666667
            + r2 * 0.0588235294117647059))))))));
    let a = select(series, series + 0.785398163397448310, is_wide);
    return select(a, HALF_PI - a, y > x);
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
    let s = u.half_sin - u.half_cos * 0.0;
    let c = u.half_cos + 0.0;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < c));
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

/// [`bounded`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
fn place_between(x: f32, low: f32, high: f32) -> f32 {
    let span = high - low;
    if span < SMALLEST_NORMAL {
        return select(0.0, 1.0, x >= high);
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(place_between(bounded(x), low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
fn angle_of_point(y: f32, x: f32) -> f32 {
    let p = abs(vec2f(x, y));
    let scaled = select(p, 0.5 * p, max(p.x, p.y) > 1.0);
    let a = atan2_positive(scaled.y, scaled.x);
    let turned = select(a, PI - a, x < 0.0);
    return select(turned, -turned, y < 0.0);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
fn footprint_of_vec2(v: vec2f) -> vec2f {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return sqrt(dx * dx + dy * dy);
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
fn footprint_of_vec3(v: vec3f) -> f32 {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

/// Relative luminance by the Rec. 709 weights, of the numbers as they stand.
fn luminance(color: Color) -> f32 {
    return dot(color.xyz, vec3f(0.2126, 0.7152, 0.0722));
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
fn axes_around(toward: vec3f, up: vec3f) -> mat3x3f {
    let leaning = cross(up, toward);
    let square = dot(leaning, leaning);
    let aside = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), abs(toward.x) > 0.7);
    let across = select(cross(aside, toward), leaning, square > 1e-8);
    let x = normalize_moderate(across - dot(across, toward) * toward, vec3f(1.0, 0.0, 0.0));
    return mat3x3f(x, cross(toward, x), toward);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
fn blend_add(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool) -> Composite {
    return clamp(vec4f(below.xyz + (below.xyz + tone * color.xyz - below.xyz), 1.0), vec4f(0.0),
        vec4f(1.0));
}

/// The farthest that anything counts as from a shape, in sizes of the shape.
const FAR_FROM_SHAPE: f32 = 1000.0;
/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
fn axes_turned(toward: vec3f, spin: f32) -> mat3x3f {
    let axes = axes_around(toward, vec3f(0.0, 1.0, 0.0));
    let turn = clamp(vec2f(0.0, 1.0), vec2f(-1.0), vec2f(1.0));
    return mat3x3f(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
fn axes_turned_2(toward: vec3f, spin: f32) -> mat3x3f {
    let axes = axes_around(toward, vec3f(0.0, 1.0, 0.0));
    let turn = clamp(sin_cos_eighth(spin - 0.0 - 0.0 - 0.0), vec2f(-1.0), vec2f(1.0));
    return mat3x3f(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// A place as seen from a center along axes, within a million of it.
fn place_along(place: vec3f, center: vec3f, axes: mat3x3f) -> vec3f {
    let away = clamp(place - center, vec3f(-1000000.0), vec3f(1000000.0));
    return vec3f(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

/// The share of a light that passes a shape at distance m, 1 on its surface, in sizes of the shape:
/// its edge is `softness` wide outward, and never narrower than a pixel. Call it in uniform control
/// flow.
fn share_beside(m: f32, softness: f32, density: f32, inverted: bool) -> f32 {
    let near = min(m, FAR_FROM_SHAPE);
    let half = 0.5 * min(footprint_of(near), 0.25);
    let beside = eased(near, 1.0 - half, 1.0 + half);
    return 1.0 - beside;
}

/// The share of a lamp's light that passes between four flaps, for a place as the lamp sees it and
/// the angles to the left, right, top and bottom flap.
fn share_of_doors(seen: vec3f, flaps: vec4f, softness: f32) -> f32 {
    let angles = vec2f(angle_of_point(seen.x, seen.z), angle_of_point(seen.y, seen.z));
    let half = 0.5 * min(footprint_of_vec2(angles), vec2f(0.1));
    let aside = (1.0 - smoothstep(flaps.x - half.x, flaps.x + max(softness, half.x), angles.x))
        * (1.0 - smoothstep(flaps.y - half.x, flaps.y + max(softness, half.x), -angles.x));
    return aside * (1.0 - smoothstep(flaps.z - half.y, flaps.z + max(softness, half.y), angles.y))
        * (1.0 - smoothstep(flaps.w - half.y, flaps.w + max(softness, half.y), -angles.y));
}

/// An angle as a filter before the profile leaves it: tan(u/2) over the share that passes, so that
/// the dark side grows from its edge as less passes, and everything is dark where nothing does.
fn angle_filtered(u: Angle, share: f32) -> Angle {
    let cosine = u.half_cos * share;
    let square = u.half_sin * u.half_sin + cosine * cosine;
    let scale = inverseSqrt(max(square, 1e-30));
    let is_dark = square < 1e-30;
    return Angle(select(u.half_sin * scale, 1.0, is_dark), select(cosine * scale, 0.0, is_dark));
}

/// A light at `light_position` seen from `position`, both in world space; `fading` is half distance
/// and range.
fn light_at(
    light_position: vec3f,
    own_from_world: mat3x3f,
    color: vec3f,
    intensity: f32,
    fading: vec2f,
    position: vec3f,
) -> Light {
    let offset = light_position - position;
    let direction = normalize_or(offset, vec3f(0.0, 0.0, 1.0));
    let faded = intensity * light_fading(length(offset), fading);
    return Light(direction, own_from_world * direction, color, faded);
}

/// Attenuation at `distance`: 1 / (1 + (d / half)^2), ended smoothly at the range by (1 - (d /
/// range)^4)^2. A half distance or range of 0 leaves its factor out.
fn light_fading(distance: f32, fading: vec2f) -> f32 {
    var left = 1.0;
    if fading.x > 0.0 {
        let d = min(distance / fading.x, 1e15);
        left = 1.0 / (1.0 + d * d);
    }
    if fading.y > 0.0 {
        let d = min(distance / fading.y, 1.0);
        let window = max(1.0 - d * d * d * d, 0.0);
        left *= window * window;
    }
    return left;
}

/// Attenuation at an angle from a spot light's aim: smoothstep between the cosines `cone.y` (outer)
/// and `cone.x` (inner); a hard, inclusive edge where they are equal.
fn light_cone(cos_angle: f32, cone: vec2f) -> f32 {
    if cone.x <= cone.y {
        return select(0.0, 1.0, cos_angle >= cone.y);
    }
    let t = clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

fn light_spot(
    light_position: vec3f,
    aim: vec3f,
    own_from_world: mat3x3f,
    color: vec3f,
    intensity: f32,
    cone: vec2f,
    fading: vec2f,
    position: vec3f,
) -> Light {
    var light = light_at(light_position, own_from_world, color, intensity, fading, position);
    light.intensity *= light_cone(dot(-light.direction, aim), cone);
    return light;
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

struct FilteredLight {
    /// The light behind the filter.
    light: Light,
    /// The angle for the profile.
    angle: Angle,
}

fn light_place_point(light_position: vec3f, angle: f32, spin: f32, toward: vec3f, position: vec3f)
    -> PlaceInLight {
    let seen = place_along(position, light_position, axes_turned_2(toward, spin));
    let turn = clamp(sin_cos_eighth(angle - 0.0 - 0.0 - 0.0), vec2f(-1.0), vec2f(1.0));
    let at = seen.xy * (turn.y / turn.x) / max(seen.z, 1e-3);
    return place_in_light(select(vec2f(1000.0), at, seen.z > 1e-3));
}

struct PlaceInLight {
    /// From 0,0 at the picture's lower left corner to 1,1 at its upper right one, as the light sees
    /// it.
    uv: vec2f,
    /// 1 within the picture, 0 outside of it.
    inside: f32,
}

fn place_in_light(at: vec2f) -> PlaceInLight {
    let near = clamp(at, vec2f(-1000.0), vec2f(1000.0));
    let inside = share_beside(max(abs(near.x), abs(near.y)), 0.0, 1.0, true);
    return PlaceInLight(0.5 + 0.5 * vec2f(-near.x, near.y), inside);
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

/// Cells
///
/// Space in pieces with straight borders, each with a number of its own: panes of glass, scales,
/// tiles, cracks. A Threshold of the border draws the seams, a Ramp of the number gives every piece
/// its color.
fn cells(position: vec3f, scale: f32, seed: i32) -> Cells {
    let p = bounded_vec3(position * scale);
    let cell = nearest_cell(p, 0u);
    let visible = 1.0 - smoothstep(0.5, 1.0, footprint_of_vec3(p));
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

const tone_shape = ProfileShape(0.87758255, 0.47942555, 20.008335, 2.4978132, 1.0, 0.04909103,
    0.021148764, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let lamp = light_spot(look.lamp_position, look.lamp_aim, look.lamp_own_from_world,
        look.lamp_color, look.lamp_intensity, look.lamp_cone, look.lamp_fading, surface.position);
    // Parametrization
    let angle = Angle(0.5 * length(surface.normal - lamp.direction), 0.5
        * length(surface.normal + lamp.direction));
    // Barn doors
    let doors = share_of_doors(place_along(surface.position, look.lamp_position,
        axes_turned(look.lamp_aim, 0.0)), vec4f(0.3, 0.36, 0.3, 0.2), 0.02);
    let place = light_place_point(look.lamp_position, 0.4, 0.6, look.lamp_aim, surface.position);
    let leaves = cells(vec3f(place.uv, 0.0), 13.0, 0i);
    // Combine filters
    let both = doors * smoothstep(0.12, 0.62, leaves.distance);
    // Light filter
    let filter_2 = FilteredLight(lamp,
        angle_filtered(angle, both * min(luminance(vec4f(1.0)), 1.0)));
    let tone = profile_balanced(filter_2.angle, 0.0, tone_shape);
    let lit = light_apply(filter_2.light, vec4f(0.93, 0.62, 0.36, 1.0), tone);
    return blend_add(vec4f(0.13, 0.14, 0.27, 1.0), lit.color, lit.tone, 1.0, true);
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
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, in.position);
    return shade(surface);
}
