//! Statements: control flow, stores and calls.

use chiaro_locale::tr;
use naga::front::Typifier;
use naga::proc::TypeResolution;
use naga::{
    Block, Expression, Function, Handle, Span, Statement, SwitchCase, SwitchValue, TypeInner,
};

use super::assembler::Assembler;
use super::expressions::{MemoryPlace, Operand};
use super::layout::scalar_kind;
use super::unsupported::statement_name;
use super::{CompileContext, FunctionFrame, Outcome};
use crate::diag::Diagnostic;
use crate::interp::ObservedValue;
use crate::interp::instruction::{Instruction, JumpTarget, PureCall, Slot, Switch};
use crate::interp::observed::kinds;

/// Compiler of one function.
pub(super) struct FunctionCompiler<'a> {
    pub(super) context: &'a CompileContext<'a>,
    pub(super) assembler: &'a mut Assembler,
    pub(super) function: &'a Function,
    pub(super) types: &'a Typifier,
    pub(super) frame: &'a FunctionFrame,
    /// Compiled forms of the expressions.
    pub(super) operands: Vec<Option<Operand>>,
    /// First slot of each local variable.
    pub(super) locals: Vec<Slot>,
    /// Work that is left, last first.
    tasks: Vec<Task<'a>>,
    /// Targets of `break` and `continue`, innermost last.
    exits: Vec<Exit>,
}

/// Task: a piece of work that waits until the code before it has been compiled.
enum Task<'a> {
    /// Statements of a block from an index on.
    Block(&'a Block, usize),
    /// Placing of this label before the next instruction.
    Label(JumpTarget),
    /// Jump to the label.
    Jump(JumpTarget),
    /// Jump to the label if the condition is false.
    JumpUnless(Handle<Expression>, JumpTarget),
    /// End of a loop or switch.
    Leave,
}

#[derive(Clone, Copy)]
struct Exit {
    on_break: JumpTarget,
    /// Target of `continue`; `None` outside of any loop.
    on_continue: Option<JumpTarget>,
}

impl<'a> FunctionCompiler<'a> {
    pub(super) fn new(
        context: &'a CompileContext<'a>,
        assembler: &'a mut Assembler,
        function: &'a Function,
        types: &'a Typifier,
        frame: &'a FunctionFrame,
    ) -> Outcome<Self> {
        let mut compiler = Self {
            context,
            assembler,
            function,
            types,
            frame,
            operands: Vec::new(),
            locals: Vec::new(),
            tasks: Vec::new(),
            exits: Vec::new(),
        };
        compiler.operands.resize_with(function.expressions.len(), || None);
        for (handle, local) in function.local_variables.iter() {
            let inner = &context.module.types[local.ty].inner;
            let count = compiler.slots_of(inner, function.local_variables.get_span(handle))?;
            let first = compiler.assembler.reserve(count)?;
            compiler.locals.push(first);
        }
        compiler.define_names()?;
        Ok(compiler)
    }

    /// Defines the places of arguments and locals.
    fn define_names(&mut self) -> Outcome<()> {
        for (handle, expression) in self.function.expressions.iter() {
            let operand = match *expression {
                Expression::FunctionArgument(index) => self.argument(index, handle)?,
                Expression::LocalVariable(local) => {
                    Operand::Place(MemoryPlace::fixed(self.locals[local.index()]))
                }
                _ => continue,
            };
            self.operands[handle.index()] = Some(operand);
        }
        Ok(())
    }

    /// Compiles the body of the function.
    pub(super) fn body(mut self) -> Outcome<()> {
        for (handle, local) in self.function.local_variables.iter() {
            let to = self.locals[handle.index()];
            if let Some(init) = local.init {
                let from = self.value(init)?;
                self.copy(to, &from)?;
            } else {
                let inner = &self.context.module.types[local.ty].inner;
                let count = self.slots_of(inner, self.function.local_variables.get_span(handle))?;
                self.assembler.emit(Instruction::Clear { to, count })?;
            }
        }
        self.tasks.push(Task::Block(&self.function.body, 0));
        while let Some(task) = self.tasks.pop() {
            match task {
                Task::Block(block, index) => {
                    if let Some(statement) = block.get(index) {
                        self.tasks.push(Task::Block(block, index + 1));
                        self.statement(statement)
                            .map_err(|error| locate_statement(error, block, index))?;
                    }
                }
                Task::Label(label) => self.assembler.place(label),
                Task::Jump(target) => self.assembler.emit(Instruction::Jump { target })?,
                Task::JumpUnless(condition, target) => self.jump_if(condition, false, target)?,
                Task::Leave => {
                    self.exits.pop();
                }
            }
        }
        if self.context.options.observe {
            self.observe();
        }
        Ok(())
    }

    /// Notes the slots of the values that the source names.
    fn observe(&mut self) {
        for (&handle, name) in &self.function.named_expressions {
            let Some(Operand::Value(slots)) = &self.operands[handle.index()] else { continue };
            let mut found = Vec::new();
            match &self.types[handle] {
                TypeResolution::Handle(ty) => {
                    if let Ok(shape) = self.context.layouts.shape(self.context.module, *ty) {
                        kinds(&shape, &mut found);
                    }
                }
                TypeResolution::Value(inner) => {
                    let kind = inner.scalar().and_then(|scalar| scalar_kind(scalar).ok());
                    found.extend(
                        kind.into_iter().flat_map(|kind| std::iter::repeat_n(kind, slots.len())),
                    );
                }
            }
            self.assembler.observed.push(ObservedValue {
                name: name.clone(),
                function: self.function.name.clone().unwrap_or_default(),
                span: self.function.expressions.get_span(handle).to_range().unwrap_or_default(),
                slots: slots.iter().copied().zip(found).collect(),
            });
        }
    }

    /// Queues tasks; the first is done first.
    fn queue<const N: usize>(&mut self, tasks: [Task<'a>; N]) {
        self.tasks.extend(tasks.into_iter().rev());
    }

    fn statement(&mut self, statement: &'a Statement) -> Outcome<()> {
        match statement {
            Statement::Emit(range) => range.clone().try_for_each(|handle| self.expression(handle)),
            Statement::Block(block) => {
                self.queue([Task::Block(block, 0)]);
                Ok(())
            }
            Statement::If { condition, accept, reject } => self.branch(*condition, accept, reject),
            Statement::Switch { selector, cases } => self.switch(*selector, cases),
            Statement::Loop { body, continuing, break_if } => {
                self.repeat(body, continuing, *break_if)
            }
            Statement::Break => match self.exits.last() {
                Some(exit) => self.assembler.emit(Instruction::Jump { target: exit.on_break }),
                None => {
                    Err(self.unsupported(tr!("`break` outside of a loop (Break)"), Span::UNDEFINED))
                }
            },
            Statement::Continue => match self.exits.last().and_then(|exit| exit.on_continue) {
                Some(target) => self.assembler.emit(Instruction::Jump { target }),
                None => Err(self
                    .unsupported(tr!("`continue` outside of a loop (Continue)"), Span::UNDEFINED)),
            },
            Statement::Return { value } => {
                if let Some(value) = value {
                    let from = self.value(*value)?;
                    self.copy(self.frame.result, &from)?;
                }
                self.assembler.emit(Instruction::Return { link: self.frame.link })
            }
            Statement::Store { pointer, value } => {
                let place = self.place(*pointer)?;
                let from = self.value(*value)?;
                self.store(place, &from)
            }
            Statement::Call { function, arguments, result } => {
                self.call(*function, arguments, *result)
            }
            Statement::Kill if self.context.options.is_stage => {
                self.assembler.emit(Instruction::Kill)
            }
            other => Err(self.unsupported(statement_name(other), Span::UNDEFINED)),
        }
    }

    fn jump_if(
        &mut self,
        condition: Handle<Expression>,
        when: bool,
        target: JumpTarget,
    ) -> Outcome<()> {
        let condition = self.scalar(condition)?;
        self.assembler.emit(Instruction::JumpIf { condition, when, target })
    }

    fn branch(
        &mut self,
        condition: Handle<Expression>,
        accept: &'a Block,
        reject: &'a Block,
    ) -> Outcome<()> {
        let end = self.assembler.label();
        if reject.is_empty() {
            self.jump_if(condition, false, end)?;
            self.queue([Task::Block(accept, 0), Task::Label(end)]);
        } else if accept.is_empty() {
            // naga turns a loop's condition into `if !condition { break; }`.
            self.jump_if(condition, true, end)?;
            self.queue([Task::Block(reject, 0), Task::Label(end)]);
        } else {
            let otherwise = self.assembler.label();
            self.jump_if(condition, false, otherwise)?;
            self.queue([
                Task::Block(accept, 0),
                Task::Jump(end),
                Task::Label(otherwise),
                Task::Block(reject, 0),
                Task::Label(end),
            ]);
        }
        Ok(())
    }

    fn repeat(
        &mut self,
        body: &'a Block,
        continuing: &'a Block,
        break_if: Option<Handle<Expression>>,
    ) -> Outcome<()> {
        let [start, next, end] = [(); 3].map(|()| self.assembler.label());
        self.assembler.place(start);
        self.exits.push(Exit { on_break: end, on_continue: Some(next) });
        self.queue([Task::Label(end), Task::Leave]);
        self.queue([match break_if {
            Some(condition) => Task::JumpUnless(condition, start),
            None => Task::Jump(start),
        }]);
        self.queue([Task::Block(body, 0), Task::Label(next), Task::Block(continuing, 0)]);
        Ok(())
    }

    fn switch(&mut self, selector: Handle<Expression>, cases: &'a [SwitchCase]) -> Outcome<()> {
        let selector = self.scalar(selector)?;
        let end = self.assembler.label();
        let on_continue = self.exits.last().and_then(|exit| exit.on_continue);
        self.exits.push(Exit { on_break: end, on_continue });
        let mut switch = Switch { cases: Vec::new(), default: end };
        let mut tasks = Vec::new();
        for case in cases {
            let label = self.assembler.label();
            match case.value {
                SwitchValue::I32(value) => switch.cases.push((value as u32, label)),
                SwitchValue::U32(value) => switch.cases.push((value, label)),
                SwitchValue::Default => switch.default = label,
            }
            tasks.extend([Task::Label(label), Task::Block(&case.body, 0)]);
            if !case.fall_through {
                tasks.push(Task::Jump(end));
            }
        }
        tasks.extend([Task::Label(end), Task::Leave]);
        let table = self.assembler.switch(switch);
        self.assembler.emit(Instruction::Switch { selector, table })?;
        self.tasks.extend(tasks.into_iter().rev());
        Ok(())
    }

    fn call(
        &mut self,
        callee: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
    ) -> Outcome<()> {
        let Some(frame) = &self.context.frames[callee.index()] else {
            return Err(self.unsupported(
                tr!("a function that has not ended yet (recursion)"),
                Span::UNDEFINED,
            ));
        };
        for (&argument, &to) in arguments.iter().zip(&frame.arguments) {
            match self.operand(argument)? {
                Operand::Value(slots) => self.copy(to, &slots)?,
                Operand::Place(place) => {
                    let pointer = self.pointer(place)?;
                    self.assembler.emit(Instruction::Copy { to, from: pointer })?;
                }
            }
        }
        let (target, link) = (frame.entry, frame.link);
        let instruction = match &frame.shared {
            // A remembered call leaves no values to observe.
            Some(arguments) if !self.context.options.observe => {
                let FunctionFrame { result, result_slots, .. } = *frame;
                let call = PureCall { arguments: arguments.clone(), result, result_slots };
                Instruction::CallPure { target, link, call: self.assembler.pure_call(call) }
            }
            _ => Instruction::Call { target, link },
        };
        self.assembler.emit(instruction)?;
        let Some(result) = result else { return Ok(()) };
        // The next call of the same function overwrites its result.
        let to = self.assembler.reserve(frame.result_slots)?;
        let slots: Vec<Slot> = (to..to + frame.result_slots).collect();
        let from: Vec<Slot> = (frame.result..frame.result + frame.result_slots).collect();
        self.copy(to, &from)?;
        self.define(result, slots)
    }

    /// Copies slots to neighboring slots.
    pub(super) fn copy(&mut self, to: Slot, from: &[Slot]) -> Outcome<()> {
        let mut to = to;
        for run in from.chunk_by(|a, b| *b == *a + 1) {
            let count = run.len() as u32;
            // A few copies are faster than a call that moves memory.
            if count > 4 {
                self.assembler.emit(Instruction::CopyRun { to, from: run[0], count })?;
            } else {
                for (to, &from) in (to..).zip(run) {
                    self.assembler.emit(Instruction::Copy { to, from })?;
                }
            }
            to += count;
        }
        Ok(())
    }

    /// Initializes private variables.
    pub(super) fn initialize_private(&mut self) -> Outcome<()> {
        let module = self.context.module;
        for &(handle, to) in &self.context.globals.private {
            let variable = &module.global_variables[handle];
            if let Some(init) = variable.init {
                let from = self.global_constant(init)?;
                self.copy(to, &from)?;
            } else {
                let count = self.slots_of(
                    &module.types[variable.ty].inner,
                    module.global_variables.get_span(handle),
                )?;
                self.assembler.emit(Instruction::Clear { to, count })?;
            }
        }
        Ok(())
    }

    fn store(&mut self, place: MemoryPlace, from: &[Slot]) -> Outcome<()> {
        if place.buffer.is_some() {
            return Err(self.unsupported(tr!("a store to a buffer (Store)"), Span::UNDEFINED));
        }
        let Some(pointer) = place.pointer else { return self.copy(place.offset, from) };
        for (offset, &from) in (place.offset..).zip(from) {
            self.assembler.emit(Instruction::Store { pointer, offset, from })?;
        }
        Ok(())
    }

    /// Number of slots of a type.
    pub(super) fn slots_of(&self, inner: &TypeInner, span: Span) -> Outcome<u32> {
        self.context
            .layouts
            .slots(inner)
            .map_err(|problem| self.locate(problem.diagnose(&self.subject()), span))
    }

    /// Name of the value that has a type, for errors about types.
    pub(super) fn subject(&self) -> String {
        tr!("a value in `{function}`", function = self.name())
    }

    fn name(&self) -> &str {
        self.function.name.as_deref().unwrap_or("")
    }

    /// Error of a function that uses a feature which the interpreter cannot run.
    #[cold]
    pub(super) fn unsupported(&self, what: &str, span: Span) -> Box<Diagnostic> {
        let message = tr!(
            "`{function}` uses {what}, which the interpreter cannot run",
            function = self.name()
        );
        self.locate(Diagnostic::error("interp-unsupported", message), span)
    }

    /// Adds the span in the source.
    #[cold]
    pub(super) fn locate(&self, mut diagnostic: Diagnostic, span: Span) -> Box<Diagnostic> {
        diagnostic.place.wgsl = span.to_range();
        Box::new(diagnostic)
    }
}

/// Adds the span of a statement to an error that has none yet.
#[cold]
fn locate_statement(mut error: Box<Diagnostic>, block: &Block, index: usize) -> Box<Diagnostic> {
    if error.place.wgsl.is_none() {
        error.place.wgsl = block.span_iter().nth(index).and_then(|(_, span)| span.to_range());
    }
    error
}
