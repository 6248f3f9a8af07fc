//! Shadows of a picture: which objects cast those of which lights onto which objects.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use chiaro_locale::tr;
use indexmap::{IndexMap, IndexSet};

use super::DroppedEffect;
use super::placement::{PlacedScene, VisibleObject};
use super::planner::Planner;
use super::variants::{LookShaders, Variants};
use crate::compile::{CompiledShader, LightValues, Needs, Proof};
use crate::diag::Diagnostic;
use crate::document::Light;
use crate::frame::casters::Casters;
use crate::frame::cost::EffectCost;
use crate::frame::effects::EffectKind;
use crate::frame::links::unlit;
use crate::frame::setup::{Setup, SetupObject};
use crate::frame::shadow_maps::{MapPlaces, MapScene, ShadowMaps};
use crate::frame::visibility::ObjectPlacement;
use crate::ids::{LightId, ObjectId};

/// Casters of a picture, with the numbers by which lights know theirs.
#[derive(Default)]
pub(super) struct PlannedCasters<'a> {
    /// Triangles that rays meet; `None` where none are sent.
    pub(super) texture: Option<Arc<Casters>>,
    objects: &'a [SetupObject],
    placed: &'a [ObjectPlacement],
    /// Sets of objects that cast some light's shadows.
    sets: IndexSet<Vec<usize>>,
    /// Maps of lights, as they are asked for.
    maps: RefCell<MapPlaces>,
    /// By the number of the object that is lit.
    receivers: HashMap<usize, LitBy>,
}

/// Casters of a light's shadows onto an object.
#[derive(Clone, Copy)]
struct LightCasters {
    /// [`LightValues::casters`].
    number: f64,
    /// Index of the set of objects.
    set: usize,
}

/// Casters of the shadows that reach an object, by their lights.
type CastersByLight = HashMap<LightId, LightCasters>;

/// Shadows that reach an object, by their lights.
#[derive(Default)]
struct LitBy {
    /// The casters of each light that may be about it.
    lights: CastersByLight,
    /// A hash of them.
    key: u64,
}

impl LitBy {
    fn new(lights: CastersByLight) -> Self {
        let mut hasher = DefaultHasher::new();
        let mut sorted: Vec<_> =
            lights.iter().map(|(id, light)| (id, light.number.to_bits(), light.set)).collect();
        sorted.sort_unstable();
        sorted.hash(&mut hasher);
        Self { key: hasher.finish(), lights }
    }
}

impl PlannedCasters<'_> {
    /// Tells the lights about an object what casts their shadows onto it: for rays, and for maps
    /// where the module reads a light's map.
    pub(super) fn tell(
        &self,
        object: usize,
        shader: &CompiledShader,
        lights: &mut IndexMap<LightId, LightValues>,
    ) {
        let Some(lit_by) = self.receivers.get(&object) else { return };
        // A lamp that is out casts no shadow, also where a module does not know that.
        let is_on = |light: &&mut LightValues| light.intensity() != 0.0;
        for (id, casters) in &lit_by.lights {
            if let Some(light) = lights.get_mut(id).filter(is_on) {
                light.casters = casters.number;
            }
        }
        if !shader.needs.shadow_maps() {
            return;
        }
        let scene = MapScene { objects: self.objects, placed: self.placed, sets: &self.sets };
        for id in shader.host.mapped_lights() {
            let light = lights.get_mut(id).filter(is_on);
            if let (Some(casters), Some(light)) = (lit_by.lights.get(id), light) {
                let place = self.maps.borrow_mut().place(&scene, light, casters.set);
                light.shadow_map = place;
            }
        }
    }

    /// The maps that lights asked for; none where no light did.
    ///
    /// # Errors
    /// `too-many-shadow-maps` for more layers than a GPU takes.
    pub(super) fn maps(&self, height: u32) -> Result<ShadowMaps, Diagnostic> {
        self.maps.take().maps(self.objects, height)
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

/// Object whose looks read casters.
struct ShadowReader {
    /// Number of the object.
    object: usize,
    /// Lights that reach it, and whose shadows its looks draw.
    lights: BTreeSet<LightId>,
    /// True if its looks ask what stands about it, whatever the light.
    reads_occluders: bool,
    /// True if its looks ask by rays.
    sends_rays: bool,
}

impl ShadowReader {
    /// True if no shadow falls on the object.
    fn is_free(&self) -> bool {
        self.lights.is_empty() && !self.reads_occluders
    }
}

/// The effect of casters that no light needs.
fn no_casters() -> DroppedEffect {
    DroppedEffect {
        what: tr!("shadow casters").to_owned(),
        why: tr!("no light whose shadows are drawn reaches an object").to_owned(),
        kind: EffectKind::Casters,
        proof: Proof::NoLight,
        look: None,
        cost: EffectCost::default(),
    }
}

impl Planner {
    /// The object with what its looks read of casters; `None` where they read none.
    fn shadow_reader(
        &self,
        scene: &PlacedScene<'_>,
        VisibleObject { number, object }: &VisibleObject<'_>,
        variants: &Variants,
    ) -> Option<ShadowReader> {
        let of_look = |look| self.shaders.get(&variants.get(&(*number, look))?.key);
        let looks: Vec<&LookShaders> = object.worn_looks().filter_map(of_look).collect();
        let modules = looks
            .iter()
            .flat_map(|shaders| std::iter::once(&shaders.draw).chain(shaders.before.values()));
        let asks = |needs: &Needs| needs.casters() || needs.shadow_maps();
        let mut readers = modules.filter(|module| asks(&module.needs)).peekable();
        readers.peek()?;
        let dark = unlit(scene.setup, &scene.mix, object);
        let mut lights = BTreeSet::new();
        let (mut reads_occluders, mut sends_rays) = (false, false);
        for module in readers {
            let shadowing = module.host.shadowing_lights();
            lights.extend(shadowing.filter(|light| !dark.contains_key(*light)).cloned());
            reads_occluders |= module.needs.occluders;
            sends_rays |= module.needs.casters();
        }
        Some(ShadowReader { object: *number, lights, reads_occluders, sends_rays })
    }

    /// The casters that looks of visible objects ask about, by rays or maps; `None` where none do.
    /// Lights whose shadows no look draws, and lights that do not reach the object, have none.
    pub(super) fn casters<'a>(
        &self,
        scene: &'a PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        variants: &Variants,
        dropped: &mut Vec<DroppedEffect>,
    ) -> Result<Option<PlannedCasters<'a>>, Vec<Diagnostic>> {
        let readers: Vec<ShadowReader> =
            visible.iter().filter_map(|v| self.shadow_reader(scene, v, variants)).collect();
        if readers.is_empty() {
            return Ok(None);
        }
        let sends_rays = readers.iter().any(|reader| reader.sends_rays);
        if readers.iter().all(ShadowReader::is_free) {
            dropped.push(no_casters());
            let texture = sends_rays.then(Arc::default);
            return Ok(Some(PlannedCasters { texture, ..PlannedCasters::default() }));
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
        for ShadowReader { object: receiver, lights, reads_occluders, .. } in &readers {
            let (receiver, onto) = (*receiver, &objects[*receiver].id);
            // The set of those that cast, and whether the receiver is one of them.
            let mut insert = |casts: &dyn Fn(&usize) -> bool| {
                let set = match is_linked || sets.is_empty() {
                    true => sets.insert_full(set_of(casts)).0,
                    false => 0,
                };
                (set, sets[set].binary_search(&receiver).is_ok())
            };
            if *reads_occluders {
                let (around, _) = insert(&|caster| shadows[*caster].reach(onto));
                occluders.insert(receiver, around);
            }
            for light in lights {
                let (set, onto_itself) = insert(&|caster| shadows[*caster].fall(light, onto));
                found.push((receiver, light, set, onto_itself));
            }
        }
        let texture = match sends_rays {
            true => {
                Some(Casters::new(objects, &scene.placed, &sets, &occluders).map_err(|p| vec![p])?)
            }
            false => None,
        };
        let mut lights: HashMap<usize, CastersByLight> = HashMap::new();
        for (receiver, light, set, onto_itself) in found {
            let number = texture
                .as_ref()
                .map_or(LightValues::NO_CASTERS, |texture| texture.number(&sets[set], onto_itself));
            let casters = LightCasters { number, set };
            lights.entry(receiver).or_default().insert(light.clone(), casters);
        }
        let lit_by = |(receiver, lights)| (receiver, LitBy::new(lights));
        Ok(Some(PlannedCasters {
            texture: texture.map(Arc::new),
            objects,
            placed: &scene.placed,
            maps: RefCell::default(),
            sets,
            receivers: lights.into_iter().map(lit_by).collect(),
        }))
    }
}
