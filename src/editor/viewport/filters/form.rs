//! Forms of filters in the world: lines that show them, and the handles on these.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use chiaro_locale::{Text, text, tr};
use glam::{DMat3, DVec3};

use super::super::lights::resolved;
use super::grip::{Grip, GripDrag};
use crate::document::LightKind;
use crate::fields::filter::{FilterKind, SelectedFilter};
use crate::fields::lighting::light_in_view;
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;

/// Number of points along a circle.
const POINTS: u32 = 48;
/// Distance from a lamp at which flaps and thrown pictures are drawn, in radii of the scene.
const AWAY: f64 = 0.6;
/// Place of the handle that turns a shape, in half sizes along its first axis.
const TURN: f64 = 1.5;
/// Greatest angle of flaps and of thrown pictures, in radians.
const MOST_FLAP: f64 = FRAC_PI_2;
const MOST_PICTURE: f64 = PI / 2.1;

/// Line in the world; dashed where the second is true.
type FilterLine = (Vec<DVec3>, bool);

/// Lines and handles of a filter.
#[derive(Default)]
pub(super) struct FilterForm {
    pub(super) lines: Vec<FilterLine>,
    pub(super) grips: Vec<Grip>,
    /// Width of the picture, in heights.
    aspect: f64,
}

/// A lamp that filters stand before.
struct LampPlace {
    kind: LightKind,
    place: DVec3,
    /// Direction in which a spot shines; unit.
    aim: DVec3,
    /// Direction toward a directional light; unit.
    direction: DVec3,
}

/// Axes of a shape whose z axis points along `toward`, turned around it by `spin`, in radians: as
/// `axes_turned` of the shaders has them.
fn axes(toward: DVec3, spin: f64) -> DMat3 {
    let z = toward.try_normalize().unwrap_or(DVec3::Z);
    let leaning = DVec3::Y.cross(z);
    let aside = if z.x.abs() > 0.7 { DVec3::Z } else { DVec3::X };
    let across = if leaning.length_squared() > 1e-8 { leaning } else { aside.cross(z) };
    let x = (across - z * across.dot(z)).try_normalize().unwrap_or(DVec3::X);
    let y = z.cross(x);
    let (sin, cos) = spin.sin_cos();
    DMat3::from_cols(x * cos + y * sin, y * cos - x * sin, z)
}

fn circle(center: DVec3, across: DVec3, up: DVec3) -> Vec<DVec3> {
    let at = |index: u32| (f64::from(index) * TAU / f64::from(POINTS)).sin_cos();
    (0..=POINTS).map(at).map(|(sin, cos)| center + across * cos + up * sin).collect()
}

fn quad(center: DVec3, across: DVec3, up: DVec3) -> Vec<DVec3> {
    [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)]
        .map(|(x, y)| center + across * x + up * y)
        .to_vec()
}

impl FilterForm {
    /// Form of the selected filter; `None` where it has none, as before a light that it does
    /// nothing to.
    /// `aspect` is the width of the picture over its height.
    pub(super) fn of(filter: &SelectedFilter<'_>, session: &Session, aspect: f32) -> Option<Self> {
        let mut form = Self { aspect: aspect.into(), ..Self::default() };
        match filter.kind {
            FilterKind::Blocker | FilterKind::Rod => form.shape(filter),
            _ => {
                let light = filter.light.as_ref()?;
                let light = light_in_view(session, light)?;
                let values = resolved(light, session);
                let lamp = LampPlace {
                    kind: light.kind,
                    place: values.position(),
                    aim: values.aim(),
                    direction: values.direction(),
                };
                let (_, radius) = sphere_of_lights(session.open_scene());
                form.at_lamp(filter, &lamp, session, AWAY * radius);
            }
        }
        // What comes by a wire cannot be dragged.
        form.grips.retain(|grip| !filter.is_wired(grip.port));
        (!form.lines.is_empty()).then_some(form)
    }

    fn grip(
        &mut self,
        (name, port, help): (Text, &'static str, &'static str),
        at: DVec3,
        value: f64,
        drag: GripDrag,
    ) {
        self.grips.push(Grip { name, port, help, at, value, drag });
    }

    /// A ball, a box, a capsule or a card that stands somewhere.
    fn shape(&mut self, filter: &SelectedFilter<'_>) {
        let (center, toward) = (filter.vector("center"), filter.vector("toward"));
        let spin = filter.number("spin");
        let size = filter.vector("size").abs().max(DVec3::splat(1e-4));
        let turned = axes(toward, spin);
        let shape = match filter.kind {
            FilterKind::Rod if filter.number("roundness") < 0.5 => "box",
            FilterKind::Rod => "ball",
            _ => filter.word("shape"),
        };
        let [x, y, z] = [turned.x_axis, turned.y_axis, turned.z_axis];
        let (wide, high, deep) = (x * size.x, y * size.y, z * size.z);
        let mut sides = vec![0, 1, 2];
        match shape {
            "box" => {
                for side in [-1.0, 1.0] {
                    self.lines.push((quad(center + deep * side, wide, high), false));
                }
                for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                    let edge = center + wide * a + high * b;
                    self.lines.push((vec![edge - deep, edge + deep], false));
                }
            }
            "capsule" => {
                let round = size.x;
                for side in [-1.0, 1.0] {
                    let end = center + deep * side;
                    self.lines.push((circle(end, x * round, y * round), false));
                    self.lines.push((circle(end, x * round, z * round), false));
                }
                for across in [x, -x, y, -y] {
                    let edge = center + across * round;
                    self.lines.push((vec![edge - deep, edge + deep], false));
                }
                sides = vec![0, 2];
            }
            "card" => {
                self.lines.push((quad(center, wide, high), false));
                sides = vec![0, 1];
            }
            _ => {
                for (across, up) in [(wide, high), (high, deep), (deep, wide)] {
                    self.lines.push((circle(center, across, up), false));
                }
            }
        }
        let end = center + z * (2.0 * size.z).max(1.2 * size.max_element());
        self.lines.push((vec![center, end], true));
        let names = match shape {
            "capsule" => [text!("Radius"), text!("Radius"), text!("Length")],
            _ => [text!("Width"), text!("Height"), text!("Depth")],
        };
        for index in sides {
            let name = names[index];
            let axis = [x, y, z][index];
            let sizes = size.to_array().to_vec();
            let drag = GripDrag::Size { center, axis, sizes, index };
            let at = center + axis * size[index];
            self.grip((name, "size", tr!("drag to size it")), at, size[index], drag);
        }
        let help = tr!("drag to point it another way");
        self.grip((text!("Axis"), "toward", help), end, toward.x, GripDrag::Toward { center });
        self.spin(center, axes(toward, 0.0), spin, TURN * size.x);
        // Over the others, which it hides where they point to the eye.
        self.grip(
            (text!("Center"), "center", tr!("drag to move it")),
            center,
            center.x,
            GripDrag::Place,
        );
    }

    /// The handle that turns around the axis, on a dashed line.
    fn spin(&mut self, center: DVec3, straight: DMat3, spin: f64, far: f64) {
        let (sin, cos) = spin.sin_cos();
        let at = center + (straight.x_axis * cos + straight.y_axis * sin) * far;
        self.lines.push((vec![center, at], true));
        let drag = GripDrag::Spin { center, axes: straight };
        self.grip((text!("Spin"), "spin", tr!("drag to turn it around its axis")), at, spin, drag);
    }

    /// Forms at a lamp: flaps, a thrown picture, distances.
    fn at_lamp(
        &mut self,
        filter: &SelectedFilter<'_>,
        lamp: &LampPlace,
        session: &Session,
        away: f64,
    ) {
        let is_sun = lamp.kind == LightKind::Directional;
        match filter.kind {
            FilterKind::Picture if is_sun => self.sun_picture(filter, lamp),
            _ if is_sun => {}
            FilterKind::BarnDoors => {
                let toward = self.toward(filter, lamp, away);
                self.doors(filter, lamp, toward, away);
            }
            FilterKind::Picture => {
                let toward = self.toward(filter, lamp, away);
                self.picture(filter, lamp, toward, away);
            }
            FilterKind::Decay => {
                let of = [(text!("Start"), "start", tr!("drag where it begins to weaken"), false)];
                self.distances(filter, lamp, session, &of);
            }
            FilterKind::DistanceRamp => {
                let of = [
                    (
                        text!("Near from"),
                        "near_from",
                        tr!("drag up to where nothing arrives"),
                        true,
                    ),
                    (text!("Near to"), "near_to", tr!("drag from where all of it arrives"), false),
                    (
                        text!("Far from"),
                        "far_from",
                        tr!("drag up to where all of it arrives"),
                        false,
                    ),
                    (text!("Far to"), "far_to", tr!("drag from where nothing arrives"), true),
                ];
                self.distances(filter, lamp, session, &of);
            }
            FilterKind::Blocker | FilterKind::Rod => {}
        }
    }

    /// Direction that a lamp's flaps or picture look to: the spot's own, or with a handle.
    fn toward(&mut self, filter: &SelectedFilter<'_>, lamp: &LampPlace, away: f64) -> DVec3 {
        if lamp.kind == LightKind::Spot {
            return lamp.aim;
        }
        let toward = filter.vector("toward").try_normalize().unwrap_or(DVec3::NEG_Y);
        let at = lamp.place + toward * away;
        self.lines.push((vec![lamp.place, at], true));
        let drag = GripDrag::Toward { center: lamp.place };
        self.grip(
            (text!("Axis"), "toward", tr!("drag to point it another way")),
            at,
            toward.x,
            drag,
        );
        toward
    }

    fn doors(&mut self, filter: &SelectedFilter<'_>, lamp: &LampPlace, toward: DVec3, away: f64) {
        let spin = filter.number("spin");
        let turned = axes(toward, spin);
        let [x, y, z] = [turned.x_axis, turned.y_axis, turned.z_axis];
        let angle = |port: &str| filter.number(port).clamp(0.0, 1.5);
        let reach = |port: &str| away * angle(port).tan();
        let [left, right, top, bottom] = ["left", "right", "top", "bottom"].map(reach);
        let middle = lamp.place + z * away;
        let corners = [(left, top), (-right, top), (-right, -bottom), (left, -bottom), (left, top)];
        let corners = corners.map(|(across, up)| middle + x * across + y * up);
        for corner in &corners[..4] {
            self.lines.push((vec![lamp.place, *corner], true));
        }
        self.lines.push((corners.to_vec(), false));
        // For who looks along z, x is to the left.
        let flaps = [
            (text!("Left flap"), "left", x, (top - bottom) / 2.0 * y),
            (text!("Right flap"), "right", -x, (top - bottom) / 2.0 * y),
            (text!("Top flap"), "top", y, (left - right) / 2.0 * x),
            (text!("Bottom flap"), "bottom", -y, (left - right) / 2.0 * x),
        ];
        for (name, port, side, aside) in flaps {
            let at = middle + side * reach(port) + aside;
            let drag = GripDrag::Angle { center: lamp.place, axis: z, side, most: MOST_FLAP };
            self.grip((name, port, tr!("drag to open or close it")), at, angle(port), drag);
        }
        // Well beside the left flap, which has a handle on the same line.
        self.spin(middle, axes(toward, 0.0), spin, left + 0.25 * away);
    }

    fn picture(&mut self, filter: &SelectedFilter<'_>, lamp: &LampPlace, toward: DVec3, away: f64) {
        let (spin, angle) = (filter.number("spin"), filter.number("angle").clamp(0.001, 1.5));
        let turned = axes(toward, spin);
        let half = away * angle.tan();
        let middle = lamp.place + turned.z_axis * away;
        let (across, up) = (turned.x_axis * half, turned.y_axis * half);
        self.lines.push((quad(middle, across, up), false));
        for corner in &quad(middle, across, up)[..4] {
            self.lines.push((vec![lamp.place, *corner], true));
        }
        let (axis, side) = (turned.z_axis, turned.y_axis);
        let drag = GripDrag::Angle { center: lamp.place, axis, side, most: MOST_PICTURE };
        self.grip(
            (text!("Angle"), "angle", tr!("drag to size the picture")),
            middle + up,
            angle,
            drag,
        );
        self.spin(middle, axes(toward, 0.0), spin, 1.3 * half);
    }

    /// The picture that a directional light throws.
    fn sun_picture(&mut self, filter: &SelectedFilter<'_>, lamp: &LampPlace) {
        let (center, size) = (filter.vector("center"), filter.number("size").abs().max(1e-4));
        let spin = filter.number("spin");
        let toward = -lamp.direction;
        let turned = axes(toward, spin);
        let (across, up) = (turned.x_axis * size, turned.y_axis * size);
        self.lines.push((quad(center, across, up), false));
        self.lines.push((vec![center, center + lamp.direction * size], true));
        let drag = GripDrag::Size { center, axis: turned.y_axis, sizes: vec![size], index: 0 };
        self.grip(
            (text!("Size"), "size", tr!("drag to size the picture")),
            center + up,
            size,
            drag,
        );
        self.spin(center, axes(toward, 0.0), spin, 1.3 * size);
        self.grip(
            (text!("Center"), "center", tr!("drag to move it")),
            center,
            center.x,
            GripDrag::Place,
        );
    }

    /// Circles around the lamp that face the eye, with a handle each.
    fn distances(
        &mut self,
        filter: &SelectedFilter<'_>,
        lamp: &LampPlace,
        session: &Session,
        of: &[(Text, &'static str, &'static str, bool)],
    ) {
        let (right, up) = session.view.orbit.right_and_up();
        for (index, &(name, port, help, is_soft)) in of.iter().enumerate() {
            let radius = filter.number(port).max(0.0);
            self.lines.push((circle(lamp.place, right * radius, up * radius), is_soft));
            // The handle stands where the circle is seen, and those of circles of one size beside
            // each other.
            let around = |step: u32| {
                let angle = f64::from(index as u32) * 0.35 - 0.5 + f64::from(step) * TAU / 24.0;
                let (sin, cos) = angle.sin_cos();
                lamp.place + (right * cos + up * sin) * radius
            };
            let is_seen = |at: &DVec3| {
                let place = session.view.orbit.place_in_picture(*at);
                place.is_some_and(|[x, y]| x.abs() < 0.47 * self.aspect && y.abs() < 0.47)
            };
            let at = (0..24).map(around).find(is_seen).unwrap_or_else(|| around(0));
            let drag = GripDrag::Distance { center: lamp.place };
            self.grip((name, port, help), at, radius, drag);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_right_handed_and_turn_around_the_last() {
        for toward in [DVec3::Y, -DVec3::Y, DVec3::X, DVec3::new(0.3, -0.5, 0.8)] {
            let turned = axes(toward, 0.4);
            assert!((turned.determinant() - 1.0).abs() < 1e-12, "{toward}");
            assert!(turned.z_axis.distance(toward.normalize()) < 1e-12);
            let straight = axes(toward, 0.0);
            let angle = straight.x_axis.angle_between(turned.x_axis);
            assert!((angle - 0.4).abs() < 1e-9 && straight.y_axis.dot(turned.x_axis) > 0.0);
        }
    }
}
