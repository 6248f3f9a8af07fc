//! Every node, look and lookup over its whole domain, GPU against the f64 reference.

use chiaro_test_drawing as support;

mod hcbtf_lookup;
mod ledger;
mod looks;
mod nodes;
mod worst;
