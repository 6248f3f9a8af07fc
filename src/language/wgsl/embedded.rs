//! Files embedded in the crate, found by `build.rs`.

include!(concat!(env!("OUT_DIR"), "/shader_library.rs"));
include!(concat!(env!("OUT_DIR"), "/passes.rs"));

/// Paths and texts of the nodes that Chiaro ships, which a crate above this one embeds.
#[cfg(test)]
pub fn shipped_nodes() -> Vec<(String, String)> {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../nodes");
    let mut nodes = Vec::new();
    for category in std::fs::read_dir(root).unwrap() {
        for file in std::fs::read_dir(category.unwrap().path()).unwrap() {
            let path = file.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "wgsl") {
                nodes.push((path.display().to_string(), std::fs::read_to_string(&path).unwrap()));
            }
        }
    }
    nodes
}
