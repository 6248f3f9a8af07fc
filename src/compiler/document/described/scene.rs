//! Codecs of fields that only scenes have.

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::{Codec, FieldType as _, PlainCodec};
use crate::diag::Diagnostic;
use crate::document::json::{JsonKind, JsonLayout, JsonWriter, ValueIndex};
use crate::document::read::reader::{Fields, Reader};
use crate::document::shape::{self, MAX_PATH};
use crate::document::{UnknownFields, read_hex};

/// Codec of the backdrop behind the objects: a color, or none.
pub(in crate::document) struct Backdrop;

impl Codec<Option<[f64; 4]>> for Backdrop {
    fn read(
        r: &mut Reader<'_>,
        fields: &mut Fields,
        name: &'static str,
    ) -> Option<Option<[f64; 4]>> {
        r.field(fields, name, |r, at, _| backdrop(r, at))
    }

    fn write(w: &mut JsonWriter, value: &Option<[f64; 4]>, unknown: Option<&UnknownFields>) {
        value.write(w, unknown);
    }

    fn is_left_out(
        value: &Option<[f64; 4]>,
        default: &Option<[f64; 4]>,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value.is_same(default)
    }
}

/// Codec of an object's looks: a path for all materials, or paths by material.
pub(in crate::document) struct Looks;

impl Codec<IndexMap<String, String>> for Looks {
    fn read(
        r: &mut Reader<'_>,
        fields: &mut Fields,
        name: &'static str,
    ) -> Option<IndexMap<String, String>> {
        r.field(fields, name, looks)
    }

    fn write(
        w: &mut JsonWriter,
        looks: &IndexMap<String, String>,
        _unknown: Option<&UnknownFields>,
    ) {
        match looks.get("*").filter(|_| looks.len() == 1) {
            Some(path) => w.string(path),
            None => w.object(JsonLayout::Inline, |w| {
                for (material, path) in looks {
                    w.member(material, |w| w.string(path));
                }
            }),
        }
    }

    fn is_left_out(
        value: &IndexMap<String, String>,
        default: &IndexMap<String, String>,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value == default
    }
}

/// Codec of a scale. No axis may be 0, which would flatten the mesh.
pub(in crate::document) struct Scale;

impl Codec<[f64; 3]> for Scale {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<[f64; 3]> {
        r.field(fields, name, |r, at, kind| {
            let scale = <[f64; 3]>::read(r, at, kind, &mut UnknownFields::new())?;
            if scale.iter().any(|s| s.abs() < 1e-9) {
                let problem = Diagnostic::error(
                    "out-of-range",
                    tr!("a scale of 0 leaves nothing of the mesh"),
                );
                r.report(
                    at,
                    problem.hint(tr!(
                        "write any other number, or \"visible\": false to hide the object"
                    )),
                );
                return None;
            }
            Some(scale)
        })
    }

    fn write(w: &mut JsonWriter, value: &[f64; 3], unknown: Option<&UnknownFields>) {
        value.write(w, unknown);
    }

    fn is_left_out(value: &[f64; 3], default: &[f64; 3], unknown: Option<&UnknownFields>) -> bool {
        PlainCodec::is_left_out(value, default, unknown)
    }
}

fn looks(
    r: &mut Reader<'_>,
    at: ValueIndex,
    kind: &'static shape::FieldKind,
) -> Option<IndexMap<String, String>> {
    match r.tree.kind(at) {
        JsonKind::Text => r
            .text_at(at, MAX_PATH)
            .map(|path| IndexMap::from([("*".to_owned(), path.into_owned())])),
        _ => r.members(at, kind, |r, member, key| {
            r.text_at(member, MAX_PATH).map(|path| (key.to_owned(), path.into_owned()))
        }),
    }
}

fn backdrop(r: &mut Reader<'_>, at: ValueIndex) -> Option<Option<[f64; 4]>> {
    match r.tree.kind(at) {
        JsonKind::Null => Some(None),
        JsonKind::Text if r.tree.string(at).as_deref() == Some("none") => Some(None),
        JsonKind::Text => {
            let hex = r.tree.string(at).and_then(|text| read_hex(&text));
            if hex.is_none() {
                let problem = Diagnostic::error("bad-color", tr!("this is no color"));
                r.report(
                    at,
                    problem.hint(tr!(
                        "write \"#rrggbb\", \"#rrggbbaa\", [r, g, b, a], or null for transparent"
                    )),
                );
            }
            hex.map(Some)
        }
        _ => {
            let color = r.color_at(at, true)?;
            Some(Some([color[0], color[1], color[2], color.get(3).copied().unwrap_or(1.0)]))
        }
    }
}
