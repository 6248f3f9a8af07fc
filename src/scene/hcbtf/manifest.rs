//! `manifest.json`: the contents of an `.hcbtf` file, and their places in the archive.

use std::fmt::Write as _;

use serde_json::{Map, Value};

use super::report::FileReport;
use super::{MAX_PAINTED, MAX_RULES, VERSION, folder};
use crate::diag::{Diagnostic, LineColumn};
use crate::document::{Address, Directions, Grid, Hcbtf, Rule};

/// Name of the manifest in the archive.
pub(super) const NAME: &str = "manifest.json";
/// Folder of the samples in the archive.
pub(super) const SAMPLES: &str = "samples/";
/// Name of the thumbnail in the archive.
pub(super) const THUMBNAIL: &str = "thumbnail.png";
/// Greatest length of a manifest that is read, in bytes: [`MAX_PAINTED`] samples need about half of
/// it.
pub(super) const MAX_MANIFEST_BYTES: u64 = 8 << 20;

/// Content of a manifest.
pub(super) struct Manifest {
    pub(super) grid: Grid,
    pub(super) is_tiling: bool,
    pub(super) rules: Vec<Rule>,
    pub(super) painted: Vec<SampleEntry>,
}

/// A painted sample in the manifest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct SampleEntry {
    pub(super) address: Address,
    /// Entry of the archive that holds the sample.
    pub(super) file: String,
}

/// The name of a sample's entry.
pub(super) fn sample_name(address: Address) -> String {
    format!("{SAMPLES}{}", folder::file_name(address))
}

/// The manifest's text: a field a line, a rule a line, a sample a line, so that tools that compare
/// lines work well.
pub(super) fn text(hcbtf: &Hcbtf) -> Result<String, serde_json::Error> {
    let mut text = head(&hcbtf.grid, hcbtf.is_tiling, &hcbtf.rules)?;
    let painted = hcbtf.painted.keys().map(|address| {
        let Address { light, view } = address;
        format!(
            "{{ \"light\": [{}, {}], \"view\": [{}, {}], \"file\": \"{}\" }}",
            light.theta,
            light.phi,
            view.theta,
            view.phi,
            sample_name(*address)
        )
    });
    let painted: Vec<String> = painted.collect();
    let _ = writeln!(text, "  \"painted\": {}\n}}", list(&painted));
    Ok(text)
}

/// The beginning of the manifest's text, up to the rules.
pub(super) fn head(
    grid: &Grid,
    is_tiling: bool,
    rules: &[Rule],
) -> Result<String, serde_json::Error> {
    let Grid { size: [width, height], light, view } = grid;
    let directions =
        |of: &Directions| format!("{{ \"theta\": {}, \"phi\": {} }}", of.theta, of.phi);
    let (light, view) = (directions(light), directions(view));
    let rules: Vec<String> = rules.iter().map(serde_json::to_string).collect::<Result<_, _>>()?;
    Ok(format!(
        "{{\n  \"chiaro\": \"hcbtf\",\n  \"version\": {VERSION},\n  \
         \"grid\": {{ \"size\": [{width}, {height}], \"light\": {light}, \"view\": {view} }},\n  \
         \"tiling\": {is_tiling},\n  \"rules\": {},\n",
        list(&rules)
    ))
}

fn list(items: &[String]) -> String {
    if items.is_empty() {
        "[]".to_owned()
    } else {
        format!("[\n    {}\n  ]", items.join(",\n    "))
    }
}

/// Reads a manifest; all errors go to the report.
pub(super) fn parse(text: &[u8], report: &mut FileReport) -> Option<Manifest> {
    report.reads(NAME);
    let fields =
        fields(text, &["chiaro", "version", "grid", "tiling", "rules", "painted"], report)?;
    let (grid, is_tiling, rules) = parse_head(&fields, report)?;
    let painted = items(&fields, "painted", MAX_PAINTED, report)?;
    let painted = painted
        .iter()
        .enumerate()
        .filter_map(|(index, value)| listed(value, index, &grid, report))
        .collect();
    Some(Manifest { grid, is_tiling, rules, painted })
}

/// The fields of a JSON text that identifies itself as one of an HCBTF; fields that are not `known`
/// are reported.
pub(super) fn fields(
    text: &[u8],
    known: &[&str],
    report: &mut FileReport,
) -> Option<Map<String, Value>> {
    let parsed =
        serde_json::from_slice::<Value>(text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text));
    let fields = match parsed {
        Ok(Value::Object(fields)) => fields,
        Ok(_) => return wrong(report, "wrong-type", "", "it is no JSON object"),
        Err(error) => {
            let at = LineColumn { line: error.line() as u32, column: error.column() as u32 };
            let part = report.part();
            let message =
                format!("`{part}` is not JSON, at line {}, column {}: {error}", at.line, at.column);
            report.add(
                Diagnostic::error("not-json", message)
                    .hint("mend it in a text editor, or take a backup"),
            );
            return None;
        }
    };
    check_version(&fields, report)?;
    unknown_fields(&fields, "", known, report);
    Some(fields)
}

/// The grid, the tiling, and the rules.
pub(super) fn parse_head(
    fields: &Map<String, Value>,
    report: &mut FileReport,
) -> Option<(Grid, bool, Vec<Rule>)> {
    let grid = grid(fields.get("grid"), report)?;
    let is_tiling = match fields.get("tiling") {
        None => true,
        Some(Value::Bool(is_tiling)) => *is_tiling,
        Some(_) => wrong(report, "wrong-type", "tiling", "it is neither true nor false")?,
    };
    let rules = items(fields, "rules", MAX_RULES, report)?;
    let rules = rules
        .iter()
        .enumerate()
        .filter_map(|(index, value)| rule(value, index, &grid, report))
        .collect();
    Some((grid, is_tiling, rules))
}

/// Reports an error at a place of the manifest.
fn wrong<T>(report: &mut FileReport, code: &'static str, path: &str, message: &str) -> Option<T> {
    let problem = Diagnostic::error(code, format!("`{}`: {message}", report.part()));
    report.add(if path.is_empty() { problem } else { problem.json_path(path) });
    None
}

fn check_version(fields: &Map<String, Value>, report: &mut FileReport) -> Option<()> {
    if fields.get("chiaro").and_then(Value::as_str) != Some("hcbtf") {
        let message = format!("`{}` does not say `\"chiaro\": \"hcbtf\"`", report.part());
        report.add(
            Diagnostic::error("wrong-document", message).hint("is this another kind of file?"),
        );
        return None;
    }
    match fields.get("version").map(Value::as_u64) {
        Some(Some(version)) if version > u64::from(VERSION) => {
            let message = format!(
                "the file is of version {version}, made by a later Chiaro; this one reads up to \
                 {VERSION}"
            );
            report.add(
                Diagnostic::error("newer-version", message).hint("open it with a newer Chiaro"),
            );
            None
        }
        None | Some(Some(1..)) => Some(()),
        Some(_) => wrong(report, "wrong-type", "version", "it is no whole number from 1"),
    }
}

fn unknown_fields(
    fields: &Map<String, Value>,
    path: &str,
    known: &[&str],
    report: &mut FileReport,
) {
    for name in fields.keys().filter(|name| !known.contains(&name.as_str())) {
        let part = report.part();
        let message = format!(
            "`{part}` has a field `{name}` that this version does not know; saving loses it"
        );
        let at = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
        report.add(
            Diagnostic::warning("unknown-field", message)
                .json_path(at)
                .suggest(name, known.iter().copied()),
        );
    }
}

/// The items of a list of at most `most` items; none if the field is missing.
fn items<'a>(
    fields: &'a Map<String, Value>,
    name: &str,
    most: usize,
    report: &mut FileReport,
) -> Option<&'a [Value]> {
    match fields.get(name) {
        None => Some(&[]),
        Some(Value::Array(items)) if items.len() <= most => Some(items),
        Some(Value::Array(items)) => wrong(
            report,
            "too-many",
            name,
            &format!("there are {} items; at most {most} can be", items.len()),
        ),
        Some(_) => wrong(report, "wrong-type", name, "it is no list"),
    }
}

fn grid(value: Option<&Value>, report: &mut FileReport) -> Option<Grid> {
    let Some(value) = value else {
        return wrong(report, "missing-field", "grid", "there is no grid");
    };
    if let Value::Object(fields) = value {
        unknown_fields(fields, "grid", &["size", "light", "view"], report);
        for side in ["light", "view"] {
            if let Some(Value::Object(directions)) = fields.get(side) {
                unknown_fields(directions, &format!("grid.{side}"), &["theta", "phi"], report);
            }
        }
    }
    let read = serde_json::from_value::<Grid>(value.clone()).map_err(|error| error.to_string());
    let checked = read.and_then(|grid| grid.check().map(|()| grid));
    checked.map_or_else(|why| wrong(report, "hcbtf-grid", "grid", &why), Some)
}

/// Reads a list of rules, as `chiaro hcbtf rules` shows them; `name` is the name of the list in
/// diagnostics.
///
/// # Errors
/// All errors of the list, up to a bound.
pub fn read_rules(text: &str, grid: &Grid, name: &str) -> Result<Vec<Rule>, Vec<Diagnostic>> {
    let mut report = FileReport::new(name);
    report.reads("rules");
    let rules = match serde_json::from_str::<Value>(text) {
        Ok(Value::Array(values)) if values.len() <= MAX_RULES => {
            let rules = values
                .iter()
                .enumerate()
                .filter_map(|(index, value)| rule(value, index, grid, &mut report));
            Some(rules.collect::<Vec<Rule>>())
        }
        Ok(Value::Array(values)) => wrong(
            &mut report,
            "too-many",
            "",
            &format!("there are {}; at most {MAX_RULES} can be", values.len()),
        ),
        Ok(_) => {
            let problem = Diagnostic::error("wrong-type", "these are no rules: it is no list");
            report.add(
                problem.hint("write a list of rules, as `chiaro hcbtf rules FILE` shows them"),
            );
            None
        }
        Err(error) => {
            let at = LineColumn { line: error.line() as u32, column: error.column() as u32 };
            report
                .add(Diagnostic::error("not-json", format!("these are no rules: {error}")).at(at));
            None
        }
    };
    report.finish(rules).map(|rules| rules.value)
}

fn rule(value: &Value, index: usize, grid: &Grid, report: &mut FileReport) -> Option<Rule> {
    let path = format!("rules[{index}]");
    let word = value.get("rule").and_then(Value::as_str);
    let Some(word) = word.filter(|word| Rule::WORDS.contains(word)) else {
        let what = word
            .map_or("a rule has no word".to_owned(), |word| format!("there is no rule `{word}`"));
        let problem = Diagnostic::error("unknown-word", format!("`{}`: {what}", report.part()))
            .json_path(path);
        let hint = format!(
            "`rule` is one of {}; `chiaro hcbtf rules --help` tells of each",
            Rule::WORDS.join(", ")
        );
        report.add(problem.suggest(word.unwrap_or_default(), Rule::WORDS).hint(hint));
        return None;
    };
    let checked = match serde_json::from_value::<Rule>(value.clone()) {
        Ok(rule) => rule.check(grid).map(|()| rule),
        Err(error) => Err(format!("the rule `{word}`: {error}")),
    };
    match checked {
        Ok(rule) => Some(rule),
        Err(why) => {
            let problem = Diagnostic::error("hcbtf-rule", format!("`{}`: {why}", report.part()))
                .json_path(path);
            let about = Rule::ABOUT.into_iter().find(|about| about.word == word);
            let known: Vec<&str> =
                about.iter().flat_map(|about| about.fields).map(|(name, _)| *name).collect();
            let unknown = value.as_object().into_iter().flat_map(Map::keys);
            let unknown = unknown.filter(|name| *name != "rule" && !known.contains(&name.as_str()));
            report.add(
                unknown.fold(problem, |problem, name| problem.suggest(name, known.iter().copied())),
            );
            None
        }
    }
}

fn listed(
    value: &Value,
    index: usize,
    grid: &Grid,
    report: &mut FileReport,
) -> Option<SampleEntry> {
    let path = format!("painted[{index}]");
    let Value::Object(fields) = value else {
        return wrong(report, "wrong-type", &path, "it is no JSON object");
    };
    unknown_fields(fields, &path, &["light", "view", "file"], report);
    let mut pair = |name: &str| {
        let pair = fields
            .get(name)
            .and_then(|value| serde_json::from_value::<[u32; 2]>(value.clone()).ok());
        let place = format!("{path}.{name}");
        pair.or_else(|| {
            wrong(
                report,
                "wrong-type",
                &place,
                &format!("`{name}` is not [theta, phi], two whole numbers"),
            )
        })
    };
    let (light, view) = (pair("light")?, pair("view")?);
    // The address is checked as it was written: a step beyond the last is a mistake at the normal
    // too.
    let outside = [(light, grid.light, "light"), (view, grid.view, "view")]
        .into_iter()
        .find(|(pair, directions, _)| pair[0] >= directions.theta || pair[1] >= directions.phi);
    if let Some((pair, directions, name)) = outside {
        let Directions { theta, phi } = directions;
        let message =
            format!("`{name}` is {pair:?}, outside the grid of {theta} x {phi} directions");
        return wrong(report, "out-of-range", &path, &message);
    }
    let Some(file) = fields.get("file").and_then(Value::as_str) else {
        return wrong(report, "missing-field", &path, "`file` does not name the sample's PNG");
    };
    if leads_outside(file) {
        let message = format!("`{NAME}`: the path `{file}` leads outside the file");
        let hint = "samples lie inside the zip: name them like `samples/l2.3_v1.4.png`";
        report.add(Diagnostic::error("hcbtf-path", message).json_path(path).hint(hint));
        return None;
    }
    Some(SampleEntry { address: Address::new(light, view), file: file.to_owned() })
}

/// True if a path is anything but names below the archive's root.
fn leads_outside(path: &str) -> bool {
    path.contains(['\\', ':', '\0']) || path.split('/').any(|part| matches!(part, "" | "." | ".."))
}
