//! The example's scene: mesh, camera and backdrop.

use super::super::super::ExportFile;
use super::super::rust::{Template, float, structure, wide};
use super::super::{PackageRequest, PackageScene};
use crate::document::Projection;

/// The file of the scene and that of the mesh.
pub(super) fn files(request: &PackageRequest<'_>, mut template: Template) -> [ExportFile; 2] {
    let scene = request.scene;
    let matrix = scene.world_from_object.to_cols_array_2d().map(|column| {
        let numbers: Vec<String> = column.into_iter().map(float).collect();
        format!("    [{}],\n", numbers.join(", "))
    });
    template.place("world_from_object", format!("[\n{}]", matrix.concat()));
    let backdrop = match scene.backdrop {
        None => "wgpu::Color::TRANSPARENT".to_owned(),
        Some([r, g, b]) => {
            format!("wgpu::Color {{ r: {r:?}, g: {g:?}, b: {b:?}, a: 1.0 }}")
        }
    };
    template.place("backdrop", backdrop);
    template.lines("camera", camera(scene));
    let mut bytes = Vec::new();
    let (mut arrays, mut fields) = (Vec::new(), Vec::new());
    let mesh = &scene.mesh;
    bytes.extend((mesh.positions.len() as u32).to_le_bytes());
    bytes.extend((mesh.indices.len() as u32).to_le_bytes());
    let mut array = |name: &str, field: &str, width: usize, numbers: Vec<f32>| {
        if name != "position" && !template.has(name) {
            return;
        }
        arrays.push(format!("let {field} = take::<{width}>(&mut rest, vertices);"));
        if name != "position" {
            fields.push(format!("{field}: &{field}"));
        }
        bytes.extend(numbers.into_iter().flat_map(f32::to_le_bytes));
    };
    array("position", "positions", 3, mesh.positions.iter().flatten().copied().collect());
    array("normal", "normals", 3, mesh.normals.iter().flatten().copied().collect());
    array("tangent", "tangents", 4, mesh.tangents.iter().flatten().copied().collect());
    array("uv", "uvs", 2, mesh.uvs.iter().flatten().copied().collect());
    array("color", "colors", 4, mesh.all_colors().iter().flatten().copied().collect());
    bytes.extend(mesh.indices.iter().flat_map(|index| index.to_le_bytes()));
    template.lines("arrays", arrays);
    let part = |part: &crate::geometry::MeshPart| {
        let (range, is_two_sided) = (&part.indices, part.two_sided);
        format!("MeshPart {{ indices: {range:?}, is_two_sided: {is_two_sided} }}")
    };
    let parts: Vec<String> = mesh.parts.iter().map(part).collect();
    let mut lines = wide("let parts = [", &parts.join(", "), "];", 4).unwrap_or_else(|| {
        let parts = parts.iter().map(|part| format!("    {part},"));
        std::iter::once("let parts = [".to_owned()).chain(parts).chain(["];".to_owned()]).collect()
    });
    // In one line, in two, or a member a line, as rustfmt has it.
    let mut members = vec!["positions: &positions".to_owned()];
    members.extend(fields);
    members.extend(["indices: &indices".to_owned(), "parts: &parts".to_owned()]);
    let data = format!("MeshData {{ {} }};", members.join(", "));
    let in_one = wide("let data = ", &data, "", 4);
    let in_two = || Some(["let data =".to_owned()].into_iter().chain(wide("    ", &data, "", 4)?));
    let form = in_one.or_else(|| Some(in_two()?.collect()));
    lines.extend(form.unwrap_or_else(|| structure("let data = MeshData", &members, ";", 4)));
    template.lines("parts", lines);
    [
        template.file("examples/show/scene.rs", include_str!("template/example_scene.rs.in")),
        ExportFile { name: "examples/show/mesh.bin".to_owned(), bytes },
    ]
}

/// The body of the function that makes the camera.
fn camera(scene: &PackageScene) -> Vec<String> {
    let camera = &scene.camera;
    let (mesh, matrix) = (&scene.mesh, scene.world_from_object);
    let bounds = mesh.bounds();
    let (scale, ..) = matrix.to_scale_rotation_translation();
    let (middle, radius) =
        (matrix.transform_point3(bounds.center()), bounds.radius * scale.abs().max_element());
    let eye = glam::DVec3::from(camera.eye);
    let backward = (eye - glam::DVec3::from(camera.target)).normalize_or(glam::DVec3::Z);
    let distance = backward.dot(eye - middle);
    let reach = 1.01 * radius.max(1e-6);
    let far = (distance + reach).max(1e-3);
    let (kind, size, near) = match camera.projection {
        Projection::Perspective => ("perspective", camera.fov, (distance - reach).max(far * 1e-3)),
        Projection::Orthographic => ("orthographic", camera.height, distance - reach),
    };
    let name = if kind == "perspective" { "fov" } else { "height" };
    let number = |x: f64| format!("{:?}", (x * 1e6).round() / 1e6);
    let mut lines = vec![
        format!("let eye = {:?};", camera.eye),
        format!("let target = {:?};", camera.target),
        format!("let depths = [{}, {}];", number(near), number(far.max(near + 1e-3))),
    ];
    // A picture that is narrower than the one that the camera was placed for shows as much in
    // width.
    let widened = match camera.aspect {
        aspect if aspect > 0.0 => {
            lines.push(format!("let widened = f64::max({aspect:?} / aspect, 1.0);"));
            if kind == "perspective" {
                lines.push(format!(
                    "let fov = 2.0 * (widened * (0.5 * {size:?}_f64).tan()).atan();"
                ));
            } else {
                lines.push(format!("let height = widened * {size:?};"));
            }
            name.to_owned()
        }
        _ => format!("{size:?}"),
    };
    lines.push(format!("Camera::{kind}(eye, target, {:?}, {widened}, aspect, depths)", camera.up));
    lines
}
