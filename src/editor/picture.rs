//! The picture in the viewport: planned and drawn on a thread of its own, on the window's device, so that neither a
//! slow GPU nor a shader being built holds up a hand. The newest wish wins; what was drawn last stays until then.

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::TextureId;
use eframe::egui_wgpu::RenderState;

use super::orbit::Orbit;
use super::session::{Session, Showing};
use super::still::Still;
use super::worker::Worker;
use crate::compile::{CompiledShader, Live};
use crate::diag::Diagnostic;
use crate::frame::{Cull, Effect, PlanOptions, Planner, effects};
use crate::library::Library;
use crate::render::{Gpu, Renderer, block_on, set_times};

/// What is to be drawn.
struct Wish {
    showing: Showing,
    still: Still,
    size: [u32; 2],
    /// Whether its effects are to be told.
    tells_effects: bool,
}

/// What a picture was wished for: the same again needs no new one.
#[derive(PartialEq)]
struct Wished {
    picture: u64,
    orbit: Orbit,
    size: [u32; 2],
    folder: PathBuf,
    tells_effects: bool,
}

/// What was drawn: a texture where it is another than the last time.
struct Drawn {
    texture: Option<wgpu::TextureView>,
    problems: Vec<Diagnostic>,
    effects: Option<Vec<Effect>>,
}

/// The viewport's picture.
pub(crate) struct Picture {
    state: RenderState,
    gpu: Gpu,
    worker: Worker<Wish, Drawn>,
    texture: Option<TextureId>,
    wished: Option<Wished>,
    /// How many pictures were asked for.
    pub(crate) wishes: u64,
    /// What keeps the picture from being drawn, or was odd about it.
    pub(crate) problems: Vec<Diagnostic>,
    /// Whether somebody wants to know what the picture costs.
    pub(crate) tells_effects: bool,
    /// What the last picture of a look at rest cost, where that was wanted.
    pub(crate) effects: Arc<Vec<Effect>>,
}

impl Picture {
    /// A picture on the window's device. `wake` is called from another thread when there is a new one.
    pub(crate) fn new(state: RenderState, wake: impl Fn() + Send + 'static) -> Self {
        let gpu = Gpu::new(state.device.clone(), state.queue.clone(), state.adapter.get_info());
        // Lights are edited: a look is not compiled anew when one goes out.
        let planner = Planner::default().culling(Cull::Objects);
        let mut artist = Artist { renderer: Renderer::new(gpu.clone()), planner, provided: None, library: None };
        let worker = Worker::new("picture", wake, move |wish| artist.draw(&wish));
        Self {
            state,
            gpu,
            worker,
            texture: None,
            wished: None,
            wishes: 0,
            problems: Vec::new(),
            tells_effects: false,
            effects: Arc::default(),
        }
    }

    /// The window's device.
    pub(crate) fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Asks for a picture of `size` pixels if anything changed, and returns the newest there is.
    pub(crate) fn update(&mut self, session: &mut Session, size: [u32; 2]) -> Option<TextureId> {
        for drawn in self.worker.answers() {
            if let Some(view) = drawn.texture {
                self.show(&view);
            }
            self.problems = drawn.problems;
            if let Some(effects) = drawn.effects {
                self.effects = Arc::new(effects);
            }
        }
        let wished = Some(Wished {
            picture: session.picture(),
            orbit: session.view.clone(),
            size,
            folder: session.folder(),
            tells_effects: self.tells_effects,
        });
        if self.wished != wished
            && size.iter().all(|&side| side > 0)
            && let Some(showing) = session.showing()
        {
            self.wished = wished;
            self.wishes += 1;
            let still = session.still_of(showing.look.clone());
            let wish = Wish { showing, still, size, tells_effects: self.tells_effects };
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
    /// The nodes that the planner compiled with.
    library: Option<Arc<Library>>,
}

impl Artist {
    fn draw(&mut self, wish: &Wish) -> Drawn {
        match self.try_draw(wish) {
            Ok(effects) => {
                let problems = std::mem::take(&mut self.planner.warnings);
                Drawn { texture: self.renderer.picture_view(), problems, effects }
            }
            Err(problems) => Drawn { texture: None, problems, effects: None },
        }
    }

    /// Draws, and tells the effects where they are wanted and the look is at rest: of a look that is being edited
    /// nothing is left out, which would only flicker.
    fn try_draw(&mut self, wish: &Wish) -> Result<Option<Vec<Effect>>, Vec<Diagnostic>> {
        let showing = &wish.showing;
        if !self.library.as_ref().is_some_and(|library| Arc::ptr_eq(library, &wish.still.library)) {
            self.planner = Planner::new(std::mem::take(&mut self.planner.assets)).culling(Cull::Objects);
            (self.library, self.provided) = (Some(wish.still.library.clone()), None);
        }
        let (mut setup, notes) = wish.still.setup(&mut self.planner.assets)?;
        // The look's lights as they are now: the planner keeps those of the time when it was given the shader.
        setup.scene.lights.clone_from(&showing.look.lights);
        if !self.provided.as_ref().is_some_and(|provided| Arc::ptr_eq(provided, &showing.shader)) {
            self.planner.provide(&showing.look, &showing.live, showing.shader.clone());
            self.provided = Some(showing.shader.clone());
        }
        let options = PlanOptions { size: wish.size, samples: 4, time: 0.0 };
        let plan = self.planner.plan(&setup, &wish.still.library, &showing.live, &options)?;
        self.planner.warnings.extend(notes);
        let is_told = wish.tells_effects && showing.live == Live::Keyed;
        let mut effects = is_told.then(|| effects(&plan, self.renderer.done()));
        block_on(self.renderer.draw(&plan)).map_err(|error| vec![error.into()])?;
        if let Some(effects) = &mut effects {
            // Once more with a clock, everything anew: what was drawn just now may have been little, or the first time.
            let times = block_on(self.renderer.measure(&plan)).map_err(|error| vec![error.into()])?;
            set_times(effects, &times);
        }
        Ok(effects)
    }
}
