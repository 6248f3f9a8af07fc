//! Texts in which HCBTFs are kept: the manifest of an `.hcbtf` file, and the listing beside the
//! images of a folder.

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::{Address, Direction, Directions, Grid, Hcbtf, Rule};
use crate::diag::Diagnostic;
use crate::document::described::{FieldType as _, described, part};
use crate::document::json::JsonWriter;
use crate::document::read::read_list;
use crate::document::shape::{FORMAT, FieldKind, LINE, MAX_PATH};
use crate::document::{LoadedDocument, UnknownFields};

/// Greatest number of images that a listing says rules filled.
const MAX_FILLED: usize = 1 << 21;
/// Kind of the rules of an HCBTF.
const RULES: FieldKind = FieldKind::List(&FieldKind::Choice(Rule::choice), Hcbtf::MAX_RULES);

described! {
    /// Grid, rules and painted samples of an `.hcbtf` file: its `manifest.json`.
    pub struct HcbtfManifest("hcbtf", Lines) {
        /// Type of the document.
        "chiaro": FieldKind::Word(&[("hcbtf", "a hand-painted 6D texture")]), required;
        /// The version of the format.
        "version": FieldKind::Number(FORMAT), json "1";
        /// A JSON Schema for text editors; kept, and not looked at.
        "$schema": FieldKind::Text(LINE), words "none";
        /// Sizes of the six dimensions.
        grid: Grid, FieldKind::Object(Grid::shape), required;
        /// True if the tile repeats without a seam; painting then goes across its edges.
        is_tiling as "tiling": bool = true, FieldKind::Bool, always;
        /// Rules that fill the samples that are not painted, in the order in which they work.
        rules: Vec<Rule> = Vec::new(), RULES, always;
        /// Samples that are painted.
        painted: Vec<PaintedSample> = Vec::new(),
            FieldKind::List(&FieldKind::Object(PaintedSample::shape), Hcbtf::MAX_PAINTED), always;
        unknown;
    }
}

described! {
    /// Painted sample of an `.hcbtf` file.
    pub struct PaintedSample("painted sample", Line, by file) {
        /// Direction toward the light: ring and step, from 0.
        light: Direction, super::DIRECTION, required;
        /// Direction toward the eye: ring and step, from 0.
        view: Direction, super::DIRECTION, required;
        /// Name of the sample's PNG in the zip.
        file: String, FieldKind::Text(MAX_PATH), required;
    }
}

described! {
    /// Grid, rules and filled samples of a folder of images: its `hcbtf.json`.
    pub struct HcbtfListing("hcbtf", Lines) {
        /// Type of the document.
        "chiaro": FieldKind::Word(&[("hcbtf", "a hand-painted 6D texture")]), required;
        /// The version of the format.
        "version": FieldKind::Number(FORMAT), json "1";
        /// A JSON Schema for text editors; kept, and not looked at.
        "$schema": FieldKind::Text(LINE), words "none";
        /// Sizes of the six dimensions.
        grid: Grid, FieldKind::Object(Grid::shape), required;
        /// True if the tile repeats without a seam; painting then goes across its edges.
        is_tiling as "tiling": bool = true, FieldKind::Bool, always;
        /// Rules that fill the samples that are not painted, in the order in which they work.
        rules: Vec<Rule> = Vec::new(), RULES, always;
        /// Digests of the images that rules filled, by name.
        filled: IndexMap<String, u64> = IndexMap::new(),
            FieldKind::Map(&FieldKind::Text(16), MAX_FILLED), always, by Digests;
        unknown;
    }
}

impl HcbtfManifest {
    /// Problems of the rules and the painted samples with the grid, by their places.
    pub(in crate::document) fn check(&self) -> Vec<Diagnostic> {
        let mut found = check_rules(&self.rules, &self.grid);
        for (index, PaintedSample { light, view, .. }) in self.painted.iter().enumerate() {
            // The address is checked as it was written: a step beyond the last is a mistake at the
            // normal too.
            for (name, direction, of) in
                [("light", light, self.grid.light), ("view", view, self.grid.view)]
            {
                if !of.contains(*direction) {
                    let Directions { theta, phi } = of;
                    let message = tr!(
                        "[{at_theta}, {at_phi}] is outside the grid of {theta} x {phi} directions",
                        at_theta = direction.theta,
                        at_phi = direction.phi
                    );
                    found.push(
                        Diagnostic::error("out-of-range", message)
                            .json_path(format!("painted[{index}].{name}")),
                    );
                }
            }
        }
        found
    }
}

impl HcbtfListing {
    /// Problems of the rules with the grid, by their places.
    pub(in crate::document) fn check(&self) -> Vec<Diagnostic> {
        check_rules(&self.rules, &self.grid)
    }
}

impl PaintedSample {
    /// Address of the sample.
    pub fn address(&self) -> Address {
        Address { light: self.light, view: self.view }.canonical()
    }
}

/// Problems of rules with the grid.
fn check_rules(rules: &[Rule], grid: &Grid) -> Vec<Diagnostic> {
    let check = |(index, rule): (usize, &Rule)| {
        let why = rule.check_whole(grid).err()?;
        Some(Diagnostic::error("hcbtf-rule", why).json_path(format!("rules[{index}]")))
    };
    rules.iter().enumerate().filter_map(check).collect()
}

impl Hcbtf {
    /// Text of the rules alone, a line each, with the fields that this version does not know:
    /// [`read_rules`] reads it.
    pub fn rules_text(&self) -> String {
        let mut writer = JsonWriter::new();
        self.rules.write(&mut writer, part(Some(&self.unknown), "rules"));
        writer.finish()
    }
}

/// Reads a list of rules alone, as `chiaro hcbtf rules` shows it, with the fields of the rules that
/// this version does not know, by index. `file` is the name of the text in diagnostics.
pub fn read_rules(
    text: &str,
    grid: &Grid,
    file: &str,
) -> LoadedDocument<(Vec<Rule>, UnknownFields)> {
    read_list(text, file, "rules", &RULES, |(rules, _): &(Vec<Rule>, _)| check_rules(rules, grid))
}
