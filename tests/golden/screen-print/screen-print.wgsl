// Screen print: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// screen-print.json says what to put there and how to draw.

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
    @align(16) side: Light,
    @align(16) viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    kappa: f32,
    pixel: vec2f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

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

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
fn place_between(x: f32, low: f32, high: f32) -> f32 {
    let span = high - low;
    if abs(span) < SMALLEST_NORMAL {
        return select(0.0, 1.0, x >= high);
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
fn footprint_of_vec2(v: vec2f) -> vec2f {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return sqrt(dx * dx + dy * dy);
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    return select(clamp(0.5 + d / w, 0.0, 1.0), select(0.0, 1.0, d >= 0.0), w < 1e-30);
}

fn mix_colors_multiply(a: Color, b: Color, factor: f32) -> Color {
    return vec4f(mix(a.xyz, a.xyz * b.xyz, factor), 1.0);
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

/// p turned by an angle in radians, from x to y.
fn turned_by(p: vec2f, angle: f32) -> vec2f {
    let turn = vec2f(sin(angle), cos(angle));
    return vec2f(turn.y * p.x - turn.x * p.y, turn.x * p.x + turn.y * p.y);
}

/// A place in pixels, in cells of a half-tone screen that has `lines` lines to the picture's height
/// and is turned by an angle in radians.
fn screen_cells(place: vec2f, viewport: vec2f, lines: f32, angle: f32) -> vec2f {
    let most = vec2f(4194304.0);
    let upright = place * (lines / max(viewport.y, 1.0));
    return clamp(turned_by(clamp(upright, vec2f(-4194304.0), most), angle), vec2f(-4194304.0),
        most);
}

/// Lines that cover `share` of all, from 0 to 1: 1 within half a `share` of every whole number, 0
/// elsewhere, averaged over a footprint of `w`. Without a footprint the edges are inclusive.
fn lines_filtered(x: f32, share: f32, w: f32) -> f32 {
    let t = x - round(x);
    if w < 1e-30 {
        return select(0.0, 1.0, (abs(t) <= 0.5 * share) & (share > 0.0));
    }
    // Beyond a thousand lines to the pixel the average does not change any more.
    let half = 0.5 * min(w, 1e3);
    return clamp((lines_integral(t + half, share) - lines_integral(t - half, share)) / (2.0 * half),
        0.0, 1.0);
}

/// The integral of lines from 0 to x.
fn lines_integral(x: f32, share: f32) -> f32 {
    let whole = round(x);
    return whole * share + clamp(x - whole, -0.5 * share, 0.5 * share);
}

/// The radius of disks around whole places that together cover `share` of the plane: beyond pi/4
/// they overlap, and at 1 they reach the middle between four.
fn dot_radius(share: f32) -> f32 {
    if share <= 0.785398163397448310 {
        return sqrt(share * 0.318309886183790672);
    }
    let s = (share - 0.785398163397448310) / (1.0 - 0.785398163397448310);
    var a = mix(0.52272320087706337 * sqrt(s), 0.785398163397448310 - 0.32756818878101679
        * sqrt(1.0 - s), s);
    var i = 0;
    loop {
        if !(i < 2) {
            break;
        }
        let turn = sin_cos_quarter(clamp(a, 0.0, 0.785398163397448310));
        let tangent = turn.x / turn.y;
        let square = 1.0 / (turn.y * turn.y);
        let sector = 0.7853981633974483 - a;
        let slope = 2.0 * sector * square * tangent;
        a = clamp(a - select(0.0, (sector * square + tangent - share) / slope, slope > 1e-3), 0.0,
            0.785398163397448310);
        continuing {
            i = i + 1;
        }
    }
    return 0.5 / sin_cos_quarter(a).y;
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
fn disk_filtered(d: f32, r: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, (d <= r) & (r > 0.0));
    }
    // A ramp as wide as a pixel adds pi w^2/12 to a disk's area. A disk too small to give that back
    // is drawn fainter.
    let square = r * r;
    let least = w * w / 3.0;
    let inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
fn disk_filtered_2(d: f32, r: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, d <= r);
    }
    let square = r * r;
    let least = w * w / 3.0;
    let inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
}

/// Ink of round dots that cover `share` of the plane.
fn ink_of_dots(cell: vec2f, share: f32, w: f32) -> f32 {
    let width = min(w, 1.0);
    var ink = disk_filtered(length(cell - round(cell)), dot_radius(share), width);
    let hole = sqrt((1.0 - share) * 0.318309886183790672);
    let is_star = smoothstep(0.3 * hole, 0.9 * hole, width) * smoothstep(0.5, 0.7, share);
    if is_star > 0.0 {
        ink = mix(ink, 1.0 - disk_filtered_2(length(cell - floor(cell) - 0.5), hole, width),
            is_star);
    }
    let mean = mix(ink, share, smoothstep(0.4, 1.0, w));
    return select(mean, share, share <= 0.0);
}

/// Ink of round dots that cover `share` of the plane.
fn ink_of_dots_2(cell: vec2f, share: f32, w: f32) -> f32 {
    let width = min(w, 1.0);
    var ink = disk_filtered(length(cell - round(cell)), dot_radius(share), width);
    let hole = sqrt((1.0 - share) * 0.318309886183790672);
    let is_star = eased(width, 0.3 * hole, 0.9 * hole) * smoothstep(0.5, 0.7, share);
    if is_star > 0.0 {
        ink = mix(ink, 1.0 - disk_filtered_2(length(cell - floor(cell) - 0.5), hole, width),
            is_star);
    }
    let mean = mix(ink, share, smoothstep(0.4, 1.0, w));
    return select(mean, share, share <= 0.0);
}

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
fn halftone_dots(value: f32, place: vec2f, lines: f32, angle: f32, viewport: vec2f) -> f32 {
    let cell = screen_cells(place, viewport, lines, angle);
    let w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots(cell, 1.0 - min(value, 1.0), max(w.x, w.y));
}

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
fn halftone_dots_2(value: f32, place: vec2f, lines: f32, angle: f32, viewport: vec2f) -> f32 {
    let cell = screen_cells(place, viewport, lines, angle);
    let w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots_2(cell, 1.0 - min(value, 1.0), max(w.x, w.y));
}

fn halftone_lines(value: f32, place: vec2f, lines: f32, angle: f32, viewport: vec2f) -> f32 {
    let cell = screen_cells(place, viewport, lines, angle);
    return 1.0 - lines_filtered(cell.y, 1.0 - value, footprint_of(cell.y));
}

const yellow_s_share_shape = ProfileShape(0.9887711, 0.14943813, 2.0858297, 1.7378688, 0.3,
    0.54759663, 0.22553022, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let side = Angle(0.5 * length(surface.normal - look.side.direction), 0.5
        * length(surface.normal + look.side.direction));
    let yellow_s_share = profile_balanced(side, 0.0, yellow_s_share_shape);
    let pale = mix(1.0, 0.25, yellow_s_share - 0.0);
    let yellow_screen = halftone_lines(pale, surface.pixel, 56.0, 0.0, look.viewport);
    let p1_ink = mix(vec4f(0.9647, 0.8118, 0.2902, 1.0), vec4f(1.0), yellow_screen);
    let on_paper = mix_colors_multiply(vec4f(0.9686, 0.9373, 0.8784, 1.0), p1_ink, 1.0);
    // Reflectance
    let shade_2 = max((dot(surface.normal, look.key.direction) + 0.3) / (1.0 + 0.3), 0.0);
    let tone = min((shade_2 - 0.0) / (0.8 - 0.0), 1.0);
    let coral_s_share = mix(0.12, 1.0, clamp((tone - 0.25) / (0.95 - 0.25), 0.0, 1.0));
    let coral_screen = halftone_dots(coral_s_share, surface.pixel, 56.0, 0.2618, look.viewport);
    let p2_ink = mix(vec4f(0.9333, 0.3529, 0.2902, 1.0), vec4f(1.0), coral_screen);
    let printed_over = vec4f(mix(on_paper.xyz, on_paper.xyz * p2_ink.xyz, 1.0), 1.0);
    let teal_s_share = mix(0.05, 1.0, min((tone - 0.0) / 0.5, 1.0));
    let teal_screen = halftone_dots_2(teal_s_share, surface.pixel, 56.0, 1.309, look.viewport);
    let p3_ink = mix(vec4f(0.1216, 0.5608, 0.5922, 1.0), vec4f(1.0), teal_screen);
    let printed_over_2 = vec4f(mix(printed_over.xyz, printed_over.xyz * p3_ink.xyz, 1.0), 1.0);
    let curvature = surface.kappa;
    // Curvature transition
    let hollow = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.8853900817779268 * clamp(curvature * 0.25, -20.0, 20.0))));
    // Threshold
    let hollows = step_filtered(hollow, 0.22, length(vec2f(footprint_of(hollow), 0.0)));
    let facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    // Threshold
    let outline = step_filtered(facing, 0.28, length(vec2f(footprint_of(facing), 0.0)));
    let black_screen = hollows * outline;
    let p4_ink = mix(vec4f(0.0902, 0.0745, 0.1216, 1.0), vec4f(1.0), black_screen);
    let printed_over_3 = vec4f(mix(printed_over_2.xyz, printed_over_2.xyz * p4_ink.xyz, 1.0), 1.0);
    return printed_over_3;
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
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        textureLoad(curvature_map, vec2i(in.clip.xy), 0).x, in.clip.xy * view.screen.xy
        + view.screen.zw);
    return shade(surface);
}
