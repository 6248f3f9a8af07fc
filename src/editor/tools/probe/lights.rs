//! List of the lights at the probed pixel: why it is lit so.

use chiaro_locale::{Text, text, tr, tr_in};
use eframe::egui::{Color32, FontId, Role, ScrollArea, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

use super::panel::{ROW, column_of};
use crate::commands::Command;
use crate::reference::{LightAccount, LightReading};
use crate::state::session::Session;
use crate::values::number_text;
use crate::widgets::text::{cell, hint};
use crate::widgets::theme;

/// Left ends of the columns, as parts of the width.
const COLUMNS: [f32; 5] = [0.0, 0.2, 0.31, 0.42, 0.62];
/// Titles of the columns, with their help.
const TITLES: [(Text, Text); 5] = [
    (text!("Light"), text!("A click shows the first node that the light goes through")),
    (
        text!("Arrives"),
        text!("Luminance of the light there: color, intensity, masters, fading and cone"),
    ),
    (text!("Facing"), text!("Angle between the surface's normal and the way to the light")),
    (text!("Becomes"), text!("What nodes make of it there: tones, shares of filters, shadows")),
    (
        text!("Why"),
        text!("The rule by which the light reaches the object, or by which it does not"),
    ),
];
/// Reason of a light that is out in this window alone.
const OUT_HERE: Text = text!("muted, or left out by a solo, in this window");

/// Shows the list.
pub(super) fn table(ui: &mut Ui, session: &Session, lights: &[LightAccount]) -> Vec<Command> {
    if lights.is_empty() {
        hint(ui, tr!("Neither the scene nor the looks of the object have lights."));
        return Vec::new();
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    let (head, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let dim = theme::of(ui).dim;
    for (index, (title, help)) in TITLES.into_iter().enumerate() {
        let place = column_of(head, &COLUMNS, index);
        cell(ui, place, title.tr(), FontId::proportional(theme::SMALL_TEXT), dim);
        ui.interact(place, ui.scope_id().with(title.english()), Sense::hover())
            .on_hover_text(help.tr());
    }
    let line = Stroke::new(1.0, theme::of(ui).grid);
    ui.painter().hline(head.x_range(), head.bottom() - 1.0, line);
    let area = ScrollArea::vertical().auto_shrink([false, false]);
    let rows = area.show(ui, |ui| {
        lights.iter().filter_map(|account| row(ui, session, account)).collect::<Vec<_>>()
    });
    rows.inner
}

fn row(ui: &mut Ui, session: &Session, account: &LightAccount) -> Option<Command> {
    let is_out_here = session.view.solo.is_dark(&account.light);
    let is_lit = account.reaches && !is_out_here;
    let why = if is_out_here { OUT_HERE.tr() } else { &account.rule };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
    response.widget_info(|| {
        let name = match is_lit {
            true => tr!("Light {light} reaches the pixel: {why}", light = account.name),
            false => tr!("Light {light} does not reach the pixel: {why}", light = account.name),
        };
        WidgetInfo::labeled(Role::Button, true, name)
    });
    let colors = theme::of(ui);
    if response.hovered() {
        ui.painter().rect_filled(rect, 2.0, colors.field.gamma_multiply(0.6));
    }
    let ink = if is_lit { colors.text } else { colors.dim };
    mark(ui, rect, account, is_lit);
    let texts = [
        account.name.clone(),
        if is_lit { number_text(account.energy, 3) } else { "-".to_owned() },
        format!("{}°", number_text(account.facing.to_degrees(), 1)),
        if is_lit { summary(&account.readings) } else { String::new() },
        why.to_owned(),
    ];
    for (index, text) in texts.iter().enumerate() {
        // A light from behind the surface is told by its angle.
        let is_behind = index == 2 && account.facing > std::f64::consts::FRAC_PI_2;
        let color = if is_behind { colors.dim } else { ink };
        let font = match index {
            0 | 4 => FontId::proportional(theme::TEXT_SIZE),
            _ => FontId::monospace(11.0),
        };
        cell(ui, column_of(rect, &COLUMNS, index), text, font, color);
    }
    let shown = account.readings.first().map(|reading| Command::Show(reading.node.clone()));
    let is_clicked = response.clicked();
    response.on_hover_ui(|ui| in_full(ui, session, account, why));
    shown.filter(|_| is_clicked)
}

/// Marks a light that reaches the pixel by a dot as strong as the light is there.
fn mark(ui: &Ui, rect: eframe::egui::Rect, account: &LightAccount, is_lit: bool) {
    let at = pos2(rect.left() + 4.0, rect.center().y);
    if !is_lit {
        ui.painter().circle_stroke(at, 2.5, Stroke::new(1.0, theme::of(ui).dim));
        return;
    }
    let strength = (account.energy as f32).clamp(0.25, 1.0);
    let color: Color32 = theme::SUN;
    ui.painter().circle_filled(at, 3.0, color.gamma_multiply(strength));
}

fn summary(readings: &[LightReading]) -> String {
    let text = |reading: &LightReading| {
        format!("{} {}", tr_in("node", &reading.label), number_text(reading.value, 3))
    };
    readings.iter().map(text).collect::<Vec<_>>().join(" · ")
}

/// Shows all that is known of a light at the pixel.
fn in_full(ui: &mut Ui, session: &Session, account: &LightAccount, why: &str) {
    ui.label(eframe::egui::RichText::new(&account.name).strong());
    ui.label(why);
    if let Some(distance) = account.distance {
        ui.label(tr!("{distance} scene units away", distance = number_text(distance, 3)));
    }
    for reading in &account.readings {
        let name = session.look_with_library().title_of_path(&reading.node);
        ui.label(tr!(
            "{label} of {name}: {value}",
            label = tr_in("node", &reading.label),
            value = number_text(reading.value, 6)
        ));
    }
}
