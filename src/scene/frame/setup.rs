//! A scene together with everything that it names: looks, meshes, images.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;
use glam::{DMat4, DQuat, DVec3};
use indexmap::IndexMap;

use super::assets::Assets;
use super::motion::PlayedAnimation;
use super::shot::{ResolvedShot, open_shot};
use super::store::AssetStore;
use crate::diag::{Diagnostic, WithWarnings, has_errors};
use crate::document::{
    Document, LayerLink, LightLink, Look, MeshAnimation, Object, Scene, ShadowLink, SourceMap,
    Transform, Values,
};
use crate::files::Files;
use crate::geometry::Mesh;
use crate::ids::ObjectId;

/// Name that stands for all materials that the object does not name.
pub const ANY_MATERIAL: &str = "*";

/// A look with the folder that its assets are relative to.
#[derive(Clone, Debug)]
pub struct SetupLook {
    /// The look.
    pub look: Look,
    /// Places of the look's values in its file.
    pub source: Arc<SourceMap>,
    /// Folder of the look's file.
    pub folder: PathBuf,
}

/// An object with its mesh and looks resolved.
#[derive(Clone, Debug)]
pub struct SetupObject {
    /// Id of the object.
    pub id: ObjectId,
    /// Mesh of the object.
    pub mesh: Arc<Mesh>,
    /// Transform from object to world space.
    pub world_from_object: DMat4,
    /// Look of each part of the mesh, by index; `None` where the object has no look for the part's
    /// material.
    pub looks: Vec<Option<usize>>,
    /// Values of exposed parameters.
    pub values: Values,
    /// Lights that reach the object.
    pub light_link: LightLink,
    /// Shadows that the object casts.
    pub shadow_link: ShadowLink,
    /// Lights of single nodes of the looks.
    pub layers: Vec<LayerLink>,
    /// Animation that the mesh plays; `None` where the mesh stands still.
    pub animation: Option<PlayedAnimation>,
}

impl SetupObject {
    /// The looks that the object's parts wear, one for each part that wears any.
    pub fn worn_looks(&self) -> impl Iterator<Item = usize> {
        self.mesh.parts.iter().zip(&self.looks).filter_map(|(_, look)| *look)
    }

    /// The center of the mesh's box, in world space.
    pub fn center(&self) -> DVec3 {
        self.world_from_object.transform_point3(self.mesh.bounds().center())
    }

    /// The radius of a sphere around the center that holds the mesh, in scene units.
    pub fn radius(&self) -> f64 {
        let bounds = self.mesh.bounds();
        let (scale, ..) = self.world_from_object.to_scale_rotation_translation();
        bounds.radius * scale.abs().max_element()
    }
}

/// A scene with everything that it names.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    /// The scene.
    pub scene: Scene,
    /// Text that the scene was read from, if any.
    pub source: Option<Arc<SourceMap>>,
    /// Folder that names in the scene are relative to.
    pub folder: PathBuf,
    /// Shot that has changed the scene, if one has.
    pub shot: Option<Arc<ResolvedShot>>,
    /// Every look that an object wears.
    pub looks: Vec<SetupLook>,
    /// Visible objects.
    pub objects: Vec<SetupObject>,
    /// Look that is being edited, if one is: its lights are taken as they are now, and all other
    /// looks are compiled with their values folded, whatever liveness is asked for this one.
    pub edited: Option<usize>,
    /// Store that the setup's meshes were read with, and in which plans find what they read.
    pub assets: AssetStore,
}

impl Setup {
    /// Distances from the object's center to the centers of all other objects, in scene units.
    pub fn others_of(&self, object: &SetupObject) -> IndexMap<ObjectId, f64> {
        let others = self.objects.iter().filter(|other| other.id != object.id);
        others.map(|other| (other.id.clone(), other.center().distance(object.center()))).collect()
    }

    /// Turns every object so that the z axis of its mesh points up instead of y.
    pub fn stand_up(&mut self) {
        let turn = DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2);
        for object in &mut self.objects {
            object.world_from_object *= turn_within(object, turn);
        }
    }
}

impl Setup {
    /// Turns the camera around its target, to the right around its up direction by `yaw`, then up
    /// by `pitch`. In radians.
    pub fn turn_camera(&mut self, [yaw, pitch]: [f64; 2]) {
        let camera = &mut self.scene.camera;
        let target = DVec3::from(camera.target);
        let up = DVec3::from(camera.up).try_normalize().unwrap_or(DVec3::Y);
        let offset = DQuat::from_axis_angle(up, yaw) * (DVec3::from(camera.eye) - target);
        let Some(right) = up.cross(offset).try_normalize() else { return };
        let turn = DQuat::from_axis_angle(right, -pitch);
        camera.eye = (target + turn * offset).to_array();
        camera.up = (turn * up).to_array();
    }

    /// Turns the illumination frame, and every light in it, around the vertical axis by `yaw`, then
    /// up by `pitch`. In radians.
    pub fn turn_lights(&mut self, [yaw, pitch]: [f64; 2]) {
        let turn = DQuat::from_rotation_y(yaw) * DQuat::from_rotation_x(-pitch);
        let turned = turn * DQuat::from_array(self.scene.illumination);
        let length = turned.length();
        self.scene.illumination = if length > 1e-9 { turned / length } else { turn }.to_array();
    }
}

/// A turn of the object's mesh around the center of its bounds, in object space.
fn turn_within(object: &SetupObject, turn: DMat4) -> DMat4 {
    let middle = object.mesh.bounds().center();
    DMat4::from_translation(middle) * turn * DMat4::from_translation(-middle)
}

/// Opens a look, a scene or a shot. A look opened alone is worn by `mesh` (a path, or `shape:` and
/// a name) in the default scene.
///
/// # Errors
/// All errors of the file and of the files that it names.
pub fn open(
    path: &Path,
    mesh: Option<&str>,
    assets: &mut Assets,
) -> Result<WithWarnings<Setup>, Vec<Diagnostic>> {
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    match Document::load(&**assets.source(), path) {
        Document::Look(loaded) => {
            let mut problems = loaded.diagnostics.clone();
            let Some(look) = loaded.value.clone().filter(|_| !has_errors(&problems)) else {
                return Err(problems);
            };
            let look = SetupLook { look, source: loaded.source.clone().into(), folder };
            let setup = default_setup(look, mesh.unwrap_or(DEFAULT_MESH), assets)
                .map_err(|more| [problems.clone(), more].concat())?
                .tell(&mut problems);
            Ok(WithWarnings::new(setup, problems))
        }
        Document::Scene(loaded) => {
            let mut problems = loaded.diagnostics.clone();
            let Some(scene) = loaded.value.clone().filter(|_| !has_errors(&problems)) else {
                return Err(problems);
            };
            let setup =
                scene_setup(scene, &folder, &loaded.source, mesh, assets).tell(&mut problems);
            if has_errors(&problems) {
                Err(problems)
            } else {
                Ok(WithWarnings::new(setup, problems))
            }
        }
        Document::Shot(loaded) => open_shot(path, loaded, mesh, assets),
    }
}

/// Mesh that a look opened alone is shown on.
pub const DEFAULT_MESH: &str = "shape:creature";

/// The default scene with one object that wears `look` and plays the first animation of its mesh.
/// Paths of meshes are relative to the working
/// folder.
///
/// # Errors
/// The reasons why the mesh cannot be used.
pub fn default_setup(
    look: SetupLook,
    mesh: &str,
    assets: &mut Assets,
) -> Result<WithWarnings<Setup>, Vec<Diagnostic>> {
    let (mesh, notes) = assets.mesh(Path::new(""), mesh)?.into_parts();
    let world_from_object = object_matrix(&Transform::default(), &mesh);
    let looks = vec![Some(0); mesh.parts.len()];
    let played = MeshAnimation::default();
    let animation = mesh.motion.as_ref().filter(|motion| !motion.animations().is_empty());
    let animation = animation.map(|_| PlayedAnimation { number: 0, played });
    let object = SetupObject {
        id: ObjectId::new("object"),
        mesh,
        world_from_object,
        looks,
        values: Values::new(),
        light_link: LightLink::default(),
        shadow_link: ShadowLink::default(),
        layers: Vec::new(),
        animation,
    };
    let (looks, objects, assets) = (vec![look], vec![object], assets.store().clone());
    Ok(WithWarnings::new(Setup { looks, objects, assets, ..Setup::default() }, notes))
}

/// The matrix from object to world space: fit, scale, turn, move.
pub fn object_matrix(transform: &Transform, mesh: &Mesh) -> DMat4 {
    let fit = if transform.fit { mesh.fit().matrix() } else { DMat4::IDENTITY };
    placed(transform, fit)
}

/// The matrix of an object whose mesh is fitted already.
pub(super) fn placed(transform: &Transform, fit: DMat4) -> DMat4 {
    let rotation = DQuat::from_array(transform.rotate);
    let rotation =
        if rotation.length_squared() > 1e-18 { rotation.normalize() } else { DQuat::IDENTITY };
    DMat4::from_scale_rotation_translation(
        transform.scale.into(),
        rotation,
        transform.translate.into(),
    ) * fit
}

/// Resolves the names in a scene: meshes relative to `folder` (`mesh` in place of all of them) and
/// looks. What could not be found is left out, with errors among the warnings.
pub fn scene_setup(
    scene: Scene,
    folder: &Path,
    source: &SourceMap,
    mesh: Option<&str>,
    assets: &mut Assets,
) -> WithWarnings<Setup> {
    let files = assets.source().clone();
    let mut looks = LookFiles { files: &*files, folder, found: Vec::new() };
    let placed = place_objects(&scene, folder, source, mesh, assets, &mut looks);
    let looks = looks.found.into_iter().map(|(_, look)| look).collect();
    let source = Some(source.clone().into());
    let assets = assets.store().clone();
    let folder = folder.to_path_buf();
    placed.map(|objects| Setup {
        scene,
        source,
        folder,
        shot: None,
        looks,
        objects,
        edited: None,
        assets,
    })
}

/// Source of the looks of a scene.
pub trait LookSource {
    /// True if there is a look of this name, even a broken one.
    fn has(&self, name: &str) -> bool;

    /// The index of a look among those of the setup; `None` if the look cannot be used, with the
    /// errors that were not told yet.
    fn find(&mut self, name: &str) -> WithWarnings<Option<usize>>;
}

/// Places the visible objects of a scene, with their meshes, relative to `folder`, and their looks.
/// An object whose mesh cannot be found, and a look that cannot be found, are left out, with errors
/// among the warnings.
pub fn place_objects(
    scene: &Scene,
    folder: &Path,
    source: &SourceMap,
    mesh: Option<&str>,
    assets: &mut Assets,
    looks: &mut dyn LookSource,
) -> WithWarnings<Vec<SetupObject>> {
    let (mut objects, mut problems) = (Vec::new(), Vec::new());
    // Many objects may show one large mesh. The objects hold the meshes, so addresses stay theirs.
    let mut fits: HashMap<*const Mesh, DMat4> = HashMap::new();
    for (index, (id, object)) in scene.objects.iter().enumerate() {
        if !object.visible {
            continue;
        }
        let path_of = |field: &str| format!("objects[{index}].{field}");
        missing_looks(id, object, looks, &path_of("looks"), source, &mut problems);
        let found = match mesh {
            Some(replacement) => assets.mesh(Path::new(""), replacement),
            None => assets.mesh(folder, &object.mesh),
        };
        let mesh = match found {
            Ok(mesh) => mesh.tell(&mut problems),
            Err(found) => {
                // A mesh that was given in place of the scene's has no place in the scene's text.
                let place = mesh.is_none().then(|| path_of("mesh"));
                problems.extend(
                    found
                        .into_iter()
                        .map(|problem| of_object(id, problem, place.as_deref(), source)),
                );
                continue;
            }
        };
        let worn = mesh
            .parts
            .iter()
            .map(|part| looks.find(look_of(object, &part.material)?).tell(&mut problems))
            .collect();
        let fit = if object.transform.fit {
            *fits.entry(Arc::as_ptr(&mesh)).or_insert_with(|| mesh.fit().matrix())
        } else {
            DMat4::IDENTITY
        };
        objects.push(SetupObject {
            id: id.clone(),
            world_from_object: placed(&object.transform, fit),
            looks: worn,
            values: object.values.clone(),
            light_link: object.light_link(),
            shadow_link: object.shadow_link(),
            layers: object.layers.clone(),
            animation: played(id, object, &mesh, (&path_of("animation"), source), &mut problems),
            mesh,
        });
        material_problems(
            id,
            object,
            &objects[objects.len() - 1].mesh,
            &path_of("looks"),
            source,
            &mut problems,
        );
    }
    file_camera_problems(scene, &objects, source, &mut problems);
    WithWarnings::new(objects, problems)
}

/// The animation that an object's mesh plays; warns where there is none of that name.
fn played(
    id: &ObjectId,
    object: &Object,
    mesh: &Mesh,
    (json_path, source): (&str, &SourceMap),
    problems: &mut Vec<Diagnostic>,
) -> Option<PlayedAnimation> {
    let played = object.animation.as_ref()?;
    let animations = mesh.motion.as_ref().map_or(&[][..], |motion| motion.animations());
    let names = || animations.iter().map(|animation| animation.name.as_str());
    let named = names().position(|name| played.name.is_empty() || name == played.name);
    if named.is_none() {
        let problem = if animations.is_empty() {
            let message = tr!("the mesh of object `{id}` has no animation, and stands still");
            Diagnostic::warning("no-animation", message)
                .hint(tr!("export the mesh with its animations, as glTF"))
        } else {
            let message = tr!(
                "the mesh of object `{id}` has no animation `{name}`, and stands still",
                name = played.name
            );
            let list: Vec<&str> = names().collect();
            Diagnostic::warning("no-animation", message)
                .suggest(&played.name, names())
                .hint(tr!("it has {names}", names = list.join(", ")))
        };
        let mut problem = problem.json_path(json_path);
        source.locate(&mut problem);
        problems.push(problem);
    }
    named.map(|number| PlayedAnimation { number, played: played.clone() })
}

/// Warns where a scene takes its camera from an object's mesh file that brings none.
fn file_camera_problems(
    scene: &Scene,
    objects: &[SetupObject],
    source: &SourceMap,
    problems: &mut Vec<Diagnostic>,
) {
    let Some(asked) = &scene.file_camera else { return };
    let object = objects.iter().find(|object| object.id.as_str() == asked.object);
    let motion = object.and_then(|object| object.mesh.motion.as_ref());
    if motion.is_some_and(|motion| motion.camera(&asked.name).is_some()) {
        return;
    }
    let message = match object {
        None => tr!("the camera is that of object `{id}`, which is not there", id = asked.object),
        Some(object) => tr!("the mesh of object `{id}` brings no such camera", id = object.id),
    };
    let cameras = motion.map_or(&[][..], |motion| motion.cameras());
    let names: Vec<&str> = cameras.iter().map(|camera| camera.name.as_str()).collect();
    let hint = match names.is_empty() {
        true => {
            tr!("the scene's own camera is taken; export the mesh with its camera, as glTF").into()
        }
        false => {
            tr!("the scene's own camera is taken; the file's are {names}", names = names.join(", "))
        }
    };
    let mut problem = Diagnostic::warning("no-camera", message).json_path("file_camera").hint(hint);
    source.locate(&mut problem);
    problems.push(problem);
}

/// The name of the look that an object wears on a material.
pub fn look_of<'o>(object: &'o Object, material: &str) -> Option<&'o str> {
    object.looks.get(material).or_else(|| object.looks.get(ANY_MATERIAL)).map(String::as_str)
}

/// A problem with an object's mesh. Where there is no such mesh, the problem's place is where the
/// scene names the mesh.
fn of_object(
    id: &ObjectId,
    mut problem: Diagnostic,
    json_path: Option<&str>,
    source: &SourceMap,
) -> Diagnostic {
    problem.message = tr!("object `{id}`: {message}", message = problem.message);
    let Some(json_path) = json_path else { return problem };
    if problem.code == "mesh-read"
        && let Some(file) = problem.place.file.take()
    {
        problem.message = format!("{} (`{file}`)", problem.message);
        problem = problem.hint(tr!("paths of meshes are relative to the scene's own file"));
    }
    if problem.place.file.is_none() {
        problem = problem.json_path(json_path);
        source.locate(&mut problem);
    }
    problem
}

/// Errors for looks that an object names and that do not exist, also for materials that its mesh
/// does not have.
fn missing_looks(
    id: &ObjectId,
    object: &Object,
    looks: &dyn LookSource,
    json_path: &str,
    source: &SourceMap,
    problems: &mut Vec<Diagnostic>,
) {
    for (material, name) in object.looks.iter().filter(|(_, name)| !looks.has(name)) {
        let message = tr!("object `{id}` wears the look `{name}`, which there is not");
        let mut problem = Diagnostic::error("missing-asset", message)
            .json_path(format!("{json_path}[{}]", serde_json::Value::from(material.as_str())))
            .hint(tr!("paths of looks are relative to the scene's own file"));
        source.locate(&mut problem);
        problems.push(problem);
    }
}

fn material_problems(
    id: &ObjectId,
    object: &Object,
    mesh: &Mesh,
    json_path: &str,
    source: &SourceMap,
    problems: &mut Vec<Diagnostic>,
) {
    let materials = || mesh.parts.iter().map(|part| part.material.as_str());
    let has_look = |material: &str| {
        object.looks.contains_key(material) || object.looks.contains_key(ANY_MATERIAL)
    };
    if !materials().any(has_look) {
        let mut problem =
            Diagnostic::warning("no-look", tr!("object `{id}` wears no look, so it is not drawn"))
                .json_path(json_path)
                .hint(tr!("give it one, as in \"looks\": \"look.json\""));
        source.locate(&mut problem);
        problems.push(problem);
    }
    for name in object
        .looks
        .keys()
        .filter(|name| *name != ANY_MATERIAL && !materials().any(|m| m == name.as_str()))
    {
        let message =
            tr!("object `{id}` has a look for the material `{name}`, which its mesh has not");
        let mut problem = Diagnostic::warning("unknown-material", message)
            .json_path(json_path)
            .suggest(name, materials())
            .hint(tr!(
                "its materials are {names}",
                names = materials().collect::<Vec<_>>().join(", ")
            ));
        source.locate(&mut problem);
        problems.push(problem);
    }
}

/// Looks read from files, by paths relative to a folder.
struct LookFiles<'f> {
    files: &'f dyn Files,
    folder: &'f Path,
    found: Vec<(PathBuf, SetupLook)>,
}

impl LookSource for LookFiles<'_> {
    fn has(&self, name: &str) -> bool {
        self.files.has_file(&self.folder.join(name))
    }

    fn find(&mut self, name: &str) -> WithWarnings<Option<usize>> {
        let path = self.folder.join(name);
        if let Some(index) = self.found.iter().position(|(known, _)| *known == path) {
            return Some(index).into();
        }
        if !self.files.has_file(&path) {
            // The error is reported with the object that names the look.
            return None.into();
        }
        let loaded = Look::load(self.files, &path);
        let problems = loaded.diagnostics.clone();
        let Some(look) = loaded.value.clone() else { return WithWarnings::new(None, problems) };
        let own_folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
        self.found.push((
            path,
            SetupLook { look, source: loaded.source.clone().into(), folder: own_folder },
        ));
        WithWarnings::new(Some(self.found.len() - 1), problems)
    }
}
