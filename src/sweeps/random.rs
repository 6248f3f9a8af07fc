//! Pseudorandom and evenly spread numbers, the same in every run.

use glam::DVec3;

/// Pseudorandom numbers by SplitMix64 (Steele, Lea and Flood 2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A generator that yields the same numbers for the same seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A generator whose seed is the FNV-1a hash of `words`.
    pub fn of(words: &str) -> Self {
        Self(words.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        }))
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// An index below `count`, which is at least 1.
    pub fn index(&mut self, count: usize) -> usize {
        (self.bits() % count.max(1) as u64) as usize
    }

    /// An item of a list that is not empty.
    pub fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.index(items.len())]
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// 1 or -1, equally likely.
    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }

    /// A direction, even on the sphere.
    pub fn direction(&mut self) -> DVec3 {
        direction(self.unit(), self.unit())
    }
}

/// A direction from two shares of 1, even on the sphere for even shares.
pub fn direction(height: f64, turn: f64) -> DVec3 {
    let z = 2.0 * height - 1.0;
    let (sin, cos) = (std::f64::consts::TAU * turn).sin_cos();
    let r = (1.0 - z * z).max(0.0).sqrt();
    DVec3::new(r * cos, r * sin, z)
}

/// Points that fill a cube of any dimension evenly: multiples of powers of the generalized golden
/// ratio (Roberts 2018).
#[derive(Clone, Debug)]
pub struct EvenPoints {
    steps: Vec<f64>,
}

impl EvenPoints {
    /// Points in a cube of this many dimensions.
    pub fn new(dimensions: usize) -> Self {
        // The root above 1 of x^(d + 1) = x + 1, by iteration, which converges from anywhere above
        // 1.
        let exponent = 1.0 / (dimensions as f64 + 1.0);
        let root = (0..64).fold(2.0_f64, |x, _| (1.0 + x).powf(exponent));
        Self { steps: (1..=dimensions).map(|power| root.powi(-(power as i32))).collect() }
    }

    /// The point of this index, each coordinate in [0, 1).
    pub fn point(&self, index: usize) -> Vec<f64> {
        self.steps.iter().map(|step| (0.5 + step * (index + 1) as f64).fract()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn even_points_leave_no_gap() {
        let even = EvenPoints::new(2);
        let mut cells = [0; 64];
        for index in 0..640 {
            let point = even.point(index);
            cells[(8.0 * point[0]) as usize * 8 + (8.0 * point[1]) as usize] += 1;
        }
        assert!(cells.iter().all(|count| (7..=13).contains(count)), "{cells:?}");
    }
}
