//! Functions of naga's IR as statements, without what their arguments rule out.
//!
//! The record of the function's expressions for the ranges of its arguments decides conditions and
//! selections; calls become those of functions that are written for their own arguments, or the
//! expressions that these come to. What naga made of one expression of the text becomes one
//! expression again, and names stay, so that people can read the result beside the file.
//!
//! - `branches`: conditions, `&&` and `||`, and `switch`.
//! - `expressions`: literals, vectors and their parts, and all that needs no decision.
//! - `operators`: arithmetic, selections and WGSL's own functions, where ranges may decide.
//! - `images`: samples, texels and sizes of textures.
//! - `known`: ranges of expressions, and the literals of those that have one value.
//! - `types`: names of types.

mod branches;
mod expressions;
mod images;
mod known;
mod operators;
mod types;

use std::collections::HashSet;
use std::rc::Rc;

use naga::{Block, Expression, Handle, LocalVariable, Statement, TypeInner};
use rustc_hash::FxHashMap;

use super::code::{Callee, Code, Line};
use super::reshape::reshaped;
use super::{CallForm, DeclaredNames, Scope, SpecializedFunctions};
use crate::compile::intervals::{self, Ranges, Trace};
use crate::document::Tier;

/// A function's statements, with the names of its variables.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::compile) struct Body {
    pub(in crate::compile) lines: Vec<Line>,
    pub(in crate::compile) locals: Vec<String>,
    /// The types of variables, as they are written.
    types: Vec<String>,
}

impl Body {
    /// A body that returns an expression.
    pub(super) fn returning(code: Code) -> Self {
        Self { lines: vec![Line::Return(code)], locals: Vec::new(), types: Vec::new() }
    }

    /// The types of variables, as they are written.
    pub(in crate::compile) fn types(&self) -> impl Iterator<Item = &String> {
        self.types.iter()
    }
}

/// Refusal of a function that holds something that is not written anew: it stays as it is.
pub(super) struct NotWritten;

type WriteResult<T> = Result<T, NotWritten>;

/// A function, written anew for arguments within these ranges, and whether anything about it has
/// changed.
pub(super) fn lower(
    functions: &mut SpecializedFunctions,
    (scope, declared): (Scope<'_>, Rc<DeclaredNames>),
    handle: Handle<naga::Function>,
    tier: Tier,
    arguments: &[Ranges],
    trace: Trace,
) -> WriteResult<(Body, bool)> {
    let function = &scope.valid.module.functions[handle];
    let taken: HashSet<String> =
        function.arguments.iter().filter_map(|argument| argument.name.clone()).collect();
    let mut lowering = FunctionWriter {
        functions,
        scope,
        function,
        info: &scope.valid.info[handle],
        tier,
        arguments,
        trace,
        declared,
        taken,
        locals: Vec::new(),
        variables: FxHashMap::default(),
        conditions: FxHashMap::default(),
        bound: FxHashMap::default(),
        open: Vec::new(),
        is_changed: false,
    };
    let mut lines = lowering.declarations()?;
    lines.extend(lowering.block(&function.body)?);
    let result = function.result.as_ref().map(|result| &scope.valid.module.types[result.ty].inner);
    let can_select = matches!(result, Some(TypeInner::Scalar(_) | TypeInner::Vector { .. }));
    let lines = reshaped(lines, can_select);
    let types = lines
        .iter()
        .filter_map(|line| if let Line::Var(_, ty, _) = line { Some(ty.to_string()) } else { None })
        .collect();
    Ok((Body { lines, locals: lowering.locals, types }, lowering.is_changed))
}

/// A function that is being written.
struct FunctionWriter<'a> {
    functions: &'a mut SpecializedFunctions,
    scope: Scope<'a>,
    function: &'a naga::Function,
    info: &'a naga::valid::FunctionInfo,
    tier: Tier,
    arguments: &'a [Ranges],
    trace: Trace,
    declared: Rc<DeclaredNames>,
    /// Names of parameters and locals.
    taken: HashSet<String>,
    locals: Vec<String>,
    /// The locals that are variables of the text.
    variables: FxHashMap<Handle<LocalVariable>, usize>,
    /// The conditions that naga's own variables for `&&` and `||` hold.
    conditions: FxHashMap<Handle<LocalVariable>, Code>,
    /// Code that stands for expressions with a name, and for calls, where they are read.
    bound: FxHashMap<Handle<Expression>, Code>,
    /// The blocks that are being written, the innermost last.
    open: Vec<Vec<Line>>,
    is_changed: bool,
}

impl FunctionWriter<'_> {
    fn local(&mut self, wanted: &str) -> usize {
        let mut name = wanted.to_owned();
        let mut count = 2;
        while self.declared.has(&name) || !self.taken.insert(name.clone()) {
            name = format!("{wanted}_{count}");
            count += 1;
        }
        self.locals.push(name);
        self.locals.len() - 1
    }

    fn write(&mut self, line: Line) {
        if let Some(lines) = self.open.last_mut() {
            lines.push(line);
        }
    }

    fn declarations(&mut self) -> WriteResult<Vec<Line>> {
        let mut lines = Vec::new();
        for (handle, variable) in self.function.local_variables.iter() {
            let Some(name) = &variable.name else { continue };
            let index = self.local(name);
            self.variables.insert(handle, index);
            let ty = self.type_text(&self.scope.valid.module.types[variable.ty])?;
            let init = variable.init.map(|init| self.code(init)).transpose()?;
            lines.push(Line::Var(index, ty.into(), init));
        }
        Ok(lines)
    }

    fn block(&mut self, block: &Block) -> WriteResult<Vec<Line>> {
        self.open.push(Vec::new());
        let result = self.statements(block);
        let lines = self.open.pop().unwrap_or_default();
        result.map(|_| lines)
    }

    /// Writes statements to the innermost block; `false` where nothing comes after them.
    fn statements(&mut self, block: &Block) -> WriteResult<bool> {
        for statement in block {
            if !self.statement(statement)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn statement(&mut self, statement: &Statement) -> WriteResult<bool> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    if self.function.named_expressions.contains_key(&handle) {
                        self.bind(handle)?;
                    }
                }
            }
            Statement::Block(inner) => return self.statements(inner),
            Statement::If { condition, accept, reject } => {
                return self.branch(*condition, accept, reject);
            }
            Statement::Switch { selector, cases } => return self.switch(*selector, cases),
            Statement::Loop { body, continuing, break_if } => {
                let body = self.block(body)?;
                self.open.push(Vec::new());
                let after = self.statements(continuing);
                let end = break_if.map(|condition| self.code(condition)).transpose();
                let continuing = self.open.pop().unwrap_or_default();
                after?;
                self.write(Line::Loop(body, continuing, end?));
            }
            Statement::Break => {
                self.write(Line::Break);
                return Ok(false);
            }
            Statement::Continue => {
                self.write(Line::Continue);
                return Ok(false);
            }
            Statement::Kill => {
                self.write(Line::Discard);
                return Ok(false);
            }
            Statement::Return { value } => {
                let value = self.code(value.ok_or(NotWritten)?)?;
                self.write(Line::Return(value));
                return Ok(false);
            }
            Statement::Store { pointer, value } => {
                let (place, value) = (self.code(*pointer)?, self.code(*value)?);
                self.write(Line::Assign(place, value));
            }
            Statement::Call { function, arguments, result } => {
                self.call(*function, arguments, result.ok_or(NotWritten)?)?;
            }
            _ => return Err(NotWritten),
        }
        Ok(true)
    }

    /// Gives a named expression its name, unless it is as short as one.
    fn bind(&mut self, handle: Handle<Expression>) -> WriteResult<()> {
        let code = self.code(handle)?;
        self.bind_code(handle, code);
        Ok(())
    }

    fn bind_code(&mut self, handle: Handle<Expression>, code: Code) {
        let code = match self.function.named_expressions.get(&handle) {
            Some(name) if !self.is_alias(&code) => {
                let index = self.local(&name.clone());
                self.write(Line::Let(index, code));
                Code::Local(index)
            }
            _ => code,
        };
        self.bound.insert(handle, code);
    }

    /// True for what cannot change and is no longer than a name.
    fn is_alias(&self, code: &Code) -> bool {
        let mut is_fixed = true;
        code.each(&mut |code| {
            if let Code::Local(index) = code {
                is_fixed &= !self.variables.values().any(|variable| variable == index);
            }
        });
        is_fixed && code.is_simple()
    }

    /// The parameter that a guard gives back as it is: callers whose numbers differ share what is
    /// written with it, where a literal would be of one caller alone.
    fn parameter_in_place(
        &mut self,
        arguments: &[Handle<Expression>],
        result: Handle<Expression>,
    ) -> WriteResult<Option<Code>> {
        let Some(&first) = arguments.first() else { return Ok(None) };
        if self.ranges(first) != self.ranges(result) {
            return Ok(None);
        }
        Ok(Some(self.code(first)?).filter(|code| matches!(code, Code::Parameter(_))))
    }

    fn call(
        &mut self,
        function: Handle<naga::Function>,
        arguments: &[Handle<Expression>],
        result: Handle<Expression>,
    ) -> WriteResult<()> {
        if let Some(literal) = self.known(result) {
            self.is_changed = true;
            let same = self.parameter_in_place(arguments, result)?;
            self.bind_code(result, same.unwrap_or(literal));
            return Ok(());
        }
        let module = &self.scope.valid.module;
        let callee = &module.functions[function];
        let name = callee.name.clone().ok_or(NotWritten)?;
        let recorded = self.trace.arguments(result).map(<[_]>::to_vec);
        let mut given = Vec::with_capacity(arguments.len());
        for (index, parameter) in callee.arguments.iter().enumerate() {
            let known = recorded.as_ref().and_then(|recorded| recorded.get(index)?.clone());
            let any = || intervals::any_of(module, parameter.ty);
            given.push(known.or_else(any).unwrap_or_else(|| Ranges::from([])));
        }
        let mut codes = Vec::with_capacity(arguments.len());
        for &argument in arguments {
            codes.push(self.code(argument)?);
        }
        let code = match self.functions.within(self.scope, &name, self.tier, &given) {
            CallForm::Original => Code::Call(Callee::Original(name.into()), codes),
            CallForm::Made(index) => {
                self.is_changed = true;
                Code::Call(Callee::Made(index), codes)
            }
            CallForm::Expression(body, is_changed) => {
                self.is_changed |= is_changed;
                let parameters: Vec<String> = callee
                    .arguments
                    .iter()
                    .map(|argument| argument.name.clone().unwrap_or_default())
                    .collect();
                for (index, code) in codes.iter_mut().enumerate() {
                    if body.reads(index) > 1 && !self.is_alias(code) {
                        let local = self.local(&parameters[index]);
                        self.write(Line::Let(local, code.clone()));
                        *code = Code::Local(local);
                    }
                }
                body.with_arguments(&codes)
            }
        };
        self.bind_code(result, code);
        Ok(())
    }
}
