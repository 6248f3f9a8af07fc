// Grisaille and glaze: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// glaze.json says what to put there and how to draw.

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
    @align(16) key: Light,
    @align(16) back: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    kappa: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

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

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
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

/// [`bounded`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
}

/// [`mixed`], component by component.
fn mixed_vec3(a: vec3f, b: vec3f, t: f32) -> vec3f {
    let d = bounded_vec3(b - a);
    return bounded_vec3(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
fn soft_light(a: f32, b: f32) -> f32 {
    let curved = select(sqrt(max(a, 0.0)), ((16.0 * a - 12.0) * a + 4.0) * a, a <= 0.25);
    return a + (2.0 * b - 1.0) * (curved - a);
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
fn color_mixed(a: vec4f, blended: vec3f, factor: f32) -> vec4f {
    let b = bounded_vec3(blended);
    return vec4f(bounded_vec3(b - (1.0 - factor) * bounded_vec3(b - a.xyz)), 1.0);
}

/// Lightness of a color in the non-separable modes (W3C Compositing and Blending 1, Lum).
fn lightness_of(rgb: vec3f) -> f32 {
    return dot(rgb, vec3f(0.3, 0.59, 0.11));
}

/// `rgb` as light as `other`, drawn toward its gray where a component would leave [0, 1] (SetLum,
/// ClipColor).
fn lit_as(rgb: vec3f, other: vec3f) -> vec3f {
    let light = lightness_of(other);
    let moved = rgb + (light - lightness_of(rgb));
    let least = min(min(moved.x, moved.y), moved.z);
    let largest = max(max(moved.x, moved.y), moved.z);
    let raised = select(1.0, light / max(light - least, 1e-6), least < 0.0);
    let clipped = light + (moved - light) * raised;
    // If both ends lie outside, the upper one is measured after the lower one was drawn in.
    let top = light + (largest - light) * raised;
    let lowered = select(1.0, (1.0 - light) / max(top - light, 1e-6), top > 1.0);
    return light + (clipped - light) * lowered;
}

/// Hue of b with the saturation and lightness of a; both counted from 0 to 1.
fn hued(a: vec3f, b: vec3f) -> vec3f {
    let below = clamp(bounded_vec3(a), vec3f(0.0), vec3f(1.0));
    return lit_as((b - b.y) * ((max(max(below.x, below.y), below.z)
        - min(min(below.x, below.y), below.z)) / (b.x - b.y)), below);
}

fn mix_colors_screen(a: Color, b: Color, factor: f32) -> Color {
    return vec4f(mixed_vec3(bounded_vec3(a.xyz), bounded_vec3(a.xyz + b.xyz - a.xyz * b.xyz),
        factor), 1.0);
}

fn mix_colors_soft_light(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, vec3f(soft_light(a.x, b.x), soft_light(a.y, b.y), a.z
        - (1.0 - 2.0 * b.z) * a.z * (1.0 - a.z)), factor);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return clamp(vec4f(below.xyz + tone * (color.xyz - below.xyz), 1.0), vec4f(0.0), vec4f(1.0));
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin - 0.0, u.half_cos);
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

struct VectorParts {
    /// The first number.
    x: f32,
    /// The second number.
    y: f32,
    /// The third number.
    z: f32,
}

const gray_modeling_tone_shape = ProfileShape(1.0, 0.0, 1.0537579, 1.3909147, 0.0, 1.2772532,
    0.561292, 0u);
const gray_lights_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.0858297, 3.3126261, 0.1,
    0.42646712, 0.19445144, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Gray modeling (Light layer)
    let gray_modeling_angle = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let gray_modeling_tone = profile_balanced(gray_modeling_angle, 0.0, gray_modeling_tone_shape);
    let gray_modeling_lit = light_apply(look.key, vec4f(0.7059, 0.7059, 0.7059, 1.0),
        gray_modeling_tone);
    let gray_modeling_blend = blend_alpha(vec4f(0.1216, 0.1216, 0.1216, 1.0),
        gray_modeling_lit.color, gray_modeling_lit.tone, 1.0, true);

    // Gray lights (Light layer)
    let gray_lights_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    let gray_lights_tone = profile_balanced_2(gray_lights_angle, 0.0, gray_lights_tone_shape);
    let gray_lights_lit = light_apply(look.key, vec4f(0.2902, 0.2902, 0.2902, 1.0),
        gray_lights_tone);
    let gray_lights_blend = clamp(vec4f(gray_modeling_blend.xyz + gray_lights_lit.tone
        * gray_lights_lit.color.xyz, 1.0), vec4f(0.0), vec4f(1.0));

    // Set alpha
    let grisaille = vec4f(gray_lights_blend.xyz, 1.0);
    let glaze_of_green_earth = vec4f(mix(grisaille.xyz,
        lit_as(vec4f(0.4275, 0.5412, 0.4471, 1.0).xyz, grisaille.xyz), 0.75), 1.0);
    let glaze_of_sienna = vec4f(mix(grisaille.xyz,
        lit_as(vec4f(0.7098, 0.4667, 0.3098, 1.0).xyz, grisaille.xyz), 0.7), 1.0);
    let place = surface.position_object;
    let height = VectorParts(place.x, place.y, place.z);
    let toward_the_head = smoothstep(-0.5, 0.5, height.y);
    let from_green_to_sienna = mix(glaze_of_green_earth, glaze_of_sienna, toward_the_head);
    let warm_light = mix_colors_soft_light(from_green_to_sienna, vec4f(0.9098, 0.702, 0.4157, 1.0),
        0.6);
    let curvature = surface.kappa;
    // Curvature transition
    let bulge = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.8853900817779268 * clamp(curvature * 0.06, -20.0, 20.0))));
    let hollows = mix(0.6, 0.0, min((bulge - 0.0) / (0.55 - 0.0), 1.0));
    // Mix colors
    let wine_in_the_hollows = vec4f(mixed_vec3(bounded_vec3(warm_light.xyz),
        hued(warm_light.xyz, vec4f(0.4902, 0.2471, 0.3608, 1.0).xyz), max(hollows, 0.0)), 1.0);
    let rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.6, 1.0);
    let cool_edge = mix_colors_screen(wine_in_the_hollows, vec4f(0.4353, 0.5294, 0.6588, 1.0),
        rim_2);
    return finite_vec4(cool_edge);
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
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x);
    return finite_vec4(shade(surface));
}
