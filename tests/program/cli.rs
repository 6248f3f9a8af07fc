//! The program itself, with each subcommand run as from a shell: results, messages, exit codes,
//! files.

use crate::support;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::{Value as Json, json};

/// A folder for one test, and the program run in it.
struct Shop(tempfile::TempDir);

/// Result of a run.
struct Ran {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Shop {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(self.0.path())
            .unwrap()
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        // Without a cache, so that a run computes what it shows.
        command.args(arguments).current_dir(self.0.path()).env("CHIARO_CACHE_DIR", "");
        command
    }

    fn run(&self, arguments: &[&str]) -> Ran {
        Ran::of(self.command(arguments).output().unwrap())
    }

    /// Runs the program without any GPU driver, so that a subcommand that needs a GPU fails.
    fn run_without_gpu(&self, arguments: &[&str]) -> Ran {
        let no_gpu =
            [("WGPU_BACKEND", "noop"), ("VK_DRIVER_FILES", "/none"), ("VK_ICD_FILENAMES", "/none")];
        Ran::of(self.command(arguments).envs(no_gpu).output().unwrap())
    }
}

impl Ran {
    fn of(output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        let ran =
            Self { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) };
        assert!(!ran.err.contains("panicked"), "{}", ran.err);
        ran
    }

    #[track_caller]
    fn ok(self) -> Self {
        assert_eq!(self.code, Some(0), "{}{}", self.out, self.err);
        self
    }

    #[track_caller]
    fn fails(self, code: i32, with: &[&str]) -> Self {
        assert_eq!(self.code, Some(code), "{}{}", self.out, self.err);
        for text in with {
            assert!(self.err.contains(text), "no `{text}` in\n{}", self.err);
        }
        self
    }

    #[track_caller]
    fn json(&self) -> Json {
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error} in\n{}", self.out))
    }
}

/// A look with a layer of one color under the light `key`, hard where u is 1 radian; its color and
/// offset can be set.
const LOOK: &str = r#"{
  "name": "Flat",
  "lights": {"key": {"direction": [0, 0, 1]}},
  "nodes": [
    {"id": "paper", "kind": "base", "values": {"color": [0.25, 0.5, 0.75]}},
    {"id": "layer", "kind": "light_layer", "values": {"light": "key", "offset": 1, "falloff": 1,
    "cutoff": 1,
      "convex": [1, 0, 0], "concave": [1, 0, 0], "blend": "alpha"}},
    {"kind": "output"}
  ],
  "wires": [{"from": "paper", "to": "layer.below"}, {"from": "layer.below", "to": "output.color"}],
  "exposed": [{"name": "paint", "target": "layer.convex"},
  {"name": "cover", "target": "layer.opacity"},
              {"name": "how", "target": "layer.blend"}]
}"#;

fn shop() -> Shop {
    let shop = Shop::new();
    shop.write("flat.json", LOOK);
    shop
}

/// Width and height from a PNG's header, after checking the file's first and last bytes.
fn png_size(path: &Path) -> [u32; 2] {
    let bytes = fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    assert_eq!(&bytes[bytes.len() - 8..bytes.len() - 4], b"IEND");
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    [number(16), number(20)]
}

#[test]
fn every_subcommand_has_help_with_examples_and_exit_codes_are_documented() {
    let shop = Shop::new();
    let top = shop.run(&["--help"]).ok().out;
    assert!(top.contains("Exit codes: 0 done; 1 ") && top.contains("130"), "{top}");
    let drawing: &[&str] = if cfg!(feature = "gpu") { &["render", "eval"] } else { &[] };
    for command in [
        &[
            "edit", "new", "check", "explain", "shot", "nodes", "fit", "export", "import", "mesh",
            "hcbtf", "desktop", "verify", "sheet", "movie", "wedge", "farm", "comp",
        ],
        drawing,
    ]
    .concat()
    {
        assert!(top.contains(&format!("  {command} ")), "{top}");
        let help = shop.run(&[command, "--help"]).ok().out;
        assert!(
            help.contains("Examples:") && help.contains(&format!("chiaro {command}")),
            "{help}"
        );
    }
    assert!(shop.run(&["--version"]).ok().out.starts_with("chiaro "));
    shop.run(&["paint"]).fails(2, &["unrecognized subcommand"]);
    let similar = "similar subcommand exists: 'render'";
    shop.run(&["rendr", "look.json", "-o", "a.png"]).fails(2, &[similar]);
    shop.run(&["chekc"]).fails(2, &["'check'"]);
    shop.run(&["export", "a.json"]).fails(2, &["--to"]);
    if cfg!(feature = "gpu") {
        shop.run(&["render", "a.json"]).fails(2, &["--output"]);
    }
}

/// A look of one layer in `color`, over a dark base.
fn lit_look(color: &str) -> String {
    let values =
        r#""light": "key", "blend": "alpha", "offset": 0.3, "falloff": 0.8, "cutoff": 1.2"#;
    format!(
        r##"{{"chiaro": "look", "version": 1,
            "lights": {{"key": {{"direction": [-0.4, 0.5, 0.7]}}}},
            "nodes": [{{"id": "base", "kind": "base", "values": {{"color": "#202030"}}}},
            {{"id": "lit", "kind": "light_layer", "values": {{{values}, "convex": "{color}"}}}},
            {{"id": "output", "kind": "output"}}],
            "wires": [{{"from": "base", "to": "lit.below"}}, {{"from": "lit.below",
            "to": "output.color"}}]}}"##
    )
}

#[test]
fn a_look_is_fitted_to_what_was_painted() {
    let shop = Shop::new();
    shop.write("wished.json", &lit_look("#c08040"));
    shop.write("look.json", &lit_look("#808080"));
    let drawn =
        ["--backdrop", "none", "--samples", "1", "--size", "32x32", "--mesh", "shape:sphere"];
    shop.run(
        &[&["render", "wished.json", "-o", "painted.png", "--on", "reference"], &drawn[..]]
            .concat(),
    )
    .ok();
    let fit =
        ["fit", "look.json", "--target", "painted.png", "--mesh", "shape:sphere", "--starts", "1"];
    let asked =
        ["--keep", "lights,profiles", "-o", "fitted.json", "--misses", "misses.png", "--json"];
    let told: Json =
        serde_json::from_str(&shop.run(&[&fit[..], &asked].concat()).ok().out).unwrap();
    let error = |when: &str| told["report"][when].as_f64().unwrap();
    assert!(error("before") > 0.05 && error("after") < 1.0 / 255.0, "{told}");
    assert_eq!(told["file"], "fitted.json");
    let fitted: Json =
        serde_json::from_str(&fs::read_to_string(shop.path("fitted.json")).unwrap()).unwrap();
    assert_eq!(fitted["lights"]["key"]["direction"], json!([-0.4, 0.5, 0.7]), "{fitted}");
    let color = &fitted["nodes"][1]["values"]["convex"];
    for (channel, wished) in [0xc0, 0x80, 0x40].into_iter().enumerate() {
        assert!(
            (255.0 * color[channel].as_f64().unwrap() - f64::from(wished)).abs() < 1.5,
            "{color}"
        );
    }
    assert_eq!(png_size(&shop.path("misses.png")), [32, 32]);
    assert_eq!(fs::read_to_string(shop.path("look.json")).unwrap(), lit_look("#808080"));
    // Two dots tell too little, which is a warning; and another look is not replaced without
    // `--force`.
    let told: Json =
        serde_json::from_str(&shop.run(&[&fit[..], &["--dry-run", "--json"]].concat()).ok().out)
            .unwrap();
    assert_eq!(
        told["report"]["turned"],
        json!(2 + 3 + 2 * 3),
        "a light, a profile, and two colors"
    );
    let mut dots = image::open(shop.path("painted.png")).unwrap().into_rgba8();
    dots.enumerate_pixels_mut()
        .filter(|(x, y, _)| ![[12, 16], [20, 16]].contains(&[*x, *y]))
        .for_each(|(_, _, pixel)| {
            pixel.0 = [0; 4];
        });
    dots.save(shop.path("dots.png")).unwrap();
    let two = [
        "fit",
        "look.json",
        "--target",
        "dots.png",
        "--mesh",
        "shape:sphere",
        "--starts",
        "1",
        "-o",
    ];
    shop.run(&[&two[..], &["fitted.json"]].concat()).fails(1, &["file-exists", "--force"]);
    let warned = ["warning[fit-few-places]", "2 painted pixels in 2 places", "11 numbers"];
    shop.run(&[&two[..], &["fitted.json", "--force"]].concat()).fails(0, &warned);
    // The same picture under turned lights is fitted by nothing but the lights, turned as `render`
    // turns them.
    let turned = [
        &["render", "look.json", "-o", "turned.png", "--turn-lights", "40", "--on", "reference"],
        &drawn[..],
    ];
    shop.run(&turned.concat()).ok();
    let dry = [
        "fit",
        "look.json",
        "--target",
        "turned.png",
        "--mesh",
        "shape:sphere",
        "--dry-run",
        "--json",
        "--starts=1",
    ];
    let told: Json =
        serde_json::from_str(&shop.run(&[&dry[..], &["--turn-lights", "40"]].concat()).ok().out)
            .unwrap();
    assert!(told["report"]["before"].as_f64().unwrap() < 0.5 / 255.0, "{told}");
    // A fit that stays far off is reported, with hints; and a fit that could not change anything is
    // refused.
    let kept = [&fit[..], &["--keep", "lights,profiles,base", "--dry-run"]].concat();
    let far = ["warning[fit-far-off]", "1 color", "1 light, 1 profile", "--keep less", "--misses"];
    let wrong = shop.path("turned.png");
    let mut inverse = image::open(&wrong).unwrap().into_rgba8();
    inverse
        .pixels_mut()
        .for_each(|pixel| (0..3).for_each(|channel| pixel.0[channel] = 255 - pixel.0[channel]));
    inverse.save(shop.path("painted.png")).unwrap();
    shop.run(&kept).fails(0, &far);
    for option in ["--starts=3", "--keep=base"] {
        shop.run(&["fit", "--layers", "1", option, "--target", "painted.png", "--dry-run"])
            .fails(2, &["--layers"]);
    }
    shop.run(&["fit", "look.json"]).fails(2, &["--target"]);
    shop.run(&["fit", "--target", "painted.png"]).fails(2, &["LOOK"]);
    shop.run(&["fit", "look.json", "--target", "none.png"]).fails(1, &["none.png"]);
    shop.run(&["fit", "look.json", "--target", "look.json"]).fails(1, &["fit-target"]);
}

#[test]
fn hcbtfs_are_made_told_of_and_exchanged() {
    let shop = Shop::new();
    let grid = "4x3,2x3,2x2";
    let made = shop.run(&["hcbtf", "new", "grass", "--color", "#204080", "--grid", grid]).ok();
    assert_eq!(made.out, "grass.hcbtf\n");
    shop.run(&["hcbtf", "new", "grass"]).fails(1, &["file-exists", "--force"]);
    shop.run(&["hcbtf", "new", "x", "--color", "green"]).fails(2, &["#rrggbb"]);
    shop.run(&["hcbtf", "new", "x", "--grid", "4x3"]).fails(2, &["32x32,6x10,6x10"]);
    let info = shop.run(&["hcbtf", "info", "grass.hcbtf"]).ok().out;
    for told in [
        "4 x 3 texels",
        "12 samples",
        "painted  1",
        "copy fills 11",
        "quick    8 x 15 in 2 layers, 960 bytes of at most 2.3 KiB: fits every GPU",
        "quick    12 x 15 in 2 layers",
        "compact  38 x 1 in 1 layer, 152 bytes",
        "lambert changes 9",
        "empty    0",
    ] {
        assert!(info.contains(told), "no `{told}` in {info}");
    }
    // Rules are shown in the form that sets them.
    let rules = shop.run(&["hcbtf", "rules", "grass.hcbtf"]).ok();
    assert_eq!(rules.json()[0]["rule"], json!("copy"));
    shop.write("rules.json", &rules.out);
    shop.run(&["hcbtf", "new", "other", "--grid", grid]).ok();
    shop.run(&["hcbtf", "rules", "other.hcbtf", "--set", "rules.json"]).ok();
    assert_eq!(shop.run(&["hcbtf", "rules", "other.hcbtf"]).ok().out, rules.out);
    shop.write("rules.json", r#"[{"rule": "blend", "sharpness": 99}]"#);
    shop.run(&["hcbtf", "rules", "other.hcbtf", "--set", "rules.json"])
        .fails(1, &["out-of-range", "rules[0].sharpness", "99 is out of range", "from 0 to 64"]);
    shop.write("rules.json", r#"[{"rule": "blnd"}, {"rule": "lambert", "amont": 1}, {}]"#);
    let told = [
        "`blnd` is not one of",
        "did you mean `blend`?",
        "`copy`, `lock`, `blend`",
        "`amont`",
        "did you mean `amount`?",
    ];
    shop.run(&["hcbtf", "rules", "other.hcbtf", "--set", "rules.json"]).fails(1, &told);
    shop.run(&["hcbtf", "new", "short", "--grid", grid]).ok();
    shop.write("short.json", r#"[{"rule": "blend"}, {"rule": "lambert", "amount": 0.5}]"#);
    shop.run(&["hcbtf", "rules", "short.hcbtf", "--set", "short.json"]).ok();
    let set = shop.run(&["hcbtf", "rules", "short.hcbtf"]).ok().json();
    assert_eq!(set[0], json!({"rule": "blend", "sharpness": 4}));
    let help = shop.run(&["hcbtf", "rules", "--help"]).ok().out;
    for told in [
        "  mirror    Highlight\n",
        "sharpness (4): Sharpness of the falloff",
        "a number from 0 to 64",
        "from (straight above): Painted sample to copy",
    ] {
        assert!(help.contains(told), "no `{told}` in {help}");
    }
    let storages = ["palette", "BC7"]
        .map(|word| shop.run(&["hcbtf", "info", "--help"]).ok().out.contains(word));
    assert_eq!(storages, [true; 2]);
    shop.write("rules.json", r#"[{"rule": "strokes", "bundle": []}]"#);
    let kept = shop.run(&["hcbtf", "rules", "other.hcbtf", "--set", "rules.json"]).ok();
    for told in ["rules.json:1:22: warning[unknown-field]", "`bundle`", "did you mean `bundles`?"] {
        assert!(kept.err.contains(told), "no `{told}` in {}", kept.err);
    }
    // The field is still there when the file is read again, and is told of.
    let again = shop.run(&["hcbtf", "rules", "other.hcbtf"]).ok();
    assert_eq!(again.json()[0]["rule"], json!("strokes"));
    assert!(again.err.contains("rules[0].bundle"), "{}", again.err);
    assert_eq!(again.json()[0]["bundle"], json!([]));
    let info = shop.run(&["hcbtf", "info", "grass.hcbtf", "--json"]).ok().json();
    assert_eq!((&info["tiles"], &info["sheet"]), (&json!(2), &json!([16, 30])));
    assert_eq!(info["samples"].as_array().map(Vec::len), Some(12));
    assert_eq!(info["samples"][1]["changed_by"], json!([1]));

    exchange(&shop, grid);
    shop.run(&["hcbtf", "import", "sheet.png", "-o", "x"])
        .fails(1, &["sheet.png: error[hcbtf-sheet]", "1152 x 3840"]);
    shop.run(&["hcbtf", "info", "none.hcbtf"]).fails(1, &["none.hcbtf", "cannot-read"]);
    shop.run(&["hcbtf", "info", "sheet.png"]).fails(1, &["hcbtf-archive"]);
    shop.run(&["hcbtf", "export", "grass.hcbtf", "--painted", "-o", "x.png"])
        .fails(2, &["--to folder"]);
    assert!(!shop.path("x.hcbtf").exists());
}

/// Exports and imports in each form: all yield the same sheet.
fn exchange(shop: &Shop, grid: &str) {
    shop.run(&["hcbtf", "export", "grass.hcbtf", "-o", "sheet.png"]).ok();
    assert_eq!(png_size(&shop.path("sheet.png")), [16, 30]);
    shop.run(&["hcbtf", "export", "grass.hcbtf", "--to", "folder", "-o", "all"]).ok();
    shop.run(&[
        "hcbtf",
        "export",
        "grass.hcbtf",
        "--to",
        "contact",
        "--gap",
        "2",
        "-o",
        "contact.png",
    ])
    .ok();
    assert_eq!(png_size(&shop.path("contact.png")), [3 * 4 + 2 * 2, 4 * 3 + 3 * 2]);
    for (from, more) in
        [("sheet.png", &[][..]), ("all", &[]), ("contact.png", &["--as", "contact", "--gap", "2"])]
    {
        let import = ["hcbtf", "import", from, "-o", "back.hcbtf", "--grid", grid, "--force"];
        let told = shop.run(&[&import[..], more].concat()).ok().err;
        // Only a folder tells which samples were painted.
        let painted = if from == "all" { "1 of 12" } else { "12 of 12" };
        assert!(told.contains(&format!("{painted} samples are painted")), "{told}");
        shop.run(&["hcbtf", "export", "back.hcbtf", "-o", "again.png", "--force"]).ok();
        assert_eq!(
            fs::read(shop.path("again.png")).unwrap(),
            fs::read(shop.path("sheet.png")).unwrap(),
            "{from}"
        );
    }
    shop.run(&["hcbtf", "export", "grass.hcbtf", "-o", "grass.ktx2"]).ok();
    let told = shop.run(&["hcbtf", "import", "grass.ktx2", "-o", "back.hcbtf", "--force"]).ok().err;
    assert!(told.contains("12 of 12 samples are painted"), "{told}");
    shop.run(&["hcbtf", "export", "back.hcbtf", "-o", "again.png", "--force"]).ok();
    assert_eq!(
        fs::read(shop.path("again.png")).unwrap(),
        fs::read(shop.path("sheet.png")).unwrap(),
        "KTX2"
    );
    shop.run(&["hcbtf", "export", "grass.hcbtf", "--to", "ktx2", "--compact", "-o", "small.ktx2"])
        .ok();
    shop.run(&["hcbtf", "import", "small.ktx2", "-o", "back.hcbtf", "--force"]).ok();
    shop.run(&["hcbtf", "export", "back.hcbtf", "-o", "again.png", "--force"]).ok();
    assert_eq!(
        fs::read(shop.path("again.png")).unwrap(),
        fs::read(shop.path("sheet.png")).unwrap(),
        "compact"
    );
    shop.run(&["hcbtf", "export", "grass.hcbtf", "--compact", "-o", "x.png"])
        .fails(2, &["--to ktx2"]);
    shop.run(&["hcbtf", "import", "sheet.png", "--as", "ktx2", "-o", "x"])
        .fails(1, &["sheet.png", "bad-ktx2"]);
    let told = shop
        .run(&["hcbtf", "export", "grass.hcbtf", "--to", "folder", "--painted", "-o", "one"])
        .ok();
    assert!(told.err.contains("1 image, and hcbtf.json"), "{}", told.err);
}

#[test]
fn nothing_that_was_exported_is_replaced_unasked_and_names_say_what_is_written() {
    let shop = Shop::new();
    shop.run(&["hcbtf", "new", "grass", "--color", "#204080", "--grid", "2x2,2x3,1x1"]).ok();
    let export = |to: &[&str]| shop.run(&[&["hcbtf", "export", "grass.hcbtf"], to].concat());
    for to in [
        &["-o", "a.png"][..],
        &["-o", "a.ktx2"],
        &["-o", "images/"],
        &["--to", "contact", "-o", "b.png"],
    ] {
        export(to).ok();
        let path = shop.path(to.last().unwrap());
        let before = if path.is_file() { fs::read(&path).unwrap() } else { Vec::new() };
        export(to).fails(1, &["file-exists", "--force", to.last().unwrap().trim_end_matches('/')]);
        assert!(!path.is_file() || fs::read(&path).unwrap() == before);
        export(&[to, &["--force"]].concat()).ok();
    }
    assert_eq!(&fs::read(shop.path("a.ktx2")).unwrap()[..7], b"\xabKTX 20");
    // Files that an earlier export left are no part of the next; other files stay.
    shop.write("images/notes.txt", "mine");
    assert_eq!(fs::read_dir(shop.path("images")).unwrap().count(), 4 + 1 + 1);
    export(&["-o", "images/", "--painted", "--force"]).ok();
    assert_eq!(fs::read_dir(shop.path("images")).unwrap().count(), 1 + 1 + 1);
    export(&["-o", "a.jpg"]).fails(2, &["a.jpg", ".png", ".ktx2"]);
    export(&["--to", "sheet", "-o", "c.ktx2"]).fails(2, &["--to sheet", ".png"]);
    export(&["--to", "folder", "-o", "c.png"]).fails(2, &["--to folder"]);
    assert!(!shop.path("c.ktx2").exists() && !shop.path("c.png").exists());
}

#[test]
fn a_folder_knows_its_grid_its_rules_and_what_was_painted() {
    let shop = Shop::new();
    shop.run(&[
        "hcbtf",
        "new",
        "grass",
        "--color",
        "#204080",
        "--grid",
        "4x4,3x6,3x6",
        "--no-tiling",
    ])
    .ok();
    let import = |from: &str, more: &[&str]| {
        shop.run(&[&["hcbtf", "import", from, "-o", "back.hcbtf", "--force"], more].concat())
    };
    for (folder, more) in [("all", &[][..]), ("some", &["--painted"])] {
        shop.run(
            &[&["hcbtf", "export", "grass.hcbtf", "--to", "folder", "-o", folder], more].concat(),
        )
        .ok();
        assert!(import(folder, &[]).ok().err.contains("1 of 169 samples are painted"));
        assert_eq!(
            fs::read(shop.path("back.hcbtf")).unwrap(),
            fs::read(shop.path("grass.hcbtf")).unwrap()
        );
    }
    import("all", &["--grid", "4x4,6x10,6x10"]).fails(2, &["--grid"]);
    import("all", &["--grid", "4x4,3x6,3x6"]).ok();
    // An image that was painted over in another program counts as painted.
    fs::copy(shop.path("all/l0.0_v0.0.png"), shop.path("all/l2.5_v2.5.png")).unwrap();
    assert!(import("all", &[]).ok().err.contains("2 of 169 samples are painted"));
    shop.run(&["check", "all"]).fails(0, &["no-documents"]);
    // Without the description that Chiaro wrote beside the images, only their names tell that they
    // are of another grid.
    fs::remove_file(shop.path("all/hcbtf.json")).unwrap();
    let ran = import("all", &[]).ok();
    let told = ["warning[hcbtf-other-grid]", "--grid 4x4,3x6,3x6", "169 of 2601 samples"];
    ran.fails(0, &told);
    assert!(!import("all", &["--grid", "4x4,3x6,3x6"]).ok().err.contains("warning"));
    fs::create_dir(shop.path("numbered")).unwrap();
    for number in 1..=5 {
        fs::copy(shop.path("all/l0.0_v0.0.png"), shop.path(&format!("numbered/b{number}.png")))
            .unwrap();
    }
    import("numbered", &[]).fails(0, &["5 numbered images", "2601 samples", "--grid"]);
    assert!(!import("numbered", &["--grid", "4x4,2x4,1x1"]).ok().err.contains("warning"));
    fs::write(shop.path("numbered/hcbtf.json"), "{").unwrap();
    import("numbered", &[]).fails(1, &["hcbtf.json", "truncated"]);
}

#[test]
fn a_painting_is_told_from_a_text_wherever_a_document_is_asked_for() {
    let shop = Shop::new();
    shop.run(&["hcbtf", "new", "grass", "--color", "#204080", "--grid", "2x2,2x3,1x1"]).ok();
    fs::copy(shop.path("grass.hcbtf"), shop.path("renamed.json")).unwrap();
    let told = [
        "this is a painted surface (HCBTF)",
        "chiaro hcbtf",
        "hcbtf_lookup",
        "example:hcbtf/brick.json",
    ];
    for file in ["grass.hcbtf", "renamed.json", "example:hcbtf/brick.hcbtf"] {
        for command in [
            &["check"][..],
            &["explain"],
            &["render", "-o", "a.png"],
            &["fit", "--target", "a.png"],
        ] {
            if command[0] == "render" && cfg!(not(feature = "gpu")) {
                continue;
            }
            shop.run(&[command, &[file]].concat()).fails(1, &told);
        }
    }
    shop.run(&["export", "grass.hcbtf", "--to", "wgsl"]).fails(1, &told);
}

#[test]
fn a_mesh_without_uvs_is_told_of_where_a_look_reads_them() {
    let shop = Shop::new();
    shop.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    shop.write("mapped.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    let look = |wired: &str| {
        format!(
            r#"{{"nodes": [{{"id": "paper", "kind": "base"}}, {{"id": "squares",
                "kind": "checker"}}, {{"kind": "output"}}],
            "wires": [{{"from": "{wired}", "to": "output.color"}}]}}"#
        )
    };
    shop.write("look.json", &look("squares"));
    shop.write("plain.json", &look("paper"));
    let object = |mesh: &str, look: &str| format!(r#"{{"mesh": "{mesh}", "looks": "{look}"}}"#);
    for (mesh, look, is_told) in [
        ("bare.obj", "look.json", true),
        ("mapped.obj", "look.json", false),
        ("bare.obj", "plain.json", false),
    ] {
        shop.write("scene.json", &format!(r#"{{"objects": [{}]}}"#, object(mesh, look)));
        let drawn =
            ["render", look, "--mesh", mesh, "-o", "a.png", "--size", "8x8", "--on", "reference"];
        let commands: [&[&str]; 4] = [
            &["check", "scene.json"],
            &["explain", "scene.json"],
            &["explain", look, "--mesh", mesh],
            &drawn,
        ];
        for command in commands {
            let err = shop.run(command).ok().err;
            assert_eq!(
                err.matches("warning[no-uvs]").count(),
                usize::from(is_told),
                "{command:?}: {err}"
            );
            if is_told {
                for told in ["`bare`", "`squares`", "unwrap", "look.json:1:"] {
                    assert!(err.contains(told), "no `{told}` in {err}");
                }
            }
        }
    }
}

#[test]
fn what_takes_long_is_kept_between_starts_and_a_damaged_cache_is_no_error() {
    let shop = shop();
    let cache = shop.path("cache");
    let picture = |name: &str| {
        let look = ["render", "flat.json", "--mesh", "shape:creature", "--size", "16x16"];
        let mut command = shop.command(&[&look[..], &["-o", name, "--on", "reference"]].concat());
        Ran::of(command.env("CHIARO_CACHE_DIR", &cache).output().unwrap()).ok();
        fs::read(shop.path(name)).unwrap()
    };
    let made = picture("made.png");
    let kept: Vec<PathBuf> = fs::read_dir(&cache).unwrap().map(|e| e.unwrap().path()).collect();
    let [mesh] = kept.as_slice() else { panic!("{kept:?}") };
    let whole = fs::read(mesh).unwrap();
    assert!(picture("read.png") == made);
    assert!(fs::read(mesh).unwrap() == whole);
    fs::write(mesh, &whole[..whole.len() / 2]).unwrap();
    assert!(picture("again.png") == made);
    assert!(fs::read(mesh).unwrap() == whole, "it was made anew");
}

#[test]
fn tangents_of_a_mesh_without_uvs_are_noted() {
    let shop = Shop::new();
    shop.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let look = |model: &str| {
        format!(
            r#"{{"lights": {{"key": {{}}}}, "nodes": [{{"id": "key", "kind": "light",
                "values": {{"light": "key"}}}},
            {{"id": "shine", "kind": "reflectance", "values": {{"model": "{model}"}}}},
            {{"kind": "output"}}],
            "wires": [{{"from": "key.light", "to": "shine.light"}}, {{"from": "shine.tone",
            "to": "output.color"}}]}}"#
        )
    };
    shop.write("brushed.json", &look("ward"));
    shop.write("plain.json", &look("phong"));
    for (look, notes) in [("brushed.json", 1), ("plain.json", 0)] {
        let drawn = [
            "render",
            look,
            "--mesh",
            "bare.obj",
            "-o",
            "a.png",
            "--size",
            "8x8",
            "--on",
            "reference",
        ];
        for command in [&drawn[..], &["explain", look, "--mesh", "bare.obj"]] {
            let err = shop.run(command).ok().err;
            assert_eq!(err.matches("note[level-tangents]").count(), notes, "{command:?}: {err}");
            assert_eq!(err.contains("`shine`"), notes > 0, "{command:?}: {err}");
        }
    }
}

#[test]
fn nodes_are_asked_for_with_their_choices() {
    let shop = Shop::new();
    assert!(shop.run(&["nodes", "blend.multiply"]).ok().out.contains("(blend)"));
    shop.run(&["nodes", "blend.glow"]).fails(1, &["`blend` has no choice `glow`", "`multiply`"]);
    shop.run(&["nodes", "add.glow"]).fails(1, &["`add` has no choice `glow`"]);
    shop.run(&["nodes", "by.near"]).fails(1, &["keys", "docs/format.md"]);
}

#[test]
fn check_tells_everything_with_its_place() {
    let shop = shop();
    shop.run_without_gpu(&["check", "flat.json"]).ok();
    shop.write(
        "bad.json",
        r#"{
  "nodes": [
    {"id": "paper", "kind": "bas"},
    {"id": "rim", "kind": "profile", "values": {"ofset": 1}},
    {"id": "photo", "kind": "image", "values": {"image": "missing.png"}},
    {"id": "output", "kind": "output"}
  ],
  "wires": [{"from": "photo", "to": "output.color"}, {"from": "nobody", "to": "rim.angle"}]
}"#,
    );
    let ran = shop
        .run(&["check", "bad.json", "flat.json", "--json"])
        .fails(1, &["2 documents checked: "]);
    let problems = ran.json();
    let codes: Vec<&str> =
        problems.as_array().unwrap().iter().map(|p| p["code"].as_str().unwrap()).collect();
    for code in ["unknown-kind", "unknown-port", "unknown-node"] {
        assert!(codes.contains(&code), "{codes:?}");
    }
    let port = problems.as_array().unwrap().iter().find(|p| p["code"] == "unknown-port").unwrap();
    assert_eq!((&port["file"], &port["at"]["line"]), (&json!("bad.json"), &json!(4)));
    assert_eq!((&port["node"], &port["port"]), (&json!("rim"), &json!("ofset")));
    assert_eq!(
        (&port["json_path"], &port["severity"]),
        (&json!("nodes[1].values.ofset"), &json!("error"))
    );
    assert!(port["hints"][0].as_str().unwrap().contains("offset"));
    // Problems are printed for people on standard error, with help, and nothing on standard output.
    let ran = shop
        .run(&["check", "bad.json"])
        .fails(1, &["bad.json:4:", "help: did you mean `offset`?", "1 document"]);
    assert!(ran.out.is_empty(), "{}", ran.out);
    shop.run(&["check", "flat.json", "--nodes", "nowhere"]).fails(2, &["nowhere"]);
    shop.run(&["check"]).fails(2, &["FILE"]);
    shop.run(&["check", "none.json"]).fails(1, &["none.json"]);
}

#[test]
fn check_looks_for_what_documents_name() {
    let shop = shop();
    let image = LOOK.replace(
        r#"{"kind": "output"}"#,
        r#"{"id": "photo", "kind": "image", "values": {"image": "missing.png"}},
            {"kind": "output"}"#,
    );
    shop.write("looks/photo.json", &image);
    shop.write(
        "scene.json",
        r##"{"objects": [
          {"id": "a", "mesh": "gone.obj", "looks": "looks/photo.json"},
          {"id": "b", "mesh": "shape:sphere", "looks": "looks/none.json", "visible": false},
          {"id": "c", "mesh": "shape:spere", "looks": "flat.json", "values": {"pant": 1,
          "cover": "wide"}}
        ]}"##,
    );
    let ran = shop.run(&["check", "scene.json", "--json"]).fails(1, &["1 document checked: "]);
    let problems = ran.json();
    let all = problems.as_array().unwrap();
    let with = |code: &str, text: &str| {
        let is_it = |p: &&Json| p["code"] == code && p.to_string().contains(text);
        all.iter().find(is_it).unwrap_or_else(|| panic!("no {code} with {text} in {problems:#}"))
    };
    let photo = with("missing-asset", "missing.png");
    assert_eq!((&photo["node"], &photo["port"]), (&json!("photo"), &json!("image")));
    assert!(
        photo["file"].as_str().unwrap().ends_with("photo.json")
            && photo["at"]["line"].as_u64().unwrap() > 1
    );
    assert!(
        with("missing-asset", "none.json")["json_path"]
            .as_str()
            .unwrap()
            .starts_with("objects[1].looks")
    );
    let mesh = with("mesh-read", "gone.obj");
    assert_eq!((&mesh["file"], &mesh["at"]["line"]), (&json!("scene.json"), &json!(2)));
    assert_eq!(mesh["json_path"], "objects[0].mesh");
    assert!(mesh["hints"].to_string().contains("relative to the scene's own file"), "{mesh}");
    assert!(with("unknown-shape", "spere")["hints"][0].as_str().unwrap().contains("sphere"));
    assert_eq!(with("unknown-parameter", "pant")["severity"], "warning");
    assert_eq!(with("wrong-type", "cover")["json_path"], "objects[2].values.cover");
    // Each problem is told once, though two objects may wear one look.
    let texts: std::collections::BTreeSet<String> = all.iter().map(ToString::to_string).collect();
    assert_eq!(texts.len(), all.len());
}

#[test]
fn wrong_code_of_a_node_is_told_in_the_look() {
    let shop = Shop::new();
    let code = |code: &str| {
        shop.write(
            "own.json",
            &format!(
                "{{\"nodes\": [\n  {{\"id\": \"c\", \"kind\": \"wgsl\", \"values\": \
                 {{\"code\": \"{code}\"}}}},\n  \
                 {{\"kind\": \"output\"}}],\n \"wires\": [{{\"from\": \"c\", \"to\": \
                 \"output.color\"}}]}}"
            ),
        );
        shop.run(&["check", "own.json"])
    };
    let place = ["own.json:2:", "node `c`, port `code`, at nodes[0].values.code"];
    let ran = code(r"// Twice.\nfn tint(a: vec4f) -> vec4f { return twice * a; }");
    let ran = ran.fails(1, &[&place[..], &["line 2, column 37 of the code: ", "`twice`"]].concat());
    assert!(!ran.err.contains("c.wgsl"), "{}", ran.err);
    // Code that naga accepts, but that cannot be a node, is refused.
    code("fn tint(a: u32) -> vec4f { return vec4f(f32(a)); }").fails(1, &place);
    code("const A = 1.0;").fails(1, &place);
    code("fn tint(").fails(1, &[&place[..], &["of the code"]].concat());
}

/// Problems of a scene without which a picture or a plan would silently lack something.
#[test]
fn explain_tells_of_scenes_what_check_tells() {
    let shop = shop();
    let scene = |object: &str| {
        let text = format!("{{\"objects\": [\n  {{\"mesh\": \"shape:sphere\", {object}}}\n]}}");
        shop.write("scene.json", &text);
        let told = |command: &str| shop.run(&[command, "scene.json"]);
        [told("check"), told("explain")]
    };
    for ran in scene(r#""looks": {"*": "flat.json", "skin": "none.json"}"#) {
        ran.fails(
            1,
            &["scene.json:2:", "missing-asset", "`none.json`", "relative to the scene's own file"],
        );
    }
    for ran in scene(r#""looks": "none.json""#) {
        ran.fails(1, &["scene.json:2:", "missing-asset"]);
    }
    for ran in scene(r#""looks": "flat.json", "values": {"cover": [1, 2, 3]}"#) {
        ran.fails(1, &["scene.json:2:", "wrong-type", "`cover`", "objects[0].values.cover"]);
    }
    for ran in scene(r#""looks": "flat.json", "values": {"pant": 1}"#) {
        ran.fails(0, &["scene.json:2:", "warning[unknown-parameter]", "did you mean `paint`?"]);
    }
    for ran in scene(r#""looks": "flat.json", "values": {"cover": 0.5, "how": "add"}"#) {
        ran.ok();
    }
    for ran in scene(r#""id": "bare""#) {
        ran.fails(0, &["scene.json:2:", "warning[no-look]", "`bare` wears no look"]);
    }
    // Problems of a hidden object are told by `check` alone.
    let [check, explain] =
        scene(r#""looks": "none.json", "values": {"cover": [1, 2, 3]}, "visible": false"#);
    check.fails(1, &["missing-asset"]);
    assert!(explain.ok().err.is_empty());
}

#[test]
fn check_walks_folders_and_reads_a_projects_own_nodes() {
    let shop = Shop::new();
    shop.write("project/looks/flat.json", LOOK);
    shop.write("project/samples.json", "[{}]");
    shop.write("project/package.json", r#"{"name": "not ours"}"#);
    shop.run(&["check", "project"]).ok().fails(0, &["1 document checked: nothing is wrong"]);
    shop.write("project/cut.json", r#"{"nodes": ["#);
    shop.run(&["check", "project"]).fails(1, &["project/cut.json:1:"]);
    fs::remove_file(shop.path("project/cut.json")).unwrap();
    shop.write("project/looks/nodes/own/broken.wgsl", "fn broken(x: f32) -> f32 { return y; }\n");
    shop.run(&["check", "project"]).fails(1, &["broken.wgsl:1:"]);
    shop.write("empty/readme.txt", "");
    shop.run(&["check", "empty"]).ok().fails(0, &["no-documents"]);
}

#[test]
fn the_example_in_the_docs_is_a_node() {
    let shop = Shop::new();
    let docs =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/nodes.md")).unwrap();
    let block = |language: &str, with: &str| {
        let fence = format!("```{language}\n");
        let mut blocks = docs.split(&fence).skip(1).map(|rest| rest.split("```").next().unwrap());
        blocks
            .find(|block| block.contains(with))
            .unwrap_or_else(|| panic!("no block with {with}"))
            .to_owned()
    };
    shop.write("nodes/own/warm_tint.wgsl", &block("wgsl", "fn warm_tint_soft"));
    let listed = shop.run(&["nodes", "warm_tint", "--nodes", "nodes", "--json"]).ok().json();
    assert_eq!(
        (&listed["category"], &listed["inputs"][1]["default"]),
        (&json!("own"), &json!(0.3))
    );
    shop.write("first.json", &block("json", "\"shadow\""));
    shop.run(&["check", "first.json"]).ok();
    let tint = block("json", "fn tint");
    shop.write(
        "custom.json",
        &format!(
            r#"{{"nodes": [{tint}, {{"id": "own", "kind": "warm_tint"}}, {{"kind": "output"}}],
                "wires": [{{"from": "own", "to": "tint.color"}}, {{"from": "tint",
                "to": "output.color"}}]}}"#
        ),
    );
    shop.run(&["check", "custom.json"]).ok();
}

/// Drivers of keys are explained, with their values and weights; a driver that cannot work is
/// reported by `check` with its line.
#[test]
fn what_drives_keys_is_explained_and_checked() {
    let shop = shop();
    let look = |wire: &str| {
        let text = format!(
            r##"{{
            "nodes": [{{"kind": "time"}}, {{"id": "later", "kind": "add", "values": {{"b": 2.5}}}},
                {{"kind": "facing"}}, {{"id": "grey", "kind": "number"}}, {{"kind": "output"}}
            ],
            "wires": [{{"from": "time", "to": "later.a"}},
                {{"from": "grey", "to": "output.color"}}],
            "direction_keys": [
                {{"name": "Mood", "by": {{"drivers": [{{"wire": "{wire}"}}, "distance"]}}, "keys": [
                    {{"at": [2.5, 1], "values": {{"grey.value": 1}}}},
                    {{"at": [9, 1], "values": {{"grey.value": 0}}}}
                ]}}
            ]
            }}"##
        );
        shop.write("driven.json", &text);
    };
    look("later");
    shop.run(&["check", "driven.json"]).ok();
    let text = shop.run_without_gpu(&["explain", "driven.json"]).ok().out;
    for part in [
        "Mood on `object`: the wire `later` is 2.5000, the distance to the eye is 4.4000",
        "weights 100.0% 0.0%",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
    let told = shop.run(&["explain", "driven.json", "--json"]).ok().json();
    let look_told = &told["looks"][0];
    assert_eq!(look_told["keys"][0]["by"][0]["now"][0], 2.5);
    let on_host = look_told["nodes"]["host"].as_array().unwrap();
    assert!(
        ["later", "time"].iter().all(|node| on_host.iter().any(|told| told == node)),
        "{on_host:?}"
    );
    for (wire, code) in [
        ("nobody", "unknown-node"),
        ("later.y", "unknown-port"),
        ("facing", "fragment-driver"),
        ("grey", "key-cycle"),
    ] {
        look(wire);
        shop.run(&["check", "driven.json"]).fails(1, &["driven.json:8:", code]);
    }
}

#[test]
fn explain_tells_passes_and_reasons_without_a_gpu() {
    let shop = shop();
    let text = shop.run_without_gpu(&["explain", "flat.json"]).ok().out;
    for part in [
        "Passes",
        "it is the picture",
        "Left out",
        "curvature",
        "Vertex attributes",
        "not read: tangent, uv",
        "Nodes:",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
    let told = shop.run(&["explain", "flat.json", "--json"]).ok().json();
    assert_eq!(told["passes"].as_array().unwrap().len(), 1);
    let look = &told["looks"][0];
    let removed: Vec<&str> = look["nodes"]["removed"]
        .as_array()
        .unwrap()
        .iter()
        .map(|r| r["path"].as_str().unwrap())
        .collect();
    assert!(removed.contains(&"layer/warp"), "{removed:?}");
    let counted = |list: &str| look["nodes"][list].as_array().unwrap().len();
    let total = counted("fragment") + counted("host") + counted("folded") + counted("removed");
    assert_eq!(look["nodes"]["total"], total);
    assert_eq!(look["uniforms"][0]["rate"], "object");
    let is_told = |kind: &str, state: &str, proof: &str| {
        let mut effects = told["effects"].as_array().unwrap().iter();
        effects.any(|e| {
            e["kind"] == kind && e["state"] == state && (proof.is_empty() || e["proof"] == proof)
        })
    };
    for (kind, state, proof) in [
        ("pass", "runs", ""),
        ("pass", "dropped", "unreachable"),
        ("object", "runs", ""),
        ("attribute", "dropped", "unreachable"),
        ("node", "runs", ""),
        ("node", "dropped", "zero-weight"),
    ] {
        assert!(is_told(kind, state, proof), "no {kind} is {state} {proof}: {}", told["effects"]);
    }
    // A look that bends with curvature needs the passes, and the plan names their reader.
    let bent =
        LOOK.replace(r#""blend": "alpha""#, r#""blend": "alpha", "slope": 0.2, "amount": 0.3"#);
    shop.write("bent.json", &bent);
    let told = shop.run(&["explain", "bent.json", "--json"]).ok().json();
    let kinds: Vec<&str> =
        told["passes"].as_array().unwrap().iter().map(|p| p["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["normals", "curvature", "look"]);
    assert!(told["passes"][1]["reason"].as_str().unwrap().contains("\"Flat\""));
    assert_eq!(told["looks"][0]["modules"].as_array().unwrap().len(), 2);
    let wgsl = shop.run(&["explain", "flat.json", "--wgsl"]).ok().out;
    assert!(wgsl.contains("fn fs_main"), "{wgsl}");
    shop.run(&["explain", "missing.json"]).fails(1, &["missing.json"]);
    shop.run(&["explain", "flat.json", "--mesh", "shape:cuboid"]).fails(1, &["unknown-shape"]);
}

/// Tiers that nobody named are told wherever a look leaves, and can be asked for.
#[test]
fn chosen_tiers_are_told_and_can_be_asked_for() {
    let shop = shop();
    let text = shop.run_without_gpu(&["explain", "flat.json"]).ok().out;
    assert!(text.contains("at most 1/255, a step of a screen, which nobody can see"), "{text}");
    let told = shop.run(&["explain", "flat.json", "--json"]).ok().json();
    let tiers = told["looks"][0]["tiers"].as_array().unwrap();
    let tone = tiers.iter().find(|node| node["node"] == "layer/tone").expect("it runs");
    assert_eq!((&tone["tier"], &tone["reason"]), (&"balanced".into(), &"unseen".into()));
    let costs = |tier: &str| tone["operations"][tier].as_u64().unwrap();
    assert!(costs("exact") > costs("balanced"), "{tone}");
    let exact = shop.run(&["explain", "flat.json", "--tier", "exact", "--json"]).ok().json();
    let named = exact["looks"][0]["tiers"].as_array().unwrap();
    assert!(named.iter().all(|node| node["tier"] == "exact" && node["reason"] == "named"));
    let wgsl = |tier: &[&str]| {
        shop.run(&[&["export", "flat.json", "--to", "wgsl"], tier].concat()).ok().out
    };
    let chosen = wgsl(&[]);
    assert_eq!(chosen, wgsl(&["--tier", "automatic"]));
    assert!(wgsl(&["--tier", "exact"]).lines().count() > chosen.lines().count());
    assert_eq!(chosen, wgsl(&["--tier", "auto"]));
    shop.run(&["export", "flat.json", "--to", "wgsl", "--tier", "best"]).fails(2, &["automatic"]);
    let said = shop.run(&["export", "flat.json", "--to", "wgsl", "-o", "out"]).ok().err;
    assert!(said.contains("which nobody can see; nodes: "), "{said}");
    let text = fs::read_to_string(shop.path("out/flat.json")).unwrap();
    let described: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(described["tiers"]["balanced"].as_u64().unwrap() > 0, "{}", described["tiers"]);
    assert_eq!(described["tiers"]["max_error"], 1.0 / 255.0);
    let exported = ["export", "flat.json", "--to", "wgsl", "-o", "out", "--json"];
    assert_eq!(shop.run(&exported).ok().json()["tiers"], described["tiers"]);
    let rendered = ["render", "flat.json", "-o", "a.png", "--size", "16x16", "--json"];
    let rendered = shop.run(&rendered).ok().json();
    assert_eq!(rendered["looks"][0]["tiers"], described["tiers"]);
    let exact = ["export", "flat.json", "--to", "wgsl", "--tier", "exact", "-o", "exact"];
    assert!(!shop.run(&exact).ok().err.contains("automatic"), "every tier is named");
}

#[test]
fn nodes_lists_and_documents_the_library() {
    let shop = Shop::new();
    let table = shop.run_without_gpu(&["nodes"]).ok().out;
    assert!(
        table.contains("light_layer")
            && table.contains("wgsl")
            && table.contains("angle, offset, falloff"),
        "{table}"
    );
    let listed = shop.run(&["nodes", "--json"]).ok().json();
    let files = support::files::below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("nodes"));
    let wgsl = files.iter().filter(|path| path.extension().is_some_and(|e| e == "wgsl"));
    for path in wgsl {
        let kind = path.file_stem().unwrap().to_str().unwrap();
        assert!(
            listed.as_array().unwrap().iter().any(|entry| entry["kind"] == kind),
            "{kind} is not listed"
        );
    }
    let layer = shop.run(&["nodes", "light_layer", "--json"]).ok().json();
    let blend =
        layer["inputs"].as_array().unwrap().iter().find(|input| input["name"] == "blend").unwrap();
    assert_eq!((&blend["type"], &blend["default"]), (&json!("choice"), &json!("add")));
    let text = shop.run(&["nodes", "profile"]).ok().out;
    assert!(text.contains("Half-Lambert") && text.contains("BADF eq. 5"), "{text}");
    assert_eq!(
        shop.run(&["nodes", "Light Layer", "--json"]).ok().json(),
        layer,
        "by what the window calls it"
    );
    assert_eq!(
        shop.run(&["nodes", "light_layer.diffuse", "--json"]).ok().json(),
        layer,
        "with a choice"
    );
    shop.run(&["nodes", "profil"]).fails(1, &["did you mean `profile`"]);
    shop.run(&["nodes", "--markdown", "profile"]).fails(2, &["cannot be used with"]);
}

#[test]
fn docs_nodes_md_is_what_the_code_says() {
    let printed = Shop::new().run(&["nodes", "--markdown"]).ok().out;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/nodes.md");
    if std::env::var("CHIARO_BLESS").is_ok_and(|value| value == "1") {
        fs::write(&path, &printed).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        kept == printed,
        "docs/nodes.md is not what the code says; CHIARO_BLESS=1 cargo test --test program writes \
         it anew"
    );
}

/// Every picture that docs/nodes.md shows exists, and has a text for readers who cannot see it; and
/// no picture is left over.
#[test]
fn docs_nodes_md_shows_pictures_that_are_there() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let text = fs::read_to_string(docs.join("nodes.md")).unwrap();
    let mut shown = BTreeSet::new();
    for picture in text.split("<img src=\"").skip(1) {
        let (name, rest) = picture.split_once('"').unwrap();
        assert!(
            docs.join(name).is_file(),
            "{name} is not there: chiaro nodes --pictures docs/nodes draws it"
        );
        assert!(
            rest.starts_with(" alt=\"") && !rest.starts_with(" alt=\"\""),
            "{name} has no words"
        );
        assert!(
            shown.insert(name.trim_start_matches("nodes/").to_owned()),
            "{name} is there twice"
        );
    }
    let files = fs::read_dir(docs.join("nodes")).unwrap().flatten();
    let kept: BTreeSet<String> =
        files.map(|file| file.file_name().to_string_lossy().into_owned()).collect();
    assert_eq!(kept, shown);
}

#[test]
fn new_writes_sound_documents_and_replaces_nothing() {
    let shop = Shop::new();
    for (name, template) in [("rim", "layers"), ("flat", "minimal"), ("stage", "scene")] {
        let ran = shop.run_without_gpu(&["new", name, "--template", template]).ok();
        assert!(
            ran.out.contains(&format!("{name}.json")) && ran.err.contains("chiaro render"),
            "{}{}",
            ran.out,
            ran.err
        );
    }
    assert_eq!(shop.names(), ["flat.json", "rim.json", "stage-look.json", "stage.json"]);
    shop.run(&["check", "."]).ok().fails(0, &["4 documents checked: nothing is wrong"]);
    shop.write("rim.json", "mine");
    shop.run(&["new", "rim"]).fails(1, &["rim.json", "--force"]);
    assert_eq!(fs::read_to_string(shop.path("rim.json")).unwrap(), "mine");
    shop.run(&["new", "rim", "--force"]).ok();
    shop.run(&["check", "rim.json"]).ok();
    let ran = shop.run(&["new", "no such/folder/rim"]);
    let ran = ran.fails(
        1,
        &[
            "no such/folder/rim.json: ",
            "cannot-write",
            "no folder `no such/folder`",
            "make the folder",
        ],
    );
    assert!(!ran.err.contains(".tmp"), "{}", ran.err);
    shop.run(&["new", "rim", "--template", "oil"]).fails(2, &["oil"]);
}

#[test]
fn export_writes_files_and_lists_them() {
    let shop = shop();
    let ran = shop.run_without_gpu(&["export", "flat.json", "--to", "all", "-o", "out"]).ok();
    assert!(ran.err.contains("unverified"), "{}", ran.err);
    let listed: Vec<&str> = ran.out.lines().collect();
    assert!(listed.len() > 8 && listed.iter().all(|file| shop.path(file).is_file()), "{listed:?}");
    assert_eq!(fs::read_dir(shop.path("out")).unwrap().count(), listed.len());
    let described: Json =
        serde_json::from_slice(&fs::read(shop.path("out/flat.json")).unwrap()).unwrap();
    assert_eq!(described["parameters"][0]["name"], "paint");
    let told = shop
        .run(&["export", "flat.json", "--to", "wgsl,msl,wgsl", "-o", "out", "--json"])
        .ok()
        .json();
    assert_eq!(told["languages"], json!(["wgsl", "msl"]));
    assert!(told["unverified"][0].as_str().unwrap().contains("Metal"), "{told}");
    let wgsl = shop.run(&["export", "flat.json", "--to", "wgsl"]).ok().out;
    assert!(wgsl.contains("@fragment"), "{wgsl}");
    shop.run(&["export", "flat.json", "--to", "hlsl"]).fails(2, &["-o"]);
    shop.run(&["export", "flat.json", "--to", "glsl"]).fails(2, &["did you mean", "glsl-330"]);
    shop.run(&["export", "flat.json", "-o", "out"]).fails(2, &["--to"]);
    for file in ["flat.json", "new.wgsl", "new.FRAG"] {
        shop.run(&["export", "flat.json", "--to", "wgsl", "-o", file])
            .fails(2, &["-o names a folder", file, "shaders/"]);
        assert!(!shop.path(file).is_dir());
    }
    // The description has the look's own name: here it would replace the look.
    shop.run(&["export", "flat.json", "--to", "wgsl", "-o", "."]).fails(1, &["would-overwrite"]);
    assert_eq!(fs::read_to_string(shop.path("flat.json")).unwrap(), LOOK);
    shop.write("scene.json", r#"{"objects": [{"looks": "flat.json"}]}"#);
    shop.run(&["export", "scene.json", "--to", "wgsl"])
        .fails(1, &["this is a scene", "in its place: flat.json"]);
    // Paths are told as seen from here, not from the scene.
    std::fs::create_dir(shop.path("scenes")).unwrap();
    shop.write(
        "scenes/far.json",
        r#"{"objects": [{"looks": "../flat.json"}, {"looks": "near.json"}]}"#,
    );
    let near = Path::new("scenes").join("near.json");
    let named = format!("in its place: flat.json, {}", near.display());
    shop.run(&["export", "scenes/far.json", "--to", "wgsl"]).fails(1, &["this is a scene", &named]);
}

#[cfg(feature = "gpu")]
mod gpu {
    use std::io::Write as _;
    use std::process::Stdio;

    use super::*;

    #[test]
    fn render_writes_a_picture_and_tells_about_it() {
        let shop = shop();
        let arguments = [
            "render",
            "flat.json",
            "-o",
            "a.png",
            "--mesh",
            "shape:sphere",
            "--size",
            "48x32",
            "--json",
        ];
        let told = shop.run(&arguments).ok().json();
        assert_eq!(png_size(&shop.path("a.png")), [48, 32]);
        assert_eq!(
            (&told["width"], &told["passes"], &told["warnings"]),
            (&json!(48), &json!(["look"]), &json!([]))
        );
        assert!(
            told["seconds"].is_number() && told["adapter"].is_string() && told["file"] == "a.png"
        );
        let small = ["--mesh", "shape:sphere", "--size", "32x32", "--samples", "1"];
        let shoot = |name: &str, camera: &[&str]| {
            shop.run(&[&["render", "flat.json", "-o", name], &small[..], camera].concat()).ok();
            fs::read(shop.path(name)).unwrap()
        };
        // One position of the eye can be given in two ways; from above, `up` is needed, too.
        let orbit = shoot("b.png", &["--camera", "distance=4;orbit=90,0"]);
        let eye = shoot("c.png", &["--camera", "target=0,0,0;eye=4,0,0;up=0,1,0"]);
        assert_eq!(orbit, eye);
        assert_ne!(
            orbit,
            shoot(
                "d.png",
                &["--camera", "orbit=0,90;fov=60", "--backdrop", "none", "--turn-lights", "-30,10"]
            )
        );
        // One digit a channel says as much as two.
        let before = |color| shoot("e.png", &["--on", "reference", "--backdrop", color]);
        assert_eq!(before("#28a"), before("#2288aa"));
    }

    #[test]
    fn render_says_what_is_wrong_before_it_works() {
        let shop = shop();
        shop.run(&["render", "flat.json", "-o", "none/a.png"])
            .fails(1, &["cannot-write", "none", "-o"]);
        shop.run(&["render", "flat.json", "-o", "a.jpg"]).fails(1, &["PNG", "-o a.png"]);
        shop.run(&["render", "flat.json", "-o", "a.png", "--camera", "eye=1,2"])
            .fails(2, &["--camera", "eye=1,2", "target="]);
        shop.run(&["render", "flat.json", "-o", "a.png", "--camera", "eye=0,0,0"])
            .fails(2, &["--camera"]);
        shop.run(&["render", "flat.json", "-o", "a.png", "--backdrop", "mauve"])
            .fails(2, &["--backdrop"]);
        shop.run(&["render", "flat.json", "-o", "a.png", "--size", "0x4"]).fails(2, &["800x600"]);
        shop.run(&["render", "flat.json", "-o", "a.png", "--samples", "3"]).fails(2, &["1 or 4"]);
        shop.run(&["render", "flat.json", "-o", "a.png", "--time", "inf"]).fails(2, &["seconds"]);
        shop.run(&["render", "flat.json", "-o", "a.png", "--mesh", "gone.obj"])
            .fails(1, &["gone.obj"]);
        shop.write("bad.json", &LOOK.replace("light_layer", "lihgt_layer"));
        shop.run(&["render", "bad.json", "-o", "a.png"]).fails(1, &["bad.json:6:", "light_layer"]);
        assert_eq!(shop.names(), ["bad.json", "flat.json"]);
    }

    #[test]
    fn render_tells_of_scenes_what_check_tells() {
        let shop = shop();
        let render = |object: &str| {
            shop.write("scene.json", &format!("{{\"objects\": [\n  {{\"mesh\": {object}}}\n]}}"));
            shop.run(&["render", "scene.json", "-o", "a.png", "--size", "8x8", "--samples", "1"])
        };
        render(r#""gone.obj", "looks": "flat.json""#)
            .fails(1, &["scene.json:2:", "gone.obj", "help: paths of meshes"]);
        render(r#""shape:sphere", "looks": {"*": "flat.json", "skin": "none.json"}"#)
            .fails(1, &["scene.json:2:", "missing-asset"]);
        render(r#""shape:sphere", "looks": "flat.json", "values": {"cover": "wide"}"#)
            .fails(1, &["scene.json:2:", "wrong-type"]);
        assert_eq!(shop.names(), ["flat.json", "scene.json"]);
        render(r#""shape:sphere", "looks": "flat.json", "values": {"pant": 1}"#)
            .fails(0, &["unknown-parameter"]);
        let help = shop.run(&["render", "--help"]).ok().out;
        assert!(help.contains("Samples a pixel: 1, or 4"), "{help}");
    }

    fn eval(shop: &Shop, more: &[&str], samples: &str) -> Ran {
        let arguments = [&["eval", "flat.json", "--at", "-"], more].concat();
        let mut child = shop
            .command(&arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // The program may end without reading its input if its arguments are wrong, so the write
        // may fail.
        let _ = child.stdin.take().unwrap().write_all(samples.as_bytes());
        Ran::of(child.wait_with_output().unwrap())
    }

    #[test]
    fn eval_answers_in_order() {
        let shop = shop();
        // The layer covers up to 1 radian (57.3 degrees) from the light, and not beyond; the edge
        // is hard.
        let samples = r#"[{"normal": [0, 0, 7]}, {"normal": [0, 1, 0]}, {"normal": [0, 0.8, 0.6]},
                          {"normal": [0, 1, 0], "lights": {"key": {"direction": [0, 3, 0]}}},
                          {"normal": [0, 1, 0], "frame": [[1, 0, 0], [0, 0, 1], [0, -1, 0]]}]"#;
        let red = json!({"value": [1.0, 0.0, 0.0, 1.0]});
        let paper = json!({"value": [0.25, 0.5, 0.75, 1.0]});
        let want = json!([red, paper, red, red, red]);
        assert_eq!(eval(&shop, &[], samples).ok().json(), want);
        assert_eq!(eval(&shop, &["--unspecialized", "--tier", "fast"], samples).ok().json(), want);
        // Outputs may be those of a node, of a node in a group, and of the group.
        let tones = json!([{"value": [1.0]}, {"value": [0.0]}]);
        for output in ["layer.tone", "layer/tone", "layer/tone.tone"] {
            let two = r#"[{"normal": [0, 0, 1]}, {"normal": [0, 0, -1]}]"#;
            assert_eq!(eval(&shop, &["--output", output], two).ok().json(), tones, "{output}");
        }
        let angle =
            eval(&shop, &["--output", "layer/angle"], r#"[{"normal": [0, 1, 0]}]"#).ok().json();
        let u = angle[0]["value"][0].as_f64().unwrap();
        assert!((u - std::f64::consts::FRAC_PI_2).abs() < 1e-6, "{u}");
        assert_eq!(eval(&shop, &[], "[]").ok().out.trim(), "[]");
        let wild = r#"[{"kappa": "inf"}, {"kappa": "nan"}, {"kappa": "-inf"}]"#;
        assert_eq!(eval(&shop, &[], wild).ok().json(), json!([red, red, red]));
    }

    #[test]
    fn eval_sets_exposed_parameters() {
        let shop = shop();
        let samples = r##"[{"values": {"paint": "#00ff00"}}, {"values": {"paint": [0, 0, 1]}}, {},
                          {"values": {"cover": 0.5}}, {"values": {"how": "add"}}]"##;
        let values: Vec<Json> = eval(&shop, &[], samples).ok().json().as_array().unwrap().clone();
        let third = |i: usize| values[i]["value"].clone();
        // Convex and concave meet half-way where the surface is flat.
        assert_eq!(third(0), json!([0.5, 0.5, 0.0, 1.0]));
        assert_eq!(third(1), json!([0.5, 0.0, 0.5, 1.0]));
        assert_eq!(third(2), json!([1.0, 0.0, 0.0, 1.0]));
        assert_eq!(third(3), json!([0.625, 0.25, 0.375, 1.0]));
        assert_eq!(third(4), json!([1.0, 0.5, 0.75, 1.0]));
    }

    #[test]
    fn eval_tells_what_is_wrong_with_samples() {
        let shop = shop();
        let bad = r#"[{"nromal": [0, 0, 1]}, {"lights": {"kye": {"direction": [0, 0, 1]}}}]"#;
        let ran = eval(&shop, &[], bad)
            .fails(1, &["standard input", "[0].nromal", "did you mean `normal`?"]);
        assert!(ran.out.is_empty());
        let ran = eval(
            &shop,
            &[],
            r#"[{}, {"lights": {"kye": {"intensity": 1}}}, {"values": {"pint": 1}}]"#,
        );
        ran.fails(1, &["[1].lights.kye", "its lights are key", "[2].values.pint", "`paint`"]);
        eval(&shop, &[], r#"[{"values": {"cover": "wide"}}]"#)
            .fails(1, &["[0].values.cover", "a number"]);
        eval(&shop, &[], r#"[{}, {"values": {"how": "ad"}}]"#)
            .fails(1, &["unknown-choice", "sample [1]"]);
        eval(&shop, &[], "{}").fails(1, &["a list of samples"]);
        eval(&shop, &[], "[").fails(1, &["1:"]);
        eval(&shop, &["--output", "layr.tone"], "[]")
            .fails(1, &["unknown-node", "did you mean `layer`?"]);
        eval(&shop, &["--output", "layer.ton"], "[{}]").fails(1, &["layer"]);
        // If no name is near, the hint lists all names.
        eval(&shop, &["--output", "nope.x"], "[]")
            .fails(1, &["the outputs are `paper.below`, ", "`output.color`"]);
        let ran = eval(&shop, &["--output", "paper.x"], "[]")
            .fails(1, &["the outputs are `paper.below`\n"]);
        assert!(!ran.err.contains("layer"), "{}", ran.err);
        eval(&shop, &["--output", "layer/angle.x"], "[]").fails(1, &["`layer/angle.angle`"]);
        eval(&shop, &["--tier", "best"], "[]").fails(2, &["exact, balanced or fast"]);
        shop.run(&["eval", "flat.json", "--at", "none.json"]).fails(1, &["none.json"]);
    }

    #[cfg(unix)]
    #[test]
    fn an_interrupted_render_leaves_no_half_written_file() {
        let shop = shop();
        for round in 0..3 {
            let name = format!("big{round}.png");
            let arguments =
                ["render", "flat.json", "-o", &name, "--size", "3000x3000", "--samples", "1"];
            let mut child = shop.command(&arguments).stderr(Stdio::null()).spawn().unwrap();
            // Ends range from just after the start to the middle of writing, if that can be met.
            let is_writing = || shop.names().iter().any(|name| name.ends_with(".tmp"));
            while round > 0 && !is_writing() && child.try_wait().unwrap().is_none() {
                std::thread::yield_now();
            }
            let id = child.id().to_string();
            assert!(
                Command::new("kill").args(["-INT", &id]).stderr(Stdio::null()).status().is_ok()
            );
            let status = child.wait().unwrap();
            assert!(!shop.names().iter().any(|name| name.ends_with(".tmp")), "{:?}", shop.names());
            // A signal that came too late leaves the finished file.
            let path = shop.path(&name);
            match status.code() {
                Some(0) => assert_eq!(png_size(&path), [3000, 3000]),
                code => assert!(code == Some(130) || code.is_none(), "{status}"),
            }
            if path.exists() {
                assert_eq!(png_size(&path), [3000, 3000]);
            }
        }
    }

    #[cfg(unix)]
    #[test]
    fn ctrl_c_ends_with_130() {
        let shop = shop();
        let mut child = shop
            .command(&["eval", "flat.json", "--at", "-"])
            .stdin(Stdio::piped())
            .spawn()
            .unwrap();
        // The input is more than a pipe holds: once it is written the program is reading, and waits
        // for an end that never comes. Standard input stays open until the program has ended:
        // waiting for the child would close it.
        let mut stdin = child.stdin.take().unwrap();
        stdin.write_all(&[b' '; 1 << 20]).unwrap();
        assert!(
            Command::new("kill")
                .args(["-INT", &child.id().to_string()])
                .status()
                .unwrap()
                .success()
        );
        let code = child.wait().unwrap().code();
        assert_eq!(code, Some(130));
        drop(stdin);
    }
}

/// Starts an export that watches its look; the lines that it says, until a minute is over.
fn watching(shop: &Shop) -> (std::process::Child, impl Iterator<Item = String> + use<>) {
    use std::io::BufRead as _;
    let program = env!("CARGO_BIN_EXE_chiaro");
    let arguments = ["export", "look.json", "--to", "wgsl", "-o", "out", "--watch"];
    let mut child = Command::new("timeout")
        .arg("60")
        .arg(program)
        .args(arguments)
        .current_dir(shop.0.path())
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let lines = std::io::BufReader::new(child.stderr.take().unwrap()).lines();
    (child, lines.map_while(Result::ok))
}

#[test]
fn an_export_that_watches_follows_the_look() {
    let shop = Shop::new();
    let example = support::root().join("examples/looks/clay.json");
    let text = fs::read_to_string(example).unwrap();
    shop.write("look.json", &text);
    let (mut child, mut lines) = watching(&shop);
    let mut exported = || {
        let said: Vec<String> = lines.by_ref().take_while(|l| !l.contains("watching ")).collect();
        (said.join("\n"), fs::read_to_string(shop.path("out/look.wgsl")).unwrap_or_default())
    };
    let (_, first) = exported();
    assert!(first.contains("fn shade("), "{first}");
    // A look that is broken for a moment is told, and what was written stays.
    shop.write("look.json", "{");
    let (said, kept) = exported();
    assert!(said.contains("error") && kept == first, "{said}");
    let name: Json = serde_json::from_str::<Json>(&text).unwrap()["name"].clone();
    let other = text.replace(&name.to_string(), "\"Another name\"");
    assert_ne!(other, text);
    shop.write("look.json", &other);
    let (said, second) = exported();
    assert!(second.contains("Another name"), "{said}\n{second}");
    // `timeout` hands a polite end on to the program, and no other.
    Command::new("kill").arg(child.id().to_string()).status().unwrap();
    child.wait().unwrap();
}
