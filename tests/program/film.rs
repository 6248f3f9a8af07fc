//! Frames after they were drawn: verified, shown, varied, killed, and sent to farms.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::{Value as Json, json};

use crate::support::{root, validators::film_judge};

/// A folder with a look that changes with time, and a light.
pub(crate) struct Stage(tempfile::TempDir);

impl Stage {
    pub(crate) fn new() -> Self {
        let stage = Self(tempfile::tempdir().unwrap());
        stage.write_look(0.9);
        stage
    }

    pub(crate) fn write_look(&self, red: f64) {
        let key = |time: f64, red: f64| json!({"time": time, "value": [red, 0.4, 0.2, 1.0]});
        let look = json!({
            "chiaro": "look", "version": 1,
            "lights": {"key": {"direction": [-0.5, 0.8, 0.6]}},
            "nodes": [
                {"id": "base", "kind": "base"},
                {"id": "lit", "kind": "light_layer",
                    "values": {"light": "key", "convex": "#f0d9b0"}},
                {"id": "output", "kind": "output"}
            ],
            "wires": [
                {"from": "base", "to": "lit.below"}, {"from": "lit.below", "to": "output.color"}
            ],
            "exposed": [{"name": "strength", "target": "lit.opacity"}],
            "time_keys": [{"target": "base.color", "keys": [key(0.0, red), key(1.0, 0.1)]}]
        });
        fs::write(self.path("look.json"), look.to_string()).unwrap();
    }

    pub(crate) fn folder(&self) -> &Path {
        self.0.path()
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").current_dir(self.0.path()).args(arguments);
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// Runs a command that succeeds; its standard output and error.
    #[track_caller]
    pub(crate) fn done(&self, arguments: &[&str]) -> [String; 2] {
        let ran = self.run(arguments);
        let [out, err] = [ran.stdout, ran.stderr].map(|text| String::from_utf8(text).unwrap());
        assert!(ran.status.success(), "{arguments:?}: {err}");
        [out, err]
    }

    /// Runs a command that fails; its last line, which is the reason.
    #[track_caller]
    pub(crate) fn fails(&self, code: i32, arguments: &[&str]) -> String {
        let ran = self.run(arguments);
        let said = String::from_utf8(ran.stderr).unwrap();
        assert_eq!(ran.status.code(), Some(code), "{arguments:?}: {said}");
        said
    }

    /// Draws frames by the reference, which needs no driver.
    pub(crate) fn render(&self, pattern: &str, frames: &str) -> Vec<Json> {
        let [out, _] = self.done(&[&RENDER[..], &["-o", pattern, "--frames", frames]].concat());
        out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }

    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

/// A render of small frames.
const RENDER: [&str; 11] = [
    "render",
    "look.json",
    "--size",
    "24x16",
    "--samples",
    "1",
    "--mesh",
    "shape:sphere",
    "--on",
    "reference",
    "--json",
];

fn states(lines: &str) -> Vec<String> {
    let state = |line: &str| serde_json::from_str::<Json>(line).unwrap()["state"].clone();
    lines.lines().map(|line| state(line).as_str().unwrap().to_owned()).collect()
}

#[test]
fn frames_are_verified_against_their_seals_and_another_run() {
    let stage = Stage::new();
    stage.render("a.####.exr", "0-3");
    stage.render("b.####.exr", "0-3");
    let [_, said] = stage.done(&["verify", "a.####.exr", "--against", "b.####.exr"]);
    assert!(
        said.contains("4 frames, all whole, and equal") && said.contains("to the bit"),
        "{said}"
    );
    let bytes = fs::read(stage.path("a.0001.exr")).unwrap();
    fs::write(stage.path("a.0001.exr"), &bytes[..bytes.len() / 2]).unwrap();
    fs::remove_file(stage.path("a.0002.exr")).unwrap();
    let said = stage.fails(1, &["verify", "a.####.exr"]);
    let last = said.lines().last().unwrap();
    assert!(last.contains("of 4 frames, 1 frame broken: 1; 1 frame missing: 2"), "{said}");
    let ran = stage.run(&["verify", "a.####.exr", "--frames", "0-5", "--json"]);
    let lines = String::from_utf8(ran.stdout).unwrap();
    assert_eq!(states(&lines), ["whole", "broken", "missing", "whole", "missing", "missing"]);
    assert!(lines.lines().next().unwrap().contains("\"size\":[24,16]"), "{lines}");
    // The same command makes them whole again; what is not Chiaro's is somebody's, and stays.
    fs::remove_file(stage.path("a.0001.exr")).unwrap();
    let states_of = stage.render("a.####.exr", "0-3");
    let words: Vec<&str> = states_of.iter().map(|line| line["state"].as_str().unwrap()).collect();
    assert_eq!(words, ["kept", "drawn", "drawn", "kept"]);
    stage.write_look(0.8);
    stage.render("c.####.exr", "0-3");
    let said = stage.fails(1, &["verify", "c.####.exr", "--against", "a.####.exr"]);
    assert!(said.contains("frames different: 0-3"), "{said}");
    stage.done(&["verify", "c.####.exr", "--against", "a.####.exr", "--within", "0.5"]);
    let mut other_size = RENDER;
    other_size[3] = "8x8";
    stage.done(&[&other_size[..], &["-o", "c.0001.exr"]].concat());
    let said = stage.fails(1, &["verify", "c.####.exr"]);
    assert!(said.contains("1 frame odd: 1"), "{said}");
    assert!(stage.fails(2, &["verify", "a.exr"]).contains("####"));
    assert!(stage.fails(1, &["verify", "none.####.exr"]).contains("there are no frames"));
    assert!(stage.fails(2, &["verify", "a.####.exr", "--within", "1"]).contains("--against"));
}

#[test]
fn a_mixture_of_states_of_a_document_is_told_by_verify_and_by_jobs() {
    let stage = Stage::new();
    fs::create_dir(stage.path("out")).unwrap();
    stage.render("out/#.exr", "1-6");
    let drawn_with = &RENDER[1..10];
    let verify = ["verify", "out/#.exr", "--frames", "1-6", "--of"];
    let verify = [&verify[..], drawn_with].concat();
    let [_, said] = stage.done(&verify);
    assert!(said.contains("6 frames, all whole, and of look.json as it is now"), "{said}");
    // Other options are another picture.
    let said = stage.fails(1, &[&verify[..], &["--turn-lights=30"]].concat());
    assert!(said.contains("6 frames of another state of look.json: 1-6"), "{said}");
    stage.fails(2, &[&verify[..], &["--no-such-option"]].concat());
    // Frames with layers tell which options they were drawn with.
    let layered = ["-o", "layered.#.exr", "--frames", "1-2", "--aov", "lights"];
    stage.done(&[&RENDER[..], &layered].concat());
    let of_layered = [&["verify", "layered.#.exr", "--of"][..], drawn_with].concat();
    let said = stage.fails(1, &of_layered);
    assert!(said.contains("add --aov=lights after look.json"), "{said}");
    assert!(said.contains("2 frames of look.json as it is now, with more options: 1-2"), "{said}");
    stage.done(&[&of_layered[..], &["--aov=lights"]].concat());
    // A task of an earlier state of the look is lost, and nobody sees it in the files alone.
    stage.write_look(0.5);
    for frame in [3, 4] {
        fs::remove_file(stage.path(&format!("out/{frame}.exr"))).unwrap();
    }
    stage.render("out/#.exr", "3-4");
    stage.done(&["verify", "out/#.exr", "--frames", "1-6"]);
    let said = stage.fails(1, &verify);
    assert!(
        said.contains("of 6 frames, 4 frames of another state of look.json: 1-2,5-6"),
        "{said}"
    );
    let farm = ["farm", "-o", "out/#.exr", "--frames", "1-6", "--to"];
    for word in ["slurm", "openjd", "opencue", "flamenco"] {
        let job = &stage.done(&[&farm[..], &[word], drawn_with].concat())[0];
        assert!(job.contains("--frames 1-6 --of look.json"), "{word}: {job}");
        assert!(job.contains("--on=reference"), "{word}: {job}");
    }
    stage.render("out/#.exr", "1-6");
    stage.done(&verify);
}

#[test]
fn frames_are_shown_on_a_sheet_and_as_a_movie() {
    let stage = Stage::new();
    stage.render("a.####.exr", "0-3");
    stage.done(&["sheet", "a.####.exr", "-o", "sheet.png", "--columns", "2", "--title", "a"]);
    let sheet = image::open(stage.path("sheet.png")).unwrap().to_rgba8();
    let lit = sheet.pixels().filter(|pixel| pixel[0] > 150 && pixel[2] < 120).count();
    assert!(sheet.width() > 64 && lit > 20, "the sphere is seen: {lit}");
    let again = ["sheet", "a.####.exr", "-o", "sheet.png", "--cells", "2"];
    assert!(stage.done(&again)[1].contains("2 of 4 frames"));
    stage.done(&["movie", "a.####.exr", "-o", "review.png", "--rate", "12"]);
    let movie = fs::read(stage.path("review.png")).unwrap();
    let count = movie.windows(4).filter(|bytes| *bytes == b"fcTL").count();
    assert_eq!(count, 4, "a control for each frame");
    assert!(image::load_from_memory(&movie).is_ok(), "others show the first frame");
    stage.done(&["movie", "a.####.exr", "--to", "apng", "-o", "moves", "--rate", "12"]);
    assert!(fs::read(stage.path("moves")).unwrap() == movie);
    // Without ffmpeg another way is told.
    let mut command = stage.command(&["movie", "a.####.exr", "-o", "review.mp4"]);
    let ran = command.env("PATH", stage.folder()).output().unwrap();
    let said = String::from_utf8_lossy(&ran.stderr).into_owned();
    assert!(!ran.status.success() && said.contains(".png") && said.contains("ffmpeg"), "{said}");
    assert!(stage.fails(1, &["movie", "a.####.exr", "-o", "review.gif"]).contains(".png"));
}

#[test]
fn a_wedge_draws_every_combination() {
    let stage = Stage::new();
    let wedge = [
        "wedge",
        "look.json",
        "-o",
        "wedge.png",
        "--size",
        "24x16",
        "--samples",
        "1",
        "--on",
        "reference",
        "--mesh",
        "shape:sphere",
    ];
    let with = |more: &[&'static str]| [&wedge[..], more].concat();
    let varied = ["--vary", "key.direction=[1,0,0],[0,1,0]", "--vary", "lit.convex=#f00,#00f"];
    stage.done(&with(&varied));
    let told: Json = serde_json::from_slice(&fs::read(stage.path("wedge.json")).unwrap()).unwrap();
    let cells = told["cells"].as_array().unwrap();
    let last = json!({"key.direction": [0.0, 1.0, 0.0], "lit.convex": "#0000ff"});
    assert_eq!((cells.len(), &cells[3]["values"]), (4, &last));
    let sheet = image::open(stage.path("wedge.png")).unwrap();
    for cell in cells {
        let place: Vec<u32> = serde_json::from_value(cell["place"].clone()).unwrap();
        assert_eq!(place[2..], [24, 16], "the window finds cells on the sheet by their places");
        assert!(place[0] + 24 <= sheet.width() && place[1] + 16 <= sheet.height());
    }
    let read = |at: usize| fs::read(stage.path(cells[at]["picture"].as_str().unwrap())).unwrap();
    assert!(read(0) != read(1) && read(1) != read(3) && read(0) != read(2));
    // What a cell shows is what the look shows with its values.
    let text = fs::read_to_string(stage.path("look.json")).unwrap();
    let text = text.replace("[-0.5,0.8,0.6]", "[0,1,0]").replace("#f0d9b0", "#0000ff");
    fs::write(stage.path("cell.json"), text).unwrap();
    let mut by_hand = wedge;
    (by_hand[0], by_hand[1], by_hand[3]) = ("render", "cell.json", "cell.png");
    stage.done(&by_hand);
    let pixels = |bytes: &[u8]| image::load_from_memory(bytes).unwrap().to_rgba8();
    assert_eq!(pixels(&read(3)), pixels(&fs::read(stage.path("cell.png")).unwrap()));
    // Times are one more thing that varies, and another sheet replaces the last.
    stage.done(&with(&["--vary", "strength=0..1/2", "--frames", "0,24"]));
    let told: Json = serde_json::from_slice(&fs::read(stage.path("wedge.json")).unwrap()).unwrap();
    assert_eq!(told["cells"][3]["frame"], json!(24));
    let refused = |code: i32, more: &[&'static str]| stage.fails(code, &with(more));
    assert!(refused(1, &["--vary", "key.intensty=1,2"]).contains("`key.intensity`"));
    assert!(refused(1, &["--vary", "lit.below=1,2"]).contains("wired"));
    assert!(refused(1, &["--vary", "key.intensity=#fff"]).contains("a number"));
    assert!(
        refused(2, &["--vary", "strength=0..1/100", "--vary", "lit.offset=0..1/100"])
            .contains("100 x 100 x 1 are more than 480 cells")
    );
    assert!(refused(2, &["--vary", "strength"]).contains("0.5..2/4"));
}

/// A value within a group varies in the use that its path names, whatever its type.
#[test]
fn a_wedge_varies_one_use_of_a_group() {
    let stage = Stage::new();
    let look = |first: &str, keyed: Json| {
        let part = |lit: Json| {
            json!({"inputs": [{"name": "below"}], "outputs": [{"name": "color"}], "nodes": [lit],
                "wires": [{"from": "inputs.below", "to": "lit.below"},
                    {"from": "lit", "to": "outputs.color"}]})
        };
        let lit = |opacity: f64, blend: &str| {
            json!({"id": "lit", "kind": "light_layer", "values": {"light": "key",
                "convex": "#f0d9b0", "opacity": opacity, "blend": blend}})
        };
        json!({"chiaro": "look", "version": 1, "lights": {"key": {"direction": [-0.5, 0.8, 0.6]}},
            "nodes": [{"id": "base", "kind": "base"}, {"id": "first", "kind": first},
                {"id": "second", "kind": "part"}, {"id": "output", "kind": "output"}],
            "wires": [{"from": "base", "to": "first.below"},
                {"from": "first", "to": "second.below"}, {"from": "second", "to": "output.color"}],
            "definitions": {"part": part(lit(0.5, "alpha")), "clear": part(lit(0.2, "alpha")),
                "dark": part(lit(0.5, "multiply"))},
            "time_keys": keyed})
        .to_string()
    };
    let keys = [0.3, 0.9].map(|value| json!({"time": value, "value": value}));
    let keyed = json!([{"target": "first/lit.opacity", "keys": keys}]);
    fs::write(stage.path("groups.json"), look("part", keyed.clone())).unwrap();
    let words =
        ["--size", "24x16", "--samples", "1", "--on", "reference", "--mesh", "shape:sphere"];
    let wedge = |vary: &str| {
        [&["wedge", "groups.json", "-o", "w.png", "--vary", vary][..], &words].concat().join(" ")
    };
    let done = |line: &str| stage.done(&line.split(' ').collect::<Vec<_>>());
    let refused = |line: &str| stage.fails(1, &line.split(' ').collect::<Vec<_>>());
    // Keys of what varies are left out, all others hold.
    for (vary, own, kept) in [
        ("first/lit.opacity=0.8,0.2", "clear", json!([])),
        ("first/lit.blend=alpha,multiply", "dark", keyed),
    ] {
        let [_, told] = done(&wedge(vary));
        assert!(told.contains("in `first` alone") && told.contains("by `second` too"), "{told}");
        // The picture of a look whose first group is another one.
        fs::write(stage.path("own.json"), look(own, kept)).unwrap();
        done(&[&["render", "own.json", "-o", "own.png"][..], &words].concat().join(" "));
        let pixels = |name: &str| image::open(stage.path(name)).unwrap().to_rgba8();
        assert_eq!(pixels("w/002.png"), pixels("own.png"), "{vary}");
        assert_ne!(pixels("w/001.png"), pixels("w/002.png"), "{vary}");
    }
    assert!(refused(&wedge("first/lit.opacty=1,2")).contains("`first/lit.opacity`"));
    assert!(refused(&wedge("first/lit.below=1,2")).contains("`first.below`"));
    assert!(refused(&wedge("first/lit.opacity=#fff")).contains("expected a number"));
}

/// A varied value stands over what a shot sets and keys, wherever the shot says it.
#[test]
fn a_wedge_stands_over_what_a_shot_changes() {
    let stage = Stage::new();
    let write = |name: &str, json: Json| fs::write(stage.path(name), json.to_string()).unwrap();
    write(
        "scene.json",
        json!({"chiaro": "scene", "version": 1,
            "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}],
            "lights": {"key": {"direction": [-0.5, 0.8, 0.6], "groups": ["stage"]}}}),
    );
    let keys = |target: &str, from: f64| {
        json!({"target": target,
            "keys": [{"frame": 0, "value": from}, {"frame": 9, "value": 0.9}]})
    };
    let shot = |overrides: Json| {
        json!({"chiaro": "shot", "version": 1, "scene": "scene.json", "frames": [0, 9],
            "overrides": overrides})
    };
    let all =
        ["lights.key.intensity", "light_groups.stage.intensity", "objects.ball.values.strength"];
    write("shot.json", shot(all.iter().map(|target| keys(target, 0.2)).collect()));
    let words =
        ["--size", "24x16", "--samples", "1", "--on", "reference", "--frames", "5", "-o", "w.png"];
    for varied in all {
        let vary = format!("{varied}=0.4,0.8");
        stage.done(&[&["wedge", "shot.json", "--vary", &vary][..], &words].concat());
        let held = |target: &&str| {
            if *target == varied {
                json!({"target": target, "value": 0.8})
            } else {
                keys(target, 0.2)
            }
        };
        write("held.json", shot(all.iter().map(held).collect()));
        let held = [&["render", "held.json"][..], &words[..8], &["-o", "h.#.png"]].concat();
        stage.done(&held);
        let pixels = |name: &str| image::open(stage.path(name)).unwrap().to_rgba8();
        assert_eq!(pixels("w/002.png"), pixels("h.5.png"), "{varied}");
        assert_ne!(pixels("w/001.png"), pixels("w/002.png"), "{varied}");
    }
    let refused = ["wedge", "shot.json", "--vary", "light_groups.stage.exposur=1,2"];
    assert!(stage.fails(1, &[&refused[..], &words].concat()).contains("exposure"));
}

#[test]
fn jobs_of_farms_hand_every_option_on() {
    let stage = Stage::new();
    fs::create_dir(stage.path("out")).unwrap();
    let farm = [
        "farm",
        "look.json",
        "-o",
        "out/####.exr",
        "--frames",
        "-2-21",
        "--chunk",
        "5",
        "--depth",
        "float",
        "--turn-lights",
        "-30",
        "--strict",
        "--to",
    ];
    let job = |word: &'static str| stage.done(&[&farm[..], &[word]].concat())[0].clone();
    for word in ["slurm", "openjd", "opencue", "flamenco"] {
        let text = job(word);
        for needed in ["--depth=float", "--turn-lights=-30", "--strict", "look.json", "verify"] {
            assert!(text.contains(needed), "{word}: no {needed} in {text}");
        }
    }
    fs::write(stage.path("job.sh"), job("slurm")).unwrap();
    assert!(Command::new("bash").arg("-n").arg(stage.path("job.sh")).status().unwrap().success());
    assert!(job("slurm").contains("chunks=(-2-2 3-7 8-12 13-17 18-21)"), "{}", job("slurm"));
    let template: Json = serde_json::from_str(&job("openjd")).unwrap();
    assert_eq!(template["specificationVersion"], "jobtemplate-2023-09");
    // A look elsewhere is told, with the folder that holds both.
    fs::create_dir(stage.path("far")).unwrap();
    let mut far = Command::new(env!("CARGO_BIN_EXE_chiaro"));
    far.current_dir(stage.path("far")).env("CHIARO_CACHE_DIR", "");
    far.args(["farm", "../look.json", "-o", "#.exr", "--frames", "1-2", "--to", "openjd"]);
    let far = far.output().unwrap();
    let said = String::from_utf8_lossy(&far.stderr);
    let folder = stage.path("").canonicalize().unwrap();
    let hint = format!("call chiaro farm in {}", folder.display());
    assert!(said.contains("outside this folder") && said.contains(&hint), "{said}");
    let template: Json = serde_json::from_slice(&far.stdout).unwrap();
    let look = folder.join("look.json").display().to_string();
    assert!(template["description"].as_str().unwrap().contains(&look), "{template}");
    let cue = job("opencue");
    assert!(cue.contains("<range>-2-21</range>") && cue.contains("<chunk>5</chunk>"), "{cue}");
    // A job that somebody may have changed stays.
    let file = [&farm[..], &["slurm", "--job", "job.sh"]].concat();
    stage.done(&file);
    fs::write(stage.path("job.sh"), "mine").unwrap();
    assert!(stage.fails(1, &file).contains("there already"));
    let said = stage.fails(2, &[&farm[..], &["deadline"]].concat());
    assert!(said.contains("slurm, openjd, opencue, flamenco"), "{said}");
    // What every task would refuse is refused at once.
    let said = stage.fails(1, &[&farm[..], &["slurm", "--aov", "lightz"]].concat());
    assert!(said.contains("`lightz`") && said.contains("did you mean `lights`"), "{said}");
    let simulated = [&farm[..], &["slurm", "--simulate", "100"]].concat();
    assert!(stage.done(&simulated)[0].contains("frames that are whole are kept"));
}

#[test]
fn progress_is_told_as_open_job_description_reads_it() {
    let stage = Stage::new();
    let words: Vec<&str> = RENDER.iter().copied().filter(|word| *word != "--json").collect();
    let more = ["-o", "#.exr", "--frames", "0-3", "--progress", "openjd"];
    let [out, _] = stage.done(&[&words[..], &more].concat());
    let lines: Vec<&str> = out.lines().filter(|line| line.contains("progress")).collect();
    assert_eq!(lines, ["25.0", "50.0", "75.0", "100.0"].map(|x| format!("openjd_progress: {x}")));
}

/// Ends the program by force when its file has so many bytes; every frame that is there is whole.
#[cfg(target_os = "linux")]
fn kill_at_random_bytes(kills: u32) {
    let stage = Stage::new();
    stage.render("a.#.exr", "0");
    let length = fs::metadata(stage.path("a.0.exr")).unwrap().len();
    let mut random = 0x5eed_u64;
    for kill in 0..kills {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let bytes = (random >> 33) % (length * 3 / 4);
        let mut limited = Command::new("prlimit");
        limited.arg(format!("--fsize={bytes}")).arg("--core=0");
        limited.arg(env!("CARGO_BIN_EXE_chiaro")).args(RENDER);
        limited.args(["-o", "a.#.exr", "--frames", "0-3"]);
        limited.env("CHIARO_CACHE_DIR", "").current_dir(stage.folder());
        let ran = limited.output().unwrap();
        assert!(!ran.status.success(), "kill {kill} at byte {bytes}: {ran:?}");
        let whole = |name: &str| {
            let stored = chiaro::film::StoredFrame::read(&fs::read(stage.path(name)).unwrap());
            stored.is_ok_and(|stored| stored.is_sealed)
        };
        let names = stage.names();
        let frames: Vec<&String> = names.iter().filter(|name| name.ends_with(".exr")).collect();
        assert!(!frames.is_empty() && frames.iter().all(|name| whole(name)), "{bytes}: {names:?}");
    }
    // The next run takes up the rest, and clears away what was begun.
    stage.render("a.#.exr", "0-3");
    stage.done(&["verify", "a.#.exr", "--frames", "0-3"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_kill_at_any_byte_leaves_frames_that_are_absent_or_whole() {
    kill_at_random_bytes(5);
}

#[cfg(target_os = "linux")]
#[test]
#[ignore = "a hundred runs"]
fn soak_a_hundred_kills_leave_frames_that_are_absent_or_whole() {
    kill_at_random_bytes(100);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_a_vanished_mesh_and_a_changed_look_lose_nothing() {
    let stage = Stage::new();
    fs::write(stage.path("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    stage.render("a.#.exr", "0-1");
    let before = fs::read(stage.path("a.1.exr")).unwrap();
    // A file that may not grow is a disk that is full: the signal is ignored, the write fails.
    let words = [&RENDER[..], &["-o", "a.#.exr", "--frames", "0-3"]].concat().join(" ");
    let program = env!("CARGO_BIN_EXE_chiaro");
    let script = format!("trap '' XFSZ; exec prlimit --fsize=100 '{program}' {words}");
    let mut full = Command::new("sh");
    full.args(["-c", &script]).env("CHIARO_CACHE_DIR", "").current_dir(stage.folder());
    let ran = full.output().unwrap();
    let said = String::from_utf8_lossy(&ran.stderr).into_owned();
    assert_eq!(ran.status.code(), Some(1), "{said}");
    assert!(said.contains("cannot-write") && said.contains("a.2.exr"), "{said}");
    assert_eq!(fs::read(stage.path("a.1.exr")).unwrap(), before);
    assert!(stage.names().iter().all(|name| !name.ends_with(".tmp")), "{:?}", stage.names());
    // A folder that takes no files, not even from root.
    let closed = [&RENDER[..], &["-o", "/sys/a.#.exr", "--frames", "0-1"]].concat();
    let said = stage.fails(1, &closed);
    assert!(said.contains("cannot-write") && said.contains("/sys"), "{said}");
    // A mesh that is gone is named, and the frames stay.
    let words: Vec<&str> =
        RENDER.map(|word| if word == "shape:sphere" { "mesh.obj" } else { word }).to_vec();
    let drawn = [&words[..], &["-o", "m.#.exr", "--frames", "0-1"]].concat();
    stage.done(&drawn);
    fs::remove_file(stage.path("mesh.obj")).unwrap();
    assert!(stage.fails(1, &drawn).contains("mesh.obj"));
    stage.done(&["verify", "m.#.exr", "--frames", "0-1"]);
    // A look that is changed in the middle is drawn anew, for frames of a shot are of one look.
    stage.write_look(0.3);
    let states = stage.render("a.#.exr", "0-3");
    let words: Vec<&str> = states.iter().map(|line| line["state"].as_str().unwrap()).collect();
    assert_eq!(words, ["drawn"; 4]);
    stage.done(&["verify", "a.#.exr", "--frames", "0-3"]);
}

#[test]
fn runs_on_one_adapter_are_equal_to_the_bit() {
    let stage = Stage::new();
    let on_gpu = RENDER.map(|word| match word {
        "reference" => "gpu",
        "1" => "4",
        other => other,
    });
    for pattern in ["a.##.exr", "b.##.exr"] {
        let drawn = [&on_gpu[..], &["-o", pattern, "--frames", "0,9,18"]].concat();
        assert_eq!(states(&stage.done(&drawn)[0]), ["drawn"; 3], "each is a picture of its own");
    }
    let read = |name: &str| fs::read(stage.path(name)).unwrap();
    for frame in ["00", "09", "18"] {
        assert!(read(&format!("a.{frame}.exr")) == read(&format!("b.{frame}.exr")), "{frame}");
    }
    stage.done(&["verify", "b.##.exr", "--frames", "0,9,18", "--against", "a.##.exr"]);
}

#[test]
fn files_that_change_while_frames_are_drawn_of_them_are_told() {
    use std::process::Stdio;
    let stage = Stage::new();
    fs::write(stage.path("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    // Lines of all frames are longer than a pipe holds: the run waits until they are read.
    let long: PathBuf = ["f".repeat(200), "g".repeat(200), "h".repeat(200)].iter().collect();
    fs::create_dir_all(stage.path("out").join(&long)).unwrap();
    let pattern = Path::new("out").join(&long).join("#.png").display().to_string();
    let on_mesh = RENDER.map(|word| if word == "shape:sphere" { "mesh.obj" } else { word });
    let words = [&on_mesh[..], &["-o", &pattern, "--frames", "0-199"]].concat();
    let mut command = stage.command(&words);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let first = stage.path("out").join(&long).join("0.png");
    while !first.exists() {
        std::thread::yield_now();
    }
    stage.write_look(0.25);
    let mesh = fs::read(stage.path("mesh.obj")).unwrap();
    fs::remove_file(stage.path("mesh.obj")).unwrap();
    let ran = child.wait_with_output().unwrap();
    let said = String::from_utf8(ran.stderr).unwrap();
    assert_eq!(ran.status.code(), Some(1), "{said}");
    let reason = said.lines().last().unwrap();
    assert!(reason.starts_with("error[files-changed]"), "the reason is the last line: {said}");
    assert!(reason.contains("look.json (all frames are of it as it was)"), "{reason}");
    assert!(reason.contains("mesh.obj (gone; all frames"), "{reason}");
    // Nothing is lost, and nothing old is kept.
    let states_of_all = states(&String::from_utf8(ran.stdout).unwrap());
    let (moving, after) = states_of_all.split_at(25);
    assert_eq!(moving, ["drawn"; 25]);
    assert_eq!(after, ["equal"; 175], "the look moves for a second");
    stage.done(&["verify", &pattern, "--frames", "0-199"]);
    fs::write(stage.path("mesh.obj"), mesh).unwrap();
    let again = [&on_mesh[..], &["-o", &pattern, "--frames", "0-3"]].concat();
    assert_eq!(states(&stage.done(&again)[0]), ["drawn"; 4]);
    assert_eq!(states(&stage.done(&again)[0]), ["kept"; 4]);
}

#[cfg(unix)]
#[test]
fn a_polite_request_to_end_is_met_between_frames() {
    use std::io::{BufRead as _, BufReader};
    use std::process::Stdio;
    let stage = Stage::new();
    let words = [&RENDER[..], &["-o", "a.#.exr", "--frames", "0-9999"]].concat();
    let mut child = stage.command(&words).stdout(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    lines.next().unwrap().unwrap();
    let clock = seconds_from_now();
    Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap();
    let status = child.wait().unwrap();
    assert!(clock() < 10.0 && status.code() == Some(130), "{status}");
    assert!(stage.names().iter().all(|name| !name.ends_with(".tmp")), "{:?}", stage.names());
    stage.done(&["verify", "a.#.exr"]);
}

#[cfg(unix)]
#[expect(clippy::disallowed_methods, reason = "a test of how long something takes")]
fn seconds_from_now() -> impl Fn() -> f64 {
    let start = std::time::Instant::now();
    move || start.elapsed().as_secs_f64()
}

#[test]
fn open_job_descriptions_own_tool_takes_the_template_and_runs_it() {
    if film_judge().is_none() {
        return;
    }
    let stage = Stage::new();
    fs::create_dir(stage.path("out")).unwrap();
    let program = env!("CARGO_BIN_EXE_chiaro");
    let farm = ["farm", "-o", "out/####.exr", "--frames", "1-6", "--chunk", "3", "--to", "openjd"];
    let more = ["--job", "job.json", "--program", program];
    stage.done(&[&farm[..], &more[..], &RENDER[1..10]].concat());
    let ran = |words: &[&str]| {
        let mut openjd = film_judge().unwrap();
        let ran = openjd.args(["-m", "openjd"]).args(words).current_dir(stage.folder());
        let ran = ran.output().unwrap();
        let said = [ran.stdout, ran.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
        assert!(ran.status.success(), "{words:?}: {said:?}");
        said.join("\n")
    };
    ran(&["check", "job.json"]);
    let folder = format!("Folder={}", stage.folder().display());
    let said = ran(&["run", "job.json", "-p", &folder, "--step", "Check", "--run-dependencies"]);
    assert!(said.contains("openjd_progress: 100.0"), "{said}");
    assert!(
        said.contains("6 frames, all whole") && stage.path("out/sheet.png").is_file(),
        "{said}"
    );
}

/// OpenCue's own RQD runs the commands of the job: `tests/farm/rqd.py` plays Cuebot.
#[test]
fn open_cues_own_rqd_runs_the_job() {
    let Some(mut python) = film_judge() else { return };
    let stage = Stage::new();
    fs::create_dir(stage.path("out")).unwrap();
    let program = env!("CARGO_BIN_EXE_chiaro");
    let farm = ["farm", "-o", "out/####.exr", "--frames", "1-4", "--chunk", "2", "--to", "opencue"];
    let more = ["--job", "job.xml", "--program", program];
    stage.done(&[&farm[..], &more[..], &RENDER[1..10]].concat());
    python.arg(root().join("tests/farm/rqd.py"));
    python.args(["job.xml", "."]).current_dir(stage.folder());
    let ran = python.output().unwrap();
    let said = [ran.stdout, ran.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    assert!(ran.status.success(), "{said:?}");
    assert_eq!(
        said[0].matches("exit 0").count(),
        3,
        "two tasks, the check with its sheet: {said:?}"
    );
    stage.done(&["verify", "out/####.exr", "--frames", "1-4"]);
    assert!(stage.path("out/sheet.png").is_file(), "{said:?}");
}
