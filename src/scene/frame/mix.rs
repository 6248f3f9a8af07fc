//! Mix of a scene's lights: which are out by mutes and solos, and what the masters of their groups
//! leave of the others.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};

use chiaro_locale::{tr, trn};
use indexmap::IndexMap;

use super::links::{idle_terms, located};
use super::setup::Setup;
use crate::diag::Diagnostic;
use crate::document::{Light, LightOut, LightValues};
use crate::ids::LightId;

/// Code of the warning that lights shine alone.
pub const SOLOED: &str = "soloed-lights";

/// Mix of all lights that a setup is about, whatever objects they shine on.
#[derive(Clone, Debug, Default)]
pub(super) struct LightMix {
    /// Lights that are out, each with the reason.
    out: IndexMap<LightId, Cow<'static, str>>,
    /// Factors on intensity and color of lights whose groups have masters.
    factors: HashMap<LightId, (f64, [f64; 3])>,
}

impl LightMix {
    /// Lights that are out, each with the reason.
    pub(super) fn out(&self) -> &IndexMap<LightId, Cow<'static, str>> {
        &self.out
    }

    /// Leaves of a light what the mix does.
    pub(super) fn apply(&self, id: &LightId, light: &mut LightValues) {
        if self.out.contains_key(id) {
            light.darken();
        } else if let Some(&(factor, tint)) = self.factors.get(id) {
            light.multiply(factor, tint);
        }
    }
}

impl Setup {
    /// All lights: the scene's, then those that its looks have besides.
    pub fn all_lights(&self) -> IndexMap<LightId, Light> {
        self.lights_with(0..self.looks.len())
    }

    /// Lights that shine alone; empty where all do that are not muted.
    pub fn soloed_lights(&self) -> BTreeSet<LightId> {
        if self.scene.soloed.is_none() {
            return BTreeSet::new();
        }
        self.scene.soloed.of(&self.all_lights(), &BTreeSet::new())
    }

    /// Mix of the lights by mutes, solos and masters.
    pub(super) fn light_mix(&self) -> LightMix {
        let scene = &self.scene;
        let mut mix = LightMix::default();
        let (muted, soloed) = (&scene.muted, &scene.soloed);
        if muted.is_none() && soloed.is_none() && scene.light_groups.is_empty() {
            return mix;
        }
        let lights = self.all_lights();
        let out = scene.lights_out(&lights);
        for (id, light) in &lights {
            let why = out.get(id).map(|out| match out {
                LightOut::NotSoloed => {
                    tr!("`soloed` (`{soloed}`) has it not", soloed = soloed.text())
                }
                LightOut::Muted => tr!("`muted` (`{muted}`) has it", muted = muted.text()),
                LightOut::ByMaster(group) => tr!("the master of its group `{group}` is 0"),
            });
            if let Some(why) = why {
                mix.out.insert(id.clone(), why.into());
            } else if let Some(product) = scene.master_factors(light) {
                mix.factors.insert(id.clone(), product);
            }
        }
        mix
    }

    /// Warnings of the mix: names that there are not, and lights that shine alone.
    pub(super) fn mix_warnings(&self) -> Vec<Diagnostic> {
        let scene = &self.scene;
        let lights = self.all_lights();
        let fields = [("muted", &scene.muted), ("soloed", &scene.soloed)];
        let mut warnings: Vec<Diagnostic> = fields
            .into_iter()
            .flat_map(|(field, set)| {
                let place = (tr!("`{field}` of the scene"), field.to_owned());
                idle_terms(self, &place, set, &lights)
            })
            .collect();
        let groups = || lights.values().flat_map(|light| &light.groups);
        for group in scene.light_groups.keys().filter(|id| !groups().any(|own| own == *id)) {
            let message =
                tr!("the scene has a master of the group `{group}`, of which no light is");
            let problem = Diagnostic::warning("unknown-light", message)
                .suggest(group.as_str(), groups().map(AsRef::as_ref));
            warnings.push(located(self, problem, format!("light_groups.{group}")));
        }
        let soloed = self.soloed_lights();
        if !soloed.is_empty() {
            let names: Vec<String> = soloed.iter().map(|id| format!("`{id}`")).collect();
            let message = trn!(
                count = names.len(),
                "{names} is soloed, so that no other light shines",
                "{names} are soloed, so that no other light shines",
                names = names.join(", ")
            );
            let problem = Diagnostic::warning(SOLOED, message)
                .hint(tr!("take it out of `soloed` when the picture is to have all its lights"));
            warnings.push(located(self, problem, "soloed".to_owned()));
        }
        warnings
    }
}
