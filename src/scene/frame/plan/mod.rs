//! The frame plan: what a renderer executes.
//!
//! [`Planner::plan`] makes one in phases, each in a room of its own: `placement` places objects
//! and camera and leaves out what is not seen, `variants` compiles every module of every look that
//! is wanted, `passes` joins the passes that anybody reads, `draws` computes each object's
//! uniforms. `omissions` tells what was left out, and `images` reads what modules sample.

mod draws;
mod images;
mod key;
mod omissions;
mod passes;
mod placement;
mod planner;
mod variants;
mod warnings;

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use super::assets::Image;
use super::camera::View;
use super::cost::EffectCost;
use super::effects::EffectKind;
use crate::compile::{CompiledShader, Proof, Uniform};
use crate::geometry::Mesh;
use crate::ids::ObjectId;
use crate::library::{PassId, Stage};

pub(super) use images::images;
pub use planner::Planner;

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

/// A pass with its reason.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Pass {
    /// Which one.
    #[serde(rename = "kind")]
    pub id: PassId,
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
    /// The look's modules of passes before it, by stage.
    pub before: BTreeMap<Stage, Arc<CompiledShader>>,
    /// The `Object` uniform.
    pub object_uniform: Uniform,
    /// The `Look` uniform; one for each module, by stage.
    pub look_uniforms: HashMap<Stage, Uniform>,
    /// For each set of the look's direction keys what decides, and the weight of each of its keys.
    pub decided: Vec<(DVec3, Vec<f64>)>,
    /// The images of the look's module, in the order of its needs.
    pub images: Vec<Arc<Image>>,
    /// The same of the modules before it.
    pub images_before: BTreeMap<Stage, Vec<Arc<Image>>>,
    /// Whether back faces are drawn.
    pub two_sided: bool,
    /// Whether the object's transform mirrors it, so that triangles run the other way around.
    pub is_mirrored: bool,
    /// From the eye, for drawing what is transparent from back to front.
    pub distance: f64,
}

impl Draw {
    /// The module of a stage that draws meshes; `None` where the plan does without that stage.
    pub fn module(&self, stage: Stage) -> Option<&Arc<CompiledShader>> {
        if stage == Stage::Draw { Some(&self.look) } else { self.before.get(&stage) }
    }

    /// Every module, the look's own first.
    pub fn modules(&self) -> impl Iterator<Item = &Arc<CompiledShader>> {
        std::iter::once(&self.look).chain(self.before.values())
    }

    /// The images of one of its modules, in the order of the module's needs.
    pub fn images_of(&self, stage: Stage) -> &[Arc<Image>] {
        match self.images_before.get(&stage) {
            Some(images) => images,
            None if self.before.contains_key(&stage) => &[],
            None => &self.images,
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
    /// How far its passes look around in what meshes are drawn into, in pixels.
    pub fn reach(&self) -> usize {
        let steps = self.passes.iter().map(|pass| pass.id.reach()).max().unwrap_or_default();
        (steps * self.view.step_pixels()) as usize
    }

    /// How many pixels its passes look around beyond a pixel in what `pass` makes: what must be
    /// known there for the picture to be whole at that pixel.
    ///
    /// Quads are whole, and at an outline a pass may take a neighbour for its pixel, so that each
    /// reads one more.
    pub fn margin(&self, pass: PassId) -> u32 {
        let readers = self.passes.iter().filter(|reader| reader.id.reads(pass));
        let around = readers
            .map(|reader| self.margin(reader.id) + reader.id.own_reach() * self.view.step_pixels());
        1 + around.max().unwrap_or_default()
    }
}
