//! Shadows of a picture: which objects cast those of which lights onto which objects.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use indexmap::{IndexMap, IndexSet};

use super::placement::{PlacedScene, VisibleObject};
use super::planner::Planner;
use super::variants::Variants;
use crate::diag::Diagnostic;
use crate::document::Light;
use crate::frame::casters::Casters;
use crate::frame::links::unlit;
use crate::frame::setup::{Setup, SetupObject};
use crate::ids::{LightId, ObjectId};

/// Casters of a picture, with the numbers by which lights know theirs.
pub(super) struct PlannedCasters {
    pub(super) texture: Arc<Casters>,
    /// By the number of the object that is lit: the casters of each light.
    numbers: HashMap<usize, HashMap<LightId, f64>>,
}

impl PlannedCasters {
    /// The casters of each light that may be about an object.
    pub(super) fn of(&self, object: usize) -> Option<&HashMap<LightId, f64>> {
        self.numbers.get(&object)
    }

    /// A hash that is the same for objects which every light's shadows reach alike.
    pub(super) fn key(&self, object: usize) -> u64 {
        let mut hasher = DefaultHasher::new();
        if let Some(numbers) = self.numbers.get(&object) {
            let mut numbers: Vec<_> = numbers.iter().map(|(id, x)| (id, x.to_bits())).collect();
            numbers.sort_unstable();
            numbers.hash(&mut hasher);
        }
        hasher.finish()
    }
}

/// Shadows of an object.
enum Shadows {
    /// No shadows.
    None,
    /// Shadows of all lights, onto all objects.
    All,
    /// Shadows of these lights, onto these objects.
    Of(BTreeSet<LightId>, BTreeSet<ObjectId>),
}

impl Shadows {
    /// Shadows of an object, among all lights; what wears no look casts none.
    fn of(object: &SetupObject, setup: &Setup, lights: &IndexMap<LightId, Light>) -> Self {
        let link = &object.shadow_link;
        if object.worn_looks().next().is_none() {
            Self::None
        } else if link.is_all() {
            Self::All
        } else {
            Self::Of(link.lights(lights), link.objects(&setup.scene.objects))
        }
    }

    /// True if the object casts the shadow of a light onto another, or onto itself.
    fn fall(&self, light: &LightId, onto: &ObjectId) -> bool {
        match self {
            Self::None => false,
            Self::All => true,
            Self::Of(lights, objects) => lights.contains(light) && objects.contains(onto),
        }
    }
}

impl Planner {
    /// The casters that looks of visible objects read; `None` where none do.
    pub(super) fn casters(
        &self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        variants: &Variants,
    ) -> Result<Option<PlannedCasters>, Vec<Diagnostic>> {
        let reads = |number: usize, look: usize| {
            let shaders = variants.get(&(number, look)).and_then(|v| self.shaders.get(&v.key));
            shaders.is_some_and(|shaders| {
                shaders.draw.needs.casters || shaders.before.values().any(|s| s.needs.casters)
            })
        };
        let readers: HashSet<usize> = visible
            .iter()
            .filter(|v| v.object.worn_looks().any(|look| reads(v.number, look)))
            .map(|visible| visible.number)
            .collect();
        if readers.is_empty() {
            return Ok(None);
        }
        let objects = &scene.setup.objects;
        let lights = scene.setup.all_lights();
        let mut sets: IndexSet<Vec<usize>> = IndexSet::new();
        let mut found: Vec<(usize, &LightId, usize, bool)> = Vec::new();
        let shadows: Vec<Shadows> =
            objects.iter().map(|object| Shadows::of(object, scene.setup, &lights)).collect();
        for receiver in readers {
            let dark = unlit(scene.setup, &scene.mix, &objects[receiver]);
            for light in lights.keys().filter(|light| !dark.contains_key(*light)) {
                let casts = |caster: &usize| shadows[*caster].fall(light, &objects[receiver].id);
                let set: Vec<usize> = (0..objects.len()).filter(casts).collect();
                let onto_itself = set.binary_search(&receiver).is_ok();
                let (set, _) = sets.insert_full(set);
                found.push((receiver, light, set, onto_itself));
            }
        }
        let texture = Casters::new(objects, &scene.placed, &sets).map_err(|p| vec![p])?;
        let mut numbers: HashMap<usize, HashMap<LightId, f64>> = HashMap::new();
        for (receiver, light, set, onto_itself) in found {
            let number = texture.number(&sets[set], onto_itself);
            numbers.entry(receiver).or_default().insert(light.clone(), number);
        }
        Ok(Some(PlannedCasters { texture: Arc::new(texture), numbers }))
    }
}
