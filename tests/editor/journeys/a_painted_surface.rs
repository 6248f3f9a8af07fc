//! A surface painted from nothing: the start page, a new HCBTF, samples for several lights and
//! views, rules for all others, a file, and a look that shows the painting on a ball.

use std::sync::Arc;

use chiaro::document::{Address, Hcbtf, Rule};
use eframe::egui::{Key, Modifiers, Pos2, Role, vec2};

use super::artist::{JourneyUser, Studio};
use crate::editor_support::WINDOW;

/// Fills the tile at work with a color of the palette.
fn flood(artist: &mut JourneyUser, color: &str) {
    artist.press(&format!("Color {color}"));
    artist.press_a(Role::RadioButton, "Fill");
    let at = texel(artist, 8, 8);
    artist.click(at);
    artist.settle();
}

/// The middle of a texel of the canvas.
fn texel(artist: &JourneyUser, x: i32, y: i32) -> Pos2 {
    artist.app().painting().screen([f64::from(x) + 0.5, f64::from(y) + 0.5]).unwrap()
}

fn painted(artist: &JourneyUser) -> &Hcbtf {
    artist.app().session().painting().unwrap().hcbtf()
}

#[test]
fn a_surface_is_painted_from_nothing() {
    let studio = Studio::new();
    let mut artist = studio.window();
    // Few of the start page's pictures are seen in a small window, and so drawn.
    artist.harness.set_size(vec2(800.0, 420.0));
    artist.app_mut().show_start_page();
    artist.settle();
    artist.press("Paint a surface");
    artist.harness.set_size(WINDOW);
    artist.settle();
    artist.press("Small: 16 x 16 texels, 13 lights x 13 views");

    // Straight above: a green with a stripe of yellow, drawn as a line by its key.
    flood(&mut artist, "#3f7a34");
    artist.press("Color #f7db4b");
    let (from, to) = (texel(&artist, 2, 8), texel(&artist, 13, 8));
    artist.hover(from);
    artist.key(Key::L);
    artist.drag(from, to);
    artist.settle();
    assert_eq!(
        painted(&artist).painted(Address::default()).unwrap().texel(8, 8),
        [0xf7, 0xdb, 0x4b, 255]
    );

    // The light sinks to the right by the keys: a darker green. Then the eye goes to the horizon on
    // the map: red.
    artist.hover(from);
    artist.key_with(Modifiers::SHIFT, Key::ArrowDown);
    assert_eq!(artist.app().session().painting().unwrap().at(), Address::new([1, 0], [0, 0]));
    flood(&mut artist, "#1f3d24");
    let low = Address::new([0, 0], [2, 3]);
    let cell = artist.app().painting().cell(low).unwrap().center();
    artist.click(cell);
    artist.settle();
    flood(&mut artist, "#d93a2f");
    assert_eq!(painted(&artist).painted.keys().copied().collect::<Vec<_>>(), {
        let mut all = vec![Address::default(), Address::new([1, 0], [0, 0]), low];
        all.sort();
        all
    });
    assert!(artist.has("3 painted") && artist.has("166 filled"), "13 x 13 but for three, blended");

    // One more rule: filled samples darken as the light sinks.
    artist.press("+ Add a rule");
    artist.press_a(Role::MenuItem, "Darken by Lambert");
    assert!(matches!(painted(&artist).rules[..], [Rule::Blend { .. }, Rule::Lambert { .. }]));

    // The HCBTF is saved by the key, and shown on a ball.
    let path = studio.path("meadow.hcbtf");
    artist.app_mut().answer_dialog(&path);
    artist.key_with(Modifiers::COMMAND, Key::S);
    artist.settle();
    let was = painted(&artist).clone();
    assert_eq!(
        chiaro::hcbtf::load(&chiaro::files::Disk, &path).unwrap().value,
        was,
        "the file holds what was painted"
    );
    artist.choose("On", "Sphere");
    let wgsl = studio.finish(artist, "meadow.json");
    assert!(wgsl.contains("texture_2d_array"), "what was painted is looked up");
    assert!(
        studio.read("meadow.json").contains("\"meadow.hcbtf\""),
        "the look names its neighbour by the way to it"
    );

    // The next day: the HCBTF is opened again, and painted on.
    let mut artist = studio.window();
    artist.app_mut().answer_dialog(&path);
    artist.key_with(Modifiers::COMMAND, Key::O);
    artist.settle();
    assert_eq!(painted(&artist), &was);
    let picture = artist.picture();
    let green = picture.object().filter(|[r, g, b, _]| g > r && g > b).count();
    assert!(green > 300, "the picture shows the meadow: {green}");
    let to = Address::new([2, 0], [0, 0]);
    let cell = artist.app().painting().cell(to).unwrap().center();
    artist.click(cell);
    flood(&mut artist, "#141218");
    artist.key_with(Modifiers::COMMAND, Key::S);
    artist.settle();
    let again = chiaro::hcbtf::load(&chiaro::files::Disk, &path).unwrap().value;
    assert_eq!((again.painted.len(), again.painted(low)), (4, was.painted(low)));
    assert!(!Arc::ptr_eq(again.painted(to).unwrap(), again.painted(low).unwrap()));
}
