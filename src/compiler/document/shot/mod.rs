//! A shot: changes to a scene, or to another shot, for a range of frames.
//!
//! A shot names what it changes and holds nothing else of it. [`Override`]s address values in the
//! words that looks and scenes have already: `lights.key.color`, `objects.hero.transform.translate`
//! and `camera.fov` of a scene; `rim.offset`, `group/blur.radius` and `nodes.rim.muted` of a look.
//! [`place`] finds and sets values by such words, and [`difference`] tells in them what an edit
//! changed.

mod difference;
mod place;

use super::Camera;
use super::UnknownFields;
use super::described::described;
use super::rate::FrameRate;
use super::shape::{FieldKind, LINE, LONG, MAX_PATH, NumberBounds};
use super::timing::{
    Extrapolation, HANDLES, HandlePair, MAX_MARKERS, ShotMarker, TimeInterpolation, TimeKey,
    TrackEnds,
};
use super::value::Value;
use super::word::WordChoice as _;

pub use difference::{ChangedTo, ValueDifference};
pub use place::{BlendKind, ValuePlace, json_of_value, keyed_target};

/// Greatest number of a frame.
const MAX_FRAME: f64 = 99_999_999.0;

/// Frames that a value is held for.
const STEPS: NumberBounds = NumberBounds::whole(1.0, 1000.0);

/// Frames of a farm's task.
const CHUNKS: NumberBounds = NumberBounds::whole(1.0, 100_000.0);

described! {
    /// Changes to a scene, or to another shot, for a range of frames.
    #[serde(default)]
    pub struct Shot("shot", Lines) {
        /// Type of the document.
        "chiaro": FieldKind::Word(&[("shot", "a shot")]), words "what it is opened as";
        /// The version of the format.
        "version": FieldKind::Number(super::shape::FORMAT), json "1";
        /// A JSON Schema for text editors; kept, and not looked at.
        "$schema": FieldKind::Text(LINE), words "none";
        /// Artist's name of the shot.
        name: String = String::new(), FieldKind::Text(LINE);
        /// Paragraph on the shot, for whoever finds it.
        about: String = String::new(), FieldKind::Text(LONG);
        /// Path of the scene that is changed, or of a shot, such as the sequence that this one is
        /// part of; relative to the shot's file.
        scene: String = String::new(), FieldKind::Text(MAX_PATH), required;
        /// The first and the last frame. Frame `F` is at `F / rate` seconds.
        frames: Option<[i32; 2]> = None,
            FieldKind::Numbers(2, 2, NumberBounds::whole(-MAX_FRAME, MAX_FRAME)),
            words "those of the shot it changes, or else the time range of the scene";
        /// Frames per second.
        rate: Option<FrameRate> = None, FieldKind::Rate,
            words "that of the shot it changes, or else of the scene's time range";
        /// Width and height of the picture, in pixels.
        size: Option<[u32; 2]> = None,
            FieldKind::Numbers(2, 2, NumberBounds::whole(1.0, 32_768.0)),
            words "that of the shot it changes, or else by the camera";
        /// Frames for which everything that shades is held: looks, their keys, lights and values of
        /// objects. 1 is on ones, 2 on twos. Cameras and objects move on.
        step: Option<u32> = None, FieldKind::Number(STEPS),
            words "that of the shot it changes, or else 1";
        /// Greatest number of frames of a task, where a farm draws them.
        chunk: Option<u32> = None, FieldKind::Number(CHUNKS),
            words "that of the shot it changes, or else 10";
        /// Camera in place of that of what is changed.
        camera: Option<Camera> = None, FieldKind::Object(Camera::shape), words "none";
        /// Frames with a name.
        markers: Vec<ShotMarker> = Vec::new(),
            FieldKind::List(&FieldKind::Object(ShotMarker::shape), MAX_MARKERS);
        /// Values that are changed.
        overrides: Vec<Override> = Vec::new(),
            FieldKind::List(&FieldKind::Object(Override::shape), 10_000);
        unknown;
    }
}

described! {
    /// A value that a shot changes: set, or keyed.
    pub struct Override("override", Line) {
        /// Path of the look whose value it is, relative to the shot's file.
        look: Option<String> = None, FieldKind::Text(MAX_PATH), words "none: a value of the scene";
        /// The value: of a scene by its fields, `lights.key.color`; of a look by
        /// [target](#targets), `rim.offset`, or by its fields, `nodes.rim.muted`.
        target: String = String::new(), FieldKind::Text(LINE), required;
        /// The value that stands in its place.
        value: Option<Value> = None, FieldKind::Value, words "required, unless `keys` are given";
        /// Values before the first key.
        #[serde(default, skip_serializing_if = "Extrapolation::is_hold")]
        before: Extrapolation = Extrapolation::Hold, FieldKind::Word(Extrapolation::WORDS);
        /// Values after the last key.
        #[serde(default, skip_serializing_if = "Extrapolation::is_hold")]
        after: Extrapolation = Extrapolation::Hold, FieldKind::Word(Extrapolation::WORDS);
        /// Values over frames, in increasing order.
        keys: Vec<ShotKey> = Vec::new(),
            FieldKind::List(&FieldKind::Object(ShotKey::shape), 100_000);
        /// Frames for which a keyed value is held, counted from the shot's first.
        step: u32 = 1, FieldKind::Number(STEPS);
        unknown;
    }
}

described! {
    /// A value at one frame.
    pub struct ShotKey("shot key", Line) {
        /// The frame, or a place between two.
        frame: f64, FieldKind::Number(NumberBounds::new(-MAX_FRAME, MAX_FRAME)), required;
        /// The value then.
        value: Value, FieldKind::Value, required;
        /// Interpolation to the next key.
        interpolation: TimeInterpolation = TimeInterpolation::Linear,
            FieldKind::Word(TimeInterpolation::WORDS);
        /// The [handle](#handles) toward the key before, for each number of the value: frames, not
        /// above 0, and an offset of the value.
        #[serde(default, rename = "in", skip_serializing_if = "Vec::is_empty")]
        incoming as "in": Vec<[f64; 2]> = Vec::new(), HANDLES, words "automatic";
        /// The handle toward the next key: frames, not below 0, and an offset of the value.
        #[serde(default, rename = "out", skip_serializing_if = "Vec::is_empty")]
        outgoing as "out": Vec<[f64; 2]> = Vec::new(), HANDLES, words "automatic";
        /// Handles in the timeline.
        #[serde(default, skip_serializing_if = "HandlePair::is_aligned")]
        handles: HandlePair = HandlePair::Aligned, FieldKind::Word(HandlePair::WORDS);
        unknown;
    }
}

impl ShotKey {
    /// A key with automatic handles.
    pub fn new(frame: f64, value: Value, interpolation: TimeInterpolation) -> Self {
        Self {
            frame,
            value,
            interpolation,
            incoming: Vec::new(),
            outgoing: Vec::new(),
            handles: HandlePair::Aligned,
            unknown: UnknownFields::new(),
        }
    }

    /// The key as one of a track whose times are frames.
    pub fn timed(&self) -> TimeKey {
        let (incoming, outgoing) = (self.incoming.clone(), self.outgoing.clone());
        TimeKey {
            incoming,
            outgoing,
            handles: self.handles,
            unknown: self.unknown.clone(),
            ..TimeKey::new(self.frame, self.value.clone(), self.interpolation)
        }
    }

    /// The key of a track whose times are frames.
    pub fn of_frames(key: TimeKey) -> Self {
        let TimeKey { time, value, interpolation, incoming, outgoing, handles, unknown } = key;
        Self { frame: time, value, interpolation, incoming, outgoing, handles, unknown }
    }
}

impl Override {
    /// Extrapolation beyond the keys.
    pub fn ends(&self) -> TrackEnds {
        TrackEnds { before: self.before, after: self.after }
    }

    /// The value in words: the look that it is of, if any, and its place there.
    pub fn address(&self) -> String {
        value_address(self.look.as_deref(), &self.target)
    }
}

/// A value in words, `looks/hero.json#rim.offset` of a look and `lights.key.color` of the scene.
pub fn value_address(look: Option<&str>, target: &str) -> String {
    look.map_or_else(|| target.to_owned(), |look| format!("{look}#{target}"))
}
