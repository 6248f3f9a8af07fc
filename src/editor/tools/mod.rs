//! Tools of the picture: the probe, the comparison and painted light.

pub(crate) mod fitting;
pub(crate) mod probe;
pub(crate) mod wipe;
