//! Painted shading (Okabe et al. 2007, the last wish of the BADF paper): a look from strokes
//! painted on a picture.
//!
//! A [`FitTarget`] holds the goals of some pixels. [`fit_local`] lays layers over the look where it
//! was painted, and changes nothing else of it. [`fit_look`] turns the lights, profiles and
//! colors of a look until the look shows them; [`fit_layers`] begins from nothing and lays light
//! layers one over the other, each where most is missing. Both end in damped least squares
//! (`solve`) on the picture of the f64 reference at the painted pixels alone (`model`), and return
//! an ordinary look with the edit that makes it. [`FitReport`] holds the errors before and after.
//!
//! Two facts keep the search honest and quick. The colors of a stack of layers enter its picture
//! linearly, so that for any tones of the layers the best colors are known at once, and only the
//! directions of lights and their fall-offs are searched (variable projection, Golub and Pereyra
//! 1973; `stack`). And a hard edge affects nothing but its own pixels, so that every search begins
//! with soft profiles, which narrow by themselves as they come closer.

mod beam;
mod build;
mod choose;
mod grow;
mod knobs;
mod lit;
mod local;
mod local_layer;
mod model;
mod place;
mod report;
mod rest;
mod solve;
mod stack;
mod state;
mod target;
mod turn;

use crate::document::{Edit, Look};

pub use grow::fit_layers;
pub use local::fit_local;
pub use report::{FitReport, KnobCounts, LookChange, MissedPixel, picture_of};
pub use target::{FitTarget, MAX_SIDE, PixelGoal};
pub use turn::fit_look;

/// Parts of a look that a fit leaves as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KeptParts {
    /// True to keep the directions of lights.
    pub lights: bool,
    /// True to keep offsets, fall-offs and cut-offs.
    pub profiles: bool,
    /// True to keep all colors, the base's included.
    pub colors: bool,
    /// True to keep the color of the base.
    pub base: bool,
}

/// Options of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// Time of the picture, in seconds.
    pub time: f64,
    /// Parts that stay as they are.
    pub keep: KeptParts,
    /// Degree to which unpainted pixels stay as they are: 0 lets them go, 1 keeps them as far as
    /// the strokes allow; by default 0.
    pub keep_rest: f64,
    /// Number of starting points that an existing look is turned from, its own settings first; at
    /// least 1, by default 6.
    pub starts: usize,
    /// RMS error of a channel that is small enough to stop at, from 0 to 1; by default half of
    /// 1/255.
    pub enough: f64,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            time: 0.0,
            keep: KeptParts::default(),
            keep_rest: 0.0,
            starts: 6,
            enough: 0.5 / 255.0,
        }
    }
}

/// Result of a fit.
#[derive(Clone, Debug)]
pub struct FittedLook {
    /// The look.
    pub look: Look,
    /// Edit that makes the fitted look of the given one, to be undone as one step.
    pub edit: Edit,
    /// Errors before and after the fit, and the changes.
    pub report: FitReport,
    /// Errors at every painted pixel that was compared, by row and column.
    pub misses: Vec<MissedPixel>,
}
