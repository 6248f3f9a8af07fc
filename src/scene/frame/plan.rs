//! The frame plan: what a renderer executes.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;
use std::sync::Arc;

use glam::{DQuat, DVec3};
use indexmap::IndexMap;

use super::assets::{Assets, Image, plain_hcbtf};
use super::camera::{View, object_uniform};
use super::cost::{self, EffectCost};
use super::effects::EffectKind;
use super::keys::{Moment, ParamTable, Rig, Wires, structural_look};
use super::nearest::nearest_surface;
use super::setup::{Setup, SetupLook, SetupObject};
use super::uvs::{self, Lack};
use super::values::live_for_values;
use super::visibility::{Cull, KnownBounds, Placed, dark_lights, fields, hidden};
use crate::compile::{
    CompiledShader, HostInputs, ImageShape, Live, Options, Param, Proof, Stage, Uniform, compile,
};
use crate::diag::Diagnostic;
use crate::document::{Driver, Graph, KeyDirection, Light, Look, Value};
use crate::geometry::Mesh;
use crate::hcbtf::LayerOptions;
use crate::ids::{LightId, NodePath, ObjectId};
use crate::library::{Context, Library, LightField, SMOOTH_LEVELS};

/// What a picture is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanOptions {
    /// Pixels.
    pub size: [u32; 2],
    /// Samples a pixel: 1 or 4.
    pub samples: u32,
    /// Seconds.
    pub time: f64,
}

/// GPU work in order.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum PassKind {
    /// Normals, object numbers and depth of every object.
    Normals,
    /// The same with the looks' detail normals.
    DetailNormals,
    /// Curvature of the normals.
    Curvature,
    /// The same from four neighbours of a pixel.
    SparseCurvature,
    /// Curvature of the detail normals.
    DetailCurvature,
    /// The same from four neighbours of a pixel.
    SparseDetailCurvature,
    /// Curvature of the normals by direction.
    CurvatureTensor,
    /// The normals smoothed, from level 1 on; each level reads the one before it.
    SmoothNormals(u8),
    /// The looks themselves.
    Look,
}

impl serde::Serialize for PassKind {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.label().replace(' ', "-"))
    }
}

impl PassKind {
    /// What people read.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Normals => "normals",
            Self::DetailNormals => "detail normals",
            Self::Curvature => "curvature",
            Self::SparseCurvature => "sparse curvature",
            Self::DetailCurvature => "detail curvature",
            Self::SparseDetailCurvature => "sparse detail curvature",
            Self::CurvatureTensor => "curvature tensor",
            Self::SmoothNormals(1) => "smooth normals 1",
            Self::SmoothNormals(2) => "smooth normals 2",
            Self::SmoothNormals(3) => "smooth normals 3",
            Self::SmoothNormals(_) => "smooth normals 4",
            Self::Look => "look",
        }
    }

    /// The file of `shaders/passes/` that it runs, without its ending; none where it draws meshes.
    pub fn shader(&self) -> Option<&'static str> {
        match self {
            Self::Curvature | Self::DetailCurvature => Some("curvature"),
            Self::SparseCurvature | Self::SparseDetailCurvature => Some("curvature_sparse"),
            Self::CurvatureTensor => Some("curvature_tensor"),
            Self::SmoothNormals(1) => Some("smooth_normals_1"),
            Self::SmoothNormals(2) => Some("smooth_normals_2"),
            Self::SmoothNormals(3) => Some("smooth_normals_3"),
            Self::SmoothNormals(_) => Some("smooth_normals_4"),
            Self::Normals | Self::DetailNormals | Self::Look => None,
        }
    }

    /// How many numbers a pixel a pass over normals makes.
    pub fn channels(&self) -> usize {
        if matches!(self, Self::CurvatureTensor | Self::SmoothNormals(_)) { 4 } else { 1 }
    }
}

/// A pass with its reason.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Pass {
    /// What it does.
    pub kind: PassKind,
    /// Why it is in the plan.
    pub reason: String,
    /// Of everything that it reads: the same hash gives the same result.
    pub input_hash: u64,
}

/// Something that the plan does without.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Dropped {
    /// What.
    pub what: String,
    /// Why it is not needed.
    pub why: String,
    /// What kind of thing it is.
    pub kind: EffectKind,
    /// What proves that nothing is lost.
    pub proof: Proof,
    /// The look that it belongs to, by name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub look: Option<String>,
    /// What it would cost, as far as that is known.
    pub cost: EffectCost,
}

/// One part of an object, to be drawn.
#[derive(Clone, Debug)]
pub struct Draw {
    /// The object.
    pub object: ObjectId,
    /// Its mesh.
    pub mesh: Arc<Mesh>,
    /// Which of its indices.
    pub indices: Range<u32>,
    /// What the look is called.
    pub look_name: String,
    /// The look.
    pub look: Arc<CompiledShader>,
    /// The look's normals, by what they are of.
    pub normals: HashMap<PassKind, Arc<CompiledShader>>,
    /// The `Object` uniform.
    pub object_uniform: Uniform,
    /// The `Look` uniform; one for each module, by stage.
    pub look_uniforms: HashMap<Stage, Uniform>,
    /// For each set of the look's direction keys what decides, and the weight of each of its keys.
    pub decided: Vec<(DVec3, Vec<f64>)>,
    /// The images of the look's module, in the order of its needs.
    pub images: Vec<Arc<Image>>,
    /// The same of the modules that draw normals, where those read any.
    pub normals_images: HashMap<Stage, Vec<Arc<Image>>>,
    /// Whether back faces are drawn.
    pub two_sided: bool,
    /// Whether the object's transform mirrors it, so that triangles run the other way around.
    pub is_mirrored: bool,
    /// From the eye, for drawing what is transparent from back to front.
    pub distance: f64,
}

impl Draw {
    /// The images of one of its modules, in the order of the module's needs.
    pub fn images_of(&self, stage: Stage) -> &[Arc<Image>] {
        match stage {
            Stage::Draw | Stage::Eval => &self.images,
            Stage::Normals | Stage::DetailNormals => {
                self.normals_images.get(&stage).map_or(&[], Vec::as_slice)
            }
        }
    }
}

/// Everything a renderer needs for one picture.
#[derive(Clone, Debug)]
pub struct FramePlan {
    /// Pixels.
    pub size: [u32; 2],
    /// Samples a pixel.
    pub samples: u32,
    /// Straight RGBA behind everything; `None` for transparent.
    pub backdrop: Option<[f64; 4]>,
    /// The camera.
    pub view: View,
    /// Back to front.
    pub draws: Vec<Draw>,
    /// In order.
    pub passes: Vec<Pass>,
    /// What was left out.
    pub dropped: Vec<Dropped>,
}

impl FramePlan {
    /// How far its passes look around in the normals, in pixels.
    pub fn reach(&self) -> usize {
        let stride = self.view.curvature_reach() / 3;
        let of = |kind: &PassKind| match kind {
            // All levels before it have looked around, each twice as far as the one before.
            PassKind::SmoothNormals(level) => stride * 2 * ((1 << level) - 1),
            kind if kind.shader().is_some() => 3 * stride,
            _ => 0,
        };
        self.passes.iter().map(|pass| of(&pass.kind)).max().unwrap_or_default()
    }
}

/// A look's modules, compiled when first asked for.
#[derive(Clone, Debug)]
pub struct LookShaders {
    draw: Arc<CompiledShader>,
    normals: HashMap<Stage, Arc<CompiledShader>>,
    rig: Rig,
    tables: HashMap<Stage, ParamTable>,
}

/// Fields of lights that are 0, with the reasons.
type Dark = Vec<((LightId, LightField), &'static str)>;

/// What an object's look was compiled as, by the object's number and the look's: the key, and which
/// lights are dark.
type Keys = HashMap<(usize, usize), (u64, BTreeSet<(LightId, LightField)>)>;

/// How a look is wanted by an object.
struct Wanted<'a> {
    live: &'a Live,
    cutout: bool,
    dark: BTreeSet<(LightId, LightField)>,
}

/// Makes frame plans, keeping what was compiled and read.
#[derive(Debug, Default)]
pub struct Planner {
    /// Meshes and images.
    pub assets: Assets,
    /// What is left out because it is not seen.
    pub cull: Cull,
    bounds: KnownBounds,
    /// Compiled looks by what they were compiled from.
    shaders: HashMap<u64, LookShaders>,
    /// Those that the last plan used.
    used: HashSet<u64>,
    /// The nodes of compiled looks that read UVs or tangents, where a mesh has no UVs.
    uv_readers: HashMap<u64, Vec<NodePath>>,
    /// What was odd, but stopped nothing.
    pub warnings: Vec<Diagnostic>,
    /// Whether looks are compiled as they are written: nothing folded, merged or removed.
    unspecialized: bool,
}

impl Planner {
    /// A planner with assets that were read already.
    pub fn new(assets: Assets) -> Self {
        Self { assets, ..Self::default() }
    }

    /// A planner for the reference: what it compiles is as the looks are written, with nothing
    /// folded or removed. Its plans are to be asked for with [`Live::All`], so that every value
    /// comes in f64.
    pub fn for_truth(assets: Assets) -> Self {
        Self { assets, unspecialized: true, cull: Cull::Objects, ..Self::default() }
    }

    /// The same, leaving out `cull`.
    #[must_use]
    pub fn culling(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }

    /// Gives a look's module that was compiled elsewhere (on another thread, say), for the next
    /// plans of this look. The same module again takes on the look's keys.
    pub fn provide(&mut self, look: &Look, live: &Live, draw: Arc<CompiledShader>) {
        let key = look_key(look, live, false, &BTreeSet::new());
        // Keys change without the module: what was made beside it serves on.
        let known =
            self.shaders.values_mut().find(|shaders| Arc::ptr_eq(&shaders.draw, &draw)).map(
                |shaders| {
                    let rig = shaders.rig.renewed(look);
                    LookShaders { rig, ..shaders.clone() }
                },
            );
        let shaders = known.unwrap_or_else(|| {
            let (rig, problems) = Rig::new(look).into_parts();
            self.warnings = problems;
            let tables = HashMap::from([(Stage::Draw, ParamTable::new(&draw.params))]);
            LookShaders { draw, normals: HashMap::new(), rig, tables }
        });
        // One look is being edited at a time: what was compiled for its earlier states goes, the
        // other looks stay.
        self.shaders.retain(|key, _| self.used.contains(key));
        self.shaders.insert(key, shaders);
    }

    /// Plans one picture of `setup`.
    ///
    /// # Errors
    /// Everything that keeps a look from being compiled or an image from being read.
    pub fn plan(
        &mut self,
        setup: &Setup,
        library: &Library,
        live: &Live,
        options: &PlanOptions,
    ) -> Result<FramePlan, Vec<Diagnostic>> {
        let lives = lives(setup, live);
        let placed = self.bounds.place(&setup.objects);
        let (center, radius) = bounds(&placed);
        let view = View::new(&setup.scene.camera, options.size, center, radius);
        let view = view.with_surface_at(nearest_surface(
            &setup.objects,
            &placed,
            view.eye,
            view.least_distance(),
        ));
        let mut dropped = Vec::new();
        let seen = self.seen(setup, &placed, &view, &mut dropped);
        let mut problems = Vec::new();
        let mut keys = Keys::new();
        for &(number, object) in &seen {
            for &look in object.looks.iter().flatten() {
                if keys.contains_key(&(number, look)) {
                    continue;
                }
                let shown = structural_look(&setup.looks[look].look, options.time, &object.values);
                let live = &lives[look];
                let dark = self.dark(setup, &shown, live, &placed[number], &view);
                let wanted = Wanted { live, cutout: has_cutout(object, look), dark: fields(&dark) };
                let key = look_key(&shown, live, wanted.cutout, &wanted.dark);
                if !self.shaders.contains_key(&key) {
                    match self.compile_look(&setup.looks[look], &shown, library, &wanted) {
                        Ok(shaders) => drop(self.shaders.insert(key, shaders)),
                        Err(found) => problems.extend(found),
                    }
                }
                if let Some(shaders) = self.shaders.get(&key) {
                    push_lights(&mut dropped, &shown, shaders, &dark);
                }
                keys.insert((number, look), (key, wanted.dark));
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        self.used = keys.values().map(|(key, _)| *key).collect();
        self.warn_of_uvs(setup, &seen, &keys, library);
        push_equal_looks(&mut dropped, setup, &keys);
        let needs = |context: Context, what: &str| {
            seen.iter().find_map(|(number, object)| {
                let mut looks = object.looks.iter().flatten();
                let reads = |look: usize| {
                    self.shaders[&keys[&(*number, look)].0].draw.needs.context(context)
                };
                let name = &setup.looks[*looks.find(|&&look| reads(look))?].look.name;
                Some(format!("object `{}` wears {}, which reads {what}", object.id, quoted(name)))
            })
        };
        let wanted = WantedCurvature::all(&needs);
        let is_wanted = |wanted: &&WantedCurvature| !wanted.passes.is_empty();
        let stages: Vec<_> =
            wanted.iter().filter(is_wanted).map(|w| (w.normals.clone(), w.stage)).collect();
        let mut draws = Vec::new();
        for &(number, object) in &seen {
            let center = placed[number].center;
            match self.draws(
                setup,
                object,
                (number, center),
                &keys,
                library,
                &lives,
                &stages,
                &view,
                options,
            ) {
                Ok(found) => draws.extend(found),
                Err(found) => problems.extend(found),
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        draws.sort_by(|a, b| b.distance.total_cmp(&a.distance));
        let passes = passes(&wanted, &draws, &view, options, &mut dropped);
        Ok(FramePlan {
            size: options.size,
            samples: options.samples,
            backdrop: setup.scene.backdrop,
            view,
            draws,
            passes,
            dropped,
        })
    }

    /// The objects of which something may be seen, with their numbers; the others are dropped.
    fn seen<'s>(
        &self,
        setup: &'s Setup,
        placed: &[Placed],
        view: &View,
        dropped: &mut Vec<Dropped>,
    ) -> Vec<(usize, &'s SetupObject)> {
        let mut seen = Vec::new();
        for (number, object) in setup.objects.iter().enumerate() {
            match hidden(object, &placed[number], view).filter(|_| self.cull != Cull::Nothing) {
                Some((proof, why)) => dropped.push(Dropped {
                    what: format!("object `{}`", object.id),
                    why: why.to_owned(),
                    kind: EffectKind::Object,
                    proof,
                    look: None,
                    cost: EffectCost::bytes(4 * object.mesh.indices.len() as u64),
                }),
                None => seen.push((number, object)),
            }
        }
        seen
    }

    /// Tells of objects whose looks read UVs, or the tangents along them, that their meshes do not
    /// have.
    fn warn_of_uvs(
        &mut self,
        setup: &Setup,
        seen: &[(usize, &SetupObject)],
        keys: &Keys,
        library: &Library,
    ) {
        self.uv_readers.retain(|key, _| self.used.contains(key));
        for &(number, object) in seen.iter().filter(|(_, object)| !object.mesh.has_uvs) {
            for &index in object.looks.iter().flatten().collect::<BTreeSet<_>>() {
                let look = &setup.looks[index];
                let Some((key, _)) = keys.get(&(number, index)) else { continue };
                let Some(LookShaders { draw, .. }) = self.shaders.get(key) else { continue };
                let Some(lack) = Lack::of(draw) else { continue };
                let readers = self
                    .uv_readers
                    .entry(*key)
                    .or_insert_with(|| uvs::readers(look, draw, lack, library));
                let problem = uvs::without_uvs(object, look, lack, readers);
                if !self.warnings.contains(&problem) {
                    self.warnings.push(problem);
                }
            }
        }
    }

    /// Tells of keys by the distance to an object that is not in the scene.
    fn warn_of_missing(&mut self, setup: &Setup, look: &SetupLook, own: &ObjectId) {
        for (index, set) in look.look.direction_keys.iter().enumerate() {
            let KeyDirection::Drivers(drivers) = &set.by else { continue };
            for driver in drivers {
                let Driver::Near(id) = driver else { continue };
                if *id != *own && setup.objects.iter().any(|object| object.id == *id) {
                    continue;
                }
                let is_own = *id == *own;
                let message = if is_own {
                    format!("object `{id}` wears a look whose keys go by how near it is to itself")
                } else {
                    format!("there is no object `{id}` in the scene")
                };
                let ids =
                    setup.objects.iter().map(|object| &object.id).filter(|other| *other != own);
                let known: Vec<String> = ids.take(8).map(|id| format!("`{id}`")).collect();
                let hint = if known.is_empty() {
                    "add another object to the scene, or let something else decide".to_owned()
                } else {
                    format!(
                        "other objects are {}; until then it counts as far away",
                        known.join(", ")
                    )
                };
                let mut problem = Diagnostic::warning("unknown-object", message)
                    .json_path(format!("direction_keys[{index}].by"))
                    .hint(hint);
                look.source.locate(&mut problem);
                if !self.warnings.contains(&problem) {
                    self.warnings.push(problem);
                }
            }
        }
    }

    fn dark(&self, setup: &Setup, shown: &Look, live: &Live, placed: &Placed, view: &View) -> Dark {
        // What may be edited any moment is never taken for what it is now.
        if self.cull != Cull::All || !matches!(live, Live::Keyed | Live::Exposed) {
            return Vec::new();
        }
        dark_lights(setup, shown, placed, view)
    }

    fn compile_look(
        &mut self,
        setup: &SetupLook,
        shown: &Look,
        library: &Library,
        wanted: &Wanted<'_>,
    ) -> Result<LookShaders, Vec<Diagnostic>> {
        let options = Options {
            live: wanted.live.clone(),
            display: true,
            cutout: wanted.cutout,
            unspecialized: self.unspecialized,
            dark: wanted.dark.clone(),
            ..Options::default()
        };
        let located = |mut problems: Vec<Diagnostic>| {
            setup.source.locate_all(&mut problems);
            problems
        };
        let draw = Arc::new(compile(shown, library, &options).map_err(located)?);
        let (rig, mut problems) = Rig::new(shown).into_parts();
        problems.extend(draw.warnings.iter().cloned());
        self.warnings.extend(located(problems));
        let tables = HashMap::from([(Stage::Draw, ParamTable::new(&draw.params))]);
        Ok(LookShaders { draw, normals: HashMap::new(), rig, tables })
    }

    #[expect(clippy::too_many_arguments, reason = "one object's share of the plan")]
    fn draws(
        &mut self,
        setup: &Setup,
        object: &SetupObject,
        (number, center): (usize, DVec3),
        keys: &Keys,
        library: &Library,
        lives: &[Live],
        stages: &[(PassKind, Stage)],
        view: &View,
        options: &PlanOptions,
    ) -> Result<Vec<Draw>, Vec<Diagnostic>> {
        let mut draws = Vec::new();
        let near = setup.others_of(object);
        for (part, look) in object.mesh.parts.iter().zip(&object.looks) {
            let Some(look) = *look else { continue };
            self.warn_of_missing(setup, &setup.looks[look], &object.id);
            let (key, dark) = &keys[&(number, look)];
            let shaders = self.shaders.get_mut(key).expect("compiled above");
            let shown = structural_look(&setup.looks[look].look, options.time, &object.values);
            for (_, stage) in stages {
                if !shaders.normals.contains_key(stage) {
                    let cutout = has_cutout(object, look);
                    let (dark, live, stage) = (dark.clone(), lives[look].clone(), *stage);
                    let unspecialized = self.unspecialized;
                    let wanted =
                        Options { live, stage, cutout, dark, unspecialized, ..Options::default() };
                    let compiled = Arc::new(compile(&shown, library, &wanted)?);
                    shaders.tables.insert(stage, ParamTable::new(&compiled.params));
                    shaders.normals.insert(stage, compiled);
                }
            }
            let lights = lights(setup, look);
            let moment = Moment {
                time: options.time,
                illumination: DQuat::from_array(setup.scene.illumination).normalize(),
                camera_from_world: view.rotation(),
                view: view.toward_viewer(center),
                center,
                distance: view.eye.distance(center),
                front: object.world_from_object.transform_vector3(DVec3::Z),
                near: &near,
                exposed: &object.values,
                lights: &lights,
                viewport: options.size.map(f64::from),
                frame: ((options.time - setup.scene.time.start) * setup.scene.time.fps).round(),
                object_id: number as f64,
            };
            let mut look_uniforms = HashMap::new();
            let (mut decided, mut cuts) = (Vec::new(), false);
            for (stage, shader) in std::iter::once((Stage::Draw, &shaders.draw))
                .chain(stages.iter().map(|(_, s)| (*s, &shaders.normals[s])))
            {
                let params = current_params(&shown, &shader.params);
                let wires = Wires::of(&shaders.draw);
                let values = shaders.rig.evaluate(&params, &shaders.tables[&stage], wires, &moment);
                let mut values = values.map_err(|problem| vec![problem])?;
                decided = std::mem::take(&mut values.decided);
                for (id, (now, then)) in params.into_iter().zip(shader.params.iter()).enumerate() {
                    if let (true, Some(value)) = (now.value != then.value, now.value) {
                        values.params.entry(id).or_insert(value);
                    }
                }
                cuts |= shader.cuts(&values.params);
                let inputs = HostInputs {
                    params: &values.params,
                    lights: &values.lights,
                    camera_from_world: view.rotation(),
                    viewport: moment.viewport,
                    time: options.time,
                    frame: moment.frame,
                    object_id: moment.object_id,
                };
                look_uniforms
                    .insert(stage, shader.host.uniform(&inputs).map_err(|problem| vec![problem])?);
            }
            let drawn = images(&mut self.assets, &shaders.draw, &setup.looks[look])?;
            let mut normals_images = HashMap::new();
            for (_, stage) in stages {
                let found = images(&mut self.assets, &shaders.normals[stage], &setup.looks[look])?;
                normals_images.insert(*stage, found);
            }
            draws.push(Draw {
                object: object.id.clone(),
                mesh: object.mesh.clone(),
                indices: part.indices.clone(),
                look_name: shown.name.clone(),
                look: shaders.draw.clone(),
                normals: stages
                    .iter()
                    .map(|(kind, stage)| (kind.clone(), shaders.normals[stage].clone()))
                    .collect(),
                object_uniform: object_uniform(
                    object.world_from_object,
                    number as f64,
                    f64::from(part.alpha_cutoff.unwrap_or(0.0)),
                ),
                look_uniforms,
                decided,
                images: drawn,
                normals_images,
                // From within, a solid is seen from behind, and so it is through what a look cuts
                // away.
                two_sided: part.two_sided || cuts || view.eye.distance(center) < object.radius(),
                is_mirrored: object.world_from_object.determinant() < 0.0,
                distance: view.backward.dot(view.eye - center),
            });
        }
        Ok(draws)
    }
}

/// How alive each look is to be: those whose objects set values by name are seen to change.
fn lives(setup: &Setup, live: &Live) -> Vec<Live> {
    let sets_values = |look: usize| {
        setup
            .objects
            .iter()
            .any(|object| !object.values.is_empty() && object.looks.contains(&Some(look)))
    };
    let asked = |look: usize| match setup.edited {
        Some(edited) if edited != look => &Live::Keyed,
        _ => live,
    };
    (0..setup.looks.len()).map(|look| live_for_values(asked(look), sets_values(look))).collect()
}

/// Lights in place of those that a look was compiled with: the scene's, and of a look that is being
/// edited its own as they are now.
fn lights(setup: &Setup, look: usize) -> Cow<'_, IndexMap<LightId, Light>> {
    if setup.edited != Some(look) {
        return Cow::Borrowed(&setup.scene.lights);
    }
    let mut lights = setup.looks[look].look.lights.clone();
    lights.extend(setup.scene.lights.iter().map(|(id, light)| (id.clone(), light.clone())));
    Cow::Owned(lights)
}

/// Lists the lights of a look that its module does not read, and those that are dark.
fn push_lights(dropped: &mut Vec<Dropped>, look: &Look, shaders: &LookShaders, dark: &Dark) {
    let is_read = |id: &LightId| shaders.draw.host.lights().any(|light| light == id);
    for id in look.lights.keys() {
        let found = dark.iter().find(|((light, _), _)| light == id);
        let (why, proof) = match found {
            Some((_, why)) => (*why, Proof::NoLight),
            None if is_read(id) => continue,
            None => ("no live node reads it, so that it has no uniforms", Proof::Unreachable),
        };
        let one = Dropped {
            what: format!("light `{id}`"),
            why: why.to_owned(),
            kind: EffectKind::Light,
            proof,
            look: Some(look.name.clone()),
            cost: EffectCost::default(),
        };
        if !dropped.contains(&one) {
            dropped.push(one);
        }
    }
}

/// Lists the looks that are compiled once with another.
fn push_equal_looks(dropped: &mut Vec<Dropped>, setup: &Setup, keys: &Keys) {
    let mut known: HashMap<u64, usize> = HashMap::new();
    let mut sorted: Vec<_> = keys.iter().map(|((_, look), (key, _))| (*look, *key)).collect();
    sorted.sort_unstable();
    sorted.dedup();
    for (look, key) in sorted {
        let first = *known.entry(key).or_insert(look);
        if first != look {
            let name = &setup.looks[look].look.name;
            dropped.push(Dropped {
                what: quoted(name),
                why: "another look says the same: both are compiled once and share their pipelines"
                    .to_owned(),
                kind: EffectKind::Look,
                proof: Proof::Equal,
                look: Some(name.clone()),
                cost: EffectCost::default(),
            });
        }
    }
}

/// The images that a module reads, in the order of its needs.
pub(super) fn images(
    assets: &mut Assets,
    shader: &CompiledShader,
    setup: &SetupLook,
) -> Result<Vec<Arc<Image>>, Vec<Diagnostic>> {
    let mut problems = Vec::new();
    let images = shader
        .needs
        .images
        .iter()
        .map(|image| {
            let plain = |color| match image.shape {
                ImageShape::Flat => Arc::new(Image::single(color)),
                ImageShape::Hcbtf { .. } => Arc::new(plain_hcbtf(color)),
            };
            if image.path.is_empty() {
                // None chosen yet: white, so that what it tints stays as it is.
                return plain([255; 4]);
            }
            let read = match image.shape {
                ImageShape::Flat => {
                    assets.image(&setup.folder, &image.path).map_err(|problem| vec![problem])
                }
                ImageShape::Hcbtf { has_levels, storage } => {
                    let options =
                        LayerOptions { has_levels, is_decoded: image.is_decoded, storage };
                    assets.hcbtf(&setup.folder, &image.path, options).map(|image| image.value)
                }
            };
            read.unwrap_or_else(|found| {
                problems.extend(found.into_iter().map(|problem| problem.node(image.node.clone())));
                plain([255, 0, 255, 255])
            })
        })
        .collect();
    setup.source.locate_all(&mut problems);
    if problems.is_empty() { Ok(images) } else { Err(problems) }
}

/// Whether a part of the object that wears this look is cut out by alpha.
fn has_cutout(object: &SetupObject, look: usize) -> bool {
    object
        .mesh
        .parts
        .iter()
        .zip(&object.looks)
        .any(|(part, worn)| *worn == Some(look) && part.alpha_cutoff.is_some())
}

fn quoted(name: &str) -> String {
    if name.is_empty() { "a look".to_owned() } else { format!("the look \"{name}\"") }
}

fn bounds(objects: &[Placed]) -> (DVec3, f64) {
    let mut min = DVec3::INFINITY;
    let mut max = DVec3::NEG_INFINITY;
    for object in objects {
        min = min.min(object.center - object.radius);
        max = max.max(object.center + object.radius);
    }
    if min.is_finite() && max.is_finite() {
        (0.5 * (min + max), 0.5 * (max - min).length())
    } else {
        (DVec3::ZERO, 1.0)
    }
}

/// What a look's module depends on: all of it, or while everything is live what is no uniform.
fn look_key(look: &Look, live: &Live, cutout: bool, dark: &BTreeSet<(LightId, LightField)>) -> u64 {
    let mut hasher = DefaultHasher::new();
    (cutout, dark).hash(&mut hasher);
    if *live == Live::All {
        (look.color_space, look.tier).hash(&mut hasher);
        hash_graph(&look.graph, &mut hasher);
        for (id, definition) in &look.definitions {
            (id, format!("{:?}{:?}", definition.inputs, definition.outputs)).hash(&mut hasher);
            hash_graph(&definition.graph, &mut hasher);
        }
        look.lights.iter().for_each(|(id, light)| (id, light.kind).hash(&mut hasher));
        look.exposed.iter().for_each(|exposed| (&exposed.name, &exposed.target).hash(&mut hasher));
        for keys in &look.direction_keys {
            format!("{keys:?}").hash(&mut hasher);
        }
        look.time_keys.iter().for_each(|track| format!("{track:?}").hash(&mut hasher));
    } else {
        look.to_text().hash(&mut hasher);
        format!("{live:?}").hash(&mut hasher);
    }
    hasher.finish()
}

fn hash_graph(graph: &Graph, hasher: &mut DefaultHasher) {
    for (id, node) in &graph.nodes {
        (id, &node.kind, &node.name, node.tier).hash(hasher);
        for (port, value) in &node.values {
            // Words decide what is compiled; hex colors are colors.
            if let (Value::Text(text), None) = (value, value.color()) {
                (port, text).hash(hasher);
            }
        }
    }
    graph.wires.hash(hasher);
    graph.frames.iter().for_each(|(id, frame)| (id, &frame.title, &frame.nodes).hash(hasher));
}

/// The parameters with what the document says now: a live module was compiled from an earlier state
/// of its values.
fn current_params(look: &Look, params: &[Param]) -> Vec<Param> {
    params
        .iter()
        .map(|param| {
            let now = look
                .find(&param.path)
                .and_then(|inner| inner.node.values.get(&param.port).cloned());
            let value =
                now.or_else(|| param.default.clone()).map(|value| value.in_space(look.color_space));
            let value = value.or_else(|| param.value.clone());
            Param { value, ..param.clone() }
        })
        .collect()
}

/// The passes over some normals.
struct WantedCurvature {
    /// What people call it.
    name: &'static str,
    /// The pass that draws the normals.
    normals: PassKind,
    /// What it draws them with.
    stage: Stage,
    /// What is found from them, each with who reads it.
    passes: Vec<(PassKind, String)>,
}

impl WantedCurvature {
    /// What `needs` has a reader for. Looks of different tiers may want it in different ways, side
    /// by side.
    fn all(needs: &dyn Fn(Context, &str) -> Option<String>) -> [Self; 2] {
        let wide = |context| needs(context, "curvature");
        let sparse = |context| needs(context, "curvature from four neighbours, its cheaper tier");
        let passes = |passes: Vec<(PassKind, Option<String>)>| {
            passes.into_iter().filter_map(|(kind, reason)| Some((kind, reason?))).collect()
        };
        // Each level is made from the one before it, whether a look reads that or not.
        let smooth = |level| {
            let mut read = (level..=SMOOTH_LEVELS)
                .map(|level| needs(Context::SmoothNormal(level), "smoothed normals"));
            (PassKind::SmoothNormals(level), read.find_map(|reason| reason))
        };
        let by_direction = needs(Context::Tensor, "curvature by direction");
        let mut of_surface = vec![
            (PassKind::Curvature, wide(Context::Kappa)),
            (PassKind::SparseCurvature, sparse(Context::KappaSparse)),
            (PassKind::CurvatureTensor, by_direction),
        ];
        of_surface.extend((1..=SMOOTH_LEVELS).map(smooth));
        [
            Self {
                name: "curvature of the surface",
                normals: PassKind::Normals,
                stage: Stage::Normals,
                passes: passes(of_surface),
            },
            Self {
                name: "curvature of the detail normals",
                normals: PassKind::DetailNormals,
                stage: Stage::DetailNormals,
                passes: passes(vec![
                    (PassKind::DetailCurvature, wide(Context::KappaDetail)),
                    (PassKind::SparseDetailCurvature, sparse(Context::KappaDetailSparse)),
                ]),
            },
        ]
    }
}

fn passes(
    wanted: &[WantedCurvature; 2],
    draws: &[Draw],
    view: &View,
    options: &PlanOptions,
    dropped: &mut Vec<Dropped>,
) -> Vec<Pass> {
    let mut passes = Vec::new();
    for wanted in wanted {
        let Some((first, reason)) = wanted.passes.first() else {
            dropped.push(Dropped {
                what: wanted.name.to_owned(),
                why: "no live node of a visible object reads it".to_owned(),
                kind: EffectKind::Pass,
                proof: Proof::Unreachable,
                look: None,
                cost: cost::of_passes(&[&wanted.normals, &PassKind::Curvature], options),
            });
            continue;
        };
        let input_hash = hash_of(draws, view, options, Some((&wanted.normals, wanted.stage)));
        let what = if matches!(first, PassKind::SmoothNormals(_)) {
            "smoother ones are"
        } else {
            "curvature is"
        };
        let why = format!("{what} computed from them: {reason}");
        passes.push(Pass { kind: wanted.normals.clone(), reason: why, input_hash });
        passes.extend(wanted.passes.iter().map(|(kind, reason)| Pass {
            kind: kind.clone(),
            reason: reason.clone(),
            input_hash,
        }));
    }
    // The look reads what the passes before it drew.
    let mut hasher = DefaultHasher::new();
    hash_of(draws, view, options, None).hash(&mut hasher);
    passes.iter().for_each(|pass: &Pass| pass.input_hash.hash(&mut hasher));
    let input_hash = hasher.finish();
    passes.push(Pass { kind: PassKind::Look, reason: "it is the picture".to_owned(), input_hash });
    passes
}

fn hash_of(
    draws: &[Draw],
    view: &View,
    options: &PlanOptions,
    normals: Option<(&PassKind, Stage)>,
) -> u64 {
    let mut hasher = DefaultHasher::new();
    (options.size, options.samples, view.uniform_bytes()).hash(&mut hasher);
    for draw in draws {
        let (shader, stage) = match normals {
            Some((kind, stage)) => (&draw.normals[kind], stage),
            None => (&draw.look, Stage::Draw),
        };
        (Arc::as_ptr(&draw.mesh) as usize, &draw.indices, &shader.wgsl, &draw.object_uniform.bytes)
            .hash(&mut hasher);
        (&draw.look_uniforms[&stage].bytes, draw.two_sided, draw.is_mirrored).hash(&mut hasher);
        draw.images_of(stage).iter().for_each(|image| image.hash.hash(&mut hasher));
    }
    hasher.finish()
}
