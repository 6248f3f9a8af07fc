//! docs/nodes.md: all documentation that is needed to write a look by hand.

use std::fmt::Write as _;

use super::super::tier;
use super::entry::{NodeEntry, default_text, json_text, range_text};
use crate::library::{Context, Conversion, Input, Rate, Type};

const HEAD: &str = include_str!("head.md");
const CUSTOM: &str = include_str!("custom.md");
/// The gallery's samples, by kind.
type Samples = serde_json::Map<String, serde_json::Value>;

/// The whole document.
pub(super) fn document(entries: &[NodeEntry]) -> String {
    let mut text = HEAD
        .replace("{{conversions}}", &conversions())
        .replace("{{surroundings}}", &surroundings());
    text += "\n## All nodes\n\n";
    for (category, entries) in by_category(entries) {
        let link = |entry: &NodeEntry| format!("[`{0}`](#{0})", entry.kind);
        let links: Vec<String> = entries.iter().map(|entry| link(entry)).collect();
        let _ = writeln!(text, "- **{category}**: {}", links.join(", "));
    }
    let samples: Samples =
        serde_json::from_str(chiaro_laboratory::NODE_SAMPLES).unwrap_or_default();
    for (category, entries) in by_category(entries) {
        let _ = writeln!(text, "\n## Category {category}");
        entries.iter().for_each(|entry| text += &section(entry, &samples));
    }
    text += "\n";
    text += CUSTOM;
    text
}

fn by_category(entries: &[NodeEntry]) -> Vec<(&str, Vec<&NodeEntry>)> {
    let mut categories: Vec<(&str, Vec<&NodeEntry>)> = Vec::new();
    for entry in entries {
        match categories.last_mut().filter(|last| last.0 == entry.category) {
            Some(last) => last.1.push(entry),
            None => categories.push((&entry.category, vec![entry])),
        }
    }
    categories
}

fn section(entry: &NodeEntry, samples: &Samples) -> String {
    let group = if entry.is_group { " (a group)" } else { "" };
    let mut text = format!(
        "\n<a id=\"{}\"></a>\n\n### `{}`: {}{group}\n",
        entry.kind, entry.kind, entry.label
    );
    if !entry.help.is_empty() {
        text += &format!("\n{}\n", entry.help);
    }
    text += &pictures(entry, samples);
    if !entry.inputs.is_empty() {
        text +=
            "\n| input | type | default | range | what it is |\n| --- | --- | --- | --- | --- |\n";
        entry.inputs.iter().for_each(|input| text += &input_row(input));
    }
    if !entry.outputs.is_empty() {
        text += "\n| output | type | what it is |\n| --- | --- | --- |\n";
        for output in &entry.outputs {
            let what = what(&output.label, &output.help);
            let _ = writeln!(text, "| `{}` | {} | {} |", output.name, output.ty, cell(&what));
        }
    }
    if !entry.presets.is_empty() {
        text += "\nPresets:\n\n";
        for preset in &entry.presets {
            let value = |(name, value): &(_, _)| format!("\"{name}\": {}", json_text(value));
            let values: Vec<String> = preset.values.iter().map(value).collect();
            let _ = writeln!(text, "- {}: `{{{}}}`", preset.label, values.join(", "));
        }
    }
    if !entry.widths.is_empty() {
        let widths: Vec<String> = entry.widths.iter().map(ToString::to_string).collect();
        let _ = writeln!(
            text,
            "\nWhere a wire brings {}, it works number by number and gives the same type.",
            list(&widths)
        );
    }
    if entry.tiers.len() > 1 {
        let tiers: Vec<String> =
            entry.tiers.iter().map(|tier| format!("`{}`", tier::word(*tier))).collect();
        let _ = writeln!(text, "\nTiers: {}.", tiers.join(", "));
    }
    if !entry.errors.is_empty() {
        let _ = writeln!(text, "\nAt most this far from exact:\n");
    }
    for error in &entry.errors {
        let help = if error.help.is_empty() { String::new() } else { format!(": {}", error.help) };
        let _ = writeln!(text, "- `{}`: {:?}{help}.", tier::word(error.tier), error.bound);
    }
    if !entry.sources.is_empty() {
        let _ = writeln!(text, "\nSource: {}.", entry.sources.join("; "));
    }
    text
}

/// The node as the canvas draws it, and its output if there is something to see of it.
fn pictures(entry: &NodeEntry, samples: &Samples) -> String {
    if entry.kind == crate::catalog::CUSTOM_KIND {
        return String::new();
    }
    let picture = |ending: &str, told: &str| {
        format!(
            "<img src=\"nodes/{}.{ending}\" alt=\"{told} {}\">",
            entry.kind,
            entry.label.replace('"', "&quot;")
        )
    };
    let node = picture("svg", "The node");
    match samples.get(&entry.kind) {
        Some(serde_json::Value::Null) => format!("\n{node}\n"),
        _ => format!("\n{node} {}\n", picture("png", "A picture by")),
    }
}

fn list(words: &[String]) -> String {
    match words {
        [most @ .., last] if !most.is_empty() => format!("{} or {last}", most.join(", ")),
        _ => words.concat(),
    }
}

fn input_row(input: &Input) -> String {
    let mut told = what(&input.label, &input.help);
    if !input.options.is_empty() {
        let option = |(word, label): &(String, String)| format!("`\"{word}\"` {label}");
        let options: Vec<String> = input.options.iter().map(option).collect();
        told += &format!(" One of {}.", options.join(", "));
    }
    let unit = if input.unit.is_empty() { String::new() } else { format!(", {}", input.unit) };
    let default = default_text(input);
    let is_value =
        matches!(input.fallback, crate::library::Fallback::Value(_)) && default != "none";
    let default = match default.split_once(" (") {
        Some((value, degrees)) if is_value => format!("`{value}` ({degrees}"),
        _ if is_value || default.starts_with("from=") || default.starts_with("same=") => {
            format!("`{default}`")
        }
        _ => default,
    };
    let cells = [input.ty.to_string() + &unit, default, range_text(input), told];
    format!(
        "| `{}` | {} |\n",
        input.name,
        cells.map(|text| cell(&text)).join(" | ").replace(" |  | ", " | | ")
    )
}

fn what(label: &str, help: &str) -> String {
    if help.is_empty() { format!("{label}.") } else { format!("{label}: {help}") }
}

/// The text escaped for a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

/// Table of all pairs of different types that a wire converts between.
fn conversions() -> String {
    use Type::{Angle, Bool, Color, Composite, Float, Int, Vec2, Vec3, Vec4};
    let types = [Float, Int, Bool, Vec2, Vec3, Vec4, Color, Composite, Angle];
    let mut text = String::from("| from | to | gives |\n| --- | --- | --- |\n");
    for from in &types {
        for to in &types {
            if let Some(conversion @ Conversion::Template(_)) = from.convert_to(to) {
                let how = conversion.apply("x");
                let how =
                    if how == "x" { "the same numbers".to_owned() } else { format!("`{how}`") };
                let _ = writeln!(text, "| {from} | {to} | {how} |");
            }
        }
    }
    text
}

/// Table of the contexts that unwired inputs may have.
fn surroundings() -> String {
    let mut text =
        String::from("| word | type | known | what it is |\n| --- | --- | --- | --- |\n");
    for context in Context::all().filter(|context| context.light_input().is_none()) {
        let word = context.word();
        let ty = Type::from_wgsl(context.wgsl_type());
        let _ =
            writeln!(text, "| `{word}` | {ty} | {} | {} |", known(context.rate()), context.help());
    }
    text
}

fn known(rate: Rate) -> &'static str {
    match rate {
        Rate::Constant => "when the look is compiled",
        Rate::Frame => "once a frame",
        Rate::Object => "once an object",
        Rate::Vertex => "at each vertex",
        Rate::Fragment => "at each fragment",
    }
}
