//! Hash maps of points, edges and corners, of which a mesh has hundreds of thousands.
//!
//! The standard library's hash withstands whoever chooses the keys, and took a third of the time in
//! which a mesh is built. This one takes a few instructions for a key of a few numbers. It begins
//! with random numbers, so that no stranger's mesh can be made for it.

use std::collections::HashMap;

use foldhash::fast::RandomState;

/// Hash map of what a mesh has many of.
pub(super) type MeshMap<K, V> = HashMap<K, V, RandomState>;

/// An empty map with room for `count` keys.
pub(super) fn with_room<K, V>(count: usize) -> MeshMap<K, V> {
    MeshMap::with_capacity_and_hasher(count, RandomState::default())
}
