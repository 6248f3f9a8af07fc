//! What an artist makes and keeps: looks and scenes, how they are read, edited and written.

mod look;
mod scene;
mod value;

pub use look::*;
pub use scene::*;
pub use value::*;
