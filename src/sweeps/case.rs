//! Cases of a node: its choices, its width, its tier, and the place where `prepare` runs.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value as Json, json};

use super::slot::{InputSlot, SlotKind, SlotTarget};
use crate::diag::Diagnostic;
use crate::document::{
    Directions, Grid, Hcbtf, LightField, LightKind, LightQuantity, Look, Tier, Tile,
};
use crate::files::write_atomic;
use crate::frame::SetupLook;
use crate::hcbtf;
use crate::library::{
    ArgumentSource, Context, ContextSample, Fallback, Input, Library, NodeDef, SurfacePart,
    Treatment, Type,
};

/// The largest number that f32 holds.
const MOST: f64 = f32::MAX as f64;
/// Largest coordinate of a place on the surface: far enough, and its depth stays a number.
const MOST_PLACE: f64 = 1e30;
/// Largest number of colors and composites. Layers and their colors are no math nodes: a result
/// beyond f32's range, as a product of many, is cleared by the Output.
const MOST_COLOR: f64 = 1e6;
/// Largest coordinate of a light's position: documents place lights no farther away.
const MOST_LIGHT: f64 = 1e6;

/// One way of using a node, as `tests/worst` stores it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Case {
    /// The kind of node.
    pub node: String,
    /// Words of the node's choices, by input; also the kind of light and the interpolation of a
    /// curve, which are no choices.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub choices: BTreeMap<String, String>,
    /// Wider type that the node is fed with, such as `vec3`; empty for its own type.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub width: String,
    /// Tier of the node.
    pub tier: Tier,
    /// True if `prepare` runs in the fragment stage, as for a node whose prepared inputs are wired.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub prepared_in_fragment: bool,
}

impl Case {
    /// Name of the case for people: `rounding floor, vec3, exact`.
    pub fn name(&self) -> String {
        let mut name = self.node.clone();
        for word in self.choices.values() {
            name += &format!(" {word}");
        }
        if !self.width.is_empty() {
            name += &format!(", {}", self.width);
        }
        if self.prepared_in_fragment {
            name += ", prepared in the fragment";
        }
        name
    }

    /// Word of the choice `port`; empty if the case has no such choice.
    pub fn choice(&self, port: &str) -> &str {
        self.choices.get(port).map_or("", String::as_str)
    }

    /// Every case of a node.
    pub fn of(def: &NodeDef) -> Vec<Self> {
        let mut cases = Vec::new();
        for choices in choices(def) {
            for width in widths(def) {
                for tier in def.tiers() {
                    for prepared_in_fragment in [false, true] {
                        if prepared_in_fragment && def.prepare.is_none() {
                            continue;
                        }
                        let (node, choices, width) =
                            (def.kind.clone(), choices.clone(), width.clone());
                        cases.push(Self { node, choices, width, tier, prepared_in_fragment });
                    }
                }
            }
        }
        cases
    }
}

/// Every combination of a node's choices.
fn choices(def: &NodeDef) -> Vec<BTreeMap<String, String>> {
    let words = |input: &Input| match input.ty {
        Type::LightName => LightKind::ALL.iter().map(|kind| kind.word().to_owned()).collect(),
        Type::Curve | Type::Ramp => ["linear", "smooth", "stepped"].map(str::to_owned).to_vec(),
        _ => input.options.iter().map(|(word, _)| word.clone()).collect(),
    };
    let mut all = vec![BTreeMap::new()];
    for input in def.visible_inputs() {
        let words = words(input);
        if words.is_empty() {
            continue;
        }
        let with = |map: &BTreeMap<String, String>, word: &String| {
            let mut map = map.clone();
            map.insert(input.name.to_string(), word.clone());
            map
        };
        all = all
            .iter()
            .flat_map(|map| words.iter().map(|word| with(map, word)).collect::<Vec<_>>())
            .collect();
    }
    all
}

/// The node's own width, as an empty word, then the wider types that it has functions for.
fn widths(def: &NodeDef) -> Vec<String> {
    let mut widths = vec![String::new()];
    for width in def.variants.iter().filter_map(|variant| variant.width.as_ref()) {
        let word = width.to_string();
        if !widths.contains(&word) {
            widths.push(word);
        }
    }
    widths
}

/// An output of a bench that is compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// Node and output, as `node.output`; `None` for the output of the look.
    pub output: Option<(String, String)>,
}

/// A look with the node alone, every number of it fed from a slot.
#[derive(Clone, Debug)]
pub struct NodeBench {
    /// Case that is measured.
    pub case: Case,
    /// Inputs of the node.
    pub slots: Vec<InputSlot>,
    /// The look, in the case's tier.
    pub look: SetupLook,
    /// The look, in the exact tier.
    pub exact: SetupLook,
    /// Outputs that are compared.
    pub roots: Vec<Root>,
}

/// The library with feeder nodes added: they pass a value on at each fragment, so that the compiler
/// knows nothing of it before.
pub(super) fn feeders(library: &Library) -> Library {
    let mut library = library.clone();
    let plain = [
        ("float", "f32", "0"),
        ("int", "i32", "0"),
        ("bool", "bool", "false"),
        ("vec2", "vec2f", "0,0"),
    ];
    let wide =
        [("vec3", "vec3f", "0,0,0"), ("vec4", "vec4f", "0,0,0,0"), ("color", "Color", "0,0,0,1")];
    for (name, ty, default) in plain.into_iter().chain(wide) {
        let other = match name {
            "bool" => "!value",
            "int" => "value + 1",
            _ => "value + 1.0",
        };
        let body = format!("return select(value, {other}, depth > 1e35);");
        add_feeder(
            &mut library,
            name,
            &format!("@param value \"Value\" default={default} : Any."),
            &format!("value: {ty}"),
            ty,
            &body,
        );
    }
    let body = "return select(value, value + 1.0, depth > 1e35);";
    add_feeder(
        &mut library,
        "composite",
        "@param value \"Value\" default=0,0,0,1 : Any.",
        "value: Color",
        "Composite",
        body,
    );
    let body = "return Angle(value.x, value.y + select(0.0, 1.0, depth > 1e35));";
    add_feeder(
        &mut library,
        "angle",
        "@param value \"Value\" default=0,1 : Sine and cosine.",
        "value: vec2f",
        "Angle",
        body,
    );
    let docs = "@param direction \"Direction\" default=0,0,1 : Unit.\n/// @param \
                own_direction \"Own\" default=0,0,1 : Unit.\n\
                /// @param color \"Color\" default=1,1,1 : RGB.\n/// @param \
                intensity \"Intensity\" default=1 : 0 or more.";
    let parameters = "direction: vec3f, own_direction: vec3f, color: vec3f, intensity: f32";
    let body = "return Light(direction, own_direction, color, intensity + select(0.0, 1.0, depth > \
                1e35));";
    add_feeder(&mut library, "light", docs, parameters, "Light", body);
    library
}

fn add_feeder(
    library: &mut Library,
    name: &str,
    docs: &str,
    parameters: &str,
    ty: &str,
    body: &str,
) {
    let code = format!(
        "import chiaro::types;\n\n/// Feed\n///\n/// Not known before the fragment.\n///\n/// \
         {docs}\n\
         /// @param depth from=depth hidden\n/// @return value \"Value\" : The same.\n\
         fn sweep_{name}({parameters}, depth: f32) -> {ty} {{\n    {body}\n}}\n"
    );
    library.add_file(&format!("nodes/sweep/sweep_{name}.wgsl"), &code);
}

fn feeder_of(ty: &Type) -> Option<&'static str> {
    Some(match ty {
        Type::Float => "sweep_float",
        Type::Int => "sweep_int",
        Type::Bool => "sweep_bool",
        Type::Vec2 => "sweep_vec2",
        Type::Vec3 => "sweep_vec3",
        Type::Vec4 => "sweep_vec4",
        Type::Color => "sweep_color",
        Type::Composite => "sweep_composite",
        Type::Angle => "sweep_angle",
        Type::Light => "sweep_light",
        _ => return None,
    })
}

/// True for the name of an input of which only the direction counts, not the length.
fn is_direction(name: &str) -> bool {
    let words =
        ["normal", "axis", "onto", "direction", "middle", "up", "x_axis", "y_axis", "tangent"];
    words.contains(&name) || name.starts_with("smooth_")
}

/// Builder of a bench's look from its parts.
struct Builder<'a> {
    def: &'a NodeDef,
    case: &'a Case,
    slots: Vec<InputSlot>,
    nodes: Vec<Json>,
    wires: Vec<Json>,
    exposed: Vec<Json>,
    values: Map<String, Json>,
}

impl NodeBench {
    /// The bench of a case; images come from `folder`.
    ///
    /// # Errors
    /// A case that the library does not have, or no longer has.
    pub fn new(case: &Case, library: &Library, folder: &Path) -> Result<Self, Vec<Diagnostic>> {
        let unknown = |what: &str| {
            vec![Diagnostic::error("unknown-kind", format!("there is no {what} to measure"))]
        };
        let Some(def) = library.nodes.get(&case.node) else {
            return Err(unknown(&format!("node `{}`", case.node)));
        };
        if !Case::of(def).contains(case) {
            return Err(unknown(&format!("case `{}` ({:?})", case.name(), case.tier)));
        }
        let mut builder = Builder {
            def,
            case,
            slots: Vec::new(),
            nodes: Vec::new(),
            wires: Vec::new(),
            exposed: Vec::new(),
            values: Map::new(),
        };
        builder.inputs();
        builder.surroundings();
        let roots = builder.roots();
        let look = |tier: Tier| builder.look(tier, folder);
        Ok(Self {
            case: case.clone(),
            look: look(case.tier)?,
            exact: look(Tier::Exact)?,
            slots: builder.slots.clone(),
            roots,
        })
    }
}

impl Builder<'_> {
    /// The types of the inputs in the case's width.
    fn types(&self) -> Vec<Type> {
        let mut types: Vec<Type> = self.def.inputs.iter().map(|input| input.ty.clone()).collect();
        let is_it =
            |ty: &Option<Type>| ty.as_ref().is_some_and(|ty| ty.to_string() == self.case.width);
        if let Some(variant) = self.def.variants.iter().find(|variant| is_it(&variant.width)) {
            for parameter in &variant.parameters {
                if let ArgumentSource::Input(index, ty) = parameter {
                    types[*index] = ty.clone();
                }
            }
        }
        types
    }

    fn inputs(&mut self) {
        let prepared: Vec<usize> = self
            .def
            .prepare
            .iter()
            .flat_map(|prepare| prepare.parameters.iter().map(|(index, _)| *index))
            .collect();
        for (index, ty) in self.types().into_iter().enumerate() {
            let input = &self.def.inputs[index];
            let name = input.name.to_string();
            // Inputs of the Output other than the color belong to other passes.
            let is_other = self.def.special == Treatment::Output && name != "color";
            if input.hidden || is_other || input.fallback == Fallback::Context(Context::KAPPA) {
                continue;
            }
            if let Some(word) = self.case.choices.get(&name) {
                self.setting(input, word);
            } else if ty.is_texture() {
                self.values.insert(name, json!(if ty == Type::Hcbtf { PAINTING } else { PICTURE }));
            } else if prepared.contains(&index) {
                self.exposed.push(json!({"name": name, "target": format!("node.{name}")}));
                self.slots.push(value_slot(input, &ty, &name, self.most()));
            } else if ty == Type::Light {
                self.feed_light(&name);
            } else if let Some(feeder) = feeder_of(&ty) {
                let id = format!("feed_{name}");
                self.nodes.push(json!({"id": id, "kind": feeder}));
                self.wires.push(json!({"from": id, "to": format!("node.{name}")}));
                self.exposed.push(json!({"name": name, "target": format!("{id}.value")}));
                self.slots.push(value_slot(input, &ty, &name, self.most()));
            }
        }
    }

    fn most(&self) -> f64 {
        if matches!(self.def.category.as_str(), "curvature" | "layer")
            || self.def.kind == "light_apply"
        {
            MOST_COLOR
        } else {
            MOST
        }
    }

    fn setting(&mut self, input: &Input, word: &str) {
        let points = [[-1.0, 0.5], [0.0, 0.0], [0.5, 2.0], [2.0, 2.0], [3.0, -1.0]];
        let value = match input.ty {
            Type::LightName => {
                self.light_slots(word);
                json!("key")
            }
            Type::Curve => json!({"points": points, "interpolation": word}),
            Type::Ramp => {
                let stop = |[x, y]: [f64; 2]| json!({"at": x, "color": [y, 0.1 * x, 0.3, 0.2 * y]});
                json!({"stops": points.map(stop), "interpolation": word})
            }
            _ => json!(word),
        };
        self.values.insert(input.name.to_string(), value);
    }

    fn light_slots(&mut self, word: &str) {
        let number = |min, max| SlotKind::Number { min, max, is_angle: false };
        match word {
            "directional" => {
                self.slot(
                    "light_direction",
                    SlotTarget::LightDirection,
                    SlotKind::Direction,
                    3,
                    MOST_LIGHT,
                );
            }
            _ => {
                self.slot(
                    "light_position",
                    SlotTarget::LightPosition,
                    number(None, None),
                    3,
                    MOST_LIGHT,
                );
            }
        }
        self.slot(
            "light_color",
            SlotTarget::LightColor,
            number(Some(0.0), Some(1.0)),
            3,
            MOST_COLOR,
        );
        self.slot(
            "light_intensity",
            SlotTarget::LightIntensity,
            number(Some(0.0), Some(4.0)),
            1,
            MOST_COLOR,
        );
    }

    fn feed_light(&mut self, name: &str) {
        let number = |min, max| SlotKind::Number { min, max, is_angle: false };
        let parts = [
            ("direction", SlotKind::Unit, 3),
            ("own_direction", SlotKind::Unit, 3),
            ("color", number(Some(0.0), Some(1.0)), 3),
            ("intensity", number(Some(0.0), Some(4.0)), 1),
        ];
        let id = format!("feed_{name}");
        self.nodes.push(json!({"id": id, "kind": "sweep_light"}));
        self.wires.push(json!({"from": id, "to": format!("node.{name}")}));
        for (part, kind, width) in parts {
            let exposed = format!("{name}_{part}");
            self.exposed.push(json!({"name": exposed, "target": format!("{id}.{part}")}));
            self.slot(&exposed, SlotTarget::Value, kind, width, MOST_COLOR);
        }
    }

    fn slot(&mut self, name: &str, place: SlotTarget, kind: SlotKind, width: usize, most: f64) {
        if self.slots.iter().all(|slot| {
            slot.place == SlotTarget::Value && place == SlotTarget::Value || slot.place != place
        }) {
            self.slots.push(InputSlot { name: name.to_owned(), place, kind, width, most });
        }
    }

    /// Adds slots for the contexts that the node reads.
    fn surroundings(&mut self) {
        let is_fed =
            |input: &Input| !input.hidden && input.fallback != Fallback::Context(Context::KAPPA);
        let contexts: Vec<Context> =
            self.def.inputs.iter().filter(|input| !is_fed(input)).filter_map(context_of).collect();
        for context in contexts {
            let sample = context.row().sample;
            for &part in sample.parts() {
                self.part(part);
            }
            if let ContextSample::Own { default, range: (min, max) } = sample {
                let kind = SlotKind::Number { min, max, is_angle: false };
                let place = SlotTarget::Context(context);
                self.slot(context.word(), place, kind, default.len(), MOST_PLACE);
            }
        }
    }

    /// Adds a slot for a part of the surface.
    fn part(&mut self, part: SurfacePart) {
        let number = SlotKind::Number { min: None, max: None, is_angle: false };
        let clock = SlotKind::Number { min: Some(0.0), max: Some(100.0), is_angle: false };
        let (name, kind, width, most) = match part {
            SurfacePart::Normal => ("surface_normal", SlotKind::Unit, 3, 1.0),
            SurfacePart::Tangent => ("surface_tangent", SlotKind::Unit, 3, 1.0),
            SurfacePart::View => ("view", SlotKind::Unit, 3, 1.0),
            SurfacePart::Position => ("surface_position", number, 3, MOST_PLACE),
            SurfacePart::Camera => ("camera", SlotKind::Rotation, 4, 1.0),
            SurfacePart::Uv => ("uv", number, 2, MOST),
            SurfacePart::VertexColor => ("vertex_color", SlotKind::Color, 4, MOST_COLOR),
            SurfacePart::Kappa => ("kappa", SlotKind::Kappa, 1, MOST),
            SurfacePart::Time => ("time", clock, 1, MOST_LIGHT),
        };
        self.slot(name, SlotTarget::Part(part), kind, width, most);
    }

    fn roots(&mut self) -> Vec<Root> {
        match self.def.special {
            Treatment::Output => return vec![Root { output: None }],
            Treatment::Light if self.def.outputs[0].ty == Type::Light => {
                self.nodes.push(json!({"id": "parts", "kind": "light_parts"}));
                self.wires.push(json!({"from": "node", "to": "parts.light"}));
                let root =
                    |port: &str| Root { output: Some(("parts".to_owned(), port.to_owned())) };
                return ["direction", "color", "intensity"].map(root).to_vec();
            }
            _ => {}
        }
        let root = |name: String| Root { output: Some(("node".to_owned(), name)) };
        self.def.outputs.iter().map(|output| root(output.name.to_string())).collect()
    }

    fn look(&self, tier: Tier, folder: &Path) -> Result<SetupLook, Vec<Diagnostic>> {
        let mut nodes = self.nodes.clone();
        let node =
            json!({"id": "node", "kind": self.def.kind, "values": self.values, "tier": tier});
        nodes.push(node);
        if self.def.special != Treatment::Output {
            nodes.push(json!({"id": "shown", "kind": "color_value"}));
            nodes.push(json!({"id": "output", "kind": "output"}));
        }
        let mut wires = self.wires.clone();
        if self.def.special != Treatment::Output {
            wires.push(json!({"from": "shown", "to": "output.color"}));
        }
        let light = self.light();
        let json = json!({
            "chiaro": "look", "version": 1, "name": self.case.name(),
            "lights": {"key": light}, "nodes": nodes, "wires": wires, "exposed": self.exposed
        });
        let loaded = Look::read(&json.to_string(), "sweep.json");
        let source = loaded.source.into();
        let look = loaded
            .value
            .filter(|_| !crate::diag::has_errors(&loaded.diagnostics))
            .ok_or(loaded.diagnostics)?;
        Ok(SetupLook { look, source, folder: PathBuf::from(folder) })
    }

    /// The light of the look. Samples set its direction, position, color and intensity; every other
    /// number is such that the light shows it.
    fn light(&self) -> serde_json::Value {
        let mut light = json!({"type": self.light_word(), "space": "world"});
        let mut angles = [0.35, 0.9].iter().cycle();
        let mut distances = [1.5, 40.0].iter().cycle();
        for field in LightField::ALL {
            let number = match field.quantity() {
                LightQuantity::Angle => angles.next(),
                LightQuantity::Distance => distances.next(),
                LightQuantity::Factor if field != LightField::Intensity => Some(&0.75),
                _ => None,
            };
            if let Some(number) = number {
                light[field.name()] = json!(number);
            }
        }
        light
    }

    fn light_word(&self) -> &str {
        let word = self.case.choices.get("light").filter(|_| self.def.has_light_types());
        word.map_or("directional", String::as_str)
    }
}

fn context_of(input: &Input) -> Option<Context> {
    match input.fallback {
        Fallback::Context(context) => Some(context),
        _ => None,
    }
}

fn value_slot(input: &Input, ty: &Type, name: &str, most: f64) -> InputSlot {
    let is_angle = input.unit == "rad";
    let (kind, width) = match ty {
        Type::Int => {
            (SlotKind::Whole { min: input.min.unwrap_or(-20.0), max: input.max.unwrap_or(20.0) }, 1)
        }
        Type::Bool => (SlotKind::Switch, 1),
        Type::Color => (SlotKind::Color, 4),
        Type::Composite => (SlotKind::Composite, 4),
        Type::Angle => (SlotKind::HalfAngle, 2),
        Type::Vec3 if is_direction(name) => (SlotKind::Direction, 3),
        Type::Vec3 if name == "stretch" => (SlotKind::Stretch, 3),
        _ => {
            (SlotKind::Number { min: input.min, max: input.max, is_angle }, ty.width().unwrap_or(1))
        }
    };
    InputSlot { name: name.to_owned(), place: SlotTarget::Value, kind, width, most }
}

/// File name of the picture that image nodes are given.
const PICTURE: &str = "sweep.png";

/// File name of the painting that HCBTF nodes are given.
const PAINTING: &str = "sweep.hcbtf";

/// Writes the picture of image nodes and the painting of HCBTF nodes.
///
/// # Errors
/// Errors of the file system.
pub(super) fn write_textures(folder: &Path) -> Result<(), Vec<Diagnostic>> {
    write_picture(folder)?;
    write_painting(folder)
}

/// Writes a painting of few directions and texels, whose colors change evenly with all six
/// coordinates. The painting is opaque, because the errors that cheaper tiers state are for opaque
/// paint.
fn write_painting(folder: &Path) -> Result<(), Vec<Diagnostic>> {
    let directions = Directions { theta: 3, phi: 4 };
    let grid = Grid { size: [5, 3], light: directions, view: directions };
    let mut painting = Hcbtf::new(grid);
    for address in grid.addresses() {
        let [light, view] = [grid.light.vector(address.light), grid.view.vector(address.view)];
        let texel = |index: u32| {
            let [x, y] = [index % grid.size[0], index / grid.size[0]].map(f64::from);
            let channels = [
                0.5 + 0.3 * light.x + 0.04 * x,
                0.4 + 0.3 * view.y + 0.1 * y,
                0.2 + 0.5 * light.z * view.z,
            ];
            let [r, g, b] = channels.map(|channel| (255.0 * channel) as u8);
            [r, g, b, 255]
        };
        let texels = (0..grid.texels() as u32).flat_map(texel).collect();
        let tile = Tile::new(grid.size, texels).unwrap_or_else(|| Tile::filled(grid.size, [0; 4]));
        painting.painted.insert(address, Arc::new(tile));
    }
    let bytes = hcbtf::write(&painting).map_err(|problem| vec![*problem])?;
    write_atomic(&folder.join(PAINTING), &bytes).map_err(|problem| vec![*problem])
}

/// Writes the picture that image nodes are given: 9 x 9 texels, each of its own color and alpha.
/// The middle of the picture is the middle of a texel, so that straight ahead is no edge.
fn write_picture(folder: &Path) -> Result<(), Vec<Diagnostic>> {
    let texel = |x: u32, y: u32| {
        image::Rgba([(28 * x) as u8, (28 * y) as u8, (14 * (x + y)) as u8, (255 - 16 * x) as u8])
    };
    let told = |error: image::ImageError| {
        vec![Diagnostic::error(
            "write-failed",
            format!("the sweep's picture cannot be written: {error}"),
        )]
    };
    image::RgbaImage::from_fn(9, 9, texel).save(folder.join(PICTURE)).map_err(told)
}
