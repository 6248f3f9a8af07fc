//! Row of one input: its label, and the editor of its value.

use chiaro_locale::{Text, text, tr};
use eframe::egui;
use eframe::egui::{Checkbox, ComboBox, Id, RichText, TextEdit, Ui, vec2};

use super::InspectedNode;
use super::bands;
use super::keyed;
use super::marks::{self, FieldTarget};
use super::path;
use crate::catalog::Port;
use crate::commands::{Command, PaintCommand, PanelId};
use crate::document::{ColorSpace, Edit, Endpoint, Grid, LightSet, Node, Value, Wire};
use crate::examples::PREFIX;
use crate::fields::lighting::OwnedKeys;
use crate::frame::UNSAVED_HCBTF;
use crate::ids::NodeId;
use crate::library::{CUSTOM_CODE, Fallback, Type};
use crate::state::keying::KeyedBy;
use crate::state::reading::{of_choice, of_library};
use crate::values;
use crate::widgets::menu::scrolling;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::text::formed;
use crate::widgets::theme;
use crate::widgets::{color, curve, ramp};

const MIXED: Text = text!("The selected nodes have different values; setting it sets all of them.");

/// Width of the labels, in points, and the part of a narrow row that they take at most.
const LABEL: f32 = 92.0;
const LABEL_PART: f32 = 0.38;

/// Room that the number beside a slider takes, in points, and the least room of both: where there
/// is less, the number alone is dragged.
const NUMBER: f32 = 66.0;
const SLIDER: f32 = NUMBER + 40.0;

/// Width of the label of a row that begins here, in points.
fn label_width(ui: &Ui) -> f32 {
    (ui.available_width() * LABEL_PART).clamp(40.0, LABEL)
}

/// Shows a label with help, and a widget that is named by it.
pub(crate) fn labelled(ui: &mut Ui, label: &str, help: &str, add: impl FnOnce(&mut Ui, Id)) {
    let text = RichText::new(label).color(theme::of(ui).text);
    marked(ui, text, help, None, &mut Vec::new(), |ui, id, _| add(ui, id));
}

/// Shows a label with help, and several widgets, which take another line where a narrow row has no
/// room for all.
pub(crate) fn several(ui: &mut Ui, label: &str, help: &str, add: impl FnOnce(&mut Ui, Id)) {
    labelled(ui, label, help, |ui, id| {
        ui.horizontal_wrapped(|ui| add(ui, id));
    });
}

/// Shows a label with help, a widget that is named by it, and the mark of its target.
pub(crate) fn marked(
    ui: &mut Ui,
    label: RichText,
    help: &str,
    marked: Option<&FieldTarget<'_>>,
    out: &mut Vec<Command>,
    add: impl FnOnce(&mut Ui, Id, &mut Vec<Command>),
) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        marks::diamond(ui, marked, out);
        let response = name(
            ui,
            label,
            help,
            if marked.is_some() { egui::Sense::click() } else { egui::Sense::hover() },
        );
        add(ui, response.id, out);
        if let Some(marked) = marked {
            menu_of_row(ui, &response, marked, out);
        }
    });
    if let Some(marked) = marked {
        keyed::show(ui, marked, out);
    }
}

/// Opens the menu of a value by a right click anywhere on its row: the label, the number, the
/// slider and the swatch take other clicks.
fn menu_of_row(ui: &Ui, label: &egui::Response, marked: &FieldTarget<'_>, out: &mut Vec<Command>) {
    let is_asked = ui.input(|input| input.pointer.secondary_clicked())
        && ui.rect_contains_pointer(ui.min_rect());
    let menu = egui::Popup::context_menu(label)
        .open_memory(is_asked.then_some(egui::SetOpenCommand::Bool(true)));
    menu.show(|ui| scrolling(ui, |ui| marks::menu(ui, marked, out)));
}

/// Shows a label with help, and a widget that is named by it; `slot` fills the room of the mark.
pub(crate) fn with_slot(
    ui: &mut Ui,
    label: RichText,
    help: &str,
    slot: impl FnOnce(&mut Ui, egui::Vec2),
    add: impl FnOnce(&mut Ui, Id),
) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        slot(ui, marks::size(ui));
        let id = name(ui, label, help, egui::Sense::hover()).id;
        add(ui, id);
    });
}

/// Shows the label of a row, in the width that all labels have.
fn name(ui: &mut Ui, label: RichText, help: &str, sense: egui::Sense) -> egui::Response {
    ui.spacing_mut().item_spacing.x = 6.0;
    let width = label_width(ui);
    let size = vec2(width, ui.spacing().interact_size.y);
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let response = ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.set_min_width(width);
        ui.set_max_width(width);
        // A long name takes a second line, but a long word is shortened.
        let font = egui::TextStyle::Body.resolve(ui.style());
        let word = |word: &str| {
            let word = word.to_owned();
            ui.painter().layout_no_wrap(word, font.clone(), egui::Color32::WHITE).size().x
        };
        let is_whole = label.text().split_whitespace().all(|part| word(part) <= width);
        let label = egui::Label::new(label).sense(sense);
        ui.add(if is_whole { label.wrap() } else { label.truncate() })
    });
    // What follows the label is shortened where a narrow row has no room for it.
    ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Truncate);
    ui.spacing_mut().combo_width = ui.spacing().combo_width.min(ui.available_width());
    if help.is_empty() { response.inner } else { response.inner.on_hover_text(help) }
}

/// Shows an input.
pub(crate) fn show(ui: &mut Ui, subject: &InspectedNode<'_>, port: &Port, out: &mut Vec<Command>) {
    ui.push_id(&port.name, |ui| {
        if let Some(wire) = subject.session.graph().wire_into(subject.id, &port.name) {
            return wired(ui, subject, port, wire, out);
        }
        let target = subject.session.selection.target(subject.id, &port.name);
        let is_keyed = subject.session.keys().keyed_by(&target) != KeyedBy::Nothing;
        let keyed = is_keyed.then(|| subject.session.keys().value_at(&target)).flatten();
        let own = subject.node.values.get(&port.name);
        let shown = keyed.as_ref().or(own);
        match port.ty {
            Type::Text if port.name.as_str() == CUSTOM_CODE => code(ui, subject, port, shown, out),
            Type::Curve => wide(ui, subject, port, shown, out, curve::show),
            Type::Ramp if port.name.as_str() == bands::PORT => {
                let label = ui.label(of_library(&port.label)).on_hover_text(help_of(port)).id;
                let space = subject.session.look().color_space;
                let value = values::current(port, shown);
                if let Some((id, value)) = bands::show(ui, label, value, space) {
                    out.push(held(subject, port, id, value));
                }
            }
            Type::Ramp => wide(ui, subject, port, shown, out, ramp::show),
            _ => {
                let reset_edit = reset_edit(subject, port);
                let with_marks = FieldTarget {
                    owned: OwnedKeys::of_look(subject.session),
                    target,
                    ty: &port.ty,
                    label: of_library(&port.label),
                    reset: reset_edit,
                };
                let is_mixed = is_mixed(subject, port);
                let tone = if shown.is_some() { theme::of(ui).text } else { theme::of(ui).dim };
                let mut text = RichText::new(of_library(&port.label)).color(tone);
                if with_marks.exposed().is_some() {
                    text = text.underline();
                }
                if is_mixed {
                    text = text.italics().color(theme::of(ui).accent);
                }
                let mut help = help_of(port);
                for line in [with_marks.help().as_str(), if is_mixed { MIXED.tr() } else { "" }] {
                    help += if line.is_empty() { "" } else { "\n" };
                    help += line;
                }
                marked(ui, text, &help, Some(&with_marks), out, |ui, label, out| {
                    reset(ui, subject, port, out);
                    if let Some((id, value)) = widget(ui, label, subject, port, shown) {
                        out.push(held(subject, port, id, value));
                    }
                });
                // The button is below the path, which takes the whole width.
                if matches!(port.ty, Type::Hcbtf | Type::Image) {
                    let lead = marks::size(ui).x + label_width(ui) + 9.0;
                    ui.horizontal(|ui| {
                        ui.add_space(lead);
                        match port.ty {
                            Type::Image => choose_button(ui, subject, port, out),
                            _ => paint_button(ui, subject, port, shown, out),
                        }
                    });
                }
            }
        }
    });
}

fn help_of(port: &Port) -> String {
    let input = format!("{} ({})", port.name, port.ty.label());
    let short = |number: f64| values::short(port, &Value::Number(number));
    let told = match (port.min.map(short), port.max.map(short)) {
        (Some(min), Some(max)) => tr!("{input}, {min} to {max}"),
        (Some(min), None) => tr!("{input}, {min} or more"),
        (None, Some(max)) => tr!("{input}, {max} or less"),
        (None, None) => input,
    };
    let told = match &port.fallback {
        Fallback::Value(value) if port.ty != Type::Text => {
            tr!("{told}; default {value}", value = values::short(port, value))
        }
        _ => told,
    };
    match of_library(&port.help) {
        "" => told,
        help => format!("{help}\n{told}"),
    }
}

/// Nodes that are selected with this one and have the same input free: a value that is set here is
/// set there too.
fn alike<'a>(
    subject: &'a InspectedNode<'_>,
    port: &'a Port,
) -> impl Iterator<Item = (&'a NodeId, &'a Node)> {
    let session = subject.session;
    session.selection.nodes.iter().filter(move |id| *id != subject.id).filter_map(move |id| {
        let node = session.graph().nodes.get(id)?;
        let kind = session.project.catalog.of(node)?;
        let other = &kind.inputs[kind.input(port.name.as_str())?];
        let is_free = session.graph().wire_into(id, &port.name).is_none();
        (is_free && other.ty == port.ty && other.unit == port.unit).then_some((id, node))
    })
}

/// True if the selected nodes have different values here.
fn is_mixed(subject: &InspectedNode<'_>, port: &Port) -> bool {
    let value = |id: &NodeId| {
        subject.session.keys().value_at(&subject.session.selection.target(id, &port.name))
    };
    let own = value(subject.id);
    alike(subject, port).any(|(id, _)| value(id) != own)
}

/// The edit that removes the nodes' own values.
fn reset_edit(subject: &InspectedNode<'_>, port: &Port) -> Option<Edit> {
    let with_own = std::iter::once((subject.id, subject.node)).chain(alike(subject, port));
    let clears =
        with_own.filter(|(_, node)| node.values.contains_key(&port.name)).map(|(id, _)| {
            Edit::ClearValue {
                graph: subject.session.selection.graph_id().clone(),
                id: id.clone(),
                port: port.name.clone(),
            }
        });
    let edits: Vec<Edit> = clears.collect();
    (!edits.is_empty()).then_some(Edit::Group { edits })
}

/// Sets a value of all selected nodes that have it, each in view: at its key, or the node's own.
fn held(subject: &InspectedNode<'_>, port: &Port, widget: Id, value: Value) -> Command {
    let session = subject.session;
    let target = session.selection.target(subject.id, &port.name);
    let others: Vec<_> =
        alike(subject, port).map(|(id, _)| session.selection.target(id, &port.name)).collect();
    let edit = match others.is_empty() {
        true => session.keys().set_at(&target, value),
        false => session.keys().set_all_at(
            std::iter::once(target).chain(others).map(|target| (target, value.clone())),
        ),
    };
    Command::EditHeld(widget, edit)
}

/// Room that the button of a wired input takes, and that of one without a value, in points.
const UNWIRE: f32 = 50.0;
const SET: f32 = 54.0;

/// Shows the source of a wired input.
fn wired(
    ui: &mut Ui,
    subject: &InspectedNode<'_>,
    port: &Port,
    wire: &Wire,
    out: &mut Vec<Command>,
) {
    labelled(ui, of_library(&port.label), &help_of(port), |ui, _| {
        let Endpoint { node, .. } = &wire.from;
        let from = subject.session.graph().nodes.get(node);
        let kind = from.and_then(|from| subject.session.project.catalog.of(from));
        let name = match (from, kind) {
            (Some(from), _) if !from.name.is_empty() => from.name.clone(),
            (_, Some(kind)) => of_library(&kind.label).to_owned(),
            _ => node.to_string(),
        };
        // A narrow row has room for the source alone; the canvas removes the wire too.
        if ui
            .link(tr!("from {name}"))
            .on_hover_text(tr!("Shows the node that feeds this"))
            .clicked()
        {
            out.push(Command::Reveal(node.clone()));
        }
        if ui.available_width() > UNWIRE
            && ui.small_button(tr!("Unwire")).on_hover_text(tr!("Removes the wire")).clicked()
        {
            out.push(Command::Edit(Edit::RemoveWire {
                graph: subject.session.selection.graph_id().clone(),
                wire: wire.clone(),
            }));
        }
    });
}

fn default_button(ui: &mut Ui) -> bool {
    let response = ui.add(egui::Button::new("×").small().frame(false));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, tr!("Default")));
    response.on_hover_text(tr!("Takes this value away, so that it has its default again")).clicked()
}

/// Shows a button that removes the node's own value.
fn reset(ui: &mut Ui, subject: &InspectedNode<'_>, port: &Port, out: &mut Vec<Command>) {
    // An input that reads its surroundings, or another input's value, has no widget for that, so
    // this button is the only way back.
    let is_own = subject.node.values.contains_key(&port.name);
    let is_read = matches!(port.fallback, Fallback::Context(_) | Fallback::Same(_));
    if is_own && is_read && default_button(ui) {
        let edit = Edit::ClearValue {
            graph: subject.session.selection.graph_id().clone(),
            id: subject.id.clone(),
            port: port.name.clone(),
        };
        out.push(Command::Edit(edit));
    }
}

/// Shows a button that asks for the image of this input.
fn choose_button(ui: &mut Ui, subject: &InspectedNode<'_>, port: &Port, out: &mut Vec<Command>) {
    let button = ui.small_button(tr!("Choose...")).on_hover_text(tr!("Asks for the image's file"));
    if button.clicked() {
        out.push(Command::AskImage(subject.session.selection.target(subject.id, &port.name)));
    }
}

/// Shows a button that opens the HCBTF of this input to be painted; a new one where there is none.
fn paint_button(
    ui: &mut Ui,
    subject: &InspectedNode<'_>,
    port: &Port,
    own: Option<&Value>,
    out: &mut Vec<Command>,
) {
    let name = match own {
        Some(Value::Text(name)) => name.as_str(),
        _ => "",
    };
    let help = match name {
        "" => tr!("Begins a new painted surface (HCBTF) here, and opens it to be painted"),
        _ => {
            tr!("Opens this painted surface (HCBTF) to be painted; the picture shows every stroke \
                 at once")
        }
    };
    let response = ui.small_button(tr!("Paint")).on_hover_text(help);
    if !response.clicked() {
        return;
    }
    if name.is_empty() {
        out.push(held(subject, port, response.id, Value::Text(UNSAVED_HCBTF.to_owned())));
        out.push(Command::Paint(PaintCommand::New { grid: Grid::THESIS, keeps_look: true }));
    } else if name.starts_with(PREFIX) {
        // The painting will be a copy of the example, without a file yet: the look names the copy
        // once it exists.
        out.push(Command::Paint(PaintCommand::Open { path: name.into(), keeps_look: true }));
    } else if name != UNSAVED_HCBTF {
        out.push(Command::Paint(PaintCommand::Open {
            path: subject.session.look.folder().join(name),
            keeps_look: true,
        }));
    } else {
        out.push(Command::ShowPanel(PanelId::PAINT));
    }
}

/// Shows the widget of an input's type. Returns the widget's id and the new value where it changed.
fn widget(
    ui: &mut Ui,
    label: Id,
    subject: &InspectedNode<'_>,
    port: &Port,
    own: Option<&Value>,
) -> Option<(Id, Value)> {
    let value = values::current(port, own);
    match &port.ty {
        _ if value.is_none() => unset(ui, subject, port),
        Type::LightName => light_name(ui, label, subject, value),
        Type::Text => light_set(ui, label, value),
        _ => plain(ui, label, port, value, subject.session.look().color_space),
    }
}

/// Shows a set of lights as a text that is one.
fn light_set(ui: &mut Ui, label: Id, value: Option<&Value>) -> Option<(Id, Value)> {
    let text = match value {
        Some(Value::Text(text)) => text.clone(),
        _ => String::new(),
    };
    let read = |text: &str| match LightSet::parse(text) {
        Ok(_) => Ok(text.to_owned()),
        Err(why) => Err(why.to_string()),
    };
    let (widget, text) = formed(ui, label, &text, String::clone, read)?;
    Some((widget, Value::Text(text)))
}

/// Shows the widget of a type that needs no node; `space` is the color space of a color's numbers.
/// Returns the widget's id and the new value where it changed.
pub(crate) fn plain(
    ui: &mut Ui,
    label: Id,
    port: &Port,
    value: Option<&Value>,
    space: ColorSpace,
) -> Option<(Id, Value)> {
    match &port.ty {
        Type::Bool => {
            let mut on = values::number(value) > 0.5;
            let response = ui.add(Checkbox::without_text(&mut on)).labelled_by(label);
            response.changed().then_some((response.id, Value::Bool(on)))
        }
        Type::Choice => choice(ui, label, port, value),
        Type::Color | Type::Composite => {
            let color =
                value.and_then(|value| value.color_in(space)).unwrap_or([0.0, 0.0, 0.0, 1.0]);
            let (id, color) = color::edit(ui, label, color, space, true)?;
            let is_opaque = color[3] == 1.0;
            Some((id, Value::Vector(if is_opaque { color[..3].to_vec() } else { color.to_vec() })))
        }
        Type::Vec2 => vector(ui, label, port, value, 2),
        Type::Vec3 => vector(ui, label, port, value, 3),
        Type::Vec4 => vector(ui, label, port, value, 4),
        Type::Image => path::edit(ui, label, value, true),
        Type::Hcbtf => path::edit(ui, label, value, false),
        Type::Float | Type::Int | Type::Angle => number(ui, label, port, value),
        _ => {
            ui.label(RichText::new(tr!("by wire only")).color(theme::of(ui).dim));
            None
        }
    }
}

/// Shows an input that has neither a value nor a default.
fn unset(ui: &mut Ui, subject: &InspectedNode<'_>, port: &Port) -> Option<(Id, Value)> {
    let width = port.ty.width();
    let of_all = |number: f64| match width {
        Some(1) => Some(Value::Number(number)),
        Some(width) => Some(Value::Vector(vec![number; width])),
        None => None,
    };
    let (text, first) = match &port.fallback {
        Fallback::Context(context) => {
            (tr!("the surface's {what}", what = values::context_words(*context)), of_all(0.0))
        }
        Fallback::Same(other) => {
            let kind = subject.session.project.catalog.of(subject.node);
            let of_other = kind.and_then(|kind| Some(&kind.inputs[kind.input(other.as_str())?]));
            let value = of_other
                .and_then(|other| values::current(other, subject.node.values.get(&other.name)));
            (
                tr!("as {input}", input = values::input_words(other)),
                value.cloned().or_else(|| of_all(1.0)),
            )
        }
        _ => {
            ui.label(RichText::new(tr!("wire something here")).color(theme::of(ui).warning));
            return None;
        }
    };
    ui.scope(|ui| {
        ui.set_max_width((ui.available_width() - SET).max(0.0));
        ui.label(RichText::new(text).color(theme::of(ui).dim));
    });
    let response = ui.small_button(tr!("Set")).on_hover_text(tr!("Gives it a value of its own"));
    if response.clicked() { Some((response.id, first?)) } else { None }
}

/// Width that is left, at least a little, however narrow the panel is; in points.
fn room(ui: &Ui) -> f32 {
    ui.available_width().max(32.0)
}

/// Shows a number. Radians are shown as degrees.
fn number(ui: &mut Ui, label: Id, port: &Port, value: Option<&Value>) -> Option<(Id, Value)> {
    let scale = if port.unit == "rad" { 180.0 / std::f64::consts::PI } else { 1.0 };
    let is_int = port.ty == Type::Int;
    let mut shown = values::number(value) * scale;
    let suffix = match port.unit.as_str() {
        "rad" => "°",
        "px" => " px",
        "s" => " s",
        _ => "",
    };
    let decimals = if is_int {
        0
    } else if scale == 1.0 {
        3
    } else {
        1
    };
    let response = match (port.min, port.max) {
        (Some(min), Some(max)) if ui.available_width() > SLIDER => {
            ui.spacing_mut().slider_width = ui.available_width() - NUMBER;
            let range = min * scale..=max * scale;
            let slider = number_slider(ui, &mut shown, range).suffix(suffix).max_decimals(decimals);
            let slider = slider;
            ui.add(if is_int { slider.integer() } else { slider })
        }
        (min, max) => {
            let range = min.map_or(f64::NEG_INFINITY, |x| x * scale)
                ..=max.map_or(f64::INFINITY, |x| x * scale);
            let speed = if is_int { 0.1 } else { 0.01 * scale.max(1.0) };
            let drag = number_field(ui, &mut shown)
                .range(range)
                .clamp_existing_to_range(false)
                .suffix(suffix)
                .max_decimals(decimals)
                .speed(speed);
            ui.add_sized(vec2(room(ui), ui.spacing().interact_size.y), drag)
        }
    };
    let response = response.labelled_by(label);
    if !response.changed() || !shown.is_finite() {
        return None;
    }
    Some((response.id, Value::Number(if is_int { shown.round() } else { shown / scale })))
}

fn vector(
    ui: &mut Ui,
    label: Id,
    port: &Port,
    value: Option<&Value>,
    width: usize,
) -> Option<(Id, Value)> {
    let mut numbers = values::vector(value, width);
    let each = ((ui.available_width() - ui.spacing().item_spacing.x * (width as f32 - 1.0))
        / width as f32)
        .max(16.0);
    let mut changed = None;
    for number in &mut numbers {
        let mut drag =
            number_field(ui, number).speed(0.01).max_decimals(3).clamp_existing_to_range(false);
        if let (Some(min), Some(max)) = (port.min, port.max) {
            drag = drag.range(min..=max);
        }
        let response =
            ui.add_sized(vec2(each, ui.spacing().interact_size.y), drag).labelled_by(label);
        if response.changed() {
            changed = Some(response.id);
        }
    }
    let is_finite = numbers.iter().all(|number| number.is_finite());
    changed.filter(|_| is_finite).map(|id| (id, Value::Vector(numbers)))
}

fn choice(ui: &mut Ui, label: Id, port: &Port, value: Option<&Value>) -> Option<(Id, Value)> {
    let word = match value {
        Some(Value::Text(word)) => word.as_str(),
        _ => "",
    };
    let shown = port
        .options
        .iter()
        .find(|(known, _)| known == word)
        .map_or(word, |(_, label)| of_choice(label));
    let width = room(ui);
    let mut chosen = None;
    let combo = ComboBox::from_id_salt("choice")
        .width(width)
        .truncate()
        .selected_text(shown)
        .show_ui(ui, |ui| {
            for (known, label) in &port.options {
                if ui.selectable_label(known == word, of_choice(label)).clicked() && known != word {
                    chosen = Some(known.clone());
                }
            }
        });
    let response = combo.response.labelled_by(label).on_hover_text(shown);
    chosen.map(|word| (response.id.with(&word), Value::Text(word)))
}

fn light_name(
    ui: &mut Ui,
    label: Id,
    subject: &InspectedNode<'_>,
    value: Option<&Value>,
) -> Option<(Id, Value)> {
    let id = match value {
        Some(Value::Text(id)) => id.as_str(),
        _ => "",
    };
    let lights = &subject.session.look().lights;
    let name = |id: &str| {
        let light = lights.get(id).filter(|light| !light.name.is_empty());
        light.map_or_else(|| id.to_owned(), |light| light.name.clone())
    };
    let mut chosen = None;
    let shown = if id.is_empty() { tr!("choose a light").to_owned() } else { name(id) };
    let combo = ComboBox::from_id_salt("light")
        .width(room(ui))
        .truncate()
        .selected_text(&shown)
        .show_ui(ui, |ui| {
            for known in lights.keys() {
                if ui.selectable_label(known.as_str() == id, name(known.as_str())).clicked() {
                    chosen = Some(known.to_string());
                }
            }
        });
    let response = combo.response.labelled_by(label).on_hover_text(shown);
    chosen.map(|id| (response.id.with(&id), Value::Text(id)))
}

/// Shows the WGSL of a custom node.
fn code(
    ui: &mut Ui,
    subject: &InspectedNode<'_>,
    port: &Port,
    own: Option<&Value>,
    out: &mut Vec<Command>,
) {
    let mut text = match values::current(port, own) {
        Some(Value::Text(text)) => text.clone(),
        _ => String::new(),
    };
    let label = ui.label(of_library(&port.label)).on_hover_text(help_of(port)).id;
    let edit =
        TextEdit::multiline(&mut text).code_editor().desired_rows(10).desired_width(f32::INFINITY);
    let response = ui.add(edit).labelled_by(label);
    if response.changed() {
        out.push(held(subject, port, response.id, Value::Text(text)));
    }
}

type Editor = fn(&mut Ui, Id, Option<&Value>) -> Option<(Id, Value)>;

/// Shows an editor that takes the whole width, below its label.
fn wide(
    ui: &mut Ui,
    subject: &InspectedNode<'_>,
    port: &Port,
    own: Option<&Value>,
    out: &mut Vec<Command>,
    show: Editor,
) {
    let label = ui.label(of_library(&port.label)).on_hover_text(help_of(port)).id;
    if let Some((id, value)) = show(ui, label, values::current(port, own)) {
        out.push(held(subject, port, id, value));
    }
}
