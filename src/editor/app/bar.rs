//! Bar at the top of the window, and line of status at the bottom.

use chiaro_locale::{Text, text, tr};
use eframe::egui::{self, Role, Ui, ViewportCommand, WidgetInfo};

use super::App;
use crate::app::dock;
use crate::commands::table::{self, CommandRow, Menu};
use crate::commands::{Command, PaintCommand, PanelId, ScaleCommand};
use crate::painter::{ShownPainting, shown};
use crate::panels::{PANELS, problems};
use crate::state::painting::work::OpenPainting;
use crate::state::problem_text::step_labelled;
use crate::state::scene::OpenScene;
use crate::state::session::Session;
use crate::state::session::painting::is_painting_shown;
use crate::widgets::menu;
use crate::widgets::spots::{self, Spot};
use crate::widgets::text::in_a_line;
use crate::widgets::theme;

/// Smallest room for the names of the open documents in the bar, in points: a narrower bar leaves
/// them out, as the window's title has them too.
const LEAST_NAME: f32 = 60.0;
/// Reason why commands about a painting are disabled.
const NOTHING_PAINTED: Text =
    text!("Nothing is open to be painted: begin a new painted surface above, or open one");

impl App {
    pub(super) fn bar(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        // Long words of another language take a second row in a narrow window.
        ui.horizontal_wrapped(|ui| {
            let mut button =
                |ui: &mut Ui, label: &str, help: &str, is_on: bool, command: Command| {
                    let response =
                        ui.add_enabled(is_on, egui::Button::new(label)).on_hover_text(help);
                    if response.clicked() {
                        commands.push(command);
                    }
                    response.rect
                };
            let mut named = |ui: &mut Ui, label: &str, command: Command| {
                button(ui, label, &table::help_of(&command), true, command)
            };
            named(ui, tr!("New"), Command::New);
            named(ui, tr!("Open"), Command::Open(None));
            let recent = self.safety.recent_menu(ui);
            let save = named(ui, tr!("Save"), Command::Save);
            spots::note(ui, Spot::Save, save);
            named(ui, tr!("Save as"), Command::SaveAs);
            ui.separator();
            let steps = self.session.steps();
            let told = |step: &str| step_labelled(self.session.look_with_library(), step);
            let (undo, redo) = (steps.undo_label().map(told), steps.redo_label().map(told));
            let help = match &undo {
                Some(step) => tr!("Takes back: {step} (Ctrl+Z)"),
                None => tr!("Takes back: nothing (Ctrl+Z)").to_owned(),
            };
            button(ui, tr!("Undo"), &help, undo.is_some(), Command::Undo);
            let help = match &redo {
                Some(step) => tr!("Repeats: {step} (Ctrl+Shift+Z)"),
                None => tr!("Repeats: nothing (Ctrl+Shift+Z)").to_owned(),
            };
            button(ui, tr!("Redo"), &help, redo.is_some(), Command::Redo);
            ui.separator();
            commands.extend(recent.map(|path| Command::Open(Some(path))));
            ui.menu_button(tr!("menu" => "View"), |ui| {
                menu::scrolling(ui, |ui| self.view_menu(ui));
            })
            .response
            .on_hover_text(tr!("Panels, theme and scale"));
            let is_open = self.session.painting().is_some();
            let why =
                |row: &CommandRow| (!is_open && row.needs_painting).then(|| NOTHING_PAINTED.tr());
            let help =
                tr!("Light on the picture; surfaces that change with the light and the eye, \
                     painted by hand");
            menu_with(
                ui,
                (tr!("Paint"), help),
                Menu::Paint,
                why,
                |ui, commands| paint_shown(ui, &self.session, commands),
                commands,
            );
            let help = tr!("The look as shaders for other programs, or the picture, as files");
            menu(ui, (tr!("Export"), help), Menu::Export, commands);
            let help = tr!("The picture, the selected nodes or the shader, to the clipboard");
            menu(ui, (tr!("Copy as"), help), Menu::CopyAs, commands);
            let help = tr!("The start page, the tour, all commands and keys");
            menu(ui, (tr!("Help"), help), Menu::Help, commands);
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                // A narrow window has room for the buttons alone.
                if ui.available_width() > LEAST_NAME {
                    self.show_documents(ui);
                }
            });
        });
    }

    fn view_menu(&mut self, ui: &mut Ui) {
        // Two columns, so that a low window has room for all of the menu.
        let rows = PANELS.len().div_ceil(2);
        egui::Grid::new("panels").num_columns(2).show(ui, |ui| {
            for row in 0..rows {
                for panel in [PANELS.get(row), PANELS.get(row + rows)].into_iter().flatten() {
                    let mut is_there = self.dock.has(panel.id);
                    if ui
                        .checkbox(&mut is_there, panel.label.tr())
                        .on_hover_text(panel.help.tr())
                        .changed()
                    {
                        self.start = None;
                        if is_there { self.dock.open(panel.id) } else { self.dock.close(panel.id) }
                    }
                }
                ui.end_row();
            }
        });
        if ui
            .button(tr!("Reset panels"))
            .on_hover_text(tr!("Puts all panels of this layout where a new window has them"))
            .clicked()
        {
            self.dock.reset();
        }
        ui.separator();
        for workspace in dock::Workspace::ALL {
            let is_it = self.dock.workspace() == workspace;
            if ui.radio(is_it, workspace.label()).on_hover_text(workspace.help()).clicked() {
                self.start = None;
                self.dock.enter(workspace);
            }
        }
        let help =
            tr!("Opens the shot, its timeline and the rendering of its frames in this layout");
        if ui.button(tr!("Panels for film")).on_hover_text(help).clicked() {
            self.start = None;
            for panel in [PanelId::FRAMES, PanelId::TIMELINE, PanelId::SHOT] {
                self.dock.open(panel);
            }
        }
        ui.separator();
        let mut theme = ui.ctx().options(|options| options.theme_preference);
        ui.horizontal(|ui| {
            use egui::ThemePreference::{Dark, Light, System};
            for (choice, label) in [
                (Dark, tr!("theme" => "Dark")),
                (Light, tr!("theme" => "Light")),
                (System, tr!("As the system")),
            ] {
                if ui.selectable_value(&mut theme, choice, label).changed() {
                    ui.ctx().set_theme(theme);
                }
            }
        });
        ui.horizontal(|ui| {
            let zoom = ui.ctx().zoom_factor();
            for percent in ScaleCommand::PERCENTS {
                let is_it = (zoom * 100.0 - f32::from(percent)).abs() < 1.0;
                let response = ui
                    .selectable_label(is_it, format!("{percent}%"))
                    .on_hover_text(tr!("Scale of the window (Ctrl and +, -, 0)"));
                let name =
                    || WidgetInfo::selected(Role::Button, true, is_it, tr!("Scale {percent}%"));
                response.widget_info(name);
                if response.clicked() {
                    ScaleCommand::To(percent).apply(ui.ctx());
                }
            }
        });
        ui.menu_button(tr!("Language"), |ui| self.language_menu(ui));
    }

    pub(super) fn status(&self, ui: &mut Ui) -> Option<Command> {
        let has_graph = self.dock.shows(PanelId::GRAPH) && !self.bench.wedge.is_large();
        let of_graph = if has_graph { self.bench.canvas.hint() } else { "" };
        let hints = [self.bench.painting.hint(), self.bench.viewport.hint(), of_graph];
        let hint = hints
            .into_iter()
            .find(|hint| !hint.is_empty() && self.start.is_none())
            .unwrap_or_default();
        ui.horizontal(|ui| {
            let mut command = problems::status(ui, &self.session);
            if let Some(message) = &self.message {
                if let Some(path) = &self.refused {
                    let name = path.file_name().unwrap_or_default().to_string_lossy();
                    let help = tr!("Opens the file that has it, in place of the shot");
                    if ui.button(tr!("Open {name}")).on_hover_text(help).clicked() {
                        command = Some(Command::Open(Some(path.clone())));
                    }
                }
                // A long message is cut off, so that it never pushes the window about.
                if in_a_line(ui, message, theme::of(ui).accent) {
                    command = Some(Command::Copy(message.clone()));
                }
                ui.separator();
            }
            if in_a_line(ui, hint, theme::of(ui).dim) {
                command = Some(Command::Copy(hint.to_owned()));
            }
            command
        })
        .inner
    }

    /// Open documents: the look, the scene around it, and the painting, each with the words before
    /// its name and true if it has changes that no file holds.
    fn documents(&self) -> Vec<(&'static str, String, bool)> {
        let session = &self.session;
        let open_scene = session.open_scene();
        let work = session.painting();
        let is_look_dirty = session.is_look_dirty();
        let mut all = Vec::new();
        if let Some(shot) = session.shot() {
            // A save writes the shot; look and scene under it have no changes.
            all.push(("", shot.name(), shot.is_dirty()));
            all.push((", ", session.name(), false));
        }
        let open_scene_of_shot = session.shot().is_some();
        // A look that only shows the painting goes without saying.
        let is_bare = |work: &OpenPainting| {
            session.path().is_none() && session.look().name == work.kept_name()
        };
        if open_scene_of_shot {
            // Its look is told.
        } else if is_look_dirty
            || open_scene.is_some()
            || !(work.is_some_and(is_bare) && self.keeps_look())
        {
            all.push(("", session.name(), is_look_dirty));
        }
        // A look and its scene may have files of the same name.
        let within = |open_scene: &OpenScene| {
            if open_scene.name() == session.name() { tr!(" in the scene ") } else { tr!(" in ") }
        };
        let is_scene_dirty = |open_scene: &OpenScene| !open_scene_of_shot && open_scene.is_dirty();
        all.extend(
            open_scene.map(|open_scene| {
                (within(open_scene), open_scene.name(), is_scene_dirty(open_scene))
            }),
        );
        let between = if all.is_empty() { "" } else { ", " };
        all.extend(work.map(|work| (between, work.name(), work.is_dirty())));
        all
    }

    /// Shows the names of the open documents, and which of them are changed.
    fn show_documents(&self, ui: &mut Ui) {
        let (colors, font) = (theme::of(ui), egui::TextStyle::Body.resolve(ui.style()));
        let mut job = egui::text::LayoutJob::default();
        let mut add = |text: &str, color| {
            job.append(text, 0.0, egui::TextFormat::simple(font.clone(), color));
        };
        let mut help: Vec<String> =
            self.session.path().map(|path| path.display().to_string()).into_iter().collect();
        let mut is_any_changed = false;
        for (between, name, is_changed) in self.documents() {
            add(between, colors.dim);
            add(&name, ui.visuals().strong_text_color());
            if is_changed {
                add(tr!(" changed"), colors.accent);
                help.push(tr!("{name} has changes that no file holds yet"));
                is_any_changed = true;
            }
        }
        if is_any_changed && self.safety.remembers() && self.session.keeping_problem().is_none() {
            let text = tr!("Closing the window keeps them: they are offered at the next start");
            help.push(text.to_owned());
        }
        let whole = ui.fonts_mut(|fonts| fonts.layout_job(job.clone())).size().x;
        if is_any_changed && whole > ui.available_width() {
            // The end of a long name may be cut off, but not that it is changed.
            ui.label(egui::RichText::new(tr!(" changed").trim_start()).color(colors.accent));
        }
        let label = ui.add(egui::Label::new(job).truncate());
        if !help.is_empty() {
            label.on_hover_text(help.join("\n"));
        }
    }

    /// Title of the window: what Save writes comes first, and the others that are open after it.
    pub fn title(&self) -> String {
        let mut documents = self.documents();
        self.leave_out_unsaved(&mut documents);
        let is_any_changed = documents.iter().any(|(_, _, is_changed)| *is_changed);
        // Save writes all that is changed, or else the first of them.
        let is_saved = |index: usize, is_changed: bool| match is_any_changed {
            true => is_changed,
            false => index == 0,
        };
        let names = |of_saved: bool| {
            let documents = documents.iter().enumerate();
            let those = documents
                .filter(|(index, (_, _, is_changed))| is_saved(*index, *is_changed) == of_saved);
            let mark = if of_saved && is_any_changed { "*" } else { "" };
            let names = those.map(|(_, (_, name, _))| format!("{name}{mark}"));
            names.collect::<Vec<String>>().join(", ")
        };
        let (saved, others) = (names(true), names(false));
        match others.is_empty() {
            true => format!("{saved} - Chiaro"),
            false => tr!("{saved} (with {others}) - Chiaro"),
        }
    }

    /// Takes the mark of changes from documents that Save does not write now: a painting without a
    /// file that is not shown, and a scene without a file while the look has changes.
    fn leave_out_unsaved(&self, documents: &mut [(&'static str, String, bool)]) {
        let session = &self.session;
        let mut from_end = documents.iter_mut().rev();
        if session.painting().is_some()
            && let Some((.., is_changed)) = from_end.next()
        {
            *is_changed &= self.saves_painting();
        }
        let has_file = session.open_scene().is_none_or(|open_scene| open_scene.path().is_some());
        if !has_file
            && session.is_look_dirty()
            && let Some((.., is_changed)) = from_end.next()
        {
            *is_changed = false;
        }
    }

    pub(super) fn set_title(&self, ctx: &egui::Context) {
        let title = self.title();
        let id = egui::Id::unique("title");
        if ctx.data(|data| data.get_temp::<String>(id)).as_ref() != Some(&title) {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            ctx.data_mut(|data| data.insert_temp(id, title));
        }
    }
}

/// Shows a menu of the rows that the table of commands has for it, with their keys.
fn menu(ui: &mut Ui, named: (&str, &str), list: Menu, commands: &mut Vec<Command>) {
    menu_with(ui, named, list, |_| None, |_, _| (), commands);
}

/// Shows a menu, after the entries of `first`; rows for which `why` gives a reason are disabled.
fn menu_with(
    ui: &mut Ui,
    (label, help): (&str, &str),
    list: Menu,
    why: impl Fn(&CommandRow) -> Option<&'static str>,
    first: impl FnOnce(&mut Ui, &mut Vec<Command>),
    commands: &mut Vec<Command>,
) {
    let entry = |ui: &mut Ui, row: &CommandRow, commands: &mut Vec<Command>| {
        let why = why(row);
        let button = egui::Button::new(row.label.tr()).shortcut_text(row.text());
        let button = ui.add_enabled(why.is_none(), button);
        button.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::MenuItem, why.is_none(), row.label)
        });
        menu::why_disabled(&button, why.unwrap_or_default());
        if button.clicked() {
            commands.push(row.command.clone());
            ui.close();
        }
    };
    let menu = ui.menu_button(label, |ui| {
        menu::scrolling(ui, |ui| {
            first(ui, commands);
            for row in table::rows().filter(|row| row.menu == Some(list)) {
                entry(ui, row, commands);
            }
        });
    });
    menu.response.on_hover_text(help);
}

/// Entries for painting what the open look shows.
fn paint_shown(ui: &mut Ui, session: &Session, commands: &mut Vec<Command>) {
    let all = shown(session);
    let mut entry = |ui: &mut Ui, label: &str, help: &str, command: Option<Command>| {
        let button = ui.add_enabled(command.is_some(), egui::Button::new(label));
        button.widget_info(|| WidgetInfo::labeled(Role::MenuItem, command.is_some(), label));
        let button = button.on_hover_text(help);
        menu::why_disabled(&button, help);
        if let Some(command) = command.filter(|_| button.clicked()) {
            commands.push(command);
            ui.close();
        }
    };
    if let Some(work) = session.painting() {
        let is_shown = is_painting_shown(session);
        let name = work.name();
        let (label, command) = match is_shown {
            true => (tr!("Go on painting {name}"), Command::ShowPanel(PanelId::PAINT)),
            false => (tr!("Back to {name}"), Command::Paint(PaintCommand::GoBack)),
        };
        entry(
            ui,
            &label,
            tr!("Shows what is open to be painted, where it was painted"),
            Some(command),
        );
    }
    if session.painting().is_none() && all.is_empty() {
        entry(
            ui,
            tr!("Paint what the look shows"),
            tr!("The open look shows nothing that is painted"),
            None,
        );
    }
    for ShownPainting { label, help, path, .. } in all {
        entry(
            ui,
            &label,
            help,
            Some(Command::Paint(PaintCommand::Open { path, keeps_look: true })),
        );
    }
    ui.separator();
}
