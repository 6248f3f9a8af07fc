//! Parting of what a step of a stack adds among the lights that it comes of.
//!
//! A share of 1 goes up the wires from the step. Where a node brings lights together the share is
//! cut in two: for what lies before the node's own light, and for the rest. Ways end where no more
//! than one light is left. Cuts of sums are proportional, and only right while everything between
//! the node and the step keeps proportions; those of a winner are right whatever follows, for all
//! that follows is the winner's. A sum behind a node that bends it is refused with the name of that
//! node, and all lights keep the share together.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use super::check::{TypedGraph, TypedNode, TypedSource};
use crate::ids::LightId;
use crate::library::{Treatment, Type};

/// Greatest number of nodes that are looked at for one step; a step behind more is not parted.
const MAX_VISITS: usize = 200_000;

/// Lights that each node depends on, by the node's index.
pub(super) type LightsByNode = Vec<Arc<BTreeSet<LightId>>>;

/// Rule by which a node that brings lights together cuts a share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CutRule {
    /// By the parts of a sum.
    Sum,
    /// All to the greater one, channel by channel.
    Greatest,
    /// Remainder that a layer leaves of those below it.
    Over,
    /// By weights: the input and the output that count them.
    Mean(&'static str, &'static str),
    /// By a factor from the one to the other: the input of that name.
    Factor(&'static str),
    /// All to the one of the greater number: the input and the output that hold it.
    Winner(&'static str, &'static str),
    /// All to the one that goes out as it is.
    Either,
}

impl CutRule {
    /// True if all goes to one of the two, so that what follows may do anything with it.
    fn is_choice(self) -> bool {
        matches!(self, Self::Greatest | Self::Winner(..) | Self::Either)
    }
}

/// Row of a kind of nodes that bring lights together.
struct JoinRow {
    kind: &'static str,
    /// The input that has the first part of a cut.
    first: &'static str,
    /// The input that has the rest.
    second: &'static str,
    rule: CutRule,
}

const JOINS: [JoinRow; 10] = [
    JoinRow { kind: "sum_of_lights", first: "before_sum", second: "value", rule: CutRule::Sum },
    JoinRow { kind: "add", first: "a", second: "b", rule: CutRule::Sum },
    JoinRow {
        kind: "greatest_of_lights",
        first: "before_greatest",
        second: "value",
        rule: CutRule::Greatest,
    },
    JoinRow { kind: "maximum", first: "a", second: "b", rule: CutRule::Greatest },
    JoinRow {
        kind: "layers_of_lights",
        first: "before_layers",
        second: "color",
        rule: CutRule::Over,
    },
    JoinRow {
        kind: "mix_of_lights",
        first: "before_mix",
        second: "color",
        rule: CutRule::Mean("before_weights", "weights"),
    },
    JoinRow { kind: "mix_values", first: "a", second: "b", rule: CutRule::Factor("factor") },
    JoinRow {
        kind: "strongest_of_lights",
        first: "before_color",
        second: "color",
        rule: CutRule::Winner("before_strength", "strength"),
    },
    JoinRow {
        kind: "first_of_lights",
        first: "before_color",
        second: "color",
        rule: CutRule::Winner("before_priority", "priority"),
    },
    JoinRow { kind: "dominant_light", first: "a", second: "b", rule: CutRule::Either },
];

/// Inputs to which nodes are in proportion, channel by channel, or of which they only leave less.
const PROPORTIONAL: [(&str, &[&str]); 6] = [
    ("multiply", &["a", "b"]),
    ("divide", &["a"]),
    ("clamp_range", &["value"]),
    ("set_alpha", &["color"]),
    ("base", &["color"]),
    ("limit_color", &["color"]),
];

/// Cut of a share in two. The parts of the first cut are the shares 1 and 2, those of the next one
/// 3 and 4, and so on.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShareCut {
    /// Share that is cut; 0 is the whole.
    pub(super) share: usize,
    /// The node that brings the lights together.
    pub(super) node: usize,
    /// The output that the share came from.
    pub(super) output: usize,
    /// The input that the first part goes to.
    pub(super) first: usize,
    /// The rule.
    pub(super) rule: CutRule,
}

/// Sum that was not cut, for something bends it.
#[derive(Clone, Debug)]
pub(super) struct BentSum {
    /// The node that bends it.
    pub(super) node: usize,
    /// The output that goes into that node; `None` where several do.
    pub(super) value: Option<(usize, usize)>,
    /// The node's lit inputs with the outputs that go into them, where there are several.
    pub(super) inputs: Vec<(usize, (usize, usize))>,
    /// Nodes from the step to the one that bends, each with the input that the way went through;
    /// `None` where the way parted on it.
    pub(super) chain: Option<Vec<(usize, usize)>>,
}

/// Shares of a step among lights.
#[derive(Clone, Debug, Default)]
pub(super) struct LightShares {
    /// The cuts, each after the one that made its share.
    pub(super) cuts: Vec<ShareCut>,
    /// Shares that are cut no further, with their lights: one, none, or all that cannot be parted.
    pub(super) ends: Vec<(usize, BTreeSet<LightId>)>,
    /// Sums that were not cut.
    pub(super) bent: Vec<BentSum>,
}

/// A wire on the way up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Lead {
    source: (usize, usize),
    /// The input that it goes into.
    into: Option<(usize, usize)>,
}

/// A share on its way up.
struct SharePath {
    share: usize,
    /// The node whose inputs are gone into.
    at: usize,
    leads: Vec<Lead>,
    /// The node that bends, the last on the way, with what goes into it.
    bent: Option<(usize, Option<(usize, usize)>)>,
    /// Nodes on the way with their inputs, and how many of them there are up to the one that bends.
    chain: Option<Vec<(usize, usize)>>,
    chain_to_bent: usize,
}

impl JoinRow {
    fn of(node: &TypedNode) -> Option<&'static Self> {
        JOINS.iter().find(|row| row.kind == node.def.kind)
    }
}

impl TypedGraph {
    /// The lights that each node depends on.
    pub(super) fn lights_by_node(&self) -> LightsByNode {
        let none = Arc::new(BTreeSet::new());
        let mut lights = vec![none; self.nodes.len()];
        for &index in &self.order {
            let node = &self.nodes[index];
            let own = node.light.as_ref().filter(|_| !node.is_unlit);
            let before = node.inputs.iter().flatten().filter_map(|input| match input.source {
                TypedSource::Wire { node, .. } => Some(&lights[node]),
                _ => None,
            });
            // Most nodes depend on what one of their inputs does.
            let mut all: Arc<BTreeSet<LightId>> = Arc::default();
            for found in before {
                if found.is_superset(&all) {
                    all = found.clone();
                } else if !found.is_subset(&all) {
                    Arc::make_mut(&mut all).extend(found.iter().cloned());
                }
            }
            if let Some(own) = own.filter(|own| !all.contains(*own)) {
                Arc::make_mut(&mut all).insert(own.clone());
            }
            lights[index] = all;
        }
        lights
    }

    /// Parts a step among lights by its inputs but the one for what is below.
    pub(super) fn part_step(
        &self,
        lights: &LightsByNode,
        index: usize,
        below: usize,
    ) -> LightShares {
        let leads = self.leads(index).filter(|lead| lead.into != Some((index, below))).collect();
        let mut parting = self.part(lights, index, leads);
        // The step itself is no part of what bends.
        for chain in parting.bent.iter_mut().filter_map(|sum| sum.chain.as_mut()) {
            chain.drain(..chain.len().min(1));
        }
        parting
    }

    /// Parts an output of a node among lights.
    pub(super) fn part_output(&self, lights: &LightsByNode, source: (usize, usize)) -> LightShares {
        self.part(lights, source.0, vec![Lead { source, into: None }])
    }

    fn leads(&self, index: usize) -> impl Iterator<Item = Lead> + '_ {
        (0..self.nodes[index].inputs.len()).filter_map(move |input| {
            let source = self.wire(index, input)?;
            Some(Lead { source, into: Some((index, input)) })
        })
    }

    fn part(&self, lights: &LightsByNode, at: usize, leads: Vec<Lead>) -> LightShares {
        let mut parting = LightShares::default();
        let mut visits = 0;
        let whole = SharePath {
            share: 0,
            at,
            leads,
            bent: None,
            chain: Some(Vec::new()),
            chain_to_bent: 0,
        };
        let mut open = vec![whole];
        while let Some(mut way) = open.pop() {
            visits += 1;
            way.leads.retain(|lead| !lights[lead.source.0].is_empty());
            let all: BTreeSet<LightId> =
                way.leads.iter().flat_map(|lead| lights[lead.source.0].iter().cloned()).collect();
            if all.len() < 2 {
                parting.ends.push((way.share, all));
                continue;
            }
            let Some(lead) = self.only_lead(lights, &mut way, &mut visits) else {
                parting.refuse(way, all);
                continue;
            };
            if visits > MAX_VISITS {
                parting.refuse(way, all);
                continue;
            }
            if let Some((node, input)) = lead.into {
                way.walk(self, (node, input), lead.source);
            }
            self.go_through(lights, lead.source, way, (&mut parting, &mut open), all);
        }
        parting
    }

    /// Goes through the node of an output: cuts the share there, or follows what is lit.
    fn go_through(
        &self,
        lights: &LightsByNode,
        (index, output): (usize, usize),
        mut way: SharePath,
        (parting, open): (&mut LightShares, &mut Vec<SharePath>),
        all: BTreeSet<LightId>,
    ) {
        way.at = index;
        let Some((row, first, second)) = self.join(lights, index) else {
            way.leads = self.leads(index).collect();
            open.push(way);
            return;
        };
        let node = &self.nodes[index];
        let own = node.light.clone().filter(|_| node.def.joins_lights() && !node.is_unlit);
        let lead = |input: usize| {
            let source = self.wire(index, input)?;
            Some(Lead { source, into: Some((index, input)) })
        };
        let of_second = |share: usize,
                         way: &SharePath,
                         parting: &mut LightShares,
                         open: &mut Vec<SharePath>| {
            let lead = lead(second);
            let mut known: BTreeSet<LightId> =
                lead.map(|lead| (*lights[lead.source.0]).clone()).unwrap_or_default();
            known.extend(own.clone());
            // What one light brings in is that light's.
            if known.len() < 2 {
                parting.ends.push((share, known));
            } else {
                let leads = lead.into_iter().collect();
                open.push(SharePath { share, leads, ..way.after_cut(index) });
            }
        };
        let Some(before) = lead(first) else {
            // The first light of a region has none before it.
            if node.def.joins_lights() {
                of_second(way.share, &way, parting, open);
                return;
            }
            // A constant beside what is lit.
            if way.bent.is_some() && !row.rule.is_choice() {
                way.leads = self.leads(index).collect();
                open.push(way);
                return;
            }
            let place = parting.cut(way.share, (index, output), first, row.rule);
            parting.ends.push((place, BTreeSet::new()));
            of_second(place + 1, &way, parting, open);
            return;
        };
        if way.bent.is_some() && !row.rule.is_choice() {
            let is_lit = |lead: Lead| !lights[lead.source.0].is_empty();
            if is_lit(before) && (own.is_some() || lead(second).is_some_and(is_lit)) {
                parting.refuse(way, all);
            } else {
                way.leads = self.leads(index).collect();
                open.push(way);
            }
            return;
        }
        let place = parting.cut(way.share, (index, output), first, row.rule);
        open.push(SharePath { share: place, leads: vec![before], ..way.after_cut(index) });
        of_second(place + 1, &way, parting, open);
    }

    /// The row of a node that brings lights together, with its two inputs; `None` for all others.
    fn join(
        &self,
        lights: &LightsByNode,
        index: usize,
    ) -> Option<(&'static JoinRow, usize, usize)> {
        let node = &self.nodes[index];
        let row = JoinRow::of(node).filter(|_| node.inputs.len() == node.def.inputs.len())?;
        let (first, second) = (self.input(index, row.first)?, self.input(index, row.second)?);
        // Lights have no channels, and vectors other ones than colors.
        let is_color = |input: usize| {
            let ty = node.inputs[input].as_ref().map(|input| &input.ty);
            row.rule == CutRule::Either
                || matches!(
                    ty,
                    Some(Type::Float | Type::Color | Type::Composite | Type::Vec3 | Type::Vec4)
                )
        };
        if let CutRule::Factor(name) = row.rule {
            let factor = self.wire(index, self.input(index, name)?);
            if factor.is_some_and(|(factor, _)| !lights[factor].is_empty()) {
                return None;
            }
        }
        (is_color(first) && is_color(second)).then_some((row, first, second))
    }

    /// The one output that all ways of a share lead to; `None` where there are several.
    fn only_lead(
        &self,
        lights: &LightsByNode,
        way: &mut SharePath,
        visits: &mut usize,
    ) -> Option<Lead> {
        let first = *way.leads.first()?;
        if way.leads.iter().all(|lead| lead.source == first.source) {
            if way.leads.len() > 1 {
                // A product of something with itself.
                way.bend(way.at, Some(first.source));
                way.chain = None;
                return Some(Lead { into: None, ..first });
            }
            return Some(first);
        }
        // Whatever lies between, it may only come of one place where lights are brought together.
        let mut found = None;
        let mut seen = HashSet::new();
        let mut open = way.leads.clone();
        while let Some(lead) = open.pop() {
            let (index, _) = lead.source;
            if lights[index].is_empty() || !seen.insert(lead.source) {
                continue;
            }
            *visits += 1;
            if *visits > MAX_VISITS {
                return None;
            }
            if lights[index].len() > 1 && self.join(lights, index).is_some() {
                if found.is_some_and(|found| found != lead.source) {
                    return None;
                }
                found = Some(lead.source);
                continue;
            }
            if self.nodes[index].light.is_some() {
                return None;
            }
            open.extend(self.leads(index));
        }
        let source = found?;
        way.bend(way.at, Some(source));
        way.chain = None;
        Some(Lead { source, into: None })
    }
}

impl LightShares {
    /// Cuts a share; returns the first of its two parts.
    fn cut(
        &mut self,
        share: usize,
        (node, output): (usize, usize),
        first: usize,
        rule: CutRule,
    ) -> usize {
        self.cuts.push(ShareCut { share, node, output, first, rule });
        2 * self.cuts.len() - 1
    }

    fn refuse(&mut self, way: SharePath, lights: BTreeSet<LightId>) {
        let (node, value) = way.bent.unwrap_or((way.at, None));
        let chain = way.chain.filter(|_| value.is_some()).map(|mut chain| {
            chain.truncate(way.chain_to_bent);
            chain
        });
        if !self.bent.iter().any(|known| known.node == node && known.value == value) {
            let several = way.leads.iter().filter(|_| way.bent.is_none());
            let inputs = several.filter_map(|lead| Some((lead.into?.1, lead.source))).collect();
            self.bent.push(BentSum { node, value, inputs, chain });
        }
        self.ends.push((way.share, lights));
    }

    /// The shares of each set of lights, added up: `(lights, shares)`.
    pub(super) fn by_lights(&self) -> Vec<(BTreeSet<LightId>, Vec<usize>)> {
        let mut places: HashMap<&BTreeSet<LightId>, usize> = HashMap::new();
        let mut found: Vec<(BTreeSet<LightId>, Vec<usize>)> = Vec::new();
        for (share, lights) in &self.ends {
            let place = *places.entry(lights).or_insert(found.len());
            match found.get_mut(place) {
                Some((_, shares)) => shares.push(*share),
                None => found.push((lights.clone(), vec![*share])),
            }
        }
        found
    }
}

impl SharePath {
    /// Notes a node that the way goes through by one of its inputs.
    fn walk(&mut self, graph: &TypedGraph, (index, input): (usize, usize), source: (usize, usize)) {
        if let Some(chain) = &mut self.chain {
            chain.push((index, input));
        }
        if !graph.keeps_proportions(index, input, source) {
            self.bend(index, Some(source));
        }
    }

    fn bend(&mut self, node: usize, value: Option<(usize, usize)>) {
        self.bent = Some((node, value));
        self.chain_to_bent = self.chain.as_ref().map_or(0, Vec::len);
    }

    /// The way after a cut at a node. What bent before it bends what comes then, too.
    fn after_cut(&self, at: usize) -> Self {
        Self {
            share: self.share,
            at,
            leads: Vec::new(),
            bent: self.bent,
            chain: None,
            chain_to_bent: 0,
        }
    }
}

impl TypedGraph {
    /// True if a node is in proportion to an input, channel by channel; so are steps of a stack.
    fn keeps_proportions(&self, index: usize, input: usize, source: (usize, usize)) -> bool {
        let node = &self.nodes[index];
        let Some(port) = node.def.inputs.get(input) else { return false };
        let from = self.nodes[source.0].output_type(source.1);
        let into = node.inputs[input].as_ref().map(|input| &input.ty);
        // One number of a color has something of all its channels.
        if matches!(into, Some(Type::Float)) && from != Type::Float {
            return false;
        }
        let name = port.name.as_str();
        let known = PROPORTIONAL.iter().find(|(kind, _)| *kind == node.def.kind);
        node.def.special == Treatment::Reroute
            || super::aov::is_step(node)
            || JoinRow::of(node).is_some_and(|row| [row.first, row.second].contains(&name))
            || known.is_some_and(|(_, inputs)| inputs.contains(&name))
    }
}
