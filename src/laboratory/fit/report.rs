//! Report of a fit: errors of a look before and after, and the changes.

use std::collections::HashSet;

use serde::Serialize;

use super::choose::{goals_of, pixels_of, wearing};
use super::knobs::{Knob, knobs_of};
use super::model::{FitShot, Model, rms_of};
use super::state::KnobSetting;
use super::target::{FitTarget, PixelGoal};
use super::{FitOptions, KeptParts};
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::figures::count;
use crate::frame::Picture;

/// Number of cells along a side of the picture; cells count as places of their own.
const CELLS: u64 = 32;
/// Number of the worst pixels in a report.
const WORST: usize = 5;
/// RMS error of a channel that is plainly seen.
const FAR: f64 = 10.0 / 255.0;
/// Share of the former error above which a fit hardly helped.
const HARDLY: f64 = 0.7;

/// Result of a fit. Errors are those of a channel, straight and as shown, from 0 to 1, weighted as
/// painted.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FitReport {
    /// Number of pixels that were painted.
    pub painted: usize,
    /// Number of pixels that were compared: painted ones within the objects, thinned if there are
    /// very many.
    pub compared: usize,
    /// Number of cells, of 32 by 32 in the picture, that pixels were compared in: two dots have few
    /// cells, however many pixels they have.
    pub places: usize,
    /// Number of coordinates that could be turned: two of a light, three of a profile and of a
    /// color.
    pub turned: usize,
    /// Numbers of knobs that were turned.
    pub tried: KnobCounts,
    /// Numbers of further knobs that the options kept.
    pub kept: KnobCounts,
    /// RMS error of the given look.
    pub before: f64,
    /// RMS error of the fitted look.
    pub after: f64,
    /// RMS change of the unpainted pixels, if they were to stay.
    pub rest: Option<f64>,
    /// True if the fit was stopped, and returned the nearest look so far.
    pub is_stopped: bool,
    /// All parts of the look that have changed.
    pub changed: Vec<LookChange>,
    /// The pixels that are farthest off, weighted by how much they count, the worst first.
    pub worst: Vec<MissedPixel>,
}

/// Numbers of the knobs of a look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct KnobCounts {
    /// Number of directional lights.
    pub lights: usize,
    /// Number of profiles.
    pub profiles: usize,
    /// Number of colors, those of ramps included.
    pub colors: usize,
}

impl KnobCounts {
    fn of(knobs: &[(Knob, KnobSetting)]) -> Self {
        let mut things = Self::default();
        for (knob, _) in knobs {
            let count = match knob {
                Knob::Direction(_) => &mut things.lights,
                Knob::Profile(_) => &mut things.profiles,
                Knob::Color { .. } | Knob::Stop { .. } => &mut things.colors,
            };
            *count += 1;
        }
        things
    }

    /// Numbers of the knobs in `all` that are not among these.
    fn left_of(&self, all: &Self) -> Self {
        Self {
            lights: all.lights.saturating_sub(self.lights),
            profiles: all.profiles.saturating_sub(self.profiles),
            colors: all.colors.saturating_sub(self.colors),
        }
    }

    /// Description for people: `1 light, 2 profiles and 7 colors`; `None` without any knob.
    pub fn told(&self) -> Option<String> {
        let each = [(self.lights, "light"), (self.profiles, "profile"), (self.colors, "color")];
        let mut named: Vec<String> = each
            .into_iter()
            .filter(|(n, _)| *n > 0)
            .map(|(n, noun)| count(n as u64, noun))
            .collect();
        let last = named.pop()?;
        Some(if named.is_empty() { last } else { format!("{} and {last}", named.join(", ")) })
    }
}

/// One part of the look that has changed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LookChange {
    /// Kind of the part: `light`, `profile` or `color`.
    pub what: &'static str,
    /// Place of the part: the light's id, the node, or the input.
    pub place: String,
    /// Former setting as people read it; empty if the part is new.
    pub from: String,
    /// New setting as people read it.
    pub to: String,
}

/// A pixel with its goal and the color that the look shows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MissedPixel {
    /// Column and row of the pixel.
    pub pixel: [u32; 2],
    /// Painted color, straight RGB.
    pub wished: [f64; 3],
    /// Color of the look, straight RGB.
    pub shown: [f64; 3],
    /// RMS of the three channels' differences.
    pub error: f64,
}

/// Error that a picture of misses shows at its brightest.
const BRIGHT: f64 = 0.1;

/// Picture of the errors of a look: black for none, over red and yellow to white; transparent where
/// nothing was compared.
pub fn picture_of(size: [u32; 2], misses: &[MissedPixel]) -> Picture {
    let mut rgba = vec![[0.0; 4]; size[0] as usize * size[1] as usize];
    for missed in misses {
        let share = 3.0 * (missed.error / BRIGHT).min(1.0) as f32;
        let [x, y] = missed.pixel.map(|at| at as usize);
        if let Some(pixel) = rgba.get_mut(y * size[0] as usize + x) {
            *pixel =
                [share.min(1.0), (share - 1.0).clamp(0.0, 1.0), (share - 2.0).clamp(0.0, 1.0), 1.0];
        }
    }
    Picture { size, rgba }
}

/// A compared pixel, with its weight.
#[derive(Clone, Copy, Debug)]
pub(super) struct ComparedPixel {
    pub(super) missed: MissedPixel,
    weight: f64,
    is_rest: bool,
}

impl ComparedPixel {
    /// Goal of the pixel.
    pub(super) fn goal(&self) -> PixelGoal {
        let MissedPixel { pixel, wished, .. } = self.missed;
        PixelGoal { pixel, color: wished, weight: self.weight, is_rest: self.is_rest }
    }

    /// Weighted distance of the pixel from its goal: the root of its sum of squared residuals.
    pub(super) fn miss(&self) -> f64 {
        (3.0 * self.weight).sqrt() * self.missed.error
    }
}

/// All compared pixels.
pub(super) type ComparedPixels = Vec<ComparedPixel>;

/// The compared pixels that were painted.
pub(super) fn painted(compared: &ComparedPixels) -> Vec<MissedPixel> {
    compared.iter().filter(|one| !one.is_rest).map(|one| one.missed).collect()
}

impl FitReport {
    /// The report on the look of `shot`, from its errors before and after the fit.
    pub(super) fn new(
        shot: &FitShot<'_>,
        fitted: &Look,
        target: &FitTarget,
        before: &ComparedPixels,
        after: &ComparedPixels,
        how: &FitOptions,
    ) -> Result<Self, Vec<Diagnostic>> {
        let turned = knobs_of(&wearing(shot, fitted.clone()), shot.look, shot.library, &how.keep)?;
        let all = KeptParts::default();
        let old = knobs_of(shot.setup, shot.look, shot.library, &all)?;
        let new = knobs_of(&wearing(shot, fitted.clone()), shot.look, shot.library, &all)?;
        let mut worst: Vec<&ComparedPixel> = after.iter().filter(|one| !one.is_rest).collect();
        let compared = worst.len();
        let tried = KnobCounts::of(&turned);
        // Pixels that a brush hardly touched, at the edge of a stroke, hardly count.
        worst.sort_by(|a, b| b.miss().total_cmp(&a.miss()));
        let worst = worst.into_iter().take(WORST).map(|one| one.missed).collect();
        Ok(Self {
            painted: target.goals.len(),
            compared,
            places: places(target.size, after),
            turned: turned.iter().map(|(_, setting)| setting.count()).sum(),
            tried,
            kept: tried.left_of(&KnobCounts::of(&new)),
            before: rms(before, false).unwrap_or_default(),
            after: rms(after, false).unwrap_or_default(),
            rest: rms(after, true),
            is_stopped: false,
            changed: changed(&old, &new),
            worst,
        })
    }
}

impl FitReport {
    /// True if the look hardly shows what was painted: it is off by more than an eye passes over,
    /// or by most of its former error.
    pub fn is_far_off(&self) -> bool {
        self.after > FAR || self.after > 0.5 * FAR && self.after > HARDLY * self.before
    }

    /// Warnings about a fit, of an existing look or of layers from nothing.
    pub fn warnings(&self, from_nothing: bool) -> Vec<Diagnostic> {
        self.few_places().into_iter().chain(self.far_off(from_nothing)).collect()
    }

    /// Warning that the look does not show what was painted.
    fn far_off(&self, from_nothing: bool) -> Option<Diagnostic> {
        let tried = self.tried.told().unwrap_or_else(|| "nothing".to_owned());
        let steps = |error: f64| format!("{:.0}/255", 255.0 * error);
        let message = format!(
            "the look is off by {} of what was painted, and was by {}: turning {tried} of it found \
             nothing nearer",
            steps(self.after),
            steps(self.before)
        );
        let mut problem = Diagnostic::warning("fit-far-off", message);
        if let Some(kept) = self.kept.told() {
            problem = problem.hint(format!("{kept} of it did not take part: --keep less"));
        }
        if self.rest.is_some() {
            problem = problem.hint("keep less of what is not painted, with a smaller --keep-rest");
        }
        let other =
            if from_nothing { "allow more --layers" } else { "--layers begins from nothing" };
        let problem =
            problem.hint(format!("{other}; --misses writes a picture of where it is off"));
        self.is_far_off().then_some(problem)
    }

    /// Warning that more was turned than so few places can determine.
    fn few_places(&self) -> Option<Diagnostic> {
        let Self { places, turned, compared, .. } = self;
        let message = format!(
            "{} in {} of the picture cannot tell what {} should be: much of the look is a guess",
            count(*compared as u64, "painted pixel"),
            count(*places as u64, "place"),
            count(*turned as u64, "number")
        );
        let problem = Diagnostic::warning("fit-few-places", message);
        (places < turned).then(|| {
            problem.hint(
                "paint more of the light, of the shade, and of \
                                                where one becomes the other; or keep what is right \
                                                already, with --keep and --keep-rest",
            )
        })
    }
}

/// Number of cells that pixels lie in, for a picture that is cut into 32 by 32 cells.
fn places(size: [u32; 2], compared: &ComparedPixels) -> usize {
    let cell = |pixel: [u32; 2]| {
        [0, 1].map(|axis| u64::from(pixel[axis]) * CELLS / u64::from(size[axis].max(1)))
    };
    compared.iter().map(|one| cell(one.missed.pixel)).collect::<HashSet<_>>().len()
}

/// Comparison of the look of `shot` with the goals, as it is.
pub(super) fn compared_as_is(
    shot: &FitShot<'_>,
    given: &[PixelGoal],
) -> Result<ComparedPixels, Vec<Diagnostic>> {
    compared_at(&Model::new(shot, Vec::new(), &pixels_of(given))?, given)
}

/// Comparison of a model with goals of some of its pixels, as it is.
pub(super) fn compared_at(
    model: &Model,
    given: &[PixelGoal],
) -> Result<ComparedPixels, Vec<Diagnostic>> {
    let wished = pixels_of(given);
    let places: Vec<usize> =
        (0..model.pixels.len()).filter(|&place| wished.contains(&model.pixels[place])).collect();
    let pixels: Vec<[u32; 2]> = places.iter().map(|&place| model.pixels[place]).collect();
    let goals = goals_of(&pixels, given)?;
    let colors = model.colors(&model.sheet(&places), &[]).map_err(|one| vec![one])?;
    Ok(missed(&goals, colors))
}

/// Comparison of a model with the goals, at each of its pixels.
pub(super) fn compared(
    model: &Model,
    goals: &[PixelGoal],
    state: &[KnobSetting],
) -> Result<ComparedPixels, Diagnostic> {
    Ok(missed(goals, model.colors(&model.sheet(&model.all()), state)?))
}

/// Comparison of goals with the colors that their pixels show.
fn missed(goals: &[PixelGoal], colors: Vec<[f64; 3]>) -> ComparedPixels {
    let missed = |(goal, shown): (&PixelGoal, [f64; 3])| {
        let error = rms_of(std::array::from_fn(|c| shown[c] - goal.color[c]));
        let missed = MissedPixel { pixel: goal.pixel, wished: goal.color, shown, error };
        ComparedPixel { missed, weight: goal.weight, is_rest: goal.is_rest }
    };
    goals.iter().zip(colors).map(missed).collect()
}

/// RMS of the painted pixels, or of the rest; `None` if there are none.
fn rms(compared: &ComparedPixels, of_rest: bool) -> Option<f64> {
    let chosen = compared.iter().filter(|one| one.is_rest == of_rest);
    let (sum, weight) = chosen.fold((0.0, 0.0), |(sum, total), one| {
        (sum + one.weight * one.missed.error.powi(2), total + one.weight)
    });
    (weight > 0.0).then(|| (sum / weight).sqrt())
}

fn changed(old: &[(Knob, KnobSetting)], new: &[(Knob, KnobSetting)]) -> Vec<LookChange> {
    let changes = new.iter().filter_map(|(knob, setting)| {
        let was = old
            .iter()
            .find(|(other, _)| other.told() == knob.told())
            .map(|(_, setting)| told(setting));
        let to = told(setting);
        let (what, place) = knob.told();
        (was.as_ref() != Some(&to)).then(|| LookChange {
            what,
            place,
            from: was.unwrap_or_default(),
            to,
        })
    });
    changes.collect()
}

/// A setting as people read it: angles in degrees, colors in hex.
fn told(setting: &KnobSetting) -> String {
    match setting {
        KnobSetting::Direction(direction) => {
            let [x, y, z] = direction.to_array();
            format!("{x:.3} {y:.3} {z:.3}")
        }
        KnobSetting::Profile(shape) => {
            let [offset, falloff, cutoff] = shape.ends().map(f64::to_degrees);
            format!("{offset:.1}° {falloff:.1}° {cutoff:.1}°")
        }
        KnobSetting::Color(color) => {
            let [r, g, b] = color.map(|x| (x * 255.0).round() as u8);
            format!("#{r:02x}{g:02x}{b:02x}")
        }
    }
}
