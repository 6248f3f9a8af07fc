//! The finished picture of the reference.

use super::raster::Raster;
use super::texels::{Coverage, Texels};
use crate::frame::Picture;
use crate::ids::ObjectId;

/// Picture of a frame plan, in f64, with the coverage of each pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReferencePicture {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Samples a pixel.
    pub samples: u32,
    /// Premultiplied RGBA, display-referred; four channels.
    pub color: Texels,
    /// Coverage of each pixel, rows from the top.
    pub coverage: Vec<Coverage>,
    /// Depth of the nearest sample of each pixel, 0 (near) to 1 (far), linear on the screen over
    /// each plane.
    pub depths: Vec<f64>,
    /// Object of each draw, by [`Coverage::draw`].
    pub objects: Vec<ObjectId>,
}

impl ReferencePicture {
    pub(super) fn new(raster: Raster, samples: u32, objects: Vec<ObjectId>) -> Self {
        let Raster { texels: color, coverage, depths } = raster;
        Self { size: color.size, samples, color, coverage, depths, objects }
    }

    /// Lays a premultiplied image of the same size over the picture.
    pub(super) fn lay_over(&mut self, image: &Texels) {
        let pixels = self.color.values.chunks_exact_mut(4).zip(image.values.chunks_exact(4));
        for (pixel, over) in pixels {
            let through = 1.0 - over[3];
            pixel.iter_mut().zip(over).for_each(|(below, above)| *below = above + through * *below);
        }
    }

    /// A pixel by column and row, straight RGBA; all channels are 0 where alpha is.
    ///
    /// # Panics
    /// Outside of the picture.
    pub fn straight(&self, x: u32, y: u32) -> [f64; 4] {
        straight(self.color.pixel(x, y))
    }

    /// The picture as the renderer returns it and picture files take it: straight, in f32.
    pub fn to_picture(&self) -> Picture {
        let rgba = self
            .color
            .values
            .chunks_exact(4)
            .map(|pixel| straight(pixel).map(|x| x as f32))
            .collect();
        Picture { size: self.size, rgba }
    }

    /// Coverage of a pixel.
    ///
    /// # Panics
    /// Outside of the picture.
    pub fn coverage(&self, x: u32, y: u32) -> Coverage {
        self.coverage[y as usize * self.size[0] as usize + x as usize]
    }

    /// The object that is on top in most samples of a pixel.
    pub fn object(&self, x: u32, y: u32) -> Option<&ObjectId> {
        self.objects.get(self.coverage(x, y).draw? as usize)
    }
}

fn straight(pixel: &[f64]) -> [f64; 4] {
    let alpha = pixel[3];
    let scale = if alpha > 0.0 { 1.0 / alpha } else { 0.0 };
    [pixel[0] * scale, pixel[1] * scale, pixel[2] * scale, alpha]
}
