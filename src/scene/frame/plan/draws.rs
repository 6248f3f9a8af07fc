//! Draws: the parts of visible objects, each with its modules and their values.
//!
//! What a look gives to all objects that wear it is computed once: its state at the time, its
//! lights, its images, and its uniforms where nothing in them follows an object.

use std::borrow::Cow;
use std::cell::LazyCell;
use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use glam::{DMat4, DVec3};
use indexmap::IndexMap;

use super::Draw;
use super::casters::PlannedCasters;
use super::images::{images, put_maps, reads_maps};
use super::order::{DrawPlace, in_lists};
use super::placement::{PlacedScene, VisibleObject, values_key};
use super::planner::Planner;
use super::variants::{LookShaders, Variants};
use crate::compile::{CompiledShader, HostInputs, ImageShape, Param, Uniform};
use crate::diag::Diagnostic;
use crate::document::{Light, LightLink, LightValues, Look, Target, Value};
use crate::frame::assets::{Assets, Image};
use crate::frame::camera::object_uniform;
use crate::frame::keys::{RigInputs, SceneRig, Wires};
use crate::frame::links::unlinked_lights;
use crate::frame::mix::LightMix;
use crate::frame::object_lights::{Surroundings, near_objects};
use crate::frame::setup::SetupLook;
use crate::geometry::{Mesh, MeshPart};
use crate::ids::{LightId, ObjectId};
use crate::library::Stage;

/// A variant of a look with everything that its draws share.
struct WornLook<'a> {
    /// The look with the words that it has at the time of the picture.
    look: Cow<'a, Look>,
    shaders: &'a LookShaders,
    /// Modules for passes before the look, by stage.
    before: BTreeMap<Stage, Arc<CompiledShader>>,
    /// Lights that replace the look's own.
    lights: Cow<'a, IndexMap<LightId, Light>>,
    /// Mutes, solos and masters of the lights.
    mix: &'a LightMix,
    /// Keys of the scene's lights.
    scene_rig: Option<&'a SceneRig>,
    images: DrawImages,
    /// True if some images are maps of the mesh's own materials, and so another part's differ.
    reads_maps: bool,
    /// True if values differ between objects of the same exposed values.
    follows_objects: bool,
    /// Values that objects share, by the exposed values of the objects, the lights that reach them,
    /// and what casts the lights' shadows onto them.
    known: HashMap<(String, Option<LightLink>, Option<u64>), Arc<DrawValues>>,
}

/// Images that the modules of a draw sample.
#[derive(Clone)]
struct DrawImages {
    of_look: Vec<Arc<Image>>,
    before: BTreeMap<Stage, Vec<Arc<Image>>>,
    /// True if depths are drawn before colors.
    depth_first: bool,
}

/// A part of an object with everything that its draw is made of.
struct PartDraw<'a> {
    scene: &'a PlacedScene<'a>,
    visible: VisibleObject<'a>,
    part: &'a MeshPart,
    /// Number of the part, which is that of its material.
    material: usize,
    /// Distances of other objects, in scene units.
    near: &'a IndexMap<ObjectId, f64>,
    /// Casters of shadows, where a look reads them.
    casters: Option<&'a PlannedCasters<'a>>,
    /// Values that keys of the scene give to lights; none until a look's are computed.
    scene_values: &'a HashMap<Target, Value>,
}

/// Values of a look's uniforms for a draw.
#[derive(Default)]
struct DrawValues {
    uniforms: HashMap<Stage, Arc<Uniform>>,
    decided: Vec<(DVec3, Vec<f64>)>,
    /// True if the look cuts parts of its surface away.
    cuts: bool,
}

impl Planner {
    /// The draws of visible objects, back to front where that may be seen and else one look after
    /// another, with the modules of `stages` before the look's own.
    pub(super) fn draws(
        &mut self,
        scene: &PlacedScene<'_>,
        (visible, casters): (&[VisibleObject<'_>], Option<&PlannedCasters<'_>>),
        variants: &Variants,
        stages: &[Stage],
    ) -> Result<Vec<Draw>, Vec<Diagnostic>> {
        let (mut draws, mut problems) = (Vec::new(), Vec::new());
        // `None` for looks whose images cannot be read.
        let mut worn: HashMap<(usize, u64), Option<WornLook<'_>>> = HashMap::new();
        let centers = LazyCell::new(|| scene.centers());
        let scene_values = HashMap::new();
        for &VisibleObject { number, object } in visible {
            let place = DrawPlace::new(scene, number);
            let parts = object.mesh.parts.iter().zip(&object.looks);
            let worn_parts =
                parts.enumerate().filter_map(|(at, (part, look))| Some((at, part, (*look)?)));
            for (material, part, index) in worn_parts {
                let Some(variant) = variants.get(&(number, index)) else { continue };
                let Some(shaders) = self.shaders.get(&variant.key) else { continue };
                let look = match worn.entry((index, variant.key)) {
                    Entry::Occupied(known) => known.into_mut(),
                    Entry::Vacant(slot) => {
                        let look = scene.worn(index, object);
                        let made =
                            WornLook::new(scene, index, (look, shaders), stages, &mut self.assets);
                        slot.insert(made.map_err(|found| problems.extend(found)).ok())
                    }
                };
                let Some(look) = look else { continue };
                let center_of = |id: &ObjectId| centers.get(id).copied();
                let center = scene.placed[number].center;
                let (rig, of_scene) = (&look.shaders.rig, look.scene_rig);
                let near = near_objects(rig, of_scene, (&object.id, center), &center_of);
                let visible = VisibleObject { number, object };
                let part = PartDraw {
                    scene,
                    visible,
                    part,
                    material,
                    near: &near,
                    casters,
                    scene_values: &scene_values,
                };
                let of_part = (&*object.mesh, part.part);
                let setup = &scene.setup.looks[index];
                let images = match look.images_of(setup, of_part, &mut self.assets) {
                    Ok(images) => images,
                    Err(found) => {
                        problems.extend(found);
                        continue;
                    }
                };
                match part.draw(look, images) {
                    Ok(draw) => draws.push((draw, place)),
                    Err(problem) => problems.push(problem),
                }
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        draws.sort_by(|(a, _), (b, _)| b.distance.total_cmp(&a.distance));
        Ok(in_lists(draws))
    }
}

impl<'a> WornLook<'a> {
    /// A variant of the look with the number `index`, in its state at the time.
    ///
    /// # Errors
    /// Images that cannot be read.
    fn new(
        scene: &'a PlacedScene<'_>,
        index: usize,
        (look, shaders): (Cow<'a, Look>, &'a LookShaders),
        stages: &[Stage],
        assets: &mut Assets,
    ) -> Result<Self, Vec<Diagnostic>> {
        let before: BTreeMap<Stage, Arc<CompiledShader>> = stages
            .iter()
            .filter_map(|stage| Some((*stage, shaders.before.get(stage)?.clone())))
            .collect();
        let reads_maps =
            reads_maps(&shaders.draw) || before.values().any(|shader| reads_maps(shader));
        let setup = &scene.setup.looks[index];
        let images = DrawImages::read((&shaders.draw, &before), setup, assets)?;
        let reads_object = shaders.draw.host.reads_object()
            || before.values().any(|shader| shader.host.reads_object());
        let lights = scene.lights(index);
        let scene_rig = scene.rig.as_deref();
        Ok(Self {
            look,
            shaders,
            before,
            follows_objects: reads_object
                || shaders.rig.follows_objects(&lights)
                || scene_rig.is_some_and(SceneRig::follows_objects),
            lights,
            mix: &scene.mix,
            scene_rig,
            images,
            reads_maps,
            known: HashMap::new(),
        })
    }

    /// The images for a part of a mesh.
    ///
    /// # Errors
    /// Pictures of the part's material that cannot be read.
    fn images_of(
        &self,
        setup: &SetupLook,
        part: (&Mesh, &MeshPart),
        assets: &mut Assets,
    ) -> Result<DrawImages, Vec<Diagnostic>> {
        let mut images = self.images.clone();
        if self.reads_maps {
            let draw = &self.shaders.draw;
            put_maps(&mut images.of_look, assets, draw, setup, part)?;
            for (stage, of_pass) in &mut images.before {
                let Some(shader) = self.before.get(stage) else { continue };
                put_maps(of_pass, assets, shader, setup, part)?;
            }
            images.depth_first = draws_depth_first(draw, &images.of_look);
        }
        Ok(images)
    }

    /// The values for an object, whose surroundings are `inputs`; lights that are not linked to it
    /// or out are dark.
    fn values(
        &mut self,
        inputs: &RigInputs<'_>,
        (link, unlinked): (&LightLink, &dyn Fn() -> Vec<LightId>),
        casters: Option<(&PlannedCasters<'_>, usize)>,
    ) -> Result<Arc<DrawValues>, Diagnostic> {
        if self.follows_objects {
            return self.computed(inputs, &unlinked(), casters).map(Arc::new);
        }
        let link = (!link.is_all()).then(|| link.clone());
        let shadows = casters.map(|(casters, object)| casters.key(object));
        let key = (values_key(inputs.exposed), link, shadows);
        if let Some(known) = self.known.get(&key) {
            return Ok(known.clone());
        }
        let values = Arc::new(self.computed(inputs, &unlinked(), casters)?);
        self.known.insert(key, values.clone());
        Ok(values)
    }

    /// The uniforms of the look's module and of the modules before it.
    fn computed(
        &self,
        inputs: &RigInputs<'_>,
        unlinked: &[LightId],
        casters: Option<(&PlannedCasters<'_>, usize)>,
    ) -> Result<DrawValues, Diagnostic> {
        let shaders = self.shaders;
        let inputs = RigInputs { lights: &self.lights, ..*inputs };
        let scene_values = self.scene_rig.map(|rig| rig.values(&inputs)).unwrap_or_default();
        let inputs = RigInputs { scene_values: &scene_values, ..inputs };
        let mut made = DrawValues::default();
        let modules = std::iter::once((shaders.draw.stage, &shaders.draw))
            .chain(self.before.iter().map(|(stage, shader)| (*stage, shader)));
        for (stage, shader) in modules {
            let Some(table) = shaders.tables.get(&stage) else { continue };
            let params = current_params(&self.look, &shader.params);
            let wires = Wires::of(&shaders.draw);
            let mut values = shaders.rig.evaluate(&params, table, wires, &inputs)?;
            made.decided = std::mem::take(&mut values.decided);
            values.lights.iter_mut().for_each(|(id, light)| self.mix.apply(id, light));
            for id in unlinked {
                values.lights.get_mut(id).map(LightValues::darken);
            }
            if let Some((casters, object)) = casters {
                casters.tell(object, shader, &mut values.lights);
            }
            for (id, (now, then)) in params.into_iter().zip(shader.params.iter()).enumerate() {
                if let (true, Some(value)) = (now.value != then.value, now.value) {
                    values.params.entry(id).or_insert(value);
                }
            }
            made.cuts |= shader.cuts(&values.params);
            let host = HostInputs {
                params: &values.params,
                lights: &values.lights,
                camera_from_world: inputs.camera_from_world,
                viewport: inputs.viewport,
                time: inputs.time,
                frame: inputs.frame,
                object_id: inputs.object_id,
            };
            made.uniforms.insert(stage, Arc::new(shader.host.uniform(&host)?));
        }
        Ok(made)
    }
}

impl DrawImages {
    fn read(
        (draw, before): (&CompiledShader, &BTreeMap<Stage, Arc<CompiledShader>>),
        setup: &SetupLook,
        assets: &mut Assets,
    ) -> Result<Self, Vec<Diagnostic>> {
        let of_look = images(assets, draw, setup)?;
        let read = |(stage, shader): (&Stage, &Arc<CompiledShader>)| {
            Ok((*stage, images(assets, shader, setup)?))
        };
        let before = before.iter().map(read).collect::<Result<_, Vec<Diagnostic>>>()?;
        let depth_first = draws_depth_first(draw, &of_look);
        Ok(Self { of_look, before, depth_first })
    }
}

impl PartDraw<'_> {
    /// The draw of the part, which wears the look.
    fn draw(&self, look: &mut WornLook<'_>, images: DrawImages) -> Result<Draw, Diagnostic> {
        let Self { scene, visible: VisibleObject { number, object }, part, material, .. } = *self;
        let unlinked = || unlinked_lights(scene.setup, object).into_keys().collect();
        let link = (&object.light_link, &unlinked as &dyn Fn() -> Vec<LightId>);
        let casters = self.casters.map(|casters| (casters, number));
        let values = look.values(&self.rig_inputs(), link, casters)?;
        let (view, placed) = (&scene.view, &scene.placed[number]);
        let eye_distance = view.eye.distance(placed.center);
        Ok(Draw {
            object: object.id.clone(),
            mesh: object.mesh.clone(),
            indices: part.indices.clone(),
            look_name: look.look.name.clone(),
            look: look.shaders.draw.clone(),
            before: look.before.clone(),
            object_uniform: object_uniform(
                object.world_from_object,
                number as f64,
                f64::from(part.alpha_cutoff.unwrap_or(0.0)),
                material,
            ),
            look_uniforms: values.uniforms.clone(),
            decided: values.decided.clone(),
            images: images.of_look,
            images_before: images.before,
            // A solid is seen from behind by an eye within, and through parts that a look cuts
            // away.
            two_sided: part.two_sided || values.cuts || eye_distance < placed.radius,
            is_mirrored: is_mirrored(object.world_from_object),
            depth_first: images.depth_first,
            distance: view.backward.dot(view.eye - placed.center),
            area: scene.area(&self.visible),
        })
    }

    /// The surroundings of the object and the time, which decide between keys. The lights are
    /// the look's.
    fn rig_inputs(&self) -> RigInputs<'_> {
        let PlacedScene { setup, options, view, placed, aims, .. } = self.scene;
        let number = self.visible.number;
        let around = Surroundings { near: self.near, aims, scene_values: self.scene_values };
        setup.rig_inputs((number, placed[number].center), view, options, around)
    }
}

/// True if triangles run the other way around after the transform.
fn is_mirrored(world_from_object: DMat4) -> bool {
    world_from_object.determinant() < 0.0
}

/// True if depths are drawn before colors.
fn draws_depth_first(shader: &CompiledShader, images: &[Arc<Image>]) -> bool {
    reads_hcbtf(shader) && is_opaque(shader, images)
}

/// True if a module reads an HCBTF: a lookup takes tens of reads.
fn reads_hcbtf(shader: &CompiledShader) -> bool {
    shader.needs.images.iter().any(|image| matches!(image.shape, ImageShape::Hcbtf { .. }))
}

/// True if nothing behind what a module draws can be seen through it.
fn is_opaque(shader: &CompiledShader, images: &[Arc<Image>]) -> bool {
    let Some(needed) = &shader.opaque_with else { return false };
    let read = shader.needs.images.iter().zip(images);
    needed.iter().all(|wanted| read.clone().any(|(own, image)| own == wanted && image.is_opaque))
}

/// The parameters with the values that the document has now: a live module was compiled from an
/// earlier state of the values.
pub(in crate::frame) fn current_params(look: &Look, params: &[Param]) -> Vec<Param> {
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
