//! OpenEXR files as compositors expect them: one part of scan lines, in which channels have the
//! names of their layers before a point, and those of the default layer none.
//!
//! Colors are premultiplied light: linear, with the primaries of Rec. 709.

mod header;

use std::hash::{Hash as _, Hasher as _};
use std::io::Cursor;

use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer, LineOrder,
    ReadChannels as _, ReadLayers as _, Text, WritableImage as _, read,
};
use chiaro_locale::{text, tr};
use half::f16;
use siphasher::sip::SipHasher13;

pub use header::{ExrAttribute, ExrHeader, FrameStamp};

use crate::FrameRate;
use crate::diag::Diagnostic;
use crate::document::srgb_to_linear;
use crate::files::OutputKind;
use crate::frame::Picture;

/// Greatest finite number of 16 bits.
const MAX_HALF: f32 = 65_504.0;

/// Number of an EXR's first bytes.
const MAGIC: &[u8] = &[0x76, 0x2f, 0x31, 0x01];

/// Numbers of channels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SampleType {
    /// 16 bits: 11 of them for the digits, as film has it.
    #[default]
    Half,
    /// 32 bits.
    Float,
}

impl SampleType {
    fn of(samples: &FlatSamples) -> Self {
        if matches!(samples, FlatSamples::F16(_)) { Self::Half } else { Self::Float }
    }
}

/// Compression, of which none loses anything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LosslessCompression {
    /// None.
    None,
    /// Runs of equal bytes: quick, for flat pictures.
    Rle,
    /// Deflate by single rows, which compositors read quickest.
    Zips,
    /// Deflate by sixteen rows.
    #[default]
    Zip,
    /// Wavelets, for pictures with grain.
    Piz,
}

impl LosslessCompression {
    /// All, each with its name for people.
    pub const ALL: [(&str, Self); 5] = [
        ("none", Self::None),
        ("rle", Self::Rle),
        ("zips", Self::Zips),
        ("zip", Self::Zip),
        ("piz", Self::Piz),
    ];

    const fn compression(self) -> Compression {
        match self {
            Self::None => Compression::Uncompressed,
            Self::Rle => Compression::RLE,
            Self::Zips => Compression::ZIP1,
            Self::Zip => Compression::ZIP16,
            Self::Piz => Compression::PIZ,
        }
    }
}

/// Form in which numbers are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExrEncoding {
    /// Numbers of the channels.
    pub samples: SampleType,
    /// Compression.
    pub compression: LosslessCompression,
}

/// Layer of a file: channels side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrLayer {
    /// Name before the point; empty for the default layer.
    pub name: String,
    /// Names of the channels, such as `R`, each with its numbers, row by row from the top.
    pub channels: Vec<(String, Vec<f32>)>,
    /// Numbers of the channels, where they are not those of the file.
    pub samples: Option<SampleType>,
}

impl ExrLayer {
    /// A picture as the default layer: premultiplied light.
    pub fn of_picture(picture: &Picture) -> Self {
        let of = |channel: usize| {
            let numbers = picture.rgba.iter().map(|pixel| match channel {
                3 => pixel[3],
                _ => light_of(pixel[channel]) * pixel[3],
            });
            numbers.collect()
        };
        let names = ["R", "G", "B", "A"].into_iter().enumerate();
        let channels = names.map(|(channel, name)| (name.to_owned(), of(channel))).collect();
        Self { name: String::new(), channels, samples: None }
    }
}

/// Light of a number as shown (IEC 61966-2-1); what lies outside of [0, 1] goes on as the curve
/// does, the same on both sides of 0.
pub(crate) fn light_of(shown: f32) -> f32 {
    (srgb_to_linear(f64::from(shown.abs())) as f32).copysign(shown)
}

/// Writes a file of layers of this size, in pixels.
///
/// # Errors
/// `exr` with the reason, for layers of another size, or none.
pub fn encode(
    size: [u32; 2],
    layers: &[ExrLayer],
    header: &ExrHeader,
    encoding: ExrEncoding,
) -> Result<Vec<u8>, Diagnostic> {
    let [width, height] = size.map(|side| side as usize);
    let mut channels = Vec::new();
    for layer in layers {
        for (channel, numbers) in &layer.channels {
            if numbers.len() != width * height {
                return Err(unwritable(tr!("a channel has another size than the picture")));
            }
            let is_alone = layer.name.is_empty();
            let name = if is_alone { channel.clone() } else { format!("{}.{channel}", layer.name) };
            let text = Text::new_or_none(&name)
                .ok_or_else(|| unwritable(&tr!("`{name}` is no name that EXR can hold")))?;
            let samples = match layer.samples.unwrap_or(encoding.samples) {
                SampleType::Half => FlatSamples::F16(numbers.iter().map(|x| half_of(*x)).collect()),
                SampleType::Float => FlatSamples::F32(numbers.clone()),
            };
            channels.push(AnyChannel::new(text, samples));
        }
    }
    let seal = seal_of(channels.iter().map(|channel| (&channel.name, &channel.sample_data)));
    let encoding = Encoding {
        compression: encoding.compression.compression(),
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let attributes = header.of_layer(size, &seal);
    let list = AnyChannels::sort(channels.into());
    let mut image = Image::from_layer(Layer::new((width, height), attributes, encoding, list));
    header.mark(&mut image.attributes);
    let mut bytes = Cursor::new(Vec::new());
    image.write().to_buffered(&mut bytes).map_err(|error| unwritable(&error.to_string()))?;
    let mut bytes = bytes.into_inner();
    header::sort_attributes(&mut bytes).ok_or_else(|| unwritable(tr!("its header is cut off")))?;
    Ok(bytes)
}

/// The nearest number of 16 bits; what is too great becomes the greatest.
fn half_of(number: f32) -> f16 {
    f16::from_f32(number.clamp(-MAX_HALF, MAX_HALF))
}

/// Content of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrContent {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Full names of the channels, such as `R` or `key.R`, in the order of the alphabet, each with
    /// its numbers, row by row from the top.
    pub channels: Vec<(String, Vec<f32>)>,
    /// Type of each channel's numbers.
    pub samples: Vec<SampleType>,
    /// The hash of the plan that the picture was drawn of, if Chiaro wrote the file.
    pub plan: Option<String>,
    /// True if the numbers are those that Chiaro wrote.
    pub is_sealed: bool,
    /// The space of layers of values, as its writer said.
    pub layers_in: Option<String>,
    /// Frames per second, of a picture among others.
    pub rate: Option<FrameRate>,
}

/// Reads a file of one part without deep data.
///
/// # Errors
/// `exr` with the reason, for bytes that are no whole file.
pub fn decode(bytes: &[u8]) -> Result<ExrContent, Diagnostic> {
    let reader = read().no_deep_data().largest_resolution_level().all_channels();
    let image = reader.first_valid_layer().all_attributes().from_buffered(Cursor::new(bytes));
    let layer = image.map_err(|error| unreadable(&error.to_string()))?.layer_data;
    let list = &layer.channel_data.list;
    let seal = seal_of(list.iter().map(|channel| (&channel.name, &channel.sample_data)));
    let numbers = |channel: &AnyChannel<FlatSamples>| {
        (channel.name.to_string(), channel.sample_data.values_as_f32().collect())
    };
    Ok(ExrContent {
        size: [layer.size.x() as u32, layer.size.y() as u32],
        channels: list.iter().map(numbers).collect(),
        samples: list.iter().map(|channel| SampleType::of(&channel.sample_data)).collect(),
        plan: header::note_of(&layer.attributes, header::PLAN),
        is_sealed: header::note_of(&layer.attributes, header::SEAL) == Some(seal),
        layers_in: header::note_of(&layer.attributes, header::LAYERS_IN),
        rate: header::rate_of(&layer.attributes),
    })
}

/// The same numbers in a file that says something else of them.
///
/// # Errors
/// As [`decode`] and [`encode`].
pub fn stamped(
    bytes: &[u8],
    header: &ExrHeader,
    encoding: ExrEncoding,
) -> Result<Vec<u8>, Diagnostic> {
    let ExrContent { size, channels, samples, .. } = decode(bytes)?;
    let layer = |(channel, samples)| ExrLayer {
        name: String::new(),
        channels: vec![channel],
        samples: Some(samples),
    };
    let layers: Vec<ExrLayer> = channels.into_iter().zip(samples).map(layer).collect();
    encode(size, &layers, header, encoding)
}

/// Checksum of all numbers, of whatever type they are: names, and bits in order of the names.
fn seal_of<'a>(channels: impl Iterator<Item = (&'a Text, &'a FlatSamples)>) -> String {
    let mut channels: Vec<_> = channels.collect();
    channels.sort_by(|(a, _), (b, _)| a.bytes().cmp(b.bytes()));
    let mut hasher = SipHasher13::new();
    for (name, samples) in channels {
        name.bytes().hash(&mut hasher);
        match samples {
            FlatSamples::F16(numbers) => numbers.iter().for_each(|x| x.to_bits().hash(&mut hasher)),
            FlatSamples::F32(numbers) => numbers.iter().for_each(|x| x.to_bits().hash(&mut hasher)),
            FlatSamples::U32(numbers) => numbers.hash(&mut hasher),
        }
    }
    format!("{:016x}", hasher.finish())
}

/// Picture as EXR.
pub const EXR: OutputKind<'static> =
    OutputKind { name: text!("a picture").english(), is_own: &is_own, has_seal: false };

/// True if an EXR is as Chiaro wrote it.
fn is_own(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) && decode(bytes).is_ok_and(|content| content.is_sealed)
}

fn unreadable(reason: &str) -> Diagnostic {
    Diagnostic::error("exr", tr!("the EXR cannot be read: {reason}"))
}

fn unwritable(reason: &str) -> Diagnostic {
    Diagnostic::error("exr", tr!("the EXR cannot be written: {reason}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> Picture {
        let rgba = (0..15).map(|at| {
            let x = at as f32 / 14.0;
            [x, 1.0 - x, 0.5, if at % 4 == 0 { 0.5 } else { 1.0 }]
        });
        Picture { size: [5, 3], rgba: rgba.collect() }
    }

    fn numbers<'c>(content: &'c ExrContent, name: &str) -> &'c [f32] {
        &content.channels.iter().find(|(channel, _)| channel == name).expect("a channel").1
    }

    #[test]
    fn a_picture_comes_back_as_premultiplied_light() {
        let layer = ExrLayer::of_picture(&picture());
        let key = ExrLayer { name: "key".to_owned(), ..layer.clone() };
        for (_, compression) in LosslessCompression::ALL {
            for samples in [SampleType::Half, SampleType::Float] {
                let encoding = ExrEncoding { samples, compression };
                let layers = [layer.clone(), key.clone()];
                let bytes = encode([5, 3], &layers, &ExrHeader::default(), encoding).unwrap();
                let content = decode(&bytes).unwrap();
                assert!(content.is_sealed && is_own(&bytes));
                assert_eq!(content.size, [5, 3]);
                let names: Vec<_> = content.channels.iter().map(|(name, _)| &name[..]).collect();
                assert_eq!(names, ["A", "B", "G", "R", "key.A", "key.B", "key.G", "key.R"]);
                let (red, alpha) = (numbers(&content, "R"), numbers(&content, "A"));
                // 0.5 as shown is 0.21404 of light.
                let half_step = if samples == SampleType::Half { 2.0_f32.powi(-11) } else { 1e-7 };
                let blue = numbers(&content, "key.B");
                for (at, pixel) in picture().rgba.iter().enumerate() {
                    assert!((alpha[at] - pixel[3]).abs() <= half_step);
                    assert!((blue[at] - 0.214_041_14 * pixel[3]).abs() <= half_step);
                }
                assert_eq!((red[0], red[14]), (0.0, 1.0));
            }
        }
    }

    #[test]
    fn a_file_gets_another_stamp() {
        let layer = ExrLayer::of_picture(&picture());
        let encoding = ExrEncoding::default();
        let header = |plan: &str| ExrHeader { plan: plan.to_owned(), ..ExrHeader::default() };
        let first = encode([5, 3], std::slice::from_ref(&layer), &header("one"), encoding).unwrap();
        let second = stamped(&first, &header("two"), encoding).unwrap();
        assert_eq!(second, encode([5, 3], &[layer], &header("two"), encoding).unwrap());
        assert_eq!(decode(&second).unwrap().plan.as_deref(), Some("two"));
    }

    #[test]
    fn what_others_changed_is_not_ours() {
        let layer = ExrLayer::of_picture(&picture());
        let encoding =
            ExrEncoding { samples: SampleType::Float, compression: LosslessCompression::None };
        let bytes = encode([5, 3], &[layer], &ExrHeader::default(), encoding).unwrap();
        for cut in [0, 3, 100, bytes.len() / 2, bytes.len() - 1] {
            assert!(!is_own(&bytes[..cut]), "{cut}");
        }
        let mut painted = bytes.clone();
        let last = painted.len() - 1;
        painted[last] ^= 1;
        assert!(decode(&painted).is_ok() && !is_own(&painted));
    }

    #[test]
    fn numbers_too_great_for_halves_stay_finite() {
        let layer = ExrLayer {
            name: String::new(),
            channels: vec![("Z".to_owned(), vec![1e9, -1e9, f32::INFINITY, 0.0])],
            samples: None,
        };
        let bytes =
            encode([2, 2], &[layer], &ExrHeader::default(), ExrEncoding::default()).unwrap();
        let content = decode(&bytes).unwrap();
        assert_eq!(numbers(&content, "Z"), [MAX_HALF, -MAX_HALF, MAX_HALF, 0.0]);
    }
}
