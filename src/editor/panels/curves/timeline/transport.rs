//! Transport of the timeline: play, step, the ways to play, and the frames that are kept.

use chiaro_locale::{tr, trn};
use eframe::egui::{
    Align, Button, ComboBox, Event, Key, Label, Layout, Modifiers, PointerButton, Rect, RichText,
    Role, Stroke, Ui, UiBuilder, WidgetInfo, vec2,
};

use super::axis::Axis;
use super::clock::SPEEDS;
use super::{Timeline, markers, shot_tracks};
use crate::commands::{Command, TimelineCommand, keyboard};
use crate::state::session::Session;
use crate::tools::PictureTools;
use crate::tools::flip::FlipBook;
use crate::tools::playback::order::LoopMode;
use crate::tools::playback::{MEMORIES, PlayPace, Playback, frame_at, time_of};
use crate::values;
use crate::widgets::menu;
use crate::widgets::number::{self, number_field, number_field_as};
use crate::widgets::theme;

/// Part of the wanted rate below which the real one is told as slow.
const SLOW: f64 = 0.95;
/// Width of the button that plays or pauses, in points.
const PLAY: f32 = 58.0;
/// Height of the band of kept frames, in points.
const BAND: f32 = 3.0;

/// Shows the buttons to play and to step.
pub(super) fn buttons(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    out: &mut Vec<Command>,
) {
    let is_playing = timeline.clock.is_running();
    let text = if is_playing { tr!("Pause") } else { tr!("Play") };
    let help = tr!("Plays the range (Space over this panel)");
    // As wide as either text, so that nothing beside the button moves.
    let button = Button::new(text).selected(is_playing).min_size(vec2(PLAY, 0.0));
    if ui.add(button).on_hover_text(help).clicked() {
        timeline.toggle(ui, session);
    }
    for (text, name, help, by) in [
        ("⏴", tr!("Previous frame"), tr!("A frame back (Comma over this panel)"), -1),
        ("⏵", tr!("Next frame"), tr!("A frame on (Period over this panel)"), 1),
    ] {
        let response = ui.button(text).on_hover_text(help);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
        if response.clicked() {
            step(timeline, session, by, out);
        }
    }
}

/// Stops, and moves the playhead by frames; beyond an end of the range it comes in at the other.
fn step(timeline: &mut Timeline, session: &Session, by: i32, out: &mut Vec<Command>) {
    timeline.clock.stop();
    let [first, last] = timeline.round().range();
    let now = (session.view.time * timeline.fps).round() as i32;
    let next = now.saturating_add(by);
    let next = if next > last && now <= last {
        first
    } else if next < first && now >= first {
        last
    } else {
        next
    };
    out.push(Command::SetTime(time_of(next, timeline.fps)));
}

/// Does what was asked for by its name.
pub(super) fn answer(
    timeline: &mut Timeline,
    ui: &Ui,
    session: &Session,
    tools: &mut PictureTools,
    out: &mut Vec<Command>,
) {
    let Some(command) = timeline.asked.take() else { return };
    let [start, end] = timeline.clock.part.unwrap_or(timeline.range);
    match command {
        TimelineCommand::Play => timeline.toggle(ui, session),
        TimelineCommand::ToStart => timeline.go(start, out),
        TimelineCommand::ToEnd => timeline.go(end, out),
        TimelineCommand::ToKeyBefore | TimelineCommand::ToKeyAfter => {
            let way = if command == TimelineCommand::ToKeyAfter { 1.0 } else { -1.0 };
            let all = super::times(session).chain(shot_tracks::times(session));
            if let Some(time) = timeline.neighbor(all, session, way) {
                timeline.go(time, out);
            }
        }
        TimelineCommand::AddMarker => {
            markers::add(session, timeline.snapped(session.view.time), out);
        }
        TimelineCommand::ChangeEnd => {
            let all = LoopMode::ALL;
            let now = all.iter().position(|mode| *mode == timeline.clock.mode);
            timeline.clock.mode = all[now.map_or(0, |now| (now + 1) % all.len())];
        }
        TimelineCommand::CacheRange => tools.playback().fill(true),
        TimelineCommand::KeepVersion => {
            let (flip, playback) = tools.pair::<FlipBook, Playback>();
            flip.keep(playback);
        }
    }
}

/// Takes the keys of the transport, over the panel.
pub(super) fn keys(
    timeline: &mut Timeline,
    ui: &Ui,
    session: &Session,
    panel: Rect,
    out: &mut Vec<Command>,
) {
    // A key that was clicked has the focus, which is no field to type into.
    let is_taken = keyboard::is_dialog_open(ui.ctx()) || ui.ctx().text_edit_focused();
    if !ui.rect_contains_pointer(panel) || is_taken {
        return;
    }
    let pressed = |key: Key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    if pressed(Key::Space) {
        timeline.toggle(ui, session);
    }
    for (key, by) in [(Key::Comma, -1), (Key::Period, 1)] {
        if pressed(key) {
            step(timeline, session, by, out);
        }
    }
    let time = session.view.time;
    let [start, end] = timeline.clock.part.unwrap_or(timeline.range);
    if pressed(Key::I) && time < end {
        timeline.clock.part = Some([time, end]);
    }
    if pressed(Key::O) && time > start {
        timeline.clock.part = Some([start, time]);
    }
    if pressed(Key::Home) {
        timeline.go(start, out);
    }
    if pressed(Key::End) {
        timeline.go(end, out);
    }
}

/// Shows the choice of what follows the end of the range.
pub(super) fn mode(timeline: &mut Timeline, ui: &mut Ui) {
    let clock = &mut timeline.clock;
    let combo = ComboBox::from_id_salt("mode").width(70.0);
    let response = menu::choice(ui, combo, clock.mode.label(), |ui| {
        for mode in LoopMode::ALL {
            ui.selectable_value(&mut clock.mode, mode, mode.label()).on_hover_text(mode.help());
        }
    });
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr!("At the end")));
    response.on_hover_text(clock.mode.help());
}

/// Shows the choice of the speed.
pub(super) fn speed(timeline: &mut Timeline, ui: &mut Ui) {
    let clock = &mut timeline.clock;
    let text = |speed: f64| format!("×{}", values::number_text(speed, 2));
    let combo = ComboBox::from_id_salt("speed").width(44.0);
    let response = menu::choice(ui, combo, text(clock.speed), |ui| {
        for speed in SPEEDS {
            ui.selectable_value(&mut clock.speed, speed, text(speed));
        }
    });
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr!("Speed")));
    response.on_hover_text(tr!("Speed, as a factor of the frame rate"));
}

/// Shows the button that plays the whole range again.
pub(super) fn whole_range(timeline: &mut Timeline, ui: &mut Ui) {
    let help = tr!(
        "Plays the whole range again. A drag on the ruler with Shift chooses a part; I and O over \
         this panel set its ends"
    );
    if ui.button(tr!("Whole range")).on_hover_text(help).clicked() {
        timeline.clock.part = None;
    }
}

/// Shows the choice between every frame and real time.
pub(super) fn pace(timeline: &mut Timeline, ui: &mut Ui) {
    let clock = &mut timeline.clock;
    let mut waits = clock.pace == PlayPace::EveryFrame;
    let help = tr!(
        "Shows every frame, later than its time where it is not drawn yet; else those are left out"
    );
    if ui.checkbox(&mut waits, tr!("Every frame")).on_hover_text(help).changed() {
        clock.pace = if waits { PlayPace::EveryFrame } else { PlayPace::RealTime };
    }
}

/// Shows the button that keeps the frames as a version.
pub(super) fn version(ui: &mut Ui, tools: &mut PictureTools) {
    let (flip, playback) = tools.pair::<FlipBook, Playback>();
    let has_frames = playback.cache().frames().next().is_some();
    let help =
        tr!("Keeps these frames, to compare later ones with: a flip book, for which the picture \
             gets buttons. Beside another version that is compared with, where there is one");
    let keep = ui.add_enabled(has_frames, Button::new(tr!("Keep version")));
    if keep.on_hover_text(help).clicked() {
        flip.keep(playback);
    }
}

/// Shows how many frames are kept, the button that draws the others, and the memory.
pub(super) fn cache(ui: &mut Ui, playback: &mut Playback, out: &mut Vec<Command>) {
    ui.separator();
    let is_filling = playback.is_filling();
    let (text, name, help) = match is_filling {
        true => (tr!("Stop"), tr!("Stop drawing"), tr!("Leaves the other frames undrawn")),
        false => (
            tr!("Cache"),
            tr!("Cache range"),
            tr!("Draws the frames of the range ahead, so that they play in real time; after a \
                 first round this begins by itself, and an edit ends it"),
        ),
    };
    let fill = ui.button(text);
    fill.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    if fill.on_hover_text(help).clicked() {
        playback.fill(!is_filling);
    }
    let Some(transport) = playback.transport() else { return };
    let round = transport.order.round;
    let [first, last] = round.range();
    let count = playback.cache().frames().filter(|(at, _)| (first..=last).contains(at)).count();
    let used = playback.cache().bytes().div_ceil(1 << 20);
    let memory = playback.memory();
    let all = round.count();
    let text = tr!("{count}/{all} kept");
    let menu = menu::staying(ui, text, |ui| {
        ui.label(trn!(
            drawn = playback.drawn(),
            "{used} of {memory} MiB in use; {drawn} frame drawn",
            "{used} of {memory} MiB in use; {drawn} frames drawn"
        ));
        let mut chosen = memory;
        for mib in MEMORIES {
            ui.radio_value(&mut chosen, mib, format!("{mib} MiB"));
        }
        let other = ui.add(number_field(ui, &mut chosen).range(1..=1 << 20).suffix(" MiB"));
        other.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Memory of frames")));
        if chosen != memory {
            out.push(Command::KeepFrameMemory(chosen));
        }
        if ui.button(tr!("Drop all frames")).clicked() {
            playback.clear();
            ui.close();
        }
    });
    let name = tr!("{count} of {all} kept");
    menu.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    menu.on_hover_text(tr!(
        "Frames that are kept, and their memory: where it is short, those that are shown last go \
         first"
    ));
    if let Some(problem) = playback.problems().first() {
        let text = RichText::new(tr!("a frame failed")).color(theme::of(ui).error);
        ui.label(text).on_hover_text(&problem.message);
    }
}

/// Shows the frames a second that are really seen.
fn real_rate(ui: &mut Ui, playback: &Playback) {
    let Some(transport) = playback.transport().filter(|transport| transport.is_playing) else {
        return;
    };
    let colors = theme::of(ui);
    let wanted = values::number_text(transport.wanted_rate, 1);
    let (text, color) = match playback.shown_rate(ui.input(|input| input.time)) {
        None => (tr!("- of {wanted} fps"), colors.dim),
        Some(real) => {
            let is_slow = real < transport.wanted_rate * SLOW;
            let color = if is_slow { colors.warning } else { colors.text };
            (tr!("{real:.1} of {wanted} fps"), color)
        }
    };
    let help = tr!("Frames that are really shown a second, of those that should be");
    let text = RichText::new(text).color(color).monospace();
    ui.add(Label::new(text).extend()).on_hover_text(help);
}

/// Draws the frames that are kept as a band along the ruler, and the part that is played.
pub(super) fn band(timeline: &Timeline, ui: &Ui, axis: Axis, playback: &Playback) {
    let colors = theme::of(ui);
    let painter = ui.painter_at(axis.lane);
    let top = axis.lane.top();
    let fps = timeline.fps;
    for run in playback.cache().runs() {
        let [from, to] = [f64::from(*run.start()), f64::from(*run.end()) + 1.0];
        let x = axis.x(from / fps)..=axis.x(to / fps);
        painter.rect_filled(Rect::from_x_y_ranges(x, top..=top + BAND), 0.0, colors.second);
    }
    if let Some([start, end]) = timeline.clock.part {
        let x = axis.x(start)..=axis.x(end);
        let place = Rect::from_x_y_ranges(x, axis.lane.bottom() - 5.0..=axis.lane.bottom());
        painter.rect_filled(place, 0.0, colors.accent);
        for time in [start, end] {
            let stroke = Stroke::new(1.0, colors.accent);
            painter.vline(axis.x(time), axis.lane.y_range(), stroke);
        }
    }
}

/// Takes a drag on the ruler with Shift, which chooses the part of the range that is played; true
/// while it does. Shift counts as it was at the press: in a window that draws slowly, the key may
/// be let go in the same frame in which the drag begins.
pub(super) fn choose_part(
    timeline: &mut Timeline,
    ui: &Ui,
    axis: Axis,
    response: &eframe::egui::Response,
) -> bool {
    let press = |event: &Event| match event {
        Event::PointerButton { pos, button: PointerButton::Primary, pressed: true, modifiers }
            if axis.lane.contains(*pos) =>
        {
            Some((pos.x, modifiers.shift))
        }
        _ => None,
    };
    if let Some((from, is_with_shift)) = ui.input(|input| input.events.iter().find_map(press)) {
        timeline.part_from = is_with_shift.then_some(from);
    }
    let is_dragged = response.dragged() || response.drag_stopped();
    let from = timeline.part_from.filter(|_| is_dragged);
    if !ui.input(|input| input.pointer.any_down()) {
        timeline.part_from = None;
    }
    let Some(from) = from else { return false };
    if let Some(at) = response.interact_pointer_pos() {
        let [a, b] = [from, at.x].map(|x| timeline.snapped(axis.time(x)));
        let [a, b] = [a.min(b), a.max(b)];
        timeline.clock.part = (b - a >= 1.0 / timeline.fps - 1e-6).then_some([a, b]);
    }
    true
}

/// Shows the frame at the playhead, as a field that moves the playhead.
pub(super) fn frame(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    out: &mut Vec<Command>,
) {
    let time = session.view.time;
    let before = (time * timeline.fps * 100.0).round() / 100.0;
    let mut frame = before;
    // Whole frames are told without decimals.
    let text = |frame: f64, _| values::number_text(frame, 2);
    let drag = number_field_as(ui, &mut frame, text, number::read).speed(0.2);
    let response = ui.add(drag.prefix(tr!("timeline" => "Frame ")));
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::SpinButton, true, tr!("Frame at the playhead"));
        info.value = Some(before);
        info
    });
    if frame.is_finite() && frame != before {
        let time = timeline.snapped(frame / timeline.fps);
        timeline.go(time, out);
    }
    response.on_hover_text(match frame_at(time, timeline.fps) {
        None => tr!("Where the playhead is, between two frames"),
        Some(_) => tr!("Where the playhead is: drag, or click to type a frame"),
    });
}

/// Shows the time at the playhead beside the ruler, and the real rate while frames are played:
/// there nothing moves as they come and go.
pub(super) fn time(ui: &mut Ui, place: Rect, session: &Session, playback: &Playback) {
    let builder = UiBuilder::new().max_rect(place).layout(Layout::left_to_right(Align::Center));
    let ui = &mut ui.new_child(builder);
    let seconds = values::number_text(session.view.time, 3);
    let text = RichText::new(tr!("{seconds} s")).monospace().color(theme::of(ui).dim);
    ui.label(text).on_hover_text(tr!("Time at the playhead"));
    real_rate(ui, playback);
}
