//! Outputs of commands: never written over inputs or over files of others, as a whole or not at
//! all, with an error if they could not be written.

use std::any::TypeId;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use chiaro::cli::OutputPath;

/// A folder for one test, with a file of every kind to read.
struct Shop(tempfile::TempDir);

impl Shop {
    fn new() -> Self {
        let shop = Self(tempfile::tempdir().unwrap());
        let image = image::RgbaImage::from_pixel(32, 32, image::Rgba([90, 120, 40, 255]));
        image.save(shop.path("target.png")).unwrap();
        fs::write(shop.path("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        fs::create_dir(shop.path("nodes")).unwrap();
        let node = "/// Twice\n///\n/// Twice a number.\n///\n/// @param x \"X\" : A number.\n\
                    /// @return y \"Y\" : Twice that.\nfn own(x: f32) -> f32 { return 2.0 * x; }\n";
        fs::write(shop.path("nodes/own.wgsl"), node).unwrap();
        let graph = r#"<materialx version="1.39"><constant name="gray" type="float"/>
            <output name="out" type="float" nodename="gray"/></materialx>"#;
        fs::write(shop.path("graph.mtlx"), graph).unwrap();
        assert!(shop.run(&["new", "look", "--template", "minimal"]).status.success());
        assert!(
            shop.run(&["hcbtf", "new", "grass", "--color", "#305020", "--grid", "4x4,2x3,2x3"])
                .status
                .success()
        );
        fs::create_dir(shop.path("looks")).unwrap();
        fs::copy(shop.path("look.json"), shop.path("looks/other.json")).unwrap();
        shop
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        // No GPU is available, as a refusal comes before anything is drawn.
        command.envs([
            ("WGPU_BACKEND", "noop"),
            ("VK_DRIVER_FILES", "/none"),
            ("VK_ICD_FILENAMES", "/none"),
            ("CHIARO_CACHE_DIR", ""),
        ]);
        command.args(arguments).current_dir(self.0.path());
        command
    }

    fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// All files below the folder, with their content.
    fn files(&self) -> Vec<(PathBuf, Vec<u8>)> {
        let (mut files, mut open) = (Vec::new(), vec![self.0.path().to_path_buf()]);
        while let Some(folder) = open.pop() {
            for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
                match path.is_dir() {
                    true => open.push(path),
                    false => files.push((path.clone(), fs::read(path).unwrap())),
                }
            }
        }
        files.sort();
        files
    }
}

fn told(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A command with one of its outputs.
struct Case {
    /// Words of the subcommand, and the argument that names the output.
    output: (&'static str, &'static str),
    /// Whole command line; `{}` stands for the output.
    line: &'static str,
    /// Files that the command reads.
    inputs: &'static [&'static str],
    /// End of the output's name; for a folder, files in it that are certainly written.
    names: Names,
}

enum Names {
    File(&'static str),
    Folder(&'static [&'static str]),
}

use Names::{File, Folder};

/// One case for each output of each command. A look that is tuned or fitted is changed by these
/// commands, so it is no input in this sense: without `-o` it is the output.
const CASES: &[Case] = &[
    Case { output: ("new", "name"), line: "new {}", inputs: &[], names: File(".json") },
    Case {
        output: ("import", "output"),
        line: "import graph.mtlx -o {}",
        inputs: &["graph.mtlx"],
        names: File(".json"),
    },
    Case {
        output: ("render", "output"),
        line: "render look.json -o {} --mesh mesh.obj --nodes nodes",
        inputs: &["look.json", "mesh.obj", "nodes/own.wgsl"],
        names: File(".png"),
    },
    Case {
        output: ("wedge", "output"),
        line: "wedge look.json --vary lit.offset=0,1 -o {} --mesh mesh.obj --nodes nodes",
        inputs: &["look.json", "mesh.obj", "nodes/own.wgsl"],
        names: File(".png"),
    },
    Case {
        output: ("sheet", "output"),
        line: "sheet target.png -o {}",
        inputs: &["target.png"],
        names: File(".png"),
    },
    Case {
        output: ("movie", "output"),
        line: "movie target.png -o {}",
        inputs: &["target.png"],
        names: File(".png"),
    },
    Case {
        output: ("comp", "output"),
        line: "comp target.png --to nuke -o {}",
        inputs: &["target.png"],
        names: File(".nk"),
    },
    Case {
        output: ("farm", "job"),
        line: "farm look.json -o ####.exr --frames 1-4 --to slurm --job {}",
        inputs: &["look.json"],
        names: File(""),
    },
    Case {
        output: ("bench", "plot"),
        line: "bench look.json --plot {} --mesh mesh.obj --nodes nodes",
        inputs: &["look.json", "mesh.obj", "nodes/own.wgsl"],
        names: File(""),
    },
    Case {
        output: ("tune", "output"),
        line: "tune look.json --max-error 1/255 -o {} --mesh mesh.obj --nodes nodes",
        inputs: &["mesh.obj", "nodes/own.wgsl"],
        names: File(""),
    },
    Case {
        output: ("fit", "output"),
        line: "fit look.json --target target.png -o {} --mesh mesh.obj --nodes nodes",
        inputs: &["target.png", "mesh.obj", "nodes/own.wgsl"],
        names: File(""),
    },
    Case {
        output: ("fit", "misses"),
        line: "fit look.json --target target.png --misses {} --mesh mesh.obj --nodes nodes",
        inputs: &["look.json", "target.png", "mesh.obj", "nodes/own.wgsl"],
        names: File(".png"),
    },
    Case {
        output: ("accuracy", "output"),
        line: "accuracy --quick --looks looks -o {}",
        inputs: &["looks/other.json"],
        names: File(""),
    },
    Case {
        output: ("accuracy", "worst"),
        line: "accuracy --quick --looks looks --worst {}",
        inputs: &["looks/other.json"],
        names: Folder(&["profile.json"]),
    },
    Case {
        output: ("gallery", "output"),
        line: "gallery look.json -o {} --mesh mesh.obj --nodes nodes",
        inputs: &["look.json", "mesh.obj", "nodes/own.wgsl"],
        names: Folder(&["look.png", "look.html", "look-graph.svg"]),
    },
    Case {
        output: ("nodes", "pictures"),
        line: "nodes --nodes nodes --pictures {}",
        inputs: &["nodes/own.wgsl"],
        names: Folder(&["own.svg", "own.png", "add.svg"]),
    },
    Case {
        output: ("export", "output"),
        line: "export look.json --to all -o {} --nodes nodes",
        inputs: &["look.json", "nodes/own.wgsl"],
        names: Folder(&["look.wgsl", "look.json", "look.spv"]),
    },
    Case {
        output: ("hcbtf new", "name"),
        line: "hcbtf new {}",
        inputs: &[],
        names: File(".hcbtf"),
    },
    Case {
        output: ("hcbtf import", "output"),
        line: "hcbtf import target.png -o {}",
        inputs: &["target.png"],
        names: File(".hcbtf"),
    },
    Case {
        output: ("hcbtf export", "output"),
        line: "hcbtf export grass.hcbtf -o {}",
        inputs: &["grass.hcbtf"],
        names: File(".png"),
    },
    Case {
        output: ("hcbtf synthesize", "output"),
        line: "hcbtf synthesize grass.hcbtf -o {}",
        inputs: &["grass.hcbtf"],
        names: File(".hcbtf"),
    },
    Case {
        output: ("hcbtf bake", "output"),
        line: "hcbtf bake look.json -o {} --nodes nodes",
        inputs: &["look.json", "nodes/own.wgsl"],
        names: File(".hcbtf"),
    },
];

impl Case {
    fn run(&self, shop: &Shop, output: &str, is_forced: bool) -> Output {
        let words = self.line.split(' ').map(|word| if word == "{}" { output } else { word });
        shop.run(&words.chain(is_forced.then_some("--force")).collect::<Vec<_>>())
    }

    /// Asserts that the command refuses, and changes nothing.
    #[track_caller]
    fn refuses(&self, shop: &Shop, output: &str, is_forced: bool, code: &str) {
        let before = shop.files();
        let ran = self.run(shop, output, is_forced);
        let told = told(&ran);
        assert_eq!(ran.status.code(), Some(1), "{}, {output}: {told}", self.line);
        assert!(told.contains(code), "{}, {output}: no `{code}` in {told}", self.line);
        assert!(shop.files() == before, "{}, {output}: something changed", self.line);
    }
}

/// Subcommand and argument of every file or folder that the command line writes.
fn outputs_of(command: &clap::Command, path: &str, found: &mut BTreeSet<(String, String)>) {
    for argument in command.get_arguments() {
        if argument.get_value_parser().type_id() == TypeId::of::<OutputPath>() {
            found.insert((path.to_owned(), argument.get_id().to_string()));
        }
    }
    for inner in command.get_subcommands() {
        outputs_of(inner, format!("{path} {}", inner.get_name()).trim(), found);
    }
}

#[test]
fn every_output_of_every_command_is_tried() {
    let mut found = BTreeSet::new();
    outputs_of(&chiaro::cli::command(), "", &mut found);
    let named = cases().map(|case| (case.output.0.to_owned(), case.output.1.to_owned()));
    assert_eq!(found, named.collect());
}

fn cases() -> impl Iterator<Item = &'static Case> {
    let needs_gpu = ["bench", "tune", "accuracy", "gallery", "nodes"];
    CASES.iter().filter(move |case| cfg!(feature = "gpu") || !needs_gpu.contains(&case.output.0))
}

#[test]
#[cfg(unix)]
fn no_command_writes_over_what_it_reads_by_any_name() {
    let shop = Shop::new();
    fs::create_dir(shop.path("out")).unwrap();
    for case in cases() {
        for input in case.inputs {
            let links: Vec<String> = match case.names {
                File(ending) => vec![format!("link{ending}")],
                Folder(names) => names.iter().map(|name| format!("out/{name}")).collect(),
            };
            for link in links {
                std::os::unix::fs::symlink(shop.path(input), shop.path(&link)).unwrap();
                let output = if matches!(case.names, Folder(_)) { "out" } else { link.as_str() };
                for is_forced in [false, true] {
                    case.refuses(&shop, output, is_forced, "would-overwrite");
                }
                fs::remove_file(shop.path(&link)).unwrap();
            }
            let File(ending) = case.names else { continue };
            if input.ends_with(ending) {
                case.refuses(&shop, input, true, "would-overwrite");
                case.refuses(&shop, &format!("nodes/../{input}"), true, "would-overwrite");
            }
        }
    }
}

#[test]
fn no_command_writes_over_what_somebody_made() {
    let shop = Shop::new();
    for case in cases() {
        for made in ["look.json", "nodes/own.wgsl", "grass.hcbtf", "target.png"] {
            match case.names {
                File(ending) => {
                    let name = format!("mine{ending}");
                    fs::copy(shop.path(made), shop.path(&name)).unwrap();
                    case.refuses(&shop, &name, false, "file-exists");
                    fs::remove_file(shop.path(&name)).unwrap();
                }
                Folder(names) => {
                    for name in names {
                        fs::create_dir(shop.path("folder")).unwrap();
                        fs::copy(shop.path(made), shop.path("folder").join(name)).unwrap();
                        case.refuses(&shop, "folder", false, "file-exists");
                        fs::remove_dir_all(shop.path("folder")).unwrap();
                    }
                }
            }
        }
    }
}

#[test]
fn what_chiaro_made_is_replaced_unasked_until_somebody_changes_it() {
    let shop = Shop::new();
    let render = [
        "render",
        "look.json",
        "-o",
        "a.png",
        "--size",
        "16x16",
        "--samples",
        "1",
        "--on",
        "reference",
    ];
    for _ in 0..2 {
        assert!(shop.run(&render).status.success());
        let ran = shop.run(&["export", "look.json", "--to", "all", "-o", "out"]);
        assert!(ran.status.success(), "{}", told(&ran));
    }
    let picture = image::open(shop.path("a.png")).unwrap().to_rgba8();
    let mut painted = picture.clone();
    painted.put_pixel(3, 4, image::Rgba([255, 0, 0, 255]));
    painted.save(shop.path("a.png")).unwrap();
    let before = shop.files();
    let ran = shop.run(&render);
    assert!(ran.status.code() == Some(1) && told(&ran).contains("--force"), "{}", told(&ran));
    assert!(shop.files() == before);
    assert!(shop.run(&[&render[..], &["--force"]].concat()).status.success());
    assert_eq!(image::open(shop.path("a.png")).unwrap().to_rgba8(), picture);

    fs::write(shop.path("out/look.wgsl"), "fn mine() {}\n").unwrap();
    let before = shop.files();
    let export = ["export", "look.json", "--to", "wgsl", "-o", "out"];
    // The description lists a file of this name, but its content is the user's.
    fs::remove_file(shop.path("out/look.json")).unwrap();
    let ran = shop.run(&export);
    assert!(ran.status.code() == Some(1) && told(&ran).contains("look.wgsl"), "{}", told(&ran));
    assert_eq!(fs::read_to_string(shop.path("out/look.wgsl")).unwrap(), "fn mine() {}\n");
    assert_eq!(shop.files().len(), before.len() - 1);
    assert!(shop.run(&[&export[..], &["--force"]].concat()).status.success());
}

/// An image that a scene's look shows is no argument of the command, and is not written over
/// either.
#[test]
fn what_documents_name_is_read_too() {
    let shop = Shop::new();
    let look = r#"{"chiaro": "look", "version": 1, "nodes": [
        {"id": "image", "kind": "image", "values": {"image": "shown.png"}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "image.color", "to": "output.color"}]}"#;
    fs::write(shop.path("shown.json"), look).unwrap();
    let render = |document, to| {
        let size =
            ["--size", "8x8", "--samples", "1", "--on", "reference", "--mesh", "shape:plane"];
        shop.run(&[&["render", document, "-o", to], &size[..]].concat())
    };
    // The image was rendered by Chiaro, so it would be replaced without `--force` if it were no
    // input.
    assert!(render("look.json", "shown.png").status.success());
    let before = shop.files();
    let ran = render("shown.json", "shown.png");
    assert!(
        ran.status.code() == Some(1) && told(&ran).contains("would-overwrite"),
        "{}",
        told(&ran)
    );
    assert!(shop.files() == before);
}

/// Every command that prints a result, run with standard output on a full disk.
#[test]
#[cfg(target_os = "linux")]
fn a_result_that_could_not_be_printed_is_an_error() {
    let shop = Shop::new();
    let mut lines: Vec<Vec<String>> = Vec::new();
    let mut helps = vec![(chiaro::cli::command(), Vec::new())];
    while let Some((command, path)) = helps.pop() {
        lines.push([&path[..], &["--help".to_owned()]].concat());
        for inner in command.get_subcommands() {
            helps.push((inner.clone(), [&path[..], &[inner.get_name().to_owned()]].concat()));
        }
    }
    for line in [
        "--version",
        "new printed",
        "check look.json --json",
        "explain look.json",
        "explain look.json --wgsl",
        "nodes",
        "nodes --markdown",
        "probe look.json --at 8,8 --size 16x16",
        "render look.json -o printed.png --size 8x8 --on reference --json",
        "export look.json --to wgsl",
        "export look.json --to wgsl -o printed",
        "hcbtf new printed",
        "hcbtf info grass.hcbtf",
        "hcbtf rules grass.hcbtf",
        "hcbtf export grass.hcbtf -o sheet.png",
    ] {
        lines.push(line.split(' ').map(str::to_owned).collect());
    }
    assert!(lines.len() > 25, "every subcommand has help: {lines:?}");
    for line in lines {
        let words: Vec<&str> = line.iter().map(String::as_str).collect();
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let ran = shop.command(&words).stdout(full).output().unwrap();
        assert_eq!(ran.status.code(), Some(1), "{words:?}: {}", told(&ran));
        assert!(told(&ran).contains("cannot-print"), "{words:?}: {}", told(&ran));
    }
    // Messages are the most that can be done: if they cannot be printed either, the exit code is
    // enough.
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let ran = shop.command(&["nodes"]).stdout(full()).stderr(full()).status().unwrap();
    assert_eq!(ran.code(), Some(1));
    assert_eq!(
        shop.command(&["nodes"]).stdout(Stdio::null()).stderr(full()).status().unwrap().code(),
        Some(0)
    );
}

/// A reader that goes away, as in `chiaro nodes --markdown | head -1`.
#[test]
#[cfg(unix)]
fn a_reader_that_goes_away_is_no_error() {
    let shop = Shop::new();
    for line in
        [&["nodes", "--markdown"][..], &["export", "look.json", "--to", "wgsl"], &["--help"]]
    {
        let mut child =
            shop.command(line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let ran = child.wait_with_output().unwrap();
        assert!(
            ran.status.success() && !told(&ran).contains("cannot-print"),
            "{line:?}: {}",
            told(&ran)
        );
    }
}

/// Numbers of finished and of temporary files in a folder.
#[cfg(unix)]
fn there(folder: &Path) -> (usize, usize) {
    let names = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.file_name());
    let (half, whole): (Vec<_>, Vec<_>) =
        names.partition(|name| name.to_string_lossy().starts_with(".chiaro-"));
    (whole.len(), half.len())
}

/// Ends an export of many images at many instants, by force and politely. Afterwards none of the
/// images exists or all do, and the next export removes the leftovers.
#[test]
#[cfg(unix)]
fn an_export_that_is_ended_leaves_nothing_or_all() {
    let shop = Shop::new();
    let grid = "2x2,4x6,4x6";
    assert!(
        shop.run(&["hcbtf", "new", "many", "--color", "#305020", "--grid", grid]).status.success()
    );
    let export = ["hcbtf", "export", "many.hcbtf", "--to", "folder", "-o", "images", "--force"];
    assert!(shop.run(&export).status.success());
    let images = shop.path("images");
    let (all, _) = there(&images);
    assert!(all > 300, "{all}");
    for (index, begun) in [1, 2, 40, 200].into_iter().enumerate() {
        for signal in ["-KILL", "-INT"] {
            fs::remove_dir_all(&images).unwrap();
            let mut child =
                shop.command(&export).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
            // The signal is sent once `begun` files exist, or all are done.
            while there(&images).1 < begun && child.try_wait().unwrap().is_none() {
                std::thread::yield_now();
            }
            let sent = Command::new("kill")
                .args([signal, &child.id().to_string()])
                .stderr(Stdio::null())
                .status();
            assert!(sent.is_ok());
            let code = child.wait().unwrap().code();
            let (whole, half) = there(&images);
            let is_told = images.join("hcbtf.json").exists();
            match signal {
                // A killed program cannot finish its work; but the description of the other files
                // is written last.
                "-KILL" => assert!(
                    is_told == (whole == all) && (half > 0 || is_told),
                    "{whole} of {all}, {half}"
                ),
                _ => {
                    assert!(whole == 0 || whole == all, "after {begun}: {whole} of {all} images");
                    assert!(
                        half == 0 && (code == Some(130) || whole == all),
                        "{half} left, {code:?}"
                    );
                }
            }
            if index == 0 || signal == "-KILL" {
                let ran = shop.run(&export);
                assert!(ran.status.success(), "{}", told(&ran));
                assert_eq!(there(&images), (all, 0));
            }
            fs::create_dir_all(&images).unwrap();
        }
    }
}
