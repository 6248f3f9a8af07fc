//! The parameters of strokes that stand on the tile.

use serde::{Deserialize, Serialize};

/// What a generator is told of strokes that stand on the tile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Strokes {
    /// Another number scatters anew.
    pub seed: u32,
}

impl Strokes {
    /// What is wrong with its numbers.
    ///
    /// # Errors
    /// Which number, and what it may be.
    #[expect(clippy::unused_self, clippy::unnecessary_wraps, reason = "there is nothing yet that could be wrong")]
    pub fn check(&self) -> Result<(), String> {
        Ok(())
    }
}
