//! Tests of exported modules against golden files, kept counts and outside validators.

use chiaro_test_drawing as support;

mod described;
mod dxc;
mod golden;
mod host_code;
mod host_work;
mod instructions;
mod live;
mod readable;
mod shadow_maps;
mod validators;
mod verdicts;
