//! Reading of values, targets, endpoints and rotations.

use chiaro_locale::{text, tr};

use super::reader::Reader;
use crate::diag::Diagnostic;
use crate::document::described::{FieldType as _, described};
use crate::document::json::{JsonKind, ValueIndex};
use crate::document::rotation;
use crate::document::shape::{self, F32, FAR, LONG, MAX_NUMBERS};
use crate::document::{Curve, Endpoint, Ramp, Target, UnknownFields, Value, long_hex};
use crate::ids::is_slug;

described! {
    /// A rotation by the right-hand rule.
    pub struct AxisAngle("axis and angle", Line) {
        /// The axis; any length but 0.
        axis: [f64; 3], shape::FieldKind::Direction, required;
        /// Angle, in radians.
        angle: f64, shape::FieldKind::Number(FAR), required;
    }
}

impl Reader<'_> {
    pub(in crate::document) fn value_at(
        &mut self,
        at: ValueIndex,
        extras: &mut UnknownFields,
    ) -> Option<Value> {
        match self.tree.kind(at) {
            JsonKind::Bool(value) => Some(Value::Bool(value)),
            JsonKind::Number => self.number_at(at, F32).map(Value::Number),
            JsonKind::Text => {
                self.text_at(at, LONG).map(|text| Value::Text(long_hex(&text).into_owned()))
            }
            JsonKind::List => self.numbers_at(at, 1, MAX_NUMBERS, F32).map(Value::Vector),
            JsonKind::Object if self.tree.member(at, "stops").is_some() => {
                let ramp = Ramp::read(self, at, &shape::FieldKind::Value, extras)?;
                self.in_order(at, "stops", ramp.stops.iter().map(|stop| stop.at))?;
                Some(Value::Ramp(ramp))
            }
            JsonKind::Object if self.tree.member(at, "points").is_some() => {
                let curve = Curve::read(self, at, &shape::FieldKind::Value, extras)?;
                self.in_order(at, "points", curve.points.iter().map(|point| point[0]))?;
                Some(Value::Curve(curve))
            }
            JsonKind::Object => {
                let problem = Diagnostic::error("wrong-type", tr!("this object is no value"));
                let hint = text!(
                    "a curve is {\"points\": [[x, y], ...]}, a ramp \
                            {\"stops\": [{\"at\": x, \"color\": [r, g, b]}, ...]}"
                )
                .tr();
                self.report(at, problem.hint(hint));
                None
            }
            JsonKind::Null => {
                let problem = Diagnostic::error("wrong-type", tr!("null is no value"));
                self.report(at, problem.hint(tr!("leave the value out for the input's default")));
                None
            }
            JsonKind::Bad => None,
        }
    }

    /// Checks that there is at least one place, and that each is greater than the one before it.
    fn in_order(
        &mut self,
        at: ValueIndex,
        what: &str,
        places: impl Iterator<Item = f64>,
    ) -> Option<()> {
        let places: Vec<f64> = places.collect();
        if places.is_empty() {
            let problem = Diagnostic::error("wrong-count", tr!("`{what}` has nothing in it"));
            self.report(at, problem.hint(tr!("write at least one")));
            return None;
        }
        if let Some(pair) = places.windows(2).find(|pair| pair[0] >= pair[1]) {
            let message = tr!(
                "`{what}` must increase, but {later} follows {earlier}",
                later = pair[1],
                earlier = pair[0]
            );
            self.report(
                at,
                Diagnostic::error("not-increasing", message)
                    .hint(tr!("sort them, and remove doubles")),
            );
            return None;
        }
        Some(())
    }

    /// Reads an end of a wire; the end at an input needs a port.
    pub(in crate::document) fn endpoint_at(
        &mut self,
        at: ValueIndex,
        needs_port: bool,
    ) -> Option<Endpoint> {
        let text = match self.tree.kind(at) {
            JsonKind::Null => "".into(),
            _ => self.text_at(at, 200)?,
        };
        let end = Endpoint::parse(&text);
        let (node, port) = (end.node.as_str(), end.port.as_str());
        let problem = if node.is_empty() {
            Diagnostic::error("wire-to-nothing", tr!("this end of the wire leads to nothing"))
        } else if needs_port && port.is_empty() {
            Diagnostic::error(
                "wire-to-nothing",
                tr!("the wire leads to `{node}`, but to no input of it"),
            )
        } else if is_slug(node) && (port.is_empty() || is_slug(port)) {
            return Some(end);
        } else {
            Diagnostic::error("bad-wire", tr!("`{text}` is no port"))
        };
        let hint = if needs_port {
            tr!("write \"node.input\"")
        } else {
            tr!("write \"node.output\", or \"node\"")
        };
        self.report(at, problem.hint(hint));
        None
    }

    pub(in crate::document) fn target_from(
        &mut self,
        at: ValueIndex,
        text: &str,
    ) -> Option<Target> {
        let target = Target::parse(text).filter(|target| match target {
            Target::Input { node, port } => {
                node.ids().iter().all(|id| is_slug(id.as_str())) && is_slug(port.as_str())
            }
            Target::Light { light, .. } => is_slug(light.as_str()),
        });
        if target.is_none() {
            let shown: String = text.chars().take(80).collect();
            let problem =
                Diagnostic::error("bad-target", tr!("`{shown}` names nothing that can be set"));
            self.report(
                at,
                problem.hint(tr!("write `node.input`, `group/node.input` or `lights.light.field`")),
            );
        }
        target
    }

    /// Reads a rotation as a unit quaternion.
    pub(in crate::document) fn rotation_at(&mut self, at: ValueIndex) -> Option<[f64; 4]> {
        let found = match self.tree.kind(at) {
            JsonKind::Object => self.axis_angle(at)?,
            JsonKind::List
                if self
                    .tree
                    .children(at)
                    .next()
                    .is_some_and(|row| self.tree.kind(row) == JsonKind::List) =>
            {
                rotation::from_matrix(self.matrix(at)?)
            }
            JsonKind::List if self.tree.children(at).count() == 4 => {
                rotation::from_quaternion(self.array_at(at, FAR)?)
            }
            JsonKind::Bad => return None,
            _ => Err(tr!("this is no rotation")),
        };
        found
            .map_err(|message| {
                let hint = text!(
                    "write a quaternion [x, y, z, w], a 3x3 matrix as three rows, or \
                            {\"axis\": [x, y, z], \"angle\": radians}"
                )
                .tr();
                self.report(at, Diagnostic::error("bad-rotation", message).hint(hint));
            })
            .ok()
    }

    fn matrix(&mut self, at: ValueIndex) -> Option<[[f64; 3]; 3]> {
        let tree = self.tree;
        let rows: Vec<_> = tree
            .children(at)
            .enumerate()
            .take(4)
            .map(|(index, row)| self.at_index(index, |r| r.array_at::<3>(row, FAR)))
            .collect();
        let rows: Vec<[f64; 3]> = rows.into_iter().collect::<Option<_>>()?;
        let count = rows.len();
        rows.try_into()
            .map_err(|_| {
                self.report(
                    at,
                    Diagnostic::error("wrong-count", tr!("expected 3 rows, found {count}")),
                );
            })
            .ok()
    }

    fn axis_angle(&mut self, at: ValueIndex) -> Option<Result<[f64; 4], &'static str>> {
        let turn =
            AxisAngle::read(self, at, &shape::FieldKind::Rotation, &mut UnknownFields::new())?;
        Some(Ok(rotation::from_axis_angle(turn.axis, turn.angle)))
    }
}
