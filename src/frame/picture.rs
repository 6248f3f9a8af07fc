//! What comes out, whoever draws it.

/// A finished picture: straight RGBA, display-referred, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels.
    pub size: [u32; 2],
    /// Row by row.
    pub rgba: Vec<[f32; 4]>,
}

impl Picture {
    /// Eight bits a channel, rounded.
    pub fn to_rgba8(&self) -> Vec<u8> {
        let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
        self.rgba.iter().flat_map(|pixel| pixel.map(byte)).collect()
    }

    /// A pixel by column and row.
    pub fn pixel(&self, x: u32, y: u32) -> [f32; 4] {
        self.rgba[(y * self.size[0] + x) as usize]
    }
}
