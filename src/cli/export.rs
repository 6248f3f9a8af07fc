//! `chiaro export`: a look as shaders for other programs, with a description of all that they need.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::open::{check_nodes_folder, library_for, open_look};
use super::output::Output;
use crate::diag::Diagnostic;
use crate::document::write_atomic;
use crate::export::{self, LANGUAGES, Language};

const EXAMPLES: &str = "\
Examples:
  chiaro export look.json --to wgsl                         the WGSL, on standard output
  chiaro export look.json --to glsl-es300 -o web/
  chiaro export look.json --to wgsl,spirv,hlsl -o shaders/
  chiaro export look.json --to all -o shaders/

Languages: wgsl, glsl-es300, glsl-330, glsl-450, hlsl, msl, spirv. Beside the shaders lies a JSON file with
uniforms, bindings, attributes, passes, exposed parameters and how they become uniforms. HLSL and MSL are unverified: no
compiler for them runs in Chiaro's tests, and their files say so.";

/// What `chiaro export` is given.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look
    look: PathBuf,
    /// Languages, joined by commas, or `all`
    #[arg(long, value_name = "LANG[,LANG]|all", required = true, value_delimiter = ',')]
    to: Vec<String>,
    /// The folder for the files; made where there is none
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// A folder of a project's own nodes; `nodes/` beside the look is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// List the files as JSON
    #[arg(long, requires = "output")]
    json: bool,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let languages = languages(&arguments.to)?;
    if arguments.output.is_none() && languages.iter().any(|language| language.slug != "wgsl") {
        let problem = Diagnostic::error("bad-argument", "only WGSL is printed; other languages are files");
        return Err(vec![problem.hint("name a folder for them: -o shaders/")]);
    }
    check_nodes_folder(arguments.nodes.as_deref())?;
    let library = library_for(&arguments.look, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let setup = open_look(&arguments.look, output)?;
    let located = |mut problems: Vec<Diagnostic>| {
        setup.source.locate_all(&mut problems);
        problems
    };
    let stem = arguments.look.file_stem().map_or_else(|| "look".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let exported = export::export(&setup.look, &library, &stem, &languages).map_err(located)?;
    output.diagnostics(&located(exported.warnings));
    let Some(folder) = &arguments.output else {
        let own = format!("{stem}.wgsl");
        let shown = exported.files.iter().find(|file| file.name == own);
        output.result(String::from_utf8_lossy(shown.map_or(&[][..], |file| &file.bytes)).trim_end());
        let is_other = |file: &&export::File| file.name != own && file.name.ends_with(".wgsl");
        let others: Vec<_> = exported.files.iter().filter(is_other).map(|file| file.name.as_str()).collect();
        if !others.is_empty() {
            output.message(&format!("it works together with {}; -o writes all files", others.join(", ")));
        }
        return Ok(());
    };
    let files = write(&exported.files, folder, &arguments.look)?;
    let unverified = languages.iter().filter(|language| language.verified_by.is_none());
    let unverified: Vec<&str> = unverified.map(|language| language.label).collect();
    if arguments.json {
        let slugs: Vec<_> = languages.iter().map(|language| language.slug).collect();
        output.json(&json!({"files": files, "languages": slugs, "unverified": unverified}));
    } else {
        files.iter().for_each(|file| output.result(file));
    }
    if !unverified.is_empty() {
        let plural = if unverified.len() == 1 { "is" } else { "are" };
        output
            .message(&format!("{} {plural} unverified: no compiler here has seen the files", unverified.join(" and ")));
    }
    Ok(())
}

fn languages(slugs: &[String]) -> Result<Vec<&'static Language>, Vec<Diagnostic>> {
    let known = LANGUAGES.map(|language| language.slug);
    let mut found: Vec<&'static Language> = Vec::new();
    let mut problems = Vec::new();
    for slug in slugs {
        match (slug.trim(), export::language(slug.trim())) {
            ("all", _) => found.extend(LANGUAGES),
            (_, Some(language)) => found.push(language),
            (slug, None) => {
                let problem = Diagnostic::error("unknown-language", format!("--to cannot be `{slug}`"));
                let hint = format!("the languages are {}, or all", known.join(", "));
                problems.push(problem.suggest(slug, known).hint(hint));
            }
        }
    }
    let mut seen: Vec<&str> = Vec::new();
    found.retain(|language| {
        let is_new = !seen.contains(&language.slug);
        seen.push(language.slug);
        is_new
    });
    if problems.is_empty() { Ok(found) } else { Err(problems) }
}

/// Writes every file, or none where one of them would take the look's own place.
fn write(files: &[export::File], folder: &Path, look: &Path) -> Result<Vec<String>, Vec<Diagnostic>> {
    if let Err(error) = std::fs::create_dir_all(folder) {
        let problem = Diagnostic::error("cannot-write", format!("the folder cannot be made: {error}"));
        return Err(vec![problem.in_file(folder.display().to_string()).hint("choose another with -o")]);
    }
    let own = std::fs::canonicalize(look).ok();
    let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(&file.name)).collect();
    if let Some(path) = paths.iter().find(|path| own.is_some() && std::fs::canonicalize(path).ok() == own) {
        let problem = Diagnostic::error("would-overwrite", "the export's description would replace the look itself");
        return Err(vec![problem.in_file(path.display().to_string()).hint("choose another folder with -o")]);
    }
    for (file, path) in files.iter().zip(&paths) {
        write_atomic(path, &file.bytes).map_err(|problem| vec![*problem])?;
    }
    Ok(paths.iter().map(|path| path.display().to_string()).collect())
}
