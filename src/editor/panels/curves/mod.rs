//! Panels in which values are drawn and not typed: a layer's profile, values over directions,
//! values over time.

pub(crate) mod keys;
pub(crate) mod profile;
pub(crate) mod timeline;
