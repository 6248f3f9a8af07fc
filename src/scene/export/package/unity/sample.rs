//! The sample: a scene that shows the look on a mesh, as Unity's text files.

use std::fmt::Write as _;

use glam::{DMat3, DQuat, DVec3};

use super::images::{UnityImage, references};
use super::parameters::{light_field, shown};
use crate::document::{LightKind, LightSpace, Projection};
use crate::export::ExportFile;
use crate::export::host_code::CSHARP;
use crate::export::package::PackageRequest;
use crate::export::package::stable_id::stable_id;
use crate::export::program::LightSetting;
use crate::geometry::Mesh;

/// The folder of the sample, which Unity copies into a project.
pub(super) const FOLDER: &str = "Samples~/Scene";

/// Text with which Unity's files begin.
const HEAD: &str = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

/// The scene, its mesh and the files by which Unity knows them.
pub(super) fn files(
    request: &PackageRequest<'_>,
    class: &str,
    images: &[UnityImage<'_>],
    has_tangents: bool,
) -> Vec<ExportFile> {
    let stem = request.stem;
    let (scene_name, mesh_name) =
        (format!("{FOLDER}/{class}.unity"), format!("{FOLDER}/{stem}.mesh.asset"));
    let mesh_meta = format!(
        "fileFormatVersion: 2\nguid: {}\nNativeFormatImporter:\n  externalObjects: {{}}\n  \
         mainObjectFileID: 4300000\n",
        stable_id(stem, &mesh_name)
    );
    let scene_meta = format!(
        "fileFormatVersion: 2\nguid: {}\nDefaultImporter:\n  externalObjects: {{}}\n",
        stable_id(stem, &scene_name)
    );
    let scene = scene(request, class, images, &stable_id(stem, &mesh_name));
    vec![
        ExportFile::text(format!("{scene_name}.meta"), scene_meta),
        ExportFile::text(scene_name, scene),
        ExportFile::text(format!("{mesh_name}.meta"), mesh_meta),
        ExportFile::text(mesh_name, mesh(&request.scene.mesh, has_tangents)),
    ]
}

/// The mesh with x mirrored, as Unity's importers turn meshes; triangles turn around with it.
fn mesh(mesh: &Mesh, has_tangents: bool) -> String {
    let has_colors = !mesh.colors.is_empty();
    let mut vertices = String::new();
    for index in 0..mesh.positions.len() {
        let ([x, y, z], [nx, ny, nz]) = (mesh.positions[index], mesh.normals[index]);
        push(&mut vertices, &[-x, y, z, -nx, ny, nz]);
        if has_tangents {
            let [x, y, z, side] = mesh.tangents[index];
            push(&mut vertices, &[-x, y, z, -side]);
        }
        if has_colors {
            push(&mut vertices, &mesh.colors[index]);
        }
        push(&mut vertices, &mesh.uvs[index]);
    }
    // Position, normal, tangent, color, eight places in images, and what bones need.
    let dimensions = [3, 3, 4 * u32::from(has_tangents), 4 * u32::from(has_colors), 2];
    let mut channels = String::new();
    let mut offset = 0;
    for index in 0..14 {
        let dimension = dimensions.get(index).copied().unwrap_or_default();
        let at = if dimension == 0 { 0 } else { offset };
        let _ = write!(
            channels,
            "    - stream: 0\n      offset: {at}\n      format: 0\n      dimension: {dimension}\n"
        );
        offset += 4 * dimension;
    }
    let count = mesh.positions.len();
    let is_small = count <= 0xffff;
    let mut indices = String::new();
    for corners in mesh.indices.chunks_exact(3) {
        for corner in [corners[0], corners[2], corners[1]] {
            let bytes = corner.to_le_bytes();
            for byte in &bytes[..if is_small { 2 } else { 4 }] {
                let _ = write!(indices, "{byte:02x}");
            }
        }
    }
    let bounds = mesh.bounds();
    let [center, extent] = [bounds.center(), 0.5 * (bounds.max - bounds.min)];
    let bounds = |indent: &str| {
        let center = vector(DVec3::new(-center.x, center.y, center.z));
        format!("{indent}m_Center: {center}\n{indent}m_Extent: {}\n", vector(extent))
    };
    format!(
        "{HEAD}--- !u!43 &4300000\nMesh:\n  m_ObjectHideFlags: 0\n  m_Name: {}\n  \
         serializedVersion: 10\n  m_SubMeshes:\n  - serializedVersion: 2\n    firstByte: 0\n    \
         indexCount: {}\n    topology: 0\n    baseVertex: 0\n    firstVertex: 0\n    \
         vertexCount: {count}\n    localAABB:\n{}  m_MeshCompression: 0\n  m_IsReadable: 1\n  \
         m_KeepVertices: 1\n  m_KeepIndices: 1\n  m_IndexFormat: {}\n  m_IndexBuffer: {indices}\n  \
         m_VertexData:\n    serializedVersion: 3\n    m_VertexCount: {count}\n    m_Channels:\n\
         {channels}    m_DataSize: {}\n    _typelessdata: {vertices}\n  m_LocalAABB:\n{}",
        name(&mesh.name),
        mesh.indices.len(),
        bounds("      "),
        i32::from(!is_small),
        offset as usize * count,
        bounds("    "),
    )
}

/// A name that needs no quotes.
fn name(text: &str) -> String {
    let kept: String = text.chars().filter(|c| c.is_ascii_alphanumeric()).collect();
    if kept.is_empty() { "Mesh".to_owned() } else { kept }
}

/// Numbers as hexadecimal bytes.
fn push(text: &mut String, numbers: &[f32]) {
    for byte in numbers.iter().flat_map(|x| x.to_le_bytes()) {
        let _ = write!(text, "{byte:02x}");
    }
}

/// The scene: the mesh with the component, a camera, and a light that one of the look's follows.
fn scene(
    request: &PackageRequest<'_>,
    class: &str,
    images: &[UnityImage<'_>],
    mesh: &str,
) -> String {
    let light = request.work.lights.iter().find(|light| follows(light));
    let mut text = HEAD.to_owned();
    let (scale, turn, place) = request.scene.world_from_object.to_scale_rotation_translation();
    text += &object(1, "Look", &[2, 3, 4, 5]);
    let mirrored_turn = DQuat::from_xyzw(turn.x, -turn.y, -turn.z, turn.w);
    text += &transform(2, 1, mirrored(place), mirrored_turn, scale, 0);
    let _ = write!(
        text,
        "--- !u!33 &3\nMeshFilter:\n  m_GameObject: {{fileID: 1}}\n  \
         m_Mesh: {{fileID: 4300000, guid: {mesh}, type: 2}}\n\
         --- !u!23 &4\nMeshRenderer:\n  m_GameObject: {{fileID: 1}}\n  m_Enabled: 1\n  \
         m_CastShadows: 1\n  m_Materials:\n  - {{fileID: 0}}\n\
         --- !u!114 &5\nMonoBehaviour:\n  m_GameObject: {{fileID: 1}}\n  m_Enabled: 1\n  \
         m_Script: {{fileID: 11500000, guid: {}, type: 3}}\n",
        stable_id(request.stem, &format!("{class}Look.cs"))
    );
    for (field, reference) in references(request.stem, images) {
        let _ = writeln!(text, "  {field}: {reference}");
    }
    if let Some(light) = light {
        let _ = writeln!(text, "  {}: {{fileID: 22}}", light_field(light.id.as_str()));
    }
    text += &camera(request);
    if let Some(light) = light {
        text += &light_object(request, light);
    }
    text
}

/// True if a light of the scene can be where the light is: far away, turned with the world.
fn follows(light: &LightSetting) -> bool {
    let is_of_world = matches!(light.light.space, LightSpace::World | LightSpace::Illumination);
    is_of_world && light.light.kind == LightKind::Directional
}

fn camera(request: &PackageRequest<'_>) -> String {
    let camera = &request.scene.camera;
    let (eye, target) = (DVec3::from(camera.eye), DVec3::from(camera.target));
    let turn = facing(mirrored(target - eye), mirrored(DVec3::from(camera.up)));
    let is_parallel = camera.projection == Projection::Orthographic;
    let [r, g, b] = request.scene.backdrop.unwrap_or([0.3; 3]);
    let mut text = object(10, "Camera", &[11, 12]);
    text += &transform(11, 10, mirrored(eye), turn, DVec3::ONE, 1);
    let _ = write!(
        text,
        "--- !u!20 &12\nCamera:\n  m_GameObject: {{fileID: 10}}\n  m_Enabled: 1\n  \
         m_ClearFlags: 2\n  m_BackGroundColor: {{r: {r}, g: {g}, b: {b}, a: 1}}\n  \
         near clip plane: 0.05\n  far clip plane: {}\n  field of view: {}\n  orthographic: {}\n  \
         orthographic size: {}\n",
        10.0 * (1.0 + eye.length()),
        camera.fov.to_degrees(),
        i32::from(is_parallel),
        0.5 * camera.height,
    );
    text
}

/// A light of the scene as the look's own is.
fn light_object(request: &PackageRequest<'_>, light: &LightSetting) -> String {
    let described = serde_json::json!(light.light);
    let numbers = |field: &str| {
        let list = described[field].as_array().cloned().unwrap_or_default();
        let number = |index: usize| list.get(index).and_then(serde_json::Value::as_f64);
        [0, 1, 2].map(|index| number(index).unwrap_or_default())
    };
    let direction = DVec3::from(numbers("direction"));
    let turn = facing(mirrored(-direction), DVec3::Y);
    let [r, g, b] = numbers("color").map(|x| shown(x, request));
    let intensity = described["intensity"].as_f64().unwrap_or(1.0);
    let mut text = object(20, &CSHARP.function_name(&light.member), &[21, 22]);
    text += &transform(21, 20, 3.0 * mirrored(direction), turn, DVec3::ONE, 2);
    let _ = write!(
        text,
        "--- !u!108 &22\nLight:\n  m_GameObject: {{fileID: 20}}\n  m_Enabled: 1\n  m_Type: 1\n  \
         m_Color: {{r: {r}, g: {g}, b: {b}, a: 1}}\n  m_Intensity: {intensity}\n"
    );
    text
}

/// A thing of the scene with its components.
fn object(id: u32, name: &str, components: &[u32]) -> String {
    let components: String =
        components.iter().map(|id| format!("  - component: {{fileID: {id}}}\n")).collect();
    format!(
        "--- !u!1 &{id}\nGameObject:\n  serializedVersion: 6\n  m_Component:\n{components}  \
         m_Layer: 0\n  m_Name: {name}\n  m_TagString: {}\n  m_IsActive: 1\n",
        if name == "Camera" { "MainCamera" } else { "Untagged" }
    )
}

fn transform(id: u32, object: u32, place: DVec3, turn: DQuat, scale: DVec3, order: u32) -> String {
    // Zeros without a sign.
    let [x, y, z, w] = turn.to_array().map(|x| x as f32 + 0.0);
    format!(
        "--- !u!4 &{id}\nTransform:\n  m_GameObject: {{fileID: {object}}}\n  \
         serializedVersion: 2\n  m_LocalRotation: {{x: {x}, y: {y}, z: {z}, w: {w}}}\n  \
         m_LocalPosition: {}\n  m_LocalScale: {}\n  m_Children: []\n  m_Father: {{fileID: 0}}\n  \
         m_RootOrder: {order}\n",
        vector(place),
        vector(scale)
    )
}

fn vector(v: DVec3) -> String {
    let v = v.as_vec3() + glam::Vec3::ZERO;
    format!("{{x: {}, y: {}, z: {}}}", v.x, v.y, v.z)
}

/// A vector of the look's space in Unity's.
fn mirrored(v: DVec3) -> DVec3 {
    DVec3::new(-v.x, v.y, v.z)
}

/// The turn that brings Unity's z to `forward` and y near `up`.
fn facing(forward: DVec3, up: DVec3) -> DQuat {
    let forward = forward.normalize_or(DVec3::Z);
    let side = up.cross(forward);
    let right = if side.length() > 1e-6 { side.normalize() } else { DVec3::X };
    DQuat::from_mat3(&DMat3::from_cols(right, forward.cross(right), forward))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_bring_axes_where_they_are_wanted() {
        let turn = facing(DVec3::new(1.0, 0.0, -2.0), DVec3::Y);
        let forward = turn * DVec3::Z;
        assert!(forward.distance(DVec3::new(1.0, 0.0, -2.0).normalize()) < 1e-12, "{forward}");
        assert!((turn * DVec3::Y).distance(DVec3::Y) < 1e-12);
        assert!((facing(DVec3::Y, DVec3::Y) * DVec3::Z).distance(DVec3::Y) < 1e-12);
    }

    #[test]
    fn names_need_no_quotes() {
        assert_eq!([name("a: b"), name("…")], ["ab", "Mesh"]);
    }
}
