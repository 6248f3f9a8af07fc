//! Memory, and what one instruction does to it.
//!
//! Memory is a list of slots, each of which is a row of `W` lanes: 1 for one call, [`super::LANES`] for lockstep. Rows are
//! cells, because the operands of one instruction may be the same row, and because that leaves plain loops which the
//! compiler turns into vector code.

use std::cell::Cell;

use super::image;
use super::instruction::{Derivative, Instruction, Slot};
use super::math::{self, Binary, Rounding, Unary};
use super::resources::World;
use super::{Precision, Program};

/// A mask with all lanes.
pub(super) const ALL: u64 = u64::MAX;

/// The lanes of one slot.
pub(super) type Row<const W: usize> = [Cell<u64>; W];

/// Slots, read and written as what the instructions say they are.
#[derive(Clone, Debug)]
pub(super) struct Memory<const W: usize> {
    rows: Vec<Row<W>>,
}

impl<const W: usize> Memory<W> {
    /// What a program's memory holds before it runs, the same in all lanes.
    pub(super) fn new(program: &Program, precision: Precision, world: &World) -> Self {
        let row = |bits: u64| std::array::from_fn(|_| Cell::new(bits));
        let mut rows: Vec<Row<W>> = program.image.iter().map(|&bits| row(bits)).collect();
        if precision == Precision::F32 {
            for &(slot, bits) in &program.wide_constants {
                rows[slot as usize] = row(bits);
            }
        }
        for &(slot, source) in &program.bound_slots {
            rows[slot as usize] = row(world.scalar(source));
        }
        Self { rows }
    }

    #[inline(always)]
    pub(super) fn row(&self, slot: Slot) -> &Row<W> {
        &self.rows[slot as usize]
    }

    /// The bits of one lane.
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

    /// The lanes of `mask` in which the slot is not 0.
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

    /// What the slot holds in all lanes, if that is the same.
    pub(super) fn same_in_all(&self, slot: Slot) -> Option<u64> {
        let row = self.row(slot);
        let first = row[0].get();
        // No early exit, so that it is one sweep of vector code.
        let differing = row.iter().fold(0, |differing, bits| differing | (bits.get() ^ first));
        (differing == 0).then_some(first)
    }

    fn copy(&self, to: Slot, from: Slot, mask: Mask) {
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

    fn copy_run(&self, to: Slot, from: Slot, count: u32, mask: Mask) {
        if W == 1 {
            let rows = |first: Slot| &self.rows[first as usize..][..count as usize];
            rows(to).iter().zip(rows(from)).for_each(|(to, from)| to[0].set(from[0].get()));
        } else {
            (0..count).for_each(|offset| self.copy(to + offset, from + offset, mask));
        }
    }

    fn clear(&self, to: Slot, count: u32, mask: Mask) {
        for row in &self.rows[to as usize..][..count as usize] {
            for (lane, to) in row.iter().enumerate() {
                if mask.has(lane) {
                    to.set(0);
                }
            }
        }
    }

    /// The slot that lies `offset` beyond what `pointer` holds.
    #[inline(always)]
    fn target(&self, pointer: Slot, offset: u32, lane: usize) -> Slot {
        self.bits(pointer, lane) as u32 + offset
    }
}

/// Which lanes an instruction is for. All others may only be changed where nobody looks.
#[derive(Clone, Copy)]
pub(super) struct Mask {
    pub(super) lanes: u64,
    /// No other lane holds anything that is still needed.
    pub(super) is_full: bool,
}

impl Mask {
    #[inline(always)]
    fn has(self, lane: usize) -> bool {
        self.is_full || self.lanes >> lane & 1 != 0
    }

    /// The lanes in it, of the first `width`.
    #[inline(always)]
    pub(super) fn lanes(self, width: usize) -> impl Iterator<Item = usize> {
        (0..width).filter(move |lane| self.lanes >> lane & 1 != 0)
    }
}

/// Rows with the meaning of their bits.
struct Lanes1<'m, const W: usize> {
    to: &'m Row<W>,
    a: &'m Row<W>,
}

struct Lanes2<'m, const W: usize> {
    to: &'m Row<W>,
    a: &'m Row<W>,
    b: &'m Row<W>,
}

/// Floats, rounded when stored.
struct Floats<R, T>(T, std::marker::PhantomData<R>);

impl<R: Rounding, const W: usize> Unary<f64, f64> for Floats<R, Lanes1<'_, W>> {
    #[inline(always)]
    fn with(self, f: impl Fn(f64) -> f64) {
        let Lanes1 { to, a } = self.0;
        for lane in 0..W {
            to[lane].set(R::round(f(f64::from_bits(a[lane].get()))).to_bits());
        }
    }
}

impl<R: Rounding, const W: usize> Binary<f64, f64> for Floats<R, Lanes2<'_, W>> {
    #[inline(always)]
    fn with(self, f: impl Fn(f64, f64) -> f64) {
        let Lanes2 { to, a, b } = self.0;
        for lane in 0..W {
            let result = f(f64::from_bits(a[lane].get()), f64::from_bits(b[lane].get()));
            to[lane].set(R::round(result).to_bits());
        }
    }
}

impl<const W: usize> Binary<f64, bool> for Lanes2<'_, W> {
    #[inline(always)]
    fn with(self, f: impl Fn(f64, f64) -> bool) {
        let Self { to, a, b } = self;
        for lane in 0..W {
            to[lane].set(u64::from(f(f64::from_bits(a[lane].get()), f64::from_bits(b[lane].get()))));
        }
    }
}

impl<const W: usize> Unary<u32, u32> for Lanes1<'_, W> {
    #[inline(always)]
    fn with(self, f: impl Fn(u32) -> u32) {
        let Self { to, a } = self;
        for lane in 0..W {
            to[lane].set(u64::from(f(a[lane].get() as u32)));
        }
    }
}

impl<const W: usize> Binary<u32, u32> for Lanes2<'_, W> {
    #[inline(always)]
    fn with(self, f: impl Fn(u32, u32) -> u32) {
        let Self { to, a, b } = self;
        for lane in 0..W {
            to[lane].set(u64::from(f(a[lane].get() as u32, b[lane].get() as u32)));
        }
    }
}

impl<const W: usize> Unary<u64, u64> for Lanes1<'_, W> {
    #[inline(always)]
    fn with(self, f: impl Fn(u64) -> u64) {
        let Self { to, a } = self;
        for lane in 0..W {
            to[lane].set(f(a[lane].get()));
        }
    }
}

/// Executes an instruction that goes on at the next.
///
/// Slots that hold what an instruction computed are read only by lanes that executed it, so those are written in all
/// lanes. Locals, arguments, results and links keep their values while other lanes run; `Copy` and its like write them,
/// and obey the mask.
#[inline(always)] // The callers are the loops, and a second dispatch would cost as much as most instructions.
pub(super) fn step<R: Rounding, const W: usize>(
    instruction: Instruction,
    memory: &Memory<W>,
    mask: Mask,
    world: &World,
) {
    let lanes1 = |to, a| Lanes1 { to: memory.row(to), a: memory.row(a) };
    let lanes2 = |to, a, b| Lanes2 { to: memory.row(to), a: memory.row(a), b: memory.row(b) };
    let rounded = std::marker::PhantomData::<R>;
    match instruction {
        Instruction::Copy { to, from } => memory.copy(to, from, mask),
        Instruction::CopyRun { to, from, count } => {
            memory.copy_run(to, from, count, mask);
        }
        Instruction::Clear { to, count } => memory.clear(to, count, mask),
        Instruction::FloatUnary { op, to, a } => math::float_unary(op, Floats(lanes1(to, a), rounded)),
        Instruction::FloatBinary { op, to, a, b } => math::float_binary(op, Floats(lanes2(to, a, b), rounded)),
        Instruction::FloatCompare { op, to, a, b } => math::float_compare(op, lanes2(to, a, b)),
        Instruction::IntUnary { op, to, a } => math::int_unary(op, lanes1(to, a)),
        Instruction::IntBinary { op, to, a, b } => math::int_binary(op, lanes2(to, a, b)),
        Instruction::Convert { op, to, a } => math::convert::<R>(op, lanes1(to, a)),
        Instruction::Select { to, condition, accept, reject } => {
            let [to, condition, accept, reject] = [to, condition, accept, reject].map(|slot| memory.row(slot));
            for lane in 0..W {
                let (accept, reject) = (accept[lane].get(), reject[lane].get());
                to[lane].set(if condition[lane].get() != 0 { accept } else { reject });
            }
        }
        Instruction::Index { to, pointer, index, count, stride } => {
            let [to, pointer, index] = [to, pointer, index].map(|slot| memory.row(slot));
            for lane in 0..W {
                let offset = u64::from((index[lane].get() as u32).min(count - 1)) * u64::from(stride);
                to[lane].set(pointer[lane].get() + offset);
            }
        }
        Instruction::Offset { to, pointer, offset } => {
            let [to, pointer] = [to, pointer].map(|slot| memory.row(slot));
            for lane in 0..W {
                to[lane].set(pointer[lane].get() + u64::from(offset));
            }
        }
        Instruction::Load { to, pointer, offset, count } => {
            for lane in mask.lanes(W) {
                let from = memory.target(pointer, offset, lane);
                (0..count).for_each(|i| memory.set(to + i, lane, memory.bits(from + i, lane)));
            }
        }
        Instruction::Store { pointer, offset, from } => {
            for lane in mask.lanes(W) {
                memory.set(memory.target(pointer, offset, lane), lane, memory.bits(from, lane));
            }
        }
        Instruction::Derivative { op, to, a } => {
            derivative(op, memory.row(to), memory.row(a), |difference| R::round(difference));
        }
        seldom => rare::<R, W>(seldom, memory, mask, world),
    }
}

/// Executes what is not worth a place in the loop.
#[inline(never)]
fn rare<R: Rounding, const W: usize>(instruction: Instruction, memory: &Memory<W>, mask: Mask, world: &World) {
    match instruction {
        Instruction::FloatFma { to, a, b, c } => {
            for lane in 0..W {
                let fused = R::fma(memory.float(a, lane), memory.float(b, lane), memory.float(c, lane));
                memory.set(to, lane, R::round(fused).to_bits());
            }
        }
        Instruction::FloatScale { to, a, exponent } => {
            for lane in 0..W {
                let scaled = math::ldexp(memory.float(a, lane), memory.int(exponent, lane).cast_signed());
                memory.set(to, lane, R::round(scaled).to_bits());
            }
        }
        Instruction::ExtractBits { to, a, offset, count, signed } => {
            for lane in 0..W {
                let [a, offset, count] = [a, offset, count].map(|slot| memory.int(slot, lane));
                memory.set(to, lane, math::extract_bits(a, offset, count, signed).into());
            }
        }
        Instruction::InsertBits { to, a, b, offset, count } => {
            for lane in 0..W {
                let [a, b, offset, count] = [a, b, offset, count].map(|slot| memory.int(slot, lane));
                memory.set(to, lane, math::insert_bits(a, b, offset, count).into());
            }
        }
        Instruction::LoadBuffer { to, buffer, pointer, offset, count } => {
            for lane in mask.lanes(W) {
                let from = memory.bits(pointer, lane) + u64::from(offset);
                (0..count).for_each(|i| memory.set(to + i, lane, world.load(buffer, from + u64::from(i))));
            }
        }
        Instruction::Image { operation } => image::execute::<R, W>(operation, memory, mask, world),
        // The loops handle what moves the counter or ends lanes; `step` all the rest.
        _ => debug_assert!(false, "{instruction:?} is no step"),
    }
}

/// Differences within each quad of lanes; 0 where lanes are no quads.
fn derivative<const W: usize>(op: Derivative, to: &Row<W>, a: &Row<W>, round: impl Fn(f64) -> f64) {
    let at = |lane: usize| f64::from_bits(a[lane].get());
    for lane in 0..W {
        let (quad, place) = (lane & !3, lane & 3);
        let (from, onto) = match op {
            Derivative::FineX => (place & 2, place | 1),
            Derivative::FineY => (place & 1, place | 2),
            Derivative::CoarseX => (0, 1),
            Derivative::CoarseY => (0, 2),
        };
        let difference = if W < 4 { 0.0 } else { at(quad + onto) - at(quad + from) };
        to[lane].set(round(difference).to_bits());
    }
}
