//! The table of a look's exposed parameters, for READMEs of packages.

use std::fmt::Write as _;

use serde_json::Value;

use super::super::description::{Description, ExposedParameter};

/// A Markdown table of the parameters that change the picture, a row each: group, label, name,
/// range and value in the look. Empty for a look without any.
pub(super) fn table(description: &Description) -> String {
    let mut rows = String::new();
    let mut last_group = "";
    for parameter in description.parameters.iter().filter(|parameter| parameter.live) {
        let Some(name) = &parameter.name else { continue };
        // A group is named once, beside its first parameter.
        let is_new = parameter.group != last_group;
        let group = if is_new { cell(&parameter.group) } else { String::new() };
        last_group = &parameter.group;
        let _infallible = writeln!(
            rows,
            "| {group} | {} | `{}` | {} | {} |",
            cell(&parameter.label),
            name.as_str(),
            range(parameter),
            cell(&text(&parameter.default)),
        );
    }
    if rows.is_empty() {
        return rows;
    }
    let head = "| group | label | name | range | in the look |\n| --- | --- | --- | --- | --- |\n";
    head.to_owned() + &rows
}

/// The range of a parameter in words, or else its type.
fn range(parameter: &ExposedParameter) -> String {
    let ends = match (parameter.min, parameter.max) {
        (Some(low), Some(high)) => format!("{} to {}", number(low), number(high)),
        (Some(low), None) => format!("from {}", number(low)),
        (None, Some(high)) => format!("up to {}", number(high)),
        (None, None) => parameter.ty.clone(),
    };
    let unit = &parameter.unit;
    if unit.is_empty() { cell(&ends) } else { cell(&format!("{ends}, {unit}")) }
}

/// A value as a person would write it.
fn text(value: &Value) -> String {
    match value {
        Value::Number(x) => x.as_f64().map_or_else(|| x.to_string(), number),
        Value::Array(parts) => parts.iter().map(text).collect::<Vec<_>>().join(", "),
        Value::String(word) => word.clone(),
        Value::Bool(true) => "on".to_owned(),
        Value::Bool(false) => "off".to_owned(),
        _ => String::new(),
    }
}

/// A number with four decimals at most.
fn number(x: f64) -> String {
    let short = format!("{x:.4}");
    let short = short.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

/// Text that fits in a cell of a table.
fn cell(text: &str) -> String {
    text.replace(['|', '<', '>', '`', '\n', '\r'], " ")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn values_are_short() {
        assert_eq!(number(std::f64::consts::PI), "3.1416");
        assert_eq!(number(-0.000_001), "0");
        assert_eq!(number(100.0), "100");
        assert_eq!(text(&json!([0.5, 1, 0.25])), "0.5, 1, 0.25");
        assert_eq!(text(&json!(true)), "on");
        assert_eq!(cell("a|b"), "a b");
    }
}
