//! Codecs of fields that only HCBTFs have.

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::Codec;
use crate::diag::Diagnostic;
use crate::document::UnknownFields;
use crate::document::json::{JsonLayout, JsonWriter};
use crate::document::read::reader::{Fields, Reader};

/// Codec of the digests of filled images: 16 hexadecimal digits each. An image without such a
/// digest is taken as painted.
pub(in crate::document) struct Digests;

impl Codec<IndexMap<String, u64>> for Digests {
    fn read(
        r: &mut Reader<'_>,
        fields: &mut Fields,
        name: &'static str,
    ) -> Option<IndexMap<String, u64>> {
        r.field(fields, name, |r, at, kind| {
            r.members(at, kind, |r, member, name| {
                let digits = r.tree.string(member);
                let digest = digits.and_then(|digits| u64::from_str_radix(&digits, 16).ok());
                if digest.is_none() {
                    let message = tr!(
                        "`{name}` has no digest of 16 hexadecimal digits; it is taken as painted"
                    );
                    r.report(member, Diagnostic::warning("wrong-type", message));
                }
                Some((name.to_owned(), digest?))
            })
        })
    }

    fn write(w: &mut JsonWriter, filled: &IndexMap<String, u64>, _: Option<&UnknownFields>) {
        w.object(JsonLayout::Lines, |w| {
            for (name, digest) in filled {
                w.member(name, |w| w.string(&format!("{digest:016x}")));
            }
        });
    }

    fn is_left_out(
        value: &IndexMap<String, u64>,
        default: &IndexMap<String, u64>,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value == default
    }
}
