//! Tracks: a value over time, between its keys and beyond them.
//!
//! Values at a time are found among the keys by halving, and handles are worked out from the
//! neighbors alone, so that a track of any length costs its logarithm.

use glam::{DQuat, DVec3, DVec4};

use super::bezier::{BezierSpan, automatic_slope};
use super::blend::{blend, is_direction, numbers_of};
use crate::document::{Extrapolation, TimeInterpolation, TimeKey, TimeKeys, TrackEnds, Value};

/// Times beyond this, in seconds, are taken for it.
const MOST_TIME: f64 = 1e15;
/// Distance in time at which a key counts as reached where keys come again, in seconds.
const SAME_TIME: f64 = 1e-9;
/// Greatest value: that of a shader's numbers.
const MOST: f64 = f32::MAX as f64;
/// Most rounds that offsets of cycles are counted for.
const MOST_ROUNDS: f64 = 1e15;
/// Speed under which a direction beyond an end stands still, in radians per second.
const NO_TURN: f64 = 1e-15;

/// Keys of a value, what holds beyond them, and how they are blended.
#[derive(Clone, Copy, Debug)]
pub struct Track<'a> {
    /// Keys, in increasing time.
    pub keys: &'a [TimeKey],
    /// Extrapolation beyond the keys.
    pub ends: TrackEnds,
    /// True for directions (of three numbers) and rotations (quaternions), which turn.
    pub turns: bool,
}

impl<'a> Track<'a> {
    /// A track of a look or a scene.
    pub fn of(track: &'a TimeKeys) -> Self {
        let turns = is_direction(&track.target);
        Self { keys: &track.keys, ends: track.ends(), turns }
    }

    /// The value at a time, in seconds; `None` for an empty track.
    pub fn at(self, time: f64) -> Option<Value> {
        let (first, last) = (self.keys.first()?, self.keys.last()?);
        let time = if time.is_nan() { first.time } else { time.clamp(-MOST_TIME, MOST_TIME) };
        let (side, is_first) = if time < first.time {
            (self.ends.before, true)
        } else if time > last.time {
            (self.ends.after, false)
        } else {
            (Extrapolation::Hold, true)
        };
        let length = last.time - first.time;
        let has_length = length > 0.0;
        if side == Extrapolation::Hold || !has_length {
            return self.between(time);
        }
        let since = time - first.time;
        let again = |local: f64| self.between(self.at_keys(first.time + local));
        match side {
            Extrapolation::Hold => self.between(time),
            Extrapolation::Linear => self.straight_on(is_first, time),
            Extrapolation::Cycle => again(within_round(since, length)),
            Extrapolation::CycleOffset => {
                let local = within_round(since, length);
                let rounds = ((since - local) / length).round().clamp(-MOST_ROUNDS, MOST_ROUNDS);
                let value = again(local)?;
                Some(self.moved_on(&value, rounds).unwrap_or(value))
            }
            Extrapolation::Mirror => {
                let local = since.rem_euclid(2.0 * length);
                again(if local > length { 2.0 * length - local } else { local })
            }
        }
    }

    /// The value at a time, where the ends hold.
    fn between(self, time: f64) -> Option<Value> {
        let next = self.keys.partition_point(|key| key.time <= time);
        let Some(index) = next.checked_sub(1) else {
            return self.keys.first().map(|key| key.value.clone());
        };
        let before = &self.keys[index];
        let Some(after) = self.keys.get(next) else { return Some(before.value.clone()) };
        let span = after.time - before.time;
        let t = if span > 0.0 { (time - before.time) / span } else { 0.0 };
        let t = match before.interpolation {
            TimeInterpolation::Stepped => return Some(before.value.clone()),
            TimeInterpolation::Linear => t,
            TimeInterpolation::Smooth => t * t * (3.0 - 2.0 * t),
            TimeInterpolation::Bezier if time == before.time => return Some(before.value.clone()),
            TimeInterpolation::Bezier => {
                let spans = self.spans(index);
                let numbers =
                    spans.map(|spans| spans.iter().map(|span| span.at(t)).collect::<Vec<f64>>());
                let value = numbers.and_then(|numbers| self.value_like(&before.value, numbers));
                return Some(value.unwrap_or_else(|| {
                    // Directions whose mean vanishes turn as between other keys.
                    mix(&before.value, &after.value, t, self.turns)
                }));
            }
        };
        Some(mix(&before.value, &after.value, t, self.turns))
    }

    /// A time at which keys come again: that of a key which is reached but for rounding.
    fn at_keys(self, time: f64) -> f64 {
        let next = self.keys.partition_point(|key| key.time <= time + SAME_TIME);
        next.checked_sub(1).map_or(time, |reached| time.max(self.keys[reached].time))
    }

    /// Cubics from a key to the next, one for each number of the values; `None` for words, and
    /// for a last key.
    pub fn spans(self, key: usize) -> Option<Vec<BezierSpan>> {
        let (a, b) = (self.numbers(key)?, self.numbers(key + 1)?);
        let length = self.keys[key + 1].time - self.keys[key].time;
        let width = a.len().max(b.len());
        let span = |c: usize| {
            let values = [component(&a, c)?, component(&b, c)?];
            let (out, back) = (self.outgoing(key, c), self.incoming(key + 1, c));
            Some(BezierSpan::new(length, values, out, back))
        };
        (length > 0.0).then(|| (0..width).map(span).collect())?
    }

    /// Handle of a key toward the key before in one number of the value: seconds, and an offset of
    /// the value. As given, or automatic.
    pub fn incoming(self, key: usize, component: usize) -> [f64; 2] {
        self.keys[key].incoming.get(component).copied().unwrap_or_else(|| {
            let before = key.checked_sub(1).map(|before| &self.keys[before]);
            self.automatic(key, component, before, -1.0)
        })
    }

    /// Handle of a key toward the next key, as [`incoming`](Self::incoming).
    pub fn outgoing(self, key: usize, component: usize) -> [f64; 2] {
        self.keys[key]
            .outgoing
            .get(component)
            .copied()
            .unwrap_or_else(|| self.automatic(key, component, self.keys.get(key + 1), 1.0))
    }

    /// An automatic handle: a third of the way to the neighbor.
    fn automatic(self, key: usize, at: usize, neighbor: Option<&TimeKey>, way: f64) -> [f64; 2] {
        let Some(neighbor) = neighbor else { return [0.0, 0.0] };
        let time = way * (neighbor.time - self.keys[key].time).abs() / 3.0;
        let value = time * self.automatic_slope(key, at);
        [time, if value.is_finite() { value } else { 0.0 }]
    }

    /// Slope of the automatic handles of a key in one number of the value, per second.
    fn automatic_slope(self, key: usize, at: usize) -> f64 {
        let last = self.keys.len() - 1;
        let before = key.checked_sub(1).and_then(|before| self.secant(before, at));
        let after = if key < last { self.secant(key, at) } else { None };
        // Where keys come again, the neighbor of the first is the last but one.
        let (before, after) = match (before, after) {
            (None, Some(own)) => match self.ends.before {
                Extrapolation::Linear => (Some(own), after),
                side if side.is_cycle() => (self.secant(last - 1, at), after),
                _ => (None, after),
            },
            (Some(own), None) => match self.ends.after {
                Extrapolation::Linear => (before, Some(own)),
                side if side.is_cycle() => (before, self.secant(0, at)),
                _ => (before, None),
            },
            both => both,
        };
        match (before, after) {
            (Some([before, since]), Some([after, until])) => {
                automatic_slope([before, after], [since, until])
            }
            _ => 0.0,
        }
    }

    /// Slope from a key to the next in one number of the value, and the seconds between them.
    fn secant(self, key: usize, at: usize) -> Option<[f64; 2]> {
        let (a, b) = (self.numbers(key)?, self.numbers(key + 1)?);
        let length = self.keys[key + 1].time - self.keys[key].time;
        let slope = (component(&b, at)? - component(&a, at)?) / length;
        (length > 0.0).then_some([slope, length])
    }

    /// Numbers of a key's value; those of a direction or a rotation of length 1.
    pub fn numbers(self, key: usize) -> Option<Vec<f64>> {
        let numbers = numbers_of(&self.keys.get(key)?.value)?;
        if self.turns && matches!(numbers.len(), 3 | 4) {
            return unit(numbers);
        }
        Some(numbers)
    }

    /// A value of numbers, in the form that another one has; `None` for a direction without
    /// length.
    fn value_like(self, like: &Value, numbers: Vec<f64>) -> Option<Value> {
        let numbers: Vec<f64> = numbers.into_iter().map(|x| x.clamp(-MOST, MOST)).collect();
        let numbers =
            if self.turns && matches!(numbers.len(), 3 | 4) { unit(numbers)? } else { numbers };
        Some(match (like, numbers.as_slice()) {
            (Value::Number(_), [number]) => Value::Number(*number),
            _ => Value::Vector(numbers),
        })
    }

    /// Change per second at the first or the last key, for each number of the value; `None` where
    /// nothing changes there.
    pub fn end_slope(self, is_first: bool) -> Option<Vec<f64>> {
        let key = if is_first { 0 } else { self.keys.len().checked_sub(2)? };
        let next = self.keys.get(key + 1)?;
        let length = next.time - self.keys[key].time;
        let slopes: Vec<f64> = match self.keys[key].interpolation {
            TimeInterpolation::Stepped | TimeInterpolation::Smooth => return None,
            TimeInterpolation::Linear => {
                let width = self.numbers(key)?.len().max(self.numbers(key + 1)?.len());
                let all = (0..width).map(|at| Some(self.secant(key, at)?[0]));
                all.collect::<Option<_>>()?
            }
            TimeInterpolation::Bezier => {
                let of = |span: &BezierSpan| span.slopes()[usize::from(!is_first)] / length;
                self.spans(key)?.iter().map(of).collect()
            }
        };
        slopes.iter().all(|slope| slope.is_finite()).then_some(slopes)
    }

    /// The direction of length 1 at an end, the one across it that it turns toward, and the speed
    /// in radians per second; `None` where it stands still.
    pub fn end_turn(self, is_first: bool) -> Option<(DVec3, DVec3, f64)> {
        let own = self.numbers(if is_first { 0 } else { self.keys.len().checked_sub(1)? })?;
        let (across, speed) = turning(&own, &self.end_slope(is_first)?)?;
        let vector = |numbers: &[f64]| Some(DVec3::from_slice(numbers.get(..3)?));
        Some((vector(&own)?, vector(&across)?, speed))
    }

    /// The value beyond an end, on its slope; directions and rotations go on turning.
    fn straight_on(self, is_first: bool, time: f64) -> Option<Value> {
        let index = if is_first { 0 } else { self.keys.len() - 1 };
        let key = &self.keys[index];
        let Some(slopes) = self.end_slope(is_first) else { return Some(key.value.clone()) };
        let beyond = time - key.time;
        let own = self.numbers(index)?;
        let own: Vec<f64> = (0..slopes.len()).filter_map(|at| component(&own, at)).collect();
        let numbers = if self.turns && matches!(own.len(), 3 | 4) {
            let Some((across, speed)) = turning(&own, &slopes) else {
                return Some(key.value.clone());
            };
            let (sin, cos) = (speed * beyond).sin_cos();
            own.iter().zip(&across).map(|(own, across)| own * cos + across * sin).collect()
        } else {
            own.iter().zip(&slopes).map(|(value, slope)| value + slope * beyond).collect()
        };
        Some(self.value_like(&key.value, numbers).unwrap_or_else(|| key.value.clone()))
    }

    /// Change of the value from the first key to the last.
    pub fn change(self) -> Option<Vec<f64>> {
        let (first, last) = (self.numbers(0)?, self.numbers(self.keys.len().checked_sub(1)?)?);
        let width = first.len().max(last.len());
        (0..width).map(|at| Some(component(&last, at)? - component(&first, at)?)).collect()
    }

    /// The axis of length 1 and the angle by which directions turn from the first key to the last.
    pub fn turn(self) -> Option<(DVec3, f64)> {
        let of = |key: usize| Some(DVec3::from_slice(self.numbers(key)?.get(..3)?));
        let (first, last) = (of(0)?, of(self.keys.len().checked_sub(1)?)?);
        let cross = first.cross(last);
        Some((cross.try_normalize()?, cross.length().atan2(first.dot(last))))
    }

    /// A value some rounds later: each changes it by as much as the last key differs from the
    /// first.
    fn moved_on(self, value: &Value, rounds: f64) -> Option<Value> {
        let own = numbers_of(value)?;
        let numbers: Vec<f64> = match (self.turns, own.len()) {
            (true, 3) => {
                let (axis, angle) = self.turn()?;
                let turned = DQuat::from_axis_angle(axis, angle * rounds) * DVec3::from_slice(&own);
                turned.to_array().to_vec()
            }
            (true, 4) => {
                let of = |key: usize| {
                    let numbers = self.numbers(key)?;
                    Some(DQuat::from_vec4(DVec4::from_slice(&numbers)))
                };
                let change = of(self.keys.len() - 1)? * of(0)?.inverse();
                let change = if change.w < 0.0 { -change } else { change };
                let (axis, angle) = change.to_axis_angle();
                let turned = DQuat::from_axis_angle(axis, angle * rounds)
                    * DQuat::from_vec4(DVec4::from_slice(&own));
                turned.to_array().to_vec()
            }
            _ => {
                let change = self.change()?;
                let width = change.len();
                let own = (0..width).filter_map(|at| component(&own, at));
                let moved = |(own, change): (f64, &f64)| {
                    if *change == 0.0 { own } else { own + rounds * change }
                };
                own.zip(&change).map(moved).collect()
            }
        };
        self.value_like(value, numbers)
    }
}

/// The time since a round began; the end of one, but for rounding, is the beginning of the next.
fn within_round(since: f64, length: f64) -> f64 {
    let local = since.rem_euclid(length);
    if length - local > SAME_TIME.min(0.5 * length) { local } else { 0.0 }
}

/// A number of a value; colors of three numbers are opaque.
fn component(numbers: &[f64], at: usize) -> Option<f64> {
    numbers.get(at).copied().or((at == 3 && numbers.len() == 3).then_some(1.0))
}

/// Numbers of length 1; `None` where they have no length.
fn unit(numbers: Vec<f64>) -> Option<Vec<f64>> {
    let greatest = numbers.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if !(greatest > 1e-30 && greatest.is_finite()) {
        return None;
    }
    let length = numbers.iter().map(|x| (x / greatest).powi(2)).sum::<f64>().sqrt();
    Some(numbers.into_iter().map(|x| x / greatest / length).collect())
}

/// The way to turn at an end: across the direction or the rotation there, of length 1, and the
/// speed in radians per second; `None` where nothing turns.
fn turning(own: &[f64], slopes: &[f64]) -> Option<(Vec<f64>, f64)> {
    let along: f64 = own.iter().zip(slopes).map(|(own, slope)| own * slope).sum();
    let across = own.iter().zip(slopes).map(|(own, slope)| slope - along * own);
    let across: Vec<f64> = across.collect();
    let speed = across.iter().map(|x| x * x).sum::<f64>().sqrt();
    let turns = speed > NO_TURN && speed.is_finite();
    turns.then(|| (across.iter().map(|x| x / speed).collect(), speed))
}

/// The value between two keys' values; values that cannot be blended (words, switches, curves) hold
/// the first until the second.
fn mix(a: &Value, b: &Value, t: f64, turns: bool) -> Value {
    let weights = [1.0 - t, t];
    blend(&[a, b], &weights, turns).unwrap_or_else(|| a.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(interpolation: TimeInterpolation, keys: &[(f64, f64)]) -> Vec<TimeKey> {
        let key =
            |&(time, value): &(f64, f64)| TimeKey::new(time, Value::Number(value), interpolation);
        keys.iter().map(key).collect()
    }

    fn track(keys: &[TimeKey], ends: Extrapolation) -> Track<'_> {
        Track { keys, ends: TrackEnds { before: ends, after: ends }, turns: false }
    }

    fn number(track: Track<'_>, time: f64) -> f64 {
        match track.at(time) {
            Some(Value::Number(x)) => x,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn tracks_hold_outside_and_go_as_asked_between() {
        let both = [(1.0, 10.0), (3.0, 20.0)];
        let linear = keys(TimeInterpolation::Linear, &both);
        let linear = track(&linear, Extrapolation::Hold);
        assert_eq!(
            [0.0, 1.0, 1.5, 3.0, 9.0].map(|t| number(linear, t)),
            [10.0, 10.0, 12.5, 20.0, 20.0]
        );
        let smooth = keys(TimeInterpolation::Smooth, &both);
        let eased = number(track(&smooth, Extrapolation::Hold), 1.5);
        assert_eq!(eased, 10.0 + 10.0 * (0.25 * 0.25 * 2.5));
        let stepped = keys(TimeInterpolation::Stepped, &both);
        assert_eq!(number(track(&stepped, Extrapolation::Hold), 2.999), 10.0);
        assert!(track(&[], Extrapolation::Cycle).at(0.0).is_none());
        // Two keys with automatic handles ease as smooth ones do.
        let bezier = keys(TimeInterpolation::Bezier, &both);
        assert!((number(track(&bezier, Extrapolation::Hold), 1.5) - eased).abs() < 1e-14);
    }

    #[test]
    fn automatic_handles_are_smooth_and_do_not_overshoot() {
        let all = [(0.0, 0.0), (1.0, 1.0), (2.0, 5.0), (2.5, 5.0), (4.0, -2.0), (5.0, -1.0)];
        let bezier = keys(TimeInterpolation::Bezier, &all);
        let track = track(&bezier, Extrapolation::Hold);
        for pair in all.windows(2) {
            let [(from, a), (to, b)] = pair else { unreachable!() };
            let mut before = *a;
            for i in 0..=50 {
                let now = number(track, from + (to - from) * f64::from(i) / 50.0);
                assert!(now >= a.min(*b) - 1e-12 && now <= a.max(*b) + 1e-12, "{now}");
                assert!((now - before) * (b - a) >= -1e-12, "goes one way");
                before = now;
            }
        }
        for (time, value) in all {
            assert_eq!(number(track, time), value, "exact at keys");
            let slope = |a: f64, b: f64| (number(track, b) - number(track, a)) / (b - a);
            let (left, right) = (slope(time - 1e-6, time), slope(time, time + 1e-6));
            assert!((left - right).abs() < 1e-3, "at {time}: {left} {right}");
        }
    }

    #[test]
    fn a_key_has_the_handles_that_are_given() {
        let mut bezier = keys(TimeInterpolation::Bezier, &[(0.0, 0.0), (3.0, 3.0)]);
        bezier[0].outgoing = vec![[1.0, 1.0]];
        bezier[1].incoming = vec![[-1.0, -1.0]];
        let straight = track(&bezier, Extrapolation::Linear);
        for time in [-9.0, 0.0, 0.7, 3.0, 100.0] {
            assert!((number(straight, time) - time).abs() < 1e-12, "thirds are straight: {time}");
        }
        bezier[0].outgoing = vec![[0.5, 4.0]];
        let bent = track(&bezier, Extrapolation::Linear);
        assert!((number(bent, -1.0) + 8.0).abs() < 1e-12, "on the slope of the handle");
    }

    #[test]
    fn keys_come_again() {
        let all = keys(TimeInterpolation::Linear, &[(1.0, 10.0), (2.0, 14.0), (3.0, 12.0)]);
        let at = |ends, times: [f64; 6]| times.map(|time| number(track(&all, ends), time));
        let times = [1.0, 2.0, 3.0, 4.0, -0.5, 1e9];
        let close = |a: [f64; 6], b: [f64; 6]| {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6 * b.abs()), "{a:?} {b:?}");
        };
        close(at(Extrapolation::Cycle, times), [10.0, 14.0, 12.0, 14.0, 12.0, 14.0]);
        let rounds = (1e9 - 2.0) / 2.0;
        close(
            at(Extrapolation::CycleOffset, times),
            [10.0, 14.0, 12.0, 16.0, 10.0, 14.0 + 2.0 * rounds],
        );
        close(at(Extrapolation::Mirror, times), [10.0, 14.0, 12.0, 14.0, 13.0, 14.0]);
        close(
            at(Extrapolation::Linear, [0.0, 1.0, 3.0, 4.0, -9.0, 13.0]),
            [6.0, 10.0, 12.0, 10.0, -30.0, -8.0],
        );
        // A step that comes again begins at its frame, whatever rounding says.
        let steps: Vec<(f64, f64)> = (0..=7).map(|i| (f64::from(i) / 24.0, f64::from(i))).collect();
        let steps = keys(TimeInterpolation::Stepped, &steps);
        let stepped = track(&steps, Extrapolation::Cycle);
        for frame in -70..70_i32 {
            let wanted = if frame == 7 { 7 } else { frame.rem_euclid(7) };
            assert_eq!(number(stepped, f64::from(frame) / 24.0), f64::from(wanted), "{frame}");
        }
    }

    #[test]
    fn a_cycle_goes_smoothly_through_its_seam() {
        let all = [(0.0, 0.0), (1.0, 2.0), (3.0, 3.0)];
        let bezier = keys(TimeInterpolation::Bezier, &all);
        let track = track(&bezier, Extrapolation::CycleOffset);
        let slope = |a: f64| (number(track, a + 1e-6) - number(track, a)) / 1e-6;
        assert!((slope(3.0 - 1e-6) - slope(3.0)).abs() < 1e-3 && slope(3.0) > 0.3);
        assert!((number(track, 3.0 + 1.0) - 5.0).abs() < 1e-12);
    }

    #[test]
    fn directions_and_rotations_turn_on() {
        let key = |time, value: &[f64]| {
            TimeKey::new(time, Value::Vector(value.to_vec()), TimeInterpolation::Bezier)
        };
        let ends = TrackEnds { before: Extrapolation::Linear, after: Extrapolation::CycleOffset };
        let directions = [key(0.0, &[0.0, 0.0, 2.0]), key(1.0, &[1.0, 0.0, 0.0])];
        let turning = Track { keys: &directions, ends, turns: true };
        for time in [-3.0, -0.2, 0.1, 0.5, 0.9, 1.5, 2.25, 1e6] {
            let Some(Value::Vector(v)) = turning.at(time) else { panic!() };
            let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!((length - 1.0).abs() < 1e-9 && v[1].abs() < 1e-9, "{time}: {v:?}");
        }
        // A quarter turn a second, so that after four all is as before.
        let (early, late) = (turning.at(0.3), turning.at(4.3));
        let (Some(Value::Vector(early)), Some(Value::Vector(late))) = (early, late) else {
            panic!()
        };
        assert!(early.iter().zip(&late).all(|(a, b)| (a - b).abs() < 1e-9), "{early:?} {late:?}");
        let half = 0.5f64.sqrt();
        let rotations = [key(0.0, &[0.0, 0.0, 0.0, 1.0]), key(1.0, &[0.0, half, 0.0, half])];
        let spinning = Track { keys: &rotations, ends, turns: true };
        let Some(Value::Vector(turned)) = spinning.at(2.0) else { panic!() };
        assert!((turned[1].abs() - 1.0).abs() < 1e-9, "half a turn after two seconds: {turned:?}");
    }

    #[test]
    fn no_track_gives_what_is_no_number() {
        use TimeInterpolation::{Bezier, Linear, Smooth, Stepped};
        let most = f64::from(f32::MAX);
        let shapes: [&[(f64, f64)]; 6] = [
            &[(0.0, 1.0)],
            &[(0.0, 1.0), (0.0, 2.0)],
            &[(0.0, -most), (1e-300, most), (1e6, -most)],
            &[(1.0, 1.0), (1.0 + f64::EPSILON, 1.0)],
            &[(-1e6, 0.0), (1e6, 0.0)],
            &[(2.0, 1.0), (2.0, 5.0), (2.0, 1.0), (3.0, 1.0)],
        ];
        let ends = [
            Extrapolation::Hold,
            Extrapolation::Linear,
            Extrapolation::Cycle,
            Extrapolation::CycleOffset,
            Extrapolation::Mirror,
        ];
        for interpolation in [Linear, Smooth, Stepped, Bezier] {
            for shape in shapes {
                let mut all = keys(interpolation, shape);
                for with_handles in [false, true] {
                    if with_handles {
                        all[0].outgoing = vec![[1e30, most]];
                        all.last_mut().unwrap().incoming = vec![[-1e-300, -most]];
                    }
                    for end in ends {
                        for time in
                            [-1e9, -1e300, 0.0, 1e-310, 0.5, 1.0, 2.0, 1e9, f64::INFINITY, f64::NAN]
                        {
                            let value = number(track(&all, end), time);
                            assert!(value.is_finite() && value.abs() <= most, "{value} at {time}");
                        }
                    }
                }
            }
        }
        let words = ["add", "screen"].map(|word| {
            TimeKey::new(f64::from(word.len() as u8), Value::Text(word.into()), Bezier)
        });
        for end in ends {
            let track = track(&words, end);
            assert_eq!(track.at(4.5), Some(Value::Text("add".into())), "words hold");
            assert!(track.at(-1e9).is_some() && track.at(1e9).is_some());
        }
    }

    #[test]
    fn long_tracks_are_searched_and_not_walked() {
        let all: Vec<(f64, f64)> = (0..100_000).map(|i| (f64::from(i), f64::from(i % 7))).collect();
        let all = keys(TimeInterpolation::Bezier, &all);
        let long = track(&all, Extrapolation::Cycle);
        // A walk would take minutes.
        for i in 0..10_000 {
            let time = f64::from(i) * 13_709.3 + 0.5;
            let (here, round_later) = (number(long, time), number(long, time + 99_999.0));
            assert!((0.0..=6.0).contains(&here), "{time}: {here}");
            assert!((here - round_later).abs() < 1e-6, "{time}: {here}, {round_later}");
        }
    }
}
