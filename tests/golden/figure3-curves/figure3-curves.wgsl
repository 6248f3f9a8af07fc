// Profile curves: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1.
// figure3-curves.json says what to put there and how to draw.

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

/// The surface under the fragment, in world space.
struct Surface {
    uv: vec2f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;

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

const PI: f32 = 3.14159265358979323846;
/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// x, or `otherwise` where x is NaN or infinite.
fn finite_or(x: f32, otherwise: f32) -> f32 {
    return select(otherwise, x, is_finite(x));
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

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
fn angle_of(radians: f32) -> Angle {
    let half_angle = 0.5 * clamp(finite_or(radians, 0.0), 0.0, PI);
    let sc = sin_cos_quarter(half_angle);
    return Angle(max(sc.x, 0.0), max(sc.y, 0.0));
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

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    return select(clamp(0.5 + d / w, 0.0, 1.0), select(0.0, 1.0, d >= 0.0), w < 1e-30);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return vec4f(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

fn blend_alpha_2(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
}

fn blend_alpha_3(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + tone * (color.xyz - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
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
    return select(pow(max(1.0 - q * q, 0.0), 1.0), 1.0, s <= 0.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick_2(s: f32, shape: ProfileShape) -> f32 {
    let q = s * shape.scale;
    return select(pow(max(1.0 - q * q, 0.0), shape.exponent), 1.0, s <= 0.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick_3(s: f32, shape: ProfileShape) -> f32 {
    let q = s * shape.scale;
    return select(pow(1.0 - q * q, shape.exponent), 1.0, s <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin * 0.0);
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
    let place = vec2f(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin * 0.0);
    let point = profile_soft_quick_2(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick_3(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick_3(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    let point = profile_soft_quick_2(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick_2(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
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

fn profile_balanced_3(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick_3(warped, angle_footprint(warped), shape);
}

/// Threshold
///
/// 0 below an edge, 1 from the edge on, antialiased by its own width on the screen: cuts a hard
/// shape out of anything smooth. Where the value does not change on the screen the edge is hard,
/// and the edge itself is 1.
fn threshold(value: f32, edge: f32, softness: f32) -> f32 {
    return step_filtered(value, edge, length(vec2f(footprint_of(value), softness)));
}

/// Separate vector
///
/// The three numbers of a vector.
fn separate_vector(vector: vec3f) -> VectorParts {
    return VectorParts(vector.x, vector.y, 0.0);
}

struct VectorParts {
    /// The first number.
    x: f32,
    /// The second number.
    y: f32,
    /// The third number.
    z: f32,
}

const lambert_shape = ProfileShape(1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926, 0u);
const half_lambert_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);
const custom_shape = ProfileShape(0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5, 0.49992928,
    0.2351043, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let place = separate_vector(vec3f(surface.uv, 0.0));
    let tone = (place.y - 0.14) / (0.86 - 0.14);
    // Blend
    let angles_tone = max(threshold(tone, -0.006, 0.0) - threshold(tone, 0.006, 0.0), 0.0);
    let angles = blend_alpha(vec4f(0.98, 0.965, 0.925, 1.0), vec4f(0.24, 0.26, 0.3, 1.0),
        angles_tone, 1.0, true);
    let angle = mix(0.0, 3.1415927, (place.x - 0.08) / (0.92 - 0.08));
    // Blend
    let tones_tone = max(threshold(angle, -0.012, 0.0) - threshold(angle, 0.012, 0.0), 0.0);
    // Blend
    let tones = max(vec4f(angles.xyz + tones_tone * (vec4f(0.24, 0.26, 0.3, 1.0).xyz - angles.xyz),
        1.0), vec4f(0.0));
    // Blend
    let offset_tone = max(threshold(angle, 0.492, 0.0) - threshold(angle, 0.508, 0.0), 0.0);
    let offset = blend_alpha_2(tones, vec4f(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55, true);
    // Blend
    let falloff_tone = max(threshold(angle, 0.942, 0.0) - threshold(angle, 0.958, 0.0), 0.0);
    let falloff = blend_alpha_2(offset, vec4f(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55, true);
    // Blend
    let cutoff_tone = max(threshold(angle, 1.792, 0.0) - threshold(angle, 1.808, 0.0), 0.0);
    let cutoff = blend_alpha_2(falloff, vec4f(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55, true);
    let lambert = profile_balanced(angle_of(angle), 0.0, lambert_shape);
    let lambert_off = tone - lambert;
    let lambert_line = threshold(lambert_off, -0.012, 0.0) - threshold(lambert_off, 0.012, 0.0);
    // Blend
    let lambert_tone = max(lambert_line, 0.0);
    let lambert_2 = blend_alpha_3(cutoff, vec4f(0.8, 0.2, 0.17, 1.0), lambert_tone, 1.0, true);
    let half_lambert = profile_balanced_2(angle_of(angle), 0.0, half_lambert_shape);
    let half_lambert_off = tone - half_lambert;
    let half_lambert_to = threshold(half_lambert_off, 0.012, 0.0);
    let half_lambert_line = threshold(half_lambert_off, -0.012, 0.0) - half_lambert_to;
    // Blend
    let half_lambert_tone = max(half_lambert_line, 0.0);
    let half_lambert_2 = blend_alpha_3(lambert_2, vec4f(0.18, 0.55, 0.27, 1.0), half_lambert_tone,
        1.0, true);
    let custom = profile_balanced_3(angle_of(angle), 0.0, custom_shape);
    let custom_off = tone - custom;
    let custom_line = threshold(custom_off, -0.012, 0.0) - threshold(custom_off, 0.012, 0.0);
    // Blend
    let custom_tone = max(custom_line, 0.0);
    let custom_2 = blend_alpha_3(half_lambert_2, vec4f(0.5, 0.31, 0.14, 1.0), custom_tone, 1.0,
        true);
    return custom_2;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(3) uv: vec2f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) uv: vec2f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, vertex.uv);
}

@fragment
fn fs_main(in: Varyings) -> @location(0) vec4f {
    let surface = Surface(in.uv);
    return shade(surface);
}
