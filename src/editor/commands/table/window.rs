//! Rows of commands that work everywhere in the window.

use chiaro_locale::{Text, text};
use eframe::egui::Key;

use super::KeyScope::{self, Window};
use super::{ALT, CTRL, CTRL_SHIFT, CommandRow, Menu, NONE, RowLabel, SHIFT, row};
use crate::commands::{
    Command as C, FilmCommand, FitCommand, GridPreset, LibraryCommand, PaintCommand as P, PanelId,
    ScaleCommand, SceneCommand, ShotCommand, SnapshotCommand, Switch, TourTopic, ViewCommand,
};
use crate::document::Storage;
use crate::hcbtf::exchange::ExchangeFormat;
use crate::state::languages::LANGUAGES;
use crate::state::parts::saving::PartChoice;
use crate::state::variations::VariedSubject;

/// Rows about files and steps, which stand before those of the languages of exports.
pub(super) fn files() -> Vec<CommandRow> {
    vec![
        row(C::New, text!("New look"), &[(CTRL, Key::N)], Window).help(text!("A new look")),
        row(C::Open(None), text!("Open a look"), &[(CTRL, Key::O)], Window).help(text!(
            "Opens a look, a scene, a shot, a painted surface or the sheet of a wedge, or makes a \
             look of a MaterialX document or of Blender's shader nodes"
        )),
        row(C::SaveAs, text!("Save under another name"), &[(CTRL_SHIFT, Key::S)], Window)
            .help(text!("Saves the look under another name")),
        row(C::SaveWithFiles, text!("Save under another name with its files"), &[], Window).help(
            text!(
                "Saves the look into another folder, and copies the images and painted surfaces \
                 that lie with it beside it; all others are used where they are"
            ),
        ),
        row(
            C::Scene(SceneCommand::SaveWithFiles),
            text!("Save the scene under another name with its files"),
            &[],
            Window,
        )
        .help(text!(
            "Saves the scene into another folder, and copies the meshes, looks and images that lie \
             with it there; all others are used where they are"
        )),
        row(C::Save, text!("Save"), &[(CTRL, Key::S)], Window)
            .help(text!("Saves the look, its scene and what is painted")),
        row(
            C::Library(LibraryCommand::Offer(PartChoice::Look)),
            text!("Save this look to the library"),
            &[],
            Window,
        )
        .help(text!("With tags, in one's own folder, the project's or a shared one")),
        row(
            C::Scene(SceneCommand::Shot(ShotCommand::New)),
            text!("New shot of this scene"),
            &[],
            Window,
        )
        .help(text!(
            "A shot over the open scene, also where another shot of it is open: frames, and values \
             that are changed over it, in a file of its own"
        )),
        row(
            C::Scene(SceneCommand::Shot(ShotCommand::NewOver)),
            text!("New shot over this shot"),
            &[],
            Window,
        )
        .help(text!(
            "A shot over the open shot, as over a sequence: all that the open one changes stands \
             beneath it, also what that changes later"
        )),
        row(C::Redo, text!("Redo"), &[(CTRL_SHIFT, Key::Z), (CTRL, Key::Y)], Window),
        row(C::Undo, text!("Undo"), &[(CTRL, Key::Z)], Window),
        row(
            C::Snapshot(SnapshotCommand::Take),
            text!("Take a snapshot"),
            &[(CTRL_SHIFT, Key::T)],
            Window,
        )
        .help(text!("Keeps the look as it is, under a name: to come back to, and to compare with")),
        row(C::ShowPanel(PanelId::SNAPSHOTS), text!("Snapshots of the look"), &[], Window)
            .help(text!("States of the look that were kept: restored, renamed, compared")),
        row(C::ShowPanel(PanelId::VARIATIONS), text!("Variations..."), &[], Window).help(text!(
            "Small pictures of a value, a color or a light as it could be; a click takes one"
        )),
        row(
            C::View(ViewCommand::Vary(VariedSubject::Mesh)),
            text!("Variations of the mesh"),
            &[],
            Window,
        )
        .help(text!(
            "The look on every built-in shape, or an object of the scene on other meshes; a click \
             takes one"
        )),
        row(C::OpenPath, text!("Open a file by its path"), &[(CTRL_SHIFT, Key::O)], Window),
        row(C::ShowStart(true), text!("Start page"), &[(ALT, Key::Home)], Window)
            .in_menu(Menu::Help),
        row(C::StartTour(TourTopic::Look), text!("Take the tour"), &[], Window).in_menu(Menu::Help),
        row(C::StartTour(TourTopic::Lights), text!("Light a scene (tour)"), &[], Window)
            .help(text!(
                "Key, rim and eye light, links, a shadow and the mixer, on three gray objects"
            ))
            .in_menu(Menu::Help),
        row(C::CopyPicture, text!("Copy the picture as an image"), &[(CTRL_SHIFT, Key::I)], Window)
            .in_menu(Menu::CopyAs),
        row(C::CopyWgsl, text!("Copy the shader as WGSL"), &[(CTRL_SHIFT, Key::W)], Window)
            .in_menu(Menu::CopyAs),
    ]
}

fn painting(command: P, label: Text) -> CommandRow {
    row(C::Paint(command), label, &[], Window).in_menu(Menu::Paint)
}

fn new_hcbtf(preset: GridPreset) -> P {
    P::New { grid: preset.grid(), keeps_look: false }
}

fn export_hcbtf(form: ExchangeFormat) -> P {
    P::Export { form, storage: Storage::default(), to: None }
}

/// Label of a scale, in percent.
fn scaled(percent: &'static str) -> RowLabel {
    RowLabel::from(text!("Scale {percent}%")).with("percent", percent)
}

/// Rows that choose the language of the window.
pub(super) fn languages() -> impl Iterator<Item = CommandRow> {
    let languages = LANGUAGES.iter().map(|language| {
        let label = RowLabel::from(text!("Language: {name}")).with("name", language.name);
        row(C::Speak(Some(language.tag)), label, &[], Window)
    });
    let of_system = row(C::Speak(None), text!("Language: as the system"), &[], Window);
    languages.chain([of_system])
}

/// Rows that follow those of the languages of exports.
pub(super) fn rows() -> Vec<CommandRow> {
    let mut rows = films_and_scales();
    rows.extend(panels());
    rows.extend(paintings());
    rows
}

/// Rows about pictures as files, the palette and the scale of the window.
fn films_and_scales() -> Vec<CommandRow> {
    vec![
        row(C::ExportPicture, text!("Export the picture as PNG..."), &[], Window)
            .in_menu(Menu::Export),
        row(C::Scene(SceneCommand::KeepView), text!("Keep this view"), &[], Window).help(text!(
            "The camera and the backdrop of the picture become the scene's, or the shot's, and in \
             a scene the turn of the lights, too"
        )),
        row(C::ShowPanel(PanelId::FRAMES), text!("Render frames..."), &[], Window)
            .help(text!(
                "Frames of the shot, the scene or the look as files, with layers and mattes"
            ))
            .in_menu(Menu::Export),
        row(C::Film(FilmCommand::ShowFarm), text!("Send to a farm..."), &[], Window)
            .help(text!("The job by which Slurm, OpenCue, OpenJD or Flamenco render the frames"))
            .in_menu(Menu::Export),
        row(C::ShowPanel(PanelId::WEDGE), text!("Wedge: try values side by side..."), &[], Window)
            .help(text!("Several values, each combination as a picture on one sheet"))
            .in_menu(Menu::Export),
        row(
            C::OpenPalette,
            text!("Find a command or a node"),
            &[(CTRL, Key::P), (CTRL, Key::F)],
            Window,
        )
        .in_menu(Menu::Help),
        row(
            C::OpenShortcuts,
            text!("Show all shortcuts"),
            &[(NONE, Key::Questionmark), (SHIFT, Key::Questionmark), (NONE, Key::F1)],
            Window,
        )
        .in_menu(Menu::Help),
        row(
            C::Scale(ScaleCommand::Larger),
            text!("Scale up: everything larger"),
            &[(CTRL, Key::Plus), (CTRL, Key::Equals), (CTRL_SHIFT, Key::Plus)],
            Window,
        ),
        row(
            C::Scale(ScaleCommand::Smaller),
            text!("Scale down: everything smaller"),
            &[(CTRL, Key::Minus)],
            Window,
        ),
        row(C::Scale(ScaleCommand::To(100)), scaled("100"), &[(CTRL, Key::Num0)], Window),
        row(C::Scale(ScaleCommand::To(125)), scaled("125"), &[], Window),
        row(C::Scale(ScaleCommand::To(150)), scaled("150"), &[], Window),
        row(C::Scale(ScaleCommand::To(200)), scaled("200"), &[], Window),
    ]
}

/// Rows that show panels, and painting on the picture.
fn panels() -> Vec<CommandRow> {
    vec![
        row(
            C::Fit(FitCommand::Turn(Switch::Toggle)),
            text!("Paint light on the picture"),
            &[(NONE, Key::L)],
            KeyScope::Picture,
        )
        .in_menu(Menu::Paint),
        row(C::ShowPanel(PanelId::PAINT), text!("Paint a surface"), &[], Window),
        row(C::ShowPanel(PanelId::LIGHT_TABLE), text!("Light table"), &[], Window)
            .help(text!("All lights and groups, field by field: many are changed at once")),
        row(C::ShowPanel(PanelId::MIXER), text!("Mixer of lights"), &[], Window)
            .help(text!("The masters of groups of lights, as faders")),
        row(C::ShowPanel(PanelId::LINKS), text!("Links of lights and objects"), &[], Window)
            .help(text!("Which lights light which objects, and by which rule")),
        row(C::Paint(P::PaintShown), text!("Paint what the look shows"), &[], Window),
    ]
}

/// Rows about the HCBTF that is painted.
fn paintings() -> Vec<CommandRow> {
    vec![
        painting(
            new_hcbtf(GridPreset::Small),
            text!("New painted surface, small (16 x 16, 3 x 6 directions)"),
        ),
        painting(
            new_hcbtf(GridPreset::Thesis),
            text!("New painted surface, as the thesis (32 x 32, 6 x 10 directions)"),
        ),
        painting(
            new_hcbtf(GridPreset::Large),
            text!("New painted surface, large (64 x 64, 6 x 10 directions)"),
        ),
        painting(
            new_hcbtf(GridPreset::Fine),
            text!("New painted surface, fine tile (128 x 128, 3 x 8 directions)"),
        ),
        painting(P::AskGrid { changes: false }, text!("New painted surface of any grid...")),
        painting(P::AskGrid { changes: true }, text!("Divide the painted surface otherwise..."))
            .needing_painting(),
        painting(P::AskSynthesis, text!("New tile from this painting...")).needing_painting(),
        painting(P::AskBake, text!("Bake this look onto a tile...")),
        painting(P::Save, text!("Save the painted surface")).needing_painting(),
        painting(P::SaveAs, text!("Save the painted surface under another name..."))
            .needing_painting(),
        painting(P::Close, text!("Close the painted surface")).needing_painting(),
        painting(P::AskImport, text!("Import painted pictures as a painted surface...")),
        painting(
            export_hcbtf(ExchangeFormat::Folder),
            text!("Export the painted surface as a folder of images..."),
        )
        .needing_painting(),
        painting(
            export_hcbtf(ExchangeFormat::Contact),
            text!("Export the painted surface as a contact sheet..."),
        )
        .needing_painting(),
        painting(
            export_hcbtf(ExchangeFormat::Sheet),
            text!("Export the painted surface as a sheet of the thesis..."),
        )
        .needing_painting(),
        painting(P::AskTexture, text!("Export the painted surface as a KTX2 texture..."))
            .needing_painting(),
    ]
}
