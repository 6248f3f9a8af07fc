//! Profile of a layer as a curve over the angle, with its offset, fall-off and cut-off as handles,
//! and the resulting colors from convex to concave.

mod plot;
mod sample;
mod strip;

use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::Arc;

use chiaro_locale::{Text, text, tr, tr_in};
use eframe::egui;
use eframe::egui::{Button, ComboBox, Label, RichText, ScrollArea, Ui, vec2};

use crate::catalog::NodeKind;
use crate::commands::{Command, PanelId};
use crate::document::{Node, Target, Tier, Value};
use crate::fields::bands;
use crate::fields::edge::{self, EdgeField, has_profile};
use crate::fields::mark;
use crate::ids::{NodeId, PortName};
use crate::library::Library;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::keying::KeyedBy;
use crate::state::session::Session;
use crate::values;
use crate::widgets::number::number_field;
use crate::widgets::rows::together;
use crate::widgets::text::hint;
use crate::widgets::theme;
use sample::{Bend, Sampler, Shape};

pub(crate) const PANEL: PanelRow = PanelRow::new(
    PanelId::PROFILE,
    text!("Profile"),
    text!("How a layer's tone falls with the angle: drag offset, fall-off and cut-off"),
    PanelPlace::BELOW_PICTURE_WITH_CURVES,
    |bench, ui, context| bench.memory.of::<Profile>().show(ui, context.session),
);

/// Inputs that make up a profile, in order.
const ANGLES: [ProfileAngle; 3] = [
    ProfileAngle {
        port: "offset",
        label: text!("Offset"),
        help: text!("Offset: up to this angle the tone is full (τ in the BADF paper)"),
        keys: text!("Keys of offset"),
        handle: text!("Offset of the profile"),
        stop: text!("Stops at the offset. Shift moves all three."),
    },
    ProfileAngle {
        port: "falloff",
        label: text!("Fall-off"),
        help: text!("Fall-off: where the tone falls fastest (f in the BADF paper)"),
        keys: text!("Keys of fall-off"),
        handle: text!("Fall-off of the profile"),
        stop: text!("Stops at the fall-off. Shift moves all three."),
    },
    ProfileAngle {
        port: "cutoff",
        label: text!("Cut-off"),
        help: text!("Cut-off: where the tone reaches 0 (c in the BADF paper)"),
        keys: text!("Keys of cut-off"),
        handle: text!("Cut-off of the profile"),
        stop: text!("Stops at the cut-off. Shift moves all three."),
    },
];

struct ProfileAngle {
    port: &'static str,
    label: Text,
    /// Meaning of the angle, with the symbol of the BADF paper for its readers.
    help: Text,
    /// Name of the mark of its keys, for screen readers.
    keys: Text,
    /// Name of its handle in the plot, for screen readers.
    handle: Text,
    /// Sentence for when another handle was stopped by its own.
    stop: Text,
}

/// Largest number of sampled curves that are kept; beyond it all are dropped.
const MOST_CURVES: usize = 96;

/// Sampled curve: angles in radians, and the tones there.
#[derive(Debug)]
struct Curve {
    angles: Vec<f64>,
    tones: Vec<f64>,
}

/// The panel, and the curves that it has drawn.
#[derive(Default)]
pub(crate) struct Profile {
    /// Node that was shown last, kept while nodes without a profile are selected.
    shown: Option<NodeId>,
    sampler: Option<(Arc<Library>, Tier, Option<Sampler>)>,
    curves: HashMap<[u64; 4], Arc<Curve>>,
    strip: strip::Strip,
}

/// Node with a profile.
struct ProfileNode<'a> {
    session: &'a Session,
    id: &'a NodeId,
    node: &'a Node,
    kind: &'a NodeKind,
    /// Shape that an edit would change: where the shape is keyed, that of the current direction
    /// key or at the playhead.
    shape: Shape,
    /// For offset, fall-off and cut-off, true if a wire feeds it.
    wired: [bool; 3],
}

impl<'a> ProfileNode<'a> {
    fn new(session: &'a Session, id: &'a NodeId) -> Option<Self> {
        let node = session.graph().nodes.get(id)?;
        let kind: &NodeKind = session.project.catalog.of(node)?;
        if !has_profile(kind) {
            return None;
        }
        let of = |part: &ProfileAngle| {
            values::number(
                session.keys().value_at(&session.selection.target(id, &part.port.into())).as_ref(),
            )
        };
        let [offset, falloff, cutoff] = ANGLES.each_ref().map(of);
        let wired = ANGLES
            .each_ref()
            .map(|part| session.graph().wire_into(id, &part.port.into()).is_some());
        Some(Self { session, id, node, kind, shape: Shape { offset, falloff, cutoff }, wired })
    }

    fn target(&self, port: &str) -> Target {
        self.session.selection.target(self.id, &port.into())
    }

    /// Present value of a numeric input; `None` where the node has no such input.
    fn number(&self, port: &str) -> Option<f64> {
        self.kind.input(port)?;
        self.session.keys().value_now(&self.target(port)).map(|value| values::number(Some(&value)))
    }

    /// Largest distance that curvature moves the profile, in radians; 0 where curvature has no
    /// effect.
    fn warp(&self) -> f64 {
        let is_wired =
            |port: &str| self.session.graph().wire_into(self.id, &PortName::from(port)).is_some();
        let bends = is_wired("slope") || self.number("slope").is_some_and(|slope| slope != 0.0);
        if bends { self.number("amount").unwrap_or(0.0).clamp(-PI, PI) } else { 0.0 }
    }

    /// The profile as one edge.
    fn edge_field(&self) -> Option<EdgeField<'_>> {
        EdgeField::of_node(self.session, self.id, self.kind)
    }

    fn name(&self) -> &str {
        name_of(self.node, self.kind)
    }

    fn tier(&self) -> Tier {
        let path = self.session.selection.path_of(self.id);
        let known = self.session.compilation().tier_of(&path);
        let def = self.session.project.library.nodes.get(&self.node.kind);
        known.or(def.map(|def| def.tier_in(self.session.look(), self.node))).unwrap_or_default()
    }

    /// Shape at each key of the set that moves the shape, with the key's index.
    fn shapes_of_keys(&self) -> Vec<(usize, Shape)> {
        let session = self.session;
        let set =
            ANGLES.iter().find_map(|part| match session.keys().keyed_by(&self.target(part.port)) {
                KeyedBy::Direction(set) => Some(set),
                _ => None,
            });
        let Some(keys) = set.and_then(|set| session.look().direction_keys.get(set)) else {
            return Vec::new();
        };
        let shape_at = |key: &crate::document::DirectionKey| {
            let of = |part: &ProfileAngle| {
                let target = self.target(part.port);
                let own = || session.look_with_library().own_value(&target);
                values::number(key.values.get(&target).cloned().or_else(own).as_ref())
            };
            let [offset, falloff, cutoff] = ANGLES.each_ref().map(of);
            Shape { offset, falloff, cutoff }
        };
        keys.keys.iter().map(shape_at).enumerate().collect()
    }
}

fn name_of<'a>(node: &'a Node, kind: &'a NodeKind) -> &'a str {
    if node.name.is_empty() { tr_in("node", &kind.label) } else { &node.name }
}

/// Says where the bands of a layer are edited, which has them in place of a profile.
fn with_bands(ui: &mut Ui, title: &str, out: &mut Vec<Command>) {
    hint(
        ui,
        &tr!("{title} has flat bands in place of a profile. Drag their edges on the object or in \
             the layer's row, or set colors and softness in the inspector."),
    );
    if ui.button(tr!("Show its bands")).on_hover_text(tr!("Brings the inspector forward")).clicked()
    {
        out.push(Command::ShowPanel(PanelId::INSPECTOR));
    }
}

impl Profile {
    /// Shows the profile of the selected node, or of the last one that had a profile.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut commands = Vec::new();
        let has_one = |id: &&NodeId| ProfileNode::new(session, id).is_some();
        let selected = session.selection.nodes.iter().rev().find(has_one);
        let has_selected = selected.is_some();
        let id = selected.or_else(|| self.shown.as_ref().filter(has_one)).cloned();
        let id = id.or_else(|| session.graph().nodes.keys().find(has_one).cloned());
        let layer = id.as_ref().and_then(|id| ProfileNode::new(session, id));
        let other = session.selection.nodes.last().filter(|_| !has_selected);
        let other = other.and_then(|id| {
            let node = session.graph().nodes.get(id)?;
            let kind: &NodeKind = session.project.catalog.of(node)?;
            Some((name_of(node, kind), kind.input(bands::PORT).is_some()))
        });
        if let Some((title, true)) = other {
            with_bands(ui, title, &mut commands);
            return commands;
        }
        let Some(layer) = layer else {
            hint(
                ui,
                tr!(
                    "Nothing here has a profile yet. Add a Light layer: its tone over the angle is \
                     drawn here."
                ),
            );
            return commands;
        };
        if let Some((selected, _)) = other {
            let text =
                tr!("{selected} has no profile; this is that of {shown}.", shown = layer.name());
            ui.add(Label::new(RichText::new(text).small().color(theme::of(ui).dim)).wrap());
        }
        ScrollArea::vertical()
            .auto_shrink([false, false])
            .show(ui, |ui| self.layer(ui, &layer, &mut commands));
        self.shown = id;
        commands
    }

    fn layer(&mut self, ui: &mut Ui, layer: &ProfileNode<'_>, out: &mut Vec<Command>) {
        let can_edit = !layer.session.graph_view().is_read_only();
        ui.add_enabled_ui(can_edit, |ui| {
            head(ui, layer, out);
            numbers(ui, layer, out);
        });
        let notes = notes(layer, &self.curve(layer, layer.shape, 0.0));
        let note_height = 18.0 * notes.len() as f32;
        let strip = strip::HEIGHT + ui.spacing().item_spacing.y;
        let height = (ui.available_height() - strip - note_height - 8.0).max(110.0);
        let curves = plot::Curves {
            own: self.curve(layer, layer.shape, 0.0),
            warped: [1.0, -1.0]
                .map(|way| layer.warp() * way)
                .map(|shift| self.curve(layer, layer.shape, shift)),
            keys: layer
                .shapes_of_keys()
                .into_iter()
                .map(|(key, shape)| (key, self.curve(layer, shape, 0.0)))
                .collect(),
        };
        let area =
            plot::show(ui, layer, &curves, vec2(ui.available_width(), height), can_edit, out);
        let rows = strip::ROWS.map(|convexity| {
            let shift = (2.0 * convexity - 1.0) * layer.warp();
            self.curve(layer, layer.shape, shift)
        });
        self.strip.show(ui, layer, area, &rows);
        for note in notes {
            ui.label(RichText::new(note).small().color(theme::of(ui).dim));
        }
    }

    /// Curve of a shape; sampled once and then kept.
    fn curve(&mut self, layer: &ProfileNode<'_>, shape: Shape, shift: f64) -> Arc<Curve> {
        const COUNT: usize = 240;
        let tier = layer.tier();
        let library: &Arc<Library> = &layer.session.project.library;
        if !self
            .sampler
            .as_ref()
            .is_some_and(|(known, of, _)| Arc::ptr_eq(known, library) && *of == tier)
        {
            self.sampler = Some((library.clone(), tier, Sampler::new(library, tier)));
            self.curves.clear();
        }
        let key = [shape.offset, shape.falloff, shape.cutoff, shift].map(f64::to_bits);
        if let Some(known) = self.curves.get(&key) {
            return known.clone();
        }
        let angles = sample::places(shape, shift, COUNT);
        let sampler = self.sampler.as_ref().and_then(|(_, _, sampler)| sampler.as_ref());
        let tones = sampler.map(|sampler| sampler.tones(shape, shift, &angles)).unwrap_or_default();
        if self.curves.len() >= MOST_CURVES {
            self.curves.clear();
        }
        let curve = Arc::new(Curve { angles, tones });
        self.curves.insert(key, curve.clone());
        curve
    }
}

/// Shows the choice of the layer, and the presets of the Profile node.
fn head(ui: &mut Ui, layer: &ProfileNode<'_>, out: &mut Vec<Command>) {
    let session = layer.session;
    ui.horizontal_wrapped(|ui| {
        let name = |ui: &mut Ui| {
            for (id, node) in &session.graph().nodes {
                let kind = session.project.catalog.of(node).filter(|kind| has_profile(kind));
                let Some(kind) = kind else { continue };
                if ui.selectable_label(id == layer.id, name_of(node, kind)).clicked() {
                    out.push(Command::Select(vec![id.clone()]));
                }
            }
        };
        let combo = ComboBox::from_id_salt("profile")
            .selected_text(layer.name())
            .width(84.0)
            .show_ui(ui, name);
        combo
            .response
            .on_hover_text(tr!("The layer whose profile this is; selecting a layer shows its own"))
            .widget_info(|| {
                egui::WidgetInfo::labeled(
                    egui::Role::ComboBox,
                    true,
                    tr!("Profile of {name}", name = layer.name()),
                )
            });
        let presets = session
            .project
            .catalog
            .get("profile")
            .map(|kind| kind.presets.as_slice())
            .unwrap_or_default();
        for preset in presets {
            let is_it = preset.values.iter().all(|(port, value)| {
                let now = ANGLES.iter().zip([
                    layer.shape.offset,
                    layer.shape.falloff,
                    layer.shape.cutoff,
                ]);
                now.into_iter().any(|(part, now)| {
                    part.port == port.as_str() && (now - values::number(Some(value))).abs() < 1e-6
                })
            });
            let label = tr_in("node", &preset.label);
            let button = Button::new(label).small().selected(is_it);
            let response = ui
                .add(button)
                .on_hover_text(tr!("Sets offset, fall-off and cut-off to this shading's"));
            response.widget_info(|| {
                let name = tr!("Profile preset {label}");
                egui::WidgetInfo::selected(egui::Role::Button, true, is_it, name)
            });
            if response.clicked() {
                let values = preset
                    .values
                    .iter()
                    .map(|(port, value)| (layer.target(port.as_str()), value.clone()));
                out.push(Command::Edit(session.keys().set_all_at(values)));
            }
        }
    });
}

/// Shows the edge, or offset, fall-off and cut-off in degrees, typed or dragged.
fn numbers(ui: &mut Ui, layer: &ProfileNode<'_>, out: &mut Vec<Command>) {
    let Shape { offset, falloff, cutoff } = layer.shape;
    ui.horizontal_wrapped(|ui| {
        if let Some(field) = layer.edge_field() {
            field.in_line(
                ui,
                [tr!("Edge of the profile's tone"), tr!("Softness of the profile")],
                out,
            );
            let path = layer.session.selection.path_of(layer.id);
            if !edge::angles_toggle(ui, &path, field.edge().is_some()).is_open {
                return;
            }
        }
        for (index, (part, radians)) in ANGLES.iter().zip([offset, falloff, cutoff]).enumerate() {
            let color = plot::color_of(ui, index);
            together(ui, part.port, |ui| {
                let help = part.help.tr();
                let label =
                    ui.label(RichText::new(part.label.tr()).color(color)).on_hover_text(help).id;
                if layer.wired[index] {
                    ui.label(RichText::new(tr!("by wire")).color(theme::of(ui).dim));
                    return;
                }
                let mut degrees = radians.to_degrees();
                let drag = number_field(ui, &mut degrees)
                    .range(0.0..=180.0)
                    .clamp_existing_to_range(false)
                    .speed(0.5)
                    .max_decimals(1)
                    .suffix("°");
                let response = ui.add(drag).labelled_by(label).on_hover_text(help);
                if response.changed() && degrees.is_finite() {
                    let edit = layer
                        .session
                        .keys()
                        .set_at(&layer.target(part.port), Value::Number(degrees.to_radians()));
                    out.push(Command::EditHeld(response.id, edit));
                }
                mark(ui, layer, part);
            });
        }
    });
}

/// Shows the mark of the key that a number belongs to, where keys move the number.
fn mark(ui: &mut Ui, layer: &ProfileNode<'_>, part: &ProfileAngle) {
    let target = layer.target(part.port);
    if layer.session.keys().keyed_by(&target) != KeyedBy::Nothing {
        mark::of(ui, layer.session.keys(), &target, part.keys.tr())
            .on_hover_text(mark::help(layer.session.keys(), &target));
    }
}

/// Notes on oddities of the curve.
fn notes(layer: &ProfileNode<'_>, curve: &Curve) -> Vec<String> {
    let shape = layer.shape;
    let sane = shape.sanitized();
    let degrees = |radians: f64| format!("{}°", values::number_text(radians.to_degrees(), 1));
    let mut notes = Vec::new();
    let pairs = [shape.offset, shape.falloff, shape.cutoff].into_iter().zip([
        sane.offset,
        sane.falloff,
        sane.cutoff,
    ]);
    for (part, (own, counts)) in ANGLES.iter().zip(pairs) {
        if (own - counts).abs() > 1e-9 && sane.offset < PI - 1e-5 {
            notes.push(tr!(
                "{part} {own} counts as {counts}: offset, fall-off and cut-off come in this order.",
                part = part.label,
                own = degrees(own),
                counts = degrees(counts)
            ));
        }
    }
    let steepest =
        || sample::steepest(&curve.angles, &curve.tones).map(degrees).unwrap_or_default();
    match Bend::of(shape) {
        Bend::Twice(second) => notes.push(tr!(
            "A fall-off more than 90° past the offset is not the only bend: the curve bends at \
             {first} and at {second}, and is steepest at {steepest}.",
            first = degrees(sane.falloff),
            second = degrees(second),
            steepest = steepest()
        )),
        Bend::Elsewhere(only) => notes.push(tr!(
            "With fall-off and cut-off together the curve bends at {only}, and is steepest there.",
            only = degrees(only)
        )),
        Bend::Never => notes.push(tr!(
            "This fall-off is no bend: the curve falls ever faster, and is steepest at {steepest}.",
            steepest = steepest()
        )),
        _ => {}
    }
    notes
}
