//! Hash maps of points, edges and corners, of which a mesh has hundreds of thousands.
//!
//! The standard library's hash withstands whoever chooses the keys, and took a third of the time in
//! which a mesh is built. This one takes a few instructions for a key of a few numbers. It begins
//! with random numbers, so that no stranger's mesh can be made for it.

use std::collections::HashMap;
use std::hash::{BuildHasher as _, Hash};
use std::ops::Range;

use foldhash::fast::RandomState;
use hashbrown::HashTable;

/// Hash map of what a mesh has many of.
pub(super) type MeshMap<K, V> = HashMap<K, V, RandomState>;

/// An empty map with room for `count` keys.
pub(super) fn with_room<K, V>(count: usize) -> MeshMap<K, V> {
    MeshMap::with_capacity_and_hasher(count, RandomState::default())
}

/// Numbers of vertices whose corners are looked at together, one range after another: what is noted
/// about all corners of a scan at once would take more memory than its file. Each range is a walk
/// through all triangles, so small meshes have one.
pub(super) fn vertex_ranges(vertices: usize, corners: usize) -> impl Iterator<Item = Range<u32>> {
    const USUAL_CORNERS: usize = 1 << 19;
    const MOST_RANGES: usize = 12;
    let ranges = corners.div_ceil(USUAL_CORNERS).clamp(1, MOST_RANGES);
    let step = vertices.div_ceil(ranges).max(1);
    let start_of = move |range: usize| vertices.min(range * step) as u32;
    (0..ranges).map(move |range| start_of(range)..start_of(range + 1))
}

/// The first of `count` items that is equal to each of them: whose key, told again as often as it
/// is needed, is the same. Only numbers of items are stored: keys of all vertices would take more
/// memory than a mesh.
pub(super) fn first_equal<K: Hash + Eq>(count: usize, key: impl Fn(usize) -> K) -> Vec<u32> {
    let hasher = RandomState::default();
    let hash = |item: &u32| hasher.hash_one(key(*item as usize));
    let mut firsts = HashTable::with_capacity(count);
    let mut first = |item: u32| {
        let own = key(item as usize);
        let is_equal = |first: &u32| key(*first as usize) == own;
        *firsts.entry(hasher.hash_one(&own), is_equal, hash).or_insert(item).get()
    };
    (0..count as u32).map(&mut first).collect()
}

/// Bits of the numbers of a row, by which rows are equal: -0 and 0 are the same.
pub(super) fn bits<const N: usize>(row: [f32; N]) -> [u32; N] {
    row.map(|number| (number + 0.0).to_bits())
}

/// The index, for each row (a position, a normal, a UV), of the first row that is equal.
pub(super) fn weld<const N: usize>(rows: &[[f32; N]]) -> Vec<u32> {
    first_equal(rows.len(), |row| bits(rows[row]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_have_all_vertices_once() {
        for (vertices, corners, count) in
            [(0, 0, 1), (7, 9, 1), (10, 1 << 20, 2), (100, 1 << 30, 12)]
        {
            let ranges: Vec<Range<u32>> = vertex_ranges(vertices, corners).collect();
            assert_eq!(ranges.len(), count);
            assert!(ranges.iter().cloned().flatten().eq(0..vertices as u32), "{ranges:?}");
        }
    }

    #[test]
    fn equal_rows_are_known_by_their_first() {
        let rows = [[0.0, 1.0], [-0.0, 1.0], [1.0, 0.0], [0.0, 1.0], [1.0, -0.0]];
        assert_eq!(weld(&rows), [0, 0, 2, 0, 2]);
        assert!(weld::<3>(&[]).is_empty());
    }
}
