//! Pictures that are compared with each other: of the look, of its other states, and files.

use std::path::{Path, PathBuf};

use chiaro_locale::tr;

use crate::document::Tier;
use crate::state::reading::tier_label;
use crate::state::shelf::{SnapshotId, SnapshotShelf};

/// Picture that is compared with another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum ComparedPicture {
    /// The look as it is.
    Present,
    /// The look in f64.
    Truth,
    Tier(Tier),
    Snapshot(SnapshotId),
    /// The look as its own file has it.
    Saved,
    /// Look in another file.
    LookFile(PathBuf),
    /// Image in a file, fitted into the picture.
    Image(PathBuf),
}

impl ComparedPicture {
    /// Pictures that need no more than the look.
    pub(crate) const OF_LOOK: [Self; 4] =
        [Self::Truth, Self::Tier(Tier::Exact), Self::Tier(Tier::Balanced), Self::Tier(Tier::Fast)];

    /// Name of the picture, before the snapshots of the look.
    pub(crate) fn label(&self, shelf: &SnapshotShelf) -> String {
        let file = |path: &Path| {
            let name = path.file_name().unwrap_or(path.as_os_str());
            name.to_string_lossy().into_owned()
        };
        match self {
            Self::Present => tr!("As set").to_owned(),
            Self::Truth => tr!("Truth (f64)").to_owned(),
            Self::Tier(tier) => tier_label(*tier).to_owned(),
            Self::Snapshot(id) => shelf
                .of(*id)
                .map_or(tr!("A deleted snapshot"), |snapshot| &snapshot.name)
                .to_owned(),
            Self::Saved => tr!("As saved").to_owned(),
            Self::LookFile(path) | Self::Image(path) => file(path),
        }
    }

    /// File that the picture is of.
    pub(crate) fn file<'p>(&'p self, own: Option<&'p Path>) -> Option<&'p Path> {
        match self {
            Self::Saved => own,
            Self::LookFile(path) | Self::Image(path) => Some(path),
            _ => None,
        }
    }
}
