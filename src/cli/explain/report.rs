//! Report on a frame plan, as data.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use serde::Serialize;

use super::super::shot::changes_text;
use crate::compile::{
    BindingKind, CompiledShader, HostStep, LoopedLights, Proof, Removal, TypedGraph, TypedSource,
    VertexAttribute, check,
};
use crate::diag::Diagnostic;
use crate::document::{DirectionKeys, Driver, KeyDirection, Look, Values};
use crate::frame::{
    Draw, DroppedEffect, Effect, FramePlan, Pass, PassId, Setup, TierCosts, ValueChange, effects,
    structural_look, tier_costs,
};
use crate::ids::{LightId, NodePath};
use crate::library::{Context, Library, Rate, Treatment};

/// Largest number of values that a uniform is said to be computed from: along a chain they add up.
const MAX_FROM: usize = 32;

/// Report on a frame plan: passes, effects, looks.
#[derive(Debug, Serialize)]
pub(super) struct ExplainReport {
    /// Values that the shot changes; empty without a shot.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) changes: Vec<ValueChange>,
    /// The same in words.
    #[serde(skip)]
    pub(super) changes_told: String,
    /// Width and height of the picture, in pixels.
    pub(super) size: [u32; 2],
    pub(super) passes: Vec<Pass>,
    pub(super) dropped: Vec<DroppedEffect>,
    /// All effects that the picture may cost time for.
    pub(super) effects: Vec<Effect>,
    /// Size of the uniforms that every module reads, in bytes.
    pub(super) view_bytes: usize,
    pub(super) object_bytes: usize,
    pub(super) looks: Vec<LookReport>,
}

/// A look as it is drawn. A look that is compiled in two ways (because a choice is keyed or set)
/// has two reports.
#[derive(Debug, Serialize)]
pub(super) struct LookReport {
    pub(super) name: String,
    /// Objects that wear the look.
    pub(super) objects: BTreeSet<String>,
    pub(super) modules: Vec<Module>,
    pub(super) attributes: Vec<AttributeReport>,
    pub(super) attributes_not_read: Vec<&'static str>,
    pub(super) surroundings: Vec<SurroundingsReport>,
    pub(super) images: Vec<ImageReport>,
    pub(super) uniforms: Vec<UniformReport>,
    pub(super) keys: Vec<KeysReport>,
    pub(super) nodes: Nodes,
    /// Tiers of the nodes that run at each fragment, with their costs in every tier.
    pub(super) tiers: Vec<TierCosts>,
    /// Greatest difference that counts as unseen where no tier is named.
    pub(super) max_error: f64,
    #[serde(skip)]
    compiled: Vec<(String, Arc<CompiledShader>)>,
}

/// A WGSL module.
#[derive(Debug, Serialize)]
pub(super) struct Module {
    pub(super) name: String,
    pub(super) lines: usize,
    /// Size of the module's `Look` uniform, in bytes.
    pub(super) uniform_bytes: u32,
}

/// A vertex attribute with the reason for it.
#[derive(Debug, Serialize)]
pub(super) struct AttributeReport {
    pub(super) name: &'static str,
    #[serde(rename = "type")]
    pub(super) ty: &'static str,
    pub(super) why: String,
}

/// A context that fragments read.
#[derive(Debug, Serialize)]
pub(super) struct SurroundingsReport {
    #[serde(skip)]
    context: Context,
    pub(super) word: &'static str,
    pub(super) what: &'static str,
    pub(super) readers: Vec<String>,
}

/// An image that the look reads.
#[derive(Debug, Serialize)]
pub(super) struct ImageReport {
    pub(super) path: String,
    pub(super) node: String,
}

/// A member of the `Look` uniform, computed on the host in f64.
#[derive(Debug, Serialize)]
pub(super) struct UniformReport {
    pub(super) name: String,
    #[serde(rename = "type")]
    pub(super) ty: String,
    pub(super) offset: u32,
    pub(super) of: String,
    pub(super) rate: Rate,
    /// Values that the member is computed from; 32 at most.
    pub(super) from: Vec<String>,
}

/// A set of direction keys on one object.
#[derive(Debug, Serialize)]
pub(super) struct KeysReport {
    pub(super) name: String,
    pub(super) object: String,
    /// Drivers of the keys, with their current values.
    pub(super) by: Vec<DecidingDriver>,
    /// Weight of each key; their sum is 1.
    pub(super) weights: Vec<f64>,
}

/// A driver that decides between keys.
#[derive(Debug, Serialize)]
pub(super) struct DecidingDriver {
    pub(super) what: String,
    /// Current value: a number, or a unit direction.
    pub(super) now: Vec<f64>,
    /// Unit of the value: `rad` or empty.
    pub(super) unit: &'static str,
}

/// Stages that the look's nodes run in, groups inlined.
#[derive(Debug, Default, Serialize)]
pub(super) struct Nodes {
    pub(super) total: usize,
    pub(super) fragment: Vec<String>,
    pub(super) host: Vec<String>,
    pub(super) folded: Vec<String>,
    pub(super) removed: Vec<Removal>,
    pub(super) removed_within: Vec<Removal>,
    pub(super) loops: Vec<LoopReport>,
}

/// Lights that are gone through in a loop.
#[derive(Debug, Serialize)]
pub(super) struct LoopReport {
    pub(super) lights: Vec<LightId>,
    /// Nodes that join what comes of the lights.
    pub(super) nodes: Vec<String>,
    /// Operations of one round.
    pub(super) operations: u64,
}

impl LoopReport {
    fn of(looped: &LoopedLights) -> Self {
        let LoopedLights { lights, nodes, operations } = looped.clone();
        Self { lights, nodes: nodes.iter().map(ToString::to_string).collect(), operations }
    }
}

impl ExplainReport {
    /// # Errors
    /// Problems of a look; a look that was planned has none.
    pub(super) fn new(
        setup: &Setup,
        plan: &FramePlan,
        library: &Library,
    ) -> Result<Self, Vec<Diagnostic>> {
        let changes = setup.shot.iter().flat_map(|shot| &shot.changes);
        let standing: Vec<_> = changes.filter(|change| change.stands).cloned().collect();
        let changes_told = changes_text(&standing, true, setup, library);
        let mut looks: Vec<(usize, LookReport)> = Vec::new();
        for draw in &plan.draws {
            let Some((index, values)) = look_of(setup, draw) else { continue };
            let same = |known: &&mut (usize, LookReport)| {
                known.0 == index && Arc::ptr_eq(&known.1.compiled[0].1, &draw.look)
            };
            if let Some((_, known)) = looks.iter_mut().find(same) {
                known.objects.insert(draw.object.to_string());
                known.keys.extend(keys(&setup.looks[index].look, draw));
                continue;
            }
            // Time is in the plan already: the choices at that time were compiled, so nothing here
            // depends on it.
            let shown = structural_look(&setup.looks[index].look, library, 0.0, values);
            let typed = check(&shown, library, None)?.value;
            let keys = keys(&shown, draw);
            let tiers = tier_costs(&shown, library)?;
            let max_error = shown.max_error;
            let report = LookReport::new(&shown.name, draw, &typed);
            looks.push((index, LookReport { keys, tiers, max_error, ..report }));
        }
        looks.sort_by_key(|(index, _)| *index);
        Ok(Self {
            size: plan.size,
            passes: plan.passes.clone(),
            changes: standing,
            changes_told,
            dropped: plan.dropped.clone(),
            effects: effects(plan, &HashMap::new()),
            view_bytes: plan.view.uniform_bytes().len(),
            object_bytes: plan.draws.first().map_or(0, |draw| draw.object_uniform.bytes.len()),
            looks: looks.into_iter().map(|(_, look)| look).collect(),
        })
    }

    /// WGSL of every module; if there are several, each below a line that names it.
    pub(super) fn wgsl(&self) -> String {
        let modules: Vec<_> = self
            .looks
            .iter()
            .flat_map(|look| look.compiled.iter().map(move |m| (look, m)))
            .collect();
        if let [(_, (_, only))] = modules.as_slice() {
            return only.wgsl.clone();
        }
        let told = modules.iter().map(|(look, (name, module))| {
            let of = if look.name.is_empty() { "a look" } else { &look.name };
            let of: String = of.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
            format!("// ---- {of}: {name} ----\n\n{}", module.wgsl)
        });
        told.collect::<Vec<_>>().join("\n")
    }
}

/// Index of the look that a draw wears, and the values that its object sets.
fn look_of<'s>(setup: &'s Setup, draw: &Draw) -> Option<(usize, &'s Values)> {
    let object = setup.objects.iter().find(|object| object.id == draw.object)?;
    let part = object.mesh.parts.iter().position(|part| part.indices == draw.indices)?;
    Some(((*object.looks.get(part)?)?, &object.values))
}

impl LookReport {
    fn new(name: &str, draw: &Draw, typed: &TypedGraph) -> Self {
        let shader = &draw.look;
        let emitted: HashSet<&NodePath> = shader.spans.nodes().collect();
        let named = |module: &Arc<CompiledShader>| {
            let label = PassId::of_stage(module.stage).map_or("look", PassId::label);
            (label.replace(' ', "-"), module.clone())
        };
        let compiled: Vec<_> = draw.modules().map(named).collect();
        let module = |(name, shader): &(String, Arc<CompiledShader>)| Module {
            name: name.clone(),
            lines: shader.wgsl.lines().count(),
            uniform_bytes: shader.host.size,
        };
        let surroundings: Vec<SurroundingsReport> = shader
            .needs
            .contexts
            .iter()
            .map(|context| reading(*context, &emitted, typed))
            .collect();
        let read = shader.needs.attributes();
        Self {
            name: name.to_owned(),
            objects: BTreeSet::from([draw.object.to_string()]),
            modules: compiled.iter().map(module).collect(),
            attributes: read
                .iter()
                .map(|attribute| attribute_report(*attribute, &surroundings))
                .collect(),
            attributes_not_read: VertexAttribute::ALL
                .iter()
                .filter(|a| !read.contains(a))
                .filter(|a| **a != VertexAttribute::Rest || draw.mesh.is_deformed())
                .map(|a| a.name())
                .collect(),
            surroundings,
            images: shader
                .needs
                .images
                .iter()
                .enumerate()
                .filter(|(index, _)| {
                    let is_it = [BindingKind::Image(*index), BindingKind::Hcbtf(*index)];
                    shader.bindings.iter().any(|binding| is_it.contains(&binding.kind))
                })
                .map(|(_, image)| ImageReport {
                    path: image.path.clone(),
                    node: image.node.to_string(),
                })
                .collect(),
            uniforms: uniforms(shader),
            keys: Vec::new(),
            tiers: Vec::new(),
            max_error: 0.0,
            nodes: Nodes::new(shader, &emitted, typed),
            compiled,
        }
    }
}

fn reading(
    context: Context,
    emitted: &HashSet<&NodePath>,
    typed: &TypedGraph,
) -> SurroundingsReport {
    let reads = |input: &Option<crate::compile::TypedInput>| {
        input.as_ref().is_some_and(|input| input.source == TypedSource::Context(context))
    };
    // The Output's normal is read by the modules that draw normals.
    let is_plain = |node: &crate::compile::TypedNode| node.def.special != Treatment::Output;
    let reader = |node: &&crate::compile::TypedNode| {
        node.inputs.iter().any(reads) && is_plain(node) && emitted.contains(&node.path)
    };
    let readers = typed.nodes.iter().filter(reader);
    SurroundingsReport {
        context,
        word: context.word(),
        what: context.help(),
        readers: readers.map(|node| node.path.to_string()).collect(),
    }
}

fn attribute_report(
    attribute: VertexAttribute,
    surroundings: &[SurroundingsReport],
) -> AttributeReport {
    let is_made = |report: &&SurroundingsReport| {
        VertexAttribute::read_by(report.context).contains(&attribute)
    };
    let told = surroundings.iter().filter(is_made);
    let told: Vec<String> =
        told.map(|reading| format!("`{}` for {}", reading.word, names(&reading.readers))).collect();
    let why = match (attribute, told.is_empty()) {
        (VertexAttribute::Position, true) => "it places the mesh in the picture".to_owned(),
        (VertexAttribute::Position, false) => {
            format!("it places the mesh in the picture, and gives {}", told.join(", "))
        }
        (VertexAttribute::Rest, _) => "marks stick to the mesh at rest".to_owned(),
        _ => format!("it gives {}", told.join(", ")),
    };
    AttributeReport { name: attribute.name(), ty: attribute.wgsl_type(), why }
}

/// A list of names; of many, the first few and a count.
pub(super) fn names(paths: &[String]) -> String {
    const MOST: usize = 4;
    let shown: Vec<String> = paths.iter().take(MOST).map(|path| format!("`{path}`")).collect();
    match paths.len() {
        0 => "the module's frame".to_owned(),
        n if n > MOST => format!("{} and {} more", shown.join(", "), n - MOST),
        _ => shown.join(", "),
    }
}

/// The members of the `Look` uniform, with the values that each depends on.
fn uniforms(shader: &CompiledShader) -> Vec<UniformReport> {
    let steps = shader.host.source().steps;
    // Steps read only earlier steps, so one pass over them is enough.
    let mut known: Vec<(Rate, BTreeSet<String>)> = Vec::with_capacity(steps.len());
    for step in &steps {
        known.push(match step {
            HostStep::Constant(_) => (Rate::Constant, BTreeSet::new()),
            HostStep::Param { id, .. } => {
                let param = &shader.params[*id];
                (Rate::Object, BTreeSet::from([format!("{}.{}", param.path, param.port)]))
            }
            HostStep::Context(context, light) => {
                let word = context.word();
                let of_light =
                    |light| format!("lights.{light}.{}", word.trim_start_matches("light."));
                (
                    context.rate(),
                    BTreeSet::from([light.as_ref().map_or_else(|| word.to_owned(), of_light)]),
                )
            }
            HostStep::Call { arguments, .. } => joined(&known, arguments),
            HostStep::Member { value, .. } => joined(&known, &[*value]),
        });
    }
    let uniform = |member: &crate::compile::UniformMember| {
        let (rate, from) = known.get(member.step).cloned().unwrap_or_default();
        UniformReport {
            name: member.name.clone(),
            ty: member.ty.wgsl().to_owned(),
            offset: member.offset,
            of: member.origin.clone(),
            rate,
            from: from.into_iter().collect(),
        }
    };
    shader.host.members.iter().map(uniform).collect()
}

/// The keys of a look on an object, with their drivers.
fn keys(look: &Look, draw: &Draw) -> Vec<KeysReport> {
    let tell = |(keys, (now, weights)): (&DirectionKeys, &(glam::DVec3, Vec<f64>))| KeysReport {
        name: keys.name.clone(),
        object: draw.object.to_string(),
        by: deciding(&keys.by, *now),
        weights: weights.clone(),
    };
    look.direction_keys.iter().zip(&draw.decided).map(tell).collect()
}

fn deciding(by: &KeyDirection, now: glam::DVec3) -> Vec<DecidingDriver> {
    let direction =
        |what: String| vec![DecidingDriver { what, now: now.to_array().to_vec(), unit: "" }];
    let drivers = match by {
        KeyDirection::Light(light) => {
            return direction(format!("the direction of light `{light}`"));
        }
        KeyDirection::View => return direction("the direction to the eye".to_owned()),
        KeyDirection::Drivers(drivers) => drivers,
    };
    let driver = |(driver, now): (&Driver, f64)| {
        let what = match driver {
            Driver::Distance => "the distance to the eye".to_owned(),
            Driver::Facing => "how far it is turned from the eye".to_owned(),
            Driver::Height(light) => format!("the height of light `{light}`"),
            Driver::Near(object) => format!("the distance to object `{object}`"),
            Driver::Wire(wire) => format!("the wire `{wire}`"),
        };
        DecidingDriver { what, now: vec![now], unit: if driver.is_angle() { "rad" } else { "" } }
    };
    drivers.iter().zip(now.to_array()).map(driver).collect()
}

fn joined(known: &[(Rate, BTreeSet<String>)], operands: &[usize]) -> (Rate, BTreeSet<String>) {
    let operands = operands.iter().filter_map(|&index| known.get(index));
    operands.fold((Rate::Constant, BTreeSet::new()), |(rate, mut from), (of, more)| {
        let room = MAX_FROM.saturating_sub(from.len());
        from.extend(more.iter().take(room).cloned());
        (rate.max(*of), from)
    })
}

/// Paths of the nodes that the drivers of keys are computed by.
fn driving(typed: &TypedGraph) -> HashSet<String> {
    let (mut seen, mut open) =
        (HashSet::new(), typed.drivers.iter().map(|driver| driver.node).collect::<Vec<_>>());
    while let Some(index) = open.pop() {
        if !seen.insert(index) {
            continue;
        }
        open.extend(typed.nodes[index].inputs.iter().flatten().filter_map(|input| {
            match &input.source {
                TypedSource::Wire { node, .. } => Some(*node),
                _ => None,
            }
        }));
    }
    seen.into_iter().map(|index| typed.nodes[index].path.to_string()).collect()
}

impl Nodes {
    fn new(shader: &CompiledShader, emitted: &HashSet<&NodePath>, typed: &TypedGraph) -> Self {
        let removed: BTreeMap<&NodePath, &Removal> =
            shader.removed.iter().map(|removal| (&removal.path, removal)).collect();
        // A member's origin is `node` or `node.part`, and no id has a dot.
        let node_of = |origin: &'_ str| {
            origin.split_once('.').map_or(origin.to_owned(), |(node, _)| node.to_owned())
        };
        let mut on_host: HashSet<String> =
            shader.host.members.iter().map(|member| node_of(&member.origin)).collect();
        on_host.extend(driving(typed));
        let mut nodes = Self {
            total: typed.order.len(),
            removed_within: shader.removed_within.clone(),
            loops: shader.loops.iter().map(LoopReport::of).collect(),
            ..Self::default()
        };
        for node in typed.order.iter().map(|&index| &typed.nodes[index]) {
            let path = node.path.to_string();
            if emitted.contains(&node.path) {
                nodes.fragment.push(path);
            } else if on_host.contains(path.as_str()) {
                nodes.host.push(path);
            } else if let Some(removal) =
                removed.get(&node.path).filter(|removal| removal.proof != Proof::Constant)
            {
                nodes.removed.push((*removal).clone());
            } else {
                nodes.folded.push(path);
            }
        }
        nodes
    }
}
