// A highlight, moved: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// highlight-moves.json says what to put there and how to draw.

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
    @align(16) turn_angle: f32,
    move_x: f32,
    move_y: f32,
    stretch_x: f32,
    stretch_y: f32,
    split_x: f32,
    split_y: f32,
    square_amount: f32,
    body: vec4f,
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

const HALF_PI: f32 = 1.57079632679489661923;
const LN_2: f32 = 0.693147180559945309417;
const LOG2_E: f32 = 1.44269504088896340736;
/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
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

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let clamped = max(x, -126.0);
    let whole = round(clamped);
    let f = clamped - whole;
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

/// ln(x) for normal x > 0.
fn log_stable(x: f32) -> f32 {
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
fn log1p_negative(y: f32) -> f32 {
    if y < 0.25 {
        return log1p_negative_small(y);
    }
    return log_stable(max(1.0 - y, 1.17549435e-38));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
fn log1p_negative_small(y: f32) -> f32 {
    let z = y / (2.0 - y);
    let z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.333333333333333333
        + z2 * (0.2 + z2 * (0.142857142857142857 + z2 * 0.111111111111111111))));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
fn sin_cos_quarter(x: f32) -> vec2f {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    let h = 0.5 * x;
    let h2 = h * h;
    let s = h * (1.0 + h2 * (-0.166666666666666667
        + h2 * (0.00833333333333333333 + h2 * (-0.000198412698412698413
        + h2 * (0.00000275573192239858907 + h2 * -2.50521083854417188e-8)))));
    let one_minus_c = h2 * (0.5 + h2 * (-0.0416666666666666667
        + h2 * (0.00138888888888888889 + h2 * (-0.0000248015873015873016
        + h2 * (2.75573192239858907e-7 + h2 * -2.08767569878680990e-9)))));
    let c = 1.0 - one_minus_c;
    return vec2f(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [`sin_cos_quarter`] after reduction to a
/// quarter turn.
fn sin_cos(x: f32) -> vec2f {
    let turns = round(x * 0.318309886183790672);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    let r = ((x - turns * 3.140625) - turns * 0.0009670257568359375)
        - turns * 6.27832957300962643e-7;
    let sign = 1.0 - 2.0 * abs(turns - 2.0 * trunc(turns * 0.5));
    return sign * sin_cos_quarter(clamp(r, -HALF_PI, HALF_PI));
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

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
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
    let step = clamp(by, vec2f(-1000000.0), vec2f(1000000.0));
    let moved = parts.direction + step.x * parts.x_axis + step.y * parts.y_axis;
    return select(parts.direction, normalize_moderate(moved, parts.direction), dot(moved, moved)
        > 1e-6);
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
fn direction_moved_2(parts: DirectionParts, by: vec2f) -> vec3f {
    let moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    return select(parts.direction, normalize_moderate(moved, parts.direction), dot(moved, moved)
        > 1e-6);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
fn axes_around(toward: vec3f, up: vec3f) -> mat3x3f {
    let y = normalize_moderate(up, vec3f(0.0, 1.0, 0.0));
    let leaning = cross(y, toward);
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

/// Split direction
///
/// Cuts a highlight in two along an axis and moves the halves apart, or in four along both: window
/// panes in an eye.
fn split_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    let side = select(vec2f(-1.0), vec2f(1.0), bent.place >= vec2f(0.0));
    return direction_moved(bent, -max(vec2f(x, y), vec2f(0.0)) * side);
}

/// Square direction
///
/// Gives a highlight corners: from round to a square whose sides lie along the axes.
fn square_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, amount: f32, sharpness: f32)
    -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    let square = dot(bent.place, bent.place);
    let apart = abs(bent.place.x) - abs(bent.place.y);
    let aside = min(apart * apart / max(square, 1e-20), 1.0);
    let corner = select(0.0, exp2_stable(sharpness * LOG2_E * log1p_negative(aside)),
        (square > 1e-20) & (aside < 1.0));
    return direction_moved_2(bent, -clamp(amount, 0.0, 1.0) * corner * bent.place);
}

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
fn stretch_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -min(vec2f(x, y), vec2f(1.0)) * bent.place);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    let alpha = below.w + tone * opacity * (1.0 - below.w);
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), alpha), vec4f(0.0), vec4f(1.0));
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

/// Rotate vector
///
/// Turns a vector about an axis, counter-clockwise as the axis points at you.
fn rotate_vector(vector: vec3f, axis: vec3f, angle: f32) -> vec3f {
    let half = clamp(sin_cos(0.5 * angle), vec2f(-1.0), vec2f(1.0));
    let aside = cross(axis, vector);
    return bounded_vec3(vector + 2.0 * half.x * (half.y * aside + half.x * cross(axis, aside)));
}

const lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733,
    0.08138281, 0u);
const highlight_shape = ProfileShape(0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let turned_from_the_key = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    let in_the_dark = 1.0 - lit_side;
    // Blend
    let shadow = clamp(vec4f(look.body.xyz
        + (look.body.xyz * mix(vec3f(1.0), vec4f(0.45, 0.36, 0.62, 1.0).xyz, in_the_dark)
        - look.body.xyz), look.body.w), vec4f(0.0), vec4f(1.0));
    let normal = surface.normal;
    let half = half_vector(look.key, surface.view);
    let turn = rotate_vector(vec3f(0.0, 1.0, 0.0), half, look.turn_angle);
    let axes_of_the_highlight = axes(half, turn);
    // Shift direction
    let move_2 = direction_moved(direction_within(normal, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis), vec2f(look.move_x, look.move_y));
    let stretch = stretch_direction(move_2, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, look.stretch_x, look.stretch_y);
    let split = split_direction(stretch, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis,
        look.split_x, look.split_y);
    let square = square_direction(split, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis,
        look.square_amount, 4.0);
    // Angle between directions
    let from_the_highlight = Angle(0.5 * length(square - half), 0.5 * length(square + half));
    let highlight = profile_balanced_2(from_the_highlight, 0.0, highlight_shape);
    let highlight_on_top = blend_alpha(shadow, vec4f(1.0, 0.98, 0.92, 1.0), highlight, 0.96, true);
    let rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.2, 1.0);
    // Blend
    let rim_s_light = clamp(vec4f(highlight_on_top.xyz + 0.5
        * (highlight_on_top.xyz + rim_2 * vec4f(0.55, 0.75, 1.0, 1.0).xyz - highlight_on_top.xyz),
        highlight_on_top.w), vec4f(0.0), vec4f(1.0));
    let output = finite_vec4(select(vec4f(rim_s_light.xyz / rim_s_light.w, rim_s_light.w),
        rim_s_light, rim_s_light.w <= 0.0));
    return output;
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
    return finite_vec4(shade(surface));
}
