//! Every key of the window in one table: what it does, what it is called, where it works. The
//! canvas takes its keys from here, and the sheet of shortcuts, menus and the command palette list
//! what is here.

use std::borrow::Cow;
use std::sync::LazyLock;

use eframe::egui;
use eframe::egui::{Key, Modifiers};

use crate::export::{self, TextFile};
use crate::hcbtf::exchange::Form;
use crate::painter::{Kind, Preset};
use crate::tools::fitting;

/// Where a key works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Everywhere.
    Window,
    /// Over the graph, while no text is typed.
    Graph,
    /// Over the picture.
    Picture,
    /// Over the picture while light is painted on it, beside the others there.
    Light,
    /// Over the tile that is painted on.
    Painting,
}

impl Place {
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Window => "Everywhere",
            Self::Graph => "In the graph",
            Self::Picture => "In the picture",
            Self::Light => "In the picture, painting light",
            Self::Painting => "On the tile that is painted",
        }
    }
}

/// Something that a key, a menu or the command palette asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Action {
    New,
    Open,
    Save,
    SaveAs,
    Undo,
    Redo,
    Probe,
    OpenPath,
    Start,
    Tour,
    CopyPicture,
    CopyWgsl,
    /// In a language, of its files the one with this ending.
    CopyShader(&'static str, &'static str),
    /// To a language, or to all of them.
    Export(&'static str),
    ExportPicture,
    ResetView,
    FrameObject,
    FrameAll,
    Projection,
    Turntable,
    Handles,
    Commands,
    Shortcuts,
    AddNode,
    Swap,
    Delete,
    Dissolve,
    Duplicate,
    Copy,
    Cut,
    Paste,
    SelectAll,
    SelectNone,
    Invert,
    Upstream,
    Downstream,
    Rename,
    Mute,
    Collapse,
    Connect,
    Group,
    Ungroup,
    OpenGroup,
    LeaveGroup,
    ShareGroup,
    Frame,
    Unframe,
    Note,
    ShowAll,
    ShowSelected,
    AlignLeft,
    AlignRight,
    AlignTop,
    AlignBottom,
    DistributeAcross,
    DistributeDown,
    Layout,
    SnapGrid,
    Minimap,
    Nudge(Way),
    SelectNext(Way),
    GoTo(u8),
    Remember(u8),
    Paint,
    PaintShown,
    NewHcbtf(Preset),
    NewHcbtfOf,
    GridOfHcbtf,
    TileOfHcbtf,
    BakeLook,
    SaveHcbtf,
    SaveHcbtfAs,
    CloseHcbtf,
    ImportHcbtf,
    ExportHcbtf(Form),
    Tool(Kind),
    Brush {
        is_larger: bool,
    },
    SwapColors,
    Flat,
    Copies,
    Arrows,
    FitTile,
    StepView(Way),
    StepLight(Way),
    PaintLight,
    FitLook,
    LightTool(fitting::Kind),
    LightBrush {
        is_larger: bool,
    },
}

/// A way on the canvas.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Way {
    Left,
    Right,
    Up,
    Down,
}

impl Way {
    /// One step.
    pub(crate) fn step(self) -> egui::Vec2 {
        match self {
            Self::Left => egui::vec2(-1.0, 0.0),
            Self::Right => egui::vec2(1.0, 0.0),
            Self::Up => egui::vec2(0.0, -1.0),
            Self::Down => egui::vec2(0.0, 1.0),
        }
    }
}

/// A row of the table.
#[derive(Clone)]
pub(crate) struct Shortcut {
    pub(crate) action: Action,
    pub(crate) label: Cow<'static, str>,
    /// Any of them will do; the first is told.
    pub(crate) keys: &'static [(Modifiers, Key)],
    pub(crate) place: Place,
}

const fn row(
    action: Action,
    label: &'static str,
    keys: &'static [(Modifiers, Key)],
    place: Place,
) -> Shortcut {
    Shortcut { action, label: Cow::Borrowed(label), keys, place }
}

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;
const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };

use Action as A;
use Place::{Graph, Painting, Window};
use Way::{Down, Left, Right, Up};

/// All of them. What needs more modifiers stands before what needs fewer, as the first that fits
/// takes a key.
pub(crate) static ALL: LazyLock<Vec<Shortcut>> = LazyLock::new(|| {
    let fixed = |rows: &'static [Shortcut]| rows.iter().cloned();
    fixed(BEFORE_LANGUAGES).chain(language_rows()).chain(fixed(AFTER_LANGUAGES)).collect()
});

/// What copies and exports the look in each language.
fn language_rows() -> impl Iterator<Item = Shortcut> {
    let without_key =
        |action, label| Shortcut { action, label: Cow::Owned(label), keys: &[], place: Window };
    let copies = export::LANGUAGES.into_iter().flat_map(move |language| {
        language.texts.iter().map(move |TextFile { ending, content }| {
            let label = format!("Copy the {content} as {}", language.short_label);
            without_key(A::CopyShader(language.slug, ending), label)
        })
    });
    let all =
        row(A::Export(export::ALL), "Export to all languages...", &[(CTRL_SHIFT, Key::E)], Window);
    let exports = export::LANGUAGES.into_iter().map(move |language| {
        let api =
            if language.api.is_empty() { String::new() } else { format!(", for {}", language.api) };
        without_key(A::Export(language.slug), format!("Export to {}{api}...", language.short_label))
    });
    copies.chain([all]).chain(exports)
}

/// The rows that stand before those of the languages.
#[rustfmt::skip]
static BEFORE_LANGUAGES: &[Shortcut] = &[
    row(A::New, "New look", &[(CTRL, Key::N)], Window),
    row(A::Open, "Open a look", &[(CTRL, Key::O)], Window),
    row(A::SaveAs, "Save under another name", &[(CTRL_SHIFT, Key::S)], Window),
    row(A::Save, "Save", &[(CTRL, Key::S)], Window),
    row(A::Redo, "Redo", &[(CTRL_SHIFT, Key::Z), (CTRL, Key::Y)], Window),
    row(A::Undo, "Undo", &[(CTRL, Key::Z)], Window),
    row(A::OpenPath, "Open a file by its path", &[(CTRL_SHIFT, Key::O)], Window),
    row(A::Start, "Start page", &[(ALT, Key::Home)], Window),
    row(A::Tour, "Take the tour", &[], Window),
    row(A::CopyPicture, "Copy the picture as an image", &[(CTRL_SHIFT, Key::I)], Window),
    row(A::CopyWgsl, "Copy the shader as WGSL", &[(CTRL_SHIFT, Key::W)], Window),
];

/// The rows that follow those of the languages.
#[rustfmt::skip]
static AFTER_LANGUAGES: &[Shortcut] = &[
    row(A::ExportPicture, "Export the picture as PNG...", &[], Window),
    row(A::Commands, "Find a command or a node", &[(CTRL, Key::P), (CTRL, Key::F)], Window),
    row(A::Shortcuts, "Show all shortcuts", &[(NONE, Key::Questionmark), (SHIFT, Key::Questionmark), (NONE, Key::F1)], Window),
    row(A::PaintLight, "Paint light on the picture", &[(NONE, Key::L)], Place::Picture),
    row(A::Paint, "Paint a surface (HCBTF)", &[], Window),
    row(A::PaintShown, "Paint what the look shows", &[], Window),
    row(A::NewHcbtf(Preset::Small), "New HCBTF, small (16 x 16, 3 x 6 directions)", &[], Window),
    row(A::NewHcbtf(Preset::Thesis), "New HCBTF, as the thesis (32 x 32, 6 x 10 directions)", &[], Window),
    row(A::NewHcbtf(Preset::Large), "New HCBTF, large (64 x 64, 6 x 10 directions)", &[], Window),
    row(A::NewHcbtf(Preset::Fine), "New HCBTF, fine tile (128 x 128, 3 x 8 directions)", &[], Window),
    row(A::NewHcbtfOf, "New HCBTF of any grid...", &[], Window),
    row(A::GridOfHcbtf, "Divide the HCBTF otherwise...", &[], Window),
    row(A::TileOfHcbtf, "New tile from this painting...", &[], Window),
    row(A::BakeLook, "Bake this look onto a tile...", &[], Window),
    row(A::SaveHcbtf, "Save the HCBTF", &[], Window),
    row(A::SaveHcbtfAs, "Save the HCBTF under another name...", &[], Window),
    row(A::CloseHcbtf, "Close the HCBTF", &[], Window),
    row(A::ImportHcbtf, "Import painted pictures as an HCBTF...", &[], Window),
    row(A::ExportHcbtf(Form::Folder), "Export the HCBTF as a folder of images...", &[], Window),
    row(A::ExportHcbtf(Form::Contact), "Export the HCBTF as a contact sheet...", &[], Window),
    row(A::ExportHcbtf(Form::Sheet), "Export the HCBTF as a sheet of the thesis...", &[], Window),
    row(A::ExportHcbtf(Form::Ktx2), "Export the HCBTF as a KTX2 texture...", &[], Window),
    row(A::Probe, "Probe a pixel", &[(NONE, Key::I)], Place::Picture),
    row(A::ResetView, "Reset camera and lights", &[(NONE, Key::R)], Place::Picture),
    row(A::FrameObject, "Frame the object", &[(NONE, Key::F)], Place::Picture),
    row(A::FrameAll, "Frame all objects", &[(NONE, Key::A)], Place::Picture),
    row(A::Projection, "Perspective or parallel", &[(NONE, Key::P)], Place::Picture),
    row(A::Turntable, "Start or stop the turntable", &[(NONE, Key::T)], Place::Picture),
    row(A::Handles, "Show or hide handles on the object", &[(NONE, Key::H)], Place::Picture),
    row(A::FitLook, "Fit this look to the painted light", &[(CTRL, Key::Enter)], Place::Light),
    row(A::LightTool(fitting::Kind::Light), "Paint where it should be lighter", &[(NONE, Key::B)], Place::Light),
    row(A::LightTool(fitting::Kind::Dark), "Paint where it should be darker", &[(NONE, Key::D)], Place::Light),
    row(A::LightTool(fitting::Kind::Color), "Paint a color that it should have", &[(NONE, Key::C)], Place::Light),
    row(A::LightTool(fitting::Kind::Keep), "Paint what should stay", &[(NONE, Key::K)], Place::Light),
    row(A::LightTool(fitting::Kind::Erase), "Erase painted light", &[(NONE, Key::E)], Place::Light),
    row(A::LightBrush { is_larger: false }, "Smaller brush of light", &[(NONE, Key::OpenBracket)], Place::Light),
    row(A::LightBrush { is_larger: true }, "Larger brush of light", &[(NONE, Key::CloseBracket)], Place::Light),
    row(A::Tool(Kind::Paint), "Brush", &[(NONE, Key::B)], Painting),
    row(A::Tool(Kind::Erase), "Eraser", &[(NONE, Key::E)], Painting),
    row(A::Tool(Kind::Smudge), "Smudge", &[(NONE, Key::S)], Painting),
    row(A::Tool(Kind::Line), "Line", &[(NONE, Key::L)], Painting),
    row(A::Tool(Kind::Fill), "Fill", &[(NONE, Key::G)], Painting),
    row(A::Tool(Kind::Stamp), "Stamp", &[(NONE, Key::K)], Painting),
    row(A::Tool(Kind::Pick), "Pick a color", &[(NONE, Key::I)], Painting),
    row(A::Brush { is_larger: false }, "Smaller brush", &[(NONE, Key::OpenBracket)], Painting),
    row(A::Brush { is_larger: true }, "Larger brush", &[(NONE, Key::CloseBracket)], Painting),
    row(A::SwapColors, "Swap the two colors", &[(NONE, Key::X)], Painting),
    row(A::Flat, "Tilted as the eye sees it, or flat", &[(NONE, Key::F)], Painting),
    row(A::Copies, "Show or hide copies around the tile", &[(NONE, Key::C)], Painting),
    row(A::Arrows, "Show or hide the arrows of light and eye", &[(NONE, Key::A)], Painting),
    row(A::FitTile, "Show the whole tile", &[(NONE, Key::Home)], Painting),
    row(A::StepLight(Left), "Light to the left", &[(SHIFT, Key::ArrowLeft)], Painting),
    row(A::StepLight(Right), "Light to the right", &[(SHIFT, Key::ArrowRight)], Painting),
    row(A::StepLight(Up), "Light higher", &[(SHIFT, Key::ArrowUp)], Painting),
    row(A::StepLight(Down), "Light lower", &[(SHIFT, Key::ArrowDown)], Painting),
    row(A::StepView(Left), "Eye to the left", &[(NONE, Key::ArrowLeft)], Painting),
    row(A::StepView(Right), "Eye to the right", &[(NONE, Key::ArrowRight)], Painting),
    row(A::StepView(Up), "Eye higher", &[(NONE, Key::ArrowUp)], Painting),
    row(A::StepView(Down), "Eye lower", &[(NONE, Key::ArrowDown)], Painting),
    row(A::AddNode, "Add a node", &[(NONE, Key::Tab), (NONE, Key::A), (SHIFT, Key::A)], Graph),
    row(A::Swap, "Swap the node for another", &[(NONE, Key::S)], Graph),
    row(A::Dissolve, "Delete, keep the wires through", &[(SHIFT, Key::Delete), (SHIFT, Key::X)], Graph),
    row(A::Delete, "Delete", &[(NONE, Key::Delete), (NONE, Key::Backspace), (NONE, Key::X)], Graph),
    row(A::Duplicate, "Duplicate", &[(CTRL, Key::D), (SHIFT, Key::D)], Graph),
    row(A::Copy, "Copy the selected nodes as text", &[(CTRL, Key::C)], Graph),
    row(A::Cut, "Cut", &[(CTRL, Key::X)], Graph),
    row(A::Paste, "Paste", &[(CTRL, Key::V)], Graph),
    row(A::SelectAll, "Select all", &[(CTRL, Key::A)], Graph),
    row(A::SelectNone, "Select nothing", &[(CTRL_SHIFT, Key::A)], Graph),
    row(A::Invert, "Invert the selection", &[(CTRL, Key::I)], Graph),
    row(A::Upstream, "Select what leads here", &[(NONE, Key::OpenBracket)], Graph),
    row(A::Downstream, "Select what this leads to", &[(NONE, Key::CloseBracket)], Graph),
    row(A::Rename, "Rename", &[(NONE, Key::F2)], Graph),
    row(A::Mute, "Mute or unmute", &[(NONE, Key::M)], Graph),
    row(A::Collapse, "Collapse or expand", &[(NONE, Key::H)], Graph),
    row(A::Ungroup, "Dissolve the group", &[(CTRL_SHIFT, Key::G)], Graph),
    row(A::Group, "Make a group", &[(CTRL, Key::G)], Graph),
    row(A::OpenGroup, "Open the group", &[(CTRL, Key::Enter)], Graph),
    row(A::LeaveGroup, "Leave the group", &[(NONE, Key::U), (CTRL, Key::Backspace)], Graph),
    row(A::ShareGroup, "Share the group with the project", &[], Graph),
    row(A::Unframe, "Take out of the frame", &[(CTRL_SHIFT, Key::J), (ALT, Key::P)], Graph),
    row(A::Frame, "Put a frame around", &[(CTRL, Key::J)], Graph),
    row(A::Note, "Add a note", &[(NONE, Key::N)], Graph),
    row(A::Connect, "Wire the selected nodes, else show all", &[(NONE, Key::F)], Graph),
    row(A::ShowAll, "Show all", &[(NONE, Key::Home)], Graph),
    row(A::ShowSelected, "Show what is selected", &[(NONE, Key::Period)], Graph),
    row(A::AlignLeft, "Align left edges", &[(SHIFT, Key::ArrowLeft)], Graph),
    row(A::AlignRight, "Align right edges", &[(SHIFT, Key::ArrowRight)], Graph),
    row(A::AlignTop, "Align tops", &[(SHIFT, Key::ArrowUp)], Graph),
    row(A::AlignBottom, "Align bottoms", &[(SHIFT, Key::ArrowDown)], Graph),
    row(A::DistributeAcross, "Space out evenly across", &[(SHIFT, Key::H)], Graph),
    row(A::DistributeDown, "Space out evenly downward", &[(SHIFT, Key::V)], Graph),
    row(A::Layout, "Tidy up", &[(NONE, Key::L)], Graph),
    row(A::SnapGrid, "Snap to the grid, or not", &[(NONE, Key::G)], Graph),
    row(A::Minimap, "Show or hide the minimap", &[(SHIFT, Key::M)], Graph),
    row(A::SelectNext(Left), "Select the next node to the left", &[(CTRL, Key::ArrowLeft)], Graph),
    row(A::SelectNext(Right), "Select the next node to the right", &[(CTRL, Key::ArrowRight)], Graph),
    row(A::SelectNext(Up), "Select the next node above", &[(CTRL, Key::ArrowUp)], Graph),
    row(A::SelectNext(Down), "Select the next node below", &[(CTRL, Key::ArrowDown)], Graph),
    row(A::Nudge(Left), "Move left, or select", &[(NONE, Key::ArrowLeft)], Graph),
    row(A::Nudge(Right), "Move right, or select", &[(NONE, Key::ArrowRight)], Graph),
    row(A::Nudge(Up), "Move up, or select", &[(NONE, Key::ArrowUp)], Graph),
    row(A::Nudge(Down), "Move down, or select", &[(NONE, Key::ArrowDown)], Graph),
    row(A::Remember(1), "Bookmark this view as 1", &[(CTRL, Key::Num1)], Graph),
    row(A::Remember(2), "Bookmark this view as 2", &[(CTRL, Key::Num2)], Graph),
    row(A::Remember(3), "Bookmark this view as 3", &[(CTRL, Key::Num3)], Graph),
    row(A::Remember(4), "Bookmark this view as 4", &[(CTRL, Key::Num4)], Graph),
    row(A::Remember(5), "Bookmark this view as 5", &[(CTRL, Key::Num5)], Graph),
    row(A::Remember(6), "Bookmark this view as 6", &[(CTRL, Key::Num6)], Graph),
    row(A::Remember(7), "Bookmark this view as 7", &[(CTRL, Key::Num7)], Graph),
    row(A::Remember(8), "Bookmark this view as 8", &[(CTRL, Key::Num8)], Graph),
    row(A::Remember(9), "Bookmark this view as 9", &[(CTRL, Key::Num9)], Graph),
    row(A::GoTo(1), "Go to bookmark 1", &[(NONE, Key::Num1)], Graph),
    row(A::GoTo(2), "Go to bookmark 2", &[(NONE, Key::Num2)], Graph),
    row(A::GoTo(3), "Go to bookmark 3", &[(NONE, Key::Num3)], Graph),
    row(A::GoTo(4), "Go to bookmark 4", &[(NONE, Key::Num4)], Graph),
    row(A::GoTo(5), "Go to bookmark 5", &[(NONE, Key::Num5)], Graph),
    row(A::GoTo(6), "Go to bookmark 6", &[(NONE, Key::Num6)], Graph),
    row(A::GoTo(7), "Go to bookmark 7", &[(NONE, Key::Num7)], Graph),
    row(A::GoTo(8), "Go to bookmark 8", &[(NONE, Key::Num8)], Graph),
    row(A::GoTo(9), "Go to bookmark 9", &[(NONE, Key::Num9)], Graph),
];

/// What the pointer does on the graph, for the sheet of shortcuts.
pub(crate) const POINTER: &[(&str, &str)] = &[
    ("Double-click on nothing", "Add a node"),
    ("Double-click on a title", "Open the group, or rename"),
    ("Double-click on a wire", "Add a reroute"),
    ("Drag from a socket", "Draw a wire; on nothing: add what fits"),
    ("Drag a node onto a wire", "Insert it there"),
    ("Alt-drag a node", "Wire it to what it comes near"),
    ("Alt-drag on nothing", "Select by a lasso"),
    ("Drag on nothing", "Select by a box"),
    ("Ctrl+right-drag", "Cut wires"),
    ("Alt-click on a wire", "Remove it"),
    ("Wheel", "Zoom"),
    ("Middle or right drag, Space+drag", "Move the view"),
    ("Right-click", "Menu"),
];

/// The same on the tile that is painted.
pub(crate) const PAINTING_POINTER: &[(&str, &str)] = &[
    ("Drag", "Paint, with the tool at hand"),
    ("Alt-click", "Pick a color"),
    ("Shift-click with the stamp", "Take this tile as the stamp"),
    ("Hold V", "Look at the sample from before"),
    ("Alt over the map or the list", "Look at that sample"),
    ("Shift-click on the map", "Copy that sample to the one at work"),
    ("Wheel over the palette", "Brighter or darker"),
    ("Wheel", "Zoom"),
    ("Middle or right drag, Space+drag", "Move the tile"),
];

impl Shortcut {
    /// The key as people read it.
    pub(crate) fn text(&self) -> String {
        self.keys.first().map_or_else(String::new, |&(modifiers, key)| key_text(modifiers, key))
    }
}

fn key_text(modifiers: Modifiers, key: Key) -> String {
    let names = [
        (modifiers.command || modifiers.ctrl, "Ctrl+"),
        (modifiers.shift, "Shift+"),
        (modifiers.alt, "Alt+"),
    ];
    let mut text: String =
        names.into_iter().filter(|(is_on, _)| *is_on).map(|(_, name)| name).collect();
    text += match key {
        Key::ArrowLeft => "Left",
        Key::ArrowRight => "Right",
        Key::ArrowUp => "Up",
        Key::ArrowDown => "Down",
        Key::Delete => "Del",
        Key::OpenBracket => "[",
        Key::CloseBracket => "]",
        Key::Questionmark => "?",
        Key::Period => ".",
        other => other.name(),
    };
    text
}

/// The row of an action.
pub(crate) fn of(action: Action) -> Option<&'static Shortcut> {
    ALL.iter().find(|row| row.action == action)
}

/// Takes the keys of a place that were pressed. Copy, cut and paste come as events of their own,
/// and Tab must be taken earlier than here, before it moves the focus.
pub(crate) fn pressed(ui: &egui::Ui, place: Place) -> Vec<Action> {
    let rows = ALL.iter().filter(|row| row.place == place);
    let rows = rows.filter(|row| !matches!(row.action, A::Copy | A::Cut | A::Paste));
    // Nothing is pressed in most frames.
    if !ui.input(|input| {
        input.events.iter().any(|event| matches!(event, egui::Event::Key { pressed: true, .. }))
    }) {
        return Vec::new();
    }
    rows.filter(|row| row.keys.iter().any(|&key| take(ui, key))).map(|row| row.action).collect()
}

/// Whose the keys of a frame are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum KeyboardOwner {
    /// The window's, and whatever lies under the pointer.
    #[default]
    Window,
    /// A text field's; keys of [`Place::Window`] still work.
    Field,
    /// A dialog's, all of them.
    Dialog,
}

fn owner_id() -> egui::Id {
    egui::Id::unique("owner of the keyboard")
}

/// Remembers whose the keys of this frame are; to be called before anything of it is shown. A field
/// or a dialog that one of these keys closes would leave the others, typed as fast, to whatever
/// lies below.
pub(crate) fn begin_frame(ctx: &egui::Context) {
    let owner = if ctx.memory(|memory| memory.top_modal_layer().is_some()) {
        KeyboardOwner::Dialog
    } else if ctx.egui_wants_keyboard_input() {
        KeyboardOwner::Field
    } else {
        KeyboardOwner::Window
    };
    ctx.data_mut(|data| data.insert_temp(owner_id(), owner));
}

fn owner(ctx: &egui::Context) -> KeyboardOwner {
    ctx.data(|data| data.get_temp(owner_id())).unwrap_or_default()
}

/// Whether the keys are those of a text field or a dialog, now or when the frame began.
pub(crate) fn is_keyboard_taken(ctx: &egui::Context) -> bool {
    owner(ctx) != KeyboardOwner::Window || ctx.egui_wants_keyboard_input()
}

/// Whether all keys are those of a dialog.
pub(crate) fn is_dialog_open(ctx: &egui::Context) -> bool {
    owner(ctx) == KeyboardOwner::Dialog
}

/// Takes a key with just these modifiers, which egui's own way would not ask for: to it Shift+D is
/// D too.
pub(crate) fn take(ui: &egui::Ui, (wanted, wanted_key): (Modifiers, Key)) -> bool {
    ui.input_mut(|input| {
        let count = input.events.len();
        input.events.retain(|event| match event {
            egui::Event::Key { key, modifiers, pressed: true, .. } => {
                *key != wanted_key || !modifiers.matches_exact(wanted)
            }
            _ => true,
        });
        input.events.len() < count
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_does_two_things_in_one_place() {
        for (index, row) in ALL.iter().enumerate() {
            for other in &ALL[index + 1..] {
                let are_over_picture = |place| matches!(place, Place::Picture | Place::Light);
                let meet = row.place == other.place || row.place == Window || other.place == Window;
                let meet = meet || are_over_picture(row.place) && are_over_picture(other.place);
                let same = row.keys.iter().any(|key| other.keys.contains(key));
                assert!(!(meet && same), "{:?} and {:?}", row.action, other.action);
                assert_ne!(row.action, other.action);
            }
        }
    }

    #[test]
    fn every_language_can_be_exported_and_all_but_binary_ones_copied() {
        for language in export::LANGUAGES {
            let row = of(A::Export(language.slug)).unwrap_or_else(|| panic!("{}", language.slug));
            let name =
                language.label.trim_end_matches(|c: char| c.is_ascii_digit() || ".- ".contains(c));
            assert!(
                row.label.contains(name.split(',').next().unwrap()),
                "{} for {}",
                row.label,
                language.label
            );
            // A row says of no API that the language's own note denies it.
            let denied = language
                .note
                .split_once("not for ")
                .map(|(_, rest)| rest.split([':', ',']).next().unwrap());
            assert!(denied.is_none_or(|api| !row.label.contains(api)), "{}", row.label);
            let copies = |row: &Shortcut| matches!(row.action, A::CopyShader(slug, _) if slug == language.slug);
            let is_copied = language.slug == "wgsl" || ALL.iter().any(copies);
            assert_eq!(is_copied, language.slug != "spirv", "{}", language.slug);
        }
    }

    #[test]
    fn keys_are_told() {
        assert_eq!(of(A::Ungroup).unwrap().text(), "Ctrl+Shift+G");
        assert_eq!(of(A::Shortcuts).unwrap().text(), "?");
    }
}
