//! Slots, the inputs of a node: numbers with their ranges, and the values at which arithmetic goes
//! wrong.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

use super::random::{Random, direction};
use crate::library::{Context, SurfacePart};

/// The numbers of all slots of one sample.
pub type Numbers = Vec<Vec<f64>>;

/// Destination of a slot's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlotTarget {
    /// The exposed parameter of the slot's name.
    Value,
    /// A part of the surface; the camera's rotation as a quaternion of any length.
    Part(SurfacePart),
    /// A context that has numbers of its own.
    Context(Context),
    /// The light's direction.
    LightDirection,
    /// The light's position.
    LightPosition,
    /// The light's color.
    LightColor,
    /// The light's intensity.
    LightIntensity,
}

/// Kind of a slot's numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlotKind {
    /// Any numbers, within a documented range if the input has one.
    Number {
        /// Documented minimum.
        min: Option<f64>,
        /// Documented maximum.
        max: Option<f64>,
        /// True if the numbers are angles, in radians.
        is_angle: bool,
    },
    /// A whole number.
    Whole {
        /// Documented minimum.
        min: f64,
        /// Documented maximum.
        max: f64,
    },
    /// 0 or 1.
    Switch,
    /// Straight RGBA.
    Color,
    /// Premultiplied RGBA.
    Composite,
    /// A unit vector, except for rounding.
    Unit,
    /// A vector whose direction counts, of any length.
    Direction,
    /// A rotation as a quaternion.
    Rotation,
    /// The sine and cosine of half an angle in [0, pi].
    HalfAngle,
    /// Curvature, NaN and infinities included.
    Kappa,
    /// Products xx, xy and yy of the derivatives of two coordinates along the picture; 0 if the
    /// coordinates are pixels.
    Stretch,
}

/// One input of a node.
#[derive(Clone, Debug, PartialEq)]
pub struct InputSlot {
    /// Name of the input, or word for the context.
    pub name: String,
    /// Destination of the numbers.
    pub place: SlotTarget,
    /// Kind of the numbers.
    pub kind: SlotKind,
    /// Number of numbers.
    pub width: usize,
    /// Largest absolute value of any number.
    pub most: f64,
}

/// The number rounded to f32, as a GPU holds it.
pub fn held(x: f64) -> f64 {
    f64::from(x as f32)
}

/// pi rounded to f32; of its neighbors one is above and one below the real pi.
const PI_32: f64 = std::f32::consts::PI as f64;
const ULP_OF_PI: f64 = 1.0 / 4_194_304.0;

/// Numbers at which arithmetic goes wrong: zeros, denormals, the largest and smallest, and numbers
/// so large that f32 loses their fractions.
const EDGES: [f64; 34] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    3.0,
    -2.0,
    0.999_999_940_395_355_2,
    1.000_000_119_209_289_6,
    1.5,
    2.5,
    1.4e-45,
    -1e-40,
    1e-40,
    1.175_494_350_822_287_5e-38,
    -1.175_494_350_822_287_5e-38,
    1e-30,
    -1e-20,
    1e-7,
    -1e-4,
    255.0,
    1e5,
    8_388_607.5,
    16_777_216.0,
    -16_777_217.0,
    1e10,
    1e19,
    -1e19,
    1e30,
    -1e30,
    f32::MAX as f64,
    -f32::MAX as f64,
];

#[expect(clippy::approx_constant, reason = "what people write for pi is not pi")]
/// Angles at which arithmetic goes wrong: pi in f32 and its neighbors, and decimals that people
/// write for pi.
const ANGLES: [f64; 20] = [
    0.0,
    -0.0,
    PI_32,
    PI_32 - ULP_OF_PI,
    PI_32 + ULP_OF_PI,
    -PI_32,
    FRAC_PI_2,
    FRAC_PI_2 - 1e-7,
    FRAC_PI_2 + 2e-7,
    -FRAC_PI_2,
    TAU,
    -TAU,
    3.14159,
    3.1415,
    1e-7,
    1e-5,
    3e-4,
    1e-3,
    0.7,
    100.0,
];

impl InputSlot {
    /// Numbers within the documented range, from shares of 1 (one share for each number).
    pub fn ordinary(&self, shares: &[f64]) -> Vec<f64> {
        let numbers: Vec<f64> = match self.kind {
            SlotKind::Number { min, max, is_angle } => {
                let (low, high) = match (min, max, is_angle) {
                    (Some(low), Some(high), _) => (low, high),
                    (Some(low), None, _) => (low, low + 4.0),
                    (None, Some(high), _) => (high - 4.0, high),
                    (None, None, true) => (-7.0, 7.0),
                    (None, None, false) => (-3.0, 3.0),
                };
                shares.iter().map(|share| low + (high - low) * share).collect()
            }
            SlotKind::Whole { min, max } => {
                vec![(min + (max - min + 1.0) * shares[0]).floor().min(max)]
            }
            SlotKind::Switch => vec![f64::from(u8::from(shares[0] >= 0.5))],
            SlotKind::Color => shares.to_vec(),
            SlotKind::Composite => {
                let alpha = (1.5 * shares[3]).min(1.0);
                vec![alpha * shares[0], alpha * shares[1], alpha * shares[2], alpha]
            }
            SlotKind::Unit => direction(shares[0], shares[1]).to_array().to_vec(),
            SlotKind::Direction => {
                let length = if shares[2] < 0.5 { 1.0 } else { 0.5 + shares[2] };
                (length * direction(shares[0], shares[1])).to_array().to_vec()
            }
            SlotKind::Rotation => rotation([shares[0], shares[1], shares[2]]),
            SlotKind::HalfAngle => half_angle(PI * shares[0]),
            SlotKind::Kappa => vec![120.0 * shares[0] - 60.0],
            // Rims stretch places by up to eight times.
            SlotKind::Stretch => {
                stretch((4.0 * shares[0] - 2.0).exp2(), (3.0 * shares[1]).exp2(), PI * shares[2])
            }
        };
        numbers.into_iter().map(held).collect()
    }

    /// Numbers at which a node may go wrong.
    pub fn extreme(&self, random: &mut Random) -> Vec<f64> {
        let most = self.most;
        let mut edge = |random: &mut Random| random.pick(&EDGES).clamp(-most, most);
        let numbers: Vec<f64> = match self.kind {
            SlotKind::Number { min, max, is_angle } => {
                let one = edge(random);
                let is_same = random.chance(0.3);
                (0..self.width)
                    .map(|_| {
                        if is_same {
                            one
                        } else {
                            extreme_number(min, max, is_angle, random, &mut edge)
                        }
                    })
                    .collect()
            }
            SlotKind::Whole { min, max } => {
                vec![random.pick(&[
                    min,
                    max,
                    min - 1.0,
                    max + 1.0,
                    0.0,
                    -16_777_216.0,
                    16_777_216.0,
                ])]
            }
            SlotKind::Switch => vec![f64::from(u8::from(random.chance(0.5)))],
            SlotKind::Color | SlotKind::Composite => {
                let is_wild = random.chance(0.3);
                let flat = [0.0, 1.0, 0.5, 0.25, 1e-7, 1.0 - 6e-8, 1e-40];
                (0..self.width)
                    .map(|_| if is_wild { edge(random) } else { random.pick(&flat) })
                    .collect()
            }
            SlotKind::Unit => special_direction(random).to_array().to_vec(),
            SlotKind::Direction => {
                let v = special_direction(random);
                let length = random.pick(&[
                    1.0,
                    0.95,
                    1.0 + 1e-6,
                    3.0,
                    1e-3,
                    1e-12,
                    1e-25,
                    1e-32,
                    1e-40,
                    1e12,
                    1e25,
                    1e35,
                    0.0,
                ]);
                (length * v).to_array().map(|x| x.clamp(-most, most)).to_vec()
            }
            SlotKind::Rotation => {
                let half_turn = std::f64::consts::FRAC_1_SQRT_2;
                let rotations = [
                    [0.0, 0.0, 0.0, 1.0],
                    [1.0, 0.0, 0.0, 0.0],
                    [half_turn, 0.0, 0.0, half_turn],
                    [0.0, 1e-4, 0.0, 1.0],
                ];
                random.pick(&rotations).to_vec()
            }
            SlotKind::HalfAngle => half_angle(random.pick(&ANGLES).clamp(0.0, PI)),
            SlotKind::Kappa => vec![random.pick(&[
                0.0,
                -0.0,
                1e-40,
                1e-7,
                0.0625,
                50.0,
                1e4,
                2e4,
                -1e30,
                1e38,
                f64::INFINITY,
                -f64::INFINITY,
                f64::NAN,
            ])],
            SlotKind::Stretch if random.chance(0.5) => {
                let size = random.pick(&[1e-10, 1e-3, 0.5, 1.0, 2.0, 1e3, 1e10]);
                stretch(size, random.pick(&[1.0, 1.0 + 1e-6, 8.0, 30.0, 1e4]), random.pick(&ANGLES))
            }
            SlotKind::Stretch => (0..3).map(|_| edge(random)).collect(),
        };
        numbers.into_iter().map(held).collect()
    }

    /// A step from these numbers: small or large, of one number or of all.
    pub fn step(&self, from: &[f64], random: &mut Random) -> Vec<f64> {
        let size = 10_f64.powf(random.between(-7.5, 0.0));
        let one = random.index(from.len());
        let is_one = random.chance(0.5);
        let moved: Vec<f64> = match self.kind {
            SlotKind::Switch => vec![f64::from(u8::from(random.chance(0.5)))],
            SlotKind::Whole { min, max } => {
                vec![(from[0] + random.pick(&[-1.0, 1.0, 0.0])).clamp(min, max)]
            }
            _ => {
                let shift = |(index, x): (usize, &f64)| {
                    let by = size
                        * random.between(-1.0, 1.0)
                        * x.abs().max(if random.chance(0.5) { 1.0 } else { 1e-7 });
                    if is_one && index != one { *x } else { x + by }
                };
                from.iter().enumerate().map(shift).collect()
            }
        };
        let numbers = match self.kind {
            SlotKind::Unit => unit(&moved),
            SlotKind::HalfAngle => half_angle((2.0 * moved[0].atan2(moved[1])).clamp(0.0, PI)),
            SlotKind::Color | SlotKind::Composite
                if from.iter().all(|x| (0.0..=1.0).contains(x)) =>
            {
                moved.iter().map(|x| x.clamp(0.0, 1.0)).collect()
            }
            SlotKind::Number { min, max, .. } => {
                let is_inside =
                    |x: &f64| min.is_none_or(|min| *x >= min) && max.is_none_or(|max| *x <= max);
                let keep = |x: &f64| x.clamp(min.unwrap_or(-f64::MAX), max.unwrap_or(f64::MAX));
                if from.iter().all(is_inside) { moved.iter().map(keep).collect() } else { moved }
            }
            _ => moved,
        };
        let most = self.most;
        numbers
            .into_iter()
            .map(|x| if x.is_finite() { held(x.clamp(-most, most)) } else { x })
            .collect()
    }

    /// True if numbers of this kind may move by a unit in the last place and still be of the kind.
    pub fn is_continuous(&self) -> bool {
        !matches!(self.kind, SlotKind::Switch | SlotKind::Whole { .. })
    }

    /// True if the numbers lie within the documented range.
    pub fn is_ordinary(&self, numbers: &[f64]) -> bool {
        match self.kind {
            SlotKind::Number { min, max, .. } => {
                let (low, high) = (min.unwrap_or(-100.0), max.unwrap_or(100.0));
                numbers.iter().all(|x| (held(low)..=held(high)).contains(x))
            }
            SlotKind::Whole { min, max } => (min..=max).contains(&numbers[0]),
            SlotKind::Color | SlotKind::Composite => {
                numbers.iter().all(|x| (0.0..=1.0).contains(x))
            }
            SlotKind::Direction => (1e-3..=1e3).contains(&DVec3::from_slice(numbers).length()),
            SlotKind::Kappa => numbers[0].abs() <= 1e4,
            SlotKind::Stretch => numbers.iter().all(|x| x.abs() <= 2e3) && is_stretch(numbers),
            SlotKind::Switch | SlotKind::Unit | SlotKind::Rotation | SlotKind::HalfAngle => true,
        }
    }
}

fn extreme_number(
    min: Option<f64>,
    max: Option<f64>,
    is_angle: bool,
    random: &mut Random,
    edge: &mut dyn FnMut(&mut Random) -> f64,
) -> f64 {
    let ends: Vec<f64> = min.into_iter().chain(max).collect();
    if !ends.is_empty() && random.chance(0.5) {
        let end = held(random.pick(&ends));
        return random.pick(&[end, next(end, 1), next(end, -1), end + 1.0, end - 1.0]);
    }
    if is_angle && random.chance(0.7) { random.pick(&ANGLES) } else { edge(random) }
}

/// Products of a place that changes by `size` along the picture, and by `ratio` times as much in
/// the direction `angle`.
fn stretch(size: f64, ratio: f64, angle: f64) -> Vec<f64> {
    let (sin, cos) = angle.sin_cos();
    let [most, least] = [(size * ratio).powi(2), size * size];
    vec![
        most * cos * cos + least * sin * sin,
        (most - least) * sin * cos,
        most * sin * sin + least * cos * cos,
    ]
}

/// True if these products belong to a place that marks can lie on: stretched at most thirty times,
/// as more leaves no digits of an area; and not seen so large that marks are as fine as the place's
/// last digits. Products whose sum is 0 or less count as none.
pub fn is_stretch(numbers: &[f64]) -> bool {
    let [xx, xy, yy] = [numbers[0], numbers[1], numbers[2]];
    let sum = xx + yy;
    sum <= 0.0 || (sum >= 1e-3 && xx > 0.0 && yy > 0.0 && xx * yy - xy * xy >= 1e-3 * sum * sum)
}

/// An axis or a diagonal, or a direction just beside one.
fn special_direction(random: &mut Random) -> DVec3 {
    let axes = [
        DVec3::X,
        DVec3::Y,
        DVec3::Z,
        DVec3::new(1.0, 1.0, 0.0),
        DVec3::new(1.0, 1.0, 1.0),
        DVec3::new(0.0, -1.0, 1.0),
    ];
    let axis = random.sign() * random.pick(&axes);
    let aside = if random.chance(0.5) { 0.0 } else { 10_f64.powf(random.between(-8.0, -1.0)) };
    (axis.normalize() + aside * random.direction()).normalize()
}

/// A rotation from three shares of 1, even among the rotations for even shares (Shoemake 1992).
fn rotation([a, b, c]: [f64; 3]) -> Vec<f64> {
    let (p, q) = ((1.0 - a).sqrt(), a.sqrt());
    vec![p * (TAU * b).sin(), p * (TAU * b).cos(), q * (TAU * c).sin(), q * (TAU * c).cos()]
}

fn half_angle(radians: f64) -> Vec<f64> {
    vec![(0.5 * radians).sin(), (0.5 * radians).cos()]
}

fn unit(v: &[f64]) -> Vec<f64> {
    DVec3::from_slice(v).try_normalize().unwrap_or(DVec3::Z).to_array().to_vec()
}

/// The f32 that is `steps` units in the last place away from `x`; steps from 0 go to the smallest
/// normal number, because smaller numbers may count as 0.
pub fn next(x: f64, steps: i32) -> f64 {
    let x = x as f32;
    if !x.is_finite() {
        return f64::from(x);
    }
    if x.abs() < f32::MIN_POSITIVE {
        return f64::from(f32::MIN_POSITIVE) * f64::from(steps.signum());
    }
    let bits = x.to_bits() as i32;
    let moved = f32::from_bits((bits + if x > 0.0 { steps } else { -steps }) as u32);
    f64::from(if moved.is_finite() { moved } else { x })
}

/// Makes the numbers of slots equal, opposite, or nearly so.
pub fn relate(slots: &[InputSlot], numbers: &mut Numbers, random: &mut Random) {
    let is_vector = |slot: &InputSlot| {
        matches!(slot.kind, SlotKind::Unit | SlotKind::Direction) || slot.width == 3
    };
    let a = random.index(slots.len());
    let like: Vec<usize> = (0..slots.len())
        .filter(|&b| {
            b != a
                && slots[b].width == slots[a].width
                && is_vector(&slots[b]) == is_vector(&slots[a])
        })
        .filter(|&b| {
            slots[a].is_continuous()
                && slots[b].is_continuous()
                && slots[b].kind != SlotKind::HalfAngle
        })
        .collect();
    if like.is_empty() {
        return;
    }
    let b = random.pick(&like);
    let apart = if random.chance(0.2) { 0.0 } else { 10_f64.powf(random.between(-7.0, -3.0)) };
    if is_vector(&slots[a]) {
        let from = DVec3::from_slice(&numbers[a]);
        let near = random.sign() * (from + apart * from.length() * random.direction());
        let near = if slots[b].kind == SlotKind::Unit {
            near.try_normalize().unwrap_or(DVec3::Z)
        } else {
            near
        };
        numbers[b] = near.to_array().map(|x| held(finite(x, slots[b].most))).to_vec();
    } else {
        let sign = if random.chance(0.8) { 1.0 } else { -1.0 };
        numbers[b] = numbers[a]
            .iter()
            .map(|x| held(finite(sign * (x + apart * random.between(-1.0, 1.0)), slots[b].most)))
            .collect();
    }
}

fn finite(x: f64, most: f64) -> f64 {
    if x.is_nan() { 0.0 } else { x.clamp(-most, most) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbors_are_the_next_numbers() {
        assert_eq!(next(1.0, 1), f64::from(1.0_f32.next_up()));
        assert_eq!(next(-1.0, 1), f64::from((-1.0_f32).next_up()));
        assert_eq!(next(1.0, -2), f64::from(1.0_f32.next_down().next_down()));
        assert_eq!(next(0.0, -1), -f64::from(f32::MIN_POSITIVE));
        assert_eq!(next(f64::from(f32::MAX), 1), f64::from(f32::MAX));
    }

    #[test]
    fn every_number_is_one_that_f32_holds() {
        let mut random = Random::new(3);
        let kinds = [
            SlotKind::Number { min: Some(0.0), max: Some(PI), is_angle: true },
            SlotKind::Unit,
            SlotKind::Direction,
            SlotKind::HalfAngle,
            SlotKind::Rotation,
            SlotKind::Color,
            SlotKind::Stretch,
        ];
        for kind in kinds {
            let width = match kind {
                SlotKind::Number { .. } => 1,
                SlotKind::HalfAngle => 2,
                SlotKind::Color | SlotKind::Rotation => 4,
                _ => 3,
            };
            let slot = InputSlot {
                name: "x".into(),
                place: SlotTarget::Value,
                kind,
                width,
                most: f64::from(f32::MAX),
            };
            for _ in 0..200 {
                let shares: Vec<f64> = (0..width).map(|_| random.unit()).collect();
                let ordinary = slot.ordinary(&shares);
                let extreme = slot.extreme(&mut random);
                let moved = slot.step(&ordinary, &mut random);
                for numbers in [&ordinary, &extreme, &moved] {
                    assert_eq!(numbers.len(), width, "{kind:?}");
                    assert!(
                        numbers.iter().all(|x| held(*x) == *x && x.is_finite()),
                        "{kind:?} {numbers:?}"
                    );
                }
                assert!(
                    slot.is_ordinary(&ordinary) || matches!(kind, SlotKind::Number { .. }),
                    "{kind:?} {ordinary:?}"
                );
            }
        }
    }
}
