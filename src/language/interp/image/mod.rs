//! Texture reads: the operations of the instructions, and their execution in every lane.

mod cube;
mod filter;
mod level;

use super::instruction::Slot;
use super::math::Rounding;
use super::memory::{Mask, Memory};
use super::resources::{BoundResources, Texel, Texture, TextureDimension};
use filter::Taps;
use level::Levels;

/// Coordinate, direction, or derivative of one; unused parts are 0.
type Vec3 = [f64; 3];

/// Slots of a vector of one to three components.
pub(super) type Slots = Vec<Slot>;

/// Use of a texture. The slots hold scalars, except those of `image` and `sampler`, which hold
/// numbers of resources.
#[derive(Clone, Debug)]
pub(super) struct Operation {
    pub(super) image: Slot,
    /// First slot of the result.
    pub(super) to: Slot,
    pub(super) texel: Texel,
    pub(super) kind: OperationKind,
}

#[derive(Clone, Debug)]
pub(super) enum OperationKind {
    Sample(Box<Sample>),
    /// Texel by its coordinates; zeros outside.
    Load {
        coordinate: Slots,
        layer: Option<Slot>,
        level: Option<Slot>,
    },
    /// Size of a level.
    Size {
        level: Option<Slot>,
        dimensions: usize,
    },
    Levels,
    Layers,
}

#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) sampler: Slot,
    pub(super) coordinate: Slots,
    pub(super) layer: Option<Slot>,
    /// Offset, in texels.
    pub(super) offset: Slots,
    pub(super) detail: Detail,
    /// Reference depth.
    pub(super) reference: Option<Slot>,
    /// Component to gather of four texels.
    pub(super) gather: Option<usize>,
    /// True if coordinates are kept half a texel from the edge, whatever the sampler says.
    pub(super) clamp_to_edge: bool,
}

/// Level of detail that is sampled.
#[derive(Clone, Debug)]
pub(super) enum Detail {
    /// Level of the footprint of a 2x2 quad, plus a bias.
    Auto {
        bias: Option<Slot>,
    },
    Zero,
    Exact(Slot),
    Gradient {
        x: Slots,
        y: Slots,
    },
}

/// Executes a texture instruction in the lanes of the mask.
pub(super) fn execute<R: Rounding, const W: usize>(
    operation: u32,
    memory: &Memory<W>,
    mask: Mask,
    resources: &BoundResources,
) {
    let operation = &resources.operations[operation as usize];
    for lane in mask.lanes(W) {
        // Bound resources are checked; a missing one belongs to a lane that did not ask for it.
        let Some(texture) = resources.texture(memory.bits(operation.image, lane)) else { continue };
        let texels = match &operation.kind {
            OperationKind::Sample(sample) => {
                sample_lane(sample, texture, memory, lane, resources, operation.texel)
            }
            OperationKind::Load { coordinate, layer, level } => {
                let place = lane_ints(memory, coordinate, lane);
                let [layer, level] =
                    [layer, level].map(|slot| slot.map_or(0, |slot| int(memory, slot, lane)));
                load(texture, place, layer, level)
            }
            OperationKind::Size { level, dimensions } => {
                let level = level.map_or(0, |slot| int(memory, slot, lane));
                size(texture, level).iter().take(*dimensions).zip(operation.to..).for_each(
                    |(&n, to)| {
                        memory.set(to, lane, n.into());
                    },
                );
                continue;
            }
            OperationKind::Levels => {
                memory.set(operation.to, lane, texture.levels().len() as u64);
                continue;
            }
            OperationKind::Layers => {
                memory.set(operation.to, lane, texture.layers().into());
                continue;
            }
        };
        store::<R, W>(operation, memory, lane, texels);
    }
}

/// Writes a result in the kind of its texels.
fn store<R: Rounding, const W: usize>(
    operation: &Operation,
    memory: &Memory<W>,
    lane: usize,
    texels: [f64; 4],
) {
    let is_one = operation.texel == Texel::Depth && !operation.kind.gathers();
    for (to, x) in (operation.to..).zip(texels).take(if is_one { 1 } else { 4 }) {
        let bits = match operation.texel {
            Texel::Float | Texel::Depth => R::round(x).to_bits(),
            Texel::I32 => u64::from((x as i32).cast_unsigned()),
            Texel::U32 => u64::from(x as u32),
        };
        memory.set(to, lane, bits);
    }
}

impl OperationKind {
    fn gathers(&self) -> bool {
        matches!(self, Self::Sample(sample) if sample.gather.is_some())
    }
}

fn int<const W: usize>(memory: &Memory<W>, slot: Slot, lane: usize) -> i64 {
    i64::from(memory.int(slot, lane).cast_signed())
}

fn lane_ints<const W: usize>(memory: &Memory<W>, slots: &[Slot], lane: usize) -> [i64; 3] {
    let mut ints = [0; 3];
    ints.iter_mut().zip(slots).for_each(|(i, &slot)| *i = int(memory, slot, lane));
    ints
}

fn lane_floats<const W: usize>(memory: &Memory<W>, slots: &[Slot], lane: usize) -> Vec3 {
    let mut floats = [0.0; 3];
    floats.iter_mut().zip(slots).for_each(|(x, &slot)| *x = memory.float(slot, lane));
    floats
}

/// Differences of a lane's coordinates from those of its neighbors, along x and y; 0 where lanes
/// are no quads.
fn quad_gradients<const W: usize>(memory: &Memory<W>, slots: &[Slot], lane: usize) -> [Vec3; 2] {
    if W < 4 {
        return [[0.0; 3]; 2];
    }
    let (quad, place) = (lane & !3, lane & 3);
    let at = |place: usize| lane_floats(memory, slots, quad + place);
    [difference(at(place | 1), at(place & 2)), difference(at(place | 2), at(place & 1))]
}

fn difference(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn sample_lane<const W: usize>(
    sample: &Sample,
    texture: &Texture,
    memory: &Memory<W>,
    lane: usize,
    resources: &BoundResources,
    texel: Texel,
) -> [f64; 4] {
    let Some(sampler) = resources.sampler(memory.bits(sample.sampler, lane)) else {
        return [0.0; 4];
    };
    let is_cube = texture.dimension() == TextureDimension::Cube;
    let mut place = lane_floats(memory, &sample.coordinate, lane);
    let mut gradients = match &sample.detail {
        Detail::Auto { .. } => quad_gradients(memory, &sample.coordinate, lane),
        Detail::Gradient { x, y } => [lane_floats(memory, x, lane), lane_floats(memory, y, lane)],
        Detail::Zero | Detail::Exact(_) => [[0.0; 3]; 2],
    };
    let mut layer = sample
        .layer
        .map_or(0, |slot| int(memory, slot, lane))
        .clamp(0, i64::from(texture.layers()) - 1);
    if is_cube {
        let face = cube::face(place);
        gradients = gradients.map(|gradient| cube::gradient(face, place, gradient));
        place = cube::on_face(face, place);
        layer = layer * 6 + face as i64;
    }
    let detail = match sample.detail {
        Detail::Auto { bias } => {
            let bias = bias.map_or(0.0, |slot| memory.float(slot, lane));
            level::of_footprint(texture, gradients) + bias
        }
        Detail::Gradient { .. } => level::of_footprint(texture, gradients),
        Detail::Exact(slot) => memory.float(slot, lane),
        Detail::Zero => 0.0,
    };
    let taps = Taps {
        texture,
        sampler,
        place,
        layer: layer as u32,
        offset: lane_ints(memory, &sample.offset, lane),
        reference: sample.reference.map(|slot| memory.float(slot, lane)),
        clamp_to_edge: sample.clamp_to_edge,
        is_depth: texel == Texel::Depth,
    };
    match sample.gather {
        Some(component) => taps.gather(component),
        None => blend(&taps, &Levels::choose(texture, sampler, detail)),
    }
}

fn blend(taps: &Taps, levels: &Levels) -> [f64; 4] {
    let near = taps.filter(levels.near, levels.filter);
    if levels.weight == 0.0 {
        return near;
    }
    let far = taps.filter(levels.near + 1, levels.filter);
    std::array::from_fn(|i| near[i] * (1.0 - levels.weight) + far[i] * levels.weight)
}

/// Texel by its coordinates; zeros outside of the texture.
fn load(texture: &Texture, place: [i64; 3], layer: i64, level: i64) -> [f64; 4] {
    let level = usize::try_from(level).ok().and_then(|level| texture.levels().get(level));
    let Some(level) = level else { return [0.0; 4] };
    let [x, y, z] = if texture.dimension() == TextureDimension::D3 {
        place
    } else {
        [place[0], place[1], layer]
    };
    let [width, height, depth] = level.size().map(i64::from);
    let is_inside = (0..width).contains(&x) && (0..height).contains(&y) && (0..depth).contains(&z);
    if is_inside { level.texel([x, y, z].map(|i| i as u32)) } else { [0.0; 4] }
}

/// Size of a level; beyond the last level, the size of the last.
fn size(texture: &Texture, level: i64) -> [u32; 3] {
    let last = texture.levels().len() - 1;
    texture.levels()[usize::try_from(level).unwrap_or(last).min(last)].size()
}
