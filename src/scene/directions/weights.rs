//! [`KeyWeights`]: one weight per key for any direction.

use chiaro_locale::tr;
use glam::DVec3;

use super::closed_form::{ClosedForm, inverse_distance_into};
use super::icosphere::Icosphere;
use super::kernel::Kernel;
use super::keys::{KeySet, NO_GROUP, unit};
use super::tessellated::{Tessellation, VertexWeights};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::KeyScheme;

/// The weights of keys as a function of direction. Made once for a set of keys, evaluated for every
/// object and frame.
///
/// ```
/// use chiaro_compiler::document::KeyScheme;
/// use chiaro_scene::directions::KeyWeights;
/// use glam::DVec3;
///
/// let (keys, problems) =
///     KeyWeights::new(&[DVec3::Z, DVec3::NEG_Z], KeyScheme::Biharmonic).into_parts();
/// assert!(problems.is_empty());
/// assert_eq!(keys.weights(DVec3::Z), [1.0, 0.0]);
/// assert!((keys.weights(DVec3::X)[0] - 0.5).abs() < 1e-12);
/// ```
#[derive(Clone, Debug)]
pub struct KeyWeights {
    set: KeySet,
    field: WeightFunction,
    space: Space,
}

/// Weights of keys as numbers: what [`KeyWeights`] evaluates.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedWeights {
    /// Function of the distances to the centers.
    pub kernel: SolvedKernel,
    /// Unit directions of the groups of keys, or their places within a cube of side 1.
    pub centers: Vec<DVec3>,
    /// Group of each key, which it shares evenly with the others of the group; `None` for a key
    /// without weight.
    pub groups: Vec<Option<usize>>,
    /// Origin and scale that bring the values of drivers into the cube; `None` for directions.
    pub places: Option<[DVec3; 2]>,
}

/// Raw weights of groups as a function of the distances to their centers.
#[derive(Clone, Debug, PartialEq)]
pub enum SolvedKernel {
    /// All weight to the only group, if there is one.
    Whole,
    /// Inverse squares of the distances, brought to a sum of 1.
    InverseDistance,
    /// A constant and a sum of kernels for each group.
    Sum {
        /// Kernel at a squared chord, and for directions at the squared chord to the antipode.
        kernel: SumKernel,
        /// Constant of each group.
        constants: Vec<f64>,
        /// Coefficients, those of a center's kernel in a row, one for each group.
        coefficients: Vec<f64>,
    },
}

/// Kernel of a sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SumKernel {
    /// Green's function of the squared Laplacian of the sphere (docs/math.md 5).
    Biharmonic,
    /// Green's function of the BADF paper's Appendix B.
    AppendixB,
    /// Minus the distance in space.
    Distance,
}

/// Space that the keys lie in.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Space {
    /// The sphere of all directions.
    Sphere,
    /// The values of one to three drivers, brought into a cube of side 1 by (value - origin) *
    /// scale.
    Places { origin: DVec3, scale: DVec3 },
}

/// Function that gives raw weights to the groups of keys.
#[derive(Clone, Debug)]
enum WeightFunction {
    /// All weight to the only group, if there is one.
    Whole,
    Closed(ClosedForm),
    Mesh(Box<VertexWeights>),
    InverseDistance,
}

impl KeyWeights {
    /// Solves for the weights of keys at `directions` (of any length).
    ///
    /// Keys closer than [`MERGE_ANGLE`](super::MERGE_ANGLE) share one weight equally, so that a
    /// duplicate changes nothing. Keys without a direction, and keys past
    /// [`MAX_KEYS`](super::MAX_KEYS), have weight 0. All of these are reported, as are keys closer
    /// than [`CLOSE_ANGLE`](super::CLOSE_ANGLE); a diagnostic's JSON path starts at the list,
    /// `keys[3].direction`. Should a solve fail, that is reported and simpler weights stand in.
    pub fn new(directions: &[DVec3], scheme: KeyScheme) -> WithWarnings<Self> {
        let (set, mut diagnostics) = KeySet::gather(directions).into_parts();
        let field = match scheme {
            _ if set.centers.len() < 2 => WeightFunction::Whole,
            KeyScheme::Biharmonic => closed(Kernel::Biharmonic, &set, &mut diagnostics),
            KeyScheme::AppendixB => closed(Kernel::AppendixB, &set, &mut diagnostics),
            KeyScheme::Tessellated => meshed(Tessellation::default(), &set, &mut diagnostics),
        };
        WithWarnings::new(Self { set, field, space: Space::Sphere }, diagnostics)
    }

    /// Solves for the weights of keys at places: the values of one to three drivers, 0 where there
    /// are fewer.
    ///
    /// Each axis is scaled by the extent of the keys along it, so that metres and radians go
    /// together. Raw weights use the kernel -|x - y|, the counterpart in space of the sphere's;
    /// along one axis they are straight lines from key to key, so that weights go by a smoothstep
    /// from one key to the next and stay constant beyond the outermost.
    pub fn at_places(places: &[DVec3]) -> WithWarnings<Self> {
        let finite = || places.iter().copied().filter(|place| place.is_finite());
        let origin = finite().reduce(DVec3::min).unwrap_or(DVec3::ZERO);
        let extent = finite().reduce(DVec3::max).unwrap_or(DVec3::ZERO) - origin;
        let scale =
            DVec3::from_array(extent.to_array().map(|x| if x > 0.0 { 1.0 / x } else { 0.0 }));
        let scaled: Vec<DVec3> = places.iter().map(|place| (*place - origin) * scale).collect();
        let (set, mut diagnostics) = KeySet::gather_places(&scaled).into_parts();
        let field = if set.centers.len() < 2 {
            WeightFunction::Whole
        } else {
            closed(Kernel::Distance, &set, &mut diagnostics)
        };
        WithWarnings::new(Self { set, field, space: Space::Places { origin, scale } }, diagnostics)
    }

    /// Weights as of [`KeyWeights::new`] with [`KeyScheme::Tessellated`], on a mesh of one's
    /// choice.
    pub fn tessellated(directions: &[DVec3], tessellation: Tessellation) -> WithWarnings<Self> {
        let (set, mut diagnostics) = KeySet::gather(directions).into_parts();
        let field = if set.centers.len() < 2 {
            WeightFunction::Whole
        } else {
            meshed(tessellation, &set, &mut diagnostics)
        };
        WithWarnings::new(Self { set, field, space: Space::Sphere }, diagnostics)
    }

    /// The solved weights as numbers, for programs that evaluate them without Chiaro; `None` for
    /// weights on a mesh.
    pub fn solved(&self) -> Option<SolvedWeights> {
        let kernel = match &self.field {
            WeightFunction::Whole => SolvedKernel::Whole,
            WeightFunction::Closed(closed) => closed.solved(),
            WeightFunction::InverseDistance => SolvedKernel::InverseDistance,
            WeightFunction::Mesh(_) => return None,
        };
        let group = |&group: &u32| (group != NO_GROUP).then_some(group as usize);
        Some(SolvedWeights {
            kernel,
            centers: self.set.centers.clone(),
            groups: self.set.group_of.iter().map(group).collect(),
            places: match self.space {
                Space::Sphere => None,
                Space::Places { origin, scale } => Some([origin, scale]),
            },
        })
    }

    /// The number of keys, which is also the number of weights.
    pub fn len(&self) -> usize {
        self.set.group_of.len()
    }

    /// True if there are no keys.
    pub fn is_empty(&self) -> bool {
        self.set.group_of.is_empty()
    }

    /// True if any key has a direction. If none has, all weights are 0 and a look's own values
    /// hold.
    pub fn has_weight(&self) -> bool {
        !self.set.centers.is_empty()
    }

    /// The smooth weights before clamping, one per key: raw weights sum to 1, but may leave [0, 1].
    pub fn raw(&self, direction: DVec3) -> Vec<f64> {
        let mut weights = vec![0.0; self.len()];
        self.raw_into(direction, &mut weights);
        weights
    }

    /// The weights, one per key: from 0 to 1, of sum 1, C1 in the direction, 1 at a key and 0 at
    /// the others.
    ///
    /// The direction may be of any length. A direction that is zero or not finite, such as that to
    /// an eye at the object's center, favors no key: all weights are equal.
    pub fn weights(&self, direction: DVec3) -> Vec<f64> {
        let mut weights = vec![0.0; self.len()];
        self.weights_into(direction, &mut weights);
        weights
    }

    /// The weights of [`KeyWeights::raw`], written to `out` without allocating.
    ///
    /// # Panics
    /// If `out` does not hold [`KeyWeights::len`] numbers.
    pub fn raw_into(&self, direction: DVec3, out: &mut [f64]) {
        self.group_raw_into(direction, out);
        self.share_within_groups(out);
    }

    /// The weights of [`KeyWeights::weights`], written to `out` without allocating.
    ///
    /// # Panics
    /// If `out` does not hold [`KeyWeights::len`] numbers.
    pub fn weights_into(&self, direction: DVec3, out: &mut [f64]) {
        self.group_raw_into(direction, out);
        let groups = &mut out[..self.set.centers.len()];
        let mut sum = 0.0;
        for weight in groups.iter_mut() {
            *weight = smoothstep(*weight);
            sum += *weight;
        }
        // Raw weights sum to 1, so with K of them the divisor is at least (3K - 2) / K^2.
        groups.iter_mut().for_each(|weight| *weight /= sum);
        self.share_within_groups(out);
    }

    /// Fills the beginning of `out` with the raw weights of the groups.
    fn group_raw_into(&self, direction: DVec3, out: &mut [f64]) {
        assert_eq!(out.len(), self.len(), "one weight per key");
        let count = self.set.centers.len();
        let groups = &mut out[..count];
        let place = match self.space {
            Space::Sphere => unit(direction),
            // Far beyond all keys weights do not change any more, and digits would be lost.
            Space::Places { origin, scale } => (!direction.is_nan())
                .then(|| {
                    ((direction - origin) * scale).clamp(DVec3::splat(-1e6), DVec3::splat(1e6))
                })
                .filter(|place| place.is_finite()),
        };
        let Some(direction) = place else {
            groups.fill(1.0 / count as f64);
            return;
        };
        match &self.field {
            WeightFunction::Whole => groups.fill(1.0),
            WeightFunction::Closed(closed) => closed.raw_into(direction, groups),
            WeightFunction::Mesh(mesh) => mesh.raw_into(direction, groups),
            WeightFunction::InverseDistance => {
                inverse_distance_into(&self.set.centers, direction, groups);
            }
        }
    }

    /// Replaces the weights of groups by those of keys, in place: a group never comes after its
    /// keys, so going backward no group's weight is overwritten before it is read.
    fn share_within_groups(&self, out: &mut [f64]) {
        for (key, &group) in self.set.group_of.iter().enumerate().rev() {
            out[key] = match group {
                NO_GROUP => 0.0,
                group => out[group as usize] / f64::from(self.set.sizes[group as usize]),
            };
        }
    }
}

/// The smoothstep of `x` clamped to [0, 1].
fn smoothstep(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

fn closed(kernel: Kernel, set: &KeySet, diagnostics: &mut Vec<Diagnostic>) -> WeightFunction {
    if let Some(closed) = ClosedForm::solve(kernel, &set.centers) {
        return WeightFunction::Closed(closed);
    }
    let problem = tr!("the smooth weights of these direction keys cannot be computed");
    diagnostics.push(Diagnostic::warning("unsolvable-keys", problem).json_path("keys").hint(tr!(
        "weights by distance stand in for them; move keys that are close to each other apart"
    )));
    WeightFunction::InverseDistance
}

fn meshed(
    tessellation: Tessellation,
    set: &KeySet,
    diagnostics: &mut Vec<Diagnostic>,
) -> WeightFunction {
    let level = tessellation.level.min(Tessellation::MAX_LEVEL);
    match VertexWeights::solve(tessellation, &set.centers) {
        Ok(mesh) => {
            diagnostics.extend(coarse(level, set));
            WeightFunction::Mesh(Box::new(mesh))
        }
        Err(why) => {
            let problem =
                tr!("the tessellation of level {level} is too coarse for these keys: {why}");
            diagnostics.push(
                Diagnostic::warning("tessellation-too-coarse", problem).json_path("keys").hint(
                    tr!("the closed form of the same energy (`appendix-b`) stands in for it"),
                ),
            );
            closed(Kernel::AppendixB, set, diagnostics)
        }
    }
}

/// A warning if a mesh is too coarse for the keys: only with several edges between two keys does
/// the mesh show the shape of their weights.
fn coarse(level: u32, set: &KeySet) -> Option<Diagnostic> {
    let resolved = 5.0 * Icosphere::edge_angle(level);
    let (a, b, angle) = set.closest_pair().filter(|(_, _, angle)| *angle < resolved)?;
    let (degrees, resolved) = (angle.to_degrees(), resolved.to_degrees());
    let problem = tr!("`keys[{a}]` and `keys[{b}]` are {degrees:.1} degrees apart, \
         and a tessellation of level {level} is accurate from {resolved:.0}");
    Some(
        Diagnostic::note("keys-near-mesh-size", problem)
            .json_path("keys")
            .hint(tr!("`appendix-b` has no such limit")),
    )
}
