//! Model of a look at chosen pixels, as a function of its knobs.
//!
//! The look is compiled with its knobs as uniforms and all else folded, and its picture is drawn
//! once by the reference, which keeps the fragments of the chosen pixels ([`GatheredFragments`]). A
//! step then runs only the host's programs in f64 and the fragment shader of these pixels: it gives
//! exactly the picture's own numbers, at a thousandth of its cost.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

use glam::{DQuat, DVec3};
use indexmap::IndexMap;

use super::choose::{evenly, telling};
use super::knobs::Knob;
use super::solve::LeastSquares;
use super::state::KnobSetting;
use super::target::PixelGoal;
use crate::compile::{HostInputs, Live, Param, ParamId};
use crate::diag::Diagnostic;
use crate::document::{AimPlaces, Light, ObjectFrame, Values};
use crate::frame::{
    Assets, CompiledShader, ParamTable, PlanOptions, Planner, Rig, RigInputs, SceneRig, Setup,
    Wires,
};
use crate::ids::{LightId, ObjectId};
use crate::library::Library;
use crate::progress::Progress;
use crate::reference::{GatheredFragments, PixelSheet, ReferenceOptions};

/// Scene, look, size and time of a picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct FitShot<'a> {
    pub(super) setup: &'a Setup,
    /// Index of the look in the setup.
    pub(super) look: usize,
    pub(super) library: &'a Library,
    /// Width and height, in pixels.
    pub(super) size: [u32; 2],
    /// Time of the picture, in seconds.
    pub(super) time: f64,
}

/// One draw that wears the look.
#[derive(Debug)]
struct FitDraw {
    draw: usize,
    /// Index and center of the object.
    object: (usize, DVec3),
    /// Front of the object, and distances of other objects.
    front: DVec3,
    turn: DQuat,
    near: IndexMap<ObjectId, f64>,
    shader: Arc<CompiledShader>,
    table: ParamTable,
    /// Parameters of each knob, by the knob's inputs.
    ids: Vec<Vec<Option<ParamId>>>,
    exposed: Values,
}

/// A look at chosen pixels.
#[derive(Debug)]
pub(super) struct Model {
    gathered: GatheredFragments,
    parts: Vec<FitDraw>,
    pub(super) knobs: Vec<Knob>,
    rig: Rig,
    lights: IndexMap<LightId, Light>,
    scene_lights: IndexMap<LightId, Light>,
    scene_rig: Option<Arc<SceneRig>>,
    aims: Arc<AimPlaces>,
    illumination: DQuat,
    time: [f64; 2],
    /// The gathered pixels that can be compared: those of draws that wear the look, and not at the
    /// edges of the draws.
    pub(super) pixels: Vec<[u32; 2]>,
    /// Indices of `pixels` among the gathered pixels.
    places: Vec<usize>,
}

impl Model {
    /// The look of `shot` at the `chosen` pixels, with `knobs` to be turned.
    ///
    /// # Errors
    /// Problems of the look, and shaders that the interpreter cannot run.
    pub(super) fn new(
        shot: &FitShot<'_>,
        knobs: Vec<Knob>,
        chosen: &HashSet<[u32; 2]>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let mut setup = shot.setup.clone();
        setup.edited = Some(shot.look);
        let touched = knobs.iter().flat_map(Knob::inputs).collect();
        let options = PlanOptions { size: shot.size, samples: 1, time: shot.time };
        let mut planner = Planner::new(Assets::default()).culling(crate::frame::CullMode::Objects);
        let plan = planner.plan(&setup, shot.library, &Live::Touched(touched), &options)?.value;
        let look = &setup.looks[shot.look].look;
        let mut parts = Vec::new();
        for (number, draw) in plan.draws.iter().enumerate() {
            let Some((index, object)) =
                setup.objects.iter().enumerate().find(|(_, o)| o.id == draw.object)
            else {
                continue;
            };
            let worn = object
                .mesh
                .parts
                .iter()
                .zip(&object.looks)
                .find(|(part, _)| part.indices == draw.indices);
            if worn.is_none_or(|(_, look)| *look != Some(shot.look)) {
                continue;
            }
            let table = ParamTable::new(&draw.look.params);
            let ids = |knob: &Knob| {
                knob.inputs().iter().map(|(node, port)| table.find(node, port)).collect()
            };
            parts.push(FitDraw {
                draw: number,
                object: (index, object.center()),
                front: object.world_from_object.transform_vector3(DVec3::Z),
                turn: ObjectFrame::new(DVec3::ZERO, object.world_from_object).turn,
                near: setup.others_of(object),
                shader: draw.look.clone(),
                ids: knobs.iter().map(ids).collect(),
                table,
                exposed: object.values.clone(),
            });
        }
        let time =
            [shot.time, ((shot.time - setup.scene.time.start) * setup.scene.time.fps).round()];
        let (rig, lights) = (Rig::new(look).value, look.lights.clone());
        let is_chosen = |pixel: [u32; 2]| chosen.contains(&pixel);
        let gathered = GatheredFragments::new(
            plan,
            &is_chosen,
            &ReferenceOptions::default(),
            &Progress::new(),
        )
        .map_err(|one| vec![one])?;
        let wears = |index: &usize| {
            let seen = gathered.seen[*index];
            parts.iter().any(|part| part.draw == seen.draw) && !is_edge(&gathered, seen.pixel)
        };
        let places: Vec<usize> = (0..gathered.seen.len()).filter(wears).collect();
        let pixels = places.iter().map(|&index| gathered.seen[index].pixel).collect();
        let illumination = setup.illumination();
        let scene_rig = SceneRig::of(&setup.scene, None);
        let aims = setup.aims();
        let scene_lights = setup.scene.lights;
        Ok(Self {
            gathered,
            parts,
            knobs,
            rig,
            lights,
            scene_lights,
            scene_rig,
            aims,
            illumination,
            time,
            pixels,
            places,
        })
    }

    /// Indices of all pixels.
    pub(super) fn all(&self) -> Vec<usize> {
        (0..self.pixels.len()).collect()
    }

    /// Indices in [`pixels`](Self::pixels) that tell most about what is `missing` at each pixel, of
    /// up to `most` quads: a quad is shaded whole, whichever of its pixels are looked at.
    pub(super) fn telling(&self, missing: &[f64], most: usize) -> Vec<usize> {
        let quads = self.quads();
        let of_quad = |quad: &Vec<usize>| {
            quad.iter().map(|&place| missing.get(place).copied().unwrap_or(0.0)).sum()
        };
        let missing: Vec<f64> = quads.iter().map(of_quad).collect();
        of_quads(&quads, telling(&missing, most))
    }

    /// Indices in [`pixels`](Self::pixels) of up to `most` quads, evenly spread, which stand for
    /// all pixels.
    pub(super) fn even(&self, most: usize) -> Vec<usize> {
        let quads = self.quads();
        of_quads(&quads, evenly(quads.len(), most))
    }

    /// Indices in [`pixels`](Self::pixels) grouped by quad.
    fn quads(&self) -> Vec<Vec<usize>> {
        let mut quads: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (place, &index) in self.places.iter().enumerate() {
            quads.entry(self.gathered.seen[index].quad()).or_default().push(place);
        }
        quads.into_values().collect()
    }

    /// Unit vector from the point seen in the middle of a pixel toward the viewer, in world space.
    pub(super) fn toward_viewer(&self, [x, y]: [u32; 2]) -> DVec3 {
        let (view, [width, height]) =
            (&self.gathered.plan().view, self.gathered.plan().size.map(f64::from));
        let (across, up) =
            ((2.0 * f64::from(x) + 1.0) / width - 1.0, 1.0 - (2.0 * f64::from(y) + 1.0) / height);
        view.toward_viewer(
            view.clip_from_world.inverse().project_point3(DVec3::new(across, up, 0.5)),
        )
    }

    /// Some of the pixels, by their indices in [`pixels`](Self::pixels), ready to be shaded.
    pub(super) fn sheet(&self, chosen: &[usize]) -> PixelSheet {
        let places: Vec<usize> = chosen.iter().map(|&index| self.places[index]).collect();
        self.gathered.sheet(&places)
    }

    /// The colors of a sheet, straight and display-referred, over the scene's backdrop where the
    /// look is transparent.
    ///
    /// # Errors
    /// Shaders that do not end.
    pub(super) fn colors(
        &self,
        sheet: &PixelSheet,
        state: &[KnobSetting],
    ) -> Result<Vec<[f64; 3]>, Diagnostic> {
        let plan = self.gathered.plan();
        let mut numbers: Vec<Vec<f64>> = plan.draws.iter().map(plan_numbers).collect();
        for part in &self.parts {
            numbers[part.draw] = self.numbers(part, state)?;
        }
        let shaded = self.gathered.shade(sheet, &numbers)?;
        let over = |[r, g, b, a]: [f64; 4]| match plan.backdrop {
            Some(behind) if a < 1.0 => {
                let rgb = [r, g, b];
                std::array::from_fn(|c| rgb[c] * a + behind[c] * behind[3] * (1.0 - a))
            }
            _ => [r, g, b],
        };
        Ok(shaded.into_iter().map(over).collect())
    }

    /// The numbers of the look's uniform on one draw.
    fn numbers(&self, part: &FitDraw, state: &[KnobSetting]) -> Result<Vec<f64>, Diagnostic> {
        let plan = self.gathered.plan();
        let mut lights = self.lights.clone();
        for (knob, setting) in self.knobs.iter().zip(state) {
            if let (Knob::Direction(id), KnobSetting::Direction(direction)) = (knob, setting)
                && let Some(light) = lights.get_mut(id)
            {
                light.direction = direction.to_array();
            }
        }
        lights.extend(self.scene_lights.iter().map(|(id, light)| (id.clone(), light.clone())));
        let (number, center) = part.object;
        let none = HashMap::new();
        let inputs = RigInputs {
            time: self.time[0],
            illumination: self.illumination,
            camera_from_world: plan.view.rotation(),
            view: plan.view.toward_viewer(center),
            center,
            distance: plan.view.eye.distance(center),
            front: part.front,
            turn: part.turn,
            near: &part.near,
            exposed: &part.exposed,
            lights: &lights,
            scene_values: &none,
            aims: &self.aims,
            viewport: plan.size.map(f64::from),
            frame: self.time[1],
            object_id: number as f64,
        };
        let scene_values =
            self.scene_rig.as_ref().map(|rig| rig.values(&inputs)).unwrap_or_default();
        let inputs = RigInputs { scene_values: &scene_values, ..inputs };
        let params: &[Param] = &part.shader.params;
        let mut values =
            self.rig.evaluate(params, &part.table, Wires::of(&part.shader), &inputs)?;
        // A knob is neither wired nor keyed, so nothing else has set its inputs.
        for ((knob, setting), ids) in self.knobs.iter().zip(state).zip(&part.ids) {
            let before = ids.first().copied().flatten().and_then(|id| values.params.get(&id));
            let new = knob.values(setting, before);
            values
                .params
                .extend(ids.iter().zip(new).filter_map(|(id, value)| Some(((*id)?, value))));
        }
        let host = HostInputs {
            params: &values.params,
            lights: &values.lights,
            camera_from_world: plan.view.rotation(),
            viewport: inputs.viewport,
            time: self.time[0],
            frame: inputs.frame,
            object_id: inputs.object_id,
        };
        Ok(part.shader.host.uniform(&host)?.numbers)
    }
}

/// The pixels of the quads `chosen`, in order.
fn of_quads(quads: &[Vec<usize>], chosen: Vec<usize>) -> Vec<usize> {
    let mut places: Vec<usize> = chosen.into_iter().flat_map(|quad| quads[quad].clone()).collect();
    places.sort_unstable();
    places
}

fn plan_numbers(draw: &crate::frame::Draw) -> Vec<f64> {
    draw.look_uniforms
        .get(&draw.look.stage)
        .map(|uniform| uniform.numbers.clone())
        .unwrap_or_default()
}

/// True if a pixel lies beside one with another draw on top: an antialiased picture has mixed their
/// colors there.
fn is_edge(gathered: &GatheredFragments, [x, y]: [u32; 2]) -> bool {
    let [width, height] = gathered.plan().size;
    let draw = |x: u32, y: u32| gathered.coverage[(y * width + x) as usize].draw;
    let around = |at: u32, size: u32| at.saturating_sub(1)..(at + 2).min(size);
    around(y, height).any(|v| around(x, width).any(|u| draw(u, v) != draw(x, y)))
}

/// The RMS of three channels.
pub(super) fn rms_of(channels: [f64; 3]) -> f64 {
    (channels.iter().map(|x| x * x).sum::<f64>() / 3.0).sqrt()
}

/// Distance of a look from the goals of some pixels, as a least squares problem.
#[derive(Debug)]
pub(super) struct LookProblem<'a> {
    pub(super) model: &'a Model,
    pub(super) sheet: PixelSheet,
    pub(super) goals: Vec<PixelGoal>,
    /// Error that a hard or narrow profile counts as.
    pub(super) soft: f64,
}

impl<'a> LookProblem<'a> {
    /// The problem for the pixels at the indices `chosen`; `goals` holds a goal for each of the
    /// model's pixels.
    pub(super) fn new(model: &'a Model, goals: &[PixelGoal], chosen: &[usize]) -> Self {
        let goals = chosen.iter().map(|&index| goals[index]).collect();
        Self { model, sheet: model.sheet(chosen), goals, soft: 0.0 }
    }

    /// The problem with a preference for broad and soft profiles where that costs less than `soft`,
    /// an RMS of a channel.
    #[must_use]
    pub(super) fn softly(self, soft: f64) -> Self {
        Self {
            soft: soft * (3.0 * self.goals.iter().map(|goal| goal.weight).sum::<f64>()).sqrt(),
            ..self
        }
    }
}

impl LeastSquares for LookProblem<'_> {
    type Point = Vec<KnobSetting>;

    fn room(&self, state: &Vec<KnobSetting>) -> Vec<[f64; 2]> {
        state.iter().flat_map(KnobSetting::room).collect()
    }

    fn moved(&self, state: &Vec<KnobSetting>, by: &[f64]) -> Result<Vec<KnobSetting>, Diagnostic> {
        let mut rest = by;
        let step = |setting: &KnobSetting| {
            let (own, others) = rest.split_at(setting.count());
            rest = others;
            if own.iter().all(|x| *x == 0.0) { *setting } else { setting.moved(own) }
        };
        Ok(state.iter().map(step).collect())
    }

    fn patience(&self) -> usize {
        4
    }

    fn residuals(&self, state: &Vec<KnobSetting>) -> Result<Vec<f64>, Diagnostic> {
        let colors = self.model.colors(&self.sheet, state)?;
        let residuals = colors.iter().zip(&self.goals).flat_map(|(color, goal)| {
            let root = goal.weight.sqrt();
            (0..3).map(move |c| root * (color[c] - goal.color[c]))
        });
        let hardness = state.iter().map(|setting| match setting {
            KnobSetting::Profile(shape) if self.soft > 0.0 => self.soft * shape.hardness(),
            _ => 0.0,
        });
        Ok(residuals.chain(hardness).collect())
    }
}
