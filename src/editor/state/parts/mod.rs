//! Library of parts: looks, layers, nodes, groups, rigs of lights, profiles and ramps that lie as
//! files in folders, to be found, and put into any look.
//!
//! Each part is a look's document, as the clipboard has it: with an Output a whole look, without
//! one a part of a graph, which may have lights and groups along. The content alone says what a
//! part is; see `docs/format.md`. `reader` reads the folders on a thread, `saving` makes parts from
//! a look, `upkeep` renames, replaces and removes them, `placing` puts them into one, with `lights`
//! that do the work of theirs there, and `pictures` takes their pictures along.

mod lights;
pub(crate) mod pictures;
pub(crate) mod placing;
mod reader;
pub(crate) mod saving;
mod shipped;
#[cfg(test)]
mod tests;
pub(crate) mod upkeep;

use chiaro_locale::{Text, text, tr, tr_in};

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::catalog::Catalog;
use crate::document::{Look, Node, Value};
use crate::ids::NodeId;
use crate::library::Library;
use crate::state::stack::BELOW;
pub(crate) use reader::{FoundParts, PartsReader};
pub(crate) use shipped::{shipped, shipped_part};

/// Name of the folder of parts beside a project's looks, and among the user's own files.
pub(crate) const FOLDER: &str = "library";

/// Names of the inputs that make a profile.
pub(crate) const PROFILE: [&str; 3] = ["offset", "falloff", "cutoff"];

/// Kind of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum PartKind {
    Look,
    Layer,
    Nodes,
    Group,
    Lights,
    Profile,
    Ramp,
}

impl PartKind {
    /// All kinds, in the order of lists.
    pub(crate) const ALL: [Self; 7] = [
        Self::Look,
        Self::Layer,
        Self::Nodes,
        Self::Group,
        Self::Lights,
        Self::Profile,
        Self::Ramp,
    ];

    /// Word for one part of the kind.
    pub(crate) fn word(self) -> &'static str {
        self.text().tr()
    }

    /// Word for one part of the kind, as a text: search knows its English, too.
    pub(crate) fn text(self) -> Text {
        match self {
            Self::Look => text!("look"),
            Self::Layer => text!("layer"),
            Self::Nodes => text!("nodes"),
            Self::Group => text!("group"),
            Self::Lights => text!("lights"),
            Self::Profile => text!("profile"),
            Self::Ramp => text!("ramp"),
        }
    }

    /// Sentence on a part of the kind that was saved.
    fn saved(self, name: &str, path: &Path) -> String {
        let path = path.display();
        match self {
            Self::Look => tr!("The look \"{name}\" is saved as {path}"),
            Self::Layer => tr!("The layer \"{name}\" is saved as {path}"),
            Self::Nodes => tr!("The nodes \"{name}\" are saved as {path}"),
            Self::Group => tr!("The group \"{name}\" is saved as {path}"),
            Self::Lights => tr!("The lights \"{name}\" are saved as {path}"),
            Self::Profile => tr!("The profile \"{name}\" is saved as {path}"),
            Self::Ramp => tr!("The ramp \"{name}\" is saved as {path}"),
        }
    }

    /// Title of all parts of the kind.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Look => tr!("Looks"),
            Self::Layer => tr!("Layers"),
            Self::Nodes => tr!("Nodes"),
            Self::Group => tr!("Groups"),
            Self::Lights => tr!("Lights"),
            Self::Profile => tr!("Profiles"),
            Self::Ramp => tr!("Ramps"),
        }
    }

    /// Explanation of what the part does where it is put.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Look => {
                tr!("A double click opens it; drop it on an object, which then wears its file")
            }
            Self::Layer => {
                tr!(
                    "A double click lays it over the selected layer; drop it on a layer, on a wire \
                     or on the canvas"
                )
            }
            Self::Nodes => {
                tr!("A double click adds it to the graph; drop it on the canvas or on a wire")
            }
            Self::Group => {
                tr!("A double click adds a node of it; drop it on the canvas or on a wire")
            }
            Self::Lights => {
                tr!("A double click sets up the look's lights: those of the same id are set anew, \
                     others are added")
            }
            Self::Profile => {
                tr!("A double click gives it to the selected node; drop it on a layer or on the \
                     inspector")
            }
            Self::Ramp => {
                tr!("A double click gives it to the selected node; drop it on a ramp's field")
            }
        }
    }

    /// Kind of a part by its content; `None` where there is nothing in it.
    pub(crate) fn of(look: &Look, catalog: &Catalog) -> Option<Self> {
        let nodes = &look.graph.nodes;
        if nodes.values().any(|node| node.kind == "output") {
            return Some(Self::Look);
        }
        if let (Some(node), 1) = (nodes.values().next(), nodes.len())
            && catalog.of(node).is_none_or(|kind| kind.input(BELOW).is_none())
            && let Some(kind) = Self::of_values(node)
        {
            return Some(kind);
        }
        if ends(look, catalog).is_some() {
            return Some(Self::Layer);
        }
        match (nodes.is_empty(), look.definitions.is_empty(), look.lights.is_empty()) {
            (false, ..) => Some(Self::Nodes),
            (true, false, _) => Some(Self::Group),
            (true, true, false) => Some(Self::Lights),
            (true, true, true) => None,
        }
    }

    /// Kind of a node that is there for its values alone.
    fn of_values(node: &Node) -> Option<Self> {
        let is = |value: &Value| match value {
            Value::Ramp(_) => Some(Self::Ramp),
            Value::Curve(_) => Some(Self::Profile),
            _ => None,
        };
        let is_profile = PROFILE.iter().all(|name| node.values.contains_key(*name));
        node.values.values().find_map(is).or(is_profile.then_some(Self::Profile))
    }
}

/// Ends of the layers of a part, the lowest and the uppermost, which is the only one that gives its
/// stack to nothing; `None` where no stack goes through the part.
pub(crate) fn ends<'l>(part: &'l Look, catalog: &Catalog) -> Option<[&'l NodeId; 2]> {
    let graph = &part.graph;
    let is_layer = |node: &Node| {
        catalog.of(node).is_some_and(|kind| {
            kind.output(BELOW).is_some()
                && kind.input(BELOW).is_some_and(|index| kind.inputs[index].is_wirable())
        })
    };
    let layers = || graph.nodes.iter().filter(|(_, node)| is_layer(node)).map(|(id, _)| id);
    let gives = |id: &NodeId| {
        let is_stack = |id: &NodeId| graph.nodes.get(id).is_some_and(is_layer);
        graph.wires.iter().any(|wire| wire.from.node == *id && is_stack(&wire.to.node))
    };
    let mut open = layers().filter(|id| !gives(id));
    let (top, None) = (open.next()?, open.next()) else { return None };
    let mut bottom = top;
    // No more steps than there are wires: a ring ends.
    for _ in 0..=graph.wires.len() {
        let Some(wire) = graph.wire_into(bottom, &BELOW.into()) else { return Some([bottom, top]) };
        let (below, node) = graph.nodes.get_key_value(&wire.from.node)?;
        if !is_layer(node) {
            return None;
        }
        bottom = below;
    }
    None
}

/// Part of the library.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    /// File of the part; a name for those that Chiaro ships.
    pub(crate) path: PathBuf,
    pub(crate) name: String,
    /// Words to find the part by, apart by spaces.
    pub(crate) tags: String,
    /// Paragraph on the part; empty for none.
    pub(crate) about: String,
    /// Content of the part, or the reason why there is none.
    pub(crate) content: Result<PartContent, String>,
}

/// Content of a part.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PartContent {
    pub(crate) kind: PartKind,
    pub(crate) look: Arc<Look>,
    /// Look that the part is shown by; `None` where there is nothing to draw.
    pub(crate) shown: Option<Arc<Look>>,
}

impl Part {
    /// Part of a look that was read, under the name of its file where it has none of its own.
    fn of(path: PathBuf, look: Look, catalog: &Catalog) -> Self {
        let stem = || path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let name = if look.name.is_empty() { stem() } else { look.name.clone() };
        let (tags, about) = (look.tags.clone(), look.about.clone());
        let content = PartKind::of(&look, catalog)
            .map(|kind| {
                let shown = placing::shown(&look, kind).map(Arc::new);
                PartContent { kind, look: Arc::new(look), shown }
            })
            .ok_or_else(|| {
                tr!("There is nothing in it: no node, no group and no light").to_owned()
            });
        Self { path, name, tags, about, content }
    }

    /// Part of a text, such as the clipboard's, whose images are named from the folder of `path`;
    /// `None` where the text is no look.
    pub(crate) fn of_text(text: &str, path: &Path) -> Option<Self> {
        let look = text.trim_start().starts_with('{').then(|| Look::read(text, "clipboard"))?;
        let mut catalog = Catalog::new(Library::built_in());
        Some(reader::of_look(path, look.value?, &mut catalog))
    }

    /// True for a part that Chiaro ships, which has no file.
    pub(crate) fn is_shipped(&self) -> bool {
        self.path.starts_with(shipped::PREFIX)
    }

    /// A text of the part, such as its name, as it is shown: those of a part that Chiaro ships are
    /// looked up.
    pub(crate) fn shown<'t>(&self, text: &'t str) -> &'t str {
        if self.is_shipped() { tr_in("example", text) } else { text }
    }

    /// Name of the part as it is shown.
    pub(crate) fn title(&self) -> &str {
        self.shown(&self.name)
    }
}
