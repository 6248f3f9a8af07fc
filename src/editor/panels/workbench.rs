//! State that panels and tools keep between frames.

use std::any::{Any, TypeId};
use std::collections::HashMap;

use super::PANELS;
use super::thumbs::Thumbs;
use crate::canvas::Canvas;
use crate::hcbtf::Device;
use crate::painter::Painting;
use crate::panels::cost::Cost;
use crate::panels::export::ExportCards;
use crate::panels::frames::FrameRenders;
use crate::panels::library::saved::SavedParts;
use crate::panels::links::Links;
use crate::panels::wedge::Wedge;
use crate::render::Gpu;
use crate::state::crashes::CrashLog;
use crate::tools::PictureTools;
use crate::viewport::Viewport;
use crate::viewport::picture::ViewportPicture;

/// Parts of the window that panels draw, with their threads.
pub(crate) struct Workbench {
    pub(crate) canvas: Canvas,
    pub(crate) viewport: Viewport,
    pub(crate) picture: Option<ViewportPicture>,
    pub(crate) tools: PictureTools,
    pub(crate) cost: Cost,
    pub(crate) painting: Painting,
    pub(crate) links: Links,
    pub(crate) export: ExportCards,
    pub(crate) frames: FrameRenders,
    pub(crate) wedge: Wedge,
    pub(crate) parts: SavedParts,
    pub(crate) thumbs: Thumbs,
    /// State of the other panels.
    pub(crate) memory: PanelMemory,
}

impl Workbench {
    /// `wake` is called from other threads when they have results; the drawing of thumbnails is
    /// noted in `crashes`.
    pub(crate) fn new(
        picture: Option<ViewportPicture>,
        crashes: CrashLog,
        wake: impl Fn() + Clone + Send + Sync + 'static,
    ) -> Self {
        let gpu: Option<Gpu> = picture.as_ref().map(|picture| picture.gpu().clone());
        let device = gpu.as_ref().map_or_else(Device::guaranteed, Gpu::holds);
        Self {
            canvas: Canvas::default(),
            viewport: Viewport::new(gpu.clone(), wake.clone()),
            tools: PictureTools::new(gpu.clone(), wake.clone()),
            cost: Cost::new(gpu.clone(), wake.clone()),
            painting: Painting::new(device, wake.clone()),
            links: Links::new(wake.clone()),
            export: ExportCards::new(wake.clone()),
            frames: FrameRenders::new(wake.clone()),
            wedge: Wedge::new(wake.clone()),
            parts: SavedParts::new(wake.clone()),
            thumbs: Thumbs::new(gpu, crashes, wake),
            picture,
            memory: PanelMemory::default(),
        }
    }

    /// True if a thread works for a panel.
    pub(crate) fn is_busy(&self) -> bool {
        PANELS.iter().filter_map(|row| row.jobs).any(|jobs| jobs(self).is_busy())
    }

    /// Waits for the threads that work for panels.
    pub(crate) fn wait(&self) {
        PANELS.iter().filter_map(|row| row.jobs).for_each(|jobs| jobs(self).wait());
    }
}

/// State of panels, each of a type of its own.
#[derive(Default)]
pub(crate) struct PanelMemory {
    states: HashMap<TypeId, Box<dyn Any>>,
}

impl PanelMemory {
    /// State of this type; its default at first.
    pub(crate) fn of<T: Default + 'static>(&mut self) -> &mut T {
        let state = self.states.entry(TypeId::of::<T>()).or_insert_with(|| Box::<T>::default());
        state.downcast_mut().unwrap_or_else(|| unreachable!("a type is the key of its own"))
    }
}
