//! Record of what the expressions of one function may be, over all ways through it: what proves
//! that a branch is never taken and that a guard changes nothing.

use std::collections::hash_map::Entry;

use naga::{Expression, Handle};
use rustc_hash::FxHashMap;

use super::machine::{Knowledge, Ranges, joined_ranges};

/// Ranges of a function's expressions and of the arguments of its calls, for given arguments of
/// its own.
#[derive(Clone, Debug, Default)]
pub(in crate::compile) struct Trace {
    /// By index of the expression; `None` for what may be anything.
    values: FxHashMap<usize, Option<Ranges>>,
    /// By index of the call's result.
    arguments: FxHashMap<usize, Vec<Option<Ranges>>>,
}

impl Trace {
    /// Ranges of an expression wherever it is evaluated; `None` where they are not known.
    pub(in crate::compile) fn value(&self, handle: Handle<Expression>) -> Option<&Ranges> {
        self.values.get(&handle.index())?.as_ref()
    }

    /// Ranges of the arguments of a call, by the expression of its result.
    pub(in crate::compile) fn arguments(
        &self,
        result: Handle<Expression>,
    ) -> Option<&[Option<Ranges>]> {
        self.arguments.get(&result.index()).map(Vec::as_slice)
    }

    pub(super) fn record(&mut self, handle: Handle<Expression>, known: &Knowledge) {
        if let Knowledge::Value(ranges) = known {
            add(self.values.entry(handle.index()), ranges);
        }
    }

    pub(super) fn record_call(&mut self, result: Handle<Expression>, given: &[Ranges]) {
        let known = self
            .arguments
            .entry(result.index())
            .or_insert_with(|| given.iter().cloned().map(Some).collect());
        for (known, given) in known.iter_mut().zip(given) {
            let both = known.as_ref().and_then(|known| joined_ranges(known, given).ok());
            *known = both.map(Into::into);
        }
    }
}

fn add(entry: Entry<'_, usize, Option<Ranges>>, ranges: &Ranges) {
    let known = entry.or_insert_with(|| Some(ranges.clone()));
    let both = known.as_ref().and_then(|known| joined_ranges(known, ranges).ok());
    *known = both.map(Into::into);
}
