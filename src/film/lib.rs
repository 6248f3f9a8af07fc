//! Film: many frames, and pictures as compositors take them.
//!
//! [`FrameList`], [`FrameRate`] and [`FramePattern`] say which frames of a scene are drawn, when
//! they are, and into which files. [`exr`] writes pictures as OpenEXR. A [`PlanHasher`] tells
//! frames that would be the same picture, in this run and from run to run.
//!
//! A [`StoredFrame`] is a file read back: whole or not, compared with another, shown over a
//! backdrop. [`sheet`] lays pictures side by side with labels, [`animated`] makes them move, and
//! [`farm`] writes the jobs of render farms.

use chiaro_compiler::{compile, document};
use chiaro_files as files;
use chiaro_language::diag;
use chiaro_scene::{frame, geometry};

mod animation;
pub mod exr;
pub mod farm;
mod frames;
mod label;
mod plan_hash;
pub mod sheet;
mod stored;

pub use animation::{animated, rgb8};
pub use document::FrameRate;
pub use frames::{FrameList, FramePattern};
pub use plan_hash::PlanHasher;
pub use stored::{FrameDifference, PLAN_NOTE, StoredFrame};
