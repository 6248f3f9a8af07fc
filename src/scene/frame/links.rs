//! Links between lights and objects, in a scene with everything that it names.

use std::borrow::Cow;
use std::collections::BTreeSet;

use indexmap::IndexMap;

use super::setup::{Setup, SetupObject};
use crate::diag::Diagnostic;
use crate::document::{Light, LinkRule, SetTerm};
use crate::ids::{LightId, ObjectId};

/// A light and an object, and whether the one reaches the other.
#[derive(Clone, Debug, PartialEq)]
pub struct LightReach {
    /// The object.
    pub object: ObjectId,
    /// The light.
    pub light: LightId,
    /// Rule that decides.
    pub rule: LinkRule,
    /// The rule in words, with the expression that decides.
    pub words: String,
}

impl Setup {
    /// All lights that an object's links may name: the scene's, then those of the object's looks.
    fn lights_about(&self, object: &SetupObject) -> IndexMap<LightId, Light> {
        let mut lights = self.scene.lights.clone();
        let looks: BTreeSet<usize> = object.worn_looks().collect();
        for (id, light) in looks.into_iter().flat_map(|look| &self.looks[look].look.lights) {
            lights.entry(id.clone()).or_insert_with(|| light.clone());
        }
        lights
    }

    /// Warnings of links that name a light, or a group, which there is not.
    pub fn light_warnings(&self) -> Vec<Diagnostic> {
        self.objects.iter().flat_map(|object| idle_links(self, object)).collect()
    }

    /// Every visible object with every light that it is about, by object.
    pub fn light_reach(&self) -> Vec<LightReach> {
        let mut found = Vec::new();
        for object in &self.objects {
            let link = &object.light_link;
            for (light, rule) in link.rules(&self.lights_about(object)) {
                let (object, words) = (object.id.clone(), link.words(rule));
                found.push(LightReach { object, light, rule, words });
            }
        }
        found
    }
}

/// Lights that do not reach an object, each with the reason.
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

/// Warnings of links that name a light, or a group, which there is not.
pub(super) fn idle_links(setup: &Setup, object: &SetupObject) -> Vec<Diagnostic> {
    let link = &object.light_link;
    if link.is_all() {
        return Vec::new();
    }
    let lights = setup.lights_about(object);
    let fields = [("linked", &link.linked), ("unlinked", &link.unlinked)];
    let idle = fields
        .into_iter()
        .flat_map(|(field, set)| set.idle_terms(&lights).map(move |term| (field, term)));
    idle.map(|(field, term)| idle_term(setup, object, field, term, &lights)).collect()
}

fn idle_term(
    setup: &Setup,
    object: &SetupObject,
    field: &'static str,
    term: &SetTerm,
    lights: &IndexMap<LightId, Light>,
) -> Diagnostic {
    let groups = || lights.values().flat_map(|light| &light.groups).map(AsRef::as_ref);
    let names = || lights.values().map(|light| light.name.as_str()).filter(|name| !name.is_empty());
    let ids = || lights.keys().map(AsRef::as_ref);
    let (what, known): (&str, Vec<&str>) = match term {
        SetTerm::Group(_) => ("group of lights", groups().collect()),
        SetTerm::Name(_) => ("light of the name", names().collect()),
        _ => ("light", ids().collect()),
    };
    let word = term.word();
    let message = format!(
        "`{field}` of object `{}` names the {what} `{word}`, which there is not",
        object.id
    );
    let mut problem = Diagnostic::warning("unknown-light", message).suggest(word, known);
    if let (Some(source), Some(index)) =
        (&setup.source, setup.scene.objects.get_index_of(&object.id))
    {
        problem = problem.json_path(format!("objects[{index}].{field}"));
        source.locate(&mut problem);
    }
    problem
}
