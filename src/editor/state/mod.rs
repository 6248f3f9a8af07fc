//! State of the window, without egui: the open documents with their past, the view on them, the
//! selection, the compiled shaders, and the journals that keep unsaved work.

pub(crate) mod comparison;
pub(crate) mod compiling;
pub(crate) mod crashes;
pub(crate) mod display;
pub(crate) mod document;
pub(crate) mod fixes;
pub(crate) mod interface;
pub(crate) mod keying;
pub(crate) mod languages;
pub(crate) mod masks;
pub(crate) mod orbit;
pub(crate) mod painting;
pub(crate) mod parts;
pub(crate) mod paths;
pub(crate) mod picture_cost;
pub(crate) mod problem_text;
pub(crate) mod reading;
pub(crate) mod revision;
pub(crate) mod runs;
pub(crate) mod safety;
pub(crate) mod scene;
pub(crate) mod selection;
pub(crate) mod session;
pub mod settings;
pub(crate) mod shelf;
pub(crate) mod shot;
pub(crate) mod sketch;
pub(crate) mod snapshot;
pub(crate) mod solo;
pub(crate) mod stack;
pub(crate) mod variations;
pub(crate) mod view;
pub(crate) mod wedge;
pub(crate) mod wire;
pub(crate) mod worker;
