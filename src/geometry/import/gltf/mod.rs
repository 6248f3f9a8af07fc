//! glTF 2.0, as JSON and GLB: the meshes of the scene in their places, all in one. Skins, morph targets and
//! animations are left out with a note.
//!
//! Where normals are missing the specification asks for flat ones; Chiaro makes smooth ones with creases as for every
//! other format, since most such files are scans and a shading look has little to say on facets. v is turned to run up
//! the image, and vertex colours, which are linear, to display colours, as in all of Chiaro's meshes.

mod accessor;
mod buffers;

use glam::{DMat3, DMat4, DVec3};
use gltf::accessor::{DataType, Dimensions};
use gltf::json::Root;
use gltf::material::AlphaMode;
use gltf::mesh::Mode;
use gltf::{Document, Primitive, Semantic};

use super::report::Report;
use super::{MAX_TRIANGLES, MAX_VERTICES, Siblings};
use crate::diag::{Diagnostic, LineColumn};
use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, Material, NONE, Soup};

/// Extensions without which a file's triangles cannot be read.
const COMPRESSIONS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Reads a glTF or GLB file.
pub(super) fn read(bytes: &[u8], siblings: Siblings, report: &mut Report) -> Soup {
    let mut soup = Soup::default();
    let (json, binary) = if bytes.starts_with(b"glTF") {
        match buffers::chunks(bytes) {
            Ok(chunks) => chunks,
            Err(diagnostic) => {
                report.add(diagnostic);
                return soup;
            }
        }
    } else {
        (bytes, None)
    };
    let Some(document) = parse(json, report) else { return soup };
    let buffers = buffers::load(&document, binary, siblings, report);
    if report.has_errors() {
        return soup;
    }
    let placed = place_meshes(&document, report);
    let mut skipped = Skipped::default();
    let primitives = placed.iter().flat_map(|(mesh, world)| mesh.primitives().map(move |p| (p, world)));
    for (primitive, world) in primitives {
        // One is enough: the soup is of no more use, and a mesh may stand in very many places.
        if let Err(diagnostic) = append(&primitive, world, &buffers, &mut soup, &mut skipped) {
            report.add(diagnostic);
            return Soup::default();
        }
    }
    skipped.skins = document.skins().len() > 0;
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
fn parse(json: &[u8], report: &mut Report) -> Option<Document> {
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
    // The others change materials and textures only, or widen what accessors may hold, which is read anyway.
    root.extensions_required.clear();
    match Document::from_json(root) {
        Ok(document) => Some(document).filter(|_| !report.has_errors()),
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

/// Appends one primitive in its place.
fn append(
    primitive: &Primitive,
    world: &DMat4,
    buffers: &[Vec<u8>],
    soup: &mut Soup,
    skipped: &mut Skipped,
) -> Result<(), Diagnostic> {
    if matches!(primitive.mode(), Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) {
        skipped.other += 1;
        return Ok(());
    }
    let Some(positions) = primitive.get(&Semantic::Positions) else { return Ok(()) };
    skipped.morphs |= primitive.morph_targets().len() > 0;
    let indices = primitive.indices();
    let index_count = indices.as_ref().map_or(positions.count(), gltf::Accessor::count);
    let too_large =
        |what: &str, most: usize| Diagnostic::error("mesh-too-large", format!("the scene has more than {most} {what}"));
    if positions.count().saturating_add(soup.points.len()) > MAX_VERTICES {
        return Err(too_large("vertices", MAX_VERTICES));
    }
    let per_triangle = if primitive.mode() == Mode::Triangles { 3 } else { 1 };
    if (index_count / per_triangle).saturating_add(soup.triangles.len()) > MAX_TRIANGLES {
        return Err(too_large("triangles", MAX_TRIANGLES));
    }
    let base = soup.points.len();
    let has = attributes(primitive, world, buffers, soup)?;
    let count = soup.points.len() - base;
    let indices = match indices {
        None => (0..count as u32).collect(),
        Some(accessor) => read_indices(&accessor, count, buffers)?,
    };
    let corner = |i: u32| {
        let at = |first: Option<usize>| first.map_or(NONE, |first| first as u32 + i);
        Corner { point: base as u32 + i, normal: at(has.normals), uv: at(has.uvs) }
    };
    // A transform that mirrors turns triangles inside out.
    let mirrored = DMat3::from_mat4(*world).determinant() < 0.0;
    let wind = |[a, b, c]: [u32; 3]| if mirrored { [b, a, c] } else { [a, b, c] }.map(corner);
    match primitive.mode() {
        Mode::TriangleStrip => soup.triangles.extend(
            indices
                .windows(3)
                .enumerate()
                .map(|(k, w)| wind(if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] })),
        ),
        Mode::TriangleFan => {
            soup.triangles.extend(indices.get(1..).unwrap_or(&[]).windows(2).map(|w| wind([indices[0], w[0], w[1]])));
        }
        _ => soup.triangles.extend(indices.chunks_exact(3).map(|t| wind([t[0], t[1], t[2]]))),
    }
    let material = material_of(primitive, soup);
    soup.material_of.resize(soup.triangles.len(), material);
    Ok(())
}

/// The indices of a primitive of `count` vertices.
fn read_indices(accessor: &gltf::Accessor, count: usize, buffers: &[Vec<u8>]) -> Result<Vec<u32>, Diagnostic> {
    let whole = matches!(accessor.data_type(), DataType::U8 | DataType::U16 | DataType::U32);
    if !whole || accessor.dimensions() != Dimensions::Scalar || accessor.normalized() {
        let message = format!("accessor {} holds no indices, but is used as such", accessor.index());
        return Err(Diagnostic::error("mesh-syntax", message));
    }
    let rows = accessor::rows::<1>(accessor, buffers, 0.0)?;
    if let Some([wrong]) = rows.iter().find(|[i]| *i >= count as f64) {
        let message = format!("accessor {} names vertex {wrong}; there are {count}, counted from 0", accessor.index());
        return Err(Diagnostic::error("mesh-index", message));
    }
    Ok(rows.iter().map(|[i]| *i as u32).collect())
}

/// The index of the primitive's material in the soup.
fn material_of(primitive: &Primitive, soup: &mut Soup) -> u32 {
    let material = primitive.material();
    let name = match (material.name(), material.index()) {
        (Some(name), _) if !name.is_empty() => name.to_owned(),
        (_, Some(index)) => format!("material_{index}"),
        (_, None) => DEFAULT_MATERIAL.to_owned(),
    };
    let cutoff = material.alpha_cutoff().unwrap_or(0.5);
    let alpha_cutoff = (material.alpha_mode() == AlphaMode::Mask).then_some(cutoff);
    let wanted = Material { name, two_sided: material.double_sided(), alpha_cutoff };
    let known = soup.materials.iter().position(|m| *m == wanted);
    known.unwrap_or_else(|| {
        soup.materials.push(wanted);
        soup.materials.len() - 1
    }) as u32
}

/// All attributes are of equal length; checked before any is read.
fn check_counts(primitive: &Primitive) -> Result<(), Diagnostic> {
    let mut counts = primitive.attributes().map(|(_, accessor)| accessor.count());
    let first = counts.next().unwrap_or_default();
    if counts.any(|count| count != first) {
        let message = format!("primitive {} has attributes of different counts", primitive.index());
        return Err(Diagnostic::error("mesh-syntax", message));
    }
    Ok(())
}

/// Where a primitive's attributes begin in the soup's lists.
struct Has {
    normals: Option<usize>,
    uvs: Option<usize>,
}

/// Appends the attributes of a primitive's vertices, turned to world space. On an error the soup is of no more use.
fn attributes(primitive: &Primitive, world: &DMat4, buffers: &[Vec<u8>], soup: &mut Soup) -> Result<Has, Diagnostic> {
    check_counts(primitive)?;
    let read3 = |semantic| primitive.get(&semantic).map(|a| accessor::rows::<3>(&a, buffers, 0.0)).transpose();
    let read4 = |semantic| primitive.get(&semantic).map(|a| accessor::rows::<4>(&a, buffers, 1.0)).transpose();
    let positions = read3(Semantic::Positions)?.unwrap_or_default();
    let normals = read3(Semantic::Normals)?;
    let uvs = primitive.get(&Semantic::TexCoords(0)).map(|a| accessor::rows::<2>(&a, buffers, 0.0)).transpose()?;
    let (tangents, colors) = (read4(Semantic::Tangents)?, read4(Semantic::Colors(0))?);
    let count = positions.len();
    let linear = DMat3::from_mat4(*world);
    // The cofactors turn normals rightly under any scale, even where one axis is flattened.
    let cofactors = DMat3::from_cols(
        linear.y_axis.cross(linear.z_axis),
        linear.z_axis.cross(linear.x_axis),
        linear.x_axis.cross(linear.y_axis),
    ) * linear.determinant().signum();
    let side = linear.determinant().signum() as f32;
    let has = Has { normals: normals.as_ref().map(|_| soup.normals.len()), uvs: uvs.as_ref().map(|_| soup.uvs.len()) };
    let base = soup.points.len();
    soup.points.extend(positions.iter().map(|&p| world.transform_point3(p.into()).as_vec3().to_array()));
    // Unit length at once, so that no scale overflows an f32.
    let turn = |m: DMat3, v: DVec3| (m * v).normalize_or_zero().as_vec3();
    soup.normals.extend(normals.iter().flatten().map(|&n| turn(cofactors, n.into()).to_array()));
    soup.uvs.extend(uvs.iter().flatten().map(|&[u, v]| [u as f32, (1.0 - v) as f32]));
    if let Some(tangents) = &tangents {
        soup.tangents.resize(base, [0.0; 4]);
        soup.tangents.extend(tangents.iter().map(|&[x, y, z, w]| {
            turn(linear, DVec3::new(x, y, z)).extend(if w < 0.0 { -side } else { side }).to_array()
        }));
    }
    if let Some(colors) = &colors {
        soup.colors.resize(base, [1.0; 4]);
        soup.colors.extend(colors.iter().map(|&[r, g, b, a]| display(r, g, b, a)));
    }
    if !soup.tangents.is_empty() {
        soup.tangents.resize(soup.points.len(), [0.0; 4]);
    }
    if !soup.colors.is_empty() {
        soup.colors.resize(soup.points.len(), [1.0; 4]);
    }
    let finite = |rows: &[f32]| rows.iter().all(|x| x.is_finite());
    let raw = |rows: &Option<Vec<[f64; 3]>>, i: usize| rows.as_ref().is_none_or(|r| r[i].iter().all(|x| x.is_finite()));
    for i in 0..count {
        let uv = uvs.as_ref().is_none_or(|uvs| uvs[i].iter().all(|x| (*x as f32).is_finite()));
        let tangent = tangents.as_ref().is_none_or(|t| t[i].iter().all(|x| x.is_finite()));
        if !finite(&soup.points[base + i]) || !raw(&normals, i) || !uv || !tangent {
            let message = format!("vertex {i} of primitive {} has numbers that are not finite", primitive.index());
            return Err(Diagnostic::error("mesh-not-finite", message));
        }
    }
    Ok(has)
}

/// Linear to the sRGB curve (IEC 61966-2-1), clamped to 0..1; NaN becomes 0.
fn display(r: f64, g: f64, b: f64, a: f64) -> [f32; 4] {
    let unit = |x: f64| if x > 0.0 { x.min(1.0) } else { 0.0 };
    let encode = |x: f64| {
        let x = unit(x);
        (if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }) as f32
    };
    [encode(r), encode(g), encode(b), unit(a) as f32]
}
