//! Documents of an artist: looks, scenes, shots and HCBTFs, and how they are read, edited and
//! written.
//!
//! [`Look::read`], [`Scene::read`] and [`Shot::read`] take JSON and give a value, a [`SourceMap`]
//! and every problem at once; [`Look::to_text`] writes the canonical form, and an unchanged
//! document is written back byte for byte. [`History`] applies every [`Edit`], [`SceneEdit`] and
//! [`HcbtfEdit`], and undoes it; a journal keeps unsaved work. docs/format.md documents the files.

mod check;
mod color;
mod described;
mod edit;
pub mod grouping;
mod hcbtf;
mod hex;
mod image;
mod json;
mod light;
mod look;
mod packed;
mod problems;
mod rate;
mod read;
mod rotation;
mod scene;
mod set;
mod shape;
mod shot;
mod source;
mod storage;
mod structure;
mod text;
mod timing;
mod value;
mod word;
mod write;

pub use color::{linear_to_srgb, parse_hex, srgb_to_linear};
pub use edit::{
    DocumentRevision, Edit, EditResult, Editable, HcbtfEdit, History, HistoryNumbers, Patch,
    SceneEdit, ShotEdit, Step,
};
pub use hcbtf::{
    Address, Angle as HcbtfAngle, Bundle, Direction, Directions, Grid, Hcbtf, HcbtfListing,
    HcbtfManifest, MAX_ANGLE_STEPS, MAX_TILE_SIDE, PaintedSample, Placement, Relief, Rule,
    RuleAbout, RuleField, StrokeGround, StrokeHighlight, StrokeShadow, StrokeShape, StrokeTones,
    Strokes, Tile, read_rules, relief,
};
pub use hex::{long_hex, read_hex};
pub use image::JournalDocument;
pub use light::{
    AimPlaces, GroupMaster, LayerLink, Light, LightField, LightFrames, LightInput, LightKind,
    LightLink, LightOut, LightQuantity, LightRelation, LightSpace, LightValues, LinkRule,
    MAX_EXPOSURE, MAX_INTENSITY, MAX_LIGHT_COLOR, MIN_LIGHT_DISTANCE, NodeLinks, ObjectFrame,
    ShadowLink,
};
pub use look::*;
pub use rate::FrameRate;
pub use read::Document;
pub use scene::*;
pub use set::{LightSet, MemberSet, ObjectSet, SetError, SetMember, SetTerm};
pub use shape::{field_tables, hcbtf_schema, look_schema, scene_schema, shot_schema};
pub use shot::{
    BlendKind, ChangedTo, Override, Shot, ShotKey, ValueDifference, ValuePlace, json_of_value,
    keyed_target, value_address,
};
pub use source::{LoadedDocument, SourceMap};
pub use storage::Storage;
pub use structure::{GraphId, InnerNode};
pub use text::read_text;
pub use timing::{
    Extrapolation, HandlePair, Marker, ShotMarker, TimeInterpolation, TimeKey, TimeKeys, TrackEnds,
};
pub use value::*;

/// Version of the format that this Chiaro writes, and the newest that it reads.
pub const VERSION: u32 = 1;
