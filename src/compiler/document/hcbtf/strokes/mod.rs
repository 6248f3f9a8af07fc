//! Parameters of strokes that stand on the tile.
//!
//! Lengths are in widths of the tile; along u to the right, along v up, and up from the surface.
//! Angles are in radians; those around the normal go from v toward u, as directions do.

mod presets;

use chiaro_locale::tr;
use serde::{Deserialize, Serialize};

use super::{BYTES, RGBA_BYTES, SEED, amount};
use crate::diag::Diagnostic;
use crate::document::UnknownFields;
use crate::document::described::{DescribedObject as _, FieldType, described};
use crate::document::json::{JsonWriter, ValueIndex};
use crate::document::read::check_value;
use crate::document::read::reader::Reader;
use crate::document::shape::{FieldKind, NumberBounds};
use crate::document::word::WordChoice as _;

/// Half a turn as people may round it up: a little more than pi, in radians.
const HALF: f64 = std::f64::consts::PI + 1e-5;
/// Full turn, in radians.
const TURN: f64 = 2.0 * HALF;
/// Kind of a range of colors.
const COLORS: FieldKind = FieldKind::Pair(&BYTES);

/// Kind of a range of numbers from 0 to `most`.
const fn range(most: f64) -> FieldKind {
    FieldKind::Numbers(2, 2, NumberBounds::new(0.0, most))
}

/// Kind of a number from `-most` to `most`.
const fn either_way(most: f64) -> FieldKind {
    FieldKind::Number(NumberBounds::new(-most, most))
}

described! {
    /// Parameters of generated strokes that stand on the tile.
    #[serde(default)]
    pub struct Strokes("strokes", Inline) {
        /// Seed of the random scatter.
        seed: u32 = 0, SEED, always;
        /// Ground between the strokes.
        ground: StrokeGround = StrokeGround::default(),
            FieldKind::Object(StrokeGround::shape), always;
        /// Shadows that strokes cast.
        shadow: StrokeShadow = StrokeShadow::default(),
            FieldKind::Object(StrokeShadow::shape), always;
        /// Bundles of strokes; at equal height, strokes of later bundles lie over those of earlier
        /// ones.
        bundles: Vec<Bundle> = Vec::new(),
            FieldKind::List(&FieldKind::Object(Bundle::shape), Strokes::MAX_BUNDLES), always;
    }
}

described! {
    /// Ground that is seen between the strokes.
    #[serde(default)]
    pub struct StrokeGround("ground", Inline) {
        /// Color, as straight RGBA bytes; an alpha of 0 leaves the strokes alone.
        color: [u8; 4] = [255; 4], RGBA_BYTES, always;
        /// Share of the color that shows in any light.
        ambient: f64 = 1.0, amount(2.0), always;
        /// Share of the color added by Lambert's law.
        diffuse: f64 = 0.0, amount(2.0), always;
    }
}

described! {
    /// Shadows that strokes cast on the ground and on each other.
    #[serde(default)]
    pub struct StrokeShadow("shadow", Inline) {
        /// Share of the light that shadows take. They leave the part that shows in any light.
        amount: f64 = 0.0, amount(1.0), always;
        /// Blur of the shadows' edges, as a share of the way that the shadow falls from the tallest
        /// stroke.
        softness: f64 = 0.2, amount(1.0), always;
    }
}

described! {
    /// Bundle of strokes of one kind.
    #[serde(default)]
    pub struct Bundle("bundle", Inline) {
        /// Number and places of the strokes.
        place: Placement = Placement::default(), FieldKind::Object(PlacementFields::shape), always;
        /// Shape of a stroke.
        shape: StrokeShape = StrokeShape::Thread, FieldKind::Word(StrokeShape::WORDS), always;
        /// Least and greatest length. Dots have none.
        length: [f64; 2] = [0.2, 0.3], range(4.0), always;
        /// Least and greatest width, or diameter of a dot.
        width: [f64; 2] = [0.02, 0.03], range(1.0), always;
        /// Taper toward the root and toward the tip: 1 is a point.
        taper: [f64; 2] = [0.0; 2], range(1.0), always;
        /// Least and greatest height of the root over the surface. Flat strokes that differ by next
        /// to nothing lie over each other in any order.
        lift: [f64; 2] = [0.0; 2], range(2.0), always;
        /// Angle from the normal at the root, in radians: 0 stands, a quarter of a turn lies.
        lean: f64 = 0.0, amount(HALF), always;
        /// Additional lean at the tip, in radians: grass nods.
        bend: f64 = 0.0, either_way(HALF), always;
        /// Direction of the lean, around the normal, in radians.
        direction: f64 = 0.0, either_way(TURN), always;
        /// Greatest deviation from that direction to either side, in radians: pi is every
        /// direction.
        spread: f64 = 0.0, amount(HALF), always;
        /// Turn around the normal from root to tip, to one side or the other, in radians.
        curl: f64 = 0.0, either_way(TURN), always;
        /// Turns of the strokes about their places while the eye goes once around: 0 stay, 1 keep
        /// facing the eye.
        turns: f64 = 0.0, either_way(1000.0), always;
        /// Range of colors at the root: each stroke has one between these two. Straight RGB as
        /// bytes.
        root: [[u8; 3]; 2] = [[0; 3]; 2], COLORS, always;
        /// Range of colors at the tip, mixed as those at the root are.
        tip: [[u8; 3]; 2] = [[0; 3]; 2], COLORS, always;
        /// Variation of brightness between strokes.
        variation: f64 = 0.0, amount(1.0), always;
        /// Share of the color that shows in any light.
        ambient: f64 = 1.0, amount(2.0), always;
        /// Share of the color added where the stroke faces the light.
        diffuse: f64 = 0.0, amount(2.0), always;
        /// Share of the color added where the light shines through the stroke from behind.
        translucent: f64 = 0.0, amount(2.0), always;
        /// Highlight of the stroke.
        highlight: StrokeHighlight = StrokeHighlight::default(),
            FieldKind::Object(StrokeHighlight::shape), always;
        /// Tones of light in which the stroke shows.
        #[serde(skip_serializing_if = "Option::is_none")]
        tones: Option<StrokeTones> = None, FieldKind::Object(StrokeTones::shape), words "all";
        /// Strength with which the grain of the paper shows through the stroke.
        grain: f64 = 0.0, amount(1.0), always;
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

/// Kind of a count of strokes.
const COUNT: FieldKind = FieldKind::Number(NumberBounds::whole(0.0, Strokes::MAX_COUNT as f64));
/// Kind of the points of a path.
const PATH: FieldKind = FieldKind::List(
    &FieldKind::Numbers(3, 3, NumberBounds::new(-4.0, 4.0)),
    Strokes::MAX_PATH_POINTS,
);

described! {
    /// Number and places of strokes: one of these fields.
    #[serde(default)]
    pub struct PlacementFields("placement", Inline) {
        /// Number of strokes, evenly scattered.
        scatter: Option<u32> = None, COUNT, words "";
        /// About the number of strokes, in rows that are shifted by half.
        lattice: Option<u32> = None, COUNT, words "";
        /// Paths of strokes, each of points along u, along v and over the surface, from root to
        /// tip.
        paths: Option<Vec<Vec<[f64; 3]>>> = None,
            FieldKind::List(&PATH, Strokes::MAX_PATH_POINTS), words "";
    }
}

impl FieldType for Placement {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        let fields = PlacementFields::read(r, at, kind, extras)?;
        let names = ["scatter", "lattice", "paths"];
        let given = names.iter().filter(|name| r.tree.member(at, name).is_some()).count();
        match fields {
            PlacementFields { scatter: Some(count), lattice: None, paths: None } => {
                Some(Self::Scatter(count))
            }
            PlacementFields { scatter: None, lattice: Some(count), paths: None } => {
                Some(Self::Lattice(count))
            }
            PlacementFields { scatter: None, lattice: None, paths: Some(paths) } => {
                Some(Self::Paths(paths))
            }
            // The one field has been reported.
            _ if given == 1 => None,
            _ => {
                let message =
                    tr!("a placement has one of the fields `scatter`, `lattice` and `paths`");
                r.report(
                    at,
                    Diagnostic::error("wrong-count", message).hint(tr!("write one of them")),
                );
                None
            }
        }
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        let mut fields = PlacementFields::default();
        match self.clone() {
            Self::Scatter(count) => fields.scatter = Some(count),
            Self::Lattice(count) => fields.lattice = Some(count),
            Self::Paths(paths) => fields.paths = Some(paths),
        }
        fields.write(w, unknown);
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
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

described! {
    /// Highlight, which shadows take away.
    #[serde(default)]
    pub struct StrokeHighlight("highlight", Inline) {
        /// Color, as straight RGB bytes.
        color: [u8; 3] = [255; 3], BYTES, always;
        /// Amount of the color that is added.
        amount: f64 = 0.0, amount(2.0), always;
        /// Exponent of the cosine: threads by Kajiya and Kay (1989), flat strokes by Blinn (1977).
        sharpness: f64 = 20.0, FieldKind::Number(NumberBounds::new(1.0, 1000.0)), always;
    }
}

/// Kind of a tone.
const TONE: FieldKind = FieldKind::Number(NumberBounds::new(-1.0, 2.0));

described! {
    /// Tones of light in which strokes show, so that darker may be more strokes (thesis 11.2). The
    /// tone of a light is the cosine of its angle from the normal.
    #[derive(Copy)]
    pub struct StrokeTones("range of tones", Inline) {
        /// Tone at which the first stroke appears. Larger than `all`: the darker, the more strokes
        /// there are.
        first: f64, TONE, required;
        /// Tone from which on all strokes are there.
        all: f64, TONE, required;
        /// Slowness of each stroke's growth from nothing to its width: at 0 the strokes appear
        /// whole, one after the other, at 1 all of them grow from `first` to `all`.
        #[serde(default)]
        growth: f64 = 0.0, amount(1.0), always;
    }
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

    /// Checks the strokes: each number by its bounds, and all of them together.
    ///
    /// # Errors
    /// A message that names the invalid number and its bounds.
    pub fn check(&self) -> Result<(), String> {
        check_value(self, &FieldKind::Object(Self::shape))?;
        self.check_whole()
    }

    /// Checks what the bounds of single numbers do not tell.
    pub(super) fn check_whole(&self) -> Result<(), String> {
        for (index, bundle) in self.bundles.iter().enumerate() {
            bundle.check_whole().map_err(|why| tr!("in bundle {index}, {why}"))?;
        }
        let points: usize = self.bundles.iter().map(|bundle| bundle.place.points()).sum();
        if points > Self::MAX_PATH_POINTS {
            return Err(tr!(
                "all paths have {points} points; at most {most} can be",
                most = Self::MAX_PATH_POINTS
            ));
        }
        let layers: f64 = self.bundles.iter().map(Bundle::layers).sum();
        if layers > Self::MAX_LAYERS {
            let most = Self::MAX_LAYERS;
            return Err(tr!(
                "the strokes cover the tile {layers:.0} times; at most {most} can be: take fewer \
                 or finer"
            ));
        }
        Ok(())
    }
}

impl Bundle {
    fn check_whole(&self) -> Result<(), String> {
        if self.tones.is_some_and(|tones| (tones.first - tones.all).abs() < 1e-6) {
            return Err(
                tr!("`tones.first` and `tones.all` are equal; one must be larger").to_owned()
            );
        }
        let Placement::Paths(paths) = &self.place else { return Ok(()) };
        match paths.iter().flatten().find(|point| point[2] < 0.0) {
            Some([_, _, height]) => {
                Err(tr!("a point of `paths` has the height {height}; it must be from 0 to 4"))
            }
            None => Ok(()),
        }
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
}
