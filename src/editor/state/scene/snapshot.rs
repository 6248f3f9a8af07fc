//! Snapshot of a scene, with everything that a thread needs to draw it.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::PathBuf;
use std::sync::Arc;

use crate::diag::WithWarnings;
use crate::document::{Object, Scene, SourceMap};
use crate::frame::{Assets, LookSource, ResolvedShot, Setup, SetupLook, place_objects};
use crate::ids::ObjectId;
use crate::state::revision::PictureRevision;

/// A scene with the looks that are not open.
#[derive(Clone)]
pub(crate) struct SceneSnapshot {
    /// Revision of the scene's picture.
    pub(super) revision: PictureRevision,
    /// Revision of the scene's shape, which changes when objects are moved, get other meshes, or
    /// wear other looks.
    pub(super) shape: PictureRevision,
    pub(crate) scene: Scene,
    /// Folder that meshes are relative to.
    pub(super) base: PathBuf,
    pub(super) source: Arc<SourceMap>,
    /// Names that mean the open look.
    pub(super) open: HashSet<String>,
    /// The other looks by their names; `None` where a file is broken.
    pub(super) others: HashMap<String, Option<Arc<SetupLook>>>,
    /// Changes by the shot over the scene, if one is open.
    pub(super) shot: Option<Arc<ResolvedShot>>,
    /// True if only objects that wear the open look are there.
    pub(super) is_alone: bool,
}

impl Default for SceneSnapshot {
    fn default() -> Self {
        Self {
            revision: PictureRevision::default(),
            shape: PictureRevision::default(),
            scene: Scene::default(),
            base: PathBuf::new(),
            source: Arc::new(Scene::read("{}", "").source),
            open: HashSet::new(),
            others: HashMap::new(),
            shot: None,
            is_alone: false,
        }
    }
}

impl SceneSnapshot {
    /// Revision of the scene's picture.
    pub(crate) fn revision(&self) -> PictureRevision {
        self.revision
    }

    /// Looks that are not open, as far as they can be read, each once, in the order of their names.
    pub(crate) fn other_looks(&self) -> impl Iterator<Item = &Arc<SetupLook>> {
        let mut named: Vec<_> =
            self.others.iter().filter_map(|(name, look)| Some((name, look.as_ref()?))).collect();
        named.sort_unstable_by_key(|(name, _)| *name);
        let mut seen = HashSet::new();
        named.into_iter().map(|(_, look)| look).filter(move |look| seen.insert(Arc::as_ptr(look)))
    }

    /// Revision of the scene's shape; lights and values do not count.
    pub(crate) fn shape(&self) -> PictureRevision {
        self.shape
    }

    /// True if an object plays an animation.
    pub(crate) fn plays(&self) -> bool {
        let moves = self.shot.as_ref().is_some_and(|shot| shot.moves_objects());
        moves || self.scene.objects.values().any(|object| object.animation.is_some())
    }

    /// True if every object is in the same place as in `other`, on the same mesh, and wears the
    /// same looks as far as they can be worn.
    pub(super) fn has_shape_of(&self, other: &Self) -> bool {
        let is_like = |a: &Object, b: &Object| {
            (&a.mesh, &a.animation, a.transform, &a.looks, a.visible)
                == (&b.mesh, &b.animation, b.transform, &b.looks, b.visible)
        };
        let (own, others) = (&self.scene.objects, &other.scene.objects);
        let is_same =
            |((id, object), (other_id, other)): ((&ObjectId, &Object), (&ObjectId, &Object))| {
                id == other_id && is_like(object, other)
            };
        let can_be_worn = |snapshot: &'_ Self| -> BTreeMap<String, bool> {
            snapshot.others.iter().map(|(name, look)| (name.clone(), look.is_some())).collect()
        };
        own.len() == others.len()
            && own.iter().zip(others).all(is_same)
            && (&self.base, &self.open) == (&other.base, &other.open)
            && can_be_worn(self) == can_be_worn(other)
    }

    /// The snapshot with only the objects that wear the open look.
    #[must_use]
    pub(crate) fn alone(&self) -> Self {
        Self { is_alone: true, ..self.clone() }
    }

    /// The scene with everything that it names, as far as that exists, and the problems. `open` is
    /// the first of its looks, even if no object wears it.
    pub(crate) fn setup(&self, open: SetupLook, assets: &mut Assets) -> WithWarnings<Setup> {
        let mut worn = SceneLooks { snapshot: self, looks: vec![open], known: HashMap::new() };
        let (objects, problems) =
            place_objects(&self.scene, &self.base, &self.source, None, assets, &mut worn)
                .into_parts();
        let (scene, assets) = (self.scene.clone(), assets.store().clone());
        let shot = self.shot.clone();
        let mut setup =
            Setup { scene, shot, looks: worn.looks, objects, assets, ..Setup::default() };
        if let Some(shot) = &self.shot {
            shot.hold_tracks(&mut setup);
        }
        if self.is_alone {
            setup.looks.truncate(1);
            for object in &mut setup.objects {
                object.looks.iter_mut().for_each(|look| *look = look.filter(|&look| look == 0));
            }
            setup.objects.retain(|object| object.looks.iter().any(Option::is_some));
        }
        WithWarnings::new(setup, problems)
    }
}

/// The open look and the others, collected as objects ask for them.
struct SceneLooks<'s> {
    snapshot: &'s SceneSnapshot,
    looks: Vec<SetupLook>,
    known: HashMap<*const SetupLook, usize>,
}

impl LookSource for SceneLooks<'_> {
    fn has(&self, name: &str) -> bool {
        self.snapshot.open.contains(name) || self.snapshot.others.contains_key(name)
    }

    fn find(&mut self, name: &str) -> WithWarnings<Option<usize>> {
        if self.snapshot.open.contains(name) {
            return Some(0).into();
        }
        // Problems of a broken look were reported when it was read.
        let look = self.snapshot.others.get(name).and_then(Option::as_ref);
        let looks = &mut self.looks;
        let index = look.map(|look| {
            *self.known.entry(Arc::as_ptr(look)).or_insert_with(|| {
                looks.push((**look).clone());
                looks.len() - 1
            })
        });
        index.into()
    }
}
