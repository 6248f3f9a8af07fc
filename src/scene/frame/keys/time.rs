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
        // Inside a definition a value belongs to every use of the definition, so only the look's
        // own nodes can be set.
        if let (true, [id]) = (is_word, node.ids())
            && let Some(node) = changed.to_mut().graph.nodes.get_mut(id)
        {
            node.values.insert(port.clone(), value);
        }
    }
    changed
}
