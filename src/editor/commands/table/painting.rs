//! Rows of commands that work over the tile that is painted.

use chiaro_locale::{Text, text};
use eframe::egui::{Key, Modifiers};

use super::KeyScope::Painting;
use super::{CommandRow, NONE, SHIFT, row};
use crate::commands::Heading::{Down, Left, Right, Up};
use crate::commands::{Command as C, PaintCommand as P, PaintTool};

fn paint(command: P, label: Text, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::Paint(command), label, keys, Painting)
}

fn tool(tool: PaintTool, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    paint(P::TakeTool(tool), tool.label(), keys)
}

pub(super) fn rows() -> Vec<CommandRow> {
    vec![
        tool(PaintTool::Paint, &[(NONE, Key::B)]),
        tool(PaintTool::Erase, &[(NONE, Key::E)]),
        tool(PaintTool::Smudge, &[(NONE, Key::S)]),
        tool(PaintTool::Line, &[(NONE, Key::L)]),
        tool(PaintTool::Fill, &[(NONE, Key::G)]),
        tool(PaintTool::Stamp, &[(NONE, Key::K)]),
        tool(PaintTool::Pick, &[(NONE, Key::I)]),
        paint(
            P::ResizeBrush { is_larger: false },
            text!("Smaller brush"),
            &[(NONE, Key::OpenBracket)],
        ),
        paint(
            P::ResizeBrush { is_larger: true },
            text!("Larger brush"),
            &[(NONE, Key::CloseBracket)],
        ),
        paint(P::SwapColors, text!("Swap the two colors"), &[(NONE, Key::X)]),
        paint(P::ToggleTilt, text!("Tilted as the eye sees it, or flat"), &[(NONE, Key::F)])
            .help(text!("Shows the tile unturned and untilted")),
        paint(P::ToggleCopies, text!("Show or hide copies around the tile"), &[(NONE, Key::C)])
            .help(text!(
                "Repeats the tile around itself, so that seams are seen and painted across"
            )),
        paint(
            P::ToggleArrows,
            text!("Show or hide the arrows of light and eye"),
            &[(NONE, Key::A)],
        )
        .help(text!("Shows where the light comes from, and where the eye is")),
        paint(P::FitTile, text!("Show the whole tile"), &[(NONE, Key::Home)])
            .help(text!("Shows the whole tile again")),
        paint(P::StepLight(Left), text!("Light to the left"), &[(SHIFT, Key::ArrowLeft)]),
        paint(P::StepLight(Right), text!("Light to the right"), &[(SHIFT, Key::ArrowRight)]),
        paint(P::StepLight(Up), text!("Light higher"), &[(SHIFT, Key::ArrowUp)]),
        paint(P::StepLight(Down), text!("Light lower"), &[(SHIFT, Key::ArrowDown)]),
        paint(P::StepView(Left), text!("Eye to the left"), &[(NONE, Key::ArrowLeft)]),
        paint(P::StepView(Right), text!("Eye to the right"), &[(NONE, Key::ArrowRight)]),
        paint(P::StepView(Up), text!("Eye higher"), &[(NONE, Key::ArrowUp)]),
        paint(P::StepView(Down), text!("Eye lower"), &[(NONE, Key::ArrowDown)]),
    ]
}
