//! Memory: a list of slots, each of which is a row of `W` lanes: 1 for one call, [`super::LANES`]
//! for lockstep. Rows are cells, because the operands of one instruction may be the same row, and
//! because cells leave plain loops which the compiler turns into vector code.

use std::cell::Cell;

use super::instruction::Slot;
use super::resources::BoundResources;
use super::{Precision, Program};

/// Bits of a mask with all lanes.
pub(super) const ALL: u64 = u64::MAX;

/// Lanes of one slot.
pub(super) type LaneRow<const W: usize> = [Cell<u64>; W];

/// Memory of slots, whose types the instructions know.
#[derive(Clone, Debug)]
pub(super) struct Memory<const W: usize> {
    rows: Vec<LaneRow<W>>,
}

impl<const W: usize> Memory<W> {
    /// Memory of a program before it runs, the same in all lanes.
    pub(super) fn new(program: &Program, precision: Precision, resources: &BoundResources) -> Self {
        let row = |bits: u64| std::array::from_fn(|_| Cell::new(bits));
        let mut rows: Vec<LaneRow<W>> = program.image.iter().map(|&bits| row(bits)).collect();
        if precision == Precision::F32 {
            for &(slot, bits) in &program.wide_constants {
                rows[slot as usize] = row(bits);
            }
        }
        for &(slot, source) in &program.bound_slots {
            rows[slot as usize] = row(resources.scalar(source));
        }
        Self { rows }
    }

    /// Memory without slots.
    pub(super) fn empty() -> Self {
        Self { rows: Vec::new() }
    }

    #[inline(always)]
    pub(super) fn row(&self, slot: Slot) -> &LaneRow<W> {
        &self.rows[slot as usize]
    }

    /// Bits of one lane.
    #[inline(always)]
    pub(super) fn bits(&self, slot: Slot, lane: usize) -> u64 {
        self.rows[slot as usize][lane].get()
    }

    #[inline(always)]
    pub(super) fn float(&self, slot: Slot, lane: usize) -> f64 {
        f64::from_bits(self.bits(slot, lane))
    }

    #[inline(always)]
    pub(super) fn int(&self, slot: Slot, lane: usize) -> u32 {
        self.bits(slot, lane) as u32
    }

    #[inline(always)]
    pub(super) fn set(&self, slot: Slot, lane: usize, bits: u64) {
        self.rows[slot as usize][lane].set(bits);
    }

    /// Lanes of `mask` in which the slot is not 0.
    #[inline(always)]
    pub(super) fn truths(&self, slot: Slot, mask: u64) -> u64 {
        let row = self.row(slot);
        let mut truths = 0;
        for (lane, bits) in row.iter().enumerate() {
            truths |= u64::from(bits.get() != 0) << lane;
        }
        truths & mask
    }

    /// Sets the slot in the lanes of the mask.
    pub(super) fn fill(&self, slot: Slot, bits: u64, mask: Mask) {
        for (lane, to) in self.row(slot).iter().enumerate() {
            to.set(if mask.has(lane) { bits } else { to.get() });
        }
    }

    /// Bits of the slot, if they are the same in all lanes.
    pub(super) fn same_in_all(&self, slot: Slot) -> Option<u64> {
        let row = self.row(slot);
        let first = row[0].get();
        // The loop has no early exit, so that it is one sweep of vector code.
        let differing = row.iter().fold(0, |differing, bits| differing | (bits.get() ^ first));
        (differing == 0).then_some(first)
    }

    /// True if the slot holds the same bits in these lanes.
    pub(super) fn is_same_in(&self, slot: Slot, lanes: u64) -> bool {
        let row = self.row(slot);
        let first = row[lanes.trailing_zeros() as usize].get();
        let differing = row.iter().enumerate().fold(0, |differing, (lane, bits)| {
            let is_in = 0_u64.wrapping_sub(lanes >> lane & 1);
            differing | ((bits.get() ^ first) & is_in)
        });
        differing == 0
    }

    /// Copies a slot in the lanes of the mask.
    #[inline(always)]
    pub(super) fn copy(&self, to: Slot, from: Slot, mask: Mask) {
        let (to, from) = (self.row(to), self.row(from));
        if mask.is_full {
            for (to, from) in to.iter().zip(from) {
                to.set(from.get());
            }
        } else {
            for (lane, (to, from)) in to.iter().zip(from).enumerate() {
                to.set(if mask.has(lane) { from.get() } else { to.get() });
            }
        }
    }

    /// Copies neighboring slots.
    pub(super) fn copy_run(&self, to: Slot, from: Slot, count: u32, mask: Mask) {
        if W == 1 {
            let rows = |first: Slot| &self.rows[first as usize..][..count as usize];
            rows(to).iter().zip(rows(from)).for_each(|(to, from)| to[0].set(from[0].get()));
        } else {
            (0..count).for_each(|offset| self.copy(to + offset, from + offset, mask));
        }
    }

    /// Clears neighboring slots.
    pub(super) fn clear(&self, to: Slot, count: u32, mask: Mask) {
        for row in &self.rows[to as usize..][..count as usize] {
            for (lane, to) in row.iter().enumerate() {
                if mask.has(lane) {
                    to.set(0);
                }
            }
        }
    }

    /// Slot that lies `offset` beyond the one whose number `pointer` holds.
    #[inline(always)]
    pub(super) fn target(&self, pointer: Slot, offset: u32, lane: usize) -> Slot {
        self.bits(pointer, lane) as u32 + offset
    }
}

/// Lanes that an instruction applies to. All other lanes may only be changed where their contents
/// are not needed.
#[derive(Clone, Copy)]
pub(super) struct Mask {
    pub(super) lanes: u64,
    /// True if no other lane holds anything that is still needed.
    pub(super) is_full: bool,
}

impl Mask {
    #[inline(always)]
    fn has(self, lane: usize) -> bool {
        self.is_full || self.lanes >> lane & 1 != 0
    }

    /// Lanes in the mask, of the first `width`.
    #[inline(always)]
    pub(super) fn lanes(self, width: usize) -> impl Iterator<Item = usize> {
        (0..width).filter(move |lane| self.lanes >> lane & 1 != 0)
    }
}
