//! Contexts: values that a node may read from its surroundings, which are the surface, the camera,
//! the clock and the lights.
//!
//! A [`Context`] is a handle to a row of one [table](table), or to an input from a light. The row
//! holds everything: the word that node files use, the type, the source of the value in a shader
//! and on the host, and the value of a sample without a scene. Code that needs a property of a
//! context asks its row; contexts are listed nowhere else.

mod row;
mod sample;
mod table;

use std::fmt;

use crate::document::{LightInput, Tier};

pub use row::{ContextBounds, ContextRow, ContextSource, HostSurroundings};
pub use sample::{ContextSample, SurfacePart, SurfacePoint};

use super::PassId;
use table::TABLE;
pub use table::{
    MAX_COORDINATE, MAX_CURVATURE, MAX_LINE_REACH, MAX_NORMAL_SCALE, MAX_ON_SCREEN, MAX_PLACE,
};

/// Rate at which a value changes: the earliest time at which the value is known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Rate {
    /// Known when the look is compiled.
    #[default]
    Constant,
    /// Known once a frame.
    Frame,
    /// Known once an object.
    Object,
    /// Known at each vertex.
    Vertex,
    /// Known at each fragment.
    Fragment,
}

/// Value from the surroundings; the word after `from=` in a node's `@param`. Contexts are ordered
/// as their rows are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Context(Handle);

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Handle {
    /// Row of the table, by number.
    Row(u8),
    /// Input from a light; these have rows of their own.
    Light(LightInput),
}

impl Context {
    /// The surface's own normal, which the modules that draw normals draw.
    pub const NORMAL: Self = Self::named("normal");
    /// Curvature of the surface, which most nodes do not show as an input.
    pub const KAPPA: Self = Self::named("kappa");

    /// Triangles of all objects that cast shadows.
    pub const CASTERS: Self = Self::named("casters");
    /// The context `shadow_map`.
    pub const SHADOW_MAP: Self = Self::named("shadow_map");

    /// Context with a word, looked up when Chiaro is compiled.
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

    /// All contexts, in the order of their rows.
    pub fn all() -> impl Iterator<Item = Self> {
        let rows = (0..TABLE.len()).map(|index| Handle::Row(index as u8));
        rows.chain(LightInput::all().map(Handle::Light)).map(Self)
    }

    /// Context that a node file's `from=` names.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::all().find(|context| context.word() == word)
    }

    /// Row of the context, with all its properties.
    pub fn row(self) -> ContextRow {
        match self.0 {
            Handle::Row(index) => TABLE[usize::from(index)],
            Handle::Light(input) => ContextRow::light(input),
        }
    }

    /// Context that replaces this one in a node of this tier.
    ///
    /// An approximation of a curvature with visible error is used only where an artist asked for
    /// one: in the fast tier, and in the balanced one of the node that is the measure itself
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

    /// Light input of the context; `None` where the context is a row of the table.
    pub fn light_input(self) -> Option<LightInput> {
        match self.0 {
            Handle::Row(_) => None,
            Handle::Light(input) => Some(input),
        }
    }

    /// Pass whose result the context is.
    pub fn pass(self) -> Option<PassId> {
        match self.row().source {
            ContextSource::Pass { pass, .. } | ContextSource::Scene { pass: Some(pass) } => {
                PassId::from_slug(pass)
            }
            _ => None,
        }
    }

    /// Word that node files use; also the variable's name in generated source.
    pub fn word(self) -> &'static str {
        self.row().word
    }

    /// True for a resource of the whole scene, which is bound as a variable of its own.
    pub fn is_resource(self) -> bool {
        matches!(self.row().source, ContextSource::Scene { .. })
    }

    /// WGSL type of the context.
    pub fn wgsl_type(self) -> &'static str {
        self.row().ty
    }

    /// Rate of the context. Lights are of object rate, because a direction key may turn them for
    /// each object.
    pub fn rate(self) -> Rate {
        match self.row().source {
            ContextSource::Fragment { .. }
            | ContextSource::Pass { .. }
            | ContextSource::Scene { .. } => Rate::Fragment,
            ContextSource::Host { rate, .. } => rate,
            ContextSource::Light(_) => Rate::Object,
        }
    }

    /// Description of the context with its space and unit: a phrase for docs and tooltips.
    pub fn help(self) -> &'static str {
        self.row().help
    }
}

impl fmt::Debug for Context {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Context({})", self.word())
    }
}

/// True if two slugs are the same; usable when Chiaro is compiled.
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
    use crate::interp::Value;
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
            if context.rate() == Rate::Fragment && !context.is_resource() {
                let value = row.sample.value(context, &SurfacePoint::default(), None);
                let count = value.components().map_or(0, |components| components.len());
                let width = Type::from_wgsl(row.ty).width().unwrap_or(9);
                assert_eq!(count, width, "{context:?}: the numbers of a sample");
            }
        }
    }

    #[test]
    fn what_shaders_are_promised_is_a_number_of_f32_within_limits() {
        for context in Context::all() {
            let bounds = context.row().bounds;
            let [least, most] = bounds.limits();
            assert!(least <= 0.0 && most > 0.0 && (most as f32).is_finite(), "{context:?}");
            assert_eq!(bounds.kept(f64::NAN), 0.0, "{context:?}");
            assert_eq!(bounds.kept(f64::INFINITY), most, "{context:?}");
            assert_eq!(bounds.kept(f64::NEG_INFINITY), least, "{context:?}");
            assert_eq!(bounds.kept(0.5), 0.5, "{context:?}");
        }
        let kept = ContextBounds::Clamped(2.0).kept_value(Value::vec(&[f64::NAN, 3.0, -0.5]));
        assert_eq!(kept, Value::vec(&[0.0, 2.0, -0.5]));
    }

    /// Bounds to which passes and functions of the library clamp are those that contexts promise.
    #[test]
    fn shaders_clamp_to_what_is_promised() {
        for (file, name, promised) in [
            ("curvature_map", "const MOST = 1e4;", MAX_CURVATURE),
            ("curvature", "@where |kappa| <= 1e4 : kappa", MAX_CURVATURE),
            ("screen", "const MOST_ON_SCREEN: f32 = 1e15;", MAX_ON_SCREEN),
        ] {
            let (text, _) = crate::wgsl::library_scans()
                .find(|(text, _)| text.contains(name))
                .unwrap_or_else(|| panic!("{file}.wgsl says no `{name}`"));
            assert!(!text.is_empty());
            let number = name.split([' ', ';']).find_map(|word| word.parse::<f64>().ok());
            assert_eq!(number, Some(promised), "{file}.wgsl: `{name}`");
            assert!(f64::from(promised as f32) <= promised, "{name}");
        }
    }
}
