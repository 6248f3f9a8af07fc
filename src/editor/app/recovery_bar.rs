//! Bar of work to be taken back and of files that changed. The bar is hidden while there is nothing
//! to report.

use std::path::PathBuf;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Panel, RichText, Ui};

use crate::commands::RecoveryCommand;
use crate::state::crashes::{CrashStep, Suspect};
use crate::state::safety::Safety;
use crate::state::safety::disk::{Conflict, PaintingConflict};
use crate::state::safety::offers::Offer;
use crate::state::session::Session;

/// Largest number of documents named in the bar; a list has all of them.
const MOST_NAMED: usize = 3;
/// Width of that list, in points.
const LIST: f32 = 620.0;

impl Safety {
    /// Shows the bar, if there is anything to report.
    pub(crate) fn show(&self, ui: &mut Ui, session: &Session) -> Vec<RecoveryCommand> {
        let problem = session.keeping_problem();
        let problem = problem.filter(|_| !self.is_problem_read);
        let count = self.offers.shown().count();
        let painting = self.disk.painting_conflict.filter(|_| session.painting().is_some());
        let is_any = self.unopened.is_some()
            || session.journals.held().is_some()
            || self.disk.conflict.is_some()
            || self.disk.scene_conflict.is_some()
            || painting.is_some();
        if problem.is_none() && !is_any && count == 0 {
            return Vec::new();
        }
        let mut out = Vec::new();
        let frame = egui::Frame::side_top_panel(ui.style());
        Panel::top("safety").frame(frame).resizable(false).show(ui, |ui| {
            if let Some(unopened) = &self.unopened {
                row(ui, Tone::Warning, &unopened.text, |ui| {
                    ask(
                        ui,
                        tr!("Understood"),
                        tr!("Hides this"),
                        RecoveryCommand::HideUnopened,
                        &mut out,
                    );
                    ask(
                        ui,
                        tr!("Open another file"),
                        tr!("Asks for a file"),
                        RecoveryCommand::OpenAnother,
                        &mut out,
                    );
                    if unopened.interrupted.is_some() {
                        ask(
                            ui,
                            tr!("Try again"),
                            tr!("Reads it all the same"),
                            RecoveryCommand::ReadAgain,
                            &mut out,
                        );
                    }
                });
                ui.add(egui::Label::new(RichText::new(&unopened.help).weak()).wrap());
            }
            if let Some(suspect) = session.journals.held() {
                held(ui, suspect, &mut out);
            }
            if let Some(problem) = problem {
                let hint = problem.hints.join("\n");
                row(ui, Tone::Warning, &problem.message, |ui| {
                    ask(ui, tr!("Understood"), &hint, RecoveryCommand::Hide, &mut out);
                });
            }
            if let Some(conflict) = &self.disk.conflict {
                self.conflict(ui, conflict, session, &mut out);
            }
            if let (Some(_), Some(open_scene)) = (&self.disk.scene_conflict, session.open_scene()) {
                let text = tr!(
                    "{name} was changed by another program, and by you",
                    name = open_scene.name_of_changed()
                );
                row(ui, Tone::Warning, &text, |ui| {
                    let help =
                        tr!("Takes the scene as it is in the file now, as one step: Undo brings \
                             your version back");
                    ask(
                        ui,
                        tr!("Load the file's version"),
                        help,
                        RecoveryCommand::ReloadScene,
                        &mut out,
                    );
                    let help = tr!("Saving the scene then writes your version over the other one");
                    ask(ui, tr!("Keep mine"), help, RecoveryCommand::KeepMyScene, &mut out);
                });
            }
            if let (Some(conflict), Some(work)) = (painting, session.painting()) {
                of_painting(ui, conflict, &work.name(), &mut out);
            }
            let offers: Vec<(usize, &Offer)> = self.offers.shown().collect();
            match offers[..] {
                [(number, offer)] => offered(ui, number, offer, &mut out),
                [] => {}
                _ => several(ui, &offers, &mut out),
            }
        });
        out
    }

    fn conflict(
        &self,
        ui: &mut Ui,
        conflict: &Conflict,
        session: &Session,
        out: &mut Vec<RecoveryCommand>,
    ) {
        let name = session
            .path()
            .and_then(|path| path.file_name())
            .map(|name| name.to_string_lossy().into_owned());
        let name = name.unwrap_or_default();
        match conflict {
            Conflict::Changed(_) => {
                let text = tr!("{name} was changed by another program, and by you");
                row(ui, Tone::Warning, &text, |ui| {
                    let help = tr!(
                        "Takes the file as it is now, as one step: Undo brings your version back"
                    );
                    ask(ui, tr!("Load the file's version"), help, RecoveryCommand::Reload, out);
                    let help = tr!("Saving then writes your version over the other one");
                    ask(ui, tr!("Keep mine"), help, RecoveryCommand::KeepMine, out);
                });
            }
            Conflict::Broken(_) => {
                let text = tr!(
                    "{name} was changed by another program and cannot be read now; your version \
                     stays"
                );
                row(ui, Tone::Warning, &text, |ui| {
                    let help = tr!("Saving then writes your version over the other one");
                    ask(ui, tr!("Keep mine"), help, RecoveryCommand::KeepMine, out);
                });
            }
            Conflict::Gone => {
                let text =
                    tr!("{name} was removed or moved by another program; saving writes it again");
                row(ui, Tone::Warning, &text, |ui| {
                    ask(ui, tr!("Understood"), tr!("Hides this"), RecoveryCommand::Hide, out);
                });
            }
        }
    }

    /// Shows the menu of recent files. Returns the chosen one.
    pub(crate) fn recent_menu(&self, ui: &mut Ui) -> Option<PathBuf> {
        let mut wanted = None;
        let menu = ui.menu_button(tr!("Recent"), |ui| {
            let mut is_empty = true;
            for (path, is_there) in self.recent() {
                is_empty = false;
                let name = path
                    .file_name()
                    .map(|name| name.to_string_lossy().into_owned())
                    .unwrap_or_default();
                let help = path.display().to_string();
                let button = ui.add_enabled(is_there, egui::Button::new(name));
                let button = button
                    .on_hover_text(&help)
                    .on_disabled_hover_text(tr!("{help} is not there any more"));
                if button.clicked() {
                    wanted = Some(path.clone());
                    ui.close();
                }
            }
            if is_empty {
                ui.label(RichText::new(tr!("Files that you open are listed here")).weak());
            }
        });
        menu.response.on_hover_text(tr!(
            "Looks, scenes, shots and paintings that were open, the newest first"
        ));
        wanted
    }
}

/// Row for an open document that is not drawn, because the last program ended over it.
fn held(ui: &mut Ui, suspect: &Suspect, out: &mut Vec<RecoveryCommand>) {
    let name = &suspect.document.name;
    let text = match suspect.step {
        CrashStep::Read => {
            tr!("{name} is open without being drawn: Chiaro ended while reading it the last time")
        }
        CrashStep::Compile => {
            tr!("{name} is open without being drawn: Chiaro ended while compiling it the last time")
        }
        CrashStep::Draw => {
            tr!("{name} is open without being drawn: Chiaro ended while drawing it the last time")
        }
    };
    row(ui, Tone::Warning, &text, |ui| {
        let help = tr!(
            "Compiles and draws it as ever. If Chiaro ends over it again, the next start asks \
             again"
        );
        ask(ui, tr!("Try again"), help, RecoveryCommand::TryAgain, out);
    });
}

fn of_painting(
    ui: &mut Ui,
    conflict: PaintingConflict,
    name: &str,
    out: &mut Vec<RecoveryCommand>,
) {
    let keep = tr!("Saving then writes your version over the other one");
    match conflict {
        PaintingConflict::Changed => {
            let text = tr!("{name} was changed by another program, and painted on by you");
            row(ui, Tone::Warning, &text, |ui| {
                let help =
                    tr!("Takes the file as it is now, as one step: Undo brings your version back");
                ask(ui, tr!("Load the file's version"), help, RecoveryCommand::ReloadPainting, out);
                ask(ui, tr!("Keep mine"), keep, RecoveryCommand::KeepMyPainting, out);
            });
        }
        PaintingConflict::Broken => {
            let text = tr!(
                "{name} was changed by another program and cannot be read now; your version stays"
            );
            row(ui, Tone::Warning, &text, |ui| {
                ask(ui, tr!("Keep mine"), keep, RecoveryCommand::KeepMyPainting, out);
            });
        }
        PaintingConflict::Gone => {
            let text =
                tr!("{name} was removed or moved by another program; saving writes it again");
            row(ui, Tone::Warning, &text, |ui| {
                ask(ui, tr!("Understood"), tr!("Hides this"), RecoveryCommand::KeepMyPainting, out);
            });
        }
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Tone {
    Note,
    Warning,
}

fn row(ui: &mut Ui, tone: Tone, text: &str, buttons: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        let color = match tone {
            Tone::Note => ui.visuals().strong_text_color(),
            Tone::Warning => ui.visuals().warn_fg_color,
        };
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            buttons(ui);
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                ui.add(egui::Label::new(RichText::new(text).color(color)).truncate());
            });
        });
    });
}

fn ask(
    ui: &mut Ui,
    label: &str,
    help: &str,
    command: RecoveryCommand,
    out: &mut Vec<RecoveryCommand>,
) {
    if ui.button(label).on_hover_text(help).clicked() {
        out.push(command);
    }
}

/// Row for several documents, with a list of them behind a button.
fn several(ui: &mut Ui, offers: &[(usize, &Offer)], out: &mut Vec<RecoveryCommand>) {
    let is_damaged = offers.iter().any(|(_, offer)| !offer.damage.is_empty());
    let names: Vec<&str> =
        offers.iter().take(MOST_NAMED).map(|(_, offer)| offer.name.as_str()).collect();
    let (count, named) = (offers.len(), names.join(", "));
    let text = match count - names.len() {
        0 => tr!("Work that was not saved, of {count} documents: {named}"),
        more => tr!("Work that was not saved, of {count} documents: {named} and {more} more"),
    };
    row(ui, if is_damaged { Tone::Warning } else { Tone::Note }, &text, |ui| {
        let is_kept = offers.iter().any(|(_, offer)| !offer.is_thrown);
        let help = tr!("They go when this window closes; until then each can still be kept");
        if ui
            .add_enabled(is_kept, egui::Button::new(tr!("Throw all away")))
            .on_hover_text(help)
            .clicked()
        {
            out.extend(offers.iter().map(|(number, _)| RecoveryCommand::Throw(*number, true)));
        }
        let list = egui::containers::menu::MenuConfig::new()
            .close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside);
        let (button, _) =
            egui::containers::menu::MenuButton::new(tr!("Choose...")).config(list).ui(ui, |ui| {
                ui.set_min_width(LIST);
                for (number, offer) in offers {
                    offered(ui, *number, offer, out);
                }
            });
        button.on_hover_text(tr!("Lists them: each is restored or thrown away by itself"));
    });
}

fn offered(ui: &mut Ui, number: usize, offer: &Offer, out: &mut Vec<RecoveryCommand>) {
    if offer.is_thrown {
        let text = tr!(
            "The unsaved changes of {name} are thrown away when this window closes",
            name = offer.name
        );
        row(ui, Tone::Note, &text, |ui| {
            ask(
                ui,
                tr!("Keep it"),
                tr!("It is offered again"),
                RecoveryCommand::Throw(number, false),
                out,
            );
        });
        return;
    }
    let tone = if offer.damage.is_empty() { Tone::Note } else { Tone::Warning };
    let text = tr!("Work that was not saved: {work}", work = offer.summary());
    row(ui, tone, &text, |ui| {
        let help = tr!("It goes when this window closes; until then you can still keep it");
        ask(ui, tr!("Throw it away"), help, RecoveryCommand::Throw(number, true), out);
        if offer.is_readable {
            let path = offer.path.as_ref().map_or_else(
                || tr!("It has no file yet").to_owned(),
                |path| path.display().to_string(),
            );
            let help = tr!("{path}\nOpens it as it was, with everything that can be undone");
            ask(ui, tr!("Restore it"), &help, RecoveryCommand::TakeBack(number), out);
        }
    });
}
