//! Extensions that a glTF asks of its reader beyond the core of 2.0: those that change the
//! triangles are read or refused, never passed over.

use chiaro_locale::tr;
use gltf::json::mesh::Semantic;
use gltf::json::validation::Checked;

use super::GltfMembers;
use super::instances::INSTANCING;
use crate::diag::Diagnostic;
use crate::geometry::import::report::ImportReport;

/// Extensions without which a file's triangles cannot be read.
const COMPRESSIONS: [&str; 3] =
    ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Features whose extensions leave the triangles as they are: beginnings of extensions' names
/// behind the vendor's prefix.
const APPEARANCE: [&str; 4] = ["materials_", "texture_", "lights_", "audio_"];

/// Extensions that are read, or that leave the triangles as they are: they widen the types that
/// accessors may hold, which are read anyway, or add data that Chiaro has no use for.
const HARMLESS: [&str; 16] = [
    INSTANCING,
    "KHR_mesh_quantization",
    "KHR_accessor_float64",
    "KHR_animation_pointer",
    "KHR_interactivity",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_techniques_webgl",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "EXT_instance_features",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "GODOT_single_root",
    "MSFT_lod",
];

/// True if a reader that does not know the extension still shows the triangles rightly.
fn is_harmless(name: &str) -> bool {
    let feature = name.split_once('_').map_or(name, |(_, feature)| feature);
    HARMLESS.contains(&name) || APPEARANCE.iter().any(|start| feature.starts_with(start))
}

/// Reports the extensions without which the file cannot be read.
pub(super) fn check(file: &GltfMembers, report: &mut ImportReport) {
    let required = &file.extensions_required;
    let named =
        COMPRESSIONS.iter().filter(|name| required.iter().any(|required| required == *name));
    let compression = named.copied().next().or_else(|| compression_in_use(file));
    if let Some(name) = compression {
        let message = tr!("the meshes are compressed with {name}, which cannot be read");
        let hint = tr!("export again without mesh compression (Blender: Data > Compression off)");
        report.add(Diagnostic::error("mesh-unsupported", message).hint(hint));
    }
    let is_unknown = |name: &&String| !is_harmless(name) && !COMPRESSIONS.contains(&name.as_str());
    let mut unknown: Vec<&str> = required.iter().filter(is_unknown).map(String::as_str).collect();
    unknown.sort_unstable();
    unknown.dedup();
    if unknown.is_empty() {
        return;
    }
    let (more, names) = (unknown.len().saturating_sub(MAX_NAMED), unknown.iter().take(MAX_NAMED));
    let mut names = names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    if more > 0 {
        names = tr!("{names} and {more} more");
    }
    let message = tr!("the file requires extensions of glTF that cannot be read: {names}");
    let hint = tr!("export without them, or as OBJ or PLY");
    report.add(Diagnostic::error("mesh-unsupported", message).hint(hint));
}

/// Number of unknown extensions that are named in a message.
const MAX_NAMED: usize = 8;

/// The name of a compression that a primitive or a buffer uses though the file does not list it as
/// required: its data is nowhere else.
fn compression_in_use(file: &GltfMembers) -> Option<&'static str> {
    let of_primitive = file.meshes.iter().flat_map(|mesh| &mesh.primitives).find_map(|primitive| {
        let named = &primitive.extensions.as_ref()?.others;
        let position = primitive.attributes.get(&Checked::Valid(Semantic::Positions))?;
        let accessor = file.accessors.get(position.value())?;
        let is_elsewhere = accessor.buffer_view.is_none() && accessor.sparse.is_none();
        COMPRESSIONS.into_iter().find(|name| is_elsewhere && named.contains_key(*name))
    });
    // A buffer without bytes is legal where every view into it says how they are unpacked.
    let of_buffer = || {
        file.buffers.iter().filter(|buffer| buffer.uri.is_none()).find_map(|buffer| {
            let named = &buffer.extensions.as_ref()?.others;
            COMPRESSIONS.into_iter().find(|name| named.contains_key(*name))
        })
    };
    of_primitive.or_else(of_buffer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_changes_no_triangle_may_be_required() {
        for name in [
            "KHR_materials_unlit",
            "KHR_texture_transform",
            "EXT_texture_webp",
            "KHR_lights_punctual",
        ] {
            assert!(is_harmless(name), "{name}");
        }
        for name in
            ["CESIUM_RTC", "KHR_node_visibility", "KHR_draco_mesh_compression", "materials_", ""]
        {
            assert!(!is_harmless(name) || name == "materials_", "{name}");
        }
    }
}
