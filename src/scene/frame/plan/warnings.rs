//! Warnings about oddities of a scene that stop nothing.

use std::cell::LazyCell;
use std::collections::{BTreeSet, HashMap, HashSet};

use chiaro_locale::tr;

use super::placement::{PlacedScene, VisibleObject};
use super::planner::Planner;
use super::variants::{LookShaders, Variants};
use crate::diag::Diagnostic;
use crate::document::{Driver, KeyDirection};
use crate::frame::links::{idle_links, located};
use crate::frame::setup::{Setup, SetupLook};
use crate::frame::uvs::{self, MissingInput};
use crate::ids::ObjectId;

impl Planner {
    /// The warnings about the visible objects and their looks, each once.
    pub(super) fn warnings(
        &mut self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        variants: &Variants,
    ) -> Vec<Diagnostic> {
        let mut found = Vec::new();
        let mut seen = HashSet::new();
        for VisibleObject { number, object } in visible {
            let worn =
                object.looks.iter().flatten().filter_map(|look| variants.get(&(*number, *look)));
            let shaders = worn.filter(|variant| seen.insert(variant.key));
            let shaders = shaders.filter_map(|variant| self.shaders.get(&variant.key));
            found.extend(shaders.flat_map(|shaders| shaders.warnings.iter().cloned()));
        }
        found.extend(self.lacking_uvs(scene, visible, variants));
        found.extend(scene.setup.mix_warnings());
        found.extend(scene.setup.aim_warnings());
        found.extend(scene_key_warnings(scene));
        let ids = LazyCell::new(|| ids_of(scene.setup));
        for VisibleObject { object, .. } in visible {
            found.extend(idle_links(scene.setup, object));
            for look in object.worn_looks() {
                let look = &scene.setup.looks[look];
                let is_there = |id: &ObjectId| ids.contains(id);
                found.extend(missing_objects(scene.setup, look, &object.id, &is_there));
            }
        }
        each_once(found)
    }

    /// Warnings of objects whose looks read UVs, or the tangents along them, where the meshes have
    /// no UVs.
    fn lacking_uvs(
        &mut self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        variants: &Variants,
    ) -> Vec<Diagnostic> {
        let mut found = Vec::new();
        self.uv_readers.retain(|key, _| self.used.contains(key));
        for VisibleObject { number, object } in visible.iter().filter(|of| !of.object.mesh.has_uvs)
        {
            for &index in object.looks.iter().flatten().collect::<BTreeSet<_>>() {
                let look = &scene.setup.looks[index];
                let Some(variant) = variants.get(&(*number, index)) else { continue };
                let Some(LookShaders { draw, .. }) = self.shaders.get(&variant.key) else {
                    continue;
                };
                let Some(lack) = MissingInput::of(draw) else { continue };
                let readers = self
                    .uv_readers
                    .entry(variant.key)
                    .or_insert_with(|| uvs::readers(look, draw, lack, scene.library));
                found.push(uvs::without_uvs(object, look, lack, readers));
            }
        }
        found
    }
}

/// Warnings of the keys of the scene's lights: of keys that lie too close, and of objects that are
/// not in the scene.
fn scene_key_warnings(scene: &PlacedScene<'_>) -> Vec<Diagnostic> {
    let Some(rig) = &scene.rig else { return Vec::new() };
    let setup = scene.setup;
    let own = |problem: &Diagnostic| {
        let path = problem.place.json_path.clone().unwrap_or_default();
        located(setup, problem.clone(), path)
    };
    let mut found: Vec<Diagnostic> = rig.warnings.iter().map(own).collect();
    let ids = ids_of(setup);
    for (index, set) in setup.scene.direction_keys.iter().enumerate() {
        let KeyDirection::Drivers(drivers) = &set.by else { continue };
        for driver in drivers {
            let Driver::Near(id) = driver else { continue };
            if !ids.contains(id) {
                let message = tr!("there is no object `{id}` in the scene");
                let problem = Diagnostic::warning("unknown-object", message)
                    .suggest(id.as_str(), setup.objects.iter().map(|object| object.id.as_str()))
                    .hint(tr!("until there is, it counts as far away"));
                found.push(located(setup, problem, format!("direction_keys[{index}].by")));
            }
        }
    }
    found
}

fn ids_of(setup: &Setup) -> HashSet<&ObjectId> {
    setup.objects.iter().map(|object| &object.id).collect()
}

/// The problems in their order, without those that were there before.
fn each_once(found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut places: HashMap<String, Vec<usize>> = HashMap::new();
    let mut each_once: Vec<Diagnostic> = Vec::new();
    for problem in found {
        let alike = places.entry(problem.message.clone()).or_default();
        if !alike.iter().any(|&place| each_once[place] == problem) {
            alike.push(each_once.len());
            each_once.push(problem);
        }
    }
    each_once
}

/// Warnings of keys that go by the distance to an object that is not in the scene.
fn missing_objects(
    setup: &Setup,
    look: &SetupLook,
    own: &ObjectId,
    is_there: &dyn Fn(&ObjectId) -> bool,
) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (index, set) in look.look.direction_keys.iter().enumerate() {
        let KeyDirection::Drivers(drivers) = &set.by else { continue };
        for driver in drivers {
            let Driver::Near(id) = driver else { continue };
            if *id != *own && is_there(id) {
                continue;
            }
            let is_own = *id == *own;
            let message = if is_own {
                tr!("object `{id}` wears a look whose keys go by how near it is to itself")
            } else {
                tr!("there is no object `{id}` in the scene")
            };
            let ids = setup.objects.iter().map(|object| &object.id).filter(|other| *other != own);
            let known: Vec<String> = ids.take(8).map(|id| format!("`{id}`")).collect();
            let hint = if known.is_empty() {
                tr!("add another object to the scene, or let something else decide").to_owned()
            } else {
                tr!(
                    "other objects are {names}; until then it counts as far away",
                    names = known.join(", ")
                )
            };
            let mut problem = Diagnostic::warning("unknown-object", message)
                .json_path(format!("direction_keys[{index}].by"))
                .hint(hint);
            look.source.locate(&mut problem);
            found.push(problem);
        }
    }
    found
}
