//! Links: which lights of a set reach a thing, and which rule says so; and whose shadows an object
//! casts onto which others.

use std::collections::BTreeSet;

use indexmap::IndexMap;

use super::Light;
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

impl LightLink {
    /// True if all lights reach the thing, whichever there are.
    pub fn is_all(&self) -> bool {
        self.linked.is_all() && self.unlinked.is_none()
    }

    /// Rule for each of the lights.
    pub fn rules(&self, lights: &IndexMap<LightId, Light>) -> IndexMap<LightId, LinkRule> {
        let linked = self.linked.of(lights, &BTreeSet::new());
        let unlinked = self.unlinked.of(lights, &linked);
        let rule = |id: &LightId| match (linked.contains(id), unlinked.contains(id)) {
            (true, false) => LinkRule::Linked,
            (true, true) => LinkRule::Unlinked,
            (false, _) => LinkRule::NotLinked,
        };
        lights.keys().map(|id| (id.clone(), rule(id))).collect()
    }

    /// The rule in words, with the expression that decided.
    pub fn words(&self, rule: LinkRule) -> String {
        match rule {
            LinkRule::Linked if self.is_all() => "all lights are linked".to_owned(),
            LinkRule::Linked => format!("`linked` (`{}`) has it", self.linked.text()),
            LinkRule::NotLinked => format!("`linked` (`{}`) has it not", self.linked.text()),
            LinkRule::Unlinked => format!("`unlinked` (`{}`) has it", self.unlinked.text()),
        }
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

    /// Lights whose shadows the object casts.
    pub fn lights(&self, all: &IndexMap<LightId, Light>) -> BTreeSet<LightId> {
        let shadowed = self.shadowed.of(all, &BTreeSet::new());
        &shadowed - &self.unshadowed.of(all, &shadowed)
    }

    /// Objects that its shadows fall on.
    pub fn objects(&self, all: &IndexMap<ObjectId, Object>) -> BTreeSet<ObjectId> {
        let on = self.shadows_on.of(all, &BTreeSet::new());
        &on - &self.no_shadows_on.of(all, &on)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
