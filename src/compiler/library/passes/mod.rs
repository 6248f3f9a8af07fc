//! Passes of a frame, in the order in which they are drawn.
//!
//! A [`PassId`] is a handle to a row of one [table](table). The row gives the pass's work, inputs,
//! outputs and purpose; plans, renderers, the reference, exports, costs and reports ask the row,
//! and none of them tells passes apart in any other way. A look reads a pass through the
//! [context](super::Context) whose row names the pass.

mod row;
mod table;

use std::fmt;

pub use row::{
    PassInput, PassOutput, PassRow, PassWork, ScreenExtent, Stage, StageRow, StageValue,
    TexelFormat,
};

use super::context::is_same;
use table::TABLE;

/// Pass of the table; passes are ordered as their rows are, each after those that it reads.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PassId(u8);

impl PassId {
    /// Pass that draws the looks themselves: the picture.
    pub const LOOK: Self = Self::named("draw");

    /// Pass that draws a scene's outlines over the picture.
    pub const OUTLINES: Self = Self::named("outlines");

    /// Pass with a slug, looked up when Chiaro is compiled.
    ///
    /// # Panics
    /// Where no row has the slug; use [`from_slug`](Self::from_slug) for slugs that are read.
    pub const fn named(slug: &str) -> Self {
        let mut index = 0;
        while index < TABLE.len() {
            if is_same(TABLE[index].slug.as_bytes(), slug.as_bytes()) {
                return Self(index as u8);
            }
            index += 1;
        }
        panic!("no row of the table of passes has this slug")
    }

    /// All passes, each after those that it reads.
    pub fn all() -> impl DoubleEndedIterator<Item = Self> {
        (0..TABLE.len()).map(|index| Self(index as u8))
    }

    /// Pass with a slug.
    pub fn from_slug(slug: &str) -> Option<Self> {
        Self::all().find(|pass| pass.row().slug == slug)
    }

    /// Pass that draws meshes with the looks' modules of a stage.
    pub fn of_stage(stage: Stage) -> Option<Self> {
        Self::all().find(|pass| pass.stage() == Some(stage))
    }

    /// Row of the pass, with all its properties.
    pub fn row(self) -> &'static PassRow {
        &TABLE[usize::from(self.0)]
    }

    /// Label for drivers, tools and hashes.
    pub fn label(self) -> &'static str {
        self.row().label.english()
    }

    /// Label that people read.
    pub fn title(self) -> &'static str {
        self.row().label.tr()
    }

    /// Stage of the looks' modules that the pass draws meshes with; `None` where the pass draws
    /// over the whole picture.
    pub fn stage(self) -> Option<Stage> {
        match self.row().work {
            PassWork::Meshes(stage) => Some(stage),
            PassWork::Screen { .. } | PassWork::Lights { .. } => None,
        }
    }

    /// True if the pass draws over the whole picture, with its one module of `shaders/passes`.
    pub fn is_screen(self) -> bool {
        matches!(self.row().work, PassWork::Screen { .. })
    }

    /// True if the pass draws what lights see, a layer for each light.
    pub fn is_of_lights(self) -> bool {
        matches!(self.row().work, PassWork::Lights { .. })
    }

    /// Pixels at which a pass over the picture may result in more than 0; `None` for others.
    pub fn extent(self) -> Option<ScreenExtent> {
        match self.row().work {
            PassWork::Screen { extent, .. } => Some(extent),
            PassWork::Meshes(_) | PassWork::Lights { .. } => None,
        }
    }

    /// True if the pass is laid over the picture when the looks are drawn.
    pub fn is_over(self) -> bool {
        self.extent() == Some(ScreenExtent::Picture)
    }

    /// True if the pass draws the picture.
    pub fn writes_picture(self) -> bool {
        self.row().writes_picture()
    }

    /// True if the pass reads a result of `other`.
    pub fn reads(self, other: Self) -> bool {
        self.row().reads.iter().any(|input| input.pass == other.row().slug)
    }

    /// Pass over meshes that draws the surface from which the pass is made; `None` for a pass over
    /// meshes.
    pub fn surface(self) -> Option<Self> {
        if !self.is_screen() {
            return None;
        }
        let mut read = self.row().reads.iter().filter_map(|input| Self::from_slug(input.pass));
        read.find(|pass| pass.stage().is_some())
    }

    /// Distance between a pixel and the farthest pixel of meshes that it depends on, in steps of
    /// 1/800 of the picture's height.
    pub fn reach(self) -> u32 {
        let before = self.row().reads.iter().filter_map(|input| Self::from_slug(input.pass));
        self.own_reach() + before.map(Self::reach).max().unwrap_or_default()
    }

    /// Distance around a pixel that the pass itself reads in its inputs, in the same steps.
    pub fn own_reach(self) -> u32 {
        match self.row().work {
            PassWork::Meshes(_) | PassWork::Lights { .. } => 0,
            PassWork::Screen { reach, .. } => reach,
        }
    }
}

impl fmt::Debug for PassId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "PassId({})", self.row().slug)
    }
}

impl serde::Serialize for PassId {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.label().replace(' ', "-"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Context;

    #[test]
    fn every_row_is_whole() {
        for pass in PassId::all() {
            let row = pass.row();
            assert_eq!(PassId::from_slug(row.slug), Some(pass), "{pass:?} twice");
            assert!(!row.label.english().is_empty() && !row.help.is_empty(), "{pass:?}");
            assert!(!row.writes.is_empty(), "{pass:?} writes nothing");
            for input in row.reads {
                let read = PassId::from_slug(input.pass);
                assert!(read.is_some_and(|read| read < pass), "{pass:?} reads `{}`", input.pass);
                let mut written = read.iter().flat_map(|read| read.row().writes);
                assert!(written.any(|output| output.name == input.output), "{pass:?}: {input:?}");
            }
            let is_served = Context::all().any(|context| context.pass() == Some(pass));
            let is_read = PassId::all().any(|other| other.reads(pass));
            let is_shown = pass == PassId::LOOK || pass.is_over();
            assert!(is_served || is_read || is_shown, "nobody reads {pass:?}");
            assert_eq!(pass.surface().is_some(), pass.is_screen(), "{pass:?}");
            assert!(!pass.is_of_lights() || pass.own_reach() == 0, "{pass:?}");
            assert!(!is_served || !row.map.is_empty(), "{pass:?}: a look reads it by what name?");
        }
        assert!(TABLE.len() < usize::from(u8::MAX));
        assert_eq!(PassId::all().next_back(), Some(PassId::LOOK));
        assert!(PassId::all().all(|pass| pass.writes_picture() == (pass == PassId::LOOK)));
        for stage in
            [Stage::Draw, Stage::Normals, Stage::DetailNormals, Stage::Facets, Stage::HiddenFacets]
        {
            assert!(
                stage.draws_meshes() && stage.draws_normals() != stage.is_picture(),
                "{stage:?}"
            );
        }
        assert!(!Stage::Eval.draws_meshes(), "samples are of no pass");
    }

    #[test]
    fn levels_look_ever_farther_around() {
        let reach = |slug| PassId::named(slug).reach();
        let smooth = ["smooth_normals_1", "smooth_normals_2", "smooth_normals_3"].map(reach);
        assert_eq!(smooth, [2, 6, 14]);
        assert_eq!([reach("normals"), reach("curvature"), reach("draw")], [0, 3, 0]);
    }
}
