//! naga's front end and validator, called from here only.

use std::ops::Range;

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

/// Module that naga accepts, with the results of its validator.
#[derive(Debug)]
pub struct ValidModule {
    /// IR of the module.
    pub module: naga::Module,
    /// Side tables of the validator.
    pub info: ModuleInfo,
}

/// Error of a text that is refused, by naga or before it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct WgslError {
    /// Description of the error, in naga's words where naga refuses the text.
    pub message: String,
    /// Byte range that the message is about, where it is known.
    pub span: Option<Range<usize>>,
}

/// Parses and validates `source`.
///
/// # Errors
/// The error that naga reports, with the place.
pub fn parse(source: &str) -> Result<ValidModule, WgslError> {
    #[expect(clippy::disallowed_methods, reason = "the one place that calls naga's front end")]
    let module = naga::front::wgsl::parse_str(source).map_err(|error| WgslError {
        message: error.message().to_owned(),
        span: error.labels().next().and_then(|(span, _)| span.to_range()),
    })?;
    validate(module)
}

/// Validates a module.
///
/// # Errors
/// The error that naga reports, with the place and every cause below it.
pub fn validate(module: naga::Module) -> Result<ValidModule, WgslError> {
    #[expect(clippy::disallowed_methods, reason = "the one place that calls naga's validator")]
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    match validator.validate(&module) {
        Ok(info) => Ok(ValidModule { module, info }),
        Err(error) => {
            // naga reports the function and the parts inside it; the innermost place is the one to
            // mend.
            let spans = error.spans().filter_map(|(span, _)| span.to_range());
            let span = spans.min_by_key(ExactSizeIterator::len);
            let mut message = error.as_inner().to_string();
            let mut cause = std::error::Error::source(error.as_inner());
            while let Some(inner) = cause {
                message += &format!(": {inner}");
                cause = inner.source();
            }
            Err(WgslError { message, span })
        }
    }
}
