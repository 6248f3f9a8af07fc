//! Primitives of glTF meshes: their attributes, triangles and material.

use chiaro_locale::tr;
use glam::{DMat3, DMat4, DVec3, Vec3};
use gltf::accessor::{DataType, Dimensions};
use gltf::material::AlphaMode;
use gltf::mesh::Mode;
use gltf::{Primitive, Semantic};

use super::maps::{MapsOfFile, UvPlace};
use super::motion::{MeshPlace, MotionRecorder};
use super::{SkippedParts, accessor};
use crate::diag::Diagnostic;
use crate::document::linear_to_srgb;
use crate::geometry::import::report::ImportProblem;
use crate::geometry::import::source::Source;
use crate::geometry::import::{MAX_TRIANGLES, MAX_VERTICES};
use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, Material, NONE, TriangleSoup};

/// Appends the triangles of one primitive, moved by `world`, to the soup; in a file in which
/// something moves, its points are recorded.
pub(super) fn append(
    primitive: &Primitive,
    (world, moved): (&DMat4, Option<(&mut MotionRecorder, MeshPlace)>),
    (buffers, maps): (&[Source], &MapsOfFile),
    soup: &mut TriangleSoup,
    skipped: &mut SkippedParts,
) -> Result<(), ImportProblem> {
    if matches!(primitive.mode(), Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) {
        skipped.other += 1;
        return Ok(());
    }
    let Some(positions) = primitive.get(&Semantic::Positions) else { return Ok(()) };
    let indices = primitive.indices();
    let index_count = indices.as_ref().map_or(positions.count(), gltf::Accessor::count);
    let too_large = |what: &str, most: usize| {
        Diagnostic::error("mesh-too-large", tr!("the scene has more than {most} {what}"))
    };
    if positions.count().saturating_add(soup.points.len()) > MAX_VERTICES {
        return Err(too_large(tr!("vertices"), MAX_VERTICES).into());
    }
    let per_triangle = if primitive.mode() == Mode::Triangles { 3 } else { 1 };
    if (index_count / per_triangle).saturating_add(soup.triangles.len()) > MAX_TRIANGLES {
        return Err(too_large(tr!("triangles"), MAX_TRIANGLES).into());
    }
    let base = soup.points.len();
    soup.triangles.reserve(index_count / per_triangle);
    let uvs = maps.place(primitive.material().index());
    let has = attributes(primitive, (world, uvs), buffers, soup)?;
    let world = match moved {
        Some((recorder, place)) => {
            recorder.record(primitive, place, (base, &has), buffers, soup)?
        }
        None => *world,
    };
    let count = soup.points.len() - base;
    let indices = match indices {
        None => (0..count as u32).collect(),
        Some(accessor) => read_indices(&accessor, count, buffers)?,
    };
    let corner = |i: u32| {
        let at = |first: Option<usize>| first.map_or(NONE, |first| first as u32 + i);
        Corner { point: base as u32 + i, normal: at(has.normals), uv: at(has.uvs) }
    };
    // A transform that mirrors turns triangles inside out.
    let mirrored = DMat3::from_mat4(world).determinant() < 0.0;
    let wind = |[a, b, c]: [u32; 3]| if mirrored { [b, a, c] } else { [a, b, c] }.map(corner);
    match primitive.mode() {
        Mode::TriangleStrip => {
            soup.triangles.extend(indices.windows(3).enumerate().map(|(k, w)| {
                wind(if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] })
            }));
        }
        Mode::TriangleFan => {
            soup.triangles.extend(
                indices.get(1..).unwrap_or(&[]).windows(2).map(|w| wind([indices[0], w[0], w[1]])),
            );
        }
        _ => soup.triangles.extend(indices.chunks_exact(3).map(|t| wind([t[0], t[1], t[2]]))),
    }
    let material = material_of(primitive, maps, soup);
    soup.wear(material);
    Ok(())
}

/// The indices of a primitive of `count` vertices.
fn read_indices(
    accessor: &gltf::Accessor,
    count: usize,
    buffers: &[Source],
) -> Result<Vec<u32>, ImportProblem> {
    let whole = matches!(accessor.data_type(), DataType::U8 | DataType::U16 | DataType::U32);
    if !whole || accessor.dimensions() != Dimensions::Scalar || accessor.normalized() {
        let message =
            tr!("accessor {index} holds no indices, but is used as such", index = accessor.index());
        return Err(Diagnostic::error("mesh-syntax", message).into());
    }
    let indices = accessor::rows_as::<1, u32>(accessor, buffers, 0.0, |[i]| i as u32)?;
    if let Some(wrong) = indices.iter().find(|i| **i as usize >= count) {
        let message = tr!(
            "accessor {index} names vertex {wrong}; there are {count}, counted from 0",
            index = accessor.index()
        );
        return Err(Diagnostic::error("mesh-index", message).into());
    }
    Ok(indices)
}

/// The index of the primitive's material in the soup.
fn material_of(primitive: &Primitive, maps: &MapsOfFile, soup: &mut TriangleSoup) -> u32 {
    let material = primitive.material();
    let name = match (material.name(), material.index()) {
        (Some(name), _) if !name.is_empty() => name.to_owned(),
        (_, Some(index)) => format!("material_{index}"),
        (_, None) => DEFAULT_MATERIAL.to_owned(),
    };
    let cutoff = material.alpha_cutoff().unwrap_or(0.5);
    let alpha_cutoff = (material.alpha_mode() == AlphaMode::Mask).then_some(cutoff);
    let (two_sided, maps) = (Some(material.double_sided()), maps.of(material.index()));
    soup.same_material(Material { name, two_sided, alpha_cutoff, maps })
}

/// Checks, before any attribute is read, that all attributes of a primitive are of equal length.
fn check_counts(primitive: &Primitive) -> Result<(), ImportProblem> {
    let mut counts = primitive.attributes().map(|(_, accessor)| accessor.count());
    let first = counts.next().unwrap_or_default();
    if counts.any(|count| count != first) {
        let message =
            tr!("primitive {index} has attributes of different counts", index = primitive.index());
        return Err(Diagnostic::error("mesh-syntax", message).into());
    }
    Ok(())
}

/// First indices of a primitive's normals and UVs in the soup's lists; `None` where the primitive
/// has none.
pub(super) struct AttributeOffsets {
    pub(super) normals: Option<usize>,
    pub(super) uvs: Option<usize>,
}

/// Appends the attributes of a primitive's vertices, transformed to world space, and UVs as the
/// material's pictures lie. After an error the soup is of no more use.
fn attributes(
    primitive: &Primitive,
    (world, place): (&DMat4, UvPlace),
    buffers: &[Source],
    soup: &mut TriangleSoup,
) -> Result<AttributeOffsets, ImportProblem> {
    check_counts(primitive)?;
    let linear = DMat3::from_mat4(*world);
    // The cofactors turn normals rightly under any scale, even where one axis is flattened.
    let cofactors = DMat3::from_cols(
        linear.y_axis.cross(linear.z_axis),
        linear.z_axis.cross(linear.x_axis),
        linear.x_axis.cross(linear.y_axis),
    ) * linear.determinant().signum();
    let side = linear.determinant().signum() as f32;
    // Unit length at once, so that no scale overflows an f32. What is not finite stays so, to be
    // found below.
    let turn = |m: DMat3, v: DVec3| match v.is_finite() {
        true => (m * v).normalize_or_zero().as_vec3(),
        false => Vec3::NAN,
    };
    let base = soup.points.len();
    let named = Semantic::TexCoords(place.set);
    let is_there = primitive.get(&named).is_some();
    let uvs = if is_there { named } else { Semantic::TexCoords(0) };
    let first = AttributeOffsets {
        normals: primitive.get(&Semantic::Normals).map(|_| soup.normals.len()),
        uvs: primitive.get(&uvs).map(|_| soup.uvs.len()),
    };
    if let Some(accessor) = primitive.get(&Semantic::Positions) {
        let place = |p: [f64; 3]| world.transform_point3(p.into()).as_vec3().to_array();
        append_to(&mut soup.points, accessor::rows_as(&accessor, buffers, 0.0, place)?);
    }
    if let Some(accessor) = primitive.get(&Semantic::Normals) {
        let normal = |n: [f64; 3]| turn(cofactors, n.into()).to_array();
        append_to(&mut soup.normals, accessor::rows_as(&accessor, buffers, 0.0, normal)?);
    }
    if let Some(accessor) = primitive.get(&uvs) {
        let uv = |uv: [f64; 2]| place.uv(uv);
        append_to(&mut soup.uvs, accessor::rows_as(&accessor, buffers, 0.0, uv)?);
    }
    if let Some(accessor) = primitive.get(&Semantic::Tangents) {
        let tangent = |[x, y, z, w]: [f64; 4]| {
            let side = if w < 0.0 { -side } else { side };
            let side = if w.is_finite() { side } else { f32::NAN };
            turn(linear, DVec3::new(x, y, z)).extend(side).to_array()
        };
        soup.tangents.resize(base, [0.0; 4]);
        append_to(&mut soup.tangents, accessor::rows_as(&accessor, buffers, 1.0, tangent)?);
    }
    if let Some(accessor) = primitive.get(&Semantic::Colors(0)) {
        let color = |[r, g, b, a]: [f64; 4]| display(r, g, b, a);
        soup.colors.resize(base, [1.0; 4]);
        append_to(&mut soup.colors, accessor::rows_as(&accessor, buffers, 1.0, color)?);
    }
    if !soup.tangents.is_empty() {
        soup.tangents.resize(soup.points.len(), [0.0; 4]);
    }
    if !soup.colors.is_empty() {
        soup.colors.resize(soup.points.len(), [1.0; 4]);
    }
    let broken = [
        not_finite(&soup.points[base..]),
        first.normals.and_then(|first| not_finite(&soup.normals[first..])),
        first.uvs.and_then(|first| not_finite(&soup.uvs[first..])),
        soup.tangents.get(base..).and_then(not_finite),
    ];
    if let Some(vertex) = broken.into_iter().flatten().min() {
        let message = tr!(
            "vertex {vertex} of primitive {index} has numbers that are not finite",
            index = primitive.index()
        );
        return Err(Diagnostic::error("mesh-not-finite", message).into());
    }
    Ok(first)
}

/// Appends rows to a list, which takes them over where it is empty.
fn append_to<T>(list: &mut Vec<T>, mut rows: Vec<T>) {
    if list.is_empty() {
        *list = rows;
    } else {
        list.append(&mut rows);
    }
}

/// Index of the first row with a number that is not finite.
fn not_finite<const N: usize>(rows: &[[f32; N]]) -> Option<usize> {
    rows.iter().position(|row| !row.iter().all(|x| x.is_finite()))
}

/// Encodes a linear color by the sRGB curve (IEC 61966-2-1), clamped to 0..1; NaN becomes 0.
fn display(r: f64, g: f64, b: f64, a: f64) -> [f32; 4] {
    let unit = |x: f64| if x > 0.0 { x.min(1.0) } else { 0.0 };
    let encode = |x: f64| linear_to_srgb(unit(x)) as f32;
    [encode(r), encode(g), encode(b), unit(a) as f32]
}
