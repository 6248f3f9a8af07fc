//! Scenes without a disk: all that a scene names is read through [`Files`], here from memory.

use std::io::Cursor;
use std::path::Path;
use std::sync::Arc;

use chiaro::document::{Address, Directions, Grid};
use chiaro::files::{FileMetadata, Files, FoundFiles, MemoryFiles, ReadError, WalkBounds};
use chiaro::frame::{AssetStore, Assets, open};
use chiaro::hcbtf::exchange::{ExchangeFormat, fitted, import};
use chiaro::hcbtf::folder::file_name;
use chiaro::hcbtf::{self, LayerOptions};
use chiaro::progress::Progress;

const SCENE: &str = r#"{"chiaro": "scene", "objects": [
    {"id": "leaf", "mesh": "meshes/leaf.obj", "looks": "looks/skin.json"}]}"#;
const LOOK: &str = r#"{"chiaro": "look", "nodes": [
    {"id": "skin", "kind": "image", "values": {"image": "../skin.png"}},
    {"id": "output", "kind": "output"}], "wires": [{"from": "skin", "to": "output.color"}]}"#;
const OBJ: &str = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

/// The files of a scene. No path leads anywhere on the disk.
fn files() -> MemoryFiles {
    let mut png = Cursor::new(Vec::new());
    image::RgbImage::from_pixel(3, 2, image::Rgb([200, 10, 0]))
        .write_to(&mut png, image::ImageFormat::Png)
        .unwrap();
    let example = MemoryFiles::default()
        .read(Path::new("example:hcbtf/pencil.hcbtf"), hcbtf::MAX_FILE_BYTES)
        .unwrap();
    let mut files = MemoryFiles::default();
    files.add("nowhere/scene.json", SCENE);
    files.add("nowhere/looks/skin.json", LOOK);
    files.add("nowhere/meshes/leaf.obj", OBJ);
    files.add("nowhere/looks/../skin.png", png.into_inner());
    files.add("nowhere/looks/paint.hcbtf", example);
    files
}

#[test]
fn a_scene_with_its_look_mesh_image_and_hcbtf_comes_from_memory() {
    let mut assets = Assets::of(&AssetStore::reading_from(Arc::new(files())));
    let (setup, problems) =
        open(Path::new("nowhere/scene.json"), None, &mut assets).unwrap().into_parts();
    let codes: Vec<_> = problems.iter().map(|problem| problem.code).collect();
    assert_eq!(codes, ["mesh-normals-made"], "{problems:?}");
    assert_eq!((setup.objects.len(), setup.objects[0].mesh.triangle_count()), (1, 1));
    let look = &setup.looks[0];
    assert_eq!(
        (setup.objects[0].looks[0], look.folder.as_path()),
        (Some(0), "nowhere/looks".as_ref())
    );
    let image = assets.image(&look.folder, "../skin.png").unwrap();
    assert_eq!((image.size, &image.rgba()[..4]), ([3, 2], &[200, 10, 0, 255][..]));
    let layers = assets.hcbtf(&look.folder, "paint.hcbtf", LayerOptions::default()).unwrap().value;
    let shipped = Assets::default()
        .hcbtf(Path::new(""), "example:hcbtf/pencil.hcbtf", LayerOptions::default())
        .unwrap();
    assert_eq!(layers.hash, shipped.value.hash);
    assert_eq!(assets.files().count(), 3);

    // Whatever is missing there is told as on a disk.
    let missing = assets.mesh(Path::new("nowhere"), "none.obj").unwrap_err();
    assert!(missing[0].to_string().contains("check the spelling"), "{}", missing[0]);
    assert_eq!(open(Path::new("nowhere/none.json"), None, &mut assets).unwrap_err().len(), 1);
}

#[test]
fn a_folder_of_samples_comes_from_memory_and_its_size_is_bounded() {
    let mut png = Cursor::new(Vec::new());
    image::RgbaImage::new(4, 4).write_to(&mut png, image::ImageFormat::Png).unwrap();
    let mut files = MemoryFiles::default();
    files.add(format!("images/{}", file_name(Address::default())), png.into_inner());
    files.add("images/notes.txt", "");
    let directions = Directions { theta: 2, phi: 3 };
    let grid = Grid { size: [1, 1], light: directions, view: directions };
    let from = Path::new("images");
    assert_eq!(ExchangeFormat::guessed(&files, from), ExchangeFormat::Folder);
    let grid = fitted(&files, from, ExchangeFormat::Folder, grid, 0);
    assert_eq!(grid.size, [4, 4]);
    let hcbtf =
        import(&files, from, ExchangeFormat::Folder, grid, 0, &Progress::new()).unwrap().value;
    assert_eq!(hcbtf.painted.len(), 1);
    // A folder of more entries than any HCBTF has samples is not looked through.
    let told = import(&EndlessFolder, from, ExchangeFormat::Folder, grid, 0, &Progress::new())
        .unwrap_err();
    assert_eq!(told[0].code, "too-large");
}

/// A folder without end.
#[derive(Debug)]
struct EndlessFolder;

impl Files for EndlessFolder {
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
        MemoryFiles::default().read(path, most)
    }

    fn metadata(&self, _: &Path) -> Option<FileMetadata> {
        None
    }

    fn walk(&self, _: &Path, bounds: WalkBounds, _: &dyn Fn(&Path) -> bool) -> FoundFiles {
        assert!(bounds.depth == 0 && bounds.entries < 1 << 22);
        FoundFiles { is_cut: true, ..FoundFiles::default() }
    }
}
