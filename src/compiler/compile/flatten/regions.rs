//! Regions: groups that run once for each light of a set.
//!
//! Each light has a copy of the group's scope, and of the scopes in it. The copies share their
//! paths and their values; a node without a light of its own has the copy's. A node that joins
//! lights takes, in each copy, its own outputs from the copy before, and everybody else takes those
//! of the last copy.

use std::collections::{HashMap, HashSet};

use chiaro_locale::tr;

use super::{FlatGraph, FlatInput, FlatNode, FlatSlot, Flattener};
use crate::diag::Diagnostic;
use crate::document::{Light, LightSet, Value};
use crate::ids::{GROUP_OUTPUTS, LightId, NodeId, NodePath, PortName};
use crate::library::{Fallback, Input, LightFeed, Output, Type};

/// Index of a region among those of the look.
pub type RegionIndex = usize;

/// A group that runs for each light, at one place in the look.
#[derive(Debug, Default)]
pub(super) struct Region {
    /// The region around it.
    outer: Option<RegionIndex>,
    /// Lights, in the order of the look.
    lights: Vec<LightId>,
    /// The scopes of each copy, by path; a single copy where there are no lights.
    copies: Vec<HashMap<NodePath, usize>>,
    /// Nodes that compute how bright each light arrives, where a node asks for it.
    reaches: HashMap<usize, usize>,
}

/// A copy of a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RegionCopy {
    /// The region.
    pub region: RegionIndex,
    /// Counts the copies of the region from 0, in the order of their lights.
    pub copy: usize,
}

/// Place of a node in a region.
#[derive(Clone, Debug)]
pub(super) struct RegionPlace {
    pub(super) copy: RegionCopy,
    /// Light that the copy is for; `None` where the set has none.
    pub(super) light: Option<LightId>,
}

impl<'a> Flattener<'a> {
    /// Lights of a set, in the order of the look. Terms that name none are warned about.
    pub(super) fn lights_of(&mut self, set: &LightSet, path: &NodePath) -> Vec<LightId> {
        let lights = &self.look.lights;
        let warnings = set.idle_warnings("`for_each`", lights).into_iter();
        self.problems.extend(warnings.map(|problem| problem.node(path.clone())));
        let found = set.of(lights, &Default::default());
        lights.keys().filter(|id| found.contains(*id)).cloned().collect()
    }

    /// Opens a region in another, or in none.
    pub(super) fn push_region(
        &mut self,
        outer: Option<RegionIndex>,
        lights: Vec<LightId>,
    ) -> RegionIndex {
        let copies = vec![HashMap::new(); lights.len().max(1)];
        self.regions.push(Region { outer, lights, copies, reaches: HashMap::new() });
        self.regions.len() - 1
    }

    /// Number of copies of a region.
    pub(super) fn copies(&self, region: RegionIndex) -> usize {
        self.regions[region].copies.len()
    }

    /// Light of a copy, with its id.
    pub(super) fn light_of(&self, copy: RegionCopy) -> Option<(&'a LightId, &'a Light)> {
        let id = self.regions[copy.region].lights.get(copy.copy)?;
        self.look.lights.get_key_value(id)
    }

    /// Notes a scope of a copy. Returns the scope whose values it shares, if that is another one.
    pub(super) fn note_copy(
        &mut self,
        scope: usize,
        path: &NodePath,
        copy: RegionCopy,
    ) -> Option<usize> {
        let copies = &mut self.regions[copy.region].copies;
        copies[copy.copy].insert(path.clone(), scope);
        let first = copies[0].get(path).copied().unwrap_or(scope);
        // The first copy may itself be one of a region around it.
        Some(self.scopes.get(first).and_then(|first| first.values).unwrap_or(first))
            .filter(|shared| *shared != scope)
    }

    /// The scope of the last copy of a region, of which the first one is given; of any other scope
    /// the same.
    pub(super) fn last_copy(&self, first: usize) -> usize {
        let scope = &self.scopes[first];
        let (Some(copy), Some(path)) = (scope.copy, &scope.path) else { return first };
        if self.is_around(first, copy) {
            return first;
        }
        let last = self.regions[copy.region].copies.last();
        last.and_then(|copies| copies.get(path)).copied().unwrap_or(first)
    }

    /// True if the scope around a scope lies in the same copy: the scope is a plain group in a
    /// region.
    fn is_around(&self, scope: usize, copy: RegionCopy) -> bool {
        let outer = self.scopes[scope].parent.and_then(|(parent, _)| self.scopes[parent].copy);
        outer.is_some_and(|outer| (outer.region, outer.copy) == (copy.region, copy.copy))
    }

    /// The region that a scope lies in, with the light of its copy.
    pub(super) fn place_of(&self, scope: usize) -> Option<RegionPlace> {
        let copy = self.scopes[scope].copy?;
        let light = self.light_of(copy).map(|(id, _)| id.clone());
        Some(RegionPlace { copy, light })
    }

    /// The node of another copy that is what a node is in the copy of its scope.
    fn counterpart(&self, scope: usize, id: &NodeId, copy: RegionCopy) -> Option<usize> {
        let path = self.scopes[scope].path.as_ref()?;
        let other = *self.regions[copy.region].copies[copy.copy].get(path)?;
        match self.scopes[other].slots.get(id.as_str())? {
            FlatSlot::Flat(node) => Some(*node),
            _ => None,
        }
    }

    /// The node whose outputs others take, of a node that joins lights: that of the last copy.
    /// `None` where it joins none.
    pub(super) fn joined(&self, scope: usize, id: &NodeId) -> Option<Option<usize>> {
        let RegionCopy { region, .. } = self.scopes[scope].copy?;
        if self.regions[region].lights.is_empty() {
            return Some(None);
        }
        let last = RegionCopy { region, copy: self.copies(region) - 1 };
        Some(self.counterpart(scope, id, last))
    }

    /// The source of an input that is fed where its node runs for each light.
    pub(super) fn fed(&mut self, index: usize, input: &Input) -> Option<FlatInput> {
        let feed = input.light_feed.as_ref()?;
        if matches!(feed, LightFeed::Number | LightFeed::Member(_)) {
            return self.fed_by_name(index, feed);
        }
        let (scope, id, _) = self.origins[index];
        let at @ RegionCopy { region, copy } = self.scopes[scope].copy?;
        Some(match feed {
            LightFeed::Before(_) if copy == 0 => FlatInput::Fixed(first_value(input)),
            LightFeed::Before(output) => {
                let node = self.counterpart(scope, id, RegionCopy { copy: copy - 1, ..at })?;
                let output = self.flat.nodes[node].def.output(output.as_str())?;
                FlatInput::Wire { node, output }
            }
            LightFeed::Index => FlatInput::Fixed(Value::Number(copy as f64)),
            LightFeed::Count => {
                FlatInput::Fixed(Value::Number(self.regions[region].lights.len() as f64))
            }
            LightFeed::Reach => {
                let node = self.reach(index, at)?;
                let output = self.flat.nodes[node].def.output("intensity")?;
                FlatInput::Wire { node, output }
            }
            LightFeed::Number | LightFeed::Member(_) => return None,
        })
    }

    /// The node that takes the light of a copy apart, made where a node asks for it first.
    fn reach(&mut self, asking: usize, at: RegionCopy) -> Option<usize> {
        if let Some(&known) = self.regions[at.region].reaches.get(&at.copy) {
            return Some(known);
        }
        let (id, light) = self.light_of(at)?;
        let name = light.display_name(id).to_owned();
        let asking = FlatNode {
            name,
            shared_name: Some("light".to_owned()),
            is_named: false,
            // Who asks may be reached by fewer lights than others that ask.
            lights: None,
            ..self.flat.nodes[asking].clone()
        };
        let [arriving, parts] =
            ["light", "light_parts"].map(|kind| self.library.nodes.get(kind).cloned());
        let (arriving, parts) = (arriving?, parts?);
        let bound = |input: &Input| match &input.fallback {
            Fallback::Context(context) => FlatInput::Context(*context),
            _ => FlatInput::Fixed(Value::Text(id.to_string())),
        };
        let inputs = arriving.inputs.iter().map(bound).collect();
        let node = self.flat.nodes.len();
        self.flat.nodes.push(FlatNode { def: arriving, inputs, ..asking.clone() });
        let inputs = vec![FlatInput::Wire { node, output: 0 }];
        self.flat.nodes.push(FlatNode { def: parts, inputs, ..asking });
        self.regions[at.region].reaches.insert(at.copy, node + 1);
        Some(node + 1)
    }

    /// Errors of outputs of regions that differ from light to light, because nothing joins them.
    pub(super) fn check_regions(&mut self) {
        for region in 0..self.regions.len() {
            // The path of a region is the shortest of its scopes.
            let last = self.regions[region].copies.last();
            let Some((path, &scope)) =
                last.and_then(|copy| copy.iter().min_by_key(|(path, _)| path.ids().len()))
            else {
                continue;
            };
            let (path, Some(group)) = (path.clone(), self.scopes[scope].group) else { continue };
            let mut known = HashSet::new();
            for port in &self.groups[group].definition.outputs {
                let Some(&wire) =
                    self.scopes[scope].wires.get(&(GROUP_OUTPUTS, port.name.as_str()))
                else {
                    continue;
                };
                let FlatInput::Wire { node, .. } = self.resolve(scope, &wire.to.node, &port.name)
                else {
                    continue;
                };
                if self.is_of_each(region, node, &mut known) {
                    self.problems.push(unjoined(&path, &port.name));
                }
            }
        }
    }

    /// True if the outputs of a node differ from light to light of a region.
    fn is_of_each(&self, region: RegionIndex, node: usize, known: &mut HashSet<usize>) -> bool {
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            let flat = &self.flat.nodes[node];
            let Some(place) = &flat.place else { continue };
            let is_own = place.copy.region == region;
            if !self.is_within(place.copy.region, region)
                || (is_own && flat.def.joins_lights())
                || !known.insert(node)
            {
                continue;
            }
            if is_own && self.flat.is_of_light(flat) {
                return true;
            }
            open.extend(flat.inputs.iter().filter_map(|input| match input {
                FlatInput::Wire { node, .. } => Some(*node),
                _ => None,
            }));
        }
        false
    }

    fn is_within(&self, inner: RegionIndex, outer: RegionIndex) -> bool {
        let mut around = Some(inner);
        while let Some(region) = around {
            if region == outer {
                return true;
            }
            around = self.regions[region].outer;
        }
        false
    }
}

impl FlatGraph {
    /// True if a node reads the light of its region's copy.
    fn is_of_light(&self, node: &FlatNode) -> bool {
        node.def.inputs.iter().zip(&node.inputs).any(|(port, input)| match input {
            FlatInput::Param(id) if port.ty == Type::LightName => match &self.params[*id].value {
                None => true,
                Some(Value::Text(id)) => id.is_empty(),
                Some(_) => false,
            },
            FlatInput::Fixed(_) => {
                port.ty == Type::LightName || port.light_feed == Some(LightFeed::Index)
            }
            _ => false,
        })
    }
}

/// Value before the first light of an input that is fed with its node's own output.
fn first_value(input: &Input) -> Value {
    match &input.fallback {
        Fallback::Value(value) => value.clone(),
        _ => Value::Number(0.0),
    }
}

/// The value of an output of a node that joins lights where there are none.
pub(super) fn without_lights(inputs: &[Input], output: &Output) -> Option<Value> {
    let feed = Some(LightFeed::Before(output.name.clone()));
    inputs.iter().find(|input| input.light_feed == feed).map(first_value)
}

fn unjoined(path: &NodePath, port: &PortName) -> Diagnostic {
    let message = tr!(
        "the output `{port}` differs from light to light, and nothing joins what comes of them"
    );
    Diagnostic::error("not-joined", message).node(path.clone()).port(port.clone()).hint(tr!(
        "put a node that joins lights before it, such as Sum of lights; or clear the node's \
         `for_each`"
    ))
}
