//! Pictures of the GPU: effects, pruning, muting and groups that leave them unchanged, and
//! surfaces.

use chiaro_test_drawing as support;

mod aimed_lights;
mod batches;
mod casters;
mod deferred;
mod depth_first;
mod displays;
mod effects;
mod grouping;
mod kept_pixels;
mod layered_lights;
mod links;
mod lit_pixels;
mod long_graphs;
mod looped_lights;
mod mute;
mod node_code;
mod object_lights;
mod probe;
mod property_looks;
mod prune;
mod regions;
mod scene_keys;
mod shared_store;
mod surfaces;
