//! Sizes of a frame plan, counted and not measured: instructions, memory, and the bytes that must
//! move.

use std::collections::HashSet;
use std::sync::Arc;

use serde::Serialize;

use crate::compile::CompiledShader;
use crate::export::spirv_words;
use crate::frame::{FramePlan, attribute_bytes};

/// Sizes of one frame plan.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Sizes {
    /// SPIR-V instructions within functions, as naga writes them, over all modules that the plan
    /// runs.
    pub instructions: u64,
    /// Lines of WGSL, over the same modules.
    pub lines: u64,
    /// Bytes of uniforms, meshes, images and targets.
    pub memory: u64,
    /// Bytes that a frame must read and write at least once: meshes, images and targets; caches
    /// cannot save these.
    pub traffic: u64,
}

impl Sizes {
    /// Counts the sizes of `plan`.
    pub fn of(plan: &FramePlan) -> Self {
        let mut sizes = Self::default();
        let mut modules: HashSet<*const CompiledShader> = HashSet::new();
        let mut images = HashSet::new();
        let mut meshes = HashSet::new();
        for draw in &plan.draws {
            for shader in draw.modules() {
                if modules.insert(Arc::as_ptr(shader)) {
                    sizes.instructions += instructions(shader);
                    sizes.lines += shader.wgsl.lines().count() as u64;
                }
                // Each draw reads its vertices once in each pass.
                let vertex: u64 = shader.needs.attributes().into_iter().map(attribute_bytes).sum();
                sizes.traffic +=
                    vertex * draw.mesh.positions.len() as u64 + 4 * draw.indices.len() as u64;
            }
            let uniforms = std::iter::once(&draw.object_uniform)
                .chain(draw.look_uniforms.values().map(AsRef::as_ref));
            let uniforms: usize = uniforms.map(|uniform| uniform.bytes.len()).sum();
            sizes.memory += uniforms as u64;
            if meshes.insert(Arc::as_ptr(&draw.mesh)) {
                let vertex: u64 =
                    draw.look.needs.attributes().into_iter().map(attribute_bytes).sum();
                sizes.memory +=
                    vertex * draw.mesh.positions.len() as u64 + 4 * draw.mesh.indices.len() as u64;
            }
            for image in &draw.images {
                if images.insert(image.hash) {
                    let bytes = image.bytes.len() as u64;
                    sizes.memory += bytes;
                    sizes.traffic += bytes;
                }
            }
        }
        let pixels = u64::from(plan.size[0]) * u64::from(plan.size[1]);
        for pass in &plan.passes {
            let (kept, moved) = pass.id.row().bytes_per_pixel(plan.samples);
            sizes.memory += kept * pixels;
            sizes.traffic += moved * pixels;
        }
        sizes
    }
}

/// Instructions within the functions of a module.
pub fn instructions(shader: &CompiledShader) -> u64 {
    let Ok(words) = spirv_words(&shader.valid) else { return 0 };
    count_in_functions(&words)
}

/// SPIR-V instructions begin with a word of their length and their code; functions lie between
/// codes 54 and 56.
fn count_in_functions(words: &[u32]) -> u64 {
    const HEADER: usize = 5;
    const FUNCTION: u32 = 54;
    const FUNCTION_END: u32 = 56;
    let mut count = 0;
    let mut inside = false;
    let mut at = HEADER;
    while let Some(&word) = words.get(at) {
        let (length, code) = ((word >> 16) as usize, word & 0xffff);
        inside |= code == FUNCTION;
        count += u64::from(inside);
        inside &= code != FUNCTION_END;
        at += length.max(1);
    }
    count
}

impl Sizes {
    /// Sizes that this plan needs more than `other`; 0 where it needs less.
    pub fn over(&self, other: &Self) -> Self {
        Self {
            instructions: self.instructions.saturating_sub(other.instructions),
            lines: self.lines.saturating_sub(other.lines),
            memory: self.memory.saturating_sub(other.memory),
            traffic: self.traffic.saturating_sub(other.traffic),
        }
    }
}
