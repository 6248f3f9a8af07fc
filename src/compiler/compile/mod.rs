//! From a look to one WGSL module.
//!
//! [`check()`] inlines groups and types every value; `specialize` folds, merges and removes, each
//! removal with its reason; `emit` writes the WGSL, which naga then validates. Each step has its
//! own type, so none can be left out.

mod about;
mod aov;
mod check;
mod drivers;
mod emit;
mod flatten;
mod functions;
mod host;
mod host_source;
mod intervals;
mod items;
mod layout;
mod names;
mod parting;
mod reach;
mod removal;
mod specialize;
mod tiers;
mod titles;
mod transfer;
mod value;

use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{LightInput, Look, Tier, Value};
use crate::ids::{LightId, NodePath, PortName};
use crate::library::{Library, Treatment, Type};
use crate::wgsl::{self, ValidModule};

pub use crate::document::{LightValues, MAX_INTENSITY, MIN_LIGHT_DISTANCE};
pub use crate::library::Stage;
pub use aov::{
    AovSource, BentLights, ShadowOutput, StackPart, StackParts, StepId, TypedAov, WireOutput,
    can_be_aov, wire_outputs,
};
use check::check_with;
pub use check::{TypedGraph, TypedInput, TypedNode, TypedSource, check};
pub use drivers::TypedDriver;
pub use emit::{Binding, BindingKind, ImageBinding, SAMPLES_PER_ROW, SpanMap, VertexAttribute};
pub use flatten::{
    GroupLabel, GroupOutputs, MAX_FLAT_NODES, Param, ParamId, RegionCopy, RegionIndex, TierReason,
    can_be_muted,
};
pub use functions::write_line;
pub use host::{
    ArrayPlace, HostDriver, HostInputs, HostProgram, Uniform, UniformMember, push_numbers,
};
pub use host_source::{HostSource, HostStep};
pub use layout::{StructLayout, ValueLayout};
pub use reach::{NodeReach, node_reach};
pub use removal::{Proof, Removal};
use specialize::LightLoop;
pub use specialize::{ImageShape, ImageUse, Needs};
pub use titles::node_title;
pub use transfer::{TRANSFER_SIZE, Transfer, TransferTable};
pub use value::{document_value, typed_value};

/// The largest `Look` uniform while every value is live; a longer look keeps fewer values live.
pub const MAX_UNIFORM_BYTES: u32 = 16 * 1024;

/// Choice of the values that stay uniforms, so that changing them compiles nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Live {
    /// Only what keys move; all else is folded. For a look at rest.
    #[default]
    Keyed,
    /// Also exposed parameters. For export and for scenes that set them.
    Exposed,
    /// Also these inputs. For a long look that is being edited.
    Touched(HashSet<(NodePath, PortName)>),
    /// Every value. For a look that is being edited.
    All,
}

/// Choice of the regions that go through their lights in a loop; others have the code of each
/// light one after another. Both compute the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loops {
    /// Regions that are long enough for a loop to be quicker to compile and no slower to run.
    #[default]
    ByCost,
    /// None.
    Never,
    /// Regions in which two or more lights that follow one another do the same.
    Always,
}

/// Options of a compilation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CompileOptions {
    /// Choice of the values that stay uniforms.
    pub live: Live,
    /// Inputs that stay live where a look is too long for [`Live::All`].
    pub touched: HashSet<(NodePath, PortName)>,
    /// The purpose of the module.
    pub stage: Stage,
    /// The output to show in place of the look's own.
    pub root: Option<(NodePath, PortName)>,
    /// Values that the module writes beside the picture, a target each.
    pub aovs: Vec<AovSource>,
    /// True if the module draws which object and material are seen, in place of colors.
    pub mattes: bool,
    /// True if colors of a look in linear light are encoded for display where they leave the
    /// shader.
    pub display: bool,
    /// True if the surface has an alpha cutoff of its own, which a mesh's material may ask for.
    pub cutout: bool,
    /// True if the mesh is deformed: places in the object's own space are those before, so that
    /// marks stay on the surface.
    pub deformed: bool,
    /// Inputs from lights that are known for whoever wears the look: what they are where the light
    /// does not reach ([`LightInput::unlit`]), else 0. Of lights that are out, black, or too far
    /// from every object.
    pub dark: BTreeSet<(LightId, LightInput)>,
    /// Choice of the lights that are gone through in a loop.
    pub loops: Loops,
    /// True if nothing is folded, merged or removed, and a node is exact unless a tier is named for
    /// it: for a module to compare pruned ones with.
    pub unspecialized: bool,
}

/// A look as a validated WGSL module, with all that a renderer must feed it.
#[derive(Debug)]
pub struct CompiledShader {
    /// The source.
    pub wgsl: String,
    /// naga's view of it.
    pub valid: ValidModule,
    /// The purpose of the module.
    pub stage: Stage,
    /// The contexts and images that the module asks of meshes and passes.
    pub needs: Needs,
    /// Bindings of the module, all in group 0.
    pub bindings: Vec<Binding>,
    /// The program that computes the `Look` uniform's members.
    pub host: HostProgram,
    /// The inputs whose values it reads from uniforms, in the order of [`HostInputs::params`].
    pub params: Arc<[Param]>,
    /// Map from the bytes of the source to the nodes that they came from.
    pub spans: SpanMap,
    /// The images that its nodes name, whether or not anything reads them.
    pub named_images: Vec<ImageUse>,
    /// The images that must be opaque for all that it draws to be; `None` if something may be
    /// transparent even then.
    pub opaque_with: Option<Vec<ImageUse>>,
    /// The parts that were left out, each with its reason.
    pub removed: Vec<Removal>,
    /// The nodes whose functions take shorter forms, each with what is left out of it.
    pub removed_within: Vec<Removal>,
    /// The lights that it goes through in loops.
    pub loops: Vec<LoopedLights>,
    /// Choice of the values that are uniforms in this module: fewer than the options ask for where
    /// the uniform would grow past [`MAX_UNIFORM_BYTES`].
    pub live: Live,
    /// The test whether the look cuts parts of the surface away, through which the back is seen.
    pub cutoff: AlphaCutoff,
    /// True if ranges prove that every fragment hides what lies behind it, to the bit: its alpha is
    /// 1. [`Self::opaque_with`] allows for roundings, and for images that may turn out opaque.
    pub is_opaque: bool,
    /// The type of what the module shows.
    pub root_type: crate::library::Type,
    /// The type of each value that is written beside the picture; `None` for nothing. An error
    /// tells why the look does not have what was asked for, and 0 is written for it.
    pub aovs: Vec<Result<Option<Type>, Diagnostic>>,
}

/// Lights that a module goes through in a loop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoopedLights {
    /// The lights, a round each.
    pub lights: Vec<LightId>,
    /// The nodes that join what comes of them.
    pub nodes: Vec<NodePath>,
    /// Operations of one round, as the functions of the nodes stand in their files.
    pub operations: u64,
}

impl CompiledShader {
    /// True if the look cuts parts of its surface away while inputs have the values of `params` in
    /// place of the document's. The answer is the same for a module in which nothing was folded as
    /// for a baked one, so that the reference and the GPU draw the same sides of a surface.
    pub fn cuts(&self, params: &HashMap<ParamId, Value>) -> bool {
        match self.cutoff {
            AlphaCutoff::None => false,
            AlphaCutoff::Wired => true,
            AlphaCutoff::Param(id) => {
                let value = params.get(&id).or_else(|| self.params.get(id)?.value.as_ref());
                let number =
                    value.and_then(|value| typed_value(value, &Type::Float).ok()?.as_f64());
                number.is_some_and(|number| number > 0.0)
            }
        }
    }
}

/// Origin of the alpha cut-off of a look's Output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlphaCutoff {
    /// Nothing is cut away: the module shows no Output, or a material's mask decides.
    None,
    /// The value of an input.
    Param(ParamId),
    /// A wire, so that each place has its own.
    Wired,
}

impl AlphaCutoff {
    fn of(typed: &TypedGraph, stage: Stage) -> Self {
        let output = &typed.nodes[typed.root.0];
        if output.def.special != Treatment::Output || !stage.draws_meshes() {
            return Self::None;
        }
        let mut inputs = output.def.inputs.iter().zip(&output.inputs);
        let cutoff = inputs
            .find(|(port, _)| port.name.as_str() == "cutoff")
            .and_then(|(_, input)| input.as_ref());
        match cutoff.map(|input| &input.source) {
            None => Self::None,
            Some(TypedSource::Param(id, _)) => Self::Param(*id),
            Some(TypedSource::Wire { .. } | TypedSource::Context(_) | TypedSource::Fixed(_)) => {
                Self::Wired
            }
        }
    }
}

/// Compiles a look; warns of oddities, and of faults of nodes that do not reach the output.
///
/// # Errors
/// Everything that is wrong with the nodes that reach the output.
pub fn compile(
    look: &Look,
    library: &Library,
    options: &CompileOptions,
) -> Result<WithWarnings<CompiledShader>, Vec<Diagnostic>> {
    // What pruned modules are compared with is the truth.
    let exact = options
        .unspecialized
        .then(|| Look { tier: Some(look.tier.unwrap_or(Tier::Exact)), ..look.clone() });
    let look = exact.as_ref().unwrap_or(look);
    let (typed, warnings) =
        check_with(look, library, options.root.as_ref(), &options.aovs)?.into_parts();
    Ok(WithWarnings::new(compile_typed(&typed, options)?, warnings))
}

/// The WGSL of a look that was checked, before naga has seen it: our own share of the work, for
/// benchmarks.
///
/// # Errors
/// The diagnostics of constants that the interpreter refuses to fold.
pub fn compile_source(
    typed: &TypedGraph,
    options: &CompileOptions,
) -> Result<String, Vec<Diagnostic>> {
    let specialized = specialize::specialize(typed, options)?;
    Ok(emit::emit(typed, &specialized, options).text)
}

/// Compiles a look that was checked.
///
/// # Errors
/// The diagnostics of constants that the interpreter refuses to fold, or a mistake of our own that
/// naga found.
pub fn compile_typed(
    typed: &TypedGraph,
    options: &CompileOptions,
) -> Result<CompiledShader, Vec<Diagnostic>> {
    let specialized = specialize::specialize(typed, options)?;
    let is_opaque = specialized.is_opaque();
    let emitted = emit::emit(typed, &specialized, options);
    let valid = wgsl::parse(&emitted.text).map_err(|error| vec![emitted.refused(&error)])?;
    let host = emitted.host.with_layout(&valid.module);
    // The reference, which alone runs what is unspecialized, has no bound, and wants every value at
    // f64.
    if host.size > MAX_UNIFORM_BYTES && options.live == Live::All && !options.unspecialized {
        let fewer =
            CompileOptions { live: Live::Touched(options.touched.clone()), ..options.clone() };
        return compile_typed(typed, &fewer);
    }
    Ok(CompiledShader {
        wgsl: emitted.text,
        valid,
        stage: options.stage,
        needs: emitted.needs,
        bindings: emitted.bindings,
        host,
        params: typed.params.clone(),
        spans: emitted.spans,
        named_images: specialized.images,
        opaque_with: specialized.opaque_with,
        removed: specialized.removed,
        removed_within: emitted.removed_within,
        loops: specialized.loops.into_iter().map(LightLoop::into_looped).collect(),
        live: options.live.clone(),
        // A material's mask says by itself whether its other side is to be drawn.
        cutoff: if options.cutout {
            AlphaCutoff::None
        } else {
            AlphaCutoff::of(typed, options.stage)
        },
        is_opaque,
        aovs: typed.aovs.iter().map(|aov| Ok(aov.clone()?.map(|aov| aov.ty))).collect(),
        root_type: emitted.root_type,
    })
}
