//! Rule of a scene's mix: which lights are out by its mutes, its solos and the masters of groups,
//! and what the masters leave of the others.

use std::collections::BTreeSet;

use indexmap::IndexMap;

use super::{Light, MAX_INTENSITY};
use crate::document::Scene;
use crate::document::set::LightSet;
use crate::ids::{LightGroup, LightId};

/// Reason why a light of a scene is out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LightOut {
    /// Others are soloed.
    NotSoloed,
    /// The light is muted, and none is soloed.
    Muted,
    /// The master of its group multiplies it by 0.
    ByMaster(LightGroup),
}

impl Scene {
    /// Factors on the intensity and on the color of a light by the masters of its groups, which
    /// multiply; `None` where none of the groups has a master.
    pub fn master_factors(&self, light: &Light) -> Option<(f64, [f64; 3])> {
        let mut masters =
            light.groups.iter().filter_map(|group| self.light_groups.get(group)).peekable();
        masters.peek()?;
        Some(masters.fold((1.0, [1.0; 3]), |(factor, tint), master| {
            let (own, own_tint) = master.factors();
            let tint = std::array::from_fn(|channel| tint[channel] * own_tint[channel]);
            ((factor * own).min(MAX_INTENSITY), tint)
        }))
    }

    /// Lights that are out, each with the reason. Solo beats mute: where a light is soloed, those
    /// shine that are, muted or not.
    pub fn lights_out(&self, lights: &IndexMap<LightId, Light>) -> IndexMap<LightId, LightOut> {
        let of = |set: &LightSet| match set.is_none() {
            true => BTreeSet::new(),
            false => set.of(lights, &BTreeSet::new()),
        };
        let (muted, soloed) = (of(&self.muted), of(&self.soloed));
        let is_black = |group: &&LightGroup| {
            self.light_groups.get(*group).is_some_and(|master| master.factors().0 == 0.0)
        };
        let mut out = IndexMap::new();
        for (id, light) in lights {
            let is_soloed = soloed.contains(id);
            let why = if !soloed.is_empty() && !is_soloed {
                Some(LightOut::NotSoloed)
            } else if !is_soloed && muted.contains(id) {
                Some(LightOut::Muted)
            } else {
                light.groups.iter().find(is_black).cloned().map(LightOut::ByMaster)
            };
            out.extend(why.map(|why| (id.clone(), why)));
        }
        out
    }
}
