//! Where controls are on the screen, for who points at them: the tour. A control notes its place
//! while it is shown.

use std::collections::HashMap;

use eframe::egui::{Context, Id, Rect, Ui};

use crate::commands::PanelId;
use crate::ids::{NodeId, PortName};

/// Something that can be pointed at.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Spot {
    /// All of a panel.
    Panel(PanelId),
    /// The picture itself, without what is above it.
    Picture,
    /// What adds a layer.
    AddLayer,
    /// A row of the stack of layers.
    Layer(NodeId),
    /// A row of the inspector.
    Input(PortName),
    /// What saves.
    Save,
}

/// Places on the screen, each with the frame that it was seen in.
type SpotPlaces = HashMap<Spot, (Rect, u64)>;

/// Says where something is, as far as it is seen.
pub(crate) fn note(ui: &Ui, spot: Spot, rect: Rect) {
    let rect = rect.intersect(ui.clip_rect());
    if rect.is_positive() {
        let frame = ui.ctx().cumulative_frame_nr();
        ui.data_mut(|data| {
            data.get_temp_mut_or_default::<SpotPlaces>(id()).insert(spot, (rect, frame))
        });
    }
}

/// Where something is, if it is seen.
pub(crate) fn find(ctx: &Context, spot: &Spot) -> Option<Rect> {
    let now = ctx.cumulative_frame_nr();
    let (rect, frame) =
        ctx.data_mut(|data| data.get_temp_mut_or_default::<SpotPlaces>(id()).get(spot).copied())?;
    // What is shown later in a frame was seen in the one before.
    (frame + 1 >= now).then_some(rect)
}

fn id() -> Id {
    Id::unique("spots")
}
