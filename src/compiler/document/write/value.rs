//! Writing values.

use super::part;
use crate::document::json::{Layout, Writer};
use crate::document::shape::{CURVE, RAMP, RAMP_STOP};
use crate::document::{Curve, Interpolation, Ramp, Unknown, Value, Values};

/// The member `values`, if there are any.
pub(super) fn values(w: &mut Writer, values: &Values, unknown: &Unknown) {
    if values.is_empty() {
        return;
    }
    w.member("values", |w| {
        w.object(Layout::Inline, |w| {
            for (port, of_port) in values {
                let extras = part(Some(unknown), "values", Some(port.as_str()));
                w.member(port.as_str(), |w| value(w, of_port, extras));
            }
        });
    });
}

pub(super) fn value(w: &mut Writer, value: &Value, unknown: Option<&Unknown>) {
    match value {
        Value::Bool(value) => w.bool(*value),
        Value::Number(number) => w.number(*number),
        Value::Vector(numbers) => w.numbers(numbers),
        Value::Text(text) => w.string(text),
        Value::Curve(of_value) => curve(w, of_value, unknown),
        Value::Ramp(of_value) => ramp(w, of_value, unknown),
    }
}

fn curve(w: &mut Writer, curve: &Curve, unknown: Option<&Unknown>) {
    w.shaped(Layout::Inline, &CURVE, unknown, |w| {
        w.member("points", |w| w.list(Layout::Inline, &curve.points, |w, point| w.numbers(point)));
        w.word_unless("interpolation", curve.interpolation, Interpolation::default());
    });
}

fn ramp(w: &mut Writer, ramp: &Ramp, unknown: Option<&Unknown>) {
    w.shaped(Layout::Inline, &RAMP, unknown, |w| {
        let mut index = 0;
        w.member("stops", |w| {
            w.list(Layout::Inline, &ramp.stops, |w, stop| {
                w.shaped(
                    Layout::Inline,
                    &RAMP_STOP,
                    part(unknown, "stops", Some(&index.to_string())),
                    |w| {
                        w.member("at", |w| w.number(stop.at));
                        w.member("color", |w| w.numbers(&stop.color));
                    },
                );
                index += 1;
            });
        });
        w.word_unless("interpolation", ramp.interpolation, Interpolation::default());
    });
}
