//! Parts that are dropped: on a layer, on the stack, on the canvas or a wire there, on an input of
//! the inspector, or on an object in the picture.

use chiaro_locale::tr;
use eframe::egui::{Context, DragAndDrop, Id, Pos2, Rect, Stroke, StrokeKind, Ui};

use super::part_card::DraggedPart;
use crate::commands::{Command, LibraryCommand, PanelId, PartSpot};
use crate::panels::Workbench;
use crate::state::session::Session;
use crate::state::stack::tree::LayerTree;
use crate::widgets::spots::{self, Spot};
use crate::widgets::theme;

/// Marks the place under a part that is dragged, and puts the part there once it is let go.
pub(super) fn each_frame(bench: &Workbench, ui: &Ui, session: &Session) -> Vec<Command> {
    let Some(part) = DragAndDrop::payload::<DraggedPart>(ui.ctx()) else {
        return Vec::new();
    };
    let at = ui.input(|input| input.pointer.latest_pos());
    let found = at.and_then(|at| spot_at(bench, ui.ctx(), session, at));
    let (spot, rect) = found.unzip();
    ui.ctx().data_mut(|data| data.insert_temp(goal_id(), spot.clone()));
    if let Some(rect) = rect.flatten() {
        let layer = eframe::egui::LayerId::new(eframe::egui::Order::Foreground, goal_id());
        let stroke = Stroke::new(2.0, theme::of(ui).accent);
        ui.ctx().layer_painter(layer).rect_stroke(rect, 3.0, stroke, StrokeKind::Inside);
    }
    if !ui.input(|input| input.pointer.any_released()) {
        return Vec::new();
    }
    DragAndDrop::clear_payload(ui.ctx());
    let place = |spot| Command::Library(LibraryCommand::Place(part.0.clone(), spot));
    spot.map(place).into_iter().collect()
}

/// Place under the pointer of a part that is dragged.
pub(super) fn goal(ctx: &Context) -> Option<PartSpot> {
    ctx.data(|data| data.get_temp::<Option<PartSpot>>(goal_id())).flatten()
}

/// Words for a place, beside the name of the part.
pub(super) fn words(spot: &PartSpot, session: &Session) -> String {
    let title = |id| session.look_with_library().title(id);
    match spot {
        PartSpot::Selection => tr!("here").to_owned(),
        PartSpot::Layer(id) => tr!("onto {name}", name = title(id)),
        PartSpot::Top => tr!("on top of all").to_owned(),
        PartSpot::Canvas(_) => tr!("onto the canvas").to_owned(),
        PartSpot::Wire(wire) => tr!("into the wire to {node}", node = title(&wire.to.node)),
        PartSpot::Input(port) => tr!("to {port}"),
        PartSpot::Object(object) => tr!("onto {name}", name = object),
    }
}

fn goal_id() -> Id {
    Id::unique("goal of a part")
}

/// Place for a part at a point of the screen, with the rectangle to mark.
fn spot_at(
    bench: &Workbench,
    ctx: &Context,
    session: &Session,
    at: Pos2,
) -> Option<(PartSpot, Option<Rect>)> {
    let hit = |spot: Spot| spots::find(ctx, &spot).filter(|rect| rect.contains(at));
    let tree = LayerTree::of(session.look(), &session.project.catalog);
    for layer in tree.rows(|_| false) {
        if let Some(rect) = hit(Spot::Layer(layer.id.clone())) {
            return Some((PartSpot::Layer(layer.id), Some(rect)));
        }
    }
    if let Some(rect) = hit(Spot::Panel(PanelId::LAYERS)) {
        return Some((PartSpot::Top, Some(rect)));
    }
    let selected = session.selection.nodes.last().and_then(|id| session.graph().nodes.get(id));
    let kind = selected.and_then(|node| session.project.catalog.of(node));
    for port in kind.iter().flat_map(|kind| &kind.inputs) {
        if let Some(rect) = hit(Spot::Input(port.name.clone())) {
            return Some((PartSpot::Input(port.name.clone()), Some(rect)));
        }
    }
    if hit(Spot::Panel(PanelId::GRAPH)).is_some() {
        let wire = bench.canvas.wire_at(session, at).map(PartSpot::Wire);
        let place = bench.canvas.place_for(Some(at));
        let canvas = PartSpot::Canvas([f64::from(place.x), f64::from(place.y)]);
        return Some((wire.unwrap_or(canvas), None));
    }
    if hit(Spot::Picture).is_some() {
        let object = bench.viewport.hovered().cloned().map(PartSpot::Object);
        return Some((object.unwrap_or(PartSpot::Selection), None));
    }
    let others = [PanelId::INSPECTOR, PanelId::LIGHTS, PanelId::PROFILE];
    let rect = others.into_iter().find_map(|panel| hit(Spot::Panel(panel)))?;
    Some((PartSpot::Selection, Some(rect)))
}
