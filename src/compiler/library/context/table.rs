//! Table of all contexts, a row each.
//!
//! A new context needs a row here, and the functions that its expression calls in `shaders/lib`; a
//! context that a pass serves names that pass's row of the [table of
//! passes](crate::library::PassId).

use glam::{DMat3, DVec3};

use super::Rate::{Frame, Object};
use super::row::{ContextBounds, ContextRow as Row};
use super::sample::SurfacePart::{
    Camera, Kappa, Normal, Position, Tangent, Time, Uv, VertexColor, View,
};
use super::sample::vec3;
use crate::interp::Value;

/// Position of a fragment in camera axes.
macro_rules! position_camera {
    () => {
        "(view.camera_from_world * vec4f(in.position, 1.0)).xyz"
    };
}

/// Factor by which clip space multiplies heights: at depth 1, or at every depth without
/// perspective.
macro_rules! view_scale {
    () => {
        "length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y, \
         view.clip_from_world[2].y))"
    };
}

/// Measure of the fragment's own normal, in camera axes.
macro_rules! on_screen {
    ($measure:literal) => {
        concat!(
            $measure,
            "((view.camera_from_world * vec4f(normal, 0.0)).xyz, ",
            position_camera!(),
            ", view.eye.w, ",
            view_scale!(),
            ")"
        )
    };
}

/// Expression that turns a texel from camera axes into world space: a vector before a rotation
/// matrix is turned back by it.
const TURNED_BACK: &str = "(vec4f(texel.xyz, 0.0) * view.camera_from_world).xyz";

/// Greatest number of a place, in scene units: scenes end sooner, and loaders refuse meshes that
/// could reach beyond.
pub const MAX_PLACE: f64 = 4e18;

/// Greatest texture coordinate, and number of a vertex color: loaders clamp both.
pub const MAX_COORDINATE: f64 = 1e6;

/// Greatest curvature, in 1/viewport-height: passes and functions clamp to it (`MOST` in
/// `shaders/lib/curvature_map.wgsl`).
pub const MAX_CURVATURE: f64 = 1e4;

/// Farthest that lines reach from their edges, in pixels (`line_reach` in
/// `shaders/lib/lines.wgsl`).
pub const MAX_LINE_REACH: f64 = 31.0;

/// Greatest number that packs two: the last of the whole numbers that f32 holds one by one.
const MAX_PACKED: f64 = 16_777_215.0;

/// Greatest place and size on screen, in picture heights: functions clamp to it
/// (`MOST_ON_SCREEN` in `shaders/lib/screen.wgsl`).
pub const MAX_ON_SCREEN: f64 = 1e15;

/// Greatest number of the matrix that turns normals into world space: the host scales greater ones
/// down, which leaves the directions of normals.
pub const MAX_NORMAL_SCALE: f64 = 1e15;

/// Rows of the table. Structs of generated modules have their members in this order.
pub(super) const TABLE: &[Row] = &[
    Row::fragment(
        "normal",
        "vec3f",
        "normal",
        "unit surface normal, world space, toward the side that is seen",
    )
    .within(ContextBounds::Unit)
    .sampled(&[Normal], |at| vec3(at.normal)),
    Row::fragment(
        "view",
        "vec3f",
        "normalize(view.eye.xyz - view.eye.w * in.position)",
        "unit, from the surface to the eye, world space",
    )
    .within(ContextBounds::Unit)
    .sampled(&[View], |at| vec3(at.view)),
    Row::fragment("position", "vec3f", "in.position", "the place on the surface, world space")
        .within(ContextBounds::Within(MAX_PLACE))
        .sampled(&[Position], |at| vec3(at.position)),
    Row::fragment(
        "position_object",
        "vec3f",
        "in.position_object",
        "the place on the surface, the object's own space",
    )
    .within(ContextBounds::Within(MAX_PLACE))
    .sampled(&[Position], |at| vec3(at.position)),
    Row::fragment(
        "position_camera",
        "vec3f",
        position_camera!(),
        "the place on the surface from the eye, camera axes: x right, y up, z toward the viewer",
    )
    .within(ContextBounds::Within(4.0 * MAX_PLACE))
    .sampled(&[Position, Camera], |at| vec3(at.camera * at.position)),
    Row::fragment("uv", "vec2f", "in.uv", "texture coordinates; v up")
        .within(ContextBounds::Within(MAX_COORDINATE))
        .sampled(&[Uv], |at| Value::vec(&at.uv.to_array())),
    Row::fragment(
        "vertex_color",
        "Color",
        "in.color",
        "straight RGBA of the vertices; white where the mesh has none",
    )
    .within(ContextBounds::Within(MAX_COORDINATE))
    .sampled(&[VertexColor], |at| Value::vec(&at.vertex_color)),
    Row::fragment(
        "tangent",
        "vec3f",
        "normalize_moderate(in.tangent.xyz - normal * dot(normal, in.tangent.xyz), vec3f(0.0))",
        "unit, along u, world space, at a right angle to the normal; 0 where there is none",
    )
    .within(ContextBounds::UnitOrShorter)
    .sampled(&[Normal, Tangent], |at| vec3(at.tangent)),
    Row::fragment(
        "bitangent",
        "vec3f",
        "cross(normal, normalize_moderate(in.tangent.xyz - normal * dot(normal, in.tangent.xyz), \
         vec3f(0.0))) * in.tangent.w",
        "unit, along v, world space; 0 where there is none",
    )
    .within(ContextBounds::UnitOrShorter)
    .sampled(&[Normal, Tangent], |at| vec3(at.bitangent)),
    Row::fragment(
        "depth",
        "f32",
        "-(view.camera_from_world * vec4f(in.position, 1.0)).z",
        "distance in front of the eye along the viewing axis, scene units",
    )
    .within(ContextBounds::Within(4.0 * MAX_PLACE))
    .sampled(&[Position, Camera], |at| Value::Float(-(at.camera * at.position).z)),
    Row::of_pass(
        "kappa",
        "f32",
        ("curvature", "texel.x"),
        "signed curvature of the surface in 1/viewport-height, convex positive",
    )
    .labeled("curvature")
    .cheaper(Some("kappa_sparse"), Some("kappa_fast"))
    .within(ContextBounds::Clamped(MAX_CURVATURE))
    .sampled(&[Kappa], |at| Value::Float(at.kappa)),
    Row::of_pass(
        "kappa_sparse",
        "f32",
        ("curvature_sparse", "texel.x"),
        "the same from four neighbors of a pixel, two steps away",
    )
    .labeled("curvature")
    .within(ContextBounds::Clamped(MAX_CURVATURE))
    .sampled(&[Kappa], |at| Value::Float(at.kappa)),
    Row::derived(
        "kappa_fast",
        "f32",
        on_screen!("curvature_on_screen"),
        "the same from the normals of neighboring pixels alone, without a pass of its own; \
         triangles show in it",
    )
    .labeled("curvature")
    .within(ContextBounds::Clamped(MAX_CURVATURE))
    .sampled(&[Kappa], |at| Value::Float(at.kappa)),
    Row::of_pass(
        "kappa_detail",
        "f32",
        ("detail_curvature", "texel.x"),
        "signed curvature of the Output node's detail normal, in 1/viewport-height",
    )
    .labeled("detail curvature")
    .cheaper(Some("kappa_detail_sparse"), Some("kappa_detail_sparse"))
    .within(ContextBounds::Clamped(MAX_CURVATURE))
    .sampled(&[Kappa], |at| Value::Float(at.kappa)),
    Row::of_pass(
        "kappa_detail_sparse",
        "f32",
        ("detail_curvature_sparse", "texel.x"),
        "the same from four neighbors of a pixel, two steps away",
    )
    .labeled("detail curvature")
    .within(ContextBounds::Clamped(MAX_CURVATURE))
    .sampled(&[Kappa], |at| Value::Float(at.kappa)),
    // A sample has no neighbors, and counts as curved alike in every direction.
    Row::of_pass(
        "curvature_tensor",
        "vec3f",
        ("curvature_tensor", "texel.xyz"),
        "curvature of the surface by direction: xx, xy and yy in camera axes, in \
         1/viewport-height, convex positive",
    )
    .cheaper(None, Some("curvature_tensor_fast"))
    .within(ContextBounds::Clamped(MAX_CURVATURE))
    .sampled(&[Kappa], |at| vec3(DVec3::new(at.kappa, 0.0, at.kappa))),
    Row::derived(
        "curvature_tensor_fast",
        "vec3f",
        on_screen!("tensor_on_screen"),
        "the same from the normals of neighboring pixels alone, without a pass of its own; \
         triangles show in it",
    )
    .within(ContextBounds::Clamped(MAX_CURVATURE))
    .sampled(&[Kappa], |at| vec3(DVec3::new(at.kappa, 0.0, at.kappa))),
    // A sample has no neighbors, and so is smooth already.
    Row::of_pass(
        "smooth_normal_1",
        "vec3f",
        ("smooth_normals_1", TURNED_BACK),
        "the surface's normal smoothed over 1/570 of the picture's height, world space; 0 where \
         there is none",
    )
    .within(ContextBounds::UnitOrShorter)
    .sampled(&[Normal], |at| vec3(at.normal)),
    Row::of_pass(
        "smooth_normal_2",
        "vec3f",
        ("smooth_normals_2", TURNED_BACK),
        "the same over 1/250 of the height",
    )
    .within(ContextBounds::UnitOrShorter)
    .sampled(&[Normal], |at| vec3(at.normal)),
    Row::of_pass(
        "smooth_normal_3",
        "vec3f",
        ("smooth_normals_3", TURNED_BACK),
        "the same over 1/125 of the height",
    )
    .within(ContextBounds::UnitOrShorter)
    .sampled(&[Normal], |at| vec3(at.normal)),
    Row::of_pass(
        "smooth_normal_4",
        "vec3f",
        ("smooth_normals_4", TURNED_BACK),
        "the same over 1/60 of the height",
    )
    .within(ContextBounds::UnitOrShorter)
    .sampled(&[Normal], |at| vec3(at.normal)),
    // A sample has no neighbors, and so no edges.
    Row::of_pass(
        "line_nearness",
        "vec4f",
        ("line_nearness", "texel"),
        "how much nearer than the reach of lines the nearest silhouette, crease, border of objects \
         and border of materials are, in pixels; 0 where none is near, and negative in the last \
         place for a border of ids",
    )
    .labeled("nearness of edges")
    .cheaper(None, Some("line_nearness_short"))
    .within(ContextBounds::Clamped(MAX_LINE_REACH))
    .given(&[0.0; 4], (Some(-MAX_LINE_REACH), Some(MAX_LINE_REACH))),
    Row::of_pass(
        "line_nearness_short",
        "vec4f",
        ("line_nearness_short", "texel"),
        "the same within half as far, nearer than that reach",
    )
    .labeled("nearness of edges")
    .within(ContextBounds::Clamped(MAX_LINE_REACH))
    .given(&[0.0; 4], (Some(-MAX_LINE_REACH), Some(MAX_LINE_REACH))),
    Row::of_pass(
        "middle_surface",
        "vec2f",
        ("facets", "vec2f(texel.z, floor(abs(texel.w)))"),
        "the depth of what the middle of the pixel shows, in scene units, and the number of its \
         object, from 1 on; 0 where nothing is",
    )
    .within(ContextBounds::Within(4.0 * MAX_PLACE))
    .given(&[0.0; 2], (Some(0.0), None)),
    Row::of_pass(
        "hidden_nearness",
        "vec4f",
        ("hidden_nearness", "texel"),
        "how much nearer than the reach of lines the nearest edges of what lies behind the first \
         surface are, by kind, in pixels; 0 where none is near",
    )
    .labeled("nearness of hidden edges")
    .within(ContextBounds::Clamped(MAX_LINE_REACH))
    .given(&[0.0; 4], (Some(-MAX_LINE_REACH), Some(MAX_LINE_REACH))),
    // A sample has no surroundings.
    Row::of_pass(
        "near_shares",
        "vec4f",
        ("near_shares", "texel"),
        "how much of what the surface looks out at stands within 2 to 256 steps of 1/800 of the \
         picture's height, as the picture shows it: two shares packed in each number",
    )
    .labeled("what stands near")
    .within(ContextBounds::Clamped(MAX_PACKED))
    .given(&[0.0; 4], (Some(0.0), Some(MAX_PACKED))),
    Row::host(
        "camera_from_world",
        "mat3x3f",
        (Frame, |host| Value::matrix(&host.camera_from_world.to_cols_array_2d())),
        "the rotation from world to camera axes",
        "rotation from world to camera axes: x right, y up, z toward the viewer",
    )
    .within(ContextBounds::Unit)
    .follows(&[Camera]),
    Row::host(
        "object_id",
        "f32",
        (Object, |host| Value::Float(host.object_id)),
        "counts objects from 0",
        "counts objects from 0",
    )
    .within(ContextBounds::Count),
    Row::host("time", "f32", (Frame, |host| Value::Float(host.time)), "seconds", "seconds")
        .follows(&[Time]),
    Row::host(
        "frame",
        "f32",
        (Frame, |host| Value::Float(host.frame)),
        "frames since the start of the time range",
        "frames since the start of the time range",
    )
    .follows(&[Time]),
    Row::host(
        "viewport",
        "vec2f",
        (Frame, |host| Value::vec(&host.viewport)),
        "width and height in pixels",
        "width and height in pixels",
    )
    .within(ContextBounds::Count),
    Row::fragment(
        "pixel",
        "vec2f",
        "in.clip.xy * view.screen.xy + view.screen.zw",
        "the pixel's place from the picture's upper left corner, x to the right and y down, in \
         pixels; centers lie at halves",
    )
    .within(ContextBounds::Within(MAX_COORDINATE))
    .given(&[0.0, 0.0], (None, None)),
    Row::fragment(
        "anchor",
        "vec3f",
        concat!(
            "anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, \
             1.0)).xyz, view.eye.w, ",
            view_scale!(),
            ")"
        ),
        "where the object's origin is seen from the picture's middle, x to the right and y down, \
         and how large a unit of \
         the scene is seen there; in picture heights",
    )
    .within(ContextBounds::Clamped(MAX_ON_SCREEN))
    .given(&[0.0, 0.0, 1.0], (None, None)),
    Row::fragment(
        "magnification",
        "f32",
        concat!(
            "size_on_screen(-(view.camera_from_world * vec4f(in.position, 1.0)).z, view.eye.w, ",
            view_scale!(),
            ")"
        ),
        "how large a unit of the scene is seen at this distance, in picture heights",
    )
    .within(ContextBounds::Clamped(MAX_ON_SCREEN))
    .given(&[1.0], (Some(0.0), Some(4.0))),
    Row::fragment(
        "world_from_normal",
        "mat3x3f",
        "object.world_from_normal",
        "turns normals and gradients of the object's own space into world space",
    )
    .within(ContextBounds::Within(MAX_NORMAL_SCALE))
    .sampled(&[], |_| Value::matrix(&DMat3::IDENTITY.to_cols_array_2d())),
    Row::derived(
        "pixel_across",
        "vec3f",
        "dpdx(in.position)",
        "from the fragment's place on the surface to that of its neighbor to the right, world \
         space",
    )
    .within(ContextBounds::Within(4.0 * MAX_PLACE))
    .sampled(&[], |_| vec3(DVec3::ZERO)),
    Row::derived(
        "pixel_down",
        "vec3f",
        "dpdy(in.position)",
        "from the fragment's place on the surface to that of its neighbor below, world space",
    )
    .within(ContextBounds::Within(4.0 * MAX_PLACE))
    .sampled(&[], |_| vec3(DVec3::ZERO)),
    Row::derived(
        "normal_across",
        "vec3f",
        "dpdx(normal)",
        "from the fragment's normal to that of its neighbor to the right, world space",
    )
    .within(ContextBounds::Within(2.0))
    .sampled(&[], |_| vec3(DVec3::ZERO)),
    Row::derived(
        "normal_down",
        "vec3f",
        "dpdy(normal)",
        "from the fragment's normal to that of its neighbor below, world space",
    )
    .within(ContextBounds::Within(2.0))
    .sampled(&[], |_| vec3(DVec3::ZERO)),
    Row::scene("casters", "Casters", "the triangles of all objects that cast shadows"),
    Row::scene_pass("shadow_map", "ShadowMaps", "what lights see first"),
    Row::scene_pass("shadow_map_behind", "ShadowMaps", "what lights see behind the first object"),
];
