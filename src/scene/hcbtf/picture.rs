//! Pictures, and their conversion from and to PNG files.

use std::io::Cursor;

use chiaro_locale::tr;
use image::codecs::png::{CompressionType, FilterType, PngDecoder, PngEncoder};
use image::{
    ColorType, DynamicImage, ExtendedColorType, ImageDecoder as _, ImageEncoder as _, Limits,
};

use super::MAX_PAINTED_BYTES;
use crate::diag::Diagnostic;
use crate::document::Tile;

/// Greatest size of profiles and notes that a PNG may hold beside its texels, in bytes; painting
/// programs leave such data in it.
pub(super) const MAX_PNG_EXTRAS: u64 = 16 << 20;
/// Beginning of a PNG: its signature, then the length and the name of its first chunk.
const PNG_START: &[u8; 16] = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR";

/// A picture: straight RGBA, 8 bits a channel, rows from the top.
#[derive(Clone, PartialEq, Eq)]
pub struct BytePicture {
    /// Width and height in texels.
    pub size: [u32; 2],
    /// Texels, four bytes each.
    pub rgba: Vec<u8>,
}

impl std::fmt::Debug for BytePicture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Picture({} x {})", self.size[0], self.size[1])
    }
}

/// A decoded picture; `had_16_bits` is true if its file held more than 8 bits a channel.
#[derive(Debug)]
pub(super) struct DecodedPicture {
    pub(super) picture: BytePicture,
    pub(super) had_16_bits: bool,
}

impl BytePicture {
    /// A transparent picture.
    ///
    /// # Errors
    /// Where the picture would take more than [`MAX_PAINTED_BYTES`]; the message gives the size.
    pub(super) fn transparent(size: [u32; 2], what: &str) -> Result<Self, Box<Diagnostic>> {
        let bytes = u64::from(size[0]) * u64::from(size[1]) * 4;
        if bytes > MAX_PAINTED_BYTES {
            let [width, height] = size;
            let message = tr!(
                "the {what} would have {width} x {height} texels, which take {mib} MiB",
                mib = bytes >> 20
            );
            let hint = tr!(
                "at most {most} MiB can be written; take a coarser grid",
                most = MAX_PAINTED_BYTES >> 20
            );
            return Err(Box::new(Diagnostic::error("too-large", message).hint(hint)));
        }
        Ok(Self { size, rgba: vec![0; bytes as usize] })
    }

    /// The picture as PNG: RGBA, 8 bits a channel. Equal pictures give equal bytes.
    ///
    /// # Errors
    /// The reason why the picture cannot be encoded; only a picture without texels cannot.
    pub fn to_png(&self) -> Result<Vec<u8>, Box<Diagnostic>> {
        encode(self.size, &self.rgba).map_err(|why| {
            Box::new(Diagnostic::error("cannot-write", tr!("the picture cannot be encoded: {why}")))
        })
    }

    /// The four bytes of a texel.
    pub(super) fn texel(&self, x: usize, y: usize) -> [u8; 4] {
        let at = 4 * (y * self.size[0] as usize + x);
        self.rgba.get(at..at + 4).and_then(|bytes| bytes.try_into().ok()).unwrap_or_default()
    }

    /// The tile of a size at a place of the picture.
    pub(super) fn cut(&self, [left, top]: [usize; 2], size: [u32; 2]) -> Option<Tile> {
        let (width, stride) = (4 * size[0] as usize, 4 * self.size[0] as usize);
        let mut rgba = Vec::with_capacity(width * size[1] as usize);
        for y in top..top + size[1] as usize {
            let start = y * stride + 4 * left;
            rgba.extend_from_slice(self.rgba.get(start..start + width)?);
        }
        Tile::new(size, rgba)
    }

    /// Writes a tile into the picture at a place.
    pub(super) fn paste(&mut self, [left, top]: [usize; 2], tile: &Tile) {
        let (width, stride) = (4 * tile.size()[0] as usize, 4 * self.size[0] as usize);
        for (y, row) in tile.bytes().chunks_exact(width).enumerate() {
            let start = (top + y) * stride + 4 * left;
            if let Some(place) = self.rgba.get_mut(start..start + width) {
                place.copy_from_slice(row);
            }
        }
    }
}

/// Decodes a PNG of any color type. `accept` is asked about its size before memory is allocated.
pub(super) fn decode(
    png: &[u8],
    accept: impl FnOnce([u32; 2]) -> Result<(), String>,
) -> Result<DecodedPicture, String> {
    let header = png.strip_prefix(PNG_START).and_then(|rest| rest.first_chunk::<8>());
    let [a, b, c, d, e, f, g, h] = *header.ok_or_else(|| tr!("it is no PNG"))?;
    let size = [u32::from_be_bytes([a, b, c, d]), u32::from_be_bytes([e, f, g, h])];
    accept(size)?;
    let texels = u64::from(size[0]) * u64::from(size[1]);
    let mut limits = Limits::default();
    (limits.max_image_width, limits.max_image_height) = (Some(size[0]), Some(size[1]));
    limits.max_alloc = Some(texels.saturating_mul(8).saturating_add(MAX_PNG_EXTRAS));
    let broken = |error: image::ImageError| tr!("it cannot be decoded: {error}");
    let decoder = PngDecoder::with_limits(Cursor::new(png), limits).map_err(broken)?;
    let kind = decoder.color_type();
    let had_16_bits =
        matches!(kind, ColorType::L16 | ColorType::La16 | ColorType::Rgb16 | ColorType::Rgba16);
    let rgba = DynamicImage::from_decoder(decoder).map_err(broken)?.into_rgba8();
    Ok(DecodedPicture {
        picture: BytePicture { size: [rgba.width(), rgba.height()], rgba: rgba.into_raw() },
        had_16_bits,
    })
}

/// The PNG of some texels: RGBA, 8 bits a channel.
pub(super) fn encode(size: [u32; 2], rgba: &[u8]) -> Result<Vec<u8>, String> {
    let mut png = Vec::new();
    PngEncoder::new_with_quality(&mut png, CompressionType::Default, FilterType::Adaptive)
        .write_image(rgba, size[0], size[1], ExtendedColorType::Rgba8)
        .map_err(|error| error.to_string())?;
    Ok(png)
}

/// The warning for a picture of 16 bits a channel.
pub(super) fn reduced(what: &str) -> Diagnostic {
    let message = tr!("{what} has 16 bits a channel; samples keep 8");
    Diagnostic::warning("hcbtf-16-bit", message)
        .hint(tr!("export it with 8 bits a channel to choose the rounding yourself"))
}

#[cfg(test)]
mod tests {
    use image::{ImageBuffer, Luma, Rgb};

    use super::*;

    fn png(image: impl Into<DynamicImage>) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        image.into().write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn every_kind_of_png_becomes_straight_rgba8() {
        let gray = decode(&png(ImageBuffer::from_pixel(2, 1, Luma([7_u8]))), |_| Ok(())).unwrap();
        assert_eq!(
            gray.picture,
            BytePicture { size: [2, 1], rgba: vec![7, 7, 7, 255, 7, 7, 7, 255] }
        );
        let deep =
            decode(&png(ImageBuffer::from_pixel(1, 1, Rgb([0_u16, 65_535, 257 * 9]))), |_| Ok(()))
                .unwrap();
        assert!(deep.had_16_bits && deep.picture.rgba == [0, 255, 9, 255]);
        let own = BytePicture { size: [1, 2], rgba: vec![1, 2, 3, 0, 255, 0, 9, 128] };
        let back = decode(&own.to_png().unwrap(), |_| Ok(())).unwrap();
        assert_eq!(back.picture, own, "colors under alpha 0 stay");
    }

    #[test]
    fn a_picture_is_refused_by_its_header_before_it_is_decoded() {
        let mut bytes = png(ImageBuffer::from_pixel(1, 1, Luma([7_u8])));
        bytes[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
        let refuse = |size: [u32; 2]| Err(format!("{size:?}"));
        assert_eq!(decode(&bytes, refuse).unwrap_err(), "[2147483647, 2147483647]");
        assert!(decode(b"JFIF", |_| Ok(())).unwrap_err().contains("no PNG"));
        assert!(decode(&bytes[..20], |_| Ok(())).is_err());
    }
}
