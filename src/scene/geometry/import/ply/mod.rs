//! PLY, as text and binary of either byte order: polygons and triangle strips; normals, colors and
//! UVs by vertex, UVs by corner. Elements and properties of other names are read and ignored.

mod header;
mod source;

use chiaro_locale::tr;

use self::header::{Element, Encoding, Header};
use self::source::NumberSource;
use super::report::{ImportProblem, ImportReport};
use super::source::Source;
use super::{MAX_TRIANGLES, MAX_VERTICES};
use crate::diag::Diagnostic;
use crate::geometry::import::cursor::NumberType;
use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, NONE, Polygon, TriangleSoup};

/// The names that programs give to a vertex's properties.
const POSITION: [&[&str]; 3] = [&["x"], &["y"], &["z"]];
const NORMAL: [&[&str]; 3] = [&["nx", "normal_x"], &["ny", "normal_y"], &["nz", "normal_z"]];
const UV: [&[&str]; 2] =
    [&["s", "u", "texture_u", "s0", "u0"], &["t", "v", "texture_v", "t0", "v0"]];
const COLOR: [&[&str]; 3] = [
    &["red", "diffuse_red", "r"],
    &["green", "diffuse_green", "g"],
    &["blue", "diffuse_blue", "b"],
];
const ALPHA: [&[&str]; 1] = [&["alpha", "diffuse_alpha", "a"]];
const FACE: &[&str] = &["vertex_indices", "vertex_index"];

/// Reads a PLY file.
///
/// # Errors
/// What keeps the numbers from being read; all else is reported.
pub(super) fn read(
    file: &Source,
    report: &mut ImportReport,
) -> Result<TriangleSoup, ImportProblem> {
    let Some(header) = header::read(file, report)? else { return Ok(TriangleSoup::default()) };
    let mut soup = TriangleSoup::default();
    let mut source = NumberSource::new(file.clone(), &header);
    elements(&header, &mut source, &mut soup, report)?;
    Ok(if report.has_errors() { TriangleSoup::default() } else { soup })
}

fn elements(
    header: &Header,
    source: &mut NumberSource,
    soup: &mut TriangleSoup,
    report: &mut ImportReport,
) -> Result<(), ImportProblem> {
    for element in header.elements.iter().filter(|e| !e.properties.is_empty()) {
        check_counts(element, header.encoding, source)?;
        match element.name.as_str() {
            "vertex" => vertices(element, source, soup, report)?,
            "face" => faces(element, source, soup, report)?,
            "tristrips" => strips(element, source, soup, report)?,
            _ => skip(element, source)?,
        }
    }
    Ok(())
}

/// Refuses counts beyond the bounds, or beyond what the rest of the file can hold, before anything
/// is allocated.
fn check_counts(
    element: &Element,
    encoding: Encoding,
    source: &NumberSource,
) -> Result<(), ImportProblem> {
    let Element { name, count, .. } = element;
    let most = match name.as_str() {
        "vertex" => MAX_VERTICES as u64,
        "face" => MAX_TRIANGLES as u64,
        _ => u64::MAX,
    };
    if *count > most {
        let message = tr!("the file has {count} of `{name}`, more than the {most} allowed");
        return Err(Diagnostic::error("mesh-too-large", message).into());
    }
    let room = source.left() + 1;
    if count.saturating_mul(element.least_bytes(encoding)) > room {
        let message = tr!("the file ends before its {count} of `{name}`");
        return Err(Diagnostic::error("mesh-truncated", message).into());
    }
    Ok(())
}

fn skip(element: &Element, source: &mut NumberSource) -> Result<(), ImportProblem> {
    let mut values = Vec::new();
    for i in 0..element.count {
        for property in &element.properties {
            source.property(property, &mut values, &|| format!("`{}` {i}", element.name))?;
        }
    }
    Ok(())
}

/// The indices of the properties with these names, if the element has all of them.
fn locate<const N: usize>(element: &Element, names: [&[&str]; N]) -> Option<[usize; N]> {
    let found =
        names.map(|names| element.find(names).filter(|&i| element.properties[i].list.is_none()));
    found.iter().all(Option::is_some).then(|| found.map(Option::unwrap_or_default))
}

fn vertices(
    element: &Element,
    source: &mut NumberSource,
    soup: &mut TriangleSoup,
    report: &mut ImportReport,
) -> Result<(), ImportProblem> {
    let Some(position) = locate(element, POSITION) else {
        return Err(Diagnostic::error(
            "mesh-syntax",
            tr!("the vertices have no properties `x`, `y` and `z`"),
        )
        .into());
    };
    let (normal, uv) = (locate(element, NORMAL), locate(element, UV));
    let (color, alpha) = (locate(element, COLOR), locate(element, ALPHA));
    // Whole numbers are scaled from 0 to their greatest value; floats are 0 to 1 already.
    let scales: Vec<f64> =
        element.properties.iter().map(|p| 1.0 / p.number.max().unwrap_or(1.0)).collect();
    let mut row = vec![0.0; element.properties.len()];
    let mut values = Vec::new();
    let count = element.count as usize;
    soup.points.reserve_exact(count);
    soup.normals.reserve_exact(if normal.is_some() { count } else { 0 });
    soup.uvs.reserve_exact(if uv.is_some() { count } else { 0 });
    soup.colors.reserve_exact(if color.is_some() { count } else { 0 });
    for i in 0..element.count {
        for (slot, property) in row.iter_mut().zip(&element.properties) {
            source.property(property, &mut values, &|| tr!("vertex {i}"))?;
            *slot = values.first().copied().unwrap_or_default();
        }
        let used = position.iter().chain(normal.iter().flatten()).chain(uv.iter().flatten());
        for &slot in used.chain(color.iter().flatten()).chain(alpha.iter().flatten()) {
            if !(row[slot] as f32).is_finite() {
                let name = &element.properties[slot].name;
                let message = tr!(
                    "vertex {i} has `{name}` = {number}, which is not finite",
                    number = row[slot]
                );
                report.add(source.here(Diagnostic::error("mesh-not-finite", message)));
            }
        }
        soup.points.push(position.map(|k| row[k] as f32));
        soup.normals.extend(normal.map(|at| at.map(|k| row[k] as f32)));
        soup.uvs.extend(uv.map(|at| at.map(|k| row[k] as f32)));
        soup.colors.extend(color.map(|at| {
            let [r, g, b] = at.map(|k| (row[k] * scales[k]).clamp(0.0, 1.0) as f32);
            let a = alpha.map_or(1.0, |[k]| (row[k] * scales[k]).clamp(0.0, 1.0) as f32);
            [r, g, b, a]
        }));
    }
    Ok(())
}

/// The corner of a point, with the point's own normal and UV, if every point has one.
fn corner(soup: &TriangleSoup, point: u32) -> Corner {
    let own = |count: usize| if count == soup.points.len() { point } else { NONE };
    Corner { point, normal: own(soup.normals.len()), uv: own(soup.uvs.len()) }
}

/// Checks that `number` is the index of a point.
fn index(
    number: f64,
    count: usize,
    source: &NumberSource,
    what: &dyn Fn() -> String,
) -> Result<u32, ImportProblem> {
    if number >= 0.0 && number < count as f64 && number.fract() == 0.0 {
        return Ok(number as u32);
    }
    let message =
        tr!("{what} names vertex {number}; there are {count}, counted from 0", what = what());
    Err(source.here(Diagnostic::error("mesh-index", message)).into())
}

fn check_triangles(soup: &TriangleSoup) -> Result<(), ImportProblem> {
    if soup.triangles.len() > MAX_TRIANGLES {
        return Err(Diagnostic::error(
            "mesh-too-large",
            tr!("the file has more than {MAX_TRIANGLES} triangles"),
        )
        .into());
    }
    Ok(())
}

fn faces(
    element: &Element,
    source: &mut NumberSource,
    soup: &mut TriangleSoup,
    report: &mut ImportReport,
) -> Result<(), ImportProblem> {
    let Some(list) = element.find(FACE).filter(|&i| element.properties[i].list.is_some()) else {
        return Err(Diagnostic::error(
            "mesh-syntax",
            tr!("the faces have no list `vertex_indices`"),
        )
        .into());
    };
    let wedge_uvs = element.find(&["texcoord"]).filter(|&i| element.properties[i].list.is_some());
    let material = soup.material(DEFAULT_MATERIAL);
    let points = soup.points.len();
    let own_uvs = soup.uvs.len() == points;
    let mut rows: Vec<Vec<f64>> = vec![Vec::new(); element.properties.len()];
    let mut polygon = Polygon::default();
    soup.triangles.reserve(element.count as usize);
    for i in 0..element.count {
        for (row, property) in rows.iter_mut().zip(&element.properties) {
            source.property(property, row, &|| tr!("face {i}"))?;
        }
        polygon.corners.clear();
        for &number in &rows[list] {
            match index(number, points, source, &|| tr!("face {i}")) {
                Ok(point) => {
                    let uv = if own_uvs { point } else { NONE };
                    polygon.corners.push(Corner { uv, ..corner(soup, point) });
                }
                Err(diagnostic) => report.add(*diagnostic),
            }
        }
        let uvs = wedge_uvs.map_or(&[][..], |k| &rows[k]);
        if uvs.len() == 2 * polygon.corners.len() && uvs.iter().all(|x| (*x as f32).is_finite()) {
            for (corner, uv) in polygon.corners.iter_mut().zip(uvs.chunks_exact(2)) {
                corner.uv = soup.uvs.len() as u32;
                soup.uvs.push([uv[0] as f32, uv[1] as f32]);
            }
        }
        polygon.cut(soup, material);
        check_triangles(soup)?;
    }
    Ok(())
}

/// Reads triangle strips as in the Stanford scans, where -1 ends a strip.
fn strips(
    element: &Element,
    source: &mut NumberSource,
    soup: &mut TriangleSoup,
    report: &mut ImportReport,
) -> Result<(), ImportProblem> {
    let Some(list) = element.find(FACE) else { return skip(element, source) };
    let material = soup.material(DEFAULT_MATERIAL);
    let mut values = Vec::new();
    for i in 0..element.count {
        for (k, property) in element.properties.iter().enumerate() {
            source.property(property, &mut values, &|| tr!("strip {i}"))?;
            if k == list {
                strip(&values, material, source, soup, report)?;
            }
        }
    }
    Ok(())
}

fn strip(
    values: &[f64],
    material: u32,
    source: &NumberSource,
    soup: &mut TriangleSoup,
    report: &mut ImportReport,
) -> Result<(), ImportProblem> {
    // The -1 that ends a strip reads as the greatest number where indices are unsigned.
    for run in values.split(|&v| v == -1.0 || v == NumberType::U32.max().unwrap_or(-1.0)) {
        let mut corners = Vec::with_capacity(run.len());
        for &number in run {
            match index(number, soup.points.len(), source, &|| tr!("a strip").to_owned()) {
                Ok(point) => corners.push(corner(soup, point)),
                Err(diagnostic) => report.add(*diagnostic),
            }
        }
        for (k, window) in corners.windows(3).enumerate() {
            let [a, b, c] = [window[0], window[1], window[2]];
            soup.triangles.push(if k % 2 == 0 { [a, b, c] } else { [b, a, c] });
        }
        soup.wear(material);
        check_triangles(soup)?;
    }
    Ok(())
}
