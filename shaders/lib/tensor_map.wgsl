// View-centered curvature tensor (Vergne et al. 2008): how the slope n.xy / n.z changes along both
// axes of the picture. The curvature pass finds half of its trace; neighbors count as in that
// pass.
import chiaro::curvature_map;

/// The tensor from the neighbors, in 1/viewport-height, camera axes, convex positive: xx, xy, yy.
fn curvature_tensor(ring: Ring) -> vec3f {
    let of_x = derivatives(ring.x, ring.weights);
    let of_y = derivatives(ring.y, ring.weights);
    // A surface's own tensor is symmetric; that of interpolated normals is not quite.
    let tensor = vec3f(of_x.x, 0.5 * (of_y.x + of_x.y), of_y.y) * curvature.viewport_height;
    return clamp(tensor, vec3f(-MOST), vec3f(MOST));
}
