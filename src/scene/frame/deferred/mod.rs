//! Looks drawn deferred: over the picture, at each pixel once, in place of triangle by triangle.
//!
//! Where triangles are a few pixels large, a rasterizer shades mostly quads of 2x2 pixels that a
//! triangle fills in part: the creature of the examples has its look shaded 2.4 times as often as
//! it has pixels. A plan that draws a surface before the look (slopes, depth and object, for
//! curvature) may have the triangle at each pixel beside it, and draw the look as a pass over the
//! picture, which reads the triangle's corners and shades the place in between.
//!
//! The picture stays what it was, to rounding: a look's derivatives are taken on the
//! triangle that the pixel shows. So every tier is drawn so wherever it is quicker, and the
//! reference, which counts no time, draws triangles.
//!
//! - `derivatives`: where a module asks for them, and how it notes its neighbors' values.
//! - `module`: the modules that are drawn over the picture, from the looks' own.
//! - `mesh`: the order of vertices by which triangles are told.

mod derivatives;
mod mesh;
mod module;

use std::sync::Arc;

use chiaro_locale::tr;
pub use mesh::NumberedMesh;
pub use module::{DeferredModule, MESH_TEXELS_PER_ROW};

use super::cost::shader_operations;
use super::coverage::PixelArea;
use crate::compile::CompiledShader;
use crate::library::PassId;

/// Operations that deferred drawing saves over triangles, for a look of so many `operations` whose
/// object has so many `triangles`, front and back, and is seen in so many `pixels`. Less than 0
/// where it takes longer.
///
/// Measured on software Vulkan with looks of 200 to 600 operations, in pictures of 400x300 to
/// 3200x2400 pixels. Of the share of quads that triangles leave empty the rasterizer shades
/// 3 / sqrt(p) times as much again, for p pixels a triangle; it sets up each triangle, sooner than
/// deferred drawing tells it. Deferred drawing reads three vertices at a pixel, and runs at the
/// neighbors what derivatives ask for.
pub(super) fn saved_operations(operations: u64, pixels: f64, triangles: f64) -> f64 {
    const QUADS: f64 = 3.0;
    const NEIGHBORS: f64 = 0.25;
    const TRIANGLE: f64 = 1700.0;
    const PIXEL: f64 = 420.0;
    let shaded_again = QUADS * (triangles / pixels.max(1.0)).sqrt();
    pixels * (operations as f64 * (shaded_again - NEIGHBORS) - PIXEL) + triangles * TRIANGLE
}

/// Modules of a look that is drawn deferred.
#[derive(Debug)]
pub struct DeferredLook {
    /// Module that draws the look.
    pub look: DeferredModule,
    /// Operations of the look's own module at each fragment.
    pub operations: u64,
    /// Source of the module that draws the surface and the numbers of triangles, with the bindings
    /// of the surface's own module.
    pub surface: String,
}

impl DeferredLook {
    /// The modules for a look and its surface.
    ///
    /// # Errors
    /// The reason why the look cannot be drawn so.
    pub fn new(look: &CompiledShader, surface: &CompiledShader) -> Result<Self, &'static str> {
        if !look.is_opaque {
            return Err(tr!("it may be transparent, and shows what lies behind"));
        }
        Ok(Self {
            look: DeferredModule::new(look)?,
            operations: shader_operations(look).0,
            surface: module::numbered_surface(surface)?,
        })
    }
}

/// Deferred drawing of a plan's looks.
#[derive(Clone, Debug)]
pub struct Deferral {
    /// Pass beside whose surface the numbers of triangles are drawn.
    pub surface: PassId,
    /// Draws in the order of the plan's.
    pub draws: Vec<DeferredDraw>,
}

/// Deferred drawing of one draw.
#[derive(Clone, Debug)]
pub struct DeferredDraw {
    /// Module that the deferred one was made from: a plan whose draws have others is drawn triangle
    /// by triangle.
    pub shader: Arc<CompiledShader>,
    /// Modules of the draw's look.
    pub look: Arc<DeferredLook>,
    /// Pixels in which the draw's object may be seen.
    pub area: PixelArea,
    /// Number of the mesh's first triangle: triangles are counted over all draws from 1, each with
    /// all triangles of its mesh.
    pub first: u32,
    /// Triangles of the mesh that are drawn, from the mesh's first one on.
    pub triangles: std::ops::Range<u32>,
    /// True if back faces are drawn, too.
    pub two_sided: bool,
    /// True if the object is mirrored, so that its front faces run clockwise.
    pub is_mirrored: bool,
}

impl DeferredDraw {
    /// Numbers that the look's module reads: the number of the mesh's first triangle, how many
    /// triangles the mesh has up to the last that is drawn, and the sides. The fourth is unused.
    pub fn numbers(&self) -> [u32; 4] {
        let sides = u32::from(self.two_sided) | u32::from(self.is_mirrored) << 1;
        [self.first, self.triangles.end, sides, 0]
    }
}

#[cfg(test)]
mod tests {
    use super::saved_operations;

    #[test]
    fn small_triangles_and_long_looks_are_drawn_deferred() {
        // The creature of the examples at 1600x1200 and at 3200x2400 pixels, with the looks of
        // figures 1 and 4.
        let saved = |operations, pixels| saved_operations(operations, pixels, 83_216.0);
        assert!(saved(599, 388_000.0) > 2.0 * saved(204, 388_000.0));
        assert!(saved(204, 388_000.0) > 0.0 && saved(204, 1_550_000.0) < 0.0);
        assert!(saved_operations(599, 388_000.0, 4.0) < 0.0, "a cube");
        assert!(saved(599, 0.0) > 0.0);
    }
}
