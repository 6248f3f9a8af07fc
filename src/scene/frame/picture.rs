//! Pictures: the result of drawing, on any executor.

use chiaro_locale::tr;

use crate::diag::Diagnostic;

/// A finished picture: straight RGBA, display-referred, rows from the top.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Pixels, row by row.
    pub rgba: Vec<[f32; 4]>,
}

impl Picture {
    /// The pixels with eight bits a channel, rounded.
    pub fn to_rgba8(&self) -> Vec<u8> {
        let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
        self.rgba.iter().flat_map(|pixel| pixel.map(byte)).collect()
    }

    /// The picture as PNG: straight alpha, 8 bits a channel.
    ///
    /// # Errors
    /// `png`: the reason why the picture cannot be encoded.
    pub fn to_png(&self) -> Result<Vec<u8>, Diagnostic> {
        let mut bytes = Vec::new();
        let encoder = image::codecs::png::PngEncoder::new(&mut bytes);
        let [width, height] = self.size;
        let kind = image::ExtendedColorType::Rgba8;
        image::ImageEncoder::write_image(encoder, &self.to_rgba8(), width, height, kind).map_err(
            |error| Diagnostic::error("png", tr!("the picture cannot be encoded: {error}")),
        )?;
        Ok(bytes)
    }

    /// The pixel at a column and row.
    pub fn pixel(&self, x: u32, y: u32) -> [f32; 4] {
        self.rgba[(y * self.size[0] + x) as usize]
    }
}
