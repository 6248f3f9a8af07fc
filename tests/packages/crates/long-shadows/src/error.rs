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
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Encoding { output, expected } => write!(
                f,
                "the target's format {output:?} changes the look's colors: draw into a view of \
                 the format {expected:?}"
            ),
        }
    }
}

impl std::error::Error for Error {}
