//! The example looks, and random samples of a surface to evaluate looks at.

use chiaro_compiler::document::Look;
use chiaro_scene::frame::{EvalSample, SetupLook};
use chiaro_test_support::random::Random;
use chiaro_test_support::{files, root};
use glam::{DMat3, DVec2};

/// Every look of `examples/looks` with its file's stem.
pub fn looks() -> Vec<(String, SetupLook)> {
    let folder = root().join("examples/looks");
    let paths = files::below(&folder).into_iter();
    let looks: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .map(|path| {
            let loaded = Look::load(&chiaro_test_support::chiaro_files::Disk, &path);
            let look = SetupLook {
                look: loaded.value.expect("an example opens"),
                source: loaded.source.into(),
                folder: folder.clone(),
            };
            (path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), look)
        })
        .collect();
    assert!(looks.len() >= 6, "the example looks are gone");
    looks
}

/// Samples of a surface, random in normal, view, position, camera, frame, UV, curvature and color.
pub fn samples(seed: u64, count: usize) -> Vec<EvalSample> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| EvalSample {
            normal: random.direction(),
            view: random.direction(),
            position: random.direction() * random.unit(),
            camera: DMat3::from_quat(random.rotation()),
            frame: random.rotation(),
            uv: DVec2::new(random.unit(), random.unit()),
            kappa: random.between(-20.0, 20.0),
            vertex_color: [(); 4].map(|()| random.unit()),
            ..EvalSample::default()
        })
        .collect()
}
