//! The example film of `examples/shots/nightfall`: graded from its files alone.

use std::process::{Command, Stdio};

use crate::support::root;
use crate::support::validators::film_judge;

/// Checks that a graded file has the mattes, the time code and the camera of its own file.
const KEPT: &str = r#"
import OpenImageIO as oiio
import numpy as np

def read(path):
    file = oiio.ImageInput.open(path)
    spec = oiio.ImageSpec(file.spec())
    pixels = np.asarray(file.read_image("float")).reshape(spec.height, spec.width, -1)
    return pixels.view(np.uint32), list(spec.channelnames), spec

(was, names, said), (now, kept, says) = read("shot.49.exr"), read("again.49.exr")
mattes = [name for name in names if name.startswith("Crypto")]
assert mattes and kept == ["R", "G", "B", "A"] + mattes, kept
for name in mattes:
    assert (was[..., names.index(name)] == now[..., kept.index(name)]).all(), name
told = [entry.name for entry in said.extra_attribs if entry.name.startswith("cryptomatte/")]
for name in told + ["smpte:TimeCode", "worldToCamera", "framesPerSecond"]:
    assert said[name] is not None and str(said[name]) == str(says[name]), name
assert "chiaro" not in [entry.name for entry in says.extra_attribs]
"#;

/// A frame whose lights are graded by `scripts/regrade.py` is the frame that is rendered with the
/// grade, everywhere but where two objects share a pixel of a matte. Some ten seconds on software
/// Vulkan: the twelve looks of the shot are compiled with their layers, twice.
#[test]
fn a_frame_is_graded_from_its_file_alone() {
    if film_judge().is_none() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let render = |shot: &str, to: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").current_dir(folder.path()).stdout(Stdio::piped());
        command.arg("render").arg(root().join("examples/shots/nightfall").join(shot));
        command.args(["-o", to, "--frames", "49", "--size", "96x54"]);
        command.args(["--aov", "lights", "--matte", "objects"]).stderr(Stdio::piped());
        command.spawn().unwrap()
    };
    let both = [
        render("nightfall-010.json", "shot.#.exr"),
        render("nightfall-010-graded.json", "graded.#.exr"),
    ];
    for child in both {
        let ran = child.wait_with_output().unwrap();
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    }
    let graded = |lantern: &str| {
        let mut command = film_judge().unwrap();
        command.arg(root().join("scripts/regrade.py")).current_dir(folder.path());
        command.args(["shot.#.exr", "--frames", "49-49", "--light", "sun=0.2"]);
        command.args(["--light", "moon=1.25", "--light", lantern, "--on", "hob", "moon=1.5"]);
        command.args(["--against", "graded.#.exr", "--within", "0.002", "-o", "again.#.exr"]);
        let ran = command.output().unwrap();
        let said = [ran.stdout, ran.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
        (ran.status.success(), said.concat())
    };
    let (is_equal, said) = graded("lantern=0.7,1.0,0.8");
    assert!(is_equal, "{said}");
    let mut kept = film_judge().unwrap();
    let kept = kept.args(["-c", KEPT]).current_dir(folder.path()).output().unwrap();
    assert!(kept.status.success(), "{}", String::from_utf8_lossy(&kept.stderr));
    let (is_equal, said) = graded("lantern=0.7,1.0,0.9");
    assert!(!is_equal && said.contains("frame 49 is"), "another grade is another frame: {said}");
}
