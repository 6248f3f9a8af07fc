//! Rows that copy and export the look: one for each language of exports, for each of its texts, and
//! for each package.

use eframe::egui::Key;

use super::{CTRL_SHIFT, CommandRow, KeyScope, Menu, row};
use crate::commands::{Command, PanelId};
use crate::export::package::PACKAGES;
use crate::export::{self, TextFile};

pub(super) fn rows() -> impl Iterator<Item = CommandRow> {
    let without_key = |command, label: String| row(command, label, &[], KeyScope::Window);
    let copies = export::LANGUAGES.into_iter().flat_map(move |language| {
        language.texts.iter().map(move |TextFile { ending, content }| {
            let label = format!("Copy the {content} as {}", language.short_label);
            without_key(Command::CopyShader(language.slug, ending), label).in_menu(Menu::CopyAs)
        })
    });
    let all = Command::ExportLook(export::ALL, None);
    let all = row(all, "Export to all languages...", &[(CTRL_SHIFT, Key::E)], KeyScope::Window);
    let exports = export::LANGUAGES.into_iter().map(move |language| {
        let api =
            if language.api.is_empty() { String::new() } else { format!(", for {}", language.api) };
        let label = format!("Export to {}{api}...", language.short_label);
        without_key(Command::ExportLook(language.slug, None), label)
    });
    let packages = PACKAGES.iter().copied().map(move |package| {
        let label = format!("Export as a package: {}...", package.label);
        without_key(Command::ExportLook(package.slug, None), label)
    });
    let cards = Command::ShowPanel(PanelId::EXPORT);
    let cards = without_key(cards, "Export to a program or a page".to_owned());
    let exports = [cards, all].into_iter().chain(exports);
    // The menu leads to the cards, which tell what each package is.
    copies.chain(exports.map(|row| row.in_menu(Menu::Export))).chain(packages)
}
