//! From a function of naga's IR to statements of its own, without what its arguments rule out.
//!
//! The record of the function's expressions for the ranges of its arguments decides conditions and
//! selections; calls become those of functions that are written for their own arguments, or the
//! expressions that these come to. What naga made of one expression of the text becomes one
//! expression again, and names stay, so that people can read the result beside the file.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use naga::common::wgsl::TryToWgsl as _;
use naga::{
    BinaryOperator as Op, Block, Expression, Handle, LocalVariable, Statement, SwitchValue,
    TypeInner, UnaryOperator,
};

use super::code::{Callee, Code, Line, level, without_unread};
use super::{Scope, Specialized, SpecializedFunctions};
use crate::compile::emit::float_literal;
use crate::compile::intervals::{Floats, Range, Ranges, Trace};
use crate::document::Tier;
use crate::interp::Scalar;

/// Longest text of a literal that is taken over as it was written, in bytes.
const LONGEST_LITERAL: usize = 60;

/// Most operators of two results between which a condition selects, in place of a branch.
const MOST_SELECTED: usize = 6;

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

/// The function holds something that is not written anew, and stays as it is.
pub(super) struct NotWritten;

type Written<T> = Result<T, NotWritten>;

/// Writes a function anew for arguments within these ranges. Also says whether anything about it
/// has changed.
pub(super) fn lower(
    functions: &mut SpecializedFunctions,
    scope: Scope<'_>,
    handle: Handle<naga::Function>,
    tier: Tier,
    arguments: &[Ranges],
    trace: Trace,
) -> Written<(Body, bool)> {
    let function = &scope.valid.module.functions[handle];
    let mut taken: HashSet<String> =
        function.arguments.iter().filter_map(|argument| argument.name.clone()).collect();
    let declared = scope.valid.module.functions.iter().filter_map(|(_, f)| f.name.clone());
    let constants = scope.valid.module.constants.iter().filter_map(|(_, c)| c.name.clone());
    taken.extend(declared.chain(constants));
    let mut lowering = Lowering {
        functions,
        scope,
        function,
        info: &scope.valid.info[handle],
        tier,
        arguments,
        trace,
        taken,
        locals: Vec::new(),
        variables: HashMap::new(),
        conditions: HashMap::new(),
        bound: HashMap::new(),
        open: Vec::new(),
        is_changed: false,
    };
    let mut lines = lowering.declarations()?;
    lines.extend(lowering.block(&function.body)?);
    let lines = collapsed(selected(without_unread(with_declarations_late(lines))));
    let types = lines
        .iter()
        .filter_map(|line| if let Line::Var(_, ty, _) = line { Some(ty.to_string()) } else { None })
        .collect();
    Ok((Body { lines, locals: lowering.locals, types }, lowering.is_changed))
}

struct Lowering<'a> {
    functions: &'a mut SpecializedFunctions,
    scope: Scope<'a>,
    function: &'a naga::Function,
    info: &'a naga::valid::FunctionInfo,
    tier: Tier,
    arguments: &'a [Ranges],
    trace: Trace,
    taken: HashSet<String>,
    locals: Vec<String>,
    /// The locals that are variables of the text.
    variables: HashMap<Handle<LocalVariable>, usize>,
    /// What naga's own variables for `&&` and `||` hold.
    conditions: HashMap<Handle<LocalVariable>, Code>,
    /// What expressions with a name, and calls, are read as.
    bound: HashMap<Handle<Expression>, Code>,
    /// The blocks that are being written, the innermost last.
    open: Vec<Vec<Line>>,
    is_changed: bool,
}

impl Lowering<'_> {
    fn local(&mut self, wanted: &str) -> usize {
        let mut name = wanted.to_owned();
        let mut count = 2;
        while !self.taken.insert(name.clone()) {
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

    fn declarations(&mut self) -> Written<Vec<Line>> {
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

    fn block(&mut self, block: &Block) -> Written<Vec<Line>> {
        self.open.push(Vec::new());
        let result = self.statements(block);
        let lines = self.open.pop().unwrap_or_default();
        result.map(|_| lines)
    }

    /// Writes statements to the innermost block; `false` where nothing comes after them.
    fn statements(&mut self, block: &Block) -> Written<bool> {
        for statement in block {
            if !self.statement(statement)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn statement(&mut self, statement: &Statement) -> Written<bool> {
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
    fn bind(&mut self, handle: Handle<Expression>) -> Written<()> {
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

    fn branch(
        &mut self,
        condition: Handle<Expression>,
        accept: &Block,
        reject: &Block,
    ) -> Written<bool> {
        if let Some(variable) = self.variable_of_logic(accept) {
            let code = self.logic(condition, accept, reject)?;
            self.conditions.insert(variable, code);
            return Ok(true);
        }
        if let Some(known) = self.truth(condition) {
            self.is_changed = true;
            return self.statements(if known { accept } else { reject });
        }
        let condition = self.code(condition)?;
        match condition {
            Code::Text(ref text, _) if &**text == "true" || &**text == "false" => {
                self.is_changed = true;
                return self.statements(if &**text == "true" { accept } else { reject });
            }
            _ => {}
        }
        let accept = self.block(accept)?;
        let reject = self.block(reject)?;
        let ends = |lines: &[Line]| {
            matches!(
                lines.last(),
                Some(Line::Return(_) | Line::Break | Line::Continue | Line::Discard)
            )
        };
        let goes_on = !(ends(&accept) && ends(&reject));
        match (accept.is_empty(), reject.is_empty()) {
            (true, true) => {}
            (true, false) => self.write(Line::If(negated(condition), reject, Vec::new())),
            // What follows a branch that ends stands without an `else`.
            _ if ends(&accept) && !reject.is_empty() => {
                self.write(Line::If(condition, accept, Vec::new()));
                for line in reject {
                    self.write(line);
                }
            }
            _ => self.write(Line::If(condition, accept, reject)),
        }
        Ok(goes_on)
    }

    /// The variable without a name that naga made for `&&` and `||`, if this is its branch.
    fn variable_of_logic(&self, accept: &Block) -> Option<Handle<LocalVariable>> {
        let Some(Statement::Store { pointer, .. }) = accept.last() else { return None };
        let Expression::LocalVariable(variable) = self.function.expressions[*pointer] else {
            return None;
        };
        self.function.local_variables[variable].name.is_none().then_some(variable)
    }

    fn logic(
        &mut self,
        condition: Handle<Expression>,
        accept: &Block,
        reject: &Block,
    ) -> Written<Code> {
        let Some(Statement::Store { value: otherwise, .. }) = reject.last() else {
            return Err(NotWritten);
        };
        let is_or = match self.function.expressions[*otherwise] {
            Expression::Literal(naga::Literal::Bool(is_or)) => is_or,
            _ => return Err(NotWritten),
        };
        let left = match (&self.function.expressions[condition], is_or) {
            (Expression::Unary { op: UnaryOperator::LogicalNot, expr }, true) => *expr,
            (_, false) => condition,
            _ => return Err(NotWritten),
        };
        let truth = self.truth(left);
        if truth == Some(is_or) {
            self.is_changed = true;
            return Ok(Code::Text(is_or.to_string().into(), level::ATOM));
        }
        let left = self.code(left)?;
        let count = accept.len();
        for statement in accept.iter().take(count - 1) {
            self.statement(statement)?;
        }
        let Some(Statement::Store { value, .. }) = accept.last() else { return Err(NotWritten) };
        let right = self.code(*value)?;
        Ok(match truth {
            Some(_) => {
                self.is_changed = true;
                right
            }
            None => logic_of(is_or, left, right),
        })
    }

    fn switch(
        &mut self,
        selector: Handle<Expression>,
        cases: &[naga::SwitchCase],
    ) -> Written<bool> {
        let number = |value: SwitchValue| match value {
            SwitchValue::I32(x) => Some(i64::from(x)),
            SwitchValue::U32(x) => Some(i64::from(x)),
            SwitchValue::Default => None,
        };
        let known = match self.ranges(selector).as_deref() {
            Some([one]) => one.whole(),
            _ => None,
        };
        if let Some(known) = known {
            let at = cases
                .iter()
                .position(|case| number(case.value) == Some(known))
                .or_else(|| cases.iter().position(|case| case.value == SwitchValue::Default));
            // Cases with several values are empty ones that fall through.
            let body = at.and_then(|at| cases[at..].iter().find(|case| !case.fall_through));
            let body = &body.ok_or(NotWritten)?.body;
            self.is_changed = true;
            let last = body.len().saturating_sub(1);
            for (index, statement) in body.iter().enumerate() {
                match statement {
                    Statement::Break if index == last => return Ok(true),
                    statement if breaks(statement) => return Err(NotWritten),
                    statement => {
                        if !self.statement(statement)? {
                            return Ok(false);
                        }
                    }
                }
            }
            return Ok(true);
        }
        let selector = self.code(selector)?;
        let mut written = Vec::new();
        let mut values: Vec<String> = Vec::new();
        for case in cases {
            values.push(match case.value {
                SwitchValue::I32(x) => x.to_string(),
                SwitchValue::U32(x) => format!("{x}u"),
                SwitchValue::Default => "default".to_owned(),
            });
            if case.fall_through {
                if !case.body.is_empty() {
                    return Err(NotWritten);
                }
                continue;
            }
            let mut body = self.block(&case.body)?;
            if body.last() == Some(&Line::Break) {
                body.pop();
            }
            let value = if values.len() == 1 { values.remove(0) } else { values.join(", ") };
            values.clear();
            written.push((value, body));
        }
        self.write(Line::Switch(selector, written));
        Ok(true)
    }

    fn call(
        &mut self,
        function: Handle<naga::Function>,
        arguments: &[Handle<Expression>],
        result: Handle<Expression>,
    ) -> Written<()> {
        if let Some(literal) = self.known(result) {
            self.is_changed = true;
            self.bind_code(result, literal);
            return Ok(());
        }
        let module = &self.scope.valid.module;
        let callee = &module.functions[function];
        let name = callee.name.clone().ok_or(NotWritten)?;
        let recorded = self.trace.arguments(result).map(<[_]>::to_vec);
        let mut given = Vec::with_capacity(arguments.len());
        for (index, parameter) in callee.arguments.iter().enumerate() {
            let known = recorded.as_ref().and_then(|recorded| recorded.get(index)?.clone());
            let any = || super::super::intervals::any_of(module, parameter.ty);
            given.push(known.or_else(any).unwrap_or_else(|| Ranges::from([])));
        }
        let mut codes = Vec::with_capacity(arguments.len());
        for &argument in arguments {
            codes.push(self.code(argument)?);
        }
        let code = match self.functions.within(self.scope, &name, self.tier, &given) {
            Specialized::Original => Code::Call(Callee::Original(name.into()), codes),
            Specialized::Made(index) => {
                self.is_changed = true;
                Code::Call(Callee::Made(index), codes)
            }
            Specialized::Expression(body, is_changed) => {
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

    /// The ranges of an expression, wherever it is evaluated.
    fn ranges(&self, handle: Handle<Expression>) -> Option<Ranges> {
        match &self.function.expressions[handle] {
            Expression::FunctionArgument(index) => self.arguments.get(*index as usize).cloned(),
            _ => self.trace.value(handle).cloned(),
        }
    }

    fn truth(&self, handle: Handle<Expression>) -> Option<bool> {
        match self.ranges(handle).as_deref() {
            Some([one]) => one.truth(),
            _ => None,
        }
    }

    /// The literal of an expression that has one value only.
    fn known(&self, handle: Handle<Expression>) -> Option<Code> {
        let ranges = self.ranges(handle)?;
        let inner = self.inner(handle);
        let scalars: Vec<Scalar> =
            ranges.iter().map(|range| range.exactly()).collect::<Option<_>>()?;
        let one = |scalar: &Scalar, is_unsigned: bool| match scalar {
            Scalar::Float(x) => float_literal(*x),
            Scalar::I32(x) if is_unsigned => format!("{x}u"),
            Scalar::I32(x) => x.to_string(),
            Scalar::U32(x) => format!("{x}u"),
            Scalar::Bool(x) => x.to_string(),
        };
        match (inner, scalars.as_slice()) {
            (TypeInner::Scalar(kind), [scalar]) => {
                let is_unsigned = kind.kind == naga::ScalarKind::Uint;
                Some(Code::number(&one(scalar, is_unsigned)))
            }
            (TypeInner::Vector { scalar, .. }, scalars)
                if scalar.kind == naga::ScalarKind::Float =>
            {
                let mut parts: Vec<Code> =
                    scalars.iter().map(|scalar| Code::number(&one(scalar, false))).collect();
                if parts.iter().all(|part| *part == parts[0]) {
                    parts.truncate(1);
                }
                let name = self.inner_text(inner).ok()?;
                Some(Code::BuiltIn(name.into(), parts))
            }
            _ => None,
        }
    }

    fn inner(&self, handle: Handle<Expression>) -> &TypeInner {
        self.info[handle].ty.inner_with(&self.scope.valid.module.types)
    }

    fn floats(&self, handle: Handle<Expression>) -> Option<Vec<Floats>> {
        let ranges = self.ranges(handle)?;
        ranges
            .iter()
            .map(|range| if let Range::Float(x) = range { Some(*x) } else { None })
            .collect()
    }

    fn is_all(&self, handle: Handle<Expression>, holds: impl Fn(Floats) -> bool) -> bool {
        self.floats(handle).is_some_and(|all| !all.is_empty() && all.into_iter().all(holds))
    }

    fn code(&mut self, handle: Handle<Expression>) -> Written<Code> {
        if let Some(bound) = self.bound.get(&handle) {
            return Ok(bound.clone());
        }
        let expression = &self.function.expressions[handle];
        // Put together from parts of another vector, it is that vector.
        if let Expression::Compose { ty, components } = expression
            && let Some(whole) = self.whole(&self.scope.valid.module.types[*ty], components)?
        {
            return Ok(whole);
        }
        let is_written = matches!(
            expression,
            Expression::Literal(_) | Expression::Constant(_) | Expression::LocalVariable(_)
        );
        if !is_written && let Some(known) = self.known(handle) {
            // A vector of constants is the same in other words.
            self.is_changed |= !matches!(
                expression,
                Expression::Compose { .. } | Expression::Splat { .. } | Expression::ZeroValue(_)
            );
            return Ok(known);
        }
        Ok(match expression {
            Expression::Literal(literal) => self.literal(handle, *literal)?,
            Expression::Constant(constant) => {
                let name = self.scope.valid.module.constants[*constant].name.as_deref();
                Code::Constant(name.ok_or(NotWritten)?.into())
            }
            Expression::ZeroValue(ty) => Code::BuiltIn(
                self.type_text(&self.scope.valid.module.types[*ty])?.into(),
                Vec::new(),
            ),
            Expression::Compose { ty, components } => {
                let ty = &self.scope.valid.module.types[*ty];
                let parts =
                    components.iter().map(|&part| self.code(part)).collect::<Written<Vec<_>>>()?;
                let name: Rc<str> = self.type_text(ty)?.into();
                if matches!(ty.inner, TypeInner::Struct { .. }) {
                    Code::Struct(name, parts)
                } else {
                    Code::BuiltIn(name, parts).simplified()
                }
            }
            Expression::Splat { value, .. } => {
                let name = self.inner_text(self.inner(handle))?;
                Code::BuiltIn(name.into(), vec![self.code(*value)?])
            }
            Expression::Swizzle { size, vector, pattern } => {
                let name: String = pattern
                    .iter()
                    .take(*size as usize)
                    .map(|component| ["x", "y", "z", "w"][*component as usize])
                    .collect();
                self.member(*vector, &name)?
            }
            Expression::AccessIndex { base, index } => self.access(*base, *index)?,
            Expression::Access { base, index } => {
                Code::Index(Box::new(self.code(*base)?), Box::new(self.code(*index)?))
            }
            Expression::FunctionArgument(index) => Code::Parameter(*index as usize),
            Expression::LocalVariable(variable) => {
                Code::Local(*self.variables.get(variable).ok_or(NotWritten)?)
            }
            Expression::Load { pointer } => {
                if let Expression::LocalVariable(variable) = self.function.expressions[*pointer]
                    && let Some(condition) = self.conditions.get(&variable)
                {
                    return Ok(condition.clone());
                }
                self.code(*pointer)?
            }
            Expression::Unary { op, expr } => {
                let operator = match op {
                    UnaryOperator::Negate => "-",
                    UnaryOperator::LogicalNot => "!",
                    UnaryOperator::BitwiseNot => "~",
                };
                let code = self.code(*expr)?;
                if *op == UnaryOperator::LogicalNot {
                    negated(code)
                } else {
                    Code::Unary(operator, Box::new(code))
                }
            }
            Expression::Binary { op, left, right } => self.binary(*op, *left, *right)?,
            Expression::Select { condition, accept, reject } => {
                self.select(*condition, *accept, *reject)?
            }
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let rest: Vec<_> = [*arg1, *arg2, *arg3].into_iter().flatten().collect();
                self.math(*fun, *arg, &rest)?
            }
            Expression::Derivative { axis, ctrl, expr } => {
                let axis = match axis {
                    naga::DerivativeAxis::X => "dpdx",
                    naga::DerivativeAxis::Y => "dpdy",
                    naga::DerivativeAxis::Width => "fwidth",
                };
                let control = match ctrl {
                    naga::DerivativeControl::None => "",
                    naga::DerivativeControl::Coarse => "Coarse",
                    naga::DerivativeControl::Fine => "Fine",
                };
                Code::BuiltIn(format!("{axis}{control}").into(), vec![self.code(*expr)?])
            }
            Expression::Relational { fun, argument } => {
                let name = match fun {
                    naga::RelationalFunction::All => "all",
                    naga::RelationalFunction::Any => "any",
                    _ => return Err(NotWritten),
                };
                Code::BuiltIn(name.into(), vec![self.code(*argument)?])
            }
            Expression::As { expr, convert, .. } => {
                let ty = self.inner_text(self.inner(handle))?;
                let name = if convert.is_some() { ty } else { format!("bitcast<{ty}>") };
                Code::BuiltIn(name.into(), vec![self.code(*expr)?])
            }
            Expression::ImageSample { .. }
            | Expression::ImageLoad { .. }
            | Expression::ImageQuery { .. } => self.image(expression)?,
            _ => return Err(NotWritten),
        })
    }

    /// The vector whose parts are put together again, even where a part is known.
    fn whole(
        &mut self,
        ty: &naga::Type,
        components: &[Handle<Expression>],
    ) -> Written<Option<Code>> {
        if !matches!(ty.inner, TypeInner::Vector { .. }) {
            return Ok(None);
        }
        let mut parts = Vec::with_capacity(components.len());
        for &component in components {
            let is_free = !self.bound.contains_key(&component);
            parts.push(match self.function.expressions[component] {
                Expression::AccessIndex { base, index } if is_free => self.access(base, index)?,
                _ => self.code(component)?,
            });
        }
        let name = self.type_text(ty)?;
        Ok(super::code::whole(&name, &parts))
    }

    /// A literal as the file has it, or what naga made of constants.
    fn literal(&self, handle: Handle<Expression>, literal: naga::Literal) -> Written<Code> {
        let span = self.function.expressions.get_span(handle).to_range();
        let text = span.and_then(|span| self.scope.source.get(span)).unwrap_or_default();
        Ok(match literal {
            naga::Literal::F32(x) => {
                let is_number = text.starts_with(|c: char| c.is_ascii_digit())
                    && text.bytes().all(|c| c.is_ascii_digit() || b".eE+-".contains(&c));
                let written = if is_number && text.len() <= LONGEST_LITERAL {
                    let is_float = text.contains(['.', 'e', 'E']);
                    if is_float { text.to_owned() } else { format!("{text}.0") }
                } else {
                    float_literal(x.into())
                };
                // Only if it is the same number.
                let same = written.parse::<f32>().is_ok_and(|read| read.to_bits() == x.to_bits());
                Code::number(&if same { written } else { float_literal(x.into()) })
            }
            naga::Literal::U32(x) => {
                let hex = text.strip_prefix("0x").and_then(|text| text.strip_suffix('u'));
                let is_same = hex.is_some_and(|hex| u32::from_str_radix(hex, 16) == Ok(x));
                Code::number(&if is_same { text.to_owned() } else { format!("{x}u") })
            }
            naga::Literal::I32(x) => Code::number(&x.to_string()),
            naga::Literal::Bool(x) => Code::Text(x.to_string().into(), level::ATOM),
            _ => return Err(NotWritten),
        })
    }

    fn member(&mut self, base: Handle<Expression>, name: &str) -> Written<Code> {
        let TypeInner::Vector { size, .. } = *self.inner(base) else { return Err(NotWritten) };
        let of = self.code(base)?;
        Ok(Code::Member(Box::new(of), name.into(), size as usize).simplified())
    }

    fn access(&mut self, base: Handle<Expression>, index: u32) -> Written<Code> {
        let types = &self.scope.valid.module.types;
        let info = self.info;
        let inner = match info[base].ty.inner_with(types) {
            TypeInner::Pointer { base, .. } => &types[*base].inner,
            TypeInner::ValuePointer { size: Some(size), .. } => {
                let (size, of) = (*size as usize, self.code(base)?);
                let name = ["x", "y", "z", "w"][index as usize];
                return Ok(Code::Member(Box::new(of), name.into(), size));
            }
            other => other,
        };
        Ok(match inner {
            TypeInner::Struct { members, .. } => {
                let name = members[index as usize].name.clone().ok_or(NotWritten)?;
                let of = self.code(base)?;
                match of {
                    Code::Struct(_, mut parts) if parts.len() == members.len() => {
                        parts.swap_remove(index as usize)
                    }
                    of => Code::Member(Box::new(of), name.into(), 0),
                }
            }
            TypeInner::Vector { size, .. } => {
                let size = *size as usize;
                let of = self.code(base)?;
                let name = ["x", "y", "z", "w"][index as usize];
                Code::Member(Box::new(of), name.into(), size).simplified()
            }
            _ => {
                Code::Index(Box::new(self.code(base)?), Box::new(Code::number(&index.to_string())))
            }
        })
    }

    fn binary(
        &mut self,
        op: Op,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Written<Code> {
        let operator = match op {
            Op::Add => "+",
            Op::Subtract => "-",
            Op::Multiply => "*",
            Op::Divide => "/",
            Op::Modulo => "%",
            Op::Equal => "==",
            Op::NotEqual => "!=",
            Op::Less => "<",
            Op::LessEqual => "<=",
            Op::Greater => ">",
            Op::GreaterEqual => ">=",
            Op::And => "&",
            Op::ExclusiveOr => "^",
            Op::InclusiveOr => "|",
            Op::LogicalAnd => "&&",
            Op::LogicalOr => "||",
            Op::ShiftLeft => "<<",
            Op::ShiftRight => ">>",
        };
        let is_one = |x: Floats| x.point() == Some(1.0);
        let is_matrix =
            |handle: Handle<Expression>| matches!(self.inner(handle), TypeInner::Matrix { .. });
        let is_plain = !is_matrix(left) && !is_matrix(right);
        let count = |handle| self.ranges(handle).map_or(0, |ranges| ranges.len());
        let (of_left, of_right) = (count(left), count(right));
        let same_shape = of_left == of_right;
        if is_plain && matches!(op, Op::Multiply | Op::Divide) {
            let (may_leave_left, may_leave_right) =
                (same_shape || of_left == 1, same_shape || of_right == 1);
            if may_leave_right && self.is_all(right, is_one) {
                self.is_changed = true;
                return self.code(left);
            }
            if op == Op::Multiply && may_leave_left && self.is_all(left, is_one) {
                self.is_changed = true;
                return self.code(right);
            }
        }
        if is_plain && same_shape && op == Op::Add {
            // -0 + 0 is 0.
            let is_zero = |x: Floats| x.point() == Some(0.0);
            let has_sign = |x: Floats| !x.minus_zero;
            if self.is_all(right, is_zero) && self.is_all(left, has_sign) {
                self.is_changed = true;
                return self.code(left);
            }
            if self.is_all(left, is_zero) && self.is_all(right, has_sign) {
                self.is_changed = true;
                return self.code(right);
            }
        }
        let is_arithmetic =
            matches!(op, Op::Add | Op::Subtract | Op::Multiply | Op::Divide | Op::Modulo);
        // A scalar beside a vector, for which naga has made a vector of it.
        let scalar = |handle: Handle<Expression>| match self.function.expressions[handle] {
            Expression::Splat { value, .. } if is_arithmetic => Some(value),
            _ => None,
        };
        let (a, b) = match (scalar(left), scalar(right)) {
            (Some(a), None) => (a, right),
            (None, Some(b)) => (left, b),
            _ => (left, right),
        };
        let (a, b) = (self.code(a)?, self.code(b)?);
        let (a, b) = if is_arithmetic { scalars_beside(a, b) } else { (a, b) };
        Ok(Code::Binary(operator, Box::new(a), Box::new(b)).simplified())
    }

    fn select(
        &mut self,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Written<Code> {
        let ranges = self.ranges(condition);
        let truths: Option<Vec<bool>> =
            ranges.and_then(|ranges| ranges.iter().map(|range| range.truth()).collect());
        if let Some(truths) = truths
            && let Some(&first) = truths.first()
            && truths.iter().all(|truth| *truth == first)
        {
            self.is_changed = true;
            return self.code(if first { accept } else { reject });
        }
        let parts = vec![self.code(reject)?, self.code(accept)?, self.code(condition)?];
        if parts[0] == parts[1] {
            self.is_changed = true;
            return Ok(parts[0].clone());
        }
        Ok(Code::BuiltIn("select".into(), parts))
    }

    fn math(
        &mut self,
        fun: naga::MathFunction,
        first: Handle<Expression>,
        rest: &[Handle<Expression>],
    ) -> Written<Code> {
        use naga::MathFunction as Math;
        let ordered =
            |lowest: Option<Handle<Expression>>, x, highest: Option<Handle<Expression>>| {
                let Some(x) = self.floats(x) else { return (false, false) };
                let bounds = |of: Option<Handle<Expression>>| of.and_then(|of| self.floats(of));
                let all = |other: Option<Vec<Floats>>, holds: fn(Floats, Floats) -> bool| {
                    other.is_some_and(|other| {
                        other.len() == x.len() && x.iter().zip(other).all(|(x, o)| holds(*x, o))
                    })
                };
                let is_above = all(bounds(lowest), |x, low| {
                    !x.nan && !low.nan && x.low >= low.high && !x.is_none()
                });
                let is_below = all(bounds(highest), |x, high| {
                    !x.nan && !high.nan && x.high <= high.low && !x.is_none()
                });
                (is_above, is_below)
            };
        let kept = match (fun, rest) {
            (Math::Max, &[other]) => {
                let (is_first, is_second) =
                    (ordered(Some(other), first, None).0, ordered(Some(first), other, None).0);
                if is_first { Some(first) } else { is_second.then_some(other) }
            }
            (Math::Min, &[other]) => {
                let (is_first, is_second) =
                    (ordered(None, first, Some(other)).1, ordered(None, other, Some(first)).1);
                if is_first { Some(first) } else { is_second.then_some(other) }
            }
            (Math::Abs, []) => self.is_all(first, Floats::is_positive).then_some(first),
            (Math::Saturate, []) => {
                self.is_all(first, |x| x.is_within(0.0, 1.0) && x.is_positive()).then_some(first)
            }
            (Math::Clamp, &[low, high]) => match ordered(Some(low), first, Some(high)) {
                (true, true) => Some(first),
                (true, false) if self.floats(first).is_some() => {
                    self.is_changed = true;
                    let parts = vec![self.code(first)?, self.code(high)?];
                    return Ok(Code::BuiltIn("min".into(), parts));
                }
                (false, true) if self.floats(first).is_some() => {
                    self.is_changed = true;
                    let parts = vec![self.code(first)?, self.code(low)?];
                    return Ok(Code::BuiltIn("max".into(), parts));
                }
                _ => None,
            },
            _ => None,
        };
        if let Some(kept) = kept {
            self.is_changed = true;
            return self.code(kept);
        }
        let name = fun.try_to_wgsl().ok_or(NotWritten)?;
        let mut parts = vec![self.code(first)?];
        for &other in rest {
            parts.push(self.code(other)?);
        }
        if fun == Math::Mix
            && let Some(Code::BuiltIn(kind, splat)) = parts.last()
            && splat.len() == 1
            && matches!(&**kind, "vec2f" | "vec3f" | "vec4f")
        {
            let one = splat[0].clone();
            parts.pop();
            parts.push(one);
        }
        Ok(Code::BuiltIn(name.into(), parts))
    }

    fn image(&mut self, expression: &Expression) -> Written<Code> {
        let mut parts = Vec::new();
        let name = match *expression {
            Expression::ImageSample {
                image,
                sampler,
                gather: None,
                coordinate,
                array_index,
                offset: None,
                level,
                depth_ref: None,
                clamp_to_edge: false,
            } => {
                for part in [Some(image), Some(sampler), Some(coordinate), array_index] {
                    if let Some(part) = part {
                        parts.push(self.code(part)?);
                    }
                }
                match level {
                    naga::SampleLevel::Auto => "textureSample",
                    naga::SampleLevel::Exact(level) => {
                        parts.push(self.code(level)?);
                        "textureSampleLevel"
                    }
                    naga::SampleLevel::Zero => {
                        parts.push(Code::number("0.0"));
                        "textureSampleLevel"
                    }
                    naga::SampleLevel::Bias(bias) => {
                        parts.push(self.code(bias)?);
                        "textureSampleBias"
                    }
                    naga::SampleLevel::Gradient { x, y } => {
                        parts.push(self.code(x)?);
                        parts.push(self.code(y)?);
                        "textureSampleGrad"
                    }
                }
            }
            Expression::ImageLoad { image, coordinate, array_index, sample: None, level } => {
                for part in
                    [Some(image), Some(coordinate), array_index, level].into_iter().flatten()
                {
                    parts.push(self.code(part)?);
                }
                "textureLoad"
            }
            Expression::ImageQuery { image, query } => {
                parts.push(self.code(image)?);
                match query {
                    naga::ImageQuery::Size { level } => {
                        if let Some(level) = level {
                            parts.push(self.code(level)?);
                        }
                        "textureDimensions"
                    }
                    naga::ImageQuery::NumLevels => "textureNumLevels",
                    naga::ImageQuery::NumLayers => "textureNumLayers",
                    naga::ImageQuery::NumSamples => "textureNumSamples",
                }
            }
            _ => return Err(NotWritten),
        };
        Ok(Code::BuiltIn(name.into(), parts))
    }

    fn type_text(&self, ty: &naga::Type) -> Written<String> {
        match (&ty.name, &ty.inner) {
            (Some(name), TypeInner::Struct { .. }) => Ok(name.clone()),
            (_, inner) => self.inner_text(inner),
        }
    }

    fn inner_text(&self, inner: &TypeInner) -> Written<String> {
        let scalar = |scalar: &naga::Scalar| match (scalar.kind, scalar.width) {
            (naga::ScalarKind::Float, 4) => Ok("f"),
            (naga::ScalarKind::Sint, 4) => Ok("i"),
            (naga::ScalarKind::Uint, 4) => Ok("u"),
            (naga::ScalarKind::Bool, _) => Ok("<bool>"),
            _ => Err(NotWritten),
        };
        Ok(match inner {
            TypeInner::Scalar(of) => match scalar(of)? {
                "<bool>" => "bool".to_owned(),
                kind => format!("{kind}32"),
            },
            TypeInner::Vector { size, scalar: of } => {
                format!("vec{}{}", *size as usize, scalar(of)?)
            }
            TypeInner::Matrix { columns, rows, scalar: of, .. } => {
                format!("mat{}x{}{}", *columns as usize, *rows as usize, scalar(of)?)
            }
            TypeInner::Array { base, size: naga::ArraySize::Constant(count), .. } => {
                let base = self.type_text(&self.scope.valid.module.types[*base])?;
                format!("array<{base}, {count}>")
            }
            _ => return Err(NotWritten),
        })
    }
}

/// A scalar in place of a vector of it, beside a vector that is none itself.
fn scalars_beside(a: Code, b: Code) -> (Code, Code) {
    let splat = |code: &Code| match code {
        Code::BuiltIn(kind, parts)
            if parts.len() == 1 && matches!(&**kind, "vec2f" | "vec3f" | "vec4f") =>
        {
            match &parts[0] {
                Code::Text(text, _) if text.parse::<f64>().is_ok() => Some(parts[0].clone()),
                _ => None,
            }
        }
        _ => None,
    };
    match (splat(&a), splat(&b)) {
        (Some(a), None) => (a, b),
        (None, Some(b)) => (a, b),
        _ => (a, b),
    }
}

/// `&&` and `||`: as `&` and `|` where the right side costs less than a branch.
fn logic_of(is_or: bool, left: Code, right: Code) -> Code {
    let literal = |code: &Code| match code {
        Code::Text(text, _) => text.parse::<bool>().ok(),
        _ => None,
    };
    match (literal(&left), literal(&right)) {
        (Some(known), _) => {
            return if known == is_or { left } else { right };
        }
        (_, Some(known)) => {
            return if known == is_or { right } else { left };
        }
        _ => {}
    }
    let is_cheap = !right.has_calls() && right.size() <= MOST_SELECTED;
    let operator = match (is_or, is_cheap) {
        (true, true) => "|",
        (true, false) => "||",
        (false, true) => "&",
        (false, false) => "&&",
    };
    Code::Binary(operator, Box::new(left), Box::new(right))
}

fn negated(code: Code) -> Code {
    match code {
        Code::Unary("!", inner) => *inner,
        // Equality alone is the opposite of its opposite for NaN too.
        Code::Binary("==", a, b) => Code::Binary("!=", a, b),
        Code::Binary("!=", a, b) => Code::Binary("==", a, b),
        Code::Text(text, _) if &*text == "true" => Code::Text("false".into(), level::ATOM),
        Code::Text(text, _) if &*text == "false" => Code::Text("true".into(), level::ATOM),
        other => Code::Unary("!", Box::new(other)),
    }
}

/// True if a statement may leave a `switch` around it.
fn breaks(statement: &Statement) -> bool {
    match statement {
        Statement::Break => true,
        Statement::Block(inner) => inner.iter().any(breaks),
        Statement::If { accept, reject, .. } => accept.iter().chain(reject).any(breaks),
        _ => false,
    }
}

/// Declares variables where they are first set, if that is in the function's outermost block.
fn with_declarations_late(lines: Vec<Line>) -> Vec<Line> {
    let count = lines.iter().take_while(|line| matches!(line, Line::Var(..))).count();
    let mut rest = lines;
    let declarations: Vec<Line> = rest.drain(..count).collect();
    for declaration in declarations.into_iter().rev() {
        let Line::Var(index, ty, init) = declaration else { continue };
        let mentions = |line: &Line| {
            let mut found = false;
            super::code::each_code(std::slice::from_ref(line), &mut |code| {
                found |= *code == Code::Local(index);
            });
            found
        };
        let Some(at) = rest.iter().position(mentions) else { continue };
        match (&rest[at], init) {
            (Line::Assign(Code::Local(place), value), None) if *place == index => {
                let mut reads_itself = false;
                value.each(&mut |code| reads_itself |= *code == Code::Local(index));
                if reads_itself {
                    rest.insert(at, Line::Var(index, ty, None));
                } else {
                    rest[at] = Line::Var(index, ty, Some(value.clone()));
                }
            }
            (_, init) => rest.insert(at, Line::Var(index, ty, init)),
        }
    }
    rest
}

/// A function that returns one of two short results, by a selection in place of a branch: nothing
/// is shared across branches, and short results cost less than one.
fn selected(lines: Vec<Line>) -> Vec<Line> {
    match lines.as_slice() {
        [.., Line::If(condition, accept, reject), Line::Return(otherwise)] if reject.is_empty() => {
            let [Line::Return(value)] = accept.as_slice() else { return lines };
            let is_short = |code: &Code| code.size() <= MOST_SELECTED && !code.has_calls();
            // Structs cannot be selected.
            let is_struct = |code: &Code| matches!(code, Code::Struct(..));
            if !is_short(value) || !is_short(otherwise) || is_struct(value) || is_struct(otherwise)
            {
                return lines;
            }
            let select = Code::BuiltIn(
                "select".into(),
                vec![otherwise.clone(), value.clone(), condition.clone()],
            );
            let mut kept = lines[..lines.len() - 2].to_vec();
            kept.push(Line::Return(select));
            selected(kept)
        }
        _ => lines,
    }
}

/// A short function as one expression, where each of its names is read once.
fn collapsed(lines: Vec<Line>) -> Vec<Line> {
    let Some((Line::Return(result), lets)) = lines.split_last() else { return lines };
    let mut result = result.clone();
    for line in lets.iter().rev() {
        let Line::Let(index, value) = line else { return lines };
        let mut reads = 0;
        result.each(&mut |code| reads += usize::from(*code == Code::Local(*index)));
        if reads > 1 {
            return lines;
        }
        result = result.with_local(*index, value);
    }
    if result.size() <= super::MOST_INLINED { vec![Line::Return(result)] } else { lines }
}
