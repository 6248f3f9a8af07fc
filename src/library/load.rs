//! The library: built in, and with a project's own files.

use std::path::Path;
use std::sync::{Arc, LazyLock};

use indexmap::IndexMap;

use super::node::NodeDef;
use super::read::{load_module, load_node, read_node, stem_and_folder};
use crate::diag::{Diagnostic, has_errors};
use crate::document::{Definition, Look};
use crate::milestones;
use crate::wgsl::{NODES, Source};

/// The nodes and groups there are.
#[derive(Clone, Debug, Default)]
pub struct Library {
    /// By kind, in the order of their files.
    pub nodes: IndexMap<String, Arc<NodeDef>>,
    /// Group definitions by id.
    pub groups: IndexMap<String, Arc<GroupDef>>,
    /// What was wrong with a project's own files; a file named here adds no node.
    pub problems: Vec<Diagnostic>,
}

/// A group that the library offers.
#[derive(Clone, Debug)]
pub struct GroupDef {
    /// Its id: what documents say in `kind`.
    pub id: String,
    /// The folder.
    pub category: String,
    /// What it is made of.
    pub definition: Definition,
}

static BUILT_IN: LazyLock<Library> = LazyLock::new(|| match Library::load_built_in() {
    Ok(library) => library,
    // A test loads every shipped file, so a release cannot come here; a developer is told what is wrong.
    Err(problems) => Library { problems, ..Library::default() },
});

impl Library {
    /// The nodes that Chiaro ships.
    pub fn built_in() -> &'static Self {
        &BUILT_IN
    }

    fn load_built_in() -> Result<Self, Vec<Diagnostic>> {
        let is_node = |path: &&(&str, &str)| path.0.ends_with(".wgsl");
        let sources: Vec<_> = NODES.iter().filter(is_node).map(|&(name, text)| Source { name, text }).collect();
        let module = Arc::new(load_module(&sources)?);
        let mut library = Self::default();
        for source in &sources {
            match read_node(source, &module, None) {
                Ok(node) => {
                    library.nodes.insert(node.kind.clone(), Arc::new(node));
                }
                Err(problems) => library.problems.extend(problems),
            }
        }
        for (path, text) in NODES.iter().filter(|(path, _)| path.ends_with(".json")) {
            library.add_groups(path, text);
        }
        milestones::reached("library");
        if has_errors(&library.problems) { Err(library.problems) } else { Ok(library) }
    }

    /// Adds a file of group definitions: a look whose `definitions` join the library. What is wrong with it goes to
    /// `problems`.
    pub fn add_groups(&mut self, path: &str, text: &str) {
        let (_, category) = stem_and_folder(path);
        let look = Look::read(text, path);
        self.problems.extend(look.diagnostics.iter().cloned());
        for (id, definition) in look.value.map(|look| look.definitions).unwrap_or_default() {
            let id = id.to_string();
            if self.nodes.contains_key(&id) || self.groups.contains_key(&id) {
                self.problems.push(kind_taken(&id, path));
                continue;
            }
            self.groups.insert(id.clone(), Arc::new(GroupDef { id, category: category.clone(), definition }));
        }
    }

    /// This library and every node under a project's `nodes/` folder. A broken file adds no node and a diagnostic
    /// with its line; all else goes on.
    #[must_use]
    pub fn with_project(&self, folder: &Path) -> Self {
        let mut library = self.clone();
        let mut files = Vec::new();
        collect_files(folder, 0, &mut files);
        files.sort();
        for file in files {
            let name = file.to_string_lossy().into_owned();
            match std::fs::read_to_string(&file) {
                // A checkout of Chiaro, or copies to learn from: nothing is said that is not known.
                Ok(text) if is_shipped(&file, &text) => {}
                Ok(text) if name.ends_with(".json") => library.add_groups(&name, &text),
                Ok(text) => library.add_file(&name, &text),
                Err(error) => library.problems.push(
                    Diagnostic::error(
                        "unreadable-node",
                        format!("this node file cannot be read: {}", crate::diag::reason(&error)),
                    )
                    .in_file(name),
                ),
            }
        }
        library
    }

    /// Adds one node file; what is wrong with it goes to `problems`.
    pub fn add_file(&mut self, name: &str, text: &str) {
        match load_node(name, text, None) {
            Ok(node) if self.nodes.contains_key(&node.kind) || self.groups.contains_key(&node.kind) => {
                self.problems.push(kind_taken(&node.kind, name));
            }
            Ok(node) => {
                self.nodes.insert(node.kind.clone(), Arc::new(node));
            }
            Err(problems) => self.problems.extend(problems),
        }
    }

    /// Every kind a node may have.
    pub fn kinds(&self) -> impl Iterator<Item = &str> {
        self.nodes.keys().chain(self.groups.keys()).map(String::as_str)
    }
}

/// Whether a file is one of those that Chiaro ships, as it ships it.
fn is_shipped(file: &Path, text: &str) -> bool {
    NODES.iter().any(|(path, shipped)| Path::new(path).file_name() == file.file_name() && *shipped == text)
}

fn kind_taken(kind: &str, file: &str) -> Diagnostic {
    Diagnostic::error("kind-taken", format!("there is a node of kind `{kind}` already"))
        .in_file(file)
        .hint("give it another name")
}

fn collect_files(folder: &Path, depth: usize, files: &mut Vec<std::path::PathBuf>) {
    // Deeper than any category; a link to a parent folder must not hang the editor.
    const MAX_DEPTH: usize = 8;
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for path in entries.flatten().map(|entry| entry.path()) {
        if path.is_dir() && depth < MAX_DEPTH {
            collect_files(&path, depth + 1, files);
        } else if path.extension().is_some_and(|extension| extension == "wgsl" || extension == "json") {
            files.push(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_names_a_share_and_the_choices_that_make_it_one() {
        let node = |bound: &str| {
            let text = format!(
                "/// Probe\n///\n/// @choice mode default=add add=Add alpha=Alpha\n/// @bound {bound}\n\
                 fn probe_add(share: f32, place: vec3f) -> f32 {{ return share; }}\n\
                 fn probe_alpha(share: f32) -> f32 {{ return share; }}\n"
            );
            crate::library::read::load_node("nodes/probe.wgsl", &text, None)
        };
        assert_eq!(node("share").unwrap().bounds[0].conditions, []);
        assert_eq!(node("share when mode = alpha").unwrap().bounds[0].conditions.len(), 1);
        for wrong in ["", "other", "place", "share when share = 0", "share if mode = alpha"] {
            let problems = node(wrong).unwrap_err();
            assert!(problems[0].message.contains("@bound"), "{wrong}: {problems:?}");
        }
    }

    #[test]
    fn copies_of_shipped_nodes_say_nothing_and_changed_ones_do() {
        let folder = tempfile::tempdir().unwrap();
        let (path, text) = NODES.iter().find(|(path, _)| path.ends_with("/profile.wgsl")).unwrap();
        let file = folder.path().join(Path::new(path).file_name().unwrap());
        std::fs::write(&file, text).unwrap();
        assert!(Library::built_in().with_project(folder.path()).problems.is_empty());
        std::fs::write(&file, format!("{text}\n")).unwrap();
        let problems = Library::built_in().with_project(folder.path()).problems;
        assert_eq!(problems.iter().map(|problem| problem.code).collect::<Vec<_>>(), ["kind-taken"]);
    }
}
