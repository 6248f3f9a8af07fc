//! Rows of commands that work over the tile that is painted.

use eframe::egui::{Key, Modifiers};

use super::KeyScope::Painting;
use super::{CommandRow, NONE, SHIFT, row};
use crate::commands::Heading::{Down, Left, Right, Up};
use crate::commands::{Command as C, PaintCommand as P, PaintTool};

fn paint(command: P, label: &'static str, keys: &'static [(Modifiers, Key)]) -> CommandRow {
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
        paint(P::ResizeBrush { is_larger: false }, "Smaller brush", &[(NONE, Key::OpenBracket)]),
        paint(P::ResizeBrush { is_larger: true }, "Larger brush", &[(NONE, Key::CloseBracket)]),
        paint(P::SwapColors, "Swap the two colors", &[(NONE, Key::X)]),
        paint(P::ToggleTilt, "Tilted as the eye sees it, or flat", &[(NONE, Key::F)])
            .help("Shows the tile unturned and untilted"),
        paint(P::ToggleCopies, "Show or hide copies around the tile", &[(NONE, Key::C)])
            .help("Repeats the tile around itself, so that seams are seen and painted across"),
        paint(P::ToggleArrows, "Show or hide the arrows of light and eye", &[(NONE, Key::A)])
            .help("Shows where the light comes from, and where the eye is"),
        paint(P::FitTile, "Show the whole tile", &[(NONE, Key::Home)])
            .help("Shows the whole tile again"),
        paint(P::StepLight(Left), "Light to the left", &[(SHIFT, Key::ArrowLeft)]),
        paint(P::StepLight(Right), "Light to the right", &[(SHIFT, Key::ArrowRight)]),
        paint(P::StepLight(Up), "Light higher", &[(SHIFT, Key::ArrowUp)]),
        paint(P::StepLight(Down), "Light lower", &[(SHIFT, Key::ArrowDown)]),
        paint(P::StepView(Left), "Eye to the left", &[(NONE, Key::ArrowLeft)]),
        paint(P::StepView(Right), "Eye to the right", &[(NONE, Key::ArrowRight)]),
        paint(P::StepView(Up), "Eye higher", &[(NONE, Key::ArrowUp)]),
        paint(P::StepView(Down), "Eye lower", &[(NONE, Key::ArrowDown)]),
    ]
}
