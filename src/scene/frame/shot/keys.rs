//! Keys of overrides: from frames to seconds, checked, and held by steps.

use serde_json::{Value as Json, json};

use super::FrameClock;
use crate::diag::Diagnostic;
use crate::document::{
    BlendKind, Interpolation, Override, ShotKey, TimeKey, UnknownFields, Value, json_of_value,
};
use crate::frame::keys::at_time;

/// Most frames over which a value is held by steps.
const MOST_HELD: i64 = 100_000;

/// Keys in seconds, and the frames for which their value is held.
pub(super) struct TimedKeys {
    pub(super) keys: Vec<TimeKey>,
    /// The frames of the first and of the last key.
    range: [f64; 2],
    step: u32,
}

/// A key that cannot stand.
pub(super) struct WrongKey {
    /// Field of the override.
    pub(super) field: String,
    pub(super) problem: Diagnostic,
}

/// Keys of an override in seconds.
///
/// # Errors
/// The first key whose value cannot stand there.
pub(super) fn timed_keys(
    clock: FrameClock,
    changed: &Override,
    blend: BlendKind,
    check: &dyn Fn(&Value) -> Result<(), Diagnostic>,
) -> Result<TimedKeys, Box<WrongKey>> {
    let mut keys: Vec<TimeKey> = Vec::with_capacity(changed.keys.len());
    for (index, key) in changed.keys.iter().enumerate() {
        check(&key.value)
            .map_err(|problem| WrongKey { field: format!("keys[{index}].value"), problem })?;
        let mut value = key.value.clone();
        if blend == BlendKind::Rotation
            && let Some(TimeKey { value: before, .. }) = keys.last()
        {
            turn_the_shorter_way(before, &mut value);
        }
        keys.push(TimeKey {
            time: clock.rate.time_within(key.frame),
            value,
            interpolation: key.interpolation,
            unknown: UnknownFields::new(),
        });
    }
    let at = |key: Option<&ShotKey>| key.map_or(0.0, |key| key.frame);
    let range = [at(changed.keys.first()), at(changed.keys.last())];
    Ok(TimedKeys { keys, range, step: changed.step })
}

/// Turns the sign of a quaternion so that numbers between it and the one before are rotations
/// between them.
fn turn_the_shorter_way(before: &Value, value: &mut Value) {
    if let (Value::Vector(before), Value::Vector(value)) = (before, value)
        && before.iter().zip(&*value).map(|(a, b)| a * b).sum::<f64>() < 0.0
    {
        value.iter_mut().for_each(|number| *number = -*number);
    }
}

impl TimedKeys {
    /// Keys that hold the value for so many frames as the override says.
    ///
    /// # Errors
    /// Keys that reach over more frames than are held.
    pub(super) fn held(
        self,
        clock: FrameClock,
        is_direction: bool,
    ) -> Result<Vec<TimeKey>, Diagnostic> {
        if self.step <= 1 {
            return Ok(self.keys);
        }
        // Frames are bounded by the format.
        let first = clock.held_frame(self.range[0].floor() as i32, self.step);
        let last = self.range[1].ceil() as i32;
        let count = (i64::from(last) - i64::from(first)) / i64::from(self.step) + 2;
        if count > MOST_HELD {
            let message =
                format!("the keys reach over {count} steps; at most {MOST_HELD} are held");
            return Err(Diagnostic::error("too-many", message)
                .hint("write a greater step, or interpolation `stepped` for the keys"));
        }
        let held = |index: i64| {
            let time = clock.rate.time(first + index as i32 * self.step as i32);
            Some(TimeKey {
                time,
                value: at_time(&self.keys, time, is_direction)?,
                interpolation: Interpolation::Stepped,
                unknown: UnknownFields::new(),
            })
        };
        Ok((0..count).filter_map(held).collect())
    }
}

/// Keys as files have them.
pub(super) fn json_of_keys(keys: &[ShotKey]) -> Json {
    let key = |key: &ShotKey| {
        let mut json = json!({ "frame": number(key.frame), "value": json_of_value(&key.value) });
        if key.interpolation != Interpolation::default() {
            json["interpolation"] = json!(key.interpolation);
        }
        json
    };
    keys.iter().map(key).collect()
}

/// A number without a needless point.
fn number(number: f64) -> Json {
    if number.fract() == 0.0 { json!(number as i64) } else { json!(number) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::FrameRate;

    fn changed(keys: &[(f64, f64)], step: u32) -> Override {
        let key = |&(frame, value): &(f64, f64)| ShotKey {
            frame,
            value: Value::Number(value),
            interpolation: Interpolation::Linear,
            unknown: UnknownFields::new(),
        };
        Override {
            look: None,
            target: "lights.key.intensity".to_owned(),
            value: None,
            keys: keys.iter().map(key).collect(),
            step,
            unknown: UnknownFields::new(),
        }
    }

    #[test]
    fn a_value_is_held_from_the_shots_first_frame_on() {
        let clock = FrameClock { first: 1, rate: FrameRate::FILM, shading_step: 1 };
        let keys = |step| {
            let changed = changed(&[(1.0, 0.0), (10.0, 9.0)], step);
            let keys = timed_keys(clock, &changed, BlendKind::Numbers, &|_| Ok(())).ok().unwrap();
            keys.held(clock, false).unwrap()
        };
        let at = |keys: &[TimeKey], frame| match at_time(keys, clock.rate.time(frame), false) {
            Some(Value::Number(number)) => (number * 1e9).round() / 1e9,
            other => panic!("{other:?}"),
        };
        for frame in -3..20 {
            let on_ones = at(&keys(1), frame);
            assert_eq!(on_ones, f64::from(frame.clamp(1, 10) - 1), "{frame}");
            for step in [2, 3, 4] {
                let held = clock.held_frame(frame, step);
                assert_eq!(at(&keys(step), frame), at(&keys(1), held), "{frame} by {step}");
            }
        }
    }

    #[test]
    fn keys_far_apart_take_no_memory_without_bound() {
        let clock = FrameClock { first: 1, rate: FrameRate::FILM, shading_step: 1 };
        let changed = changed(&[(-9e7, 0.0), (9e7, 9.0)], 2);
        let keys = timed_keys(clock, &changed, BlendKind::Numbers, &|_| Ok(())).ok().unwrap();
        assert_eq!(keys.held(clock, false).unwrap_err().code, "too-many");
    }
}
