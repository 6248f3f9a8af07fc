//! Panels in which values are drawn and not typed: a layer's profile, values over directions,
//! values over time.

mod handle;
pub(crate) mod keys;
pub(crate) mod mark;
pub(crate) mod profile;
pub(crate) mod still_wires;
pub(crate) mod timeline;
