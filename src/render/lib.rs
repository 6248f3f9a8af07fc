//! Renderer: execution of frame plans on wgpu.
//!
//! [`Gpu`] is a device, our own or a window's. [`Renderer`] keeps the expensive resources
//! (pipelines, meshes, images, targets) and runs a [`FramePlan`]'s passes in order.
//! [`Renderer::evaluate`] evaluates a look at surface samples. Creation, drawing and readback are
//! async; only the program's main function, or a thread of its window, blocks on them.

use chiaro_compiler::compile;
use chiaro_language::{clock, diag, milestones, progress};
use chiaro_locale::tr;
use chiaro_scene::{frame, geometry, hcbtf};

mod casters;
mod deferred;
mod display;
mod error;
mod eval;
mod executor;
mod gpu;
mod image;
mod kept;
mod mesh;
mod passes;
mod pipeline;
mod readback;
mod shadow_maps;
mod store;
mod target;
mod timer;

use std::collections::HashMap;
use std::sync::Arc;

use crate::frame::{DisplayModule, FramePlan, LayeredPicture, PassId};

pub use crate::frame::Picture;

pub use error::{LimitedSize, RenderError};
pub use gpu::{Gpu, device_descriptor};
pub use store::UploadCounts;
pub use timer::{PassTime, set_times};

/// Executor of frame plans on a GPU. Renderers on clones of one [`Gpu`] share meshes, images and
/// pipelines.
#[derive(Debug)]
pub struct Renderer {
    gpu: Gpu,
    pipelines: pipeline::Pipelines,
    meshes: mesh::Meshes,
    images: image::Images,
    /// Pipelines of passes over the picture, created on first use; true beside those that test
    /// depth.
    screens: HashMap<(PassId, bool), passes::ScreenPipeline>,
    targets: target::Targets,
    /// The step from light to what is shown; `None` for the curve of sRGB, by which looks end.
    display: Option<display::Display>,
    /// Triangles that cast shadows, while looks read them.
    casters: Option<casters::CastersTexture>,
    /// The scene as lights see it, while looks read it.
    lights: shadow_maps::LightTargets,
    /// Hash of the inputs that each pass's targets were drawn from.
    done: HashMap<PassId, u64>,
    /// Pixels of the last picture, where they are kept.
    kept: kept::KeptPixels,
    /// Timer of the passes, while they are measured.
    timer: Option<timer::Timer>,
}

impl Renderer {
    /// A renderer on `gpu`.
    pub fn new(gpu: Gpu) -> Self {
        Self {
            pipelines: gpu.store.pipelines.clone(),
            meshes: gpu.store.meshes.clone(),
            images: gpu.store.images.clone(),
            gpu,
            screens: HashMap::new(),
            targets: target::Targets::default(),
            display: None,
            casters: None,
            lights: shadow_maps::LightTargets::default(),
            done: HashMap::new(),
            kept: kept::KeptPixels::default(),
            timer: None,
        }
    }

    /// The device that the renderer runs on.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Hash of the inputs that each pass's targets were drawn from: passes with these inputs are
    /// not run again.
    pub fn done(&self) -> &HashMap<PassId, u64> {
        &self.done
    }

    /// Shows pictures by a module from now on, or without one by the curve of sRGB. Layers stay as
    /// they are.
    ///
    /// # Errors
    /// A module that the device does not take; pictures are then shown by the curve of sRGB.
    pub async fn show_by(
        &mut self,
        module: Option<&Arc<DisplayModule>>,
    ) -> Result<(), RenderError> {
        let Some(module) = module else {
            self.display = None;
            return Ok(());
        };
        if self.display.as_ref().is_some_and(|display| display.is_of(module)) {
            return Ok(());
        }
        let guard = self.gpu.guard();
        let display = display::Display::new(&self.gpu, module.clone());
        let made = guard.finish().await;
        self.display = made.is_ok().then_some(display);
        made
    }

    /// Runs `plan`; the picture is then in [`shown_view`](Self::shown_view), premultiplied and
    /// display-referred. Passes with the same inputs as last time are not run again. Returns the
    /// passes that ran.
    ///
    /// # Errors
    /// Errors of the GPU; the former picture stays.
    pub async fn draw(&mut self, plan: &FramePlan) -> Result<Vec<PassId>, RenderError> {
        self.gpu.check_size(plan.size)?;
        let guard = self.gpu.guard();
        // New targets are empty, so every pass has to run again.
        if self.targets.fit(&self.gpu, plan) {
            self.done.clear();
        }
        self.prepare_casters(plan)?;
        if self.prepare_shadow_maps(plan)? {
            self.done.clear();
        }
        // What was cleared, and what may have changed unseen, begins anew.
        let mut inputs = self.kept.inputs.take().filter(|_| !self.done.is_empty());
        self.kept.count(plan, Some(&[]));
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame") });
        let deferral = self.deferral(plan);
        let mut ran = Vec::new();
        // What is laid over the picture follows the looks.
        for pass in plan.passes.iter().filter(|pass| !pass.id.is_over()) {
            if self.done.get(&pass.id) == Some(&pass.input_hash) {
                continue;
            }
            match (pass.id.stage(), deferral) {
                (None, _) if pass.id.is_of_lights() => {
                    if !self.draw_lights(plan, pass.id, &mut encoder)? {
                        continue;
                    }
                }
                (None, _) => self.draw_screen(plan, pass.id, &mut encoder)?,
                (Some(_), Some(deferral)) if pass.id.writes_picture() => {
                    self.draw_deferred(plan, deferral, &mut encoder)?;
                    self.kept.count(plan, None);
                    inputs = None;
                }
                (Some(_), Some(deferral)) if pass.id == deferral.surface => {
                    self.draw_numbered(plan, deferral, &mut encoder)?;
                }
                (Some(_), _) if pass.id.writes_picture() => {
                    inputs = self.draw_look(plan, inputs.as_ref(), &mut encoder)?;
                }
                (Some(stage), _) => self.draw_meshes(plan, (pass.id, stage), &mut encoder)?,
            }
            ran.push(pass.id);
            if pass.id.writes_picture() {
                for over in plan.passes.iter().map(|pass| pass.id).filter(|id| id.is_over()) {
                    self.draw_screen(plan, over, &mut encoder)?;
                    ran.push(over);
                }
            }
        }
        if let (Some(display), Some(picture)) = (&mut self.display, self.targets.picture()) {
            display.draw(&self.gpu, picture, &mut encoder);
        }
        self.gpu.queue.submit([encoder.finish()]);
        // After an error the content of the targets is unknown, so no pass counts as done.
        if let Err(error) = guard.finish().await {
            self.done.clear();
            self.lights.forget();
            if matches!(error, RenderError::OutOfMemory { .. }) {
                self.gpu.store.clear();
            }
            return Err(error);
        }
        self.kept.inputs = inputs;
        self.done.extend(plan.passes.iter().map(|pass| (pass.id, pass.input_hash)));
        self.gpu.store.keep_recent();
        Ok(ran)
    }

    /// Runs `plan` and reads the picture back.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub async fn picture(&mut self, plan: &FramePlan) -> Result<Picture, RenderError> {
        self.draw(plan).await?;
        let texture = self
            .shown()
            .ok_or(RenderError::Lost { message: tr!("the picture has no target").to_owned() })?;
        readback::read_picture(&self.gpu, texture).await
    }

    /// Runs `plan` and reads the picture and its layers back.
    ///
    /// # Errors
    /// As [`draw`](Self::draw), and more layers than the device can draw at once.
    pub async fn layered(&mut self, plan: &FramePlan) -> Result<LayeredPicture, RenderError> {
        let (size, limit) = (plan.aovs.len() as u64, self.gpu.most_layers() as u64);
        if size > limit {
            return Err(RenderError::TooLarge { what: LimitedSize::PictureLayers, size, limit });
        }
        let picture = self.picture(plan).await?;
        let mut layers = Vec::with_capacity(plan.aovs.len());
        for layer in self.targets.layers() {
            layers.push(readback::read_layer(&self.gpu, layer).await?);
        }
        Ok(LayeredPicture { picture, layers })
    }

    /// The picture that [`draw`](Self::draw) drew, as it is shown: `rgba16float`, premultiplied.
    pub fn shown_view(&self) -> Option<wgpu::TextureView> {
        self.shown().map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }

    fn shown(&self) -> Option<&wgpu::Texture> {
        self.display.as_ref().map_or(self.targets.picture(), display::Display::picture)
    }

    /// The picture that passes draw into.
    pub(crate) fn picture_view(&self) -> Option<wgpu::TextureView> {
        self.targets
            .picture()
            .map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }
}
