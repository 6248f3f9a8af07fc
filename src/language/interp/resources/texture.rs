//! Textures: texels by mip level, shared by all readers.

use std::fmt;
use std::sync::Arc;

use chiaro_locale::tr;

use crate::diag::Diagnostic;

/// Dimension of a texture: the meaning of its coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TextureDimension {
    /// One coordinate.
    D1,
    /// Two coordinates; layers are chosen by number.
    D2,
    /// Three coordinates.
    D3,
    /// Cube, whose coordinates are a direction; every six layers are the faces +x, -x, +y, -y, +z,
    /// -z of a cube.
    Cube,
}

impl TextureDimension {
    /// Number of coordinates by which the texture is sampled.
    pub(in crate::interp) fn coordinates(self) -> usize {
        match self {
            Self::D1 => 1,
            Self::D2 => 2,
            Self::D3 | Self::Cube => 3,
        }
    }
}

#[derive(Clone, Debug)]
enum Texels {
    Single(Vec<[f32; 4]>),
    Double(Vec<[f64; 4]>),
    /// Straight RGBA as bytes from 0 to 255, for 0 to 1: a texture of many layers would be eight
    /// times as large else.
    Bytes(Vec<u8>),
}

/// Mip level: width, height, and depth or number of layers; texels by rows from the top, layer
/// after layer.
#[derive(Clone, Debug)]
pub struct TextureLevel {
    size: [u32; 3],
    texels: Texels,
}

impl TextureLevel {
    /// Level of RGBA texels in f32; textures of fewer channels have 0, 0 and 1 in the rest,
    /// integers their values.
    pub fn f32(size: [u32; 3], texels: Vec<[f32; 4]>) -> Self {
        Self { size, texels: Texels::Single(texels) }
    }

    /// Level of RGBA texels in f64, as [`f32`](Self::f32).
    pub fn f64(size: [u32; 3], texels: Vec<[f64; 4]>) -> Self {
        Self { size, texels: Texels::Double(texels) }
    }

    /// Level of RGBA texels as bytes, four each, which stand for 0 to 1.
    pub fn rgba8(size: [u32; 3], bytes: Vec<u8>) -> Self {
        Self { size, texels: Texels::Bytes(bytes) }
    }

    /// Width, height, and depth or number of layers.
    pub fn size(&self) -> [u32; 3] {
        self.size
    }

    /// Texel at x, y and z (or layer), which must lie inside.
    pub fn texel(&self, [x, y, z]: [u32; 3]) -> [f64; 4] {
        let [width, height, _] = self.size.map(|n| n as usize);
        let index = (z as usize * height + y as usize) * width + x as usize;
        match &self.texels {
            Texels::Single(texels) => texels[index].map(f64::from),
            Texels::Double(texels) => texels[index],
            Texels::Bytes(bytes) => {
                std::array::from_fn(|channel| f64::from(bytes[4 * index + channel]) / 255.0)
            }
        }
    }

    fn count(&self) -> usize {
        match &self.texels {
            Texels::Single(texels) => texels.len(),
            Texels::Double(texels) => texels.len(),
            Texels::Bytes(bytes) => bytes.len() / 4,
        }
    }
}

/// Texture. A clone shares the texels.
#[derive(Clone)]
pub struct Texture {
    dimension: TextureDimension,
    levels: Arc<[TextureLevel]>,
}

impl fmt::Debug for Texture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.levels[0].size;
        write!(f, "Texture({:?}, {size:?}, {} levels)", self.dimension, self.levels.len())
    }
}

impl Texture {
    /// Texture of mip levels, the largest first, each half as large as the one before.
    ///
    /// # Errors
    /// `interp-texture`: there is no level, or a level of another size or number of texels than it
    /// must have.
    pub fn new(dimension: TextureDimension, levels: Vec<TextureLevel>) -> Result<Self, Diagnostic> {
        let wrong = |message: String| Err(Diagnostic::error("interp-texture", message));
        let Some(first) = levels.first() else {
            return wrong(tr!("a texture needs at least one level").to_owned());
        };
        let [width, height, depth] = first.size;
        let fits = match dimension {
            TextureDimension::D1 => height == 1 && depth == 1,
            TextureDimension::D2 | TextureDimension::D3 => true,
            TextureDimension::Cube => width == height && depth.is_multiple_of(6),
        };
        if !fits || first.size.contains(&0) {
            return wrong(tr!("a texture of {dimension:?} cannot be {width} x {height} x {depth}"));
        }
        for (index, level) in levels.iter().enumerate() {
            let half = |n: u32| n.checked_shr(index as u32).unwrap_or(0).max(1);
            let layers = if dimension == TextureDimension::D3 { half(depth) } else { depth };
            let expected = [half(width), half(height), layers];
            if level.size != expected {
                return wrong(tr!(
                    "level {index} must be {expected:?} texels large, and is {size:?}",
                    size = level.size
                ));
            }
            let count = expected.iter().map(|&n| u128::from(n)).product::<u128>();
            if level.count() as u128 != count {
                return wrong(tr!(
                    "level {index} has {texels} texels, and needs {count}",
                    texels = level.count()
                ));
            }
        }
        Ok(Self { dimension, levels: levels.into() })
    }

    /// Flat texture of one level, by rows from the top.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn flat(size: [u32; 2], texels: Vec<[f32; 4]>) -> Result<Self, Diagnostic> {
        Self::new(TextureDimension::D2, vec![TextureLevel::f32([size[0], size[1], 1], texels)])
    }

    /// Dimension of the texture.
    pub fn dimension(&self) -> TextureDimension {
        self.dimension
    }

    /// Mip levels, the largest first; at least one.
    pub fn levels(&self) -> &[TextureLevel] {
        &self.levels
    }

    /// Number of layers, or of whole cubes.
    pub fn layers(&self) -> u32 {
        match self.dimension {
            TextureDimension::D1 | TextureDimension::D3 => 1,
            TextureDimension::D2 => self.levels[0].size[2],
            TextureDimension::Cube => self.levels[0].size[2] / 6,
        }
    }
}
