//! The picture in the viewport: planned and drawn on a thread of its own, on the window's device, so that neither a
//! slow GPU nor a shader being built holds up a hand. The newest wish wins; what was drawn last stays until then.

use std::sync::Arc;

use eframe::egui::TextureId;
use eframe::egui_wgpu::RenderState;
use glam::DQuat;

use super::orbit::Orbit;
use super::session::{Session, Showing};
use super::worker::Worker;
use crate::compile::CompiledShader;
use crate::diag::Diagnostic;
use crate::document::SourceMap;
use crate::frame::{Cull, PlanOptions, Planner, SetupLook, default_setup};
use crate::library::Library;
use crate::render::{Gpu, Renderer, block_on};

/// What is to be drawn.
struct Wish {
    showing: Showing,
    source: Arc<SourceMap>,
    folder: std::path::PathBuf,
    library: Arc<Library>,
    orbit: Orbit,
    size: [u32; 2],
}

/// What was drawn: a texture where it is another than the last time.
struct Drawn {
    texture: Option<wgpu::TextureView>,
    problems: Vec<Diagnostic>,
}

/// The viewport's picture.
pub(crate) struct Picture {
    state: RenderState,
    worker: Worker<Wish, Drawn>,
    texture: Option<TextureId>,
    wished: Option<(u64, Orbit, [u32; 2], std::path::PathBuf)>,
    /// How many pictures were asked for.
    pub(crate) wishes: u64,
    /// What keeps the picture from being drawn, or was odd about it.
    pub(crate) problems: Vec<Diagnostic>,
}

impl Picture {
    /// A picture on the window's device. `wake` is called from another thread when there is a new one.
    pub(crate) fn new(state: RenderState, wake: impl Fn() + Send + 'static) -> Self {
        let gpu = Gpu::new(state.device.clone(), state.queue.clone(), state.adapter.get_info());
        // Lights are edited: a look is not compiled anew when one goes out.
        let planner = Planner::default().culling(Cull::Objects);
        let mut artist = Artist { renderer: Renderer::new(gpu), planner, provided: None };
        let worker = Worker::new("picture", wake, move |wish| artist.draw(&wish));
        Self { state, worker, texture: None, wished: None, wishes: 0, problems: Vec::new() }
    }

    /// Asks for a picture of `size` pixels if anything changed, and returns the newest there is.
    pub(crate) fn update(&mut self, session: &mut Session, size: [u32; 2]) -> Option<TextureId> {
        for drawn in self.worker.answers() {
            if let Some(view) = drawn.texture {
                self.show(&view);
            }
            self.problems = drawn.problems;
        }
        let folder =
            session.path().and_then(|path| path.parent()).map(std::path::Path::to_path_buf).unwrap_or_default();
        let wished = Some((session.picture(), session.view.clone(), size, folder.clone()));
        if self.wished != wished
            && size.iter().all(|&side| side > 0)
            && let Some(showing) = session.showing()
        {
            self.wished = wished;
            self.wishes += 1;
            let wish = Wish {
                showing,
                source: session.source().clone(),
                folder,
                library: session.library.clone(),
                orbit: session.view.clone(),
                size,
            };
            self.worker.request(|_| wish);
        }
        self.texture
    }

    /// Whether one is being made.
    pub(crate) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    /// Waits for it.
    pub(crate) fn wait(&self) {
        self.worker.wait();
    }

    fn show(&mut self, view: &wgpu::TextureView) {
        let filter = wgpu::FilterMode::Linear;
        let mut renderer = self.state.renderer.write();
        match self.texture {
            Some(id) => renderer.update_egui_texture_from_wgpu_texture(&self.state.device, view, filter, id),
            None => self.texture = Some(renderer.register_native_texture(&self.state.device, view, filter)),
        }
    }
}

/// Lives on the thread.
struct Artist {
    renderer: Renderer,
    planner: Planner,
    /// The shader that the planner was given last.
    provided: Option<Arc<CompiledShader>>,
}

impl Artist {
    fn draw(&mut self, wish: &Wish) -> Drawn {
        match self.try_draw(wish) {
            Ok(()) => {
                let problems = std::mem::take(&mut self.planner.warnings);
                Drawn { texture: self.renderer.picture_view(), problems }
            }
            Err(problems) => Drawn { texture: None, problems },
        }
    }

    fn try_draw(&mut self, wish: &Wish) -> Result<(), Vec<Diagnostic>> {
        let Wish { showing, orbit, .. } = wish;
        let look =
            SetupLook { look: (*showing.look).clone(), source: wish.source.clone(), folder: wish.folder.clone() };
        let (mut setup, notes) = default_setup(look, &orbit.mesh, &mut self.planner.assets)?;
        if orbit.z_is_up {
            setup.stand_up();
        }
        setup.scene.camera = orbit.camera();
        setup.scene.illumination = DQuat::to_array(&orbit.illumination);
        // The look's lights as they are now: the planner keeps those of the time when it was given the shader.
        setup.scene.lights.clone_from(&showing.look.lights);
        if !self.provided.as_ref().is_some_and(|provided| Arc::ptr_eq(provided, &showing.shader)) {
            self.planner.provide(&showing.look, &showing.live, showing.shader.clone());
            self.provided = Some(showing.shader.clone());
        }
        let options = PlanOptions { size: wish.size, samples: 4, time: 0.0 };
        let plan = self.planner.plan(&setup, &wish.library, &showing.live, &options)?;
        self.planner.warnings.extend(notes);
        block_on(self.renderer.draw(&plan)).map_err(|error| vec![error.into()])?;
        Ok(())
    }
}
