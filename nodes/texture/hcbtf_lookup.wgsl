import chiaro::types;
import chiaro::hcbtf;

/// Painted surface
///
/// A hand-painted surface (HCBTF) that changes with the light and with the eye: for each direction
/// of both it shows what was painted for them, blended between the nearest paintings.
///
/// @param sheet "Painted surface" widget=path : An .hcbtf file.
/// @param light "Light" wire : The light that the painting answers to. For several lights use a
///   lookup for each, or let Dominant light choose one, which keeps strokes whole.
/// @param uv "UV" from=uv : Where on the tile, which repeats; u to the right, v up.
/// @param scale "Scale" default=1,1 : How often the tile repeats.
/// @param unlit "Below the horizon" default=0,0,0,1 : The color where the light stands below the
///   surface.
/// @param normal "Normal" from=normal : World space; a bumped one tilts the painting's directions
///   with it.
/// @choice lookup "Lookup" default=smooth smooth="Smooth" texels="Crisp texels" : Smooth blends
///   directions and texels and does not shimmer at a distance; Crisp texels blends directions alone
///   and keeps each texel a square.
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
/// @error balanced 3.7e-3 : color, premultiplied, where neighboring paintings have nothing in
///   common, from the GPU's eight-bit weights; 1e-3 where they are alike
/// @error fast 0.55 : color where paintings of neighboring views differ, for the nearest view
///   alone is read; the mean over smooth paintings is 0.017
/// @opaque
/// @source thesis 10.3, A.3
fn hcbtf_lookup_smooth(
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
    let place = bounded_vec2(uv * scale);
    let level = hcbtf_level(place, grid);
    let above = hcbtf_horizon(light.direction, frame);
    let lights = hcbtf_around(hcbtf_place(hcbtf_local(light.direction, frame), grid.light),
        grid.light);
    let views = hcbtf_views(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    // Nothing painted is seen below the horizon.
    var sum = vec4f(0.0);
    if above > 0.0 {
        sum = hcbtf_smooth(sheet, place, grid, level, lights, views);
    }
    return hcbtf_finished(hcbtf_straight(sum), above, unlit, grid);
}

fn hcbtf_lookup_smooth_balanced(
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
    let place = bounded_vec2(uv * scale);
    let level = hcbtf_level(place, grid);
    let above = hcbtf_horizon(light.direction, frame);
    let lights = hcbtf_place(hcbtf_local(light.direction, frame), grid.light);
    let views = hcbtf_views(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    var sum = vec4f(0.0);
    if above > 0.0 {
        sum = hcbtf_smooth_taps(sheet, sheet_sampler, place, grid, level, lights, views);
    }
    return hcbtf_finished(hcbtf_straight(sum), above, unlit, grid);
}

fn hcbtf_lookup_smooth_fast(
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
    let place = bounded_vec2(uv * scale);
    let level = i32(hcbtf_level(place, grid) + 0.5);
    let above = hcbtf_horizon(light.direction, frame);
    let lights = hcbtf_place(hcbtf_local(light.direction, frame), grid.light);
    let near = hcbtf_near(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    let color = hcbtf_tap_at(sheet, sheet_sampler, place, grid, level, lights, near);
    return hcbtf_finished(color, above, unlit, grid);
}

fn hcbtf_lookup_texels(
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
    let lights = hcbtf_around(hcbtf_place(hcbtf_local(light.direction, frame), grid.light),
        grid.light);
    let views = hcbtf_views(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    return hcbtf_finished(hcbtf_straight(hcbtf_crisp(sheet, uv * scale, grid, lights, views)),
        above, unlit, grid);
}

fn hcbtf_lookup_texels_balanced(
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
    let lights = hcbtf_place(hcbtf_local(light.direction, frame), grid.light);
    let views = hcbtf_views(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    return hcbtf_finished(hcbtf_straight(hcbtf_crisp_taps(sheet, sheet_sampler, uv * scale, grid,
        lights, views)), above, unlit, grid);
}

fn hcbtf_lookup_texels_fast(
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
    let lights = hcbtf_place(hcbtf_local(light.direction, frame), grid.light);
    let near = hcbtf_near(hcbtf_place(hcbtf_local(view, frame), grid.view), grid.view);
    let color = hcbtf_crisp_tap(sheet, sheet_sampler, uv * scale, grid, lights, near);
    return hcbtf_finished(color, above, unlit, grid);
}
