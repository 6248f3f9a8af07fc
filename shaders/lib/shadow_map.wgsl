// Shadows from maps: pictures of the scene as a light sees it (docs/math.md 6.8).
//
// A texel of a map tells how near to the light the nearest surface is, the number of its object
// from 1 on, and how its nearness changes from texel to texel. A directional light's nearness is
// the height toward it; a lamp's is 1 over the depth in the face of a cube about it. Both are
// linear over a plane. So a surface and a texel are two planes, and the texel is a blocker where
// its plane is the nearer one both at the texel's middle and at the surface's own place: no offset
// is needed, whatever the scale. A second map holds what is nearest of other objects than the first
// map's, so that an object's own shadow and those of others are told apart.
import chiaro::types;
import chiaro::numeric;
import chiaro::shadows;

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

/// The share of a light that is kept from a surface, by the texel it lies in: 0 or 1.
fn shadow_of_texel(
    maps: ShadowMaps,
    behind: ShadowMaps,
    surface: MappedSurface,
    by_itself: bool,
) -> f32 {
    let texel = vec2i(floor(surface.at));
    return select(0.0, 1.0, is_dark_texel(maps, behind, surface, texel, by_itself));
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
