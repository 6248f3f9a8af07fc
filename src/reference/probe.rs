//! Probe of one pixel: the value that every name of a look's source had there.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use chiaro_locale::tr;

use super::executor::execute;
use super::modules::Modules;
use super::options::ReferenceOptions;
use super::shader::QuadBatch;
use crate::diag::Diagnostic;
use crate::frame::FramePlan;
use crate::ids::{LightId, NodePath};
use crate::interp::{Lanes, Precision, Program};
use crate::progress::Progress;

/// A value at the pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedValue {
    /// Name in the generated source.
    pub name: String,
    /// Span of the expression in the source, in bytes.
    pub span: Range<usize>,
    /// Scalars of the value, in order; bools are 0 or 1.
    pub numbers: Vec<f64>,
}

/// Values that the visible fragment of a pixel computed.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedFragment {
    /// Index of the draw in the plan.
    pub draw: usize,
    /// Depth, from 0 (near) to 1 (far).
    pub depth: f64,
    /// Values in the order of computation.
    pub values: Vec<ProbedValue>,
}

/// Watch on a pixel that keeps the values of its nearest fragment.
#[derive(Debug)]
pub(super) struct PixelWatch {
    pixel: [u32; 2],
    found: Mutex<Option<ProbedFragment>>,
}

impl PixelWatch {
    /// Keeps the values of a batch that was just run if it has a fragment at the pixel that is
    /// nearer than all before.
    pub(super) fn look(
        &self,
        batch: &QuadBatch,
        discarded: u64,
        draw: usize,
        lanes: &Lanes<'_>,
        program: &Program,
    ) {
        let [x, y] = self.pixel.map(|side| f64::from(side) + 0.5);
        let lives = batch.live() & !discarded;
        let here = (0..batch.lanes())
            .filter(|&lane| lives >> lane & 1 == 1)
            .filter(|&lane| batch.position(0)[lane] == x && batch.position(1)[lane] == y);
        for lane in here {
            let depth = batch.position(2)[lane];
            let mut found = self.found.lock().unwrap_or_else(PoisonError::into_inner);
            if found.as_ref().is_some_and(|found| found.depth <= depth) {
                continue;
            }
            let mut values: Vec<ProbedValue> = program
                .observed()
                .iter()
                .map(|value| ProbedValue {
                    name: value.name.clone(),
                    span: value.span.clone(),
                    numbers: lanes.observe(value, lane),
                })
                .collect();
            // The source computes from top to bottom: functions stand before those that call them.
            values.sort_by_key(|value| value.span.start);
            *found = Some(ProbedFragment { draw, depth, values });
        }
    }
}

/// Runs the passes that `plan` needs for one pixel, and returns the values that the visible
/// fragment computed there; `None` if nothing is drawn. Functions that are called several times
/// (those of the library) have the values of their last call only.
///
/// # Errors
/// As [`execute`], and `reference-plan` for a pixel outside of the picture.
pub fn probe(
    plan: &FramePlan,
    pixel: [u32; 2],
    precision: Precision,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<Option<ProbedFragment>, Diagnostic> {
    if pixel[0] >= plan.size[0] || pixel[1] >= plan.size[1] {
        let ([x, y], [width, height]) = (pixel, plan.size);
        let message = tr!("there is no pixel {x},{y} in {width}x{height}");
        return Err(Diagnostic::error("reference-plan", message)
            .hint(tr!("columns and rows are counted from 0")));
    }
    let modules =
        Modules::watching(plan, precision, PixelWatch { pixel, found: Mutex::new(None) })?;
    let [x, y] = pixel;
    let options = ReferenceOptions { region: Some([x, y, x + 1, y + 1]), ..*options };
    execute(plan, &modules, &options, progress)?;
    Ok(modules.into_found())
}

/// A node's value at a pixel, in both precisions.
#[derive(Clone, Debug, PartialEq)]
pub struct WireValue {
    /// Index, in the plan, of the draw that the pixel shows.
    pub draw: usize,
    /// Path of the node.
    pub node: NodePath,
    /// Light that the value is about, where that is one alone; of plans as looks are written.
    pub light: Option<LightId>,
    /// Name of the value in the generated source.
    pub name: String,
    /// Value with every operation rounded to f32, as a GPU computes.
    pub single: Vec<f64>,
    /// Value in f64: the truth.
    pub double: Vec<f64>,
}

impl WireValue {
    /// The largest difference between the two values; infinite if a number is finite in only one of
    /// them.
    pub fn difference(&self) -> f64 {
        let pairs = self.single.iter().zip(&self.double);
        pairs
            .map(|(a, b)| if a.to_bits() == b.to_bits() || a == b { 0.0 } else { (a - b).abs() })
            .fold(0.0, |most, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
    }

    /// True if all numbers are finite in f32.
    pub fn is_finite(&self) -> bool {
        self.single.iter().all(|x| x.is_finite())
    }
}

/// Every node's value at a pixel, in the order of computation, f32 beside f64; `None` if nothing is
/// drawn. The first value that is [not finite](WireValue::is_finite) is the origin of a broken
/// pixel.
///
/// # Errors
/// As [`probe`].
pub fn probe_wires(
    plan: &FramePlan,
    pixel: [u32; 2],
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<Option<Vec<WireValue>>, Diagnostic> {
    let both = [Precision::F32, Precision::F64]
        .map(|precision| probe(plan, pixel, precision, options, progress));
    let [single, double] = both;
    let (Some(single), Some(double)) = (single?, double?) else { return Ok(None) };
    let drawn = double.draw;
    let Some(draw) = plan.draws.get(drawn) else { return Ok(None) };
    let wires = double.values.into_iter().filter_map(|value| {
        let node = draw.look.spans.node_at(value.span.start)?.clone();
        let same =
            single.values.iter().find(|other| other.span == value.span && single.draw == drawn)?;
        Some(WireValue {
            draw: drawn,
            node,
            light: draw.look.spans.light_at(value.span.start).cloned(),
            name: value.name,
            single: same.numbers.clone(),
            double: value.numbers,
        })
    });
    Ok(Some(wires.collect()))
}

impl PixelWatch {
    /// The values of the nearest fragment at the pixel.
    pub(super) fn into_found(self) -> Option<ProbedFragment> {
        self.found.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}
