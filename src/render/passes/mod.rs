//! Encoding of passes for the GPU: meshes with the looks' modules, one triangle over the picture,
//! and the picture itself.

mod look;
mod meshes;
mod screen;

pub(crate) use look::cleared;
pub(crate) use screen::ScreenPipeline;
