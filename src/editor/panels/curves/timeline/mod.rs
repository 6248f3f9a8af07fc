//! Timeline: values over time, one row for each keyed value, played in real time.
//!
//! The playhead belongs to the window, not to the look: playing does not change the document.
//! Frames are requested no more often than at the chosen frame rate, and not at all at rest. The
//! clock says which frame is due; `tools::playback` draws and keeps frames.

mod axis;
mod bar;
mod clock;
mod differences;
mod edges;
mod file_tracks;
mod graph;
mod key_bar;
mod markers;
mod range;
mod rows;
mod sheet;
mod shot_tracks;
mod transport;

use std::path::PathBuf;
use std::time::Duration;

use chiaro_locale::{text, tr};
use eframe::egui;
use eframe::egui::{Rect, ScrollArea, Sense, Stroke, Ui, Vec2, pos2, vec2};

use crate::commands::{Command, PanelId, TimelineCommand};
use crate::document::TimeRange;
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::panels::table::{PanelPlace, PanelRow, Presence};
use crate::state::keying::retime::tidy;
use crate::state::session::Session;
use crate::tools::PictureTools;
use crate::tools::playback::Playback;
use crate::tools::playback::order::Round;
use crate::widgets::text::hint;
use crate::widgets::theme;
use axis::Axis;
use clock::PlayClock;
use file_tracks::FileTracks;
use markers::NameField;
use sheet::KeySheet;

pub(crate) const PANEL: PanelRow = PanelRow::new(
    PanelId::TIMELINE,
    text!("Timeline"),
    text!("Values that change with time: keys, play, scrub"),
    PanelPlace::BELOW_GRAPH,
    |bench, ui, context| bench.memory.of::<Timeline>().show(ui, context.session, &mut bench.tools),
)
.with_each_frame(|bench, ui, session, presence| {
    let timeline = bench.memory.of::<Timeline>();
    let mut commands: Vec<Command> = timeline.follow(session).into_iter().collect();
    if presence == Presence::Absent {
        timeline.clock.stop();
        timeline.files = FileTracks::default();
        bench.tools.playback().follow(None);
        return commands;
    }
    let ticked = timeline.tick(ui, session, bench.tools.playback());
    commands.extend(ticked.map(Command::SetTime));
    transport::answer(timeline, ui, session, &mut bench.tools, &mut commands);
    // Before the graph, whose keys are some of the same.
    if let Some(panel) = timeline.panel.filter(|_| presence == Presence::Seen) {
        timeline.sheet.follow(session);
        sheet::keys(timeline, ui, session, panel, &mut commands);
        transport::keys(timeline, ui, session, panel, &mut commands);
    }
    commands
});

/// Width of the names of values, in points.
const NAMES: f32 = 190.0;
/// Height of the ruler, in points.
const RULER: f32 = 24.0;
/// Size of what catches the pointer at the head of the playhead, in points.
const HEAD: Vec2 = vec2(14.0, 16.0);
/// Height of a row, in points.
const ROW: f32 = 32.0;
/// Smallest difference between two times, in seconds.
const LEAST: f64 = 1e-3;

/// The panel, its clock, and its visible range.
pub(crate) struct Timeline {
    clock: PlayClock,
    /// Place where a press with Shift began, whose drag chooses a part of the range, in points.
    part_from: Option<f32>,
    fps: f64,
    snaps: bool,
    /// File of the open shot, with its frames and its rate as last seen.
    of_shot: Option<(PathBuf, TimeRange)>,
    /// Range that is played, in seconds.
    range: [f64; 2],
    /// Range that is visible, in seconds.
    seen: [f64; 2],
    /// Selected keys, and the tracks as they are shown.
    sheet: KeySheet,
    /// Motion that meshes' files bring.
    files: FileTracks,
    /// Place of the panel, and the height of the row of selected keys, in points, as last shown.
    panel: Option<Rect>,
    bar_height: f32,
    /// Height of opened tracks, in points: as much as there is place.
    curve_height: f32,
    /// Seconds by which arrow keys move the selected keys in this frame.
    steps: Option<f64>,
    /// True if the selected keys are deleted in this frame.
    is_deleting: bool,
    /// Time of a key that the playhead is brought to in this frame.
    went: Option<f64>,
    /// Marker whose name is typed.
    renaming: NameField,
    /// Search among the values that can be keyed.
    search: String,
    /// Command that was asked for by its name.
    asked: Option<TimelineCommand>,
}

impl Default for Timeline {
    fn default() -> Self {
        Self {
            clock: PlayClock::default(),
            part_from: None,
            fps: TimeRange::default().fps,
            snaps: true,
            of_shot: None,
            range: [0.0, 4.0],
            seen: [-0.2, 4.4],
            sheet: KeySheet::default(),
            files: FileTracks::default(),
            panel: None,
            bar_height: 0.0,
            curve_height: *graph::HEIGHTS.start(),
            steps: None,
            is_deleting: false,
            went: None,
            renaming: None,
            search: String::new(),
            asked: None,
        }
    }
}

impl Timeline {
    /// Time that the playhead moves on to while playing; requests the next frame for when it is
    /// due.
    fn tick(&mut self, ui: &Ui, session: &Session, playback: &mut Playback) -> Option<f64> {
        let (round, present) = (self.round(), session.view.time);
        let is_ready = |frame| playback.is_ready(frame);
        let now = ui.input(|input| input.time);
        let tick = self.clock.tick(round, (self.fps, present), now, is_ready);
        if tick.ends_round {
            playback.fill(true);
        }
        if let Some(wait) = tick.wait {
            ui.ctx().request_repaint_after(Duration::from_secs_f64(wait));
        }
        let transport = self.clock.transport(round, self.fps, tick.time.unwrap_or(present));
        playback.follow(Some(transport));
        tick.time
    }

    /// Does what is asked for by its name, in the next frame of the window.
    pub(crate) fn ask(&mut self, command: TimelineCommand) {
        self.asked = Some(command);
    }

    /// Frames that are played.
    fn round(&self) -> Round {
        self.clock.round(self.range, self.fps)
    }

    /// Time as chosen by hand: the nearest frame where times snap to frames.
    fn snapped(&self, time: f64) -> f64 {
        if self.snaps { tidy((time * self.fps).round() / self.fps) } else { tidy(time) }
    }

    fn toggle(&mut self, ui: &Ui, session: &Session) {
        let frame = (session.view.time * self.fps).round() as i32;
        self.clock.toggle(self.round(), frame, ui.input(|input| input.time));
        ui.ctx().request_repaint();
    }

    /// Moves the playhead to another time, also while playing.
    fn go(&mut self, time: f64, out: &mut Vec<Command>) {
        self.clock.go(self.round(), (time * self.fps).round() as i32);
        out.push(Command::SetTime(time));
    }

    /// Shows the values that are keyed over time.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        tools: &mut PictureTools,
    ) -> Vec<Command> {
        let mut commands = Vec::new();
        self.sheet.begin_frame(session);
        self.files.sync(session);
        let panel = ui.max_rect();
        bar::show(self, ui, session, tools, &mut commands);
        let (ruler, _) = ui.allocate_exact_size(vec2(ui.available_width(), RULER), Sense::hover());
        let lane = Rect::from_min_max(
            pos2(ruler.left() + NAMES, ruler.top()),
            ruler.max - vec2(10.0, 0.0),
        );
        let axis = Axis { lane, seen: self.seen };
        let beside = Rect::from_min_max(ruler.min, pos2(lane.left() - 8.0, ruler.bottom()));
        transport::time(ui, beside, session, tools.playback());
        axis.ruler(ui, self.fps, self.range, session.shot().is_some());
        transport::band(self, ui, axis, tools.playback());
        self.scrub(ui, session, axis, &mut commands);
        markers::show(self, ui, session, axis, &mut commands);
        edges::show(self, ui, session, axis, &mut commands);
        differences::show(self, ui, tools, axis, &mut commands);
        let top = ui.cursor().top();
        let is_empty = times(session).next().is_none()
            && shot_tracks::times(session).is_empty()
            && self.files.is_empty();
        if is_empty {
            ui.add_space(6.0);
            hint(
                ui,
                tr!("Nothing changes with time yet. Press the diamond beside a value in the \
                     inspector and choose \"Key here\", or add a value above; then move the \
                     playhead and set it to something else."),
            );
        } else {
            // The row of the selected keys is below, so that no key moves as it is pressed.
            let height = (ui.available_height() - self.bar_height).max(ROW);
            self.curve_height = height.clamp(*graph::HEIGHTS.start(), *graph::HEIGHTS.end());
            let tracks = ScrollArea::vertical().auto_shrink([false, false]).max_height(height);
            tracks.show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 2.0;
                for owned in owners(session) {
                    for track in 0..owned.look().time_keys.len() {
                        rows::show(self, ui, owned, axis, track, &mut commands);
                    }
                }
                shot_tracks::show(self, ui, session, axis, &mut commands);
                file_tracks::show(self, ui, session, axis, &mut commands);
            });
        }
        let bottom = ui.cursor().top().min(panel.bottom());
        let rows = Rect::from_min_max(pos2(lane.left(), top), pos2(lane.right(), bottom));
        key_bar::show(self, ui, session, &mut commands);
        let bar_height = ui.cursor().top() - bottom;
        // Its greatest height stays, so that curves keep theirs while keys are chosen.
        if bar_height > self.bar_height {
            self.bar_height = bar_height;
            ui.ctx().request_repaint();
        }
        self.panel = Some(panel);
        sheet::go_on(self, ui, session, axis, &mut commands);
        if let Some(time) = self.went.take() {
            self.go(time, &mut commands);
        }
        if std::mem::take(&mut self.is_deleting) {
            self.sheet.delete(session, &mut commands);
        }
        if let Some(later) = self.steps.take() {
            let picked = self.sheet.picked(session);
            let widget = Some(ui.scope_id().with("steps"));
            let time = |time: f64| tidy(time + later);
            self.sheet.retime(session, picked, (1.0, &time), widget, &mut commands);
        }
        let drawn = self.sheet.select_in_box(ui);
        self.sheet.learn(session);
        if let Some(drawn) = drawn {
            let color = theme::of(ui).accent;
            let painter = ui.painter_at(rows);
            let stroke = Stroke::new(1.0, color);
            painter.rect(drawn, 0.0, color.gamma_multiply(0.12), stroke, egui::StrokeKind::Inside);
        }
        self.navigate(ui, panel, axis, rows);
        // Above the hint of an empty timeline, which is to be read.
        playhead(ui, session, axis, if is_empty { top } else { rows.bottom() });
        commands
    }

    /// Handles drags of the range's ends, and drags on the ruler, which move the playhead.
    fn scrub(&mut self, ui: &mut Ui, session: &Session, axis: Axis, out: &mut Vec<Command>) {
        let id = ui.scope_id().with("ruler");
        let response = ui.interact(axis.lane, id, Sense::click_and_drag());
        let time = session.view.time;
        response.widget_info(|| egui::WidgetInfo::slider(true, time, tr!("Playhead")));
        self.range_ends(ui, axis);
        // Above an end of the range, which would otherwise be dragged in its place.
        let response = match playhead_grip(ui, id.with("playhead"), session, axis) {
            Some(grip) => response.union(grip),
            None => response,
        };
        let is_part = transport::choose_part(self, ui, axis, &response);
        self.clock.is_scrubbed = response.dragged() && !is_part;
        if let Some(pointer) = response
            .interact_pointer_pos()
            .filter(|_| !is_part && (response.dragged() || response.clicked()))
        {
            let time = self.snapped(axis.time(pointer.x));
            if session.exact_time(time) != session.view.time {
                self.go(time, out);
            }
        }
        response.on_hover_text(tr!(
            "Drag to scrub; with Shift choose the part that is played. The wheel zooms in time; a \
             drag with the middle button pans."
        ));
    }

    /// Shows the ends of the range as flags, and handles their drags.
    fn range_ends(&mut self, ui: &Ui, axis: Axis) {
        let names = [tr!("Start of the range"), tr!("End of the range")];
        for (end, name) in names.into_iter().enumerate() {
            let at = pos2(axis.x(self.range[end]), axis.lane.bottom() - 5.0);
            if !axis.lane.expand(2.0).contains(at) {
                continue;
            }
            let handled = crate::widgets::handle::handle(
                ui,
                ui.scope_id().with(("end of the range", end)),
                at,
                name,
                self.range[end],
                true,
            );
            let wished = handled.to.map(|to| axis.time(to.x));
            let step = f64::from(handled.steps.x) / self.fps;
            if let Some(time) = wished.or((step != 0.0).then_some(self.range[end] + step)) {
                let gap = 1.0 / self.fps;
                let other = self.range[1 - end];
                let time = self.snapped(time);
                self.range[end] =
                    if end == 0 { time.min(other - gap) } else { time.max(other + gap) };
            }
            axis::flag(ui, at, end == 1, &handled.response);
            handled.response.on_hover_text(tr!("{name}: what is played"));
        }
    }

    /// Moves the visible range: the wheel zooms over the ruler, and everywhere with Ctrl; a drag
    /// beside the keys pans.
    fn navigate(&mut self, ui: &Ui, panel: Rect, axis: Axis, rows: Rect) {
        let Some(pointer) =
            ui.input(|input| input.pointer.hover_pos()).filter(|at| panel.contains(*at))
        else {
            return;
        };
        if !ui.rect_contains_pointer(panel) {
            return;
        }
        let (scroll, zoom) = ui.input(|input| (input.smooth_scroll_delta, input.zoom_delta()));
        let is_ruler = axis.lane.contains(pointer);
        let factor =
            f64::from(zoom) * if is_ruler { f64::from(scroll.y / 200.0).exp() } else { 1.0 };
        if factor != 1.0 && (is_ruler || rows.contains(pointer)) {
            self.seen = axis.zoomed(pointer.x, factor);
        }
        if scroll.x != 0.0 {
            self.seen = axis.panned(scroll.x);
        }
        let middle =
            ui.input(|input| input.pointer.middle_down().then_some(input.pointer.delta().x));
        if let Some(by) = middle.filter(|by| *by != 0.0) {
            self.seen = axis.panned(by);
        }
    }

    /// Fits the selected keys into view, or all keys and the range.
    fn fit_selected(&mut self, session: &Session) {
        match self.sheet.range(session).filter(|[low, high]| high - low > LEAST) {
            Some([low, high]) => {
                let margin = 0.1 * (high - low);
                self.seen = [low - margin, high + margin];
            }
            None => self.fit(session),
        }
    }

    /// The nearest of some times before or after the playhead.
    fn neighbor(
        &self,
        times: impl Iterator<Item = f64>,
        session: &Session,
        way: f64,
    ) -> Option<f64> {
        let beyond = times.filter(|time| (time - session.view.time) * way > LEAST / 2.0);
        beyond.min_by(|a, b| (a * way).total_cmp(&(b * way)))
    }

    /// Scales keys about a time, as they were when a gesture began.
    fn scale(
        &mut self,
        session: &Session,
        held: Vec<sheet::PickedTrack>,
        (about, scale): (f64, f64),
        widget: egui::Id,
        out: &mut Vec<Command>,
    ) {
        let snaps = (self.snaps, self.fps);
        let time = |time: f64| {
            let time = about + (time - about) * scale;
            let (snaps, fps) = snaps;
            if snaps { tidy((time * fps).round() / fps) } else { tidy(time) }
        };
        if scale.is_finite() && scale > 0.0 {
            self.sheet.retime(session, held, (scale, &time), Some(widget), out);
        }
    }

    /// Fits all keys and the range into view.
    fn fit(&mut self, session: &Session) {
        let [mut low, mut high] = self.range;
        for time in times(session).chain(shot_tracks::times(session)) {
            (low, high) = (low.min(time), high.max(time));
        }
        let margin = 0.05 * (high - low).max(0.1);
        self.seen = [low - margin, high + margin];
    }
}

/// Documents whose tracks are shown: the look's, then those of the scene's lights.
fn owners(session: &Session) -> impl Iterator<Item = OwnedKeys<'_>> {
    [Owner::Look, Owner::Scene].into_iter().filter_map(|owner| OwnedKeys::of(session, owner))
}

/// Times of all keys, in seconds.
fn times(session: &Session) -> impl Iterator<Item = f64> {
    let tracks = owners(session).flat_map(|owned| &owned.look().time_keys);
    tracks.flat_map(|track| &track.keys).map(|key| key.time)
}

/// The head of the playhead, where it is seen or dragged.
fn playhead_grip(ui: &Ui, id: egui::Id, session: &Session, axis: Axis) -> Option<egui::Response> {
    let (x, lane) = (axis.x(session.view.time), axis.lane);
    if !lane.x_range().contains(x) && !ui.ctx().is_being_dragged(id) {
        return None;
    }
    let top = pos2(x.clamp(lane.left(), lane.right()), lane.top());
    let head = Rect::from_min_max(top - vec2(HEAD.x / 2.0, 0.0), top + vec2(HEAD.x / 2.0, HEAD.y));
    // The ruler is what the keyboard comes to.
    Some(ui.interact(head, id, Sense::CLICK | Sense::DRAG))
}

fn playhead(ui: &Ui, session: &Session, axis: Axis, bottom: f32) {
    let x = axis.x(session.view.time);
    if !(axis.lane.left() - 1.0..=axis.lane.right() + 1.0).contains(&x) {
        return;
    }
    let color = theme::of(ui).accent;
    ui.painter().vline(x, axis.lane.top() + 8.0..=bottom, Stroke::new(1.5, color));
    let top = pos2(x, axis.lane.top() + 10.0);
    let points =
        [vec2(-6.0, -8.0), vec2(6.0, -8.0), vec2(6.0, -2.0), vec2(0.0, 5.0), vec2(-6.0, -2.0)];
    let shape = points.map(|d| top + d).to_vec();
    ui.painter().add(egui::Shape::convex_polygon(shape, color, Stroke::NONE));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_snap_to_frames() {
        let mut timeline = Timeline { fps: 24.0, ..Timeline::default() };
        assert_eq!(timeline.snapped(0.5), 0.5);
        assert_eq!(timeline.snapped(0.51), 0.5, "frame 12.24");
        timeline.snaps = false;
        assert_eq!(timeline.snapped(0.512_345_678), 0.512_346);
    }
}
