//! Row of the selected keys: time and value of one, interpolation, handles, what holds beyond the
//! keys, and their length.

use chiaro_locale::{Text, text, tr, trn};
use eframe::egui::{Button, RichText, Role, Ui, WidgetInfo};

use super::sheet::PickedTrack;
use super::{Timeline, rows};
use crate::commands::Command;
use crate::document::{Extrapolation, HandlePair, TimeInterpolation, TrackEnds};
use crate::fields::lighting::OwnedKeys;
use crate::state::keying::retime;
use crate::state::session::Session;
use crate::widgets::number::number_field;
use crate::widgets::text::hint;
use crate::widgets::theme;
use crate::widgets::value;

/// Interpolations with their names and explanations.
pub(super) const INTERPOLATIONS: [(TimeInterpolation, Text, Text); 4] = [
    (
        TimeInterpolation::Bezier,
        text!("Bezier"),
        text!("Goes by handles to the next key (a hollow circle)"),
    ),
    (TimeInterpolation::Smooth, text!("Smooth"), text!("Eases to the next key (a circle)")),
    (
        TimeInterpolation::Linear,
        text!("Straight"),
        text!("Goes evenly to the next key (a diamond)"),
    ),
    (TimeInterpolation::Stepped, text!("Stepped"), text!("Holds until the next key (a square)")),
];

/// Kinds of handles with their names and explanations; `None` for automatic ones.
const HANDLES: [(Option<HandlePair>, Text, Text); 3] = [
    (None, text!("Automatic"), text!("Smooth, and never beyond the keys")),
    (Some(HandlePair::Aligned), text!("Aligned"), text!("One handle turns with the other")),
    (Some(HandlePair::Free), text!("Free"), text!("Each handle is moved by itself")),
];

/// Values beyond the keys, with their names and explanations.
const BEYOND: [(Extrapolation, Text, Text); 5] = [
    (Extrapolation::Hold, text!("hold"), text!("The value of the key")),
    (Extrapolation::Linear, text!("go on straight"), text!("On with the slope of the curve")),
    (Extrapolation::Cycle, text!("cycle"), text!("All keys again")),
    (
        Extrapolation::CycleOffset,
        text!("cycle with offset"),
        text!("All keys again, from the value reached"),
    ),
    (Extrapolation::Mirror, text!("to and fro"), text!("All keys backward, then forward again")),
];

/// Shows the row.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    out: &mut Vec<Command>,
) {
    let picked = timeline.sheet.picked(session);
    ui.horizontal_wrapped(|ui| {
        if picked.is_empty() {
            let is_any = super::times(session).next().is_some();
            if is_any {
                // Here and not under the pointer, where it would cover tracks.
                hint(
                    ui,
                    tr!("Press a key, or drag a box around keys, to change them. A double click \
                         on a track adds one; a drag with Alt or the middle button pans."),
                );
            }
            return;
        }
        one_key(timeline, ui, session, &picked, out);
        interpolation(timeline, ui, session, &picked, out);
        ui.menu_button(tr!("Handles"), |ui| {
            for (pair, text, help) in HANDLES {
                if ui.button(text.tr()).on_hover_text(help.tr()).clicked() {
                    let change = |it: &PickedTrack| retime::with_handles(&it.track, &it.keys, pair);
                    timeline.sheet.change(session, change, out);
                }
            }
        });
        beyond(timeline, ui, session, &picked, out);
        length(timeline, ui, session, out);
        scale(timeline, ui, session, out);
        commands(timeline, ui, session, &picked, out);
    });
}

/// Shows time, frame and value of an only key, or how many are selected.
fn one_key(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    picked: &[PickedTrack],
    out: &mut Vec<Command>,
) {
    let [PickedTrack { owner, index, track, keys }] = picked else {
        let count: usize = picked.iter().map(|it| it.keys.len()).sum();
        let tracks = picked.len();
        let text =
            trn!(tracks, "{count} keys in {tracks} track", "{count} keys in {tracks} tracks");
        ui.label(RichText::new(text).color(theme::of(ui).accent));
        return;
    };
    let Some(owned) = OwnedKeys::of(session, *owner) else { return };
    let [name, what] = rows::owner_and_name(owned, track);
    let accent = theme::of(ui).accent;
    let &[key_at] = keys.as_slice() else {
        let count = keys.len();
        let text = trn!(count, "{count} key of {name}: {what}", "{count} keys of {name}: {what}");
        ui.label(RichText::new(text).color(accent));
        return;
    };
    ui.label(RichText::new(format!("{name}: {what}")).color(accent));
    let key = &track.keys[key_at];
    let mut time = key.time;
    // A shot counts frames alone.
    let of_time = session.shot().is_none().then(|| {
        let drag =
            number_field(ui, &mut time).speed(1.0 / timeline.fps).max_decimals(4).suffix(" s");
        let response = ui.add(drag);
        let name = tr!("Time of the key");
        response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
        response
    });
    let mut frame = key.time * timeline.fps;
    let drag = number_field(ui, &mut frame).speed(0.2).max_decimals(2).prefix("f ");
    let of_frame = ui.add(drag);
    of_frame.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Frame of the key")));
    let of_frame = (of_frame, frame / timeline.fps);
    for (response, time) in of_time.map(|of_time| (of_time, time)).into_iter().chain([of_frame]) {
        let held = timeline.sheet.held_while(session, &response);
        if response.changed() && time.is_finite() {
            let time = timeline.snapped(time);
            let widget = Some(response.id);
            timeline.sheet.retime(session, held, (1.0, &|_| time), widget, out);
        }
        response.on_hover_text(tr!("When"));
    }
    let Some(port) = owned.keys.base.port_at(&track.target) else { return };
    let space = session.look().color_space;
    if let Some((id, value)) = value::cell(ui, tr!("Value of the key"), &port, &key.value, space) {
        let edit = owned.keys.change_track(*index, |track| track.keys[key_at].value = value);
        out.extend(owned.held(id, edit));
    }
}

/// Shows the menu of interpolations.
fn interpolation(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    picked: &[PickedTrack],
    out: &mut Vec<Command>,
) {
    let menu = ui.menu_button(tr!("Interpolation"), |ui| {
        for (choice, text, help) in INTERPOLATIONS {
            let is_it = picked
                .iter()
                .all(|it| it.keys.iter().all(|&key| it.track.keys[key].interpolation == choice));
            if ui.add(Button::selectable(is_it, text.tr())).on_hover_text(help.tr()).clicked()
                && !is_it
            {
                let change = |it: &PickedTrack| retime::interpolated(&it.track, &it.keys, choice);
                timeline.sheet.change(session, change, out);
            }
        }
    });
    menu.response.on_hover_text(tr!("How values go from these keys to the next"));
}

/// Shows the menu of what holds before and after the keys of the tracks.
fn beyond(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    picked: &[PickedTrack],
    out: &mut Vec<Command>,
) {
    let menu = ui.menu_button(tr!("Beyond"), |ui| {
        for (side, is_before) in [(tr!("keys" => "Before"), true), (tr!("keys" => "After"), false)]
        {
            for (choice, text, help) in BEYOND {
                let of = |ends: TrackEnds| if is_before { ends.before } else { ends.after };
                let is_it = picked.iter().all(|it| of(it.track.ends()) == choice);
                let button = Button::selectable(is_it, format!("{side}: {}", text.tr()));
                if ui.add(button).on_hover_text(help.tr()).clicked() {
                    let change = |it: &PickedTrack| {
                        let mut ends = it.track.ends();
                        *(if is_before { &mut ends.before } else { &mut ends.after }) = choice;
                        retime::with_ends(&it.track, ends)
                    };
                    timeline.sheet.change(session, change, out);
                }
            }
            if is_before {
                ui.separator();
            }
        }
    });
    menu.response.on_hover_text(tr!("Values before the first key and after the last"));
}

/// Shows the length of several keys in frames.
fn length(timeline: &mut Timeline, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    let Some([start, end]) = timeline.sheet.range(session) else { return };
    if end - start < super::LEAST {
        return;
    }
    let fps = timeline.fps;
    let mut frames = (end - start) * fps;
    let drag = number_field(ui, &mut frames).speed(0.25).max_decimals(2).suffix(tr!(" frames"));
    let response = ui.add(drag.range(0.01..=1e7));
    response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Length of the keys")));
    let held = timeline.sheet.held_while(session, &response);
    if let Some([start, end]) = range_of(&held).filter(|_| response.changed()) {
        let scale = frames / fps / (end - start);
        timeline.scale(session, held, (start, scale), response.id, out);
    }
    response.on_hover_text(tr!("Stretches the keys to so many frames; the first stays"));
}

/// Shows the factor by which several keys are scaled about the playhead.
fn scale(timeline: &mut Timeline, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    if timeline.sheet.range(session).is_none_or(|[start, end]| end - start < super::LEAST) {
        return;
    }
    let playhead = session.view.time;
    let mut percent = 100.0;
    let drag = number_field(ui, &mut percent).speed(0.5).max_decimals(1).suffix(" %");
    let response = ui.add(drag.range(1.0..=10_000.0));
    response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Scale of the keys")));
    let held = timeline.sheet.held_while(session, &response);
    if response.changed() && !held.is_empty() {
        timeline.scale(session, held, (playhead, percent / 100.0), response.id, out);
    }
    response.on_hover_text(tr!("Scales the keys about the playhead"));
}

/// Times of the first and the last picked key.
pub(super) fn range_of(picked: &[PickedTrack]) -> Option<[f64; 2]> {
    let times = || picked.iter().flat_map(|it| it.keys.iter().map(|&key| it.track.keys[key].time));
    let low = times().min_by(f64::total_cmp)?;
    let high = times().max_by(f64::total_cmp)?;
    (high - low >= super::LEAST).then_some([low, high])
}

/// Shows the menu of what is done with the keys as they are.
fn commands(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    picked: &[PickedTrack],
    out: &mut Vec<Command>,
) {
    let now = timeline.snapped(session.view.time);
    ui.menu_button(tr!("Edit keys"), |ui| {
        if ui.button(tr!("Copy keys")).on_hover_text(tr!("Ctrl+C over this panel")).clicked() {
            timeline.sheet.copy(session);
        }
        let help = tr!(
            "Puts the copied keys at the playhead (Ctrl+V): into their tracks, or keys of one \
             track into that of the selected key"
        );
        let can_paste = timeline.sheet.has_copies();
        let paste = ui.add_enabled(can_paste, Button::new(tr!("Paste keys")));
        if paste.on_hover_text(help).clicked() {
            timeline.sheet.paste(session, now, out);
        }
        let help = tr!("Puts copies at the playhead (Ctrl+D)");
        let duplicate = ui.button(tr!("Duplicate keys")).on_hover_text(help);
        if duplicate.clicked() && timeline.sheet.copy(session) {
            timeline.sheet.active = None;
            timeline.sheet.paste(session, now, out);
        }
    });
    let count: usize = picked.iter().map(|it| it.keys.len()).sum();
    let text = trn!(count, "Delete time key", "Delete time keys");
    if ui.button(text).on_hover_text(tr!("Takes them away (Delete)")).clicked() {
        timeline.sheet.delete(session, out);
    }
}
