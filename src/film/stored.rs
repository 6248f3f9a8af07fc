//! Frames as files: read back, known to be whole, and compared.

use std::io::Cursor;

use chiaro_locale::{tr, trn};

use crate::diag::Diagnostic;
use crate::document::{linear_to_srgb, srgb_to_linear};
use crate::exr;
use crate::files::{OutputKind, png};
use crate::frame::Picture;

/// Keyword of the note in a PNG that names the plan that was drawn.
pub const PLAN_NOTE: &str = "Chiaro plan";

/// Number of bytes that a PNG may unfold to.
const MAX_PNG_BYTES: usize = 1 << 32;

/// Numbers of red, green and blue, and of alpha where there is some.
type ColorNumbers<'a> = ([&'a [f32]; 3], Option<&'a [f32]>);

/// A frame as its file has it.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredFrame {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Names of the channels in the order of the alphabet, each with its numbers, row by row from
    /// the top: premultiplied light of an EXR, straight numbers as shown of a PNG.
    pub channels: Vec<(String, Vec<f32>)>,
    /// Hash of the plan that was drawn, and how it was stored.
    pub plan: Option<String>,
    /// True if the numbers are those that Chiaro wrote.
    pub is_sealed: bool,
    /// True of an EXR.
    is_light: bool,
}

/// Most layers that a sentence names.
const MOST_NAMED: usize = 4;

/// Difference of two frames of one size, in the channels that both have.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameDifference {
    /// The greatest difference of two numbers; infinite beside a number that is none.
    pub greatest: f64,
    /// Channel that has it.
    pub channel: String,
    /// Pixel that has it: column and row.
    pub pixel: [u32; 2],
    /// Number of pixels of which any channel differs.
    pub pixels: usize,
}

impl StoredFrame {
    /// Reads a PNG or an EXR.
    ///
    /// # Errors
    /// `exr` or `png` with the reason, for bytes that are no whole file.
    pub fn read(bytes: &[u8]) -> Result<Self, Diagnostic> {
        if bytes.starts_with(b"\x89PNG") {
            return read_png(bytes);
        }
        let exr::ExrContent { size, channels, plan, is_sealed, .. } = exr::decode(bytes)?;
        Ok(Self { size, channels, plan, is_sealed, is_light: true })
    }

    /// True if the numbers are light, and not what is shown.
    pub fn is_light(&self) -> bool {
        self.is_light
    }

    /// The names of the channels.
    pub fn names(&self) -> Vec<&str> {
        self.channels.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// The frame without its numbers: its size and the names of its channels.
    #[must_use]
    pub fn without_numbers(&self) -> Self {
        let channels = self.channels.iter().map(|(name, _)| (name.clone(), Vec::new())).collect();
        let Self { size, is_sealed, is_light, .. } = *self;
        Self { size, channels, plan: self.plan.clone(), is_sealed, is_light }
    }

    /// Layers that the other frame does not have, as a list for people with the number of their
    /// channels; `None` where it has all channels.
    pub fn layers_beyond(&self, other: &Self) -> Option<String> {
        let mut beyond = self.names();
        beyond.retain(|name| other.numbers(name).is_none());
        let layers = beyond.iter().map(|name| name.rsplit_once('.').map_or(*name, |(of, _)| of));
        let mut layers: Vec<&str> = layers.collect();
        layers.dedup();
        let named = layers.iter().take(MOST_NAMED).copied().collect::<Vec<_>>().join(", ");
        let count = beyond.len();
        let of_all = trn!(count, "{count} channel", "{count} channels");
        Some(match layers.len().saturating_sub(MOST_NAMED) {
            _ if layers.is_empty() => return None,
            0 => tr!("{named} ({of_all})"),
            more => tr!("{named} and {more} more ({of_all})"),
        })
    }

    /// Numbers of a channel.
    fn numbers(&self, name: &str) -> Option<&[f32]> {
        let found = self.channels.iter().find(|(known, _)| known == name);
        found.map(|(_, numbers)| numbers.as_slice())
    }

    /// The difference to another frame in the channels that both have; `None` where all their
    /// numbers are equal to the bit.
    ///
    /// # Errors
    /// The reason why the two cannot be compared: other sizes, or no channel of one name.
    pub fn difference(&self, other: &Self) -> Result<Option<FrameDifference>, String> {
        if self.size != other.size {
            let [[width, height], [other_width, other_height]] = [self.size, other.size];
            return Err(tr!(
                "it is {width}x{height}, and the other one {other_width}x{other_height}"
            ));
        }
        if !self.channels.iter().any(|(name, _)| other.numbers(name).is_some()) {
            return Err(tr!("both have no channel of one name").to_owned());
        }
        let mut differs = vec![false; self.size[0] as usize * self.size[1] as usize];
        let mut found: Option<FrameDifference> = None;
        for (name, numbers) in &self.channels {
            let Some(others) = other.numbers(name) else { continue };
            for (at, (a, b)) in numbers.iter().zip(others).enumerate() {
                if a.to_bits() == b.to_bits() {
                    continue;
                }
                differs[at] = true;
                let apart = (f64::from(*a) - f64::from(*b)).abs();
                let greatest = if apart.is_nan() { f64::INFINITY } else { apart };
                if found.as_ref().is_none_or(|known| greatest > known.greatest) {
                    let width = self.size[0] as usize;
                    let pixel = [(at % width) as u32, (at / width) as u32];
                    found =
                        Some(FrameDifference { greatest, channel: name.clone(), pixel, pixels: 0 });
                }
            }
        }
        let pixels = differs.iter().filter(|differs| **differs).count();
        Ok(found.map(|found| FrameDifference { pixels, ..found }))
    }

    /// The picture as it is shown over a backdrop, a color as shown; opaque. Light is laid over in
    /// light, and what is shown in what is shown.
    ///
    /// # Errors
    /// `no-picture` where a channel of the picture is not there.
    pub fn over(&self, backdrop: [f64; 3]) -> Result<Picture, Diagnostic> {
        let ([red, green, blue], alpha) = self.colors()?;
        let pixel = |at: usize| {
            let alpha = alpha.map_or(1.0, |alpha| f64::from(alpha[at]));
            let mut shown = [1.0; 4];
            for (slot, (number, behind)) in
                shown.iter_mut().zip([red[at], green[at], blue[at]].into_iter().zip(backdrop))
            {
                let number = f64::from(number);
                *slot = if self.is_light {
                    linear_to_srgb(number + (1.0 - alpha) * srgb_to_linear(behind)) as f32
                } else {
                    (number * alpha + behind * (1.0 - alpha)) as f32
                };
            }
            shown
        };
        let rgba = (0..red.len()).map(pixel).collect();
        Ok(Picture { size: self.size, rgba })
    }

    /// The picture as shown, with the alpha that it has: what was written.
    ///
    /// # Errors
    /// `no-picture` where a channel of the picture is not there.
    pub fn picture(&self) -> Result<Picture, Diagnostic> {
        let (colors, alpha) = self.colors()?;
        let pixel = |at: usize| {
            let alpha = alpha.map_or(1.0, |alpha| alpha[at]);
            let shown = |light: f32| {
                let straight = f64::from(light) / f64::from(alpha).max(f64::MIN_POSITIVE);
                (linear_to_srgb(straight.abs()) as f32).copysign(light)
            };
            let color = |of: &[f32]| match self.is_light {
                true if alpha <= 0.0 => 0.0,
                true => shown(of[at]),
                false => of[at],
            };
            let [red, green, blue] = colors.map(color);
            [red, green, blue, alpha]
        };
        let rgba = (0..colors[0].len()).map(pixel).collect();
        Ok(Picture { size: self.size, rgba })
    }

    /// Numbers of red, green and blue, and of alpha where the file has it.
    fn colors(&self) -> Result<ColorNumbers<'_>, Diagnostic> {
        let channel = |name: &str| {
            self.numbers(name).ok_or_else(|| {
                let message = tr!("the file has no channel {name}, and so no picture");
                Diagnostic::error("no-picture", message)
                    .hint(tr!("name a file that has R, G, B and A, as chiaro render writes it"))
            })
        };
        let colors = [channel("R")?, channel("G")?, channel("B")?];
        Ok((colors, channel("A").ok()))
    }
}

fn read_png(bytes: &[u8]) -> Result<StoredFrame, Diagnostic> {
    let failed = |message: String| Diagnostic::error("png", message);
    let limits = ::png::Limits { bytes: MAX_PNG_BYTES };
    let mut decoder = ::png::Decoder::new_with_limits(Cursor::new(bytes), limits);
    decoder.set_transformations(::png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(|error| failed(error.to_string()))?;
    let length = reader.output_buffer_size().filter(|length| *length <= MAX_PNG_BYTES);
    let mut pixels =
        vec![0; length.ok_or_else(|| failed(tr!("the picture is too large").to_owned()))?];
    let info = reader.next_frame(&mut pixels).map_err(|error| failed(error.to_string()))?;
    let names: &[&str] = match info.color_type {
        ::png::ColorType::Rgba => &["A", "B", "G", "R"],
        ::png::ColorType::Rgb => &["B", "G", "R"],
        _ => return Err(failed(tr!("the picture has no colors").to_owned())),
    };
    let channel = |at: usize| {
        let bytes = pixels.iter().skip(at).step_by(names.len());
        bytes.map(|byte| f32::from(*byte) / 255.0).collect::<Vec<f32>>()
    };
    let place = |name: &str| ["R", "G", "B", "A"].iter().position(|known| *known == name);
    let channels =
        names.iter().filter_map(|name| Some(((*name).to_owned(), channel(place(name)?)))).collect();
    Ok(StoredFrame {
        size: [info.width, info.height],
        channels,
        plan: png::note(bytes, PLAN_NOTE),
        is_sealed: (OutputKind::PICTURE.is_own)(bytes),
        is_light: false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exr::{ExrEncoding, ExrHeader, ExrLayer};

    fn picture() -> Picture {
        let rgba = (0..6).map(|at| [at as f32 / 6.0, 0.5, 0.25, 1.0 - at as f32 / 10.0]);
        Picture { size: [3, 2], rgba: rgba.collect() }
    }

    #[test]
    fn both_formats_show_the_same_picture() {
        let header = ExrHeader { plan: "abc".to_owned(), ..ExrHeader::default() };
        let layers = [ExrLayer::of_picture(&picture())];
        let exr = exr::encode([3, 2], &layers, &header, ExrEncoding::default()).unwrap();
        let exr = StoredFrame::read(&exr).unwrap();
        assert!(exr.is_sealed && exr.plan.as_deref() == Some("abc"));
        let noted = png::with_note(&picture().to_png().unwrap(), PLAN_NOTE, "abc");
        let png = StoredFrame::read(&noted).unwrap();
        assert_eq!((png.size, png.plan.as_deref()), ([3, 2], Some("abc")));
        assert!(!png.is_sealed, "nobody has sealed it yet");
        assert_eq!(exr.names(), png.names());
        // Without a backdrop's light both are the color as shown, times what covers.
        let first = |frame: &StoredFrame| frame.over([0.0; 3]).unwrap().rgba[0];
        for (a, b) in first(&exr).into_iter().zip(first(&png)) {
            assert!((a - b).abs() < 3e-3, "{a} {b}");
        }
        assert_eq!(first(&png)[3], 1.0);
        // With its alpha the picture is the one that was written.
        for frame in [&exr, &png] {
            let read = frame.picture().unwrap();
            for (pixel, wanted) in read.rgba.iter().zip(&picture().rgba) {
                let is_near = pixel.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 3e-3);
                assert!(is_near, "{pixel:?} {wanted:?}");
            }
        }
    }

    #[test]
    fn frames_are_compared_to_the_bit() {
        let read = |picture: &Picture| StoredFrame::read(&picture.to_png().unwrap()).unwrap();
        let (frame, mut other) = (picture(), picture());
        assert_eq!(read(&frame).difference(&read(&other)), Ok(None));
        other.rgba[4][1] += 2.0 / 255.0;
        other.rgba[1][0] += 1.0 / 255.0;
        let found = read(&frame).difference(&read(&other)).unwrap().unwrap();
        assert_eq!((found.channel.as_str(), found.pixel, found.pixels), ("G", [1, 1], 2));
        assert!((found.greatest - 2.0 / 255.0).abs() < 1e-6);
        let wide = Picture { size: [6, 1], rgba: picture().rgba };
        assert!(read(&frame).difference(&read(&wide)).unwrap_err().contains("6x1"));
        let mut odd = read(&frame);
        odd.channels[0].1[0] = f32::NAN;
        assert_eq!(odd.difference(&odd), Ok(None), "the same bits are equal");
        let found = odd.difference(&read(&frame)).unwrap().unwrap();
        assert_eq!(found.greatest, f64::INFINITY);
    }

    #[test]
    fn layers_that_one_frame_has_alone_are_named_and_the_others_compared() {
        let read = |names: &[&str]| {
            let own = ExrLayer::of_picture(&picture());
            let named = |name: &&str| ExrLayer { name: (*name).to_owned(), ..own.clone() };
            let layers: Vec<ExrLayer> = names.iter().map(named).collect();
            let header = ExrHeader::default();
            StoredFrame::read(
                &exr::encode([3, 2], &layers, &header, ExrEncoding::default()).unwrap(),
            )
            .unwrap()
        };
        let (plain, mut lit) = (read(&[""]), read(&["", "light_key", "light_back"]));
        assert_eq!(plain.difference(&lit), Ok(None), "what both have is equal");
        assert_eq!(plain.layers_beyond(&lit), None);
        let alone = lit.layers_beyond(&plain).unwrap();
        assert_eq!(alone, "light_back, light_key (8 channels)");
        let red = lit.channels.iter_mut().find(|(name, _)| name == "R").unwrap();
        red.1[4] += 1.0;
        let found = lit.difference(&plain).unwrap().unwrap();
        assert_eq!((found.channel.as_str(), found.pixel, found.pixels), ("R", [1, 1], 1));
        let many = read(&["a", "b", "c", "d", "e", "f"]);
        assert_eq!(many.layers_beyond(&plain).unwrap(), "a, b, c, d and 2 more (24 channels)");
        assert!(many.difference(&plain).is_err());
        let told = StoredFrame::read(&[0x76, 0x2f, 0x31, 0x01]).unwrap_err().message;
        assert!(told.starts_with("the EXR cannot be read:"), "{told}");
    }

    #[test]
    fn half_a_file_is_no_frame() {
        let bytes = picture().to_png().unwrap();
        for cut in 0..bytes.len() - 12 {
            assert!(StoredFrame::read(&bytes[..cut]).is_err(), "{cut}");
        }
        assert!(StoredFrame::read(b"somebody's").is_err());
    }
}
