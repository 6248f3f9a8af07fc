//! Samples of nodes: a small look around one node, and its picture on a sphere or another shape.

use std::path::Path;

use glam::{DMat4, DQuat, DVec3};
use serde_json::Value as Json;

use crate::catalog::{Catalog, NodeKind, Port};
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::{Endpoint, Light, LightKind, LightSpace, Look, Node, Value, Values, Wire};
use crate::examples;
use crate::frame::{
    Assets, Executor, Picture, PlanOptions, Planner, SHAPE_PREFIX, SetupLook, SetupObject,
    default_setup,
};
use crate::library::{Fallback, Library, Type};
use crate::progress::Progress;

/// Table of samples that show more of a node than its defaults, by kind: values as in a look's
/// JSON, the source that `feed`s each input, the factor of the output (`times`), the own shape to
/// show the node on (`mesh`), the own shape that hangs before the light unseen (`caster`),
/// the place from which the lamp shines on the sphere (`lamp`); or `null` if nothing of the node
/// can be seen.
const VALUES: &str = crate::NODE_SAMPLES;
/// Direction toward the light of samples.
const KEY: [f64; 3] = [-0.5, 0.6, 0.62];
/// Place from which the lamp of samples shines on the sphere, for which the table names no other.
const LAMP: [f64; 3] = [-1.5, 1.5, 2.4];
/// Own shape of the samples for which the table names no other.
const MESH: &str = "sphere";
/// Id of the node itself in the sample's look.
const NODE: &str = "node";
/// File name of an image for nodes that ask for one, beside the look.
const IMAGE: &str = "sample.png";
/// File name of an HCBTF for nodes that ask for one, beside the look.
const HCBTF: &str = "sample.hcbtf";
const STRIPES: &str = "example:hcbtf/stripes.hcbtf";

/// Sample of a kind of node.
#[derive(Default)]
struct NodeSample {
    values: Values,
    /// Inputs, each with the name of its source.
    feed: Vec<(String, String)>,
    times: Option<f64>,
    mesh: String,
    caster: Option<String>,
    lamp: Option<[f64; 3]>,
}

/// A look that shows the first output of a node of `kind`; `None` if nothing of it can be seen.
fn look_of(kind: &NodeKind, catalog: &Catalog, showing: NodeSample) -> Option<Look> {
    if Library::built_in().nodes.get(&kind.id).is_some_and(|def| def.joins_lights()) {
        return joined_look(kind);
    }
    let mut build = Build { look: Look::default(), catalog };
    let lights = [("key", KEY), ("back", [0.8, -0.1, 0.2])];
    for (id, direction) in lights {
        build.look.lights.insert(id.into(), Light { direction, ..Light::default() });
    }
    let position = showing.lamp.unwrap_or(LAMP);
    let lamp = Light {
        kind: LightKind::Spot,
        position,
        aim: position.map(|x| -x),
        space: LightSpace::World,
        ..Light::default()
    };
    build.look.lights.insert("lamp".into(), lamp);
    build.add(NODE, &kind.id, showing.values);
    for (port, source) in &showing.feed {
        build.make(source);
        build.wire(source, NODE, port);
    }
    let is_chosen = !showing.feed.is_empty();
    for port in &kind.inputs {
        if build.is_fed(kind, port, is_chosen)
            && let Some(source) = source_of(kind, &port.ty)
        {
            build.make(source);
            build.wire(source, NODE, port.name.as_str());
        }
    }
    if kind.id == "output" {
        return Some(build.look);
    }
    let mut shown = match &kind.outputs.first()?.ty {
        Type::Light => build.lit(),
        // Angles are shown as grays: half a turn is white.
        Type::Angle => build.then("share", "divide", "a", &[("b", std::f64::consts::PI)], NODE),
        // Directions are shown as colors, with middle gray for 0.
        Type::Vec3 => {
            let half = build.then("half", "multiply", "a", &[("b", 0.5)], NODE);
            build.then("raised", "add", "a", &[("b", 0.5)], half)
        }
        ty if ty.convert_to(&Type::Composite).is_some() => NODE,
        _ => return None,
    };
    if let Some(times) = showing.times {
        shown = build.then("times", "multiply", "a", &[("b", times)], shown);
    }
    build.then("output", "output", "color", &[], shown);
    Some(build.look)
}

/// A look of three colored lights, joined by a node of `kind` in a group that runs for each.
fn joined_look(kind: &NodeKind) -> Option<Look> {
    let join = |port: &str| format!("join.{port}");
    let fed = kind.inputs.iter().map(|port| match (port.name.as_str(), &port.ty) {
        (name, Type::Light) => ("lamp", join(name)),
        (name @ ("value" | "color"), _) => ("lit", join(name)),
        (name, _) if name != "margin" => ("tone", join(name)),
        (_, _) => ("", String::new()),
    });
    let own = [
        ("lamp", "angle.light".to_owned()),
        ("angle", "tone.angle".to_owned()),
        ("lamp", "parts.light".to_owned()),
        ("parts.color", "lit.a".to_owned()),
        ("tone", "lit.b".to_owned()),
        ("join", "outputs.color".to_owned()),
    ];
    let wires: Vec<Json> = own
        .into_iter()
        .chain(fed.filter(|(from, _)| !from.is_empty()))
        .map(|(from, to)| serde_json::json!({ "from": from, "to": to }))
        .collect();
    let text = serde_json::json!({
        "lights": {
            "key": {"direction": [-0.7, 0.5, 0.5], "color": [0.95, 0.62, 0.3]},
            "fill": {"direction": [0.8, 0.3, 0.4], "color": [0.3, 0.55, 0.95]},
            "low": {"direction": [0.1, -0.9, 0.4], "color": [0.7, 0.25, 0.6]}},
        "definitions": {"lamps": {
            "outputs": [{"name": "color"}],
            "nodes": [{"id": "lamp", "kind": "light"}, {"id": "parts", "kind": "light_parts"},
                {"id": "angle", "kind": "parametrization"},
                {"id": "tone", "kind": "profile",
                    "values": {"offset": 0.5, "falloff": 0.8, "cutoff": 1.1}},
                {"id": "lit", "kind": "multiply"}, {"id": "join", "kind": kind.id}],
            "wires": wires}},
        "nodes": [{"id": NODE, "kind": "lamps", "for_each": "*"},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": NODE, "to": "output.color"}]
    });
    Look::read(&text.to_string(), "sample.json").value
}

impl NodeSample {
    /// The table's sample of a kind, with files and lights for inputs that name some.
    fn of(kind: &NodeKind) -> Option<Self> {
        let table: serde_json::Map<String, Json> = serde_json::from_str(VALUES).unwrap_or_default();
        let mut showing = Self { mesh: MESH.to_owned(), ..Self::default() };
        if let Some(own) = table.get(&kind.id) {
            let mut own = own.as_object()?.clone();
            if let Some(Json::Object(feed)) = own.remove("feed") {
                let pair =
                    |(port, source): (String, Json)| Some((port, source.as_str()?.to_owned()));
                showing.feed = feed.into_iter().filter_map(pair).collect();
            }
            if let Some(Json::String(mesh)) = own.remove("mesh") {
                showing.mesh = mesh;
            }
            if let Some(Json::String(caster)) = own.remove("caster") {
                showing.caster = Some(caster);
            }
            showing.lamp = own.remove("lamp").and_then(|place| serde_json::from_value(place).ok());
            showing.times = own.remove("times").and_then(|times| times.as_f64());
            // Values are read as a document's: its reader tells numbers, colors, curves and ramps
            // apart.
            let text = serde_json::json!({"nodes": [{"id": NODE, "kind": kind.id, "values": own}]})
                .to_string();
            let node = Look::read(&text, "samples.json")
                .value
                .and_then(|look| look.graph.nodes.get(NODE).cloned());
            showing.values = node.map(|node| node.values).unwrap_or_default();
        }
        for port in &kind.inputs {
            let text = match port.ty {
                Type::LightName => "key",
                Type::Image => IMAGE,
                Type::Hcbtf => HCBTF,
                _ => continue,
            };
            showing.values.entry(port.name.clone()).or_insert_with(|| Value::Text(text.to_owned()));
        }
        Some(showing)
    }
}

/// Name of the default source for an input of a type.
fn source_of(kind: &NodeKind, ty: &Type) -> Option<&'static str> {
    let is_plain = matches!(kind.category.as_str(), "math" | "vector");
    Some(match ty {
        Type::Light => "light",
        Type::Angle => "turn",
        Type::Composite => "base",
        Type::Color => "colors",
        Type::Vec3 | Type::Vec4 => "facing",
        Type::Vec2 => "uv",
        Type::Float if is_plain => "across",
        Type::Float => "tone",
        _ => return None,
    })
}

struct Build<'a> {
    look: Look,
    catalog: &'a Catalog,
}

impl Build<'_> {
    fn add(&mut self, id: &str, kind: &str, values: Values) {
        self.look
            .graph
            .nodes
            .insert(id.into(), Node { kind: kind.to_owned(), values, ..Node::default() });
    }

    fn wire(&mut self, from: &str, node: &str, port: &str) {
        let port = if port.is_empty() { self.first_input(node) } else { port.to_owned() };
        let output = self.look.graph.nodes.get(from).and_then(|node| self.catalog.of(node));
        let output = output
            .and_then(|kind| kind.outputs.first())
            .map(|port| port.name.clone())
            .unwrap_or_default();
        let from = Endpoint { node: from.into(), port: output };
        self.look
            .graph
            .wires
            .push(Wire { from, to: Endpoint { node: node.into(), port: port.as_str().into() } });
    }

    fn first_input(&self, node: &str) -> String {
        let kind = self.look.graph.nodes.get(node).and_then(|node| self.catalog.of(node));
        kind.and_then(|kind| kind.inputs.first())
            .map(|port| port.name.to_string())
            .unwrap_or_default()
    }

    /// True if an input gets a wire: each input that needs one, and the first input of a node that
    /// would look the same everywhere, unless the sample chose a source.
    fn is_fed(&self, kind: &NodeKind, port: &Port, is_chosen: bool) -> bool {
        let has_value = self
            .look
            .graph
            .nodes
            .get(NODE)
            .is_some_and(|node| node.values.contains_key(&port.name));
        let has_wire = self.look.graph.wire_into(&NODE.into(), &port.name).is_some();
        if !port.is_wirable() || has_value || has_wire {
            return false;
        }
        if matches!(port.fallback, Fallback::Wire) {
            return true;
        }
        let is_varying = kind
            .inputs
            .iter()
            .any(|port| matches!(port.fallback, Fallback::Context(_) | Fallback::Wire));
        let is_value = kind.category == "input" || kind.id == "base";
        let first = kind
            .inputs
            .iter()
            .find(|port| port.is_wirable() && source_of(kind, &port.ty).is_some());
        !is_chosen && !is_varying && !is_value && first.is_some_and(|first| first.name == port.name)
    }

    /// Adds a node with some numbers as values, whose input `port` is wired to `from`.
    fn then(
        &mut self,
        id: &'static str,
        kind: &str,
        port: &str,
        numbers: &[(&str, f64)],
        from: &str,
    ) -> &'static str {
        let values = numbers.iter().map(|(name, x)| ((*name).into(), Value::Number(*x)));
        self.add(id, kind, values.collect());
        self.wire(from, id, port);
        id
    }

    /// Adds nodes that show the light of the sample's node: a diffuse profile in the light's color.
    /// Returns the last of these nodes.
    fn lit(&mut self) -> &'static str {
        let turn = self.then("lit_turn", "parametrization", "light", &[], NODE);
        let soft = [("offset", 0.0), ("falloff", 1.6), ("cutoff", 1.6)];
        let tone = self.then("lit_tone", "profile", "angle", &soft, turn);
        let color = self.then("lit_color", "light_apply", "light", &[], NODE);
        let lit = self.then("lit", "multiply", "a", &[], color);
        self.wire(tone, lit, "b");
        lit
    }

    /// Adds a source and the nodes that it needs, once.
    fn make(&mut self, source: &str) {
        if self.look.graph.nodes.contains_key(source) {
            return;
        }
        let light = |id: &str| [("light".into(), Value::Text(id.to_owned()))].into();
        match source {
            "light" => self.add("light", "light", light("key")),
            "back" => self.add("back", "light", light("back")),
            "turn" => {
                self.make("light");
                self.then("turn", "parametrization", "light", &[], "light");
            }
            "tone" => {
                self.make("turn");
                let soft = [("offset", 0.0), ("falloff", 1.6), ("cutoff", 1.6)];
                self.then("tone", "profile", "angle", &soft, "turn");
            }
            "base" => self.add(
                "base",
                "base",
                [("color".into(), Value::Vector(vec![0.24, 0.14, 0.2, 1.0]))].into(),
            ),
            "facing" => self.add("facing", "camera_normal", Values::default()),
            "across" => {
                self.make("facing");
                self.then("across", "separate_vector", "", &[], "facing");
            }
            "uv" => self.add("uv", "uv", Values::default()),
            "normal" => self.add("normal", "normal", Values::default()),
            "noise" => self.add("noise", "noise", [("octaves".into(), Value::Number(3.0))].into()),
            // A normal map that leans with the noise.
            "bumps" => {
                self.make("noise");
                self.then(
                    "bumps",
                    "combine_color",
                    "red",
                    &[("green", 0.5), ("blue", 1.0)],
                    "noise",
                );
            }
            _ => {
                self.make("facing");
                let halved = self.then("halved", "multiply", "a", &[("b", 0.5)], "facing");
                self.then("colors", "add", "a", &[("b", 0.5)], halved);
            }
        }
    }
}

/// Draws the output of a node of a kind, on a transparent ground; `None` if nothing of it can be
/// seen. `folder` holds the image and the HCBTF that some nodes read ([`write_assets`]).
pub(super) async fn picture(
    kind: &NodeKind,
    catalog: &Catalog,
    library: &Library,
    executor: &mut dyn Executor,
    (folder, side): (&Path, u32),
) -> Result<Option<Picture>, Vec<Diagnostic>> {
    let Some(showing) = NodeSample::of(kind) else { return Ok(None) };
    let mesh = format!("{SHAPE_PREFIX}{}", showing.mesh);
    let caster = showing.caster.clone();
    let Some(look) = look_of(kind, catalog, showing) else { return Ok(None) };
    let mut assets = Assets::default();
    // The look was made in code, so it has no source text.
    let source = Look::read("{}", &kind.id).source.into();
    let look = SetupLook { look, source, folder: folder.to_path_buf() };
    let mut setup = default_setup(look, &mesh, &mut assets)?.value;
    if let Some(caster) = caster {
        let toward = DVec3::from(KEY).normalize();
        setup.objects.push(SetupObject {
            id: "caster".into(),
            mesh: assets.mesh(folder, &format!("{SHAPE_PREFIX}{caster}"))?.value,
            world_from_object: DMat4::from_scale_rotation_translation(
                DVec3::splat(0.62),
                DQuat::from_rotation_arc(DVec3::Z, toward),
                2.8 * toward,
            ),
            ..setup.objects[0].clone()
        });
    }
    setup.scene.backdrop = None;
    if mesh.ends_with(MESH) {
        // The sphere fills its picture.
        setup.scene.camera.eye = [0.0, 0.0, 4.2];
        setup.scene.camera.target = [0.0; 3];
    }
    let options = PlanOptions { size: [side, side], samples: 4, time: 0.4 };
    let plan = Planner::new(assets).plan(&setup, library, &Live::Keyed, &options)?.value;
    let picture = executor.picture(&plan, &Progress::new()).await;
    Ok(Some(picture.map_err(|problem| vec![problem])?))
}

/// Writes the image and the HCBTF that samples read.
pub(super) fn write_assets(folder: &Path) -> Result<(), Diagnostic> {
    let write = |name: &str, bytes: &[u8]| {
        crate::files::write_atomic(&folder.join(name), bytes).map_err(|problem| *problem)
    };
    write(HCBTF, examples::file(Path::new(STRIPES)).unwrap_or_default())?;
    // The image is warm above and cool below, and lighter to the right, so that its orientation can
    // be seen.
    const SIDE: u32 = 64;
    let pixel = |index: u32| {
        let (x, y) = ((index % SIDE) as f32 / SIDE as f32, (index / SIDE) as f32 / SIDE as f32);
        let is_dark = (x * 8.0).floor() as i32 % 2 == (y * 8.0).floor() as i32 % 2;
        let light = if is_dark { 0.55 } else { 0.85 } + 0.15 * x;
        [light, light * (0.75 - 0.2 * y), light * (0.35 + 0.5 * y), 1.0]
    };
    let picture = Picture { size: [SIDE, SIDE], rgba: (0..SIDE * SIDE).map(pixel).collect() };
    write(IMAGE, &picture.to_png()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fields of the table that are no inputs.
    const OWN_FIELDS: [&str; 5] = ["feed", "times", "mesh", "caster", "lamp"];

    #[test]
    fn samples_are_of_ports_that_there_are() {
        let catalog = Catalog::new(Library::built_in());
        let table: serde_json::Map<String, Json> = serde_json::from_str(VALUES).unwrap();
        for (kind, values) in &table {
            let known = catalog.get(kind).unwrap_or_else(|| panic!("there is no kind `{kind}`"));
            let Some(values) = values.as_object() else { continue };
            let fed = values
                .get("feed")
                .and_then(Json::as_object)
                .into_iter()
                .flat_map(|feed| feed.keys());
            for port in values.keys().filter(|name| !OWN_FIELDS.contains(&name.as_str())).chain(fed)
            {
                assert!(known.input(port).is_some(), "{kind} has no input `{port}`");
            }
        }
    }

    #[test]
    fn every_sample_is_a_good_look() {
        let library = Library::built_in();
        let catalog = Catalog::new(library);
        let mut unseen = Vec::new();
        for kind in catalog.all().filter(|kind| kind.id != crate::catalog::CUSTOM_KIND) {
            match NodeSample::of(kind).and_then(|showing| look_of(kind, &catalog, showing)) {
                None => unseen.push(kind.id.clone()),
                Some(look) => {
                    let compiled = crate::compile::compile(&look, library, &Default::default());
                    assert!(compiled.is_ok(), "{}: {:?}", kind.id, compiled.err());
                }
            }
        }
        let told = |kind: &String| {
            serde_json::from_str::<serde_json::Map<_, Json>>(VALUES).unwrap()[kind].is_null()
        };
        assert!(unseen.iter().all(told), "nothing is seen of {unseen:?}");
    }
}
