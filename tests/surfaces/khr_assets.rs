//! glTF files that move, against the same computed anew from the specification (`gltf_truth`): the
//! sample assets of the Khronos Group where a folder has them, none of which is shipped. Files of
//! our own that have what the assets show are in `khr_features`.
//!
//! A mesh's triangles are those of the file in another order, without those that have no area, so
//! they are first found in each other by their places at rest. What a file does not have is
//! computed anew of the deformed triangles: made normals, and made tangents, which go along with
//! the triangles as lines drawn on them would.

use std::collections::{BTreeMap, HashMap, VecDeque};
use std::fmt;
use std::hash::Hash;
use std::path::{Path, PathBuf};

use chiaro::diag::{Diagnostic, WithWarnings};
use chiaro::files::Disk;
use chiaro::geometry::{Animation, Mesh, Motion, load};
use glam::{DMat3, DVec3, DVec4};

use crate::gltf_truth::{GltfTruth, PointTruth};
use crate::support::files;
use crate::support::validators::say;

/// Greatest distance from the truth, against the numbers that a place is a sum of: a place and the
/// weights of joints are rounded to f32 once. Of files in which nothing moves, matrices are in f32.
const OFF: f64 = 1e-6;
const OFF_STILL: f64 = 1e-5;
/// Greatest distance of unit vectors from the truth, where nothing is flattened.
const TURNED: f64 = 1e-5;
/// Least roundness of a matrix, and least share of what cancels out, at which vectors are compared.
const LEAST: f64 = 1e-3;
/// Number of times of each animation.
const TIMES: usize = 8;

/// Counts of what was compared, and how far the worst place is off.
#[derive(Debug, Default)]
pub(crate) struct ComparedCounts {
    pub(crate) animations: usize,
    pub(crate) poses: usize,
    pub(crate) triangles: usize,
    /// Number of the file's triangles that have no area, and are not drawn.
    pub(crate) left_out: usize,
    /// Numbers of normals and tangents of the file, and of made ones of both, that were compared.
    pub(crate) vectors: [usize; 4],
    /// Greatest distance of a place, against the numbers that it is a sum of.
    worst: f64,
}

impl fmt::Display for ComparedCounts {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { animations, poses, triangles, left_out, vectors, worst } = self;
        let [normals, tangents, made_normals, made_tangents] = vectors;
        write!(
            out,
            "{animations} animations, {poses} poses of {triangles} triangles ({left_out} without \
             area), {normals} and {made_normals} made normals, {tangents} and {made_tangents} made \
             tangents, off by {worst:.0e}"
        )
    }
}

/// Numbers as bits, by which equal rows are found: 0 and -0 are one.
fn bits<const N: usize>(row: [f32; N]) -> [u32; N] {
    row.map(|number| (number + 0.0).to_bits())
}

fn at(row: [f32; 3]) -> DVec3 {
    DVec3::from(row.map(f64::from))
}

fn tangent_at(mesh: &Mesh, vertex: usize) -> DVec3 {
    DVec4::from(mesh.tangents[vertex].map(f64::from)).truncate()
}

/// The mesh of a file, compared with the truth.
struct MeshComparison<'a> {
    truth: &'a GltfTruth,
    rest: &'a Mesh,
    /// Primitive and point of each corner of the mesh's triangles.
    corners: Vec<(usize, usize)>,
    /// True for vertices whose normals were made, and for those whose tangents were.
    has_made: Vec<[bool; 2]>,
    told: ComparedCounts,
}

/// Triangle of the truth: the number of its primitive, and its points.
type TrueTriangle = (usize, [usize; 3]);

/// The orders of a triangle's corners: three ways round, then three of the other way.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]];

impl<'a> MeshComparison<'a> {
    /// Finds the mesh's triangles in the file.
    ///
    /// # Errors
    /// The first triangle that is not in its place, at rest, in the order of its material.
    fn new(rest: &'a Mesh, truth: &'a GltfTruth, off: f64) -> Result<Self, String> {
        let points = truth.posed(None);
        let mut queues: BTreeMap<Option<usize>, VecDeque<TrueTriangle>> = BTreeMap::new();
        let mut names: HashMap<Option<usize>, String> = HashMap::new();
        for (number, primitive) in truth.primitives.iter().enumerate() {
            let name = match (primitive.material_name.as_str(), primitive.material) {
                ("", None) => "default".to_owned(),
                ("", Some(material)) => format!("material_{material}"),
                (name, _) => name.to_owned(),
            };
            names.insert(primitive.material, name);
            let queue = queues.entry(primitive.material).or_default();
            queue.extend(primitive.triangles.iter().map(|triangle| (number, *triangle)));
        }
        let mut this = Self {
            truth,
            rest,
            corners: Vec::with_capacity(rest.indices.len()),
            has_made: vec![[false; 2]; rest.positions.len()],
            told: ComparedCounts { triangles: rest.triangle_count(), ..ComparedCounts::default() },
        };
        for part in &rest.parts {
            let triangles = &rest.indices[part.indices.start as usize..part.indices.end as usize];
            for vertices in triangles.as_chunks::<3>().0 {
                let places = vertices.map(|vertex| at(rest.positions[vertex as usize]));
                let mut named = queues.iter_mut().filter(|(key, _)| names[*key] == part.material);
                let found = named.find_map(|(_, queue)| this.next(queue, places, &points, off));
                let found = found.ok_or_else(|| {
                    format!("the file has no triangle at {places:?} next, of `{}`", part.material)
                })?;
                this.take(*vertices, found, &points)?;
            }
        }
        let more: Vec<TrueTriangle> = queues.into_values().flatten().collect();
        if let Some(more) = more.iter().find(|triangle| !has_no_area(**triangle, &points)) {
            return Err(format!("the mesh lacks the triangle {more:?}"));
        }
        this.told.left_out += more.len();
        Ok(this)
    }

    /// Takes the next triangle of a queue if it is at these places, and tells in which order. Those
    /// without an area may be missing.
    fn next(
        &mut self,
        queue: &mut VecDeque<TrueTriangle>,
        places: [DVec3; 3],
        points: &[Vec<PointTruth>],
        off: f64,
    ) -> Option<(TrueTriangle, usize)> {
        while let Some(&(number, triangle)) = queue.front() {
            let distance = |order: &[usize; 3]| {
                let truth = order.map(|corner| points[number][triangle[corner]]);
                let pairs = places.iter().zip(truth);
                let distances = pairs.map(|(place, truth)| {
                    let distance = place.distance(truth.place);
                    if distance <= off * truth.reach { distance } else { f64::INFINITY }
                });
                distances.sum::<f64>()
            };
            // Of a tiny triangle all corners are near each other: the nearest order is the one.
            let orders = ORDERS.iter().map(distance).enumerate();
            let nearest = orders.min_by(|(_, a), (_, b)| a.total_cmp(b));
            if let Some((order, _)) = nearest.filter(|(_, distance)| distance.is_finite()) {
                queue.pop_front();
                return Some(((number, triangle), order));
            }
            if !has_no_area((number, triangle), points) {
                return None;
            }
            queue.pop_front();
            self.told.left_out += 1;
        }
        None
    }

    /// Notes what a triangle's corners are made of.
    fn take(
        &mut self,
        vertices: [u32; 3],
        ((number, triangle), order): (TrueTriangle, usize),
        points: &[Vec<PointTruth>],
    ) -> Result<(), String> {
        let is_turned = order >= 3;
        if is_turned != points[number][0].is_mirrored {
            return Err(format!("a triangle of primitive {number} is wound the wrong way"));
        }
        for (vertex, corner) in vertices.into_iter().zip(ORDERS[order]) {
            let point = triangle[corner];
            self.corners.push((number, point));
            let truth = points[number][point];
            let has_tangent = self.truth.primitives[number].has_tangents();
            self.has_made[vertex as usize] = [!truth.has_normal, !has_tangent];
        }
        Ok(())
    }

    /// Compares the mesh with the file in a pose.
    ///
    /// # Errors
    /// The first vertex that is wrong.
    fn compare(
        &mut self,
        mesh: &Mesh,
        animation: Option<(usize, f64)>,
        off: f64,
    ) -> Result<(), String> {
        let points = self.truth.posed(animation);
        if mesh.indices != self.rest.indices || mesh.uvs != self.rest.uvs {
            return Err("a pose changed triangles or UVs".to_owned());
        }
        self.told.poses += 1;
        for (&(number, point), &vertex) in self.corners.iter().zip(&mesh.indices) {
            let (truth, vertex) = (points[number][point], vertex as usize);
            let told = |what: &str, found: String| {
                format!("{what} of vertex {vertex} (point {point} of primitive {number}): {found}")
            };
            let distance = at(mesh.positions[vertex]).distance(truth.place);
            let share = distance / truth.reach.max(f64::MIN_POSITIVE);
            let is_near = share <= off || distance == 0.0;
            if !is_near {
                let found = mesh.positions[vertex];
                return Err(told("the place", format!("{found:?} is not {}", truth.place)));
            }
            self.told.worst = self.told.worst.max(share);
            let vectors = self.vectors(mesh, vertex, &truth);
            let [normals, tangents] = vectors.map_err(|found| told("a vector", found))?;
            self.told.vectors[0] += normals;
            self.told.vectors[1] += tangents;
        }
        if animation.is_some() {
            self.made_normals(mesh)?;
            self.made_tangents(mesh)?;
        }
        Ok(())
    }

    /// Compares the normal and the tangent that the file has for a vertex, and counts them. How far
    /// they may be off grows as the vertex's matrix flattens.
    fn vectors(
        &self,
        mesh: &Mesh,
        vertex: usize,
        truth: &PointTruth,
    ) -> Result<[usize; 2], String> {
        let normal = at(mesh.normals[vertex]);
        let tangent = tangent_at(mesh, vertex);
        let side = f64::from(mesh.tangents[vertex][3]);
        let lengths = [normal.length() - 1.0, tangent.length() - 1.0, normal.dot(tangent)];
        let is_frame = lengths.iter().all(|off| off.abs() < TURNED) && side.abs() == 1.0;
        if !is_frame {
            return Err(format!("normal {normal} and tangent {tangent}, {side} are no frame"));
        }
        let mut counts = [0; 2];
        if truth.roundness < LEAST {
            return Ok(counts);
        }
        let off = TURNED / truth.roundness.min(1.0);
        let [is_made, _] = self.has_made[vertex];
        if let Some(expected) = truth.normal.filter(|_| !is_made) {
            counts[0] = 1;
            if normal.distance(expected) > off {
                return Err(format!("normal {normal} is not {expected}"));
            }
        }
        let Some(expected) = truth.tangent else { return Ok(counts) };
        let upright = expected.truncate().reject_from(normal);
        if upright.length() > 0.1 {
            counts[1] = 1;
            let mirrored = if truth.is_mirrored { -1.0 } else { 1.0 };
            if tangent.distance(upright.normalize()) > 10.0 * off || side != mirrored * expected.w {
                return Err(format!("tangent {tangent}, {side} is not {expected}"));
            }
        }
        Ok(counts)
    }

    /// Corners of the vertices that share a made vector: those of equal keys at rest.
    fn groups<K: Hash + Eq>(&self, made: usize, key: impl Fn(usize) -> K) -> Vec<Vec<usize>> {
        let mut groups: HashMap<K, Vec<usize>> = HashMap::new();
        for (corner, &vertex) in self.rest.indices.iter().enumerate() {
            if self.has_made[vertex as usize][made] {
                groups.entry(key(vertex as usize)).or_default().push(corner);
            }
        }
        groups.into_values().collect()
    }

    /// Compares made normals with the mean of the deformed triangles' around a vertex, each
    /// weighted by its angle there.
    fn made_normals(&mut self, mesh: &Mesh) -> Result<(), String> {
        let rest = self.rest;
        for corners in self.groups(0, |v| (bits(rest.positions[v]), bits(rest.normals[v]))) {
            let (mut sum, mut angles) = (DVec3::ZERO, 0.0);
            for &corner in &corners {
                let [a, b, c] = triangle(mesh, corner);
                let angle = (b - a).angle_between(c - a);
                if angle.is_finite() {
                    sum += angle * (b - a).cross(c - a).normalize_or_zero();
                    angles += angle;
                }
            }
            // What nearly cancels out is left to rounding.
            if sum.length() < LEAST * angles || angles < LEAST {
                continue;
            }
            let off = TURNED * angles / sum.length();
            for corner in corners {
                let vertex = mesh.indices[corner] as usize;
                let (normal, expected) = (at(mesh.normals[vertex]), sum.normalize());
                self.told.vectors[2] += 1;
                if normal.distance(expected) > off {
                    return Err(format!("made normal {normal} of {vertex} is not {expected}"));
                }
            }
        }
        Ok(())
    }

    /// Compares made tangents with lines that are drawn on the triangles at rest.
    fn made_tangents(&mut self, mesh: &Mesh) -> Result<(), String> {
        let rest = self.rest;
        let key = |v: usize| {
            let place = (bits(rest.positions[v]), bits(rest.normals[v]));
            (place, bits(rest.uvs[v]), bits(rest.tangents[v]))
        };
        for corners in self.groups(1, key) {
            let line = tangent_at(rest, rest.indices[corners[0]] as usize);
            let (mut sum, mut lengths, mut is_thin) = (DVec3::ZERO, 0.0, false);
            for &corner in &corners {
                let [from, to] = [rest, mesh].map(|mesh| triangle(mesh, corner));
                is_thin |= is_degenerate(from, 1e-5);
                let carried = carried(line, from, to);
                sum += carried;
                lengths += carried.length();
            }
            if is_thin || sum.length() < LEAST * lengths || lengths < f64::MIN_POSITIVE {
                continue;
            }
            for corner in corners {
                let vertex = mesh.indices[corner] as usize;
                let upright = sum.normalize().reject_from(at(mesh.normals[vertex]));
                if upright.length() < 0.1 {
                    continue;
                }
                let (tangent, expected) = (tangent_at(mesh, vertex), upright.normalize());
                let off = 10.0 * TURNED * lengths / sum.length();
                self.told.vectors[3] += 1;
                let is_side = mesh.tangents[vertex][3] == rest.tangents[vertex][3];
                if tangent.distance(expected) > off || !is_side {
                    return Err(format!("made tangent {tangent} of {vertex} is not {expected}"));
                }
            }
        }
        Ok(())
    }
}

/// The places of the triangle at a corner, from the corner's own on.
fn triangle(mesh: &Mesh, corner: usize) -> [DVec3; 3] {
    let (start, own) = (corner / 3 * 3, corner % 3);
    [0, 1, 2].map(|next| at(mesh.positions[mesh.indices[start + (own + next) % 3] as usize]))
}

/// True if a triangle's height is less than that share of its longest edge.
fn is_degenerate([a, b, c]: [DVec3; 3], share: f64) -> bool {
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    (b - a).cross(c - a).length() <= share * longest * longest
}

/// True if a triangle at rest has no area, or so little that rounding decides.
fn has_no_area((number, triangle): TrueTriangle, points: &[Vec<PointTruth>]) -> bool {
    is_degenerate(triangle.map(|point| points[number][point].place), 1e-6)
}

/// A line that was drawn on a triangle, by the matrix that brings the triangle's edges from where
/// they were to where they are, and its normal to nothing.
fn carried(line: DVec3, from: [DVec3; 3], to: [DVec3; 3]) -> DVec3 {
    let edges = |[a, b, c]: [DVec3; 3]| [b - a, c - a];
    let ([u, v], [moved_u, moved_v]) = (edges(from), edges(to));
    let frame = DMat3::from_cols(u, v, u.cross(v).normalize());
    DMat3::from_cols(moved_u, moved_v, DVec3::ZERO) * (frame.inverse() * line)
}

/// Times of an animation to compare at: before and after its keys, at some of them, and between.
fn times(keys: &[f64]) -> Vec<f64> {
    let (Some(&first), Some(&last)) = (keys.first(), keys.last()) else { return Vec::new() };
    let between = |number: usize| first + (last - first) * (number as f64 + 0.37) / TIMES as f64;
    let mut times = vec![first - 1.0, first, keys[keys.len() / 2], keys[keys.len() / 3], last];
    times.extend((0..TIMES).map(between));
    times.push(last + 1.0);
    times
}

/// Compares the cameras' places; those of equal names cannot be told apart.
fn compare_cameras(
    (motion, truth): (&Motion, &GltfTruth),
    pose: Option<(&Animation, f64)>,
    animation: Option<(usize, f64)>,
) -> Result<(), String> {
    let named = |name: &str| motion.cameras().iter().filter(|camera| camera.name == name).count();
    if motion.cameras().len() != truth.cameras.len() {
        return Err(format!("there are {} cameras", truth.cameras.len()));
    }
    for (camera, &number) in motion.cameras().iter().zip(&truth.cameras) {
        if named(&camera.name) > 1 {
            continue;
        }
        let (_, node) = motion.camera(&camera.name).ok_or("a camera is not found by its name")?;
        let (found, expected) = (motion.pose(pose).node(node), truth.node(number, animation));
        let most = |numbers: [f64; 16]| numbers.into_iter().map(f64::abs).fold(0.0, f64::max);
        let off = most((found - expected).to_cols_array()) / most(expected.to_cols_array());
        if node as usize != number || off.is_nan() || off > OFF {
            return Err(format!("camera `{}`: {found} is not {expected}", camera.name));
        }
    }
    Ok(())
}

/// Compares a mesh with its file, at rest and in poses of all its animations.
///
/// # Errors
/// The first difference.
pub(crate) fn compare(mesh: &Mesh, truth: &GltfTruth) -> Result<ComparedCounts, String> {
    let animations = truth.animations();
    let off = if animations.is_empty() { OFF_STILL } else { OFF };
    let mut compared = MeshComparison::new(mesh, truth, off)?;
    compared.compare(mesh, None, off)?;
    let Some(motion) = &mesh.motion else {
        return match animations.is_empty() {
            true => Ok(compared.told),
            false => Err("nothing moves".to_owned()),
        };
    };
    compare_cameras((motion, truth), None, None)?;
    let found: Vec<&str> = motion.animations().iter().map(|one| one.name.as_str()).collect();
    let expected: Vec<&str> = animations.iter().map(|(_, name)| *name).collect();
    if found != expected {
        return Err(format!("the animations are {found:?}, not {expected:?}"));
    }
    for (animation, &(number, name)) in motion.animations().iter().zip(&animations) {
        let keys = truth.key_times(number);
        if animation.key_times() != keys {
            return Err(format!("animation `{name}` has other keys"));
        }
        compared.told.animations += 1;
        for time in times(&keys) {
            let (pose, of_truth) = (Some((animation, time)), Some((number, time)));
            let posed = mesh.posed(&motion.pose(pose));
            let told = |why: String| format!("animation `{name}` at {time}: {why}");
            compared.compare(&posed, of_truth, off).map_err(told)?;
            compare_cameras((motion, truth), pose, of_truth).map_err(told)?;
        }
    }
    Ok(compared.told)
}

/// The verdict on an asset.
enum AssetVerdict {
    Equal(ComparedCounts),
    /// Errors with which the file was refused.
    Refused(Vec<Diagnostic>),
    /// Parts that were read by neither reader, or by one only.
    InPart(String),
}

/// True for what is said of motion that was left out.
fn is_left_out(warning: &Diagnostic) -> bool {
    warning.code == "mesh-animation" && !warning.message.contains("were scaled")
}

/// Reads an asset, and compares it.
fn verdict(path: &Path) -> Result<AssetVerdict, String> {
    let WithWarnings { value: mesh, warnings } = match load(&Disk, path) {
        Ok(read) => read,
        Err(problems) => {
            let is_clear =
                |problem: &Diagnostic| !problem.message.is_empty() && problem.place.file.is_some();
            let is_told = problems.iter().any(Diagnostic::is_error);
            return match is_told && problems.iter().all(is_clear) {
                true => Ok(AssetVerdict::Refused(problems)),
                false => Err(format!("it is refused, but not told why: {problems:?}")),
            };
        }
    };
    if let Some(warning) = warnings.iter().find(|warning| is_left_out(warning)) {
        return Ok(AssetVerdict::InPart(warning.message.clone()));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let sibling = |name: &str| std::fs::read(folder.join(name)).map_err(|why| why.to_string());
    let bytes = std::fs::read(path).map_err(|why| why.to_string())?;
    let truth = GltfTruth::read(&bytes, &sibling)?;
    if truth.has_copies {
        return Ok(AssetVerdict::InPart("copies of meshes are not computed anew".to_owned()));
    }
    if truth.has_blurred_rotations() {
        return Ok(AssetVerdict::InPart("a rotation is no unit quaternion".to_owned()));
    }
    compare(&mesh, &truth).map(AssetVerdict::Equal)
}

/// All sample assets of a folder. Each is equal to the specification, or refused with a reason.
#[test]
#[ignore = "assets are not shipped; scripts/soak runs it where CHIARO_KHR_ASSETS names them"]
fn soak_khr_assets_move_as_their_specification_says() {
    let Some(folder) = std::env::var_os("CHIARO_KHR_ASSETS").map(PathBuf::from) else {
        say("SKIPPED: CHIARO_KHR_ASSETS names no folder; clone glTF-Sample-Assets of the Khronos \
             Group, and set it to the whole path of the clone's folder `Models`");
        return;
    };
    let mut assets = files::below(&folder);
    assets
        .retain(|path| path.extension().is_some_and(|ending| ending == "gltf" || ending == "glb"));
    assert!(!assets.is_empty(), "no .gltf and no .glb is in {}", folder.display());
    let (mut moved, mut wrong) = (0, Vec::new());
    for path in &assets {
        let name = path.strip_prefix(&folder).unwrap_or(path).display();
        // A panic is told with the name of its file, and the others are looked at all the same.
        let found = std::panic::catch_unwind(|| verdict(path));
        match found.unwrap_or_else(|_| Err("it panicked".to_owned())) {
            Ok(AssetVerdict::Equal(told)) => {
                moved += told.animations;
                say(&format!("{name}: {told}"));
            }
            Ok(AssetVerdict::Refused(problems)) => {
                problems.iter().for_each(|problem| say(&format!("{name}: REFUSED, {problem}")));
            }
            Ok(AssetVerdict::InPart(why)) => say(&format!("{name}: NOT COMPARED, {why}")),
            Err(why) => {
                say(&format!("{name}: WRONG, {why}"));
                wrong.push(format!("{name}: {why}"));
            }
        }
    }
    say(&format!("{} assets with {moved} animations", assets.len()));
    assert!(wrong.is_empty(), "{} are wrong:\n{}", wrong.len(), wrong.join("\n"));
    assert!(moved > 0, "none of the assets in {} moves", folder.display());
}
