//! Cost of a layer at the end of its row, from the picture that was just drawn.

use std::collections::HashMap;

use chiaro_locale::tr;
use eframe::egui::{Align2, FontId, Rect, Role, Sense, Ui, WidgetInfo, pos2};

use crate::ids::NodeId;
use crate::state::picture_cost::PictureCost;
use crate::state::stack::owners::{LayerOwner, LayerOwners};
use crate::state::stack::tree::LayerTree;
use crate::widgets::theme;

/// Width of the number, and the least width that is left of the name, in points.
const WIDTH: f32 = 32.0;
const LEAST_NAME: f32 = 40.0;

/// Costs of a look's layers in a picture.
pub(super) struct LayerCosts<'c> {
    cost: &'c PictureCost,
    /// Shares of the picture's time, 0 to 1.
    shares: HashMap<NodeId, f64>,
}

/// Cost of a layer.
#[derive(Clone, Copy)]
pub(super) struct LayerCost<'c> {
    cost: &'c PictureCost,
    /// Share of the picture's time, 0 to 1.
    share: f64,
}

impl<'c> LayerCosts<'c> {
    pub(super) fn new(cost: &'c PictureCost, owners: &LayerOwners) -> Self {
        let one = owners.shares(cost).into_iter().filter_map(|share| match share.owner {
            LayerOwner::One(id) => Some((id, share.share)),
            LayerOwner::Several => None,
        });
        Self { cost, shares: one.collect() }
    }

    /// Cost of a layer; of a closed folder with all that is in it.
    pub(super) fn of(&self, tree: &LayerTree, id: &NodeId, is_closed: bool) -> LayerCost<'c> {
        let share = |id: &NodeId| self.shares.get(id).copied().unwrap_or(0.0);
        let share = match is_closed {
            true => tree.with_inner(id).iter().map(share).sum(),
            false => share(id),
        };
        LayerCost { cost: self.cost, share }
    }
}

impl LayerCost<'_> {
    /// Shows the cost of the layer `title` at the right of a row's room for the name. Returns the
    /// room that is left.
    pub(super) fn show(self, ui: &Ui, room: Rect, title: &str) -> Rect {
        if self.cost.operations.is_empty() || room.width() < WIDTH + LEAST_NAME {
            return room;
        }
        let place = Rect::from_min_max(pos2(room.right() - WIDTH, room.top()), room.max);
        let response = ui.interact(place, ui.scope_id().with("cost"), Sense::hover());
        let told = self.cost.share_text(self.share);
        response
            .widget_info(|| WidgetInfo::labeled(Role::Label, true, tr!("Cost of {title}: {told}")));
        let font = FontId::proportional(theme::SMALL_TEXT);
        let text = format!("{:.0} %", 100.0 * self.share);
        ui.painter().text(
            place.right_center(),
            Align2::RIGHT_CENTER,
            text,
            font,
            theme::of(ui).dim,
        );
        let help =
            tr!("Its part of the picture's time, estimated by the operations in the code of its \
                 nodes; what several layers share is not in it. Cost and accuracy tells more.");
        response.on_hover_text(format!("{told}\n{help}"));
        Rect::from_min_max(room.min, pos2(place.left() - 4.0, room.bottom()))
    }
}
