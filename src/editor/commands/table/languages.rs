//! Rows that copy and export the look: one for each language of exports, for each of its texts, and
//! for each package.

use chiaro_locale::{Text, text};
use eframe::egui::Key;

use super::{CTRL_SHIFT, CommandRow, KeyScope, Menu, RowLabel, row};
use crate::commands::{Command, PanelId};
use crate::export::package::PACKAGES;
use crate::export::{self, TextFile};

pub(super) fn rows() -> impl Iterator<Item = CommandRow> {
    let without_key = |command, label: RowLabel| row(command, label, &[], KeyScope::Window);
    let copies = export::LANGUAGES.into_iter().flat_map(move |language| {
        language.texts.iter().map(move |TextFile { ending, content }| {
            let label = RowLabel::from(copies(content)).with("language", language.short_label);
            without_key(Command::CopyShader(language.slug, ending), label).in_menu(Menu::CopyAs)
        })
    });
    let all = Command::ExportLook(export::ALL, None);
    let all =
        row(all, text!("Export to all languages..."), &[(CTRL_SHIFT, Key::E)], KeyScope::Window);
    let exports = export::LANGUAGES.into_iter().map(move |language| {
        let label = match language.api {
            "" => RowLabel::from(text!("Export to {language}...")),
            api => RowLabel::from(text!("Export to {language}, for {api}...")).with("api", api),
        };
        let label = label.with("language", language.short_label);
        without_key(Command::ExportLook(language.slug, None), label)
    });
    let packages = PACKAGES.iter().copied().map(move |package| {
        let label = RowLabel::from(text!("Export as a package: {package}..."));
        let label = label.with("package", package.label.tr());
        without_key(Command::ExportLook(package.slug, None), label)
    });
    let cards = Command::ShowPanel(PanelId::EXPORT);
    let cards = without_key(cards, text!("Export to a program or a page").into());
    let exports = [cards, all].into_iter().chain(exports);
    // The menu leads to the cards, which tell what each package is.
    copies.chain(exports.map(|row| row.in_menu(Menu::Export))).chain(packages)
}

/// Label of copying a text file of a look.
fn copies(content: &str) -> Text {
    match content {
        "fragment shader" => text!("Copy the fragment shader as {language}"),
        "vertex shader" => text!("Copy the vertex shader as {language}"),
        _ => text!("Copy the shader as {language}"),
    }
}
