//! Graphs as pictures: their measures, their colors, and SVG of them.
//!
//! The window's canvas takes the same measures and colors, so that a graph in a document or on a
//! web page is the one that artists know.

mod graph;
pub mod palette;
mod svg;

pub use graph::{graph_svg, node_svg, overlapping};
pub use palette::Palette;
pub use svg::escaped;

use crate::library::Type;

/// Size of plain text, in points.
pub const TEXT_SIZE: f32 = 13.0;
/// Width of a node, in points.
pub const NODE_WIDTH: f32 = 184.0;
/// Height of a node's title, in points.
pub const TITLE_HEIGHT: f32 = 26.0;
/// Height of a port's row, in points.
pub const ROW_HEIGHT: f32 = 20.0;
/// Height of a node's part below its last row, in points.
pub const NODE_FOOT: f32 = 6.0;
/// Radius of a socket, in points.
pub const SOCKET: f32 = 5.0;
/// Margin between a frame and its nodes, in points.
pub const FRAME_MARGIN: f32 = 16.0;
/// Height of a frame's title, in points.
pub const FRAME_TITLE: f32 = 28.0;
/// Padding between a note's edge and its text, in points.
pub const NOTE_PADDING: f32 = 9.0;

/// The height of a node with `rows` rows, in points.
pub fn node_height(rows: usize) -> f32 {
    TITLE_HEIGHT + ROW_HEIGHT * rows as f32 + NODE_FOOT
}

/// The middle of a row below a node's top, in points; outputs come first.
pub fn row_center(row: usize) -> f32 {
    TITLE_HEIGHT + ROW_HEIGHT * (row as f32 + 0.5) + 1.0
}

/// The distance that a wire runs level before it bends, for ends that are `run` points apart
/// horizontally. In points.
pub fn wire_reach(run: f32) -> f32 {
    (run.abs() * 0.5).clamp(30.0, 200.0)
}

/// Shape of a socket, so that types can be distinguished without color too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SocketShape {
    /// Circle, for numbers.
    Circle,
    /// Diamond, for vectors.
    Diamond,
    /// Square, for colors and stacks.
    Square,
    /// Triangle, for angles.
    Triangle,
    /// Hexagon, for lights.
    Hexagon,
}

const H: f32 = 0.866_025_4;
const CIRCLE: [(f32, f32); 12] = [
    (0.0, 1.0),
    (0.5, H),
    (H, 0.5),
    (1.0, 0.0),
    (H, -0.5),
    (0.5, -H),
    (0.0, -1.0),
    (-0.5, -H),
    (-H, -0.5),
    (-1.0, 0.0),
    (-H, 0.5),
    (-0.5, H),
];
const DIAMOND: [(f32, f32); 4] = [(0.0, 1.2), (1.2, 0.0), (0.0, -1.2), (-1.2, 0.0)];
const SQUARE: [(f32, f32); 4] = [(0.88, 0.88), (0.88, -0.88), (-0.88, -0.88), (-0.88, 0.88)];
const TRIANGLE: [(f32, f32); 3] = [(-0.9, -1.1), (1.2, 0.0), (-0.9, 1.1)];
const HEXAGON: [(f32, f32); 6] =
    [(1.1, 0.0), (0.55, 0.95), (-0.55, 0.95), (-1.1, 0.0), (-0.55, -0.95), (0.55, -0.95)];

impl SocketShape {
    /// The shape of a type's sockets.
    pub fn of(ty: &Type) -> Self {
        match ty {
            Type::Vec2 | Type::Vec3 | Type::Vec4 | Type::Mat3 => Self::Diamond,
            Type::Color | Type::Composite => Self::Square,
            Type::Angle => Self::Triangle,
            Type::Light => Self::Hexagon,
            _ => Self::Circle,
        }
    }

    /// The corners of the shape around its middle, at radius 1; no more than twelve.
    pub fn outline(self) -> &'static [(f32, f32)] {
        match self {
            Self::Circle => &CIRCLE,
            Self::Diamond => &DIAMOND,
            Self::Square => &SQUARE,
            Self::Triangle => &TRIANGLE,
            Self::Hexagon => &HEXAGON,
        }
    }
}
