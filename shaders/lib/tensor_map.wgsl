// View-centered curvature tensor (Vergne et al. 2008): how the slope n.xy / n.z changes along both
// axes of the picture. The curvature pass finds half of its trace; neighbors count as in that
// pass.
import chiaro::curvature_map;

/// Weighted difference of slopes to a neighbor for each step in xy, and the weight in z.
fn slope_change(center: Texel, here: vec2f, at: vec2i, offset: vec2f, weight: f32) -> vec3f {
    let other = neighbor(center, at, offset);
    let sign = select(-1.0, 1.0, offset.x + offset.y > 0.0);
    return weight * other.z * vec3f(sign * (other.xy - here) / length(offset), 1.0);
}

/// The derivative of the slope from what counts of the two sides, as [`derivative`] joins them.
fn slope_derivative(forward: vec3f, backward: vec3f) -> vec2f {
    return vec2f(
        derivative(SideDifferences(forward.x, forward.z, backward.x, backward.z)),
        derivative(SideDifferences(forward.y, forward.z, backward.y, backward.z)),
    );
}

/// The tensor at a pixel in 1/viewport-height, camera axes, convex positive: xx, xy, yy.
fn tensor_at(pixel: vec2i) -> vec3f {
    var at = pixel;
    var center = texel(at);
    if center.object == 0.0 {
        // With several samples per pixel, pixels at an outline take the values of a neighbor, as
        // for curvature.
        if curvature.samples < 2.0 {
            return vec3f(0.0);
        }
        at = covered_near(pixel);
        center = texel(at);
        if center.object == 0.0 {
            return vec3f(0.0);
        }
    }
    let here = slope(center.normal);
    let up = select(-1, 1, curvature.rows_up > 0.5);
    let stride = max(i32(round(curvature.viewport_height / 800.0)), 1);
    var right = vec3f(0.0);
    var left = vec3f(0.0);
    var above = vec3f(0.0);
    var below = vec3f(0.0);
    for (var k = 1; k <= 3; k++) {
        let reach = k * stride;
        let distance = f32(reach);
        let weight = WEIGHTS[k - 1] * distance * distance;
        right += slope_change(center, here, at + vec2i(reach, 0), vec2f(distance, 0.0), weight);
        left += slope_change(center, here, at - vec2i(reach, 0), vec2f(-distance, 0.0), weight);
        above += slope_change(center, here, at + vec2i(0, up * reach), vec2f(0.0, distance),
            weight);
        below += slope_change(center, here, at - vec2i(0, up * reach), vec2f(0.0, -distance),
            weight);
    }
    let along_x = slope_derivative(right, left);
    let along_y = slope_derivative(above, below);
    // A surface's own tensor is symmetric; that of interpolated normals is not quite.
    let tensor = vec3f(along_x.x, 0.5 * (along_x.y + along_y.x), along_y.y)
        * curvature.viewport_height;
    return clamp(tensor, vec3f(-MOST), vec3f(MOST));
}
