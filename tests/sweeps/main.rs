//! Sweeps of every node, look and lookup over the whole domain: the GPU against the reference in
//! f64.

use chiaro_test_drawing as support;

mod hcbtf_lookup;
mod ledger;
mod looks;
mod nodes;
mod worst;
