//! How far a look is from what was painted, before and after, and what was turned.

use std::collections::HashSet;

use serde::Serialize;

use super::Keep;
use super::choose::{pixels_of, wearing, wishes_of};
use super::knobs::{Knob, knobs_of};
use super::model::{Model, Shot};
use super::state::Setting;
use super::target::{Target, Wish};
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::figures::count;
use crate::frame::Picture;

/// Cells along the picture that count as places of their own.
const CELLS: u64 = 32;
/// Pixels that are told of.
const WORST: usize = 5;

/// What a fit came to. Errors are of a channel, straight and as shown, from 0 to 1, weighted as painted.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Pixels that were painted.
    pub painted: usize,
    /// Pixels that were compared: painted ones within the objects, thinned where there are very many.
    pub compared: usize,
    /// Cells of the picture that pixels were compared in, of 32 by 32: two dots are a few, however many pixels they have.
    pub places: usize,
    /// Numbers that could be turned: two of a light, three of a profile and of a colour.
    pub turned: usize,
    /// The RMS error of the look as it was.
    pub before: f64,
    /// The RMS error now.
    pub after: f64,
    /// Everything that is another now.
    pub changed: Vec<Changed>,
    /// The pixels that are farthest off, the worst first.
    pub worst: Vec<Missed>,
}

/// One thing that is another than it was.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Changed {
    /// `light`, `profile` or `color`.
    pub what: &'static str,
    /// The light's id, the node, or the input.
    pub place: String,
    /// What it was, as people read it; empty where it was not there.
    pub from: String,
    /// What it is.
    pub to: String,
}

/// A pixel that does not show what was painted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Missed {
    /// Column and row.
    pub pixel: [u32; 2],
    /// Straight RGB as painted.
    pub wished: [f64; 3],
    /// Straight RGB as it is.
    pub shown: [f64; 3],
    /// The RMS of the three channels.
    pub error: f64,
}

/// The error at which a picture of misses is at its brightest.
const BRIGHT: f64 = 0.1;

/// Where a look misses what was painted: black where it does not, over red and yellow to white; transparent where nothing
/// was compared.
pub fn picture_of(size: [u32; 2], misses: &[Missed]) -> Picture {
    let mut rgba = vec![[0.0; 4]; size[0] as usize * size[1] as usize];
    for missed in misses {
        let share = 3.0 * (missed.error / BRIGHT).min(1.0) as f32;
        let [x, y] = missed.pixel.map(|at| at as usize);
        if let Some(pixel) = rgba.get_mut(y * size[0] as usize + x) {
            *pixel = [share.min(1.0), (share - 1.0).clamp(0.0, 1.0), (share - 2.0).clamp(0.0, 1.0), 1.0];
        }
    }
    Picture { size, rgba }
}

/// Every compared pixel with its weight.
pub(super) type Compared = Vec<(Missed, f64)>;

impl Report {
    /// What became of the look of `shot`, from how far off it was and is.
    pub(super) fn new(
        shot: &Shot<'_>,
        fitted: &Look,
        target: &Target,
        before: &Compared,
        after: &Compared,
        keep: &Keep,
    ) -> Result<Self, Vec<Diagnostic>> {
        let turned = knobs_of(&wearing(shot, fitted.clone()), shot.look, shot.library, keep)?;
        let all = Keep::default();
        let old = knobs_of(shot.setup, shot.look, shot.library, &all)?;
        let new = knobs_of(&wearing(shot, fitted.clone()), shot.look, shot.library, &all)?;
        let mut worst: Vec<Missed> = after.iter().map(|(missed, _)| *missed).collect();
        worst.sort_by(|a, b| b.error.total_cmp(&a.error));
        worst.truncate(WORST);
        Ok(Self {
            painted: target.wishes.len(),
            compared: after.len(),
            places: places(target.size, after),
            turned: turned.iter().map(|(_, setting)| setting.count()).sum(),
            before: rms(before),
            after: rms(after),
            changed: changed(&old, &new),
            worst,
        })
    }
}

impl Report {
    /// What there is to warn of: more was turned than so few places can tell.
    pub fn warning(&self) -> Option<Diagnostic> {
        let Self { places, turned, compared, .. } = self;
        let message = format!(
            "{} in {} of the picture cannot tell what {} should be: much of the look is a guess",
            count(*compared as u64, "painted pixel"),
            count(*places as u64, "place"),
            count(*turned as u64, "number")
        );
        let problem = Diagnostic::warning("fit-few-places", message);
        (places < turned).then(|| problem.hint("paint more of the light, of the shade, and of where one becomes the other; or keep what is right already"))
    }
}

/// The cells that pixels lie in, of a picture that is cut into 32 by 32.
fn places(size: [u32; 2], compared: &Compared) -> usize {
    let cell = |pixel: [u32; 2]| [0, 1].map(|axis| u64::from(pixel[axis]) * CELLS / u64::from(size[axis].max(1)));
    compared.iter().map(|(missed, _)| cell(missed.pixel)).collect::<HashSet<_>>().len()
}

/// How far the look of `shot` is off as it is.
pub(super) fn compared_as_is(shot: &Shot<'_>, given: &[Wish]) -> Result<Compared, Vec<Diagnostic>> {
    let model = Model::new(shot, Vec::new(), &pixels_of(given))?;
    let wishes = wishes_of(&model.pixels, given)?;
    compared(&model, &wishes, &[]).map_err(|one| vec![one])
}

/// How far a model is off at each of its pixels.
pub(super) fn compared(model: &Model, wishes: &[Wish], state: &[Setting]) -> Result<Compared, Diagnostic> {
    let colors = model.colors(&model.sheet(&model.all()), state)?;
    let missed = |(wish, shown): (&Wish, [f64; 3])| {
        let squares: f64 = shown.iter().zip(wish.color).map(|(shown, wished)| (shown - wished).powi(2)).sum();
        let missed = Missed { pixel: wish.pixel, wished: wish.color, shown, error: (squares / 3.0).sqrt() };
        (missed, wish.weight)
    };
    Ok(wishes.iter().zip(colors).map(missed).collect())
}

fn rms(missed: &Compared) -> f64 {
    let (sum, weight) = missed.iter().fold((0.0, 0.0), |(sum, total), (missed, weight)| {
        (sum + weight * missed.error * missed.error, total + weight)
    });
    if weight > 0.0 { (sum / weight).sqrt() } else { 0.0 }
}

fn changed(old: &[(Knob, Setting)], new: &[(Knob, Setting)]) -> Vec<Changed> {
    let changes = new.iter().filter_map(|(knob, setting)| {
        let was = old.iter().find(|(other, _)| other.told() == knob.told()).map(|(_, setting)| told(setting));
        let to = told(setting);
        let (what, place) = knob.told();
        (was.as_ref() != Some(&to)).then(|| Changed { what, place, from: was.unwrap_or_default(), to })
    });
    changes.collect()
}

/// A setting as people read it: angles in degrees, colours in hex.
fn told(setting: &Setting) -> String {
    match setting {
        Setting::Direction(direction) => {
            let [x, y, z] = direction.to_array();
            format!("{x:.3} {y:.3} {z:.3}")
        }
        Setting::Profile(shape) => {
            let [offset, falloff, cutoff] = shape.ends().map(f64::to_degrees);
            format!("{offset:.1}° {falloff:.1}° {cutoff:.1}°")
        }
        Setting::Color(color) => {
            let [r, g, b] = color.map(|x| (x * 255.0).round() as u8);
            format!("#{r:02x}{g:02x}{b:02x}")
        }
    }
}
