//! A rim is chosen by a wedge: its values are varied in the window, drawn by the program beside it,
//! and a cell is taken by a click on the sheet.

use chiaro::document::Value;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};

use super::artist::Studio;

#[test]
fn a_rim_is_taken_from_a_sheet() {
    let studio = Studio::new();
    studio.chiaro(&["new", "figure"]);
    let mut artist = studio.window_with(&studio.path("figure.json"));
    let before = artist.picture();

    // The rim's opacity by its menu, and its light by the list.
    artist.press("Node Rim against the backdrop");
    artist.menu_of("Opacity", "Wedge this value");
    artist.press("Add a value");
    artist.bring(Role::Button, "behind: Intensity");
    artist.press("behind: Intensity");
    for (target, from, to) in [("rim.opacity", "0.25", "1"), ("behind.intensity", "1", "4")] {
        let number_of = format!("Number of values of {target}");
        let [from_at, to_at] = ["from", "to"].map(|end| format!("{target} {end}"));
        for (field, number) in [(from_at, from), (to_at, to), (number_of, "2")] {
            let field = artist.fields_called(&field)[0];
            artist.type_over(field, number);
        }
    }
    artist.press_a(Role::RadioButton, "Cells 160 pixels wide");
    artist.press("Draw 4 cells");

    // The values make room for the sheet.
    let cell = artist.place_like("Cell 2: ");
    artist.hover(cell.center());
    artist.click(cell.center());
    artist.settle();
    let opacity = &artist.look().graph.nodes["rim"].values["opacity"];
    assert_eq!(*opacity, Value::Number(0.25));
    assert_eq!((artist.look().lights["behind"].intensity, artist.steps()), (4.0, 1));
    assert!(artist.picture() != before, "the rim is another");
    artist.undo();
    artist.settle();
    assert!(!artist.app().session().is_dirty() && artist.picture() == before, "one step");
    artist.redo();
    artist.key_with(Modifiers::COMMAND, Key::S);
    artist.settle();
    assert!(studio.read("figure.json").contains("\"intensity\": 4"));
}
