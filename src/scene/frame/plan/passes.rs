//! Passes that run before the picture, and the reasons for them.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use chiaro_locale::tr;

use super::omissions::quoted;
use super::placement::{PlacedScene, VisibleObject};
use super::variants::{LookShaders, Variants};
use super::{Draw, DroppedEffect, Pass, PlanOptions};
use crate::compile::{CompiledShader, Proof};
use crate::frame::camera::View;
use crate::frame::casters::Casters;
use crate::frame::cost::{self, EffectCost};
use crate::frame::effects::EffectKind;
use crate::frame::screen::Ink;
use crate::frame::shadow_maps::ShadowMaps;
use crate::ids::ObjectId;
use crate::library::{Context, PassId, Stage};

/// Passes that are wanted, in the order of their table, with the reasons.
pub(super) struct WantedPasses(BTreeMap<PassId, String>);

/// Looks as visible objects wear them: the first that reads a context is the reason for the
/// context's pass.
pub(super) struct ContextReaders<'a> {
    scene: &'a PlacedScene<'a>,
    /// The first object that wears each variant of a look, and the look's number.
    first_wearers: Vec<(&'a ObjectId, usize, &'a LookShaders)>,
}

impl<'a> ContextReaders<'a> {
    /// The variants that visible objects wear.
    pub(super) fn new(
        scene: &'a PlacedScene<'a>,
        visible: &[VisibleObject<'a>],
        variants: &Variants,
        shaders: &'a HashMap<u64, LookShaders>,
    ) -> Self {
        let mut seen = HashSet::new();
        let mut first_wearers = Vec::new();
        for VisibleObject { number, object } in visible {
            for &look in object.looks.iter().flatten() {
                let Some(variant) = variants.get(&(*number, look)) else { continue };
                let is_first = seen.insert((look, variant.key));
                if let (true, Some(shaders)) = (is_first, shaders.get(&variant.key)) {
                    first_wearers.push((&object.id, look, shaders));
                }
            }
        }
        Self { scene, first_wearers }
    }

    /// The reason why a context is wanted, if any look reads it; `what` is the context's name for
    /// people.
    fn reason(&self, context: Context, what: &str) -> Option<String> {
        let reads = |(_, _, shaders): &&(_, _, &LookShaders)| shaders.draw.needs.context(context);
        let (object, look, _) = self.first_wearers.iter().find(reads)?;
        let name = &self.scene.setup.looks[*look].look.name;
        Some(tr!("object `{object}` wears {look}, which reads {what}", look = quoted(name)))
    }
}

/// Everything beside draws that passes over meshes read.
pub(super) struct SceneSeen<'a> {
    pub(super) view: &'a View,
    pub(super) casters: Option<&'a Casters>,
    pub(super) shadow_maps: Option<&'a ShadowMaps>,
    pub(super) ink: Option<Ink>,
    /// Color behind everything.
    pub(super) backdrop: Option<[f64; 4]>,
}

impl WantedPasses {
    /// The passes that `readers` read, and those that they are made from. Looks of different tiers
    /// may want curvature in different ways, side by side. `has_ink` if the scene draws lines.
    pub(super) fn new(readers: &ContextReaders<'_>, has_ink: bool) -> Self {
        let mut wanted = BTreeMap::from([(PassId::LOOK, tr!("it is the picture").to_owned())]);
        if has_ink {
            wanted.insert(PassId::OUTLINES, tr!("the scene draws outlines").to_owned());
        }
        // Passes are visited from the last to the first, so that the readers of a pass are known
        // before it.
        for pass in PassId::all().rev() {
            let mut served = Context::all().filter(|context| context.pass() == Some(pass));
            let own = served.find_map(|context| readers.reason(context, pass.row().purpose.tr()));
            let of_reader = || {
                let (reader, reason) = wanted.iter().find(|(reader, _)| reader.reads(pass))?;
                Some(if pass.stage().is_none() {
                    reason.clone()
                } else {
                    tr!("{result} computed from them: {reason}", result = reader.row().result)
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

    /// True if any of them draws what lights see.
    pub(super) fn of_lights(&self) -> bool {
        self.0.keys().any(|pass| pass.is_of_lights())
    }

    /// Lists the passes over meshes that are not wanted, with everything that would be made from
    /// them.
    pub(super) fn push_unwanted(&self, dropped: &mut Vec<DroppedEffect>, options: &PlanOptions) {
        let is_first = |pass: &PassId| !pass.is_screen() && pass.row().reads.is_empty();
        let unwanted = PassId::all().filter(|pass| is_first(pass) && !self.0.contains_key(pass));
        dropped.extend(unwanted.map(|pass| DroppedEffect {
            what: pass.row().purpose.tr().to_owned(),
            why: tr!("no live node of a visible object reads it").to_owned(),
            kind: EffectKind::Pass,
            proof: Proof::Unreachable,
            look: None,
            cost: unwanted_cost(pass, options),
        }));
    }

    /// The passes in order, each with the hash of everything that it reads.
    pub(super) fn planned(
        self,
        draws: &[Draw],
        seen: &SceneSeen<'_>,
        options: &PlanOptions,
    ) -> Vec<Pass> {
        let mut passes: Vec<Pass> = Vec::with_capacity(self.0.len());
        for (id, reason) in self.0 {
            let mut hasher = DefaultHasher::new();
            if let Some(stage) = id.stage() {
                hash_of(draws, seen.view, options, stage).hash(&mut hasher);
                let modules = draws.iter().filter_map(|draw| draw.module(stage));
                if let Some(casters) = seen.casters.filter(|_| reads_casters(modules)) {
                    casters.hash().hash(&mut hasher);
                }
            }
            if let Some(maps) = seen.shadow_maps.filter(|_| id.is_of_lights()) {
                maps.hash().hash(&mut hasher);
            }
            if let Some(ink) = seen.ink.filter(|_| id.is_over()) {
                let numbers = ink.color.iter().chain(&ink.widths);
                numbers.for_each(|number| number.to_bits().hash(&mut hasher));
            }
            if let Some(backdrop) = seen.backdrop.filter(|_| id.writes_picture()) {
                backdrop.map(f64::to_bits).hash(&mut hasher);
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

/// True if any of the modules reads the triangles that cast shadows.
fn reads_casters<'a>(mut modules: impl Iterator<Item = &'a Arc<CompiledShader>>) -> bool {
    modules.any(|shader| shader.needs.casters())
}

/// The hash of everything that decides on what a pass over meshes draws.
fn hash_of(draws: &[Draw], view: &View, options: &PlanOptions, stage: Stage) -> u64 {
    let mut hasher = DefaultHasher::new();
    (options.size, options.samples, view.uniform_bytes()).hash(&mut hasher);
    // Each module is hashed once, and then counts by its number.
    let mut modules: HashMap<*const CompiledShader, usize> = HashMap::new();
    for draw in draws {
        let Some(shader) = draw.module(stage) else { continue };
        let next = modules.len();
        let module = *modules.entry(Arc::as_ptr(shader)).or_insert_with(|| {
            shader.wgsl.hash(&mut hasher);
            next
        });
        (Arc::as_ptr(&draw.mesh) as usize, &draw.indices, module, &draw.object_uniform.bytes)
            .hash(&mut hasher);
        let uniform = draw.look_uniforms.get(&stage).map(|uniform| &uniform.bytes);
        (uniform, draw.two_sided, draw.is_mirrored).hash(&mut hasher);
        draw.images_of(stage).iter().for_each(|image| image.hash.hash(&mut hasher));
    }
    hasher.finish()
}
