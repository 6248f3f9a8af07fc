//! From a look to one WGSL module.
