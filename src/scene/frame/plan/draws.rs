//! Draws: the parts of visible objects, each with its modules and their values.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use glam::{DQuat, DVec3};
use indexmap::IndexMap;

use super::Draw;
use super::images::images;
use super::placement::{PlacedScene, VisibleObject};
use super::planner::Planner;
use super::variants::{LookShaders, Variants};
use crate::compile::{CompiledShader, HostInputs, ImageShape, Param, Uniform};
use crate::diag::Diagnostic;
use crate::document::{Light, Look};
use crate::frame::assets::{Assets, Image};
use crate::frame::camera::object_uniform;
use crate::frame::keys::{RigInputs, Wires, structural_look};
use crate::frame::setup::SetupLook;
use crate::geometry::MeshPart;
use crate::ids::{LightId, ObjectId};
use crate::library::Stage;

/// A part of an object with everything that its draw is made of.
struct PartDraw<'a> {
    scene: &'a PlacedScene<'a>,
    visible: VisibleObject<'a>,
    part: &'a MeshPart,
    setup: &'a SetupLook,
    /// The look with the words that it has at the time of the picture.
    look: &'a Look,
    shaders: &'a LookShaders,
    /// Distances of other objects, in scene units.
    near: &'a IndexMap<ObjectId, f64>,
    /// Lights that replace the look's own.
    lights: &'a IndexMap<LightId, Light>,
}

/// Values of a look's uniforms for a draw.
#[derive(Default)]
struct DrawValues {
    uniforms: HashMap<Stage, Uniform>,
    decided: Vec<(DVec3, Vec<f64>)>,
    /// True if the look cuts parts of its surface away.
    cuts: bool,
}

impl Planner {
    /// The draws of visible objects from back to front, with the modules of `stages` before the
    /// look's own.
    pub(super) fn draws(
        &mut self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        variants: &Variants,
        stages: &[Stage],
    ) -> Result<Vec<Draw>, Vec<Diagnostic>> {
        let (mut draws, mut problems) = (Vec::new(), Vec::new());
        for object in visible {
            match self.object_draws(scene, *object, variants, stages) {
                Ok(found) => draws.extend(found),
                Err(found) => problems.extend(found),
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        draws.sort_by(|a, b| b.distance.total_cmp(&a.distance));
        Ok(draws)
    }

    fn object_draws(
        &mut self,
        scene: &PlacedScene<'_>,
        visible: VisibleObject<'_>,
        variants: &Variants,
        stages: &[Stage],
    ) -> Result<Vec<Draw>, Vec<Diagnostic>> {
        let VisibleObject { number, object } = visible;
        let near = scene.setup.others_of(object);
        let mut draws = Vec::new();
        for (part, look) in object.mesh.parts.iter().zip(&object.looks) {
            let Some(index) = *look else { continue };
            let Some(variant) = variants.get(&(number, index)) else { continue };
            let Some(shaders) = self.shaders.get(&variant.key) else { continue };
            let setup = &scene.setup.looks[index];
            let look = structural_look(&setup.look, scene.options.time, &object.values);
            let lights = scene.lights(index);
            let (near, lights) = (&near, &*lights);
            let part = PartDraw { scene, visible, part, setup, look: &look, shaders, near, lights };
            draws.push(part.draw(&mut self.assets, stages)?);
        }
        Ok(draws)
    }
}

impl PartDraw<'_> {
    fn draw(&self, assets: &mut Assets, stages: &[Stage]) -> Result<Draw, Vec<Diagnostic>> {
        let Self { scene, visible: VisibleObject { number, object }, part, shaders, .. } = *self;
        let before: BTreeMap<Stage, Arc<CompiledShader>> = stages
            .iter()
            .filter_map(|stage| Some((*stage, shaders.before.get(stage)?.clone())))
            .collect();
        let values = self.values(&before).map_err(|problem| vec![problem])?;
        let mut read = |shader| images(assets, shader, self.setup);
        let images = read(&shaders.draw)?;
        let depth_first = reads_hcbtf(&shaders.draw) && is_opaque(&shaders.draw, &images);
        let images_before = before
            .iter()
            .map(|(stage, shader)| Ok((*stage, read(shader)?)))
            .collect::<Result<BTreeMap<Stage, Vec<Arc<Image>>>, Vec<Diagnostic>>>(
        )?;
        let (view, center) = (&scene.view, scene.placed[number].center);
        Ok(Draw {
            object: object.id.clone(),
            mesh: object.mesh.clone(),
            indices: part.indices.clone(),
            look_name: self.look.name.clone(),
            look: shaders.draw.clone(),
            before,
            object_uniform: object_uniform(
                object.world_from_object,
                number as f64,
                f64::from(part.alpha_cutoff.unwrap_or(0.0)),
            ),
            look_uniforms: values.uniforms,
            decided: values.decided,
            images,
            images_before,
            // A solid is seen from behind by an eye within, and through parts that a look cuts
            // away.
            two_sided: part.two_sided || values.cuts || view.eye.distance(center) < object.radius(),
            is_mirrored: object.world_from_object.determinant() < 0.0,
            depth_first,
            distance: view.backward.dot(view.eye - center),
        })
    }

    /// The surroundings of the object and the time, which decide between keys.
    fn rig_inputs(&self) -> RigInputs<'_> {
        let PlacedScene { setup, options, view, placed, .. } = self.scene;
        let VisibleObject { number, object } = self.visible;
        let center = placed[number].center;
        let time = &setup.scene.time;
        RigInputs {
            time: options.time,
            illumination: DQuat::from_array(setup.scene.illumination).normalize(),
            camera_from_world: view.rotation(),
            view: view.toward_viewer(center),
            center,
            distance: view.eye.distance(center),
            front: object.world_from_object.transform_vector3(DVec3::Z),
            near: self.near,
            exposed: &object.values,
            lights: self.lights,
            viewport: options.size.map(f64::from),
            frame: ((options.time - time.start) * time.fps).round(),
            object_id: number as f64,
        }
    }

    /// The uniforms of the look's module and of the modules before it.
    fn values(
        &self,
        before: &BTreeMap<Stage, Arc<CompiledShader>>,
    ) -> Result<DrawValues, Diagnostic> {
        let shaders = self.shaders;
        let inputs = self.rig_inputs();
        let mut made = DrawValues::default();
        let modules = std::iter::once((shaders.draw.stage, &shaders.draw))
            .chain(before.iter().map(|(stage, shader)| (*stage, shader)));
        for (stage, shader) in modules {
            let Some(table) = shaders.tables.get(&stage) else { continue };
            let params = current_params(self.look, &shader.params);
            let wires = Wires::of(&shaders.draw);
            let mut values = shaders.rig.evaluate(&params, table, wires, &inputs)?;
            made.decided = std::mem::take(&mut values.decided);
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
            made.uniforms.insert(stage, shader.host.uniform(&host)?);
        }
        Ok(made)
    }
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
