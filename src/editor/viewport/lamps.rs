//! Handles of lamps: the place of every point and spot light, and of each directional light that is
//! aimed at an object from there; for the light at hand a spot's aim, the rims of its cones, and
//! the distances at which a lamp fades and ends.
//!
//! A place and an aim are dragged across the picture, at their depth. Cones are drawn on a ball
//! around the lamp, so that they may be as wide as they like; distances as circles that face the
//! eye.

use std::f64::consts::{PI, TAU};

use chiaro_locale::tr;
use eframe::egui::{Color32, Id, Pos2, Rect, Shape, Stroke, Ui};
use glam::DVec3;

use super::lights::{aim_place, paint_middle, resolved};
use super::project;
use crate::commands::Command;
use crate::compile::LightValues;
use crate::document::{Light, LightField, LightKind, Value};
use crate::fields::layer;
use crate::fields::lighting::set_light_at;
use crate::ids::LightId;
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;
use crate::widgets::theme;

/// Distance within which a handle is hit, in points.
const REACH: f32 = 8.0;
/// Length of a spot's axis, in radii of the scene.
const AXIS: f64 = 0.6;
/// Number of points along a rim.
const POINTS: u32 = 48;
/// Least distance and angle that a drag sets.
const LEAST: f64 = 1e-3;

/// Handle of a lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum LampHandle {
    Place,
    Aim,
    /// The rim of a cone.
    Cone(LightField),
    /// The circle of a distance.
    Distance(LightField),
}

impl LampHandle {
    /// Name of the handle, without its light.
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Place => tr!("lamp" => "Place"),
            Self::Aim => tr!("Aim"),
            Self::Cone(LightField::Inner) => tr!("Full cone"),
            Self::Cone(_) => tr!("Whole cone"),
            Self::Distance(LightField::HalfDistance) => tr!("Half distance"),
            Self::Distance(_) => tr!("lamp" => "Range"),
        }
    }

    /// Hint on the drag.
    pub(super) fn hint(self, name: &str) -> String {
        match self {
            Self::Place => tr!("Drag to move the lamp {name} across the picture"),
            Self::Aim => tr!("Drag to aim the spot {name}"),
            Self::Cone(LightField::Inner) => {
                tr!("Drag the full cone of {name}: within it the light is whole")
            }
            Self::Cone(_) => tr!("Drag the whole cone of {name}: beyond it nothing is left"),
            Self::Distance(LightField::HalfDistance) => {
                tr!("Drag where half of {name} is left")
            }
            Self::Distance(_) => tr!("Drag where nothing of {name} is left"),
        }
    }
}

/// A lamp as it stands in the scene.
struct LampInScene<'a> {
    light: &'a Light,
    values: LightValues,
    /// Length of the axis, in scene units.
    length: f64,
}

impl<'a> LampInScene<'a> {
    fn of(light: &'a Light, session: &Session) -> Option<Self> {
        let (_, radius) = sphere_of_lights(session.open_scene());
        let values = resolved(light, session);
        // A directional light has a place where that says whence it shines at an object.
        let has_place = light.kind != LightKind::Directional || aim_place(light, session).is_some();
        has_place.then_some(Self { light, values, length: AXIS * radius })
    }

    fn aim_end(&self) -> DVec3 {
        self.values.position() + self.values.aim() * self.length
    }

    /// Points of a handle that is a line, in world space.
    fn rim(&self, handle: LampHandle, session: &Session) -> Vec<DVec3> {
        let center = self.values.position();
        let around = |along: DVec3, across: DVec3, up: DVec3| {
            (0..=POINTS).map(move |index| {
                let (sin, cos) = (f64::from(index) * TAU / f64::from(POINTS)).sin_cos();
                center + along + across * cos + up * sin
            })
        };
        match handle {
            LampHandle::Place | LampHandle::Aim => Vec::new(),
            LampHandle::Cone(field) => {
                let (sin, cos) = number(field, self.light).clamp(0.0, PI).sin_cos();
                let aim = self.values.aim();
                let (across, up) = aim.any_orthonormal_pair();
                let [cos, sin] = [cos, sin].map(|part| part * self.length);
                around(aim * cos, across * sin, up * sin).collect()
            }
            LampHandle::Distance(field) => {
                let (right, up) = session.view.orbit.right_and_up();
                let radius = number(field, self.light);
                around(DVec3::ZERO, right * radius, up * radius).collect()
            }
        }
    }

    /// Lines of the selected lamp.
    fn lines(&self) -> Vec<LampHandle> {
        let mut lines = Vec::new();
        if self.light.kind == LightKind::Directional {
            return lines;
        }
        if self.light.kind == LightKind::Spot {
            lines.extend([LightField::Outer, LightField::Inner].map(LampHandle::Cone));
        }
        let distances = [LightField::Range, LightField::HalfDistance].into_iter();
        let set = distances.filter(|field| number(*field, self.light) > 0.0);
        lines.extend(set.map(LampHandle::Distance));
        lines
    }
}

fn number(field: LightField, light: &Light) -> f64 {
    field.numbers(light).first().copied().unwrap_or_default()
}

/// Lamps that shine, and whether each is selected.
fn lamps(session: &Session) -> impl Iterator<Item = (&LightId, LampInScene<'_>, bool)> {
    let selected = layer::light_at_hand(session);
    session.keys().shining().filter_map(move |(id, light)| {
        let is_selected = selected.as_ref() == Some(id);
        Some((id, LampInScene::of(light, session)?, is_selected))
    })
}

/// Handles of a light that stands in the scene, with their places on the screen; those of lines and
/// the aim only while the light is at hand.
pub(super) fn places(session: &Session, id: &LightId, rect: Rect) -> Vec<(LampHandle, Pos2)> {
    let Some(lamp) = session.keys().light(id).and_then(|light| LampInScene::of(light, session))
    else {
        return Vec::new();
    };
    let mut found = vec![(LampHandle::Place, Some(lamp.values.position()))];
    if layer::light_at_hand(session).as_ref() == Some(id) {
        if lamp.light.kind == LightKind::Spot {
            found.push((LampHandle::Aim, Some(lamp.aim_end())));
        }
        let lines = lamp.lines().into_iter();
        found.extend(lines.map(|handle| (handle, lamp.rim(handle, session).first().copied())));
    }
    let on_screen = |(handle, point): (LampHandle, Option<DVec3>)| {
        Some((handle, project(point?, rect, session)?))
    };
    found.into_iter().filter_map(on_screen).collect()
}

/// Handle under the pointer.
pub(super) fn hit(session: &Session, rect: Rect, at: Pos2) -> Option<(LightId, LampHandle)> {
    let near =
        |point: DVec3| project(point, rect, session).is_some_and(|p| p.distance(at) <= REACH);
    let all: Vec<_> = lamps(session).collect();
    for (id, lamp, is_selected) in &all {
        if near(lamp.values.position()) {
            return Some(((*id).clone(), LampHandle::Place));
        }
        if *is_selected && lamp.light.kind == LightKind::Spot && near(lamp.aim_end()) {
            return Some(((*id).clone(), LampHandle::Aim));
        }
    }
    let (id, lamp, _) = all.iter().find(|(.., is_selected)| *is_selected)?;
    let distance = |handle: &LampHandle| {
        let points: Vec<Pos2> = on_screen(&lamp.rim(*handle, session), rect, session);
        let pairs = points.windows(2).map(|pair| distance_to(pair[0], pair[1], at));
        pairs.fold(f32::INFINITY, f32::min)
    };
    let lines = lamp.lines().into_iter().map(|handle| (distance(&handle), handle));
    let nearest = lines.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|found| found.0 <= REACH)?;
    Some(((*id).clone(), nearest.1))
}

fn on_screen(points: &[DVec3], rect: Rect, session: &Session) -> Vec<Pos2> {
    points.iter().filter_map(|point| project(*point, rect, session)).collect()
}

fn distance_to(a: Pos2, b: Pos2, at: Pos2) -> f32 {
    let along = b - a;
    let t = (at - a).dot(along) / along.length_sq().max(1e-6);
    at.distance(a + along * t.clamp(0.0, 1.0))
}

/// Moves a handle to a point of the screen.
pub(super) fn drag(
    id: &LightId,
    handle: LampHandle,
    session: &Session,
    rect: Rect,
    at: Pos2,
) -> Option<Command> {
    let lamp = LampInScene::of(session.keys().light(id)?, session)?;
    let values = &lamp.values;
    let offset = (at - rect.center()) / rect.height();
    let orbit = &session.view.orbit;
    let (origin, ray) = orbit.ray_through([f64::from(offset.x), f64::from(-offset.y)]);
    // The point under the pointer at the depth of another.
    let beside = |point: DVec3| {
        let depth = orbit.direction();
        let along = (point - origin).dot(depth) / ray.dot(depth);
        (along.is_finite() && along > 0.0).then(|| origin + ray * along)
    };
    let short = |v: DVec3| v.to_array().map(|x| (x * 1e4).round() / 1e4 + 0.0).to_vec();
    let (field, value) = match handle {
        LampHandle::Place => {
            let place = values.own_from_world * (beside(values.position())? - values.own_origin);
            (LightField::Position, Value::Vector(short(place)))
        }
        LampHandle::Aim => {
            let aim = (beside(lamp.aim_end())? - values.position()).try_normalize()?;
            (LightField::Aim, Value::Vector(short(values.own_from_world * aim)))
        }
        LampHandle::Cone(field) => {
            let present = number(field, lamp.light);
            let angle = angle_on_ball(&lamp, (origin, ray), present);
            let [least, most] = match field {
                LightField::Inner => [0.0, lamp.light.outer],
                _ => [lamp.light.inner.max(LEAST), PI],
            };
            (field, Value::Number(rounded(angle).clamp(least, most.max(least))))
        }
        LampHandle::Distance(field) => {
            let radius = beside(values.position())?.distance(values.position());
            (field, Value::Number(rounded(radius).max(LEAST)))
        }
    };
    (field.get(lamp.light) != value).then(|| {
        set_light_at(session, id, field.name(), value).held(Id::unique("lamp in the picture"))
    })
}

fn rounded(x: f64) -> f64 {
    (x * 1e4).round() / 1e4
}

/// Angle from a spot's axis at which a ray meets the ball that cones are drawn on: of both sides
/// the one that is nearer to the present angle.
fn angle_on_ball(lamp: &LampInScene<'_>, (origin, ray): (DVec3, DVec3), present: f64) -> f64 {
    let center = lamp.values.position();
    let along = (center - origin).dot(ray);
    let nearest = origin + ray * along;
    let half = (lamp.length * lamp.length - nearest.distance_squared(center)).max(0.0).sqrt();
    let angles = [-half, half].map(|step| {
        let way = (nearest + ray * step - center).try_normalize().unwrap_or(DVec3::Z);
        way.angle_between(lamp.values.aim())
    });
    let [a, b] = angles;
    if (a - present).abs() <= (b - present).abs() { a } else { b }
}

/// Draws the lamps, and the lines of the selected one.
pub(super) fn paint(ui: &Ui, rect: Rect, session: &Session, held: Option<(&LightId, LampHandle)>) {
    let painter = ui.painter_at(rect);
    for (id, lamp, is_selected) in lamps(session) {
        let held = held.filter(|(held, _)| *held == id).map(|(_, handle)| handle);
        let [r, g, b] = lamp.light.color.map(|c| (c.clamp(0.0, 1.0) * 255.0) as u8);
        let color = Color32::from_rgb(r, g, b);
        let Some(at) = project(lamp.values.position(), rect, session) else { continue };
        if is_selected || held.is_some() {
            for handle in lamp.lines() {
                let points = on_screen(&lamp.rim(handle, session), rect, session);
                let strength = if held == Some(handle) { 1.0 } else { 0.7 };
                let is_soft = matches!(
                    handle,
                    LampHandle::Cone(LightField::Inner)
                        | LampHandle::Distance(LightField::HalfDistance)
                );
                let color = color.gamma_multiply(strength);
                let halo = theme::HALO.gamma_multiply(strength);
                painter.add(Shape::line(points.clone(), Stroke::new(3.5, halo)));
                if is_soft {
                    painter.extend(Shape::dashed_line(&points, Stroke::new(1.5, color), 5.0, 4.0));
                } else {
                    painter.add(Shape::line(points, Stroke::new(1.5, color)));
                }
            }
        }
        if lamp.light.kind == LightKind::Directional
            && let Some(aim) = aim_place(lamp.light, session)
            && let Some(to) = project(aim, rect, session)
        {
            let line = Shape::dashed_line(&[at, to], Stroke::new(1.5, color), 5.0, 4.0);
            painter.line_segment([at, to], Stroke::new(3.5, theme::HALO.gamma_multiply(0.7)));
            painter.extend(line);
        }
        if lamp.light.kind == LightKind::Spot
            && let Some(to) = project(lamp.aim_end(), rect, session)
        {
            let strength = if is_selected { 1.0 } else { 0.5 };
            let halo = theme::HALO.gamma_multiply(strength);
            painter.line_segment([at, to], Stroke::new(4.0, halo));
            painter.line_segment([at, to], Stroke::new(1.8, color.gamma_multiply(strength)));
            if is_selected {
                let is_held = held == Some(LampHandle::Aim);
                painter.circle_filled(to, if is_held { 8.0 } else { 6.0 }, theme::HALO);
                painter.circle_filled(to, if is_held { 6.5 } else { 4.5 }, color);
            }
        }
        paint_middle(ui, rect, at, held == Some(LampHandle::Place));
    }
}
