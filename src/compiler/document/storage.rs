//! Layout of an HCBTF in the texture that shaders look it up in.

use chiaro_locale::tr;

/// Storage of an HCBTF in a texture: a choice between speed and memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Storage {
    /// Lights of each texel beside each other, with a layer for each distinct view: the fewest
    /// reads.
    #[default]
    Quick,
    /// Each distinct tile once, with (x, y) innermost, as indices into a palette where that is
    /// smaller: exact, too.
    Compact,
    /// Each distinct tile once, with (x, y) innermost, in compressed blocks of a byte a texel: with
    /// a small loss.
    Blocks,
}

impl Storage {
    /// All storages, in the order of menus.
    pub const ALL: [Self; 3] = [Self::Quick, Self::Compact, Self::Blocks];

    /// Name of the storage in looks.
    pub fn word(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Compact => "compact",
            Self::Blocks => "blocks",
        }
    }

    /// Label of the storage in the window.
    pub fn label(self) -> &'static str {
        match self {
            Self::Quick => tr!("Quick"),
            Self::Compact => tr!("Compact"),
            Self::Blocks => tr!("Blocks"),
        }
    }

    /// Description in a line without a full stop, for help, documentation and menus.
    pub fn about(self) -> &'static str {
        match self {
            Self::Quick => {
                tr!("for each texel all its lights side by side: the fewest reads, and the most \
                 memory; exact")
            }
            Self::Compact => {
                tr!("every tile that differs once, with a palette where that is smaller: less \
                 memory, more reads; exact")
            }
            Self::Blocks => {
                tr!("every tile that differs once, compressed to a byte a texel (BC7): colors are \
                 off by a little")
            }
        }
    }

    /// Storage with a name in looks.
    pub fn of(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|storage| storage.word() == word)
    }
}
