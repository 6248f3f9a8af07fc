//! Parameters of a relief of the tile.

mod light;
mod pattern;
mod presets;

use chiaro_locale::tr;
pub use light::{Finish, Glint, Illumination};
pub use pattern::{Channel, Pattern};
pub use presets::{PRESETS, Preset};

use super::{Address, BYTES, Grid, SEED, amount};
use crate::document::described::DescribedObject as _;
use crate::document::described::described;
use crate::document::read::check_value;
use crate::document::shape::FieldKind;

described! {
    /// Parameters of a generated relief of the tile: a height field with colors, as it is seen and
    /// lit from every direction. Lengths are in parts of the tile's width, texels being square;
    /// angles in radians; colors straight bytes as they are seen.
    #[serde(default)]
    pub struct Relief("relief", Inline) {
        /// Seed of the random scatter.
        seed: u32 = 1, SEED, always;
        /// Pattern of the relief.
        pattern: Pattern = Pattern::default(), FieldKind::Choice(Pattern::choice), always;
        /// Depth from the lowest place to the highest, in tile widths.
        depth: f64 = 0.05, amount(1.0), always;
        /// Height that stays in place when the eye moves: 0 the lowest, 1 the highest.
        pivot: f64 = 1.0, amount(1.0), always;
        /// Sun and sky.
        light: Illumination = Illumination::default(),
            FieldKind::Object(Illumination::shape), always;
        /// Specular reflection of the sun.
        glint: Glint = Glint::default(), FieldKind::Object(Glint::shape), always;
        /// Style of drawing.
        finish: Finish = Finish::default(), FieldKind::Object(Finish::shape), always;
    }
}

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

    /// Checks the relief: each number by its bounds, and that the grid is not too fine.
    ///
    /// # Errors
    /// The name of an invalid number and its bounds, or that the grid is too fine for a relief.
    pub fn check(&self, grid: &Grid) -> Result<(), String> {
        check_value(self, &FieldKind::Object(Self::shape))?;
        self.check_whole(grid)
    }

    /// Checks what the bounds of single numbers do not tell.
    pub(super) fn check_whole(&self, grid: &Grid) -> Result<(), String> {
        if let Some(address) = self.painted().find(|address| !grid.contains(*address)) {
            return Err(tr!("the pattern names {address}, which is outside the grid"));
        }
        let [width, height] = grid.size;
        if grid.texels() > Self::MAX_TEXELS {
            return Err(tr!(
                "a relief has at most 512 x 512 texels; the grid's tiles have {width} x {height}"
            ));
        }
        let directions = grid.view.distinct_count() + grid.light.distinct_count();
        let bytes = grid.texels() as u64 * directions * Self::BYTES_PER_TEXEL;
        if bytes > Self::MAX_BYTES {
            let (mib, most) = (bytes >> 20, Self::MAX_BYTES >> 20);
            return Err(tr!("drawing the relief would take {mib} MiB; at most {most} MiB can be"));
        }
        Ok(())
    }
}
