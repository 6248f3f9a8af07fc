//! Motion in a glTF: nodes, skins, morph targets, animations and cameras.
//!
//! Nothing wrong here keeps the triangles from being used: what cannot be read is left out with a
//! warning, an animation's channel, a skin, or all of it. Counts are bounded before anything is
//! read, because accessors may be named any number of times.

use chiaro_locale::tr;
use glam::{DMat4, DQuat, DVec3};
use gltf::accessor::Dimensions;
use gltf::{Accessor, Document, Primitive, Semantic};
use serde::Deserialize;

use super::primitive::AttributeOffsets;
use super::{accessor, json};
use crate::diag::Diagnostic;
use crate::geometry::import::report::{ImportProblem, ImportReport};
use crate::geometry::import::source::Source;
use crate::geometry::motion::{
    Animation, CameraLens, Channel, Curve, KeyInterpolation, Motion, MovedNode, MovedPart,
    NodeCamera, NodeProperty, PointChange, Pose, Skin,
};
use crate::geometry::soup::TriangleSoup;

/// Greatest count of numbers in all curves of a file.
const MAX_CURVE_NUMBERS: usize = 1 << 24;
/// Greatest count of joints in all skins of a file, and of one skin.
const MAX_JOINTS: usize = 1 << 16;
/// Greatest count of joints' shares of all points of a file.
const MAX_INFLUENCES: usize = 1 << 26;
/// Greatest count of changes that morph targets make to points, and of points that are asked.
const MAX_CHANGES: usize = 1 << 23;
const MAX_ASKED: usize = 1 << 28;
/// Greatest number of sets of four joints that move a point.
const MAX_SETS: u32 = 4;
/// Difference of a point's shares from 1 that is told, in all.
const SHARES_OFF: f64 = 0.01;

/// The members of a glTF's JSON that say what moves.
#[derive(Default, Deserialize)]
#[serde(default)]
struct MotionMembers {
    skins: Vec<SkinMember>,
    animations: Vec<AnimationMember>,
    cameras: Vec<CameraMember>,
    nodes: Vec<NodeMember>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
struct NodeMember {
    name: String,
    skin: Option<usize>,
    camera: Option<usize>,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct SkinMember {
    joints: Vec<usize>,
    inverse_bind_matrices: Option<usize>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
struct AnimationMember {
    name: String,
    channels: Vec<ChannelMember>,
    samplers: Vec<SamplerMember>,
}

#[derive(Deserialize)]
struct ChannelMember {
    sampler: usize,
    target: TargetMember,
}

#[derive(Deserialize)]
struct TargetMember {
    node: Option<usize>,
    path: String,
}

#[derive(Deserialize)]
struct SamplerMember {
    input: usize,
    output: usize,
    #[serde(default)]
    interpolation: String,
}

#[derive(Default, Deserialize)]
#[serde(default)]
struct CameraMember {
    name: String,
    perspective: Option<PerspectiveMember>,
    orthographic: Option<OrthographicMember>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct PerspectiveMember {
    yfov: f64,
    #[serde(default)]
    aspect_ratio: f64,
}

#[derive(Deserialize)]
struct OrthographicMember {
    xmag: f64,
    ymag: f64,
}

/// Recorder of points that move.
pub(super) struct MotionRecorder {
    /// Skin of each node's mesh.
    skins: Vec<Option<u32>>,
    /// Pose of the file without an animation.
    rest: Pose,
    /// Number of points that morph targets were asked for.
    asked: usize,
    /// Warnings that were not told yet, each once.
    warnings: Vec<String>,
}

/// Place of a mesh.
#[derive(Clone, Copy)]
pub(super) struct MeshPlace {
    /// Number of the node.
    pub(super) node: u32,
    /// Transform from the mesh's space to the node's, of a copy of the mesh.
    pub(super) instance: DMat4,
}

/// Reads what moves in a file, and where cameras stand. `None` where there is neither; without a
/// recorder the file's triangles stand as they are.
pub(super) fn read(
    json: &[u8],
    document: &Document,
    buffers: &[Source],
    report: &mut ImportReport,
) -> Option<(Motion, Option<MotionRecorder>)> {
    let members: MotionMembers = match json::deserialize::from_slice(json) {
        Ok(members) => members,
        Err(error) => {
            let message = tr!("skins, animations and cameras are left out: {error}");
            report.add(Diagnostic::warning("mesh-animation", message));
            return None;
        }
    };
    let nodes = nodes(document);
    let reader =
        MemberReader { accessors: document.accessors().collect(), buffers, nodes: nodes.len() };
    let mut motion = Motion { order: order(&nodes), nodes, ..Motion::default() };
    let numbers = reader.skins(&members.skins, &mut motion, report);
    motion.animations = reader.animations(&members.animations, &motion.nodes, report);
    motion.cameras = cameras(&members);
    let skin_of = |node: &NodeMember| *numbers.get(node.skin?)?;
    let skins: Vec<Option<u32>> = members.nodes.iter().map(skin_of).collect();
    let has_weights = || motion.nodes.iter().any(|node| node.weights.iter().any(|w| *w != 0.0));
    let moves = !motion.animations.is_empty() || skins.iter().any(Option::is_some) || has_weights();
    if !moves {
        return (!motion.cameras.is_empty()).then_some((motion, None));
    }
    let rest = motion.pose(None);
    motion.points.starts.push(0);
    Some((motion, Some(MotionRecorder { skins, rest, asked: 0, warnings: Vec::new() })))
}

/// The nodes as they stand, those of the scene without parents outside of the scene.
fn nodes(document: &Document) -> Vec<MovedNode> {
    let node = |node: gltf::Node| {
        let transform = node.transform();
        let matrix = match transform {
            gltf::scene::Transform::Matrix { matrix } => {
                Some(DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from))))
            }
            gltf::scene::Transform::Decomposed { .. } => None,
        };
        let (translation, rotation, scale) = transform.decomposed();
        let rotation = DQuat::from_array(rotation.map(f64::from));
        let is_turn = rotation.is_finite() && rotation.length() > 1e-12;
        MovedNode {
            parent: None,
            matrix,
            translation: DVec3::from(translation.map(f64::from)),
            rotation: if is_turn { rotation.normalize() } else { DQuat::IDENTITY },
            scale: DVec3::from(scale.map(f64::from)),
            weights: weights(&node),
        }
    };
    let mut nodes: Vec<MovedNode> = document.nodes().map(node).collect();
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let mut is_root = vec![false; nodes.len()];
    let roots = scene.iter().flat_map(gltf::Scene::nodes);
    roots.for_each(|root| is_root[root.index()] = true);
    for node in document.nodes() {
        for child in node.children().filter(|child| !is_root[child.index()]) {
            nodes[child.index()].parent.get_or_insert(node.index() as u32);
        }
    }
    nodes
}

/// Weights of the morph targets of a node's mesh, as they are without an animation.
fn weights(node: &gltf::Node) -> Vec<f64> {
    let Some(mesh) = node.mesh() else { return Vec::new() };
    let count = mesh.primitives().map(|primitive| primitive.morph_targets().len()).max();
    let given = node.weights().or(mesh.weights()).unwrap_or_default();
    let mut weights: Vec<f64> = given.iter().map(|weight| f64::from(*weight)).collect();
    weights.iter_mut().filter(|weight| !weight.is_finite()).for_each(|weight| *weight = 0.0);
    weights.resize(count.unwrap_or_default(), 0.0);
    weights
}

/// Numbers of the nodes, each after its parent; nodes within themselves have none.
fn order(nodes: &[MovedNode]) -> Vec<u32> {
    let mut children: Vec<Vec<u32>> = vec![Vec::new(); nodes.len()];
    let mut order = Vec::with_capacity(nodes.len());
    for (number, node) in (0..).zip(nodes) {
        match node.parent {
            Some(parent) => children[parent as usize].push(number),
            None => order.push(number),
        }
    }
    let mut next = 0;
    while let Some(&number) = order.get(next) {
        order.append(&mut children[number as usize]);
        next += 1;
    }
    order
}

fn cameras(members: &MotionMembers) -> Vec<NodeCamera> {
    let mut cameras = Vec::new();
    for (node, member) in members.nodes.iter().enumerate() {
        let Some(number) = member.camera else { continue };
        let Some(camera) = members.cameras.get(number) else { continue };
        let lens = match (&camera.perspective, &camera.orthographic) {
            (Some(own), _) => CameraLens::Perspective { fov: own.yfov, aspect: own.aspect_ratio },
            (None, Some(own)) => {
                CameraLens::Orthographic { half_width: own.xmag.abs(), half_height: own.ymag.abs() }
            }
            (None, None) => continue,
        };
        let names = [camera.name.as_str(), member.name.as_str()];
        let name = names.into_iter().find(|name| !name.is_empty());
        let name = name.map_or_else(|| format!("camera_{}", cameras.len()), str::to_owned);
        cameras.push(NodeCamera { name, node: node as u32, lens });
    }
    cameras
}

/// Reader of skins and animations.
struct MemberReader<'a, 'f> {
    accessors: Vec<Accessor<'a>>,
    buffers: &'a [Source<'f>],
    /// Number of the file's nodes.
    nodes: usize,
}

impl MemberReader<'_, '_> {
    /// The accessor of a number, if its elements are such.
    fn accessor(&self, index: usize, dimensions: Dimensions) -> Result<&Accessor<'_>, String> {
        match self.accessors.get(index) {
            Some(accessor) if accessor.dimensions() == dimensions => Ok(accessor),
            Some(_) => Err(tr!("accessor {index} is of another type")),
            None => Err(tr!("there is no accessor {index}")),
        }
    }

    /// Reads the skins into the motion, and gives the number of each there; `None` for those that
    /// are left out.
    fn skins(
        &self,
        members: &[SkinMember],
        motion: &mut Motion,
        report: &mut ImportReport,
    ) -> Vec<Option<u32>> {
        let mut joints = 0_usize;
        let mut numbers = Vec::with_capacity(members.len());
        for (index, member) in members.iter().enumerate() {
            joints = joints.saturating_add(member.joints.len());
            let skin = match joints > MAX_JOINTS {
                true => Err(tr!("there are more than {MAX_JOINTS} joints")),
                false => self.skin(member),
            };
            numbers.push(match skin {
                Ok(skin) => {
                    motion.skins.push(skin);
                    Some(motion.skins.len() as u32 - 1)
                }
                Err(why) => {
                    let message =
                        tr!("skin {index} is left out, its mesh stands as modeled: {why}");
                    report.add(Diagnostic::warning("mesh-animation", message));
                    None
                }
            });
        }
        numbers
    }

    fn skin(&self, member: &SkinMember) -> Result<Skin, String> {
        if member.joints.is_empty() {
            return Err(tr!("it has no joints").to_owned());
        }
        if let Some(wrong) = member.joints.iter().find(|joint| **joint >= self.nodes) {
            return Err(tr!("its joint {wrong} is no node"));
        }
        let mut binds = vec![DMat4::IDENTITY; member.joints.len()];
        if let Some(index) = member.inverse_bind_matrices {
            let accessor = self.accessor(index, Dimensions::Mat4)?;
            if accessor.count() < binds.len() {
                return Err(tr!("it has fewer bind matrices than joints").to_owned());
            }
            if accessor.count() > MAX_JOINTS {
                return Err(tr!("it has more than {MAX_JOINTS} bind matrices"));
            }
            let rows = accessor::rows::<16>(accessor, self.buffers, 0.0);
            let rows = rows.map_err(|problem| problem.message)?;
            if !rows.iter().flatten().all(|number| number.is_finite()) {
                return Err(tr!("a bind matrix is not finite").to_owned());
            }
            binds = rows.iter().map(DMat4::from_cols_array).collect();
        }
        let joints = member.joints.iter().map(|joint| *joint as u32).zip(binds);
        Ok(Skin { joints: joints.collect() })
    }

    fn animations(
        &self,
        members: &[AnimationMember],
        nodes: &[MovedNode],
        report: &mut ImportReport,
    ) -> Vec<Animation> {
        let mut left = MAX_CURVE_NUMBERS;
        let mut animations = Vec::new();
        for (number, member) in members.iter().enumerate() {
            let name = match member.name.as_str() {
                "" => format!("animation_{number}"),
                name => name.to_owned(),
            };
            let mut channels = Vec::new();
            for (index, channel) in member.channels.iter().enumerate() {
                match self.channel(channel, &member.samplers, nodes, &mut left) {
                    Ok(channel) => channels.extend(channel),
                    Err(why) => {
                        let message =
                            tr!("channel {index} of animation `{name}` is left out: {why}");
                        report.add(Diagnostic::warning("mesh-animation", message));
                    }
                }
            }
            if !channels.is_empty() {
                animations.push(Animation { name, channels });
            }
        }
        animations
    }

    /// The channel; `None` where it moves no node. `left` counts the numbers that curves may still
    /// have.
    fn channel(
        &self,
        member: &ChannelMember,
        samplers: &[SamplerMember],
        nodes: &[MovedNode],
        left: &mut usize,
    ) -> Result<Option<Channel>, String> {
        let Some(node) = member.target.node else { return Ok(None) };
        if node >= nodes.len() {
            return Err(tr!("there is no node {node}"));
        }
        let (property, dimensions) = match member.target.path.as_str() {
            "translation" => (NodeProperty::Translation, Dimensions::Vec3),
            "rotation" => (NodeProperty::Rotation, Dimensions::Vec4),
            "scale" => (NodeProperty::Scale, Dimensions::Vec3),
            "weights" => (NodeProperty::Weights, Dimensions::Scalar),
            path => return Err(tr!("`{path}` cannot be moved")),
        };
        let sampler = samplers.get(member.sampler);
        let sampler = sampler
            .ok_or_else(|| tr!("there is no sampler {sampler}", sampler = member.sampler))?;
        let interpolation = match sampler.interpolation.as_str() {
            "" | "LINEAR" => KeyInterpolation::Linear,
            "STEP" => KeyInterpolation::Step,
            "CUBICSPLINE" => KeyInterpolation::CubicSpline,
            word => return Err(tr!("there is no interpolation `{word}`")),
        };
        let input = self.accessor(sampler.input, Dimensions::Scalar)?;
        let output = self.accessor(sampler.output, dimensions)?;
        let numbers = output.count().saturating_mul(dimensions.multiplicity());
        *left = left
            .checked_sub(numbers.saturating_add(input.count()))
            .ok_or_else(|| tr!("curves have more than {MAX_CURVE_NUMBERS} numbers"))?;
        let times = self.numbers::<1>(input)?;
        let values = match dimensions {
            Dimensions::Vec3 => self.numbers::<3>(output)?,
            Dimensions::Vec4 => self.numbers::<4>(output)?,
            _ => self.numbers::<1>(output)?,
        };
        let width = match property {
            NodeProperty::Translation | NodeProperty::Scale => 3,
            NodeProperty::Rotation => 4,
            NodeProperty::Weights => nodes[node].weights.len(),
        };
        if width == 0 {
            return Err(tr!("node {node} has no morph targets"));
        }
        let curve = Curve::new(interpolation, times, values, width)?;
        Ok(Some(Channel { node: node as u32, property, curve }))
    }

    fn numbers<const N: usize>(&self, accessor: &Accessor) -> Result<Vec<f32>, String> {
        let row = |row: [f64; N]| row.map(|number| number as f32);
        let rows = accessor::rows_as(accessor, self.buffers, 0.0, row);
        Ok(rows.map_err(|problem| problem.message)?.into_flattened())
    }
}

impl MotionRecorder {
    /// Records the points of a primitive, which were appended to the soup as they stand without
    /// skins and morphs, and brings them to where these place them at rest. Gives the transform
    /// that stands for the primitive's, which may mirror.
    pub(super) fn record(
        &mut self,
        primitive: &Primitive,
        place: MeshPlace,
        (base, has): (usize, &AttributeOffsets),
        buffers: &[Source],
        soup: &mut TriangleSoup,
    ) -> Result<DMat4, ImportProblem> {
        let Some(mut motion) = soup.motion.take() else { return Ok(DMat4::IDENTITY) };
        let count = soup.points.len() - base;
        let own = |row: [f64; 3]| row.map(|x| x as f32);
        let rows = |semantic: Semantic| match primitive.get(&semantic) {
            Some(accessor) => accessor::rows_as(&accessor, buffers, 0.0, own),
            None => Ok(vec![[0.0; 3]; count]),
        };
        let points = &mut motion.points;
        points.positions.append(&mut rows(Semantic::Positions)?);
        points.normals.append(&mut rows(Semantic::Normals)?);
        points.tangents.append(&mut match primitive.get(&Semantic::Tangents) {
            Some(accessor) => {
                accessor::rows_as(&accessor, buffers, 1.0, |[x, y, z, w]: [f64; 4]| {
                    [x as f32, y as f32, z as f32, if w < 0.0 { -1.0 } else { 1.0 }]
                })?
            }
            None => vec![[0.0; 4]; count],
        });
        let first_target = points.targets.len() as u32;
        self.targets(primitive, base, buffers, &mut motion)?;
        let skin = self.skins.get(place.node as usize).copied().flatten();
        let skin =
            skin.filter(|skin| self.influences(primitive, *skin, count, buffers, &mut motion));
        let end = motion.points.influences.len() as u32;
        motion.points.starts.resize(motion.points.positions.len() + 1, end);
        let part = MovedPart {
            points: base as u32..(base + count) as u32,
            node: place.node,
            instance: place.instance,
            skin,
            targets: first_target..motion.points.targets.len() as u32,
        };
        let posed = motion.points.posed(&part, &self.rest);
        if posed.positions.iter().flatten().all(|number| number.is_finite()) {
            soup.points[base..].copy_from_slice(&posed.positions);
            if let Some(first) = has.normals {
                soup.normals[first..].copy_from_slice(&posed.normals);
            }
            if soup.tangents.len() == soup.points.len() {
                soup.tangents[base..].copy_from_slice(&posed.tangents);
            }
        }
        let matrix = motion.points.first_matrix(&part, &self.rest);
        motion.parts.push(part);
        soup.motion = Some(motion);
        Ok(matrix)
    }

    /// Tells what was left out.
    pub(super) fn tell(self, report: &mut ImportReport) {
        for message in self.warnings {
            report.add(Diagnostic::warning("mesh-animation", message));
        }
    }

    fn warn(&mut self, message: &str) {
        if !self.warnings.iter().any(|known| known == message) {
            self.warnings.push(message.to_owned());
        }
    }

    /// Reads the morph targets of a primitive.
    fn targets(
        &mut self,
        primitive: &Primitive,
        base: usize,
        buffers: &[Source],
        motion: &mut Motion,
    ) -> Result<(), ImportProblem> {
        let mut changes: usize = motion.points.targets.iter().map(Vec::len).sum();
        let count = motion.points.positions.len() - base;
        for target in primitive.morph_targets() {
            self.asked = self.asked.saturating_add(count);
            let accessors = [target.positions(), target.normals(), target.tangents()];
            let mut moved: Vec<PointChange> = Vec::new();
            let is_whole = |accessor: &Accessor| {
                accessor.count() == count && accessor.dimensions() == Dimensions::Vec3
            };
            if self.asked > MAX_ASKED || changes > MAX_CHANGES {
                self.warn(tr!("morph targets are left out: they have too many points"));
            } else if !accessors.iter().flatten().all(is_whole) {
                self.warn(tr!("a morph target is left out: it has not one change for each vertex"));
            } else {
                let mut all = vec![[[0.0_f32; 3]; 3]; count];
                for (part, accessor) in accessors.into_iter().enumerate() {
                    let Some(accessor) = accessor else { continue };
                    let row = |row: [f64; 3]| row.map(|x| x as f32);
                    let rows = accessor::rows_as(&accessor, buffers, 0.0, row)?;
                    all.iter_mut().zip(rows).for_each(|(all, row)| all[part] = row);
                }
                if all.iter().flatten().flatten().all(|number| number.is_finite()) {
                    let changed =
                        (base as u32..).zip(&all).filter(|(_, all)| **all != [[0.0; 3]; 3]);
                    moved.extend(changed.map(|(point, [position, normal, tangent])| PointChange {
                        point,
                        position: *position,
                        normal: *normal,
                        tangent: *tangent,
                    }));
                } else {
                    self.warn(tr!(
                        "a morph target is left out: it has numbers that are not finite"
                    ));
                }
            }
            changes += moved.len();
            motion.points.targets.push(moved);
        }
        Ok(())
    }

    /// Reads which joints move the points of a primitive, and how much; false where they cannot be
    /// read, and nothing was added.
    fn influences(
        &mut self,
        primitive: &Primitive,
        skin: u32,
        count: usize,
        buffers: &[Source],
        motion: &mut Motion,
    ) -> bool {
        let joints = motion.skins.get(skin as usize).map_or(0, |skin| skin.joints.len());
        match influences(primitive, joints, count, buffers) {
            Ok((influences, is_off)) => {
                let points = &mut motion.points;
                let total: usize = influences.iter().map(Vec::len).sum();
                if points.influences.len() + total > MAX_INFLUENCES {
                    self.warn(tr!("a skin is left out: its vertices have too many joints"));
                    return false;
                }
                for of_point in influences {
                    points.influences.extend(of_point);
                    points.starts.push(points.influences.len() as u32);
                }
                if is_off {
                    self.warn(tr!(
                        "joints' weights of some vertices are not 1 together, and were scaled"
                    ));
                }
                true
            }
            Err(why) => {
                self.warn(&tr!("a skin is left out, its mesh stands as modeled: {why}"));
                false
            }
        }
    }
}

/// The joints that move each point, with their shares.
type PointInfluences = Vec<Vec<(u16, f32)>>;

/// The influences of a primitive's points, and whether some shares had to be scaled.
fn influences(
    primitive: &Primitive,
    joints: usize,
    count: usize,
    buffers: &[Source],
) -> Result<(PointInfluences, bool), String> {
    let mut influences: PointInfluences = vec![Vec::new(); count];
    for set in 0..MAX_SETS {
        let [of_joints, of_weights] =
            [Semantic::Joints(set), Semantic::Weights(set)].map(|name| primitive.get(&name));
        let (Some(of_joints), Some(of_weights)) = (of_joints, of_weights) else {
            if set == 0 {
                return Err(tr!("its vertices name no joints").to_owned());
            }
            break;
        };
        let told = |problem: ImportProblem| problem.message;
        let numbers = accessor::rows_as(&of_joints, buffers, 0.0, |row: [f64; 4]| row);
        let weights = accessor::rows_as(&of_weights, buffers, 0.0, |row: [f64; 4]| row);
        let rows = numbers.map_err(told)?.into_iter().zip(weights.map_err(told)?);
        for (of_point, (numbers, weights)) in influences.iter_mut().zip(rows) {
            for (number, weight) in numbers.into_iter().zip(weights) {
                if !weight.is_finite() {
                    return Err(tr!("a joint's weight is not finite").to_owned());
                }
                if weight > 0.0 {
                    if !(number >= 0.0 && (number as usize) < joints) {
                        return Err(tr!("a vertex names joint {number}; there are {joints}"));
                    }
                    of_point.push((number as u16, weight as f32));
                }
            }
        }
    }
    let mut is_off = false;
    for of_point in &mut influences {
        let sum: f64 = of_point.iter().map(|(_, weight)| f64::from(*weight)).sum();
        is_off |= (sum - 1.0).abs() > SHARES_OFF;
        of_point.iter_mut().for_each(|(_, weight)| *weight = (f64::from(*weight) / sum) as f32);
    }
    Ok((influences, is_off))
}
