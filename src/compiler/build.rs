//! Embeds the library's nodes, and the examples.

use chiaro_embed::{Content, Table, embed};

fn main() {
    embed(&[
        Table {
            name: "NODES",
            base: "",
            folders: &["nodes"],
            extensions: &["wgsl", "json"],
            content: Content::Text,
            order: None,
        },
        Table {
            name: "EXAMPLES",
            base: "examples",
            folders: &["looks", "shadows", "hcbtf", "images", "meshes", "scenes", "shots"],
            extensions: &["json", "hcbtf", "png", "ies", "glb"],
            content: Content::Bytes,
            order: Some("order.txt"),
        },
    ]);
}
