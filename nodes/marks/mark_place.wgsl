import chiaro::types;
import chiaro::marks;
import chiaro::numeric;
import chiaro::screen;
import chiaro::total;

/// Mark place
///
/// Where strokes and dots are anchored, and which way strokes go: on the picture, on the picture
/// but moving along with the object, along texture coordinates, across an axis of the object, or
/// around the light so that they turn with it. Wire both outputs to Hatching, Stippling, Brush
/// strokes or Paper grain, which keep their marks as large on the picture as they are, however far
/// the surface is.
///
/// @choice follow "Follows" default=light light="Light" axis="Axis" uv="UV" object="Object"
///   screen="Screen" : Light lays strokes along the edge of its shadow; Axis along cuts through the
///   object; UV along u; Object moves with the object's middle and grows with its nearness; Screen
///   stays where it is.
/// @param light "Light" wire : Whose light strokes lie around.
/// @param axis "Axis" default=0,1,0 : In the object's own space.
/// @param uv "UV" from=uv : Texture coordinates.
/// @param unit "UV size" default=3 min=0.001 max=1000 : How large one unit of the texture
///   coordinates is, in the object's own units.
/// @param normal "Normal" from=normal : World space; any length but 0. Smooth normals keep strokes
///   together.
/// @param angle "Angle" unit=rad default=0 : How far strokes are turned.
/// @param view from=view hidden
/// @param tangent from=tangent hidden
/// @param bitangent from=bitangent hidden
/// @param position_object from=position_object hidden
/// @param world_from_normal from=world_from_normal hidden
/// @param magnification from=magnification hidden
/// @param anchor from=anchor hidden
/// @param pixel from=pixel hidden
/// @param viewport from=viewport hidden
/// @source Praun et al. 2001; Kalnins et al. 2002
fn mark_place_light(
    light: Light,
    normal: vec3f,
    angle: f32,
    view: vec3f,
    position_object: vec3f,
    world_from_normal: mat3x3f,
    magnification: f32,
) -> MarkPlace {
    let toward = light.direction * world_from_normal;
    let m = place_across(toward, position_object, world_from_normal, normal, view, magnification,
        angle);
    return MarkPlace(m.place, m.stretch);
}

fn mark_place_axis(
    axis: vec3f,
    normal: vec3f,
    angle: f32,
    view: vec3f,
    position_object: vec3f,
    world_from_normal: mat3x3f,
    magnification: f32,
) -> MarkPlace {
    let m = place_across(axis, position_object, world_from_normal, normal, view, magnification,
        angle);
    return MarkPlace(m.place, m.stretch);
}

fn mark_place_uv(
    uv: vec2f,
    unit: f32,
    normal: vec3f,
    angle: f32,
    view: vec3f,
    tangent: vec3f,
    bitangent: vec3f,
    world_from_normal: mat3x3f,
    magnification: f32,
) -> MarkPlace {
    let m = place_along_uv(uv, unit, normal, view, tangent, bitangent, world_from_normal,
        magnification, angle);
    return MarkPlace(m.place, m.stretch);
}

fn mark_place_object(angle: f32, anchor: vec3f, pixel: vec2f, viewport: vec2f) -> MarkPlace {
    let size = clamp(bounded(anchor.z), 1e-6, 1e6);
    let place = bounded_vec2(place_in_picture(pixel, viewport) - vec2f(anchor.x, -anchor.y)) / size;
    let m = mark_place_of(place, vec3f(1.0 / size, 0.0, 0.0), vec3f(0.0, 1.0 / size, 0.0), angle);
    return MarkPlace(m.place, m.stretch);
}

fn mark_place_screen(angle: f32, pixel: vec2f, viewport: vec2f) -> MarkPlace {
    let place = place_in_picture(pixel, viewport);
    let m = mark_place_of(place, vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), angle);
    return MarkPlace(m.place, m.stretch);
}

struct MarkPlace {
    /// Along the strokes, and across them.
    place: vec2f,
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    stretch: vec3f,
}
