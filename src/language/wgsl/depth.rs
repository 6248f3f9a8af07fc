//! Depth of a shader: the longest chain of operations that follow from one another, as a driver
//! sees them, with all calls inlined.
//!
//! Drivers visit the operands of a value, and theirs in turn, by recursion: Mesa's range analysis
//! takes up to 150 bytes of stack for each operation on the way. So a long chain of nodes overflows
//! the stack of a program that compiles it, however it was split into functions.

use std::rc::Rc;

use naga::{BinaryOperator, Block, Expression, Function, Handle, MathFunction, Module, Statement};

use super::operations::Operations;

/// Number of operations, calls inlined, beyond which a shader is not walked: its depth is given as
/// their number.
const MAX_WALKED: u64 = 4_000_000;
/// Depth of calls beyond which functions are not walked.
const MAX_CALL_DEPTH: usize = 600;

/// Length of the longest chain of operations of any entry point. Loops count as one round.
pub fn depth_of_entry_points(module: &Module) -> u64 {
    let operations = Operations::of(module).of_entry_points(module);
    if operations > MAX_WALKED {
        return operations;
    }
    let deepest = |function: &Function| {
        let mut walk = Walk { module, deepest: 0, calls: 0, private: 0 };
        walk.function(function, &[]);
        walk.deepest
    };
    module.entry_points.iter().map(|entry| deepest(&entry.function)).max().unwrap_or_default()
}

/// Depth of a value.
#[derive(Clone, Debug)]
enum Depth {
    /// Depth of the whole value.
    Whole(u64),
    /// Depth of each member: the results of a part of a look are values that have nothing to do
    /// with one another.
    Members(Rc<[u64]>),
}

impl Depth {
    fn most(&self) -> u64 {
        match self {
            Self::Whole(depth) => *depth,
            Self::Members(members) => members.iter().copied().max().unwrap_or_default(),
        }
    }

    fn member(&self, index: u32) -> u64 {
        match self {
            Self::Members(members) => members.get(index as usize).copied().unwrap_or_default(),
            Self::Whole(depth) => *depth,
        }
    }
}

struct Walk<'a> {
    module: &'a Module,
    deepest: u64,
    /// Number of calls under way.
    calls: usize,
    /// Greatest depth that was stored in a private variable.
    private: u64,
}

/// Call under way.
struct DepthFrame<'a> {
    function: &'a Function,
    arguments: &'a [Depth],
    /// Depth of each expression, once it is known.
    values: Vec<Option<Depth>>,
    /// Depth of each local variable.
    locals: Vec<u64>,
    /// Greatest depth that was stored through a pointer that the caller gave.
    handed_back: u64,
    result: Option<Depth>,
}

impl Walk<'_> {
    /// Depth of a function's result, and the greatest depth that it stored through its caller's
    /// pointers.
    fn function(&mut self, function: &Function, arguments: &[Depth]) -> (Depth, u64) {
        let mut frame = DepthFrame {
            function,
            arguments,
            values: vec![None; function.expressions.len()],
            locals: vec![0; function.local_variables.len()],
            handed_back: 0,
            result: None,
        };
        self.block(&function.body, &mut frame);
        (frame.result.unwrap_or(Depth::Whole(0)), frame.handed_back)
    }

    /// Walks statements in their order. WGSL allows blocks within blocks at most 127 deep.
    fn block(&mut self, block: &Block, frame: &mut DepthFrame<'_>) {
        for statement in block {
            match statement {
                Statement::Emit(range) => range.clone().for_each(|handle| self.emit(handle, frame)),
                Statement::Block(inner) => self.block(inner, frame),
                Statement::If { accept, reject, .. } => {
                    self.block(accept, frame);
                    self.block(reject, frame);
                }
                Statement::Switch { cases, .. } => {
                    cases.iter().for_each(|case| self.block(&case.body, frame));
                }
                Statement::Loop { body, continuing, .. } => {
                    let before = frame.locals.clone();
                    self.block(body, frame);
                    self.block(continuing, frame);
                    if self.is_of_unknown_rounds(body, frame.function) {
                        // What is stored in the loop is no operation behind it, but a choice
                        // between rounds, at which recursion ends.
                        for (local, before) in frame.locals.iter_mut().zip(before) {
                            *local = if *local > before { 0 } else { *local };
                        }
                    }
                }
                Statement::Store { pointer, value } => {
                    let depth = self.value(*value, frame).most();
                    self.store(*pointer, depth, frame);
                }
                Statement::Call { function, arguments, result } => {
                    self.call(*function, arguments, *result, frame);
                }
                Statement::Return { value: Some(value) } => {
                    let depth = self.value(*value, frame);
                    frame.result = Some(match frame.result.take() {
                        None => depth,
                        Some(other) => Depth::Whole(other.most().max(depth.most())),
                    });
                }
                _ => {}
            }
        }
    }

    /// True if a loop ends where a function says so that takes nothing and reads what the host
    /// gives: no driver can know the number of its rounds, and unroll it.
    fn is_of_unknown_rounds(&self, body: &Block, function: &Function) -> bool {
        let reads_host = |callee: Handle<Function>| {
            let callee = &self.module.functions[callee];
            callee.arguments.is_empty()
                && callee
                    .expressions
                    .iter()
                    .any(|(_, expression)| matches!(expression, Expression::GlobalVariable(_)))
        };
        let is_unknown = |condition: Handle<Expression>| {
            let mut open = vec![condition];
            while let Some(at) = open.pop() {
                match &function.expressions[at] {
                    Expression::CallResult(callee) if reads_host(*callee) => return true,
                    expression => open.extend(operands(expression)),
                }
            }
            false
        };
        let breaks = |block: &Block| block.iter().any(|inner| matches!(inner, Statement::Break));
        body.iter().any(|statement| match statement {
            Statement::If { condition, accept, reject } => {
                (breaks(accept) || breaks(reject)) && is_unknown(*condition)
            }
            _ => false,
        })
    }

    fn call(
        &mut self,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
        frame: &mut DepthFrame<'_>,
    ) {
        let depths: Vec<Depth> =
            arguments.iter().map(|&argument| self.value(argument, frame)).collect();
        let (depth, handed_back) = if self.calls < MAX_CALL_DEPTH {
            self.calls += 1;
            let found = self.function(&self.module.functions[function], &depths);
            self.calls -= 1;
            found
        } else {
            (Depth::Whole(depths.iter().map(Depth::most).max().unwrap_or_default()), 0)
        };
        if handed_back > 0 {
            arguments.iter().for_each(|&argument| self.store(argument, handed_back, frame));
        }
        if let Some(result) = result {
            frame.values[result.index()] = Some(depth);
        }
    }

    /// Notes the depth of a value stored through a pointer; nothing, where an expression is no
    /// pointer.
    fn store(&mut self, pointer: Handle<Expression>, depth: u64, frame: &mut DepthFrame<'_>) {
        self.deepest = self.deepest.max(depth);
        match frame.function.expressions[base_of(frame.function, pointer)] {
            Expression::LocalVariable(local) => {
                let known = &mut frame.locals[local.index()];
                *known = depth.max(*known);
            }
            Expression::GlobalVariable(_) => self.private = self.private.max(depth),
            Expression::FunctionArgument(_) => frame.handed_back = frame.handed_back.max(depth),
            _ => {}
        }
    }

    fn emit(&mut self, handle: Handle<Expression>, frame: &mut DepthFrame<'_>) {
        let depth = match &frame.function.expressions[handle] {
            Expression::Compose { components, .. } => components
                .iter()
                .map(|&component| self.value(component, frame).most())
                .collect::<Vec<_>>()
                .into(),
            Expression::AccessIndex { base, index } => {
                Depth::Whole(self.value(*base, frame).member(*index))
            }
            expression => {
                let below =
                    operands(expression).map(|operand| self.value(operand, frame).most()).max();
                Depth::Whole(below.unwrap_or_default() + own_depth(expression))
            }
        };
        self.deepest = self.deepest.max(depth.most());
        frame.values[handle.index()] = Some(depth);
    }

    fn value(&self, handle: Handle<Expression>, frame: &DepthFrame<'_>) -> Depth {
        if let Some(known) = &frame.values[handle.index()] {
            return known.clone();
        }
        match frame.function.expressions[handle] {
            Expression::FunctionArgument(index) => {
                frame.arguments.get(index as usize).cloned().unwrap_or(Depth::Whole(0))
            }
            Expression::LocalVariable(local) => Depth::Whole(frame.locals[local.index()]),
            Expression::GlobalVariable(_) => Depth::Whole(self.private),
            _ => Depth::Whole(0),
        }
    }
}

impl From<Vec<u64>> for Depth {
    fn from(members: Vec<u64>) -> Self {
        Self::Members(members.into())
    }
}

/// Variable or argument that a pointer leads into.
fn base_of(function: &Function, pointer: Handle<Expression>) -> Handle<Expression> {
    let mut at = pointer;
    while let Expression::Access { base, .. } | Expression::AccessIndex { base, .. } =
        function.expressions[at]
    {
        at = base;
    }
    at
}

/// Operands that an expression is computed from.
fn operands(expression: &Expression) -> impl Iterator<Item = Handle<Expression>> {
    let found = match *expression {
        Expression::Access { base, index } => [Some(base), Some(index), None, None],
        Expression::Splat { value, .. } | Expression::Swizzle { vector: value, .. } => {
            [Some(value), None, None, None]
        }
        Expression::Load { pointer } => [Some(pointer), None, None, None],
        Expression::ImageSample { coordinate, array_index, .. }
        | Expression::ImageLoad { coordinate, array_index, .. } => {
            [Some(coordinate), array_index, None, None]
        }
        Expression::Unary { expr, .. }
        | Expression::Derivative { expr, .. }
        | Expression::As { expr, .. } => [Some(expr), None, None, None],
        Expression::Binary { left, right, .. } => [Some(left), Some(right), None, None],
        Expression::Select { condition, accept, reject } => {
            [Some(condition), Some(accept), Some(reject), None]
        }
        Expression::Relational { argument, .. } => [Some(argument), None, None, None],
        Expression::Math { arg, arg1, arg2, arg3, .. } => [Some(arg), arg1, arg2, arg3],
        _ => [None; 4],
    };
    found.into_iter().flatten()
}

/// Own depth of an expression, in instructions of a driver.
fn own_depth(expression: &Expression) -> u64 {
    match expression {
        Expression::Binary { op: BinaryOperator::Modulo, .. } => 4,
        Expression::Binary { .. }
        | Expression::Unary { .. }
        | Expression::Select { .. }
        | Expression::Derivative { .. }
        | Expression::Relational { .. }
        | Expression::As { .. }
        | Expression::ImageSample { .. }
        | Expression::ImageLoad { .. } => 1,
        Expression::Math { fun, .. } => match fun {
            // Inverse trigonometric functions are polynomials in the driver.
            MathFunction::Asin | MathFunction::Acos | MathFunction::Atan | MathFunction::Atan2 => {
                24
            }
            MathFunction::Inverse | MathFunction::Determinant => 12,
            MathFunction::Asinh
            | MathFunction::Acosh
            | MathFunction::Atanh
            | MathFunction::Sinh
            | MathFunction::Cosh
            | MathFunction::Tanh
            | MathFunction::Tan => 8,
            MathFunction::SmoothStep | MathFunction::Normalize | MathFunction::Refract => 6,
            MathFunction::Clamp | MathFunction::Saturate => 2,
            MathFunction::Abs
            | MathFunction::Sign
            | MathFunction::Step
            | MathFunction::Fma
            | MathFunction::Min
            | MathFunction::Max
            | MathFunction::Floor
            | MathFunction::Ceil
            | MathFunction::Round
            | MathFunction::Trunc
            | MathFunction::Fract
            | MathFunction::Sin
            | MathFunction::Cos
            | MathFunction::Exp2
            | MathFunction::Log2
            | MathFunction::Sqrt
            | MathFunction::InverseSqrt => 1,
            _ => 3,
        },
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depth(functions: &str, body: &str) -> u64 {
        let source = format!(
            "{functions}\n@fragment fn main(@location(0) x: f32) -> @location(0) vec4f {{ {body} }}"
        );
        depth_of_entry_points(&crate::wgsl::parse(&source).unwrap().module)
    }

    #[test]
    fn calls_variables_and_pointers_are_followed() {
        let step = "fn step_on(y: f32) -> f32 { return y * 2.0 + 1.0; }";
        assert_eq!(depth("", "return vec4f(x * x * x + (x + x));"), 3);
        assert_eq!(
            depth(step, "let a = step_on(x); let b = step_on(a); return vec4f(step_on(b));"),
            6
        );
        assert_eq!(depth(step, "var y = x; y = step_on(y); y = step_on(y); return vec4f(y);"), 4);
        let into = "fn into(p: ptr<function, f32>) { *p = *p * 2.0; }";
        assert_eq!(depth(into, "var y = x * x; into(&y); into(&y); return vec4f(y);"), 3);
        let private = "var<private> p: f32; fn next() { p = p * 2.0; }";
        assert_eq!(depth(private, "p = x; next(); next(); next(); return vec4f(p);"), 3);
    }

    #[test]
    fn loops_of_unknown_rounds_end_a_chain() {
        let step = "fn step_on(y: f32) -> f32 { return y * 2.0 + 1.0; }
            @group(0) @binding(0) var<uniform> host: vec4f;
            fn turns() -> u32 { return select(1u, 2u, host.x > 1.0); }
            fn known() -> u32 { return 1u; }";
        let looped = |rounds: &str| {
            let body = format!(
                "let a = step_on(step_on(x)); var b: f32;
                for (var i = 0u; i < {rounds}; i++) {{ b = step_on(step_on(step_on(a))); }}
                return vec4f(step_on(b));"
            );
            depth(step, &body)
        };
        assert_eq!(looped("turns()"), 10);
        assert_eq!(looped("known()"), 12);
        assert_eq!(looped("1u"), 12);
    }

    #[test]
    fn members_have_depths_of_their_own() {
        let pair = "struct Pair { a: f32, b: f32 }
            fn pair(a: f32, b: f32) -> Pair { return Pair(a * 2.0, b * b * b * b * b); }";
        assert_eq!(
            depth(pair, "let p = pair(x, x); let q = pair(p.a, x); return vec4f(q.a * q.a);"),
            4
        );
    }

    #[test]
    fn what_doubles_is_not_walked() {
        let twice = |i: usize| {
            format!("fn g{}(x: f32) -> f32 {{ return g{i}(x) + g{i}(x + 1.0); }}\n", i + 1)
        };
        let doubling: String = (0..70).map(twice).collect();
        let functions = format!("fn g0(x: f32) -> f32 {{ return sin(x); }}\n{doubling}");
        assert!(depth(&functions, "return vec4f(g70(x));") > MAX_WALKED);
    }
}
