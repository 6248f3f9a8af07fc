//! STL, as text and binary. Facet normals are left out: the winding says the same, and better.
//! Points repeat for every facet; [`super::super::build`] welds them.

use chiaro_locale::tr;

use super::cursor::Cursor;
use super::report::ImportReport;
use super::{MAX_TRIANGLES, MAX_VERTICES};
use crate::geometry::map::weld;
use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, NONE, TriangleSoup};

/// Length of a binary file's comment and count, in bytes.
const HEADER: usize = 84;
/// Length of a binary facet (normal, three points, two bytes of attributes), in bytes.
const FACET: usize = 50;

/// The number of facets that the header of a binary file declares.
fn declared(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(80..HEADER)?;
    Some(u64::from(u32::from_le_bytes([count[0], count[1], count[2], count[3]])))
}

/// True if a file of `length` bytes is exactly as long as its binary header, in its first bytes,
/// declares. Binary files may begin with anything, also with `solid`, so their length decides.
pub(super) fn is_binary(head: &[u8], length: u64) -> bool {
    declared(head).is_some_and(|count| HEADER as u64 + FACET as u64 * count == length)
}

/// Reads an STL file, text or binary.
pub(super) fn read(bytes: &[u8], report: &mut ImportReport) -> TriangleSoup {
    let looks_like_text = bytes.trim_ascii_start().starts_with(b"solid");
    let points = if looks_like_text && !is_binary(bytes, bytes.len() as u64) {
        text(&String::from_utf8_lossy(bytes), report)
    } else {
        binary(bytes, declared(bytes), report)
    };
    if report.has_errors() {
        return TriangleSoup::default();
    }
    joined(&points)
}

/// The soup of these points, with coinciding points joined, so that the vertices are as few as they
/// can be.
fn joined(points: &[[f32; 3]]) -> TriangleSoup {
    let welded = weld(points);
    let mut soup = TriangleSoup::default();
    let material = soup.material(DEFAULT_MATERIAL);
    let mut index_of = vec![NONE; points.len()];
    for (i, &first) in welded.iter().enumerate() {
        if first as usize == i {
            index_of[i] = soup.points.len() as u32;
            soup.points.push(points[i]);
        }
    }
    let corner = |i: usize| Corner { point: index_of[welded[i] as usize], normal: NONE, uv: NONE };
    let triangles = (0..points.len() / 3).map(|t| [0, 1, 2].map(|k| corner(3 * t + k)));
    soup.triangles.reserve(points.len() / 3);
    soup.triangles.extend(triangles);
    soup.wear(material);
    soup
}

fn binary(bytes: &[u8], declared: Option<u64>, report: &mut ImportReport) -> Vec<[f32; 3]> {
    let Some(count) = declared else {
        report.error(
            "mesh-truncated",
            tr!(
                "the file has {bytes} bytes; an STL file has at least {HEADER}",
                bytes = bytes.len()
            ),
        );
        return Vec::new();
    };
    let there = ((bytes.len() - HEADER) / FACET) as u64;
    if there < count {
        report.error("mesh-truncated", tr!("the file ends after {there} of its {count} facets"));
        return Vec::new();
    }
    if too_many(count, report) {
        return Vec::new();
    }
    let mut points = Vec::with_capacity(count as usize * 3);
    let mut cursor = Cursor::little_endian(&bytes[HEADER..]);
    for facet in 0..count {
        let (_normal, corners) = (cursor.vec3(), [cursor.vec3(), cursor.vec3(), cursor.vec3()]);
        let _attributes = cursor.take(2);
        for corner in corners.into_iter().flatten() {
            if corner.iter().any(|c| !c.is_finite()) {
                report.error(
                    "mesh-not-finite",
                    tr!(
                        "facet {number} has the point {corner:?}, which is not finite",
                        number = facet + 1
                    ),
                );
            }
            points.push(corner);
        }
    }
    points
}

fn too_many(facets: u64, report: &mut ImportReport) -> bool {
    let most = MAX_TRIANGLES.min(MAX_VERTICES) as u64;
    if facets > most {
        report.error(
            "mesh-too-large",
            tr!("the file has {facets} facets, more than the {most} allowed"),
        );
    }
    facets > most
}

fn text(text: &str, report: &mut ImportReport) -> Vec<[f32; 3]> {
    let mut points: Vec<[f32; 3]> = Vec::new();
    let mut open = false;
    let mut facet_start = 0;
    for line in text.lines() {
        let mut words = line.split_ascii_whitespace();
        let Some(keyword) = words.next() else { continue };
        match keyword.to_ascii_lowercase().as_str() {
            "solid" => open = true,
            "endsolid" => open = false,
            "facet" => facet_start = points.len(),
            "vertex" => points.push(vertex(text, keyword, words, report)),
            "endfacet" if points.len() - facet_start != 3 => {
                let message = tr!(
                    "a facet has {count} vertices instead of 3",
                    count = points.len() - facet_start
                );
                report.error_at(text, keyword, "mesh-syntax", message);
                points.truncate(facet_start);
            }
            "endfacet" | "outer" | "endloop" => {}
            _ => report.error_at(
                text,
                keyword,
                "mesh-syntax",
                tr!("`{keyword}` is no word of an STL file"),
            ),
        }
        if too_many(points.len() as u64 / 3, report) {
            return points;
        }
    }
    if open || !points.len().is_multiple_of(3) {
        report.error("mesh-truncated", tr!("the file ends before `endsolid`"));
    }
    points
}

fn vertex<'a>(
    text: &str,
    keyword: &str,
    words: impl Iterator<Item = &'a str>,
    report: &mut ImportReport,
) -> [f32; 3] {
    let mut point = [0.0; 3];
    let mut count = 0;
    for word in words {
        match word.parse::<f32>() {
            Ok(number) if number.is_finite() => {
                if let Some(slot) = point.get_mut(count) {
                    *slot = number;
                }
            }
            Ok(_) => report.error_at(
                text,
                word,
                "mesh-not-finite",
                tr!("the coordinate `{word}` is not finite"),
            ),
            Err(_) => {
                report.error_at(text, word, "mesh-syntax", tr!("`{word}` is not a number"));
            }
        }
        count += 1;
    }
    if count != 3 {
        report.error_at(
            text,
            keyword,
            "mesh-syntax",
            tr!("a vertex has {count} numbers instead of 3"),
        );
    }
    point
}
