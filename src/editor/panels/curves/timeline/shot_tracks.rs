//! Tracks of the shot that are no light's and no node's: the camera, objects, masters of groups.
//! Their keys are overrides of the shot, in frames.

use chiaro_locale::tr;
use eframe::egui::{
    self, Key, Pos2, Rect, RichText, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use super::axis::Axis;
use super::key_bar::INTERPOLATIONS;
use super::rows::paint_key;
use super::{NAMES, ROW, Timeline};
use crate::commands::{Command, SceneCommand, ShotCommand};
use crate::document::{Override, ShotEdit, Target};
use crate::fields::{mark, scene_names};
use crate::frame::ValueChange;
use crate::state::session::Session;
use crate::state::session::shot::json_text;
use crate::state::shot::{ON_FRAME, OpenShot, ShotAddress, key_at};
use crate::widgets::handle::{self, handle};
use crate::widgets::menu::MenuSearch;
use crate::widgets::text::cell;
use crate::widgets::theme;

/// Fields of the camera that are offered to be keyed.
const CAMERA: [&str; 4] = ["camera.eye", "camera.target", "camera.fov", "camera.height"];
/// Fields of the selected object that are offered to be keyed.
const OBJECT: [&str; 3] = ["transform.translate", "transform.rotate", "transform.scale"];

/// A keyed value, with the override that has its keys.
struct ShotTrack<'s> {
    change: &'s ValueChange,
    keys: &'s Override,
    /// True for the open shot's own, which can be changed here.
    is_own: bool,
}

/// Tracks that no document has under the shot.
fn tracks(shot: &OpenShot) -> impl Iterator<Item = ShotTrack<'_>> {
    let is_here = |change: &&ValueChange| {
        let is_light = matches!(Target::parse(&change.target), Some(Target::Light { .. }));
        change.stands && change.is_keyed && change.look.is_none() && !is_light
    };
    shot.resolved().changes.iter().filter(is_here).filter_map(|change| {
        let file = shot.stack().shots.iter().find(|file| file.path == change.by);
        let is_own = change.by == shot.path();
        let keys = match is_own {
            true => shot.own(&ShotAddress::of(change))?,
            false => {
                let index = file?.shot.override_of(None, &change.target)?;
                file?.shot.overrides.get(index)?
            }
        };
        Some(ShotTrack { change, keys, is_own })
    })
}

/// Times of the keys, in seconds.
pub(super) fn times(session: &Session) -> Vec<f64> {
    let Some(shot) = session.shot() else { return Vec::new() };
    let rate = shot.rate();
    let keys = tracks(shot).flat_map(|track| &track.keys.keys);
    keys.map(|key| rate.time_within(key.frame)).collect()
}

/// Shows the entries that key the camera and the selected object, where no keys of it are there.
pub(super) fn menu(
    (ui, search): (&mut Ui, &mut MenuSearch),
    session: &Session,
    out: &mut Vec<Command>,
) {
    let Some((shot, scene)) = session.shot().zip(session.open_scene()) else { return };
    let of_object = scene
        .selected()
        .into_iter()
        .flat_map(|(id, _)| OBJECT.map(|field| format!("objects.{id}.{field}")));
    for target in CAMERA.map(str::to_owned).into_iter().chain(of_object) {
        let is_keyed = tracks(shot).any(|track| track.change.target == target);
        if is_keyed || scene.scene().value_at(&target).is_err() {
            continue;
        }
        let [owner, what] = scene_names::of(&target);
        if search.entry(ui, &format!("{owner}: {what}")) {
            push(out, ShotCommand::Key(ShotAddress { look: None, target }));
        }
    }
}

fn push(out: &mut Vec<Command>, command: ShotCommand) {
    out.push(Command::Scene(SceneCommand::Shot(command)));
}

/// Shows the tracks.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    axis: Axis,
    out: &mut Vec<Command>,
) {
    let Some(shot) = session.shot() else { return };
    for track in tracks(shot) {
        row(timeline, ui, (session, shot), axis, &track, out);
    }
}

fn row(
    timeline: &mut Timeline,
    ui: &mut Ui,
    (session, shot): (&Session, &OpenShot),
    axis: Axis,
    track: &ShotTrack<'_>,
    out: &mut Vec<Command>,
) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    if !ui.is_rect_visible(rect) {
        return;
    }
    let [owner, what] = scene_names::of(&track.change.target);
    let names = Rect::from_min_size(rect.min, vec2(NAMES - 8.0, ROW));
    let builder = egui::UiBuilder::new().id_salt(&track.change.target).max_rect(names);
    head(&mut ui.new_child(builder), (session, shot), track, [&owner, &what], out);
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), rect.y_range());
    let colors = theme::of(ui);
    let painter = ui.painter_at(lane);
    painter.rect_filled(lane, 3.0, colors.canvas);
    let rate = shot.rate();
    let x = |frame: f64| axis.x(rate.time_within(frame));
    let ink = if track.is_own { colors.second } else { colors.dim };
    if let [first, .., last] = track.keys.keys.as_slice() {
        let middle = lane.center().y;
        painter.hline(x(first.frame)..=x(last.frame), middle, Stroke::new(1.5, ink));
    }
    for (index, key) in track.keys.keys.iter().enumerate() {
        let at = pos2(x(key.frame), lane.center().y);
        if !lane.expand(6.0).contains(at) {
            continue;
        }
        key_handle(timeline, ui, shot, (track, index), (axis, at), [&owner, &what], out);
    }
}

/// Shows the diamond that keys the value at the playhead, the value's name, and its present value.
fn head(
    ui: &mut Ui,
    (session, shot): (&Session, &OpenShot),
    track: &ShotTrack<'_>,
    [owner, what]: [&str; 2],
    out: &mut Vec<Command>,
) {
    let colors = theme::of(ui);
    let frame = shot.rate().frame_within(session.view.time);
    let here = key_at(&track.keys.keys, frame);
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.allocate_exact_size(vec2(12.0, ui.spacing().interact_size.y), Sense::hover());
        let size = vec2(16.0, ui.spacing().interact_size.y);
        let sense = if track.is_own { Sense::click() } else { Sense::hover() };
        let (rect, response) = ui.allocate_exact_size(size, sense);
        let name = match here {
            Some(_) => tr!("Delete key of {owner}: {what}"),
            None => tr!("Add key of {owner}: {what}"),
        };
        response.widget_info(|| WidgetInfo::labeled(Role::Button, track.is_own, &name));
        let edge = if response.hovered() { colors.text } else { colors.accent };
        let fill = if here.is_some() { colors.accent } else { egui::Color32::TRANSPARENT };
        mark::diamond(ui, rect.center(), 4.5, fill, edge);
        if response.clicked() {
            match here {
                Some(index) => push(out, ShotCommand::Edit(without(track.keys, index))),
                None => push(out, ShotCommand::Key(ShotAddress::of(track.change))),
            }
        }
        let by = track.change.by.file_name().unwrap_or_default().to_string_lossy();
        response.on_hover_text(match (track.is_own, here) {
            (false, _) => tr!("Keyed by {by}, which lies under the shot"),
            (true, Some(_)) => tr!("Deletes the key at the playhead").to_owned(),
            (true, None) => tr!("Adds a key at the playhead").to_owned(),
        });
        let place = session.open_scene().map(|scene| scene.scene().value_at(&track.change.target));
        let now = place.and_then(Result::ok).map(|place| json_text(&place.value));
        let rect = ui.available_rect_before_wrap();
        let value_width = 70.0;
        let left = Rect::from_min_max(rect.min, pos2(rect.right() - value_width, rect.bottom()));
        let middle = left.top() + 0.46 * left.height();
        let font = egui::TextStyle::Body.resolve(ui.style());
        let small = egui::FontId::proportional(theme::SMALL_TEXT);
        let above = Rect::from_x_y_ranges(left.x_range(), left.top()..=middle);
        let below = Rect::from_x_y_ranges(left.x_range(), middle..=left.bottom());
        cell(ui, above, owner, small.clone(), colors.dim);
        cell(ui, below, what, font, colors.text);
        let right =
            Rect::from_min_max(pos2(rect.right() - value_width + 4.0, rect.top()), rect.max);
        cell(ui, right, &now.unwrap_or_default(), small, colors.dim);
    });
}

/// Shows a key: dragged, it stays between its neighbors.
fn key_handle(
    timeline: &mut Timeline,
    ui: &Ui,
    shot: &OpenShot,
    (track, index): (&ShotTrack<'_>, usize),
    (axis, at): (Axis, Pos2),
    [owner, what]: [&str; 2],
    out: &mut Vec<Command>,
) {
    let key = &track.keys.keys[index];
    let label = tr!("Frame key {key} of {owner}: {what}", key = index + 1);
    let id = ui.scope_id().with(("shot key", &track.change.target, index));
    let handled = handle(ui, id, at, &label, key.frame, track.is_own);
    let wished = handled.to.map(|to| shot.rate().frame_within(axis.time(to.x)));
    let step = f64::from(handled.steps.x);
    let wished = wished.or((step != 0.0).then_some(key.frame + step));
    if let Some(frame) = wished {
        let frame = if timeline.snaps { frame.round() } else { frame };
        let edit = moved(track.keys, index, frame);
        out.extend(
            edit.map(|edit| Command::Scene(SceneCommand::Shot(ShotCommand::EditHeld(id, edit)))),
        );
    }
    if track.is_own && handle::pressed(ui, &handled.response, Key::Delete) {
        push(out, ShotCommand::Edit(without(track.keys, index)));
    }
    let is_hot = handled.response.hovered();
    paint_key(ui, at, key.interpolation, handled.response.has_focus(), is_hot);
    handle::focus_ring(ui, &handled.response, at, 7.0);
    if handled.response.double_clicked() {
        timeline.went = Some(shot.rate().time_within(key.frame));
    }
    if track.is_own {
        handled.response.context_menu(|ui| key_menu(ui, track, index, out));
    }
    let text = tr!(
        "Frame {frame}: {value}. Drag it, or arrow keys; a right click shapes it; double-click \
         brings the playhead here; Delete removes it.",
        frame = key.frame,
        value = json_text(&serde_json::json!(key.value))
    );
    handled.response.on_hover_text(text);
}

fn key_menu(ui: &mut Ui, track: &ShotTrack<'_>, index: usize, out: &mut Vec<Command>) {
    let now = track.keys.keys[index].interpolation;
    for (interpolation, text, help) in INTERPOLATIONS {
        if ui.radio(now == interpolation, text.tr()).on_hover_text(help.tr()).clicked() {
            let mut change = track.keys.clone();
            change.keys[index].interpolation = interpolation;
            push(out, ShotCommand::Edit(ShotEdit::set_override(change)));
            ui.close();
        }
    }
    ui.separator();
    if ui.button(RichText::new(tr!("Delete key"))).clicked() {
        push(out, ShotCommand::Edit(without(track.keys, index)));
        ui.close();
    }
}

/// The edit that moves a key to a frame between its neighbors; `None` where there is no room.
fn moved(track: &Override, index: usize, frame: f64) -> Option<ShotEdit> {
    let least = index.checked_sub(1).and_then(|before| track.keys.get(before));
    let most = track.keys.get(index + 1);
    let is_free = least.is_none_or(|key| frame > key.frame + ON_FRAME)
        && most.is_none_or(|key| frame < key.frame - ON_FRAME);
    let mut change = track.clone();
    let key = change.keys.get_mut(index).filter(|key| is_free && key.frame != frame)?;
    key.frame = frame;
    Some(ShotEdit::set_override(change))
}

/// The edit that takes a key away; with the last one the whole change.
fn without(track: &Override, index: usize) -> ShotEdit {
    let mut change = track.clone();
    if change.keys.len() < 2 {
        return ShotEdit::take_back(change.look, change.target);
    }
    change.keys.remove(index.min(change.keys.len() - 1));
    ShotEdit::set_override(change)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Shot;

    fn track() -> Override {
        let text = r#"{"chiaro": "shot", "version": 1, "scene": "a.json", "overrides": [
            {"target": "camera.fov", "keys": [
                {"frame": 1, "value": 30}, {"frame": 12, "value": 40}]}]}"#;
        let shot = Shot::read(text, "shot.json").value.unwrap();
        shot.overrides.into_iter().next().unwrap()
    }

    #[test]
    fn keys_move_between_their_neighbors_and_go() {
        let track = track();
        let frames = |edit: &ShotEdit| match edit {
            ShotEdit::SetOverride { change: Some(change), .. } => {
                change.keys.iter().map(|key| key.frame).collect::<Vec<f64>>()
            }
            _ => Vec::new(),
        };
        assert_eq!(frames(&moved(&track, 0, 5.0).unwrap()), [5.0, 12.0]);
        assert!(moved(&track, 0, 12.0).is_none(), "another key is there");
        assert!(moved(&track, 1, 12.0).is_none(), "it is there");
        let one = without(&track, 0);
        assert_eq!(frames(&one), [12.0]);
        let ShotEdit::SetOverride { change: Some(change), .. } = one else { panic!() };
        assert!(matches!(without(&change, 0), ShotEdit::SetOverride { change: None, .. }));
    }
}
