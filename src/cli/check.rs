//! `chiaro check`: all problems and oddities of looks, scenes and shots, without drawing anything.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use serde_json::json;

use super::open::{check_nodes_folder, library_for};
use super::output::{Output, once, raise};
use super::scene;
use crate::compile::{CompileOptions, Live, TypedSource, check as check_look, compile_typed};
use crate::diag::{Diagnostic, Severity, WithWarnings, has_errors};
use crate::document::{Document, LoadedDocument, Look, Scene, Shot, Value};
use crate::figures::count;
use crate::files::{self, WalkBounds};
use crate::frame::{
    Assets, Rig, SHORTEN, missing_uvs, named_map, open_shot, scene_setup, too_deep,
};
use crate::library::{Library, Type};
use chiaro_scene::hcbtf::LayerOptions;

const EXAMPLES: &str = "\
Examples:
  chiaro check look.json
  chiaro check examples/            every look, scene and shot in a folder and below
  chiaro check scene.json --json    a list of objects, for a script or an editor

Each problem has a severity, a code that stays the same between versions, a place (file, line, \
column, JSON path,
node, port), and help. The exit code is 1 where there is an error; warnings alone give 0 \
without --strict.";

/// Arguments of `chiaro check`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// Looks, scenes, shots, or folders of them
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// A folder of a project's own nodes; `nodes/` beside each document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Take warnings for errors, so that the exit code is 1
    #[arg(long)]
    strict: bool,
    /// Print the problems as a JSON list
    #[arg(long)]
    json: bool,
}

/// Checks the files. Returns true if any error was found, or where that is asked any warning.
pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<bool, Vec<Diagnostic>> {
    check_nodes_folder(arguments.nodes.as_deref())?;
    let mut checker = Checker { nodes: arguments.nodes.as_deref(), ..Checker::default() };
    let mut files = Vec::new();
    for file in &arguments.files {
        if file.is_dir() {
            checker.is_project = true;
            checker.folder(file, &mut files);
        } else {
            files.push(file.clone());
        }
    }
    files.iter().for_each(|file| checker.document(file));
    let mut problems = once(checker.problems);
    if arguments.strict {
        raise(&mut problems);
    }
    if arguments.json {
        output.json(&json!(problems));
    } else {
        output.diagnostics(&problems);
    }
    output.message(&summary(files.len(), &problems));
    Ok(has_errors(&problems))
}

fn summary(files: usize, problems: &[Diagnostic]) -> String {
    let of =
        |severity: Severity| problems.iter().filter(|problem| problem.severity == severity).count();
    let kinds =
        [(Severity::Error, "error"), (Severity::Warning, "warning"), (Severity::Note, "note")];
    let found = kinds.map(|(severity, word)| (of(severity) as u64, word));
    let told: Vec<String> =
        found.iter().filter(|(n, _)| *n > 0).map(|(n, word)| count(*n, word)).collect();
    let told = if told.is_empty() { "nothing is wrong".to_owned() } else { told.join(", ") };
    format!("{} checked: {told}", count(files as u64, "document"))
}

#[derive(Default)]
struct Checker<'a> {
    /// True if folders are checked, with all documents in them.
    is_project: bool,
    nodes: Option<&'a Path>,
    assets: Assets,
    libraries: HashMap<PathBuf, Library>,
    looks: HashSet<PathBuf>,
    /// Scenes that were checked with shots over them.
    scenes: HashSet<PathBuf>,
    problems: Vec<Diagnostic>,
}

impl Checker<'_> {
    /// Finds looks, scenes and shots in a folder and below; other JSON files are left alone, broken
    /// ones are not.
    fn folder(&mut self, folder: &Path, found: &mut Vec<PathBuf>) {
        // Folders are followed deep enough for any project.
        const BOUNDS: WalkBounds = WalkBounds { depth: 16, entries: 20_000 };
        let before = found.len();
        // Groups in a `nodes` folder are read with the library.
        let is_library = |path: &Path| path.file_name().is_some_and(|name| name == "nodes");
        let walked = files::walk(folder, BOUNDS, &|path| !is_library(path));
        for (path, error) in walked.unreadable {
            let message = format!("this folder cannot be read: {error}");
            let problem = Diagnostic::error("cannot-read", message);
            self.problems.push(problem.in_file(path.display().to_string()));
        }
        if walked.is_cut {
            let message = format!(
                "only {} files and folders in it are looked at: not all is checked",
                BOUNDS.entries
            );
            let problem = Diagnostic::warning("too-many-files", message);
            let hint = "check the folders in it one by one";
            self.problems.push(problem.in_file(folder.display().to_string()).hint(hint));
        }
        let is_json = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "json");
        found
            .extend(walked.files.into_iter().filter(|path| is_json(path) && may_be_document(path)));
        found[before..].sort();
        if found.len() == before {
            let problem =
                Diagnostic::warning("no-documents", "there is no look and no scene in this folder");
            self.problems.push(problem.in_file(folder.display().to_string()));
        }
    }

    fn library(&mut self, document: &Path) -> Library {
        let folder = document.parent().unwrap_or(Path::new("")).to_path_buf();
        if let Some(known) = self.libraries.get(&folder) {
            return known.clone();
        }
        let library = library_for(document, self.nodes);
        // A broken node file is an error of the nodes that use it, which the compiler tells, and of
        // the project as a whole; to a look that does not use it, it is a warning.
        let severity = if self.is_project { Severity::Error } else { Severity::Warning };
        let aside = |problem: &Diagnostic| Diagnostic { severity, ..problem.clone() };
        self.problems.extend(library.problems.iter().map(aside));
        self.libraries.insert(folder, library.clone());
        library
    }

    fn document(&mut self, path: &Path) {
        let library = self.library(path);
        match Document::load(&crate::files::Disk, path) {
            Document::Look(loaded) => self.look(path, &loaded, &library),
            Document::Scene(loaded) => self.scene(path, &loaded, &library),
            Document::Shot(loaded) => self.shot(path, loaded, &library),
        }
    }

    /// Checks a shot, the scene under it, and the looks as it changes them.
    fn shot(&mut self, path: &Path, loaded: LoadedDocument<Shot>, library: &Library) {
        let more = as_if_sound(&loaded);
        let setup = match open_shot(path, loaded, None, &mut self.assets) {
            Ok(opened) => opened.tell(&mut self.problems),
            Err(problems) => {
                self.problems.extend(problems);
                let more = more.map(|sound| open_shot(path, sound, None, &mut self.assets));
                return self.problems.extend(more.and_then(Result::err).unwrap_or_default());
            }
        };
        let Some(shot) = &setup.shot else { return };
        let values = scene::check_values(&setup, library);
        self.problems.extend(values.unwrap_or_else(|problems| problems));
        self.problems.extend(setup.light_warnings());
        for (index, worn) in
            setup.looks.iter().enumerate().filter(|(_, look)| shot.changes_look(look))
        {
            let mut found = match check_look(&worn.look, library, None) {
                Ok(typed) => {
                    let options =
                        CompileOptions { live: Live::Exposed, ..CompileOptions::default() };
                    let compiled = compile_typed(&typed.value, &options).err();
                    compiled.unwrap_or(typed.warnings)
                }
                Err(problems) => problems,
            };
            found.iter_mut().for_each(|problem| shot.locate(&setup.looks[index], problem));
            worn.source.locate_all(&mut found);
            self.problems.extend(found);
        }
        let scene = shot.stack.scene_path.clone();
        if self.scenes.insert(scene.clone()) {
            self.document(&scene);
        }
    }

    fn look(&mut self, path: &Path, loaded: &LoadedDocument<Look>, library: &Library) {
        if !self.looks.insert(path.to_path_buf()) {
            return;
        }
        self.problems.extend(loaded.diagnostics.iter().cloned());
        let Some(look) = &loaded.value else { return };
        let mut found = Vec::new();
        let folder = path.parent().unwrap_or(Path::new(""));
        match check_look(look, library, None) {
            Ok(WithWarnings { value: typed, warnings }) => {
                missing_images(&typed, folder, &mut self.assets, &mut found);
                let options = CompileOptions { live: Live::Exposed, ..CompileOptions::default() };
                match compile_typed(&typed, &options) {
                    Ok(compiled) => {
                        let too_deep = too_deep(&compiled);
                        found.extend(warnings);
                        found.extend(too_deep.map(|message| {
                            Diagnostic::warning("deep-shader", message).hint(SHORTEN.english())
                        }));
                    }
                    Err(problems) => found.extend(problems),
                }
            }
            Err(problems) => found.extend(problems),
        }
        if !loaded.has_errors() {
            found.extend(Rig::new(look).warnings);
        } else {
            // Files that could not be read were left out, and told before; the missing parts that
            // follow from that are no news.
            found.retain(|problem| !FOLLOWS.contains(&problem.code));
        }
        loaded.source.locate_all(&mut found);
        self.problems.extend(found);
    }

    fn scene(&mut self, path: &Path, loaded: &LoadedDocument<Scene>, library: &Library) {
        self.problems.extend(loaded.diagnostics.iter().cloned());
        let Some(scene) = &loaded.value else { return };
        let folder = path.parent().unwrap_or(Path::new(""));
        let looks = scene::looks(scene, folder);
        looks.iter().for_each(|(name, look)| self.look(&folder.join(name), look, library));
        let mut found = scene::value_problems(scene, &looks, library);
        // An object that is hidden now may be shown later.
        let mut all = scene.clone();
        all.objects.values_mut().for_each(|object| object.visible = true);
        let (setup, of_setup) =
            scene_setup(all, folder, &loaded.source, None, &mut self.assets).into_parts();
        self.problems.extend(missing_uvs(&setup, library));
        self.problems.extend(setup.light_warnings());
        // Problems of the looks were told with the looks.
        let file = path.display().to_string();
        found.extend(of_setup.into_iter().filter(|problem| {
            let place = problem.place.file.as_deref();
            place.is_none()
                || place == Some(&file)
                || !looks.keys().any(|look| place == folder.join(look).to_str())
        }));
        loaded.source.locate_all(&mut found);
        self.problems.extend(found);
    }
}

/// A shot whose only errors are keys out of order, without these errors: of each value that has
/// such keys the first is left, so that the rest of the shot can be checked.
fn as_if_sound(loaded: &LoadedDocument<Shot>) -> Option<LoadedDocument<Shot>> {
    let mut sound = loaded.clone();
    sound.diagnostics.retain(|problem| !problem.is_error() || problem.code != "not-increasing");
    if !loaded.has_errors() || sound.has_errors() {
        return None;
    }
    sound.diagnostics.clear();
    for changed in &mut sound.value.as_mut()?.overrides {
        if !changed.keys.is_sorted_by(|before, after| before.frame < after.frame) {
            changed.keys.truncate(1);
        }
    }
    Some(sound)
}

/// Codes of problems that follow from a file that could not be read.
const FOLLOWS: [&str; 5] =
    ["no-output", "unwired", "unknown-node", "unknown-target", "unknown-light"];

/// True if a JSON file in a folder is a document of ours, or broken, which is worth telling.
fn may_be_document(path: &Path) -> bool {
    let Ok(text) = crate::files::read_text(path) else { return true };
    match serde_json::from_str::<serde_json::Value>(&text) {
        // The JSON file beside the images of an exported HCBTF is neither look nor scene.
        Ok(serde_json::Value::Object(fields))
            if fields.get("chiaro").is_some_and(|kind| kind == "hcbtf") =>
        {
            false
        }
        Ok(serde_json::Value::Object(fields)) => ["chiaro", "nodes", "objects"]
            .iter()
            .any(|field| fields.get(*field).is_some_and(|value| !value.is_object())),
        Ok(_) => false,
        Err(_) => true,
    }
}

fn missing_images(
    typed: &crate::compile::TypedGraph,
    folder: &Path,
    assets: &mut Assets,
    found: &mut Vec<Diagnostic>,
) {
    for node in &typed.nodes {
        for (input, port) in node.inputs.iter().zip(&node.def.inputs) {
            let Some(TypedSource::Param(_, Value::Text(name))) =
                input.as_ref().map(|input| &input.source)
            else {
                continue;
            };
            if !port.ty.is_texture() || name.is_empty() {
                continue;
            }
            let problems = match port.ty {
                Type::Hcbtf => assets
                    .hcbtf(folder, name, LayerOptions::default())
                    .map_or_else(|problems| problems, |warned| warned.warnings),
                // A map of a mesh is that of whatever wears the look.
                _ => match named_map(name) {
                    Ok(Some(_)) => Vec::new(),
                    Ok(None) => assets.image(folder, name).err().into_iter().collect(),
                    Err(problem) => vec![problem],
                },
            };
            found.extend(problems.into_iter().map(|problem| {
                let mut problem = problem.node(node.path.clone()).port(port.name.clone());
                problem.place.file = None;
                problem
            }));
        }
    }
}
