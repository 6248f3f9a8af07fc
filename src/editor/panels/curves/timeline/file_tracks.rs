//! Tracks that are read in the files of meshes: the camera of the picture, and the clips that
//! objects play. They are outlined and dashed where keys that are edited here are filled.

use chiaro_locale::tr;
use eframe::egui::{
    self, Button, Color32, FontId, Pos2, Rect, RichText, Role, Sense, Shape, Stroke, StrokeKind,
    Ui, WidgetInfo, pos2, vec2,
};

use super::axis::Axis;
use super::{NAMES, ROW, Timeline, graph};
use crate::commands::{Command, SceneCommand, ShotCommand};
use crate::fields::mark;
use crate::state::revision::{FilesRevision, PictureRevision};
use crate::state::scene::{CameraInFile, FileMotion, PlayedClip};
use crate::state::session::Session;
use crate::values;
use crate::widgets::text::cell;
use crate::widgets::theme;

/// Height of the camera's row, in points.
const CAMERA_ROW: f32 = 56.0;
/// Greatest number of frames that a curve is drawn by.
const MOST_POINTS: i32 = 200;
/// Length of a dash of a curve and of the gap behind it, in points.
const DASH: [f32; 2] = [5.0, 3.0];

/// State of the scene that motion was read in.
type MotionKey = (Option<PictureRevision>, FilesRevision);

/// Motion of the open scene's files, as last read.
#[derive(Default)]
pub(super) struct FileTracks {
    key: Option<MotionKey>,
    motion: Option<FileMotion>,
    path: Option<EyePath>,
}

/// Places of the camera's eye at frames.
struct EyePath {
    /// First frame, last frame, and frames from one place to the next.
    frames: [i32; 3],
    fps: f64,
    /// Times in seconds, with the place then.
    eyes: Vec<(f64, [f64; 3])>,
}

impl EyePath {
    /// The path over the frames of a range of times, in seconds.
    fn of(motion: &FileMotion, [from, to]: [f64; 2], fps: f64) -> Self {
        let frames = frames_of([from, to], fps);
        let [first, last, step] = frames;
        let eye = |frame: i32| {
            let time = f64::from(frame) / fps;
            (time, motion.camera_at(time).eye)
        };
        let eyes = (first..=last).step_by(step.unsigned_abs().max(1) as usize).map(eye).collect();
        Self { frames, fps, eyes }
    }
}

/// The first and the last frame around a range of times, and the frames from one point of a curve
/// to the next.
fn frames_of([from, to]: [f64; 2], fps: f64) -> [i32; 3] {
    let span = ((to - from) * fps).max(1.0);
    let step = (span / f64::from(MOST_POINTS)).ceil();
    // On multiples of the step, so that points stay while the range is panned.
    let first = (from * fps / step).floor() * step;
    let last = (to * fps / step).ceil() * step;
    [first as i32, last as i32, step as i32]
}

impl FileTracks {
    /// Brings the motion up to date with the open scene.
    pub(super) fn sync(&mut self, session: &Session) {
        let open_scene = session.open_scene().filter(|open_scene| {
            let mut objects = open_scene.scene().objects.values();
            !open_scene.placed.is_empty() && objects.any(|object| object.animation.is_some())
        });
        let Some(_) = open_scene else { return *self = Self::default() };
        let key = (session.scene_revision(), session.revisions().files);
        if self.key != Some(key) {
            *self = Self { key: Some(key), motion: session.file_motion(), path: None };
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.motion.as_ref().is_none_or(|motion| motion.clips.is_empty())
    }

    /// Reads where the camera is over the visible range.
    fn follow_camera(&mut self, seen: [f64; 2], fps: f64) {
        let Some(motion) = &self.motion else { return };
        let frames = frames_of(seen, fps);
        if self.path.as_ref().is_none_or(|path| (path.frames, path.fps) != (frames, fps)) {
            self.path = Some(EyePath::of(motion, seen, fps));
        }
    }
}

/// Shows the tracks.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    axis: Axis,
    out: &mut Vec<Command>,
) {
    let (seen, fps) = (timeline.seen, timeline.fps);
    let tracks = &mut timeline.files;
    if tracks.motion.as_ref().is_some_and(|motion| motion.camera.is_some()) {
        tracks.follow_camera(seen, fps);
    }
    let Some(motion) = &tracks.motion else { return };
    if let Some(camera) = &motion.camera {
        let path = tracks.path.as_ref().map_or(&[][..], |path| &path.eyes);
        camera_row(ui, session, axis, (camera, path), out);
    }
    for clip in &motion.clips {
        clip_row(ui, axis, clip);
    }
}

/// Text on a clip: its name, and its length in seconds of the file.
fn clip_text(clip: &PlayedClip) -> String {
    let seconds = values::number_text(clip.seconds, 2);
    tr!("{clip}, {seconds} s", clip = clip.name)
}

fn camera_row(
    ui: &mut Ui,
    session: &Session,
    axis: Axis,
    (camera, path): (&CameraInFile, &[(f64, [f64; 3])]),
    out: &mut Vec<Command>,
) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), CAMERA_ROW), Sense::hover());
    if !ui.is_rect_visible(rect) {
        return;
    }
    let (name, clip) = (&camera.name, &camera.clip);
    let file = &clip.file;
    let above = tr!("{name} of {file}");
    let below = tr!("Camera: {clip}", clip = clip_text(clip));
    let names = names(ui, rect, [&above, &below]);
    let builder = egui::UiBuilder::new().id_salt("camera of a file").max_rect(names);
    keys_of_it(&mut ui.new_child(builder), session, out);
    let label = tr!("Track in {file}: camera {name}");
    let help = tr!(
        "Where the camera {name} is: read in {file}, whose clip {clip} moves it, and not edited \
         here. Pictures are drawn from it. Red, green and blue are its x, y and z.",
        clip = clip.name
    );
    let lane = lane(ui, axis, rect, (&label, &help));
    seams(ui, axis, lane, clip);
    let numbers = || path.iter().flat_map(|(_, eye)| *eye);
    let (low, high) = (numbers().fold(f64::MAX, f64::min), numbers().fold(f64::MIN, f64::max));
    let y = |x: f64| {
        let share = if high > low { (x - low) / (high - low) } else { 0.5 };
        lane.bottom() - 7.0 - (lane.height() - 14.0) * share as f32
    };
    for at in 0..3 {
        let points: Vec<Pos2> =
            path.iter().map(|(time, eye)| pos2(axis.x(*time), y(eye[at]))).collect();
        let stroke = Stroke::new(1.0, graph::ink(ui, 3, at));
        let dashes = Shape::dashed_line(&points, stroke, DASH[0], DASH[1]);
        ui.painter_at(lane).extend(dashes);
    }
}

/// Shows the button that makes keys of the shot of the camera's motion.
fn keys_of_it(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    let shot = session.shot();
    if shot.is_some_and(|shot| shot.places_camera()) {
        let text = RichText::new(tr!("Keys of the shot stand over it")).small();
        let help = tr!("Without them, reset in Shot, the picture is seen from the file's camera");
        ui.label(text.color(theme::of(ui).dim)).on_hover_text(help);
        return;
    }
    let help = tr!(
        "Keys of the shot that put its camera where this one is at every frame, as few as that \
         takes: they are edited here, and the file stays as it is. One step of undo. The lens \
         stays the file's."
    );
    let button = ui.add_enabled(shot.is_some(), Button::new(tr!("Make keys of it")).small());
    let button = button.on_disabled_hover_text(tr!(
        "Keys of the camera are a shot's: the panel Shot begins one over this scene"
    ));
    if button.on_hover_text(help).clicked() {
        out.push(Command::Scene(SceneCommand::Shot(ShotCommand::KeyCameraOfFile)));
    }
}

fn clip_row(ui: &mut Ui, axis: Axis, clip: &PlayedClip) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    if !ui.is_rect_visible(rect) {
        return;
    }
    let PlayedClip { object, file, name, .. } = clip;
    let above = tr!("{object}, by {file}");
    names(ui, rect, [&above, &clip_text(clip)]);
    let label = tr!("Track in {file}: clip {name} of {object}");
    let help = tr!(
        "The clip {name}, which {object} plays: poses that are read in {file}, and not edited \
         here. A line is where it begins anew or ends. Its speed and its start are in Objects, \
         where the shot changes them."
    );
    let lane = lane(ui, axis, rect, (&label, &help));
    seams(ui, axis, lane, clip);
}

/// Shows two lines of names, and returns the room below them.
fn names(ui: &Ui, rect: Rect, [above, below]: [&str; 2]) -> Rect {
    let colors = theme::of(ui);
    let left = rect.left() + 36.0;
    let line = |top: f32, bottom: f32| {
        let from = pos2(left, rect.top() + top);
        Rect::from_min_max(from, pos2(rect.left() + NAMES - 8.0, rect.top() + bottom))
    };
    let small = FontId::proportional(theme::SMALL_TEXT);
    let font = egui::TextStyle::Body.resolve(ui.style());
    cell(ui, line(0.0, 0.46 * ROW), above, small, colors.dim);
    cell(ui, line(0.46 * ROW, ROW), below, font, colors.text);
    line(ROW + 2.0, rect.height())
}

/// Shows the outline of a track that is not edited here.
fn lane(ui: &Ui, axis: Axis, rect: Rect, (label, help): (&str, &str)) -> Rect {
    let lane = Rect::from_x_y_ranges(axis.lane.x_range(), rect.y_range());
    let stroke = Stroke::new(1.0, theme::of(ui).dim.gamma_multiply(0.5));
    ui.painter().rect_stroke(lane, 3.0, stroke, StrokeKind::Inside);
    let response = ui.interact(lane, ui.scope_id().with(label), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, label));
    response.on_hover_text(help);
    lane
}

/// Draws where a clip begins anew or ends, and the keys of the file: smaller than those of the
/// shot, hollow, and at the edge.
fn seams(ui: &Ui, axis: Axis, lane: Rect, clip: &PlayedClip) {
    let stroke = Stroke::new(1.0, theme::of(ui).dim);
    let painter = ui.painter_at(lane);
    for time in clip.seams(axis.seen) {
        painter.vline(axis.x(time), lane.y_range(), stroke);
    }
    for time in clip.key_times(axis.seen) {
        let at = pos2(axis.x(time), lane.bottom() - 5.0);
        mark::diamond(ui, at, 2.5, Color32::TRANSPARENT, stroke.color);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_stay_on_frames_while_the_range_is_panned() {
        assert_eq!(frames_of([0.0, 2.0], 24.0), [0, 48, 1]);
        assert_eq!(frames_of([0.01, 1.99], 24.0), [0, 48, 1]);
        let [first, last, step] = frames_of([-10.0, 90.0], 24.0);
        assert_eq!((first % step, last % step), (0, 0));
        assert!(step > 1 && (last - first) / step <= MOST_POINTS + 2);
        let [first, last, _] = frames_of([0.5, 0.5001], 24.0);
        assert!(first < last);
    }
}
