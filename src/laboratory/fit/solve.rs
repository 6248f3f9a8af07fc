//! Damped least squares (Levenberg 1944, Marquardt 1963) on derivatives by finite differences,
//! within bounds.
//!
//! Coordinates at a bound that a step would leave are held for the step. Columns of the Jacobian
//! are computed side by side on all cores; each is independent of the others, so that the result is
//! the same on any number of cores.

use chiaro_locale::tr;
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use crate::diag::Diagnostic;
use crate::progress::Progress;

/// Step of finite differences: it leaves seven digits of an f64 for the derivative.
const STEP: f64 = 1e-6;
/// Number of times a step may be shortened.
const TRIES: usize = 8;

/// A problem of least squares: residuals that depend on a point.
pub(super) trait LeastSquares: Sync {
    /// The unknowns of the problem.
    type Point: Clone + Send + Sync;

    /// Room of a point along each coordinate, down and up.
    fn room(&self, point: &Self::Point) -> Vec<[f64; 2]>;

    /// The point moved by `by` along each coordinate.
    fn moved(&self, point: &Self::Point, by: &[f64]) -> Result<Self::Point, Diagnostic>;

    /// Residuals at a point.
    fn residuals(&self, point: &Self::Point) -> Result<Vec<f64>, Diagnostic>;

    /// Number of steps that a Jacobian is updated for, by the changes that the steps show, before
    /// it is computed anew.
    fn patience(&self) -> usize;
}

/// Result of a descent.
#[derive(Clone, Debug)]
pub(super) struct Minimum<P> {
    pub(super) point: P,
    /// Sum of squared residuals.
    pub(super) error: f64,
}

/// Conditions that end a descent.
#[derive(Clone, Copy, Debug)]
pub(super) struct StopRule {
    /// Largest number of steps.
    pub(super) steps: usize,
    /// Sum of squared residuals that is small enough.
    pub(super) error: f64,
}

/// Descends from `start`.
///
/// A stopped descent returns the point that it has reached.
///
/// # Errors
/// Points that cannot be evaluated.
pub(super) fn descend<P: LeastSquares>(
    problem: &P,
    start: P::Point,
    until: StopRule,
    progress: &Progress,
) -> Result<Minimum<P::Point>, Diagnostic> {
    let mut point = start;
    let mut residuals = problem.residuals(&point)?;
    let mut error = squared(&residuals);
    let mut damping = 1e-2;
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let (mut age, mut slow) = (0, 0);
    for _ in 0..until.steps {
        if error <= until.error || slow >= 3 || progress.is_stopped() {
            break;
        }
        let room = problem.room(&point);
        if columns.is_empty() {
            (columns, age) = (jacobian(problem, &point, &room, &residuals)?, 0);
        }
        let normal = Normal::new(&columns, &residuals);
        let before = error;
        for _ in 0..TRIES {
            if progress.is_stopped() {
                return Ok(Minimum { point, error });
            }
            let by = normal.step(damping, &room);
            let next = problem.moved(&point, &by)?;
            let found = problem.residuals(&next)?;
            let sum = squared(&found);
            let is_better = sum < error;
            broyden_update(&mut columns, &by, &residuals, &found);
            if is_better {
                (point, residuals, error) = (next, found, sum);
                damping = (damping * 0.2).max(1e-10);
                break;
            }
            damping *= 5.0;
            // A Jacobian that was updated over several steps misled: it is computed anew.
            if age > 0 {
                break;
            }
        }
        age += 1;
        // No step along a fresh Jacobian is better: the point is a minimum.
        if error >= before && age == 1 {
            break;
        }
        // A Jacobian serves as long as it leads down well.
        if error > 0.5 * before || age > problem.patience() {
            columns.clear();
        }
        // Three steps in a row that gain next to nothing end the descent.
        slow = if error > 0.999 * before { slow + 1 } else { 0 };
    }
    Ok(Minimum { point, error })
}

/// Error of a fit that was stopped before it came nearer.
pub(super) fn stopped() -> Diagnostic {
    Diagnostic::error("stopped", tr!("the fit was stopped before it came nearer"))
}

fn squared(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

/// Updates the Jacobian by the change of residuals along a step (Broyden 1965).
fn broyden_update(columns: &mut [Vec<f64>], by: &[f64], before: &[f64], after: &[f64]) {
    let length: f64 = by.iter().map(|x| x * x).sum();
    if length <= 0.0 {
        return;
    }
    for (index, (after, before)) in after.iter().zip(before).enumerate() {
        let told: f64 = columns.iter().zip(by).map(|(column, step)| column[index] * step).sum();
        let surprise = (after - before - told) / length;
        columns.iter_mut().zip(by).for_each(|(column, step)| column[index] += surprise * step);
    }
}

fn jacobian<P: LeastSquares>(
    problem: &P,
    point: &P::Point,
    room: &[[f64; 2]],
    residuals: &[f64],
) -> Result<Vec<Vec<f64>>, Diagnostic> {
    let column = |index: usize| {
        // A coordinate without room above is differentiated downward.
        let step = if room[index][1] < STEP { -STEP } else { STEP };
        let mut by = vec![0.0; room.len()];
        by[index] = step;
        let there = problem.residuals(&problem.moved(point, &by)?)?;
        Ok(there.iter().zip(residuals).map(|(there, here)| (there - here) / step).collect())
    };
    (0..room.len()).into_par_iter().map(column).collect()
}

/// The normal equations of one step.
struct Normal {
    /// Products of the columns with each other.
    products: Vec<Vec<f64>>,
    /// Descent direction: products of the columns with the negative residuals.
    slope: Vec<f64>,
}

impl Normal {
    fn new(columns: &[Vec<f64>], residuals: &[f64]) -> Self {
        let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let row = |i: usize| columns.iter().map(|column| dot(column, &columns[i])).collect();
        Self {
            products: (0..columns.len()).into_par_iter().map(row).collect(),
            slope: columns.iter().map(|column| -dot(column, residuals)).collect(),
        }
    }

    /// The step with a damping, within the room.
    fn step(&self, damping: f64, room: &[[f64; 2]]) -> Vec<f64> {
        let count = self.slope.len();
        let mut held: Vec<Option<f64>> = (0..count)
            .map(|i| {
                let is_flat = self.products[i][i] <= 1e-18;
                let leaves = (room[i][0] > -1e-9 && self.slope[i] < 0.0)
                    || (room[i][1] < 1e-9 && self.slope[i] > 0.0);
                (is_flat || leaves).then_some(0.0)
            })
            .collect();
        // A coordinate that would leave its range goes to the bound, and the others make up for
        // that.
        for _ in 0..=count {
            let step = self.free_step(damping, &held);
            let beyond =
                |i: &usize| held[*i].is_none() && !(room[*i][0]..=room[*i][1]).contains(&step[*i]);
            let Some(first) = (0..count).find(beyond) else { return step };
            held[first] = Some(step[first].clamp(room[first][0], room[first][1]));
        }
        vec![0.0; count]
    }

    fn free_step(&self, damping: f64, held: &[Option<f64>]) -> Vec<f64> {
        let free: Vec<usize> = (0..held.len()).filter(|i| held[*i].is_none()).collect();
        let entry = |i: usize, j: usize| {
            let product = self.products[i][j];
            if i == j { product * (1.0 + damping) + 1e-12 } else { product }
        };
        let mut matrix: Vec<Vec<f64>> =
            free.iter().map(|&i| free.iter().map(|&j| entry(i, j)).collect()).collect();
        let mut right: Vec<f64> = free
            .iter()
            .map(|&i| {
                let known = held
                    .iter()
                    .enumerate()
                    .filter_map(|(j, value)| Some(self.products[i][j] * (*value)?));
                self.slope[i] - known.sum::<f64>()
            })
            .collect();
        solve_in_place(&mut matrix, &mut right);
        let mut step: Vec<f64> = held.iter().map(|value| value.unwrap_or(0.0)).collect();
        free.iter().zip(right).for_each(|(&i, value)| step[i] = value);
        step
    }
}

/// Solves a symmetric, positive system by Cholesky's method; the result takes the place of `right`.
/// Unknowns without weight get 0. The systems here have a few rows and are solved hundreds of
/// thousands of times; a library of large matrices would spend its time on calls.
pub(super) fn solve_in_place(matrix: &mut [Vec<f64>], right: &mut [f64]) {
    let count = right.len();
    for i in 0..count {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - known;
            matrix[i][j] = if i == j {
                // Other rows explain this row wholly, except for rounding.
                if rest > 1e-14 * matrix[i][i].abs() { rest.sqrt() } else { f64::INFINITY }
            } else {
                rest / matrix[j][j]
            };
        }
    }
    for i in 0..count {
        let known: f64 = (0..i).map(|k| matrix[i][k] * right[k]).sum();
        right[i] = (right[i] - known) / matrix[i][i];
    }
    for i in (0..count).rev() {
        let known: f64 = (i + 1..count).map(|k| matrix[k][i] * right[k]).sum();
        right[i] = (right[i] - known) / matrix[i][i];
    }
    right.iter_mut().filter(|x| !x.is_finite()).for_each(|x| *x = 0.0);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rosenbrock's valley as two residuals, within a box.
    struct Valley {
        high: f64,
        patience: usize,
    }

    impl LeastSquares for Valley {
        type Point = [f64; 2];

        fn room(&self, point: &[f64; 2]) -> Vec<[f64; 2]> {
            point.map(|x| [-2.0 - x, self.high - x]).to_vec()
        }

        fn moved(&self, point: &[f64; 2], by: &[f64]) -> Result<[f64; 2], Diagnostic> {
            Ok([0, 1].map(|i| (point[i] + by[i]).clamp(-2.0, self.high)))
        }

        fn residuals(&self, &[x, y]: &[f64; 2]) -> Result<Vec<f64>, Diagnostic> {
            Ok(vec![10.0 * (y - x * x), 1.0 - x])
        }

        fn patience(&self) -> usize {
            self.patience
        }
    }

    #[test]
    fn it_comes_to_the_ground_of_a_bent_valley_or_to_the_bound() {
        let until = StopRule { steps: 200, error: 1e-20 };
        for patience in [0, 3] {
            let valley = Valley { high: 2.0, patience };
            let found = descend(&valley, [-1.2, 1.0], until, &Progress::new()).unwrap();
            assert!(found.point.iter().all(|x| (x - 1.0).abs() < 1e-6), "{found:?}");
        }
        // With x and y at most 1/2 the minimum is at x = 1/2, y = 1/4.
        let found =
            descend(&Valley { high: 0.5, patience: 0 }, [-1.2, 0.4], until, &Progress::new())
                .unwrap();
        assert!(
            (found.point[0] - 0.5).abs() < 1e-6 && (found.point[1] - 0.25).abs() < 1e-6,
            "{found:?}"
        );
    }

    /// A sum of two coordinates that is to be 1; a third that no residual knows.
    struct Tie;

    impl LeastSquares for Tie {
        type Point = [f64; 3];

        fn room(&self, point: &[f64; 3]) -> Vec<[f64; 2]> {
            point.map(|x| [-x, 1.0 - x]).to_vec()
        }

        fn moved(&self, point: &[f64; 3], by: &[f64]) -> Result<[f64; 3], Diagnostic> {
            Ok([0, 1, 2].map(|i| (point[i] + by[i]).clamp(0.0, 1.0)))
        }

        fn residuals(&self, point: &[f64; 3]) -> Result<Vec<f64>, Diagnostic> {
            Ok(vec![point[0] + point[1] - 1.0])
        }

        fn patience(&self) -> usize {
            4
        }
    }

    /// Ties go to what was there: nothing moves that the goals do not ask for.
    #[test]
    fn what_the_goals_cannot_tell_stays() {
        let until = StopRule { steps: 50, error: 0.0 };
        let from = |start| descend(&Tie, start, until, &Progress::new()).unwrap().point;
        assert_eq!(from([0.25, 0.75, 0.3]), [0.25, 0.75, 0.3], "what is met already stays");
        let [a, b, unseen] = from([0.2, 0.4, 0.3]);
        assert_eq!(unseen, 0.3);
        // Of all points that are equally good the one that is near to the beginning is taken.
        assert!((a - 0.4).abs() < 0.02 && (b - 0.6).abs() < 0.02, "{a} and {b}");
    }

    #[test]
    fn once_it_is_stopped_it_stays_where_it_is() {
        let progress = Progress::new();
        progress.stop();
        let until = StopRule { steps: 200, error: 0.0 };
        let found =
            descend(&Valley { high: 2.0, patience: 0 }, [-1.2, 1.0], until, &progress).unwrap();
        assert_eq!(found.point, [-1.2, 1.0]);
    }

    #[test]
    fn a_system_is_solved_and_a_row_without_weight_gives_nothing() {
        let mut matrix = vec![vec![4.0, 2.0, 0.0], vec![2.0, 3.0, 0.0], vec![0.0, 0.0, 0.0]];
        let mut right = vec![8.0, 8.0, 0.0];
        solve_in_place(&mut matrix, &mut right);
        assert!(
            (right[0] - 1.0).abs() < 1e-12 && (right[1] - 2.0).abs() < 1e-12 && right[2] == 0.0,
            "{right:?}"
        );
    }
}
