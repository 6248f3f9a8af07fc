//! The node files that the crate carries, listed by `build.rs`.

include!(concat!(env!("OUT_DIR"), "/embedded.rs"));
