//! Memory that the program takes, as the system counts it.

use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::support::root;

/// Vertices along each side of the mesh.
const SIDE: usize = 1024;

/// Writes a sheet of waves with normals and UVs as GLB, and returns its length in bytes.
fn write_sheet(path: &Path) -> u64 {
    let share = |index: usize| index as f32 / (SIDE - 1) as f32;
    let vertices = || (0..SIDE * SIDE).map(|index| [share(index % SIDE), share(index / SIDE)]);
    let height = |u: f32, v: f32| 0.1 * (9.0 * u).sin() * (7.0 * v).cos();
    let triangles = || {
        let cells = (0..(SIDE - 1) * (SIDE - 1)).map(|cell| (cell % (SIDE - 1), cell / (SIDE - 1)));
        cells.flat_map(|(x, y)| {
            let [a, b, c, d] = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
                .map(|(x, y)| (y * SIDE + x) as u32);
            [a, b, c, a, c, d]
        })
    };
    let (count, corners) = (SIDE * SIDE, 6 * (SIDE - 1) * (SIDE - 1));
    let [places, normals, uvs, indices] = [12 * count, 12 * count, 8 * count, 4 * corners];
    let view = |offset, length| {
        format!(r#"{{"buffer": 0, "byteOffset": {offset}, "byteLength": {length}}}"#)
    };
    let accessor = |view, kind, count, form| {
        let of_view = format!(r#""bufferView": {view}, "componentType": {kind}"#);
        format!(r#"{{{of_view}, "count": {count}, "type": "{form}"}}"#)
    };
    let views = [
        view(0, places),
        view(places, normals),
        view(places + normals, uvs),
        view(places + normals + uvs, indices),
    ];
    let accessors = [
        accessor(0, 5126, count, "VEC3"),
        accessor(1, 5126, count, "VEC3"),
        accessor(2, 5126, count, "VEC2"),
        accessor(3, 5125, corners, "SCALAR"),
    ];
    let length = places + normals + uvs + indices;
    let mut json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [
        {{"attributes": {{"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}}, "indices": 3}}]}}],
        "buffers": [{{"byteLength": {length}}}], "bufferViews": [{}], "accessors": [{}]}}"#,
        views.join(", "),
        accessors.join(", ")
    );
    while json.len() % 4 != 0 {
        json.push(' ');
    }
    let mut file = BufWriter::new(File::create(path).unwrap());
    let whole = 12 + 8 + json.len() + 8 + length;
    let mut put = |bytes: &[u8]| file.write_all(bytes).unwrap();
    put(b"glTF");
    for word in [2, whole as u32, json.len() as u32] {
        put(&word.to_le_bytes());
    }
    put(b"JSON");
    put(json.as_bytes());
    put(&(length as u32).to_le_bytes());
    put(b"BIN\0");
    let mut numbers = |row: &[f32]| row.iter().for_each(|number| put(&number.to_le_bytes()));
    vertices().for_each(|[u, v]| numbers(&[u, height(u, v), v]));
    vertices().for_each(|[u, v]| {
        let step = 1e-3;
        let along = |u1: f32, v1: f32| (height(u + u1, v + v1) - height(u, v)) / step;
        numbers(&[-along(step, 0.0), 1.0, -along(0.0, step)]);
    });
    vertices().for_each(|uv| numbers(&uv));
    triangles().for_each(|index| put(&index.to_le_bytes()));
    drop(file);
    std::fs::metadata(path).unwrap().len()
}

/// The most memory that the program takes while it explains a look on a mesh, in bytes.
#[expect(clippy::disallowed_methods, reason = "the system gives no sign when memory grows")]
fn peak_on(mesh: &str) -> u64 {
    let look = root().join("examples/looks/figure1-layers.json");
    let mut child = Command::new(env!("CARGO_BIN_EXE_chiaro"))
        .args(["explain", look.to_str().unwrap(), "--mesh", mesh])
        .env("CHIARO_CACHE_DIR", "")
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    loop {
        let ended = child.try_wait().unwrap();
        if let Some(code) = ended {
            assert!(code.success(), "{mesh}");
            return peak;
        }
        // The system keeps the peak, until the program has ended.
        let told = std::fs::read_to_string(&status).unwrap_or_default();
        let kibibytes = told.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kibibytes =
            kibibytes.and_then(|text| text.trim().strip_suffix("kB")?.trim().parse().ok());
        peak = kibibytes.map_or(peak, |kibibytes: u64| kibibytes << 10);
        sleep(Duration::from_millis(2));
    }
}

#[test]
fn a_mesh_takes_no_more_memory_than_twice_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join("sheet.glb");
    let length = write_sheet(&mesh);
    let share = peak_on(mesh.to_str().unwrap()).saturating_sub(peak_on("shape:sphere"));
    // It is 1.3 files when it is built, so less was not measured.
    assert!((length..=2 * length).contains(&share), "{share} bytes for a file of {length}");
}
