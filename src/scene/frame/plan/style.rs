//! Styles of plans: what is drawn fast, and the truth.

use super::planner::Planner;
use crate::compile::Live;
use crate::frame::assets::Assets;
use crate::frame::visibility::CullMode;

/// Style of a plan; every executor draws plans of every style.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PlanStyle {
    /// Known values folded, and parts left out that cannot change the picture.
    #[default]
    Specialized,
    /// Looks compiled as they are written, with every value in f64: the truth.
    AsWritten,
}

impl PlanStyle {
    /// A planner of this style, with a reader that may have read assets already.
    pub fn planner(self, assets: Assets) -> Planner {
        match self {
            Self::Specialized => Planner::new(assets),
            Self::AsWritten => {
                Planner { unspecialized: true, cull: CullMode::Objects, ..Planner::new(assets) }
            }
        }
    }

    /// The values that stay uniforms in plans of this style.
    pub fn live(self) -> Live {
        match self {
            Self::Specialized => Live::Keyed,
            Self::AsWritten => Live::All,
        }
    }
}
