//! A painted HCBTF: the document with its past, and the look that shows it.

pub(crate) mod home;
pub(crate) mod keeping;
pub(crate) mod look;
pub(crate) mod work;

/// State of the painting in a frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PaintingUpdate {
    /// True if the open look shows the painting.
    pub(crate) is_shown: bool,
    /// True if the sample at work is marked in the picture.
    pub(crate) is_marked: bool,
}
