//! The planner, which makes frame plans.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use super::deferral::{self, DeferredLooks};
use super::key::{SurfaceVariant, look_key};
use super::omissions::push_equal_looks;
use super::passes::{ContextReaders, SceneSeen, WantedPasses};
use super::style::PlanStyle;
use super::variants::{LookShaders, Variants};
use super::{FramePlan, PlanOptions};
use crate::compile::{CompiledShader, Live, Loops};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::Look;
use crate::frame::aovs::{AovLayer, AovRequest};
use crate::frame::assets::Assets;
use crate::frame::keys::{Rig, SceneRig};
use crate::frame::mattes::sample_shifts;
use crate::frame::motion::KnownPoses;
use crate::frame::screen::Ink;
use crate::frame::setup::{Setup, SetupLook};
use crate::frame::visibility::{CullMode, KnownBounds};
use crate::ids::NodePath;
use crate::library::Library;

/// Maker of frame plans, which keeps compiled looks and assets that were read.
#[derive(Debug, Default)]
pub struct Planner {
    /// Reader of meshes and images.
    pub assets: Assets,
    /// Parts that are left out because they are not seen.
    pub cull: CullMode,
    pub(super) bounds: KnownBounds,
    /// Meshes in their last poses.
    pub(super) poses: KnownPoses,
    /// Compiled looks, by the hash of what they were compiled from.
    pub(super) shaders: HashMap<u64, LookShaders>,
    /// Keys of the compiled looks that the last plan used.
    pub(super) used: HashSet<u64>,
    /// Keys of the lights of the last scene.
    pub(super) scene_rig: Option<Arc<SceneRig>>,
    /// Nodes of compiled looks that read UVs or tangents, for meshes without UVs.
    pub(super) uv_readers: HashMap<u64, Vec<NodePath>>,
    /// Modules of looks that are drawn deferred.
    pub(super) deferred: DeferredLooks,
    /// True if looks are compiled as they are written: nothing folded, merged or removed.
    pub(super) unspecialized: bool,
    /// Choice of the lights that modules go through in loops.
    pub(super) loops: Loops,
    /// Layers that plans have beside the picture.
    pub aovs: Vec<AovRequest>,
    /// True if plans draw which objects and materials are seen, in place of colors.
    pub(super) mattes: bool,
    /// Shift of the picture, to the right and down, in pixels.
    pub(super) shift: [f64; 2],
}

impl Planner {
    /// A planner with a reader that may have read assets already.
    pub fn new(assets: Assets) -> Self {
        Self { assets, ..Self::default() }
    }

    /// A planner for the reference: looks are compiled as they are written, with nothing folded or
    /// removed. Its plans are to be asked for with [`Live::All`], so that every value comes in f64.
    pub fn for_truth(assets: Assets) -> Self {
        PlanStyle::AsWritten.planner(assets)
    }

    /// A planner for probes: [for the truth](Self::for_truth), with code of its own for each light
    /// of a region, so that the values of one are told from those of another.
    pub fn for_probes(assets: Assets) -> Self {
        Self { loops: Loops::Never, ..Self::for_truth(assets) }
    }

    /// The planner, changed to leave out `cull`.
    #[must_use]
    pub fn culling(self, cull: CullMode) -> Self {
        Self { cull, ..self }
    }

    /// Provides a look's module that was compiled elsewhere (on another thread, say), for the next
    /// plans of this look. A module that is known already takes on the look's keys.
    pub fn provide(&mut self, look: &Look, live: &Live, draw: Arc<CompiledShader>) {
        let key = look_key(look, live, SurfaceVariant::default(), &BTreeSet::new());
        // Keys change without the module: the modules made beside it are still valid.
        let known = self.shaders.values().find(|shaders| Arc::ptr_eq(&shaders.draw, &draw));
        let shaders = match known {
            Some(shaders) => {
                let (rig, warnings) = shaders.rig.renewed(look).into_parts();
                LookShaders { rig, warnings, ..shaders.clone() }
            }
            None => {
                let (rig, warnings) = Rig::new(look).into_parts();
                LookShaders::new(draw, rig, warnings)
            }
        };
        // Only one look is edited at a time: modules compiled for its earlier states are dropped,
        // those of other looks stay.
        self.shaders.retain(|key, _| self.used.contains(key));
        self.shaders.insert(key, shaders);
    }

    /// Plans the pictures of which object and material is seen, one for each of a pixel's samples:
    /// its place in the pixel is the middle of the pixels of its picture. See
    /// [`MattePart`](crate::frame::MattePart).
    ///
    /// # Errors
    /// As [`plan`](Self::plan).
    pub fn plan_mattes(
        &mut self,
        setup: &Setup,
        library: &Library,
        live: &Live,
        options: &PlanOptions,
    ) -> Result<Vec<FramePlan>, Vec<Diagnostic>> {
        let aovs = std::mem::take(&mut self.aovs);
        self.mattes = true;
        let single = PlanOptions { samples: 1, ..options.clone() };
        let plans = sample_shifts(options.samples).into_iter().map(|shift| {
            self.shift = shift;
            self.plan(setup, library, live, &single).map(|plan| plan.value)
        });
        let plans = plans.collect();
        (self.aovs, self.mattes, self.shift) = (aovs, false, [0.0; 2]);
        plans
    }

    /// The layers beside the picture, as the looks' modules give them.
    fn planned_aovs(
        &self,
        looks: &[SetupLook],
        variants: &Variants,
    ) -> Result<Vec<AovLayer>, Vec<Diagnostic>> {
        if self.aovs.is_empty() {
            return Ok(Vec::new());
        }
        let mut variants: Vec<_> = variants.iter().collect();
        variants.sort_by_key(|((object, look), _)| (*look, *object));
        let modules = variants.into_iter().filter_map(|((_, look), variant)| {
            let file = looks.get(*look)?.source.file();
            Some((file, &*self.shaders.get(&variant.key)?.draw))
        });
        AovLayer::planned(&self.aovs, &modules)
    }

    /// Plans one picture of `setup`; warns of oddities of the looks and objects in it. Where a shot
    /// is over it, that moves the scene to the time, and may hold what shades at a frame before.
    ///
    /// # Errors
    /// All errors that keep a look from being compiled or an image from being read.
    pub fn plan(
        &mut self,
        setup: &Setup,
        library: &Library,
        live: &Live,
        options: &PlanOptions,
    ) -> Result<WithWarnings<FramePlan>, Vec<Diagnostic>> {
        self.assets.share(&setup.assets);
        // Meshes move with the camera and the objects, however long shading is held.
        let posed = self.poses.at(setup, options.time);
        let (setup, time) = (&*posed, posed.shading_time(options.time));
        let options = &PlanOptions { time, ..options.clone() };
        let mut dropped = Vec::new();
        let mut scene = self.place(setup, library, live, options);
        scene.view = scene.view.shifted(self.shift);
        let visible = self.visible(&scene, &mut dropped);
        let variants = self.compile_looks(&scene, &visible, &mut dropped)?;
        push_equal_looks(&mut dropped, setup, &variants);
        let shaders = &self.shaders;
        let readers = ContextReaders::new(&scene, &visible, &variants, shaders);
        let ink = Ink::of(&setup.scene.outlines, options.size[1]);
        let ink = ink.filter(|_| !visible.is_empty() && !self.mattes);
        let wanted = WantedPasses::new(&readers, ink.is_some());
        let stages = wanted.stages_before();
        let aovs = self.planned_aovs(&setup.looks, &variants)?;
        self.compile_before(&scene, &visible, &variants, &stages)?;
        let warnings = self.warnings(&scene, &visible, &variants);
        let casters = self.casters(&scene, &visible, &variants, &mut dropped)?;
        let draws = self.draws(&scene, (&visible, casters.as_ref()), &variants, &stages)?;
        wanted.push_unwanted(&mut dropped, options);
        let mapped = casters.as_ref().filter(|_| wanted.of_lights());
        let shadow_maps = mapped.map(|casters| casters.maps(options.size[1]));
        let shadow_maps = shadow_maps.transpose().map_err(|problem| vec![problem])?;
        let casters = casters.and_then(|casters| casters.texture);
        let backdrop = setup.scene.backdrop.filter(|_| !self.mattes);
        let seen = SceneSeen {
            view: &scene.view,
            casters: casters.as_deref(),
            shadow_maps: shadow_maps.as_ref(),
            ink,
            backdrop,
        };
        let mut passes = wanted.planned(&draws, &seen, options);
        let deferral = self.deferred.deferral(&scene, &visible, &passes, &draws);
        deferral::tell(&mut passes, &deferral);
        let plan = FramePlan {
            size: options.size,
            samples: options.samples,
            backdrop,
            ink,
            view: scene.view,
            covered: scene.covered(&visible),
            casters,
            shadow_maps: shadow_maps.map(Arc::new),
            draws,
            passes,
            deferral,
            aovs,
            dropped,
        };
        Ok(WithWarnings::new(plan, warnings))
    }
}
