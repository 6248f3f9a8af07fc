//! Lights of a part that comes into a look: those whose work a light of the look does already, and
//! those that the part brings along, under ids and names that are free there.

use chiaro_locale::tr;
use glam::DVec3;
use indexmap::IndexMap;

use crate::catalog::{Catalog, NodeKind};
use crate::document::{Graph, Light, LightField, LightKind, LightSet, LightSpace, Look, Value};
use crate::ids::{LightId, PortName, make_slug};
use crate::library::Type;

/// Greatest angle between the directions of two lights that do the same work, in radians.
const SAME_ANGLE: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Greatest distance between the places of two lights that do the same work, as a share of how far
/// they are from the origin of their frame.
const SAME_DISTANCE: f64 = 0.05;

/// Part with its lights as they are to be in a look.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LitPart {
    /// The part. Its lights are those that the look lacks, under ids and names that are free.
    pub(super) look: Look,
    /// Names of the look's own lights that light the part.
    pub(super) found: Vec<String>,
    /// Names of the lights that come along.
    pub(super) brought: Vec<String>,
}

impl LitPart {
    /// Part as it comes into the look `to`; `catalog` is that of the part.
    pub(super) fn new(to: &Look, part: &Look, catalog: &Catalog) -> Self {
        let mut lit = Self { look: part.clone(), found: Vec::new(), brought: Vec::new() };
        let mut renames = LightRenames::default();
        let mut lights: IndexMap<LightId, Light> = IndexMap::new();
        for (id, light) in &part.lights {
            if let Some((own, in_look)) = counterpart(to, id, light) {
                lit.found.push(in_look.display_name(own).to_owned());
                renames.add((id, light), (own, in_look));
                continue;
            }
            let is_taken = |slug: &str| {
                let all = [&to.lights, &part.lights, &lights];
                all.iter().any(|lights| lights.contains_key(slug))
            };
            let new = match to.lights.contains_key(id) {
                true => LightId::from(make_slug(stem(id), is_taken).as_str()),
                false => id.clone(),
            };
            let mut brought = light.clone();
            brought.name = free_name(&light.name, [&to.lights, &lights]);
            lit.brought.push(brought.display_name(&new).to_owned());
            renames.add((id, light), (&new, &brought));
            lights.insert(new, brought);
        }
        lit.look.lights = lights;
        renames.apply(&mut lit.look, catalog);
        lit
    }

    /// Words on the lights, each after a dot; empty for a part without lights.
    pub(super) fn told(&self) -> String {
        let mut told = String::new();
        if !self.found.is_empty() {
            told += " · ";
            told += &tr!("lit by this look's {names}", names = self.found.join(", "));
        }
        let names = self.brought.join(", ");
        match self.brought.len() {
            0 => {}
            1 => told = told + " · " + &tr!("with its own light {names}"),
            _ => told = told + " · " + &tr!("with its own lights {names}"),
        }
        told
    }
}

/// Light of a look that lights a part in place of the part's own: the one of the same id where it
/// [does the same work](does_same_work), else one that shines as the part's light does and has its
/// name, or the id that an earlier copy of the part has brought.
fn counterpart<'l>(to: &'l Look, id: &LightId, light: &Light) -> Option<(&'l LightId, &'l Light)> {
    let of_id = to.lights.get_key_value(id).filter(|(_, own)| does_same_work(own, light));
    of_id.or_else(|| {
        let is_named = |own: &Light| !light.name.is_empty() && own.name == light.name;
        let is_copy = |own: &LightId| own != id && stem(own) == stem(id);
        to.lights
            .iter()
            .find(|(own_id, own)| (is_named(own) || is_copy(own_id)) && shines_alike(own, light))
    })
}

/// True if a look's own light does the work of a part's light of the same id, so that the part
/// needs none of its own.
///
/// Ids are no names that artists choose: most looks have a `key`, many a `back`, which lie
/// elsewhere in each. A layer for the key is to be lit by the key of the look that it comes into,
/// wherever that is, as long as both shine from the front. A rim, a lamp or anything else is made
/// for the place that its light has, and there the look's own does only where it [shines
/// alike](shines_alike). Color and intensity are the look's in either case.
pub(super) fn does_same_work(own: &Light, light: &Light) -> bool {
    (is_from_front(own) && is_from_front(light)) || shines_alike(own, light)
}

/// True for a light that shines from the viewer's side of the illumination frame.
fn is_from_front(light: &Light) -> bool {
    light.kind == LightKind::Directional
        && light.space == LightSpace::Illumination
        && light.aimed_at.is_none()
        && light.direction[2] > 0.0
}

/// True if two lights are of one kind and frame and shine from nearly the same direction or place.
fn shines_alike(a: &Light, b: &Light) -> bool {
    if (a.kind, a.space, &a.aimed_at) != (b.kind, b.space, &b.aimed_at) {
        return false;
    }
    let is_near = |a: [f64; 3], b: [f64; 3]| {
        let [a, b] = [a, b].map(DVec3::from);
        a.distance(b) <= SAME_DISTANCE * a.length().max(b.length())
    };
    let is_along = |a: [f64; 3], b: [f64; 3]| DVec3::from(a).angle_between(b.into()) <= SAME_ANGLE;
    a.fields().all(|field| match field {
        LightField::Direction => is_along(a.direction, b.direction),
        LightField::Aim => is_along(a.aim, b.aim),
        LightField::Position => is_near(a.position, b.position),
        LightField::Outer => (a.outer - b.outer).abs() <= SAME_ANGLE,
        _ => true,
    })
}

/// An id without the number that made it free: `back` for `back_2`.
fn stem(id: &LightId) -> &str {
    let id = id.as_str();
    let stem = id.trim_end_matches(|c: char| c.is_ascii_digit());
    stem.strip_suffix('_').filter(|stem| stem.len() + 1 < id.len()).unwrap_or(id)
}

/// The name, or with a number where a light is called so; empty stays empty, which is the id.
fn free_name(name: &str, all: [&IndexMap<LightId, Light>; 2]) -> String {
    let is_taken = |name: &str| {
        all.iter()
            .flat_map(|lights| lights.iter())
            .any(|(id, light)| light.display_name(id) == name)
    };
    if name.is_empty() || !is_taken(name) {
        return name.to_owned();
    }
    let mut numbered = (2_u64..).map(|number| format!("{name} {number}"));
    numbered.find(|name| !is_taken(name)).unwrap_or_default()
}

/// Ids and names of a part's lights that are others in the look.
#[derive(Default)]
struct LightRenames {
    ids: IndexMap<LightId, LightId>,
    names: IndexMap<String, String>,
}

impl LightRenames {
    fn add(&mut self, (id, light): (&LightId, &Light), (new, own): (&LightId, &Light)) {
        if new != id {
            self.ids.insert(id.clone(), new.clone());
        }
        let is_renamed = own.name != light.name && ![own, light].iter().any(|l| l.name.is_empty());
        if is_renamed {
            self.names.insert(light.name.clone(), own.name.clone());
        }
    }

    /// Names the lights anew in all nodes of a part, and in those of its groups.
    fn apply(&self, part: &mut Look, catalog: &Catalog) {
        if self.ids.is_empty() && self.names.is_empty() {
            return;
        }
        self.apply_to_graph(&mut part.graph, catalog);
        for (id, definition) in &mut part.definitions {
            self.apply_to_graph(&mut definition.graph, catalog);
            let Some(kind) = catalog.get(id.as_str()) else { continue };
            for port in &mut definition.inputs {
                if let Some(default) =
                    port.default.as_mut().filter(|_| names_light(kind, &port.name))
                {
                    self.apply_to_value(default);
                }
            }
        }
    }

    fn apply_to_graph(&self, graph: &mut Graph, catalog: &Catalog) {
        for node in graph.nodes.values_mut() {
            if let Some(kind) = catalog.of(node).cloned() {
                let named = node.values.iter_mut().filter(|(port, _)| names_light(&kind, port));
                named.for_each(|(_, value)| self.apply_to_value(value));
            }
            let links = &mut node.links;
            let sets = [
                &mut links.layered,
                &mut links.unlayered,
                &mut links.filtered,
                &mut links.unfiltered,
            ];
            for set in sets.into_iter().chain(&mut node.for_each) {
                *set = self.set(set);
            }
        }
    }

    fn apply_to_value(&self, value: &mut Value) {
        if let Value::Text(id) = value
            && let Some(new) = self.ids.get(id.as_str())
        {
            *id = new.to_string();
        }
    }

    /// The set with other ids and names in it; ids with `*` or `?` and groups stay.
    fn set(&self, set: &LightSet) -> LightSet {
        let is_gap = |c: char| c.is_whitespace() || "|&()".contains(c);
        let mut parts = Vec::new();
        for (index, part) in set.text().split('"').enumerate() {
            // Names stand between quotes.
            if index % 2 == 1 {
                parts.push(self.names.get(part).map_or(part, String::as_str).to_owned());
                continue;
            }
            let words = part.split_inclusive(is_gap).map(|word| {
                let id = word.trim_end_matches(is_gap).trim_start_matches('-');
                match self.ids.get(id) {
                    Some(new) => word.replacen(id, new.as_str(), 1),
                    None => word.to_owned(),
                }
            });
            parts.push(words.collect());
        }
        LightSet::parse(&parts.join("\"")).unwrap_or_else(|_| set.clone())
    }
}

/// True for an input that takes the id of a light.
fn names_light(kind: &NodeKind, port: &PortName) -> bool {
    kind.input(port.as_str()).is_some_and(|index| kind.inputs[index].ty == Type::LightName)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    fn light(text: &str) -> Light {
        let look = look(&format!(r#"{{"lights": {{"light": {text}}}}}"#));
        look.lights["light"].clone()
    }

    fn look(text: &str) -> Look {
        let loaded = Look::read(text, "test");
        assert!(!loaded.has_errors(), "{:?}", loaded.diagnostics);
        loaded.value.unwrap()
    }

    fn lit(to: &str, part: &str) -> LitPart {
        let part = look(part);
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&part, Library::built_in());
        LitPart::new(&look(&format!(r#"{{"lights": {to}}}"#)), &part, &catalog)
    }

    /// Part of a layer that is lit by the light `back`.
    fn rim(light: &str) -> String {
        format!(
            r#"{{"lights": {{"back": {light}}}, "nodes": [
              {{"id": "rim", "kind": "light_layer", "values": {{"light": "back"}}}}]}}"#
        )
    }

    fn light_of(lit: &LitPart) -> String {
        match &lit.look.graph.nodes["rim"].values["light"] {
            Value::Text(id) => id.clone(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn lights_do_the_same_work_where_they_shine_alike_or_both_from_the_front() {
        let check = |[a, b]: [&str; 2], is_same: bool| {
            assert_eq!(does_same_work(&light(a), &light(b)), is_same, "{a} {b}");
            assert_eq!(does_same_work(&light(b), &light(a)), is_same, "{b} {a}");
        };
        let rim = r#"{"direction": [0.8, 0.5, -0.7]}"#;
        check(
            [rim, r##"{"name": "Moon", "direction": [1.6, 1, -1.4], "color": "#8090ff"}"##],
            true,
        );
        check([rim, r#"{"direction": [0.82, 0.5, -0.7]}"#], true);
        check([rim, r#"{"direction": [-0.75, 0.1, -0.7]}"#], false);
        check([rim, r#"{"direction": [0.8, 0.5, 0.7]}"#], false);
        check([rim, r#"{"direction": [0.8, 0.5, -0.7], "space": "camera"}"#], false);
        let keys = [r#"{"direction": [-0.6, 0.5, 0.6]}"#, r#"{"direction": [0.5, 0.8, 0.2]}"#];
        check(keys, true);
        let in_world = r#"{"direction": [0.5, 0.8, 0.2], "space": "world"}"#;
        check([keys[0], in_world], false);
        let lamp = r#"{"type": "point", "position": [1, 2, 3]}"#;
        check([keys[0], lamp], false);
        check([lamp, r#"{"type": "point", "position": [1, 2.1, 3]}"#], true);
        check([lamp, r#"{"type": "point", "position": [-1, 2, 3]}"#], false);
        check([lamp, r#"{"type": "spot", "position": [1, 2, 3]}"#], false);
        let spot = r#"{"type": "spot", "position": [1, 2, 3], "aim": [0, -1, 0]}"#;
        check([spot, r#"{"type": "spot", "position": [1, 2, 3], "aim": [0, 0, -1]}"#], false);
    }

    #[test]
    fn a_light_that_is_there_lights_the_part() {
        let part = rim(r#"{"name": "Moon", "direction": [0.8, 0.5, -0.7]}"#);
        let same = lit(r#"{"key": {}, "back": {"direction": [0.8, 0.5, -0.7]}}"#, &part);
        assert_eq!((light_of(&same).as_str(), same.look.lights.len()), ("back", 0));
        assert_eq!(same.told(), " · lit by this look's back");
        let front = rim(r#"{"direction": [-0.6, 0.5, 0.6]}"#);
        let key = lit(r#"{"back": {"name": "Key", "direction": [0.5, 0.8, 0.2]}}"#, &front);
        assert_eq!((light_of(&key).as_str(), key.look.lights.len()), ("back", 0));
        assert_eq!(key.told(), " · lit by this look's Key");
    }

    #[test]
    fn a_rim_brings_its_own_light_once() {
        let part = rim(r#"{"name": "Moon", "direction": [0.8, 0.5, -0.7]}"#);
        let jade = r#"{"back": {"direction": [-0.75, 0.1, -0.7]}}"#;
        let own = lit(jade, &part);
        assert_eq!(light_of(&own), "back_2");
        assert_eq!(own.look.lights["back_2"].direction, [0.8, 0.5, -0.7]);
        assert_eq!(own.told(), " · with its own light Moon");
        // A second copy of the part finds the light of the first, which has been moved a little.
        let moon = r#""back_2": {"name": "Moon", "direction": [0.81, 0.5, -0.7]}"#;
        let there = jade.replace("]}}", &format!("]}}, {moon}}}"));
        let again = lit(&there, &part);
        assert_eq!((light_of(&again).as_str(), again.look.lights.len()), ("back_2", 0));
        assert_eq!(again.told(), " · lit by this look's Moon");
        // A light without a name is known by its id.
        let bare = rim(r#"{"direction": [0.8, 0.5, -0.7]}"#);
        assert_eq!(lit(jade, &bare).told(), " · with its own light back_2");
        // Where the look has no such light, id and name stay.
        let free = lit(r#"{"key": {}}"#, &part);
        assert_eq!(
            (light_of(&free).as_str(), free.told().as_str()),
            ("back", " · with its own light Moon")
        );
        let lamp = lit(r#"{"back": {"type": "point"}}"#, &part);
        assert_eq!(light_of(&lamp), "back_2", "another kind");
    }

    #[test]
    fn names_and_ids_that_are_taken_get_numbers() {
        let part = rim(r#"{"name": "Moon", "direction": [0.8, 0.5, -0.7]}"#);
        let other = r#"{"moon": {"name": "Moon", "direction": [-0.75, 0.1, -0.7]}}"#;
        let named = lit(other, &part);
        assert_eq!(
            (light_of(&named).as_str(), named.told().as_str()),
            ("back", " · with its own light Moon 2")
        );
        let alike = lit(r#"{"moon": {"name": "Moon", "direction": [0.8, 0.5, -0.7]}}"#, &part);
        assert_eq!(
            (light_of(&alike).as_str(), alike.told().as_str()),
            ("moon", " · lit by this look's Moon")
        );
        let side = r#"{"direction": [-0.75, 0.1, -0.7]}"#;
        let twice = lit(&format!(r#"{{"back": {side}, "back_2": {side}}}"#), &part);
        assert_eq!(light_of(&twice), "back_3");
        // The free id is none that another light of the part has.
        let two = part
            .replace(r#""lights": {"#, r#""lights": {"back_2": {"direction": [0, 0.5, -0.7]}, "#);
        let two = lit(&format!(r#"{{"back": {side}}}"#), &two);
        assert_eq!((light_of(&two).as_str(), two.look.lights.len()), ("back_3", 2));
        assert_eq!(two.told(), " · with its own lights back_2, Moon");
    }

    #[test]
    fn groups_and_sets_name_the_light_that_comes_along() {
        let part = r#"{"lights": {"back": {"name": "Moon", "direction": [0.8, 0.5, -0.7]}},
          "nodes": [
            {"id": "rim", "kind": "edge", "for_each": "back | group:back",
              "layered": "* -back", "unlayered": "\"Moon\" & (back)"}],
          "definitions": {"edge": {"inputs": [{"name": "of", "default": "back"}],
            "outputs": [{"name": "color"}], "nodes": [
              {"id": "layer", "kind": "light_layer", "values": {"light": "back"}},
              {"id": "other", "kind": "light_layer"}],
            "wires": [{"from": "inputs.of", "to": "other.light"},
              {"from": "layer", "to": "outputs.color"}]}}}"#;
        let lit = lit(r#"{"back": {"name": "Moon", "direction": [-0.8, 0.5, -0.7]}}"#, part);
        let node = &lit.look.graph.nodes["rim"];
        assert_eq!(node.for_each.as_ref().unwrap().text(), "back_2 | group:back");
        let links = [&node.links.layered, &node.links.unlayered].map(LightSet::text);
        assert_eq!(links, ["* -back_2", "\"Moon 2\" & (back_2)"]);
        let edge = &lit.look.definitions["edge"];
        let named = Some(Value::Text("back_2".to_owned()));
        assert_eq!(edge.graph.nodes["layer"].values.get("light"), named.as_ref());
        assert_eq!(edge.inputs[0].default, named);
    }
}
