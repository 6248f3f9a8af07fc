//! Tests of exported modules against golden files and outside validators.

use chiaro_test_drawing as support;

mod golden;
mod validators;
