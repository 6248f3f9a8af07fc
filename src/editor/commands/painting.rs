//! What is asked for of the HCBTF that is painted, and the tools that paint it.

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui;

use super::Heading;
use crate::document::{Address, Directions, Grid, Hcbtf, HcbtfEdit, Storage, Tile};
use crate::hcbtf::exchange::Form;

/// Something that is asked for of what is painted; [`App`](crate::App) does it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PaintCommand {
    /// A change as an undo step of its own.
    Edit(HcbtfEdit),
    /// A change that goes on for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, HcbtfEdit),
    /// Works at another sample.
    GoTo(Address),
    /// Begins a new one, in a look of its own unless the open one is to stay.
    New {
        grid: Grid,
        keeps_look: bool,
    },
    /// Opens the one in a file. The open look stays where it shows that, or where it is to.
    Open {
        path: PathBuf,
        keeps_look: bool,
    },
    /// Divides the open one otherwise, which loses so many painted samples.
    Divide {
        grid: Grid,
        lost: usize,
    },
    /// Paints what the open look shows, or goes on with that; where it is more than one, shows
    /// which there are.
    PaintShown,
    /// Shows the open one in the look that it was painted in, or in one of its own.
    GoBack,
    /// Asks how finely a new one is divided, or how the open one is to be from now on.
    AskGrid {
        changes: bool,
    },
    /// Asks for a new tile of patches of the open one.
    AskSynthesis,
    /// Asks onto which grid the open look is to be baked.
    AskBake,
    /// Bakes it as was asked for; asks for the file where there is none.
    Bake {
        to: Option<PathBuf>,
    },
    /// Begins with what was made, in a look of its own.
    Begin {
        hcbtf: Arc<Hcbtf>,
    },
    /// Asks what pictures of other programs are to become an HCBTF.
    AskImport,
    /// Makes one of pictures; asks for them where there are none.
    Import {
        import: PictureImport,
        from: Option<PathBuf>,
    },
    /// Asks how a texture is to be stored.
    AskTexture,
    /// Writes all samples in another program's form; asks where to.
    Export {
        form: Form,
        /// Of a texture.
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
    /// Shows a stroke that goes on over a sample, which is no edit yet; none shows what is painted.
    ShowStroke(Option<(Address, Arc<Tile>)>),
}

/// A tool that paints on the tile.
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
    /// All, in the order of the bar.
    pub(crate) const ALL: [Self; 7] =
        [Self::Paint, Self::Erase, Self::Smudge, Self::Line, Self::Fill, Self::Stamp, Self::Pick];

    /// What people call it.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Paint => "Brush",
            Self::Erase => "Eraser",
            Self::Smudge => "Smudge",
            Self::Line => "Line",
            Self::Fill => "Fill",
            Self::Stamp => "Stamp",
            Self::Pick => "Pick a color",
        }
    }

    /// What it does, with its key.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Paint => "Paints with the first color (B). Alt-click picks a color from the tile",
            Self::Erase => "Takes paint away, down to what is transparent (E)",
            Self::Smudge => "Pulls the paint along, as a finger does (S)",
            Self::Line => "Draws a straight stroke from where you press to where you let go (L)",
            Self::Fill => {
                "Fills what is of one color and hangs together, and goes on under soft edges (G)"
            }
            Self::Stamp => {
                "Lays a whole tile down, as wide as the brush (K). Shift-click takes the tile at \
                 work as the stamp"
            }
            Self::Pick => "Takes the color under the pointer (I)",
        }
    }

    /// Whether it has a size and an edge.
    pub(crate) fn has_brush(self) -> bool {
        !matches!(self, Self::Fill | Self::Pick)
    }
}

/// A grid to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum GridPreset {
    Small,
    Thesis,
    Large,
    Fine,
}

impl GridPreset {
    pub(crate) const ALL: [Self; 4] = [Self::Small, Self::Thesis, Self::Large, Self::Fine];

    /// The grid itself.
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
            Self::Small => "Small",
            Self::Thesis => "Thesis",
            Self::Large => "Large",
            Self::Fine => "Fine tile",
        }
    }

    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Small => "Few texels, few directions: to try things out",
            Self::Thesis => "The size of the thesis that HCBTFs come from",
            Self::Large => "The thesis's directions with finer strokes",
            Self::Fine => "Fine strokes that change little with light and eye",
        }
    }
}

/// What pictures are taken for. How large their tiles are they tell themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PictureImport {
    pub(crate) form: Form,
    pub(crate) light: Directions,
    pub(crate) view: Directions,
    /// Texels between the tiles of a contact sheet.
    pub(crate) gap: u32,
    pub(crate) is_tiling: bool,
}

impl Default for PictureImport {
    fn default() -> Self {
        let Grid { light, view, .. } = Grid::THESIS;
        Self { form: Form::Folder, light, view, gap: 0, is_tiling: true }
    }
}
