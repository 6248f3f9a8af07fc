//! `chiaro export --to PACKAGE`: a folder that runs where it arrives.

use serde_json::json;

use super::super::open::{check_nodes_folder, library_for, not_a_look};
use super::super::output::Output;
use super::super::render::executor;
use super::super::target::outputs;
use super::super::tier;
use super::Arguments;
use crate::diag::Diagnostic;
use crate::document::Document;
use crate::frame::{Assets, open};
use chiaro_scene::export;
use chiaro_scene::export::package::{Package, PackageScene, draw_expected, export_package};

/// Exports a look as a package.
pub(super) async fn run(
    arguments: &Arguments,
    package: &Package,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    let Some(folder) = arguments.output.as_ref().map(AsRef::as_ref) else {
        let problem = Diagnostic::error("bad-argument", "a package is a folder");
        return Err(vec![problem.hint(format!("name one for it: -o {}/", package.slug))]);
    };
    super::check_folder(folder).map_err(|problem| vec![problem])?;
    check_nodes_folder(arguments.nodes.as_deref())?;
    let mut library = library_for(&arguments.look, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    if let Document::Scene(scene) = Document::load(&crate::files::Disk, &arguments.look) {
        return Err(vec![not_a_look(&arguments.look, scene.value.as_ref())]);
    }
    let mut assets = Assets::default();
    let opened = open(&arguments.look, arguments.mesh.as_deref(), &mut assets)?;
    let (mut setup, warnings) = opened.into_parts();
    output.diagnostics(&warnings);
    for worn in &mut setup.looks {
        super::apply_options(arguments, worn, &mut library, true, output)?;
    }
    let worn = &setup.looks[0];
    let stem = super::stem(arguments);
    let located = |mut problems: Vec<Diagnostic>| {
        worn.source.locate_all(&mut problems);
        problems
    };
    let place = (worn.folder.as_path(), &mut assets);
    let scene = PackageScene::of(&setup).ok_or_else(|| {
        vec![Diagnostic::error("empty-scene", "there is no mesh to show the look on")]
    })?;
    let exported = export_package(&worn.look, &library, &stem, package, &scene, place);
    let exported = exported.map_err(located)?;
    // A package may have taken cheaper tiers, which the warnings tell.
    let has_own_tiers = exported.warnings.iter().all(|warning| warning.code != "cheaper-tier");
    output.diagnostics(&located(exported.warnings));
    let mut files = exported.value;
    let mut executor = executor(None, output).await.map_err(|problem| vec![problem])?;
    let expected = output
        .watch_async("drawing", async |progress| {
            draw_expected(&setup, &library, assets, &mut *executor, progress).await
        })
        .await?;
    files.push(expected);
    let read = [Some(&arguments.look), arguments.nodes.as_ref()].into_iter().flatten();
    let mut outputs = outputs(arguments.force, read);
    let written = export::write(&files, folder, &mut outputs)?;
    let names: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    let opens = package.opens.map(|name| folder.join(name).display().to_string());
    if arguments.json {
        let tiers = tier::counts(&worn.look, &library);
        output.json(&json!({
            "files": names, "package": package.slug, "opens": opens, "tiers": tiers,
        }));
    } else {
        names.iter().for_each(|file| output.result(file));
        let told = tier::told(&worn.look, &library).filter(|_| has_own_tiers);
        told.iter().for_each(|told| output.message(told));
        if let Some(opens) = opens {
            output.message(&format!("open {opens}"));
        }
    }
    Ok(())
}
