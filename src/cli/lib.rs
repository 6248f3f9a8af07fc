//! The command line: one file a subcommand.
//!
//! Results go to standard output, messages to standard error. Exit codes: 0 for success; 1 if a
//! document, an asset or the GPU is at fault, as a diagnostic tells; 2 if the command line is; 130
//! if the program was ended by Ctrl-C, with no file half written.

use chiaro_compiler::{catalog, compile, document, library};
use chiaro_files as files;
use chiaro_film as film;
use chiaro_language::{clock, diag, figures, ids, milestones, progress};
use chiaro_reference as reference;
use chiaro_scene::{frame, threads};

#[cfg(feature = "sweeps")]
mod accuracy;
#[cfg(feature = "gpu")]
mod bench;
mod check;
mod comp;
mod desktop;
#[cfg(feature = "gpu")]
mod eval;
mod explain;
mod export;
mod farm;
mod fit;
mod frame_files;
#[cfg(feature = "gpu")]
mod gallery;
mod hcbtf;
mod import;
mod interrupt;
mod lights;
mod mesh;
mod movie;
mod new;
mod nodes;
mod open;
mod output;
mod probe;
mod render;
#[cfg(feature = "gpu")]
mod samples;
mod scene;
mod sheet;
mod shot;
mod target;
mod tier;
#[cfg(feature = "gpu")]
mod tune;
mod used_files;
mod verify;
mod view;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory as _, Parser, Subcommand};

use crate::diag::Diagnostic;
use output::Output;

pub use target::OutputPath;

/// Draw with light: stylized shading as a graph, compiled to one readable WGSL shader.
#[derive(Debug, Parser)]
#[command(
    name = "chiaro", version, max_term_width = 100, after_help = EXAMPLES,
    args_conflicts_with_subcommands = true
)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    /// A look or a scene to open in the editor
    file: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  chiaro
  chiaro new rim
  chiaro rim.json
  chiaro render rim.json -o rim.png --mesh bunny.obj
  chiaro check examples/
  chiaro export rim.json --to glsl-450 -o shaders/

Results go to standard output, messages to standard error. What a command reads is never written
over, and files that Chiaro did not make are replaced with --force only.
Exit codes: 0 done; 1 something in a document, an asset or the GPU is at fault (a message says
what); 2 the command line is wrong; 130 ended by Ctrl-C, with no file half written.";

#[derive(Debug, Subcommand)]
enum Command {
    /// Open a look, a scene or an HCBTF in the editor (also what `chiaro` and `chiaro FILE` do)
    #[command(after_help = EDIT_EXAMPLES)]
    Edit {
        /// A look or a scene
        files: Vec<PathBuf>,
        /// The mesh to see it on: a file (OBJ, PLY, STL, glTF, GLB) or an own shape (shape:knot);
        /// one that lies on its back is stood up by Options, "Z is up"
        #[arg(short, long)]
        mesh: Option<String>,
    },
    /// Write a look, a scene or a shot to begin with
    New(new::Arguments),
    /// Tell everything that is wrong or odd in looks, scenes and shots
    Check(check::Arguments),
    /// Tell what is drawn, in which passes, on which data, and why
    Explain(explain::Arguments),
    /// List a scene's lights, and tell which of them reach which objects, by which rule
    Lights(lights::Arguments),
    /// Tell what a shot changes, and by which file; take a change back
    Shot(shot::Arguments),
    /// List the nodes that looks are made of, or tell all about one
    Nodes(nodes::Arguments),
    /// Render a look, a scene or a shot to a PNG or an EXR, or to many
    Render(render::Arguments),
    /// Draw one picture for each combination of values, on a sheet with labels
    Wedge(render::wedge::Arguments),
    /// Read frames again: whole or not, and equal to those of another run or not
    Verify(verify::Arguments),
    /// Show frames side by side
    Sheet(sheet::Arguments),
    /// Make a movie of frames, for review
    Movie(movie::Arguments),
    /// Write the Nuke script or Blender's compositor that puts frames together from their layers
    Comp(comp::Arguments),
    /// Write the job by which a render farm draws frames
    Farm(farm::Arguments),
    /// Print a look's value, or any node's, at given surface samples
    #[cfg(feature = "gpu")]
    Eval(eval::Arguments),
    /// Measure what a look costs and how far it is from the truth, whole and node by node
    #[cfg(feature = "gpu")]
    Bench(bench::Arguments),
    /// Pick the cheapest tiers under a stated error, or the most accurate within a stated time
    #[cfg(feature = "gpu")]
    Tune(tune::Arguments),
    /// Turn a look's lights, profiles and colors until it shows what was painted on its picture
    Fit(fit::Arguments),
    /// Tell the value on every wire at one pixel, f32 beside f64
    Probe(probe::Arguments),
    /// Measure how far every node and every example look is from the truth, and write it down
    #[cfg(feature = "sweeps")]
    Accuracy(accuracy::Arguments),
    /// Show looks and scenes as a web page, with their graphs, shaders and costs
    #[cfg(feature = "gpu")]
    Gallery(gallery::Arguments),
    /// Write a look as shaders for other programs
    Export(export::Arguments),
    /// Tell what a mesh file holds: size, materials, animations, cameras
    Mesh(mesh::Arguments),
    /// Make a look of another program's graph: a MaterialX document, Blender's shader nodes
    Import(import::Arguments),
    /// Tell what a hand-painted 6D texture (.hcbtf) holds, make one, exchange its samples with
    /// other programs
    Hcbtf(hcbtf::Arguments),
    /// Put Chiaro and its file types into the desktop's menu, or take them out
    Desktop(desktop::Arguments),
}

const EDIT_EXAMPLES: &str = "\
Examples:
  chiaro edit
  chiaro edit examples/looks/figure1-layers.json";

/// Codes of diagnostics about the command line itself, which are printed like the argument parser's
/// own.
const USAGE: [&str; 2] = ["bad-argument", "unknown-language"];

/// Task for `main` after the command line was read.
#[derive(Debug)]
pub enum Outcome {
    /// The command has run; `main` exits with this code.
    Done(ExitCode),
    /// The editor is to be opened with these files.
    Edit {
        /// Paths of looks; the first one is shown.
        files: Vec<PathBuf>,
        /// The mesh to see it on.
        mesh: Option<String>,
    },
}

/// The argument parser of the command line.
pub fn command() -> clap::Command {
    Arguments::command()
}

/// Reads the command line and runs the subcommand, except for the editor, which `main` opens.
pub fn run() -> Outcome {
    milestones::reached("program");
    files::cache::open_for_user();
    threads::prepare_pool();
    let output = Output::new();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.use_stderr() => {
            // The parser takes a mistyped command for a file, which no arguments may follow.
            let first = std::env::args_os().nth(1).map(PathBuf::from);
            let is_command =
                |word: &PathBuf| subcommands().iter().any(|known| word == Path::new(known));
            match first.filter(|word| !is_command(word) && is_mistyped(word)) {
                Some(word) => unknown_subcommand(&word).exit(),
                None => error.exit(),
            }
        }
        // Help and the version are results like any other.
        Err(help) => {
            output.help(&help);
            return Outcome::Done(finished(Ok(()), &output));
        }
    };
    let command = match arguments {
        Arguments { command: Some(Command::Edit { files, mesh }), .. } => {
            return Outcome::Edit { files, mesh };
        }
        Arguments { command: Some(command), .. } => command,
        Arguments { file: Some(word), .. } if is_mistyped(&word) => {
            unknown_subcommand(&word).exit()
        }
        Arguments { file, .. } => {
            return Outcome::Edit { files: file.into_iter().collect(), mesh: None };
        }
    };
    interrupt::clean_up_on_interrupt();
    threads::with_room(|| wait(carry_out(&command, &output)))
}

/// Blocks until a future is done: the one place of the command line that does, as it has no other
/// work meanwhile.
#[expect(
    clippy::disallowed_methods,
    reason = "the command line waits for the GPU, and nobody else"
)]
fn wait<T>(future: impl Future<Output = T>) -> T {
    pollster::block_on(future)
}

/// Runs a subcommand.
async fn carry_out(command: &Command, output: &Output) -> Outcome {
    let result = match command {
        Command::Edit { .. } => Ok(()),
        Command::New(arguments) => new::run(arguments, output),
        Command::Check(arguments) => match check::run(arguments, output) {
            // The problems were printed: they are the result of a check.
            Ok(true) => Err(Vec::new()),
            found => found.map(drop),
        },
        Command::Explain(arguments) => explain::run(arguments, output).await,
        Command::Lights(arguments) => lights::run(arguments, output),
        Command::Shot(arguments) => shot::run(arguments, output),
        Command::Nodes(arguments) => nodes::run(arguments, output).await,
        Command::Render(arguments) => render::run(arguments, output).await,
        Command::Wedge(arguments) => render::wedge::run(arguments, output).await,
        Command::Verify(arguments) => verify::run(arguments, output),
        Command::Sheet(arguments) => sheet::run(arguments, output),
        Command::Movie(arguments) => movie::run(arguments, output),
        Command::Comp(arguments) => comp::run(arguments, output),
        Command::Farm(arguments) => farm::run(arguments, output),
        #[cfg(feature = "gpu")]
        Command::Eval(arguments) => eval::run(arguments, output).await,
        #[cfg(feature = "gpu")]
        Command::Bench(arguments) => bench::run(arguments, output).await,
        #[cfg(feature = "gpu")]
        Command::Tune(arguments) => tune::run(arguments, output).await,
        Command::Fit(arguments) => fit::run(arguments, output),
        Command::Probe(arguments) => probe::run(arguments, output),
        #[cfg(feature = "sweeps")]
        Command::Accuracy(arguments) => accuracy::run(arguments, output).await,
        #[cfg(feature = "gpu")]
        Command::Gallery(arguments) => gallery::run(arguments, output).await,
        Command::Export(arguments) => export::run(arguments, output).await,
        Command::Mesh(arguments) => mesh::run(arguments, output),
        Command::Import(arguments) => import::run(arguments, output),
        Command::Hcbtf(arguments) => hcbtf::run(arguments, output).await,
        Command::Desktop(arguments) => desktop::run(arguments, output),
    };
    Outcome::Done(finished(result, output))
}

/// Prints the errors of a command, including a result that could not be printed. Returns the exit
/// code.
fn finished(result: Result<(), Vec<Diagnostic>>, output: &Output) -> ExitCode {
    if result.is_err() && interrupt::is_interrupted() {
        return ExitCode::from(interrupt::INTERRUPTED);
    }
    let mut code = match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(problems) => {
            output.diagnostics(&problems);
            let is_usage = |problem: &Diagnostic| USAGE.contains(&problem.code);
            let is_all_usage = !problems.is_empty() && problems.iter().all(is_usage);
            if is_all_usage { ExitCode::from(2) } else { ExitCode::FAILURE }
        }
    };
    if let Err(problem) = output.finish() {
        output.diagnostics(&[problem]);
        code = ExitCode::FAILURE;
    }
    code
}

/// True if a word that is no subcommand was meant as one: no file has this name, and it does not
/// look like a file name.
fn is_mistyped(word: &Path) -> bool {
    let is_option = word.to_string_lossy().starts_with('-');
    !is_option && !word.exists() && word.extension().is_none() && word.components().count() == 1
}

/// Names of the subcommands, with those that the parser adds by itself, such as `help`.
fn subcommands() -> Vec<String> {
    let mut command = command();
    command.build();
    command.get_subcommands().map(|subcommand| subcommand.get_name().to_owned()).collect()
}

fn unknown_subcommand(word: &Path) -> clap::Error {
    let word = word.to_string_lossy();
    let alike = |name: &String| strsim::damerau_levenshtein(name, &word) <= 2;
    let near = subcommands().into_iter().find(alike);
    let tip = near.map_or_else(String::new, |near| {
        format!("\n\n  tip: a similar subcommand exists: '{near}'")
    });
    command().error(
        ErrorKind::InvalidSubcommand,
        format!("unrecognized subcommand or file '{word}'{tip}"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_alone_is_opened_and_a_mistyped_subcommand_is_told() {
        let read = |words: &[&str]| {
            Arguments::try_parse_from(std::iter::once("chiaro").chain(words.iter().copied()))
        };
        let opened = read(&["looks/rim.json"]).unwrap();
        assert!(opened.command.is_none() && opened.file == Some("looks/rim.json".into()));
        assert!(read(&[]).unwrap().file.is_none());
        assert!(matches!(read(&["check", "a.json"]).unwrap().command, Some(Command::Check(_))));
        assert!(read(&["a.json", "check"]).is_err());
        for (word, is_mistyped_one) in
            [("rendr", true), ("rim.json", false), ("looks/rim", false), ("templates", false)]
        {
            assert_eq!(is_mistyped(Path::new(word)), is_mistyped_one, "{word}");
        }
        let told = unknown_subcommand(Path::new("rendr")).to_string();
        assert!(subcommands().iter().any(|name| name == "help"));
        assert!(
            told.contains("'rendr'") && (cfg!(not(feature = "gpu")) || told.contains("'render'")),
            "{told}"
        );
    }
}
