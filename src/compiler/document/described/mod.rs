//! Descriptions of the objects of a document, one for each.
//!
//! [`described!`] takes the rows of an object and makes of them the type with its default, the
//! [`ObjectShape`] from which the JSON Schemas and docs/format.md are made, the reader with its
//! diagnostics, the writer of the canonical form, and the image that journals keep. A new field is
//! a row. The type of a row's value decides how the value is read and written ([`FieldType`]),
//! unless the row names a [`Codec`] of its own (`by`).
//!
//! ```text
//! described! {
//!     /// What the object is; the schema says it, too.
//!     #[derive(Copy)]             // beside Clone, Debug, PartialEq and serde's two
//!     #[serde(default)]           // where every row has a default: makes `Default`
//!     pub struct Camera("camera", Line) {
//!         /// What the field is, with unit and space.
//!         fov: f64 = 0.5, Number(FAR);                   // left out where it has its default
//!         /// As above, and written even then.
//!         mesh: String = "shape:sphere".to_owned(), Text(4096), always;
//!         /// The default in words, where JSON does not say it.
//!         tier: Option<Tier> = None, Word(Tier::WORDS), words "the look's";
//!         /// Without this field there is no object.
//!         target: Target, Kind::Target, required;
//!         /// Without this field the object has this value, and an error is reported.
//!         kind: String = String::new(), Text(64), required;
//!         /// A field with another name in files, and a codec of its own.
//!         position as "at": [f64; 2] = [0.0; 2], Numbers(2, 2, FAR), by Place;
//!         /// A field in files that the type does not hold.
//!         "id": Slug, words "made from the kind";
//!         ..graph: Graph;         // an object whose fields lie among those of this one
//!         unknown;                // keeps fields that no row knows, or the object around does
//!     }
//! }
//! ```

mod choice;
mod codecs;
mod containers;
mod hcbtf;
mod identified;
mod keys;
mod parts;
mod scene;

use super::UnknownFields;
use super::json::{JsonLayout, JsonWriter, ValueIndex};
use super::read::reader::{Fields, Reader};
use super::shape::{FieldKind, ObjectShape};

pub(super) use choice::{described_choice, is_written_alike, write_choice};
pub(super) use codecs::{
    AUTOMATIC_OR_TIER, AutomaticTier, CanvasColor, ColorCodec, DocumentSpace, FlatCodec, PlainCodec,
};
pub(super) use hcbtf::Digests;
pub(super) use identified::{Nodes, Objects};
pub(super) use keys::{DecidedBy, KeyPlace, TargetValues};
pub(super) use scene::{Backdrop, Looks, Scale};

/// Type of a field of a document.
pub(super) trait FieldType: Sized {
    /// Layout of a list or an object of several such values.
    const LISTED: JsonLayout = JsonLayout::Inline;

    /// Reads a value and reports its problems. Unknown fields go to `extras`, unless the value
    /// keeps them.
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self>;

    /// Writes the value with its `unknown` fields, which the part around it kept for it.
    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>);

    /// True if two values are written alike, to the last bit of numbers.
    fn is_same(&self, other: &Self) -> bool;

    /// True if a field with this default need not be written.
    fn is_left_out(&self, default: &Self, _unknown: Option<&UnknownFields>) -> bool {
        self.is_same(default)
    }

    /// Key of the value in a list, under which its unknown fields are kept.
    fn identity(&self, index: usize) -> String {
        index.to_string()
    }
}

/// Reader and writer of a row.
pub(super) trait Codec<T> {
    /// Reads the field's value, where it is there and can be read.
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<T>;

    /// Writes the value alone.
    fn write(w: &mut JsonWriter, value: &T, unknown: Option<&UnknownFields>);

    /// True if a field with this default need not be written.
    fn is_left_out(value: &T, default: &T, unknown: Option<&UnknownFields>) -> bool;

    /// Writes the member, unless it has its default; `unknown` are the fields that the object
    /// keeps.
    fn member(
        w: &mut JsonWriter,
        name: &str,
        value: &T,
        default: Option<&T>,
        unknown: Option<&UnknownFields>,
    ) {
        let extras = part(unknown, name);
        if !default.is_some_and(|default| Self::is_left_out(value, default, extras)) {
            w.member(name, |w| Self::write(w, value, extras));
        }
    }
}

/// Object with rows; [`described!`] implements this trait.
pub(super) trait DescribedObject: Sized {
    /// Layout of the object itself, and layout of several such objects.
    const LAYOUT: (JsonLayout, JsonLayout);

    /// Shape of the object, for the schema and docs/format.md.
    fn shape() -> &'static ObjectShape;

    /// Reads the rows from the members of an object.
    fn from_fields(r: &mut Reader<'_>, fields: &mut Fields) -> Option<Self>;

    /// Writes the rows as members of the object that is open.
    fn write_members(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>);

    /// True if two objects are written alike; see [`FieldType::is_same`].
    fn has_same_rows(&self, other: &Self) -> bool;

    /// Unknown fields that the object keeps itself.
    fn own_unknown(&self) -> Option<&UnknownFields> {
        None
    }

    /// Key of the object in a list; see [`FieldType::identity`].
    fn name_in_list(&self, index: usize) -> String {
        index.to_string()
    }
}

impl<T: DescribedObject> FieldType for T {
    const LISTED: JsonLayout = T::LAYOUT.1;

    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        _kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        let mut fields = r.object(at, T::shape())?;
        let value = T::from_fields(r, &mut fields);
        if value.is_some() {
            *extras = fields.unknown;
        }
        value
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        let unknown = self.own_unknown().or(unknown);
        w.shaped(T::LAYOUT.0, T::shape(), unknown, |w| self.write_members(w, unknown));
    }

    fn is_same(&self, other: &Self) -> bool {
        self.has_same_rows(other)
    }

    fn is_left_out(&self, default: &Self, unknown: Option<&UnknownFields>) -> bool {
        self.has_same_rows(default) && unknown.is_none_or(UnknownFields::is_empty)
    }

    fn identity(&self, index: usize) -> String {
        self.name_in_list(index)
    }
}

/// Unknown fields that are kept for a part under its name; see [`UnknownFields`].
pub(super) fn part<'u>(
    unknown: Option<&'u UnknownFields>,
    name: &str,
) -> Option<&'u UnknownFields> {
    unknown?.get(name)?.as_object()
}

/// Default as JSON, for the schema and docs/format.md.
pub(super) fn default_json<T, C: Codec<T>>(default: &T) -> String {
    let mut writer = JsonWriter::new();
    C::write(&mut writer, default, None);
    writer.finish().trim_end().to_owned()
}

/// Makes a type of a document from its rows; the head of this file documents the syntax.
macro_rules! described {
    (
        $(#[doc = $help:literal])+
        $(#[derive($($derive:ident),*)])?
        $(#[serde($default:ident)])?
        pub struct $name:ident($shape:expr, $layout:ident $(, by $identity:ident)?) {
            $($rows:tt)*
        }
    ) => {
        described! {
            @rows {
                [$($help)+] [$($($derive)*)?] [$($default)?] $name [$shape] $layout [$($identity)?]
            } [] [] [] $($rows)*
        }
    };

    // Row that is left out where it has its default.
    (
        @rows $head:tt [$($members:tt)*] [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $(#[serde($($serde:tt)*)])?
        $field:ident $(as $file:literal)?: $ty:ty = $default:expr, $kind:expr
        $(, by $codec:ident)?; $($rest:tt)*
    ) => {
        described! {
            @rows $head
            [$($members)* {
                [$($help)+] [$(#[serde($($serde)*)])?] $field [$field $($file)?] [$ty]
                [$default] [$default] [Some(&$default)] [$($codec)?]
            }]
            [
                $($shape)* {
                    [$($help)+] [$field $($file)?] [$kind] [default $ty, $default, $($codec)?]
                }
            ]
            [] $($rest)*
        }
    };
    // Row that is always written, even with its default.
    (
        @rows $head:tt [$($members:tt)*] [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $(#[serde($($serde:tt)*)])?
        $field:ident $(as $file:literal)?: $ty:ty = $default:expr, $kind:expr, always
        $(, by $codec:ident)?; $($rest:tt)*
    ) => {
        described! {
            @rows $head
            [$($members)* {
                [$($help)+] [$(#[serde($($serde)*)])?] $field [$field $($file)?] [$ty]
                [$default] [$default] [None] [$($codec)?]
            }]
            [
                $($shape)* {
                    [$($help)+] [$field $($file)?] [$kind] [default $ty, $default, $($codec)?]
                }
            ]
            [] $($rest)*
        }
    };
    // Row with a default that words describe.
    (
        @rows $head:tt [$($members:tt)*] [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $(#[serde($($serde:tt)*)])?
        $field:ident $(as $file:literal)?: $ty:ty = $default:expr, $kind:expr, words $words:literal
        $(, by $codec:ident)?; $($rest:tt)*
    ) => {
        described! {
            @rows $head
            [$($members)* {
                [$($help)+] [$(#[serde($($serde)*)])?] $field [$field $($file)?] [$ty]
                [$default] [$default] [Some(&$default)] [$($codec)?]
            }]
            [$($shape)* { [$($help)+] [$field $($file)?] [$kind] [words $words] }]
            [] $($rest)*
        }
    };
    // Required row with a value for the case that it is missing, which is reported as an error.
    (
        @rows $head:tt [$($members:tt)*] [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $(#[serde($($serde:tt)*)])?
        $field:ident $(as $file:literal)?: $ty:ty = $default:expr, $kind:expr, required
        $(, by $codec:ident)?; $($rest:tt)*
    ) => {
        described! {
            @rows $head
            [$($members)* {
                [$($help)+] [$(#[serde($($serde)*)])?] $field [$field $($file)?] [$ty]
                [$default] [$default] [None] [$($codec)?]
            }]
            [$($shape)* { [$($help)+] [$field $($file)?] [$kind] [required] }]
            [] $($rest)*
        }
    };
    // Required row.
    (
        @rows $head:tt [$($members:tt)*] [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $(#[serde($($serde:tt)*)])?
        $field:ident $(as $file:literal)?: $ty:ty, $kind:expr, required
        $(, by $codec:ident)?; $($rest:tt)*
    ) => {
        described! {
            @rows $head
            [$($members)* {
                [$($help)+] [$(#[serde($($serde)*)])?] $field [$field $($file)?] [$ty]
                [] [return None] [None] [$($codec)?]
            }]
            [$($shape)* { [$($help)+] [$field $($file)?] [$kind] [required] }]
            [] $($rest)*
        }
    };
    // Row that is required under conditions given in words: without it there is no object.
    (
        @rows $head:tt [$($members:tt)*] [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $(#[serde($($serde:tt)*)])?
        $field:ident $(as $file:literal)?: $ty:ty, $kind:expr, words $words:literal
        $(, by $codec:ident)?; $($rest:tt)*
    ) => {
        described! {
            @rows $head
            [$($members)* {
                [$($help)+] [$(#[serde($($serde)*)])?] $field [$field $($file)?] [$ty]
                [] [return None] [None] [$($codec)?]
            }]
            [$($shape)* { [$($help)+] [$field $($file)?] [$kind] [words $words] }]
            [] $($rest)*
        }
    };
    // Row in files alone, which the type does not hold.
    (
        @rows $head:tt $members:tt [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $file:literal: $kind:expr, words $words:literal; $($rest:tt)*
    ) => {
        described! {
            @rows $head $members
            [$($shape)* { [$($help)+] [none $file] [$kind] [words $words] }] [] $($rest)*
        }
    };
    (
        @rows $head:tt $members:tt [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $file:literal: $kind:expr, required; $($rest:tt)*
    ) => {
        described! {
            @rows $head $members
            [$($shape)* { [$($help)+] [none $file] [$kind] [required] }] [] $($rest)*
        }
    };
    (
        @rows $head:tt $members:tt [$($shape:tt)*] []
        $(#[doc = $help:literal])+ $file:literal: $kind:expr, json $json:literal; $($rest:tt)*
    ) => {
        described! {
            @rows $head $members
            [$($shape)* { [$($help)+] [none $file] [$kind] [json $json] }] [] $($rest)*
        }
    };
    // Object whose fields lie among those of this one.
    (
        @rows $head:tt [$($members:tt)*] [$($shape:tt)*] []
        $(#[doc = $help:literal])+ ..$field:ident: $ty:ty; $($rest:tt)*
    ) => {
        described! {
            @rows $head
            [$($members)* {
                [$($help)+] [] $field [$field] [$ty]
                [Default::default()] [Default::default()] [None] [FlatCodec]
            }]
            [$($shape)* { flat $ty }]
            [] $($rest)*
        }
    };
    (@rows $head:tt $members:tt $shape:tt [] $unknown:ident;) => {
        described! { @rows $head $members $shape [$unknown] }
    };

    (
        @rows {
            [$($help:literal)+] [$($derive:ident)*] [$($default:ident)?] $name:ident [$shape:expr]
            $layout:ident [$($identity:ident)?]
        }
        [$({
            [$($member_help:literal)+] [$($serde:tt)*] $field:ident [$($file:tt)+] [$ty:ty]
            [$($value:expr)?] [$or:expr] [$omitted:expr] [$($codec:ident)?]
        })*]
        [$($row:tt)*] [$($unknown:ident)?]
    ) => {
        $(#[doc = $help])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize $(, $derive)*)]
        $(#[serde($default)])?
        #[allow(unreachable_pub, reason = "some parts of documents are read and not kept")]
        pub struct $name {
            $($(#[doc = $member_help])+ $($serde)* pub $field: $ty,)*
            $(
                /// Fields of later versions or of other programs.
                #[serde(default, skip_serializing_if = "crate::document::UnknownFields::is_empty")]
                pub $unknown: crate::document::UnknownFields,
            )?
        }

        described! { @default [$($default)?] $name [$($field [$($value)?])*] [$($unknown)?] }

        impl crate::document::described::DescribedObject for $name {
            const LAYOUT: (crate::document::json::JsonLayout, crate::document::json::JsonLayout) =
                described!(@layout $layout);

            fn shape() -> &'static crate::document::shape::ObjectShape {
                use crate::document::shape::ObjectShape;
                static SHAPE: ObjectShape = ObjectShape {
                    name: $shape,
                    help: concat!($($help),+).trim_ascii(),
                    rows: &[$(described!(@row $row)),*],
                };
                &SHAPE
            }

            fn from_fields(
                r: &mut crate::document::read::reader::Reader<'_>,
                fields: &mut crate::document::read::reader::Fields,
            ) -> Option<Self> {
                $(let $field: Option<$ty> =
                    <described!(@codec $($codec)?) as crate::document::described::Codec<$ty>>::read(
                        r,
                        fields,
                        described!(@name $($file)+),
                    );)*
                Some(Self {
                    $($field: match $field {
                        Some(value) => value,
                        None => $or,
                    },)*
                    $($unknown: std::mem::take(&mut fields.unknown),)?
                })
            }

            fn write_members(
                &self,
                w: &mut crate::document::json::JsonWriter,
                unknown: Option<&crate::document::UnknownFields>,
            ) {
                $(<described!(@codec $($codec)?) as crate::document::described::Codec<$ty>>::member(
                    w,
                    described!(@name $($file)+),
                    &self.$field,
                    $omitted,
                    unknown,
                );)*
            }

            fn has_same_rows(&self, other: &Self) -> bool {
                $(<described!(@codec $($codec)?) as crate::document::described::Codec<$ty>>
                    ::is_left_out(&self.$field, &other.$field, None) &&)*
                true
            }

            $(fn own_unknown(&self) -> Option<&crate::document::UnknownFields> {
                Some(&self.$unknown)
            })?

            $(fn name_in_list(&self, _index: usize) -> String {
                self.$identity.to_string()
            })?
        }
    };

    (@default [] $($rest:tt)*) => {};
    (@default [default] $name:ident [$($field:ident [$value:expr])*] [$($unknown:ident)?]) => {
        impl Default for $name {
            fn default() -> Self {
                Self {
                    $($field: $value,)*
                    $($unknown: crate::document::UnknownFields::new(),)?
                }
            }
        }
    };

    (@layout Lines) => {
        (crate::document::json::JsonLayout::Lines, crate::document::json::JsonLayout::Lines)
    };
    (@layout Line) => {
        (crate::document::json::JsonLayout::Inline, crate::document::json::JsonLayout::Lines)
    };
    (@layout Inline) => {
        (crate::document::json::JsonLayout::Inline, crate::document::json::JsonLayout::Inline)
    };

    (@codec) => { crate::document::described::PlainCodec };
    (@codec $codec:ident) => { crate::document::described::$codec };

    (@name $field:ident) => { stringify!($field) };
    (@name $field:ident $file:literal) => { $file };

    (@row { flat $ty:ty }) => {
        crate::document::shape::ShapeRow::Flat(
            <$ty as crate::document::described::DescribedObject>::shape,
        )
    };
    (@row { [$($help:literal)+] [$($file:tt)+] [$kind:expr] [$($default:tt)*] }) => {
        crate::document::shape::ShapeRow::Field(crate::document::shape::ShapeField {
            name: described!(@name $($file)+),
            kind: $kind,
            default: described!(@told $($default)*),
            help: concat!($($help),+).trim_ascii(),
        })
    };

    (@told required) => { crate::document::shape::FieldDefault::Required };
    (@told words $words:literal) => { crate::document::shape::FieldDefault::Words($words) };
    (@told json $json:literal) => {
        crate::document::shape::FieldDefault::Json(|| $json.to_owned())
    };
    (@told default $ty:ty, $default:expr, $($codec:ident)?) => {
        crate::document::shape::FieldDefault::Json(|| {
            crate::document::described::default_json::<
                $ty,
                described!(@codec $($codec)?),
            >(&$default)
        })
    };
}
pub(super) use described;
