//! Table of all commands that people ask for by name: label, help, keys, and the place where the
//! keys work. Keys, menus, the sheet of shortcuts and the command palette list this table.

mod graph;
mod label;
mod languages;
mod painting;
mod picture;
mod timeline;
mod window;

use std::sync::LazyLock;

use chiaro_locale::{Text, text, tr};
use eframe::egui;
use eframe::egui::{Key, Modifiers};

use super::{Command, GraphCommand as G, keyboard};
pub(crate) use label::RowLabel;

/// Place where a key works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyScope {
    /// Everywhere.
    Window,
    /// Over the graph, while no text is typed.
    Graph,
    /// Over the picture.
    Picture,
    /// Over the picture while light is painted on it, beside the other keys there.
    Light,
    /// Over the tile that is painted on.
    Painting,
}

impl KeyScope {
    /// True if keys of this place work while the pointer is over `pointed`.
    fn works_over(self, pointed: Self) -> bool {
        self == pointed || (self, pointed) == (Self::Picture, Self::Light)
    }

    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Window => tr!("Everywhere"),
            Self::Graph => tr!("In the graph"),
            Self::Picture => tr!("In the picture"),
            Self::Light => tr!("In the picture, painting light"),
            Self::Painting => tr!("On the tile that is painted"),
        }
    }
}

/// Menu of the bar above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Menu {
    Paint,
    Export,
    CopyAs,
    Help,
}

/// Row of the table.
#[derive(Clone, Debug)]
pub(crate) struct CommandRow {
    pub(crate) command: Command,
    pub(crate) label: RowLabel,
    /// Explanation of the command, where the label does not give one.
    help: Option<Text>,
    /// Keys of the command, any of which will do; the first is shown.
    pub(crate) keys: &'static [(Modifiers, Key)],
    pub(crate) place: KeyScope,
    /// Menu that lists the command.
    pub(crate) menu: Option<Menu>,
    /// True if the command is about the HCBTF that is open to be painted.
    pub(crate) needs_painting: bool,
}

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;
const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };

/// All rows. A row whose key has more modifiers stands before one with fewer, as the first that
/// fits takes a key.
static ROWS: LazyLock<Vec<CommandRow>> = LazyLock::new(|| {
    let mut rows = window::files();
    rows.extend(languages::rows());
    rows.extend(window::rows());
    rows.extend(window::languages());
    rows.extend(picture::rows());
    rows.extend(painting::rows());
    rows.extend(graph::rows());
    rows.extend(timeline::rows());
    rows
});

/// All rows, in the order of lists.
pub(crate) fn rows() -> impl Iterator<Item = &'static CommandRow> {
    ROWS.iter()
}

/// The row of a command.
pub(crate) fn row_of(command: &Command) -> Option<&'static CommandRow> {
    rows().find(|row| row.command == *command)
}

/// Explanation of a command, with its key, for a tooltip.
pub(crate) fn help_of(command: &Command) -> String {
    row_of(command).map(CommandRow::help_with_key).unwrap_or_default()
}

fn row(
    command: Command,
    label: impl Into<RowLabel>,
    keys: &'static [(Modifiers, Key)],
    place: KeyScope,
) -> CommandRow {
    let label = label.into();
    CommandRow { command, label, help: None, keys, place, menu: None, needs_painting: false }
}

impl CommandRow {
    fn help(self, help: Text) -> Self {
        Self { help: Some(help), ..self }
    }

    fn in_menu(self, menu: Menu) -> Self {
        Self { menu: Some(menu), ..self }
    }

    fn needing_painting(self) -> Self {
        Self { needs_painting: true, ..self }
    }

    /// True if a key does something else at the place that the pointer is over.
    fn is_taken_elsewhere(&self, ctx: &egui::Context, key: (Modifiers, Key)) -> bool {
        let Some(pointed) = keyboard::pointed(ctx) else { return false };
        !self.place.works_over(pointed)
            && rows().any(|other| other.place.works_over(pointed) && other.keys.contains(&key))
    }

    /// Takes the row's keys where one of them is pressed. A key that has another meaning at the
    /// place under the pointer is left to that.
    pub(crate) fn take(&self, ui: &egui::Ui) -> bool {
        let mut keys = self.keys.iter();
        keys.any(|&key| !self.is_taken_elsewhere(ui.ctx(), key) && keyboard::take(ui, key))
    }

    /// First key of the row, as people read it.
    pub(crate) fn text(&self) -> String {
        self.keys.first().map_or_else(String::new, |&(modifiers, key)| key_text(modifiers, key))
    }

    /// Explanation of the command, with its key.
    pub(crate) fn help_with_key(&self) -> String {
        let help = self.help.map_or_else(|| self.label.tr(), |help| help.tr().into());
        match self.text() {
            key if key.is_empty() => help.into_owned(),
            key => format!("{help} ({key})"),
        }
    }
}

fn key_text(modifiers: Modifiers, key: Key) -> String {
    let names = [
        (modifiers.command || modifiers.ctrl, tr!("Ctrl+")),
        (modifiers.shift, tr!("Shift+")),
        (modifiers.alt, tr!("Alt+")),
    ];
    let mut text: String =
        names.into_iter().filter(|(is_on, _)| *is_on).map(|(_, name)| name).collect();
    text += match key {
        Key::ArrowLeft => tr!("key" => "Left"),
        Key::ArrowRight => tr!("key" => "Right"),
        Key::ArrowUp => tr!("key" => "Up"),
        Key::ArrowDown => tr!("key" => "Down"),
        Key::Delete => tr!("key" => "Del"),
        Key::Enter => tr!("key" => "Enter"),
        Key::Backspace => tr!("key" => "Backspace"),
        Key::Home => tr!("key" => "Home"),
        Key::OpenBracket => "[",
        Key::CloseBracket => "]",
        Key::Questionmark => "?",
        Key::Period => ".",
        Key::Plus => "+",
        Key::Minus => "-",
        other => other.name(),
    };
    text
}

/// Takes the pressed keys of a place, and returns their commands. Copy, cut and paste come as
/// events of their own, and Tab must be taken earlier than here, before it moves the focus.
pub(crate) fn pressed(ui: &egui::Ui, place: KeyScope) -> Vec<Command> {
    let rows = rows().filter(|row| row.place == place);
    let is_event =
        |command: &Command| matches!(command, Command::Graph(G::Copy | G::Cut | G::Paste));
    let rows = rows.filter(|row| !is_event(&row.command));
    // No key is pressed in most frames.
    if !ui.input(|input| {
        input.events.iter().any(|event| matches!(event, egui::Event::Key { pressed: true, .. }))
    }) {
        return Vec::new();
    }
    rows.filter(|row| row.take(ui)).map(|row| row.command.clone()).collect()
}

/// Actions of the pointer on the graph, for the sheet of shortcuts.
pub(crate) const POINTER: &[(Text, Text)] = &[
    (text!("Double-click on nothing"), text!("Add a node")),
    (text!("Double-click on a title"), text!("Open the group, or rename")),
    (text!("Double-click on a wire"), text!("Add a reroute")),
    (text!("Drag from a socket"), text!("Draw a wire; on nothing: add what fits")),
    (text!("Drag a node onto a wire"), text!("Insert it there")),
    (text!("Alt-drag a node"), text!("Wire it to what it comes near")),
    (text!("Alt-drag on nothing"), text!("Select by a lasso")),
    (text!("Drag on nothing"), text!("Select by a box")),
    (text!("Ctrl+right-drag"), text!("Cut wires")),
    (text!("Alt-click on a wire"), text!("Remove it")),
    (text!("Wheel"), text!("Zoom")),
    (text!("Middle or right drag, Space+drag"), text!("Move the view")),
    (text!("Right-click"), text!("Menu")),
];

/// Keys of the light table, as the sheet of shortcuts lists them; the table takes them where one of
/// its cells has the focus.
pub(crate) const LIGHT_TABLE: &[(Text, Text)] = &[
    (text!("Enter, F2 or typing"), text!("Change all selected cells")),
    (text!("0.5  *1.2  +0.1  50%"), text!("Typed: a value or a change")),
    (text!("Alt+Up, Alt+Down"), text!("Nudge")),
    (text!("K"), text!("Key, or take the key away")),
    (text!("Space"), text!("Turn a switch")),
    (text!("Del"), text!("Reset")),
    (text!("Ctrl+C, Ctrl+V"), text!("Copy and paste cells")),
    (text!("Ctrl+A"), text!("Select more")),
];

/// Actions of the pointer on the tile that is painted, for the sheet of shortcuts.
pub(crate) const PAINTING_POINTER: &[(Text, Text)] = &[
    (text!("Drag"), text!("Paint, with the tool at hand")),
    (text!("Alt-click"), text!("Pick a color")),
    (text!("Shift-click with the stamp"), text!("Take this tile as the stamp")),
    (text!("Hold V"), text!("Look at the sample from before")),
    (text!("Alt over the map or the list"), text!("Look at that sample")),
    (text!("Shift-click on the map"), text!("Copy that sample to the one at work")),
    (text!("Wheel over the palette"), text!("Brighter or darker")),
    (text!("Wheel"), text!("Zoom")),
    (text!("Middle or right drag, Space+drag"), text!("Move the tile")),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export;

    #[test]
    fn no_key_does_two_things_in_one_place() {
        for (index, row) in ROWS.iter().enumerate() {
            for other in &ROWS[index + 1..] {
                let are_over_picture = |place| matches!(place, KeyScope::Picture | KeyScope::Light);
                let is_window = row.place == KeyScope::Window || other.place == KeyScope::Window;
                let meet = row.place == other.place || is_window;
                let meet = meet || are_over_picture(row.place) && are_over_picture(other.place);
                let same = row.keys.iter().any(|key| other.keys.contains(key));
                assert!(!(meet && same), "{:?} and {:?}", row.command, other.command);
                assert_ne!(row.command, other.command);
            }
        }
    }

    #[test]
    fn every_language_can_be_exported_and_all_but_binary_ones_copied() {
        for language in export::LANGUAGES {
            let row = row_of(&Command::ExportLook(language.slug, None))
                .unwrap_or_else(|| panic!("{}", language.slug));
            let label = row.label.english();
            let name =
                language.label.trim_end_matches(|c: char| c.is_ascii_digit() || ".- ".contains(c));
            assert!(
                label.contains(name.split(',').next().unwrap()),
                "{label} for {}",
                language.label
            );
            // The row of a language must not name an API that the language's own note denies.
            let denied = language
                .note
                .split_once("not for ")
                .map(|(_, rest)| rest.split([':', ',']).next().unwrap());
            assert!(denied.is_none_or(|api| !label.contains(api)), "{label}");
            let copies = |row: &CommandRow| {
                let Command::CopyShader(slug, _) = row.command else { return false };
                slug == language.slug
            };
            let is_copied = language.slug == "wgsl" || ROWS.iter().any(copies);
            assert_eq!(is_copied, language.slug != "spirv", "{}", language.slug);
        }
    }

    #[test]
    fn keys_are_told() {
        assert_eq!(row_of(&Command::Graph(G::Ungroup)).unwrap().text(), "Ctrl+Shift+G");
        assert_eq!(row_of(&Command::OpenShortcuts).unwrap().text(), "?");
    }
}
