// Guest: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// room-guest.json says what to put there and how to draw.

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
    eye_position: vec3f,
    eye_own_from_world: mat3x3f,
    eye_color: vec3f,
    eye_intensity: f32,
    eye_fading: vec2f,
    rim_position: vec3f,
    rim_aim: vec3f,
    rim_own_from_world: mat3x3f,
    rim_color: vec3f,
    rim_intensity: f32,
    rim_cone: vec2f,
    rim_fading: vec2f,
    fill_position: vec3f,
    fill_own_from_world: mat3x3f,
    fill_color: vec3f,
    fill_intensity: f32,
    fill_fading: vec2f,
    sun_direction: vec3f,
    @align(16) sun: Light,
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned_2(u: Angle, t: vec2f) -> Angle {
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

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
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
    let t = clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Relative luminance by the Rec. 709 weights, of the numbers as they stand.
fn luminance(color: Color) -> f32 {
    return dot(color.xyz, vec3f(0.2126, 0.7152, 0.0722));
}

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
fn limit_color(color: Color, limit: f32, softness: f32) -> Color {
    let knee = 1.0 - softness;
    let brightest = max(max(color.x, color.y), color.z);
    if brightest <= knee {
        return vec4f(color.xyz, 1.0);
    }
    let room = limit - knee;
    let above = brightest - knee;
    let pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return vec4f(color.xyz * min(pressed / brightest, 1.0), 1.0);
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

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
fn axes_turned(toward: vec3f, spin: f32) -> mat3x3f {
    let axes = axes_around(toward, vec3f(0.0, 1.0, 0.0));
    let turn = clamp(vec2f(0.0, 1.0), vec2f(-1.0), vec2f(1.0));
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
    let half = 0.5 * min(footprint_of(m), 0.25);
    let beside = eased(m, 1.0 - half, 1.0 + half);
    return 1.0 - beside;
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

/// Light parts
///
/// Takes a light apart, for shading that the other nodes do not know.
fn light_parts(light: Light) -> LightParts {
    return LightParts(light.direction, vec4f(light.color, 1.0), light.intensity);
}

struct LightParts {
    /// Unit, toward the light, world space.
    direction: vec3f,
    /// The light's color, opaque.
    color: Color,
    /// With the light's distance and cone attenuation; 0 or more.
    intensity: f32,
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

fn parametrization_diffuse_balanced(light: Light, normal: vec3f) -> Angle {
    return Angle(0.5 * length(normal - light.direction), 0.5 * length(normal + light.direction));
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

fn profile_balanced_2(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Window
///
/// Four panes of a window: 1 through the glass, 0 at its bars and beyond.
fn window(uv: vec2f, bars: f32, softness: f32) -> f32 {
    let from_edge = 0.5 - abs(uv - 0.5);
    let from_cross = abs(uv - 0.5);
    let within = smoothstep(vec2f(bars), vec2f(bars + softness), from_edge);
    let beside = smoothstep(vec2f(0.5 * bars), vec2f(0.5 * bars + softness), from_cross);
    return within.x * within.y * beside.x * beside.y;
}

const lamps_eye_tone_shape = ProfileShape(0.87758255, 0.47942555, 8.353367, 2.4874215, 1.0,
    0.117860116, 0.05078552, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Lamps eye (Lamps)
    let eye = light_at(look.eye_position, look.eye_own_from_world, look.eye_color,
        look.eye_intensity, look.eye_fading, surface.position);
    let eye_2 = light_parts(eye);
    let lamps_eye_strength = bounded_vec4(eye_2.color * vec4f(vec3f(eye_2.intensity), 1.0));
    let lamps_eye_angle = parametrization_diffuse_balanced(eye, surface.normal);
    let lamps_eye_tone = profile_balanced(lamps_eye_angle, 0.0, lamps_eye_tone_shape);
    let lamps_eye_lit = bounded_vec4(lamps_eye_strength * vec4f(vec3f(lamps_eye_tone), 1.0));

    // Lamps rim (Lamps)
    let rim = light_spot(look.rim_position, look.rim_aim, look.rim_own_from_world, look.rim_color,
        look.rim_intensity, look.rim_cone, look.rim_fading, surface.position);
    let rim_2 = light_parts(rim);
    let lamps_rim_strength = bounded_vec4(rim_2.color * vec4f(vec3f(rim_2.intensity), 1.0));
    let lamps_rim_angle = parametrization_diffuse_balanced(rim, surface.normal);
    let lamps_rim_tone = profile_balanced(lamps_rim_angle, 0.0, lamps_eye_tone_shape);
    let lamps_rim_lit = bounded_vec4(lamps_rim_strength * vec4f(vec3f(lamps_rim_tone), 1.0));

    // Lamps fill (Lamps)
    let fill = light_at(look.fill_position, look.fill_own_from_world, look.fill_color,
        look.fill_intensity, look.fill_fading, surface.position);
    let fill_2 = light_parts(fill);
    let lamps_fill_strength = bounded_vec4(fill_2.color * vec4f(vec3f(fill_2.intensity), 1.0));
    let lamps_fill_angle = parametrization_diffuse_balanced(fill, surface.normal);
    let lamps_fill_tone = profile_balanced(lamps_fill_angle, 0.0, lamps_eye_tone_shape);
    let lamps_fill_lit = bounded_vec4(lamps_fill_strength * vec4f(vec3f(lamps_fill_tone), 1.0));
    let lamps_fill_sum = select(vec4f(0.0, 0.0, 0.0, 1.0),
        vec4f(bounded_vec3(0.0 + lamps_fill_lit.xyz), 1.0), fill_2.intensity > 0.0);

    // Lamps rim
    let lamps_rim_sum = select(lamps_fill_sum,
        vec4f(bounded_vec3(lamps_fill_sum.xyz + lamps_rim_lit.xyz), 1.0), rim_2.intensity > 0.0);

    // Lamps eye
    let lamps_eye_sum = select(lamps_rim_sum,
        vec4f(bounded_vec3(lamps_rim_sum.xyz + lamps_eye_lit.xyz), 1.0), eye_2.intensity > 0.0);

    let lamplit = lamps_eye_sum * vec4f(0.86, 0.62, 0.44, 1.0);
    let night = lamplit + vec4f(0.1, 0.07, 0.15, 1.0);
    // Base
    let ground = vec4f(night.xyz, 1.0);
    let sun_angle = parametrization_diffuse_balanced(look.sun, surface.normal);
    let thrown = place_in_light(place_along(surface.position, vec3f(0.1, -0.05, 0.0),
        axes_turned(-look.sun_direction, 0.0)).xy / vec3f(0.95).x);
    let window_2 = window(thrown.uv, 0.05, 0.02);
    // Light filter
    let filter_2 = FilteredLight(look.sun,
        angle_filtered(sun_angle, min(window_2, 1.0) * min(luminance(vec4f(1.0)), 1.0)));
    let sun_tone = profile_balanced_2(filter_2.angle, 0.0, lamps_eye_tone_shape);
    let sun_lit = light_apply(filter_2.light, vec4f(0.86, 0.62, 0.44, 1.0), sun_tone);
    // Blend
    let stack = clamp(vec4f(ground.xyz + sun_lit.tone * sun_lit.color.xyz, 1.0), vec4f(0.0),
        vec4f(1.0));
    return limit_color(stack, 1.0, 0.3);
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
