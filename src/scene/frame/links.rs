//! Links between lights and objects, in a scene with everything that it names.

use std::borrow::Cow;
use std::collections::BTreeSet;

use indexmap::IndexMap;

use super::mix::LightMix;
use super::setup::{Setup, SetupObject};
use crate::diag::Diagnostic;
use crate::document::{Light, LinkRule, MemberSet, SetMember};
use crate::ids::{LightId, ObjectId};

/// A light and an object, and whether the one reaches the other.
#[derive(Clone, Debug, PartialEq)]
pub struct LightReach {
    /// The object.
    pub object: ObjectId,
    /// The light.
    pub light: LightId,
    /// True if it reaches the object.
    pub reaches: bool,
    /// The rule that decides, in words, with its expression.
    pub words: String,
}

impl Setup {
    /// All lights that an object's links may name: the scene's, then those of the object's looks.
    fn lights_about(&self, object: &SetupObject) -> IndexMap<LightId, Light> {
        self.lights_with(object.worn_looks().collect::<BTreeSet<usize>>())
    }

    /// The scene's lights, then those that some of its looks have besides.
    pub(super) fn lights_with(
        &self,
        looks: impl IntoIterator<Item = usize>,
    ) -> IndexMap<LightId, Light> {
        let mut lights = self.scene.lights.clone();
        for (id, light) in looks.into_iter().flat_map(|look| &self.looks[look].look.lights) {
            lights.entry(id.clone()).or_insert_with(|| light.clone());
        }
        lights
    }

    /// Warnings of links, mutes, solos and masters: of names that there are not, and of lights that
    /// shine alone.
    pub fn light_warnings(&self) -> Vec<Diagnostic> {
        let links = self.objects.iter().flat_map(|object| idle_links(self, object));
        self.mix_warnings().into_iter().chain(links).collect()
    }

    /// Every visible object with every light that it is about, by object.
    pub fn light_reach(&self) -> Vec<LightReach> {
        let mix = self.light_mix();
        let mut found = Vec::new();
        for object in &self.objects {
            let link = &object.light_link;
            for (light, rule) in link.rules(&self.lights_about(object)) {
                let out = mix.out().get(&light).filter(|_| rule == LinkRule::Linked);
                let words = out.map_or_else(|| link.words(rule), |why| why.clone().into_owned());
                let reaches = rule == LinkRule::Linked && out.is_none();
                found.push(LightReach { object: object.id.clone(), light, reaches, words });
            }
        }
        found
    }
}

/// Lights that do not reach an object, each with the reason: they are not linked to it, or out.
pub(super) fn unlit(
    setup: &Setup,
    mix: &LightMix,
    object: &SetupObject,
) -> IndexMap<LightId, Cow<'static, str>> {
    let mut unlit = unlinked_lights(setup, object);
    for (id, why) in mix.out() {
        unlit.entry(id.clone()).or_insert_with(|| format!("it is out: {why}").into());
    }
    unlit
}

/// Lights that are not linked to an object, each with the reason.
pub(super) fn unlinked_lights(
    setup: &Setup,
    object: &SetupObject,
) -> IndexMap<LightId, Cow<'static, str>> {
    let link = &object.light_link;
    if link.is_all() {
        return IndexMap::new();
    }
    let rules = link.rules(&setup.lights_about(object)).into_iter();
    let unlinked = rules.filter(|(_, rule)| *rule != LinkRule::Linked);
    let words = |rule| {
        format!("it does not reach the objects that wear the look: their {}", link.words(rule))
    };
    unlinked.map(|(id, rule)| (id, words(rule).into())).collect()
}

/// Warnings of links that name a light, a group or an object which there is not.
pub(super) fn idle_links(setup: &Setup, object: &SetupObject) -> Vec<Diagnostic> {
    let (link, shadow) = (&object.light_link, &object.shadow_link);
    if link.is_all() && shadow.is_all() {
        return Vec::new();
    }
    let index = setup.scene.objects.get_index_of(&object.id).unwrap_or_default();
    let place = |field: &str| {
        (format!("`{field}` of object `{}`", object.id), format!("objects[{index}].{field}"))
    };
    let own = setup.lights_about(object);
    let all = if shadow.is_all() { IndexMap::new() } else { setup.all_lights() };
    let of_lights = [
        ("linked", &link.linked, &own),
        ("unlinked", &link.unlinked, &own),
        ("shadowed", &shadow.shadowed, &all),
        ("unshadowed", &shadow.unshadowed, &all),
    ];
    let of_objects = [("shadows_on", &shadow.shadows_on), ("no_shadows_on", &shadow.no_shadows_on)];
    let objects = &setup.scene.objects;
    let idle_lights = of_lights
        .into_iter()
        .flat_map(|(field, set, lights)| idle_terms(setup, &place(field), set, lights));
    let idle_objects = of_objects
        .into_iter()
        .flat_map(|(field, set)| idle_terms(setup, &place(field), set, objects));
    idle_lights.chain(idle_objects).collect()
}

/// Warnings of a set's terms that name none of all members. `place` is whose set it is, and where
/// in the scene's document.
pub(super) fn idle_terms<M: SetMember>(
    setup: &Setup,
    (whose, json_path): &(String, String),
    set: &MemberSet<M>,
    all: &IndexMap<M::Id, M>,
) -> Vec<Diagnostic> {
    let idle = set.idle_warnings(whose, all).into_iter();
    idle.map(|problem| located(setup, problem, json_path.clone())).collect()
}

/// The problem with its place in the scene's document, where that was read from a text.
pub(super) fn located(setup: &Setup, problem: Diagnostic, json_path: String) -> Diagnostic {
    let Some(source) = &setup.source else { return problem };
    let mut problem = problem.json_path(json_path);
    source.locate(&mut problem);
    problem
}
