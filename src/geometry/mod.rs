//! Meshes: import, tangents, own shapes.
