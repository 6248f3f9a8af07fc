//! Effect of one instruction on memory, in any number of lanes.

use super::image;
use super::instruction::{Derivative, Instruction};
use super::math::{self, Binary, Rounding, Unary};
use super::memory::{LaneRow, Mask, Memory};
use super::resources::BoundResources;

/// Rows of the result and one operand.
struct Lanes1<'m, const W: usize> {
    to: &'m LaneRow<W>,
    a: &'m LaneRow<W>,
}

struct Lanes2<'m, const W: usize> {
    to: &'m LaneRow<W>,
    a: &'m LaneRow<W>,
    b: &'m LaneRow<W>,
}

/// Rows of floats, rounded when stored.
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
            to[lane]
                .set(u64::from(f(f64::from_bits(a[lane].get()), f64::from_bits(b[lane].get()))));
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

/// Executes an instruction that continues at the next.
///
/// Slots that hold the result of an instruction are read only by lanes that executed it, so those
/// are written in all lanes. Locals, arguments, results and links keep their values while other
/// lanes run; `Copy` and its like write them, and obey the mask.
// The callers are the loops, and a second dispatch would cost as much as most instructions.
#[inline(always)]
pub(super) fn step<R: Rounding, const W: usize>(
    instruction: Instruction,
    memory: &Memory<W>,
    mask: Mask,
    resources: &BoundResources,
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
        Instruction::FloatUnary { op, to, a } => {
            math::float_unary(op, Floats(lanes1(to, a), rounded));
        }
        Instruction::FloatBinary { op, to, a, b } => {
            math::float_binary(op, Floats(lanes2(to, a, b), rounded));
        }
        Instruction::FloatCompare { op, to, a, b } => math::float_compare(op, lanes2(to, a, b)),
        Instruction::IntUnary { op, to, a } => math::int_unary(op, lanes1(to, a)),
        Instruction::IntBinary { op, to, a, b } => math::int_binary(op, lanes2(to, a, b)),
        Instruction::Convert { op, to, a } => math::convert::<R>(op, lanes1(to, a)),
        Instruction::Select { to, condition, accept, reject } => {
            let [to, condition, accept, reject] =
                [to, condition, accept, reject].map(|slot| memory.row(slot));
            for lane in 0..W {
                let (accept, reject) = (accept[lane].get(), reject[lane].get());
                to[lane].set(if condition[lane].get() != 0 { accept } else { reject });
            }
        }
        Instruction::Index { to, pointer, index, count, stride } => {
            let [to, pointer, index] = [to, pointer, index].map(|slot| memory.row(slot));
            for lane in 0..W {
                let offset =
                    u64::from((index[lane].get() as u32).min(count - 1)) * u64::from(stride);
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
        seldom => rare::<R, W>(seldom, memory, mask, resources),
    }
}

/// Executes rare instructions, which are not worth a place in the loop.
#[inline(never)]
fn rare<R: Rounding, const W: usize>(
    instruction: Instruction,
    memory: &Memory<W>,
    mask: Mask,
    resources: &BoundResources,
) {
    match instruction {
        Instruction::FloatFma { to, a, b, c } => {
            for lane in 0..W {
                let fused =
                    R::fma(memory.float(a, lane), memory.float(b, lane), memory.float(c, lane));
                memory.set(to, lane, R::round(fused).to_bits());
            }
        }
        Instruction::FloatScale { to, a, exponent } => {
            for lane in 0..W {
                let scaled =
                    math::ldexp(memory.float(a, lane), memory.int(exponent, lane).cast_signed());
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
                let [a, b, offset, count] =
                    [a, b, offset, count].map(|slot| memory.int(slot, lane));
                memory.set(to, lane, math::insert_bits(a, b, offset, count).into());
            }
        }
        Instruction::LoadBuffer { to, buffer, pointer, offset, count } => {
            for lane in mask.lanes(W) {
                let from = memory.bits(pointer, lane) + u64::from(offset);
                (0..count).for_each(|i| {
                    memory.set(to + i, lane, resources.load(buffer, from + u64::from(i)));
                });
            }
        }
        Instruction::Image { operation } => {
            image::execute::<R, W>(operation, memory, mask, resources);
        }
        // The loops handle instructions that move the counter or end lanes; `step` handles all
        // others.
        _ => debug_assert!(false, "{instruction:?} is no step"),
    }
}

/// Differences within each quad of lanes; 0 where lanes are no quads.
fn derivative<const W: usize>(
    op: Derivative,
    to: &LaneRow<W>,
    a: &LaneRow<W>,
    round: impl Fn(f64) -> f64,
) {
    let at = |lane: usize| f64::from_bits(a[lane].get());
    for (lane, to) in to.iter().enumerate() {
        let (quad, place) = (lane & !3, lane & 3);
        let (from, onto) = match op {
            Derivative::FineX => (place & 2, place | 1),
            Derivative::FineY => (place & 1, place | 2),
            Derivative::CoarseX => (0, 1),
            Derivative::CoarseY => (0, 2),
        };
        let difference = if W < 4 { 0.0 } else { at(quad + onto) - at(quad + from) };
        to.set(round(difference).to_bits());
    }
}
