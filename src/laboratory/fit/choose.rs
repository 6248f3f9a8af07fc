//! Choice of the pixels that a search looks at: some spread evenly, and some where most is missing.

use std::collections::{HashMap, HashSet};

use chiaro_locale::tr;
use glam::DVec3;

use super::model::{FitShot, Model};
use super::target::{FitTarget, PixelGoal};
use crate::diag::Diagnostic;
use crate::document::{Endpoint, Graph, Look, Node, Value, Values, Wire};
use crate::frame::Setup;

/// Largest number of painted pixels that are used; more are thinned, as the others say the same.
pub(super) const MAX_PIXELS: usize = 4096;

/// Goals of the painted pixels, thinned evenly if there are very many.
pub(super) fn thinned(target: &FitTarget) -> Vec<PixelGoal> {
    evenly(target.goals.len(), MAX_PIXELS).into_iter().map(|index| target.goals[index]).collect()
}

/// At most `most` of `count` indices, evenly spread; all indices if there are fewer.
pub(super) fn evenly(count: usize, most: usize) -> Vec<usize> {
    if count <= most { (0..count).collect() } else { (0..most).map(|i| i * count / most).collect() }
}

/// At most `most` indices, in order: half of them evenly spread, half with the largest `missing`.
pub(super) fn telling(missing: &[f64], most: usize) -> Vec<usize> {
    if missing.len() <= most {
        return (0..missing.len()).collect();
    }
    let mut chosen = vec![false; missing.len()];
    evenly(missing.len(), most / 2).into_iter().for_each(|index| chosen[index] = true);
    let mut order: Vec<usize> = (0..missing.len()).filter(|&index| !chosen[index]).collect();
    order.sort_by(|&a, &b| missing[b].total_cmp(&missing[a]).then(a.cmp(&b)));
    // Every other index of the largest, so that one blot does not take all places.
    order.into_iter().step_by(2).take(most - most / 2).for_each(|index| chosen[index] = true);
    (0..missing.len()).filter(|&index| chosen[index]).collect()
}

/// The goals of those `pixels` that can be compared.
///
/// # Errors
/// `fit-target`: no pixel has a goal.
pub(super) fn goals_of(
    pixels: &[[u32; 2]],
    goals: &[PixelGoal],
) -> Result<Vec<PixelGoal>, Vec<Diagnostic>> {
    let by_pixel: HashMap<[u32; 2], &PixelGoal> =
        goals.iter().map(|goal| (goal.pixel, goal)).collect();
    let found: Vec<PixelGoal> =
        pixels.iter().filter_map(|pixel| by_pixel.get(pixel).map(|goal| **goal)).collect();
    if found.is_empty() {
        let message = tr!("no painted pixel lies within an object that wears the look");
        return Err(vec![Diagnostic::error("fit-target", message).hint(tr!(
            "paint over the picture as `chiaro render` makes it, at the same size and with the \
             same mesh and camera"
        ))]);
    }
    Ok(found)
}

/// The pixels of the goals.
pub(super) fn pixels_of(goals: &[PixelGoal]) -> HashSet<[u32; 2]> {
    goals.iter().map(|goal| goal.pixel).collect()
}

/// Surface that the reference sees at the pixels that can be compared.
#[derive(Debug)]
pub(super) struct SurfaceSamples {
    /// The normal and the mirrored view of each pixel, in world space.
    pub(super) directions: Vec<[DVec3; 2]>,
    /// Column and row of each pixel.
    pub(super) pixels: Vec<[u32; 2]>,
}

impl SurfaceSamples {
    /// The surface at the chosen pixels of a picture.
    ///
    /// # Errors
    /// Looks that the interpreter cannot run.
    pub(super) fn new(
        shot: &FitShot<'_>,
        chosen: &HashSet<[u32; 2]>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let setup = wearing(shot, showing("normal", Values::new()));
        let model = Model::new(&FitShot { setup: &setup, ..*shot }, Vec::new(), chosen)?;
        let normals = model.colors(&model.sheet(&model.all()), &[]).map_err(|one| vec![one])?;
        let directions = normals.into_iter().zip(&model.pixels).map(|(normal, pixel)| {
            let (normal, view) =
                (DVec3::from(normal).normalize_or(DVec3::Z), model.toward_viewer(*pixel));
            [normal, (2.0 * normal.dot(view) * normal - view).normalize_or(normal)]
        });
        let directions = directions.collect();
        let pixels = model.pixels;
        Ok(Self { directions, pixels })
    }
}

/// Positions of the surface at the chosen pixels, in the object's own space, by column and row.
///
/// # Errors
/// Looks that the interpreter cannot run.
pub(super) fn positions_of(
    shot: &FitShot<'_>,
    chosen: &HashSet<[u32; 2]>,
) -> Result<HashMap<[u32; 2], DVec3>, Vec<Diagnostic>> {
    let space = Values::from_iter([("space".into(), Value::Text("object".to_owned()))]);
    let setup = wearing(shot, showing("position", space));
    let model = Model::new(&FitShot { setup: &setup, ..*shot }, Vec::new(), chosen)?;
    let found = model.colors(&model.sheet(&model.all()), &[]).map_err(|one| vec![one])?;
    Ok(model.pixels.iter().copied().zip(found.into_iter().map(DVec3::from)).collect())
}

/// A look that shows the output of a node of this kind, with these values.
fn showing(kind: &str, values: Values) -> Look {
    let node = |kind: &str, values| Node { kind: kind.to_owned(), values, ..Node::default() };
    let wire = Wire { from: Endpoint::new("shown", ""), to: Endpoint::new("output", "color") };
    let nodes =
        [("shown".into(), node(kind, values)), ("output".into(), node("output", Values::new()))]
            .into_iter()
            .collect();
    Look { graph: Graph { nodes, wires: vec![wire], ..Graph::default() }, ..Look::default() }
}

/// The setup of the shot with another look in place of the fitted one.
pub(super) fn wearing(shot: &FitShot<'_>, look: Look) -> Setup {
    let mut setup = shot.setup.clone();
    setup.looks[shot.look].look = look;
    setup
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_tells_most_is_looked_at_and_the_rest_is_not_forgotten() {
        let mut missing = vec![0.0; 1000];
        missing[700..740].fill(1.0);
        let chosen = telling(&missing, 40);
        assert_eq!(chosen.len(), 40);
        assert!(
            chosen.iter().filter(|&&index| (700..740).contains(&index)).count() >= 19,
            "{chosen:?}"
        );
        assert!(chosen.iter().filter(|&&index| index < 700).count() >= 13, "{chosen:?}");
        assert_eq!(telling(&missing[..10], 40).len(), 10);
    }
}
