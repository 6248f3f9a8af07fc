//! Makes frame plans.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use super::key::look_key;
use super::omissions::push_equal_looks;
use super::passes::{ContextReaders, WantedPasses};
use super::variants::LookShaders;
use super::{FramePlan, PlanOptions};
use crate::compile::{CompiledShader, Live};
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::frame::assets::Assets;
use crate::frame::keys::Rig;
use crate::frame::setup::Setup;
use crate::frame::visibility::{Cull, KnownBounds};
use crate::ids::NodePath;
use crate::library::Library;

/// Makes frame plans, keeping what was compiled and read.
#[derive(Debug, Default)]
pub struct Planner {
    /// Meshes and images.
    pub assets: Assets,
    /// What is left out because it is not seen.
    pub cull: Cull,
    /// What was odd, but stopped nothing.
    pub warnings: Vec<Diagnostic>,
    pub(super) bounds: KnownBounds,
    /// Compiled looks by what they were compiled from.
    pub(super) shaders: HashMap<u64, LookShaders>,
    /// Those that the last plan used.
    pub(super) used: HashSet<u64>,
    /// The nodes of compiled looks that read UVs or tangents, where a mesh has no UVs.
    pub(super) uv_readers: HashMap<u64, Vec<NodePath>>,
    /// Whether looks are compiled as they are written: nothing folded, merged or removed.
    pub(super) unspecialized: bool,
}

impl Planner {
    /// A planner with assets that were read already.
    pub fn new(assets: Assets) -> Self {
        Self { assets, ..Self::default() }
    }

    /// A planner for the reference: what it compiles is as the looks are written, with nothing
    /// folded or removed. Its plans are to be asked for with [`Live::All`], so that every value
    /// comes in f64.
    pub fn for_truth(assets: Assets) -> Self {
        Self { assets, unspecialized: true, cull: Cull::Objects, ..Self::default() }
    }

    /// The same, leaving out `cull`.
    #[must_use]
    pub fn culling(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }

    /// Gives a look's module that was compiled elsewhere (on another thread, say), for the next
    /// plans of this look. The same module again takes on the look's keys.
    pub fn provide(&mut self, look: &Look, live: &Live, draw: Arc<CompiledShader>) {
        let key = look_key(look, live, false, &BTreeSet::new());
        // Keys change without the module: what was made beside it serves on.
        let known =
            self.shaders.values_mut().find(|shaders| Arc::ptr_eq(&shaders.draw, &draw)).map(
                |shaders| {
                    let rig = shaders.rig.renewed(look);
                    LookShaders { rig, ..shaders.clone() }
                },
            );
        let shaders = known.unwrap_or_else(|| {
            let (rig, problems) = Rig::new(look);
            self.warnings = problems;
            LookShaders::new(draw, rig)
        });
        // One look is being edited at a time: what was compiled for its earlier states goes, the
        // other looks stay.
        self.shaders.retain(|key, _| self.used.contains(key));
        self.shaders.insert(key, shaders);
    }

    /// Plans one picture of `setup`.
    ///
    /// # Errors
    /// Everything that keeps a look from being compiled or an image from being read.
    pub fn plan(
        &mut self,
        setup: &Setup,
        library: &Library,
        live: &Live,
        options: &PlanOptions,
    ) -> Result<FramePlan, Vec<Diagnostic>> {
        let mut dropped = Vec::new();
        let scene = self.place(setup, library, live, options);
        let visible = self.visible(&scene, &mut dropped);
        let variants = self.compile_looks(&scene, &visible, &mut dropped)?;
        push_equal_looks(&mut dropped, setup, &variants);
        let shaders = &self.shaders;
        let wanted = WantedPasses::new(&ContextReaders {
            scene: &scene,
            visible: &visible,
            variants: &variants,
            shaders,
        });
        let stages = wanted.stages_before();
        self.compile_before(&scene, &visible, &variants, &stages)?;
        self.warn(&scene, &visible, &variants);
        let draws = self.draws(&scene, &visible, &variants, &stages)?;
        wanted.push_unwanted(&mut dropped, options);
        let passes = wanted.planned(&draws, &scene.view, options);
        Ok(FramePlan {
            size: options.size,
            samples: options.samples,
            backdrop: setup.scene.backdrop,
            view: scene.view,
            draws,
            passes,
            dropped,
        })
    }
}
