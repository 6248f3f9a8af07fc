//! Looking through a light: the camera stands at the light and looks along its axis for a while,
//! and the light goes wherever the view is moved.
//!
//! The view that was before is kept, and comes back at the end. A directional light is looked
//! through in parallel lines, a spot through its whole cone.

use std::f64::consts::PI;

use chiaro_locale::tr;
use eframe::egui::Id;
use glam::DVec3;

use super::lights::{aim_place, resolved};
use crate::commands::Command;
use crate::compile::LightValues;
use crate::document::{Camera, Light, LightKind, LightSpace, Projection};
use crate::fields::layer;
use crate::fields::lighting::{OwnedLight, Owner, light_in_view, set_light_like};
use crate::ids::LightId;
use crate::state::orbit::Orbit;
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;

/// Distance of the eye from what a directional light lights, in radii of that.
const FAR: f64 = 3.0;
/// Share of the picture's height that the lit sphere takes for a directional light.
const SHARE: f64 = 0.8;
/// Decimals of numbers that are written.
const DECIMALS: f64 = 1e6;

/// A light that is looked through.
pub(super) struct LookThrough {
    id: LightId,
    /// View that comes back at the end.
    before: Orbit,
    /// View and light as of the last frame.
    view: Orbit,
    values: LightValues,
}

/// The light that would be looked through: the one at hand, or the first.
fn chosen(session: &Session) -> Option<LightId> {
    let of = |owner: Owner| owner.lights(session).and_then(|lights| lights.keys().next()).cloned();
    let first = || of(Owner::Look).or_else(|| of(Owner::Scene));
    layer::light_at_hand(session).or_else(first)
}

impl LookThrough {
    /// Begins to look through the selected light, and gives its view.
    ///
    /// # Errors
    /// The reason why there is none to look through, as a sentence without its end.
    pub(super) fn begin(session: &Session) -> Result<Self, String> {
        let none = || tr!("The look has no light to look through");
        let id = chosen(session).ok_or_else(none)?;
        let light = light_in_view(session, &id).ok_or_else(none)?;
        if light.space == LightSpace::Camera {
            return Err(tr!(
                "{light} goes along with the camera, so that it cannot be looked through",
                light = light.display_name(&id)
            ));
        }
        let before = session.view.orbit.clone();
        let values = resolved(light, session);
        let view = view_of(&values, light, &before, session);
        Ok(Self { id, before, view, values })
    }

    pub(super) fn view(&self) -> &Orbit {
        &self.view
    }

    /// The view from before, in the present illumination frame.
    pub(super) fn end(self, session: &Session) -> Orbit {
        Orbit { illumination: session.view.orbit.illumination, ..self.before }
    }

    /// Display name of the light.
    pub(super) fn name(&self, session: &Session) -> String {
        OwnedLight::lighting(session, &self.id)
            .map_or_else(|| self.id.to_string(), |light| light.full_name())
    }

    /// Lets the light follow the view where the user moved it, or the view the light where that was
    /// edited. Returns the edit of the light.
    pub(super) fn follow(&mut self, session: &Session, view: &mut Orbit) -> Option<Command> {
        let light = light_in_view(session, &self.id)?;
        let values = resolved(light, session);
        if place(view) != place(&self.view) {
            let new = light_from(view, &values, light, aim_place(light, session));
            self.view = view.clone();
            self.values = resolved(&new, session);
            let change = set_light_like(session, &self.id, &new)?;
            return Some(change.held(Id::unique("looking through a light")));
        }
        if values != self.values {
            *view = view_of(&values, light, view, session);
            self.view = view.clone();
            self.values = values;
        }
        None
    }
}

/// Numbers of a view that a light follows.
fn place(view: &Orbit) -> (f64, f64, f64, DVec3) {
    (view.yaw, view.pitch, view.distance, view.target)
}

/// The view through a light; all that a light does not say is as in `old`.
fn view_of(values: &LightValues, light: &Light, old: &Orbit, session: &Session) -> Orbit {
    let (center, radius) = sphere_of_lights(session.open_scene());
    let mut view = old.clone();
    let (eye, backward) = match light.kind {
        LightKind::Directional => {
            let backward = values.direction();
            view.projection = Projection::Orthographic;
            (center + backward * FAR * radius, backward)
        }
        LightKind::Point => {
            view.projection = Projection::Perspective;
            let backward = (values.position() - center).try_normalize().unwrap_or(DVec3::Z);
            (values.position(), backward)
        }
        LightKind::Spot => {
            view.projection = Projection::Perspective;
            view.fov = (2.0 * light.outer).clamp(Camera::FOV[0], Camera::FOV[1].min(0.8 * PI));
            (values.position(), -values.aim())
        }
    };
    view.distance = (eye - center).dot(backward).max(0.1 * radius);
    view.target = eye - backward * view.distance;
    if light.kind == LightKind::Directional {
        view.fov = 2.0 * (radius / SHARE / view.distance).atan();
    }
    let local = view.upright.inverse() * backward;
    view.pitch = local.y.clamp(-1.0, 1.0).asin();
    view.yaw = local.x.atan2(local.z).rem_euclid(2.0 * PI);
    view
}

/// The light that is looked through by a view.
fn light_from(view: &Orbit, values: &LightValues, light: &Light, aim: Option<DVec3>) -> Light {
    let written = |v: DVec3| v.to_array().map(|x| (x * DECIMALS).round() / DECIMALS + 0.0);
    let backward = view.direction();
    let mut new = light.clone();
    let from = |place: DVec3| written(values.own_from_world * (place - values.own_origin));
    if let Some(aim) = aim.filter(|_| light.kind == LightKind::Directional) {
        new.position = from(aim + backward * values.position().distance(aim));
        return new;
    }
    if light.kind == LightKind::Directional {
        new.direction = written(values.own_from_world * backward);
        return new;
    }
    let eye = view.target + backward * view.distance;
    new.position = from(eye);
    if light.kind == LightKind::Spot {
        new.aim = written(values.own_from_world * -backward);
    }
    new
}
