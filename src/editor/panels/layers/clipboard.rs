//! Layers on the clipboard: a copy goes there with all that feeds it, as a part of the library
//! does, and is laid over the selected layer where it is pasted, in this look or another.

use std::path::Path;
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{Event, Ui};

use super::row::title_of;
use crate::commands::{Command, LibraryCommand, PartSpot};
use crate::ids::NodeId;
use crate::state::parts::saving::{PartChoice, PartSource};
use crate::state::parts::{Part, PartKind};
use crate::state::session::Session;

/// Runs copy and paste, which the window system sends as events of their own; `acting` are the
/// layers to copy. Returns true where they are to be cut out.
pub(super) fn handle(
    ui: &Ui,
    session: &Session,
    acting: &[NodeId],
    out: &mut Vec<Command>,
) -> bool {
    let is_it = |event: &Event| matches!(event, Event::Copy | Event::Cut | Event::Paste(_));
    let events: Vec<Event> = ui.input_mut(|input| {
        let (taken, left) = std::mem::take(&mut input.events).into_iter().partition(is_it);
        input.events = left;
        taken
    });
    let mut is_cut = false;
    for event in events {
        match event {
            Event::Paste(text) => out.push(paste(session, &text)),
            event => is_cut |= copy(session, acting, out) && event == Event::Cut,
        }
    }
    is_cut
}

/// Copies layers, and tells so or why not. Returns true if they were copied.
pub(super) fn copy(session: &Session, layers: &[NodeId], out: &mut Vec<Command>) -> bool {
    match copied(session, layers) {
        Ok(text) => {
            out.extend([Command::Copy(text), Command::Tell(told(session, layers))]);
            true
        }
        Err(why_not) => {
            out.push(Command::Tell(why_not));
            false
        }
    }
}

/// Sentence on layers that were copied.
pub(super) fn told(session: &Session, layers: &[NodeId]) -> String {
    let names: Vec<String> = layers.iter().map(|id| title_of(session, id)).collect();
    tr!(
        "Copied: {layers} · Ctrl+V lays it over the selected layer, in this look or another",
        layers = names.join(", ")
    )
}

/// Text of layers, with all that feeds them.
fn copied(session: &Session, layers: &[NodeId]) -> Result<String, String> {
    let (look, catalog) = (session.look(), &session.project.catalog);
    let source = PartSource { look, graph: &look.graph, catalog };
    let draft = source.draft(&PartChoice::Layers(layers.to_vec()))?;
    Ok(draft.look.to_text())
}

/// Command that lays the layers of a text over the selected one, or tells that it holds none.
fn paste(session: &Session, text: &str) -> Command {
    // Images are named from the folder of the look, on the clipboard as in its own file.
    let path = session.path().unwrap_or(Path::new(""));
    let part = Part::of_text(text, path)
        .filter(|part| part.content.as_ref().is_ok_and(|content| content.kind == PartKind::Layer));
    match part {
        Some(part) => Command::Library(LibraryCommand::Place(Arc::new(part), PartSpot::Selection)),
        None => Command::Tell(
            tr!("The clipboard holds no layers: other nodes are pasted in the graph").to_owned(),
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    #[test]
    fn layers_are_copied_with_what_feeds_them_and_pasted_as_a_part() {
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.start_from(
            r##"{"name": "Two", "lights": {"back": {"direction": [0.8, 0.5, -0.7]}}, "nodes": [
              {"id": "base", "kind": "base"}, {"id": "tint", "kind": "color_value"},
              {"id": "rim", "kind": "light_layer", "name": "Rim", "values": {"light": "back"}},
              {"id": "output", "kind": "output"}],
            "wires": [{"from": "base", "to": "rim.below"}, {"from": "tint", "to": "rim.convex"},
              {"from": "rim", "to": "output.color"}]}"##,
            "two",
        );
        let text = copied(&session, &["rim".into()]).unwrap();
        let Command::Library(LibraryCommand::Place(part, PartSpot::Selection)) =
            paste(&session, &text)
        else {
            panic!("{text}")
        };
        let look = &part.content.as_ref().unwrap().look;
        assert_eq!((part.name.as_str(), look.graph.nodes.len(), look.lights.len()), ("Rim", 2, 1));
        for other in ["", "some words", "{}", &session.look().to_text()] {
            assert!(matches!(paste(&session, other), Command::Tell(_)), "{other}");
        }
    }
}
