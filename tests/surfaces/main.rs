//! Tests of meshes, painted surfaces and directions, the parts of a scene that need no GPU.

use chiaro_test_drawing as support;

mod blue_noise;
mod directions_schemes;
mod directions_weights;
mod geometry_import;
mod geometry_models;
mod geometry_shapes;
mod geometry_tangents;
mod gltf_truth;
mod hcbtf_bake;
mod hcbtf_edits;
mod hcbtf_examples;
mod hcbtf_file;
mod hcbtf_opaque;
mod khr_assets;
mod khr_features;
mod material_maps;
mod memory_files;
mod motion;
