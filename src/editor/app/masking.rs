//! Commands about masks that are painted on the mesh.

use chiaro_locale::tr;
use eframe::egui::Ui;

use super::App;
use crate::commands::{MaskCommand, PanelId};
use crate::ids::NodeId;
use crate::state::masks::MaskLaying;
use crate::tools::masking::{MaskTool, lacks_colors, laying};
use crate::tools::placing::PlacingTool;
use crate::tools::probe::Probe;

impl App {
    pub(super) fn apply_to_masking(&mut self, ui: &Ui, command: MaskCommand) {
        match command {
            MaskCommand::New(layer) => {
                let laying = laying(&self.session.snapshot());
                if self.attempt(|session| session.new_mask(&layer, &laying)).is_none() {
                    return;
                }
                self.paint_mask_of(ui, Some(layer));
                if laying != MaskLaying::Uvs {
                    let told = tr!(
                        "This mesh has no UVs: its mask lies straight through it, as it is seen now"
                    );
                    self.bench.tools.of_mut::<MaskTool>().tell(told.to_owned());
                }
            }
            MaskCommand::Paint(layer) => {
                let Some(copied) = self.attempt(|session| session.own_mask(&layer)) else {
                    return;
                };
                self.paint_mask_of(ui, Some(layer));
                if let Some([other, own]) = copied {
                    let told =
                        tr!("{other} is shown by others, too: a copy of it is painted, {own}");
                    self.bench.tools.of_mut::<MaskTool>().tell(told);
                }
            }
            MaskCommand::Keep(step) => self.tell(|session| session.paint_mask(step)),
            MaskCommand::CheckColors if lacks_colors(&self.session.snapshot()) => {
                let told = tr!(
                    "The mesh has no vertex colors, which count as white: nothing is hidden until \
                     it brings some"
                );
                self.message = Some(told.to_owned());
            }
            MaskCommand::CheckColors => {}
            MaskCommand::Leave => self.paint_mask_of(ui, None),
        }
    }

    /// Begins to paint the mask of a layer, or ends painting.
    fn paint_mask_of(&mut self, ui: &Ui, layer: Option<NodeId>) {
        let is_on = layer.is_some();
        self.bench.tools.of_mut::<MaskTool>().turn(layer, &self.session);
        // Others take the pointer too, and the turntable carries the model away from it.
        if is_on {
            self.bench.tools.of_mut::<Probe>().turn(false);
            self.bench.tools.of_mut::<PlacingTool>().turn(false);
            self.bench.viewport.stop_turning();
            self.turn_fitting(ui, false);
            self.start = None;
            self.dock.open(PanelId::PICTURE);
        }
    }
}
