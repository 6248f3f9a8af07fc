//! Hand-painted 6D texture (HCBTF): painted samples, and the rules that fill the others.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use chiaro_locale::tr;
use serde::{Deserialize, Serialize};

use super::UnknownFields;
use super::described::{FieldType, described};
use super::json::{JsonWriter, ValueIndex};
use super::read::reader::Reader;
use super::shape::{FieldKind, NumberBounds};

mod file;
pub mod relief;
pub(in crate::document) mod rule;
mod strokes;

pub use file::{HcbtfListing, HcbtfManifest, PaintedSample, read_rules};
pub use relief::Relief;
pub use rule::{Rule, RuleAbout, RuleField};
pub use strokes::{
    Bundle, Placement, StrokeGround, StrokeHighlight, StrokeShadow, StrokeShape, StrokeTones,
    Strokes,
};

/// Greatest number of texels along a side of a tile.
pub const MAX_TILE_SIDE: u32 = 4095;
/// Greatest number of steps of an angle.
pub const MAX_ANGLE_STEPS: u32 = 255;

/// Kind of a color as straight RGB bytes.
pub(super) const BYTES: FieldKind = FieldKind::Numbers(3, 3, NumberBounds::whole(0.0, 255.0));
/// Kind of a color as straight RGBA bytes.
const RGBA_BYTES: FieldKind = FieldKind::Numbers(4, 4, NumberBounds::whole(0.0, 255.0));
/// Kind of a seed.
const SEED: FieldKind = FieldKind::Number(NumberBounds::whole(0.0, u32::MAX as f64));
/// Kind of a number of steps of an angle.
const STEPS: FieldKind = FieldKind::Number(NumberBounds::whole(1.0, MAX_ANGLE_STEPS as f64));

/// Kind of a number from 0 to `most`.
const fn amount(most: f64) -> FieldKind {
    FieldKind::Number(NumberBounds::new(0.0, most))
}

described! {
    /// Grid of directions over the hemisphere: rings from the normal down to the horizon, and steps
    /// around it. Ring `theta` of `n` lies `theta / (n - 1)` of a quarter turn from the normal
    /// (thesis 10.2: 6 rings, 18 degrees apart); step `phi` of `n` lies `phi / n` of a turn from v
    /// toward u.
    #[derive(Copy, Eq, Hash)]
    pub struct Directions("grid of directions", Inline) {
        /// Number of rings: 1 is the normal alone.
        theta: u32, STEPS, required;
        /// Number of steps around each ring.
        phi: u32, STEPS, required;
    }
}

impl Directions {
    /// Number of directions, with the normal once for each step around it.
    pub fn count(self) -> usize {
        self.theta as usize * self.phi as usize
    }

    /// Distinct directions: the normal only once.
    pub fn distinct(self) -> impl Iterator<Item = Direction> {
        let ring = move |theta| {
            (0..if theta == 0 { 1 } else { self.phi }).map(move |phi| Direction { theta, phi })
        };
        (0..self.theta).flat_map(ring)
    }

    /// Number of distinct directions: the normal is one direction, whatever the step around it.
    pub fn distinct_count(self) -> u64 {
        1 + u64::from(self.theta.max(1) - 1) * u64::from(self.phi)
    }

    /// Index of a direction in [`Self::distinct`].
    pub fn index(self, direction: Direction) -> u64 {
        match direction.canonical() {
            Direction { theta: 0, .. } => 0,
            Direction { theta, phi } => {
                1 + u64::from(theta - 1) * u64::from(self.phi) + u64::from(phi)
            }
        }
    }

    /// True if the grid has a direction.
    pub fn contains(self, direction: Direction) -> bool {
        direction.theta < self.theta && direction.phi < self.phi
    }

    /// Angles of a direction, from the normal, and around it from v toward u; in radians.
    pub fn angles(self, direction: Direction) -> [f64; 2] {
        let rings = f64::from(self.theta.max(2) - 1);
        let quarter = std::f64::consts::FRAC_PI_2;
        [
            quarter * f64::from(direction.theta) / rings,
            std::f64::consts::TAU * f64::from(direction.phi) / f64::from(self.phi.max(1)),
        ]
    }

    /// Unit vector of a direction: along u, along v, along the normal.
    pub fn vector(self, direction: Direction) -> glam::DVec3 {
        let [theta, phi] = self.angles(direction);
        glam::DVec3::new(theta.sin() * phi.sin(), theta.sin() * phi.cos(), theta.cos())
    }
}

described! {
    /// Grid of an HCBTF: the sizes of its six dimensions.
    #[derive(Copy, Eq, Hash)]
    pub struct Grid("grid", Inline) {
        /// Texels of a tile along u and along v; rows go down from where v is largest.
        size: [u32; 2],
            FieldKind::Numbers(2, 2, NumberBounds::whole(1.0, MAX_TILE_SIDE as f64)), required;
        /// Directions toward the light.
        light: Directions, FieldKind::Object(Directions::shape), required;
        /// Directions toward the eye.
        view: Directions, FieldKind::Object(Directions::shape), required;
    }
}

impl Grid {
    /// Grid of the thesis: 32 x 32 texels, 6 x 10 lights, 6 x 10 views (thesis 10.2).
    pub const THESIS: Self = {
        let directions = Directions { theta: 6, phi: 10 };
        Self { size: [32, 32], light: directions, view: directions }
    };

    /// Number of texels of a tile.
    pub fn texels(&self) -> usize {
        self.size[0] as usize * self.size[1] as usize
    }

    /// True if the grid has a sample.
    pub fn contains(&self, address: Address) -> bool {
        self.light.contains(address.light) && self.view.contains(address.view)
    }

    /// Addresses of the distinct samples, by view and then by light.
    pub fn addresses(&self) -> impl Iterator<Item = Address> {
        let light = self.light;
        self.view
            .distinct()
            .flat_map(move |view| light.distinct().map(move |light| Address { light, view }))
    }

    /// Number of samples that [`Self::addresses`] gives.
    pub fn sample_count(&self) -> u64 {
        self.view.distinct_count() * self.light.distinct_count()
    }

    /// Index of a sample in [`Self::addresses`]; `None` outside the grid.
    pub fn index(&self, address: Address) -> Option<u64> {
        let index = || {
            self.view.index(address.view) * self.light.distinct_count()
                + self.light.index(address.light)
        };
        self.contains(address).then(index)
    }

    /// Checks the numbers of the grid.
    ///
    /// # Errors
    /// A message that names the invalid number and its bounds.
    pub fn check(&self) -> Result<(), String> {
        let sides = [("width", self.size[0]), ("height", self.size[1])];
        let angles = [
            (tr!("light's theta"), self.light.theta),
            (tr!("light's phi"), self.light.phi),
            (tr!("view's theta"), self.view.theta),
            (tr!("view's phi"), self.view.phi),
        ];
        for (most, numbers) in [(MAX_TILE_SIDE, &sides[..]), (MAX_ANGLE_STEPS, &angles[..])] {
            if let Some((name, number)) =
                numbers.iter().find(|(_, number)| *number == 0 || *number > most)
            {
                return Err(tr!("the grid's {name} is {number}; it must be from 1 to {most}"));
            }
        }
        Ok(())
    }
}

/// Direction of a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Direction {
    /// Ring, 0 at the normal.
    pub theta: u32,
    /// Step around the ring.
    pub phi: u32,
}

impl Direction {
    /// Canonical form of the direction: the normal itself has no angle around it.
    pub fn canonical(self) -> Self {
        if self.theta == 0 { Self::default() } else { self }
    }
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.theta, self.phi)
    }
}

/// Address of a sample: a tile as it looks under one light for one eye.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Address {
    /// Direction toward the eye.
    pub view: Direction,
    /// Direction toward the light.
    pub light: Direction,
}

impl Address {
    /// Address of the sample for a light and a view, each by ring and step.
    pub fn new(light: [u32; 2], view: [u32; 2]) -> Self {
        let direction = |[theta, phi]: [u32; 2]| Direction { theta, phi };
        Self { light: direction(light), view: direction(view) }.canonical()
    }

    /// Address by which the sample is kept: at the normal there is one sample, whatever the step
    /// around it.
    pub fn canonical(self) -> Self {
        Self { view: self.view.canonical(), light: self.light.canonical() }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { light, view } = self;
        f.write_str(&tr!("light {light}, view {view}"))
    }
}

/// Texels of a tile: straight RGBA, 8 bits a channel, rows from the top.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Tile {
    size: [u32; 2],
    rgba: Vec<u8>,
}

impl fmt::Debug for Tile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Tile({} x {})", self.size[0], self.size[1])
    }
}

impl Tile {
    /// Tile from its bytes; `None` where there are not four for every texel.
    pub fn new(size: [u32; 2], rgba: Vec<u8>) -> Option<Self> {
        let count = size[0] as usize * size[1] as usize * 4;
        (rgba.len() == count && count > 0).then_some(Self { size, rgba })
    }

    /// Tile of one color.
    pub fn filled(size: [u32; 2], color: [u8; 4]) -> Self {
        let size = size.map(|side| side.max(1));
        Self { size, rgba: color.repeat(size[0] as usize * size[1] as usize) }
    }

    /// Width and height, in texels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Bytes of the texels, four for each.
    pub fn bytes(&self) -> &[u8] {
        &self.rgba
    }

    /// Bytes of the texels, four for each, to be painted on.
    pub fn bytes_mut(&mut self) -> &mut [u8] {
        &mut self.rgba
    }

    /// Smallest rectangle (x, y, width, height) around the texels that differ from another tile's;
    /// `None` where all are equal. The whole tile where the other has another size.
    pub fn difference(&self, other: &Self) -> Option<[u32; 4]> {
        let [width, height] = self.size;
        if self.size != other.size {
            return Some([0, 0, width, height]);
        }
        let stride = 4 * width as usize;
        let rows = || self.rgba.chunks_exact(stride).zip(other.rgba.chunks_exact(stride));
        let top = rows().position(|(a, b)| a != b)?;
        let bottom = rows().rposition(|(a, b)| a != b)?;
        let (mut left, mut right) = (stride, 0);
        for (a, b) in rows().take(bottom + 1).skip(top).filter(|(a, b)| a != b) {
            let is_other = |(a, b): (&u8, &u8)| a != b;
            left = a.iter().zip(b).take(left).position(is_other).unwrap_or(left);
            right = a.iter().zip(b).skip(right).rposition(is_other).map_or(right, |at| right + at);
        }
        let (left, right) = (left / 4, right / 4);
        Some([left, top, right + 1 - left, bottom + 1 - top].map(|n| n as u32))
    }

    /// Hash of the visible content: tiles with different hashes differ in texels, and tiles with
    /// equal hashes are equal but for an accident. The hash is the same on every machine, and
    /// ignores the color of transparent texels, which programs change as they like.
    pub fn digest(&self) -> u64 {
        let seen: Vec<u8> = self
            .rgba
            .as_chunks::<4>()
            .0
            .iter()
            .flat_map(|texel| if texel[3] == 0 { [0; 4] } else { *texel })
            .collect();
        hash(&seen)
    }

    /// Texel at x and y, wrapped around the tile.
    pub fn texel(&self, x: i64, y: i64) -> [u8; 4] {
        let [width, height] = self.size.map(i64::from);
        let at = 4 * (y.rem_euclid(height) * width + x.rem_euclid(width)) as usize;
        [self.rgba[at], self.rgba[at + 1], self.rgba[at + 2], self.rgba[at + 3]]
    }
}

/// Hash that tells any two rows of texels apart that differ in one texel, and others but for an
/// accident. The hash is the same on every machine.
pub(super) fn hash(texels: &[u8]) -> u64 {
    let (texels, _) = texels.as_chunks::<4>();
    texels.iter().fold(0, |hash: u64, texel| {
        let word = u64::from(u32::from_le_bytes(*texel));
        (hash ^ word).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29)
    })
}

/// Angle of a sample's light or view direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Angle {
    /// Angle of the light from the normal.
    LightTheta,
    /// Angle of the light around the normal.
    LightPhi,
    /// Angle of the eye from the normal.
    ViewTheta,
    /// Angle of the eye around the normal.
    ViewPhi,
}

/// Hand-painted 6D texture.
#[derive(Clone, Debug, PartialEq)]
pub struct Hcbtf {
    /// Grid of the samples.
    pub grid: Grid,
    /// True if the tile repeats without a seam; painting then goes across its edges.
    pub is_tiling: bool,
    /// Painted samples, by canonical address; every tile has the grid's size.
    pub painted: BTreeMap<Address, Arc<Tile>>,
    /// Rules that fill the other samples.
    pub rules: Vec<Rule>,
    /// Fields of later versions or of other programs.
    pub unknown: UnknownFields,
}

impl Hcbtf {
    /// Greatest size of all painted samples, four bytes a texel, in bytes.
    pub const MAX_PAINTED_BYTES: u64 = 1 << 30;
    /// Greatest number of painted samples: a plain zip has no more entries.
    pub const MAX_PAINTED: usize = 65_000;
    /// Greatest number of rules.
    pub const MAX_RULES: usize = 1000;

    /// HCBTF without painted samples and rules.
    pub fn new(grid: Grid) -> Self {
        Self {
            grid,
            is_tiling: true,
            painted: BTreeMap::new(),
            rules: Vec::new(),
            unknown: UnknownFields::new(),
        }
    }

    /// Painted tile of a sample; `None` where the sample is not painted.
    pub fn painted(&self, address: Address) -> Option<&Arc<Tile>> {
        self.painted.get(&address.canonical())
    }
}

impl Serialize for Direction {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        [self.theta, self.phi].serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let [theta, phi] = <[u32; 2]>::deserialize(deserializer)?;
        Ok(Self { theta, phi })
    }
}

impl Serialize for Address {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        AddressFields { light: self.light, view: self.view }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Address {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let AddressFields { light, view } = AddressFields::deserialize(deserializer)?;
        Ok(Self { light, view }.canonical())
    }
}

/// Kind of a direction of the grid: ring and step, from 0.
const DIRECTION: FieldKind =
    FieldKind::Numbers(2, 2, NumberBounds::whole(0.0, (MAX_ANGLE_STEPS - 1) as f64));

described! {
    /// Sample of the grid: at the normal there is one, whatever the step.
    #[derive(Copy)]
    pub struct AddressFields("address", Inline) {
        /// Direction toward the light: ring and step, from 0.
        light: Direction, DIRECTION, required;
        /// Direction toward the eye: ring and step, from 0.
        view: Direction, DIRECTION, required;
    }
}

impl FieldType for Direction {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        let [theta, phi] = FieldType::read(r, at, kind, extras)?;
        Some(Self { theta, phi })
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        [self.theta, self.phi].write(w, unknown);
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

impl FieldType for Address {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        let AddressFields { light, view } = FieldType::read(r, at, kind, extras)?;
        Some(Self { light, view }.canonical())
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        AddressFields { light: self.light, view: self.view }.write(w, unknown);
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_is_the_least_rectangle_around_what_differs() {
        let before = Tile::filled([7, 5], [1, 2, 3, 255]);
        assert_eq!(before.difference(&before.clone()), None);
        assert_eq!(before.difference(&Tile::filled([5, 7], [1, 2, 3, 255])), Some([0, 0, 7, 5]));
        for (changed, wanted) in [
            (vec![[0, 0, 0]], [0, 0, 1, 1]),
            (vec![[6, 4, 3]], [6, 4, 1, 1]),
            (vec![[2, 3, 2], [4, 1, 1]], [2, 1, 3, 3]),
            (vec![[5, 1, 0], [3, 2, 3], [3, 4, 1]], [3, 1, 3, 4]),
            (vec![[0, 2, 3], [6, 2, 0]], [0, 2, 7, 1]),
        ] {
            let mut after = before.clone();
            for [x, y, channel] in &changed {
                after.bytes_mut()[4 * (y * 7 + x) + channel] = 9;
            }
            assert_eq!(after.difference(&before), Some(wanted), "{changed:?}");
            assert_eq!(before.difference(&after), Some(wanted), "{changed:?}");
        }
    }
}
