//! Rows of commands that work over the graph, while no text is typed.

use std::borrow::Cow;

use eframe::egui::{Key, Modifiers};

use super::KeyScope::Graph;
use super::{ALT, CTRL, CTRL_SHIFT, CommandRow, Menu, NONE, SHIFT, row};
use crate::commands::Heading::{Down, Left, Right, Up};
use crate::commands::{Command as C, GraphCommand as G};

/// Digits of the bookmarks, with their keys.
static DIGITS: [(u8, [(Modifiers, Key); 2]); 9] = {
    const fn keys(key: Key) -> [(Modifiers, Key); 2] {
        [(CTRL, key), (NONE, key)]
    }
    [
        (1, keys(Key::Num1)),
        (2, keys(Key::Num2)),
        (3, keys(Key::Num3)),
        (4, keys(Key::Num4)),
        (5, keys(Key::Num5)),
        (6, keys(Key::Num6)),
        (7, keys(Key::Num7)),
        (8, keys(Key::Num8)),
        (9, keys(Key::Num9)),
    ]
};

fn graph(
    command: G,
    label: impl Into<Cow<'static, str>>,
    keys: &'static [(Modifiers, Key)],
) -> CommandRow {
    row(C::Graph(command), label, keys, Graph)
}

pub(super) fn rows() -> Vec<CommandRow> {
    let mut rows = edits();
    rows.extend(groups());
    rows.extend(arrangement());
    rows.extend(steps());
    rows.extend(DIGITS.iter().map(|(digit, keys)| {
        graph(G::Remember(*digit), format!("Bookmark this view as {digit}"), &keys[..1])
    }));
    rows.extend(DIGITS.iter().map(|(digit, keys)| {
        graph(G::GoTo(*digit), format!("Go to bookmark {digit}"), &keys[1..])
    }));
    rows
}

/// Rows that add, remove and select nodes.
fn edits() -> Vec<CommandRow> {
    vec![
        graph(G::AddNode, "Add a node", &[(NONE, Key::Tab), (NONE, Key::A), (SHIFT, Key::A)]),
        graph(G::Swap, "Swap the node for another", &[(NONE, Key::S)]),
        graph(
            G::Dissolve,
            "Delete, keep the wires through",
            &[(SHIFT, Key::Delete), (SHIFT, Key::X)],
        ),
        graph(G::Delete, "Delete", &[(NONE, Key::Delete), (NONE, Key::Backspace), (NONE, Key::X)]),
        graph(G::Duplicate, "Duplicate", &[(CTRL, Key::D), (SHIFT, Key::D)]),
        graph(G::Copy, "Copy the selected nodes as text", &[(CTRL, Key::C)]).in_menu(Menu::CopyAs),
        graph(G::Cut, "Cut", &[(CTRL, Key::X)]),
        graph(G::Paste, "Paste", &[(CTRL, Key::V)]),
        graph(G::SelectAll, "Select all", &[(CTRL, Key::A)]),
        graph(G::SelectNone, "Select nothing", &[(CTRL_SHIFT, Key::A)]),
        graph(G::Invert, "Invert the selection", &[(CTRL, Key::I)]),
        graph(G::Upstream, "Select what leads here", &[(NONE, Key::OpenBracket)]),
        graph(G::Downstream, "Select what this leads to", &[(NONE, Key::CloseBracket)]),
    ]
}

/// Rows that change nodes in place, groups and frames.
fn groups() -> Vec<CommandRow> {
    vec![
        graph(G::Rename, "Rename", &[(NONE, Key::F2)]),
        graph(G::NamePass, "Name an output as a pass (AOV)...", &[]).help(
            "Films ask for the output by this name: chiaro render --aov NAME. It costs nothing \
             where nobody asks",
        ),
        graph(G::Mute, "Mute or unmute", &[(NONE, Key::M)]),
        graph(G::Collapse, "Collapse or expand", &[(NONE, Key::H)]),
        graph(G::Ungroup, "Dissolve the group", &[(CTRL_SHIFT, Key::G)]),
        graph(G::Group, "Make a group", &[(CTRL, Key::G)]),
        graph(G::OpenGroup, "Open the group", &[(CTRL, Key::Enter)]),
        graph(G::LeaveGroup, "Leave the group", &[(NONE, Key::U), (CTRL, Key::Backspace)]),
        graph(G::ShareGroup, "Share the group with the project", &[]),
        graph(G::Unframe, "Take out of the frame", &[(CTRL_SHIFT, Key::J), (ALT, Key::P)]),
        graph(G::Frame, "Put a frame around", &[(CTRL, Key::J)]),
        graph(G::Note, "Add a note", &[(NONE, Key::N)]),
        graph(G::Connect, "Wire the selected nodes, else show all", &[(NONE, Key::F)]),
        graph(G::ShowAll, "Show all", &[(NONE, Key::Home)]),
    ]
}

/// Rows about the layout of nodes, and the part of it in view.
fn arrangement() -> Vec<CommandRow> {
    vec![
        graph(G::ShowSelected, "Show what is selected", &[(NONE, Key::Period)]),
        graph(G::AlignLeft, "Align left edges", &[(SHIFT, Key::ArrowLeft)]),
        graph(G::AlignRight, "Align right edges", &[(SHIFT, Key::ArrowRight)]),
        graph(G::AlignTop, "Align tops", &[(SHIFT, Key::ArrowUp)]),
        graph(G::AlignBottom, "Align bottoms", &[(SHIFT, Key::ArrowDown)]),
        graph(G::DistributeAcross, "Space out evenly across", &[(SHIFT, Key::H)]),
        graph(G::DistributeDown, "Space out evenly downward", &[(SHIFT, Key::V)]),
        graph(G::Layout, "Tidy up", &[(NONE, Key::L)]),
        graph(G::SnapGrid, "Snap to the grid, or not", &[(NONE, Key::G)]),
        graph(G::Minimap, "Show or hide the minimap", &[(SHIFT, Key::M)]),
        graph(G::Costs, "Show or hide what nodes cost", &[(SHIFT, Key::C)]),
    ]
}

/// Rows of the arrow keys.
fn steps() -> Vec<CommandRow> {
    vec![
        graph(G::SelectNext(Left), "Select the next node to the left", &[(CTRL, Key::ArrowLeft)]),
        graph(
            G::SelectNext(Right),
            "Select the next node to the right",
            &[(CTRL, Key::ArrowRight)],
        ),
        graph(G::SelectNext(Up), "Select the next node above", &[(CTRL, Key::ArrowUp)]),
        graph(G::SelectNext(Down), "Select the next node below", &[(CTRL, Key::ArrowDown)]),
        graph(G::Nudge(Left), "Move left, or select", &[(NONE, Key::ArrowLeft)]),
        graph(G::Nudge(Right), "Move right, or select", &[(NONE, Key::ArrowRight)]),
        graph(G::Nudge(Up), "Move up, or select", &[(NONE, Key::ArrowUp)]),
        graph(G::Nudge(Down), "Move down, or select", &[(NONE, Key::ArrowDown)]),
    ]
}
