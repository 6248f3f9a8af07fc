//! Markers: times with names, on a strip below the ruler.

use eframe::egui::{
    Align2, FontId, Key, Rect, Sense, Shape, Stroke, TextEdit, Ui, UiBuilder, WidgetInfo, pos2,
    vec2,
};

use super::axis::Axis;
use super::{NAMES, Timeline};
use crate::commands::Command;
use crate::document::{Edit, Marker, SceneEdit, UnknownFields};
use crate::fields::lighting::{Change, Owner};
use crate::state::keying::retime::tidy;
use crate::state::session::Session;
use crate::values;
use crate::widgets::handle::{focus_ring, handle, pressed};
use crate::widgets::theme;

/// Height of the strip, in points.
pub(super) const STRIP: f32 = 20.0;

/// Marker whose name is typed, and the name so far.
pub(super) type NameField = Option<(Owner, usize, String)>;

/// Markers of a document.
fn of(session: &Session, owner: Owner) -> &[Marker] {
    let of_scene = || Some(session.open_scene()?.scene().markers.as_slice());
    match owner {
        Owner::Look => &session.look().markers,
        Owner::Scene => of_scene().unwrap_or_default(),
    }
}

/// Times of all markers, in seconds.
pub(super) fn times(session: &Session) -> impl Iterator<Item = f64> {
    let all = [Owner::Look, Owner::Scene].into_iter().flat_map(|owner| of(session, owner));
    all.map(|marker| marker.time)
}

/// The edit that sets the markers of a document, in order of time.
fn set(owner: Owner, mut markers: Vec<Marker>) -> Change {
    markers.sort_by(|a, b| a.time.total_cmp(&b.time));
    match owner {
        Owner::Look => Change::Look(Edit::SetMarkers { markers }),
        Owner::Scene => Change::Scene(SceneEdit::SetMarkers { markers }),
    }
}

/// Adds a marker: to the scene, where there is one.
pub(super) fn add(session: &Session, time: f64, out: &mut Vec<Command>) {
    let owner = if session.open_scene().is_some() { Owner::Scene } else { Owner::Look };
    let mut markers = of(session, owner).to_vec();
    let is_free = |number: &usize| {
        let name = format!("Marker {number}");
        markers.iter().all(|marker| marker.name != name)
    };
    let number = (1..).find(is_free).unwrap_or(1);
    let name = format!("Marker {number}");
    markers.push(Marker { time: tidy(time), name, unknown: UnknownFields::new() });
    out.push(set(owner, markers).once());
}

/// Shows the strip.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    axis: Axis,
    out: &mut Vec<Command>,
) {
    let (strip, _) = ui.allocate_exact_size(vec2(ui.available_width(), STRIP), Sense::hover());
    let names = Rect::from_min_size(strip.min, vec2(NAMES - 8.0, STRIP));
    let mut head = ui.new_child(UiBuilder::new().id_salt("markers").max_rect(names));
    head.horizontal_centered(|ui| {
        ui.spacing_mut().button_padding.y = 0.0;
        let help = "Names the time at the playhead (M over this panel)";
        if ui.small_button("Add marker").on_hover_text(help).clicked() {
            add(session, timeline.snapped(session.view.time), out);
        }
    });
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), strip.y_range());
    ui.painter().rect_filled(lane, 3.0, theme::of(ui).well);
    for owner in [Owner::Look, Owner::Scene] {
        for index in 0..of(session, owner).len() {
            marker(timeline, ui, session, (owner, index), (axis, lane), out);
        }
    }
}

fn marker(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    (owner, index): (Owner, usize),
    (axis, lane): (Axis, Rect),
    out: &mut Vec<Command>,
) {
    let markers = of(session, owner);
    let marker = &markers[index];
    let at = pos2(axis.x(marker.time), lane.center().y);
    if !lane.x_range().expand(4.0).contains(at.x) {
        return;
    }
    let id = ui.scope_id().with(("marker", owner, index));
    let label = format!("Marker {}", marker.name);
    let handled = handle(ui, id, at, &label, marker.time, true);
    let response = handled.response;
    response.widget_info(|| WidgetInfo::slider(true, marker.time, &label));
    let changed = |change: &dyn Fn(&mut Marker)| {
        let mut markers = markers.to_vec();
        change(&mut markers[index]);
        markers
    };
    let steps = f64::from(handled.steps.x) / timeline.fps;
    let wished =
        handled.to.map(|to| axis.time(to.x)).or((steps != 0.0).then_some(marker.time + steps));
    if let Some(time) =
        wished.map(|time| timeline.snapped(time)).filter(|time| *time != marker.time)
    {
        // In order of time only once the drag is over, so that the handle stays the same one.
        let markers = changed(&|marker| marker.time = time);
        let change = match owner {
            Owner::Look => Change::Look(Edit::SetMarkers { markers }),
            Owner::Scene => Change::Scene(SceneEdit::SetMarkers { markers }),
        };
        out.push(change.held(id));
    }
    if response.clicked() {
        timeline.go(marker.time, out);
    }
    if response.double_clicked() {
        timeline.renaming = Some((owner, index, marker.name.clone()));
    }
    let mut is_deleted = pressed(ui, &response, Key::Delete);
    response.context_menu(|ui| {
        if ui.button("Rename marker").clicked() {
            timeline.renaming = Some((owner, index, marker.name.clone()));
        }
        is_deleted |= ui.button("Delete marker").clicked();
    });
    if is_deleted {
        let mut markers = markers.to_vec();
        markers.remove(index);
        out.push(set(owner, markers).once());
    }
    let colors = theme::of(ui);
    let is_hot = response.hovered() || response.dragged();
    let color = if is_hot { colors.accent } else { colors.third };
    let painter = ui.painter_at(lane.expand2(vec2(6.0, 0.0)));
    let flag = [vec2(-4.5, -7.0), vec2(4.5, -7.0), vec2(4.5, 1.0), vec2(0.0, 7.0), vec2(-4.5, 1.0)];
    let flag = flag.map(|d| at + d).to_vec();
    painter.add(Shape::convex_polygon(flag, color, Stroke::NONE));
    focus_ring(ui, &response, at, 7.0);
    let left = pos2(at.x + 8.0, lane.top());
    match &mut timeline.renaming {
        Some((named, at, name)) if (*named, *at) == (owner, index) => {
            let field = Rect::from_min_size(left, vec2(120.0, STRIP));
            let edit = TextEdit::singleline(name).id(id.with("name")).desired_width(110.0);
            let typed = ui.put(field, edit);
            typed.widget_info(|| {
                WidgetInfo::labeled(eframe::egui::Role::TextInput, true, "Name of the marker")
            });
            let (name, is_over) = (name.clone(), typed.lost_focus());
            if !typed.has_focus() && !is_over {
                typed.request_focus();
            }
            if is_over {
                timeline.renaming = None;
                let is_given_up = ui.input(|input| input.key_pressed(Key::Escape));
                if !is_given_up && name != marker.name {
                    out.push(set(owner, changed(&|marker| marker.name.clone_from(&name))).once());
                }
            }
        }
        _ => {
            let font = FontId::proportional(theme::SMALL_TEXT);
            let middle = pos2(left.x, lane.center().y);
            painter.text(middle, Align2::LEFT_CENTER, &marker.name, font, colors.text);
        }
    }
    let frame = (marker.time * timeline.fps).round();
    response.on_hover_text(format!(
        "{}: {} s, frame {frame}. Press to go there, drag to move it, double-click to name it, \
         Delete removes it.",
        marker.name,
        values::number_text(marker.time, 3)
    ));
}
