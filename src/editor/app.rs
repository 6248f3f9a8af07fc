//! The window: panels around the canvas, and the one place that applies what they ask for.

use eframe::egui;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use eframe::egui::{Key, Modifiers, Panel, RichText, Ui, ViewportCommand};

use super::canvas::{Canvas, edits};
use super::code::Code;
use super::command::Command;
use super::cost::Cost;
use super::curves::keys::Keys;
use super::curves::profile::Profile;
use super::curves::timeline::Timeline;
use super::dialogs::{Dialogs, IMAGES, MESHES, Purpose};
use super::dock::Dock;
use super::dock::effects::Effects;
use super::panels::{Panels, library, problems, solo};
use super::picture::Picture;
use super::probe::{Probe, picture_size};
use super::safety::Safety;
use super::safety::places::Places;
use super::session::Session;
use super::settings::Settings;
use super::sheet::Sheet;
use super::shortcuts::{self, Action, Place};
use super::viewport::{Export, Viewport};
use super::wipe::Wipe;
use super::{dock, inspector, theme};
use crate::diag::Diagnostic;
use crate::document::Edit;
use crate::library::Library;

/// The height of the status bar, in points.
const STATUS: f32 = 38.0;

/// The window's state.
pub struct App {
    session: Session,
    canvas: Canvas,
    viewport: Viewport,
    code: Code,
    picture: Option<Picture>,
    dialogs: Dialogs,
    dock: Dock,
    effects: Effects,
    probe: Probe,
    wipe: Wipe,
    cost: Cost,
    profile: Profile,
    keys: Keys,
    timeline: Timeline,
    panels: Panels,
    safety: Safety,
    sheet: Sheet,
    /// What is done once unsaved changes are dealt with.
    pending: Option<Pending>,
    /// What went wrong with a file or an edit, until the next command.
    message: Option<String>,
    /// Presses of the pointer, and what had the keyboard: together with a widget they are the hand that edits.
    presses: u64,
    closes: bool,
}

/// What would lose unsaved changes.
#[derive(Clone, Debug, PartialEq)]
enum Pending {
    New,
    Open(PathBuf),
    Example(usize),
    Close,
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
        let picture = render_state.map(|state| Picture::new(state, waker()));
        let wipe = Wipe::new(picture.as_ref().map(|picture| picture.gpu().clone()), waker());
        let viewport = Viewport::new(picture.as_ref().map(|picture| picture.gpu().clone()), waker());
        let cost = Cost::new(picture.as_ref().map(|picture| picture.gpu().clone()), waker());
        let panels = Panels::new(picture.as_ref().map(|picture| picture.gpu().clone()), waker());
        Self {
            session: Session::new(library, waker()),
            canvas: Canvas::default(),
            viewport,
            code: Code::default(),
            picture,
            dialogs: Dialogs::new(waker()),
            dock: Dock::default(),
            effects: Effects::default(),
            probe: Probe::new(waker()),
            wipe,
            cost,
            profile: Profile::default(),
            keys: Keys::default(),
            timeline: Timeline::default(),
            panels,
            safety: Safety::new(waker()),
            sheet: Sheet::default(),
            pending: None,
            message: None,
            presses: 0,
            closes: false,
        }
    }

    /// Shows the look on a mesh: a path, or `shape:` and the name of an own shape. What is wrong with it is told where
    /// problems are; the last good picture stays.
    pub fn show_on(&mut self, mesh: &str) {
        mesh.clone_into(&mut self.session.view.mesh);
        self.safety.shown_on(mesh);
    }

    /// Keeps unsaved work and settings in these folders, and offers what was left behind there.
    pub fn keep_in(&mut self, places: Places, ctx: &egui::Context) {
        let waker = ctx.clone();
        self.safety.keep_in(places, &mut self.session, move || waker.request_repaint());
        self.safety.settings.apply(ctx);
        if let Some(layout) = self.safety.settings.layout.clone() {
            self.dock.restore(&layout);
        }
    }

    /// Goes on where the last window was closed, if anything was not saved then.
    pub fn resume(&mut self) {
        self.message = self.safety.resume(&mut self.session);
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
        self.dialogs.is_silent = true;
        self
    }

    /// Writes the picture, in so many pixels, to a PNG file; what becomes of it is told in the status bar.
    pub fn save_picture(&mut self, size: [u32; 2], path: &Path) {
        self.viewport.export(&self.session, Export::Picture(size), path.to_owned());
    }

    /// Writes the look on a ball, so many pixels wide, to a PNG file, as an image for a LitSphere node.
    pub fn bake_litsphere(&mut self, side: u32, path: &Path) {
        self.viewport.export(&self.session, Export::LitSphere(side), path.to_owned());
    }

    /// Shows an image beside the picture, to work from.
    pub fn show_reference(&mut self, path: &Path) {
        self.viewport.show_reference(path.to_owned());
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
        &self.canvas
    }

    /// The canvas, for programs that drive the window.
    pub fn canvas_mut(&mut self) -> &mut Canvas {
        &mut self.canvas
    }

    /// The viewport.
    pub fn viewport(&self) -> &Viewport {
        &self.viewport
    }

    /// The probe.
    pub fn probe(&self) -> &Probe {
        &self.probe
    }

    /// The comparison with a tier or the truth.
    pub fn wipe(&self) -> &Wipe {
        &self.wipe
    }

    /// What was measured.
    pub fn cost(&self) -> &Cost {
        &self.cost
    }

    /// How the panels share the window, where that changed since it was asked for last: to be remembered.
    pub fn changed_arrangement(&mut self) -> Option<serde_json::Value> {
        self.dock.changed()
    }

    /// Arranges the panels as they were; what cannot be read changes nothing.
    pub fn arrange(&mut self, saved: &serde_json::Value) {
        self.dock.restore(saved);
    }

    /// Whether shaders, pictures or values are being made.
    pub fn is_busy(&self) -> bool {
        let is_drawing = self.picture.as_ref().is_some_and(Picture::is_busy) || self.viewport.is_busy();
        is_drawing
            || self.session.is_compiling()
            || self.canvas.is_busy()
            || self.probe.is_busy()
            || self.wipe.is_busy()
            || self.cost.is_busy()
            || self.panels.is_busy()
    }

    /// Waits for them; for tests.
    pub fn wait(&self) {
        self.session.wait();
        self.canvas.wait();
        self.probe.wait();
        self.viewport.wait();
        self.wipe.wait();
        self.cost.wait();
        self.panels.wait();
        if let Some(picture) = &self.picture {
            picture.wait();
        }
    }

    /// How many pictures were asked for.
    pub fn pictures(&self) -> u64 {
        self.picture.as_ref().map_or(0, |picture| picture.wishes)
    }

    /// How many times coarser than the screen the picture is; 1 at rest.
    pub fn coarseness(&self) -> u32 {
        self.picture.as_ref().map_or(1, Picture::coarseness)
    }

    /// How many small pictures of layers and looks there are.
    pub fn small_pictures(&self) -> usize {
        self.panels.pictures()
    }

    /// Opens a look and tells where that fails.
    pub fn open(&mut self, path: &Path) {
        if let Some(told) = self.safety.reopen(path, &mut self.session) {
            self.message = Some(told).filter(|told| !told.is_empty());
        } else {
            let is_open = self.session.open(path);
            self.message = (!is_open).then(|| format!("{} could not be opened", path.display()));
        }
        if self.message.is_none() {
            self.safety.opened(path);
        }
        self.safety.look();
    }

    /// Saves to a file and tells where that fails.
    pub fn save_as(&mut self, path: &Path) -> bool {
        match self.session.save_as(path) {
            Ok(()) => {
                self.message = Some(format!("Saved {}", path.display()));
                self.safety.opened(path);
                true
            }
            Err(problem) => {
                self.message = Some(problems::sentence(&problem).replace('\n', ": "));
                if problem.code == "changed-on-disk" {
                    self.safety.look_at_files(&mut self.session);
                }
                false
            }
        }
    }

    /// Shows the window for one frame.
    pub fn show(&mut self, ui: &mut Ui) {
        if ui.input(|input| input.pointer.any_pressed()) {
            self.presses += 1;
        }
        self.sheet.take_escape(ui);
        self.canvas.claim_tab(ui);
        let mut commands = Vec::new();
        self.shortcuts(ui, &mut commands);
        let dropped = ui.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_path_buf()));
        commands.extend(dropped.map(|path| {
            let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_lowercase();
            match ending.as_str() {
                mesh if MESHES.contains(&mesh) => Command::ShowOn(Some(path)),
                image if IMAGES.contains(&image) => Command::ShowReference(Some(path)),
                _ => Command::Open(Some(path)),
            }
        }));
        commands.extend(self.dialogs.answers().map(|(purpose, path)| match purpose {
            Purpose::Open => Command::Open(Some(path)),
            Purpose::Save => Command::SaveTo(path),
            Purpose::Mesh => Command::ShowOn(Some(path)),
            Purpose::Export(export) => Command::Export(export, Some(path)),
            Purpose::Reference => Command::ShowReference(Some(path)),
        }));
        if let Some(again) = self.session.tick(ui.input(|input| input.time)) {
            ui.ctx().request_repaint_after(again);
        }
        if self.dock.has(dock::Panel::Timeline) {
            self.timeline.tick(ui, &mut self.session);
        } else {
            self.timeline.stop();
        }
        self.session.refresh_keys();
        let (told, again) = self.safety.tick(ui, &mut self.session);
        self.message = told.or(self.message.take());
        if let Some(again) = again {
            ui.ctx().request_repaint_after(again);
        }
        self.panels(ui, &mut commands);
        self.ask_about_changes(ui, &mut commands);
        commands.extend(self.sheet.show(ui).map(Command::Act));
        for command in commands {
            self.apply(ui, command);
            // What was changed in this frame is seen in the next one.
            ui.ctx().request_repaint();
        }
        let is_held = ui.input(|input| input.pointer.any_down());
        self.session.commit(is_held);
        // A panel is resized in many steps; where it ends is remembered.
        if !is_held {
            let layout = self.safety.remembers().then(|| self.dock.changed()).flatten();
            self.safety.remember(ui.ctx(), layout);
        } else if let Some(picture) = &mut self.picture {
            picture.hurry(&mut self.session);
        }
        self.close_or_stay(ui.ctx());
        self.set_title(ui.ctx());
    }

    fn panels(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        Panel::top("bar").frame(theme::panel(ui)).resizable(false).show(ui, |ui| self.bar(ui, commands));
        commands.extend(self.safety.show(ui, &self.session).into_iter().map(Command::Safety));
        if let Some(picture) = &self.picture {
            self.session.set_picture_problems(&picture.problems);
        }
        // Of one height, whatever it says, so that nothing above moves under a hand.
        let status = Panel::bottom("status").frame(theme::panel(ui)).resizable(false).exact_size(STATUS);
        status.show(ui, |ui| {
            commands.extend(self.status(ui));
        });
        self.panels.update(ui, &self.session);
        if let Some(picture) = &mut self.picture {
            picture.tells_effects = self.dock.shows(dock::Panel::Effects);
        }
        let mut dock = std::mem::take(&mut self.dock);
        let ground = egui::Frame::new().fill(theme::of(ui).node_edge);
        egui::CentralPanel::default().frame(ground).show(ui, |ui| {
            dock.show(ui, &mut |ui, panel| self.panel(ui, panel, commands));
        });
        self.dock = dock;
    }

    fn panel(&mut self, ui: &mut Ui, panel: dock::Panel, commands: &mut Vec<Command>) {
        commands.extend(match panel {
            dock::Panel::Picture => {
                let Self { viewport, session, picture, probe, wipe, .. } = self;
                viewport.show(ui, session, picture.as_mut(), probe, wipe)
            }
            dock::Panel::Graph => {
                let rect = ui.max_rect();
                let mut commands = self.canvas.show(ui, &self.session);
                let dropped = library::dropped(ui, rect);
                commands.extend(dropped.map(|(kind, at)| Command::AddNode { kind, at: Some(at) }));
                commands
            }
            dock::Panel::Inspector => inspector::show(ui, &self.session),
            dock::Panel::Code => {
                let is_alone = !self.session.solo().layers.is_empty();
                let bar = is_alone.then(|| solo::bar(ui, &self.session)).flatten();
                self.code.show(ui, &self.session).into_iter().chain(bar).collect()
            }
            dock::Panel::Effects => self.effects.show(ui, self.picture.as_ref().map(|picture| &picture.effects)),
            dock::Panel::Cost => {
                let size = self.viewport.rect().map_or([0, 0], |rect| picture_size(rect, ui.pixels_per_point()));
                self.cost.show(ui, &self.session, size)
            }
            dock::Panel::Probe => self.probe.show(ui, &self.session),
            dock::Panel::Profile => self.profile.show(ui, &self.session),
            dock::Panel::Keys => self.keys.show(ui, &self.session),
            dock::Panel::Timeline => self.timeline.show(ui, &self.session),
            other => {
                if other == dock::Panel::Library {
                    self.panels.know_recent(self.safety.recent());
                }
                self.panels.show(ui, other, &self.session)
            }
        });
    }

    fn bar(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        ui.horizontal(|ui| {
            let mut button = |ui: &mut Ui, label: &str, help: &str, is_on: bool, command: Command| {
                let response = ui.add_enabled(is_on, egui::Button::new(label)).on_hover_text(help);
                if response.clicked() {
                    commands.push(command);
                }
            };
            button(ui, "New", "A new look (Ctrl+N)", true, Command::New);
            button(ui, "Open", "Opens a look (Ctrl+O)", true, Command::Open(None));
            let recent = self.safety.recent_menu(ui);
            button(ui, "Save", "Saves the look (Ctrl+S)", true, Command::Save);
            button(ui, "Save as", "Saves under another name (Ctrl+Shift+S)", true, Command::SaveAs);
            ui.separator();
            let step = |label: Option<&str>, otherwise: &str| label.map_or(otherwise.to_owned(), str::to_owned);
            let (undo, redo) = (self.session.undo_label(), self.session.redo_label());
            let help = format!("Takes back: {} (Ctrl+Z)", step(undo, "nothing"));
            button(ui, "Undo", &help, undo.is_some(), Command::Undo);
            let help = format!("Repeats: {} (Ctrl+Shift+Z)", step(redo, "nothing"));
            button(ui, "Redo", &help, redo.is_some(), Command::Redo);
            ui.separator();
            commands.extend(recent.map(|path| Command::Open(Some(path))));
            ui.menu_button("View", |ui| self.view_menu(ui)).response.on_hover_text("Panels, theme and scale");
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let name = self.document_name();
                if self.session.is_dirty() {
                    ui.label(RichText::new("changed").color(theme::of(ui).accent)).on_hover_text("Not saved yet");
                }
                let path = self.session.path().map(|path| path.display().to_string());
                let label = ui.label(RichText::new(name).strong());
                if let Some(path) = path {
                    label.on_hover_text(path);
                }
            });
        });
    }

    fn view_menu(&mut self, ui: &mut Ui) {
        for panel in dock::Panel::ALL {
            let mut is_there = self.dock.has(panel);
            if ui.checkbox(&mut is_there, panel.label()).on_hover_text(panel.help()).changed() {
                if is_there { self.dock.open(panel) } else { self.dock.close(panel) }
            }
        }
        if ui.button("Reset panels").on_hover_text("Puts all panels where a new window has them").clicked() {
            self.dock.reset();
        }
        ui.separator();
        let mut theme = ui.ctx().options(|options| options.theme_preference);
        ui.horizontal(|ui| {
            use egui::ThemePreference::{Dark, Light, System};
            for (choice, label) in [(Dark, "Dark"), (Light, "Light"), (System, "As the system")] {
                if ui.selectable_value(&mut theme, choice, label).changed() {
                    ui.ctx().set_theme(theme);
                }
            }
        });
        ui.horizontal(|ui| {
            let zoom = ui.ctx().zoom_factor();
            for percent in [100, 125, 150, 200] {
                let factor = percent as f32 / 100.0;
                let is_it = (zoom - factor).abs() < 0.01;
                if ui.selectable_label(is_it, format!("{percent}%")).on_hover_text("Scale of the window").clicked() {
                    ui.ctx().set_zoom_factor(factor);
                }
            }
        });
    }

    fn status(&self, ui: &mut Ui) -> Option<Command> {
        let hint =
            [self.viewport.hint(), self.canvas.hint()].into_iter().find(|hint| !hint.is_empty()).unwrap_or_default();
        ui.horizontal(|ui| {
            let command = problems::status(ui, &self.session);
            if let Some(message) = &self.message {
                ui.label(RichText::new(message).color(theme::of(ui).accent));
                ui.separator();
            }
            ui.add(egui::Label::new(RichText::new(hint).color(theme::of(ui).dim)).truncate());
            command
        })
        .inner
    }

    fn document_name(&self) -> String {
        match self.session.path().and_then(|path| path.file_name()) {
            Some(name) => name.to_string_lossy().into_owned(),
            None => "New look".to_owned(),
        }
    }

    fn set_title(&self, ctx: &egui::Context) {
        let mark = if self.session.is_dirty() { "*" } else { "" };
        let title = format!("{}{mark} - Chiaro", self.document_name());
        let id = egui::Id::unique("title");
        if ctx.data(|data| data.get_temp::<String>(id)).as_ref() != Some(&title) {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            ctx.data_mut(|data| data.insert_temp(id, title));
        }
    }

    fn shortcuts(&self, ui: &Ui, commands: &mut Vec<Command>) {
        let is_typing = ui.ctx().egui_wants_keyboard_input();
        // A field that is being typed in has an undo of its own, and question marks.
        let is_text = |action| matches!(action, Action::Undo | Action::Redo | Action::Shortcuts);
        for row in shortcuts::ALL.iter().filter(|row| row.place != Place::Graph) {
            if is_typing && (is_text(row.action) || row.place == Place::Picture) {
                continue;
            }
            if row.keys.iter().any(|&key| shortcuts::take(ui, key)) {
                commands.push(Command::Act(row.action));
            }
        }
        let escape = (Modifiers::NONE, Key::Escape);
        if self.probe.is_on() && !is_typing && shortcuts::take(ui, escape) {
            commands.push(Command::LeaveProbe);
        }
    }

    fn apply(&mut self, ui: &Ui, command: Command) {
        if !matches!(
            command,
            Command::Act(_) | Command::Select(_) | Command::Reveal(_) | Command::Show(_) | Command::OpenGraph(_)
        ) {
            self.message = None;
        }
        match command {
            Command::Edit(edit) => self.tell(|session| session.apply(edit, None)),
            Command::EditHeld(widget, edit) => {
                let focus = ui.memory(egui::Memory::focused);
                let mut hasher = DefaultHasher::new();
                (widget, self.presses, focus).hash(&mut hasher);
                let hand = hasher.finish();
                self.tell(|session| session.apply(edit, Some(hand)));
            }
            Command::Select(ids) => self.session.select(ids),
            Command::Reveal(id) => {
                self.session.select(vec![id.clone()]);
                self.canvas.reveal(id);
            }
            Command::Show(path) => {
                let ids = path.ids();
                self.session.open_graph(&ids[..ids.len().saturating_sub(1)]);
                if let Some(id) = self.session.step_here(&path).cloned() {
                    self.session.select(vec![id.clone()]);
                    self.canvas.reveal(id);
                }
            }
            Command::OpenGraph(path) => self.session.open_graph(&path),
            Command::Undo => drop(self.session.undo()),
            Command::Redo => drop(self.session.redo()),
            Command::New => self.do_or_ask(Pending::New),
            Command::Open(Some(path)) => self.do_or_ask(Pending::Open(path)),
            Command::Open(None) => self.dialogs.ask(Purpose::Open, self.session.path()),
            Command::Save => self.save(),
            Command::SaveAs => self.dialogs.ask(Purpose::Save, self.session.path()),
            Command::SaveTo(path) => {
                if self.save_as(&path) {
                    self.go_on();
                }
            }
            Command::ShowOn(Some(path)) => self.show_on(&path.to_string_lossy()),
            Command::ShowOn(None) => self.dialogs.ask(Purpose::Mesh, Some(Path::new(&self.session.view.mesh))),
            Command::Probe(on) => {
                self.probe.turn(on);
                if on {
                    self.dock.open(dock::Panel::Probe);
                }
            }
            Command::ShowWire(wire) => self.session.show_wire(wire),
            Command::Export(export, Some(path)) => self.viewport.export(&self.session, export, path),
            Command::Export(export, None) => self.dialogs.ask(Purpose::Export(export), self.session.path()),
            Command::CopyPicture => self.viewport.copy(&self.session, ui.pixels_per_point()),
            Command::ShowReference(Some(path)) => self.viewport.show_reference(path),
            Command::ShowReference(None) => self.dialogs.ask(Purpose::Reference, self.session.path()),
            Command::LeaveProbe => self.probe.escape(),
            Command::Solo(solo) => self.session.set_solo(solo),
            Command::ShowPanel(panel) => self.dock.open(panel),
            Command::GoTo(place) => self.session.go_to(place),
            Command::AddNode { kind, at } => self.add_node(&kind, at),
            Command::OpenExample(index) => self.do_or_ask(Pending::Example(index)),
            Command::Copy(text) => ui.ctx().copy_text(text),
            Command::SelectKey(key) => self.session.key = key,
            Command::SetTime(time) => self.session.time = time,
            Command::TurnTo(view) => self.session.view = *view,
            Command::Safety(wish) => self.message = self.safety.apply(wish, &mut self.session),
            Command::Tell(text) => self.message = Some(text),
            Command::Act(action) => self.act(ui, action),
        }
    }

    /// Does what the command palette chose.
    fn act(&mut self, ui: &Ui, action: Action) {
        let command = match action {
            Action::New => Command::New,
            Action::Open => Command::Open(None),
            Action::Save => Command::Save,
            Action::SaveAs => Command::SaveAs,
            Action::Undo => Command::Undo,
            Action::Redo => Command::Redo,
            Action::Probe => Command::Probe(!self.probe.is_on()),
            Action::Commands | Action::Shortcuts => return self.sheet.open(action),
            action => return self.canvas.ask(action),
        };
        self.apply(ui, command);
    }

    fn add_node(&mut self, kind: &str, at: Option<egui::Pos2>) {
        let Some(kind) = self.session.catalog.all().find(|known| known.id == kind).cloned() else { return };
        let at = self.canvas.place_for(at);
        let (id, edits) = edits::add(&self.session, &kind, at);
        self.tell(|session| session.apply(Edit::Group { edits }, None));
        self.session.select(vec![id]);
    }

    fn tell(&mut self, edit: impl FnOnce(&mut Session) -> Result<(), Box<Diagnostic>>) {
        if let Err(problem) = edit(&mut self.session) {
            self.message = Some(problem.message);
        }
    }

    fn save(&mut self) {
        match self.session.path().map(Path::to_path_buf) {
            Some(path) => {
                if self.save_as(&path) {
                    self.go_on();
                }
            }
            None => self.dialogs.ask(Purpose::Save, None),
        }
    }

    /// Does what would lose changes, where there are none, or where the journal keeps them; else asks first.
    fn do_or_ask(&mut self, pending: Pending) {
        self.pending = Some(pending);
        if !self.session.is_dirty() || self.session.keeps_work() {
            self.go_on();
        }
    }

    fn go_on(&mut self) {
        match self.pending.take() {
            Some(Pending::New) => {
                self.session.start_new();
                self.safety.look();
            }
            Some(Pending::Open(path)) => self.open(&path),
            Some(Pending::Example(index)) => {
                let (name, text) = library::EXAMPLES[index];
                self.session.start_from(text, name);
                self.safety.look();
            }
            Some(Pending::Close) => self.closes = true,
            None => {}
        }
    }

    fn ask_about_changes(&mut self, ui: &Ui, commands: &mut Vec<Command>) {
        if self.pending.is_none() || !self.session.is_dirty() {
            return;
        }
        let modal = egui::Modal::new(egui::Id::unique("unsaved")).show(ui.ctx(), |ui| {
            ui.set_width(320.0);
            ui.label(RichText::new(format!("{} has changes", self.document_name())).heading());
            ui.label("They are lost unless you save them.");
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                if ui.button("Save").clicked() {
                    commands.push(Command::Save);
                }
                if ui.button("Do not save").clicked() {
                    self.session.give_up_changes();
                    self.go_on();
                }
                if ui.button("Cancel").clicked() {
                    self.pending = None;
                }
            });
        });
        if modal.should_close() {
            self.pending = None;
        }
    }

    fn close_or_stay(&mut self, ctx: &egui::Context) {
        if self.closes {
            ctx.send_viewport_cmd(ViewportCommand::Close);
        } else if ctx.input(|input| input.viewport().close_requested())
            && self.session.is_dirty()
            && !self.session.keeps_work()
        {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.pending = Some(Pending::Close);
        }
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.show(ui);
    }

    fn on_exit(&mut self) {
        self.session.close_journal(true);
    }
}
