//! Between a document's values and the interpreter's.

use chiaro_locale::{Text, text, tr, trn};

use crate::document::{Curve, Interpolation, Ramp, Value};
use crate::interp;
use crate::library::Type;

/// A document's value as a value of type `ty`.
///
/// # Errors
/// Says what was expected and what was found.
pub fn typed_value(value: &Value, ty: &Type) -> Result<interp::Value, String> {
    let found = || {
        tr!("expected {expected}, found {found}", expected = expected(ty), found = describe(value))
    };
    match (ty, value) {
        (Type::Bool, Value::Bool(b)) => Ok(interp::Value::Bool(*b)),
        (Type::Float, Value::Number(x)) => Ok(interp::Value::Float(finite(*x)?)),
        (Type::Int, Value::Number(x)) if x.fract() == 0.0 && x.abs() <= 16_777_216.0 => {
            Ok(interp::Value::I32(*x as i32))
        }
        (Type::Curve, Value::Curve(curve)) => curve_value(curve),
        (Type::Ramp, Value::Ramp(ramp)) => ramp_value(ramp),
        (Type::Mat3, Value::Vector(v)) if v.len() == 9 => {
            let columns = [[v[0], v[1], v[2]], [v[3], v[4], v[5]], [v[6], v[7], v[8]]];
            Ok(interp::Value::matrix(&columns))
        }
        (_, Value::Number(x)) if ty.width().is_some_and(|width| width > 1) => {
            let mut components = vec![finite(*x)?; ty.width().unwrap_or(1)];
            if is_color(ty) {
                components[3] = 1.0;
            }
            Ok(interp::Value::vec(&components))
        }
        (_, Value::Text(_)) if is_color(ty) => {
            value.color().map(|rgba| interp::Value::vec(&rgba)).ok_or_else(found)
        }
        (_, Value::Vector(v)) => {
            let width = ty.width().filter(|&width| width > 1).ok_or_else(found)?;
            let mut components = v.iter().map(|x| finite(*x)).collect::<Result<Vec<_>, _>>()?;
            if is_color(ty) && components.len() == 3 {
                components.push(1.0);
            }
            if components.len() == width {
                Ok(interp::Value::vec(&components))
            } else {
                Err(found())
            }
        }
        _ => Err(found()),
    }
}

fn is_color(ty: &Type) -> bool {
    matches!(ty, Type::Color | Type::Composite)
}

fn finite(x: f64) -> Result<f64, String> {
    if x.is_finite() {
        Ok(x)
    } else {
        Err(tr!("expected a finite number, found NaN or infinity").to_owned())
    }
}

pub(super) fn expected(ty: &Type) -> String {
    match ty {
        Type::Bool => tr!("true or false").to_owned(),
        Type::Float => tr!("a number").to_owned(),
        Type::Int => tr!("a whole number").to_owned(),
        Type::Vec2 | Type::Vec3 | Type::Vec4 => {
            tr!("{count} numbers in brackets", count = ty.width().unwrap_or(0))
        }
        Type::Color | Type::Composite => {
            tr!("a color: [r, g, b], [r, g, b, a] or \"#rrggbb\"").to_owned()
        }
        Type::Mat3 => tr!("nine numbers in brackets").to_owned(),
        Type::Curve => text!("a curve: {\"points\": [[x, y], ...]}").tr().to_owned(),
        Type::Ramp => {
            text!("a ramp: {\"stops\": [{\"at\": 0, \"color\": [r, g, b]}, ...]}").tr().to_owned()
        }
        Type::Choice => tr!("one of the choice's words").to_owned(),
        Type::LightName => tr!("the id of a light").to_owned(),
        Type::Image => tr!("the path of an image").to_owned(),
        Type::Hcbtf => tr!("the path of an .hcbtf file").to_owned(),
        Type::Text => tr!("a text").to_owned(),
        Type::Casters => tr!("the scene's own casters").to_owned(),
        Type::ShadowMaps => tr!("the scene's own shadow maps").to_owned(),
        Type::Angle | Type::Light | Type::Prepared(_) => tr!("a wire").to_owned(),
    }
}

/// A value in words, for messages.
pub(super) fn describe(value: &Value) -> String {
    match value {
        Value::Bool(b) => format!("{b}"),
        Value::Number(x) => tr!("the number {x}"),
        Value::Vector(v) => trn!(count = v.len(), "{count} numbers", "{count} numbers"),
        Value::Text(text) if text.len() <= 40 => tr!("the text {text:?}"),
        Value::Text(_) => tr!("a text").to_owned(),
        Value::Curve(_) => tr!("a curve").to_owned(),
        Value::Ramp(_) => tr!("a ramp").to_owned(),
    }
}

fn interpolation_code(interpolation: Interpolation) -> interp::Value {
    interp::Value::U32(match interpolation {
        Interpolation::Linear => 0,
        Interpolation::Smooth => 1,
        Interpolation::Stepped => 2,
    })
}

fn curve_value(curve: &Curve) -> Result<interp::Value, String> {
    let points = &curve.points;
    in_order(text!("points"), points.len(), Curve::MAX_POINTS, points.iter().map(|p| p[0]))?;
    for y in points.iter().map(|p| p[1]) {
        finite(y)?;
    }
    let slopes = monotone_slopes(points);
    let mut packed: Vec<_> = points
        .iter()
        .zip(&slopes)
        .map(|(p, slope)| interp::Value::vec(&[p[0], p[1], *slope, 0.0]))
        .collect();
    packed.resize(Curve::MAX_POINTS, interp::Value::vec(&[0.0; 4]));
    Ok(interp::Value::Struct(vec![
        interp::Value::Array(packed),
        interp::Value::U32(points.len() as u32),
        interpolation_code(curve.interpolation),
    ]))
}

fn ramp_value(ramp: &Ramp) -> Result<interp::Value, String> {
    let stops = &ramp.stops;
    in_order(text!("stops"), stops.len(), Ramp::MAX_STOPS, stops.iter().map(|stop| stop.at))?;
    let mut colors = Vec::new();
    for stop in stops {
        colors.push(typed_value(&Value::Vector(stop.color.clone()), &Type::Color)?);
    }
    colors.resize(Ramp::MAX_STOPS, interp::Value::vec(&[0.0; 4]));
    let mut places: Vec<f64> = stops.iter().map(|stop| stop.at).collect();
    places.resize(Ramp::MAX_STOPS, 0.0);
    let places = places.chunks(4).map(interp::Value::vec).collect();
    Ok(interp::Value::Struct(vec![
        interp::Value::Array(colors),
        interp::Value::Array(places),
        interp::Value::U32(stops.len() as u32),
        interpolation_code(ramp.interpolation),
    ]))
}

fn in_order(
    what: Text,
    count: usize,
    most: usize,
    places: impl Iterator<Item = f64>,
) -> Result<(), String> {
    if count == 0 || count > most {
        return Err(tr!("expected 1 to {most} {what}, found {count}"));
    }
    let mut before = f64::NEG_INFINITY;
    for place in places {
        if finite(place)? < before {
            return Err(tr!("expected {what} in increasing order; {place} comes after {before}"));
        }
        before = place;
    }
    Ok(())
}

/// Slopes of the monotone cubic through `points` (Fritsch and Carlson 1980, in the harmonic-mean
/// form of Fritsch and Butland 1984): no overshoot between any two points.
fn monotone_slopes(points: &[[f64; 2]]) -> Vec<f64> {
    let secants: Vec<f64> = points
        .windows(2)
        .map(|pair| {
            let dx = pair[1][0] - pair[0][0];
            if dx > 0.0 { (pair[1][1] - pair[0][1]) / dx } else { 0.0 }
        })
        .collect();
    let slope_at = |i: usize| -> f64 {
        match (i.checked_sub(1).and_then(|j| secants.get(j)), secants.get(i)) {
            (Some(&before), Some(&after)) if before * after > 0.0 => {
                2.0 * before * after / (before + after)
            }
            (Some(_), Some(_)) => 0.0,
            (Some(&only), None) | (None, Some(&only)) => only,
            (None, None) => 0.0,
        }
    };
    (0..points.len()).map(slope_at).collect()
}

/// An interpreter's value as a document's: numbers, vectors and switches; structs as their numbers
/// in order.
pub fn document_value(value: &interp::Value) -> Value {
    match value {
        interp::Value::Bool(b) => Value::Bool(*b),
        interp::Value::Struct(parts) | interp::Value::Array(parts) => {
            Value::Vector(parts.iter().flat_map(|part| numbers(&document_value(part))).collect())
        }
        other => match other.components().as_deref() {
            Some([one]) => Value::Number(*one),
            Some(many) => Value::Vector(many.to_vec()),
            None => Value::Vector(Vec::new()),
        },
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Bool(b) => vec![f64::from(u8::from(*b))],
        Value::Number(x) => vec![*x],
        Value::Vector(v) => v.clone(),
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_take_the_type_of_their_port() {
        let color = typed_value(&Value::Vector(vec![0.1, 0.2, 0.3]), &Type::Color).unwrap();
        assert_eq!(color, interp::Value::vec(&[0.1, 0.2, 0.3, 1.0]));
        assert_eq!(
            typed_value(&Value::Number(0.5), &Type::Color).unwrap(),
            interp::Value::vec(&[0.5, 0.5, 0.5, 1.0])
        );
        let problem = typed_value(&Value::Vector(vec![1.0, 2.0]), &Type::Vec3).unwrap_err();
        assert_eq!(problem, "expected 3 numbers in brackets, found 2 numbers");
        assert!(typed_value(&Value::Number(f64::NAN), &Type::Float).is_err());
    }

    #[test]
    fn monotone_slopes_are_flat_at_extremes() {
        let slopes = monotone_slopes(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 0.0]]);
        assert_eq!(slopes, [1.0, 0.0, 0.0, 0.0]);
        let straight = monotone_slopes(&[[0.0, 0.0], [1.0, 2.0], [3.0, 6.0]]);
        assert_eq!(straight, [2.0, 2.0, 2.0]);
    }
}
