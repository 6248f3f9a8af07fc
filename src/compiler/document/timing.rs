//! Keys in time: how values go from key to key, what holds beyond the first and the last, and
//! markers.

use serde::{Deserialize, Serialize};

use super::described::described;
use super::look::{Target, UnknownFields};
use super::shape::{F32, FAR, FieldKind, LINE, NumberBounds};
use super::value::Value;
use super::word::WordChoice as _;

/// Kind of the handles of a key: an offset in time and one in value for each component.
pub(super) const HANDLES: FieldKind =
    FieldKind::List(&FieldKind::Numbers(2, 2, F32), super::shape::MAX_NUMBERS);

/// Greatest number of markers.
pub(super) const MAX_MARKERS: usize = 10_000;

described! {
    /// The values of one target over time.
    pub struct TimeKeys("time keys", Lines) {
        /// Value that changes.
        target: Target, FieldKind::Target, required;
        /// Values before the first key.
        #[serde(default, skip_serializing_if = "Extrapolation::is_hold")]
        before: Extrapolation = Extrapolation::Hold, FieldKind::Word(Extrapolation::WORDS);
        /// Values after the last key.
        #[serde(default, skip_serializing_if = "Extrapolation::is_hold")]
        after: Extrapolation = Extrapolation::Hold, FieldKind::Word(Extrapolation::WORDS);
        /// The keys, in increasing time.
        keys: Vec<TimeKey> = Vec::new(),
            FieldKind::List(&FieldKind::Object(TimeKey::shape), 100_000);
        unknown;
    }
}

described! {
    /// A value at one time.
    pub struct TimeKey("time key", Line) {
        /// Time, in seconds.
        time: f64, FieldKind::Number(FAR), required;
        /// The value then.
        value: Value, FieldKind::Value, required;
        /// Interpolation to the next key.
        interpolation: TimeInterpolation = TimeInterpolation::Linear,
            FieldKind::Word(TimeInterpolation::WORDS);
        /// The [handle](#handles) toward the key before, for each number of the value: seconds, not
        /// above 0, and an offset of the value.
        #[serde(default, rename = "in", skip_serializing_if = "Vec::is_empty")]
        incoming as "in": Vec<[f64; 2]> = Vec::new(), HANDLES, words "automatic";
        /// The handle toward the next key: seconds, not below 0, and an offset of the value.
        #[serde(default, rename = "out", skip_serializing_if = "Vec::is_empty")]
        outgoing as "out": Vec<[f64; 2]> = Vec::new(), HANDLES, words "automatic";
        /// Handles in the timeline.
        #[serde(default, skip_serializing_if = "HandlePair::is_aligned")]
        handles: HandlePair = HandlePair::Aligned, FieldKind::Word(HandlePair::WORDS);
        unknown;
    }
}

described! {
    /// A time with a name.
    #[serde(default)]
    pub struct Marker("marker", Line) {
        /// Time, in seconds.
        time: f64 = 0.0, FieldKind::Number(FAR), required;
        /// Name of the marker.
        name: String = String::new(), FieldKind::Text(LINE);
        unknown;
    }
}

described! {
    /// A frame with a name.
    #[serde(default)]
    pub struct ShotMarker("shot marker", Line) {
        /// The frame.
        frame: i32 = 0, FieldKind::Number(NumberBounds::whole(-99_999_999.0, 99_999_999.0)),
            required;
        /// Name of the marker.
        name: String = String::new(), FieldKind::Text(LINE);
        unknown;
    }
}

/// Interpolation from a key in time to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum TimeInterpolation {
    /// Even change.
    #[default]
    Linear,
    /// Slow at both keys, without handles.
    Smooth,
    /// No change until the next key.
    Stepped,
    /// Cubic between the keys' handles.
    Bezier,
}

/// Values beyond the first or the last key of a track.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Extrapolation {
    /// The end's value.
    #[default]
    Hold,
    /// On with the slope of the end.
    Linear,
    /// All keys again.
    Cycle,
    /// All keys again, from the value that was reached.
    CycleOffset,
    /// All keys to and fro.
    Mirror,
}

impl Extrapolation {
    /// True for the default, which files leave out.
    pub fn is_hold(&self) -> bool {
        *self == Self::Hold
    }

    /// True for keys that come again, where values pass from the last key to the first.
    pub fn is_cycle(self) -> bool {
        matches!(self, Self::Cycle | Self::CycleOffset)
    }
}

/// The two handles of a key as the timeline moves them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HandlePair {
    /// In one line.
    #[default]
    Aligned,
    /// Each for itself.
    Free,
}

impl HandlePair {
    /// True for the default, which files leave out.
    pub fn is_aligned(&self) -> bool {
        *self == Self::Aligned
    }
}

/// Extrapolation before the first key of a track and after the last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TrackEnds {
    /// Before the first key.
    pub before: Extrapolation,
    /// After the last key.
    pub after: Extrapolation,
}

impl TrackEnds {
    /// True where the end values hold.
    pub fn are_held(self) -> bool {
        self == Self::default()
    }
}

impl TimeKeys {
    /// A track without keys.
    pub fn new(target: Target) -> Self {
        Self {
            target,
            before: Extrapolation::Hold,
            after: Extrapolation::Hold,
            keys: Vec::new(),
            unknown: UnknownFields::new(),
        }
    }

    /// Extrapolation beyond the keys.
    pub fn ends(&self) -> TrackEnds {
        TrackEnds { before: self.before, after: self.after }
    }
}

impl TimeKey {
    /// A key with automatic handles.
    pub fn new(time: f64, value: Value, interpolation: TimeInterpolation) -> Self {
        Self {
            time,
            value,
            interpolation,
            incoming: Vec::new(),
            outgoing: Vec::new(),
            handles: HandlePair::Aligned,
            unknown: UnknownFields::new(),
        }
    }
}
