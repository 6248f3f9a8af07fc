//! Execution of frame plans on the CPU in f64: the truth that the GPU is compared with.
//!
//! [`execute`] runs a plan's passes in order, as the renderer does: `geometry` has each vertex
//! shaded once, and sorts the triangles into tiles; on each tile, `clip` cuts a triangle at the
//! near and far planes, `setup` puts it on the screen's grid, `coverage` finds the samples that it
//! covers, and `interpolate` the values at its pixels; `batches` gathers their 2x2 quads and has
//! them shaded, and `tile` keeps depth and color of every sample. `fullscreen` shades all pixels of
//! an image.
//!
//! [`GatheredFragments`] keeps the fragments of chosen pixels, to shade them again with other
//! values of a look.
//!
//! The rasterizer knows no WGSL: shaders stand behind the traits [`Shader`] and [`ShaderFactory`].
//! Behind these traits, `modules` runs generated WGSL by the interpreter, in f64 or as f32 rounds.
//! Pictures of the GPU are compared with the reference's in `laboratory::accuracy::error`.
//!
//! # Agreement with a GPU, and differences
//! Clip space, viewport, culling, the top-left rule, sample positions, the depth test (less) and
//! blending are WebGPU's. Fragments are shaded once, at the pixel's middle, for all samples that
//! they cover; helpers of a quad lie on the triangle's plane. Positions, depths, varyings and
//! images are f64 and are never rounded, except for the grid ([`SnapGrid`]) that coverage alone is
//! decided on, and for images if [`ImageRounding`] asks for it. A fragment that its shader discards
//! leaves no depth; fragments that are hidden already are not shaded, which does not change the
//! picture, as depths only ever fall.
#![allow(
    clippy::result_large_err,
    reason = "diagnostics are large, and made only when all is lost"
)]

use chiaro_compiler::{document, library};
use chiaro_language::{diag, ids, interp, progress, wgsl};
use chiaro_scene::{frame, hcbtf, placing, threads};

mod batches;
mod clip;
mod coverage;
mod eval;
mod executor;
mod fullscreen;
mod gather;
mod geometry;
mod interpolate;
mod lighting;
mod modules;
mod options;
mod picture;
mod pool;
mod probe;
mod raster;
mod reference;
mod setup;
mod shader;
mod surface;
mod texels;
mod tile;
mod tiles;
mod uniform;

pub use eval::evaluate;
pub use executor::{PassImages, ShaderFactory, execute, execute_layered, execute_screens};
pub use fullscreen::shade_all;
pub use gather::{GatheredFragments, GatheredPixel, PixelSheet};
pub use geometry::Triangles;
pub use lighting::{LightAccount, LightReading, light_accounts};
pub use modules::Modules;
pub use options::{ImageRounding, ReferenceOptions, SnapGrid};
pub use picture::ReferencePicture;
pub use probe::{ProbedFragment, ProbedValue, WireValue, probe, probe_wires};
pub use raster::{MAX_SAMPLES, MAX_SIDE, Raster, rasterize};
pub use reference::Reference;
pub use setup::Sides;
pub use shader::{
    FragmentStage, LANES, QUADS, QuadBatch, Shader, ShaderOutputs, Varying, VaryingInterpolation,
    VertexStage,
};
pub use surface::{ProbedSurface, probe_surface, surface_look, surface_setup};
pub use texels::{Coverage, Texels};
pub use tile::PassTarget;
pub use tiles::{BakedLook, TILE_SAMPLES, bake_look, bake_look_sampled};
