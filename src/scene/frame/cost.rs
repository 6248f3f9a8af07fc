//! What effects cost: counted here, and measured by whoever has a GPU.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Serialize;

use super::plan::{Draw, PassKind, PlanOptions};
use crate::compile::{Attribute, CompiledShader};
use crate::figures;
use crate::wgsl::{self, Operations, Valid};

/// What an effect costs; of what is dropped, what it would cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EffectCost {
    /// Operations at each fragment that it is drawn at, counted in naga's IR (see [`Operations`]);
    /// 0 for what has none.
    pub operations: u64,
    /// Bytes of memory that it holds.
    pub bytes: u64,
    /// What the GPU took for it, where that was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub milliseconds: Option<f64>,
}

impl EffectCost {
    /// Operations alone.
    pub fn operations(operations: u64) -> Self {
        Self { operations, ..Self::default() }
    }

    /// Memory alone.
    pub fn bytes(bytes: u64) -> Self {
        Self { bytes, ..Self::default() }
    }
}

impl std::fmt::Display for EffectCost {
    /// `12.3 ms, 214 operations, 7.5 MiB`: what there is of it.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let milliseconds = self.milliseconds.map(|ms| {
            format!("{} ms", if ms < 9.95 { format!("{ms:.2}") } else { format!("{ms:.0}") })
        });
        let operations =
            (self.operations > 0).then(|| figures::count(self.operations, "operation"));
        let bytes = (self.bytes > 0).then(|| figures::bytes(self.bytes));
        let parts: Vec<String> = [milliseconds, operations, bytes].into_iter().flatten().collect();
        f.write_str(if parts.is_empty() { "nothing" } else { "" })?;
        f.write_str(&parts.join(", "))
    }
}

impl PassKind {
    /// Bytes a pixel that a pass keeps, and that it at least reads and writes once.
    pub fn bytes_per_pixel(&self, samples: u32) -> (u64, u64) {
        const COLOR: u64 = 8;
        const NORMAL: u64 = 16;
        const NUMBER: u64 = 4;
        let samples = u64::from(samples);
        match self {
            // Normals, distance and a depth buffer, written.
            Self::Normals | Self::DetailNormals => (NORMAL + 2 * NUMBER, NORMAL + 2 * NUMBER),
            // Normals and distances read, curvature written, and read again by the look.
            Self::Curvature
            | Self::SparseCurvature
            | Self::DetailCurvature
            | Self::SparseDetailCurvature => (NUMBER, NORMAL + NUMBER + 2 * NUMBER),
            // The same with four numbers each.
            Self::CurvatureTensor | Self::SmoothNormals(_) => (NORMAL, 3 * NORMAL + NUMBER),
            Self::Look if samples > 1 => {
                (COLOR + samples * (COLOR + NUMBER), COLOR + 2 * samples * (COLOR + NUMBER))
            }
            Self::Look => (COLOR + NUMBER, COLOR + NUMBER),
        }
    }
}

/// Bytes that a vertex's attribute takes.
pub fn attribute_bytes(attribute: Attribute) -> u64 {
    match attribute {
        Attribute::Uv => 8,
        Attribute::Position | Attribute::Normal => 12,
        Attribute::Tangent | Attribute::Color => 16,
    }
}

/// What passes that are not in a plan would hold.
pub(super) fn of_passes(kinds: &[&PassKind], options: &PlanOptions) -> EffectCost {
    let pixels = u64::from(options.size[0]) * u64::from(options.size[1]);
    let bytes: u64 = kinds.iter().map(|kind| kind.bytes_per_pixel(1).0).sum();
    EffectCost::bytes(bytes * pixels)
}

/// The operations at each fragment of the modules that a pass runs; the most, where objects differ.
pub(super) fn pass_operations(kind: &PassKind, draws: &[Draw]) -> u64 {
    let most = |of: &dyn Fn(&Draw) -> Option<&Arc<CompiledShader>>| {
        draws
            .iter()
            .filter_map(of)
            .map(|shader| module_operations(&shader.valid))
            .max()
            .unwrap_or_default()
    };
    match kind {
        PassKind::Look => most(&|draw| Some(&draw.look)),
        PassKind::Normals | PassKind::DetailNormals => most(&|draw| draw.normals.get(kind)),
        _ => kind.shader().map_or(0, fixed_operations),
    }
}

/// The operations of a fixed pass.
fn fixed_operations(name: &str) -> u64 {
    let valid = wgsl::pass(name).ok().and_then(|linked| wgsl::parse(&linked.text).ok());
    valid.as_ref().map_or(0, module_operations)
}

/// The operations of a whole module.
fn module_operations(valid: &Valid) -> u64 {
    Operations::of(&valid.module).of_entry_points(&valid.module)
}

/// The operations at each fragment of a module, whole and of every node that is in it.
pub(super) fn shader_operations(shader: &CompiledShader) -> (u64, BTreeMap<String, u64>) {
    let module = &shader.valid.module;
    let operations = Operations::of(module);
    let mut counted: BTreeMap<String, u64> =
        shader.spans.nodes().map(|path| (path.to_string(), 0)).collect();
    operations.for_each(module, |span, operations| {
        if let Some(path) = shader.spans.node_at(span.start) {
            *counted.entry(path.to_string()).or_default() += operations;
        }
    });
    (operations.of_entry_points(module), counted)
}
