//! Commands about placing a light by what it does.

use eframe::egui::Ui;

use super::App;
use crate::commands::{MaskCommand, PanelId, PlacingCommand};
use crate::tools::placing::PlacingTool;
use crate::tools::probe::Probe;

impl App {
    pub(super) fn apply_to_placing(&mut self, ui: &Ui, command: PlacingCommand) {
        let Self { bench, session, .. } = self;
        let placing = bench.tools.of_mut::<PlacingTool>();
        let is_on = match command {
            PlacingCommand::Turn(switch) => {
                let on = switch.turned(placing.is_on());
                placing.turn(on);
                on
            }
            PlacingCommand::By(mark) => placing.take(mark),
            PlacingCommand::Leave => {
                if placing.leave(session) {
                    self.session.undo();
                }
                return;
            }
        };
        // Probe and brushes take the pointer too, and the turntable carries the model away from it.
        if is_on {
            bench.tools.of_mut::<Probe>().turn(false);
            bench.viewport.stop_turning();
            self.apply_to_masking(ui, MaskCommand::Leave);
            self.turn_fitting(ui, false);
            self.start = None;
            self.dock.open(PanelId::PICTURE);
        }
    }
}
