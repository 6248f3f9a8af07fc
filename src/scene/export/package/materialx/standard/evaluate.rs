//! Expressions of WGSL as symbols.

use naga::{
    BinaryOperator as Op, Expression, Handle, Literal, MathFunction as Math, RelationalFunction,
    ScalarKind, Type, TypeInner, UnaryOperator,
};

use super::follow::{Follower, Frame, Unfit};
use super::operations::node_of;
use super::symbols::Symbol;
use super::terms::{TermId, Terms, Truth};

/// The reason for values that are worked with bit by bit.
const BITS: &str = "works with bits of numbers, for which MaterialX has no nodes";

fn unfit<T>(reason: &str) -> Result<T, Unfit> {
    Err(Unfit(reason.to_owned()))
}

impl<'m> Follower<'m> {
    /// Calculates an expression, whose operands are known.
    pub(super) fn expression(
        &mut self,
        frame: &mut Frame<'m>,
        handle: Handle<Expression>,
    ) -> Result<Symbol, Unfit> {
        let arena = frame.arena;
        match &arena[handle] {
            Expression::Literal(literal) => self.literal(*literal),
            Expression::Constant(constant) => self.constant(self.module.constants[*constant].init),
            Expression::ZeroValue(ty) => Ok(Symbol::zero(self.module, *ty, &mut self.terms)),
            Expression::FunctionArgument(place) => {
                let argument = frame.arguments.get(*place as usize);
                argument.cloned().ok_or_else(|| Unfit("lacks an argument".to_owned()))
            }
            Expression::GlobalVariable(variable) => {
                Ok(Symbol::Pointer(variable.index(), Vec::new()))
            }
            Expression::LocalVariable(variable) => {
                Ok(Symbol::Pointer(frame.locals + variable.index(), Vec::new()))
            }
            Expression::CallResult(_) => unfit("uses a result that is not there"),
            Expression::Load { pointer } => {
                let pointer = self.value(frame, *pointer)?;
                self.load(&pointer)
            }
            Expression::AccessIndex { base, index } => {
                let base = self.value(frame, *base)?;
                self.part(&base, *index as usize)
            }
            Expression::Access { base, index } => {
                let (base, index) = (self.value(frame, *base)?, self.value(frame, *index)?);
                self.access(&base, &index)
            }
            Expression::Compose { ty, components } => {
                let parts: Result<Vec<Symbol>, Unfit> =
                    components.iter().map(|it| self.value(frame, *it)).collect();
                self.composed(*ty, parts?)
            }
            Expression::Splat { size, value } => {
                let width = *size as usize;
                Ok(match self.value(frame, *value)? {
                    Symbol::Number(id) => Symbol::Number(self.terms.splat(id, width)),
                    other => Symbol::List(vec![other; width]),
                })
            }
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(frame, *vector)?;
                let places = &pattern[..*size as usize];
                let parts: Result<Vec<Symbol>, Unfit> =
                    places.iter().map(|place| self.part(&vector, *place as usize)).collect();
                Ok(Symbol::vector(parts?, &mut self.terms))
            }
            Expression::Unary { op, expr } => {
                let value = self.value(frame, *expr)?;
                self.unary(*op, &value)
            }
            Expression::Binary { op, left, right } => {
                let (left, right) = (self.value(frame, *left)?, self.value(frame, *right)?);
                self.binary(*op, &left, &right)
            }
            Expression::Select { condition, accept, reject } => {
                let condition = self.value(frame, *condition)?;
                let (on, off) = (self.value(frame, *accept)?, self.value(frame, *reject)?);
                self.select(&condition, &on, &off)
            }
            Expression::Relational { fun, argument } => {
                let argument = self.value(frame, *argument)?;
                self.relational(*fun, argument)
            }
            Expression::Math { fun, arg, arg1, arg2, arg3: None } => {
                let mut arguments = vec![self.value(frame, *arg)?];
                for argument in [arg1, arg2].into_iter().flatten() {
                    arguments.push(self.value(frame, *argument)?);
                }
                self.math(*fun, &arguments)
            }
            Expression::As { expr, kind, convert } => {
                let value = self.value(frame, *expr)?;
                self.cast(&value, *kind, convert.is_some())
            }
            Expression::Derivative { .. } => {
                unfit("asks how a value changes from pixel to pixel, which MaterialX does not tell")
            }
            Expression::ImageSample { .. }
            | Expression::ImageLoad { .. }
            | Expression::ImageQuery { .. } => unfit("reads an image"),
            _ => unfit("does what only programs of a GPU can"),
        }
    }

    fn load(&mut self, pointer: &Symbol) -> Result<Symbol, Unfit> {
        let Symbol::Pointer(slot, way) = pointer else {
            return unfit("reads memory that graphs do not have");
        };
        let mut found = self.memory[*slot].clone();
        for place in way {
            found = self.part(&found, *place)?;
        }
        Ok(found)
    }

    /// A value of its parts, which for a vector may be vectors themselves.
    fn composed(&mut self, ty: Handle<Type>, parts: Vec<Symbol>) -> Result<Symbol, Unfit> {
        if !matches!(self.module.types[ty].inner, TypeInner::Vector { .. }) {
            return Ok(Symbol::List(parts));
        }
        let mut singles = Vec::new();
        for part in &parts {
            singles.extend(part.singles(&mut self.terms));
        }
        Ok(Symbol::vector(singles, &mut self.terms))
    }

    fn literal(&mut self, literal: Literal) -> Result<Symbol, Unfit> {
        #[expect(clippy::cast_precision_loss, reason = "numbers of a shader have 32 bits")]
        Ok(match literal {
            Literal::F32(x) => Symbol::Number(self.terms.number(f64::from(x))),
            Literal::F64(x) | Literal::AbstractFloat(x) => Symbol::Number(self.terms.number(x)),
            Literal::U32(x) => Symbol::Whole(self.terms.number(f64::from(x))),
            Literal::I32(x) => Symbol::Whole(self.terms.number(f64::from(x))),
            Literal::I64(x) | Literal::AbstractInt(x) => Symbol::Whole(self.terms.number(x as f64)),
            Literal::Bool(x) => Symbol::Truth(Truth::Known(x)),
            _ => return unfit("has numbers of a kind that graphs do not have"),
        })
    }

    fn part(&mut self, value: &Symbol, place: usize) -> Result<Symbol, Unfit> {
        let part = value.part(place, &mut self.terms);
        part.ok_or_else(|| Unfit("takes a part of what has none".to_owned()))
    }

    /// An element by an index that may be open.
    fn access(&mut self, base: &Symbol, index: &Symbol) -> Result<Symbol, Unfit> {
        if let Some(known) = index.whole(&self.terms) {
            return self.part(base, usize::try_from(known).unwrap_or_default());
        }
        let (Symbol::Whole(index), Symbol::Number(_) | Symbol::List(_)) = (index, base) else {
            return unfit("reads a list at a place that the picture decides");
        };
        let elements = base.singles(&mut self.terms);
        if elements.len() > 8 {
            return unfit("reads a long list at a place that the picture decides");
        }
        let mut elements = elements.into_iter().enumerate().rev();
        let Some((_, mut found)) = elements.next() else { return unfit("reads an empty list") };
        for (place, element) in elements {
            let place = self.terms.number(place as f64);
            let is_it = self.terms.test("ifequal", *index, place);
            found = self.chosen(&is_it, &element, &found)?;
        }
        Ok(found)
    }

    fn unary(&mut self, op: UnaryOperator, value: &Symbol) -> Result<Symbol, Unfit> {
        let minus = self.terms.number(-1.0);
        match (op, value) {
            (UnaryOperator::Negate, Symbol::Number(id)) => {
                Ok(Symbol::Number(self.terms.each("multiply", &[*id, minus])))
            }
            (UnaryOperator::Negate, Symbol::Whole(id)) => {
                Ok(Symbol::Whole(self.terms.each("multiply", &[*id, minus])))
            }
            (UnaryOperator::LogicalNot, Symbol::Truth(truth)) => {
                Ok(Symbol::Truth(truth.clone().not()))
            }
            (_, Symbol::List(list)) => {
                let list: Result<Vec<Symbol>, Unfit> =
                    list.iter().map(|it| self.unary(op, it)).collect();
                list.map(Symbol::List)
            }
            _ => unfit(BITS),
        }
    }

    fn binary(&mut self, op: Op, left: &Symbol, right: &Symbol) -> Result<Symbol, Unfit> {
        match (left, right) {
            (Symbol::Number(a), Symbol::Number(b)) => self.numbers(op, *a, *b),
            (Symbol::Whole(a), Symbol::Whole(b)) => wholes(&mut self.terms, op, *a, *b),
            (Symbol::Truth(a), Symbol::Truth(b)) => {
                let (a, b) = (a.clone(), b.clone());
                Ok(Symbol::Truth(match op {
                    Op::And | Op::LogicalAnd => a.and(b),
                    Op::InclusiveOr | Op::LogicalOr => a.or(b),
                    Op::NotEqual | Op::ExclusiveOr => {
                        a.clone().and(b.clone().not()).or(a.not().and(b))
                    }
                    Op::Equal => a.clone().and(b.clone()).or(a.not().and(b.not())),
                    _ => return unfit("calculates with truth values"),
                }))
            }
            (Symbol::List(columns), Symbol::Number(b)) if op == Op::Multiply => {
                let scales = right.singles(&mut self.terms);
                let is_scale = self.terms.width(*b) == 1;
                let scale = |place: usize| if is_scale { right } else { &scales[place] };
                let scaled: Result<Vec<Symbol>, Unfit> = columns
                    .iter()
                    .enumerate()
                    .map(|(place, column)| self.binary(op, column, scale(place)))
                    .collect();
                let scaled = scaled?;
                if is_scale {
                    return Ok(Symbol::List(scaled));
                }
                let mut columns = scaled.into_iter();
                let Some(mut sum) = columns.next() else { return unfit("has an empty matrix") };
                for column in columns {
                    sum = self.binary(Op::Add, &sum, &column)?;
                }
                Ok(sum)
            }
            (Symbol::Number(a), Symbol::List(columns)) if op == Op::Multiply => {
                let is_scale = self.terms.width(*a) == 1;
                let mut found = Vec::new();
                for column in columns {
                    found.push(match is_scale {
                        true => self.binary(op, left, column)?,
                        false => self.math(Math::Dot, &[left.clone(), column.clone()])?,
                    });
                }
                Ok(match is_scale {
                    true => Symbol::List(found),
                    false => Symbol::vector(found, &mut self.terms),
                })
            }
            (Symbol::List(a), Symbol::List(b)) => {
                let is_matrix = matches!(
                    (a.first(), b.first()),
                    (Some(Symbol::Number(_)), Some(Symbol::Number(_)))
                );
                let mut found = Vec::new();
                for (place, column) in b.iter().enumerate() {
                    found.push(match is_matrix && op == Op::Multiply {
                        true => self.binary(op, left, column)?,
                        false => {
                            let own = a.get(place).cloned().unwrap_or(Symbol::Foreign);
                            self.binary(op, &own, column)?
                        }
                    });
                }
                Ok(Symbol::List(found))
            }
            (Symbol::List(list), one) => {
                let list: Result<Vec<Symbol>, Unfit> =
                    list.iter().map(|it| self.binary(op, it, one)).collect();
                list.map(Symbol::List)
            }
            (one, Symbol::List(list)) => {
                let list: Result<Vec<Symbol>, Unfit> =
                    list.iter().map(|it| self.binary(op, one, it)).collect();
                list.map(Symbol::List)
            }
            _ => unfit("calculates with what is no number"),
        }
    }

    fn numbers(&mut self, op: Op, a: TermId, b: TermId) -> Result<Symbol, Unfit> {
        let kind = match op {
            Op::Add => "add",
            Op::Subtract => "subtract",
            Op::Multiply => "multiply",
            Op::Divide => "divide",
            Op::Modulo => {
                // WGSL rounds toward zero, nodes downward.
                let quotient = self.terms.each("divide", &[a, b]);
                let whole = self.math(Math::Trunc, &[Symbol::Number(quotient)])?;
                let Symbol::Number(whole) = whole else { return unfit(BITS) };
                let back = self.terms.each("multiply", &[whole, b]);
                return Ok(Symbol::Number(self.terms.each("subtract", &[a, back])));
            }
            _ => {
                let width = self.terms.width(a);
                let mut found = Vec::with_capacity(width);
                for place in 0..width {
                    let one = self.terms.component(a, place);
                    let two = self.terms.component(b, place);
                    found.push(Symbol::Truth(compared(&mut self.terms, op, one, two)?));
                }
                return Ok(Symbol::vector(found, &mut self.terms));
            }
        };
        Ok(Symbol::Number(self.terms.each(kind, &[a, b])))
    }

    fn select(&mut self, condition: &Symbol, on: &Symbol, off: &Symbol) -> Result<Symbol, Unfit> {
        match condition {
            Symbol::Truth(truth) => self.chosen(truth, on, off),
            Symbol::List(truths) => {
                let (on, off) = (on.singles(&mut self.terms), off.singles(&mut self.terms));
                let mut found = Vec::new();
                for ((truth, on), off) in truths.iter().zip(&on).zip(&off) {
                    found.push(self.select(truth, on, off)?);
                }
                Ok(Symbol::vector(found, &mut self.terms))
            }
            _ => unfit("asks what is no question"),
        }
    }

    fn relational(&mut self, fun: RelationalFunction, of: Symbol) -> Result<Symbol, Unfit> {
        let truths = match of {
            Symbol::List(list) => list,
            one => vec![one],
        };
        let is_all = match fun {
            RelationalFunction::All => true,
            RelationalFunction::Any => false,
            // Nothing here is made of numbers that are none.
            _ => return Ok(Symbol::Truth(Truth::Known(false))),
        };
        let mut found = Truth::Known(is_all);
        for truth in truths {
            let Symbol::Truth(truth) = truth else { return unfit("asks what is no question") };
            found = if is_all { found.and(truth) } else { found.or(truth) };
        }
        Ok(Symbol::Truth(found))
    }

    fn math(&mut self, fun: Math, arguments: &[Symbol]) -> Result<Symbol, Unfit> {
        if let (Math::Transpose, [Symbol::List(columns)]) = (fun, arguments) {
            let columns: Vec<Vec<Symbol>> =
                columns.iter().map(|column| column.singles(&mut self.terms)).collect();
            let rows = columns.first().map_or(0, Vec::len);
            let row = |place: usize| columns.iter().map(move |it| it[place].clone()).collect();
            let rows: Vec<Vec<Symbol>> = (0..rows).map(row).collect();
            let rows = rows.into_iter().map(|row| Symbol::vector(row, &mut self.terms));
            return Ok(Symbol::List(rows.collect()));
        }
        let mut ids = Vec::new();
        let mut is_whole = false;
        for argument in arguments {
            match argument {
                Symbol::Number(id) => ids.push(*id),
                Symbol::Whole(id) => {
                    is_whole = true;
                    ids.push(*id);
                }
                // Vectors of integers, one after the other.
                Symbol::List(list) => {
                    let mut found = Vec::new();
                    for place in 0..list.len() {
                        let own: Result<Vec<Symbol>, Unfit> =
                            arguments.iter().map(|it| self.part(it, place)).collect();
                        found.push(self.math(fun, &own?)?);
                    }
                    return Ok(Symbol::vector(found, &mut self.terms));
                }
                _ => return unfit("calculates with what is no number"),
            }
        }
        let id = of_numbers(&mut self.terms, fun, &ids)?;
        Ok(if is_whole { Symbol::Whole(id) } else { Symbol::Number(id) })
    }

    fn cast(&mut self, value: &Symbol, kind: ScalarKind, is_value: bool) -> Result<Symbol, Unfit> {
        match (value, kind) {
            (Symbol::Number(_), ScalarKind::Float) => Ok(value.clone()),
            (Symbol::Number(id), _) if self.terms.width(*id) > 1 => {
                let mut found = Vec::new();
                for single in value.singles(&mut self.terms) {
                    found.push(self.cast(&single, kind, is_value)?);
                }
                Ok(Symbol::List(found))
            }
            (Symbol::List(list), _) => {
                let list: Result<Vec<Symbol>, Unfit> =
                    list.iter().map(|it| self.cast(it, kind, is_value)).collect();
                Ok(Symbol::vector(list?, &mut self.terms))
            }
            (Symbol::Truth(truth), ScalarKind::Bool) => Ok(Symbol::Truth(truth.clone())),
            (Symbol::Truth(truth), _) => {
                let (on, off) = (self.terms.number(1.0), self.terms.number(0.0));
                let id = self.terms.choose(truth, on, off);
                let is_float = kind == ScalarKind::Float;
                Ok(if is_float { Symbol::Number(id) } else { Symbol::Whole(id) })
            }
            (Symbol::Number(id) | Symbol::Whole(id), ScalarKind::Bool) => {
                let zero = self.terms.number(0.0);
                Ok(Symbol::Truth(self.terms.test("ifequal", *id, zero).not()))
            }
            _ if !is_value => unfit(BITS),
            (Symbol::Whole(id), ScalarKind::Float) => Ok(Symbol::Number(*id)),
            (Symbol::Whole(id), _) => match value.whole(&self.terms) {
                Some(known) if known < 0 && kind == ScalarKind::Uint => {
                    let wrapped = known.rem_euclid(1 << 32);
                    Ok(Symbol::Whole(self.terms.number(wrapped as f64)))
                }
                _ => Ok(Symbol::Whole(*id)),
            },
            (Symbol::Number(_), _) => match self.math(Math::Trunc, std::slice::from_ref(value))? {
                Symbol::Number(id) => Ok(Symbol::Whole(id)),
                _ => unfit(BITS),
            },
            _ => unfit("makes numbers of what is none"),
        }
    }
}

/// A comparison.
fn compared(terms: &mut Terms, op: Op, a: TermId, b: TermId) -> Result<Truth, Unfit> {
    Ok(match op {
        Op::Greater => terms.test("ifgreater", a, b),
        Op::GreaterEqual => terms.test("ifgreatereq", a, b),
        Op::Less => terms.test("ifgreater", b, a),
        Op::LessEqual => terms.test("ifgreatereq", b, a),
        Op::Equal => terms.test("ifequal", a, b),
        Op::NotEqual => terms.test("ifequal", a, b).not(),
        _ => return unfit(BITS),
    })
}

/// Arithmetic of integers: of those that are known as shaders have it, of others in floats.
fn wholes(terms: &mut Terms, op: Op, a: TermId, b: TermId) -> Result<Symbol, Unfit> {
    let known = |id: TermId| Symbol::Whole(id).whole(terms);
    if let (Some(one), Some(two)) = (known(a), known(b)) {
        let found = match op {
            Op::Add => Some(one + two),
            Op::Subtract => Some(one - two),
            Op::Multiply => one.checked_mul(two),
            Op::Divide => one.checked_div(two),
            Op::Modulo => one.checked_rem(two),
            Op::And => Some(one & two),
            Op::InclusiveOr => Some(one | two),
            Op::ExclusiveOr => Some(one ^ two),
            Op::ShiftLeft => u32::try_from(two).ok().and_then(|by| one.checked_shl(by)),
            Op::ShiftRight => u32::try_from(two).ok().and_then(|by| one.checked_shr(by)),
            _ => return Ok(Symbol::Truth(compared(terms, op, a, b)?)),
        };
        // Beyond 32 bits integers wrap, by their sign, which terms do not have.
        let range = i64::from(i32::MIN)..=i64::from(i32::MAX);
        return match found.filter(|found| range.contains(found)) {
            Some(found) => Ok(Symbol::Whole(terms.number(found as f64))),
            None => unfit(BITS),
        };
    }
    match op {
        Op::Add => Ok(Symbol::Whole(terms.each("add", &[a, b]))),
        Op::Subtract => Ok(Symbol::Whole(terms.each("subtract", &[a, b]))),
        Op::Multiply => Ok(Symbol::Whole(terms.each("multiply", &[a, b]))),
        Op::Divide | Op::Modulo => unfit("divides integers, for which MaterialX has no nodes"),
        _ => Ok(Symbol::Truth(compared(terms, op, a, b)?)),
    }
}

/// A function of floats.
fn of_numbers(terms: &mut Terms, fun: Math, ids: &[TermId]) -> Result<TermId, Unfit> {
    if let Some(kind) = node_of(fun) {
        return Ok(terms.each(kind, ids));
    }
    let width = ids.iter().map(|id| terms.width(*id)).max().unwrap_or(1);
    let (zero, one) = (terms.number(0.0), terms.number(1.0));
    Ok(match (fun, ids) {
        (Math::Saturate, [x]) => terms.each("clamp", &[*x, zero, one]),
        (Math::Atan, [x]) => {
            let one = terms.splat(one, width);
            terms.each("atan2", &[*x, one])
        }
        (Math::Exp2, [x]) => {
            let two = terms.number(2.0);
            terms.each("power", &[two, *x])
        }
        (Math::Log2, [x]) => {
            let (log, scale) = (terms.each("ln", &[*x]), terms.number(std::f64::consts::LOG2_E));
            terms.each("multiply", &[log, scale])
        }
        (Math::Radians | Math::Degrees, [x]) => {
            let is_radians = fun == Math::Radians;
            let factor = if is_radians { 1.0_f64.to_radians() } else { 1.0_f64.to_degrees() };
            let factor = terms.number(factor);
            terms.each("multiply", &[*x, factor])
        }
        (Math::InverseSqrt, [x]) => {
            let root = terms.each("sqrt", &[*x]);
            terms.each("divide", &[one, root])
        }
        (Math::Dot, [a, b]) => terms.node("dotproduct", &[*a, *b], 1),
        (Math::Cross, [a, b]) => terms.node("crossproduct", &[*a, *b], 3),
        (Math::Length, [x]) if width == 1 => terms.each("absval", &[*x]),
        (Math::Length, [x]) => terms.node("magnitude", &[*x], 1),
        (Math::Distance, [a, b]) => {
            let way = terms.each("subtract", &[*a, *b]);
            let kind = if width == 1 { "absval" } else { "magnitude" };
            terms.node(kind, &[way], 1)
        }
        (Math::Normalize, [x]) => terms.unit(*x),
        (Math::Fma, [a, b, c]) => {
            let product = terms.each("multiply", &[*a, *b]);
            terms.each("add", &[product, *c])
        }
        (Math::Mix, [a, b, by]) => {
            if terms.is_all(*by, 0.0) {
                return Ok(*a);
            }
            if terms.is_all(*by, 1.0) {
                return Ok(*b);
            }
            terms.node("mix", &[*b, *a, *by], width)
        }
        (Math::SmoothStep, [low, high, x]) => terms.node("smoothstep", &[*x, *low, *high], width),
        (Math::Reflect, [way, normal]) => {
            let along = terms.node("dotproduct", &[*normal, *way], 1);
            let two = terms.number(2.0);
            let twice = terms.each("multiply", &[along, two]);
            let back = terms.each("multiply", &[*normal, twice]);
            terms.each("subtract", &[*way, back])
        }
        (Math::Step | Math::Trunc | Math::Sinh | Math::Cosh | Math::Tanh, _) => {
            let mut found = Vec::with_capacity(width);
            for place in 0..width {
                let own: Vec<TermId> = ids.iter().map(|id| terms.component(*id, place)).collect();
                found.push(of_one(terms, fun, &own)?);
            }
            terms.combine(&found)
        }
        _ => return unfit("calls a function for which MaterialX has no nodes"),
    })
}

/// A function of single floats.
fn of_one(terms: &mut Terms, fun: Math, ids: &[TermId]) -> Result<TermId, Unfit> {
    let (zero, one) = (terms.number(0.0), terms.number(1.0));
    match (fun, ids) {
        (Math::Step, [edge, x]) => {
            let is_beyond = terms.test("ifgreatereq", *x, *edge);
            Ok(terms.choose(&is_beyond, one, zero))
        }
        (Math::Trunc, [x]) => {
            let is_positive = terms.test("ifgreatereq", *x, zero);
            let (below, above) = (terms.each("floor", &[*x]), terms.each("ceil", &[*x]));
            Ok(terms.choose(&is_positive, below, above))
        }
        _ => unfit("calls a function for which MaterialX has no nodes"),
    }
}
