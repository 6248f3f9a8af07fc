//! Job of a farm: the farm, how its tasks are cut, and the file that is written.

use chiaro_locale::{tr, trn};
use eframe::egui::style::ScrollAnimation;
use eframe::egui::{Align, Button, Response, RichText, Role, Ui, WidgetInfo};

use super::{FrameRenders, JobRun, command_text, view_of};
use crate::commands::{Command, FilmCommand, SceneCommand, ShotCommand};
use crate::document::ShotEdit;
use crate::fields::row::labelled;
use crate::film::farm::{FARMS, Farm};
use crate::panels::shot::inherited;
use crate::panels::table::PanelContext;
use crate::state::runs::{FilmDocument, RunEnd};
use crate::state::session::Session;
use crate::widgets::number::number_field;
use crate::widgets::text::hint;
use crate::widgets::theme;

impl FrameRenders {
    /// Shows the choices of a job, and the job that was written.
    pub(super) fn farm_part(
        &mut self,
        ui: &mut Ui,
        context: PanelContext<'_>,
        document: &FilmDocument,
        out: &mut Vec<Command>,
    ) {
        let head = ui.label(RichText::new(tr!("Send to a farm")).strong());
        // A panel that was closed has its height, and so the room to scroll, a frame later.
        if self.shows_farm > 0 {
            self.shows_farm -= 1;
            head.scroll_to_me_animation(Some(Align::Min), ScrollAnimation::none());
            ui.ctx().request_repaint();
        }
        hint(
            ui,
            tr!("The same frames, drawn by many machines. The job is a file that you submit."),
        );
        let farm = self.farm_of(context, document);
        farms(ui, farm.to, out);
        let count = self.choices.list(document).map_or(0, |list| list.frames().len() as u32);
        self.chunk_row(ui, context.session, [farm.chunk, count], out);
        let files = context.session.drawn_files();
        let line = self.choices.job(document, view_of(context), (&farm, &files));
        let is_going_on = self.job.as_ref().is_some_and(|job| job.end.is_none());
        let text = tr!("Write {file}", file = farm.job(&document.stem()));
        let button = ui.add_enabled(line.is_ok() && !is_going_on, Button::new(text));
        let help = tr!("Writes the job beside the document; nothing is sent anywhere");
        if button.on_hover_text(help).clicked() {
            out.push(Command::Film(FilmCommand::WriteJob));
        }
        if let Ok(line) = &line {
            command_text(ui, line, tr!("Copy the command that writes the job"), out);
        }
        // A job of another farm is submitted in another way.
        let is_own = |job: &JobRun| job.document == document.path && job.farm == farm.to;
        let is_shown = |job: &&JobRun| job.end.is_none() || is_own(job);
        let Some(job) = self.job.as_ref().filter(is_shown) else { return };
        written(ui, job, out);
        if job.end == Some(RunEnd::Failed) && job.file.is_file() {
            let file = job.file.file_name().unwrap_or_default().to_string_lossy();
            let help = tr!("The file that is there gives way to the new job");
            if ui.button(tr!("Replace {file}")).on_hover_text(help).clicked() {
                self.replaces_job = true;
                out.push(Command::Film(FilmCommand::WriteJob));
            }
        }
    }

    /// Shows the greatest number of frames of a task: the shot's own, where one is open.
    fn chunk_row(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        numbers: [u32; 2],
        out: &mut Vec<Command>,
    ) {
        let (label, help) = (tr!("Frames a task"), tr!("Greatest number of frames of a task"));
        let Some(shot) = session.shot() else {
            labelled(ui, label, help, |ui, _| {
                self.chunk = chunk_field(ui, numbers).1.unwrap_or(self.chunk);
            });
            return;
        };
        let own = (shot.shot().chunk.is_some(), ShotEdit::SetChunk { chunk: None });
        inherited(ui, shot, (label, help), own, out, |ui, _, out| {
            let (field, changed) = chunk_field(ui, numbers);
            let edit = changed.map(|chunk| ShotEdit::SetChunk { chunk: Some(chunk) });
            out.extend(edit.map(|edit| {
                Command::Scene(SceneCommand::Shot(ShotCommand::EditHeld(field.id, edit)))
            }));
        });
    }
}

/// Shows the farms; the job is for one of them.
fn farms(ui: &mut Ui, to: &str, out: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        for farm in FARMS {
            let is_it = to == farm.word;
            let response = ui.selectable_label(is_it, farm.word);
            let name = tr!("Farm {name}", name = farm.word);
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
            let help = tr!("Submitted by {command}", command = farm.submitted_by);
            if response.on_hover_text(help).clicked() {
                out.push(Command::KeepFarm(farm.word));
            }
        }
    });
}

/// Shows the field for the frames of a task, and how many tasks so many frames are. Returns the
/// field, and the number where it changed.
fn chunk_field(ui: &mut Ui, [mut chunk, frames]: [u32; 2]) -> (Response, Option<u32>) {
    let response = ui.add(number_field(ui, &mut chunk).range(1..=100_000).speed(0.2));
    response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Frames a task")));
    let tasks = (frames as usize).div_ceil(chunk.max(1) as usize);
    let text = trn!(tasks, "{tasks} task", "{tasks} tasks");
    ui.label(RichText::new(text).color(theme::of(ui).dim));
    let changed = response.changed().then_some(chunk);
    (response, changed)
}

/// Shows where the job is, and how it is submitted.
fn written(ui: &mut Ui, job: &JobRun, out: &mut Vec<Command>) {
    let colors = theme::of(ui);
    let Some(end) = job.end else {
        hint(ui, tr!("Looking for the files that the frames are made of ..."));
        return;
    };
    if end == RunEnd::Done {
        ui.label(tr!("The job is {file}", file = job.file.display()));
        // As it is named in the folder of its tasks.
        let name = job.file.strip_prefix(&job.line.folder).unwrap_or(&job.file).to_string_lossy();
        if let Some(farm) = Farm::named(job.farm) {
            let by = farm.submitted_by.tr().replace("FILE", &name);
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(tr!("Submit it by")).color(colors.dim));
                ui.label(RichText::new(&by).monospace());
                let copy = ui.small_button(tr!("Copy"));
                let label = tr!("Copy the command that submits the job");
                copy.widget_info(|| WidgetInfo::labeled(Role::Button, true, label));
                if copy.on_hover_text(tr!("Copies it, with the way to its folder")).clicked() {
                    let folder = job.line.folder.display();
                    out.push(Command::Copy(format!("cd '{folder}' && {by}")));
                }
                let folder = ui.small_button(tr!("Open folder"));
                if folder.on_hover_text(job.line.folder.display().to_string()).clicked() {
                    let folder = job.line.folder.clone();
                    out.push(Command::Film(FilmCommand::OpenPath(folder)));
                }
            });
        }
    }
    // Warnings, such as of files that the machines would lack, stand before the last line.
    let is_last = |index: usize| end == RunEnd::Done && index + 1 == job.messages.len();
    for (index, message) in job.messages.iter().enumerate().filter(|(at, _)| !is_last(*at)) {
        let is_error =
            end != RunEnd::Done && index + 1 == job.messages.len() || message.starts_with("error");
        let color = match (is_error, message.starts_with("warning")) {
            (true, _) => colors.error,
            (false, true) => colors.warning,
            (false, false) => colors.dim,
        };
        ui.label(RichText::new(message).small().color(color));
    }
}
