//! The reference's rasteriser against what triangles are, and its executor against the plan.

#[path = "reference_raster/coverage.rs"]
mod coverage;
#[path = "reference_raster/plans.rs"]
mod plans;
#[path = "reference_raster/shaders.rs"]
mod shaders;
mod support;
#[path = "reference_raster/surfaces.rs"]
mod surfaces;
