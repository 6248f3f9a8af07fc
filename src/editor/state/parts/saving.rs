//! Parts of a look for the library, and their files.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use chiaro_locale::{tr, trn};

use super::pictures::{MovedPictures, PictureRoute};
use super::{PROFILE, PartKind};
use crate::catalog::{Catalog, values};
use crate::document::{Graph, Look, Node, Target, Value, grouping};
use crate::files::{Disk, Files as _, make_folder, write_atomic};
use crate::ids::{DefinitionId, NodeId, PortName, make_slug};
use crate::library::{Library, Type};
use crate::state::stack::{BELOW, Stack};

/// Part of a look that is to be kept.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PartChoice {
    Look,
    /// Layers of the look, with the nodes that feed them.
    Layers(Vec<NodeId>),
    /// Nodes of the graph that is open.
    Nodes(Vec<NodeId>),
    Group(DefinitionId),
    Lights,
    /// Profile of a node of the graph that is open.
    Profile(NodeId),
    /// Ramp of an input of a node of the graph that is open.
    Ramp(NodeId, PortName),
}

/// Part that is about to be saved.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PartDraft {
    pub(crate) kind: PartKind,
    /// The part, with a name, tags and a description to begin with.
    pub(crate) look: Look,
    /// Notes on parts of the look that do not go along.
    pub(crate) notes: Vec<String>,
}

/// Look that a part is made of.
#[derive(Clone, Copy)]
pub(crate) struct PartSource<'a> {
    pub(crate) look: &'a Look,
    /// Graph that is open: the look's own, or that of a group.
    pub(crate) graph: &'a Graph,
    pub(crate) catalog: &'a Catalog,
}

impl PartSource<'_> {
    /// Draft of a part.
    ///
    /// # Errors
    /// The reason why there is nothing to keep.
    pub(crate) fn draft(self, choice: &PartChoice) -> Result<PartDraft, String> {
        let Self { look, graph, .. } = self;
        let (kind, mut part, name) = match choice {
            PartChoice::Look => (PartKind::Look, look.clone(), look.name.clone()),
            PartChoice::Layers(ids) => {
                let nodes = self.with_feeders(ids);
                let name = ids.first().map_or_else(String::new, |id| self.title(&look.graph, id));
                (PartKind::Layer, self.fragment(&look.graph, &nodes)?, name)
            }
            PartChoice::Nodes(ids) => {
                let name = ids.last().map_or_else(String::new, |id| self.title(graph, id));
                (PartKind::Nodes, self.fragment(graph, ids)?, name)
            }
            PartChoice::Group(id) => self.group(id)?,
            PartChoice::Lights => {
                if look.lights.is_empty() {
                    return Err(tr!("The look has no lights to keep").to_owned());
                }
                let lights = look.lights.clone();
                let part = Look { lights, color_space: look.color_space, ..Look::default() };
                (PartKind::Lights, part, format!("Lights of {}", look.name))
            }
            PartChoice::Profile(id) => {
                let (part, name) = self.values_of(id, |name| PROFILE.contains(&name.as_str()))?;
                (PartKind::Profile, part, name)
            }
            PartChoice::Ramp(id, port) => {
                let (part, name) = self.values_of(id, |name| name == port)?;
                (PartKind::Ramp, part, name)
            }
        };
        let notes = self.left(&part, choice);
        // What the part is follows from its content alone.
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&part, Library::built_in());
        let kind = PartKind::of(&part, &catalog).unwrap_or(kind);
        part.name = name;
        Ok(PartDraft { kind, look: part, notes })
    }

    fn title(self, graph: &Graph, id: &NodeId) -> String {
        let Some(node) = graph.nodes.get(id) else { return id.to_string() };
        let kind = || self.catalog.of(node).map(|kind| kind.label.to_string());
        if node.name.is_empty() { kind().unwrap_or_default() } else { node.name.clone() }
    }

    fn fragment(self, graph: &Graph, nodes: &[NodeId]) -> Result<Look, String> {
        let there: Vec<NodeId> = nodes
            .iter()
            .filter(|id| graph.nodes.get(*id).is_some_and(|node| node.kind != "output"))
            .cloned()
            .collect();
        if there.is_empty() {
            return Err(tr!("Nothing that can be kept is selected").to_owned());
        }
        let text = grouping::copy_text(self.look, graph, &there, &[]);
        Look::read(&text, "part").value.ok_or_else(|| tr!("The nodes cannot be written").to_owned())
    }

    fn group(self, id: &DefinitionId) -> Result<(PartKind, Look, String), String> {
        let definition = self.look.definitions.get(id).ok_or(tr!("The look has no such group"))?;
        let mut graph = Graph::default();
        let node = Node { kind: id.to_string(), ..Node::default() };
        graph.nodes.insert(NodeId::from(id.as_str()), node);
        // The groups that it uses go along; its own node does not.
        let text = grouping::copy_text(self.look, &graph, &[NodeId::from(id.as_str())], &[]);
        let mut part = Look::read(&text, "part").value.ok_or(tr!("The group cannot be written"))?;
        part.graph.nodes.clear();
        if let Some(index) = part.definitions.get_index_of(id) {
            part.definitions.move_index(index, part.definitions.len() - 1);
        }
        let name =
            if definition.label.is_empty() { id.to_string() } else { definition.label.clone() };
        Ok((PartKind::Group, part, name))
    }

    /// Node with nothing but some of a node's values, as they are without keys.
    fn values_of(
        self,
        id: &NodeId,
        is_kept: impl Fn(&PortName) -> bool,
    ) -> Result<(Look, String), String> {
        let none = || tr!("The node has no such value to keep").to_owned();
        let node = self.graph.nodes.get(id).ok_or_else(none)?;
        let kind = self.catalog.of(node).ok_or_else(none)?;
        let kept: Vec<(PortName, Value)> = kind
            .inputs
            .iter()
            .filter(|port| is_kept(&port.name))
            .filter_map(|port| {
                let value = values::current(port, node.values.get(&port.name))?.clone();
                Some((port.name.clone(), value))
            })
            .collect();
        if kept.is_empty() {
            return Err(none());
        }
        let is_ramp = kept.iter().any(|(_, value)| matches!(value, Value::Ramp(_)));
        let kind = if is_ramp { "ramp" } else { "profile" };
        let mut bare = Node { kind: kind.to_owned(), ..Node::default() };
        bare.values.extend(
            kept.into_iter()
                .map(|(name, value)| (if is_ramp { PortName::from("ramp") } else { name }, value)),
        );
        let mut part = Look { color_space: self.look.color_space, ..Look::default() };
        part.graph.nodes.insert(NodeId::from(kind), bare);
        Ok((part, self.title(self.graph, id)))
    }

    /// Layers and all nodes that feed them, but for the stack that they lie on and other layers.
    fn with_feeders(self, ids: &[NodeId]) -> Vec<NodeId> {
        let graph = &self.look.graph;
        let stack = Stack::of(self.look, self.catalog);
        let mut others: HashSet<&NodeId> = stack.layers.iter().map(|layer| &layer.id).collect();
        others.extend(stack.ground.iter().map(|ground| &ground.node));
        let mut all: Vec<NodeId> = ids.to_vec();
        let mut next = 0;
        while let Some(id) = all.get(next).cloned() {
            let is_layer = others.contains(&id);
            let into = graph
                .wires
                .iter()
                .filter(|wire| wire.to.node == id && !(is_layer && wire.to.port.as_str() == BELOW));
            for wire in into {
                let from = &wire.from.node;
                if !others.contains(from) && !all.contains(from) {
                    all.push(from.clone());
                }
            }
            next += 1;
        }
        all
    }

    /// Notes on parts of the look that do not go along.
    fn left(self, part: &Look, choice: &PartChoice) -> Vec<String> {
        if *choice == PartChoice::Look {
            return Vec::new();
        }
        let mut notes = Vec::new();
        let is_of_part = |target: &Target| match target {
            Target::Input { node, .. } => {
                node.ids().first().is_some_and(|id| part.graph.nodes.contains_key(id))
            }
            Target::Light { light, .. } => part.lights.contains_key(light),
        };
        let mut targets = self.look.time_keys.iter().map(|keys| &keys.target).chain(
            self.look
                .direction_keys
                .iter()
                .flat_map(|keys| &keys.keys)
                .flat_map(|key| key.values.keys()),
        );
        if targets.any(is_of_part) {
            notes.push(tr!("Keys stay with this look").to_owned());
        }
        let graph = match choice {
            PartChoice::Nodes(_) => self.graph,
            _ => &self.look.graph,
        };
        let open = graph.wires.iter().filter(|wire| {
            let nodes = &part.graph.nodes;
            nodes.contains_key(&wire.to.node)
                && wire.to.port.as_str() != BELOW
                && !nodes.contains_key(&wire.from.node)
        });
        match open.count() {
            0 => {}
            count => notes.push(trn!(
                count,
                "A wire from outside of it is left out",
                "{count} wires from outside of it are left out"
            )),
        }
        let built_in = Library::built_in();
        let mut lacks: Vec<&str> = part
            .graph
            .nodes
            .values()
            .map(|node| node.kind.as_str())
            .filter(|kind| !part.definitions.contains_key(*kind))
            .filter(|kind| {
                !built_in.nodes.contains_key(*kind) && !built_in.groups.contains_key(*kind)
            })
            .filter(|kind| *kind != crate::catalog::CUSTOM_KIND)
            .collect();
        lacks.dedup();
        if !lacks.is_empty() {
            notes.push(tr!("Needs nodes of this project: {nodes}", nodes = lacks.join(", ")));
        }
        notes
    }
}

/// Ports with ramps of a node, and true for a node with a profile.
pub(crate) fn keepable(catalog: &Catalog, node: &Node) -> (Vec<PortName>, bool) {
    let Some(kind) = catalog.of(node) else { return (Vec::new(), false) };
    let ramps = kind.inputs.iter().filter(|port| port.ty == Type::Ramp);
    let has_profile = PROFILE.iter().all(|name| kind.input(name).is_some());
    (ramps.map(|port| port.name.clone()).collect(), has_profile)
}

/// Writes a part to a new file of a folder, which is made if need be. `from` is the folder that the
/// look's images are named from. Returns the file, and a sentence on what was done.
///
/// # Errors
/// The reason why the file cannot be written.
pub(crate) fn save(
    draft: &PartDraft,
    folder: &Path,
    from: Option<&Path>,
    catalog: &Catalog,
) -> Result<(PathBuf, String), String> {
    let name = named(draft)?;
    make_folder(folder).map_err(|problem| format!("{}: {}", folder.display(), problem.message))?;
    let file_of = |slug: &str| folder.join(format!("{slug}.json"));
    // Nothing is written over: another part of the name is somebody's.
    let slug = make_slug(name, |slug| Disk.metadata(&file_of(slug)).is_some());
    let path = file_of(&slug);
    let mut told = write(draft, &path, from, catalog)?;
    let first = make_slug(name, |_| false);
    if slug != first {
        told.insert(1, tr!("{first}.json was there already, and stays as it is"));
    }
    Ok((path, told.join(" · ")))
}

/// Writes a part to a file, in place of what is there, and its own pictures beside it. Returns what
/// was done, saving first.
pub(super) fn write(
    draft: &PartDraft,
    path: &Path,
    from: Option<&Path>,
    catalog: &Catalog,
) -> Result<Vec<String>, String> {
    let name = named(draft)?;
    let mut look = draft.look.clone();
    look.name = name.to_owned();
    let folder = path.parent().unwrap_or(Path::new(""));
    let moved = match from {
        Some(from) => {
            let route = PictureRoute { from, to: Some(folder), takes_equal: true };
            route.rename(&mut look, catalog)
        }
        None => MovedPictures::default(),
    };
    for picture in &moved.copied {
        let file = folder.join(&picture.name);
        write_atomic(&file, &picture.bytes).map_err(|problem| problem.message)?;
    }
    write_atomic(path, look.to_text().as_bytes()).map_err(|problem| problem.message)?;
    let mut told = vec![draft.kind.saved(name, path)];
    told.extend(moved.told());
    Ok(told)
}

/// Name of a part that is to be saved.
fn named(draft: &PartDraft) -> Result<&str, String> {
    let name = draft.look.name.trim();
    if name.is_empty() { Err(tr!("Give it a name first").to_owned()) } else { Ok(name) }
}
