import chiaro::types;
import chiaro::convert;
import chiaro::numeric;

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
///
/// @param color "Color" wire : The finished stack of layers, or any color.
/// @param normal "Detail normal" from=normal : What the curvature pass sees when a Curvature node
///   asks for detail.
/// @param cutoff "Alpha cutoff" default=0 min=0 max=1 : Fragments with less alpha than this are not
///   drawn, the others keep theirs; 0 draws all.
/// @param id "Id" default=0 : Whole number by which *Outline* tells parts of a surface apart, such
///   as one painted into an image: where it changes is a border of ids. 128 ids differ.
/// @return color "Color" : The pixel.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

fn output_normal(normal: vec3f) -> vec3f {
    return normalize_or(normal, vec3f(0.0, 0.0, 1.0));
}

fn output_cutoff(cutoff: f32) -> f32 {
    return cutoff;
}

fn output_id(id: f32) -> f32 {
    return id;
}
