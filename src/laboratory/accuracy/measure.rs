//! Measure of an error: the one figure of a comparison that a bound applies to.

use std::str::FromStr;

use serde::{Serialize, Serializer};

use super::ErrorFigures;

/// One of the figures of a comparison with the truth.
///
/// The default is the 99.9th percentile, because an eye judges a picture by it: the largest
/// difference is that of a single pixel, where a crease or a silhouette decides by the last bit of
/// f32, and the exact tier itself may be far off there. Over several views each view has to be
/// within the bound, so that a bad view is not averaged away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Measure {
    /// The largest difference of any channel of any pixel.
    Max,
    /// Error that all but one pixel in a thousand stay below, in every view.
    #[default]
    P999,
    /// The root of the mean square over all channels and pixels.
    Rms,
}

impl Measure {
    /// Number of the measure among `figures`.
    pub fn of(self, figures: &ErrorFigures) -> f64 {
        match self {
            Self::Max => figures.max,
            Self::P999 => figures.p999,
            Self::Rms => figures.rms,
        }
    }

    /// The word for this measure on the command line and in reports.
    pub fn word(self) -> &'static str {
        match self {
            Self::Max => "max",
            Self::P999 => "p99.9",
            Self::Rms => "rms",
        }
    }

    /// Meaning of a bound on this measure, as a phrase for reports.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Max => "the largest error of any pixel",
            Self::P999 => "the error that one pixel in a thousand exceeds",
            Self::Rms => "the root mean square error",
        }
    }
}

impl FromStr for Measure {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let known =
            [Self::Max, Self::P999, Self::Rms].into_iter().find(|measure| measure.word() == text);
        known.ok_or_else(|| "write max, p99.9 or rms".to_owned())
    }
}

impl Serialize for Measure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_word_names_its_figure() {
        let figures = ErrorFigures { max: 3.0, p999: 2.0, rms: 1.0, ..ErrorFigures::default() };
        for (word, wanted) in [("max", 3.0), ("p99.9", 2.0), ("rms", 1.0)] {
            let measure: Measure = word.parse().unwrap();
            assert_eq!((measure.of(&figures), measure.word()), (wanted, word));
        }
        assert!("most".parse::<Measure>().is_err());
    }
}
