//! Terms as XML of MaterialX: each a node with the name that the artist or the library gave it.

use std::collections::HashSet;
use std::fmt::Write as _;

use super::super::inputs::NodeInput;
use super::super::literal;
use super::super::source::GIVEN;
use super::StandardGraph;
use super::operations::inputs_of;
use super::terms::{Origin, TermId, Terms};

/// Types of MaterialX by the count of their numbers.
const TYPES: [&str; 5] = ["", "float", "vector2", "vector3", "color4"];

/// Names that nodes must not have: those of the outputs.
const OUTPUTS: [&str; 4] = ["out_color", "out_opacity", "color", "opacity"];

impl Terms {
    /// The terms that results are made of, in their order.
    pub(super) fn used(&self, results: &[TermId]) -> Vec<TermId> {
        let mut is_used = vec![false; self.list.len()];
        let mut open = results.to_vec();
        while let Some(id) = open.pop() {
            if !std::mem::replace(&mut is_used[id.0], true) {
                open.extend(&self.term(id).sources);
            }
        }
        (0..self.list.len()).filter(|place| is_used[*place]).map(TermId).collect()
    }
}

/// Writes the graph.
pub(super) fn write(
    terms: &Terms,
    node: &str,
    inputs: &[NodeInput<'_>],
    color: [TermId; 3],
    opacity: TermId,
) -> StandardGraph {
    let used = terms.used(&[&color[..], &[opacity]].concat());
    let mut writer = Writer { terms, inputs, names: vec![String::new(); terms.list.len()] };
    let mut taken: HashSet<String> = inputs.iter().map(|input| input.name.to_owned()).collect();
    taken.extend(OUTPUTS.map(str::to_owned));
    for id in &used {
        let wanted = writer.wanted_name(*id);
        let mut name = wanted.clone();
        let mut number = 2;
        while !taken.insert(name.clone()) {
            name = format!("{wanted}_{number}");
            number += 1;
        }
        writer.names[id.0] = name;
    }
    let mut text = format!("  <nodegraph name=\"NG_{node}_standard\" nodedef=\"ND_{node}\">\n");
    let (mut group, mut nodes) = ("", 2);
    for id in used {
        let own = terms.groups[id.0].as_str();
        let element = writer.node(id);
        if element.is_empty() {
            continue;
        }
        if own != group && !own.is_empty() {
            let _ = writeln!(text, "\n    <!-- {} -->", own.replace('_', " "));
        } else if own != group {
            text.push('\n');
        }
        group = own;
        text += &element;
        nodes += 1;
    }
    let channels = color.iter().enumerate();
    let channels: String = channels
        .map(|(place, id)| format!("      {}\n", writer.source(&format!("in{}", place + 1), *id)))
        .collect();
    let _ = write!(
        text,
        "\n    <combine3 name=\"color\" type=\"color3\">\n{channels}    </combine3>\n    \
         <dot name=\"opacity\" type=\"float\">\n      {}\n    </dot>\n    \
         <output name=\"out_color\" type=\"color3\" nodename=\"color\" />\n    \
         <output name=\"out_opacity\" type=\"float\" nodename=\"opacity\" />\n  \
         </nodegraph>\n",
        writer.source("in", opacity)
    );
    StandardGraph { text, nodes }
}

struct Writer<'a> {
    terms: &'a Terms,
    inputs: &'a [NodeInput<'a>],
    names: Vec<String>,
}

impl Writer<'_> {
    /// Name for a term: the source's, behind that of the artist's node.
    fn wanted_name(&self, id: TermId) -> String {
        let term = self.terms.term(id);
        let (own, group) = (&self.terms.names[id.0], &self.terms.groups[id.0]);
        let word = |text: &str| text.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
        if let Origin::Given(name) = term.origin {
            return name.to_owned();
        }
        let own = match (&term.origin, own.is_empty()) {
            (_, false) => word(own),
            (Origin::Component(place), _) => {
                let source = match &self.terms.term(term.sources[0]).origin {
                    Origin::Input(place) => self.inputs[*place].name,
                    _ => self.names[term.sources[0].0].as_str(),
                };
                return format!("{source}_{}", ["x", "y", "z", "w"][*place]);
            }
            (Origin::Node(kind), _) => match *kind {
                "ifgreater" | "ifgreatereq" | "ifequal" => "choice".to_owned(),
                kind => kind.to_owned(),
            },
            _ => String::new(),
        };
        match group.is_empty() || *group == own {
            true => own,
            false => format!("{}_{own}", word(group)),
        }
    }

    /// Type of a term.
    fn ty(&self, id: TermId) -> &'static str {
        let term = self.terms.term(id);
        match term.origin {
            Origin::Input(place) => self.inputs[place].ty.0,
            _ => TYPES[term.width],
        }
    }

    /// Element of an input that has a term for its source.
    fn source(&self, name: &str, id: TermId) -> String {
        let head = format!("<input name=\"{name}\" type=\"{}\"", self.ty(id));
        if let Some(numbers) = self.terms.known(id) {
            return format!("{head} value=\"{}\" />", literal::list(&numbers));
        }
        match self.terms.term(id).origin {
            Origin::Input(place) => {
                format!("{head} interfacename=\"{}\" />", self.inputs[place].name)
            }
            _ => format!("{head} nodename=\"{}\" />", self.names[id.0]),
        }
    }

    /// Element of a term; empty for what stands in others' inputs.
    fn node(&self, id: TermId) -> String {
        let term = self.terms.term(id);
        let mut inputs = Vec::new();
        let element = match &term.origin {
            Origin::Constant(_) | Origin::Input(_) => return String::new(),
            Origin::Given(name) => {
                let of_view = ("viewdirection", Some("world"));
                let given = GIVEN.iter().find(|given| given.name == *name);
                let (element, space) = given.map_or(of_view, |given| given.node);
                if let Some(space) = space {
                    inputs.push(format!(
                        "<input name=\"space\" type=\"string\" value=\"{space}\" />"
                    ));
                }
                element.to_owned()
            }
            Origin::Component(place) => {
                inputs.push(self.source("in", term.sources[0]));
                inputs.push(format!("<input name=\"index\" type=\"integer\" value=\"{place}\" />"));
                "extract".to_owned()
            }
            Origin::Node(kind) => {
                let names = inputs_of(kind, term.sources.len());
                let sources = names.iter().zip(&term.sources);
                inputs.extend(sources.map(|(name, id)| self.source(name, *id)));
                if *kind == "ifequal" && term.sources.len() == 3 {
                    let on = "<input name=\"value2\" type=\"boolean\" value=\"true\" />";
                    inputs.insert(1, on.to_owned());
                }
                match *kind {
                    "combine" => format!("combine{}", term.width),
                    kind => kind.to_owned(),
                }
            }
        };
        let head = format!("    <{element} name=\"{}\" type=\"{}\"", self.names[id.0], self.ty(id));
        if inputs.is_empty() {
            return format!("{head} />\n");
        }
        let inputs: String = inputs.iter().map(|input| format!("      {input}\n")).collect();
        format!("{head}>\n{inputs}    </{element}>\n")
    }
}
