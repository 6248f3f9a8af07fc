//! Value of a document as one that a wedge varies.

use crate::document::{ColorSpace, Target, Value};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::library::Type;
use crate::state::runs::Variation;
use crate::state::session::Session;
use crate::widgets::color;

/// Values of the selected nodes, and of the nodes within those that are groups.
pub(crate) fn selected_values(session: &Session) -> Vec<Target> {
    let selection = &session.selection;
    let nodes = selection.nodes.iter().map(|id| selection.path_of(id)).collect();
    session.look_with_library().values_within(session.graph(), nodes)
}

/// A variation of a value around what it is now; `None` for what no wedge varies, such as a switch.
pub(crate) fn variation_of(owned: OwnedKeys<'_>, target: &Target) -> Option<Variation> {
    let name = match target {
        Target::Input { .. } => target.to_string(),
        Target::Light { light, field } => format!("{light}.{field}"),
    };
    let port = owned.keys.base.port_at(target)?;
    let now = owned.keys.value_now(target)?;
    match (&port.ty, &now) {
        (Type::Color | Type::Composite, now) => {
            // Lights of scenes are told as they are shown, whatever the looks choose.
            let space = match owned.owner {
                Owner::Scene => ColorSpace::Display,
                Owner::Look => owned.session.look().color_space,
            };
            let [r, g, b, _] = color::encoded(now.color_in(space)?, space);
            Some(Variation::of_color(name, [r, g, b]))
        }
        (Type::Float | Type::Angle | Type::Int, Value::Number(number)) => {
            let bounds = [port.min.unwrap_or(f64::MIN), port.max.unwrap_or(f64::MAX)];
            Some(Variation::around(name, *number, port.unit == "rad").within(bounds))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::ids::NodeId;
    use crate::library::Library;

    #[test]
    fn values_within_a_selected_group_vary_by_their_paths() {
        let text = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}}, "nodes": [
            {"id": "rim", "kind": "part", "name": "Rim"}, {"id": "output", "kind": "output"}],
            "wires": [{"from": "rim", "to": "output.color"}],
            "definitions": {"part": {"inputs": [{"name": "reach", "default": 1}],
                "outputs": [{"name": "color"}], "nodes": [{"id": "lit", "kind": "light_layer"}],
                "wires": [{"from": "inputs.reach", "to": "lit.offset"},
                    {"from": "lit", "to": "outputs.color"}]}}}"#;
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.start_from(text, "groups");
        session.selection.nodes.insert(NodeId::new("rim"));
        let found = selected_values(&session);
        let has = |name: &str| found.iter().any(|target| target.to_string() == name);
        assert!(has("rim.reach") && has("rim/lit.opacity") && !has("rim/lit.offset"), "{found:?}");
        let opacity = Target::parse("rim/lit.opacity").unwrap();
        let variation = variation_of(OwnedKeys::of_look(&session), &opacity).unwrap();
        assert_eq!(variation.word(), "rim/lit.opacity=0.5..1/4");
        let title = session.look_with_library().title_of_target(&opacity);
        assert_eq!(title, "Rim / Light layer: Opacity");
    }
}
