//! Symbols: values of WGSL while a look is followed.

use naga::{Handle, Module, Type, TypeInner};

use super::terms::{TermId, Terms, Truth};
use crate::interp::Value;

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Symbol {
    /// A float or a vector of floats.
    Number(TermId),
    /// An integer.
    Whole(TermId),
    /// A truth value.
    Truth(Truth),
    /// A struct, an array, a matrix by its columns, a vector of integers or of truth values.
    List(Vec<Self>),
    /// A place in memory: a slot, and the way within it.
    Pointer(usize, Vec<usize>),
    /// An image or what else no term can be.
    Foreign,
}

impl Symbol {
    /// The value of an integer that is known.
    #[expect(clippy::cast_possible_truncation, reason = "integers of 32 bits are exact in f64")]
    pub(super) fn whole(&self, terms: &Terms) -> Option<i64> {
        match self {
            Self::Whole(id) => terms.known(*id).map(|numbers| numbers[0] as i64),
            _ => None,
        }
    }

    /// A value that is known.
    pub(super) fn of_value(value: &Value, terms: &mut Terms) -> Self {
        match value {
            Value::Bool(x) => Self::Truth(Truth::Known(*x)),
            Value::I32(x) => Self::Whole(terms.number(f64::from(*x))),
            Value::U32(x) => Self::Whole(terms.number(f64::from(*x))),
            Value::Float(x) => Self::Number(terms.number(*x)),
            Value::Vector(scalars) => {
                let numbers: Vec<f64> = scalars.iter().map(|scalar| scalar.as_f64()).collect();
                Self::Number(terms.constant(&numbers))
            }
            Value::Matrix { columns, components } => {
                let rows = components.len() / (*columns).max(1);
                let columns = components.chunks(rows.max(1));
                Self::List(columns.map(|it| Self::Number(terms.constant(it))).collect())
            }
            Value::Array(list) | Value::Struct(list) => {
                Self::List(list.iter().map(|value| Self::of_value(value, terms)).collect())
            }
        }
    }

    /// Zero of a type.
    pub(super) fn zero(module: &Module, ty: Handle<Type>, terms: &mut Terms) -> Self {
        let scalar = |kind: naga::ScalarKind, width: usize, terms: &mut Terms| match kind {
            naga::ScalarKind::Float | naga::ScalarKind::AbstractFloat => {
                Self::Number(terms.constant(&vec![0.0; width]))
            }
            _ => {
                let one = match kind {
                    naga::ScalarKind::Bool => Self::Truth(Truth::Known(false)),
                    _ => Self::Whole(terms.number(0.0)),
                };
                if width == 1 { one } else { Self::List(vec![one; width]) }
            }
        };
        match &module.types[ty].inner {
            TypeInner::Scalar(of) => scalar(of.kind, 1, terms),
            TypeInner::Vector { size, scalar: of } => scalar(of.kind, *size as usize, terms),
            TypeInner::Matrix { columns, rows, .. } => {
                let column = Self::Number(terms.constant(&vec![0.0; *rows as usize]));
                Self::List(vec![column; *columns as usize])
            }
            TypeInner::Array { base, size: naga::ArraySize::Constant(size), .. } => {
                let element = Self::zero(module, *base, terms);
                Self::List(vec![element; size.get() as usize])
            }
            TypeInner::Struct { members, .. } => {
                let zero = |member: &naga::StructMember| Self::zero(module, member.ty, terms);
                Self::List(members.iter().map(zero).collect())
            }
            _ => Self::Foreign,
        }
    }

    /// A part of a value.
    pub(super) fn part(&self, place: usize, terms: &mut Terms) -> Option<Self> {
        match self {
            Self::Number(id) if place < terms.width(*id) => {
                Some(Self::Number(terms.component(*id, place)))
            }
            Self::List(list) => list.get(place).cloned(),
            Self::Pointer(slot, way) => {
                let mut way = way.clone();
                way.push(place);
                Some(Self::Pointer(*slot, way))
            }
            _ => None,
        }
    }

    /// The value with another part at the end of a way.
    pub(super) fn with(&self, way: &[usize], part: Self, terms: &mut Terms) -> Option<Self> {
        let Some((place, rest)) = way.split_first() else { return Some(part) };
        match self {
            Self::Number(id) => {
                let width = terms.width(*id);
                let mut parts: Vec<TermId> =
                    (0..width).map(|place| terms.component(*id, place)).collect();
                let Self::Number(new) = part else { return None };
                *parts.get_mut(*place)? = new;
                Some(Self::Number(terms.combine(&parts)))
            }
            Self::List(list) => {
                let mut list = list.clone();
                let inner = list.get(*place)?.with(rest, part, terms)?;
                list[*place] = inner;
                Some(Self::List(list))
            }
            _ => None,
        }
    }

    /// All single values of a vector.
    pub(super) fn singles(&self, terms: &mut Terms) -> Vec<Self> {
        match self {
            Self::Number(id) => {
                let width = terms.width(*id);
                (0..width).map(|place| Self::Number(terms.component(*id, place))).collect()
            }
            Self::List(list) => list.clone(),
            other => vec![other.clone()],
        }
    }

    /// A vector of single values.
    pub(super) fn vector(singles: Vec<Self>, terms: &mut Terms) -> Self {
        let numbers: Option<Vec<TermId>> = singles
            .iter()
            .map(|single| match single {
                Self::Number(id) => Some(*id),
                _ => None,
            })
            .collect();
        match numbers {
            Some(numbers) => Self::Number(terms.combine(&numbers)),
            None if singles.len() == 1 => singles.into_iter().next().unwrap_or(Self::Foreign),
            None => Self::List(singles),
        }
    }

    /// One of two by a condition; `None` where no node chooses.
    pub(super) fn choose(truth: &Truth, on: &Self, off: &Self, terms: &mut Terms) -> Option<Self> {
        if on == off {
            return Some(on.clone());
        }
        match (truth, on, off) {
            (Truth::Known(true), ..) => Some(on.clone()),
            (Truth::Known(false), ..) => Some(off.clone()),
            (_, Self::Number(on), Self::Number(off)) => {
                Some(Self::Number(terms.choose(truth, *on, *off)))
            }
            (_, Self::Whole(on), Self::Whole(off)) => {
                Some(Self::Whole(terms.choose(truth, *on, *off)))
            }
            (_, Self::Truth(on), Self::Truth(off)) => {
                Some(Self::Truth(choose_truth(truth, on, off)))
            }
            (_, Self::List(on), Self::List(off)) if on.len() == off.len() => {
                let pairs = on.iter().zip(off);
                let list: Option<Vec<Self>> =
                    pairs.map(|(on, off)| Self::choose(truth, on, off, terms)).collect();
                list.map(Self::List)
            }
            _ => None,
        }
    }
}

/// One of two conditions by a third.
pub(super) fn choose_truth(truth: &Truth, on: &Truth, off: &Truth) -> Truth {
    if on == off {
        return on.clone();
    }
    truth.clone().and(on.clone()).or(truth.clone().not().and(off.clone()))
}
