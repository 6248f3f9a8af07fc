//! Edits, the one way in which documents change; each edit has an inverse.
//!
//! [`Look::apply`] checks an [`Edit`], applies it and returns the edit that undoes it; scenes,
//! shots and HCBTFs have edits of their own ([`SceneEdit`], [`ShotEdit`], [`HcbtfEdit`]).
//! [`History`] owns a document and keeps the inverses, so that every edit can be undone; a journal
//! holds serialized edits.
//!
//! An edit that removes a part which other parts name (a node with its wires, a light with its
//! keys) is first spelled out as a group of single edits, so that its inverse restores all of them
//! in their old order.

mod graph;
mod hcbtf;
mod history;
mod labels;
mod parts;
mod patch;
mod scene;
mod shot;
mod trial;

use chiaro_locale::{tr, trn};
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::{
    Bookmark, ColorSpace, Definition, DirectionKeys, ExposedValue, Frame, GraphId, InterfacePort,
    Light, LightSet, Look, Marker, NamedAov, Node, NodeLinks, Note, Tier, TimeKeys, Value, Wire,
};
use crate::diag::Diagnostic;
use crate::ids::{DefinitionId, FrameId, LightId, NodeId, NoteId, PortName};

pub use hcbtf::HcbtfEdit;
pub use history::{DocumentRevision, Editable, History, HistoryNumbers, Step};
pub use patch::Patch;
pub use scene::SceneEdit;
pub use shot::ShotEdit;

/// Result of an edit: the edit that undoes it.
pub type EditResult<E> = Result<E, Box<Diagnostic>>;

/// Edit of a look. Edits of nodes, wires and frames name the graph; by default it is the look's
/// own.
///
/// An `index` is the position of a new part among its like; without one the part comes last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "edit", rename_all = "snake_case")]
#[allow(missing_docs, reason = "the fields are named after what they set")]
pub enum Edit {
    /// Several edits as one: all or none.
    Group { edits: Vec<Edit> },
    /// Replaces the whole look, as when another program changed its file.
    Replace { look: Box<Look> },
    /// Names the look.
    SetLookName { name: String },
    /// Sets the text on what the look shows and how it is built.
    SetLookAbout { about: String },
    /// Sets the words to find the look by.
    SetLookTags { tags: String },
    /// Sets the color space.
    SetColorSpace { color_space: ColorSpace },
    /// Sets the tier of all nodes without a tier of their own; `None` for the cheapest of each
    /// whose difference nobody can see.
    SetLookTier { tier: Option<Tier> },
    /// Sets the greatest difference that automatic tiers may make, in numbers of a color.
    SetMaxError { max_error: f64 },

    /// Adds a node under a new id.
    AddNode { graph: GraphId, id: NodeId, node: Node, index: Option<usize> },
    /// Removes a node with its wires, its place in frames, and the exposed parameters and keys of
    /// its inputs.
    RemoveNode { graph: GraphId, id: NodeId },
    /// Gives a node the artist's name; the id stays.
    SetName { graph: GraphId, id: NodeId, name: String },
    /// Changes a node's kind; values and wires stay. Where a group goes away, the exposed
    /// parameters and keys of inputs in it go too.
    SetKind { graph: GraphId, id: NodeId, kind: String },
    /// Sets a node's tier; `None` for the tier of the group or look around it.
    SetTier { graph: GraphId, id: NodeId, tier: Option<Tier> },
    /// Lets a group run once for each light of a set; `None` for once, for no light.
    SetForEach { graph: GraphId, id: NodeId, for_each: Option<LightSet> },
    /// Sets the lights that reach a node and that pass through it.
    SetNodeLinks { graph: GraphId, id: NodeId, links: NodeLinks },
    /// Mutes a node, or takes it in again.
    SetMuted { graph: GraphId, id: NodeId, muted: bool },
    /// Collapses a node to its title, or expands it.
    SetCollapsed { graph: GraphId, id: NodeId, collapsed: bool },
    /// Moves nodes on the canvas, to these places.
    MoveNodes { graph: GraphId, positions: IndexMap<NodeId, [f64; 2]> },
    /// Sets the value of an input.
    SetValue { graph: GraphId, id: NodeId, port: PortName, value: Value, index: Option<usize> },
    /// Removes an input's value, so that the input has its default.
    ClearValue { graph: GraphId, id: NodeId, port: PortName },

    /// Adds a wire in place of any other into its input; with an index, to an input without a wire.
    AddWire { graph: GraphId, wire: Wire, index: Option<usize> },
    /// Removes a wire.
    RemoveWire { graph: GraphId, wire: Wire },

    /// Adds a frame under a new id.
    AddFrame { graph: GraphId, id: FrameId, frame: Frame, index: Option<usize> },
    /// Changes a frame's title, color or nodes.
    SetFrame { graph: GraphId, id: FrameId, frame: Frame },
    /// Removes a frame; its nodes stay.
    RemoveFrame { graph: GraphId, id: FrameId },

    /// Adds a note under a new id.
    AddNote { graph: GraphId, id: NoteId, note: Note, index: Option<usize> },
    /// Changes a note's text, place, width or color.
    SetNote { graph: GraphId, id: NoteId, note: Note },
    /// Removes a note.
    RemoveNote { graph: GraphId, id: NoteId },
    /// Sets the bookmarks: views that keys bring back.
    SetBookmarks { graph: GraphId, bookmarks: Vec<Bookmark> },

    /// Adds a light under a new id.
    AddLight { id: LightId, light: Light, index: Option<usize> },
    /// Changes a light.
    SetLight { id: LightId, light: Light },
    /// Removes a light with its exposed parameters and keys. Nodes that name the light stay.
    RemoveLight { id: LightId },

    /// Adds a group definition under a new id.
    AddDefinition { id: DefinitionId, definition: Definition, index: Option<usize> },
    /// Changes a group's label, help, inputs and outputs; its graph stays.
    SetInterface {
        id: DefinitionId,
        label: String,
        help: String,
        inputs: Vec<InterfacePort>,
        outputs: Vec<InterfacePort>,
    },
    /// Removes a group definition that no node uses.
    RemoveDefinition { id: DefinitionId },

    /// Exposes an input.
    AddExposed { exposed: ExposedValue, index: Option<usize> },
    /// Changes an exposed parameter.
    SetExposed { index: usize, exposed: ExposedValue },
    /// Removes an exposed parameter.
    RemoveExposed { index: usize },

    /// Sets the outputs that films ask for by name.
    SetAovs { aovs: Vec<NamedAov> },

    /// Adds a set of direction keys.
    AddDirectionKeys { keys: DirectionKeys, index: Option<usize> },
    /// Changes a set of direction keys.
    SetDirectionKeys { index: usize, keys: DirectionKeys },
    /// Removes a set of direction keys.
    RemoveDirectionKeys { index: usize },

    /// Keys a target over time.
    AddTimeKeys { keys: TimeKeys, index: Option<usize> },
    /// Changes the keys of a target.
    SetTimeKeys { index: usize, keys: TimeKeys },
    /// Removes the keys of a target.
    RemoveTimeKeys { index: usize },
    /// Sets the times with names.
    SetMarkers { markers: Vec<Marker> },
}

impl Edit {
    /// Label of the edit for undo, e.g. `add rim`.
    pub fn label(&self) -> String {
        match self {
            Self::Group { edits } => labels::of_several(edits)
                .unwrap_or_else(|| edits.first().map_or_else(|| "nothing".to_owned(), Self::label)),
            Self::Replace { .. } => tr!("load the file again").to_owned(),
            Self::SetLookName { .. } => tr!("rename the look").to_owned(),
            Self::SetLookAbout { .. } => tr!("describe the look").to_owned(),
            Self::SetLookTags { .. } => tr!("tag the look").to_owned(),
            Self::SetColorSpace { .. } => tr!("change the color space").to_owned(),
            Self::SetLookTier { .. } => tr!("change the look's tier").to_owned(),
            Self::SetMaxError { .. } => tr!("change the difference of automatic tiers").to_owned(),
            Self::AddNode { id, .. } => tr!("add {id}"),
            Self::RemoveNode { id, .. } => tr!("remove {id}"),
            Self::SetName { id, .. } => tr!("rename {id}"),
            Self::SetKind { id, .. } => tr!("change the kind of {id}"),
            Self::SetTier { id, .. } => tr!("change the tier of {id}"),
            Self::SetNodeLinks { id, .. } => tr!("link lights and {id}"),
            Self::SetForEach { id, .. } => tr!("change the lights of {id}"),
            Self::SetMuted { id, muted: true, .. } => tr!("mute {id}"),
            Self::SetMuted { id, .. } => tr!("unmute {id}"),
            Self::SetCollapsed { id, collapsed: true, .. } => tr!("collapse {id}"),
            Self::SetCollapsed { id, .. } => tr!("expand {id}"),
            Self::MoveNodes { positions, .. } => match positions.keys().next() {
                Some(id) if positions.len() == 1 => tr!("move {id}"),
                _ => trn!(count = positions.len(), "move {count} nodes", "move {count} nodes"),
            },
            Self::SetValue { id, port, .. } => tr!("change {id}.{port}"),
            Self::ClearValue { id, port, .. } => tr!("reset {id}.{port}"),
            Self::AddWire { wire, .. } => {
                tr!("wire {from} to {to}", from = wire.from, to = wire.to)
            }
            Self::RemoveWire { wire, .. } => tr!("unwire {to}", to = wire.to),
            Self::AddFrame { .. } => tr!("add a frame").to_owned(),
            Self::SetFrame { .. } => tr!("change a frame").to_owned(),
            Self::RemoveFrame { .. } => tr!("remove a frame").to_owned(),
            Self::AddNote { .. } => tr!("add a note").to_owned(),
            Self::SetNote { .. } => tr!("change a note").to_owned(),
            Self::RemoveNote { .. } => tr!("remove a note").to_owned(),
            Self::SetBookmarks { .. } => tr!("change bookmarks").to_owned(),
            Self::AddLight { id, .. } => tr!("add the light {id}"),
            Self::SetLight { id, light } => labels::of_light(id, None, light),
            Self::RemoveLight { id } => tr!("remove the light {id}"),
            Self::AddDefinition { id, .. } => tr!("add the group {id}"),
            Self::SetInterface { id, .. } => tr!("change the group {id}"),
            Self::RemoveDefinition { id } => tr!("remove the group {id}"),
            Self::AddExposed { exposed, .. } => tr!("expose {name}", name = exposed.name),
            Self::SetExposed { .. } => tr!("change a parameter").to_owned(),
            Self::RemoveExposed { .. } => tr!("remove a parameter").to_owned(),
            Self::SetAovs { .. } => tr!("change named outputs").to_owned(),
            Self::AddTimeKeys { keys, .. } => tr!("key {target}", target = keys.target),
            Self::SetTimeKeys { keys, .. } => tr!("change keys of {target}", target = keys.target),
            Self::AddDirectionKeys { keys, .. } => labels::of_new_keys(keys),
            Self::SetDirectionKeys { keys, .. } => labels::of_keys(None, keys),
            Self::RemoveDirectionKeys { .. } | Self::RemoveTimeKeys { .. } => {
                labels::of_removed_keys(None)
            }
            Self::SetMarkers { .. } => tr!("change markers").to_owned(),
        }
    }
}

impl Look {
    /// Applies an edit and returns the edit that undoes it.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible: it names a part that does not exist, or sets a
    /// value that no document holds. The look is then as it was.
    pub fn apply(&mut self, edit: Edit) -> EditResult<Edit> {
        apply(self, edit, false)
    }
}

impl Look {
    /// Label of edits that are one step.
    fn label_of_several(&self, edits: &[Edit]) -> String {
        let lights: Option<Vec<_>> = edits
            .iter()
            .map(|edit| match edit {
                Edit::SetLight { id, light } => Some((id, self.lights.get(id), light)),
                _ => None,
            })
            .collect();
        match (lights, edits) {
            (_, [edit]) => self.label(edit),
            (Some(lights), [_, ..]) => labels::of_lights(lights.into_iter()),
            // Keys of an input begin with a value of its own.
            (
                _,
                [
                    Edit::SetValue { .. },
                    keys @ (Edit::AddTimeKeys { .. }
                    | Edit::AddDirectionKeys { .. }
                    | Edit::SetDirectionKeys { .. }),
                ],
            ) => self.label(keys),
            _ => labels::of_several(edits).unwrap_or_else(|| {
                edits.first().map_or_else(|| "nothing".to_owned(), |first| self.label(first))
            }),
        }
    }
}

impl Editable for Look {
    type Edit = Edit;

    fn edit(&mut self, edit: Edit, is_known_good: bool) -> EditResult<Edit> {
        apply(self, edit, is_known_good)
    }

    fn label(&self, edit: &Edit) -> String {
        match edit {
            Edit::SetLight { id, light } => labels::of_light(id, self.lights.get(id), light),
            Edit::SetDirectionKeys { index, keys } => {
                labels::of_keys(self.direction_keys.get(*index), keys)
            }
            Edit::RemoveDirectionKeys { index } => {
                labels::of_removed_keys(self.direction_keys.get(*index))
            }
            Edit::Group { edits } => self.label_of_several(edits),
            Edit::RemoveTimeKeys { index } => match self.time_keys.get(*index) {
                Some(keys) => tr!("remove keys of {target}", target = keys.target),
                None => edit.label(),
            },
            _ => edit.label(),
        }
    }

    fn does_nothing(edit: &Edit) -> bool {
        matches!(edit, Edit::Group { edits } if edits.is_empty())
    }

    fn is_annotation(edit: &Edit) -> bool {
        match edit {
            Edit::Group { edits } => edits.iter().all(Self::is_annotation),
            Edit::MoveNodes { .. }
            | Edit::SetCollapsed { .. }
            | Edit::AddNote { .. }
            | Edit::SetNote { .. }
            | Edit::RemoveNote { .. }
            | Edit::SetBookmarks { .. }
            | Edit::SetMarkers { .. }
            | Edit::SetLookName { .. }
            | Edit::SetLookAbout { .. }
            | Edit::SetLookTags { .. } => true,
            _ => false,
        }
    }

    fn covers(older: &Edit, newer: &Edit) -> bool {
        match (older, newer) {
            (
                Edit::SetValue { graph: g, id: i, port: p, index: None, .. },
                Edit::SetValue { graph, id, port, index: None, .. },
            ) => (g, i, p) == (graph, id, port),
            (Edit::SetLookName { .. }, Edit::SetLookName { .. })
            | (Edit::SetLookAbout { .. }, Edit::SetLookAbout { .. })
            | (Edit::SetLookTags { .. }, Edit::SetLookTags { .. })
            | (Edit::SetMaxError { .. }, Edit::SetMaxError { .. })
            | (Edit::SetMarkers { .. }, Edit::SetMarkers { .. }) => true,
            (Edit::SetLight { id: i, .. }, Edit::SetLight { id, .. }) => i == id,
            (Edit::MoveNodes { graph: g, positions: p }, Edit::MoveNodes { graph, positions }) => {
                g == graph
                    && p.len() == positions.len()
                    && positions.keys().all(|id| p.contains_key(id))
            }
            (Edit::SetName { graph: g, id: i, .. }, Edit::SetName { graph, id, .. }) => {
                (g, i) == (graph, id)
            }
            (Edit::SetFrame { graph: g, id: i, .. }, Edit::SetFrame { graph, id, .. }) => {
                (g, i) == (graph, id)
            }
            (Edit::SetNote { graph: g, id: i, .. }, Edit::SetNote { graph, id, .. }) => {
                (g, i) == (graph, id)
            }
            (Edit::SetDirectionKeys { index: i, .. }, Edit::SetDirectionKeys { index, .. })
            | (Edit::SetTimeKeys { index: i, .. }, Edit::SetTimeKeys { index, .. }) => i == index,
            _ => false,
        }
    }
}

/// Applies one edit. An edit that is known to be good, because it undoes or repeats another, is not
/// checked: a document that was broken before an edit is as broken after its undoing.
fn apply(look: &mut Look, edit: Edit, is_known_good: bool) -> EditResult<Edit> {
    if !is_known_good {
        trial::check(look, &edit)?;
    }
    match edit {
        Edit::Group { edits } => group(look, edits, is_known_good),
        Edit::Replace { look: new } => {
            Ok(Edit::Replace { look: Box::new(std::mem::replace(look, *new)) })
        }
        Edit::SetLookName { name } => {
            Ok(Edit::SetLookName { name: std::mem::replace(&mut look.name, name) })
        }
        Edit::SetLookAbout { about } => {
            Ok(Edit::SetLookAbout { about: std::mem::replace(&mut look.about, about) })
        }
        Edit::SetLookTags { tags } => {
            Ok(Edit::SetLookTags { tags: std::mem::replace(&mut look.tags, tags) })
        }
        Edit::SetColorSpace { color_space } => {
            let color_space = std::mem::replace(&mut look.color_space, color_space);
            Ok(Edit::SetColorSpace { color_space })
        }
        Edit::SetLookTier { tier } => {
            Ok(Edit::SetLookTier { tier: std::mem::replace(&mut look.tier, tier) })
        }
        Edit::SetMaxError { max_error } => {
            Ok(Edit::SetMaxError { max_error: std::mem::replace(&mut look.max_error, max_error) })
        }
        Edit::AddNode { graph, id, node, index } => graph::add_node(look, graph, id, node, index),
        Edit::RemoveNode { graph, id } => graph::remove_node(look, graph, id),
        Edit::SetName { graph, id, name } => {
            let old = std::mem::replace(&mut graph::node_mut(look, &graph, &id)?.name, name);
            Ok(Edit::SetName { graph, id, name: old })
        }
        Edit::SetKind { graph, id, kind } => graph::set_kind(look, graph, id, kind),
        Edit::SetTier { graph, id, tier } => {
            let tier = std::mem::replace(&mut graph::node_mut(look, &graph, &id)?.tier, tier);
            Ok(Edit::SetTier { graph, id, tier })
        }
        Edit::SetForEach { graph, id, for_each } => {
            let slot = &mut graph::node_mut(look, &graph, &id)?.for_each;
            Ok(Edit::SetForEach { graph, id, for_each: std::mem::replace(slot, for_each) })
        }
        Edit::SetNodeLinks { graph, id, links } => {
            let slot = &mut graph::node_mut(look, &graph, &id)?.links;
            Ok(Edit::SetNodeLinks { graph, id, links: std::mem::replace(slot, links) })
        }
        Edit::SetMuted { graph, id, muted } => {
            let muted = std::mem::replace(&mut graph::node_mut(look, &graph, &id)?.muted, muted);
            Ok(Edit::SetMuted { graph, id, muted })
        }
        Edit::SetCollapsed { graph, id, collapsed } => {
            let collapsed =
                std::mem::replace(&mut graph::node_mut(look, &graph, &id)?.collapsed, collapsed);
            Ok(Edit::SetCollapsed { graph, id, collapsed })
        }
        Edit::MoveNodes { graph, positions } => graph::move_nodes(look, graph, positions),
        Edit::SetValue { graph, id, port, value, index } => {
            graph::set_value(look, graph, id, port, value, index)
        }
        Edit::ClearValue { graph, id, port } => graph::clear_value(look, graph, id, port),
        Edit::AddWire { graph, wire, index } => graph::add_wire(look, graph, wire, index),
        Edit::RemoveWire { graph, wire } => graph::remove_wire(look, graph, &wire),
        Edit::AddFrame { graph, id, frame, index } => {
            graph::add_frame(look, graph, id, frame, index)
        }
        Edit::SetFrame { graph, id, frame } => graph::set_frame(look, graph, id, frame),
        Edit::RemoveFrame { graph, id } => graph::remove_frame(look, graph, id),
        Edit::AddNote { graph, id, note, index } => graph::add_note(look, graph, id, note, index),
        Edit::SetNote { graph, id, note } => graph::set_note(look, graph, id, note),
        Edit::RemoveNote { graph, id } => graph::remove_note(look, graph, id),
        Edit::SetBookmarks { graph, bookmarks } => graph::set_bookmarks(look, graph, bookmarks),
        part => parts::apply(look, part),
    }
}

/// Applies all edits, or none of them.
fn group(look: &mut Look, edits: Vec<Edit>, is_known_good: bool) -> EditResult<Edit> {
    all_or_none(look, edits, is_known_good).map(|edits| Edit::Group { edits })
}

/// Applies edits in order; where one fails, those before it are undone. Returns the inverses in the
/// order in which they are to be applied.
fn all_or_none<D: Editable>(
    document: &mut D,
    edits: Vec<D::Edit>,
    is_known_good: bool,
) -> EditResult<Vec<D::Edit>> {
    let mut inverses = Vec::with_capacity(edits.len());
    let mut failure = None;
    for edit in edits {
        match document.edit(edit, is_known_good) {
            Ok(inverse) if D::does_nothing(&inverse) => {}
            Ok(inverse) => inverses.push(inverse),
            Err(problem) => {
                failure = Some(problem);
                break;
            }
        }
    }
    inverses.reverse();
    let Some(problem) = failure else { return Ok(inverses) };
    for inverse in inverses {
        let undone = document.edit(inverse, true);
        debug_assert!(undone.is_ok(), "an inverse applies to what its edit made: {undone:?}");
    }
    Err(problem)
}

/// Inverse of an edit that changes nothing.
fn nothing() -> Edit {
    Edit::Group { edits: Vec::new() }
}

/// Diagnostic of an edit that names a part that does not exist.
fn missing(what: &str, name: impl std::fmt::Display) -> Box<Diagnostic> {
    Box::new(Diagnostic::error("impossible-edit", tr!("there is no {what} `{name}`")))
}

/// Diagnostic of an edit that cannot be applied.
fn impossible(message: impl Into<String>) -> Box<Diagnostic> {
    Box::new(Diagnostic::error("impossible-edit", message))
}
