//! The script `scene.js`: the mesh that wears the look, the camera and the backdrop.
//!
//! Vertices are as they are in the mesh, since a look may read their positions in object space; the
//! transform that fits the mesh stands beside them. Arrays are base64 of little-endian numbers.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Map, Value, json};

use super::super::super::pretty::pretty;
use super::super::{PackageRequest, PackageScene};
use crate::document::{Camera, Projection};
use crate::geometry::{Mesh, MeshPart};

/// The script of the scene; `made` is its first line.
pub(super) fn script(request: &PackageRequest<'_>, made: &str) -> String {
    let scene = request.scene;
    let entries = request.description.modules.iter().flat_map(|module| &module.entry_points);
    let attributes = entries.flat_map(|entry| entry.attributes.iter().map(|it| it.name.as_str()));
    let described = json!({
        "camera": camera(&scene.camera),
        "backdrop": scene.backdrop,
        "illumination": glam::DMat3::IDENTITY.to_cols_array(),
        "mesh": mesh(scene, attributes),
    });
    let place = super::place(request);
    format!("// {made}\n{place}scene = {};\n", pretty(&described).trim_end())
}

fn camera(camera: &Camera) -> Value {
    json!({
        "eye": camera.eye, "target": camera.target, "up": camera.up,
        "parallel": camera.projection == Projection::Orthographic,
        "fov": camera.fov, "height": camera.height, "aspect": camera.aspect,
    })
}

/// The mesh with those attributes that shaders read.
fn mesh<'a>(scene: &PackageScene, attributes: impl Iterator<Item = &'a str>) -> Value {
    let mesh: &Mesh = &scene.mesh;
    let (matrix, bounds) = (scene.world_from_object, mesh.bounds());
    let (scale, ..) = matrix.to_scale_rotation_translation();
    let part = |(material, part): (usize, &MeshPart)| {
        json!({
            "first": part.indices.start, "count": part.indices.len(),
            "twoSided": part.two_sided, "material": material,
        })
    };
    let arrays: Map<String, Value> =
        attributes.filter_map(|name| Some((name.to_owned(), array(mesh, name)?.into()))).collect();
    json!({
        "worldFromObject": matrix.to_cols_array(),
        "middle": bounds.center().to_array(),
        "sphere": {
            "center": matrix.transform_point3(bounds.center()).to_array(),
            "radius": bounds.radius * scale.abs().max_element(),
        },
        "parts": mesh.parts.iter().enumerate().map(part).collect::<Vec<_>>(),
        "attributes": arrays,
        "indices": encoded(mesh.indices.iter().map(|index| index.to_le_bytes())),
    })
}

/// An attribute of all vertices, by the name that shaders have for it; `None` for a name that no
/// mesh has.
fn array(mesh: &Mesh, name: &str) -> Option<String> {
    Some(match name {
        "position" => floats(&mesh.positions),
        "normal" => floats(&mesh.normals),
        "tangent" => floats(&mesh.tangents),
        "uv" => floats(&mesh.uvs),
        "color" => floats(&mesh.all_colors()),
        _ => return None,
    })
}

fn floats<const N: usize>(vectors: &[[f32; N]]) -> String {
    encoded(vectors.iter().flatten().map(|number| number.to_le_bytes()))
}

fn encoded(words: impl Iterator<Item = [u8; 4]>) -> String {
    STANDARD.encode(words.flatten().collect::<Vec<u8>>())
}
