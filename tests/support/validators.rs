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
        }
    }

    /// Result of a check without its tool: passes and prints a line, unless the tools are required.
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

/// True if a missing tool is a failure.
pub fn tools_are_required() -> bool {
    env::var("CHIARO_REQUIRE_TOOLS").is_ok_and(|value| value == "1")
}

#[expect(clippy::print_stderr, reason = "a skipped check is to be seen in the test's output")]
fn say(line: &str) {
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

/// Has glslang's front end for HLSL read the two entry points of `source`, rewritten where that
/// front end is wrong about HLSL ([`for_glslang`]): a second opinion on every expression, type and
/// declaration, but not that of a Direct3D compiler.
pub fn glslang_hlsl(source: &str) -> Result<(), String> {
    let source = for_glslang(source);
    let vulkan = [
        "--target-env",
        "vulkan1.1",
        "--auto-map-bindings",
        "--auto-map-locations",
        "-o",
        "out.spv",
    ];
    for (stage, entry) in [(ShaderStage::Vertex, "vs_main"), (ShaderStage::Fragment, "fs_main")] {
        glslang(&source, stage, &[&["-D", "-e", entry], &vulkan[..]].concat())?;
    }
    Ok(())
}

/// HLSL rewritten for glslang, which takes a constant of the module that is made by a function for
/// a recursion, and knows no zero that is cast to an array. Both become lists in braces, of the
/// same values.
pub fn for_glslang(source: &str) -> String {
    let line = |line: &str| -> String {
        if line.starts_with("static const ") && line.contains(" = Construct") {
            return constructed_in_braces(line);
        }
        // `float4 colors[16] = (float4[16])0;`
        let zero = line.split_once(" = (").filter(|(_, value)| value.ends_with("])0;"));
        let parts = zero.and_then(|(variable, _)| {
            let (ty, name) = variable.trim_start().split_once(' ')?;
            let count: usize = name.split_once('[')?.1.strip_suffix(']')?.parse().ok()?;
            Some((variable, ty, count))
        });
        match parts {
            Some((variable, ty, count)) => {
                format!("{variable} = {{ {} }};", vec![format!("({ty})0"); count].join(", "))
            }
            None => line.to_owned(),
        }
    };
    source.lines().map(|one| line(one) + "\n").collect()
}

/// A line of HLSL with `ConstructX(a, b)` as `{a, b}`, at any depth.
fn constructed_in_braces(line: &str) -> String {
    let mut text = String::new();
    let mut closing = Vec::new();
    let mut rest = line;
    while let Some(next) = rest.chars().next() {
        let name = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        if rest.starts_with("Construct") && rest[name..].starts_with('(') {
            text.push('{');
            closing.push('}');
            rest = &rest[name + 1..];
            continue;
        }
        match next {
            '(' => closing.push(')'),
            ')' => {
                text.extend(closing.pop());
                rest = &rest[1..];
                continue;
            }
            _ => {}
        }
        let word = if name == 0 { next.len_utf8() } else { name };
        text.push_str(&rest[..word]);
        rest = &rest[word..];
    }
    text
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
