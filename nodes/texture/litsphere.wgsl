import chiaro::types;
import chiaro::numeric;
import chiaro::surface;

/// LitSphere
///
/// Shades the surface as a painted ball is shaded: each normal takes the color that the ball has
/// there. The picture holds the ball, seen from the front.
///
/// @param image "Image" widget=path : A picture of the ball.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @choice lookup "Lookup" default=perspective perspective="Along the line of sight"
///   camera="Along the camera's axis" : Along the line of sight, the ball's rim is always the
///   surface's rim; along the camera's axis, equal normals have equal colors all over the picture.
///   Without perspective both are the same.
/// @param radius "Radius" default=0.49 min=0 max=0.5 : The ball's radius over the picture's width.
/// @choice filter "Filter" default=linear linear="Linear" nearest="Nearest" : Linear is smooth;
///   Nearest keeps pixels.
/// @choice encoding "Encoding" default=color color="Color" data="Data" :
///   Color for what is seen; Data takes numbers as they are.
/// @param view from=view hidden
/// @param camera_from_world from=camera_from_world hidden
/// @return color "Color" : Straight RGBA.
/// @source Sloan, Martin, Gooch and Gooch 2001
fn litsphere_perspective(
    image: texture_2d<f32>,
    image_sampler: sampler,
    normal: vec3f,
    radius: f32,
    view: vec3f,
    camera_from_world: mat3x3f,
) -> Color {
    let n = camera_from_world * normalize_or(normal, view);
    return textureSample(image, image_sampler,
        litsphere_place(n, camera_from_world * view, radius));
}

fn litsphere_camera(
    image: texture_2d<f32>,
    image_sampler: sampler,
    normal: vec3f,
    radius: f32,
    view: vec3f,
    camera_from_world: mat3x3f,
) -> Color {
    let n = camera_from_world * normalize_or(normal, view);
    return textureSample(image, image_sampler, litsphere_place(n, vec3f(0.0, 0.0, 1.0), radius));
}
