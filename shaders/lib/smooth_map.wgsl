// A hierarchy of ever smoother normals, as exaggerated shading wants it (Rusinkiewicz et al. 2006),
// by wavelets with holes: each level blurs the one before it by 1 2 1 in both directions, with
// steps twice as far apart. So level k has seen a Gaussian that is sqrt((4^k - 1) / 1.5) steps of
// 1/800 of the picture's height wide, for nine reads a level however wide it is.
import chiaro::curvature_map;

/// The normals of the level before, in camera axes, in xyz. The first level reads none: the surface
/// has its normals.
@group(0) @binding(2) var normals: texture_2d<f32>;

/// A pixel before a level smooths it: all 0 beyond the image, and the object where nothing is.
struct RoughPixel {
    normal: vec3f,
    object: f32,
    depth: f32,
}

fn rough_pixel(at: vec2i, level: i32) -> RoughPixel {
    let size = vec2i(textureDimensions(surface));
    if any(at < vec2i(0)) || any(at >= size) {
        return RoughPixel(vec3f(0.0), 0.0, 0.0);
    }
    let texel = textureLoad(surface, at, 0);
    if level == 1 {
        return RoughPixel(normal_of(texel), abs(texel.w), texel.z);
    }
    return RoughPixel(textureLoad(normals, at, 0).xyz, abs(texel.w), texel.z);
}

/// The normal at a pixel, smoothed from neighbors 2^level steps of 1/800 of the picture's height
/// away, in xyz; the object in w.
///
/// Two opposite neighbors count for as much as the lesser of them does. So what one side lacks, at
/// an outline or where something else lies in front, does not bend the normal toward the other
/// side.
fn smoothed_at(pixel: vec2i, level: i32) -> vec4f {
    let at = seen_pixel(pixel).at;
    let center = rough_pixel(at, level);
    if center.object == 0.0 {
        return vec4f(0.0);
    }
    let plane = plane_of(center.object, center.depth, center.normal);
    let reach = (1 << u32(level)) * step_pixels();
    let straight = pairs_of(center.normal, plane, at, vec2i(reach, 0), vec2i(0, reach), level);
    let slanted = pairs_of(center.normal, plane, at, vec2i(reach), vec2i(reach, -reach), level);
    let sum = 4.0 * center.normal + 2.0 * straight + slanted;
    let size = length(sum);
    let normal = select(center.normal, sum / max(size, 1e-6), size > 1e-6);
    // A pixel that has its neighbor's normal shows no object itself.
    return vec4f(normal, select(0.0, center.object, all(at == pixel)));
}

/// Sum of the normals of two pairs of neighbors, at both sides of a pixel each; the pixel's own
/// normal stands in as far as one of a pair does not count. Both offsets, along columns and rows,
/// are equally long.
fn pairs_of(normal: vec3f, plane: Plane, at: vec2i, first: vec2i, second: vec2i,
    level: i32) -> vec3f {
    let a = rough_pixel(at + first, level);
    let b = rough_pixel(at - first, level);
    let c = rough_pixel(at + second, level);
    let d = rough_pixel(at - second, level);
    let objects = vec4f(a.object, b.object, c.object, d.object);
    let depths = vec4f(a.depth, b.depth, c.depth, d.depth);
    let rise = vec2f(dot(plane.rise, vec2f(first)), dot(plane.rise, vec2f(second)));
    let rises = vec4f(rise.x, -rise.x, rise.y, -rise.y);
    let weights = neighbor_weights(plane, objects, depths, rises, length(vec2f(first)));
    let share = min(weights.xz, weights.yw);
    return share.x * (a.normal + b.normal) + (1.0 - share.x) * 2.0 * normal
        + share.y * (c.normal + d.normal) + (1.0 - share.y) * 2.0 * normal;
}
