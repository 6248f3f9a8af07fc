//! Runs programs.

use super::instruction::{Instruction, Slot};
use super::math::{self, Double, Rounding, Single};
use super::{Parameter, Precision, Program, Value};
use crate::diag::Diagnostic;

/// Memory in which one [`Program`] runs, one call after the other.
#[derive(Clone, Debug)]
pub struct Machine<'p> {
    program: &'p Program,
    precision: Precision,
    memory: Vec<u64>,
}

/// A program ran for longer than allowed.
struct Endless;

impl<'p> Machine<'p> {
    pub(super) fn new(program: &'p Program, precision: Precision) -> Self {
        let mut memory = program.image.clone();
        if precision == Precision::F32 {
            for &slot in &program.wide_constants {
                let bits = &mut memory[slot as usize];
                *bits = Single::round(f64::from_bits(*bits)).to_bits();
            }
        }
        Self { program, precision, memory }
    }

    /// Runs the program once. Nothing of an earlier call is left to see.
    ///
    /// # Errors
    /// As [`Program::call`].
    pub fn call(&mut self, arguments: &[Value]) -> Result<Value, Diagnostic> {
        let Program { name, parameters, result, result_slot, step_limit, .. } = self.program;
        if arguments.len() != parameters.len() {
            let plural = if parameters.len() == 1 { "" } else { "s" };
            let message =
                format!("`{name}` takes {} argument{plural}, but {} were given", parameters.len(), arguments.len());
            return Err(Diagnostic::error("interp-argument", message));
        }
        for (parameter, value) in parameters.iter().zip(arguments) {
            let slots = &mut self.memory[parameter.slot as usize..];
            parameter.shape.write(value, self.precision, slots).ok_or_else(|| wrong_shape(name, parameter, value))?;
        }
        let outcome = match self.precision {
            Precision::F64 => run::<Double>(self.program, &mut self.memory),
            Precision::F32 => run::<Single>(self.program, &mut self.memory),
        };
        outcome.map_err(|Endless| {
            Diagnostic::error("interp-endless", format!("`{name}` did not end within {step_limit} steps"))
                .hint("look for a loop whose exit condition never becomes true")
        })?;
        Ok(result.read(&mut self.memory[*result_slot as usize..].iter().copied()))
    }
}

#[cold]
fn wrong_shape(function: &str, parameter: &Parameter, value: &Value) -> Diagnostic {
    let Parameter { name, shape, .. } = parameter;
    let message = format!("argument `{name}` of `{function}` is {shape}, but {value} ({}) was given", value.describe());
    Diagnostic::error("interp-argument", message)
}

/// Slots, read and written as what the instructions say they are.
struct Memory<'m>(&'m mut [u64]);

impl Memory<'_> {
    fn bits(&self, slot: Slot) -> u64 {
        self.0[slot as usize]
    }

    fn float(&self, slot: Slot) -> f64 {
        f64::from_bits(self.bits(slot))
    }

    fn int(&self, slot: Slot) -> u32 {
        self.bits(slot) as u32
    }

    fn set(&mut self, slot: Slot, bits: u64) {
        self.0[slot as usize] = bits;
    }

    fn set_float<R: Rounding>(&mut self, slot: Slot, x: f64) {
        self.set(slot, R::round(x).to_bits());
    }

    fn set_int(&mut self, slot: Slot, x: u32) {
        self.set(slot, u64::from(x));
    }

    /// The slot that lies `offset` beyond what `pointer` holds.
    fn target(&self, pointer: Slot, offset: u32) -> usize {
        self.bits(pointer) as usize + offset as usize
    }

    fn copy(&mut self, to: usize, from: usize, count: u32) {
        self.0.copy_within(from..from + count as usize, to);
    }
}

fn run<R: Rounding>(program: &Program, memory: &mut [u64]) -> Result<(), Endless> {
    let code = program.code.as_slice();
    let mut memory = Memory(memory);
    let mut counter = program.entry as usize;
    let mut steps = program.step_limit;
    loop {
        let instruction = code[counter];
        counter += 1;
        let cost = match instruction {
            Instruction::CopyRun { count, .. } | Instruction::Clear { count, .. } | Instruction::Load { count, .. } => {
                u64::from(count)
            }
            _ => 1,
        };
        steps = steps.checked_sub(cost).ok_or(Endless)?;
        match instruction {
            Instruction::Halt => return Ok(()),
            Instruction::Jump { target } => counter = target as usize,
            Instruction::JumpIf { condition, when, target } => {
                if (memory.bits(condition) != 0) == when {
                    counter = target as usize;
                }
            }
            Instruction::Switch { selector, table } => {
                let switch = &program.switches[table as usize];
                let found = switch.cases.binary_search_by_key(&memory.int(selector), |case| case.0);
                counter = found.map_or(switch.default, |index| switch.cases[index].1) as usize;
            }
            Instruction::Call { target, link } => {
                memory.set(link, counter as u64);
                counter = target as usize;
            }
            Instruction::Return { link } => counter = memory.bits(link) as usize,
            _ => step::<R>(instruction, &mut memory),
        }
    }
}

/// Executes an instruction that goes on at the next.
#[inline(always)] // The one caller is the loop, and a second dispatch would cost as much as most instructions.
fn step<R: Rounding>(instruction: Instruction, memory: &mut Memory) {
    match instruction {
        Instruction::Copy { to, from } => memory.set(to, memory.bits(from)),
        Instruction::CopyRun { to, from, count } => memory.copy(to as usize, from as usize, count),
        Instruction::Clear { to, count } => memory.0[to as usize..][..count as usize].fill(0),
        Instruction::FloatUnary { op, to, a } => memory.set_float::<R>(to, math::float_unary(op, memory.float(a))),
        Instruction::FloatBinary { op, to, a, b } => {
            memory.set_float::<R>(to, math::float_binary(op, memory.float(a), memory.float(b)));
        }
        Instruction::FloatFma { to, a, b, c } => {
            memory.set_float::<R>(to, R::fma(memory.float(a), memory.float(b), memory.float(c)));
        }
        Instruction::FloatScale { to, a, exponent } => {
            memory.set_float::<R>(to, math::ldexp(memory.float(a), memory.int(exponent) as i32));
        }
        Instruction::FloatCompare { op, to, a, b } => {
            memory.set(to, u64::from(math::float_compare(op, memory.float(a), memory.float(b))));
        }
        Instruction::IntUnary { op, to, a } => memory.set_int(to, math::int_unary(op, memory.int(a))),
        Instruction::IntBinary { op, to, a, b } => {
            memory.set_int(to, math::int_binary(op, memory.int(a), memory.int(b)));
        }
        Instruction::ExtractBits { to, a, offset, count, signed } => {
            let (offset, count) = (memory.int(offset), memory.int(count));
            memory.set_int(to, math::extract_bits(memory.int(a), offset, count, signed));
        }
        Instruction::InsertBits { to, a, b, offset, count } => {
            let (offset, count) = (memory.int(offset), memory.int(count));
            memory.set_int(to, math::insert_bits(memory.int(a), memory.int(b), offset, count));
        }
        Instruction::Convert { op, to, a } => memory.set(to, math::convert::<R>(op, memory.bits(a))),
        Instruction::Select { to, condition, accept, reject } => {
            let chosen = if memory.bits(condition) != 0 { accept } else { reject };
            memory.set(to, memory.bits(chosen));
        }
        Instruction::Index { to, pointer, index, count, stride } => {
            let offset = u64::from(memory.int(index).min(count - 1)) * u64::from(stride);
            memory.set(to, memory.bits(pointer) + offset);
        }
        Instruction::Offset { to, pointer, offset } => memory.set(to, memory.bits(pointer) + u64::from(offset)),
        Instruction::Load { to, pointer, offset, count } => {
            memory.copy(to as usize, memory.target(pointer, offset), count);
        }
        Instruction::Store { pointer, offset, from } => {
            let target = memory.target(pointer, offset);
            memory.0[target] = memory.bits(from);
        }
        Instruction::Halt
        | Instruction::Jump { .. }
        | Instruction::JumpIf { .. }
        | Instruction::Switch { .. }
        | Instruction::Call { .. }
        | Instruction::Return { .. } => unreachable!("the loop handles what moves the counter"),
    }
}
