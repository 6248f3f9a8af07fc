//! The look that a painting was seen in last, for the way back from other looks.

use std::path::PathBuf;

use crate::document::Look;
use crate::state::orbit::Orbit;
use crate::state::revision::DocumentNumber;

/// A look that showed what is painted, as it was when another one was opened.
#[derive(Clone, Debug)]
pub(crate) struct Home {
    /// Which document it was.
    pub(crate) document: DocumentNumber,
    /// Its file, or that of the scene around it.
    pub(crate) path: Option<PathBuf>,
    pub(crate) look: Look,
    /// Where it was seen from, and on what.
    pub(crate) view: Orbit,
}

impl Home {
    /// What people call it.
    pub(crate) fn name(&self) -> String {
        match self.path.as_ref().and_then(|path| path.file_name()) {
            Some(name) => name.to_string_lossy().into_owned(),
            None => self.look.name.clone(),
        }
    }
}
