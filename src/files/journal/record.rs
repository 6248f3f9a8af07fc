//! What the lines of a journal say.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::document::{Edit, HcbtfEdit, HistoryNumbers, SceneEdit, Step};

/// The version of the journal that this Chiaro writes, and the only one that it reads.
pub(super) const VERSION: u32 = 1;

/// One line. A journal is `begin`, what stood there then, `ready`, and from then on `ops` and
/// `window`.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", bound(deserialize = "E: Clone + Deserialize<'de>"))]
pub(super) enum Record<'a, E: Clone> {
    /// What the journal is of.
    Begin { version: u32, kind: Cow<'a, str>, numbers: HistoryNumbers, about: Cow<'a, About> },
    /// The text that the file held when it was read or saved last.
    Source { text: Cow<'a, str> },
    /// The document's image; of a large one the next part, several lines following each other.
    Document { image: Cow<'a, str> },
    /// Steps that can be taken back, oldest first; several lines follow each other.
    Done(Cow<'a, [Step<E>]>),
    /// Steps that can be repeated, the next one last.
    Undone(Cow<'a, [Step<E>]>),
    /// All of the above is there.
    Ready,
    /// What was done, at once.
    Ops(Cow<'a, [Op<E>]>),
    /// What the window wants back now, member by member in place of what [`About::window`] says.
    Window(Cow<'a, serde_json::Map<String, serde_json::Value>>),
    /// The window was closed as windows are.
    Closed,
}

/// One thing done to a document.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Op<E> {
    /// An edit, in the gesture that it belongs to.
    Edit {
        /// As given to [`History::apply_in`](crate::document::History::apply_in).
        #[serde(default, skip_serializing_if = "Option::is_none")]
        gesture: Option<u64>,
        /// What was applied.
        edit: E,
    },
    /// The last step was taken back.
    Undo,
    /// The step taken back last was repeated.
    Redo,
}

/// What a journal is of, for people and for taking it back.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct About {
    /// What people call the document.
    pub name: String,
    /// Its file, once there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<String>,
    /// Whether the file holds more than could be read.
    pub is_partial: bool,
    /// What else a window wants back, such as the mesh; the journal does not look at it.
    #[serde(skip_serializing_if = "serde_json::Value::is_null")]
    pub window: serde_json::Value,
}

/// What is done to looks.
pub type LookOp = Op<Edit>;
/// What is done to scenes.
pub type SceneOp = Op<SceneEdit>;
/// What is done to HCBTFs.
pub type HcbtfOp = Op<HcbtfEdit>;
