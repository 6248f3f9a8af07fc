//! A blob: balls run together, as in figure 2 of the BADF paper.

use super::nets::Cells;
use super::sculpture::{Sculpture, ball};

/// Size of the grid's cells. The shape's radius is about 1.2.
pub(super) const CELLS: Cells = Cells::even(0.0225);

/// The blob: convex lobes with saddles and hollows between them.
pub(super) fn sculpture() -> Sculpture {
    let balls = [
        ([0.0, 0.0, 0.0], 0.50),
        ([-0.50, 0.36, 0.16], 0.33),
        ([0.46, 0.44, -0.02], 0.37),
        ([0.56, -0.28, 0.30], 0.30),
        ([-0.28, -0.52, 0.28], 0.40),
        ([-0.06, 0.20, 0.56], 0.24),
        ([0.04, 0.88, 0.10], 0.22),
        ([-0.86, -0.14, -0.10], 0.23),
        ([0.16, -0.42, -0.56], 0.33),
        ([-0.32, 0.40, -0.54], 0.31),
        ([0.78, 0.02, -0.46], 0.22),
        ([0.34, -0.86, 0.10], 0.22),
    ];
    let mut clay = Sculpture::default();
    for (center, radius) in balls {
        clay.add(0.5, ball(center, radius));
    }
    clay
}
