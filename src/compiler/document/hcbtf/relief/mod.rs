//! The parameters of a relief of the tile.

mod light;
mod pattern;
mod presets;

use serde::{Deserialize, Serialize};

pub use light::{Finish, Glint, Illumination};
pub use pattern::{Channel, Pattern};
pub use presets::{PRESETS, Preset};

use super::{Address, Grid};

/// What a generator is told of a relief of the tile: a height field with colors, as it is seen and
/// lit from every direction. Lengths are in parts of the tile's width, texels being square; angles
/// in radians; colors straight bytes as they are seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Relief {
    /// Another number scatters anew.
    pub seed: u32,
    /// What it is a relief of.
    pub pattern: Pattern,
    /// From the lowest place to the highest, in tile widths.
    pub depth: f64,
    /// The height that stays where it is when the eye moves: 0 the lowest, 1 the highest.
    pub pivot: f64,
    /// What lights it.
    pub light: Illumination,
    /// What shines.
    pub glint: Glint,
    /// How it is drawn.
    pub finish: Finish,
}

impl Default for Relief {
    fn default() -> Self {
        Self {
            seed: 1,
            pattern: Pattern::default(),
            depth: 0.05,
            pivot: 1.0,
            light: Illumination::default(),
            glint: Glint::default(),
            finish: Finish::default(),
        }
    }
}

/// A number, its name, and from where to where it may be.
type Bounded = (&'static str, f64, f64, f64);

impl Relief {
    /// The most texels of a tile that can have a relief.
    pub const MAX_TEXELS: usize = 512 * 512;
    /// The most memory that its views and lights may take while it is drawn, in bytes.
    pub const MAX_BYTES: u64 = 2 << 30;
    /// What a texel takes for each view or light, in bytes.
    const BYTES_PER_TEXEL: u64 = 20;

    /// The painted samples that it needs.
    pub fn painted(&self) -> impl Iterator<Item = Address> {
        let needed = match self.pattern {
            Pattern::Painted { heights, colors, .. } => vec![heights, colors],
            _ => Vec::new(),
        };
        needed.into_iter()
    }

    /// What is wrong with its numbers.
    ///
    /// # Errors
    /// Which number, and what it may be; and where the grid is too fine for a relief.
    pub fn check(&self, grid: &Grid) -> Result<(), String> {
        let own = [("depth", self.depth, 0.0, 1.0), ("pivot", self.pivot, 0.0, 1.0)];
        let all = own.into_iter().chain(self.pattern.bounds()).chain(self.light.bounds());
        for (name, value, least, most) in all.chain(self.glint.bounds()).chain(self.finish.bounds())
        {
            if !(least..=most).contains(&value) {
                return Err(format!("`{name}` is {value}; it must be from {least} to {most}"));
            }
        }
        if let Some(address) = self.painted().find(|address| !grid.contains(*address)) {
            return Err(format!("the pattern names {address}, which is outside the grid"));
        }
        let [width, height] = grid.size;
        if grid.texels() > Self::MAX_TEXELS {
            return Err(format!(
                "a relief has at most 512 x 512 texels; the grid's tiles have {width} x {height}"
            ));
        }
        let directions = grid.view.distinct_count() + grid.light.distinct_count();
        let bytes = grid.texels() as u64 * directions * Self::BYTES_PER_TEXEL;
        if bytes > Self::MAX_BYTES {
            let (mib, most) = (bytes >> 20, Self::MAX_BYTES >> 20);
            return Err(format!(
                "drawing the relief would take {mib} MiB; at most {most} MiB can be"
            ));
        }
        Ok(())
    }
}
