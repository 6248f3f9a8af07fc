//! Rows that copy and export the look: one for each language of exports, and for each of its texts.

use eframe::egui::Key;

use super::{CTRL_SHIFT, CommandRow, KeyScope, Menu, row};
use crate::commands::Command;
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
    copies.chain([all].into_iter().chain(exports).map(|row| row.in_menu(Menu::Export)))
}
