//! Comics from Lambert: the soft layer of a new look is cut to a cartoon's two tones, its shadow is
//! filled with dots, and surfaces that turn away are inked.

use super::artist::{JourneyUser, Studio};

const LIT: [u8; 3] = [0xf2, 0xc0, 0x80];
const SHADOW: [u8; 3] = [0xa0, 0x50, 0x48];
const DOTS: [u8; 3] = [0x50, 0x18, 0x30];
const INK: [u8; 3] = [0x10, 0x08, 0x10];

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Adds a node that blends a color over its backdrop, by a tone.
fn add_blend(artist: &mut JourneyUser, at: [f32; 2], name: &str, color: [u8; 3]) {
    let at = artist.on_canvas(at[0], at[1]);
    artist.add_named(at, "blend", name);
    artist.set_word("Mode", "Alpha");
    artist.set_color("Color", &hex(color));
    artist.show_all();
}

#[test]
fn a_lambert_layer_becomes_a_comic() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.app_mut().show_on("shape:sphere");
    artist.settle();
    let lambert = artist.picture();
    artist.press("Base Base");
    artist.set_color("Color", &hex(SHADOW));
    artist.press("Layer Diffuse");
    artist.press("Profile preset Cartoon");
    artist.choose("Blending of Diffuse", "Alpha");
    artist.set_color("Convex color", &hex(LIT));
    artist.set_color("Concave color", &hex(LIT));
    let two = artist.picture();
    two.differs(&lambert);
    let shares = [two.share_of(LIT), two.share_of(SHADOW)];
    assert!(
        shares[0] > 0.1 && shares[1] > 0.1 && shares[0] + shares[1] > 0.9,
        "two flat tones: {shares:?}"
    );

    // Dots in the shadow: a pattern, by the inverted tone.
    add_blend(&mut artist, [0.75, 0.7], "Half-tone", DOTS);
    let at = artist.on_canvas(0.1, 0.75);
    artist.add_named(at, "checker", "Pattern");
    artist.set("Scale", "12");
    artist.show_all();
    let at = artist.on_canvas(0.4, 0.9);
    artist.add_node(at, "multiply");
    artist.show_all();
    // A wire dropped on an empty place opens a search for nodes that fit.
    let (from, nothing) =
        (artist.place("Output Tone of Diffuse").center(), artist.on_canvas(0.3, 0.97));
    artist.drag(from, nothing);
    artist.type_text("invert");
    artist.key(eframe::egui::Key::Enter);
    artist.settle();
    artist.show_all();
    artist.wire("Output Value of Invert", "Input A of Multiply");
    artist.wire("Output Color of Pattern", "Input B of Multiply");
    artist.wire("Output Stack of Diffuse", "Input Below of Half-tone");
    artist.wire("Output Product of Multiply", "Input Tone of Half-tone");
    artist.wire("Output Stack of Half-tone", "Input Color of Output");
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    let dotted = artist.picture();
    let shares = [LIT, SHADOW, DOTS].map(|color| dotted.share_of(color));
    assert!(shares[0] > 0.1 && shares[1] > 0.05 && shares[2] > 0.05, "{shares:?}");
    assert!((shares[0] - two.share_of(LIT)).abs() < 0.01, "the light is left alone");

    // Ink on surfaces that turn away.
    add_blend(&mut artist, [0.85, 0.95], "Ink", INK);
    let at = artist.on_canvas(0.1, 0.95);
    artist.add_node(at, "facing");
    artist.show_all();
    let at = artist.on_canvas(0.3, 0.95);
    artist.add_node(at, "threshold");
    artist.set("Edge", "0.4");
    artist.show_all();
    let at = artist.on_canvas(0.5, 0.95);
    artist.add_named(at, "invert", "Outline");
    artist.show_all();
    artist.wire("Output Facing of Facing ratio", "Input Value of Threshold");
    artist.wire("Output Mask of Threshold", "Input Value of Outline");
    artist.wire("Output Value of Outline", "Input Tone of Ink");
    artist.wire("Output Stack of Half-tone", "Input Below of Ink");
    artist.wire("Output Stack of Ink", "Input Color of Output");
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    let inked = artist.picture();
    let ink = inked.share_of(INK);
    // Seen in perspective from afar, n.v is below 0.4 on about 0.4 squared of the disc.
    assert!(ink > 0.08 && ink < 0.25, "{ink}");

    let wgsl = studio.finish(artist, "comics.json");
    assert!(
        wgsl.contains("half_tone") && wgsl.contains("ink"),
        "the code says what the artist calls it"
    );
}
