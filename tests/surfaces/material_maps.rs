//! Maps of a mesh's own materials, as images of looks.

use std::io::Cursor;
use std::path::Path;
use std::sync::Arc;

use chiaro::compile::Live;
use chiaro::diag::Diagnostic;
use chiaro::files::MemoryFiles;
use chiaro::frame::{AssetStore, Assets, FramePlan, PlanOptions, Planner, open};
use chiaro::geometry::MaterialMap;
use chiaro::library::Library;
use serde_json::{Value as Json, json};

use crate::geometry_import::base64;
use crate::support::color::{to_linear, to_srgb};

fn png(color: [u8; 4]) -> Vec<u8> {
    let mut png = Cursor::new(Vec::new());
    let image = image::RgbaImage::from_pixel(2, 2, image::Rgba(color));
    image.write_to(&mut png, image::ImageFormat::Png).unwrap();
    png.into_inner()
}

/// Three triangles: one wears a picture within the file, times a factor; one a picture beside it;
/// and one has a plain color.
fn gltf() -> Json {
    let corners: Vec<u8> = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        .iter()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    let data = |bytes: &[u8]| format!("data:application/octet-stream;base64,{}", base64(bytes));
    let drawn = |material: usize| json!({"attributes": {"POSITION": 0}, "material": material});
    json!({
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [drawn(0), drawn(1), drawn(2)]}],
        "materials": [
            {"name": "inside", "pbrMetallicRoughness": {
                "baseColorTexture": {"index": 0}, "baseColorFactor": [0.5, 1, 1, 0.5]}},
            {"name": "beside", "pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}},
            {"name": "plain", "emissiveFactor": [0, 0.25, 0], "pbrMetallicRoughness": {
                "baseColorFactor": [0.2, 0.4, 0.6, 1], "roughnessFactor": 0.3}}
        ],
        "textures": [{"source": 0}, {"source": 1}],
        "images": [{"uri": data(&png([200, 100, 50, 255]))}, {"uri": "a%20skin.png"}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": data(&corners)}],
    })
}

fn planned(mesh: &Json, image: &str) -> Result<FramePlan, Vec<Diagnostic>> {
    let mut files = MemoryFiles::default();
    files.add("meshes/hero.gltf", mesh.to_string());
    files.add("meshes/a skin.png", png([1, 2, 3, 255]));
    let look = json!({"chiaro": "look", "nodes": [
        {"id": "skin", "kind": "image", "values": {"image": image}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "skin", "to": "output.color"}]});
    files.add("look.json", look.to_string());
    let scene = json!({"chiaro": "scene", "objects": [
        {"id": "hero", "mesh": "meshes/hero.gltf", "looks": "look.json"}]});
    files.add("scene.json", scene.to_string());
    let mut assets = Assets::of(&AssetStore::reading_from(Arc::new(files)));
    let setup = open(Path::new("scene.json"), None, &mut assets)?.value;
    let options = PlanOptions { size: [32, 32], samples: 1, time: 0.0 };
    let plan = Planner::new(assets).plan(&setup, Library::built_in(), &Live::Keyed, &options)?;
    Ok(plan.value)
}

/// The first pixel of the image of each part, in the file's order of materials.
fn pixels(mesh: &Json, image: &str) -> Vec<[u8; 4]> {
    let plan = planned(mesh, image).unwrap_or_else(|problems| panic!("{problems:?}"));
    let mut draws: Vec<_> = plan.draws.iter().collect();
    draws.sort_by_key(|draw| draw.indices.start);
    let first = |draw: &&chiaro::frame::Draw| {
        let rgba = draw.images[0].rgba();
        [rgba[0], rgba[1], rgba[2], rgba[3]]
    };
    draws.iter().map(first).collect()
}

#[test]
fn every_part_has_the_picture_of_its_own_material() {
    let encoded = |linear: f64| (to_srgb(linear) * 255.0).round() as u8;
    let dimmed = encoded(to_linear(200.0 / 255.0) * 0.5);
    let plain = [encoded(0.2), encoded(0.4), encoded(0.6), 255];
    let base = pixels(&gltf(), "mesh:base_color");
    assert_eq!(base, [[dimmed, 100, 50, 128], [1, 2, 3, 255], plain]);
    let emissive = pixels(&gltf(), "mesh:emissive");
    assert_eq!(emissive, [[0, 0, 0, 255], [0, 0, 0, 255], [0, encoded(0.25), 0, 255]]);
    // Data is multiplied as it is.
    let rough = pixels(&gltf(), "mesh:metallic_roughness");
    assert_eq!(rough, [[255; 4], [255; 4], [255, 77, 255, 255]]);
    assert_eq!(pixels(&gltf(), "mesh:normal"), [[128, 128, 255, 255]; 3]);
    // A picture within the file can be named by itself, for all parts.
    assert_eq!(pixels(&gltf(), "meshes/hero.gltf#images/0"), [[200, 100, 50, 255]; 3]);
}

#[test]
fn what_cannot_be_read_is_told_and_no_triangle_is_lost() {
    let message = |mesh: &Json, image: &str| {
        let problems = planned(mesh, image).err().unwrap_or_default();
        problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    let told = message(&gltf(), "mesh:base_colour");
    assert!(told.contains("`mesh:base_color`") && told.contains("skin"), "{told}");
    let told = message(&gltf(), "meshes/hero.gltf#images/7");
    assert!(told.contains("picture 7") && told.contains("hero.gltf"), "{told}");
    let mut gone = gltf();
    gone["images"][1]["uri"] = json!("gone.png");
    let told = message(&gone, "mesh:base_color");
    assert!(told.contains("gone.png"), "{told}");
    // Whoever does not look at the picture does not read it.
    assert_eq!(message(&gone, "mesh:normal"), "");
    // Pictures that no rule allows are none, and the triangles are there.
    let mut wrong = gltf();
    wrong["images"] = json!([7, {"uri": "/etc/passwd"}]);
    wrong["textures"][0] = json!("none");
    assert_eq!(pixels(&wrong, "mesh:base_color").len(), 3);
}

#[test]
fn names_of_maps_lead_to_them() {
    for (map, name) in MaterialMap::NAMES {
        assert_eq!((MaterialMap::named(name), map.name()), (Some(map), name));
    }
}
