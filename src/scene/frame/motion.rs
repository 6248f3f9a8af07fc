//! Motion of a setup: meshes in the poses of a time, and cameras of their files.

use std::borrow::Cow;
use std::collections::VecDeque;
use std::sync::{Arc, Weak};

use glam::{DMat4, DVec3};

use super::setup::{Setup, SetupObject};
use crate::document::{Camera, MeshAnimation, Projection};
use crate::geometry::{CameraLens, Mesh, Pose};

/// Greatest memory of the deformed meshes that are kept, with what a device holds of them, in
/// bytes, and their greatest number; the last is always kept.
const MOST_BYTES: usize = 128 << 20;
const MOST_MESHES: usize = 256;

/// Sizes of a mesh that it takes while it is kept: its own, and on the device, as long as somebody
/// holds the mesh, that of its buffers, and of textures of them where a look is deferred.
const SIZES_OF_MESH: usize = 3;

/// Animation of a mesh that an object plays.
#[derive(Clone, Debug, PartialEq)]
pub struct PlayedAnimation {
    /// Number of the animation in the mesh's motion.
    pub number: usize,
    /// Speed, start and end.
    pub played: MeshAnimation,
}

impl PlayedAnimation {
    /// The time in the animation at a time of the scene, in seconds.
    fn time_at(&self, time: f64, seconds: f64) -> f64 {
        let MeshAnimation { speed, offset, loops, .. } = self.played;
        let at = offset + time * speed;
        match loops {
            true if seconds > 0.0 => at.rem_euclid(seconds),
            _ => at.clamp(0.0, seconds),
        }
    }
}

impl SetupObject {
    /// The pose of the object's mesh at a time in seconds; `None` where nothing moves it.
    fn pose(&self, time: f64) -> Option<Pose> {
        let played = self.animation.as_ref()?;
        let motion = self.mesh.motion.as_ref()?;
        let animation = motion.animations().get(played.number)?;
        Some(motion.pose(Some((animation, played.time_at(time, animation.seconds())))))
    }
}

/// Deformed meshes of the last pictures, the last one first.
#[derive(Debug, Default)]
pub(super) struct KnownPoses(VecDeque<PosedMesh>);

#[derive(Debug)]
struct PosedMesh {
    /// Mesh at rest, by which the pose's hash means something.
    rest: Weak<Mesh>,
    hash: u64,
    mesh: Arc<Mesh>,
}

impl KnownPoses {
    /// The setup at a time in seconds, moved by the shot over it: objects that play an animation
    /// have their meshes in its pose. Where nothing moves it is the setup as it is.
    pub(super) fn at<'s>(&mut self, setup: &'s Setup, time: f64) -> Cow<'s, Setup> {
        let mut moved = setup.at(time);
        let plays = moved.objects.iter().any(|object| object.animation.is_some());
        if !plays && moved.scene.file_camera.is_none() {
            return moved;
        }
        let setup = moved.to_mut();
        if let Some(camera) = setup.file_camera(time) {
            setup.place_camera(camera);
        }
        for object in &mut setup.objects {
            if let Some(pose) = object.pose(time) {
                object.mesh = self.mesh(&object.mesh, &pose);
            }
        }
        moved
    }

    /// The mesh in a pose; one that is known already is the same one.
    fn mesh(&mut self, rest: &Arc<Mesh>, pose: &Pose) -> Arc<Mesh> {
        let Some(motion) = rest.motion.as_ref().filter(|motion| motion.moves_surface()) else {
            return rest.clone();
        };
        let hash = motion.surface_hash(pose);
        // The weak handle keeps the address of a mesh from being used again.
        let is_it = |known: &PosedMesh| {
            known.hash == hash && std::ptr::eq(known.rest.as_ptr(), Arc::as_ptr(rest))
        };
        let known = self.0.iter().position(is_it).and_then(|at| self.0.remove(at));
        let known = known.unwrap_or_else(|| PosedMesh {
            rest: Arc::downgrade(rest),
            hash,
            mesh: Arc::new(rest.posed_with_tree(pose)),
        });
        let mesh = known.mesh.clone();
        self.keep(known);
        mesh
    }

    /// Keeps a mesh as the last one, and as many of those before as there is room for.
    fn keep(&mut self, last: PosedMesh) {
        self.0.push_front(last);
        let mut bytes = 0;
        let mut fits = |known: &PosedMesh| {
            bytes += SIZES_OF_MESH * known.mesh.bytes();
            bytes <= MOST_BYTES && known.rest.strong_count() > 0
        };
        let kept =
            1 + self.0.iter().skip(1).take(MOST_MESHES).take_while(|known| fits(known)).count();
        self.0.truncate(kept);
    }
}

impl Setup {
    /// The setup at a time in seconds, as [plans](super::Planner::plan) draw it: moved by the shot
    /// over it, with deformed meshes, and with the camera of a file that the scene asks for.
    pub fn posed(&self, time: f64) -> Cow<'_, Self> {
        KnownPoses::default().at(self, time)
    }

    /// The camera of the picture at a time in seconds: the scene's, moved by the shot over it, or
    /// that of a file.
    pub fn seen_camera(&self, time: f64) -> Camera {
        let mut moved = self.at(time);
        if let Some(camera) = moved.file_camera(time) {
            moved.to_mut().place_camera(camera);
        }
        moved.scene.camera
    }

    /// Puts a file's camera in place of the scene's. Single values of the camera that a shot
    /// changes stand over it.
    fn place_camera(&mut self, camera: Camera) {
        let changed = match &self.shot {
            Some(shot) => shot.camera_values(&self.scene),
            None => Vec::new(),
        };
        self.scene.camera = camera;
        for (address, value) in changed {
            // What the file's camera cannot have, such as a target at its eye, is the file's.
            let _ = self.scene.set_value(&address, &value);
        }
    }

    /// The camera that the scene takes from an object's mesh file, at a time in seconds; `None`
    /// where it takes none, or there is none.
    fn file_camera(&self, time: f64) -> Option<Camera> {
        let asked = self.scene.file_camera.as_ref()?;
        let object = self.objects.iter().find(|object| object.id.as_str() == asked.object)?;
        let motion = object.mesh.motion.as_ref()?;
        let (camera, node) = motion.camera(&asked.name)?;
        let pose = object.pose(time).unwrap_or_else(|| motion.pose(None));
        let world = object.world_from_object * pose.node(node);
        Some(camera_at(world, camera, &self.scene.camera))
    }
}

/// The camera with a lens at a transform, from camera axes (x right, y up, z toward the viewer) to
/// the world. What the file does not say is that of `own`.
fn camera_at(world: DMat4, lens: CameraLens, own: &Camera) -> Camera {
    let axis = |axis: DVec3| world.transform_vector3(axis).try_normalize().unwrap_or(axis);
    let (eye, forward, up) = (world.w_axis.truncate(), axis(DVec3::NEG_Z), axis(DVec3::Y));
    if !eye.is_finite() {
        return *own;
    }
    // The eye's distance to what it looks at is open; the scene's stays.
    let distance = DVec3::from(own.eye).distance(own.target.into()).max(1e-3);
    let placed = Camera {
        eye: eye.to_array(),
        target: (eye + distance * forward).to_array(),
        up: up.to_array(),
        ..*own
    };
    match lens {
        CameraLens::Perspective { fov, aspect } => Camera {
            projection: Projection::Perspective,
            fov: if fov.is_finite() { fov.clamp(Camera::FOV[0], Camera::FOV[1]) } else { own.fov },
            aspect: if aspect.is_finite() { aspect.clamp(0.0, 100.0) } else { own.aspect },
            ..placed
        },
        CameraLens::Orthographic { half_width, half_height } => {
            let scale = world.transform_vector3(DVec3::Y).length();
            let height = 2.0 * half_height * scale;
            Camera {
                projection: Projection::Orthographic,
                height: if height.is_finite() { height.clamp(1e-6, 1e6) } else { own.height },
                aspect: (half_width / half_height.max(1e-12)).clamp(0.0, 100.0),
                ..placed
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kept_meshes_are_bounded_by_all_that_they_take() {
        let mut known = KnownPoses::default();
        let rest = Arc::new(Mesh::default());
        let of = |hash, vertices| PosedMesh {
            rest: Arc::downgrade(&rest),
            hash,
            mesh: Arc::new(Mesh { positions: vec![[0.0; 3]; vertices], ..Mesh::default() }),
        };
        // A quarter of the bound, with what the device holds.
        let quarter = MOST_BYTES / SIZES_OF_MESH / 12 / 4;
        for hash in 0..8 {
            known.keep(of(hash, quarter));
        }
        let hashes = |known: &KnownPoses| known.0.iter().map(|kept| kept.hash).collect::<Vec<_>>();
        assert_eq!(hashes(&known), [7, 6, 5, 4, 3], "the last one, and four quarters");
        known.keep(of(8, 5 * quarter));
        assert_eq!(hashes(&known), [8, 7, 6, 5, 4], "the last one, however large");
        known.keep(of(9, 1));
        assert_eq!(hashes(&known), [9]);
        for hash in 10..1000 {
            known.keep(of(hash, 1));
        }
        assert_eq!(known.0.len(), MOST_MESHES + 1);
    }
}
