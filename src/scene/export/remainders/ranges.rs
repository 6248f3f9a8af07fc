//! Ranges of whole numbers, as far as a function itself tells them.

use std::collections::HashMap;

use naga::{BinaryOperator, Block, Expression, Function, Handle, Literal, LocalVariable, Module};
use naga::{Constant, Statement};

/// Least and greatest number.
type Range = [i64; 2];

/// Knowledge of the whole numbers of a function.
pub(super) struct Ranges<'a> {
    module: &'a Module,
    function: &'a Function,
    /// Least numbers of variables that only count up.
    counts: HashMap<Handle<LocalVariable>, i64>,
}

impl<'a> Ranges<'a> {
    pub(super) fn of(module: &'a Module, function: &'a Function) -> Self {
        let mut ranges = Self { module, function, counts: HashMap::new() };
        let mut written = HashMap::new();
        ranges.walk(&function.body, &mut written);
        for (variable, local) in function.local_variables.iter() {
            let mut values = written.remove(&variable).unwrap_or_default();
            values.push(local.init.map_or(Some(0), |init| ranges.start(variable, init)));
            let least = values.into_iter().reduce(|a, b| Some(a?.min(b?)));
            if let Some(least) = least.flatten() {
                ranges.counts.insert(variable, least);
            }
        }
        ranges
    }

    /// True if no component of a value can be below 0.
    pub(super) fn is_never_negative(&self, value: Handle<Expression>) -> bool {
        self.range(value).is_some_and(|[low, _]| low >= 0)
    }

    /// Gathers what is written into variables: the least number that a count starts from, `None`
    /// for everything else.
    fn walk(&self, block: &Block, written: &mut HashMap<Handle<LocalVariable>, Vec<Option<i64>>>) {
        for statement in block {
            match statement {
                Statement::Store { pointer, value } => {
                    if let Expression::LocalVariable(variable) = self.function.expressions[*pointer]
                    {
                        written.entry(variable).or_default().push(self.start(variable, *value));
                    }
                }
                Statement::Call { arguments, .. } => {
                    for argument in arguments {
                        if let Expression::LocalVariable(it) = self.function.expressions[*argument]
                        {
                            written.entry(it).or_default().push(None);
                        }
                    }
                }
                Statement::Block(block) => self.walk(block, written),
                Statement::If { accept, reject, .. } => {
                    self.walk(accept, written);
                    self.walk(reject, written);
                }
                Statement::Switch { cases, .. } => {
                    cases.iter().for_each(|case| self.walk(&case.body, written));
                }
                Statement::Loop { body, continuing, .. } => {
                    self.walk(body, written);
                    self.walk(continuing, written);
                }
                _ => {}
            }
        }
    }

    /// The number that a variable starts from, or the greatest of all where a step counts it up.
    fn start(&self, variable: Handle<LocalVariable>, value: Handle<Expression>) -> Option<i64> {
        if let Expression::Binary { op: BinaryOperator::Add, left, right } =
            self.function.expressions[value]
            && let Expression::Load { pointer } = self.function.expressions[left]
            && matches!(self.function.expressions[pointer], Expression::LocalVariable(it)
                if it == variable)
        {
            return self.is_never_negative(right).then_some(i64::MAX);
        }
        self.range(value).map(|[low, _]| low)
    }

    /// The range of all components of a value; `None` where it is not known.
    fn range(&self, value: Handle<Expression>) -> Option<Range> {
        let range = match &self.function.expressions[value] {
            Expression::Literal(literal) => number(*literal),
            Expression::Constant(constant) => self.constant(*constant),
            Expression::ZeroValue(_) => Some([0, 0]),
            Expression::Splat { value, .. } => self.range(*value),
            Expression::Swizzle { vector, .. } => self.range(*vector),
            Expression::AccessIndex { base, .. } => self.range(*base),
            Expression::Compose { components, .. } => {
                let ranges = components.iter().map(|component| self.range(*component));
                ranges.reduce(|a, b| Some(union(a?, b?))).flatten()
            }
            Expression::Select { accept, reject, .. } => {
                Some(union(self.range(*accept)?, self.range(*reject)?))
            }
            Expression::Load { pointer } => match self.function.expressions[*pointer] {
                Expression::LocalVariable(variable) => {
                    self.counts.get(&variable).map(|low| [*low, i64::from(i32::MAX)])
                }
                _ => None,
            },
            Expression::Binary { op, left, right } => {
                binary(*op, self.range(*left), self.range(*right)?)
            }
            _ => None,
        };
        // Sums beyond what 32 bits hold begin again below.
        range.filter(|[low, high]| i32::try_from(*low).is_ok() && i32::try_from(*high).is_ok())
    }

    fn constant(&self, constant: Handle<Constant>) -> Option<Range> {
        match self.module.global_expressions[self.module.constants[constant].init] {
            Expression::Literal(literal) => number(literal),
            _ => None,
        }
    }
}

fn number(literal: Literal) -> Option<Range> {
    match literal {
        Literal::I32(number) => Some([i64::from(number); 2]),
        _ => None,
    }
}

fn union([a, b]: Range, [c, d]: Range) -> Range {
    [a.min(c), b.max(d)]
}

/// The range of what an operator gives. A remainder is bounded whatever is divided.
fn binary(op: BinaryOperator, left: Option<Range>, [low, high]: Range) -> Option<Range> {
    if op == BinaryOperator::Modulo {
        let most = low.abs().max(high.abs()) - 1;
        let least = if left.is_some_and(|[low, _]| low >= 0) { 0 } else { -most };
        return (low > 0).then_some([least, most]);
    }
    let [a, b] = left?;
    let corners = |of: fn(i64, i64) -> i64| {
        let all = [of(a, low), of(a, high), of(b, low), of(b, high)];
        [all.iter().copied().min().unwrap_or(a), all.iter().copied().max().unwrap_or(b)]
    };
    match op {
        BinaryOperator::Add => Some([a + low, b + high]),
        BinaryOperator::Subtract => Some([a - high, b - low]),
        BinaryOperator::Multiply => Some(corners(|x, y| x * y)),
        BinaryOperator::Divide if low > 0 => Some(corners(|x, y| x / y)),
        _ => None,
    }
}
