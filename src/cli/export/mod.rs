//! `chiaro export`: a look as shaders for other programs, with a description of all inputs that
//! they need.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::open::{check_nodes_folder, library_for, open_look};
use super::output::Output;
use super::target::{OutputPath, outputs};
use super::tier::{self, TierChoice};
use crate::diag::Diagnostic;
use crate::document::Storage;
use crate::frame::{Assets, SetupLook};
use crate::library::Library;
use chiaro_scene::export::package::{PACKAGES, package};
use chiaro_scene::export::{self, ExportOptions};

mod package;
mod watch;

/// Text below the options: examples, languages, and all packages.
fn after_help() -> String {
    let packages =
        PACKAGES.iter().map(|package| format!("  {:<8} {}\n", package.slug, package.help));
    format!(
        "{EXAMPLES}\n\nPackages, folders that run where they arrive:\n{}",
        packages.collect::<String>()
    )
}

const EXAMPLES: &str = "\
Examples:
  chiaro export look.json --to wgsl                         the WGSL, on standard output
  chiaro export look.json --to glsl-es300 -o web/
  chiaro export look.json --to wgsl,spirv,hlsl -o shaders/
  chiaro export look.json --to all -o shaders/
  chiaro export look.json --to hlsl --tier auto -o shaders/
  chiaro export look.json --to web -o page/ --mesh shape:creature
  chiaro export look.json --to three -o game/look --watch
  chiaro export look.json --to wgsl --live -o shaders/      with every value as a parameter

Languages: wgsl, glsl-es300, glsl-330, glsl-450, hlsl, slang, msl, spirv. Beside the shaders lies \
a JSON file with
uniforms, bindings, attributes, passes, exposed parameters and how they become uniforms. MSL is \
unverified: no compiler
for it runs in Chiaro's tests, and its files say so.";

/// Arguments of `chiaro export`.
#[derive(Debug, clap::Args)]
#[command(after_help = after_help())]
pub(super) struct Arguments {
    /// A look
    look: PathBuf,
    /// Languages, joined by commas, or `all`; or a package, which runs where it arrives
    #[arg(long, value_name = "LANG[,LANG]|all|PACKAGE", required = true, value_delimiter = ',')]
    to: Vec<String>,
    /// The folder for the files; made where there is none
    #[arg(short, long)]
    output: Option<OutputPath>,
    /// The implementation to export of every node: exact, balanced, fast, or auto, the cheapest
    /// that nobody can see, and the nearest that an export carries, which is told; the document's
    /// without it
    #[arg(long, value_parser = tier::parse)]
    tier: Option<TierChoice>,
    /// A mesh (OBJ, PLY, STL, glTF, GLB) or an own shape (shape:creature) that a package shows the
    /// look on
    #[arg(short, long)]
    mesh: Option<String>,
    /// Export every value as a parameter that can be set, not only those that the look exposes:
    /// each in the group of its node, with its range, default, unit and help. The shader is slower,
    /// because it computes what was known before
    #[arg(long)]
    live: bool,
    /// Store painted surfaces in another way than their nodes say: quick, compact or blocks.
    /// Without it, packages have them compact where a node says quick
    #[arg(long, value_name = "STORAGE", value_parser = parse_storage)]
    textures: Option<Storage>,
    /// Export again whenever the look or what it reads changes, until Ctrl-C
    #[arg(long, requires = "output")]
    watch: bool,
    /// A folder of a project's own nodes; `nodes/` beside the look is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Replace files that no export has written
    #[arg(long, requires = "output")]
    force: bool,
    /// List the files as JSON
    #[arg(long, requires = "output")]
    json: bool,
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    if arguments.watch {
        watch::run(arguments, output).await
    } else {
        export(arguments, output).await
    }
}

/// Exports once.
async fn export(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    if let [slug] = &arguments.to[..]
        && let Some(package) = package(slug.trim())
    {
        return package::run(arguments, package, output).await;
    }
    if arguments.mesh.is_some() {
        let problem = Diagnostic::error("bad-argument", "--mesh is for packages");
        return Err(vec![problem.hint("languages are for any mesh: leave it out")]);
    }
    let languages = export::languages(arguments.to.iter().map(String::as_str))?;
    if arguments.output.is_none() && languages.iter().any(|language| language.slug != "wgsl") {
        let problem =
            Diagnostic::error("bad-argument", "only WGSL is printed; other languages are files");
        return Err(vec![problem.hint("name a folder for them: -o shaders/")]);
    }
    let folder = arguments.output.as_ref().map(AsRef::as_ref);
    if let Some(folder) = folder {
        check_folder(folder).map_err(|problem| vec![problem])?;
    }
    check_nodes_folder(arguments.nodes.as_deref())?;
    let mut library = library_for(&arguments.look, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut setup = open_look(&arguments.look, output)?;
    apply_options(arguments, &mut setup, &mut library, false, output)?;
    let located = |mut problems: Vec<Diagnostic>| {
        setup.source.locate_all(&mut problems);
        problems
    };
    let stem = stem(arguments);
    let place = (setup.folder.as_path(), &mut Assets::default());
    let exported =
        export::export(&setup.look, &library, &stem, &languages, place).map_err(located)?;
    output.diagnostics(&located(exported.warnings));
    let Some(folder) = folder else {
        let own = format!("{stem}.wgsl");
        let shown = exported.value.iter().find(|file| file.name == own);
        output
            .result(String::from_utf8_lossy(shown.map_or(&[][..], |file| &file.bytes)).trim_end());
        let is_other =
            |file: &&export::ExportFile| file.name != own && file.name.ends_with(".wgsl");
        let others: Vec<_> =
            exported.value.iter().filter(is_other).map(|file| file.name.as_str()).collect();
        if !others.is_empty() {
            output.message(&format!(
                "it works together with {}; -o writes all files",
                others.join(", ")
            ));
        }
        return Ok(());
    };
    let read = [Some(&arguments.look), arguments.nodes.as_ref()].into_iter().flatten();
    let mut outputs = outputs(arguments.force, read);
    let files = export::write(&exported.value, folder, &mut outputs)?;
    let files: Vec<String> = files.iter().map(|path| path.display().to_string()).collect();
    if arguments.json {
        let unverified = languages.iter().filter(|language| language.verified_by.is_none());
        let unverified: Vec<&str> = unverified.map(|language| language.label).collect();
        let slugs: Vec<_> = languages.iter().map(|language| language.slug).collect();
        let tiers = tier::counts(&setup.look, &library);
        output.json(&json!({
            "files": files, "languages": slugs, "unverified": unverified, "tiers": tiers,
        }));
    } else {
        files.iter().for_each(|file| output.result(file));
        tier::told(&setup.look, &library).iter().for_each(|told| output.message(told));
    }
    if let Some(told) = export::unverified(&languages) {
        output.message(&told);
    }
    Ok(())
}

/// Beginning of the names of the exported files: the name of the look's file without its ending.
fn stem(arguments: &Arguments) -> String {
    let stem = arguments.look.file_stem();
    stem.map_or_else(|| "look".to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// Changes a look as the arguments ask, and tells what an export does not carry; `is_package` where
/// it goes into a package.
fn apply_options(
    arguments: &Arguments,
    worn: &mut SetupLook,
    library: &mut Library,
    is_package: bool,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    if let Some(tier) = arguments.tier {
        tier::set_every_tier(&mut worn.look, library, tier);
    }
    let options = ExportOptions {
        takes_carried_tiers: arguments.tier == Some(TierChoice::Automatic),
        is_live: arguments.live,
        storage: arguments.textures,
    };
    let mut told = options.apply(&mut worn.look, library, is_package);
    let (Ok(problems) | Err(problems)) = &mut told;
    worn.source.locate_all(problems);
    output.diagnostics(&told?);
    Ok(())
}

/// The storage of painted surfaces that a word names, for clap.
fn parse_storage(word: &str) -> Result<Storage, String> {
    let names = || Storage::ALL.map(Storage::word).join(", ");
    Storage::of(word).ok_or_else(|| format!("a storage is one of {}", names()))
}

/// Refuses a path that is no folder, or whose name ends like a file of some language: nobody looks
/// for shaders in a folder `rim.wgsl`.
fn check_folder(path: &Path) -> Result<(), Diagnostic> {
    const ENDINGS: [&str; 13] = [
        "wgsl", "glsl", "vert", "frag", "hlsl", "slang", "msl", "metal", "spv", "spirv", "json",
        "png", "ktx2",
    ];
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let is_like_file = ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()));
    if path.is_file() || (is_like_file && !path.is_dir()) {
        let message =
            format!("-o names a folder, and `{}` is a file or is called like one", path.display());
        let hint =
            "name a folder, as -o shaders/: an export is several files, named after the look";
        return Err(Diagnostic::error("bad-argument", message).hint(hint));
    }
    Ok(())
}
