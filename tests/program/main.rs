//! The program from outside: its commands, what they write, and what they measure.

use chiaro_test_drawing as support;

mod bench;
mod cli;
mod comp;
mod desktop;
mod film;
mod fit;
mod frames;
mod gallery;
mod layers;
mod lights;
#[cfg(target_os = "linux")]
mod memory;
mod nightfall;
mod outputs;
mod shots;
#[cfg(target_os = "linux")]
mod slurm;
mod views;
