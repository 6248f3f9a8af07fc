// A hierarchy of ever smoother normals, as exaggerated shading wants it (Rusinkiewicz et al. 2006),
// by wavelets with holes: each level blurs the one before it by 1 2 1 in both directions, with
// steps twice as far apart. So level k has seen a Gaussian that is sqrt((4^k - 1) / 1.5) steps of
// 1/800 of the picture's height wide, for nine reads a level however wide it is.
import chiaro::curvature_map;

/// The normal at a pixel, smoothed from neighbors `step` steps of 1/800 of the picture's height
/// away, in xyz; the object in w.
///
/// Two opposite neighbors count for as much as the lesser of them does. So what one side lacks, at
/// an outline or where something else lies in front, does not bend the normal toward the other
/// side.
fn smoothed_at(pixel: vec2i, step: i32) -> vec4f {
    var at = pixel;
    var center = texel(at);
    let object = center.object;
    if center.object == 0.0 {
        // With several samples per pixel, pixels at an outline take the values of a neighbor, as
        // for curvature.
        if curvature.samples < 2.0 {
            return vec4f(0.0);
        }
        at = covered_near(pixel);
        center = texel(at);
        if center.object == 0.0 {
            return vec4f(0.0);
        }
    }
    let reach = step * max(i32(round(curvature.viewport_height / 800.0)), 1);
    var sum = 4.0 * center.normal;
    sum += pair_of(center, at, vec2i(reach, 0), 2.0);
    sum += pair_of(center, at, vec2i(0, reach), 2.0);
    sum += pair_of(center, at, vec2i(reach, reach), 1.0);
    sum += pair_of(center, at, vec2i(reach, -reach), 1.0);
    let size = length(sum);
    return vec4f(select(center.normal, sum / max(size, 1e-6), size > 1e-6), object);
}

/// Weighted sum of the normals at both sides of a pixel; the pixel's own stands in as far as one of
/// them does not count. `offset` is in pixels, y up.
fn pair_of(center: Texel, at: vec2i, offset: vec2i, weight: f32) -> vec3f {
    let up = select(-1, 1, curvature.rows_up > 0.5);
    let by = vec2i(offset.x, up * offset.y);
    let away = vec2f(offset);
    let share = min(neighbor(center, at + by, away).z, neighbor(center, at - by, -away).z);
    let both = texel(at + by).normal + texel(at - by).normal;
    return weight * (share * both + (1.0 - share) * 2.0 * center.normal);
}
