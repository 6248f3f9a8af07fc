//! Interval analysis: a sound range for every scalar of every value of a look.
//!
//! A node's function is run as naga IR on ranges instead of numbers, so that a custom node is
//! understood as well as one of the library, and no table of nodes is kept. Whatever a fragment
//! computes lies within the ranges: in f32, however WGSL lets a card round, and in the
//! interpreter's f32 and f64. What cannot be followed may be anything.
//!
//! - `range`: the domain: intervals with NaN and -0 told apart, integers with the size of a float's
//!   bits, truth values.
//! - `floats`: arithmetic, rounded outward.
//! - `machine`, `expressions`, `math`, `refine`: naga IR on ranges. Conditions that stay open split
//!   the way.
//! - `library`: the few functions whose operands hang together.
//! - `surroundings`: what is known of a context before any fragment runs.

mod expressions;
mod floats;
mod layout;
mod library;
mod machine;
mod math;
mod range;
mod refine;
mod surroundings;
mod trace;

#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::sync::LazyLock;

use naga::Handle;
use rustc_hash::FxHashMap;

use crate::interp;
use crate::library::{NodeModule, Type};
use crate::wgsl::{self, ValidModule};
use machine::Machine;

pub(super) use machine::Ranges;
pub(super) use math::floats;
pub(super) use range::{Floats, Length, Range};
pub(super) use surroundings::context_ranges;
pub(super) use trace::Trace;

/// The ranges of a node's function for arguments within these ranges; `None` where the function
/// cannot be followed.
pub(super) fn call(module: &NodeModule, function: &str, arguments: &[Ranges]) -> Option<Ranges> {
    let (valid, handle) = module.function(function)?;
    let own = |name: &str| is_of_library(module, name);
    Machine::new(valid, &own).call(handle, arguments).ok()
}

/// The record of a function's expressions for arguments within these ranges; `None` where the
/// function cannot be followed.
pub(super) fn trace(
    module: &NodeModule,
    valid: &ValidModule,
    function: Handle<naga::Function>,
    arguments: &[Ranges],
) -> Option<Trace> {
    let own = |name: &str| is_of_library(module, name);
    Machine::new(valid, &own).trace(function, arguments).ok()
}

/// Ranges of numbers that were made finite numbers of f32: NaN 0, and what is too large the largest
/// number of its sign.
pub(super) fn finite(ranges: &[Range]) -> Ranges {
    ranges.iter().map(|range| range.finite()).collect()
}

/// True if a function of a module has the text of the shader library's own.
fn is_of_library(module: &NodeModule, name: &str) -> bool {
    let text = module.declaration(name).map(|found| found.text);
    text.is_some() && text == LIBRARY_TEXTS.get(name).copied()
}

/// Anything of a type of naga's IR; `None` for what is no plain value.
pub(super) fn any_of(module: &naga::Module, ty: Handle<naga::Type>) -> Option<Ranges> {
    layout::tops_of(module, &module.types[ty].inner).map(Into::into)
}

/// Anything that an argument of a node's function may be; `None` for what is no plain value.
pub(super) fn any_argument(module: &NodeModule, function: &str, place: usize) -> Option<Ranges> {
    let (valid, handle) = module.function(function)?;
    let argument = valid.module.functions[handle].arguments.get(place)?;
    any_of(&valid.module, argument.ty)
}

/// Calls on ranges, each made once.
#[derive(Default)]
pub(super) struct Calls(FxHashMap<(usize, String, Vec<u64>), Option<Ranges>>);

impl Calls {
    /// [`call`], or what it gave for the same ranges before.
    pub(super) fn call(
        &mut self,
        module: &NodeModule,
        function: &str,
        arguments: &[Ranges],
    ) -> Option<Ranges> {
        let key = (std::ptr::from_ref(module) as usize, function.to_owned(), bits(arguments));
        self.0.entry(key).or_insert_with(|| call(module, function, arguments)).clone()
    }
}

/// Ranges of arguments, told apart from any others, for tables.
pub(super) fn bits(arguments: &[Ranges]) -> Vec<u64> {
    arguments.iter().flat_map(|ranges| ranges.iter()).flat_map(|range| range.bits()).collect()
}

/// Ranges that hold what either holds; `None` for values of two shapes.
pub(super) fn join(a: &Ranges, b: &Ranges) -> Option<Ranges> {
    let is_same = a.len() == b.len();
    let joined: Option<Vec<Range>> = a.iter().zip(b.iter()).map(|(a, b)| a.join(*b)).collect();
    joined.filter(|_| is_same).map(Into::into)
}

/// [`call`] for a module that imports the library and declares nothing that could be taken for a
/// part of it.
pub(super) fn call_plain(
    valid: &ValidModule,
    function: &str,
    arguments: &[Ranges],
) -> Option<Ranges> {
    run(valid, function, arguments, &|_| true)
}

fn run(
    valid: &ValidModule,
    function: &str,
    arguments: &[Ranges],
    own: &dyn Fn(&str) -> bool,
) -> Option<Ranges> {
    let (handle, _) =
        valid.module.functions.iter().find(|(_, f)| f.name.as_deref() == Some(function))?;
    Machine::new(valid, own).call(handle, arguments).ok()
}

/// The texts of the library's functions that [`library`] knows.
static LIBRARY_TEXTS: LazyLock<HashMap<&'static str, &'static str>> = LazyLock::new(|| {
    let mut texts = HashMap::new();
    for (source, scan) in wgsl::library_scans() {
        for declaration in &scan.declarations {
            if let Some(name) = library::NAMES.iter().find(|name| **name == declaration.name)
                && let Some(text) = source.get(declaration.body.clone())
            {
                texts.insert(*name, text);
            }
        }
    }
    texts
});

/// A value that is known.
pub(super) fn of_value(value: &interp::Value) -> Ranges {
    let mut ranges = Vec::new();
    push_ranges(value, &mut ranges);
    ranges.into()
}

fn push_ranges(value: &interp::Value, ranges: &mut Vec<Range>) {
    match value {
        interp::Value::Array(parts) | interp::Value::Struct(parts) => {
            parts.iter().for_each(|part| push_ranges(part, ranges));
        }
        other => {
            let mut own = Vec::new();
            push_scalars(other, &mut |scalar| own.push(Range::of_scalar(scalar)));
            ranges.extend(range::with_length(own));
        }
    }
}

/// Anything that has the shape of a value.
pub(super) fn any_like(value: &interp::Value) -> Ranges {
    let mut ranges = Vec::new();
    push_scalars(value, &mut |scalar| ranges.push(Range::any_like(scalar)));
    ranges.into()
}

fn push_scalars(value: &interp::Value, push: &mut dyn FnMut(interp::Scalar)) {
    match value {
        interp::Value::Vector(scalars) => scalars.iter().for_each(|&scalar| push(scalar)),
        interp::Value::Matrix { components, .. } => {
            components.iter().for_each(|&x| push(interp::Scalar::Float(x)));
        }
        interp::Value::Array(parts) | interp::Value::Struct(parts) => {
            parts.iter().for_each(|part| push_scalars(part, push));
        }
        other => other.as_scalar().into_iter().for_each(push),
    }
}

/// The only value of type `ty` that lies within the ranges, to the bit.
pub(super) fn exactly(ranges: &[Range], ty: &Type) -> Option<interp::Value> {
    let width = ty.width()?;
    let scalars = ranges.iter().map(|range| range.exactly()).collect::<Option<Vec<_>>>()?;
    match scalars.as_slice() {
        [one] if width == 1 => Some((*one).into()),
        many if many.len() == width => Some(interp::Value::Vector(scalars)),
        _ => None,
    }
}

/// The number of scalars in a value of this type, where the type alone tells.
pub(super) fn scalars_in(ty: &Type) -> Option<usize> {
    Some(match ty {
        Type::Mat3 => 9,
        Type::Angle => 2,
        Type::Light => 10,
        other => other.width()?,
    })
}
