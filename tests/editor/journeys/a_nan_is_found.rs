//! A node of the artist's own divides 0 by 0 where the light does not reach. The hole in the
//! picture is probed, the first broken wire leads to the node, the node's file is mended, and the
//! picture is whole.

use eframe::egui::{Key, vec2};

use super::artist::{JourneyUser, Studio};

/// A node that gives 0/0 where the tone is 0, in unlit places.
const BROKEN: &str = "/// Glow
///
/// Full where there is any light, and half of that elsewhere.
///
/// @param tone \"Tone\" default=0 : What is evened out.
/// @return glow \"Glow\" : From 0.5 to 1, or so it should be.
fn glow(tone: f32) -> f32 {
    return 0.5 + 0.5 * (tone / tone);
}
";

fn probe(artist: &mut JourneyUser) {
    // A point on the shaded side, down to the right.
    let rect = artist.app().viewport().rect().unwrap();
    let at = rect.center() + vec2(0.26, 0.26) * rect.height();
    artist.hover(at);
    artist.key(Key::I);
    artist.click(at);
    artist.settle();
}

/// Makes the window notice changed files at once, without waiting for the system's report.
fn look_at_files(artist: &mut JourneyUser) {
    artist.app_mut().look_at_files();
    artist.settle();
}

#[test]
fn a_nan_from_a_custom_node_is_found_and_mended() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.app_mut().show_on("shape:sphere");
    artist.save_under(&studio.path("look.json"));
    let whole = artist.picture();

    // The node's file is dropped into the project's folder, and the search knows it.
    studio.write("nodes/glow.wgsl", BROKEN);
    look_at_files(&mut artist);
    assert!(artist.says("loaded again"), "{:?}", artist.app().message());
    let at = artist.on_canvas(0.5, 0.8);
    artist.add_node(at, "glow");
    artist.show_all();
    let at = artist.on_canvas(0.7, 0.9);
    artist.add_node(at, "mix values");
    artist.show_all();
    let at = artist.on_canvas(0.9, 0.9);
    artist.add_node(at, "blend");
    artist.show_all();
    artist.wire("Output Tone of Diffuse", "Input Tone of Glow");
    artist.wire("Output Glow of Glow", "Input Factor of Mix");
    artist.wire("Output Stack of Diffuse", "Input Below of Blend");
    artist.wire("Output Value of Mix", "Input Tone of Blend");
    artist.wire("Output Stack of Blend", "Input Color of Output");
    assert!(
        artist.errors().is_empty(),
        "nothing is wrong with the code as such: {:?}",
        artist.errors()
    );
    let holed = artist.picture();
    holed.differs(&whole);

    // The probe finds the first broken wire.
    probe(&mut artist);
    assert!(artist.says("Go to first broken wire"), "{:?}", artist.app().probe().wires());
    artist.press("Go to first broken wire");
    assert_eq!(artist.selected(), ["glow"]);
    let wires = artist.app().probe().wires();
    let of = |node: &str| wires.iter().find(|wire| wire.node.to_string() == node).unwrap();
    assert!(of("glow").single[0].is_nan() && of("diffuse/blend").is_finite(), "{wires:?}");
    assert_eq!(wires.iter().find(|wire| !wire.is_finite()).unwrap().node.to_string(), "glow");

    // The canvas has the values of this pixel, too, those of groups with them.
    let (canvas, session) = (artist.app().canvas(), artist.app().session());
    assert_eq!(canvas.reading_text(session, "glow"), Some("NaN"));
    assert!(canvas.reading_text(session, "diffuse").is_some());

    // A slip while mending the file: the error is told at the node, and the last good picture
    // stays.
    studio.write("nodes/glow.wgsl", &BROKEN.replace("tone / tone", "toon / tone"));
    look_at_files(&mut artist);
    assert!(
        artist.app().canvas().has_error("glow") && artist.says("toon"),
        "{:?}",
        artist.errors()
    );
    artist.picture().equals(&holed);

    studio.write("nodes/glow.wgsl", &BROKEN.replace("(tone / tone)", "step(1e-6, tone)"));
    look_at_files(&mut artist);
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    assert!(
        artist.app().probe().wires().iter().all(|wire| wire.is_finite()),
        "the kept pixel is read again"
    );
    assert!(!artist.says("Go to first broken wire"));
    artist.key(Key::Escape);
    artist.key(Key::Escape);
    let mended = artist.picture();
    mended.differs(&holed);
    let backdrop = mended.at(0.0, 0.0);
    assert!(mended.object().all(|pixel| pixel[3] == 255) && backdrop[3] == 255);

    let wgsl = studio.finish(artist, "look.json");
    assert!(wgsl.contains("fn shade(") && !wgsl.contains("tone / tone"), "{wgsl}");
}
