//! Assembler: collects the instructions, constants and labels of a program.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use chiaro_locale::tr;
use naga::{Expression, Handle};

use super::Outcome;
use crate::diag::Diagnostic;
use crate::interp::ObservedValue;
use crate::interp::image::Operation;
use crate::interp::instruction::{Instruction, JumpTarget, PureCall, Slot, Switch};
use crate::interp::resources::SlotSource;

/// Greatest number of slots of a program's memory: 32 MiB.
pub(super) const MAX_SLOTS: u32 = 1 << 22;

/// Greatest number of slots that the lists of all values of a program may name together.
const MAX_LISTED: usize = 1 << 25;

/// Greatest number of instructions of a program.
const MAX_CODE: usize = 1 << 24;

/// Program in the making. Targets are labels, which [`link`](Self::link) turns into numbers of
/// instructions.
pub(super) struct Assembler {
    code: Vec<Instruction>,
    switches: Vec<Switch>,
    pure_calls: Vec<PureCall>,
    image: Vec<u64>,
    constants: HashMap<u64, Slot>,
    /// Slots of constants that f32 cannot hold, by their bits in f64 and in f32.
    wide_constants: HashMap<(u64, u64), Slot>,
    /// Bits of those slots in f32.
    wide_slots: HashMap<Slot, u64>,
    bound_slots: HashMap<SlotSource, Slot>,
    operations: Vec<Operation>,
    constant_slots: HashSet<Slot>,
    constant_runs: HashMap<Vec<Slot>, Slot>,
    /// Values of the module's constant expressions.
    pub(super) globals: HashMap<Handle<Expression>, Rc<[Slot]>>,
    /// Number of slots that all lists of slots name together.
    listed: usize,
    /// Values that the source names, where they are to be read.
    pub(super) observed: Vec<ObservedValue>,
    /// Number of the instruction that each label stands before.
    labels: Vec<u32>,
}

/// Complete program, without its signature.
pub(super) struct LinkedProgram {
    pub(super) code: Vec<Instruction>,
    pub(super) switches: Vec<Switch>,
    pub(super) pure_calls: Vec<PureCall>,
    pub(super) image: Vec<u64>,
    pub(super) wide_constants: Vec<(Slot, u64)>,
    pub(super) bound_slots: Vec<(Slot, SlotSource)>,
    pub(super) operations: Vec<Operation>,
    pub(super) observed: Vec<ObservedValue>,
    pub(super) entry: u32,
}

impl Assembler {
    pub(super) fn new() -> Self {
        Self {
            // The entry function's link slot stays 0, so its return ends the program here.
            code: vec![Instruction::Halt],
            switches: Vec::new(),
            pure_calls: Vec::new(),
            image: Vec::new(),
            constants: HashMap::new(),
            wide_constants: HashMap::new(),
            wide_slots: HashMap::new(),
            bound_slots: HashMap::new(),
            operations: Vec::new(),
            constant_slots: HashSet::new(),
            constant_runs: HashMap::new(),
            globals: HashMap::new(),
            listed: 0,
            observed: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// Appends an instruction.
    pub(super) fn emit(&mut self, instruction: Instruction) -> Outcome<()> {
        if self.code.len() >= MAX_CODE {
            return Err(too_big(&tr!("{MAX_CODE} instructions")));
        }
        self.code.push(instruction);
        Ok(())
    }

    /// Reserves neighboring slots, and returns the first.
    pub(super) fn reserve(&mut self, count: u32) -> Outcome<Slot> {
        let first = self.image.len() as u32;
        if count > MAX_SLOTS - first {
            return Err(too_big(&tr!("{MAX_SLOTS} scalars")));
        }
        self.image.resize(self.image.len() + count as usize, 0);
        Ok(first)
    }

    /// Slot that holds these bits.
    pub(super) fn constant(&mut self, bits: u64) -> Outcome<Slot> {
        if let Some(&slot) = self.constants.get(&bits) {
            return Ok(slot);
        }
        let slot = self.reserve_constant(bits)?;
        self.constants.insert(bits, slot);
        Ok(slot)
    }

    /// Slot that holds this float; if f32 cannot, then one that is rounded when the program runs in
    /// f32.
    pub(super) fn float(&mut self, x: f64) -> Outcome<Slot> {
        self.wide_float(x, f64::from(x as f32))
    }

    /// Slot that holds `x` in f64 and `single` in f32.
    pub(super) fn wide_float(&mut self, x: f64, single: f64) -> Outcome<Slot> {
        let bits = (x.to_bits(), single.to_bits());
        if x.is_nan() || bits.0 == bits.1 {
            return self.constant(bits.0);
        }
        if let Some(&slot) = self.wide_constants.get(&bits) {
            return Ok(slot);
        }
        let slot = self.reserve_constant(bits.0)?;
        self.wide_constants.insert(bits, slot);
        self.wide_slots.insert(slot, bits.1);
        Ok(slot)
    }

    /// Slot that is filled when resources are bound.
    pub(super) fn bound(&mut self, source: SlotSource) -> Outcome<Slot> {
        if let Some(&slot) = self.bound_slots.get(&source) {
            return Ok(slot);
        }
        let slot = self.reserve(1)?;
        self.bound_slots.insert(source, slot);
        Ok(slot)
    }

    /// Registers a use of a texture, whose number an instruction names.
    pub(super) fn image(&mut self, operation: Operation) -> u32 {
        self.operations.push(operation);
        self.operations.len() as u32 - 1
    }

    fn reserve_constant(&mut self, bits: u64) -> Outcome<Slot> {
        let slot = self.reserve(1)?;
        self.image[slot as usize] = bits;
        self.constant_slots.insert(slot);
        Ok(slot)
    }

    /// First of neighboring slots that hold the values of `slots`, if those are all constants.
    pub(super) fn constant_run(&mut self, slots: &[Slot]) -> Outcome<Option<Slot>> {
        if let Some(&first) = self.constant_runs.get(slots) {
            return Ok(Some(first));
        }
        if !slots.iter().all(|slot| self.constant_slots.contains(slot)) {
            return Ok(None);
        }
        let first = self.reserve(slots.len() as u32)?;
        for (to, &from) in (first..).zip(slots) {
            self.image[to as usize] = self.image[from as usize];
            self.constant_slots.insert(to);
            if let Some(&single) = self.wide_slots.get(&from) {
                self.wide_slots.insert(to, single);
            }
        }
        self.constant_runs.insert(slots.to_vec(), first);
        Ok(Some(first))
    }

    /// Accounts for the list of the slots of one value.
    pub(super) fn list(&mut self, slots: usize) -> Outcome<()> {
        self.listed += slots;
        if self.listed > MAX_LISTED {
            Err(too_big(&tr!("{MAX_LISTED} scalars in its values")))
        } else {
            Ok(())
        }
    }

    /// New label, to be placed later.
    pub(super) fn label(&mut self) -> JumpTarget {
        self.labels.push(0);
        self.labels.len() as u32 - 1
    }

    /// Puts a label before the next instruction.
    pub(super) fn place(&mut self, label: JumpTarget) {
        self.labels[label as usize] = self.code.len() as u32;
    }

    /// Registers a switch, whose number an instruction names.
    pub(super) fn switch(&mut self, switch: Switch) -> u32 {
        self.switches.push(switch);
        self.switches.len() as u32 - 1
    }

    /// Registers a call that may be shared, whose number an instruction names.
    pub(super) fn pure_call(&mut self, call: PureCall) -> u32 {
        self.pure_calls.push(call);
        self.pure_calls.len() as u32 - 1
    }

    /// Number of instructions so far.
    pub(super) fn length(&self) -> usize {
        self.code.len()
    }

    /// Resolves all labels.
    pub(super) fn link(self, entry: JumpTarget) -> LinkedProgram {
        let Self {
            mut code,
            mut switches,
            pure_calls,
            image,
            labels,
            wide_slots,
            bound_slots,
            operations,
            observed,
            ..
        } = self;
        for instruction in &mut code {
            if let Instruction::Jump { target }
            | Instruction::JumpIf { target, .. }
            | Instruction::Call { target, .. }
            | Instruction::CallPure { target, .. } = instruction
            {
                *target = labels[*target as usize];
            }
        }
        for switch in &mut switches {
            for (_, target) in &mut switch.cases {
                *target = labels[*target as usize];
            }
            switch.cases.sort_unstable();
            switch.default = labels[switch.default as usize];
        }
        let mut wide_constants: Vec<(Slot, u64)> = wide_slots.into_iter().collect();
        wide_constants.sort_unstable();
        let mut bound_slots: Vec<(Slot, SlotSource)> =
            bound_slots.into_iter().map(|(source, slot)| (slot, source)).collect();
        bound_slots.sort_unstable_by_key(|(slot, _)| *slot);
        LinkedProgram {
            code,
            switches,
            pure_calls,
            image,
            wide_constants,
            bound_slots,
            operations,
            observed,
            entry: labels[entry as usize],
        }
    }
}

#[cold]
fn too_big(limit: &str) -> Box<Diagnostic> {
    let message =
        tr!("the function needs more than {limit}, which is all that the interpreter grants");
    Box::new(
        Diagnostic::error("interp-too-big", message)
            .hint(tr!("use smaller arrays or fewer of them")),
    )
}
