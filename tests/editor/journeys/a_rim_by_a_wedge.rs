//! A rim is chosen by a wedge: drawn by the program, its sheet opened in the window, and a cell
//! taken by a click on its picture.

use chiaro::document::Value;
use eframe::egui::{Key, Modifiers};

use super::artist::Studio;

#[test]
fn a_rim_is_taken_from_a_sheet() {
    let studio = Studio::new();
    studio.chiaro(&["new", "figure"]);
    let wedge = ["wedge", "figure.json", "-o", "rims.png", "--size", "96x72", "--samples", "1"];
    let varied = ["--vary", "rim.falloff=0.3,0.6", "--vary", "behind.intensity=1,4"];
    studio.chiaro(&[&wedge[..], &varied[..]].concat());
    let mut artist = studio.window_with(&studio.path("figure.json"));
    let before = artist.picture();
    artist.app_mut().answer_dialog(&studio.path("rims.png"));
    artist.key_with(Modifiers::COMMAND, Key::O);
    artist.settle();
    let cell = artist.place_like("Cell 4: ");
    artist.hover(cell.center());
    artist.click(cell.center());
    artist.settle();
    let falloff = &artist.look().graph.nodes["rim"].values["falloff"];
    assert_eq!(*falloff, Value::Number(0.6));
    assert_eq!((artist.look().lights["behind"].intensity, artist.steps()), (4.0, 1));
    assert!(artist.picture() != before, "the rim is brighter");
    artist.undo();
    artist.settle();
    assert!(!artist.app().session().is_dirty() && artist.picture() == before, "one step");
    artist.redo();
    artist.key_with(Modifiers::COMMAND, Key::S);
    artist.settle();
    assert!(studio.read("figure.json").contains("\"intensity\": 4"));
}
