//! Inputs of the pass of the looks, draw by draw: a renderer that has the samples of one picture
//! finds by them which pixels of the next one may be others, and shades those alone.
//!
//! A pixel depends on the draws whose areas have it, in their order, and through passes over the
//! picture on the draws around it. Where none of those changes, comes or goes, every sample stays
//! what it was, to the bit, for two draws that both stay keep their order wherever exchanging them
//! could be seen (see `order`). What all pixels depend on has to be the same: the camera, with the
//! planes between which the scene lies, and the sizes.

use std::collections::{HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Arc, Weak};

use super::{Draw, FramePlan};
use crate::compile::CompiledShader;
use crate::frame::casters::Casters;
use crate::frame::coverage::PixelArea;
use crate::frame::shadow_maps::ShadowMaps;
use crate::geometry::Mesh;
use crate::library::PassId;

/// Most areas that are told apart: each is a part of every draw that has pixels in it.
const MOST_AREAS: usize = 8;

/// Inputs of the pass of the looks.
#[derive(Debug)]
pub struct LookInputs {
    /// Hash of what all pixels depend on.
    common: u64,
    /// Areas of the draws, each by the hash of everything that the draw reads.
    draws: HashMap<u64, PixelArea>,
    /// Distance around a draw, in pixels, within which others may read it.
    spread: u32,
    size: [u32; 2],
    /// Owners of what is known by its address, so that no other thing gets that address meanwhile.
    _meshes: Vec<Weak<Mesh>>,
    _casters: Option<Arc<Casters>>,
    _shadow_maps: Option<Arc<ShadowMaps>>,
}

impl LookInputs {
    /// The inputs of a plan.
    pub fn of(plan: &FramePlan) -> Self {
        let mut hasher = DefaultHasher::new();
        (plan.size, plan.samples, plan.view.uniform_bytes(), &plan.aovs).hash(&mut hasher);
        plan.backdrop.map(|color| color.map(f64::to_bits)).hash(&mut hasher);
        // Of surfaces at one depth, the first or the last is seen.
        plan.draws.iter().all(|draw| draw.depth_first).hash(&mut hasher);
        let mut modules = HashMap::new();
        let hash = |draw: &Draw| (input_hash(plan, draw, &mut modules), draw.area);
        Self {
            common: hasher.finish(),
            draws: plan.draws.iter().map(hash).collect(),
            spread: plan.spread(),
            size: plan.size,
            _meshes: plan.draws.iter().map(|draw| Arc::downgrade(&draw.mesh)).collect(),
            _casters: plan.casters.clone(),
            _shadow_maps: plan.shadow_maps.clone(),
        }
    }

    /// Areas outside of which every sample is the one that a picture of `before` has; they may
    /// overlap, and begin and end between blocks of so many pixels. `None` where no pixel is known
    /// to stay.
    pub fn changed_since(&self, before: &Self, block: u32) -> Option<Vec<PixelArea>> {
        if self.common != before.common {
            return None;
        }
        let spread = self.spread.max(before.spread);
        let own = self.draws.iter().filter(|(hash, _)| !before.draws.contains_key(hash));
        let gone = before.draws.iter().filter(|(hash, _)| !self.draws.contains_key(hash));
        let mut areas = Vec::new();
        let seen = own.chain(gone).map(|(_, area)| area).filter(|area| !area.is_empty());
        for area in seen {
            add(&mut areas, area.widened(spread, self.size).in_blocks(block, self.size));
        }
        let pixels: u64 = areas.iter().map(PixelArea::count).sum();
        (pixels < PixelArea::whole(self.size).count()).then_some(areas)
    }
}

/// Adds an area to some, or joins it with one of them where that is less to shade.
fn add(areas: &mut Vec<PixelArea>, area: PixelArea) {
    if area.is_empty() {
        return;
    }
    let growth = |other: &PixelArea| {
        let joined = other.joined(area).count() as i64;
        joined - other.count() as i64 - area.count() as i64
    };
    let nearest = (0..areas.len()).min_by_key(|&index| growth(&areas[index]));
    match nearest.filter(|&index| areas.len() >= MOST_AREAS || growth(&areas[index]) <= 0) {
        // The joined area may take in others.
        Some(index) => {
            let joined = areas.swap_remove(index).joined(area);
            add(areas, joined);
        }
        None => areas.push(area),
    }
}

/// The hash of everything that a draw reads in all passes but other draws' results: those count by
/// their areas.
fn input_hash(
    plan: &FramePlan,
    draw: &Draw,
    modules: &mut HashMap<*const CompiledShader, u64>,
) -> u64 {
    let mut hasher = DefaultHasher::new();
    (Arc::as_ptr(&draw.mesh) as usize, &draw.indices, &draw.object_uniform.bytes).hash(&mut hasher);
    (draw.two_sided, draw.is_mirrored, draw.depth_first, draw.area).hash(&mut hasher);
    for shader in draw.modules() {
        let text = modules.entry(Arc::as_ptr(shader)).or_insert_with(|| {
            let mut hasher = DefaultHasher::new();
            shader.wgsl.hash(&mut hasher);
            hasher.finish()
        });
        let uniform = draw.look_uniforms.get(&shader.stage).map(|uniform| &uniform.bytes);
        (*text, uniform).hash(&mut hasher);
        draw.images_of(shader.stage).iter().for_each(|image| image.hash.hash(&mut hasher));
        if let Some(casters) = plan.casters.as_ref().filter(|_| shader.needs.casters()) {
            casters.hash().hash(&mut hasher);
        }
        let is_read = |pass: PassId| shader.needs.passes().any(|read| read == pass);
        let lights = plan.passes.iter().filter(|pass| pass.id.is_of_lights() && is_read(pass.id));
        lights.for_each(|pass| pass.input_hash.hash(&mut hasher));
    }
    hasher.finish()
}

impl FramePlan {
    /// Distance around a draw, in pixels, within which looks read of it through passes over the
    /// picture; see [`margin`](Self::margin) for the pixel more that each pass may take.
    fn spread(&self) -> u32 {
        let modules: HashMap<_, _> =
            self.draws.iter().flat_map(Draw::modules).map(|one| (Arc::as_ptr(one), one)).collect();
        let read: HashSet<PassId> =
            modules.values().flat_map(|module| module.needs.passes()).collect();
        let read = read.into_iter().filter(|pass| !pass.is_of_lights());
        read.map(|pass| self.depth_of(pass)).max().unwrap_or_default()
    }

    fn depth_of(&self, pass: PassId) -> u32 {
        let before = PassId::all().filter(|before| pass.reads(*before));
        let deepest = before.map(|before| self.depth_of(before)).max().unwrap_or_default();
        1 + pass.own_reach() * self.view.step_pixels() + deepest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(begin: [u32; 2], end: [u32; 2]) -> PixelArea {
        PixelArea { begin, end }
    }

    #[test]
    fn areas_are_joined_where_that_is_less_to_shade() {
        let mut areas = Vec::new();
        add(&mut areas, PixelArea::EMPTY);
        assert!(areas.is_empty());
        add(&mut areas, area([0, 0], [10, 10]));
        add(&mut areas, area([40, 40], [50, 50]));
        assert_eq!(areas.len(), 2, "far apart");
        add(&mut areas, area([5, 0], [12, 10]));
        assert_eq!(areas, [area([40, 40], [50, 50]), area([0, 0], [12, 10])]);
        // What joins two takes in a third.
        add(&mut areas, area([0, 0], [50, 48]));
        assert_eq!(areas, [area([0, 0], [50, 50])]);
    }

    #[test]
    fn many_areas_are_few() {
        let mut areas = Vec::new();
        for at in 0..100 {
            let begin = [(at * 37) % 400, (at * 91) % 300];
            let one = area(begin, begin.map(|least| least + 3));
            add(&mut areas, one);
            assert!(areas.len() <= MOST_AREAS);
            assert!(areas.iter().any(|all| all.joined(one) == *all), "{one:?}");
        }
    }
}
