//! glTF 2.0, as JSON and GLB: the meshes of the scene in their places, all in one. Skins, morph targets and
//! animations are left out with a note.
//!
//! Where normals are missing the specification asks for flat ones; Chiaro makes smooth ones with creases as for every
//! other format, since most such files are scans and a shading look has little to say on facets. v is turned to run up
//! the image, and vertex colours, which are linear, to display colours, as in all of Chiaro's meshes.

mod accessor;
mod buffers;
mod primitive;

use glam::DMat4;
use gltf::Document;
use gltf::json::Root;

use super::Siblings;
use super::report::Report;
use crate::diag::{Diagnostic, LineColumn};
use crate::geometry::soup::Soup;

/// Extensions without which a file's triangles cannot be read.
const COMPRESSIONS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Reads a glTF or GLB file.
pub(super) fn read(bytes: &[u8], siblings: Siblings, report: &mut Report) -> Soup {
    let mut soup = Soup::default();
    let (json, binary) = if bytes.starts_with(b"glTF") {
        match buffers::chunks(bytes) {
            Ok(chunks) => chunks,
            Err(diagnostic) => {
                report.add(*diagnostic);
                return soup;
            }
        }
    } else {
        (bytes, None)
    };
    let mut skipped = Skipped::default();
    let Some(document) = parse(json, &mut skipped, report) else { return soup };
    let buffers = buffers::load(&document, binary, siblings, report);
    if report.has_errors() {
        return soup;
    }
    let placed = place_meshes(&document, report);
    let primitives = placed.iter().flat_map(|(mesh, world)| mesh.primitives().map(move |p| (p, world)));
    for (primitive, world) in primitives {
        // One is enough: the soup is of no more use, and a mesh may stand in very many places.
        if let Err(diagnostic) = primitive::append(&primitive, world, &buffers, &mut soup, &mut skipped) {
            report.add(*diagnostic);
            return Soup::default();
        }
    }
    skipped.tell(report);
    if let (1, Some(mesh)) = (document.meshes().len(), document.meshes().next()) {
        soup.name = mesh.name().unwrap_or_default().to_owned();
    }
    if report.has_errors() { Soup::default() } else { soup }
}

/// What was left out.
#[derive(Default)]
struct Skipped {
    skins: bool,
    morphs: bool,
    /// Primitives of points or lines.
    other: usize,
}

impl Skipped {
    fn tell(&self, report: &mut Report) {
        if self.skins {
            let message = "skins are left out: the mesh stands as it was modelled";
            report.add(Diagnostic::note("mesh-unsupported", message));
        }
        if self.morphs {
            report
                .add(Diagnostic::note("mesh-unsupported", "morph targets are left out: the mesh has its first shape"));
        }
        if self.other > 0 {
            let message = format!("{} primitives of points or lines are left out", self.other);
            report.add(Diagnostic::note("mesh-unsupported", message));
        }
    }
}

/// Reads and validates the JSON; `None` after an error.
fn parse(json: &[u8], skipped: &mut Skipped, report: &mut Report) -> Option<Document> {
    let mut root: Root = match gltf::json::deserialize::from_slice(json) {
        Ok(root) => root,
        Err(error) => {
            let code = if error.is_eof() { "mesh-truncated" } else { "mesh-syntax" };
            let at = LineColumn { line: error.line() as u32, column: error.column() as u32 };
            report.add(Diagnostic::error(code, format!("the glTF's JSON cannot be read: {error}")).at(at));
            return None;
        }
    };
    for extension in root.extensions_required.iter().filter(|name| COMPRESSIONS.contains(&name.as_str())) {
        let message = format!("the file is compressed with {extension}, which cannot be read");
        report.add(Diagnostic::error("mesh-unsupported", message).hint("export without mesh compression"));
    }
    skipped.skins = !root.skins.is_empty();
    keep_geometry(&mut root);
    if let Some(wrong) = missing_accessor(&root) {
        report.error("mesh-syntax", format!("the glTF is not valid: there is no accessor {wrong}"));
    }
    if report.has_errors() {
        return None;
    }
    match Document::from_json(root) {
        Ok(document) => Some(document),
        Err(gltf::Error::Validation(problems)) => {
            for (path, problem) in problems {
                let diagnostic = Diagnostic::error("mesh-syntax", format!("the glTF is not valid: {problem}"));
                report.add(diagnostic.json_path(path.to_string()));
            }
            None
        }
        Err(error) => {
            report.error("mesh-syntax", format!("the glTF is not valid: {error}"));
            None
        }
    }
}

/// Drops what is not read, so that nothing wrong in it keeps the geometry from being used: textures of a kind that the
/// crate does not know, animations, cameras, skins. Bounds of positions, which many writers leave out, are filled in.
fn keep_geometry(root: &mut Root) {
    // Those left change materials and textures only, or widen what accessors may hold, which is read anyway.
    root.extensions_required.clear();
    root.animations.clear();
    root.skins.clear();
    root.cameras.clear();
    root.textures.clear();
    root.images.clear();
    root.samplers.clear();
    for node in &mut root.nodes {
        (node.camera, node.skin) = (None, None);
    }
    for material in &mut root.materials {
        material.pbr_metallic_roughness = Default::default();
        (material.normal_texture, material.occlusion_texture, material.emissive_texture) = (None, None, None);
    }
    let zero = gltf::json::serialize::to_value([0.0; 3]).ok();
    for accessor in &mut root.accessors {
        (accessor.min, accessor.max) = (zero.clone(), zero.clone());
    }
}

/// An accessor that a primitive names and the file lacks: the crate's validation looks positions up before it checks
/// that they are there.
fn missing_accessor(root: &Root) -> Option<usize> {
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut named = primitives.flat_map(|primitive| primitive.attributes.values()).map(gltf::json::Index::value);
    named.find(|&index| index >= root.accessors.len())
}

/// The meshes of the default scene (else the first; else of all nodes without parent), each with its world transform.
fn place_meshes<'a>(document: &'a Document, report: &mut Report) -> Vec<(gltf::Mesh<'a>, DMat4)> {
    let mut open: Vec<(gltf::Node, DMat4)> = match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => scene.nodes().map(|node| (node, DMat4::IDENTITY)).collect(),
        None => {
            let mut is_child = vec![false; document.nodes().len()];
            for child in document.nodes().flat_map(|node| node.children()) {
                is_child[child.index()] = true;
            }
            document.nodes().filter(|n| !is_child[n.index()]).map(|node| (node, DMat4::IDENTITY)).collect()
        }
    };
    // Depth first in the file's order.
    open.reverse();
    let mut seen = vec![false; document.nodes().len()];
    let mut placed = Vec::new();
    while let Some((node, parent)) = open.pop() {
        if std::mem::replace(&mut seen[node.index()], true) {
            report.error("mesh-syntax", format!("node {} has two parents, or is in itself", node.index()));
            continue;
        }
        let local = DMat4::from_cols_array_2d(&node.transform().matrix().map(|column| column.map(f64::from)));
        let world = parent * local;
        if !world.is_finite() {
            report.error("mesh-not-finite", format!("node {} has a transform that is not finite", node.index()));
            continue;
        }
        placed.extend(node.mesh().map(|mesh| (mesh, world)));
        let children: Vec<_> = node.children().map(|child| (child, world)).collect();
        open.extend(children.into_iter().rev());
    }
    placed
}
