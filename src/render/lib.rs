//! Executes frame plans on wgpu.
//!
//! [`Gpu`] is a device, our own or a window's. [`Renderer`] keeps what is expensive (pipelines,
//! meshes, images, targets) and runs a [`FramePlan`]'s passes in order. [`Renderer::evaluate`] runs
//! surface samples. Creation and readback are async; [`block_on`] is for the command line.

use chiaro_compiler::compile;
use chiaro_language::{clock, diag, milestones, progress};
use chiaro_scene::{frame, geometry, hcbtf};

mod error;
mod eval;
mod executor;
mod gpu;
mod image;
mod mesh;
mod passes;
mod pipeline;
mod readback;
mod target;
mod timer;

use std::collections::HashMap;

use crate::compile::Stage;
use crate::frame::{FramePlan, PassId};

pub use crate::frame::Picture;

pub use error::RenderError;
pub use gpu::{Gpu, block_on, device_descriptor};
pub use timer::{PassTime, set_times};

/// Runs frame plans.
#[derive(Debug)]
pub struct Renderer {
    gpu: Gpu,
    pipelines: pipeline::Pipelines,
    meshes: mesh::Meshes,
    images: image::Images,
    /// The pipelines of passes over the picture, made when first asked for.
    screens: HashMap<PassId, passes::ScreenPipeline>,
    targets: target::Targets,
    /// The input hash of what each pass's targets hold.
    done: HashMap<PassId, u64>,
    /// While passes are timed.
    timer: Option<timer::Timer>,
}

impl Renderer {
    /// A renderer on `gpu`.
    pub fn new(gpu: Gpu) -> Self {
        Self {
            gpu,
            pipelines: pipeline::Pipelines::default(),
            meshes: mesh::Meshes::default(),
            images: image::Images::default(),
            screens: HashMap::new(),
            targets: target::Targets::default(),
            done: HashMap::new(),
            timer: None,
        }
    }

    /// The device it runs on.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The input hash of what each pass's targets hold: what would not run again.
    pub fn done(&self) -> &HashMap<PassId, u64> {
        &self.done
    }

    /// Runs `plan`; the picture is then in [`picture_view`](Self::picture_view), premultiplied and
    /// display-referred. Passes whose inputs are what they were last time are not run again. Says
    /// which ran.
    ///
    /// # Errors
    /// What the GPU cannot do; what was drawn before stays.
    pub async fn draw(&mut self, plan: &FramePlan) -> Result<Vec<PassId>, RenderError> {
        self.gpu.check_size(plan.size)?;
        let guard = self.gpu.guard();
        if self.targets.fit(&self.gpu, plan) {
            self.done.clear();
        }
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame") });
        let mut ran = Vec::new();
        for pass in &plan.passes {
            if self.done.get(&pass.id) == Some(&pass.input_hash) {
                continue;
            }
            match pass.id.stage() {
                None => self.draw_screen(plan, pass.id, &mut encoder)?,
                Some(Stage::Draw) => self.draw_look(plan, &mut encoder)?,
                Some(stage) => self.draw_meshes(plan, (pass.id, stage), &mut encoder)?,
            }
            ran.push(pass.id);
        }
        self.gpu.queue.submit([encoder.finish()]);
        if let Err(error) = guard.finish().await {
            self.done.clear();
            return Err(error);
        }
        self.done.extend(plan.passes.iter().map(|pass| (pass.id, pass.input_hash)));
        self.meshes.keep_recent();
        self.images.keep_recent();
        Ok(ran)
    }

    /// Runs `plan` and reads the picture back.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub async fn picture(&mut self, plan: &FramePlan) -> Result<Picture, RenderError> {
        self.draw(plan).await?;
        let texture = self
            .targets
            .picture()
            .ok_or(RenderError::Lost { message: "the picture has no target".to_owned() })?;
        readback::read_picture(&self.gpu, texture).await
    }

    /// What [`draw`](Self::draw) drew, `rgba16float`, premultiplied.
    pub fn picture_view(&self) -> Option<wgpu::TextureView> {
        self.targets
            .picture()
            .map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }
}
