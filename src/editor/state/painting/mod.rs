//! An HCBTF that is painted: the document with its past, and the look that shows it.

pub(crate) mod home;
pub(crate) mod keeping;
pub(crate) mod look;
pub(crate) mod work;

/// What a frame finds out of what is painted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PaintingUpdate {
    /// Whether the open look shows it.
    pub(crate) is_shown: bool,
    /// Whether the sample at work is marked in the picture.
    pub(crate) is_marked: bool,
}
