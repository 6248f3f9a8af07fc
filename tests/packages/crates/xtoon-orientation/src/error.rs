//! Reasons why a material cannot be made.

use std::fmt;

/// Reason why the material cannot be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// The target would encode or decode the look's colors.
    Encoding {
        /// Format of the target.
        output: wgpu::TextureFormat,
        /// Format that takes the colors as they are.
        expected: wgpu::TextureFormat,
    },
    /// An image of the look cannot be read.
    Image {
        /// Name of the file.
        file: &'static str,
        /// Reason in words.
        reason: String,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Encoding { output, expected } => write!(
                f,
                "the target's format {output:?} changes the look's colors: draw into a view of \
                 the format {expected:?}"
            ),
            Self::Image { file, reason } => write!(f, "the image {file} cannot be read: {reason}"),
        }
    }
}

impl std::error::Error for Error {}
