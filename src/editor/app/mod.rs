//! Window of the editor: panels around the canvas. Their commands are applied in one place,
//! `apply`.

mod appearance;
mod apply;
mod bar;
mod closing;
mod colors;
pub(crate) mod dialogs;
pub(crate) mod dock;
mod files;
mod film;
mod fitting;
mod library;
pub(crate) mod look_export;
mod masking;
mod painting;
pub(crate) mod path_field;
mod placing;
mod recovery;
pub(crate) mod recovery_bar;
mod scene;
pub(crate) mod shortcuts_and_palette;
mod snapshots;
pub(crate) mod tour;
mod welcome;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use eframe::egui::{self, Key, Modifiers, OpenUrl, Panel, Ui};

use crate::app::dialogs::{DialogKind, Dialogs};
use crate::app::dock::{Dock, Workspace};
use crate::app::look_export::{LookExportResult, LookExports, address_of};
use crate::app::path_field::PathField;
use crate::app::shortcuts_and_palette::Sheet;
use crate::app::tour::Tour;
use crate::canvas::Canvas;
use crate::commands::table::{self, CommandRow, KeyScope};
use crate::commands::{
    Command, FilePurpose, FilmCommand, FitCommand, IMAGES, MESHES, MaskCommand, PanelId,
    PictureExport, PlacingCommand, SceneCommand, ViewCommand, keyboard,
};
use crate::diag::has_errors;
use crate::document::Target;
use crate::files::{Disk, SharedFiles};
use crate::library::Library;
use crate::milestones;
use crate::painter::Painting;
use crate::painter::before::ViewBefore;
use crate::panels::cost::Cost;
use crate::panels::{PANELS, PanelContext, PanelRow, Presence, Workbench};
use crate::state::revision::{DocumentNumber, PaintingNumber};
use crate::state::safety::Safety;
use crate::state::safety::places::Places;
use crate::state::session::Session;
use crate::state::session::painting::is_painting_shown;
use crate::state::settings::Settings;
use crate::state::wedge::WedgeSheet;
use crate::tools::fitting::FitTool;
use crate::tools::masking::MaskTool;
use crate::tools::placing::PlacingTool;
use crate::tools::playback::Playback;
use crate::tools::probe::Probe;
use crate::tools::wipe::Wipe;
use crate::viewport::Viewport;
use crate::viewport::picture::{MissingPicture, ViewportPicture};
use crate::widgets::pacing::EventPacer;
use crate::widgets::{number, spots, theme};
use files::PendingAction;
use welcome::StartPage;

/// Interval at which the GPU is asked whether it has finished a first drawing.
const UNFINISHED: Duration = Duration::from_millis(30);
/// Height of the status bar, in points.
const STATUS: f32 = 38.0;

/// State of the window.
pub struct App {
    session: Session,
    bench: Workbench,
    dialogs: Dialogs,
    dock: Dock,
    look_exports: LookExports,
    colors: colors::ColorOpener,
    safety: Safety,
    sheet: Sheet,
    start: Option<StartPage>,
    tour: Option<Tour>,
    path_field: Option<PathField>,
    /// Input that an image was asked for.
    asked_image: Option<Target>,
    /// Action to carry out once unsaved changes are dealt with.
    pending: Option<PendingAction>,
    /// Message about a file or an edit, until the next command.
    message: Option<String>,
    /// File that has what the last message says could not be changed here.
    refused: Option<PathBuf>,
    /// Number of presses of the pointer: together with a widget and the keyboard's focus they
    /// identify the gesture that edits.
    presses: u64,
    closes: bool,
    /// True if the user is asked whether closing is to stop what runs beside the window.
    asks_to_stop: bool,
    /// True if the last frame was the first one with a picture, where that milestone is reported.
    shows_first_picture: bool,
    /// The look and the painting that the panels were last laid out for.
    laid_out_for: Option<(DocumentNumber, Option<PaintingNumber>)>,
    /// View before a painting's flat square.
    view_before_painting: ViewBefore,
    /// File of the program that renders frames beside the window: its own.
    program: Option<PathBuf>,
}

impl App {
    /// Creates a window with a new look. `render_state` is the device to draw with, if there is
    /// one.
    pub fn new(ctx: &egui::Context, render_state: Option<eframe::egui_wgpu::RenderState>) -> Self {
        Self::reading_from(Arc::new(Disk), ctx, render_state)
    }

    /// Creates a window with a new look, as [`new`](Self::new) does. What documents name is read
    /// from `files`.
    pub fn reading_from(
        files: SharedFiles,
        ctx: &egui::Context,
        render_state: Option<eframe::egui_wgpu::RenderState>,
    ) -> Self {
        theme::apply(ctx);
        ctx.add_plugin(EventPacer::default());
        ctx.set_theme(egui::ThemePreference::Dark);
        let waker = || {
            let ctx = ctx.clone();
            move || ctx.request_repaint()
        };
        let library = Arc::new(Library::built_in().clone());
        let session = Session::reading_from(files, library, waker());
        let crashes = || session.journals.crashes.clone();
        let picture = render_state.map(|state| ViewportPicture::new(state, crashes(), waker()));
        let gpu = picture.as_ref().map(|picture| picture.gpu().clone());
        let bench = Workbench::new(picture, crashes(), waker());
        Self {
            session,
            bench,
            dialogs: Dialogs::new(waker()),
            dock: Dock::default(),
            look_exports: LookExports::new(gpu, waker()),
            colors: colors::ColorOpener::new(waker()),
            safety: Safety::new(waker()),
            sheet: Sheet::default(),
            start: None,
            tour: None,
            path_field: None,
            asked_image: None,
            pending: None,
            message: None,
            refused: None,
            presses: 0,
            closes: false,
            asks_to_stop: false,
            shows_first_picture: false,
            laid_out_for: None,
            view_before_painting: ViewBefore::default(),
            program: std::env::current_exe().ok(),
        }
    }

    /// Shows the look, or of a scene the selected object, on a mesh: a path, or `shape:` and the
    /// name of a built-in shape. Problems of the mesh are listed with the others; the last good
    /// picture stays.
    pub fn show_on(&mut self, mesh: &str) {
        if self.session.open_scene().is_some() {
            return self.mesh_of_object(mesh);
        }
        self.session.view.orbit.show_on(mesh);
        self.safety.shown_on(mesh, self.session.view.orbit.z_is_up);
    }

    /// Stands up a mesh whose z axis points up, or lays it back.
    pub(super) fn stand_up(&mut self, z_is_up: bool) {
        self.session.view.orbit.z_is_up = z_is_up;
        self.safety.shown_on(&self.session.view.orbit.mesh, z_is_up);
    }

    /// Keeps unsaved work and settings in these folders, and offers work that was left behind
    /// there.
    pub fn keep_in(&mut self, places: Places, ctx: &egui::Context) {
        let waker = ctx.clone();
        self.safety.keep_in(places, &mut self.session, move || waker.request_repaint());
        appearance::apply(&self.safety.settings, ctx);
        self.bench.tools.playback().set_memory(self.safety.settings.frame_memory);
        self.show_by_settings();
        if let Some(layout) = self.safety.settings.layout.clone() {
            self.dock.restore(&layout);
        }
    }

    /// Resumes the work of the last window that was closed, if anything was not saved then.
    pub fn resume(&mut self) {
        let painting = self.painting_number();
        self.message = self.safety.resume(&mut self.session);
        self.open_lacking_look();
        self.play_frames_of_shot();
        self.show_painting_taken_back(painting);
    }

    /// Checks at once whether other programs changed files, which otherwise takes a moment.
    pub fn look_at_files(&mut self) {
        if let Some(told) = self.safety.look_at_files(&mut self.session) {
            self.message = Some(told);
        }
    }

    /// Settings of the window.
    pub fn settings(&self) -> &Settings {
        &self.safety.settings
    }

    /// Changes the settings, and saves them.
    pub fn change_settings(&mut self, change: impl FnOnce(&mut Settings)) {
        self.safety.change_settings(change);
    }

    /// The last message.
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

    /// Renders frames beside the window by the program of this file; for programs that drive the
    /// window, which are no `chiaro` themselves.
    #[must_use]
    pub fn rendering_by(mut self, program: &Path) -> Self {
        self.program = Some(program.to_owned());
        self
    }

    /// Answers the next dialog for a file with `path`; for programs that drive the window.
    pub fn answer_dialog(&mut self, path: &Path) {
        self.dialogs.prepared.push_back(path.to_owned());
    }

    /// Sets the longest wait for the picture of a drag before a frame is shown without it. A
    /// software GPU takes long on a busy machine.
    pub fn wait_for_pictures(&mut self, time: Duration) {
        if let Some(picture) = &mut self.bench.picture {
            picture.patience = time;
        }
    }

    /// Writes the picture, `size` in pixels, to a PNG file; the status bar reports the result.
    pub fn save_picture(&mut self, size: [u32; 2], path: &Path) {
        self.bench.viewport.export(&self.session, PictureExport::Picture(size), path.to_owned());
    }

    /// Writes the look on a ball to a PNG file, as an image for a LitSphere node. `side` is its
    /// width in pixels.
    pub fn bake_litsphere(&mut self, side: u32, path: &Path) {
        self.bench.viewport.export(&self.session, PictureExport::LitSphere(side), path.to_owned());
    }

    /// Shows an image beside the picture, to work from.
    pub fn show_reference(&mut self, path: &Path) {
        self.bench.viewport.show_reference(&self.session, path.to_owned());
    }

    /// Session of the open look.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// Session of the open look, for programs that drive the window.
    pub fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// Canvas of the window.
    pub fn canvas(&self) -> &Canvas {
        &self.bench.canvas
    }

    /// Canvas of the window, for programs that drive it.
    pub fn canvas_mut(&mut self) -> &mut Canvas {
        &mut self.bench.canvas
    }

    /// Viewport of the window.
    pub fn viewport(&self) -> &Viewport {
        &self.bench.viewport
    }

    /// Probe of the picture.
    pub fn probe(&self) -> &Probe {
        self.bench.tools.of()
    }

    /// Painting workspace.
    pub fn painting(&self) -> &Painting {
        &self.bench.painting
    }

    /// Tool that places a light by what it does.
    pub fn placing(&self) -> &PlacingTool {
        self.bench.tools.of()
    }

    /// Comparison of the picture with a tier or the truth.
    pub fn wipe(&self) -> &Wipe {
        self.bench.tools.of()
    }

    /// Number of frames of the timeline that are kept, and of those that were drawn for it.
    pub fn frames(&self) -> [u64; 2] {
        let playback = self.bench.tools.of::<Playback>();
        [playback.cache().frames().count() as u64, playback.drawn()]
    }

    /// Memory of the frames that are kept, in bytes.
    pub fn frame_bytes(&self) -> usize {
        self.bench.tools.of::<Playback>().cache().bytes()
    }

    /// Light painted on the picture, and the look fitted to it.
    pub fn fitting(&self) -> &FitTool {
        self.bench.tools.of()
    }

    /// Light painted on the picture, for programs that drive the window.
    pub fn fitting_mut(&mut self) -> &mut FitTool {
        self.bench.tools.of_mut()
    }

    /// Measured cost of the look.
    pub fn cost(&self) -> &Cost {
        &self.bench.cost
    }

    /// Names of all panels, in the order of menus, in English.
    pub fn panel_names() -> impl Iterator<Item = &'static str> {
        PANELS.iter().map(|row| row.label.english())
    }

    /// Place of the panel of this English name, with the row of tabs above it, while it is seen.
    pub fn panel_place(&self, name: &str) -> Option<eframe::egui::Rect> {
        let row = PANELS.iter().find(|row| row.label.english() == name)?;
        self.dock.place(row.id)
    }

    /// Saved form of the panels' layout, where it changed since the last call.
    pub fn changed_arrangement(&mut self) -> Option<serde_json::Value> {
        self.dock.changed()
    }

    /// Lays the panels out as saved; a layout that cannot be read changes nothing.
    pub fn arrange(&mut self, saved: &serde_json::Value) {
        self.dock.restore(saved);
        self.laid_out_for = None;
    }

    /// True while shaders, pictures or values are being made.
    pub fn is_busy(&self) -> bool {
        self.is_drawing()
            || self.session.is_compiling()
            || self.bench.is_busy()
            || self.look_exports.is_busy()
            || self.colors.is_busy()
    }

    /// Waits until shaders, pictures and values are made; for tests.
    pub fn wait(&self) {
        self.session.wait();
        self.bench.wait();
        self.look_exports.wait();
        self.colors.wait();
        if let Some(picture) = &self.bench.picture {
            picture.wait();
        }
    }

    /// True while the first picture of the open document is being made and an older picture of
    /// another one is shown.
    pub fn is_preparing(&self) -> bool {
        let awaited =
            self.bench.picture.as_ref().and_then(|picture| picture.awaited(&self.session));
        matches!(awaited, Some(MissingPicture::Shader | MissingPicture::Picture))
    }

    /// True if a picture was requested that is not handed to the GPU yet.
    pub fn is_drawing(&self) -> bool {
        self.bench.picture.as_ref().is_some_and(ViewportPicture::is_busy)
    }

    /// Number of requested pictures.
    pub fn pictures(&self) -> u64 {
        self.bench.picture.as_ref().map_or(0, |picture| picture.requested.count())
    }

    /// Ratio of the screen's resolution to the picture's; 1 at rest.
    pub fn coarseness(&self) -> u32 {
        self.bench.picture.as_ref().map_or(1, ViewportPicture::coarseness)
    }

    /// Number of small pictures of layers and looks.
    pub fn small_pictures(&self) -> usize {
        self.bench.thumbs.count()
    }

    /// Shows the window for one frame.
    pub fn show(&mut self, ui: &mut Ui) {
        keyboard::begin_frame(ui.ctx());
        keyboard::set_pointed(ui.ctx(), self.pointed_keys(ui));
        if ui.input(|input| input.pointer.any_pressed()) {
            self.presses += 1;
        }
        self.sheet.take_escape(ui);
        self.leave_start_page();
        self.give_up_drag(ui);
        let mut commands = Vec::new();
        if self.start.is_none() && !self.bench.wedge.is_large() {
            self.bench.canvas.claim_tab(ui);
        }
        self.sheet.keep_early(ui);
        self.shortcuts(ui, &mut commands);
        let typed_in = keyboard::text_field(ui.ctx()).filter(|_| !commands.is_empty());
        // A field that waits for its end takes its text before Ctrl+S or another key of the window
        // does its work.
        let of_keys = typed_in.map(|field| {
            ui.memory_mut(|memory| memory.surrender_focus(field));
            std::mem::take(&mut commands)
        });
        self.take_look_exports(ui);
        self.take_colors();
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
                image if IMAGES.contains(&image) && WedgeSheet::read(&path).is_none() => {
                    Command::ShowReference(Some(path))
                }
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
        let fitted = self.bench.tools.of_mut::<FitTool>().tick(ui, &self.session);
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
        self.ask_to_stop(ui);
        self.ask_about_changes(ui, &mut commands);
        commands.extend(self.bench.painting.ask(ui, &self.session));
        commands.extend(self.sheet.show(ui, &self.session));
        self.show_tour(ui, &mut commands);
        commands.extend(of_keys.into_iter().flatten());
        if let Some(field) = typed_in.filter(|_| commands.contains(&Command::Save)) {
            ui.memory_mut(|memory| memory.request_focus(field));
        }
        for command in commands {
            self.apply(ui, command);
            // A change of this frame is only seen in the next one.
            ui.ctx().request_repaint();
        }
        self.message = number::take_note(ui.ctx()).or(self.message.take());
        self.lay_out();
        let is_held = ui.input(|input| input.pointer.any_down());
        self.session.commit(is_held);
        // A panel is resized in many steps; only the last one is remembered.
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

    /// Lays the panels out for painting once the painting is shown, and for looks once another look
    /// is open. Only opening and closing moves panels: edits of the look do not.
    pub(super) fn lay_out(&mut self) {
        let open = (self.session.revisions().document, self.painting_number());
        if self.laid_out_for != Some(open) {
            self.laid_out_for = Some(open);
            self.bench.viewport.stop_looking_through();
            let is_painted = is_painting_shown(&self.session);
            self.dock.enter(if is_painted { Workspace::Painting } else { Workspace::Look });
            if !is_painted && let Some(view) = self.view_before_painting.given_back(&self.session) {
                self.session.view.orbit = view;
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
        // The height is fixed, whatever the text, so that nothing above moves under a hand.
        let status =
            Panel::bottom("status").frame(theme::panel(ui)).resizable(false).exact_size(STATUS);
        status.show(ui, |ui| {
            commands.extend(self.status(ui));
        });
        if self.bench.picture.as_ref().is_some_and(ViewportPicture::is_unfinished) {
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

    /// Runs each panel's work that is due once a frame, before anything is drawn.
    fn begin_panels(&mut self, ui: &Ui) {
        for row in PANELS {
            let Some(each_frame) = row.each_frame else {
                continue;
            };
            let presence = match self.dock.has(row.id) {
                true if self.start.is_none() && self.dock.shows(row.id) => Presence::Seen,
                true => Presence::Hidden,
                false => Presence::Absent,
            };
            let commands = each_frame(&mut self.bench, ui, &self.session, presence);
            commands.into_iter().for_each(|command| self.carry_out(ui, command));
        }
    }

    /// Draws a panel. The effects of the pointer there on the view and on strokes are in the
    /// drawing already.
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

    /// Runs the work of painting that is due once a frame: finds out whether the painting is seen,
    /// and takes the samples that rules filled.
    fn tick_painting(&mut self) {
        let update = self.bench.painting.tick(&self.session);
        self.session.update_painting(update);
        if let Some(work) = self.session.painting_mut()
            && self.bench.painting.fill(work)
        {
            self.session.painting_changed();
        }
    }

    /// True while the first picture is on its way. Behind the start page none is requested.
    fn awaits_first_picture(&self) -> bool {
        let is_awaited =
            |picture: &ViewportPicture| !picture.is_there() && picture.problems.is_empty();
        self.start.is_none()
            && self.dock.shows(PanelId::PICTURE)
            && self.bench.picture.as_ref().is_some_and(is_awaited)
            && !has_errors(self.session.compilation().problems())
    }

    fn has_picture(&self) -> bool {
        self.bench.picture.as_ref().is_some_and(ViewportPicture::is_there)
    }

    /// Takes the results of exported shaders.
    fn take_look_exports(&mut self, ui: &Ui) {
        for done in self.look_exports.answers() {
            self.message = Some(match done {
                LookExportResult::Told(told) => told,
                LookExportResult::Copied(text, told) => {
                    ui.ctx().copy_text(text);
                    told
                }
                LookExportResult::Opened(page, told) => {
                    ui.ctx().open_url(OpenUrl::new_tab(address_of(&page)));
                    told
                }
            });
        }
    }

    /// Place of keys under the pointer, by where the panels were in the last frame: a key that has
    /// several meanings does what it does there, whichever panel is shown first.
    fn pointed_keys(&self, ui: &Ui) -> Option<KeyScope> {
        let at = ui.input(|input| input.pointer.hover_pos()).filter(|_| self.start.is_none())?;
        if self.bench.painting.has_pointer() {
            return Some(KeyScope::Painting);
        }
        let is_over = |panel| self.dock.place(panel).is_some_and(|place| place.contains(at));
        match () {
            () if is_over(PanelId::GRAPH) && !self.bench.wedge.is_large() => Some(KeyScope::Graph),
            () if is_over(PanelId::PICTURE) && self.fitting().is_on() => Some(KeyScope::Light),
            () if is_over(PanelId::PICTURE) => Some(KeyScope::Picture),
            () => None,
        }
    }

    fn shortcuts(&self, ui: &Ui, commands: &mut Vec<Command>) {
        let is_typing = keyboard::is_keyboard_taken(ui.ctx());
        // A text field with the keyboard has an undo of its own, and takes question marks; a handle
        // that was dragged has not.
        let is_text_edited = is_typing && keyboard::text_field(ui.ctx()).is_some();
        let has_list = egui::Popup::is_any_open(ui.ctx());
        let is_text = |command: &Command| {
            matches!(command, Command::Undo | Command::Redo | Command::OpenShortcuts)
        };
        // Other keys of the picture work only under the pointer, where the picture takes them
        // itself.
        let is_here = |row: &&CommandRow| {
            let turns_tool =
                matches!(row.command, Command::Probe(_) | Command::Fit(FitCommand::Turn(_)));
            row.place == KeyScope::Window || turns_tool
        };
        for row in table::rows().filter(is_here) {
            if keyboard::is_dialog_open(ui.ctx())
                || row.place == KeyScope::Picture && (is_typing || has_list || self.start.is_some())
                || is_text_edited && is_text(&row.command)
            {
                continue;
            }
            if row.take(ui) {
                commands.push(row.command.clone());
            }
        }
        let escape = (Modifiers::NONE, Key::Escape);
        let is_free = self.path_field.is_none() && self.pending.is_none() && !has_list;
        if self.start.is_some() && is_free && keyboard::take(ui, escape) {
            commands.push(Command::ShowStart(false));
        }
        // An open picker or menu takes the key first; otherwise it would stay open.
        let is_open = egui::Popup::is_any_open(ui.ctx());
        if self.probe().is_on() && !is_typing && !is_open && keyboard::take(ui, escape) {
            commands.push(Command::LeaveProbe);
        }
        let places = self.bench.tools.of::<PlacingTool>().is_on() && self.start.is_none();
        if places && is_free && !is_typing && keyboard::take(ui, escape) {
            commands.push(Command::Placing(PlacingCommand::Leave));
        }
        let masks = self.bench.tools.of::<MaskTool>().is_on() && self.start.is_none();
        if masks && is_free && !is_typing && keyboard::take(ui, escape) {
            commands.push(Command::Mask(MaskCommand::Leave));
        }
        let looks_through = self.viewport().is_looking_through() && self.start.is_none();
        if looks_through && is_free && !is_typing && keyboard::take(ui, escape) {
            commands.push(Command::View(ViewCommand::LookThrough));
        }
        let paints = self.fitting().is_on() && self.start.is_none();
        if paints && is_free && !is_typing && !is_open && keyboard::take(ui, escape) {
            commands.push(Command::Fit(FitCommand::Leave));
        }
        let has_sheet = self.bench.wedge.is_large() && self.dock.shows(PanelId::GRAPH);
        let has_sheet = has_sheet && self.start.is_none();
        if has_sheet && is_free && !is_text_edited && keyboard::take(ui, escape) {
            commands.push(Command::Film(FilmCommand::EnlargeWedge(false)));
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        // The picture of the last frame is on the screen when the next frame begins.
        if std::mem::take(&mut self.shows_first_picture) {
            milestones::reached("picture on the screen");
        }
        let had_picture = self.has_picture();
        self.show(ui);
        milestones::reached("first frame");
        if self.has_picture() && !had_picture && milestones::is_enabled() {
            self.shows_first_picture = true;
            ui.ctx().request_repaint();
        }
    }

    fn on_exit(&mut self) {
        self.session.close_journal(true);
        self.session.journals.crashes.close();
    }
}
