//! The reference's rasterizer against the geometry of triangles, and its executor against the plan.

mod coverage;
mod plans;
mod shaders;
mod surfaces;
