//! Motion of meshes: what a glTF file says of how its surface moves, and the surface at a time.
//!
//! A [`Motion`] holds the nodes of the file with the curves that move them, its skins, the targets
//! of its morphs and its cameras, and the surface as the file has it, before anything moved it.
//! [`Motion::pose`] gives the matrices and weights at a time, which take microseconds to compute
//! and to compare; [`Mesh::posed`](super::Mesh::posed) deforms the surface by them, which takes
//! milliseconds. Both are in f64.
//!
//! The mesh that a file gives without an animation is the mesh *at rest*: nodes stand as the file
//! places them, skins and morphs are applied so. What depends on a surface alone is made of it
//! once, and kept for all poses: vertices, triangles, the vertices that share a made normal or
//! tangent, and the places to which marks stick.

mod curve;
mod pose;
mod surface;

use std::ops::Range;

use glam::{DMat4, DQuat, DVec3};

use super::mesh::Mesh;
pub(super) use curve::{Curve, KeyInterpolation};
pub use pose::Pose;
pub(super) use surface::{MovedPoints, PointChange, VertexSource, VertexSources};

/// Motion of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// Nodes by their numbers in the file.
    pub(super) nodes: Vec<MovedNode>,
    /// Numbers of the nodes, each after its parent.
    pub(super) order: Vec<u32>,
    pub(super) skins: Vec<Skin>,
    pub(super) parts: Vec<MovedPart>,
    pub(super) points: MovedPoints,
    pub(super) animations: Vec<Animation>,
    pub(super) cameras: Vec<NodeCamera>,
    /// Vertices of the mesh, as far as they are made of points.
    pub(super) sources: VertexSources,
}

/// Node of a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MovedNode {
    pub(super) parent: Option<u32>,
    /// Transform to the parent's space, as a whole; `None` where its parts tell it.
    pub(super) matrix: Option<DMat4>,
    pub(super) translation: DVec3,
    pub(super) rotation: DQuat,
    pub(super) scale: DVec3,
    /// Weights of the morph targets of the node's mesh.
    pub(super) weights: Vec<f64>,
}

/// Joints of a skin.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Skin {
    /// Nodes, each with the matrix from the mesh's space to the node's own as the mesh was bound.
    pub(super) joints: Vec<(u32, DMat4)>,
}

/// Points of one primitive in one place.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct MovedPart {
    pub(super) points: Range<u32>,
    /// Node that has the mesh.
    pub(super) node: u32,
    /// Transform from the mesh's space to the node's.
    pub(super) instance: DMat4,
    /// Number of the skin, which places the points instead of the node.
    pub(super) skin: Option<u32>,
    /// Targets of the part's morphs, in [`MovedPoints`].
    pub(super) targets: Range<u32>,
}

/// Animation of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Animation {
    /// Name of the animation; `animation_` and its number where the file has none.
    pub name: String,
    pub(super) channels: Vec<Channel>,
}

impl Animation {
    /// The time of the last key, in seconds.
    pub fn seconds(&self) -> f64 {
        self.channels.iter().map(|channel| channel.curve.end()).fold(0.0, f64::max)
    }

    /// Times of all keys, in seconds, each once and in increasing order.
    pub fn key_times(&self) -> Vec<f64> {
        self.key_times_of(|_| true)
    }

    /// Times of the keys of some channels.
    fn key_times_of(&self, is_it: impl Fn(&Channel) -> bool) -> Vec<f64> {
        let channels = self.channels.iter().filter(|channel| is_it(channel));
        let mut times: Vec<f64> = channels.flat_map(|channel| channel.curve.times()).collect();
        times.sort_unstable_by(f64::total_cmp);
        times.dedup();
        times
    }
}

/// Curve that moves one part of a node.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Channel {
    pub(super) node: u32,
    pub(super) property: NodeProperty,
    pub(super) curve: Curve,
}

/// Part of a node that curves move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NodeProperty {
    Translation,
    Rotation,
    Scale,
    Weights,
}

/// Camera of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeCamera {
    /// Name of the camera, or else of its node; `camera_` and its number where neither has one.
    pub name: String,
    pub(super) node: u32,
    /// Projection of the camera.
    pub lens: CameraLens,
}

/// Projection of a file's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CameraLens {
    /// Vertical field of view in radians, and width over height, 0 where the file leaves it open.
    Perspective {
        /// Vertical field of view, in radians.
        fov: f64,
        /// Width over height; 0 for any.
        aspect: f64,
    },
    /// Half of the picture's width and height, in the file's units.
    Orthographic {
        /// Half of the width, in the file's units.
        half_width: f64,
        /// Half of the height, in the file's units.
        half_height: f64,
    },
}

impl Motion {
    /// The animations, in the file's order.
    pub fn animations(&self) -> &[Animation] {
        &self.animations
    }

    /// The cameras, in the file's order.
    pub fn cameras(&self) -> &[NodeCamera] {
        &self.cameras
    }

    /// The lens and the node of the camera of a name, of the first camera for an empty name.
    pub fn camera(&self, name: &str) -> Option<(CameraLens, u32)> {
        let mut cameras = self.cameras.iter();
        let camera = cameras.find(|camera| name.is_empty() || camera.name == name)?;
        Some((camera.lens, camera.node))
    }

    /// Times of the keys of an animation that move a node or a node above it, in seconds, each once
    /// and in increasing order.
    pub fn key_times(&self, animation: &Animation, node: u32) -> Vec<f64> {
        let parent = |node: &u32| self.nodes.get(*node as usize)?.parent;
        // As many nodes as there are, whatever their parents say.
        let line = std::iter::successors(Some(node), parent).take(self.nodes.len());
        let moved: Vec<u32> = line.collect();
        animation.key_times_of(|channel| moved.contains(&channel.node))
    }

    /// True if anything of it can be asked for.
    pub(super) fn is_used(&self) -> bool {
        self.moves_surface() || !self.cameras.is_empty()
    }

    /// The motion of a mesh whose vertices are made of these points.
    pub(super) fn of_mesh(self, mesh: &Mesh, sources: &[VertexSource]) -> Self {
        if !self.moves_surface() {
            return Self { points: MovedPoints::default(), parts: Vec::new(), ..self };
        }
        let sources = VertexSources::new(mesh, sources, &self.points.tangents);
        Self { sources, ..self }
    }

    /// True if something moves the surface.
    pub fn moves_surface(&self) -> bool {
        !self.animations.is_empty() && !self.parts.is_empty()
    }
}
