//! Values of something that varies, as the command line writes them.

use crate::document::{Value, long_hex, parse_hex};

/// Greatest number of values of one thing.
const MAX_VALUES: usize = 10_000;

/// Variation of a value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Variation {
    /// Name of the value, as it was written.
    pub(super) target: String,
    /// The values that it takes, in order.
    pub(super) values: Vec<Value>,
}

/// Reads `TARGET=VALUES`.
pub(super) fn parse(text: &str) -> Result<Variation, String> {
    let (target, values) = text.split_once('=').ok_or("write it as key.intensity=0.5..2/4")?;
    let values = match values.split_once("..") {
        Some((from, rest)) => range(from, rest)?,
        None => parts(values).into_iter().map(value).collect::<Result<_, _>>()?,
    };
    Ok(Variation { target: target.trim().to_owned(), values })
}

/// So many values from one to another.
fn range(from: &str, rest: &str) -> Result<Vec<Value>, String> {
    let form = || "write so many values from one to another as 0.5..2/4".to_owned();
    let (to, count) = rest.rsplit_once('/').ok_or_else(form)?;
    let count: usize = count.trim().parse().map_err(|_| form())?;
    if !(2..=MAX_VALUES).contains(&count) {
        return Err(format!("there are from 2 to {MAX_VALUES} values from one to another"));
    }
    let (from, to) = (value(from)?, value(to)?);
    let is_color = matches!((&from, &to), (Value::Text(_), Value::Text(_)));
    let numbers = |value: &Value| match value {
        Value::Number(number) => Some(vec![*number]),
        Value::Vector(numbers) => Some(numbers.clone()),
        Value::Text(text) => parse_hex(text).map(|color| color.to_vec()),
        _ => None,
    };
    let ends = numbers(&from).zip(numbers(&to));
    let (from, to) = ends
        .filter(|(from, to)| from.len() == to.len())
        .ok_or_else(|| "both ends are numbers, colors, or lists of as many numbers".to_owned())?;
    let at = |place: usize| {
        let share = place as f64 / (count - 1) as f64;
        let between = from.iter().zip(&to).map(|(from, to)| from + (to - from) * share);
        let numbers: Vec<f64> = between.collect();
        match numbers.as_slice() {
            [number] => Value::Number(*number),
            numbers if is_color => Value::Text(hex(numbers)),
            _ => Value::Vector(numbers),
        }
    };
    Ok((0..count).map(at).collect())
}

/// The parts between commas that lie in no brackets.
fn parts(text: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut begin) = (Vec::new(), 0_i32, 0);
    for (at, sign) in text.char_indices() {
        match sign {
            '[' => depth += 1,
            ']' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&text[begin..at]);
                begin = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[begin..]);
    parts
}

fn value(text: &str) -> Result<Value, String> {
    let text = text.trim();
    if text.starts_with('#') {
        let color = long_hex(text).into_owned();
        let known = parse_hex(&color).map(|_| Value::Text(color));
        return known.ok_or_else(|| format!("`{text}` is no color; write #8af or #88aaff"));
    }
    match text {
        "" => Err("a value is missing".to_owned()),
        "true" | "false" => Ok(Value::Bool(text == "true")),
        _ if text.starts_with('[') => serde_json::from_str::<Vec<f64>>(text)
            .ok()
            .filter(|numbers| numbers.iter().all(|number| number.is_finite()))
            .map(Value::Vector)
            .ok_or_else(|| format!("`{text}` is no list of numbers such as [0,1,0]")),
        _ => Ok(match text.parse::<f64>().ok().filter(|number| number.is_finite()) {
            Some(number) => Value::Number(number),
            None => Value::Text(text.to_owned()),
        }),
    }
}

/// A color as text, of three numbers or four; one that is opaque has three.
fn hex(numbers: &[f64]) -> String {
    let count = if numbers.get(3).is_none_or(|alpha| *alpha >= 1.0) { 3 } else { 4 };
    let byte = |x: &f64| format!("{:02x}", (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    numbers.iter().take(count).fold("#".to_owned(), |text, x| text + &byte(x))
}

/// A value for a label.
pub(super) fn text(value: &Value) -> String {
    let number = |x: &f64| {
        let text = format!("{x:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    match value {
        Value::Number(x) => number(x),
        Value::Text(text) => text.clone(),
        Value::Bool(is_on) => is_on.to_string(),
        Value::Vector(numbers) => {
            let numbers: Vec<String> = numbers.iter().map(number).collect();
            format!("[{}]", numbers.join(", "))
        }
        Value::Curve(_) | Value::Ramp(_) => "…".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(words: &str) -> Result<Vec<String>, String> {
        parse(words).map(|varied| varied.values.iter().map(text).collect())
    }

    #[test]
    fn values_are_read_as_people_write_them() {
        let found = |words: &str| texts(words).unwrap().join(" | ");
        assert_eq!(found("key.intensity=0.5..2/4"), "0.5 | 1 | 1.5 | 2");
        assert_eq!(found("rim.color=#8af,#fa8"), "#88aaff | #ffaa88");
        assert_eq!(found("rim.color=#000000..#ffffff/3"), "#000000 | #808080 | #ffffff");
        assert_eq!(found("key.direction=[0,1,0], [1, 0, 0.5]"), "[0, 1, 0] | [1, 0, 0.5]");
        assert_eq!(found("a.b=[0,0]..[1,2]/2"), "[0, 0] | [1, 2]");
        assert_eq!(found("lit.blend=add,alpha"), "add | alpha");
        assert_eq!(found("x=-1..1/2"), "-1 | 1");
        assert_eq!(found("x=true,false"), "true | false");
        assert_eq!(parse(" a.b =1").unwrap().target, "a.b");
        for wrong in [
            "key",
            "k=",
            "k=1,,2",
            "k=#12",
            "k=0..1",
            "k=0..1/1",
            "k=0..#fff/2",
            "k=[a]",
            "k=0../3",
        ] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
