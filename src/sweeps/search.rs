//! Search for worse inputs: small and large steps from the worst samples that a sweep has found,
//! keeping the samples with larger errors. They are written to files, so that a test can check
//! them.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::bounds::is_stated;
use super::case::{Case, NodeBench};
use super::measure::{CaseFigures, Finding, Laboratory, told};
use super::random::Random;
use super::slot::{Numbers, relate};
use crate::accuracy::MeasureError;
use crate::diag::Diagnostic;
use crate::document::read_text;
use crate::files::{Files, OutputKind, Outputs, make_folder};
use crate::library::Library;

/// Number of samples that are kept from round to round.
const PARENTS: usize = 6;
/// Number of steps that are tried from each sample.
const CHILDREN: usize = 40;

/// Climbs from the worst samples of `measured` to worse ones; the work is the same in every run.
///
/// # Errors
/// Errors of the compiler, the GPU or the interpreter.
pub async fn climb(
    lab: &mut Laboratory<'_>,
    bench: &NodeBench,
    measured: &mut CaseFigures,
    rounds: usize,
) -> Result<(), MeasureError> {
    if bench.slots.is_empty() || measured.broken > 0 {
        return Ok(());
    }
    let mut random = Random::of(&format!("climb {}", bench.case.name()));
    for _ in 0..rounds {
        let mut children: Vec<Numbers> = Vec::new();
        for parent in &measured.worst {
            children.extend((0..CHILDREN).map(|_| child(bench, &parent.numbers, &mut random)));
        }
        for finding in lab.compare(bench, &children).await? {
            let is_broken = finding.got.iter().any(|x| !x.is_finite());
            measured.broken += usize::from(is_broken);
            measured.samples += 1;
            if is_broken || is_stated(&bench.case, &bench.slots, &finding.numbers) {
                measured.worst.push(finding);
            }
        }
        measured.worst.sort_by(|a, b| b.error.total_cmp(&a.error));
        measured.worst.dedup_by(|a, b| a.numbers == b.numbers);
        measured.worst.truncate(PARENTS);
    }
    if let Some(worst) = measured.worst.first() {
        measured.max = measured.max.max(worst.error);
        measured.worst_words = super::measure::words(bench, worst);
    }
    Ok(())
}

fn child(bench: &NodeBench, parent: &Numbers, random: &mut Random) -> Numbers {
    let mut numbers = parent.clone();
    let share = random.pick(&[0.15, 0.5, 1.0]);
    let sure = random.index(bench.slots.len());
    for (index, slot) in bench.slots.iter().enumerate() {
        if index == sure || random.chance(share) {
            let is_far = random.chance(0.05);
            numbers[index] =
                if is_far { slot.extreme(random) } else { slot.step(&numbers[index], random) };
        }
    }
    if random.chance(0.05) {
        relate(&bench.slots, &mut numbers, random);
    }
    numbers
}

/// One of the worst inputs, as `tests/worst` stores it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorstInput {
    /// Case of the node.
    #[serde(flatten)]
    pub case: Case,
    /// Numbers that the node was fed with, by slot; NaN and infinities as words.
    pub inputs: indexmap::IndexMap<String, Vec<NumberOrWord>>,
    /// Error when the input was found, relative to the output's range.
    pub error: f64,
}

/// A number, or a word for one that JSON has no number for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum NumberOrWord {
    /// A finite number.
    Number(f64),
    /// `inf`, `-inf` or `nan`.
    Word(String),
}

impl From<f64> for NumberOrWord {
    fn from(x: f64) -> Self {
        if x.is_finite() { Self::Number(x) } else { Self::Word(told(&[x]).to_lowercase()) }
    }
}

impl NumberOrWord {
    fn number(&self) -> f64 {
        match self {
            Self::Number(x) => *x,
            Self::Word(word) => word.parse().unwrap_or(f64::NAN),
        }
    }
}

impl WorstInput {
    /// The input of a bench's finding.
    pub fn new(bench: &NodeBench, finding: &Finding) -> Self {
        let input = |(slot, numbers): (&super::slot::InputSlot, &Vec<f64>)| {
            (slot.name.clone(), numbers.iter().copied().map(NumberOrWord::from).collect())
        };
        let error = format!("{:.2e}", finding.error).parse().unwrap_or(finding.error);
        Self {
            case: bench.case.clone(),
            inputs: bench.slots.iter().zip(&finding.numbers).map(input).collect(),
            error,
        }
    }

    /// The numbers for a bench's slots.
    ///
    /// # Errors
    /// An input that is missing or has another width.
    pub fn numbers(&self, bench: &NodeBench) -> Result<Numbers, Diagnostic> {
        let of = |slot: &super::slot::InputSlot| {
            let numbers = self
                .inputs
                .get(&slot.name)
                .map(|words| words.iter().map(NumberOrWord::number).collect::<Vec<_>>());
            let wrong = || {
                Diagnostic::error(
                    "worst-input",
                    format!(
                        "`{}` of {} has not {} numbers",
                        slot.name,
                        self.case.name(),
                        slot.width
                    ),
                )
            };
            numbers.filter(|numbers| numbers.len() == slot.width).ok_or_else(wrong)
        };
        bench.slots.iter().map(of).collect()
    }
}

/// Lists of worst inputs, as a kind of output file.
const WORST: OutputKind<'static> = OutputKind {
    name: "a list of worst inputs",
    is_own: &|text| serde_json::from_slice::<Vec<WorstInput>>(text).is_ok(),
    has_seal: false,
};

/// Checks that worst inputs of every node may be written into a folder, before the search for them.
///
/// # Errors
/// As [`Outputs::check`].
pub fn check(folder: &Path, library: &Library, outputs: &Outputs) -> Result<(), Diagnostic> {
    let mut kinds = library.nodes.keys();
    kinds.try_for_each(|kind| outputs.check(&folder.join(format!("{kind}.json")), WORST))
}

/// Writes worst inputs, a file a node, one input a line; all together.
///
/// # Errors
/// Errors of the file system, and files of others in the way.
pub fn write(
    folder: &Path,
    all: &[WorstInput],
    outputs: &mut Outputs,
) -> Result<(), Vec<Diagnostic>> {
    let mut by_node: std::collections::BTreeMap<&str, Vec<&WorstInput>> =
        std::collections::BTreeMap::new();
    for worst in all {
        by_node.entry(&worst.case.node).or_default().push(worst);
    }
    make_folder(folder).map_err(|problem| vec![*problem])?;
    for (node, inputs) in by_node {
        let lines: Vec<String> =
            inputs.iter().map(|worst| serde_json::json!(worst).to_string()).collect();
        let text = format!("[\n{}\n]\n", lines.join(",\n"));
        outputs
            .add(&folder.join(format!("{node}.json")), WORST, text.as_bytes())
            .map_err(|problem| vec![problem])?;
    }
    outputs.commit().map_err(|problem| vec![problem])
}

/// Reads a file of worst inputs.
///
/// # Errors
/// A file that cannot be read, or is no list of worst inputs.
pub fn read(files: &dyn Files, path: &Path) -> Result<Vec<WorstInput>, Diagnostic> {
    let told =
        |error: String| Diagnostic::error("worst-input", error).in_file(path.display().to_string());
    let text = read_text(files, path).map_err(|problem| told(problem.message))?;
    serde_json::from_str(&text).map_err(|error| told(error.to_string()))
}
