//! Records that the lines of a journal hold.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::document::{Edit, HcbtfEdit, HistoryNumbers, SceneEdit, ShotEdit, Step};

/// Version of the journal that this Chiaro writes, and the only one that it reads.
pub(super) const VERSION: u32 = 1;

/// Content of one line. A journal consists of `begin`, the records of the state at that time,
/// `ready`, and from then on `ops` and `window`.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", bound(deserialize = "E: Clone + Deserialize<'de>"))]
pub(super) enum Record<'a, E: Clone> {
    /// Subject of the journal.
    Begin {
        version: u32,
        kind: Cow<'a, str>,
        numbers: HistoryNumbers,
        about: Cow<'a, DocumentInfo>,
    },
    /// Text of the document's file when it was read or saved last.
    Source { text: Cow<'a, str> },
    /// Image of the document; a large image is split over several lines that follow each other.
    Document { image: Cow<'a, str> },
    /// Steps that can be undone, oldest first; several lines follow each other.
    Done(Cow<'a, [Step<E>]>),
    /// Steps that can be redone, the next one last.
    Undone(Cow<'a, [Step<E>]>),
    /// Mark that all of the above is there.
    Ready,
    /// Operations that were done at once.
    Ops(Cow<'a, [Op<E>]>),
    /// State that the window wants back, member by member in place of those of
    /// [`DocumentInfo::window`].
    Window(Cow<'a, serde_json::Map<String, serde_json::Value>>),
    /// Mark that the window was closed normally.
    Closed,
}

/// Operation on a document.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Op<E> {
    /// Edit, in the gesture that it belongs to.
    Edit {
        /// Gesture as given to [`History::apply_in`](crate::document::History::apply_in).
        #[serde(default, skip_serializing_if = "Option::is_none")]
        gesture: Option<u64>,
        /// Edit that was applied.
        edit: E,
    },
    /// Undo of the last step.
    Undo,
    /// Redo of the step that was undone last.
    Redo,
}

/// Description of a journal's document, for people and for restoring the window.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct DocumentInfo {
    /// Name of the document as people read it.
    pub name: String,
    /// Path of the document's file; `None` before it is first saved.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<String>,
    /// True if the file holds more than could be read.
    pub is_partial: bool,
    /// Other state that the window wants back, such as the mesh; the journal does not look at it.
    #[serde(skip_serializing_if = "serde_json::Value::is_null")]
    pub window: serde_json::Value,
}

/// Operation on a look.
pub type LookOp = Op<Edit>;
/// Operation on a scene.
pub type SceneOp = Op<SceneEdit>;
/// Operation on a shot.
pub type ShotOp = Op<ShotEdit>;
/// Operation on an HCBTF.
pub type HcbtfOp = Op<HcbtfEdit>;
