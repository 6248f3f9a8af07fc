//! Report of the measurements, as data and as a table.

use std::fmt::Write as _;

use serde::{Serialize, Serializer};

use super::size::Sizes;
use super::{ErrorFigures, Measure, TimeEstimate};
use crate::document::Tier;
use crate::frame::PassId;
use crate::ids::NodeId;

/// All measurements of one run.
#[derive(Clone, Debug, Serialize)]
pub struct BenchReport {
    /// The GPU's name.
    pub adapter: String,
    /// True if the adapter is a software renderer, whose times say little about a device's.
    pub is_software: bool,
    /// True if times are the GPU's own timestamps; otherwise they are wall-clock times.
    pub has_timestamps: bool,
    /// Width and height of the picture, in pixels.
    pub size: [u32; 2],
    /// Samples a pixel.
    pub samples: u32,
    /// Number of times each variant was drawn.
    pub rounds: usize,
    /// Rows in the order of measuring: the whole look with its passes, then nodes.
    pub rows: Vec<MeasurementRow>,
}

/// Subject of a row.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum MeasurementSubject {
    /// The whole frame.
    Whole,
    /// A pass of the whole frame in the row before.
    Pass(PassId),
    /// A node; the row's time and sizes are what the node adds.
    Node {
        /// The look's name.
        look: String,
        /// The node.
        id: NodeId,
        /// The artist's name of the node.
        name: String,
        /// The node's kind.
        kind: String,
    },
}

/// Tiers that a row measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MeasuredTier {
    /// One tier.
    Named(Tier),
    /// The cheapest tier of each node whose difference nobody can see.
    Automatic,
    /// The tiers that the document asks for, where they are none of the others.
    AsSet,
}

impl MeasuredTier {
    /// True if the tiers can be adopted: they are not those of the document already.
    pub fn is_choice(self) -> bool {
        self != Self::AsSet
    }

    /// The tier of a look that has adopted this one.
    pub fn of_look(self) -> Option<Tier> {
        match self {
            Self::Named(tier) => Some(tier),
            Self::Automatic | Self::AsSet => None,
        }
    }

    /// Word for the tiers in reports.
    pub fn word(self) -> &'static str {
        match self {
            Self::Named(tier) => tier_word(tier),
            Self::Automatic => "automatic",
            Self::AsSet => "as set",
        }
    }
}

impl Serialize for MeasuredTier {
    /// A tier by its word, `automatic`, or null for the document's own.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Named(tier) => tier.serialize(serializer),
            Self::Automatic => serializer.serialize_str("automatic"),
            Self::AsSet => serializer.serialize_none(),
        }
    }
}

/// One measurement.
#[derive(Clone, Debug, Serialize)]
pub struct MeasurementRow {
    /// Subject of the measurement.
    pub subject: MeasurementSubject,
    /// Tiers that were measured.
    pub tier: MeasuredTier,
    /// Time a frame, in milliseconds.
    pub time: TimeEstimate,
    /// Sizes of the frame plan; `None` for a pass.
    pub sizes: Option<Sizes>,
    /// Distance from the truth; `None` if there was no comparison.
    pub error: Option<ErrorFigures>,
}

impl MeasurementRow {
    /// The row's error by the largest difference of a channel.
    pub fn max_error(&self) -> Option<f64> {
        self.error.as_ref().map(|error| error.max)
    }

    /// The row's error by `measure`.
    pub fn error_by(&self, measure: Measure) -> Option<f64> {
        self.error.as_ref().map(|error| measure.of(error))
    }

    fn name(&self) -> String {
        match &self.subject {
            MeasurementSubject::Whole => "whole look".to_owned(),
            MeasurementSubject::Pass(pass) => format!("  {} pass", pass.label()),
            MeasurementSubject::Node { name, .. } => name.clone(),
        }
    }
}

/// The rows of `rows` that no other beats in both time and error, by index, fastest first.
///
/// Rows without an error are never on the front.
pub fn pareto_front(rows: &[&MeasurementRow]) -> Vec<usize> {
    pareto_front_by(rows, Measure::Max)
}

/// The Pareto front as [`pareto_front`] finds it, with errors by `measure`.
pub fn pareto_front_by(rows: &[&MeasurementRow], measure: Measure) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..rows.len()).filter(|&index| rows[index].error.is_some()).collect();
    let key = |index: usize| {
        (rows[index].time.median, rows[index].error_by(measure).unwrap_or(f64::INFINITY))
    };
    order.sort_by(|&a, &b| key(a).0.total_cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    let mut best = f64::INFINITY;
    order.retain(|&index| {
        let is_better = key(index).1 < best;
        best = best.min(key(index).1);
        is_better
    });
    order
}

/// Word for a tier in reports.
pub fn tier_word(tier: Tier) -> &'static str {
    match tier {
        Tier::Exact => "exact",
        Tier::Balanced => "balanced",
        Tier::Fast => "fast",
    }
}

impl BenchReport {
    /// Lines that tell which tiers of the whole look are within the error `most` by `measure`;
    /// empty if no error is known.
    pub fn verdict(&self, measure: Measure, most: f64) -> String {
        let mut lines = String::new();
        for row in self.rows.iter().filter(|row| row.subject == MeasurementSubject::Whole) {
            let (Some(error), Some(figures)) = (row.error_by(measure), &row.error) else {
                continue;
            };
            let [x, y] = figures.worst;
            let is_within = if error <= most { "within" } else { "beyond" };
            let _ = writeln!(
                lines,
                "{}: {is_within} {most:.2e} by {} ({error:.1e}); {} of {} pixels differ by more \
                 than 1/255, most at {x},{y}",
                row.tier.word(),
                measure.word(),
                figures.visible,
                figures.pixels,
            );
        }
        lines
    }

    /// The report as a table of text.
    pub fn table(&self) -> String {
        let mut lines = vec![HEADER.map(str::to_owned)];
        lines.extend(self.rows.iter().map(cells));
        let widths: Vec<usize> = (0..HEADER.len())
            .map(|column| lines.iter().map(|l| l[column].chars().count()).max().unwrap_or(0))
            .collect();
        let mut text = String::new();
        let clock = if self.has_timestamps { "GPU timestamps" } else { "the clock on the wall" };
        let software = if self.is_software {
            "; a software adapter, whose times say little about a GPU's"
        } else {
            ""
        };
        let [width, height] = self.size;
        let _ = writeln!(
            text,
            "{width}x{height}, {} sample{} a pixel, {} rounds on {} ({clock}{software})\n",
            self.samples,
            if self.samples == 1 { "" } else { "s" },
            self.rounds,
            self.adapter,
        );
        for (index, line) in lines.iter().enumerate() {
            let cells = line.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| {
                // Words to the left, numbers to the right.
                if column < 2 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
            });
            let _ = writeln!(text, "{}", cells.collect::<Vec<_>>().join("  ").trim_end());
            if index == 0 {
                let rules: Vec<String> = widths.iter().map(|&width| "-".repeat(width)).collect();
                let _ = writeln!(text, "{}", rules.join("  "));
            }
        }
        text.push_str(NOTES);
        text
    }
}

const HEADER: [&str; 12] = [
    "what",
    "tier",
    "ms",
    "95% from",
    "to",
    "instr.",
    "KiB",
    "KiB moved",
    "max error",
    "rms",
    "99.9%",
    "over 1/255",
];

const NOTES: &str = "
Times are medians with their 95% confidence interval; a node's is what it adds to the exact look, \
and (noise) says that
nothing was seen beyond chance. Errors are distances from the reference picture in f64, in \
channels from 0 to 1.
";

fn cells(row: &MeasurementRow) -> [String; 12] {
    let is_node = matches!(row.subject, MeasurementSubject::Node { .. });
    let noise = if is_node && row.time.is_noise() { " (noise)" } else { "" };
    let kib = |bytes: u64| format!("{:.0}", bytes as f64 / 1024.0);
    let sizes = |get: fn(&Sizes) -> String| row.sizes.as_ref().map_or_else(String::new, get);
    let error = |get: fn(&ErrorFigures) -> f64| {
        row.error.as_ref().map_or_else(String::new, |e| small(get(e)))
    };
    [
        row.name(),
        row.tier.word().to_owned(),
        format!("{:.3}{noise}", row.time.median),
        format!("{:.3}", row.time.low),
        format!("{:.3}", row.time.high),
        sizes(|sizes| sizes.instructions.to_string()),
        row.sizes.as_ref().map_or_else(String::new, |sizes| kib(sizes.memory)),
        row.sizes.as_ref().map_or_else(String::new, |sizes| kib(sizes.traffic)),
        match &row.error {
            Some(error) if error.max > 0.0 => {
                format!("{} at {},{}", small(error.max), error.worst[0], error.worst[1])
            }
            Some(_) => "0".to_owned(),
            None => String::new(),
        },
        error(|error| error.rms),
        error(|error| error.p999),
        row.error.as_ref().map_or_else(String::new, |error| error.visible.to_string()),
    ]
}

/// The number with two digits, whatever its magnitude.
fn small(number: f64) -> String {
    if number == 0.0 { "0".to_owned() } else { format!("{number:.1e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(time: f64, error: f64) -> MeasurementRow {
        MeasurementRow {
            subject: MeasurementSubject::Whole,
            tier: MeasuredTier::AsSet,
            time: TimeEstimate { median: time, low: time, high: time },
            sizes: None,
            error: Some(ErrorFigures { max: error, ..ErrorFigures::default() }),
        }
    }

    #[test]
    fn the_front_is_what_nothing_beats() {
        let rows = [
            row(3.0, 0.1),
            row(1.0, 0.5),
            row(2.0, 0.6),
            row(4.0, 0.1),
            row(5.0, 0.0),
            row(1.0, 0.4),
        ];
        let rows: Vec<&MeasurementRow> = rows.iter().collect();
        assert_eq!(pareto_front(&rows), [5, 0, 4]);
    }

    #[test]
    fn a_table_is_aligned_and_says_what_is_noise() {
        let mut noisy = row(0.1, 0.0);
        noisy.time.low = -0.1;
        let (id, name, kind) = ("tone".into(), "Tone".to_owned(), "profile".to_owned());
        noisy.subject = MeasurementSubject::Node { look: "Rim".to_owned(), id, name, kind };
        let report = BenchReport {
            adapter: "an adapter".to_owned(),
            is_software: true,
            has_timestamps: true,
            size: [64, 32],
            samples: 1,
            rounds: 9,
            rows: vec![row(3.0, 0.25), noisy],
        };
        let table = report.table();
        assert!(
            table.starts_with(
                "64x32, 1 sample a pixel, 9 rounds on an adapter (GPU timestamps; a software"
            ),
            "{table}"
        );
        assert!(table.contains("(noise)") && table.contains("2.5e-1 at 0,0"), "{table}");
        let lines: Vec<&str> = table.lines().collect();
        let column = lines[2].find("95%").unwrap() + "95% from".len();
        assert_eq!(lines[4].as_bytes()[column - 5..column], *b"3.000");
    }
}
