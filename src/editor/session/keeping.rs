//! What keeps a session's work: its journal, and what another program did to its file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::super::catalog::Catalog;
use super::super::safety::keeper::{Keeper, Standing};
use super::Session;
use crate::diag::Diagnostic;
use crate::document::journal::{About, LookOp, Recovered, Slot};
use crate::document::{Edit, Look, read_text};
use crate::ids::NodePath;
use crate::library::Library;

/// A look's journal, and what is not sent to it yet.
#[derive(Default)]
pub(super) struct Keeping {
    keeper: Option<Keeper>,
    ops: Vec<LookOp>,
    /// What the file holds by another program's hand and may be written over.
    overridden: Option<String>,
}

/// How the file is compared with what was read from it or written to it last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum OnDisk {
    Same,
    /// There is no file, or none yet.
    Gone,
    /// Another text.
    Changed(String),
    /// It cannot be read at this moment.
    Unreadable,
}

impl Keeping {
    /// Notes what was done, if anything is kept.
    pub(super) fn note(&mut self, op: Option<LookOp>) {
        if self.keeper.is_some() {
            self.ops.extend(op);
        }
    }

    /// Whether edits are noted, so that one must be kept before it is applied.
    pub(super) fn is_on(&self) -> bool {
        self.keeper.is_some()
    }
}

impl Session {
    /// Keeps the journal of unsaved work in a folder from now on. `wake` is called from another thread when that fails,
    /// or works again.
    pub fn keep_in(&mut self, folder: &Path, wake: impl Fn() + Send + 'static) {
        self.keeping.keeper = Some(Keeper::new(folder.to_owned(), wake));
        if self.is_dirty() {
            self.begin_journal(None);
        }
    }

    /// Hands what was done since the last call to the journal; a gesture that goes on may wait for a moment there.
    pub fn commit(&mut self, goes_on: bool) {
        let is_dirty = self.is_dirty();
        let Some(keeper) = &mut self.keeping.keeper else { return };
        let is_asked = keeper.has_begun && keeper.wants_to_begin() && is_dirty;
        if is_asked || !self.keeping.ops.is_empty() && keeper.wants_to_begin() {
            self.begin_journal(None);
        } else {
            keeper.add(std::mem::take(&mut self.keeping.ops), goes_on);
        }
    }

    /// Waits until the system has all that was handed over; for tests, and before something is put away.
    pub fn wait_for_journal(&self) {
        if let Some(keeper) = &self.keeping.keeper {
            keeper.wait();
        }
    }

    /// Why unsaved work is not kept, if it should be and is not.
    pub(crate) fn keeping_problem(&self) -> Option<Diagnostic> {
        self.keeping.keeper.as_ref().and_then(Keeper::problem)
    }

    /// Whether closing or another document would lose nothing, once all is handed over.
    pub(crate) fn keeps_work(&mut self) -> bool {
        self.commit(false);
        self.wait_for_journal();
        self.keeping.keeper.as_ref().is_some_and(|keeper| keeper.problem().is_none())
    }

    /// Begins the journal with the look as it stands.
    pub(super) fn begin_journal(&mut self, slot: Option<Slot>) {
        self.keeping.ops.clear();
        if self.keeping.keeper.is_none() {
            return;
        }
        let path = self.path().map(|path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned()));
        let file_name = path.as_ref().and_then(|path| path.file_name()).map(|name| name.to_string_lossy().into_owned());
        let about = About {
            name: file_name.unwrap_or_else(|| "New look".to_owned()),
            path: path.as_ref().and_then(|path| path.to_str()).map(str::to_owned),
            is_partial: self.is_partial,
            window: serde_json::json!({ "mesh": self.view.mesh }),
        };
        let source = self.path.is_some().then(|| self.source.text().clone());
        let standing = Standing { about, source, history: self.history.clone(), slot };
        if let Some(keeper) = &mut self.keeping.keeper {
            keeper.begin(standing);
        }
    }

    /// After a save the journal begins anew: with the same past, and nothing unsaved.
    pub(super) fn saved(&mut self) {
        self.keeping.overridden = None;
        if self.history.steps() == (0, 0) {
            self.keeping.ops.clear();
        } else {
            self.begin_journal(None);
        }
    }

    /// Lets go of the journal before another document comes: it stays if anything in it is not saved.
    pub(crate) fn leave_journal(&mut self, in_peace: bool) {
        self.commit(false);
        self.keeping.overridden = None;
        let is_dirty = self.is_dirty();
        if let Some(keeper) = &mut self.keeping.keeper {
            match is_dirty {
                true => keeper.leave(in_peace),
                false => keeper.discard(),
            }
            keeper.wait();
        }
    }

    /// Closes the journal as a window that is closed does; nothing is kept any more after that.
    pub fn close_journal(&mut self, in_peace: bool) {
        self.leave_journal(in_peace);
        self.keeping.keeper = None;
    }

    /// Takes work back that a journal gave: the document, its file, and all that can be undone and redone. The journal
    /// goes on where it is.
    pub(crate) fn take_back(&mut self, found: Recovered<Look>, slot: Slot) {
        let path = found.about.path.as_ref().map(PathBuf::from);
        let name = found.about.path.as_deref().unwrap_or("new look");
        let source = Look::read(found.source.as_deref().unwrap_or("{}"), name).source;
        match &path {
            Some(path) => self.use_project(path),
            None => self.use_library(Library::built_in().clone()),
        }
        if let Some(mesh) = found.about.window.get("mesh").and_then(serde_json::Value::as_str) {
            mesh.clone_into(&mut self.view.mesh);
        }
        self.replace(found.history.document().clone(), source, path);
        self.history = found.history;
        self.is_partial = found.about.is_partial;
        self.load_problems = found.damage;
        self.begin_journal(Some(slot));
    }

    /// Compares the look's file with what it held when it was read or written last.
    pub(crate) fn on_disk(&self) -> OnDisk {
        let Some(path) = &self.path else { return OnDisk::Same };
        match read_text(path) {
            Ok(text) if text == **self.source.text() => OnDisk::Same,
            Ok(text) if self.keeping.overridden.as_ref() == Some(&text) => OnDisk::Same,
            Ok(text) => OnDisk::Changed(text),
            Err(_) if !path.exists() => OnDisk::Gone,
            Err(_) => OnDisk::Unreadable,
        }
    }

    /// Takes what another program made of the file, as one step that can be undone. View and selection stay. Returns
    /// whether it could be read without an error; else the look stays as it is, and the problems are told.
    pub(crate) fn reload(&mut self, text: &str) -> bool {
        let file = self.path.as_ref().map(|path| path.display().to_string()).unwrap_or_default();
        let loaded = Look::read(text, &file);
        self.problems_number += 1;
        let has_errors = loaded.has_errors();
        self.load_problems = loaded.diagnostics;
        let Some(look) = loaded.value.filter(|_| !has_errors) else { return false };
        if look.to_text() != self.look().to_text()
            && let Err(problem) = self.apply(Edit::Replace { look: Box::new(look) }, None)
        {
            self.load_problems.push(*problem);
            return false;
        }
        self.source = Arc::new(loaded.source);
        self.opened = self.source.clone();
        self.is_partial = false;
        self.history.mark_saved();
        self.saved();
        true
    }

    /// Lets saving write over what another program wrote.
    pub(crate) fn keep_mine(&mut self, theirs: String) {
        self.keeping.overridden = Some(theirs);
    }

    /// Reads the project's own nodes again. Where a file is broken now, the look goes on with the node as it was.
    pub(crate) fn reload_library(&mut self) {
        let Some(path) = self.path.clone() else { return };
        let before = self.library.clone();
        self.use_project(&path);
        let broken = self.library.problems.iter().filter_map(kind_of).map(str::to_owned);
        let lost: Vec<String> = broken.filter(|kind| !self.library.nodes.contains_key(kind)).collect();
        for kind in lost {
            if let Some(node) = before.nodes.get(&kind) {
                Arc::make_mut(&mut self.library).nodes.insert(kind, node.clone());
            }
        }
        self.catalog = Catalog::new(&self.library);
        self.catalog.sync(self.history.document(), &self.library);
        self.place_library_problems();
        self.shaders.structure_changed();
        // What was probed or compared was so with the nodes of before.
        self.files_changed();
    }

    /// Tells what is wrong with node files at a node of theirs, where the look has one.
    pub(super) fn place_library_problems(&mut self) {
        let nodes = &self.history.document().graph.nodes;
        let placed = self.library.problems.iter().cloned().map(|mut problem| {
            let used = kind_of(&problem).and_then(|kind| nodes.iter().find(|(_, node)| node.kind == kind));
            problem.place.node = used.map(|(id, _)| NodePath::root(id.clone()));
            problem
        });
        self.library_problems = placed.collect();
        self.problems_number += 1;
    }

    /// Draws again with files that changed: meshes and images are read anew where their files are others.
    pub(crate) fn files_changed(&mut self) {
        self.files += 1;
        self.picture += 1;
    }

    /// How often files that the look uses have changed.
    pub(crate) fn files(&self) -> u64 {
        self.files
    }

    pub(super) fn use_library(&mut self, library: Library) {
        self.library = Arc::new(library);
        self.catalog = Catalog::new(&self.library);
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // A window that panics is not closed in peace: what it was at may be what broke it.
        self.close_journal(!std::thread::panicking());
    }
}

/// The kind of node that a problem's file is about.
fn kind_of(problem: &Diagnostic) -> Option<&str> {
    Path::new(problem.place.file.as_deref()?).file_stem()?.to_str()
}
