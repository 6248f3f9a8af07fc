//! What the viewport shows of a stage, with everything that a thread needs to draw it.

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;
use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::document::{Scene, SourceMap};
use crate::frame::{Assets, Setup, SetupLook, Wardrobe, place_objects};

/// A scene with the looks that are not open.
#[derive(Clone)]
pub(crate) struct Staged {
    /// Another number is another picture.
    pub(super) version: u64,
    pub(crate) scene: Scene,
    /// What meshes are relative to.
    pub(super) base: PathBuf,
    pub(super) source: Arc<SourceMap>,
    /// The names that mean the open look.
    pub(super) open: HashSet<String>,
    /// The others; `None` where a file is broken.
    pub(super) others: HashMap<String, Option<Arc<SetupLook>>>,
    /// Whether only what wears the open look is there.
    pub(super) is_alone: bool,
}

impl Default for Staged {
    fn default() -> Self {
        Self {
            version: 0,
            scene: Scene::default(),
            base: PathBuf::new(),
            source: Arc::new(Scene::read("{}", "").source),
            open: HashSet::new(),
            others: HashMap::new(),
            is_alone: false,
        }
    }
}

impl Staged {
    /// Tells one picture of a stage from another.
    pub(crate) fn version(&self) -> u64 {
        self.version
    }

    /// Without what does not wear the open look.
    #[must_use]
    pub(crate) fn alone(&self) -> Self {
        Self { is_alone: true, ..self.clone() }
    }

    /// The scene with everything that it names, as far as that is there, and what is wrong. `open` is the first of its
    /// looks, whether anything wears it or not.
    pub(crate) fn setup(&self, open: SetupLook, assets: &mut Assets) -> (Setup, Vec<Diagnostic>) {
        let mut problems = Vec::new();
        let mut worn = Worn { staged: self, looks: vec![open], known: HashMap::new() };
        let objects = place_objects(&self.scene, &self.base, &self.source, None, assets, &mut worn, &mut problems);
        let mut setup = Setup { scene: self.scene.clone(), looks: worn.looks, objects, ..Setup::default() };
        if self.is_alone {
            setup.looks.truncate(1);
            for object in &mut setup.objects {
                object.looks.iter_mut().for_each(|look| *look = look.filter(|&look| look == 0));
            }
            setup.objects.retain(|object| object.looks.iter().any(Option::is_some));
        }
        (setup, problems)
    }
}

/// The open look and the others, as objects ask for them.
struct Worn<'s> {
    staged: &'s Staged,
    looks: Vec<SetupLook>,
    known: HashMap<*const SetupLook, usize>,
}

impl Wardrobe for Worn<'_> {
    fn has(&self, name: &str) -> bool {
        self.staged.open.contains(name) || self.staged.others.contains_key(name)
    }

    fn find(&mut self, name: &str, _: &mut Vec<Diagnostic>) -> Option<usize> {
        if self.staged.open.contains(name) {
            return Some(0);
        }
        // What is wrong with a broken one was told when it was read.
        let look = self.staged.others.get(name)?.as_ref()?;
        let looks = &mut self.looks;
        Some(*self.known.entry(Arc::as_ptr(look)).or_insert_with(|| {
            looks.push((**look).clone());
            looks.len() - 1
        }))
    }
}
