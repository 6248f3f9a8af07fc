//! The selected filter of a light, as far as it can be edited in the picture.

use eframe::egui::Id;
use glam::DVec3;

use crate::catalog::NodeKind;
use crate::commands::Command;
use crate::document::Value;
use crate::fields::layer::light_at_hand;
use crate::ids::{LightId, NodeId};
use crate::library::Type;
use crate::state::reading::of_library;
use crate::state::session::Session;
use crate::values;

/// Kind of a filter that has handles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FilterKind {
    Blocker,
    Rod,
    BarnDoors,
    /// A picture that a light throws: a gobo, or the coordinates of any pattern.
    Picture,
    Decay,
    DistanceRamp,
}

/// Kinds of nodes that have handles.
const KINDS: [(&str, FilterKind); 7] = [
    ("blocker", FilterKind::Blocker),
    ("rod", FilterKind::Rod),
    ("barn_doors", FilterKind::BarnDoors),
    ("light_place", FilterKind::Picture),
    ("gobo", FilterKind::Picture),
    ("decay", FilterKind::Decay),
    ("distance_ramp", FilterKind::DistanceRamp),
];

/// Node of a filter that is selected.
pub(crate) struct SelectedFilter<'s> {
    session: &'s Session,
    pub(crate) node: NodeId,
    pub(crate) name: String,
    pub(crate) kind: FilterKind,
    of: &'s NodeKind,
    /// Light that is filtered: the one that the node names, or in a group that runs for each light
    /// the one at hand.
    pub(crate) light: Option<LightId>,
}

impl<'s> SelectedFilter<'s> {
    /// The node that was selected last, if it is a filter that can be edited.
    pub(crate) fn of(session: &'s Session) -> Option<Self> {
        if session.graph_view().is_read_only() {
            return None;
        }
        let (id, node) = session.graph().nodes.get_key_value(session.selection.nodes.last()?)?;
        let (_, kind) = *KINDS.iter().find(|(name, _)| node.kind == *name)?;
        let of = session.project.catalog.of(node)?;
        let name =
            if node.name.is_empty() { of_library(&of.label).to_owned() } else { node.name.clone() };
        let named = of.inputs.iter().find(|port| port.ty == Type::LightName);
        let named =
            named.and_then(|port| match values::current(port, node.values.get(&port.name)) {
                Some(Value::Text(id)) if !id.is_empty() => Some(LightId::new(id.as_str())),
                _ => None,
            });
        let first = || session.look().lights.keys().next().cloned();
        let light = named.or_else(|| light_at_hand(session)).or_else(first);
        Some(Self { session, node: id.clone(), name, kind, of, light })
    }

    /// Present value of an input.
    fn value(&self, port: &str) -> Option<Value> {
        self.of.input(port)?;
        let target = self.session.selection.target(&self.node, &port.into());
        self.session.keys().value_now(&target)
    }

    /// Present number of an input; 0 where it has none.
    pub(crate) fn number(&self, port: &str) -> f64 {
        let number = values::number(self.value(port).as_ref());
        if number.is_finite() { number } else { 0.0 }
    }

    /// Present vector of an input; 0 where it has none.
    pub(crate) fn vector(&self, port: &str) -> DVec3 {
        match self.value(port) {
            Some(Value::Vector(numbers)) if numbers.len() == 3 => {
                Some(DVec3::from_slice(&numbers)).filter(|v| v.is_finite()).unwrap_or_default()
            }
            Some(Value::Number(number)) if number.is_finite() => DVec3::splat(number),
            _ => DVec3::ZERO,
        }
    }

    /// Word of an input with choices.
    pub(crate) fn word(&self, port: &str) -> &'s str {
        let (of, node) = (self.of, self.session.graph().nodes.get(&self.node));
        let port = of.input(port).map(|index| &of.inputs[index]);
        let value = port.and_then(|port| values::current(port, node?.values.get(&port.name)));
        match value {
            Some(Value::Text(word)) => word,
            _ => "",
        }
    }

    /// True if an input comes by a wire, or is not there.
    pub(crate) fn is_wired(&self, port: &str) -> bool {
        self.of.input(port).is_none()
            || self.session.graph().wire_into(&self.node, &port.into()).is_some()
    }

    /// Command that sets an input, as part of the step that goes on while `held` is held; `None`
    /// where nothing changes.
    pub(crate) fn set(
        &self,
        session: &Session,
        port: &str,
        value: Value,
        held: Id,
    ) -> Option<Command> {
        let target = session.selection.target(&self.node, &port.into());
        let is_new = session.keys().value_at(&target).as_ref() != Some(&value);
        is_new.then(|| Command::EditHeld(held, session.keys().set_at(&target, value)))
    }
}
