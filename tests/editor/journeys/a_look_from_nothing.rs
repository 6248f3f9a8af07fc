//! Figure 1's look from nothing: base, fill, diffuse, highlight and back-light, each warped by
//! curvature, typed layer by layer. The result is the example that was written by hand.

use std::path::Path;

use eframe::egui::Role;

use super::artist::{JourneyUser, Studio};

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/looks/figure1-layers.json");

/// Types the profile and the warp of the selected layer. Angles in degrees.
fn shape(artist: &mut JourneyUser, angles: [&str; 3], colors: [&str; 2], slope: &str, warp: &str) {
    for (label, text) in ["Offset", "Fall-off", "Cut-off"].into_iter().zip(angles) {
        artist.set(label, text);
    }
    artist.set_color("Convex color", colors[0]);
    artist.set_color("Concave color", colors[1]);
    artist.set("Shape slope", slope);
    artist.set("Shape offset", warp);
}

/// Types the direction of the only light, in the list of lights.
fn direct(artist: &mut JourneyUser, direction: [&str; 3]) {
    artist.tab("Lights");
    direct_shown(artist, direction);
    artist.tab("Layers");
}

/// Types the direction of the shown light: in the inspector, the light of the selected layer.
fn direct_shown(artist: &mut JourneyUser, direction: [&str; 3]) {
    for (axis, text) in direction.into_iter().enumerate() {
        let fields = artist.fields_called("Direction");
        artist.type_over(fields[axis], text);
    }
}

#[test]
fn figure_1_is_built_layer_by_layer() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.press("Base Base");
    artist.set_color("Color", "#15131c");
    direct(&mut artist, ["-0.6", "0.75", "0.65"]);
    assert_eq!(artist.look().lights["key"].direction, [-0.6, 0.75, 0.65]);

    // The lowest layer: a tint everywhere.
    artist.press("Base Base");
    artist.press("Add layer");
    artist.press("Add Ambient");
    artist.set_color("Convex color", "#16131f");
    artist.set_color("Concave color", "#08060d");

    artist.press("Layer Diffuse");
    shape(&mut artist, ["2.9", "71.6", "108.9"], ["#b5662e", "#6e2a1e"], "0.2", "14.3");

    // The highlight, added on the canvas: a node by the search, between the diffuse layer and the
    // output.
    artist.show_all();
    let at = artist.on_canvas(0.75, 0.75);
    let specular = artist.add_named(at, "light layer", "Specular");
    artist.wire("Output Stack of Diffuse", "Input Below of Specular");
    artist.wire("Output Stack of Specular", "Input Color of Output");
    artist.set_word("Shading type", "Specular");
    shape(&mut artist, ["5.7", "14.9", "28.6"], ["#e8d9b8", "#8a5c40"], "0.15", "5.7");

    // The back-light, added in the list of layers over the selected one, with a light of its own.
    artist.press("Layer Specular");
    artist.press("Add layer");
    artist.press("Add Back-light");
    shape(&mut artist, ["28.6", "54.4", "71.6"], ["#4f86b8", "#21456e"], "0.2", "8.6");
    direct_shown(&mut artist, ["0.85", "0.35", "-0.75"]);
    assert_eq!(artist.look().lights["back"].direction, [0.85, 0.35, -0.75]);
    assert_eq!(artist.look().lights.len(), 2, "a light behind was added");
    let wires = &artist.look().graph;
    assert_eq!(
        wires.wire_into(&"back_light".into(), &"below".into()).unwrap().from.node.as_str(),
        specular
    );
    assert!(
        artist.app().session().compilation().problems().is_empty(),
        "{:?}",
        artist.app().session().compilation().problems()
    );
    let rows = ["Back-light", "Specular", "Diffuse", "Ambient"]
        .map(|name| artist.place(&format!("Layer {name}")).min.y);
    assert!(
        rows.windows(2).all(|pair| pair[0] < pair[1]),
        "the list is the stack, from the top: {rows:?}"
    );

    artist.look_from_the_front();
    let own = artist.picture();
    let mut example = studio.window_with(Path::new(EXAMPLE));
    let difference = own.difference_from(&example.picture());
    // Angles were typed to a tenth of a degree, colors to 1/255.
    assert!(difference.mean < 0.3 && difference.max <= 12, "{difference:?}");
    drop(example);

    // A hidden layer leaves the picture, and comes back.
    artist.press_a(Role::CheckBox, "Show Back-light");
    artist.picture().differs(&own);
    artist.press_a(Role::CheckBox, "Show Back-light");
    artist.picture().equals(&own);

    let wgsl = studio.finish(artist, "figure1.json");
    for name in ["ambient", "diffuse", "specular", "back_light"] {
        assert!(wgsl.contains(name), "the code calls the layer {name} as the artist does");
    }
}
