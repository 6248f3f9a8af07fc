// Warped light: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_tensor_map 3.
// warped-light.json says what to put there and how to draw.

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
    @align(16) camera_from_world: mat3x3f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    curvature_tensor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_tensor_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

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

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let clamped = clamp(x, -126.0, 127.999992);
    let whole = round(clamped);
    let f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    let twice = 2.0 + f * (1.386294405710424 + f * (0.4804529582723118 + f * (0.11100664941567156
        + f * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable_2(x: f32) -> f32 {
    let clamped = max(x, -126.0);
    let whole = round(clamped);
    let f = clamped - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
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

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
fn srgb_of_linear(light: f32) -> f32 {
    let size = abs(light);
    let value = select(1.055 * pow(size, 0.4166666666666667) - 0.055, size * 12.92, size
        <= 0.0031308);
    return select(value, -value, light < 0.0);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
fn oklab_of_linear(rgb: vec3f) -> vec3f {
    let l = pow(dot(rgb, vec3f(0.4122214708, 0.5363325363, 0.0514459929)), 0.3333333333333333);
    let m = pow(dot(rgb, vec3f(0.2119034982, 0.6806995451, 0.1073969566)), 0.3333333333333333);
    let s = pow(dot(rgb, vec3f(0.0883024619, 0.2817188376, 0.6299787005)), 0.3333333333333333);
    return vec3f(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l
        - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660
        * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
fn linear_of_oklab(lab: vec3f) -> vec3f {
    let l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
    let m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
    let s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
    let cubes = vec3f(l * l * l, m * m * m, s * s * s);
    return vec3f(dot(cubes, vec3f(4.0767416621, -3.3077115913, 0.2309699292)),
        dot(cubes, vec3f(-1.2684380046, 2.6097574011, -0.3413193965)),
        dot(cubes, vec3f(-0.0041960863, -0.7034186147, 1.7076147010)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
fn oklab_of_srgb(coded: vec3f) -> vec3f {
    return oklab_of_linear(vec3f(select(pow((coded.x + 0.055) / 1.055, 2.4), coded.x / 12.92,
        coded.x <= 0.04045), pow((coded.y + 0.055) / 1.055, 2.4),
        pow((coded.z + 0.055) / 1.055, 2.4)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
fn oklab_of_srgb_2(coded: vec3f) -> vec3f {
    return oklab_of_linear(vec3f(pow((coded.x + 0.055) / 1.055, 2.4),
        pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
fn srgb_of_oklab(lab: vec3f) -> vec3f {
    let light = linear_of_oklab(lab);
    return vec3f(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// Place on a ramp: the colors before and after it, and the way between them.
struct RampPlace {
    before: vec4f,
    after: vec4f,
    /// Way from `before` to `after`, 0 to 1; smooth ramps are level at each stop.
    t: f32,
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
fn ramp_place(ramp: Ramp, x: f32) -> RampPlace {
    var colors = ramp.colors;
    var places = ramp.places;
    var i = 1u;
    var at = 0u;
    loop {
        if !(i < 5u) {
            break;
        }
        at = select(at, i, places[i / 4u][i % 4u] <= x);
        continuing {
            i = i + 1u;
        }
    }
    let after = min(at + 1u, 4u);
    let place = places[at / 4u][at % 4u];
    let t = clamp(divided(x - place, places[after / 4u][after % 4u] - place), 0.0, 1.0);
    return RampPlace(colors[at], colors[after], t);
}

fn mix_colors_screen(a: Color, b: Color, factor: f32) -> Color {
    return vec4f(mix(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, min(factor, 1.0)), 1.0);
}

fn mix_colors_screen_2(a: Color, b: Color, factor: f32) -> Color {
    return vec4f(mix(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, factor), 1.0);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
fn curvature_signed(kappa: f32, slope: f32) -> f32 {
    let a = clamp(kappa, -10000.0, 1e4) * slope;
    let magnitude = min(abs(a), 50.0);
    if magnitude < 0.0625 {
        let a2 = a * a;
        return a * (1.0 - a2 * (0.333333333333333333 - a2
            * (0.133333333333333333 - a2 * 0.0539682539682539683)));
    }
    let z = exp2_stable_2(-2.8853900817779268 * magnitude);
    let t = (1.0 - z) / (1.0 + z);
    return select(-t, t, a >= 0.0);
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
fn principal_curvatures(tensor: vec3f) -> vec2f {
    let mean = 0.5 * (tensor.x + tensor.z);
    let spread = length(vec2f(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    let far = mean + select(-spread, spread, mean >= 0.0);
    let near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return select(vec2f(near, far), vec2f(far, near), mean >= 0.0);
}

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    n_l: f32,
    n_v: f32,
    n_h: f32,
    v_h: f32,
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    sine2: f32,
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
fn reflection_of(light: vec3f, normal: vec3f, view: vec3f) -> Reflection {
    let half = half_of(light, normal, view);
    let n_h = clamp(dot(normal, half), 0.0, 1.0);
    let v_h = clamp(dot(view, half), 0.0, 1.0);
    return Reflection(dot(normal, light), dot(normal, view), n_h, v_h, sine_squared(normal, half));
}

/// The square of the sine between two unit vectors.
fn sine_squared(a: vec3f, b: vec3f) -> f32 {
    let across = cross(a, b);
    return min(dot(across, across), 1.0);
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
fn half_of(light: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let half = light + view;
    return normalize_moderate(select(normal, half, dot(half, half) > 1e-12), normal);
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
fn schlick(at_normal: f32, cosine: f32) -> f32 {
    let m = 1.0 - cosine;
    let m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Cook and Torrance's model with the GGX distribution and Smith's height-correlated shadowing
/// (Walter et al. 2007, Heitz 2014).
fn ggx(r: Reflection, width: f32, at_normal: f32) -> f32 {
    if (r.n_l <= 0.0) | (r.n_v <= 0.0) {
        return 0.0;
    }
    let a2 = width * width;
    let bottom = max(r.sine2 + a2 * r.n_h * r.n_h, 1e-12);
    let distribution = a2 / (bottom * bottom);
    let toward_light = r.n_v * sqrt(r.n_l * r.n_l * (1.0 - a2) + a2);
    let toward_eye = r.n_l * sqrt(r.n_v * r.n_v * (1.0 - a2) + a2);
    let visibility = 0.5 / max(toward_light + toward_eye, 1e-9);
    return min(distribution * visibility * schlick(at_normal, r.v_h) * r.n_l, 1e6);
}

fn ramp_oklab(value: f32, ramp: Ramp) -> Color {
    let place = ramp_place(ramp, value);
    return select(select(vec4f(srgb_of_oklab(mix(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb_2(place.after.xyz), place.t)), 1.0), place.after, place.t >= 1.0),
        place.before, place.t <= 0.0);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
fn rim(light: Light, normal: vec3f, view: vec3f, width: f32, softness: f32, follow: f32) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let edge = max(width * softness, min(footprint_of(facing), 1.0));
    let aside = normal - view;
    let further = select(width - facing, 0.5 * dot(aside, aside) - 0.5, facing > 0.5);
    let within = further / edge + 0.0;
    let inside = clamp(within, 0.0, 1.0);
    let across = light.direction - dot(light.direction, view) * view;
    let side = dot(normal - dot(normal, view) * view, across
        * inverseSqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// `place` times the symmetric matrix (xx, xy, yy) in which each principal curvature k of the
/// tensor has become 2^(-amount tanh(slope k)).
fn warped_place(tensor: vec3f, place: vec2f, amount: f32, slope: f32) -> vec2f {
    let k = principal_curvatures(tensor);
    let most = exp2_stable(-amount * curvature_signed(k.x, slope));
    let least = exp2_stable(-amount * curvature_signed(k.y, slope));
    let half_apart = vec2f(0.5 * (tensor.x - tensor.z), tensor.y);
    let axes = half_apart / max(length(half_apart), 1e-20);
    let turned = vec2f(axes.x * place.x + axes.y * place.y, axes.y * place.x - axes.x * place.y);
    return 0.5 * (most + least) * place + 0.5 * (most - least) * turned;
}

/// The light's direction after light warping: its stereographic projection from the point opposite
/// the normal is drawn nearer along convex directions and away along concave ones.
fn warped_light(light: vec3f, n: vec3f, view: vec3f, camera_from_world: mat3x3f, tensor: vec3f,
    amount: f32, slope: f32) -> vec3f {
    let right = vec3f(1.0, 0.0, 0.0) * camera_from_world;
    let x = normalize_moderate(right - dot(right, view) * view, vec3f(1.0, 0.0, 0.0));
    let y = cross(view, x);
    let between = (view + n) / max(1.0 + dot(view, n), 0.01);
    let along_x = x - dot(n, x) * between;
    let along_y = y - dot(n, y) * between;
    let place = vec2f(dot(light, along_x), dot(light, along_y)) / max(1.0 + dot(light, n), 1e-4);
    let q = warped_place(tensor, place, amount, slope);
    let square = dot(q, q);
    return normalize_or(2.0 * q.x * along_x + 2.0 * q.y * along_y + (1.0 - square) * n, light);
}

/// Warp light
///
/// Bends a light over the surface's shape: bumps and ridges draw it toward themselves, hollows push
/// it away, so that every layer it lights shows more of the form. Flat places see it as it is, and
/// so does the outline.
fn light_warp(light: Light, normal: vec3f, amount: f32, slope: f32, tensor: vec3f, view: vec3f,
    camera_from_world: mat3x3f) -> Light {
    let most = amount * smoothstep(0.05, 0.3, dot(normal, view));
    let warped = warped_light(light.direction, normal, view, camera_from_world, tensor, most,
        slope);
    let is_flat = most == 0.0;
    return Light(select(warped, light.direction, is_flat), light.own_direction, light.color,
        light.intensity);
}

const jade = Ramp(array(vec4f(0.0157, 0.1294, 0.1216, 1.0), vec4f(0.0588, 0.3529, 0.298, 1.0),
    vec4f(0.2471, 0.6275, 0.4784, 1.0), vec4f(0.7137, 0.8784, 0.6902, 1.0),
    vec4f(0.9333, 0.9725, 0.8471, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.35, 0.65, 0.9), vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0), vec4f(0.0)), 5u, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let bent_by_the_form = light_warp(look.key, surface.normal, 1.4, 0.03, surface.curvature_tensor,
        surface.view, look.camera_from_world);
    // Reflectance
    let through_the_stone = max((dot(surface.normal, bent_by_the_form.direction) + 0.6)
        / (1.0 + 0.6), 0.0);
    let jade_2 = ramp_oklab(through_the_stone, jade);
    // Reflectance
    let polish = ggx(reflection_of(bent_by_the_form.direction, surface.normal, surface.view), 0.42
        * 0.42, 0.09);
    let polished = mix_colors_screen(jade_2, vec4f(1.0, 0.9569, 0.8627, 1.0), polish);
    let light_from_behind = rim(look.back, surface.normal, surface.view, 0.5, 0.8, 1.0);
    let glowing_edge = mix_colors_screen_2(polished, vec4f(0.1843, 0.5608, 0.7216, 1.0),
        light_from_behind);
    return glowing_edge;
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
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz);
    return shade(surface);
}
