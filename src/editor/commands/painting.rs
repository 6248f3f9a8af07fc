//! Commands about the painted HCBTF, and the tools that paint it.
//! Light that is painted on the picture: `commands::fit`.

use std::path::PathBuf;
use std::sync::Arc;

use chiaro_locale::{Text, text, tr};
use eframe::egui;

use super::Heading;
use crate::document::{Address, Directions, Grid, Hcbtf, HcbtfEdit, Storage, Tile};
use crate::hcbtf::exchange::ExchangeFormat;

/// Command about the painting; [`App`](crate::App) carries it out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PaintCommand {
    /// Changes the painting, as an undo step of its own.
    Edit(HcbtfEdit),
    /// Changes the painting for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, HcbtfEdit),
    /// Moves on to work at another sample.
    GoTo(Address),
    /// Begins a new HCBTF, in a look of its own unless the open look is to stay.
    New {
        grid: Grid,
        keeps_look: bool,
    },
    /// Opens the HCBTF in a file. The open look stays where it shows that HCBTF, or with
    /// `keeps_look`.
    Open {
        path: PathBuf,
        keeps_look: bool,
    },
    /// Gives the open HCBTF another grid, which loses `lost` painted samples.
    Divide {
        grid: Grid,
        lost: usize,
    },
    /// Paints what the open look shows, or goes on with that; where it shows several HCBTFs, lists
    /// them.
    PaintShown,
    /// Shows the painting in the look that it was painted in, or in one of its own.
    GoBack,
    /// Asks for the grid of a new HCBTF, or for another grid of the open one.
    AskGrid {
        changes: bool,
    },
    /// Asks for a new tile made of patches of the open HCBTF.
    AskSynthesis,
    /// Asks for the grid that the open look is to be baked onto.
    AskBake,
    /// Bakes the open look with the settings of the dialog; asks for the file where there is none.
    Bake {
        to: Option<PathBuf>,
    },
    /// Begins to paint a newly made HCBTF, in a look of its own.
    Begin {
        hcbtf: Arc<Hcbtf>,
    },
    /// Asks which pictures of other programs are to become an HCBTF.
    AskImport,
    /// Makes an HCBTF of pictures; asks for them where there are none.
    Import {
        import: PictureImport,
        from: Option<PathBuf>,
    },
    /// Asks for the storage of a texture.
    AskTexture,
    /// Writes all samples in another program's form; asks for the file where there is none.
    Export {
        form: ExchangeFormat,
        /// Storage of a texture.
        storage: Storage,
        to: Option<PathBuf>,
    },
    Save,
    SaveAs,
    /// Saves to this file.
    SaveTo(PathBuf),
    Close,
    /// Takes a tool in hand.
    TakeTool(PaintTool),
    ResizeBrush {
        is_larger: bool,
    },
    SwapColors,
    /// Shows the tile tilted as the eye sees it, or flat.
    ToggleTilt,
    /// Shows copies around the tile, or none.
    ToggleCopies,
    /// Shows the arrows of light and eye, or none.
    ToggleArrows,
    /// Shows the whole tile.
    FitTile,
    /// Moves the eye by one direction.
    StepView(Heading),
    /// Moves the light by one direction.
    StepLight(Heading),
    /// Shows a stroke that goes on over a sample, which is no edit yet; `None` shows the painting
    /// alone.
    ShowStroke(Option<(Address, Arc<Tile>)>),
}

/// Tool that paints on the tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum PaintTool {
    Paint,
    Erase,
    Smudge,
    Line,
    Fill,
    Stamp,
    Pick,
}

impl PaintTool {
    /// All tools, in the order of the bar.
    pub(crate) const ALL: [Self; 7] =
        [Self::Paint, Self::Erase, Self::Smudge, Self::Line, Self::Fill, Self::Stamp, Self::Pick];

    /// Display name of the tool.
    pub(crate) fn label(self) -> Text {
        match self {
            Self::Paint => text!("Brush"),
            Self::Erase => text!("Eraser"),
            Self::Smudge => text!("Smudge"),
            Self::Line => text!("Line"),
            Self::Fill => text!("tool" => "Fill"),
            Self::Stamp => text!("Stamp"),
            Self::Pick => text!("Pick a color"),
        }
    }

    /// Explanation of the tool, with its key.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Paint => {
                tr!("Paints with the first color (B). Alt-click picks a color from the tile")
            }
            Self::Erase => tr!("Takes paint away, down to what is transparent (E)"),
            Self::Smudge => tr!("Pulls the paint along, as a finger does (S)"),
            Self::Line => {
                tr!("Draws a straight stroke from where you press to where you let go (L)")
            }
            Self::Fill => {
                tr!("Fills what is of one color and hangs together, and goes on under soft edges \
                     (G)")
            }
            Self::Stamp => {
                tr!("Lays a whole tile down, as wide as the brush (K). Shift-click takes the tile \
                     at work as the stamp")
            }
            Self::Pick => tr!("Takes the color under the pointer (I)"),
        }
    }

    /// True if the tool has a size and an edge.
    pub(crate) fn has_brush(self) -> bool {
        !matches!(self, Self::Fill | Self::Pick)
    }
}

/// Preset of a new HCBTF's grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum GridPreset {
    Small,
    Thesis,
    Large,
    Fine,
}

impl GridPreset {
    pub(crate) const ALL: [Self; 4] = [Self::Small, Self::Thesis, Self::Large, Self::Fine];

    /// Grid of the preset.
    pub(crate) fn grid(self) -> Grid {
        let directions = |theta, phi| Directions { theta, phi };
        let of =
            |side, directions| Grid { size: [side, side], light: directions, view: directions };
        match self {
            Self::Small => of(16, directions(3, 6)),
            Self::Thesis => Grid::THESIS,
            Self::Large => of(64, directions(6, 10)),
            Self::Fine => of(128, directions(3, 8)),
        }
    }

    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Small => tr!("Small"),
            Self::Thesis => tr!("Thesis"),
            Self::Large => tr!("Large"),
            Self::Fine => tr!("Fine tile"),
        }
    }

    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Small => tr!("Few texels, few directions: to try things out"),
            Self::Thesis => tr!("The size of the thesis that painted surfaces (HCBTFs) come from"),
            Self::Large => tr!("The thesis's directions with finer strokes"),
            Self::Fine => tr!("Fine strokes that change little with light and eye"),
        }
    }
}

/// Interpretation of imported pictures. The size of their tiles is read from the pictures
/// themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PictureImport {
    pub(crate) form: ExchangeFormat,
    pub(crate) light: Directions,
    pub(crate) view: Directions,
    /// Gap between the tiles of a contact sheet, in texels.
    pub(crate) gap: u32,
    pub(crate) is_tiling: bool,
}

impl Default for PictureImport {
    fn default() -> Self {
        let Grid { light, view, .. } = Grid::THESIS;
        Self { form: ExchangeFormat::Folder, light, view, gap: 0, is_tiling: true }
    }
}
