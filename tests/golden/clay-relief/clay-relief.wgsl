// Clay relief: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3, curvature_tensor_map 4.
// clay-relief.json says what to put there and how to draw.

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
    @align(16) sky: Light,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    kappa: f32,
    curvature_tensor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;
@group(0) @binding(4) var curvature_tensor_map: texture_2d<f32>;

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

const PI: f32 = 3.14159265358979323846;
const HALF_PI: f32 = 1.57079632679489661923;
const LOG2_E: f32 = 1.44269504088896340736;
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
fn atan2_positive(y: f32, x: f32) -> f32 {
    let small = min(y, x);
    let large = max(y, x);
    if large <= 0.0 {
        return 0.0;
    }
    let t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    let is_wide = t > 0.41421356;
    let r = select(t, (small - large) / (small + large), is_wide);
    let r2 = r * r;
    let series = r * (1.0 + r2 * (-0.333333333333333333
        + r2 * (0.2 + r2 * (-0.142857142857142857
        + r2 * (0.111111111111111111 + r2 * (-0.0909090909090909091
        + r2 * (0.0769230769230769231 + r2 * (-0.0666666666666666667
            + r2 * 0.0588235294117647059))))))));
    let a = select(series, series + 0.785398163397448310, is_wide);
    return select(a, HALF_PI - a, y > x);
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
fn bounded_vec2(v: vec2f) -> vec2f {
    let bits = bitcast<vec2u>(v);
    let magnitude = bits & vec2u(0x7fffffffu);
    let largest = bitcast<vec2f>((bits & vec2u(0x80000000u)) | vec2u(0x7f7fffffu));
    let numbers = select(vec2f(0.0), largest, magnitude == vec2u(0x7f800000u));
    return select(numbers, v, magnitude < vec2u(0x7f800000u));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
fn angle_of_point(y: f32, x: f32) -> f32 {
    // Coordinates are halved where they are large, so that the sum of both stays finite.
    let p = abs(bounded_vec2(vec2f(x, y)));
    let scaled = select(p, 0.5 * p, max(p.x, p.y) > 1.0);
    let a = atan2_positive(scaled.y, scaled.x);
    let turned = select(a, PI - a, x < 0.0);
    return select(turned, -turned, y < 0.0);
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

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
fn soft_light(a: f32, b: f32) -> f32 {
    if b <= 0.5 {
        return a - (1.0 - 2.0 * b) * a * (1.0 - a);
    }
    let curved = select(sqrt(max(a, 0.0)), ((16.0 * a - 12.0) * a + 4.0) * a, a <= 0.25);
    return a + (2.0 * b - 1.0) * (curved - a);
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
    return vec4f(mix(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, factor), 1.0);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
fn curvature_signed(kappa: f32, slope: f32) -> f32 {
    let a = kappa * slope;
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

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
fn curvature_signed_2(kappa: f32, slope: f32) -> f32 {
    let a = min(kappa, 1e4) * slope;
    let magnitude = min(a, 50.0);
    if magnitude < 0.0625 {
        let a2 = a * a;
        return a * (1.0 - a2 * (0.333333333333333333 - a2
            * (0.133333333333333333 - a2 * 0.0539682539682539683)));
    }
    let z = exp2_stable_2(-2.8853900817779268 * magnitude);
    let t = (1.0 - z) / (1.0 + z);
    return t;
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

/// A tone from 0 to 1 scaled by e^curved where it is dark and by e^-curved where it is light; the
/// tone `turning` stays.
fn radiance_scaled(tone: f32, curved: f32, turning: f32) -> f32 {
    let e = exp2_stable(curved * LOG2_E);
    let dark = turning * (1.0 - tone);
    let light = tone * (1.0 - turning);
    return tone * (e * dark + light) / max(dark + e * light, 1e-20);
}

/// Scale by curvature
///
/// Makes a tone lighter where the surface bulges and darker where it is hollow, and the other way
/// around where it is very light: any shading shows its shape more plainly.
fn radiance_scaling(tone: f32, kappa: f32, amount: f32, slope: f32, turning: f32) -> f32 {
    let curved = amount * curvature_signed(kappa, slope);
    return min(select(radiance_scaled(tone, curved, turning), tone, curved == 0.0), 1.0);
}

/// Relief
///
/// What the surface does at a place, in two numbers for a Tone map or for ramps: its shape (pit,
/// valley, saddle, ridge or bump) and how strongly it has it.
fn relief(tensor: vec3f, slope: f32) -> Relief {
    let k = principal_curvatures(tensor);
    let around = angle_of_point(k.x + k.y, k.x - k.y);
    let curvedness = sqrt(0.5 * dot(k, k));
    let strength = curvature_signed_2(curvedness, slope);
    return Relief(0.5 + around / PI, strength, k.x, k.y);
}

struct Relief {
    /// The shape index: 0 a pit, 0.25 a valley, 0.5 a saddle or flat, 0.75 a ridge, 1 a bump.
    shape: f32,
    /// From 0 where it is flat to 1.
    strength: f32,
    /// The greatest curvature of all directions, in 1/viewport-height.
    greatest: f32,
    /// The least curvature of all directions, in 1/viewport-height.
    least: f32,
}

const terracotta = Ramp(array(vec4f(0.2353, 0.102, 0.1098, 1.0), vec4f(0.5412, 0.251, 0.1882, 1.0),
    vec4f(0.8118, 0.498, 0.3412, 1.0), vec4f(0.949, 0.7412, 0.5725, 1.0),
    vec4f(0.9843, 0.8627, 0.7333, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.3, 0.62, 0.9), vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0), vec4f(0.0)), 5u, 0u);
const pits_to_bumps = Ramp(array(vec4f(0.2941, 0.2275, 0.3216, 1.0),
    vec4f(0.4784, 0.2902, 0.2902, 1.0), vec4f(0.7529, 0.502, 0.3765, 1.0),
    vec4f(0.9412, 0.7529, 0.5804, 1.0), vec4f(1.0, 0.9412, 0.8471, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0)), array(vec4f(0.0, 0.3, 0.5, 0.75), vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0),
    vec4f(0.0)), 5u, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let matt_clay = reflectance_half_lambert(look.key, surface.normal);
    let worked_by_curvature = radiance_scaling(matt_clay, surface.kappa, 1.3, 0.03, 0.9);
    let terracotta_2 = ramp_oklab(worked_by_curvature, terracotta);
    let what_the_surface_does = relief(surface.curvature_tensor, 0.025);
    let pits_to_bumps_2 = ramp_oklab(what_the_surface_does.shape, pits_to_bumps);
    let slip_in_the_hollows = vec4f(mix(terracotta_2.xyz,
        vec3f(soft_light(terracotta_2.x, pits_to_bumps_2.x),
        soft_light(terracotta_2.y, pits_to_bumps_2.y),
        soft_light(terracotta_2.z, pits_to_bumps_2.z)),
        clamp(what_the_surface_does.strength, 0.0, 1.0)), 1.0);
    let sky_along_the_edge = rim(look.sky, surface.normal, surface.view, 0.4, 0.9, 1.0);
    let cool_edge = mix_colors_screen(slip_in_the_hollows, vec4f(0.3725, 0.498, 0.6588, 1.0),
        sky_along_the_edge);
    return cool_edge;
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
        textureLoad(curvature_map, vec2i(in.clip.xy), 0).x,
        textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz);
    return shade(surface);
}
