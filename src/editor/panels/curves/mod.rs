//! Panels in which values are drawn instead of typed: the profile of a layer, values over
//! directions, values over time.

pub(crate) mod keys;
pub(crate) mod profile;
pub(crate) mod timeline;
