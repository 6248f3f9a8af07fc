//! Menu of the views that the picture is shown by: the curve of sRGB, and those of an OpenColorIO
//! configuration.

use chiaro_locale::tr;
use eframe::egui::{self, Ui};

use crate::commands::{Command, DisplayCommand};
use crate::film::{BUILT_IN, ColorConfig, VIEW_VARIABLE};
use crate::state::display::DisplayChoice;
use crate::state::session::Session;
use crate::state::worker::{BackgroundJobs, Worker};

/// Configuration for the menu, with all displays and their views, or the reason why there are none.
struct ListedConfig {
    name: String,
    displays: Result<Vec<(String, Vec<String>)>, String>,
}

impl ListedConfig {
    fn open(name: String) -> Self {
        let opened = ColorConfig::open(&name).map(|config| config.displays());
        Self { name, displays: opened.map_err(|problem| problem.message) }
    }
}

/// Configurations for the menu. A studio's is a file of a megabyte on a slow disk, so that it is
/// read beside the window.
#[derive(Default)]
pub(super) struct ColorMenu {
    /// Name of the configuration that is listed, or is to be.
    wanted: String,
    listed: Option<ListedConfig>,
    /// Reader of configurations; `None` until the menu is opened.
    reader: Option<Worker<String, ListedConfig>>,
}

impl BackgroundJobs for ColorMenu {
    fn is_busy(&self) -> bool {
        // An answer may lie there for long: it is taken when the menu is open.
        self.reader.as_ref().is_some_and(Worker::is_busy)
    }

    fn wait(&self) {
        if let Some(reader) = &self.reader {
            reader.wait();
        }
    }
}

impl ColorMenu {
    /// The configuration of a name; `None` while it is read.
    fn config(&mut self, ui: &Ui, name: &str) -> Option<&ListedConfig> {
        let ctx = ui.ctx().clone();
        let reader = self.reader.get_or_insert_with(|| {
            Worker::new("colors", move || ctx.request_repaint(), ListedConfig::open)
        });
        if self.wanted != name {
            self.wanted = name.to_owned();
            reader.request(|_| name.to_owned());
        }
        if let Some(read) = reader.answers().pop() {
            self.listed = Some(read);
        }
        self.listed.as_ref().filter(|listed| listed.name == name)
    }
}

/// Height of a menu of views, in points, above which it scrolls.
const MENU_HEIGHT: f32 = 420.0;

/// Shows the entry with its menu.
pub(super) fn menu(ui: &mut Ui, session: &Session, colors: &mut ColorMenu, out: &mut Vec<Command>) {
    let shown = session.view().display().map(|display| &*display.choice);
    let label = match shown {
        None => tr!("View transform: sRGB").to_owned(),
        Some(choice) => tr!("View transform: {view}", view = choice.view),
    };
    let help =
        tr!("Shows the picture's light by the curve of sRGB, or by a view of an OpenColorIO \
         configuration such as ACES 2; for this window only, the look stays as it is");
    let entry = ui.menu_button(label, |ui| {
        let help = tr!("As PNGs are written without --view");
        if ui.radio(shown.is_none(), "sRGB").on_hover_text(help).clicked() {
            out.push(Command::Display(DisplayCommand::Show(None)));
        }
        ui.separator();
        let name = match shown {
            Some(choice) => choice.config.clone(),
            None => ColorConfig::name_of(None),
        };
        match colors.config(ui, &name).map(|listed| &listed.displays) {
            Some(Ok(displays)) => views(ui, &name, displays, shown, out),
            Some(Err(problem)) => drop(ui.label(problem.as_str())),
            None => drop(ui.weak(tr!("Reading the configuration..."))),
        }
        ui.separator();
        configurations(ui, &name, out);
    });
    entry.response.on_hover_text(help);
}

fn views(
    ui: &mut Ui,
    config: &str,
    displays: &[(String, Vec<String>)],
    shown: Option<&DisplayChoice>,
    out: &mut Vec<Command>,
) {
    for (display, views) in displays {
        ui.menu_button(display, |ui| {
            egui::ScrollArea::vertical().max_height(MENU_HEIGHT).show(ui, |ui| {
                for view in views {
                    let choice = DisplayChoice {
                        config: config.to_owned(),
                        display: display.clone(),
                        view: view.clone(),
                    };
                    if ui.radio(shown == Some(&choice), view).clicked() {
                        out.push(Command::Display(DisplayCommand::Show(Some(choice))));
                    }
                }
            });
        });
    }
}

/// Shows the choice of the configuration.
fn configurations(ui: &mut Ui, name: &str, out: &mut Vec<Command>) {
    let mut entry = |ui: &mut Ui, label: &str, config: &str| {
        if ui.radio(name == config, label).on_hover_text(config).clicked() {
            out.push(Command::Display(DisplayCommand::Open(Some(config.into()))));
        }
    };
    entry(ui, tr!("Built in: ACES 2"), BUILT_IN);
    let of_system = ColorConfig::name_of(None);
    if of_system != BUILT_IN {
        entry(ui, &format!("${VIEW_VARIABLE}"), &of_system);
    }
    if name != BUILT_IN && name != of_system {
        let file = std::path::Path::new(name).file_name();
        let file = file.map_or(name.into(), |file| file.to_string_lossy());
        entry(ui, &file, name);
    }
    let help = tr!("Takes the displays and views of another configuration (.ocio, .ocioz)");
    if ui.button(tr!("Configuration from a file...")).on_hover_text(help).clicked() {
        out.push(Command::Display(DisplayCommand::Open(None)));
        ui.close();
    }
}
