// Half-tone comic: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// halftone-comic.json says what to put there and how to draw.

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
    @align(16) key: Light,
    @align(16) viewport: vec2f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    pixel: vec2f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
fn footprint_of_vec2(v: vec2f) -> vec2f {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return sqrt(dx * dx + dy * dy);
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

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w);
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint(warped), shape);
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
    var ink = disk_filtered(length(cell - round(cell)), sqrt(share * 0.318309886183790672), width);
    let hole = sqrt((1.0 - share) * 0.318309886183790672);
    let is_star = smoothstep(0.3 * hole, 0.9 * hole, width) * smoothstep(0.5, 0.7, share);
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
    return 1.0 - ink_of_dots_2(cell, 1.0 - value, max(w.x, w.y));
}

const not_in_deep_shade_shape = ProfileShape(0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0, 0.0, 1u);
const highlight_shape = ProfileShape(0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Reflectance
    let light_and_shade = max((dot(surface.normal, look.key.direction) + 0.25) / 1.25, 0.0);
    let red_to_print = mix(0.15, 1.0, clamp((light_and_shade - 0.1) / (0.75 - 0.1), 0.0, 1.0));
    let red_dots = halftone_dots(red_to_print, surface.pixel, 78.0, 0.2617994, look.viewport);
    let red_on_yellow = mix(vec4f(0.91, 0.3, 0.24, 1.0), vec4f(1.0, 0.87, 0.58, 1.0), red_dots);
    // Parametrization
    let turned_from_the_light = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let not_in_deep_shade = profile_balanced(turned_from_the_light, 0.0, not_in_deep_shade_shape);
    let deep_shade = 1.0 - not_in_deep_shade;
    let how_much_blue = deep_shade * 0.62;
    let less = 1.0 - how_much_blue;
    let blue_dots = halftone_dots_2(less, surface.pixel, 78.0, 1.3089969, look.viewport);
    let inked = 1.0 - blue_dots;
    let blue_over_it = vec4f(mix(red_on_yellow.xyz, red_on_yellow.xyz
        * vec4f(0.24, 0.3, 0.58, 1.0).xyz, inked), 1.0);
    let mirrored = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    let highlight = profile_balanced(mirrored, 0.0, highlight_shape);
    let left_free = mix(blue_over_it, vec4f(1.0, 0.99, 0.95, 1.0), highlight);
    let contour = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.22);
    let black_line = mix(left_free, vec4f(0.09, 0.07, 0.13, 1.0), contour);
    return black_line;
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
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position), in.clip.xy
        * view.screen.xy + view.screen.zw);
    return shade(surface);
}
