//! Colors that shots change, as the fields of the window have them.

use serde_json::Value as Json;

use crate::catalog::values;
use crate::document::{ColorSpace, linear_to_srgb, read_hex};
use crate::frame::ValueChange;

/// Ends of the names of fields that hold colors.
const COLORS: [&str; 3] = ["color", "tint", "backdrop"];
/// Colors of a scene that are given as they are shown, whatever its looks compute in.
const AS_SHOWN: [&str; 2] = ["backdrop", "outlines.color"];

/// The space of the numbers of a color that a shot changes, where its look, or the looks that its
/// light shines on, compute in `space`; `None` where the value is no color.
pub fn color_space(change: &ValueChange, space: ColorSpace) -> Option<ColorSpace> {
    let name = change.target.rsplit('.').next().unwrap_or_default();
    let is_named = COLORS.iter().any(|color| name.ends_with(color));
    if !(is_named || is_hex(&change.from) || is_hex(&change.to)) {
        return None;
    }
    let is_shown = change.look.is_none() && AS_SHOWN.contains(&change.target.as_str());
    Some(if is_shown { ColorSpace::Display } else { space })
}

/// True for a color in hexadecimal.
pub fn is_hex(value: &Json) -> bool {
    value.as_str().and_then(read_hex).is_some()
}

/// A color as the window's fields have it, `#ff8000`; `None` for what no screen shows.
pub fn color_text(numbers: &[Json], space: ColorSpace) -> Option<String> {
    let numbers: Option<Vec<f64>> = numbers.iter().map(Json::as_f64).collect();
    let (rgb, a) = match numbers?[..] {
        [r, g, b] => ([r, g, b], 1.0),
        [r, g, b, a] => ([r, g, b], a),
        _ => return None,
    };
    let [r, g, b] = match space {
        ColorSpace::Display => rgb,
        ColorSpace::Linear => rgb.map(linear_to_srgb),
    };
    let is_shown = [r, g, b, a].iter().all(|x| (0.0..=1.0).contains(x));
    is_shown.then(|| values::hex([r, g, b, a]))
}
