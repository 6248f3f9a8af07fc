//! An HCBTF that is painted: the document with its past, and the look that shows it.

pub(crate) mod home;
pub(crate) mod keeping;
pub(crate) mod look;
pub(crate) mod work;
