//! Positions of controls on the screen, for the tour to point at. A control notes its position
//! while it is shown.

use std::collections::HashMap;

use eframe::egui::{Context, Id, Rect, Ui};

use crate::commands::PanelId;
use crate::ids::{NodeId, PortName};

/// Control that can be pointed at.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Spot {
    /// A whole panel.
    Panel(PanelId),
    /// The picture itself, without the controls above it.
    Picture,
    /// The button that adds a layer.
    AddLayer,
    /// A row of the stack of layers.
    Layer(NodeId),
    /// A row of the inspector.
    Input(PortName),
    /// The button that saves.
    Save,
    /// The menu that adds a light to the scene.
    AddSceneLight,
    /// The switch that places lights.
    PlaceLight,
}

/// Positions on the screen, each with the frame that it was seen in.
type SpotPlaces = HashMap<Spot, (Rect, u64)>;

/// Notes the position of a control, as far as it is seen.
pub(crate) fn note(ui: &Ui, spot: Spot, rect: Rect) {
    let rect = rect.intersect(ui.clip_rect());
    if rect.is_positive() {
        let frame = ui.ctx().cumulative_frame_nr();
        ui.data_mut(|data| {
            data.get_temp_mut_or_default::<SpotPlaces>(id()).insert(spot, (rect, frame))
        });
    }
}

/// Position of a control, if it is seen.
pub(crate) fn find(ctx: &Context, spot: &Spot) -> Option<Rect> {
    let now = ctx.cumulative_frame_nr();
    let (rect, frame) =
        ctx.data_mut(|data| data.get_temp_mut_or_default::<SpotPlaces>(id()).get(spot).copied())?;
    // A control that is shown later in a frame was last noted in the frame before.
    (frame + 1 >= now).then_some(rect)
}

fn id() -> Id {
    Id::unique("spots")
}
