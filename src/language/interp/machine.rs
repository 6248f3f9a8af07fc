//! Machine that runs programs, one call at a time.

use chiaro_locale::{tr, trn};

use super::instruction::{Instruction, JumpTarget};
use super::math::{Double, Rounding, Single};
use super::memory::{ALL, Mask, Memory};
use super::resources::{BoundContent, BoundResources};
use super::step::step;
use super::{Precision, Program, ProgramParameter, Value};
use crate::diag::Diagnostic;

/// Memory in which one [`Program`] runs, one call after the other.
#[derive(Clone, Debug)]
pub struct Machine<'p> {
    program: &'p Program,
    precision: Precision,
    memory: Memory<1>,
    contents: &'p [BoundContent],
}

/// Error of a program that ran for longer than allowed.
pub(super) struct TimeLimitError;

impl TimeLimitError {
    #[cold]
    pub(super) fn diagnose(&self, program: &Program) -> Diagnostic {
        let Program { name, step_limit, .. } = program;
        Diagnostic::error("interp-endless", tr!("`{name}` did not end within {step_limit} steps"))
            .hint(tr!("look for a loop whose exit condition never becomes true"))
    }
}

impl<'p> Machine<'p> {
    pub(super) fn new(
        program: &'p Program,
        precision: Precision,
        contents: &'p [BoundContent],
    ) -> Self {
        let resources = BoundResources { contents, operations: &program.operations };
        Self { program, precision, memory: Memory::new(program, precision, &resources), contents }
    }

    /// Runs the program once. No state of an earlier call remains.
    ///
    /// # Errors
    /// As [`Program::call`].
    pub fn call(&mut self, arguments: &[Value]) -> Result<Value, Diagnostic> {
        let Program { name, parameters, result, result_slot, .. } = self.program;
        if self.contents.len() != self.program.resources.len() {
            let message = tr!("`{name}` reads resources, and none are bound");
            return Err(Diagnostic::error("interp-unbound", message)
                .hint(tr!("bind them, and run what `Program::bind` gives")));
        }
        write_arguments(name, parameters, arguments, self.precision, &self.memory, 0)?;
        let resources =
            BoundResources { contents: self.contents, operations: &self.program.operations };
        let (entry, steps) = (self.program.entry, &mut self.program.step_limit.clone());
        let outcome = match self.precision {
            Precision::F64 => run::<Double>(self.program, &self.memory, &resources, entry, steps),
            Precision::F32 => run::<Single>(self.program, &self.memory, &resources, entry, steps),
        };
        outcome.map_err(|endless| endless.diagnose(self.program))?;
        Ok(result.read(&mut (*result_slot..).map(|slot| self.memory.bits(slot, 0))))
    }
}

/// Writes the arguments of one lane to the slots where the program expects them.
pub(super) fn write_arguments<const W: usize>(
    function: &str,
    parameters: &[ProgramParameter],
    arguments: &[Value],
    precision: Precision,
    memory: &Memory<W>,
    lane: usize,
) -> Result<(), Diagnostic> {
    if arguments.len() != parameters.len() {
        let message = trn!(
            count = parameters.len(),
            "`{function}` takes {count} argument, but {given} were given",
            "`{function}` takes {count} arguments, but {given} were given",
            given = arguments.len()
        );
        return Err(Diagnostic::error("interp-argument", message));
    }
    for (parameter, value) in parameters.iter().zip(arguments) {
        let mut scalars = vec![0; parameter.shape.slots() as usize];
        if parameter.shape.write(value, precision, &mut scalars).is_none() {
            return Err(wrong_shape(function, parameter, value));
        }
        (parameter.slot..).zip(scalars).for_each(|(slot, bits)| memory.set(slot, lane, bits));
    }
    Ok(())
}

#[cold]
fn wrong_shape(function: &str, parameter: &ProgramParameter, value: &Value) -> Diagnostic {
    let ProgramParameter { name, shape, .. } = parameter;
    let message = tr!(
        "argument `{name}` of `{function}` is {shape}, but {value} ({given}) was given",
        given = value.describe()
    );
    Diagnostic::error("interp-argument", message)
}

/// Runs the function at `entry`, whose link is 0, until it returns, and subtracts the cost of its
/// instructions from `steps`.
pub(super) fn run<R: Rounding>(
    program: &Program,
    memory: &Memory<1>,
    resources: &BoundResources,
    entry: JumpTarget,
    steps: &mut u64,
) -> Result<(), TimeLimitError> {
    let code = program.code.as_slice();
    let mut counter = entry as usize;
    loop {
        let instruction = code[counter];
        counter += 1;
        *steps = steps.checked_sub(instruction.cost()).ok_or(TimeLimitError)?;
        match instruction {
            Instruction::Halt => return Ok(()),
            Instruction::Jump { target } => counter = target as usize,
            Instruction::JumpIf { condition, when, target } => {
                if (memory.bits(condition, 0) != 0) == when {
                    counter = target as usize;
                }
            }
            Instruction::Switch { selector, table } => {
                counter = program.switches[table as usize].target(memory.int(selector, 0)) as usize;
            }
            Instruction::Call { target, link } | Instruction::CallPure { target, link, .. } => {
                memory.set(link, 0, counter as u64);
                counter = target as usize;
            }
            Instruction::Return { link } => counter = memory.bits(link, 0) as usize,
            // The only lane has no neighbors to help.
            Instruction::Kill => {}
            _ => step::<R, 1>(instruction, memory, Mask { lanes: ALL, is_full: true }, resources),
        }
    }
}
