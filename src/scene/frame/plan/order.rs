//! Order of draws: one look after another, and back to front where that can be seen.
//!
//! A change of the look costs a GPU more than the next mesh of the same look, so draws of one look
//! follow one another. Two draws keep their order where exchanging them could change a pixel: where
//! they may share pixels and one of them may be seen through, and where they may share pixels at
//! the same depth, of which the first drawn is seen. So the picture is, to the bit, that of all
//! draws from back to front.

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;

use super::Draw;
use super::placement::PlacedScene;
use crate::frame::coverage::PixelArea;
use crate::library::Stage;

/// Pairs of draws that are compared, at most, for each draw: where more lie one over another, draws
/// stay in their order.
const MOST_COMPARED: usize = 256;

/// Share of the distance from the eye by which two boxes must lie apart so that depth, an f32,
/// tells their surfaces apart: a thousandth of the far plane is the nearest plane, 2^-24 the step.
const APART: f64 = 1e-4;

/// Place of an object: where its draws may be seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct DrawPlace {
    /// Pixels that may show the object.
    area: PixelArea,
    /// Corners of a box around the object, in world space.
    low: DVec3,
    high: DVec3,
}

impl DrawPlace {
    /// The place of the object of that number.
    pub(super) fn new(scene: &PlacedScene<'_>, number: usize) -> Self {
        let (object, placed) = (&scene.setup.objects[number], &scene.placed[number]);
        let matrix = object.world_from_object;
        let area = PixelArea::of_box(matrix, &placed.bounds, &scene.view, scene.options.size);
        let half = 0.5 * placed.bounds.size();
        let [x, y, z] =
            [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| matrix.transform_vector3(axis * half).abs());
        let margin = APART * (scene.view.eye.distance(placed.center) + placed.radius);
        let reach = x + y + z + DVec3::splat(margin);
        Self { area, low: placed.center - reach, high: placed.center + reach }
    }

    /// True if the boxes of two objects may touch; also where a box is not finite.
    fn touches(&self, other: &Self) -> bool {
        let is_apart = |a: &Self, b: &Self| a.high.cmplt(b.low).any();
        !(is_apart(self, other) || is_apart(other, self))
    }
}

/// The draws in an order in which those of one look follow one another where that cannot be seen.
/// `draws` are in the order in which they would be drawn otherwise.
pub(super) fn in_lists(draws: Vec<(Draw, DrawPlace)>) -> Vec<Draw> {
    let kinds = kinds(&draws);
    let is_mixed = kinds.iter().any(|kind| *kind != 0);
    let before = if is_mixed { overlaps(&draws) } else { None };
    let Some(before) = before else { return draws.into_iter().map(|(draw, _)| draw).collect() };
    // Draws of one level need no order among different kinds but that of the kinds.
    let mut levels: Vec<usize> = Vec::with_capacity(draws.len());
    for (index, before) in before.iter().enumerate() {
        let after = |other: &usize| levels[*other] + usize::from(kinds[*other] > kinds[index]);
        let level = before.iter().map(after).max().unwrap_or_default();
        levels.push(level);
    }
    let mut places: Vec<usize> = (0..draws.len()).collect();
    places.sort_by_key(|&index| (levels[index], kinds[index], index));
    let mut draws: Vec<Option<Draw>> = draws.into_iter().map(|(draw, _)| Some(draw)).collect();
    places.into_iter().filter_map(|index| draws[index].take()).collect()
}

/// The kind of each draw, which draws of one list share: numbers in the order of first draws.
fn kinds(draws: &[(Draw, DrawPlace)]) -> Vec<usize> {
    let mut known = HashMap::new();
    let kind_of = |(draw, _): &(Draw, DrawPlace)| {
        let next = known.len();
        let images: Vec<u64> = draw.images.iter().map(|image| image.hash).collect();
        let sides = (draw.two_sided, draw.is_mirrored);
        *known.entry((Arc::as_ptr(&draw.look), images, sides)).or_insert(next)
    };
    draws.iter().map(kind_of).collect()
}

/// The earlier draws that each draw must follow; `None` where too many lie one over another.
fn overlaps(draws: &[(Draw, DrawPlace)]) -> Option<Vec<Vec<usize>>> {
    let mut before = vec![Vec::new(); draws.len()];
    let place = |index: usize| &draws[index].1;
    let mut by_column: Vec<usize> =
        (0..draws.len()).filter(|index| !place(*index).area.is_empty()).collect();
    by_column.sort_by_key(|&index| place(index).area.begin[0]);
    let mut open: Vec<usize> = Vec::new();
    let mut left = MOST_COMPARED * draws.len();
    for index in by_column {
        let own = place(index);
        open.retain(|&other| place(other).area.end[0] > own.area.begin[0]);
        left = left.checked_sub(open.len())?;
        for &other in &open {
            if must_keep_order(&draws[index], &draws[other]) {
                before[index.max(other)].push(index.min(other));
            }
        }
        open.push(index);
    }
    Some(before)
}

/// True if exchanging two draws whose columns overlap could change a pixel.
fn must_keep_order((a, at): &(Draw, DrawPlace), (b, other): &(Draw, DrawPlace)) -> bool {
    let shares_rows = at.area.begin[1] < other.area.end[1] && other.area.begin[1] < at.area.end[1];
    let hides = a.look.is_opaque && b.look.is_opaque;
    shares_rows && (!hides || at.touches(other))
}

impl Draw {
    /// True if the pass of `stage` draws both from one list: only meshes and numbers differ.
    pub fn shares_list(&self, other: &Self, stage: Stage) -> bool {
        let (Some(own), Some(theirs)) = (self.module(stage), other.module(stage)) else {
            return false;
        };
        let is_same_module = Arc::ptr_eq(own, theirs)
            || (own.wgsl == theirs.wgsl && own.needs.images == theirs.needs.images);
        let (images, others) = (self.images_of(stage), other.images_of(stage));
        is_same_module
            && (self.two_sided, self.is_mirrored) == (other.two_sided, other.is_mirrored)
            && images.len() == others.len()
            && images.iter().zip(others).all(|(own, other)| own.hash == other.hash)
    }
}
