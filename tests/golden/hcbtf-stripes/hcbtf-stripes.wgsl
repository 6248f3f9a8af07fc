// Stripes: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, image_1 3, image_1_sampler 4.
// hcbtf-stripes.json says what to put there and how to draw.

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
    /// The alpha cutoff of the material, 0 for none.
    cutoff: f32,
}

/// What is known before the fragment.
struct Look {
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    uv: vec2f,
    tangent: vec3f,
    bitangent: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var image_1: texture_2d_array<f32>;
@group(0) @binding(4) var image_1_sampler: sampler;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

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

const PI: f32 = 3.14159265358979323846;
const HALF_PI: f32 = 1.57079632679489661923;
/// Whether x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// x, or `otherwise` where x is NaN or infinite.
fn finite_or(x: f32, otherwise: f32) -> f32 {
    return select(otherwise, x, is_finite(x));
}

/// Each component as it is, or 0 where it is NaN or infinite.
fn finite_vec3(v: vec3f) -> vec3f {
    return vec3f(finite_or(v.x, 0.0), finite_or(v.y, 0.0), finite_or(v.z, 0.0));
}

/// Each component as it is, or 0 where it is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    return vec4f(finite_vec3(v.xyz), finite_or(v.w, 0.0));
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a NaN. Scaled by the
/// largest component first, so that neither tiny nor huge vectors under- or overflow.
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !(largest > 1e-30 && largest < 1e30) {
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
    let series = r * (1.0 + r2 * (-0.333333333333333333 + r2 * (0.2 + r2 * (-0.142857142857142857 + r2 * (0.111111111111111111 + r2 * (-0.0909090909090909091
        + r2 * (0.0769230769230769231 + r2 * (-0.0666666666666666667 + r2 * 0.0588235294117647059))))))));
    let a = select(series, series + 0.785398163397448310, is_wide);
    return select(a, HALF_PI - a, y > x);
}

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// [`bounded`], component by component.
fn bounded_vec2(v: vec2f) -> vec2f {
    return vec2f(bounded(v.x), bounded(v.y));
}

/// [`bounded`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    return vec3f(bounded(v.x), bounded(v.y), bounded(v.z));
}

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    return vec4f(bounded(v.x), bounded(v.y), bounded(v.z), bounded(v.w));
}

/// The length of v, also where its square would over- or underflow.
fn length_of(v: vec3f) -> f32 {
    let w = bounded_vec3(v);
    let largest = max(max(abs(w.x), abs(w.y)), abs(w.z));
    if largest < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(largest * length(w / largest));
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
fn angle_of_point(y: f32, x: f32) -> f32 {
    // Halved where they are large, so that the sum of both stays finite.
    let p = abs(bounded_vec2(vec2f(x, y)));
    let scaled = select(p, 0.5 * p, max(p.x, p.y) > 1.0);
    let a = atan2_positive(scaled.y, scaled.x);
    let turned = select(a, PI - a, x < 0.0);
    return select(turned, -turned, y < 0.0);
}

/// Straight to premultiplied.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Premultiplied to straight. Where nothing covers the pixel the colour is kept as it is, so that light added over
/// transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// Display colours decoded to linear light by the sRGB curve (IEC 61966-2-1); alpha stays.
fn linear_from_display(color: Color) -> Color {
    let c = max(color.xyz, vec3f(0.0));
    let low = c / 12.92;
    let high = pow((c + 0.055) / 1.055, vec3f(2.4));
    return vec4f(select(high, low, c <= vec3f(0.04045)), color.w);
}

/// Unit tangent, bitangent and normal as columns: a mesh's tangent and bitangent stood upright on a normal (Gram and
/// Schmidt), with the handedness of the mesh. Where the tangent is missing or lies along the normal, another one takes
/// its place.
fn world_from_tangent(tangent: vec3f, bitangent: vec3f, normal: vec3f) -> mat3x3f {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let t = normalize_or(tangent, vec3f(0.0));
    let leaning = t - dot(t, n) * n;
    // Leaning by less than this the tangent has no direction beside the normal but rounding's.
    let is_usable = dot(leaning, leaning) > 1e-8;
    let rough = normalize_or(select(any_orthogonal(n), leaning, is_usable), vec3f(1.0, 0.0, 0.0));
    // Once more: where tangent and normal are close, what is left of the one still leans along the other.
    let upright = normalize_or(rough - dot(rough, n) * n, vec3f(1.0, 0.0, 0.0));
    let b = cross(n, upright);
    return mat3x3f(upright, select(b, -b, dot(b, bitangent) < 0.0), n);
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// How far x changes over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// 0 below the edge and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = bounded(x - edge);
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// How an HCBTF is divided, as its texture tells.
struct HcbtfGrid {
    /// Texels of the tile.
    size: vec2i,
    /// Rings and steps of the lights.
    light: vec2i,
    /// Rings and steps of the views.
    view: vec2i,
    /// Whether smaller levels are there.
    has_levels: bool,
    /// Whether colours are to be decoded to linear light after the blend.
    is_decoded: bool,
}

/// A direction among those of a grid: the two rings and the two steps around it, with the weight of the second of each.
struct HcbtfPlace {
    theta: vec2i,
    phi: vec2i,
    weight: vec2f,
}

/// The four views around one, with their weights.
struct HcbtfViews {
    layer: vec4i,
    weight: vec4f,
}

fn hcbtf_grid(sheet: texture_2d_array<f32>) -> HcbtfGrid {
    let last = i32(textureNumLayers(sheet)) - 1;
    let first = vec4i(round(255.0 * textureLoad(sheet, vec2i(0, 0), last, 0)));
    let second = vec4i(round(255.0 * textureLoad(sheet, vec2i(1, 0), last, 0)));
    let size = vec2i(first.x + 256 * (first.z % 16), first.y + 256 * (first.z / 16));
    return HcbtfGrid(size, second.xy, second.zw, first.w % 2 == 1, first.w / 2 % 2 == 1);
}

/// A world-space direction beside a surface: x along u, y along v, z along the normal; unit.
fn hcbtf_local(direction: vec3f, frame: mat3x3f) -> vec3f {
    return normalize_or(normalize_or(direction, frame[2]) * frame, vec3f(0.0, 0.0, 1.0));
}

/// Rings and steps as numbers between them: theta in [0, rings - 1], phi in [0, steps). Below the horizon counts as on
/// it. Straight up there is no phi, and 0 is taken; all samples of the first ring are the same.
fn hcbtf_place(local: vec3f, directions: vec2i) -> vec2f {
    let across = length_of(vec3f(local.xy, 0.0));
    // The GPU's own atan2 may be off by a thousandth.
    let theta = angle_of_point(across, max(local.z, 0.0));
    let around = select(0.0, angle_of_point(local.x, local.y), across > 1e-12);
    let steps = f32(directions.y);
    let phi = around * (0.159154943091895336 * steps);
    let turned = select(phi, phi + steps, phi < 0.0);
    let rings = f32(directions.x - 1);
    // Rounding may reach the last step from below; that is the first.
    return vec2f(clamp(theta * 0.636619772367581343 * rings, 0.0, rings), select(turned, 0.0, turned >= steps));
}

/// The samples around a place and how much the second of each pair counts.
fn hcbtf_around(place: vec2f, directions: vec2i) -> HcbtfPlace {
    let low = vec2i(floor(place));
    let theta = vec2i(low.x, min(low.x + 1, directions.x - 1));
    let phi = vec2i(low.y, (low.y + 1) % directions.y);
    return HcbtfPlace(theta, phi, place - floor(place));
}

fn hcbtf_views(place: vec2f, directions: vec2i) -> HcbtfViews {
    let around = hcbtf_around(place, directions);
    let layer = vec4i(around.theta.x, around.theta.y, around.theta.x, around.theta.y) * directions.y
        + vec4i(around.phi.x, around.phi.x, around.phi.y, around.phi.y);
    let w = around.weight;
    let weight = vec4f((1.0 - w.x) * (1.0 - w.y), w.x * (1.0 - w.y), (1.0 - w.x) * w.y, w.x * w.y);
    return HcbtfViews(layer, weight);
}

/// Where the block of a texel's lights begins, in texels of the layer, for a level that begins at `origin`.
fn hcbtf_block(texel: vec2i, light: vec2i, origin: vec2i) -> vec2i {
    return origin + texel * vec2i(light.x, light.y + 2);
}

/// Adds a straight colour with a weight, so that what is transparent does not tint.
fn hcbtf_add(sum: vec4f, color: vec4f, weight: f32) -> vec4f {
    return sum + vec4f(color.xyz * color.w, color.w) * weight;
}

/// A straight colour from such a sum; transparent black where nothing was painted.
fn hcbtf_straight(sum: vec4f) -> vec4f {
    return select(vec4f(0.0), vec4f(clamp(sum.xyz / max(sum.w, 1e-20), vec3f(0.0), vec3f(1.0)), min(sum.w, 1.0)), sum.w > 0.0);
}

/// Four lights of one view at one texel, loaded and blended; premultiplied.
fn hcbtf_lights(sheet: texture_2d_array<f32>, block: vec2i, layer: i32, light: HcbtfPlace) -> vec4f {
    let w = light.weight;
    var sum = vec4f(0.0);
    sum = hcbtf_add(sum, textureLoad(sheet, block + vec2i(light.theta.x, light.phi.x + 1), layer, 0), (1.0 - w.x) * (1.0 - w.y));
    sum = hcbtf_add(sum, textureLoad(sheet, block + vec2i(light.theta.y, light.phi.x + 1), layer, 0), w.x * (1.0 - w.y));
    sum = hcbtf_add(sum, textureLoad(sheet, block + vec2i(light.theta.x, light.phi.y + 1), layer, 0), (1.0 - w.x) * w.y);
    return hcbtf_add(sum, textureLoad(sheet, block + vec2i(light.theta.y, light.phi.y + 1), layer, 0), w.x * w.y);
}

/// All sixteen samples around a light and a view at one texel; premultiplied.
fn hcbtf_sixteen(sheet: texture_2d_array<f32>, block: vec2i, light: HcbtfPlace, views: HcbtfViews) -> vec4f {
    return views.weight.x * hcbtf_lights(sheet, block, views.layer.x, light)
        + views.weight.y * hcbtf_lights(sheet, block, views.layer.y, light)
        + views.weight.z * hcbtf_lights(sheet, block, views.layer.z, light)
        + views.weight.w * hcbtf_lights(sheet, block, views.layer.w, light);
}

/// The four texels around a place of a level, with their weights, wrapped around the tile.
struct HcbtfTexels {
    /// Left, top, right, bottom.
    at: vec4i,
    weight: vec2f,
    /// Where the level begins, in texels of the layer.
    origin: vec2i,
}

/// The blocks of four texels.
struct HcbtfBlocks {
    left_top: vec2i,
    right_top: vec2i,
    left_bottom: vec2i,
    right_bottom: vec2i,
}

fn hcbtf_blocks(texels: HcbtfTexels, light: vec2i) -> HcbtfBlocks {
    let at = texels.at;
    return HcbtfBlocks(
        hcbtf_block(at.xy, light, texels.origin),
        hcbtf_block(at.zy, light, texels.origin),
        hcbtf_block(at.xw, light, texels.origin),
        hcbtf_block(at.zw, light, texels.origin),
    );
}

fn hcbtf_texels(uv: vec2f, grid: HcbtfGrid, level: i32) -> HcbtfTexels {
    var size = grid.size;
    var origin = vec2i(0);
    for (var i = 0; i < level; i++) {
        // The first smaller level stands beside the tile, the next ones below each other.
        origin = vec2i(grid.size.x * grid.light.x, select(origin.y + size.y * (grid.light.y + 2), 0, i == 0));
        size = max(size / 2, vec2i(1));
    }
    let p = bounded_vec2(vec2f(uv.x, -uv.y));
    let place = (p - floor(p)) * vec2f(size) - 0.5;
    let low = vec2i(floor(place));
    let first = (low + size) % size;
    return HcbtfTexels(vec4i(first, (first + 1) % size), place - floor(place), origin);
}

/// All sixteen samples, each bilinear between the texels of one level; premultiplied.
fn hcbtf_sixteen_at(sheet: texture_2d_array<f32>, uv: vec2f, grid: HcbtfGrid, level: i32, light: HcbtfPlace, views: HcbtfViews) -> vec4f {
    let texels = hcbtf_texels(uv, grid, level);
    let w = texels.weight;
    let blocks = hcbtf_blocks(texels, grid.light);
    return (1.0 - w.x) * (1.0 - w.y) * hcbtf_sixteen(sheet, blocks.left_top, light, views)
        + w.x * (1.0 - w.y) * hcbtf_sixteen(sheet, blocks.right_top, light, views)
        + (1.0 - w.x) * w.y * hcbtf_sixteen(sheet, blocks.left_bottom, light, views)
        + w.x * w.y * hcbtf_sixteen(sheet, blocks.right_bottom, light, views);
}

/// How many times smaller, as a power of two, the tile is seen than it is painted. Call it in uniform control flow.
fn hcbtf_level(uv: vec2f, grid: HcbtfGrid) -> f32 {
    let dx = bounded_vec2(dpdx(uv) * vec2f(grid.size));
    let dy = bounded_vec2(dpdy(uv) * vec2f(grid.size));
    let widest = clamp(max(dot(dx, dx), dot(dy, dy)), 1.0, 1e9);
    let side = max(grid.size.x, grid.size.y);
    let last = floor(log2(f32(side)) + 1e-4);
    return select(0.0, min(0.5 * log2(widest), last), grid.has_levels);
}

/// How much of a light just above the horizon arrives: all of it, and nothing below, with an edge as wide as a pixel.
/// Call it in uniform control flow.
fn hcbtf_horizon(light: vec3f, frame: mat3x3f) -> f32 {
    let height = dot(normalize_or(light, frame[2]), frame[2]);
    return step_filtered(height, 0.0, footprint_of(height));
}

/// The colour of a straight blend: below the horizon replaced, decoded where the look is in linear light.
fn hcbtf_finished(lit: vec4f, above: f32, unlit: vec4f, grid: HcbtfGrid) -> vec4f {
    let painted = select(lit, linear_from_display(lit), grid.is_decoded);
    return mix(bounded_vec4(unlit), painted, above);
}

/// HCBTF
///
/// A hand-painted surface that changes with the light and with the eye: for each direction of both it shows what was
/// painted for them, blended between the nearest paintings.
fn hcbtf_lookup_smooth(
    sheet: texture_2d_array<f32>,
    sheet_sampler: sampler,
    light: Light,
    uv: vec2f,
    scale: vec2f,
    unlit: Color,
    normal: vec3f,
    view: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
) -> Color {
    let grid = hcbtf_grid(sheet);
    let frame = world_from_tangent(tangent, bitangent, normal);
    let place = bounded_vec2(uv * scale);
    let level = hcbtf_level(place, grid);
    let above = hcbtf_horizon(light.direction, frame);
    let lights = hcbtf_around(hcbtf_place(hcbtf_local(light.direction, frame), grid.light), grid.light);
    let views = hcbtf_views(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    let finer = i32(level);
    var sum = hcbtf_sixteen_at(sheet, place, grid, finer, lights, views);
    if level > f32(finer) {
        sum = mix(sum, hcbtf_sixteen_at(sheet, place, grid, finer + 1, lights, views), level - f32(finer));
    }
    return hcbtf_finished(hcbtf_straight(sum), above, unlit, grid);
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let painting = hcbtf_lookup_smooth(image_1, image_1_sampler, look.key, surface.uv, vec2f(6.0), vec4f(0.07, 0.04, 0.11, 1.0), surface.normal, surface.view, surface.tangent, surface.bitangent);
    let output_2 = output(premultiplied(painting));
    return output_2;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) tangent: vec4f,
    @location(3) uv: vec2f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) tangent: vec4f,
    @location(3) uv: vec2f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    var out: Varyings;
    out.clip = view.clip_from_world * world;
    out.position = world.xyz;
    out.normal = object.world_from_normal * vertex.normal;
    out.tangent = vec4f((object.world_from_object * vec4f(vertex.tangent.xyz, 0.0)).xyz, select(vertex.tangent.w, -vertex.tangent.w, determinant(object.world_from_normal) < 0.0));
    out.uv = vertex.uv;
    return out;
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_or(in.normal, vec3f(0.0, 0.0, 1.0));
    let normal = select(-facing, facing, is_front);
    var surface: Surface;
    surface.normal = normal;
    surface.view = normalize_or(view.eye.xyz - view.eye.w * in.position, normalize_or(view.eye.xyz, vec3f(0.0, 0.0, 1.0)));
    surface.uv = in.uv;
    surface.tangent = normalize_or(in.tangent.xyz - normal * dot(normal, in.tangent.xyz), in.tangent.xyz);
    surface.bitangent = cross(normal, normalize_or(in.tangent.xyz - normal * dot(normal, in.tangent.xyz), in.tangent.xyz)) * in.tangent.w;
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
