//! Built-in shapes to judge a look on: each of known curvature or of many kinds of it.
//!
//! All but the plane, the waves and the city are closed; all lie within about 1.5 units of the
//! origin, y up, the front towards +z. Shapes are made once, at first use, from formulas alone, so
//! they are the same everywhere; the program keeps those that take long.

mod blob;
mod city;
mod creature;
mod cube;
mod curve;
mod nets;
mod revolve;
mod sculpture;
mod sweep;
mod uv;

use std::convert::Infallible;
use std::sync::OnceLock;

use chiaro_locale::{Text, text};

use super::build::build;
use super::mesh::Mesh;
use super::normals::CREASE_ANGLE;
use super::soup::TriangleSoup;
use crate::cache;

/// A built-in shape.
#[derive(Clone, Copy, Debug)]
pub struct OwnShape {
    /// Name of the shape in documents, after `shape:`.
    pub name: &'static str,
    /// Name of the shape for people.
    pub label: Text,
    /// Use of the shape, in a sentence.
    pub help: Text,
    /// Function that makes the shape.
    make: fn() -> TriangleSoup,
}

/// All built-in shapes, in the order of menus.
pub const SHAPES: &[OwnShape] = &[
    OwnShape {
        name: "sphere",
        label: text!("Sphere"),
        help: text!("Every direction once and one curvature: the plainest view of a look."),
        make: revolve::sphere,
    },
    OwnShape {
        name: "torus",
        label: text!("Torus"),
        help: text!("Curved outwards outside and like a saddle inside."),
        make: revolve::torus,
    },
    OwnShape {
        name: "blob",
        label: text!("Blob"),
        help: text!("Balls run together: convex lobes with soft hollows between them."),
        make: || uv::spherical(&nets::polygonize(&blob::sculpture(), blob::CELLS)),
    },
    OwnShape {
        name: "knot",
        label: text!("Knot"),
        help: text!("A trefoil tube that passes over and under itself."),
        make: sweep::knot,
    },
    OwnShape {
        name: "creature",
        label: text!("Creature"),
        help: text!(
            "A seated cub with brows, eyes, mouth, ears and folds: a character with real \
               hollows."
        ),
        make: || uv::boxed(&nets::polygonize(&creature::sculpture(), creature::CELLS)),
    },
    OwnShape {
        name: "cube",
        label: text!("Rounded cube"),
        help: text!("Flat faces between rounded edges: where curvature is nothing, or high."),
        make: cube::cube,
    },
    OwnShape {
        name: "vase",
        label: text!("Vase"),
        help: text!("A thin wall, hollow inside, with a lip and a foot."),
        make: revolve::vase,
    },
    OwnShape {
        name: "plane",
        label: text!("Plane"),
        help: text!("A flat square, for textures and thresholds."),
        make: cube::plane,
    },
    OwnShape {
        name: "waves",
        label: text!("Waves"),
        help: text!(
            "A flat square in waves, for painted surfaces: every tile is lit and seen from \
               somewhere else."
        ),
        make: cube::waves,
    },
    OwnShape {
        name: "ball",
        label: text!("Ball"),
        help: text!("A sphere of 400 triangles, beside the waves in the thesis's test scene."),
        make: revolve::ball,
    },
    OwnShape {
        name: "city",
        label: text!("City"),
        help: text!(
            "2,785 houses between streets, with whole repeats of a tile on every wall: 27,860 \
               triangles."
        ),
        make: city::city,
    },
];

/// The shape of that name; made at first use, then copied.
pub fn shape(name: &str) -> Option<Mesh> {
    static MADE: [OnceLock<Mesh>; SHAPES.len()] = [const { OnceLock::new() }; SHAPES.len()];
    let index = SHAPES.iter().position(|shape| shape.name == name)?;
    let make = || -> Result<Mesh, Infallible> {
        let mut soup = (SHAPES[index].make)();
        SHAPES[index].name.clone_into(&mut soup.name);
        Ok(build(soup, CREASE_ANGLE).0)
    };
    if let Some(made) = MADE[index].get() {
        return Some(made.clone());
    }
    // Made before anybody is let wait for it: making is spread over rayon's threads, which would
    // wait for it too. Another thread may have been first; its mesh is the same.
    let Ok(mesh) = cache::cached("shape", &name, make);
    Some(MADE[index].get_or_init(|| mesh).clone())
}
