//! Embeds every file under `nodes/`, found by walking the folders, so that none is forgotten.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let mut generated = String::new();
    for (name, folder) in [("NODES", "nodes")] {
        let mut files = Vec::new();
        walk(&root.join(folder), &mut files);
        files.sort();
        let doc = format!("/// The path and the text of every file under `{folder}/`.");
        let _ = writeln!(generated, "{doc}\npub static {name}: &[(&str, &str)] = &[");
        for file in files {
            let short = file
                .strip_prefix(&root)
                .expect("below the root")
                .to_string_lossy()
                .replace('\\', "/");
            let _ =
                writeln!(generated, "    ({short:?}, include_str!({:?})),", file.to_string_lossy());
        }
        generated.push_str("];\n");
    }
    let out = PathBuf::from(env::var("OUT_DIR").expect("cargo sets it")).join("embedded.rs");
    fs::write(out, generated).expect("the output folder can be written");
}

fn walk(folder: &Path, files: &mut Vec<PathBuf>) {
    println!("cargo::rerun-if-changed={}", folder.display());
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let path = entry.path();
        if path.is_dir() {
            walk(&path, files);
        } else if path.extension().is_some_and(|e| e == "wgsl" || e == "json") {
            files.push(path);
        }
    }
}
