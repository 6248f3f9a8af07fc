//! Variants of looks: every module of every look that is wanted, compiled.
//!
//! One look is compiled in several variants where objects set its words, where it is cut out by
//! alpha, or where different lights are dark for the objects that wear it; but not in more variants
//! than a few, whatever the number of objects.

use std::borrow::Cow;
use std::collections::hash_map::Entry;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use super::DroppedEffect;
use super::key::{SurfaceVariant, content_key, drawing_key, variant_key};
use super::omissions::{push_lights, push_node_links};
use super::placement::{PlacedScene, VisibleObject, values_key};
use super::planner::Planner;
use crate::compile::{AovSource, CompileOptions, CompiledShader, Live, Loops, compile};
use crate::diag::Diagnostic;
use crate::document::{LightInput, Look};
use crate::frame::keys::{ParamTable, Rig};
use crate::frame::links::unlit;
use crate::frame::setup::{SetupLook, SetupObject};
use crate::frame::visibility::{CullMode, dark_lights, inputs_of};
use crate::ids::LightId;
use crate::library::{Library, Stage};

/// Sets of dark lights for which one look is compiled, at most.
const MOST_DARK_SETS: usize = 4;

/// Inputs from dark lights that are known, with the reasons.
pub(super) type DarkLights = Vec<((LightId, LightInput), Cow<'static, str>)>;

/// The variants of looks that objects wear, by the object's number and the look's.
pub(super) type Variants = HashMap<(usize, usize), LookVariant>;

/// A variant of a look, as an object wears it.
pub(super) struct LookVariant {
    /// Key under which the variant's modules are kept.
    pub(super) key: u64,
    surface: SurfaceVariant,
    /// Inputs from dark lights that are known.
    dark: BTreeSet<(LightId, LightInput)>,
}

/// A variant's modules, compiled when first asked for.
#[derive(Clone, Debug)]
pub(super) struct LookShaders {
    pub(super) draw: Arc<CompiledShader>,
    /// The modules of passes before the look.
    pub(super) before: HashMap<Stage, Arc<CompiledShader>>,
    pub(super) rig: Rig,
    /// Warnings about the look's nodes and keys.
    pub(super) warnings: Vec<Diagnostic>,
    /// Tables of the parameters that each module reads.
    pub(super) tables: HashMap<Stage, ParamTable>,
}

impl LookShaders {
    /// The look's own module with its keys.
    pub(super) fn new(draw: Arc<CompiledShader>, rig: Rig, warnings: Vec<Diagnostic>) -> Self {
        let tables = HashMap::from([(draw.stage, ParamTable::new(&draw.params))]);
        Self { draw, before: HashMap::new(), rig, warnings, tables }
    }
}

impl Planner {
    /// Compiles the looks that visible objects wear, and drops looks that only other objects wore.
    pub(super) fn compile_looks(
        &mut self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        dropped: &mut Vec<DroppedEffect>,
    ) -> Result<Variants, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let mut variants = Variants::new();
        let mut contents = ContentKeys::default();
        let mut told = HashSet::new();
        let mut all_dark = self.dark(scene, visible);
        for &VisibleObject { number, object } in visible {
            for &index in object.looks.iter().flatten() {
                if variants.contains_key(&(number, index)) {
                    continue;
                }
                let look = &scene.setup.looks[index];
                let now = scene.worn(index, object);
                let live = &scene.lives[index];
                let dark = all_dark.remove(&(number, index)).unwrap_or_default();
                let (surface, known) = (surface_of(object, index), inputs_of(&dark));
                let own = matches!(now, Cow::Owned(_)).then_some(object);
                let content = contents.get(index, &now, live, own);
                let aovs: Vec<AovSource> =
                    self.aovs.iter().map(|asked| asked.source(index)).collect();
                let key = variant_key(content, surface, &known);
                let key = drawing_key(key, &aovs, self.mattes);
                let variant = LookVariant { key, surface, dark: known };
                if !self.shaders.contains_key(&key) {
                    match self.compile_look(look, &now, scene.library, (live, &variant, aovs)) {
                        Ok(shaders) => drop(self.shaders.insert(key, shaders)),
                        Err(found) => problems.extend(found),
                    }
                }
                if let Some(shaders) = self.shaders.get(&key)
                    && !told.contains(&(index, key, dark.clone()))
                {
                    push_lights(dropped, &now, shaders, &dark);
                    push_node_links(dropped, &now, scene.library);
                    told.insert((index, key, dark));
                }
                variants.insert((number, index), variant);
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        self.used = variants.values().map(|variant| variant.key).collect();
        Ok(variants)
    }

    /// Compiles the modules of the passes before the looks.
    pub(super) fn compile_before(
        &mut self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        variants: &Variants,
        stages: &[Stage],
    ) -> Result<(), Vec<Diagnostic>> {
        let mut problems = Vec::new();
        for &VisibleObject { number, object } in visible {
            for index in object.worn_looks() {
                let Some(variant) = variants.get(&(number, index)) else { continue };
                let known = self.shaders.get(&variant.key).map(|shaders| &shaders.before);
                let is_known = |stage| known.is_some_and(|known| known.contains_key(stage));
                if stages.iter().all(is_known) {
                    continue;
                }
                let look = &scene.setup.looks[index];
                let now = scene.worn(index, object);
                for &stage in stages {
                    let options =
                        CompileOptions { stage, ..self.options(&scene.lives[index], variant) };
                    let Some(shaders) = self.shaders.get_mut(&variant.key) else { continue };
                    if shaders.before.contains_key(&stage) {
                        continue;
                    }
                    match compile(&now, scene.library, &options) {
                        Ok(compiled) => {
                            let shader = compiled.value;
                            shaders.tables.insert(stage, ParamTable::new(&shader.params));
                            shaders.before.insert(stage, Arc::new(shader));
                        }
                        Err(found) => problems.extend(located(look, found)),
                    }
                }
            }
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }

    /// Inputs from lights that are dark for an object that wears a look, by the object's number and
    /// the look's. Where different lights are dark for many objects of one look, only what is dark
    /// for all of them counts, so that the look is not compiled for each.
    fn dark(
        &self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
    ) -> HashMap<(usize, usize), DarkLights> {
        let mut dark: HashMap<(usize, usize), DarkLights> = HashMap::new();
        let mut sets: HashMap<usize, HashSet<BTreeSet<(LightId, LightInput)>>> = HashMap::new();
        for &VisibleObject { number, object } in visible {
            for &index in object.looks.iter().flatten() {
                // Values that may be edited at any time are never assumed to stay as they are.
                if self.cull != CullMode::All
                    || !matches!(scene.lives[index], Live::Keyed | Live::Exposed)
                {
                    continue;
                }
                let Entry::Vacant(slot) = dark.entry((number, index)) else { continue };
                let look = scene.worn(index, object);
                let (setup, lights) = (scene.setup, scene.lights(index));
                let placed = (&scene.placed[number], object);
                let unlit = unlit(setup, &scene.mix, object);
                let found =
                    dark_lights((setup, &scene.aims), &look, &lights, placed, &scene.view, &unlit);
                let found = slot.insert(found);
                sets.entry(index).or_default().insert(inputs_of(found));
            }
        }
        sets.retain(|_, sets| sets.len() > MOST_DARK_SETS);
        let common: HashMap<usize, BTreeSet<(LightId, LightInput)>> = sets
            .into_iter()
            .filter_map(|(look, sets)| {
                let common = sets.into_iter().reduce(|common, set| &common & &set)?;
                Some((look, common))
            })
            .collect();
        for ((_, look), dark) in &mut dark {
            if let Some(common) = common.get(look) {
                dark.retain(|(input, _)| common.contains(input));
            }
        }
        dark
    }

    fn compile_look(
        &self,
        setup: &SetupLook,
        look: &Look,
        library: &Library,
        (live, variant, aovs): (&Live, &LookVariant, Vec<AovSource>),
    ) -> Result<LookShaders, Vec<Diagnostic>> {
        let mut options = CompileOptions { display: true, ..self.options(live, variant) };
        options.mattes = self.mattes;
        if !aovs.is_empty() {
            // What comes of one light can only be told from that of others where each has code of
            // its own.
            options.loops = Loops::Never;
            options.aovs = aovs;
        }
        let compiled = compile(look, library, &options).map_err(|found| located(setup, found))?;
        let (rig, mut warnings) = Rig::new(look).into_parts();
        let draw = compiled.tell(&mut warnings);
        Ok(LookShaders::new(Arc::new(draw), rig, located(setup, warnings)))
    }

    fn options(&self, live: &Live, variant: &LookVariant) -> CompileOptions {
        CompileOptions {
            live: live.clone(),
            cutout: variant.surface.cutout,
            deformed: variant.surface.deformed,
            dark: variant.dark.clone(),
            unspecialized: self.unspecialized,
            loops: self.loops,
            ..CompileOptions::default()
        }
    }
}

/// Hashes of looks' contents, each computed once for a picture.
#[derive(Default)]
struct ContentKeys(HashMap<(usize, String), u64>);

impl ContentKeys {
    /// The hash of the look of that number in the state `now`, which objects like `own` wear where
    /// these change it; others leave the look as it is.
    fn get(&mut self, look: usize, now: &Look, live: &Live, own: Option<&SetupObject>) -> u64 {
        let own = own.map(|object| format!("{}{:?}", values_key(&object.values), object.layers));
        *self.0.entry((look, own.unwrap_or_default())).or_insert_with(|| content_key(now, live))
    }
}

/// The problems, with their places in the look's document.
fn located(look: &SetupLook, mut problems: Vec<Diagnostic>) -> Vec<Diagnostic> {
    look.source.locate_all(&mut problems);
    problems
}

/// The surface that an object gives to a look.
fn surface_of(object: &SetupObject, look: usize) -> SurfaceVariant {
    let mut parts = object.mesh.parts.iter().zip(&object.looks);
    SurfaceVariant {
        cutout: parts.any(|(part, worn)| *worn == Some(look) && part.alpha_cutoff.is_some()),
        deformed: object.mesh.is_deformed(),
    }
}
