//! One file a pass; those with a fixed shader share its name with a file of `shaders/passes/`.

pub(super) mod curvature;
mod look;
mod normals;
