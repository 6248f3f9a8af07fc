import chiaro::numeric;
import chiaro::total;
import chiaro::curvature;

/// Relief
///
/// What the surface does at a place, in two numbers for a Tone map or for ramps: its shape (pit,
/// valley, saddle, ridge or bump) and how strongly it has it.
///
/// @param tensor "Curvature tensor" from=curvature_tensor : xx, xy and yy in camera axes, in
///   1/viewport-height.
/// @param slope "Slope" default=0.05 min=0 max=1 : How soon relief counts as strong.
/// @error fast 0.1 : of the curvatures, where the surface is smooth, of triangles of a pixel or so,
///   and not seen edge-on; large triangles and creases show, and no pass is needed
/// @source Koenderink and van Doorn 1992; Kindlmann et al. 2003; Vergne et al. 2008
fn relief(tensor: vec3f, slope: f32) -> Relief {
    let k = principal_curvatures(tensor_safe(tensor));
    let around = angle_of_point(k.x + k.y, k.x - k.y);
    let curvedness = sqrt(0.5 * dot(k, k));
    let strength = curvature_signed(curvedness, max(bounded(slope), 0.0));
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
