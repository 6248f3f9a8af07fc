//! Rules: how samples that nobody painted come about.

pub(in crate::document) mod about;

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

pub use self::about::RuleAbout;
use super::{Address, Angle, Grid, Relief, Strokes};

/// How samples that nobody painted come about. Rules work in order: those that fill take samples
/// that are still empty, those that change take what was filled before them; what is painted stays
/// as it is (thesis 10.1).
///
/// What a file leaves out is as the window makes it ([`RuleAbout::fresh`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "rule", rename_all = "snake_case", deny_unknown_fields)]
pub enum Rule {
    /// Fills: the same tile everywhere.
    Copy {
        /// The painted sample to copy.
        #[serde(default)]
        from: Address,
    },
    /// Fills: what is painted does not depend on these angles. Where several painted samples differ
    /// in them alone, the nearest is taken; where none differs in them alone, the sample stays
    /// empty. At the normal there is no angle around it, so any agrees.
    Lock {
        /// The angles that do not matter.
        #[serde(default = "eye_around")]
        angles: Vec<Angle>,
    },
    /// Fills: blends what is painted by how near its light and its view are, on the product of the
    /// two spheres.
    Blend {
        /// How fast influence falls: 1 is soft, 8 takes nearly the nearest alone.
        #[serde(default = "blend_sharpness")]
        sharpness: f64,
    },
    /// Fills: as [`Rule::Blend`], of the two or three nearest alone, with their strokes moved in
    /// place of faded (thesis 12). What is alike in them is looked for; where nothing is, they are
    /// blended.
    Morph {
        /// How fast influence falls, as in [`Rule::Blend`].
        #[serde(default = "morph_sharpness")]
        sharpness: f64,
    },
    /// Fills: one color, where the light is near the mirrored direction of the view, fading
    /// outward.
    Mirror {
        /// Straight RGBA as bytes; the alpha is that at the mirrored direction itself.
        #[serde(default = "highlight")]
        color: [u8; 4],
        /// From the mirrored direction to where it ends, in radians.
        #[serde(default = "highlight_width")]
        width: f64,
    },
    /// Fills: copies a painted sample to where the light is near the mirrored direction of the
    /// view, and only there (thesis 10.1: copying restricted to the specular reflection).
    Specular {
        /// The painted sample to copy.
        #[serde(default)]
        from: Address,
        /// From the mirrored direction to where it ends, in radians.
        #[serde(default = "copy_width")]
        width: f64,
    },
    /// Fills: one color.
    Color {
        /// Straight RGBA as bytes.
        #[serde(default = "grey")]
        color: [u8; 4],
    },
    /// Fills: draws strokes that stand on the tile, as each eye and each light see them.
    Strokes(Box<Strokes>),
    /// Fills: shows a relief of the tile, as each eye and each light see it.
    Relief(Box<Relief>),
    /// Changes: darker the lower the light stands (thesis eq. 1).
    Lambert {
        /// What it darkens to, straight RGB as bytes.
        #[serde(default = "dark")]
        shadow: [u8; 3],
        /// 0 leaves everything as it is, 1 is Lambert's law.
        #[serde(default = "one")]
        amount: f64,
    },
    /// Changes: turns the tile's content with the view around the normal, so that it keeps facing
    /// the eye: what points along v at phi 0 points toward the eye at every phi. Each turned tile
    /// is resampled from its unturned source (thesis figure 37), also where several rules turn it.
    /// The view along the normal is not turned.
    Rotate {
        /// Turns of the content for each turn of the view.
        #[serde(default = "one")]
        turns: f64,
    },
    /// Changes: multiplies by a color that goes from one to another along an angle. At the normal,
    /// which has no angle around it, by the middle of the two.
    Recolor {
        /// Along which angle.
        #[serde(default = "light_height")]
        angle: Angle,
        /// The factor at the angle's beginning, straight RGB as bytes.
        #[serde(default = "white")]
        from: [u8; 3],
        /// The factor at its end; for angles around the normal, half a turn away.
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

fn grey() -> [u8; 4] {
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
    /// What people are told of every rule.
    pub const ABOUT: [RuleAbout; 12] = about::ABOUT;
    /// Every rule's word in files.
    pub const WORDS: [&'static str; 12] = {
        let mut words = [""; 12];
        let mut index = 0;
        while index < words.len() {
            words[index] = about::ABOUT[index].word;
            index += 1;
        }
        words
    };
    /// The sharpest [`Rule::Blend`] and [`Rule::Morph`].
    pub const MAX_SHARPNESS: f64 = 64.0;
    /// The most turns of [`Rule::Rotate`], either way.
    pub const MAX_TURNS: f64 = 1000.0;

    /// The word by which files know it.
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

    /// What people are told of it.
    pub fn about(&self) -> RuleAbout {
        let is_own = |about: &RuleAbout| about.word == self.word();
        // A test holds that each is in the list.
        Self::ABOUT.into_iter().find(is_own).unwrap_or(Self::ABOUT[0])
    }

    /// Whether it takes samples that are empty; the others change what was filled before them.
    pub fn fills(&self) -> bool {
        !matches!(self, Self::Lambert { .. } | Self::Rotate { .. } | Self::Recolor { .. })
    }

    /// What is wrong with its numbers, said to whoever gave them.
    ///
    /// # Errors
    /// Which number, and what it may be.
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
