//! Rules that fill and change the samples that are not painted.

pub(in crate::document) mod about;

use std::f64::consts::PI;

use chiaro_locale::tr;

pub use self::about::{RuleAbout, RuleField};
use super::{Address, AddressFields, Angle, BYTES, Grid, RGBA_BYTES, Relief, Strokes, amount};
use crate::document::described::{DescribedObject as _, described, described_choice};
use crate::document::read::check_value;
use crate::document::shape::{FieldKind, NumberBounds};
use crate::document::word::WordChoice as _;

/// Kind of a painted sample's address.
const SAMPLE: FieldKind = FieldKind::Object(AddressFields::shape);

described_choice! {
    /// Rule for samples that are not painted. Rules work in order: those that fill take samples
    /// that are still empty, those that change take the samples that were filled before them;
    /// painted samples stay as they are (thesis 10.1).
    ///
    /// Fields that a file leaves out are as the window makes them ([`RuleAbout::fresh`]).
    pub enum Rule("rule") {
        /// Fills: the same tile everywhere.
        Copy("copy") as CopyRule {
            /// Painted sample to copy.
            from: Address = Address::default(), SAMPLE;
        }
        /// Fills: painted samples do not depend on these angles. Where several painted samples
        /// differ in them alone, the nearest is taken; where none differs in them alone, the sample
        /// stays empty. At the normal there is no angle around it, so any agrees.
        Lock("lock") as LockRule {
            /// Angles that do not matter.
            angles: Vec<Angle> = vec![Angle::ViewPhi],
                FieldKind::List(&FieldKind::Word(Angle::WORDS), 16);
        }
        /// Fills: blends painted samples by the nearness of their lights and views, on the product
        /// of the two spheres.
        Blend("blend") as BlendRule {
            /// Sharpness of the falloff of influence: 1 is soft, 8 takes nearly the nearest alone.
            sharpness: f64 = 4.0, amount(Rule::MAX_SHARPNESS);
        }
        /// Fills: as `blend`, of the two or three nearest alone, with their strokes moved in place
        /// of faded (thesis 12). Matching parts are looked for; where there are none, the samples
        /// are blended.
        Morph("morph") as MorphRule {
            /// Sharpness of the falloff of influence, as in `blend`.
            sharpness: f64 = 2.0, amount(Rule::MAX_SHARPNESS);
        }
        /// Fills: one color, where the light is near the mirrored direction of the view, fading
        /// outward.
        Mirror("mirror") as MirrorRule {
            /// Color as straight RGBA bytes; the alpha is that at the mirrored direction itself.
            color: [u8; 4] = [255, 250, 235, 255], RGBA_BYTES;
            /// Angle from the mirrored direction to the end of the effect, in radians.
            width: f64 = PI / 8.0, amount(PI);
        }
        /// Fills: copies a painted sample to where the light is near the mirrored direction of the
        /// view, and only there (thesis 10.1: copying restricted to the specular reflection).
        Specular("specular") as SpecularRule {
            /// Painted sample to copy.
            from: Address = Address::default(), SAMPLE;
            /// Angle from the mirrored direction to the end of the effect, in radians.
            width: f64 = PI / 6.0, amount(PI);
        }
        /// Fills: one color.
        Color("color") as ColorRule {
            /// Color as straight RGBA bytes.
            color: [u8; 4] = [128, 128, 128, 255], RGBA_BYTES;
        }
        /// Changes: darker the lower the light stands (thesis eq. 1).
        Lambert("lambert") as LambertRule {
            /// Color to darken to, as straight RGB bytes.
            shadow: [u8; 3] = [20, 18, 32], BYTES;
            /// Strength: 0 leaves the sample unchanged, 1 is Lambert's law.
            amount: f64 = 1.0, amount(1.0);
        }
        /// Changes: turns the tile's content with the view around the normal, so that it keeps
        /// facing the eye: content that points along v at phi 0 points toward the eye at every phi.
        /// Each turned tile is resampled from its unturned source (thesis figure 37), also where
        /// several rules turn it. The view along the normal is not turned.
        Rotate("rotate") as RotateRule {
            /// Number of turns of the content for each turn of the view.
            turns: f64 = 1.0,
                FieldKind::Number(NumberBounds::new(-Rule::MAX_TURNS, Rule::MAX_TURNS));
        }
        /// Changes: multiplies by a color that goes from one to another along an angle. At the
        /// normal, which has no angle around it, by the middle of the two.
        Recolor("recolor") as RecolorRule {
            /// Angle along which the color changes.
            angle: Angle = Angle::LightTheta, FieldKind::Word(Angle::WORDS);
            /// Factor at the angle's beginning, as straight RGB bytes.
            from: [u8; 3] = [255; 3], BYTES;
            /// Factor at the angle's end; for angles around the normal, half a turn away.
            to: [u8; 3] = [255, 170, 110], BYTES;
        }
    }
    boxed {
        /// Fills: draws strokes that stand on the tile, as each eye and each light see them.
        Strokes("strokes") as StrokesRule: Strokes;
        /// Fills: shows a relief of the tile, as each eye and each light see it.
        Relief("relief") as ReliefRule: Relief;
    }
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

    /// Checks the rule: each number by its bounds, and that the grid has what it names.
    ///
    /// # Errors
    /// A message that names the invalid number and its bounds.
    pub fn check(&self, grid: &Grid) -> Result<(), String> {
        check_value(self, &FieldKind::Choice(Self::choice))?;
        self.check_whole(grid)
    }

    /// Checks what the bounds of single numbers do not tell.
    pub(super) fn check_whole(&self, grid: &Grid) -> Result<(), String> {
        match self {
            Self::Copy { from } | Self::Specular { from, .. } if !grid.contains(*from) => {
                Err(tr!("`from` names {from}, which is outside the grid"))
            }
            Self::Lock { angles } if angles.is_empty() => {
                Err(tr!("`angles` names no angle").to_owned())
            }
            Self::Strokes(strokes) => strokes.check_whole(),
            Self::Relief(relief) => relief.check_whole(grid),
            _ => Ok(()),
        }
    }
}
