//! Handles of the selected highlight layer on the object: its middle moves it, the ring turns it,
//! and knobs stretch it, split it along both axes, make it larger, draw out its corners, and notch
//! it like a star of so many rays.
//!
//! `middle` finds the place where the highlight is seen, and `frame` stands the other handles
//! around that on the screen, at the layer's own axes and as far out as the highlight is drawn. A
//! shape that the layer does not have is begun by a small handle, shown while the pointer is near.

mod frame;
mod handle;
mod middle;
mod paint;

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{Id, Pos2, Rect, Sense, Ui, Vec2, WidgetInfo, vec2};

use super::field::{LightPlace, light_values};
use super::place::place_in;
use super::surface::Surface;
use crate::commands::Command;
use crate::compile::LightValues;
use crate::document::{Target, Value};
use crate::fields::layer::{SelectedHighlight, Setting};
use crate::state::session::Session;
use crate::widgets::handle as focusable;
use frame::HandleFrame;
use handle::HighlightHandle;
use middle::{Middle, SmoothSurface, WantedMiddle};

/// Distance within which a handle is hit, in points.
const REACH: f32 = 8.0;
/// Distance of a handle from the border of the picture at least, in points: one that stands farther
/// out is drawn there.
const INSET: f32 = 12.0;
/// Way of an arrow key, in points.
const STEP: f32 = 4.0;

/// Handle that is dragged.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HeldHighlight {
    handle: HighlightHandle,
    /// Way from the pointer to the handle's own place when the drag began.
    grip: Vec2,
    /// Turn of the layer less that of the pointer when the drag of the ring began, in radians.
    lead: f64,
}

/// Inputs of the place: for the same inputs the known place is used.
#[derive(Clone, Debug, PartialEq)]
struct HighlightInputs {
    layer: SelectedHighlight,
    light: LightValues,
}

/// The widget and its state between frames.
#[derive(Default)]
pub(super) struct HighlightGizmo {
    made: Option<HighlightInputs>,
    surface: Option<SmoothSurface>,
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
        let inputs = HighlightInputs { layer, light };
        // The place of another layer says nothing of where people look for this one.
        let layer_before = self.layer().filter(|layer| layer.node == inputs.layer.node);
        let before = layer_before.and(self.middle.as_ref()).filter(|middle| middle.is_seen);
        let before = before.zip(self.surface.as_ref());
        let before = before.map(|(middle, smooth)| smooth.surface.place_of(middle.pixel));
        if !self.surface.as_ref().is_some_and(|known| Arc::ptr_eq(&known.surface, surface)) {
            self.surface = Some(SmoothSurface::new(surface.clone()));
            self.made = None;
        }
        if self.made.as_ref() == Some(&inputs) {
            return;
        }
        let wanted = WantedMiddle {
            light: &LightPlace::of(&inputs.light),
            moved: inputs.layer.moved.each_ref().map(|setting| setting.value),
            shape: &inputs.layer.drawn_shape(),
        };
        self.middle = self.surface.as_ref().and_then(|smooth| smooth.middle(wanted, before));
        self.made = Some(inputs);
    }

    /// Layer whose handles are shown.
    fn layer(&self) -> Option<&SelectedHighlight> {
        self.made.as_ref().map(|made| &made.layer)
    }

    /// True if the highlight is seen, so that all of its handles have a meaning.
    fn is_seen(&self) -> bool {
        self.middle.as_ref().is_some_and(|middle| middle.is_seen)
    }

    fn frame(&self, rect: Rect) -> Option<HandleFrame> {
        let (middle, layer) = (self.middle.as_ref()?, self.layer()?);
        let [x, y] = self.surface.as_ref()?.surface.place_of(middle.pixel);
        Some(HandleFrame {
            at: rect.min + vec2(x * rect.width(), y * rect.height()),
            upright: middle.axes,
            scale: middle.scale * rect.height(),
            height: rect.height(),
            shape: layer.drawn_shape(),
        })
    }

    /// Handles that can be dragged, with the places where they are drawn: within the picture.
    fn handles(&self, rect: Rect) -> Vec<(HighlightHandle, Pos2)> {
        let (Some(frame), Some(layer)) = (self.frame(rect), self.layer()) else {
            return Vec::new();
        };
        let is_there = |handle: &HighlightHandle| {
            handle.is_shown(layer) && (self.is_seen() || *handle == HighlightHandle::Middle)
        };
        let all = HighlightHandle::ALL.into_iter().filter(is_there);
        all.map(|handle| (handle, within(rect, frame.place(handle)))).collect()
    }

    /// Handle that a drag from a place of the screen would hold.
    fn held(&self, handle: HighlightHandle, rect: Rect, at: Pos2) -> Option<HeldHighlight> {
        let (frame, layer) = (self.frame(rect)?, self.layer()?);
        let grip = frame.place(handle) - at;
        let lead = layer.turn.at_key - frame.turn_at(at).unwrap_or_default();
        Some(HeldHighlight { handle, grip, lead })
    }

    /// Handle under the pointer.
    pub(super) fn hit(&self, rect: Rect, at: Pos2) -> Option<HeldHighlight> {
        let handles = self.handles(rect);
        let reached = handles.iter().map(|(handle, place)| (*handle, place.distance(at)));
        let knob = reached.filter(|(_, distance)| *distance <= REACH);
        let knob = knob.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(handle, _)| handle);
        let frame = self.frame(rect)?;
        let is_on_ring = (frame.at.distance(at) - frame.ring()).abs() <= 0.6 * REACH;
        let has_ring = handles.iter().any(|(handle, _)| *handle == HighlightHandle::Ring);
        let ring = Some(HighlightHandle::Ring).filter(|_| is_on_ring && has_ring);
        self.held(knob.or(ring)?, rect, at)
    }

    /// Hint on what a drag of a handle does.
    pub(super) fn hint(&self, held: &HeldHighlight) -> &'static str {
        match self.is_seen() {
            true => held.handle.hint(),
            false => tr!("The highlight is out of sight · drag to where it shall be seen"),
        }
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
        let (layer, frame) = (self.layer()?, self.frame(rect)?);
        let to = at + held.grip;
        let values = match held.handle {
            HighlightHandle::Middle => {
                let light = LightPlace::of(&self.made.as_ref()?.light);
                let [x, y] = self.surface.as_ref()?.moved_to(&light, place_in(rect, to))?;
                vec![set(&layer.moved[0], x), set(&layer.moved[1], y)]
            }
            HighlightHandle::Ring => {
                let turn = frame.turn_at(at)? + held.lead;
                let turn = (turn + PI).rem_euclid(TAU) - PI;
                let step = 15_f64.to_radians();
                vec![set(&layer.turn, if in_steps { (turn / step).round() * step } else { turn })]
            }
            HighlightHandle::Size => {
                let radius = rounded(frame.value_at(held.handle, to)?);
                layer.values_of(layer.edge()?.moved_to(radius))
            }
            handle => vec![set(handle.setting(layer)?, frame.value_at(handle, to)?)],
        };
        let edit = match held.handle {
            HighlightHandle::Size => session.keys().set_together(&values),
            _ => session.keys().set_all_at(values),
        };
        Some(Command::EditHeld(Id::unique(("highlight", held.handle.name())), edit))
    }

    /// Names the handles for screen readers, and moves the one that has the keyboard.
    pub(super) fn keyboard(&self, ui: &Ui, rect: Rect, session: &Session) -> Vec<Command> {
        let Some(layer) = self.layer() else { return Vec::new() };
        let mut out = Vec::new();
        let handles = self.handles(rect).into_iter();
        for (handle, at) in handles.filter(|(handle, _)| !handle.is_twin()) {
            let label = handle.label(&layer.name);
            let id = Id::unique("handle of a highlight").with((&layer.name, handle.name()));
            let area = Rect::from_center_size(at, Vec2::splat(2.0 * REACH));
            let response = ui.interact(area, id, Sense::focusable_noninteractive());
            let value = handle.setting(layer).map_or(0.0, |setting| setting.value);
            response.widget_info(|| WidgetInfo::slider(true, value, &label));
            focusable::focus_ring(ui, &response, at, 6.0);
            let steps = if response.has_focus() { focusable::arrows(ui, id) } else { Vec2::ZERO };
            if steps == Vec2::ZERO {
                continue;
            }
            let to = at + vec2(steps.x, -steps.y) * STEP;
            out.extend(match handle {
                // Rays come by one: a step of the pointer would be less than a ray.
                HighlightHandle::Rays => layer.rays.as_ref().map(|rays| {
                    let count = rays.at_key.round() + f64::from((steps.x + steps.y).signum());
                    let edit = session.keys().set_all_at([set(rays, count.clamp(2.0, 64.0))]);
                    Command::EditHeld(id, edit)
                }),
                _ => self
                    .held(handle, rect, at)
                    .and_then(|held| self.drag(&held, session, rect, to, false)),
            });
        }
        out
    }

    /// Place on the screen of a handle that is shown, by its label; for tests.
    pub(super) fn place_of(&self, label: &str, rect: Rect) -> Option<Pos2> {
        let mut handles = self.handles(rect).into_iter();
        handles.find(|(handle, _)| handle.name() == label).map(|(_, place)| place)
    }
}

/// Value of a setting that is dragged.
fn set(setting: &Setting<f64>, value: f64) -> (Target, Value) {
    (setting.target.clone(), Value::Number(rounded(value)))
}

fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

/// Place within the picture nearest to one that may lie beyond its border.
fn within(rect: Rect, place: Pos2) -> Pos2 {
    let inner = rect.shrink(INSET);
    if inner.is_positive() { inner.clamp(place) } else { place }
}
