//! Executes frame plans on wgpu.
