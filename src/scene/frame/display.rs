//! Display of pictures by other means than the curve of sRGB.

/// WGSL that says what a display shows of light, with all that it reads.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayModule {
    /// Text that defines [`FUNCTION`](Self::FUNCTION), from linear light with the primaries of
    /// Rec. 709 to the numbers of the display; alpha goes through.
    pub text: String,
    /// Content of the uniform buffer, with its binding.
    pub uniforms: Option<(u32, Vec<u8>)>,
    /// Tables that the text reads.
    pub tables: Vec<DisplayTable>,
}

impl DisplayModule {
    /// Name of the function, of a `vec4<f32>`.
    pub const FUNCTION: &'static str = "shown_by_view";
    /// Group of the module's bindings.
    pub const GROUP: u32 = 1;
}

/// Table of a [`DisplayModule`]: a texture of 32-bit floats that is loaded and not filtered.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayTable {
    /// Binding of the texture.
    pub binding: u32,
    /// Number of dimensions: 1, 2 or 3.
    pub dimensions: u32,
    /// Width, height and depth, in texels.
    pub size: [u32; 3],
    /// True if a texel is a color of four numbers, false if it is one number.
    pub has_colors: bool,
    /// The texels as little endian bytes, row by row.
    pub texels: Vec<u8>,
}
