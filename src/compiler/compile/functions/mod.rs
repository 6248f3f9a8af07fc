//! Functions of nodes, written for the arguments that a look gives them.
//!
//! A function of the library gives a documented result for every input, and guards it. Where the
//! ranges of its arguments prove that a guard changes nothing or a branch is never taken, the
//! module gets the function without it: as an expression in its caller where it comes to one, else
//! as a function of its own. A function of which nothing is proved stands as it does in its file,
//! with its comments.
//!
//! - `code`: statements and expressions.
//! - `print`: their WGSL.
//! - `constant`: expressions that WGSL computes when a shader is made.
//! - `facts`: what ranges prove about arguments, for the rules that stand in the library's files.
//! - `lower`: from naga's IR to statements, by the record that `intervals` keeps.
//! - `reshape`: statements in the form in which people would write them.

mod code;
mod constant;
mod facts;
mod lower;
mod print;
mod reshape;

#[cfg(test)]
mod tests;

use std::rc::Rc;
use std::sync::Arc;

use naga::Handle;
use rustc_hash::{FxHashMap, FxHashSet};

use super::intervals::{self, Ranges};
use crate::document::Tier;
use crate::interp::Literals;
use crate::library::NodeModule;
use crate::wgsl::ValidModule;

pub(super) use code::{Callee, Code, Line, each_code};
pub(super) use lower::Body;
pub use print::write_line;
pub(super) use print::{CodeNames, LINE, level, write_lines};

/// Most operators of an expression that stands in its caller in place of a call.
const MOST_INLINED: usize = 9;

/// Most operators of two results between which a condition selects, in place of a branch.
const MOST_SELECTED: usize = 6;

/// Deepest calls within calls that are written anew.
const MOST_DEPTH: usize = 40;

/// A function for certain arguments.
#[derive(Clone, Debug)]
pub(super) enum CallForm {
    /// Function as it stands in its file.
    Original,
    /// An expression of its parameters; `true` if it is not just what its file says.
    Expression(Rc<Code>, bool),
    /// A function of its own, by index.
    Made(usize),
}

/// The part of a module that naga has read for a function.
#[derive(Clone, Copy)]
struct Scope<'m> {
    module: &'m NodeModule,
    valid: &'m ValidModule,
    literals: &'m Literals,
}

/// A function that was written anew.
#[derive(Debug)]
pub(super) struct MadeFunction {
    /// The name in its file.
    pub(super) name: Rc<str>,
    pub(super) body: Body,
}

/// Names that a part of a module declares.
#[derive(Debug)]
struct DeclaredNames {
    functions: FxHashMap<String, Handle<naga::Function>>,
    constants: FxHashSet<String>,
}

impl DeclaredNames {
    fn of(module: &naga::Module) -> Self {
        let functions = module.functions.iter();
        Self {
            functions: functions
                .filter_map(|(handle, function)| Some((function.name.clone()?, handle)))
                .collect(),
            constants: module.constants.iter().filter_map(|(_, c)| c.name.clone()).collect(),
        }
    }

    fn has(&self, name: &str) -> bool {
        self.functions.contains_key(name) || self.constants.contains(name)
    }
}

type CallKey = (usize, Rc<str>, Tier, Vec<u64>);

/// All functions that a module needs, each written once.
#[derive(Debug, Default)]
pub(super) struct SpecializedFunctions {
    pub(super) made: Vec<MadeFunction>,
    by_body: FxHashMap<(usize, Rc<str>, Body), usize>,
    by_call: FxHashMap<CallKey, CallForm>,
    /// By address of the part of a module.
    declared: FxHashMap<usize, Rc<DeclaredNames>>,
    depth: usize,
}

impl SpecializedFunctions {
    /// The function of a module for arguments within these ranges.
    pub(super) fn specialize(
        &mut self,
        module: &NodeModule,
        name: &str,
        tier: Tier,
        arguments: &[Ranges],
    ) -> CallForm {
        let Ok((valid, literals)) = module.read(name) else { return CallForm::Original };
        self.within(Scope { module, valid, literals }, name, tier, arguments)
    }

    /// The function for arguments within these ranges, as a part of its module that naga has read.
    fn within(
        &mut self,
        scope: Scope<'_>,
        name: &str,
        tier: Tier,
        arguments: &[Ranges],
    ) -> CallForm {
        let module_key = std::ptr::from_ref(scope.module) as usize;
        let key: CallKey = (module_key, name.into(), tier, intervals::bits(arguments));
        if let Some(known) = self.by_call.get(&key) {
            return known.clone();
        }
        let specialized = if self.depth < MOST_DEPTH {
            self.depth += 1;
            let specialized = self.written(scope, module_key, name, tier, arguments);
            self.depth -= 1;
            specialized.unwrap_or(CallForm::Original)
        } else {
            CallForm::Original
        };
        self.by_call.insert(key, specialized.clone());
        specialized
    }

    fn written(
        &mut self,
        scope: Scope<'_>,
        module_key: usize,
        name: &str,
        tier: Tier,
        arguments: &[Ranges],
    ) -> Option<CallForm> {
        let rules = scope.module.rules(name);
        let rule = rules.iter().find(|rule| facts::all_hold(&rule.facts, tier, arguments));
        let wanted = rule.map_or(name, |rule| &rule.function);
        let declared = self.declared.entry(std::ptr::from_ref(scope.valid) as usize);
        let declared =
            declared.or_insert_with(|| Rc::new(DeclaredNames::of(&scope.valid.module))).clone();
        let handle = *declared.functions.get(wanted)?;
        let trace = intervals::trace(scope.module, scope.valid, handle, arguments)?;
        let (body, is_changed) =
            lower::lower(self, (scope, declared), handle, tier, arguments, trace).ok()?;
        let mut is_refused = false;
        each_code(&body.lines, &mut |code| is_refused |= code.may_be_refused());
        if is_refused {
            return None;
        }
        let is_changed = is_changed || rule.is_some();
        if let [Line::Return(code)] = body.lines.as_slice()
            && code.size() <= MOST_INLINED
        {
            return Some(CallForm::Expression(Rc::new(code.clone()), is_changed));
        }
        if !is_changed {
            return Some(CallForm::Original);
        }
        Some(self.make(module_key, name, body))
    }

    /// A call of a function in place of an expression of its parameters; of the one that stands in
    /// its file where nothing about it has changed.
    pub(super) fn function_of(
        &mut self,
        module: &Arc<NodeModule>,
        name: &str,
        code: &Code,
        is_changed: bool,
    ) -> CallForm {
        if !is_changed {
            return CallForm::Original;
        }
        self.make(module_key(module), name, Body::returning(code.clone()))
    }

    /// Number of operations of a call in its form, those of called functions included.
    pub(super) fn operations(&self, module: &NodeModule, name: &str, form: &CallForm) -> u64 {
        match form {
            CallForm::Original => module.operations(name),
            CallForm::Expression(code, _) => self.operations_of(module, code),
            CallForm::Made(index) => self.operations_of_made(module, *index),
        }
    }

    /// True if another function of the same name takes at most so many operations more.
    pub(super) fn is_alike(
        &self,
        module: &NodeModule,
        [index, other]: [usize; 2],
        most: u64,
    ) -> bool {
        let count = |index: usize| self.operations_of_made(module, index);
        self.made[index].name == self.made[other].name && count(other) <= count(index) + most
    }

    fn operations_of_made(&self, module: &NodeModule, index: usize) -> u64 {
        let mut count = 0;
        each_code(&self.made[index].body.lines, &mut |code| {
            count += self.operations_of_one(module, code);
        });
        count
    }

    fn operations_of(&self, module: &NodeModule, code: &Code) -> u64 {
        let mut count = 0;
        code.each(&mut |code| count += self.operations_of_one(module, code));
        count
    }

    /// Operations of an expression without those of its parts. Functions call no function that is
    /// not made before them, so that this ends.
    fn operations_of_one(&self, module: &NodeModule, code: &Code) -> u64 {
        match code {
            Code::Call(Callee::Original(name), _) => module.operations(name),
            Code::Call(Callee::Made(index), _) => self.operations_of_made(module, *index),
            Code::Unary(..) | Code::Binary(..) => 1,
            // Putting a vector together is free.
            Code::BuiltIn(name, _) => u64::from(!name.starts_with("vec")),
            _ => 0,
        }
    }

    fn make(&mut self, module: usize, name: &str, body: Body) -> CallForm {
        let key = (module, Rc::from(name), body);
        if let Some(&index) = self.by_body.get(&key) {
            return CallForm::Made(index);
        }
        let index = self.made.len();
        let (_, name, body) = key.clone();
        self.made.push(MadeFunction { name, body });
        self.by_body.insert(key, index);
        CallForm::Made(index)
    }
}

/// The address that tells modules apart.
pub(super) fn module_key(module: &Arc<NodeModule>) -> usize {
    Arc::as_ptr(module) as usize
}
