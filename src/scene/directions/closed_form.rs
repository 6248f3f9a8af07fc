//! Raw weights in closed form: `w_k(x) = a_k + sum over j of c_jk K(x, x_j)`, with `sum over j of
//! c_jk = 0`.

use faer::linalg::solvers::DenseSolveCore;
use faer::{Col, Mat, Side};
use glam::DVec3;

use super::kernel::Kernel;
use super::weights::{SolvedKernel, SumKernel};

/// Greatest error of a raw weight at the keys, where its own key asks for 1 and the others for 0.
/// The smoothstep is flat there, so 3 TOLERANCE^2 of the error is left.
const TOLERANCE: f64 = 1e-5;

/// Raw weights of distinct keys.
#[derive(Clone, Debug)]
pub(super) struct ClosedForm {
    kernel: Kernel,
    centers: Vec<DVec3>,
    /// Constant terms of the weights: a_k.
    constants: Vec<f64>,
    /// Coefficients c_jk: row j holds the factors of the kernel at center j in each weight.
    coefficients: Vec<f64>,
}

impl ClosedForm {
    /// Solves for the weights of unit directions; `None` if they are (nearly) not distinct.
    ///
    /// The conditions `w_k(x_j) = [j = k]` and `sum c = 0` are a saddle-point system. The kernel
    /// plus twice its peak is positive definite (its Legendre coefficients all are positive), and a
    /// constant does not matter to coefficients that sum to 0. So with G that matrix, U its
    /// inverse, u = U 1 and s = 1'u, the solution is C = U - u u' / s and a = u / s: one Cholesky
    /// factorization.
    pub(super) fn solve(kernel: Kernel, centers: &[DVec3]) -> Option<Self> {
        let n = centers.len();
        let kernels = Mat::from_fn(n, n, |i, j| kernel.between(centers[i], centers[j]));
        let shifted = Mat::from_fn(n, n, |i, j| 2.0 * kernel.peak() + kernels[(i, j)]);
        let inverse = shifted.llt(Side::Lower).ok()?.inverse();
        let sums = Col::from_fn(n, |i| (0..n).map(|j| inverse[(i, j)]).sum::<f64>());
        let total = sums.sum();
        // The c and a for any right-hand sides, one side per column.
        let solve = |right: &Mat<f64>| {
            let constants = sums.transpose() * right / total;
            (&inverse * right - &sums * &constants, constants)
        };
        let (mut coefficients, mut constants) = solve(&Mat::identity(n, n));
        // The shift drowned the small kernels of near keys. One step of refinement with the kernels
        // themselves mends that: with 512 keys, each at the merge distance from the next, errors at
        // keys fall from 7e-5 to 6e-7.
        let residual = Mat::from_fn(n, n, |j, k| f64::from(u8::from(j == k)) - constants[k])
            - &kernels * &coefficients;
        let (coefficient_errors, constant_errors) = solve(&residual);
        coefficients += coefficient_errors;
        constants += constant_errors;
        let solved = Self {
            kernel,
            centers: centers.to_vec(),
            constants: (0..n).map(|k| constants[k]).collect(),
            coefficients: (0..n * n).map(|at| coefficients[(at / n, at % n)]).collect(),
        };
        (solved.interpolation_error() < TOLERANCE).then_some(solved)
    }

    /// The function as numbers.
    pub(super) fn solved(&self) -> SolvedKernel {
        let kernel = match self.kernel {
            Kernel::Biharmonic => SumKernel::Biharmonic,
            Kernel::AppendixB => SumKernel::AppendixB,
            Kernel::Distance => SumKernel::Distance,
        };
        let (constants, coefficients) = (self.constants.clone(), self.coefficients.clone());
        SolvedKernel::Sum { kernel, constants, coefficients }
    }

    /// The raw weights at a unit direction, one per center. Raw weights sum to 1, but may leave [0,
    /// 1].
    pub(super) fn raw_into(&self, direction: DVec3, out: &mut [f64]) {
        out.copy_from_slice(&self.constants);
        for (&center, row) in self.centers.iter().zip(self.coefficients.chunks_exact(out.len())) {
            let value = self.kernel.between(direction, center);
            for (weight, coefficient) in out.iter_mut().zip(row) {
                *weight += coefficient * value;
            }
        }
    }

    /// The largest error of a weight at a key; infinite when a weight is not finite.
    fn interpolation_error(&self) -> f64 {
        let mut weights = vec![0.0; self.centers.len()];
        let mut largest = 0.0;
        for (key, &center) in self.centers.iter().enumerate() {
            self.raw_into(center, &mut weights);
            for (other, weight) in weights.iter().enumerate() {
                let error = (weight - f64::from(u8::from(other == key))).abs();
                largest = if error.is_finite() { error.max(largest) } else { f64::INFINITY };
            }
        }
        largest
    }
}

/// Weights that fall with the square of the distance, for sets whose system cannot be solved: 1 at
/// a key, and C1.
pub(super) fn inverse_distance_into(centers: &[DVec3], direction: DVec3, out: &mut [f64]) {
    for (weight, center) in out.iter_mut().zip(centers) {
        // 1e-30 is the least squared distance at which the others' weights are not lost to
        // rounding.
        *weight = 1.0 / (direction - *center).length_squared().max(1e-30);
    }
    let sum: f64 = out.iter().sum();
    out.iter_mut().for_each(|weight| *weight /= sum);
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOTH: [Kernel; 2] = [Kernel::Biharmonic, Kernel::AppendixB];

    #[test]
    fn coincident_keys_have_no_solution() {
        for kernel in BOTH {
            assert!(ClosedForm::solve(kernel, &[DVec3::X, DVec3::X, DVec3::Y]).is_none());
        }
    }

    #[test]
    fn keys_at_the_merge_distance_are_solved_well() {
        // A patch of keys at the least distance that merging leaves, 5 by 5, and some keys far
        // away.
        let near =
            |i: usize| DVec3::new(1.0, 1e-4 * (i % 5) as f64, 1e-4 * (i / 5) as f64).normalize();
        let mut keys: Vec<DVec3> = (0..25).map(near).collect();
        keys.extend([DVec3::Z, DVec3::NEG_Y, DVec3::new(-0.6, 0.8, 0.0)]);
        for kernel in BOTH {
            let solved = ClosedForm::solve(kernel, &keys).unwrap();
            assert!(solved.interpolation_error() < 1e-6, "{:e}", solved.interpolation_error());
        }
    }

    #[test]
    fn two_keys_are_a_scaled_difference_of_kernels() {
        // By symmetry the weight is w_1 = 1/2 + (K(x, x_1) - K(x, x_2)) / (-2 K(x_1, x_2)).
        let (a, b) = (DVec3::X, DVec3::new(0.3, 0.4, -0.5).normalize());
        for kernel in BOTH {
            let solved = ClosedForm::solve(kernel, &[a, b]).unwrap();
            for x in [DVec3::Y, DVec3::new(-0.2, 0.7, 0.1).normalize()] {
                let wanted = 0.5
                    - 0.5 * (kernel.between(x, a) - kernel.between(x, b)) / kernel.between(a, b);
                let mut weights = [0.0; 2];
                solved.raw_into(x, &mut weights);
                assert!(
                    (weights[0] - wanted).abs() < 1e-14
                        && (weights[0] + weights[1] - 1.0).abs() < 1e-14
                );
            }
        }
    }

    #[test]
    fn inverse_distances_interpolate() {
        let keys = [DVec3::X, DVec3::X, DVec3::Y];
        let mut weights = [0.0; 3];
        inverse_distance_into(&keys, DVec3::X, &mut weights);
        assert!((weights[0] - 0.5).abs() < 1e-15 && weights[2] < 1e-15);
        inverse_distance_into(&keys, DVec3::Z, &mut weights);
        assert!(weights.iter().all(|weight| (weight - 1.0 / 3.0).abs() < 1e-15));
    }
}
