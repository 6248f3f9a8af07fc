//! Looks with many layers without effect.

use std::path::PathBuf;

use chiaro_compiler::document::Look;
use chiaro_scene::frame::SetupLook;
use serde_json::json;

use chiaro_test_support::random::Random;

/// A random stack of layers of which many do nothing: opacity 0, black, no warp, equal colors, the
/// same layer twice.
pub fn idle_stack(random: &mut Random) -> SetupLook {
    let mut nodes =
        vec![json!({"id": "base", "kind": "base", "values": {"color": [0.2, 0.3, 0.4, 1]}})];
    let mut wires = Vec::new();
    let mut below = "base".to_owned();
    for index in 0..2 + random.index(6) {
        let id = format!("layer_{index}");
        let offset = *random.pick(&[0.0, 0.5]);
        let color = *random.pick(&[
            [0.0, 0.0, 0.0, 1.0],
            [0.7, 0.5, 0.3, 1.0],
            [0.7, 0.5, 0.3, 0.5],
            [0.9, 0.1, 0.2, 0.0],
        ]);
        let other = if random.chance(0.5) { color } else { [0.1, 0.6, 0.2, 1.0] };
        nodes.push(json!({"id": id, "kind": "light_layer", "values": {
            "light": *random.pick(&["key", "back"]),
            "type": *random.pick(&["diffuse", "specular", "screen_aligned", "half_vector"]),
            "offset": offset, "falloff": offset + *random.pick(&[0.3, 0.8]), "cutoff": offset + 1.2,
            "convex": color, "concave": other,
            "slope": *random.pick(&[0.0, 0.2]), "amount": *random.pick(&[0.0, 0.4]),
            "blend": *random.pick(&["add", "multiply", "subtract", "alpha", "shade"]),
            "opacity": *random.pick(&[0.0, 0.6, 1.0]), "clamped": random.chance(0.7)
        }}));
        wires.push(json!({"from": format!("{below}.below"), "to": format!("{id}.below")}));
        below = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": format!("{below}.below"), "to": "output.color"}));
    let lights = json!({
        "key": {"direction": [1, 2, 3]},
        "back": {"direction": [-1, 0.5, -1], "intensity": *random.pick(&[0.0, 0.5, 2.0])}
    });
    let json = json!({"lights": lights, "nodes": nodes, "wires": wires});
    let loaded = Look::read(&json.to_string(), "stack.json");
    SetupLook {
        look: loaded.value.expect("a look"),
        source: loaded.source.into(),
        folder: PathBuf::new(),
    }
}
