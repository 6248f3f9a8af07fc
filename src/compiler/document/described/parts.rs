//! Switches, numbers, words, texts and ids as parts of documents.

use chiaro_locale::tr;

use super::FieldType;
use crate::diag::Diagnostic;
use crate::document::hcbtf::relief::Channel;
use crate::document::hcbtf::{Angle, StrokeShape};
use crate::document::json::{JsonKind, JsonLayout, JsonWriter, ValueIndex};
use crate::document::read::reader::Reader;
use crate::document::shape::{self, FieldKind};
use crate::document::word::WordChoice as _;
use crate::document::{
    ColorSpace, Endpoint, Extrapolation, HandlePair, Interpolation, KeyScheme, LightKind,
    LightSpace, MemberSet, OutputPort, Projection, SetMember, Target, Tier, TimeInterpolation,
    UnknownFields, Value,
};
use crate::ids::{LightGroup, NodeId, ObjectId, PortName};

/// True if numbers are the same to the last bit, the sign of 0 included: the sign is written too.
pub(in crate::document) fn same(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

impl FieldType for bool {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        _kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        match r.tree.kind(at) {
            JsonKind::Bool(value) => Some(value),
            _ => {
                r.wrong_type(at, tr!("true or false"));
                None
            }
        }
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.bool(*self);
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

impl FieldType for f64 {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        match kind {
            FieldKind::Number(bounds) => r.number_at(at, *bounds),
            _ => None,
        }
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.number(*self);
    }

    fn is_same(&self, other: &Self) -> bool {
        same(&[*self], &[*other])
    }
}

macro_rules! whole_numbers {
    ($($whole:ty),*) => { $(
        /// Whole number within the bounds of its kind.
        impl FieldType for $whole {
            fn read(
                r: &mut Reader<'_>,
                at: ValueIndex,
                kind: &'static FieldKind,
                extras: &mut UnknownFields,
            ) -> Option<Self> {
                <f64 as FieldType>::read(r, at, kind, extras).map(|number| number as Self)
            }

            fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
                w.number(f64::from(*self));
            }

            fn is_same(&self, other: &Self) -> bool {
                self == other
            }
        }

        /// Fixed count of whole numbers, as of texels or a color in bytes.
        impl<const N: usize> FieldType for [$whole; N] {
            fn read(
                r: &mut Reader<'_>,
                at: ValueIndex,
                kind: &'static FieldKind,
                extras: &mut UnknownFields,
            ) -> Option<Self> {
                let numbers = <[f64; N] as FieldType>::read(r, at, kind, extras)?;
                Some(numbers.map(|number| number as $whole))
            }

            fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
                w.numbers(&self.map(f64::from));
            }

            fn is_same(&self, other: &Self) -> bool {
                self == other
            }
        }
    )* };
}

whole_numbers!(u8, u32, i32);

/// Two colors in bytes, between which something lies.
impl FieldType for [[u8; 3]; 2] {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        let FieldKind::Pair(color) = kind else { return None };
        let items = r.list_at(at, kind, |r, at| <[u8; 3]>::read(r, at, color, extras))?;
        let count = r.tree.children(at).count();
        if count != 2 {
            let message = tr!("expected 2 colors, found {count}");
            r.report(at, Diagnostic::error("wrong-count", message));
            return None;
        }
        let colors: Vec<[u8; 3]> = items.into_iter().map(|(_, color)| color).collect();
        colors.try_into().ok()
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        w.list(JsonLayout::Inline, self, |w, color| color.write(w, unknown));
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

/// Fixed count of numbers: a vector, a direction, a color without alpha or a rotation.
impl<const N: usize> FieldType for [f64; N] {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        match kind {
            FieldKind::Numbers(_, _, bounds) => r.array_at(at, *bounds),
            FieldKind::Direction => {
                r.array_at(at, shape::FAR).filter(|direction| r.is_direction(at, direction))
            }
            FieldKind::Color { alpha } => r.color_at(at, *alpha)?.try_into().ok(),
            FieldKind::Rotation => r.rotation_at(at)?.as_slice().try_into().ok(),
            _ => None,
        }
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.numbers(self);
    }

    fn is_same(&self, other: &Self) -> bool {
        same(self, other)
    }
}

impl FieldType for String {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        match kind {
            FieldKind::Text(most) => r.text_at(at, *most).map(std::borrow::Cow::into_owned),
            _ => None,
        }
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.string(self);
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

macro_rules! words {
    ($($word:ty),*) => { $(
        impl FieldType for $word {
            fn read(
                r: &mut Reader<'_>,
                at: ValueIndex,
                _kind: &'static FieldKind,
                _: &mut UnknownFields,
            ) -> Option<Self> {
                r.word_at(at, Self::WORDS).and_then(|word| Self::from_word(&word))
            }

            fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
                w.string(self.word());
            }

            fn is_same(&self, other: &Self) -> bool {
                self == other
            }
        }
    )* };
}

words!(
    Angle,
    Channel,
    ColorSpace,
    Extrapolation,
    HandlePair,
    Interpolation,
    KeyScheme,
    LightKind,
    LightSpace,
    Projection,
    StrokeShape,
    Tier,
    TimeInterpolation
);

macro_rules! ids {
    ($($id:ty),*) => { $(
        impl FieldType for $id {
            fn read(
                r: &mut Reader<'_>,
                at: ValueIndex,
                _kind: &'static FieldKind,
                _: &mut UnknownFields,
            ) -> Option<Self> {
                r.slug_at(at).map(Self::from)
            }

            fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
                w.string(self.as_str());
            }

            fn is_same(&self, other: &Self) -> bool {
                self == other
            }
        }
    )* };
}

ids!(LightGroup, NodeId, ObjectId, PortName);

/// Set, of whose text what is wrong is told.
impl<M: SetMember> FieldType for MemberSet<M> {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        _kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        let text = r.text_at(at, shape::LINE)?;
        let set = Self::parse(&text);
        if let Err(why) = &set {
            let problem = Diagnostic::error(M::BAD, format!("`{text}`: {why}"));
            r.report(at, problem.hint(M::EXAMPLE.tr()));
        }
        set.ok()
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.string(self.text());
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

/// End of a wire.
impl FieldType for Endpoint {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        r.endpoint_at(at, matches!(kind, FieldKind::Input))
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.string(&self.to_string());
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

/// Target of a key or an exposed parameter.
impl FieldType for Target {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        _kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        let text = r.text_at(at, 10_000)?;
        r.target_from(at, &text)
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.string(&self.to_string());
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

/// Output of a node, with the groups around it.
impl FieldType for OutputPort {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        _kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        super::keys::output(r, at)
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        w.string(&self.to_string());
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

/// Value of any input.
impl FieldType for Value {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        _kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        r.value_at(at, extras)
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        match self {
            Self::Bool(value) => w.bool(*value),
            Self::Number(number) => w.number(*number),
            Self::Vector(numbers) => w.numbers(numbers),
            Self::Text(text) => w.string(text),
            Self::Curve(curve) => curve.write(w, unknown),
            Self::Ramp(ramp) => ramp.write(w, unknown),
        }
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}
