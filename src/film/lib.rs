//! Film: many frames, and pictures as compositors take them.
//!
//! [`FrameList`], [`FrameRate`] and [`FramePattern`] say which frames of a scene are drawn, when
//! they are, and into which files. [`exr`] writes pictures as OpenEXR. A [`PlanHasher`] tells
//! frames that would be the same picture, in this run and from run to run.
//!
//! A [`StoredFrame`] is a file read back: whole or not, compared with another, shown over a
//! backdrop. [`sheet`] lays pictures side by side with labels, [`animated`] makes them move, and
//! [`farm`] writes the jobs of render farms. [`comp`] writes what puts a picture together from its
//! layers, in a compositor. A [`DisplayView`] shows a picture as OpenColorIO has it.

use chiaro_compiler::{catalog, compile, document, library};
use chiaro_files as files;
use chiaro_language::{diag, ids, progress};
use chiaro_scene::{frame, geometry};

mod animation;
mod changes;
pub mod comp;
mod contributions;
mod cryptomatte;
pub mod exr;
pub mod farm;
mod frames;
mod label;
mod layers;
mod naming;
mod plan_hash;
pub mod sheet;
mod stored;
mod tables;
mod view;

pub use animation::{animated, rgb8};
pub use changes::{color_space, color_text, is_hex, value_before};
pub use contributions::{ContributionLayers, Contributions, contributions, light_shares};
pub use cryptomatte::{Cryptomatte, MatteCoverage};
pub use document::FrameRate;
pub use frames::{FrameList, FramePattern};
pub use layers::{
    AskedLayers, DrawnLayers, LayeredPlan, MatteKind, named_outputs, shadow_outputs, wire_request,
};
pub use naming::{LayerNaming, free_name, is_legal, legal_name};
pub use plan_hash::PlanHasher;
pub use stored::{FrameDifference, PLAN_NOTE, StoredFrame};
pub use tables::{CUBE, LayerTable};
pub use view::{BUILT_IN, ColorConfig, DisplayView, VIEW_VARIABLE};
