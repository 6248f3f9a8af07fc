//! Markers: times with names, on a strip below the ruler. Those of the document that is edited are
//! moved and named here; while a shot is open, those of what lies under it are shown beside them.

use std::path::Path;

use chiaro_locale::tr;
use eframe::egui::{
    Align2, Color32, FontId, Id, Key, Pos2, Rect, Response, Role, Sense, Shape, Stroke, TextEdit,
    Ui, UiBuilder, Vec2, WidgetInfo, pos2, vec2,
};

use super::axis::Axis;
use super::{NAMES, Timeline};
use crate::commands::{Command, SceneCommand, ShotCommand};
use crate::document::{Edit, Marker, SceneEdit, ShotEdit, ShotMarker, UnknownFields};
use crate::state::keying::retime::tidy;
use crate::state::session::Session;
use crate::values;
use crate::widgets::handle::{focus_ring, handle, pressed};
use crate::widgets::rows::leaves_with_text;
use crate::widgets::theme;

/// Height of the strip, in points.
pub(super) const STRIP: f32 = 20.0;
/// Side of the square that catches the pointer over a marker that is only read, in points.
const REACH: f32 = 16.0;

/// Document that markers are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum MarkerOwner {
    Look,
    Scene,
    /// A shot, by its place among the shots over the scene: 0 is the open one.
    Shot(usize),
}

/// Marker whose name is typed, and the name so far.
pub(super) type NameField = Option<(MarkerOwner, usize, String)>;

impl MarkerOwner {
    /// Documents that have markers, the one that is edited last: it is drawn over the others.
    fn all(session: &Session) -> impl Iterator<Item = Self> {
        let shots = session.shot().map_or(0, |shot| shot.stack().shots.len());
        [Self::Look, Self::Scene].into_iter().chain((0..shots).rev().map(Self::Shot))
    }

    /// Document that gets new markers: the shot, the scene, or the look, whichever is outermost.
    fn outermost(session: &Session) -> Self {
        match session.open_scene() {
            Some(_) if session.shot().is_some() => Self::Shot(0),
            Some(_) => Self::Scene,
            None => Self::Look,
        }
    }

    /// True if the markers are changed here: under a shot, files stay as they are.
    fn is_edited(self, session: &Session) -> bool {
        session.shot().is_none() || self == Self::Shot(0)
    }

    /// Markers of the document; those of a shot at the times of their frames.
    fn markers(self, session: &Session) -> Vec<Marker> {
        let at = |rate: crate::document::FrameRate, marker: &ShotMarker| Marker {
            time: rate.time(marker.frame),
            name: marker.name.clone(),
            unknown: marker.unknown.clone(),
        };
        match self {
            Self::Look => session.look().markers.clone(),
            Self::Scene => {
                session.open_scene().map(|it| it.scene().markers.clone()).unwrap_or_default()
            }
            Self::Shot(number) => {
                let of = |shot: &crate::state::shot::OpenShot| {
                    let markers = match number {
                        0 => &shot.shot().markers,
                        _ => &shot.stack().shots.get(number)?.shot.markers,
                    };
                    Some(markers.iter().map(|marker| at(shot.rate(), marker)).collect())
                };
                session.shot().and_then(of).unwrap_or_default()
            }
        }
    }

    /// The document in words, for what is shown of it over another.
    fn described(self, session: &Session) -> String {
        let file = |path: Option<&Path>| {
            let name = path.and_then(Path::file_name);
            name.map_or_else(String::new, |name| format!(" {}", name.to_string_lossy()))
        };
        let shots = session.shot().map(|shot| &shot.stack().shots);
        match self {
            Self::Look => tr!("marker of" => "the look{file}", file = file(session.path())),
            Self::Scene => {
                let file = file(session.open_scene().and_then(|it| it.path()));
                tr!("marker of" => "the scene{file}")
            }
            Self::Shot(number) => {
                let under = shots.and_then(|shots| shots.get(number));
                let file = file(under.map(|under| under.path.as_path()));
                tr!("marker of" => "the shot{file}")
            }
        }
    }

    /// Command that sets the markers: as one step for as long as a widget is held, where one is
    /// given.
    fn set(self, session: &Session, markers: Vec<Marker>, widget: Option<Id>) -> Command {
        let of_scene = |edit| match widget {
            Some(widget) => SceneCommand::EditHeld(widget, edit),
            None => SceneCommand::Edit(edit),
        };
        match self {
            Self::Look => {
                let edit = Edit::SetMarkers { markers };
                match widget {
                    Some(widget) => Command::EditHeld(widget, edit),
                    None => Command::Edit(edit),
                }
            }
            Self::Scene => Command::Scene(of_scene(SceneEdit::SetMarkers { markers })),
            Self::Shot(_) => {
                let fps = session.shot().map_or(24.0, |shot| shot.rate().per_second());
                let markers = markers.into_iter().map(|marker| ShotMarker {
                    frame: (marker.time * fps).round() as i32,
                    name: marker.name,
                    unknown: marker.unknown,
                });
                let edit = ShotEdit::SetShotMarkers { markers: markers.collect() };
                let command = match widget {
                    Some(widget) => ShotCommand::EditHeld(widget, edit),
                    None => ShotCommand::Edit(edit),
                };
                Command::Scene(SceneCommand::Shot(command))
            }
        }
    }

    /// Command that sets the markers in order of time, as one step.
    fn set_in_order(self, session: &Session, mut markers: Vec<Marker>) -> Command {
        markers.sort_by(|a, b| a.time.total_cmp(&b.time));
        self.set(session, markers, None)
    }

    /// A time that a marker of the document can have: shots name frames.
    fn nearest_time(self, session: &Session, time: f64) -> f64 {
        match (self, session.shot()) {
            (Self::Shot(_), Some(shot)) => {
                shot.rate().time((time * shot.rate().per_second()).round() as i32)
            }
            _ => time,
        }
    }
}

/// Times of all markers, in seconds.
pub(super) fn times(session: &Session) -> impl Iterator<Item = f64> {
    let all = MarkerOwner::all(session).flat_map(|owner| owner.markers(session));
    all.map(|marker| marker.time)
}

/// Adds a marker: to the shot or to the scene, where there is one.
pub(super) fn add(session: &Session, time: f64, out: &mut Vec<Command>) {
    let owner = MarkerOwner::outermost(session);
    let mut markers = owner.markers(session);
    let time = tidy(time);
    // The name of the one that is there is changed by a double click.
    if markers.iter().any(|marker| (marker.time - time).abs() < 1e-6) {
        return;
    }
    let is_free = |number: &usize| {
        let name = format!("Marker {number}");
        markers.iter().all(|marker| marker.name != name)
    };
    let number = (1..).find(is_free).unwrap_or(1);
    let name = format!("Marker {number}");
    markers.push(Marker { time, name, unknown: UnknownFields::new() });
    out.push(owner.set_in_order(session, markers));
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
        let help = match MarkerOwner::outermost(session) {
            MarkerOwner::Shot(_) => tr!("Names the frame at the playhead in the shot (M here)"),
            _ => tr!("Names the time at the playhead (M over this panel)"),
        };
        if ui.small_button(tr!("Add marker")).on_hover_text(help).clicked() {
            add(session, timeline.snapped(session.view.time), out);
        }
    });
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), strip.y_range());
    ui.painter().rect_filled(lane, 3.0, theme::of(ui).well);
    for owner in MarkerOwner::all(session) {
        let markers = owner.markers(session);
        for index in 0..markers.len() {
            let at = pos2(axis.x(markers[index].time), lane.center().y);
            if !lane.x_range().expand(4.0).contains(at.x) {
                continue;
            }
            let shown = ShownMarker { session, owner, markers: &markers, index, at, lane };
            if owner.is_edited(session) {
                shown.edit(timeline, ui, axis, out);
            } else {
                shown.read(timeline, ui, out);
            }
        }
    }
}

/// A marker at its place on the screen.
struct ShownMarker<'s> {
    session: &'s Session,
    owner: MarkerOwner,
    /// All markers of its document.
    markers: &'s [Marker],
    index: usize,
    at: Pos2,
    lane: Rect,
}

impl ShownMarker<'_> {
    fn marker(&self) -> &Marker {
        &self.markers[self.index]
    }

    fn id(&self, ui: &Ui) -> Id {
        ui.scope_id().with(("marker", self.owner, self.index))
    }

    /// The markers of the document with a change of this one.
    fn changed(&self, change: impl FnOnce(&mut Marker)) -> Vec<Marker> {
        let mut markers = self.markers.to_vec();
        change(&mut markers[self.index]);
        markers
    }

    /// Time and frame in words.
    fn place(&self, timeline: &Timeline) -> String {
        let Marker { time, name, .. } = self.marker();
        let frame = (time * timeline.fps).round();
        tr!("{name}: {seconds} s, frame {frame}", seconds = values::number_text(*time, 3))
    }

    fn paint_flag(&self, ui: &Ui, response: &Response, color: Color32) {
        let is_hot = response.hovered() || response.dragged();
        let color = if is_hot { theme::of(ui).accent } else { color };
        let painter = ui.painter_at(self.lane.expand2(vec2(6.0, 0.0)));
        let flag =
            [vec2(-4.5, -7.0), vec2(4.5, -7.0), vec2(4.5, 1.0), vec2(0.0, 7.0), vec2(-4.5, 1.0)];
        let flag = flag.map(|d| self.at + d).to_vec();
        painter.add(Shape::convex_polygon(flag, color, Stroke::NONE));
        focus_ring(ui, response, self.at, 7.0);
    }

    fn paint_name(&self, ui: &Ui, color: Color32) {
        let painter = ui.painter_at(self.lane.expand2(vec2(6.0, 0.0)));
        let font = FontId::proportional(theme::SMALL_TEXT);
        let middle = pos2(self.at.x + 8.0, self.lane.center().y);
        painter.text(middle, Align2::LEFT_CENTER, &self.marker().name, font, color);
    }

    /// Shows a marker of what lies under the shot: a press goes there.
    fn read(&self, timeline: &mut Timeline, ui: &Ui, out: &mut Vec<Command>) {
        let place = Rect::from_center_size(self.at, Vec2::splat(REACH));
        let response = ui.interact(place, self.id(ui), Sense::click());
        let of = self.owner.described(self.session);
        let label = tr!("Marker {name} of {of}", name = self.marker().name);
        response.widget_info(|| WidgetInfo::labeled(Role::Link, true, &label));
        if response.clicked() {
            timeline.go(self.marker().time, out);
        }
        let color = theme::of(ui).dim.gamma_multiply(0.6);
        self.paint_flag(ui, &response, color);
        self.paint_name(ui, color);
        let place = self.place(timeline);
        response.on_hover_text(tr!(
            "{place}, of {of}, which the shot leaves as it is. Press to go there; open that file \
             to change it."
        ));
    }

    /// Shows a marker of the document that is edited.
    fn edit(&self, timeline: &mut Timeline, ui: &mut Ui, axis: Axis, out: &mut Vec<Command>) {
        let (session, owner, index) = (self.session, self.owner, self.index);
        let marker = self.marker();
        let id = self.id(ui);
        let label = tr!("Marker {name}", name = marker.name);
        let handled = handle(ui, id, self.at, &label, marker.time, true);
        let response = handled.response;
        response.widget_info(|| WidgetInfo::slider(true, marker.time, &label));
        let steps = f64::from(handled.steps.x) / timeline.fps;
        let wished =
            handled.to.map(|to| axis.time(to.x)).or((steps != 0.0).then_some(marker.time + steps));
        let wished = wished.map(|time| owner.nearest_time(session, timeline.snapped(time)));
        if let Some(time) = wished.filter(|time| *time != marker.time) {
            // In order of time only once the drag is over, so that the handle stays the same one.
            let markers = self.changed(|marker| marker.time = time);
            out.push(owner.set(session, markers, Some(id)));
        }
        if response.clicked() {
            timeline.go(marker.time, out);
        }
        if response.double_clicked() {
            timeline.renaming = Some((owner, index, marker.name.clone()));
        }
        let mut is_deleted = pressed(ui, &response, Key::Delete);
        response.context_menu(|ui| {
            if ui.button(tr!("Rename marker")).clicked() {
                timeline.renaming = Some((owner, index, marker.name.clone()));
            }
            is_deleted |= ui.button(tr!("Delete marker")).clicked();
        });
        if is_deleted {
            let mut markers = self.markers.to_vec();
            markers.remove(index);
            out.push(owner.set_in_order(session, markers));
        }
        self.paint_flag(ui, &response, theme::of(ui).third);
        match &timeline.renaming {
            Some((named, at, _)) if (*named, *at) == (owner, index) => {
                self.rename(timeline, ui, out);
            }
            _ => self.paint_name(ui, theme::of(ui).text),
        }
        let place = self.place(timeline);
        response.on_hover_text(tr!(
            "{place}. Press to go there, drag to move it, double-click to name it, Delete removes \
             it."
        ));
    }

    /// Shows the field in which the name is typed.
    fn rename(&self, timeline: &mut Timeline, ui: &mut Ui, out: &mut Vec<Command>) {
        let Some((_, _, name)) = &mut timeline.renaming else { return };
        let left = pos2(self.at.x + 8.0, self.lane.top());
        let field = Rect::from_min_size(left, vec2(120.0, STRIP));
        let edit = TextEdit::singleline(name).id(self.id(ui).with("name")).desired_width(110.0);
        let typed = ui.put(field, edit);
        typed.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, tr!("Name of the marker")));
        let (name, is_over) = (name.clone(), typed.lost_focus());
        if !typed.has_focus() && !is_over {
            typed.request_focus();
        }
        if is_over {
            timeline.renaming = None;
            if leaves_with_text(ui) && name != self.marker().name {
                let markers = self.changed(|marker| marker.name.clone_from(&name));
                out.push(self.owner.set_in_order(self.session, markers));
            }
        }
    }
}
