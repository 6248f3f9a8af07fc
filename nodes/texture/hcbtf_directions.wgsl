import chiaro::types;
import chiaro::hcbtf;
import chiaro::color;

/// Painted surface, directions
///
/// Shows what a painted surface (HCBTF) looks up where: for finding out which painting is seen, and
/// whether texture coordinates lie as they should.
///
/// @param sheet "Painted surface" widget=path : An .hcbtf file; only its grid is read.
/// @param light "Light" wire : The light that the painting answers to.
/// @choice show "Show" default=light light="Light's sample" view="View's sample" weights="Weights"
///   phi_zero="Phi zero" : The nearest sample of the light or of the view, its step as hue and its
///   ring as paleness; how much the four nearest views count, in red, green, blue and white; or
///   where phi begins: orange for the light, blue for the view.
/// @param normal "Normal" from=normal : World space; any length but 0.
/// @param view from=view hidden
/// @param tangent from=tangent hidden
/// @param bitangent from=bitangent hidden
/// @return color "Color" : Opaque.
/// @source thesis Appendix B
fn hcbtf_directions_light(sheet: texture_2d_array<f32>, sheet_sampler: sampler, light: Light,
    normal: vec3f, tangent: vec3f, bitangent: vec3f) -> Color {
    let grid = hcbtf_grid(sheet, 0);
    let frame = world_from_tangent(tangent, bitangent, normal);
    let near = hcbtf_near(hcbtf_place(hcbtf_local(light.direction, frame), grid.light), grid.light);
    return hcbtf_sample_color(near, grid.light);
}

fn hcbtf_directions_view(sheet: texture_2d_array<f32>, sheet_sampler: sampler, normal: vec3f,
    view: vec3f, tangent: vec3f, bitangent: vec3f) -> Color {
    let grid = hcbtf_grid(sheet, 0);
    let frame = world_from_tangent(tangent, bitangent, normal);
    let near = hcbtf_near(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    return hcbtf_sample_color(near, grid.view);
}

fn hcbtf_directions_weights(sheet: texture_2d_array<f32>, sheet_sampler: sampler, normal: vec3f,
    view: vec3f, tangent: vec3f, bitangent: vec3f) -> Color {
    let grid = hcbtf_grid(sheet, 0);
    let frame = world_from_tangent(tangent, bitangent, normal);
    let views = hcbtf_views(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    return vec4f(views.weight.xyz + views.weight.w, 1.0);
}

fn hcbtf_directions_phi_zero(light: Light, normal: vec3f, view: vec3f, tangent: vec3f,
    bitangent: vec3f) -> Color {
    let frame = world_from_tangent(tangent, bitangent, normal);
    let to_light = hcbtf_local(light.direction, frame);
    let to_view = hcbtf_local(view, frame);
    let of_light = hcbtf_phi_line(to_light, footprint_of(to_light.x));
    let of_view = hcbtf_phi_line(to_view, footprint_of(to_view.x));
    let ground = vec3f(0.12 + 0.5 * max(to_view.z, 0.0));
    return vec4f(mix(mix(ground, vec3f(0.2, 0.45, 1.0), of_view), vec3f(1.0, 0.55, 0.1), of_light),
        1.0);
}

/// A sample's own color: its step around the normal as hue, paler toward the normal.
fn hcbtf_sample_color(place: vec2i, directions: vec2i) -> vec4f {
    let hue = rgb_of_hue(f32(place.y) / f32(directions.y));
    let part = f32(place.x) / f32(max(directions.x - 1, 1));
    return vec4f(mix(vec3f(1.0), hue, part), 1.0);
}

/// A line three pixels wide where phi is 0: where the u axis is crossed on the side of v.
fn hcbtf_phi_line(local: vec3f, w: f32) -> f32 {
    let edge = max(1.5 * w, 0.01);
    return (1.0 - step_filtered(abs(local.x), edge, w)) * select(0.0, 1.0, local.y > 0.0);
}
