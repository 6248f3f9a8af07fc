//! Rows of commands that work everywhere in the window.

use eframe::egui::Key;

use super::KeyScope::{self, Window};
use super::{ALT, CTRL, CTRL_SHIFT, CommandRow, Menu, NONE, SHIFT, row};
use crate::commands::{
    Command as C, FitCommand, GridPreset, PaintCommand as P, PanelId, ScaleCommand, SceneCommand,
    ShotCommand, SnapshotCommand, Switch, TourTopic, ViewCommand,
};
use crate::document::Storage;
use crate::hcbtf::exchange::ExchangeFormat;
use crate::state::variations::VariedSubject;

/// Rows about files and steps, which stand before those of the languages.
pub(super) fn files() -> Vec<CommandRow> {
    vec![
        row(C::New, "New look", &[(CTRL, Key::N)], Window).help("A new look"),
        row(C::Open(None), "Open a look", &[(CTRL, Key::O)], Window).help(
            "Opens a look, a scene or an HCBTF, or makes a look of a MaterialX document or of \
                 Blender's shader nodes",
        ),
        row(C::SaveAs, "Save under another name", &[(CTRL_SHIFT, Key::S)], Window)
            .help("Saves the look under another name"),
        row(C::Save, "Save", &[(CTRL, Key::S)], Window)
            .help("Saves the look, its scene and what is painted"),
        row(C::Scene(SceneCommand::Shot(ShotCommand::New)), "New shot of this scene", &[], Window)
            .help(
                "A shot over the open scene, or over the open shot: frames, and values that are \
                 changed over it, in a file of its own",
            ),
        row(C::Redo, "Redo", &[(CTRL_SHIFT, Key::Z), (CTRL, Key::Y)], Window),
        row(C::Undo, "Undo", &[(CTRL, Key::Z)], Window),
        row(C::Snapshot(SnapshotCommand::Take), "Take a snapshot", &[(CTRL_SHIFT, Key::T)], Window)
            .help("Keeps the look as it is, under a name: to come back to, and to compare with"),
        row(C::ShowPanel(PanelId::SNAPSHOTS), "Snapshots of the look", &[], Window)
            .help("States of the look that were kept: restored, renamed, compared"),
        row(C::ShowPanel(PanelId::VARIATIONS), "Variations...", &[], Window).help(
            "Small pictures of a value, a color or a light as it could be; a click takes one",
        ),
        row(C::View(ViewCommand::Vary(VariedSubject::Mesh)), "Variations of the mesh", &[], Window)
            .help("The look on every built-in shape; a click shows it there"),
        row(C::OpenPath, "Open a file by its path", &[(CTRL_SHIFT, Key::O)], Window),
        row(C::ShowStart(true), "Start page", &[(ALT, Key::Home)], Window).in_menu(Menu::Help),
        row(C::StartTour(TourTopic::Look), "Take the tour", &[], Window).in_menu(Menu::Help),
        row(C::StartTour(TourTopic::Lights), "Light a scene (tour)", &[], Window)
            .help("Key, rim and eye light, links, a shadow and the mixer, on three gray objects")
            .in_menu(Menu::Help),
        row(C::CopyPicture, "Copy the picture as an image", &[(CTRL_SHIFT, Key::I)], Window)
            .in_menu(Menu::CopyAs),
        row(C::CopyWgsl, "Copy the shader as WGSL", &[(CTRL_SHIFT, Key::W)], Window)
            .in_menu(Menu::CopyAs),
    ]
}

fn painting(command: P, label: &'static str) -> CommandRow {
    row(C::Paint(command), label, &[], Window).in_menu(Menu::Paint)
}

fn new_hcbtf(preset: GridPreset) -> P {
    P::New { grid: preset.grid(), keeps_look: false }
}

fn export_hcbtf(form: ExchangeFormat) -> P {
    P::Export { form, storage: Storage::default(), to: None }
}

/// Rows that follow those of the languages.
pub(super) fn rows() -> Vec<CommandRow> {
    vec![
        row(C::ExportPicture, "Export the picture as PNG...", &[], Window).in_menu(Menu::Export),
        row(C::OpenPalette, "Find a command or a node", &[(CTRL, Key::P), (CTRL, Key::F)], Window)
            .in_menu(Menu::Help),
        row(
            C::OpenShortcuts,
            "Show all shortcuts",
            &[(NONE, Key::Questionmark), (SHIFT, Key::Questionmark), (NONE, Key::F1)],
            Window,
        )
        .in_menu(Menu::Help),
        row(
            C::Scale(ScaleCommand::Larger),
            "Scale up: everything larger",
            &[(CTRL, Key::Plus), (CTRL, Key::Equals), (CTRL_SHIFT, Key::Plus)],
            Window,
        ),
        row(
            C::Scale(ScaleCommand::Smaller),
            "Scale down: everything smaller",
            &[(CTRL, Key::Minus)],
            Window,
        ),
        row(C::Scale(ScaleCommand::To(100)), "Scale 100%", &[(CTRL, Key::Num0)], Window),
        row(C::Scale(ScaleCommand::To(125)), "Scale 125%", &[], Window),
        row(C::Scale(ScaleCommand::To(150)), "Scale 150%", &[], Window),
        row(C::Scale(ScaleCommand::To(200)), "Scale 200%", &[], Window),
        row(
            C::Fit(FitCommand::Turn(Switch::Toggle)),
            "Paint light on the picture",
            &[(NONE, Key::L)],
            KeyScope::Picture,
        )
        .in_menu(Menu::Paint),
        row(C::ShowPanel(PanelId::PAINT), "Paint a surface (HCBTF)", &[], Window),
        row(C::ShowPanel(PanelId::LIGHT_TABLE), "Light table", &[], Window)
            .help("All lights and groups, field by field: many are changed at once"),
        row(C::ShowPanel(PanelId::MIXER), "Mixer of lights", &[], Window)
            .help("The masters of groups of lights, as faders"),
        row(C::ShowPanel(PanelId::LINKS), "Links of lights and objects", &[], Window)
            .help("Which lights light which objects, and by which rule"),
        row(C::Paint(P::PaintShown), "Paint what the look shows", &[], Window),
        painting(new_hcbtf(GridPreset::Small), "New HCBTF, small (16 x 16, 3 x 6 directions)"),
        painting(
            new_hcbtf(GridPreset::Thesis),
            "New HCBTF, as the thesis (32 x 32, 6 x 10 directions)",
        ),
        painting(new_hcbtf(GridPreset::Large), "New HCBTF, large (64 x 64, 6 x 10 directions)"),
        painting(new_hcbtf(GridPreset::Fine), "New HCBTF, fine tile (128 x 128, 3 x 8 directions)"),
        painting(P::AskGrid { changes: false }, "New HCBTF of any grid..."),
        painting(P::AskGrid { changes: true }, "Divide the HCBTF otherwise...").needing_painting(),
        painting(P::AskSynthesis, "New tile from this painting...").needing_painting(),
        painting(P::AskBake, "Bake this look onto a tile..."),
        painting(P::Save, "Save the HCBTF").needing_painting(),
        painting(P::SaveAs, "Save the HCBTF under another name...").needing_painting(),
        painting(P::Close, "Close the HCBTF").needing_painting(),
        painting(P::AskImport, "Import painted pictures as an HCBTF..."),
        painting(export_hcbtf(ExchangeFormat::Folder), "Export the HCBTF as a folder of images...")
            .needing_painting(),
        painting(export_hcbtf(ExchangeFormat::Contact), "Export the HCBTF as a contact sheet...")
            .needing_painting(),
        painting(
            export_hcbtf(ExchangeFormat::Sheet),
            "Export the HCBTF as a sheet of the thesis...",
        )
        .needing_painting(),
        painting(P::AskTexture, "Export the HCBTF as a KTX2 texture...").needing_painting(),
    ]
}
