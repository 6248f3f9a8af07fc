//! `chiaro gallery`: looks and scenes as a web page.

use std::path::{Path, PathBuf};

use super::open::{check_nodes_folder, library_for};
use super::output::{Output, once};
use super::render::{Size, parse_samples};
use super::target::{OutputPath, outputs};
use crate::diag::{Diagnostic, has_errors};
use crate::files::Disk;
use chiaro_laboratory::gallery::{GalleryOptions, build, check, list};
use chiaro_render::Gpu;

const EXAMPLES: &str = "\
Examples:
  chiaro gallery -o gallery/
  chiaro gallery my-looks/ -o out/ --mesh bunny.obj --size 800x800
  chiaro gallery a.json b.json -o out/ --rounds 0

A folder's gallery.json says what is shown and in which order:
  {\"title\": \"...\", \"about\": \"...\", \"sections\": [{\"title\": \"...\", \"entries\": \
  [\"look.json\"]}]}
An entry may say more: \
{\"file\": \"look.json\", \"mesh\": \"shape:knot\", \"backdrop\": \"#f2ead8\"}, and \"name\",
\"camera\", \"turn_lights\" and \"time\", as chiaro render takes them.
Its paths are from its folder. Without one everything in the folder is, with a section for each \
folder in it.
A look's paragraph is its `about`. A document that cannot be shown is left out and told of.";

/// Arguments of `chiaro gallery`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// Looks, scenes, and folders that hold some; all examples without any
    documents: Vec<PathBuf>,
    /// The folder to write the pages into
    #[arg(short, long)]
    output: OutputPath,
    /// Width and height of the pictures in pixels
    #[arg(short, long, default_value = "720x480")]
    size: Size,
    /// Samples a pixel: 1, or 4 for smooth edges
    #[arg(long, default_value_t = 4, value_parser = parse_samples)]
    samples: u32,
    /// Number of times that each tier is drawn to measure its time, up to 10000; 0 measures neither
    /// times nor errors
    #[arg(short, long, default_value_t = 7, value_parser = parse_rounds)]
    rounds: u32,
    /// A mesh or an own shape (shape:creature) in place of the documents' own
    #[arg(short, long)]
    mesh: Option<String>,
    /// A folder of a project's own nodes; `nodes/` beside a document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Place of the nodes' documentation as seen from the pages, to link them: a path or an address
    #[arg(long)]
    link_nodes: Option<String>,
    /// Replace files that Chiaro did not write, but for another page
    #[arg(long)]
    force: bool,
}

fn parse_rounds(text: &str) -> Result<u32, String> {
    let rounds = text.parse().ok().filter(|rounds| *rounds == 0 || (3..=10_000).contains(rounds));
    rounds.ok_or_else(|| "it is 0, or from 3 to 10000".to_owned())
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    check_nodes_folder(arguments.nodes.as_deref())?;
    let list = if arguments.documents.is_empty() {
        list::examples()?
    } else {
        list::list(&Disk, &arguments.documents)?
    };
    let folder = arguments.output.as_ref();
    let shown = list.sections.iter().flat_map(|section| &section.shown);
    let mut outputs = outputs(arguments.force, shown.map(|shown| &shown.file));
    let own =
        arguments.mesh.as_deref().map(Path::new).into_iter().chain(arguments.nodes.as_deref());
    own.chain(arguments.documents.iter().map(PathBuf::as_path))
        .for_each(|path| outputs.reads(path));
    check(&list, folder, &outputs)?;
    let gpu = Gpu::headless().await.map_err(|error| vec![error.into()])?;
    let options = GalleryOptions {
        size: arguments.size.0,
        samples: arguments.samples,
        rounds: arguments.rounds as usize,
        mesh: arguments.mesh.clone(),
        nodes: arguments.link_nodes.clone(),
    };
    let find = |document: &Path| library_for(document, arguments.nodes.as_deref());
    let made = output
        .watch_async("drawing", async |progress| {
            build(&list, folder, &mut outputs, &gpu, &find, &options, progress).await
        })
        .await?;
    let problems = once(made.problems);
    let page = folder.join("index.html");
    let plural = if made.pages == 1 { "page" } else { "pages" };
    if made.pages > 0 {
        output.message(&format!("{}: {} {plural}", page.display(), made.pages));
    }
    if has_errors(&problems) {
        return Err(problems);
    }
    output.diagnostics(&problems);
    Ok(())
}
