//! Commands about painting light on the picture.

use eframe::egui::Ui;

use super::App;
use crate::commands::{FitCommand, MaskCommand, PanelId, SketchCommand};
use crate::tools::fitting::FitTool;
use crate::tools::placing::PlacingTool;
use crate::tools::probe::Probe;

impl App {
    pub(super) fn apply_to_fitting(&mut self, ui: &Ui, command: FitCommand) {
        let Self { bench, session, .. } = self;
        let fitting = bench.tools.of_mut::<FitTool>();
        let commands = match command {
            FitCommand::Turn(switch) => {
                let on = switch.turned(fitting.is_on());
                return self.turn_fitting(ui, on);
            }
            FitCommand::Leave => fitting.leave(session),
            FitCommand::Discard => fitting.discard(),
            FitCommand::Clear => fitting.clear(session),
            FitCommand::Apply => return self.apply_fit(),
            FitCommand::Fit(goal) => return fitting.fit(goal, session),
            FitCommand::Stop => return fitting.stop(),
            FitCommand::TakeBrush(brush) => return fitting.take_brush(brush),
            FitCommand::ResizeBrush { is_larger } => return fitting.resize_brush(is_larger),
            FitCommand::Back => {
                if let Some(standpoint) = session.sketchbook.sketch().standpoint() {
                    (session.view.orbit, session.view.time) = standpoint.back(&session.view.orbit);
                }
                return;
            }
        };
        commands.into_iter().for_each(|command| self.carry_out(ui, command));
    }

    /// Takes on the fitted look, as one step.
    fn apply_fit(&mut self) {
        let fitting = self.bench.tools.of_mut::<FitTool>();
        let Some(edit) = fitting.take_on(&self.session) else { return };
        self.session.set_preview(None);
        self.tell(|session| session.apply(edit, None));
        self.bench.tools.of_mut::<FitTool>().is_taken_on(&self.session);
    }

    /// Begins or ends painting on the picture. The probe and the turntable are turned off, since
    /// they would be in the way.
    pub(super) fn turn_fitting(&mut self, ui: &Ui, on: bool) {
        let commands = self.bench.tools.of_mut::<FitTool>().turn(on, &self.session);
        commands.into_iter().for_each(|command| self.carry_out(ui, command));
        if on {
            self.bench.tools.of_mut::<Probe>().turn(false);
            self.bench.tools.of_mut::<PlacingTool>().turn(false);
            self.apply_to_masking(ui, MaskCommand::Leave);
            self.bench.viewport.stop_turning();
            self.start = None;
            self.dock.open(PanelId::PICTURE);
            self.dock.open(PanelId::FIT);
        }
    }

    pub(super) fn apply_to_sketch(&mut self, command: SketchCommand) {
        match command {
            SketchCommand::Open(is_open) => self.session.sketchbook.sketch.is_open = is_open,
            SketchCommand::Paint { label, from, tile } => {
                self.session.paint_sketch(label, *from, tile);
            }
            SketchCommand::Preview(look) => self.session.set_preview(look),
        }
    }
}
