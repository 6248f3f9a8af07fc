// Film print: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// film-print.json says what to put there and how to draw.

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

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    points: array<vec4f, 16>,
    /// Number of points that count.
    count: u32,
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
    interpolation: u32,
}

const LOG2_E: f32 = 1.44269504088896340736;
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

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
fn log1p_negative_small(y: f32) -> f32 {
    let z = y / (2.0 - y);
    let z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.333333333333333333
        + z2 * (0.2 + z2 * (0.142857142857142857 + z2 * 0.111111111111111111))));
}

/// [`sin_cos_quarter`] for |x| <= 0.1.
fn sin_cos_tiny(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.166666666666666667 + y * 0.00833333333333333333));
    let c = 1.0 - y * (0.5 + y * (-0.0416666666666666667 + y * 0.00138888888888888889));
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
    let s = u.half_sin * t.y - u.half_cos * t.x;
    let c = u.half_cos * t.y + u.half_sin * t.x;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < c));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned_3(u: Angle, t: vec2f) -> Angle {
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
    return sqrt(dot(d, d));
}

/// The curve's y at x; the steps of a stepped curve are averaged over a footprint of `w`. 0 for a
/// curve without points.
fn curve_at(curve: Curve, x: f32, w: f32) -> f32 {
    var points = curve.points;
    var i_2 = 1u;
    var at = 0u;
    loop {
        if !(i_2 < 6u) {
            break;
        }
        at = select(at, i_2, points[i_2].x <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let a = points[at];
    if (at + 1u >= 6u) | (x <= a.x) {
        return a.y;
    }
    let b = points[at + 1u];
    let t = clamp(divided(x - a.x, b.x - a.x), 0.0, 1.0);
    return hermite(vec4f(a.y), vec4f(b.y), (b.x - a.x) * vec4f(a.z), (b.x - a.x) * vec4f(b.z), t).x;
}

/// The curve's y at x; the steps of a stepped curve are averaged over a footprint of `w`. 0 for a
/// curve without points.
fn curve_at_2(curve: Curve, x: f32, w: f32) -> f32 {
    var points = curve.points;
    var i_2 = 1u;
    var at = 0u;
    loop {
        if !(i_2 < 4u) {
            break;
        }
        at = select(at, i_2, points[i_2].x <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let a = points[at];
    if (at + 1u >= 4u) | (x <= a.x) {
        return a.y;
    }
    let b = points[at + 1u];
    let t = clamp(divided(x - a.x, b.x - a.x), 0.0, 1.0);
    return hermite(vec4f(a.y), vec4f(b.y), (b.x - a.x) * vec4f(a.z), (b.x - a.x) * vec4f(b.z), t).x;
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
fn hermite(a: vec4f, b: vec4f, from_a: vec4f, to_b: vec4f, t: f32) -> vec4f {
    let d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// Color curves
///
/// Redraws a color's channels along curves, one for all of them and then one for each: contrast,
/// film looks, split toning.
fn color_curves(color: Color, all: Curve, red: Curve, green: Curve, blue: Curve) -> Color {
    let w = vec3f(footprint_of(color.x), footprint_of(color.y), footprint_of(color.z));
    let r = curve_at_2(all, color.x, w.x);
    let g = curve_at_2(all, color.y, w.y);
    let b = curve_at_2(all, color.z, w.z);
    return vec4f(curve_at_2(red, r, w.x), curve_at_2(green, g, w.y), curve_at_2(blue, b, w.z), 1.0);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return vec4f(below.xyz + tone * (color.xyz - below.xyz), 1.0);
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

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin - u.half_cos * 0.0;
    if s <= 0.0 {
        return 1.0;
    }
    let q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
fn profile_power(q: f32, exponent: f32) -> f32 {
    if q >= 1.0 {
        return 0.0;
    }
    var log_base = 0.0;
    if q < 0.5 {
        log_base = LOG2_E * log1p_negative_small(q * q);
    } else {
        log_base = log2_stable((1.0 - q) * (1.0 + q));
    }
    return min(exp2_stable(exponent * log_base), 1.0);
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point(u, shape);
    let is_wide = w < 0.1 * shape.edge_deviation;
    if is_wide | (w <= 0.0) {
        return point;
    }
    let reach = sin_cos_tiny(0.193649167310370844 * w);
    let before = profile_point(angle_turned(u, reach), shape);
    let after = profile_point(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
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

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
fn profile(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
    return profile_filtered(warped, angle_footprint(warped), shape);
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned_3(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

const tone_shape = ProfileShape(1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107, 0.63535863, 0u);
const response_of_the_film = Curve(array(vec4f(0.0, 0.0, 0.2, 0.0), vec4f(0.3, 0.06, 0.36, 0.0),
    vec4f(0.5, 0.42, 0.972973, 0.0), vec4f(0.62, 0.5, 1.0256411, 0.0),
    vec4f(0.8, 0.9, 0.81632656, 0.0), vec4f(1.0, 1.0, 0.5, 0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 6u, 1u);
const sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05, 0.3043368,
    0.13399889, 0u);
const back_light_tone_shape = ProfileShape(0.9689124, 0.24740396, 4.0419726, 1.8505588, 0.5,
    0.27256957, 0.11186968, 0u);
const film_print = Curve(array(vec4f(0.0, 0.04, 0.64, 0.0), vec4f(0.25, 0.2, 0.8608187, 0.0),
    vec4f(0.6, 0.66, 0.97504276, 0.0), vec4f(1.0, 0.97, 0.775, 0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0)), 4u, 1u);
const film_print_2 = Curve(array(vec4f(0.0, 0.0, 0.73333335, 0.0),
    vec4f(0.3, 0.22, 0.99215686, 0.0), vec4f(0.6, 0.68, 1.0514286, 0.0), vec4f(1.0, 1.0, 0.8, 0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 4u, 1u);
const film_print_3 = Curve(array(vec4f(0.0, 0.06, 0.8333333, 0.0), vec4f(0.3, 0.31, 0.8805031, 0.0),
    vec4f(0.6, 0.59, 0.91636366, 0.0), vec4f(1.0, 0.95, 0.9, 0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0)), 4u, 1u);
const film_print_4 = Curve(array(vec4f(0.0, 0.13, 0.8, 0.0), vec4f(0.3, 0.37, 0.53333336, 0.0),
    vec4f(0.6, 0.49, 0.51555556, 0.0), vec4f(1.0, 0.78, 0.725, 0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0)), 4u, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let turned_from_the_key = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let tone = profile(turned_from_the_key, 0.0, tone_shape);
    let response_of_the_film_2 = curve_at(response_of_the_film, tone, footprint_of(tone));
    // Blend
    let body_tone = clamp(response_of_the_film_2, 0.0, 1.0);
    let body = blend_alpha(vec4f(0.1216, 0.1137, 0.1333, 1.0), vec4f(0.7765, 0.7137, 0.6392, 1.0),
        body_tone, 1.0, true);

    // Sheen (Light layer)
    let sheen_angle = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    let sheen_tone = profile_balanced(sheen_angle, 0.0, sheen_tone_shape);
    let sheen_lit = light_apply(look.key, vec4f(0.3725, 0.3451, 0.298, 1.0), sheen_tone);
    let sheen_blend = clamp(vec4f(body.xyz + sheen_lit.tone * sheen_lit.color.xyz, 1.0), vec4f(0.0),
        vec4f(1.0));

    // Back-light (Light layer)
    let back_light_angle = Angle(0.5 * length(surface.normal - look.back.direction), 0.5
        * length(surface.normal + look.back.direction));
    let back_light_tone = profile_balanced(back_light_angle, 0.0, back_light_tone_shape);
    let back_light_lit = light_apply(look.back, vec4f(0.498, 0.5255, 0.549, 1.0), back_light_tone);
    let back_light_blend = clamp(vec4f(sheen_blend.xyz + back_light_lit.tone
        * back_light_lit.color.xyz, 1.0), vec4f(0.0), vec4f(1.0));

    let film_print_5 = color_curves(back_light_blend, film_print, film_print_2, film_print_3,
        film_print_4);
    return film_print_5;
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
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position));
    return shade(surface);
}
