//! Images of documents as they lie in memory, for journals. Looks, scenes and the parts of HCBTFs
//! have an image by serde, from their descriptions; tiles, which no text holds, are packed. An
//! image also holds data that no file has, such as the unknown fields of a removed part, which undo
//! may bring back.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use chiaro_locale::tr;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::packed::PackedTile;
use super::{Address, Editable, Grid, Hcbtf, Look, Rule, Scene, Shot, Tile, UnknownFields};

/// Image of an HCBTF, with each tile once however many samples are equal to it.
pub(super) struct HcbtfImage;

#[derive(Serialize, Deserialize)]
#[serde(rename = "Hcbtf", bound(deserialize = ""))]
struct HcbtfText<'h> {
    grid: Grid,
    is_tiling: bool,
    tiles: Vec<PackedTile>,
    /// Each sample, with the index of its tile.
    painted: Vec<(Address, usize)>,
    rules: Cow<'h, [Rule]>,
    #[serde(default, skip_serializing_if = "UnknownFields::is_empty")]
    unknown: UnknownFields,
}

impl HcbtfImage {
    pub(super) fn serialize<S: Serializer>(
        hcbtf: &Hcbtf,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let mut places: HashMap<&Tile, usize> = HashMap::new();
        let mut tiles = Vec::new();
        let mut painted = Vec::with_capacity(hcbtf.painted.len());
        for (address, tile) in &hcbtf.painted {
            let place = places.entry(&**tile).or_insert_with(|| {
                tiles.push(PackedTile::new(tile));
                tiles.len() - 1
            });
            painted.push((*address, *place));
        }
        let Hcbtf { grid, is_tiling, painted: _, rules, unknown } = hcbtf;
        HcbtfText {
            grid: *grid,
            is_tiling: *is_tiling,
            tiles,
            painted,
            rules: rules.into(),
            unknown: unknown.clone(),
        }
        .serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Hcbtf, D::Error> {
        let HcbtfText { grid, is_tiling, tiles, painted, rules, unknown } =
            HcbtfText::deserialize(deserializer)?;
        // The bound is checked before anything is unpacked.
        if tiles.iter().map(PackedTile::texel_bytes).sum::<u64>() > Hcbtf::MAX_PAINTED_BYTES {
            return Err(D::Error::custom(tr!("the tiles are larger than can be")));
        }
        let unpack = |packed: &PackedTile| {
            packed.tile().map(Arc::new).ok_or_else(|| D::Error::custom(tr!("a damaged tile")))
        };
        let tiles: Vec<Arc<Tile>> = tiles.iter().map(unpack).collect::<Result<_, _>>()?;
        let of = |(address, place): (Address, usize)| {
            let tile =
                tiles.get(place).ok_or_else(|| D::Error::custom(tr!("a sample without a tile")))?;
            Ok((address, tile.clone()))
        };
        let painted = painted.into_iter().map(of).collect::<Result<_, D::Error>>()?;
        Ok(Hcbtf { grid, is_tiling, painted, rules: rules.into_owned(), unknown })
    }
}

/// Document that a journal can hold.
pub trait JournalDocument:
    Editable<Edit: Serialize + serde::de::DeserializeOwned + 'static> + Clone
{
    /// Kind of the document, as files give it.
    const KIND: &'static str;

    /// Image of the whole document, as JSON.
    ///
    /// # Errors
    /// The document holds values that JSON cannot, which no document does.
    fn to_image(&self) -> serde_json::Result<String>;

    /// Reads the document that [`to_image`](Self::to_image) wrote.
    ///
    /// # Errors
    /// The text is no image of such a document.
    fn from_image(text: &str) -> serde_json::Result<Self>;
}

macro_rules! journaled {
    ($document:ty, $kind:literal) => {
        impl JournalDocument for $document {
            const KIND: &'static str = $kind;

            fn to_image(&self) -> serde_json::Result<String> {
                serde_json::to_string(self)
            }

            fn from_image(text: &str) -> serde_json::Result<Self> {
                serde_json::from_str(text)
            }
        }
    };
}

journaled!(Look, "look");
journaled!(Scene, "scene");
journaled!(Shot, "shot");

impl JournalDocument for Hcbtf {
    const KIND: &'static str = "hcbtf";

    fn to_image(&self) -> serde_json::Result<String> {
        let mut text = Vec::new();
        HcbtfImage::serialize(self, &mut serde_json::Serializer::new(&mut text))?;
        Ok(String::from_utf8_lossy(&text).into_owned())
    }

    fn from_image(text: &str) -> serde_json::Result<Self> {
        HcbtfImage::deserialize(&mut serde_json::Deserializer::from_str(text))
    }
}

/// Serialization of an HCBTF within edits.
pub(super) mod of_hcbtf {
    use serde::{Deserializer, Serializer};

    use super::HcbtfImage;
    use crate::document::Hcbtf;

    pub(in crate::document) fn serialize<S: Serializer>(
        hcbtf: &Hcbtf,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        HcbtfImage::serialize(hcbtf, serializer)
    }

    pub(in crate::document) fn deserialize<'de, D: Deserializer<'de>>(
        source: D,
    ) -> Result<Box<Hcbtf>, D::Error> {
        HcbtfImage::deserialize(source).map(Box::new)
    }
}

/// Serialization of an optional tile.
pub(super) mod of_tile {
    use std::sync::Arc;

    use chiaro_locale::tr;
    use serde::de::Error as _;
    use serde::{Deserialize as _, Deserializer, Serialize as _, Serializer};

    use super::PackedTile;
    use crate::document::Tile;

    pub(in crate::document) fn serialize<S: Serializer>(
        tile: &Option<Arc<Tile>>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        tile.as_ref().map(|tile| PackedTile::new(tile)).serialize(serializer)
    }

    pub(in crate::document) fn deserialize<'de, D: Deserializer<'de>>(
        source: D,
    ) -> Result<Option<Arc<Tile>>, D::Error> {
        let unpack = |packed: PackedTile| {
            packed.tile().map(Arc::new).ok_or_else(|| D::Error::custom(tr!("a damaged tile")))
        };
        Option::<PackedTile>::deserialize(source)?.map(unpack).transpose()
    }
}
