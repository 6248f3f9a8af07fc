//! Words over time, which change what is compiled.

use std::borrow::Cow;

use super::track::Track;
use crate::document::{Look, Target, Value, Values};
use crate::library::Library;

/// The look with the words that its time keys and `exposed` values set at that time, in seconds:
/// the state that is compiled. A word within a group, of the look or of the library, is of one use;
/// a look that has all these words already is not copied.
pub fn structural_look<'l>(
    look: &'l Look,
    library: &Library,
    time: f64,
    exposed: &Values,
) -> Cow<'l, Look> {
    let timed =
        look.time_keys.iter().filter_map(|track| Some((&track.target, Track::of(track).at(time)?)));
    let set = look.exposed.iter().filter_map(|e| Some((&e.target, exposed.get(&e.name)?.clone())));
    let mut changed = Cow::Borrowed(look);
    for (target, value) in set.chain(timed) {
        let Target::Input { node, port } = target else { continue };
        let is_word = matches!(&value, Value::Text(_)) && value.color().is_none();
        let is_new = || {
            let found = library.node_of(&changed, node.ids());
            found.is_some_and(|(_, node)| node.values.get(port) != Some(&value))
        };
        if is_word
            && is_new()
            && let Some(node) = library.node_of_one_use(changed.to_mut(), node)
        {
            node.values.insert(port.clone(), value);
        }
    }
    changed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::{CompileOptions, compile};
    use crate::ids::NodePath;

    #[test]
    fn a_word_within_a_group_steps_in_that_use_alone() {
        let text = r#"{"definitions": {"glow": {"inputs": [{"name": "below"}], "outputs": ["stack"],
            "nodes": [{"id": "layer", "kind": "blend"}],
            "wires": [{"from": "inputs.below", "to": "layer.below"},
              {"from": "layer", "to": "outputs.stack"}]}},
          "nodes": [{"id": "one", "kind": "glow"}, {"id": "two", "kind": "glow"},
            {"id": "output", "kind": "output"}],
          "time_keys": [{"target": "one/layer.mode", "keys": [
            {"time": 0, "value": "add"}, {"time": 1, "value": "multiply"}]},
            {"target": "one/layer.clamp", "keys": [{"time": 0, "value": "on"}]}]}"#;
        let look = Look::read(text, "look").value.expect("a look");
        let mode = |look: &Look, path: &str| {
            let path = NodePath::parse(path);
            let kind = &look.graph.nodes[&path.ids()[0]].kind;
            look.definitions[kind.as_str()].graph.nodes["layer"].values.get("mode").cloned()
        };
        for (time, wanted) in [(0.5, "add"), (1.5, "multiply")] {
            let now = structural_look(&look, Library::built_in(), time, &Values::new());
            assert_eq!(mode(&now, "one/layer"), Some(Value::Text(wanted.to_owned())));
            assert_eq!(mode(&now, "two/layer"), None, "the other use keeps its own");
            assert_eq!(now.definitions.len(), 2, "one definition for all words of a use");
        }
    }

    #[test]
    fn a_word_within_a_group_of_the_library_steps_and_is_exposed() {
        let mut library = Library::built_in().clone();
        let group = r#"{"definitions": {"glow": {"inputs": [{"name": "below"}],
            "outputs": [{"name": "stack"}], "nodes": [{"id": "layer", "kind": "blend",
              "values": {"mode": "add", "color": [0.5, 0.2, 0.1]}}],
            "wires": [{"from": "inputs.below", "to": "layer.below"},
              {"from": "layer", "to": "outputs.stack"}]}}}"#;
        library.add_groups("nodes/layer/glow.json", group);
        assert!(library.problems.is_empty(), "{:?}", library.problems);
        let text = r#"{"nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.5, 0.6, 0.7]}},
            {"id": "one", "kind": "glow"}, {"id": "two", "kind": "glow"},
            {"id": "output", "kind": "output"}],
          "wires": [{"from": "base", "to": "one.below"}, {"from": "one", "to": "two.below"},
            {"from": "two", "to": "output.color"}],
          "exposed": [{"name": "top", "target": "two/layer.mode"}],
          "time_keys": [{"target": "one/layer.mode", "keys": [
            {"time": 0, "value": "add"}, {"time": 1, "value": "multiply"}]}]}"#;
        let look = Look::read(text, "look").value.expect("a look");
        let at = |time, exposed: &Values| structural_look(&look, &library, time, exposed);
        let modes = |look: &Look| {
            ["one/layer", "two/layer"].map(|path| {
                let found = library.node_of(look, NodePath::parse(path).ids());
                found.and_then(|(_, node)| node.values.get("mode").cloned())
            })
        };
        let word = |word: &str| Some(Value::Text(word.to_owned()));
        let shader = |look: &Look| {
            let compiled = compile(look, &library, &CompileOptions::default());
            compiled.expect("a good look").value.wgsl
        };

        let none = Values::new();
        let before = at(0.5, &none);
        assert!(matches!(before, Cow::Borrowed(_)), "the group has the word already");
        let after = at(1.5, &none);
        assert_eq!(modes(&after), [word("multiply"), word("add")]);
        assert_ne!(shader(&after), shader(&before));
        assert_eq!(modes(&look), [word("add"), word("add")], "the look's file says so still");

        let set: Values = [("top".into(), Value::Text("screen".to_owned()))].into();
        let now = at(1.5, &set);
        assert_eq!(modes(&now), [word("multiply"), word("screen")]);
        assert_ne!(shader(&now), shader(&after));
    }

    #[test]
    fn what_names_no_node_copies_nothing() {
        let text = r#"{"nodes": [{"id": "rim", "kind": "light_layer"}], "time_keys": [
            {"target": "rim/nothing.mode", "keys": [{"time": 0, "value": "add"}]},
            {"target": "rim.opacity", "keys": [{"time": 0, "value": 0.5}]}]}"#;
        let look = Look::read(text, "look").value.expect("a look");
        let now = structural_look(&look, Library::built_in(), 0.0, &Values::new());
        assert!(matches!(now, Cow::Borrowed(_)));
    }
}
