//! glTF 2.0, as JSON and GLB: all meshes of the scene, each in its places, as one mesh, with what
//! its animations move (`motion`).
//!
//! Where normals are missing the specification asks for flat ones; Chiaro makes smooth ones with
//! creases as for every other format, since most such files are scans and a shading look has little
//! to say on facets. v is turned to run up the image, and vertex colors, which are linear, to
//! display colors, as in all of Chiaro's meshes.

mod accessor;
mod buffers;
mod extensions;
mod instances;
mod maps;
mod motion;
mod primitive;

use chiaro_locale::tr;
use glam::DMat4;
use gltf::Document;
use gltf::json::mesh::Semantic;
use gltf::json::validation::{Checked, Error, Validate as _};
use gltf::json::{self, Root};
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Value as Json;

use self::instances::PlacedMesh;
use self::maps::MapsOfFile;
pub(super) use self::maps::image_within;

use super::Siblings;
use super::report::{ImportProblem, ImportReport};
use super::source::Source;
use crate::diag::{Diagnostic, LineColumn};
use crate::geometry::soup::TriangleSoup;

/// The members of a glTF's JSON that say where triangles are. The other members need not even be
/// valid: animations, skins, cameras, textures and additions of later versions and extensions.
#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct GltfMembers {
    asset: Option<json::Asset>,
    accessors: Vec<json::Accessor>,
    buffers: Vec<json::Buffer>,
    buffer_views: Vec<json::buffer::View>,
    scene: Option<json::Index<json::Scene>>,
    scenes: Vec<json::Scene>,
    nodes: Vec<json::Node>,
    meshes: Vec<json::Mesh>,
    materials: Vec<json::Material>,
    textures: Json,
    images: maps::ImageList,
    skins: Vec<IgnoredAny>,
    animations: Vec<IgnoredAny>,
    cameras: Vec<IgnoredAny>,
    extensions_required: Vec<String>,
}

/// Reads a glTF or GLB file.
///
/// # Errors
/// What keeps the file's frame from being read; all else is reported.
pub(super) fn read(
    file: &Source,
    siblings: Siblings,
    report: &mut ImportReport,
) -> Result<TriangleSoup, ImportProblem> {
    let (json, binary) = match file.head(4)?.as_slice() {
        b"glTF" => buffers::chunks(file)?,
        _ => (file.clone(), None),
    };
    let soup = read_document(&json.all()?, binary.as_ref(), siblings, report);
    Ok(if report.has_errors() { TriangleSoup::default() } else { soup })
}

fn read_document(
    json: &[u8],
    binary: Option<&Source>,
    siblings: Siblings,
    report: &mut ImportReport,
) -> TriangleSoup {
    let mut soup = TriangleSoup::default();
    let mut skipped = SkippedParts::default();
    let Some((document, maps)) = parse(json, &mut skipped, report) else { return soup };
    let buffers = buffers::load(&document, binary, siblings, report);
    if report.has_errors() {
        return soup;
    }
    let placed = place_meshes(&document, &buffers, report);
    let moved = skipped.may_move.then(|| motion::read(json, &document, &buffers, report)).flatten();
    let mut recorder = moved.and_then(|(motion, recorder)| {
        soup.motion = Some(motion);
        recorder
    });
    let places =
        placed.iter().flat_map(|placed| placed.places().map(move |place| (&placed.mesh, place)));
    for (primitive, (world, place)) in
        places.flat_map(|(mesh, place)| mesh.primitives().map(move |p| (p, place)))
    {
        let moved = recorder.as_mut().map(|recorder| (recorder, place));
        // One error is enough: the soup is of no more use, and a mesh may stand in very many
        // places.
        if let Err(diagnostic) = primitive::append(
            &primitive,
            (&world, moved),
            (&buffers, &maps),
            &mut soup,
            &mut skipped,
        ) {
            report.add(*diagnostic);
            return TriangleSoup::default();
        }
    }
    if let Some(recorder) = recorder {
        recorder.tell(report);
    }
    skipped.tell(report);
    if let (1, Some(mesh)) = (document.meshes().len(), document.meshes().next()) {
        soup.name = mesh.name().unwrap_or_default().to_owned();
    }
    soup
}

/// Parts of the file that were left out, for the reader's notes.
#[derive(Default)]
struct SkippedParts {
    /// True if the file names something that moves or is moved, or cameras.
    may_move: bool,
    /// Number of primitives of points or lines.
    other: usize,
}

impl SkippedParts {
    fn tell(&self, report: &mut ImportReport) {
        if self.other > 0 {
            let message =
                tr!("{count} primitives of points or lines are left out", count = self.other);
            report.add(Diagnostic::note("mesh-unsupported", message));
        }
    }
}

/// Reads and validates the JSON; `None` after an error.
fn parse(
    json: &[u8],
    skipped: &mut SkippedParts,
    report: &mut ImportReport,
) -> Option<(Document, MapsOfFile)> {
    let file: GltfMembers = match json::deserialize::from_slice(json) {
        Ok(file) => file,
        Err(error) => {
            let code = if error.is_eof() { "mesh-truncated" } else { "mesh-syntax" };
            let at = LineColumn { line: error.line() as u32, column: error.column() as u32 };
            report.add(
                Diagnostic::error(code, tr!("the glTF's JSON cannot be read: {error}")).at(at),
            );
            return None;
        }
    };
    extensions::check(&file, report);
    let mut weights = file.nodes.iter().map(|node| &node.weights);
    let mut of_meshes = file.meshes.iter().map(|mesh| &mesh.weights);
    skipped.may_move = !file.skins.is_empty()
        || !file.animations.is_empty()
        || !file.cameras.is_empty()
        || weights.any(Option::is_some)
        || of_meshes.any(Option::is_some);
    let maps = maps::read(&file, report);
    let Some(root) = geometry_of(file) else {
        let message = tr!("the glTF is not valid: it has no `asset` that tells its version");
        report.error("mesh-syntax", message);
        return None;
    };
    if let Some(wrong) = missing_accessor(&root) {
        report.error("mesh-syntax", tr!("the glTF is not valid: there is no accessor {wrong}"));
    }
    if report.has_errors() {
        return None;
    }
    let mut problems = Vec::new();
    root.validate(&root, json::Path::new, &mut |path, error| {
        problems.push((path().to_string(), error));
    });
    // An accessor without a view is all zeros, which the crate does not know.
    let is_zeros = |path: &str| path.starts_with("accessors[") && path.ends_with("].bufferView");
    problems.retain(|(path, error)| !(*error == Error::Missing && is_zeros(path)));
    if problems.is_empty() {
        return Some((Document::from_json_without_validation(root), maps));
    }
    for (path, problem) in problems {
        let diagnostic = Diagnostic::error("mesh-syntax", tr!("the glTF is not valid: {problem}"));
        report.add(diagnostic.json_path(path));
    }
    None
}

/// The part of a file that is read, as the crate's document; `None` where the file's version is
/// missing. Everything else is dropped, so that nothing wrong there keeps the geometry from being
/// used: textures, cameras and skins that nodes and materials name, and attributes of the maker's
/// own. Bounds of positions, which many writers leave out, are filled in.
fn geometry_of(file: GltfMembers) -> Option<Root> {
    let mut root = Root {
        asset: file.asset?,
        accessors: file.accessors,
        buffers: file.buffers,
        buffer_views: file.buffer_views,
        scene: file.scene,
        scenes: file.scenes,
        nodes: file.nodes,
        meshes: file.meshes,
        materials: file.materials,
        ..Root::default()
    };
    for node in &mut root.nodes {
        (node.camera, node.skin) = (None, None);
    }
    for primitive in root.meshes.iter_mut().flat_map(|mesh| &mut mesh.primitives) {
        let is_own = |name: &Checked<Semantic>| matches!(name, Checked::Valid(Semantic::Extras(_)));
        primitive.attributes.retain(|name, _| !is_own(name));
    }
    for material in &mut root.materials {
        material.pbr_metallic_roughness = Default::default();
        (material.normal_texture, material.occlusion_texture, material.emissive_texture) =
            (None, None, None);
    }
    let zero = json::serialize::to_value([0.0; 3]).ok();
    for accessor in &mut root.accessors {
        (accessor.min, accessor.max) = (zero.clone(), zero.clone());
    }
    Some(root)
}

/// The index of an accessor that a primitive names and the file lacks: the crate's validation looks
/// positions up before it checks that their accessor exists.
fn missing_accessor(root: &Root) -> Option<usize> {
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut named = primitives
        .flat_map(|primitive| primitive.attributes.values())
        .map(gltf::json::Index::value);
    named.find(|&index| index >= root.accessors.len())
}

/// The meshes of the default scene (else of the first scene; else of all nodes without parent),
/// each with its places.
fn place_meshes<'a>(
    document: &'a Document,
    buffers: &[Source],
    report: &mut ImportReport,
) -> Vec<PlacedMesh<'a>> {
    let mut open: Vec<(gltf::Node, DMat4)> =
        match document.default_scene().or_else(|| document.scenes().next()) {
            Some(scene) => scene.nodes().map(|node| (node, DMat4::IDENTITY)).collect(),
            None => {
                let mut is_child = vec![false; document.nodes().len()];
                for child in document.nodes().flat_map(|node| node.children()) {
                    is_child[child.index()] = true;
                }
                document
                    .nodes()
                    .filter(|n| !is_child[n.index()])
                    .map(|node| (node, DMat4::IDENTITY))
                    .collect()
            }
        };
    // Depth first, in the file's order.
    open.reverse();
    let mut seen = vec![false; document.nodes().len()];
    let mut placed = Vec::new();
    let mut drawn = 0;
    while let Some((node, parent)) = open.pop() {
        if std::mem::replace(&mut seen[node.index()], true) {
            report.error(
                "mesh-syntax",
                tr!("node {index} has two parents, or is in itself", index = node.index()),
            );
            continue;
        }
        let local = DMat4::from_cols_array_2d(
            &node.transform().matrix().map(|column| column.map(f64::from)),
        );
        let world = parent * local;
        if !world.is_finite() {
            report.error(
                "mesh-not-finite",
                tr!("node {index} has a transform that is not finite", index = node.index()),
            );
            continue;
        }
        match PlacedMesh::read(document, &node, world, buffers, &mut drawn) {
            Ok(mesh) => placed.extend(mesh),
            Err(problem) => {
                report.add(*problem);
                return Vec::new();
            }
        }
        let children: Vec<_> = node.children().map(|child| (child, world)).collect();
        open.extend(children.into_iter().rev());
    }
    placed
}
