// Long shadows: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, shadow_map 3, shadow_map_behind 4.
// look.rs says what to put there.

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
    sun_source: vec4f,
    object_id: f32,
    sun_shadow_map: vec4f,
    @align(16) sun: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    position: vec3f,
    pixel_across: vec3f,
    pixel_down: vec3f,
    normal_across: vec3f,
    normal_down: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var shadow_map: ShadowMaps;
@group(0) @binding(4) var shadow_map_behind: ShadowMaps;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// What lights see first, a layer for each, as `shaders/lib/shadow_map.wgsl` reads it.
alias ShadowMaps = texture_2d_array<f32>;

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

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
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
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// [`mixed`], component by component.
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let d = bounded_vec4(b - a);
    return bounded_vec4(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// A factor as it is, or kept within 0 and 1 when `clamped`.
fn factor_of(x: f32, clamped: bool) -> f32 {
    return select(bounded(x), clamp(bounded(x), 0.0, 1.0), clamped);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    var colors = ramp.colors;
    var places = ramp.places;
    var i_2 = 1u;
    var at = 0u;
    loop {
        if !(i_2 < 3u) {
            break;
        }
        at = select(at, i_2, places[0u][i_2 % 4u] <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let place = places[0u][at % 4u];
    if (at + 1u >= 3u) | (x <= place) {
        return colors[at];
    }
    let after = at + 1u;
    let span = places[0u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    return mix(colors[at], colors[after], t);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at_2(ramp: Ramp, x: f32, w: f32) -> Color {
    var colors = ramp.colors;
    var places = ramp.places;
    var i_2 = 1u;
    var at = 0u;
    loop {
        if !(i_2 < 4u) {
            break;
        }
        at = select(at, i_2, places[0u][i_2 % 4u] <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let place = places[0u][at % 4u];
    if (at + 1u >= 4u) | (x <= place) {
        return colors[at];
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    return mix(colors[at], colors[after], t);
}

/// A share (an opacity, a mask) clamped to [0, 1]: beyond, a mix would go past what it mixes.
fn unit_share(share: f32) -> f32 {
    return clamp(share, 0.0, 1.0);
}

/// `color` with its alpha clamped to [0, 1].
fn with_unit_alpha(color: Color) -> Color {
    return vec4f(color.xyz, unit_share(color.w));
}

/// Premultiplied RGBA of a straight color.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// Mix colors
///
/// Lays one color on another as paint programs do. For a stack of shading layers take Blend, which
/// knows tones and transparency.
fn mix_colors_normal(a: Color, b: Color, factor: f32) -> Color {
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), factor_of(factor, true));
}

/// A ray and what limits it.
struct Ray {
    origin: vec3f,
    direction: vec3f,
    /// 1 over each component of the direction.
    inverse: vec3f,
    /// The end of the ray, in lengths of the direction.
    end: f32,
    /// What a rounding may leave between the origin and a surface that it lies on.
    noise: f32,
    /// Up to this far away planes of triangles that are seen from behind are no blockers,
    under: f32,
    /// if the ray meets them within this, in lengths of its direction.
    under_end: f32,
}

/// The triangle that a ray leaves.
struct Facet {
    /// From the surface to where rays start, in the space of the object's triangles.
    lift: vec3f,
    /// Number of the triangle in the object's tree, or -1.
    triangle: i32,
}

/// No triangle: for rays that meet other objects alone.
const NO_FACET = Facet(vec3f(0.0), -1);
/// 1/x for numbers that may be 0, within what f32 holds.
fn inverse_of(v: vec3f) -> vec3f {
    let least = vec3f(1e-20);
    return 1.0 / select(v, least, abs(v) < least);
}

/// A surface as its shadows see it.
struct Receiver {
    position: vec3f,
    /// From a pixel's place to those of its neighbors on the right and below.
    across: vec3f,
    down: vec3f,
    /// The light's place and 1, or the direction toward it and 0.
    source: vec4f,
    /// Radius of the light: in scene units, or of a directional one at a distance of 1.
    size: f32,
    /// The light's `casters`.
    casters: f32,
    /// Number of the object.
    object: f32,
    facet: Facet,
}

/// The ray from a place of a pixel, 0,0 its middle and 0.5,0.5 its lower right corner, toward a
/// place of the light within a disk of radius 1.
fn ray_from(receiver: Receiver, at: vec2f, of_light: vec2f) -> Ray {
    let moved = at.x * receiver.across + at.y * receiver.down;
    let origin = receiver.position + moved;
    let source = receiver.source;
    let toward = source.xyz - source.w * origin;
    let length = sqrt(dot(toward, toward));
    // Two directions across the way to the light, on the axis that is farthest from it.
    let axis = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), abs(toward.x) > 0.6 * length);
    let side = normalize_or(cross(toward, axis), vec3f(0.0, 0.0, 1.0));
    let up = normalize_or(cross(side, toward), vec3f(0.0, 1.0, 0.0));
    let aimed = toward + receiver.size * (of_light.x * side + of_light.y * up);
    let direction = normalize_or(aimed, vec3f(0.0, 0.0, 1.0));
    // A directional light has no end; a lamp is no blocker of itself.
    let end = select(1e30, 0.99999 * sqrt(dot(aimed, aimed)), source.w > 0.5);
    let under = sqrt(dot(moved, moved));
    return Ray(origin, direction, inverse_of(direction), end, 0.0, under, 2.0 * under);
}

/// The share of a pixel whose smooth normal turns away from the light; `normal_across` and
/// `normal_down` are how it changes to the pixel's neighbors.
fn turned_away(
    receiver: Receiver,
    normal: vec3f,
    normal_across: vec3f,
    normal_down: vec3f,
) -> f32 {
    let toward = ray_from(receiver, vec2f(0.0), vec2f(0.0)).direction;
    let facing = dot(normal, toward);
    let width = abs(dot(normal_across, toward)) + abs(dot(normal_down, toward));
    return clamp(0.5 - facing / max(width, 1e-6), 0.0, 1.0);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// What the grid of a rasterizer may move corners of triangles by, along each side of a texel.
const MAP_SNAP: f32 = 0.0078125;
/// Share of a place that roundings may leave.
const MAP_NOISE: f32 = 2e-6;
/// Greatest change of nearness from texel to texel, in texels, that a plane is followed by.
const STEEP: f32 = 4.0;
/// Most that a surface which faces the light bends from a texel to its neighbor, in texels a texel.
const MOST_BEND: f32 = 2.0;
/// Change of slope within a texel, of what is smaller: in texels a texel, and as a share of slopes.
const ROUGH: f32 = 0.5;
/// Thickness of what keeps the light from a facet that is turned away from it although the smooth
/// normal is not, in texels.
const THICK: f32 = 4.0;
/// Most texels to which the course of an edge is followed, to either side.
const LONGEST_RUN = 12;
/// A pixel's surface as a light's map sees it.
struct MappedSurface {
    /// The place, in texels from the map's upper left corner.
    at: vec2f,
    /// Nearness to the light, and its change from texel to texel to the right and below.
    nearness: f32,
    slope: vec2f,
    /// The side of a texel, as a change of nearness.
    unit: f32,
    /// What roundings may leave of a nearness.
    noise: f32,
    /// From the pixel's place to those of its neighbors on the right and below, in texels.
    across: vec2f,
    down: vec2f,
    /// Layer of the map, below 0 where the light has none.
    layer: i32,
    /// Number of the object, from 1 on.
    object: f32,
}

/// The surface of a pixel, as `Receiver` of `shadows.wgsl` describes it, in a light's map: the
/// middle of the map, half of its side and its first layer.
fn mapped_surface(
    maps: ShadowMaps,
    map: vec4f,
    source: vec4f,
    position: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
) -> MappedSurface {
    let side = f32(textureDimensions(maps).x);
    let normal = cross(across, down);
    let size = sqrt(dot(normal, normal));
    var surface: MappedSurface;
    surface.layer = i32(map.w);
    surface.object = object + 1.0;
    var place: vec2f;
    var steps: array<vec2f, 2>;
    // The part of the normal along the map, upward.
    var aside: vec2f;
    if source.w < 0.5 {
        let axes = map_axes(source.xyz);
        place = (axes * position).xy;
        surface.nearness = dot(source.xyz, position);
        surface.noise = MAP_NOISE * (dot(abs(source.xyz), abs(position)) + abs(map.z));
        let turned = axes * normal;
        aside = turned.xy;
        surface.slope = -turned.xy / away_from_zero(turned.z, 1e-3 * size);
        steps = array((axes * across).xy, (axes * down).xy);
    } else {
        let way = position - source.xyz;
        let face = map_face(way);
        let axis = face >> 1u;
        let seen = turned_to(way, axis);
        let side_of_axis = select(1.0, -1.0, (face & 1) == 1);
        let depth = max(abs(seen.z), 1e-20);
        place = seen.xy / depth;
        surface.layer += face;
        surface.nearness = 1.0 / depth;
        let far = abs(position) + abs(source.xyz);
        let rounded = MAP_NOISE * max(max(far.x, far.y), far.z);
        surface.noise = (rounded / depth + MAP_NOISE) * surface.nearness;
        let turned = turned_to(normal, axis);
        let least = 1e-3 * size * sqrt(dot(way, way));
        surface.slope = turned.xy / away_from_zero(dot(normal, way), least);
        let a = turned_to(across, axis);
        let b = turned_to(down, axis);
        aside = turned.xy - side_of_axis * turned.z * place;
        steps = array((a.xy - side_of_axis * a.z * place) / depth,
            (b.xy - side_of_axis * b.z * place) / depth);
    }
    // Rows count downward.
    let texels = vec2f(0.5, -0.5) * side / map.z;
    surface.at = 0.5 * side + (place - map.xy) * texels;
    surface.across = steps[0] * texels;
    surface.down = steps[1] * texels;
    let slope = surface.slope / texels;
    surface.unit = 2.0 * map.z / side * select(1.0, surface.nearness, source.w > 0.5);
    let steepness = sqrt(dot(slope, slope)) / surface.unit;
    surface.slope = select(vec2f(0.0), slope * min(STEEP / max(steepness, 1e-20), 1.0), size > 0.0);
    // Along a surface that the light hardly meets its own next texels are far nearer or farther: it
    // is asked for a texel before its front, which looks at the viewer as `normal` does not.
    let before = clamp(steepness / STEEP - 0.5, 0.0, 1.0) / max(sqrt(dot(aside, aside)), 1e-30);
    surface.at += select(vec2f(0.0), before * aside * vec2f(-1.0, 1.0), size > 0.0);
    return surface;
}

/// The axes of a directional light's map, as rows: to the right, up, and toward the light (Duff et
/// al. 2017).
fn map_axes(toward: vec3f) -> mat3x3f {
    // The place of the turn is one where no light is likely to stand.
    let side = select(-1.0, 1.0, toward.z > -0.4142);
    let a = -1.0 / (side + toward.z);
    let b = toward.x * toward.y * a;
    return transpose(mat3x3f(
        vec3f(1.0 + side * toward.x * toward.x * a, side * b, -side * toward.x),
        vec3f(b, side + toward.y * toward.y * a, -toward.y),
        toward,
    ));
}

/// The face of a cube in which a way from its middle lies: 0 for +x, 1 for -x, then y and z.
fn map_face(way: vec3f) -> i32 {
    let size = abs(way);
    if size.x >= size.y && size.x >= size.z {
        return select(0, 1, way.x < 0.0);
    }
    if size.y >= size.z {
        return select(2, 3, way.y < 0.0);
    }
    return select(4, 5, way.z < 0.0);
}

/// A vector with the axis of a face last.
fn turned_to(v: vec3f, axis: i32) -> vec3f {
    return select(select(v, v.zxy, axis == 1), v.yzx, axis == 0);
}

/// x, or what is `least` away from 0 on the same side.
fn away_from_zero(x: f32, least: f32) -> f32 {
    let size = max(max(abs(x), least), 1e-30);
    return select(size, -size, x < 0.0);
}

/// A texel of what may keep the light from a surface, the surface's own object alone if
/// `by_itself`, else others; 0 where nothing does.
fn blocker_texel(
    maps: ShadowMaps,
    behind: ShadowMaps,
    surface: MappedSurface,
    texel: vec2i,
    by_itself: bool,
) -> vec4f {
    let size = vec2i(textureDimensions(maps));
    if surface.layer < 0 || any(texel < vec2i(0)) || any(texel >= size) {
        return vec4f(0.0);
    }
    let first = textureLoad(maps, texel, surface.layer, 0);
    if first.y < 0.5 || (first.y == surface.object) == by_itself {
        return first;
    }
    let second = textureLoad(behind, texel, surface.layer, 0);
    let is_wanted = (second.y == surface.object) == by_itself;
    return select(vec4f(0.0), second, is_wanted);
}

/// True if what a texel holds stands between a surface and the light.
fn stands_before(surface: MappedSurface, texel: vec2i, found: vec4f) -> bool {
    let offset = vec2f(texel) + 0.5 - surface.at;
    let at_middle = found.x - surface.nearness - dot(surface.slope, offset);
    // A surface that bends is no blocker of its next texels.
    let near = clamp(offset, vec2f(-1.0), vec2f(1.0));
    let at_place = at_middle - dot(found.zw - surface.slope, near);
    let slopes = abs(found.zw) + abs(surface.slope);
    let rounded = surface.noise + MAP_SNAP * (slopes.x + slopes.y);
    // Nor is one that is rough, or bends to and fro, within a texel.
    let most = MOST_BEND * surface.unit + abs(surface.slope);
    let bend = min(abs(found.zw - surface.slope), most)
        + ROUGH * (surface.unit + abs(surface.slope));
    // With several samples a pixel, its middle may lie beside the triangle, on the plane of that.
    let beside = min(0.5 * (abs(surface.across) + abs(surface.down)), vec2f(1.0));
    let explained = rounded + dot(bend, max(abs(near), beside));
    return found.y > 0.5 && min(at_middle, at_place) > explained;
}

/// True if the light is kept from a surface at a texel.
fn is_dark_texel(
    maps: ShadowMaps,
    behind: ShadowMaps,
    surface: MappedSurface,
    texel: vec2i,
    by_itself: bool,
) -> bool {
    let found = blocker_texel(maps, behind, surface, texel, by_itself);
    return stands_before(surface, texel, found);
}

/// The course of an edge between texels beside a place.
struct EdgeCourse {
    /// From the texels' border to the edge, outward from the place's own texel.
    shift: f32,
    /// Its change from texel to texel along the border.
    slope: f32,
    /// Number of texels along which the border runs straight.
    length: f32,
}

/// An end of a straight border, in steps of `along` from a texel that is dark or not, next to one
/// beyond `outward` that is not alike: the number of steps, and half a texel outward or inward, to
/// where the border turns by a single texel as those of straight edges do; 0 for a corner.
fn border_end(
    maps: ShadowMaps,
    behind: ShadowMaps,
    surface: MappedSurface,
    texel: vec2i,
    along: vec2i,
    outward: vec2i,
    by_itself: bool,
    is_dark: bool,
) -> vec2f {
    for (var step = 1; step <= LONGEST_RUN; step++) {
        let next = texel + step * along;
        // The texels within the border and beyond it, then two aside: beyond it where both are
        // alike, else within. One call in a loop: compilers copy functions to where they are
        // called, and some take minutes over six.
        var inner = false;
        var outer = false;
        var goes_on = false;
        for (var i = 0; i < 4; i++) {
            let aside = next + select(-1, 2, inner) * outward - select(0, 1, i == 3) * along;
            let place = select(next + i * outward, aside, i >= 2);
            let is_alike = is_dark_texel(maps, behind, surface, place, by_itself) == is_dark;
            if i == 0 {
                inner = is_alike;
            } else if i == 1 {
                outer = is_alike;
                // Straight on, or texels that touch at their corners alone.
                if inner != outer {
                    break;
                }
            } else if i == 2 {
                if is_alike != inner {
                    break;
                }
            } else {
                goes_on = is_alike != inner;
            }
        }
        if inner && !outer {
            continue;
        }
        if outer && !inner {
            return vec2f(f32(step), 0.0);
        }
        // It turns outward or inward.
        return vec2f(f32(step), select(select(-0.5, 0.5, inner), 0.0, goes_on));
    }
    return vec2f(f32(LONGEST_RUN), 0.0);
}

/// The course of the edge beside a texel's border: straight from where the border turns on one side
/// to where it turns on the other, and through its middle (Reshetov 2009; Bondarev 2014 for maps of
/// shadows). `share` is the place along the border, within the texel.
fn edge_course(before: vec2f, after: vec2f, share: f32) -> EdgeCourse {
    let length = before.x + after.x - 1.0;
    let along = 2.0 * (before.x - 1.0 + share) / length - 1.0;
    let end = select(before.y, after.y, along > 0.0);
    return EdgeCourse(end * abs(along), 2.0 * abs(end) / length, length);
}

/// The share of a light that is kept from a pixel, by edges through the texels about it, from 0 to
/// 1.
fn shadow_of_edges(
    maps: ShadowMaps,
    behind: ShadowMaps,
    surface: MappedSurface,
    by_itself: bool,
) -> f32 {
    let texel = vec2i(floor(surface.at));
    let within = surface.at - vec2f(texel);
    let is_dark = is_dark_texel(maps, behind, surface, texel, by_itself);
    let pixel = abs(surface.across) + abs(surface.down);
    // The share of the pixel that is as its texel is.
    var alike = 1.0;
    var longest = 0.0;
    for (var side = 0; side < 4; side++) {
        let sign = select(1, -1, (side & 1) == 1);
        let is_row = side >= 2;
        let outward = select(vec2i(sign, 0), vec2i(0, sign), is_row);
        if is_dark_texel(maps, behind, surface, texel + outward, by_itself) == is_dark {
            continue;
        }
        let along = select(vec2i(0, 1), vec2i(1, 0), is_row);
        let before = border_end(maps, behind, surface, texel, -along, outward, by_itself, is_dark);
        let after = border_end(maps, behind, surface, texel, along, outward, by_itself, is_dark);
        let place = select(within, within.yx, is_row);
        let course = edge_course(before, after, place.y);
        let extent = select(pixel, pixel.yx, is_row);
        let width = max(extent.x + course.slope * extent.y, 1e-3);
        let border = select(place.x, 1.0 - place.x, sign > 0);
        let covered = clamp(0.5 + (border + course.shift) / width, 0.0, 1.0);
        // Of a step of a slanted edge the longer border tells its course.
        alike = select(select(alike, min(alike, covered), course.length == longest), covered,
            course.length > longest);
        longest = max(longest, course.length);
    }
    return select(1.0 - alike, alike, is_dark);
}

/// What keeps the light from a surface, the nearer one of two: how far away its lit side is, in
/// scene units, and its number; 0 and -1 where nothing does.
fn blocker_in_map(
    maps: ShadowMaps,
    behind: ShadowMaps,
    surface: MappedSurface,
    source: vec4f,
    position: vec3f,
) -> vec2f {
    let texel = vec2i(floor(surface.at));
    var found = blocker_texel(maps, behind, surface, texel, false);
    if !stands_before(surface, texel, found) {
        found = vec4f(0.0);
    }
    let own = blocker_texel(maps, behind, surface, texel, true);
    if stands_before(surface, texel, own) && (found.y < 0.5 || own.x < found.x) {
        found = own;
    }
    if found.y < 0.5 {
        return vec2f(0.0, -1.0);
    }
    let way = source.xyz - position;
    let of_lamp = sqrt(dot(way, way)) * (1.0 - surface.nearness / max(found.x, 1e-20));
    let distance = select(found.x - surface.nearness, of_lamp, source.w > 0.5);
    return vec2f(max(distance, 0.0), found.y - 1.0);
}

/// The surface as its own object's shadow sees it. Where the facet is turned away from the light
/// and the smooth normal is not, the facet's own front is no blocker, but what is thicker.
fn smooth_surface(
    surface: MappedSurface,
    receiver: Receiver,
    normal: vec3f,
) -> MappedSurface {
    let facet = cross(receiver.across, receiver.down);
    let toward = receiver.source.xyz - receiver.source.w * receiver.position;
    var smoothed = surface;
    if dot(facet, normal) * dot(facet, toward) <= 0.0 {
        smoothed.noise += THICK * surface.unit;
    }
    return smoothed;
}

fn cast_shadow_balanced(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> f32 {
    if map.w < 0.0 {
        return 0.0;
    }
    let surface = mapped_surface(shadow_map, map, source, position, across, down, object);
    return shadow_of_edges(shadow_map, shadow_map_behind, surface, false);
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

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

fn self_shadow_balanced(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    normal: vec3f,
    normal_across: vec3f,
    normal_down: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> f32 {
    let receiver = Receiver(position, across, down, source, 0.0, 0.0, object, NO_FACET);
    let away = turned_away(receiver, normal, normal_across, normal_down);
    if map.w < 0.0 {
        return 0.0;
    }
    if away >= 1.0 {
        return 1.0;
    }
    let seen = mapped_surface(shadow_map, map, source, position, across, down, object);
    let surface = smooth_surface(seen, receiver, normal);
    return max(away, shadow_of_edges(shadow_map, shadow_map_behind, surface, true));
}

fn shadow_blocker_balanced(
    source: vec4f,
    map: vec4f,
    position: vec3f,
    across: vec3f,
    down: vec3f,
    object: f32,
    shadow_map: ShadowMaps,
    shadow_map_behind: ShadowMaps,
) -> ShadowBlocker {
    if map.w < 0.0 {
        return ShadowBlocker(0.0, -1.0);
    }
    let surface = mapped_surface(shadow_map, map, source, position, across, down, object);
    let found = blocker_in_map(shadow_map, shadow_map_behind, surface, source, position);
    return ShadowBlocker(found.x, found.y);
}

struct ShadowBlocker {
    /// From the surface to what blocks the light, in scene units; 0 where nothing does.
    distance: f32,
    /// Number of the object that blocks it, as Object ID counts; -1 where nothing does.
    object: f32,
}

/// Maximum
///
/// The larger of two numbers, component by component. A color keeps the alpha of A.
fn maximum(a: f32, b: f32) -> f32 {
    return max(bounded(a), bounded(b));
}

const tone_shape = ProfileShape(1.0, 0.0, 1.4142135, 1.0, 0.0, 0.9999498, 0.37607837, 0u);
const in_the_sun = Ramp(array(vec4f(0.9137, 0.6314, 0.3569, 1.0),
    vec4f(0.9725, 0.8157, 0.5412, 1.0), vec4f(1.0, 0.9412, 0.7686, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.5, 1.0, 0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), 3u, 0u);
const in_the_shade = Ramp(array(vec4f(0.1686, 0.1451, 0.3137, 1.0), vec4f(0.251, 0.2, 0.4196, 1.0),
    vec4f(0.4902, 0.3294, 0.5333, 1.0), vec4f(0.7255, 0.4706, 0.549, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0)), array(vec4f(0.0, 0.18, 0.55, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    4u, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let angle = Angle(0.5 * length(surface.normal - look.sun.direction), 0.5
        * length(surface.normal + look.sun.direction));
    let tone = profile_balanced(angle, 0.0, tone_shape);
    let in_the_sun_2 = ramp_at(in_the_sun, tone, footprint_of(tone));

    // Shadow
    let shadow_blocker = shadow_blocker_balanced(look.sun_source, look.sun_shadow_map,
        surface.position, surface.pixel_across, surface.pixel_down, look.object_id, shadow_map,
        shadow_map_behind);

    let how_far_off = min((bounded(shadow_blocker.distance) - 0.0) / (2.6 - 0.0), 1.0);
    let in_the_shade_2 = ramp_at_2(in_the_shade, how_far_off, footprint_of(how_far_off));

    // Shadow
    let shadow_others = cast_shadow_balanced(look.sun_source, look.sun_shadow_map, surface.position,
        surface.pixel_across, surface.pixel_down, look.object_id, shadow_map, shadow_map_behind);
    let shadow_own = self_shadow_balanced(look.sun_source, look.sun_shadow_map, surface.position,
        surface.normal, surface.normal_across, surface.normal_down, surface.pixel_across,
        surface.pixel_down, look.object_id, shadow_map, shadow_map_behind);

    let cast_and_self = maximum(shadow_others, shadow_own);
    let sun_or_shade = mix_colors_normal(in_the_sun_2, in_the_shade_2, cast_and_self);
    return output(premultiplied(with_unit_alpha(sun_or_shade)));
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

/// The look's color: straight RGBA.
fn look_color(in: Varyings, is_front: bool) -> vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, in.position, dpdx(in.position), dpdy(in.position), dpdx(normal),
        dpdy(normal));
    return finite_vec4(shade(surface));
}

/// For targets of colors as shown.
@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    return look_color(in, is_front);
}

/// Linear light of a color as shown.
fn linear_of_shown(color: vec3f) -> vec3f {
    let high = pow((color + 0.055) / 1.055, vec3f(2.4));
    return select(high, color / 12.92, color <= vec3f(0.04045));
}

/// For targets of linear light.
@fragment
fn fs_linear(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let shown = look_color(in, is_front);
    return vec4f(linear_of_shown(shown.rgb), shown.a);
}
