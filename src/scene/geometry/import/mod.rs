//! Import of mesh files: [`import`] takes bytes and a name, so that it also works where there are
//! no paths; [`load`] reads the bytes of a path from [`Files`].
//!
//! Each format has one reader, which gives a [`TriangleSoup`]; those of glTF and PLY read the
//! file in pieces, those of OBJ and STL take it whole. All readers check lengths against
//! [`MAX_FILE_BYTES`], [`MAX_VERTICES`], [`MAX_TRIANGLES`] and the bytes left in the file before
//! they allocate, and report through [`ImportReport`].

mod cursor;
mod gltf;
mod obj;
mod ply;
mod report;
mod source;
mod stl;

use std::io::Cursor;
use std::path::Path;

use chiaro_locale::tr;

use self::report::{ImportProblem, ImportReport};
use self::source::{Source, unreadable};
use super::build::build;
use super::mesh::Mesh;
use super::normals::CREASE_ANGLE;
use super::soup::TriangleSoup;
use crate::diag::{Diagnostic, WithWarnings};
use crate::files::{self, Files, OpenFile};

/// Greatest length of a file (or of a buffer beside a glTF) that is read, in bytes; longer ones are
/// refused.
pub const MAX_FILE_BYTES: u64 = 1 << 30;
/// Greatest number of points, of normals and of UVs in a file; files of more are refused.
pub const MAX_VERTICES: usize = 1 << 24;
/// Greatest number of triangles in a file; files of more are refused.
pub const MAX_TRIANGLES: usize = 1 << 24;

/// Number of bytes at the beginning of a file that tell its format.
const HEAD: u64 = 1 << 10;

/// Greatest coordinate of a vertex: a scene may scale it a million times and still stay within what
/// shaders are promised ([`MAX_PLACE`](crate::library::MAX_PLACE)).
pub(super) const FARTHEST: f32 = 2e12;

/// Radii of meshes that are accepted: squares and cubes of coordinates must fit an f32.
const RADII: std::ops::RangeInclusive<f64> = 1e-12..=1e12;

/// Reader of the files that a glTF names, by their names relative to it; the error says why a file
/// cannot be read.
pub type Siblings<'a> = &'a dyn Fn(&str) -> Result<Box<dyn OpenFile>, String>;

/// The `Siblings` of a file that no other file can lie beside, for [`import`].
///
/// # Errors
/// Always.
pub fn no_siblings(_: &str) -> Result<Box<dyn OpenFile>, String> {
    Err(tr!("only the file itself was given").to_owned())
}

/// Reads a file's `bytes` as the format that the ending of `name` says (obj, ply, stl, gltf, glb),
/// or else its first bytes. `name` is also what diagnostics call the file.
///
/// # Errors
/// Everything that keeps the file from being used, up to a bound.
pub fn import(
    name: &str,
    bytes: &[u8],
    siblings: Siblings,
) -> Result<WithWarnings<Mesh>, Vec<Diagnostic>> {
    import_file(name, Box::new(Cursor::new(bytes)), siblings)
}

/// Imports a file, which is closed before the mesh is built: building takes memory besides.
fn import_file(
    name: &str,
    file: Box<dyn OpenFile + '_>,
    siblings: Siblings,
) -> Result<WithWarnings<Mesh>, Vec<Diagnostic>> {
    let mut report = ImportReport::new(name);
    let source = Source::whole(file).map_err(|why| unreadable(&why).into());
    let soup = match source.and_then(|source| read(name, &source, siblings, &mut report)) {
        Ok(soup) => soup,
        Err(problem) => {
            report.add(*problem);
            TriangleSoup::default()
        }
    };
    report.stop_on_errors()?;
    let mesh = finish(soup, &mut report);
    report.stop_on_errors()?;
    Ok(WithWarnings::new(mesh, report.into_list()))
}

/// [`import`]s the file at `path`; files that a glTF names are read from the same folder.
///
/// # Errors
/// As [`import`], and where the file cannot be read.
pub fn load(files: &dyn Files, path: &Path) -> Result<WithWarnings<Mesh>, Vec<Diagnostic>> {
    let name = path.display().to_string();
    let file = files.open(path, MAX_FILE_BYTES).map_err(|why| {
        let hint = if files.metadata(path).is_some() {
            tr!("name a file that you may read")
        } else {
            tr!("check the spelling and the folder")
        };
        vec![unreadable(&why).in_file(name.as_str()).hint(hint)]
    })?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut mesh = import_file(&name, file, &|sibling| {
        files.open(&folder.join(sibling), MAX_FILE_BYTES).map_err(|why| why.to_string())
    })?;
    mesh.value.file = Some(path.to_owned());
    Ok(mesh)
}

/// The bytes of a picture within the glTF or GLB file at `path`, by its number, undecoded; at most
/// `most_bytes`.
///
/// # Errors
/// The reason why it cannot be read.
pub fn load_image(
    files: &dyn Files,
    path: &Path,
    number: usize,
    most_bytes: u64,
) -> Result<Vec<u8>, Diagnostic> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let open = |path: &Path| files.open(path, MAX_FILE_BYTES);
    let file = open(path).and_then(|file| Source::whole(file).map_err(Into::into));
    let file = file.map_err(|why| unreadable(&why))?;
    let siblings = |name: &str| open(&folder.join(name)).map_err(|why| why.to_string());
    gltf::image_within(&file, number, &siblings, most_bytes).map_err(|problem| *problem)
}

fn read(
    name: &str,
    file: &Source,
    siblings: Siblings,
    report: &mut ImportReport,
) -> Result<TriangleSoup, ImportProblem> {
    if file.length() > MAX_FILE_BYTES {
        let message = tr!(
            "the file has {bytes} bytes, more than the {MAX_FILE_BYTES} allowed",
            bytes = file.length()
        );
        return Err(Diagnostic::error("mesh-too-large", message).into());
    }
    let file_name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let (stem, ending) = file_name.rsplit_once('.').unwrap_or((file_name, ""));
    let head = file.head(HEAD)?;
    if let Some(problem) = foreign(&head, file.length(), ending) {
        return Err(problem.into());
    }
    let mut soup = match ending.to_ascii_lowercase().as_str() {
        "obj" => obj::read(&file.all()?, report),
        "ply" => ply::read(file, report)?,
        "stl" => stl::read(&file.all()?, report),
        "gltf" | "glb" => gltf::read(file, siblings, report)?,
        _ if head.starts_with(b"glTF") => gltf::read(file, siblings, report)?,
        _ if head.starts_with(b"ply\n") || head.starts_with(b"ply\r") => ply::read(file, report)?,
        _ => {
            let message = tr!("`{ending}` is no mesh format that can be read");
            let problem = Diagnostic::error("mesh-format", message);
            return Err(problem.hint(tr!("use an OBJ, PLY, STL, glTF or GLB file")).into());
        }
    };
    if soup.name.is_empty() {
        stem.clone_into(&mut soup.name);
    }
    Ok(soup)
}

/// The error for a file of `length` bytes whose first ones, `head`, show that no reader can read
/// it.
fn foreign(head: &[u8], length: u64, ending: &str) -> Option<Diagnostic> {
    if head.starts_with(b"DRACO") {
        let message = tr!("the mesh is compressed with Draco, which cannot be read");
        let hint = tr!("export without compression, as glTF, OBJ or PLY");
        return Some(Diagnostic::error("mesh-unsupported", message).hint(hint));
    }
    if head.starts_with(b"Ogawa") || ending.eq_ignore_ascii_case("abc") {
        let hint = tr!("write glTF from the same program, which keeps animation");
        let problem = Diagnostic::error("mesh-unsupported", tr!("Alembic cannot be read"));
        return Some(problem.hint(hint));
    }
    let is_binary = ending.eq_ignore_ascii_case("stl") && stl::is_binary(head, length);
    if !is_binary && files::is_utf16(head) {
        let problem = Diagnostic::error("mesh-encoding", tr!("the file is text in UTF-16"));
        return Some(problem.hint(tr!("save it as UTF-8")));
    }
    None
}

/// Builds the mesh and reports what was missing or dropped.
fn finish(soup: TriangleSoup, report: &mut ImportReport) -> Mesh {
    let count = soup.triangles.len();
    if count == 0 {
        let message = if soup.points.is_empty() {
            tr!("the mesh is empty")
        } else {
            tr!("the mesh has points but no faces")
        };
        report.add(
            Diagnostic::error("mesh-empty", message)
                .hint(tr!("export the surface as polygons or triangles")),
        );
        return Mesh::default();
    }
    let (mesh, made) = build(soup, CREASE_ANGLE);
    if mesh.indices.is_empty() {
        report.error("mesh-empty", tr!("none of the {count} triangles has an area"));
        return mesh;
    }
    if made.degenerate > 0 {
        let message = tr!(
            "{left_out} of {count} triangles have no area and were left out",
            left_out = made.degenerate
        );
        report.add(Diagnostic::warning("mesh-degenerate", message));
    }
    let radius = mesh.bounds().radius;
    if !RADII.contains(&radius) {
        let message = tr!(
            "the mesh has a radius of {radius:e} units; only {least:e} to {most:e} can be drawn",
            least = RADII.start(),
            most = RADII.end()
        );
        report.add(
            Diagnostic::error("mesh-scale", message).hint(tr!("scale the mesh where it was made")),
        );
    }
    let far = mesh.positions.iter().flatten().fold(0.0_f32, |far, x| far.max(x.abs()));
    if far > FARTHEST && RADII.contains(&radius) {
        let message = tr!(
            "the mesh reaches to the coordinate {far:e}; only those up to {FARTHEST:e} can be drawn"
        );
        report.add(
            Diagnostic::error("mesh-scale", message).hint(tr!("move the mesh where it was made")),
        );
    }
    if made.normals > 0 {
        let degrees = CREASE_ANGLE.to_degrees().round();
        let message = tr!(
            "normals were made for {corners} corners, with creases above {degrees} degrees",
            corners = made.normals
        );
        report.add(Diagnostic::note("mesh-normals-made", message));
    }
    mesh
}
