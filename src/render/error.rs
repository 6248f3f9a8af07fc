//! Errors of the GPU, with hints for the user.

use crate::diag::Diagnostic;
use crate::frame::SHORTEN;

/// Reason why a plan was not drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// The system has no adapter.
    #[error("no GPU was found, nor a software renderer: {message}")]
    NoAdapter {
        /// Message of the system.
        message: String,
    },
    /// The device was lost.
    #[error("the GPU was lost: {message}")]
    Lost {
        /// Message of the system.
        message: String,
    },
    /// The device has not enough memory.
    #[error("the GPU has not enough memory for {what}")]
    OutOfMemory {
        /// Name of the resource that does not fit.
        what: String,
    },
    /// A size exceeds a limit of the adapter.
    #[error("{what} is {size}, and this GPU allows at most {limit}")]
    TooLarge {
        /// Name of the size that is too large.
        what: String,
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
    #[error("the GPU refused our work: {message}")]
    Refused {
        /// Message of the validation.
        message: String,
    },
}

impl From<RenderError> for Diagnostic {
    fn from(error: RenderError) -> Self {
        let (code, hint) = match &error {
            RenderError::NoAdapter { .. } => (
                "no-gpu",
                "install a Vulkan driver; on Debian without a GPU: apt install mesa-vulkan-drivers \
                 libvulkan1",
            ),
            RenderError::Lost { .. } => {
                ("gpu-lost", "nothing of the document is lost: save it and start again")
            }
            RenderError::OutOfMemory { .. } => {
                ("gpu-memory", "use a smaller picture, smaller images or fewer samples")
            }
            RenderError::TooLarge { .. } => ("gpu-limit", "use a smaller one"),
            RenderError::TooDeep { .. } => ("deep-shader", SHORTEN.tr()),
            RenderError::Refused { .. } => {
                ("gpu-refused", "this is a mistake in Chiaro: please report the look")
            }
        };
        Self::error(code, error.to_string()).hint(hint)
    }
}
