//! Words that choices are written with.

use chiaro_locale::tr_in;

use super::hcbtf::relief::Channel;
use super::hcbtf::{Angle, StrokeShape};
use super::{
    ColorSpace, Extrapolation, HandlePair, Interpolation, KeyScheme, LightKind, LightSpace,
    Projection, Tier, TimeInterpolation,
};

/// Choice that is written as a word.
pub(super) trait WordChoice: Sized + Copy + PartialEq + 'static {
    /// Each word and its meaning.
    const WORDS: &'static [(&'static str, &'static str)];
    /// Choices, in the order of the words.
    const ALL: &'static [Self];

    /// Word of the choice.
    fn word(self) -> &'static str {
        let index = Self::ALL.iter().position(|&choice| choice == self);
        index.map_or("", |index| Self::WORDS[index].0)
    }

    /// Meaning of the choice's word.
    fn meaning(self) -> &'static str {
        let index = Self::ALL.iter().position(|&choice| choice == self);
        index.map_or("", |index| Self::WORDS[index].1)
    }

    /// Choice with a word.
    fn from_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().position(|(known, _)| *known == word).map(|index| Self::ALL[index])
    }
}

macro_rules! words {
    ($name:ident { $($variant:ident $word:literal $help:literal,)* }) => {
        impl WordChoice for $name {
            const WORDS: &'static [(&'static str, &'static str)] = &[$(($word, $help)),*];
            const ALL: &'static [Self] = &[$(Self::$variant),*];
        }
    };
}

words!(ColorSpace {
    Display "display" "as they are shown (sRGB-encoded); layers blend as in a painting program",
    Linear "linear" "linear light, encoded to sRGB where a picture is shown or written as PNG",
});
words!(Tier {
    Exact "exact" "the truth, as near as 32-bit numbers come",
    Balanced "balanced" "errors below what is seen, where that is faster",
    Fast "fast" "the least time; edges and curvature are seen to differ",
});
words!(LightKind {
    Directional "directional" "the same direction everywhere",
    Point "point" "at a position, shining everywhere",
    Spot "spot" "at a position, shining into a cone",
});
words!(LightSpace {
    Illumination "illumination" "the illumination frame, which turns all its lights together",
    World "world" "the world",
    Camera "camera" "the camera: x right, y up, z toward the viewer",
    Object "object" "each object that wears the look, for itself: from the middle of its box, with \
        its axes, in the scene's unit",
});
words!(KeyScheme {
    Biharmonic "biharmonic" "the sphere's biharmonic functions in closed form",
    AppendixB "appendix-b" "the continuum limit of the energy of BADF Appendix B, in closed form",
    Tessellated "tessellated" "the paper's own least squares over a tessellated sphere; for \
                               comparison",
});
words!(Interpolation {
    Linear "linear" "straight",
    Smooth "smooth" "smooth, without overshoot (monotone cubic)",
    Stepped "stepped" "each value holds until the next",
});
words!(TimeInterpolation {
    Linear "linear" "evenly",
    Smooth "smooth" "slow at both keys",
    Stepped "stepped" "the value holds until the next key",
    Bezier "bezier" "a cubic by the [handles](#handles) of both keys",
});
words!(Extrapolation {
    Hold "hold" "the key's value",
    Linear "linear" "on with the curve's slope at the key",
    Cycle "cycle" "all keys again",
    CycleOffset "cycle_offset" "all keys again, each time from the value that was reached",
    Mirror "mirror" "all keys to and fro",
});
words!(HandlePair {
    Aligned "aligned" "one turns with the other",
    Free "free" "each is moved by itself",
});
words!(Projection {
    Perspective "perspective" "lines meet at the eye",
    Orthographic "orthographic" "parallel lines stay parallel",
});
words!(Angle {
    LightTheta "light_theta" "the light's angle from the normal",
    LightPhi "light_phi" "the light's angle around the normal",
    ViewTheta "view_theta" "the eye's angle from the normal",
    ViewPhi "view_phi" "the eye's angle around the normal",
});
words!(StrokeShape {
    Thread "thread" "round, and grows from its place",
    Ribbon "ribbon" "flat, its middle at its place",
    Dot "dot" "a flat round, its root the middle and its tip the rim",
});
words!(Channel {
    Luminance "luminance" "bright texels stand high",
    Alpha "alpha" "opaque texels stand high; the relief is then opaque everywhere",
});

impl LightKind {
    /// All kinds, in the order of menus.
    pub const ALL: &'static [Self] = <Self as WordChoice>::ALL;

    /// Word of the kind in files, and in node files for functions of one kind.
    pub fn word(self) -> &'static str {
        WordChoice::word(self)
    }

    /// Meaning of the kind: a phrase for docs and tooltips.
    pub fn help(self) -> &'static str {
        tr_in("choice", self.meaning())
    }
}

impl LightSpace {
    /// All frames, in the order of menus.
    pub const ALL: &'static [Self] = <Self as WordChoice>::ALL;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn agree_with_serde<T: WordChoice + serde::Serialize + std::fmt::Debug>() {
        assert_eq!(T::WORDS.len(), T::ALL.len());
        for &choice in T::ALL {
            assert_eq!(serde_json::to_value(choice).unwrap(), choice.word());
            assert_eq!(T::from_word(choice.word()), Some(choice));
        }
    }

    #[test]
    fn journals_and_documents_use_the_same_words() {
        agree_with_serde::<ColorSpace>();
        agree_with_serde::<Tier>();
        agree_with_serde::<LightKind>();
        agree_with_serde::<LightSpace>();
        agree_with_serde::<KeyScheme>();
        agree_with_serde::<Interpolation>();
        agree_with_serde::<TimeInterpolation>();
        agree_with_serde::<Extrapolation>();
        agree_with_serde::<HandlePair>();
        agree_with_serde::<Projection>();
        agree_with_serde::<Angle>();
        agree_with_serde::<StrokeShape>();
        agree_with_serde::<Channel>();
    }
}
