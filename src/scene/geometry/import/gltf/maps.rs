//! Maps of glTF materials, where they lie, and the pictures within files.
//!
//! A mesh has one UV a vertex here. They are those by which the part's own material lays its
//! pictures: of the set of coordinates that it names, moved as `KHR_texture_transform` says. So a
//! look's image lies where the file's does, and UVs that a tool has packed into whole numbers come
//! out as they were. Of a material whose pictures lie differently the first one counts.
//!
//! What is wrong in a material or a texture is left out: it keeps no triangle from being used.

use std::collections::HashMap;
use std::sync::Arc;

use chiaro_locale::tr;
use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer};
use serde_json::Value as Json;

use super::GltfMembers;
use super::buffers::{chunks, decoded_path, from_uri};
use crate::diag::Diagnostic;
use crate::geometry::import::Siblings;
use crate::geometry::import::report::{ImportProblem, ImportReport};
use crate::geometry::import::source::{Source, unreadable};
use crate::geometry::maps::{MapSource, MaterialMap, MaterialMaps, WITHIN};

/// A picture that a file names: one beside it, or within it.
#[derive(Deserialize)]
#[serde(untagged)]
pub(super) enum ImageEntry {
    Named {
        /// The URI, but for data, which may be long.
        #[serde(deserialize_with = "without_data")]
        uri: Option<String>,
    },
    Within(IgnoredAny),
}

/// The pictures that a file names; none where they are no list.
#[derive(Deserialize)]
#[serde(untagged)]
pub(super) enum ImageList {
    List(Vec<ImageEntry>),
    Other(IgnoredAny),
}

impl Default for ImageList {
    fn default() -> Self {
        Self::Other(IgnoredAny)
    }
}

fn without_data<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<String>, D::Error> {
    String::deserialize(deserializer).map(|uri| (!uri.starts_with("data:")).then_some(uri))
}

/// Greatest factor and greatest distance by which UVs are moved: what is beyond is an error of the
/// file.
const FARTHEST: f64 = 1e6;

/// Place of a material's pictures on its triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct UvPlace {
    /// Number of the set of coordinates.
    pub(super) set: u32,
    /// Matrix by which they are moved, row by row, with v down; the last column is added.
    rows: [[f64; 3]; 2],
}

impl UvPlace {
    /// The first set, unmoved.
    const PLAIN: Self = Self { set: 0, rows: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] };

    /// The place of a texture, as a material names it.
    fn of(texture: &Json) -> Self {
        let moved = &texture["extensions"]["KHR_texture_transform"];
        let set = moved["texCoord"].as_u64().or_else(|| texture["texCoord"].as_u64());
        let set = set.and_then(|set| u32::try_from(set).ok()).unwrap_or(0);
        let pair =
            |value: &Json, default: f64| [0, 1].map(|axis| value[axis].as_f64().unwrap_or(default));
        let [x, y] = pair(&moved["offset"], 0.0);
        let [su, sv] = pair(&moved["scale"], 1.0);
        // An angle of any size is one within a turn.
        let (sin, cos) = moved["rotation"].as_f64().unwrap_or(0.0).sin_cos();
        let rows = [[cos * su, sin * sv, x], [-sin * su, cos * sv, y]];
        let is_sane = rows.iter().flatten().all(|number| number.abs() <= FARTHEST);
        Self { set, rows: if is_sane { rows } else { Self::PLAIN.rows } }
    }

    /// The coordinates of a vertex, with v up, from those of the file, with v down.
    pub(super) fn uv(&self, [u, v]: [f64; 2]) -> [f32; 2] {
        let [across, down] = match self.rows == Self::PLAIN.rows {
            true => [u, v],
            false => self.rows.map(|[by_u, by_v, more]| by_u * u + by_v * v + more),
        };
        [across as f32, (1.0 - down) as f32]
    }
}

/// Maps of the file's materials and where they lie, by the materials' numbers. Equal maps are one.
pub(super) struct MapsOfFile(Vec<(Option<Arc<MaterialMaps>>, UvPlace)>);

impl MapsOfFile {
    /// The maps of a material, by its number.
    pub(super) fn of(&self, material: Option<usize>) -> Option<Arc<MaterialMaps>> {
        self.0.get(material?)?.0.clone()
    }

    /// The place of the pictures of a material, by its number.
    pub(super) fn place(&self, material: Option<usize>) -> UvPlace {
        material.and_then(|material| self.0.get(material)).map_or(UvPlace::PLAIN, |known| known.1)
    }
}

/// Reads the maps of all materials; notes what cannot be shown as the file asks.
pub(super) fn read(file: &GltfMembers, report: &mut ImportReport) -> MapsOfFile {
    let pictures = Pictures { file };
    let mut known: HashMap<String, Arc<MaterialMaps>> = HashMap::new();
    let mut apart = 0;
    let maps = file.materials.iter().map(|material| {
        let mut places = Vec::new();
        let maps = pictures.maps(material, &mut places);
        let place = places.first().copied().unwrap_or(UvPlace::PLAIN);
        apart += places.iter().filter(|other| **other != place).count();
        let key = format!("{maps:?}");
        let maps =
            (!maps.is_empty()).then(|| known.entry(key).or_insert_with(|| Arc::new(maps)).clone());
        (maps, place)
    });
    let maps = maps.collect();
    if apart > 0 {
        let message = tr!(
            "{apart} pictures of materials are moved, or lie by another set of UVs, than the first \
             one of their material; a look sees them by the UVs of that one"
        );
        report.add(Diagnostic::note("mesh-unsupported", message));
    }
    MapsOfFile(maps)
}

struct Pictures<'f> {
    file: &'f GltfMembers,
}

impl Pictures<'_> {
    /// The maps of a material, and the places of those that are pictures.
    fn maps(&self, material: &gltf::json::Material, places: &mut Vec<UvPlace>) -> MaterialMaps {
        let Ok(json) = serde_json::to_value(material) else { return MaterialMaps::new() };
        let pbr = &json["pbrMetallicRoughness"];
        let number = |value: &Json, default: f64| value.as_f64().unwrap_or(default) as f32;
        let color = |value: &Json, default: f64| -> [f32; 3] {
            std::array::from_fn(|channel| number(&value[channel], default))
        };
        let (base, emissive) = (&pbr["baseColorFactor"], &json["emissiveFactor"]);
        let [r, g, b] = color(base, 1.0);
        let [er, eg, eb] = color(emissive, 0.0);
        let rough = number(&pbr["roughnessFactor"], 1.0);
        let metal = number(&pbr["metallicFactor"], 1.0);
        let all = [
            (MaterialMap::BaseColor, &pbr["baseColorTexture"], [r, g, b, number(&base[3], 1.0)]),
            (MaterialMap::Normal, &json["normalTexture"], [1.0; 4]),
            (MaterialMap::Occlusion, &json["occlusionTexture"], [1.0; 4]),
            (MaterialMap::Emissive, &json["emissiveTexture"], [er, eg, eb, 1.0]),
            (
                MaterialMap::MetallicRoughness,
                &pbr["metallicRoughnessTexture"],
                [1.0, rough, metal, 1.0],
            ),
        ];
        let mut maps = MaterialMaps::new();
        for (map, texture, factor) in all {
            let image = self.image(texture);
            places.extend(image.is_some().then(|| UvPlace::of(texture)));
            let factor = factor.map(|x| if x.is_finite() { x.clamp(0.0, 1.0) } else { 1.0 });
            let absent = map.absent().map(|x| f32::from(x) / 255.0);
            if image.is_some() || (factor != absent && map != MaterialMap::Normal) {
                maps.insert(map, MapSource { image, factor });
            }
        }
        maps
    }

    /// The picture that a texture of a material shows.
    fn image(&self, texture: &Json) -> Option<String> {
        let texture = self.file.textures.get(texture["index"].as_u64()? as usize)?;
        let webp = &texture["extensions"]["EXT_texture_webp"]["source"];
        let number = texture["source"].as_u64().or_else(|| webp.as_u64())? as usize;
        let ImageList::List(images) = &self.file.images else { return None };
        match images.get(number)? {
            ImageEntry::Named { uri: Some(uri) } => decoded_path(uri).ok(),
            _ => Some(format!("{WITHIN}{number}")),
        }
    }
}

/// The bytes of a picture within a glTF or GLB file, by its number, undecoded.
///
/// # Errors
/// The reason why there is no such picture.
pub(crate) fn image_within(
    file: &Source,
    number: usize,
    siblings: Siblings,
    most_bytes: u64,
) -> Result<Vec<u8>, ImportProblem> {
    let problem = |message: &str| -> ImportProblem {
        Diagnostic::error("missing-asset", tr!("picture {number} {message}")).into()
    };
    let (json, binary) = match file.head(4)?.as_slice() {
        b"glTF" => chunks(file)?,
        _ => (file.clone(), None),
    };
    let json: Json = serde_json::from_slice(&json.all()?)
        .map_err(|_| problem(tr!("is of a file that is no glTF")))?;
    let image = json["images"].get(number).ok_or_else(|| problem(tr!("is not there")))?;
    let part = if let Some(uri) = image["uri"].as_str() {
        let opened = from_uri(uri, siblings);
        let opened = opened.map_err(|why| problem(&tr!("cannot be read: {why}")))?;
        Source::whole(opened).map_err(|why| ImportProblem::from(unreadable(&why)))?
    } else {
        let view = image["bufferView"].as_u64();
        let view = view.and_then(|view| json["bufferViews"].get(view as usize));
        let view = view.ok_or_else(|| problem(tr!("is nowhere in the file")))?;
        let buffer = json["buffers"].get(view["buffer"].as_u64().unwrap_or(0) as usize);
        let uri = buffer.and_then(|buffer| buffer["uri"].as_str());
        let buffer = match (uri, binary) {
            (Some(uri), _) => {
                let opened = from_uri(uri, siblings);
                let opened = opened.map_err(|why| problem(&tr!("cannot be read: {why}")))?;
                Source::whole(opened).map_err(|why| ImportProblem::from(unreadable(&why)))?
            }
            (None, Some(binary)) => binary,
            (None, None) => return Err(problem(tr!("is nowhere in the file"))),
        };
        let offset = view["byteOffset"].as_u64().unwrap_or(0);
        let length = view["byteLength"].as_u64().unwrap_or(0);
        buffer.part(offset, length).ok_or_else(|| problem(tr!("reaches beyond the file")))?
    };
    if part.length() > most_bytes {
        return Err(problem(&tr!("is larger than {most} MiB", most = most_bytes >> 20)));
    }
    part.all()
}
