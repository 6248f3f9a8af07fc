//! Lanes: programs run for many lanes in lockstep.
//!
//! Every instruction is executed for all lanes before the next one, so that the cost of choosing it
//! is shared, and the inner loops are plain ones over rows of floats. While all lanes stand at the
//! same instruction nothing is masked. Where they part, [`groups`] lets the hindmost move until
//! they meet again.
//!
//! The meaning of the instructions is that of [`step`](super::step), which the scalar machine
//! shares: the code is the same at a width of one. Only instructions that move the counter are
//! written twice, because one lane never parts.

mod groups;
mod shared;

use super::instruction::Instruction;
use super::machine::{TimeLimitError, write_arguments};
use super::math::{Double, Rounding, Single};
use super::memory::{Mask, Memory};
use super::resources::{BoundProgram, BoundResources};
use super::step::step;
use super::{LanePort, Precision, Program, Value};
use crate::diag::Diagnostic;
use chiaro_locale::tr;
use groups::{LaneGroup, LaneGroups};
use shared::SharedCalls;

/// Number of lanes that run at once: 16 quads. In a quad lane 0 is at (0, 0), 1 at (1, 0), 2 at (0,
/// 1), 3 at (1, 1); y points down.
pub const LANES: usize = 64;

/// Greatest number of slots that lanes may have: 512 MiB.
const MAX_SLOTS: usize = 1 << 20;

/// Memory in which a program runs for [`LANES`] lanes at once, one batch after the other.
///
/// ```
/// use chiaro_language::interp::{
///     Bindings, FunctionOptions, LANES, Literals, Precision, Program,
/// };
///
/// let source = "
///     @group(0) @binding(0) var<uniform> tint: vec4f;
///     @fragment fn shade(@location(0) x: f32) -> @location(0) vec4f {
///         return tint * dpdx(x * x);
///     }";
/// let module = chiaro_language::wgsl::parse(source).expect("valid WGSL").module;
/// let literals = Literals::of(source);
/// let program = Program::compile(&module, "shade", FunctionOptions::stage(&literals))?;
/// let mut bindings = Bindings::new();
/// bindings.buffer(0, 0, [0.5, 0.25, 1.0, 1.0].into());
/// let bound = program.bind(&bindings, Precision::F64).map_err(|mut problems| problems.remove(0))?;
/// // For each thread:
/// let mut lanes = bound.lanes()?;
/// // For each batch of 16 quads; here all alike.
/// let x: [f64; LANES] = std::array::from_fn(|lane| if lane % 2 == 0 { 3.0 } else { 4.0 });
/// lanes.write(&program.inputs()[0], 0, &x);
/// let batch = lanes.run(LANES)?;
/// let mut red = [0.0; LANES];
/// lanes.read(&program.outputs()[0], 0, &mut red);
/// assert_eq!((red, batch.discarded), ([3.5; LANES], 0));
/// # Ok::<(), chiaro_language::diag::Diagnostic>(())
/// ```
#[derive(Clone, Debug)]
pub struct Lanes<'b> {
    bound: &'b BoundProgram<'b>,
    pub(super) memory: Memory<LANES>,
    shared: SharedCalls,
}

/// Result of a batch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Batch {
    /// A bit for each lane that met `discard`. The result of such a lane means nothing.
    pub discarded: u64,
    /// Number of instructions executed, each for all lanes; or for one, where all would have done
    /// the same.
    pub steps: u64,
}

impl<'b> Lanes<'b> {
    pub(super) fn new(bound: &'b BoundProgram<'b>) -> Result<Self, Diagnostic> {
        let program = bound.program();
        if program.image.len() > MAX_SLOTS {
            let message = tr!(
                "`{function}` needs {slots} scalars for each lane, more than the {MAX_SLOTS} that \
                 the interpreter grants",
                function = program.name(),
                slots = program.image.len()
            );
            return Err(Diagnostic::error("interp-too-big", message)
                .hint(tr!("use smaller arrays or fewer of them")));
        }
        let (precision, resources) = (bound.precision(), bound.resources());
        let shared = SharedCalls::new(program, precision, &resources);
        Ok(Self { bound, memory: Memory::new(program, precision, &resources), shared })
    }

    /// Sets one component of an input in the lanes `0..values.len()`. Integers are truncated, bools
    /// are true unless 0.
    ///
    /// # Panics
    /// There are more values than lanes, or the port has not that component.
    pub fn write(&mut self, input: &LanePort, component: usize, values: &[f64]) {
        let row = self.memory.row(input.slot_of(component));
        for (cell, &x) in row[..values.len()].iter().zip(values) {
            cell.set(input.kind.bits_of(x, self.bound.precision()));
        }
    }

    /// Reads one component of an output in the lanes `0..values.len()`.
    ///
    /// # Panics
    /// There are more values than lanes, or the port has not that component.
    pub fn read(&self, output: &LanePort, component: usize, values: &mut [f64]) {
        let row = self.memory.row(output.slot_of(component));
        let width = values.len();
        for (x, cell) in values.iter_mut().zip(&row[..width]) {
            *x = output.kind.read(cell.get()).as_f64();
        }
    }

    /// Sets all arguments of one lane.
    ///
    /// # Errors
    /// As [`Program::call`].
    ///
    /// # Panics
    /// There is no such lane.
    pub fn set(&mut self, lane: usize, arguments: &[Value]) -> Result<(), Diagnostic> {
        let program = self.bound.program();
        write_arguments(
            program.name(),
            program.parameters(),
            arguments,
            self.bound.precision(),
            &self.memory,
            lane,
        )
    }

    /// Result of one lane.
    ///
    /// # Panics
    /// There is no such lane.
    pub fn get(&self, lane: usize) -> Value {
        let program = self.bound.program();
        program.result().read(&mut (program.result_slot..).map(|slot| self.memory.bits(slot, lane)))
    }

    /// Runs the first `count` lanes; whole quads, if derivatives or textures are to mean anything.
    /// Lanes that only help their neighbors are run like any other. All inputs of these lanes must
    /// have been set since the last run.
    ///
    /// # Errors
    /// `interp-endless`: the lanes together took more instructions than
    /// [`FunctionOptions::step_limit`](super::FunctionOptions).
    ///
    /// # Panics
    /// There are fewer lanes.
    pub fn run(&mut self, count: usize) -> Result<Batch, Diagnostic> {
        assert!(count <= LANES, "there are {LANES} lanes, not {count}");
        if count == 0 {
            return Ok(Batch::default());
        }
        let live = u64::MAX >> (LANES - count);
        let program = self.bound.program();
        let resources = self.bound.resources();
        let outcome = match self.bound.precision() {
            Precision::F64 => {
                run::<Double>(program, &self.memory, &mut self.shared, live, &resources)
            }
            Precision::F32 => {
                run::<Single>(program, &self.memory, &mut self.shared, live, &resources)
            }
        };
        outcome.map_err(|endless| endless.diagnose(program))
    }
}

fn run<R: Rounding>(
    program: &Program,
    memory: &Memory<LANES>,
    shared: &mut SharedCalls,
    live: u64,
    resources: &BoundResources,
) -> Result<Batch, TimeLimitError> {
    let code = program.code.as_slice();
    let mut groups = LaneGroups::new(LaneGroup { counter: program.entry as usize, lanes: live });
    let mut steps = program.step_limit;
    let mut discarded = 0;
    loop {
        let LaneGroup { counter, lanes } = groups.current;
        let instruction = code[counter];
        groups.current.counter = counter + 1;
        steps = steps.checked_sub(instruction.cost()).ok_or(TimeLimitError)?;
        match instruction {
            Instruction::Halt => {
                if !groups.finish() {
                    break;
                }
            }
            Instruction::Jump { target } => groups.current.counter = target as usize,
            Instruction::JumpIf { condition, when, target } => {
                let truths = memory.truths(condition, lanes);
                groups.branch(if when { truths } else { lanes & !truths }, target as usize);
            }
            Instruction::Switch { selector, table } => {
                let switch = &program.switches[table as usize];
                match memory.same_in_all(selector) {
                    Some(value) => groups.current.counter = switch.target(value as u32) as usize,
                    None => {
                        groups.scatter(|lane| switch.target(memory.int(selector, lane)) as usize);
                    }
                }
            }
            Instruction::Call { target, link } => {
                memory.fill(link, counter as u64 + 1, Mask { lanes, is_full: lanes == live });
                groups.current.counter = target as usize;
            }
            Instruction::CallPure { target, link, call } => {
                let mask = Mask { lanes, is_full: lanes == live };
                if !shared.call::<R>(
                    (call, target, link),
                    (program, resources),
                    memory,
                    mask,
                    &mut steps,
                )? {
                    memory.fill(link, counter as u64 + 1, mask);
                    groups.current.counter = target as usize;
                }
            }
            Instruction::Return { link } => match memory.same_in_all(link) {
                Some(target) => groups.current.counter = target as usize,
                None => groups.scatter(|lane| memory.bits(link, lane) as usize),
            },
            Instruction::Kill => {
                discarded |= lanes;
                if discarded == live {
                    break;
                }
            }
            _ => {
                step::<R, LANES>(
                    instruction,
                    memory,
                    Mask { lanes, is_full: lanes == live },
                    resources,
                );
            }
        }
        groups.settle();
    }
    Ok(Batch { discarded, steps: program.step_limit - steps })
}
