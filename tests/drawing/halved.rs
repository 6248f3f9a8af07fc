//! A node with a constant, and a look that shows the node: for tests of what depends on a constant.

use chiaro_compiler::library::Library;
use chiaro_scene::frame::SetupLook;
use serde_json::{Value as Json, json};

use crate::eval;

/// The library with a node `half_of`, which gives its input times `constant`.
pub fn library(constant: &str) -> Library {
    let text = format!(
        "/// Half\n///\n/// @param x \"Value\" default=0 : A number.\nfn half_of(x: f32) -> f32 \
         {{\n    return {constant} * x;\n}}\n"
    );
    let mut library = Library::built_in().clone();
    library.add_file("nodes/math/half_of.wgsl", &text);
    assert!(library.problems.is_empty(), "{:?}", library.problems);
    library
}

/// The text of a look that shows half of the `facing` node's value.
pub fn text() -> Json {
    json!({
        "nodes": [
            {"id": "facing", "kind": "facing"},
            {"id": "half", "kind": "half_of"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "facing", "to": "half.x"}, {"from": "half", "to": "output.color"}]
    })
}

/// The look that shows half of the `facing` node's value.
pub fn look() -> SetupLook {
    eval::look(&text())
}
