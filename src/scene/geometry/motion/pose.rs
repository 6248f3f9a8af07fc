//! Pose: where an animation has its nodes at a time, and how much of each morph there is.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};

use glam::{DMat4, DQuat, DVec3};

use super::{Animation, Motion, MovedNode, NodeProperty};

/// Matrices and weights of a motion at a time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pose {
    /// Transform of each node, from its own space to the scene's.
    pub(super) nodes: Vec<DMat4>,
    /// Matrices of each skin's joints, from the mesh's space as it was bound to the scene's.
    pub(super) skins: Vec<Vec<DMat4>>,
    /// Weights of the morph targets of each node's mesh.
    pub(super) weights: Vec<Vec<f64>>,
}

impl Motion {
    /// The pose at a time of an animation in seconds, or at rest.
    pub fn pose(&self, animation: Option<(&Animation, f64)>) -> Pose {
        let mut locals: Vec<MovedNode> = self.nodes.clone();
        let mut value = Vec::new();
        let channels = animation.iter().flat_map(|(animation, _)| &animation.channels);
        let time = animation.map_or(0.0, |(_, time)| time);
        for channel in channels {
            let Some(node) = locals.get_mut(channel.node as usize) else { continue };
            if channel.property == NodeProperty::Rotation {
                node.rotation = channel.curve.rotation(time).unwrap_or(node.rotation);
            } else {
                channel.curve.value(time, &mut value);
            }
            let vector = || <[f64; 3]>::try_from(value.as_slice()).ok().map(DVec3::from);
            match channel.property {
                NodeProperty::Translation => node.translation = vector().unwrap_or_default(),
                NodeProperty::Scale => node.scale = vector().unwrap_or(DVec3::ONE),
                NodeProperty::Weights => {
                    node.weights.iter_mut().zip(&value).for_each(|(own, new)| *own = *new);
                }
                NodeProperty::Rotation => {}
            }
            if channel.property != NodeProperty::Weights {
                node.matrix = None;
            }
        }
        let mut nodes = vec![DMat4::IDENTITY; locals.len()];
        for &number in &self.order {
            let node = &locals[number as usize];
            let parent = node.parent.map_or(DMat4::IDENTITY, |parent| nodes[parent as usize]);
            nodes[number as usize] = parent * node.local();
        }
        let joint = |(node, bind): &(u32, DMat4)| {
            nodes.get(*node as usize).map_or(DMat4::IDENTITY, |node| *node * *bind)
        };
        let skins = self.skins.iter().map(|skin| skin.joints.iter().map(joint).collect());
        Pose {
            skins: skins.collect(),
            weights: locals.into_iter().map(|n| n.weights).collect(),
            nodes,
        }
    }

    /// The hash of what a pose makes of the surface: poses of equal hashes are the same surface.
    pub fn surface_hash(&self, pose: &Pose) -> u64 {
        let mut hasher = DefaultHasher::new();
        let mut matrix = |matrix: &DMat4| {
            matrix.to_cols_array().map(f64::to_bits).hash(&mut hasher);
        };
        let mut used: Vec<u32> = self.parts.iter().filter_map(|part| part.skin).collect();
        used.dedup();
        let skins = used.iter().filter_map(|skin| pose.skins.get(*skin as usize));
        skins.flatten().for_each(&mut matrix);
        let rigid = self.parts.iter().filter(|part| part.skin.is_none());
        rigid.filter_map(|part| pose.nodes.get(part.node as usize)).for_each(&mut matrix);
        for part in self.parts.iter().filter(|part| !part.targets.is_empty()) {
            let weights = pose.weights.get(part.node as usize);
            weights.into_iter().flatten().for_each(|weight| weight.to_bits().hash(&mut hasher));
        }
        hasher.finish()
    }
}

impl Pose {
    /// The transform of a node, from its own space to the file's scene.
    pub fn node(&self, number: u32) -> DMat4 {
        self.nodes.get(number as usize).copied().unwrap_or(DMat4::IDENTITY)
    }
}

impl MovedNode {
    /// The transform to the parent's space.
    fn local(&self) -> DMat4 {
        self.matrix.unwrap_or_else(|| {
            DMat4::from_scale_rotation_translation(self.scale, self.rotation, self.translation)
        })
    }
}

impl Default for MovedNode {
    fn default() -> Self {
        Self {
            parent: None,
            matrix: None,
            translation: DVec3::ZERO,
            rotation: DQuat::IDENTITY,
            scale: DVec3::ONE,
            weights: Vec::new(),
        }
    }
}
