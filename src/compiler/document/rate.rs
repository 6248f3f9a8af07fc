//! Rates of frames, exactly.

use std::str::FromStr;

use chiaro_locale::tr;
use serde::{Deserialize, Serialize};

use super::UnknownFields;
use super::described::FieldType;
use super::json::{JsonKind, JsonWriter, ValueIndex};
use super::read::reader::Reader;
use super::shape::{FieldKind, LINE};
use crate::diag::Diagnostic;

/// Frames per second: a whole number, or one of the rates of television, which are those times
/// 1000 / 1001.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct FrameRate {
    /// Frames in [`Self::seconds`] seconds.
    pub frames: u32,
    /// Seconds.
    pub seconds: u32,
}

/// Greatest distance of a time from a frame's that counts as the frame's, in frames: files and
/// fields round times to microseconds.
const ON_FRAME: f64 = 1e-4;

impl FrameRate {
    /// The rate of film.
    pub const FILM: Self = Self { frames: 24, seconds: 1 };

    /// The time at which a frame begins, in seconds: frame 0 begins at 0.
    pub fn time(self, frame: i32) -> f64 {
        self.time_within(f64::from(frame))
    }

    /// The time of a frame, or of a place between two, in seconds.
    pub fn time_within(self, frame: f64) -> f64 {
        frame * f64::from(self.seconds) / f64::from(self.frames)
    }

    /// The frame that is shown at a time, in seconds. A time that was computed from a frame gives
    /// that frame, whatever its last digits.
    pub fn frame_at(self, time: f64) -> i32 {
        // As floats become whole numbers, those that are too great become the greatest.
        (self.frame_within(time) + 1e-6).floor() as i32
    }

    /// The frame at a time in seconds, or the place between two: a whole number for a time that was
    /// computed from a frame and then rounded to microseconds.
    pub fn frame_within(self, time: f64) -> f64 {
        let frame = time * self.per_second();
        if (frame - frame.round()).abs() < ON_FRAME { frame.round() } else { frame }
    }

    /// The exact time of the frame whose rounded time is given, in seconds; times between two
    /// frames stay.
    pub fn exact(self, time: f64) -> f64 {
        let frame = self.frame_within(time);
        if frame.fract() == 0.0 { self.time_within(frame) } else { time }
    }

    /// Frames per second.
    pub fn per_second(self) -> f64 {
        f64::from(self.frames) / f64::from(self.seconds)
    }

    /// The number of frames that clocks count in a second.
    pub fn nominal(self) -> u32 {
        self.frames.div_ceil(self.seconds)
    }
}

impl FromStr for FrameRate {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        /// Rates of television as people write them, and the whole number that each is near to.
        const OF_TELEVISION: [(&str, u32); 6] = [
            ("23.976", 24),
            ("23.98", 24),
            ("29.97", 30),
            ("47.952", 48),
            ("59.94", 60),
            ("119.88", 120),
        ];
        if let Some((_, whole)) = OF_TELEVISION.iter().find(|(written, _)| *written == text) {
            return Ok(Self { frames: whole * 1000, seconds: 1001 });
        }
        let (frames, seconds) = text.split_once('/').unwrap_or((text, "1"));
        let number =
            |text: &str| text.parse().ok().filter(|number| (1..=1_000_000).contains(number));
        let rate = number(frames).zip(number(seconds));
        rate.map(|(frames, seconds)| Self { frames, seconds }).ok_or_else(|| {
            tr!("write frames per second as 24, as 23.976, or as a fraction such as 24000/1001")
                .to_owned()
        })
    }
}

impl std::fmt::Display for FrameRate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { frames, seconds } = self;
        if *seconds == 1 { write!(f, "{frames}") } else { write!(f, "{frames}/{seconds}") }
    }
}

/// Whole number, or a fraction as a text.
impl FieldType for FrameRate {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        _kind: &'static FieldKind,
        _: &mut UnknownFields,
    ) -> Option<Self> {
        let text = match r.tree.kind(at) {
            JsonKind::Bad => return None,
            JsonKind::Number => r.tree.number(at).map(|number| number.to_string()),
            _ => Some(r.text_at(at, LINE)?.into_owned()),
        };
        let rate = text.unwrap_or_default().parse::<Self>();
        if rate.is_err() {
            let problem = Diagnostic::error("bad-rate", tr!("this is no rate of frames"));
            r.report(
                at,
                problem.hint(tr!("write 24, 23.976, or a fraction such as \"24000/1001\"")),
            );
        }
        rate.ok()
    }

    fn write(&self, w: &mut JsonWriter, _unknown: Option<&UnknownFields>) {
        if self.seconds == 1 {
            w.number(f64::from(self.frames));
        } else {
            w.string(&self.to_string());
        }
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_exact() {
        let rate = |text: &str| text.parse::<FrameRate>();
        assert_eq!(rate("24"), Ok(FrameRate::FILM));
        assert_eq!(rate("23.976"), Ok(FrameRate { frames: 24_000, seconds: 1001 }));
        assert_eq!(rate("30000/1001"), rate("29.97"));
        assert_eq!(rate("29.97").unwrap().nominal(), 30);
        assert_eq!(FrameRate::FILM.time(36), 1.5);
        assert_eq!(rate("24000/1001").unwrap().time(24_000), 1001.0);
        for wrong in ["0", "-24", "24/0", "fast", "24.5", "1e3"] {
            assert!(rate(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn times_in_microseconds_are_those_of_their_frames() {
        for rate in ["24", "25", "23.976", "30", "59.94", "120"] {
            let rate = rate.parse::<FrameRate>().unwrap();
            for frame in -240..=240 {
                let rounded = (rate.time(frame) * 1e6).round() / 1e6;
                assert_eq!(rate.exact(rounded), rate.time(frame), "{frame} at {rate}");
                assert_eq!(rate.frame_at(rounded), frame, "{frame} at {rate}");
            }
        }
        assert_eq!(FrameRate::FILM.exact(0.123), 0.123, "between two frames");
    }

    #[test]
    fn a_frame_is_shown_at_its_own_time() {
        for rate in ["24", "25", "23.976", "59.94", "1"].map(|text| text.parse::<FrameRate>()) {
            let rate = rate.unwrap();
            for frame in [-1001, -1, 0, 1, 7, 1001, 86_399, 172_800] {
                assert_eq!(rate.frame_at(rate.time(frame)), frame, "{rate}");
                assert_eq!(rate.frame_at(rate.time_within(f64::from(frame) + 0.9)), frame);
            }
        }
    }
}
