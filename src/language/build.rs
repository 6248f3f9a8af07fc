//! Embeds the shaders that every module may import, and those of passes.

use chiaro_embed::{Content, Table, embed};

fn main() {
    let shaders = |name, folders| Table {
        name,
        base: "",
        folders,
        extensions: &["wgsl"],
        content: Content::Text,
        order: None,
    };
    embed(&[shaders("SHADER_LIBRARY", &["shaders/lib"]), shaders("PASSES", &["shaders/passes"])]);
}
