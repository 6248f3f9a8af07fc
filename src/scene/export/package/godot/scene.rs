//! The scene that shows the look, as Godot's text files: a mesh, a camera, a backdrop.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::{DMat3, DMat4, DVec3, Vec3};

use super::super::PackageRequest;
use super::defaults::camera_axes;
use crate::document::Projection;
use crate::geometry::Mesh;

/// Format of the arrays of a surface: vertices, normals, tangents, texture coordinates and indices,
/// of the second version (Godot 4.2).
const FORMAT: u64 = 1 | 1 << 1 | 1 << 2 | 1 << 4 | 1 << 12 | 1 << 35;

/// The mesh as a resource, which needs no import.
pub(super) fn mesh(mesh: &Mesh) -> String {
    let bounds = mesh.bounds();
    let size = bounds.max - bounds.min;
    let numbers = [bounds.min, size].map(|v| format!("{}, {}, {}", v.x, v.y, v.z));
    let mut vertices: Vec<u8> =
        mesh.positions.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
    for (normal, tangent) in mesh.normals.iter().zip(&mesh.tangents) {
        let [x, y] = octahedral(Vec3::from(*normal));
        let direction = octahedral(Vec3::new(tangent[0], tangent[1], tangent[2]));
        // The half of the second number says on which side the third axis is.
        let across = 0.5 * direction[1].max(1.0 / 32767.0) + 0.5;
        let across = if tangent[3] < 0.0 { 1.0 - across } else { across };
        let words = [x, y, direction[0], across];
        vertices.extend(words.iter().flat_map(|x| ((x * 65535.0).round() as u16).to_le_bytes()));
    }
    // Rows of textures run down in Godot.
    let uvs = mesh.uvs.iter().flat_map(|[u, v]| [*u, 1.0 - v]);
    let uvs: Vec<u8> = uvs.flat_map(f32::to_le_bytes).collect();
    // Fronts are clockwise in Godot.
    let corners = mesh.indices.chunks_exact(3).flat_map(|corner| [corner[0], corner[2], corner[1]]);
    let is_small = mesh.positions.len() <= 0xffff;
    let indices: Vec<u8> = match is_small {
        true => corners.flat_map(|corner| (corner as u16).to_le_bytes()).collect(),
        false => corners.flat_map(u32::to_le_bytes).collect(),
    };
    let data = |bytes: &[u8]| format!("PackedByteArray(\"{}\")", STANDARD.encode(bytes));
    format!(
        "[gd_resource type=\"ArrayMesh\" format=4]\n\n[resource]\n_surfaces = [{{\n\
         \"aabb\": AABB({}, {}),\n\"attribute_data\": {},\n\"format\": {FORMAT},\n\
         \"index_count\": {},\n\"index_data\": {},\n\"primitive\": 3,\n\
         \"uv_scale\": Vector4(0, 0, 0, 0),\n\"vertex_count\": {},\n\"vertex_data\": {}\n}}]\n",
        numbers[0],
        numbers[1],
        data(&uvs),
        mesh.indices.len(),
        data(&indices),
        mesh.positions.len(),
        data(&vertices)
    )
}

/// A direction as two numbers from 0 to 1: the octahedron unfolded to a square.
fn octahedral(direction: Vec3) -> [f32; 2] {
    let n = direction / (direction.abs().element_sum()).max(1e-20);
    let folded = |a: f32, b: f32| (1.0 - b.abs()) * if a >= 0.0 { 1.0 } else { -1.0 };
    let [x, y] = if n.z >= 0.0 { [n.x, n.y] } else { [folded(n.x, n.y), folded(n.y, n.x)] };
    [0.5 * x + 0.5, 0.5 * y + 0.5]
}

/// The scene.
pub(super) fn scene(request: &PackageRequest<'_>) -> String {
    let (scene, stem) = (request.scene, request.stem);
    let name = request.title.replace(['"', '\\', '.', ':', '@', '/', '%'], " ");
    let (axes, eye) = camera_axes(scene);
    let camera = &scene.camera;
    let projection = match camera.projection {
        Projection::Perspective => format!("fov = {}\n", camera.fov.to_degrees()),
        Projection::Orthographic => format!("projection = 1\nsize = {}\n", camera.height),
    };
    let far = 10.0 * (1.0 + eye.length());
    let mut text = format!(
        "[gd_scene load_steps=4 format=3]\n\n\
         [ext_resource type=\"Script\" path=\"{stem}.gd\" id=\"1\"]\n\
         [ext_resource type=\"ArrayMesh\" path=\"{stem}.mesh.tres\" id=\"2\"]\n\n"
    );
    let [r, g, b] = scene.backdrop.unwrap_or([0.3; 3]);
    let _infallible = write!(
        text,
        "[sub_resource type=\"Environment\" id=\"1\"]\nbackground_mode = 1\n\
         background_color = Color({r}, {g}, {b}, 1)\n\n\
         [node name=\"{name}\" type=\"Node3D\"]\n\n\
         [node name=\"Mesh\" type=\"MeshInstance3D\" parent=\".\"]\n\
         transform = {}\nmesh = ExtResource(\"2\")\nscript = ExtResource(\"1\")\n\n\
         [node name=\"Camera\" type=\"Camera3D\" parent=\".\"]\n\
         transform = {}\n{projection}near = 0.05\nfar = {far}\n\n\
         [node name=\"Backdrop\" type=\"WorldEnvironment\" parent=\".\"]\n\
         environment = SubResource(\"1\")\n",
        transform(scene.world_from_object),
        transform(DMat4::from_mat3_translation(axes, eye)),
    );
    text
}

/// A transform as Godot writes it: the rows of its matrix, then the origin.
fn transform(matrix: DMat4) -> String {
    let rows = DMat3::from_mat4(matrix).transpose().to_cols_array();
    let origin: DVec3 = matrix.w_axis.truncate();
    let numbers: Vec<String> =
        rows.into_iter().chain(origin.to_array()).map(|x| format!("{}", x as f32)).collect();
    format!("Transform3D({})", numbers.join(", "))
}

/// The project, so that the folder opens by itself.
pub(super) fn project(request: &PackageRequest<'_>) -> String {
    let name = request.title.replace(['"', '\\'], "");
    format!(
        "; {}: made by Chiaro {}, a project of Godot 4.\n\nconfig_version=5\n\n[application]\n\n\
         config/name=\"{name}\"\nrun/main_scene=\"res://{}.tscn\"\n\
         config/features=PackedStringArray(\"4.6\", \"GL Compatibility\")\n\n[display]\n\n\
         window/size/viewport_width=800\nwindow/size/viewport_height=800\n\n[rendering]\n\n\
         renderer/rendering_method=\"gl_compatibility\"\n\
         renderer/rendering_method.mobile=\"gl_compatibility\"\nanti_aliasing/quality/msaa_3d=2\n",
        request.title,
        env!("CARGO_PKG_VERSION"),
        request.stem
    )
}
