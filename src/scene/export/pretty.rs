//! JSON for people: a value that fits on a line stands on one line.

use serde_json::Value;

/// Greatest length of a line, except for single texts, in columns.
const WIDTH: usize = 120;

/// A document with a line end at its end. Values that are written here nest a few levels deep.
pub(super) fn pretty(value: &Value) -> String {
    let mut out = String::new();
    write(value, 0, 0, &mut out);
    out.push('\n');
    out
}

/// Writes a value; `used` is the number of columns before the value on its line, beside the
/// indentation.
fn write(value: &Value, indent: usize, used: usize, out: &mut String) {
    let compact = spaced(value);
    // One column is left for the comma behind the value.
    if indent + used + compact.len() < WIDTH || !(value.is_array() || value.is_object()) {
        out.push_str(&compact);
        return;
    }
    let inner = indent + 2;
    let is_list = value.is_array();
    out.push_str(if is_list { "[\n" } else { "{\n" });
    let entries: Vec<(String, &Value)> = match value {
        Value::Array(items) => items.iter().map(|item| (String::new(), item)).collect(),
        Value::Object(fields) => {
            fields.iter().map(|(key, field)| (format!("{}: ", quoted(key)), field)).collect()
        }
        _ => Vec::new(),
    };
    for (index, (key, entry)) in entries.iter().enumerate() {
        out.push_str(&" ".repeat(inner));
        out.push_str(key);
        write(entry, inner, key.len(), out);
        out.push_str(if index + 1 == entries.len() { "\n" } else { ",\n" });
    }
    out.push_str(&" ".repeat(indent));
    out.push(if is_list { ']' } else { '}' });
}

fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// A value on one line, with a space after each comma and colon.
fn spaced(value: &Value) -> String {
    match value {
        Value::Array(items) => {
            format!("[{}]", items.iter().map(spaced).collect::<Vec<_>>().join(", "))
        }
        Value::Object(fields) => {
            let field =
                |(key, value): (&String, &Value)| format!("{}: {}", quoted(key), spaced(value));
            format!("{{{}}}", fields.iter().map(field).collect::<Vec<_>>().join(", "))
        }
        // Whole numbers are written without a point, as people write them.
        Value::Number(number) if number.is_f64() => match number.as_f64() {
            Some(x) if x.fract() == 0.0 && x.abs() < 1e15 => format!("{x:.0}"),
            _ => number.to_string(),
        },
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn what_fits_stands_on_a_line() {
        let value = json!({"a": [1, 2.5], "b": {"c": vec!["word"; 30]}});
        let text = pretty(&value);
        assert!(
            text.starts_with("{\n  \"a\": [1, 2.5],\n  \"b\": {\n    \"c\": [\n      \"word\",\n"),
            "{text}"
        );
        assert!(text.lines().all(|line| line.len() <= WIDTH));
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), value);
        assert_eq!(pretty(&json!([])), "[]\n");
        assert_eq!(pretty(&json!([1.0, -2.0, 0.1, 1e300])), "[1, -2, 0.1, 1e+300]\n");
    }
}
