//! Texels packed by DEFLATE (RFC 1951): in memory for undo, and as base64 in journals.

use std::io::{Read as _, Write as _};
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use chiaro_locale::tr;
use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{MAX_TILE_SIDE, Tile};

/// Bytes packed by DEFLATE.
#[derive(Clone, PartialEq, Eq)]
pub(super) struct Bytes(Arc<[u8]>);

impl std::fmt::Debug for Bytes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} bytes", self.0.len())
    }
}

impl Bytes {
    /// Packs bytes quickly rather than tightly: the artist's hand waits for it.
    pub(super) fn pack(bytes: &[u8]) -> Self {
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
        // Writing to memory cannot fail.
        let packed = encoder.write_all(bytes).and_then(|()| encoder.finish()).unwrap_or_default();
        Self(packed.into())
    }

    /// Unpacked bytes, if there are `count` of them.
    pub(super) fn unpack(&self, count: usize) -> Option<Vec<u8>> {
        let mut bytes = Vec::new();
        // One byte beyond `count` reveals a longer text.
        DeflateDecoder::new(&*self.0).take(count as u64 + 1).read_to_end(&mut bytes).ok()?;
        (bytes.len() == count).then_some(bytes)
    }

    /// Size of the packed bytes.
    pub(super) fn count(&self) -> usize {
        self.0.len()
    }
}

impl Serialize for Bytes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&BASE64.encode(&self.0))
    }
}

impl<'de> Deserialize<'de> for Bytes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let bytes = BASE64.decode(text.trim()).map_err(|_| D::Error::custom(tr!("no base64")))?;
        Ok(Self(bytes.into()))
    }
}

/// Packed tile.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Tile")]
pub(super) struct PackedTile {
    size: [u32; 2],
    rgba: Bytes,
}

impl PackedTile {
    pub(super) fn new(tile: &Tile) -> Self {
        Self { size: tile.size(), rgba: Bytes::pack(tile.bytes()) }
    }

    /// Size of the tile's texels when unpacked, in bytes.
    pub(super) fn texel_bytes(&self) -> u64 {
        self.size.iter().fold(4, |bytes: u64, side| bytes.saturating_mul(u64::from(*side)))
    }

    /// Unpacked tile; `None` where the data are damaged.
    pub(super) fn tile(&self) -> Option<Tile> {
        let is_tile = self.size.iter().all(|side| (1..=MAX_TILE_SIDE).contains(side));
        let count = is_tile.then(|| self.texel_bytes() as usize)?;
        Tile::new(self.size, self.rgba.unpack(count)?)
    }
}
