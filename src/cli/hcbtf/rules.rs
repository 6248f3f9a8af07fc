//! `chiaro hcbtf rules`: the rules of a file as JSON, and their replacement.

use std::path::PathBuf;

use super::open;
use crate::diag::Diagnostic;
use crate::document::{HcbtfEdit, Rule, read_rules};
use crate::files::{Disk, OutputKind, read_text};
use crate::output::Output;
use crate::target::outputs;
use chiaro_scene::hcbtf::{load, write};

/// Width of the help, in columns.
const WIDTH: usize = 98;

/// Arguments of `chiaro hcbtf rules`.
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Arguments {
    /// An .hcbtf file
    file: PathBuf,
    /// A JSON file with the list of rules that take the place of the present ones, as
    /// docs/format.md tells them
    #[arg(long, value_name = "RULES.json")]
    set: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let Some(path) = &arguments.set else {
        output.result(open(&arguments.file, output)?.rules_text().trim_end());
        return Ok(());
    };
    let (mut hcbtf, warnings) = load(&Disk, &arguments.file)?.into_parts();
    // The rules that were there so far go: nobody need hear what is odd about them.
    let is_of_rules = |warning: &Diagnostic| {
        warning.place.json_path.as_deref().is_some_and(|path| path.starts_with("rules["))
    };
    output.diagnostics(&warnings.into_iter().filter(|one| !is_of_rules(one)).collect::<Vec<_>>());
    let text = read_text(path).map_err(|problem| vec![*problem])?;
    let name = path.display().to_string();
    let read = read_rules(&text, &hcbtf.grid, &name);
    if read.has_errors() {
        return Err(read.diagnostics);
    }
    output.diagnostics(&read.diagnostics);
    let (rules, unknown) = read.value.unwrap_or_default();
    hcbtf.apply(HcbtfEdit::SetRules { rules, unknown }).map_err(|problem| vec![*problem])?;
    let named = arguments.file.display().to_string();
    let bytes = write(&hcbtf).map_err(|problem| vec![problem.in_file(named.clone())])?;
    let mut outputs = outputs(false, [path]);
    outputs.changes(&arguments.file);
    outputs
        .write(&arguments.file, OutputKind::DOCUMENT, &bytes)
        .map_err(|problem| vec![problem])?;
    output.result(&named);
    Ok(())
}

/// Help with every rule, from the one list of rules.
fn help() -> String {
    let mut help = "Examples:\n  chiaro hcbtf rules grass.hcbtf > rules.json\n  \
                    echo '[{\"rule\": \"blend\"}, {\"rule\": \"lambert\", \"amount\": 0.6}]' > \
                    rules.json\n  \
                    chiaro hcbtf rules grass.hcbtf --set rules.json\n\n\
                    Rules by their words in files, with what the window calls them. What a file \
                    leaves out is as in brackets.\n"
        .to_owned();
    for about in Rule::ABOUT {
        help += &format!("\n  {:<10}{}\n", about.word, about.label);
        help += &wrapped(&plain(about.does.english()), 12);
        for field in about.fields() {
            help += &wrapped(&plain(&field.line()), 14);
        }
    }
    help
}

/// The text without Markdown's marks.
fn plain(text: &str) -> String {
    text.replace(['`', '*'], "")
}

/// The text in lines that are indented by `indent` spaces.
fn wrapped(text: &str, indent: usize) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if indent + line.len() + 1 + word.len() <= WIDTH => {
                *line += &format!(" {word}");
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| format!("{}{line}\n", " ".repeat(indent))).collect()
}
