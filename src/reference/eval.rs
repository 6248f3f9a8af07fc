//! Surface samples through a look's evaluation module, as the renderer runs them on the GPU.

use super::shader::LANES;
use super::uniform;
use crate::diag::Diagnostic;
use crate::frame::{BindingKind, EvalBatch, SAMPLES_PER_ROW};
use crate::interp::{self, Bindings, Precision, Program, ResourceKind, Value};

/// The root's value at each sample of a batch, in the batch's order: up to four numbers, by the root's type.
///
/// # Errors
/// What the interpreter cannot run.
pub fn evaluate(batch: &EvalBatch, precision: Precision) -> Result<Vec<[f64; 4]>, Diagnostic> {
    let count = batch.indices.len();
    let program = Program::compile(&batch.shader.valid.module, "fs_main", interp::Options::stage(&batch.shader.wgsl))?;
    let bindings = bindings(batch, &program, count)?;
    let first = |problems: Vec<Diagnostic>| {
        let nothing = || Diagnostic::error("reference-plan", "what a module reads is missing");
        problems.into_iter().next().unwrap_or_else(nothing)
    };
    let bound = program.bind(&bindings, precision).map_err(first)?;
    let mut lanes = bound.lanes()?;
    let [position] = program.inputs() else {
        return Err(Diagnostic::error("reference-plan", "the module evaluates no samples"));
    };
    let [value] = program.outputs() else {
        return Err(Diagnostic::error("reference-plan", "the module gives no value"));
    };
    let mut values = Vec::with_capacity(count);
    let mut row = [0.0; LANES];
    // A quad a sample, so that derivatives are 0 as they are on the GPU.
    for first in (0..count).step_by(LANES / 4) {
        let here = (count - first).min(LANES / 4);
        for component in 0..position.size {
            for (lane, cell) in row[..4 * here].iter_mut().enumerate() {
                let index = first + lane / 4;
                let (column, line) = (index % SAMPLES_PER_ROW as usize, index / SAMPLES_PER_ROW as usize);
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

fn bindings(batch: &EvalBatch, program: &Program, count: usize) -> Result<Bindings, Diagnostic> {
    let mut bindings = Bindings::new();
    let stride = batch.samples.numbers.len().checked_div(count).unwrap_or(0);
    for binding in &batch.shader.bindings {
        let at = binding.binding;
        match &binding.kind {
            BindingKind::Samples => {
                let resource = program.resources().iter().find(|r| (r.group, r.binding) == (0, at));
                if let Some(ResourceKind::Unsized { element, .. }) = resource.map(|resource| &resource.kind) {
                    let numbers = batch.samples.numbers.chunks_exact(stride.max(1));
                    let samples = numbers.map(|numbers| uniform::value(element, &mut numbers.iter().copied()));
                    bindings.buffer(0, at, Value::Array(samples.collect()));
                }
            }
            BindingKind::Image(index) | BindingKind::Hcbtf(index) => {
                if let Some((image, used)) = batch.images.get(*index).zip(batch.shader.needs.images.get(*index)) {
                    bindings.texture(0, at, super::modules::texture_of(image, used)?);
                }
            }
            BindingKind::Sampler(index) => {
                if let Some(used) = batch.shader.needs.images.get(*index) {
                    bindings.sampler(0, at, super::modules::sampler_of(used));
                }
            }
            _ => {}
        }
    }
    Ok(bindings)
}
