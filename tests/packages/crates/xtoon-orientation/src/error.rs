//! Reasons why a material or a mesh cannot be made.

use std::fmt;

/// Reason why a material or a mesh cannot be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// The target would encode colors that are encoded already.
    Encoding {
        /// Format of the target.
        format: wgpu::TextureFormat,
    },
    /// A mesh cannot be drawn.
    Mesh {
        /// Reason in words.
        reason: String,
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
            Self::Encoding { format } => write!(
                f,
                "{format:?} encodes colors as sRGB, and those of Encoding::Shown are encoded: \
                 take Encoding::Linear, or a view of the format {:?}",
                format.remove_srgb_suffix()
            ),
            Self::Mesh { reason } => write!(f, "the mesh cannot be drawn: {reason}"),
            Self::Image { file, reason } => write!(f, "the image {file} cannot be read: {reason}"),
        }
    }
}

impl std::error::Error for Error {}
