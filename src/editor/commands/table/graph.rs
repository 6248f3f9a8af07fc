//! Rows of commands that work over the graph, while no text is typed.

use chiaro_locale::{Text, text};
use eframe::egui::{Key, Modifiers};

use super::KeyScope::Graph;
use super::{ALT, CTRL, CTRL_SHIFT, CommandRow, Menu, NONE, RowLabel, SHIFT, row};
use crate::commands::Heading::{Down, Left, Right, Up};
use crate::commands::{Command as C, GraphCommand as G};

/// Digit of a bookmark, as labels tell it, and its keys.
type Bookmark = (u8, &'static str, [(Modifiers, Key); 2]);

/// Bookmarks, in the order of their keys.
static DIGITS: [Bookmark; 9] = {
    const fn keys(key: Key) -> [(Modifiers, Key); 2] {
        [(CTRL, key), (NONE, key)]
    }
    [
        (1, "1", keys(Key::Num1)),
        (2, "2", keys(Key::Num2)),
        (3, "3", keys(Key::Num3)),
        (4, "4", keys(Key::Num4)),
        (5, "5", keys(Key::Num5)),
        (6, "6", keys(Key::Num6)),
        (7, "7", keys(Key::Num7)),
        (8, "8", keys(Key::Num8)),
        (9, "9", keys(Key::Num9)),
    ]
};

fn graph(command: G, label: impl Into<RowLabel>, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::Graph(command), label, keys, Graph)
}

pub(super) fn rows() -> Vec<CommandRow> {
    let mut rows = edits();
    rows.extend(groups());
    rows.extend(arrangement());
    rows.extend(steps());
    let numbered = |text: Text, digit| RowLabel::from(text).with("digit", digit);
    rows.extend(DIGITS.iter().map(|(number, digit, keys)| {
        let label = numbered(text!("Bookmark this view as {digit}"), digit);
        graph(G::Remember(*number), label, &keys[..1])
    }));
    rows.extend(DIGITS.iter().map(|(number, digit, keys)| {
        let label = numbered(text!("Go to bookmark {digit}"), digit);
        graph(G::GoTo(*number), label, &keys[1..])
    }));
    rows
}

/// Rows that add, remove and select nodes.
fn edits() -> Vec<CommandRow> {
    vec![
        graph(
            G::AddNode,
            text!("Add a node"),
            &[(NONE, Key::Tab), (NONE, Key::A), (SHIFT, Key::A)],
        ),
        graph(G::Swap, text!("Swap the node for another"), &[(NONE, Key::S)]),
        graph(
            G::Dissolve,
            text!("Delete, keep the wires through"),
            &[(SHIFT, Key::Delete), (SHIFT, Key::X)],
        ),
        graph(
            G::Delete,
            text!("Delete"),
            &[(NONE, Key::Delete), (NONE, Key::Backspace), (NONE, Key::X)],
        ),
        graph(G::Duplicate, text!("Duplicate"), &[(CTRL, Key::D), (SHIFT, Key::D)]),
        graph(G::Copy, text!("Copy the selected nodes as text"), &[(CTRL, Key::C)])
            .in_menu(Menu::CopyAs),
        graph(G::Cut, text!("Cut"), &[(CTRL, Key::X)]),
        graph(G::Paste, text!("Paste"), &[(CTRL, Key::V)]),
        graph(G::SelectAll, text!("Select all"), &[(CTRL, Key::A)]),
        graph(G::SelectNone, text!("Select nothing"), &[(CTRL_SHIFT, Key::A)]),
        graph(G::Invert, text!("Invert the selection"), &[(CTRL, Key::I)]),
        graph(G::Upstream, text!("Select what leads here"), &[(NONE, Key::OpenBracket)]),
        graph(G::Downstream, text!("Select what this leads to"), &[(NONE, Key::CloseBracket)]),
    ]
}

/// Rows that change nodes in place, groups and frames.
fn groups() -> Vec<CommandRow> {
    vec![
        graph(G::Rename, text!("Rename"), &[(NONE, Key::F2)]),
        graph(G::NamePass, text!("Name an output as a pass (AOV)..."), &[]).help(text!(
            "Films ask for the output by this name: chiaro render --aov NAME. It costs nothing \
             where nobody asks"
        )),
        graph(G::Mute, text!("Mute or unmute"), &[(NONE, Key::M)]),
        graph(G::Collapse, text!("Collapse or expand"), &[(NONE, Key::H)]),
        graph(G::Ungroup, text!("Dissolve the group"), &[(CTRL_SHIFT, Key::G)]),
        graph(G::Group, text!("Make a group"), &[(CTRL, Key::G)]),
        graph(G::OpenGroup, text!("Open the group"), &[(CTRL, Key::Enter)]),
        graph(G::LeaveGroup, text!("Leave the group"), &[(NONE, Key::U), (CTRL, Key::Backspace)]),
        graph(G::ShareGroup, text!("Share the group with the project"), &[]),
        graph(G::Unframe, text!("Take out of the frame"), &[(CTRL_SHIFT, Key::J), (ALT, Key::P)]),
        graph(G::Frame, text!("Put a frame around"), &[(CTRL, Key::J)]),
        graph(G::Note, text!("Add a note"), &[(NONE, Key::N)]),
        graph(G::Connect, text!("Wire the selected nodes, else show all"), &[(NONE, Key::F)]),
        graph(G::ShowAll, text!("Show all"), &[(NONE, Key::Home)]),
    ]
}

/// Rows about the layout of nodes, and the part of it in view.
fn arrangement() -> Vec<CommandRow> {
    vec![
        graph(G::ShowSelected, text!("Show what is selected"), &[(NONE, Key::Period)]),
        graph(G::AlignLeft, text!("Align left edges"), &[(SHIFT, Key::ArrowLeft)]),
        graph(G::AlignRight, text!("Align right edges"), &[(SHIFT, Key::ArrowRight)]),
        graph(G::AlignTop, text!("Align tops"), &[(SHIFT, Key::ArrowUp)]),
        graph(G::AlignBottom, text!("Align bottoms"), &[(SHIFT, Key::ArrowDown)]),
        graph(G::DistributeAcross, text!("Space out evenly across"), &[(SHIFT, Key::H)]),
        graph(G::DistributeDown, text!("Space out evenly downward"), &[(SHIFT, Key::V)]),
        graph(G::Layout, text!("Tidy up"), &[(NONE, Key::L)]),
        graph(G::SnapGrid, text!("Snap to the grid, or not"), &[(NONE, Key::G)]),
        graph(G::Minimap, text!("Show or hide the minimap"), &[(SHIFT, Key::M)]),
        graph(G::Costs, text!("Show or hide what nodes cost"), &[(SHIFT, Key::C)]),
    ]
}

/// Rows of the arrow keys.
fn steps() -> Vec<CommandRow> {
    vec![
        graph(
            G::SelectNext(Left),
            text!("Select the next node to the left"),
            &[(CTRL, Key::ArrowLeft)],
        ),
        graph(
            G::SelectNext(Right),
            text!("Select the next node to the right"),
            &[(CTRL, Key::ArrowRight)],
        ),
        graph(G::SelectNext(Up), text!("Select the next node above"), &[(CTRL, Key::ArrowUp)]),
        graph(G::SelectNext(Down), text!("Select the next node below"), &[(CTRL, Key::ArrowDown)]),
        graph(G::Nudge(Left), text!("Move left, or select"), &[(NONE, Key::ArrowLeft)]),
        graph(G::Nudge(Right), text!("Move right, or select"), &[(NONE, Key::ArrowRight)]),
        graph(G::Nudge(Up), text!("Move up, or select"), &[(NONE, Key::ArrowUp)]),
        graph(G::Nudge(Down), text!("Move down, or select"), &[(NONE, Key::ArrowDown)]),
    ]
}
