//! Thumbnails of scenes and shots, from their files: all of a scene as its own camera sees it, in a
//! square, and the middle of a shot's picture in the middle of its frames.

use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;

use glam::DVec3;

use crate::compile::Live;
use crate::document::{Camera, Document, Projection, Scene};
use crate::files::Files;
use crate::frame::{
    AssetStore, Assets, CullMode, FramePlan, PlanOptions, Planner, SHAPE_PREFIX, Setup,
    SetupObject, ShotStack, View, open, scene_setup,
};
use crate::library::Library;
use crate::state::session::Session;

/// Largest total size of the meshes that are read for a thumbnail, in bytes.
const MOST_BYTES: u64 = 128 << 20;
/// Part of half the picture's side that the whole scene reaches to.
const FILLED: f64 = 0.94;
/// Range of the picture's width, in heights of the camera's picture: at most as in a wide window.
const ZOOM: [f64; 2] = [0.4, 1.8];

/// Key of a scene's thumbnail: a hash of the file's content, and of the files that it names.
pub(crate) fn key_of_scene(path: &Path, scene: &Scene, session: &Session, side: f32) -> u64 {
    let mut hasher = DefaultHasher::new();
    (path, side.round() as u32, scene.to_text()).hash(&mut hasher);
    let folder = path.parent().unwrap_or(Path::new(""));
    for name in
        scene.objects.values().flat_map(|object| object.looks.values().chain([&object.mesh]))
    {
        (name, session.assets.source().metadata(&folder.join(name))).hash(&mut hasher);
    }
    hasher.finish()
}

/// Key of a shot's thumbnail: a hash of the file's content, and of what the shot changes.
pub(crate) fn key_of_shot(path: &Path, session: &Session, side: f32) -> u64 {
    let mut hasher = DefaultHasher::new();
    (path, side.round() as u32).hash(&mut hasher);
    if let Some(Ok(stack)) = ShotStack::load(&**session.assets.source(), path) {
        let ShotStack { shots, scene_path, scene, .. } = &stack.value;
        for file in shots {
            (&file.path, file.shot.to_text()).hash(&mut hasher);
        }
        key_of_scene(scene_path, scene, session, side).hash(&mut hasher);
    }
    hasher.finish()
}

/// Frame plan of the scene or the shot in a file, read with the window's other pictures; `None`
/// where there is nothing to draw, or too much. Data of files that no other picture shows is
/// dropped with this one.
pub(super) fn plan(path: &Path, options: &PlanOptions, assets: &AssetStore) -> Option<FramePlan> {
    let files = &**assets.source();
    let mut planner = Planner::new(Assets::of(assets)).culling(CullMode::Objects);
    planner.assets.draft();
    let (setup, folder, time) = match Document::load(files, path) {
        Document::Look(_) => return None,
        Document::Scene(loaded) => {
            let scene = loaded.value?;
            let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
            if bytes_of_meshes(&scene, &folder, files) > MOST_BYTES {
                return None;
            }
            // Missing files are left out, as in the window.
            let assets = &mut planner.assets;
            let mut setup = scene_setup(scene, &folder, &loaded.source, None, assets).value;
            setup.scene.file_camera = None;
            setup.scene.camera = fitted(&setup);
            (setup, folder, options.time)
        }
        Document::Shot(loaded) => {
            let stack = ShotStack::over(files, path, loaded).ok()?.value;
            let folder = stack.scene_folder().to_path_buf();
            if bytes_of_meshes(&stack.scene, &folder, files) > MOST_BYTES {
                return None;
            }
            let [first, last] = stack.frames();
            let time = stack.rate().time(first.midpoint(last));
            (open(path, None, &mut planner.assets).ok()?.value, folder, time)
        }
    };
    let nodes = folder.join("nodes");
    let library = if files.is_folder(&nodes) {
        Library::built_in().with_project(files, &nodes)
    } else {
        Library::built_in().clone()
    };
    let options = PlanOptions { time, ..*options };
    Some(planner.plan(&setup, &library, &Live::Keyed, &options).ok()?.value)
}

fn bytes_of_meshes(scene: &Scene, folder: &Path, files: &dyn Files) -> u64 {
    let meshes = scene.objects.values().map(|object| object.mesh.as_str());
    let meshes: BTreeSet<&str> = meshes.filter(|mesh| !mesh.starts_with(SHAPE_PREFIX)).collect();
    let found = meshes.into_iter().filter_map(|mesh| files.metadata(&folder.join(mesh)));
    found.map(|found| found.length).sum()
}

/// Scene's camera, zoomed so that all of the scene is in a square picture, and no smaller than need
/// be.
fn fitted(setup: &Setup) -> Camera {
    let camera = setup.scene.camera;
    let view = View::new(&camera, [1, 1], DVec3::ZERO, 1.0);
    let far = |object: &SetupObject| -> f64 {
        let (center, radius) = (object.center(), object.radius());
        let [right, up] = [0, 1].map(|row| view.rotation().row(row));
        let from_eye = center - view.eye;
        let depth = if view.is_perspective { -from_eye.dot(view.backward) } else { 1.0 };
        // Objects beside the eye, or behind it, have no place in the picture.
        let aside = from_eye.dot(right).abs().max(from_eye.dot(up).abs());
        if view.is_perspective && depth <= radius { 0.0 } else { (aside + radius) / depth }
    };
    let reach = setup.objects.iter().map(far).fold(0.0, f64::max) / FILLED;
    let half = 0.5 * view.view_height;
    let half = if reach > 0.0 { reach.clamp(half * ZOOM[0], half * ZOOM[1]) } else { half };
    let camera = Camera { aspect: 0.0, ..camera };
    match camera.projection {
        Projection::Perspective => Camera { fov: 2.0 * half.atan(), ..camera },
        Projection::Orthographic => Camera { height: 2.0 * half, ..camera },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_a_scene_is_in_its_small_picture() {
        for name in ["cast", "figure2-parametrizations", "figure4-curvature", "figure5-from-behind"]
        {
            let path = Path::new(env!("CARGO_MANIFEST_DIR"))
                .join(format!("../../examples/scenes/{name}.json"));
            let mut setup = open(&path, None, &mut Assets::default()).unwrap().value;
            setup.scene.camera = fitted(&setup);
            let view = View::new(&setup.scene.camera, [100, 100], DVec3::ZERO, 20.0);
            let mut most: f64 = 0.0;
            for object in &setup.objects {
                let at = view.clip_from_world.project_point3(object.center());
                most = most.max(at.x.abs()).max(at.y.abs());
            }
            assert!((0.3..0.94).contains(&most), "{name}: {most}");
        }
    }

    #[test]
    fn a_small_picture_reads_nothing_that_another_picture_has_read() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes/cast.json");
        let options = PlanOptions { size: [32; 2], samples: 1, time: 0.0 };
        let store = AssetStore::new();
        let shown = plan(&path, &options, &store).unwrap();
        let reads = store.reads();
        assert!(plan(&path, &options, &store).is_some() && !shown.draws.is_empty());
        assert!(reads > 0 && store.reads() == reads, "{} after {reads}", store.reads());
    }

    #[test]
    fn an_example_shot_has_a_picture_of_its_own() {
        let options = PlanOptions { size: [32; 2], samples: 1, time: 0.0 };
        let store = AssetStore::new();
        for name in ["evening-010", "evening", "nightfall/nightfall-010-graded"] {
            let path = format!("{}shots/{name}.json", crate::examples::PREFIX);
            let shot = plan(Path::new(&path), &options, &store).unwrap();
            assert!(!shot.draws.is_empty(), "{name}");
        }
    }

    #[test]
    fn an_orthographic_sphere_fills_the_square() {
        let scene = r#"{"objects": [{"mesh": "shape:sphere", "looks": "none.json"}],
          "camera": {"eye": [0, 0, 5], "projection": "orthographic", "height": 4}}"#;
        let loaded = Scene::read(scene, "test");
        let scene = loaded.value.unwrap();
        let folder = Path::new("");
        let mut assets = Assets::default();
        let setup = scene_setup(scene, folder, &loaded.source, None, &mut assets).value;
        let height = fitted(&setup).height;
        assert!((height - 2.0 / FILLED).abs() < 0.02, "{height}");
    }
}
