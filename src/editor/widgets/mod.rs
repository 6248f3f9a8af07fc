//! Parts of the interface that do not know the window's state: fields, rows, icons, the theme.

pub(crate) mod color;
pub(crate) mod confirm;
pub(crate) mod curve;
pub(crate) mod handle;
pub(crate) mod icon;
pub(crate) mod menu;
pub(crate) mod number;
mod number_text;
pub(crate) mod overflow;
pub(crate) mod pacing;
pub(crate) mod picker;
pub(crate) mod ramp;
pub(crate) mod rows;
pub(crate) mod spots;
pub(crate) mod text;
pub(crate) mod theme;
pub(crate) mod value;
