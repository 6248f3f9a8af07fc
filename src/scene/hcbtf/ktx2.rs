//! The texture of an HCBTF as a KTX2 file (Khronos, KTX File Format 2.0), which engines load beside
//! an exported shader.
//!
//! The file has one level of an array of RGBA8 or BC7 layers as [`LayeredTexture`] describes them;
//! its first row is at the top.

use chiaro_locale::tr;

use super::blocks::TexelCoding;
use super::layers::{LayeredTexture, MAX_LAYERS_BYTES};
use crate::diag::Diagnostic;

const IDENTIFIER: [u8; 12] =
    [0xab, b'K', b'T', b'X', b' ', b'2', b'0', 0xbb, b'\r', b'\n', 0x1a, b'\n'];
/// Code of `VK_FORMAT_R8G8B8A8_UNORM`.
const RGBA8: u32 = 37;
/// Code of `VK_FORMAT_BC7_UNORM_BLOCK`.
const BC7: u32 = 145;
/// Length of the header, in bytes: identifier, nine numbers, places of four parts, and place of the
/// one level.
const HEADER: usize = 12 + 9 * 4 + 4 * 4 + 2 * 8 + 3 * 8;
/// Keys and values of the file, in the order that the format asks for.
const KEYS: [(&str, &str); 2] =
    [("KTXorientation", "rd"), ("KTXwriter", concat!("Chiaro ", env!("CARGO_PKG_VERSION")))];

/// The bytes of a file.
pub fn write(layers: &LayeredTexture) -> Vec<u8> {
    let described = description(layers.coding);
    let keys = keys();
    let keys_at = HEADER + described.len();
    let level_at = (keys_at + keys.len()).next_multiple_of(16);
    let mut out = Vec::with_capacity(level_at + layers.bytes.len());
    out.extend(IDENTIFIER);
    let [width, height] = layers.size;
    // Format, bytes of a channel, width, height, depth, layers, faces, levels, supercompression.
    let format = match layers.coding {
        TexelCoding::Rgba8 => RGBA8,
        TexelCoding::Bc7 => BC7,
    };
    let numbers = [format, 1, width, height, 0, layers.count, 1, 1, 0];
    let parts = [HEADER as u32, described.len() as u32, keys_at as u32, keys.len() as u32];
    out.extend(numbers.into_iter().chain(parts).flat_map(u32::to_le_bytes));
    let bytes = layers.bytes.len() as u64;
    out.extend([0, 0, level_at as u64, bytes, bytes].into_iter().flat_map(u64::to_le_bytes));
    out.extend(described);
    out.extend(keys);
    out.resize(level_at, 0);
    out.extend(&layers.bytes);
    out
}

/// The basic data format descriptor (Khronos Data Format Specification 1.3): four channels of 8
/// bits, or blocks of them, linear, alpha straight.
fn description(coding: TexelCoding) -> Vec<u8> {
    // The color model, texels along a block less one, its bytes, and its parts: bits less one,
    // channel, the highest number.
    let (model, edge, bytes, parts): (u8, u8, u32, &[(u8, u8, u32)]) = match coding {
        TexelCoding::Rgba8 => (1, 0, 4, &[(7, 0, 255), (7, 1, 255), (7, 2, 255), (7, 15, 255)]),
        TexelCoding::Bc7 => (134, 3, 16, &[(127, 0, u32::MAX)]),
    };
    let block = 24 + 16 * parts.len() as u32;
    let mut out = Vec::new();
    let model = u32::from_le_bytes([model, 1, 1, 0]);
    let edges = u32::from_le_bytes([edge, edge, 0, 0]);
    // Vendor and type, version and size, color model with primaries and transfer, texel block,
    // bytes of its planes.
    let words = [block + 4, 0, 2 | block << 16, model, edges, bytes, 0];
    out.extend(words.into_iter().flat_map(u32::to_le_bytes));
    for (index, (bits, channel, highest)) in (0u8..).zip(parts) {
        out.extend([8 * index, 0, *bits, *channel]);
        out.extend([0, 0, *highest].into_iter().flat_map(u32::to_le_bytes));
    }
    out
}

fn keys() -> Vec<u8> {
    let mut out = Vec::new();
    for (key, value) in KEYS {
        out.extend(((key.len() + value.len() + 2) as u32).to_le_bytes());
        out.extend(key.bytes().chain([0]).chain(value.bytes()).chain([0]));
        out.resize(out.len().next_multiple_of(4), 0);
    }
    out
}

/// Reads a file of [`write()`]; `name` is the file's, for messages.
///
/// # Errors
/// `bad-ktx2`: the file is no KTX2, is cut short, or holds something else than one level of RGBA8
/// or BC7 layers.
pub fn read(bytes: &[u8], name: &str) -> Result<LayeredTexture, Diagnostic> {
    let wrong = |message: &str| {
        Diagnostic::error("bad-ktx2", message.to_owned())
            .in_file(name)
            .hint(tr!("export the painted surface (HCBTF) anew; only one level of RGBA8 or BC7 \
                   layers, without supercompression, is read"))
    };
    if !bytes.starts_with(&IDENTIFIER) {
        return Err(wrong(tr!("this is no KTX2 file")));
    }
    let word = |at: usize| {
        bytes.get(at..at + 4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]))
    };
    let long = |at: usize| Some(u64::from(word(at)?) | u64::from(word(at + 4)?) << 32);
    let cut = || wrong(tr!("the file is cut short"));
    let number = |index: usize| word(12 + 4 * index).ok_or_else(cut);
    let [format, width, height, depth, count] =
        [number(0)?, number(2)?, number(3)?, number(4)?, number(5)?];
    let [faces, levels, compression] = [number(6)?, number(7)?, number(8)?];
    let coding = match format {
        RGBA8 => Some(TexelCoding::Rgba8),
        BC7 if width % 4 == 0 && height % 4 == 0 => Some(TexelCoding::Bc7),
        _ => None,
    };
    let is_plain =
        (depth, faces, levels, compression) == (0, 1, 1, 0) && width > 0 && height > 0 && count > 0;
    let Some(coding) = coding.filter(|_| is_plain) else {
        return Err(wrong(tr!("the texture is not one level of RGBA8 or BC7 layers")));
    };
    let (Some(at), Some(length)) = (long(HEADER - 24), long(HEADER - 16)) else {
        return Err(cut());
    };
    let texels = [width, height, count].into_iter().map(u64::from).fold(1, u64::saturating_mul);
    if length != coding.bytes(texels) {
        return Err(wrong(tr!("its size is not that of its texels")));
    }
    if TexelCoding::Rgba8.bytes(texels) > MAX_LAYERS_BYTES {
        return Err(wrong(tr!("its texels would take more memory than one may")));
    }
    let texels = at
        .checked_add(length)
        .and_then(|end| bytes.get(usize::try_from(at).ok()?..usize::try_from(end).ok()?));
    let bytes = texels.ok_or_else(cut)?.to_vec();
    Ok(LayeredTexture { size: [width, height], count, coding, bytes })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn small() -> LayeredTexture {
        LayeredTexture {
            size: [3, 2],
            count: 2,
            coding: TexelCoding::Rgba8,
            bytes: (0..48).collect(),
        }
    }

    #[test]
    fn what_is_written_is_read() {
        assert_eq!(read(&write(&small()), "a.ktx2").unwrap(), small());
    }

    /// Reads the file by another program's reader of the format.
    #[test]
    fn a_reader_of_the_format_agrees() {
        let bytes = write(&small());
        let reader = ::ktx2::Reader::new(&bytes[..]).unwrap();
        let header = reader.header();
        assert_eq!(header.format, Some(::ktx2::Format::R8G8B8A8_UNORM));
        assert_eq!([header.pixel_width, header.pixel_height, header.layer_count], [3, 2, 2]);
        let levels: Vec<_> = reader.levels().collect();
        assert_eq!(levels.len(), 1);
        assert_eq!(levels[0].data, small().bytes);
        let keys: Vec<_> = reader.key_value_data().map(|(key, _)| key.to_owned()).collect();
        assert_eq!(keys, KEYS.map(|(key, _)| key));
        assert_eq!(reader.transfer_function(), Some(::ktx2::TransferFunction::Linear));
        assert_eq!(reader.color_model(), Some(::ktx2::ColorModel::RGBSDA));
        assert_eq!(reader.is_alpha_premultiplied(), Some(false));
        assert_eq!(reader.basic_dfd().map(|described| described.sample_information.len()), Some(4));
        let blocks = LayeredTexture {
            size: [8, 4],
            count: 3,
            coding: TexelCoding::Bc7,
            bytes: (0..96).collect(),
        };
        let bytes = write(&blocks);
        assert_eq!(read(&bytes, "a.ktx2").unwrap(), blocks);
        let reader = ::ktx2::Reader::new(&bytes[..]).unwrap();
        assert_eq!(reader.header().format, Some(::ktx2::Format::BC7_UNORM_BLOCK));
        assert_eq!(reader.levels().next().unwrap().data, blocks.bytes);
        assert_eq!(reader.transfer_function(), Some(::ktx2::TransferFunction::Linear));
        assert_eq!(reader.color_model(), Some(::ktx2::ColorModel::BC7));
        let described = reader.basic_dfd().unwrap();
        assert_eq!(described.texel_block_dimensions.map(u8::from), [4, 4, 1, 1]);
        assert_eq!(described.bytes_planes[0], 16);
        assert_eq!(described.sample_information.len(), 1);
    }

    #[test]
    fn every_cut_and_every_changed_number_is_told() {
        let whole = write(&small());
        for length in 0..whole.len() {
            assert!(read(&whole[..length], "a.ktx2").is_err(), "{length} bytes");
        }
        for at in 0..48 {
            let mut changed = whole.clone();
            changed[at] ^= 0x41;
            // The bytes of a channel are not needed to read the file.
            let is_read = read(&changed, "a.ktx2").is_ok();
            assert_eq!(is_read, (16..20).contains(&at), "byte {at}");
        }
    }
}
