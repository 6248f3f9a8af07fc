//! Exported looks: golden outputs of every example look in every language, and the description held
//! against programs that do not share the exporter's code.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::support::files;
use crate::support::validators::{glslang_reflection, tint};
use crate::verdicts::verdict;
use chiaro::compile::{
    CompileOptions, HostInputs, LightValues, Live, Stage as CompileStage, compile,
};
use chiaro::document::{Directions, Grid, Hcbtf, LightFrames, Look, Tile};
use chiaro::export::{ExportFile, LANGUAGES, export};
use chiaro::frame::Assets;
use chiaro::hcbtf;
use chiaro::interp::{
    Derivatives, FunctionOptions, Literals, Precision, Program, ScalarKind, Shape, Value,
};
use chiaro::library::Library;
use chiaro::wgsl;
use glam::{DMat3, DQuat};
use serde_json::{Value as Json, json};

/// The folder of the golden outputs.
fn golden_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

fn read_look(text: &str, name: &str) -> Look {
    let loaded = Look::read(text, name);
    loaded.value.unwrap_or_else(|| panic!("{:?}", loaded.diagnostics))
}

/// All files of a look in all languages.
fn export_all(look: &Look, stem: &str) -> Vec<ExportFile> {
    let exported = export(
        look,
        Library::built_in(),
        stem,
        &LANGUAGES,
        (Path::new(""), &mut Assets::default()),
    );
    let exported = exported.unwrap_or_else(|problems| {
        panic!(
            "{stem}: {}",
            problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
        )
    });
    exported.value
}

/// The golden files as they should be, by their paths below the folder.
fn expected() -> BTreeMap<PathBuf, Vec<u8>> {
    let looks = files::below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks"));
    let mut expected = BTreeMap::new();
    for path in
        looks.iter().filter(|path| path.extension().is_some_and(|extension| extension == "json"))
    {
        let stem = path.file_stem().expect("a file").to_string_lossy().into_owned();
        let look =
            read_look(&fs::read_to_string(path).expect("an example"), &path.display().to_string());
        for file in export_all(&look, &stem) {
            let name = Path::new(&stem).join(&file.name);
            assert!(
                expected.insert(name.clone(), file.bytes).is_none(),
                "two files are {}",
                name.display()
            );
        }
    }
    expected
}

/// The first line that differs, or the sizes where a file is no text.
fn difference(golden: &[u8], now: &[u8]) -> String {
    let (Ok(golden_text), Ok(now_text)) = (std::str::from_utf8(golden), std::str::from_utf8(now))
    else {
        return format!("{} bytes, now {}", golden.len(), now.len());
    };
    let longest = golden_text.lines().count().max(now_text.lines().count());
    let line = |text: &str, index: usize| text.lines().nth(index).unwrap_or("(the end)").to_owned();
    let first = (0..longest).find(|&index| line(golden_text, index) != line(now_text, index));
    first.map_or_else(
        || "line ends differ".to_owned(),
        |index| {
            format!(
                "line {}\n  golden: {}\n  now:    {}",
                index + 1,
                line(golden_text, index),
                line(now_text, index)
            )
        },
    )
}

/// Golden outputs equal the exported files. `CHIARO_BLESS=1 cargo test --test export` writes them
/// anew.
#[test]
fn golden_outputs_are_what_is_exported() {
    let folder = golden_folder();
    let expected = expected();
    let mut found: Vec<PathBuf> = files::below(&folder);
    // Files beside the looks' folders are kept by other tests.
    found.retain(|path| path.parent() != Some(folder.as_path()));
    let is_blessing = env::var("CHIARO_BLESS").is_ok_and(|value| value == "1");
    let mut complaints = Vec::new();
    for path in &found {
        let name = path.strip_prefix(&folder).expect("below the folder");
        if !expected.contains_key(name) {
            if is_blessing {
                fs::remove_file(path).expect("a stale golden file");
            } else {
                complaints.push(format!(
                    "{}: no example look is exported to this file any more",
                    path.display()
                ));
            }
        }
    }
    for (name, now) in &expected {
        let path = folder.join(name);
        let golden = fs::read(&path);
        if golden.as_ref().is_ok_and(|golden| golden == now) {
            continue;
        }
        if is_blessing {
            fs::create_dir_all(path.parent().expect("a folder"))
                .expect("a folder for golden files");
            fs::write(&path, now).expect("a golden file");
        } else {
            let what = golden.map_or_else(
                |_| "there is no such golden file".to_owned(),
                |old| difference(&old, now),
            );
            complaints.push(format!("{}: {what}", path.display()));
        }
    }
    let how = "if this is meant: CHIARO_BLESS=1 cargo test --test export, and read the difference";
    assert!(complaints.is_empty(), "{}\n{how}", complaints.join("\n"));
}

/// An export has no scene to send rays past: each look of `examples/shadows` is refused, and the
/// nodes that send rays are named.
#[test]
fn looks_that_send_rays_are_refused() {
    let looks = files::below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/shadows"));
    assert!(!looks.is_empty(), "the looks that send rays are gone");
    for path in looks {
        let name = path.display().to_string();
        let look = read_look(&fs::read_to_string(&path).expect("an example"), &name);
        let assets = (Path::new(""), &mut Assets::default());
        let refused = export(&look, Library::built_in(), "a", &LANGUAGES, assets);
        let problems = refused.map(|_| ()).expect_err(&name);
        for problem in problems {
            assert_eq!(problem.code, "export-casters", "{name}: {problem}");
            let node = problem.place.node.as_ref().expect("a node is named").to_string();
            let outer = node.split('/').next().unwrap_or_default();
            let is_there = look.graph.nodes.keys().any(|id| id.to_string() == outer);
            assert!(is_there, "{name} has no node {outer}");
            assert!(!problem.hints.is_empty(), "{name}: what to do is told");
        }
    }
}

/// The description tells whose GLSL a file is: OpenGL and Vulkan take different texts that both say
/// 450.
#[test]
fn the_description_says_whose_glsl_it_is() {
    let look = read_look(
        r#"{"nodes": [{"kind": "base"}, {"kind": "output"}],
        "wires": [{"from": "base", "to": "output.color"}]}"#,
        "a.json",
    );
    let files = export_all(&look, "a");
    let file = files.iter().find(|file| file.name == "a.json").expect("a description");
    let described: Json = serde_json::from_slice(&file.bytes).expect("JSON");
    let glsl = &described["languages"]["glsl-450"];
    let note = glsl["note"].as_str().expect("a note");
    assert!(
        note.contains("OpenGL 4.5") && note.contains("not for Vulkan") && note.contains("spirv"),
        "{note}"
    );
    assert_eq!(glsl["clip_space"]["depth"], json!([-1, 1]));
}

#[test]
fn exporting_twice_gives_the_same_bytes() {
    assert_eq!(expected(), expected());
}

/// A look with every kind of thing that a look can hold: exposed numbers, colors, a ramp, a choice
/// and a light's field; a number that becomes a color; time; a directional and a spot light; an
/// image in a node of its own; curvature, also of detail normals; an alpha cutoff.
const RICH: &str = include_str!("rich.json");

fn rich() -> Look {
    read_look(RICH, "rich.json")
}

fn file<'f>(files: &'f [ExportFile], name: &str) -> &'f ExportFile {
    files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}"))
}

fn text(file: &ExportFile) -> String {
    String::from_utf8(file.bytes.clone()).expect("UTF-8")
}

fn description(files: &[ExportFile], stem: &str) -> Json {
    serde_json::from_slice(&file(files, &format!("{stem}.json")).bytes).expect("JSON")
}

fn module<'d>(description: &'d Json, name: &str) -> &'d Json {
    let modules = description["modules"].as_array().expect("modules");
    modules
        .iter()
        .find(|module| module["name"] == name)
        .unwrap_or_else(|| panic!("no module {name}"))
}

/// Complaints of outside compilers about files of every language, one text for each refused file;
/// and the number of WGSL files among them.
fn judged(files: &[ExportFile]) -> (Vec<String>, usize) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut wgsl = Vec::new();
    let mut complaints = Vec::new();
    for file in files {
        if file.name.ends_with(".wgsl") {
            wgsl.push(folder.path().join(&file.name));
            fs::write(folder.path().join(&file.name), &file.bytes).expect("a temporary file");
        }
        let refused = verdict(&file.name, &file.bytes).and_then(Result::err);
        complaints.extend(refused.map(|error| format!("{}: {error}", file.name)));
    }
    complaints.extend(tint(&wgsl).err());
    (complaints, wgsl.len())
}

/// The outside compilers that judge the golden outputs take a look with everything, which the
/// examples need not resemble.
#[test]
fn everything_a_look_can_hold_passes_the_validators() {
    let (complaints, wgsl) = judged(&export_all(&rich(), "rich"));
    assert!(complaints.is_empty(), "{}", complaints.join("\n\n"));
    assert_eq!(wgsl, 7, "four modules and three files of functions");
}

#[test]
fn images_and_hcbtfs_are_carried_along() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let directions = Directions { theta: 2, phi: 3 };
    let grid = Grid { size: [3, 2], light: directions, view: directions };
    let mut painting = Hcbtf::new(grid);
    for (index, address) in grid.addresses().enumerate() {
        painting
            .painted
            .insert(address, Tile::filled(grid.size, [index as u8, 200, 7, 255]).into());
    }
    fs::write(folder.path().join("moss.hcbtf"), hcbtf::write(&painting).expect("it fits"))
        .expect("a temporary file");
    fs::write(folder.path().join("moss.png"), b"not looked at").expect("a temporary file");
    let lookup = |id: &str, lookup: &str, tier: &str| {
        json!({
            "id": id, "kind": "hcbtf_lookup", "tier": tier,
            "values": {"sheet": "moss.hcbtf", "lookup": lookup}
        })
    };
    let look = json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            lookup("a", "smooth", "exact"), lookup("b", "smooth", "balanced"),
            lookup("c", "texels", "fast"),
            {"id": "ab", "kind": "mix_colors"}, {"id": "abc", "kind": "mix_colors"},
            {"id": "all", "kind": "mix_colors"},
            {"id": "image", "kind": "image", "values": {"image": "moss.png"}},
            {"id": "gone", "kind": "image", "values": {"image": "gone.png"}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "a.light"}, {"from": "light", "to": "b.light"},
            {"from": "light", "to": "c.light"},
            {"from": "a", "to": "ab.a"}, {"from": "b", "to": "ab.b"}, {"from": "ab", "to": "abc.a"},
            {"from": "c", "to": "abc.b"},
            {"from": "abc", "to": "all.a"}, {"from": "image.color", "to": "all.b"},
            {"from": "gone.alpha", "to": "all.factor"},
            {"from": "all", "to": "output.color"}
        ]
    });
    let look = read_look(&look.to_string(), "moss.json");
    let exported = export(
        &look,
        Library::built_in(),
        "moss",
        &LANGUAGES,
        (folder.path(), &mut Assets::default()),
    );
    let exported = exported.unwrap_or_else(|problems| panic!("{problems:?}"));
    let (complaints, _) = judged(&exported.value);
    assert!(complaints.is_empty(), "{}", complaints.join("\n\n"));
    let told: Vec<_> = exported
        .warnings
        .iter()
        .map(|problem| (problem.code, problem.place.node.as_ref().map(ToString::to_string)))
        .collect();
    assert_eq!(told, [("not-carried", Some("gone".to_owned()))]);
    let images = description(&exported.value, "moss")["images"].as_array().expect("images").clone();
    let named = |image: &Json| {
        (
            image["path"].as_str().unwrap().to_owned(),
            image["kind"].as_str().unwrap().to_owned(),
            image["file"].as_str().map(str::to_owned),
        )
    };
    let mut named: Vec<_> = images.iter().map(named).collect();
    named.sort();
    let row = |path: &str, kind: &str, file: Option<&str>| {
        (path.to_owned(), kind.to_owned(), file.map(str::to_owned))
    };
    // The HCBTF is exported with smaller levels and without, as its two lookups read it.
    let wanted = [
        row("gone.png", "image", None),
        row("moss.hcbtf", "hcbtf", Some("moss.moss-2.ktx2")),
        row("moss.hcbtf", "hcbtf", Some("moss.moss.ktx2")),
        row("moss.png", "image", Some("moss.moss.png")),
    ];
    assert_eq!(named, wanted);
    assert_eq!(file(&exported.value, "moss.moss.png").bytes, b"not looked at");
    for name in ["moss.moss.ktx2", "moss.moss-2.ktx2"] {
        let layers =
            hcbtf::ktx2::read(&file(&exported.value, name).bytes, name).expect("a texture");
        assert_eq!(hcbtf::from_layers(&layers).expect("an HCBTF").painted, painting.painted);
    }
}

#[test]
fn every_file_that_the_description_names_is_there() {
    let files = export_all(&rich(), "rich");
    let described = description(&files, "rich");
    let mut named = vec!["rich.json".to_owned()];
    for language in described["languages"].as_object().expect("languages").values() {
        for module in language["modules"].as_array().expect("modules") {
            let files = module["files"].as_array().expect("files");
            named
                .extend(files.iter().map(|file| file["file"].as_str().expect("a name").to_owned()));
        }
    }
    for module in described["modules"].as_array().expect("modules") {
        named.extend(module["host"]["functions"].as_str().map(str::to_owned));
    }
    let mut there: Vec<_> = files.iter().map(|file| file.name.clone()).collect();
    named.sort();
    there.sort();
    assert_eq!(named, there);
}

#[test]
fn unverified_languages_say_so_in_every_file() {
    let files = export_all(&rich(), "rich");
    for file in
        files.iter().filter(|file| !file.name.ends_with(".spv") && !file.name.ends_with(".json"))
    {
        let is_unverified = file.name.ends_with(".metal");
        assert_eq!(text(file).contains("// UNVERIFIED: "), is_unverified, "{}", file.name);
        // The look's name, `Rich look\`, ends in a backslash, which must not swallow the line after
        // a comment.
        assert!(!text(file).lines().take(3).any(|line| line.ends_with('\\')), "{}", file.name);
    }
    // The heap of samplers that only wgpu has is not exported.
    assert!(
        text(file(&files, "rich.hlsl")).contains("SamplerState image_1_sampler : register(s0);")
    );
    assert!(
        files.iter().all(|file| !String::from_utf8_lossy(&file.bytes).contains("nagaSamplerHeap"))
    );
}

/// Offsets of uniforms in the description by full name, such as `u_look.key.direction`.
fn described_offsets(description: &Json) -> BTreeMap<String, u64> {
    let mut offsets = BTreeMap::new();
    for binding in module(description, "draw")["bindings"].as_array().expect("bindings") {
        let members = binding["members"].as_array();
        let root = format!("u_{}", binding["name"].as_str().expect("a name"));
        let mut open: Vec<(String, u64, &Json)> =
            members.into_iter().flatten().map(|m| (root.clone(), 0, m)).collect();
        while let Some((path, start, member)) = open.pop() {
            let path = format!("{path}.{}", member["name"].as_str().expect("a name"));
            let at = start + member["offset"].as_u64().expect("an offset");
            open.extend(
                member["members"]
                    .as_array()
                    .into_iter()
                    .flatten()
                    .map(|inner| (path.clone(), at, inner)),
            );
            offsets.insert(path, at);
        }
    }
    offsets
}

/// Offsets in the description agree with glslang, which lays std140 blocks out by itself.
#[test]
fn uniforms_lie_in_glsl_where_the_description_says() {
    let files = export_all(&rich(), "rich");
    let offsets = described_offsets(&description(&files, "rich"));
    for version in ["330", "450"] {
        let names = ["vert", "frag"].map(|extension| format!("rich.{version}.{extension}"));
        let folder = tempfile::tempdir().expect("a temporary folder");
        for name in &names {
            fs::write(folder.path().join(name), &file(&files, name).bytes)
                .expect("a temporary file");
        }
        let Some(reflection) = glslang_reflection(folder.path(), &names) else { return };
        let mut count = 0;
        for line in
            reflection.lines().filter(|line| line.starts_with("u_") && !line.contains("offset -1"))
        {
            let (name, rest) = line.split_once(": offset ").expect("a reflected uniform");
            let offset: u64 =
                rest.split(',').next().and_then(|number| number.parse().ok()).expect("an offset");
            assert_eq!(offsets.get(name), Some(&offset), "{name} in GLSL {version}");
            count += 1;
        }
        assert!(count >= 25, "only {count} uniforms:\n{reflection}");
    }
}

/// The value of a step of `host`: JSON as the description has it, or the value that a function
/// gave.
#[derive(Clone, Debug)]
enum StepValue {
    Json(Json),
    Value(Value),
}

/// A JSON value as a value of a shape.
fn shaped(json: &Json, shape: &Shape) -> Value {
    let items = || json.as_array().expect("a list").iter();
    let numbers = || items().map(|item| item.as_f64().expect("a number")).collect::<Vec<_>>();
    match shape {
        Shape::Scalar(ScalarKind::Bool) => Value::Bool(json.as_bool().expect("a bool")),
        Shape::Scalar(ScalarKind::I32) => Value::I32(json.as_i64().expect("an integer") as i32),
        Shape::Scalar(ScalarKind::U32) => Value::U32(json.as_u64().expect("an integer") as u32),
        Shape::Scalar(ScalarKind::Float) => Value::Float(json.as_f64().expect("a number")),
        Shape::Vector { .. } => Value::vec(&numbers()),
        Shape::Matrix { columns, .. } => Value::Matrix { columns: *columns, components: numbers() },
        Shape::Array { element, .. } => {
            Value::Array(items().map(|item| shaped(item, element)).collect())
        }
        Shape::Struct { members, .. } => Value::Struct(
            items().zip(members).map(|(item, (_, member))| shaped(item, member)).collect(),
        ),
    }
}

/// Numbers of a value, in order.
fn flat(value: &Value) -> Vec<f64> {
    match value.parts() {
        Some(parts) => parts.iter().flat_map(flat).collect(),
        None => value.components().expect("numbers"),
    }
}

fn flat_json(json: &Json) -> Vec<f64> {
    match json {
        Json::Array(items) => items.iter().flat_map(flat_json).collect(),
        Json::Bool(b) => vec![f64::from(u8::from(*b))],
        other => vec![other.as_f64().expect("a number")],
    }
}

/// Runs a module's `host` as its documentation says, without the compiler's code.
fn evaluate(
    host: &Json,
    functions: &str,
    set: &dyn Fn(usize) -> Option<Json>,
    context: &dyn Fn(&Json) -> Json,
) -> Vec<Vec<f64>> {
    let valid = wgsl::parse(functions).expect("valid WGSL");
    // Constants are taken as written, in f64.
    let literals = Literals::of(functions);
    let options = FunctionOptions {
        derivatives: Derivatives::Zero,
        literals: Some(&literals),
        ..FunctionOptions::default()
    };
    let mut values: Vec<StepValue> = Vec::new();
    let index = |json: &Json| json.as_u64().expect("an index") as usize;
    for step in host["steps"].as_array().expect("steps") {
        let value = match step["op"].as_str().expect("an operation") {
            "constant" => StepValue::Json(step["value"].clone()),
            "parameter" => {
                let given = set(index(&step["parameter"])).map(|given| {
                    match (step["type"].as_str(), given) {
                        (Some("color"), Json::Number(x)) => json!([x, x, x, 1]),
                        (Some("color"), Json::Array(mut rgb)) if rgb.len() == 3 => {
                            rgb.push(json!(1));
                            Json::Array(rgb)
                        }
                        (_, given) => given,
                    }
                });
                StepValue::Json(given.unwrap_or_else(|| step["value"].clone()))
            }
            "context" => StepValue::Json(context(step)),
            "call" => {
                let function = step["function"].as_str().expect("a function");
                let program = Program::compile(&valid.module, function, options).expect(function);
                let arguments = step["arguments"]
                    .as_array()
                    .expect("arguments")
                    .iter()
                    .zip(program.parameters());
                let arguments: Vec<_> = arguments
                    .map(|(argument, parameter)| match &values[index(argument)] {
                        StepValue::Json(json) => shaped(json, &parameter.shape),
                        StepValue::Value(value) => value.clone(),
                    })
                    .collect();
                StepValue::Value(program.call(&arguments, Precision::F64).expect(function))
            }
            "member" => match &values[index(&step["of"])] {
                StepValue::Json(json) => StepValue::Json(json[index(&step["member"])].clone()),
                StepValue::Value(value) => StepValue::Value(
                    value.parts().expect("a struct")[index(&step["member"])].clone(),
                ),
            },
            other => panic!("{other}"),
        };
        values.push(value);
    }
    let members = host["members"].as_array().expect("members");
    let numbers = |member: &Json| match &values[index(&member["step"])] {
        StepValue::Json(json) => flat_json(json),
        StepValue::Value(value) => flat(value),
    };
    members.iter().map(numbers).collect()
}

/// A field of a light from the description, without the compiler's code. The illumination frame is
/// turned by 90 degrees about y: x becomes -z, z becomes x.
fn light_field(light: &Json, field: &str) -> Json {
    let values = &light["values"];
    let is_turned = values["space"] == "illumination";
    let vector = |name: &str| {
        values[name]
            .as_array()
            .expect(name)
            .iter()
            .map(|x| x.as_f64().expect(name))
            .collect::<Vec<_>>()
    };
    let unit = |v: &[f64]| {
        let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        vec![v[0] / length, v[1] / length, v[2] / length]
    };
    let world = |v: &[f64]| if is_turned { vec![v[2], v[1], -v[0]] } else { v.to_vec() };
    match field {
        "light.direction" => json!(world(&unit(&vector("direction")))),
        "light.own_direction" => json!(unit(&vector("direction"))),
        "light.position" => json!(world(&vector("position"))),
        "light.aim" => json!(world(&unit(&vector("aim")))),
        "light.own_from_world" if is_turned => json!([0, 0, 1, 0, 1, 0, -1, 0, 0]),
        "light.own_from_world" => json!([1, 0, 0, 0, 1, 0, 0, 0, 1]),
        "light.color" => values["color"].clone(),
        "light.intensity" => values["intensity"].clone(),
        "light.cone" => {
            json!([values["inner"].as_f64().map(f64::cos), values["outer"].as_f64().map(f64::cos)])
        }
        "light.fading" => json!([values["half_distance"], values["range"]]),
        other => panic!("{other}"),
    }
}

/// Values that the test sets, by their exposed names.
fn test_values() -> BTreeMap<&'static str, Json> {
    [
        ("speed", json!(0.7)),
        ("offset", json!(0.9)),
        ("shadow", json!([0.2, 0.3, 0.4])),
        ("warm", json!(0.35)),
        ("slope", json!(3)),
    ]
    .into()
}

#[test]
fn the_described_host_computes_what_the_compilers_does() {
    let look = rich();
    let files = export_all(&look, "rich");
    let described = description(&files, "rich");
    let test_values = test_values();
    for values in [BTreeMap::new(), test_values] {
        for (name, stage) in [
            ("draw", CompileStage::Draw),
            ("normals", CompileStage::Normals),
            ("detail_normals", CompileStage::DetailNormals),
        ] {
            let host = &module(&described, name)["host"];
            let functions = text(file(&files, host["functions"].as_str().expect("a file")));
            let exposed_name = |index: usize| {
                described["parameters"][index]["name"].as_str().expect("exposed").to_owned()
            };
            let set = |index: usize| values.get(exposed_name(index).as_str()).cloned();
            let context = |step: &Json| match step["light"].as_str() {
                Some(id) => {
                    let lights = described["lights"].as_array().expect("lights");
                    let light =
                        lights.iter().find(|light| light["id"] == id).expect("a described light");
                    light_field(light, step["context"].as_str().expect("a context"))
                }
                None => json!(2.5),
            };
            let found = evaluate(host, &functions, &set, &context);
            let expected = compiled_host(&look, stage, &values);
            assert_eq!(found.len(), expected.len());
            for ((member, found), expected) in
                host["members"].as_array().unwrap().iter().zip(&found).zip(&expected)
            {
                let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12 * a.abs().max(1.0);
                assert!(
                    found.len() == expected.len() && found.iter().zip(expected).all(is_near),
                    "{name}: {member}: {found:?} is not {expected:?}"
                );
                if values.is_empty() && !member["default"].is_null() {
                    let default = flat_json(&member["default"]);
                    assert!(
                        default.iter().zip(found).all(|(a, b)| *a as f32 == *b as f32),
                        "{member}"
                    );
                }
            }
        }
    }
}

/// Values of a module's `host` by the compiler's own program.
fn compiled_host(look: &Look, stage: CompileStage, values: &BTreeMap<&str, Json>) -> Vec<Vec<f64>> {
    let options = CompileOptions { live: Live::Exposed, stage, ..CompileOptions::default() };
    let shader = compile(look, Library::built_in(), &options).expect("a right look").value;
    let params: HashMap<usize, _> = values
        .iter()
        .filter_map(|(name, value)| {
            let exposed = look
                .exposed
                .iter()
                .find(|exposed| exposed.name.as_str() == *name)
                .expect("exposed");
            let target = exposed.target.to_string();
            let param = shader
                .params
                .iter()
                .position(|param| format!("{}.{}", param.path, param.port) == target)?;
            Some((param, serde_json::from_value(value.clone()).expect("a document's value")))
        })
        .collect();
    let illumination = DQuat::from_rotation_y(std::f64::consts::FRAC_PI_2);
    let frames = LightFrames { illumination, ..LightFrames::default() };
    let lights = look
        .lights
        .iter()
        .map(|(id, light)| (id.clone(), LightValues::new(light, &frames)))
        .collect();
    let inputs = HostInputs {
        params: &params,
        lights: &lights,
        camera_from_world: DMat3::IDENTITY,
        viewport: [2.5; 2],
        time: 2.5,
        frame: 2.5,
        object_id: 2.5,
    };
    shader.host.run(&inputs).expect("a program that ends").iter().map(flat).collect()
}

#[test]
fn parameters_are_described_as_people_see_them() {
    let files = export_all(&rich(), "rich");
    let described = description(&files, "rich");
    let parameter = |name: &str| {
        let list = described["parameters"].as_array().expect("parameters");
        list.iter()
            .find(|parameter| parameter["name"] == name)
            .unwrap_or_else(|| panic!("no {name}"))
            .clone()
    };
    assert_eq!(parameter("speed")["label"], "How fast", "the artist's label");
    assert_eq!(parameter("slope")["label"], "Shape slope", "the group's label");
    let offset = parameter("offset");
    assert_eq!(
        (&offset["label"], &offset["unit"], &offset["default"]),
        (&json!("Offset"), &json!("rad"), &json!(0))
    );
    assert_eq!((&offset["target"], &offset["type"]), (&json!("diffuse.offset"), &json!("float")));
    assert!((offset["max"].as_f64().expect("a range") - std::f64::consts::PI).abs() < 1e-12);
    let way = parameter("way");
    assert_eq!(
        (&way["type"], &way["default"], &way["live"]),
        (&json!("choice"), &json!("multiply"), &json!(false))
    );
    assert!(way["options"].as_array().expect("words").contains(&json!("screen")));
    assert_eq!(parameter("lamp")["default"], 1);
    assert_eq!(described["images"][0]["path"], "paper.png");
    let key = &described["lights"][0];
    assert_eq!(key["label"], "Key light");
    assert!(key["members"].as_array().expect("members").contains(&json!("draw.key")));
}

#[test]
fn passes_read_only_what_was_drawn_before() {
    let files = export_all(&rich(), "rich");
    let described = description(&files, "rich");
    let mut drawn = Vec::new();
    for pass in described["passes"].as_array().expect("passes") {
        for input in pass["inputs"].as_array().into_iter().flatten() {
            assert!(drawn.contains(&(input["pass"].clone(), input["output"].clone())), "{pass}");
        }
        let module = module(&described, pass["module"].as_str().expect("a module"));
        let bindings = module["bindings"].as_array().expect("bindings");
        let drawn_textures = bindings.iter().filter(|binding| {
            let from = &binding["feed"]["from"];
            from == "pass" || from == "inputs"
        });
        assert_eq!(drawn_textures.count(), pass["inputs"].as_array().map_or(0, Vec::len), "{pass}");
        let outputs = pass["outputs"].as_array().expect("outputs");
        let fragment = module["entry_points"]
            .as_array()
            .expect("entry points")
            .iter()
            .find(|p| p["stage"] == "fragment");
        assert_eq!(
            fragment.expect("a fragment shader")["outputs"].as_array().map(Vec::len),
            Some(outputs.len())
        );
        drawn.extend(outputs.iter().map(|output| (pass["name"].clone(), output["name"].clone())));
    }
    let names: Vec<_> = described["passes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|pass| pass["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["normals", "detail_normals", "curvature", "detail_curvature", "draw"]);
}

/// Tint takes a module of the whole library. Browsers refuse code that naga takes: derivatives
/// where control flow is not uniform, literals beyond f32.
#[test]
fn tint_takes_the_whole_library() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut seen = Vec::new();
    let mut paths = Vec::new();
    for def in Library::built_in().nodes.values() {
        let module = std::sync::Arc::as_ptr(&def.module);
        if !seen.contains(&module) {
            seen.push(module);
            paths.push(folder.path().join(format!("library_{}.wgsl", seen.len())));
            fs::write(&paths[seen.len() - 1], &def.module.linked.text).expect("a temporary file");
        }
    }
    tint(&paths).expect("the library is WGSL that browsers take");
}
