//! Blending of values under weights: numbers, vectors and colors are summed, directions turned;
//! words and switches cannot be blended.

use std::collections::HashMap;

use glam::DVec3;

use crate::directions::{blend_direction, blend_number};
use crate::document::{DirectionKeys, LightQuantity, Target, Value};

/// True if a target is a direction, which is turned where numbers are blended.
pub fn is_direction(target: &Target) -> bool {
    target.light_field().is_some_and(|field| field.quantity() == LightQuantity::Direction)
}

/// The weighted sum of numbers, vectors or colors; `None` where they are of different shapes, or
/// are words.
pub(super) fn blend(values: &[&Value], weights: &[f64], is_direction: bool) -> Option<Value> {
    let rows: Option<Vec<Vec<f64>>> = values.iter().map(|value| numbers_of(value)).collect();
    let mut rows = rows?;
    let width = rows.iter().map(Vec::len).max()?;
    for row in rows.iter_mut().filter(|row| row.len() == 3 && width == 4) {
        row.push(1.0);
    }
    if rows.iter().any(|row| row.len() != width) {
        return None;
    }
    if is_direction && width == 3 {
        let directions: Vec<DVec3> = rows.iter().map(|row| DVec3::from_slice(row)).collect();
        return blend_direction(weights, &directions)
            .map(|direction| Value::Vector(direction.to_array().to_vec()));
    }
    let column = |c: usize| rows.iter().map(|row| row[c]).collect::<Vec<f64>>();
    let blended: Vec<f64> = (0..width).map(|c| blend_number(weights, &column(c))).collect();
    Some(if matches!(values[0], Value::Number(_)) {
        Value::Number(blended[0])
    } else {
        Value::Vector(blended)
    })
}

pub(super) fn numbers_of(value: &Value) -> Option<Vec<f64>> {
    match value {
        Value::Number(x) => Some(vec![*x]),
        Value::Vector(v) => Some(v.clone()),
        Value::Text(_) => value.color().map(|rgba| rgba.to_vec()),
        Value::Bool(_) | Value::Curve(_) | Value::Ramp(_) => None,
    }
}

/// Blends the keyed values under `weights` into `values`; `base` gives the value of a target
/// without keys.
pub(super) fn blend_keys(
    keys: &DirectionKeys,
    weights: &[f64],
    base: &dyn Fn(&Target) -> Option<Value>,
    values: &mut HashMap<Target, Value>,
) {
    if weights.iter().all(|w| *w == 0.0) {
        return;
    }
    let own: HashMap<Target, Value> = keys
        .keys
        .iter()
        .flat_map(|key| key.values.keys())
        .filter_map(|target| {
            Some((target.clone(), values.get(target).cloned().or_else(|| base(target))?))
        })
        .collect();
    let mut targets: Vec<&Target> = keys.keys.iter().flat_map(|key| key.values.keys()).collect();
    targets.sort_by_cached_key(std::string::ToString::to_string);
    targets.dedup();
    for target in targets {
        let at_key = |index: usize| {
            let key = &keys.keys[index];
            sanitized(target, &|t: &Target| {
                key.values.get(t).cloned().or_else(|| own.get(t).cloned()).or_else(|| base(t))
            })
        };
        let at_keys: Vec<Option<Value>> = (0..keys.keys.len()).map(at_key).collect();
        let with_value: Vec<(&Value, f64)> = at_keys
            .iter()
            .zip(weights)
            .filter_map(|(value, weight)| Some((value.as_ref()?, *weight)))
            .collect();
        let total: f64 = with_value.iter().map(|(_, weight)| weight).sum();
        if total <= 0.0 {
            continue;
        }
        let (at_keys, weights): (Vec<&Value>, Vec<f64>) =
            with_value.into_iter().map(|(v, w)| (v, w / total)).unzip();
        if let Some(value) = blend(&at_keys, &weights, is_direction(target)) {
            values.insert(target.clone(), value);
        }
    }
}

/// The value of a target at a key, made fit for blending: offset, cut-off and fall-off of one node
/// are brought into order first (docs/math.md 5), so that every blend of them is in order too.
fn sanitized(target: &Target, value: &dyn Fn(&Target) -> Option<Value>) -> Option<Value> {
    let own = value(target)?;
    let Target::Input { node, port } = target else { return Some(own) };
    if !matches!(port.as_str(), "offset" | "falloff" | "cutoff") {
        return Some(own);
    }
    let sibling = |name: &str| {
        let target = Target::Input { node: node.clone(), port: name.into() };
        match value(&target) {
            Some(Value::Number(x)) => Some(x),
            _ => None,
        }
    };
    let pi = std::f64::consts::PI;
    let default = |name: &str, otherwise: f64| sibling(name).unwrap_or(otherwise);
    let offset = default("offset", 0.0).clamp(0.0, pi);
    let cutoff = default("cutoff", pi / 2.0).clamp(offset, pi);
    let falloff = default("falloff", pi / 2.0).clamp(offset, cutoff);
    Some(Value::Number(match port.as_str() {
        "offset" => offset,
        "falloff" => falloff,
        _ => cutoff,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_of_three_and_four_numbers_blend() {
        let opaque = Value::Vector(vec![1.0, 0.0, 0.0]);
        let clear = Value::Vector(vec![0.0, 0.0, 0.0, 0.0]);
        assert_eq!(
            blend(&[&opaque, &clear], &[0.5, 0.5], false),
            Some(Value::Vector(vec![0.5, 0.0, 0.0, 0.5]))
        );
    }
}
