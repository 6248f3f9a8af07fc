//! Links: which lights of a set reach a thing, and which rule says so; and whose shadows an object
//! casts onto which others.

use std::collections::BTreeSet;

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::Light;
use crate::diag::Diagnostic;
use crate::document::scene::Object;
use crate::document::set::{LightSet, ObjectSet};
use crate::ids::{LightId, ObjectId};

/// Sets of the lights that are linked to a thing, and of those that are not although they are.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct LightLink {
    /// Lights that reach the thing. There is nothing before it, so `{source}` is no light.
    pub linked: LightSet,
    /// Lights that do not; `{source}` are those of `linked`.
    pub unlinked: LightSet,
}

/// All lights reach the thing.
impl Default for LightLink {
    fn default() -> Self {
        Self { linked: LightSet::all(), unlinked: LightSet::none() }
    }
}

/// Rule that decides whether a light reaches a thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkRule {
    /// The light is of `linked`, and not of `unlinked`.
    Linked,
    /// The light is not of `linked`.
    NotLinked,
    /// The light is of `linked` and of `unlinked`.
    Unlinked,
}

/// Relation between lights and things, by the two fields that say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LightRelation {
    /// Lights that reach an object.
    Linked,
    /// Lights that reach a node.
    Layered,
    /// Lights that pass through a node that filters them.
    Filtered,
    /// Lights whose shadows an object casts.
    Shadowed,
}

impl LightRelation {
    /// Names of the field of what is related and of the field of what is not all the same.
    pub fn fields(self) -> [&'static str; 2] {
        match self {
            Self::Linked => ["linked", "unlinked"],
            Self::Layered => ["layered", "unlayered"],
            Self::Filtered => ["filtered", "unfiltered"],
            Self::Shadowed => ["shadowed", "unshadowed"],
        }
    }
}

impl LightLink {
    /// True if all lights reach the thing, whichever there are.
    pub fn is_all(&self) -> bool {
        self.linked.is_all() && self.unlinked.is_none()
    }

    /// Rule for each of the lights.
    pub fn rules(&self, lights: &IndexMap<LightId, Light>) -> IndexMap<LightId, LinkRule> {
        self.rules_within(lights, &BTreeSet::new())
    }

    /// Rule for each of the lights; `{source}` is `around`, those that reach what is around the
    /// thing.
    pub fn rules_within(
        &self,
        lights: &IndexMap<LightId, Light>,
        around: &BTreeSet<LightId>,
    ) -> IndexMap<LightId, LinkRule> {
        let linked = self.linked.of(lights, around);
        let unlinked = self.unlinked.of(lights, &linked);
        let rule = |id: &LightId| rule_of(linked.contains(id), unlinked.contains(id));
        lights.keys().map(|id| (id.clone(), rule(id))).collect()
    }

    /// Lights of those around a thing that reach it.
    pub fn lights_within(
        &self,
        lights: &IndexMap<LightId, Light>,
        around: &BTreeSet<LightId>,
    ) -> BTreeSet<LightId> {
        let rules = self.rules_within(lights, around).into_iter();
        let reaching = rules.filter(|(id, rule)| *rule == LinkRule::Linked && around.contains(id));
        reaching.map(|(id, _)| id).collect()
    }

    /// The rule in words, with the expression that decided, for a relation.
    pub fn words(&self, relation: LightRelation, rule: LinkRule) -> String {
        if rule == LinkRule::Linked && relation == LightRelation::Linked && self.is_all() {
            return tr!("all lights are linked").to_owned();
        }
        words_of(relation.fields(), [self.linked.text(), self.unlinked.text()], rule)
    }

    /// Warnings of names in the link that no light has; `whose` says whose link it is.
    pub fn idle_warnings(
        &self,
        relation: LightRelation,
        whose: &str,
        lights: &IndexMap<LightId, Light>,
    ) -> Vec<Diagnostic> {
        let sets = relation.fields().into_iter().zip([&self.linked, &self.unlinked]);
        sets.flat_map(|(field, set)| set.idle_warnings(&format!("`{field}`{whose}"), lights))
            .collect()
    }
}

fn rule_of(is_in: bool, is_out: bool) -> LinkRule {
    match (is_in, is_out) {
        (true, false) => LinkRule::Linked,
        (true, true) => LinkRule::Unlinked,
        (false, _) => LinkRule::NotLinked,
    }
}

/// The rule in words: which field has a thing, or has it not, with its expression.
fn words_of(fields: [&str; 2], texts: [&str; 2], rule: LinkRule) -> String {
    let ([field, out], [text, out_text]) = (fields, texts);
    match rule {
        LinkRule::Linked => tr!("`{field}` (`{text}`) has it"),
        LinkRule::NotLinked if text.trim().is_empty() => tr!("`{field}` is empty"),
        LinkRule::NotLinked => tr!("`{field}` (`{text}`) has it not"),
        LinkRule::Unlinked => tr!("`{out}` (`{out_text}`) has it"),
    }
}

/// Shadows that an object casts: of which lights, and onto which objects.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct ShadowLink {
    /// Lights whose shadows the object casts.
    pub shadowed: LightSet,
    /// Lights whose shadows it does not cast; `{source}` are those of `shadowed`.
    pub unshadowed: LightSet,
    /// Objects that its shadows fall on.
    pub shadows_on: ObjectSet,
    /// Objects that they do not; `{source}` are those of `shadows_on`.
    pub no_shadows_on: ObjectSet,
}

/// The object casts all shadows that there are.
impl Default for ShadowLink {
    fn default() -> Self {
        Self {
            shadowed: LightSet::all(),
            unshadowed: LightSet::none(),
            shadows_on: ObjectSet::all(),
            no_shadows_on: ObjectSet::none(),
        }
    }
}

impl ShadowLink {
    /// True if the object casts the shadows of all lights onto all objects, whichever there are.
    pub fn is_all(&self) -> bool {
        self.shadowed.is_all()
            && self.unshadowed.is_none()
            && self.shadows_on.is_all()
            && self.no_shadows_on.is_none()
    }

    /// Link of the lights whose shadows the object casts.
    pub fn light_link(&self) -> LightLink {
        LightLink { linked: self.shadowed.clone(), unlinked: self.unshadowed.clone() }
    }

    /// Lights whose shadows the object casts.
    pub fn lights(&self, all: &IndexMap<LightId, Light>) -> BTreeSet<LightId> {
        linked_of(self.light_link().rules(all))
    }

    /// Rule for each of the objects that its shadows may fall on.
    pub fn rules_of_objects(
        &self,
        all: &IndexMap<ObjectId, Object>,
    ) -> IndexMap<ObjectId, LinkRule> {
        let on = self.shadows_on.of(all, &BTreeSet::new());
        let not_on = self.no_shadows_on.of(all, &on);
        let rule = |id: &ObjectId| rule_of(on.contains(id), not_on.contains(id));
        all.keys().map(|id| (id.clone(), rule(id))).collect()
    }

    /// Objects that its shadows fall on.
    pub fn objects(&self, all: &IndexMap<ObjectId, Object>) -> BTreeSet<ObjectId> {
        linked_of(self.rules_of_objects(all))
    }

    /// The rule for an object in words, with the expression that decided.
    pub fn words_of_object(&self, rule: LinkRule) -> String {
        let texts = [self.shadows_on.text(), self.no_shadows_on.text()];
        words_of(["shadows_on", "no_shadows_on"], texts, rule)
    }
}

fn linked_of<I: Ord>(rules: IndexMap<I, LinkRule>) -> BTreeSet<I> {
    let linked = rules.into_iter().filter(|(_, rule)| *rule == LinkRule::Linked);
    linked.map(|(id, _)| id).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::{LayerLink, NodeLinks};
    use super::*;

    const IDS: [&str; 4] = ["key", "fill", "rim", "eye"];

    fn lit() -> IndexMap<LightId, Light> {
        let light = |id: &str| Light { groups: vec![id[..1].into()], ..Light::default() };
        IDS.map(|id| (id.into(), light(id))).into()
    }

    /// A set of lights, and its members as bits of [`IDS`], by what was there before.
    type SetCase = (String, fn(u8) -> u8);

    fn sets() -> impl Strategy<Value = SetCase> {
        let cases: Vec<SetCase> = vec![
            (String::new(), |_| 0),
            ("*".to_owned(), |_| 0b1111),
            ("key | rim".to_owned(), |_| 0b0101),
            ("group:f | eye".to_owned(), |_| 0b1010),
            ("* - fill".to_owned(), |_| 0b1101),
            ("{source}".to_owned(), |before| before),
            ("{source} - key".to_owned(), |before| before & 0b1110),
            ("* - {source}".to_owned(), |before| !before & 0b1111),
            ("{source} & (key | eye)".to_owned(), |before| before & 0b1001),
        ];
        prop::sample::select(cases)
    }

    fn bits(ids: &BTreeSet<LightId>) -> u8 {
        IDS.iter().rev().fold(0, |bits, id| bits << 1 | u8::from(ids.contains(*id)))
    }

    proptest! {
        /// Members that are linked are those of the first set that are not of the second, of which
        /// the first is the source; and none is linked within that is not around.
        #[test]
        fn links_are_what_the_algebra_of_their_sets_says(
            (linked, of_linked) in sets(),
            (unlinked, of_unlinked) in sets(),
            around in 0_u8..16,
        ) {
            let set = |text: &str| LightSet::parse(text).unwrap();
            let link = LightLink { linked: set(&linked), unlinked: set(&unlinked) };
            let lights = lit();
            let ids = IDS.iter().enumerate().filter(|(bit, _)| around >> bit & 1 == 1);
            let ids: BTreeSet<LightId> = ids.map(|(_, id)| LightId::from(*id)).collect();
            let of = |source: u8| {
                let first = of_linked(source);
                (first, of_unlinked(first))
            };
            let (first, second) = of(around);
            prop_assert_eq!(bits(&link.lights_within(&lights, &ids)), first & !second & around);
            let (first, second) = of(0);
            for (bit, rule) in link.rules(&lights).into_values().enumerate() {
                let wanted = match (first >> bit & 1, second >> bit & 1) {
                    (1, 0) => LinkRule::Linked,
                    (1, _) => LinkRule::Unlinked,
                    _ => LinkRule::NotLinked,
                };
                prop_assert_eq!(rule, wanted);
            }
            let shadow = ShadowLink {
                shadowed: link.linked,
                unshadowed: link.unlinked,
                ..ShadowLink::default()
            };
            prop_assert_eq!(bits(&shadow.lights(&lights)), first & !second);
        }

        /// A scene's row for a node takes from, and adds to, what the look says of the node.
        #[test]
        fn rows_of_a_scene_stand_over_what_looks_say(
            own in [sets(), sets()],
            over in [sets(), sets()],
            around in 0_u8..16,
        ) {
            let set = |(text, _): &SetCase| LightSet::parse(text).unwrap();
            let links = NodeLinks {
                layered: set(&own[0]),
                unlayered: set(&own[1]),
                filtered: set(&own[0]),
                unfiltered: set(&own[1]),
            };
            let row = LayerLink {
                node: "rim".into(),
                layered: set(&over[0]),
                unlayered: set(&over[1]),
                filtered: set(&over[0]),
                unfiltered: set(&over[1]),
            };
            let both = links.under(&row);
            let ids = IDS.iter().enumerate().filter(|(bit, _)| around >> bit & 1 == 1);
            let ids: BTreeSet<LightId> = ids.map(|(_, id)| LightId::from(*id)).collect();
            let without = |sets: &[SetCase; 2], source: u8| {
                let first = (sets[0].1)(source);
                first & !(sets[1].1)(first)
            };
            let wanted = without(&over, without(&own, around)) & around;
            for link in [both.layered_link(), both.filtered_link()] {
                prop_assert_eq!(bits(&link.lights_within(&lit(), &ids)), wanted);
            }
        }
    }

    #[test]
    fn exclusions_are_taken_from_what_is_linked() {
        let lights: IndexMap<LightId, Light> =
            ["key", "fill", "rim"].map(|id| (id.into(), Light::default())).into();
        let rules = |linked: &str, unlinked: &str| {
            let set = |text| LightSet::parse(text).unwrap();
            let link = LightLink { linked: set(linked), unlinked: set(unlinked) };
            link.rules(&lights).into_values().collect::<Vec<_>>()
        };
        let [yes, no, out] = [LinkRule::Linked, LinkRule::NotLinked, LinkRule::Unlinked];
        assert_eq!(rules("*", ""), [yes; 3]);
        assert_eq!(rules("key | rim", "rim | fill"), [yes, no, out]);
        assert_eq!(rules("key | rim", "{source} - key"), [yes, no, out]);
        assert_eq!(rules("", "*"), [no; 3]);
        assert_eq!(rules("{source} | rim", ""), [no, no, yes]);
        assert!(LightLink::default().is_all());
    }
}
