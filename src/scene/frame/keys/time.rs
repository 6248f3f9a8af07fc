//! Words and switches over time, which change what is compiled.

use std::borrow::Cow;

use super::track::Track;
use crate::document::{Look, Target, Value, Values};

/// The look with the words and switches that its time keys and `exposed` values set at that time:
/// the state that is compiled.
pub fn structural_look<'l>(look: &'l Look, time: f64, exposed: &Values) -> Cow<'l, Look> {
    let timed =
        look.time_keys.iter().filter_map(|track| Some((&track.target, Track::of(track).at(time)?)));
    let set = look.exposed.iter().filter_map(|e| Some((&e.target, exposed.get(&e.name)?.clone())));
    let mut changed = Cow::Borrowed(look);
    for (target, value) in set.chain(timed) {
        let Target::Input { node, port } = target else { continue };
        let is_word = matches!(&value, Value::Text(_)) && value.color().is_none();
        // Groups of the library are not read here: they stay as they are.
        if is_word && let Some(node) = changed.to_mut().node_of_one_use(node, |_| None) {
            node.values.insert(port.clone(), value);
        }
    }
    changed
}

#[cfg(test)]
mod tests {
    use super::*;
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
            let now = structural_look(&look, time, &Values::new());
            assert_eq!(mode(&now, "one/layer"), Some(Value::Text(wanted.to_owned())));
            assert_eq!(mode(&now, "two/layer"), None, "the other use keeps its own");
            assert_eq!(now.definitions.len(), 2, "one definition for all words of a use");
        }
    }
}
