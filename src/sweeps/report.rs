//! Report of a survey as a document: docs/accuracy.md, its plots and its JSON.

use std::fmt::Write as _;
use std::path::Path;

use serde::Serialize;

use super::bounds::{EXCEPTIONS, ErrorMetric, STEEP_FOOT};
use super::looks::LookFigures;
use super::measure::CaseFigures;
use super::search::WorstInput;
use super::stability::StabilityFigures;
use super::{pictures, plot, stability};
use crate::diag::Diagnostic;
use crate::document::Tier;
use crate::files::{OutputKind, Outputs, make_folder};

/// Result of a survey.
#[derive(Clone, Debug, Default, Serialize)]
pub struct AccuracyReport {
    /// The GPU's name.
    pub adapter: String,
    /// True if the adapter is a software renderer on the CPU.
    pub is_software: bool,
    /// Errors of each case of each node.
    pub nodes: Vec<CaseFigures>,
    /// Errors of each look, in each tier.
    pub looks: Vec<LookFigures>,
    /// Errors of each look in the largest pictures, if they were asked for.
    pub large: Vec<LookFigures>,
    /// Flicker of each look on each mesh, while light and camera turn.
    pub stability: Vec<StabilityFigures>,
    /// The worst inputs of nodes, to be kept in `tests/worst`.
    #[serde(skip)]
    pub worst: Vec<WorstInput>,
}

impl AccuracyReport {
    /// Descriptions of all errors beyond their bounds.
    pub fn broken(&self) -> Vec<String> {
        let nodes = self.nodes.iter().filter(|one| !one.holds());
        let nodes =
            nodes.map(|one| format!("{} ({}): {}", one.case.name(), tier(one), one.worst_words));
        let looks = self.looks.iter().chain(&self.large).filter(|one| !one.holds());
        let looks = looks.map(|one| {
            let (e, tier) = (&one.error, word_of(one.tier));
            let edges = format!("{} of {} edge pixels over 1/255", e.edge_visible, e.edges);
            format!(
                "{} ({tier}): {:.1e}, RMS {:.1e}, {edges}, in {}",
                one.look, e.max, e.rms, one.worst_words
            )
        });
        let turning = self.stability.iter().filter(|one| !one.holds());
        let turning = turning.map(|one| {
            let most = one.smooth.max.max(one.edges.max);
            let share = format!(
                "{} of {} pixels of silhouettes",
                one.silhouettes.visible, one.silhouettes.count
            );
            format!(
                "{} on the {} flickers by {most:.1e}, and {share} by more than 1/255",
                one.look, one.mesh
            )
        });
        nodes.chain(looks).chain(turning).collect()
    }

    /// The document as Markdown; its plots lie in the folder `plots` beside it.
    pub fn markdown(&self, command: &str, plots: &str) -> String {
        let mut text = String::new();
        self.head(&mut text, command);
        self.broken_part(&mut text);
        if !self.nodes.is_empty() {
            self.nodes_part(&mut text, plots);
            exceptions_part(&mut text);
        }
        if !self.looks.is_empty() {
            pictures::looks_part(self, &mut text, plots);
        }
        if !self.stability.is_empty() {
            pictures::stability_part(self, &mut text, plots);
        }
        text
    }

    fn head(&self, text: &mut String, command: &str) {
        let software = if self.is_software {
            " This is **software Vulkan**: a GPU rounds division, square roots and derivatives in \
             its own way, within\n\
             what WGSL allows, and no figure here was taken on one."
        } else {
            ""
        };
        let _ = writeln!(
            text,
            "# Accuracy\n\n<!-- Written by `{command}`. -->\n\n\
             How far the GPU is from the truth, and where it is farthest. The truth is the exact \
             tier in f64, with nothing\n\
             folded, fed with the same f32-rounded inputs. It shares the exact tier's polynomials \
             (good to 1e-7); closed\n\
             forms that share nothing with the shaders hold those, in `tests/truth_*.rs`.\n\n\
             Made by `{command}` on {}.{software} The same adapter gives the same file.\n",
            self.adapter
        );
    }

    fn broken_part(&self, text: &mut String) {
        let broken = self.broken();
        if broken.is_empty() {
            return;
        }
        let _ = writeln!(
            text,
            "## Beyond their bounds\n\nThese {} do not keep what they are held to:\n",
            broken.len()
        );
        for words in broken {
            let _ = writeln!(text, "- {words}");
        }
        text.push('\n');
    }

    fn nodes_part(&self, text: &mut String, plots: &str) {
        let samples: usize = self.nodes.iter().map(|one| one.samples).sum();
        let broken: usize = self.nodes.iter().map(|one| one.broken).sum();
        let _ = writeln!(
            text,
            "## Nodes\n\n\
             Every node in every choice, width and tier, alone in a look with all of its inputs \
             fed: evenly over what is\n\
             documented, and at the edges of arithmetic (zeros, denormals, the largest numbers, pi \
             in f32 and its neighbors,\n\
             vectors that are equal, opposite and nearly so, or not unit). From the worst samples \
             a search climbs to worse\n\
             ones; what it found is kept in `tests/worst` and held by a test. {samples} samples; \
             NaN or infinite: {broken}.\n\n\
             Errors are relative to the output's range: 1, or the largest number of the true \
             result where that is more. p99.9 is\n\
             over samples within what is documented. *by rounding* counts samples that are within \
             the bound only because no f32\n\
             can tell their inputs from others (see below). A line stands for the worst of a \
             node's choices and widths.\n\n\
             ![The largest error of each node and its bound]({plots}/nodes.svg)\n\n\
             | node | tier | samples | by rounding | p99.9 | largest | bound | worst case |\n\
             | --- | --- | ---: | ---: | ---: | ---: | ---: | --- |"
        );
        for group in self.groups() {
            let worst = group
                .iter()
                .max_by(|a, b| (a.max / a.bound).total_cmp(&(b.max / b.bound)))
                .copied();
            let Some(worst) = worst else { continue };
            let sum =
                |get: fn(&CaseFigures) -> usize| group.iter().map(|one| get(one)).sum::<usize>();
            let p999 = group.iter().map(|one| one.p999).fold(0.0, f64::max);
            let case = if worst.max == 0.0 { "exact".to_owned() } else { self.words_of(worst) };
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} | {} | {case} |",
                worst.case.node,
                tier(worst),
                sum(|one| one.samples),
                sum(|one| one.rounded),
                small(p999),
                small(worst.max),
                small(worst.bound),
            );
        }
        text.push('\n');
    }

    fn words_of(&self, one: &CaseFigures) -> String {
        let setting = one.case.name();
        let setting =
            setting.trim_start_matches(one.case.node.as_str()).trim_start_matches([' ', ',']);
        let setting = if setting.is_empty() { String::new() } else { format!("*{setting}:* ") };
        format!("{setting}{}", one.worst_words.replace('|', "\\|"))
    }

    /// The cases grouped by node and tier.
    fn groups(&self) -> Vec<Vec<&CaseFigures>> {
        let mut groups: Vec<Vec<&CaseFigures>> = Vec::new();
        for one in &self.nodes {
            let same = |group: &&mut Vec<&CaseFigures>| {
                group[0].case.node == one.case.node && group[0].case.tier == one.case.tier
            };
            match groups.iter_mut().find(same) {
                Some(group) => group.push(one),
                None => groups.push(vec![one]),
            }
        }
        groups
    }

    /// Checks that the document may be written to `path`, and the plots beside it, before the hours
    /// of measuring.
    ///
    /// # Errors
    /// As [`Outputs::check`].
    pub fn check(path: &Path, outputs: &Outputs) -> Result<(), Diagnostic> {
        outputs.check(path, REPORT)?;
        let folder = path.with_file_name(stem_of(path));
        PLOTS.iter().try_for_each(|name| outputs.check(&folder.join(name), OutputKind::DRAWING))
    }

    /// Writes the document to `path`, and the plots into the folder of the same stem beside it; all
    /// together, the document last.
    ///
    /// # Errors
    /// Errors of the file system, and files of others in the way.
    pub fn write(
        &self,
        path: &Path,
        command: &str,
        outputs: &mut Outputs,
    ) -> Result<(), Vec<Diagnostic>> {
        let stem = stem_of(path);
        let folder = path.with_file_name(&stem);
        make_folder(&folder).map_err(|problem| vec![*problem])?;
        let one = |problem| vec![problem];
        for (name, svg) in self.plots() {
            outputs.add(&folder.join(name), OutputKind::DRAWING, svg.as_bytes()).map_err(one)?;
        }
        outputs.add(path, REPORT, self.markdown(command, &stem).as_bytes()).map_err(one)?;
        outputs.commit().map_err(one)
    }

    fn plots(&self) -> Vec<(&'static str, String)> {
        let node = |group: &Vec<&CaseFigures>| {
            let worst = group.iter().map(|one| one.max).fold(0.0, f64::max);
            let bound = group.iter().map(|one| one.bound).fold(0.0, f64::max);
            let one = group[0];
            let color = ["#35618f", "#4f8f5b", "#c0583f"][one.case.tier as usize];
            let label = if tier(one) == "exact" {
                one.case.node.clone()
            } else {
                format!("{}, {}", one.case.node, tier(one))
            };
            plot::PlotRow { label, points: vec![(worst, color)], bound: Some(bound) }
        };
        let nodes: Vec<plot::PlotRow> = self.groups().iter().map(node).collect();
        let look = |one: &LookFigures| plot::PlotRow {
            label: one.look.clone(),
            points: vec![
                (one.error.edge_max, "#b9b4a9"),
                (one.error.rms, "#4f8f5b"),
                (one.error.max, "#35618f"),
            ],
            bound: one.bound.max,
        };
        let exact = self.looks.iter().filter(|one| one.tier == Tier::Exact);
        let looks: Vec<plot::PlotRow> = exact.map(look).collect();
        let turning = |one: &StabilityFigures| {
            let kinds =
                [(one.silhouettes, "#b9b4a9"), (one.edges, "#c0583f"), (one.smooth, "#35618f")];
            let points = kinds
                .iter()
                .filter(|(flicker, _)| flicker.count > 0)
                .map(|(flicker, color)| (flicker.max, *color));
            let label = format!("{}, {}", one.look, one.mesh);
            plot::PlotRow { label, points: points.collect(), bound: Some(stability::ON_EDGES) }
        };
        let stability: Vec<plot::PlotRow> = self.stability.iter().map(turning).collect();
        let tiers = [("exact", "#35618f"), ("balanced", "#4f8f5b"), ("fast", "#c0583f")];
        let parts = [("largest", "#35618f"), ("RMS", "#4f8f5b"), ("at edges", "#b9b4a9")];
        let kinds = [
            ("smooth", "#35618f"),
            ("terminators and cartoon edges", "#c0583f"),
            ("silhouettes", "#b9b4a9"),
        ];
        let all = [
            (
                PLOTS[0],
                plot::svg(
                    "Largest error of each node",
                    "relative to the output's range",
                    &nodes,
                    &tiers,
                ),
            ),
            (PLOTS[1], plot::svg("Error of each look", "of a channel", &looks, &parts)),
            (
                PLOTS[2],
                plot::svg(
                    "Flicker of each look",
                    "change of a channel beside the truth's",
                    &stability,
                    &kinds,
                ),
            ),
        ];
        let is_empty = |name: &str| name != PLOTS[0] && self.looks.is_empty();
        all.into_iter().filter(|(name, _)| !is_empty(name)).collect()
    }
}

/// Names of the plots: nodes, looks and their stability.
const PLOTS: [&str; 3] = ["nodes.svg", "looks.svg", "stability.svg"];

/// The document, as a kind of output file.
const REPORT: OutputKind<'static> = OutputKind {
    name: "a report of accuracy",
    is_own: &|text| text.starts_with(b"# Accuracy\n\n<!-- Written by `chiaro accuracy"),
    has_seal: false,
};

/// Name of the folder of a document's plots.
fn stem_of(path: &Path) -> String {
    path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default()
}

fn exceptions_part(text: &mut String) {
    let _ = writeln!(
        text,
        "### How nodes are held to their bounds\n\n\
         Exact tiers err by rounding alone: 2e-6 of the output's range, but for those below. A \
         cheaper tier is held to that\n\
         and to what its file states, where the file states it. A denormal may count as 0, as WGSL \
         allows.\n\n\
         - *plain*: by the distance from the truth.\n\
         - *steep*: where that is too far, by the distance from what the truth spans while each \
         input moves by up to four units in\n  \
           its last place, one at a time and many together: a result that is right for inputs \
           which no f32 can tell from the given\n  \
           ones is no error.\n\
         - *steps*: the same, but by the distance from the nearest of those results, so that \
         nothing between two steps passes.\n\n\
         *From* and *to* limit the inputs' size; beyond, results are finite, and no more is said. \
         A profile that falls off a quarter\n\
         turn or more from its offset ends infinitely steep, and is held to {STEEP_FOOT:e} \
         (cheaper tiers to ten times that); an\n\
         offset near pi to 1e-6 over its distance from pi, and within 0.01 of pi to be finite. A \
         palette's softness divides\n\
         distances in Oklab, and it is held to 1e-6 over that; the table has errors there divided \
         by what is granted more. Marks\n\
         are held where their place is drawn out at most thirty times.\n\n\
         | node | choice | bound | judged | from | to | why |\n\
         | --- | --- | ---: | --- | ---: | ---: | --- |"
    );
    for e in EXCEPTIONS {
        let judged = match e.judging {
            ErrorMetric::Plain => "plain",
            ErrorMetric::Steep => "steep",
            ErrorMetric::Steps => "steps",
        };
        let range = if e.of_inputs { ", inputs count into the range" } else { "" };
        let together = if e.together { ", moved by units of the largest input" } else { "" };
        let limit = |x: f64, none: bool| if none { String::new() } else { format!("{x:e}") };
        let (from, to) =
            (limit(e.finest, e.finest == 0.0), limit(e.reach, e.reach >= f64::from(f32::MAX)));
        let (bound, word) = (small(e.bound), e.word);
        let _ = writeln!(
            text,
            "| {} | {word} | {bound} | {judged}{range}{together} | {from} | {to} | {} |",
            e.node, e.reason
        );
    }
    text.push('\n');
}

fn tier(one: &CaseFigures) -> &'static str {
    word_of(one.case.tier)
}

/// Word for a tier in a look's file.
pub(super) fn word_of(tier: Tier) -> &'static str {
    ["exact", "balanced", "fast"][tier as usize]
}

/// The number with two digits, whatever its magnitude.
pub(super) fn small(number: f64) -> String {
    if number == 0.0 { "0".to_owned() } else { format!("{number:.1e}") }
}
