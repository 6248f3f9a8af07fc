//! Names the sources that make what the cache keeps by their hash.

use chiaro_embed::hash_sources;

fn main() {
    hash_sources("CHIARO_SCENE_SOURCES", &[".", "../compiler/document", "../../Cargo.lock"]);
}
