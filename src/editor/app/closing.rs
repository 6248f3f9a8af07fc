//! Closing of the window: what it would lose is asked about, and what it would stop.

use chiaro_locale::tr;
use eframe::egui::{self, RichText, Ui, ViewportCommand};

use super::App;
use super::files::PendingAction;
use crate::widgets::confirm;

impl App {
    /// Closes the window where that is due; keeps it open where closing it would stop or lose
    /// something that nobody has been asked about.
    pub(super) fn close_or_stay(&mut self, ctx: &egui::Context) {
        if self.closes {
            return ctx.send_viewport_cmd(ViewportCommand::Close);
        }
        if !ctx.input(|input| input.viewport().close_requested()) {
            return;
        }
        if !self.stopped_by_closing().is_empty() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.asks_to_stop = true;
        } else if self.session.is_painting_dirty() && !self.session.keeps_painting()
            || self.session.is_dirty() && !self.session.keeps_work()
        {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.pending = Some(PendingAction::Close);
        }
    }

    /// Runs beside the window that closing it would stop, each in a sentence.
    fn stopped_by_closing(&self) -> Vec<String> {
        self.bench.frames.going_on().into_iter().chain(self.bench.wedge.going_on()).collect()
    }

    /// Asks whether closing the window is to stop what runs beside it.
    pub(super) fn ask_to_stop(&mut self, ui: &Ui) {
        if !self.asks_to_stop {
            return;
        }
        let runs = self.stopped_by_closing();
        if runs.is_empty() {
            // What would have been stopped is done: the window closes, as was asked.
            self.asks_to_stop = false;
            return self.do_or_ask(PendingAction::Close);
        }
        let keeps = self.session.is_dirty() && self.session.keeps_work();
        let (mut stops, mut stays) = (false, false);
        let modal = egui::Modal::new(egui::Id::unique("runs")).show(ui.ctx(), |ui| {
            ui.set_width(360.0);
            stops = confirm::enters(ui);
            ui.label(RichText::new(tr!("Closing stops what is being made")).heading());
            runs.iter().for_each(|run| drop(ui.label(run)));
            if keeps {
                ui.label(tr!("What is not saved is kept, and offered at the next start."));
            }
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                stops |= ui.button(tr!("Stop and close")).clicked();
                stays = ui.button(tr!("Stay")).clicked();
            });
        });
        if stops {
            self.asks_to_stop = false;
            self.bench.frames.stop();
            self.bench.wedge.stop();
            self.do_or_ask(PendingAction::Close);
        } else if stays || modal.should_close() {
            self.asks_to_stop = false;
        }
    }
}
