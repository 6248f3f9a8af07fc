//! Effects: everything that a picture may cost, each with its state, the reason and the proof.
//! `chiaro explain` prints them.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use serde::Serialize;

use super::cost::{EffectCost, attribute_bytes, pass_operations, shader_operations};
use super::plan::{Draw, FramePlan};
use crate::compile::{BindingKind, CompiledShader, Proof, StructLayout, VertexAttribute};
use crate::library::{PassId, Type};

/// Kind of an effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EffectKind {
    /// A pass: GPU work of its own.
    Pass,
    /// An object of the scene.
    Object,
    /// A look: its modules and pipelines.
    Look,
    /// A light of a look, with its uniforms.
    Light,
    /// A vertex attribute of a look's meshes.
    Attribute,
    /// An image with its sampler.
    Texture,
    /// Triangles that cast shadows.
    Casters,
    /// Values that a look reads from uniforms.
    Uniforms,
    /// A node of a look.
    Node,
}

/// State of an effect in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EffectState {
    /// The effect is done for this picture.
    Runs,
    /// The effect was done for an earlier picture and is still valid.
    Cached,
    /// The effect is not done.
    Dropped,
}

/// An effect: a part of the work that a picture may cost.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Effect {
    /// Name of the effect.
    pub what: String,
    /// Kind of the effect.
    pub kind: EffectKind,
    /// State of the effect.
    pub state: EffectState,
    /// Cost of the effect; for a dropped effect, the cost that it would have, as far as known.
    pub cost: EffectCost,
    /// Reason for the state: the end of a sentence that begins with the effect.
    pub reason: String,
    /// Proof that nothing is lost without the effect; `None` for effects that run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<Proof>,
    /// Name of the look that the effect belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub look: Option<String>,
    /// Path of the node, for an effect of one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node: Option<String>,
    /// Pass, for an effect that is one.
    #[serde(skip)]
    pub pass: Option<PassId>,
}

impl Effect {
    fn runs(what: impl Into<String>, kind: EffectKind, reason: impl Into<String>) -> Self {
        let (what, reason) = (what.into(), reason.into());
        let cost = EffectCost::default();
        Self {
            what,
            kind,
            state: EffectState::Runs,
            cost,
            reason,
            proof: None,
            look: None,
            node: None,
            pass: None,
        }
    }

    fn dropped(
        what: impl Into<String>,
        kind: EffectKind,
        reason: impl Into<String>,
        proof: Proof,
    ) -> Self {
        Self { state: EffectState::Dropped, proof: Some(proof), ..Self::runs(what, kind, reason) }
    }

    fn costs(self, cost: EffectCost) -> Self {
        Self { cost, ..self }
    }

    fn of(self, look: &str) -> Self {
        Self { look: Some(look.to_owned()), ..self }
    }
}

/// All effects of a plan. `done` is the input hash of each pass whose result a renderer still
/// holds, so that a pass that would not run again shows as cached.
pub fn effects(plan: &FramePlan, done: &HashMap<PassId, u64>) -> Vec<Effect> {
    let mut effects: Vec<Effect> = Vec::new();
    let pixels = u64::from(plan.size[0]) * u64::from(plan.size[1]);
    for pass in &plan.passes {
        let mut effect = Effect::runs(pass.id.title(), EffectKind::Pass, &pass.reason);
        effect.pass = Some(pass.id);
        effect.cost.operations = pass_operations(pass.id, &plan.draws);
        effect.cost.bytes = pass.id.row().bytes_per_pixel(plan.samples).0 * pixels;
        if let Some(maps) = plan.shadow_maps.as_ref().filter(|_| pass.id.is_of_lights()) {
            let [layers, triangles] = maps.counts();
            let texel = u64::from(4 * u32::BITS / 8);
            effect.cost.bytes = texel * u64::from(maps.side).pow(2) * layers;
            let layers = trn!(layers, "{layers} layer", "{layers} layers");
            let triangles = trn!(triangles, "{triangles} triangle", "{triangles} triangles");
            let side = maps.side;
            effect.reason += &tr!(", in {layers} of {side}x{side} with {triangles}");
        }
        if done.get(&pass.id) == Some(&pass.input_hash) {
            effect.state = EffectState::Cached;
            effect.proof = Some(Proof::Unchanged);
        }
        effects.push(effect);
    }
    for dropped in &plan.dropped {
        let mut effect = Effect::dropped(&dropped.what, dropped.kind, &dropped.why, dropped.proof)
            .costs(dropped.cost);
        effect.look.clone_from(&dropped.look);
        effects.push(effect);
    }
    effects.extend(casters(plan));
    let mut seen = HashSet::new();
    for draw in &plan.draws {
        if seen.insert(draw.object.clone()) {
            let reason = tr!(
                "some of it may be seen: {count} triangles",
                count = draw.mesh.indices.len() / 3
            );
            let cost = EffectCost::bytes(
                4 * draw.mesh.indices.len() as u64 + draw.object_uniform.bytes.len() as u64,
            );
            effects.push(
                Effect::runs(
                    tr!("object `{object}`", object = draw.object),
                    EffectKind::Object,
                    reason,
                )
                .costs(cost),
            );
        }
    }
    let mut looks: Vec<(&Arc<CompiledShader>, &Draw)> = Vec::new();
    for draw in &plan.draws {
        if !looks.iter().any(|(known, _)| Arc::ptr_eq(known, &draw.look)) {
            looks.push((&draw.look, draw));
        }
    }
    for (shader, draw) in looks {
        push_look(&mut effects, shader, draw);
    }
    effects
}

/// The triangles that cast shadows, where a look reads them.
fn casters(plan: &FramePlan) -> Option<Effect> {
    let casters = plan.casters.as_ref().filter(|casters| !casters.trees().is_empty())?;
    let reads = |draw: &&Draw| draw.modules().any(|module| module.needs.casters());
    let draw = plan.draws.iter().find(reads)?;
    let triangles = casters.trees().iter().map(|tree| u64::from(tree.triangles));
    let (triangles, trees): (u64, _) = (triangles.sum(), casters.trees().len());
    let reason = tr!(
        "object `{object}` wears {look}, which sends rays past {triangles} in {trees}",
        object = draw.object,
        look = if draw.look_name.is_empty() { tr!("a look") } else { &draw.look_name },
        triangles = trn!(triangles, "{triangles} triangle", "{triangles} triangles"),
        trees = trn!(trees, "{trees} tree", "{trees} trees")
    );
    let [width, height] = casters.size().map(u64::from);
    let cost = EffectCost::bytes(16 * width * height);
    Some(Effect::runs(tr!("shadow casters"), EffectKind::Casters, reason).costs(cost))
}

fn push_look(effects: &mut Vec<Effect>, shader: &CompiledShader, draw: &Draw) {
    let name = draw.look_name.as_str();
    let mut push = |effect: Effect| effects.push(effect.of(name));
    let modules = draw.modules().count();
    let what = if name.is_empty() { tr!("a look") } else { name };
    let reason = trn!(
        modules,
        "object `{object}` wears it; it is compiled to {modules} module",
        "object `{object}` wears it; it is compiled to {modules} modules",
        object = &draw.object
    );
    let (operations, of_nodes) = shader_operations(shader);
    let cost = EffectCost::operations(operations);
    push(Effect::runs(what, EffectKind::Look, reason).costs(cost));
    push_lights(&mut push, shader);
    let read = read_attributes(shader, draw);
    let is_there = |attribute: &VertexAttribute| {
        *attribute != VertexAttribute::Rest || draw.mesh.is_deformed()
    };
    for attribute in VertexAttribute::ALL.into_iter().filter(is_there) {
        let what = tr!("vertex {attribute}", attribute = attribute.name());
        let cost = EffectCost::bytes(attribute_bytes(attribute) * draw.mesh.positions.len() as u64);
        push(match read.get(&attribute) {
            Some(stage) => {
                Effect::runs(what, EffectKind::Attribute, tr!("the {stage} module reads it"))
                    .costs(cost)
            }
            None => {
                let reason = tr!("no live node reads it, so that it is neither uploaded nor bound");
                Effect::dropped(what, EffectKind::Attribute, reason, Proof::Unreachable).costs(cost)
            }
        });
    }
    let is_bound = |index: usize| {
        draw.modules()
            .flat_map(|module| &module.bindings)
            .any(|binding| binding.kind == BindingKind::Image(index))
    };
    for (index, image) in shader.named_images.iter().enumerate() {
        let what =
            if image.path.is_empty() { tr!("an image that is not chosen") } else { &image.path };
        let mut effect = if is_bound(index) {
            let read = draw.images.get(index).map_or(0, |image| image.bytes.len() as u64);
            let reason = tr!("`{node}` reads it", node = image.node);
            Effect::runs(what, EffectKind::Texture, reason).costs(EffectCost::bytes(read))
        } else {
            let reason = tr!(
                "nothing that is seen reads `{node}`, so that it is not even loaded",
                node = image.node
            );
            Effect::dropped(what, EffectKind::Texture, reason, Proof::Unreachable)
        };
        effect.node = Some(image.node.to_string());
        push(effect);
    }
    let bytes = u64::from(shader.host.size);
    push(if bytes > 0 {
        let reason = tr!("values that are known before the fragment");
        Effect::runs(tr!("uniforms of the look"), EffectKind::Uniforms, reason)
            .costs(EffectCost::bytes(bytes))
    } else {
        let reason = tr!("everything is known when the look is compiled, or at each fragment");
        Effect::dropped(tr!("uniforms of the look"), EffectKind::Uniforms, reason, Proof::Constant)
    });
    for (path, operations) in of_nodes {
        let what = tr!("node `{path}`");
        let effect = Effect::runs(what, EffectKind::Node, tr!("it runs at each fragment"));
        let effect = effect.costs(EffectCost::operations(operations));
        push(Effect { node: Some(path), ..effect });
    }
    for removal in &shader.removed {
        let path = removal.path.to_string();
        let effect =
            Effect::dropped(tr!("node `{path}`"), EffectKind::Node, &removal.reason, removal.proof)
                .costs(EffectCost::operations(removal.operations));
        push(Effect { node: Some(path), ..effect });
    }
}

/// Lists the lights that a module reads, each once.
fn push_lights(push: &mut impl FnMut(Effect), shader: &CompiledShader) {
    let has_uniforms = shader.host.members.iter().any(|member| member.ty == Type::Light);
    let layout = StructLayout::of(&shader.valid.module, "Light").filter(|_| has_uniforms);
    let cost = EffectCost::bytes(layout.map_or(0, |layout| u64::from(layout.size)));
    let reason = if has_uniforms {
        tr!("its uniforms are read at each fragment")
    } else {
        tr!("uniforms are computed from it")
    };
    let mut seen = HashSet::new();
    for light in shader.host.lights().filter(|light| seen.insert(*light)) {
        push(Effect::runs(tr!("light `{light}`"), EffectKind::Light, reason).costs(cost));
    }
}

/// The attributes that a draw's modules read, each with the first module that reads it.
fn read_attributes(
    shader: &CompiledShader,
    draw: &Draw,
) -> BTreeMap<VertexAttribute, &'static str> {
    let mut read = BTreeMap::new();
    for attribute in shader.needs.attributes() {
        read.insert(attribute, "look's");
    }
    for (stage, module) in &draw.before {
        let label = PassId::of_stage(*stage).map_or("", PassId::label);
        for attribute in module.needs.attributes() {
            read.entry(attribute).or_insert(label);
        }
    }
    read
}
