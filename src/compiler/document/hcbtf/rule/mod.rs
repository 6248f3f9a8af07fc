//! Rules that fill and change the samples that are not painted.

pub(in crate::document) mod about;

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

pub use self::about::RuleAbout;
use super::{Address, Angle, Grid, Relief, Strokes};

/// Rule for samples that are not painted. Rules work in order: those that fill take samples that
/// are still empty, those that change take the samples that were filled before them; painted
/// samples stay as they are (thesis 10.1).
///
/// Fields that a file leaves out are as the window makes them ([`RuleAbout::fresh`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "rule", rename_all = "snake_case", deny_unknown_fields)]
pub enum Rule {
    /// Fills: the same tile everywhere.
    Copy {
        /// Painted sample to copy.
        #[serde(default)]
        from: Address,
    },
    /// Fills: painted samples do not depend on these angles. Where several painted samples differ
    /// in them alone, the nearest is taken; where none differs in them alone, the sample stays
    /// empty. At the normal there is no angle around it, so any agrees.
    Lock {
        /// Angles that do not matter.
        #[serde(default = "eye_around")]
        angles: Vec<Angle>,
    },
    /// Fills: blends painted samples by the nearness of their lights and views, on the product of
    /// the two spheres.
    Blend {
        /// Sharpness of the falloff of influence: 1 is soft, 8 takes nearly the nearest alone.
        #[serde(default = "blend_sharpness")]
        sharpness: f64,
    },
    /// Fills: as [`Rule::Blend`], of the two or three nearest alone, with their strokes moved in
    /// place of faded (thesis 12). Matching parts are looked for; where there are none, the samples
    /// are blended.
    Morph {
        /// Sharpness of the falloff of influence, as in [`Rule::Blend`].
        #[serde(default = "morph_sharpness")]
        sharpness: f64,
    },
    /// Fills: one color, where the light is near the mirrored direction of the view, fading
    /// outward.
    Mirror {
        /// Color as straight RGBA bytes; the alpha is that at the mirrored direction itself.
        #[serde(default = "highlight")]
        color: [u8; 4],
        /// Angle from the mirrored direction to the end of the effect, in radians.
        #[serde(default = "highlight_width")]
        width: f64,
    },
    /// Fills: copies a painted sample to where the light is near the mirrored direction of the
    /// view, and only there (thesis 10.1: copying restricted to the specular reflection).
    Specular {
        /// Painted sample to copy.
        #[serde(default)]
        from: Address,
        /// Angle from the mirrored direction to the end of the effect, in radians.
        #[serde(default = "copy_width")]
        width: f64,
    },
    /// Fills: one color.
    Color {
        /// Color as straight RGBA bytes.
        #[serde(default = "gray")]
        color: [u8; 4],
    },
    /// Fills: draws strokes that stand on the tile, as each eye and each light see them.
    Strokes(Box<Strokes>),
    /// Fills: shows a relief of the tile, as each eye and each light see it.
    Relief(Box<Relief>),
    /// Changes: darker the lower the light stands (thesis eq. 1).
    Lambert {
        /// Color to darken to, as straight RGB bytes.
        #[serde(default = "dark")]
        shadow: [u8; 3],
        /// Strength: 0 leaves the sample unchanged, 1 is Lambert's law.
        #[serde(default = "one")]
        amount: f64,
    },
    /// Changes: turns the tile's content with the view around the normal, so that it keeps facing
    /// the eye: content that points along v at phi 0 points toward the eye at every phi. Each
    /// turned tile is resampled from its unturned source (thesis figure 37), also where several
    /// rules turn it. The view along the normal is not turned.
    Rotate {
        /// Number of turns of the content for each turn of the view.
        #[serde(default = "one")]
        turns: f64,
    },
    /// Changes: multiplies by a color that goes from one to another along an angle. At the normal,
    /// which has no angle around it, by the middle of the two.
    Recolor {
        /// Angle along which the color changes.
        #[serde(default = "light_height")]
        angle: Angle,
        /// Factor at the angle's beginning, as straight RGB bytes.
        #[serde(default = "white")]
        from: [u8; 3],
        /// Factor at the angle's end; for angles around the normal, half a turn away.
        #[serde(default = "low_sun")]
        to: [u8; 3],
    },
}

fn eye_around() -> Vec<Angle> {
    vec![Angle::ViewPhi]
}

fn blend_sharpness() -> f64 {
    4.0
}

fn morph_sharpness() -> f64 {
    2.0
}

fn highlight() -> [u8; 4] {
    [255, 250, 235, 255]
}

fn highlight_width() -> f64 {
    PI / 8.0
}

fn copy_width() -> f64 {
    PI / 6.0
}

fn gray() -> [u8; 4] {
    [128, 128, 128, 255]
}

fn dark() -> [u8; 3] {
    [20, 18, 32]
}

fn one() -> f64 {
    1.0
}

fn light_height() -> Angle {
    Angle::LightTheta
}

fn white() -> [u8; 3] {
    [255; 3]
}

fn low_sun() -> [u8; 3] {
    [255, 170, 110]
}

impl Rule {
    /// Descriptions of all rules for people.
    pub const ABOUT: [RuleAbout; 12] = about::ABOUT;
    /// Words of all rules in files.
    pub const WORDS: [&'static str; 12] = {
        let mut words = [""; 12];
        let mut index = 0;
        while index < words.len() {
            words[index] = about::ABOUT[index].word;
            index += 1;
        }
        words
    };
    /// Greatest sharpness of [`Rule::Blend`] and [`Rule::Morph`].
    pub const MAX_SHARPNESS: f64 = 64.0;
    /// Greatest number of turns of [`Rule::Rotate`], either way.
    pub const MAX_TURNS: f64 = 1000.0;

    /// Word of the rule in files.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Copy { .. } => "copy",
            Self::Lock { .. } => "lock",
            Self::Blend { .. } => "blend",
            Self::Morph { .. } => "morph",
            Self::Mirror { .. } => "mirror",
            Self::Specular { .. } => "specular",
            Self::Color { .. } => "color",
            Self::Lambert { .. } => "lambert",
            Self::Rotate { .. } => "rotate",
            Self::Recolor { .. } => "recolor",
            Self::Strokes(_) => "strokes",
            Self::Relief(_) => "relief",
        }
    }

    /// Description of the rule for people.
    pub fn about(&self) -> RuleAbout {
        let is_own = |about: &RuleAbout| about.word == self.word();
        // A test holds that each rule is in the list.
        Self::ABOUT.into_iter().find(is_own).unwrap_or(Self::ABOUT[0])
    }

    /// True for a rule that fills empty samples; the others change samples that were filled before
    /// them.
    pub fn fills(&self) -> bool {
        !matches!(self, Self::Lambert { .. } | Self::Rotate { .. } | Self::Recolor { .. })
    }

    /// Checks the numbers of the rule.
    ///
    /// # Errors
    /// A message that names the invalid number and its bounds.
    pub fn check(&self, grid: &Grid) -> Result<(), String> {
        let within = |name: &str, value: f64, least: f64, most: f64| {
            let is_within = (least..=most).contains(&value);
            let message = || format!("`{name}` is {value}; it must be from {least} to {most:.4}");
            if is_within { Ok(()) } else { Err(message()) }
        };
        match self {
            Self::Copy { from } | Self::Specular { from, .. } if !grid.contains(*from) => {
                Err(format!("`from` names {from}, which is outside the grid"))
            }
            Self::Lock { angles } if angles.is_empty() => Err("`angles` names no angle".to_owned()),
            Self::Blend { sharpness } | Self::Morph { sharpness } => {
                within("sharpness", *sharpness, 0.0, Self::MAX_SHARPNESS)
            }
            Self::Mirror { width, .. } | Self::Specular { width, .. } => {
                within("width", *width, 0.0, std::f64::consts::PI)
            }
            Self::Lambert { amount, .. } => within("amount", *amount, 0.0, 1.0),
            Self::Rotate { turns } => within("turns", *turns, -Self::MAX_TURNS, Self::MAX_TURNS),
            Self::Strokes(strokes) => strokes.check(),
            Self::Relief(relief) => relief.check(grid),
            Self::Copy { .. } | Self::Lock { .. } | Self::Color { .. } | Self::Recolor { .. } => {
                Ok(())
            }
        }
    }
}
