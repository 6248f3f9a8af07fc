//! Row of the timeline below the ruler while a flip book is open: how far each frame is from the
//! other version's, and the ways to the frames that are wrong.

use chiaro_locale::{tr, trn};
use eframe::egui::{
    Button, Rect, RichText, Role, ScrollArea, Sense, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::axis::Axis;
use super::{NAMES, Timeline};
use crate::commands::Command;
use crate::film::FrameList;
use crate::tools::PictureTools;
use crate::tools::flip::FlipBook;
use crate::tools::playback::time_of;
use crate::widgets::number::number_field;
use crate::widgets::theme;

/// Height of the row, in points.
const HEIGHT: f32 = 30.0;
/// Greatest number of frames in the list.
const LISTED: usize = 500;

/// Shows the row, where a flip book is open.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    tools: &mut PictureTools,
    axis: Axis,
    out: &mut Vec<Command>,
) {
    let flip = tools.of_mut::<FlipBook>();
    if flip.name().is_none() {
        return;
    }
    let size = vec2(ui.available_width(), HEIGHT);
    let (row, _) = ui.allocate_exact_size(size, Sense::hover());
    let names = Rect::from_min_size(row.min, vec2(NAMES - 8.0, HEIGHT));
    let mut head = ui.new_child(UiBuilder::new().id_salt("differences").max_rect(names));
    let chosen = head.horizontal_centered(|ui| controls(ui, flip, timeline)).inner;
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), row.y_range());
    let clicked = strip(ui, flip, timeline, axis, lane);
    if let Some(frame) = chosen.or(clicked) {
        timeline.clock.stop();
        out.push(Command::SetTime(time_of(frame, timeline.fps)));
    }
}

/// Shows the threshold, the list of frames beyond it, and the way to the worst; gives the frame
/// that is chosen.
fn controls(ui: &mut Ui, flip: &mut FlipBook, timeline: &Timeline) -> Option<i32> {
    ui.spacing_mut().item_spacing.x = 3.0;
    let mut chosen = None;
    let greatest = flip.greatest();
    let help = tr!("Goes to the frame with the greatest difference");
    let button =
        ui.add_enabled(greatest.is_some(), Button::new(tr!("Greatest"))).on_hover_text(help);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Greatest difference")));
    if button.clicked() {
        chosen = greatest;
    }
    let count = flip.wrong().count();
    let open = flip.uncompared(timeline.round().range());
    // How many differ is known once all are compared.
    let text = match open {
        0 => tr!("{count} differ"),
        _ => tr!("{count} of {compared} differ", compared = flip.deltas().count()),
    };
    let menu = ui.menu_button(text, |ui| {
        ScrollArea::vertical().max_height(300.0).show(ui, |ui| {
            for (frame, kind) in flip.wrong().take(LISTED) {
                if ui.button(tr!("Frame {frame} {text}", text = kind.text())).clicked() {
                    chosen = Some(frame);
                    ui.close();
                }
            }
            for (frame, problem) in flip.failed().take(LISTED) {
                ui.label(tr!("Frame {frame}: {problem}"));
            }
            if open > 0 {
                ui.label(trn!(
                    open,
                    "{open} frame is not drawn and compared yet: Cache draws it",
                    "{open} frames are not drawn and compared yet: Cache draws them"
                ));
            }
            ui.label(lacking(&flip.lacking(timeline.round().range())));
        });
    });
    let help = match open {
        0 => tr!("Frames that differ by more than the threshold").to_owned(),
        _ => trn!(
            open,
            "Frames that differ by more than the threshold; {open} is not compared yet",
            "Frames that differ by more than the threshold; {open} are not compared yet"
        ),
    };
    menu.response.on_hover_text(help);
    let drag = number_field(ui, &mut flip.threshold).range(0..=254).prefix("> ").suffix("/255");
    let response = ui.add(drag).on_hover_text(tr!("Differences up to this one count as none"));
    response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Threshold")));
    chosen
}

/// Frames without another version, in words.
fn lacking(frames: &FrameList) -> String {
    match frames.frames().len() {
        0 => tr!("Every frame of the range has another version").to_owned(),
        count => trn!(
            count,
            "Frame {frames} has no other version",
            "{count} frames have no other version: {frames}"
        ),
    }
}

/// Draws the difference of each frame as a bar; gives the frame that is clicked.
fn strip(ui: &Ui, flip: &FlipBook, timeline: &Timeline, axis: Axis, lane: Rect) -> Option<i32> {
    let colors = theme::of(ui);
    let painter = ui.painter_at(lane);
    painter.rect_filled(lane, 3.0, colors.canvas);
    let fps = timeline.fps;
    for (frame, kind) in flip.deltas() {
        let greatest = kind.greatest();
        let x = axis.x(f64::from(frame) / fps)..=axis.x((f64::from(frame) + 1.0) / fps);
        if greatest == 0 {
            let y = lane.bottom() - 2.0..=lane.bottom();
            painter.rect_filled(Rect::from_x_y_ranges(x, y), 0.0, colors.second);
            continue;
        }
        // Small differences are seen beside great ones.
        let part = f32::from(greatest).ln_1p() / 255.0_f32.ln_1p();
        let top = lane.bottom() - 3.0 - part * (lane.height() - 4.0);
        let is_wrong = greatest > flip.threshold;
        let color = if is_wrong { colors.error } else { colors.dim };
        painter.rect_filled(Rect::from_x_y_ranges(x, top..=lane.bottom()), 0.0, color);
    }
    for (frame, _) in flip.failed() {
        let x = axis.x((f64::from(frame) + 0.5) / fps);
        let at = pos2(x, lane.center().y);
        painter.circle_filled(at, 3.0, colors.warning);
    }
    let response = ui.interact(lane, ui.scope_id().with("difference strip"), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Differences")));
    let frame_at = |x: f32| (axis.time(x) * fps).floor() as i32;
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked());
    if let Some(at) = response.hover_pos() {
        let frame = frame_at(at.x);
        let found = flip.deltas().find(|(of, _)| *of == frame);
        let text = found.map_or(tr!("is not compared yet").to_owned(), |(_, kind)| kind.text());
        response.on_hover_ui_at_pointer(|ui| {
            ui.label(RichText::new(tr!("Frame {frame} {text}")));
        });
    }
    clicked.map(|at| frame_at(at.x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_without_another_version_are_named() {
        let told = |frames: &[i32]| lacking(&FrameList::of(frames.to_vec()));
        assert_eq!(told(&[]), "Every frame of the range has another version");
        assert_eq!(told(&[5]), "Frame 5 has no other version");
        assert_eq!(told(&[3, 4, 5, 9]), "4 frames have no other version: 3-5,9");
    }
}
