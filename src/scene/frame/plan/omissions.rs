//! Omissions of a plan: dark and unread lights, and looks that equal another.

use std::collections::HashMap;

use chiaro_locale::tr;

use super::DroppedEffect;
use super::variants::{DarkLights, LookShaders, Variants};
use crate::compile::{Proof, node_reach};
use crate::document::{LightRelation, Look};
use crate::frame::cost::EffectCost;
use crate::frame::effects::EffectKind;
use crate::frame::setup::Setup;
use crate::ids::LightId;
use crate::library::Library;

/// Lists the lights of a look that its module does not read, and the lights that are dark.
pub(super) fn push_lights(
    dropped: &mut Vec<DroppedEffect>,
    look: &Look,
    shaders: &LookShaders,
    dark: &DarkLights,
) {
    let is_read = |id: &LightId| shaders.draw.host.lights().any(|light| light == id);
    for id in look.lights.keys() {
        let found = dark.iter().find(|((light, _), _)| light == id);
        let (why, proof) = match found {
            Some((_, why)) => (why.as_ref(), Proof::NoLight),
            None if is_read(id) => continue,
            None => (tr!("no live node reads it, so that it has no uniforms"), Proof::Unreachable),
        };
        let one = DroppedEffect {
            what: tr!("light `{id}`"),
            why: why.to_owned(),
            kind: EffectKind::Light,
            proof,
            look: Some(look.name.clone()),
            cost: EffectCost::default(),
        };
        if !dropped.contains(&one) {
            dropped.push(one);
        }
    }
}

/// Lists the lights that do not reach nodes of a look, and those that pass by what filters others.
pub(super) fn push_node_links(dropped: &mut Vec<DroppedEffect>, look: &Look, library: &Library) {
    for reach in node_reach(look, library).into_iter().filter(|reach| !reach.reaches) {
        let (light, node) = (&reach.light, &reach.node);
        let (what, proof) = match reach.relation {
            LightRelation::Filtered => {
                (tr!("filter `{node}` of the light `{light}`"), Proof::Unreachable)
            }
            _ => (tr!("light `{light}` on the node `{node}`"), Proof::NoLight),
        };
        let one = DroppedEffect {
            what,
            why: reach.words,
            kind: EffectKind::Light,
            proof,
            look: Some(look.name.clone()),
            cost: EffectCost::default(),
        };
        if !dropped.contains(&one) {
            dropped.push(one);
        }
    }
}

/// Lists the looks that are compiled together with an equal look.
pub(super) fn push_equal_looks(
    dropped: &mut Vec<DroppedEffect>,
    setup: &Setup,
    variants: &Variants,
) {
    let mut known: HashMap<u64, usize> = HashMap::new();
    let mut sorted: Vec<_> =
        variants.iter().map(|((_, look), variant)| (*look, variant.key)).collect();
    sorted.sort_unstable();
    sorted.dedup();
    for (look, key) in sorted {
        let first = *known.entry(key).or_insert(look);
        if first != look {
            let name = &setup.looks[look].look.name;
            dropped.push(DroppedEffect {
                what: quoted(name),
                why: tr!(
                    "another look says the same: both are compiled once and share their pipelines"
                )
                .to_owned(),
                kind: EffectKind::Look,
                proof: Proof::Equal,
                look: Some(name.clone()),
                cost: EffectCost::default(),
            });
        }
    }
}

/// The name of a look as sentences quote it.
pub(super) fn quoted(name: &str) -> String {
    if name.is_empty() { tr!("a look").to_owned() } else { tr!("the look \"{name}\"") }
}
