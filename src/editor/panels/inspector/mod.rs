//! Inspector: all values of the selected node that can be set, with names, units and help.

mod interface;
mod roughness;

use chiaro_locale::{Text, text, tr, tr_in, trn};
use eframe::egui;
use eframe::egui::{RichText, ScrollArea, TextEdit, Ui};

use crate::catalog::{NodeKind, Port};
use crate::commands::{Command, PanelId};
use crate::document::{ColorSpace, Edit, LightSet, Look, NodeLinks, Target, Tier, Value};
use crate::fields::edge::{self, EdgeField, PROFILE};
use crate::fields::lighting::{OwnedLight, Owner};
use crate::fields::node_links::{is_filter, is_lit};
use crate::fields::{InspectedNode, marks, row};
use crate::ids::LightId;
use crate::library::Type;
use crate::panels::lights;
use crate::panels::table::{PanelPlace, PanelRow, PanelStack};
use crate::state::reading::{tier_label, tier_word};
use crate::state::session::Session;
use crate::state::wire::{ShownWire, Style};
use crate::values;
use crate::widgets::number::number_field;
use crate::widgets::spots::{self, Spot};
use crate::widgets::text::is_typed;
use crate::widgets::text::{formed, in_lines};
use crate::widgets::theme;

/// Number of steps of a screen between the least and the greatest number of a color.
const STEPS: f64 = 255.0;
/// Width of a list where there is room, and least width of a field with its unit, in points.
const LIST: f32 = 100.0;
/// Most lines of a node's help that stand above its values.
const HELP: usize = 3;
const UNIT: f32 = 90.0;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::INSPECTOR,
    text!("Inspector"),
    text!("The values of what is selected"),
    PanelPlace { stack: Some(PanelStack::Inspector), ..PanelPlace::CLOSED },
    |_, ui, context| show(ui, context.session),
);

/// Shows the node that was selected last, or the look itself.
pub(crate) fn show(ui: &mut Ui, session: &Session) -> Vec<Command> {
    let mut commands = Vec::new();
    let selected =
        session.selection.nodes.last().and_then(|id| Some((id, session.graph().nodes.get(id)?)));
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        // The margin is room for the scroll bar.
        ui.set_max_width((ui.available_width() - 8.0).max(0.0));
        if session.graph_view().is_read_only() {
            let text = tr!("This group is of the library. Make it the look's own to change it.");
            ui.label(RichText::new(text).color(theme::of(ui).dim));
            if ui.button(tr!("Make it the look's own")).clicked() {
                commands.extend(session.graph_view().own_group().map(Command::Edit));
            }
            ui.add_space(4.0);
            ui.disable();
        }
        match selected {
            Some((id, node)) => match session.project.catalog.of(node) {
                Some(kind) => {
                    show_node(ui, &InspectedNode { session, id, node, kind }, &mut commands);
                }
                None => {
                    ui.heading(id.as_str());
                    ui.label(tr!("There is no node of kind \"{kind}\".", kind = node.kind));
                }
            },
            None if session.graph_view().definition().is_some() => {
                interface::show(ui, session, &mut commands);
            }
            None => show_look(ui, session, &mut commands),
        }
    });
    commands
}

fn show_node(ui: &mut Ui, subject: &InspectedNode<'_>, out: &mut Vec<Command>) {
    let InspectedNode { session, id, node, kind } = subject;
    ui.horizontal(|ui| {
        let label = ui.label(RichText::new(tr_in("node", &kind.label)).heading());
        let count = session.selection.nodes.len();
        if count > 1 {
            let help = tr!("What is set here is set in every selected node that has it");
            let text = RichText::new(tr!("and {more} more", more = count - 1));
            let text = text.color(theme::of(ui).dim);
            ui.label(text).on_hover_text(help);
        }
        label.on_hover_text(tr!("kind {kind}, id {id}", kind = node.kind));
    });
    if !kind.help.is_empty() {
        let help = tr_in("node", &kind.help);
        let first = help.split("\n\n").next().unwrap_or_default();
        in_lines(ui, RichText::new(first).color(theme::of(ui).dim), HELP).on_hover_text(help);
    }
    if !kind.sources.is_empty() {
        ui.label(RichText::new(kind.sources.join(" · ")).small().color(theme::of(ui).dim));
    }
    ui.add_space(4.0);
    name_row(ui, subject, out);
    presets(ui, subject, out);
    roughness::row(ui, subject, out);
    ui.separator();
    let wanted = search(ui, kind);
    let field = EdgeField::of_node(session, id, kind);
    let field = field.filter(|_| wanted.is_empty() || has_words(EDGE, &wanted));
    // Three angles lie behind the edge that they make, unless a search is for them.
    let is_behind =
        |port: &Port| wanted.is_empty() && field.is_some() && PROFILE.contains(&port.name.as_str());
    let is_first = |port: &Port| port.name.as_str() == PROFILE[0];
    if let Some(field) = field.as_ref().filter(|_| !wanted.is_empty()) {
        field.rows(ui, out);
    }
    for port in kind.inputs.iter().filter(|port| fits(port, &wanted)) {
        let top = ui.cursor().top();
        match &field {
            Some(_) if is_behind(port) && !is_first(port) => continue,
            Some(field) if is_behind(port) => edge_rows(ui, subject, field, out),
            _ => row::show(ui, subject, port, out),
        }
        let rect = egui::Rect::from_x_y_ranges(
            ui.max_rect().x_range(),
            top..=ui.cursor().top() - ui.spacing().item_spacing.y,
        );
        let ports = if is_behind(port) { &PROFILE[..] } else { &[port.name.as_str()] };
        ports.iter().for_each(|port| spots::note(ui, Spot::Input((*port).into()), rect));
    }
    let hidden = kind.inputs.iter().filter(|port| !fits(port, &wanted)).count();
    if hidden > 0 {
        ui.horizontal(|ui| {
            let text = RichText::new(tr!("{hidden} more hidden")).color(theme::of(ui).dim);
            ui.label(text).on_hover_text(tr!("The search above hides them"));
            if ui
                .small_button(tr!("Show all values"))
                .on_hover_text(tr!("Ends the search"))
                .clicked()
            {
                ui.data_mut(|data| data.remove::<String>(search_id(kind)));
            }
        });
    }
    for_each_row(ui, subject, out);
    tier_row(ui, subject, out);
    shown_row(ui, subject, out);
    let path = session.selection.path_of(id);
    marks::list(
        ui,
        session,
        |target| matches!(target, Target::Input { node, .. } if *node == path),
        out,
    );
    lights_of(ui, subject, out);
    // Below the light itself: few looks need them.
    link_rows(ui, subject, out);
}

/// Shows the edge of a profile, and the three angles behind it.
fn edge_rows(
    ui: &mut Ui,
    subject: &InspectedNode<'_>,
    field: &EdgeField<'_>,
    out: &mut Vec<Command>,
) {
    field.rows(ui, out);
    let path = subject.session.selection.path_of(subject.id);
    let is_edge = field.edge().is_some();
    let slot = |_: &mut Ui, _| {};
    let mut is_open = true;
    if is_edge {
        row::with_slot(ui, RichText::new(""), "", slot, |ui, _| {
            is_open = edge::angles_toggle(ui, &path, is_edge).is_open;
        });
    } else {
        edge::angles_toggle(ui, &path, is_edge);
    }
    let ports = PROFILE.iter().filter_map(|port| subject.kind.input(port));
    for port in ports.filter(|_| is_open) {
        row::show(ui, subject, &subject.kind.inputs[port], out);
    }
}

/// Number of inputs from which on there is a search field.
const LONG: usize = 10;

/// Shows the search field of a node with many inputs; returns the query in lower case.
fn search(ui: &mut Ui, kind: &NodeKind) -> String {
    if kind.inputs.len() < LONG {
        return String::new();
    }
    let id = search_id(kind);
    let mut text = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_default();
    let response = ui.add(
        TextEdit::singleline(&mut text)
            .id(id)
            .hint_text(tr!("Find a value"))
            .desired_width(f32::INFINITY),
    );
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::TextInput, true, tr!("Find a value"))
    });
    if response.changed() {
        ui.data_mut(|data| data.insert_temp(id, text.clone()));
    }
    text.trim().to_lowercase()
}

fn search_id(kind: &NodeKind) -> egui::Id {
    egui::Id::unique(("inspector search", &kind.id))
}

/// Words by which a search finds the edge of a profile.
const EDGE: Text = text!("edge softness");

/// True if a text has the words that are sought, which are in lower case.
fn has_words(text: Text, wanted: &str) -> bool {
    [text.english(), text.tr()].iter().any(|text| text.to_lowercase().contains(wanted))
}

fn fits(port: &crate::catalog::Port, wanted: &str) -> bool {
    let has_it = |text: &str| text.to_lowercase().contains(wanted);
    let words = [port.name.as_str(), &port.label, &port.help];
    wanted.is_empty() || words.iter().any(|text| has_it(text) || has_it(tr_in("node", text)))
}

fn name_row(
    ui: &mut Ui,
    InspectedNode { session, id, node, kind }: &InspectedNode<'_>,
    out: &mut Vec<Command>,
) {
    row::labelled(
        ui,
        tr!("Name"),
        tr!("What you call it; the generated code uses it"),
        |ui, label| {
            let mut name = node.name.clone();
            let edit = TextEdit::singleline(&mut name)
                .hint_text(tr_in("node", &kind.label))
                .desired_width(f32::INFINITY)
                .char_limit(80);
            let response = ui.add(edit).labelled_by(label);
            if is_typed(ui, &response, &mut name) {
                let edit = Edit::SetName {
                    graph: session.selection.graph_id().clone(),
                    id: (*id).clone(),
                    name,
                };
                out.push(Command::EditHeld(response.id, edit));
            }
        },
    );
}

fn presets(
    ui: &mut Ui,
    InspectedNode { session, id, kind, .. }: &InspectedNode<'_>,
    out: &mut Vec<Command>,
) {
    if kind.presets.is_empty() {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        for preset in &kind.presets {
            if ui
                .button(tr_in("node", &preset.label))
                .on_hover_text(tr!("Sets the values of this preset"))
                .clicked()
            {
                let values = preset
                    .values
                    .iter()
                    .map(|(port, value)| (session.selection.target(id, port), value.clone()));
                out.push(Command::Edit(session.keys().set_all_at(values)));
            }
        }
    });
}

/// Shows the lights that a group runs for, once for each.
fn for_each_row(
    ui: &mut Ui,
    InspectedNode { session, id, node, .. }: &InspectedNode<'_>,
    out: &mut Vec<Command>,
) {
    let is_group = session.look().definitions.contains_key(node.kind.as_str());
    if !is_group && node.for_each.is_none() {
        return;
    }
    let help = tr!(
        "Runs the group once for each light of a set: a light that nothing in it names is that \
         one, and nodes such as Sum of lights join what comes of them. * is every light; key | \
         group:rim - group:set says more"
    );
    row::labelled(ui, tr!("For each light"), help, |ui, label| {
        let read = |text: &str| match text.trim() {
            "" => Ok(None),
            text => LightSet::parse(text).map(Some).map_err(|why| why.to_string()),
        };
        let text_of = |set: &Option<LightSet>| set.as_ref().map_or("", LightSet::text).to_owned();
        if let Some((widget, for_each)) = formed(ui, label, &node.for_each, text_of, read) {
            let graph = session.selection.graph_id().clone();
            let edit = Edit::SetForEach { graph, id: (*id).clone(), for_each };
            out.push(Command::EditHeld(widget, edit));
        }
    });
}

/// Row for a set of the lights of a node.
struct LinkRow {
    label: Text,
    help: Text,
    set: fn(&mut NodeLinks) -> &mut LightSet,
}

const REACH: [LinkRow; 2] = [
    LinkRow {
        label: text!("Reached by"),
        help: text!(
            "Lights that reach it, and what is in it; {source} are those that reach the group \
             around it. * is every light; key | group:rim - group:set says more"
        ),
        set: |links| &mut links.layered,
    },
    LinkRow {
        label: text!("Not reached by"),
        help: text!("Lights that do not reach it all the same; {source} is Reached by"),
        set: |links| &mut links.unlayered,
    },
];

const FILTER: [LinkRow; 2] = [
    LinkRow {
        label: text!("Filters lights"),
        help: text!(
            "Lights that it filters; others pass as if it were not there. * is every light; key | \
             group:rim - group:set says more"
        ),
        set: |links| &mut links.filtered,
    },
    LinkRow {
        label: text!("Lets pass by"),
        help: text!("Lights that it does not filter all the same; {source} is Filters lights"),
        set: |links| &mut links.unfiltered,
    },
];

/// Rows for the lights that reach a node which names one or runs for several, and for those that a
/// node filters.
fn link_rows(
    ui: &mut Ui,
    InspectedNode { session, id, node, kind }: &InspectedNode<'_>,
    out: &mut Vec<Command>,
) {
    let links = &node.links;
    let (is_lit, is_filter) = (is_lit(kind, node), is_filter(kind, node));
    let rows = is_lit.then_some(REACH).into_iter().chain(is_filter.then_some(FILTER)).flatten();
    let mut now = links.clone();
    for LinkRow { label, help, set } in rows {
        let shown = set(&mut now).clone();
        row::labelled(ui, label.tr(), help.tr(), |ui, label| {
            let read = |text: &str| LightSet::parse(text).map_err(|why| why.to_string());
            let found = formed(ui, label, &shown, |set| set.text().to_owned(), read);
            if let Some((widget, changed)) = found {
                let mut links = links.clone();
                *set(&mut links) = changed;
                let graph = session.selection.graph_id().clone();
                let edit = Edit::SetNodeLinks { graph, id: (*id).clone(), links };
                out.push(Command::EditHeld(widget, edit));
            }
        });
    }
}

fn tier_row(
    ui: &mut Ui,
    InspectedNode { session, id, node, kind, .. }: &InspectedNode<'_>,
    out: &mut Vec<Command>,
) {
    let def = session.project.library.nodes.get(&kind.id);
    let tiers = match kind.tiers.as_slice() {
        // Forms of the functions that it calls make a tier, too.
        [_] if def.is_some_and(|def| def.has_cheaper()) => vec![Tier::Exact, Tier::Balanced],
        tiers => tiers.to_vec(),
    };
    if tiers.len() < 2 {
        return;
    }
    row::labelled(
        ui,
        tr!("Tier"),
        tr!("Which implementation: exact, or faster with a measured error"),
        |ui, label| {
            let runs = session.compilation().tier_of(&session.selection.path_of(id));
            let name = |tier: Option<Tier>| match (tier, runs) {
                (Some(tier), _) => tier_label(tier).to_owned(),
                (None, Some(tier)) if node.tier.is_none() => {
                    tr!("As the look ({tier})", tier = tier_word(tier))
                }
                (None, _) => tr!("As the look").to_owned(),
            };
            let combo = egui::ComboBox::from_id_salt("tier")
                .width(ui.available_width().min(LIST))
                .truncate()
                .selected_text(name(node.tier))
                .show_ui(ui, |ui| {
                    for tier in std::iter::once(None).chain(tiers.iter().copied().map(Some)) {
                        let response = ui
                            .selectable_label(node.tier == tier, name(tier))
                            .on_hover_text(error_of(session, kind, tier));
                        if response.clicked() {
                            let alike = session.selection.nodes.iter().filter(|id| {
                                let other = session
                                    .graph()
                                    .nodes
                                    .get(*id)
                                    .and_then(|node| session.project.catalog.of(node));
                                other.is_some_and(|other| other.tiers == kind.tiers)
                            });
                            let graph = session.selection.graph_id();
                            let edits = alike.map(|id| Edit::SetTier {
                                graph: graph.clone(),
                                id: id.clone(),
                                tier,
                            });
                            out.push(Command::Edit(Edit::Group { edits: edits.collect() }));
                        }
                    }
                });
            combo.response.labelled_by(label);
        },
    );
}

/// Error of a tier against the exact one, as the node's file states it.
fn error_of(session: &Session, kind: &NodeKind, tier: Option<Tier>) -> String {
    let def = session.project.library.nodes.get(&kind.id);
    match tier {
        None => match session.look().tier {
            Some(tier) => tr!("As the look is: {tier}", tier = tier_word(tier)),
            None => tr!("The cheapest whose difference nobody can see").to_owned(),
        },
        Some(Tier::Exact) => tr!("The truth, as near as f32 comes").to_owned(),
        Some(tier) => match def.and_then(|def| def.error_of(tier)) {
            Some(error) => {
                let help = tr_in("node", &error.help);
                tr!("At most {bound:e} off: {help}", bound = error.bound)
            }
            None => {
                tr!("Faster, with the error that the Cost and accuracy panel measures").to_owned()
            }
        },
    }
}

/// Shows the choice of the output that is viewed in place of the picture, and of its display.
fn shown_row(
    ui: &mut Ui,
    InspectedNode { session, id, kind, .. }: &InspectedNode<'_>,
    out: &mut Vec<Command>,
) {
    if kind.outputs.is_empty() {
        return;
    }
    let shown =
        session.view.wire.as_ref().filter(|wire| wire.node == session.selection.path_of(id));
    row::labelled(
        ui,
        tr!("View wire"),
        tr!("Shows an output of this node in place of the picture"),
        |ui, label| {
            let name = |port: &crate::catalog::Port| tr_in("node", &port.label).to_owned();
            let port =
                shown.and_then(|wire| kind.outputs.iter().find(|port| port.name == wire.port));
            let text = port.map_or(tr!("Not shown").to_owned(), name);
            let combo = egui::ComboBox::from_id_salt("wire")
                .selected_text(text)
                .width(90.0)
                .show_ui(ui, |ui| {
                    if ui.selectable_label(shown.is_none(), tr!("Not shown")).clicked() {
                        out.push(Command::ShowWire(None));
                    }
                    for port in &kind.outputs {
                        let is_it = shown.is_some_and(|wire| wire.port == port.name);
                        if ui.selectable_label(is_it, name(port)).clicked() {
                            let style = shown.map(|wire| wire.style).unwrap_or_default();
                            out.push(Command::ShowWire(Some(ShownWire {
                                node: session.selection.path_of(id),
                                port: port.name.clone(),
                                style,
                            })));
                        }
                    }
                });
            combo.response.labelled_by(label);
        },
    );
    let Some(wire) = shown else { return };
    row::labelled(ui, tr!("Seen as"), tr!("How its numbers are seen"), |ui, _| {
        for style in Style::ALL {
            if ui
                .selectable_label(wire.style == style, style.label())
                .on_hover_text(style.help())
                .clicked()
            {
                out.push(Command::ShowWire(Some(ShownWire { style, ..wire.clone() })));
            }
        }
    });
}

/// Shows the lights that a node names.
fn lights_of(ui: &mut Ui, subject: &InspectedNode<'_>, out: &mut Vec<Command>) {
    for port in subject.kind.inputs.iter().filter(|port| port.ty == Type::LightName) {
        let Some(Value::Text(id)) = values::current(port, subject.node.values.get(&port.name))
        else {
            continue;
        };
        let id = LightId::from(id.as_str());
        let owned_light = OwnedLight::lighting(subject.session, &id)
            .filter(|_| subject.session.look().lights.contains_key(&id));
        if let Some(owned_light) = owned_light {
            ui.separator();
            let light = owned_light.name();
            let title = match owned_light.owner {
                Owner::Look => tr!("The light \"{light}\""),
                Owner::Scene => tr!("The light \"{light}\" of the scene"),
            };
            ui.label(RichText::new(title).strong());
            lights::edit(ui, subject.session, &owned_light, out);
        }
    }
}

/// Meaning of a tier that a look asks for.
fn tier_help(tier: Option<Tier>) -> &'static str {
    match tier {
        None => tr!("For each node the cheapest whose difference nobody can see"),
        Some(Tier::Exact) => tr!("The truth, as near as 32-bit numbers come"),
        Some(Tier::Balanced) => tr!("Errors below what is seen, where that is faster"),
        Some(Tier::Fast) => tr!("The least time; edges and curvature may be seen to differ"),
    }
}

/// Row of the difference that automatic tiers may make, shown in steps of a screen.
fn difference_row(ui: &mut Ui, look: &Look, out: &mut Vec<Command>) {
    let help =
        tr!("Greatest difference from the exact tier that an automatic one may make, in the 255 \
             steps of a screen; 1 is seen by nobody. More allows cheaper tiers, and 0 none. It is \
             estimated; Cost and accuracy measures it");
    row::labelled(ui, tr!("Difference"), help, |ui, label| {
        // A whole number of steps is shown as one, in spite of rounding.
        let mut steps = (look.max_error * STEPS * 1e6).round() / 1e6;
        let unit = match (steps - 1.0).abs() < 0.005 {
            _ if ui.available_width() < UNIT => "",
            true => tr!(" step"),
            false => tr!(" steps"),
        };
        let field = number_field(ui, &mut steps)
            .range(0.0..=STEPS)
            .speed(0.05)
            .max_decimals(2)
            .suffix(unit);
        let response = ui.add(field).labelled_by(label).on_hover_text(help);
        if response.changed() {
            let max_error = (steps / STEPS).clamp(0.0, 1.0);
            out.push(Command::EditHeld(response.id, Edit::SetMaxError { max_error }));
        }
    });
}

/// Shows a link to the lights, which have a panel of their own.
fn lights_row(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    row::labelled(ui, tr!("Lights"), tr!("What shines on the look"), |ui, _| {
        let count = session.look().lights.len();
        let text = trn!(count, "{count} light", "{count} lights");
        if ui.link(text).on_hover_text(tr!("Opens the list of lights")).clicked() {
            out.push(Command::ShowPanel(PanelId::LIGHTS));
        }
    });
}

/// Shows the look itself, where nothing is selected.
fn show_look(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    let look = session.look();
    ui.heading(tr!("Look"));
    ui.label(RichText::new(tr!("Select a node to set its values.")).color(theme::of(ui).dim));
    ui.add_space(4.0);
    row::labelled(ui, tr!("Name"), tr!("What you call this look"), |ui, label| {
        let mut name = look.name.clone();
        let response =
            ui.add(TextEdit::singleline(&mut name).desired_width(f32::INFINITY)).labelled_by(label);
        if is_typed(ui, &response, &mut name) {
            out.push(Command::EditHeld(response.id, Edit::SetLookName { name }));
        }
    });
    row::labelled(
        ui,
        tr!("About"),
        tr!("What it shows and how it is built, for who finds it"),
        |ui, label| {
            let mut about = look.about.clone();
            let field =
                TextEdit::multiline(&mut about).desired_width(f32::INFINITY).desired_rows(2);
            let response =
                ui.add(field.hint_text(tr!("What it shows, how it is built"))).labelled_by(label);
            if response.changed() {
                out.push(Command::EditHeld(response.id, Edit::SetLookAbout { about }));
            }
        },
    );
    row::labelled(
        ui,
        tr!("Tags"),
        tr!("Words to find it by in the library, apart by spaces"),
        |ui, label| {
            let mut tags = look.tags.clone();
            let field =
                TextEdit::singleline(&mut tags).desired_width(f32::INFINITY).char_limit(200);
            let response = ui.add(field).labelled_by(label);
            if is_typed(ui, &response, &mut tags) {
                out.push(Command::EditHeld(response.id, Edit::SetLookTags { tags }));
            }
        },
    );
    row::labelled(ui, tr!("Colors"), tr!("What the numbers of a color mean"), |ui, label| {
        let name = |space| match space {
            ColorSpace::Display => tr!("As shown"),
            ColorSpace::Linear => tr!("Linear light"),
        };
        let combo = egui::ComboBox::from_id_salt("space")
            .selected_text(name(look.color_space))
            .show_ui(ui, |ui| {
                for color_space in [ColorSpace::Display, ColorSpace::Linear] {
                    if ui
                        .selectable_label(look.color_space == color_space, name(color_space))
                        .clicked()
                    {
                        out.push(Command::Edit(Edit::SetColorSpace { color_space }));
                    }
                }
            });
        combo.response.labelled_by(label);
    });
    row::labelled(
        ui,
        tr!("Tier"),
        tr!("Which implementation nodes have that do not say their own"),
        |ui, label| {
            let name = |tier: Option<Tier>| tier.map_or(tr!("Automatic"), tier_label);
            let combo = egui::ComboBox::from_id_salt("tier")
                .width(ui.available_width().min(LIST))
                .truncate()
                .selected_text(name(look.tier))
                .show_ui(ui, |ui| {
                    let tiers = [None, Some(Tier::Exact), Some(Tier::Balanced), Some(Tier::Fast)];
                    for tier in tiers {
                        let choice = ui.selectable_label(look.tier == tier, name(tier));
                        if choice.on_hover_text(tier_help(tier)).clicked() {
                            out.push(Command::Edit(Edit::SetLookTier { tier }));
                        }
                    }
                });
            combo.response.labelled_by(label);
        },
    );
    if look.tier.is_none() {
        difference_row(ui, look, out);
    }
    marks::list(ui, session, |_| true, out);
    lights_row(ui, session, out);
}
