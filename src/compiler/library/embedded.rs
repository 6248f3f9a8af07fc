//! The node files that the crate carries, found by `build.rs`.

include!(concat!(env!("OUT_DIR"), "/nodes.rs"));
