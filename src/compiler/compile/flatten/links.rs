//! Links of nodes: which lights reach them, and which pass them by.
//!
//! A light that does not reach a node has no intensity in it. A light that a node does not filter
//! passes by: for that light the node is muted. Which light passes is known before anything is
//! compiled, by following the wires from the node to what names the light.

use std::collections::BTreeSet;
use std::sync::Arc;

use chiaro_locale::tr;

use super::{FlatInput, FlatSlot, Flattener, WireEnd, let_through, stand_in_of};
use crate::diag::Diagnostic;
use crate::document::{Light, LightLink, LightRelation, LightSet, Node, SetMember as _, Value};
use crate::ids::{LightId, NodeId, NodePath, PortName};
use crate::library::{Fallback, Input, LightFeed, NodeDef, Output, Type};

/// A node that some lights pass by.
pub(super) struct FilterNode<'a> {
    scope: usize,
    id: &'a NodeId,
    path: NodePath,
    link: LightLink,
}

impl<'a> Flattener<'a> {
    /// Lights that reach a node; `None` for all.
    pub(super) fn lights_reaching(
        &mut self,
        scope: usize,
        node: &Node,
        path: &NodePath,
    ) -> Option<Arc<BTreeSet<LightId>>> {
        let around = self.scopes[scope].lights.clone();
        let link = node.links.layered_link();
        if link.is_all() {
            return around;
        }
        let lights = &self.look.lights;
        self.warn_of_link(scope, &link, LightRelation::Layered, path);
        let around =
            around.map_or_else(|| lights.keys().cloned().collect(), |around| (*around).clone());
        Some(Arc::new(link.lights_within(lights, &around)))
    }

    /// Warns of names that no light has, once for all copies of a node.
    fn warn_of_link(
        &mut self,
        scope: usize,
        link: &LightLink,
        relation: LightRelation,
        path: &NodePath,
    ) {
        if self.scopes[scope].values.is_none() {
            let idle = link.idle_warnings(relation, "", &self.look.lights).into_iter();
            self.problems.extend(idle.map(|problem| problem.node(path.clone())));
        }
    }

    /// Warns of a link of a node that no light reaches by name.
    pub(super) fn check_layered(
        &mut self,
        scope: usize,
        node: &Node,
        def: &NodeDef,
        path: &NodePath,
    ) {
        let names_light = def.joins_lights() || def.inputs.iter().any(is_light_name);
        if names_light || node.links.layered_link().is_all() || self.scopes[scope].values.is_some()
        {
            return;
        }
        let message =
            tr!("`layered` is for groups, and for nodes that name a light: this one does not");
        self.problems.push(
            Diagnostic::warning("no-light", message).node(path.clone()).hint(tr!(
                "set it on the node that its light comes from, or on a group around both"
            )),
        );
    }

    /// Notes a node that some lights pass by.
    pub(super) fn note_filter(
        &mut self,
        scope: usize,
        id: &'a NodeId,
        node: &Node,
        path: &NodePath,
    ) {
        let link = node.links.filtered_link();
        if !link.is_all() {
            self.warn_of_link(scope, &link, LightRelation::Filtered, path);
            self.filters.push(FilterNode { scope, id, path: path.clone(), link });
        }
    }

    /// Finds the nodes that the light on its way through them passes by.
    pub(super) fn find_passed_by(&mut self) {
        for FilterNode { scope, id, path, link } in std::mem::take(&mut self.filters) {
            let Some((inputs, outputs)) = self.ports_at(scope, id) else { continue };
            let can_be_left_out = outputs.iter().all(|output| {
                let_through(&inputs, output).is_some() || stand_in_of(&output.ty, 1.0).is_some()
            });
            let problem = |message: &str, hint: &str| {
                Diagnostic::warning("not-a-filter", message).node(path.clone()).hint(hint)
            };
            let is_first = self.scopes[scope].values.is_none();
            if !can_be_left_out {
                self.problems.extend(is_first.then(|| {
                    problem(
                        tr!("`filtered` is for nodes that let a light through: this one makes \
                         something else of it"),
                        tr!("set it on a Light filter, or on a node that gives one its share"),
                    )
                }));
                continue;
            }
            match self.light_through(scope, id) {
                Some(light) => {
                    let all = self.look.lights.keys().cloned().collect();
                    if !link.lights_within(&self.look.lights, &all).contains(&light) {
                        self.passed_by.insert((scope, id.as_str()));
                    }
                }
                None => self.problems.extend(is_first.then(|| {
                    problem(
                        tr!(
                            "`filtered` is for nodes that one light passes through, which is known \
                         where it is named: here it is not"
                        ),
                        tr!("set it where the light has not been joined with others"),
                    )
                })),
            }
        }
        // Ends that were found on the way know nothing of what is passed by.
        self.ends.clear();
    }

    /// Ports of a node or group.
    fn ports_at(&self, scope: usize, id: &NodeId) -> Option<(Vec<Input>, Vec<Output>)> {
        match self.scopes[scope].slots.get(id.as_str())? {
            FlatSlot::Flat(index) => {
                let def = &self.flat.nodes[*index].def;
                Some((def.inputs.clone(), def.outputs.clone()))
            }
            FlatSlot::Group(child) => {
                let group = &self.groups[self.scopes[*child].group?];
                let ports = self.ports_of(group.kind, group.definition);
                Some((ports.inputs.clone(), ports.outputs.clone()))
            }
            FlatSlot::Missing => None,
        }
    }

    /// The light that passes through a node: the one that it names, or that the only light on a
    /// wire into it comes from.
    fn light_through(&mut self, scope: usize, id: &'a NodeId) -> Option<LightId> {
        let mut at = (scope, id);
        for _ in 0..=self.origins.len() {
            let (inputs, _) = self.ports_at(at.0, at.1)?;
            if let Some(named) = inputs.iter().find(|input| is_light_name(input)) {
                return self.light_named(at.0, at.1, &named.name);
            }
            let mut wired = inputs.iter().filter(|input| input.ty == Type::Light);
            let (Some(input), None) = (wired.next(), wired.next()) else { return None };
            let WireEnd::Output { node, .. } = self.end_of(at.0, at.1, &input.name) else {
                return None;
            };
            let (scope, id, _) = *self.origins.get(node)?;
            at = (scope, id);
        }
        None
    }

    /// The light that an input names: by its id, else that of the copy, else the look's first.
    fn light_named(&mut self, scope: usize, id: &'a NodeId, port: &PortName) -> Option<LightId> {
        let text = self.text_at(scope, id, port).unwrap_or_default();
        if !text.is_empty() {
            let light = self.look.lights.get_key_value(text.as_str());
            return light.map(|(id, _)| id.clone());
        }
        let of_copy = self.place_of(scope).and_then(|place| place.light);
        of_copy.or_else(|| self.look.lights.keys().next().cloned())
    }

    /// The text of an input that is not wired, through the groups around it.
    fn text_at(&mut self, scope: usize, id: &'a NodeId, port: &PortName) -> Option<String> {
        let WireEnd::Open { scope, id, port, fallback } = self.end_of(scope, id, port) else {
            return None;
        };
        let own = self.scopes[scope].graph.nodes.get(id).and_then(|node| node.values.get(&port));
        match (own, fallback) {
            (Some(Value::Text(text)), _) => Some(text.clone()),
            (None, Some(Fallback::Value(Value::Text(text)))) => Some(text),
            _ => None,
        }
    }

    /// The value of an input that tells of the light that its node names, in a region or not.
    pub(super) fn fed_by_name(&mut self, index: usize, feed: &LightFeed) -> Option<FlatInput> {
        let (scope, id, _) = self.origins[index];
        let def = self.flat.nodes[index].def.clone();
        let named = def.inputs.iter().find(|input| is_light_name(input))?;
        let light = self.light_named(scope, id, &named.name)?;
        let number = match feed {
            LightFeed::Number => Light::number_of(&light),
            LightFeed::Member(port) => {
                let set = self.set_at(index, port)?;
                let members = set.of(&self.look.lights, &BTreeSet::new());
                f64::from(u8::from(members.contains(&light)))
            }
            _ => return None,
        };
        Some(FlatInput::Fixed(Value::Number(number)))
    }

    /// The set of lights that an input says, of which what is wrong is told once for all copies.
    fn set_at(&mut self, index: usize, port: &PortName) -> Option<LightSet> {
        let (scope, id, _) = self.origins[index];
        let def = self.flat.nodes[index].def.clone();
        let default = match def.input(port.as_str()).map(|input| &def.inputs[input].fallback) {
            Some(Fallback::Value(Value::Text(text))) => text.clone(),
            _ => String::new(),
        };
        let text = self.text_at(scope, id, port).unwrap_or(default);
        let path = self.flat.nodes[index].path.clone();
        let is_first = self.scopes[scope].values.is_none();
        match LightSet::parse(&text) {
            Ok(set) => {
                if is_first {
                    let idle = set.idle_warnings(&format!("`{port}`"), &self.look.lights);
                    let on_port =
                        |problem: Diagnostic| problem.node(path.clone()).port(port.clone());
                    self.problems.extend(idle.into_iter().map(on_port));
                }
                Some(set)
            }
            Err(why) => {
                let problem = Diagnostic::error(Light::BAD, format!("`{text}`: {why}"));
                let problem = problem.node(path).port(port.clone()).hint(Light::EXAMPLE.tr());
                self.problems.extend(is_first.then_some(problem));
                None
            }
        }
    }
}

fn is_light_name(input: &Input) -> bool {
    input.ty == Type::LightName
}
