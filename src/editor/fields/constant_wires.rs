//! Note in menus of wires about those that never change, which cannot usefully drive keys.

use chiaro_locale::{tr, trn};
use eframe::egui::{Label, RichText, Sense, Ui};

use crate::document::Driver;
use crate::state::session::Session;
use crate::widgets::theme;

/// Largest number of wires that are named.
const NAMED: usize = 12;

/// Shows the number of wires that are left out, with the reason and their names in a tooltip.
pub(crate) fn note(ui: &mut Ui, session: &Session, constant: &[Driver]) {
    if constant.is_empty() {
        return;
    }
    let text =
        trn!(count = constant.len(), "{count} wire never changes", "{count} wires never change");
    let mut names: Vec<String> =
        constant.iter().take(NAMED).map(|driver| session.keys().driver_name(driver)).collect();
    if constant.len() > NAMED {
        names.push(tr!("and {count} more", count = constant.len() - NAMED));
    }
    let help = tr!(
        "Left out, for keys by them would stand still:\n{names}\nExpose what they come from, key \
         it in time, or wire a light or the time to it, and they are offered here.",
        names = names.join("\n")
    );
    let text = RichText::new(text).small().color(theme::of(ui).dim);
    ui.add(Label::new(text).sense(Sense::hover())).on_hover_text(help);
}
