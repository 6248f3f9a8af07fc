//! Variants of looks: every module of every look that is wanted, compiled.
//!
//! One look is compiled in several variants where objects set its words, where it is cut out by
//! alpha, or where different lights are dark for the objects that wear it.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use super::DroppedEffect;
use super::key::look_key;
use super::omissions::push_lights;
use super::placement::{PlacedScene, VisibleObject};
use super::planner::Planner;
use crate::compile::{CompileOptions, CompiledShader, Live, compile};
use crate::diag::Diagnostic;
use crate::document::{LightField, Look};
use crate::frame::keys::{ParamTable, Rig, structural_look};
use crate::frame::setup::{SetupLook, SetupObject};
use crate::frame::visibility::{CullMode, dark_lights, fields};
use crate::ids::LightId;
use crate::library::{Library, Stage};

/// Fields of lights that are 0, with the reasons.
pub(super) type DarkLights = Vec<((LightId, LightField), &'static str)>;

/// The variants of looks that objects wear, by the object's number and the look's.
pub(super) type Variants = HashMap<(usize, usize), LookVariant>;

/// A variant of a look, as an object wears it.
pub(super) struct LookVariant {
    /// Key under which the variant's modules are kept.
    pub(super) key: u64,
    /// True if a part of the object is cut out by alpha.
    cutout: bool,
    /// Fields of lights that are known to be 0.
    dark: BTreeSet<(LightId, LightField)>,
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
        for &VisibleObject { number, object } in visible {
            for &index in object.looks.iter().flatten() {
                if variants.contains_key(&(number, index)) {
                    continue;
                }
                let look = &scene.setup.looks[index];
                let now = structural_look(&look.look, scene.options.time, &object.values);
                let live = &scene.lives[index];
                let dark = self.dark(scene, number, index, &now);
                let (cutout, fields) = (has_cutout(object, index), fields(&dark));
                let key = look_key(&now, live, cutout, &fields);
                let variant = LookVariant { key, cutout, dark: fields };
                if !self.shaders.contains_key(&key) {
                    match self.compile_look(look, &now, scene.library, (live, &variant)) {
                        Ok(shaders) => drop(self.shaders.insert(key, shaders)),
                        Err(found) => problems.extend(found),
                    }
                }
                if let Some(shaders) = self.shaders.get(&key) {
                    push_lights(dropped, &now, shaders, &dark);
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
                let look = &scene.setup.looks[index];
                let now = structural_look(&look.look, scene.options.time, &object.values);
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

    /// Fields of lights that are 0 for an object that wears a look, by the object's number and the
    /// look's.
    fn dark(
        &self,
        scene: &PlacedScene<'_>,
        object: usize,
        index: usize,
        look: &Look,
    ) -> DarkLights {
        // Values that may be edited at any time are never assumed to stay as they are.
        if self.cull != CullMode::All || !matches!(scene.lives[index], Live::Keyed | Live::Exposed)
        {
            return Vec::new();
        }
        let lights = scene.lights(index);
        dark_lights(scene.setup, look, &lights, &scene.placed[object], &scene.view)
    }

    fn compile_look(
        &self,
        setup: &SetupLook,
        look: &Look,
        library: &Library,
        (live, variant): (&Live, &LookVariant),
    ) -> Result<LookShaders, Vec<Diagnostic>> {
        let options = CompileOptions { display: true, ..self.options(live, variant) };
        let compiled = compile(look, library, &options).map_err(|found| located(setup, found))?;
        let (rig, mut warnings) = Rig::new(look).into_parts();
        let draw = compiled.tell(&mut warnings);
        Ok(LookShaders::new(Arc::new(draw), rig, located(setup, warnings)))
    }

    fn options(&self, live: &Live, variant: &LookVariant) -> CompileOptions {
        CompileOptions {
            live: live.clone(),
            cutout: variant.cutout,
            dark: variant.dark.clone(),
            unspecialized: self.unspecialized,
            ..CompileOptions::default()
        }
    }
}

/// The problems, with their places in the look's document.
fn located(look: &SetupLook, mut problems: Vec<Diagnostic>) -> Vec<Diagnostic> {
    look.source.locate_all(&mut problems);
    problems
}

/// True if a part of the object that wears this look is cut out by alpha.
fn has_cutout(object: &SetupObject, look: usize) -> bool {
    object
        .mesh
        .parts
        .iter()
        .zip(&object.looks)
        .any(|(part, worn)| *worn == Some(look) && part.alpha_cutoff.is_some())
}
