//! Maps of materials: what a mesh's file says on how a surface looks, as pictures and factors.
//!
//! They shade nothing by themselves. A look reads one where an image input names it (`mesh:` and
//! the map's name), and each part of each object then has its own.

use std::collections::BTreeMap;

/// Meaning of a material's map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MaterialMap {
    /// Color of the surface and its alpha.
    BaseColor,
    /// Normals in tangent space, 0 to 1 for -1 to 1.
    Normal,
    /// Share of surrounding light that arrives, in red.
    Occlusion,
    /// Color of the light that the surface sends out.
    Emissive,
    /// Roughness in green, and metalness in blue.
    MetallicRoughness,
}

impl MaterialMap {
    /// All maps with their names in looks.
    pub const NAMES: [(Self, &'static str); 5] = [
        (Self::BaseColor, "base_color"),
        (Self::Normal, "normal"),
        (Self::Occlusion, "occlusion"),
        (Self::Emissive, "emissive"),
        (Self::MetallicRoughness, "metallic_roughness"),
    ];

    /// The map of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(_, own)| *own == name).map(|(map, _)| *map)
    }

    /// Name in looks.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(map, _)| *map == self).map_or("", |(_, name)| *name)
    }

    /// True if pictures of the map hold colors, by the sRGB curve; else they hold data.
    pub fn is_color(self) -> bool {
        matches!(self, Self::BaseColor | Self::Emissive)
    }

    /// The map where a file has none: straight RGBA of a picture that changes nothing.
    pub fn absent(self) -> [u8; 4] {
        match self {
            Self::Normal => [128, 128, 255, 255],
            Self::Emissive => [0, 0, 0, 255],
            Self::BaseColor | Self::Occlusion | Self::MetallicRoughness => [255; 4],
        }
    }
}

/// One map of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct MapSource {
    /// Picture of the surface: a path relative to the mesh's file, or [`WITHIN`] and the number of
    /// a picture in that file; `None` where the whole surface has one color.
    pub image: Option<String>,
    /// Linear RGBA that the picture, or white, is multiplied by; 0 to 1.
    pub factor: [f32; 4],
}

/// Text between a mesh's file and the number of a picture within it.
pub const WITHIN: &str = "#images/";

/// Maps that a material has, at least one.
pub type MaterialMaps = BTreeMap<MaterialMap, MapSource>;
