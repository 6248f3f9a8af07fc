//! Compositors' documents that put a picture together from its layers: a gain for each light or
//! layer, and what is in none of them.
//!
//! Layers add up in the space in which the looks blend. So the picture is brought into that space,
//! the sum of its layers is taken off, which leaves backdrop, outlines and smooth edges, and all is
//! added again, each part times its gain:
//!
//! ```text
//! rest   = into(picture) - beauty
//! result = back(rest * gain + layer_1 * gain_1 + ... + layer_n * gain_n)
//! ```
//!
//! With all gains at 1 that is the picture. A compositor is a row of [`COMPOSITORS`] and a file
//! that writes its document as text.

mod blender;
mod nuke;
mod parts;

use crate::FrameRate;
use crate::diag::Diagnostic;
use crate::exr::SampleType;

pub use parts::{LayerSpace, PicturePart, PictureParts};

/// Picture, or frames, to be put together.
#[derive(Clone, Debug, PartialEq)]
pub struct Comp {
    /// Name for people.
    pub name: String,
    /// Path of the picture, with `####` for the number where there are frames, from the folder of
    /// the document unless it is absolute; folders are parted by `/`.
    pub file: String,
    /// Path of the first frame, as [`Self::file`].
    pub first_file: String,
    /// The first and the last frame; `None` for a picture alone.
    pub frames: Option<[i32; 2]>,
    /// Frames per second.
    pub rate: FrameRate,
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Numbers of the pictures that are written.
    pub samples: SampleType,
    /// The layers that add up to the picture.
    pub parts: PictureParts,
    /// Names of the mattes.
    pub mattes: Vec<String>,
    /// Path of the pictures that are written, as [`Self::file`].
    pub output: String,
}

impl Comp {
    /// True if paths begin at the folder of the document.
    fn is_relative(&self) -> bool {
        let is_drive = self.file.as_bytes().get(1) == Some(&b':');
        !(self.file.starts_with('/') || is_drive)
    }

    /// A sentence on the document, for its head.
    fn about(&self) -> String {
        let PictureParts { parts, whole, space, .. } = &self.parts;
        let space = match space {
            LayerSpace::Display => "as shown: the sum is decoded by the curve of sRGB",
            LayerSpace::Linear => "as light",
        };
        format!("{}: {} layers that add up to {whole}, {space}", self.name, parts.len())
    }
}

/// A program that puts pictures together.
#[derive(Clone, Copy)]
pub struct Compositor {
    /// Word of the command line.
    pub word: &'static str,
    /// Ending of the document's file.
    pub ending: &'static str,
    /// Way to open the document; `FILE` stands for it.
    pub opened_by: &'static str,
    write: fn(&Comp) -> Result<String, Diagnostic>,
}

/// All compositors.
pub const COMPOSITORS: &[Compositor] = &[
    Compositor {
        word: "nuke",
        ending: "nk",
        opened_by: "open it in Nuke 13 or later, as a script or by File > Insert Comp Nodes",
        write: nuke::write,
    },
    Compositor {
        word: "blender",
        ending: "py",
        opened_by: "blender --python FILE makes its scene; add -- --save comp.blend to keep it",
        write: blender::write,
    },
];

impl std::fmt::Debug for Compositor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.word)
    }
}

impl Compositor {
    /// The compositor of a word.
    pub fn named(word: &str) -> Option<Self> {
        COMPOSITORS.iter().find(|compositor| compositor.word == word).copied()
    }

    /// The text of a document.
    ///
    /// # Errors
    /// `no-comp` with what the compositor cannot hold.
    pub fn document(self, comp: &Comp) -> Result<String, Diagnostic> {
        (self.write)(comp)
    }
}
