//! Shader compilers and validators that are none of ours, for a second opinion on what we emit.
//!
//! They come from `scripts/setup`. Where one is missing its check says so on standard error and passes, so that
//! `cargo test` works anywhere; with `CHIARO_REQUIRE_TOOLS=1`, which `scripts/test` sets, it fails.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::{env, fmt};

/// A program that `scripts/setup` installs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tool {
    /// GLSL: `glslangValidator` of Debian's glslang-tools.
    Glslang,
    /// SPIR-V: `spirv-val` of Debian's spirv-tools.
    SpirvVal,
    /// WGSL: Tint, in Dawn for Node, driven by `tests/tint/validate.mjs`.
    Tint,
}

impl Tool {
    /// Whether it can be started here.
    pub(crate) fn is_here(self) -> bool {
        let starts = |program: &str, argument: &str| {
            let quiet = Command::new(program).arg(argument).stdout(Stdio::null()).stderr(Stdio::null()).status();
            quiet.is_ok_and(|status| status.success())
        };
        match self {
            Self::Glslang => starts("glslangValidator", "--version"),
            Self::SpirvVal => starts("spirv-val", "--version"),
            Self::Tint => {
                tint_folder().join("node_modules/webgpu/package.json").is_file() && starts("node", "--version")
            }
        }
    }

    /// What a check does without its tool: pass, aloud, unless the tools are required.
    fn missing(self) -> Result<(), String> {
        if tools_are_required() {
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
        })
    }
}

/// Whether a missing tool is a failure.
pub(crate) fn tools_are_required() -> bool {
    env::var("CHIARO_REQUIRE_TOOLS").is_ok_and(|value| value == "1")
}

#[expect(clippy::print_stderr, reason = "a skipped check is to be seen in the test's output")]
fn say(line: &str) {
    eprintln!("{line}");
}

/// The stage that a GLSL source is for; GLSL does not say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stage {
    Vertex,
    Fragment,
    Compute,
}

/// Has glslang compile `source`. `flags` are its own, e.g. `["-V"]` for the rules of Vulkan; without them the source's
/// `#version` decides. Gives what glslang says, with the source's lines numbered, where it refuses.
pub(crate) fn glslang(source: &str, stage: Stage, flags: &[&str]) -> Result<(), String> {
    if !Tool::Glslang.is_here() {
        return Tool::Glslang.missing();
    }
    let stage = match stage {
        Stage::Vertex => "vert",
        Stage::Fragment => "frag",
        Stage::Compute => "comp",
    };
    // It writes SPIR-V beside itself when asked to make some, hence a folder of its own.
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut command = Command::new("glslangValidator");
    command.args(["--stdin", "-S", stage]).args(flags).current_dir(folder.path());
    let output = feed(&mut command, source.as_bytes())?;
    if output.status.success() { Ok(()) } else { Err(format!("{}\n{}", said(&output), numbered(source))) }
}

/// What glslang finds in the program that `files` of `folder` make together: names, offsets and types of its uniforms,
/// a line each. `None` without glslang; panics where it cannot link them.
pub(crate) fn glslang_reflection(folder: &Path, files: &[String]) -> Option<String> {
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

/// Has spirv-val check a SPIR-V module, little-endian words as written to a `.spv` file, by the rules of `environment`,
/// e.g. `vulkan1.1`.
pub(crate) fn spirv_val(module: &[u8], environment: &str) -> Result<(), String> {
    if !Tool::SpirvVal.is_here() {
        return Tool::SpirvVal.missing();
    }
    let mut command = Command::new("spirv-val");
    command.args(["--target-env", environment, "-"]);
    let output = feed(&mut command, module)?;
    if output.status.success() { Ok(()) } else { Err(said(&output)) }
}

/// Has Tint compile WGSL files, all in one start of it. Gives `path:line:column: severity: message` for each message of
/// each file that it refuses.
pub(crate) fn tint<P: AsRef<Path>>(files: &[P]) -> Result<(), String> {
    if !Tool::Tint.is_here() {
        return Tool::Tint.missing();
    }
    let list: Vec<_> = files.iter().map(|file| file.as_ref().display().to_string()).collect();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/tint/validate.mjs");
    let mut command = Command::new("node");
    command.arg(script).env("CHIARO_TINT", tint_folder());
    let output = feed(&mut command, (list.join("\n") + "\n").as_bytes())?;
    let answer: serde_json::Value =
        serde_json::from_slice(&output.stdout).map_err(|error| format!("Tint: {error}\n{}", said(&output)))?;
    let reports = answer.as_array().ok_or("Tint: the answer is no list")?;
    let answered = reports.iter().map(|report| report["file"].as_str().unwrap_or_default());
    if !answered.eq(list.iter().map(String::as_str)) {
        return Err(format!("Tint: the answer is not about the files asked for\n{}", said(&output)));
    }
    let refusals: Vec<_> = reports.iter().filter(|report| report["ok"] != true).map(refusal).collect();
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
        format!("{file}:{}:{}: {}: {}", message["line"], message["column"], text("severity"), text("message"))
    };
    messages.map(line).collect::<Vec<_>>().join("\n")
}

/// Where `scripts/setup` puts Tint, or where `CHIARO_TINT` says it is.
fn tint_folder() -> PathBuf {
    env::var_os("CHIARO_TINT").map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join(".tools/tint"), PathBuf::from)
}

/// Runs a program with `input` on its standard input.
fn feed(command: &mut Command, input: &[u8]) -> Result<Output, String> {
    let program = command.get_program().to_string_lossy().into_owned();
    // From a file, not a pipe: the program may answer at length before it has read everything.
    let mut file = tempfile::tempfile().map_err(|error| error.to_string())?;
    file.write_all(input).and_then(|()| std::io::Seek::rewind(&mut file)).map_err(|error| error.to_string())?;
    command.stdin(file).output().map_err(|error| format!("{program}: {error}"))
}

/// Everything that a program printed.
fn said(output: &Output) -> String {
    let text = [&output.stdout[..], &output.stderr[..]].map(String::from_utf8_lossy).concat();
    format!("{} ({})", text.trim(), output.status)
}

fn numbered(source: &str) -> String {
    source.lines().enumerate().map(|(index, line)| format!("{:4} {line}\n", index + 1)).collect()
}
