// Exaggerated shape: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, smooth_normal_1_map 3, smooth_normal_2_map 4, smooth_normal_3_map 5, smooth_normal_4_map 6.
// shape-exaggerated.json says what to put there and how to draw.

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
    viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    smooth_normal_1: vec3f,
    smooth_normal_2: vec3f,
    smooth_normal_3: vec3f,
    smooth_normal_4: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var smooth_normal_1_map: texture_2d<f32>;
@group(0) @binding(4) var smooth_normal_2_map: texture_2d<f32>;
@group(0) @binding(5) var smooth_normal_3_map: texture_2d<f32>;
@group(0) @binding(6) var smooth_normal_4_map: texture_2d<f32>;

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

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let whole = round(x);
    let f = x - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * 0.5;
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

fn ramp_oklab(value: f32, ramp: Ramp) -> Color {
    let place = ramp_place(ramp, value);
    return select(select(vec4f(srgb_of_oklab(mix(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb(place.after.xyz), place.t)), 1.0), place.after, place.t >= 1.0), place.before,
        place.t <= 0.0);
}

/// Shading of the detail that a finer normal has beyond a coarser one: -1 where the finer turns
/// from the light, 1 where it turns toward the light. The light is laid at the coarser normal's
/// horizon, so that detail is lit as well as can be, however the light falls.
fn detail_lit(finer: vec3f, coarser: vec3f, light: vec3f, contrast: f32) -> f32 {
    let across = light - dot(light, coarser) * coarser;
    // Straight under the light there is no direction along the surface, and detail fades.
    let toward = across / max(length(across), 0.05);
    return clamp(contrast * dot(finer, toward), -1.0, 1.0);
}

fn exaggerated_four(light: Light, normal: vec3f, contrast: f32, detail: f32, smooth_1: vec3f,
    smooth_2: vec3f, smooth_3: vec3f, smooth_4: vec3f) -> f32 {
    let r = exp2_stable(-detail);
    let n1 = normalize_moderate(smooth_1, normal);
    let n2 = normalize_moderate(smooth_2, n1);
    let n3 = normalize_moderate(smooth_3, n2);
    let n4 = normalize_moderate(smooth_4, n3);
    let coarse = detail_lit(n2, n3, light.direction, contrast) + r
        * (detail_lit(n3, n4, light.direction, contrast) + r * dot(n4, light.direction));
    let sum = detail_lit(normal, n1, light.direction, contrast) + r
        * (detail_lit(n1, n2, light.direction, contrast) + r * coarse);
    return clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r * (1.0 + r * (1.0 + r)))), 0.0, 1.0);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
fn outer_contour(width: f32, normal: vec3f, view: vec3f, viewport: vec2f) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let pixels = width * clamp(viewport.y, 1.0, 1e5) / 1000.0;
    let distance = facing / max(2.0 * footprint_of(facing), 1e-6);
    let near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * near;
}

const from_dusk_to_sun = Ramp(array(vec4f(0.1373, 0.1647, 0.302, 1.0),
    vec4f(0.4196, 0.3725, 0.5255, 1.0), vec4f(0.7882, 0.5804, 0.4353, 1.0),
    vec4f(0.9412, 0.8039, 0.5725, 1.0), vec4f(1.0, 0.9843, 0.902, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0)), array(vec4f(0.05, 0.35, 0.55, 0.75), vec4f(0.98, 0.0, 0.0, 0.0), vec4f(0.0),
    vec4f(0.0)), 5u, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let every_scale_of_detail = exaggerated_four(look.key, surface.normal, 7.0, 0.1,
        surface.smooth_normal_1, surface.smooth_normal_2, surface.smooth_normal_3,
        surface.smooth_normal_4);
    let from_dusk_to_sun_2 = ramp_oklab(every_scale_of_detail, from_dusk_to_sun);
    let ink = outer_contour(3.0, surface.normal, surface.view, look.viewport);
    let inked = mix(from_dusk_to_sun_2, vec4f(0.098, 0.1059, 0.2, 1.0), ink);
    return inked;
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
        (vec4f(textureLoad(smooth_normal_1_map, vec2i(in.clip.xy), 0).xyz, 0.0)
        * view.camera_from_world).xyz, (vec4f(textureLoad(smooth_normal_2_map, vec2i(in.clip.xy),
        0).xyz, 0.0) * view.camera_from_world).xyz,
        (vec4f(textureLoad(smooth_normal_3_map, vec2i(in.clip.xy), 0).xyz, 0.0)
        * view.camera_from_world).xyz, (vec4f(textureLoad(smooth_normal_4_map, vec2i(in.clip.xy),
        0).xyz, 0.0) * view.camera_from_world).xyz);
    return shade(surface);
}
