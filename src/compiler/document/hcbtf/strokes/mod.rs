//! The parameters of strokes that stand on the tile.
//!
//! Lengths are in widths of the tile; along u to the right, along v up, and up from the surface.
//! Angles are in radians; those around the normal go from v toward u, as directions do.

mod presets;

use serde::{Deserialize, Serialize};

/// Half a turn, as people write it: a little more than pi.
const HALF: f64 = std::f64::consts::PI + 1e-5;
/// A turn.
const TURN: f64 = 2.0 * HALF;

/// What a generator is told of strokes that stand on the tile.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Strokes {
    /// Another number scatters anew.
    pub seed: u32,
    /// What is seen between the strokes.
    pub ground: StrokeGround,
    /// The shadows that strokes cast.
    pub shadow: StrokeShadow,
    /// The strokes; where none is higher, those of later bundles lie over those of earlier ones.
    pub bundles: Vec<Bundle>,
}

/// What is seen between the strokes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StrokeGround {
    /// Straight RGBA as bytes; an alpha of 0 leaves the strokes alone.
    pub color: [u8; 4],
    /// How much of its color is there in any light, 0 to 2.
    pub ambient: f64,
    /// How much more by Lambert's law, 0 to 2.
    pub diffuse: f64,
}

impl Default for StrokeGround {
    fn default() -> Self {
        Self { color: [255; 4], ambient: 1.0, diffuse: 0.0 }
    }
}

/// The shadows that strokes cast on the ground and on each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StrokeShadow {
    /// How much of the light they take, 0 to 1. What is there in any light they leave.
    pub amount: f64,
    /// How far their edges are blurred, as a share of the way that the shadow falls from the
    /// tallest stroke, 0 to 1.
    pub softness: f64,
}

impl Default for StrokeShadow {
    fn default() -> Self {
        Self { amount: 0.0, softness: 0.2 }
    }
}

/// Strokes of one kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Bundle {
    /// How many there are, and where.
    pub place: Placement,
    /// What a stroke is.
    pub shape: StrokeShape,
    /// From the shortest to the longest, 0 to 4. Dots have none.
    pub length: [f64; 2],
    /// From the narrowest to the widest, 0 to 1; the diameter of a dot.
    pub width: [f64; 2],
    /// How much narrower they become toward the root and toward the tip, each 0 to 1: 1 is a point.
    pub taper: [f64; 2],
    /// How high the root is over the surface, from the lowest to the highest, 0 to 2. Flat ones
    /// that differ by next to nothing lie over each other in any order.
    pub lift: [f64; 2],
    /// From the normal, where a stroke begins, 0 to pi: 0 stands, a quarter of a turn lies.
    pub lean: f64,
    /// By how much more it leans at its tip, -pi to pi: grass nods.
    pub bend: f64,
    /// Where they lean to, around the normal.
    pub direction: f64,
    /// How far they stray from that to either side, 0 to pi: pi is every direction.
    pub spread: f64,
    /// By how much they turn around the normal from root to tip, to one side or the other, -2 pi to
    /// 2 pi.
    pub curl: f64,
    /// How often they turn about their places while the eye goes once around: 0 stay, 1 keep facing
    /// it.
    pub turns: f64,
    /// The colors at the root: each stroke has one between these two. Straight RGB as bytes.
    pub root: [[u8; 3]; 2],
    /// The colors at the tip, mixed as those at the root are.
    pub tip: [[u8; 3]; 2],
    /// How much lighter or darker than others a stroke may be, 0 to 1.
    pub variation: f64,
    /// How much of its color is there in any light, 0 to 2.
    pub ambient: f64,
    /// How much more where it faces the light, 0 to 2.
    pub diffuse: f64,
    /// How much more where the light shines through it from behind, 0 to 2.
    pub translucent: f64,
    /// Its highlight.
    pub highlight: StrokeHighlight,
    /// By which light it is there; always where this is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tones: Option<StrokeTones>,
    /// How much the grain of the paper shows through it, 0 to 1.
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

/// Where strokes are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Placement {
    /// So many, evenly scattered, across the edges of a tile that repeats; the first few are as
    /// even as all.
    Scatter(u32),
    /// About so many, in rows that are shifted by half, as the dots of a half-tone are. There are 2
    /// n² in a square tile.
    Lattice(u32),
    /// Each where its points are, from root to tip: along u, along v, and over the surface.
    Paths(Vec<Vec<[f64; 3]>>),
}

impl Default for Placement {
    fn default() -> Self {
        Self::Scatter(200)
    }
}

/// What a stroke is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StrokeShape {
    /// It grows from its place, and is round: equally wide from every side. Grass, hair, twigs.
    #[default]
    Thread,
    /// Its middle is at its place, and it lies as flat as it can. Strokes of a pen or a brush,
    /// stripes.
    Ribbon,
    /// A round that lies flat; its root is its middle and its tip its rim.
    Dot,
}

/// A highlight, which shadows take away.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct StrokeHighlight {
    /// Straight RGB as bytes.
    pub color: [u8; 3],
    /// How much is added, 0 to 2.
    pub amount: f64,
    /// The power to which its cosine is raised, 1 to 1000: threads by Kajiya and Kay (1989), flat
    /// ones by Blinn (1977).
    pub sharpness: f64,
}

impl Default for StrokeHighlight {
    fn default() -> Self {
        Self { color: [255; 3], amount: 0.0, sharpness: 20.0 }
    }
}

/// By which light strokes are there, so that darker may be more strokes (thesis 11.2). The tone of
/// a light is the cosine of its angle from the normal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StrokeTones {
    /// The tone at which the first appears. Larger than `all`: the darker, the more there are.
    pub first: f64,
    /// The tone from which on all are there.
    pub all: f64,
    /// How slowly each grows from nothing to its width, 0 to 1: at 0 they appear whole, one after
    /// the other, at 1 all of them grow from `first` to `all`.
    #[serde(default)]
    pub growth: f64,
}

impl StrokeTones {
    /// How much of a stroke is there in a light of this tone, 0 to 1. `rank` is its place among the
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
    /// The most bundles.
    pub const MAX_BUNDLES: usize = 32;
    /// The most strokes of one bundle.
    pub const MAX_COUNT: u32 = 4096;
    /// The most points of all paths together.
    pub const MAX_PATH_POINTS: usize = 20_000;
    /// How often all strokes together may cover the tile, by their lengths and widths: time is
    /// bounded by it.
    pub const MAX_LAYERS: f64 = 400.0;

    /// What is wrong with its numbers.
    ///
    /// # Errors
    /// Which number, and what it may be.
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

    /// How often its strokes cover the tile, at most.
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
    /// How many points its paths have.
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
