//! Grouping: groups are made of nodes and dissolved again, and parts of a graph become text for the
//! clipboard, each as one edit.
//!
//! Every change is made of [`Edit`](super::Edit)s, so that it is undone, journaled and checked as
//! any other. Keys and exposed parameters follow their inputs into a group and out of it.

mod dissolve;
mod fragment;
mod make;
mod targets;

pub use dissolve::{DissolvedGroup, dissolve};
pub use fragment::{PastedFragment, copy_text, paste_text};
pub use make::{NewGroup, OfferedValue, group, group_with_values};
