//! The command line: one file a subcommand.
//!
//! Exit codes: 0 done; 1 the document, an asset or the GPU is at fault, and a diagnostic says how; 2 the command line is.

#[cfg(feature = "gpu")]
mod eval;
mod output;
#[cfg(feature = "gpu")]
mod render;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::diag::Diagnostic;
use output::Output;

/// Draw with light: stylized shading as a graph, compiled to one readable WGSL shader.
#[derive(Debug, Parser)]
#[command(name = "chiaro", version, max_term_width = 100, after_help = EXAMPLES)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
}

const EXAMPLES: &str = "\
Examples:
  chiaro edit examples/looks/first.json
  chiaro render examples/looks/first.json -o first.png --mesh bunny.obj
  chiaro eval my.json --at samples.json

Exit codes: 0 done; 1 something in a document, an asset or the GPU is at fault (a message says what);
2 the command line is wrong.";

#[derive(Debug, Subcommand)]
enum Command {
    /// Open looks or scenes in the editor (also what `chiaro` alone does)
    Edit {
        /// Looks or scenes.
        files: Vec<PathBuf>,
    },
    /// Render a look or a scene to a PNG
    #[cfg(feature = "gpu")]
    Render(render::Arguments),
    /// Print a look's value, or any node's, at given surface samples
    #[cfg(feature = "gpu")]
    Eval(eval::Arguments),
}

/// What `main` does after the command line was read.
#[derive(Debug)]
pub enum Outcome {
    /// It is done.
    Done(ExitCode),
    /// The editor is to be opened with these files.
    Edit(Vec<PathBuf>),
}

/// Reads the command line and does what it says, but for the editor, which `main` opens.
pub fn run() -> Outcome {
    let arguments = Arguments::parse();
    let output = Output::new();
    let result: Result<(), Vec<Diagnostic>> = match arguments.command {
        None => return Outcome::Edit(Vec::new()),
        Some(Command::Edit { files }) => return Outcome::Edit(files),
        #[cfg(feature = "gpu")]
        Some(Command::Render(arguments)) => render::run(&arguments, &output),
        #[cfg(feature = "gpu")]
        Some(Command::Eval(arguments)) => eval::run(&arguments, &output),
    };
    Outcome::Done(match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(problems) => {
            output.diagnostics(&problems);
            ExitCode::FAILURE
        }
    })
}
