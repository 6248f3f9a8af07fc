//! Relations between lights and objects that the pane shows and edits: which lights reach an
//! object, and whose shadows an object casts. Each is a set of the object, and a set of exceptions.

use std::collections::BTreeSet;

use chiaro_locale::tr;
use indexmap::IndexMap;

use crate::document::{Light, LightLink, LightRelation, LightSet, LinkRule, Object, SetTerm};
use crate::ids::{LightId, ObjectId};

/// Relation between lights and objects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Relation {
    /// Lights that reach an object.
    #[default]
    Light,
    /// Lights whose shadows an object casts.
    Shadow,
}

impl Relation {
    pub(super) const ALL: [Self; 2] = [Self::Light, Self::Shadow];

    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Light => tr!("Light"),
            Self::Shadow => tr!("Shadows"),
        }
    }

    pub(super) fn help(self) -> &'static str {
        match self {
            Self::Light => {
                tr!("Which lights reach which objects: `linked` and `unlinked` of an object")
            }
            Self::Shadow => {
                tr!("Whose shadows the objects cast: `shadowed` and `unshadowed` of an object")
            }
        }
    }

    /// An object and lights in the relation, or not, as a sentence.
    pub(super) fn sentence(self, is_so: bool, object: &ObjectId, lights: &str) -> String {
        match (self, is_so) {
            (Self::Light, true) => tr!("{object} is lit by {lights}"),
            (Self::Light, false) => tr!("{object} is not lit by {lights}"),
            (Self::Shadow, true) => tr!("{object} casts the shadow of {lights}"),
            (Self::Shadow, false) => tr!("{object} casts no shadow of {lights}"),
        }
    }

    /// The object's set, and its exceptions.
    pub(super) fn sets(self, object: &Object) -> LightLink {
        match self {
            Self::Light => object.light_link(),
            Self::Shadow => {
                let shadow = object.shadow_link();
                LightLink { linked: shadow.shadowed, unlinked: shadow.unshadowed }
            }
        }
    }

    /// Gives the object a set and exceptions.
    pub(super) fn set(self, object: &mut Object, link: LightLink) {
        match self {
            Self::Light => (object.linked, object.unlinked) = (link.linked, link.unlinked),
            Self::Shadow => (object.shadowed, object.unshadowed) = (link.linked, link.unlinked),
        }
    }

    /// A rule of the link in words, with the names that the sets have in files.
    pub(super) fn words(self, link: &LightLink, rule: LinkRule) -> String {
        match self {
            Self::Light => link.words(LightRelation::Linked, rule),
            Self::Shadow if link.is_all() => tr!("it casts the shadows of all lights").to_owned(),
            Self::Shadow => link.words(LightRelation::Shadowed, rule),
        }
    }
}

/// Change of an object's links.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum LinkChange {
    /// Puts the lights of terms in.
    Link(Vec<SetTerm>),
    /// Takes the lights of terms out.
    Unlink(Vec<SetTerm>),
    /// Adds an expression to the set, as it is written.
    Append(LightSet),
    /// Puts an expression in place of the set and of its exceptions.
    Replace(LightSet),
}

impl LinkChange {
    /// The link after the change; `all` are the lights that sets may name.
    pub(super) fn of(&self, link: &LightLink, all: &IndexMap<LightId, Light>) -> LightLink {
        let mut new = link.clone();
        match self {
            Self::Link(terms) => terms.iter().for_each(|term| link_term(&mut new, term, all)),
            Self::Unlink(terms) => terms.iter().for_each(|term| unlink_term(&mut new, term, all)),
            Self::Append(set) => new.linked = joined(&link.linked, set),
            Self::Replace(set) => {
                new = LightLink { linked: set.clone(), unlinked: LightSet::none() };
            }
        }
        new
    }
}

fn members(set: &LightSet, all: &IndexMap<LightId, Light>) -> BTreeSet<LightId> {
    set.of(all, &BTreeSet::new())
}

fn link_term(link: &mut LightLink, term: &SetTerm, all: &IndexMap<LightId, Light>) {
    let wanted = members(&LightSet::none().with(term), all);
    let linked = members(&link.linked, all);
    if !wanted.is_subset(&linked) {
        link.linked =
            undone(&link.linked, term, &wanted, all).unwrap_or_else(|| link.linked.with(term));
    }
    let linked = members(&link.linked, all);
    let unlinked = link.unlinked.of(all, &linked);
    if !wanted.is_disjoint(&unlinked) {
        let parts = link.unlinked.without(term, all);
        // A set that speaks of `{source}` is not undone by its terms.
        let is_left = !wanted.is_disjoint(&parts.of(all, &linked));
        link.unlinked = if is_left { lessened(&parts, term) } else { parts };
    }
}

fn unlink_term(link: &mut LightLink, term: &SetTerm, all: &IndexMap<LightId, Light>) {
    let wanted = members(&LightSet::none().with(term), all);
    if !wanted.is_disjoint(&members(&link.linked, all)) {
        link.linked = link.linked.without(term, all);
    }
}

/// The set without its last ` - term`, where that alone takes the wanted lights out.
fn undone(
    set: &LightSet,
    term: &SetTerm,
    wanted: &BTreeSet<LightId>,
    all: &IndexMap<LightId, Light>,
) -> Option<LightSet> {
    let text = set.text().trim().strip_suffix(&format!("- {term}"))?;
    let before = LightSet::parse(text.trim_end()).ok()?;
    (members(&before, all) == &members(set, all) | wanted).then_some(before)
}

/// Both sets, as one expression.
fn joined(set: &LightSet, more: &LightSet) -> LightSet {
    if set.is_none() {
        return more.clone();
    }
    let text = format!("{} | {}", set.text().trim(), enclosed(more));
    LightSet::parse(&text).unwrap_or_else(|_| set.clone())
}

/// The set without a term, as one expression.
fn lessened(set: &LightSet, term: &SetTerm) -> LightSet {
    LightSet::parse(&format!("{} - {term}", set.text().trim())).unwrap_or_else(|_| set.clone())
}

/// The expression, in parentheses where it has operators.
fn enclosed(set: &LightSet) -> String {
    let text = set.text().trim();
    let is_term = !text.contains(|c: char| c.is_whitespace() || "|&".contains(c));
    if is_term { text.to_owned() } else { format!("({text})") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lights() -> IndexMap<LightId, Light> {
        let of = |groups: &[&str]| Light {
            groups: groups.iter().map(|group| (*group).into()).collect(),
            ..Light::default()
        };
        [("key", of(&[])), ("rim_a", of(&["rim"])), ("rim_b", of(&["rim"])), ("fill", of(&[]))]
            .map(|(id, light)| (LightId::from(id), light))
            .into()
    }

    fn link(linked: &str, unlinked: &str) -> LightLink {
        let set = |text| LightSet::parse(text).unwrap();
        LightLink { linked: set(linked), unlinked: set(unlinked) }
    }

    fn after(change: &LinkChange, [linked, unlinked]: [&str; 2]) -> [String; 2] {
        let new = change.of(&link(linked, unlinked), &lights());
        [new.linked.text().to_owned(), new.unlinked.text().to_owned()]
    }

    #[test]
    fn links_change_by_terms_and_by_expressions() {
        let key = vec![SetTerm::Id("key".to_owned())];
        let rim = vec![SetTerm::Group("rim".to_owned())];
        let (link_key, unlink_key) = (LinkChange::Link(key.clone()), LinkChange::Unlink(key));
        assert_eq!(after(&unlink_key, ["*", ""]), ["* - key", ""]);
        assert_eq!(after(&link_key, ["* - key", ""]), ["*", ""], "and back");
        assert_eq!(after(&link_key, ["fill", ""]), ["fill | key", ""]);
        assert_eq!(after(&unlink_key, ["fill | key", ""]), ["fill", ""]);
        assert_eq!(after(&link_key, ["*", "key | fill"]), ["*", "fill"]);
        assert_eq!(after(&link_key, ["*", "{source}"]), ["*", "{source} - key"]);
        assert_eq!(after(&link_key, ["*", ""]), ["*", ""], "what is linked stays as it is");
        assert_eq!(after(&LinkChange::Link(rim.clone()), ["key", ""]), ["key | group:rim", ""]);
        assert_eq!(after(&LinkChange::Unlink(rim), ["*", ""]), ["* - group:rim", ""]);
        let set = LightSet::parse("group:rim - rim_a").unwrap();
        let append = LinkChange::Append(set.clone());
        assert_eq!(after(&append, ["key", "fill"]), ["key | (group:rim - rim_a)", "fill"]);
        assert_eq!(after(&append, ["", ""]), ["group:rim - rim_a", ""]);
        assert_eq!(after(&LinkChange::Replace(set), ["key", "fill"]), ["group:rim - rim_a", ""]);
    }

    #[test]
    fn links_do_what_they_say_to_every_light() {
        let all = lights();
        let sets = ["*", "", "key", "group:rim", "* - group:rim", "rim_? | fill", "* & group:rim"];
        let terms = [SetTerm::Id("rim_a".to_owned()), SetTerm::Group("rim".to_owned())];
        for (linked, unlinked) in sets.iter().flat_map(|a| sets.iter().map(move |b| (a, b))) {
            for term in &terms {
                let wanted = members(&LightSet::none().with(term), &all);
                let before = link(linked, unlinked);
                for (change, rule) in [
                    (LinkChange::Link(vec![term.clone()]), true),
                    (LinkChange::Unlink(vec![term.clone()]), false),
                ] {
                    let (old, new) = (before.rules(&all), change.of(&before, &all).rules(&all));
                    for (id, found) in &new {
                        let is_linked = *found == LinkRule::Linked;
                        if wanted.contains(id) {
                            assert_eq!(is_linked, rule, "{change:?} of {before:?}: {id}");
                        } else {
                            let was = old[id] == LinkRule::Linked;
                            assert_eq!(is_linked, was, "{change:?} of {before:?} moves {id}");
                        }
                    }
                }
            }
        }
    }
}
