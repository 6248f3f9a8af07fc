//! List of the painted samples: sorted by light or by view, each with its actions.

use chiaro_locale::tr;
use eframe::egui::{FontId, Rect, Role, ScrollArea, Sense, Ui, WidgetInfo, pos2, vec2};

use super::easel::name_of;
use super::moves;
use crate::commands::{Command, PaintCommand};
use crate::document::{Address, HcbtfEdit};
use crate::painter::atlas::Atlas;
use crate::state::painting::work::OpenPainting;
use crate::widgets::rows::{picture_frame, row_ground};
use crate::widgets::text::cell;
use crate::widgets::theme;

const ROW: f32 = 30.0;

/// Order of the list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Order {
    #[default]
    View,
    Light,
}

/// Lists the painted samples. `peek` is set while a sample is only looked at.
pub(super) fn show(
    ui: &mut Ui,
    work: &OpenPainting,
    atlas: &Atlas,
    order: &mut Order,
    peek: &mut Option<Address>,
    out: &mut Vec<Command>,
) {
    let mut painted: Vec<Address> = work.hcbtf().painted.keys().copied().collect();
    ui.horizontal(|ui| {
        ui.strong(tr!("{count} painted", count = painted.len()));
        ui.label(tr!("sorted" => "by"));
        ui.selectable_value(order, Order::View, tr!("sorted by" => "view"))
            .on_hover_text(tr!("Sorts by where the eye is"));
        ui.selectable_value(order, Order::Light, tr!("sorted by" => "light"))
            .on_hover_text(tr!("Sorts by where the light is"));
    });
    if painted.is_empty() {
        let text = tr!(
            "Paint on the tile: each light and view that you paint is listed here. The rules fill \
             the others."
        );
        ui.label(eframe::egui::RichText::new(text).color(theme::of(ui).dim));
        return;
    }
    if *order == Order::Light {
        painted.sort_by_key(|address| (address.light, address.view));
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    ScrollArea::vertical().id_salt("painted").auto_shrink([false, false]).show_rows(
        ui,
        ROW,
        painted.len(),
        |ui, rows| {
            for address in &painted[rows] {
                row(ui, work, *address, *order, atlas, peek, out);
            }
        },
    );
}

fn row(
    ui: &mut Ui,
    work: &OpenPainting,
    address: Address,
    order: Order,
    atlas: &Atlas,
    peek: &mut Option<Address>,
    out: &mut Vec<Command>,
) {
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width() - 8.0, ROW), Sense::click());
    let name = name_of(work, address);
    let is_at_work = work.at() == address;
    response.widget_info(|| {
        WidgetInfo::selected(Role::ListItem, true, is_at_work, tr!("Sample {name}"))
    });
    row_ground(ui, rect, &response, is_at_work);
    let picture = Rect::from_min_size(rect.min + vec2(4.0, 3.0), vec2(24.0, 24.0));
    atlas.paint(ui.painter(), work, address, picture);
    picture_frame(ui, picture);
    let grid = work.grid();
    let view = tr!("view {direction}", direction = moves::name(grid.view, address.view));
    let light = tr!("light {direction}", direction = moves::name(grid.light, address.light));
    let parts = match order {
        Order::View => [view, light],
        Order::Light => [light, view],
    };
    for (index, text) in parts.into_iter().enumerate() {
        let top = rect.top() + 1.0 + index as f32 * 14.0;
        let line = Rect::from_min_max(
            pos2(picture.right() + 8.0, top),
            pos2(rect.right() - 110.0, top + 14.0),
        );
        let ink = if index == 0 { theme::of(ui).text } else { theme::of(ui).dim };
        cell(ui, line, &text, FontId::proportional(theme::SMALL_TEXT), ink);
    }
    let buttons =
        Rect::from_min_max(pos2(rect.right() - 106.0, rect.top() + 3.0), rect.max - vec2(2.0, 3.0));
    let layout = eframe::egui::Layout::right_to_left(eframe::egui::Align::Center);
    let mut row = ui.new_child(eframe::egui::UiBuilder::new().max_rect(buttons).layout(layout));
    let delete = row.small_button(tr!("Delete"));
    delete.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Delete {name}")));
    if delete
        .on_hover_text(tr!(
            "Takes this painting away: the rules fill its place. Undo brings it back"
        ))
        .clicked()
    {
        out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::DeleteTile { address })));
    }
    let copy = row.add_enabled(!is_at_work, eframe::egui::Button::new(tr!("Copy")).small());
    copy.widget_info(|| WidgetInfo::labeled(Role::Button, !is_at_work, tr!("Copy {name}")));
    if copy.on_hover_text(tr!("Copies this painting to the sample at work")).clicked() {
        out.extend(copy_to(work, address, work.at()));
    }
    if response.hovered() && ui.input(|input| input.modifiers.alt) {
        *peek = Some(address);
    }
    if response.clicked() {
        out.push(Command::Paint(PaintCommand::GoTo(address)));
    }
    response.on_hover_text(tr!("Click to work at it; hold Alt to only look at it"));
}

/// Command that copies the tile seen at a sample to another sample.
pub(super) fn copy_to(work: &OpenPainting, from: Address, to: Address) -> Option<Command> {
    let edit = match work.hcbtf().painted(from) {
        Some(_) => HcbtfEdit::CopyTile { from, to },
        None => HcbtfEdit::SetTile { address: to, tile: Some(work.tile(from)?.clone()) },
    };
    Some(Command::Paint(PaintCommand::Edit(edit)))
}
