//! Hand-painted 6D textures (HCBTFs): reading and writing of their files, the rules that fill
//! samples that are not painted, and the texture that shaders look up.
//!
//! [`load`] and [`read`] take an `.hcbtf` file, [`write()`] gives its bytes. [`fill`](fill::fill)
//! runs the rules and gives a [`FilledSamples`]: a tile and its [`Provenance`] for every sample of
//! the grid, which is what shaders look up. [`sheet`], [`folder`] and [`contact`] exchange samples
//! with other programs: the thesis's flattened texture, a folder of images, and one picture with
//! all samples side by side; [`exchange`] covers all of these forms. docs/format.md documents them.
//! [`paint`] is the brush. [`stored`] lays the filled tiles out as the texture of a shader,
//! [`needs`] computes the size beforehand, and [`ktx2`] writes the texture as a file for other
//! engines.
//!
//! Files are not trusted: sizes are bounded before memory is taken for them ([`MAX_FILE_BYTES`],
//! [`MAX_PAINTED_BYTES`], [`MAX_PAINTED`]), and every problem is a diagnostic that names the file.

mod archive;
mod blocks;
mod compact;
pub mod contact;
mod cover;
pub mod exchange;
mod file;
pub mod fill;
pub mod folder;
mod generate;
pub mod ktx2;
mod layers;
mod levels;
mod listing;
mod manifest;
mod memory;
mod noise;
pub mod paint;
mod picture;
mod repaint;
mod report;
mod share;
pub mod sheet;
mod synthesize;

use crate::diag::Diagnostic;
use crate::document::{Grid, Hcbtf};

pub use blocks::{Loss, TexelCoding, loss};
use chiaro_locale::tr;
pub use cover::{Cover, cover};
pub use file::{load, read, read_bytes, write};
pub use fill::{
    FillEstimate, FilledSamples, NotFilled, Provenance, SampleChoice, estimate, filled_at_most,
};
pub use layers::{
    LayerOptions, LayeredTexture, MAX_LAYERS_BYTES, check_layers, from_layers, layers,
    layers_bytes, layers_size, stored, stored_size,
};
pub use memory::{Device, Limits, Need, needs, needs_at_most};
pub use picture::BytePicture;
pub use repaint::{Region, repaint};
pub use synthesize::{Synthesis, synthesize, synthesize_filled};

/// Version of `.hcbtf` files that this Chiaro writes, and the newest that it reads.
pub const VERSION: u32 = 1;
/// Greatest length of a file that is read, in bytes.
pub const MAX_FILE_BYTES: u64 = 1 << 30;
/// Greatest size of painted samples, four bytes a texel, and of sheets, in bytes.
pub const MAX_PAINTED_BYTES: u64 = Hcbtf::MAX_PAINTED_BYTES;
/// Greatest number of painted samples in one file: a plain zip has no more entries.
pub const MAX_PAINTED: usize = Hcbtf::MAX_PAINTED;
/// Greatest number of rules in one file.
pub const MAX_RULES: usize = Hcbtf::MAX_RULES;

/// Checks that a file can hold every sample of a grid as painted.
///
/// # Errors
/// `too-large`, with the numbers to reduce.
pub fn check_all_painted(grid: &Grid) -> Result<(), Diagnostic> {
    check_painted(grid, grid.sample_count())
}

/// Checks that a file can hold that many painted samples.
fn check_painted(grid: &Grid, count: u64) -> Result<(), Diagnostic> {
    if count <= MAX_PAINTED as u64
        && count.saturating_mul(grid.texels() as u64 * 4) <= MAX_PAINTED_BYTES
    {
        return Ok(());
    }
    let message = tr!(
        "{count} painted samples of {width} x {height} texels are too much",
        width = grid.size[0],
        height = grid.size[1]
    );
    let hint = tr!(
        "a file holds {MAX_PAINTED} of them, and {most} MiB: take a smaller tile or a coarser grid",
        most = MAX_PAINTED_BYTES >> 20
    );
    Err(Diagnostic::error("too-large", message).hint(hint))
}
