//! Node files embedded in the crate, found by `build.rs`.

include!(concat!(env!("OUT_DIR"), "/nodes.rs"));
