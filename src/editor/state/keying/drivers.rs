//! Drivers of keys: numbers of the scene and wires of the look, with their present values and their
//! names.

use chiaro_locale::{Text, fill, text};

use super::KeyedLook;
use crate::compile::{CompileOptions, Live, compile};
use crate::document::{DirectionKeys, Driver, KeyDirection, OutputPort, Target};
use crate::frame::{Rig, Wires, driver_value};
use crate::ids::{NodePath, PortName};
use crate::state::reading::of_library;
use crate::values::number_text;

impl KeyedLook<'_> {
    /// Present value of a driver. A wire that drives nothing yet is compiled for this, once.
    pub(crate) fn driver_now(self, driver: &Driver) -> f64 {
        if let Driver::Wire(wire) = driver {
            return self.known_wire(wire).or_else(|| self.new_wire(wire)).unwrap_or(0.0);
        }
        let lights = &self.evaluation.now.lights;
        let lights = if lights.is_empty() { &self.base.look.lights } else { lights };
        self.at_this_moment(|moment| driver_value(driver, lights, moment))
    }

    /// Present value of a wire that already drives keys.
    fn known_wire(self, wire: &OutputPort) -> Option<f64> {
        let sets = self.base.look.direction_keys.iter().zip(&self.evaluation.now.decided);
        let mut found = sets.filter_map(|(keys, (now, _))| {
            let KeyDirection::Drivers(drivers) = &keys.by else { return None };
            let axis = drivers.iter().position(|driver| driver.output() == Some(wire))?;
            Some(now[axis])
        });
        found.next()
    }

    /// Present value of a wire that drives no keys yet: a copy of the look with a set of keys by
    /// this wire is compiled and run.
    fn new_wire(self, wire: &OutputPort) -> Option<f64> {
        let by = KeyDirection::Drivers(vec![Driver::Wire(wire.clone())]);
        let (name, scheme, unknown) = (String::new(), Default::default(), Default::default());
        let mut trial = self.base.look.clone();
        trial.direction_keys.push(DirectionKeys { name, by, scheme, keys: Vec::new(), unknown });
        let options = CompileOptions { live: Live::Exposed, ..CompileOptions::default() };
        let shader = compile(&trial, self.base.library, &options).ok()?.value;
        let base = |node: &NodePath, port: &PortName| {
            self.base.own_value(&Target::Input { node: node.clone(), port: port.clone() })
        };
        let rig = Rig::new(&trial).value;
        let now = self
            .at_this_moment(|moment| rig.keyed_values(&base, Some(Wires::of(&shader)), moment))
            .ok()?;
        now.decided.last().map(|(now, _)| now.x)
    }

    /// Display name of a driver.
    pub(crate) fn driver_name(self, driver: &Driver) -> String {
        self.driver_name_in(driver, Text::tr, of_library)
    }

    /// Name of a driver in English, for names that are kept.
    pub(super) fn english_driver_name(self, driver: &Driver) -> String {
        self.driver_name_in(driver, Text::english, |label| label)
    }

    fn driver_name_in(
        self,
        driver: &Driver,
        told: fn(Text) -> &'static str,
        label: fn(&str) -> &str,
    ) -> String {
        let (text, name) = match driver {
            Driver::Distance => (text!("Distance to the eye"), String::new()),
            Driver::Facing => (text!("Turned from the eye"), String::new()),
            Driver::Height(light) => (text!("Height of \"{name}\""), self.base.light_name(light)),
            Driver::Near(object) => (text!("Distance to \"{name}\""), object.to_string()),
            Driver::Wire(wire) => match self.wire_names(wire, label) {
                None => return wire.to_string(),
                Some([port, node]) => {
                    let values =
                        [("port", format_args!("{port}")), ("node", format_args!("{node}"))];
                    return fill(told(text!("{port} of \"{node}\"")), &values);
                }
            },
        };
        fill(told(text), &[("name", format_args!("{name}"))])
    }

    /// Names of an output and of its node; `label` gives a label of the library in the language
    /// that is wanted. `None` where there is no such node.
    fn wire_names(self, wire: &OutputPort, label: fn(&str) -> &str) -> Option<[String; 2]> {
        let path = wire.node.to_string();
        let node = self.base.node_at(&wire.node)?;
        let kind = self.base.catalog.of(node);
        let of_kind = kind.map_or(path.as_str(), |kind| label(&kind.label));
        let called = if node.name.is_empty() { of_kind } else { &node.name };
        let port = kind.and_then(|kind| kind.outputs.iter().find(|port| port.name == wire.port));
        let port = port.map_or(wire.port.as_str(), |port| label(&port.label));
        Some([port.to_owned(), called.to_owned()])
    }

    /// Drivers that keys can have, without wires.
    pub(crate) fn drivers(self) -> Vec<Driver> {
        let heights = self.base.look.lights.keys().map(|id| Driver::Height(id.clone()));
        let objects =
            self.scene.into_iter().flat_map(|open_scene| open_scene.scene().objects.keys());
        let near = objects.map(|id| Driver::Near(id.clone()));
        [Driver::Distance, Driver::Facing].into_iter().chain(heights).chain(near).collect()
    }

    /// Wires that can drive keys of the targets `moved`: first those that may change while the look
    /// stays as it is, then those that never do, and so would hold every key where it is.
    pub(crate) fn wires(self, moved: &[Target]) -> [Vec<Driver>; 2] {
        let look = self.base.look;
        let exposed = look.exposed.iter().map(|exposed| &exposed.target);
        let in_time = look.time_keys.iter().map(|track| &track.target);
        let by_direction = look
            .direction_keys
            .iter()
            .flat_map(|keys| &keys.keys)
            .flat_map(|key| key.values.keys());
        let set: Vec<Target> = exposed.chain(in_time).chain(by_direction).cloned().collect();
        let found = self.typed.map(|typed| typed.drivable(moved, &set)).unwrap_or_default();
        // The compiler may be a step behind the document.
        let is_there = |wire: &OutputPort| self.base.node_at(&wire.node).is_some();
        found.map(|wires| wires.into_iter().filter(is_there).map(Driver::Wire).collect())
    }
}

/// Value of a driver in words, with its unit.
pub(crate) fn said(driver: &Driver, value: f64) -> String {
    if driver.is_angle() { format!("{:.1}°", value.to_degrees()) } else { number_text(value, 3) }
}
