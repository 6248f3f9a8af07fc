//! Store shared by the pictures of a window: files that are read, uploads and compiled modules.

use crate::support::eval::renderer;
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::frame::{AssetStore, Assets, PlanOptions, Planner, Setup, open};
use chiaro::library::Library;
use chiaro::render::Renderer;

const OBJ: &str = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";

#[test]
fn two_pictures_with_the_same_mesh_read_it_once_and_upload_it_once() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join("leaf.obj");
    std::fs::write(&mesh, OBJ).unwrap();
    let (store, gpu) = (AssetStore::new(), renderer().gpu().with_own_store());
    let look = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/looks/figure6-comics.json");
    let options = PlanOptions { size: [32; 2], samples: 1, time: 0.0 };
    let mut pictures: Vec<(Planner, Renderer, Setup)> = Vec::new();
    for _ in 0..2 {
        let mut assets = Assets::of(&store);
        let setup = open(look.as_ref(), mesh.to_str(), &mut assets).unwrap().value;
        pictures.push((Planner::new(assets), Renderer::new(gpu.clone()), setup));
    }
    let mut drawn = Vec::new();
    for (planner, renderer, setup) in &mut pictures {
        let plan = planner.plan(setup, Library::built_in(), &Live::Keyed, &options).unwrap().value;
        drawn.push(block_on(renderer.picture(&plan)).unwrap());
    }
    assert!(drawn[0] == drawn[1] && store.len() == 1);
    assert_eq!((store.reads(), gpu.uploads().meshes), (1, 1));

    // Assets that no picture uses any more are dropped, and read again on request.
    drop(pictures);
    assert!(store.is_empty());
    let mut assets = Assets::of(&store);
    let setup = open(look.as_ref(), mesh.to_str(), &mut assets).unwrap().value;
    assert_eq!((store.reads(), store.len()), (2, 1));

    // A file that has changed is another mesh, for all requests from then on.
    let mut others = Assets::of(&store);
    std::fs::write(&mesh, format!("{OBJ}f 1//1 3//1 2//1\n")).unwrap();
    let changed = open(look.as_ref(), mesh.to_str(), &mut others).unwrap().value;
    let triangles = |setup: &Setup| setup.objects[0].mesh.triangle_count();
    assert_eq!((triangles(&setup), triangles(&changed), store.reads()), (1, 2, 3));
}

#[test]
fn planners_of_one_setup_share_what_its_looks_read() {
    let folder = tempfile::tempdir().unwrap();
    image::RgbImage::new(4, 4).save(folder.path().join("paper.png")).unwrap();
    let look = folder.path().join("paper.json");
    let text = r#"{"chiaro": "look", "nodes": [
        {"id": "paper", "kind": "image", "values": {"image": "paper.png"}},
        {"id": "output", "kind": "output"}], "wires": [{"from": "paper", "to": "output.color"}]}"#;
    std::fs::write(&look, text).unwrap();
    let store = AssetStore::new();
    let setup = open(&look, Some("shape:sphere"), &mut Assets::of(&store)).unwrap().value;
    let options = PlanOptions { size: [32; 2], samples: 1, time: 0.0 };
    let plans = [Live::Keyed, Live::All].map(|live| {
        Planner::default().plan(&setup, Library::built_in(), &live, &options).unwrap().value
    });
    assert!(plans.iter().all(|plan| plan.draws[0].images.len() == 1));
    assert_eq!(store.reads(), 2, "the sphere and the paper");
}

#[test]
fn a_picture_drops_what_it_has_not_used_for_long() {
    let store = AssetStore::new();
    let mut assets = Assets::of(&store);
    let mesh = |assets: &mut Assets, name: &str| {
        assets.mesh("".as_ref(), name).unwrap().value.triangle_count()
    };
    mesh(&mut assets, "shape:sphere");
    for _ in 0..40 {
        assets.begin_picture();
        mesh(&mut assets, "shape:torus");
    }
    assert_eq!((store.reads(), store.len()), (2, 1));
    assert_eq!(assets.files().count(), 0, "an own shape is no file");
}
