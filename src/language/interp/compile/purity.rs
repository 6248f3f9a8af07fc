//! Purity of functions: those that give the same result for the same arguments, and run long enough
//! to be worth comparing arguments.

use naga::{AddressSpace, Block, Expression, Function, Handle, Module, Statement, TypeInner};

use super::{CompileContext, calls};

/// Least number of instructions, callees included, for which arguments are compared; a shorter
/// function is run again.
const LEAST: usize = 48;

/// Properties of a compiled function.
#[derive(Clone, Copy, Default)]
struct FunctionFacts {
    is_pure: bool,
    has_loop: bool,
    /// Number of instructions, callees included.
    length: usize,
}

/// Properties of all functions; callees are added before callers.
pub(super) struct Purity(Vec<FunctionFacts>);

impl Purity {
    pub(super) fn new(module: &Module) -> Self {
        Self(vec![FunctionFacts::default(); module.functions.len()])
    }

    /// Adds a function of `length` instructions.
    pub(super) fn add(
        &mut self,
        context: &CompileContext,
        handle: Handle<Function>,
        function: &Function,
        length: usize,
    ) {
        let mut known = FunctionFacts {
            is_pure: is_pure(context.module, function),
            has_loop: has_loop(function),
            length,
        };
        for callee in calls(&function.body) {
            let callee = self.0[callee.index()];
            known.is_pure &= callee.is_pure;
            known.has_loop |= callee.has_loop;
            known.length = known.length.saturating_add(callee.length);
        }
        self.0[handle.index()] = known;
    }

    /// True for a function that is pure and takes long.
    pub(super) fn is_worth_sharing(&self, handle: Handle<Function>) -> bool {
        let FunctionFacts { is_pure, has_loop, length } = self.0[handle.index()];
        is_pure && (has_loop || length >= LEAST)
    }
}

/// True if a function's own result depends on its arguments, constants and buffers alone, and the
/// function has no other effect.
fn is_pure(module: &Module, function: &Function) -> bool {
    let is_pointer = |ty| {
        matches!(module.types[ty].inner, TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. })
    };
    let is_pure = |expression: &Expression| match expression {
        Expression::GlobalVariable(variable) => {
            let space = module.global_variables[*variable].space;
            matches!(space, AddressSpace::Uniform | AddressSpace::Storage { .. })
        }
        // A derivative depends on the neighbors, and so may a sample of a texture.
        Expression::Derivative { .. }
        | Expression::ImageSample { .. }
        | Expression::ImageLoad { .. } => false,
        _ => true,
    };
    !function.arguments.iter().any(|argument| is_pointer(argument.ty))
        && function.expressions.iter().all(|(_, expression)| is_pure(expression))
        && !any(&function.body, |statement| matches!(statement, Statement::Kill))
}

fn has_loop(function: &Function) -> bool {
    any(&function.body, |statement| matches!(statement, Statement::Loop { .. }))
}

/// True if a block has such a statement at any depth.
fn any(body: &Block, is_one: impl Fn(&Statement) -> bool) -> bool {
    let mut blocks = vec![body];
    while let Some(block) = blocks.pop() {
        for statement in block {
            if is_one(statement) {
                return true;
            }
            match statement {
                Statement::Block(inner) => blocks.push(inner),
                Statement::If { accept, reject, .. } => blocks.extend([accept, reject]),
                Statement::Loop { body, continuing, .. } => blocks.extend([body, continuing]),
                Statement::Switch { cases, .. } => {
                    blocks.extend(cases.iter().map(|case| &case.body));
                }
                _ => {}
            }
        }
    }
    false
}
