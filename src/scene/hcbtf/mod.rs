//! Hand-painted 6D textures (HCBTFs): how their files are read and written, how rules fill what is
//! not painted, and how all of it becomes the texture that shaders look up.
//!
//! [`load`] and [`read`] take an `.hcbtf` file, [`write()`] gives its bytes. [`fill`](fill::fill)
//! runs the rules and gives a [`FilledSamples`]: a tile and its [`Provenance`] for every sample of the
//! grid, which is what shaders look up. [`sheet`], [`folder`] and [`contact`] exchange samples with
//! other programs: the thesis's flattened texture, a folder of images, and one picture with all
//! samples side by side; [`exchange`] has all of them by one name each. docs/format.md documents
//! all of them. [`paint`] is the brush. [`stored`] lays the filled tiles out as the texture of a
//! shader, [`needs`] tells beforehand what that takes, and [`ktx2`] writes it as a file for other
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

pub use blocks::{Coding, Loss, loss};
pub use cover::{Cover, cover};
pub use file::{load, read, read_bytes, write};
pub use fill::{
    Estimate, FilledSamples, NotFilled, Provenance, SampleChoice, estimate, filled_at_most,
};
pub use layers::{
    LayerOptions, Layers, MAX_LAYERS_BYTES, check_layers, from_layers, layers, layers_bytes,
    layers_size, stored, stored_size,
};
pub use manifest::read_rules;
pub use memory::{Device, Limits, Need, needs, needs_at_most};
pub use picture::Picture;
pub use repaint::{Region, repaint};
pub use synthesize::{Synthesis, synthesize, synthesize_filled};

/// The version of `.hcbtf` files that this Chiaro writes, and the newest that it reads.
pub const VERSION: u32 = 1;
/// Files longer than this are refused.
pub const MAX_FILE_BYTES: u64 = 1 << 30;
/// Painted samples that take more than this, four bytes a texel, are refused; so are larger sheets.
pub const MAX_PAINTED_BYTES: u64 = Hcbtf::MAX_PAINTED_BYTES;
/// More painted samples than this are refused in one file: a plain zip has no more entries.
pub const MAX_PAINTED: usize = Hcbtf::MAX_PAINTED;
/// More rules than this are refused in one file.
pub const MAX_RULES: usize = Hcbtf::MAX_RULES;

/// Whether a file can hold every sample of a grid as painted.
///
/// # Errors
/// `too-large`, with what to take less of.
pub fn check_all_painted(grid: &Grid) -> Result<(), Diagnostic> {
    check_painted(grid, grid.sample_count())
}

/// Whether a file can hold so many painted samples.
fn check_painted(grid: &Grid, count: u64) -> Result<(), Diagnostic> {
    if count <= MAX_PAINTED as u64
        && count.saturating_mul(grid.texels() as u64 * 4) <= MAX_PAINTED_BYTES
    {
        return Ok(());
    }
    let message = format!(
        "{count} painted samples of {} x {} texels are too much",
        grid.size[0], grid.size[1]
    );
    let hint = format!(
        "a file holds {MAX_PAINTED} of them, and {} MiB: take a smaller tile or a coarser grid",
        MAX_PAINTED_BYTES >> 20
    );
    Err(Diagnostic::error("too-large", message).hint(hint))
}
