//! The table of a look's exposed parameters, with which the README of every package ends.

use serde_json::Value;

use super::super::description::{Description, ExposedParameter};
use crate::catalog::values::hex;
use crate::document::ColorSpace;

/// Beginning of the table.
const HEAD: &str = "| group | label | name | range | value |\n| --- | --- | --- | --- | --- |\n";

/// Group of parameters that belong to no node.
const NO_GROUP: &str = "Look";

/// The exposed parameters as a table of Markdown: a line each, groups together, both in the
/// artist's order. A sentence that says what to do where the look exposes none.
pub(super) fn parameter_table(description: &Description) -> String {
    parameter_table_with(description, |parameter| parameter.name.as_ref()?.to_string().into())
}

/// The table with the package's own names of parameters; none for those without one.
pub(super) fn parameter_table_with(
    description: &Description,
    name: impl Fn(&ExposedParameter) -> Option<String>,
) -> String {
    let exposed = || description.parameters.iter().filter(|it| it.name.is_some());
    let mut groups: Vec<&str> = Vec::new();
    for parameter in exposed() {
        if !groups.contains(&group(parameter)) {
            groups.push(group(parameter));
        }
    }
    if groups.is_empty() {
        return "The look exposes none: expose some in Chiaro, or export with `--live`.\n"
            .to_owned();
    }
    let space = description.color_space;
    let mut table = HEAD.to_owned();
    for wanted in groups {
        let of_group = exposed().filter(|it| group(it) == wanted);
        table.extend(of_group.map(|it| row(it, &name(it).unwrap_or_default(), space)));
    }
    table
}

fn group(parameter: &ExposedParameter) -> &str {
    if parameter.group.is_empty() { NO_GROUP } else { &parameter.group }
}

/// The line of a parameter.
fn row(parameter: &ExposedParameter, name: &str, space: ColorSpace) -> String {
    let [group, label] = [group(parameter), parameter.label.as_str()].map(cell);
    let value = cell(&value(parameter, space));
    format!("| {group} | {label} | `{name}` | {} | {value} |\n", cell(&range(parameter)))
}

/// A text that neither ends a cell nor is markup.
pub(super) fn cell(text: &str) -> String {
    let plain = text.replace(char::is_control, " ");
    plain.replace('|', "\\|").replace('<', "&lt;").replace('*', "\\*").replace('`', "'")
}

/// The values that a parameter takes.
fn range(parameter: &ExposedParameter) -> String {
    if !parameter.live {
        return "fixed by the export".to_owned();
    }
    if !parameter.options.is_empty() {
        return parameter.options.join(", ");
    }
    let unit = match parameter.unit.as_str() {
        "" => String::new(),
        unit => format!(" {unit}"),
    };
    match (parameter.min, parameter.max) {
        (Some(least), Some(most)) => format!("{} to {}{unit}", short(least), short(most)),
        (Some(least), None) => format!("from {}{unit}", short(least)),
        (None, Some(most)) => format!("to {}{unit}", short(most)),
        (None, None) => match parameter.ty.as_str() {
            "switch" => "true, false".to_owned(),
            "float" => format!("any number{unit}"),
            "int" => format!("any whole number{unit}"),
            ty => format!("{ty}{unit}"),
        },
    }
}

/// The value that a parameter has in the look.
fn value(parameter: &ExposedParameter, space: ColorSpace) -> String {
    match &parameter.default {
        Value::Number(number) => number.as_f64().map(short).unwrap_or_default(),
        Value::String(word) => word.clone(),
        Value::Bool(is_on) => is_on.to_string(),
        Value::Array(values) => {
            let numbers: Option<Vec<f64>> = values.iter().map(Value::as_f64).collect();
            let numbers = numbers.unwrap_or_default();
            match (parameter.ty.as_str(), numbers.as_slice()) {
                // Colors as shown have the form that people know.
                ("color", &[r, g, b, a]) if space == ColorSpace::Display && is_shown(&numbers) => {
                    hex([r, g, b, a])
                }
                _ => numbers.iter().map(|number| short(*number)).collect::<Vec<_>>().join(", "),
            }
        }
        Value::Null | Value::Object(_) => String::new(),
    }
}

/// True for numbers that a color of 8 bits can have.
fn is_shown(numbers: &[f64]) -> bool {
    numbers.iter().all(|number| (0.0..=1.0).contains(number))
}

/// A number as people read it: four decimals, or all digits of one that is smaller.
fn short(number: f64) -> String {
    if number != 0.0 && number.abs() < 1e-3 {
        return number.to_string();
    }
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn parameter(ty: &str, default: Value) -> ExposedParameter {
        ExposedParameter { ty: ty.to_owned(), default, live: true, ..ExposedParameter::default() }
    }

    #[test]
    fn rows_tell_ranges_and_values() {
        let mut angle = parameter("float", json!(0.5));
        (angle.group, angle.label) = ("Key | *tone*".to_owned(), "Cut-off".to_owned());
        (angle.min, angle.max) = (Some(0.0), Some(std::f64::consts::PI));
        angle.unit = "rad".to_owned();
        let wanted = "| Key \\| \\*tone\\* | Cut-off | `` | 0 to 3.1416 rad | 0.5 |\n";
        assert_eq!(row(&angle, "", ColorSpace::Display), wanted);
        angle.live = false;
        assert_eq!(range(&angle), "fixed by the export");
    }

    #[test]
    fn values_are_written_as_people_set_them() {
        let color = parameter("color", json!([1.0, 0.5, 0.0, 1.0]));
        assert_eq!(value(&color, ColorSpace::Display), "#ff8000");
        assert_eq!(value(&color, ColorSpace::Linear), "1, 0.5, 0, 1");
        assert_eq!(value(&parameter("switch", json!(true)), ColorSpace::Display), "true");
        assert_eq!([short(-0.0), short(2.0), short(0.000_25)], ["0", "2", "0.00025"]);
    }
}
