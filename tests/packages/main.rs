//! Packages in the programs that they are for: their pictures against our own.
//!
//! A case exports a look as a user does, by the program, has the consumer draw the package, and
//! compares with the picture of `chiaro render`, drawn by the same software GPU, which comes with
//! Chromium. What is measured is in one table, `tests/golden/packages.txt`.

use chiaro_test_drawing as support;

mod babylon;
mod bevy_crate;
mod blender;
mod godot;
mod library;
mod materialx;
mod matrix;
mod pictures;
mod table;
mod three;
mod unity;
mod unreal;
mod web;
mod wgpu_crate;
