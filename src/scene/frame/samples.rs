//! Surface samples for `chiaro eval`: each is an object of its own, with its view, its lights and
//! its camera.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use chiaro_locale::{text, tr};
use glam::{DMat3, DQuat, DVec2, DVec3};
use indexmap::IndexMap;

use super::assets::{Assets, Image};
use super::keys::{ParamTable, Rig, RigInputs, Wires, structural_look};
use super::plan::images;
use super::setup::SetupLook;
use super::values::{check_exposed_value, live_for_values};
use crate::compile::{
    CompileOptions, CompiledShader, HostInputs, LightValues, Stage, StructLayout, TypedGraph,
    Uniform, check, compile, push_numbers,
};
use crate::diag::Diagnostic;
use crate::document::{Light, LightKind, Look, Value, Values};
use crate::ids::{LightId, ObjectId};
use crate::library::{Context, Library, SurfacePoint};

/// Fields of a light that a sample sets; fields that it leaves out are the look's.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LightOverride {
    /// Direction toward the light, in the light's own frame; any length but 0.
    pub direction: Option<DVec3>,
    /// Position of the light, in the light's own frame.
    pub position: Option<DVec3>,
    /// Color, straight RGB.
    pub color: Option<DVec3>,
    /// Intensity, 0 or more.
    pub intensity: Option<f64>,
}

/// A point of a surface with everything that a look may ask of it. Vectors are in world space, of
/// any length.
#[derive(Clone, Debug, PartialEq)]
pub struct EvalSample {
    /// Normal of the surface.
    pub normal: DVec3,
    /// Tangent along u; `None` for any direction along the surface.
    pub tangent: Option<DVec3>,
    /// True if texture coordinates are mirrored here: v then goes the other way around the normal.
    pub is_mirrored: bool,
    /// Direction from the surface to the eye.
    pub view: DVec3,
    /// Position of the point, in world space.
    pub position: DVec3,
    /// Rotation from world space to camera axes: rows right, up and toward the viewer.
    pub camera: DMat3,
    /// Texture coordinates.
    pub uv: DVec2,
    /// Curvature in 1/viewport-height, convex positive.
    pub kappa: f64,
    /// Numbers of contexts that do not follow from the other fields, as the contexts' rows say; a
    /// row's default where none are given. A sample's picture is one pixel high.
    pub contexts: BTreeMap<Context, Vec<f64>>,
    /// Distance from the eye to the object, in scene units.
    pub distance: f64,
    /// Front of the object, its z axis, in world space.
    pub front: DVec3,
    /// Distances of other objects, by id, in scene units.
    pub near: IndexMap<ObjectId, f64>,
    /// Color of the vertices, straight RGBA.
    pub vertex_color: [f64; 4],
    /// Time, in seconds.
    pub time: f64,
    /// Rotation from the illumination frame to world space.
    pub frame: DQuat,
    /// Lights that the sample changes, by id.
    pub lights: IndexMap<LightId, LightOverride>,
    /// Values of exposed parameters.
    pub values: Values,
}

impl Default for EvalSample {
    fn default() -> Self {
        Self {
            normal: DVec3::Z,
            tangent: None,
            is_mirrored: false,
            view: DVec3::Z,
            position: DVec3::ZERO,
            camera: DMat3::IDENTITY,
            uv: DVec2::ZERO,
            kappa: 0.0,
            contexts: BTreeMap::new(),
            distance: 1.0,
            front: DVec3::Z,
            near: IndexMap::new(),
            vertex_color: [1.0; 4],
            time: 0.0,
            frame: DQuat::IDENTITY,
            lights: IndexMap::new(),
            values: Values::new(),
        }
    }
}

/// Samples that one module evaluates.
#[derive(Clone, Debug)]
pub struct EvalBatch {
    /// The module, of [`Stage::Eval`].
    pub shader: Arc<CompiledShader>,
    /// Indices of the samples in the list that they came from.
    pub indices: Vec<usize>,
    /// The storage buffer's content, one sample after the other.
    pub samples: Uniform,
    /// The images of the module's needs.
    pub images: Vec<Arc<Image>>,
}

/// A look compiled for the evaluation of samples, in any number of batches.
#[derive(Debug)]
pub struct Evaluable<'a> {
    setup: &'a SetupLook,
    /// The module, of [`Stage::Eval`].
    pub shader: Arc<CompiledShader>,
    /// The images of the module's needs.
    pub images: Vec<Arc<Image>>,
    rig: Rig,
    table: ParamTable,
}

impl<'a> Evaluable<'a> {
    /// Compiles a look for samples that set no values, at time 0.
    ///
    /// # Errors
    /// All errors of the look, and images that cannot be read.
    pub fn new(
        setup: &'a SetupLook,
        library: &Library,
        assets: &mut Assets,
    ) -> Result<Self, Vec<Diagnostic>> {
        let look = structural_look(&setup.look, library, 0.0, &Values::new());
        let shader = compile(
            &look,
            library,
            &CompileOptions { stage: Stage::Eval, ..CompileOptions::default() },
        );
        let shader = shader.map_err(|mut problems| {
            setup.source.locate_all(&mut problems);
            problems
        })?;
        Self::of(setup, &look, shader.value.into(), assets)
    }

    fn of(
        setup: &'a SetupLook,
        look: &Look,
        shader: Arc<CompiledShader>,
        assets: &mut Assets,
    ) -> Result<Self, Vec<Diagnostic>> {
        let images = images(assets, &shader, setup)?;
        let rig = Rig::new(look).value;
        let table = ParamTable::new(&shader.params);
        Ok(Self { setup, shader, images, rig, table })
    }

    /// Packs samples, of which there is at least one.
    ///
    /// # Errors
    /// Values that cannot be packed.
    pub fn pack<'s>(
        &self,
        samples: impl ExactSizeIterator<Item = &'s EvalSample>,
    ) -> Result<Uniform, Diagnostic> {
        let packer = Packer::new(&self.shader);
        let mut packed =
            Uniform { bytes: vec![0; packer.stride * samples.len()], numbers: Vec::new() };
        for (place, sample) in samples.enumerate() {
            let at = place * packer.stride;
            packer.pack(
                sample,
                &self.setup.look.lights,
                &self.rig,
                &self.table,
                at,
                &mut packed,
            )?;
        }
        Ok(packed)
    }
}

/// Packs samples for the GPU. Samples whose values change what is compiled (a choice's word) go
/// into batches of their own.
///
/// # Errors
/// All errors of the look, and values or lights that the look does not have.
pub fn eval_batches(
    setup: &SetupLook,
    library: &Library,
    samples: &[EvalSample],
    options: &CompileOptions,
    assets: &mut Assets,
) -> Result<Vec<EvalBatch>, Vec<Diagnostic>> {
    let located = |mut problems: Vec<Diagnostic>| {
        setup.source.locate_all(&mut problems);
        problems
    };
    let mut problems = check_samples(setup, samples);
    let any_set = samples.iter().any(|sample| !sample.values.is_empty());
    if problems.is_empty() && any_set {
        let typed = check(&setup.look, library, None).map_err(located)?.value;
        problems = check_values(&setup.look, &typed, samples);
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let mut batches = Vec::new();
    for indices in group(setup, library, samples).into_values() {
        let first = &samples[indices[0]];
        let look = structural_look(&setup.look, library, first.time, &first.values);
        let options = CompileOptions {
            stage: Stage::Eval,
            live: live_for_values(&options.live, any_set),
            ..options.clone()
        };
        let is_set = matches!(look, Cow::Owned(_));
        let shader = compile(&look, library, &options).map_err(|problems| {
            let told = |problem: Diagnostic| {
                problem.hint(tr!("this is with the values of sample [{index}]", index = indices[0]))
            };
            located(
                problems
                    .into_iter()
                    .map(|problem| if is_set { told(problem) } else { problem })
                    .collect(),
            )
        })?;
        let made = Evaluable::of(setup, &look, Arc::new(shader.value), assets)?;
        let packed = made
            .pack(indices.iter().map(|&index| &samples[index]))
            .map_err(|problem| vec![problem])?;
        batches.push(EvalBatch {
            shader: made.shader,
            indices,
            samples: packed,
            images: made.images,
        });
    }
    Ok(batches)
}

/// Indices of samples, grouped by the words that the samples set.
fn group(
    setup: &SetupLook,
    library: &Library,
    samples: &[EvalSample],
) -> IndexMap<String, Vec<usize>> {
    let has_words = setup
        .look
        .time_keys
        .iter()
        .any(|track| track.keys.iter().any(|k| matches!(k.value, Value::Text(_))));
    let mut groups: IndexMap<String, Vec<usize>> = IndexMap::new();
    for (index, sample) in samples.iter().enumerate() {
        let words = sample
            .values
            .iter()
            .filter(|(_, value)| matches!(value, Value::Text(_)) && value.color().is_none());
        let mut key: String = words.map(|(name, value)| format!("{name}={value:?};")).collect();
        if has_words {
            let now = structural_look(&setup.look, library, sample.time, &sample.values);
            key += &now.to_text();
        }
        groups.entry(key).or_default().push(index);
    }
    groups
}

fn check_samples(setup: &SetupLook, samples: &[EvalSample]) -> Vec<Diagnostic> {
    let mut problems = Vec::new();
    let exposed: Vec<&str> =
        setup.look.exposed.iter().map(|exposed| exposed.name.as_str()).collect();
    for (index, sample) in samples.iter().enumerate() {
        for name in sample.values.keys().filter(|name| !exposed.contains(&name.as_str())) {
            let problem = Diagnostic::error(
                "unknown-parameter",
                tr!("the look exposes no parameter `{name}`"),
            )
            .json_path(format!("[{index}].values.{name}"))
            .suggest(name.as_str(), exposed.iter().copied());
            problems.push(if exposed.is_empty() {
                problem.hint(
                    text!(
                        "expose it in the look: \
                     \"exposed\": [{\"name\": \"width\", \"target\": \"rim.cutoff\"}]"
                    )
                    .tr(),
                )
            } else {
                problem.hint(tr!("it exposes {names}", names = exposed.join(", ")))
            });
        }
        for id in sample.lights.keys().filter(|id| !setup.look.lights.contains_key(*id)) {
            let known: Vec<&str> = setup.look.lights.keys().map(AsRef::as_ref).collect();
            let hint = if known.is_empty() {
                tr!("it has none").to_owned()
            } else {
                tr!("its lights are {names}", names = known.join(", "))
            };
            problems.push(
                Diagnostic::error("unknown-light", tr!("the look has no light `{id}`"))
                    .json_path(format!("[{index}].lights.{id}"))
                    .suggest(id.as_str(), known.iter().copied())
                    .hint(hint),
            );
        }
    }
    problems
}

/// Errors for values that a parameter cannot have.
fn check_values(look: &Look, typed: &TypedGraph, samples: &[EvalSample]) -> Vec<Diagnostic> {
    let mut problems = Vec::new();
    for (index, sample) in samples.iter().enumerate() {
        for (name, value) in &sample.values {
            let problem = check_exposed_value(look, typed, name.as_str(), value);
            problems.extend(
                problem.map(|problem| problem.json_path(format!("[{index}].values.{name}"))),
            );
        }
    }
    problems
}

struct Packer<'a> {
    shader: &'a CompiledShader,
    surface: Option<(u32, StructLayout)>,
    look_at: u32,
    stride: usize,
}

impl<'a> Packer<'a> {
    fn new(shader: &'a CompiledShader) -> Self {
        let module = &shader.valid.module;
        let sample = StructLayout::of(module, "Sample").unwrap_or_default();
        let at = |name: &str| sample.member(name).map(|member| member.0);
        let surface = at("surface").zip(StructLayout::of(module, "Surface"));
        Self {
            shader,
            surface,
            look_at: at("look").unwrap_or(0),
            stride: sample.size.next_multiple_of(16) as usize,
        }
    }

    fn pack(
        &self,
        sample: &EvalSample,
        own_lights: &IndexMap<LightId, Light>,
        rig: &Rig,
        table: &ParamTable,
        at: usize,
        packed: &mut Uniform,
    ) -> Result<(), Diagnostic> {
        let surface = surface_point(sample);
        if let Some((offset, layout)) = &self.surface {
            for (name, member, layout) in &layout.members {
                let contexts = &self.shader.needs.contexts;
                let Some(context) = contexts.iter().find(|context| context.word() == name) else {
                    continue;
                };
                let at = at + (*offset + member) as usize;
                let given = sample.contexts.get(context).map(Vec::as_slice);
                let row = context.row();
                // A sample may say anything; looks get what shaders are promised.
                let value = row.bounds.kept_value(row.sample.value(*context, &surface, given));
                layout.write(&value, at, &mut packed.bytes);
                push_numbers(&value, &mut packed.numbers);
            }
        }
        let lights = sample_lights(sample, own_lights);
        let (scene_values, aims) = Default::default();
        let inputs = RigInputs {
            time: sample.time,
            illumination: sample.frame,
            camera_from_world: sample.camera,
            view: surface.view,
            center: sample.position,
            distance: sample.distance,
            front: sample.front,
            turn: DQuat::IDENTITY,
            near: &sample.near,
            exposed: &sample.values,
            lights: &lights,
            scene_values: &scene_values,
            aims: &aims,
            viewport: [1.0, 1.0],
            frame: (sample.time * 24.0).round(),
            object_id: 0.0,
        };
        let mut values =
            rig.evaluate(&self.shader.params, table, Wires::of(self.shader), &inputs)?;
        place_lights(sample, &mut values.lights);
        let host = HostInputs {
            params: &values.params,
            lights: &values.lights,
            camera_from_world: sample.camera,
            viewport: inputs.viewport,
            time: sample.time,
            frame: inputs.frame,
            object_id: inputs.object_id,
        };
        self.shader.host.write(&host, at + self.look_at as usize, packed)?;
        // The struct's padding.
        packed.numbers.extend([0.0; 4]);
        Ok(())
    }
}

/// The look's lights with the fields that the sample sets.
fn sample_lights(sample: &EvalSample, own: &IndexMap<LightId, Light>) -> IndexMap<LightId, Light> {
    let mut lights = IndexMap::new();
    for (id, set) in &sample.lights {
        let Some(mut light) = own.get(id).cloned() else { continue };
        if let Some(direction) = set.direction {
            light.direction = direction.to_array();
        }
        if let Some(position) = set.position {
            light.position = position.to_array();
        }
        if let Some(color) = set.color {
            light.color = color.to_array();
        }
        if let Some(intensity) = set.intensity {
            light.intensity = intensity;
        }
        lights.insert(id.clone(), light);
    }
    lights
}

/// Places lights of kinds that a sample's fields do not suit: a directional light that is given a
/// position shines from there; a point or spot light that is given a direction stands one unit away
/// in that direction.
fn place_lights(sample: &EvalSample, lights: &mut IndexMap<LightId, LightValues>) {
    for (id, set) in &sample.lights {
        let Some(light) = lights.get_mut(id) else { continue };
        match (light.kind, set.direction, set.position) {
            (LightKind::Directional, None, Some(_)) => {
                let toward = light.position() - sample.position;
                light.shine_from(toward.try_normalize().unwrap_or(DVec3::Z));
            }
            (LightKind::Point | LightKind::Spot, Some(_), None) => {
                let toward = light.direction();
                light.stand_at(sample.position + toward, -toward);
            }
            _ => {}
        }
    }
}

/// A sample's surface in unit vectors.
fn surface_point(sample: &EvalSample) -> SurfacePoint {
    let unit = |v: DVec3, otherwise: DVec3| {
        // Scaled first, so that neither tiny nor huge vectors underflow or overflow.
        let largest = v.abs().max_element();
        if largest > 0.0 && largest.is_finite() { (v / largest).normalize() } else { otherwise }
    };
    let normal = unit(sample.normal, DVec3::Z);
    let along = |t: DVec3| t - normal * normal.dot(t);
    let any = along(if normal.x.abs() < 0.9 { DVec3::X } else { DVec3::Y });
    let tangent = unit(sample.tangent.map_or(any, along), any.normalize());
    let bitangent = normal.cross(tangent);
    SurfacePoint {
        normal,
        tangent,
        bitangent: if sample.is_mirrored { -bitangent } else { bitangent },
        view: unit(sample.view, DVec3::Z),
        position: sample.position,
        camera: sample.camera,
        uv: sample.uv,
        vertex_color: sample.vertex_color,
        kappa: sample.kappa,
    }
}
