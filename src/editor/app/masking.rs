//! Commands about masks that are painted on the mesh.

use chiaro_locale::tr;
use eframe::egui::Ui;

use super::App;
use crate::commands::{MaskCommand, PanelId};
use crate::diag::Diagnostic;
use crate::ids::NodeId;
use crate::state::masks::{MaskLaying, MaskPicture, SIDE};
use crate::state::session::Session;
use crate::state::stack::Stack;
use crate::tools::masking::{MaskTool, laying};
use crate::tools::placing::PlacingTool;
use crate::tools::probe::Probe;

impl App {
    pub(super) fn apply_to_masking(&mut self, ui: &Ui, command: MaskCommand) {
        match command {
            MaskCommand::New(layer) => {
                let mut made = None;
                self.tell(|session| {
                    made = Some(new_mask(session, &layer)?);
                    Ok(())
                });
                if made.is_some() {
                    self.paint_mask_of(ui, Some(layer));
                }
                if made == Some(MaskLaying::Uvs) || made.is_none() {
                    return;
                }
                self.bench.tools.of_mut::<MaskTool>().tell(
                    tr!(
                        "This mesh has no UVs: its mask lies straight through it, as it is seen now"
                    )
                    .to_owned(),
                );
            }
            MaskCommand::Paint(layer) => self.paint_mask_of(ui, Some(layer)),
            MaskCommand::Keep(step) => self.tell(|session| session.paint_mask(step)),
            MaskCommand::Leave => self.paint_mask_of(ui, None),
        }
    }

    /// Begins to paint the mask of a layer, or ends painting.
    fn paint_mask_of(&mut self, ui: &Ui, layer: Option<NodeId>) {
        let is_on = layer.is_some();
        self.bench.tools.of_mut::<MaskTool>().turn(layer);
        self.session.masks.is_open = is_on;
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

/// Gives a layer a mask that hides it, in a new file beside the look's. Returns the way in which it
/// lies.
fn new_mask(session: &mut Session, layer: &NodeId) -> Result<MaskLaying, Box<Diagnostic>> {
    let problem = |message: &str| Box::new(Diagnostic::error("no-mask", message));
    let Some(path) = session.path().map(std::path::Path::to_path_buf) else {
        return Err(problem(tr!("save the look first: its mask is a picture beside its file")));
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().unwrap_or(std::path::Path::new("."));
    let mut names = std::iter::once(format!("{stem}-mask.png"))
        .chain((2..1000).map(|number| format!("{stem}-mask-{number}.png")));
    let name = names
        .find(|name| !folder.join(name).exists())
        .ok_or_else(|| problem(tr!("there are too many masks beside the look's file")))?;
    session.write_mask(&folder.join(&name), &MaskPicture::filled([SIDE, SIDE], 0))?;
    let laying = laying(&session.snapshot());
    let (mask, edit) = Stack::mask_by_picture(session.look(), layer, (&name, &laying));
    session.apply(edit, None)?;
    session.select(vec![mask]);
    Ok(laying)
}
