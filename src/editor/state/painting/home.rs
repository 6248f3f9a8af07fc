//! The look that a painting was last seen in, for the way back from other looks.

use std::path::PathBuf;

use super::look;
use crate::catalog::Catalog;
use crate::document::Look;
use crate::state::orbit::Orbit;
use crate::state::revision::DocumentNumber;

/// A look that showed the painting, in its state when another look was opened.
#[derive(Clone, Debug)]
pub(crate) struct Home {
    /// Number of the look's document.
    pub(crate) document: DocumentNumber,
    /// File of the look, or of the scene around it.
    pub(crate) path: Option<PathBuf>,
    pub(crate) look: Look,
    /// View of the look, and the mesh that it was seen on.
    pub(crate) view: Orbit,
}

impl Home {
    /// Names the HCBTF `to` wherever the look names it `from`.
    pub(crate) fn rename_painting(&mut self, catalog: &Catalog, from: &str, to: &str) {
        for edit in look::rename(&self.look, catalog, from, to) {
            // An edit that is impossible with this catalog is left out.
            let _ = self.look.apply(edit);
        }
    }

    /// Display name of the look.
    pub(crate) fn name(&self) -> String {
        match self.path.as_ref().and_then(|path| path.file_name()) {
            Some(name) => name.to_string_lossy().into_owned(),
            None => self.look.name.clone(),
        }
    }
}
