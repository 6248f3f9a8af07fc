//! Godot 4, its official web build, in Chromium, with a pack of files that a test gives it.
//!
//! Godot starts once, in seconds, and then runs scripts that the test asks for.

use std::path::PathBuf;

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::chromium::Chromium;
use crate::root;
use crate::served::Server;
use crate::validators::{Tool, godot_folder};

/// Version of the engine.
pub const VERSION: [u32; 3] = [4, 6, 0];

/// A running Godot.
pub struct Godot {
    browser: Chromium,
    _server: Server,
    _folder: TempDir,
}

impl Godot {
    /// Godot with files, whose paths are those after `res://`. `None`, told on standard error,
    /// where a tool is missing.
    ///
    /// # Errors
    /// Reasons why Godot does not start; missing tools where they are required.
    pub fn start(files: &[(String, Vec<u8>)]) -> Result<Option<Self>, String> {
        if !Tool::Godot.is_here() {
            return Tool::Godot.missing().map(|()| None);
        }
        let Some(mut browser) = Chromium::start()? else { return Ok(None) };
        let text = |error: std::io::Error| error.to_string();
        let folder = tempfile::tempdir().map_err(text)?;
        let own = |name: &str| root().join("tests/godot").join(name);
        std::fs::copy(own("page.html"), folder.path().join("page.html")).map_err(text)?;
        let mut packed = vec![
            ("project.godot".to_owned(), PROJECT.as_bytes().to_vec()),
            ("main.tscn".to_owned(), SCENE.as_bytes().to_vec()),
            ("runner.gd".to_owned(), std::fs::read(own("runner.gd")).map_err(text)?),
        ];
        packed.extend(files.iter().cloned());
        std::fs::write(folder.path().join("game.pck"), pack(&packed)).map_err(text)?;
        let served: Vec<(String, PathBuf)> =
            vec![("godot".to_owned(), godot_folder()), (String::new(), folder.path().to_owned())];
        let server = Server::start(served)?;
        browser.open(&server.url("page.html"))?;
        browser.evaluate(
            "new Promise((resolve) => {
                const wait = () => (window.isReady ? resolve(true) : setTimeout(wait, 20));
                wait();
            })",
        )?;
        Ok(Some(Self { browser, _server: server, _folder: folder }))
    }

    /// Value of a script's function `run(main)`, as JSON; `main` is a node of the running scene.
    ///
    /// # Errors
    /// What Godot said: errors of the script, and any that it printed meanwhile.
    pub fn run(&mut self, script: &str) -> Result<Value, String> {
        self.browser.evaluate("said.length = 0")?;
        let answer = self.browser.evaluate(&format!("ask({})", json!(script)))?;
        let said = self.browser.evaluate("said.join('\\n')")?;
        let said = said.as_str().unwrap_or_default();
        let mut answer: Value = serde_json::from_str(answer.as_str().unwrap_or_default())
            .map_err(|error| format!("{error}: {answer}"))?;
        let is_fine = said.is_empty() && answer["problem"].is_null();
        if is_fine {
            return Ok(answer["answer"].take());
        }
        let answer: String = answer.to_string().chars().take(500).collect();
        Err(format!("{said}\n{answer}"))
    }
}

const PROJECT: &str = "config_version=5

[application]
config/name=\"Test\"
run/main_scene=\"res://main.tscn\"

[rendering]
renderer/rendering_method=\"gl_compatibility\"
";

const SCENE: &str = "[gd_scene load_steps=2 format=3]

[ext_resource type=\"Script\" path=\"res://runner.gd\" id=\"1\"]

[node name=\"main\" type=\"Node\"]
script = ExtResource(\"1\")
";

/// Files as Godot's pack of version 2: a head, the directory, the files one after another.
fn pack(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    // Version of the format, of the engine, flags; the place of the files; 16 words for later.
    let head_size = 4 + 5 * 4 + 8 + 16 * 4;
    let mut directory = (files.len() as u32).to_le_bytes().to_vec();
    let mut contents: Vec<u8> = Vec::new();
    for (path, bytes) in files {
        let padded = path.len().next_multiple_of(4);
        directory.extend((padded as u32).to_le_bytes());
        directory.extend(path.as_bytes());
        directory.resize(directory.len() + padded - path.len(), 0);
        directory.extend((contents.len() as u64).to_le_bytes());
        directory.extend((bytes.len() as u64).to_le_bytes());
        // A checksum that nobody asks for, and flags.
        directory.extend([0; 16 + 4]);
        contents.extend(bytes);
    }
    let base = head_size + directory.len();
    let mut pack = b"GDPC".to_vec();
    for word in [2, VERSION[0], VERSION[1], VERSION[2], 0] {
        pack.extend(word.to_le_bytes());
    }
    pack.extend((base as u64).to_le_bytes());
    pack.resize(head_size, 0);
    pack.extend(directory);
    pack.extend(contents);
    pack
}
