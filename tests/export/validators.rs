//! Exported shaders pass compilers of other projects; and those compilers, as the project drives
//! them, refuse wrong shaders. A check that cannot fail would prove nothing.

use std::fs;
use std::path::{Path, PathBuf};

use crate::support::files;
use crate::support::ledger::{Ledger, ProofKey};
use crate::support::validators::{
    ShaderStage, Tool, glslang, glslang_hlsl, hlsl, slang, slang_hlsl, spirv_val, tint,
    tools_are_required,
};
use chiaro::document::Look;
use chiaro::export::{LANGUAGES, export};
use chiaro::frame::Assets;
use chiaro::library::Library;

/// True if a test that needs `tool` to refuse a shader can run; fails where the tools are required
/// and `tool` is missing.
fn can_refuse(tool: Tool) -> bool {
    let here = tool.is_here();
    assert!(here || !tools_are_required(), "{tool} is missing: run scripts/setup");
    here
}

/// Writes `source` to a file of its own and has Tint compile the file.
fn tint_source(source: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("shader.wgsl");
    fs::write(&file, source).expect("a temporary file");
    tint(&[file])
}

#[test]
fn tint_takes_what_is_right() {
    tint_source(
        "@fragment fn main(@location(0) x: f32) -> @location(0) vec4f {
            let slope = dpdx(x);
            return select(vec4f(0.0), vec4f(slope), x > 0.5);
        }",
    )
    .expect("a right shader");
}

#[test]
fn tint_refuses_a_wrong_type_and_says_where() {
    if can_refuse(Tool::Tint) {
        let error = tint_source("fn a() -> f32 {\n    return 1u;\n}").expect_err("a wrong type");
        assert!(error.contains("shader.wgsl:2:5: error:"), "{error}");
    }
}

/// A reason for using Tint: naga takes this shader, browsers do not.
#[test]
fn tint_refuses_a_derivative_in_non_uniform_control_flow() {
    let source = "@fragment fn main(@location(0) x: f32) -> @location(0) vec4f {
        var slope = 0.0;
        if x > 0.5 {
            slope = dpdx(x);
        }
        return vec4f(slope);
    }";
    if can_refuse(Tool::Tint) {
        let error = tint_source(source).expect_err("the derivative depends on a varying");
        assert!(
            error.contains(":4:21: error: 'dpdx' must only be called from uniform control flow"),
            "{error}"
        );
    }
}

#[test]
fn tint_reports_every_file_it_refuses() {
    if can_refuse(Tool::Tint) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let files = ["one.wgsl", "two.wgsl", "three.wgsl"].map(|name| folder.path().join(name));
        fs::write(&files[0], "fn a() { b(); }").expect("a temporary file");
        fs::write(&files[1], "fn a() {}").expect("a temporary file");
        let error = tint(&files).expect_err("one is wrong and one does not exist");
        assert!(error.contains("one.wgsl:1:10") && error.contains("three.wgsl"), "{error}");
        assert!(!error.contains("two.wgsl"), "{error}");
    }
}

/// glslang takes a right shader of every exported version, and refuses a wrong one that breaks that
/// version's rules.
#[test]
fn glslang_knows_every_version_that_we_write() {
    let versions = [
        // ES 300 has neither double precision nor buffers; a float needs a precision.
        ("#version 300 es\nprecision highp float;", "double d = 1.0;"),
        ("#version 330 core", "const int n = 1.5;"),
        ("#version 450 core", "const int n = 1.5;"),
    ];
    for (version, wrong) in versions {
        let shader = |line: &str| {
            format!("{version}\nout vec4 color;\nvoid main() {{\n{line}\ncolor = vec4(1.0);\n}}\n")
        };
        glslang(&shader(""), ShaderStage::Fragment, &[]).expect(version);
        if can_refuse(Tool::Glslang) {
            let error = glslang(&shader(wrong), ShaderStage::Fragment, &[]).expect_err(version);
            assert!(error.contains("ERROR: "), "{error}");
            assert!(error.contains(wrong), "the source is shown: {error}");
        }
    }
}

/// Both compilers of HLSL take a right shader, with constants as exports write them, and refuse
/// wrong ones; slangc also constants that a function makes.
#[test]
fn compilers_of_hlsl_know_right_from_wrong() {
    let shader = |pair: &str, body: &str| {
        format!(
            "struct Pair {{ float a; float2 b; }};\n\
             Pair ConstructPair(float a, float2 b) {{ Pair ret = (Pair)0; ret.a = a; ret.b = b; \
             return ret; }}\n\
             static const Pair PAIR = {pair};\n\
             float4 vs_main(float3 at : LOC0) : SV_Position {{ return float4(at, 1.0); }}\n\
             float4 fs_main() : SV_Target0 {{\n    \
             float2 sums[2] = {{ (float2)0, (float2)0 }};\n    {body}\n}}\n"
        )
    };
    let list = "{(1.0 + 0.5), float2(2.0, 3.0)}";
    let sum = "sums[1] += PAIR.b; return float4(PAIR.a, sums[1], 1.0);";
    hlsl(&shader(list, sum)).expect("a right shader");
    let wrong = [
        "return PAIR;",
        "return float4(PAIR.c, 0.0, 0.0, 1.0);",
        "return missing(sums);",
        "return float4(1.0",
    ];
    if can_refuse(Tool::Glslang) {
        for body in wrong {
            glslang_hlsl(&shader(list, body)).expect_err(body);
        }
    }
    if Tool::Slang.is_here() {
        for body in wrong {
            slang_hlsl(&shader(list, body)).expect_err(body);
        }
        let made = shader("ConstructPair(1.0, float2(2.0, 3.0))", sum);
        let refused = slang_hlsl(&made).expect_err("a constant that a function makes");
        assert!(refused.contains("compile-time constant"), "{refused}");
    }
}

#[test]
fn glslang_knows_the_stages_and_its_flags() {
    let vertex =
        "#version 450\nlayout(location = 0) in vec4 at;\nvoid main() { gl_Position = at; }\n";
    glslang(vertex, ShaderStage::Vertex, &["-V"]).expect("a vertex shader");
    glslang(
        "#version 450\nlayout(local_size_x = 1) in;\nvoid main() {}\n",
        ShaderStage::Compute,
        &[],
    )
    .expect("a compute shader");
    if can_refuse(Tool::Glslang) {
        glslang(vertex, ShaderStage::Fragment, &["-V"]).expect_err("gl_Position is no fragment's");
        let without_location =
            "#version 450\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";
        glslang(without_location, ShaderStage::Fragment, &["-V"])
            .expect_err("Vulkan asks for locations");
    }
}

/// One SPIR-V instruction.
fn op(code: u32, operands: &[u32]) -> Vec<u32> {
    [&[((operands.len() as u32 + 1) << 16) | code], operands].concat()
}

/// The smallest compute shader in SPIR-V 1.0, with `body` between the label and the end of its one
/// function.
fn spirv(body: &[u32]) -> Vec<u8> {
    let (void, function_type, main, label, bound) = (2, 3, 4, 5, 6);
    let words = [
        &[0x0723_0203, 0x0001_0000, 0, bound, 0][..],
        &op(17, &[1]),                                        // OpCapability Shader
        &op(14, &[0, 1]),                                     // OpMemoryModel Logical GLSL450
        &op(15, &[5, main, u32::from_le_bytes(*b"main"), 0]), // OpEntryPoint GLCompute
        &op(16, &[main, 17, 1, 1, 1]),                        // OpExecutionMode LocalSize
        &op(19, &[void]),                                     // OpTypeVoid
        &op(33, &[function_type, void]),                      // OpTypeFunction
        &op(54, &[void, main, 0, function_type]),             // OpFunction None
        &op(248, &[label]),                                   // OpLabel
        body,
        &op(56, &[]), // OpFunctionEnd
    ]
    .concat();
    words.into_iter().flat_map(u32::to_le_bytes).collect()
}

#[test]
fn spirv_val_takes_what_is_right_and_refuses_what_is_not() {
    let (op_return, op_return_value) = (op(253, &[]), op(254, &[5]));
    spirv_val(&spirv(&op_return), "vulkan1.1").expect("a right module");
    if can_refuse(Tool::SpirvVal) {
        spirv_val(&spirv(&[]), "vulkan1.1").expect_err("a block without an end");
        spirv_val(&spirv(&op_return_value), "vulkan1.1").expect_err("a value from a void function");
        spirv_val(b"not a module", "vulkan1.1").expect_err("no module at all");
    }
}

/// The sweep of exported files: outside compilers judge, as the project drives them.
const SWEEP: &[&str] = &["tests/export/validators.rs", "tests/support/validators.rs", "tests/tint"];

/// The version of slangc, as `scripts/setup` fetches it.
const SLANG: &str = include_str!("../slang/requirements.txt");

/// Has every exported file judged that is due by the ledger, and closes the ledger. A file's
/// extension says who judges the file; an unknown extension is a mistake. Files lie under `root`.
fn judge(mut ledger: Ledger, root: &Path, files: &[PathBuf]) {
    let versions = ProofKey::of_judges(SWEEP).with(versions().as_bytes());
    let mut wgsl = Vec::new();
    for path in files {
        let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy().into_owned();
        let extension = path.extension().unwrap_or_default().to_string_lossy().into_owned();
        let bytes = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let text = String::from_utf8_lossy(&bytes);
        let key =
            if extension == "spv" { versions.with(&bytes) } else { versions.with_source(&text) };
        if !ledger.is_due(&name, &key) {
            continue;
        }
        let verdict = match extension.as_str() {
            "wgsl" => {
                wgsl.push((name, key, path));
                continue;
            }
            "vert" => glslang(&text, ShaderStage::Vertex, &[]),
            "frag" => glslang(&text, ShaderStage::Fragment, &[]),
            "comp" => glslang(&text, ShaderStage::Compute, &[]),
            "spv" => spirv_val(&bytes, "vulkan1.1"),
            "hlsl" => hlsl(&text),
            "slang" => slang(&text),
            // No tool on Debian judges Metal, and those files say so; the others are no shaders.
            "metal" | "json" | "txt" | "md" | "png" => continue,
            _ => Err(format!("nobody judges .{extension} files; see tests/export/validators.rs")),
        };
        ledger.note(&name, &key, verdict.map(|()| 0.0));
    }
    let paths: Vec<&PathBuf> = wgsl.iter().map(|(_, _, path)| *path).collect();
    let refused =
        if paths.is_empty() { String::new() } else { tint(&paths).err().unwrap_or_default() };
    let is_of = |line: &&str, path: &Path| line.starts_with(&*path.to_string_lossy());
    for (name, key, path) in &wgsl {
        let said: Vec<&str> = refused.lines().filter(|line| is_of(line, path)).collect();
        ledger.note(name, key, if said.is_empty() { Ok(0.0) } else { Err(said.join("\n")) });
    }
    let elsewhere = refused.lines().find(|line| !paths.iter().any(|path| is_of(line, path)));
    assert!(elsewhere.is_none(), "{refused}");
    ledger.close();
}

/// Versions of the validators on this machine.
fn versions() -> String {
    let said = |program: &str| {
        let output = std::process::Command::new(program).arg("--version").output();
        output
            .map(|output| String::from_utf8_lossy(&output.stdout).into_owned())
            .unwrap_or_default()
    };
    said("glslangValidator") + &said("spirv-val") + SLANG
}

/// Committed outputs of `tests/golden/` pass, found by a walk so that none is forgotten.
#[test]
fn golden_outputs_pass_their_validators() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let golden = files::below(&root.join("tests/golden"));
    let looks = files::below(&root.join("examples/looks"));
    assert!(
        looks.is_empty() || !golden.is_empty(),
        "there are example looks and no golden outputs of them"
    );
    judge(Ledger::open("golden"), root, &golden);
}

/// Looks that read images and HCBTFs are exported to every language and pass, although they have no
/// golden outputs. Their textures are checked in `tests/export/golden.rs`.
#[test]
fn looks_with_textures_pass_their_validators() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let looks = ["images", "hcbtf"].map(|folder| files::below(&examples.join(folder))).concat();
    let out = tempfile::tempdir().unwrap();
    let mut written = Vec::new();
    for path in
        looks.iter().filter(|path| path.extension().is_some_and(|extension| extension == "json"))
    {
        let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
        let look = Look::load(&chiaro::files::Disk, path).value.unwrap();
        let exported = export(
            &look,
            Library::built_in(),
            &stem,
            &LANGUAGES,
            (Path::new(""), &mut Assets::default()),
        );
        for file in exported.unwrap_or_else(|problems| panic!("{stem}: {problems:?}")).value {
            let path = out.path().join(&stem).join(&file.name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(&path, &file.bytes).unwrap();
            written.push(path);
        }
    }
    assert!(written.len() > 15 * LANGUAGES.len(), "only {} files are written", written.len());
    judge(Ledger::open("textures"), out.path(), &written);
}
