//! Problems in words.

use chiaro_locale::tr;

use crate::diag::{Diagnostic, Place};
use crate::document::Target;
use crate::ids::{NodePath, PortName};
use crate::state::reading::{LookWithLibrary, of_library};

/// A problem with its hints, one a line, for people.
pub(crate) fn sentence(problem: &Diagnostic) -> String {
    let mut text = problem.message.clone();
    for hint in &problem.hints {
        text += "\n";
        text += hint;
    }
    text
}

/// A text of a problem with the marks of code as quotes, in which nodes and their ports have the
/// labels of the canvas: *Back-light / Blend* for `back_light/blend`, and *Below* for `below` where
/// the problem is at that port.
pub(crate) fn labelled(look: LookWithLibrary<'_>, problem: &Diagnostic, text: &str) -> String {
    if let Some(told) = idle_light(look, problem).filter(|_| text == problem.message) {
        return told;
    }
    let Place { node, port, .. } = &problem.place;
    let of_place = |part: &str| {
        let port = port.as_ref().filter(|port| port.as_str() == part)?;
        port_label(look, node.as_ref()?, port)
    };
    let shown = |part: &str| of_place(part).or_else(|| label_of(look, part));
    let mut parts = text.split('`');
    let mut told = parts.next().unwrap_or_default().to_owned();
    for (index, part) in parts.enumerate() {
        match index % 2 {
            0 => told += &format!("\"{}\"", shown(part).unwrap_or(part.to_owned())),
            _ => told += part,
        }
    }
    told
}

/// The words of the window for a change of a look's light that the scene's replaces: the compiler's
/// own say how a file is mended.
fn idle_light(look: LookWithLibrary<'_>, problem: &Diagnostic) -> Option<String> {
    let address = problem.message.split('`').nth(1).filter(|_| problem.code == "idle-override")?;
    let target = Target::parse(address)?;
    let Target::Light { light, .. } = &target else { return None };
    let [name, value] = look.names_of(&target);
    look.look.lights.contains_key(light).then(|| {
        tr!("{name}: {value} of the look changes nothing: the scene's light stands in its place. \
             Reset it in Shot, and set {name} of the scene.")
    })
}

/// The label of a step of the history, in which ports have the labels of the canvas: *Back-light:
/// Stack* for `back_light.below`.
pub(crate) fn step_labelled(look: LookWithLibrary<'_>, label: &str) -> String {
    let word = |whole: &str| {
        // Names of a list end with commas.
        let word = whole.trim_end_matches(',');
        // Words of a sentence have neither of these marks, while ids of several words have one.
        let label = word.contains(['.', '_']).then(|| label_of(look, word)).flatten();
        // A node that is no more is told by its id.
        let words = || (!word.contains('.')).then(|| word.replace('_', " "));
        label.or_else(words).map_or_else(|| whole.to_owned(), |label| label + &whole[word.len()..])
    };
    label.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// Label of a path of nodes, or of a port behind one; `None` for other words, and for nodes that
/// are not there.
fn label_of(look: LookWithLibrary<'_>, word: &str) -> Option<String> {
    let whole = NodePath::parse(word);
    if look.node_at(&whole).is_some() {
        return Some(look.title_of_path(&whole));
    }
    if let Some(target @ Target::Light { light, .. }) = &Target::parse(word)
        && look.look.lights.contains_key(light)
        && target.light_field().is_some()
    {
        let [light, value] = look.names_of(target);
        return Some(format!("{light}: {value}"));
    }
    let (path, port) = word.rsplit_once('.')?;
    let node = NodePath::parse(path);
    let port = port_label(look, &node, &port.into())?;
    Some(format!("{}: {port}", look.title_of_path(&node)))
}

/// Label of an input or an output of a node.
fn port_label(look: LookWithLibrary<'_>, node: &NodePath, port: &PortName) -> Option<String> {
    let kind = look.catalog.of(look.node_at(node)?)?;
    let input = look.port_at(&Target::Input { node: node.clone(), port: port.clone() });
    let output = || kind.outputs.get(kind.output(port.as_str())?).cloned();
    Some(of_library(&input.or_else(output)?.label).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;
    use crate::document::Look;
    use crate::library::Library;

    #[test]
    fn paths_in_texts_have_the_labels_of_the_canvas() {
        let look = r#"{"lights": {"key": {"name": "Sun"}}, "nodes": [{"id": "base", "kind": "base"},
          {"id": "rim", "kind": "light_layer", "name": "Back-light"},
          {"id": "cut_highlight", "kind": "light_layer", "name": "Cut highlight"}]}"#;
        let look = Look::read(look, "test").value.unwrap();
        let library = Library::built_in();
        let mut catalog = Catalog::new(library);
        catalog.sync(&look, library);
        let look = LookWithLibrary { look: &look, catalog: &catalog, library };
        let text = "a ring: `rim.below` leads to `base.below`; `rim` is `a.b`, `x";
        let problem = Diagnostic::error("ring", text);
        let expected = "a ring: \"Back-light: Below\" leads to \"Base: Stack\"; \"Back-light\" is \
                        \"a.b\", \"x\"";
        assert_eq!(labelled(look, &problem, text), expected);
        let problem = problem.node(NodePath::root("rim".into())).port("cutoff".into());
        let told = labelled(look, &problem, "`cutoff` of `rim` is no `falloff`");
        assert_eq!(told, "\"Cut-off\" of \"Back-light\" is no \"falloff\"");
        let step = step_labelled(look, "wire base.below to rim.below");
        assert_eq!(step, "wire Base: Stack to Back-light: Below");
        let step = step_labelled(look, "change keys of lights.key.intensity");
        assert_eq!(step, "change keys of Sun: Intensity");
        let step = step_labelled(look, "change rim.cutoff, rim.below");
        assert_eq!(step, "change Back-light: Cut-off, Back-light: Below");
        assert_eq!(step_labelled(look, "key lights.moon.intensity"), "key lights.moon.intensity");
        assert_eq!(step_labelled(look, "add cut_highlight"), "add Cut highlight");
        assert_eq!(step_labelled(look, "remove old_rim, key"), "remove old rim, key");
    }

    #[test]
    fn an_idle_change_of_a_light_is_told_by_its_name_with_the_way_out() {
        let look = r#"{"lights": {"light": {"name": "Sun"}}, "nodes": [{"id": "light",
          "kind": "base", "name": "Tone"}]}"#;
        let look = Look::read(look, "test").value.unwrap();
        let library = Library::built_in();
        let mut catalog = Catalog::new(library);
        catalog.sync(&look, library);
        let look = LookWithLibrary { look: &look, catalog: &catalog, library };
        let text = "`lights.light.direction` of the look has no effect: the scene has a light \
                    `light`, which stands in its place; leave \"look\" out to change that";
        let told = labelled(look, &Diagnostic::warning("idle-override", text), text);
        assert!(told.starts_with("Sun: Direction of the look changes nothing"), "{told}");
        assert!(told.ends_with("set Sun of the scene."), "{told}");
        let told = labelled(look, &Diagnostic::warning("other", text), text);
        assert!(told.contains("leave \"look\" out"), "{told}");
    }
}
