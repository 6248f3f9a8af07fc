//! Nodes of the library.

use std::sync::Arc;

use chiaro_locale::{tr, tr_in};
use eframe::egui;
use eframe::egui::{
    Align2, Area, CollapsingHeader, CursorIcon, FontId, Id, Order, Rect, Response, Role,
    ScrollArea, Sense, Ui, WidgetInfo, pos2, vec2,
};

use super::DraggedKind;
use crate::catalog::NodeKind;
use crate::commands::Command;
use crate::state::session::Session;
use crate::widgets::rows::row_ground;
use crate::widgets::text::{cell, hint};
use crate::widgets::theme;

const ROW: f32 = 24.0;

/// Lists kinds: by category, or those that match a search, best first.
pub(super) fn show(ui: &mut Ui, session: &Session, query: &str) -> Vec<Command> {
    let mut out = Vec::new();
    let kinds = || session.project.catalog.all().filter(|kind| !kind.is_missing);
    ScrollArea::vertical().auto_shrink([false, false]).id_salt("nodes").show(ui, |ui| {
        ui.set_max_width(ui.available_width() - 8.0);
        ui.spacing_mut().item_spacing.y = 1.0;
        if !query.trim().is_empty() {
            let mut found: Vec<(u32, &Arc<NodeKind>)> =
                kinds().filter_map(|kind| Some((rank(kind, query)?, kind))).collect();
            found.sort_by_key(|(rank, _)| *rank);
            if found.is_empty() {
                hint(ui, tr!("No node of that name"));
            }
            found.iter().for_each(|(_, kind)| row(ui, kind, &mut out));
            return;
        }
        let mut categories: Vec<&str> = Vec::new();
        for kind in kinds() {
            if !categories.contains(&kind.category.as_str()) {
                categories.push(&kind.category);
            }
        }
        // Layers and lights come first, as looks are begun with them.
        categories.sort_by_key(|category| match *category {
            "layer" => 0,
            "light" => 1,
            "group" => 2,
            _ => 3,
        });
        for category in categories {
            let title = capital(tr_in("node", category));
            let header = CollapsingHeader::new(title)
                .id_salt(category)
                .default_open(matches!(category, "layer" | "light" | "group"));
            header.show_unindented(ui, |ui| {
                for kind in kinds().filter(|kind| kind.category == category) {
                    row(ui, kind, &mut out);
                }
                ui.add_space(4.0);
            });
        }
    });
    out
}

fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Rank of a kind in a search, 0 best; `None` where a word is found nowhere in the kind. Texts are
/// searched in the user's language and in English.
fn rank(kind: &NodeKind, query: &str) -> Option<u32> {
    let both = |text: &str| [text, tr_in("node", text)].map(str::to_lowercase);
    let (labels, helps) = (both(&kind.label), both(&kind.help));
    let categories = both(&kind.category);
    let has = |texts: &[String; 2], word: &str| texts.iter().any(|text| text.contains(word));
    let mut sum = 0;
    for word in query.to_lowercase().split_whitespace() {
        sum += if labels.iter().any(|label| label.starts_with(word)) {
            0
        } else if has(&labels, word) {
            1
        } else if kind.id.contains(word) || has(&categories, word) {
            2
        } else if word.len() > 2 && has(&helps, word) {
            4
        } else {
            return None;
        };
    }
    Some(sum)
}

fn row(ui: &mut Ui, kind: &Arc<NodeKind>, out: &mut Vec<Command>) {
    let id = Id::unique("library").with(&kind.id);
    let (_, rect) = ui.allocate_space(vec2(ui.available_width(), ROW));
    let response = ui.interact(rect, id, Sense::click_and_drag());
    response.widget_info(|| {
        WidgetInfo::labeled(
            Role::Button,
            true,
            tr!("Library node {name}", name = tr_in("node", &kind.label)),
        )
    });
    let is_dragged = response.dragged();
    if ui.is_rect_visible(rect) {
        row_ground(ui, rect, &response, is_dragged);
        paint(ui, rect, kind);
    }
    response.dnd_set_drag_payload(DraggedKind(kind.id.clone()));
    if is_dragged {
        ghost(ui, kind);
    }
    if response.clicked() {
        out.push(Command::AddNode { kind: kind.id.clone(), at: None });
    }
    tell(response, kind);
}

fn paint(ui: &Ui, rect: Rect, kind: &NodeKind) {
    let colors = theme::of(ui);
    let chip = Rect::from_min_size(rect.min + vec2(6.0, 5.0), vec2(5.0, ROW - 10.0));
    ui.painter().rect_filled(chip, 2.0, colors.of_category(&kind.category).gamma_multiply(1.5));
    // Dots show the types of the outputs, in the colors of their sockets.
    let mut x = rect.right() - 10.0;
    for output in kind.outputs.iter().rev().take(4) {
        ui.painter().circle_filled(pos2(x, rect.center().y), 3.5, colors.of_type(&output.ty));
        x -= 11.0;
    }
    let text =
        Rect::from_min_max(pos2(rect.left() + 18.0, rect.top()), pos2(x - 2.0, rect.bottom()));
    cell(ui, text, tr_in("node", &kind.label), FontId::proportional(theme::TEXT_SIZE), colors.text);
}

/// Shows a node at the pointer while the node is dragged.
fn ghost(ui: &Ui, kind: &NodeKind) {
    let Some(at) = ui.input(|input| input.pointer.latest_pos()) else { return };
    ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
    let area = Area::new(Id::unique("library ghost"))
        .order(Order::Tooltip)
        .fixed_pos(at + vec2(10.0, 6.0))
        .interactable(false);
    area.show(ui.ctx(), |ui| {
        let size = vec2(theme::NODE_WIDTH, theme::TITLE_HEIGHT);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let colors = theme::of(ui);
        ui.painter().rect_filled(rect, 5.0, colors.of_category(&kind.category));
        let font = FontId::proportional(theme::TEXT_SIZE);
        ui.painter().text(
            rect.left_center() + vec2(10.0, 0.0),
            Align2::LEFT_CENTER,
            tr_in("node", &kind.label),
            font,
            colors.text,
        );
    });
}

fn tell(response: Response, kind: &NodeKind) {
    response.on_hover_ui(|ui: &mut egui::Ui| {
        ui.set_max_width(320.0);
        ui.label(egui::RichText::new(tr_in("node", &kind.label)).strong());
        let first = tr_in("node", &kind.help).split("\n\n").next().unwrap_or_default();
        if !first.is_empty() {
            ui.label(first);
        }
        ui.label(
            egui::RichText::new(tr!("Drag it onto the canvas, or click to add it in the middle"))
                .small()
                .color(theme::of(ui).dim),
        );
    });
}
