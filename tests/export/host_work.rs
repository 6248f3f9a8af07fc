//! Host work of whole looks, as their packages carry it: the bytes of every uniform, from
//! JavaScript, Python, GDScript or C# and from Chiaro, with keys, lights and parameters in motion.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

use glam::{DMat3, DMat4, DQuat, DVec3};
use indexmap::IndexMap;
use serde_json::{Value as Json, json};

use crate::support::godot::Godot;
use crate::support::random::Random;
use crate::support::validators::{say, tools_are_required};
use crate::support::{files, root};
use chiaro::compile::{CompileOptions, CompiledShader, HostInputs, Live, compile};
use chiaro::document::{
    Camera, Extrapolation, Look, Target, Tier, TimeInterpolation, TimeKey, TimeKeys, Value, Values,
};
use chiaro::export::ExportOptions;
use chiaro::export::package::{PackageScene, export_package, package};
use chiaro::files::Disk;
use chiaro::frame::{Assets, ParamTable, Rig, RigInputs, Wires};
use chiaro::geometry::Mesh;
use chiaro::library::Library;

/// States that each look is tried in.
const STATES: usize = 5;

/// Relative difference of a float of 32 bits that is rounding.
const TOLERANCE: f32 = 2e-6;

/// A state of a scene around one object.
struct State {
    camera: DMat3,
    eye: DVec3,
    parallel: Option<DVec3>,
    illumination: DQuat,
    turn: DQuat,
    middle: DVec3,
    time: f64,
    frame: f64,
    object_id: f64,
    viewport: [f64; 2],
    exposed: Values,
}

impl State {
    fn random(look: &Look, random: &mut Random) -> Self {
        let mut exposed = Values::new();
        for parameter in &look.exposed {
            if random.chance(0.4) {
                continue;
            }
            let own = value_of(look, &parameter.target);
            let value = match own {
                Some(Value::Number(x)) if x.fract() != 0.0 => {
                    Value::Number(single(x * random.between(0.5, 1.0)))
                }
                Some(Value::Vector(v)) => {
                    let parts = v.iter().map(|x| single(x * random.between(0.5, 1.0)));
                    Value::Vector(parts.collect())
                }
                _ => continue,
            };
            exposed.insert(parameter.name.clone(), value);
        }
        let parallel = random.chance(0.3).then(|| random.direction());
        Self {
            camera: DMat3::from_quat(random.rotation()),
            eye: random.direction() * random.between(2.0, 5.0),
            parallel,
            illumination: random.rotation(),
            turn: random.rotation(),
            middle: random.direction() * 0.4,
            time: random.between(-0.5, 4.0),
            frame: random.index(90) as f64,
            object_id: random.index(7) as f64,
            viewport: [random.between(60.0, 900.0).floor(), random.between(60.0, 900.0).floor()],
            exposed,
        }
    }

    fn json(&self) -> Json {
        let matrix = |m: DMat3| json!(m.to_cols_array());
        let vector = |v: DVec3| json!(v.to_array());
        json!({
            "parameters": self.exposed,
            "illumination": matrix(DMat3::from_quat(self.illumination)),
            "camera": {
                "rotation": matrix(self.camera),
                "eye": vector(self.eye),
                "parallel": self.parallel.is_some(),
                "toward": vector(self.parallel.unwrap_or(DVec3::Z)),
            },
            "object": {
                "id": self.object_id,
                "axes": matrix(DMat3::from_quat(self.turn)),
                "middle": vector(self.middle),
            },
            "viewport": self.viewport,
            "time": self.time,
            "frame": self.frame,
        })
    }

    /// The bytes of the uniform, by Chiaro.
    fn uniform(&self, look: &Look, shader: &CompiledShader) -> Vec<u8> {
        let rig = Rig::new(look).value;
        let view = self.parallel.unwrap_or_else(|| (self.eye - self.middle).normalize_or(DVec3::Z));
        let inputs = RigInputs {
            time: self.time,
            illumination: self.illumination,
            camera_from_world: self.camera,
            view,
            center: self.middle,
            distance: self.eye.distance(self.middle),
            front: self.turn * DVec3::Z,
            turn: self.turn,
            near: &IndexMap::new(),
            exposed: &self.exposed,
            lights: &IndexMap::new(),
            scene_values: &HashMap::new(),
            aims: &Arc::default(),
            viewport: self.viewport,
            frame: self.frame,
            object_id: self.object_id,
        };
        let table = ParamTable::new(&shader.params);
        let values = rig
            .evaluate(&shader.params, &table, Wires::of(shader), &inputs)
            .expect("an example's keys");
        let inputs = HostInputs {
            params: &values.params,
            lights: &values.lights,
            camera_from_world: self.camera,
            viewport: self.viewport,
            time: self.time,
            frame: self.frame,
            object_id: self.object_id,
        };
        shader.host.uniform(&inputs).expect("an example's host work").bytes
    }
}

/// A number that inspectors of 32 bits can hold.
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// The document's value of a target.
fn value_of(look: &Look, target: &Target) -> Option<Value> {
    match target {
        Target::Input { node, port } => match node.ids() {
            [id] => look.graph.nodes.get(id)?.values.get(port).cloned(),
            _ => None,
        },
        Target::Light { light, field } => {
            chiaro::frame::light_field(look.lights.get(light)?, field)
        }
    }
}

/// A file of a look's package.
fn packaged(look: &Look, name: &str, folder: &Path, slug: &str, ending: &str) -> String {
    let scene = PackageScene {
        mesh: Arc::new(Mesh::default()),
        world_from_object: DMat4::IDENTITY,
        camera: Camera::default(),
        backdrop: None,
    };
    let package = package(slug).expect("a package");
    let place = (folder, &mut Assets::default());
    let files = export_package(look, Library::built_in(), name, package, &scene, place)
        .unwrap_or_else(|problems| panic!("{name}: {}", problems[0]))
        .value;
    let own = format!("{name}.{ending}");
    let file = files.into_iter().find(|file| file.name == own).expect("the look");
    String::from_utf8(file.bytes).expect("text")
}

/// The look's `LOOK.js`, as a package has it.
fn javascript(look: &Look, name: &str, folder: &Path) -> String {
    packaged(look, name, folder, "web", "js")
}

/// The part of an add-on for Blender that any Python runs.
fn python(look: &Look, name: &str, folder: &Path) -> String {
    let whole = packaged(look, &name.replace('-', "_"), folder, "blender", "py");
    let (_, after) = whole.split_once("from mathutils import Matrix, Vector\n").expect("imports");
    let (own, _) = after.split_once("# Draws the look with").expect("the player");
    format!("import copy, math, struct\n{own}")
}

/// A look with its file's stem and the bytes that are wanted of it.
struct Case {
    name: String,
    script: String,
    states: Vec<Json>,
    wanted: Vec<Vec<u8>>,
}

/// The examples, every second of them with all values as parameters, from the first or the second.
fn cases(first_live: usize, written: fn(&Look, &str, &Path) -> String) -> Vec<Case> {
    // An export carries no rays.
    let is_live = |index: usize| index % 2 == first_live;
    let mut cases =
        cases_in(Tier::Balanced, is_live, |look, name, folder| Some(written(look, name, folder)));
    cases.push(moving_case(written));
    cases
}

/// A look of ten lights whose directions, colors and intensities go from key to key, and on beyond
/// their keys, in every way that there is.
fn moving_case(written: fn(&Look, &str, &Path) -> String) -> Case {
    use Extrapolation::{Cycle, CycleOffset, Hold, Linear, Mirror};
    use TimeInterpolation::{Bezier, Linear as Even, Smooth, Stepped};
    let mut random = Random::new(25);
    let path = root().join("examples/looks/lights-apart.json");
    let mut look = Look::load(&Disk, &path).value.expect("an example opens");
    look.set_every_tier(Tier::Balanced);
    let ids: Vec<_> = look.lights.keys().cloned().collect();
    for (number, light) in ids.into_iter().enumerate() {
        for (field, width) in [("direction", 3), ("color", 3), ("intensity", 1)] {
            let ways = [Bezier, Even, Bezier, Smooth, Stepped];
            let mut time = random.between(-0.5, 0.5);
            let mut key = |index: usize| {
                time += random.between(0.2, 1.5);
                let numbers: Vec<f64> = (0..width).map(|_| random.between(0.1, 1.0)).collect();
                let value = match numbers.as_slice() {
                    [number] => Value::Number(*number),
                    _ => Value::Vector(numbers),
                };
                let mut key = TimeKey::new(time, value, ways[(number + index) % ways.len()]);
                if random.chance(0.5) {
                    let way = |way: f64, random: &mut Random| {
                        [way * random.between(0.0, 1.0), random.between(-0.3, 0.3)]
                    };
                    key.incoming = (0..width).map(|_| way(-1.0, &mut random)).collect();
                    key.outgoing = (0..width).map(|_| way(1.0, &mut random)).collect();
                }
                key
            };
            let keys = (0..4).map(&mut key).collect();
            let ends = [Hold, Linear, Cycle, CycleOffset, Mirror];
            look.time_keys.push(TimeKeys {
                before: ends[(number + width) % ends.len()],
                after: ends[number % ends.len()],
                keys,
                ..TimeKeys::new(Target::Light { light: light.clone(), field: field.to_owned() })
            });
        }
    }
    let options = CompileOptions { live: Live::Exposed, ..CompileOptions::default() };
    let shader = compile(&look, Library::built_in(), &options).expect("an example").value;
    let states: Vec<State> = (0..40)
        .map(|_| State { time: random.between(-6.0, 9.0), ..State::random(&look, &mut random) })
        .collect();
    let name = "lights-moving".to_owned();
    Case {
        script: written(&look, &name, path.parent().expect("a folder")),
        name,
        wanted: states.iter().map(|state| state.uniform(&look, &shader)).collect(),
        states: states.iter().map(State::json).collect(),
    }
}

/// The examples in a tier of which something is written; those that `is_live` names by their
/// numbers have all values as parameters.
fn cases_in(
    tier: Tier,
    is_live: impl Fn(usize) -> bool,
    mut written: impl FnMut(&Look, &str, &Path) -> Option<String>,
) -> Vec<Case> {
    let mut random = Random::new(7);
    let mut cases = Vec::new();
    for path in files::below(&root().join("examples/looks")) {
        if path.extension().is_none_or(|ending| ending != "json") {
            continue;
        }
        let name = path.file_stem().expect("a file").to_string_lossy().into_owned();
        let mut look = Look::load(&Disk, &path).value.expect("an example opens");
        look.set_every_tier(tier);
        if is_live(cases.len()) {
            let options = ExportOptions { is_live: true, ..ExportOptions::default() };
            options.apply(&mut look, &mut Library::built_in().clone(), true).expect("an example");
        }
        let options = CompileOptions { live: Live::Exposed, ..CompileOptions::default() };
        let shader = compile(&look, Library::built_in(), &options).expect("an example").value;
        if shader.host.size == 0 {
            continue;
        }
        let Some(script) = written(&look, &name, path.parent().expect("a folder")) else {
            continue;
        };
        let states: Vec<State> = (0..STATES).map(|_| State::random(&look, &mut random)).collect();
        cases.push(Case {
            name,
            script,
            wanted: states.iter().map(|state| state.uniform(&look, &shader)).collect(),
            states: states.iter().map(State::json).collect(),
        });
    }
    cases
}

#[test]
fn packages_compute_the_uniforms_of_every_example() {
    let cases = cases(1, javascript);
    // The page's script puts the look where a browser has it.
    let mut program = "const results = [];\nconst window = {};\n".to_owned();
    for case in &cases {
        let _ = writeln!(
            program,
            "results.push((() => {{\n{}\nconst {{ look }} = \
             Object.values(window.chiaroExports).at(-1);\nreturn {}.map((state) => \
             Array.from(new Uint32Array(look.modules.draw.prepare(state))));\n}})());",
            case.script,
            json!(case.states)
        );
    }
    program += "console.log(JSON.stringify(results));\n";
    compare(&cases, "node", "looks.mjs", &program);
}

#[test]
fn add_ons_compute_the_uniforms_of_every_example() {
    let cases = cases(0, python);
    let mut program = "import json, struct\nresults = []\n".to_owned();
    for case in &cases {
        let _ = writeln!(
            program,
            "look = {{}}\nexec({}, look)\nstates = json.loads({})\n\
             all_bytes = [look[\"prepare\"](\"draw\", state) for state in states]\n\
             results.append([struct.unpack(f\"<{{len(it) // 4}}I\", it) for it in all_bytes])",
            json!(case.script),
            json!(json!(case.states).to_string())
        );
    }
    program += "print(json.dumps(results))\n";
    compare(&cases, "python3", "looks.py", &program);
}

/// Function of GDScript that gives the numbers of a look's uniform in states.
const NUMBERS: &str = r#"
func numbers(folder: String, stem: String, states: Array) -> Array:
	var look := MeshInstance3D.new()
	look.set_script(load("res://%s/%s.gd" % [folder, stem]))
	var own := {}
	for property: Dictionary in look.get_script().get_script_property_list():
		own[property.name] = look.get(property.name)
	var all := []
	for state: Dictionary in states:
		var around := {
			illumination = columns(state.illumination),
			camera_from_world = columns(state.camera.rotation),
			eye = state.camera.eye,
			parallel = state.camera.toward if state.camera.parallel else [0.0, 0.0, 0.0],
			object_axes = columns(state.object.axes),
			object_middle = state.object.middle,
			object_id = state.object.id,
			viewport = state.viewport,
			time = state.time,
			frame = state.frame,
		}
		for name: String in own:
			if name.begins_with("near_"):
				around[name] = 1e6
		for name: String in state.parameters:
			var property := property_of(look, name)
			look.set(property, value(state.parameters[name], own.get(property)))
		var host: GDScript = load("res://%s/%s.host.gd" % [folder, stem])
		var settings: Dictionary = look.call("_settings", around)
		if host.get_script_method_list().any(is_keyed):
			settings = host.call("keyed", settings, around)
		all.append(host.call("draw_numbers", settings, around))
		for name: String in state.parameters:
			var property := property_of(look, name)
			look.set(property, own[property])
	look.free()
	return all


func is_keyed(method: Dictionary) -> bool:
	return method.name == "keyed"


## Properties that a node has already get an end.
func property_of(look: Node, name: String) -> String:
	var wanted := name.to_lower().replace("-", "_").replace(".", "_")
	for property: Dictionary in look.get_script().get_script_property_list():
		if property.name == wanted:
			return wanted
	return wanted + "_of_look"


func columns(m: Array) -> Array:
	return [m.slice(0, 3), m.slice(3, 6), m.slice(6, 9)]


func value(given: Variant, own: Variant) -> Variant:
	match typeof(own):
		TYPE_COLOR:
			return Color(given[0], given[1], given[2], given[3] if given.size() > 3 else 1.0)
		TYPE_VECTOR2:
			return Vector2(given[0], given[1])
		TYPE_VECTOR3:
			return Vector3(given[0], given[1], given[2])
		TYPE_VECTOR4:
			return Vector4(given[0], given[1], given[2], given[3])
	return given
"#;

/// The scripts of the package for Godot, of every example that one pass draws in the fast tier.
#[test]
#[ignore = "takes ten seconds; scripts/soak runs it"]
fn soak_scripts_compute_the_uniforms_of_every_example() {
    let mut files = Vec::new();
    let scene = PackageScene {
        mesh: Arc::new(Mesh::default()),
        world_from_object: DMat4::IDENTITY,
        camera: Camera::default(),
        backdrop: None,
    };
    let never = |_| false;
    let cases = cases_in(Tier::Fast, never, |look, name, folder| {
        let place = (folder, &mut Assets::default());
        let library = Library::built_in();
        let package = package("godot").expect("a package");
        let found = export_package(look, library, name, package, &scene, place).ok()?.value;
        for file in found {
            let is_shader = file.name.ends_with(".gdshader");
            if is_shader || file.name.ends_with(".gd") {
                // What is computed is asked for, not what is drawn.
                let bytes = if is_shader { b"shader_type spatial;\n".to_vec() } else { file.bytes };
                files.push((format!("{name}/{}", file.name), bytes));
            }
        }
        Some(String::new())
    });
    let Some(mut godot) = Godot::start(&files).expect("Godot starts") else { return };
    assert!(cases.len() > 50, "{} looks have host work", cases.len());
    let mut script =
        format!("extends RefCounted\n\n{NUMBERS}\n\nfunc run(_main: Node) -> Array:\n");
    script += "\tvar all := []\n";
    for case in &cases {
        let states = json!(json!(case.states).to_string());
        let _ = writeln!(
            script,
            "\tall.append(numbers(\"{0}\", \"{0}\", JSON.parse_string({states})))",
            case.name
        );
    }
    script += "\treturn all\n";
    let results =
        godot.run(&script).unwrap_or_else(|said| panic!("{}", &said[..said.len().min(4000)]));
    let results: Vec<Vec<Vec<f64>>> = serde_json::from_value(results).expect("lists of numbers");
    compare_numbers(&cases, &results);
}

/// A program in C# that gives the numbers of looks in states, by the fields of their components.
const COMPARISON: &str = r#"
using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using UnityEngine;

static class Comparison
{
    const BindingFlags Any =
        BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

    static string Plain(string name) => name.Replace("_", "").Replace("-", "").Replace(".", "")
        .ToLowerInvariant();

    static object Vector(Type type, double[] v) =>
        Activator.CreateInstance(type, v.Cast<object>().ToArray());

    static object Columns(Type type, double[] m)
    {
        Type column = type.GetField("c0").FieldType;
        return Activator.CreateInstance(type, Enumerable.Range(0, 3)
            .Select(at => Vector(column, m.Skip(3 * at).Take(3).ToArray())).ToArray());
    }

    static object Value(Type type, double[] v)
    {
        if (type == typeof(float)) return (float)v[0];
        if (type == typeof(int)) return (int)v[0];
        if (type == typeof(bool)) return v[0] != 0.0;
        var parts = v.Select(x => (object)(float)x).ToList();
        if (type == typeof(Color) && parts.Count == 3) parts.Add(1f);
        return Activator.CreateInstance(type, parts.ToArray());
    }

    // The numbers of a look's uniform.
    static void Tell(
        string name, Dictionary<string, double[]> parameters, Dictionary<string, double[]> state)
    {
        Type type = Type.GetType("Chiaro." + name + "Look");
        Type work = Type.GetType("Chiaro." + name + "Work");
        object look = Activator.CreateInstance(type);
        foreach (var pair in parameters)
        {
            string wanted = Plain(pair.Key);
            FieldInfo field = type.GetFields().FirstOrDefault(
                it => Plain(it.Name) == wanted || Plain(it.Name) == wanted + "value");
            if (field == null) throw new Exception(name + " has no field for " + pair.Key);
            field.SetValue(look, Value(field.FieldType, pair.Value));
        }
        MethodInfo settingsIn = type.GetMethod("SettingsIn", Any);
        Type surroundings = settingsIn.GetParameters()[0].ParameterType;
        object around = Activator.CreateInstance(surroundings);
        foreach (FieldInfo field in surroundings.GetFields())
        {
            double[] given;
            if (!state.TryGetValue(field.Name, out given)) given = new[] { 1e6 };
            field.SetValue(around, given.Length == 9 ? Columns(field.FieldType, given)
                : given.Length > 1 ? Vector(field.FieldType, given) : (object)given[0]);
        }
        object settings = settingsIn.Invoke(look, new[] { around });
        MethodInfo keyed = work.GetMethod("Keyed", Any);
        if (keyed != null) settings = keyed.Invoke(null, new[] { settings, around });
        var numbers = (double[])type.GetField("numbers", Any).GetValue(look);
        work.GetMethod("DrawNumbers", Any).Invoke(null, new[] { settings, around, numbers });
        Console.WriteLine("[" + string.Join(",", numbers.Select(x => x.ToString("R"))) + "]");
    }

    static void Main()
    {
        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
"#;

/// The components of the package for Unity, of every example that one pass draws in the fast tier.
#[test]
#[ignore = "takes ten seconds; scripts/soak runs it"]
fn soak_components_compute_the_uniforms_of_every_example() {
    let scene = PackageScene {
        mesh: Arc::new(Mesh::default()),
        world_from_object: DMat4::IDENTITY,
        camera: Camera::default(),
        backdrop: None,
    };
    let never = |_| false;
    let cases = cases_in(Tier::Fast, never, |look, name, folder| {
        let place = (folder, &mut Assets::default());
        let library = Library::built_in();
        let package = package("unity").expect("a package");
        let found = export_package(look, library, name, package, &scene, place).ok()?.value;
        let component = found.into_iter().find(|file| file.name.ends_with("Look.cs"))?;
        String::from_utf8(component.bytes).ok()
    });
    assert!(cases.len() > 50, "{} looks have host work", cases.len());
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut program = COMPARISON.to_owned();
    let mut files = vec!["Comparison.cs".to_owned()];
    for case in &cases {
        let class = case.script.split_once("public sealed class ").expect("a class").1;
        let class = class.split_once("Look :").expect("a class").0;
        files.push(format!("{class}Look.cs"));
        std::fs::write(folder.path().join(files.last().expect("a file")), &case.script)
            .expect("a temporary file");
        for state in &case.states {
            let _ = writeln!(program, "        Tell(\"{class}\", {}", of_csharp(state));
        }
    }
    program += "    }\n}\n";
    std::fs::write(folder.path().join("Comparison.cs"), program).expect("a temporary file");
    let compiled = Command::new("mcs")
        .args(["-nologo", "-langversion:7.2", "-warn:0", "-out:comparison.exe"])
        .args(&files)
        .arg(root().join("tests/packages/unity/UnityEngine.cs"))
        .current_dir(folder.path())
        .output();
    let Ok(compiled) = compiled else {
        assert!(!tools_are_required(), "mcs is missing: run scripts/setup");
        say("SKIPPED: mcs is missing");
        return;
    };
    let said = String::from_utf8_lossy(&compiled.stderr);
    assert!(compiled.status.success(), "{}", &said[..said.len().min(4000)]);
    let output = Command::new("mono").arg(folder.path().join("comparison.exe")).output();
    let output = output.expect("mono starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}", &said[..said.len().min(4000)]);
    let lines = String::from_utf8_lossy(&output.stdout).into_owned();
    let lines: Vec<Vec<f64>> =
        lines.lines().map(|line| serde_json::from_str(line).expect("numbers")).collect();
    let results: Vec<_> = lines.chunks(STATES).map(<[_]>::to_vec).collect();
    compare_numbers(&cases, &results);
}

/// A state as two arguments in C#: parameters, and surroundings by their names there.
fn of_csharp(state: &Json) -> String {
    let list = |value: &Json| {
        let numbers: Vec<String> = match value {
            Json::Array(items) => items.iter().filter_map(Json::as_f64).collect(),
            other => vec![other.as_f64().unwrap_or_default()],
        }
        .iter()
        .map(|x| format!("{x:?}"))
        .collect();
        format!("new double[] {{ {} }}", numbers.join(", "))
    };
    let dictionary = |entries: &[(String, String)]| {
        let entries: Vec<String> =
            entries.iter().map(|(name, value)| format!("{{ \"{name}\", {value} }}")).collect();
        format!("new Dictionary<string, double[]> {{ {} }}", entries.join(", "))
    };
    let parameters: Vec<(String, String)> = state["parameters"]
        .as_object()
        .into_iter()
        .flatten()
        .map(|(name, value)| (name.clone(), list(value)))
        .collect();
    let camera = &state["camera"];
    let is_parallel = camera["parallel"] == json!(true);
    let parallel = if is_parallel { camera["toward"].clone() } else { json!([0.0, 0.0, 0.0]) };
    let around = [
        ("illumination", &state["illumination"]),
        ("cameraFromWorld", &camera["rotation"]),
        ("eye", &camera["eye"]),
        ("parallel", &parallel),
        ("objectAxes", &state["object"]["axes"]),
        ("objectMiddle", &state["object"]["middle"]),
        ("objectId", &state["object"]["id"]),
        ("viewport", &state["viewport"]),
        ("time", &state["time"]),
        ("frame", &state["frame"]),
    ];
    let around = around.map(|(name, value)| (name.to_owned(), list(value)));
    format!("{}, {});", dictionary(&parameters), dictionary(&around))
}

/// Compares numbers of 64 bits of all cases and states with the bytes of Chiaro's own uniforms.
fn compare_numbers(cases: &[Case], results: &[Vec<Vec<f64>>]) {
    let mut wrong = Vec::new();
    for (case, results) in cases.iter().zip(results) {
        for (state, (wanted, found)) in case.states.iter().zip(case.wanted.iter().zip(results)) {
            let words = wanted.chunks_exact(4);
            let words = words.map(|it| u32::from_le_bytes([it[0], it[1], it[2], it[3]]));
            let differs = |(wanted, found): (u32, &f64)| {
                let (a, b) = (f32::from_bits(wanted), *found as f32);
                let is_integer = found.fract() == 0.0 && wanted == *found as i64 as u32;
                !is_integer && (a - b).abs() > TOLERANCE * a.abs().max(1.0)
            };
            let first = words.zip(found).position(differs);
            if let Some(at) = first {
                let wanted = wanted[4 * at..4 * at + 4].try_into().map(f32::from_le_bytes);
                wrong.push(format!(
                    "{}: word {at} is {:?} and not {wanted:?}, in {state}",
                    case.name, found[at]
                ));
                break;
            }
        }
    }
    assert_eq!(results.len(), cases.len(), "looks that ran");
    assert!(wrong.is_empty(), "{} looks differ:\n{}", wrong.len(), wrong.join("\n"));
}

/// Runs a program that prints the words of the uniforms of all cases and states, and compares them
/// with Chiaro's own.
fn compare(cases: &[Case], command: &str, file: &str, program: &str) {
    assert!(cases.len() > 60, "{} looks have host work", cases.len());
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join(file);
    std::fs::write(&file, program).expect("a temporary file");
    let Ok(output) = Command::new(command).arg(&file).output() else {
        assert!(!tools_are_required(), "{command} is missing: run scripts/setup");
        say(&format!("SKIPPED: {command} is missing"));
        return;
    };
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}", &said[..said.len().min(4000)]);
    let results: Vec<Vec<Vec<u32>>> =
        serde_json::from_slice(&output.stdout).expect("lists of words");
    let mut wrong = Vec::new();
    assert_eq!(results.len(), cases.len(), "looks that ran");
    for (case, results) in cases.iter().zip(&results) {
        for (state, (wanted, found)) in case.states.iter().zip(case.wanted.iter().zip(results)) {
            let wanted: Vec<u32> = wanted
                .chunks_exact(4)
                .map(|bytes| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
                .collect();
            let differs = |(wanted, found): (&u32, &u32)| {
                let (a, b) = (f32::from_bits(*wanted), f32::from_bits(*found));
                wanted != found && (a - b).abs() > TOLERANCE * a.abs().max(1.0)
            };
            let first = wanted.iter().zip(found).position(differs);
            // Blocks may be filled up to 16 bytes.
            let is_whole = (wanted.len()..wanted.len() + 4).contains(&found.len());
            if !is_whole || first.is_some() {
                let at = first.unwrap_or(0);
                wrong.push(format!(
                    "{}: word {at} is {:?} and not {:?}, in {state}",
                    case.name,
                    found.get(at).map(|it| f32::from_bits(*it)),
                    wanted.get(at).map(|it| f32::from_bits(*it)),
                ));
                break;
            }
        }
    }
    assert!(wrong.is_empty(), "{} looks differ:\n{}", wrong.len(), wrong.join("\n"));
}
