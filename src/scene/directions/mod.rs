//! Weights of keys on the sphere of directions (BADF section 3.4 and Appendix B).
//!
//! A key pins values at a direction; between the keys, [`KeyWeights`] gives the share of each key.
//! A weight is made in three steps: a smooth function on the sphere that is 1 at its key and 0 at
//! all others ([`KeyWeights::raw`]), a smoothstep that brings it into [0, 1], and a division that
//! makes all weights sum to 1 ([`KeyWeights::weights`]). [`blend_number`], [`blend_vector`] and
//! [`blend_direction`] then interpolate values with these weights.
//!
//! The paper solves for the smooth functions on a tessellated sphere. Its energy has a limit for
//! ever finer meshes, and that limit has a closed form: one small dense solve for a set of keys,
//! then a sum of kernels, exact between the vertices that a mesh would have, and independent of the
//! orientation of the mesh. So looks use the closed forms (`biharmonic`, `appendix-b`), and the
//! mesh (`tessellated`) is there to compare.
//!
//! Smoothness of the weights: they are C1. Appendix B claims C2, but the second derivative of a raw
//! weight grows like log r toward every key, and the clamp makes it jump where a raw weight leaves
//! [0, 1].

mod blend;
mod closed_form;
mod icosphere;
mod kernel;
mod keys;
mod tessellated;
mod weights;

pub use blend::{blend_direction, blend_number, blend_vector};
pub use kernel::appendix_b_series;
pub use tessellated::Tessellation;
pub use weights::{KeyWeights, SolvedKernel, SolvedWeights, SumKernel};

pub use keys::{CLOSE_ANGLE, MAX_KEYS, MERGE_ANGLE};
