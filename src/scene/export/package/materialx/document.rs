//! The document: the look's node, the graph behind it, and a material that wears it.
//!
//! The node has the exposed parameters alone. A graph gives the function behind the node the
//! surface, whose nodes MaterialX brings along. No node has the place of the eye: a small one has,
//! which reads what generators declare for the direction of view.

use std::fmt::Write as _;

use super::super::PackageRequest;
use super::inputs::NodeInput;
use super::literal;
use super::source::Source;
use crate::export::description::ExposedParameter;

/// The text around the parts of a look.
const TEMPLATE: &str = include_str!("look.mtlx");

/// Writes the document of a look, whose node is called `name`.
pub(super) fn write(
    request: &PackageRequest<'_>,
    name: &str,
    inputs: &[NodeInput<'_>],
    source: &Source,
    standard: &str,
) -> String {
    let given_names: Vec<&str> = source.given.iter().map(|given| given.name).collect();
    let mut public = String::new();
    let mut private = String::new();
    let mut passed_on = String::new();
    for given in &source.given {
        let (ty, name) = (given.ty.0, given.name);
        let zero = literal::list(&vec![0.0; components(ty)]);
        let _ = writeln!(private, "    <input name=\"{name}\" type=\"{ty}\" value=\"{zero}\" />");
        let _ = writeln!(
            passed_on,
            "      <input name=\"{name}\" type=\"{ty}\" nodename=\"{name}\" />"
        );
    }
    private += "    <input name=\"eye\" type=\"vector3\" value=\"0.0, 0.0, 0.0\" />\n";
    passed_on += "      <input name=\"eye\" type=\"vector3\" nodename=\"eye\" />\n";
    for input in inputs {
        let (ty, value) = (input.ty.0, literal::materialx(&input.default));
        let _ = writeln!(
            public,
            "    <input name=\"{}\" type=\"{ty}\" value=\"{value}\"{} />",
            input.name,
            told(input.told, ty)
        );
        // What the graph gives has the first right to its name.
        let mut inner = input.name.to_owned();
        while given_names.contains(&inner.as_str()) || inner == "eye" {
            inner.push_str("_in");
        }
        let _ = writeln!(private, "    <input name=\"{inner}\" type=\"{ty}\" value=\"{value}\" />");
        let _ = writeln!(
            passed_on,
            "      <input name=\"{inner}\" type=\"{ty}\" interfacename=\"{}\" />",
            input.name
        );
    }
    let mut surface = String::new();
    for given in &source.given {
        let (node, space) = given.node;
        let head = format!("    <{node} name=\"{}\" type=\"{}\"", given.name, given.ty.0);
        surface += &match space {
            None => format!("{head} />\n"),
            Some(space) => format!(
                "{head}>\n      <input name=\"space\" type=\"string\" value=\"{space}\" />\n    \
                 </{node}>\n"
            ),
        };
    }
    TEMPLATE
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{public}}\n", &public)
        .replace("{{private}}\n", &private)
        .replace("{{passed_on}}\n", &passed_on)
        .replace("{{surface}}\n", &surface)
        .replace("{{standard}}\n", &commented(standard))
        .replace("{{node}}", name)
        .replace("{{stem}}", &escaped(request.stem))
        // Last: a title may have braces.
        .replace("{{title}}", &escaped(request.title).replace("--", "- -"))
}

/// The graph of MaterialX's own nodes with what is said above it; empty where there is none.
fn commented(standard: &str) -> String {
    if standard.is_empty() {
        return String::new();
    }
    format!("  <!-- The look of MaterialX's own nodes, for all other targets. -->\n{standard}\n")
}

/// Numbers of a type of MaterialX.
fn components(ty: &str) -> usize {
    match ty {
        "vector2" => 2,
        "vector3" | "color3" => 3,
        "vector4" | "color4" => 4,
        "matrix33" => 9,
        _ => 1,
    }
}

/// Attributes that tell people of an input.
fn told(parameter: &ExposedParameter, ty: &str) -> String {
    let mut text = format!(" uiname=\"{}\"", escaped(&parameter.label));
    if !parameter.group.is_empty() {
        // A slash would open a folder within.
        let folder = parameter.group.replace('/', " ");
        let _ = write!(text, " uifolder=\"{}\"", escaped(&folder));
    }
    let bound = |x: f64| match ty {
        "integer" => format!("{x:.0}"),
        _ => literal::list(&vec![x; components(ty)]),
    };
    if !matches!(ty, "boolean" | "matrix33") {
        for (name, value) in [("uimin", parameter.min), ("uimax", parameter.max)] {
            if let Some(value) = value {
                let _ = write!(text, " {name}=\"{}\"", bound(value));
            }
        }
    }
    let unit = match parameter.unit.as_str() {
        "" => String::new(),
        unit => format!("In {unit}."),
    };
    let doc = [parameter.help.as_str(), &unit].join(" ");
    if !doc.trim().is_empty() {
        let _ = write!(text, " doc=\"{}\"", escaped(doc.trim()));
    }
    text
}

/// A text within an attribute's quotes.
fn escaped(text: &str) -> String {
    let plain = text.replace(char::is_control, " ");
    plain.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_tell_people() {
        let mut parameter = ExposedParameter {
            label: "Rim \"light\" & <more>".to_owned(),
            help: "How far.".to_owned(),
            group: "Rim/back".to_owned(),
            unit: "rad".to_owned(),
            min: Some(0.0),
            ..ExposedParameter::default()
        };
        let wanted = " uiname=\"Rim &quot;light&quot; &amp; &lt;more&gt;\" uifolder=\"Rim back\" \
                      uimin=\"0.0, 0.0\" doc=\"How far. In rad.\"";
        assert_eq!(told(&parameter, "vector2"), wanted);
        (parameter.max, parameter.unit) = (Some(3.0), String::new());
        assert!(told(&parameter, "integer").contains("uimin=\"0\" uimax=\"3\" doc=\"How far.\""));
        assert!(!told(&parameter, "boolean").contains("uimin"));
    }
}
