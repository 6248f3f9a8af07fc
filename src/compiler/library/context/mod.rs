//! What a node may ask of its surroundings: the surface, the camera, the clock and the lights.
//!
//! A [`Context`] is a handle to a row of one [table](table), or to what a light gives. The row says everything: the word that
//! node files use, the type, where the value comes from in a shader and on the host, and which
//! value a sample without a scene has. Whoever needs more of a context asks its row; nobody else
//! lists contexts.

mod row;
mod sample;
mod table;

use std::fmt;

use crate::document::{LightInput, Tier};

pub use row::{Bounds, ContextRow, ContextSource, HostSurroundings};
pub use sample::{ContextSample, SurfacePart, SurfacePoint};

use super::PassId;
use table::TABLE;

/// When a value is known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Rate {
    /// When the look is compiled.
    #[default]
    Constant,
    /// Once a frame.
    Frame,
    /// Once an object.
    Object,
    /// At each vertex.
    Vertex,
    /// At each fragment.
    Fragment,
}

/// A value from the surroundings; the word after `from=` in a node's `@param`. Contexts are ordered
/// as their rows are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Context(Handle);

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Handle {
    /// A row of the table, by its number.
    Row(u8),
    /// What a light gives, which has rows of its own.
    Light(LightInput),
}

impl Context {
    /// The surface's own normal, which the modules that draw normals draw.
    pub const NORMAL: Self = Self::named("normal");
    /// Curvature of the surface, which most nodes do not show as an input.
    pub const KAPPA: Self = Self::named("kappa");

    /// The context of a word, looked up when Chiaro is compiled.
    ///
    /// # Panics
    /// Where no row has the word; use [`from_word`](Self::from_word) for words that are read.
    pub const fn named(word: &str) -> Self {
        let mut index = 0;
        while index < TABLE.len() {
            if is_same(TABLE[index].word.as_bytes(), word.as_bytes()) {
                return Self(Handle::Row(index as u8));
            }
            index += 1;
        }
        panic!("no row of the table of contexts has this word")
    }

    /// All of them, in the order of their rows.
    pub fn all() -> impl Iterator<Item = Self> {
        let rows = (0..TABLE.len()).map(|index| Handle::Row(index as u8));
        rows.chain(LightInput::all().map(Handle::Light)).map(Self)
    }

    /// The context that a node file's `from=` names.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::all().find(|context| context.word() == word)
    }

    /// Everything that is known of it.
    pub fn row(self) -> ContextRow {
        match self.0 {
            Handle::Row(index) => TABLE[usize::from(index)],
            Handle::Light(input) => ContextRow::light(input),
        }
    }

    /// What stands for it in a node of this tier.
    ///
    /// What is off by more than is seen stands for a curvature only where an artist asked for that:
    /// in the fast tier, and in the balanced one of the node that is the measure itself
    /// (`is_measure`) and nothing else.
    pub fn at_tier(self, tier: Tier, is_measure: bool) -> Self {
        let row = self.row();
        let word = match tier {
            Tier::Balanced if is_measure => row.balanced,
            Tier::Fast => row.fast,
            _ => None,
        };
        word.and_then(Self::from_word).unwrap_or(self)
    }

    /// Whether it is a curvature in one number, whatever of and however it is measured.
    pub fn is_curvature(self) -> bool {
        let row = self.row();
        row.sample.parts() == [SurfacePart::Kappa] && row.ty == "f32"
    }

    /// What a light gives for it.
    pub fn light_input(self) -> Option<LightInput> {
        match self.0 {
            Handle::Row(_) => None,
            Handle::Light(input) => Some(input),
        }
    }

    /// The pass whose result it is.
    pub fn pass(self) -> Option<PassId> {
        match self.row().source {
            ContextSource::Pass { pass, .. } => PassId::from_slug(pass),
            _ => None,
        }
    }

    /// The word that node files use; also the variable's name in generated source.
    pub fn word(self) -> &'static str {
        self.row().word
    }

    /// Its WGSL type.
    pub fn wgsl_type(self) -> &'static str {
        self.row().ty
    }

    /// When it is known. Lights are of object rate, because a direction key may turn them for each
    /// object.
    pub fn rate(self) -> Rate {
        match self.row().source {
            ContextSource::Fragment { .. } | ContextSource::Pass { .. } => Rate::Fragment,
            ContextSource::Host { rate, .. } => rate,
            ContextSource::Light(_) => Rate::Object,
        }
    }

    /// What it is, with its space and unit: a phrase for docs and tooltips.
    pub fn help(self) -> &'static str {
        self.row().help
    }
}

impl fmt::Debug for Context {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Context({})", self.word())
    }
}

/// Whether two slugs are the same, known when Chiaro is compiled.
pub(super) const fn is_same(a: &[u8], b: &[u8]) -> bool {
    if a.len() != b.len() {
        return false;
    }
    let mut index = 0;
    while index < a.len() {
        if a[index] != b[index] {
            return false;
        }
        index += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Type;

    #[test]
    fn every_row_is_whole() {
        assert!(TABLE.len() < usize::from(u8::MAX));
        for context in Context::all() {
            let row = context.row();
            assert_eq!(Context::from_word(row.word), Some(context), "{context:?} twice");
            assert!(!row.help.is_empty(), "{context:?}");
            let named = |word: Option<&str>| word.is_none_or(|w| Context::from_word(w).is_some());
            assert!(named(row.balanced) && named(row.fast), "{context:?}: a cheaper one");
            if let ContextSource::Pass { pass, wgsl } = row.source {
                assert!(PassId::from_slug(pass).is_some(), "{context:?}: no pass `{pass}`");
                assert!(wgsl.contains("texel"), "{context:?} reads nothing of its pass");
            }
            if context.rate() == Rate::Fragment {
                let value = row.sample.value(context, &SurfacePoint::default(), None);
                let count = value.components().map_or(0, |components| components.len());
                let width = Type::from_wgsl(row.ty).width().unwrap_or(9);
                assert_eq!(count, width, "{context:?}: the numbers of a sample");
            }
        }
    }
}
