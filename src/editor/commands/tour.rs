//! Tours that a newcomer can take.

/// Topic of a tour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TourTopic {
    /// A first look, from nothing.
    Look,
    /// A gray scene that is lit: lights, links, shadows, the mixer.
    Lights,
}
