//! Meshes: import, normals, tangents, built-in shapes.
//!
//! A file's bytes become a `soup::TriangleSoup` (points and corners as the file has them:
//! `import/`, one reader a format); `build` turns the soup into a [`Mesh`] that a GPU can draw:
//! degenerate triangles dropped, missing normals made (`normals`), corners joined to vertices
//! (`vertices`), tangents made or kept (`tangents`), triangles sorted by material. The built-in
//! shapes (`shapes`) go the same way from formulas.

mod build;
mod closed;
mod import;
mod map;
mod maps;
mod mesh;
mod motion;
mod normals;
mod shapes;
mod soup;
mod tangents;
mod tree;
mod triangulate;
mod vertices;

pub use import::{
    MAX_FILE_BYTES, MAX_TRIANGLES, MAX_VERTICES, Siblings, import, load, load_image, no_siblings,
};

pub use maps::{MapSource, MaterialMap, MaterialMaps, WITHIN};
pub use mesh::{Bounds, DEFAULT_MATERIAL, FitTransform, LazyTree, Mesh, MeshPart};
pub use motion::{Animation, CameraLens, Motion, NodeCamera, Pose};
pub use normals::CREASE_ANGLE;
pub use shapes::{OwnShape, SHAPES, shape};
pub use tree::{BoxNode, MeshTree, tree_of_boxes};
