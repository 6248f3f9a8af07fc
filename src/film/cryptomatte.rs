//! Cryptomatte 1.1: mattes of everything that has a name, by ids and coverage.
//!
//! A pixel lists the names that its samples show, those of most coverage first, in layers of two:
//! id and coverage in R and G, and in B and A. An id is the hash of the name, its bits read as a
//! float. The header says which hash is which name.

use std::collections::BTreeMap;

use crate::exr::{ExrAttribute, ExrLayer, SampleType};

/// Ids of a pixel: more are left out, those of least coverage first. The same in all frames.
const RANKS: usize = 6;

/// Hash of a name: MurmurHash3 for 32-bit words, seeded with 0.
fn murmur3(bytes: &[u8]) -> u32 {
    let scramble =
        |word: u32| word.wrapping_mul(0xcc9e_2d51).rotate_left(15).wrapping_mul(0x1b87_3593);
    let mut hash = 0_u32;
    let mut words = bytes.chunks_exact(4);
    for word in &mut words {
        hash ^= scramble(u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
        hash = hash.rotate_left(13).wrapping_mul(5).wrapping_add(0xe654_6b64);
    }
    let rest = words.remainder().iter().rev().fold(0, |word, byte| word << 8 | u32::from(*byte));
    hash ^= if words.remainder().is_empty() { 0 } else { scramble(rest) };
    hash ^= bytes.len() as u32;
    hash ^= hash >> 16;
    hash = hash.wrapping_mul(0x85eb_ca6b);
    hash ^= hash >> 13;
    hash = hash.wrapping_mul(0xc2b2_ae35);
    hash ^ hash >> 16
}

/// The id of a name: its hash, but never the bits of a number that is not normal, for files and
/// filters change those.
fn id_of(name: &str) -> u32 {
    let hash = murmur3(name.as_bytes());
    let exponent = hash >> 23 & 255;
    if exponent == 0 || exponent == 255 { hash ^ 1 << 23 } else { hash }
}

/// Matte of one kind of names.
#[derive(Clone, Debug, PartialEq)]
pub struct Cryptomatte {
    /// Name of the kind, such as `CryptoObject`: the beginning of the layers' names.
    pub name: &'static str,
    /// All names, whether or not they are seen.
    pub names: Vec<String>,
    /// Coverage of the names.
    pub coverage: MatteCoverage,
}

/// Coverage of names, pixel by pixel in rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub enum MatteCoverage {
    /// For each sample of a pixel, the name that is seen: an index among the names, or nothing.
    Samples(Vec<Vec<Option<usize>>>),
    /// For each name, its share of each pixel.
    Shares(Vec<Vec<f32>>),
}

impl MatteCoverage {
    /// Number of pixels.
    fn pixels(&self) -> usize {
        match self {
            Self::Samples(samples) => samples.first().map_or(0, Vec::len),
            Self::Shares(shares) => shares.first().map_or(0, Vec::len),
        }
    }

    /// Ids of a pixel with the coverage of each; equal ids are one.
    fn of_pixel(&self, pixel: usize, ids: &[f32], seen: &mut Vec<(f32, f32)>) {
        seen.clear();
        let mut add = |name: usize, share: f32| {
            let is_same = |(id, _): &&mut (f32, f32)| id.to_bits() == ids[name].to_bits();
            match seen.iter_mut().find(is_same) {
                Some((_, sum)) => *sum += share,
                None => seen.push((ids[name], share)),
            }
        };
        match self {
            Self::Samples(samples) => {
                let share = 1.0 / samples.len().max(1) as f32;
                samples.iter().filter_map(|sample| sample[pixel]).for_each(|name| add(name, share));
            }
            Self::Shares(shares) => {
                let shares = shares.iter().map(|share| share[pixel]).enumerate();
                shares.filter(|(_, share)| *share > 0.0).for_each(|(name, share)| add(name, share));
            }
        }
        seen.sort_by_key(|(id, share)| (std::cmp::Reverse(share.to_bits()), id.to_bits()));
    }
}

impl Cryptomatte {
    /// Number of bytes that a pixel takes: samples or shares, and the numbers of the layers.
    pub(crate) fn bytes_a_pixel(&self) -> usize {
        let numbers = size_of::<f32>() * (4 + 2 * RANKS);
        numbers
            + match &self.coverage {
                MatteCoverage::Samples(samples) => size_of::<Option<usize>>() * samples.len(),
                MatteCoverage::Shares(shares) => size_of::<f32>() * shares.len(),
            }
    }

    /// The layers: a preview in colors, and ids with coverage.
    pub fn layers(&self) -> Vec<ExrLayer> {
        let ids: Vec<f32> = self.names.iter().map(|name| f32::from_bits(id_of(name))).collect();
        let count = self.coverage.pixels();
        let mut ranks = vec![vec![0.0_f32; count]; 2 * RANKS];
        let mut preview = vec![vec![0.0_f32; count]; 3];
        let mut seen = Vec::new();
        for pixel in 0..count {
            self.coverage.of_pixel(pixel, &ids, &mut seen);
            for (rank, &(id, coverage)) in seen.iter().take(RANKS).enumerate() {
                ranks[2 * rank][pixel] = id;
                ranks[2 * rank + 1][pixel] = coverage;
                for (channel, sum) in preview.iter_mut().enumerate() {
                    sum[pixel] += coverage * preview_of(id, channel);
                }
            }
        }
        let channels = |names: [&str; 4], numbers: Vec<Vec<f32>>| {
            names.iter().map(|name| (*name).to_owned()).zip(numbers).collect()
        };
        let mut layers = vec![ExrLayer {
            name: self.name.to_owned(),
            channels: channels(["R", "G", "B", "A"], preview),
            samples: None,
        }];
        let mut ranks = ranks.into_iter();
        for level in 0..RANKS / 2 {
            layers.push(ExrLayer {
                name: format!("{}{level:02}", self.name),
                channels: channels(["R", "G", "B", "A"], ranks.by_ref().take(4).collect()),
                // Half floats would destroy the ids.
                samples: Some(SampleType::Float),
            });
        }
        layers
    }

    /// Statements of the header about the matte.
    pub fn attributes(&self) -> Vec<ExrAttribute> {
        let key = &format!("{:08x}", murmur3(self.name.as_bytes()))[..7];
        // Two names of one id are one matte, which has the first name of the alphabet.
        let mut manifest: BTreeMap<&str, u32> = BTreeMap::new();
        manifest.extend(self.names.iter().map(|name| (name.as_str(), id_of(name))));
        let pairs = manifest.iter().map(|(name, id)| format!("{}:\"{id:08x}\"", json_text(name)));
        let manifest = format!("{{{}}}", pairs.collect::<Vec<_>>().join(","));
        let notes = [
            ("name", self.name.to_owned()),
            ("hash", "MurmurHash3_32".to_owned()),
            ("conversion", "uint32_to_float32".to_owned()),
            ("manifest", manifest),
        ];
        let attribute = |(what, text): (&str, String)| ExrAttribute {
            name: format!("cryptomatte/{key}/{what}"),
            text,
        };
        notes.into_iter().map(attribute).collect()
    }
}

/// A channel of the color by which a preview shows an id.
fn preview_of(id: f32, channel: usize) -> f32 {
    f32::from(murmur3(&id.to_bits().to_le_bytes()).to_le_bytes()[channel]) / 255.0
}

/// A text in JSON, in ASCII alone.
fn json_text(text: &str) -> String {
    let mut quoted = String::from("\"");
    for unit in text.encode_utf16() {
        match char::from_u32(unit.into()) {
            Some(c @ ('"' | '\\')) => quoted.extend(['\\', c]),
            Some(c) if (' '..='~').contains(&c) => quoted.push(c),
            _ => quoted.push_str(&format!("\\u{unit:04x}")),
        }
    }
    quoted + "\""
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Vectors of the specification's sample pictures, and of the hash's reference.
    #[test]
    fn ids_are_those_of_the_specification() {
        assert_eq!(murmur3(b""), 0);
        for (name, id) in
            [("bunny", 0x1385_1a76), ("default", 0x42c9_679f), ("bunny_porcelain_mat", 0xb24b_26d4)]
        {
            assert_eq!(id_of(name), id, "{name}");
        }
        for number in 0..20_000 {
            let id = f32::from_bits(id_of(&format!("object_{number}")));
            assert!(id.is_normal());
        }
    }

    #[test]
    fn ranks_are_by_coverage_and_manifests_in_ascii() {
        let matte = Cryptomatte {
            name: "CryptoObject",
            names: vec!["key\"".to_owned(), "Würfel".to_owned()],
            coverage: MatteCoverage::Samples(vec![
                vec![Some(0), None],
                vec![Some(1), None],
                vec![Some(1), Some(0)],
                vec![Some(1), None],
            ]),
        };
        let layers = matte.layers();
        let names: Vec<_> = layers.iter().map(|layer| layer.name.as_str()).collect();
        assert_eq!(names, ["CryptoObject", "CryptoObject00", "CryptoObject01", "CryptoObject02"]);
        let [first, second] = [&layers[1], &layers[2]];
        let numbers = |layer: &ExrLayer, pixel: usize| {
            layer.channels.iter().map(|(_, numbers)| numbers[pixel]).collect::<Vec<f32>>()
        };
        let ids: Vec<f32> = matte.names.iter().map(|name| f32::from_bits(id_of(name))).collect();
        assert_eq!(numbers(first, 0), [ids[1], 0.75, ids[0], 0.25]);
        assert_eq!(numbers(first, 1), [ids[0], 0.25, 0.0, 0.0]);
        assert_eq!(numbers(second, 0), [0.0; 4]);
        let manifest = &matte.attributes()[3];
        assert!(manifest.text.starts_with("{\"W\\u00fcrfel\":\""), "{}", manifest.text);
        assert!(manifest.text.contains("\"key\\\"\":\""));
    }
}
