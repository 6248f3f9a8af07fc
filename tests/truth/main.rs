//! Tests of the shaders against independent formulas in f64, and of the reference against itself.

use chiaro_test_drawing as support;

mod badf;
mod closed_forms;
mod contexts;
mod family;
mod handwritten;
mod hard_cases;
mod hidden_lines;
mod imported;
mod joined_lights;
mod keys;
mod light_filters;
mod marks;
mod nodes;
mod outlines;
mod pruned;
mod raster;
mod scene_outlines;
mod screen_occlusion;
mod shadow_maps;
mod shadow_places;
mod shadows;
mod shape_passes;
mod shaped_layers;
mod single;
mod tiers;
mod wire_keys;
