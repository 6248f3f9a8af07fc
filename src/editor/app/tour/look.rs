//! Tour of a first look: the text of each step, its target, the test of whether it is done, and the
//! commands that do it.

use chiaro_locale::{text, trn};

use super::{Step, StepStart, Suggestion, TourRow, TourTexts};
use crate::commands::{Command, PanelId, TourTopic, ViewCommand};
use crate::document::{Edit, GraphId, Node, Value};
use crate::ids::NodeId;
use crate::panels::layers;
use crate::state::session::Session;
use crate::state::stack::Stack;
use crate::widgets::spots::Spot;

/// Inputs of a layer that shape its profile.
const PROFILE: [&str; 3] = ["offset", "falloff", "cutoff"];
/// Inputs of a layer that blend it.
const BLENDING: [&str; 2] = ["blend", "opacity"];
/// Smallest turn of the lights that counts as one, in radians.
const TURNED: f64 = 0.05;

/// Text of the look that the tour begins with: a base, and a light that nothing is lit by yet.
const NOTHING: &str = r##"{
  "chiaro": "look",
  "version": 1,
  "name": "First look",
  "lights": {"key": {"direction": [-0.5, 0.7, 0.6]}},
  "nodes": [
    {"id": "base", "kind": "base", "at": [0, 0], "values": {"color": [0.5, 0.5, 0.5]}},
    {"id": "output", "kind": "output", "at": [520, 0]}
  ],
  "wires": [{"from": "base", "to": "output.color"}]
}"##;

/// The tour.
pub(super) static TOUR: TourRow = TourRow {
    steps: &STEPS,
    texts: TourTexts {
        title: text!("This is your look"),
        made: |session| {
            let nodes = session.look().graph.nodes.values();
            let count = nodes.filter(|node| node.kind == "light_layer").count();
            trn!(
                count,
                "{count} layer over a base: everything in Chiaro is made this way. The graph in \
                 the middle is the same look, where anything can be wired to anything.",
                "{count} layers over a base: everything in Chiaro is made this way. The graph in \
                 the middle is the same look, where anything can be wired to anything."
            )
        },
        more: text!(
            "Drop a mesh of yours on the window to see it there. Copy as, above, takes the picture \
             or the shader with you."
        ),
        next: &NEXT,
    },
    begin: |session| session.start_from(NOTHING, "first look"),
};

/// Suggestions at the end of the tour.
static NEXT: [Suggestion; 4] = [
    (
        text!("Light a scene"),
        text!("The tour of lights, links and shadows, on three gray objects"),
        Command::StartTour(TourTopic::Lights),
    ),
    (
        text!("See the examples"),
        text!("All of them, as pictures: open one and take it apart"),
        Command::ShowStart(true),
    ),
    (text!("All shortcuts"), text!("What every key does (?)"), Command::OpenShortcuts),
    (
        text!("Find a command"),
        text!("Everything that the window can do, by name (Ctrl+P)"),
        Command::OpenPalette,
    ),
];

/// Steps from nothing to a look.
static STEPS: [Step; 7] = [
    Step {
        title: text!("The base"),
        task: text!("Click Base in the stack of layers, then change its color."),
        reason: text!(
            "It is what is seen where no light falls. Painters begin dark and leave room for the \
             light."
        ),
        panels: &[PanelId::PICTURE, PanelId::LAYERS, PanelId::INSPECTOR],
        spots: |session| match ground(session) {
            Some(base) if session.selection.nodes.contains(&base) => {
                vec![Spot::Input("color".into()), Spot::Layer(base)]
            }
            Some(base) => vec![Spot::Layer(base), Spot::Panel(PanelId::LAYERS)],
            None => vec![Spot::Panel(PanelId::LAYERS)],
        },
        is_done: |session, before| {
            ground(session).is_some_and(|base| is_changed(session, before, &base, &["color"]))
        },
        show: |session| {
            let color = Value::Vector(vec![0.17, 0.1, 0.15]);
            ground(session).map_or_else(Vec::new, |base| set(session, &base, &[("color", color)]))
        },
    },
    Step {
        title: text!("A first layer of light"),
        task: text!("Press Add layer and choose Diffuse."),
        reason: text!(
            "A layer is a light, the way it moves over the surface, a profile and two colors. \
             Diffuse light stays where it falls; a highlight follows the eye."
        ),
        panels: &[PanelId::PICTURE, PanelId::LAYERS],
        spots: |_| vec![Spot::AddLayer, Spot::Panel(PanelId::LAYERS)],
        is_done: has_more_layers,
        show: |session| layers::add_preset(session, "Diffuse"),
    },
    Step {
        title: text!("Its profile"),
        task: text!("Drag the handles of the curve: offset, fall-off and cut-off."),
        reason: text!(
            "Up to the offset the tone is full, at the cut-off it is gone. Bring them together for \
             the edge of a cartoon, apart for something soft."
        ),
        panels: &[PanelId::PICTURE, PanelId::PROFILE, PanelId::INSPECTOR],
        spots: |_| vec![Spot::Panel(PanelId::PROFILE), Spot::Input("offset".into())],
        is_done: |session, before| any_layer_changed(session, before, &PROFILE),
        show: |session| {
            let values = [("offset", 0.75), ("falloff", 1.15), ("cutoff", 1.5)];
            let values = values.map(|(port, angle)| (port, Value::Number(angle)));
            top_layer(session).map_or_else(Vec::new, |layer| set(session, &layer, &values))
        },
    },
    Step {
        title: text!("Turn the light"),
        task: text!("Drag on the object, beside its colored lines."),
        reason: text!(
            "The light turns with your hand, and so do all lights of the look: they hang in one \
             frame. A drag on a line shapes the layer, and a drag beside the object turns the \
             camera."
        ),
        panels: &[PanelId::PICTURE],
        spots: |_| vec![Spot::Picture],
        is_done: is_light_turned,
        show: |session| {
            let mut view = session.view.orbit.clone();
            view.turn_lights(-0.1, -0.04);
            vec![Command::View(ViewCommand::TurnTo(Box::new(view)))]
        },
    },
    Step {
        title: text!("A rim from behind"),
        task: text!("Press Add layer again and choose Back-light."),
        reason: text!(
            "It brings a light of its own, behind the object as you see it now: its cool rim parts \
             the object from what is behind."
        ),
        panels: &[PanelId::PICTURE, PanelId::LAYERS],
        spots: |_| vec![Spot::AddLayer, Spot::Panel(PanelId::LAYERS)],
        is_done: has_more_layers,
        show: |session| layers::add_preset(session, "Back-light"),
    },
    Step {
        title: text!("How layers meet"),
        task: text!("In a layer's row, choose another blending or drag its opacity."),
        reason: text!(
            "Add brightens what is below, multiply darkens it, alpha covers it. The order counts \
             too: drag rows."
        ),
        panels: &[PanelId::PICTURE, PanelId::LAYERS],
        spots: |session| {
            top_layer(session)
                .map(Spot::Layer)
                .into_iter()
                .chain([Spot::Panel(PanelId::LAYERS)])
                .collect()
        },
        is_done: |session, before| any_layer_changed(session, before, &BLENDING),
        show: |session| {
            let opacity = Value::Number(0.7);
            top_layer(session)
                .map_or_else(Vec::new, |layer| set(session, &layer, &[("opacity", opacity)]))
        },
    },
    Step {
        title: text!("Keep it"),
        task: text!("Press Save and choose where."),
        reason: text!(
            "A look is a small text file, and Recent will have it. What is not saved is kept too, \
             until you are back."
        ),
        panels: &[PanelId::PICTURE],
        spots: |_| vec![Spot::Save],
        is_done: |session, _| session.path().is_some() && !session.is_dirty(),
        show: |_| vec![Command::Save],
    },
];

fn stack(session: &Session) -> Stack {
    Stack::of(session.look(), &session.project.catalog)
}

/// The node that the lowest layer lies on.
fn ground(session: &Session) -> Option<NodeId> {
    stack(session).ground.map(|ground| ground.node)
}

/// The layer that was last worked on, or else the uppermost.
fn top_layer(session: &Session) -> Option<NodeId> {
    let stack = stack(session);
    let selected = session.selection.nodes.last().filter(|id| stack.index_of(id).is_some());
    selected.or(stack.layers.first().map(|layer| &layer.id)).cloned()
}

fn has_more_layers(session: &Session, before: &StepStart) -> bool {
    stack(session).layers.len() > Stack::of(&before.look, &session.project.catalog).layers.len()
}

fn any_layer_changed(session: &Session, before: &StepStart, ports: &[&str]) -> bool {
    stack(session).layers.iter().any(|layer| is_changed(session, before, &layer.id, ports))
}

/// True if any of these inputs of a node that was there before has another value.
fn is_changed(session: &Session, before: &StepStart, id: &NodeId, ports: &[&str]) -> bool {
    let Some(old) = before.look.graph.nodes.get(id) else { return false };
    let now = session.look().graph.nodes.get(id);
    ports.iter().any(|port| value(Some(old), port) != value(now, port))
}

fn is_light_turned(session: &Session, before: &StepStart) -> bool {
    let lights = &session.look().lights;
    let is_other = |(id, light): (_, &crate::document::Light)| {
        lights
            .get(id)
            .is_some_and(|now| (now.direction, now.position) != (light.direction, light.position))
    };
    session.view.orbit.illumination.angle_between(before.illumination) > TURNED
        || before.look.lights.iter().any(is_other)
}

fn value<'a>(node: Option<&'a Node>, port: &str) -> Option<&'a Value> {
    node?.values.get(port)
}

/// Commands that set values of a node, as one step, and select it.
fn set(session: &Session, id: &NodeId, values: &[(&str, Value)]) -> Vec<Command> {
    let edit = |(port, value): &(&str, Value)| {
        let (port, value) = ((*port).into(), value.clone());
        Edit::SetValue { graph: GraphId::Look, id: id.clone(), port, value, index: None }
    };
    let edits = values.iter().map(edit).collect();
    let leave =
        (!session.selection.open_groups().is_empty()).then(|| Command::OpenGraph(Vec::new()));
    let select = Command::Select(vec![id.clone()]);
    leave.into_iter().chain([Command::Edit(Edit::Group { edits }), select]).collect()
}
