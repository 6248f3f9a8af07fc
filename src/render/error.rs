//! What a GPU cannot do, told so that the user can go on.

use crate::diag::Diagnostic;
use crate::frame::SHORTEN;

/// Why something was not drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// No adapter.
    #[error("no GPU was found, nor a software renderer: {message}")]
    NoAdapter {
        /// What the system says.
        message: String,
    },
    /// The device is gone.
    #[error("the GPU was lost: {message}")]
    Lost {
        /// What the system says.
        message: String,
    },
    /// There is not enough memory.
    #[error("the GPU has not enough memory for {what}")]
    OutOfMemory {
        /// For what.
        what: String,
    },
    /// A limit of the adapter.
    #[error("{what} is {size}, and this GPU allows at most {limit}")]
    TooLarge {
        /// What is too large.
        what: String,
        /// How large.
        size: u64,
        /// How large it may be.
        limit: u64,
    },
    /// The shader is more than a driver's compiler is handed.
    #[error("{message}")]
    TooDeep {
        /// How deep the shader is, and how deep it may be.
        message: String,
    },
    /// A mistake of ours.
    #[error("the GPU refused our work: {message}")]
    Refused {
        /// What it says.
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
            RenderError::TooDeep { .. } => ("deep-shader", SHORTEN),
            RenderError::Refused { .. } => {
                ("gpu-refused", "this is a mistake in Chiaro: please report the look")
            }
        };
        Self::error(code, error.to_string()).hint(hint)
    }
}
