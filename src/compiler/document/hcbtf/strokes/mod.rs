//! Parameters of strokes that stand on the tile.
//!
//! Lengths are in widths of the tile; along u to the right, along v up, and up from the surface.
//! Angles are in radians; those around the normal go from v toward u, as directions do.

mod presets;

use serde::{Deserialize, Serialize};

/// Half a turn as people may round it up: a little more than pi, in radians.
const HALF: f64 = std::f64::consts::PI + 1e-5;
/// Full turn, in radians.
const TURN: f64 = 2.0 * HALF;

/// Parameters of generated strokes that stand on the tile.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Strokes {
    /// Seed of the random scatter.
    pub seed: u32,
    /// Ground between the strokes.
    pub ground: StrokeGround,
    /// Shadows that strokes cast.
    pub shadow: StrokeShadow,
    /// Bundles of strokes; at equal height, strokes of later bundles lie over those of earlier
    /// ones.
    pub bundles: Vec<Bundle>,
}

/// Ground that is seen between the strokes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StrokeGround {
    /// Color, as straight RGBA bytes; an alpha of 0 leaves the strokes alone.
    pub color: [u8; 4],
    /// Share of the color that shows in any light, 0 to 2.
    pub ambient: f64,
    /// Share of the color added by Lambert's law, 0 to 2.
    pub diffuse: f64,
}

impl Default for StrokeGround {
    fn default() -> Self {
        Self { color: [255; 4], ambient: 1.0, diffuse: 0.0 }
    }
}

/// Shadows that strokes cast on the ground and on each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StrokeShadow {
    /// Share of the light that shadows take, 0 to 1. They leave the part that shows in any light.
    pub amount: f64,
    /// Blur of the shadows' edges, as a share of the way that the shadow falls from the tallest
    /// stroke, 0 to 1.
    pub softness: f64,
}

impl Default for StrokeShadow {
    fn default() -> Self {
        Self { amount: 0.0, softness: 0.2 }
    }
}

/// Bundle of strokes of one kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Bundle {
    /// Number and places of the strokes.
    pub place: Placement,
    /// Shape of a stroke.
    pub shape: StrokeShape,
    /// Least and greatest length, 0 to 4. Dots have none.
    pub length: [f64; 2],
    /// Least and greatest width, or diameter of a dot, 0 to 1.
    pub width: [f64; 2],
    /// Taper toward the root and toward the tip, each 0 to 1: 1 is a point.
    pub taper: [f64; 2],
    /// Least and greatest height of the root over the surface, 0 to 2. Flat strokes that differ by
    /// next to nothing lie over each other in any order.
    pub lift: [f64; 2],
    /// Angle from the normal at the root, 0 to pi: 0 stands, a quarter of a turn lies.
    pub lean: f64,
    /// Additional lean at the tip, -pi to pi: grass nods.
    pub bend: f64,
    /// Direction of the lean, around the normal.
    pub direction: f64,
    /// Greatest deviation from that direction to either side, 0 to pi: pi is every direction.
    pub spread: f64,
    /// Turn around the normal from root to tip, to one side or the other, -2 pi to 2 pi.
    pub curl: f64,
    /// Turns of the strokes about their places while the eye goes once around: 0 stay, 1 keep
    /// facing the eye.
    pub turns: f64,
    /// Range of colors at the root: each stroke has one between these two. Straight RGB as bytes.
    pub root: [[u8; 3]; 2],
    /// Range of colors at the tip, mixed as those at the root are.
    pub tip: [[u8; 3]; 2],
    /// Variation of brightness between strokes, 0 to 1.
    pub variation: f64,
    /// Share of the color that shows in any light, 0 to 2.
    pub ambient: f64,
    /// Share of the color added where the stroke faces the light, 0 to 2.
    pub diffuse: f64,
    /// Share of the color added where the light shines through the stroke from behind, 0 to 2.
    pub translucent: f64,
    /// Highlight of the stroke.
    pub highlight: StrokeHighlight,
    /// Tones of light in which the stroke shows; all where left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tones: Option<StrokeTones>,
    /// Strength with which the grain of the paper shows through the stroke, 0 to 1.
    pub grain: f64,
}

impl Default for Bundle {
    fn default() -> Self {
        Self {
            place: Placement::default(),
            shape: StrokeShape::default(),
            length: [0.2, 0.3],
            width: [0.02, 0.03],
            taper: [0.0; 2],
            lift: [0.0; 2],
            lean: 0.0,
            bend: 0.0,
            direction: 0.0,
            spread: 0.0,
            curl: 0.0,
            turns: 0.0,
            root: [[0; 3]; 2],
            tip: [[0; 3]; 2],
            variation: 0.0,
            ambient: 1.0,
            diffuse: 0.0,
            translucent: 0.0,
            highlight: StrokeHighlight::default(),
            tones: None,
            grain: 0.0,
        }
    }
}

/// Places of strokes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Placement {
    /// Given number of strokes, evenly scattered, across the edges of a tile that repeats; the
    /// first few are as even as all.
    Scatter(u32),
    /// About the given number of strokes, in rows that are shifted by half, as the dots of a
    /// half-tone are. There are 2 n² in a square tile.
    Lattice(u32),
    /// Strokes along the points of paths, from root to tip: along u, along v, and over the surface.
    Paths(Vec<Vec<[f64; 3]>>),
}

impl Default for Placement {
    fn default() -> Self {
        Self::Scatter(200)
    }
}

/// Shape of a stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StrokeShape {
    /// Thread that grows from its place, and is round: equally wide from every side. Grass, hair,
    /// twigs.
    #[default]
    Thread,
    /// Ribbon with its middle at its place, as flat as it can lie. Strokes of a pen or a brush,
    /// stripes.
    Ribbon,
    /// Round dot that lies flat; its root is its middle and its tip its rim.
    Dot,
}

/// Highlight, which shadows take away.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StrokeHighlight {
    /// Color, as straight RGB bytes.
    pub color: [u8; 3],
    /// Amount of the color that is added, 0 to 2.
    pub amount: f64,
    /// Exponent of the cosine, 1 to 1000: threads by Kajiya and Kay (1989), flat strokes by Blinn
    /// (1977).
    pub sharpness: f64,
}

impl Default for StrokeHighlight {
    fn default() -> Self {
        Self { color: [255; 3], amount: 0.0, sharpness: 20.0 }
    }
}

/// Tones of light in which strokes show, so that darker may be more strokes (thesis 11.2). The tone
/// of a light is the cosine of its angle from the normal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StrokeTones {
    /// Tone at which the first stroke appears. Larger than `all`: the darker, the more strokes
    /// there are.
    pub first: f64,
    /// Tone from which on all strokes are there.
    pub all: f64,
    /// Slowness of each stroke's growth from nothing to its width, 0 to 1: at 0 the strokes appear
    /// whole, one after the other, at 1 all of them grow from `first` to `all`.
    #[serde(default)]
    pub growth: f64,
}

impl StrokeTones {
    /// Share of a stroke that shows in a light of this tone, 0 to 1. `rank` is its place among the
    /// bundle, 0 to 1.
    pub fn share(&self, tone: f64, rank: f64) -> f64 {
        let gone = ((self.first - tone) / (self.first - self.all)).clamp(0.0, 1.0);
        let begins = rank * (1.0 - self.growth);
        if self.growth > 0.0 {
            ((gone - begins) / self.growth).clamp(0.0, 1.0)
        } else {
            f64::from(u8::from(gone > begins))
        }
    }
}

impl Strokes {
    /// Greatest number of bundles.
    pub const MAX_BUNDLES: usize = 32;
    /// Greatest number of strokes of one bundle.
    pub const MAX_COUNT: u32 = 4096;
    /// Greatest number of points of all paths together.
    pub const MAX_PATH_POINTS: usize = 20_000;
    /// Greatest number of times that all strokes together may cover the tile, by their lengths and
    /// widths; it bounds the time of drawing.
    pub const MAX_LAYERS: f64 = 400.0;

    /// Checks the numbers of the strokes.
    ///
    /// # Errors
    /// A message that names the invalid number and its bounds.
    pub fn check(&self) -> Result<(), String> {
        within("ground.ambient", self.ground.ambient, 0.0, 2.0)?;
        within("ground.diffuse", self.ground.diffuse, 0.0, 2.0)?;
        within("shadow.amount", self.shadow.amount, 0.0, 1.0)?;
        within("shadow.softness", self.shadow.softness, 0.0, 1.0)?;
        if self.bundles.len() > Self::MAX_BUNDLES {
            return Err(format!(
                "there are {} bundles; at most {} can be",
                self.bundles.len(),
                Self::MAX_BUNDLES
            ));
        }
        for (index, bundle) in self.bundles.iter().enumerate() {
            bundle.check().map_err(|why| format!("in bundle {index}, {why}"))?;
        }
        let points: usize = self.bundles.iter().map(|bundle| bundle.place.points()).sum();
        if points > Self::MAX_PATH_POINTS {
            return Err(format!(
                "all paths have {points} points; at most {} can be",
                Self::MAX_PATH_POINTS
            ));
        }
        let layers: f64 = self.bundles.iter().map(Bundle::layers).sum();
        if layers > Self::MAX_LAYERS {
            let most = Self::MAX_LAYERS;
            return Err(format!(
                "the strokes cover the tile {layers:.0} times; at most {most} can be: take fewer \
                 or finer"
            ));
        }
        Ok(())
    }
}

impl Bundle {
    fn check(&self) -> Result<(), String> {
        for (name, pair, most) in [
            ("length", self.length, 4.0),
            ("width", self.width, 1.0),
            ("taper", self.taper, 1.0),
            ("lift", self.lift, 2.0),
        ] {
            pair.into_iter().try_for_each(|value| within(name, value, 0.0, most))?;
        }
        within("lean", self.lean, 0.0, HALF)?;
        within("bend", self.bend, -HALF, HALF)?;
        within("direction", self.direction, -TURN, TURN)?;
        within("spread", self.spread, 0.0, HALF)?;
        within("curl", self.curl, -TURN, TURN)?;
        within("turns", self.turns, -1000.0, 1000.0)?;
        within("variation", self.variation, 0.0, 1.0)?;
        within("ambient", self.ambient, 0.0, 2.0)?;
        within("diffuse", self.diffuse, 0.0, 2.0)?;
        within("translucent", self.translucent, 0.0, 2.0)?;
        within("highlight.amount", self.highlight.amount, 0.0, 2.0)?;
        within("highlight.sharpness", self.highlight.sharpness, 1.0, 1000.0)?;
        within("grain", self.grain, 0.0, 1.0)?;
        if let Some(tones) = self.tones {
            within("tones.first", tones.first, -1.0, 2.0)?;
            within("tones.all", tones.all, -1.0, 2.0)?;
            within("tones.growth", tones.growth, 0.0, 1.0)?;
            if (tones.first - tones.all).abs() < 1e-6 {
                return Err(
                    "`tones.first` and `tones.all` are equal; one must be larger".to_owned()
                );
            }
        }
        self.place.check()
    }

    /// Greatest number of times that the bundle's strokes cover the tile.
    fn layers(&self) -> f64 {
        let [length, width] = [self.length, self.width].map(|pair| pair[0].max(pair[1]));
        let length = if self.shape == StrokeShape::Dot { width } else { length };
        match &self.place {
            Placement::Scatter(count) | Placement::Lattice(count) => {
                f64::from(*count) * length * width
            }
            Placement::Paths(paths) => {
                let along = |path: &Vec<[f64; 3]>| -> f64 {
                    path.windows(2)
                        .map(|pair| (0..3).map(|i| (pair[1][i] - pair[0][i]).abs()).sum::<f64>())
                        .sum()
                };
                width * paths.iter().map(along).sum::<f64>()
            }
        }
    }
}

impl Placement {
    /// Number of points of all paths.
    fn points(&self) -> usize {
        if let Self::Paths(paths) = self { paths.iter().map(Vec::len).sum() } else { 0 }
    }

    fn check(&self) -> Result<(), String> {
        match self {
            Self::Scatter(count) | Self::Lattice(count) if *count > Strokes::MAX_COUNT => {
                Err(format!(
                    "there are {count} strokes; at most {} can be in a bundle",
                    Strokes::MAX_COUNT
                ))
            }
            Self::Paths(paths) => {
                for [u, v, height] in paths.iter().flatten() {
                    within("paths: u", *u, -4.0, 4.0)?;
                    within("paths: v", *v, -4.0, 4.0)?;
                    within("paths: height", *height, 0.0, 4.0)?;
                }
                Ok(())
            }
            Self::Scatter(_) | Self::Lattice(_) => Ok(()),
        }
    }
}

fn within(name: &str, value: f64, least: f64, most: f64) -> Result<(), String> {
    let is_within = (least..=most).contains(&value);
    if is_within {
        Ok(())
    } else {
        Err(format!("`{name}` is {value}; it must be from {least} to {most:.4}"))
    }
}
