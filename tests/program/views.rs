//! Views of OpenColorIO's configurations in files of what a display shows: `--view`, `--display`,
//! `--ocio`.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use chiaro::film::{BUILT_IN, ColorConfig};
use chiaro::frame::Picture;
use serde_json::json;

use crate::support::{root, validators::film_judge};

const ACES: &str = "ACES 2.0 - SDR 100 nits (Rec.709)";

/// A folder with a look of light, and a configuration that has one view: light alone.
struct Stage(tempfile::TempDir);

impl Stage {
    fn new() -> Self {
        let stage = Self(tempfile::tempdir().unwrap());
        let look = json!({
            "chiaro": "look", "version": 1, "color_space": "linear",
            "nodes": [
                {"id": "base", "kind": "base", "values": {"color": [0.18, 0.5, 0.9, 1.0]}},
                {"id": "output", "kind": "output"}
            ],
            "wires": [{"from": "base", "to": "output.color"}]
        });
        fs::write(stage.path("look.json"), look.to_string()).unwrap();
        let config = "ocio_profile_version: 2\nroles: {default: a, scene_linear: a}\ndisplays:\n  \
                      d:\n    - !<View> {name: raw, colorspace: a}\ncolorspaces:\n  - \
                      !<ColorSpace> {name: a, aliases: [lin_rec709_scene]}\n";
        fs::write(stage.path("config.ocio"), config).unwrap();
        stage
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn run(&self, arguments: &[&str], ocio: Option<&str>) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").env_remove("OCIO").current_dir(self.0.path());
        command.args(arguments).envs(ocio.map(|config| ("OCIO", config)));
        command.output().unwrap()
    }

    #[track_caller]
    fn render(&self, more: &[&str], ocio: Option<&str>) -> String {
        let render = ["render", "look.json", "--mesh", "shape:sphere", "--size", "24x16"];
        let plain = ["--samples", "1", "--on", "reference", "--backdrop", "#808080"];
        let ran = self.run(&[&render[..], &plain, more].concat(), ocio);
        let [out, said] = [ran.stdout, ran.stderr].map(|text| String::from_utf8(text).unwrap());
        assert!(ran.status.success(), "{more:?}: {said}");
        out
    }

    /// The color in the middle of a picture.
    fn middle(&self, name: &str) -> [i32; 3] {
        let picture = image::open(self.path(name)).unwrap().to_rgb8();
        picture.get_pixel(picture.width() / 2, picture.height() / 2).0.map(i32::from)
    }
}

#[test]
fn pictures_are_shown_by_a_view() {
    let stage = Stage::new();
    stage.render(&["-o", "plain.png"], None);
    assert_eq!(stage.middle("plain.png"), [118, 188, 243]);
    stage.render(&["-o", "aces.png", "--view", ACES], None);
    // Light of (0.18, 0.5, 0.9) by OpenColorIO's own view.
    let near = |name: &str, wanted: [i32; 3]| {
        let made = stage.middle(name);
        let apart = made.iter().zip(wanted).map(|(a, b)| (a - b).abs()).max();
        assert!(apart <= Some(1), "{name}: {made:?} {wanted:?}");
    };
    near("aces.png", WANTED);
    // By $OCIO, and by another configuration over it.
    stage.render(&["-o", "raw.png", "--view", "raw"], Some("config.ocio"));
    near("raw.png", [46, 128, 230]);
    let over = ["-o", "over.png", "--ocio", BUILT_IN, "--view", ACES];
    stage.render(&over, Some("config.ocio"));
    near("over.png", WANTED);
    // Without a view $OCIO changes nothing.
    stage.render(&["-o", "same.png"], Some("config.ocio"));
    assert_eq!(stage.middle("same.png"), [118, 188, 243]);
    // Frames of another view are other frames.
    let state = |more: &[&str]| {
        let frames = ["-o", "f.#.png", "--frames", "0", "--json"];
        let told = stage.render(&[&frames[..], more].concat(), None);
        let told: serde_json::Value = serde_json::from_str(told.lines().next().unwrap()).unwrap();
        told["state"].as_str().unwrap().to_owned()
    };
    assert_eq!([state(&[]), state(&[]), state(&["--view", ACES])], ["drawn", "kept", "drawn"]);
    // A look that chose what is shown is told.
    let display =
        fs::read_to_string(stage.path("look.json")).unwrap().replace("\"linear\"", "\"display\"");
    fs::write(stage.path("shown.json"), display).unwrap();
    let draw = |view: &str| {
        let size = ["render", "shown.json", "-o", "shown-look.png", "--size", "8x8"];
        let ran = stage.run(&[&size[..], &["--on", "reference", "--view", view]].concat(), None);
        String::from_utf8(ran.stderr).unwrap()
    };
    assert!(draw(ACES).contains("display-referred"));
    assert!(!draw("Un-tone-mapped").contains("display-referred"));
    // What can be asked for is listed.
    let views = stage.render(&["--list-views"], Some("config.ocio"));
    assert_eq!(views, "d/raw\n");
    // Movies and sheets show what EXRs hold.
    stage.render(&["-o", "l.#.exr", "--frames", "0"], None);
    for command in ["movie", "sheet"] {
        let arguments = [command, "l.#.exr", "-o", "shown.png", "--view", ACES, "--force"];
        let ran = stage.run(&arguments, None);
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        if command == "movie" {
            near("shown.png", WANTED);
        }
    }
}

/// The color of [`pictures_are_shown_by_a_view`].
const WANTED: [i32; 3] = [103, 144, 178];

#[test]
fn a_view_that_cannot_be_is_told() {
    let stage = Stage::new();
    let fails = |code: i32, arguments: &[&str]| {
        let ran = stage.run(arguments, None);
        let said = String::from_utf8_lossy(&ran.stderr).into_owned();
        assert_eq!(ran.status.code(), Some(code), "{arguments:?}: {said}");
        said
    };
    let render = ["render", "look.json", "-o"];
    let with = |more: &[&'static str]| [&render[..], more].concat();
    let said = fails(1, &with(&["a.png", "--view", "ACES 2.0"]));
    assert!(said.contains(ACES) && said.contains("Un-tone-mapped"), "{said}");
    assert!(fails(2, &with(&["a.exr", "--view", ACES])).contains("PNG"));
    assert!(
        fails(1, &with(&["a.png", "--view", "v", "--ocio", "none.ocio"])).contains("none.ocio")
    );
    assert!(fails(2, &with(&["a.png", "--ocio", "config.ocio"])).contains("--view"));
    assert!(fails(2, &with(&["a.png", "--display", "d"])).contains("--view"));
    let said = fails(1, &with(&["a.png", "--view", ACES, "--display", "d"]));
    assert!(said.contains("no display `d`") && said.contains("sRGB - Display"), "{said}");
    stage.render(&["-o", "a.png"], None);
    assert!(fails(2, &["sheet", "a.png", "-o", "s.png", "--view", ACES]).contains("already"));
}

/// Every view of the configurations that are built in, against OpenColorIO itself.
#[test]
fn views_are_those_of_opencolorio() {
    let Some(mut judge) = film_judge() else { return };
    // Light from dark to far above white, colors at and beyond the edge of what can be shown.
    let mut random = 0x5eed_u64;
    let mut next = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (random >> 40) as f32 / (1 << 24) as f32
    };
    let rgba: Vec<[f32; 4]> = (0..2000)
        .map(|at| {
            let scale = (12.0 * next() - 8.0).exp2();
            let color = [next(), next(), next()].map(|x| x * scale);
            let [r, g, b] = color;
            match at % 4 {
                0 => [r, g, b, 1.0],
                1 => [r, 0.0, 0.0, 1.0],
                2 => [r - 0.3 * scale, g, b - 0.3 * scale, 1.0],
                _ => [r, r, r, 1.0],
            }
        })
        .collect();
    let picture = Picture { size: [2000, 1], rgba };
    let folder = tempfile::tempdir().unwrap();
    let bytes = |picture: &Picture| {
        let numbers = picture.rgba.iter().flat_map(|pixel| pixel[..3].to_vec());
        numbers.flat_map(f32::to_le_bytes).collect::<Vec<u8>>()
    };
    fs::write(folder.path().join("shown"), bytes(&picture)).unwrap();
    let config = ColorConfig::open(BUILT_IN).unwrap();
    let names = config.names();
    assert!(names.len() > 20, "{names:?}");
    for (at, name) in names.iter().enumerate() {
        let view = config.view(None, name).unwrap();
        fs::write(folder.path().join(at.to_string()), bytes(&view.show(&picture))).unwrap();
    }
    judge.arg(root().join("tests/film/views.py")).arg(BUILT_IN).arg(folder.path()).args(&names);
    let ran = judge.output().unwrap();
    let said = String::from_utf8_lossy(&ran.stdout).into_owned();
    assert!(ran.status.success(), "{said}{}", String::from_utf8_lossy(&ran.stderr));
    let worst: f64 = said.trim().parse().unwrap();
    // The curve of sRGB that pictures come through is taken in another precision there.
    assert!(worst < 2e-5, "{worst}");
}
