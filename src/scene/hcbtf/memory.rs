//! Size of the texture of an HCBTF, before it is made, and the limits of devices.

use std::sync::Arc;

use chiaro_locale::tr;

use super::blocks::{self, TexelCoding};
use super::compact;
use super::fill::{MAX_FILLED_BYTES, MAX_SAMPLES, NotFilled, filled_at_most};
use super::layers::{MAX_LAYERS_BYTES, check_layers, layers_size, stored_size};
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Storage, Tile};

/// Limits of a device for textures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Greatest side, in texels.
    pub side: u64,
    /// Greatest number of layers of an array.
    pub layers: u64,
    /// True if the device supports textures of compressed blocks; elsewhere they are decoded.
    pub has_blocks: bool,
}

impl Limits {
    /// Limits of every device that WebGPU runs on.
    pub const GUARANTEED: Self = Self { side: 8192, layers: 256, has_blocks: false };
}

/// A device that textures are made for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Device {
    /// Name of the device.
    pub name: String,
    /// Limits of its textures.
    pub limits: Limits,
}

impl Device {
    /// The device of the limits that every device has, which stands in where there is none.
    pub fn guaranteed() -> Self {
        Self { name: tr!("what WebGPU guarantees").to_owned(), limits: Limits::GUARANTEED }
    }

    /// A phrase that tells whether the device can hold a texture, and whether every GPU can.
    pub fn word(&self, need: &Need) -> &'static str {
        match (need.fits(self.limits), need.fits(Limits::GUARANTEED)) {
            (true, true) => tr!("fits every GPU"),
            (true, false) => tr!("fits this one, not every GPU"),
            (false, _) => tr!("does not fit"),
        }
    }

    /// Checks that all samples of a grid can be filled, and be painted on with this device: an
    /// HCBTF that is painted has a layer for each view, quick and at least without smaller levels.
    ///
    /// # Errors
    /// The size that is too large, and the number to reduce.
    pub fn check_painted(&self, grid: &Grid) -> Result<(), Diagnostic> {
        grid.check().map_err(|why| Diagnostic::error("hcbtf-grid", why))?;
        let (samples, bytes) = (grid.sample_count(), filled_at_most(grid));
        if samples > MAX_SAMPLES {
            return Err(NotFilled::TooMany { samples }.into());
        }
        if bytes > MAX_FILLED_BYTES {
            return Err(NotFilled::TooLarge { bytes }.into());
        }
        check_layers(grid, false)?;
        let [width, height, layers] = layers_size(grid, false);
        let Limits { side, layers: most, .. } = self.limits;
        let wrong =
            |what: String| Diagnostic::error("too-large", format!("{what} ({})", self.name));
        if width.max(height) > side {
            let what = tr!(
                "its texture would have {width} x {height} texels; the device takes {side} along a \
                 side"
            );
            return Err(wrong(what).hint(tr!("take fewer texels, or fewer lights")));
        }
        if layers > most {
            let views = grid.view.count();
            let what = tr!(
                "its texture would have {layers} layers for {views} views; the device takes {most}"
            );
            return Err(wrong(what).hint(tr!(
                "take fewer views: rings times steps may be {most_views}",
                most_views = most.max(1) - 1
            )));
        }
        Ok(())
    }
}

/// Size that one storage takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Need {
    /// The storage.
    pub storage: Storage,
    /// True if the texture has smaller levels of the tile, as smooth lookups read them.
    pub has_levels: bool,
    /// Width and height of a layer in texels, and the number of layers.
    pub size: [u64; 3],
}

impl Need {
    /// The size in bytes, on a device that supports the storage's coding.
    pub fn bytes(&self) -> u64 {
        let coding =
            if self.storage == Storage::Blocks { TexelCoding::Bc7 } else { TexelCoding::Rgba8 };
        coding.bytes(self.texels())
    }

    /// The size in bytes on a device of these limits.
    pub fn bytes_on(&self, limits: Limits) -> u64 {
        if limits.has_blocks { self.bytes() } else { TexelCoding::Rgba8.bytes(self.texels()) }
    }

    fn texels(&self) -> u64 {
        self.size.into_iter().fold(1, u64::saturating_mul)
    }

    /// True if a device of these limits can hold the texture, and Chiaro makes one so large.
    pub fn fits(&self, limits: Limits) -> bool {
        let [width, height, layers] = self.size;
        let bytes = TexelCoding::Rgba8.bytes(self.texels());
        width.max(height) <= limits.side && layers <= limits.layers && bytes <= MAX_LAYERS_BYTES
    }
}

/// The size of each storage, with and without smaller levels, for these tiles.
pub fn needs<'a>(grid: &Grid, tile: impl Fn(Address) -> Option<&'a Arc<Tile>>) -> Vec<Need> {
    each(|storage, has_levels| stored_size(grid, &tile, has_levels, storage))
}

/// The greatest size of each storage, whatever is painted: no two tiles alike, and each of many
/// colors.
pub fn needs_at_most(grid: &Grid) -> Vec<Need> {
    each(|storage, has_levels| match storage {
        Storage::Quick => layers_size(grid, has_levels),
        Storage::Compact => compact::most(grid, has_levels),
        Storage::Blocks => blocks::most(grid, has_levels),
    })
}

fn each(size: impl Fn(Storage, bool) -> [u64; 3]) -> Vec<Need> {
    let all = Storage::ALL
        .into_iter()
        .flat_map(|storage| [false, true].map(|has_levels| (storage, has_levels)));
    all.map(|(storage, has_levels)| Need { storage, has_levels, size: size(storage, has_levels) })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Directions;

    #[test]
    fn what_a_device_cannot_hold_is_told_with_what_to_take_less_of() {
        let directions = |theta, phi| Directions { theta, phi };
        let grid = |side, light, view| Grid { size: [side, side], light, view };
        let few = directions(3, 6);
        let device = Device::guaranteed();
        assert_eq!(device.check_painted(&Grid::THESIS), Ok(()));
        let why = |grid: Grid| device.check_painted(&grid).unwrap_err();
        // 17 x 15 views and the layer of the header are exactly what every device has.
        assert_eq!(device.check_painted(&grid(8, few, directions(17, 15))), Ok(()));
        let views = why(grid(8, few, directions(16, 16)));
        assert!(views.message.contains("257 layers for 256 views"), "{}", views.message);
        assert_eq!(views.hints, ["take fewer views: rings times steps may be 255"]);
        // A texel is a block of 6 x 12 lights: 8,192 / 12 texels fit along the side.
        let lights = directions(6, 10);
        assert_eq!(device.check_painted(&grid(682, lights, directions(1, 1))), Ok(()));
        let wide = why(grid(683, lights, directions(1, 1)));
        assert!(
            wide.message.contains("4098 x 8196 texels")
                && wide.hints == ["take fewer texels, or fewer lights"]
        );
        for too_much in [
            grid(4095, few, few),
            grid(1, directions(255, 255), directions(6, 10)),
            grid(0, few, few),
        ] {
            assert!(!why(too_much).message.is_empty());
        }
    }
}
