//! How an HCBTF lies in the texture that shaders look it up in.

/// A choice between speed and memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Storage {
    /// The lights of each texel beside each other, a layer for each view that differs: the fewest
    /// reads.
    #[default]
    Quick,
    /// Every tile that differs once, with (x, y) innermost, as indices into a palette where that is
    /// smaller: exact, too.
    Compact,
    /// Every tile that differs once, with (x, y) innermost, in compressed blocks of a byte a texel:
    /// with a small loss.
    Blocks,
}

impl Storage {
    /// Every one, in the order of menus.
    pub const ALL: [Self; 3] = [Self::Quick, Self::Compact, Self::Blocks];

    /// What looks call it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Quick => "quick",
            Self::Compact => "compact",
            Self::Blocks => "blocks",
        }
    }

    /// What it is, in a line without a full stop: for help, documentation and menus.
    pub fn about(self) -> &'static str {
        match self {
            Self::Quick => {
                "for each texel all its lights side by side: the fewest reads, and the most \
                 memory; exact"
            }
            Self::Compact => {
                "every tile that differs once, with a palette where that is smaller: less memory, \
                 more reads; exact"
            }
            Self::Blocks => {
                "every tile that differs once, compressed to a byte a texel (BC7): colors are off \
                 by a little"
            }
        }
    }

    /// The one that looks call so.
    pub fn of(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|storage| storage.word() == word)
    }
}
