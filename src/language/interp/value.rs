//! Values: arguments and results of a program.

use std::fmt;

use chiaro_locale::tr;

use super::shape::ScalarKind;

/// Number or truth value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scalar {
    /// `bool`
    Bool(bool),
    /// `i32`
    I32(i32),
    /// `u32`
    U32(u32),
    /// `f32`, held as f64.
    Float(f64),
}

impl Scalar {
    /// Type of the scalar.
    pub fn kind(self) -> ScalarKind {
        match self {
            Self::Bool(_) => ScalarKind::Bool,
            Self::I32(_) => ScalarKind::I32,
            Self::U32(_) => ScalarKind::U32,
            Self::Float(_) => ScalarKind::Float,
        }
    }

    /// Numeric value of the scalar, true being 1.
    pub fn as_f64(self) -> f64 {
        match self {
            Self::Bool(x) => f64::from(u8::from(x)),
            Self::I32(x) => f64::from(x),
            Self::U32(x) => f64::from(x),
            Self::Float(x) => x,
        }
    }
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(x) => x.fmt(f),
            Self::I32(x) => x.fmt(f),
            Self::U32(x) => x.fmt(f),
            Self::Float(x) => x.fmt(f),
        }
    }
}

/// Value of a constructible WGSL type. Equality is that of IEEE 754: NaN equals nothing.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `bool`
    Bool(bool),
    /// `i32`
    I32(i32),
    /// `u32`
    U32(u32),
    /// `f32`, held as f64.
    Float(f64),
    /// Vector of two to four components of one kind.
    Vector(Vec<Scalar>),
    /// Matrix of floats.
    Matrix {
        /// Number of columns, 2 to 4.
        columns: usize,
        /// Components, column after column: `columns` times the number of rows.
        components: Vec<f64>,
    },
    /// Array of elements of one type.
    Array(Vec<Value>),
    /// Struct of members, in order of declaration.
    Struct(Vec<Value>),
}

impl Value {
    /// A vector of floats.
    pub fn vec(components: &[f64]) -> Self {
        Self::Vector(components.iter().map(|&x| Scalar::Float(x)).collect())
    }

    /// A vector of signed integers.
    pub fn ivec(components: &[i32]) -> Self {
        Self::Vector(components.iter().map(|&x| Scalar::I32(x)).collect())
    }

    /// A vector of unsigned integers.
    pub fn uvec(components: &[u32]) -> Self {
        Self::Vector(components.iter().map(|&x| Scalar::U32(x)).collect())
    }

    /// A vector of truth values.
    pub fn bvec(components: &[bool]) -> Self {
        Self::Vector(components.iter().map(|&x| Scalar::Bool(x)).collect())
    }

    /// A matrix from its columns, which must be equally long.
    pub fn matrix<const R: usize>(columns: &[[f64; R]]) -> Self {
        Self::Matrix { columns: columns.len(), components: columns.as_flattened().to_vec() }
    }

    /// Number of a float, an integer or a bool (1 if true).
    pub fn as_f64(&self) -> Option<f64> {
        self.as_scalar().map(Scalar::as_f64)
    }

    /// Scalar of a scalar value.
    pub fn as_scalar(&self) -> Option<Scalar> {
        match *self {
            Self::Bool(x) => Some(Scalar::Bool(x)),
            Self::I32(x) => Some(Scalar::I32(x)),
            Self::U32(x) => Some(Scalar::U32(x)),
            Self::Float(x) => Some(Scalar::Float(x)),
            _ => None,
        }
    }

    /// Numbers of a scalar, a vector or a matrix (column after column); `None` for an array or a
    /// struct.
    pub fn components(&self) -> Option<Vec<f64>> {
        match self {
            Self::Vector(scalars) => Some(scalars.iter().map(|s| s.as_f64()).collect()),
            Self::Matrix { components, .. } => Some(components.clone()),
            Self::Array(_) | Self::Struct(_) => None,
            _ => self.as_f64().map(|x| vec![x]),
        }
    }

    /// Components of a vector of exactly `N` floats.
    pub fn as_vec<const N: usize>(&self) -> Option<[f64; N]> {
        let Self::Vector(scalars) = self else { return None };
        let floats: Option<Vec<f64>> = scalars
            .iter()
            .map(|s| if let Scalar::Float(x) = s { Some(*x) } else { None })
            .collect();
        floats?.try_into().ok()
    }

    /// Elements of an array or members of a struct.
    pub fn parts(&self) -> Option<&[Self]> {
        match self {
            Self::Array(parts) | Self::Struct(parts) => Some(parts),
            _ => None,
        }
    }

    /// Type of the value, as far as the value alone tells, in WGSL's words.
    pub(super) fn describe(&self) -> String {
        match self {
            Self::Vector(scalars) => {
                let kind = scalars.first().map_or("?", |s| s.kind().name());
                format!("vec{}<{kind}>", scalars.len())
            }
            Self::Matrix { columns, components } => {
                format!("mat{columns}x{}<f32>", components.len().checked_div(*columns).unwrap_or(0))
            }
            Self::Array(elements) => tr!("an array of {count}", count = elements.len()),
            Self::Struct(members) => tr!("a struct of {count}", count = members.len()),
            _ => self.as_scalar().map_or("?", |s| s.kind().name()).to_owned(),
        }
    }
}

impl From<Scalar> for Value {
    fn from(scalar: Scalar) -> Self {
        match scalar {
            Scalar::Bool(x) => Self::Bool(x),
            Scalar::I32(x) => Self::I32(x),
            Scalar::U32(x) => Self::U32(x),
            Scalar::Float(x) => Self::Float(x),
        }
    }
}

impl From<bool> for Value {
    fn from(x: bool) -> Self {
        Self::Bool(x)
    }
}

impl From<i32> for Value {
    fn from(x: i32) -> Self {
        Self::I32(x)
    }
}

impl From<u32> for Value {
    fn from(x: u32) -> Self {
        Self::U32(x)
    }
}

impl From<f64> for Value {
    fn from(x: f64) -> Self {
        Self::Float(x)
    }
}

impl<const N: usize> From<[f64; N]> for Value {
    /// A vector; `N` is 2 to 4.
    fn from(components: [f64; N]) -> Self {
        Self::vec(&components)
    }
}

impl fmt::Display for Value {
    /// Writes the value as in WGSL, but without type names: `1.5`, `(1, 2)`, `[(1, 2), (3, 4)]`,
    /// `{1, true}`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fn list<T: fmt::Display>(
            f: &mut fmt::Formatter<'_>,
            items: &[T],
            [open, close]: [&str; 2],
        ) -> fmt::Result {
            f.write_str(open)?;
            for (index, item) in items.iter().enumerate() {
                let separator = if index == 0 { "" } else { ", " };
                write!(f, "{separator}{item}")?;
            }
            f.write_str(close)
        }
        match self {
            Self::Vector(scalars) => list(f, scalars, ["(", ")"]),
            Self::Matrix { columns, components } => {
                let rows = components.len().checked_div(*columns).unwrap_or(0).max(1);
                let columns: Vec<Self> = components.chunks(rows).map(Self::vec).collect();
                list(f, &columns, ["(", ")"])
            }
            Self::Array(elements) => list(f, elements, ["[", "]"]),
            Self::Struct(members) => list(f, members, ["{", "}"]),
            Self::Bool(x) => x.fmt(f),
            Self::I32(x) => x.fmt(f),
            Self::U32(x) => x.fmt(f),
            Self::Float(x) => x.fmt(f),
        }
    }
}
