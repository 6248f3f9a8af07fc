//! Functions and statements.

use std::collections::{HashMap, HashSet};

use chiaro_locale::tr;
use naga::valid::FunctionInfo;
use naga::{Block, Expression, Function, Handle, LocalVariable, Module, Statement, SwitchValue};

use super::dialect::{Dialect, Head, NameOf, Term, ValueType};
use super::module::ModuleWriter;
use super::names::Names;
use super::types;
use super::uses::{Uses, each_block, each_operand, each_root, variable_of};

/// Reason why a language cannot express something, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Refusal(pub(super) String);

/// Writer of one function.
pub(super) struct FunctionWriter<'a> {
    pub(super) module: &'a Module,
    pub(super) info: &'a FunctionInfo,
    pub(super) function: &'a Function,
    pub(super) dialect: &'a dyn Dialect,
    pub(super) shared: &'a ModuleWriter<'a>,
    pub(super) uses: Uses,
    /// Names and types of the parameters.
    pub(super) parameters: Vec<(String, ValueType)>,
    pub(super) variables: HashMap<Handle<LocalVariable>, String>,
    /// Expressions that have a name, or whose text stands for them.
    pub(super) terms: HashMap<Handle<Expression>, Term>,
    /// True while the text of a returned value is made: nothing changes it afterwards.
    pub(super) is_returned: bool,
    names: Names,
    /// Expressions that were emitted and have no name.
    pending: Vec<Handle<Expression>>,
    declared: HashSet<Handle<LocalVariable>>,
    /// Blocks that are run before the next turn of the loops around.
    continuing: Vec<&'a Block>,
    lines: Vec<String>,
    indent: usize,
}

impl<'a> FunctionWriter<'a> {
    pub(super) fn new(
        shared: &'a ModuleWriter<'a>,
        function: &'a Function,
        info: &'a FunctionInfo,
    ) -> Result<Self, Refusal> {
        let mut names = shared.names.clone();
        let (module, dialect) = (shared.module, shared.dialect);
        let named = |what: &str| Refusal(what.to_owned());
        let mut parameters = Vec::new();
        for argument in &function.arguments {
            if let naga::TypeInner::Pointer { .. } = module.types[argument.ty].inner {
                return Err(named(tr!("a pointer among its parameters")));
            }
            let ty =
                types::of(module, argument.ty).ok_or_else(|| named(tr!("a parameter's type")))?;
            let name = dialect.styled(argument.name.as_deref().unwrap_or("x"), NameOf::Value);
            parameters.push((names.give(&name), ty));
        }
        let mut variables = HashMap::new();
        for (handle, variable) in function.local_variables.iter() {
            let name = dialect.styled(variable.name.as_deref().unwrap_or("value"), NameOf::Value);
            variables.insert(handle, names.give(&name));
        }
        Ok(Self {
            module,
            info,
            function,
            dialect,
            shared,
            uses: Uses::of(function),
            parameters,
            variables,
            terms: HashMap::new(),
            is_returned: false,
            names,
            pending: Vec::new(),
            declared: HashSet::new(),
            continuing: Vec::new(),
            lines: Vec::new(),
            indent: 0,
        })
    }

    /// The function's text, under that name.
    pub(super) fn write(mut self, name: &str, doc: &[String]) -> Result<String, Refusal> {
        let result = self.function.result.as_ref().and_then(|it| types::of(self.module, it.ty));
        let result = result.ok_or_else(|| self.refusal(tr!("a function without a result")))?;
        let parameters = self.parameters.clone();
        let head = Head::Function { name, parameters: &parameters, result: &result };
        let mut text: String =
            self.dialect.doc(doc).iter().map(|line| format!("{line}\n")).collect();
        let opening = self.dialect.open(&head);
        self.line(&opening);
        let function = self.function;
        self.inside(|writer| writer.block(&function.body))?;
        self.close();
        for line in self.lines {
            text += &line;
            text.push('\n');
        }
        Ok(text)
    }

    pub(super) fn refusal(&self, what: &str) -> Refusal {
        Refusal(what.to_owned())
    }

    /// The variable that a pointer leads into.
    pub(super) fn variable(&self, pointer: Handle<Expression>) -> Option<Handle<LocalVariable>> {
        variable_of(self.function, pointer)
    }

    /// Declares a value under a name like `wanted`.
    pub(super) fn declare_value(&mut self, wanted: &str, ty: &ValueType, value: &Term) -> Term {
        let name = self.names.give(&self.dialect.styled(wanted, NameOf::Value));
        let line = self.dialect.declare(&name, ty, value, false);
        self.line(&line);
        Term::primary(name)
    }

    fn line(&mut self, text: &str) {
        let indent = self.dialect.indent().repeat(self.indent);
        self.lines.extend(text.lines().map(|line| format!("{indent}{line}")));
    }

    fn inside(
        &mut self,
        body: impl FnOnce(&mut Self) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let before = self.lines.len();
        self.indent += 1;
        body(self)?;
        if self.lines.len() == before
            && let Some(nothing) = self.dialect.nothing()
        {
            self.line(nothing);
        }
        self.indent -= 1;
        Ok(())
    }

    fn close(&mut self) {
        if let Some(closing) = self.dialect.close() {
            self.line(closing);
        }
    }

    fn block(&mut self, block: &'a Block) -> Result<(), Refusal> {
        let pending = std::mem::take(&mut self.pending);
        let statements: Vec<&Statement> = block.iter().collect();
        for (index, statement) in statements.iter().enumerate() {
            self.declare_variables_before(&statements, index)?;
            self.statement(statement)?;
        }
        self.pending = pending;
        Ok(())
    }

    /// Declares the variables whose first use is in that statement, and which it does not itself
    /// declare by setting them.
    fn declare_variables_before(
        &mut self,
        statements: &[&'a Statement],
        index: usize,
    ) -> Result<(), Refusal> {
        let function = self.function;
        for (variable, local) in function.local_variables.iter() {
            if self.declared.contains(&variable) || !self.mentions(statements[index], variable) {
                continue;
            }
            let others = &statements[index + 1..];
            let is_within = !others.iter().any(|other| self.mentions(other, variable));
            if (is_within && self.is_set_within(statements[index], variable))
                || self.is_set_by(statements[index], variable)
            {
                continue;
            }
            let ty = types::of(self.module, local.ty).ok_or_else(|| self.refusal(tr!("a type")))?;
            self.declared.insert(variable);
            let name = &self.variables[&variable];
            if local.init.is_none()
                && let Some(line) = self.dialect.declare_empty(name, &ty)
            {
                self.line(&line);
                continue;
            }
            let value = match local.init {
                Some(init) => self.term(init)?,
                None => self.zero(&ty)?,
            };
            let line = self.dialect.declare(&self.variables[&variable], &ty, &value, true);
            self.line(&line);
        }
        Ok(())
    }

    /// True if a statement sets a whole variable, and reads nothing of it.
    fn is_set_by(&self, statement: &Statement, variable: Handle<LocalVariable>) -> bool {
        let Statement::Store { pointer, value } = statement else { return false };
        self.function.expressions[*pointer] == Expression::LocalVariable(variable)
            && !self.reads(*value, variable)
    }

    /// True if the only block within a statement that has to do with a variable begins by setting
    /// it: the variable can be declared there.
    fn is_set_within(&self, statement: &Statement, variable: Handle<LocalVariable>) -> bool {
        let mut mentioned = false;
        each_root(statement, |root| mentioned |= self.reads(root, variable));
        let mut blocks = Vec::new();
        each_block(statement, |block| {
            if block.iter().any(|inner| self.mentions(inner, variable)) {
                blocks.push(block);
            }
        });
        let [block] = blocks[..] else { return false };
        let mut inner = block.iter().filter(|inner| self.mentions(inner, variable));
        let Some(first) = inner.next() else { return false };
        let is_last = inner.next().is_none();
        !mentioned
            && self.function.local_variables[variable].init.is_none()
            && (self.is_set_by(first, variable) || (is_last && self.is_set_within(first, variable)))
    }

    fn mentions(&self, statement: &Statement, variable: Handle<LocalVariable>) -> bool {
        let mut found = false;
        if let Statement::Emit(range) = statement {
            found = range.clone().any(|handle| self.reads(handle, variable));
        }
        each_root(statement, |root| found |= self.reads(root, variable));
        each_block(statement, |block| {
            found = found || block.iter().any(|inner| self.mentions(inner, variable));
        });
        found
    }

    /// True if an expression has to do with a variable, itself or by operands without a name.
    fn reads(&self, handle: Handle<Expression>, variable: Handle<LocalVariable>) -> bool {
        let mut open = vec![handle];
        let mut seen = HashSet::new();
        while let Some(handle) = open.pop() {
            if !seen.insert(handle) || self.terms.contains_key(&handle) {
                continue;
            }
            if self.function.expressions[handle] == Expression::LocalVariable(variable) {
                return true;
            }
            each_operand(&self.function.expressions[handle], |operand| open.push(operand));
        }
        false
    }

    fn statement(&mut self, statement: &'a Statement) -> Result<(), Refusal> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    self.emit(handle)?;
                }
                Ok(())
            }
            Statement::Block(block) => self.block(block),
            Statement::If { condition, accept, reject } => {
                self.settle(statement)?;
                self.branch(*condition, accept, reject, false)
            }
            Statement::Switch { selector, cases } => {
                self.settle(statement)?;
                self.switch(*selector, cases)
            }
            Statement::Loop { body, continuing, break_if } => {
                self.settle(statement)?;
                self.repeat(body, continuing, *break_if)
            }
            Statement::Break => {
                let line = format!("break{}", self.dialect.end());
                self.line(&line);
                Ok(())
            }
            Statement::Continue => {
                if let Some(continuing) = self.continuing.last().copied() {
                    self.block(continuing)?;
                }
                let line = format!("continue{}", self.dialect.end());
                self.line(&line);
                Ok(())
            }
            Statement::Return { value: Some(value) } => {
                self.is_returned =
                    matches!(self.function.expressions[*value], Expression::Load { .. });
                let term = self.term(*value)?;
                self.is_returned = false;
                let line = format!("return {}{}", term.text, self.dialect.end());
                self.line(&line);
                Ok(())
            }
            Statement::Store { pointer, value } => {
                self.settle(statement)?;
                self.store(*pointer, *value)
            }
            Statement::Call { function, arguments, result } => {
                self.use_up(statement);
                self.call(*function, arguments, *result)
            }
            Statement::Return { value: None } => {
                Err(self.refusal(tr!("a function without a result")))
            }
            _ => Err(self.refusal(tr!("what only a GPU does"))),
        }
    }

    /// Takes note of an expression: names it, or lets its text stand where it is used.
    fn emit(&mut self, handle: Handle<Expression>) -> Result<(), Refusal> {
        let Some(wanted) = self.wanted_name(handle) else {
            self.pending.push(handle);
            return Ok(());
        };
        let ty = self.type_of(handle)?;
        let term = self.text(handle)?;
        let named = self.declare_value(&wanted, &ty, &term);
        self.terms.insert(handle, named);
        Ok(())
    }

    /// The name that an expression is to have, if it is to have one.
    fn wanted_name(&self, handle: Handle<Expression>) -> Option<String> {
        if let Some(name) = self.function.named_expressions.get(&handle) {
            return Some(name.clone());
        }
        let is_again = self.uses.count(handle) > 1 && !self.is_place(handle);
        (is_again && !self.is_trivial(handle)).then(|| "value".to_owned())
    }

    /// True for an expression that points to a variable or into it.
    pub(super) fn is_place(&self, handle: Handle<Expression>) -> bool {
        let inner = self.info[handle].ty.inner_with(&self.module.types);
        matches!(inner, naga::TypeInner::Pointer { .. } | naga::TypeInner::ValuePointer { .. })
    }

    /// True for an expression that costs nothing to write again.
    fn is_trivial(&self, handle: Handle<Expression>) -> bool {
        match self.function.expressions[handle] {
            Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::FunctionArgument(_)
            | Expression::LocalVariable(_) => true,
            Expression::AccessIndex { base, .. } => {
                self.terms.contains_key(&base) || self.is_trivial(base)
            }
            _ => false,
        }
    }

    /// Names those pending expressions that read a variable which the statement may change, and
    /// that the statement does not use up.
    fn settle(&mut self, statement: &Statement) -> Result<(), Refusal> {
        self.use_up(statement);
        let reads = |handle: &Handle<Expression>| {
            matches!(
                self.function.expressions[*handle],
                Expression::Load { .. } | Expression::CallResult(_)
            )
        };
        let (open, pending) = std::mem::take(&mut self.pending).into_iter().partition(reads);
        self.pending = pending;
        let open: Vec<Handle<Expression>> = open;
        for handle in open {
            let ty = self.type_of(handle)?;
            let term = self.term(handle)?;
            let named = self.declare_value("value", &ty, &term);
            self.terms.insert(handle, named);
        }
        Ok(())
    }

    /// Forgets those pending expressions that a statement uses.
    fn use_up(&mut self, statement: &Statement) {
        let mut used = HashSet::new();
        let mut open = Vec::new();
        each_root(statement, |root| open.push(root));
        while let Some(handle) = open.pop() {
            if used.insert(handle) {
                each_operand(&self.function.expressions[handle], |operand| open.push(operand));
            }
        }
        self.pending.retain(|handle| !used.contains(handle));
    }

    fn store(
        &mut self,
        pointer: Handle<Expression>,
        value: Handle<Expression>,
    ) -> Result<(), Refusal> {
        let ty = self.type_of(pointer)?;
        let variable = self.variable(pointer).ok_or_else(|| self.refusal(tr!("a pointer")))?;
        let mut term = self.term(value)?;
        let is_made = matches!(
            self.function.expressions[value],
            Expression::Compose { .. }
                | Expression::ZeroValue(_)
                | Expression::CallResult(_)
                | Expression::Splat { .. }
        );
        if self.uses.built.contains(&variable)
            && ty.is_composite()
            && (!is_made || self.terms.contains_key(&value))
            && !matches!(self.function.expressions[value], Expression::Load { .. })
        {
            term = self.dialect.copy(&term, &ty);
        }
        let is_whole = self.function.expressions[pointer] == Expression::LocalVariable(variable);
        let line = if is_whole && self.declared.insert(variable) {
            let name = &self.variables[&variable];
            let is_variable =
                self.uses.built.contains(&variable) || self.uses.stores.get(&variable) != Some(&1);
            self.dialect.declare(name, &ty, &term, is_variable)
        } else {
            let place = self.term(pointer)?;
            self.dialect.assign(&place, &term)
        };
        self.line(&line);
        Ok(())
    }

    fn call(
        &mut self,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
    ) -> Result<(), Refusal> {
        let reads_variables = arguments.iter().any(|&argument| {
            self.function.local_variables.iter().any(|(it, _)| self.reads(argument, it))
        });
        let terms = arguments.iter().map(|&it| self.term(it)).collect::<Result<Vec<_>, _>>()?;
        let term = Term::call(&self.shared.function(function), &terms);
        let Some(result) = result else { return Err(self.refusal(tr!("a call without a result"))) };
        let term = match self.wanted_name(result) {
            Some(wanted) => {
                let ty = self.type_of(result)?;
                self.declare_value(&wanted, &ty, &term)
            }
            None => {
                if reads_variables {
                    self.pending.push(result);
                }
                term
            }
        };
        self.terms.insert(result, term);
        Ok(())
    }

    fn branch(
        &mut self,
        condition: Handle<Expression>,
        accept: &'a Block,
        reject: &'a Block,
        is_else: bool,
    ) -> Result<(), Refusal> {
        let condition = self.term(condition)?;
        let (condition, accept, reject) = if accept.is_empty() && !reject.is_empty() {
            let mut helpers = self.shared.helpers.borrow_mut();
            let not =
                self.dialect.scalar("!", super::dialect::Kind::Bool, &[condition], &mut helpers);
            drop(helpers);
            (not.ok_or_else(|| self.refusal("`!`"))?, reject, accept)
        } else {
            (condition, accept, reject)
        };
        let head = if is_else { Head::ElseIf(&condition) } else { Head::If(&condition) };
        let opening = self.dialect.open(&head);
        self.line(&opening);
        self.inside(|writer| writer.block(accept))?;
        if let Some((condition, accept, reject)) = self.else_if(reject) {
            let before = self.lines.len();
            self.term(condition)?;
            if self.lines.len() == before {
                return self.branch(condition, accept, reject, true);
            }
            // A part of the condition got a name, which is declared in a block of its own.
            self.lines.truncate(before);
        }
        if !reject.is_empty() {
            let opening = self.dialect.open(&Head::Else);
            self.line(&opening);
            self.inside(|writer| writer.block(reject))?;
        }
        self.close();
        Ok(())
    }

    /// The branch that is all there is in a block.
    fn else_if(&self, block: &'a Block) -> Option<(Handle<Expression>, &'a Block, &'a Block)> {
        let (last, first) = block.split_last()?;
        let Statement::If { condition, accept, reject } = last else { return None };
        let is_silent = |statement: &Statement| match statement {
            Statement::Emit(range) => {
                range.clone().all(|handle| self.wanted_name(handle).is_none())
            }
            _ => false,
        };
        let is_plain = !accept.is_empty() || reject.is_empty();
        (is_plain && first.iter().all(is_silent)).then_some((*condition, accept, reject))
    }

    fn switch(
        &mut self,
        selector: Handle<Expression>,
        cases: &'a [naga::SwitchCase],
    ) -> Result<(), Refusal> {
        let ty = self.type_of(selector)?;
        let ValueType::Scalar(kind) = ty else { return Err(self.refusal(tr!("a switch"))) };
        let term = self.term(selector)?;
        let term = self.declare_value("selected", &ty, &term);
        let mut values: Vec<i64> = Vec::new();
        let mut is_first = true;
        // Cases that share a body come as empty ones that fall through.
        for case in cases {
            let is_default = match case.value {
                SwitchValue::I32(value) => {
                    values.push(i64::from(value));
                    false
                }
                SwitchValue::U32(value) => {
                    values.push(i64::from(value));
                    false
                }
                SwitchValue::Default => true,
            };
            if case.fall_through {
                if !case.body.is_empty() {
                    return Err(self.refusal(tr!("a switch whose cases fall through")));
                }
                continue;
            }
            let body = without_break(&case.body);
            if body.iter().any(leaves) {
                return Err(self.refusal(tr!("a switch that is left in the middle of a case")));
            }
            let mut condition: Option<Term> = None;
            for value in values.drain(..) {
                let value = self.dialect.integer(value, kind);
                let mut helpers = self.shared.helpers.borrow_mut();
                let mut scalar = |operation: &str, operands: &[Term]| {
                    self.dialect.scalar(operation, kind, operands, &mut helpers)
                };
                let equal = scalar("==", &[term.clone(), value]);
                condition = match (condition, equal) {
                    (Some(before), Some(equal)) => scalar("||", &[before, equal]),
                    (None, equal) => equal,
                    (before, None) => before,
                };
            }
            let opening = match (&condition, is_first, is_default) {
                (_, true, true) => None,
                (_, false, true) | (None, ..) => Some(self.dialect.open(&Head::Else)),
                (Some(condition), true, false) => Some(self.dialect.open(&Head::If(condition))),
                (Some(condition), false, false) => {
                    Some(self.dialect.open(&Head::ElseIf(condition)))
                }
            };
            let Some(opening) = opening else {
                return self.statements(body);
            };
            is_first = false;
            self.line(&opening);
            self.inside(|writer| writer.statements(body))?;
        }
        if !is_first {
            self.close();
        }
        Ok(())
    }

    fn statements(&mut self, statements: &'a [Statement]) -> Result<(), Refusal> {
        let pending = std::mem::take(&mut self.pending);
        let list: Vec<&Statement> = statements.iter().collect();
        for (index, statement) in list.iter().enumerate() {
            self.declare_variables_before(&list, index)?;
            self.statement(statement)?;
        }
        self.pending = pending;
        Ok(())
    }

    fn repeat(
        &mut self,
        body: &'a Block,
        continuing: &'a Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<(), Refusal> {
        let (condition, mut rest) = self.condition(body);
        // What a condition reads has to be declared before the loop.
        let opening = match condition {
            Some(condition) => {
                let before = self.lines.len();
                let condition = self.term(condition)?;
                if self.lines.len() == before {
                    self.dialect.open(&Head::While(&condition))
                } else {
                    // A part of the condition got a name, and changes from turn to turn.
                    self.lines.truncate(before);
                    rest = body;
                    self.dialect.open(&Head::Forever)
                }
            }
            None => self.dialect.open(&Head::Forever),
        };
        self.line(&opening);
        self.continuing.push(continuing);
        self.inside(|writer| {
            writer.statements(rest)?;
            let is_left = rest.last().is_some_and(|last| {
                matches!(last, Statement::Continue | Statement::Break | Statement::Return { .. })
            });
            if !is_left {
                writer.block(continuing)?;
                if let Some(condition) = break_if {
                    let condition = writer.term(condition)?;
                    let opening = writer.dialect.open(&Head::If(&condition));
                    writer.line(&opening);
                    let line = format!("break{}", writer.dialect.end());
                    writer.inside(|writer| {
                        writer.line(&line);
                        Ok(())
                    })?;
                    writer.close();
                }
            }
            Ok(())
        })?;
        self.continuing.pop();
        self.close();
        Ok(())
    }

    /// The condition of a loop that begins by asking for one, and what comes after.
    fn condition(&self, body: &'a Block) -> (Option<Handle<Expression>>, &'a [Statement]) {
        let statements: &'a [Statement] = body;
        let at = statements.iter().position(|statement| !matches!(statement, Statement::Emit(_)));
        let Some(at) = at else { return (None, statements) };
        let is_silent = statements[..at].iter().all(|statement| match statement {
            Statement::Emit(range) => {
                range.clone().all(|handle| self.wanted_name(handle).is_none())
            }
            _ => false,
        });
        match &statements[at] {
            Statement::If { condition, accept, reject }
                if is_silent
                    && accept.is_empty()
                    && matches!(reject.first(), Some(Statement::Break)) =>
            {
                (Some(*condition), &statements[at + 1..])
            }
            _ => (None, statements),
        }
    }
}

/// A case's body without the `break` at its end.
fn without_break(body: &Block) -> &[Statement] {
    match body.split_last() {
        Some((Statement::Break, before)) => before,
        _ => body,
    }
}

/// True if a statement may leave the switch around it.
fn leaves(statement: &Statement) -> bool {
    match statement {
        Statement::Break => true,
        Statement::Loop { .. } => false,
        _ => {
            let mut found = false;
            each_block(statement, |block| found = found || block.iter().any(leaves));
            found
        }
    }
}
