//! Progress of frames: a mark for each, the time that is left, and what is wrong at which frame.

use std::time::Duration;

use chiaro_locale::{tr, trn};
use eframe::egui::{Color32, Rect, RichText, Role, Sense, Ui, WidgetInfo, pos2, vec2};

use super::FrameRun;
use crate::commands::{Command, FilmCommand, PanelId};
use crate::state::runs::{FrameFate, RunEnd};
use crate::state::session::Session;
use crate::widgets::theme;

/// Height of the marks, in points.
const HEIGHT: f32 = 14.0;
/// Interval at which the time is told anew, in seconds.
const TICK: f64 = 0.5;

/// Shows the progress.
pub(super) fn show(ui: &mut Ui, frames: &FrameRun, session: &Session, out: &mut Vec<Command>) {
    let [whole, all] = frames.progress.count();
    let colors = theme::of(ui);
    let (text, color) = match frames.end {
        None => (going_on(frames, [whole, all]), colors.text),
        Some(RunEnd::Done) => (
            trn!(
                whole,
                "{whole} frame in {time}",
                "{whole} frames in {time}",
                time = time(frames.seconds)
            ),
            colors.text,
        ),
        Some(RunEnd::Stopped) => (tr!("Stopped: {whole} of {all} are whole"), colors.warning),
        Some(RunEnd::Failed) => (tr!("{whole} of {all} are whole"), colors.error),
    };
    let stale_by = frames.stale_by.as_ref().filter(|_| frames.end.is_some());
    let color = if stale_by.is_some() { colors.dim } else { color };
    ui.label(RichText::new(text).color(color));
    if let Some(name) = stale_by {
        let text = tr!("{name} was changed since: these frames are of what it was before");
        ui.label(RichText::new(text).color(colors.warning));
    }
    if frames.end.is_none() {
        ui.ctx().request_repaint_after(Duration::from_secs_f64(TICK));
    }
    marks(ui, frames, session, out);
    for (frame, reason) in frames.progress.failed().take(12) {
        ui.horizontal_wrapped(|ui| {
            let go = ui.link(tr!("Frame {frame}")).on_hover_text(tr!("Brings the playhead there"));
            if go.clicked() {
                out.push(Command::SetTime(time_of(session, frame)));
            }
            ui.label(RichText::new(reason).color(colors.error));
        });
    }
    if let (Some(end), Some(last)) = (frames.end, frames.progress.messages().last()) {
        let is_told = match end {
            RunEnd::Done => false,
            // What a driver says as it is taken away means nothing.
            RunEnd::Stopped => true,
            RunEnd::Failed => frames.progress.failed().next().is_some(),
        };
        if !is_told {
            ui.label(RichText::new(last).small().color(colors.dim));
        }
    }
    if frames.end.is_none() || whole == 0 {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        let help =
            tr!("Compares these frames with those of the window, and finds the one that differs");
        if ui.button(tr!("Flip book")).on_hover_text(help).clicked() {
            out.push(Command::ShowPanel(PanelId::TIMELINE));
            out.push(Command::CompareFrames(Some(frames.first.clone())));
        }
        let help = frames.folder.display().to_string();
        if ui.button(tr!("Open folder")).on_hover_text(help).clicked() {
            out.push(Command::Film(FilmCommand::OpenPath(frames.folder.clone())));
        }
    });
}

/// The state of a run that goes on, in words.
fn going_on(frames: &FrameRun, [whole, all]: [usize; 2]) -> String {
    let passed = frames.clock.seconds();
    match frames.progress.seconds_left(passed) {
        Some(left) => tr!(
            "{whole} of {all}, {passed}, about {left} left",
            passed = time(passed),
            left = time(left)
        ),
        None => trn!(
            all,
            "Opening and compiling, {passed} ({all} frame)",
            "Opening and compiling, {passed} ({all} frames)",
            passed = time(passed)
        ),
    }
}

/// A time in words.
fn time(seconds: f64) -> String {
    match seconds {
        ..10.0 => format!("{seconds:.1} s"),
        ..100.0 => format!("{seconds:.0} s"),
        seconds => format!("{:.0} min", seconds / 60.0),
    }
}

/// Time of a frame, in seconds.
fn time_of(session: &Session, frame: i32) -> f64 {
    match session.shot() {
        Some(shot) => shot.rate().time(frame),
        None => {
            let scene = session.open_scene().map(|open_scene| open_scene.scene().time.fps);
            f64::from(frame) / scene.unwrap_or(24.0)
        }
    }
}

/// Shows a mark for each frame; a click brings the playhead to the frame.
fn marks(ui: &mut Ui, frames: &FrameRun, session: &Session, out: &mut Vec<Command>) {
    let colors = theme::of(ui);
    let size = vec2(ui.available_width(), HEIGHT);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let [whole, all] = frames.progress.count();
    let name = tr!("Frames: {whole} of {all} are whole");
    response.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, &name));
    let is_stale = frames.stale_by.is_some() && frames.end.is_some();
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 2.0, colors.well);
    let count = frames.progress.frames().len().max(1);
    let step = rect.width() / count as f32;
    let gap = if step > 4.0 { 1.0 } else { 0.0 };
    for (index, (_, fate)) in frames.progress.frames().enumerate() {
        let color: Color32 = match fate {
            None => continue,
            Some(FrameFate::Failed(_)) => colors.error,
            Some(_) if is_stale => colors.dim.gamma_multiply(0.5),
            Some(FrameFate::Drawn(_)) => colors.accent,
            Some(FrameFate::Kept) => colors.second,
            Some(FrameFate::Equal(_)) => colors.accent_dim,
        };
        let left = rect.left() + index as f32 * step;
        let mark = Rect::from_min_max(
            pos2(left, rect.top()),
            pos2(left + (step - gap).max(0.5), rect.bottom()),
        );
        painter.rect_filled(mark, 0.0, color);
    }
    let at = response.hover_pos().or(response.interact_pointer_pos());
    let index = at.map(|at| ((at.x - rect.left()) / step).max(0.0) as usize);
    let found = index.and_then(|index| frames.progress.frames().nth(index));
    if let Some((frame, _)) = found.filter(|_| response.clicked()) {
        out.push(Command::SetTime(time_of(session, frame)));
    }
    if let Some((frame, fate)) = found {
        let fate = fate.map_or_else(|| tr!("not drawn yet").to_owned(), FrameFate::text);
        response.on_hover_text(match is_stale {
            false => tr!("Frame {frame}: {fate}"),
            true => tr!("Frame {frame}: {fate}, before the last change"),
        });
    }
}
