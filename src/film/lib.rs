//! Film: many frames, and pictures as compositors take them.
//!
//! [`FrameList`], [`FrameRate`] and [`FramePattern`] say which frames of a scene are drawn, when
//! they are, and into which files. [`exr`] writes pictures as OpenEXR. A [`PlanHasher`] tells
//! frames that would be the same picture, in this run and from run to run.

use chiaro_compiler::{compile, document};
use chiaro_files as files;
use chiaro_language::diag;
use chiaro_scene::{frame, geometry};

pub mod exr;
mod frames;
mod plan_hash;

pub use document::FrameRate;
pub use frames::{FrameList, FramePattern};
pub use plan_hash::PlanHasher;
