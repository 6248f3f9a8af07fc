//! `chiaro hcbtf rules`: the rules of a file as JSON, and others in their place.

use std::path::PathBuf;

use serde_json::json;

use super::open;
use crate::cli::output::Output;
use crate::diag::Diagnostic;
use crate::document::{Hcbtf, Rule, read_text, write_atomic};
use crate::hcbtf::write;

/// What `chiaro hcbtf rules` is given.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// An .hcbtf file
    file: PathBuf,
    /// A JSON file with the list of rules that take the place of the present ones, as docs/format.md tells them
    #[arg(long, value_name = "RULES.json")]
    set: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let hcbtf = open(&arguments.file, output)?;
    let Some(path) = &arguments.set else {
        output.json(&json!(hcbtf.rules));
        return Ok(());
    };
    let text = read_text(path).map_err(|problem| vec![*problem])?;
    let name = path.display().to_string();
    let rules = serde_json::from_str::<Vec<Rule>>(&text).map_err(|error| {
        let problem = Diagnostic::error("hcbtf-rule", format!("these are no rules: {error}"));
        vec![problem.in_file(name).hint("write a list of rules; without --set this command shows how they look")]
    })?;
    let named = arguments.file.display().to_string();
    let bytes = write(&Hcbtf { rules, ..hcbtf }).map_err(|problem| vec![problem.in_file(named.clone())])?;
    write_atomic(&arguments.file, &bytes).map_err(|problem| vec![*problem])?;
    output.result(&named);
    Ok(())
}
