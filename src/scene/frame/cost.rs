//! Costs of effects: operations and bytes are counted here, time is measured by those who have a
//! GPU.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use serde::Serialize;

use super::plan::{Draw, PlanOptions};
use super::screen::ScreenModule;
use super::shadow_maps::LightModule;
use crate::compile::{CompileOptions, CompiledShader, TierReason, VertexAttribute, check, compile};
use crate::diag::Diagnostic;
use crate::document::{Look, Tier};
use crate::figures;
use crate::library::{Library, PassId};
use crate::wgsl::{Operations, ValidModule};

/// Cost of an effect; for a dropped effect, the cost that it would have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EffectCost {
    /// Number of operations at each fragment that the effect is drawn at, counted in naga's IR (see
    /// [`Operations`]); 0 for effects without operations.
    pub operations: u64,
    /// Memory that the effect holds, in bytes.
    pub bytes: u64,
    /// Time that the GPU took for the effect, in milliseconds; `None` where it was not measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub milliseconds: Option<f64>,
}

impl EffectCost {
    /// A cost in operations alone.
    pub fn operations(operations: u64) -> Self {
        Self { operations, ..Self::default() }
    }

    /// A cost in memory alone.
    pub fn bytes(bytes: u64) -> Self {
        Self { bytes, ..Self::default() }
    }
}

impl std::fmt::Display for EffectCost {
    /// Writes `12.3 ms, 214 operations, 7.5 MiB`: the parts of the cost that are not 0.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let milliseconds = self.milliseconds.map(|ms| {
            format!("{} ms", if ms < 9.95 { format!("{ms:.2}") } else { format!("{ms:.0}") })
        });
        let operations = (self.operations > 0).then(|| {
            let count = self.operations;
            trn!(count, "{count} operation", "{count} operations")
        });
        let bytes = (self.bytes > 0).then(|| figures::bytes(self.bytes));
        let parts: Vec<String> = [milliseconds, operations, bytes].into_iter().flatten().collect();
        f.write_str(if parts.is_empty() { tr!("nothing") } else { "" })?;
        f.write_str(&parts.join(", "))
    }
}

/// Size of a vertex's attribute, in bytes.
pub fn attribute_bytes(attribute: VertexAttribute) -> u64 {
    match attribute {
        VertexAttribute::Uv => 8,
        VertexAttribute::Position | VertexAttribute::Normal | VertexAttribute::Rest => 12,
        VertexAttribute::Tangent | VertexAttribute::Color => 16,
    }
}

/// The memory that passes that are not in a plan would hold.
pub(super) fn of_passes(passes: impl Iterator<Item = PassId>, options: &PlanOptions) -> EffectCost {
    let pixels = u64::from(options.size[0]) * u64::from(options.size[1]);
    let bytes: u64 = passes.map(|pass| pass.row().bytes_per_pixel(1).0).sum();
    EffectCost::bytes(bytes * pixels)
}

/// The number of operations at each fragment of the modules that a pass runs; the greatest number
/// where objects differ.
pub(super) fn pass_operations(pass: PassId, draws: &[Draw]) -> u64 {
    let Some(stage) = pass.stage() else {
        let of_lights = || Some(LightModule::of(pass).ok().flatten()?.valid);
        let valid = ScreenModule::of(pass).ok().flatten().map(|module| module.valid);
        return valid.or_else(of_lights).map_or(0, |valid| module_operations(&valid));
    };
    let modules = draws.iter().filter_map(|draw| draw.module(stage));
    // Many draws share few modules.
    let modules: HashMap<_, _> = modules.map(|shader| (Arc::as_ptr(shader), shader)).collect();
    modules.values().map(|shader| module_operations(&shader.valid)).max().unwrap_or_default()
}

/// The number of operations of a whole module.
fn module_operations(valid: &ValidModule) -> u64 {
    Operations::of(&valid.module).of_entry_points(&valid.module)
}

/// The number of operations at each fragment of a module: of the whole module, and of every node in
/// the module.
pub(super) fn shader_operations(shader: &CompiledShader) -> (u64, BTreeMap<String, u64>) {
    let module = &shader.valid.module;
    let operations = Operations::of(module);
    let mut counted: BTreeMap<String, u64> =
        shader.spans.nodes().map(|path| (path.to_string(), 0)).collect();
    operations.for_each(module, |span, operations| {
        if let Some(path) = shader.spans.node_of(&span) {
            *counted.entry(path.to_string()).or_default() += operations;
        }
    });
    (operations.of_entry_points(module), counted)
}

/// Operations at each fragment in every tier.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct TierOperations {
    /// Operations in the exact tier.
    pub exact: u64,
    /// Operations in the balanced tier.
    pub balanced: u64,
    /// Operations in the fast tier.
    pub fast: u64,
}

impl TierOperations {
    /// Operations in a tier.
    pub fn of(&self, tier: Tier) -> u64 {
        match tier {
            Tier::Exact => self.exact,
            Tier::Balanced => self.balanced,
            Tier::Fast => self.fast,
        }
    }

    /// True if the tiers cost the same.
    pub fn are_same(&self) -> bool {
        self.exact == self.balanced && self.balanced == self.fast
    }
}

/// Tier of a node of a look, with what the node costs in every tier.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TierCosts {
    /// Path of the node through the groups it lies in.
    pub node: String,
    /// Tier of the node.
    pub tier: Tier,
    /// Origin of the tier.
    pub reason: TierReason,
    /// Difference from the exact tier that the node's file states of the balanced one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balanced_error: Option<f64>,
    /// Operations at each fragment in every tier, counted in naga's IR, where the whole look is in
    /// that tier.
    pub operations: TierOperations,
}

/// Costs of a look's nodes that run at each fragment, in every tier.
///
/// # Errors
/// All errors of the look.
pub fn tier_costs(look: &Look, library: &Library) -> Result<Vec<TierCosts>, Vec<Diagnostic>> {
    let options = CompileOptions::default();
    let counted = |tier: Tier| {
        let mut look = look.clone();
        look.set_every_tier(tier);
        let shader = compile(&look, library, &options)?.value;
        Ok::<_, Vec<Diagnostic>>(shader_operations(&shader).1)
    };
    let exact = counted(Tier::Exact)?;
    let (balanced, fast) = (counted(Tier::Balanced)?, counted(Tier::Fast)?);
    let nodes = check(look, library, None)?.value.nodes;
    let costs = nodes.into_iter().filter_map(|node| {
        let path = node.path.to_string();
        let of = |counts: &BTreeMap<String, u64>| counts.get(&path).copied().unwrap_or_default();
        let operations =
            TierOperations { exact: *exact.get(&path)?, balanced: of(&balanced), fast: of(&fast) };
        Some(TierCosts {
            tier: node.tier,
            reason: node.tier_reason,
            balanced_error: node.def.error_of(Tier::Balanced).map(|error| error.bound),
            operations,
            node: path,
        })
    });
    Ok(costs.collect())
}
