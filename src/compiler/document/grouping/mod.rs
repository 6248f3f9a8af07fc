//! Groups made of nodes and dissolved again, and parts of a graph as text for the clipboard: each
//! as one edit.
//!
//! All of it is said in [`Edit`](super::Edit)s, so that it is undone, journalled and checked as
//! everything else is. What exposes or keys an input follows it into a group and out of it.

mod dissolve;
mod fragment;
mod make;
mod targets;

pub use dissolve::{Dissolved, dissolve};
pub use fragment::{Pasted, copy_text, paste_text};
pub use make::{Grouped, group};
