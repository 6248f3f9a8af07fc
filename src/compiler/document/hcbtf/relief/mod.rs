//! Parameters of a relief of the tile.

mod light;
mod pattern;
mod presets;

use serde::{Deserialize, Serialize};

pub use light::{Finish, Glint, Illumination};
pub use pattern::{Channel, Pattern};
pub use presets::{PRESETS, Preset};

use super::{Address, Grid};

/// Parameters of a generated relief of the tile: a height field with colors, as it is seen and lit
/// from every direction. Lengths are in parts of the tile's width, texels being square; angles in
/// radians; colors straight bytes as they are seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Relief {
    /// Seed of the random scatter.
    pub seed: u32,
    /// Pattern of the relief.
    pub pattern: Pattern,
    /// Depth from the lowest place to the highest, in tile widths.
    pub depth: f64,
    /// Height that stays in place when the eye moves: 0 the lowest, 1 the highest.
    pub pivot: f64,
    /// Sun and sky.
    pub light: Illumination,
    /// Specular reflection of the sun.
    pub glint: Glint,
    /// Style of drawing.
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

/// Bounded number: its name, its value, and its least and greatest value.
type BoundedNumber = (&'static str, f64, f64, f64);

impl Relief {
    /// Greatest number of texels of a tile that can have a relief.
    pub const MAX_TEXELS: usize = 512 * 512;
    /// Greatest memory of the relief's views and lights while it is drawn, in bytes.
    pub const MAX_BYTES: u64 = 2 << 30;
    /// Memory of a texel for each view or light, in bytes.
    const BYTES_PER_TEXEL: u64 = 20;

    /// Painted samples that the relief needs.
    pub fn painted(&self) -> impl Iterator<Item = Address> {
        let needed = match self.pattern {
            Pattern::Painted { heights, colors, .. } => vec![heights, colors],
            _ => Vec::new(),
        };
        needed.into_iter()
    }

    /// Checks the numbers of the relief.
    ///
    /// # Errors
    /// The name of an invalid number and its bounds, or that the grid is too fine for a relief.
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
