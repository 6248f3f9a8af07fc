//! The reference's rasteriser against what triangles are, and its executor against the plan.

mod coverage;
mod plans;
mod shaders;
mod surfaces;
