//! Errors of the GPU, with hints for the user.

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::frame::SHORTEN;

/// Size that a GPU limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitedSize {
    /// Greater side of the picture, in pixels.
    PictureSide,
    /// Greater side of an image, in pixels.
    ImageSide,
    /// Number of layers of an HCBTF's texture.
    HcbtfLayers,
    /// Number of layers of the picture.
    PictureLayers,
    /// Length of all uniforms of the picture, in bytes.
    UniformBytes,
    /// Length of the picture as it is read back, in bytes.
    PictureBytes,
}

impl LimitedSize {
    /// Sentence on a size above a GPU's limit.
    fn above(self, size: u64, limit: u64) -> String {
        match self {
            Self::PictureSide => {
                tr!("a side of the picture has {size} pixels; this GPU allows at most {limit}")
            }
            Self::ImageSide => {
                tr!("a side of an image has {size} pixels; this GPU allows at most {limit}")
            }
            Self::HcbtfLayers => {
                tr!("a painted surface (HCBTF) has {size} layers; this GPU allows at most {limit}")
            }
            Self::PictureLayers => {
                tr!("the picture has {size} layers; this GPU allows at most {limit}")
            }
            Self::UniformBytes => {
                tr!("the uniforms of this picture take {size} bytes; at most {limit} are possible")
            }
            Self::PictureBytes => {
                tr!("the picture takes {size} bytes; this GPU allows at most {limit}")
            }
        }
    }
}

/// Reason why a plan was not drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// The system has no adapter.
    #[error("{}", tr!("no GPU was found, nor a software renderer: {message}"))]
    NoAdapter {
        /// Message of the system.
        message: String,
    },
    /// The device was lost.
    #[error("{}", tr!("the GPU was lost: {message}"))]
    Lost {
        /// Message of the system.
        message: String,
    },
    /// There is not enough memory.
    #[error("{message}")]
    OutOfMemory {
        /// Description of what does not fit.
        message: String,
    },
    /// A size exceeds a limit of the adapter.
    #[error("{}", what.above(*size, *limit))]
    TooLarge {
        /// Size that is too large.
        what: LimitedSize,
        /// The size.
        size: u64,
        /// Largest size that the adapter allows.
        limit: u64,
    },
    /// The shader is nested too deeply to be handed to a driver's compiler.
    #[error("{message}")]
    TooDeep {
        /// Description of the shader's depth and of the limit.
        message: String,
    },
    /// The validation refused our commands: a mistake of ours.
    #[error("{}", tr!("the GPU refused our work: {message}"))]
    Refused {
        /// Message of the validation.
        message: String,
    },
}

impl RenderError {
    /// Error of a module that has a binding for which the plan has nothing.
    pub(crate) fn unbound(binding: &str) -> Self {
        Self::Refused { message: tr!("nothing to bind to `{binding}`") }
    }
}

impl From<RenderError> for Diagnostic {
    fn from(error: RenderError) -> Self {
        let (code, hint) = match &error {
            RenderError::NoAdapter { .. } => (
                "no-gpu",
                tr!("install a Vulkan driver; on Debian without a GPU: apt install \
                     mesa-vulkan-drivers libvulkan1"),
            ),
            RenderError::Lost { .. } => {
                ("gpu-lost", tr!("nothing of the document is lost: save it and start again"))
            }
            RenderError::OutOfMemory { .. } => {
                ("gpu-memory", tr!("use a smaller picture, smaller images or fewer samples"))
            }
            RenderError::TooLarge { .. } => ("gpu-limit", tr!("use a smaller one")),
            RenderError::TooDeep { .. } => ("deep-shader", SHORTEN.tr()),
            RenderError::Refused { .. } => {
                ("gpu-refused", tr!("this is a mistake in Chiaro: please report the look"))
            }
        };
        Self::error(code, error.to_string()).hint(hint)
    }
}
