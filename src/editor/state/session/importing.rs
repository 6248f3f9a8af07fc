//! Looks of other programs' graphs.

use std::path::Path;

use chiaro_locale::trn;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{Edit, read_text};
use crate::import::{GraphFile, anchor_images, import_graph};

impl Session {
    /// Kind of another program's graph that a file is; `None` for our own documents, and for what
    /// cannot be read.
    pub(crate) fn graph_file(&self, path: &Path) -> Option<GraphFile> {
        let kind = GraphFile::of(path)?;
        if kind == GraphFile::MaterialX {
            return Some(kind);
        }
        let text = read_text(&**self.assets.source(), path).ok()?;
        GraphFile::is_blender(&text).then_some(kind)
    }

    /// Begins a new look with what another program's graph holds, as one step that can be undone.
    /// Gives a sentence on the look; what came as a note is among its problems.
    ///
    /// # Errors
    /// Problems that keep the file from being imported; the open documents stay then.
    pub(crate) fn import(
        &mut self,
        path: &Path,
        kind: GraphFile,
    ) -> Result<String, Vec<Diagnostic>> {
        let text = read_text(&**self.assets.source(), path).map_err(|problem| vec![*problem])?;
        let file = path.display().to_string();
        let imported = import_graph(&text, &file, kind, &self.project.library)?;
        let (mut look, warnings) = imported.into_parts();
        // The look has no file yet from which relative paths lead.
        if let Some(folder) = std::path::absolute(path).ok().as_deref().and_then(Path::parent) {
            anchor_images(&mut look, folder);
        }
        let (nodes, notes) = (look.graph.nodes.len(), look.graph.notes.len());
        let name = look.name.clone();
        self.start_new();
        let edit = Edit::Replace { look: Box::new(look) };
        self.apply(edit, None).map_err(|problem| vec![*problem])?;
        self.look.load_problems = warnings;
        self.revisions.problems.advance();
        let told = trn!(nodes, "Imported {name}: {nodes} node", "Imported {name}: {nodes} nodes");
        let noted = trn!(
            notes,
            "{notes} has no twin here and came as a note with its values",
            "{notes} have no twin here and came as notes with their values"
        );
        Ok(if notes == 0 { told } else { format!("{told}; {noted}") })
    }
}
