//! Colors of graphs, dark and light: 0xrrggbb, as they are shown.

use crate::library::{CATEGORIES, Type};

/// A set of colors for graphs.
#[derive(Debug)]
pub struct Palette {
    /// Ground of the canvas.
    pub canvas: u32,
    /// Body of a node.
    pub node: u32,
    /// Edge of a node.
    pub node_edge: u32,
    /// Edge around a color, so that a color like its ground is seen.
    pub swatch_edge: u32,
    /// Plain text.
    pub text: u32,
    /// Text of less weight.
    pub dim: u32,
    /// Frame that has no color of its own.
    pub frame: u32,
    /// Note that has no color of its own.
    pub note: u32,
    types: Types,
    /// Colors of titles, in the order of [`CATEGORIES`]; that of any other category comes last.
    categories: [u32; CATEGORIES.len() + 1],
}

#[derive(Debug)]
struct Types {
    float: u32,
    int: u32,
    bool: u32,
    vector: u32,
    color: u32,
    composite: u32,
    angle: u32,
    light: u32,
    curve: u32,
    other: u32,
}

impl Palette {
    /// The color of a type's sockets and wires.
    pub fn of_type(&self, ty: &Type) -> u32 {
        let types = &self.types;
        match ty {
            Type::Float => types.float,
            Type::Int => types.int,
            Type::Bool => types.bool,
            Type::Vec2 | Type::Vec3 | Type::Vec4 | Type::Mat3 => types.vector,
            Type::Color => types.color,
            Type::Composite => types.composite,
            Type::Angle => types.angle,
            Type::Light => types.light,
            Type::Curve | Type::Ramp => types.curve,
            _ => types.other,
        }
    }

    /// The color of a category's titles.
    pub fn of_category(&self, category: &str) -> u32 {
        let index =
            CATEGORIES.iter().position(|name| *name == category).unwrap_or(CATEGORIES.len());
        self.categories[index]
    }

    /// The colors of all types.
    pub fn types(&self) -> [u32; 10] {
        let Types { float, int, bool, vector, color, composite, angle, light, curve, other } =
            self.types;
        [float, int, bool, vector, color, composite, angle, light, curve, other]
    }

    /// The colors of all categories' titles.
    pub fn categories(&self) -> &[u32] {
        &self.categories
    }
}

/// Dark palette: a calm dark ground.
pub static DARK: Palette = Palette {
    canvas: 0x18191c,
    node: 0x2c2e33,
    node_edge: 0x101113,
    swatch_edge: 0x5c5e64,
    text: 0xdeddd9,
    dim: 0x919296,
    frame: 0x3e4046,
    note: 0xe9c45c,
    types: Types {
        float: 0xb0b4bc,
        int: 0x7eb296,
        bool: 0xd68cac,
        vector: 0x7c92e8,
        color: 0xe8c854,
        composite: 0xee9242,
        angle: 0x5cc2b6,
        light: 0xfaeec4,
        curve: 0xbe8ce0,
        other: 0x968a7e,
    },
    categories: [
        0x744c2c, 0x6e6032, 0x3e5c3e, 0x30585c, 0x684252, 0x424874, 0x444c5a, 0x5c4040, 0x6c5a4c,
        0x5a4670, 0x46603a, 0x2f5a4c, 0x6a4a3a, 0x3c5468, 0x4a4a4e,
    ],
};

/// Light palette: paper.
pub static LIGHT: Palette = Palette {
    canvas: 0xe2dfd9,
    node: 0xfaf9f7,
    node_edge: 0xb3aea4,
    swatch_edge: 0x9d988e,
    text: 0x24231f,
    dim: 0x66635c,
    frame: 0xc6c1b8,
    note: 0x7f5f00,
    types: Types {
        float: 0x6d717a,
        int: 0x3a8560,
        bool: 0xb0507c,
        vector: 0x4760cc,
        color: 0xa67f00,
        composite: 0xd06a10,
        angle: 0x16897c,
        light: 0x9c8128,
        curve: 0x8e4fbe,
        other: 0x857868,
    },
    categories: [
        0xe9c3a0, 0xe4d79f, 0xbcd8b8, 0xb0d6d9, 0xe6c1cf, 0xc5caec, 0xc9d0da, 0xe3c4c2, 0xe4cfba,
        0xd8c8e8, 0xcadcb4, 0xb4dccb, 0xe8cdb8, 0xbcd2e4, 0xd2cfca,
    ],
};
