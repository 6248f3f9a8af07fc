//! A look's layers with the folders among them: a folder is a layer with a stack of its own, and
//! edits of the list are edits of nodes and wires.
//!
//! A pass-through folder's stack begins with what lies below the folder; an isolated one's with a
//! transparent *Base*. Every edit is thought of as another list, whose wires replace those that
//! differ.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use indexmap::IndexMap;

use super::mask;
use super::{BASE, BELOW, Layer, STEP, Stack, feeds};
use crate::catalog::Catalog;
use crate::document::{Edit, Endpoint, GraphId, Look, Node, Value, Wire};
use crate::ids::{NodeId, PortName, make_slug};

/// Name of the input that makes a layer a folder.
pub(crate) const INSIDE: &str = "inside";
/// Kinds of folders.
pub(crate) const PASS_THROUGH: &str = "pass_through";
pub(crate) const ISOLATED: &str = "folder";
/// Inputs of an isolated folder that a pass-through one lacks.
const BLEND: &str = "blend";
const CLAMPED: &str = "clamped";
/// Distance of a folder's layers from the folder, downward, in points.
const DROP: f64 = 560.0;

/// Stack of a look without an Output.
static NO_STACK: Stack =
    Stack { head: None, output: None, layers: Vec::new(), ground: None, is_on_other: false };

/// Place among the layers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct LayerPlace {
    /// Folder that the place lies in; `None` for none.
    pub(crate) folder: Option<NodeId>,
    /// Number of layers over the place in its stack.
    pub(crate) at: usize,
}

/// Layer as a row of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TreeRow {
    /// Node of the layer.
    pub(crate) id: NodeId,
    /// Place of the layer.
    pub(crate) place: LayerPlace,
    /// Number of folders around the layer.
    pub(crate) depth: usize,
    /// True for folders.
    pub(crate) is_folder: bool,
}

/// Place between two layers, as ends of wires.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LayerJoint {
    /// Output of what lies below; `None` where nothing does.
    pub(crate) from: Option<Endpoint>,
    /// Input of what lies above.
    pub(crate) into: Endpoint,
    /// Inputs of the lowest layers in pass-through folders above, which lie on the same.
    pub(crate) others: Vec<Endpoint>,
}

/// A look's layers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct LayerTree {
    /// The look's own stack, under no folder, and the stack of each folder.
    stacks: IndexMap<Option<NodeId>, Stack>,
}

impl LayerTree {
    /// The layers of a look.
    pub(crate) fn of(look: &Look, catalog: &Catalog) -> Self {
        let nodes = &look.graph.nodes;
        let Some((output, _)) = nodes.iter().find(|(_, node)| node.kind == "output") else {
            return Self::default();
        };
        let into = feeds(look);
        let mut seen = HashSet::from([output]);
        let head = Endpoint::new(output.clone(), "color");
        let own = Stack::follow(look, catalog, &into, head, &mut seen);
        let mut stacks = IndexMap::from([(None, own)]);
        let mut next = 0;
        while let Some((_, stack)) = stacks.get_index(next) {
            let is_folder = |layer: &&Layer| {
                let kind = look.graph.nodes.get(&layer.id).and_then(|node| catalog.of(node));
                kind.is_some_and(|kind| {
                    kind.input(INSIDE).is_some_and(|index| kind.inputs[index].is_wirable())
                })
            };
            let folders: Vec<NodeId> =
                stack.layers.iter().filter(is_folder).map(|layer| layer.id.clone()).collect();
            for id in folders {
                let head = Endpoint::new(id.clone(), INSIDE);
                let inner = Stack::follow(look, catalog, &into, head, &mut seen);
                stacks.insert(Some(id), inner);
            }
            next += 1;
        }
        Self { stacks }
    }

    /// The look's own stack, of what lies in no folder.
    pub(crate) fn own(&self) -> &Stack {
        self.stacks.get(&None).unwrap_or(&NO_STACK)
    }

    /// All layers, what they lie on, and the Output.
    pub(crate) fn members(&self) -> impl Iterator<Item = &NodeId> {
        self.stacks.values().flat_map(|stack| {
            let layers = stack.layers.iter().map(|layer| &layer.id);
            layers.chain(&stack.output).chain(stack.ground.as_ref().map(|ground| &ground.node))
        })
    }

    /// True if there is an Output that a stack can feed.
    pub(crate) fn has_output(&self) -> bool {
        self.own().has_output()
    }

    /// Number of layers, folders among them.
    pub(crate) fn len(&self) -> usize {
        self.stacks.values().map(|stack| stack.layers.len()).sum()
    }

    /// True for a layer that is a folder.
    pub(crate) fn is_folder(&self, id: &NodeId) -> bool {
        self.stacks.contains_key(&Some(id.clone()))
    }

    /// True for a layer.
    pub(crate) fn contains(&self, id: &NodeId) -> bool {
        self.place_of(id).is_some()
    }

    /// The stack in a folder, or the look's own.
    #[cfg(test)]
    pub(crate) fn stack_in(&self, folder: Option<&NodeId>) -> Option<&Stack> {
        self.stacks.get(&folder.cloned())
    }

    /// The stack that has a layer.
    pub(crate) fn stack_of(&self, id: &NodeId) -> Option<&Stack> {
        self.stacks.values().find(|stack| stack.index_of(id).is_some())
    }

    /// Layer of a node.
    pub(crate) fn layer(&self, id: &NodeId) -> Option<&Layer> {
        self.stacks.values().find_map(|stack| stack.layer(id))
    }

    /// True for a layer that changes what is below and lays nothing over it.
    pub(crate) fn is_adjustment(&self, id: &NodeId) -> bool {
        self.layer(id).is_some_and(Layer::is_adjustment)
    }

    /// Place of a layer.
    pub(crate) fn place_of(&self, id: &NodeId) -> Option<LayerPlace> {
        let of = |(folder, stack): (&Option<NodeId>, &Stack)| {
            Some(LayerPlace { folder: folder.clone(), at: stack.index_of(id)? })
        };
        self.stacks.iter().find_map(of)
    }

    /// The layers from the top, a folder before what lies in it, without what lies in the folders
    /// that are closed.
    pub(crate) fn rows(&self, is_closed: impl Fn(&NodeId) -> bool) -> Vec<TreeRow> {
        let mut rows = Vec::with_capacity(self.len());
        let mut open = vec![(None::<NodeId>, 0_usize)];
        while let Some((folder, at)) = open.pop() {
            let Some(layer) = self.stacks.get(&folder).and_then(|stack| stack.layers.get(at))
            else {
                continue;
            };
            let depth = open.len();
            let is_folder = self.is_folder(&layer.id);
            let place = LayerPlace { folder: folder.clone(), at };
            rows.push(TreeRow { id: layer.id.clone(), place, depth, is_folder });
            open.push((folder, at + 1));
            if is_folder && !is_closed(&layer.id) {
                open.push((Some(layer.id.clone()), 0));
            }
        }
        rows
    }

    /// The place directly over a layer or over the ground, or on top of all; `None` for a node that
    /// is neither, and for a look without an Output.
    pub(crate) fn joint_over(&self, id: Option<&NodeId>) -> Option<LayerJoint> {
        let own = self.own();
        let is_ground = |id: &NodeId| own.ground.as_ref().is_some_and(|end| end.node == *id);
        let place = match id {
            None => LayerPlace::default(),
            Some(id) if is_ground(id) => LayerPlace { folder: None, at: own.layers.len() },
            Some(id) => self.place_of(id)?,
        };
        let stack = self.stacks.get(&place.folder)?;
        let from = stack.layers.get(place.at).map(|layer| &layer.outlet);
        let from = from.or(stack.ground.as_ref()).cloned();
        let above = place.at.checked_sub(1).and_then(|at| stack.layers.get(at));
        let into = above.map(|layer| &layer.inlet).or(stack.head.as_ref())?.clone();
        let lies_there = |inner: &&Stack| inner.is_on_other && inner.ground == from;
        let inner = self.stacks.values().filter(lies_there).filter_map(Stack::lowest_inlet);
        let others = inner.filter(|inlet| **inlet != into && from.is_some()).cloned().collect();
        Some(LayerJoint { from, into, others })
    }

    /// Folders around a layer, the innermost first.
    pub(crate) fn folders_around(&self, id: &NodeId) -> Vec<NodeId> {
        let mut found = Vec::new();
        let mut at = id.clone();
        while let Some(folder) = self.place_of(&at).and_then(|place| place.folder) {
            found.push(folder.clone());
            at = folder;
        }
        found
    }

    /// Layers of these that lie in no other one of them, in the order of the list.
    pub(crate) fn outermost(&self, ids: &[NodeId]) -> Vec<NodeId> {
        let rows = self.rows(|_| false).into_iter().map(|row| row.id);
        let is_free = |id: &NodeId| {
            ids.contains(id) && !self.folders_around(id).iter().any(|folder| ids.contains(folder))
        };
        rows.filter(is_free).collect()
    }

    /// The layers that lie in a folder, the uppermost first; `None` for a layer that is no folder.
    pub(super) fn layers_in(
        &self,
        id: &NodeId,
    ) -> Option<impl DoubleEndedIterator<Item = &NodeId>> {
        let stack = self.stacks.get(&Some(id.clone()))?;
        Some(stack.layers.iter().map(|layer| &layer.id))
    }

    /// The layers in a folder at any depth, with the folder.
    pub(crate) fn with_inner(&self, id: &NodeId) -> Vec<NodeId> {
        let mut found = vec![id.clone()];
        let mut next = 0;
        while next < found.len() {
            let inner = self.stacks.get(&Some(found[next].clone()));
            found.extend(inner.into_iter().flat_map(|stack| &stack.layers).map(|l| l.id.clone()));
            next += 1;
        }
        found
    }

    /// The transparent base of an isolated folder, which nothing else uses.
    fn own_base(&self, look: &Look, folder: &NodeId) -> Option<NodeId> {
        let stack = self.stacks.get(&Some(folder.clone())).filter(|stack| !stack.is_on_other)?;
        let id = &stack.ground.as_ref()?.node;
        let users = look.graph.wires.iter().filter(|wire| wire.from.node == *id).count();
        let is_base = look.graph.nodes.get(id).is_some_and(|node| node.kind == BASE);
        (is_base && users == 1).then(|| id.clone())
    }

    /// Grounds of pass-through folders, which are what lies below each.
    fn settle(&mut self) {
        let mut open = vec![None];
        while let Some(folder) = open.pop() {
            let Some(stack) = self.stacks.get(&folder) else { continue };
            let mut grounds = Vec::new();
            for (index, layer) in stack.layers.iter().enumerate() {
                let below = stack.layers.get(index + 1).map(|layer| &layer.outlet);
                grounds.push((layer.id.clone(), below.or(stack.ground.as_ref()).cloned()));
            }
            for (id, ground) in grounds {
                let key = Some(id);
                if let Some(inner) = self.stacks.get_mut(&key) {
                    if inner.is_on_other {
                        inner.ground = ground;
                    }
                    open.push(key);
                }
            }
        }
    }

    /// The edits that wire the layers of `new`, each with the reroutes below it.
    fn rewire(look: &Look, mut new: Self) -> Vec<Edit> {
        new.settle();
        let into = feeds(look);
        let outlets: HashSet<&Endpoint> = new
            .stacks
            .values()
            .flat_map(|stack| stack.layers.iter().map(|layer| &layer.outlet).chain(&stack.ground))
            .collect();
        let mut edits = Vec::new();
        for stack in new.stacks.values() {
            let inlets = stack.head.iter().chain(stack.layers.iter().map(|layer| &layer.inlet));
            let sources = stack.layers.iter().map(|layer| Some(&layer.outlet));
            for (to, from) in inlets.zip(sources.chain([stack.ground.as_ref()])) {
                let old = into.get(to).copied();
                match from {
                    Some(from) if old.is_none_or(|old| old.from != *from) => {
                        let wire = Wire { from: from.clone(), to: to.clone() };
                        edits.push(Edit::AddWire { graph: GraphId::Look, wire, index: None });
                    }
                    // The wire of a removed layer goes with its node.
                    None => {
                        let gone = old.filter(|old| outlets.contains(&old.from)).cloned();
                        let removal = |wire: Wire| Edit::RemoveWire { graph: GraphId::Look, wire };
                        edits.extend(gone.map(removal));
                    }
                    Some(_) => {}
                }
            }
        }
        edits
    }

    /// Moves layers, in the order of the list, to a place; with them go what lies in them and, on
    /// the canvas, what feeds them alone. `None` if nothing moves, or a folder would lie in itself.
    pub(crate) fn move_to(&self, look: &Look, ids: &[NodeId], place: &LayerPlace) -> Option<Edit> {
        let ids = self.outermost(ids);
        let first = ids.first()?.clone();
        let is_inside = |id: &NodeId| {
            place.folder.as_ref().is_some_and(|folder| self.with_inner(id).contains(folder))
        };
        if ids.iter().any(is_inside) {
            return None;
        }
        let mut new = self.clone();
        let old_target = self.stacks.get(&place.folder)?;
        let before = old_target.layers.iter().take(place.at);
        let at = before.filter(|layer| !ids.contains(&layer.id)).count();
        let mut moved = Vec::new();
        for id in &ids {
            let from = self.place_of(id)?;
            let stack = new.stacks.get_mut(&from.folder)?;
            moved.push(stack.layers.remove(stack.index_of(id)?));
        }
        let target = new.stacks.get_mut(&place.folder)?;
        let at = at.min(target.layers.len());
        target.layers.splice(at..at, moved);
        let mut positions = IndexMap::new();
        if target.layers.len() == old_target.layers.len() {
            if target.layers == old_target.layers {
                return None;
            }
            // The same layers in another order lie where those of the old order lay.
            for (new, old) in target.layers.iter().zip(&old_target.layers) {
                let [from, to] = [&new.id, &old.id].map(|id| position(look, id));
                if new.id != old.id {
                    let by = [to[0] - from[0], to[1] - from[1]];
                    old_target.carry(look, &new.id, by, &mut positions);
                }
            }
        } else {
            let mut over = self.over(look, &LayerPlace { at, ..place.clone() });
            for id in &ids {
                let (from, to) = (position(look, id), [over[0] - STEP, over[1]]);
                let stack = self.stack_of(id)?;
                stack.carry(look, id, [to[0] - from[0], to[1] - from[1]], &mut positions);
                over = to;
            }
            self.make_room(look, place, over, &ids, &mut positions);
        }
        // The layer itself comes first: undo names the step by it.
        let own = positions.shift_remove(&first).map(|place| IndexMap::from([(first, place)]));
        let moves = own.into_iter().chain((!positions.is_empty()).then_some(positions));
        let mut edits: Vec<Edit> =
            moves.map(|positions| Edit::MoveNodes { graph: GraphId::Look, positions }).collect();
        edits.extend(Self::rewire(look, new));
        Some(Edit::Group { edits })
    }

    /// The place one row up or down from layers that move together; open folders are entered and
    /// left. `None` at the ends.
    pub(crate) fn beside(
        &self,
        ids: &[NodeId],
        is_up: bool,
        is_closed: impl Fn(&NodeId) -> bool,
    ) -> Option<LayerPlace> {
        let ids = self.outermost(ids);
        let LayerPlace { folder, at } =
            self.place_of(if is_up { ids.first()? } else { ids.last()? })?;
        let siblings = &self.stacks.get(&folder)?.layers;
        let next = if is_up { at.checked_sub(1) } else { Some(at + 1) };
        let Some(next) = next.and_then(|next| siblings.get(next)) else {
            let out = self.place_of(&folder?)?;
            return Some(LayerPlace { at: out.at + usize::from(!is_up), ..out });
        };
        match self.stacks.get(&Some(next.id.clone())).filter(|_| !is_closed(&next.id)) {
            Some(inner) => {
                let at = if is_up { inner.layers.len() } else { 0 };
                Some(LayerPlace { folder: Some(next.id.clone()), at })
            }
            None => Some(LayerPlace { folder, at: if is_up { at - 1 } else { at + 2 } }),
        }
    }

    /// Position on the canvas of what lies over a place: a layer, the Output, or a point beside a
    /// folder under it.
    fn over(&self, look: &Look, place: &LayerPlace) -> [f64; 2] {
        let stack = self.stacks.get(&place.folder);
        let above = place.at.checked_sub(1).and_then(|at| stack?.layers.get(at));
        match (above, &place.folder) {
            (Some(layer), _) => position(look, &layer.id),
            (None, Some(folder)) => {
                let [x, y] = position(look, folder);
                [x, y + DROP]
            }
            (None, None) => stack
                .and_then(|stack| stack.output.as_ref())
                .map_or([0.0; 2], |id| position(look, id)),
        }
    }

    /// Moves what lies below a place to the left, so that it begins a step after `last`.
    fn make_room(
        &self,
        look: &Look,
        place: &LayerPlace,
        last: [f64; 2],
        without: &[NodeId],
        positions: &mut IndexMap<NodeId, [f64; 2]>,
    ) {
        let Some(stack) = self.stacks.get(&place.folder) else { return };
        let below = stack.layers.iter().skip(place.at).map(|layer| &layer.id);
        let ground = stack.ground.as_ref().filter(|_| !stack.is_on_other);
        let below: Vec<&NodeId> = below
            .filter(|id| !without.contains(id))
            .chain(ground.map(|ground| &ground.node))
            .collect();
        let Some(next) = below.first() else { return };
        let lack = position(look, next)[0] - (last[0] - STEP);
        if lack > 0.0 {
            below.iter().for_each(|id| stack.carry(look, id, [-lack, 0.0], positions));
        }
    }

    /// Takes layers out of the stack, folders with all that lies in them.
    pub(crate) fn remove(&self, look: &Look, ids: &[NodeId]) -> Edit {
        let mut gone: Vec<NodeId> = Vec::new();
        for id in self.outermost(ids) {
            gone.extend(self.with_inner(&id));
        }
        let mut new = self.clone();
        let bases: Vec<NodeId> = gone.iter().filter_map(|id| self.own_base(look, id)).collect();
        new.stacks.retain(|folder, _| folder.as_ref().is_none_or(|id| !gone.contains(id)));
        for stack in new.stacks.values_mut() {
            stack.layers.retain(|layer| !gone.contains(&layer.id));
        }
        let mut edits: Vec<Edit> = gone.into_iter().chain(bases).map(removal).collect();
        edits.extend(Self::rewire(look, new));
        Edit::Group { edits }
    }

    /// Inserts a new node as the layer at a place, and makes room for it. Sets the node's position.
    pub(crate) fn insert(
        &self,
        look: &Look,
        place: &LayerPlace,
        id: &NodeId,
        mut node: Node,
    ) -> Vec<Edit> {
        let mut new = self.clone();
        let Some(stack) = self.stacks.get(&place.folder) else { return Vec::new() };
        let at = place.at.min(stack.layers.len());
        let place = LayerPlace { at, ..place.clone() };
        let over = self.over(look, &place);
        let mut positions = IndexMap::new();
        if place.folder.is_some() {
            node.position = [over[0] - STEP, over[1]];
            self.make_room(look, &place, node.position, &[], &mut positions);
        } else {
            let under = stack.layers.get(at).map(|layer| &layer.id);
            let under = under.or(stack.ground.as_ref().map(|ground| &ground.node));
            node.position = under.map_or([over[0] - STEP, over[1]], |id| {
                let [x, y] = position(look, id);
                [x + STEP, y]
            });
            let lack = node.position[0] + STEP - over[0];
            if lack > 0.0 {
                let above = stack.layers[..at].iter().map(|layer| &layer.id).chain(&stack.output);
                above.for_each(|id| stack.carry(look, id, [lack, 0.0], &mut positions));
            }
        }
        if let Some(stack) = new.stacks.get_mut(&place.folder) {
            stack.layers.insert(at, plain_layer(id));
        }
        let mut edits =
            vec![Edit::AddNode { graph: GraphId::Look, id: id.clone(), node, index: None }];
        if !positions.is_empty() {
            edits.push(Edit::MoveNodes { graph: GraphId::Look, positions });
        }
        edits.extend(Self::rewire(look, new));
        edits
    }

    /// Puts an empty folder at a place. Returns its id.
    pub(crate) fn add_folder(&self, look: &Look, place: &LayerPlace) -> (NodeId, Edit) {
        let (id, node) = new_folder(look);
        let mut edits = self.insert(look, place, &id, node);
        let stack = self.stacks.get(&place.folder);
        let under = stack.and_then(|stack| {
            stack.layers.get(place.at).map(|layer| &layer.outlet).or(stack.ground.as_ref())
        });
        edits.extend(under.map(|from| {
            let wire = Wire { from: from.clone(), to: Endpoint::new(id.clone(), INSIDE) };
            Edit::AddWire { graph: GraphId::Look, wire, index: None }
        }));
        (id, Edit::Group { edits })
    }

    /// Puts layers into a new pass-through folder at the place of the uppermost; nothing of the
    /// picture changes where they lay one on the other. Returns the folder's id.
    pub(crate) fn group(&self, look: &Look, ids: &[NodeId]) -> Option<(NodeId, Edit)> {
        let ids = self.outermost(ids);
        let top = ids.first()?;
        let place = self.place_of(top)?;
        let (id, mut node) = new_folder(look);
        node.position = position(look, top);
        let (mut new, mut inner, mut positions) = (self.clone(), Vec::new(), IndexMap::new());
        for layer in &ids {
            let from = self.place_of(layer)?;
            let stack = new.stacks.get_mut(&from.folder)?;
            inner.push(stack.layers.remove(stack.index_of(layer)?));
            self.stack_of(layer)?.carry(look, layer, [0.0, DROP], &mut positions);
        }
        let head = Some(Endpoint::new(id.clone(), INSIDE));
        let output = Some(id.clone());
        let inside = Stack { head, output, layers: inner, ground: None, is_on_other: true };
        new.stacks.get_mut(&place.folder)?.layers.insert(place.at, plain_layer(&id));
        new.stacks.insert(Some(id.clone()), inside);
        let mut edits = vec![
            Edit::AddNode { graph: GraphId::Look, id: id.clone(), node, index: None },
            Edit::MoveNodes { graph: GraphId::Look, positions },
        ];
        edits.extend(Self::rewire(look, new));
        Some((id, Edit::Group { edits }))
    }

    /// Takes folders away, and leaves what lay in them in their place.
    pub(crate) fn ungroup(&self, look: &Look, folders: &[NodeId]) -> Option<Edit> {
        let (mut new, mut edits, mut positions) = (self.clone(), Vec::new(), IndexMap::new());
        let mut gone = Vec::new();
        for id in folders.iter().filter(|id| self.is_folder(id)) {
            let place = new.place_of(id)?;
            let inner = new.stacks.shift_remove(&Some(id.clone()))?;
            for layer in &inner.layers {
                self.stack_of(&layer.id)?.carry(look, &layer.id, [0.0, -DROP], &mut positions);
            }
            new.stacks.get_mut(&place.folder)?.layers.splice(place.at..=place.at, inner.layers);
            gone.push(id.clone());
            gone.extend(self.own_base(look, id));
            // A mask of the folder, with what feeds the mask alone.
            let mask = mask::of(look, id).map(|(mask, _)| mask);
            let used_once = |mask: &&NodeId| {
                look.graph.wires.iter().filter(|wire| wire.from.node == **mask).count() == 1
            };
            if let (Some(mask), Some(stack)) = (mask.filter(used_once), self.stack_of(id)) {
                gone.extend(stack.with_own(look, mask));
            }
        }
        positions.retain(|id, _| !gone.contains(id));
        edits.extend(gone.into_iter().map(removal));
        if edits.is_empty() {
            return None;
        }
        edits.push(Edit::MoveNodes { graph: GraphId::Look, positions });
        edits.extend(Self::rewire(look, new));
        Some(Edit::Group { edits })
    }

    /// Edits that give folders a blend mode, or let them pass through, each after those before it.
    pub(crate) fn set_modes(
        look: &Look,
        catalog: &Catalog,
        folders: &[&NodeId],
        mode: Option<&str>,
    ) -> Vec<Edit> {
        let mut edits = Vec::new();
        let mut now = Cow::Borrowed(look);
        for folder in folders {
            let edit = Self::of(&now, catalog).set_mode(&now, folder, mode);
            edits.extend(edit.filter(|edit| now.to_mut().apply(edit.clone()).is_ok()));
        }
        edits
    }

    /// Gives a folder a blend mode, so that it is isolated, or, without one, lets it pass through.
    pub(crate) fn set_mode(
        &self,
        look: &Look,
        folder: &NodeId,
        mode: Option<&str>,
    ) -> Option<Edit> {
        let node = look.graph.nodes.get(folder)?;
        let key = Some(folder.clone());
        let (graph, id) = (GraphId::Look, folder.clone());
        let mut new = self.clone();
        let inner = new.stacks.get_mut(&key)?;
        let of = |kind: &str| Edit::SetKind {
            graph: graph.clone(),
            id: id.clone(),
            kind: kind.to_owned(),
        };
        let Some(mode) = mode else {
            let mut edits = vec![of(PASS_THROUGH)];
            for port in [BLEND, CLAMPED].map(PortName::new) {
                if node.values.contains_key(&port) {
                    edits.push(Edit::ClearValue { graph: graph.clone(), id: id.clone(), port });
                }
            }
            edits.extend(self.own_base(look, folder).map(removal));
            inner.is_on_other = true;
            edits.extend(Self::rewire(look, new));
            return Some(Edit::Group { edits });
        };
        let (port, value) = (PortName::new(BLEND), Value::Text(mode.to_owned()));
        let set = Edit::SetValue { graph: graph.clone(), id: id.clone(), port, value, index: None };
        if node.kind == ISOLATED {
            return Some(set);
        }
        let last = inner.layers.last().map(|layer| position(look, &layer.id));
        let [x, y] = last.unwrap_or_else(|| {
            let [x, y] = position(look, folder);
            [x, y + DROP]
        });
        let (base, transparent) = (
            NodeId::new(make_slug(BASE, |slug| look.graph.nodes.contains_key(slug))),
            Node {
                kind: BASE.to_owned(),
                name: "Nothing below".to_owned(),
                position: [x - STEP, y],
                values: [(PortName::new("color"), Value::Vector(vec![0.0; 4]))].into(),
                ..Node::default()
            },
        );
        inner.ground = Some(Endpoint::new(base.clone(), BELOW));
        inner.is_on_other = false;
        let add = Edit::AddNode { graph: graph.clone(), id: base, node: transparent, index: None };
        let mut edits = vec![of(ISOLATED), set, add];
        edits.extend(Self::rewire(look, new));
        Some(Edit::Group { edits })
    }

    /// Puts a copy of each layer over it, folders with all that lies in them, fed by the same wires
    /// otherwise. Returns the ids of the copies of these layers.
    pub(crate) fn duplicate(&self, look: &Look, ids: &[NodeId]) -> Option<(Vec<NodeId>, Edit)> {
        let ids = self.outermost(ids);
        let mut new = self.clone();
        let (mut edits, mut copies) = (Vec::new(), Vec::new());
        let mut positions = IndexMap::new();
        let mut taken: HashSet<String> = HashSet::new();
        for id in &ids {
            let by = self.room_for_copy(look, &ids, id, &mut positions);
            let mut copied: IndexMap<NodeId, NodeId> = IndexMap::new();
            for inner in self.with_inner(id) {
                // What lies in a copied folder lies under what lies in the original.
                let drop = if inner == *id { 0.0 } else { DROP };
                for old in self.own_base(look, &inner).into_iter().chain([inner]) {
                    let slug = make_slug(stem(&old), |slug| {
                        look.graph.nodes.contains_key(slug) || taken.contains(slug)
                    });
                    taken.insert(slug.clone());
                    let mut node = look.graph.nodes.get(&old)?.clone();
                    let [x, y] = node.position;
                    node.position = [x + by, y + drop];
                    let copy = NodeId::new(slug);
                    copied.insert(old, copy.clone());
                    let graph = GraphId::Look;
                    edits.push(Edit::AddNode { graph, id: copy, node, index: None });
                }
            }
            edits.extend(self.copied_wires(look, &copied));
            for (old, copy) in &copied {
                let Some(stack) = self.stacks.get(&Some(old.clone())) else { continue };
                let of = |id: &NodeId| copied.get(id).unwrap_or(id).clone();
                let moved = |end: &Endpoint| Endpoint { node: of(&end.node), ..end.clone() };
                let stack = Stack {
                    head: Some(Endpoint::new(copy.clone(), INSIDE)),
                    output: Some(copy.clone()),
                    layers: stack.layers.iter().map(|l| copied_layer(l, &of(&l.id))).collect(),
                    ground: stack.ground.as_ref().map(moved),
                    is_on_other: stack.is_on_other,
                };
                new.stacks.insert(Some(copy.clone()), stack);
            }
            let copy = copied.get(id)?.clone();
            let place = new.place_of(id)?;
            let layer = copied_layer(self.layer(id)?, &copy);
            new.stacks.get_mut(&place.folder)?.layers.insert(place.at, layer);
            copies.push(copy);
        }
        if !positions.is_empty() {
            edits.push(Edit::MoveNodes { graph: GraphId::Look, positions });
        }
        edits.extend(Self::rewire(look, new));
        (!copies.is_empty()).then_some((copies, Edit::Group { edits }))
    }

    /// Moves a layer, and those over it, to the right for copies of these layers that lie over each
    /// of them. Returns how far to the right of the layer its copy lies, in points.
    fn room_for_copy(
        &self,
        look: &Look,
        copied: &[NodeId],
        id: &NodeId,
        positions: &mut IndexMap<NodeId, [f64; 2]>,
    ) -> f64 {
        let Some((stack, index)) =
            self.stack_of(id).and_then(|stack| Some((stack, stack.index_of(id)?)))
        else {
            return STEP;
        };
        let below = |at: usize| {
            stack.layers[at..].iter().filter(|layer| copied.contains(&layer.id)).count() as f64
        };
        for (above, layer) in stack.layers.iter().enumerate().take(index) {
            stack.carry(look, &layer.id, [STEP * below(above + 1), 0.0], positions);
        }
        let is_own = stack.output.as_ref().is_some_and(|id| !self.is_folder(id));
        if let Some(output) = stack.output.as_ref().filter(|_| is_own) {
            stack.carry(look, output, [STEP * below(0), 0.0], positions);
        }
        STEP * below(index)
    }

    /// Wires into copies from what feeds the originals, but for those of the stack.
    fn copied_wires(&self, look: &Look, copied: &IndexMap<NodeId, NodeId>) -> Vec<Edit> {
        let is_of_stack = |wire: &Wire| {
            let port = &wire.to.port;
            let is_below = || self.layer(&wire.to.node).is_some_and(|layer| layer.input == *port);
            port.as_str() == BELOW
                || port.as_str() == INSIDE && self.is_folder(&wire.to.node)
                || is_below()
        };
        let copy = |wire: &Wire| {
            let to = Endpoint { node: copied.get(&wire.to.node)?.clone(), ..wire.to.clone() };
            let from = copied.get(&wire.from.node).unwrap_or(&wire.from.node).clone();
            let from = Endpoint { node: from, ..wire.from.clone() };
            (!is_of_stack(wire)).then_some(Edit::AddWire {
                graph: GraphId::Look,
                wire: Wire { from, to },
                index: None,
            })
        };
        look.graph.wires.iter().filter_map(copy).collect()
    }

    /// Layers with whether each is muted where only these are shown: what lies in them stays as it
    /// is, and the folders around them are shown.
    pub(crate) fn muted_alone(&self, alone: &dyn Fn(&NodeId) -> bool) -> HashMap<NodeId, bool> {
        let rows = self.rows(|_| false);
        let mut shown: HashSet<NodeId> = HashSet::new();
        for row in rows.iter().filter(|row| alone(&row.id)) {
            shown.insert(row.id.clone());
            shown.extend(self.folders_around(&row.id));
        }
        let of = |row: TreeRow| {
            let is_in_shown = self.folders_around(&row.id).iter().any(alone);
            match shown.contains(&row.id) {
                true => Some((row.id, false)),
                false => (!is_in_shown).then_some((row.id, true)),
            }
        };
        rows.into_iter().filter_map(of).collect()
    }
}

fn position(look: &Look, id: &NodeId) -> [f64; 2] {
    look.graph.nodes.get(id).map_or([0.0; 2], |node| node.position)
}

fn removal(id: NodeId) -> Edit {
    Edit::RemoveNode { graph: GraphId::Look, id }
}

/// The layer of a node with the ports that layers have.
fn plain_layer(id: &NodeId) -> Layer {
    Layer::of(id.clone(), &PortName::new(BELOW), PortName::new(BELOW))
}

/// The layer of a node's copy.
fn copied_layer(layer: &Layer, copy: &NodeId) -> Layer {
    Layer::of(copy.clone(), &layer.outlet.port, layer.input.clone())
}

/// A pass-through folder with a name that nothing has yet.
fn new_folder(look: &Look) -> (NodeId, Node) {
    let is_taken = |name: &str| look.graph.nodes.values().any(|node| node.name == name);
    let numbered = (2..).map(|number| format!("Folder {number}"));
    let mut names = std::iter::once("Folder".to_owned()).chain(numbered);
    let name = names.find(|name| !is_taken(name)).unwrap_or_default();
    let id = NodeId::new(make_slug(&name, |slug| look.graph.nodes.contains_key(slug)));
    (id, Node { kind: PASS_THROUGH.to_owned(), name, ..Node::default() })
}

/// An id without the number at its end.
fn stem(id: &NodeId) -> &str {
    let stem = id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
    if stem.is_empty() { id.as_str() } else { stem }
}

#[cfg(test)]
mod tests;
