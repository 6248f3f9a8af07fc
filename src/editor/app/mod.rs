//! The window: panels around the canvas. What they ask for is applied in one place, `apply`.

mod appearance;
mod apply;
mod bar;
pub(crate) mod dialogs;
pub(crate) mod dock;
mod files;
mod fitting;
pub(crate) mod look_export;
mod painting;
pub(crate) mod path_field;
mod recovery;
pub(crate) mod recovery_bar;
mod scene;
pub(crate) mod sheet;
pub(crate) mod tour;
mod welcome;

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use eframe::egui::{self, Key, Modifiers, Panel, Ui};

use crate::app::dialogs::{DialogKind, Dialogs};
use crate::app::dock::{Dock, Workspace};
use crate::app::look_export::{LookExportResult, LookExports};
use crate::app::path_field::PathField;
use crate::app::sheet::Sheet;
use crate::app::tour::Tour;
use crate::canvas::Canvas;
use crate::commands::table::{self, CommandRow, Place};
use crate::commands::{
    Command, FilePurpose, FitCommand, IMAGES, MESHES, PanelId, PictureExport, SceneCommand,
    keyboard,
};
use crate::diag::has_errors;
use crate::library::Library;
use crate::milestones;
use crate::painter::Painting;
use crate::painter::before::ViewBefore;
use crate::panels::cost::Cost;
use crate::panels::{PANELS, PanelContext, PanelRow, Presence, Workbench};
use crate::state::revision::DocumentNumber;
use crate::state::safety::Safety;
use crate::state::safety::places::Places;
use crate::state::session::Session;
use crate::state::settings::Settings;
use crate::tools::fitting::Fitting;
use crate::tools::probe::Probe;
use crate::tools::wipe::Wipe;
use crate::viewport::Viewport;
use crate::viewport::picture::{MissingPicture, Picture};
use crate::widgets::{spots, theme};
use files::Pending;
use welcome::StartPage;

/// How often the GPU is asked whether it has done what it never drew before.
const UNFINISHED: Duration = Duration::from_millis(30);
/// The height of the status bar, in points.
const STATUS: f32 = 38.0;

/// The window's state.
pub struct App {
    session: Session,
    bench: Workbench,
    dialogs: Dialogs,
    dock: Dock,
    look_exports: LookExports,
    safety: Safety,
    sheet: Sheet,
    start: Option<StartPage>,
    tour: Option<Tour>,
    path_field: Option<PathField>,
    /// What is done once unsaved changes are dealt with.
    pending: Option<Pending>,
    /// What went wrong with a file or an edit, until the next command.
    message: Option<String>,
    /// Presses of the pointer, and what had the keyboard: together with a widget they are the hand
    /// that edits.
    presses: u64,
    closes: bool,
    /// Whether the last frame was the first one with a picture, where that is to be told.
    shows_first_picture: bool,
    /// The look and the painting that the panels were laid out for last.
    laid_out_for: Option<(DocumentNumber, Option<u64>)>,
    /// What was looked at before a painting's flat square.
    view_before_painting: ViewBefore,
}

impl App {
    /// A window with a new look. `render_state` is the device to draw with, where there is one.
    pub fn new(ctx: &egui::Context, render_state: Option<eframe::egui_wgpu::RenderState>) -> Self {
        theme::apply(ctx);
        ctx.set_theme(egui::ThemePreference::Dark);
        let waker = || {
            let ctx = ctx.clone();
            move || ctx.request_repaint()
        };
        let library = Arc::new(Library::built_in().clone());
        let session = Session::new(library, waker());
        let crashes = || session.journals.crashes.clone();
        let picture = render_state.map(|state| Picture::new(state, crashes(), waker()));
        let bench = Workbench::new(picture, crashes(), waker());
        Self {
            session,
            bench,
            dialogs: Dialogs::new(waker()),
            dock: Dock::default(),
            look_exports: LookExports::new(waker()),
            safety: Safety::new(waker()),
            sheet: Sheet::default(),
            start: None,
            tour: None,
            path_field: None,
            pending: None,
            message: None,
            presses: 0,
            closes: false,
            shows_first_picture: false,
            laid_out_for: None,
            view_before_painting: ViewBefore::default(),
        }
    }

    /// Shows the look, or of a scene the selected object, on a mesh: a path, or `shape:` and the
    /// name of an own shape. What is wrong with it is told where problems are; the last good
    /// picture stays.
    pub fn show_on(&mut self, mesh: &str) {
        if self.session.stage().is_some() {
            return self.mesh_of_object(mesh);
        }
        self.session.view.orbit.show_on(mesh);
        self.safety.shown_on(mesh, self.session.view.orbit.z_is_up);
    }

    /// Stands the mesh up whose z axis points up, or lays it back.
    pub(super) fn stand_up(&mut self, z_is_up: bool) {
        self.session.view.orbit.z_is_up = z_is_up;
        self.safety.shown_on(&self.session.view.orbit.mesh, z_is_up);
    }

    /// Keeps unsaved work and settings in these folders, and offers what was left behind there.
    pub fn keep_in(&mut self, places: Places, ctx: &egui::Context) {
        let waker = ctx.clone();
        self.safety.keep_in(places, &mut self.session, move || waker.request_repaint());
        appearance::apply(&self.safety.settings, ctx);
        if let Some(layout) = self.safety.settings.layout.clone() {
            self.dock.restore(&layout);
        }
    }

    /// Goes on where the last window was closed, if anything was not saved then.
    pub fn resume(&mut self) {
        let painting = self.painting_number();
        self.message = self.safety.resume(&mut self.session);
        self.open_lacking_look();
        self.show_painting_taken_back(painting);
    }

    /// Looks at once whether other programs changed files, which else takes a moment.
    pub fn look_at_files(&mut self) {
        if let Some(told) = self.safety.look_at_files(&mut self.session) {
            self.message = Some(told);
        }
    }

    /// What is remembered.
    pub fn settings(&self) -> &Settings {
        &self.safety.settings
    }

    /// Changes what is remembered, and saves it.
    pub fn change_settings(&mut self, change: impl FnOnce(&mut Settings)) {
        self.safety.change_settings(change);
    }

    /// What was told last.
    pub fn message(&self) -> Option<&str> {
        self.message.as_deref()
    }

    /// Never opens a dialog of the system; for programs that drive the window.
    #[must_use]
    pub fn without_dialogs(mut self) -> Self {
        self.dialogs.way = DialogKind::Silent;
        self
    }

    /// Asks for paths in the window itself, and never opens a dialog of the system.
    #[must_use]
    pub fn with_path_fields(mut self) -> Self {
        self.dialogs.way = DialogKind::Window;
        self
    }

    /// Answers the next dialog that would ask for a file with this one; for programs that drive the
    /// window.
    pub fn answer_dialog(&mut self, path: &Path) {
        self.dialogs.prepared.push_back(path.to_owned());
    }

    /// Waits so long for the picture of a drag before a frame is shown without it. A software GPU
    /// takes long on a busy machine.
    pub fn wait_for_pictures(&mut self, time: Duration) {
        if let Some(picture) = &mut self.bench.picture {
            picture.patience = time;
        }
    }

    /// Writes the picture, in so many pixels, to a PNG file; what becomes of it is told in the
    /// status bar.
    pub fn save_picture(&mut self, size: [u32; 2], path: &Path) {
        self.bench.viewport.export(&self.session, PictureExport::Picture(size), path.to_owned());
    }

    /// Writes the look on a ball, so many pixels wide, to a PNG file, as an image for a LitSphere
    /// node.
    pub fn bake_litsphere(&mut self, side: u32, path: &Path) {
        self.bench.viewport.export(&self.session, PictureExport::LitSphere(side), path.to_owned());
    }

    /// Shows an image beside the picture, to work from.
    pub fn show_reference(&mut self, path: &Path) {
        self.bench.viewport.show_reference(path.to_owned());
    }

    /// The open look.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The open look, for programs that drive the window.
    pub fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The canvas.
    pub fn canvas(&self) -> &Canvas {
        &self.bench.canvas
    }

    /// The canvas, for programs that drive the window.
    pub fn canvas_mut(&mut self) -> &mut Canvas {
        &mut self.bench.canvas
    }

    /// The viewport.
    pub fn viewport(&self) -> &Viewport {
        &self.bench.viewport
    }

    /// The probe.
    pub fn probe(&self) -> &Probe {
        &self.bench.tools.probe
    }

    /// The painting workspace.
    pub fn painting(&self) -> &Painting {
        &self.bench.painting
    }

    /// The comparison with a tier or the truth.
    pub fn wipe(&self) -> &Wipe {
        &self.bench.tools.wipe
    }

    /// Painted light.
    pub fn fitting(&self) -> &Fitting {
        &self.bench.tools.fitting
    }

    /// Painted light, for programs that drive the window.
    pub fn fitting_mut(&mut self) -> &mut Fitting {
        &mut self.bench.tools.fitting
    }

    /// What was measured.
    pub fn cost(&self) -> &Cost {
        &self.bench.cost
    }

    /// How the panels share the window, where that changed since it was asked for last: to be
    /// remembered.
    pub fn changed_arrangement(&mut self) -> Option<serde_json::Value> {
        self.dock.changed()
    }

    /// Arranges the panels as they were; what cannot be read changes nothing.
    pub fn arrange(&mut self, saved: &serde_json::Value) {
        self.dock.restore(saved);
        self.laid_out_for = None;
    }

    /// Whether shaders, pictures or values are being made.
    pub fn is_busy(&self) -> bool {
        self.is_drawing()
            || self.session.is_compiling()
            || self.bench.is_busy()
            || self.look_exports.is_busy()
    }

    /// Waits for them; for tests.
    pub fn wait(&self) {
        self.session.wait();
        self.bench.wait();
        self.look_exports.wait();
        if let Some(picture) = &self.bench.picture {
            picture.wait();
        }
    }

    /// Whether the first picture of what is open is being made, while there is one of something
    /// else.
    pub fn is_preparing(&self) -> bool {
        let awaited =
            self.bench.picture.as_ref().and_then(|picture| picture.awaited(&self.session));
        matches!(awaited, Some(MissingPicture::Shader | MissingPicture::Picture))
    }

    /// Whether a picture was asked for that is not handed to the GPU yet.
    pub fn is_drawing(&self) -> bool {
        self.bench.picture.as_ref().is_some_and(Picture::is_busy)
    }

    /// How many pictures were asked for.
    pub fn pictures(&self) -> u64 {
        self.bench.picture.as_ref().map_or(0, |picture| picture.wishes)
    }

    /// How many times coarser than the screen the picture is; 1 at rest.
    pub fn coarseness(&self) -> u32 {
        self.bench.picture.as_ref().map_or(1, Picture::coarseness)
    }

    /// How many small pictures of layers and looks there are.
    pub fn small_pictures(&self) -> usize {
        self.bench.thumbs.count()
    }

    /// Shows the window for one frame.
    pub fn show(&mut self, ui: &mut Ui) {
        keyboard::begin_frame(ui.ctx());
        if ui.input(|input| input.pointer.any_pressed()) {
            self.presses += 1;
        }
        self.sheet.take_escape(ui);
        self.leave_start_page();
        self.give_up_drag(ui);
        let mut commands = Vec::new();
        if self.start.is_none() {
            self.bench.canvas.claim_tab(ui);
        }
        self.shortcuts(ui, &mut commands);
        self.take_look_exports(ui);
        self.message = self.bench.painting.exported().or(self.message.take());
        self.take_made();
        let dropped =
            ui.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_path_buf()));
        let adds = self.adds_what_is_dropped(ui);
        commands.extend(dropped.map(|path| {
            let ending = path
                .extension()
                .and_then(|ending| ending.to_str())
                .unwrap_or_default()
                .to_lowercase();
            match ending.as_str() {
                mesh if MESHES.contains(&mesh) && adds => {
                    Command::Scene(SceneCommand::Chosen(FilePurpose::AddMesh, path))
                }
                mesh if MESHES.contains(&mesh) => Command::ShowOn(Some(path)),
                image if IMAGES.contains(&image) => Command::ShowReference(Some(path)),
                _ => Command::Open(Some(path)),
            }
        }));
        commands.extend(self.chosen_files(ui));
        if let Some(again) = self.session.tick(ui.input(|input| input.time)) {
            ui.ctx().request_repaint_after(again);
        }
        self.session.awaits_first_picture = self.awaits_first_picture();
        self.begin_panels(ui);
        self.session.refresh_keys();
        self.session.follow_keys(ui.input(|input| input.pointer.any_down()));
        self.tick_painting();
        let fitted = self.bench.tools.fitting.tick(ui, &self.session);
        fitted.into_iter().for_each(|command| self.carry_out(ui, command));
        let (now, has_come_back) = ui
            .input(|input| (input.time, input.events.contains(&egui::Event::WindowFocused(true))));
        let (told, again) = self.safety.tick(now, has_come_back, &mut self.session);
        self.message = told.or(self.message.take());
        if let Some(again) = again {
            ui.ctx().request_repaint_after(again);
        }
        self.session.refresh_shown_look();
        self.panels(ui, &mut commands);
        self.ask_about_changes(ui, &mut commands);
        commands.extend(self.bench.painting.ask(ui, &self.session));
        commands.extend(self.sheet.show(ui, &self.session));
        self.show_tour(ui, &mut commands);
        for command in commands {
            self.apply(ui, command);
            // What was changed in this frame is seen in the next one.
            ui.ctx().request_repaint();
        }
        self.lay_out();
        let is_held = ui.input(|input| input.pointer.any_down());
        self.session.commit(is_held);
        // A panel is resized in many steps; where it ends is remembered.
        if !is_held {
            let layout = self.safety.remembers().then(|| self.dock.changed()).flatten();
            self.safety.remember(appearance::current(ui.ctx()), layout);
        } else if let Some(picture) = &mut self.bench.picture {
            self.session.refresh_shown_look();
            picture.hurry(&self.session);
        }
        self.close_or_stay(ui.ctx());
        self.set_title(ui.ctx());
    }

    /// Lays the panels out for painting once what is painted is shown, and for looks once another
    /// look is open. Edits of the look move nothing: only what is opened and closed does.
    pub(super) fn lay_out(&mut self) {
        let open = (self.session.document_number(), self.painting_number());
        if self.laid_out_for != Some(open) {
            self.laid_out_for = Some(open);
            let is_painted = crate::state::painting::look::shows(&self.session);
            self.dock.enter(if is_painted { Workspace::Painting } else { Workspace::Look });
            if !is_painted {
                if let Some(view) = self.view_before_painting.given_back(&self.session) {
                    self.session.view.orbit = view;
                }
            }
        }
    }

    fn panels(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        Panel::top("bar")
            .frame(theme::panel(ui))
            .resizable(false)
            .show(ui, |ui| self.bar(ui, commands));
        self.safety.forget_old_notes(&self.session);
        commands.extend(self.safety.show(ui, &self.session).into_iter().map(Command::Recovery));
        if let Some(picture) = &self.bench.picture {
            self.session.set_picture_problems(&picture.problems);
        }
        // Of one height, whatever it says, so that nothing above moves under a hand.
        let status =
            Panel::bottom("status").frame(theme::panel(ui)).resizable(false).exact_size(STATUS);
        status.show(ui, |ui| {
            commands.extend(self.status(ui));
        });
        if self.bench.picture.as_ref().is_some_and(Picture::is_unfinished) {
            ui.ctx().request_repaint_after(UNFINISHED);
        }
        if self.start.is_some() {
            return self.start_page(ui, commands);
        }
        let mut dock = std::mem::take(&mut self.dock);
        let ground = egui::Frame::new().fill(theme::of(ui).node_edge);
        egui::CentralPanel::default().frame(ground).show(ui, |ui| {
            dock.show(ui, &mut |ui, panel| self.panel(ui, panel, commands));
        });
        self.dock = dock;
    }

    /// Does what is due for panels once a frame, before anything is drawn.
    fn begin_panels(&mut self, ui: &Ui) {
        for row in PANELS {
            let Some(each_frame) = row.each_frame else { continue };
            let presence = match self.dock.has(row.id) {
                true if self.start.is_none() && self.dock.shows(row.id) => Presence::Seen,
                true => Presence::Hidden,
                false => Presence::Absent,
            };
            let commands = each_frame(&mut self.bench, ui, &self.session, presence);
            commands.into_iter().for_each(|command| self.carry_out(ui, command));
        }
    }

    /// Draws a panel. What the pointer does there to the view and to strokes is drawn already.
    fn panel(&mut self, ui: &mut Ui, panel: &PanelRow, commands: &mut Vec<Command>) {
        spots::note(ui, spots::Spot::Panel(panel.id), ui.max_rect());
        if let Some(interact) = panel.interact {
            let context = PanelContext { session: &self.session, safety: &self.safety };
            for command in interact(&mut self.bench, ui, context) {
                match command.is_drawn_at_once() {
                    true => self.carry_out(ui, command),
                    false => commands.push(command),
                }
            }
        }
        let context = PanelContext { session: &self.session, safety: &self.safety };
        commands.extend((panel.draw)(&mut self.bench, ui, context));
    }

    /// What painting needs once a frame: whether what is painted is seen, and what rules filled.
    fn tick_painting(&mut self) {
        let update = self.bench.painting.tick(&self.session);
        self.session.update_painting(update);
        if let Some(work) = self.session.painting_mut()
            && self.bench.painting.fill(work)
        {
            self.session.painting_changed();
        }
    }

    /// Whether the first picture is on its way. Behind the start page none is asked for.
    fn awaits_first_picture(&self) -> bool {
        let is_awaited = |picture: &Picture| !picture.is_there() && picture.problems.is_empty();
        self.start.is_none()
            && self.dock.shows(PanelId::PICTURE)
            && self.bench.picture.as_ref().is_some_and(is_awaited)
            && !has_errors(self.session.problems())
    }

    fn has_picture(&self) -> bool {
        self.bench.picture.as_ref().is_some_and(Picture::is_there)
    }

    /// Takes what left the window as a shader.
    fn take_look_exports(&mut self, ui: &Ui) {
        for done in self.look_exports.answers() {
            let (copied, told) = match done {
                LookExportResult::Told(told) => (None, told),
                LookExportResult::Copied(text, told) => (Some(text), told),
            };
            copied.into_iter().for_each(|text| ui.ctx().copy_text(text));
            self.message = Some(told);
        }
    }

    fn shortcuts(&self, ui: &Ui, commands: &mut Vec<Command>) {
        let is_typing = keyboard::is_keyboard_taken(ui.ctx());
        // A field that is being typed in has an undo of its own, and question marks.
        let is_text = |command: &Command| {
            matches!(command, Command::Undo | Command::Redo | Command::OpenShortcuts)
        };
        // The other keys of the picture work over it alone, where it takes them itself.
        let is_here = |row: &&CommandRow| {
            let turns_tool =
                matches!(row.command, Command::Probe(_) | Command::Fit(FitCommand::Turn(_)));
            row.place == Place::Window || turns_tool
        };
        for row in table::rows().filter(is_here) {
            if keyboard::is_dialog_open(ui.ctx())
                || row.place == Place::Picture
                    && (is_typing || self.start.is_some() || self.bench.painting.has_pointer())
                || is_typing && is_text(&row.command)
            {
                continue;
            }
            if row.keys.iter().any(|&key| keyboard::take(ui, key)) {
                commands.push(row.command.clone());
            }
        }
        let escape = (Modifiers::NONE, Key::Escape);
        let is_free = self.path_field.is_none()
            && self.pending.is_none()
            && !egui::Popup::is_any_open(ui.ctx());
        if self.start.is_some() && is_free && keyboard::take(ui, escape) {
            commands.push(Command::ShowStart(false));
        }
        // A picker or a menu that is open takes the key first: it would stay open else.
        let is_open = egui::Popup::is_any_open(ui.ctx());
        if self.bench.tools.probe.is_on() && !is_typing && !is_open && keyboard::take(ui, escape) {
            commands.push(Command::LeaveProbe);
        }
        let paints = self.bench.tools.fitting.is_on() && self.start.is_none();
        if paints && is_free && !is_typing && !is_open && keyboard::take(ui, escape) {
            commands.push(Command::Fit(FitCommand::Leave));
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        // What the last frame showed is on the screen when the next one begins.
        if std::mem::take(&mut self.shows_first_picture) {
            milestones::reached("picture on the screen");
        }
        let had_picture = self.has_picture();
        self.show(ui);
        milestones::reached("first frame");
        if self.has_picture() && !had_picture && milestones::are_told() {
            self.shows_first_picture = true;
            ui.ctx().request_repaint();
        }
    }

    fn on_exit(&mut self) {
        self.session.close_journal(true);
        self.session.journals.crashes.close();
    }
}
