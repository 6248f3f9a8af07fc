//! The two kernels of the closed forms: Green's functions of fourth-order operators on the unit
//! sphere.
//!
//! With y = |a - b|^2 / 4 (from 0 where the directions agree to 1 where they are opposite) and P_l
//! the Legendre polynomials at 1 - 2y, a kernel is `sum over l >= 1 of (2l+1) / s(l) P_l`, where s
//! is the operator's spectrum:
//! - biharmonic: s = (l(l+1))^2, the square of the Laplacian;
//! - Appendix B: s = l(l+1) (3 l(l+1) - 4), the limit of the paper's energy on ever finer regular
//!   meshes.
//!
//! Both are stored less their value at y = 0. A weight takes kernels with coefficients that sum to
//! 0, so the constant changes nothing, and near-coincident keys keep relative accuracy.

use std::f64::consts::{EULER_GAMMA, PI};
use std::sync::LazyLock;

use glam::DVec3;

/// A Green's function, less its value at distance 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kernel {
    Biharmonic,
    AppendixB,
    /// The distance, negated, between points of a cube of side 1: in space the biharmonic Green's
    /// function.
    Distance,
}

impl Kernel {
    /// The kernel between two unit directions: 0 where they agree, negative elsewhere.
    pub(super) fn between(self, a: DVec3, b: DVec3) -> f64 {
        if self == Self::Distance {
            return -a.distance(b);
        }
        let y = 0.25 * (a - b).length_squared();
        if y <= 0.5 { self.near(y) } else { self.far(0.25 * (a + b).length_squared()) }
    }

    /// The sum of the Legendre series at distance 0: the value that was subtracted, and the largest
    /// value of the series.
    pub(super) fn peak(self) -> f64 {
        match self {
            Self::Biharmonic => 1.0,
            Self::AppendixB => APPENDIX_B.at_zero + 3.0 / 16.0,
            // The cube's diagonal: a shift that far above all distances makes their matrix positive
            // definite.
            Self::Distance => 3.0_f64.sqrt(),
        }
    }

    /// The kernel at y in [0, 1/2], exact to a few units in the last place, also at y = 0 and for
    /// subnormals.
    fn near(self, y: f64) -> f64 {
        if y <= 0.0 {
            return 0.0;
        }
        match self {
            Self::Biharmonic => {
                let z = -(-y).ln_1p();
                y.ln() * z - dilogarithm(z)
            }
            Self::AppendixB => APPENDIX_B.near(y),
            Self::Distance => -2.0 * y.sqrt(),
        }
    }

    /// The kernel at 1 - t, t in [0, 1/2]: on the far side of the sphere, where the kernel is
    /// smooth.
    fn far(self, t: f64) -> f64 {
        let t = t.clamp(0.0, 0.5);
        match self {
            // Euler's reflection turns -ln(y) ln(1-y) - Li2(y) into this.
            Self::Biharmonic => dilogarithm(-(-t).ln_1p()) - PI * PI / 6.0,
            Self::AppendixB => APPENDIX_B.far(t),
            Self::Distance => -2.0 * (1.0 - t).sqrt(),
        }
    }
}

/// Li2(x) for x in [0, 1/2], given z = -ln(1 - x): the series in z with Bernoulli numbers, B_n
/// z^(n+1) / (n+1)!.
fn dilogarithm(z: f64) -> f64 {
    /// B_2n / (2n+1)! for n from 1; the next term is below 1e-18.
    const COEFFICIENTS: [f64; 8] = [
        1.0 / 36.0,
        -1.0 / 3600.0,
        1.0 / 211_680.0,
        -1.0 / 10_886_400.0,
        5.0 / 66.0 / 39_916_800.0,
        -691.0 / 2730.0 / 6_227_020_800.0,
        7.0 / 6.0 / 1_307_674_368_000.0,
        -3617.0 / 510.0 / 355_687_428_096_000.0,
    ];
    let square = z * z;
    z - 0.25 * square + z * square * horner(&COEFFICIENTS, square)
}

/// The polynomial `coefficients[0] + coefficients[1] x + ...`, by Horner's scheme.
fn horner(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// Number of terms of the hypergeometric series: the next term, at 1/2, is below 1e-18.
const TERMS: usize = 54;

/// Numbers of the kernel of Appendix B, for programs that evaluate it without Chiaro: the terms
/// without and with the digamma function, the factor of the far series, and the value at 0.
pub fn appendix_b_series() -> ([&'static [f64]; 2], [f64; 2]) {
    let kernel = &*APPENDIX_B;
    ([&kernel.series, &kernel.with_psi], [kernel.factor, kernel.at_zero])
}

static APPENDIX_B: LazyLock<AppendixB> = LazyLock::new(AppendixB::new);

/// Series of `[1 + ln y - pi / sin(nu pi) 2F1(-nu, nu+1; 1; 1-y)] / 4` with nu (nu+1) = 4/3.
///
/// At y = 0 the logarithm of 2F1 cancels ln y, so near 0 the series about the singularity is used,
/// with the cancellation done on paper: `4 K = 1 + h_0 + sum over n >= 1 of t_n (h_n - ln y) y^n`,
/// where t_n = (-nu)_n (nu+1)_n / n!^2 and h_n = 2 psi(n+1) - psi(n-nu) - psi(n+nu+1).
struct AppendixB {
    /// Coefficients t_n for n from 0.
    series: [f64; TERMS],
    /// Products t_n h_n for n from 0.
    with_psi: [f64; TERMS],
    /// The factor pi / sin(nu pi).
    factor: f64,
    /// Value of the unshifted kernel at y = 0.
    at_zero: f64,
}

impl AppendixB {
    fn new() -> Self {
        let nu = 0.5 * ((19.0f64 / 3.0).sqrt() - 1.0);
        let psi = digamma(nu + 1.0);
        // psi(-nu) by reflection; psi(1) is minus Euler's constant.
        let mut h = -2.0 * EULER_GAMMA - 2.0 * psi - PI / (PI * nu).tan();
        let at_zero = 0.25 * (1.0 + h);
        let mut t = 1.0;
        let (mut series, mut with_psi) = ([0.0; TERMS], [0.0; TERMS]);
        for n in 0..TERMS {
            series[n] = t;
            with_psi[n] = t * h;
            let (n, next) = (n as f64, n as f64 + 1.0);
            t *= (n - nu) * (n + nu + 1.0) / (next * next);
            h += 2.0 / next - 1.0 / (n - nu) - 1.0 / (n + nu + 1.0);
        }
        Self { series, with_psi, factor: PI / (PI * nu).sin(), at_zero }
    }

    fn near(&self, y: f64) -> f64 {
        0.25 * y * (horner(&self.with_psi[1..], y) - y.ln() * horner(&self.series[1..], y))
    }

    fn far(&self, t: f64) -> f64 {
        0.25 * (1.0 + (-t).ln_1p() - self.factor * horner(&self.series, t)) - self.at_zero
    }
}

/// psi(x) for x > 0: shifted to where the asymptotic series is exact to rounding.
fn digamma(x: f64) -> f64 {
    let (mut x, mut shift) = (x, 0.0);
    while x < 16.0 {
        shift += 1.0 / x;
        x += 1.0;
    }
    let inverse = 1.0 / (x * x);
    let tail = [1.0 / 12.0, -1.0 / 120.0, 1.0 / 252.0, -1.0 / 240.0, 1.0 / 132.0, -691.0 / 32760.0];
    x.ln() - 0.5 / x - inverse * horner(&tail, inverse) - shift
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOTH: [Kernel; 2] = [Kernel::Biharmonic, Kernel::AppendixB];

    fn at(kernel: Kernel, y: f64) -> f64 {
        if y <= 0.5 { kernel.near(y) } else { kernel.far(1.0 - y) }
    }

    /// The Legendre series itself, less its sum at y = 0, summed over `count` degrees by the
    /// three-term recurrence.
    fn legendre_series(kernel: Kernel, y: f64, count: u32) -> f64 {
        let x = 1.0 - 2.0 * y;
        let (mut before, mut now, mut sum) = (1.0, x, 0.0);
        for l in 1..=count {
            let l = f64::from(l);
            let laplacian = l * (l + 1.0);
            let spectrum = match kernel {
                Kernel::Biharmonic => laplacian * laplacian,
                Kernel::AppendixB => laplacian * (3.0 * laplacian - 4.0),
                Kernel::Distance => unreachable!("it is none of the sphere's"),
            };
            sum += (2.0 * l + 1.0) / spectrum * now;
            (before, now) = (now, ((2.0 * l + 1.0) * x * now - l * before) / (l + 1.0));
        }
        sum - kernel.peak()
    }

    /// The largest difference between closed form and series over y from 1e-5 to 1 - 1e-9.
    fn series_error(kernel: Kernel) -> f64 {
        let ys = [
            1e-5,
            1e-4,
            1e-3,
            0.01,
            0.1,
            0.25,
            0.4,
            0.4999,
            0.5,
            0.5001,
            0.6,
            0.75,
            0.9,
            0.99,
            0.999,
            1.0 - 1e-9,
        ];
        ys.iter()
            .map(|&y| (at(kernel, y) - legendre_series(kernel, y, 200_000)).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn closed_forms_are_the_sums_of_their_legendre_series() {
        for kernel in BOTH {
            let error = series_error(kernel);
            assert!(error < 1e-12, "{kernel:?}: {error:e}");
        }
    }

    #[test]
    fn the_peak_is_the_sum_of_the_series_at_zero() {
        // At y = 0 every P_l is 1, and the tail past L is 1/L^2 (or a third of it) to relative 1/L.
        let series = |kernel| legendre_series(kernel, 0.0, 100_000) + kernel.peak();
        assert!((series(Kernel::Biharmonic) + 1e-10 - Kernel::Biharmonic.peak()).abs() < 1e-13);
        assert!((series(Kernel::AppendixB) + 1e-10 / 3.0 - Kernel::AppendixB.peak()).abs() < 1e-13);
    }

    #[test]
    fn values_agree_with_forty_digit_arithmetic() {
        // Computed with 60 digits from the polylogarithm and from 2F1 itself, then rounded.
        let known = [
            (1e-18, -4.244_653_167_389_282_5e-17, -1.528_149_145_695_315_7e-17),
            (1e-9, -2.172_326_584_755_804_5e-8, -8.373_736_179_172_198e-9),
            (1e-3, -0.007_911_461_572_108_694, -0.003_768_999_855_205_402_4),
            (0.25, -0.666_464_673_917_920_3, -0.490_954_918_862_641_4),
            (0.5, -1.062_693_540_383_213_9, -0.876_817_194_350_694_3),
            (0.75, -1.377_281_427_765_494, -1.226_167_572_392_163_3),
            (0.999, -1.643_933_816_737_052_8, -1.551_589_232_366_943_3),
            (1.0, -1.644_934_066_848_226_4, -1.552_860_527_413_735_2),
        ];
        for (y, biharmonic, appendix_b) in known {
            assert!((at(Kernel::Biharmonic, y) / biharmonic - 1.0).abs() < 2e-15, "{y:e}");
            assert!((at(Kernel::AppendixB, y) / appendix_b - 1.0).abs() < 4e-15, "{y:e}");
        }
        assert!((APPENDIX_B.at_zero - 0.661_985_674_241_661_6).abs() < 2e-15);
    }

    #[test]
    fn the_two_branches_meet_and_the_ends_are_finite() {
        for kernel in BOTH {
            assert!((kernel.near(0.5) - kernel.far(0.5)).abs() < 1e-15, "{kernel:?}");
            assert_eq!(kernel.near(0.0), 0.0);
            assert!(kernel.near(5e-324).is_finite() && kernel.near(1e-300) < 0.0);
            assert!(kernel.between(DVec3::X, DVec3::NEG_X).is_finite());
        }
    }

    #[test]
    fn digamma_at_known_points() {
        assert!((digamma(1.0) + EULER_GAMMA).abs() < 1e-15);
        assert!((digamma(0.5) + EULER_GAMMA + 2.0 * 2f64.ln()).abs() < 1e-15);
    }
}
