//! Evaluation of surface samples by a look's evaluation module, as the renderer runs it on the GPU.

use std::sync::Arc;

use chiaro_locale::tr;

use super::shader::LANES;
use super::uniform;
use crate::diag::Diagnostic;
use crate::frame::{
    BindingKind, Casters, CompiledShader, EvalBatch, Image, SAMPLES_PER_ROW, Uniform,
};
use crate::interp::{self, Bindings, BoundProgram, Precision, Program, ResourceKind, Value};
use crate::progress::Progress;

/// The root's value at each sample of a batch, in the batch's order: up to four numbers, by the
/// root's type.
///
/// # Errors
/// Modules that the interpreter cannot run.
pub fn evaluate(batch: &EvalBatch, precision: Precision) -> Result<Vec<[f64; 4]>, Diagnostic> {
    let evaluator = Evaluator::new(&batch.shader, &batch.images)?;
    evaluator.run(&batch.samples, batch.indices.len(), precision, &Progress::new())
}

/// A look's evaluation module, ready to run for any number of batches, on any number of threads.
#[derive(Debug)]
pub(super) struct Evaluator {
    program: Program,
    /// Images and samplers, which are the same for all batches.
    bindings: Bindings,
    /// Binding of the samples.
    samples: Option<u32>,
}

impl Evaluator {
    pub(super) fn new(shader: &CompiledShader, images: &[Arc<Image>]) -> Result<Self, Diagnostic> {
        let literals = interp::Literals::of(&shader.wgsl);
        let options = interp::FunctionOptions::stage(&literals);
        let program = Program::compile(&shader.valid.module, "fs_main", options)?;
        let mut bindings = Bindings::new();
        let mut samples = None;
        for binding in &shader.bindings {
            let at = binding.binding;
            match &binding.kind {
                BindingKind::Samples => samples = Some(at),
                BindingKind::Image(index) | BindingKind::Hcbtf(index) => {
                    if let Some((image, used)) =
                        images.get(*index).zip(shader.needs.images.get(*index))
                    {
                        bindings.texture(0, at, super::modules::texture_of(image, used)?);
                    }
                }
                BindingKind::Sampler(index) => {
                    if let Some(used) = shader.needs.images.get(*index) {
                        bindings.sampler(0, at, super::modules::sampler_of(used));
                    }
                }
                BindingKind::Casters => {
                    let none = super::modules::casters_texture(&Casters::default())?;
                    bindings.texture(0, at, none);
                }
                BindingKind::Pass(_) => {
                    bindings.texture(0, at, super::modules::unseen()?);
                }
                _ => {}
            }
        }
        Ok(Self { program, bindings, samples })
    }

    /// The values of `count` packed samples, in their order.
    ///
    /// # Errors
    /// Modules that the interpreter cannot run, and `stopped` if `progress` was stopped.
    pub(super) fn run(
        &self,
        samples: &Uniform,
        count: usize,
        precision: Precision,
        progress: &Progress,
    ) -> Result<Vec<[f64; 4]>, Diagnostic> {
        let bindings = self.with(samples, count);
        let first = |problems: Vec<Diagnostic>| {
            let nothing =
                || Diagnostic::error("reference-plan", tr!("what a module reads is missing"));
            problems.into_iter().next().unwrap_or_else(nothing)
        };
        run(&self.program.bind(&bindings, precision).map_err(first)?, count, progress)
    }

    /// The bindings of the module, with these samples.
    fn with(&self, samples: &Uniform, count: usize) -> Bindings {
        let mut bindings = self.bindings.clone();
        let stride = samples.numbers.len().checked_div(count).unwrap_or(0);
        let Some(at) = self.samples else { return bindings };
        let resource = self.program.resources().iter().find(|r| (r.group, r.binding) == (0, at));
        if let Some(ResourceKind::Unsized { element, .. }) = resource.map(|resource| &resource.kind)
        {
            let numbers = samples.numbers.chunks_exact(stride.max(1));
            let samples =
                numbers.map(|numbers| uniform::value(element, &mut numbers.iter().copied()));
            bindings.buffer(0, at, Value::Array(samples.collect()));
        }
        bindings
    }
}

fn run(
    bound: &BoundProgram<'_>,
    count: usize,
    progress: &Progress,
) -> Result<Vec<[f64; 4]>, Diagnostic> {
    let program = bound.program();
    let mut lanes = bound.lanes()?;
    let [position] = program.inputs() else {
        return Err(Diagnostic::error("reference-plan", tr!("the module evaluates no samples")));
    };
    let [value] = program.outputs() else {
        return Err(Diagnostic::error("reference-plan", tr!("the module gives no value")));
    };
    let mut values = Vec::with_capacity(count);
    let mut row = [0.0; LANES];
    // Each sample fills a quad, so that derivatives are 0, as on the GPU.
    for first in (0..count).step_by(LANES / 4) {
        progress.check()?;
        let here = (count - first).min(LANES / 4);
        for component in 0..position.size {
            for (lane, cell) in row[..4 * here].iter_mut().enumerate() {
                let index = first + lane / 4;
                let (column, line) =
                    (index % SAMPLES_PER_ROW as usize, index / SAMPLES_PER_ROW as usize);
                *cell = match component {
                    0 => (2 * column + lane % 2) as f64 + 0.5,
                    1 => (2 * line + lane / 2 % 2) as f64 + 0.5,
                    2 => 0.0,
                    _ => 1.0,
                };
            }
            lanes.write(position, component, &row[..4 * here]);
        }
        lanes.run(4 * here)?;
        let begin = values.len();
        values.resize(begin + here, [0.0; 4]);
        for component in 0..value.size.min(4) {
            lanes.read(value, component, &mut row[..4 * here]);
            for (sample, value) in values[begin..].iter_mut().enumerate() {
                value[component] = row[4 * sample];
            }
        }
    }
    Ok(values)
}
