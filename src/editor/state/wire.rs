//! Any wire in place of the picture: its value as a color, as heat, or with lines where the value
//! crosses tenths.
//!
//! The look itself is not touched. The compiler is asked for another output than the look's own;
//! heat and lines are a node of the window's own behind that output, in a copy of the look.

use chiaro_locale::tr;

use crate::catalog::Catalog;
use crate::document::{Endpoint, InterfacePort, Look, Node, Value, Wire};
use crate::ids::{GROUP_OUTPUTS, NodeId, NodePath, PortName};
use crate::library::{Library, Type};

/// Name of the node that colors the shown value; no slug of a name begins so.
const SHOWN: &str = "chiaro-shown";

/// Largest number of groups in one another that an output is followed through.
const MOST_DEPTH: usize = 64;

/// Display of a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Style {
    /// Numbers as red, green and blue; one as gray.
    #[default]
    Color,
    Heat,
    Isolines,
}

impl Style {
    pub(crate) const ALL: [Self; 3] = [Self::Color, Self::Heat, Self::Isolines];

    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Color => tr!("Color"),
            Self::Heat => tr!("Heat"),
            Self::Isolines => tr!("Isolines"),
        }
    }

    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Color => {
                tr!("The numbers as red, green and blue; a single one as gray, an angle from 0 to \
                     180°")
            }
            Self::Heat => {
                tr!("Blue below 0, then black to yellow from 0 to 1, red above; not a number is \
                     magenta")
            }
            Self::Isolines => {
                tr!("Gray, with a line where it crosses a tenth, a white one where it crosses a \
                     whole number; none where it is level")
            }
        }
    }
}

/// A wire that is shown in place of the picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ShownWire {
    pub(crate) node: NodePath,
    pub(crate) port: PortName,
    pub(crate) style: Style,
}

impl ShownWire {
    /// A copy of the look that has the shown output, and that output.
    pub(crate) fn of(
        &self,
        look: &Look,
        library: &Library,
        ty: Option<&Type>,
    ) -> (Look, (NodePath, PortName)) {
        let mut look = look.clone();
        let own = (self.node.clone(), self.port.clone());
        let Some(code) = ty.and_then(|ty| code(self.style, ty)) else { return (look, own) };
        let Some(from) = led_out(&mut look, library, self.node.ids(), &self.port) else {
            return (look, own);
        };
        let mut node = Node { kind: "wgsl".to_owned(), ..Node::default() };
        node.values.insert("code".into(), Value::Text(code));
        look.graph.nodes.insert(SHOWN.into(), node);
        look.graph.wires.push(Wire { from, to: Endpoint::new(SHOWN, "value") });
        (look, (NodePath::root(SHOWN.into()), "value".into()))
    }

    /// Type of the shown output.
    pub(crate) fn ty(&self, look: &Look, library: &Library, catalog: &Catalog) -> Option<Type> {
        let kind = catalog.of(library.node_of(look, self.node.ids())?.1)?;
        Some(kind.outputs[kind.output(self.port.as_str())?].ty.clone())
    }
}

/// The node whose value an output gives: that of the path, or of a group the node within, through
/// groups in groups, that leads to the output.
pub(crate) fn source_within(
    look: &Look,
    library: &Library,
    path: NodePath,
    port: &PortName,
) -> NodePath {
    let (mut path, mut port) = (path, port.clone());
    // A group that holds itself is an error, which the compiler tells.
    for _ in 0..MOST_DEPTH {
        let found = library.node_of(look, path.ids());
        let group = found.and_then(|(_, node)| library.group_of(look, &node.kind));
        let wire = group.and_then(|group| group.graph.wire_into(&GROUP_OUTPUTS.into(), &port));
        let Some(wire) = wire else { break };
        (path, port) = (path.join(wire.from.node.clone()), wire.from.port.clone());
    }
    path
}

/// Leads an output of an inner node out to the look's own graph: each group on the way becomes, in
/// this copy of the look, one of its own with an output more.
fn led_out(
    look: &mut Look,
    library: &Library,
    path: &[NodeId],
    port: &PortName,
) -> Option<Endpoint> {
    let mut from = Endpoint::new(path.last()?.clone(), port.clone());
    let mut inner_kind: Option<String> = None;
    for depth in (1..path.len()).rev() {
        let (_, holder) = library.node_of(look, &path[..depth])?;
        let mut definition = library.group_of(look, &holder.kind)?.clone();
        if let Some(kind) = inner_kind.take() {
            definition.graph.nodes.get_mut(&path[depth])?.kind = kind;
        }
        definition.outputs.push(InterfacePort { name: SHOWN.into(), ..InterfacePort::default() });
        definition.graph.wires.push(Wire { from, to: Endpoint::new(GROUP_OUTPUTS, SHOWN) });
        let kind = format!("{SHOWN}-{depth}");
        look.definitions.insert(kind.as_str().into(), definition);
        inner_kind = Some(kind);
        from = Endpoint::new(path[depth - 1].clone(), SHOWN);
    }
    if let Some(kind) = inner_kind {
        look.graph.nodes.get_mut(&path[0])?.kind = kind;
    }
    Some(from)
}

/// WGSL of the coloring node; `None` where a value is shown as it is.
fn code(style: Style, ty: &Type) -> Option<String> {
    // A value of any type as a single number: an angle's share of 180 degrees, a color's luminance.
    let (parameter, number) = match ty {
        Type::Angle => ("f32", "value / 3.14159265"),
        ty if ty.convert_to(&Type::Float).is_some() => ("f32", "value"),
        ty if ty.convert_to(&Type::Vec3).is_some() => {
            ("vec3f", "dot(value, vec3f(0.2126, 0.7152, 0.0722))")
        }
        _ => return None,
    };
    let body = match style {
        Style::Color => return None,
        Style::Heat => HEAT,
        Style::Isolines => ISOLINES,
    };
    Some(format!(
        "/// Shown\n///\n/// @param value \"Value\" default=0 : What is shown.\n/// @return \
         value \"Color\" : Its color.\n\
         fn chiaro_shown(value: {parameter}) -> vec3f {{\n    let x = {number};\n{body}}}\n"
    ))
}

const HEAT: &str = "    \
    let bits = bitcast<u32>(x) & 0x7f800000u;
    let warm = vec3f(smoothstep(0.1, 0.6, x), smoothstep(0.4, 1.0, x) * 0.9, 0.35 * \
    smoothstep(0.0, 0.25, x) * (1.0 - smoothstep(0.4, 0.7, x)));
    let above = mix(warm, vec3f(1.0, 0.15, 0.1), smoothstep(1.0, 1.001, x));
    let below = mix(vec3f(0.05, 0.25, 0.55), vec3f(0.55, 0.85, 1.0), clamp(-x, 0.0, 1.0));
    return select(select(above, below, x < 0.0), vec3f(1.0, 0.0, 1.0), bits == 0x7f800000u);
";

const ISOLINES: &str = "    \
    let slope = fwidth(x);
    let width = max(slope, 1e-7);
    let tenth = abs(fract(x * 10.0 - 0.5) - 0.5) / (10.0 * width);
    let whole = abs(fract(x - 0.5) - 0.5) / width;
    let gray = vec3f(0.15 + 0.6 * clamp(x, 0.0, 1.0));
    let fine = mix(vec3f(0.93, 0.64, 0.33), gray, clamp(max(tenth, 10.0 * width * 2.0 - 1.0), 0.0, \
    1.0));
    let lined = mix(vec3f(1.0, 1.0, 1.0), fine, clamp(whole - 0.5, 0.0, 1.0));
    return select(gray, lined, slope > 1e-6);
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_group_gives_out_is_the_value_of_a_node_within() {
        let text = r#"{"nodes": [{"id": "rim", "kind": "light_layer"}, {"id": "own", "kind": "g"}],
          "definitions": {"g": {"outputs": [{"name": "below"}, {"name": "through"}],
            "inputs": [{"name": "through"}], "nodes": [{"id": "inner", "kind": "light_layer"}],
            "wires": [{"from": "inner.below", "to": "outputs.below"},
              {"from": "inputs.through", "to": "outputs.through"}]}}}"#;
        let look = Look::read(text, "test").value.unwrap();
        let source = |path: &str, port: &str| {
            source_within(&look, Library::built_in(), NodePath::parse(path), &port.into())
                .to_string()
        };
        assert_eq!(source("rim", "below"), "rim/blend");
        assert_eq!(source("own", "below"), "own/inner/blend");
        assert_eq!(source("rim/blend", "below"), "rim/blend", "no group");
        assert_eq!(source("own", "through"), "own/inputs", "an input, which has no value here");
        assert_eq!(source("nobody", "below"), "nobody");
    }
}
