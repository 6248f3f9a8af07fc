//! Hints on the actions possible at the pointer.

use chiaro_locale::tr;
use eframe::egui::{Pos2, Rect};

use super::{Drag, Handles, Viewport, is_on_object};
use crate::fields::layer;
use crate::state::session::Session;

impl Viewport {
    /// Hint on the actions possible at the pointer over the picture, or on the drag under way.
    pub(super) fn hint_at(
        &self,
        pointer: Option<Pos2>,
        rect: Rect,
        session: &Session,
        handles: &Handles,
        hovered: Option<&Drag>,
    ) -> String {
        match (self.drag.as_ref().or(hovered), pointer) {
            (Some(Drag::Curve(held)), _) => self.isocurves.hint(held),
            (Some(Drag::Light(held)), _) => held.hint(session),
            (Some(Drag::Highlight(held)), _) => self.highlight.hint(held).to_owned(),
            (Some(Drag::Lights), _) if !session.keys().has_turning_lights() => tr!(
                "A drag turns no light: none is in the illumination frame, all stay in the world, \
                 the camera or an object. Frame, in a light's fields, changes that"
            )
            .to_owned(),
            (Some(Drag::Lights), _) => tr!(
                "Turning the illumination frame: every light in it turns with it · Esc puts it \
                 back"
            )
            .to_owned(),
            (Some(Drag::Camera), _) => {
                tr!("Turning the camera around the object · Esc puts it back").to_owned()
            }
            (Some(Drag::Pan), _) => tr!("Moving the camera · Esc puts it back").to_owned(),
            (None, None) => String::new(),
            (None, Some(at)) if is_on_object(at, rect, session, handles) => {
                if layer::light_at_hand(session).is_some() {
                    tr!("Drag to turn all lights · Shift-drag turns the light at hand · Alt-drag \
                         turns the camera · wheel comes nearer · R resets")
                } else {
                    tr!("Drag to turn all lights · Alt-drag turns the camera · wheel comes nearer \
                         · R resets")
                }
                .to_owned()
            }
            (None, Some(_)) => tr!(
                "Drag to turn the camera · right-drag moves it · wheel comes nearer · R resets · F \
                 frames"
            )
            .to_owned(),
        }
    }
}
