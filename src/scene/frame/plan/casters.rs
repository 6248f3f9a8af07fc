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
    /// By the number of the object that is lit.
    receivers: HashMap<usize, LitBy>,
}

/// Shadows that reach an object, by their lights.
#[derive(Default)]
struct LitBy {
    /// The casters of each light that may be about it.
    numbers: HashMap<LightId, f64>,
    /// A hash of them.
    key: u64,
}

impl LitBy {
    fn new(numbers: HashMap<LightId, f64>) -> Self {
        let mut hasher = DefaultHasher::new();
        let mut sorted: Vec<_> = numbers.iter().map(|(id, x)| (id, x.to_bits())).collect();
        sorted.sort_unstable();
        sorted.hash(&mut hasher);
        Self { key: hasher.finish(), numbers }
    }
}

impl PlannedCasters {
    /// The casters of each light that may be about an object.
    pub(super) fn of(&self, object: usize) -> Option<&HashMap<LightId, f64>> {
        self.receivers.get(&object).map(|lit_by| &lit_by.numbers)
    }

    /// A hash that is the same for objects which every light's shadows reach alike.
    pub(super) fn key(&self, object: usize) -> u64 {
        self.receivers.get(&object).map_or(0, |lit_by| lit_by.key)
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
        let is_of_light = match self {
            Self::Of(lights, _) => lights.contains(light),
            Self::None | Self::All => true,
        };
        is_of_light && self.reach(onto)
    }

    /// True if the object casts the shadow of any light onto another, or onto itself.
    fn reach(&self, onto: &ObjectId) -> bool {
        match self {
            Self::None => false,
            Self::All => true,
            Self::Of(_, objects) => objects.contains(onto),
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
        let set_of = |casts: &dyn Fn(&usize) -> bool| -> Vec<usize> {
            (0..objects.len()).filter(casts).collect()
        };
        // Without links one set serves all.
        let is_linked = shadows.iter().any(|shadows| matches!(shadows, Shadows::Of(..)));
        let mut occluders: HashMap<usize, usize> = HashMap::new();
        for receiver in readers {
            let onto = &objects[receiver].id;
            let around = match is_linked || sets.is_empty() {
                true => sets.insert_full(set_of(&|caster| shadows[*caster].reach(onto))).0,
                false => 0,
            };
            occluders.insert(receiver, around);
            let dark = unlit(scene.setup, &scene.mix, &objects[receiver]);
            for light in lights.keys().filter(|light| !dark.contains_key(*light)) {
                let set = match is_linked {
                    true => sets.insert_full(set_of(&|c| shadows[*c].fall(light, onto))).0,
                    false => around,
                };
                let onto_itself = sets[set].binary_search(&receiver).is_ok();
                found.push((receiver, light, set, onto_itself));
            }
        }
        let texture =
            Casters::new(objects, &scene.placed, &sets, &occluders).map_err(|p| vec![p])?;
        let mut numbers: HashMap<usize, HashMap<LightId, f64>> = HashMap::new();
        for (receiver, light, set, onto_itself) in found {
            let number = texture.number(&sets[set], onto_itself);
            numbers.entry(receiver).or_default().insert(light.clone(), number);
        }
        let lit_by = |(receiver, numbers)| (receiver, LitBy::new(numbers));
        let receivers = numbers.into_iter().map(lit_by).collect();
        Ok(Some(PlannedCasters { texture: Arc::new(texture), receivers }))
    }
}
