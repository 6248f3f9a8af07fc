//! The package `unreal`, as far as it goes without Unreal: the material's text is read, its Custom
//! node is compiled by two compilers of HLSL with a stand-in for what a material's code has, and
//! the picture is drawn on Unreal's axes.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use image::RgbaImage;

use crate::pictures::{Difference, Trial, examples, keep, soak_trials};
use crate::support::validators::Tool;
use crate::table;
use crate::unity::drawing::{drawn_shader, in_one_tier};
use crate::unity::glslang;
use crate::unity::textures::{Texture, Textures};

/// Text around the code of a Custom node, and the world on Unreal's axes: centimeters, x of
/// the look, then its z, then its y. The scene is that of the tests of Unity, whose x is mirrored.
const STAND_IN: &str = r#"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
CBUFFER_START(UnityPerMaterial)
    float nothing;
CBUFFER_END
struct ViewState
{
    float3 ViewRight;
    float3 ViewUp;
    float3 ViewForward;
    float4x4 ViewToClip;
    float4 ViewRectMin;
    float4 ViewSizeAndInvSize;
};
static ViewState ResolvedView;
struct FMaterialPixelParameters { float4 SvPosition; float3x3 TangentToWorld; };
float3 turned(float3 v) { return float3(-v.x, v.z, v.y); }
struct Mesh
{
    float3 position : POSITION;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float2 uv : TEXCOORD0;
    float4 color : COLOR;
};
struct PassedPixel
{
    float4 clip : SV_Position;
    float3 world : TEXCOORD0;
    float3 normal : TEXCOORD1;
    float3 tangent : TEXCOORD2;
    float3 bitangent : TEXCOORD3;
    float2 uv : TEXCOORD4;
    float4 color : TEXCOORD5;
    float3 local : TEXCOORD6;
};
PassedPixel vertex_of(Mesh mesh)
{
    PassedPixel passed;
    float3 world = TransformObjectToWorld(mesh.position);
    passed.clip = mul(UNITY_MATRIX_VP, float4(world, 1.0));
    passed.world = 100.0 * turned(world);
    float3 normal = TransformObjectToWorldNormal(mesh.normal);
    float3 tangent = mul((float3x3)UNITY_MATRIX_M, mesh.tangent.xyz);
    passed.normal = turned(normal);
    passed.tangent = turned(normalize(tangent));
    // v runs down in Unreal.
    passed.bitangent = turned(normalize(-cross(normal, tangent) * mesh.tangent.w));
    passed.uv = float2(mesh.uv.x, 1.0 - mesh.uv.y);
    passed.color = mesh.color;
    passed.local = 100.0 * turned(mesh.position);
    return passed;
}
"#;

/// A material's graph, read from the text for the clipboard.
struct Material {
    /// Code of the Custom node.
    code: String,
    /// Inputs of the Custom node: name, type and value in HLSL.
    inputs: Vec<(String, &'static str, String)>,
    /// File that the Custom node includes.
    file: String,
    /// Textures of the parameters.
    textures: Textures,
    /// True if the text of one screen asks for a material of two sides.
    is_two_sided: bool,
    /// True if it asks for one that is cut away where its opacity is low.
    is_masked: bool,
}

impl Material {
    fn of(folder: &Path) -> Self {
        let files = fs::read_dir(folder).expect("a package");
        let mut files = files.filter_map(|entry| Some(entry.ok()?.path()));
        let is_it = |path: &std::path::PathBuf| path.to_string_lossy().ends_with(".material.txt");
        let text = fs::read_to_string(files.find(is_it).expect("a material")).expect("a text");
        check_pins(&text);
        let property = |name: &str| {
            let mut lines = text.lines().filter_map(|line| line.trim().strip_prefix(name));
            lines.next().unwrap_or_else(|| panic!("{name} in {text}")).to_owned()
        };
        let code = property("Code=").trim_matches('"').replace("\\r\\n", "\n");
        let file = property("IncludeFilePaths(0)=").trim_matches('"').to_owned();
        let inputs = text.lines().filter(|line| line.trim().starts_with("Inputs("));
        let inputs = inputs.map(|line| input(&text, line)).collect();
        let file = file.rsplit('/').next().unwrap_or_default().to_owned();
        let readme = fs::read_to_string(folder.join("README.md")).expect("a text");
        let is_two_sided = readme.contains("| *Two Sided* | on");
        let is_masked = readme.contains("| *Masked*");
        let textures = textures(folder, &text);
        Self { code, inputs, file, textures, is_two_sided, is_masked }
    }

    /// Our own picture of a trial, and that of the material in the trial's package.
    fn drawn(&self, trial: &Trial, folder: &Path) -> (RgbaImage, Vec<u8>) {
        drawn_shader(trial, folder, self.shader(), &self.textures, self.is_two_sided)
    }

    /// A text of ShaderLab with one pass, which draws the material.
    fn shader(&self) -> String {
        // The clip value that materials have from the start.
        let mask = if self.is_masked { "if (Opacity < 0.3333) discard;\n" } else { "" };
        let mut heads = String::new();
        let mut values = String::new();
        let mut declared = String::new();
        for (name, ty, value) in &self.inputs {
            if ty.starts_with("Texture") {
                let _infallible = write!(
                    declared,
                    "{ty}<float4> {name}Bound;\nSamplerState {name}BoundSampler;\n"
                );
                let _infallible = write!(heads, "{ty} {name}, SamplerState {name}Sampler, ");
                let _infallible = write!(values, "{name}Bound, {name}BoundSampler, ");
                continue;
            }
            let _infallible = write!(heads, "{ty} {name}, ");
            let _infallible = write!(values, "{value}, ");
        }
        format!(
            "HLSLINCLUDE\n{STAND_IN}#include \"{}\"\n{declared}\
             float3 CustomExpression0(FMaterialPixelParameters Parameters, {heads}inout float \
             Opacity)\n{{\n{}\n}}\n\
             float4 fragment_of(PassedPixel passed, bool is_front : SV_IsFrontFace) : \
             SV_Target\n{{\n\
             ResolvedView.ViewRight = turned(UNITY_MATRIX_V[0].xyz);\n\
             ResolvedView.ViewUp = turned(UNITY_MATRIX_V[1].xyz);\n\
             ResolvedView.ViewForward = -turned(UNITY_MATRIX_V[2].xyz);\n\
             ResolvedView.ViewToClip = (float4x4)0;\n\
             ResolvedView.ViewToClip[0][0] = unity_CameraProjection[0][0];\n\
             ResolvedView.ViewToClip[1][1] = unity_CameraProjection[1][1];\n\
             ResolvedView.ViewRectMin = float4(7.0, 9.0, 0.0, 0.0);\n\
             ResolvedView.ViewSizeAndInvSize = float4(_ScreenParams.xy, 1.0 / _ScreenParams.xy);\n\
             FMaterialPixelParameters Parameters;\n\
             float2 pixel = passed.clip.xy;\n\
             Parameters.TangentToWorld =\n\
             float3x3(passed.tangent, passed.bitangent, passed.normal);\n\
             Parameters.SvPosition = float4(pixel + ResolvedView.ViewRectMin.xy, 0.5, 1.0);\n\
             float Opacity = 0.0;\n\
             float3 color = CustomExpression0(Parameters, {values}Opacity);\n{mask}\
             return float4(color, Opacity);\n}}\nENDHLSL\nHLSLPROGRAM\n\
             #pragma vertex vertex_of\n#pragma fragment fragment_of\nENDHLSL\n",
            self.file, self.code,
        )
    }
}

/// An input of the Custom node: its name, its type and the value that its node gives.
fn input(text: &str, line: &str) -> (String, &'static str, String) {
    let between = |begin: &str, end: char| {
        let (_, rest) = line.split_once(begin).unwrap_or_else(|| panic!("{begin} in {line}"));
        rest.split(end).next().unwrap_or_default().to_owned()
    };
    let name = between("InputName=\"", '"');
    let class = between("/Script/Engine.MaterialExpression", '\'');
    let node = between("'MaterialGraphNode_", '.');
    let head = format!("Name=\"MaterialGraphNode_{node}\"");
    let (_, object) = text.split_once(&head).unwrap_or_else(|| panic!("{head} in {text}"));
    let property = |name: &str| {
        let (_, rest) = object.split_once(name).unwrap_or_else(|| panic!("{name} of {line}"));
        rest.lines().next().unwrap_or_default().trim_matches(['(', ')']).to_owned()
    };
    let (ty, value) = match class.as_str() {
        "ScalarParameter" => ("float", property("DefaultValue=")),
        "VectorParameter" => {
            let numbers = property("DefaultValue=");
            let numbers: Vec<&str> = numbers.split(',').map(|part| &part[2..]).collect();
            match line.contains("OutputIndex=4") {
                true => ("float", numbers[3].to_owned()),
                false => ("float3", format!("float3({})", numbers[..3].join(", "))),
            }
        }
        "TextureObjectParameter" => {
            let is_array = property("Texture=").contains("Engine.Texture2DArray'");
            (if is_array { "Texture2DArray" } else { "Texture2D" }, String::new())
        }
        "WorldPosition" => ("float3", "passed.world".to_owned()),
        "TextureCoordinate" => ("float2", "passed.uv".to_owned()),
        "Time" => ("float", "0.0".to_owned()),
        "VertexColor" if line.contains("OutputIndex=4") => ("float", "passed.color.a".to_owned()),
        "VertexColor" => ("float3", "passed.color.rgb".to_owned()),
        "VertexNormalWS" => ("float3", "passed.normal".to_owned()),
        "TwoSidedSign" => ("float", "(is_front ? 1.0 : -1.0)".to_owned()),
        "CameraPositionWS" => ("float3", "100.0 * turned(_WorldSpaceCameraPos)".to_owned()),
        "TransformPosition" => ("float3", "passed.local".to_owned()),
        "ObjectPositionWS" => ("float3", "(0.0).xxx".to_owned()),
        other => panic!("an unknown node {other}"),
    };
    (name, ty, value)
}

/// The textures of a package's material, imported as its text of one screen says.
fn textures(folder: &Path, text: &str) -> Textures {
    let readme = fs::read_to_string(folder.join("README.md")).expect("a text");
    let mut found = Textures::new();
    for line in readme.lines() {
        // | `rim.stroke.png` | off | Bi-linear | Wrap |
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let ["", file, srgb @ ("on" | "off"), filter, tiling, ""] = cells[..] else { continue };
        let file = file.trim_matches('`');
        // Unreal makes an asset of the file's name.
        let asset = file.rsplit_once('.').expect("an ending").0.replace('.', "_");
        let (before, _) = text
            .split_once(&format!("'/Game/Chiaro/{asset}.{asset}'"))
            .unwrap_or_else(|| panic!("a texture {asset} in {text}"));
        let name = before.rsplit_once("ParameterName=\"").expect("a parameter").1;
        let name = format!("{}Bound", name.split('"').next().unwrap_or_default());
        let bytes = fs::read(folder.join(file)).expect("a file");
        let word =
            |at: usize| u32::from_le_bytes(bytes[4 * at..4 * at + 4].try_into().expect("a word"));
        let (size, texels, layers) = if file.ends_with(".dds") {
            // Format 28: RGBA of 8 bits.
            assert_eq!((word(21), word(32)), (u32::from_le_bytes(*b"DX10"), 28));
            ([word(4), word(3)], bytes[148..].to_vec(), Some(word(35)))
        } else {
            let image = image::load_from_memory(&bytes).expect("an image").to_rgba8();
            (image.dimensions().into(), image.into_raw(), None)
        };
        found.insert(
            name,
            Texture {
                size,
                bytes: texels,
                layers,
                is_decoded: srgb == "on",
                is_linear: filter == "Bi-linear",
                wrap: match tiling {
                    "Wrap" => wgpu::AddressMode::Repeat,
                    "Mirror" => wgpu::AddressMode::MirrorRepeat,
                    _ => wgpu::AddressMode::ClampToEdge,
                },
            },
        );
    }
    found
}

/// Every pin that a link names is there, and names the other end.
fn check_pins(text: &str) {
    let mut links: Vec<(String, String, String)> = Vec::new();
    let mut node = String::new();
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("Begin Object Class=") {
            node = rest.split('"').nth(1).unwrap_or_default().to_owned();
        }
        let Some((_, pin)) = line.split_once("PinId=") else { continue };
        let id = pin[..32].to_owned();
        let ends = pin.split_once("LinkedTo=(").map_or("", |(_, rest)| rest);
        let ends = ends.split(')').next().unwrap_or_default();
        for end in ends.split(',').filter(|end| !end.is_empty()) {
            links.push((node.clone(), id.clone(), end.to_owned()));
        }
    }
    assert!(links.len() >= 2, "{text}");
    for (node, id, end) in &links {
        let back = format!("{node} {id}");
        let is_back = |(node, id, to): &&(String, String, String)| {
            *to == back && format!("{node} {id}") == *end
        };
        assert!(links.iter().any(|link| is_back(&link)), "{node} {id} has no way back");
    }
}

fn has_tools() -> bool {
    let tools = [Tool::Glslang, Tool::Slang];
    tools.iter().all(|tool| {
        let is_here = tool.is_here();
        if !is_here {
            tool.missing().expect("a required tool");
        }
        is_here
    })
}

/// Looks are drawn as we draw them: many lights, with host work in the shader, and a painted
/// surface.
#[test]
fn unreal_packages_draw_what_we_draw() {
    if !has_tools() {
        return;
    }
    let trials = examples(&["looks/string-of-lamps", "hcbtf/grass-flat"]);
    let trials = trials.into_iter().map(|(name, trial)| (name, in_one_tier(trial)));
    compare(&trials.collect::<Vec<_>>());
}

/// All example looks. `CHIARO_BLESS=1` writes their lines.
#[test]
#[ignore = "takes minutes; scripts/soak runs it"]
fn soak_unreal_packages_draw_all_examples() {
    if has_tools() {
        let trials = soak_trials("unreal", in_one_tier);
        let is_whole = std::env::var_os("CHIARO_LOOKS").is_none();
        assert!(!is_whole || trials.len() > 50, "{} looks are taken", trials.len());
        compare(&trials);
    }
}

/// Draws packages, and compares what they show with our own pictures and the table.
fn compare(trials: &[(String, Trial)]) {
    let mut measured = BTreeMap::new();
    for (name, trial) in trials {
        let folder = trial.package("unreal");
        let material = Material::of(&folder);
        let (ours, found) = material.drawn(trial, &folder);
        keep(name, &found, &ours);
        let seen = ours.pixels().filter(|pixel| pixel.0[3] > 0).count();
        assert!(seen > 1000, "{name}: {seen} pixels are covered");
        measured.insert(format!("unreal stand-in {name}"), Difference::of(&found, &ours));
    }
    table::check(&measured);
}

/// A parameter of the material changes what it changes with us.
#[test]
fn parameters_of_unreal_change_what_they_change_with_us() {
    if !has_tools() {
        return;
    }
    let trial = in_one_tier(Trial::of("looks/highlight-moves"));
    let folder = trial.package("unreal");
    let changed = in_one_tier(Trial::changed("looks/highlight-moves", |look| {
        for node in look["nodes"].as_array_mut().into_iter().flatten() {
            if node["id"] == "move" {
                node["values"]["x"] = serde_json::json!(0.3);
            }
        }
    }));
    let mut material = Material::of(&folder);
    let (before, _) = material.drawn(&trial, &folder);
    let moved = material.inputs.iter_mut().find(|(name, ..)| name == "MoveX");
    moved.expect("an input").2 = "0.3".to_owned();
    let (ours, found) = material.drawn(&changed, &folder);
    assert!(Difference::of(&found, &before).beyond > 100, "the value is seen");
    let key = "unreal stand-in highlight-moves-set".to_owned();
    table::check(&BTreeMap::from([(key, Difference::of(&found, &ours))]));
}

/// glslang takes the functions. It finds no names within a namespace, so its text has none.
#[test]
fn glslang_takes_the_functions_of_unreal() {
    if !has_tools() {
        return;
    }
    for name in ["mood", "lights-apart"] {
        let trial = Trial::of(&format!("looks/{name}"));
        let folder = trial.package("unreal");
        let material = Material::of(&folder);
        let text = fs::read_to_string(folder.join(&material.file)).expect("the functions");
        let (before, rest) = text.split_once("namespace ").expect("a namespace");
        let (class, rest) = rest.split_once("\n{\n").expect("its beginning");
        let rest = rest.trim_end().strip_suffix('}').expect("its end");
        // The stand-in has names of its own, which no namespace keeps apart now.
        let text = format!("#undef Light\n#undef PI\n#undef HALF_PI\n{before}{rest}")
            .replace("#pragma once", "");
        let place = tempfile::tempdir().expect("a folder");
        fs::write(place.path().join(&material.file), text).expect("a file");
        let shader = material.shader().replace(&format!("{class}::"), "");
        let (_, shader) = shader.split_once("HLSLINCLUDE\n").expect("a text");
        let (shader, _) = shader.split_once("ENDHLSL").expect("its end");
        let shader = format!("#define Light LightOfTheStandIn\n{shader}");
        glslang(place.path(), &shader, "fragment_of", "fragment");
    }
}
