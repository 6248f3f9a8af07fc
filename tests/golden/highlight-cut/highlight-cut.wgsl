// Highlights, cut and joined: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// highlight-cut.json says what to put there and how to draw.

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
    @align(16) back: Light,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned_2(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - u.half_cos * 0.0;
    let c = u.half_cos + u.half_sin * 0.0;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < c));
    return Angle(turned.x, turned.y);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// Angle between directions
///
/// The angle that a Profile turns into a tone, between any two directions: a bent half-vector and
/// the normal, a hair's tangent and a light.
fn angle_between_directions(a: vec3f, b: vec3f) -> Angle {
    return Angle(0.5 * length(a - b), 0.5 * length(a + b));
}

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    direction: vec3f,
    x_axis: vec3f,
    y_axis: vec3f,
    /// The direction's cosines with the two axes.
    place: vec2f,
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
fn direction_within(direction: vec3f, x_axis: vec3f, y_axis: vec3f) -> DirectionParts {
    let y = y_axis * inverseSqrt(max(dot(y_axis, y_axis), 1e-30));
    return DirectionParts(direction, x_axis, y, vec2f(dot(direction, x_axis), dot(direction, y)));
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
fn direction_moved(parts: DirectionParts, by: vec2f) -> vec3f {
    let moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    return select(parts.direction, normalize_moderate(moved, parts.direction), dot(moved, moved)
        > 1e-6);
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

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
fn axes(direction: vec3f, up: vec3f) -> AxesAround {
    let axes_2 = axes_around(direction, up);
    return AxesAround(axes_2[0], axes_2[1]);
}

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    x_axis: vec3f,
    /// Unit, upright.
    y_axis: vec3f,
}

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
fn half_vector(light: Light, view: vec3f) -> vec3f {
    let half = light.direction + view;
    return normalize_or(select(any_orthogonal(view), half, dot(half, half) > 1e-12), view);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
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

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick_2(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w);
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
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

fn profile_balanced_2(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint(warped), shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
fn rim(light: Light, normal: vec3f, view: vec3f, width: f32, softness: f32, follow: f32) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let edge = max(width * softness, min(footprint_of(facing), 1.0));
    let aside = normal - view;
    let further = select(width - facing, 0.5 * dot(aside, aside) - (1.0 - width), facing > 0.5);
    let within = further / edge + 0.0;
    let inside = clamp(within, 0.0, 1.0);
    let across = light.direction - dot(light.direction, view) * view;
    let side = dot(normal - dot(normal, view) * view, across
        * inverseSqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
}

const lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733,
    0.08138281, 0u);
const disc_shape = ProfileShape(0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u);
const bite_shape = ProfileShape(0.9887711, 0.14943813, 0.0, 1.0, 0.3, 0.0, 0.0, 1u);
const dot_shape = ProfileShape(0.99875027, 0.04997917, 0.0, 1.0, 0.1, 0.0, 0.0, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let turned_from_the_key = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    let in_the_dark = 1.0 - lit_side;
    // Blend
    let shadow = vec4f(vec4f(0.62, 0.16, 0.26, 1.0).xyz
        * mix(vec3f(1.0), vec4f(0.5, 0.33, 0.56, 1.0).xyz, in_the_dark), 1.0);
    let normal = surface.normal;
    let half = half_vector(look.key, surface.view);
    let from_the_highlight = angle_between_directions(normal, half);
    let disc = profile_balanced_2(from_the_highlight, 0.0, disc_shape);
    let upright = axes(half, vec3f(0.0, 1.0, 0.0));
    // Shift direction
    let aside = direction_moved(direction_within(normal, upright.x_axis, upright.y_axis),
        vec2f(-0.13, 0.13));
    let from_beside_it = angle_between_directions(aside, half);
    let bite = profile_balanced_2(from_beside_it, 0.0, bite_shape);
    // Combine tones
    let crescent = min(disc, 1.0 - bite);
    // Shift direction
    let dot_s_place = direction_moved(direction_within(normal, upright.x_axis, upright.y_axis),
        vec2f(-0.06, 0.06));
    let from_the_dot = angle_between_directions(dot_s_place, half);
    let dot_2 = profile_balanced_2(from_the_dot, 0.0, dot_shape);
    // Combine tones
    let crescent_and_dot = max(crescent, dot_2);
    let highlight_on_top = blend_alpha(shadow, vec4f(1.0, 0.97, 0.9, 1.0), crescent_and_dot, 0.96,
        true);
    let rim_2 = rim(look.back, surface.normal, surface.view, 0.42, 0.08, 1.0);
    // Combine tones
    let rim_in_the_dark_only = min(rim_2, in_the_dark);
    // Blend
    let rim_s_light = clamp(vec4f(highlight_on_top.xyz + 0.6
        * (highlight_on_top.xyz + rim_in_the_dark_only * vec4f(1.0, 0.62, 0.5, 1.0).xyz
        - highlight_on_top.xyz), 1.0), vec4f(0.0), vec4f(1.0));
    return rim_s_light;
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
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position));
    return shade(surface);
}
