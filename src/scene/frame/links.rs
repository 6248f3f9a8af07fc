//! Links between lights and objects, in a scene with everything that it names.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::mix::LightMix;
use super::setup::{Setup, SetupObject};
use crate::compile::{NodeReach, node_reach};
use crate::diag::Diagnostic;
use crate::document::{Light, LightRelation, LinkRule, MemberSet, SetMember};
use crate::ids::{LightId, ObjectId};
use crate::library::Library;

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

/// A light and a node of a look that an object wears, and whether the one reaches the other, or is
/// filtered by it.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerReach {
    /// The object.
    pub object: ObjectId,
    /// Name of the look.
    pub look: String,
    /// Node and light with their rule.
    pub reach: NodeReach,
}

/// A light and two objects, and whether the shadow that the one casts of it falls on the other.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowReach {
    /// The light.
    pub light: LightId,
    /// The object that casts the shadow.
    pub caster: ObjectId,
    /// The object that it falls on, or not.
    pub onto: ObjectId,
    /// True if it falls there, where a look asks for shadows.
    pub falls: bool,
    /// True if links of shadows decide, and not that the light is dark there or the caster unseen.
    pub is_by_link: bool,
    /// The rule that decides, in words, with its expression.
    pub words: String,
}

impl Setup {
    /// Every visible object with the nodes of its looks that are about lights, at a time in
    /// seconds.
    pub fn layer_reach(&self, library: &Library, time: f64) -> Vec<LayerReach> {
        let (mix, mut found) = (self.light_mix(), Vec::new());
        for object in &self.objects {
            let lights = self.light_reach_with(&mix, object);
            for look in object.worn_looks().collect::<BTreeSet<usize>>() {
                found.extend(self.layer_reach_of((object, look), &lights, library, time));
            }
        }
        found
    }

    /// The nodes that are about lights of one look that an object wears, at a time in seconds;
    /// `lights` is the object's own [`light_reach_of`](Self::light_reach_of).
    pub fn layer_reach_of(
        &self,
        (object, look): (&SetupObject, usize),
        lights: &[LightReach],
        library: &Library,
        time: f64,
    ) -> Vec<LayerReach> {
        let dark = lights.iter().filter(|cell| !cell.reaches);
        let dark: HashMap<&LightId, &str> =
            dark.map(|cell| (&cell.light, cell.words.as_str())).collect();
        let worn = self.worn(look, object, library, time);
        let of_node = |mut reach: NodeReach| {
            if let Some(words) = dark.get(&reach.light) {
                if reach.relation == LightRelation::Filtered {
                    return None;
                }
                reach.reaches = false;
                reach.words = (*words).to_owned();
            }
            Some(LayerReach { object: object.id.clone(), look: worn.name.clone(), reach })
        };
        node_reach(&worn, library).into_iter().filter_map(of_node).collect()
    }

    /// Every light with every pair of visible objects, of which one may cast its shadow onto the
    /// other or onto itself.
    pub fn shadow_reach(&self) -> impl Iterator<Item = ShadowReach> + '_ {
        let lights = self.all_lights();
        let dark: HashMap<(ObjectId, LightId), String> = self
            .light_reach()
            .into_iter()
            .filter(|cell| !cell.reaches)
            .map(|cell| ((cell.object, cell.light), cell.words))
            .collect();
        self.objects.iter().flat_map(move |caster| {
            let link = &caster.shadow_link;
            let of_lights = link.light_link().rules(&lights);
            let of_objects = link.rules_of_objects(&self.scene.objects);
            let wears_look = caster.worn_looks().next().is_some();
            let mut found = Vec::new();
            for (light, rule) in &of_lights {
                for onto in &self.objects {
                    let of_object = of_objects.get(&onto.id).copied();
                    // What is not of the scene's own list is of no set but that of all.
                    let of_object = of_object.unwrap_or(match link.is_all() {
                        true => LinkRule::Linked,
                        false => LinkRule::NotLinked,
                    });
                    let unlit = dark.get(&(onto.id.clone(), light.clone()));
                    let (is_by_link, words) = if !wears_look {
                        (false, tr!("it wears no look").to_owned())
                    } else if let Some(words) = unlit {
                        (false, tr!("the light does not reach it: {words}"))
                    } else if *rule != LinkRule::Linked || of_object == LinkRule::Linked {
                        (true, link.light_link().words(LightRelation::Shadowed, *rule))
                    } else {
                        (true, link.words_of_object(of_object))
                    };
                    found.push(ShadowReach {
                        light: light.clone(),
                        caster: caster.id.clone(),
                        onto: onto.id.clone(),
                        falls: is_by_link
                            && *rule == LinkRule::Linked
                            && of_object == LinkRule::Linked,
                        is_by_link,
                        words,
                    });
                }
            }
            found
        })
    }

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
        self.mix_warnings().into_iter().chain(self.aim_warnings()).chain(links).collect()
    }

    /// Every visible object with every light that it is about, by object.
    pub fn light_reach(&self) -> Vec<LightReach> {
        let mix = self.light_mix();
        let of_object = |object: &SetupObject| self.light_reach_with(&mix, object);
        self.objects.iter().flat_map(of_object).collect()
    }

    /// Every light that an object is about.
    pub fn light_reach_of(&self, object: &SetupObject) -> Vec<LightReach> {
        self.light_reach_with(&self.light_mix(), object)
    }

    fn light_reach_with(&self, mix: &LightMix, object: &SetupObject) -> Vec<LightReach> {
        let link = &object.light_link;
        let of_light = |(light, rule): (LightId, LinkRule)| {
            let out = mix.out().get(&light).filter(|_| rule == LinkRule::Linked);
            let of_link = || link.words(LightRelation::Linked, rule);
            let words = out.map_or_else(of_link, |why| why.clone().into_owned());
            let reaches = rule == LinkRule::Linked && out.is_none();
            LightReach { object: object.id.clone(), light, reaches, words }
        };
        link.rules(&self.lights_about(object)).into_iter().map(of_light).collect()
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
        unlit.entry(id.clone()).or_insert_with(|| tr!("it is out: {why}").into());
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
        let why = link.words(LightRelation::Linked, rule);
        tr!("it does not reach the objects that wear the look: their {why}")
    };
    unlinked.map(|(id, rule)| (id, words(rule).into())).collect()
}

/// Warnings of links that name a light, a group or an object which there is not.
pub(super) fn idle_links(setup: &Setup, object: &SetupObject) -> Vec<Diagnostic> {
    let (link, shadow) = (&object.light_link, &object.shadow_link);
    if link.is_all() && shadow.is_all() && object.layers.is_empty() {
        return Vec::new();
    }
    let index = setup.scene.objects.get_index_of(&object.id).unwrap_or_default();
    let place = |field: &str| {
        (tr!("`{field}` of object `{id}`", id = object.id), format!("objects[{index}].{field}"))
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
    let of_layers = object.layers.iter().enumerate().flat_map(|(row, layer)| {
        let sets = [
            ("layered", &layer.layered),
            ("unlayered", &layer.unlayered),
            ("filtered", &layer.filtered),
            ("unfiltered", &layer.unfiltered),
        ];
        sets.map(|(field, set)| (format!("layers[{row}].{field}"), set))
    });
    let idle_layers =
        of_layers.flat_map(|(field, set)| idle_terms(setup, &place(&field), set, &own));
    let unknown = setup.layer_warnings(object);
    idle_lights.chain(idle_objects).chain(idle_layers).chain(unknown).collect()
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
