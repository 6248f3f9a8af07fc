//! Project of the look: the folder that the look lies in, with nodes of its own, and the folder of
//! the scene around it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Session;
use super::nodes::NodesAnswer;
use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::document::{Graph, Look};
use crate::ids::NodePath;
use crate::library::Library;
use crate::state::arrangement;

impl Session {
    /// Leaves the project of a document that has no folder any more: only the nodes that Chiaro
    /// ships remain.
    pub(super) fn leave_project(&mut self) {
        if self.look.path.is_some() || self.open_scene.is_some() {
            self.leave_all_projects();
        }
    }

    /// Leaves the project as [`leave_project`](Self::leave_project) does, whether or not the
    /// previous document had a folder.
    pub(super) fn leave_all_projects(&mut self) {
        self.project.leave();
        self.project.set_library(Library::built_in().clone());
    }

    /// Goes to the project of the document at `path`: with the nodes that Chiaro ships at once, and
    /// with the project's own as soon as they are read.
    pub(super) fn use_project(&mut self, path: &Path) {
        self.leave_all_projects();
        self.read_nodes(path, false);
    }

    /// Asks for the project's own nodes, if there are any. Returns true if so.
    fn read_nodes(&mut self, path: &Path, keeps_broken: bool) -> bool {
        self.project.reader.sweep(path.parent().unwrap_or(Path::new("")).to_path_buf());
        let folders = self.node_folders_with(Some(path));
        let files = self.assets.source();
        let is_asked = folders.iter().any(|path| files.is_folder(path));
        if is_asked {
            self.project.reader.read(folders, keeps_broken);
        } else {
            self.project.leave();
        }
        is_asked
    }

    /// Takes the project's own nodes, once they are read. Returns true while they are being read: a
    /// shader compiled without them would be of other nodes.
    pub(super) fn awaits_nodes(&mut self) -> bool {
        for NodesAnswer { library, files, keeps_broken, is_change, .. } in
            self.project.reader.answers()
        {
            self.project.files = files;
            let Some(library) = library else { continue };
            self.project.has_changed |= is_change;
            self.renew_library(library, keeps_broken);
        }
        self.project.reader.is_awaited()
    }

    /// Asks for the project's own nodes again if their files have changed.
    pub(crate) fn check_nodes(&self) {
        let folders = self.node_folders();
        if !folders.is_empty() {
            self.project.reader.check(folders);
        }
    }

    /// Folders that the project's own nodes come from, whether they exist or not: nodes beside the
    /// look win over those beside the scene around it, and so come later.
    pub(crate) fn node_folders(&self) -> Vec<PathBuf> {
        self.node_folders_with(self.path())
    }

    fn node_folders_with(&self, look: Option<&Path>) -> Vec<PathBuf> {
        let beside = |path: &Path| path.parent().unwrap_or(Path::new("")).join("nodes");
        let own = look.map(beside);
        let of_scene =
            self.open_scene.as_ref().and_then(|open_scene| open_scene.path()).map(beside);
        of_scene.filter(|nodes| own.as_ref() != Some(nodes)).into_iter().chain(own).collect()
    }

    /// Reads the project's own nodes again. Where a file is broken now, the look goes on with the
    /// node as it was.
    pub(crate) fn reload_library(&mut self) {
        let of_scene = || {
            self.open_scene.as_ref().and_then(|open_scene| open_scene.path()).map(Path::to_path_buf)
        };
        let Some(path) = self.look.path.clone().or_else(of_scene) else { return };
        if !self.read_nodes(&path, true) {
            self.renew_library(Library::built_in().clone(), true);
        }
    }

    /// Tells all problems again, in the language that is spoken now. Words are made where a problem
    /// is found: documents, nodes and what pictures are drawn of are read again, and the look is
    /// compiled again.
    pub(crate) fn tell_again(&mut self) {
        self.look.tell_again();
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.tell_again();
        }
        self.revisions.problems.advance();
        let folders = self.node_folders();
        if folders.iter().any(|folder| self.assets.source().is_folder(folder)) {
            self.project.reader.read(folders, true);
        } else {
            self.renew_library(Library::built_in().clone(), true);
        }
    }

    fn renew_library(&mut self, library: Library, keeps_broken: bool) {
        let before = self.project.library.clone();
        self.project.set_library(library);
        if keeps_broken {
            let broken =
                self.project.library.problems.iter().filter_map(kind_of).map(str::to_owned);
            let lost: Vec<String> =
                broken.filter(|kind| !self.project.library.nodes.contains_key(kind)).collect();
            for kind in lost {
                if let Some(node) = before.nodes.get(&kind) {
                    Arc::make_mut(&mut self.project.library).nodes.insert(kind, node.clone());
                }
            }
            self.project.catalog = Catalog::new(&self.project.library);
        }
        self.project.sync(self.look.document());
        self.place_nodes_again();
        self.place_library_problems();
        self.compilation.shaders.structure_changed();
        // Probes and comparisons hold for the previous nodes.
        self.files_changed();
    }

    /// Places the nodes of the look that have no place. Nothing is changed by that, and it is no
    /// step.
    pub(super) fn place_nodes(&mut self) {
        let mut look = self.look().clone();
        if arrangement::place_nodes_of(&mut look, &self.project.catalog) {
            self.look.history.amend(look, |_| ());
        }
    }

    /// Places the nodes of a look that is as its file has it anew: nodes of the project, which were
    /// read after the look, have other heights than the stand-ins for them.
    fn place_nodes_again(&mut self) {
        if self.shot().is_some() || self.is_look_dirty() || self.look.history.steps() != (0, 0) {
            return;
        }
        let Some(read) = Look::read(self.look.file.source.text(), "").value else { return };
        let mut placed = self.look().clone();
        take_places(&mut placed.graph, &read.graph);
        for (id, definition) in &mut placed.definitions {
            if let Some(read) = read.definitions.get(id) {
                take_places(&mut definition.graph, &read.graph);
            }
        }
        arrangement::place_nodes_of(&mut placed, &self.project.catalog);
        if placed != *self.look() {
            self.look.history.amend(placed, |_| ());
        }
    }

    /// Places each problem of a node file at a node of that kind, where the look has one.
    pub(super) fn place_library_problems(&mut self) {
        let nodes = &self.look.document().graph.nodes;
        let placed = self.project.library.problems.iter().cloned().map(|mut problem| {
            let used =
                kind_of(&problem).and_then(|kind| nodes.iter().find(|(_, node)| node.kind == kind));
            problem.place.node = used.map(|(id, _)| NodePath::root(id.clone()));
            problem
        });
        self.project.problems = placed.collect();
        self.revisions.problems.advance();
    }
}

/// Takes the places that the nodes have in another graph.
fn take_places(graph: &mut Graph, of: &Graph) {
    for (id, node) in &mut graph.nodes {
        if let Some(read) = of.nodes.get(id) {
            node.position = read.position;
        }
    }
}

/// Kind of node that a problem's file defines.
fn kind_of(problem: &Diagnostic) -> Option<&str> {
    Path::new(problem.place.file.as_deref()?).file_stem()?.to_str()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_projects_nodes_come_after_the_look_is_open() {
        let folder = tempfile::tempdir().unwrap();
        let look = folder.path().join("look.json");
        std::fs::write(&look, "{\"nodes\": []}").unwrap();
        std::fs::create_dir(folder.path().join("nodes")).unwrap();
        let node = folder.path().join("nodes/half.wgsl");
        std::fs::write(&node, "fn half(x: f32) -> f32 {\n    return 0.5 * x;\n}\n").unwrap();
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&look).unwrap();
        assert!(session.is_compiling() && !session.project.library.nodes.contains_key("half"));
        session.wait();
        session.tick(0.0);
        assert!(
            session.project.library.nodes.contains_key("half")
                && session.project.problems.is_empty()
        );

        // A node that breaks later is reported, and stays as it was.
        std::fs::write(&node, "fn half(x: f32) -> f32 {\n    return 0.5 *;\n}\n").unwrap();
        session.reload_library();
        session.wait();
        session.tick(0.0);
        assert!(
            session.project.library.nodes.contains_key("half")
                && !session.project.problems.is_empty()
        );
    }

    const PLAIN: &str = r#"{"nodes": [{"id": "base", "kind": "base"},
        {"id": "over", "kind": "blend"}, {"id": "end", "kind": "output"}],
        "wires": [{"from": "base", "to": "over.below"}, {"from": "over", "to": "end.color"}]}"#;

    fn places(session: &Session) -> Vec<[f64; 2]> {
        session.look().graph.nodes.values().map(|node| node.position).collect()
    }

    #[test]
    fn a_look_without_places_opens_laid_out_and_unchanged_wherever_it_comes_from() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            path
        };
        let look = file("look.json", PLAIN);
        let scene = file(
            "scene.json",
            r#"{"chiaro": "scene", "objects": [
                {"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}]}"#,
        );
        let shot = file("shot.json", r#"{"chiaro": "shot", "scene": "scene.json"}"#);
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&look).unwrap();
        let alone = places(&session);
        assert!(alone[0][0] < alone[1][0] && alone[1][0] < alone[2][0], "{alone:?}");
        assert!(!session.is_dirty() && session.look.history.steps() == (0, 0));
        for around in [&scene, &shot] {
            session.open(around).unwrap();
            session.open(&look).unwrap();
            assert!(session.open_scene().is_some());
            assert_eq!(places(&session), alone, "{}", around.display());
            assert!(!session.is_dirty(), "{}", around.display());
        }
        assert_eq!(std::fs::read_to_string(&look).unwrap(), PLAIN, "nothing is written");

        // Without the shot the look can be saved, and its file has the places then.
        session.open(&scene).unwrap();
        session.open(&look).unwrap();
        session.save_as(&look).unwrap();
        let saved = Look::read(&std::fs::read_to_string(&look).unwrap(), "look").value.unwrap();
        assert_eq!(saved, *session.look());
        assert_eq!(saved.graph.nodes["over"].position, alone[1]);
    }

    #[test]
    fn another_programs_version_without_places_is_no_change_but_for_what_it_says() {
        let folder = tempfile::tempdir().unwrap();
        let look = folder.path().join("look.json");
        std::fs::write(&look, PLAIN).unwrap();
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&look).unwrap();
        let before = places(&session);
        let spaced = PLAIN.replace("}, ", "},  ");
        assert!(session.reload(&spaced));
        assert_eq!(session.look.history.steps(), (0, 0), "it means the same");
        let named = PLAIN.replace("{\"nodes\"", "{\"name\": \"Told\", \"nodes\"");
        assert!(session.reload(&named));
        assert_eq!((session.look().name.as_str(), places(&session)), ("Told", before));
    }
}
