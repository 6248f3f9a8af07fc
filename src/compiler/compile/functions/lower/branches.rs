//! Branches: those that ranges decide are none, and short ones become operators.

use naga::{Block, Expression, Handle, LocalVariable, Statement, SwitchValue, UnaryOperator};

use super::operators::negated;
use super::{FunctionWriter, NotWritten, WriteResult};
use crate::compile::functions::MOST_SELECTED;
use crate::compile::functions::code::{Code, Line};
use crate::compile::functions::print::level;

impl FunctionWriter<'_> {
    pub(super) fn branch(
        &mut self,
        condition: Handle<Expression>,
        accept: &Block,
        reject: &Block,
    ) -> WriteResult<bool> {
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
        if let Some(known) = condition.truth() {
            self.is_changed = true;
            return self.statements(if known { accept } else { reject });
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
    ) -> WriteResult<Code> {
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

    pub(super) fn switch(
        &mut self,
        selector: Handle<Expression>,
        cases: &[naga::SwitchCase],
    ) -> WriteResult<bool> {
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
}

/// `&&` and `||`: as `&` and `|` where the right side costs less than a branch.
fn logic_of(is_or: bool, left: Code, right: Code) -> Code {
    if let Some(known) = left.truth() {
        return if known == is_or { left } else { right };
    }
    if let Some(known) = right.truth() {
        return if known == is_or { right } else { left };
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

/// True if a statement may leave a `switch` around it.
fn breaks(statement: &Statement) -> bool {
    match statement {
        Statement::Break => true,
        Statement::Block(inner) => inner.iter().any(breaks),
        Statement::If { accept, reject, .. } => accept.iter().chain(reject).any(breaks),
        _ => false,
    }
}
