// Curvature as color: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// mean-curvature.json says what to put there and how to draw.

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
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    kappa: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

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
        if !(i < 7u) {
            break;
        }
        at = select(at, i, places[i / 4u][i % 4u] <= x);
        continuing {
            i = i + 1u;
        }
    }
    let after = min(at + 1u, 6u);
    let place = places[at / 4u][at % 4u];
    let t = clamp(divided(x - place, places[after / 4u][after % 4u] - place), 0.0, 1.0);
    return RampPlace(colors[at], colors[after], t);
}

fn ramp_oklab(value: f32, ramp: Ramp) -> Color {
    let place = ramp_place(ramp, value);
    return select(select(vec4f(srgb_of_oklab(mix(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb(place.after.xyz), place.t)), 1.0), place.after, place.t >= 1.0), place.before,
        place.t <= 0.0);
}

fn reflectance_half_lambert(light: Light, normal: vec3f) -> f32 {
    let half = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half * half, 1.0);
}

const hollow_flat_ridge = Ramp(array(vec4f(0.0588, 0.1294, 0.2706, 1.0),
    vec4f(0.1843, 0.3725, 0.5412, 1.0), vec4f(0.7255, 0.7647, 0.7059, 1.0),
    vec4f(0.9255, 0.8902, 0.7961, 1.0), vec4f(0.8902, 0.749, 0.502, 1.0),
    vec4f(0.7804, 0.4627, 0.1843, 1.0), vec4f(1.0, 0.9529, 0.8627, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.25, 0.44, 0.5), vec4f(0.6, 0.8, 1.0, 0.0), vec4f(0.0), vec4f(0.0)), 7u, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let curvature = surface.kappa;
    // Curvature transition
    let from_hollow_to_ridge = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.8853900817779268 * clamp(curvature * 0.045, -20.0, 20.0))));
    let hollow_flat_ridge_2 = ramp_oklab(from_hollow_to_ridge, hollow_flat_ridge);
    let base = hollow_flat_ridge_2;
    let half_lambert = reflectance_half_lambert(look.key, surface.normal);
    let in_the_dark = 1.0 - half_lambert;
    // Blend
    let shade_2 = clamp(vec4f(base.xyz
        * mix(vec3f(1.0), vec4f(0.42, 0.4, 0.55, 1.0).xyz, in_the_dark), 1.0), vec4f(0.0),
        vec4f(1.0));
    return shade_2;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, object.world_from_normal * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x);
    return shade(surface);
}
