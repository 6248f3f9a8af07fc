//! Expressions of a function as terms of a language.

use chiaro_locale::tr;
use naga::proc::TypeResolution;
use naga::{
    BinaryOperator, DerivativeAxis, Expression, Handle, Literal, MathFunction, RelationalFunction,
    ScalarKind, SwizzleComponent, UnaryOperator,
};

use super::dialect::{Kind, Level, NameOf, Term, ValueType};
use super::function::{FunctionWriter, Refusal};
use super::types;

impl FunctionWriter<'_> {
    /// The term of an expression: its name where it has one, else its own text.
    pub(super) fn term(&mut self, handle: Handle<Expression>) -> Result<Term, Refusal> {
        if let Some(term) = self.terms.get(&handle) {
            return Ok(term.clone());
        }
        self.text(handle)
    }

    /// Type of an expression, or of what it points to.
    pub(super) fn type_of(&self, handle: Handle<Expression>) -> Result<ValueType, Refusal> {
        let found = match &self.info[handle].ty {
            TypeResolution::Handle(ty) => types::of(self.module, *ty),
            TypeResolution::Value(inner) => types::value_type(self.module, inner),
        };
        found.ok_or_else(|| self.refusal(tr!("a type of its own kind")))
    }

    /// The text of an expression.
    pub(super) fn text(&mut self, handle: Handle<Expression>) -> Result<Term, Refusal> {
        let function = self.function;
        match &function.expressions[handle] {
            Expression::Literal(literal) => {
                Ok(self.literal(*literal, function.expressions.get_span(handle)))
            }
            Expression::Constant(constant) => self.constant(*constant),
            Expression::ZeroValue(_) => {
                let ty = self.type_of(handle)?;
                self.zero(&ty)
            }
            Expression::Compose { components, .. } => self.compose(handle, components),
            Expression::Splat { value, .. } => {
                let ty = self.type_of(handle)?;
                let value = self.term(*value)?;
                self.splat(value, &ty)
            }
            Expression::Swizzle { size, vector, pattern } => {
                let (ty, of) = (self.type_of(handle)?, self.type_of(*vector)?);
                let vector = self.simple(*vector)?;
                let item = |component: &SwizzleComponent| {
                    self.dialect.part(&vector, *component as usize, &of)
                };
                let items: Vec<Term> = pattern[..*size as usize].iter().map(item).collect();
                Ok(self.dialect.list(&items, &ty))
            }
            Expression::FunctionArgument(index) => {
                Ok(Term::primary(self.parameters[*index as usize].0.clone()))
            }
            Expression::LocalVariable(variable) => {
                Ok(Term::primary(self.variables[variable].clone()))
            }
            Expression::Load { pointer } => self.load(*pointer),
            Expression::Access { base, index } => {
                let ty = self.type_of(*base)?;
                let base = self.base_of_part(*base)?;
                let index = self.term(*index)?;
                Ok(match ty {
                    ValueType::Vector(..) => self.dialect.component(&base, &index, &ty),
                    _ => self.dialect.element(&base, &self.dialect.index(&index)),
                })
            }
            Expression::AccessIndex { base, index } => self.access(*base, *index),
            Expression::Unary { op, expr } => {
                let operation = match op {
                    UnaryOperator::Negate => "negate",
                    UnaryOperator::LogicalNot => "!",
                    UnaryOperator::BitwiseNot => "~",
                };
                self.operation(operation, &[*expr])
            }
            Expression::Binary { op, left, right } => self.binary(*op, *left, *right),
            Expression::Select { condition, accept, reject } => {
                self.operation("select", &[*condition, *accept, *reject])
            }
            Expression::Relational { fun, argument } => self.relational(*fun, *argument),
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let rest = [arg1, arg2, arg3].into_iter().filter_map(|it| *it);
                let operands: Vec<_> = std::iter::once(*arg).chain(rest).collect();
                self.math(*fun, &operands)
            }
            Expression::As { expr, kind, convert } => self.convert(*expr, *kind, convert.is_some()),
            Expression::Derivative { axis, expr, .. } => {
                let operation = match axis {
                    DerivativeAxis::X => "dpdx",
                    DerivativeAxis::Y => "dpdy",
                    DerivativeAxis::Width => "fwidth",
                };
                let found = self.operation(operation, &[*expr]);
                found.map_err(|_| self.refusal("`Derivative`"))
            }
            other => {
                let debug = format!("{other:?}");
                let name = debug.split([' ', '(', '{']).next().unwrap_or_default();
                Err(self.refusal(&format!("`{name}`")))
            }
        }
    }

    fn literal(&mut self, literal: Literal, span: naga::Span) -> Term {
        let dialect = self.dialect;
        let (kind, term) = match literal {
            Literal::F32(single) => {
                let wide = self.shared.literals.wide(span, single);
                (Kind::Float, dialect.float(wide.unwrap_or_else(|| f64::from(single))))
            }
            Literal::F64(x) | Literal::AbstractFloat(x) => (Kind::Float, dialect.float(x)),
            Literal::F16(x) => (Kind::Float, dialect.float(x.to_f64())),
            Literal::U32(x) => (Kind::Unsigned, dialect.integer(i64::from(x), Kind::Unsigned)),
            Literal::U16(x) => (Kind::Unsigned, dialect.integer(i64::from(x), Kind::Unsigned)),
            Literal::U64(x) => (Kind::Unsigned, dialect.integer(x.cast_signed(), Kind::Unsigned)),
            Literal::I32(x) => (Kind::Signed, dialect.integer(i64::from(x), Kind::Signed)),
            Literal::I16(x) => (Kind::Signed, dialect.integer(i64::from(x), Kind::Signed)),
            Literal::I64(x) | Literal::AbstractInt(x) => {
                (Kind::Signed, dialect.integer(x, Kind::Signed))
            }
            Literal::Bool(x) => (Kind::Bool, dialect.truth(x)),
        };
        self.shared.constant_at(span, kind, &term).map_or(term, Term::primary)
    }

    fn constant(&mut self, constant: Handle<naga::Constant>) -> Result<Term, Refusal> {
        let named = &self.module.constants[constant];
        if let Some(name) = named.name.as_deref().and_then(|name| self.shared.constant(name)) {
            return Ok(Term::primary(name));
        }
        Err(self.refusal(tr!("a constant without a name")))
    }

    /// The zero of a type.
    pub(super) fn zero(&mut self, ty: &ValueType) -> Result<Term, Refusal> {
        Ok(match ty {
            ValueType::Scalar(Kind::Bool) => self.dialect.truth(false),
            ValueType::Scalar(Kind::Float) => self.dialect.float(0.0),
            ValueType::Scalar(kind) => self.dialect.integer(0, *kind),
            ValueType::Vector(count, kind) => {
                let item = self.zero(&ValueType::Scalar(*kind))?;
                self.dialect.list(&vec![item; *count], ty)
            }
            ValueType::Matrix(columns, rows) => {
                let column = self.zero(&ValueType::Vector(*rows, Kind::Float))?;
                self.dialect.list(&vec![column; *columns], ty)
            }
            ValueType::Array(count, element) => {
                let item = self.zero(element)?;
                if element.is_composite() {
                    self.dialect.list(&vec![item; *count], ty)
                } else {
                    self.dialect.repeated(&item, *count)
                }
            }
            ValueType::Struct(name) => {
                let members = self.members(name)?;
                let mut terms = Vec::new();
                for (member, ty) in members {
                    terms.push((member, self.zero(&ty)?));
                }
                self.dialect.structure(&self.shared.structure(name), &terms)
            }
        })
    }

    fn members(&self, name: &str) -> Result<Vec<(String, ValueType)>, Refusal> {
        let found = self.module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name));
        let members = found.and_then(|(handle, _)| types::members(self.module, handle));
        let members = members.ok_or_else(|| self.refusal(&tr!("the struct `{name}`")))?;
        let styled =
            |(name, ty): (String, ValueType)| (self.dialect.styled(&name, NameOf::Member), ty);
        Ok(members.into_iter().map(styled).collect())
    }

    fn compose(
        &mut self,
        handle: Handle<Expression>,
        components: &[Handle<Expression>],
    ) -> Result<Term, Refusal> {
        let ty = self.type_of(handle)?;
        match &ty {
            ValueType::Struct(name) => {
                let members = self.members(name)?;
                let mut terms = Vec::new();
                for ((member, _), component) in members.into_iter().zip(components) {
                    terms.push((member, self.term(*component)?));
                }
                Ok(self.dialect.structure(&self.shared.structure(name), &terms))
            }
            // Vectors may be composed of vectors.
            ValueType::Vector(..) => {
                let mut items = Vec::new();
                for &component in components {
                    match self.type_of(component)? {
                        of @ ValueType::Vector(count, _) => {
                            let vector = self.simple(component)?;
                            let parts =
                                (0..count).map(|index| self.dialect.part(&vector, index, &of));
                            items.extend(parts);
                        }
                        _ => items.push(self.term(component)?),
                    }
                }
                Ok(self.dialect.list(&items, &ty))
            }
            _ => {
                let items =
                    components.iter().map(|&it| self.term(it)).collect::<Result<Vec<_>, _>>()?;
                Ok(self.dialect.list(&items, &ty))
            }
        }
    }

    /// A vector of one value.
    fn splat(&mut self, value: Term, ty: &ValueType) -> Result<Term, Refusal> {
        let ValueType::Vector(count, kind) = ty else { return Ok(value) };
        if let Some(term) = self.dialect.splat(&value, ty) {
            return Ok(term);
        }
        let value = self.named_if_long(value, &ValueType::Scalar(*kind));
        Ok(self.dialect.list(&vec![value; *count], ty))
    }

    /// The term of an expression, with a name where the text would be long: it is to be written
    /// several times.
    fn simple(&mut self, handle: Handle<Expression>) -> Result<Term, Refusal> {
        let ty = self.type_of(handle)?;
        let term = self.term(handle)?;
        let is_constant = matches!(self.function.expressions[handle], Expression::Constant(_));
        if is_constant && !self.dialect.takes_parts_of_results() {
            return Ok(self.declare_value("value", &ty, &term));
        }
        Ok(self.named_if_long(term, &ty))
    }

    /// The term of a value that a part is taken of.
    fn base_of_part(&mut self, handle: Handle<Expression>) -> Result<Term, Refusal> {
        let term = self.term(handle)?;
        let is_path = match self.function.expressions[handle] {
            Expression::Constant(_) => false,
            Expression::Access { .. } | Expression::AccessIndex { .. } => true,
            _ => !term.text.contains(['(', ' ']),
        };
        if is_path || self.is_place(handle) || self.dialect.takes_parts_of_results() {
            return Ok(term);
        }
        let ty = self.type_of(handle)?;
        Ok(self.declare_value("value", &ty, &term))
    }

    fn named_if_long(&mut self, term: Term, ty: &ValueType) -> Term {
        let is_short = term.level <= Level::Unary && !term.text.contains(['(', '[', '{', ' ']);
        if is_short { term } else { self.declare_value("value", ty, &term) }
    }

    fn load(&mut self, pointer: Handle<Expression>) -> Result<Term, Refusal> {
        let ty = self.type_of(pointer)?;
        let place = self.term(pointer)?;
        let is_built = self.variable(pointer).is_some_and(|it| self.uses.built.contains(&it));
        let is_shared = is_built && ty.is_composite() && !self.is_returned;
        Ok(if is_shared { self.dialect.copy(&place, &ty) } else { place })
    }

    fn access(&mut self, base: Handle<Expression>, index: u32) -> Result<Term, Refusal> {
        let ty = self.type_of(base)?;
        let term = self.base_of_part(base)?;
        match &ty {
            ValueType::Struct(name) => {
                let members = self.members(name)?;
                let member = members.into_iter().nth(index as usize).map(|(member, _)| member);
                Ok(self.dialect.member(&term, &member.unwrap_or_default()))
            }
            _ => Ok(self.dialect.part(&term, index as usize, &ty)),
        }
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Result<Term, Refusal> {
        let mut types = [self.type_of(left)?, self.type_of(right)?];
        let is_matrix = |ty: &ValueType| matches!(ty, ValueType::Matrix(..));
        if types.iter().any(is_matrix) {
            let mut operands = vec![self.term(left)?, self.term(right)?];
            let helper = match (operator, &types[0], &types[1]) {
                (BinaryOperator::Multiply, ValueType::Matrix(..), ValueType::Vector(..)) => {
                    "matrix_times_vector"
                }
                (BinaryOperator::Multiply, ValueType::Vector(..), ValueType::Matrix(..)) => {
                    "vector_times_matrix"
                }
                (BinaryOperator::Multiply, ValueType::Matrix(..), ValueType::Matrix(..)) => {
                    "matrix_times_matrix"
                }
                (BinaryOperator::Multiply, ValueType::Matrix(..), _) => "matrix_times_scalar",
                (BinaryOperator::Multiply, ..) => {
                    operands.reverse();
                    "matrix_times_scalar"
                }
                (BinaryOperator::Add, ..) => "matrix_plus_matrix",
                (BinaryOperator::Subtract, ..) => "matrix_minus_matrix",
                _ => return Err(self.refusal(tr!("an operation of matrices"))),
            };
            if helper == "matrix_times_scalar" && is_matrix(&types[1]) {
                types.reverse();
            }
            return self.whole(helper, &types, &operands);
        }
        let operation = match operator {
            BinaryOperator::Add => "+",
            BinaryOperator::Subtract => "-",
            BinaryOperator::Multiply => "*",
            BinaryOperator::Divide => "/",
            BinaryOperator::Modulo => "%",
            BinaryOperator::Equal => "==",
            BinaryOperator::NotEqual => "!=",
            BinaryOperator::Less => "<",
            BinaryOperator::LessEqual => "<=",
            BinaryOperator::Greater => ">",
            BinaryOperator::GreaterEqual => ">=",
            BinaryOperator::And => "&",
            BinaryOperator::ExclusiveOr => "^",
            BinaryOperator::InclusiveOr => "|",
            BinaryOperator::LogicalAnd => "&&",
            BinaryOperator::LogicalOr => "||",
            BinaryOperator::ShiftLeft => "<<",
            BinaryOperator::ShiftRight => ">>",
        };
        self.operation(operation, &[left, right])
    }

    fn relational(
        &mut self,
        function: RelationalFunction,
        argument: Handle<Expression>,
    ) -> Result<Term, Refusal> {
        let ty = self.type_of(argument)?;
        let helper = match function {
            RelationalFunction::All => "all",
            RelationalFunction::Any => "any",
            RelationalFunction::IsNan | RelationalFunction::IsInf => {
                return Err(self.refusal(tr!("a test for numbers that are none")));
            }
        };
        let term = self.term(argument)?;
        if ty.is_composite() { self.whole(helper, &[ty], &[term]) } else { Ok(term) }
    }

    /// Calls a helper function on whole values.
    fn whole(
        &mut self,
        name: &'static str,
        types: &[ValueType],
        operands: &[Term],
    ) -> Result<Term, Refusal> {
        let mut helpers = self.shared.helpers.borrow_mut();
        if let Some(term) = self.dialect.typed(name, types, operands, &mut helpers) {
            return Ok(term);
        }
        drop(helpers);
        if self.dialect.helper(name).is_none() {
            return Err(self.refusal(&format!("`{name}`")));
        }
        Ok(self.shared.helpers.borrow_mut().call(name, operands))
    }

    fn math(
        &mut self,
        function: MathFunction,
        operands: &[Handle<Expression>],
    ) -> Result<Term, Refusal> {
        let whole = match function {
            MathFunction::Dot => Some("dot"),
            MathFunction::Cross => Some("cross"),
            MathFunction::Normalize => Some("normalize"),
            MathFunction::Reflect => Some("reflect"),
            MathFunction::Transpose => Some("transpose"),
            MathFunction::Length | MathFunction::Distance => {
                let is_vector = self.type_of(operands[0])?.is_composite();
                match (function, is_vector) {
                    (MathFunction::Length, true) => Some("length"),
                    (MathFunction::Distance, true) => Some("distance"),
                    (MathFunction::Length, false) => return self.operation("abs", operands),
                    _ => return Err(self.refusal(tr!("a distance of numbers"))),
                }
            }
            _ => None,
        };
        if let Some(helper) = whole {
            let terms = operands.iter().map(|&it| self.term(it)).collect::<Result<Vec<_>, _>>()?;
            let types =
                operands.iter().map(|&it| self.type_of(it)).collect::<Result<Vec<_>, _>>()?;
            return self.whole(helper, &types, &terms);
        }
        let name = format!("{function:?}").to_lowercase();
        self.operation(&name, operands)
    }

    fn convert(
        &mut self,
        operand: Handle<Expression>,
        kind: ScalarKind,
        is_conversion: bool,
    ) -> Result<Term, Refusal> {
        let operation = match (kind, is_conversion) {
            (ScalarKind::Float | ScalarKind::AbstractFloat, true) => "to_float",
            (ScalarKind::Sint | ScalarKind::AbstractInt, true) => "to_signed",
            (ScalarKind::Uint, true) => "to_unsigned",
            (ScalarKind::Bool, _) => "to_bool",
            (ScalarKind::Float | ScalarKind::AbstractFloat, false) => "bits_to_float",
            (ScalarKind::Sint | ScalarKind::AbstractInt, false) => "bits_to_signed",
            (ScalarKind::Uint, false) => "bits_to_unsigned",
        };
        if let ValueType::Matrix(..) = self.type_of(operand)? {
            return self.term(operand);
        }
        self.operation(operation, &[operand])
    }

    /// An operation on scalars, component by component where operands are vectors.
    fn operation(
        &mut self,
        operation: &str,
        operands: &[Handle<Expression>],
    ) -> Result<Term, Refusal> {
        let types = operands.iter().map(|&it| self.type_of(it)).collect::<Result<Vec<_>, _>>()?;
        let mut terms = operands.iter().map(|&it| self.term(it)).collect::<Result<Vec<_>, _>>()?;
        let kind_of = |ty: &ValueType| match ty {
            ValueType::Scalar(kind) | ValueType::Vector(_, kind) => *kind,
            _ => Kind::Float,
        };
        let deciding = if operation == "select" { &types[1] } else { &types[0] };
        let kind = kind_of(deciding);
        let is_vector = |ty: &ValueType| matches!(ty, ValueType::Vector(..));
        // A choice between whole values is one, whatever they are.
        let is_choice = operation == "select" && !is_vector(&types[0]);
        let vector = types.iter().find(|ty| is_vector(ty)).filter(|_| !is_choice).cloned();
        if is_choice && types[1].is_composite() {
            let mut helpers = self.shared.helpers.borrow_mut();
            if let Some(term) = self.dialect.choice(&types, &terms, &mut helpers) {
                return Ok(term);
            }
        }
        let Some(vector) = vector else {
            let mut helpers = self.shared.helpers.borrow_mut();
            let found = self.dialect.scalar(operation, kind, &terms, &mut helpers);
            drop(helpers);
            return found.ok_or_else(|| self.refusal(&format!("`{operation}`")));
        };
        let mut helpers = self.shared.helpers.borrow_mut();
        if let Some(term) = self.dialect.typed(operation, &types, &terms, &mut helpers) {
            return Ok(term);
        }
        drop(helpers);
        let ValueType::Vector(count, _) = vector else { return Err(self.refusal(tr!("a vector"))) };
        for (term, ty) in terms.iter_mut().zip(&types) {
            if !is_vector(ty) {
                *term = self.splat(term.clone(), &ValueType::Vector(count, kind_of(ty)))?;
            }
        }
        let places: Vec<Term> =
            ["x", "y", "z"][..terms.len()].iter().map(|name| Term::primary(*name)).collect();
        let mut helpers = self.shared.helpers.borrow_mut();
        let body = self.dialect.scalar(operation, kind, &places, &mut helpers);
        let Some(body) = body else {
            drop(helpers);
            return Err(self.refusal(&tr!("`{operation}` of vectors")));
        };
        let result = result_kind(operation, kind);
        let name = vector_name(operation, kind);
        let source = self.dialect.each(&name, terms.len(), [kind, result], &body.text);
        helpers.made.insert(name.clone(), source);
        Ok(Term::call(&name, &terms))
    }
}

/// Kind of an operation's result.
pub(super) fn result_kind(operation: &str, kind: Kind) -> Kind {
    match operation {
        "==" | "!=" | "<" | "<=" | ">" | ">=" | "&&" | "||" | "!" | "to_bool" => Kind::Bool,
        "to_float" | "bits_to_float" => Kind::Float,
        "to_signed" | "bits_to_signed" => Kind::Signed,
        "to_unsigned" | "bits_to_unsigned" => Kind::Unsigned,
        _ => kind,
    }
}

/// Name of the function that runs an operation on each component.
fn vector_name(operation: &str, kind: Kind) -> String {
    let word = match operation {
        "+" => "add",
        "-" => "subtract",
        "*" => "multiply",
        "/" => "divide",
        "%" => "remainder",
        "==" => "equal",
        "!=" => "not_equal",
        "<" => "less",
        "<=" => "less_equal",
        ">" => "greater",
        ">=" => "greater_equal",
        "&" | "&&" => "and",
        "|" | "||" => "or",
        "^" => "xor",
        "<<" => "shift_left",
        ">>" => "shift_right",
        "!" | "~" => "not",
        other => other,
    };
    let ending = match kind {
        Kind::Float => "",
        Kind::Signed => "_i32",
        Kind::Unsigned => "_u32",
        Kind::Bool => "_bool",
    };
    format!("vector_{word}{ending}")
}
