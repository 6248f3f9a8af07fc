//! Visible surface, pixel by pixel, for the widgets on it: positions, normals, curvature.
//!
//! The surface is made on a thread of its own by the reference's rasterizer, whenever mesh, camera
//! or size change; it does not depend on lights and layers. It is coarser than the picture
//! ([`MOST`]), which interpolated curves hardly show.

use std::sync::Arc;

use chiaro_locale::tr;
use glam::{DMat3, DVec3, Vec3};

use super::lying;
use crate::diag::Diagnostic;
use crate::document::Camera;
use crate::frame::{Assets, FramePlan, SHAPE_PREFIX, Setup, SetupObject, View};
use crate::ids::ObjectId;
use crate::interp::{Precision, Value};
use crate::library::{Context, Library};
use crate::progress::Progress;
use crate::reference::{
    FragmentStage, Modules, PassImages, PassTarget, QuadBatch, ReferenceOptions, Shader,
    ShaderOutputs, Sides, Texels, Triangles, Varying, VaryingInterpolation, VertexStage,
    execute_screens, rasterize,
};
use crate::state::revision::{FilesRevision, PictureRevision};
use crate::state::scene::ObjectPlace;
use crate::state::session::Session;
use crate::state::snapshot::RenderSnapshot;
use crate::state::worker::Worker;

/// Approximate largest number of pixels: half of those of 500 by 500 along each side.
const MOST: f32 = 62_500.0;
/// Largest deviation of the depth step between two neighbors of one surface from the step that
/// their slope predicts, in pixels times one plus the slope.
const TOLERANCE: f32 = 2.5;
/// Least cosine between normal and view that is used: at a steeper slope every step in depth would
/// be explained.
const LEAST_FACING: f32 = 0.05;

/// Inputs of a surface: for the same inputs the known surface is used.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Key {
    pub(super) mesh: String,
    z_is_up: bool,
    scene: Option<PictureRevision>,
    /// Number of changes to files, meshes among them.
    files: FilesRevision,
    camera: Camera,
    /// Moment, in seconds; 0 where no mesh can move.
    time: f64,
    size: [u32; 2],
}

impl Key {
    /// Key for a picture of this size in points.
    pub(super) fn new(session: &Session, points: eframe::egui::Vec2) -> Self {
        let (orbit, files) = (&session.view.orbit, session.revisions().files);
        // Neither lights nor values move objects.
        let scene = session.open_scene().map(|open| open.snapshot().shape());
        let moves = match session.open_scene() {
            Some(open) => open.snapshot().plays(),
            None => !orbit.mesh.starts_with(SHAPE_PREFIX),
        };
        let scale = (MOST / (points.x * points.y).max(1.0)).sqrt().min(1.0);
        let size =
            [points.x, points.y].map(|side| (side * scale).round().clamp(2.0, 4096.0) as u32);
        Self {
            mesh: orbit.mesh.clone(),
            z_is_up: orbit.z_is_up,
            scene,
            files,
            camera: orbit.camera(),
            time: if moves { session.view.time } else { 0.0 },
            size,
        }
    }
}

/// Grid of pixels of the visible surface. Lists have one entry per pixel, rows from the top.
#[derive(Debug)]
pub(super) struct Surface {
    pub(super) key: Key,
    /// Pixels along x and y.
    pub(super) size: [usize; 2],
    /// Unit normals in world space; 0 where there is no object, or one that does not wear the open
    /// look.
    pub(super) normals: Vec<Vec3>,
    /// Positions in world space.
    pub(super) positions: Vec<Vec3>,
    /// Links of each pixel: bit 0 if the pixel to the right, bit 1 if the one below belongs to the
    /// same piece of surface.
    pub(super) links: Vec<u8>,
    /// Curvature in 1/viewport-height, convex positive, where requested.
    pub(super) kappa: Option<Vec<f32>>,
    pub(super) view: View,
    /// Parts of objects that are visible.
    pub(super) parts_seen: Arc<VisibleParts>,
}

/// Part of an object.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ObjectPart {
    pub(super) object: ObjectId,
    pub(super) material: String,
    /// True if the part wears the open look.
    pub(super) is_open: bool,
}

/// Part visible at each pixel, and the places of all objects.
#[derive(Debug, Default)]
pub(super) struct VisibleParts {
    all: Vec<ObjectPart>,
    /// Number of each pixel's part, from 1 on; 0 where there is none.
    seen: Vec<u16>,
    pub(super) placed: Vec<ObjectPlace>,
}

impl Surface {
    /// Direction from a pixel's position toward the viewer, unit, world space.
    pub(super) fn toward_viewer(&self, pixel: usize) -> Vec3 {
        if self.view.is_perspective {
            (self.view.eye.as_vec3() - self.positions[pixel]).normalize_or(Vec3::Z)
        } else {
            self.view.backward.as_vec3()
        }
    }

    /// Rotation from world to camera axes.
    pub(super) fn camera_from_world(&self) -> DMat3 {
        self.view.rotation()
    }

    pub(super) fn is_covered(&self, pixel: usize) -> bool {
        self.normals[pixel] != Vec3::ZERO
    }

    /// Pixel at a place of the picture, in parts of its size, or the nearest that shows the open
    /// look.
    pub(super) fn nearest(&self, place: [f32; 2]) -> Option<usize> {
        let [width, height] = self.size;
        let at = [place[0] * width as f32 - 0.5, place[1] * height as f32 - 0.5];
        let [x, y] = [
            at[0].round().clamp(0.0, width as f32 - 1.0),
            at[1].round().clamp(0.0, height as f32 - 1.0),
        ];
        let own = y as usize * width + x as usize;
        if self.is_covered(own) {
            return Some(own);
        }
        let distance = |&pixel: &usize| {
            let (dx, dy) = ((pixel % width) as f32 - at[0], (pixel / width) as f32 - at[1]);
            dx * dx + dy * dy
        };
        let covered = (0..self.normals.len()).filter(|&pixel| self.is_covered(pixel));
        covered.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// Pixel at a place of the picture, in parts of its size.
    pub(super) fn pixel_at(&self, place: [f32; 2]) -> Option<usize> {
        let [x, y] = [place[0] * self.size[0] as f32, place[1] * self.size[1] as f32];
        let is_inside =
            x >= 0.0 && y >= 0.0 && (x as usize) < self.size[0] && (y as usize) < self.size[1];
        is_inside.then(|| y as usize * self.size[0] + x as usize)
    }

    /// True if an object that wears the open look is at a place of the picture, in parts of its
    /// size.
    pub(super) fn is_at(&self, place: [f32; 2]) -> bool {
        self.pixel_at(place).is_some_and(|pixel| self.is_covered(pixel))
    }

    /// Part of an object at a place of the picture, in parts of its size, whatever look it wears.
    pub(super) fn piece_at(&self, place: [f32; 2]) -> Option<&ObjectPart> {
        let number = *self.parts_seen.seen.get(self.pixel_at(place)?)?;
        self.parts_seen.all.get(usize::from(number).checked_sub(1)?)
    }

    /// Corners, in parts of the picture's size, of a box around the visible part of an object.
    pub(super) fn box_of(&self, object: &ObjectId) -> Option<[[f32; 2]; 2]> {
        let width = self.size[0];
        let is_it: Vec<bool> =
            self.parts_seen.all.iter().map(|piece| piece.object == *object).collect();
        let of_it =
            |number: &u16| usize::from(*number).checked_sub(1).is_some_and(|piece| is_it[piece]);
        let pixels = self.parts_seen.seen.iter().enumerate().filter(|(_, number)| of_it(number));
        let (mut least, mut most) = ([usize::MAX; 2], [0; 2]);
        for (pixel, _) in pixels {
            let at = [pixel % width, pixel / width];
            for axis in [0, 1] {
                least[axis] = least[axis].min(at[axis]);
                most[axis] = most[axis].max(at[axis] + 1);
            }
        }
        let part = |at: [usize; 2]| [0, 1].map(|axis| at[axis] as f32 / self.size[axis] as f32);
        (least[0] < most[0]).then(|| [part(least), part(most)])
    }

    /// Center of a pixel, in parts of the picture's size.
    pub(super) fn place_of(&self, pixel: usize) -> [f32; 2] {
        let [width, height] = self.size;
        [
            ((pixel % width) as f32 + 0.5) / width as f32,
            ((pixel / width) as f32 + 0.5) / height as f32,
        ]
    }
}

struct SurfaceRequest {
    key: Key,
    snapshot: RenderSnapshot,
    with_kappa: bool,
}

/// Thread that makes surfaces, with the last one.
pub(super) struct Surfaces {
    worker: Worker<SurfaceRequest, Option<Arc<Surface>>>,
    asked: Option<(Key, bool)>,
    last: Option<Arc<Surface>>,
}

impl Surfaces {
    /// `wake` is called from another thread when there is a new surface.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let mut assets = Assets::default();
        let mut last: Option<Arc<Surface>> = None;
        let work = move |request: SurfaceRequest| {
            let old = last.take().filter(|old| old.key == request.key);
            last = match old {
                Some(old) if request.with_kappa && old.kappa.is_none() => {
                    Some(Arc::new(with_kappa(&old)))
                }
                Some(old) => Some(old),
                None => make(&request, &mut assets).map(Arc::new),
            };
            last.clone()
        };
        Self { worker: Worker::new("surface", wake, work), asked: None, last: None }
    }

    /// Requests a surface where needed; returns the last one, if it is of this moment.
    pub(super) fn update(
        &mut self,
        key: &Key,
        with_kappa: bool,
        snapshot: impl FnOnce() -> RenderSnapshot,
    ) -> Option<Arc<Surface>> {
        if let Some(answer) = self.worker.answers().pop() {
            self.last = answer;
        }
        let knows = |(known, kappa): &(Key, bool)| known == key && (*kappa || !with_kappa);
        if !self.asked.as_ref().is_some_and(knows) {
            self.asked = Some((key.clone(), with_kappa));
            let request = SurfaceRequest { key: key.clone(), snapshot: snapshot(), with_kappa };
            self.worker.request(|_| request);
        }
        self.last.clone().filter(|surface| surface.key == *key)
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

/// Surface for a request; `None` where there is no mesh: the picture shows why.
fn make(request: &SurfaceRequest, assets: &mut Assets) -> Option<Surface> {
    let setup = request.snapshot.setup(assets).ok()?.value;
    let surface = surface_of(&setup.posed(request.key.time), &request.key).ok()?;
    Some(if request.with_kappa { with_kappa(&surface) } else { surface })
}

fn surface_of(setup: &Setup, key: &Key) -> Result<Surface, Diagnostic> {
    let size = key.size;
    let reach = |object: &SetupObject| object.center().length() + object.radius();
    let radius = setup.objects.iter().map(reach).fold(1e-6, f64::max);
    let view = View::new(&setup.scene.camera, size, DVec3::ZERO, radius);
    // Parts that wear no look are not drawn.
    let parts = |object: &SetupObject| -> Vec<usize> {
        (0..object.mesh.parts.len()).filter(|&part| object.looks[part].is_some()).collect()
    };
    let parts = setup
        .objects
        .iter()
        .flat_map(|object| parts(object).into_iter().map(move |part| (object, part)));
    let parts: Vec<_> = parts.take(usize::from(u16::MAX)).collect();
    let shaders: Vec<_> = parts
        .iter()
        .zip(1..)
        .map(|((object, _), number)| SurfaceShader::new(object, &view, number))
        .collect();
    let triangles = parts.iter().zip(&shaders).map(|((object, part), shader)| {
        let part = &object.mesh.parts[*part];
        let is_mirrored = DMat3::from_mat4(object.world_from_object).determinant() < 0.0;
        Triangles {
            indices: &object.mesh.indices[part.indices.start as usize..part.indices.end as usize],
            shader,
            sides: Sides { both: part.two_sided, is_mirrored },
        }
    });
    let triangles: Vec<_> = triangles.collect();
    let raster = rasterize(
        size,
        1,
        &PassTarget::Numbers(NUMBERS),
        &triangles,
        &ReferenceOptions::default(),
        &Progress::new(),
    )?;
    let all: Vec<ObjectPart> = parts.iter().map(|(object, part)| piece(object, *part)).collect();
    let vector =
        |numbers: &[f64]| Vec3::new(numbers[0] as f32, numbers[1] as f32, numbers[2] as f32);
    let (mut normals, mut positions, mut seen) = (Vec::new(), Vec::new(), Vec::new());
    for pixel in raster.texels.values.chunks_exact(NUMBERS) {
        let number = pixel[6].round() as u16;
        let is_open = usize::from(number).checked_sub(1).is_some_and(|piece| all[piece].is_open);
        normals.push(if is_open { vector(&pixel[..3]).normalize_or_zero() } else { Vec3::ZERO });
        positions.push(vector(&pixel[3..]));
        seen.push(number);
    }
    let parts_seen =
        Arc::new(VisibleParts { all, seen, placed: setup.objects.iter().map(placed).collect() });
    let size = size.map(|side| side as usize);
    let links = links(&normals, &positions, size, &view);
    Ok(Surface { key: key.clone(), size, normals, positions, links, kappa: None, view, parts_seen })
}

fn piece(object: &SetupObject, part: usize) -> ObjectPart {
    let material = object.mesh.parts[part].material.clone();
    // The open look is the first of a setup's.
    ObjectPart { object: object.id.clone(), material, is_open: object.looks[part] == Some(0) }
}

fn placed(object: &SetupObject) -> ObjectPlace {
    let mut materials: Vec<String> = Vec::new();
    for part in &object.mesh.parts {
        if !materials.contains(&part.material) {
            materials.push(part.material.clone());
        }
    }
    let motion = object.mesh.motion.as_ref();
    let animations = motion.map_or(&[][..], |motion| motion.animations());
    let cameras = motion.map_or(&[][..], |motion| motion.cameras());
    ObjectPlace {
        id: object.id.clone(),
        center: object.center(),
        radius: object.radius(),
        seems_to_lie: lying::seems_to_lie(&object.mesh.bounds()),
        materials,
        animations: animations.iter().map(|animation| animation.name.clone()).collect(),
        cameras: cameras.iter().map(|camera| camera.name.clone()).collect(),
    }
}

/// Links between neighbors on one piece of surface: those no farther apart in depth than their
/// slopes explain.
fn links(
    normals: &[Vec3],
    positions: &[Vec3],
    [width, height]: [usize; 2],
    view: &View,
) -> Vec<u8> {
    let rotation = view.rotation().as_mat3();
    let (eye, backward) = (view.eye.as_vec3(), view.backward.as_vec3());
    let depth = |pixel: usize| (eye - positions[pixel]).dot(backward);
    let is_one = |a: usize, b: usize, axis: usize| {
        if normals[a] == Vec3::ZERO || normals[b] == Vec3::ZERO {
            return false;
        }
        let pixel = view.pixel_size_at(f64::from(depth(a))) as f32;
        let step = depth(b) - depth(a);
        [a, b].into_iter().any(|at| {
            let n = rotation * normals[at];
            let slope = [n.x, -n.y][axis] / n.z.max(LEAST_FACING);
            (step - slope * pixel).abs() <= TOLERANCE * pixel * (1.0 + slope.abs())
        })
    };
    let linked = |pixel: usize| {
        let (x, y) = (pixel % width, pixel / width);
        let right = x + 1 < width && is_one(pixel, pixel + 1, 0);
        let below = y + 1 < height && is_one(pixel, pixel + width, 1);
        u8::from(right) | u8::from(below) << 1
    };
    (0..width * height).map(linked).collect()
}

/// The surface with curvature, measured by the same pass as in the picture.
fn with_kappa(surface: &Surface) -> Surface {
    let Surface { key, size, normals, positions, links, view, parts_seen, .. } = surface;
    Surface {
        key: key.clone(),
        size: *size,
        normals: normals.clone(),
        positions: positions.clone(),
        links: links.clone(),
        kappa: Some(kappa(surface).unwrap_or_else(|_| vec![0.0; normals.len()])),
        view: *view,
        parts_seen: parts_seen.clone(),
    }
}

fn kappa(surface: &Surface) -> Result<Vec<f32>, Diagnostic> {
    let (size, view) = (surface.key.size, surface.view);
    let drawn = texels(surface)?;
    let pass = Context::KAPPA.pass();
    let nothing = || Diagnostic::error("reference-plan", tr!("no pass measures curvature"));
    let pass = pass.ok_or_else(nothing)?;
    let plan = FramePlan::of_screens(pass, view, size);
    let mut images = PassImages::default();
    plan.missing().for_each(|of_meshes| images.insert(of_meshes, &drawn));
    let modules = Modules::new(&plan, Precision::F64)?;
    execute_screens(&plan, &mut images, &modules, &ReferenceOptions::default(), &Progress::new())?;
    let texels = images.first(pass).ok_or_else(nothing)?;
    Ok(texels.values.iter().map(|&x| x as f32).collect())
}

/// Texels of the surface as the pass that draws normals makes them, by its own function.
fn texels(surface: &Surface) -> Result<Texels, Diagnostic> {
    let (view, rotation) = (surface.view, surface.view.rotation());
    let nothing = || Diagnostic::error("reference-plan", tr!("no function packs texels"));
    let node = Library::built_in().nodes.values().next().ok_or_else(nothing)?;
    let program = node.module.program("surface_texel")?;
    let mut machine = program.machine(Precision::F64);
    let mut drawn = Texels::new(surface.key.size, 4);
    let pixels = surface.normals.iter().zip(&surface.positions);
    for ((normal, position), texel) in pixels.zip(drawn.values.chunks_exact_mut(4)) {
        if *normal != Vec3::ZERO {
            let normal = (rotation * normal.as_dvec3()).to_array();
            let depth = view.backward.dot(view.eye - position.as_dvec3());
            let packed = machine.call(&[Value::vec(&normal), depth.into(), 1.0.into()])?;
            texel.copy_from_slice(&packed.as_vec::<4>().ok_or_else(nothing)?);
        }
    }
    Ok(drawn)
}

/// Number of values of a fragment: normal, position, and number of the part.
const NUMBERS: usize = 7;

/// Shader that draws a part's normals and positions, world space, and its number.
struct SurfaceShader<'a> {
    object: &'a SetupObject,
    number: usize,
    clip_from_object: glam::DMat4,
    normals: DMat3,
}

impl<'a> SurfaceShader<'a> {
    fn new(object: &'a SetupObject, view: &View, number: usize) -> Self {
        let linear = DMat3::from_mat4(object.world_from_object);
        let normals =
            if linear.determinant().abs() > 1e-12 { linear.inverse().transpose() } else { linear };
        Self {
            object,
            number,
            clip_from_object: view.clip_from_world * object.world_from_object,
            normals,
        }
    }
}

const VARYINGS: [Varying; 2] =
    [Varying { components: 3, interpolation: VaryingInterpolation::Perspective }; 2];

impl Shader for SurfaceShader<'_> {
    fn varyings(&self) -> &[Varying] {
        &VARYINGS
    }

    fn vertices(&self) -> Box<dyn VertexStage + '_> {
        Box::new(SurfaceStages(self))
    }

    fn fragments(&self) -> Box<dyn FragmentStage + '_> {
        Box::new(SurfaceStages(self))
    }
}

struct SurfaceStages<'a>(&'a SurfaceShader<'a>);

impl VertexStage for SurfaceStages<'_> {
    fn shade(&mut self, vertices: &[u32], out: &mut [f64]) -> Result<(), Diagnostic> {
        let SurfaceShader { object, clip_from_object, normals, .. } = self.0;
        for (&vertex, out) in vertices.iter().zip(out.chunks_exact_mut(10)) {
            let position = DVec3::from(object.mesh.positions[vertex as usize].map(f64::from));
            let normal =
                *normals * DVec3::from(object.mesh.normals[vertex as usize].map(f64::from));
            out[..4].copy_from_slice(&(*clip_from_object * position.extend(1.0)).to_array());
            out[4..7].copy_from_slice(&normal.normalize_or_zero().to_array());
            out[7..]
                .copy_from_slice(&object.world_from_object.transform_point3(position).to_array());
        }
        Ok(())
    }
}

impl FragmentStage for SurfaceStages<'_> {
    fn shade(&mut self, batch: &QuadBatch, out: &mut ShaderOutputs) -> Result<(), Diagnostic> {
        for component in 0..6 {
            out.channel_mut(component)[..batch.lanes()]
                .copy_from_slice(&batch.varying(component)[..batch.lanes()]);
        }
        out.channel_mut(6)[..batch.lanes()].fill(self.0.number as f64);
        // Back faces have their normals turned around, as looks see them.
        for lane in (0..batch.lanes()).filter(|lane| batch.front() >> lane & 1 == 0) {
            (0..3).for_each(|component| out.channel_mut(component)[lane] *= -1.0);
        }
        Ok(())
    }
}
