//! Calls that all lanes make alike: run once, on one lane, and remembered.

use super::super::instruction::{JumpTarget, PureCall, Slot};
use super::super::machine::{TimeLimitError, run};
use super::super::math::Rounding;
use super::super::memory::{Mask, Memory};
use super::super::resources::BoundResources;
use super::super::{Precision, Program};
use super::LANES;

/// Remembered result of each pure call of a program, and memory to run the calls in.
#[derive(Clone, Debug)]
pub(super) struct SharedCalls {
    memory: Memory<1>,
    last: Vec<Option<LastCall>>,
}

/// Arguments of the last shared run of a call, and its result.
#[derive(Clone, Debug)]
struct LastCall {
    arguments: Vec<u64>,
    result: Vec<u64>,
}

impl SharedCalls {
    pub(super) fn new(program: &Program, precision: Precision, resources: &BoundResources) -> Self {
        // A program without shared calls needs no memory here.
        let memory = if program.pure_calls.is_empty() {
            Memory::empty()
        } else {
            Memory::new(program, precision, resources)
        };
        Self { memory, last: vec![None; program.pure_calls.len()] }
    }

    /// Writes the result of a call (its number, the function's entry, its link) in the lanes of the
    /// mask, if their arguments are the same; returns whether they are.
    pub(super) fn call<R: Rounding>(
        &mut self,
        (number, target, link): (u32, JumpTarget, Slot),
        (program, resources): (&Program, &BoundResources),
        memory: &Memory<LANES>,
        mask: Mask,
        steps: &mut u64,
    ) -> Result<bool, TimeLimitError> {
        let call = &program.pure_calls[number as usize];
        let last = &mut self.last[number as usize];
        if !is_alike(call, memory, mask.lanes) {
            return Ok(false);
        }
        let lane = mask.lanes.trailing_zeros() as usize;
        let arguments = || call.arguments.iter().map(|&slot| memory.bits(slot, lane));
        let known = match last {
            Some(last) if last.arguments.iter().copied().eq(arguments()) => last,
            _ => {
                let arguments: Vec<u64> = arguments().collect();
                call.arguments
                    .iter()
                    .zip(&arguments)
                    .for_each(|(&slot, &bits)| self.memory.set(slot, 0, bits));
                // The program ends when the function returns.
                self.memory.set(link, 0, 0);
                run::<R>(program, &self.memory, resources, target, steps)?;
                let result = (call.result..).take(call.result_slots as usize);
                let result = result.map(|slot| self.memory.bits(slot, 0)).collect();
                last.insert(LastCall { arguments, result })
            }
        };
        (call.result..).zip(&known.result).for_each(|(slot, &bits)| memory.fill(slot, bits, mask));
        Ok(true)
    }
}

/// True if the lanes have the same arguments.
fn is_alike(call: &PureCall, memory: &Memory<LANES>, lanes: u64) -> bool {
    // Comparing the first and the last lane mostly suffices.
    let (first, last) = (lanes.trailing_zeros() as usize, 63 - lanes.leading_zeros() as usize);
    call.arguments.iter().all(|&slot| memory.bits(slot, first) == memory.bits(slot, last))
        && call.arguments.iter().all(|&slot| memory.is_same_in(slot, lanes))
}
