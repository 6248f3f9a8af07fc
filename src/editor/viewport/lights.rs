//! Lights on the object: needles that show their directions, and handles that are dragged.
//!
//! Directional lights have needles, unless they are muted or others are soloed; point and spot
//! lights have the handles of `lamps`. The light of the selected layer, of whichever kind, is
//! dragged by the middle of its lit part too.
//!
//! The middle of a light's lit part is dragged over the surface: the light turns so that the middle
//! is under the pointer. Beyond the outline the middle goes on behind the object. The end of a
//! needle is dragged around the object like a bead on a ball; a drag over the rim and back leads to
//! the other side. A needle that ends outside of the picture (`needle`) is drawn up to its edge, as
//! an arrow.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Color32, Id, Pos2, Rect, Stroke, Ui, vec2};
use glam::DVec3;

use super::field::direction_at;
use super::lamps::{self, LampHandle};
use super::needle::{self, CutEnd, Needle};
use super::surface::Surface;
use crate::commands::Command;
use crate::compile::LightValues;
use crate::document::{Light, LightKind, Value};
use crate::fields::lighting::{OwnedLight, set_light_at};
use crate::ids::LightId;
use crate::placing::Parametrization;
use crate::state::orbit::Orbit;
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;
use crate::widgets::theme;

/// Distance within which a handle is hit, in points.
const REACH: f32 = 8.0;

/// Handle by which a light is dragged.
#[derive(Clone, Debug, PartialEq)]
enum Grip {
    /// The middle of the light's lit part.
    Middle(Parametrization),
    /// The end of the light's needle: whether it is behind the object, whether the drag has left
    /// the ball, and where the end was held, if it lies outside of the picture.
    Needle { is_behind: bool, is_outside: bool, cut: Option<CutEnd> },
    /// A handle of a point or spot light, or of another that has a place.
    Lamp(LampHandle),
}

/// Light that is dragged.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HeldLight {
    pub(super) light: LightId,
    grip: Grip,
}

impl HeldLight {
    /// Drag of a light by the middle of its lit part.
    pub(super) fn by_middle(light: LightId, shading: Parametrization) -> Self {
        Self { light, grip: Grip::Middle(shading) }
    }

    /// Handle of a lamp that is held.
    pub(super) fn lamp(&self) -> Option<(&LightId, LampHandle)> {
        match self.grip {
            Grip::Lamp(handle) => Some((&self.light, handle)),
            _ => None,
        }
    }

    /// True for a drag by the middle of the lit part.
    pub(super) fn is_by_middle(&self) -> bool {
        matches!(self.grip, Grip::Middle(_))
    }

    /// True for a drag by the end of the needle.
    pub(super) fn is_by_needle(&self) -> bool {
        matches!(self.grip, Grip::Needle { .. })
    }

    /// Hint on the drag.
    pub(super) fn hint(&self, session: &Session) -> String {
        let name = OwnedLight::lighting(session, &self.light)
            .map_or_else(|| self.light.to_string(), |owned_light| owned_light.full_name());
        match &self.grip {
            Grip::Middle(shading) => turn_hint(*shading, &name),
            Grip::Lamp(handle) => handle.hint(&name),
            Grip::Needle { .. } => {
                let aimed_at =
                    session.keys().light(&self.light).and_then(|light| light.aimed_at.as_ref());
                if let Some(object) = aimed_at {
                    return tr!(
                        "Drag to move the light {name} around {object}, which it stays aimed at"
                    );
                }
                tr!("Drag to turn the light {name} around the object; over the rim and back, or a \
                     double-click, takes it to the other side")
            }
        }
    }
}

/// Hint on the drag of a light by the middle of its lit part.
fn turn_hint(shading: Parametrization, name: &str) -> String {
    if shading.mirrors() {
        tr!("Drag to turn the light {name}: its highlight follows the pointer, beyond the outline \
             it goes behind")
    } else {
        tr!("Drag to turn the light {name}: its bright middle follows the pointer, beyond the \
             outline it goes behind")
    }
}

/// Handle of a light on the screen, for who finds it by its name.
pub(super) struct NamedHandle {
    pub(super) name: String,
    pub(super) at: Pos2,
    pub(super) held: HeldLight,
}

/// Handles of the lights that shine: ends of needles, and what lamps have.
pub(super) fn named(session: &Session, rect: Rect) -> Vec<NamedHandle> {
    let full_name = |id: &LightId| {
        OwnedLight::lighting(session, id)
            .map_or_else(|| id.to_string(), |owned_light| owned_light.full_name())
    };
    let mut found = Vec::new();
    for (id, light) in session.keys().shining() {
        let name = full_name(id);
        if let Some(needle) = Needle::of(light, rect, session) {
            let (at, held) = (needle.to, by_needle(id, &needle));
            found.push(NamedHandle { name: tr!("Needle of {name}"), at, held });
        }
        for (handle, at) in lamps::places(session, id, rect) {
            let held = HeldLight { light: id.clone(), grip: Grip::Lamp(handle) };
            found.push(NamedHandle {
                name: tr!("{handle} of {light}", handle = handle.label(), light = name),
                at,
                held,
            });
        }
    }
    found.retain(|handle| rect.contains(handle.at));
    found
}

/// Place of the object that a light is aimed at, in world space.
pub(super) fn aim_place(light: &Light, session: &Session) -> Option<DVec3> {
    session.keys().light_frames().aims.get(light.aimed_at.as_ref()?).copied()
}

/// Values of a light at the present place of the camera.
pub(super) fn resolved(light: &Light, session: &Session) -> LightValues {
    LightValues::new(light, &session.keys().light_frames())
}

/// Light whose needle ends under the pointer, or whose lamp has a handle there.
pub(super) fn hit(session: &Session, rect: Rect, at: Pos2) -> Option<HeldLight> {
    let of_lamp = || {
        let (light, handle) = lamps::hit(session, rect, at)?;
        Some(HeldLight { light, grip: Grip::Lamp(handle) })
    };
    needle_at(session, rect, at).or_else(of_lamp)
}

/// Light whose needle ends under the pointer.
fn needle_at(session: &Session, rect: Rect, at: Pos2) -> Option<HeldLight> {
    let lights = session.keys().shining();
    let needles = lights.filter_map(|(id, light)| Some((id, Needle::of(light, rect, session)?)));
    let near = needles.map(|(id, needle)| (needle.to.distance(at), id, needle));
    let (_, id, needle) =
        near.filter(|(distance, ..)| *distance <= REACH).min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(by_needle(id, &needle))
}

/// Drag of a light by the end of its needle.
fn by_needle(id: &LightId, needle: &Needle) -> HeldLight {
    let Needle { is_behind, cut, .. } = *needle;
    let grip = Grip::Needle { is_behind, is_outside: false, cut };
    HeldLight { light: id.clone(), grip }
}

/// Turns the dragged light so that its handle is at a point of the screen.
pub(super) fn drag(
    held: &mut HeldLight,
    session: &Session,
    surface: Option<&Surface>,
    rect: Rect,
    at: Pos2,
) -> Option<Command> {
    let light = session.keys().light(&held.light)?;
    let values = resolved(light, session);
    let (toward, place) = match &mut held.grip {
        Grip::Lamp(handle) => return lamps::drag(&held.light, *handle, session, rect, at),
        Grip::Middle(shading) => at_surface(surface?, *shading, &values, rect, at)?,
        Grip::Needle { is_behind, is_outside, cut } => {
            let at = cut.map_or(at, |cut| cut.end_for(at));
            let (toward, is_on_ball) = on_ball(
                &session.view.orbit,
                sphere_of_lights(session.open_scene()),
                rect,
                at,
                *is_behind,
            );
            // A drag over the rim and back leads to the other side.
            if is_on_ball && *is_outside {
                *is_behind = !*is_behind;
            }
            *is_outside = !is_on_ball;
            (toward, DVec3::ZERO)
        }
    };
    shone_from(session, &held.light, &values, toward, place)
}

/// Takes a light whose needle is held to the other side of what it lights, where its needle ends at
/// the same place of the picture, or near it. `None` for other handles.
pub(super) fn turned_over(held: &HeldLight, session: &Session) -> Option<Command> {
    let Grip::Needle { .. } = held.grip else { return None };
    let values = resolved(session.keys().light(&held.light)?, session);
    let (toward, backward) = (values.direction(), session.view.orbit.direction());
    let mirrored = toward - 2.0 * toward.dot(backward) * backward;
    shone_from(session, &held.light, &values, mirrored, DVec3::ZERO)
}

/// Command that lets a light shine from a direction, in world space: turns it, or moves a lamp
/// around `place`, or a light that is aimed at an object around that.
fn shone_from(
    session: &Session,
    id: &LightId,
    values: &LightValues,
    toward: DVec3,
    place: DVec3,
) -> Option<Command> {
    let light = session.keys().light(id)?;
    let own = |place: DVec3| values.own_from_world * (place - values.own_origin);
    let short = |v: DVec3| v.to_array().map(|x| (x * 1e4).round() / 1e4 + 0.0);
    let (field, old, new) = match (light.kind, aim_place(light, session)) {
        // A light that is aimed at an object shines from its place, whatever its direction is.
        (LightKind::Directional, Some(aim)) => {
            let distance = values.position().distance(aim);
            let distance = if distance > 1e-6 { distance } else { 1.0 };
            ("position", light.position, short(own(aim + toward * distance)))
        }
        (LightKind::Directional, None) => {
            ("direction", light.direction, short(values.own_from_world * toward))
        }
        (LightKind::Point | LightKind::Spot, _) => {
            let distance = values.position().distance(place);
            ("position", light.position, short(own(place + toward * distance)))
        }
    };
    let set = || set_light_at(session, id, field, Value::Vector(new.to_vec()));
    (new != old).then(|| set().held(Id::unique("light on the object")))
}

/// Direction to a light whose middle is at a point of the screen, and the position on the surface
/// there.
fn at_surface(
    surface: &Surface,
    shading: Parametrization,
    light: &LightValues,
    rect: Rect,
    at: Pos2,
) -> Option<(DVec3, DVec3)> {
    let place = [(at.x - rect.min.x) / rect.width(), (at.y - rect.min.y) / rect.height()];
    let pixel = surface.nearest(place)?;
    let toward = direction_at(surface, pixel, shading, light);
    let position = surface.positions[pixel].as_dvec3();
    if surface.is_at(place)
        || matches!(shading, Parametrization::Specular | Parametrization::HalfVector)
    {
        return Some((toward, position));
    }
    // Beyond the outline the light goes on behind the object: a quarter turn per quarter of the
    // picture's height.
    let [x, y] = surface.place_of(pixel);
    let rim = rect.min + vec2(x * rect.width(), y * rect.height());
    let beyond = f64::from((at.distance(rim) / (rect.height() * 0.25)).min(1.0))
        * std::f64::consts::FRAC_PI_2;
    let back = match shading {
        Parametrization::ScreenAligned => light.own_from_world.transpose() * DVec3::Z,
        _ => surface.toward_viewer(pixel).as_dvec3(),
    };
    let aside = (toward - back * toward.dot(back)).try_normalize()?;
    // On a coarse grid the outline's last pixel may still face the viewer a little; the angle
    // behind is counted from there, and both together are a half turn.
    let start = toward.angle_between(back).min(std::f64::consts::FRAC_PI_2);
    let angle = start + beyond * (std::f64::consts::PI - start) / std::f64::consts::FRAC_PI_2;
    Some((back * angle.cos() + aside * angle.sin(), position))
}

/// Direction on the ball of the needles' ends at a point of the screen, and true if the ball is
/// there; otherwise the direction of the ball's rim.
fn on_ball(
    orbit: &Orbit,
    (center, radius): (DVec3, f64),
    rect: Rect,
    at: Pos2,
    is_behind: bool,
) -> (DVec3, bool) {
    let (right, _) = orbit.right_and_up();
    let backward = orbit.direction();
    let offset = (at - rect.center()) / rect.height();
    let (origin, ray) = orbit.ray_through([f64::from(offset.x), f64::from(-offset.y)]);
    // The ball is mapped to the origin, with radius 1.
    let origin = (origin - center) / radius;
    let along = -origin.dot(ray);
    let nearest = origin + ray * along;
    let half = needle::FAR * needle::FAR - nearest.length_squared();
    if half <= 0.0 {
        return (nearest.try_normalize().unwrap_or(right), false);
    }
    let half = if is_behind { half.sqrt() } else { -half.sqrt() };
    ((nearest + ray * half).try_normalize().unwrap_or(backward), true)
}

/// Shows the directions of the directional lights: a needle from outside the object toward each.
pub(super) fn paint_needles(
    ui: &Ui,
    rect: Rect,
    session: &Session,
    is_turning: bool,
    held: Option<&LightId>,
) {
    let painter = ui.painter_at(rect);
    for (id, light) in session.keys().shining() {
        let Some(needle) = Needle::of(light, rect, session) else { continue };
        let color = light.color.map(|c| (c.clamp(0.0, 1.0) * 255.0) as u8);
        let is_held = held == Some(id);
        let strength = if is_turning || is_held { 1.0 } else { 0.75 };
        let strength = strength * if needle.is_behind { 0.5 } else { 1.0 };
        let color = Color32::from_rgb(color[0], color[1], color[2]).gamma_multiply(strength);
        needle.paint(&painter, color, strength, is_held);
    }
}

/// Draws a sun at the middle of a light's lit part.
pub(super) fn paint_middle(ui: &Ui, rect: Rect, at: Pos2, is_held: bool) {
    let painter = ui.painter_at(rect);
    let color = if is_held { Color32::WHITE } else { theme::SUN };
    painter.circle_filled(at, 6.5, theme::HALO);
    painter.circle_filled(at, 4.0, color);
    for ray in 0..8 {
        let direction = egui::Vec2::angled(ray as f32 * std::f32::consts::FRAC_PI_4);
        painter.line_segment(
            [at + direction * 6.0, at + direction * 9.0],
            Stroke::new(3.0, theme::HALO),
        );
        painter.line_segment([at + direction * 6.0, at + direction * 9.0], Stroke::new(1.5, color));
    }
}

/// True if the sun at `middle` is under the pointer.
pub(super) fn is_at_middle(middle: Option<Pos2>, at: Pos2) -> bool {
    middle.is_some_and(|middle| middle.distance(at) <= REACH)
}
