//! Two layers become a group with a name and an input of its own; the group is shared with the
//! project; another look uses it; and a change of the shared group changes both looks.

use chiaro::document::Value;
use eframe::egui::{Key, Modifiers};

use super::artist::{JourneyUser, Studio};

const CTRL: Modifiers = Modifiers::COMMAND;

/// Moves the pointer over the canvas, where keys are the graph's.
fn over_canvas(artist: &mut JourneyUser) {
    let at = artist.on_canvas(0.5, 0.97);
    artist.hover(at);
}

/// Wires a node of the group between the base and the output of a new look.
fn use_skin(artist: &mut JourneyUser) {
    let at = artist.on_canvas(0.4, 0.85);
    artist.add_node(at, "skin");
    artist.show_all();
    artist.wire("Output Stack of Base", "Input Below of Skin");
    artist.wire("Output Stack of Skin", "Input Color of Output");
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
}

#[test]
fn a_group_is_made_named_shared_and_changed_for_all() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.press("Layer Diffuse");
    artist.press("Add layer");
    artist.press("Add Highlight");
    artist.save_under(&studio.path("one.json"));
    let before = artist.picture();

    // Both layers, selected in the list, become a group.
    let at = artist.place("Layer Diffuse").left_top() + eframe::egui::vec2(60.0, 26.0);
    artist.click_with(CTRL, at);
    artist.settle();
    assert_eq!(artist.selected().len(), 2);
    over_canvas(&mut artist);
    artist.key_with(CTRL, Key::G);
    artist.settle();
    artist.key_with(CTRL, Key::Enter);
    artist.settle();
    assert_eq!(artist.app().session().selection().open_groups().len(), 1);
    let name = artist.text_field("Name");
    artist.type_over(name, "Skin");
    // The highlight's color is an input of the group, as it was changed.
    let definition = artist.look().definitions.values().next().unwrap().clone();
    assert_eq!(definition.label, "Skin");
    assert!(
        definition.inputs.iter().any(|port| port.name.as_str() == "highlight_convex"),
        "{:?}",
        definition.inputs
    );
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());

    // The group is shared with the project: its file is there, and the look uses that file.
    artist.press("Share with the project");
    assert!(studio.path("nodes/skin.json").is_file(), "{:?}", artist.app().message());
    assert!(
        artist.look().definitions.is_empty() && artist.app().session().graph_view().is_read_only()
    );
    artist.press("Go to Look");
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    let group = artist
        .look()
        .graph
        .nodes
        .values()
        .find(|node| node.kind == "skin")
        .expect("a node of it")
        .clone();
    assert_eq!(group.kind, "skin");
    artist.save_under(&studio.path("one.json"));
    // The new input begins with the layer's color.
    let white = artist.picture();
    white.equals(&before);

    // A second look of the same folder, in a window of its own.
    let mut other = studio.window();
    other.save_under(&studio.path("two.json"));
    over_canvas(&mut other);
    let diffuse = other.place_like("Node Diffuse").center_top() + eframe::egui::vec2(0.0, 8.0);
    other.click(diffuse);
    other.key(Key::Delete);
    other.settle();
    use_skin(&mut other);
    other.set_color("Highlight: Convex color", "#20ff40");
    other.save_under(&studio.path("two.json"));
    let green = other.picture();

    // A change of the group in the second look, shared again, changes both looks.
    over_canvas(&mut other);
    other.key_with(CTRL, Key::Enter);
    other.settle();
    assert!(other.app().session().graph_view().is_read_only());
    other.press("Make it the look's own");
    let inner = other.place_like("Node Diffuse").center_top() + eframe::egui::vec2(0.0, 8.0);
    other.click(inner);
    other.settle();
    other.set("Cut-off", "45");
    other.press("Share with the project");
    assert!(other.look().definitions.is_empty(), "{:?}", other.app().message());
    other.press("Go to Look");
    assert!(other.errors().is_empty(), "{:?}", other.errors());
    other.picture().differs(&green);
    let shared =
        chiaro::document::Look::load(&chiaro::files::Disk, &studio.path("nodes/skin.json"))
            .value
            .unwrap();
    let cutoff = &shared.definitions["skin"].graph.nodes["diffuse"].values["cutoff"];
    assert!(
        matches!(cutoff, Value::Number(x) if (x.to_degrees() - 45.0).abs() < 0.1),
        "{cutoff:?}"
    );
    artist.app_mut().look_at_files();
    artist.settle();
    artist.picture().differs(&white);
    assert!(!artist.app().session().is_dirty(), "its own file is as it was");
    drop(artist);
    studio.finish(other, "two.json");
}
