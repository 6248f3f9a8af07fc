//! Passes that run before the picture, and the reasons for them.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use super::omissions::quoted;
use super::placement::{PlacedScene, VisibleObject};
use super::variants::{LookShaders, Variants};
use super::{Draw, DroppedEffect, Pass, PlanOptions};
use crate::compile::Proof;
use crate::frame::camera::View;
use crate::frame::cost::{self, EffectCost};
use crate::frame::effects::EffectKind;
use crate::library::{Context, PassId, Stage};

/// Passes that are wanted, in the order of their table, with the reasons.
pub(super) struct WantedPasses(BTreeMap<PassId, String>);

/// Looks as visible objects wear them: the first that reads a context is the reason for the
/// context's pass.
pub(super) struct ContextReaders<'a> {
    pub(super) scene: &'a PlacedScene<'a>,
    pub(super) visible: &'a [VisibleObject<'a>],
    pub(super) variants: &'a Variants,
    pub(super) shaders: &'a std::collections::HashMap<u64, LookShaders>,
}

impl ContextReaders<'_> {
    /// The reason why a context is wanted, if any look reads it; `what` is the context's name for
    /// people.
    fn reason(&self, context: Context, what: &str) -> Option<String> {
        self.visible.iter().find_map(|VisibleObject { number, object }| {
            let reads = |look: usize| {
                let variant = self.variants.get(&(*number, look))?;
                let shaders = self.shaders.get(&variant.key)?;
                shaders.draw.needs.context(context).then_some(look)
            };
            let look = object.looks.iter().flatten().find_map(|look| reads(*look))?;
            let name = &self.scene.setup.looks[look].look.name;
            Some(format!("object `{}` wears {}, which reads {what}", object.id, quoted(name)))
        })
    }
}

impl WantedPasses {
    /// The passes that `readers` read, and those that they are made from. Looks of different tiers
    /// may want curvature in different ways, side by side.
    pub(super) fn new(readers: &ContextReaders<'_>) -> Self {
        let mut wanted = BTreeMap::from([(PassId::LOOK, "it is the picture".to_owned())]);
        // Passes are visited from the last to the first, so that the readers of a pass are known
        // before it.
        for pass in PassId::all().rev() {
            let mut served = Context::all().filter(|context| context.pass() == Some(pass));
            let own = served.find_map(|context| readers.reason(context, pass.row().purpose));
            let of_reader = || {
                let (reader, reason) = wanted.iter().find(|(reader, _)| reader.reads(pass))?;
                Some(if pass.is_screen() {
                    reason.clone()
                } else {
                    format!("{} computed from them: {reason}", reader.row().result)
                })
            };
            if let Some(reason) = own.or_else(of_reader) {
                wanted.entry(pass).or_insert(reason);
            }
        }
        Self(wanted)
    }

    /// The stages of looks' modules that passes before the picture draw.
    pub(super) fn stages_before(&self) -> Vec<Stage> {
        self.0
            .keys()
            .filter(|pass| !pass.writes_picture())
            .filter_map(|pass| pass.stage())
            .collect()
    }

    /// Lists the passes over meshes that are not wanted, with everything that would be made from
    /// them.
    pub(super) fn push_unwanted(&self, dropped: &mut Vec<DroppedEffect>, options: &PlanOptions) {
        let unwanted = PassId::all().filter(|pass| !pass.is_screen() && !self.0.contains_key(pass));
        dropped.extend(unwanted.map(|pass| DroppedEffect {
            what: pass.row().purpose.to_owned(),
            why: "no live node of a visible object reads it".to_owned(),
            kind: EffectKind::Pass,
            proof: Proof::Unreachable,
            look: None,
            cost: unwanted_cost(pass, options),
        }));
    }

    /// The passes in order, each with the hash of everything that it reads.
    pub(super) fn planned(self, draws: &[Draw], view: &View, options: &PlanOptions) -> Vec<Pass> {
        let mut passes: Vec<Pass> = Vec::with_capacity(self.0.len());
        for (id, reason) in self.0 {
            let mut hasher = DefaultHasher::new();
            if let Some(stage) = id.stage() {
                hash_of(draws, view, options, stage).hash(&mut hasher);
            }
            // The picture reads the results of all passes before it, whichever they are.
            let is_read = |before: &&Pass| id.writes_picture() || id.reads(before.id);
            let read = passes.iter().filter(is_read);
            read.for_each(|before| (before.id, before.input_hash).hash(&mut hasher));
            passes.push(Pass { id, reason, input_hash: hasher.finish() });
        }
        passes
    }
}

/// The memory that a pass and the first pass that reads it would hold.
fn unwanted_cost(pass: PassId, options: &PlanOptions) -> EffectCost {
    let reader = PassId::all().find(|reader| reader.reads(pass));
    cost::of_passes(std::iter::once(pass).chain(reader), options)
}

/// The hash of everything that decides on what a pass over meshes draws.
fn hash_of(draws: &[Draw], view: &View, options: &PlanOptions, stage: Stage) -> u64 {
    let mut hasher = DefaultHasher::new();
    (options.size, options.samples, view.uniform_bytes()).hash(&mut hasher);
    for draw in draws {
        let Some(shader) = draw.module(stage) else { continue };
        (Arc::as_ptr(&draw.mesh) as usize, &draw.indices, &shader.wgsl, &draw.object_uniform.bytes)
            .hash(&mut hasher);
        let uniform = draw.look_uniforms.get(&stage).map(|uniform| &uniform.bytes);
        (uniform, draw.two_sided, draw.is_mirrored).hash(&mut hasher);
        draw.images_of(stage).iter().for_each(|image| image.hash.hash(&mut hasher));
    }
    hasher.finish()
}
