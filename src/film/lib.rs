//! Film: many frames, and pictures as compositors take them.
//!
//! [`FrameList`], [`FrameRate`] and [`FramePattern`] say which frames of a scene are drawn, when
//! they are, and into which files. [`exr`] writes pictures as OpenEXR. A [`PlanHasher`] tells
//! frames that would be the same picture, in this run and from run to run.

use chiaro_compiler::{compile, document, library};
use chiaro_files as files;
use chiaro_language::{diag, ids, progress};
use chiaro_scene::{frame, geometry};

mod cryptomatte;
pub mod exr;
mod frames;
mod layers;
mod naming;
mod plan_hash;

pub use cryptomatte::{Cryptomatte, MatteCoverage};
pub use frames::{FrameList, FramePattern, FrameRate};
pub use layers::{
    AskedLayers, Contributions, DrawnLayers, LayeredPlan, MatteKind, contributions, light_shares,
    wire_request,
};
pub use naming::{LayerNaming, free_name, is_legal, legal_name};
pub use plan_hash::PlanHasher;
