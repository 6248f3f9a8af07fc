//! The numbers of the look's uniform as properties of a material.
//!
//! A material has numbers and vectors, but no structs, arrays or matrices. Each number and vector
//! of the uniform is a property with a name of its own; a matrix is as many as it has columns.

use std::collections::HashSet;

use chiaro_locale::tr;

use super::source::Source;
use crate::diag::Diagnostic;
use crate::export::package::PackageRequest;
use crate::export::reflect::Member;

/// A property.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::export::package) struct Leaf {
    /// Name of the property, such as `_key_direction`.
    pub(in crate::export::package) property: String,
    /// The place in the look's variable, such as `look.key.direction`.
    pub(in crate::export::package) place: String,
    /// Type of the place in HLSL: `float`, `float2` to `float4`, `int` or `uint`.
    pub(in crate::export::package) ty: String,
    /// The first of the uniform's words that are the property's.
    pub(in crate::export::package) word: u32,
    /// Number of words, 1 to 4.
    pub(in crate::export::package) count: u32,
}

impl Leaf {
    /// True for a whole number.
    pub(in crate::export::package) fn is_integer(&self) -> bool {
        self.ty == "int" || self.ty == "uint"
    }
}

/// The properties, in the order of the uniform; none of a look without one.
///
/// # Errors
/// - `export-failed`: a member that has another form in HLSL than is looked for.
pub(in crate::export::package) fn leaves(
    request: &PackageRequest<'_>,
    source: &Source,
) -> Result<Vec<Leaf>, Diagnostic> {
    let draw = request.modules.modules.iter().find(|module| module.is_draw());
    let bound = draw.and_then(|module| module.bindings.iter().find(|it| it.name == "look"));
    let Some(bound) = bound else { return Ok(Vec::new()) };
    let Some((name, ty)) = source.blocks.iter().find(|(_, ty)| *ty == "Look") else {
        return Err(lost("look"));
    };
    let mut found = Vec::new();
    members(source, &bound.members, ty, (name, ""), 0, &mut found)?;
    // `key.color` and `key_color` would have one name.
    let images = source.images.iter();
    let mut taken: HashSet<String> = images.map(|image| image.texture.clone()).collect();
    for leaf in &mut found {
        let numbered = (2..).map(|number| format!("{}_{number}", leaf.property));
        let mut names = std::iter::once(leaf.property.clone()).chain(numbered);
        if let Some(name) = names.find(|name| taken.insert(name.clone())) {
            leaf.property = name;
        }
    }
    Ok(found)
}

fn lost(place: &str) -> Diagnostic {
    Diagnostic::error("export-failed", tr!("`{place}` has an unknown form in HLSL"))
        .hint(tr!("please report the look; `--to hlsl` may still carry it"))
}

/// The leaves of a struct's members. `at` is the struct's place in HLSL and the beginning of its
/// properties' names.
fn members(
    source: &Source,
    members: &[Member],
    ty: &str,
    at: (&str, &str),
    offset: u32,
    found: &mut Vec<Leaf>,
) -> Result<(), Diagnostic> {
    let fields = source.members(ty).filter(|fields| fields.len() == members.len());
    let fields = fields.ok_or_else(|| lost(at.0))?;
    for (member, field) in members.iter().zip(fields) {
        let place = format!("{}.{}", at.0, field.name);
        let property = format!("{}_{}", at.1, member.name);
        let ty = field.ty.trim_start_matches("row_major ");
        let offset = offset + member.offset;
        let places = (place.as_str(), property.as_str());
        if let Some(element) = member.ty.strip_prefix("array<") {
            let count = element.rsplit_once(", ").and_then(|it| it.1.strip_suffix('>'));
            let count: u32 = count.and_then(|it| it.parse().ok()).ok_or_else(|| lost(&place))?;
            for index in 0..count {
                let places = (format!("{place}[{index}]"), format!("{property}_{index}"));
                let places = (places.0.as_str(), places.1.as_str());
                value(source, member, ty, places, offset + index * member.stride, found)?;
            }
        } else {
            value(source, member, ty, places, offset, found)?;
        }
    }
    Ok(())
}

/// The leaves of a value, an element of an array among them.
fn value(
    source: &Source,
    member: &Member,
    ty: &str,
    (place, property): (&str, &str),
    offset: u32,
    found: &mut Vec<Leaf>,
) -> Result<(), Diagnostic> {
    if !member.members.is_empty() {
        return members(source, &member.members, ty, (place, property), offset, found);
    }
    let leaf = |property: String, place: String, ty: &str, offset: u32, count: u32| Leaf {
        property,
        place,
        ty: ty.to_owned(),
        word: offset / 4,
        count,
    };
    let size = ty.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    match (ty, size) {
        ("float" | "int" | "uint", _) => {
            found.push(leaf(property.to_owned(), place.to_owned(), ty, offset, 1));
        }
        (_, "2" | "3" | "4") if ty.starts_with("float") => {
            let count = size.parse().unwrap_or(4);
            found.push(leaf(property.to_owned(), place.to_owned(), ty, offset, count));
        }
        _ => {
            // `float3x3`: the exporter's rows are columns.
            let (columns, rows) = size.split_once('x').ok_or_else(|| lost(place))?;
            let columns: u32 = columns.parse().map_err(|_| lost(place))?;
            let rows: u32 = rows.parse().map_err(|_| lost(place))?;
            let stride = if rows == 2 { 8 } else { 16 };
            for column in 0..columns {
                found.push(leaf(
                    format!("{property}_{column}"),
                    format!("{place}[{column}]"),
                    &format!("float{rows}"),
                    offset + stride * column,
                    rows,
                ));
            }
        }
    }
    Ok(())
}
