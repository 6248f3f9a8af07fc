//! Edges of the selected keys, which scale them in time.

use chiaro_locale::tr;
use eframe::egui::{CursorIcon, Rect, Stroke, Ui, pos2, vec2};

use super::axis::Axis;
use super::{RULER, Timeline, key_bar, markers};
use crate::commands::Command;
use crate::state::session::Session;
use crate::widgets::handle::{focus_ring, handle};
use crate::widgets::theme;

/// Shows the range of the selected keys as a band over the strip of markers, with an edge at each
/// end: dragged, it scales the keys about the other end, with Alt about the playhead.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    axis: Axis,
    out: &mut Vec<Command>,
) {
    let Some([start, end]) = timeline.sheet.range(session) else { return };
    if end - start < super::LEAST {
        return;
    }
    let colors = theme::of(ui);
    let top = axis.lane.top() + RULER + ui.spacing().item_spacing.y;
    let band = Rect::from_x_y_ranges(
        axis.x(start)..=axis.x(end),
        top + markers::STRIP - 5.0..=top + markers::STRIP,
    );
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), band.y_range());
    ui.painter_at(lane).rect_filled(band, 0.0, colors.accent_dim);
    let about_playhead = ui.input(|input| input.modifiers.alt);
    let names = [tr!("Start of the selection"), tr!("End of the selection")];
    for (index, name) in names.into_iter().enumerate() {
        let at = pos2(axis.x([start, end][index]), band.center().y);
        if !lane.x_range().expand(2.0).contains(at.x) {
            continue;
        }
        let id = ui.scope_id().with(("edge of the selection", index));
        let handled = handle(ui, id, at, name, [start, end][index], true);
        let held = timeline.sheet.held_while(session, &handled.response);
        if let Some((to, own)) = handled.to.zip(key_bar::range_of(&held)) {
            let about = if about_playhead { session.view.time } else { own[1 - index] };
            let time = timeline.snapped(axis.time(to.x));
            let scale = (time - about) / (own[index] - about);
            timeline.scale(session, held, (about, scale), handled.response.id, out);
        }
        let is_hot = handled.response.hovered() || handled.response.dragged();
        let color = if is_hot { colors.text } else { colors.accent };
        let edge = Rect::from_center_size(at, vec2(4.0, 12.0));
        ui.painter().rect(edge, 1.0, color, Stroke::NONE, eframe::egui::StrokeKind::Inside);
        focus_ring(ui, &handled.response, at, 6.0);
        handled.response.on_hover_cursor(CursorIcon::ResizeHorizontal).on_hover_text(tr!(
            "Drag to stretch the selected keys about the other end; with Alt about the playhead"
        ));
    }
}
