//! Motion that the files of meshes bring into a scene: the clips that objects play, and the camera
//! of a file. It is read in the files, and keyed nowhere.

use super::mesh_label;
use crate::document::{Camera, MeshAnimation};
use crate::frame::Setup;
use crate::ids::ObjectId;

/// Greatest number of times of a clip that are told.
const MOST_TIMES: usize = 1000;

/// Clip of a mesh's file that an object plays.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PlayedClip {
    pub(crate) object: ObjectId,
    /// Name of the mesh's file.
    pub(crate) file: String,
    /// Name of the clip in the file.
    pub(crate) name: String,
    /// Length of the clip, in seconds of the file.
    pub(crate) seconds: f64,
    /// Speed, start and end.
    pub(crate) played: MeshAnimation,
    /// Times of the file's keys, in seconds of the file.
    pub(crate) keys: Vec<f64>,
}

impl PlayedClip {
    /// Times at which the clip begins anew or ends, within a range of times of the scene, in
    /// seconds.
    pub(crate) fn seams(&self, range: [f64; 2]) -> Vec<f64> {
        let ends = if self.played.loops { &[0.0][..] } else { &[0.0, self.seconds] };
        self.times_of(ends, range)
    }

    /// Times of the file's keys as the clip plays, within a range of times of the scene, in
    /// seconds.
    pub(crate) fn key_times(&self, range: [f64; 2]) -> Vec<f64> {
        self.times_of(&self.keys, range)
    }

    /// Times of the scene at which the clip is at some of its own times, in seconds; empty where
    /// they are too many to be told apart.
    fn times_of(&self, own: &[f64], [from, to]: [f64; 2]) -> Vec<f64> {
        let MeshAnimation { speed, offset, loops, .. } = self.played;
        if speed == 0.0 || self.seconds <= 0.0 {
            return Vec::new();
        }
        let time = |round: f64, own: f64| (round * self.seconds + own - offset) / speed;
        let round = |time: f64| ((offset + time * speed) / self.seconds).floor();
        let rounds = if loops {
            [round(from).min(round(to)), round(from).max(round(to))]
        } else {
            [0.0, 0.0]
        };
        let count = (rounds[1] - rounds[0] + 1.0) * own.len() as f64;
        if !(1.0..MOST_TIMES as f64).contains(&count) {
            return Vec::new();
        }
        let each = (0..=(rounds[1] - rounds[0]) as usize).map(|at| rounds[0] + at as f64);
        let all = each.flat_map(|round| own.iter().map(move |own| time(round, *own)));
        all.filter(|time| (from..=to).contains(time)).collect()
    }
}

/// Camera of a mesh's file that pictures are drawn from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CameraInFile {
    /// Name of the camera, or of its node.
    pub(crate) name: String,
    /// Clip that moves it.
    pub(crate) clip: PlayedClip,
}

/// Motion of a scene's files.
pub(crate) struct FileMotion {
    setup: Setup,
    pub(crate) clips: Vec<PlayedClip>,
    /// Camera of the picture, where it is of a file whose clip is played.
    pub(crate) camera: Option<CameraInFile>,
}

impl FileMotion {
    /// The motion of a setup that is seen from its own camera.
    pub(crate) fn of(mut setup: Setup) -> Self {
        let mut clips = Vec::new();
        for object in &setup.objects {
            let motion = object.mesh.motion.as_ref();
            let played = object.animation.as_ref().zip(motion).and_then(|(played, motion)| {
                Some((&played.played, motion.animations().get(played.number)?))
            });
            let Some((played, animation)) = played else { continue };
            let mesh = setup.scene.objects.get(&object.id).map(|object| object.mesh.as_str());
            clips.push(PlayedClip {
                object: object.id.clone(),
                file: mesh_label(mesh.unwrap_or_default()),
                name: animation.name.clone(),
                seconds: animation.seconds(),
                played: played.clone(),
                keys: animation.key_times(),
            });
        }
        let camera = setup.scene.file_camera.as_ref().and_then(|asked| {
            let object = setup.objects.iter().find(|object| object.id.as_str() == asked.object)?;
            let motion = object.mesh.motion.as_ref()?;
            let mut cameras = motion.cameras().iter();
            let found = cameras.find(|it| asked.name.is_empty() || it.name == asked.name)?;
            let animation = motion.animations().get(object.animation.as_ref()?.number)?;
            let (_, node) = motion.camera(&asked.name)?;
            let clip = clips.iter().find(|clip| clip.object == object.id)?;
            let keys = motion.key_times(animation, node);
            let clip = PlayedClip { keys, ..clip.clone() };
            Some(CameraInFile { name: found.name.clone(), clip })
        });
        // Looks place no camera, and would be copied for each time.
        setup.looks.clear();
        Self { setup, clips, camera }
    }

    /// The camera of the picture at a time, in seconds.
    pub(crate) fn camera_at(&self, time: f64) -> Camera {
        self.setup.seen_camera(time)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clip_tells_where_it_begins_anew() {
        let clip = |speed: f64, offset: f64, loops: bool| PlayedClip {
            object: ObjectId::new("sprout"),
            file: "sprout.glb".to_owned(),
            name: "sway".to_owned(),
            seconds: 2.0,
            played: MeshAnimation { speed, offset, loops, ..MeshAnimation::default() },
            keys: vec![0.5, 2.0],
        };
        assert_eq!(clip(1.0, 0.0, true).key_times([0.0, 3.0]), [0.5, 2.0, 2.5]);
        let range = [0.0, 5.0];
        assert_eq!(clip(1.0, 0.0, true).seams(range), [0.0, 2.0, 4.0]);
        assert_eq!(clip(2.0, 1.0, true).seams([0.0, 2.0]), [0.5, 1.5]);
        assert_eq!(clip(-1.0, 0.0, true).seams([0.5, 4.5]), [4.0, 2.0]);
        assert_eq!(clip(1.0, -1.0, false).seams(range), [1.0, 3.0], "it begins and ends");
        assert!(clip(1.0, 5.0, false).seams(range).is_empty(), "it has ended");
        assert!(clip(0.0, 0.0, true).seams(range).is_empty(), "it stands still");
        assert!(clip(1e9, 0.0, true).seams(range).is_empty(), "too many to be told");
    }
}
