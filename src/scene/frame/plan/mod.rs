//! The frame plan, which a renderer executes.
//!
//! [`Planner::plan`] makes a plan in phases, each in a module of its own: `placement` places
//! objects and camera and leaves out what is not seen, `variants` compiles every module of every
//! look that is wanted, `passes` joins the passes that anything reads, `draws` computes the
//! uniforms, each look's once where no object has others, `order` puts draws of one look side by
//! side, and `deferral` chooses how looks are drawn. `omissions` lists what was left out, and
//! `images` reads what modules sample. `look_inputs` tells which
//! pixels of one plan's picture another plan's has too.

mod casters;
mod deferral;
mod draws;
mod images;
mod key;
mod look_inputs;
mod omissions;
mod order;
mod passes;
mod placement;
mod planner;
mod style;
mod variants;
mod warnings;

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use super::aovs::AovLayer;
use super::assets::Image;
use super::camera::View;
use super::casters::Casters;
use super::cost::EffectCost;
use super::coverage::PixelArea;
use super::deferred::Deferral;
use super::effects::EffectKind;
use super::screen::Ink;
use super::shadow_maps::ShadowMaps;
use crate::compile::{CompiledShader, Proof, Uniform};
use crate::geometry::Mesh;
use crate::ids::ObjectId;
use crate::library::{PassId, Stage};

pub(super) use draws::current_params;
pub(super) use images::images;
pub use images::named_map;
pub use look_inputs::LookInputs;
pub use planner::Planner;
pub use style::PlanStyle;

/// Options of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanOptions {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Number of samples a pixel: 1 or 4.
    pub samples: u32,
    /// Time, in seconds.
    pub time: f64,
}

/// A pass with its reason.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Pass {
    /// The pass.
    #[serde(rename = "kind")]
    pub id: PassId,
    /// Reason why the pass is in the plan.
    pub reason: String,
    /// Hash of everything that the pass reads: the same hash gives the same result.
    pub input_hash: u64,
}

/// An effect that the plan does without.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct DroppedEffect {
    /// Name of the effect.
    pub what: String,
    /// Reason why the effect is not needed.
    pub why: String,
    /// Kind of the effect.
    pub kind: EffectKind,
    /// Proof that nothing is lost.
    pub proof: Proof,
    /// Name of the look that the effect belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub look: Option<String>,
    /// Cost that the effect would have, as far as known.
    pub cost: EffectCost,
}

/// A part of an object, to be drawn.
#[derive(Clone, Debug)]
pub struct Draw {
    /// The object.
    pub object: ObjectId,
    /// Mesh of the object.
    pub mesh: Arc<Mesh>,
    /// Range of the mesh's indices that are drawn.
    pub indices: Range<u32>,
    /// Name of the look.
    pub look_name: String,
    /// Module of the look.
    pub look: Arc<CompiledShader>,
    /// Modules of the look for passes before it, by stage.
    pub before: BTreeMap<Stage, Arc<CompiledShader>>,
    /// The `Object` uniform.
    pub object_uniform: Uniform,
    /// The `Look` uniforms, one for each module, by stage; draws of the same values share them.
    pub look_uniforms: HashMap<Stage, Arc<Uniform>>,
    /// Direction that decides, and the weight of each key, for each set of the look's direction
    /// keys.
    pub decided: Vec<(DVec3, Vec<f64>)>,
    /// Images of the look's module, in the order of its needs.
    pub images: Vec<Arc<Image>>,
    /// Images of the modules before the look's own, in the order of their needs, by stage.
    pub images_before: BTreeMap<Stage, Vec<Arc<Image>>>,
    /// True if back faces are drawn.
    pub two_sided: bool,
    /// True if the object's transform mirrors it, so that triangles run the other way around.
    pub is_mirrored: bool,
    /// True if its depth is to be drawn before any look: it hides all that is behind it, and its
    /// pixels are dear.
    pub depth_first: bool,
    /// Distance from the eye along the line of sight, for drawing transparent parts from back to
    /// front.
    pub distance: f64,
    /// Pixels that may show it.
    pub area: PixelArea,
}

impl Draw {
    /// The module of a stage that draws meshes; `None` where the plan does without that stage.
    pub fn module(&self, stage: Stage) -> Option<&Arc<CompiledShader>> {
        if stage == self.look.stage { Some(&self.look) } else { self.before.get(&stage) }
    }

    /// All modules, the look's own first.
    pub fn modules(&self) -> impl Iterator<Item = &Arc<CompiledShader>> {
        std::iter::once(&self.look).chain(self.before.values())
    }

    /// The images of the module of `stage`, in the order of the module's needs.
    pub fn images_of(&self, stage: Stage) -> &[Arc<Image>] {
        match self.images_before.get(&stage) {
            Some(images) => images,
            None if self.before.contains_key(&stage) => &[],
            None => &self.images,
        }
    }
}

/// A plan with everything that a renderer needs for one picture.
#[derive(Clone, Debug)]
pub struct FramePlan {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Number of samples a pixel.
    pub samples: u32,
    /// Color behind everything, straight RGBA; `None` for transparent.
    pub backdrop: Option<[f64; 4]>,
    /// Lines over the picture; `None` where the scene draws none.
    pub ink: Option<Ink>,
    /// The camera.
    pub view: View,
    /// Pixels in which objects may be seen.
    pub covered: PixelArea,
    /// Triangles that cast shadows; `None` where no look reads them.
    pub casters: Option<Arc<Casters>>,
    /// The scene as lights see it; `None` where no look reads it.
    pub shadow_maps: Option<Arc<ShadowMaps>>,
    /// Draws, back to front where their order can be seen, else one look after another.
    pub draws: Vec<Draw>,
    /// Passes, in the order in which they run.
    pub passes: Vec<Pass>,
    /// Deferred drawing of the looks, or the reason why they are drawn triangle by triangle (empty
    /// where no surface is drawn before them). The picture is the same; the reference draws
    /// triangles.
    pub deferral: Result<Deferral, String>,
    /// Layers beside the picture, which every look's module writes.
    pub aovs: Vec<AovLayer>,
    /// Effects that were left out.
    pub dropped: Vec<DroppedEffect>,
}

impl FramePlan {
    /// The plan of `pass` alone, with the passes over the picture that it reads: whoever runs it
    /// has the [images of meshes](Self::missing) already.
    pub fn of_screens(pass: PassId, view: View, size: [u32; 2]) -> Self {
        let mut passes = vec![pass];
        for before in PassId::all().rev().filter(|before| before.is_screen()) {
            if passes.iter().any(|pass| pass.reads(before)) {
                passes.push(before);
            }
        }
        let planned =
            |id: PassId| Pass { id, reason: id.row().purpose.tr().to_owned(), input_hash: 0 };
        Self {
            size,
            samples: 1,
            backdrop: None,
            ink: None,
            view,
            covered: PixelArea::whole(size),
            casters: None,
            shadow_maps: None,
            draws: Vec::new(),
            passes: passes.into_iter().rev().map(planned).collect(),
            deferral: Err(String::new()),
            aovs: Vec::new(),
            dropped: Vec::new(),
        }
    }

    /// The draws of the pass of `stage` in lists: each has one module, the same images and sides.
    pub fn draw_lists(&self, stage: Stage) -> impl Iterator<Item = &[Draw]> {
        let lists = self.draws.chunk_by(move |draw, next| draw.shares_list(next, stage));
        lists.filter(move |draws| draws[0].module(stage).is_some())
    }

    /// Pixels outside of which every pass over the picture results in 0: it need not run there.
    pub fn screen_area(&self) -> PixelArea {
        // Pixels at an outline take the values of a neighbor, in each pass once more.
        let passes = self.passes.iter().filter(|pass| pass.id.is_screen()).count();
        let over = self.passes.iter().filter(|pass| pass.id.is_over());
        let reach = over.map(|pass| pass.id.own_reach() * self.view.step_pixels()).max();
        self.covered.widened(1 + passes as u32 + reach.unwrap_or_default(), self.size)
    }

    /// The passes whose results the plan's passes read, and that the plan does not have.
    pub fn missing(&self) -> impl Iterator<Item = PassId> {
        let is_read = |pass: PassId| self.passes.iter().any(|reader| reader.id.reads(pass));
        let is_planned = |pass: PassId| self.passes.iter().any(|planned| planned.id == pass);
        PassId::all().filter(move |pass| is_read(*pass) && !is_planned(*pass))
    }

    /// The distance to which the plan's passes look around in images that meshes are drawn into, in
    /// pixels.
    pub fn reach(&self) -> usize {
        let steps = self.passes.iter().map(|pass| pass.id.reach()).max().unwrap_or_default();
        (steps * self.view.step_pixels()) as usize
    }

    /// The distance around a pixel within which the plan's passes read the result of `pass`, which
    /// must be known there for the picture to be whole at that pixel. In pixels.
    ///
    /// Quads are whole, and at an outline a pass may take a neighbor for its pixel, so that each
    /// reads one more.
    pub fn margin(&self, pass: PassId) -> u32 {
        let readers = self.passes.iter().filter(|reader| reader.id.reads(pass));
        let around = readers
            .map(|reader| self.margin(reader.id) + reader.id.own_reach() * self.view.step_pixels());
        1 + around.max().unwrap_or_default()
    }
}
