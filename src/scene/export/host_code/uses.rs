//! Uses of a function's expressions and variables.

use std::collections::{HashMap, HashSet};

use naga::{Block, Expression, Function, Handle, LocalVariable, Statement};

/// Uses within a function.
#[derive(Debug, Default)]
pub(super) struct Uses {
    /// Number of uses of each expression by other expressions and by statements.
    pub(super) counts: HashMap<Handle<Expression>, usize>,
    /// Variables that are set in part: a member, an element.
    pub(super) built: HashSet<Handle<LocalVariable>>,
    /// Number of statements that set a variable.
    pub(super) stores: HashMap<Handle<LocalVariable>, usize>,
}

impl Uses {
    pub(super) fn of(function: &Function) -> Self {
        let mut uses = Self::default();
        for (_, expression) in function.expressions.iter() {
            each_operand(expression, |operand| *uses.counts.entry(operand).or_default() += 1);
        }
        uses.block(function, &function.body);
        uses
    }

    fn block(&mut self, function: &Function, block: &Block) {
        for statement in block {
            each_root(statement, |root| *self.counts.entry(root).or_default() += 1);
            if let Statement::Store { pointer, .. } = statement
                && let Some(variable) = variable_of(function, *pointer)
            {
                *self.stores.entry(variable).or_default() += 1;
                if !matches!(function.expressions[*pointer], Expression::LocalVariable(_)) {
                    self.built.insert(variable);
                }
            }
            each_block(statement, |inner| self.block(function, inner));
        }
    }

    pub(super) fn count(&self, expression: Handle<Expression>) -> usize {
        self.counts.get(&expression).copied().unwrap_or(0)
    }
}

/// The variable that a pointer leads into.
pub(super) fn variable_of(
    function: &Function,
    mut pointer: Handle<Expression>,
) -> Option<Handle<LocalVariable>> {
    loop {
        match function.expressions[pointer] {
            Expression::LocalVariable(variable) => return Some(variable),
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => {
                pointer = base;
            }
            _ => return None,
        }
    }
}

/// Calls `with` for each operand of an expression.
pub(super) fn each_operand(expression: &Expression, mut with: impl FnMut(Handle<Expression>)) {
    match expression {
        Expression::Compose { components, .. } => components.iter().for_each(|&it| with(it)),
        Expression::Access { base, index } => {
            with(*base);
            with(*index);
        }
        Expression::AccessIndex { base, .. } => with(*base),
        Expression::Splat { value, .. } => with(*value),
        Expression::Swizzle { vector, .. } => with(*vector),
        Expression::Load { pointer } => with(*pointer),
        Expression::Unary { expr, .. }
        | Expression::As { expr, .. }
        | Expression::Derivative { expr, .. } => with(*expr),
        Expression::Binary { left, right, .. } => {
            with(*left);
            with(*right);
        }
        Expression::Select { condition, accept, reject } => {
            with(*condition);
            with(*accept);
            with(*reject);
        }
        Expression::Relational { argument, .. } => with(*argument),
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            with(*arg);
            [arg1, arg2, arg3].into_iter().flatten().for_each(|&it| with(it));
        }
        _ => {}
    }
}

/// Calls `with` for each expression that a statement itself reads.
pub(super) fn each_root(statement: &Statement, mut with: impl FnMut(Handle<Expression>)) {
    match statement {
        Statement::If { condition, .. } => with(*condition),
        Statement::Switch { selector, .. } => with(*selector),
        Statement::Loop { break_if: Some(condition), .. } => with(*condition),
        Statement::Return { value: Some(value) } => with(*value),
        Statement::Store { pointer, value } => {
            with(*pointer);
            with(*value);
        }
        Statement::Call { arguments, .. } => arguments.iter().for_each(|&it| with(it)),
        _ => {}
    }
}

/// Calls `with` for each block within a statement.
pub(super) fn each_block<'a>(statement: &'a Statement, mut with: impl FnMut(&'a Block)) {
    match statement {
        Statement::Block(block) => with(block),
        Statement::If { accept, reject, .. } => {
            with(accept);
            with(reject);
        }
        Statement::Switch { cases, .. } => cases.iter().for_each(|case| with(&case.body)),
        Statement::Loop { body, continuing, .. } => {
            with(body);
            with(continuing);
        }
        _ => {}
    }
}
