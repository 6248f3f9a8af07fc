//! Documentation of nodes for a terminal.

use std::fmt::Write as _;

use super::super::tier;
use super::entry::{NodeEntry, default_text, json_text, range_text};
use crate::library::Input;

/// Table with one line a node, by category.
pub(super) fn table(entries: &[NodeEntry]) -> String {
    let width = |of: fn(&NodeEntry) -> &str| {
        entries.iter().map(|entry| of(entry).chars().count()).max().unwrap_or(0)
    };
    let (kinds, labels) = (width(|entry| &entry.kind), width(|entry| &entry.label));
    let mut text = String::new();
    let mut category = "";
    for entry in entries {
        if entry.category != category {
            category = &entry.category;
            let _ = writeln!(text, "{}{category}", if text.is_empty() { "" } else { "\n" });
        }
        let inputs: Vec<&str> = entry.inputs.iter().map(|input| input.name.as_str()).collect();
        let outputs: Vec<&str> = entry.outputs.iter().map(|output| output.name.as_str()).collect();
        let ports = format!("{} -> {}", inputs.join(", "), outputs.join(", "));
        let line = format!("  {:kinds$}  {:labels$}  {}", entry.kind, entry.label, ports.trim());
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let _ =
        write!(text, "\n{} kinds of nodes; `chiaro nodes KIND` tells all about one", entries.len());
    text
}

/// All documentation of one node.
pub(super) fn whole(entry: &NodeEntry) -> String {
    let what = if entry.is_group { "a group of" } else { "of" };
    let mut text =
        format!("{} ({}), {what} the category {}\n", entry.label, entry.kind, entry.category);
    for paragraph in entry.help.split("\n\n").filter(|paragraph| !paragraph.is_empty()) {
        text += &format!("\n{}\n", wrapped(paragraph, ""));
    }
    if !entry.inputs.is_empty() {
        text += "\nInputs\n";
        entry.inputs.iter().for_each(|input| text += &input_lines(input));
    }
    if !entry.outputs.is_empty() {
        text += "\nOutputs\n";
        for output in &entry.outputs {
            let _ = writeln!(text, "  {}  {}, {}", output.name, output.label, output.ty);
            if !output.help.is_empty() {
                let _ = writeln!(text, "{}", wrapped(&output.help, "      "));
            }
        }
    }
    if !entry.presets.is_empty() {
        text += "\nPresets\n";
        for preset in &entry.presets {
            let values =
                preset.values.iter().map(|(name, value)| format!("{name} {}", json_text(value)));
            let _ = writeln!(text, "  {}: {}", preset.label, values.collect::<Vec<_>>().join(", "));
        }
    }
    if !entry.widths.is_empty() {
        let widths: Vec<String> = entry.widths.iter().map(ToString::to_string).collect();
        let _ = writeln!(
            text,
            "\nWhere a wire brings it, works number by number in {}.",
            widths.join(", ")
        );
    }
    if !entry.errors.is_empty() {
        text += "\nTiers, and how far from exact they are at most\n";
        for error in &entry.errors {
            let _ = writeln!(text, "  {}  {:?}", tier::word(error.tier), error.bound);
            if !error.help.is_empty() {
                let _ = writeln!(text, "{}", wrapped(&error.help, "      "));
            }
        }
    }
    if !entry.sources.is_empty() {
        let _ = writeln!(text, "\nSource: {}", entry.sources.join("; "));
    }
    text.trim_end().to_owned()
}

fn input_lines(input: &Input) -> String {
    let mut facts = vec![input.label.clone(), input.ty.to_string(), default_text(input)];
    facts.push(range_text(input));
    facts.push(input.unit.clone());
    facts.retain(|fact| !fact.is_empty());
    let mut text = format!("  {}  {}\n", input.name, facts.join(", "));
    if !input.options.is_empty() {
        let options: Vec<String> =
            input.options.iter().map(|(word, _)| format!("\"{word}\"")).collect();
        text += &format!("{}\n", wrapped(&format!("one of {}", options.join(", ")), "      "));
    }
    if !input.help.is_empty() {
        text += &format!("{}\n", wrapped(&input.help, "      "));
    }
    text
}

/// The text in lines of at most 96 characters, each indented by `indent`.
fn wrapped(text: &str, indent: &str) -> String {
    const WIDTH: usize = 96;
    let mut lines = vec![indent.to_owned()];
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("there is one at the start");
        let is_begun = line.len() > indent.len();
        if is_begun && line.chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push(format!("{indent}{word}"));
        } else {
            line.push_str(if is_begun { " " } else { "" });
            line.push_str(word);
        }
    }
    lines.join("\n")
}
