//! Beam of a search: the few of many stacks of layers that the search goes on with.

use super::lit::LayerLight;
use super::solve::Minimum;
use super::stack::FitLayer;

/// Layers with their distance from the target.
pub(super) type FitStack = Minimum<Vec<FitLayer>>;

/// Width that a search begins with, and the wider one that is tried if the first does not come
/// near.
pub(super) const WIDTHS: [Width; 2] =
    [Width { beam: 3, beginnings: 8, lights: 64 }, Width { beam: 6, beginnings: 20, lights: 160 }];

/// Extent of a search.
#[derive(Clone, Copy, Debug)]
pub(super) struct Width {
    /// Number of stacks that go on to the next layer.
    pub(super) beam: usize,
    /// Number of initial values of a layer that descend.
    pub(super) beginnings: usize,
    /// Number of lights from everywhere.
    pub(super) lights: usize,
}

/// The best stacks; of those whose layers have much the same light only the first two.
pub(super) fn apart(found: Vec<(LayerLight, FitStack)>, most: usize) -> Vec<FitStack> {
    let mut kept: Vec<(LayerLight, FitStack)> = Vec::new();
    for (lit, stack) in found {
        let is_near = |(other, _): &(LayerLight, FitStack)| {
            other.kind == lit.kind && other.direction.dot(lit.direction) > 0.9
        };
        if kept.iter().filter(|other| is_near(other)).count() < 2 {
            kept.push((lit, stack));
        }
        if kept.len() >= most {
            break;
        }
    }
    kept.into_iter().map(|(_, stack)| stack).collect()
}

/// The best stacks, of equal ones only the first.
pub(super) fn best_of(mut found: Vec<FitStack>, most: usize) -> Vec<FitStack> {
    found.sort_by(|a, b| a.error.total_cmp(&b.error));
    found.dedup_by(|b, a| {
        (b.error - a.error).abs() <= 1e-3 * a.error && b.point.len() == a.point.len()
    });
    found.truncate(most);
    found
}
