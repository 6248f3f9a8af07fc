//! Embeds every file of a folder in a crate. Files are found by walking the folder, so that none is
//! forgotten and no list of files has to be kept. [`hash_sources`] names a crate's sources by their
//! hash.
//!
//! A crate's build script names its folders as rows of one table:
//!
//! ```no_run
//! use chiaro_embed::{Content, Table, embed};
//!
//! embed(&[Table {
//!     name: "NODES",
//!     base: "",
//!     folders: &["nodes"],
//!     extensions: &["wgsl", "json"],
//!     content: Content::Text,
//!     order: None,
//! }]);
//! ```
//!
//! and the crate includes the file that is generated for a row: `include!(concat!(env!("OUT_DIR"),
//! "/nodes.rs"));`

use std::collections::HashMap;
use std::fmt::Write as _;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Type of a file's content in the crate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Text, as `&str`.
    Text,
    /// Bytes, as `&[u8]`.
    Bytes,
}

/// Folders whose files are embedded, as one static slice of `(path, content)`.
#[derive(Clone, Copy, Debug)]
pub struct Table<'a> {
    /// Name of the slice; in small letters, also the name of the generated file.
    pub name: &'a str,
    /// Folder that the paths of the slice are relative to, itself relative to the crate's manifest.
    pub base: &'a str,
    /// Folders below `base` that are walked. Links are followed, so that a folder elsewhere in the
    /// repository is part of a package of the crate.
    pub folders: &'a [&'a str],
    /// Extensions of the files that are embedded.
    pub extensions: &'a [&'a str],
    /// Type of the content in the crate.
    pub content: Content,
    /// File below `base` that lists paths, one a line, that come first; other paths follow by name.
    /// Words after ` | ` and lines that are no paths are for others.
    pub order: Option<&'a str>,
}

/// Writes a file `NAME.rs` for each table into the build's `OUT_DIR`.
///
/// # Panics
///
/// Outside a build script that cargo runs, and where a file cannot be read or written: a build
/// script has nobody else to tell.
pub fn embed(tables: &[Table<'_>]) {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    for table in tables {
        let file = out.join(format!("{}.rs", table.name.to_lowercase()));
        fs::write(&file, slice(&root, table))
            .unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    }
}

/// Sets an environment variable for the crate, which reads it by `env!`, to a hash of the target
/// and of files: those of `paths`, and all Rust sources in folders of `paths`, relative to the
/// crate's manifest. A path that leads to nothing, as one out of a package of the crate does, is
/// left out.
///
/// # Panics
///
/// As [`embed`].
#[expect(clippy::print_stdout, reason = "cargo listens to what a build script prints")]
pub fn hash_sources(variable: &str, paths: &[&str]) {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let mut files = Vec::new();
    for path in paths.iter().map(|path| root.join(path)) {
        if path.is_dir() {
            walk(&path, &["rs"], &mut files);
        } else if path.is_file() {
            watch(&path);
            files.push(path);
        }
    }
    files.sort();
    let mut hasher = DefaultHasher::new();
    env::var_os("TARGET").expect("cargo sets it").hash(&mut hasher);
    for file in &files {
        let bytes = fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        bytes.hash(&mut hasher);
    }
    println!("cargo::rustc-env={variable}={:016x}", hasher.finish());
}

/// Source code of one table's slice.
fn slice(root: &Path, table: &Table<'_>) -> String {
    let base = root.join(table.base);
    let mut files = Vec::new();
    for folder in table.folders {
        walk(&base.join(folder), table.extensions, &mut files);
    }
    let mut files: Vec<(String, PathBuf)> =
        files.into_iter().map(|file| (short(&base, &file), file)).collect();
    let ranks = table.order.map(|order| ranks(&base.join(order))).unwrap_or_default();
    files.sort_by_cached_key(|(name, _)| {
        (ranks.get(name).copied().unwrap_or(usize::MAX), name.clone())
    });
    let (ty, include) = match table.content {
        Content::Text => ("&str", "include_str!"),
        Content::Bytes => ("&[u8]", "include_bytes!"),
    };
    let (name, folders) = (table.name, table.folders.join("/`, `"));
    let mut text = format!(
        "/// The path and the content of every file under `{folders}/`.\n\
         pub static {name}: &[(&str, {ty})] = &[\n"
    );
    for (name, file) in &files {
        let _ = writeln!(text, "    ({name:?}, {include}({:?})),", file.to_string_lossy());
    }
    text + "];\n"
}

/// Path of a file below a folder, with `/` on every system.
fn short(folder: &Path, file: &Path) -> String {
    let short = file.strip_prefix(folder).expect("the file was found there");
    short.to_string_lossy().replace('\\', "/")
}

/// Rank of each path that an order file lists, by line.
fn ranks(file: &Path) -> HashMap<String, usize> {
    watch(file);
    let text =
        fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let path = |line: &str| line.split_once(" | ").map_or(line, |(path, _)| path).to_owned();
    text.lines().map(path).zip(0..).collect()
}

/// Tells cargo to run the build script again when a file or folder changes.
#[expect(clippy::print_stdout, reason = "cargo listens to what a build script prints")]
fn watch(path: &Path) {
    println!("cargo::rerun-if-changed={}", path.display());
}

/// Every file below a folder that has one of the extensions.
fn walk(folder: &Path, extensions: &[&str], files: &mut Vec<PathBuf>) {
    watch(folder);
    let entries =
        fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for entry in entries {
        let path = entry.unwrap_or_else(|error| panic!("{}: {error}", folder.display())).path();
        let is_wanted =
            || path.extension().is_some_and(|name| extensions.iter().any(|wanted| name == *wanted));
        if path.is_dir() {
            walk(&path, extensions, files);
        } else if is_wanted() {
            files.push(path);
        }
    }
}
