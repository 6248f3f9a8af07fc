//! Cost of a layer at the end of its row, from the picture that was just drawn.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

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

/// Shares of a look's layers in the time of the picture that was just drawn.
#[derive(Default)]
pub(super) struct LayerShares {
    /// Operations that the shares were found in.
    of: Option<Arc<BTreeMap<NodeId, u64>>>,
    /// Shares of layers, 0 to 1.
    shares: HashMap<NodeId, f64>,
}

/// Cost of a layer.
#[derive(Clone, Copy)]
pub(super) struct LayerCost<'c> {
    cost: &'c PictureCost,
    /// Share of the picture's time, 0 to 1.
    share: f64,
}

impl LayerShares {
    /// Forgets the shares, as nodes work for other layers now.
    pub(super) fn forget(&mut self) {
        self.of = None;
    }

    /// Finds the shares anew where the operations of a picture are others.
    pub(super) fn update(&mut self, cost: &PictureCost, owners: &LayerOwners) {
        if self.of.as_ref().is_some_and(|of| Arc::ptr_eq(of, &cost.operations)) {
            return;
        }
        let one = owners.shares(&cost.operations).into_iter();
        let one = one.filter_map(|share| match share.owner {
            LayerOwner::One(id) => Some((id, share.share)),
            LayerOwner::Several => None,
        });
        self.shares = one.collect();
        self.of = Some(cost.operations.clone());
    }

    /// Cost of a layer; of a closed folder with all that is in it.
    pub(super) fn cost_of<'c>(
        &self,
        cost: &'c PictureCost,
        tree: &LayerTree,
        (id, is_closed): (&NodeId, bool),
    ) -> LayerCost<'c> {
        let share = |id: &NodeId| self.shares.get(id).copied().unwrap_or(0.0);
        let share = match is_closed {
            true => tree.with_inner(id).iter().map(share).sum(),
            false => share(id),
        };
        LayerCost { cost, share }
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
