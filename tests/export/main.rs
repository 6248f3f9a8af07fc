//! Tests of exported modules against golden files, kept counts and outside validators.

use chiaro_test_drawing as support;

mod golden;
mod instructions;
mod shadow_maps;
mod validators;
