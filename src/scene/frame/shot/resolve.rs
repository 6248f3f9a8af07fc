//! Overrides put into a scene and its looks, the farthest document first.

use std::path::Path;
use std::sync::Arc;

use chiaro_locale::tr;
use serde_json::Value as Json;

use super::keys::{json_of_keys, timed_keys};
use super::moving::{MovingValue, object_of};
use super::stack::{is_same_file, located, named_from};
use super::{FrameClock, ResolvedShot, ShotFile, ShotStack, ValueChange};
use crate::diag::{Diagnostic, WithWarnings, has_errors};
use crate::document::{
    Camera, LoadedDocument, Override, Scene, Shot, Target, TimeRange, Value, json_of_value,
    keyed_target,
};
use crate::files::{Files, shortened};
use crate::frame::assets::Assets;
use crate::frame::setup::{Setup, SetupLook, SetupObject, scene_setup};
use crate::ids::ObjectId;

/// Opens a shot that was read from a file: what it changes, with the changes.
///
/// # Errors
/// All errors of the shots, of the scene, and of the files that it names.
pub fn open_shot(
    path: &Path,
    loaded: LoadedDocument<Shot>,
    mesh: Option<&str>,
    assets: &mut Assets,
) -> Result<WithWarnings<Setup>, Vec<Diagnostic>> {
    let files = assets.source().clone();
    let (stack, mut problems) = ShotStack::over(&*files, path, loaded)?.into_parts();
    let mut resolver = ShotResolver::new(&stack);
    let (folder, source) = (stack.scene_folder(), &stack.scene_source);
    let scene = resolver.scene().clone();
    let mut setup = scene_setup(scene, folder, source, mesh, assets).tell(&mut problems);
    resolver.change_looks(&*files, &mut setup);
    let shot = resolver.finish().tell(&mut problems);
    if has_errors(&problems) {
        return Err(problems);
    }
    shot.hold_tracks(&mut setup);
    setup.shot = Some(Arc::new(shot));
    Ok(WithWarnings::new(setup, problems))
}

/// Resolver of a shot: the scene as far as overrides are put into it. The scene is changed at once,
/// by which its looks are found; these are changed next.
pub struct ShotResolver<'s> {
    stack: &'s ShotStack,
    scene: Scene,
    changes: Vec<ValueChange>,
    moving: Vec<MovingValue>,
    clock: FrameClock,
    problems: Vec<Diagnostic>,
}

/// An override in its file.
#[derive(Clone, Copy)]
struct OverrideAt<'s> {
    file: &'s ShotFile,
    index: usize,
    changed: &'s Override,
}

impl OverrideAt<'_> {
    /// A problem at a field of the override.
    fn problem(&self, problem: Diagnostic, field: &str) -> Diagnostic {
        located(self.file, problem, &format!("overrides[{}].{field}", self.index))
    }
}

impl<'s> ShotResolver<'s> {
    /// A resolver that has put all overrides of values of the scene into it.
    pub fn new(stack: &'s ShotStack) -> Self {
        let ([first, last], rate) = (stack.frames(), stack.rate());
        let clock = FrameClock { first, last, rate, shading_step: stack.step() };
        let (scene, changes, moving) = (stack.scene.clone(), Vec::new(), Vec::new());
        let mut resolver = Self { stack, scene, changes, moving, clock, problems: Vec::new() };
        resolver.change_scene();
        resolver
    }

    /// The scene with what is set in it. Values that move are as they were before the shots.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The changes, with problems of overrides that could not be put in.
    pub fn finish(self) -> WithWarnings<ResolvedShot> {
        let Self { stack, changes, moving, clock, problems, .. } = self;
        WithWarnings::new(ResolvedShot { changes, moving, clock, stack: stack.clone() }, problems)
    }

    /// Puts all overrides of values of the scene into it.
    fn change_scene(&mut self) {
        for file in self.stack.shots.iter().rev() {
            if let Some(camera) = &file.shot.camera {
                self.change_camera(file, camera);
            }
            for at in overrides(file).filter(|at| at.changed.look.is_none()) {
                if let Err(problem) = self.change_value(at) {
                    self.problems.push(*problem);
                }
            }
        }
        if !has_errors(&self.problems) {
            self.check_scene();
        }
        let [start, end] = self.stack.frames().map(|frame| self.clock.rate.time(frame));
        self.scene.time = TimeRange { start, end, fps: self.clock.rate.per_second() };
        // Objects that come and go are there, so that their meshes and looks are found.
        for moving in &self.moving {
            if let Some((id, "visible")) = object_of(&moving.address)
                && let Some(object) = self.scene.objects.get_mut(&ObjectId::new(id))
            {
                object.visible = true;
            }
        }
    }

    /// Checks the scene as a whole, with what was put into it.
    fn check_scene(&mut self) {
        let file = &self.stack.shots[0];
        for mut problem in self.scene.check().into_iter().filter(Diagnostic::is_error) {
            let at = problem.place.json_path.take().unwrap_or_default();
            problem.message =
                tr!("`{at}`, as the shot changes it: {message}", message = problem.message);
            self.problems.push(located(file, problem, "overrides"));
        }
    }

    /// Puts a camera in place of the one before.
    fn change_camera(&mut self, file: &ShotFile, camera: &Camera) {
        let json = |camera: &Camera| serde_json::to_value(camera).unwrap_or_default();
        let (from, to) = (json(&self.scene.camera), json(camera));
        for (name, to) in to.as_object().into_iter().flatten() {
            let address = format!("camera.{name}");
            let has_moved = self.moving.iter().any(|moving| moving.address == address);
            if from.get(name) != Some(to) || has_moved {
                self.moving.retain(|moving| moving.address != address);
                let from = from.get(name).cloned().unwrap_or_default();
                self.push(
                    (file, "camera".to_owned()),
                    None,
                    (&address, 1),
                    false,
                    (from, to.clone()),
                );
            }
        }
        self.scene.camera = *camera;
        self.scene.file_camera = None;
    }

    /// Puts an override of a value of the scene into it.
    fn change_value(&mut self, at: OverrideAt<'_>) -> Result<(), Box<Diagnostic>> {
        let address = at.changed.target.as_str();
        let place = self.scene.value_at(address).map_err(|problem| {
            let is_light = address.starts_with("lights.") && problem.code == "unknown-target";
            let hint = tr!("name the look in \"look\" where it is a light of a look");
            at.problem(if is_light { problem.hint(hint) } else { problem }, "target")
        })?;
        self.tell_directions(at);
        if let Some(value) = &at.changed.value {
            self.scene.set_value(address, value).map_err(|problem| at.problem(problem, "value"))?;
            self.scene.time_keys.retain(|track| track.target.to_string() != address);
            self.moving.retain(|moving| moving.address != address);
        } else {
            if let Some(why) = why_fixed(address) {
                let message = format!("`{address}` {why}");
                let problem = Diagnostic::error("bad-target", message);
                let problem = problem.hint(tr!("write \"value\" in place of \"keys\""));
                return Err(at.problem(problem, "keys").into());
            }
            let check = |value: &Value| self.scene.check_value(address, value);
            let keys = timed_keys(self.clock, at.changed, place.blend, &check)
                .map_err(|wrong| at.problem(wrong.problem, &wrong.field))?;
            self.moving.retain(|moving| moving.address != address);
            match keyed_target(address).filter(|target| matches!(target, Target::Light { .. })) {
                Some(target) => {
                    let track = keys.track(self.clock, target);
                    self.scene.key_light(track.map_err(|wrong| at.problem(wrong, "step"))?);
                }
                None => self.moving.push(MovingValue {
                    address: address.to_owned(),
                    blend: place.blend,
                    step: at.changed.step,
                    keys: keys.keys,
                    ends: keys.ends,
                }),
            }
        }
        self.push_override(at, None, place.value);
        Ok(())
    }

    /// Warns of keys by direction, which stand over what is set and over keys in time.
    fn tell_directions(&mut self, at: OverrideAt<'_>) {
        let keys = self.scene.direction_keys.iter().flat_map(|keys| &keys.keys);
        let mut targets = keys.flat_map(|key| key.values.keys());
        if targets.any(|target| target.to_string() == at.changed.target) {
            let message = tr!(
                "`{target}` is keyed by a direction in the scene, which stands over the shot",
                target = at.changed.target
            );
            let problem = Diagnostic::warning("idle-override", message);
            self.problems.push(at.problem(problem, "target"));
        }
    }

    /// Puts all overrides of values of looks into the looks that the objects wear.
    pub fn change_looks(&mut self, files: &dyn Files, setup: &mut Setup) {
        for file in self.stack.shots.iter().rev() {
            for at in overrides(file) {
                let Some(name) = &at.changed.look else { continue };
                let path = super::stack::folder(&file.path).join(name);
                let is_it =
                    |worn: &SetupLook| is_same_file(files, Path::new(worn.source.file()), &path);
                let changed = match setup.looks.iter().position(is_it) {
                    Some(look) => self.change_look_value(at, look, setup),
                    None => Err(self.unworn(at, files, &path, setup).into()),
                };
                if let Err(problem) = changed {
                    self.problems.push(*problem);
                }
            }
        }
    }

    /// The problem of a look that no object wears.
    fn unworn(
        &self,
        at: OverrideAt<'_>,
        files: &dyn Files,
        path: &Path,
        setup: &Setup,
    ) -> Diagnostic {
        let name = at.changed.look.as_deref().unwrap_or_default();
        // A hidden object may wear it.
        let folder = self.stack.scene_folder();
        let mut named = self.scene.objects.values().flat_map(|object| object.looks.values());
        let problem = if named.any(|look| is_same_file(files, &folder.join(look), path)) {
            Diagnostic::warning("idle-override", tr!("no visible object wears `{name}`"))
        } else if files.has_file(path) {
            Diagnostic::error("unknown-look", tr!("no object of the scene wears `{name}`"))
        } else {
            Diagnostic::error("missing-asset", tr!("there is no look `{name}`"))
                .hint(tr!("paths of looks are relative to the shot's own file"))
        };
        // As the shot would name them, so that what is suggested can be written there.
        let own = super::stack::folder(&at.file.path);
        let worn: Vec<String> =
            setup.looks.iter().map(|worn| named_from(own, Path::new(worn.source.file()))).collect();
        let wrong = named_from(own, path);
        let problem = problem.suggest(&wrong, worn.iter().map(String::as_str));
        at.problem(problem, "look")
    }

    /// Puts an override of a value of a look into it.
    fn change_look_value(
        &mut self,
        at: OverrideAt<'_>,
        index: usize,
        setup: &mut Setup,
    ) -> Result<(), Box<Diagnostic>> {
        let address = at.changed.target.as_str();
        let covering = covering(setup, index, address);
        let worn = &mut setup.looks[index];
        let place = worn.look.value_at(address).map_err(|problem| at.problem(problem, "target"))?;
        if let Some(why) = covering {
            let message = tr!("`{address}` of the look has no effect: {why}");
            let problem = Diagnostic::warning("idle-override", message);
            self.problems.push(at.problem(problem, "target"));
        }
        if let Some(value) = &at.changed.value {
            let set = worn.look.set_value(address, value);
            set.map_err(|problem| at.problem(problem, "value"))?;
        } else {
            let Some(target) = keyed_target(address).filter(|_| !address.starts_with("nodes."))
            else {
                let message = tr!("`{address}` is built into the shader of the look");
                let problem = Diagnostic::error("bad-target", message);
                let problem = problem.hint(tr!("write \"value\" in place of \"keys\""));
                return Err(at.problem(problem, "keys").into());
            };
            let check = |value: &Value| worn.look.check_value(address, value);
            let keys = timed_keys(self.clock, at.changed, place.blend, &check)
                .map_err(|wrong| at.problem(wrong.problem, &wrong.field))?;
            let track = keys.track(self.clock, target);
            worn.look.key_value(track.map_err(|wrong| at.problem(wrong, "step"))?);
        }
        let name = display(setup.looks[index].source.file());
        self.push_override(at, Some(name), place.value);
        Ok(())
    }

    fn push_override(&mut self, at: OverrideAt<'_>, look: Option<String>, from: Json) {
        let changed = at.changed;
        let to = match &changed.value {
            Some(value) => json_of_value(value),
            None => json_of_keys(&changed.keys),
        };
        let target = (changed.target.as_str(), changed.step);
        let place = (at.file, format!("overrides[{}]", at.index));
        self.push(place, look, target, changed.value.is_none(), (from, to));
    }

    /// Lists a change, over an earlier one of the same value.
    fn push(
        &mut self,
        (file, json_path): (&ShotFile, String),
        look: Option<String>,
        (target, step): (&str, u32),
        is_keyed: bool,
        (from, to): (Json, Json),
    ) {
        let is_it = |change: &&mut ValueChange| {
            change.stands && change.look == look && change.target == target
        };
        let before = self.changes.iter_mut().find(is_it).map(|before| {
            before.stands = false;
            before.to.clone()
        });
        self.changes.push(ValueChange {
            look,
            target: target.to_owned(),
            from: before.unwrap_or(from),
            to,
            is_keyed,
            step,
            by: file.path.clone(),
            json_path,
            stands: true,
        });
    }
}

/// The overrides of a file.
fn overrides(file: &ShotFile) -> impl Iterator<Item = OverrideAt<'_>> {
    let all = file.shot.overrides.iter().enumerate();
    all.map(move |(index, changed)| OverrideAt { file, index, changed })
}

/// A path as people write it.
fn display(path: impl AsRef<Path>) -> String {
    shortened(path.as_ref()).display().to_string()
}

/// The reason why a value of the scene does not move, in words that follow its address.
fn why_fixed(address: &str) -> Option<&'static str> {
    let field = object_of(address).map(|_| address.splitn(3, '.').nth(2).unwrap_or_default());
    match field {
        Some(field) if field == "mesh" || field == "looks" || field.starts_with("looks.") => {
            Some(tr!("is read once for all frames"))
        }
        Some("transform.fit") => Some(tr!("does not move")),
        None if ["time", "name", "about"].contains(&address.split('.').next().unwrap_or("")) => {
            Some(tr!("does not move"))
        }
        _ => None,
    }
}

/// The reason why a value of a look has no effect, where something stands over it.
fn covering(setup: &Setup, look: usize, address: &str) -> Option<String> {
    if let Some(Target::Light { light, .. }) = keyed_target(address)
        && setup.scene.lights.contains_key(&light)
    {
        return Some(tr!(
            "the scene has a light `{light}`, which stands in its place; leave \"look\" out to \
             change that"
        ));
    }
    let exposed = setup.looks[look].look.exposed.iter();
    let exposed = exposed.filter(|exposed| exposed.target.to_string() == address);
    let names: Vec<_> = exposed.map(|exposed| &exposed.name).collect();
    let sets = |object: &&SetupObject| {
        object.worn_looks().any(|worn| worn == look)
            && names.iter().any(|name| object.values.contains_key(*name))
    };
    let object = setup.objects.iter().find(sets)?;
    let name = names.iter().find(|name| object.values.contains_key(**name))?;
    let id = &object.id;
    Some(tr!("object `{id}` sets it; change `objects.{id}.values.{name}`"))
}
