//! Table of the probe's result.

use chiaro_locale::{tr, tr_in};
use eframe::egui;
use eframe::egui::{FontId, Rect, RichText, ScrollArea, Sense, Ui, pos2, vec2};

use super::{Probe, lights};
use crate::commands::Command;
use crate::fields::wire_value::{color_of, text_of};
use crate::ids::NodePath;
use crate::progress::Interruption;
use crate::reference::WireValue;
use crate::state::problem_text::sentence;
use crate::state::session::Session;
use crate::state::wire::{ShownWire, Style};
use crate::widgets::text::{cell, hint};
use crate::widgets::theme;

/// Height of a row, in points.
pub(super) const ROW: f32 = 20.0;

/// Left ends of the columns, as parts of the width.
const COLUMNS: [f32; 4] = [0.0, 0.3, 0.57, 0.84];

impl Probe {
    /// Shows the table, or why there is none.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut commands = Vec::new();
        self.head(ui, &mut commands);
        if !self.is_on {
            hint(
                ui,
                tr!("Turn on the probe (I) and point at the picture: every wire's value at that \
                     pixel is listed here."),
            );
            return commands;
        }
        match self.found.as_ref().map(|found| &found.result) {
            None => hint(ui, tr!("Rest the pointer on the picture, or click to keep a pixel.")),
            Some(Ok(None)) => hint(ui, tr!("Nothing is drawn there.")),
            Some(Ok(Some(found))) if self.lists_lights => {
                commands.extend(lights::table(ui, session, &found.lights));
            }
            Some(Ok(Some(found))) => {
                let jump = std::mem::take(&mut self.jump);
                commands.extend(table(ui, session, (&found.wires, &self.names), jump));
            }
            Some(Err(found)) => {
                for problem in
                    found.iter().filter(|problem| problem.code != Interruption::CODE).take(3)
                {
                    ui.label(RichText::new(sentence(problem)).color(theme::of(ui).error));
                }
            }
        }
        commands
    }

    fn head(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        ui.horizontal(|ui| {
            let mut is_on = self.is_on;
            let toggle = ui.toggle_value(&mut is_on, tr!("Probe the picture"));
            if toggle
                .on_hover_text(tr!("Reads every wire's value at a pixel (I); Esc leaves it"))
                .changed()
            {
                commands.push(Command::Probe(is_on.into()));
            }
            if !self.is_on {
                return;
            }
            self.lists(ui);
            if let Some([x, y]) = self.pixel {
                let text = match self.is_pinned {
                    true => tr!("pixel {x}, {y} · kept"),
                    false => tr!("pixel {x}, {y}"),
                };
                ui.label(RichText::new(text).color(theme::of(ui).dim));
            }
            if self.worker.is_busy() {
                ui.label(RichText::new(tr!("computing")).color(theme::of(ui).accent));
            } else if self.found.is_some() && !self.is_current() {
                ui.label(RichText::new(tr!("of before")).color(theme::of(ui).dim));
            }
            let broken = self.wires().iter().find(|wire| !wire.is_finite());
            let node = broken.and_then(|wire| wire.node.outermost().cloned());
            if let Some(node) = node {
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    let text =
                        RichText::new(tr!("Go to first broken wire")).color(theme::of(ui).error);
                    let help =
                        tr!("Shows the node whose value is the first that is not a finite number");
                    if ui.button(text).on_hover_text(help).clicked() {
                        self.jump = true;
                        self.lists_lights = false;
                        commands.push(Command::Show(NodePath::root(node)));
                    }
                });
            }
        });
        ui.add_space(2.0);
    }

    /// Shows the choice between the lists.
    fn lists(&mut self, ui: &mut Ui) {
        let lists = [
            (false, tr!("Wires"), tr!("The value on every wire at the pixel, f32 beside f64")),
            (
                true,
                tr!("Why lit so"),
                tr!("Each light with its strength there, and the rule by which it reaches the \
                     object or does not"),
            ),
        ];
        for (lists_lights, label, help) in lists {
            ui.selectable_value(&mut self.lists_lights, lists_lights, label).on_hover_text(help);
        }
    }
}

fn column(rect: Rect, index: usize) -> Rect {
    column_of(rect, &COLUMNS, index)
}

/// Column of a row, by the left ends of all columns as parts of the width.
pub(super) fn column_of(rect: Rect, columns: &[f32], index: usize) -> Rect {
    let inner = Rect::from_min_max(rect.min + vec2(10.0, 0.0), rect.max);
    let end = columns.get(index + 1).copied().unwrap_or(1.0);
    let x = |part: f32| inner.left() + part * inner.width();
    Rect::from_min_max(pos2(x(columns[index]), rect.top()), pos2(x(end) - 8.0, rect.bottom()))
}

/// Table of wires with the names of their rows.
fn table(
    ui: &mut Ui,
    session: &Session,
    (wires, names): (&[WireValue], &[String]),
    jump: bool,
) -> Vec<Command> {
    ui.spacing_mut().item_spacing.y = 0.0;
    let (head, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    for (index, title) in [tr!("Node"), "f32", "f64", tr!("Difference")].into_iter().enumerate() {
        cell(
            ui,
            column(head, index),
            title,
            FontId::proportional(theme::SMALL_TEXT),
            theme::of(ui).dim,
        );
    }
    ui.painter().hline(
        head.x_range(),
        head.bottom() - 1.0,
        egui::Stroke::new(1.0, theme::of(ui).grid),
    );
    let first_broken = wires.iter().position(|wire| !wire.is_finite());
    let mut area = ScrollArea::vertical().auto_shrink([false, false]);
    if let Some(row) = first_broken.filter(|_| jump) {
        area = area.vertical_scroll_offset((row as f32 - 2.0).max(0.0) * ROW);
    }
    let mut commands = Vec::new();
    area.show_rows(ui, ROW, wires.len(), |ui, rows| {
        for index in rows {
            let name = names.get(index).map_or("", String::as_str);
            let is_first_broken = Some(index) == first_broken;
            commands.extend(row(ui, session, (&wires[index], name), is_first_broken));
        }
    });
    commands
}

fn row(
    ui: &mut Ui,
    session: &Session,
    (wire, name): (&WireValue, &str),
    is_first_broken: bool,
) -> Option<Command> {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Button, true, tr!("Wire of {node}", node = wire.node))
    });
    let is_selected = wire.node.outermost().is_some_and(|id| session.selection.nodes.contains(id));
    if is_first_broken {
        ui.painter().rect_filled(rect, 2.0, theme::of(ui).error.gamma_multiply(0.25));
    } else if is_selected {
        ui.painter().rect_filled(rect, 2.0, theme::of(ui).accent_dim.gamma_multiply(0.55));
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 2.0, theme::of(ui).field.gamma_multiply(0.6));
    }
    if !wire.is_finite() {
        ui.painter().circle_filled(
            pos2(rect.left() + 4.0, rect.center().y),
            3.0,
            theme::of(ui).error,
        );
    }
    let ink = if wire.is_finite() { theme::of(ui).text } else { theme::of(ui).error };
    let look = session.look_with_library();
    cell(ui, column(rect, 0), name, FontId::proportional(theme::TEXT_SIZE), ink);
    for (index, numbers) in [(1, &wire.single), (2, &wire.double)] {
        let mut place = column(rect, index);
        if let Some(color) = color_of(look, wire, numbers) {
            let swatch =
                Rect::from_min_size(pos2(place.left(), rect.center().y - 5.0), vec2(10.0, 10.0));
            ui.painter().rect_filled(swatch, 2.0, color);
            let edge = egui::Stroke::new(1.0, theme::of(ui).swatch_edge);
            ui.painter().rect_stroke(swatch, 2.0, edge, egui::StrokeKind::Inside);
            place.min.x += 16.0;
        }
        let text = text_of(look, wire, numbers);
        cell(ui, place, &text, FontId::monospace(11.0), ink);
    }
    let difference = wire.difference();
    let far = difference > 1.0 / 255.0;
    let ink = if !wire.is_finite() {
        theme::of(ui).error
    } else if far {
        theme::of(ui).warning
    } else {
        theme::of(ui).dim
    };
    let text = if difference == 0.0 { "0".to_owned() } else { format!("{difference:.1e}") };
    cell(ui, column(rect, 3), &text, FontId::monospace(11.0), ink);
    let mut command = response
        .clicked()
        .then(|| wire.node.outermost().cloned().map(|id| Command::Show(NodePath::root(id))))
        .flatten();
    response.context_menu(|ui| {
        let node = look.node_at(&wire.node);
        let Some(kind) = node.and_then(|node| session.project.catalog.of(node)) else { return };
        for (port, style) in
            kind.outputs.iter().flat_map(|port| Style::ALL.map(|style| (port, style)))
        {
            let text = show_as(&port.label, style);
            if ui.button(text).on_hover_text(style.help()).clicked() {
                let shown = ShownWire { node: wire.node.clone(), port: port.name.clone(), style };
                command = Some(Command::ShowWire(Some(shown)));
            }
        }
    });
    response.on_hover_ui(|ui| in_full(ui, name, &text_of(look, wire, &wire.double), wire));
    command
}

/// Label of the entry that shows an output in place of the picture.
fn show_as(port: &str, style: Style) -> String {
    let port = tr_in("node", port);
    match style {
        Style::Color => tr!("Show {port} as color"),
        Style::Heat => tr!("Show {port} as heat"),
        Style::Isolines => tr!("Show {port} as isolines"),
    }
}

/// Shows a wire in words, and every scalar with all its digits.
fn in_full(ui: &mut Ui, name: &str, text: &str, wire: &WireValue) {
    ui.label(RichText::new(name).strong());
    ui.label(text);
    ui.label(RichText::new(tr!("{name} in the WGSL", name = wire.name)).color(theme::of(ui).dim));
    egui::Grid::new("in full").num_columns(3).spacing([16.0, 2.0]).show(ui, |ui| {
        for (single, double) in wire.single.iter().zip(&wire.double) {
            let monospace = |text: String| RichText::new(text).monospace();
            ui.label(monospace(format!("{single:.9}")));
            ui.label(monospace(format!("{double:.15}")));
            let off = if single == double { 0.0 } else { (single - double).abs() };
            ui.label(monospace(format!("{off:.1e}")).color(theme::of(ui).dim));
            ui.end_row();
        }
    });
    ui.label(
        RichText::new(tr!(
            "f32, f64 and their difference; a click shows the node, a right click shows the wire \
             in the picture"
        ))
        .color(theme::of(ui).dim),
    );
}
