//! The profile as numbers: run by the interpreter from the same WGSL that the shader contains.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use crate::document::Tier;
use crate::interp::{Precision, Program, Value};
use crate::library::{ArgumentSource, Library, NodeDef, NodeFunction};

/// Offset, fall-off and cut-off, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shape {
    pub(super) offset: f64,
    pub(super) falloff: f64,
    pub(super) cutoff: f64,
}

impl Shape {
    /// Shape in order, as the shader takes it (docs/math.md D2): the offset within a half turn, the
    /// cut-off after it, the fall-off between both.
    pub(super) fn sanitized(self) -> Self {
        let offset = self.offset.clamp(0.0, PI);
        let cutoff = self.cutoff.clamp(offset, PI);
        Self { offset, falloff: self.falloff.clamp(offset, cutoff), cutoff }
    }
}

/// Bends of a curve between its offset and its cut-off (docs/math.md 2.2); angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bend {
    /// Curve that is 1 everywhere.
    Ambient,
    /// Step from 1 to 0.
    Step,
    /// One bend, at the fall-off.
    Once,
    /// Bend at the end: the fall-off is the cut-off and at most a quarter turn from the offset, so
    /// that the curve grows steeper up to there.
    AtEnd,
    /// Bends at the fall-off and at a second place.
    Twice(f64),
    /// One bend, elsewhere than at the fall-off.
    Elsewhere(f64),
    /// No bend.
    Never,
}

impl Bend {
    /// Bends of a shape's curve.
    pub(super) fn of(shape: Shape) -> Self {
        const SAME: f64 = 1e-6;
        let Shape { offset, falloff, cutoff } = shape.sanitized();
        let (f, c) = (falloff - offset, cutoff - offset);
        if offset >= PI - 1e-5 {
            return Self::Ambient;
        }
        if f < 1e-9 || c < 1e-9 {
            return Self::Step;
        }
        if f <= FRAC_PI_2 + SAME {
            return if c - f < SAME && f < FRAC_PI_2 - SAME { Self::AtEnd } else { Self::Once };
        }
        if c - f < SAME {
            // The exponent is 1, and the rest is a cosine.
            return Self::Elsewhere(offset + FRAC_PI_2);
        }
        let cosine = (f.cos() - c.cos()) / (f.cos() * c.cos() - 1.0);
        let second = cosine.clamp(-1.0, 1.0).acos();
        match second {
            // With a cut-off half a turn away the second bend lies at the cut-off.
            second if second >= c - 1e-4 => Self::Once,
            second if (second - f).abs() < 1e-4 => Self::Never,
            second => Self::Twice(offset + second),
        }
    }
}

/// Functions of the library that a profile is drawn with.
pub(super) struct Sampler {
    prepare: Arc<Program>,
    profile: Arc<Program>,
    /// Arguments of the profile function, in order.
    takes: Vec<ProfileArgument>,
}

enum ProfileArgument {
    Angle,
    Shift,
    Shape,
}

impl Sampler {
    /// Functions of a tier; `None` where the library has no such node.
    pub(super) fn new(library: &Library, tier: Tier) -> Option<Self> {
        let def = library.nodes.get("profile")?;
        let prepare = def.module.program(&def.prepare.as_ref()?.function).ok()?;
        let variant = variant_of(def, tier)?;
        let profile = def.module.program(&variant.function).ok()?;
        let takes = variant.parameters.iter().map(|parameter| match parameter {
            ArgumentSource::Prepared => Some(ProfileArgument::Shape),
            ArgumentSource::Input(index, _) => match def.inputs[*index].name.as_str() {
                "angle" => Some(ProfileArgument::Angle),
                "shift" => Some(ProfileArgument::Shift),
                _ => None,
            },
            ArgumentSource::Sampler(_) | ArgumentSource::Choice(_) => None,
        });
        Some(Self { prepare, profile, takes: takes.collect::<Option<_>>()? })
    }

    /// Tone at each of the angles, for a profile moved by `shift`; all in radians.
    pub(super) fn tones(&self, shape: Shape, shift: f64, angles: &[f64]) -> Vec<f64> {
        let arguments = [shape.offset, shape.falloff, shape.cutoff].map(Value::Float);
        let Ok(prepared) = self.prepare.call(&arguments, Precision::F64) else { return Vec::new() };
        let mut machine = self.profile.machine(Precision::F64);
        let mut tone = |u: f64| {
            let arguments: Vec<Value> = self
                .takes
                .iter()
                .map(|takes| match takes {
                    ProfileArgument::Angle => {
                        let (sin, cos) = (0.5 * u).sin_cos();
                        Value::Struct(vec![Value::Float(sin), Value::Float(cos.max(0.0))])
                    }
                    ProfileArgument::Shift => Value::Float(shift),
                    ProfileArgument::Shape => prepared.clone(),
                })
                .collect();
            machine.call(&arguments).ok().and_then(|value| value.as_f64()).unwrap_or(0.0)
        };
        angles.iter().map(|&u| tone(u)).collect()
    }
}

/// Variant that serves a tier: the tier's own, or the exact one.
pub(super) fn variant_of(def: &NodeDef, tier: Tier) -> Option<&NodeFunction> {
    let of = |tier| def.variants.iter().find(move |variant| variant.tier == tier);
    of(tier).or_else(|| of(Tier::Exact))
}

/// Angles at which a curve is sampled: evenly, and on both sides of each possible edge.
pub(super) fn places(shape: Shape, shift: f64, count: usize) -> Vec<f64> {
    const BESIDE: f64 = 1e-5;
    let mut places: Vec<f64> = (0..=count).map(|i| i as f64 / count as f64 * PI).collect();
    let Shape { offset, cutoff, .. } = shape.sanitized();
    for edge in [offset + shift, cutoff + shift] {
        places.extend(
            [edge - BESIDE, edge, edge + BESIDE].into_iter().filter(|u| (0.0..=PI).contains(u)),
        );
    }
    places.sort_by(f64::total_cmp);
    places
}

/// Angle at which a sampled curve falls most steeply; `None` where it never falls.
pub(super) fn steepest(angles: &[f64], tones: &[f64]) -> Option<f64> {
    let pairs = angles.windows(2).zip(tones.windows(2)).filter(|(u, _)| u[1] - u[0] > 1e-3);
    let slopes = pairs.map(|(u, t)| (0.5 * (u[0] + u[1]), (t[0] - t[1]) / (u[1] - u[0])));
    slopes.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, slope)| *slope > 0.0).map(|(u, _)| u)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tones(offset: f64, falloff: f64, cutoff: f64, angles: &[f64]) -> Vec<f64> {
        let sampler = Sampler::new(Library::built_in(), Tier::Exact).unwrap();
        sampler.tones(Shape { offset, falloff, cutoff }, 0.0, angles)
    }

    #[test]
    fn the_presets_are_their_closed_forms() {
        let angles: Vec<f64> = (0..=180).map(|d| f64::from(d).to_radians()).collect();
        type ToneFormula = fn(f64) -> f64;
        let cases = [
            ("Lambert", [0.0, FRAC_PI_2, FRAC_PI_2], (|u| u.cos().max(0.0)) as ToneFormula),
            ("half-Lambert", [0.0, FRAC_PI_2, PI], |u| 0.5 + 0.5 * u.cos()),
            ("ambient", [PI, PI, PI], |_| 1.0),
        ];
        for (name, [offset, falloff, cutoff], truth) in cases {
            for (u, tone) in angles.iter().zip(tones(offset, falloff, cutoff, &angles)) {
                assert!((tone - truth(*u)).abs() < 1e-6, "{name} at {u}: {tone}");
            }
        }
        for tier in [Tier::Balanced, Tier::Fast] {
            let sampler = Sampler::new(Library::built_in(), tier).unwrap();
            let shape = Shape { offset: 0.0, falloff: FRAC_PI_2, cutoff: PI };
            for (u, tone) in angles.iter().zip(sampler.tones(shape, 0.0, &angles)) {
                assert!((tone - (0.5 + 0.5 * u.cos())).abs() < 1e-3, "{tier:?} at {u}: {tone}");
            }
        }
    }

    /// Second differences of the curve change sign where the formula puts bends, and nowhere else.
    #[test]
    fn bends_are_where_the_curve_bends() {
        let shapes = [
            (0.0, 1.0, 2.0),
            (0.2, 0.9, 1.4),
            (0.0, FRAC_PI_2, PI),
            (0.0, 1.7, PI),
            (0.0, 2.0, 2.6),
            (0.0, 1.8, 1.95),
            (0.3, 2.3, 2.9),
            (0.0, 2.0, 2.0),
            (0.0, 0.6, 0.6),
        ];
        for (offset, falloff, cutoff) in shapes {
            // The step is so wide that the rounding of the series is far below a second difference.
            let h = 0.02;
            let count = ((cutoff - offset) / h) as usize - 2;
            let angles: Vec<f64> = (1..count).map(|i| offset + i as f64 * h).collect();
            let tones = tones(offset, falloff, cutoff, &angles);
            let bends: Vec<f64> = tones.windows(3).map(|t| t[0] - 2.0 * t[1] + t[2]).collect();
            let found: Vec<f64> = (1..bends.len())
                .filter(|&i| bends[i - 1] * bends[i] < 0.0)
                .map(|i| 0.5 * (angles[i] + angles[i + 1]))
                .collect();
            let mut wanted = match Bend::of(Shape { offset, falloff, cutoff }) {
                Bend::Once => vec![falloff],
                Bend::Twice(second) => vec![falloff, second],
                Bend::Elsewhere(only) => vec![only],
                _ => Vec::new(),
            };
            wanted.sort_by(f64::total_cmp);
            assert_eq!(
                found.len(),
                wanted.len(),
                "{offset} {falloff} {cutoff}: {found:?} {wanted:?}"
            );
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!(
                    (found - wanted).abs() < 1.5 * h,
                    "{offset} {falloff} {cutoff}: {found} {wanted}"
                );
            }
        }
        let of = |offset, falloff, cutoff| Bend::of(Shape { offset, falloff, cutoff });
        assert_eq!(of(PI, 0.0, 0.0), Bend::Ambient);
        assert_eq!(of(0.7, 0.7, 0.7), Bend::Step);
        assert_eq!(of(0.7, 0.2, 2.0), Bend::Step, "a fall-off before the offset counts as at it");
        // Both bends meet at cos c = 2 cos f / (1 + cos^2 f).
        let f: f64 = 1.9;
        let c = (2.0 * f.cos() / (1.0 + f.cos().powi(2))).acos();
        assert_eq!(of(0.0, f, c), Bend::Never);
    }
}
