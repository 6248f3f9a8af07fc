//! Placement of parts in a look: the edit, and the sentence on what was copied, what the look had
//! already, and what was renamed. Nothing is copied in silence.

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::lights::LitPart;
use super::{PROFILE, PartKind, ends};
use crate::catalog::{Catalog, Port};
use crate::diag::Diagnostic;
use crate::document::{Edit, Endpoint, GraphId, Look, Node, Value, Wire, grouping};
use crate::ids::{DefinitionId, LightId, NodeId, PortName, make_slug};
use crate::library::{Library, Type};
use crate::state::arrangement::{NodeBox, box_of, place_nodes};
use crate::state::problem_text::sentence;
use crate::state::reading::of_library;
use crate::state::stack::BELOW;
use crate::state::stack::tree::{LayerJoint, LayerTree};

/// Distance from one layer to the next on the canvas, in points.
const STEP: f64 = 260.0;

/// Gap below a node that a helper would have covered, in points.
const CLEAR: f32 = 26.0;

/// Placed part.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Placement {
    pub(crate) edit: Edit,
    /// Nodes to select.
    pub(crate) nodes: Vec<NodeId>,
    /// Sentence on what was done.
    pub(crate) told: String,
}

/// Look that a part is placed in.
#[derive(Clone, Copy)]
pub(crate) struct Recipient<'a> {
    pub(crate) look: &'a Look,
    pub(crate) catalog: &'a Catalog,
    pub(crate) library: &'a Library,
}

impl Recipient<'_> {
    /// The catalog of the look after an edit.
    fn catalog_of(self, trial: &Look) -> Catalog {
        let mut catalog = Catalog::new(self.library);
        catalog.sync(trial, self.library);
        catalog
    }
}

/// Lays the layers of a part over a layer of a look, or on top of all.
///
/// # Errors
/// The reason why they cannot be laid there.
pub(crate) fn layer(
    to: Recipient<'_>,
    (name, part): (&str, &Look),
    over: Option<&NodeId>,
) -> Result<Placement, String> {
    let tree = LayerTree::of(to.look, to.catalog);
    if !tree.has_output() {
        return Err(tr!("The look has no Output node, so that no layer can be laid on").to_owned());
    }
    let found = over.and_then(|id| tree.joint_over(Some(id))).or_else(|| tree.joint_over(None));
    let joint = found.ok_or(tr!("There is no stack to lay it on"))?;
    let below = joint.from.as_ref().map(|from| title(to, &from.node));
    let told = match below {
        Some(below) => tr!("\"{name}\" is copied into this look, over {below}"),
        None => tr!("\"{name}\" is copied into this look"),
    };
    between(to, (name, part), joint, told)
}

/// Puts a part into a wire of the look's own graph.
///
/// # Errors
/// The reason why it does not fit there.
pub(crate) fn in_wire(
    to: Recipient<'_>,
    (name, part): (&str, &Look),
    wire: &Wire,
) -> Result<Placement, String> {
    let [below, above] = [&wire.from, &wire.to].map(|end| title(to, &end.node));
    let told = tr!("\"{name}\" is copied into this look, between {below} and {above}");
    let (from, into) = (Some(wire.from.clone()), wire.to.clone());
    between(to, (name, part), LayerJoint { from, into, others: Vec::new() }, told)
}

/// Puts a part between an output and inputs, where there is room made for it; `told` says so.
fn between(
    to: Recipient<'_>,
    (name, part): (&str, &Look),
    LayerJoint { from, into, others }: LayerJoint,
    told: String,
) -> Result<Placement, String> {
    // Groups of the part may have other names in the trial.
    let own = to.catalog_of(part);
    let lit = LitPart::new(to.look, &placed(to, part), &own);
    let part = &lit.look;
    let pasted = paste(to.look, &GraphId::Look, part, None)?;
    let mut trial = to.look.clone();
    trial.apply(pasted.edit.clone()).map_err(|problem| problem.message)?;
    let catalog = to.catalog_of(&trial);
    let ends = ends(part, &own);
    let here = |id: &NodeId| {
        let index = part.graph.nodes.get_index_of(id)?;
        pasted.nodes.get(index).cloned()
    };
    let (inlet, outlet) = match ends {
        Some([bottom, top]) => (
            here(bottom).map(|id| Endpoint::new(id, BELOW)),
            here(top).map(|id| Endpoint::new(id, BELOW)),
        ),
        None => through(&trial, &catalog, &pasted.nodes, from.as_ref(), &into),
    };
    let (Some(inlet), Some(outlet)) = (inlet, outlet) else {
        return Err(tr!(
            "\"{name}\" does not fit there: it has no free input and output of the wire's type"
        ));
    };
    let mut edits = vec![pasted.edit];
    let mut positions = room(to.look, &trial, (&pasted.nodes, &outlet.node), from.as_ref(), &into);
    let is_helper = |id: &&NodeId| {
        let kind = trial.graph.nodes.get(*id).and_then(|node| catalog.of(node));
        ![&inlet.node, &outlet.node].contains(id)
            && kind.is_none_or(|kind| kind.output(BELOW).is_none())
    };
    let helpers: Vec<&NodeId> = pasted.nodes.iter().filter(is_helper).collect();
    uncover(&trial, &catalog, &helpers, &mut positions);
    edits.push(Edit::MoveNodes { graph: GraphId::Look, positions });
    // What is one layer is called as the part is.
    let is_layer = ends.is_some_and(|[bottom, top]| bottom == top);
    edits.extend(rename(to.look, &trial, &outlet.node, is_layer.then_some(name)));
    let below = from.map(|from| Wire { from, to: inlet });
    let above = std::iter::once(into).chain(others);
    let above = above.map(|to| Wire { from: outlet.clone(), to });
    edits.extend(below.into_iter().chain(above).map(|wire| Edit::AddWire {
        graph: GraphId::Look,
        wire,
        index: None,
    }));
    let told = told + &along(to, &lit);
    // The layer itself is selected, as that is what is set next.
    Ok(Placement { edit: Edit::Group { edits }, nodes: vec![outlet.node], told })
}

/// Adds the nodes of a part to a graph, or a node of its group.
///
/// # Errors
/// The reason why they cannot be added.
pub(crate) fn nodes(
    to: Recipient<'_>,
    graph: &GraphId,
    (name, part): (&str, &Look),
    at: [f64; 2],
) -> Result<Placement, String> {
    let part = &with_node_of_group(&placed(to, part), name);
    let lit = LitPart::new(to.look, part, &to.catalog_of(part));
    let pasted = paste(to.look, graph, &lit.look, Some(at))?;
    let told = tr!("\"{name}\" is copied into this look") + &along(to, &lit);
    Ok(Placement { edit: pasted.edit, nodes: pasted.nodes, told })
}

/// Adds the nodes of a text, such as the clipboard's, to a graph, lit as those of a part are: by
/// the look's own lights where these do the same work, else by lights that come along. The
/// sentence names those; it is empty where there are none.
///
/// # Errors
/// A diagnostic where the text is no look, or holds nothing to add.
pub(crate) fn of_text(
    to: Recipient<'_>,
    graph: &GraphId,
    text: &str,
    at: Option<[f64; 2]>,
) -> Result<(grouping::PastedFragment, String), Box<Diagnostic>> {
    let part = text.trim_start().starts_with('{').then(|| Look::read(text, "clipboard").value);
    let Some(mut part) = part.flatten() else {
        return Ok((grouping::paste_text(to.look, graph, text, at)?, String::new()));
    };
    let placed = place_nodes(&mut part, to.library).then(|| part.to_text());
    if part.lights.is_empty() {
        let text = placed.as_deref().unwrap_or(text);
        return Ok((grouping::paste_text(to.look, graph, text, at)?, String::new()));
    }
    let lit = LitPart::new(to.look, &part, &to.catalog_of(&part));
    let pasted = grouping::paste_text(to.look, graph, &lit.look.to_text(), at)?;
    let told = match lit.brought.is_empty() {
        true => String::new(),
        false => tr!("Pasted").to_owned() + &lit.told(),
    };
    Ok((pasted, told))
}

/// A part whose nodes have places.
fn placed(to: Recipient<'_>, part: &Look) -> Look {
    let mut part = part.clone();
    place_nodes(&mut part, to.library);
    part
}

/// A part that holds groups alone, with a node of the last one, which uses the others.
pub(super) fn with_node_of_group(part: &Look, name: &str) -> Look {
    let mut part = part.clone();
    if part.graph.nodes.is_empty()
        && let Some((id, _)) = part.definitions.last()
    {
        let node = Node { kind: id.to_string(), name: name.to_owned(), ..Node::default() };
        part.graph.nodes.insert(NodeId::from(id.as_str()), node);
    }
    part
}

/// Sets up a look's lights as a part has them: those of the same id are set anew, others are added.
///
/// # Errors
/// The reason why there is nothing to set up.
pub(crate) fn lights(look: &Look, (name, part): (&str, &Look)) -> Result<Placement, String> {
    let (mut edits, mut set, mut added) = (Vec::new(), Vec::new(), Vec::new());
    let shown = |id: &LightId| {
        part.lights.get(id).map_or(id.as_str(), |light| light.display_name(id)).to_owned()
    };
    for (id, light) in &part.lights {
        match look.lights.get(id) {
            Some(own) if own == light => {}
            Some(_) => {
                set.push(shown(id));
                edits.push(Edit::SetLight { id: id.clone(), light: light.clone() });
            }
            None => {
                added.push(shown(id));
                let (id, light) = (id.clone(), light.clone());
                edits.push(Edit::AddLight { id, light, index: None });
            }
        }
    }
    if edits.is_empty() {
        return Err(tr!("This look has the lights of \"{name}\" already"));
    }
    let mut told = vec![tr!("\"{name}\" is copied into this look")];
    if !set.is_empty() {
        told.push(tr!("set anew: {lights}", lights = set.join(", ")));
    }
    if !added.is_empty() {
        told.push(tr!("added: {lights}", lights = added.join(", ")));
    }
    let others: Vec<&str> = look
        .lights
        .iter()
        .filter(|(id, _)| !part.lights.contains_key(*id))
        .map(|(id, light)| light.display_name(id))
        .collect();
    if !others.is_empty() {
        told.push(tr!("as they were: {lights}", lights = others.join(", ")));
    }
    let told = told.join(" · ");
    Ok(Placement { edit: Edit::Group { edits }, nodes: Vec::new(), told })
}

/// Values of a profile or a ramp for a node of a kind: by name, and a ramp or a curve also for the
/// only input of that type, or for `port`. Empty where the node takes none of them.
pub(crate) fn values(
    to: Recipient<'_>,
    node: &Node,
    part: &Look,
    port: Option<&PortName>,
) -> Vec<(PortName, Value)> {
    let (Some(source), Some(kind)) = (part.graph.nodes.values().next(), to.catalog.of(node)) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for (name, value) in &source.values {
        let ty = match value {
            Value::Ramp(_) => Some(Type::Ramp),
            Value::Curve(_) => Some(Type::Curve),
            _ => None,
        };
        let input = match &ty {
            Some(ty) => {
                let fits = |input: &&crate::catalog::Port| {
                    input.ty == *ty && port.is_none_or(|port| *port == input.name)
                };
                kind.inputs.iter().find(fits)
            }
            None if PROFILE.contains(&name.as_str()) => {
                kind.inputs.iter().find(|input| input.name == *name)
            }
            None => None,
        };
        found.extend(input.map(|input| (input.name.clone(), value.clone())));
    }
    found
}

fn paste(
    look: &Look,
    graph: &GraphId,
    part: &Look,
    at: Option<[f64; 2]>,
) -> Result<grouping::PastedFragment, String> {
    grouping::paste_text(look, graph, &part.to_text(), at).map_err(|problem| sentence(&problem))
}

/// Free input and output of placed nodes by which they can be put between two others.
fn through(
    trial: &Look,
    catalog: &Catalog,
    nodes: &[NodeId],
    from: Option<&Endpoint>,
    into: &Endpoint,
) -> (Option<Endpoint>, Option<Endpoint>) {
    let port_of = |end: &Endpoint, is_output: bool| {
        let kind = catalog.of(trial.graph.nodes.get(&end.node)?)?;
        let (ports, index) = match is_output {
            true => (&kind.outputs, kind.output(end.port.as_str())?),
            false => (&kind.inputs, kind.input(end.port.as_str())?),
        };
        Some(ports[index].clone())
    };
    let kinds =
        || nodes.iter().filter_map(|id| Some((id, catalog.of(trial.graph.nodes.get(id)?)?)));
    // What a stack converts to is not what an artist means by putting a part into one.
    let takes = |port: &Port, ty: &Type| match [&port.ty, ty].contains(&&Type::Composite) {
        true => port.ty == *ty,
        false => port.takes(ty),
    };
    let is_wired = |end: &Endpoint| trial.graph.wire_into(&end.node, &end.port).is_some();
    let inlet = from.and_then(|from| {
        let ty = port_of(from, true)?.ty;
        kinds().find_map(|(id, kind)| {
            let input = |exact: bool| {
                kind.inputs.iter().find(|port| {
                    port.is_wirable()
                        && (if exact { port.ty == ty } else { takes(port, &ty) })
                        && !is_wired(&Endpoint::new(id.clone(), port.name.clone()))
                })
            };
            let port = input(true).or_else(|| input(false))?;
            Some(Endpoint::new(id.clone(), port.name.clone()))
        })
    });
    let outlet = port_of(into, false).and_then(|target| {
        kinds().collect::<Vec<_>>().into_iter().rev().find_map(|(id, kind)| {
            let is_used = trial.graph.wires.iter().any(|wire| wire.from.node == *id);
            let port = kind.outputs.iter().find(|port| !is_used && takes(&target, &port.ty))?;
            Some(Endpoint::new(id.clone(), port.name.clone()))
        })
    });
    (inlet, outlet)
}

/// Moves of nodes, so that placed ones lie between two others, with the last on their level: what
/// lies to the right of them is moved on.
fn room(
    look: &Look,
    trial: &Look,
    (placed, last): (&[NodeId], &NodeId),
    from: Option<&Endpoint>,
    into: &Endpoint,
) -> IndexMap<NodeId, [f64; 2]> {
    let place = |id: &NodeId| trial.graph.nodes.get(id).map(|node| node.position);
    let (Some(target), Some(last)) = (place(&into.node), place(last)) else {
        return IndexMap::new();
    };
    let xs = || placed.iter().filter_map(place).map(|[x, _]| x);
    let (least, most) = (xs().fold(f64::MAX, f64::min), xs().fold(f64::MIN, f64::max));
    let begin = from.and_then(|from| place(&from.node)).unwrap_or([target[0] - STEP, target[1]]);
    let by = [begin[0] + STEP - least, begin[1] - last[1]];
    let mut positions: IndexMap<NodeId, [f64; 2]> = IndexMap::new();
    for id in placed {
        if let Some([x, y]) = place(id) {
            positions.insert(id.clone(), [x + by[0], y + by[1]]);
        }
    }
    let lack = most + by[0] + STEP - target[0];
    if lack > 0.0 {
        for (id, node) in look.graph.nodes.iter().filter(|(_, node)| node.position[0] >= target[0])
        {
            positions.insert(id.clone(), [node.position[0] + lack, node.position[1]]);
        }
    }
    positions
}

/// Moves the nodes `helpers`, which work for placed layers, down from the nodes that they would
/// cover; `positions` are the places of those that move in any case.
fn uncover(
    look: &Look,
    catalog: &Catalog,
    helpers: &[&NodeId],
    positions: &mut IndexMap<NodeId, [f64; 2]>,
) {
    let placed = |id: &NodeId| {
        let mut node = look.graph.nodes.get(id)?.clone();
        node.position = positions.get(id).copied().unwrap_or(node.position);
        Some(box_of(&node, catalog.of(&node).map(|kind| &**kind)))
    };
    let others = look.graph.nodes.keys().filter(|id| !helpers.contains(id));
    let mut taken: Vec<NodeBox> = others.filter_map(placed).collect();
    let mut moved = Vec::new();
    for &id in helpers {
        let Some(mut own) = placed(id) else { continue };
        let before = own;
        // Each step goes below one of the boxes, which is then out of the way for good.
        while let Some(other) = taken.iter().find(|other| other.overlaps(&own)) {
            own.min[1] = other.max(1) + CLEAR;
        }
        if own != before {
            moved.push((id.clone(), own.min.map(f64::from)));
        }
        taken.push(own);
    }
    positions.extend(moved);
}

/// Name for a placed node: the part's or its own, with a number where a node of the look has it.
fn rename(look: &Look, trial: &Look, id: &NodeId, part: Option<&str>) -> Option<Edit> {
    let own = &trial.graph.nodes.get(id)?.name;
    let name = part.map(str::trim).filter(|name| !name.is_empty()).unwrap_or(own);
    let is_taken = |name: &str| look.graph.nodes.values().any(|node| node.name == name);
    let numbered = || (2..).map(|number| format!("{name} {number}")).find(|name| !is_taken(name));
    let name = if name.is_empty() || !is_taken(name) { name.to_owned() } else { numbered()? };
    (name != *own).then(|| Edit::SetName { graph: GraphId::Look, id: id.clone(), name })
}

/// Display name of a node of the look's own graph.
fn title(to: Recipient<'_>, id: &NodeId) -> String {
    let Some(node) = to.look.graph.nodes.get(id) else { return id.to_string() };
    let kind = to.catalog.of(node).filter(|_| node.name.is_empty());
    match kind {
        Some(kind) => of_library(&kind.label).to_owned(),
        None if node.name.is_empty() => id.to_string(),
        None => node.name.clone(),
    }
}

/// Words on the lights, groups and nodes of a part: new ones, and those that the look has.
fn along(to: Recipient<'_>, lit: &LitPart) -> String {
    let part = &lit.look;
    let mut told = lit.told();
    let mut tell = |what: fn(String) -> String, names: Vec<String>| {
        if !names.is_empty() {
            told += " · ";
            told += &what(names.join(", "));
        }
    };
    let group = |id: &DefinitionId| {
        part.definitions.get(id).map_or_else(String::new, |definition| {
            if definition.label.is_empty() { id.to_string() } else { definition.label.clone() }
        })
    };
    let (known, new): (Vec<_>, Vec<_>) =
        part.definitions.keys().partition(|id| to.look.definitions.contains_key(*id));
    tell(|names| tr!("with its group {names}"), new.into_iter().map(group).collect());
    let (same, renamed): (Vec<_>, Vec<_>) =
        known.into_iter().partition(|id| to.look.definitions.get(*id) == part.definitions.get(*id));
    tell(|names| tr!("uses this look's group {names}"), same.into_iter().map(group).collect());
    tell(
        |names| tr!("under another name, as this look has another one, {names}"),
        renamed.into_iter().map(group).collect(),
    );
    let lacks: Vec<String> = part
        .graph
        .nodes
        .values()
        .filter(|node| {
            let is_own = part.definitions.contains_key(node.kind.as_str());
            !is_own && to.catalog.of(node).is_none_or(|kind| kind.is_missing)
        })
        .map(|node| node.kind.clone())
        .collect();
    tell(|names| tr!("lacks here: the node {names}"), lacks);
    told
}

/// Look on which a part is shown; `None` where there is nothing to see.
pub(crate) fn shown(part: &Look, kind: PartKind) -> Option<Look> {
    const BASE: &str = r##"{"lights": {"key": {"direction": [-0.5, 0.7, 0.6]}}, "nodes": [
        {"id": "base", "kind": "base", "values": {"color": "#8d8377"}},
        {"id": "output", "kind": "output"}],
      "wires": [{"from": "base", "to": "output.color"}]}"##;
    const PROFILED: &str = r##"{"lights": {"key": {"direction": [-0.5, 0.7, 0.6]}}, "nodes": [
        {"id": "base", "kind": "base", "values": {"color": "#1e1c24"}},
        {"id": "layer", "kind": "light_layer", "values": {"light": "key", "convex": "#e8d9c2",
          "concave": "#e8d9c2", "blend": "alpha"}},
        {"id": "output", "kind": "output"}],
      "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}]}"##;
    let read = |text: &str| Look::read(text, "shown").value;
    let library = Library::built_in();
    match kind {
        PartKind::Look => Some(part.clone()),
        PartKind::Layer => {
            let mut look = read(BASE)?;
            look.color_space = part.color_space;
            // The part's own lights, and not those of the look that it is shown on.
            look.lights.clone_from(&part.lights);
            let mut catalog = Catalog::new(library);
            catalog.sync(&look, library);
            let to = Recipient { look: &look, catalog: &catalog, library };
            let placed = layer(to, ("", part), None).ok()?;
            look.apply(placed.edit).ok()?;
            Some(look)
        }
        PartKind::Profile => {
            let mut look = read(PROFILED)?;
            let source = part.graph.nodes.values().next()?;
            let layer = look.graph.nodes.get_mut("layer")?;
            for name in PROFILE {
                layer.values.insert(name.into(), source.values.get(name)?.clone());
            }
            Some(look)
        }
        PartKind::Lights => {
            let mut look = read(BASE)?;
            look.graph
                .nodes
                .get_mut("base")?
                .values
                .insert("color".into(), Value::Text("#14131a".to_owned()));
            look.lights.clone_from(&part.lights);
            look.color_space = part.color_space;
            let mut below = Endpoint::new("base", "");
            // As many as a small picture tells apart.
            for (index, id) in part.lights.keys().take(6).enumerate() {
                let name = NodeId::new(make_slug(&format!("layer_{index}"), |slug| {
                    look.graph.nodes.contains_key(slug)
                }));
                let mut node = Node { kind: "light_layer".to_owned(), ..Node::default() };
                node.values.insert("light".into(), Value::Text(id.to_string()));
                look.graph.nodes.insert(name.clone(), node);
                look.graph.wires.push(Wire { from: below, to: Endpoint::new(name.clone(), BELOW) });
                below = Endpoint::new(name, BELOW);
            }
            look.graph.wires.retain(|wire| wire.to.node.as_str() != "output");
            look.graph.wires.push(Wire { from: below, to: Endpoint::new("output", "color") });
            Some(look)
        }
        PartKind::Nodes | PartKind::Group | PartKind::Ramp => None,
    }
}
