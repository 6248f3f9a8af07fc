//! Choices between objects by a word in one of their fields, such as the rules of an HCBTF.
//!
//! [`described_choice!`] takes the choices with their rows and makes of them the enum, its
//! [`ChoiceShape`], its reader and its writer. Each choice has an object of its own, which
//! [`described!`](super::described) makes of the rows, with the word as a field.
//!
//! ```text
//! described_choice! {
//!     /// What the choice is; the schema says it, too.
//!     pub enum Rule("rule") {         // the name, and the field that holds the word
//!         /// What this choice does.
//!         Copy("copy") as CopyRule {
//!             /// What the field is.
//!             from: Address = Address::default(), FieldKind::Object(AddressFields::shape);
//!         }
//!     }
//!     boxed {
//!         /// A choice whose fields are those of another object.
//!         Strokes("strokes") as StrokesRule: Strokes;
//!     }
//! }
//! ```

use chiaro_locale::tr;

use super::{DescribedObject, FieldType};
use crate::diag::Diagnostic;
use crate::document::UnknownFields;
use crate::document::json::{JsonKind, JsonLayout, JsonWriter, ValueIndex};
use crate::document::read::reader::{PathStep, Reader, with_article};
use crate::document::shape::ChoiceShape;

impl Reader<'_> {
    /// Index of the choice that an object names, among the choices of the shape.
    pub(in crate::document) fn choice_at(
        &mut self,
        at: ValueIndex,
        shape: &'static ChoiceShape,
    ) -> Option<usize> {
        let noun = with_article(shape.name);
        if self.tree.kind(at) != JsonKind::Object {
            self.wrong_type(at, &tr!("{noun} (an object)"));
            return None;
        }
        let Some(member) = self.tree.member(at, shape.tag) else {
            let words: Vec<&str> = shape.words.iter().map(|(word, _)| *word).collect();
            let message = tr!("{noun} needs the field `{tag}`", tag = shape.tag);
            let hint = tr!("`{tag}` is one of {words}", tag = shape.tag, words = words.join(", "));
            self.report(at, Diagnostic::error("missing-field", message).hint(hint));
            return None;
        };
        self.path.push(PathStep::Field(shape.tag));
        let word = self.word_at(member, shape.words);
        self.path.pop();
        shape.words.iter().position(|(known, _)| word.as_deref() == Some(*known))
    }
}

/// Writes the object of a choice, with its word first.
pub(in crate::document) fn write_choice<T: DescribedObject>(
    w: &mut JsonWriter,
    (tag, word): (&str, &str),
    object: &T,
    unknown: Option<&UnknownFields>,
) {
    w.shaped(JsonLayout::Inline, T::shape(), unknown, |w| {
        w.member(tag, |w| w.string(word));
        object.write_members(w, unknown);
    });
}

/// True if two values are written as the same text.
pub(in crate::document) fn is_written_alike<T: FieldType>(a: &T, b: &T) -> bool {
    let text = |value: &T| {
        let mut writer = JsonWriter::new();
        value.write(&mut writer, None);
        writer.finish()
    };
    text(a) == text(b)
}

/// Makes a choice between objects from their rows; the head of this file documents the syntax.
macro_rules! described_choice {
    (
        $(#[doc = $help:literal])+
        pub enum $name:ident($shape:literal) {
            $(
                $(#[doc = $variant_help:literal])+
                $variant:ident($word:literal) as $object:ident {
                    $(
                        $(#[doc = $field_help:literal])+
                        $(#[serde($($serde:tt)*)])?
                        $field:ident $(as $file:literal)?: $ty:ty = $default:expr, $kind:expr;
                    )*
                }
            )*
        }
        $(boxed {
            $(
                $(#[doc = $boxed_help:literal])+
                $boxed:ident($boxed_word:literal) as $boxed_object:ident: $inner:ident;
            )*
        })?
    ) => {
        $(#[doc = $help])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(tag = $shape, rename_all = "snake_case")]
        pub enum $name {
            $(
                $(#[doc = $variant_help])+
                $variant {
                    $($(#[doc = $field_help])+ $(#[serde($($serde)*)])? $field: $ty,)*
                },
            )*
            $($(
                $(#[doc = $boxed_help])+
                $boxed(Box<$inner>),
            )*)?
        }

        $(
            described! {
                $(#[doc = $variant_help])+
                #[serde(default)]
                pub struct $object(concat!($word, " ", $shape), Line) {
                    /// The word of the choice.
                    $shape: FieldKind::Word(&[($word, concat!($($variant_help),+))]), required;
                    $(
                        $(#[doc = $field_help])+ $(#[serde($($serde)*)])?
                        $field $(as $file)?: $ty = $default, $kind, always;
                    )*
                }
            }
        )*
        $($(
            described! {
                $(#[doc = $boxed_help])+
                #[serde(default)]
                pub struct $boxed_object(concat!($boxed_word, " ", $shape), Line) {
                    /// The word of the choice.
                    $shape: FieldKind::Word(&[($boxed_word, concat!($($boxed_help),+))]), required;
                    /// The fields.
                    ..inner: $inner;
                }
            }
        )*)?

        impl $name {
            /// Choice with a word, with the default of each field.
            fn of_word(word: &str) -> Option<Self> {
                match word {
                    $($word => {
                        let $object { $($field),* } = Default::default();
                        Some(Self::$variant { $($field),* })
                    })*
                    $($($boxed_word => Some(Self::$boxed(Box::default())),)*)?
                    _ => None,
                }
            }

            /// Shape of the choice, for the schema and docs/format.md.
            pub(in crate::document) fn choice() -> &'static crate::document::shape::ChoiceShape {
                use crate::document::described::DescribedObject;
                static SHAPE: crate::document::shape::ChoiceShape =
                    crate::document::shape::ChoiceShape {
                        name: $shape,
                        tag: $shape,
                        help: concat!($($help),+),
                        words: &[
                            $(($word, concat!($($variant_help),+)),)*
                            $($(($boxed_word, concat!($($boxed_help),+)),)*)?
                        ],
                        objects: &[
                            $(<$object as DescribedObject>::shape,)*
                            $($(<$boxed_object as DescribedObject>::shape,)*)?
                        ],
                    };
                &SHAPE
            }
        }

        impl crate::document::described::FieldType for $name {
            const LISTED: crate::document::json::JsonLayout =
                crate::document::json::JsonLayout::Lines;

            fn read(
                r: &mut crate::document::read::reader::Reader<'_>,
                at: crate::document::json::ValueIndex,
                kind: &'static FieldKind,
                extras: &mut crate::document::UnknownFields,
            ) -> Option<Self> {
                use crate::document::described::FieldType;
                let index = r.choice_at(at, Self::choice())?;
                match Self::choice().words[index].0 {
                    $($word => {
                        let $object { $($field),* } = FieldType::read(r, at, kind, extras)?;
                        Some(Self::$variant { $($field),* })
                    })*
                    $($($boxed_word => {
                        let $boxed_object { inner } = FieldType::read(r, at, kind, extras)?;
                        Some(Self::$boxed(Box::new(inner)))
                    })*)?
                    _ => None,
                }
            }

            fn write(
                &self,
                w: &mut crate::document::json::JsonWriter,
                unknown: Option<&crate::document::UnknownFields>,
            ) {
                use crate::document::described::write_choice;
                match self.clone() {
                    $(Self::$variant { $($field),* } => {
                        write_choice(w, ($shape, $word), &$object { $($field),* }, unknown);
                    })*
                    $($(Self::$boxed(inner) => {
                        let object = $boxed_object { inner: *inner };
                        write_choice(w, ($shape, $boxed_word), &object, unknown);
                    })*)?
                }
            }

            fn is_same(&self, other: &Self) -> bool {
                crate::document::described::is_written_alike(self, other)
            }
        }
    };
}
pub(in crate::document) use described_choice;
