//! Painted shading (Okabe et al. 2007, the last wish of the BADF paper): a look from what was
//! painted on a picture.
//!
//! A [`Target`] says what some pixels should show. [`fit_look`] turns the lights, profiles and
//! colors of a look until it shows that; [`fit_layers`] begins from nothing and lays light layers
//! one over the other, each where most is missing. Both end in damped least squares (`solve`) on
//! the picture of the f64 reference at the painted pixels alone (`model`), and leave an ordinary
//! look with the edit that makes it. [`Report`] says how far off it was and is.
//!
//! Two things keep the search honest and quick. The colors of a stack of layers enter its picture
//! linearly, so that for any tones of the layers the best colors are known at once, and only where
//! light comes from and how it falls off is searched (variable projection, Golub and Pereyra 1973;
//! `stack`). And a hard edge pulls at nothing but its own pixels, so that every search begins with
//! soft profiles, which narrow by themselves as they come closer.

mod beam;
mod build;
mod choose;
mod grow;
mod knobs;
mod lit;
mod model;
mod report;
mod rest;
mod solve;
mod stack;
mod state;
mod target;
mod turn;

use crate::document::{Edit, Look};

pub use grow::fit_layers;
pub use report::{Changed, KnobCounts, MissedPixel, Report, picture_of};
pub use target::{MAX_SIDE, PixelGoal, Target};
pub use turn::fit_look;

/// What of a look stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keep {
    /// Directions of lights.
    pub lights: bool,
    /// Offsets, fall-offs and cut-offs.
    pub profiles: bool,
    /// Colors, that of the base too.
    pub colors: bool,
    /// The color of the base.
    pub base: bool,
}

/// How to fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// The time of the picture in seconds.
    pub time: f64,
    /// What stays.
    pub keep: Keep,
    /// How far what is not painted stays as it is: 0 lets it go, 1 keeps it as far as strokes let
    /// it.
    pub keep_rest: f64,
    /// From how many beginnings a look that is there is turned, its own first: at least 1.
    pub starts: usize,
    /// The RMS error of a channel, from 0 to 1, that is small enough.
    pub enough: f64,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { time: 0.0, keep: Keep::default(), keep_rest: 0.0, starts: 6, enough: 0.5 / 255.0 }
    }
}

/// A look that was fitted.
#[derive(Clone, Debug)]
pub struct FittedLook {
    /// The look.
    pub look: Look,
    /// What makes it of the look that was given, to be undone as one.
    pub edit: Edit,
    /// How far off it was and is.
    pub report: Report,
    /// How far off it is at every painted pixel that was compared, by row and column.
    pub misses: Vec<MissedPixel>,
}
