//! glTF 2.0 computed anew from its specification, in f64: where all points of a file are at a time
//! of an animation, with their normals and tangents, and where its nodes are.
//!
//! Nothing is taken from the code that is tested: JSON, buffers and accessors are read here, and
//! curves, node hierarchies, morph targets and linear blend skinning are written down as the
//! specification has them. It is plain where that code is quick: matrices are multiplied up the
//! line of parents for each node anew, and normals turn by inverse matrices. Numbers of the JSON
//! are rounded to f32, which is what accessors have.

use glam::{DMat3, DMat4, DVec3, DVec4};
use serde_json::Value;

use crate::support::chromium::from_base64;

/// Reader of a file beside the glTF, by its name.
pub(crate) type SiblingBytes<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// File with the bytes of its buffers.
struct GltfFile {
    json: Value,
    buffers: Vec<Vec<u8>>,
}

/// AccessorElements of an accessor.
struct AccessorElements {
    /// Count of numbers in an element.
    width: usize,
    numbers: Vec<f64>,
}

impl AccessorElements {
    fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.numbers.chunks_exact(self.width)
    }

    /// AccessorElements as vectors of three numbers.
    fn vectors(&self) -> Vec<DVec3> {
        self.rows().map(DVec3::from_slice).collect()
    }
}

/// Numbers of a list in the JSON; none where it is missing.
fn listed(value: &Value) -> Vec<f64> {
    let numbers = value.as_array().into_iter().flatten();
    numbers.map(|number| f64::from(number.as_f64().unwrap_or(f64::NAN) as f32)).collect()
}

/// Whole number of the JSON.
fn whole(value: &Value) -> Option<usize> {
    value.as_u64().and_then(|number| usize::try_from(number).ok())
}

/// Members of a list in the JSON.
fn members(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn bytes_at(bytes: &[u8], start: usize, length: usize) -> Result<&[u8], String> {
    let end = start.checked_add(length);
    end.and_then(|end| bytes.get(start..end)).ok_or_else(|| format!("no {length} bytes at {start}"))
}

fn word_at(bytes: &[u8], start: usize) -> Result<usize, String> {
    let word = bytes_at(bytes, start, 4)?.try_into().map_err(|_| "no word".to_owned())?;
    Ok(u32::from_le_bytes(word) as usize)
}

/// Size of a component in bytes.
fn component_size(component: usize) -> Result<usize, String> {
    match component {
        5120 | 5121 => Ok(1),
        5122 | 5123 => Ok(2),
        5125 | 5126 => Ok(4),
        other => Err(format!("there is no component type {other}")),
    }
}

/// A component, which a normalized one is of a whole: f = c / 255 and so on, and for signed ones
/// max(c / 127, -1).
fn component(bytes: &[u8], kind: usize, is_normalized: bool) -> f64 {
    let two = || [bytes[0], bytes[1]];
    let four = || [bytes[0], bytes[1], bytes[2], bytes[3]];
    let (number, most) = match kind {
        5120 => (f64::from(bytes[0].cast_signed()), 127.0),
        5121 => (f64::from(bytes[0]), 255.0),
        5122 => (f64::from(i16::from_le_bytes(two())), 32767.0),
        5123 => (f64::from(u16::from_le_bytes(two())), 65535.0),
        5125 => (f64::from(u32::from_le_bytes(four())), 4_294_967_295.0),
        _ => (f64::from(f32::from_le_bytes(four())), 1.0),
    };
    if is_normalized { (number / most).max(-1.0) } else { number }
}

impl GltfFile {
    fn read(bytes: &[u8], sibling: SiblingBytes<'_>) -> Result<Self, String> {
        let (mut json, mut binary) = (bytes, None);
        if bytes.starts_with(b"glTF") {
            let mut at = 12;
            while at + 8 <= bytes.len() {
                let length = word_at(bytes, at)?;
                let chunk = bytes_at(bytes, at + 8, length)?;
                match &bytes[at + 4..at + 8] {
                    b"JSON" => json = chunk,
                    b"BIN\0" => binary = Some(chunk.to_vec()),
                    _ => {}
                }
                at += 8 + length;
            }
        }
        let json: Value = serde_json::from_slice(json).map_err(|error| error.to_string())?;
        let mut buffers = Vec::new();
        for buffer in members(&json["buffers"]) {
            buffers.push(match buffer["uri"].as_str() {
                None => binary.take().ok_or("there is no binary chunk")?,
                Some(uri) => match uri.split_once(";base64,") {
                    Some((_, data)) => from_base64(data)?,
                    None => sibling(&uri.replace("%20", " "))?,
                },
            });
        }
        Ok(Self { json, buffers })
    }

    /// The bytes of a view, from `offset` on.
    fn view(&self, view: &Value, offset: usize) -> Result<&[u8], String> {
        let view = &self.json["bufferViews"][whole(view).ok_or("no view is named")?];
        let buffer = self.buffers.get(whole(&view["buffer"]).ok_or("no buffer is named")?);
        let start = whole(&view["byteOffset"]).unwrap_or(0);
        let length = whole(&view["byteLength"]).ok_or("a view has no length")?;
        let bytes = bytes_at(buffer.ok_or("there is no such buffer")?, start, length)?;
        bytes.get(offset..).ok_or_else(|| "an accessor begins behind its view".to_owned())
    }

    /// The elements of an accessor: those of its view, or zeros, and in their places those that a
    /// sparse accessor tells.
    fn elements(&self, index: usize) -> Result<AccessorElements, String> {
        let accessor = &self.json["accessors"][index];
        let width = match accessor["type"].as_str() {
            Some("SCALAR") => 1,
            Some("VEC2") => 2,
            Some("VEC3") => 3,
            Some("VEC4") => 4,
            Some("MAT4") => 16,
            other => return Err(format!("accessor {index} is of the type {other:?}")),
        };
        let kind = whole(&accessor["componentType"]).unwrap_or(0);
        let size = component_size(kind)?;
        let count = whole(&accessor["count"]).unwrap_or(0);
        let is_normalized = accessor["normalized"].as_bool().unwrap_or(false);
        let offset = |of: &Value| whole(&of["byteOffset"]).unwrap_or(0);
        let read = |bytes: &[u8], stride: usize, count: usize| -> Result<Vec<f64>, String> {
            let mut numbers = Vec::with_capacity(count * width);
            for part in 0..count * width {
                let at = part / width * stride + part % width * size;
                numbers.push(component(bytes_at(bytes, at, size)?, kind, is_normalized));
            }
            Ok(numbers)
        };
        let mut numbers = vec![0.0; count * width];
        if let Some(view) = accessor.get("bufferView") {
            let stride = &self.json["bufferViews"][whole(view).unwrap_or(0)]["byteStride"];
            let bytes = self.view(view, offset(accessor))?;
            numbers = read(bytes, whole(stride).unwrap_or(width * size), count)?;
        }
        if let Some(sparse) = accessor.get("sparse") {
            let (places, values) = (&sparse["indices"], &sparse["values"]);
            let count = whole(&sparse["count"]).unwrap_or(0);
            let new = read(self.view(&values["bufferView"], offset(values))?, width * size, count)?;
            let bytes = self.view(&places["bufferView"], offset(places))?;
            let kind = whole(&places["componentType"]).unwrap_or(0);
            let size = component_size(kind)?;
            for (number, row) in new.chunks_exact(width).enumerate() {
                let place = component(bytes_at(bytes, number * size, size)?, kind, false) as usize;
                let own = numbers.get_mut(place * width..(place + 1) * width);
                own.ok_or("a sparse accessor names an element beyond it")?.copy_from_slice(row);
            }
        }
        Ok(AccessorElements { width, numbers })
    }

    /// The elements of an accessor that may be missing.
    fn named(&self, index: &Value) -> Result<Option<AccessorElements>, String> {
        whole(index).map(|index| self.elements(index)).transpose()
    }
}

/// Property of a node that a curve moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum MovedProperty {
    Translation,
    Rotation,
    Scale,
    Weights,
}

/// Curve of one property of a node.
struct CurveTruth {
    node: usize,
    path: MovedProperty,
    interpolation: String,
    times: Vec<f64>,
    values: Vec<f64>,
}

impl CurveTruth {
    /// Count of numbers in the property.
    fn width(&self) -> usize {
        let of_key = if self.interpolation == "CUBICSPLINE" { 3 } else { 1 };
        self.values.len() / (self.times.len() * of_key)
    }

    /// The numbers of a key: its value, or 0 for the tangent toward it and 2 for the one from it.
    fn key(&self, key: usize, tangent: Option<usize>) -> &[f64] {
        let width = self.width();
        let start = match self.interpolation.as_str() {
            "CUBICSPLINE" => (3 * key + tangent.unwrap_or(1)) * width,
            _ => key * width,
        };
        &self.values[start..start + width]
    }

    /// The value at a time: appendix C of the specification.
    fn value(&self, time: f64) -> Vec<f64> {
        let last = self.times.len() - 1;
        let own = |key: usize| self.key(key, None).to_vec();
        if time <= self.times[0] {
            return own(0);
        }
        if time >= self.times[last] {
            return own(last);
        }
        let before = (0..last).rev().find(|key| self.times[*key] <= time).unwrap_or(0);
        let span = self.times[before + 1] - self.times[before];
        let t = (time - self.times[before]) / span;
        let pairs = own(before).into_iter().zip(own(before + 1));
        match self.interpolation.as_str() {
            "STEP" => own(before),
            "CUBICSPLINE" => {
                let leaving = self.key(before, Some(2));
                let arriving = self.key(before + 1, Some(0));
                let (t2, t3) = (t.powi(2), t.powi(3));
                let parts = pairs.zip(leaving).zip(arriving);
                let point = |(((a, b), leaving), arriving): (((f64, f64), &f64), &f64)| {
                    (2.0 * t3 - 3.0 * t2 + 1.0) * a
                        + span * (t3 - 2.0 * t2 + t) * leaving
                        + (-2.0 * t3 + 3.0 * t2) * b
                        + span * (t3 - t2) * arriving
                };
                parts.map(point).collect()
            }
            _ if self.path == MovedProperty::Rotation => {
                let [a, b] = [before, before + 1].map(|key| DVec4::from_slice(&own(key)));
                slerp(a, b, t).to_array().to_vec()
            }
            _ => pairs.map(|(a, b)| (1.0 - t) * a + t * b).collect(),
        }
    }
}

/// Spherical linear interpolation of quaternions along the shorter arc.
fn slerp(a: DVec4, b: DVec4, t: f64) -> DVec4 {
    let (a, b) = (a.normalize(), b.normalize());
    let b = if a.dot(b) < 0.0 { -b } else { b };
    // Half of what the chords tell is exact for small angles too.
    let angle = 2.0 * (a - b).length().atan2((a + b).length());
    if angle < 1e-9 {
        return ((1.0 - t) * a + t * b).normalize();
    }
    (((1.0 - t) * angle).sin() * a + (t * angle).sin() * b) / angle.sin()
}

/// Node as it stands, or as an animation moved it.
#[derive(Clone, Debug)]
struct NodeTruth {
    parent: Option<usize>,
    matrix: Option<DMat4>,
    translation: DVec3,
    rotation: DVec4,
    scale: DVec3,
    weights: Vec<f64>,
    mesh: Option<usize>,
    skin: Option<usize>,
    children: Vec<usize>,
}

impl NodeTruth {
    /// The transform to the parent's space: T * R * S.
    fn local(&self) -> DMat4 {
        if let Some(matrix) = self.matrix {
            return matrix;
        }
        let [x, y, z, w] = self.rotation.normalize().to_array();
        let turn = DMat3::from_cols_array_2d(&[
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
            [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
            [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
        ]);
        let linear = turn * DMat3::from_diagonal(self.scale);
        let column = |axis: usize| linear.col(axis).extend(0.0);
        DMat4::from_cols(column(0), column(1), column(2), self.translation.extend(1.0))
    }
}

/// Primitive of triangles in its place.
pub(crate) struct PrimitiveTruth {
    node: usize,
    positions: Vec<DVec3>,
    normals: Option<Vec<DVec3>>,
    tangents: Option<Vec<DVec4>>,
    /// Differences of positions, normals and tangents, of each morph target.
    targets: Vec<[Option<Vec<DVec3>>; 3]>,
    /// Joints of each point with their weights, which are 1 together; empty without a skin.
    influences: Vec<Vec<(usize, f64)>>,
    /// Triangles of points, counter-clockwise where nothing mirrors.
    pub(crate) triangles: Vec<[usize; 3]>,
    /// Number of the material.
    pub(crate) material: Option<usize>,
    /// Name of the material; empty where it has none.
    pub(crate) material_name: String,
}

/// Point in a pose, in the space of the scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointTruth {
    pub(crate) place: DVec3,
    /// Size of the numbers that the place is a sum of, which rounding goes by.
    pub(crate) reach: f64,
    /// Normal of the file, of unit length; `None` where it has none, or none is left.
    pub(crate) normal: Option<DVec3>,
    /// True if the file has a normal there before a matrix moves it.
    pub(crate) has_normal: bool,
    /// Tangent of the file with its side; its length is 1.
    pub(crate) tangent: Option<DVec4>,
    /// Share of its volume that the point's matrix leaves a ball, against an even scale: 1 for
    /// turns, 0 where the matrix flattens.
    pub(crate) roundness: f64,
    /// True where the matrix mirrors.
    pub(crate) is_mirrored: bool,
}

/// Animation of a file.
struct AnimationTruth {
    name: String,
    curves: Vec<CurveTruth>,
}

/// File that is computed from its specification.
pub(crate) struct GltfTruth {
    nodes: Vec<NodeTruth>,
    /// Joints of each skin, each with its inverse bind matrix.
    skins: Vec<Vec<(usize, DMat4)>>,
    animations: Vec<AnimationTruth>,
    /// Primitives of triangles in the order of the scene, depth first.
    pub(crate) primitives: Vec<PrimitiveTruth>,
    /// Nodes with cameras, in the order of the nodes.
    pub(crate) cameras: Vec<usize>,
    /// True if a node asks for copies of its mesh, of which nothing is known here.
    pub(crate) has_copies: bool,
}

impl GltfTruth {
    /// True if the specification, which wants unit quaternions for rotations, leaves open how the
    /// file's are meant: digits were left out of one.
    pub(crate) fn has_blurred_rotations(&self) -> bool {
        self.nodes.iter().any(|node| (node.rotation.length() - 1.0).abs() > 1e-5)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// Where this reader, which knows whole files only, does not understand it.
    pub(crate) fn read(bytes: &[u8], sibling: SiblingBytes<'_>) -> Result<Self, String> {
        let file = GltfFile::read(bytes, sibling)?;
        let json = &file.json;
        let scenes = members(&json["scenes"]);
        let scene = scenes.get(whole(&json["scene"]).unwrap_or(0));
        let nodes = nodes(json, scene);
        let mut skins = Vec::new();
        for skin in members(&json["skins"]) {
            let binds = file.named(&skin["inverseBindMatrices"])?;
            let binds: Option<Vec<DMat4>> =
                binds.map(|binds| binds.rows().map(DMat4::from_cols_slice).collect());
            let joints = members(&skin["joints"]).iter().enumerate().map(|(number, joint)| {
                let bind = binds.as_ref().map_or(DMat4::IDENTITY, |binds| binds[number]);
                Ok((whole(joint).ok_or("a joint is no number")?, bind))
            });
            skins.push(joints.collect::<Result<Vec<_>, &str>>()?);
        }
        let mut truth = Self {
            animations: animations(&file)?,
            cameras: Vec::new(),
            has_copies: json.to_string().contains("EXT_mesh_gpu_instancing"),
            nodes,
            skins,
            primitives: Vec::new(),
        };
        for (number, node) in members(&json["nodes"]).iter().enumerate() {
            truth.cameras.extend(node.get("camera").map(|_| number));
        }
        let roots: Vec<usize> = match scene {
            Some(scene) => members(&scene["nodes"]).iter().filter_map(whole).collect(),
            None => (0..truth.nodes.len()).filter(|n| truth.nodes[*n].parent.is_none()).collect(),
        };
        let mut open: Vec<usize> = roots.into_iter().rev().collect();
        while let Some(number) = open.pop() {
            open.extend(truth.nodes[number].children.iter().rev());
            let Some(mesh) = truth.nodes[number].mesh else { continue };
            for primitive in members(&json["meshes"][mesh]["primitives"]) {
                let read = truth.primitive(&file, number, primitive)?;
                truth.primitives.extend(read);
            }
        }
        Ok(truth)
    }

    /// The primitive at a node; `None` for points and lines.
    fn primitive(
        &self,
        file: &GltfFile,
        node: usize,
        primitive: &Value,
    ) -> Result<Option<PrimitiveTruth>, String> {
        let attributes = &primitive["attributes"];
        let Some(positions) = file.named(&attributes["POSITION"])? else { return Ok(None) };
        let positions = positions.vectors();
        let corners: Vec<usize> = match file.named(&primitive["indices"])? {
            Some(indices) => indices.numbers.iter().map(|index| *index as usize).collect(),
            None => (0..positions.len()).collect(),
        };
        let p = |i: usize| corners[i];
        let last = corners.len().saturating_sub(2);
        let triangles = match whole(&primitive["mode"]).unwrap_or(4) {
            4 => (0..corners.len() / 3).map(|i| [p(3 * i), p(3 * i + 1), p(3 * i + 2)]).collect(),
            5 => (0..last).map(|i| [p(i), p(i + 1 + i % 2), p(i + 2 - i % 2)]).collect(),
            6 => (0..last).map(|i| [p(i + 1), p(i + 2), p(0)]).collect(),
            _ => return Ok(None),
        };
        let mut targets = Vec::new();
        for target in members(&primitive["targets"]) {
            let part =
                |name: &str| file.named(&target[name]).map(|part| part.map(|part| part.vectors()));
            targets.push([part("POSITION")?, part("NORMAL")?, part("TANGENT")?]);
        }
        let tangents = file.named(&attributes["TANGENT"])?;
        let material = whole(&primitive["material"]);
        let of_file = material.map_or(&Value::Null, |number| &file.json["materials"][number]);
        Ok(Some(PrimitiveTruth {
            node,
            normals: file.named(&attributes["NORMAL"])?.map(|normals| normals.vectors()),
            tangents: tangents.map(|rows| rows.rows().map(DVec4::from_slice).collect()),
            targets,
            influences: match self.nodes[node].skin {
                Some(_) => influences(file, attributes, positions.len())?,
                None => Vec::new(),
            },
            positions,
            triangles,
            material,
            material_name: of_file["name"].as_str().unwrap_or_default().to_owned(),
        }))
    }

    /// Names of the animations that move nodes, with their numbers.
    pub(crate) fn animations(&self) -> Vec<(usize, &str)> {
        let all = self.animations.iter().enumerate();
        let moving = all.filter(|(_, animation)| !animation.curves.is_empty());
        moving.map(|(number, animation)| (number, animation.name.as_str())).collect()
    }

    /// Times of all keys of an animation, in seconds, in increasing order.
    pub(crate) fn key_times(&self, animation: usize) -> Vec<f64> {
        let curves = &self.animations[animation].curves;
        let mut times: Vec<f64> = curves.iter().flat_map(|curve| curve.times.clone()).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// The nodes at a time of an animation, or at rest.
    fn moved(&self, animation: Option<(usize, f64)>) -> Vec<NodeTruth> {
        let mut nodes = self.nodes.clone();
        let Some((animation, time)) = animation else { return nodes };
        for curve in &self.animations[animation].curves {
            let value = curve.value(time);
            let node = &mut nodes[curve.node];
            match curve.path {
                MovedProperty::Translation => node.translation = DVec3::from_slice(&value),
                MovedProperty::Rotation => node.rotation = DVec4::from_slice(&value),
                MovedProperty::Scale => node.scale = DVec3::from_slice(&value),
                MovedProperty::Weights => node.weights = value,
            }
        }
        nodes
    }

    /// The transform of a node to the scene at a time of an animation, or at rest.
    pub(crate) fn node(&self, number: usize, animation: Option<(usize, f64)>) -> DMat4 {
        global(&self.moved(animation), number)
    }

    /// The points of all primitives at a time of an animation, or at rest.
    pub(crate) fn posed(&self, animation: Option<(usize, f64)>) -> Vec<Vec<PointTruth>> {
        let nodes = self.moved(animation);
        let joint = |(node, bind): &(usize, DMat4)| global(&nodes, *node) * *bind;
        let skins: Vec<Vec<DMat4>> =
            self.skins.iter().map(|skin| skin.iter().map(joint).collect()).collect();
        let posed = self.primitives.iter().map(|primitive| {
            let node = &nodes[primitive.node];
            let rigid = global(&nodes, primitive.node);
            let matrices = |point: usize| -> Vec<(DMat4, f64)> {
                let skin = node.skin.and_then(|skin| skins.get(skin));
                let of_point = primitive.influences.get(point).filter(|list| !list.is_empty());
                let (Some(skin), Some(of_point)) = (skin, of_point) else {
                    return vec![(rigid, 1.0)];
                };
                of_point.iter().map(|(joint, weight)| (skin[*joint], *weight)).collect()
            };
            let points = 0..primitive.positions.len();
            points.map(|point| primitive.point(point, &matrices(point), &node.weights)).collect()
        });
        posed.collect()
    }
}

impl PrimitiveTruth {
    /// True if the file has tangents for it.
    pub(crate) fn has_tangents(&self) -> bool {
        self.tangents.is_some()
    }

    /// A point that targets have changed by their weights, and then the sum of matrices moved, each
    /// by its own weight.
    fn point(&self, point: usize, matrices: &[(DMat4, f64)], weights: &[f64]) -> PointTruth {
        let changed = |part: usize, own: DVec3| {
            self.targets.iter().zip(weights).fold(own, |sum, (target, weight)| {
                sum + target[part].as_ref().map_or(DVec3::ZERO, |rows| *weight * rows[point])
            })
        };
        let matrix =
            matrices.iter().fold(DMat4::ZERO, |sum, (matrix, weight)| sum + *matrix * *weight);
        let linear = DMat3::from_mat4(matrix);
        let place = changed(0, self.positions[point]);
        let changes = self.targets.iter().zip(weights).map(|(target, weight)| {
            weight.abs() * target[0].as_ref().map_or(0.0, |rows| rows[point].length())
        });
        let far = self.positions[point].length() + changes.sum::<f64>();
        let reach = |(matrix, weight): &(DMat4, f64)| {
            let moved = size(DMat3::from_mat4(*matrix)) * far;
            weight * (moved + matrix.w_axis.truncate().length())
        };
        let determinant = linear.determinant();
        let normal = self.normals.as_ref().map(|normals| changed(1, normals[point]));
        let has_normal = normal.is_some_and(|normal| normal != DVec3::ZERO);
        let normal = normal.and_then(|normal| match determinant == 0.0 {
            true => None,
            false => (linear.inverse().transpose() * normal).try_normalize(),
        });
        let tangent = self.tangents.as_ref().and_then(|tangents| {
            let own = changed(2, tangents[point].truncate());
            Some((linear * own).try_normalize()?.extend(tangents[point].w.signum()))
        });
        PointTruth {
            place: matrix.transform_point3(place),
            reach: matrices.iter().map(reach).sum(),
            normal,
            has_normal,
            tangent,
            roundness: determinant.abs() / size(linear).powi(3).max(f64::MIN_POSITIVE),
            is_mirrored: determinant < 0.0,
        }
    }
}

/// The mean scale of a matrix.
fn size(linear: DMat3) -> f64 {
    (linear.to_cols_array().iter().map(|x| x * x).sum::<f64>() / 3.0).sqrt()
}

/// The transform of a node to the scene: those of all its parents, then its own.
fn global(nodes: &[NodeTruth], number: usize) -> DMat4 {
    let mut matrix = nodes[number].local();
    let mut next = nodes[number].parent;
    while let Some(parent) = next {
        matrix = nodes[parent].local() * matrix;
        next = nodes[parent].parent;
    }
    matrix
}

/// All nodes as they stand.
fn nodes(json: &Value, scene: Option<&Value>) -> Vec<NodeTruth> {
    let node = |node: &Value| {
        let parts = |name: &str, default: &[f64]| match node.get(name) {
            Some(numbers) => listed(numbers),
            None => default.to_vec(),
        };
        let mesh = whole(&node["mesh"]);
        let of_mesh = mesh.map_or(&Value::Null, |mesh| &json["meshes"][mesh]);
        let targets = members(&of_mesh["primitives"]).iter().map(|p| members(&p["targets"]).len());
        let given = node.get("weights").unwrap_or(&of_mesh["weights"]);
        let mut weights = listed(given);
        weights.resize(targets.max().unwrap_or(0), 0.0);
        NodeTruth {
            parent: None,
            matrix: node.get("matrix").map(|numbers| DMat4::from_cols_slice(&listed(numbers))),
            translation: DVec3::from_slice(&parts("translation", &[0.0; 3])),
            rotation: DVec4::from_slice(&parts("rotation", &[0.0, 0.0, 0.0, 1.0])),
            scale: DVec3::from_slice(&parts("scale", &[1.0; 3])),
            weights,
            mesh,
            skin: whole(&node["skin"]),
            children: members(&node["children"]).iter().filter_map(whole).collect(),
        }
    };
    let mut nodes: Vec<NodeTruth> = members(&json["nodes"]).iter().map(node).collect();
    let roots = scene.map_or(&[][..], |scene| members(&scene["nodes"]));
    let roots: Vec<usize> = roots.iter().filter_map(whole).collect();
    for parent in 0..nodes.len() {
        for child in nodes[parent].children.clone() {
            if !roots.contains(&child) {
                nodes[child].parent = Some(parent);
            }
        }
    }
    nodes
}

/// All animations; channels that move no node, or what extensions name, are left out.
fn animations(file: &GltfFile) -> Result<Vec<AnimationTruth>, String> {
    let mut animations = Vec::new();
    for (number, animation) in members(&file.json["animations"]).iter().enumerate() {
        let mut curves = Vec::new();
        for channel in members(&animation["channels"]) {
            let target = &channel["target"];
            let path = match target["path"].as_str() {
                Some("translation") => MovedProperty::Translation,
                Some("rotation") => MovedProperty::Rotation,
                Some("scale") => MovedProperty::Scale,
                Some("weights") => MovedProperty::Weights,
                _ => continue,
            };
            let Some(node) = whole(&target["node"]) else { continue };
            let sampler = whole(&channel["sampler"]).ok_or("a channel names no sampler")?;
            let sampler = &animation["samplers"][sampler];
            let [times, values] = ["input", "output"].map(|part| file.named(&sampler[part]));
            let [times, values] = [times?, values?].map(|part| part.ok_or("a sampler is empty"));
            curves.push(CurveTruth {
                node,
                path,
                interpolation: sampler["interpolation"].as_str().unwrap_or("LINEAR").to_owned(),
                times: times?.numbers,
                values: values?.numbers,
            });
        }
        let name = animation["name"].as_str().filter(|name| !name.is_empty());
        let name = name.map_or_else(|| format!("animation_{number}"), str::to_owned);
        animations.push(AnimationTruth { name, curves });
    }
    Ok(animations)
}

/// Joints of a primitive's points with their weights. The specification asks that weights be 1
/// together; rounded ones are made so.
fn influences(
    file: &GltfFile,
    attributes: &Value,
    count: usize,
) -> Result<Vec<Vec<(usize, f64)>>, String> {
    let mut influences = vec![Vec::new(); count];
    for set in 0.. {
        let [joints, weights] =
            ["JOINTS", "WEIGHTS"].map(|name| file.named(&attributes[format!("{name}_{set}")]));
        let (Some(joints), Some(weights)) = (joints?, weights?) else { break };
        for (point, (joints, weights)) in joints.rows().zip(weights.rows()).enumerate() {
            let pairs = joints.iter().zip(weights).filter(|(_, weight)| **weight > 0.0);
            influences[point].extend(pairs.map(|(joint, weight)| (*joint as usize, *weight)));
        }
    }
    for of_point in &mut influences {
        let sum: f64 = of_point.iter().map(|(_, weight)| weight).sum();
        of_point.iter_mut().for_each(|(_, weight)| *weight /= sum);
    }
    Ok(influences)
}
