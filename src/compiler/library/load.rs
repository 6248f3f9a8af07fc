//! Loading of the library: the built-in nodes, and a project's own files.

use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::embedded::NODES;
use super::module::NodeModule;
use super::node::NodeDef;
use super::read::{load_node, read_node, stem_and_folder};
use crate::diag::{Diagnostic, has_errors};
use crate::document::{Definition, Look};
use crate::files::{self, Files, ReadError, WalkBounds};
use crate::milestones;
use crate::wgsl::{self, NamedSource};

/// Bounds of the walk to a project's nodes: deeper than any category.
const BOUNDS: WalkBounds = WalkBounds { depth: 8, entries: 20_000 };
/// Greatest number of files of a project's nodes.
const MAX_FILES: usize = 4096;
/// Greatest size of a file of a project's nodes, in bytes.
const MAX_FILE_BYTES: u64 = 1 << 20;
/// Greatest size of all files of a project's nodes together, in bytes.
const MAX_PROJECT_BYTES: u64 = 16 << 20;

/// Library of nodes and groups.
#[derive(Clone, Debug, Default)]
pub struct Library {
    /// Nodes by kind, in the order of their files.
    pub nodes: IndexMap<String, Arc<NodeDef>>,
    /// Group definitions by id.
    pub groups: IndexMap<String, Arc<GroupDef>>,
    /// Problems of a project's own files; a file named here adds no node.
    pub problems: Vec<Diagnostic>,
}

/// Group that the library offers.
#[derive(Clone, Debug)]
pub struct GroupDef {
    /// Id of the group, which documents give as `kind`.
    pub id: String,
    /// File name, as messages give it.
    pub file: String,
    /// Folder of the file.
    pub category: String,
    /// Definition of the group: its graph and interface.
    pub definition: Definition,
}

/// Built-in library, loaded on first use.
static BUILT_IN: LazyLock<Library> = LazyLock::new(|| match Library::load_built_in() {
    Ok(library) => library,
    // A test loads and validates every shipped file, so a release cannot come here; the problems
    // tell a developer what is wrong.
    Err(problems) => Library { problems, ..Library::default() },
});

impl Library {
    /// Library of the nodes that Chiaro ships.
    pub fn built_in() -> &'static Self {
        &BUILT_IN
    }

    fn load_built_in() -> Result<Self, Vec<Diagnostic>> {
        let is_node = |path: &&(&str, &str)| path.0.ends_with(".wgsl");
        let sources: Vec<_> =
            NODES.iter().filter(is_node).map(|&(name, text)| NamedSource { name, text }).collect();
        let module = Arc::new(NodeModule::of_files(wgsl::link(&sources)?));
        let mut library = Self::default();
        let mut files = module.linked.files.iter();
        for source in &sources {
            // A source stands behind all that it imports.
            let Some(file) = files.find(|file| file.name == source.name) else { continue };
            match read_node(source, &file.scan, &module, None) {
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

    /// Adds a file of group definitions: a look whose `definitions` join the library. Its
    /// diagnostics go to `problems`.
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
            let (file, category) = (path.to_owned(), category.clone());
            self.groups.insert(id.clone(), Arc::new(GroupDef { id, file, category, definition }));
        }
    }

    /// Library with every node under a project's `nodes/` folder. A broken file adds no node
    /// and a diagnostic with its line; the other files are added. The folder may be a stranger's,
    /// so the number and size of its files are bounded.
    #[must_use]
    pub fn with_project(&self, files: &dyn Files, folder: &Path) -> Self {
        let mut library = self.clone();
        let found = node_files(files, folder);
        let mut left = MAX_PROJECT_BYTES;
        let mut is_cut = found.is_cut;
        for file in found.files {
            let name = file.to_string_lossy().into_owned();
            let text = match read_node_file(files, &file) {
                Ok(text) => text,
                Err(problem) => {
                    library.problems.push(problem.in_file(name));
                    continue;
                }
            };
            let Some(rest) = left.checked_sub(text.len() as u64) else {
                is_cut = true;
                break;
            };
            left = rest;
            // The folder may be a checkout of Chiaro, or hold copies to learn from: a shipped file
            // is no duplicate to report.
            if is_shipped(&file, &text) {
                continue;
            }
            if name.ends_with(".json") {
                library.add_groups(&name, &text);
            } else {
                library.add_file(&name, &text);
            }
        }
        if is_cut {
            library.problems.push(too_much(folder));
        }
        library
    }

    /// Adds one node file; its diagnostics go to `problems`.
    pub fn add_file(&mut self, name: &str, text: &str) {
        match load_node(name, text, None) {
            Ok(node)
                if self.nodes.contains_key(&node.kind) || self.groups.contains_key(&node.kind) =>
            {
                self.problems.push(kind_taken(&node.kind, name));
            }
            Ok(node) => {
                self.nodes.insert(node.kind.clone(), Arc::new(node));
            }
            Err(problems) => self.problems.extend(problems),
        }
    }

    /// All kinds that a node may have.
    pub fn kinds(&self) -> impl Iterator<Item = &str> {
        self.nodes.keys().chain(self.groups.keys()).map(String::as_str)
    }
}

/// True if a file is one that Chiaro ships, unchanged.
fn is_shipped(file: &Path, text: &str) -> bool {
    NODES
        .iter()
        .any(|(path, shipped)| Path::new(path).file_name() == file.file_name() && *shipped == text)
}

fn kind_taken(kind: &str, file: &str) -> Diagnostic {
    Diagnostic::error("kind-taken", tr!("there is a node of kind `{kind}` already"))
        .in_file(file)
        .hint(tr!("give it another name"))
}

/// Files of a project's own nodes, and the folders that they lie in.
#[derive(Debug, Default)]
pub struct NodeFiles {
    /// Files whose names end in `.wgsl` or `.json`, sorted.
    pub files: Vec<PathBuf>,
    /// The walked folder and the folders in it.
    pub folders: Vec<PathBuf>,
    /// True if there are more files than are read.
    is_cut: bool,
}

/// Finds a project's own nodes.
pub fn node_files(files: &dyn Files, folder: &Path) -> NodeFiles {
    let walked = files.walk(folder, BOUNDS, &|_| true);
    let is_node = |path: &PathBuf| {
        path.extension().is_some_and(|ending| ending == "wgsl" || ending == "json")
    };
    let mut files: Vec<PathBuf> = walked.files.into_iter().filter(is_node).collect();
    files.sort();
    let is_cut = walked.is_cut || files.len() > MAX_FILES;
    files.truncate(MAX_FILES);
    NodeFiles { files, folders: walked.folders, is_cut }
}

fn read_node_file(files: &dyn Files, path: &Path) -> Result<String, Diagnostic> {
    let unreadable = |why: &str| {
        Diagnostic::error("unreadable-node", tr!("this node file cannot be read: {why}"))
    };
    let bytes = files.read(path, MAX_FILE_BYTES).map_err(|error| {
        let problem = unreadable(&error.to_string());
        match error {
            ReadError::Io(_) => problem,
            _ => problem.hint(tr!("keep only WGSL files and group definitions in this folder")),
        }
    })?;
    if files::is_utf16(&bytes) {
        return Err(unreadable(tr!("it is text in UTF-16")).hint(tr!("save it as UTF-8")));
    }
    String::from_utf8(bytes)
        .map_err(|_| unreadable(tr!("it is no text in UTF-8")).hint(tr!("save it as UTF-8")))
}

fn too_much(folder: &Path) -> Diagnostic {
    let message = tr!(
        "this folder holds more than is read for nodes ({MAX_FILES} files and {most} MiB): the \
         rest is left out",
        most = MAX_PROJECT_BYTES >> 20
    );
    Diagnostic::warning("too-many-nodes", message).in_file(folder.display().to_string()).hint(tr!(
        "keep only WGSL files and group definitions in it, and no links to large folders"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::MemoryFiles;

    const FOLDER: &str = "project/nodes";

    /// Codes of the problems of a project's nodes.
    fn problems(files: &MemoryFiles) -> Vec<&'static str> {
        let library = Library::built_in().with_project(files, Path::new(FOLDER));
        library.problems.iter().map(|problem| problem.code).collect()
    }

    #[test]
    fn a_file_that_is_too_large_or_no_text_is_told_and_the_rest_is_read() {
        let mut files = MemoryFiles::default();
        let path = |name: &str| Path::new(FOLDER).join(name);
        files.add(path("half.wgsl"), "fn half(x: f32) -> f32 {\n    return 0.5 * x;\n}\n");
        files.add(path("large.wgsl"), vec![b' '; MAX_FILE_BYTES as usize + 1]);
        files.add(path("wide.wgsl"), b"\xFF\xFEf\0n\0");
        files.add(path("wild.json"), b"{\xFF}");
        assert_eq!(problems(&files), ["unreadable-node"; 3]);
        let library = Library::built_in().with_project(&files, Path::new(FOLDER));
        assert!(library.nodes.contains_key("half"));
    }

    #[test]
    fn files_are_read_up_to_a_bound_of_all_of_them() {
        let mut files = MemoryFiles::default();
        let text = format!("// {}", "x".repeat(MAX_FILE_BYTES as usize - 3));
        let most = MAX_PROJECT_BYTES / MAX_FILE_BYTES;
        for i in 0..=most {
            files.add(Path::new(FOLDER).join(format!("n{i}.wgsl")), text.as_str());
        }
        let told = problems(&files);
        assert_eq!(told.iter().filter(|code| **code == "too-many-nodes").count(), 1);
        assert_eq!(told.len() as u64, most + 1, "{told:?}");
    }

    #[test]
    fn a_bound_names_a_share_and_the_choices_that_make_it_one() {
        let node = |bound: &str| {
            let text = format!(
                "/// Probe\n///\n/// @choice mode default=add add=Add alpha=Alpha\n/// @bound \
                 {bound}\n\
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
        let mut files = MemoryFiles::default();
        let (path, text) = NODES.iter().find(|(path, _)| path.ends_with("/profile.wgsl")).unwrap();
        let file = Path::new(FOLDER).join(Path::new(path).file_name().unwrap());
        files.add(&file, *text);
        assert_eq!(problems(&files), [""; 0]);
        files.add(&file, format!("{text}\n"));
        assert_eq!(problems(&files), ["kind-taken"]);
    }
}
