//! The script `scene.js`: the mesh that wears the look, the camera and the backdrop.
//!
//! Vertices are as they are in the mesh, since a look may read their positions in object space; the
//! transform that fits the mesh stands beside them. Arrays are base64 of little-endian numbers.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::{DMat4, DQuat};
use serde_json::{Value, json};

use super::Page;
use crate::document::{Camera, Projection};
use crate::export::pretty::pretty;
use crate::frame::SetupObject;
use crate::geometry::{Mesh, MeshPart};

/// The script of the scene; `made` is its first line.
pub(super) fn script(page: &Page<'_>, made: &str) -> String {
    let scene = &page.setup.scene;
    let turn = DQuat::from_array(scene.illumination);
    let described = json!({
        "camera": camera(&scene.camera),
        "backdrop": scene.backdrop,
        "illumination": glam::DMat3::from_quat(turn).to_cols_array(),
        "mesh": page.setup.objects.first().map(|object| mesh(object, page)),
    });
    format!("// {made}\nconst scene = {};\n", pretty(&described).trim_end())
}

fn camera(camera: &Camera) -> Value {
    json!({
        "eye": camera.eye, "target": camera.target, "up": camera.up,
        "parallel": camera.projection == Projection::Orthographic,
        "fov": camera.fov, "height": camera.height, "aspect": camera.aspect,
    })
}

fn mesh(object: &SetupObject, page: &Page<'_>) -> Value {
    let mesh: &Mesh = &object.mesh;
    let part = |(material, part): (usize, &MeshPart)| {
        json!({
            "first": part.indices.start, "count": part.indices.len(),
            "twoSided": part.two_sided, "material": material,
        })
    };
    let attributes = page.attributes.iter().filter_map(|name| Some((*name, array(mesh, name)?)));
    let matrix: DMat4 = object.world_from_object;
    json!({
        "worldFromObject": matrix.to_cols_array(),
        "middle": mesh.bounds().center().to_array(),
        "sphere": {"center": object.center().to_array(), "radius": object.radius()},
        "parts": mesh.parts.iter().enumerate().map(part).collect::<Vec<_>>(),
        "attributes": attributes.map(|(name, text)| (name.to_owned(), text.into())).collect::<
            serde_json::Map<_, _>,
        >(),
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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::document::Look;
    use crate::frame::{Assets, Setup, SetupLook, default_setup};

    fn setup_of(shape: &str) -> Setup {
        let loaded = Look::read(r#"{"nodes": [{"kind": "output"}]}"#, "a.json");
        let (look, source) = (loaded.value.unwrap(), loaded.source.into());
        let look = SetupLook { look, source, folder: Path::new("").into() };
        default_setup(look, &format!("shape:{shape}"), &mut Assets::default()).unwrap().value
    }

    fn script_of(setup: &Setup, attributes: &[&str]) -> String {
        let attributes = attributes.iter().copied().collect();
        let (images, parameters) = (&[][..], Vec::new());
        let page = Page { title: "A", stem: "a", setup, attributes, images, parameters };
        script(&page, "A: made by Chiaro.")
    }

    /// Arrays of the script are the mesh's own numbers.
    #[test]
    fn arrays_are_the_meshes_numbers() {
        let setup = setup_of("sphere");
        let text = script_of(&setup, &["normal", "position", "uv"]);
        let json = text.split_once("const scene = ").unwrap().1.trim().trim_end_matches(';');
        let scene: Value = serde_json::from_str(json).unwrap();
        let mesh = &setup.objects[0].mesh;
        let array = |name: &str| STANDARD.decode(name).unwrap();
        let attributes = &scene["mesh"]["attributes"];
        let numbers: Vec<f32> = array(attributes["uv"].as_str().unwrap())
            .chunks_exact(4)
            .map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()))
            .collect();
        assert_eq!(numbers, mesh.uvs.as_flattened());
        assert!(attributes["tangent"].is_null(), "what no module reads is left out");
        assert_eq!(scene["mesh"]["parts"][0]["count"], mesh.indices.len());
        if let Ok(out) = std::env::var("DEV_SCENE") {
            for shape in ["creature", "knot", "sphere", "plane"] {
                let text = script_of(&setup_of(shape), &["normal", "position", "uv", "tangent", "color"]);
                std::fs::write(format!("{out}/{shape}.js"), text).unwrap();
            }
        }
    }
}
