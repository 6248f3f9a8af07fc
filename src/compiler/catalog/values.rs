//! Values as people read them: degrees in place of radians, labels in place of words.

use chiaro_locale::{tr, tr_in, trn};

use crate::document::{Look, Node, Value};
use crate::ids::PortName;
use crate::library::{Context, Fallback, Type};

use super::{CODE_VALUE, Port};

/// Text of a value in a few characters.
pub fn short(port: &Port, value: &Value) -> String {
    match value {
        Value::Bool(on) => switch(*on).to_owned(),
        Value::Number(number) if port.ty == Type::Bool => switch(*number > 0.5).to_owned(),
        Value::Number(number) if port.unit == "rad" => {
            format!("{}°", number_text(number.to_degrees(), 1))
        }
        Value::Number(number) => number_text(*number, 3),
        Value::Vector(numbers) => {
            numbers.iter().map(|number| number_text(*number, 2)).collect::<Vec<_>>().join(", ")
        }
        Value::Text(word) => {
            let label =
                port.options.iter().find(|(known, _)| known == word).map(|(_, label)| label);
            label.map_or_else(|| word.clone(), |label| tr_in("choice", label).to_owned())
        }
        Value::Curve(curve) => trn!(count = curve.points.len(), "{count} points", "{count} points"),
        Value::Ramp(ramp) => trn!(count = ramp.stops.len(), "{count} colors", "{count} colors"),
    }
}

fn switch(is_on: bool) -> &'static str {
    if is_on { tr!("switch" => "on") } else { tr!("switch" => "off") }
}

/// Text of a number with at most `decimals` decimals, without zeros at its end.
pub fn number_text(number: f64, decimals: usize) -> String {
    if number != 0.0 && (number.abs() >= 1e6 || number.abs() < 0.5 * 0.1f64.powi(decimals as i32)) {
        return format!("{number:.1e}");
    }
    let text = format!("{number:.decimals$}");
    if !text.contains('.') {
        return text;
    }
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Words of a name in code: underscores and points become spaces.
pub fn words(name: &str) -> String {
    name.replace(['_', '.'], " ")
}

/// Words for an input that another one is the same as.
pub fn input_words(name: &PortName) -> String {
    tr_in("node", &words(name.as_str())).to_owned()
}

/// Label of a context in people's words: the papers' kappa is a curvature.
pub fn context_words(context: Context) -> String {
    let english = context.row().label.map_or_else(|| words(context.word()), str::to_owned);
    tr_in("context", &english).to_owned()
}

/// Display of an unwired input in a node's row.
#[derive(Clone, Debug, PartialEq)]
pub enum InputDisplay {
    /// Only the name of the input.
    Nothing,
    /// Source of the value, in quiet words.
    Source(String),
    /// Text of the value.
    Text(String),
    /// Color, as RGBA with straight alpha.
    Color([f64; 4]),
}

/// Display of an unwired input of `node` in `look`.
pub fn shown(port: &Port, node: &Node, look: &Look) -> InputDisplay {
    let value = match (node.values.get(&port.name), &port.fallback) {
        (Some(value), _) | (None, Fallback::Value(value)) => value,
        (None, Fallback::Same(other)) => {
            return InputDisplay::Source(tr!("as {words}", words = input_words(other)));
        }
        (None, Fallback::Context(context)) => return InputDisplay::Source(context_words(*context)),
        (None, Fallback::Wire) => return InputDisplay::Nothing,
    };
    if matches!(port.ty, Type::Color | Type::Composite)
        && let Some(color) = value.color()
    {
        return InputDisplay::Color(color);
    }
    match (&port.ty, value) {
        (Type::LightName, Value::Text(id)) => {
            let light = look.lights.get(id.as_str());
            InputDisplay::Text(
                light
                    .map(|light| &light.name)
                    .filter(|name| !name.is_empty())
                    .unwrap_or(id)
                    .clone(),
            )
        }
        (Type::Text, _) if port.name.as_str() == CODE_VALUE => InputDisplay::Nothing,
        _ => InputDisplay::Text(short(port, value)),
    }
}

/// Value of an unwired input: the node's own, or that of the kind.
pub fn current<'a>(port: &'a Port, own: Option<&'a Value>) -> Option<&'a Value> {
    match (own, &port.fallback) {
        (Some(value), _) | (None, Fallback::Value(value)) => Some(value),
        (None, _) => None,
    }
}

/// Value as a number.
pub fn number(value: Option<&Value>) -> f64 {
    match value {
        Some(Value::Number(number)) => *number,
        Some(Value::Bool(on)) => f64::from(u8::from(*on)),
        Some(Value::Vector(numbers)) => numbers.first().copied().unwrap_or(0.0),
        _ => 0.0,
    }
}

/// Value as `width` numbers; one number stands for all.
pub fn vector(value: Option<&Value>, width: usize) -> Vec<f64> {
    let mut numbers = match value {
        Some(Value::Vector(numbers)) => numbers.clone(),
        other => vec![number(other); width],
    };
    numbers.resize(width, 0.0);
    numbers
}

/// Hexadecimal text of a color: `#rrggbb`, or `#rrggbbaa` where the color is not opaque.
pub fn hex(color: [f64; 4]) -> String {
    let [r, g, b, a] = color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    if a == 255 {
        format!("#{r:02x}{g:02x}{b:02x}")
    } else {
        format!("#{r:02x}{g:02x}{b:02x}{a:02x}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(number_text(0.5, 3), "0.5");
        assert_eq!(number_text(90.0, 1), "90");
        assert_eq!(number_text(-0.0, 3), "0");
        assert_eq!(number_text(100.0, 0), "100");
        assert_eq!(number_text(0.00001, 3), "1.0e-5");
    }

    #[test]
    fn colors_have_a_hex() {
        assert_eq!(hex([1.0, 0.5, 0.0, 1.0]), "#ff8000");
        assert_eq!(hex([0.0, 0.0, 0.0, 0.0]), "#00000000");
    }
}
