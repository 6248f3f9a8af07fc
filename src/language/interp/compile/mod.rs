//! Compiler from naga IR to instructions.
//!
//! Every function that the entry function reaches is compiled once, callees first. Nothing here
//! recurses: blocks, constants and the call graph are walked with explicit stacks, so that no
//! module is too deep.

mod access;
mod arithmetic;
mod assembler;
mod builtins;
mod constants;
mod expressions;
mod globals;
mod images;
mod layout;
mod linear;
mod literals;
mod operators;
mod ports;
mod purity;
mod statements;
mod unsupported;

use chiaro_locale::tr;
pub use literals::Literals;

use naga::front::Typifier;
use naga::proc::ResolveContext;
use naga::{Block, Expression, Function, Handle, Module, Statement};

use super::instruction::{Instruction, JumpTarget, Slot};
use super::{FunctionOptions, Program, ProgramParameter, Shape};
use crate::diag::Diagnostic;
use assembler::Assembler;
use globals::Globals;
use layout::Layouts;
use purity::Purity;
use statements::FunctionCompiler;

/// Result whose error is boxed, because it is moved through many hands.
type Outcome<T> = Result<T, Box<Diagnostic>>;

/// Frame of a function: the start of its code, and the places of its arguments, result and return
/// address.
struct FunctionFrame {
    entry: JumpTarget,
    link: Slot,
    /// First slot of each argument.
    arguments: Vec<Slot>,
    result: Slot,
    /// Number of slots of the result.
    result_slots: u32,
    /// All slots of the arguments, if lanes can share a run.
    shared: Option<Vec<Slot>>,
}

/// Context of the compilation of all functions of a program.
struct CompileContext<'a> {
    module: &'a Module,
    layouts: &'a Layouts,
    options: FunctionOptions<'a>,
    globals: &'a Globals,
    /// Frames of all functions of the module that have been compiled.
    frames: &'a [Option<FunctionFrame>],
}

/// Compiles the function of that name; see [`Program::compile`].
pub(super) fn compile(
    module: &Module,
    name: &str,
    options: FunctionOptions<'_>,
) -> Outcome<Program> {
    let function = find(module, name)?;
    let layouts = Layouts::of(module);
    let (parameters, result) = signature(module, &layouts, name, function, options)?;
    let mut assembler = Assembler::new();
    let callees = reachable(module, function);
    let globals = if options.is_stage {
        let functions = callees.iter().map(|&callee| &module.functions[callee]);
        Globals::of(module, &layouts, &mut assembler, functions.chain([function]))?
    } else {
        Globals::default()
    };
    let mut purity = Purity::new(module);
    let mut frames: Vec<Option<FunctionFrame>> = Vec::new();
    frames.resize_with(module.functions.len(), || None);
    for callee in callees {
        let context = CompileContext {
            module,
            layouts: &layouts,
            options,
            globals: &globals,
            frames: &frames,
        };
        let begin = assembler.length();
        let function = &module.functions[callee];
        let mut frame = compile_function(&context, &mut assembler, function, false)?;
        purity.add(&context, callee, function, assembler.length() - begin);
        if !purity.is_worth_sharing(callee) {
            frame.shared = None;
        }
        frames[callee.index()] = Some(frame);
    }
    let context =
        CompileContext { module, layouts: &layouts, options, globals: &globals, frames: &frames };
    let frame = compile_function(&context, &mut assembler, function, true)?;
    let parameters: Vec<ProgramParameter> = parameters
        .into_iter()
        .zip(&frame.arguments)
        .map(|((name, shape), &slot)| ProgramParameter { name, shape, slot })
        .collect();
    let linked = assembler.link(frame.entry);
    Ok(Program {
        name: name.to_owned(),
        code: linked.code,
        switches: linked.switches,
        pure_calls: linked.pure_calls,
        image: linked.image,
        wide_constants: linked.wide_constants,
        bound_slots: linked.bound_slots,
        operations: linked.operations,
        resources: globals.resources,
        observed: linked.observed,
        entry: linked.entry,
        inputs: ports::inputs(module, function, &parameters),
        outputs: ports::outputs(module, function, &result, frame.result),
        parameters,
        result,
        result_slot: frame.result,
        step_limit: options.step_limit,
    })
}

/// Function or entry point of that name.
fn find<'m>(module: &'m Module, name: &str) -> Outcome<&'m Function> {
    let functions = module.functions.iter().map(|(_, f)| (f.name.as_deref().unwrap_or(""), f));
    let entry_points = module.entry_points.iter().map(|e| (e.name.as_str(), &e.function));
    let known: Vec<(&str, &Function)> = functions.chain(entry_points).collect();
    known.iter().find(|(known, _)| *known == name).map(|(_, function)| *function).ok_or_else(|| {
        let error =
            Diagnostic::error("interp-unknown-function", tr!("there is no function `{name}`"));
        Box::new(error.suggest(name, known.iter().map(|(known, _)| *known)))
    })
}

/// Names and shapes of the arguments, and the shape of the result.
fn signature(
    module: &Module,
    layouts: &Layouts,
    name: &str,
    function: &Function,
    options: FunctionOptions<'_>,
) -> Outcome<(Vec<(String, Shape)>, Shape)> {
    let shape = |ty, what: &str| {
        layouts
            .shape(module, ty)
            .map_err(|problem| Box::new(problem.diagnose(&tr!("{what} of `{name}`"))))
    };
    let mut parameters = Vec::new();
    for argument in &function.arguments {
        let argument_name = argument.name.clone().unwrap_or_default();
        let shape = shape(argument.ty, &tr!("argument `{argument_name}`"))?;
        parameters.push((argument_name, shape));
    }
    let Some(result) = &function.result else {
        if options.is_stage {
            return Ok((parameters, Shape::Struct { name: String::new(), members: Vec::new() }));
        }
        let message = tr!("`{name}` returns nothing, so there is nothing to run it for");
        return Err(Box::new(Diagnostic::error("interp-unsupported", message)));
    };
    Ok((parameters, shape(result.ty, tr!("the result"))?))
}

/// Functions that `entry` calls, directly or through others, callees before callers.
fn reachable(module: &Module, entry: &Function) -> Vec<Handle<Function>> {
    let mut found = vec![false; module.functions.len()];
    let mut pending = vec![entry];
    while let Some(function) = pending.pop() {
        for callee in calls(&function.body) {
            if !std::mem::replace(&mut found[callee.index()], true) {
                pending.push(&module.functions[callee]);
            }
        }
    }
    // naga's arena lists functions after those that they call.
    module
        .functions
        .iter()
        .map(|(handle, _)| handle)
        .filter(|handle| found[handle.index()])
        .collect()
}

/// Functions that are called anywhere in a block.
fn calls(body: &Block) -> Vec<Handle<Function>> {
    let mut callees = Vec::new();
    let mut blocks = vec![body];
    while let Some(block) = blocks.pop() {
        for statement in block {
            match statement {
                Statement::Call { function, .. } => callees.push(*function),
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
    callees
}

/// Appends the code of one function; the code of the entry begins with the values of private
/// variables.
fn compile_function(
    context: &CompileContext,
    assembler: &mut Assembler,
    function: &Function,
    is_entry: bool,
) -> Outcome<FunctionFrame> {
    let types = types(context.module, function)?;
    let frame = frame(context, assembler, function)?;
    assembler.place(frame.entry);
    let mut compiler = FunctionCompiler::new(context, assembler, function, &types, &frame)?;
    if is_entry {
        compiler.initialize_private()?;
    }
    compiler.body()?;
    // A function without result may end without `return`; in any other, control never gets here.
    assembler.emit(Instruction::Return { link: frame.link })?;
    Ok(frame)
}

/// Types of all expressions.
fn types(module: &Module, function: &Function) -> Outcome<Typifier> {
    let resolve =
        ResolveContext::with_locals(module, &function.local_variables, &function.arguments);
    let mut types = Typifier::new();
    if let Some((last, _)) = function.expressions.iter().last() {
        types.grow(last, &function.expressions, &resolve).map_err(|problem| {
            let name = function.name.as_deref().unwrap_or("");
            Box::new(Diagnostic::error(
                "interp-unsupported",
                tr!("the types of `{name}` are not known: {problem}"),
            ))
        })?;
    }
    Ok(types)
}

/// Reserves the slots that the callers of a function must know.
fn frame(
    context: &CompileContext,
    assembler: &mut Assembler,
    function: &Function,
) -> Outcome<FunctionFrame> {
    let name = function.name.as_deref().unwrap_or("");
    let slots = |ty, what: &str| {
        let inner = &context.module.types[ty].inner;
        context
            .layouts
            .slots(inner)
            .map_err(|problem| Box::new(problem.diagnose(&tr!("{what} of `{name}`"))))
    };
    let entry = assembler.label();
    let link = assembler.reserve(1)?;
    let (mut arguments, mut shared) = (Vec::new(), Vec::new());
    for argument in &function.arguments {
        let count = slots(
            argument.ty,
            &tr!("argument `{argument}`", argument = argument.name.as_deref().unwrap_or("")),
        )?;
        let first = assembler.reserve(count)?;
        arguments.push(first);
        shared.extend(first..first + count);
    }
    let result_slots =
        function.result.as_ref().map_or(Ok(0), |result| slots(result.ty, tr!("the result")))?;
    let result = assembler.reserve(result_slots)?;
    Ok(FunctionFrame { entry, link, arguments, result, result_slots, shared: Some(shared) })
}

/// True for an expression that is a constant value, wherever it stands.
fn is_constant(expression: &Expression) -> bool {
    matches!(
        expression,
        Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::ZeroValue(_)
            | Expression::Compose { .. }
            | Expression::Splat { .. }
    )
}
