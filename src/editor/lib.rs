//! The editor: node canvas, viewport, inspector, generated WGSL. The only egui code.
//!
//! `state` holds the open documents, each an `OpenDocument` with its past and its journal, and asks
//! a thread for shaders; `state` does not know egui. `commands` lists all commands of the window,
//! with labels and keys. Panels, the canvas, the painter, the picture and its tools see the
//! [`Session`] and return commands; [`App`] applies those in one place. Panels are rows of
//! `panels::PANELS`, tools of the picture rows of `tools::TOOLS`. The canvas owns no graph: it
//! reads the document and draws the part in view.
//!
//! Modules lie in layers, and each uses only lower ones: `state`, `commands`, `widgets`, `fields`,
//! `tools`, then `canvas`, `painter` and `viewport`, then `panels`, and `app` above all.

use chiaro_compiler::{catalog, compile, document, examples, library};
use chiaro_files as files;
use chiaro_film as film;
use chiaro_laboratory::{accuracy, fit};
use chiaro_language::{clock, diag, figures, ids, interp, milestones, progress};
use chiaro_reference as reference;
use chiaro_render as render;
use chiaro_scene::{
    directions, drawing, export, frame, geometry, hcbtf, import, photometry, placing, threads,
};

mod app;
mod canvas;
mod commands;
mod fields;
mod painter;
mod panels;
mod state;
mod tools;
mod viewport;
mod widgets;

use eframe::egui;
use std::io::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

pub use crate::painter::Painting;
pub use crate::panels::cost::Cost;
pub use crate::state::display::DisplayChoice;
pub use crate::state::orbit::Orbit;
pub use crate::state::revision::{GestureId, LookRevision};
pub use crate::state::safety::places::Places;
pub use crate::state::scene::OpenScene;
pub use crate::state::session::Session;
pub use crate::state::settings::{self, Settings};
pub use crate::tools::fitting::FitTool;
pub use crate::tools::placing::PlacingTool;
pub use crate::tools::probe::Probe;
pub use crate::tools::wipe::Wipe;
pub use app::App;
pub use canvas::Canvas;
pub use viewport::Viewport;

use crate::catalog::values;

use crate::diag::Diagnostic;
use crate::frame::{DEFAULT_MESH, SHAPE_PREFIX};
use crate::library::Library;

/// Options of the native window: size, icon, and the limits of the GPU device.
pub fn options() -> eframe::NativeOptions {
    let viewport = egui::ViewportBuilder::default()
        .with_app_id("chiaro")
        .with_title("Chiaro")
        .with_inner_size([1600.0, 960.0])
        .with_min_inner_size([760.0, 480.0])
        .with_drag_and_drop(true)
        .with_icon(icon());
    let mut setup = eframe::egui_wgpu::WgpuSetupCreateNew::without_display_handle();
    setup.device_descriptor = Arc::new(|adapter| {
        milestones::reached("adapter");
        crate::render::device_descriptor(adapter)
    });
    let mut options =
        eframe::NativeOptions { viewport, renderer: eframe::Renderer::Wgpu, ..Default::default() };
    options.wgpu_options.wgpu_setup = setup.into();
    options
}

/// The program's icon, as `chiaro desktop` installs it too.
fn icon() -> egui::IconData {
    eframe::icon_data::from_png_bytes(include_bytes!("icon.png")).unwrap_or_default()
}

/// Starts the processor's work for the first picture on threads, while the window and the device
/// are created: the built-in nodes are read, and a built-in shape of `mesh` is made. Both results
/// are cached for all later callers.
fn warm_up(mesh: Option<&str>) {
    drop(state::worker::start("library", || {
        Library::built_in();
    }));
    let shape = mesh.unwrap_or(DEFAULT_MESH).strip_prefix(SHAPE_PREFIX).map(str::to_owned);
    if let Some(shape) = shape {
        drop(state::worker::start("shape", move || drop(crate::geometry::shape(&shape))));
    }
}

/// Opens the window with the first of `files`, or a new look, on `mesh` (a path, or `shape:` and a
/// name), and returns when the window is closed.
///
/// # Errors
/// The reason why no window can be opened.
pub fn run(files: &[PathBuf], mesh: Option<&str>) -> Result<(), Box<Diagnostic>> {
    let file = files.first().cloned();
    let mesh = mesh.map(str::to_owned);
    warm_up(mesh.as_deref());
    let places = Places::of_user();
    places.as_ref().map(|places| Settings::load(&places.settings())).unwrap_or_default().speak();
    let create = move |context: &eframe::CreationContext<'_>| {
        milestones::reached("window and device");
        let mut app = App::new(&context.egui_ctx, context.wgpu_render_state.clone());
        if let Some(places) = places {
            app.keep_in(places, &context.egui_ctx);
        }
        match file {
            Some(file) => {
                if let Some(wrong) = app.begin_with(&file) {
                    let _ = writeln!(std::io::stderr(), "{wrong}");
                }
            }
            None => app.begin(),
        }
        if let Some(mesh) = mesh {
            app.show_on(&mesh);
        }
        Ok(Box::new(app) as Box<dyn eframe::App>)
    };
    eframe::run_native("chiaro", options(), Box::new(create)).map_err(|error| {
        let problem = Diagnostic::error("no-window", format!("no window could be opened: {error}"));
        let hint = "without a display, `chiaro render` makes pictures; on Linux DISPLAY or \
                    WAYLAND_DISPLAY names one";
        Box::new(problem.hint(hint))
    })
}
