//! Widget of BADF figure 3: a layer's offset, fall-off and cut-off as lines on the surface, which
//! are dragged there.
//!
//! Lines that coincide are grabbed together and move together; Ctrl pulls one of them off.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::epaint::PathStroke;
use eframe::egui::{
    Align2, Color32, FontId, Id, Painter, Pos2, Rect, Shape, Stroke, Ui, pos2, vec2,
};

use super::field::{Field, Line, light_values};
use super::surface::Surface;
use crate::commands::Command;
use crate::compile::LightValues;
use crate::fields::edge::EdgeField;
use crate::fields::layer::{Curve, SelectedLayer};
use crate::state::session::Session;
use crate::values;
use crate::widgets::theme;

/// Distance within which a line is hit, in points.
const REACH: f32 = 7.0;
/// Distance below which lines coincide, in radians.
const TOGETHER: f64 = 1e-6;
/// Length below which a line is noise of the mesh, in points.
const SHORTEST: f32 = 9.0;
/// Number of lines of one angle beyond which the mesh is rough there.
const MANY: usize = 24;
/// Part of the longest line below which a line is noise of a rough mesh.
const NOISE: f32 = 0.12;
/// Length of an offset's line below which a ring stands for it, in points.
const RING_BELOW: f32 = 48.0;
/// Offset beyond which there is no ring, however short the line, in radians: its end is out of
/// view.
const RING_WITHIN: f64 = 0.5;
/// Radius of the ring, in points.
pub(super) const RING: f32 = 14.0;
/// Largest angle from the light at which the middle of the lit part counts as visible, in radians.
const NEAR_MIDDLE: f32 = 0.15;

/// Lines of one angle.
#[derive(Debug)]
struct Track {
    /// Curves that have this angle, in order.
    curves: Vec<Curve>,
    level: f64,
    lines: Vec<Line>,
}

impl Track {
    /// Lines that are drawn and taken hold of.
    fn lines_without_noise(&self, rect: Rect) -> impl Iterator<Item = &Line> {
        let lengths: Vec<f32> = self.lines.iter().map(|line| length(line, rect)).collect();
        let least = least_length(&lengths);
        let lines = self.lines.iter().zip(lengths);
        lines.filter_map(move |(line, length)| (length >= least).then_some(line))
    }
}

/// Inputs of the lines: for the same inputs the known lines are used.
#[derive(Clone, Debug, PartialEq)]
struct IsocurveInputs {
    layer: SelectedLayer,
    light: LightValues,
}

/// Curves that are dragged.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HeldCurve {
    curves: Vec<Curve>,
    /// True if one of the curves is to be pulled off, as soon as the drag shows which.
    splits: bool,
    /// Angle of the curves when the drag began, in radians.
    level: f64,
    /// True if the fall-off takes the whole soft edge along.
    moves_edge: bool,
}

/// The widget and its state between frames.
#[derive(Default)]
pub(super) struct Isocurves {
    made: Option<IsocurveInputs>,
    surface: Option<Arc<Surface>>,
    field: Field,
    tracks: Vec<Track>,
    /// Place of the pixel nearest to the light, in parts of the picture's size; `None` where no
    /// pixel is near the light.
    middle: Option<[f32; 2]>,
}

impl Isocurves {
    /// Drops the lines, as nothing that has any is selected.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Makes the lines anew where their inputs have changed.
    pub(super) fn update(
        &mut self,
        session: &Session,
        surface: &Arc<Surface>,
        layer: &SelectedLayer,
    ) {
        let Some(light) = session.keys().light(&layer.light) else { return self.clear() };
        let light = light_values(light, session, surface);
        let is_same_surface =
            self.surface.as_ref().is_some_and(|known| Arc::ptr_eq(known, surface));
        let same = |made: &&IsocurveInputs| is_same_surface && made.light == light;
        let known = self.made.as_ref().filter(same);
        if known.is_some_and(|made| made.layer == *layer) {
            return;
        }
        if known
            .is_none_or(|made| (made.layer.shading, made.layer.warp) != (layer.shading, layer.warp))
        {
            let (field, least) = Field::new(surface, layer, &light);
            self.field = field;
            let near = least.filter(|(_, angle)| *angle < NEAR_MIDDLE);
            self.middle = near.map(|(pixel, _)| surface.place_of(pixel));
            self.tracks.clear();
        }
        self.surface = Some(surface.clone());
        let mut old = std::mem::take(&mut self.tracks);
        for (curve, level) in layer.curves() {
            if let Some(last) =
                self.tracks.last_mut().filter(|last| (last.level - level).abs() < TOGETHER)
            {
                last.curves.push(curve);
                continue;
            }
            let known = old
                .iter_mut()
                .find(|track| track.level == level)
                .map(|track| std::mem::take(&mut track.lines));
            let lines = known.unwrap_or_else(|| self.field.lines(surface, level as f32));
            self.tracks.push(Track { curves: vec![curve], level, lines });
        }
        self.made = Some(IsocurveInputs { layer: layer.clone(), light });
    }

    /// Middle of the lit part on the screen, where visible.
    pub(super) fn middle(&self, rect: Rect) -> Option<Pos2> {
        self.middle.map(|place| on_screen(rect, place))
    }

    /// Angle at a point of the screen, in radians.
    fn angle_at(&self, rect: Rect, at: Pos2) -> Option<f64> {
        let place = [(at.x - rect.min.x) / rect.width(), (at.y - rect.min.y) / rect.height()];
        self.field.at(self.surface.as_ref()?, place).map(f64::from)
    }

    /// Curves under the pointer.
    pub(super) fn hit(&self, rect: Rect, at: Pos2, splits: bool) -> Option<HeldCurve> {
        let distance = |track: &Track| {
            let lines = track.lines_without_noise(rect);
            let mut nearest =
                lines.map(|line| distance_to(line, rect, at)).fold(f32::INFINITY, f32::min);
            if self.has_ring(track, rect)
                && let Some(middle) = self.middle(rect)
            {
                nearest = nearest.min((at.distance(middle) - RING).abs());
            }
            nearest
        };
        let nearest = self.tracks.iter().map(|track| (distance(track), track));
        let (distance, track) = nearest.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let is_edge = || self.made.as_ref().is_some_and(|made| made.layer.edge().is_some());
        let moves_edge = !splits && track.curves == [Curve::Falloff] && is_edge();
        let splits = splits && track.curves.len() > 1;
        (distance <= REACH).then(|| HeldCurve {
            curves: track.curves.clone(),
            splits,
            level: track.level,
            moves_edge,
        })
    }

    /// True if a ring stands for an offset whose line is too short.
    fn has_ring(&self, track: &Track, rect: Rect) -> bool {
        matches!(track.curves[0], Curve::Offset | Curve::Edge(0))
            && track.level < RING_WITHIN
            && track.lines.iter().map(|line| length(line, rect)).sum::<f32>() < RING_BELOW
    }

    /// Moves the dragged curves to a point of the screen.
    pub(super) fn drag(
        &self,
        held: &mut HeldCurve,
        session: &Session,
        rect: Rect,
        at: Pos2,
    ) -> Option<Command> {
        let layer = &self.made.as_ref()?.layer;
        let angle = self.angle_at(rect, at)?;
        if held.splits {
            let away = angle - held.level;
            if away.abs() < 0.01 {
                return None;
            }
            // A drag inward pulls the first curve off, a drag outward the last.
            let one = if away < 0.0 { held.curves.first() } else { held.curves.last() };
            held.curves = one.copied().into_iter().collect();
            held.splits = false;
        }
        // A hundredth of a degree is finer than a pixel, and keeps files readable.
        let angle = (angle * 1e4).round() / 1e4;
        let keys = session.keys();
        let edit = match layer.edge().filter(|_| held.moves_edge) {
            Some(edge) => {
                let field = EdgeField::of_layer(session, layer)?;
                keys.set_together(&field.values_of(edge.moved_to(angle)))
            }
            None => keys.set_all_at(layer.moved(&held.curves, angle)),
        };
        Some(Command::EditHeld(Id::unique("isocurve"), edit))
    }

    /// Hint on the drag of these curves.
    pub(super) fn hint(&self, held: &HeldCurve) -> String {
        let names = names(&held.curves);
        let mut parts = vec![match held.curves[..] {
            _ if held.moves_edge => tr!("Drag {names}: the whole edge, as soft as it is"),
            [Curve::Edge(_), ..] => tr!("Drag {names}: where one band ends and the next begins"),
            [Curve::Offset] => tr!("Drag {names}: up to here the tone is full"),
            [Curve::Falloff] => tr!("Drag {names}: here the tone falls fastest"),
            [Curve::Cutoff] => tr!("Drag {names}: here the tone ends"),
            [Curve::Offset, .., Curve::Cutoff] => tr!("Drag {names}: a hard edge"),
            [Curve::Offset, ..] => tr!("Drag {names}: where the tone begins to fall"),
            _ => tr!("Drag {names}: where the tone ends"),
        }];
        if held.moves_edge {
            parts.push(tr!("Ctrl-drag takes the fall-off alone").to_owned());
        } else if held.curves.len() > 1 && !held.splits {
            let text = tr!("Ctrl-drag takes one alone: inward the first, outward the last");
            parts.push(text.to_owned());
        }
        let left_out = self.made.as_ref().and_then(|made| made.layer.leaves_out);
        parts.extend(left_out.map(|what| tr!("drawn without {what}")));
        parts.join(" · ")
    }

    /// Draws the lines; `marked` are dragged or under the pointer, and `is_near` is true while the
    /// pointer is over the picture.
    pub(super) fn paint(&self, ui: &Ui, rect: Rect, marked: Option<&HeldCurve>, is_near: bool) {
        let painter = ui.painter_at(rect);
        let is_marked = |track: &Track| {
            marked.is_some_and(|held| held.curves.iter().any(|curve| track.curves.contains(curve)))
        };
        for track in &self.tracks {
            let width = if is_marked(track) { 3.0 } else { 1.8 };
            let strength = if is_near || is_marked(track) { 1.0 } else { 0.65 };
            for line in track.lines_without_noise(rect) {
                let points: Vec<Pos2> =
                    line.points.iter().map(|place| on_screen(rect, *place)).collect();
                paint_line(&painter, &points, line.is_closed, &track.curves, width, strength);
            }
            if self.has_ring(track, rect)
                && let Some(middle) = self.middle(rect)
            {
                let color = ink(track.curves[0]).gamma_multiply(strength);
                painter.circle_stroke(
                    middle,
                    RING,
                    Stroke::new(width + 2.0, theme::HALO.gamma_multiply(strength)),
                );
                painter.circle_stroke(middle, RING, Stroke::new(width, color));
            }
        }
        if is_near || marked.is_some() {
            self.labels(&painter, rect, marked);
        }
    }

    /// Draws names and angles, each on its own line where that is farthest from the light.
    fn labels(&self, painter: &Painter, rect: Rect, marked: Option<&HeldCurve>) {
        let middle = self.middle(rect).unwrap_or(rect.left_top());
        let away = (rect.center() - middle).normalized();
        let away = if away.length() < 0.5 { vec2(0.6, 0.8) } else { away };
        let mut taken: Vec<Rect> = Vec::new();
        for track in &self.tracks {
            let longest =
                track.lines.iter().max_by(|a, b| length(a, rect).total_cmp(&length(b, rect)));
            let longest = longest.filter(|line| length(line, rect) >= SHORTEST);
            let at = match longest {
                _ if self.has_ring(track, rect) => {
                    self.middle(rect).map(|middle| middle + away * RING)
                }
                Some(line) => {
                    let points = line.points.iter().map(|place| on_screen(rect, *place));
                    points
                        .max_by(|a, b| (*a - middle).dot(away).total_cmp(&(*b - middle).dot(away)))
                }
                None => None,
            };
            let Some(at) = at else { continue };
            let text = format!(
                "{} {}°",
                names(&track.curves),
                values::number_text(track.level.to_degrees(), 1)
            );
            let is_marked = marked.is_some_and(|held| held.curves == track.curves);
            let color = if is_marked { Color32::WHITE } else { ink(track.curves[0]) };
            let galley =
                painter.layout_no_wrap(text, FontId::proportional(theme::SMALL_TEXT), color);
            let mut place =
                Align2::LEFT_TOP.anchor_size(at + vec2(8.0, 6.0), galley.size() + vec2(8.0, 3.0));
            let over = (place.max - rect.max).max(egui::Vec2::ZERO);
            place = place.translate(-over);
            while let Some(other) = taken.iter().find(|other| other.intersects(place)) {
                place = place.translate(vec2(0.0, other.max.y - place.min.y + 2.0));
            }
            taken.push(place);
            painter.rect_filled(place, 3.0, theme::PLATE);
            painter.galley(place.min + vec2(4.0, 1.5), galley, color);
        }
    }

    /// Points of a curve on the screen; for tests.
    pub(super) fn points(&self, curve: Curve, rect: Rect) -> Vec<Pos2> {
        let tracks = self.tracks.iter().filter(|track| track.curves.contains(&curve));
        let lines = tracks.flat_map(|track| track.lines_without_noise(rect));
        lines.flat_map(|line| &line.points).map(|place| on_screen(rect, *place)).collect()
    }
}

fn names(curves: &[Curve]) -> String {
    let within = |curve: &Curve| match curve {
        Curve::Offset => tr!("within a sentence" => "offset").to_owned(),
        Curve::Falloff => tr!("within a sentence" => "fall-off").to_owned(),
        Curve::Cutoff => tr!("within a sentence" => "cut-off").to_owned(),
        Curve::Edge(index) => tr!("within a sentence" => "edge {number}", number = index + 1),
    };
    let Some((first, others)) = curves.split_first() else { return String::new() };
    let mut names = vec![first.label()];
    names.extend(others.iter().map(within));
    match names.as_slice() {
        [names @ .., last] if !names.is_empty() => {
            tr!("{names} and {last}", names = names.join(", "))
        }
        _ => names.concat(),
    }
}

/// Color of a curve; those of bands take turns.
fn ink(curve: Curve) -> Color32 {
    theme::curve(curve.index() % Curve::ALL.len())
}

fn paint_line(
    painter: &Painter,
    points: &[Pos2],
    is_closed: bool,
    curves: &[Curve],
    width: f32,
    strength: f32,
) {
    let shape = |points: Vec<Pos2>, stroke: Stroke| {
        let stroke = PathStroke::from(stroke);
        if is_closed { Shape::closed_line(points, stroke) } else { Shape::line(points, stroke) }
    };
    painter.add(shape(
        points.to_vec(),
        Stroke::new(width + 2.2, theme::HALO.gamma_multiply(strength)),
    ));
    let color = |curve: Curve| ink(curve).gamma_multiply(strength);
    painter.add(shape(points.to_vec(), Stroke::new(width, color(curves[0]))));
    // Curves that coincide are shown between the dashes of one another.
    let (dash, count) = (9.0, curves.len() as f32);
    for (index, curve) in curves.iter().enumerate().skip(1) {
        let mut path = points.to_vec();
        if is_closed && let Some(first) = points.first() {
            path.push(*first);
        }
        let mut shapes = Vec::new();
        let offset = dash * index as f32;
        let gap = dash * (count - 1.0);
        Shape::dashed_line_many_with_offset(
            &path,
            Stroke::new(width, color(*curve)),
            &[dash],
            &[gap],
            offset,
            &mut shapes,
        );
        painter.extend(shapes);
    }
}

fn on_screen(rect: Rect, place: [f32; 2]) -> Pos2 {
    pos2(rect.min.x + place[0] * rect.width(), rect.min.y + place[1] * rect.height())
}

fn segments(line: &Line, rect: Rect) -> impl Iterator<Item = (Pos2, Pos2)> + '_ {
    let points = &line.points;
    let count = if line.is_closed { points.len() } else { points.len().saturating_sub(1) };
    (0..count)
        .map(move |k| (on_screen(rect, points[k]), on_screen(rect, points[(k + 1) % points.len()])))
}

/// Length from which on lines of one angle are drawn, in points: on a rough mesh most of them go
/// around single bumps.
fn least_length(lengths: &[f32]) -> f32 {
    let count = lengths.iter().filter(|length| **length >= SHORTEST).count();
    let longest = lengths.iter().copied().fold(0.0, f32::max);
    if count > MANY { SHORTEST.max(NOISE * longest) } else { SHORTEST }
}

fn length(line: &Line, rect: Rect) -> f32 {
    segments(line, rect).map(|(a, b)| a.distance(b)).sum()
}

fn distance_to(line: &Line, rect: Rect, at: Pos2) -> f32 {
    let distance = |(a, b): (Pos2, Pos2)| {
        let t = ((at - a).dot(b - a) / (b - a).length_sq().max(1e-9)).clamp(0.0, 1.0);
        at.distance(a + (b - a) * t)
    };
    segments(line, rect).map(distance).fold(f32::INFINITY, f32::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_around_bumps_are_left_out_and_lines_of_several_bodies_stay() {
        let bodies = [400.0, 60.0, 12.0, 3.0];
        assert_eq!(least_length(&bodies), SHORTEST);
        let bumps: Vec<f32> = std::iter::once(400.0).chain([20.0; 60]).collect();
        let least = least_length(&bumps);
        assert!(bumps.iter().filter(|length| **length >= least).count() == 1, "{least}");
        // Many lines of like lengths are all there is.
        assert_eq!(least_length(&[20.0; 60]), SHORTEST);
        assert_eq!(least_length(&[]), SHORTEST);
    }
}
