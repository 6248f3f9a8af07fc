//! Handles of the selected highlight layer on the object: its middle moves it, the ring turns it,
//! and knobs stretch it, split it and make it larger.
//!
//! The middle is the place whose normal is the middle direction of the layer (the half-vector,
//! moved along its two upright axes). A scan has such places by the dozen, so normals are averaged
//! over a small window first, and of places that fit as well the one nearest to the last is taken.
//! The other handles stand around the middle on the screen, at the layer's own axes.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{
    Align2, Color32, FontId, Id, Pos2, Rect, Sense, Stroke, Ui, Vec2, WidgetInfo, vec2,
};
use glam::{DVec3, Vec3};

use super::field::{LightPlace, light_values};
use super::place::place_in;
use super::surface::Surface;
use crate::commands::Command;
use crate::compile::LightValues;
use crate::document::{Target, Value};
use crate::fields::layer::{SelectedHighlight, Setting};
use crate::state::session::Session;
use crate::values;
use crate::widgets::handle;
use crate::widgets::theme;

/// Distance within which a handle is hit, in points.
const REACH: f32 = 8.0;
/// Radius of the ring, in points.
const RING: f32 = 58.0;
/// Distance of the knobs from the middle where nothing is stretched or split, in points.
const NEAR: f32 = 26.0;
/// Points that a stretch by the factor e takes, and that a split of 1 takes.
const STRETCH: f32 = 40.0;
const SPLIT: f32 = 90.0;
/// Points that a radius of 1 takes.
const SIZE: f32 = 70.0;
/// Range of the stretch that is dragged.
const STRETCHED: [f64; 2] = [-0.5, 0.95];
/// Half of the side of the window that normals are averaged over, in pixels of the surface.
const WINDOW: usize = 3;
/// Angle from the eye's half-vector beyond which nothing is moved: its tangent has no end.
const LEAST_COSINE: f64 = 0.05;
/// Way of an arrow key, in points.
const STEP: f32 = 4.0;

/// Handle of a highlight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HighlightHandle {
    Middle,
    Ring,
    Stretch,
    Split,
    Size,
}

impl HighlightHandle {
    const ALL: [Self; 5] = [Self::Middle, Self::Stretch, Self::Split, Self::Size, Self::Ring];

    /// Name of the handle, as tests find it.
    fn name(self) -> &'static str {
        match self {
            Self::Middle => "Move",
            Self::Ring => "Turn",
            Self::Stretch => "Stretch",
            Self::Split => "Split",
            Self::Size => "Size",
        }
    }

    /// Name of the handle of a layer, for who cannot see it.
    fn label(self, layer: &str) -> String {
        match self {
            Self::Middle => tr!("Move {layer} on the object"),
            Self::Ring => tr!("Turn {layer} on the object"),
            Self::Stretch => tr!("Stretch {layer} on the object"),
            Self::Split => tr!("Split {layer} on the object"),
            Self::Size => tr!("Size {layer} on the object"),
        }
    }

    pub(super) fn hint(self) -> &'static str {
        match self {
            Self::Middle => tr!("Drag to move the highlight over the object"),
            Self::Ring => tr!("Drag to turn the highlight · Shift turns it by steps of 15°"),
            Self::Stretch => tr!("Drag outward to stretch the highlight, inward to shorten it"),
            Self::Split => tr!("Drag outward to split the highlight, inward to join it"),
            Self::Size => tr!("Drag outward to make the highlight larger"),
        }
    }
}

/// Handle that is dragged.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HeldHighlight {
    pub(super) handle: HighlightHandle,
    /// Turn of the layer less that of the pointer when the drag of the ring began, in radians.
    lead: f64,
}

/// Inputs of the place: for the same inputs the known place is used.
#[derive(Clone, Debug, PartialEq)]
struct HighlightInputs {
    layer: SelectedHighlight,
    light: LightValues,
}

/// Middle of a highlight on a surface.
struct Middle {
    pixel: usize,
    /// Axes on the screen that the layer's own have before they are turned: right and upright.
    axes: [Vec2; 2],
}

/// The widget and its state between frames.
#[derive(Default)]
pub(super) struct HighlightGizmo {
    made: Option<HighlightInputs>,
    surface: Option<Arc<Surface>>,
    /// Averaged normals; 0 where there is no surface.
    normals: Vec<Vec3>,
    middle: Option<Middle>,
}

impl HighlightGizmo {
    /// Finds the middle anew where its inputs have changed.
    pub(super) fn update(
        &mut self,
        session: &Session,
        surface: Option<&Arc<Surface>>,
        layer: Option<SelectedHighlight>,
    ) {
        let (Some(surface), Some(layer)) = (surface, layer) else {
            *self = Self::default();
            return;
        };
        let Some(light) = session.keys().light(&layer.light) else {
            *self = Self::default();
            return;
        };
        let light = light_values(light, session, surface);
        if !self.surface.as_ref().is_some_and(|known| Arc::ptr_eq(known, surface)) {
            self.normals = averaged(surface);
            self.surface = Some(surface.clone());
            self.made = None;
        }
        let inputs = HighlightInputs { layer, light };
        if self.made.as_ref() == Some(&inputs) {
            return;
        }
        self.middle = self.find(surface, &inputs);
        self.made = Some(inputs);
    }

    fn find(&self, surface: &Surface, inputs: &HighlightInputs) -> Option<Middle> {
        let place = LightPlace::of(&inputs.light);
        let moved = inputs.layer.moved.each_ref().map(|setting| setting.value);
        let before = self.middle.as_ref().map(|middle| surface.place_of(middle.pixel));
        let cost = |pixel: usize| {
            let normal = self.normals[pixel].as_dvec3();
            let [x, y, z] = half_axes(surface, &place, pixel);
            let middle = (z + moved[0] * x + moved[1] * y).normalize_or(z);
            let away = before.map_or(0.0, |[x, y]| {
                let [px, py] = surface.place_of(pixel);
                f64::from((px - x).hypot(py - y))
            });
            normal.angle_between(middle) + 0.15 * away
        };
        let covered = (0..self.normals.len()).filter(|&pixel| self.normals[pixel] != Vec3::ZERO);
        let costs = covered.map(|pixel| (pixel, cost(pixel)));
        let (pixel, _) =
            costs.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, cost)| *cost < 0.3)?;
        let [x, y, z] = half_axes(surface, &place, pixel);
        let middle = (z + moved[0] * x + moved[1] * y).normalize_or(z);
        let [x, y, _] = axes_around(middle);
        let on_screen = |axis: DVec3| {
            let seen = surface.camera_from_world() * axis;
            vec2(seen.x as f32, -seen.y as f32)
        };
        Some(Middle { pixel, axes: [on_screen(x), on_screen(y)] })
    }

    /// Layer whose handles are shown.
    fn layer(&self) -> Option<&SelectedHighlight> {
        self.made.as_ref().map(|made| &made.layer)
    }

    /// Places of the handles on the screen, with the direction of the first axis there.
    fn places(&self, rect: Rect) -> Option<(Pos2, [Vec2; 2])> {
        let (middle, layer) = (self.middle.as_ref()?, self.layer()?);
        let [x, y] = self.surface.as_ref()?.place_of(middle.pixel);
        let at = rect.min + vec2(x * rect.width(), y * rect.height());
        let (sin, cos) = (layer.turn.value as f32).sin_cos();
        let [x, y] = middle.axes;
        Some((at, [(cos * x + sin * y).normalized(), (cos * y - sin * x).normalized()]))
    }

    /// Place of a handle on the screen.
    fn place(&self, handle: HighlightHandle, rect: Rect) -> Option<Pos2> {
        let (at, [x, y]) = self.places(rect)?;
        let layer = self.layer()?;
        Some(match handle {
            HighlightHandle::Middle => at,
            HighlightHandle::Ring => at + RING * y,
            HighlightHandle::Stretch => at + stretch_way(layer.stretch.value) * x,
            HighlightHandle::Split => at - split_way(layer.split.value) * x,
            HighlightHandle::Size => {
                at + (NEAR + SIZE * layer.edge()?.at.min(1.0) as f32) * (x - y).normalized()
            }
        })
    }

    /// Setting of a handle that has one of its own.
    fn setting(&self, handle: HighlightHandle) -> Option<&Setting<f64>> {
        let layer = self.layer()?;
        Some(match handle {
            HighlightHandle::Size => return None,
            HighlightHandle::Middle => layer.moved.iter().max_by_key(|setting| setting.is_wired)?,
            HighlightHandle::Ring => &layer.turn,
            HighlightHandle::Stretch => &layer.stretch,
            HighlightHandle::Split => &layer.split,
        })
    }

    /// True for a handle whose value can be set.
    fn is_free(&self, handle: HighlightHandle) -> bool {
        match self.setting(handle) {
            Some(setting) => !setting.is_wired,
            None => self.layer().is_some_and(|layer| layer.edge().is_some()),
        }
    }

    /// Handles that can be dragged, with their places.
    fn handles(&self, rect: Rect) -> impl Iterator<Item = (HighlightHandle, Pos2)> {
        let free = HighlightHandle::ALL.into_iter().filter(|handle| self.is_free(*handle));
        free.filter_map(move |handle| Some((handle, self.place(handle, rect)?)))
    }

    /// Handle under the pointer.
    pub(super) fn hit(&self, rect: Rect, at: Pos2) -> Option<HeldHighlight> {
        let (middle, _) = self.places(rect)?;
        let mut found = self.handles(rect).map(|(handle, place)| (handle, place.distance(at)));
        let knob = found.find(|(_, distance)| *distance <= REACH).map(|(handle, _)| handle);
        let is_on_ring = (middle.distance(at) - RING).abs() <= 0.6 * REACH;
        let ring = Some(HighlightHandle::Ring).filter(|ring| {
            is_on_ring && self.setting(*ring).is_some_and(|setting| !setting.is_wired)
        });
        let handle = knob.or(ring)?;
        let lead = self.layer()?.turn.at_key - self.turn_at(rect, at).unwrap_or_default();
        Some(HeldHighlight { handle, lead })
    }

    /// Turn of the first axis toward a point of the screen less a quarter turn, in radians: the
    /// knob of the ring stands on the second axis.
    fn turn_at(&self, rect: Rect, at: Pos2) -> Option<f64> {
        let [x, y] = self.middle.as_ref()?.axes;
        let way = at - self.places(rect)?.0;
        // The axes are foreshortened: the way is made of both.
        let det = x.x * y.y - x.y * y.x;
        if det.abs() < 1e-4 {
            return None;
        }
        let (along, up) = ((way.x * y.y - way.y * y.x) / det, (x.x * way.y - x.y * way.x) / det);
        Some(f64::from(up.atan2(along)) - std::f64::consts::FRAC_PI_2)
    }

    /// Moves the dragged handle to a point of the screen; `in_steps` turns it by 15 degrees.
    pub(super) fn drag(
        &self,
        held: &HeldHighlight,
        session: &Session,
        rect: Rect,
        at: Pos2,
        in_steps: bool,
    ) -> Option<Command> {
        let layer = self.layer()?;
        let set = |setting: &Setting<f64>, value: f64| -> (Target, Value) {
            (setting.target.clone(), Value::Number((value * 1e4).round() / 1e4))
        };
        let values = match held.handle {
            HighlightHandle::Middle => {
                let [x, y] = self.moved_to(rect, at)?;
                vec![set(&layer.moved[0], x), set(&layer.moved[1], y)]
            }
            HighlightHandle::Ring => {
                let turn = self.turn_at(rect, at)? + held.lead;
                let turn = (turn + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU)
                    - std::f64::consts::PI;
                let step = 15_f64.to_radians();
                vec![set(&layer.turn, if in_steps { (turn / step).round() * step } else { turn })]
            }
            HighlightHandle::Stretch => {
                let (middle, [x, _]) = self.places(rect)?;
                let way = f64::from(((at - middle).dot(x) - NEAR) / STRETCH);
                vec![set(&layer.stretch, (1.0 - (-way).exp()).clamp(STRETCHED[0], STRETCHED[1]))]
            }
            HighlightHandle::Split => {
                let (middle, [x, _]) = self.places(rect)?;
                let way = f64::from((-(at - middle).dot(x) - NEAR) / SPLIT);
                vec![set(&layer.split, way.clamp(0.0, 1.0))]
            }
            HighlightHandle::Size => {
                let (middle, [x, y]) = self.places(rect)?;
                let way = (at - middle).dot((x - y).normalized());
                let radius = (f64::from((way - NEAR) / SIZE).clamp(0.0, 1.0) * 1e4).round() / 1e4;
                layer.values_of(layer.edge()?.moved_to(radius))
            }
        };
        let edit = match held.handle {
            HighlightHandle::Size => session.keys().set_together(&values),
            _ => session.keys().set_all_at(values),
        };
        Some(Command::EditHeld(Id::unique(("highlight", held.handle.name())), edit))
    }

    /// Distances that move the highlight to the surface at a point of the screen.
    fn moved_to(&self, rect: Rect, at: Pos2) -> Option<[f64; 2]> {
        let (surface, made) = (self.surface.as_ref()?, self.made.as_ref()?);
        let pixel = surface.nearest(place_in(rect, at))?;
        let normal = self.normals.get(pixel)?.as_dvec3();
        let [x, y, z] = half_axes(surface, &LightPlace::of(&made.light), pixel);
        let toward = normal.dot(z);
        (toward > LEAST_COSINE).then(|| [normal.dot(x) / toward, normal.dot(y) / toward])
    }

    /// Draws the handles; `marked` is dragged or under the pointer.
    pub(super) fn paint(&self, ui: &Ui, rect: Rect, marked: Option<&HeldHighlight>, is_near: bool) {
        let Some((middle, [x, _])) = self.places(rect) else { return };
        let painter = ui.painter_at(rect);
        let strength = if is_near || marked.is_some() { 1.0 } else { 0.6 };
        let is_marked = |handle| marked.is_some_and(|held| held.handle == handle);
        let line = |width: f32, color: Color32| Stroke::new(width, color.gamma_multiply(strength));
        let ring = if is_marked(HighlightHandle::Ring) { 2.5 } else { 1.3 };
        painter.circle_stroke(middle, RING, line(ring + 2.0, theme::HALO));
        painter.circle_stroke(middle, RING, line(ring, theme::SUN));
        let ends = [HighlightHandle::Split, HighlightHandle::Stretch];
        if let [Some(from), Some(to)] = ends.map(|handle| self.place(handle, rect)) {
            painter.line_segment([from, to], line(3.0, theme::HALO));
            painter.line_segment([from, to], line(1.2, theme::SUN));
        }
        for (handle, at) in self.handles(rect) {
            let is_held = is_marked(handle);
            let size = if is_held { 6.5 } else { 5.0 };
            let color = if is_held { Color32::WHITE } else { theme::SUN }.gamma_multiply(strength);
            let halo = theme::HALO.gamma_multiply(strength);
            match handle {
                HighlightHandle::Stretch => {
                    let square = |size: f32| Rect::from_center_size(at, Vec2::splat(2.0 * size));
                    painter.rect_filled(square(size + 1.5), 1.0, halo);
                    painter.rect_filled(square(size - 0.5), 1.0, color);
                }
                HighlightHandle::Split => {
                    let aside = x.rot90();
                    for way in [-1.0, 1.0] {
                        let place = at + way * 3.0 * x;
                        let ends = [place - size * aside, place + size * aside];
                        painter.line_segment(ends, Stroke::new(4.0, halo));
                        painter.line_segment(ends, Stroke::new(2.0, color));
                    }
                }
                HighlightHandle::Middle | HighlightHandle::Ring | HighlightHandle::Size => {
                    painter.circle_filled(at, size + 2.0, halo);
                    painter.circle_filled(at, size, color);
                }
            }
        }
        if let Some(held) = marked {
            self.label(&painter, rect, held.handle);
        }
    }

    /// Writes the value of a handle beside it.
    fn label(&self, painter: &eframe::egui::Painter, rect: Rect, handle: HighlightHandle) {
        let (Some(layer), Some(at)) = (self.layer(), self.place(handle, rect)) else { return };
        let text = match handle {
            HighlightHandle::Middle => {
                let [x, y] = layer.moved.each_ref().map(|it| values::number_text(it.value, 2));
                format!("{x}, {y}")
            }
            HighlightHandle::Ring => {
                format!("{}°", values::number_text(layer.turn.value.to_degrees(), 0))
            }
            HighlightHandle::Stretch => {
                tr!("Stretch {value}", value = values::number_text(layer.stretch.value, 2))
            }
            HighlightHandle::Size => {
                let edge = layer.edge().map_or(0.0, |edge| edge.at.to_degrees());
                format!("{}°", values::number_text(edge, 1))
            }
            HighlightHandle::Split => {
                tr!("Split {value}", value = values::number_text(layer.split.value, 2))
            }
        };
        let font = FontId::proportional(theme::SMALL_TEXT);
        let galley = painter.layout_no_wrap(text, font, Color32::WHITE);
        let place = Align2::LEFT_TOP.anchor_size(at + vec2(9.0, 7.0), galley.size());
        painter.rect_filled(place.expand2(vec2(4.0, 1.5)), 3.0, theme::PLATE);
        painter.galley(place.min, galley, Color32::WHITE);
    }

    /// Names the handles for screen readers, and moves the one that has the keyboard.
    pub(super) fn keyboard(&self, ui: &Ui, rect: Rect, session: &Session) -> Vec<Command> {
        let Some(name) = self.layer().map(|layer| layer.name.clone()) else { return Vec::new() };
        let mut out = Vec::new();
        for (handle, at) in self.handles(rect).collect::<Vec<_>>() {
            let label = handle.label(&name);
            let id = Id::unique("handle of a highlight").with((&name, handle.name()));
            let area = Rect::from_center_size(at, Vec2::splat(2.0 * REACH));
            let response = ui.interact(area, id, Sense::focusable_noninteractive());
            let value = self.setting(handle).map_or(0.0, |setting| setting.value);
            response.widget_info(|| WidgetInfo::slider(true, value, &label));
            handle::focus_ring(ui, &response, at, 6.0);
            let steps = if response.has_focus() { handle::arrows(ui, id) } else { Vec2::ZERO };
            if steps != Vec2::ZERO {
                let to = at + vec2(steps.x, -steps.y) * STEP;
                let lead = self.layer().map_or(0.0, |layer| layer.turn.at_key)
                    - self.turn_at(rect, at).unwrap_or_default();
                out.extend(self.drag(&HeldHighlight { handle, lead }, session, rect, to, false));
            }
        }
        out
    }

    /// Place of a handle on the screen by its label; for tests.
    pub(super) fn place_of(&self, label: &str, rect: Rect) -> Option<Pos2> {
        let handle = HighlightHandle::ALL.into_iter().find(|handle| handle.name() == label)?;
        self.place(handle, rect)
    }
}

/// Distance of the knob of a stretch from the middle, in points.
fn stretch_way(stretch: f64) -> f32 {
    NEAR - STRETCH * (1.0 - stretch.clamp(STRETCHED[0], STRETCHED[1])).ln() as f32
}

/// Distance of the knob of a split from the middle, in points.
fn split_way(split: f64) -> f32 {
    NEAR + SPLIT * split.clamp(0.0, 1.0) as f32
}

/// Axes around the half-vector of a pixel, and that itself: right, upright, toward.
fn half_axes(surface: &Surface, light: &LightPlace, pixel: usize) -> [DVec3; 3] {
    let toward = light.at(surface.positions[pixel]) + surface.toward_viewer(pixel);
    axes_around(toward.as_dvec3().normalize_or(DVec3::Z))
}

/// Unit axes to the right and upright around a direction, and that itself, as the node *Axes
/// around a direction* has them.
fn axes_around(toward: DVec3) -> [DVec3; 3] {
    let across = DVec3::Y.cross(toward);
    let x = match across.length_squared() > 1e-8 {
        true => across.normalize(),
        false => DVec3::X.cross(toward).normalize_or(DVec3::X),
    };
    [x, toward.cross(x), toward]
}

/// Normals of a surface, averaged over a small window; 0 where there is no surface.
fn averaged(surface: &Surface) -> Vec<Vec3> {
    let [width, height] = surface.size;
    let along = |of: &[Vec3], step: usize, count: usize, at: usize, index: usize| {
        let (back, ahead) = (WINDOW.min(at), WINDOW.min(count - 1 - at));
        (0..=back + ahead).map(|k| of[index - back * step + k * step]).sum::<Vec3>()
    };
    let index = |pixel: usize| (pixel % width, pixel / width);
    let rows: Vec<Vec3> = (0..surface.normals.len())
        .map(|pixel| along(&surface.normals, 1, width, index(pixel).0, pixel))
        .collect();
    let sums = (0..rows.len()).map(|pixel| along(&rows, width, height, index(pixel).1, pixel));
    let is_covered = |pixel: usize| surface.is_covered(pixel);
    sums.enumerate()
        .map(
            |(pixel, sum)| {
                if is_covered(pixel) { sum.normalize_or(Vec3::ZERO) } else { Vec3::ZERO }
            },
        )
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_those_of_the_node() {
        for toward in [DVec3::Z, DVec3::new(0.4, 0.3, 0.6).normalize(), DVec3::NEG_X] {
            let [x, y, z] = axes_around(toward);
            assert!(x.dot(y).abs() + y.dot(z).abs() + z.dot(x).abs() < 1e-12, "{toward}");
            assert!(x.cross(y).dot(z) > 1.0 - 1e-12 && y.y >= 0.0, "{toward}: upright");
        }
        assert_eq!(axes_around(DVec3::Z)[..2], [DVec3::X, DVec3::Y]);
        assert!(axes_around(DVec3::Y).iter().all(|axis| axis.is_finite()));
    }

    #[test]
    fn knobs_stand_where_a_drag_puts_them() {
        for stretch in [-0.5, 0.0, 0.4, 0.95] {
            let way = f64::from((stretch_way(stretch) - NEAR) / STRETCH);
            assert!((1.0 - (-way).exp() - stretch).abs() < 1e-6, "{stretch}");
        }
        for split in [0.0, 0.3, 1.0] {
            assert!((f64::from((split_way(split) - NEAR) / SPLIT) - split).abs() < 1e-6);
        }
        assert!(stretch_way(f64::NEG_INFINITY) > 4.0 && stretch_way(1.0).is_finite());
    }
}
