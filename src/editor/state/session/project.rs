//! The project that the look is of: the folder that it lies in, with nodes of its own, and that of
//! the scene around it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Session;
use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::document::remove_abandoned;
use crate::ids::NodePath;
use crate::library::Library;

impl Session {
    /// What is in no folder has no nodes but those that Chiaro ships.
    pub(super) fn leave_project(&mut self) {
        if self.path.is_some() || self.stage.is_some() {
            self.use_library(Library::built_in().clone());
        }
    }

    pub(super) fn use_project(&mut self, path: &Path) {
        remove_abandoned(path.parent().unwrap_or(Path::new("")));
        let mut library = Library::built_in().clone();
        for nodes in self.node_folders_with(Some(path)) {
            if nodes.is_dir() {
                library = library.with_project(&nodes);
            }
        }
        self.use_library(library);
    }

    /// The folders that the project's own nodes come from, be they there or not: those beside the
    /// look stand before those beside the scene that it is in, and so come later.
    pub(crate) fn node_folders(&self) -> Vec<PathBuf> {
        self.node_folders_with(self.path())
    }

    fn node_folders_with(&self, look: Option<&Path>) -> Vec<PathBuf> {
        let beside = |path: &Path| path.parent().unwrap_or(Path::new("")).join("nodes");
        let own = look.map(beside);
        let of_scene = self.stage.as_ref().and_then(|stage| stage.path()).map(beside);
        of_scene.filter(|nodes| own.as_ref() != Some(nodes)).into_iter().chain(own).collect()
    }

    /// Reads the project's own nodes again. Where a file is broken now, the look goes on with the
    /// node as it was.
    pub(crate) fn reload_library(&mut self) {
        let of_scene = || self.stage.as_ref().and_then(|stage| stage.path()).map(Path::to_path_buf);
        let Some(path) = self.path.clone().or_else(of_scene) else { return };
        let before = self.library.clone();
        self.use_project(&path);
        let broken = self.library.problems.iter().filter_map(kind_of).map(str::to_owned);
        let lost: Vec<String> =
            broken.filter(|kind| !self.library.nodes.contains_key(kind)).collect();
        for kind in lost {
            if let Some(node) = before.nodes.get(&kind) {
                Arc::make_mut(&mut self.library).nodes.insert(kind, node.clone());
            }
        }
        self.catalog = Catalog::new(&self.library);
        self.catalog.sync(self.kept.history.document(), &self.library);
        self.place_library_problems();
        self.shaders.structure_changed();
        // What was probed or compared was so with the nodes of before.
        self.files_changed();
    }

    /// Tells what is wrong with node files at a node of theirs, where the look has one.
    pub(super) fn place_library_problems(&mut self) {
        let nodes = &self.kept.history.document().graph.nodes;
        let placed = self.library.problems.iter().cloned().map(|mut problem| {
            let used =
                kind_of(&problem).and_then(|kind| nodes.iter().find(|(_, node)| node.kind == kind));
            problem.place.node = used.map(|(id, _)| NodePath::root(id.clone()));
            problem
        });
        self.library_problems = placed.collect();
        self.problems_number += 1;
    }

    pub(super) fn use_library(&mut self, library: Library) {
        self.library = Arc::new(library);
        self.catalog = Catalog::new(&self.library);
    }
}

/// The kind of node that a problem's file is about.
fn kind_of(problem: &Diagnostic) -> Option<&str> {
    Path::new(problem.place.file.as_deref()?).file_stem()?.to_str()
}
