import chiaro::types;
import chiaro::hcbtf;

/// Painted surface, nearest
///
/// A hand-painted surface (HCBTF), of which each place shows the one painting whose light and view
/// are nearest, as it was painted: strokes stay whole, and change at once.
///
/// @param sheet "Painted surface" widget=path : An .hcbtf file.
/// @param light "Light" wire : The light that the painting answers to.
/// @param uv "UV" from=uv : Where on the tile, which repeats; u to the right, v up.
/// @param scale "Scale" default=1,1 : How often the tile repeats.
/// @param unlit "Below the horizon" default=0,0,0,1 : The color where the light stands below the
///   surface.
/// @param normal "Normal" from=normal : World space; a bumped one tilts the painting's directions
///   with it.
/// @choice encoding "Encoding" default=color color="Color" data="Data" :
///   Color for what is seen; Data takes numbers as they are.
/// @choice storage "Storage" default=quick quick="Quick" compact="Compact" blocks="Blocks" : Quick
///   needs the fewest reads; Compact keeps every tile that differs once, with a palette where that
///   is smaller, and looks the same with a fraction of the memory; Blocks compresses them to a byte
///   a texel (BC7), which is off by a few of 255, where the GPU can. `chiaro hcbtf info` tells what
///   each takes.
/// @param view from=view hidden
/// @param tangent from=tangent hidden
/// @param bitangent from=bitangent hidden
/// @return color "Color" : Straight RGBA.
/// @opaque
/// @source thesis 10.3
fn hcbtf_nearest(
    sheet: texture_2d_array<f32>,
    sheet_sampler: sampler,
    storage: i32,
    light: Light,
    uv: vec2f,
    scale: vec2f,
    unlit: Color,
    normal: vec3f,
    view: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
) -> Color {
    let grid = hcbtf_grid(sheet, storage);
    let frame = world_from_tangent(tangent, bitangent, normal);
    let above = hcbtf_horizon(light.direction, frame);
    let lights = hcbtf_near(hcbtf_place(hcbtf_local(light.direction, frame), grid.light),
        grid.light);
    let near = hcbtf_near(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    return hcbtf_finished(hcbtf_painted(sheet, uv * scale, grid, lights, near), above, unlit, grid);
}
